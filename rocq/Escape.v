(* Section 4, A > 1: the escape, (126) to (138). Units: mu g = Omega = 1, so that every number here has no dimension.
   Every motion with A > 1 at some moment escapes by the laws shown here; of the printed ones (128) to (137) none holds. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate TableMotions TableAngle QuasiFixed Formulas Analysis Late Alpha Spiral Small.
Open Scope R_scope.

(* Functions of the time, dimensionless:
   «with $F=f$ and $G=law$: $\frac{F(t)}{G(t)}=1+(c)\,\frac{\ln t}{t}+o\!\left(\frac{\ln t}{t}\right)$ for $t\to\infty$» *)
Definition follows (f law : R -> R) (c : R) : Prop :=
  is_lim (fun t => f t / law t) p_infty 1 /\ is_lim (fun t => (f t / law t - 1) * (t / ln t)) p_infty c.
(* A law that does not hold, dimensionless: «with $F=f$ and $G=law$: $\frac{F(t)}{G(t)}\to c\ne1$ for $t\to\infty$» *)
Definition misses (f law : R -> R) (c : R) : Prop := is_lim (fun t => f t / law t) p_infty c /\ c <> 1.

Lemma follows_of f law c : near (fun t => f t / law t) c -> follows f law c.
Proof. intros H. split; [ exact (near_one _ _ H) | exact H ]. Qed.
(* 3 sqrt 2/4: by this the printed laws are wrong, or by a power of it *)
Lemma six_hundredths : 1 < right_escape_product_over_a.
Proof. destruct root2. unfold right_escape_product_over_a. nra. Qed.
Lemma misses_of f law g c d : follows f law c -> (forall t, 1 <= t -> f t / g t = f t / law t * d) -> 1 < d -> misses f g d.
Proof.
  intros [H _] E N. split; [ | lra ]. apply (tends_ext 1 (fun t => f t / law t * d)). intros; symmetry; auto. limit. ring.
Qed.

Section Inner.
(* a motion, from the moment s on inside p < rho, with its A and alpha *)
Variables (x y u w A alpha : R -> R) (s : R).
Hypothesis table : spin x y u w.
Hypothesis from : 0 <= s.
Hypothesis inner : forall t, s <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).

Lemma inside t : s <= t -> 0 < A t /\ A t ^ 2 = E t /\ p t = A t * sinh (alpha t) /\ rho t = A t * cosh (alpha t) /\
  p t < rho t /\ rho t + p t = A t * exp (alpha t).
Proof.
  intros Ht. destruct (inner t Ht) as (A0 & k1 & k2). unfold eq111_p, eq112_rho in *.
  assert (e : A t ^ 2 = E t) by (rewrite E_is, k1, k2, !Rpow_mult_distr, cosh2; ring). repeat split; trivial.
  apply slow. rewrite <- e. now apply pow_lt. rewrite k1, k2. unfold cosh, sinh. field.
Qed.
Lemma positive t : s <= t -> 0 < p t -> 0 < sinh (alpha t) /\ 0 < alpha t.
Proof. intros Ht p0. destruct (inside t Ht) as (A0 & _ & k1 & _). rewrite k1 in p0. assert (0 < sinh (alpha t)) by nra. split; trivial.
    now apply sinh_sign. Qed.
(* (113), and (114) with the angle at this moment *)
Lemma rates t psi : s <= t -> angle (x t) (y t) (u t) (w t) psi -> rder A t (eq113_a_rate (alpha t)) /\
  (0 < p t -> rder alpha t (eq114_alpha_rate (A t) (alpha t) psi)).
Proof.
  intros Ht a. destruct (inside t Ht) as (A0 & _ & _ & _ & pr & _).
    assert (K : forall r, t <= r -> hyperbolic (x r) (y r) (u r) (w r) (A r) (alpha r)).
  { intros r Hr. apply inner. lra. } split. { now apply (A_rate x y u w A alpha table t); [ lra | | ]. }
  intros p0. pose (f r := if Req_EM_T r t then psi else proj1_sig (angle_exists (x r) (y r) (u r) (w r))).
  replace psi with (f t) by (unfold f; now destruct (Req_EM_T t t)). apply (alpha_rate x y u w f A alpha table); trivial; try lra.
  intros r _. unfold f. destruct (Req_EM_T r t) as [-> | _]. now apply angle_iff. apply (proj2_sig (angle_exists (x r) (y r) (u r) (w r))).
Qed.
(* (126): where alpha is small and psi near psi_1 of (124) the rate of alpha is 1 - 1/A: up to their distance and a multiple of sinh^2 alpha *)
Theorem eq_126 psi t (late : s <= t) (slips : 0 < p t) (turned : angle (x t) (y t) (u t) (w t) psi) :
  exists l, rder alpha t l /\ Rabs (l - eq126_alpha_rate (A t)) <= Rabs (psi - eq124_psi1 (alpha t)) + (2 + / (2 * A t)) * sinh (alpha t) ^ 2.
Proof.
  destruct (rates t psi late turned) as [_ D]. destruct (inside t late) as (A0 & _). destruct (positive t late slips) as [s0 a0]. eexists. split.
    exact (D slips).
  clear D. set (a := alpha t) in *. pose proof (cosh2 a) as c2. pose proof (cosh_from_1 a). pose proof (cosh_double a) as cd.
    pose proof (cosh_pos (2 * a)) as cc.
  destruct (psi1_spec a a0) as (_ & _ & C1). pose proof (cos_near psi (eq124_psi1 a)) as N. rewrite C1 in N. apply Rabs_le_between in N.
  assert (0 <= 1 - / cosh (2 * a) <= 2 * sinh a ^ 2).
  { pose proof (Rinv_0_lt_compat _ cc). assert (/ cosh (2 * a) * cosh (2 * a) = 1) by (field; lra). split; nra. }
  assert (0 <= (cosh a - 1) / A t <= / (2 * A t) * sinh a ^ 2).
  { pose proof (Rinv_0_lt_compat _ A0). rewrite Rinv_mult_distr by lra. unfold Rdiv. assert (cosh a - 1 <= / 2 * sinh a ^ 2) by nra. split; nra. }
  unfold eq114_alpha_rate, eq126_alpha_rate.
  replace (cos psi - cosh a / A t - (1 - 1 / A t)) with ((cos psi - / cosh (2 * a)) - (1 - / cosh (2 * a)) - (cosh a - 1) / A t) by (field; lra).
  apply Rabs_le. assert (0 <= sinh a ^ 2) by nra. lra.
Qed.
End Inner.

Lemma small_angle z e : - PI < z <= PI -> 0 < e < 1 -> cos e <= cos z -> Rabs z <= e.
Proof.
  intros Hz He H. pose proof PI2_3_2. apply Rnot_lt_le. intros k.
    assert (cz : cos (Rabs z) = cos z) by (unfold Rabs; destruct (Rcase_abs z); [ apply cos_neg | trivial ]).
  assert (Rabs z <= PI) by (apply Rabs_le; lra). pose proof (cos_decreasing_1 e (Rabs z) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). lra.
Qed.
(* near alpha = 0: for every A > 0, every psi between - pi and pi at the start, and eps > 0, however small: if alpha is small enough at the
   start, then within the time eps psi and psi_1 are below eps, and (126) holds up to eps; so it stays as long as alpha is small *)
Theorem s4_small_alpha A0 psi0 eps (inside0 : 0 < A0) (straight : - PI < psi0 < PI) (any : 0 < eps) : exists d0 d, 0 < d0 <= d /\
  forall x y u w A alpha psi s, spin x y u w -> 0 <= s -> (forall t, s <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t)) ->
  (forall t, s <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) -> A s = A0 -> psi s = psi0 -> 0 < alpha s < d0 ->
  exists T, s <= T <= s + eps /\ (forall r, s <= r <= T -> 0 < alpha r < d) /\
    forall t, T <= t -> (forall r, s <= r <= t -> 0 < alpha r < d) ->
    Rabs (psi t) < eps /\ Rabs (eq124_psi1 (alpha t)) < eps /\ Rabs (psi t - eq124_psi1 (alpha t)) < eps /\
    exists l, rder alpha t l /\ Rabs (l - eq126_alpha_rate (A t)) < eps.
