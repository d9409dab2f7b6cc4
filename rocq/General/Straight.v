(* Drives along the x-axis: the velocity across dies out (with a rate), a drive that stays above k by a margin speeds the particle up,
   one that stays above k without a margin need not. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
From Slipbook.General Require Import Rates Contraction Exists.
Open Scope R_scope.

Section Straight.
Variables (k : R) (Ax vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis M : motion k Ax (fun _ => 0) vx vy.
Notation v t := (nrm (vx t) (vy t)).
(* the rate of vy^2, slipping or not *)
Lemma across_force s : 0 <= s -> exists lx ly, rder vx s lx /\ rder vy s ly /\ Rabs (lx + Ax s) <= k /\ v s * ly = - k * vy s /\ vy s * ly <= 0.
Proof.
  intros Hs. destruct (m_law _ _ _ _ _ M s Hs) as (fx & fy & C & X & Y). destruct (coulomb_slip _ _ _ _ _ hk C) as [_ e].
  exists (fx - Ax s), (fy - 0). split; trivial. split; trivial. split; [ | split ].
  - destruct C as [B _]. replace (fx - Ax s + Ax s) with fx by ring. apply Rabs_le. pose proof (pow2_ge_0 fy). split; nra.
  - lra.
  - destruct (nrm_pos (vx s) (vy s)) as [p | p].
    + apply (Rmult_le_reg_l (v s)); trivial. replace (v s * (vy s * (fy - 0))) with (vy s * (v s * fy)) by ring. rewrite e. pose proof (pow2_ge_0 (vy s)). nra.
    + destruct (nrm_zero _ _ (eq_sym p)) as [_ ->]. lra.
Qed.
Theorem across_falls s t : 0 <= s <= t -> vy t ^ 2 <= vy s ^ 2.
Proof.
  intros Hst. apply (rder_decr (fun t => vy t ^ 2)); [ lra | | ]; intros u Hu.
  - cont.
  - destruct (across_force u) as (lx & ly & _ & Y & _ & _ & P); [ lra | ]. eexists. split. rd. simpl. lra.
Qed.
Theorem across_falls_strictly s t : 0 < k -> 0 <= s < t -> vy s <> 0 -> vy t ^ 2 < vy s ^ 2.
Proof.
  intros k0 Hst N. destruct (across_force s) as (lx & ly & _ & Y & _ & e & _); [ lra | ].
  assert (n0 : 0 < v s). { destruct (nrm_pos (vx s) (vy s)) as [p | p]; trivial. destruct (nrm_zero _ _ (eq_sym p)). lra. }
  assert (q : 0 < vy s ^ 2) by (destruct (Rdichotomy _ _ N); nra).
  assert (D : rder (fun t => vy t ^ 2) s (2 * (vy s * ly))) by (eapply rder_eq; [ rd | simpl; ring ]).
  destruct (rder_falls _ _ _ D) as (d & d0 & Hd).
  - assert (vy s * ly < 0); [ | lra ]. apply (Rmult_lt_reg_l (v s)); trivial. replace (v s * (vy s * ly)) with (vy s * (v s * ly)) by ring. rewrite e. nra.
  - assert (p : 0 < Rmin d (t - s)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (t - s)). pose proof (Rmin_r d (t - s)). set (h := Rmin d (t - s) / 2) in *.
    specialize (Hd h ltac:(unfold h; lra)). cbv beta in Hd. pose proof (across_falls (s + h) t ltac:(unfold h; lra)). lra.
Qed.

(* a bounded drive: v_perp falls as t^(-k/a), at least *)
Section Bounded.
Variable a : R.
Hypothesis ha : 0 < a.
Hypothesis hA : forall t, 0 <= t -> Rabs (Ax t) <= a.
Let S0 := v 0 + 1.
Lemma speed_bound t : 0 <= t -> v t <= S0 + a * t.
Proof.
  intros Ht. set (D t := vx t ^ 2 + vy t ^ 2 + 1).
  assert (Dp : forall s, 1 <= D s) by (intros s; unfold D; pose proof (pow2_ge_0 (vx s)); pose proof (pow2_ge_0 (vy s)); lra).
  assert (b0 : sqrt (D 0) <= S0). { unfold S0. pose proof (nrm_pos (vx 0) (vy 0)). pose proof (nrm_sq (vx 0) (vy 0)). rewrite <- (sqrt_pow2 (v 0 + 1)) by lra. apply sqrt_le_1_alt. unfold D. nra. }
  apply Rle_trans with (sqrt (D t)). { unfold nrm, D. apply sqrt_le_1_alt. lra. }
  enough (sqrt (D t) - a * t <= sqrt (D 0) - a * 0) by lra.
  apply (rder_decr (fun t => sqrt (D t) - a * t)); trivial; intros s Hs.
  - apply (continuity_pt_minus (fun t => sqrt (D t)) (fun t => a * t)); [ | cont ]. apply (continuity_pt_comp D sqrt).
    unfold D. cont. apply continuity_pt_sqrt. specialize (Dp s). lra.
  - destruct (m_law _ _ _ _ _ M s) as (fx & fy & [B P] & X & Y); [ lra | ].
    assert (DD : rder D s (2 * (vx s * (fx - Ax s) + vy s * fy))) by (eapply rder_eq; [ unfold D; rd | simpl; ring ]).
    assert (q : 0 < sqrt (D s)) by (apply sqrt_lt_R0; specialize (Dp s); lra).
    eexists. split. apply (rder_minus (fun t => sqrt (D t)) (fun t => a * t)); [ | rd ].
    apply (rder_comp D sqrt). exact DD. apply is_derive_Reals, derivable_pt_lim_sqrt. specialize (Dp s); lra.
    cbv beta. set (m := vx s * (fx - Ax s) + vy s * fy). replace (/ (2 * sqrt (D s)) * (2 * m)) with (m / sqrt (D s)) by (field; lra).
    enough (m / sqrt (D s) <= a) by lra. apply Rle_div_l; trivial. 
    assert (v s <= sqrt (D s)) by (unfold nrm, D; apply sqrt_le_1_alt; lra). pose proof (nrm_pos (vx s) (vy s)).
    pose proof (dot_abs (Ax s) 0 (vx s) (vy s)) as Q. specialize (hA s ltac:(lra)).
    assert (nrm (Ax s) 0 <= a). { eapply Rle_trans; [ apply nrm_abs | rewrite Rabs_R0; lra ]. }
    apply Rabs_le_between in Q. unfold m. nra.
Qed.
Theorem across_rate t : 0 <= t -> vy t ^ 2 * Rpower (S0 + a * t) (2 * k / a) <= vy 0 ^ 2 * Rpower (S0 + a * 0) (2 * k / a).
Proof.
  intros Ht. assert (S1 : 1 <= S0) by (unfold S0; pose proof (nrm_pos (vx 0) (vy 0)); lra). unfold Rpower.
  apply (rder_decr (fun t => vy t ^ 2 * exp (2 * k / a * ln (S0 + a * t)))); trivial; intros s Hs.
  - assert (0 < S0 + a * s) by nra. cont; trivial.
  - destruct (across_force s) as (lx & ly & _ & Y & _ & e & _); [ lra | ].
    assert (p : 0 < S0 + a * s) by nra. pose proof (speed_bound s ltac:(lra)) as b.
    eexists. split. rd. trivial. cbv beta. set (E := exp _). assert (0 < E) by apply exp_pos.
    set (L := S0 + a * s) in *. pose proof (nrm_pos (vx s) (vy s)) as [n0 | n0].
    + set (n := v s) in *. assert (K : vy s * ly + k * vy s ^ 2 / L <= 0).
      { apply (Rmult_le_reg_l n); trivial. replace (n * (vy s * ly + k * vy s ^ 2 / L)) with (vy s * (n * ly) + k * vy s ^ 2 * (n / L)) by (field; lra).
        rewrite e. assert (n / L <= 1) by (apply Rle_div_l; lra). assert (0 <= k * vy s ^ 2) by (apply Rmult_le_pos; [ | apply pow2_ge_0 ]; trivial). nra. }
      match goal with |- ?g <= 0 => replace g with (2 * E * (vy s * ly + k * vy s ^ 2 / L)) end. nra. simpl. field. lra.
    + destruct (nrm_zero _ _ (eq_sym n0)) as [_ ->]. simpl. lra.
Qed.
Theorem across_vanishes : 0 < k -> is_lim vy p_infty 0.
Proof.
  intros k0. assert (h : 0 < 2 * k / a) by (apply Rdiv_lt_0_compat; lra). assert (S1 : 1 <= S0) by (unfold S0; pose proof (nrm_pos (vx 0) (vy 0)); lra).
  apply (lim_of_bound vy (vy 0 ^ 2 * Rpower (S0 + a * 0) (2 * k / a)) (fun t => Rpower (S0 + a * t) (2 * k / a))).
  - apply Rmult_le_pos. apply pow2_ge_0. left. apply exp_pos.
  - intros t Ht. apply across_rate; trivial.
  - intros K. destruct (grows_line a S0 (exp (Rabs K / (2 * k / a))) ha) as (T & T0 & HT). exists T. split; trivial. intros t Ht. specialize (HT t Ht).
    apply Rle_trans with (Rabs K); [ apply Rle_abs | ]. unfold Rpower. pose proof (exp_pos (Rabs K / (2 * k / a))).
    assert (L : Rabs K / (2 * k / a) <= ln (S0 + a * t)) by (rewrite <- (ln_exp (Rabs K / (2 * k / a))); now apply Rcomplements.ln_le).
    apply Rle_div_l in L; trivial. pose proof (exp_ineq1_le (2 * k / a * ln (S0 + a * t))). lra.
Qed.
End Bounded.

(* a drive towards +x above k + delta: the speed grows at delta / 2 from some time on *)
Theorem speeds_up delta : 0 < delta -> (forall t, 0 <= t -> k + delta <= - Ax t) -> exists T, 0 <= T /\ forall s t, T <= s <= t -> v s + delta / 2 * (t - s) <= v t.
Proof.
  intros hd hA. assert (G : forall t, 0 <= t -> vx 0 + delta * t <= vx t).
  { intros t Ht. enough (- vx t + delta * t <= - vx 0 + delta * 0) by lra. apply (rder_decr (fun t => - vx t + delta * t)); trivial; intros s Hs.
    - cont.
    - destruct (across_force s) as (lx & ly & X & _ & b & _); [ lra | ]. apply Rabs_le_between in b. specialize (hA s ltac:(lra)). eexists. split. rd. lra. }
  set (Y := Rabs (vy 0)). assert (Y0 : 0 <= Y) by apply Rabs_pos. set (B := (2 * k / delta + 1) * Y + 1).
  assert (kd : 0 <= 2 * k / delta) by (apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]).
  destruct (grows_line delta (vx 0) B hd) as (T & T0 & HT). exists T. split; trivial. intros s t Hst.
  enough (- v t + delta / 2 * t <= - v s + delta / 2 * s) by lra. apply (rder_decr (fun t => - v t + delta / 2 * t)); [ lra | | ]; intros u Hu.
  - cont.
  - specialize (HT u ltac:(lra)). specialize (G u ltac:(lra)). specialize (hA u ltac:(lra)). pose proof (across_falls 0 u ltac:(lra)) as F.
    assert (y1 : Rabs (vy u) <= Y). { unfold Y. apply Rsqr_le_abs_0. unfold Rsqr. lra. } assert (0 <= 2 * k / delta * Y) by now apply Rmult_le_pos.
    assert (x1 : 1 <= vx u) by (unfold B in HT; lra). pose proof (nrm_abs (vx u) (vy u)) as nb. rewrite (Rabs_pos_eq (vx u)) in nb by lra.
    destruct (abs_nrm (vx u) (vy u)) as [na _]. rewrite (Rabs_pos_eq (vx u)) in na by lra.
    pose proof (speed_rate k Ax (fun _ => 0) vx vy hk M u ltac:(lra) ltac:(lra)) as S. cbv beta in S. eexists. split. rds.
    set (n := v u) in *. assert (K : (k + delta / 2) * n <= (k + delta) * vx u).
    { assert ((k + delta / 2) * n <= (k + delta / 2) * (vx u + Y)) by (apply Rmult_le_compat_l; lra).
      assert (B * (delta / 2) = (k + delta / 2) * Y + delta / 2) by (unfold B; field; lra). assert (delta / 2 * B <= delta / 2 * vx u) by (apply Rmult_le_compat_l; lra). lra. }
    assert (k + delta / 2 <= (k + delta) * (vx u / n)). { replace ((k + delta) * (vx u / n)) with ((k + delta) * vx u / n) by (field; lra). apply Rle_div_r; lra. }
    assert (0 <= vx u / n) by (apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]).
    assert ((k + delta) * (vx u / n) <= - Ax u * (vx u / n)) by (apply Rmult_le_compat_r; trivial). lra.
