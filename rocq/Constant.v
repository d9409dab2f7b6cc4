(* Section 2.1, the plane is pulled with the constant acceleration (-A, 0), lambda = mu g / A: (6) to (20) and what is said beside them, of every motion.
   pulled A lambda vx vy: a motion under this pull (Constant/Slip.v); polar vx vy v theta: v and theta are its speed and angle, (4) (Constant/Angle.v). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
From Slipbook.General Require Import Contraction Exists Straight.
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

(* (15), (16): without friction *)
Theorem eq_15 A vx vy : pulled A 0 vx vy -> forall t, 0 <= t -> vx t = eq15_vx A (vx 0) t.
Proof.
  intros M t Ht. unfold eq15_vx. enough (vx t - A * t = vx 0 - A * 0) by lra. apply (rder_const (fun t => vx t - A * t)); trivial; intros s Hs.
  - pose proof (cx A 0 vx vy M s ltac:(lra)). cont.
  - destruct (m_law _ _ _ _ _ M s ltac:(lra)) as (fx & fy & [B _] & X & _). unfold eq3_acceleration_1 in X. eapply rder_eq. rd.
    assert (fx = 0) by (pose proof (pow2_ge_0 fy); nra). lra.
Qed.
Theorem eq_16 A vx vy : pulled A 0 vx vy -> forall t, 0 <= t -> vy t = eq16_vy (vy 0).
Proof.
  intros M t Ht. unfold eq16_vy. apply rder_const; trivial; intros s Hs. apply (cy A 0 vx vy M); lra.
  destruct (m_law _ _ _ _ _ M s ltac:(lra)) as (fx & fy & [B _] & _ & Y). unfold eq3_acceleration_2 in Y. eapply rder_eq. exact Y.
  assert (fy = 0) by (pose proof (pow2_ge_0 fx); nra). lra.
Qed.
(* Without friction vy stays, vx grows at the rate A; where vy is not 0 the path (rx, ry) is the printed parabola through the start, else it is straight. *)
Theorem s21_frictionless_parabola A vx vy rx ry : pulled A 0 vx vy -> (forall t, 0 < t -> continuity_pt rx t /\ continuity_pt ry t) ->
  (forall t, 0 <= t -> rder rx t (vx t) /\ rder ry t (vy t)) -> forall t, 0 <= t ->
  vy t = vy 0 /\ vx t = vx 0 + A * t /\ (vy 0 <> 0 -> rx t - rx 0 = s21_parabola A (vx 0) (vy 0) (ry t - ry 0)) /\ (vy 0 = 0 -> ry t = ry 0).
Proof.
  intros M C D t Ht. split. now apply (eq_16 A vx vy M t). split. now apply (eq_15 A vx vy M t).
  assert (ey : ry t = ry 0 + vy 0 * t).
  { enough (ry t - vy 0 * t = ry 0 - vy 0 * 0) by lra. apply (rder_const (fun t => ry t - vy 0 * t)); trivial; intros s Hs.
    - destruct (C s ltac:(lra)). cont.
    - destruct (D s ltac:(lra)) as [_ Y]. eapply rder_eq. rd. pose proof (eq_16 A vx vy M s ltac:(lra)) as e. unfold eq16_vy in e. lra. }
  assert (ex : rx t = rx 0 + vx 0 * t + A * t ^ 2 * / 2).
  { enough (rx t - (vx 0 * t + A * t ^ 2 * / 2) = rx 0 - (vx 0 * 0 + A * 0 ^ 2 * / 2)) by lra. apply (rder_const (fun t => rx t - (vx 0 * t + A * t ^ 2 * / 2))); trivial; intros s Hs.
    - destruct (C s ltac:(lra)). cont.
    - destruct (D s ltac:(lra)) as [X _]. eapply rder_eq. rd. pose proof (eq_15 A vx vy M s ltac:(lra)) as e. unfold eq15_vx in e. simpl. lra. }
  rewrite ey, ex. unfold s21_parabola. split. intros n. field. exact n. intros ->. ring.
Qed.

(* (17) to (19), lambda = 1: from every start, at all times, and at large times *)
Theorem eq_17 A vx vy v theta : 0 < A -> pulled A 1 vx vy -> polar vx vy v theta -> forall t, 0 <= t ->
  eq17_invariant (v t) (theta t) = eq17_invariant (v 0) (theta 0).
Proof.
  intros hA M P t Ht. pose proof (plus_stays A vx vy hA M t Ht) as e. rewrite !(polar_speed vx vy v theta) in e by (trivial; lra).
  destruct (P t Ht) as (_ & _ & ex & _). destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _). rewrite ex, e0 in e. unfold eq4_velocity_1, eq17_invariant in *. lra.
Qed.
Theorem eq_18 A vx vy v theta : 0 < A -> pulled A 1 vx vy -> polar vx vy v theta -> is_lim vx p_infty (eq18_vx_limit (v 0) (theta 0)).
Proof.
  intros hA M P. destruct (critical_late A vx vy hA M) as [_ L]. rewrite (polar_speed vx vy v theta) in L by (trivial; lra). destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _).
  rewrite e0 in L. unfold eq18_vx_limit, eq4_velocity_1 in *. replace (v 0 * (1 + cos (theta 0)) / 2) with ((v 0 + v 0 * cos (theta 0)) / 2) by field. exact L.