Proof.
  set (e2 := Rmin eps 1 / 4). assert (0 < Rmin eps 1) by (apply Rmin_pos; lra). pose proof (Rmin_l eps 1). pose proof (Rmin_r eps 1).
  assert (e20 : 0 < e2 <= / 4 /\ e2 <= eps / 4) by (unfold e2; lra). pose proof PI2_3_2.
  assert (ce : 0 < cos e2 < 1). { pose proof (cos_gt_0 e2 ltac:(lra) ltac:(lra)). pose proof (sin_gt_0 e2 ltac:(lra) ltac:(lra)).
    pose proof (unit_circle e2). nra. }
  set (e := 1 - cos e2). set (M := 2 + / (2 * A0)). assert (M0 : 2 < M) by (unfold M; pose proof (Rinv_0_lt_compat (2 * A0) ltac:(lra)); lra).
  set (kap := Rmin (e / 2) (eps / (4 * M))). assert (k0 : 0 < kap) by (apply Rmin_pos; [ unfold e; lra | apply Rdiv_lt_0_compat; lra ]).
  assert (ka : kap <= e / 2) by apply Rmin_l. assert (kb : kap * (4 * M) <= eps) by (apply Rle_div_r; [ lra | apply Rmin_r ]).
  assert (He : 0 < e < 1) by (unfold e; lra). assert (c1 : -1 < cos psi0 <= 1).
  { pose proof (COS_bound psi0). split; [ | lra ]. replace psi0 with (2 * (psi0 / 2)) by field. rewrite cos_2a_cos.
    pose proof (cos_gt_0 (psi0 / 2) ltac:(lra) ltac:(lra)). nra. }
  destruct (relaxes A0 (cos psi0) e kap eps inside0 c1 He k0 any) as (W & st & W0 & st0 & rel). exists (arcsinh (st / A0)), (arcsinh W).
  assert (q0 : 0 < st / A0) by (apply Rdiv_lt_0_compat; lra). split.
  { split. rewrite <- arcsinh_0. now apply arcsinh_lt. apply arcsinh_le, Rle_div_l; lra. }
  intros x y u w A alpha psi s S Hs In Ang As Ps al0. pose proof (inside x y u w A alpha s In) as ins.
  assert (below : forall a k, a < arcsinh k -> sinh a < k) by (intros a k h; rewrite <- (sinh_arcsinh k); now apply sinh_lt).
  assert (sp : forall a, 0 < a -> 0 < sinh a) by (intros a h; rewrite <- sinh_0; now apply sinh_lt).
  assert (Ag : forall t, s <= t -> A0 <= A t).
  { intros t Ht. pose proof (A_never_falls x y u w S s t ltac:(lra)) as up. destruct (ins t Ht) as (At & e1 & _).
    destruct (ins s (Rle_refl s)) as (_ & e3 & _).
    rewrite <- As in *. apply Rsqr_incr_0; rewrite ?Rsqr_pow2; lra. }
  destruct (ins s (Rle_refl s)) as (_ & Es & ps & _). rewrite As in *. destruct al0 as [al0 al1]. apply below in al1. apply sp in al0.
  destruct (rel x y u w s S Hs) as (T & HT & HW & Hend). { now symmetry. }
  { rewrite ps. split. now apply Rmult_lt_0_compat. rewrite Rmult_comm. now apply Rlt_div_r. } { rewrite <- Ps. now apply Ang, Rle_refl. }
  exists T. split; trivial. split.
  - intros r Hr. specialize (HW r Hr). destruct (ins r ltac:(lra)) as (Ar & _ & k1 & _).
    destruct (positive x y u w A alpha s In r) as [s1 a1]; try lra. split; trivial.
    pose proof (Ag r ltac:(lra)). rewrite <- (arcsinh_sinh (alpha r)). apply arcsinh_lt.
    rewrite k1 in HW. assert (A0 * sinh (alpha r) <= A r * sinh (alpha r)) by (apply Rmult_le_compat_r; lra). apply (Rmult_lt_reg_l A0); lra.
  - intros t Ht small. pose proof (small t ltac:(lra)) as [a0 a1]. apply below in a1. pose proof (sp _ a0) as s1.
    destruct (ins t ltac:(lra)) as (At & _ & k1 & k2 & pr & _). pose proof (cosh_from_1 (alpha t)) as ch.
      assert (p0 : 0 < nrm (u t) (w t)) by (rewrite k1; now apply Rmult_lt_0_compat).
    assert (close : (1 - e) * (nrm (x t) (y t) * nrm (u t) (w t)) <= x t * u t + y t * w t).
    { apply Hend; trivial. intros r Hr. destruct (small r ltac:(lra)) as [r0 r1]. apply below in r1. apply sp in r0.
      destruct (ins r ltac:(lra)) as (Ar & _ & q1 & q2 & _). pose proof (cosh_from_1 (alpha r)). rewrite q1, q2. split. now apply Rmult_lt_0_compat.
      replace (W * (A r * cosh (alpha r))) with (A r * (W * cosh (alpha r))) by ring. apply Rmult_le_compat_l. lra.
      apply Rle_trans with (W * 1); [ lra | apply Rmult_le_compat_l; lra ]. }
    destruct (Ang t ltac:(lra)) as [rg an]. assert (rp : 0 < nrm (x t) (y t) * nrm (u t) (w t)) by (apply Rmult_lt_0_compat; lra).
    assert (P1 : Rabs (psi t) <= e2). { apply small_angle; trivial. lra. rewrite (proj1 an) in close. unfold e in close.
      apply (Rmult_le_reg_l _ _ _ rp). lra. }
    destruct (psi1_spec (alpha t) a0) as (b1 & _ & C1). pose proof (cosh_double (alpha t)) as cd. pose proof (cosh_pos (2 * alpha t)).
    assert (s2 : sinh (alpha t) ^ 2 <= kap * 1) by (simpl; rewrite Rmult_1_r; apply Rmult_le_compat; lra).
    assert (P2 : Rabs (eq124_psi1 (alpha t)) <= e2).
    { apply small_angle; trivial; try lra. rewrite C1. apply (Rmult_le_reg_r (cosh (2 * alpha t))). lra. rewrite Rinv_l, cd by lra.
      assert (cos e2 * (2 * sinh (alpha t) ^ 2) <= cos e2 * (1 - cos e2)) by (apply Rmult_le_compat_l; unfold e in *; lra).
        pose proof (pow2_ge_0 (1 - cos e2)). lra. }
    apply Rabs_le_between in P1. apply Rabs_le_between in P2. split. apply Rabs_def1; lra. split. apply Rabs_def1; lra. split. apply Rabs_def1; lra.
    destruct (eq_126 x y u w A alpha s S Hs In (psi t) t ltac:(lra) p0 an) as (l & L & B). exists l. split; trivial. eapply Rle_lt_trans. exact B.
    assert (Rabs (psi t - eq124_psi1 (alpha t)) <= 2 * e2) by (apply Rabs_le; lra). pose proof (Ag t ltac:(lra)) as ag.
    assert (/ (2 * A t) <= / (2 * A0)) by (apply Rinv_le_contravar; lra). pose proof (Rinv_0_lt_compat (2 * A t) ltac:(lra)).
    assert ((2 + / (2 * A t)) * sinh (alpha t) ^ 2 <= M * kap) by (apply Rmult_le_compat; [ lra | apply pow2_ge_0 | unfold M; lra | lra ]). lra.
