(* (10) to (13) and (17) to (19), as printed, from (1) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Constant.
Open Scope R_scope.

Definition eq11_speed (lam v0 th0 th : R) : R :=
  v0 * (sin th0 / sin th) * Rpower (tan (th / 2) / tan (th0 / 2)) lam.
Definition eq13_time (lam A v0 th0 th : R) : R :=
  v0 * (lam + cos th0) / (A * (1 - lam ^ 2)) *
  ((lam + cos th) * sin th0 / ((lam + cos th0) * sin th) * Rpower (tan (th / 2) / tan (th0 / 2)) lam - 1).
Definition eq14_speed (lam A v0 th0 th t : R) : R := ((1 - lam ^ 2) * A * t + v0 * (lam + cos th0)) / (lam + cos th).
Definition eq20_T (lam A v0 th0 : R) : R := v0 * (lam + cos th0) / (A * (lam ^ 2 - 1)).

Lemma tan_half th : 0 < th < PI -> tan (th / 2) = sin th / (1 + cos th) /\ 0 < tan (th / 2).
Proof.
  intros H. assert (0 < cos (th / 2)) by (apply cos_gt_0; lra). split; [ | apply tan_gt_0; lra ].
  unfold tan. replace (sin th) with (sin (2 * (th / 2))) by (f_equal; field). replace (cos th) with (cos (2 * (th / 2))) by (f_equal; field).
  rewrite sin_2a, cos_2a_cos. field. split; nra.
Qed.

Section Angle.
Variables (A lam : R) (vx vy v theta : R -> R) (t : R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : motion (A * lam) (fun _ => - A) (fun _ => 0) vx vy.
Hypothesis ht : 0 <= t.
(* (4) holds up to the time t, and the particle slips at an angle *)
Hypothesis polar : forall s, 0 <= s <= t -> 0 < v s /\ 0 < theta s < PI /\ vx s = v s * cos (theta s) /\ vy s = v s * sin (theta s).

Lemma speed s : 0 <= s <= t -> nrm (vx s) (vy s) = v s.
Proof.
  intros Hs. destruct (polar s Hs) as (p & _ & -> & ->). unfold nrm.
  replace ((v s * cos (theta s)) ^ 2 + (v s * sin (theta s)) ^ 2) with (Rsqr (v s) * (Rsqr (sin (theta s)) + Rsqr (cos (theta s)))) by (unfold Rsqr; ring).
  rewrite sin2_cos2, Rmult_1_r. apply sqrt_Rsqr. lra.
Qed.
Lemma sin_pos s : 0 <= s <= t -> 0 < sin (theta s).
Proof. intros Hs. destruct (polar s Hs) as (_ & H & _). apply sin_gt_0; lra. Qed.

Theorem eq10 : v t * sin (theta t) * Rpower (tan (theta t / 2)) (- lam) = v 0 * sin (theta 0) * Rpower (tan (theta 0 / 2)) (- lam).
Proof.
  assert (L := law10 A lam vx vy hA hl M t ht). cbv zeta beta in L. rewrite !speed in L by lra.
  assert (F : forall s, 0 <= s <= t -> v s * sin (theta s) * Rpower (tan (theta s / 2)) (- lam) = exp (ln (vy s) - lam * (ln (vy s) - ln (v s + vx s)))).
  { intros s Hs. destruct (polar s Hs) as (p & a & ex & ey). pose proof (sin_pos s Hs).
    destruct (tan_half (theta s) a) as [e _]. assert (0 < 1 + cos (theta s)) by (pose proof (sin2_cos2 (theta s)) as Q; pose proof (COS_bound (theta s)); unfold Rsqr in Q; nra).
    rewrite <- ey at 1. assert (0 < vy s) by (rewrite ey; nra). assert (0 < v s + vx s) by (rewrite ex; nra).
    rewrite <- (exp_ln (vy s)) at 1 by trivial. unfold Rpower. rewrite <- exp_plus. f_equal.
    replace (tan (theta s / 2)) with (vy s / (v s + vx s)). rewrite ln_div by trivial. ring. rewrite ex, ey, e. field. nra. }
  rewrite !F by lra. f_equal. apply L. intros s Hs. destruct (polar s Hs) as (p & _ & _ & ->). pose proof (sin_pos s Hs). nra.
Qed.

Theorem eq11 : v t = eq11_speed lam (v 0) (theta 0) (theta t).
Proof.
  pose proof eq10 as E. pose proof (sin_pos t ltac:(lra)). pose proof (sin_pos 0 ltac:(lra)).
  destruct (polar t ltac:(lra)) as (_ & a & _). destruct (polar 0 ltac:(lra)) as (_ & a0 & _).
  destruct (tan_half _ a) as [_ p]. destruct (tan_half _ a0) as [_ p0].
  unfold eq11_speed, Rdiv at 2. unfold Rpower in *. rewrite ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; trivial).
  set (w := ln (tan (theta t / 2))) in *. set (w0 := ln (tan (theta 0 / 2))) in *.
  replace (lam * (w + - w0)) with (- lam * w0 + - (- lam * w)) by ring. rewrite exp_plus, exp_Ropp.
  pose proof (exp_pos (- lam * w)). apply (Rmult_eq_reg_l (sin (theta t) * exp (- lam * w))); [ | nra ].
  transitivity (v t * sin (theta t) * exp (- lam * w)). ring. rewrite E. field. lra.
Qed.

Theorem eq14' : lam + cos (theta t) <> 0 -> v t = eq14_speed lam A (v 0) (theta 0) (theta t) t.
Proof.
  intros N. pose proof (eq14 A lam vx vy hA hl M t ht) as E. cbv zeta beta in E. rewrite !speed in E by lra.
  destruct (polar t ltac:(lra)) as (_ & _ & ex & _). destruct (polar 0 ltac:(lra)) as (_ & _ & ex0 & _).
  unfold eq14_speed. rewrite ex, ex0 in E. apply (Rmult_eq_reg_r (lam + cos (theta t))); trivial.
  replace (v t * (lam + cos (theta t))) with (lam * v t + v t * cos (theta t)) by ring. rewrite E. field. trivial.
  intros s Hs. rewrite speed by lra. destruct (polar s ltac:(lra)). lra.
Qed.

(* (13), with the conditions under which it has a value *)
Theorem eq13 : lam <> 1 -> lam + cos (theta 0) <> 0 -> t = eq13_time lam A (v 0) (theta 0) (theta t).
Proof.
  intros h1 h0. pose proof (eq14 A lam vx vy hA hl M t ht) as E. cbv zeta beta in E. rewrite !speed in E by lra.
  destruct (polar t ltac:(lra)) as (_ & _ & ex & _). destruct (polar 0 ltac:(lra)) as (_ & _ & ex0 & _). rewrite ex, ex0 in E.
  pose proof eq11 as E11. unfold eq11_speed in E11. pose proof (sin_pos t ltac:(lra)). pose proof (sin_pos 0 ltac:(lra)).
  assert (1 - lam ^ 2 <> 0) by nra. unfold eq13_time. set (P := Rpower _ lam) in *.
  apply (Rmult_eq_reg_l ((1 - lam ^ 2) * A)); [ | apply Rmult_integral_contrapositive; lra ].
  transitivity (v t * (lam + cos (theta t)) - v 0 * (lam + cos (theta 0))).
  - assert (E2 : lam * v t + v t * cos (theta t) = lam * v 0 + v 0 * cos (theta 0) + (1 - lam ^ 2) * A * t).
    { apply E. intros s Hs. rewrite speed by lra. destruct (polar s ltac:(lra)). lra. } lra.
  - rewrite E11. field. repeat split; lra.
Qed.
End Angle.