Qed.
Theorem eq_19 A vx vy : 0 < A -> pulled A 1 vx vy -> is_lim vy p_infty eq19_vy_limit.
Proof. intros hA M. exact (proj1 (critical_late A vx vy hA M)). Qed.
(* lambda = 1: the velocity tends to the constant of (18) and (19). *)
Theorem s21_critical_terminal_velocity A vx vy v theta : 0 < A -> pulled A 1 vx vy -> polar vx vy v theta ->
  is_lim vx p_infty (eq18_vx_limit (v 0) (theta 0)) /\ is_lim vy p_infty eq19_vy_limit.
Proof. intros hA M P. split. now apply (eq_18 A vx vy v theta). now apply (eq_19 A vx vy). Qed.

(* (20), lambda > 1: from every start the particle slips before T, and rests from T on. *)
Theorem eq_20 A lam vx vy v theta : 0 < A -> 1 < lam -> pulled A lam vx vy -> polar vx vy v theta ->
  let T := eq20_stop_time lam A (v 0) (theta 0) in 0 <= T /\ (forall t, 0 <= t < T -> v t <> 0) /\ forall t, T <= t -> v t = 0.
Proof.
  intros hA h1 M P T. assert (hl : 0 <= lam) by lra. assert (eT : (lam * nrm (vx 0) (vy 0) + vx 0) / (A * (lam ^ 2 - 1)) = T).
  { rewrite (polar_speed vx vy v theta) by (trivial; lra). destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _). rewrite e0. unfold T, eq20_stop_time, eq4_velocity_1. f_equal. ring. }
  pose proof (T_pos A lam vx vy hA h1) as T0. rewrite eT in T0. split; trivial. split; intros t Ht.
  - rewrite <- (polar_speed vx vy v theta t P) by lra. apply (slip_before A lam vx vy hA hl M h1). rewrite eT. exact Ht.
  - rewrite <- (polar_speed vx vy v theta t P) by lra. apply (rest_after A lam vx vy hA hl M h1). rewrite eT. exact Ht.
Qed.
(* lambda > 1: it comes to rest at the time T of (20), and the angle tends to 0 as t -> T from below, but for a start at theta = PI. *)
Theorem s21_large_friction_stops A lam vx vy v theta : 0 < A -> 1 < lam -> pulled A lam vx vy -> polar vx vy v theta ->
  let T := eq20_stop_time lam A (v 0) (theta 0) in (forall t, 0 <= t < T -> v t <> 0) /\ (forall t, T <= t -> v t = 0) /\
  (theta 0 <> PI -> forall e, 0 < e -> exists d, 0 < d /\ forall t, 0 <= t < T -> T - d < t -> Rabs (theta t - s21_late_angle) < e).
Proof.
  intros hA h1 M P T. destruct (eq_20 A lam vx vy v theta hA h1 M P) as (T0 & S & R). fold T in T0, S, R. split; trivial. split; trivial. intros n e He.
  destruct (P 0 (Rle_refl 0)) as (p0 & b0 & e0 & _). unfold s21_late_angle. destruct p0 as [p0 | z].
  2: { exists 1. split. lra. intros t Ht. exfalso. apply (S 0); [ lra | now rewrite <- z ]. }
  pose proof (plus_cos (theta 0) b0 n) as c0. pose proof (polar_speed vx vy v theta 0 P (Rle_refl 0)) as ev.
  assert (C0 : 0 < nrm (vx 0) (vy 0) + vx 0) by (rewrite ev, e0; unfold eq4_velocity_1; nra).
  destruct (turns_before_stop A lam vx vy hA h1 M C0 (e / 2) ltac:(lra)) as (d & d0 & Hd).
  assert (eT : (lam * nrm (vx 0) (vy 0) + vx 0) / (A * (lam ^ 2 - 1)) = T) by (rewrite ev, e0; unfold T, eq20_stop_time, eq4_velocity_1; f_equal; ring). rewrite eT in Hd.
  exists d. split; trivial. intros t Ht Hs. destruct (Hd t Ht Hs) as [x y]. destruct (P t ltac:(lra)) as (pt & bt & ext & eyt).
  pose proof (angle_small (v t) (theta t) (vx t) (vy t) pt bt ext eyt x) as K. rewrite Rminus_0_r. apply Rle_lt_trans with (e / 2); [ | lra ]. apply (Rmult_le_reg_r (vx t)); lra.
Qed.
(* The excepted start, straight against the pull: the angle stays PI until the stop. *)
Theorem s21_large_friction_stops__at_PI A lam vx vy v theta : 0 < A -> 1 < lam -> pulled A lam vx vy -> polar vx vy v theta -> theta 0 = PI ->
  forall t, 0 <= t < eq20_stop_time lam A (v 0) (theta 0) -> theta t = PI.
