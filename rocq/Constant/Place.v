(* 2.1: where it stops (lambda > 1); not in the paper *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Constant.
Open Scope R_scope.

Section Place.
Variables (A lam : R) (vx vy x y : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 1 < lam.
Hypothesis M : motion (A * lam) (fun _ => - A) (fun _ => 0) vx vy.
Hypothesis cx : forall t, 0 < t -> continuity_pt x t.
Hypothesis cy : forall t, 0 < t -> continuity_pt y t.
Hypothesis px : forall t, 0 <= t -> rder x t (vx t).
Hypothesis py : forall t, 0 <= t -> rder y t (vy t).
Notation v t := (nrm (vx t) (vy t)).
(* two quadratic forms of the velocity, with the rates - 4 A (lambda^2 - 1) vx and - A (4 lambda^2 - 1) vy *)
Definition form_x t := v t ^ 2 + 2 * lam * v t * vx t + vx t ^ 2.
Definition form_y t := vy t * (2 * lam * v t + vx t).

Lemma forms t : 0 <= t -> (forall s, 0 <= s < t -> v s <> 0) ->
  4 * A * (lam ^ 2 - 1) * x t + form_x t = 4 * A * (lam ^ 2 - 1) * x 0 + form_x 0 /\
  A * (4 * lam ^ 2 - 1) * y t + form_y t = A * (4 * lam ^ 2 - 1) * y 0 + form_y 0.
Proof.
  intros Ht N. unfold form_x, form_y.
  split; [ apply (rder_const (fun t => 4 * A * (lam ^ 2 - 1) * x t + (v t ^ 2 + 2 * lam * v t * vx t + vx t ^ 2)))
         | apply (rder_const (fun t => A * (4 * lam ^ 2 - 1) * y t + vy t * (2 * lam * v t + vx t))) ]; trivial; intros s Hs;
    try (cont; try (apply cx; lra); try (apply cy; lra); try (apply (m_cx _ _ _ _ _ M); lra); apply (m_cy _ _ _ _ _ M); lra);
    destruct (newton A lam vx vy hA ltac:(lra) M s ltac:(lra) (N s Hs)) as [X Y]; specialize (N s Hs); pose proof (px s ltac:(lra)); pose proof (py s ltac:(lra));
    (eapply rder_eq; [ rd; exact N | ]); pose proof (nrm_sq (vx s) (vy s)); set (n := nrm (vx s) (vy s)) in *; simpl;
    (field_simplify_eq; [ | exact N ]); replace (vy s ^ 2) with (n ^ 2 - vx s ^ 2) by lra; try ring;
    replace (vy s ^ 3) with (vy s * (n ^ 2 - vx s ^ 2)) by (replace (n ^ 2 - vx s ^ 2) with (vy s ^ 2) by lra; ring); ring.
Qed.
Theorem stopping_place t : (lam * v 0 + vx 0) / (A * (lam ^ 2 - 1)) <= t -> 0 <= t ->
  x t = x 0 + form_x 0 / (4 * A * (lam ^ 2 - 1)) /\ y t = y 0 + form_y 0 / (A * (4 * lam ^ 2 - 1)).
Proof.
  set (T := (lam * v 0 + vx 0) / (A * (lam ^ 2 - 1))). intros h1 h2. assert (l2 : 1 < lam ^ 2) by nra. assert (k0 : 0 < A * (lam ^ 2 - 1)) by nra.
  pose proof (eq20 A lam vx vy hA ltac:(lra) M hl) as E. cbv beta zeta in E. fold T in E. destruct E as [E1 E2].
  assert (T0 : 0 <= T). { unfold T. apply Rmult_le_pos; [ | left; now apply Rinv_0_lt_compat ]. pose proof (vx_le vx vy 0) as V. cbv beta zeta in V. apply Rabs_le_between in V. pose proof (nrm_pos (vx 0) (vy 0)). nra. }
  assert (R : forall s, T <= s -> vx s = 0 /\ vy s = 0). { intros s Hs. apply sq_sum. rewrite <- nrm_sq, E2; lra. }
  destruct (forms T T0 E1) as [F1 F2]. destruct (R T ltac:(lra)) as [r1 r2]. unfold form_x at 1 in F1. unfold form_y at 1 in F2. rewrite (E2 T ltac:(lra) T0), r1 in F1. rewrite r2 in F2.
  assert (x t = x T). { apply (rder_const x); [ lra | intros; apply cx; lra | ]. intros s Hs. destruct (R s ltac:(lra)) as [<- _]. apply px; lra. }
  assert (y t = y T). { apply (rder_const y); [ lra | intros; apply cy; lra | ]. intros s Hs. destruct (R s ltac:(lra)) as [_ <-]. apply py; lra. }
  split; [ rewrite H; apply (Rmult_eq_reg_l (4 * A * (lam ^ 2 - 1))); [ | nra ] | rewrite H0; apply (Rmult_eq_reg_l (A * (4 * lam ^ 2 - 1))); [ | nra ] ]; rewrite Rmult_plus_distr_l.
  - replace (4 * A * (lam ^ 2 - 1) * (form_x 0 / (4 * A * (lam ^ 2 - 1)))) with (form_x 0) by (field; nra). lra.
  - replace (A * (4 * lam ^ 2 - 1) * (form_y 0 / (A * (4 * lam ^ 2 - 1)))) with (form_y 0) by (field; nra). lra.
Qed.
(* the same by the angle at the start, which may be 0, PI or below *)
Corollary stopping_place_angle v0 th t : vx 0 = v0 * cos th -> vy 0 = v0 * sin th -> 0 <= v0 -> v0 * (lam + cos th) / (A * (lam ^ 2 - 1)) <= t -> 0 <= t ->
  x t = x 0 + v0 ^ 2 * (1 + 2 * lam * cos th + cos th ^ 2) / (4 * A * (lam ^ 2 - 1)) /\ y t = y 0 + v0 ^ 2 * sin th * (2 * lam + cos th) / (A * (4 * lam ^ 2 - 1)).
Proof.
  intros e1 e2 h0 h1 h2. assert (e : v 0 = v0).
  { unfold nrm. rewrite e1, e2. pose proof (sin2_cos2 th) as I. rewrite !Rsqr_pow2 in I. replace ((v0 * cos th) ^ 2 + (v0 * sin th) ^ 2) with (v0 ^ 2 * (sin th ^ 2 + cos th ^ 2)) by ring.
    rewrite I, Rmult_1_r. now apply sqrt_pow2. }
  destruct (stopping_place t) as [X Y]; trivial. { rewrite e, e1. replace (lam * v0 + v0 * cos th) with (v0 * (lam + cos th)) by ring. exact h1. }
  rewrite X, Y. unfold form_x, form_y. rewrite e, e1, e2. split; f_equal; f_equal; ring.
Qed.
End Place.
