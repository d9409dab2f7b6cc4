(* Where the particle stops under a constant pull with lambda > 1, from every start; it is not in the paper. Two quadratic forms of the velocity have rates
   - 4 A (lambda^2 - 1) vx and - A (4 lambda^2 - 1) vy while it slips, and are 0 at the stop. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas.
From Slipbook.General Require Import Rates.
From Slipbook.Constant Require Import Slip Angle.
Open Scope R_scope.

Section Place.
Variables (A lam : R) (vx vy x y : R -> R).
Hypothesis hA : 0 < A.
Hypothesis h1 : 1 < lam.
Hypothesis M : pulled A lam vx vy.
Hypothesis cp : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t.
Hypothesis dp : forall t, 0 <= t -> rder x t (vx t) /\ rder y t (vy t).
Notation v t := (nrm (vx t) (vy t)).
Definition form_x t := v t ^ 2 + 2 * lam * v t * vx t + vx t ^ 2.
Definition form_y t := vy t * (2 * lam * v t + vx t).
Lemma forms t : 0 <= t -> (forall s, 0 <= s < t -> v s <> 0) ->
  4 * A * (lam ^ 2 - 1) * x t + form_x t = 4 * A * (lam ^ 2 - 1) * x 0 + form_x 0 /\
  A * (4 * lam ^ 2 - 1) * y t + form_y t = A * (4 * lam ^ 2 - 1) * y 0 + form_y 0.
Proof.
  intros Ht N. unfold form_x, form_y.
  split; [ apply (rder_const (fun t => 4 * A * (lam ^ 2 - 1) * x t + (v t ^ 2 + 2 * lam * v t * vx t + vx t ^ 2)))
         | apply (rder_const (fun t => A * (4 * lam ^ 2 - 1) * y t + vy t * (2 * lam * v t + vx t))) ]; trivial; intros s Hs;
    try (destruct (cp s ltac:(lra)); pose proof (cx A lam vx vy M s ltac:(lra)); pose proof (cy A lam vx vy M s ltac:(lra)); cont; fail);
    specialize (N s Hs); destruct (pull_rates A lam vx vy hA ltac:(lra) M s ltac:(lra) N) as (X & Y & _); destruct (dp s ltac:(lra));
    (eapply rder_eq; [ rd; exact N | ]); pose proof (nrm_sq (vx s) (vy s)); set (n := nrm (vx s) (vy s)) in *; simpl;
    (field_simplify_eq; [ | exact N ]); replace (vy s ^ 2) with (n ^ 2 - vx s ^ 2) by lra; try ring;
    replace (vy s ^ 3) with (vy s * (n ^ 2 - vx s ^ 2)) by (replace (n ^ 2 - vx s ^ 2) with (vy s ^ 2) by lra; ring); ring.
Qed.
Theorem stopping_place t : (lam * v 0 + vx 0) / (A * (lam ^ 2 - 1)) <= t ->
  x t = x 0 + form_x 0 / (4 * A * (lam ^ 2 - 1)) /\ y t = y 0 + form_y 0 / (A * (4 * lam ^ 2 - 1)).
Proof.
  assert (hl : 0 <= lam) by lra. pose proof (T_pos A lam vx vy hA h1) as T0. set (T := (lam * v 0 + vx 0) / (A * (lam ^ 2 - 1))) in *. intros Ht.
  assert (R : forall s, T <= s -> vx s = 0 /\ vy s = 0) by (intros s Hs; apply nrm_zero, (rest_after A lam vx vy hA hl M h1); trivial).
  destruct (forms T T0 (slip_before A lam vx vy hA hl M h1)) as [F1 F2]. destruct (R T ltac:(lra)) as [r1 r2].
  unfold form_x at 1 in F1. unfold form_y at 1 in F2. rewrite r1, r2, nrm_0 in F1. rewrite r1, r2, nrm_0 in F2.
  assert (ex : x t = x T). { apply (rder_const x); [ lra | intros; apply cp; lra | ]. intros s Hs. destruct (R s ltac:(lra)) as [<- _]. apply dp; lra. }
  assert (ey : y t = y T). { apply (rder_const y); [ lra | intros; apply cp; lra | ]. intros s Hs. destruct (R s ltac:(lra)) as [_ <-]. apply dp; lra. }
  pose proof (hd A lam hA h1). assert (k1 : 4 * A * (lam ^ 2 - 1) <> 0) by lra. assert (0 < A * (4 * lam ^ 2 - 1)) by (apply Rmult_lt_0_compat; nra). assert (k2 : A * (4 * lam ^ 2 - 1) <> 0) by lra.
  split; [ rewrite ex; apply (Rmult_eq_reg_l (4 * A * (lam ^ 2 - 1))); trivial | rewrite ey; apply (Rmult_eq_reg_l (A * (4 * lam ^ 2 - 1))); trivial ]; rewrite Rmult_plus_distr_l.
  - replace (4 * A * (lam ^ 2 - 1) * (form_x 0 / (4 * A * (lam ^ 2 - 1)))) with (form_x 0) by (field; nra). lra.
  - replace (A * (4 * lam ^ 2 - 1) * (form_y 0 / (A * (4 * lam ^ 2 - 1)))) with (form_y 0) by (field; nra). lra.
Qed.
(* the same by the speed and the angle at the start, with the time T of (20) *)
Corollary stopping_place_angle v theta t : polar vx vy v theta -> eq20_stop_time lam A (v 0) (theta 0) <= t ->
  x t = x 0 + v 0 ^ 2 * (1 + 2 * lam * cos (theta 0) + cos (theta 0) ^ 2) / (4 * A * (lam ^ 2 - 1)) /\
  y t = y 0 + v 0 ^ 2 * sin (theta 0) * (2 * lam + cos (theta 0)) / (A * (4 * lam ^ 2 - 1)).
Proof.
  intros P Ht. pose proof (polar_speed vx vy v theta 0 P (Rle_refl 0)) as e. destruct (P 0 (Rle_refl 0)) as (_ & _ & e1 & e2). unfold eq4_velocity_1, eq4_velocity_2, eq20_stop_time in *.
  destruct (stopping_place t) as [X Y]. { rewrite e, e1. replace (lam * v 0 + v 0 * cos (theta 0)) with (v 0 * (lam + cos (theta 0))) by ring. exact Ht. }
  rewrite X, Y. unfold form_x, form_y. rewrite e, e1, e2. split; f_equal; f_equal; ring.
Qed.
End Place.