Proof.
  intros hA h1 M P e t Ht. destruct (eq_20 A lam vx vy v theta hA h1 M P) as (_ & S & _). destruct (P t ltac:(lra)) as (p & b & ex & ey). destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _).
  assert (C : nrm (vx t) (vy t) + vx t <= nrm (vx 0) (vy 0) + vx 0).
  { apply (rder_decr (fun t => nrm (vx t) (vy t) + vx t)); [ lra | | ]; intros s Hs. pose proof (cx A lam vx vy M s ltac:(lra)). pose proof (cy A lam vx vy M s ltac:(lra)). cont.
    assert (N : nrm (vx s) (vy s) <> 0) by (rewrite (polar_speed vx vy v theta) by (trivial; lra); apply S; lra).
    destruct (side_rates A lam vx vy hA ltac:(lra) M s ltac:(lra) N) as [D _]. eexists. split. exact D. destruct (sides vx vy s) as (a & _). pose proof (nrm_pos (vx s) (vy s)).
    assert (0 <= (nrm (vx s) (vy s) + vx s) / nrm (vx s) (vy s)) by (apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ]; lra). assert (0 <= (lam - 1) * A) by nra. nra. }
  rewrite !(polar_speed vx vy v theta) in C by (trivial; lra). rewrite ex, e0, e in C. unfold eq4_velocity_1 in C. rewrite cos_PI in C.
  destruct (Req_dec (theta t) PI) as [z | n]; trivial. exfalso. pose proof (plus_cos _ b n). pose proof (S t Ht). nra.
Qed.

(* lambda <= 1, but for lambda = 1 from rest or at theta = PI: from some time on the particle slides, and its angle tends to 0. *)
Theorem s21_small_friction_aligns A lam vx vy v theta : 0 < A -> 0 <= lam -> s21_keeps_moving_sides_1 lam <= s21_keeps_moving_sides_2 lam ->
  pulled A lam vx vy -> polar vx vy v theta -> ~ (lam = 1 /\ (v 0 = 0 \/ theta 0 = PI)) ->
  (exists T, forall t, T <= t -> 0 < v t) /\ is_lim theta p_infty s21_late_angle.
Proof.
  unfold s21_keeps_moving_sides_1, s21_keeps_moving_sides_2, s21_late_angle. intros hA hl l1 M P X.
  assert (h : lam < 1 \/ 0 < nrm (vx 0) (vy 0) + vx 0).
  { destruct l1 as [l1 | ->]; [ now left | right ]. destruct (P 0 (Rle_refl 0)) as (p & b & e0 & _). rewrite (polar_speed vx vy v theta), e0 by (trivial; lra).
    assert (v 0 <> 0) by tauto. assert (n : theta 0 <> PI) by tauto. pose proof (plus_cos _ b n). unfold eq4_velocity_1. nra. }
  pose proof (turns_forward A lam vx vy hA (conj hl l1) M h) as G. split.
  - destruct (G 1 Rlt_0_1) as (T & T0 & HT). exists T. intros t Ht. destruct (HT t Ht) as [x _]. destruct (P t ltac:(lra)) as ([p | z] & _ & ex & _); trivial.
    rewrite ex, <- z in x. unfold eq4_velocity_1 in x. lra.
  - apply is_lim_spec. intros e. pose proof (cond_pos e) as He. destruct (G (e / 2) ltac:(lra)) as (T & T0 & HT). exists T. intros t Ht. destruct (HT t ltac:(lra)) as [x y].
    destruct (P t ltac:(lra)) as (p & b & ex & ey). pose proof (angle_small (v t) (theta t) (vx t) (vy t) p b ex ey x). rewrite Rminus_0_r.
    apply Rle_lt_trans with (e / 2); [ | lra ]. apply (Rmult_le_reg_r (vx t)); lra.
Qed.
(* The excepted starts: with lambda = 1 the particle stops at v0 / (2 A), and rests. *)
Theorem s21_small_friction_aligns__excepted A vx vy v theta : 0 < A -> pulled A 1 vx vy -> polar vx vy v theta -> v 0 = 0 \/ theta 0 = PI ->
  forall t, v 0 / (2 * A) < t -> v t = 0.
Proof.
  intros hA M P X t Ht. destruct (P 0 (Rle_refl 0)) as (p & _ & e0 & _). pose proof (polar_speed vx vy v theta 0 P (Rle_refl 0)) as ev.
  assert (q : 0 <= v 0 / (2 * A)) by (apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ]; lra).
  rewrite <- (polar_speed vx vy v theta t P) by lra. apply (straight_stops A vx vy hA M); try lra. 2: now rewrite ev.
  rewrite ev, e0. unfold eq4_velocity_1. destruct X as [-> | ->]; rewrite ?cos_PI; ring.
Qed.
(* lambda < 1: no rest lasts, however short; a particle at rest moves at once, and for ever. *)
Theorem s21_friction_cannot_hold A lam vx vy : 0 < A -> 0 <= lam -> s21_cannot_hold_sides_1 lam < s21_cannot_hold_sides_2 lam -> pulled A lam vx vy ->
  forall s t, 0 <= s < t -> nrm (vx s) (vy s) = 0 -> nrm (vx t) (vy t) <> 0.
