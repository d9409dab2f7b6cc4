(* Speed and angle of the velocity: (4), its converse, tangents of half the angle, and the rate at which the angle turns. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
From Slipbook.General Require Import Contraction.
From Slipbook.Constant Require Import Slip.
Open Scope R_scope.

(* (4): v and theta are the speed and the angle of the velocity with the x-axis, in radians above -PI up to PI; at rest the angle may be any *)
Definition polar vx vy v theta := forall t, 0 <= t -> 0 <= v t /\ - PI < theta t <= PI /\ vx t = eq4_velocity_1 (v t) (theta t) /\ vy t = eq4_velocity_2 (v t) (theta t).

Lemma sc th : sin th ^ 2 + cos th ^ 2 = 1.
Proof. pose proof (sin2_cos2 th) as e. unfold Rsqr in e. lra. Qed.
Lemma polar_speed vx vy v theta t : polar vx vy v theta -> 0 <= t -> nrm (vx t) (vy t) = v t.
Proof.
  intros P Ht. destruct (P t Ht) as (p & _ & -> & ->). unfold nrm, eq4_velocity_1, eq4_velocity_2. pose proof (sc (theta t)).
  replace ((v t * cos (theta t)) ^ 2 + (v t * sin (theta t)) ^ 2) with (v t ^ 2 * (sin (theta t) ^ 2 + cos (theta t) ^ 2)) by ring. rewrite H, Rmult_1_r. now apply sqrt_pow2.
Qed.
Lemma half_angle th : - PI < th < PI -> 0 < 1 + cos th /\ tan (th / 2) = sin th / (1 + cos th).
Proof.
  intros H. assert (c0 : 0 < cos (th / 2)) by (apply cos_gt_0; lra).
  assert (es : sin th = 2 * sin (th / 2) * cos (th / 2)) by (rewrite <- sin_2a; f_equal; field).
  assert (ec : cos th = 2 * cos (th / 2) * cos (th / 2) - 1) by (rewrite <- cos_2a_cos; f_equal; field).
  split. nra. unfold tan. rewrite es, ec. field. split; nra.
Qed.
Lemma upper_half th : - PI < th <= PI -> 0 < sin th -> 0 < th < PI.
Proof.
  intros H s. destruct (Rle_lt_dec th 0) as [k | k].
  - exfalso. pose proof (sin_ge_0 (- th) ltac:(lra) ltac:(lra)) as q. rewrite sin_neg in q. lra.
  - split; trivial. destruct (Req_dec th PI) as [-> | n]; [ rewrite sin_PI in s | ]; lra.
Qed.
Lemma plus_cos th : - PI < th <= PI -> th <> PI -> 0 < 1 + cos th. Proof. intros H n. apply half_angle. lra. Qed.
(* an angle is below its tangent *)
Lemma angle_small v th x y : 0 <= v -> - PI < th <= PI -> x = eq4_velocity_1 v th -> y = eq4_velocity_2 v th -> 0 < x -> Rabs th * x <= Rabs y.
Proof.
  unfold eq4_velocity_1, eq4_velocity_2. intros Hv H -> -> c. pose proof (Rabs_pos th) as p. set (a := Rabs th).
  assert (ec : cos th = cos a) by (unfold a, Rabs; destruct Rcase_abs; [ now rewrite cos_neg | trivial ]).
  assert (es : Rabs (sin th) = Rabs (sin a)) by (unfold a, Rabs at 3; destruct Rcase_abs; [ now rewrite sin_neg, Rabs_Ropp | trivial ]).
  assert (c0 : 0 < cos a) by (rewrite <- ec; nra). assert (a1 : a <= PI) by (apply Rabs_le; lra).
  assert (a2 : a < PI / 2). { apply Rnot_le_lt. intros q. pose proof (cos_le_0 a q ltac:(lra)). lra. }
  assert (K : a * cos a - sin a <= 0 * cos 0 - sin 0).
  { apply (rder_decr (fun t => t * cos t - sin t)); trivial; intros s Hs. apply derivable_continuous_pt. reg.
    exists (- (s * sin s)). split. apply rder_of. auto_derive; trivial. ring. pose proof (sin_ge_0 s ltac:(lra) ltac:(lra)). nra. }
  rewrite sin_0 in K. rewrite Rabs_mult, (Rabs_pos_eq v), es, ec by trivial. pose proof (Rle_abs (sin a)). replace (a * (v * cos a)) with (v * (a * cos a)) by ring.
  apply Rmult_le_compat_l; lra.
Qed.

(* the angle of a velocity *)
Definition angle x y := if Req_EM_T (nrm x y + x) 0 then PI else 2 * atan (y / (nrm x y + x)).
Lemma angle_polar x y : - PI < angle x y <= PI /\ x = eq4_velocity_1 (nrm x y) (angle x y) /\ y = eq4_velocity_2 (nrm x y) (angle x y).
Proof.
  unfold angle, eq4_velocity_1, eq4_velocity_2. pose proof (nrm_sq x y) as e. pose proof PI_RGT_0. destruct (abs_nrm x y) as [b _]. apply Rabs_le_between in b. set (n := nrm x y) in *.
  destruct Req_EM_T as [z | z].
  - rewrite cos_PI, sin_PI. assert (y = 0) by (assert (n = - x) by lra; subst n; nra). repeat split; lra.
  - set (u := y / (n + x)). pose proof (atan_bound u). set (a := atan u) in *. split. lra. pose proof (sc a) as q.
    assert (c0 : 0 < cos a) by (apply cos_gt_0; lra). assert (s : sin a = u * cos a). { rewrite <- (tan_atan u). fold a. unfold tan. field. lra. }
    assert (uy : u * (n + x) = y) by (unfold u; field; trivial).
    assert (c2 : cos a ^ 2 * (2 * n) = n + x).
    { apply (Rmult_eq_reg_r (n + x)); trivial. rewrite s in q. transitivity (cos a ^ 2 * ((n + x) ^ 2 + y ^ 2)); [ rewrite (Rplus_comm _ (y ^ 2)); replace (y ^ 2) with (n ^ 2 - x ^ 2) by lra; ring | ].
      rewrite <- uy. transitivity (((u * cos a) ^ 2 + cos a ^ 2) * (n + x) ^ 2); [ ring | rewrite q; ring ]. }
    rewrite cos_2a, sin_2a. split.
    + transitivity (n * (cos a ^ 2 - (1 - cos a ^ 2))); [ lra | f_equal; rewrite <- q; ring ].
    + rewrite s. transitivity (u * (cos a ^ 2 * (2 * n))); [ rewrite c2, uy; reflexivity | ring ].
Qed.
Lemma angle_up : angle 0 1 = PI / 2.
Proof.
  unfold angle. assert (e : nrm 0 1 = 1) by (unfold nrm; replace (0 ^ 2 + 1 ^ 2) with 1 by ring; apply sqrt_1). rewrite e.
  destruct Req_EM_T; [ lra | ]. replace (1 / (1 + 0)) with 1 by field. rewrite atan_1. field.
Qed.

Section Turn.
Variables (A lam : R) (vx vy v theta : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : pulled A lam vx vy.
Hypothesis P : polar vx vy v theta.
Notation n t := (nrm (vx t) (vy t)).
(* the tangent of half the angle *)
Lemma tan_half t : 0 <= t -> 0 < v t -> theta t <> PI -> 0 < n t + vx t /\ vy t / (n t + vx t) = tan (theta t / 2).
Proof.
  intros Ht p N. destruct (P t Ht) as (_ & b & ex & ey). destruct (half_angle (theta t) ltac:(lra)) as [c ->].
  rewrite (polar_speed vx vy v theta) by trivial. rewrite ex, ey. unfold eq4_velocity_1, eq4_velocity_2. split. nra. field. split; nra.
Qed.
Lemma angle_rate t : 0 <= t -> 0 < v t -> theta t <> PI -> rder theta t (- (A * sin (theta t) / v t)).
Proof.
  intros Ht p N. destruct (tan_half t Ht p N) as [C0 _]. pose proof (polar_speed vx vy v theta t P Ht) as en.
  assert (n0 : n t <> 0) by lra. destruct (pull_rates A lam vx vy hA hl M t Ht n0) as (_ & Y & _). destruct (side_rates A lam vx vy hA hl M t Ht n0) as [C _].
  destruct (rder_near_pos _ _ _ C C0) as (d & d0 & Hd). cbv beta in Hd.
  apply (rder_ext _ (fun s => 2 * atan (vy s * / (n s + vx s))) t _ d d0).
  - intros s Hs. specialize (Hd (s - t) ltac:(lra)). replace (t + (s - t)) with s in Hd by ring. destruct (P s ltac:(lra)) as (q & b & ex & _).
    rewrite (polar_speed vx vy v theta s P) in Hd by lra. rewrite ex in Hd. unfold eq4_velocity_1 in Hd.
    assert (v0 : 0 < v s). { destruct q as [q | q]; trivial. rewrite <- q in Hd. lra. }
    assert (N' : theta s <> PI). { intros k. rewrite k, cos_PI in Hd. lra. }
    destruct (tan_half s ltac:(lra) v0 N') as [_ e]. unfold Rdiv at 1 in e. rewrite e, atan_tan by lra. field.
  - assert (I : rder (fun s => / (n s + vx s)) t (- / (n t + vx t) ^ 2 * ((1 - lam) * A * ((n t + vx t) / n t)))).
    { apply (rder_comp (fun s => n s + vx s) Rinv); trivial. auto_derive. lra. field. lra. }
    pose proof (rder_mult _ _ _ _ _ Y I) as Q. cbv beta in Q.
    pose proof (rder_comp (fun s => vy s * / (n s + vx s)) atan t _ _ Q (proj2 (is_derive_Reals _ _ _) (derivable_pt_lim_atan _))) as R2. cbv beta in R2.
    eapply rder_eq. apply (rder_mult (fun _ => 2)); [ rd | exact R2 ]. cbv beta. destruct (P t Ht) as (_ & _ & _ & ey). unfold eq4_velocity_2 in ey. rewrite en in *.
    replace (A * sin (theta t) / v t) with (A * vy t / v t ^ 2) by (rewrite ey; field; lra).
    destruct (sides vx vy t) as (_ & _ & y2). rewrite en in y2. set (m := v t) in *. set (x := vx t) in *. set (y := vy t) in *.
    assert (e1 : 1 + (y * / (m + x)) ^ 2 = 2 * m / (m + x)). { replace (1 + (y * / (m + x)) ^ 2) with (((m + x) ^ 2 + y ^ 2) / (m + x) ^ 2) by (field; lra). rewrite <- y2. field. lra. }
    rewrite e1. field. split; lra.
Qed.
End Turn.