Qed.

Section Escapes.
(* a motion, from the moment s on inside p < rho, with its A and alpha *)
Variables (x y u w A alpha : R -> R) (s : R).
Hypothesis table : spin x y u w.
Hypothesis from : 0 <= s.
Hypothesis inner : forall t, s <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Let inside := inside x y u w A alpha s inner.
Let rates := rates x y u w A alpha s table from inner.
Let up := A_never_falls x y u w table.

Lemma A_to_infinity : (forall M, exists T, s <= T /\ forall t, T <= t -> M < E t) -> is_lim A p_infty p_infty.
Proof.
  intros H. apply is_lim_spec. intros M. destruct (H (M ^ 2)) as (T & T0 & HT). exists T. intros t Ht. specialize (HT t ltac:(lra)).
  destruct (inside t ltac:(lra)) as (A0 & A2 & _). rewrite <- A2 in HT. nra.
Qed.
(* (127): A > 1 is enough for an escape, A and rho grow without end; below 1 no A is: if alpha < ln(1/A) the particle comes to rest for good *)
Theorem eq_127 : (eq127_least_a < A s -> is_lim A p_infty p_infty /\ escapes x y) /\
  (A s < eq127_least_a -> alpha s < ln (1 / A s) -> exists T, forall t, T <= t -> x t = x T /\ y t = y T /\ u t = 0 /\ w t = 0).
Proof.
  destruct (inside s (Rle_refl s)) as (A0 & A2 & _ & _ & _ & sum). unfold eq127_least_a. split; intros H.
  - split. apply A_to_infinity, (unbounded_above_1 x y u w table s from). nra. apply (escapes_from x y u w table s from). nra.
  - intros a. assert (m1 : rho s + p s < 1).
    { rewrite sum. replace 1 with (A s * (1 / A s)) by (field; lra). apply Rmult_lt_compat_l; trivial. rewrite <- (exp_ln (1 / A s)).
      now apply exp_increasing. apply Rdiv_lt_0_compat; lra. }
    pose proof (nrm_pos (u s) (w s)). pose proof (nrm_pos (x s) (y s)). set (T := s + p s / (1 - (rho s + p s))). assert (sT : s <= T).
    { pose proof (Rinv_0_lt_compat (1 - (rho s + p s)) ltac:(lra)). unfold T, Rdiv. nra. }
    exists T. intros t Ht. destruct (caught x y u w table s T from m1 (Rle_refl T)) as (z1 & z2 & r1).
      apply (table_rest_lasts x y u w table T t); try lra.
    now apply at_rest. rewrite <- nrm_sq. pose proof (nrm_pos (x T) (y T)). nra.
Qed.
(* A never falls, and it grows without end unless alpha goes to 0 *)
Theorem s4_A_never_decreases : (forall r t, s <= r <= t -> A r <= A t) /\ (is_lim A p_infty p_infty \/ is_lim alpha p_infty 0).
Proof.
  assert (mono : forall r t, s <= r <= t -> A r <= A t).
  { intros r t Hr. destruct (inside r ltac:(lra)) as (_ & e1 & _). destruct (inside t ltac:(lra)) as (A0 & e2 & _). specialize (up r t ltac:(lra)).
    nra. }
  split; trivial. destruct (Classical_Prop.classic (exists M, forall t, 0 <= t -> E t <= M)) as [[M HM] | no]; [ right | left ].
  - destruct (bounded_ends x y u w table M HM) as (_ & _ & _ & _ & Hu & Hw & _). destruct (inside s (Rle_refl s)) as (a0 & _).
    assert (K : tends (fun t => nrm (u t) (w t) * / A s) 0).
    { unfold nrm. limit. lra. rewrite <- Rplus_0_l, pow_i, !Rplus_0_l, sqrt_0 by auto. ring. }
    pose proof (tends_comp arcsinh _ 0 K (derivable_continuous_pt _ _ (exist _ _ (derivable_pt_lim_arcsinh 0)))) as L. rewrite arcsinh_0 in L.
    apply (is_lim_le_le_loc (fun _ => 0) (fun t => arcsinh (nrm (u t) (w t) * / A s))); trivial. 2: apply is_lim_const. exists s. intros t Ht.
    destruct (inside t ltac:(lra)) as (A0 & _ & k1 & _). pose proof (mono s t ltac:(lra)). pose proof (nrm_pos (u t) (w t)).
    assert (s0 : 0 <= sinh (alpha t)) by nra. rewrite <- (arcsinh_sinh (alpha t)). split. rewrite <- arcsinh_0. now apply arcsinh_le.
    apply arcsinh_le. rewrite k1. replace (sinh (alpha t)) with (A s * sinh (alpha t) * / A s) at 1 by (field; lra).
    apply Rmult_le_compat_r. left; now apply Rinv_0_lt_compat. now apply Rmult_le_compat_r.
  - apply A_to_infinity. intros M. destruct (Classical_Prop.classic (exists T, 0 <= T /\ M < E T)) as [(T & T0 & HT) | n].
    + exists (Rmax s T). split. apply Rmax_l. intros t Ht. pose proof (Rmax_r s T). specialize (up T t ltac:(lra)). lra.
    + exfalso. apply no. exists M. intros t Ht. apply Rnot_lt_le. intros k. apply n. eauto.
Qed.

Hypothesis above : eq127_least_a < A s.
Lemma E_above t : s <= t -> 1 < E t.
Proof. intros Ht. destruct (inside s (Rle_refl s)) as (A0 & A2 & _). unfold eq127_least_a in above. specialize (up s t ltac:(lra)). nra. Qed.

(* A grows without end; the speed never vanishes but in one case: the particle has come straight in, cos psi <= -1/cosh alpha up to
   its stop, where alpha is 0, so that psi went to pi; it stops there once and never again *)
Theorem s4_escape_if_A_above_1 : is_lim A p_infty p_infty /\ ((forall t, s <= t -> 0 < p t) \/
  exists T, s <= T /\ p T = 0 /\ (forall t, T < t -> 0 < p t) /\
    forall t, s <= t < T -> 0 < p t /\ (x t * u t + y t * w t) / (rho t * p t) <= - / cosh (alpha t)).
Proof.
  split. { now apply eq_127. } assert (pos : forall t, p t <> 0 -> 0 < p t) by (intros t n; pose proof (nrm_pos (u t) (w t)); lra).
  destruct (Classical_Prop.classic (exists T, s <= T /\ p T = 0)) as [(T & T0 & z) | never].
  - right. exists T. split; trivial. split; trivial. split. { apply (stops_once x y u w table T); trivial. lra. now apply E_above. }
    intros t Ht. pose proof (E_above t ltac:(lra)) as E1. assert (p0 : 0 < p t).
    { apply pos. intros k. pose proof (stops_once x y u w table t ltac:(lra) E1 k T ltac:(lra)). lra. }
    split; trivial. destruct (inside t ltac:(lra)) as (A0 & A2 & _ & re & _). pose proof (cosh_pos (alpha t)) as c0. apply Rnot_lt_le. intros k.
    enough (0 < p T) by lra. apply (never_stops x y u w table t); try lra. rewrite <- A2, sqrt_pow2 by lra.
      assert (r0 : 0 < rho t) by (rewrite re; nra).
    apply Rlt_div_r in k; [ | nra ]. replace (- / cosh (alpha t) * (rho t * p t)) with (- (A t * p t)) in k by (rewrite re; field; lra). lra.
  - left. intros t Ht. apply pos. eauto.
Qed.

