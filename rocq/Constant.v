(* 2.1: constant acceleration of the plane, A = (-A, 0); lambda = k / A *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General.
Open Scope R_scope.

Section Constant.
Variables (A lam : R) (vx vy : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : motion (A * lam) (fun _ => - A) (fun _ => 0) vx vy.
Let v t := nrm (vx t) (vy t).

(* while it slips: Newton's law (1) with its signs *)
Lemma newton t : 0 <= t -> v t <> 0 ->
  rder vx t (A - A * lam * (vx t / v t)) /\ rder vy t (- A * lam * (vy t / v t)).
Proof.
  intros Ht N. destruct (m_law _ _ _ _ _ M t Ht) as (fx & fy & C & X & Y).
  assert (hk : 0 <= A * lam) by nra. destruct (coulomb_slip _ _ _ _ _ hk C) as [e1 e2]. fold (v t) in *.
  split; (eapply rder_eq; [ eassumption | apply (Rmult_eq_reg_l (v t)); [ | exact N ] ]);
   [ replace (v t * (fx - - A)) with (v t * fx + A * v t) by ring; rewrite e1 
   | replace (v t * (fy - 0)) with (v t * fy) by ring; rewrite e2 ]; field; exact N.
Qed.

(* (6), (7): with any angle *)
Theorem eq6 theta t : 0 <= t -> v t <> 0 -> (forall s, vx s = v s * cos (theta s)) ->
  rder (fun s => v s * cos (theta s)) t (A * (1 - lam * cos (theta t))).
Proof.
  intros Ht N H. destruct (newton t Ht N) as [[F [D E]] _]. exists F. split; [ | intros; rewrite <- H; auto ].
  replace (A * (1 - lam * cos (theta t))) with (A - A * lam * (vx t / v t)); trivial. rewrite H. field. exact N.
Qed.
Theorem eq7 theta t : 0 <= t -> v t <> 0 -> (forall s, vy s = v s * sin (theta s)) ->
  rder (fun s => v s * sin (theta s)) t (- A * lam * sin (theta t)).
Proof.
  intros Ht N H. destruct (newton t Ht N) as [_ [F [D E]]]. exists F. split; [ | intros; rewrite <- H; auto ].
  replace (- A * lam * sin (theta t)) with (- A * lam * (vy t / v t)); trivial. rewrite H. field. exact N.
Qed.

(* (14): lambda v + vx grows at A (1 - lambda^2) while it slips *)
Theorem eq14 t : 0 <= t -> (forall s, 0 <= s < t -> v s <> 0) ->
  lam * v t + vx t = lam * v 0 + vx 0 + (1 - lam ^ 2) * A * t.
Proof.
  intros Ht N.
  enough (lam * v t + vx t - (1 - lam ^ 2) * A * t = lam * v 0 + vx 0 - (1 - lam ^ 2) * A * 0) by lra.
  apply (rder_const (fun t => lam * nrm (vx t) (vy t) + vx t - (1 - lam ^ 2) * A * t)); trivial; intros s Hs.
  - cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) | apply (m_cx _ _ _ _ _ M) ]; lra.
  - destruct (newton s ltac:(lra) (N s Hs)) as [X Y]. specialize (N s Hs).
    eapply rder_eq. rd. exact N. unfold v in *. pose proof (nrm_sq (vx s) (vy s)). set (n := nrm (vx s) (vy s)) in *.
    field_simplify_eq; [ | exact N ]. replace (vy s ^ 2) with (n ^ 2 - vx s ^ 2) by lra. ring.
Qed.

(* (20), exactly: it comes to rest at T, not before, and stays *)
Let T := (lam * v 0 + vx 0) / (A * (lam ^ 2 - 1)).
Lemma vx_le t : Rabs (vx t) <= v t.
Proof. unfold v, nrm. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. pose proof (pow2_ge_0 (vy t)). lra. Qed.
Lemma v0_cases t : v t = 0 -> vx t = 0 /\ vy t = 0.
Proof. intros e. apply sq_sum. rewrite <- nrm_sq. fold (v t). rewrite e. lra. Qed.

Theorem eq20 : 1 < lam -> (forall t, 0 <= t < T -> v t <> 0) /\ (forall t, T <= t -> 0 <= t -> v t = 0).
Proof.
  intros h1. assert (hk : 0 <= A * lam) by nra. assert (hd : 0 < A * (lam ^ 2 - 1)) by nra.
  assert (hT : A * (lam ^ 2 - 1) * T = lam * v 0 + vx 0) by (unfold T; field; split; nra).
  assert (stay : forall s, 0 <= s -> v s = 0 -> forall t, s <= t -> v t = 0).
  { intros s Hs e t Hst. destruct (v0_cases _ e) as [e1 e2].
    destruct (rest_lasts _ _ _ _ _ s hk M Hs) with (t := t) as [g1 g2]; trivial.
    - intros _ _. unfold nrm. replace ((- A) ^ 2 + 0 ^ 2) with (Rsqr A) by (unfold Rsqr; ring). rewrite sqrt_Rsqr; nra.
    - unfold v, nrm. rewrite g1, g2. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. apply sqrt_0. }
  (* the first moment of rest within [0, t], if any, is T *)
  assert (slip : forall t, 0 <= t -> v t <> 0 -> lam * v t + vx t = A * (lam ^ 2 - 1) * (T - t) /\ 0 < v t).
  { intros t Ht N. split.
    - rewrite (eq14 t Ht); [ lra | ]. intros s Hs e. apply N. apply (stay s); lra.
    - pose proof (nrm_pos (vx t) (vy t)). fold (v t) in *. lra. }
  split; intros t Ht.
  - intros e.
    assert (E : lam * v 0 + vx 0 + (lam ^ 2 - 1) * A * 0 <= lam * v t + vx t + (lam ^ 2 - 1) * A * t).
    { apply Ropp_le_cancel. apply (rder_decr (fun t => - (lam * nrm (vx t) (vy t) + vx t + (lam ^ 2 - 1) * A * t))); [ lra | | ]; intros s Hs.
      - apply continuity_pt_opp. cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) | apply (m_cx _ _ _ _ _ M) ]; lra.
      - destruct (Req_dec (v s) 0) as [z | z].
        + exists (- ((lam ^ 2 - 1) * A)). split; [ | nra ]. exists (fun t => - ((lam ^ 2 - 1) * A * t)). split. { auto_derive; [ trivial | ring ]. }
          intros r Hr. cbv beta. pose proof (stay s ltac:(lra) z r Hr) as er. fold (v r). rewrite er. destruct (v0_cases _ er) as [-> _]. inR. ring.
        + destruct (newton s ltac:(lra) z) as [X Y]. exists (- 0). split; [ | lra ].
          eapply rder_eq. rd. exact z. unfold v in *. pose proof (nrm_sq (vx s) (vy s)). set (n := nrm (vx s) (vy s)) in *.
          field_simplify_eq; [ | exact z ]. replace (vy s ^ 2) with (n ^ 2 - vx s ^ 2) by lra. ring. }
    rewrite e in E. destruct (v0_cases _ e) as [e1 _]. rewrite e1 in E. nra.
  - intros H0. destruct (Req_dec (v t) 0) as [z | z]; trivial. exfalso.
    destruct (slip t H0 z) as [e p]. pose proof (vx_le t). apply Rabs_le_between in H. nra.
