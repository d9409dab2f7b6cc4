(* Section 4, from Newton's law (89) with rest *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

(* (89): position (x, y), velocity (u, w) on a table that turns; the friction has the size 1 *)
Record spin (x y u w : R -> R) : Prop := {
  s_cx : forall t, 0 < t -> continuity_pt x t;  s_cy : forall t, 0 < t -> continuity_pt y t;
  s_cu : forall t, 0 < t -> continuity_pt u t;  s_cw : forall t, 0 < t -> continuity_pt w t;
  s_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, coulomb 1 (u t) (w t) fx fy /\
            rder u t (x t + 2 * w t + fx) /\ rder w t (y t - 2 * u t + fy) }.

Section Turntable.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation xi t := ((x t * u t + y t * w t) / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) / nrm (u t) (w t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).

Ltac conts := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

(* (103), at rest too *)
Theorem eq103 t : 0 <= t -> rder (fun t => (u t ^ 2 + w t ^ 2 - (x t ^ 2 + y t ^ 2)) * / 2) t (- p t).
Proof.
  intros Ht. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & [B P] & U & W).
  eapply rder_eq. rd. simpl. lra.
Qed.

(* (99), (100), (101), (108) while it slips *)
Lemma slip t : 0 <= t -> p t <> 0 -> rder x t (u t) /\ rder y t (w t) /\
  rder u t (x t + 2 * w t - u t / p t) /\ rder w t (y t - 2 * u t - w t / p t).
Proof.
  intros Ht N. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W).
  destruct (coulomb_slip _ _ _ _ _ Rle_0_1 C) as [e1 e2]. repeat split; trivial; (eapply rder_eq; [ eassumption | ]).
  - replace fx with (nrm (u t) (w t) * fx / nrm (u t) (w t)) by (field; trivial). rewrite e1. field. trivial.
  - replace fy with (nrm (u t) (w t) * fy / nrm (u t) (w t)) by (field; trivial). rewrite e2. field. trivial.
Qed.
Ltac byslip t Ht N n e := destruct (slip t Ht N) as (X & Y & U & W); pose proof (nrm_sq (u t) (w t)) as e;
  eapply rder_eq; [ rd; exact N | ]; set (n := nrm (u t) (w t)) in *; inR; field_simplify_eq; [ | trivial ].
Theorem eq99 t : 0 <= t -> p t <> 0 -> rder (fun t => p t) t (xi t - 1).
Proof. intros Ht N. byslip t Ht N n e. replace (w t ^ 2) with (n ^ 2 - u t ^ 2) by lra. ring. Qed.

(* the A of (113) never decreases: E = A^2 *)
Theorem A_never_falls s t : 0 <= s <= t -> E s <= E t.
Proof.
  intros Hst. apply Ropp_le_cancel. apply (rder_decr (fun t => - E t)); [ lra | | ]; intros r Hr.
  - conts.
  - destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ].
    eexists. split. rd. simpl. pose proof (nrm_pos (u r) (w r)). lra.
Qed.