Qed.
End Straight.

(* k = 1: under the drive -(1 + exp (-4 t) / 4), above k at all times, the motion that starts across it loses speed for ever *)
Theorem no_margin : exists vx vy, motion 1 (fun t => - (1 + exp (- (4) * t) / 4)) (fun _ => 0) vx vy /\ vx 0 = 0 /\ vy 0 = 1 /\
  forall s t, 0 <= s < t -> nrm (vx t) (vy t) < nrm (vx s) (vy s).
Proof.
  set (E t := exp (- (4) * t)). destruct (plane_has_a_motion 1 (fun t => - (1 + E t / 4)) (fun _ => 0) 0 1 Rle_0_1) as (vx & vy & M & x0 & y0).
  { intros t _. split; [ unfold E, Rdiv | ]; cont. }
  assert (dE : forall t, is_derive E t (- 4 * E t)) by (intros t; unfold E; auto_derive; trivial; ring). assert (E0 : E 0 = 1) by (unfold E; rewrite Rmult_0_r; apply exp_0).
  assert (Ep : forall t, 0 < E t) by (intros; apply exp_pos).
  exists vx, vy. split; [ exact M | ]. split; trivial. split; trivial. set (v t := nrm (vx t) (vy t)).
  assert (v0 : v 0 = 1) by (unfold v, nrm; rewrite x0, y0; replace (0 ^ 2 + 1 ^ 2) with 1 by ring; apply sqrt_1).
  assert (cv : forall t, 0 < t -> continuity_pt v t) by (intros t Ht; apply (speed_cont _ _ _ _ _ M t Ht)).
  assert (cE : forall t, continuity_pt E t) by (intros t; unfold E; cont).
  pose proof (m_cx _ _ _ _ _ M) as cx. pose proof (m_cy _ _ _ _ _ M) as cy.
  assert (C1 : forall t, 0 <= t -> 1 <= v t + vx t).
  { intros t Ht. enough (- (v t + vx t) <= - (v 0 + vx 0)) by lra. apply (rder_decr (fun t => - (v t + vx t))); trivial; intros s Hs.
    - specialize (cv s ltac:(lra)). specialize (cx s ltac:(lra)). cont.
    - specialize (Ep s). destruct (Req_dec (v s) 0) as [z | z].
      + destruct (rest_rates _ _ _ _ _ Rle_0_1 M s ltac:(lra) z) as (lx & ly & X & Y & N & _). destruct (across_force _ _ _ _ Rle_0_1 M s ltac:(lra)) as (mx & my & X' & _ & b & _).
        rewrite (rder_one _ _ _ _ X' X) in b. clear X'. cbv beta in b. apply Rabs_le_between in b. fold v in N. eexists. split. rd. pose proof (nrm_pos lx ly). lra.
      + destruct (slip_rates _ _ _ _ _ Rle_0_1 M s ltac:(lra) z) as [X _]. pose proof (speed_rate _ _ _ _ _ Rle_0_1 M s ltac:(lra) z) as N. fold v in N. cbv beta in N.
        eexists. split. rd. destruct (abs_nrm (vx s) (vy s)) as [ab _]. fold (v s) in *. apply Rabs_le_between in ab. pose proof (nrm_pos (vx s) (vy s)) as p. fold (v s) in p.
        assert (- (1) <= vx s / v s) by (apply Rle_div_r; lra). set (c := vx s / v s) in *. cbv beta.
        assert (0 <= E s * (1 + c)) by (apply Rmult_le_pos; lra). lra. }
  assert (half : forall t, 0 <= t -> 1 / 2 <= v t).
  { intros t Ht. specialize (C1 t Ht). destruct (abs_nrm (vx t) (vy t)) as [ab _]. fold (v t) in ab. apply Rabs_le_between in ab. lra. }
  assert (rates : forall s, 0 <= s -> rder vx s (1 + E s / 4 - vx s / v s) /\ rder vy s (- (vy s / v s)) /\ rder v s ((1 + E s / 4) * (vx s / v s) - 1)).
  { intros s Hs. specialize (half s Hs). destruct (slip_rates _ _ _ _ _ Rle_0_1 M s Hs ltac:(fold (v s); lra)) as [X Y]. pose proof (speed_rate _ _ _ _ _ Rle_0_1 M s Hs ltac:(fold (v s); lra)) as N.
    fold v in N. fold (v s) in X, Y, N. cbv beta in *. split; [ | split ]; (eapply rder_eq; [ eassumption | ring ]). }
  assert (C2 : forall t, 0 <= t -> v t + vx t <= 2).
  { intros t Ht. enough (v t + vx t + E t / 8 <= v 0 + vx 0 + E 0 / 8) by (specialize (Ep t); lra). apply (rder_decr (fun t => v t + vx t + E t / 8)); trivial; intros s Hs.
    - specialize (cv s ltac:(lra)). specialize (cx s ltac:(lra)). specialize (cE s). unfold Rdiv. cont.
    - destruct (rates s ltac:(lra)) as (X & _ & N). pose proof (rder_of _ _ _ (dE s)). unfold Rdiv at 1. eexists. split. rd. specialize (Ep s). specialize (half s ltac:(lra)).
      destruct (abs_nrm (vx s) (vy s)) as [ab _]. fold (v s) in ab. apply Rabs_le_between in ab.
      assert (vx s / v s <= 1) by (apply Rle_div_l; lra). set (c := vx s / v s) in *. assert (E s * c <= E s * 1) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Y1 : forall t, 0 <= t -> E t <= vy t ^ 2 <= 1).
  { intros t Ht. split; [ | pose proof (across_falls _ _ _ _ Rle_0_1 M 0 t ltac:(lra)) as F; rewrite y0 in F; lra ].
    assert (K : - (vy t ^ 2 * exp (4 * t)) <= - (vy 0 ^ 2 * exp (4 * 0))).
    { apply (rder_decr (fun t => - (vy t ^ 2 * exp (4 * t)))); trivial; intros s Hs. specialize (cy s ltac:(lra)). cont.
      destruct (rates s ltac:(lra)) as (_ & Y & _). eexists. split. rd. specialize (half s ltac:(lra)). cbv beta. pose proof (exp_pos (4 * s)). set (x := exp (4 * s)) in *.
      assert (i2 : / v s <= 2) by (rewrite <- (Rinv_inv 2); apply Rinv_le_contravar; lra). pose proof (pow2_ge_0 (vy s)).
      match goal with |- ?g <= 0 => replace g with (- (2 * vy s ^ 2 * x * (2 - / v s))) by (simpl; field; lra) end. assert (0 <= 2 * vy s ^ 2 * x) by (apply Rmult_le_pos; lra). nra. }
    rewrite y0, Rmult_0_r, exp_0 in K. assert (i : E t * exp (4 * t) = 1). { unfold E. rewrite <- exp_plus. replace (- (4) * t + 4 * t) with 0 by ring. apply exp_0. }
    apply (Rmult_le_reg_r (exp (4 * t))). apply exp_pos. lra. }
  intros s t Hst. fold (v t) (v s). 
  assert (K : v t + / 48 * - E t <= v s + / 48 * - E s).
  { apply (rder_decr (fun t => v t + / 48 * - E t)); [ lra | | ]; intros u Hu. specialize (cv u ltac:(lra)). specialize (cE u). cont.
    destruct (rates u ltac:(lra)) as (_ & _ & N). pose proof (rder_of _ _ _ (dE u)). eexists. split. rd. specialize (half u ltac:(lra)). specialize (C1 u ltac:(lra)). specialize (C2 u ltac:(lra)).
    destruct (Y1 u ltac:(lra)) as [l1 l2]. specialize (Ep u). pose proof (nrm_sq (vx u) (vy u)) as e. fold (v u) in e. set (n := v u) in *.
    assert (n32 : n <= 3 / 2) by nra. assert (q : vx u / n <= 1 - E u / 3). { apply Rle_div_l. lra. assert ((n - vx u) * 2 >= E u) by nra. nra. }
    destruct (Rle_lt_dec 0 (vx u / n)) as [p | p]. { assert (vx u / n <= 1) by lra. set (c := vx u / n) in *. assert (E u * c <= E u * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (E u * (vx u / n) <= 0) by nra. lra. }
  assert (E t < E s) by (unfold E; apply exp_increasing; lra). lra.
Qed.