Proof.
  unfold s21_cannot_hold_sides_1, s21_cannot_hold_sides_2. intros hA hl l1 M s t Hst e z. destruct (nrm_zero _ _ e) as [e1 _]. destruct (nrm_zero _ _ z) as [z1 _].
  pose proof (forward_grows A lam vx vy hA hl M s t ltac:(lra)). assert (0 < A * (1 - lam) * (t - s)) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.
(* The printed lambda <= 1 fails at lambda = 1: rest is a motion exactly when lambda >= 1. *)
Theorem s21_friction_cannot_hold__printed A lam : 0 < A -> 0 <= lam -> (pulled A lam (fun _ => 0) (fun _ => 0) <-> 1 <= lam).
Proof.
  intros hA hl. split.
  - intros M. apply Rnot_lt_le. intros l1. apply (s21_friction_cannot_hold A lam _ _ hA hl l1 M 0 1); [ lra | | ]; apply nrm_0.
  - intros l1. split. 1, 2: intros; cont. intros t Ht. exists (- A), 0. unfold coulomb, eq3_acceleration_1, eq3_acceleration_2. cbv beta. rewrite nrm_0. split.
    split; [ | ring ]. assert (A * 1 <= A * lam) by (apply Rmult_le_compat_l; lra). nra. split; (eapply rder_eq; [ rd | ring ]).
Qed.