(* rho, p and A^2 over their laws, and the shape of the motion in the end *)
Let law_E t := sqrt 2 / 9 * t ^ 3.
Let r_of t := rho t / right_escape_rho t. Let p_of t := p t / right_escape_rho t. Let e_of t := E t / law_E t.
Lemma right_rho t : 0 < t -> 0 < right_escape_rho t.
Proof. intros H. destruct root2. apply Rmult_lt_0_compat. apply Rdiv_lt_0_compat; lra. now apply pow_lt. Qed.
Lemma in_the_laws t : s <= t -> 1 <= t -> 0 < t /\ 0 < A t /\ 0 < e_of t /\ 0 < r_of t /\ 0 <= p_of t /\ E t = e_of t * law_E t /\ p t = p_of t *
    right_escape_rho t /\
  exp (2 * alpha t) = (r_of t + p_of t) ^ 2 / (4 * e_of t) * (sqrt 2 * t) /\ cosh (alpha t) / A t = 3 / 2 * (r_of t / e_of t) / t /\
  cosh (2 * alpha t) = (r_of t ^ 2 + p_of t ^ 2) / (2 * e_of t) * (t / sqrt 2).
Proof.
  intros Ht t1. destruct root2 as [s0 s2]. destruct (inside t Ht) as (A0 & A2 & k1 & k2 & pr & k3). pose proof (E_above t Ht) as E1.
    pose proof (nrm_pos (u t) (w t)).
  assert (l0 : 0 < law_E t) by (unfold law_E; assert (0 < t ^ 3) by (apply pow_lt; lra); apply Rmult_lt_0_compat; lra).
  pose proof (right_rho t ltac:(lra)) as r0.
  assert (ee : E t = e_of t * law_E t) by (unfold e_of; field; lra). assert (er : rho t = r_of t * right_escape_rho t) by (unfold r_of; field; lra).
  assert (ep : p t = p_of t * right_escape_rho t) by (unfold p_of; field; lra). assert (e0 : 0 < e_of t) by (apply Rdiv_lt_0_compat; lra).
  assert (R0 : 0 < r_of t) by (apply Rdiv_lt_0_compat; lra).
    assert (P0 : 0 <= p_of t) by (apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ]; lra).
  do 5 (split; [ lra | ]). do 2 (split; trivial). rewrite ee in A2. unfold law_E, right_escape_rho in *. split; [ | split ].
  - replace (exp (2 * alpha t)) with ((A t * exp (alpha t)) ^ 2 / A t ^ 2). 2: { replace (2 * alpha t) with (alpha t + alpha t) by ring.
    rewrite exp_plus. field. lra. }
    rewrite <- k3, A2, er, ep. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - replace (cosh (alpha t) / A t) with (rho t / A t ^ 2) by (rewrite k2; field; lra). rewrite A2, er.
    field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - rewrite cosh_double. replace (1 + 2 * sinh (alpha t) ^ 2) with ((rho t ^ 2 + p t ^ 2) / A t ^ 2). 2: { rewrite k1, k2, !Rpow_mult_distr, cosh2.
    field. lra. }
    rewrite A2, er, ep. field_simplify_eq; [ ring [s2] | repeat split; lra ].
Qed.
Ltac known T := destruct (escape_laws x y u w table s from (E_above s (Rle_refl s))) as (T & Ts & T1 & HT & Nr & Np & Ne & Nc & Ll);
  change (near r_of (- (3 * sqrt 2 / 2))) in Nr; change (near p_of (- (3 * sqrt 2 / 2))) in Np; change (near e_of (- (9 * sqrt 2 / 4))) in Ne;
  pose proof (near_one _ _ Nr) as Lr; pose proof (near_one _ _ Np) as Lp; pose proof (near_one _ _ Ne) as Le; pose proof (near_one _ _ Nc) as Lc;
    cbv beta in Lc;
  destruct root2 as [s0 s2].
Ltac seen t := destruct (in_the_laws t) as (t0 & A0 & e0 & r0 & p0 & ee & ep & ea & ca & c2); [ lra | lra | ].

(* the rate of alpha at large times goes as 1/(2 t), as does the right side of (128) as corrected *)
Theorem eq_128 dalpha : (forall t, s <= t -> 0 < p t -> rder alpha t (dalpha t)) ->
  is_lim (fun t => dalpha t / right_escape_alpha_rate (alpha t) (A t)) p_infty 1 /\
  is_lim (fun t => t * dalpha t) p_infty (1 / 2) /\ is_lim (fun t => t * right_escape_alpha_rate (alpha t) (A t)) p_infty (1 / 2).
Proof.
  intros D. known T. assert (K : tends (fun t => t * dalpha t) (1 / 2)).
  { apply (tends_ext T (fun t => 2 * (xi t / rho t / right_escape_lag t) - 3 / 2 * (r_of t / e_of t))).
    - intros t Ht. seen t. destruct (HT t Ht) as (q0 & x0 & _). destruct (angle_exists (x t) (y t) (u t) (w t)) as (psi & a & _).
      apply angle_iff in a.
      destruct (inside t ltac:(lra)) as (_ & _ & _ & _ & pr & _).
        rewrite (rder_unique _ _ _ _ (D t ltac:(lra) q0) (proj2 (rates t psi ltac:(lra) a) q0)).
      unfold eq114_alpha_rate, right_escape_lag. rewrite ca, (proj1 a). field. repeat split; lra.
    - limit. lra. field. }
  assert (L : tends (fun t => t * right_escape_alpha_rate (alpha t) (A t)) (1 / 2)).
  { apply (tends_ext T (fun t => 4 * e_of t / (r_of t ^ 2 + p_of t ^ 2) - 3 / 2 * (r_of t / e_of t))).
    - intros t Ht. seen t. unfold right_escape_alpha_rate. rewrite ca, c2. field_simplify_eq; [ ring [s2] | repeat split; nra ].
    - limit. lra. lra. field. }
  split; [ | now split ]. destruct (in_the_end 1 _ _ (1 / 2) L ltac:(lra)) as (T2 & T20 & H2).
  apply (tends_ext T2 (fun t => (t * dalpha t) * / (t * right_escape_alpha_rate (alpha t) (A t)))).
  - intros t Ht. specialize (H2 t Ht). field. split; nra.
  - limit. lra. field.
Qed.
(* ... while t times the right side as printed goes to a negative number *)
Theorem eq_128__printed dalpha : (forall t, s <= t -> 0 < p t -> rder alpha t (dalpha t)) ->
  is_lim (fun t => t * dalpha t) p_infty (1 / 2) /\ is_lim (fun t => t * eq128_alpha_rate (alpha t) (A t)) p_infty (sqrt 2 - 3 / 2) /\ sqrt 2 - 3 / 2 < 0.
Proof.
  intros D. split; [ exact (proj1 (proj2 (eq_128 dalpha D))) | ]. known T. split; [ | nra ]. apply (tends_ext T (fun t => 2 * sqrt 2 * e_of t / (r_of t ^ 2 + p_of t ^ 2) - 3 / 2 * (r_of t / e_of t))).
  - intros t Ht. seen t. unfold eq128_alpha_rate. rewrite ca, c2. field. repeat split; nra.
  - limit. lra. lra. field.
Qed.
(* cosh alpha cosh 2 alpha over A goes to 3 sqrt 2/4, which is not 1 *)
Theorem eq_129 : is_lim (fun t => eq129_a (alpha t) / A t) p_infty right_escape_product_over_a.
Proof.
  known T. apply (tends_ext T (fun t => 3 * sqrt 2 / 8 * r_of t * (r_of t ^ 2 + p_of t ^ 2) / e_of t ^ 2)).
  - intros t Ht. seen t. unfold eq129_a. symmetry. transitivity (cosh (alpha t) / A t * cosh (2 * alpha t)). unfold Rdiv; ring.
    rewrite ca, c2. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - limit. lra. unfold right_escape_product_over_a. field.
