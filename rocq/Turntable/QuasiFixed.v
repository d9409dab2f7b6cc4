(* psi with alpha held fixed: the ratio of sin ((psi - psi_1) / 2) to sin ((psi - psi_2) / 2) falls exactly as exp (- 2 t / sinh 2 alpha) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion RightDerivatives Picard TableAngle Formulas.
Open Scope R_scope.

Lemma tanh_range al : 0 < al -> 0 < tanh (2 * al) < 1.
Proof.
  intros Ha. unfold tanh. pose proof (cosh_pos (2 * al)) as c0. assert (z0 : 0 < sinh (2 * al)) by (rewrite <- sinh_0; apply sinh_lt; lra).
  split. now apply Rdiv_lt_0_compat. apply Rlt_div_l; trivial. unfold sinh, cosh. pose proof (exp_pos (- (2 * al))). lra.
Qed.
Lemma coth_is al : 0 < al -> coth (2 * al) = / tanh (2 * al).
Proof. intros Ha. pose proof (tanh_range al Ha) as T. unfold coth, tanh in *. pose proof (cosh_pos (2 * al)). assert (sinh (2 * al) <> 0) by (intros z; rewrite z in T; lra). field. lra. Qed.
Lemma psi1_spec al : 0 < al -> 0 < eq124_psi1 al < PI / 2 /\ sin (eq124_psi1 al) = tanh (2 * al) /\ cos (eq124_psi1 al) = / cosh (2 * al).
Proof.
  intros Ha. pose proof (tanh_range al Ha) as T. unfold eq124_psi1. assert (e : sin (asin (tanh (2 * al))) = tanh (2 * al)) by (apply sin_asin; lra).
  assert (b : - (PI / 2) < asin (tanh (2 * al)) < PI / 2) by (apply asin_bound_lt; lra). split; [ split; [ | lra ] | split; trivial ].
  - apply Rnot_le_lt. intros k. pose proof (sin_incr_1 (asin (tanh (2 * al))) 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). rewrite sin_0 in *. lra.
  - rewrite cos_asin by lra. pose proof (cosh_pos (2 * al)) as c0. rewrite <- (sqrt_pow2 (/ cosh (2 * al))) by (left; now apply Rinv_0_lt_compat). f_equal.
    unfold tanh, Rsqr. pose proof (cosh_sq (2 * al)) as q. field_simplify_eq; [ | lra ]. lra.
Qed.
(* (115) is zero just where sin psi = tanh 2 alpha *)
Lemma stands al psi : 0 < al -> eq115_psi_rate al psi = 0 <-> sin psi = tanh (2 * al).
Proof.
  intros Ha. pose proof (tanh_range al Ha) as T. unfold eq115_psi_rate. rewrite coth_is by trivial. set (k := tanh (2 * al)) in *. split; intros h.
  - replace (sin psi) with (sin psi * / k * k) by (field; lra). replace (sin psi * / k) with 1 by lra. ring.
  - rewrite h. field. lra.
Qed.

Section Frozen.
Variable al : R.
Variable psi : R -> R.
Hypothesis ha : 0 < al.
Hypothesis hc : forall t, 0 < t -> continuity_pt psi t.
Hypothesis hd : forall t, 0 <= t -> rder psi t (eq115_psi_rate al (psi t)).
Notation from1 t := (sin ((psi t - eq124_psi1 al) * / 2)).
Notation from2 t := (sin ((psi t - eq125_psi2 al) * / 2)).
Notation T := (tanh (2 * al)).
Notation k := (2 / sinh (2 * al)).

Lemma rate_is t : eq115_psi_rate al (psi t) = 4 * from1 t * from2 t / T.
Proof.
  destruct (psi1_spec al ha) as (_ & e & _). pose proof (tanh_range al ha) as T0. unfold eq115_psi_rate, eq125_psi2. rewrite coth_is by trivial.
  change (asin (tanh (2 * al))) with (eq124_psi1 al). set (a := (psi t - eq124_psi1 al) * / 2). set (b := (psi t + eq124_psi1 al) * / 2).
  replace ((psi t - (PI - eq124_psi1 al)) * / 2) with (- (PI / 2 - b)) by (unfold b; field). rewrite sin_neg, sin_shift.
  replace (sin (psi t)) with (sin (b + a)) by (f_equal; unfold a, b; field). rewrite <- e. replace (eq124_psi1 al) with (b - a) in e |- * by (unfold a, b; field).
  rewrite sin_plus, sin_minus in *. field. rewrite e. lra.
Qed.
Lemma halves_rates t : 0 <= t -> rder (fun t => from1 t) t (2 / T * cos ((psi t - eq124_psi1 al) * / 2) * from1 t * from2 t) /\
  rder (fun t => from2 t) t (2 / T * cos ((psi t - eq125_psi2 al) * / 2) * from1 t * from2 t).
Proof.
  intros Ht. pose proof (hd t Ht) as D. rewrite rate_is in D. pose proof (tanh_range al ha).
  split; (eapply rder_eq; [ apply (rder_sin (fun t => (psi t - _) * / 2)); rd | cbv beta; field; lra ]).
Qed.
Lemma cont_half c t : 0 < t -> continuity_pt (fun t => sin ((psi t - c) * / 2)) t.
Proof. intros Ht. apply (continuity_pt_comp (fun t => (psi t - c) * / 2) sin); [ cont | apply continuity_sin ]. Qed.
Hypothesis away : from2 0 <> 0.
Lemma stays_away t : 0 <= t -> from2 t <> 0.
Proof.
  intros Ht z. pose proof (tanh_range al ha) as T0. set (M := 4 / T). assert (M0 : 0 < M) by (apply Rdiv_lt_0_compat; lra).
  assert (K : - (from2 t ^ 2 * exp (M * t)) <= - (from2 0 ^ 2 * exp (M * 0))).
  { apply (rder_decr (fun t => - (from2 t ^ 2 * exp (M * t)))); trivial; intros s Hs.
    - apply (continuity_pt_opp (fun t => from2 t ^ 2 * exp (M * t))), (continuity_pt_mult (fun t => from2 t ^ 2)); [ | cont ].
      apply (continuity_pt_comp (fun t => from2 t) (fun x => x ^ 2)); [ apply cont_half; lra | apply derivable_continuous_pt, derivable_pt_pow ].
    - destruct (halves_rates s ltac:(lra)) as [_ D]. eexists. split. apply (rder_opp (fun t => from2 t ^ 2 * exp (M * t))), (rder_mult (fun t => from2 t ^ 2)); [ apply (rder_pow (fun t => from2 t)), D | rd ].
      simpl INR. simpl pred. cbv beta. set (e := exp (M * s)). assert (e0 : 0 < e) by apply exp_pos. pose proof (SIN_bound ((psi s - eq124_psi1 al) * / 2)) as b1. pose proof (COS_bound ((psi s - eq125_psi2 al) * / 2)) as b2.
      set (a := from1 s) in *. set (b := from2 s) in *. set (c := cos _) in *.
      match goal with |- ?g <= 0 => replace g with (- (M * e * b ^ 2 * (1 + c * a))) by (unfold M; field; lra) end.
      assert (0 <= M * e * b ^ 2) by (apply Rmult_le_pos; [ nra | apply pow2_ge_0 ]). assert (0 <= 1 + c * a) by nra. nra. }
  rewrite z, Rmult_0_r, exp_0 in K. pose proof (pow2_gt_0 (from2 0) away). nra.
Qed.
Lemma ratio_falls t : 0 <= t -> from1 t * from2 0 = exp (- (k * t)) * from1 0 * from2 t.
Proof.
  intros Ht. destruct (psi1_spec al ha) as (_ & e & e'). pose proof (tanh_range al ha) as T0. assert (z0 : 0 < sinh (2 * al)) by (rewrite <- sinh_0; apply sinh_lt; lra). pose proof (cosh_pos (2 * al)).
  assert (K : from1 t * / from2 t * exp (k * t) = from1 0 * / from2 0 * exp (k * 0)).
  { apply (rder_const (fun t => from1 t * / from2 t * exp (k * t))); trivial; intros s Hs.
    - apply (continuity_pt_mult (fun t => from1 t * / from2 t)); [ | cont ]. apply (continuity_pt_mult (fun t => from1 t)); [ apply cont_half; lra | ].
      apply (continuity_pt_inv (fun t => from2 t)); [ apply cont_half; lra | apply stays_away; lra ].
    - destruct (halves_rates s ltac:(lra)) as [D1 D2]. pose proof (stays_away s ltac:(lra)) as b0.
      eapply rder_eq. apply (rder_mult (fun t => from1 t * / from2 t)); [ apply (rder_mult (fun t => from1 t)); [ exact D1 | apply (rder_inv (fun t => from2 t)); [ exact D2 | exact b0 ] ] | rd ].
      cbv beta. set (a1 := (psi s - eq124_psi1 al) * / 2) in *. set (a2 := (psi s - eq125_psi2 al) * / 2) in *.
      assert (q : sin a2 * cos a1 - sin a1 * cos a2 = - / cosh (2 * al)).
      { rewrite <- e'. replace (sin a2 * cos a1 - sin a1 * cos a2) with (sin (a2 - a1)) by (rewrite sin_minus; ring). replace (a2 - a1) with (- (PI / 2 - eq124_psi1 al)).
        rewrite sin_neg, sin_shift. ring. unfold a1, a2, eq125_psi2. change (asin (tanh (2 * al))) with (eq124_psi1 al). field. }
      set (E := exp (k * s)). match goal with |- ?g = 0 => replace g with ((2 / T * (sin a2 * cos a1 - sin a1 * cos a2) + k) * sin a1 * / sin a2 * E) by (field; lra) end.
      rewrite q. unfold tanh. field. split; [ exact b0 | lra ]. }
  rewrite Rmult_0_r, exp_0, Rmult_1_r in K. pose proof (stays_away t Ht) as b0. assert (e1 : exp (k * t) * exp (- (k * t)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  apply (Rmult_eq_compat_r (from2 t * from2 0 * exp (- (k * t)))) in K.
  replace (from1 t * / from2 t * exp (k * t) * (from2 t * from2 0 * exp (- (k * t)))) with (from1 t * from2 0 * (exp (k * t) * exp (- (k * t)))) in K by (field; exact b0).
  rewrite e1, Rmult_1_r in K. rewrite K. field. exact away.
Qed.
Lemma attracted : is_lim (fun t => from1 t) p_infty 0.
Proof.
  assert (z0 : 0 < sinh (2 * al)) by (rewrite <- sinh_0; apply sinh_lt; lra). assert (k0 : 0 < k) by (apply Rdiv_lt_0_compat; lra). set (q := k) in *.
  apply is_lim_spec. intros eps. pose proof (cond_pos eps) as e0. set (e := pos eps) in *. pose proof (Rabs_pos_lt _ away) as b0. set (b := Rabs (from2 0)) in *.
  exists (/ (q * b * e)). intros t Ht. assert (i0 : 0 < / (q * b * e)) by (apply Rinv_0_lt_compat; apply Rmult_lt_0_compat; nra). pose proof (ratio_falls t ltac:(lra)) as R. fold q in R.
  rewrite Rminus_0_r. apply (Rmult_lt_reg_r b); trivial. unfold b at 1. rewrite <- Rabs_mult, R, !Rabs_mult, (Rabs_pos_eq (exp _)) by (left; apply exp_pos).
  assert (s1 : Rabs (from1 0) <= 1) by (apply Rabs_le, SIN_bound). assert (s2 : Rabs (from2 t) <= 1) by (apply Rabs_le, SIN_bound). pose proof (Rabs_pos (from1 0)). pose proof (Rabs_pos (from2 t)).
  assert (qb : 0 < q * b * e) by (apply Rmult_lt_0_compat; nra). assert (qt : 1 < q * t * (b * e)).
  { apply (Rmult_lt_compat_l _ _ _ qb) in Ht. rewrite Rinv_r in Ht by lra. replace (q * t * (b * e)) with (q * b * e * t) by ring. exact Ht. }
  pose proof (exp_ineq1_le (q * t)) as x1. assert (e1 : exp (q * t) * exp (- (q * t)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). pose proof (exp_pos (- (q * t))) as x0.
  apply Rle_lt_trans with (exp (- (q * t)) * 1 * 1). { apply Rmult_le_compat; nra. }
  assert (be : 0 < b * e) by nra. apply (Rmult_lt_reg_l (exp (q * t))). apply exp_pos. rewrite !Rmult_1_r, e1. nra.
Qed.
End Frozen.
(* such a psi from every start *)
Lemma frozen_exists al psi0 : 0 < al -> exists psi, psi 0 = psi0 /\ (forall t, 0 < t -> continuity_pt psi t) /\ forall t, 0 <= t -> rder psi t (eq115_psi_rate al (psi t)).
Proof.
  intros Ha. pose proof (tanh_range al Ha) as T0. assert (i0 : 0 < / tanh (2 * al)) by (apply Rinv_0_lt_compat; lra). set (K := 2 * / tanh (2 * al)).
  assert (sl : forall a b, Rabs (sin a - sin b) <= Rabs (a - b)).
  { intros a b. destruct (MVT_abs sin cos b a) as (c & -> & _). { intros; apply derivable_pt_lim_sin. } rewrite <- (Rmult_1_l (Rabs (a - b))) at 2. apply Rmult_le_compat_r. apply Rabs_pos. apply Rabs_le, COS_bound. }
  destruct (picard (fun i v => match i with px => eq115_psi_rate al (v px) | _ => 0 end) K ltac:(unfold K; lra)) with (c := fun i : place => psi0) as (f & f0 & fc & fd).
  - intros v v' D H i. specialize (H px). pose proof (sl (v px) (v' px)) as q. pose proof (Rabs_pos (v px - v' px)). assert (KD : 0 <= K * D) by (apply Rmult_le_pos; unfold K; lra).
    destruct i; try (rewrite Rminus_eq_0, Rabs_R0; exact KD). unfold eq115_psi_rate. rewrite coth_is by trivial.
    replace (2 * (1 - sin (v px) * / tanh (2 * al)) - 2 * (1 - sin (v' px) * / tanh (2 * al))) with (- (K * (sin (v px) - sin (v' px)))) by (unfold K; ring).
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq K) by (unfold K; lra). apply Rmult_le_compat_l; unfold K; lra.
  - exists (f px). split; [ apply f0 | split ]. intros; apply fc. intros t Ht. apply rder_of, (fd px t Ht).
Qed.