(* Friction k up to the constant acceleration (ax, ay) of the plane, but for k = |A| from rest or straight along A: the cosine of the angle between the velocity and A
   tends to -1. The particle slides against the plane's acceleration; the print, along it, is wrong. *)
Theorem s21_along_acceleration k ax ay vx vy : 0 <= k <= nrm ax ay -> 0 < nrm ax ay -> motion k (fun _ => ax) (fun _ => ay) vx vy ->
  (k < nrm ax ay \/ ax * vx 0 + ay * vy 0 < nrm ax ay * nrm (vx 0) (vy 0)) ->
  let cosine t := (ax * vx t + ay * vy t) / (nrm ax ay * nrm (vx t) (vy t)) in
  is_lim cosine p_infty right_constant_late_sense /\ ~ is_lim cosine p_infty s21_late_sense.
Proof.
  intros hk hA M h cosine. pose proof (nrm_sq ax ay) as ea. set (a := nrm ax ay) in *. set (ex := - ax / a). set (ey := - ay / a).
  assert (He : ex ^ 2 + ey ^ 2 = 1). { unfold ex, ey. replace ((- ax / a) ^ 2 + (- ay / a) ^ 2) with ((ax ^ 2 + ay ^ 2) / a ^ 2) by (field; lra). rewrite <- ea. field. lra. }
  set (ux t := ex * vx t + ey * vy t). set (uy t := ex * vy t - ey * vx t).
  assert (N : pulled a (k / a) ux uy).
  { unfold pulled. replace (a * (k / a)) with k by (field; lra). apply (motion_turned ex ey k (fun _ => ax) (fun _ => ay)); trivial; intros _; unfold eq3_acceleration_1, eq3_acceleration_2, ex, ey.
    - transitivity (- (ax ^ 2 + ay ^ 2) / a); [ rewrite <- ea | ]; field; lra.
    - field. lra. }
  assert (en : forall t, nrm (ux t) (uy t) = nrm (vx t) (vy t)) by (intros t; unfold ux, uy; now apply nrm_turned).
  assert (eu : forall t, ux t = - (ax * vx t + ay * vy t) / a) by (intros t; unfold ux, ex, ey; field; lra).
  assert (l1 : 0 <= k / a <= 1) by (split; [ apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ] | apply Rle_div_l ]; lra).
  assert (h' : k / a < 1 \/ 0 < nrm (ux 0) (uy 0) + ux 0).
  { destruct h as [h | h]; [ left; apply Rlt_div_l; lra | right ]. rewrite en, eu. apply (Rmult_lt_reg_r a); trivial. rewrite Rmult_0_l.
    replace ((nrm (vx 0) (vy 0) + - (ax * vx 0 + ay * vy 0) / a) * a) with (a * nrm (vx 0) (vy 0) - (ax * vx 0 + ay * vy 0)) by (field; lra). lra. }
  assert (L : is_lim cosine p_infty (-1)).
  { apply is_lim_spec. intros e. pose proof (cond_pos e) as e0. destruct (turns_forward a (k / a) ux uy hA l1 N h' (e / 2) ltac:(lra)) as (T & T0 & HT). exists T. intros t Ht.
    destruct (HT t ltac:(lra)) as [x y]. pose proof (nrm_abs (ux t) (uy t)) as n1. rewrite (Rabs_pos_eq (ux t)) in n1 by lra. destruct (abs_nrm (ux t) (uy t)) as [n2 _]. rewrite (Rabs_pos_eq (ux t)) in n2 by lra.
    assert (ec : cosine t = - (ux t / nrm (ux t) (uy t))). { unfold cosine. rewrite en, eu. field. rewrite <- en. lra. }
    rewrite ec. set (n := nrm (ux t) (uy t)) in *. assert (ux t / n <= 1) by (apply Rle_div_l; lra). assert (1 - e / 2 <= ux t / n) by (apply Rle_div_r; nra). apply Rabs_def1; lra. }
  split. exact L. intros K. apply is_lim_unique in L. apply is_lim_unique in K. rewrite L in K. unfold s21_late_sense in K. injection K. lra.
Qed.

(* A particle on an incline of slope beta at rest: weight g, normal force N along (sin beta, 0, cos beta), friction F in the slope, of size mu N at most and of
   power - mu N |w|, all by unit of mass; its velocity w = (wx, wy, wz) stays in the slope. *)
Record on_incline mu g beta (wx wy wz : R -> R) : Prop := {
  incline_c : forall t, 0 < t -> continuity_pt wx t /\ continuity_pt wy t /\ continuity_pt wz t;
  incline_law : forall t, 0 <= t -> wx t * sin beta + wz t * cos beta = 0 /\ exists N Fx Fy Fz, 0 <= N /\ Fx * sin beta + Fz * cos beta = 0 /\
    Fx ^ 2 + Fy ^ 2 + Fz ^ 2 <= (mu * N) ^ 2 /\ Fx * wx t + Fy * wy t + Fz * wz t = - (mu * N) * sqrt (wx t ^ 2 + wy t ^ 2 + wz t ^ 2) /\
    rder wx t (N * sin beta + Fx) /\ rder wy t Fy /\ rder wz t (- g + N * cos beta + Fz) }.
(* The motions on an incline are those under the constant pull A = g sin beta with g cos beta in the place of g: seen down the slope and across it each is one,
   and each of these is one on the incline. *)
Theorem s21_incline mu g beta : 0 < g -> 0 < beta < PI / 2 ->
  let A := g * sin beta in let lam := eq5_lambda mu (g * cos beta) A in
  (forall wx wy wz, on_incline mu g beta wx wy wz -> pulled A lam (fun t => cos beta * wx t - sin beta * wz t) wy) /\
  (forall vx vy, pulled A lam vx vy -> on_incline mu g beta (fun t => cos beta * vx t) vy (fun t => - sin beta * vx t)).
Proof.
  intros hg hb A lam. assert (s0 : 0 < sin beta) by (apply sin_gt_0; lra). assert (c0 : 0 < cos beta) by (apply cos_gt_0; lra). pose proof (sc beta) as q. set (s := sin beta) in *. set (c := cos beta) in *.
  assert (k0 : A * lam = mu * (g * c)) by (unfold lam, eq5_lambda, A; field; lra). unfold pulled. rewrite k0. split.
  - intros wx wy wz [C L]. fold s c in L. split. 1, 2: intros t Ht; destruct (C t Ht) as (? & ? & ?); cont. intros t Ht. destruct (L t Ht) as (_ & N & Fx & Fy & Fz & N0 & F0 & B & P & X & Y & Z).
    assert (eN : N = g * c).
    { assert (D : rder (fun t => wx t * s + wz t * c) t ((N * s + Fx) * s + (- g + N * c + Fz) * c)) by (eapply rder_eq; [ rd | ring ]).
      assert (D0 : rder (fun t => wx t * s + wz t * c) t 0). { apply (rder_ext _ (fun _ => 0) t 0 1 Rlt_0_1); [ | rd ]. intros r Hr. destruct (L r ltac:(lra)) as [e _]. symmetry. exact e. }
      pose proof (rder_one _ _ _ _ D D0) as e. assert (N * (s ^ 2 + c ^ 2) + (Fx * s + Fz * c) - g * c = 0) by lra. rewrite q, F0 in H. lra. }
    subst N. destruct (L t Ht) as (w0 & _).
    assert (two : forall a b a' b', a * s + b * c = 0 -> a' * s + b' * c = 0 -> (c * a - s * b) * (c * a' - s * b') = a * a' + b * b').
    { intros a b a' b' h h'. transitivity ((s ^ 2 + c ^ 2) * (a * a' + b * b') - (a * s + b * c) * (a' * s + b' * c)); [ ring | rewrite q, h; ring ]. }
    exists (c * Fx - s * Fz), Fy. split; [ split | split ].
    + pose proof (two _ _ _ _ F0 F0). replace ((c * Fx - s * Fz) ^ 2) with (Fx * Fx + Fz * Fz) by (rewrite <- H; ring). lra.
    + rewrite (two _ _ _ _ F0 w0). unfold nrm. replace ((c * wx t - s * wz t) ^ 2) with (wx t * wx t + wz t * wz t) by (rewrite <- (two _ _ _ _ w0 w0); ring).
      replace (wx t * wx t + wz t * wz t + wy t ^ 2) with (wx t ^ 2 + wy t ^ 2 + wz t ^ 2) by ring. rewrite <- P. ring.
    + eapply rder_eq. rd. unfold eq3_acceleration_1, A. fold s. ring.
    + eapply rder_eq. rd. unfold eq3_acceleration_2. ring.
  - intros vx vy [cx cy L]. split. { intros t Ht. specialize (cx t Ht). specialize (cy t Ht). repeat split; trivial; cont. }
    intros t Ht. destruct (L t Ht) as (fx & fy & [B P] & X & Y). unfold eq3_acceleration_1, eq3_acceleration_2, A in *. fold s c in X |- *. split. ring. exists (g * c), (c * fx), fy, (- s * fx). repeat split.
    + nra.
    + ring.
    + replace ((c * fx) ^ 2 + fy ^ 2 + (- s * fx) ^ 2) with ((s ^ 2 + c ^ 2) * fx ^ 2 + fy ^ 2) by ring. rewrite q. lra.
    + replace ((c * vx t) ^ 2 + vy t ^ 2 + (- s * vx t) ^ 2) with ((s ^ 2 + c ^ 2) * vx t ^ 2 + vy t ^ 2) by ring. rewrite q, Rmult_1_l.
      fold (nrm (vx t) (vy t)). rewrite <- P. transitivity ((s ^ 2 + c ^ 2) * (fx * vx t) + fy * vy t); [ ring | rewrite q; ring ].
    + eapply rder_eq. rd. ring.
    + eapply rder_eq. rd. ring.
    + eapply rder_eq. rd. assert (- g = - g * (s ^ 2 + c ^ 2)) as -> by (rewrite q; ring). ring.
Qed.
(* A drive that depends on time is no incline: if each motion under a continuous drive is one under a constant pull (ax, ay), with any friction k', then k' = k
   and the drive is that constant at all times. *)
Theorem s21_incline_only_constant k k' Ax Ay ax ay : 0 <= k -> 0 <= k' -> (forall t, 0 <= t -> continuity_pt Ax t /\ continuity_pt Ay t) ->
  (forall vx vy, motion k Ax Ay vx vy -> motion k' (fun _ => ax) (fun _ => ay) vx vy) -> k' = k /\ forall t, 0 <= t -> Ax t = ax /\ Ay t = ay.
Proof.
  intros hk hk' C H. assert (R : forall vx vy t, motion k Ax Ay vx vy -> 0 <= t -> nrm (vx t) (vy t) <> 0 ->
    - Ax t - k * (vx t / nrm (vx t) (vy t)) = - ax - k' * (vx t / nrm (vx t) (vy t)) /\ - Ay t - k * (vy t / nrm (vx t) (vy t)) = - ay - k' * (vy t / nrm (vx t) (vy t))).
  { intros vx vy t M Ht N. destruct (slip_rates _ _ _ _ _ hk M t Ht N) as [X Y]. destruct (slip_rates _ _ _ _ _ hk' (H _ _ M) t Ht N) as [X' Y'].
    split; eapply rder_one; eassumption. }
  assert (n1 : forall x, x ^ 2 = 1 -> nrm x 0 = 1) by (intros x e; unfold nrm; rewrite e; replace (1 + 0 ^ 2) with 1 by ring; apply sqrt_1).
  assert (ek : k' = k).
  { destruct (plane_has_a_motion k Ax Ay 1 0 hk C) as (vx & vy & M & e1 & e2). destruct (plane_has_a_motion k Ax Ay (-1) 0 hk C) as (ux & uy & M' & f1 & f2).
    destruct (R vx vy 0 M (Rle_refl 0)) as [a _]. rewrite e1, e2, n1; lra. destruct (R ux uy 0 M' (Rle_refl 0)) as [b _]. rewrite f1, f2, n1; lra.
    rewrite e1, e2, n1 in a by lra. rewrite f1, f2, n1 in b by lra. lra. }
  split; trivial. intros t Ht. subst k'.
  destruct (continuity_ab_maj (fun s => Rabs (Ax s)) 0 t Ht) as (m & Hm & _). { intros s Hs. apply (continuity_pt_comp Ax Rabs). apply C; lra. apply Rcontinuity_abs. }
  set (B := (k + Rabs (Ax m)) * t + 1). destruct (plane_has_a_motion k Ax Ay B 0 hk C) as (vx & vy & M & e1 & _).
  assert (L : Rabs (vx t - vx 0) <= (k + Rabs (Ax m)) * (t - 0)).
  { apply rder_lip; trivial; intros s Hs. apply (m_cx _ _ _ _ _ M); lra. destruct (m_law _ _ _ _ _ M s ltac:(lra)) as (fx & fy & [b _] & X & _). eexists. split. exact X.
    specialize (Hm s ltac:(lra)). apply Rabs_le_between in Hm. assert (- k <= fx <= k) by (pose proof (pow2_ge_0 fy); nra). apply Rabs_le. lra. }
  apply Rabs_le_between in L. assert (x1 : 1 <= vx t) by (unfold B in e1; lra). destruct (abs_nrm (vx t) (vy t)) as [b _]. rewrite Rabs_pos_eq in b by lra.
  destruct (R vx vy t M Ht) as [X Y]; lra.
Qed.

(* ---- the hypotheses of these theorems can be met ---- *)
Ltac start A lam := destruct (across_start A lam) as (vx & vy & v & theta & M & P & v0 & th0 & x0 & y0 & go); [ lra | lra | pose proof PI_RGT_0 ].
Ltac goes := intros; match goal with g : _ <= 1 -> forall t, 0 <= t -> 0 < _ |- _ => apply g; lra end.
Lemma eq_6__occurs : ltac:(occurs eq_6). Proof. intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 _ _); [ lra | lra | lra | goes ]. Qed.
Lemma eq_7__occurs : ltac:(occurs eq_7). Proof. intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 _ _); [ lra | lra | lra | goes ]. Qed.
Lemma eq_8__occurs : ltac:(occurs eq_8). Proof. intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 _ _); [ lra | lra | lra | goes ]. Qed.
Lemma eq_9__occurs : ltac:(occurs eq_9). Proof. intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 0 _ _ _ _); lra. Qed.
Lemma eq_10__occurs : ltac:(occurs eq_10). Proof. intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 _ _ _); [ lra | lra | lra | goes | lra ]. Qed.
Lemma eq_11__occurs : ltac:(occurs eq_11). Proof. intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 _ _ _ _); [ lra | lra | lra | goes | lra | lra ]. Qed.
Lemma eq_12__occurs : ltac:(occurs eq_12).
Proof.
  intros H. start 1 (1 / 2). assert (h0 : 0 < theta 0 < PI) by lra. assert (s : forall t, 0 <= t <= 1 -> 0 < v t) by goes.
  pose proof (stays_above 1 (1 / 2) vx vy v theta ltac:(lra) ltac:(lra) M P 1 ltac:(lra) s h0) as h.
  refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 (Derive (fun th => Rpower (tan (th / 2)) (1 / 2)) (theta 1)) _ _ s h0 _); try lra.
  apply Derive_correct. assert (0 < cos (theta 1 / 2)) by (apply cos_gt_0; lra). pose proof (tan_gt_0 (theta 1 / 2) ltac:(lra) ltac:(lra)).
  unfold Rpower, tan in *. auto_derive. split; [ unfold Rdiv in *; lra | split; [ assumption | trivial ] ].
