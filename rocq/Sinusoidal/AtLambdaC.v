(* 2.2 at lambda_c itself: (38) is still a motion without rest, and attracts *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic Steady Steady2 Pulse Aniso Aniso2 AttractPlane Regions.
Open Scope R_scope.

Theorem eq38_at_lambda_c vx vy : let l := eq37_lambda_c in let p := eq39_phi1 l in let W := ext PI (g38 l p) in
  p = asin l /\ motion l (fun t => - sin (p + t)) (fun _ => 0) W (fun _ => 0) /\ (forall t, 0 < t < PI -> 0 < W t) /\
  (motion l (fun t => - sin (p + t)) (fun _ => 0) vx vy -> is_lim (fun t => vx t - W t) p_infty 0 /\ is_lim vy p_infty 0).
Proof.
  intros l p W. pose proof lambda_c_between as hl. fold l in hl. destruct (p1_range l hl) as [[a b] e]. pose proof PI_RGT_0 as pi0.
  assert (c : cos (asin l) = PI * l / 2). { rewrite cos_asin_pow by lra. rewrite (proj2 (at_lambda_c l ltac:(lra)) eq_refl). field. }
  assert (ep : p = asin l) by (unfold p, eq39_phi1; rewrite <- c; apply acos_cos; lra).
  assert (gh : forall t, g38 l p t = h l t) by (intros t; unfold g38, h; rewrite ep; trivial).
  assert (hP : h l PI = 0). { unfold h. rewrite (Rplus_comm (asin l)), (Rplus_comm PI), neg_cos, c. field. }
  assert (h0 : h l 0 = 0) by (unfold h; rewrite Rplus_0_r; ring).
  assert (P : forall t, 0 < t < PI -> 0 < h l t). { intros t Ht. destruct (Rle_lt_dec t (PI - 2 * asin l)). apply h_up; trivial; lra. rewrite <- hP. apply h_down; trivial; lra. }
  assert (PW : forall t, 0 < t < PI -> 0 < W t). { intros t Ht. unfold W. rewrite (ext_on PI (g38 l p) pi0 0) by (simpl; lra). unfold sg; simpl. rewrite Rmult_1_l, Rmult_0_l, Rminus_0_r, gh. apply P, Ht. }
  assert (M : motion l (fun t => - sin (p + t)) (fun _ => 0) W (fun _ => 0)).
  { apply half_period; trivial.
    - intros t. replace (p + (t + PI)) with (p + t + PI) by ring. rewrite neg_sin. ring.
    - rewrite !gh, hP, h0. ring.
    - intros t _. apply derivable_continuous_pt. exists (sin (p + t) - l). apply is_derive_Reals, g_der.
    - intros t Ht. exists (- l). assert (0 <= g38 l p t) by (rewrite gh; destruct (Req_dec t 0) as [-> | ]; [ lra | left; apply P; lra ]). split.
      + split; [ nra | ]. unfold nrm. replace (g38 l p t ^ 2 + 0 ^ 2) with (Rsqr (g38 l p t)) by (unfold Rsqr; ring). rewrite sqrt_Rsqr by trivial. ring.
      + apply rder_of. replace (- l - - sin (p + t)) with (sin (p + t) - l) by ring. apply g_der. }
  split; [ trivial | split; [ trivial | split; [ trivial | ] ] ]. intros V.
  apply (plane_attracts l 1 (2 * PI) 0 PI (fun t => - sin (p + t)) W); trivial; try lra.
  - intros t. rewrite Rabs_Ropp. apply Rabs_le, SIN_bound.
  - intros t. apply ext_period; trivial.
  - unfold W. rewrite (ext_on PI _ pi0 0) by (simpl; lra). simpl. replace (0 - 0 * PI) with 0 by ring. rewrite gh, h0. ring.
  - intros t Ht. specialize (PW (t + PI) ltac:(lra)). unfold W in PW. rewrite ext_anti in PW by trivial. unfold W. lra.
  - intros t Ht. apply PW. lra.
Qed.
