(* The last moments before a rest with psi -> 0, for A, alpha and psi as functions of time: alpha falls at the rate 1/sigma - 1 in the end,
   and with that A and psi have the laws (142), (144), (145). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas TableLaws TableAngle Fate Alpha Stops Late Thin Near.
Open Scope R_scope.

Ltac ll_limit := eapply ll_eq; [ ll | ].

(* l'Hôpital *)
Lemma ll_hospital f df g dg s T L : s < T -> (forall t, s <= t < T -> rder f t (df t) /\ rder g t (dg t) /\ dg t < 0 /\ 0 < g t) ->
  (forall t, s < t < T -> continuity_pt f t /\ continuity_pt g t) -> left_lim f T 0 -> left_lim g T 0 ->
  left_lim (fun t => df t / dg t) T L -> left_lim (fun t => f t / g t) T L.
Proof.
  intros sT D C F G H e He. destruct (soon_from s T _ sT (soon_near _ _ _ (e / 2) H ltac:(lra))) as (s' & s1 & K).
  exists (T - s'). split. lra. intros t Ht. assert (B : forall r, s' <= r < T -> (L + e / 2) * dg r < df r < (L - e / 2) * dg r).
  { intros r Hr. specialize (K r Hr). cbv beta in K. destruct (D r ltac:(lra)) as (_ & _ & n & _). apply Rabs_def2 in K.
    replace (df r) with (df r / dg r * dg r) by (field; lra). split; nra. }
  assert (up : f t - (L + e / 2) * g t <= 0).
  { apply (ll_incr (fun t => f t - (L + e / 2) * g t) s' T 0); [ ll_limit; lra | | | lra ]; intros r Hr.
    - destruct (C r ltac:(lra)). contq.
    - destruct (D r ltac:(lra)) as (d1 & d2 & _). specialize (B r Hr). eexists. split. rdq. lra. }
  assert (lo : (L - e / 2) * g t - f t <= 0).
  { apply (ll_incr (fun t => (L - e / 2) * g t - f t) s' T 0); [ ll_limit; lra | | | lra ]; intros r Hr.
    - destruct (C r ltac:(lra)). contq.
    - destruct (D r ltac:(lra)) as (d1 & d2 & _). specialize (B r Hr). eexists. split. rdq. lra. }
  destruct (D t ltac:(lra)) as (_ & _ & _ & g0). assert (q : f t / g t * g t = f t) by (field; lra). set (v := f t / g t) in *.
  apply Rabs_def1; nra.
Qed.

(* ---- powers with real exponents ---- *)
Lemma rder_power f a t l : rder f t l -> 0 < f t -> rder (fun s => Rpower (f s) a) t (a * Rpower (f t) (a - 1) * l).
Proof. intros H P. eapply rder_eq. apply (rder_comp f (fun z => Rpower z a) t l (a * Rpower (f t) (a - 1)) H).
  apply is_derive_Reals, derivable_pt_lim_power, P. ring. Qed.
Lemma cont_power f a t : continuity_pt f t -> 0 < f t -> continuity_pt (fun s => Rpower (f s) a) t.
Proof.
  intros H P. apply (continuity_pt_comp f (fun z => Rpower z a)); trivial. apply derivable_continuous_pt. exists (a * Rpower (f t) (a - 1)).
  apply derivable_pt_lim_power, P.
Qed.
Lemma power_pos z a : 0 < Rpower z a. Proof. apply exp_pos. Qed.
Lemma power_one z a : 0 < z <= 1 -> 0 <= a -> Rpower z a <= 1.
Proof. intros Hz Ha. pose proof (Rle_Rpower_l z 1 a Ha Hz) as k. unfold Rpower in k at 2. now rewrite ln_1, Rmult_0_r, exp_0 in k. Qed.
Lemma power_le z a b : 0 < z <= 1 -> a <= b -> Rpower z b <= Rpower z a.
Proof.
  intros Hz Hab. replace b with ((b - a) + a) by ring. rewrite Rpower_plus. pose proof (power_one z (b - a) Hz ltac:(lra)).
  pose proof (power_pos z a). nra.
Qed.
Lemma power_cube z a : 0 < z -> Rpower z a ^ 3 = Rpower z (3 * a).
Proof. intros Hz. replace (3 * a) with (a + (a + a)) by ring. rewrite !Rpower_plus. ring. Qed.
Lemma power_sq z a : 0 < z -> Rpower z a ^ 2 = Rpower z (2 * a).
Proof. intros Hz. replace (2 * a) with (a + a) by ring. rewrite Rpower_plus. ring. Qed.
Lemma ll_power f T a : soon T (fun t => 0 < f t) -> left_lim f T 0 -> 0 < a -> left_lim (fun t => Rpower (f t) a) T 0.
Proof.
  intros P H Ha e He. destruct (soon_and _ _ _ P (H (Rpower e (/ a)) (power_pos _ _))) as (d & d0 & K). exists d. split; trivial. intros t Ht.
  destruct (K t Ht) as [p0 h]. rewrite Rminus_0_r in *. rewrite Rabs_pos_eq in * by (try (left; apply power_pos); lra).
  replace e with (Rpower (Rpower e (/ a)) a). 2: { rewrite Rpower_mult. replace (/ a * a) with 1 by (field; lra). now apply Rpower_1. }
  apply Rlt_Rpower_l; lra.
Qed.

(* ---- sizes for small alpha and psi ---- *)
Lemma cos_quadratic v : Rabs (cos v - 1) <= v ^ 2.
Proof.
  pose proof (cos_2a_sin (v / 2)) as q. replace (2 * (v / 2)) with v in q by field. rewrite q.
  assert (sin (v / 2) ^ 2 <= (v / 2) ^ 2) by (rewrite <- (pow2_abs (v / 2)); apply pow_maj_Rabs, sin_abs). pose proof (pow2_ge_0 (sin (v / 2))).
  apply Rabs_le. nra.
Qed.
Lemma sin_cubic v : Rabs (v - sin v) <= Rabs v ^ 3.
Proof.
  destruct (MVT_gen (fun v => v - sin v) 0 v (fun v => 1 - cos v)) as (c & Hc & e).
  { intros r _. auto_derive; trivial. ring. } { intros r _. apply continuity_pt_minus; [ cont | apply continuity_sin ]. }
  rewrite sin_0, !Rminus_0_r in e. rewrite e, Rabs_mult, Rabs_minus_sym. pose proof (cos_quadratic c).
  assert (c2 : c ^ 2 <= Rabs v ^ 2). { rewrite pow2_abs. unfold Rmin, Rmax in Hc. destruct (Rle_dec 0 v); nra. }
  replace (Rabs v ^ 3) with (Rabs v ^ 2 * Rabs v) by ring. apply Rmult_le_compat_r. apply Rabs_pos. lra.
Qed.
(* 2 alpha coth 2 alpha *)
Definition hcoth a := 2 * a * coth (2 * a).
Lemma hcoth_near a : 0 < a <= / 2 -> Rabs (hcoth a - 1) <= 8 * a ^ 2.
Proof.
  intros Ha. destruct (hyp_small (2 * a) ltac:(lra)) as (e1 & e2 & h1 & h2 & es & ec). unfold hcoth, coth. rewrite es, ec.
  set (b := 4 * a ^ 2). assert (b0 : 0 < b) by (unfold b; nra). replace (2 * a + (2 * a) ^ 3 * e1) with (2 * a * (1 + b * e1)) by (unfold b; ring).
  replace (2 * a * ((1 + (2 * a) ^ 2 * e2) / (2 * a * (1 + b * e1))) - 1) with (b * (e2 - e1) / (1 + b * e1)) by (unfold b; field; nra).
  replace (8 * a ^ 2) with (b * 2) by (unfold b; ring). apply Rabs_le. split; [ apply Rle_div_r | apply Rle_div_l ]; nra.
Qed.

(* A, alpha and psi from the moment s on until the rest at T, at the distance sigma *)
Record arrives (sigma s T : R) (A al psi : R -> R) : Prop := {
  v_time : s < T;
  v_pos : forall t, s <= t < T -> 0 < A t /\ 0 < al t;
  v_cont : forall t, s < t < T -> continuity_pt A t /\ continuity_pt al t /\ continuity_pt psi t;
  v_rate : forall t, s <= t < T -> rder A t (eq113_a_rate (al t)) /\ rder al t (eq114_alpha_rate (A t) (al t) (psi t)) /\
  rder psi t (eq115_psi_rate (al t) (psi t));
  v_A : left_lim A T sigma;  v_al : left_lim al T 0;  v_psi : left_lim psi T 0 }.

Section Arrives.
Variables (A al psi : R -> R) (sigma s T : R).
Hypothesis inside : 0 < sigma < 1.
Hypothesis V : arrives sigma s T A al psi.
Let sT := v_time _ _ _ _ _ _ V.
Let lA := v_A _ _ _ _ _ _ V.
Let lal := v_al _ _ _ _ _ _ V.
Let lpsi := v_psi _ _ _ _ _ _ V.
Notation dal t := (eq114_alpha_rate (A t) (al t) (psi t)).
Notation dpsi t := (eq115_psi_rate (al t) (psi t)).

Lemma inwards : eq140_alpha_rate sigma < 0.
Proof. assert (1 < / sigma) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). unfold eq140_alpha_rate, Rdiv. lra. Qed.
Lemma cosh_cont a : continuity_pt cosh a. Proof. apply derivable_continuous_pt. exists (sinh a). apply derivable_pt_lim_cosh. Qed.
Lemma dal_limit : left_lim (fun t => dal t) T (eq140_alpha_rate sigma).
Proof.
  pose proof (ll_comp cos _ _ _ lpsi (continuity_cos 0)) as c. pose proof (ll_comp cosh _ _ _ lal (cosh_cont 0)) as h. cbv beta in c, h.
  rewrite cos_0 in c. rewrite cosh_0 in h.
  unfold eq114_alpha_rate, eq140_alpha_rate. ll_limit; lra.
Qed.
Lemma pos_soon : soon T (fun t => 0 < A t /\ 0 < al t).
Proof. apply (soon_after s); trivial. apply V. Qed.
Lemma al_soon : soon T (fun t => 0 < al t).
Proof. apply (soon_imp T (fun t => 0 < A t /\ 0 < al t)); [ intros t h; apply h | exact pos_soon ]. Qed.
(* alpha falls *)
Lemma falls : exists s', s < s' < T /\ forall t, s' <= t < T -> dal t < 0.
Proof.
  pose proof inwards. apply soon_from; trivial. destruct (soon_near _ _ _ (- eq140_alpha_rate sigma) dal_limit ltac:(lra)) as (d & d0 & K). exists d.
  split; trivial.
  intros t Ht. specialize (K t Ht). apply Rabs_def2 in K. cbv beta. lra.
Qed.
Lemma ratio_limit : left_lim (fun t => eq140_alpha_rate sigma / dal t) T 1.
Proof.
  pose proof dal_limit as l. pose proof inwards. ll_limit; [ lra | field; lra ].
Qed.
(* alpha, by the time that is left *)
Lemma alpha_limit : left_lim (fun t => al t / eq141_alpha sigma (t - T)) T 1.
Proof.
  destruct falls as (s' & Hs & F). assert (n : 0 < (1 - sigma) / sigma) by (apply Rdiv_lt_0_compat; lra).
  apply (ll_hospital al (fun t => dal t) (fun t => eq141_alpha sigma (t - T)) (fun _ => eq140_alpha_rate sigma) s'); [ lra | | | trivial | | ].
  - intros t Ht. destruct (v_rate _ _ _ _ _ _ V t ltac:(lra)) as (_ & d & _). split; trivial. split; [ | split ].
    + apply rder_of. unfold eq141_alpha, eq140_alpha_rate. auto_derive; trivial. field. lra.
    + unfold eq140_alpha_rate. replace (1 - 1 / sigma) with (- ((1 - sigma) / sigma)) by (field; lra). lra.
    + unfold eq141_alpha. replace ((sigma - 1) * (t - T) / sigma) with ((1 - sigma) / sigma * (T - t)) by (field; lra). apply Rmult_lt_0_compat; lra.
  - intros t Ht. split. apply (v_cont _ _ _ _ _ _ V); lra. unfold eq141_alpha, Rdiv. cont.
  - eapply ll_eq. apply (ll_cont (fun t => eq141_alpha sigma (t - T))). unfold eq141_alpha, Rdiv. cont. unfold eq141_alpha. field. lra.
  - pose proof dal_limit as l. eapply ll_eq. apply (ll_mult (fun t => dal t) (fun _ => / eq140_alpha_rate sigma)). ll. ll. pose proof inwards; lra.
    field. pose proof inwards; lra.
Qed.
(* sinh alpha / alpha, alpha coth alpha *)
Lemma shc_limit : left_lim (fun t => sinh (al t) / al t) T 1.
Proof.
  intros e He. destruct (soon_and _ _ _ al_soon (soon_near _ _ _ (Rmin (/ 2) (e / 2)) lal ltac:(apply Rmin_pos; lra))) as (d & d0 & H). exists d.
  split; trivial.
  intros t Ht. destruct (H t Ht) as [a0 a1]. pose proof (Rmin_l (/ 2) (e / 2)). pose proof (Rmin_r (/ 2) (e / 2)). rewrite Rminus_0_r in a1.
  rewrite Rabs_pos_eq in a1 by lra.
  destruct (hyp_small (al t) ltac:(lra)) as (e1 & _ & h1 & _ & -> & _). replace ((al t + al t ^ 3 * e1) / al t - 1) with (al t ^ 2 * e1) by (field;
  lra).
  rewrite Rabs_pos_eq by nra. nra.
Qed.
Lemma hcoth_limit : left_lim (fun t => hcoth (al t)) T 1.
Proof.
  assert (k : left_lim (fun t => hcoth (al t) - 1) T 0).
  { apply (ll_squeeze _ (fun t => 8 * al t ^ 2)); [ | ll_limit; ring ].
    apply (soon_imp _ _ _ (fun t h => hcoth_near (al t) h)). destruct (soon_and _ _ _ al_soon (soon_near _ _ _ (/ 2) lal ltac:(lra))) as (d & d0 & H).
    exists d. split; trivial. intros t Ht. destruct (H t Ht) as [a0 a1]. rewrite Rminus_0_r in a1. apply Rabs_def2 in a1. lra. }
  apply (ll_ext (fun t => hcoth (al t) - 1 + 1) _ T _ 1 Rlt_0_1). intros; ring. ll_limit. ring.
Qed.
(* A, by alpha *)
Lemma A_limit : left_lim (fun t => (A t - sigma) / al t ^ 2) T (sigma / (sigma - 1) / 2).
Proof.
  destruct falls as (s' & Hs & F). pose proof dal_limit as l. pose proof shc_limit as h.
  pose proof inwards as n.
  apply (ll_hospital (fun t => A t - sigma) (fun t => eq113_a_rate (al t)) (fun t => al t ^ 2) (fun t => 2 * al t * dal t) s'); [ lra | | | | | ].
  - intros t Ht. destruct (v_rate _ _ _ _ _ _ V t ltac:(lra)) as (dA & d & _). destruct (v_pos _ _ _ _ _ _ V t ltac:(lra)). specialize (F t Ht).
    repeat split; try nra. eapply rder_eq. rd. ring. eapply rder_eq. apply (rder_pow al 2); exact d. simpl. ring.
  - intros t Ht. destruct (v_cont _ _ _ _ _ _ V t ltac:(lra)) as (c1 & c2 & _). split; contq.
  - ll_limit. ring.
  - ll_limit. ring.
  - apply (ll_soon (fun t => sinh (al t) / al t * (/ 2 * / dal t))).
    + apply (soon_after s'); [ lra | ]. intros t Ht. destruct (v_pos _ _ _ _ _ _ V t ltac:(lra)). specialize (F t Ht). unfold eq113_a_rate. field.
      lra.
    + eapply ll_eq. ll; lra. unfold eq140_alpha_rate. field. lra.
Qed.
(* what (142) leaves out *)
Lemma turning t : 0 < al t -> dpsi t = 2 - hcoth (al t) * (sin (psi t) / al t).
Proof. intros a0. unfold eq115_psi_rate, hcoth. field. lra. Qed.
Lemma psi_law : left_lim (fun t => (eq142_left sigma (dpsi t / dal t) - eq142_right (al t) (psi t)) / (1 + Rabs (psi t) / al t)) T 0.
Proof.
  destruct falls as (s' & Hs & F). pose proof ratio_limit as l. pose proof hcoth_limit as h.
  apply (ll_squeeze _ (fun t => Rabs (eq140_alpha_rate sigma / dal t - 1) * (2 + Rabs (hcoth (al t))) + (Rabs (psi t) ^ 2 + Rabs (hcoth (al t) -
  1)))).
  - apply (soon_after s'); [ lra | ]. intros t Ht. destruct (v_pos _ _ _ _ _ _ V t ltac:(lra)) as [_ a0]. specialize (F t Ht). set (d := dal t) in *.
    unfold eq142_left, eq142_right. rewrite turning by trivial.
    pose proof (sin_cubic (psi t)) as s3. pose proof (sin_abs (psi t)) as s1. set (z := psi t) in *. set (a := al t) in *. set (H := hcoth a) in *.
    set (v := sin z) in *.
    set (q := eq140_alpha_rate sigma / d). assert (N : 0 < 1 + Rabs z / a) by (assert (0 <= Rabs z / a) by (apply Rmult_le_pos;
    [ apply Rabs_pos | left; now apply Rinv_0_lt_compat ]); lra).
    replace ((sigma - 1) / sigma * ((2 - H * (v / a)) / d) - 2 * (1 - z / (2 * a))) with ((q - 1) * (2 - H * (v / a)) + (z - v - (H - 1) * v) / a)
      by (unfold q, eq140_alpha_rate; field; lra).
    unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; now apply Rinv_0_lt_compat). apply Rle_div_l; trivial.
    assert (ia : 0 < / a) by now apply Rinv_0_lt_compat. set (m := Rabs z / a) in *.
    assert (m0 : 0 <= m) by (apply Rmult_le_pos; [ apply Rabs_pos | lra ]).
    assert (va : Rabs (v / a) <= m). { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ a)) by lra. apply Rmult_le_compat_r; lra. }
    assert (b1 : Rabs (2 - H * (v / a)) <= (2 + Rabs H) * (1 + m)).
    { pose proof (Rabs_triang 2 (- (H * (v / a)))) as k. rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) in k by lra. unfold Rminus.
      pose proof (Rabs_pos H). assert (Rabs H * Rabs (v / a) <= Rabs H * m) by (apply Rmult_le_compat_l; lra). nra. }
    assert (b2 : Rabs ((z - v - (H - 1) * v) / a) <= (Rabs z ^ 2 + Rabs (H - 1)) * (1 + m)).
    { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ a)) by lra. pose proof (Rabs_triang (z - v) (- ((H - 1) * v))) as k.
    rewrite Rabs_Ropp, Rabs_mult in k.
      pose proof (Rabs_pos (H - 1)). pose proof (pow2_ge_0 (Rabs z)). assert (Rabs (H - 1) * Rabs v <= Rabs (H - 1) * Rabs z) by (apply
      Rmult_le_compat_l; lra).
      apply Rle_trans with ((Rabs z ^ 2 + Rabs (H - 1)) * m); [ | apply Rmult_le_compat_l; lra ].
      unfold m, Rdiv. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [ lra | ]. unfold Rminus at 1. eapply Rle_trans; [ exact k | ]. simpl in *.
      lra. }
    eapply Rle_trans; [ apply Rabs_triang | ]. rewrite Rabs_mult, Rmult_plus_distr_r. apply Rplus_le_compat; trivial.
    rewrite Rmult_assoc. apply Rmult_le_compat_l; [ apply Rabs_pos | trivial ].
  - assert (ab : forall f c, left_lim f T c -> left_lim (fun t => Rabs (f t)) T (Rabs c)) by (intros f c Hf; apply (ll_comp Rabs f T c Hf),
    Rcontinuity_abs).
    eapply ll_eq. apply (ll_plus (fun t => Rabs (eq140_alpha_rate sigma / dal t - 1) * (2 + Rabs (hcoth (al t)))) (fun t => Rabs (psi t) ^ 2 + Rabs
    (hcoth (al t) - 1))).
    + apply (ll_mult (fun t => Rabs (eq140_alpha_rate sigma / dal t - 1)) (fun t => 2 + Rabs (hcoth (al t)))).
      apply (ab (fun t => eq140_alpha_rate sigma / dal t - 1)). ll. apply (ll_plus (fun _ => 2)). ll. apply (ab (fun t => hcoth (al t))). ll.
    + apply (ll_plus (fun t => Rabs (psi t) ^ 2)). apply (ll_pow (fun t => Rabs (psi t))), ab. ll. apply (ab (fun t => hcoth (al t) - 1)). ll.
    + rewrite !Rminus_eq_0, !Rabs_R0. ring.
Qed.
Lemma A_law : left_lim (fun t => eq144_left sigma (eq113_a_rate (al t) / dal t) / eq144_right (al t)) T 1.
Proof.
  destruct falls as (s' & Hs & F). pose proof ratio_limit as l. pose proof shc_limit as h.
  apply (ll_soon (fun t => eq140_alpha_rate sigma / dal t * (sinh (al t) / al t))); [ | ll_limit; ring ].
  apply (soon_after s'); [ lra | ]. intros t Ht. destruct (v_pos _ _ _ _ _ _ V t ltac:(lra)) as [_ a0]. specialize (F t Ht).
  unfold eq144_left, eq144_right, eq140_alpha_rate, eq113_a_rate. field. lra.
Qed.
End Arrives.
