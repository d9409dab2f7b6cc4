(* (17) to (19): lambda = 1 *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Constant Limits.
Open Scope R_scope.

Section Critical.
Variables (A : R) (vx vy : R -> R).
Hypothesis hA : 0 < A.
Hypothesis M : motion (A * 1) (fun _ => - A) (fun _ => 0) vx vy.
Notation v t := (nrm (vx t) (vy t)).
Let C := v 0 + vx 0.
Hypothesis hC : 0 < C.  (* it does not start at rest or straight against x *)
Ltac conts := cont; first [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.

Theorem eq17 t : 0 <= t -> v t + vx t = C.
Proof.
  intros Ht. apply (rder_const (fun t => v t + vx t)); trivial; intros s Hs; [ conts | ].
  destruct (Req_dec (v s) 0) as [z | z].
  - destruct (v0_cases vx vy s z) as [e1 e2].
    assert (R0 : forall r, s <= r -> vx r = 0 /\ vy r = 0).
    { apply (rest_lasts (A * 1) (fun _ => - A) (fun _ => 0)); trivial; try lra. intros _ _. unfold nrm.
      replace ((- A) ^ 2 + 0 ^ 2) with (Rsqr A) by (unfold Rsqr; ring). rewrite sqrt_Rsqr; lra. }
    exists (fun _ => 0). split. auto_derive; trivial. intros r Hr. destruct (R0 r Hr) as [-> ->].
    unfold nrm. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. rewrite sqrt_0. inR. ring.
  - destruct (newton A 1 vx vy hA Rle_0_1 M s ltac:(lra) z) as [X Y]. cbv zeta beta in X, Y. pose proof (nrm_sq (vx s) (vy s)) as e.
    eapply rder_eq. rd. exact z. set (n := v s) in *. inR. field_simplify_eq; [ | exact z ]. replace (vy s ^ 2) with (n ^ 2 - vx s ^ 2) by lra. ring.
Qed.
Lemma moves t : 0 <= t -> 0 < v t /\ v t = (C + vy t ^ 2 / C) / 2.
Proof.
  intros Ht. pose proof (eq17 t Ht) as e. pose proof (nrm_sq (vx t) (vy t)) as q. pose proof (nrm_pos (vx t) (vy t)).
  assert (E : v t = (C + vy t ^ 2 / C) / 2). { replace (vy t ^ 2) with ((v t - vx t) * C) by (rewrite <- e; nra). field_simplify; lra. }
  split; trivial. rewrite E. assert (0 <= vy t ^ 2 / C) by (apply Rmult_le_pos; [ apply pow2_ge_0 | left; now apply Rinv_0_lt_compat ]). lra.
Qed.
Let B := (C + vy 0 ^ 2 / C) / 2.
Lemma B_pos : 0 < B.
Proof. destruct (moves 0 (Rle_refl 0)) as [a b]. unfold B. rewrite <- b. exact a. Qed.
Theorem eq19_rate t : 0 <= t -> vy t ^ 2 * exp (2 * A / B * t) <= vy 0 ^ 2.
Proof.
  intros Ht. pose proof B_pos as b. replace (vy 0 ^ 2) with (vy 0 ^ 2 * exp (2 * A / B * 0)) by (rewrite Rmult_0_r, exp_0; ring).
  apply (rder_decr (fun t => vy t ^ 2 * exp (2 * A / B * t))); trivial; intros s Hs; [ conts | ].
  destruct (moves s ltac:(lra)) as [n0 n1].
  destruct (newton A 1 vx vy hA Rle_0_1 M s ltac:(lra) ltac:(lra)) as [X Y]. cbv zeta beta in X, Y.
  eexists. split. rd. cbv beta. set (E := exp _). assert (0 < E) by apply exp_pos.
  pose proof (across_falls _ _ _ _ (ltac:(lra) : 0 <= A * 1) M 0 s ltac:(lra)) as F.
  assert (nB : v s <= B). { rewrite n1. unfold B. assert (vy s ^ 2 / C <= vy 0 ^ 2 / C) by (apply Rmult_le_compat_r; [ left; now apply Rinv_0_lt_compat | exact F ]). lra. }
  set (n := v s) in *. assert (K : / B <= / n) by (apply Rinv_le_contravar; lra). pose proof (pow2_ge_0 (vy s)).
  match goal with |- ?g <= 0 => replace g with (2 * A * E * vy s ^ 2 * (/ B - / n)) by (simpl; field; lra) end.
  assert (0 <= 2 * A * E * vy s ^ 2) by (apply Rmult_le_pos; [ nra | trivial ]). nra.
Qed.
Lemma grows K : exists T, 0 <= T /\ forall t, T <= t -> K <= exp (2 * A / B * t).
Proof.
  pose proof B_pos as b. assert (h : 0 < 2 * A / B) by (apply Rdiv_lt_0_compat; lra). exists (Rabs K / (2 * A / B)). split.
  apply Rmult_le_pos; [ apply Rabs_pos | left; now apply Rinv_0_lt_compat ]. intros t Ht.
  apply Rle_trans with (Rabs K); [ apply Rle_abs | ]. pose proof (exp_ineq1_le (2 * A / B * t)).
  apply (Rmult_le_compat_l (2 * A / B)) in Ht; [ | lra ]. replace (2 * A / B * (Rabs K / (2 * A / B))) with (Rabs K) in Ht by (field; lra). lra.
Qed.
Theorem eq19 : is_lim vy p_infty 0.
Proof. apply (lim_of_bound vy (vy 0 ^ 2) (fun t => exp (2 * A / B * t))); [ apply pow2_ge_0 | exact eq19_rate | exact grows ]. Qed.
(* (18): vx tends to (v0 + vx0) / 2 = v0 (1 + cos theta0) / 2 *)
Theorem eq18 : is_lim vx p_infty (C / 2).
Proof.
  assert (L : is_lim (fun t => vx t - C / 2) p_infty 0).
  { apply (lim_of_bound _ ((vy 0 ^ 2) ^ 2 / (4 * C ^ 2)) (fun t => exp (2 * A / B * t))); [ | | exact grows ].
    - apply Rmult_le_pos; [ apply pow2_ge_0 | left; apply Rinv_0_lt_compat; nra ].
    - intros t Ht. destruct (moves t Ht) as [n0 n1]. pose proof (eq17 t Ht) as e. pose proof (eq19_rate t Ht) as r.
      pose proof (across_falls _ _ _ _ (ltac:(lra) : 0 <= A * 1) M 0 t ltac:(lra)) as F.
      replace (vx t - C / 2) with (- (vy t ^ 2 / (2 * C))) by (replace (vx t) with (C - v t) by lra; rewrite n1; field; lra).
      replace ((- (vy t ^ 2 / (2 * C))) ^ 2 * exp (2 * A / B * t)) with (vy t ^ 2 * (vy t ^ 2 * exp (2 * A / B * t)) / (4 * C ^ 2)) by (field; lra).
      apply Rmult_le_compat_r; [ left; apply Rinv_0_lt_compat; nra | ]. pose proof (pow2_ge_0 (vy t)). pose proof (exp_pos (2 * A / B * t)). simpl in *. nra. }
  replace (C / 2) with (0 + C / 2) by ring. apply (is_lim_ext (fun t => vx t - C / 2 + C / 2)); [ intros; ring | ].
  apply (is_lim_plus' _ (fun _ => C / 2)); [ exact L | apply is_lim_const ].
Qed.
End Critical.
