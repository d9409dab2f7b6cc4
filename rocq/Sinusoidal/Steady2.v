(* 2.2: below lambda_c there is the motion (38), which does not rest *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic Steady.
Open Scope R_scope.

Section Small.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Hypothesis hc : l < eq37_lambda_c.
Definition eq39_phi1 : R := acos (PI * l / 2).
Definition g38 p t := - l * t + cos p - cos (p + t).
Let p := eq39_phi1.

Lemma half_small : 0 < PI * l / 2 < sqrt (1 - l ^ 2) /\ sqrt (1 - l ^ 2) <= 1.
Proof.
  pose proof PI_RGT_0. assert (N : ~ (- PI * l + 2 * sqrt (1 - l ^ 2) <= 0)).
  { intros k. destruct k as [k | k]. apply (proj1 (eq36 l ltac:(lra))) in k. lra.
    assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra). unfold eq37_lambda_c in hc. apply Rlt_div_r in hc; trivial.
    assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; nra).
    assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; nra).
    assert (L := sq_lt (l * sqrt (4 + PI ^ 2)) 2 ltac:(nra)). rewrite Rpow_mult_distr, S2 in L.
    assert (E : (2 * sqrt (1 - l ^ 2)) ^ 2 = (PI * l) ^ 2) by (f_equal; lra). rewrite !Rpow_mult_distr, Q2 in E. nra. }
  repeat split; try nra. rewrite <- sqrt_1 at 2. apply sqrt_le_1_alt. nra.
Qed.
Lemma p_facts : 0 < p < PI / 2 /\ cos p = PI * l / 2 /\ l < sin p.
Proof.
  destruct half_small as [[a b] c]. assert (e : cos p = PI * l / 2) by (apply cos_acos; lra).
  assert (B : 0 < p < PI) by (unfold p, eq39_phi1; apply acos_bound_lt; lra). pose proof PI_RGT_0.
  assert (B2 : p < PI / 2). { apply Rnot_le_lt. intros k. pose proof (cos_decr_1 (PI / 2) p ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). rewrite cos_PI2 in *. lra. }
  repeat split; trivial; try lra. apply sq_lt_inv. left. apply sin_gt_0; lra.
  pose proof (sin2_cos2 p) as Q. unfold Rsqr in Q. assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; nra).
  assert (L := sq_lt (cos p) (sqrt (1 - l ^ 2)) ltac:(lra)). nra.
Qed.
Theorem eq41 : asin l < eq39_phi1.
Proof.
  destruct p_facts as [[a b] [_ c]]. destruct (p1_range l hl) as [[a1 b1] e1]. fold p. apply Rnot_le_lt. intros k.
  pose proof (sin_incr_1 p (asin l) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). lra.
Qed.
Lemma g_der t : is_derive (g38 p) t (sin (p + t) - l).
Proof. unfold g38. auto_derive; trivial. ring. Qed.
Lemma g_pos t : 0 < t < PI -> 0 < g38 p t.
Proof.
  intros H. destruct p_facts as [[a b] [c d]]. destruct (p1_range l hl) as [[a1 b1] e1]. pose proof eq41 as k. fold p in k. set (q := asin l) in *.
  assert (g0 : g38 p 0 = 0) by (unfold g38; rewrite Rplus_0_r; ring).
  assert (gP : g38 p PI = 0) by (unfold g38; rewrite neg_cos, c; field).
  destruct (Rle_lt_dec t (PI - q - p)).
  - rewrite <- g0. apply (up (g38 p) (fun t => sin (p + t) - l)); [ lra | intros; apply g_der | ]. intros x Hx. pose proof (sin_above l hl (p + x)) as s. fold q in s. lra.
  - rewrite <- gP. apply Ropp_lt_cancel. apply (up (fun t => - g38 p t) (fun t => - (sin (p + t) - l))); [ lra | intros; apply (is_derive_opp (g38 p)), g_der | ].
    intros x Hx. enough (sin (p + x) < sin q) by lra. destruct (Rle_lt_dec (p + x) (3 * (PI / 2))).
    + rewrite <- (sin_PI_x (p + x)). apply sin_increasing_1; lra.
    + apply Rlt_trans with 0; [ apply sin_lt_0_var | apply sin_gt_0 ]; lra.
Qed.
(* (38): it passes through zero at 0 and PI, and moves between; the drive's phase at its start is (39) *)
Theorem eq38 : motion l (fun t => - sin (p + t)) (fun _ => 0) (ext PI (g38 p)) (fun _ => 0) /\ (forall t, 0 < t < PI -> 0 < ext PI (g38 p) t).
Proof.
  pose proof PI_RGT_0. destruct p_facts as [_ [c _]]. assert (g0 : g38 p 0 = 0) by (unfold g38; rewrite Rplus_0_r; ring). split.
  2: { intros t Ht. rewrite (ext_on PI (g38 p) PI_RGT_0 0) by (simpl; lra). unfold sg; simpl. rewrite Rmult_1_l, Rmult_0_l, Rminus_0_r. apply g_pos, Ht. }
  apply half_period; trivial.
  - intros t. replace (p + (t + PI)) with (p + t + PI) by ring. rewrite neg_sin. ring.
  - rewrite g0. unfold g38. rewrite neg_cos, c. field.
  - intros t _. apply derivable_continuous_pt. exists (sin (p + t) - l). apply is_derive_Reals, g_der.
  - intros t Ht. exists (- l). assert (0 <= g38 p t) by (destruct (Req_dec t 0) as [-> | ]; [ lra | left; apply g_pos; lra ]). split.
    + split; [ nra | ]. unfold nrm. replace (g38 p t ^ 2 + 0 ^ 2) with (Rsqr (g38 p t)) by (unfold Rsqr; ring). rewrite sqrt_Rsqr by trivial. ring.
    + apply rder_of. replace (- l - - sin (p + t)) with (sin (p + t) - l) by ring. apply g_der.
Qed.
End Small.