Qed.
Lemma eq_13__occurs : ltac:(occurs eq_13).
Proof.
  intros H. start 1 (1 / 2). refine (H 1 (1 / 2) vx vy v theta _ _ M P 1 _ _ _ _ _ _); [ lra | lra | lra | goes | lra | lra | lra | rewrite th0, cos_PI2; lra ].
Qed.
Lemma eq_14__occurs : ltac:(occurs eq_14).
Proof.
  intros H. start 1 1. assert (s : forall t, 0 <= t < 1 -> 0 < v t) by goes. pose proof (go ltac:(lra) 1 ltac:(lra)) as v1. destruct (P 1 ltac:(lra)) as (_ & b & e & _).
  refine (H 1 1 vx vy v theta _ _ M P 1 _ s _); try lra. intros z. pose proof (plus_rises 1 1 vx vy ltac:(lra) ltac:(lra) M 0 1 ltac:(lra) ltac:(lra)) as r.
  rewrite !(polar_speed vx vy v theta) in r by (trivial; lra). rewrite x0, v0, e in r. unfold eq4_velocity_1 in r. nra.
Qed.
Lemma eq_15__occurs : ltac:(occurs eq_15). Proof. intros H. start 1 0. exact (H 1 vx vy M 0 (Rle_refl 0)). Qed.
Lemma eq_16__occurs : ltac:(occurs eq_16). Proof. intros H. start 1 0. exact (H 1 vx vy M 0 (Rle_refl 0)). Qed.
(* the parabola from (0, 0), crosswise *)
Lemma s21_frictionless_parabola__occurs : ltac:(occurs s21_frictionless_parabola).
Proof.
  intros H. refine (H 1 (fun t => t) (fun _ => 1) (fun t => t ^ 2 * / 2) (fun t => t) _ _ _ 0 (Rle_refl 0)).
  - split. 1, 2: intros; cont. intros t Ht. exists 0, 0. unfold coulomb, eq3_acceleration_1, eq3_acceleration_2. split. split; ring_simplify; lra. split; (eapply rder_eq; [ rd | ring ]).
  - intros; split; cont.
  - intros; split; (eapply rder_eq; [ rd | simpl; field ]).