Qed.
Theorem eq_129__printed : misses (fun t => eq129_a (alpha t)) A right_escape_product_over_a.
Proof. split. exact eq_129. pose proof six_hundredths. lra. Qed.
(* alpha less its law in A goes to 0, and A grows without end *)
Theorem eq_130 : is_lim (fun t => alpha t - right_escape_alpha_by_a (A t)) p_infty 0 /\ is_lim A p_infty p_infty.
Proof.
  split; [ | apply s4_escape_if_A_above_1 ]. known T. apply (tends_ext T (fun t => ln ((r_of t + p_of t) ^ 6 / (64 * e_of t ^ 4)) / 6)).
  - intros t Ht. seen t. destruct (inside t ltac:(lra)) as (_ & A2 & _). unfold right_escape_alpha_by_a. set (L := ln (3 * sqrt 2 * A t)).
    assert (eL : exp L = 3 * sqrt 2 * A t) by (apply exp_ln; nra).
      replace ((r_of t + p_of t) ^ 6 / (64 * e_of t ^ 4)) with (exp (2 * alpha t) ^ 3 / exp L ^ 2).
    { replace (exp (2 * alpha t) ^ 3 / exp L ^ 2) with (exp (6 * alpha t - 2 * L)). rewrite ln_exp. field.
      replace (6 * alpha t - 2 * L) with (2 * alpha t + 2 * alpha t + 2 * alpha t + - L + - L) by ring. rewrite !exp_plus, !exp_Ropp. field.
        apply Rgt_not_eq, exp_pos. }
    rewrite eL, ea, !Rpow_mult_distr, A2, ee. unfold law_E. rewrite s2. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - limit. lra. lra. replace ((1 + 1) ^ 6 * / (64 * 1 ^ 4)) with 1 by field. rewrite ln_1. ring.
Qed.
Lemma ln_six : 0 < ln right_escape_product_over_a.
Proof. pose proof six_hundredths. rewrite <- ln_1. apply ln_increasing; lra. Qed.
(* (130) as printed differs by a third of the logarithm of 3 sqrt 2/4 *)
Theorem eq_130__printed : is_lim (fun t => alpha t - eq130_alpha (A t)) p_infty (ln right_escape_product_over_a / 3) /\ ln
  right_escape_product_over_a / 3 <> 0.
Proof.
  pose proof six_hundredths. pose proof ln_six. split; [ | lra ]. destruct eq_130 as [K _].
  apply (tends_ext s (fun t => alpha t - right_escape_alpha_by_a (A t) + ln right_escape_product_over_a / 3)); [ | limit; ring ].
  intros t Ht. destruct (inside t Ht) as (A0 & _). unfold eq130_alpha, right_escape_alpha_by_a.
  replace (3 * sqrt 2 * A t) with (right_escape_product_over_a * (4 * A t)) by (unfold right_escape_product_over_a; field). rewrite ln_mult by lra.
    field.
Qed.
(* the rate of A over its law in A goes to 1 *)
Theorem eq_131 dA : (forall t, s <= t -> rder A t (dA t)) -> is_lim (fun t => dA t / right_escape_a_rate (A t)) p_infty 1.
Proof.
  intros D. destruct eq_130 as [K _]. known T.
  apply (tends_ext T (fun t => 2 * p_of t / (r_of t + p_of t) * exp (alpha t - right_escape_alpha_by_a (A t)))).
  - intros t Ht. seen t. destruct (angle_exists (x t) (y t) (u t) (w t)) as (psi & a & _). apply angle_iff in a.
    destruct (inside t ltac:(lra)) as (_ & _ & k1 & _ & pr & k3).
    rewrite (rder_unique _ _ _ _ (D t ltac:(lra)) (proj1 (rates t psi ltac:(lra) a))).
      unfold right_escape_a_rate, Rpower, right_escape_alpha_by_a, eq113_a_rate.
    set (L := ln (3 * sqrt 2 * A t)). replace (alpha t - L / 3) with (alpha t + - (1 / 3 * L)) by field. rewrite exp_plus, exp_Ropp.
      pose proof (exp_pos (1 / 3 * L)).
    replace (exp (alpha t)) with ((rho t + p t) / A t) by (rewrite k3; field; lra).
      replace (sinh (alpha t)) with (p t / A t) by (rewrite k1; field; lra).
    pose proof (right_rho t t0). unfold r_of, p_of. field. pose proof (nrm_pos (u t) (w t)). repeat split; lra.
  - pose proof (tends_comp exp _ _ K (derivable_continuous_pt _ _ (derivable_pt_exp 0))) as X. cbv beta in X. rewrite exp_0 in X. limit. lra. field.
Qed.
Theorem eq_131__printed dA : (forall t, s <= t -> rder A t (dA t)) ->
  is_lim (fun t => dA t / eq131_a_rate (A t)) p_infty (Rpower right_escape_product_over_a (1 / 3)) /\ Rpower right_escape_product_over_a (1 / 3) <> 1.
Proof.
  intros D. pose proof six_hundredths as c1. split. 2: { assert (1 < Rpower right_escape_product_over_a (1 / 3)); [ | lra ].
    rewrite <- (Rpower_O right_escape_product_over_a) at 1 by lra. apply Rpower_lt; lra. }
  pose proof (eq_131 dA D) as K.
    apply (tends_ext s (fun t => dA t / right_escape_a_rate (A t) * Rpower right_escape_product_over_a (1 / 3))); [ | limit; ring ].
  intros t Ht. destruct (inside t Ht) as (A0 & _). unfold eq131_a_rate, right_escape_a_rate.
  replace (3 * sqrt 2 * A t) with (right_escape_product_over_a * (4 * A t)) by (unfold right_escape_product_over_a; field).
  rewrite <- Rpower_mult_distr by lra. field. split; apply Rgt_not_eq, exp_pos.
Qed.

(* A *)
Lemma right_a t : 0 < t -> right_escape_a t = sqrt (law_E t).
Proof.
  intros t0. destruct root2 as [s0 s2]. assert (t3 : 0 < t ^ 3) by now apply pow_lt. unfold right_escape_a, law_E.
  replace (3 / 2) with (INR 3 * / 2) by (simpl; field). rewrite <- Rpower_mult, Rpower_pow, Rpower_sqrt, sqrt_mult by lra. f_equal.
  pose proof (sqrt_pos (sqrt 2)). rewrite <- (sqrt_pow2 (sqrt (sqrt 2) / 3)) by lra. f_equal. unfold Rdiv. rewrite Rpow_mult_distr, root_sq by lra.
    field.
Qed.
Theorem eq_132 : follows A right_escape_a (- (9 * sqrt 2 / 8)).
Proof.
  known T. apply follows_of, (near_ext T (fun t => sqrt (e_of t))).
  - intros t Ht. seen t. destruct (inside t ltac:(lra)) as (_ & A2 & _). rewrite right_a by trivial. rewrite <- (sqrt_pow2 (A t)), A2, ee by lra.
    assert (0 < law_E t) by (pose proof (E_above t ltac:(lra)); nra). rewrite sqrt_mult by lra. pose proof (sqrt_lt_R0 (law_E t) ltac:(lra)).
      field. lra.
  - eapply near_eq. nears. field.
Qed.
Theorem eq_132__printed : misses A eq132_a (sqrt right_escape_product_over_a).
Proof.
  pose proof six_hundredths as c1. apply (misses_of _ _ _ _ _ eq_132).
  - intros t t1. unfold right_escape_a, eq132_a. assert (P : 0 < Rpower t (3 / 2)) by apply exp_pos. destruct root2 as [s0 s2].
    pose proof (sqrt_lt_R0 (sqrt 2) s0).
    pose proof (sqrt_lt_R0 27 ltac:(lra)). replace (sqrt right_escape_product_over_a) with (sqrt (sqrt 2) * sqrt 27 / 6). field. lra.
    rewrite <- (sqrt_pow2 (sqrt (sqrt 2) * sqrt 27 / 6)) by nra. f_equal. unfold Rdiv. rewrite !Rpow_mult_distr, !root_sq by lra.
      unfold right_escape_product_over_a. field.
  - rewrite <- sqrt_1 at 1. apply sqrt_lt_1_alt. lra.
