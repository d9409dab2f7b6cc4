(* Section 2.1, the plane is pulled with the constant acceleration (-A, 0), lambda = mu g / A: (6) to (20) and what is said beside them, of every motion.
   pulled A lambda vx vy: a motion under this pull (Constant/Slip.v); polar vx vy v theta: v and theta are its speed and angle, (4) (Constant/Angle.v). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas.
From Slipbook.General Require Import Rates Contraction Exists Straight.
From Slipbook.Constant Require Export Slip Angle.
Open Scope R_scope.

Ltac emptied T := lazymatch T with
  | forall x : ?A, @?B x => constr:(forall x : A, ltac:(let b := eval cbv beta in (B x) in let r := emptied b in exact r))
  | _ => constr:(False) end.
Ltac occurs t := let T := type of t in let r := emptied T in exact (~ r).

(* ---- motions, from every start: at rest, at any angle, for every lambda ---- *)
Theorem pull_has_a_motion A lam v0 theta0 : 0 < A -> 0 <= lam ->
  exists vx vy, pulled A lam vx vy /\ vx 0 = eq4_velocity_1 v0 theta0 /\ vy 0 = eq4_velocity_2 v0 theta0.
Proof. intros hA hl. apply plane_has_a_motion. apply Rmult_le_pos; lra. intros; split; cont. Qed.
(* one that starts across the pull, with its speed and angle; for lambda <= 1 it never stops *)
Lemma across_start A lam : 0 < A -> 0 <= lam -> exists vx vy v theta, pulled A lam vx vy /\ polar vx vy v theta /\ v 0 = 1 /\ theta 0 = PI / 2 /\
  vx 0 = 0 /\ vy 0 = 1 /\ (lam <= 1 -> forall t, 0 <= t -> 0 < v t).
Proof.
  intros hA hl. destruct (plane_has_a_motion (A * lam) (fun _ => eq3_acceleration_1 A) (fun _ => eq3_acceleration_2 A) 0 1) as (vx & vy & M & e1 & e2).
  apply Rmult_le_pos; lra. intros; split; cont. exists vx, vy, (fun t => nrm (vx t) (vy t)), (fun t => angle (vx t) (vy t)). rewrite e1, e2, angle_up.
  assert (n1 : nrm 0 1 = 1) by (unfold nrm; replace (0 ^ 2 + 1 ^ 2) with 1 by ring; apply sqrt_1).
  split; [ exact M | ]. split; [ | repeat split; trivial ].
  - intros t Ht. split; [ apply nrm_pos | apply angle_polar ].
  - intros h t Ht. pose proof (plus_rises A lam vx vy hA hl M 0 t h ltac:(lra)) as r. rewrite e1, e2, n1 in r. destruct (sides vx vy t) as (_ & b & _). lra.
Qed.

Section Motions.
Variables (A lam : R) (vx vy v theta : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : pulled A lam vx vy.
Hypothesis P : polar vx vy v theta.
Notation slips_until t := (forall s, 0 <= s <= t -> 0 < v s).
Let slip t (H : slips_until t) s (Hs : 0 <= s <= t) : nrm (vx s) (vy s) <> 0.
Proof. rewrite (polar_speed vx vy v theta s P) by lra. specialize (H s Hs). lra. Qed.

(* (6), (7): while it slips *)
Theorem eq_6 t : 0 <= t -> 0 < v t -> rder (fun s => eq4_velocity_1 (v s) (theta s)) t (eq6_vx_rate lam A (theta t)).
Proof.
  intros Ht p. pose proof (polar_speed vx vy v theta t P Ht) as e. destruct (P t Ht) as (_ & _ & ex & _). destruct (pull_rates A lam vx vy hA hl M t Ht ltac:(lra)) as (X & _).
  apply (rder_ext _ vx t _ 1 Rlt_0_1). intros s Hs. now destruct (P s ltac:(lra)) as (_ & _ & ? & _).
  eapply rder_eq. exact X. rewrite e, ex. unfold eq6_vx_rate, eq4_velocity_1. field. lra.
Qed.
Theorem eq_7 t : 0 <= t -> 0 < v t -> rder (fun s => eq4_velocity_2 (v s) (theta s)) t (eq7_vy_rate lam A (theta t)).
Proof.
  intros Ht p. pose proof (polar_speed vx vy v theta t P Ht) as e. destruct (P t Ht) as (_ & _ & _ & ey). destruct (pull_rates A lam vx vy hA hl M t Ht ltac:(lra)) as (_ & Y & _).
  apply (rder_ext _ vy t _ 1 Rlt_0_1). intros s Hs. now destruct (P s ltac:(lra)) as (_ & _ & _ & ?).
  eapply rder_eq. exact Y. rewrite e, ey. unfold eq7_vy_rate, eq4_velocity_2. field. lra.
Qed.
(* (8): the rates p and q of the two components of the velocity stand in the printed ratio; q is 0 where lambda cos theta = 1 only
   (for lambda = 1 that is theta = 0, where p is 0, too; for lambda > 1 the path is upright there). *)
Theorem eq_8 t : 0 <= t -> 0 < v t -> exists p q, rder (fun s => eq4_velocity_2 (v s) (theta s)) t p /\ rder (fun s => eq4_velocity_1 (v s) (theta s)) t q /\
  (q = 0 <-> lam * cos (theta t) = 1) /\ (q <> 0 -> p / q = eq8_hodograph_slope lam (theta t)).
Proof.
  intros Ht n. exists (eq7_vy_rate lam A (theta t)), (eq6_vx_rate lam A (theta t)). split. now apply eq_7. split. now apply eq_6.
  unfold eq7_vy_rate, eq6_vx_rate, eq8_hodograph_slope. split. split; intros e; nra. intros e. field. split; [ | lra ]. intros z. apply e. rewrite z. ring.
Qed.
(* (9): at an angle, the relative rate of the speed is the printed multiple of the rate w of the angle *)
Theorem eq_9 t : 0 <= t -> 0 < v t -> theta t <> 0 -> theta t <> PI ->
  exists w d, rder theta t w /\ rder v t d /\ w <> 0 /\ d / v t = eq9_log_speed_rate lam (theta t) * w.
Proof.
  intros Ht p n0 n1. pose proof (polar_speed vx vy v theta t P Ht) as e. destruct (P t Ht) as (_ & b & ex & _). unfold eq4_velocity_1 in ex.
  destruct (pull_rates A lam vx vy hA hl M t Ht ltac:(lra)) as (_ & _ & S). rewrite e, ex in S.
  assert (s0 : sin (theta t) <> 0). { intros z. destruct (Rdichotomy _ _ n0). pose proof (sin_gt_0 (- theta t)). rewrite sin_neg in H0. lra. pose proof (sin_gt_0 (theta t)). lra. }
  exists (- (A * sin (theta t) / v t)), (A * (v t * cos (theta t) / v t) - A * lam). split. now apply (angle_rate A lam vx vy v theta). split; [ | split ].
  - apply (rder_ext _ (fun s => nrm (vx s) (vy s)) t _ 1 Rlt_0_1). intros s Hs. apply (polar_speed vx vy v theta); trivial; lra. exact S.
  - intros z. apply s0. apply (Rmult_eq_reg_l (A / v t)). lra. apply Rgt_not_eq. now apply Rdiv_lt_0_compat.
  - unfold eq9_log_speed_rate. field. split; lra.
Qed.
(* a start with 0 < theta < PI has vy > 0 as long as it slips *)
Lemma stays_above t : 0 <= t -> slips_until t -> 0 < theta 0 < PI -> 0 < theta t < PI.
Proof.
  intros Ht H h0. destruct (P 0 (Rle_refl 0)) as (_ & _ & _ & y0). destruct (P t Ht) as (_ & b & _ & y). unfold eq4_velocity_2 in *.
  pose proof (sin_gt_0 (theta 0) ltac:(lra) ltac:(lra)) as s0. pose proof (H 0 ltac:(lra)) as p0. pose proof (H t ltac:(lra)) as pt.
  destruct (power_law A lam vx vy hA hl M t Ht (slip t H)) as (_ & _ & _ & q & _). rewrite y0. nra. apply upper_half; trivial. rewrite y0, y in q.
  assert (0 < v 0 * sin (theta 0)) by now apply Rmult_lt_0_compat. assert (0 < v t * sin (theta t)) by nra. nra.
Qed.
(* (11): from every start at an angle, above or below the x-axis, as long as it slips *)
Theorem eq_11 t : 0 <= t -> slips_until t -> theta 0 <> 0 -> theta 0 <> PI -> v t = eq11_speed lam (v 0) (theta 0) (theta t).
Proof.
  intros Ht H n0 n1. destruct (P 0 (Rle_refl 0)) as (_ & b0 & _ & y0). destruct (P t Ht) as (_ & b & _ & y). pose proof (H 0 ltac:(lra)) as p0. pose proof (H t ltac:(lra)) as pt.
  unfold eq4_velocity_2 in *. assert (s0 : sin (theta 0) <> 0).
  { intros z. destruct (Rdichotomy _ _ n0) as [k | k]. pose proof (sin_gt_0 (- theta 0)) as q. rewrite sin_neg in q. lra. pose proof (sin_gt_0 (theta 0)). lra. }
  assert (Y0 : vy 0 <> 0) by (rewrite y0; apply Rmult_integral_contrapositive; lra). pose proof (power_law A lam vx vy hA hl M t Ht (slip t H) Y0) as (_ & _ & _ & q & _ & e).
  assert (st : sin (theta t) <> 0) by (intros z; rewrite y, z in q; lra). assert (n1' : theta t <> PI) by (intros z; apply st; rewrite z; apply sin_PI).
  destruct (tan_half vx vy v theta P t Ht pt n1') as [_ et]. destruct (tan_half vx vy v theta P 0 (Rle_refl 0) p0 n1) as [_ e0].
  rewrite et, e0 in e. unfold eq11_speed. rewrite <- e, y, y0. field. repeat split; trivial; lra.
Qed.
(* (10): from every start with 0 < theta < PI the value does not change as long as it slips (and the angle stays between 0 and PI) *)
Theorem eq_10 t : 0 <= t -> slips_until t -> 0 < theta 0 < PI -> 0 < theta t < PI /\ eq10_invariant lam (v t) (theta t) = eq10_invariant lam (v 0) (theta 0).
Proof.
  intros Ht H h0. pose proof (stays_above t Ht H h0) as h. split; trivial. pose proof (eq_11 t Ht H ltac:(lra) ltac:(lra)) as e. unfold eq11_speed in e.
  pose proof (sin_gt_0 (theta 0) ltac:(lra) ltac:(lra)) as s0. pose proof (sin_gt_0 (theta t) ltac:(lra) ltac:(lra)) as st.
  pose proof (tan_gt_0 (theta 0 / 2) ltac:(lra) ltac:(lra)) as t0. pose proof (tan_gt_0 (theta t / 2) ltac:(lra) ltac:(lra)) as tt.
  unfold eq10_invariant. unfold Rpower in *. rewrite (ln_div (tan (theta t / 2))) in e by trivial. set (a := ln (tan (theta t / 2))) in *. set (b := ln (tan (theta 0 / 2))) in *.
  rewrite e. transitivity (v 0 * sin (theta 0) * (exp (lam * (a - b)) * exp (- lam * a))). field. lra. rewrite <- exp_plus. f_equal. f_equal. ring.
Qed.
(* (12): along the motion, with x4 = d (tan (theta/2))^lambda / d theta and the rate w of the angle, A is the printed rate times w *)
Theorem eq_12 t x4 : 0 < lam -> 0 <= t -> slips_until t -> 0 < theta 0 < PI -> is_derive (fun th => Rpower (tan (th / 2)) lam) (theta t) x4 ->
  exists w, rder theta t w /\ A = eq12_time_rate lam (v 0) (theta 0) (theta t) x4 * w.
Proof.
  intros l0 Ht H h0 D. destruct (eq_10 t Ht H h0) as [h e]. pose proof (H t ltac:(lra)) as pt. exists (- (A * sin (theta t) / v t)).
  split. apply (angle_rate A lam vx vy v theta); trivial; lra.
  pose proof (sin_gt_0 (theta t) ltac:(lra) ltac:(lra)) as st. pose proof (tan_gt_0 (theta t / 2) ltac:(lra) ltac:(lra)) as tt. destruct (half_angle (theta t) ltac:(lra)) as [c0 et].
  assert (ch : 0 < cos (theta t / 2)) by (apply cos_gt_0; lra).
  assert (D' : is_derive (fun th => Rpower (tan (th / 2)) lam) (theta t) (lam * Rpower (tan (theta t / 2)) lam / sin (theta t))).
  { unfold Rpower. replace (lam * exp (lam * ln (tan (theta t / 2))) / sin (theta t)) with (/ sin (theta t) * (lam * exp (lam * ln (tan (theta t / 2))))) by (unfold Rdiv; ring).
    apply (is_derive_comp (fun x => exp (lam * x)) (fun th => ln (tan (th / 2)))). auto_derive; trivial. ring.
    unfold tan in *. auto_derive. split. lra. split; trivial. 
    assert (es : sin (theta t) = 2 * sin (theta t / 2) * cos (theta t / 2)) by (rewrite <- sin_2a; f_equal; field). rewrite es.
    assert (sh : 0 < sin (theta t / 2)) by (apply sin_gt_0; lra). pose proof (sc (theta t / 2)) as q. change (theta t * / 2) with (theta t / 2).
    set (s := sin (theta t / 2)) in *. set (c := cos (theta t / 2)) in *. field_simplify_eq; [ | split; lra ]. nra. }
  apply is_derive_unique in D. apply is_derive_unique in D'. rewrite D' in D. unfold eq12_time_rate. rewrite <- D. unfold eq10_invariant in e. rewrite !Rpower_Ropp in e.
  pose proof (exp_pos (lam * ln (tan (theta 0 / 2)))) as q0. pose proof (exp_pos (lam * ln (tan (theta t / 2)))) as q. fold (Rpower (tan (theta 0 / 2)) lam) in q0. fold (Rpower (tan (theta t / 2)) lam) in q.
  set (r0 := Rpower (tan (theta 0 / 2)) lam) in *. set (r := Rpower (tan (theta t / 2)) lam) in *. replace (v 0 * sin (theta 0) / r0) with (v t * sin (theta t) / r) by exact e. field. repeat split; lra.
Qed.
(* (14): from every start, as long as it slips *)
Theorem eq_14 t : 0 <= t -> (forall s, 0 <= s < t -> 0 < v s) -> lam + cos (theta t) <> 0 -> v t = eq14_speed_at_time lam A (v 0) (theta 0) (theta t) t.
Proof.
  intros Ht H n. assert (N : forall s, 0 <= s < t -> nrm (vx s) (vy s) <> 0). { intros s Hs. rewrite (polar_speed vx vy v theta s P) by lra. specialize (H s Hs). lra. }
  pose proof (moved A lam vx vy hA hl M t Ht N) as e. rewrite !(polar_speed vx vy v theta) in e by (trivial; lra). destruct (P t Ht) as (_ & _ & ex & _). destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _).
  rewrite ex, e0 in e. unfold eq4_velocity_1 in e. unfold eq14_speed_at_time. apply (Rmult_eq_reg_r (lam + cos (theta t))); trivial.
  replace (v t * (lam + cos (theta t))) with (lam * v t + v t * cos (theta t)) by ring. rewrite e. field. trivial.
Qed.
(* (13): from every start at an angle, as long as it slips *)
Theorem eq_13 t : 0 <= t -> slips_until t -> theta 0 <> 0 -> theta 0 <> PI -> lam <> 1 -> lam + cos (theta 0) <> 0 ->
  t = eq13_time lam A (v 0) (theta 0) (theta t).
Proof.
  intros Ht H n0 n1 h1 h0. pose proof (eq_11 t Ht H n0 n1) as E. pose proof (moved A lam vx vy hA hl M t Ht (fun s Hs => slip t H s ltac:(lra))) as e.
  rewrite !(polar_speed vx vy v theta) in e by (trivial; lra). destruct (P t Ht) as (_ & _ & ex & _). destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _).
  rewrite ex, e0 in e. unfold eq4_velocity_1, eq11_speed in *. assert (l2 : 1 - lam ^ 2 <> 0) by nra. unfold eq13_time. pose proof (H t ltac:(lra)) as pt.
  assert (st : sin (theta t) <> 0). { intros z. rewrite z in E. unfold Rdiv in E. rewrite Rinv_0 in E. lra. }
  set (X := Rpower _ lam) in *. apply (Rmult_eq_reg_l ((1 - lam ^ 2) * A)); [ | apply Rmult_integral_contrapositive; lra ].
  transitivity (v t * (lam + cos (theta t)) - v 0 * (lam + cos (theta 0))). lra. rewrite E at 1. field. repeat split; lra.
Qed.
End Motions.
