(* Section 4, A > 1: the escape, (126) to (138). Units: mu g = Omega = 1, so that every number here has no dimension.
   Every motion with A > 1 at some moment escapes by the laws shown here; of the printed ones (128) to (137) none holds. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate TableAngle QuasiFixed Formulas Analysis Late Alpha Spiral Small.
Open Scope R_scope.

(* f is law (1 + c (ln t)/t + o((ln t)/t)) as t goes to infinity; both are functions of the time, dimensionless *)
Definition follows (f law : R -> R) (c : R) : Prop :=
  is_lim (fun t => f t / law t) p_infty 1 /\ is_lim (fun t => (f t / law t - 1) * (t / ln t)) p_infty c.
(* f over law goes to a number, which is not 1 *)
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
Proof. intros Ht p0. destruct (inside t Ht) as (A0 & _ & k1 & _). rewrite k1 in p0. assert (0 < sinh (alpha t)) by nra. split; trivial. now apply sinh_sign. Qed.
(* (113), and (114) with the angle at this moment *)
Lemma rates t psi : s <= t -> angle (x t) (y t) (u t) (w t) psi -> rder A t (eq113_a_rate (alpha t)) /\
  (0 < p t -> rder alpha t (eq114_alpha_rate (A t) (alpha t) psi)).
Proof.
  intros Ht a. destruct (inside t Ht) as (A0 & _ & _ & _ & pr & _). assert (K : forall r, t <= r -> hyperbolic (x r) (y r) (u r) (w r) (A r) (alpha r)).
  { intros r Hr. apply inner. lra. } split. { now apply (A_rate x y u w A alpha table t); [ lra | | ]. }
  intros p0. pose (f r := if Req_EM_T r t then psi else proj1_sig (angle_exists (x r) (y r) (u r) (w r))).
  replace psi with (f t) by (unfold f; now destruct (Req_EM_T t t)). apply (alpha_rate x y u w f A alpha table); trivial; try lra.
  intros r _. unfold f. destruct (Req_EM_T r t) as [-> | _]. now apply angle_iff. apply (proj2_sig (angle_exists (x r) (y r) (u r) (w r))).
Qed.
(* (126): where alpha is small and psi near psi_1 of (124) the rate of alpha is 1 - 1/A: up to their distance and a multiple of sinh^2 alpha *)
Theorem eq_126 psi t (late : s <= t) (slips : 0 < p t) (turned : angle (x t) (y t) (u t) (w t) psi) :
  exists l, rder alpha t l /\ Rabs (l - eq126_alpha_rate (A t)) <= Rabs (psi - eq124_psi1 (alpha t)) + (2 + / (2 * A t)) * sinh (alpha t) ^ 2.
Proof.
  destruct (rates t psi late turned) as [_ D]. destruct (inside t late) as (A0 & _). destruct (positive t late slips) as [s0 a0]. eexists. split. exact (D slips).
  clear D. set (a := alpha t) in *. pose proof (cosh2 a) as c2. pose proof (cosh_from_1 a). pose proof (cosh_double a) as cd. pose proof (cosh_pos (2 * a)) as cc.
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
  intros Hz He H. pose proof PI2_3_2. apply Rnot_lt_le. intros k. assert (cz : cos (Rabs z) = cos z) by (unfold Rabs; destruct (Rcase_abs z); [ apply cos_neg | trivial ]).
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
  assert (ce : 0 < cos e2 < 1). { pose proof (cos_gt_0 e2 ltac:(lra) ltac:(lra)). pose proof (sin_gt_0 e2 ltac:(lra) ltac:(lra)). pose proof (unit_circle e2). nra. }
  set (e := 1 - cos e2). set (M := 2 + / (2 * A0)). assert (M0 : 2 < M) by (unfold M; pose proof (Rinv_0_lt_compat (2 * A0) ltac:(lra)); lra).
  set (kap := Rmin (e / 2) (eps / (4 * M))). assert (k0 : 0 < kap) by (apply Rmin_pos; [ unfold e; lra | apply Rdiv_lt_0_compat; lra ]).
  assert (ka : kap <= e / 2) by apply Rmin_l. assert (kb : kap * (4 * M) <= eps) by (apply Rle_div_r; [ lra | apply Rmin_r ]).
  assert (He : 0 < e < 1) by (unfold e; lra). assert (c1 : -1 < cos psi0 <= 1).
  { pose proof (COS_bound psi0). split; [ | lra ]. replace psi0 with (2 * (psi0 / 2)) by field. rewrite cos_2a_cos. pose proof (cos_gt_0 (psi0 / 2) ltac:(lra) ltac:(lra)). nra. }
  destruct (relaxes A0 (cos psi0) e kap eps inside0 c1 He k0 any) as (W & st & W0 & st0 & rel). exists (arcsinh (st / A0)), (arcsinh W).
  assert (q0 : 0 < st / A0) by (apply Rdiv_lt_0_compat; lra). split.
  { split. rewrite <- arcsinh_0. now apply arcsinh_lt. apply arcsinh_le, Rle_div_l; lra. }
  intros x y u w A alpha psi s S Hs In Ang As Ps al0. pose proof (inside x y u w A alpha s In) as ins.
  assert (below : forall a k, a < arcsinh k -> sinh a < k) by (intros a k h; rewrite <- (sinh_arcsinh k); now apply sinh_lt).
  assert (sp : forall a, 0 < a -> 0 < sinh a) by (intros a h; rewrite <- sinh_0; now apply sinh_lt).
  assert (Ag : forall t, s <= t -> A0 <= A t).
  { intros t Ht. pose proof (A_never_falls x y u w S s t ltac:(lra)) as up. destruct (ins t Ht) as (At & e1 & _). destruct (ins s (Rle_refl s)) as (_ & e3 & _). nra. }
  destruct (ins s (Rle_refl s)) as (_ & Es & ps & _). rewrite As in *. destruct al0 as [al0 al1]. apply below in al1. apply sp in al0.
  destruct (rel x y u w s S Hs) as (T & HT & HW & Hend). { now symmetry. }
  { rewrite ps. split. nra. rewrite Rmult_comm. now apply Rlt_div_r. } { rewrite <- Ps. now apply Ang, Rle_refl. }
  exists T. split; trivial. split.
  - intros r Hr. specialize (HW r Hr). destruct (ins r ltac:(lra)) as (Ar & _ & k1 & _). destruct (positive x y u w A alpha s In r) as [s1 a1]; try lra. split; trivial.
    pose proof (Ag r ltac:(lra)). rewrite <- (arcsinh_sinh (alpha r)). apply arcsinh_lt.
    rewrite k1 in HW. nra.
  - intros t Ht small. pose proof (small t ltac:(lra)) as [a0 a1]. apply below in a1. pose proof (sp _ a0) as s1.
    destruct (ins t ltac:(lra)) as (At & _ & k1 & k2 & pr & _). pose proof (cosh_from_1 (alpha t)) as ch. assert (p0 : 0 < nrm (u t) (w t)) by (rewrite k1; nra).
    assert (close : (1 - e) * (nrm (x t) (y t) * nrm (u t) (w t)) <= x t * u t + y t * w t).
    { apply Hend; trivial. intros r Hr. destruct (small r ltac:(lra)) as [r0 r1]. apply below in r1. apply sp in r0.
      destruct (ins r ltac:(lra)) as (Ar & _ & q1 & q2 & _). pose proof (cosh_from_1 (alpha r)). rewrite q1, q2. split. nra.
      replace (W * (A r * cosh (alpha r))) with (A r * (W * cosh (alpha r))) by ring. apply Rmult_le_compat_l; nra. }
    destruct (Ang t ltac:(lra)) as [rg an]. assert (rp : 0 < nrm (x t) (y t) * nrm (u t) (w t)) by nra.
    assert (P1 : Rabs (psi t) <= e2). { apply small_angle; trivial. lra. rewrite (proj1 an) in close. unfold e in close. nra. }
    destruct (psi1_spec (alpha t) a0) as (b1 & _ & C1). pose proof (cosh_double (alpha t)) as cd.
    assert (s2 : sinh (alpha t) ^ 2 <= kap * 1) by (simpl; rewrite Rmult_1_r; apply Rmult_le_compat; lra).
    assert (P2 : Rabs (eq124_psi1 (alpha t)) <= e2).
    { apply small_angle; trivial; try lra. rewrite C1. apply (Rmult_le_reg_r (cosh (2 * alpha t))). lra. rewrite Rinv_l, cd by lra. unfold e in *. nra. }
    apply Rabs_le_between in P1. apply Rabs_le_between in P2. split. apply Rabs_def1; lra. split. apply Rabs_def1; lra. split. apply Rabs_def1; lra.
    destruct (eq_126 x y u w A alpha s S Hs In (psi t) t ltac:(lra) p0 an) as (l & L & B). exists l. split; trivial. eapply Rle_lt_trans. exact B.
    assert (Rabs (psi t - eq124_psi1 (alpha t)) <= 2 * e2) by (apply Rabs_le; lra). pose proof (Ag t ltac:(lra)) as ag.
    assert (/ (2 * A t) <= / (2 * A0)) by (apply Rinv_le_contravar; lra). pose proof (Rinv_0_lt_compat (2 * A t) ltac:(lra)).
    assert ((2 + / (2 * A t)) * sinh (alpha t) ^ 2 <= M * kap) by (apply Rmult_le_compat; [ lra | apply pow2_ge_0 | unfold M; lra | lra ]). lra.
Qed.