Qed.
(* alpha *)
Theorem eq_133 : is_lim (fun t => alpha t - right_escape_alpha t) p_infty 0.
Proof.
  known T. apply (tends_ext T (fun t => ln ((r_of t + p_of t) ^ 2 / (4 * e_of t)) / 2)).
  - intros t Ht. seen t. unfold right_escape_alpha. replace (alpha t) with (ln (exp (2 * alpha t)) / 2) by (rewrite ln_exp; field).
    rewrite ea, ln_mult. field.
    apply Rdiv_lt_0_compat; nra. nra.
  - limit. lra. lra. replace ((1 + 1) ^ 2 * / (4 * 1)) with 1 by field. rewrite ln_1. ring.
Qed.
Theorem eq_133__printed : is_lim (fun t => alpha t - eq133_alpha t) p_infty (ln right_escape_product_over_a / 2) /\ ln right_escape_product_over_a /
  2 <> 0.
Proof.
  pose proof six_hundredths. pose proof ln_six. pose proof eq_133 as K. split; [ | lra ].
  apply (tends_ext 1 (fun t => alpha t - right_escape_alpha t + ln right_escape_product_over_a / 2)); [ | limit; ring ]. intros t Ht.
    unfold eq133_alpha, right_escape_alpha.
  replace (sqrt 2 * t) with (right_escape_product_over_a * (4 * t / 3)) by (unfold right_escape_product_over_a; field). rewrite ln_mult by lra. field.
Qed.

(* pi/2 - psi, where psi is chosen between - pi and pi *)
Lemma sine_below d : 0 < d < PI -> d * cos d <= sin d <= d.
Proof.
  intros Hd. split; [ | left; now apply sin_lt_x ]. enough (d * cos d - sin d <= 0 * cos 0 - sin 0) by (rewrite sin_0 in *; lra).
  apply (rder_decr (fun r => r * cos r - sin r)); [ lra | intros r Hr; apply derivable_continuous_pt; reg | ]. intros r Hr. eexists. split.
  apply rder_of. auto_derive; trivial. pose proof (sin_ge_0 r ltac:(lra) ltac:(lra)). nra.
Qed.
Theorem eq_134 psi (range : forall t, s <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) :
  follows (fun t => PI / 2 - psi t) right_escape_lag (3 * sqrt 2 / 4).
Proof.
  known T. destruct (in_the_end T _ 0 (/ 2) Ll ltac:(lra)) as (T2 & T20 & H2).
  assert (K : forall t, T2 <= t -> 0 < xi t / rho t /\ 0 <= t * ((PI / 2 - psi t) / (xi t / rho t) - 1) <= 2 * (t * (1 + ((x t * w t - y t * u t) *
    / p t) / rho t))).
  { intros t Ht. specialize (H2 t Ht). destruct (HT t ltac:(lra)) as (p0 & x0 & _). destruct (range t ltac:(lra)) as [rg [a1 a2]].
    destruct (inside t ltac:(lra)) as (_ & _ & _ & _ & pr & _). assert (c0 : xi t / rho t = cos (psi t)) by (rewrite a1; field; lra).
    replace ((x t * w t - y t * u t) * / p t / rho t) with (- sin (psi t)) in * by (rewrite a2; field; lra). rewrite c0.
    assert (cp : 0 < cos (psi t)) by (rewrite <- c0; apply Rdiv_lt_0_compat; lra). pose proof PI_RGT_0.
    assert (d0 : / 2 < sin (psi t)).
    { apply Rnot_le_lt. intros k. assert (1 * / 2 <= t * (1 + - sin (psi t))) by (apply Rmult_le_compat; lra). lra. }
    assert (0 < psi t < PI / 2).
    { split; apply Rnot_le_lt; intros k; [ pose proof (sin_ge_0 (- psi t) ltac:(lra) ltac:(lra)) as q; rewrite sin_neg in q; lra |
      pose proof (cos_le_0 (psi t) ltac:(lra) ltac:(lra)); lra ]. }
    destruct (sine_below (PI / 2 - psi t) ltac:(lra)) as [b1 b2]. rewrite sin_shift, cos_shift in *. set (c := cos (psi t)) in *.
      set (d := sin (psi t)) in *.
    set (de := PI / 2 - psi t) in *. split; trivial. assert (q1 : 1 <= de / c) by (apply Rle_div_r; lra). split. apply Rmult_le_pos; lra.
    replace (2 * (t * (1 + - d))) with (t * (2 * (1 - d))) by ring. apply Rmult_le_compat_l. lra. enough (de / c <= 1 + 2 * (1 - d)) by lra.
    apply Rle_div_l; trivial. apply (Rmult_le_reg_r d); [ lra | ]. assert (d <= 1) by apply SIN_bound.
    assert (k : 1 <= (1 + 2 * (1 - d)) * d) by nra. apply (Rmult_le_compat_l c) in k; lra. }
  apply follows_of, (near_ext T2 (fun t => xi t / rho t / right_escape_lag t * ((PI / 2 - psi t) / (xi t / rho t)))).
  - intros t Ht. destruct (K t Ht) as [c0 _]. unfold right_escape_lag. set (c := xi t / rho t) in *. field. lra.
  - eapply near_eq. apply near_mult. exact Nc. apply (near_small T2 _ (fun t => t * ((PI / 2 - psi t) / (xi t / rho t) - 1)) 0).
    + apply (is_lim_le_le_loc (fun _ => 0) (fun t => 2 * (t * (1 + ((x t * w t - y t * u t) * / p t) / rho t)))).
      exists T2. intros t Ht. apply K. lra. apply is_lim_const. limit. ring.
    + intros t Ht. destruct (K t Ht) as [c0 _]. set (c := xi t / rho t) in *. field. lra.
    + ring.
Qed.
Theorem eq_134__printed psi (range : forall t, s <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) :
  misses (fun t => PI / 2 - psi t) eq134_lag 0.
Proof.
  destruct (eq_134 psi range) as [K _]. split; [ | lra ].
    pose proof (is_lim_inv (fun t => t) p_infty p_infty (is_lim_id p_infty) ltac:(discriminate)) as I. simpl in I.
  apply (tends_ext 1 (fun t => (PI / 2 - psi t) / right_escape_lag t * (2 / 3 * sqrt (3 * / t)))).
  - intros t Ht. unfold right_escape_lag, eq134_lag. replace (1 / 2) with (/ 2) by field. assert (q : 0 < 3 / t) by (apply Rdiv_lt_0_compat; lra).
    rewrite Rpower_sqrt by trivial. change (3 * / t) with (3 / t). pose proof (sqrt_lt_R0 _ q) as r0. pose proof (root_sq (3 / t) ltac:(lra)) as r2.
    set (k := sqrt (3 / t)) in *. replace ((PI / 2 - psi t) / (2 / t)) with ((PI / 2 - psi t) * (3 / (2 * (3 / t)))) by (field; lra).
      rewrite <- r2. field. lra.
  - limit. rewrite Rmult_0_r. lra. rewrite Rmult_0_r, sqrt_0. ring.
Qed.
(* the speed p and the distance rho *)
Theorem eq_135 : follows (fun t => p t) right_escape_rho (- (3 * sqrt 2 / 2)).
Proof. known T. now apply follows_of. Qed.
Theorem eq_136 : follows (fun t => rho t) right_escape_rho (- (3 * sqrt 2 / 2)).
Proof. known T. now apply follows_of. Qed.
Lemma over_printed f g c : follows f right_escape_rho c -> (forall t, g t = 2 * t ^ 2 / 9) -> misses f g right_escape_product_over_a.
Proof.
  intros F G. destruct root2 as [s0 s2]. apply (misses_of _ _ _ _ _ F), six_hundredths. intros t t1. rewrite G.
    unfold right_escape_rho, right_escape_product_over_a.
  field_simplify_eq; [ ring [s2] | lra ].
