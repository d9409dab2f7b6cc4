(* psi with alpha held fixed: the ratio of sin ((psi - psi_1) / 2) to sin ((psi - psi_2) / 2) falls exactly as exp (- 2 t / sinh 2 alpha) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
Open Scope R_scope.

Section Frozen.
Variable al : R.
Hypothesis ha : 0 < al.
Notation psi1 := (eq124_psi1 al).
Notation psi2 := (eq125_psi2 al).
Notation T := (tanh (2 * al)).
Lemma double_pos : 0 < sinh (2 * al). Proof. rewrite <- sinh_0. apply sinh_lt. lra. Qed.
Lemma tanh_range : 0 < T < 1.
Proof.
  pose proof double_pos. pose proof (cosh_pos (2 * al)). unfold tanh. split. now apply Rdiv_lt_0_compat. apply Rlt_div_l; trivial.
  unfold sinh, cosh. pose proof (exp_pos (- (2 * al))). lra.
Qed.
Lemma psi1_spec : 0 < psi1 < PI / 2 /\ sin psi1 = T /\ cos psi1 = / cosh (2 * al).
Proof.
  pose proof tanh_range. pose proof (cosh_pos (2 * al)) as c0. unfold eq124_psi1. destruct (asin_range T); trivial.
  split; trivial. split; trivial. rewrite cos_asin_pow by lra.
  rewrite <- (sqrt_pow2 (/ cosh (2 * al))) by (left; now apply Rinv_0_lt_compat). f_equal. unfold tanh. field_simplify_eq; [ | lra ].
  pose proof (cosh2 (2 * al)). lra.
Qed.
Lemma rate_T a : eq115_psi_rate al a = 2 / T * (T - sin a).
Proof. pose proof double_pos. pose proof (cosh_pos (2 * al)). unfold eq115_psi_rate, coth, tanh. field. lra. Qed.
(* (115) is zero just where sin psi = tanh 2 alpha *)
Lemma stands a : eq115_psi_rate al a = 0 <-> sin a = T.
Proof.
  pose proof tanh_range. rewrite rate_T. split; [ | intros ->; ring ]. intros h. apply Rmult_integral in h as [h | h]; [ | lra ].
  assert (0 < 2 / T) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.

Variable psi : R -> R.
Hypothesis hc : forall t, 0 < t -> continuity_pt psi t.
Hypothesis hd : forall t, 0 <= t -> rder psi t (eq115_psi_rate al (psi t)).
Notation from1 t := (sin ((psi t - psi1) / 2)).
Notation from2 t := (sin ((psi t - psi2) / 2)).
Notation k := (2 / sinh (2 * al)).
Lemma rate_is t : eq115_psi_rate al (psi t) = 4 / T * from1 t * from2 t.
Proof.
  pose proof tanh_range. rewrite rate_T. destruct psi1_spec as (_ & e & _). rewrite <- e at 2. rewrite form4. change psi2 with (PI - psi1).
  replace ((psi t - (PI - psi1)) / 2) with (- (PI / 2 - (psi1 + psi t) / 2)) by field. rewrite sin_neg, sin_shift.
  replace ((psi1 - psi t) / 2) with (- ((psi t - psi1) / 2)) by field. rewrite sin_neg. field. lra.
Qed.
Lemma half_rate c t : 0 <= t -> rder (fun t => sin ((psi t - c) / 2)) t (2 / T * cos ((psi t - c) / 2) * from1 t * from2 t).
Proof.
  intros Ht. pose proof (hd t Ht) as D. rewrite rate_is in D. pose proof tanh_range. unfold Rdiv in *.
  eapply rder_eq; [ apply (rder_sin (fun t => (psi t - c) * / 2)); rd | cbv beta; field; lra ].
Qed.
Lemma half_cont c t : 0 < t -> continuity_pt (fun t => sin ((psi t - c) / 2)) t.
Proof. intros Ht. unfold Rdiv. apply (continuity_pt_comp (fun t => (psi t - c) * / 2) sin); [ cont | apply continuity_sin ]. Qed.
(* psi1 and psi2 lie apart *)
Lemma apart t : from2 t * cos ((psi t - psi1) / 2) - from1 t * cos ((psi t - psi2) / 2) = - / cosh (2 * al).
Proof.
  destruct psi1_spec as (_ & _ & <-). transitivity (sin ((psi t - psi2) / 2 - (psi t - psi1) / 2)). rewrite sin_minus; ring.
  change psi2 with (PI - psi1). replace (_ - _) with (- (PI / 2 - psi1)) by field. now rewrite sin_neg, sin_shift.
Qed.
Lemma ratio_falls t : 0 <= t -> from1 t * from2 0 * exp (k * t) = from1 0 * from2 t.
Proof.
  intros Ht. pose proof tanh_range as T0. pose proof double_pos as z0. pose proof (cosh_pos (2 * al)) as c0. apply Rminus_diag_uniq.
  set (h t := from1 t * from2 0 * exp (k * t) - from1 0 * from2 t). set (M := 4 / T). change (h t = 0).
  assert (D : forall s, 0 <= s -> rder h s (2 / T * from1 s * cos ((psi s - psi2) / 2) * h s)).
  { intros s Hs. pose proof (half_rate psi1 s Hs). pose proof (half_rate psi2 s Hs). unfold h at 1. eapply rder_eq. rds.
    unfold h. cbv beta. set (E := exp (k * s)). pose proof (apart s) as q. assert (w : k = 2 / T * / cosh (2 * al)) by (unfold tanh; field; lra).
    rewrite w. set (g := / cosh (2 * al)) in *. replace g with (from1 s * cos ((psi s - psi2) / 2) - from2 s * cos ((psi s - psi1) / 2)) by lra.
    ring. }
  assert (K : h t ^ 2 * exp (- M * t) <= h 0 ^ 2 * exp (- M * 0)).
  { apply (rder_decr (fun t => h t ^ 2 * exp (- M * t))); trivial; intros s Hs.
    - pose proof (half_cont psi1 s ltac:(lra)). pose proof (half_cont psi2 s ltac:(lra)). unfold h. cont.
    - specialize (D s ltac:(lra)). eexists. split. rd. cbv beta. simpl pred. simpl INR. pose proof (exp_pos (- M * s)). set (E := exp _) in *.
      pose proof (SIN_bound ((psi s - psi1) / 2)). pose proof (COS_bound ((psi s - psi2) / 2)). set (a := from1 s) in *. set (c := cos _) in *.
      replace (_ + _) with (M * (a * c - 1) * (h s ^ 2 * E)) by (unfold M; field; lra). assert (0 < M) by (apply Rdiv_lt_0_compat; lra).
      assert (a * c <= 1) by nra. pose proof (pow2_ge_0 (h s)).
      enough (0 <= M * (1 - a * c) * (h s ^ 2 * E)) by lra. apply Rmult_le_pos; apply Rmult_le_pos; lra. }
  replace (h 0) with 0 in K by (unfold h; rewrite Rmult_0_r, exp_0; ring). pose proof (exp_pos (- M * t)).
  assert (h t ^ 2 <= 0) by (apply (Rmult_le_reg_r (exp (- M * t))); lra). nra.
Qed.
Hypothesis away : from2 0 <> 0.
Lemma stays_away t : 0 <= t -> from2 t <> 0.
Proof.
  intros Ht z. pose proof (ratio_falls t Ht) as R. pose proof (apart t) as q. rewrite z, Rmult_0_r in R.
  apply Rmult_integral in R as [R | R]; [ | pose proof (exp_pos (k * t)); lra ]. apply Rmult_integral in R as [R | R]; [ | easy ].
  rewrite z, R in q. pose proof (Rinv_0_lt_compat _ (cosh_pos (2 * al))). lra.
Qed.
Lemma attracted : is_lim (fun t => from1 t) p_infty 0.
Proof.
  pose proof (pow2_gt_0 _ away) as b0. assert (k0 : 0 < 2 * k) by (pose proof (Rdiv_lt_0_compat 2 _ Rlt_0_2 double_pos); lra).
  apply (lim_of_bound _ (/ from2 0 ^ 2) (fun t => exp (2 * k * t))); [ left; now apply Rinv_0_lt_compat | | intros K; now apply grows_exp ].
  intros t Ht. replace (exp (2 * k * t)) with (exp (k * t) ^ 2) by (simpl; rewrite Rmult_1_r, <- exp_plus; f_equal; ring).
  apply (Rmult_le_reg_r (from2 0 ^ 2)); trivial. rewrite Rinv_l by lra.
  replace (from1 t ^ 2 * exp (k * t) ^ 2 * from2 0 ^ 2) with ((from1 t * from2 0 * exp (k * t)) ^ 2) by ring. rewrite (ratio_falls t Ht).
  pose proof (SIN_bound ((psi 0 - psi1) / 2)). pose proof (SIN_bound ((psi t - psi2) / 2)). assert (-1 <= from1 0 * from2 t <= 1) by nra. nra.
Qed.
End Frozen.
(* such a psi *)
Lemma frozen_exists al : 0 < al -> exists psi, (forall t, is_derive psi t (eq115_psi_rate al (psi t))) /\ sin ((psi 0 - eq125_psi2 al) / 2) <> 0.
Proof.
  intros Ha. set (psi t := eq125_psi2 al + PI - 2 * atan (exp (- (2 / sinh (2 * al)) * t) - sinh (2 * al))). exists psi.
  pose proof (double_pos al Ha). pose proof (cosh_pos (2 * al)). destruct (psi1_spec al Ha) as (_ & es & ec). split.
  - intros t. unfold psi. set (z := exp (- (2 / sinh (2 * al)) * t) - sinh (2 * al)). assert (q : 0 < 1 + z ^ 2) by nra.
    assert (e : sin (eq125_psi2 al + PI - 2 * atan z) = - (tanh (2 * al) * (1 - z ^ 2) / (1 + z ^ 2) + / cosh (2 * al) * (2 * z) / (1 + z ^ 2))).
    { change (eq125_psi2 al) with (PI - eq124_psi1 al). replace (PI - eq124_psi1 al + PI - 2 * atan z) with (- (eq124_psi1 al + 2 * atan z) + 2 *
    PI) by ring.
      destruct (twice_atan z) as [h1 h2]. rewrite sin_per, sin_neg, sin_plus, es, ec, h1, h2. field. lra. }
    rewrite rate_T, e by trivial. unfold z at 1. auto_derive; trivial. fold z. set (E := exp _). set (S := sinh _) in *. unfold tanh. fold S.
    transitivity (2 * (2 / S) * (z + S) / (1 + z ^ 2)); [ unfold z in *; fold E in q |- *; field; split; lra | field; lra ].
  - unfold psi. replace ((_ - _) / 2) with (PI / 2 - atan (exp (- (2 / sinh (2 * al)) * 0) - sinh (2 * al))) by field. rewrite sin_shift.
    pose proof (atan_bound (exp (- (2 / sinh (2 * al)) * 0) - sinh (2 * al))). apply Rgt_not_eq, cos_gt_0; lra.
Qed.