Qed.
Lemma eq_17__occurs : ltac:(occurs eq_17). Proof. intros H. start 1 1. refine (H 1 vx vy v theta _ M P 0 _); lra. Qed.
Lemma eq_18__occurs : ltac:(occurs eq_18). Proof. intros H. start 1 1. refine (H 1 vx vy v theta _ M P); lra. Qed.
Lemma eq_19__occurs : ltac:(occurs eq_19). Proof. intros H. start 1 1. refine (H 1 vx vy _ M); lra. Qed.
Lemma s21_critical_terminal_velocity__occurs : ltac:(occurs s21_critical_terminal_velocity). Proof. intros H. start 1 1. refine (H 1 vx vy v theta _ M P); lra. Qed.
Lemma eq_20__occurs : ltac:(occurs eq_20). Proof. intros H. start 1 2. refine (H 1 2 vx vy v theta _ _ M P); lra. Qed.
Lemma s21_large_friction_stops__occurs : ltac:(occurs s21_large_friction_stops). Proof. intros H. start 1 2. refine (H 1 2 vx vy v theta _ _ M P); lra. Qed.
(* at PI: from (-1, 0), with T = 1 / 3 for lambda = 2 *)
Lemma s21_large_friction_stops__at_PI__occurs : ltac:(occurs s21_large_friction_stops__at_PI).
Proof.
  intros H. destruct (pull_has_a_motion 1 2 1 PI) as (vx & vy & M & e1 & e2); try lra. unfold eq4_velocity_1, eq4_velocity_2 in *. rewrite cos_PI, sin_PI in *.
  assert (n1 : nrm (vx 0) (vy 0) = 1) by (unfold nrm; rewrite e1, e2; replace ((1 * -1) ^ 2 + (1 * 0) ^ 2) with 1 by ring; apply sqrt_1).
  assert (a : angle (vx 0) (vy 0) = PI) by (unfold angle; rewrite n1; destruct Req_EM_T; trivial; lra).
  refine (H 1 2 vx vy (fun t => nrm (vx t) (vy t)) (fun t => angle (vx t) (vy t)) _ _ M (fun t _ => conj (nrm_pos _ _) (angle_polar _ _)) a 0 _); try lra.
  unfold eq20_stop_time. rewrite n1, a, cos_PI. lra.