Qed.
Theorem eq_135__printed : misses (fun t => p t) eq135_p right_escape_product_over_a.
Proof. apply (over_printed _ _ _ eq_135). reflexivity. Qed.
Theorem eq_136__printed : misses (fun t => rho t) eq136_rho right_escape_product_over_a.
Proof. apply (over_printed _ _ _ eq_136). reflexivity. Qed.

(* the length of the path *)
Section Path.
Variable len : R -> R.
Hypothesis path : arc_length u w len.
Lemma energy t : s <= t -> E t / 2 = len t + (E s / 2 - len s).
Proof.
  intros Ht. destruct path as [C D]. enough (E t * / 2 - len t = E s * / 2 - len s) by lra.
    apply (rder_const (fun t => E t * / 2 - len t)); trivial; intros r Hr.
  - pose proof (C r ltac:(lra)). conts table.
  - pose proof (E_rate x y u w table r ltac:(lra)). pose proof (D r ltac:(lra)). eapply rder_eq.
    apply (rder_minus (fun t => E t * / 2) len); [ | eassumption ].
    apply (rder_mult (fun t => E t)); [ eassumption | rdq ]. unfold eq105_arc_rate. field.
Qed.
Theorem eq_137 : follows len right_escape_s (- (9 * sqrt 2 / 4)).
Proof.
  known T. set (c := E s / 2 - len s). pose proof (is_lim_inv (fun t => t) p_infty p_infty (is_lim_id p_infty) ltac:(discriminate)) as I. simpl in I.
  apply follows_of, (near_ext T (fun t => e_of t * (1 - 9 * sqrt 2 * c / (e_of t * t ^ 3)))).
  - intros t Ht. seen t. pose proof (energy t ltac:(lra)) as e. fold c in e. rewrite ee in e. replace (len t) with (e_of t * law_E t / 2 - c) by lra.
    unfold law_E, right_escape_s. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - eapply near_eq. apply near_mult. exact Ne. apply (near_small T _ (fun t => - (9 * sqrt 2 * c / e_of t) * (/ t) ^ 2) 0). limit. lra. ring.
    intros t Ht. seen t. field. lra. ring.
Qed.
Theorem eq_137__printed : misses len eq137_s right_escape_product_over_a.
Proof.
  destruct root2 as [s0 s2]. apply (misses_of _ _ _ _ _ eq_137), six_hundredths. intros t t1.
    unfold right_escape_s, eq137_s, right_escape_product_over_a.
  field_simplify_eq; [ ring [s2] | lra ].
Qed.
(* A^2/2 over s goes to 1: by (104) their difference is constant, whatever the motion, and s grows without end *)
Theorem eq_138 : is_lim (fun t => eq138_s (A t) / len t) p_infty 1.
Proof.
  destruct eq_137 as [K _]. known T. destruct (in_the_end T _ _ (/ 2) K ltac:(lra)) as (T2 & T20 & H2).
    apply (tends_ext T2 (fun t => e_of t / (len t / right_escape_s t))).
  - intros t Ht. specialize (H2 t Ht). seen t. destruct (inside t ltac:(lra)) as (_ & A2 & _). unfold eq138_s. rewrite A2, ee.
    assert (t3 : 0 < t ^ 3) by (apply pow_lt; lra).
      assert (len t <> 0) by (intros k; rewrite k in H2; unfold Rdiv in H2; rewrite Rmult_0_l in H2; lra).
    unfold law_E, right_escape_s. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - limit. lra. field.
Qed.
End Path.
(* alpha grows without end *)
Theorem s4_alpha_unbounded : is_lim alpha p_infty p_infty.
Proof.
  destruct (in_the_end 1 _ 0 1 eq_133 Rlt_0_1) as (T & T0 & HT). destruct root2 as [s0 s2]. apply is_lim_spec. intros M.
  exists (Rmax T (exp (2 * (M + 1)))). intros t Ht. pose proof (Rmax_l T (exp (2 * (M + 1)))). pose proof (Rmax_r T (exp (2 * (M + 1)))).
  specialize (HT t ltac:(lra)). unfold right_escape_alpha in HT. enough (2 * (M + 1) <= ln (sqrt 2 * t)) by lra.
  rewrite <- (ln_exp (2 * (M + 1))) at 1. apply ln_mono. split. apply exp_pos. nra.
Qed.
End Escapes.

(* ---- what these theorems speak of exists ---- *)
(* the angle between - pi and pi *)
Definition angle_of x y u w := if Req_EM_T (nrm x y * nrm u w + (x * u + y * w)) 0 then PI else proj1_sig (angle_exists x y u w).
Lemma angle_of_spec x y u w : - PI < angle_of x y u w <= PI /\ angle x y u w (angle_of x y u w).
Proof.
  unfold angle_of. pose proof PI_RGT_0. destruct (angle_exists x y u w) as (psi & a & k). simpl. apply angle_iff in a.
    destruct (Req_EM_T _ 0) as [z | n].
  - split. lra. split; rewrite ?cos_PI, ?sin_PI; [ lra | ]. destruct a as [a1 a2]. set (m := nrm x y * nrm u w) in *.
    destruct (sq_sum (m * sin psi) 0); [ | lra ]. replace (_ + _) with (m ^ 2 * (cos psi ^ 2 + sin psi ^ 2) - (m * cos psi) ^ 2) by ring.
    rewrite unit_circle. replace (m * cos psi) with (- m) by lra. lra.
  - split; trivial. rewrite (k n). unfold half_angle. pose proof (atan_bound ((y * u - x * w) / (nrm x y * nrm u w + (x * u + y * w)))). lra.
Qed.
(* every start inside p < rho has a motion, with A, alpha and psi *)
Lemma inner_exists a b c d : nrm c d < nrm a b -> exists x y u w A alpha, spin x y u w /\ (x 0 = a /\ y 0 = b /\ u 0 = c /\ w 0 = d) /\
  forall t, 0 <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t).
Proof.
  intros H. destruct (table_exists a b c d) as (x & y & u & w & S & e). exists x, y, u, w. assert (e' := e). destruct e' as (<- & <- & <- & <-).
  destruct (with_A x y u w S H) as (A & alpha & K). exists A, alpha. split; trivial. split; trivial. intros t Ht. split; [ | now apply K ].
  now apply (A_rate x y u w A alpha S 0 (Rle_refl 0)).
Qed.
(* one that escapes and never stops, from rho = 2 outward, p = 1, with all that goes with it *)
Lemma an_escape : exists x y u w A alpha, spin x y u w /\ (forall t, 0 <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t)) /\
  eq127_least_a < A 0 /\ (forall t, 0 <= t -> 0 < nrm (u t) (w t)) /\
  (exists psi, forall t, 0 <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) /\
  (exists dA, forall t, 0 <= t -> rder A t (dA t)) /\ (exists dalpha, forall t, 0 <= t -> 0 < nrm (u t) (w t) -> rder alpha t (dalpha t)) /\
  exists len, arc_length u w len.
Proof.
  destruct (inner_exists 2 0 1 0) as (x & y & u & w & A & alpha & S & (e1 & e2 & e3 & e4) & In). rewrite !nrm_x0; lra. exists x, y, u, w, A, alpha.
  destruct (inside x y u w A alpha 0 In 0 (Rle_refl 0)) as (A0 & A2 & _). rewrite e1, e2, e3, e4 in A2. split; trivial. split; trivial.
  split. { unfold eq127_least_a. nra. } split.
  { apply (never_stops x y u w S 0 (Rle_refl 0)); rewrite e1, e2, e3, e4. lra. pose proof (nrm_pos 1 0).
    pose proof (sqrt_pos (2 ^ 2 + 0 ^ 2 - (1 ^ 2 + 0 ^ 2))). nra. }
  pose (psi t := angle_of (x t) (y t) (u t) (w t)).
    assert (a : forall t, - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) by (intros; apply angle_of_spec).
  pose proof (fun t Ht => rates x y u w A alpha 0 S (Rle_refl 0) In t (psi t) Ht (proj2 (a t))) as R. split. { exists psi. auto. }
  split. { eexists. intros t Ht. exact (proj1 (R t Ht)). } split. { eexists. intros t Ht. exact (proj2 (R t Ht)). }
  eexists. apply (arc_exists 1 1 x y u w Rlt_0_1). now apply spin_is_turntable.
