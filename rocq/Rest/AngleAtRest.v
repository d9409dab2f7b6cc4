(* psi in the last moments before a rest: with k = sigma/(1 - sigma), alpha dpsi/dalpha = k psi - 2 k alpha up to (alpha + |psi|)^3, so that psi
   less its particular solution, over alpha^k, converges: (143). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas TableLaws TableAngle Fate Alpha Stops Late Thin Near Arrives.
Open Scope R_scope.

Section Angle.
Variables (A al psi : R -> R) (sigma s T : R).
Hypothesis inside : 0 < sigma < 1.
Hypothesis V : arrives sigma s T A al psi.
Let sT := v_time _ _ _ _ _ _ V.
Let lA := v_A _ _ _ _ _ _ V.
Let lal := v_al _ _ _ _ _ _ V.
Let lpsi := v_psi _ _ _ _ _ _ V.
Notation dal t := (eq114_alpha_rate (A t) (al t) (psi t)).
Notation dpsi t := (eq115_psi_rate (al t) (psi t)).
Notation k := (sigma / (1 - sigma)).

Lemma k_pos : 0 < k. Proof. apply Rdiv_lt_0_compat; lra. Qed.
Lemma k_is : eq140_alpha_rate sigma = - / k. Proof. unfold eq140_alpha_rate. field. lra. Qed.
(* the equation (143) solves, and what it leaves out *)
Definition left_out t := al t * dpsi t - dal t * (k * psi t - 2 * k * al t).
Lemma left_out_small : exists C, 0 < C /\ soon T (fun t => Rabs (left_out t) <= C * (al t + Rabs (psi t)) ^ 3).
Proof.
  pose proof k_pos as k0. set (c1 := Rabs (sigma / (sigma - 1) / 2) + 1). set (c2 := 1 + 4 / sigma + 2 * c1 / sigma ^ 2).
  assert (c10 : 0 < c1) by (unfold c1; pose proof (Rabs_pos (sigma / (sigma - 1) / 2)); lra).
  assert (i0 : 0 < / sigma) by (apply Rinv_0_lt_compat; lra). assert (i2 : 0 < / sigma ^ 2) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (c20 : 0 < c2) by (unfold c2, Rdiv; nra). exists (9 + 2 * k * c2). split. nra.
  pose proof (soon_and _ _ _ (al_soon A al psi sigma s T V) (soon_near _ _ _ (/ 2) lal ltac:(lra))) as S1.
  pose proof (soon_and _ _ _ S1 (soon_near _ _ _ (sigma / 2) lA ltac:(lra))) as S2.
  pose proof (soon_and _ _ _ S2 (soon_near _ _ _ 1 (A_limit A al psi sigma s T inside V) Rlt_0_1)) as S3.
  revert S3. apply soon_imp. intros t (((a0 & a1) & HA) & HQ). rewrite Rminus_0_r in a1. apply Rabs_def2 in a1. apply Rabs_def2 in HA.
  set (a := al t) in *. set (z := psi t) in *.
  assert (dA : Rabs (A t - sigma) <= c1 * a ^ 2).
  { assert (p : 0 < a ^ 2) by (apply pow_lt; lra). replace (A t - sigma) with ((A t - sigma) / a ^ 2 * a ^ 2) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (a ^ 2)) by lra.
    apply Rmult_le_compat_r. lra. unfold c1. pose proof (Rabs_triang_inv ((A t - sigma) / a ^ 2) (sigma / (sigma - 1) / 2)). lra. }
  set (de := dal t + / k).
  assert (Hde : Rabs de <= c2 * (a ^ 2 + Rabs z ^ 2)).
  { unfold de, eq114_alpha_rate. fold a z. destruct (hyp_small a ltac:(lra)) as (_ & e2 & _ & h2 & _ & ec). rewrite ec.
    replace (cos z - (1 + a ^ 2 * e2) / A t + / k) with (cos z - 1 + (- (a ^ 2 * e2 / A t) + (A t - sigma) * / (sigma * A t))) by (field;
    repeat split; lra).
    pose proof (cos_quadratic z) as q. rewrite <- (pow2_abs z) in q. assert (iA : 0 < / A t <= 2 * / sigma).
    { split. apply Rinv_0_lt_compat; lra. replace (2 * / sigma) with (/ (sigma / 2)) by (field; lra). apply Rinv_le_contravar; lra. }
    pose proof (pow2_ge_0 a) as p. assert (b1 : Rabs (- (a ^ 2 * e2 / A t)) <= 4 / sigma * a ^ 2).
    { rewrite Rabs_Ropp, Rabs_pos_eq. unfold Rdiv. assert (e2 * / A t <= 2 * (2 * / sigma)) by (apply Rmult_le_compat; lra). nra.
      apply Rmult_le_pos; [ apply Rmult_le_pos; lra | lra ]. }
    assert (b2 : Rabs ((A t - sigma) * / (sigma * A t)) <= 2 * c1 / sigma ^ 2 * a ^ 2).
    { rewrite Rabs_mult, (Rabs_pos_eq (/ _)). 2: left; apply Rinv_0_lt_compat; nra.
    replace (2 * c1 / sigma ^ 2 * a ^ 2) with (c1 * a ^ 2 * (/ sigma * (2 * / sigma))) by (field; lra).
      apply Rmult_le_compat; trivial. apply Rabs_pos. left; apply Rinv_0_lt_compat; nra. rewrite Rinv_mult_distr by lra.
      apply Rmult_le_compat_l; lra. }
    pose proof (Rabs_triang (cos z - 1) (- (a ^ 2 * e2 / A t) + (A t - sigma) * / (sigma * A t))) as t1.
    pose proof (Rabs_triang (- (a ^ 2 * e2 / A t)) ((A t - sigma) * / (sigma * A t))) as t2. pose proof (pow2_ge_0 (Rabs z)) as z2.
    unfold c2. assert (0 <= 4 / sigma * Rabs z ^ 2) by (apply Rmult_le_pos; [ unfold Rdiv; lra | trivial ]).
    assert (0 <= 2 * c1 / sigma ^ 2 * Rabs z ^ 2) by (apply Rmult_le_pos; [ unfold Rdiv; nra | trivial ]). lra. }
  unfold left_out. rewrite turning by trivial. replace (dal t) with (de - / k) by (unfold de; ring). fold a z. clearbody de.
  pose proof (sin_cubic z) as s3. pose proof (sin_abs z) as s1. pose proof (hcoth_near a ltac:(lra)) as hh. set (H := hcoth a) in *.
  set (v := sin z) in *. set (m := Rabs z) in *.
  assert (m0 : 0 <= m) by apply Rabs_pos.
  match goal with |- Rabs ?g <= _ => replace g with ((z - v) + (- ((H - 1) * v) + - (de * (k * (z - 2 * a))))) by (field; lra) end.
  assert (b1 : Rabs (- ((H - 1) * v)) <= 8 * a ^ 2 * m) by (rewrite Rabs_Ropp, Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  assert (b2 : Rabs (- (de * (k * (z - 2 * a)))) <= c2 * (a ^ 2 + m ^ 2) * (k * (m + 2 * a))).
  { rewrite Rabs_Ropp, Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. rewrite Rabs_mult, (Rabs_pos_eq k) by lra.
  apply Rmult_le_compat_l; [ lra | ].
    pose proof (Rabs_triang z (- (2 * a))) as q. rewrite Rabs_Ropp, (Rabs_pos_eq (2 * a)) in q by lra. exact q. }
  eapply Rle_trans; [ apply Rabs_triang | ]. eapply Rle_trans; [ apply Rplus_le_compat; [ exact s3 | eapply Rle_trans;
  [ apply Rabs_triang | apply Rplus_le_compat; [ exact b1 | exact b2 ] ] ] | ].
  assert (x1 : 0 <= a ^ 2 * m) by (apply Rmult_le_pos; [ apply pow2_ge_0 | trivial ]).
  assert (x2 : 0 <= a * m ^ 2) by (apply Rmult_le_pos; [ lra | apply pow2_ge_0 ]).
  assert (x3 : 0 <= a ^ 3) by (apply pow_le; lra). assert (x4 : 0 <= m ^ 3) by (apply pow_le; lra).
  assert (y1 : m ^ 3 + 8 * a ^ 2 * m <= 9 * (a + m) ^ 3) by (replace ((a + m) ^ 3) with (a ^ 3 + 3 * (a ^ 2 * m) + 3 * (a * m ^ 2) + m ^ 3) by ring;
  lra).
  assert (y2 : (a ^ 2 + m ^ 2) * (m + 2 * a) <= 2 * (a + m) ^ 3).
  { replace ((a ^ 2 + m ^ 2) * (m + 2 * a)) with (2 * a ^ 3 + a ^ 2 * m + 2 * (a * m ^ 2) + m ^ 3) by ring.
    replace ((a + m) ^ 3) with (a ^ 3 + 3 * (a ^ 2 * m) + 3 * (a * m ^ 2) + m ^ 3) by ring. lra. }
  assert (y3 : c2 * k * ((a ^ 2 + m ^ 2) * (m + 2 * a)) <= c2 * k * (2 * (a + m) ^ 3)) by (apply Rmult_le_compat_l; nra). lra.
Qed.

(* psi is small of the order alpha^q, for every q < k not above 1 *)
Lemma psi_order q : 0 < q < k -> q <= 1 -> exists M, 0 < M /\ soon T (fun t => Rabs (psi t) <= M * Rpower (al t) q).
Proof.
  intros Hq q1. pose proof k_pos as k0. destruct left_out_small as (C & C0 & HC). set (g := (k - q) / (4 * k)).
  assert (g0 : 0 < g) by (apply Rdiv_lt_0_compat; lra).
  assert (gk : g * (4 * k) = k - q) by (unfold g; field; repeat split; lra). assert (g1 : g <= / 4) by nra.
  pose proof (soon_and _ _ _ HC (soon_near _ _ _ 1 lal Rlt_0_1)) as S1.
  pose proof (soon_and _ _ _ S1 (soon_near _ _ _ (Rmin 1 (g / (8 * C))) lpsi ltac:(apply Rmin_pos; [ lra | apply Rdiv_lt_0_compat; lra ]))) as S2.
  pose proof (soon_and _ _ _ S2 (soon_near _ _ _ (/ (2 * k)) (dal_limit A al psi sigma s T inside V) ltac:(apply Rinv_0_lt_compat; lra))) as S3.
  destruct (soon_from s T _ sT S3) as (s' & Hs & H).
  set (W t := psi t ^ 2 * Rpower (al t) (- (2 * q))). set (M := Rmax (W s') ((/ g) ^ 2)). assert (Mg : (/ g) ^ 2 <= M) by apply Rmax_r.
  assert (MW : W s' <= M) by apply Rmax_l.
  assert (M0 : 0 < M) by (eapply Rlt_le_trans; [ apply pow_lt, Rinv_0_lt_compat, g0 | exact Mg ]).
  assert (low : forall t, s' <= t < T -> W t - M <= 0).
  { intros t Ht. apply (barrier (fun t => W t - M) s' t); try lra; intros r Hr; destruct (v_pos _ _ _ _ _ _ V r ltac:(lra)) as [_ a0].
    - destruct (v_cont _ _ _ _ _ _ V r ltac:(lra)) as (_ & c2 & c3). unfold W. pose proof (cont_power al (- (2 * q)) r c2 a0). contq.
    - destruct (v_rate _ _ _ _ _ _ V r ltac:(lra)) as (_ & d2 & d3). destruct (H r ltac:(lra)) as (((lo & a1) & z1) & l1).
      eexists. split. { apply (rder_minus W (fun _ => M)); [ | apply rder_fixed ]. apply (rder_mult (fun t => psi t ^ 2)).
      apply (rder_pow psi 2 _ _ d3). apply (rder_power al _ _ _ d2 a0). }
      rewrite Rminus_0_r in a1, z1. rewrite k_is in l1. apply Rabs_def2 in l1. simpl INR. simpl pred. rewrite pow_1. unfold W. unfold left_out in lo.
      set (d := dal r) in *. set (z' := dpsi r) in *. set (a := al r) in *. set (z := psi r) in *. set (P := Rpower a (- (2 * q))).
      assert (P0 : 0 < P) by apply power_pos. rewrite (Rabs_pos_eq a) in a1 by lra.
      replace (Rpower a (- (2 * q) - 1)) with (P / a).
      2: { unfold Rminus. rewrite Rpower_plus. fold P. unfold Rdiv. f_equal. rewrite Rpower_Ropp, Rpower_1; trivial. }
      intros big. assert (W1 : (/ g) ^ 2 <= z ^ 2 * P) by lra. set (m := Rabs z) in *. assert (m0 : 0 <= m) by apply Rabs_pos.
      assert (zz : z ^ 2 = m ^ 2) by (unfold m; now rewrite pow2_abs).
      set (L := a * z' - d * (k * z - 2 * k * a)) in *. pose proof (Rmin_l 1 (g / (8 * C))). pose proof (Rmin_r 1 (g / (8 * C))).
      match goal with |- ?v <= 0 => replace v with (2 * (P / a) * (z * L - (- d) * (4 * k * (g * z ^ 2) - 2 * k * (a * z)))) by (unfold L, g; field;
      repeat split; lra) end.
      enough (z * L - (- d) * (4 * k * (g * z ^ 2) - 2 * k * (a * z)) <= 0). { assert (0 < P / a) by (apply Rdiv_lt_0_compat; trivial). nra. }
      assert (b1 : a <= g * m).
      { assert (Pa : P * a ^ 2 <= 1). { replace (a ^ 2) with (Rpower a 2) by (rewrite <- Rpower_pow by trivial; reflexivity). unfold P.
      rewrite <- Rpower_plus. apply power_one; lra. }
        assert (1 <= g ^ 2 * (m ^ 2 * P)). { rewrite <- zz. replace 1 with (g ^ 2 * (/ g) ^ 2) by (field; lra).
        apply Rmult_le_compat_l; [ apply pow2_ge_0 | trivial ]. }
        assert (a ^ 2 <= (g * m) ^ 2). { apply Rle_trans with (g ^ 2 * (m ^ 2 * P) * a ^ 2). pose proof (pow2_ge_0 a). nra.
        replace (g ^ 2 * (m ^ 2 * P) * a ^ 2) with ((g * m) ^ 2 * (P * a ^ 2)) by ring. pose proof (pow2_ge_0 (g * m)). nra. }
        assert (0 <= g * m) by nra. nra. }
      assert (am : a <= m) by nra. assert (b2 : z * L <= g * m ^ 2).
      { eapply Rle_trans; [ apply Rle_abs | ]. rewrite Rabs_mult. fold m. assert (c3 : C * (a + m) ^ 3 <= C * (2 * m) ^ 3) by (apply
      Rmult_le_compat_l; [ lra | apply pow_incr; lra ]).
        assert (8 * C * m <= g). { apply Rle_trans with (8 * C * (g / (8 * C))). apply Rmult_le_compat_l; lra. right. field. lra. }
        assert (mm : 0 <= m ^ 2) by apply pow2_ge_0. apply Rle_trans with (m * (C * (2 * m) ^ 3)). apply Rmult_le_compat_l; lra.
        replace (m * (C * (2 * m) ^ 3)) with (8 * C * m * m * m ^ 2) by ring. apply Rmult_le_compat_r; nra. }
      assert (b3 : 2 * k * (g * m ^ 2) <= 4 * k * (g * z ^ 2) - 2 * k * (a * z)). { rewrite zz. pose proof (Rle_abs z) as zm. fold m in zm.
      assert (a * z <= g * m ^ 2) by nra. nra. }
      assert (dd : / (2 * k) <= - d). { replace (/ k) with (/ (2 * k) + / (2 * k)) in l1 by (field; lra). lra. }
      assert (b4 : / (2 * k) * (2 * k * (g * m ^ 2)) <= (- d) * (4 * k * (g * z ^ 2) - 2 * k * (a * z))).
      { apply Rmult_le_compat; trivial. left; apply Rinv_0_lt_compat; lra. apply Rmult_le_pos; [ lra | apply Rmult_le_pos;
      [ lra | apply pow2_ge_0 ] ]. }
      replace (/ (2 * k) * (2 * k * (g * m ^ 2))) with (g * m ^ 2) in b4 by (field; lra). lra. }
  exists (M + 1). split. lra. apply (soon_after s'); [ lra | ]. intros t Ht. specialize (low t Ht).
  destruct (v_pos _ _ _ _ _ _ V t ltac:(lra)) as [_ a0]. unfold W in low.
  set (P := Rpower (al t) q). assert (P0 : 0 < P) by apply power_pos. assert (e1 : Rpower (al t) (- (2 * q)) * P ^ 2 = 1).
  { unfold P. rewrite power_sq, <- Rpower_plus by trivial. replace (- (2 * q) + 2 * q) with 0 by ring. now apply Rpower_O. }
  apply abs_of_sq. nra. apply Rle_trans with (M * P ^ 2); [ | pose proof (pow2_ge_0 P); nra ].
  apply Rle_trans with (psi t ^ 2 * Rpower (al t) (- (2 * q)) * P ^ 2). right. rewrite Rmult_assoc, e1. ring. apply Rmult_le_compat_r.
  apply pow2_ge_0. lra.
Qed.
(* for k > 1/3 what (142) leaves out tends to zero as it stands *)
Lemma psi_law_plain : / 4 < sigma -> left_lim (fun t => eq142_left sigma (dpsi t / dal t) - eq142_right (al t) (psi t)) T 0.
Proof.
  intros s4. pose proof k_pos as k0. assert (k3 : / 3 < k) by (apply Rlt_div_r; lra). set (q := Rmin 1 ((k + / 3) / 2)).
  assert (Hq : / 3 < q < k /\ q <= 1) by (unfold q, Rmin; destruct (Rle_dec 1 ((k + / 3) / 2)); lra).
  destruct (psi_order q ltac:(lra) ltac:(lra)) as (M & M0 & HM). destruct left_out_small as (C & C0 & HC).
  pose proof (soon_and _ _ _ (al_soon A al psi sigma s T V) (soon_near _ _ _ 1 lal Rlt_0_1)) as S1.
  pose proof (soon_near _ _ _ (/ (2 * k)) (dal_limit A al psi sigma s T inside V) ltac:(apply Rinv_0_lt_compat; lra)) as S2.
  apply (ll_squeeze _ (fun t => 2 * C * (1 + M) ^ 3 * Rpower (al t) (3 * q - 1))).
  - generalize (soon_and _ _ _ (soon_and _ _ _ S1 S2) (soon_and _ _ _ HM HC)). apply soon_imp. intros t (((a0 & a1) & l1) & hM & hC).
    rewrite Rminus_0_r, Rabs_pos_eq in a1 by lra. rewrite k_is in l1. apply Rabs_def2 in l1. unfold left_out in hC. set (d := dal t) in *.
    set (a := al t) in *. set (lo := a * eq115_psi_rate a (psi t) - _) in *. set (P := Rpower a q) in *.
    assert (kk : / k = / (2 * k) + / (2 * k)) by (field; lra). assert (i0 : 0 < / (2 * k)) by (apply Rinv_0_lt_compat; lra).
    assert (d0 : 0 < / (2 * k) < - d) by lra.
    replace (eq142_left sigma (eq115_psi_rate a (psi t) / d) - eq142_right a (psi t)) with (lo * (/ a * (/ k * / - d))).
    2: { unfold lo, eq142_left, eq142_right. field. repeat split; lra. }
    assert (id : 0 < / - d < 2 * k).
    { split. apply Rinv_0_lt_compat; lra. rewrite <- (Rinv_involutive (2 * k)) by lra. apply Rinv_lt_contravar; [ apply Rmult_lt_0_compat | ]; lra. }
    assert (ik : 0 < / k * / - d <= 2).
    { assert (0 < / k) by (apply Rinv_0_lt_compat; lra). split. apply Rmult_lt_0_compat; lra. replace 2 with (/ k * (2 * k)) by (field; lra).
      apply Rmult_le_compat_l; lra. }
    assert (ia : 0 < / a) by now apply Rinv_0_lt_compat.
    assert (size : Rabs lo <= C * ((1 + M) ^ 3 * Rpower a (3 * q))).
    { eapply Rle_trans; [ exact hC | ]. apply Rmult_le_compat_l; [ lra | ]. rewrite <- power_cube, <- Rpow_mult_distr by trivial.
      pose proof (power_le a q 1 ltac:(lra) ltac:(lra)) as e. rewrite Rpower_1 in e by trivial. fold P in e. pose proof (Rabs_pos (psi t)).
      apply pow_incr. fold P. lra. }
    rewrite Rabs_mult, (Rabs_pos_eq (/ a * _)) by (apply Rmult_le_pos; lra).
    apply Rle_trans with (C * ((1 + M) ^ 3 * Rpower a (3 * q)) * (/ a * 2)).
    apply Rmult_le_compat; [ apply Rabs_pos | apply Rmult_le_pos; lra | trivial | apply Rmult_le_compat_l; lra ].
    right. unfold Rminus. rewrite Rpower_plus, Rpower_Ropp, Rpower_1 by trivial. ring.
  - eapply ll_eq. apply (ll_mult (fun _ => 2 * C * (1 + M) ^ 3)); [ apply ll_const | ].
    apply (ll_power al T (3 * q - 1) (al_soon A al psi sigma s T V) lal). lra. ring.
Qed.
(* psi over alpha^k, less that of a solution, converges *)
Lemma converges q G : (forall a, 0 < a -> is_derive G a (- (2 * k * Rpower a (- k)))) -> q <= 1 -> k < 3 * q ->
  (exists M, 0 < M /\ soon T (fun t => Rabs (psi t) <= M * Rpower (al t) q)) ->
  exists c D, 0 < D /\ soon T (fun t => Rabs (psi t * Rpower (al t) (- k) - G (al t) - c) <= D * Rpower (al t) (3 * q - k)).
Proof.
  intros HG q1 qk (M & M0 & HM). destruct left_out_small as (C & C0 & HC). pose proof k_pos as k0.
  pose proof (soon_and _ _ _ (al_soon A al psi sigma s T V) (soon_near _ _ _ 1 lal Rlt_0_1)) as S1.
  pose proof (soon_and _ _ _ (soon_and _ _ _ S1 (soon_and _ _ _ HM HC)) (soon_near _ _ _ (/ (2 * k)) (dal_limit A al psi sigma s T inside V)
  ltac:(apply Rinv_0_lt_compat; lra))) as S2.
  destruct (soon_from s T _ sT S2) as (s' & Hs & H). set (b := 3 * q - k). assert (b0 : 0 < b) by (unfold b; lra).
  set (L := C * (1 + M) ^ 3). assert (L0 : 0 < L) by (apply Rmult_lt_0_compat; trivial; apply pow_lt; lra). set (D := 2 * k * L / b).
  assert (D0 : 0 < D) by (apply Rdiv_lt_0_compat; nra).
  set (Z t := psi t * Rpower (al t) (- k) - G (al t)).
  assert (cZ : forall t, s' <= t < T -> continuity_pt Z t /\ continuity_pt (fun t => Rpower (al t) b) t).
  { intros t Ht. destruct (v_cont _ _ _ _ _ _ V t ltac:(lra)) as (_ & c2 & c3). destruct (v_pos _ _ _ _ _ _ V t ltac:(lra)) as [_ a0].
  split; [ | now apply cont_power ].
    unfold Z. apply (continuity_pt_minus (fun t => psi t * Rpower (al t) (- k)) (fun t => G (al t))). pose proof (cont_power al (- k) t c2 a0). contq.
    apply (continuity_pt_comp al G); trivial. apply (cont_of _ _ _ (HG _ a0)). }
  assert (rZ : forall t, s' <= t < T -> exists l m, rder Z t l /\ rder (fun t => Rpower (al t) b) t m /\ l + D * m <= 0 /\ 0 <= l - D * m).
  { intros t Ht. destruct (v_rate _ _ _ _ _ _ V t ltac:(lra)) as (_ & d2 & d3). destruct (H t Ht) as (((a0 & a1) & (hM & hC)) & l1).
  rewrite k_is in l1. apply Rabs_def2 in l1.
    eexists _, _. split; [ | split ].
    - apply (rder_minus (fun t => psi t * Rpower (al t) (- k)) (fun t => G (al t))).
      apply (rder_mult psi); [ exact d3 | exact (rder_power al _ _ _ d2 a0) ]. exact (rder_comp al G _ _ _ d2 (HG _ a0)).
    - exact (rder_power al b _ _ d2 a0).
    - rewrite Rminus_0_r, Rabs_pos_eq in a1 by lra. unfold left_out in *. set (d := dal t) in *. set (a := al t) in *. set (Q := Rpower a (- k)).
      set (B := Rpower a (b - 1)). assert (B0 : 0 < B) by apply power_pos. assert (Q0 : 0 < Q) by apply power_pos.
      replace (Rpower a (- k - 1)) with (Q / a). 2: { unfold Rminus. rewrite Rpower_plus. fold Q. unfold Rdiv. f_equal.
      rewrite Rpower_Ropp, Rpower_1; trivial. }
      match goal with |- ?g + _ <= 0 /\ _ => replace g with ((a * eq115_psi_rate a (psi t) - d * (k * psi t - 2 * k * a)) * (Q / a)) by (field;
      lra) end.
      set (lo := a * eq115_psi_rate a (psi t) - _) in *.
      assert (size : Rabs (lo * (Q / a)) <= L * B).
      { rewrite Rabs_mult, (Rabs_pos_eq (Q / a)) by (left; now apply Rdiv_lt_0_compat).
      apply Rle_trans with (C * ((1 + M) * Rpower a q) ^ 3 * (Q / a)).
        - apply Rmult_le_compat_r. left; now apply Rdiv_lt_0_compat. eapply Rle_trans; [ exact hC | ]. apply Rmult_le_compat_l; [ lra | ].
          apply pow_incr. pose proof (Rabs_pos (psi t)).
          pose proof (power_le a q 1 ltac:(lra) q1) as e. rewrite Rpower_1 in e by trivial. split; lra.
        - right. rewrite Rpow_mult_distr, power_cube by trivial. replace B with (Rpower a (3 * q) * (Q / a)). unfold L. ring.
          unfold B, b, Q, Rdiv. rewrite <- (Rpower_1 a) at 3 by trivial. rewrite <- Rpower_Ropp, <- !Rpower_plus. f_equal. ring. }
      apply Rabs_le_between in size. assert (dd : d <= - / (2 * k)). { replace (/ k) with (/ (2 * k) + / (2 * k)) in l1 by (field; lra). lra. }
      assert (D * (b * B * d) <= - (L * B)). { replace (- (L * B)) with (D * (b * B * (- / (2 * k)))) by (unfold D; field; lra).
      apply Rmult_le_compat_l; [ lra | ]. apply Rmult_le_compat_l; nra. }
      split; lra. }
  assert (down : forall r t, s' <= r <= t -> t < T -> Z t + D * Rpower (al t) b <= Z r + D * Rpower (al r) b).
  { intros r t Hr Ht. apply (rder_decr (fun t => Z t + D * Rpower (al t) b)); [ lra | | ]; intros v Hv. destruct (cZ v ltac:(lra)). contq.
    destruct (rZ v ltac:(lra)) as (l & m & h1 & h2 & h3 & h4). eexists. split.
    apply (rder_plus Z); [ exact h1 | apply (rder_mult (fun _ => D)); [ apply rder_fixed | exact h2 ] ]. lra. }
  assert (up : forall r t, s' <= r <= t -> t < T -> Z r - D * Rpower (al r) b <= Z t - D * Rpower (al t) b).
  { intros r t Hr Ht. apply Ropp_le_cancel. apply (rder_decr (fun t => - (Z t - D * Rpower (al t) b))); [ lra | | ]; intros v Hv.
  destruct (cZ v ltac:(lra)). contq.
    destruct (rZ v ltac:(lra)) as (l & m & h1 & h2 & h3 & h4). eexists. split.
    apply (rder_opp (fun t => Z t - D * Rpower (al t) b)), (rder_minus Z); [ exact h1 | apply (rder_mult (fun _ => D));
    [ apply rder_fixed | exact h2 ] ]. lra. }
  assert (P : forall t, 0 < D * Rpower (al t) b) by (intros t; apply Rmult_lt_0_compat; [ trivial | apply power_pos ]).
  destruct (ll_mono (fun t => Z t - D * Rpower (al t) b) s' T (Z s' + D * Rpower (al s') b)) as (c & lc & hc); [ lra | exact up | | ].
  { intros t Ht. pose proof (down s' t ltac:(lra) ltac:(lra)). specialize (P t). lra. }
  exists c, D. split; trivial. apply (soon_after s'); [ lra | ]. intros t Ht. specialize (hc t Ht). apply Rabs_le. fold (Z t). split; [ | lra ].
  enough (c <= Z t + D * Rpower (al t) b) by lra. apply (ll_le _ _ _ t _ lc); [ lra | ]. intros r Hr. pose proof (down t r ltac:(lra) ltac:(lra)).
  pose proof (P r). lra.
Qed.
Lemma first_order_q : k < 3 -> let q := 2 * k / (k + 3) in 0 < q < k /\ q <= 1 /\ k < 3 * q.
Proof.
  intros k3 q. pose proof k_pos. assert (e : q * (k + 3) = 2 * k) by (unfold q; field; lra). assert (q0 : 0 < q) by (apply Rdiv_lt_0_compat; lra).
  clearbody q. set (kk := k) in *. repeat split; nra.
Qed.
(* (143): the difference is of the order of (alpha + alpha^k)^3 *)
Lemma psi_solution : / 4 < sigma < 3 / 4 -> sigma <> / 2 -> exists c D, 0 < D /\
  soon T (fun t => Rabs (psi t - eq143_psi sigma c (al t)) <= D * Rpower (al t) (3 * Rmin 1 k)).
Proof.
  intros Hs ne. pose proof k_pos as k0. assert (kb : / 3 < k < 3). { split; [ apply Rlt_div_r | apply Rlt_div_l ]; lra. }
  assert (k1 : k <> 1). { intros z. apply ne. assert (z' : k * (1 - sigma) = 1 * (1 - sigma)) by now rewrite z. unfold Rdiv in z'.
  rewrite Rmult_assoc, Rinv_l in z' by lra. lra. }
  set (m := 2 * k / (k - 1)). set (G a := m * Rpower a (1 - k)).
  assert (HG : forall a, 0 < a -> is_derive G a (- (2 * k * Rpower a (- k)))).
  { intros a a0. replace (- (2 * k * Rpower a (- k))) with (m * ((1 - k) * Rpower a (1 - k - 1))).
    apply (is_derive_scal (fun a => Rpower a (1 - k)) a m). apply is_derive_Reals, derivable_pt_lim_power, a0.
    replace (1 - k - 1) with (- k) by ring. unfold m. field_simplify_eq; [ ring | ].
    split. intros z. apply k1. lra. lra. }
  destruct (first_order_q ltac:(lra)) as (h1 & h2 & h3). cbv zeta in h1, h2, h3.
  destruct (converges _ G HG h2 h3 (psi_order _ h1 h2)) as (c & D & D0 & B). set (mu := Rmin 1 k). assert (m1 : mu <= 1) by apply Rmin_l.
  assert (m2 : mu <= k) by apply Rmin_r.
  assert (m3 : k < 3 * mu) by (unfold mu, Rmin; destruct (Rle_dec 1 k); lra). 
  pose proof (soon_and _ _ _ (al_soon A al psi sigma s T V) (soon_near _ _ _ 1 lal Rlt_0_1)) as S1.
  assert (back : forall t, 0 < al t -> Rpower (al t) (- k) * Rpower (al t) k = 1 /\ G (al t) * Rpower (al t) k = m * al t).
  { intros t a0. split. rewrite <- Rpower_plus. replace (- k + k) with 0 by ring. now apply Rpower_O. unfold G. rewrite Rmult_assoc, <- Rpower_plus.
  replace (1 - k + k) with 1 by ring. now rewrite Rpower_1. }
  assert (O : exists M, 0 < M /\ soon T (fun t => Rabs (psi t) <= M * Rpower (al t) mu)).
  { exists (Rabs m + Rabs c + D). split. pose proof (Rabs_pos m). pose proof (Rabs_pos c). lra. generalize (soon_and _ _ _ S1 B). apply soon_imp.
  intros t ((a0 & a1) & h). rewrite Rminus_0_r, Rabs_pos_eq in a1 by lra.
    destruct (back t a0) as [e1 e2]. set (P := Rpower (al t) k) in *. assert (P0 : 0 < P) by apply power_pos.
    set (X := psi t * Rpower (al t) (- k) - G (al t) - c) in *.
    assert (e : psi t = m * al t + (X + c) * P). { transitivity (psi t * (Rpower (al t) (- k) * P)). rewrite e1. ring. unfold X. rewrite <- e2. ring.
    }
    pose proof (power_le (al t) mu 1 ltac:(lra) m1) as p1. rewrite Rpower_1 in p1 by trivial. pose proof (power_le (al t) mu k ltac:(lra) m2) as p2.
    fold P in p2.
    pose proof (power_one (al t) (3 * (2 * k / (k + 3)) - k) ltac:(lra) ltac:(lra)) as p3. set (Q := Rpower (al t) mu) in *.
    assert (hX : Rabs X <= D) by (eapply Rle_trans; [ exact h | ]; nra). rewrite e. eapply Rle_trans; [ apply Rabs_triang | ].
    rewrite !Rabs_mult, (Rabs_pos_eq (al t)), (Rabs_pos_eq P) by lra.
    pose proof (Rabs_triang X c). pose proof (Rabs_pos m). pose proof (Rabs_pos (X + c)).
    assert (Rabs m * al t <= Rabs m * Q) by (apply Rmult_le_compat_l; lra).
    assert (Rabs (X + c) * P <= (D + Rabs c) * Q) by (apply Rmult_le_compat; lra). lra. }
  destruct (converges _ G HG m1 m3 O) as (c' & D' & D0' & B'). exists (c' / 2), D'. split; trivial. generalize (soon_and _ _ _ S1 B').
  apply soon_imp. intros t ((a0 & a1) & h).
  destruct (back t a0) as [e1 e2]. set (P := Rpower (al t) k) in *. assert (P0 : 0 < P) by apply power_pos.
  assert (eP : al t * Rpower (al t) ((2 * sigma - 1) / (1 - sigma)) = P). { unfold P. rewrite <- (Rpower_1 (al t)) at 1 by trivial.
  rewrite <- Rpower_plus. f_equal. field. lra. }
  replace (psi t - eq143_psi sigma (c' / 2) (al t)) with ((psi t * Rpower (al t) (- k) - G (al t) - c') * P).
  - rewrite Rabs_mult, (Rabs_pos_eq P) by lra. apply Rle_trans with (D' * Rpower (al t) (3 * mu - k) * P). apply Rmult_le_compat_r; lra.
    right. unfold P. rewrite Rmult_assoc, <- Rpower_plus. do 2 f_equal. ring.
  - unfold eq143_psi. transitivity (psi t * (Rpower (al t) (- k) * P) - G (al t) * P - c' * P). ring. rewrite e1, e2.
    transitivity (psi t - 2 * (sigma / (2 * sigma - 1)) * al t - c' * (al t * Rpower (al t) ((2 * sigma - 1) / (1 - sigma)))); [ | field; lra ].
    rewrite eP. unfold m. field. repeat split; lra.
Qed.
(* at sigma = 1/2 *)
Lemma psi_one_half : sigma = / 2 -> exists c D, 0 < D /\ soon T (fun t => Rabs (psi t - right_rest_psi_at_one_half c (al t)) <= D * Rpower (al t) (3
  / 2)).
Proof.
  intros h. assert (k1 : k = 1) by (rewrite h; field). destruct (first_order_q ltac:(lra)) as (h1 & h2 & h3). cbv zeta in h1, h2, h3.
  assert (HG : forall a, 0 < a -> is_derive (fun a => - (2 * ln a)) a (- (2 * k * Rpower a (- k)))).
  { intros a a0. rewrite k1. rewrite Rpower_Ropp, Rpower_1 by trivial. auto_derive; trivial. ring. }
  destruct (converges _ _ HG h2 h3 (psi_order _ h1 h2)) as (c & D & D0 & B). exists (c / 2), D. split; trivial.
  generalize (soon_and _ _ _ (al_soon A al psi sigma s T V) B). apply soon_imp. intros t (a0 & b). rewrite k1 in b.
  rewrite Rpower_Ropp, Rpower_1 in b by trivial.
  replace (psi t - right_rest_psi_at_one_half (c / 2) (al t)) with ((psi t * / al t - - (2 * ln (al t)) - c) * al t) by (unfold
  right_rest_psi_at_one_half; field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (al t)) by lra. apply Rle_trans with (D * Rpower (al t) (3 * (2 * 1 / (1 + 3)) - 1) * al t).
  apply Rmult_le_compat_r; lra.
  right. rewrite <- (Rpower_1 (al t)) at 2 by trivial. rewrite Rmult_assoc, <- Rpower_plus. do 2 f_equal. field.
Qed.
End Angle.