Qed.
Lemma s21_small_friction_aligns__occurs : ltac:(occurs s21_small_friction_aligns).
Proof. intros H. start 1 1. refine (H 1 1 vx vy v theta _ _ _ M P _); unfold s21_keeps_moving_sides_1, s21_keeps_moving_sides_2; lra. Qed.
Lemma s21_small_friction_aligns__excepted__occurs : ltac:(occurs s21_small_friction_aligns__excepted).
Proof.
  intros H. destruct (pull_has_a_motion 1 1 1 PI) as (vx & vy & M & e1 & e2); try lra. unfold eq4_velocity_1, eq4_velocity_2 in *. rewrite cos_PI, sin_PI in *.
  assert (n1 : nrm (vx 0) (vy 0) = 1) by (unfold nrm; rewrite e1, e2; replace ((1 * -1) ^ 2 + (1 * 0) ^ 2) with 1 by ring; apply sqrt_1).
  assert (a : angle (vx 0) (vy 0) = PI) by (unfold angle; rewrite n1; destruct Req_EM_T; trivial; lra).
  refine (H 1 vx vy (fun t => nrm (vx t) (vy t)) (fun t => angle (vx t) (vy t)) _ M (fun t _ => conj (nrm_pos _ _) (angle_polar _ _)) (or_intror a) 1 _); try lra.
Qed.
(* from rest *)
Lemma s21_friction_cannot_hold__occurs : ltac:(occurs s21_friction_cannot_hold).
Proof.
  intros H. destruct (pull_has_a_motion 1 (1 / 2) 0 0) as (vx & vy & M & e1 & e2); try lra. unfold eq4_velocity_1, eq4_velocity_2 in *.
  refine (H 1 (1 / 2) vx vy _ _ _ M 0 1 _ _); unfold s21_cannot_hold_sides_1, s21_cannot_hold_sides_2; try lra. rewrite e1, e2, !Rmult_0_l. apply nrm_0.
Qed.
Lemma s21_along_acceleration__occurs : ltac:(occurs s21_along_acceleration).
Proof.
  intros H. assert (n1 : nrm (-1) 0 = 1) by (unfold nrm; replace ((-1) ^ 2 + 0 ^ 2) with 1 by ring; apply sqrt_1).
  destruct (plane_has_a_motion 1 (fun _ => -1) (fun _ => 0) 0 1) as (vx & vy & M & e1 & e2). lra. intros; split; cont.
  refine (H 1 (-1) 0 vx vy _ _ M _); rewrite n1; try lra. right. rewrite e1, e2. destruct (abs_nrm 0 1) as [_ b]. rewrite Rabs_pos_eq in b; lra.
Qed.
Lemma s21_incline__occurs : exists wx wy wz, on_incline (1 / 2) 1 (PI / 4) wx wy wz /\ wy 0 = 1.
Proof.
  pose proof PI_RGT_0. assert (b : 0 < PI / 4 < PI / 2) by lra. destruct (s21_incline (1 / 2) 1 (PI / 4) Rlt_0_1 b) as [_ I].
  assert (s0 : 0 < 1 * sin (PI / 4)) by (rewrite Rmult_1_l; apply sin_gt_0; lra). assert (c0 : 0 < cos (PI / 4)) by (apply cos_gt_0; lra).
  destruct (across_start (1 * sin (PI / 4)) (eq5_lambda (1 / 2) (1 * cos (PI / 4)) (1 * sin (PI / 4)))) as (vx & vy & v & theta & M & _ & _ & _ & _ & y0 & _); trivial.
  { unfold eq5_lambda. apply Rmult_le_pos; [ | left; now apply Rinv_0_lt_compat ]. lra. } eexists. eexists. eexists. split. exact (I vx vy M). exact y0.
Qed.
Lemma s21_incline_only_constant__occurs : ltac:(occurs s21_incline_only_constant).
Proof.
  intros H. refine (H 1 1 (fun _ => 1) (fun _ => 0) 1 0 _ _ _ (fun _ _ M => M)); try lra. intros; split; cont.
Qed.