Qed.
Ltac an_escape := intros H; pose proof (Rle_refl 0); destruct an_escape as (x & y & u & w & A & alpha & S & In & A1 & p0 & (psi & Hpsi) & (dA & HdA)
  & (dalpha & Hda) & len & Hlen); first [ eapply (H x y u w A alpha 0); eassumption | idtac ].
Lemma eq_126__occurs : ltac:(occurs eq_126).
Proof. an_escape. apply (H x y u w A alpha 0 S ltac:(lra) In (psi 0) 0); auto. now apply Hpsi. Qed.
Lemma eq_127__occurs : ltac:(occurs eq_127). Proof. an_escape. Qed.
Lemma s4_A_never_decreases__occurs : ltac:(occurs s4_A_never_decreases). Proof. an_escape. Qed.
Lemma s4_escape_if_A_above_1__occurs : ltac:(occurs s4_escape_if_A_above_1). Proof. an_escape. Qed.
Lemma eq_128__occurs : ltac:(occurs eq_128). Proof. an_escape. Qed.
Lemma eq_128__printed__occurs : ltac:(occurs eq_128__printed). Proof. an_escape. Qed.
Lemma eq_129__occurs : ltac:(occurs eq_129). Proof. an_escape. Qed.
Lemma eq_129__printed__occurs : ltac:(occurs eq_129__printed). Proof. an_escape. Qed.
Lemma eq_130__occurs : ltac:(occurs eq_130). Proof. an_escape. Qed.
Lemma eq_130__printed__occurs : ltac:(occurs eq_130__printed). Proof. an_escape. Qed.
Lemma eq_131__occurs : ltac:(occurs eq_131). Proof. an_escape. Qed.
Lemma eq_131__printed__occurs : ltac:(occurs eq_131__printed). Proof. an_escape. Qed.
Lemma eq_132__occurs : ltac:(occurs eq_132). Proof. an_escape. Qed.
Lemma eq_132__printed__occurs : ltac:(occurs eq_132__printed). Proof. an_escape. Qed.
Lemma eq_133__occurs : ltac:(occurs eq_133). Proof. an_escape. Qed.
Lemma eq_133__printed__occurs : ltac:(occurs eq_133__printed). Proof. an_escape. Qed.
Lemma eq_134__occurs : ltac:(occurs eq_134). Proof. an_escape. Qed.
Lemma eq_134__printed__occurs : ltac:(occurs eq_134__printed). Proof. an_escape. Qed.
Lemma eq_135__occurs : ltac:(occurs eq_135). Proof. an_escape. Qed.
Lemma eq_135__printed__occurs : ltac:(occurs eq_135__printed). Proof. an_escape. Qed.
Lemma eq_136__occurs : ltac:(occurs eq_136). Proof. an_escape. Qed.
Lemma eq_136__printed__occurs : ltac:(occurs eq_136__printed). Proof. an_escape. Qed.
Lemma eq_137__occurs : ltac:(occurs eq_137). Proof. an_escape. Qed.
Lemma eq_137__printed__occurs : ltac:(occurs eq_137__printed). Proof. an_escape. Qed.
Lemma eq_138__occurs : ltac:(occurs eq_138). Proof. an_escape. Qed.
Lemma s4_alpha_unbounded__occurs : ltac:(occurs s4_alpha_unbounded). Proof. an_escape. Qed.
(* every A, psi and alpha there are at a start: what s4_small_alpha speaks of exists *)
Lemma s4_small_alpha__occurs A0 psi0 a : 0 < A0 -> - PI < psi0 < PI -> 0 < a -> exists x y u w A alpha psi, spin x y u w /\
  (forall t, 0 <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t)) /\ (forall t, 0 <= t -> - PI < psi t <= PI /\ angle (x t) (y t)
    (u t) (w t) (psi t)) /\
  A 0 = A0 /\ psi 0 = psi0 /\ alpha 0 = a.
Proof.
  intros a0 Hpsi Ha. pose proof (cosh_pos a) as c0. assert (s0 : 0 < sinh a) by (rewrite <- sinh_0; now apply sinh_lt). pose proof (cosh2 a) as ch.
  assert (ac : 0 < A0 * cosh a) by now apply Rmult_lt_0_compat. assert (as0 : 0 < A0 * sinh a) by now apply Rmult_lt_0_compat.
  assert (rn : nrm (A0 * cosh a) 0 = A0 * cosh a) by (apply nrm_x0; lra).
  assert (pn : nrm (A0 * sinh a * cos psi0) (- (A0 * sinh a * sin psi0)) = A0 * sinh a).
  { rewrite <- (sqrt_pow2 (A0 * sinh a)) at 3 by lra. unfold nrm. f_equal. rewrite <- (Rmult_1_r ((A0 * sinh a) ^ 2)), <- (unit_circle psi0). ring. }
  destruct (inner_exists (A0 * cosh a) 0 (A0 * sinh a * cos psi0) (- (A0 * sinh a * sin psi0))) as (x & y & u & w & A & alpha & S & (e1 & e2 & e3 &
    e4) & In).
  { rewrite rn, pn. nra. }
  exists x, y, u, w, A, alpha, (fun t => if Req_EM_T t 0 then psi0 else angle_of (x t) (y t) (u t) (w t)). split; trivial. split; trivial. split.
  { intros t _. destruct (Req_EM_T t 0) as [-> | _]; [ | apply angle_of_spec ]. split. lra. unfold angle. rewrite e1, e2, e3, e4, rn, pn.
    split; ring. }
  destruct (inside x y u w A alpha 0 In 0 (Rle_refl 0)) as (Ap & A2 & k1 & _). rewrite e3, e4, pn in k1. assert (A00 : A 0 = A0).
  { rewrite E_is, e1, e2, e3, e4, rn, pn, !Rpow_mult_distr, ch in A2. apply Rsqr_inj; try lra. rewrite !Rsqr_pow2. lra. }
  split; trivial. split. now destruct (Req_EM_T 0 0). rewrite <- (arcsinh_sinh (alpha 0)), <- (arcsinh_sinh a). f_equal. rewrite A00 in k1. nra.
Qed.
(* ... and one that is caught as (127) says: from rho = 1/2, p = 1/4 *)
Lemma eq_127__caught__occurs : exists x y u w A alpha, spin x y u w /\ (forall t, 0 <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha
  t)) /\
  A 0 < eq127_least_a /\ 0 < alpha 0 < ln (1 / A 0).
Proof.
  destruct (inner_exists (/ 2) 0 (/ 4) 0) as (x & y & u & w & A & alpha & S & (e1 & e2 & e3 & e4) & In). rewrite !nrm_x0; lra.
  exists x, y, u, w, A, alpha. split; trivial. split; trivial. destruct (inside x y u w A alpha 0 In 0 (Rle_refl 0)) as (A0 & A2 & k1 & _ & _ & sum).
  rewrite e1, e2, e3, e4, !nrm_x0 in * by lra. unfold eq127_least_a. split. nra. split. { apply sinh_sign. nra. }
  rewrite <- (ln_exp (alpha 0)). apply ln_increasing. apply exp_pos. apply Rlt_div_r; trivial. lra.
Qed.
