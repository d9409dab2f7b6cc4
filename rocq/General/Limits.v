(* Large times: v_perp -> 0 in a straight bounded drive; (18), (19) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Constant.
Open Scope R_scope.

(* a square below c exp(- g t) goes to zero *)
Lemma lim_of_bound f (c : R) (B : R -> R) : 0 <= c -> (forall t, 0 <= t -> f t ^ 2 * B t <= c) -> 
  (forall K, exists T, 0 <= T /\ forall t, T <= t -> K <= B t) -> is_lim f p_infty 0.
Proof.
  intros Hc H HB. apply is_lim_spec. intros eps. destruct (HB (c / eps ^ 2 + 1)) as (T & T0 & HT).
  exists T. intros t Ht. rewrite Rminus_0_r. specialize (H t ltac:(lra)). specialize (HT t ltac:(lra)).
  pose proof (cond_pos eps) as ep. set (e := pos eps) in *. apply Rnot_le_lt. intros K.
  assert (e ^ 2 <= f t ^ 2) by (rewrite <- (pow2_abs (f t)); apply pow_incr; lra).
  assert (0 < e ^ 2) by nra. assert (0 <= c / e ^ 2) by (apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]).
  assert (e ^ 2 * (c / e ^ 2 + 1) = c + e ^ 2) by (field; lra). nra.
Qed.