(* s4-escape-if-A-above-1: the particle leaves every circle for good *)
Theorem escape : 1 < E 0 -> forall M, exists t0, 0 <= t0 /\ forall t, t0 <= t -> M < x t ^ 2 + y t ^ 2.
Proof.
  intros h M.
  (* it is enough that E exceeds M once *)
  enough (exists t0, 0 <= t0 /\ M < E t0) as (t0 & h0 & h1).
  { exists t0. split; trivial. intros t Ht. pose proof (A_never_falls t0 t ltac:(lra)). pose proof (pow2_ge_0 (u t)). pose proof (pow2_ge_0 (w t)). lra. }
  assert (grow : forall t, 0 <= t -> E 0 <= E t) by (intros; apply A_never_falls; lra).
  assert (rho1 : forall t, 0 <= t -> E 0 <= rho t ^ 2 /\ 1 < rho t).
  { intros t Ht. specialize (grow t Ht). pose proof (nrm_sq (x t) (y t)). pose proof (nrm_pos (x t) (y t)).
    pose proof (pow2_ge_0 (u t)). pose proof (pow2_ge_0 (w t)). split; nra. }
  assert (far : forall t, 0 <= t -> rho t - E t / 2 <= rho 0 - E 0 / 2).
  { intros t Ht. apply (rder_decr (fun t => rho t - E t * / 2)); trivial; intros r Hr.
    - conts.
    - destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ].
      destruct (rho1 r ltac:(lra)). eexists. split. rd. lra. simpl.
      pose proof (power_bound (p r) (u r) (w r) (- x r) (- y r) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q.
      assert (en : nrm (- x r) (- y r) = rho r) by (unfold nrm; f_equal; ring). rewrite en in Q.
      assert ((x r * u r + y r * w r) / rho r <= p r) by (apply Rle_div_l; lra). lra. }
  destruct (Classical_Prop.classic (exists t0, 0 <= t0 /\ M < E t0)) as [ok | no]; [ exact ok | exfalso ].
  assert (below : forall t, 0 <= t -> E t <= M) by (intros t Ht; apply Rnot_lt_le; intros k; apply no; eauto).
  set (c := rho 0 - E 0 / 2 + M / 2). 
  assert (near : forall t, 0 <= t -> rho t <= c) by (intros t Ht; specialize (far t Ht); specialize (below t Ht); unfold c; lra).
  set (r0 := sqrt (E 0)). set (d := r0 ^ 2 - r0).
  assert (hs : 1 < r0) by (unfold r0; rewrite <- sqrt_1; apply sqrt_lt_1_alt; lra).
  assert (hq : r0 ^ 2 = E 0) by (unfold r0; rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra).
  assert (hd : 0 < d) by (unfold d; nra).
  set (G t := x t * u t + y t * w t + c * E t).
  assert (up : forall t, 0 <= t -> G 0 + d * t <= G t).
  { intros t Ht. enough (- G t + d * t <= - G 0 + d * 0) by lra. unfold G.
    apply (rder_decr (fun t => - (x t * u t + y t * w t + c * E t) + d * t)); trivial; intros r Hr.
    - conts.
    - destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ].
      destruct (rho1 r ltac:(lra)) as [r1 r2]. pose proof (near r ltac:(lra)) as rc.
      eexists. split. rd. simpl.
      pose proof (power_bound 1 fx fy (x r) (y r) Rle_0_1 B) as Q1.
      pose proof (power_bound (p r) (- w r) (u r) (y r) (x r) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q2.
      pose proof (power_bound (p r) (w r) (- u r) (x r) (y r) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q2'.
      pose proof (nrm_sq (u r) (w r)) as e1. pose proof (nrm_sq (x r) (y r)) as e2. pose proof (nrm_pos (u r) (w r)).
      assert (r0 <= rho r) by (unfold r0; rewrite <- (sqrt_pow2 (rho r)) by lra; apply sqrt_le_1_alt; lra).
      assert (d <= rho r ^ 2 - rho r) by (unfold d; nra).
      assert (0 <= p r * (c - rho r)) by nra. 
      set (n := p r) in *. set (m := rho r) in *. clear - Q1 Q2 Q2' e1 e2 H H0 H1 H2 P. nra. }
  assert (low : forall t, 0 <= t -> G t <= c ^ 2 + c * M).
  { intros t Ht. unfold G. destruct (rho1 t Ht) as [r1 r2]. specialize (near t Ht). specialize (below t Ht).
    pose proof (power_bound (p t) (u t) (w t) (- x t) (- y t) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q.
    assert (en : nrm (- x t) (- y t) = rho t) by (unfold nrm; f_equal; ring). rewrite en in Q.
    pose proof (grow t Ht). pose proof (nrm_sq (u t) (w t)) as e1. pose proof (nrm_sq (x t) (y t)) as e2. pose proof (nrm_pos (u t) (w t)).
    assert (p t <= rho t) by nra. nra. }
  set (t1 := Rmax 0 ((c ^ 2 + c * M - G 0) / d + 1)).
  pose proof (Rmax_l 0 ((c ^ 2 + c * M - G 0) / d + 1)). pose proof (Rmax_r 0 ((c ^ 2 + c * M - G 0) / d + 1)). fold t1 in H, H0.
  specialize (up t1 H). specialize (low t1 H).
  assert (d * ((c ^ 2 + c * M - G 0) / d + 1) <= d * t1) by (apply Rmult_le_compat_l; lra).
  replace (d * ((c ^ 2 + c * M - G 0) / d + 1)) with (c ^ 2 + c * M - G 0 + d) in H1 by (field; lra). lra.
Qed.
End Turntable.
