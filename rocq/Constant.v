(* Section 2.1, the plane is pulled with the constant acceleration (-A, 0), lambda = mu g / A: (6) to (20) and what is said beside them,
   of every motion.
   pulled A lambda vx vy: a motion under this pull (Constant/Slip.v);
   polar vx vy v theta: v and theta are its speed and angle, (4) (Constant/Angle.v). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
From Slipbook.General Require Import Contraction Exists Straight.
From Slipbook.Constant Require Export Slip Angle.
Import Continuous.
Open Scope R_scope.

(* Every start has a motion: at rest, at any angle, for every lambda. *)
Theorem pull_has_a_motion A lam v0 theta0 : 0 < A -> 0 <= lam -> 0 <= v0 -> - PI < theta0 <= PI ->
  exists vx vy v theta, pulled A lam vx vy /\ polar vx vy v theta /\ v 0 = v0 /\ theta 0 = theta0.
Proof.
  intros hA hl h0 ht. destruct (plane_has_a_motion (A * lam) (fun _ => eq3_acceleration_1 A) (fun _ => eq3_acceleration_2 A) (eq4_velocity_1 v0
  theta0) (eq4_velocity_2 v0 theta0))
    as (vx & vy & M & e1 & e2). now apply hk. intros; split; cont. assert (n0 : nrm (vx 0) (vy 0) = v0).
  { rewrite e1, e2. unfold eq4_velocity_1, eq4_velocity_2. rewrite nrm_scale by trivial. unfold nrm. rewrite unit_circle, sqrt_1. ring. }
  exists vx, vy, (fun t => nrm (vx t) (vy t)), (fun t => if Req_EM_T t 0 then theta0 else direction_of (vx t) (vy t)). split; trivial.
  split; [ | split; [ exact n0 | now destruct Req_EM_T ] ].
  intros t Ht. split. apply nrm_pos. destruct Req_EM_T as [-> | _]; [ now rewrite n0 | apply angle_polar ].
Qed.

Section Motions.
Variables (A lam : R) (vx vy v theta : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : pulled A lam vx vy.
Hypothesis P : polar vx vy v theta.
Notation slips_until t := (forall s, 0 <= s <= t -> 0 < v s).
Let V := polar_speed vx vy v theta P.
Lemma polar_at t : 0 <= t -> 0 <= v t /\ - PI < theta t <= PI /\ vx t = v t * cos (theta t) /\ vy t = v t * sin (theta t).
Proof. apply P. Qed.
Lemma polar_rates t : 0 <= t -> 0 < v t -> rder (fun s => eq4_velocity_1 (v s) (theta s)) t (eq6_vx_rate lam A (theta t)) /\
  rder (fun s => eq4_velocity_2 (v s) (theta s)) t (eq7_vy_rate lam A (theta t)) /\ rder v t (A * (cos (theta t) - lam)).
Proof.
  intros Ht p. destruct (polar_at t Ht) as (_ & _ & ex & ey). destruct (pull_rates A lam vx vy v hA hl M V t Ht ltac:(lra)) as (X & Y & S).
  rewrite ex in X, S. rewrite ey in Y.
  split; [ apply (rder_ext vx); [ intros; apply P; lra | ] | split; [ apply (rder_ext vy); [ intros; apply P; lra | ] | ] ]; (eapply rder_eq;
  [ eassumption | unfold eq6_vx_rate, eq7_vy_rate; field; lra ]).
Qed.

(* (6), (7): while it slips *)
Theorem eq_6 t : 0 <= t -> 0 < v t -> rder (fun s => eq4_velocity_1 (v s) (theta s)) t (eq6_vx_rate lam A (theta t)).
Proof. apply polar_rates. Qed.
Theorem eq_7 t : 0 <= t -> 0 < v t -> rder (fun s => eq4_velocity_2 (v s) (theta s)) t (eq7_vy_rate lam A (theta t)).
Proof. apply polar_rates. Qed.
(* (8): the rates p and q of the two components of the velocity stand in the printed ratio; q is 0 where lambda cos theta = 1 only
   (for lambda = 1 that is theta = 0, where p is 0, too; for lambda > 1 the path is upright there). *)
Theorem eq_8 t : 0 <= t -> 0 < v t -> exists p q, rder (fun s => eq4_velocity_2 (v s) (theta s)) t p /\ rder (fun s => eq4_velocity_1 (v s) (theta
  s)) t q /\
  (q = 0 <-> lam * cos (theta t) = 1) /\ (q <> 0 -> p / q = eq8_hodograph_slope lam (theta t)).
Proof.
  intros Ht n. destruct (polar_rates t Ht n) as (X & Y & _). exists (eq7_vy_rate lam A (theta t)), (eq6_vx_rate lam A (theta t)).
  repeat split; trivial; unfold eq7_vy_rate, eq6_vx_rate, eq8_hodograph_slope.
  1, 2: intros e; nra. intros e. field. split; [ | lra ]. intros z. apply e. rewrite z. ring.
Qed.
(* (9): at an angle, the relative rate of the speed is the printed multiple of the rate w of the angle *)
Theorem eq_9 t : 0 <= t -> 0 < v t -> theta t <> 0 -> theta t <> PI ->
  exists w d, rder theta t w /\ rder v t d /\ w <> 0 /\ d / v t = eq9_log_speed_rate lam (theta t) * w.
Proof.
  intros Ht p n0 n1. destruct (polar_at t Ht) as (_ & b & _). pose proof (sin_no _ b n0 n1) as s0.
  exists (- (A * sin (theta t) / v t)), (A * (cos (theta t) - lam)). split; [ | split; [ | split ] ].
  - now apply (angle_rate A lam vx vy v theta).
  - now apply polar_rates.
  - intros z. apply s0. apply (Rmult_eq_reg_l (A / v t)). lra. apply Rgt_not_eq. now apply Rdiv_lt_0_compat.
  - unfold eq9_log_speed_rate. field. split; lra.
Qed.
(* while it slips, from a start at an angle, it stays on one side of the x-axis *)
Lemma one_side t : 0 <= t -> slips_until t -> theta 0 <> 0 -> theta 0 <> PI ->
  0 < v t + vx t /\ 0 < sin (theta t) * sin (theta 0) /\ 0 < tan (theta t / 2) / tan (theta 0 / 2) /\ v t * sin (theta t) / (v 0 * sin (theta 0)) =
  Rpower (tan (theta t / 2) / tan (theta 0 / 2)) lam.
Proof.
  intros Ht H n0 n1. pose proof (H t ltac:(lra)) as pt. pose proof (H 0 ltac:(lra)) as p0. destruct (polar_at 0 (Rle_refl 0)) as (_ & b & _ & y0).
  destruct (polar_at t Ht) as (_ & _ & _ & y).
  pose proof (sin_no _ b n0 n1) as s0. assert (Y0 : vy 0 <> 0) by (rewrite y0; apply Rmult_integral_contrapositive; lra).
  destruct (power_law A lam vx vy v hA hl M V t Ht) as (_ & C & q & r & e & _); trivial. { intros s Hs. specialize (H s Hs). lra. }
  destruct (angle_is vx vy v theta P t Ht C) as (_ & nt & _). destruct (plus_is vx vy v theta P t Ht pt nt) as [_ ->].
  destruct (plus_is vx vy v theta P 0 (Rle_refl 0) p0 n1) as [_ ->].
  repeat split; trivial; rewrite <- ?y, <- ?y0; trivial. rewrite y, y0 in q. apply (Rmult_lt_reg_l (v t * v 0)). now apply Rmult_lt_0_compat. lra.
Qed.
(* (11): from every start at an angle, above or below the x-axis, as long as it slips; the power is one of a positive number *)
Theorem eq_11 t : 0 <= t -> slips_until t -> theta 0 <> 0 -> theta 0 <> PI ->
  0 < tan (theta t / 2) / tan (theta 0 / 2) /\ v t = eq11_speed lam (v 0) (theta 0) (theta t).
Proof.
  intros Ht H n0 n1. destruct (one_side t Ht H n0 n1) as (_ & s & r & e). split; trivial. pose proof (H 0 ltac:(lra)). unfold eq11_speed.
  rewrite <- e. field. repeat split; try lra; intros z; rewrite z in s; lra.
Qed.
(* (10): from every start with 0 < theta < PI the value does not change as long as it slips (and the angle stays between 0 and PI) *)
Theorem eq_10 t : 0 <= t -> slips_until t -> 0 < theta 0 < PI -> 0 < theta t < PI /\ eq10_invariant lam (v t) (theta t) = eq10_invariant lam (v 0)
  (theta 0).
Proof.
  intros Ht H h0. destruct (one_side t Ht H ltac:(lra) ltac:(lra)) as (_ & s & _ & e). pose proof (H 0 ltac:(lra)).
  pose proof (sin_gt_0 (theta 0) ltac:(lra) ltac:(lra)) as s0.
  assert (h : 0 < theta t < PI) by (apply sin_up; [ apply P, Ht | nra ]). split; trivial.
  pose proof (tan_gt_0 (theta 0 / 2) ltac:(lra) ltac:(lra)) as t0. pose proof (tan_gt_0 (theta t / 2) ltac:(lra) ltac:(lra)) as tt.
  unfold eq10_invariant, Rpower in *. rewrite (ln_div (tan (theta t / 2))) in e by trivial. set (a := ln (tan (theta t / 2))) in *.
  set (b := ln (tan (theta 0 / 2))) in *.
  assert (q : v t * sin (theta t) = exp (lam * (a - b)) * (v 0 * sin (theta 0))) by (rewrite <- e; field; lra).
  rewrite q, (Rmult_comm (exp _)), Rmult_assoc, <- exp_plus. f_equal. f_equal. ring.
Qed.
(* (12): along the motion, with x4 = d (tan (theta/2))^lambda / d theta and the rate w of the angle, A is the printed rate times w *)
Theorem eq_12 t : 0 < lam -> 0 <= t -> slips_until t -> 0 < theta 0 < PI -> exists x4 w,
  is_derive (fun th => Rpower (tan (th / 2)) lam) (theta t) x4 /\
  rder theta t w /\ A = eq12_time_rate lam (v 0) (theta 0) (theta t) x4 * w.
Proof.
  intros l0 Ht H h0. destruct (eq_10 t Ht H h0) as [h e]. pose proof (H t ltac:(lra)) as pt.
  pose proof (sin_gt_0 (theta t) ltac:(lra) ltac:(lra)) as st.
  exists (lam * Rpower (tan (theta t / 2)) lam / sin (theta t)), (- (A * sin (theta t) / v t)). split; [ | split ].
  - pose proof (tan_gt_0 (theta t / 2) ltac:(lra) ltac:(lra)) as tt. assert (ch : 0 < cos (theta t / 2)) by (apply cos_gt_0; lra).
    assert (sh : 0 < sin (theta t / 2)) by (apply sin_gt_0; lra).
    replace (sin (theta t)) with (2 * sin (theta t / 2) * cos (theta t / 2)) by (rewrite <- sin_2a; f_equal; field).
    pose proof (unit_circle (theta t / 2)) as q.
    unfold Rpower, tan in *. auto_derive. repeat split; lra. set (c := cos (theta t / 2)) in *. set (s := sin (theta t / 2)) in *.
    change (cos (theta t * / 2)) with c. change (sin (theta t * / 2)) with s. change (s * / c) with (s / c). set (x := exp _).
    field_simplify_eq; [ | lra ]. transitivity (lam * x * (c ^ 2 + s ^ 2)); [ | rewrite q ]; ring.
  - apply (angle_rate A lam vx vy v theta); trivial; lra.
  - unfold eq12_time_rate, eq10_invariant in *. rewrite !Rpower_Ropp in e. unfold Rdiv in *. rewrite <- e. field. repeat split; try lra.
    apply Rgt_not_eq, exp_pos.
Qed.
(* (14): from every start, as long as it slips *)
Lemma moved_polar t : 0 <= t -> (forall s, 0 <= s < t -> 0 < v s) -> v t * (lam + cos (theta t)) = (1 - lam ^ 2) * A * t + v 0 * (lam + cos (theta
  0)).
Proof.
  intros Ht H. pose proof (moved A lam vx vy v hA hl M V t Ht ltac:(intros s Hs; specialize (H s Hs); lra)) as e.
  destruct (polar_at t Ht) as (_ & _ & ex & _). destruct (polar_at 0 (Rle_refl 0)) as (_ & _ & e0 & _). lra.
Qed.
Theorem eq_14 t : 0 <= t -> (forall s, 0 <= s < t -> 0 < v s) -> lam + cos (theta t) <> 0 -> v t = eq14_speed_at_time lam A (v 0) (theta 0) (theta t)
  t.
Proof. intros Ht H n. unfold eq14_speed_at_time. rewrite <- moved_polar by trivial. field. trivial. Qed.
(* (13): from every start at an angle, as long as it slips *)
Theorem eq_13 t : 0 <= t -> slips_until t -> theta 0 <> 0 -> theta 0 <> PI -> lam <> 1 -> lam + cos (theta 0) <> 0 ->
  t = eq13_time lam A (v 0) (theta 0) (theta t).
Proof.
  intros Ht H n0 n1 h1 h0. destruct (eq_11 t Ht H n0 n1) as [_ E]. destruct (one_side t Ht H n0 n1) as (_ & s & _). pose proof (H 0 ltac:(lra)).
  pose proof (moved_polar t Ht ltac:(intros; apply H; lra)) as e.
  unfold eq13_time, eq11_speed in *. set (X := Rpower _ lam) in *. assert (l2 : 1 - lam ^ 2 <> 0) by nra.
  apply (Rmult_eq_reg_l ((1 - lam ^ 2) * A)); [ | apply Rmult_integral_contrapositive; lra ].
  transitivity (v t * (lam + cos (theta t)) - v 0 * (lam + cos (theta 0))). lra. rewrite E at 1. field. repeat split; trivial; try lra. intros z.
  rewrite z in s. lra.
Qed.
(* lambda <= 1: a start that is not straight against the pull never stops *)
Lemma goes t : lam <= 1 -> 0 < v 0 -> theta 0 <> PI -> 0 <= t -> 0 < v t.
Proof.
  intros h p n Ht. destruct (plus_is vx vy v theta P 0 (Rle_refl 0) p n) as [C _]. pose proof (plus_rises A lam vx vy v hA hl M V 0 t h ltac:(lra)).
  pose proof (sides vx vy v V t Ht). lra.
Qed.
(* straight against the pull it stays so as long as it slips *)
Lemma straight t : 1 <= lam -> 0 <= t -> slips_until t -> theta 0 = PI -> theta t = PI.
Proof.
  intros h Ht H e. destruct (polar_at 0 (Rle_refl 0)) as (_ & _ & e0 & _). rewrite e, cos_PI in e0.
  destruct (Req_dec (theta t) PI) as [z | n]; trivial. exfalso.
  destruct (plus_is vx vy v theta P t Ht (H t ltac:(lra)) n) as [C _]. assert (v t + vx t <= v 0 + vx 0); [ | lra ].
  apply (rder_decr (fun t => v t + vx t)); trivial; intros s Hs. pose proof (cv A lam vx vy v M V s ltac:(lra)). cont.
  pose proof (H s ltac:(lra)). destruct (pull_rates A lam vx vy v hA hl M V s ltac:(lra) ltac:(lra)) as (X & _ & S). eexists. split. rds. cbv beta.
  destruct (sides vx vy v V s) as (a & _). lra.
  match goal with |- ?g <= 0 => replace g with (- ((lam - 1) * A * ((v s + vx s) / v s))) by (field; lra) end.
  assert (0 <= (v s + vx s) / v s) by (apply Rdiv_le_0_compat; lra). assert (0 <= (lam - 1) * A) by (apply Rmult_le_pos; lra). nra.
Qed.

(* (17) to (19), lambda = 1: from every start, at all times, and at large times *)
Lemma critical : lam = 1 -> pulled A 1 vx vy. Proof. now intros <-. Qed.
Theorem eq_17 : lam = 1 -> forall t, 0 <= t -> eq17_invariant (v t) (theta t) = eq17_invariant (v 0) (theta 0).
Proof.
  intros h t Ht. pose proof (plus_stays A vx vy v hA (critical h) V t Ht) as e. destruct (polar_at t Ht) as (_ & _ & ex & _).
  destruct (polar_at 0 (Rle_refl 0)) as (_ & _ & e0 & _).
  rewrite ex, e0 in e. unfold eq17_invariant. lra.
Qed.
(* lambda = 1: the velocity tends to the constant of (18) and (19). *)
Theorem s21_critical_terminal_velocity : lam = 1 -> is_lim vx p_infty (eq18_vx_limit (v 0) (theta 0)) /\ is_lim vy p_infty eq19_vy_limit.
Proof.
  intros h. destruct (critical_late A vx vy v hA (critical h) V) as [L K]. split; trivial. destruct (polar_at 0 (Rle_refl 0)) as (_ & _ & e0 & _).
  rewrite e0 in K. unfold eq18_vx_limit.
  rewrite Rmult_plus_distr_l, Rmult_1_r. exact K.
Qed.
Theorem eq_18 : lam = 1 -> is_lim vx p_infty (eq18_vx_limit (v 0) (theta 0)).
Proof. apply s21_critical_terminal_velocity. Qed.
Theorem eq_19 : lam = 1 -> is_lim vy p_infty eq19_vy_limit.
Proof. apply s21_critical_terminal_velocity. Qed.

(* (20), lambda > 1: from every start the particle slips before T, and rests from T on. *)
Theorem eq_20 : 1 < lam -> let T := eq20_stop_time lam A (v 0) (theta 0) in 0 <= T /\ (forall t, 0 <= t < T -> v t <> 0) /\ forall t,
  T <= t -> v t = 0.
Proof.
  intros h T. pose proof (hd A lam hA h) as d. destruct (polar_at 0 (Rle_refl 0)) as (p & _ & e0 & _). pose proof (COS_bound (theta 0)).
  assert (eT : A * (lam ^ 2 - 1) * T = lam * v 0 + vx 0) by (unfold T, eq20_stop_time; rewrite e0; field; nra).
  assert (T0 : 0 <= T) by (apply Rdiv_le_0_compat; [ apply Rmult_le_pos; lra | exact d ]).
  split; trivial. split; intros t Ht; [ apply (slip_before A lam vx vy v hA hl M V t);
  [ lra | ] | apply (rest_after A lam vx vy v hA hl M V ltac:(lra) t); [ lra | lra | ] ]; rewrite <- eT;
    [ apply Rmult_lt_compat_l | apply Rmult_le_compat_l ]; lra.
Qed.
(* lambda > 1: it comes to rest at the time T of (20), and the angle tends to 0 as t -> T from below, but for a start at theta = PI. *)
Theorem s21_large_friction_stops : 1 < lam -> let T := eq20_stop_time lam A (v 0) (theta 0) in (forall t, 0 <= t < T -> v t <> 0) /\ (forall t,
  T <= t -> v t = 0) /\
  (theta 0 <> PI -> forall e, 0 < e -> exists d, 0 < d /\ forall t, 0 <= t < T -> T - d < t -> Rabs (theta t - s21_late_angle) < e).
Proof.
  intros h T. destruct (eq_20 h) as (T0 & S & R). fold T in T0, S, R. split; trivial. split; trivial. intros n e He. unfold s21_late_angle.
  destruct (polar_at 0 (Rle_refl 0)) as ([p | z] & _ & e0 & _).
  2: { exists 1. split. lra. intros t Ht. exfalso. apply (S 0); [ lra | now symmetry ]. }
  destruct (plus_is vx vy v theta P 0 (Rle_refl 0) p n) as [C0 _]. destruct (angle_small vx vy v theta P e He) as (q & q0 & Hq).
  destruct (turns_before_stop A lam vx vy v hA hl M V h C0 q q0) as (d & d0 & Hd). pose proof (hd A lam hA h) as k.
  exists (d / (A * (lam ^ 2 - 1))). split. now apply Rdiv_lt_0_compat.
  intros t Ht Hs. rewrite Rminus_0_r. destruct (Hd t) as [x y]; [ lra | now apply S | | apply Hq; trivial; lra ].
  rewrite (moved_to A lam vx vy v hA hl M V ltac:(lra) t) by (try apply S; lra). assert (Hs' : (T - t) < d / (A * (lam ^ 2 - 1))) by lra.
  apply Rlt_div_r in Hs'; trivial.
  assert (eT : A * (lam ^ 2 - 1) * T = lam * v 0 + vx 0) by (unfold T, eq20_stop_time; rewrite e0; field; nra). lra.
Qed.
(* The excepted start, straight against the pull: the angle stays PI until the stop. *)
Theorem s21_large_friction_stops__at_PI : 1 < lam -> theta 0 = PI -> forall t, 0 <= t < eq20_stop_time lam A (v 0) (theta 0) -> theta t = PI.
Proof.
  intros h e t Ht. destruct (eq_20 h) as (_ & S & _). apply straight; trivial; try lra. intros s Hs.
  destruct (polar_at s ltac:(lra)) as ([p | z] & _); trivial. exfalso. apply (S s); [ lra | now symmetry ].
Qed.

(* lambda <= 1, but for lambda = 1 from rest or at theta = PI: from some time on the particle slides, and its angle tends to 0. *)
Theorem s21_small_friction_aligns : s21_keeps_moving_sides_1 lam <= s21_keeps_moving_sides_2 lam -> ~ (lam = 1 /\ (v 0 = 0 \/ theta 0 = PI)) ->
  (exists T, forall t, T <= t -> 0 < v t) /\ is_lim theta p_infty s21_late_angle.
Proof.
  unfold s21_keeps_moving_sides_1, s21_keeps_moving_sides_2, s21_late_angle. intros l1 X. assert (h : lam < 1 \/ 0 < v 0 + vx 0).
  { destruct l1 as [l1 | l1]; [ now left | right ]. destruct (polar_at 0 (Rle_refl 0)) as ([p | z] & _).
    apply (plus_is vx vy v theta P); trivial; [ lra | tauto ]. exfalso. apply X. split; trivial. now left. }
  pose proof (turns_forward A lam vx vy v hA (conj hl l1) M V h) as G. split.
  - destruct (G 1 Rlt_0_1) as (T & T0 & HT). exists T. intros t Ht. destruct (HT t Ht). pose proof (sides vx vy v V t ltac:(lra)). lra.
  - apply lim_zero. intros e He. destruct (angle_small vx vy v theta P e He) as (q & q0 & Hq). destruct (G q q0) as (T & T0 & HT). exists T.
    intros t Ht. destruct (HT t Ht). left. apply Hq; trivial. lra.
Qed.
(* The excepted starts: with lambda = 1 the particle stops at v0 / (2 A), and rests. *)
Theorem s21_small_friction_aligns__excepted : lam = 1 -> v 0 = 0 \/ theta 0 = PI -> forall t, v 0 / (2 * A) <= t -> v t = 0.
Proof.
  intros h X t Ht. destruct (polar_at 0 (Rle_refl 0)) as (p & _ & e0 & _). assert (0 <= v 0 / (2 * A)) by (apply Rdiv_le_0_compat; lra).
  apply (straight_stops A vx vy v hA (critical h) V); try lra. rewrite e0. destruct X as [-> | ->]; rewrite ?cos_PI; ring.
Qed.
(* lambda < 1: no rest lasts, however short; a particle at rest moves at once, and for ever. *)
Theorem s21_friction_cannot_hold : s21_cannot_hold_sides_1 lam < s21_cannot_hold_sides_2 lam -> forall s t, 0 <= s < t -> v s = 0 -> v t <> 0.
Proof.
  unfold s21_cannot_hold_sides_1, s21_cannot_hold_sides_2. intros l1 s t Hst e z. pose proof (forward_grows A lam vx vy v hA hl M V s t ltac:(lra)).
  pose proof (sides vx vy v V s ltac:(lra)).
  pose proof (sides vx vy v V t ltac:(lra)). assert (0 < A * (1 - lam) * (t - s)) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.

(* Figure 1, a start at an angle: its velocity runs along the curve of (11), from theta0 through every angle between theta0 and 0, and no other;
   for lambda <= 1, panel (a), it
   never stops, for lambda > 1, panel (b), it ends at rest. *)
Theorem fig_1 : 0 < v 0 -> theta 0 <> 0 -> theta 0 <> PI ->
  (forall t, 0 <= t -> slips_until t -> 0 < theta t / theta 0 <= 1 /\ v t = eq11_speed lam (v 0) (theta 0) (theta t)) /\
  (forall c, 0 < c <= 1 -> exists t, 0 <= t /\ slips_until t /\ theta t = c * theta 0) /\
  (s21_keeps_moving_sides_1 lam <= s21_keeps_moving_sides_2 lam <-> forall t, 0 <= t -> 0 < v t) /\
  (s21_keeps_moving_sides_2 lam < s21_keeps_moving_sides_1 lam <-> exists T, forall t, T <= t -> v t = 0).
Proof.
  unfold s21_keeps_moving_sides_1, s21_keeps_moving_sides_2. intros p n0 n1. set (a := theta 0) in *.
  destruct (polar_at 0 (Rle_refl 0)) as (_ & b0 & _). fold a in b0.
  assert (K : forall t, 0 <= t -> slips_until t -> 0 < v t + vx t /\ 0 < theta t * / a /\ 0 <= sin (theta t) * / a).
  { intros t Ht H. destruct (one_side t Ht H n0 n1) as (C & s & _). split; trivial. fold a in s. destruct (polar_at t Ht) as (_ & b & _).
    destruct (angle_is vx vy v theta P t Ht C) as (_ & nt & _).
    assert (S : forall x, - PI < x < PI -> 0 < x /\ 0 < sin x \/ x < 0 /\ sin x < 0 \/ sin x = 0).
    { intros x Hx. destruct (Rtotal_order x 0) as [k | [-> | k]]; [ right; left; split; trivial; apply sin_lt_0_var; lra | right; right;
      apply sin_0 | left; split; trivial; apply sin_gt_0; lra ]. }
    destruct (S a ltac:(lra)) as [[k1 k2] | [[k1 k2] | z]]; [ | | rewrite z in s; lra ];
    [ pose proof (Rinv_0_lt_compat a k1) | pose proof (Rinv_lt_0_compat a k1) ];
      destruct (S (theta t) ltac:(lra)) as [[k3 k4] | [[k3 k4] | z]]; try (rewrite z in s; lra); split; nra. }
  assert (Q : forall t, 0 <= t -> slips_until t -> rder (fun s => theta s * / a) t (- (A * sin (theta t) / v t) * / a) /\ (0 < t -> continuity_pt
  (fun s => theta s * / a) t)).
  { intros t Ht H. destruct (K t Ht H) as (C & _). destruct (angle_is vx vy v theta P t Ht C) as (v0 & nt & _).
    pose proof (angle_rate A lam vx vy v theta hA hl M P t Ht v0 nt). split.
    eapply rder_eq. rd. ring. intros t0. pose proof (angle_cont A lam vx vy v theta M P t t0 C). cont. }
  assert (E : (lam <= 1 -> forall t, 0 <= t -> 0 < v t) /\ (1 < lam -> exists T, forall t, T <= t -> v t = 0)).
  { split. intros; now apply goes. intros h. exists (eq20_stop_time lam A (v 0) a). apply (eq_20 h). }
  assert (F : forall T, (forall t, T <= t -> v t = 0) -> ~ forall t, 0 <= t -> 0 < v t) by (intros T R G; specialize (R (Rmax 0 T) (Rmax_r _ _));
  specialize (G (Rmax 0 T) (Rmax_l _ _)); lra).
  split; [ | split; [ | split; split ] ].
  - intros t Ht H. split; [ split; [ apply K; trivial | ] | apply eq_11; trivial ].
    assert (theta t * / a <= theta 0 * / a); [ | fold a in H0; rewrite Rinv_r in H0; trivial; unfold Rdiv; lra ].
    apply (rder_decr (fun s => theta s * / a)); trivial; intros s Hs; destruct (Q s) as [D C]; try (intros; apply H; lra); try lra. apply C; lra.
    eexists. split. exact D.
    destruct (K s) as (_ & _ & k); try (intros; apply H; lra); try lra. pose proof (H s ltac:(lra)).
    assert (0 <= A / v s) by (apply Rdiv_le_0_compat; lra). unfold Rdiv in *. nra.
  - intros c Hc. assert (Z : exists t, 0 <= t /\ slips_until t /\ Rabs (theta t) < c * Rabs a).
    { assert (ca : 0 < c * Rabs a) by (apply Rmult_lt_0_compat; [ lra | now apply Rabs_pos_lt ]). destruct (Rle_lt_dec lam 1) as [h | h].
      - destruct s21_small_friction_aligns as [_ L]; [ exact h | fold a; lra | ]. destruct (lim_near _ _ _ L ca) as (T & T0 & HT). exists T.
        split; trivial. split. intros; apply E; lra.
        specialize (HT T (Rle_refl T)). unfold s21_late_angle in HT. apply Rabs_def1; lra.
      - destruct (s21_large_friction_stops h) as (S & _ & L). destruct (L n1 _ ca) as (d & d0 & Hd). fold a in S, Hd.
        destruct (eq_20 h) as (T0 & _ & R). fold a in T0, R. set (T := eq20_stop_time lam A (v 0) a) in *.
        assert (T1 : 0 < T) by (destruct T0 as [ | z]; trivial; exfalso; specialize (R 0 ltac:(lra)); lra). set (m := Rmin d T).
        assert (0 < m) by now apply Rmin_pos. pose proof (Rmin_l d T). pose proof (Rmin_r d T). fold m in H0, H1.
        exists (T - m / 2). split. lra. split. { intros s Hs. specialize (S s ltac:(lra)).
        destruct (polar_at s ltac:(lra)) as ([ | z] & _); trivial. exfalso. now apply S. }
        specialize (Hd (T - m / 2) ltac:(lra) ltac:(lra)). unfold s21_late_angle in Hd. now rewrite Rminus_0_r in Hd. }
    destruct Z as (t & Ht & H & small). apply Classical_Prop.NNPP. intros no. assert (no' : forall s, 0 <= s <= t -> theta s * / a - c <> 0).
    { intros s Hs z. apply no. exists s. split. lra. split. intros; apply H; lra. replace c with (theta s * / a) by lra. field. trivial. }
    assert (0 < theta t * / a - c).
    { apply (keeps_sign (fun s => theta s * / a - c) (- (A * sin (theta 0) / v 0) * / a)); trivial.
      - intros s Hs. destruct (Q s) as [_ C]; [ lra | intros; apply H; lra | ].
        apply (continuity_pt_minus (fun s => theta s * / a)); [ apply C; lra | cont ].
      - destruct (Q 0 (Rle_refl 0)) as [D _]. intros; apply H; lra. eapply rder_eq. rds. ring.
      - fold a. rewrite Rinv_r by trivial. specialize (no' 0 ltac:(lra)). fold a in no'. rewrite Rinv_r in no' by trivial. lra. }
    pose proof (Rabs_pos_lt a n0). destruct (K t Ht H) as (_ & k & _). assert (Rabs (theta t) = theta t * / a * Rabs a).
    { rewrite <- (Rabs_pos_eq (theta t * / a)) at 1 by lra. rewrite <- Rabs_mult. f_equal. field. trivial. } nra.
  - apply E.
  - intros G. apply Rnot_lt_le. intros h. destruct (proj2 E h) as [T R]. exact (F T R G).
  - apply E.
  - intros [T R]. apply Rnot_le_lt. intros h. exact (F T R (proj1 E h)).
Qed.
End Motions.

(* The printed lambda <= 1 fails at lambda = 1: rest is a motion exactly when lambda >= 1. *)
Theorem s21_friction_cannot_hold__printed A lam : 0 < A -> 0 <= lam -> (pulled A lam (fun _ => 0) (fun _ => 0) <-> 1 <= lam).
Proof.
  intros hA hl. split.
  - intros M. apply Rnot_lt_le. intros l1. apply (s21_friction_cannot_hold A lam _ _ (fun _ => 0) (fun _ => 0) hA hl M) with (s := 0) (t := 1);
    trivial; try lra.
    pose proof PI_RGT_0. intros t _. unfold eq4_velocity_1, eq4_velocity_2. repeat split; lra.
  - intros l1. split. 1, 2: intros; cont. intros t Ht. exists (- A), 0. unfold coulomb, eq3_acceleration_1, eq3_acceleration_2. cbv beta.
    rewrite nrm_0. split.
    split; [ | ring ]. assert (A * 1 <= A * lam) by (apply Rmult_le_compat_l; lra). nra. split; (eapply rder_eq; [ rd | ring ]).
Qed.
(* (15), (16): without friction *)
Lemma free A vx vy : pulled A 0 vx vy -> forall t, 0 <= t -> vx t = vx 0 + A * t /\ vy t = vy 0.
Proof.
  intros M t Ht. assert (D : forall s, 0 <= s -> rder vx s A /\ rder vy s 0).
  { intros s Hs. destruct (m_law _ _ _ _ _ M s Hs) as (fx & fy & [B _] & X & Y). unfold eq3_acceleration_1, eq3_acceleration_2 in *.
    destruct (sq_sum fx fy) as [-> ->]. lra. split; (eapply rder_eq; [ eassumption | ring ]). }
  split; [ enough (vx t - A * t = vx 0 - A * 0) by lra; apply (rder_const (fun t => vx t - A * t)) | apply rder_const ]; trivial; intros s Hs;
  try cont; destruct (D s ltac:(lra)); trivial. eapply rder_eq. rd. ring.
Qed.
Theorem eq_15 A vx vy : pulled A 0 vx vy -> forall t, 0 <= t -> vx t = eq15_vx A (vx 0) t.
Proof. intros M t Ht. now apply (free A vx vy). Qed.
Theorem eq_16 A vx vy : pulled A 0 vx vy -> forall t, 0 <= t -> vy t = eq16_vy (vy 0).
Proof. intros M t Ht. now apply (free A vx vy). Qed.
(* Without friction vy stays, vx grows at the rate A; where vy is not 0 the path (rx, ry) is the printed parabola through the start,
   else it is straight. *)
Theorem s21_frictionless_parabola A vx vy rx ry : pulled A 0 vx vy -> (forall t, 0 < t -> continuity_pt rx t /\ continuity_pt ry t) ->
  (forall t, 0 <= t -> rder rx t (vx t) /\ rder ry t (vy t)) -> forall t, 0 <= t ->
  vy t = vy 0 /\ vx t = vx 0 + A * t /\ (vy 0 <> 0 -> rx t - rx 0 = s21_parabola A (vx 0) (vy 0) (ry t - ry 0)) /\ (vy 0 = 0 -> ry t = ry 0).
Proof.
  intros M C D t Ht. destruct (free A vx vy M t Ht) as [e1 e2]. split; trivial. split; trivial.
  assert (K : forall f v w a, (forall s, 0 < s -> continuity_pt f s) -> (forall s, 0 <= s -> rder f s (v s)) ->
    (forall s, 0 <= s -> v s = w + a * s) -> f t - f 0 = w * t + a * t ^ 2 * / 2).
  { intros f v w a Cf Df e. enough (f t - (w * t + a * t ^ 2 * / 2) = f 0 - (w * 0 + a * 0 ^ 2 * / 2)) by lra.
    apply (rder_const (fun t => f t - (w * t + a * t ^ 2 * / 2))); trivial; intros s Hs.
    - specialize (Cf s ltac:(lra)). cont.
    - specialize (Df s ltac:(lra)). eapply rder_eq. rd. rewrite e by lra. simpl. field. }
  rewrite (K rx vx (vx 0) A), (K ry vy (vy 0) 0); try apply C; try apply D; try (intros; destruct (free A vx vy M s); lra). unfold s21_parabola.
  split; [ intros n; field; exact n | intros z ]. rewrite z in *.
  pose proof (K ry vy 0 0 ltac:(apply C) ltac:(apply D) ltac:(intros; destruct (free A vx vy M s); lra)). lra.
Qed.


(* Friction k up to the constant acceleration (ax, ay) of the plane,
   but for k = |A| from rest or straight along A: the cosine of the angle between the velocity and A
   tends to -1. The particle slides against the plane's acceleration; the print, along it, is wrong. *)
Theorem s21_along_acceleration k ax ay vx vy : 0 <= k <= nrm ax ay -> 0 < nrm ax ay -> motion k (fun _ => ax) (fun _ => ay) vx vy ->
  (k < nrm ax ay \/ ax * vx 0 + ay * vy 0 < nrm ax ay * nrm (vx 0) (vy 0)) ->
  let cosine t := (ax * vx t + ay * vy t) / (nrm ax ay * nrm (vx t) (vy t)) in
  is_lim cosine p_infty right_constant_late_sense /\ ~ is_lim cosine p_infty s21_late_sense.
Proof.
  intros hk hA M h cosine. pose proof (nrm_sq ax ay) as ea. set (a := nrm ax ay) in *. set (ex := - ax / a). set (ey := - ay / a).
  assert (He : ex ^ 2 + ey ^ 2 = 1) by (transitivity ((ax ^ 2 + ay ^ 2) / a ^ 2); [ unfold ex, ey | rewrite <- ea ]; field; lra).
  set (ux t := ex * vx t + ey * vy t). set (uy t := ex * vy t - ey * vx t). set (v t := nrm (vx t) (vy t)). set (theta t := direction_of (ux t) (uy t)).
  assert (N : pulled a (k / a) ux uy).
  { unfold pulled. replace (a * (k / a)) with k by (field; lra).
    apply (motion_turned ex ey k (fun _ => ax) (fun _ => ay)); trivial; intros _; unfold eq3_acceleration_1, eq3_acceleration_2, ex, ey; [ | field;
    lra ].
    transitivity (- (ax ^ 2 + ay ^ 2) / a); [ rewrite <- ea | ]; field; lra. }
  assert (P : polar ux uy v theta).
  { intros t _. unfold v. rewrite <- (nrm_turned ex ey (vx t) (vy t) He). split; [ apply nrm_pos | apply angle_polar ]. }
  assert (eu : forall t, ax * vx t + ay * vy t = - (a * ux t)) by (intros t; unfold ux, ex, ey; field; lra).
  assert (l : 0 <= k / a <= 1) by (split; [ apply Rdiv_le_0_compat | apply Rle_div_l ]; lra).
  destruct (s21_small_friction_aligns a (k / a) ux uy v _ hA (proj1 l) N P) as [[T HT] L].
  { unfold s21_keeps_moving_sides_1, s21_keeps_moving_sides_2. apply l. }
  { intros [e c]. assert (k = a) by (rewrite <- (Rmult_1_l a), <- e; field; lra). destruct h as [h | h]; [ lra | ]. rewrite eu in h.
    fold (v 0) in h. destruct (P 0 (Rle_refl 0)) as (_ & _ & e0 & _).
    unfold eq4_velocity_1 in e0. destruct c as [c | c]; rewrite c in *; rewrite ?cos_PI in e0; rewrite e0 in h; lra. }
  assert (K : is_lim cosine p_infty (-1)).
  { apply (is_lim_ext_loc (fun t => - cos (theta t))).
    - exists (Rmax 0 T). intros t Ht. pose proof (Rmax_l 0 T). pose proof (Rmax_r 0 T). specialize (HT t ltac:(lra)).
      destruct (P t ltac:(lra)) as (_ & _ & e & _). unfold eq4_velocity_1 in e.
      unfold cosine. rewrite eu, e. fold (v t). field. lra.
    - replace (Finite (-1)) with (Finite ((fun x => - cos x) 0)) by (f_equal; cbv beta; rewrite cos_0; ring).
      apply (is_lim_comp_continuous _ (fun x => - cos x)); [ exact L | ].
      apply continuity_pt_filterlim. reg. }
  split. exact K. intros K'. apply is_lim_unique in K, K'. rewrite K in K'. unfold s21_late_sense in K'. injection K'. lra.
Qed.

(* A particle on an incline of slope beta at rest: weight g, normal force N along (sin beta, 0, cos beta), friction F in the slope,
   of size mu N at most and of
   power - mu N |w|, all by unit of mass; its velocity w = (wx, wy, wz) stays in the slope.
   «$(wx,wy,wz)$ is the velocity of a particle on an incline of slope $beta$ at rest, under the weight $g$, with friction $mu$» *)
Record on_incline mu g beta (wx wy wz : R -> R) : Prop := {
  incline_c : forall t, 0 < t -> continuity_pt wx t /\ continuity_pt wy t /\ continuity_pt wz t;
  incline_law : forall t, 0 <= t -> wx t * sin beta + wz t * cos beta = 0 /\ exists N Fx Fy Fz, 0 <= N /\ Fx * sin beta + Fz * cos beta = 0 /\
    Fx ^ 2 + Fy ^ 2 + Fz ^ 2 <= (mu * N) ^ 2 /\ Fx * wx t + Fy * wy t + Fz * wz t = - (mu * N) * sqrt (wx t ^ 2 + wy t ^ 2 + wz t ^ 2) /\
    rder wx t (N * sin beta + Fx) /\ rder wy t Fy /\ rder wz t (- g + N * cos beta + Fz) }.
(* The motions on an incline are those under the constant pull A = g sin beta with g cos beta in the place of g: seen down the slope and across it
   each is one,
   and each of these is one on the incline. *)
Theorem s21_incline mu g beta : 0 < g -> 0 < beta < PI / 2 ->
  let A := g * sin beta in let lam := eq5_lambda mu (g * cos beta) A in
  (forall wx wy wz, on_incline mu g beta wx wy wz -> pulled A lam (fun t => cos beta * wx t - sin beta * wz t) wy) /\
  (forall vx vy, pulled A lam vx vy -> on_incline mu g beta (fun t => cos beta * vx t) vy (fun t => - sin beta * vx t)).
Proof.
  intros hg hb A lam. assert (s0 : 0 < sin beta) by (apply sin_gt_0; lra). assert (c0 : 0 < cos beta) by (apply cos_gt_0; lra).
  pose proof (unit_circle beta) as q. rewrite Rplus_comm in q. set (s := sin beta) in *. set (c := cos beta) in *.
  assert (k0 : A * lam = mu * (g * c)) by (unfold lam, eq5_lambda, A; field; lra). unfold pulled. rewrite k0. split.
  - intros wx wy wz [C L]. fold s c in L. split. 1, 2: intros t Ht; destruct (C t Ht) as (? & ? & ?); cont. intros t Ht.
    destruct (L t Ht) as (_ & N & Fx & Fy & Fz & N0 & F0 & B & P & X & Y & Z).
    assert (eN : N = g * c).
    { assert (D : rder (fun t => wx t * s + wz t * c) t ((N * s + Fx) * s + (- g + N * c + Fz) * c)) by (eapply rder_eq; [ rd | ring ]).
      assert (D0 : rder (fun t => wx t * s + wz t * c) t 0) by (apply (rder_zero _ t 1 Rlt_0_1); intros r Hr; apply L; lra).
      pose proof (rder_unique _ _ _ _ D D0) as e. assert (N * (s ^ 2 + c ^ 2) + (Fx * s + Fz * c) - g * c = 0) by lra. rewrite q, F0 in H. lra. }
    subst N. destruct (L t Ht) as (w0 & _).
    assert (two : forall a b a' b', a * s + b * c = 0 -> a' * s + b' * c = 0 -> (c * a - s * b) * (c * a' - s * b') = a * a' + b * b').
    { intros a b a' b' h h'. transitivity ((s ^ 2 + c ^ 2) * (a * a' + b * b') - (a * s + b * c) * (a' * s + b' * c)); [ ring | rewrite q, h;
      ring ]. }
    exists (c * Fx - s * Fz), Fy. split; [ split | split ].
    + pose proof (two _ _ _ _ F0 F0). replace ((c * Fx - s * Fz) ^ 2) with (Fx * Fx + Fz * Fz) by (rewrite <- H; ring). lra.
    + rewrite (two _ _ _ _ F0 w0). unfold nrm. replace ((c * wx t - s * wz t) ^ 2) with (wx t * wx t + wz t * wz t) by (rewrite <- (two _ _ _ _ w0
      w0); ring).
      replace (wx t * wx t + wz t * wz t + wy t ^ 2) with (wx t ^ 2 + wy t ^ 2 + wz t ^ 2) by ring. rewrite <- P. ring.
    + eapply rder_eq. rd. unfold eq3_acceleration_1, A. fold s. ring.
    + eapply rder_eq. rd. unfold eq3_acceleration_2. ring.
  - intros vx vy [cx cy L]. split. { intros t Ht. specialize (cx t Ht). specialize (cy t Ht). repeat split; trivial; cont. }
    intros t Ht. destruct (L t Ht) as (fx & fy & [B P] & X & Y). unfold eq3_acceleration_1, eq3_acceleration_2, A in *. fold s c in X |- *. split.
    ring. exists (g * c), (c * fx), fy, (- s * fx). repeat split.
    + nra.
    + ring.
    + replace ((c * fx) ^ 2 + fy ^ 2 + (- s * fx) ^ 2) with ((s ^ 2 + c ^ 2) * fx ^ 2 + fy ^ 2) by ring. rewrite q. lra.
    + replace ((c * vx t) ^ 2 + vy t ^ 2 + (- s * vx t) ^ 2) with ((s ^ 2 + c ^ 2) * vx t ^ 2 + vy t ^ 2) by ring. rewrite q, Rmult_1_l.
      fold (nrm (vx t) (vy t)). rewrite <- P. transitivity ((s ^ 2 + c ^ 2) * (fx * vx t) + fy * vy t); [ ring | rewrite q; ring ].
    + eapply rder_eq. rd. ring.
    + eapply rder_eq. rd. ring.
    + eapply rder_eq. rd. assert (- g = - g * (s ^ 2 + c ^ 2)) as -> by (rewrite q; ring). ring.
Qed.
(* A drive that depends on time is no incline: if each motion under a continuous drive is one under a constant pull (ax, ay), with any friction k',
   then k' = k
   and the drive is that constant at all times. *)
Theorem s21_incline_only_constant k k' Ax Ay ax ay : 0 <= k -> 0 <= k' -> (forall t, 0 <= t -> continuity_pt Ax t /\ continuity_pt Ay t) ->
  (forall vx vy, motion k Ax Ay vx vy -> motion k' (fun _ => ax) (fun _ => ay) vx vy) -> k' = k /\ forall t, 0 <= t -> Ax t = ax /\ Ay t = ay.
Proof.
  intros hk hk' C H. assert (R : forall vx vy t, motion k Ax Ay vx vy -> 0 <= t -> nrm (vx t) (vy t) <> 0 ->
    - Ax t - k * (vx t / nrm (vx t) (vy t)) = - ax - k' * (vx t / nrm (vx t) (vy t)) /\ - Ay t - k * (vy t / nrm (vx t) (vy t)) = - ay - k' * (vy t /
      nrm (vx t) (vy t))).
  { intros vx vy t M Ht N. destruct (slip_rates _ _ _ _ _ hk M t Ht N) as [X Y]. destruct (slip_rates _ _ _ _ _ hk' (H _ _ M) t Ht N) as [X' Y'].
    split; eapply rder_unique; eassumption. }
  assert (n1 : nrm 1 0 = 1 /\ nrm (-1) 0 = 1) by (rewrite !nrm_x, Rabs_R1, Rabs_left by lra; lra). destruct n1 as [n1 n2].
  assert (ek : k' = k).
  { destruct (plane_has_a_motion k Ax Ay 1 0 hk C) as (vx & vy & M & e1 & e2).
    destruct (plane_has_a_motion k Ax Ay (-1) 0 hk C) as (ux & uy & M' & f1 & f2).
    destruct (R vx vy 0 M (Rle_refl 0)) as [a _]. rewrite e1, e2; lra. destruct (R ux uy 0 M' (Rle_refl 0)) as [b _]. rewrite f1, f2; lra.
    rewrite e1, e2, n1 in a. rewrite f1, f2, n2 in b. lra. }
  split; trivial. intros t Ht. subst k'.
  destruct (continuity_ab_maj (fun s => Rabs (Ax s)) 0 t Ht) as (m & Hm & _). { intros s Hs. apply (continuity_pt_comp Ax Rabs). apply C; lra.
  apply Rcontinuity_abs. }
  set (B := (k + Rabs (Ax m)) * t + 1). destruct (plane_has_a_motion k Ax Ay B 0 hk C) as (vx & vy & M & e1 & _).
  assert (L : Rabs (vx t - vx 0) <= (k + Rabs (Ax m)) * (t - 0)).
  { apply rder_lip; trivial; intros s Hs. apply (m_cx _ _ _ _ _ M); lra. destruct (m_law _ _ _ _ _ M s ltac:(lra)) as (fx & fy & [b _] & X & _).
    eexists. split. exact X.
    specialize (Hm s ltac:(lra)). apply Rabs_le_between in Hm. assert (- k <= fx <= k) by (pose proof (pow2_ge_0 fy); nra). apply Rabs_le. lra. }
  apply Rabs_le_between in L. assert (x1 : 1 <= vx t) by (unfold B in e1; lra). destruct (abs_nrm (vx t) (vy t)) as [b _].
  rewrite Rabs_pos_eq in b by lra.
  destruct (R vx vy t M Ht) as [X Y]; lra.
Qed.

(* ---- the hypotheses of these theorems can be met: with A = 1, from the speed 1 and the angle th ---- *)
Ltac start lam th := pose proof PI_RGT_0; destruct (pull_has_a_motion 1 lam 1 th) as (vx & vy & v & theta & M & P & v0 & th0); [ lra .. | ];
  assert (l0 : 0 <= lam) by lra; match goal with M : pulled _ _ _ _, P : polar _ _ _ _,
  l : 0 <= lam |- _ => pose proof (goes _ _ _ _ _ _ Rlt_0_1 l M P) as G end.
Ltac at_0 := repeat match goal with e : ?f 0 = _ |- _ => rewrite e end.
Ltac ok := intros; unfold s21_keeps_moving_sides_1, s21_keeps_moving_sides_2, s21_cannot_hold_sides_1, s21_cannot_hold_sides_2 in *; at_0;
  rewrite ?cos_PI2; trivial;
  try first [ lra | match goal with G : forall t, _ -> _ |- 0 < _ => apply G; at_0; lra end ].
Ltac met H t := start (1 / 2) (PI / 2); match goal with M : pulled _ _ _ _, P : polar _ _ _ _,
  l : 0 <= _ |- _ => apply (H _ _ _ _ _ _ Rlt_0_1 l M P t) end; ok.
Lemma eq_6__occurs : ltac:(occurs eq_6). Proof. intros H. met H 1%R. Qed.
Lemma eq_7__occurs : ltac:(occurs eq_7). Proof. intros H. met H 1%R. Qed.
Lemma eq_8__occurs : ltac:(occurs eq_8). Proof. intros H. met H 1%R. Qed.
Lemma eq_9__occurs : ltac:(occurs eq_9). Proof. intros H. met H 0%R. Qed.
Lemma eq_10__occurs : ltac:(occurs eq_10). Proof. intros H. met H 1%R. Qed.
Lemma eq_11__occurs : ltac:(occurs eq_11). Proof. intros H. met H 1%R. Qed.
Lemma eq_12__occurs : ltac:(occurs eq_12). Proof. intros H. met H 1%R. Qed.
Lemma eq_13__occurs : ltac:(occurs eq_13). Proof. intros H. met H 1%R. Qed.
Lemma eq_14__occurs : ltac:(occurs eq_14).
Proof.
  intros H. start 1 (PI / 2). apply (H 1 1 vx vy v theta Rlt_0_1 l0 M P 1); [ lra | ok | ]. intros z.
  pose proof (moved_polar 1 1 vx vy v theta Rlt_0_1 l0 M P 1 ltac:(lra) ltac:(ok)) as e.
  rewrite z, v0, th0, cos_PI2 in e. lra.
Qed.
Lemma eq_15__occurs : ltac:(occurs eq_15). Proof. intros H. start 0 (PI / 2). exact (H 1 vx vy M 0 (Rle_refl 0)). Qed.
Lemma eq_16__occurs : ltac:(occurs eq_16). Proof. intros H. start 0 (PI / 2). exact (H 1 vx vy M 0 (Rle_refl 0)). Qed.
(* the parabola from (0, 0), crosswise *)
Lemma s21_frictionless_parabola__occurs : ltac:(occurs s21_frictionless_parabola).
Proof.
  intros H. refine (H 1 (fun t => t) (fun _ => 1) (fun t => t ^ 2 * / 2) (fun t => t) _ _ _ 0 (Rle_refl 0)).
  - split. 1, 2: intros; cont. intros t Ht. exists 0, 0. unfold coulomb, eq3_acceleration_1, eq3_acceleration_2. split. split; ring_simplify; lra.
    split; (eapply rder_eq; [ rd | ring ]).
  - intros; split; cont.
  - intros; split; (eapply rder_eq; [ rd | simpl; field ]).
Qed.
Lemma eq_17__occurs : ltac:(occurs eq_17). Proof. intros H. start 1 (PI / 2). apply (H 1 1 vx vy v theta Rlt_0_1 M P) with 0; ok. Qed.
Lemma eq_18__occurs : ltac:(occurs eq_18). Proof. intros H. start 1 (PI / 2). apply (H 1 1 vx vy v theta Rlt_0_1 M P); ok. Qed.
Lemma eq_19__occurs : ltac:(occurs eq_19). Proof. intros H. start 1 (PI / 2). apply (H 1 1 vx vy v theta Rlt_0_1 M P); ok. Qed.
Lemma s21_critical_terminal_velocity__occurs : ltac:(occurs s21_critical_terminal_velocity). Proof. intros H. start 1 (PI / 2).
  apply (H 1 1 vx vy v theta Rlt_0_1 M P); ok. Qed.
Lemma eq_20__occurs : ltac:(occurs eq_20). Proof. intros H. start 2 (PI / 2). apply (H 1 2 vx vy v theta Rlt_0_1 l0 M P); ok. Qed.
Lemma s21_large_friction_stops__occurs : ltac:(occurs s21_large_friction_stops). Proof. intros H. start 2 (PI / 2).
  apply (H 1 2 vx vy v theta Rlt_0_1 l0 M P); ok. Qed.
Lemma s21_large_friction_stops__at_PI__occurs : ltac:(occurs s21_large_friction_stops__at_PI).
Proof. intros H. start 2 PI. apply (H 1 2 vx vy v theta Rlt_0_1 l0 M P) with 0; ok. unfold eq20_stop_time. rewrite cos_PI. lra. Qed.
Lemma s21_small_friction_aligns__occurs : ltac:(occurs s21_small_friction_aligns). Proof. intros H. start 1 (PI / 2).
  apply (H 1 1 vx vy v theta Rlt_0_1 l0 M P); ok. Qed.
Lemma s21_small_friction_aligns__excepted__occurs : ltac:(occurs s21_small_friction_aligns__excepted). Proof. intros H. start 1 PI.
  apply (H 1 1 vx vy v theta Rlt_0_1 M P) with 1; ok. Qed.
(* from rest *)
Lemma s21_friction_cannot_hold__occurs : ltac:(occurs s21_friction_cannot_hold).
Proof.
  intros H. destruct (pull_has_a_motion 1 (1 / 2) 0 0) as (vx & vy & v & theta & M & P & v0 & th0); try (pose proof PI_RGT_0; lra).
  apply (H 1 (1 / 2) vx vy v theta) with 0 1; ok.
Qed.
Lemma fig_1__occurs : ltac:(occurs fig_1). Proof. intros H. start 2 (PI / 2). apply (H 1 2 vx vy v theta Rlt_0_1 l0 M P); ok. Qed.
Lemma s21_along_acceleration__occurs : ltac:(occurs s21_along_acceleration).
Proof.
  intros H. destruct (plane_has_a_motion 1 (fun _ => -1) (fun _ => 0) 0 1) as (vx & vy & M & e1 & e2). lra. intros; split; cont.
  assert (n1 : nrm (-1) 0 = 1) by (rewrite nrm_x, Rabs_left; lra). refine (H 1 (-1) 0 vx vy _ _ M _); rewrite n1; try lra. right.
  rewrite e1, e2, nrm_0y; lra.
Qed.
Lemma s21_incline__occurs : exists wx wy wz, on_incline (1 / 2) 1 (PI / 4) wx wy wz /\ wy 0 = 1.
Proof.
  pose proof PI_RGT_0. assert (b : 0 < PI / 4 < PI / 2) by lra. destruct (s21_incline (1 / 2) 1 (PI / 4) Rlt_0_1 b) as [_ I].
  assert (s0 : 0 < 1 * sin (PI / 4)) by (rewrite Rmult_1_l; apply sin_gt_0; lra). assert (c0 : 0 < cos (PI / 4)) by (apply cos_gt_0; lra).
  destruct (pull_has_a_motion (1 * sin (PI / 4)) (eq5_lambda (1 / 2) (1 * cos (PI / 4)) (1 * sin (PI / 4))) 1 (PI / 2)) as (vx & vy & v & theta & M &
  P & v0 & th0); try lra.
  { unfold eq5_lambda. apply Rdiv_le_0_compat; lra. } do 3 eexists. split. exact (I vx vy M). destruct (P 0 (Rle_refl 0)) as (_ & _ & _ & ->).
    unfold eq4_velocity_2. rewrite v0, th0, sin_PI2. ring.
Qed.
Lemma s21_incline_only_constant__occurs : ltac:(occurs s21_incline_only_constant).
Proof. intros H. refine (H 1 1 (fun _ => 1) (fun _ => 0) 1 0 _ _ _ (fun _ _ M => M)); try lra. intros; split; cont. Qed.