Qed.

(* (10), in logarithms: no angle is needed *)
Lemma law10 t : 0 <= t -> (forall s, 0 <= s <= t -> 0 < vy s) ->
  ln (vy t) - lam * (ln (vy t) - ln (v t + vx t)) = ln (vy 0) - lam * (ln (vy 0) - ln (v 0 + vx 0)).
Proof.
  intros Ht P.
  assert (N : forall s, 0 <= s <= t -> 0 < v s /\ 0 < v s + vx s).
  { intros s Hs. specialize (P s Hs). unfold v. pose proof (nrm_pos (vx s) (vy s)). pose proof (nrm_sq (vx s) (vy s)). nra. }
  apply (rder_const (fun t => ln (vy t) - lam * (ln (vy t) - ln (nrm (vx t) (vy t) + vx t)))); trivial; intros s Hs;
    destruct (N s ltac:(lra)) as [n1 n2]; unfold v in *.
  - cont; try (apply P; lra); trivial; [ apply (m_cy _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) | apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) | apply (m_cx _ _ _ _ _ M) ]; lra.
  - destruct (newton s ltac:(lra) ltac:(unfold v; lra)) as [X Y]. specialize (P s ltac:(lra)). unfold v in *.
    eapply rder_eq. rd; trivial; lra. pose proof (nrm_sq (vx s) (vy s)). set (n := nrm (vx s) (vy s)) in *.
    field_simplify_eq; [ | repeat split; lra ]. replace (vy s ^ 2) with (n ^ 2 - vx s ^ 2) by lra. ring.
Qed.
End Constant.