Section Across.
Variables (k a : R) (Ax vx vy : R -> R).
Hypothesis hk : 0 < k.
Hypothesis ha : 0 < a.
Hypothesis hA : forall t, 0 <= t -> Rabs (Ax t) <= a.
Hypothesis M : motion k Ax (fun _ => 0) vx vy.
Let S0 := sqrt (vx 0 ^ 2 + vy 0 ^ 2 + 1).
Ltac conts := cont; first [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.

Lemma S0_pos : 1 <= S0.
Proof. unfold S0. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt. pose proof (pow2_ge_0 (vx 0)). pose proof (pow2_ge_0 (vy 0)). lra. Qed.
Lemma speed_bound t : 0 <= t -> nrm (vx t) (vy t) <= S0 + a * t.
Proof.
  intros Ht. set (D t := vx t ^ 2 + vy t ^ 2 + 1).
  assert (Dp : forall s, 1 <= D s) by (intros s; unfold D; pose proof (pow2_ge_0 (vx s)); pose proof (pow2_ge_0 (vy s)); lra).
  apply Rle_trans with (sqrt (D t)). { unfold nrm, D. apply sqrt_le_1_alt. lra. }
  enough (sqrt (D t) - a * t <= sqrt (D 0) - a * 0) by (unfold D, S0 in *; lra).
  apply (rder_decr (fun t => sqrt (D t) - a * t)); trivial; intros s Hs.
  - apply (continuity_pt_minus (fun t => sqrt (D t)) (fun t => a * t)); [ | cont ].
    apply (continuity_pt_comp D sqrt). unfold D. conts. apply continuity_pt_sqrt. specialize (Dp s). lra.
  - destruct (m_law _ _ _ _ _ M s) as (fx & fy & [B P] & X & Y); [ lra | ].
    assert (DD : rder D s (2 * (vx s * (fx - Ax s) + vy s * fy))) by (eapply rder_eq; [ unfold D; rd | simpl; ring ]).
    assert (q : 0 < sqrt (D s)) by (apply sqrt_lt_R0; specialize (Dp s); lra).
    eexists. split. apply (rder_minus (fun t => sqrt (D t)) (fun t => a * t)); [ | rd ].
    apply (rder_comp D sqrt). exact DD. apply is_derive_Reals, derivable_pt_lim_sqrt. specialize (Dp s); lra.
    simpl. assert (vx s * (fx - Ax s) + vy s * fy <= a * sqrt (D s)).
    { assert (Rabs (vx s) <= sqrt (D s)). { rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold D, Rsqr. pose proof (pow2_ge_0 (vy s)). lra. }
      specialize (hA s ltac:(lra)). pose proof (nrm_pos (vx s) (vy s)). assert (- (Ax s * vx s) <= a * sqrt (D s)).
      { apply Rle_trans with (Rabs (Ax s * vx s)). rewrite <- Rabs_Ropp. apply Rle_abs. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. } nra. }
    replace (/ (2 * sqrt (D s)) * (2 * (vx s * (fx - Ax s) + vy s * fy))) with ((vx s * (fx - Ax s) + vy s * fy) / sqrt (D s)) by (field; lra).
    assert ((vx s * (fx - Ax s) + vy s * fy) / sqrt (D s) <= a) by (apply Rle_div_l; lra). lra.
Qed.

(* s2-perpendicular-decays with a rate: v_perp falls at least as fast as t^(-k/a) *)
Theorem across_rate t : 0 <= t -> vy t ^ 2 * Rpower (S0 + a * t) (2 * k / a) <= vy 0 ^ 2 * Rpower (S0 + a * 0) (2 * k / a).
Proof.
  intros Ht. pose proof S0_pos. unfold Rpower.
  apply (rder_decr (fun t => vy t ^ 2 * exp (2 * k / a * ln (S0 + a * t)))); trivial; intros s Hs.
  - assert (0 < S0 + a * s) by nra. cont; trivial. apply (m_cy _ _ _ _ _ M); lra.
  - destruct (m_law _ _ _ _ _ M s) as (fx & fy & C & X & Y); [ lra | ].
    assert (p : 0 < S0 + a * s) by nra. pose proof (speed_bound s ltac:(lra)).
    eexists. split. rd. trivial. cbv beta. set (E := exp _). assert (0 < E) by apply exp_pos.
    set (L := S0 + a * s) in *. destruct (coulomb_slip _ _ _ _ _ (Rlt_le _ _ hk) C) as [_ e].
    pose proof (nrm_sq (vx s) (vy s)). pose proof (nrm_pos (vx s) (vy s)). set (n := nrm (vx s) (vy s)) in *.
    assert (K : vy s * fy + k * vy s ^ 2 / L <= 0).
    { destruct H3 as [n0 | n0].
      - apply (Rmult_le_reg_l n); trivial. replace (n * (vy s * fy + k * vy s ^ 2 / L)) with (vy s * (n * fy) + k * vy s ^ 2 * (n / L)) by (field; lra).
        rewrite e. assert (n / L <= 1) by (apply Rle_div_l; lra). pose proof (pow2_ge_0 (vy s)). assert (0 <= k * vy s ^ 2) by nra. nra.
      - assert (vy s = 0) as -> by nra. unfold Rdiv. lra. }
    match goal with |- ?g <= 0 => replace g with (2 * E * (vy s * fy + k * vy s ^ 2 / L)) end. nra.
    simpl. field. lra.
Qed.
Theorem across_vanishes : is_lim vy p_infty 0.
Proof.
  pose proof S0_pos as s1. assert (h : 0 < 2 * k / a) by (apply Rdiv_lt_0_compat; lra).
  apply (lim_of_bound vy (vy 0 ^ 2 * Rpower (S0 + a * 0) (2 * k / a)) (fun t => Rpower (S0 + a * t) (2 * k / a))).
  - apply Rmult_le_pos. apply pow2_ge_0. left. apply exp_pos.
  - intros t Ht. apply across_rate; trivial.
  - intros K. exists (exp (Rabs K / (2 * k / a)) / a). split. apply Rmult_le_pos; [ left; apply exp_pos | left; now apply Rinv_0_lt_compat ].
    intros t Ht. apply Rle_trans with (Rabs K); [ apply Rle_abs | ].
    assert (exp (Rabs K / (2 * k / a)) <= S0 + a * t). { apply (Rmult_le_compat_l a) in Ht; [ | lra ]. replace (a * (exp (Rabs K / (2 * k / a)) / a)) with (exp (Rabs K / (2 * k / a))) in Ht by (field; lra). lra. }
    unfold Rpower. pose proof (exp_pos (Rabs K / (2 * k / a))). assert (Rabs K / (2 * k / a) <= ln (S0 + a * t)).
    { rewrite <- (ln_exp (Rabs K / (2 * k / a))). apply Rcomplements.ln_le; trivial. }
    assert (Rabs K <= 2 * k / a * ln (S0 + a * t)). { apply (Rmult_le_compat_l (2 * k / a)) in H1; [ | lra ]. replace (2 * k / a * (Rabs K / (2 * k / a))) with (Rabs K) in H1 by (field; lra). exact H1. }
    pose proof (exp_ineq1_le (2 * k / a * ln (S0 + a * t))). lra.
Qed.
End Across.
