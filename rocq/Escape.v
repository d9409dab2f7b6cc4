(* Section 4, A > 1: the escape, (126) to (138). Units: mu g = Omega = 1, so that every number here has no dimension.
   Every motion with A > 1 at some moment escapes by the laws shown here; of the printed ones (128) to (137) none holds. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Fate Alpha TableAngle Exist Exist2 Formulas Late Prey Spiral Small.
Open Scope R_scope.

Ltac emptied T := lazymatch T with
  | forall x : ?A, @?B x => constr:(forall x : A, ltac:(let b := eval cbv beta in (B x) in let r := emptied b in exact r))
  | _ => constr:(False) end.
Ltac occurs t := let T := type of t in let r := emptied T in exact (~ r).

(* f is law (1 + c (ln t)/t + o((ln t)/t)) as t goes to infinity *)
Definition follows (f law : R -> R) (c : R) : Prop :=
  is_lim (fun t => f t / law t) p_infty 1 /\ is_lim (fun t => (f t / law t - 1) * (t / ln t)) p_infty c.
(* f over law goes to a number, which is not 1 *)
Definition misses (f law : R -> R) (c : R) : Prop := is_lim (fun t => f t / law t) p_infty c /\ c <> 1.

Lemma follows_of f law c : near (fun t => f t / law t) c -> follows f law c.
Proof. intros H. split; [ exact (near_one _ _ H) | exact H ]. Qed.
Lemma misses_of T f law g c d : follows f law c -> (forall t, T <= t -> 0 < t -> law t / g t = d /\ law t <> 0) -> d <> 1 -> misses f g d.
Proof.
  intros [H _] E N. split; trivial. apply (tends_ext (Rmax T 1) (fun t => f t / law t * d)).
  - intros t Ht. pose proof (Rmax_l T 1). pose proof (Rmax_r T 1). destruct (E t ltac:(lra) ltac:(lra)) as [<- n]. unfold Rdiv.
    rewrite Rmult_assoc, <- (Rmult_assoc (/ law t)), Rinv_l; trivial. ring.
  - limit. ring.
Qed.
Lemma root_two : 4 / 3 < sqrt 2 /\ sqrt 2 ^ 2 = 2.
Proof. destruct root2 as [s0 s2]. split; nra. Qed.
(* 3 sqrt 2/4: by this the printed laws are wrong, or by a power of it *)
Lemma six_hundredths : 1 < right_escape_product_over_a.
Proof. destruct root_two. unfold right_escape_product_over_a. lra. Qed.

Lemma cosh2 a : cosh a ^ 2 = 1 + sinh a ^ 2.
Proof. unfold cosh, sinh. assert (e : exp a * exp (- a) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). field_simplify. nra. Qed.
Lemma cosh_from_1 a : 1 <= cosh a.
Proof. pose proof (cosh2 a). pose proof (cosh_pos a). nra. Qed.
Lemma cosh_double a : cosh (2 * a) = 1 + 2 * sinh a ^ 2.
Proof.
  replace (2 * a) with (a + a) by ring. assert (e : exp a * exp (- a) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  unfold cosh, sinh. rewrite Ropp_plus_distr, !exp_plus. field_simplify. nra.
Qed.
Lemma sinh_sign a : 0 < sinh a -> 0 < a.
Proof. intros H. apply Rnot_le_lt. intros k. assert (sinh a <= 0); [ | lra ]. rewrite <- sinh_0. destruct k as [k | ->]; [ left; now apply sinh_lt |
  lra ]. Qed.
Lemma cos_near a b : Rabs (cos a - cos b) <= Rabs (a - b).
Proof.
  assert (K : forall z, Rabs (sin z) <= Rabs z).
  { assert (P : forall z, 0 <= z -> Rabs (sin z) <= z).
    { intros z [z0 | <-]; [ | rewrite sin_0, Rabs_R0; lra ]. pose proof (sin_lt_x z z0). pose proof (SIN_bound z). apply Rabs_le. split; [ | lra ].
      destruct (Rle_lt_dec 1 z); [ lra | ]. pose proof PI2_3_2. pose proof (sin_gt_0 z z0 ltac:(lra)). lra. }
    intros z. destruct (Rle_lt_dec 0 z). rewrite (Rabs_pos_eq z) by trivial. auto. rewrite <- Rabs_Ropp, <- sin_neg, (Rabs_left z) by trivial.
      apply P. lra. }
  rewrite form2, !Rabs_mult. replace (Rabs (-2)) with 2 by (rewrite Rabs_left; lra). specialize (K ((a - b) / 2)).
    pose proof (SIN_bound ((a + b) / 2)).
  assert (Rabs (sin ((a + b) / 2)) <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos (sin ((a - b) / 2))).
  replace (Rabs ((a - b) / 2)) with (Rabs (a - b) / 2) in K by (unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)); lra). nra.
Qed.

Lemma root_rate x y u w (S : spin x y u w) t (ht : 0 <= t) : 0 < x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2) ->
  rder (fun s => sqrt (x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2))) t (nrm (u t) (w t) / sqrt (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2))).
Proof.
  intros E0. eapply rder_eq. apply (rder_root (fun s => x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2))); [ apply (E_rate x y u w S t ht) | exact E0 ].
  field. apply Rgt_not_eq, sqrt_lt_R0, E0.
Qed.
(* (113) and (114) at one moment, by the angle and the A and alpha that there are from it on *)
Lemma rates_inside x y u w (S : spin x y u w) t (ht : 0 <= t) (p0 : 0 < nrm (u t) (w t)) psi al d : 0 < d -> 0 < x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^
  2) ->
  x t * u t + y t * w t = nrm (x t) (y t) * nrm (u t) (w t) * cos psi ->
  (forall s, t <= s < t + d -> hyperbolic (x s) (y s) (u s) (w s) (sqrt (x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2))) (al s)) ->
  rder (fun s => sqrt (x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2))) t (eq113_a_rate (al t)) /\
  rder al t (eq114_alpha_rate (sqrt (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2))) (al t) psi).
Proof.
  intros Hd E0 e H. set (E s := x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2)) in *. assert (a0 : 0 < sqrt (E t)) by now apply sqrt_lt_R0.
  assert (DA : rder (fun s => sqrt (E s)) t (eq113_a_rate (al t))).
  { eapply rder_eq. apply (root_rate x y u w S t ht E0). destruct (H t ltac:(lra)) as [-> _]. unfold eq111_p, eq113_a_rate. fold (E t). field. lra. }
  assert (DP : rder (fun s => nrm (u s) (w s)) t (nrm (x t) (y t) * cos psi - 1)).
  { assert (N : nrm (u t) (w t) <> 0) by lra. destruct (slip _ _ _ _ S t ht N) as (_ & _ & U & W). eapply rder_eq. apply (rder_nrm u w); [ exact U |
    exact W | exact N ].
    pose proof (nrm_sq (u t) (w t)) as q. set (n := nrm (u t) (w t)) in *. apply (Rmult_eq_reg_l n); [ | lra ].
      replace (n * (nrm (x t) (y t) * cos psi - 1)) with (x t * u t + y t * w t - n) by (rewrite e; ring).
    field_simplify_eq; [ ring [q] | lra ]. }
  split; trivial. eapply rder_eq. eapply (rder_alpha (fun s => nrm (u s) (w s)) (fun s => sqrt (E s)) al t d _ _ Hd); [ | exact DP | exact DA ].
  { intros s Hs. destruct (H s Hs) as [k _]. split; trivial. pose proof (A_never_falls x y u w S t s ltac:(lra)). apply sqrt_lt_R0. unfold E in *.
    lra. }
  destruct (H t ltac:(lra)) as [_ ->]. pose proof (cosh_pos (al t)). pose proof (cosh2 (al t)) as c.
    unfold eq113_a_rate, eq114_alpha_rate, eq112_rho. fold (E t). field_simplify_eq; [ ring [c] | lra ].
Qed.

(* (126): where alpha is small and psi near psi_1 of (124) the rate of alpha is 1 - 1/A: up to their distance and a multiple of sinh^2 alpha *)
Theorem eq_126 x y u w A alpha psi t d (table : spin x y u w) (from : 0 <= t) (lasts : 0 < d) (slips : 0 < nrm (u t) (w t))
  (inner : forall r, t <= r < t + d -> 0 < A r /\ hyperbolic (x r) (y r) (u r) (w r) (A r) (alpha r)) (turned : angle (x t) (y t) (u t) (w t) psi) :
  exists l, rder alpha t l /\ Rabs (l - eq126_alpha_rate (A t)) <= Rabs (psi - eq124_psi1 (alpha t)) + (2 + / (2 * A t)) * sinh (alpha t) ^ 2.
Proof.
  revert table from lasts slips inner turned. intros S Ht Hd p0 H [e1 _]. assert (AE : forall r, t <= r < t + d -> sqrt (x r ^ 2 + y r ^ 2 - (u r ^ 2
    + w r ^ 2)) = A r).
  { intros r Hr. destruct (H r Hr) as (A0 & k1 & k2). unfold eq111_p, eq112_rho in *. rewrite <- (sqrt_pow2 (A r)) by lra. f_equal.
    rewrite <- !nrm_sq, k1, k2, !Rpow_mult_distr, cosh2. ring. }
  destruct (H t ltac:(lra)) as (A0 & k1 & k2). pose proof (AE t ltac:(lra)) as At.
  assert (E0 : 0 < x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)). { apply Rnot_le_lt. intros k. rewrite sqrt_neg_0 in At by trivial. lra. }
  destruct (rates_inside x y u w S t Ht p0 psi alpha d Hd E0 e1) as [_ D]. { intros r Hr. rewrite AE by trivial. now apply H. }
  exists (eq114_alpha_rate (A t) (alpha t) psi). split. { now rewrite At in D. } clear D.
  set (a := alpha t) in *. unfold eq111_p in k1. assert (s0 : 0 < sinh a) by (rewrite k1 in p0; nra). pose proof (sinh_sign a s0) as a0.
    pose proof (cosh2 a) as c2. pose proof (cosh_pos a) as c0.
  assert (c1 : 1 <= cosh a) by nra. pose proof (cosh_double a) as cd. assert (cc : 0 < cosh (2 * a)) by apply cosh_pos.
  assert (C1 : cos (eq124_psi1 a) = / cosh (2 * a)).
  { unfold eq124_psi1. pose proof (cosh2 (2 * a)) as q. assert (s2 : 0 < sinh (2 * a)) by (rewrite <- sinh_0; apply sinh_lt; lra).
    assert (T : -1 <= tanh (2 * a) <= 1). { unfold tanh. split; [ apply Rle_div_r | apply Rle_div_l ]; trivial; nra. }
    rewrite cos_asin by trivial. rewrite <- (sqrt_pow2 (/ cosh (2 * a))) by (left; now apply Rinv_0_lt_compat). f_equal. unfold tanh, Rsqr.
      field_simplify_eq; [ ring [q] | lra ]. }
  assert (b1 : 0 <= 1 - / cosh (2 * a) <= 2 * sinh a ^ 2).
  { assert (/ cosh (2 * a) * cosh (2 * a) = 1) by (field; lra). assert (0 < / cosh (2 * a)) by now apply Rinv_0_lt_compat. split; nra. }
  assert (b2 : 0 <= (cosh a - 1) / A t <= / (2 * A t) * sinh a ^ 2).
  { assert (0 < / A t) by now apply Rinv_0_lt_compat. rewrite Rinv_mult_distr by lra. unfold Rdiv. assert (cosh a - 1 <= / 2 * sinh a ^ 2) by nra.
    split; nra. }
  pose proof (cos_near psi (eq124_psi1 a)) as N. rewrite C1 in N. unfold eq114_alpha_rate, eq126_alpha_rate.
  replace (cos psi - cosh a / A t - (1 - 1 / A t)) with ((cos psi - / cosh (2 * a)) - (1 - / cosh (2 * a)) - (cosh a - 1) / A t) by (field; lra).
  apply Rabs_le. apply Rabs_le_between in N. assert (0 <= sinh a ^ 2) by nra. lra.
Qed.

Lemma cos_above_minus_1 z : - PI < z < PI -> -1 < cos z.
Proof. intros H. replace z with (2 * (z / 2)) by field. rewrite cos_2a_cos. pose proof (cos_gt_0 (z / 2) ltac:(lra) ltac:(lra)). nra. Qed.
Lemma small_angle z e : - PI < z <= PI -> 0 < e < 1 -> cos e <= cos z -> Rabs z <= e.
Proof.
  intros Hz He H. pose proof PI2_3_2. apply Rnot_lt_le. intros k. assert (cz : cos (Rabs z) = cos z) by (unfold Rabs; destruct (Rcase_abs z);
    [ apply cos_neg | trivial ]).
  assert (Rabs z <= PI) by (apply Rabs_le; lra). pose proof (cos_decreasing_1 e (Rabs z) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). lra.
Qed.
Lemma small_psi1 a k e : 0 < a -> sinh a < k -> k <= 1 -> 0 < e < 1 -> 3 * k <= sin e -> 0 <= eq124_psi1 a <= e.
Proof.
  intros a0 s1 k1 He Hs. unfold eq124_psi1. assert (s0 : 0 < sinh a) by (rewrite <- sinh_0; now apply sinh_lt). pose proof (cosh2 a) as c2.
    pose proof (cosh_pos a). pose proof (cosh_double a) as cd. pose proof (cosh_pos (2 * a)) as cc.
  assert (cu : cosh a <= 3 / 2) by nra. assert (sd : sinh (2 * a) = 2 * sinh a * cosh a). { replace (2 * a) with (a + a) by ring. unfold sinh, cosh.
    rewrite Ropp_plus_distr, !exp_plus. field. }
  assert (T0 : 0 < tanh (2 * a)) by (unfold tanh; apply Rdiv_lt_0_compat; trivial; nra). assert (Tk : tanh (2 * a) <= sin e). { unfold tanh.
    apply Rle_div_l; trivial. nra. }
  pose proof (SIN_bound e). pose proof PI2_3_2. pose proof (asin_bound (tanh (2 * a))) as B. pose proof (sin_asin (tanh (2 * a)) ltac:(lra)) as V.
    set (b := asin (tanh (2 * a))) in *. split; apply Rnot_lt_le; intros q.
  - pose proof (sin_lt_0_var b ltac:(lra) q). lra.
  - pose proof (sin_increasing_1 e b ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) q). lra.
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
  set (e2 := Rmin eps 1 / 4). assert (m0 : 0 < Rmin eps 1) by (apply Rmin_pos; lra). pose proof (Rmin_l eps 1). pose proof (Rmin_r eps 1).
    assert (e20 : 0 < e2 <= / 4) by (unfold e2; lra). assert (e21 : e2 <= eps / 4) by (unfold e2; lra).
  pose proof PI2_3_2 as pi3. assert (se : 0 < sin e2) by (apply sin_gt_0; lra). assert (ce : 0 < cos e2 < 1).
    { pose proof (cos_gt_0 e2 ltac:(lra) ltac:(lra)). pose proof (sin2_cos2 e2). unfold Rsqr in *. split; nra. }
  set (e := 1 - cos e2). set (M := 2 + / (2 * A0)). assert (M0 : 2 < M). { unfold M. assert (0 < / (2 * A0)); [ | lra ]. apply Rinv_0_lt_compat.
    lra. }
  set (kap := Rmin 1 (Rmin (sin e2 / 3) (eps / (4 * M)))). assert (k0 : 0 < kap). { repeat apply Rmin_pos; try lra. apply Rdiv_lt_0_compat; lra. }
  assert (ka : kap <= 1) by apply Rmin_l. assert (kb : kap <= sin e2 / 3) by (eapply Rle_trans; [ apply Rmin_r | apply Rmin_l ]).
    assert (kc : kap <= eps / (4 * M)) by (eapply Rle_trans; [ apply Rmin_r | apply Rmin_r ]).
  assert (kd : M * kap <= eps / 4). { apply (Rmult_le_compat_l M) in kc; [ | lra ]. replace (M * (eps / (4 * M))) with (eps / 4) in kc by (field;
    lra). trivial. }
  pose proof (cos_above_minus_1 psi0 straight) as c1. pose proof (COS_bound psi0) as c2. set (c0 := cos psi0) in *.
    assert (He : 0 < e <= 1) by (unfold e; lra).
  destruct (sizes A0 c0 e kap eps inside0 (conj c1 (proj2 c2)) He k0 any) as (_ & _ & _ & _ & _ & w0 & wk & _ & _ & _ & _ & _ & _ & _ & st0 & st1 & _
    & _). set (W := window c0 e kap) in *. set (st := start A0 c0 e kap eps) in *.
  assert (q0 : 0 < st / A0) by (now apply Rdiv_lt_0_compat). assert (q1 : st / A0 <= W) by (apply Rle_div_l; trivial; nra).
  exists (arcsinh (st / A0)), (arcsinh W). split. { split. rewrite <- arcsinh_0. now apply arcsinh_lt. now apply arcsinh_le. }
  intros x y u w A alpha psi s S Hs In Ang As Ps al0.
  assert (below : forall a k, a < arcsinh k -> sinh a < k) by (intros a k h; rewrite <- (sinh_arcsinh k); now apply sinh_lt).
  assert (pos : forall t, s <= t -> 0 < alpha t -> 0 < nrm (u t) (w t)). { intros t Ht h. destruct (In t Ht) as (At & k1 & _). rewrite k1.
    unfold eq111_p. apply Rmult_lt_0_compat; trivial. rewrite <- sinh_0. now apply sinh_lt. }
  assert (AE : forall t, s <= t -> A t ^ 2 = x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)). { intros t Ht. destruct (In t Ht) as (At & k1 & k2).
    unfold eq111_p, eq112_rho in *. rewrite <- !nrm_sq, k1, k2, !Rpow_mult_distr, cosh2. ring. }
  assert (Ag : forall t, s <= t -> A0 <= A t). { intros t Ht. pose proof (A_never_falls x y u w S s t ltac:(lra)) as up.
    rewrite <- !AE, As in up by lra. destruct (In t Ht) as (At & _). apply Rsqr_incr_0; rewrite ?Rsqr_pow2; lra. }
  destruct (In s (Rle_refl s)) as (A0' & p1 & _). unfold eq111_p in p1. rewrite As in p1. pose proof (pos s (Rle_refl s) (proj1 al0)) as ps.
  assert (pst : nrm (u s) (w s) < st). { rewrite p1. pose proof (below _ _ (proj2 al0)) as b. apply (Rmult_lt_compat_l A0) in b; trivial.
    replace (A0 * (st / A0)) with st in b by (field; lra). trivial. }
  assert (cs : (x s * u s + y s * w s) * / nrm (u s) (w s) = nrm (x s) (y s) * c0). { destruct (Ang s (Rle_refl s)) as [_ [-> _]]. rewrite Ps.
    unfold c0. field. lra. }
  assert (Es : x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2) = A0 ^ 2) by (rewrite <- AE, As; lra).
  destruct (relaxes x y u w S s A0 c0 e kap eps Hs inside0 (conj c1 (proj2 c2)) He k0 any Es (conj ps pst) cs) as (T & HT & HW & Hend).
    fold W in HW, Hend. exists T. split; trivial. split.
  - intros r Hr. destruct (HW r Hr) as [pr wr]. destruct (In r ltac:(lra)) as (Ar & k1 & _). unfold eq111_p in k1. pose proof (Ag r ltac:(lra)).
    assert (s1 : 0 < sinh (alpha r)) by (apply (Rmult_lt_reg_l (A r)); lra). split. now apply sinh_sign.
    rewrite <- (arcsinh_sinh (alpha r)). apply arcsinh_lt. rewrite k1 in wr. assert (A0 * sinh (alpha r) <= A r * sinh (alpha r)) by (apply
      Rmult_le_compat_r; lra). assert (0 < W * A0) by now apply Rmult_lt_0_compat. apply (Rmult_lt_reg_l A0); lra.
  - intros t Ht small. pose proof (small t ltac:(lra)) as [a0 a1]. pose proof (below _ _ a1) as sw.
    assert (s1 : 0 < sinh (alpha t)) by (rewrite <- sinh_0; now apply sinh_lt). pose proof (pos t ltac:(lra) a0) as p0.
    assert (close : (1 - e) * nrm (x t) (y t) <= (x t * u t + y t * w t) * / nrm (u t) (w t)).
    { apply Hend; trivial. intros r Hr. destruct (small r ltac:(lra)) as [r0 r1]. pose proof (below _ _ r1) as rw. split. apply pos; lra.
      destruct (In r ltac:(lra)) as (Ar & k1 & k2). unfold eq111_p, eq112_rho in *. rewrite k1, k2.
      pose proof (cosh_from_1 (alpha r)). assert (W * 1 <= W * cosh (alpha r)) by (apply Rmult_le_compat_l; lra).
        replace (W * (A r * cosh (alpha r))) with (A r * (W * cosh (alpha r))) by ring. apply Rmult_le_compat_l; lra. }
    destruct (Ang t ltac:(lra)) as [rg an]. assert (r0 : 0 < nrm (x t) (y t)). { destruct (In t ltac:(lra)) as (At & _ & k2). rewrite k2.
      unfold eq112_rho. apply Rmult_lt_0_compat; trivial. apply cosh_pos. }
    assert (P1 : Rabs (psi t) <= e2). { apply small_angle; trivial. lra. destruct an as [a _]. rewrite a in close.
      apply (Rmult_le_reg_l (nrm (x t) (y t))); trivial. unfold e in close. replace (nrm (x t) (y t) * nrm (u t) (w t) * cos (psi t) * / nrm (u t) (w
      t)) with (nrm (x t) (y t) * cos (psi t)) in close by (field; lra). lra. }
    pose proof (small_psi1 (alpha t) W e2 a0 sw ltac:(lra) ltac:(lra) ltac:(lra)) as P2. apply Rabs_le_between in P1. split. apply Rabs_def1; lra.
      split. apply Rabs_def1; lra. split. apply Rabs_def1; lra.
    destruct (eq_126 x y u w A alpha (psi t) t 1 S ltac:(lra) Rlt_0_1 p0 ltac:(intros r Hr; apply In; lra) an) as (l & L & B). exists l. split;
      trivial. eapply Rle_lt_trans. exact B.
    assert (Rabs (psi t - eq124_psi1 (alpha t)) <= 2 * e2) by (apply Rabs_le; lra). pose proof (Ag t ltac:(lra)) as ag.
      assert (/ (2 * A t) <= / (2 * A0)) by (apply Rinv_le_contravar; lra). assert (0 < / (2 * A t)) by (apply Rinv_0_lt_compat; lra).
    assert ((2 + / (2 * A t)) * sinh (alpha t) ^ 2 <= M * kap). { apply Rmult_le_compat. lra. apply pow2_ge_0. unfold M; lra.
      apply Rle_trans with (W * 1); [ rewrite <- Rsqr_pow2; apply Rmult_le_compat | ]; lra. } lra.
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

Lemma inside t : s <= t -> 0 < A t /\ A t ^ 2 = E t /\ A t = sqrt (E t) /\ p t = A t * sinh (alpha t) /\ rho t = A t * cosh (alpha t) /\
  rho t + p t = A t * exp (alpha t) /\ rho t - p t = A t * exp (- alpha t).
Proof.
  intros Ht. destruct (inner t Ht) as (A0 & k1 & k2). unfold eq111_p, eq112_rho in *.
  assert (e : A t ^ 2 = E t) by (rewrite <- !nrm_sq, k1, k2, !Rpow_mult_distr, cosh2; ring). split; trivial. split; trivial.
  split. { rewrite <- e, sqrt_pow2; lra. } split; trivial. split; trivial. rewrite k1, k2. unfold cosh, sinh. split; field.
Qed.
Lemma A_to_infinity : (forall M, exists T, s <= T /\ forall t, T <= t -> M < E t) -> is_lim A p_infty p_infty.
Proof.
  intros H. apply is_lim_spec. intros M. destruct (H (M ^ 2)) as (T & T0 & HT). exists T. intros t Ht. specialize (HT t ltac:(lra)).
  destruct (inside t ltac:(lra)) as (A0 & A2 & _). rewrite <- A2 in HT. nra.
Qed.

(* (127): A > 1 is enough for an escape; below 1 no A is: if alpha < ln(1/A) the particle comes to rest for good *)
Theorem eq_127 : (eq127_least_a < A s -> is_lim A p_infty p_infty) /\
  (A s < eq127_least_a -> alpha s < ln (1 / A s) -> exists T, forall t, T <= t -> x t = x T /\ y t = y T /\ u t = 0 /\ w t = 0).
Proof.
  destruct (inside s (Rle_refl s)) as (A0 & A2 & _ & _ & _ & sum & _). unfold eq127_least_a. split; intros H.
  - apply A_to_infinity, (unbounded_above_1 x y u w table s from). nra.
  - intros a. assert (m1 : rho s + p s < 1).
    { rewrite sum. apply (Rmult_lt_reg_l (/ A s)). now apply Rinv_0_lt_compat. rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra.
      replace (/ A s) with (1 / A s) by (field; lra). rewrite <- (exp_ln (1 / A s)). now apply exp_increasing. apply Rdiv_lt_0_compat; lra. }
    set (T := s + p s / (1 - (rho s + p s))). assert (sT : s <= T). { unfold T. assert (0 <= p s / (1 - (rho s + p s))); [ | lra ].
      apply Rmult_le_pos. apply nrm_pos. left. apply Rinv_0_lt_compat. lra. }
    exists T. intros t Ht. destruct (caught x y u w table s T from m1 (Rle_refl T)) as (z1 & z2 & r1). apply (table_rest_lasts x y u w table T t);
      try lra. now apply at_rest.
    rewrite <- nrm_sq. pose proof (nrm_pos (x T) (y T)). pose proof (nrm_pos (u s) (w s)). nra.
Qed.
(* A never falls, and it grows without end unless alpha goes to 0 *)
Theorem s4_A_never_decreases : (forall r t, s <= r <= t -> A r <= A t) /\ (is_lim A p_infty p_infty \/ is_lim alpha p_infty 0).
Proof.
  pose proof (A_never_falls x y u w table) as up. assert (mono : forall r t, s <= r <= t -> A r <= A t).
  { intros r t Hr. destruct (inside r ltac:(lra)) as (_ & _ & -> & _). destruct (inside t ltac:(lra)) as (_ & _ & -> & _). apply sqrt_le_1_alt, up.
    lra. }
  split; trivial. destruct (Classical_Prop.classic (exists M, forall t, 0 <= t -> E t <= M)) as [[M HM] | no]; [ right | left ].
  - destruct (bounded_ends x y u w table M HM) as (_ & _ & _ & _ & Hu & Hw & _). apply is_lim_spec. intros e. pose proof (cond_pos e) as e0.
    destruct (inside s (Rle_refl s)) as (a0 & _). set (a := A s) in *. assert (se : 0 < sinh e) by (rewrite <- sinh_0; now apply sinh_lt).
    set (d := a * sinh e / 2). assert (d0 : 0 < d) by (unfold d; nra).
    destruct (lim_near u 0 d Hu d0) as (T1 & T10 & H1). destruct (lim_near w 0 d Hw d0) as (T2 & T20 & H2). exists (T1 + T2 + s). intros t Ht.
    specialize (H1 t ltac:(lra)). specialize (H2 t ltac:(lra)). destruct (inside t ltac:(lra)) as (A0 & _ & _ & Hal & _).
      pose proof (mono s t ltac:(lra)) as at1. fold a in at1.
    pose proof (nrm_sq (u t) (w t)). pose proof (nrm_pos (u t) (w t)).
    assert (pt : p t < a * sinh e) by (unfold d in *; nra). set (z := sinh (alpha t)) in *. assert (z0 : 0 <= z) by nra.
      assert (z1 : z < sinh e) by nra.
    rewrite Rminus_0_r, <- (arcsinh_sinh (alpha t)). fold z. rewrite Rabs_pos_eq. rewrite <- (arcsinh_sinh e). now apply arcsinh_lt.
      rewrite <- arcsinh_0. now apply arcsinh_le.
  - apply A_to_infinity. intros M. destruct (Classical_Prop.classic (exists T, 0 <= T /\ M < E T)) as [(T & T0 & HT) | n].
    + exists (Rmax s T). split. apply Rmax_l. intros t Ht. pose proof (Rmax_r s T). specialize (up T t ltac:(lra)). lra.
    + exfalso. apply no. exists M. intros t Ht. apply Rnot_lt_le. intros k. apply n. eauto.
Qed.

Hypothesis above : eq127_least_a < A s.
Lemma E_above : 1 < E s.
Proof. destruct (inside s (Rle_refl s)) as (A0 & A2 & _). unfold eq127_least_a in above. nra. Qed.

(* A grows without end; the speed never vanishes but in one case: the particle has come straight in, cos psi <= -1/cosh alpha up to
   its stop, where alpha is 0, so that psi went to pi; it stops there once and never again *)
Theorem s4_escape_if_A_above_1 : is_lim A p_infty p_infty /\ ((forall t, s <= t -> 0 < p t) \/
  exists T, s <= T /\ p T = 0 /\ (forall t, T < t -> 0 < p t) /\
    forall t, s <= t < T -> 0 < p t /\ (x t * u t + y t * w t) / (rho t * p t) <= - / cosh (alpha t)).
Proof.
  pose proof E_above as HE. pose proof (A_never_falls x y u w table) as up. split. { now apply A_to_infinity, (unbounded_above_1 x y u w table s
    from). }
  destruct (Classical_Prop.classic (exists T, s <= T /\ p T = 0)) as [(T & T0 & z) | never].
  - right. exists T. split; trivial. split; trivial. split. { apply (stops_once x y u w table T); trivial. lra. specialize (up s T ltac:(lra)). lra. }
    intros t Ht. assert (p0 : 0 < p t). { destruct (nrm_pos (u t) (w t)) as [k | k]; trivial. exfalso.
      pose proof (stops_once x y u w table t ltac:(lra) ltac:(specialize (up s t ltac:(lra)); lra) ltac:(lra) T ltac:(lra)). lra. }
    split; trivial. destruct (inside t ltac:(lra)) as (A0 & _ & Ae & _ & re & _). pose proof (cosh_pos (alpha t)) as c0. apply Rnot_lt_le. intros k.
    enough (0 < p T) by lra. apply (never_stops x y u w table t); try lra. specialize (up s t ltac:(lra)). lra. rewrite <- Ae.
    assert (r0 : 0 < rho t) by (rewrite re; nra). apply Rlt_div_r in k; [ | nra ]. replace (- / cosh (alpha t) * (rho t * p t)) with (- (A t * p t))
      in k by (rewrite re; field; lra). lra.
  - left. intros t Ht. destruct (nrm_pos (u t) (w t)) as [k | k]; trivial. exfalso. eauto.
Qed.

Let zf := z_of x y u w. Let hf := h_of x y u w. Let Nf := N_of x y u w. Let Pf := P_of x y u w.
Notation W t := ((1 - hf t) * / zf t).
(* what is known of it in the end *)
Lemma spiral : exists T, s <= T /\ hunt T zf hf Nf Pf /\ forall t, T <= t -> 0 < p t /\ 0 < (x t * u t + y t * w t) * / p t /\ 1 < E t.
Proof. apply escape_hunts; trivial. apply E_above. Qed.
Lemma seen T t : s <= T -> hunt T zf hf Nf Pf -> (forall t, T <= t -> 0 < p t /\ 0 < (x t * u t + y t * w t) * / p t /\ 1 < E t) -> T <= t ->
  0 < t /\ 0 < zf t /\ 0 < hf t < 1 /\ 0 < Nf t /\ 0 < cosh (alpha t) /\ exp (2 * alpha t) = (1 + hf t) / (1 - hf t) /\
  cosh (alpha t) / A t = 2 * Nf t * zf t /\ cosh (2 * alpha t) = (1 + hf t ^ 2) / (1 - hf t ^ 2) /\
  A t ^ 2 = / (4 * Nf t ^ 2 * (1 + hf t) * W t * zf t ^ 3).
Proof.
  intros Ts H HT Ht. destruct (state x y u w T H HT t Ht) as (t0 & z0 & hh & N0 & h1 & pe & re & Ee).
    destruct (inside t ltac:(lra)) as (A0 & A2 & _ & k1 & k2 & k3 & k4).
  fold zf hf Nf in z0, hh, N0, h1, pe, re, Ee. pose proof (cosh_pos (alpha t)) as c0. assert (zz : 0 < zf t ^ 2) by nra.
    assert (z3 : 0 < zf t ^ 3) by nra. assert (ec : cosh (alpha t) = rho t / A t) by (rewrite k2; field; lra).
    assert (es : sinh (alpha t) = p t / A t) by (rewrite k1; field; lra).
  repeat split; trivial; try lra.
  - replace (2 * alpha t) with (alpha t - - alpha t) by ring. unfold Rminus at 1. rewrite exp_plus, exp_Ropp. pose proof (exp_pos (- alpha t)) as x0.
    replace (exp (alpha t)) with ((rho t + p t) / A t) by (rewrite k3; field; lra).
      replace (exp (- alpha t)) with ((rho t - p t) / A t) by (rewrite k4; field; lra).
    assert (r0 : 0 < rho t) by (rewrite k2; nra). rewrite pe. field. repeat split; try lra; nra.
  - rewrite ec. replace (rho t / A t / A t) with (rho t / A t ^ 2) by (field; lra). rewrite A2, Ee, re. field. repeat split; try lra; nra.
  - rewrite cosh_double, es. replace (1 + 2 * (p t / A t) ^ 2) with (1 + 2 * p t ^ 2 / A t ^ 2) by (field; lra).
    replace (A t ^ 2) with (rho t ^ 2 * (1 - hf t ^ 2)). 2: { rewrite A2. transitivity (rho t ^ 2 - p t ^ 2). rewrite pe. ring. rewrite !nrm_sq.
      ring. }
    assert (r0 : 0 < rho t) by (rewrite k2; nra). rewrite pe. field. split; nra.
Qed.
Ltac in_the_end T t Ht := destruct (seen T t) as (t0 & z0 & hh & N0 & c0 & ea & eA & e2 & eE); trivial.
Ltac known T := destruct spiral as (T & Ts & H & HT);
  pose proof (proj1 (settles _ _ _ _ _ H)) as LN; pose proof (proj2 (settles _ _ _ _ _ H)) as LP; pose proof (h_one _ _ _ _ _ H) as Lh;
  pose proof (w_limit _ _ _ _ _ H) as Lw; pose proof (z_zero _ _ _ _ _ H) as Lz; pose proof (zt_limit _ _ _ _ _ H) as Lt;
  cbv beta in Lw, Lt; destruct root_two as [s0 s2].

(* the rate of alpha at large times goes as 1/(2 t), as does the right side of (128) as corrected *)
Theorem eq_128 dalpha : (forall t, s <= t -> 0 < p t -> rder alpha t (dalpha t)) ->
  is_lim (fun t => dalpha t / right_escape_alpha_rate (alpha t) (A t)) p_infty 1 /\
  is_lim (fun t => t * dalpha t) p_infty (1 / 2) /\ is_lim (fun t => t * right_escape_alpha_rate (alpha t) (A t)) p_infty (1 / 2).
Proof.
  intros D. known T.
  assert (K : tends (fun t => t * dalpha t) (1 / 2)).
  { apply (tends_ext T (fun t => (zf t * t) * (2 * (/ (1 + zf t ^ 2) - Nf t)))).
    - intros t Ht. in_the_end T t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape x y u w t p0 x0 E1) as (pr & _ & _ & _ & xe & _).
      fold zf in xe.
      assert (zk : 0 < 2 * zf t * / (1 + zf t ^ 2) <= 1). { assert (0 < 1 + zf t ^ 2) by nra. split. apply Rmult_lt_0_compat. lra.
        now apply Rinv_0_lt_compat. apply Rle_div_l; trivial. pose proof (pow2_ge_0 (zf t - 1)). lra. }
      set (psi := acos (2 * zf t * / (1 + zf t ^ 2))). assert (cp : cos psi = 2 * zf t * / (1 + zf t ^ 2)) by (unfold psi; apply cos_acos; lra).
      assert (e : x t * u t + y t * w t = rho t * p t * cos psi). { destruct (xi_p x y u w t p0) as (<- & _). rewrite xe, cp. ring. }
      destruct (rates_inside x y u w table t ltac:(lra) p0 psi alpha 1 Rlt_0_1 ltac:(lra) e) as [_ R].
      { intros r Hr. destruct (inside r ltac:(lra)) as (_ & _ & <- & _). apply inner. lra. }
      rewrite (rder_unique _ _ _ _ (D t ltac:(lra) p0) R). destruct (inside t ltac:(lra)) as (_ & _ & <- & _). unfold eq114_alpha_rate.
        rewrite cp, eA. field. nra.
    - limit. lra. field. }
  assert (L : tends (fun t => t * right_escape_alpha_rate (alpha t) (A t)) (1 / 2)).
  { apply (tends_ext T (fun t => (zf t * t) * (sqrt 2 * (1 + hf t) * W t / (1 + hf t ^ 2) - 2 * Nf t))).
    - intros t Ht. in_the_end T t Ht. unfold right_escape_alpha_rate. rewrite eA, e2. field. repeat split; try lra; nra.
    - limit. lra. replace (sqrt 2 * (1 + 1) * sqrt 2) with (2 * sqrt 2 ^ 2) by ring. rewrite s2. field. }
  split; [ | now split ]. destruct (in_the_end 1 _ _ (1 / 2) L ltac:(lra)) as (T2 & T20 & H2).
  apply (tends_ext T2 (fun t => (t * dalpha t) * / (t * right_escape_alpha_rate (alpha t) (A t)))).
  - intros t Ht. specialize (H2 t Ht). apply Rabs_def2 in H2. field. split; nra.
  - limit. lra. field.
Qed.
(* ... while t times the right side as printed goes to a negative number *)
Theorem eq_128__printed : is_lim (fun t => t * eq128_alpha_rate (alpha t) (A t)) p_infty (sqrt 2 - 3 / 2) /\ sqrt 2 - 3 / 2 < 0.
Proof.
  known T. split; [ | nra ]. apply (tends_ext T (fun t => (zf t * t) * ((1 + hf t) * W t / (1 + hf t ^ 2) - 2 * Nf t))).
  - intros t Ht. in_the_end T t Ht. unfold eq128_alpha_rate. rewrite eA, e2. field. repeat split; try lra; nra.
  - limit. lra. field.
Qed.
(* cosh alpha cosh 2 alpha over A goes to 3 sqrt 2/4 *)
Theorem eq_129 : is_lim (fun t => eq129_a (alpha t) / A t) p_infty right_escape_product_over_a.
Proof.
  known T. apply (tends_ext T (fun t => 2 * Nf t * (1 + hf t ^ 2) / ((1 + hf t) * W t))).
  - intros t Ht. in_the_end T t Ht. unfold eq129_a. symmetry. transitivity (cosh (alpha t) / A t * cosh (2 * alpha t)). unfold Rdiv; ring.
    rewrite eA, e2. field. repeat split; try lra; nra.
  - limit. nra. unfold right_escape_product_over_a. field_simplify_eq; [ ring [s2] | lra ].
Qed.
Theorem eq_129__printed : right_escape_product_over_a <> 1.
Proof. pose proof six_hundredths. lra. Qed.
(* alpha less its law in A goes to 0, and A grows without end *)
Theorem eq_130 : is_lim (fun t => alpha t - right_escape_alpha_by_a (A t)) p_infty 0 /\ is_lim A p_infty p_infty.
Proof.
  split; [ | apply s4_escape_if_A_above_1 ]. known T.
  apply (tends_ext T (fun t => ln ((1 + hf t) ^ 4 * (4 * Nf t ^ 2) / (18 * W t ^ 2)) / 6)).
  - intros t Ht. in_the_end T t Ht. destruct (inside t ltac:(lra)) as (A0 & _). unfold right_escape_alpha_by_a. set (L := ln (3 * sqrt 2 * A t)).
    replace ((1 + hf t) ^ 4 * (4 * Nf t ^ 2) / (18 * W t ^ 2)) with (exp (6 * alpha t - 2 * L)). rewrite ln_exp. field.
    unfold Rminus. rewrite exp_plus, exp_Ropp. replace (2 * L) with (L + L) by ring. rewrite exp_plus. unfold L.
      rewrite exp_ln by (apply Rmult_lt_0_compat; lra).
    replace (6 * alpha t) with (2 * alpha t + 2 * alpha t + 2 * alpha t) by ring. rewrite !exp_plus, ea.
      replace (3 * sqrt 2 * A t * (3 * sqrt 2 * A t)) with (9 * sqrt 2 ^ 2 * A t ^ 2) by ring.
    rewrite eE, s2. field. repeat split; try lra; nra.
  - limit. rewrite s2. lra. rewrite s2. lra. rewrite s2. replace ((1 + 1) ^ 4 * (4 * (3 / 4) ^ 2) * / (18 * 2)) with 1 by field. rewrite ln_1. ring.
Qed.
Theorem eq_130__printed : is_lim (fun t => alpha t - eq130_alpha (A t)) p_infty (ln right_escape_product_over_a / 3) /\ ln
  right_escape_product_over_a / 3 <> 0.
Proof.
  pose proof six_hundredths as c1. destruct eq_130 as [K _]. split. 2: { assert (0 < ln right_escape_product_over_a); [ | lra ]. rewrite <- ln_1.
    apply ln_increasing; lra. }
  apply (tends_ext s (fun t => alpha t - right_escape_alpha_by_a (A t) + ln right_escape_product_over_a / 3)); [ | limit; ring ].
  intros t Ht. destruct (inside t Ht) as (A0 & _). unfold eq130_alpha, right_escape_alpha_by_a.
    replace (3 * sqrt 2 * A t) with (right_escape_product_over_a * (4 * A t)) by (unfold right_escape_product_over_a; field).
  rewrite ln_mult by lra. field.
Qed.
(* the rate of A over its law in A goes to 1 *)
Theorem eq_131 dA : (forall t, s <= t -> rder A t (dA t)) -> is_lim (fun t => dA t / right_escape_a_rate (A t)) p_infty 1.
Proof.
  intros D. destruct eq_130 as [K _]. known T. apply (tends_ext T (fun t => (1 - (1 - hf t) / (1 + hf t)) * exp (alpha t - right_escape_alpha_by_a (A
    t)))).
  - intros t Ht. in_the_end T t Ht. destruct (HT t Ht) as (p0 & _ & E1). destruct (inside t ltac:(lra)) as (A0 & A2 & Ae & k1 & _).
    assert (R : rder A t (p t / A t)).
    { pose proof (root_rate x y u w table t ltac:(lra) ltac:(lra)) as R. rewrite <- Ae in R. destruct R as (F & F1 & F2). exists F. split; trivial.
      intros r Hr. rewrite F2 by trivial. destruct (inside r ltac:(lra)) as (_ & _ & -> & _). reflexivity. }
    rewrite (rder_unique _ _ _ _ (D t ltac:(lra)) R), k1. unfold right_escape_a_rate, Rpower, right_escape_alpha_by_a.
      set (L := ln (3 * sqrt 2 * A t)).
    replace (alpha t - L / 3) with (alpha t + - (1 / 3 * L)) by field. rewrite exp_plus, exp_Ropp. pose proof (exp_pos (1 / 3 * L)).
      pose proof (exp_pos (alpha t)).
    replace ((1 - hf t) / (1 + hf t)) with (/ exp (2 * alpha t)) by (rewrite ea; field; lra).
      replace (2 * alpha t) with (alpha t + alpha t) by ring. rewrite exp_plus. unfold sinh. rewrite exp_Ropp. field. lra.
  - pose proof (tends_comp _ exp _ (derivable_continuous_pt _ _ (derivable_pt_exp 0)) K) as X. cbv beta in X. rewrite exp_0 in X. limit. lra. field.
Qed.
Theorem eq_131__printed dA : (forall t, s <= t -> rder A t (dA t)) ->
  is_lim (fun t => dA t / eq131_a_rate (A t)) p_infty (Rpower right_escape_product_over_a (1 / 3)) /\ Rpower right_escape_product_over_a (1 / 3) <> 1.
Proof.
  intros D. pose proof six_hundredths as c1. split. 2: { assert (1 < Rpower right_escape_product_over_a (1 / 3)); [ | lra ].
    rewrite <- (Rpower_O right_escape_product_over_a) at 1 by lra. apply Rpower_lt; lra. }
  pose proof (eq_131 dA D) as K. apply (tends_ext s (fun t => dA t / right_escape_a_rate (A t) * Rpower right_escape_product_over_a (1 / 3))); [ |
    limit; ring ].
  intros t Ht. destruct (inside t Ht) as (A0 & _). unfold eq131_a_rate, right_escape_a_rate.
    replace (3 * sqrt 2 * A t) with (right_escape_product_over_a * (4 * A t)) by (unfold right_escape_product_over_a; field).
  rewrite <- Rpower_mult_distr by lra. assert (P : forall a b, Rpower a b <> 0) by (intros a b; apply Rgt_not_eq, exp_pos). field. split; apply P.
Qed.

Lemma right_a t : 0 < t -> right_escape_a t = sqrt (sqrt 2 / 9 * t ^ 3).
Proof.
  intros t0. destruct root_two as [s1 s2]. assert (t3 : 0 < t ^ 3) by now apply pow_lt. unfold right_escape_a.
    replace (3 / 2) with (INR 3 * / 2) by (simpl; field). rewrite <- Rpower_mult, Rpower_pow, Rpower_sqrt by trivial.
  rewrite sqrt_mult by lra. f_equal. pose proof (sqrt_pos (sqrt 2)). rewrite <- (sqrt_pow2 (sqrt (sqrt 2) / 3)) by lra. f_equal. unfold Rdiv.
    rewrite Rpow_mult_distr, <- Rsqr_pow2, Rsqr_sqrt by lra. field.
Qed.
(* A *)
Theorem eq_132 : follows A right_escape_a (- (9 * sqrt 2 / 8)).
Proof.
  known T. apply follows_of. apply (near_ext (Rmax T s) (fun t => sqrt (E t / (sqrt 2 / 9 * t ^ 3)))).
  - intros t Ht. pose proof (Rmax_l T s). pose proof (Rmax_r T s). in_the_end T t ltac:(lra). lra. destruct (HT t ltac:(lra)) as (_ & _ & E1).
    destruct (inside t ltac:(lra)) as (_ & _ & -> & _). rewrite right_a by trivial.
    assert (0 < t ^ 3) by now apply pow_lt. apply sqrt_div; nra.
  - eapply near_eq. apply near_root. exact (law_E x y u w T H HT). field.
Qed.
Theorem eq_132__printed : misses A eq132_a (sqrt right_escape_product_over_a).
Proof.
  pose proof six_hundredths as c1. destruct root_two as [s1 s2]. apply (misses_of 1 _ _ _ _ _ eq_132).
  - intros t _ t0. unfold right_escape_a, eq132_a. assert (P : 0 < Rpower t (3 / 2)) by apply exp_pos. pose proof (sqrt_lt_R0 (sqrt 2) ltac:(lra)).
    pose proof (sqrt_lt_R0 27 ltac:(lra)). split; [ | nra ].
    replace (sqrt (sqrt 2) / 3 * Rpower t (3 / 2) / (2 * Rpower t (3 / 2) / sqrt 27)) with (sqrt (sqrt 2) * sqrt 27 / 6) by (field; lra).
    rewrite <- (sqrt_pow2 (sqrt (sqrt 2) * sqrt 27 / 6)) by nra. f_equal. unfold Rdiv.
      rewrite !Rpow_mult_distr, <- !(Rsqr_pow2 (sqrt _)), !Rsqr_sqrt by lra. unfold right_escape_product_over_a. field.
  - assert (1 < sqrt right_escape_product_over_a); [ | lra ]. rewrite <- sqrt_1 at 1. apply sqrt_lt_1_alt. lra.
Qed.
(* alpha *)
Theorem eq_133 : is_lim (fun t => alpha t - right_escape_alpha t) p_infty 0.
Proof.
  known T. pose proof (near_one _ _ (law_alpha x y u w T H HT)) as K. apply (tends_ext T (fun t => ln ((rho t + p t) / (rho t - p t) /
    right_escape_twice_alpha_exp t) / 2)).
  - intros t Ht. in_the_end T t Ht. destruct (inside t ltac:(lra)) as (A0 & _ & _ & _ & _ & k3 & k4). rewrite k3, k4.
    unfold right_escape_alpha, right_escape_twice_alpha_exp.
    pose proof (exp_pos (alpha t)). pose proof (exp_pos (- alpha t)). rewrite <- (exp_ln (sqrt 2 * t)) at 1 by (apply Rmult_lt_0_compat; lra).
      set (L := ln (sqrt 2 * t)).
    replace (A t * exp (alpha t) / (A t * exp (- alpha t)) / exp L) with (exp (2 * alpha t - L)). rewrite ln_exp. field.
    replace (2 * alpha t - L) with (alpha t + alpha t + - L) by ring. rewrite !exp_plus, !exp_Ropp. pose proof (exp_pos L). field. lra.
  - limit. lra. rewrite ln_1. field.
Qed.
Theorem eq_133__printed : is_lim (fun t => alpha t - eq133_alpha t) p_infty (ln right_escape_product_over_a / 2) /\ ln right_escape_product_over_a /
  2 <> 0.
Proof.
  pose proof six_hundredths as c1. pose proof eq_133 as K. split. 2: { assert (0 < ln right_escape_product_over_a); [ | lra ]. rewrite <- ln_1.
    apply ln_increasing; lra. }
  apply (tends_ext 1 (fun t => alpha t - right_escape_alpha t + ln right_escape_product_over_a / 2)); [ | limit; ring ].
  intros t Ht. unfold eq133_alpha, right_escape_alpha. replace (sqrt 2 * t) with (right_escape_product_over_a * (4 * t / 3)) by (unfold
    right_escape_product_over_a; field).
  rewrite ln_mult by lra. field.
Qed.

Lemma atan_close z : 0 < z -> Rabs (atan z / z - 1) <= z ^ 2.
Proof.
  intros z0. assert (D : forall r, is_derive atan r (/ (1 + r ^ 2))). { intros r. apply is_derive_Reals, derivable_pt_lim_atan. }
  assert (C : forall r, continuity_pt atan r) by (intros r; apply derivable_continuous_pt; exists (/ (1 + r ^ 2)); apply is_derive_Reals, D).
  assert (up : atan z - z <= atan 0 - 0).
  { apply (rder_decr (fun r => atan r - r)); [ lra | intros r Hr; pose proof (C r); contq | ]. intros r Hr. eexists. split.
    apply (rder_minus atan (fun r => r)); [ apply rder_of, D | rdq ].
    assert (/ (1 + r ^ 2) <= / 1) by (apply Rinv_le_contravar; nra). lra. }
  assert (lo : z * (1 - z ^ 2) - atan z <= 0 * (1 - 0 ^ 2) - atan 0).
  { apply (rder_decr (fun r => r * (1 - r ^ 2) - atan r)); [ lra | intros r Hr; pose proof (C r); contq | ]. intros r Hr. eexists. split.
    apply (rder_minus (fun r => r * (1 - r ^ 2)) atan); [ rdq | apply rder_of, D ].
    simpl INR. simpl pred. assert (q : / (1 + r ^ 2) * (1 + r ^ 2) = 1) by (field; nra). assert (0 < / (1 + r ^ 2)) by (apply Rinv_0_lt_compat;
      nra). pose proof (pow2_ge_0 r). nra. }
  rewrite atan_0 in *. replace (atan z / z - 1) with ((atan z - z) / z) by (field; lra). apply Rabs_le. split; [ apply Rle_div_r |
    apply Rle_div_l ]; trivial; nra.
Qed.
(* pi/2 - psi, where psi is chosen between - pi and pi *)
Theorem eq_134 psi (range : forall t, s <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) :
  follows (fun t => PI / 2 - psi t) right_escape_lag (3 * sqrt 2 / 4).
Proof.
  known T. apply follows_of. apply (near_ext T (fun t => atan (zf t) / zf t * / U x y u w t)).
  - intros t Ht. in_the_end T t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape x y u w t p0 x0 E1) as (pr & _ & _ & _ & xe & le & _).
    fold zf in xe, le.
    destruct (range t ltac:(lra)) as [rg [a1 a2]]. assert (r0 : 0 < rho t) by lra. assert (q0 : 0 < 1 + zf t ^ 2) by (pose proof (pow2_ge_0 (zf t));
      lra).
    assert (c1 : cos (psi t) = 2 * zf t * / (1 + zf t ^ 2)). { apply (Rmult_eq_reg_l (rho t)); [ | lra ]. rewrite <- xe, a1. field. lra. }
    assert (c2 : sin (psi t) = (1 - zf t ^ 2) * / (1 + zf t ^ 2)). { apply (Rmult_eq_reg_l (rho t)); [ | lra ]. rewrite a2 in le.
      replace (- (rho t * p t * sin (psi t)) * / p t) with (- (rho t * sin (psi t))) in le by (field; lra). lra. }
    assert (c0' : 0 < cos (psi t)). { rewrite c1. apply Rmult_lt_0_compat. lra. now apply Rinv_0_lt_compat. }
    pose proof PI_RGT_0 as pi0. assert (near0 : - (PI / 2) < psi t < PI / 2).
    { split; apply Rnot_le_lt; intros k; [ rewrite <- cos_neg in c0'; pose proof (cos_le_0 (- psi t) ltac:(lra) ltac:(lra)) |
      pose proof (cos_le_0 (psi t) ltac:(lra) ltac:(lra)) ]; lra. }
    set (e := (PI / 2 - psi t) / 2). assert (e1 : sin (2 * e) = cos (psi t)) by (unfold e;
      replace (2 * ((PI / 2 - psi t) / 2)) with (PI / 2 - psi t) by field; apply sin_shift).
    assert (e2' : cos (2 * e) = sin (psi t)) by (unfold e; replace (2 * ((PI / 2 - psi t) / 2)) with (PI / 2 - psi t) by field; apply cos_shift).
    assert (ce : 0 < cos e) by (apply cos_gt_0; unfold e; lra). rewrite sin_2a in e1. rewrite cos_2a_cos in e2'.
    assert (te : tan e = zf t). { unfold tan. apply (Rmult_eq_reg_r (2 * cos e * cos e)); [ | apply Rgt_not_eq, Rmult_lt_0_compat; lra ].
      transitivity (cos (psi t)). rewrite <- e1. field. lra.
      replace (2 * cos e * cos e) with (1 + sin (psi t)) by lra. rewrite c1, c2. field. lra. }
    assert (ae : atan (zf t) = e) by (rewrite <- te; apply atan_tan; unfold e; lra). rewrite ae. unfold right_escape_lag, U, e. fold zf. field. lra.
  - pose proof (near_U x y u w T H) as NU. eapply near_eq. apply near_mult; [ | apply near_inv; exact NU ].
    + apply (near_small _ (fun t => t * (atan (zf t) / zf t - 1)) 0).
      * apply (squeeze T _ (fun t => zf t * t * zf t)). 2: { limit. ring. } intros t Ht. in_the_end T t Ht. pose proof (atan_close (zf t) z0).
        rewrite Rabs_mult, Rabs_pos_eq by lra. nra.
      * exists T. intros t Ht. in_the_end T t Ht. field. lra.
    + field.
Qed.
Theorem eq_134__printed psi (range : forall t, s <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) :
  misses (fun t => PI / 2 - psi t) eq134_lag 0.
Proof.
  destruct (eq_134 psi range) as [K _]. split; [ | lra ]. pose proof inv_time as I. cbv beta in K, I.
  apply (tends_ext 1 (fun t => (PI / 2 - psi t) / right_escape_lag t * (2 / 3 * sqrt (3 * / t)))).
  - intros t Ht. unfold right_escape_lag, eq134_lag. replace (1 / 2) with (/ 2) by field. assert (q : 0 < 3 / t) by (apply Rdiv_lt_0_compat; lra).
    rewrite Rpower_sqrt by trivial.
    change (3 * / t) with (3 / t). pose proof (sqrt_lt_R0 _ q) as r0. assert (r2 : sqrt (3 / t) ^ 2 = 3 / t) by (rewrite <- Rsqr_pow2;
      apply Rsqr_sqrt; lra).
    set (k := sqrt (3 / t)) in *. replace ((PI / 2 - psi t) / (2 / t)) with ((PI / 2 - psi t) * (3 / (2 * (3 / t)))) by (field; lra). rewrite <- r2.
      field. lra.
  - limit. rewrite Rmult_0_r. lra. rewrite Rmult_0_r, sqrt_0. ring.
Qed.
(* the speed p and the distance rho *)
Theorem eq_135 : follows (fun t => p t) right_escape_rho (- (3 * sqrt 2 / 2)).
Proof. known T. apply follows_of. exact (law_p x y u w T H HT). Qed.
Theorem eq_136 : follows (fun t => rho t) right_escape_rho (- (3 * sqrt 2 / 2)).
Proof. known T. apply follows_of. exact (law_rho x y u w T H HT). Qed.
Lemma over_printed f g c : follows f right_escape_rho c -> (forall t, g t = 2 * t ^ 2 / 9) -> misses f g right_escape_product_over_a.
Proof.
  intros F G. destruct root_two as [s1 s2]. apply (misses_of 1 _ _ _ _ _ F). 2: pose proof six_hundredths; lra.
  intros t _ t0. rewrite G. unfold right_escape_rho, right_escape_product_over_a. split. field_simplify_eq; [ ring [s2] | lra ].
  apply Rgt_not_eq. apply Rmult_lt_0_compat; [ apply Rdiv_lt_0_compat; lra | now apply pow_lt ].
Qed.
Theorem eq_135__printed : misses (fun t => p t) eq135_p right_escape_product_over_a.
Proof. apply (over_printed _ _ _ eq_135). reflexivity. Qed.
Theorem eq_136__printed : misses (fun t => rho t) eq136_rho right_escape_product_over_a.
Proof. apply (over_printed _ _ _ eq_136). reflexivity. Qed.

(* the length of the path *)
Section Path.
Variable len : R -> R.
Hypothesis len_cont : forall t, s < t -> continuity_pt len t.
Hypothesis len_rate : forall t, s <= t -> rder len t (eq105_arc_rate (p t)).
Lemma energy t : s <= t -> E t / 2 = len t + (E s / 2 - len s).
Proof.
  intros Ht. enough (E t * / 2 - len t = E s * / 2 - len s) by lra. apply (rder_const (fun t => E t * / 2 - len t)); trivial; intros r Hr.
  - pose proof (len_cont r ltac:(lra)). apply (continuity_pt_minus (fun t => E t * / 2)); trivial. cont; first [ apply (s_cx _ _ _ _ table) |
    apply (s_cy _ _ _ _ table) | apply (s_cu _ _ _ _ table) | apply (s_cw _ _ _ _ table) ]; lra.
  - destruct (s_law _ _ _ _ table r ltac:(lra)) as (X & Y & fx & fy & [B P] & U' & W'). pose proof (len_rate r ltac:(lra)) as L. eapply rder_eq.
    apply (rder_minus (fun t => E t * / 2) len); [ rd | exact L ]. simpl. unfold eq105_arc_rate. lra.
Qed.
Theorem eq_137 : follows len right_escape_s (- (9 * sqrt 2 / 4)).
Proof.
  known T. apply follows_of. set (c := E s / 2 - len s). pose proof inv_time as I. pose proof inv_ln as J. cbv beta in I, J.
  apply (near_ext (Rmax T (exp 1)) (fun t => E t / (sqrt 2 / 9 * t ^ 3) + - (c * 18 / sqrt 2) * (/ t) ^ 3)).
  - intros t Ht. pose proof (Rmax_l T (exp 1)). in_the_end T t ltac:(lra). lra. pose proof (energy t ltac:(lra)) as e. fold c in e.
    replace (len t) with (E t / 2 - c) by lra. unfold right_escape_s. field_simplify_eq; [ ring [s2] | lra ].
  - apply near_plus. exact (law_E x y u w T H HT). apply (tends_ext 1 (fun t => - (c * 18 / sqrt 2) * (/ t) ^ 2 * / ln t)).
    + intros t Ht. unfold Rdiv at 3. set (l := / ln t). field. lra.
    + limit. ring.
Qed.
Theorem eq_137__printed : misses len eq137_s right_escape_product_over_a.
Proof.
  destruct root_two as [s1 s2]. apply (misses_of 1 _ _ _ _ _ eq_137). 2: pose proof six_hundredths; lra.
  intros t _ t0. assert (t3 : 0 < t ^ 3) by now apply pow_lt. unfold right_escape_s, eq137_s, right_escape_product_over_a. split. field_simplify_eq;
    [ ring [s2] | lra ].
  apply Rgt_not_eq. apply Rmult_lt_0_compat; trivial. apply Rdiv_lt_0_compat; [ apply Rdiv_lt_0_compat | ]; lra.
Qed.
(* A^2/2 over s goes to 1: by (104) their difference is constant, whatever the motion, and s grows without end *)
Theorem eq_138 : is_lim (fun t => eq138_s (A t) / len t) p_infty 1.
Proof.
  pose proof (proj1 s4_escape_if_A_above_1) as K. set (c := E s / 2 - len s). apply (tends_ext s (fun t => / (1 - 2 * c * (/ A t) ^ 2))).
  - intros t Ht. destruct (inside t Ht) as (A0 & A2 & _). pose proof (energy t Ht) as e. fold c in e. unfold eq138_s. rewrite <- A2 in e.
    replace (len t) with (A t ^ 2 / 2 - c) by lra.
    destruct (Req_dec (A t ^ 2 / 2 - c) 0) as [z | n].
    + rewrite z. unfold Rdiv. replace (1 - 2 * c * (/ A t) ^ 2) with 0. rewrite Rinv_0. ring. replace c with (A t ^ 2 / 2) by lra. field. lra.
    + field. repeat split; try lra; intros k; apply n; lra.
  - pose proof (is_lim_inv A p_infty p_infty K ltac:(discriminate)) as I. simpl in I. limit. lra. field.
Qed.
End Path.
(* alpha grows without end *)
Theorem s4_alpha_unbounded : is_lim alpha p_infty p_infty.
Proof.
  pose proof eq_133 as K. apply is_lim_spec. intros M. destruct (in_the_end 1 _ 0 1 K Rlt_0_1) as (T & T0 & HT). destruct root_two as [s1 s2].
    exists (Rmax T (exp (2 * (M + 1)))). intros t Ht.
  pose proof (Rmax_l T (exp (2 * (M + 1)))). pose proof (Rmax_r T (exp (2 * (M + 1)))). specialize (HT t ltac:(lra)). apply Rabs_def2 in HT.
    unfold right_escape_alpha in HT.
  assert (2 * (M + 1) <= ln (sqrt 2 * t)); [ | lra ]. rewrite <- (ln_exp (2 * (M + 1))) at 1. apply ln_mono. split. apply exp_pos. nra.
Qed.
End Escapes.

(* ---- what these theorems speak of exists ---- *)
(* every motion inside p < rho has an A and an alpha, and while it slips a psi *)
Lemma inner_exists x y u w s : spin x y u w -> 0 <= s -> 0 < x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2) -> exists A alpha,
  (forall t, A t = sqrt (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2))) /\ forall t, s <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha
    t).
Proof.
  intros S Hs HE. set (A t := sqrt (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2))). exists A, (fun t => arcsinh (nrm (u t) (w t) / A t)). split; trivial.
  intros t Ht. pose proof (A_never_falls x y u w S s t ltac:(lra)) as up. assert (A0 : 0 < A t) by (apply sqrt_lt_R0; lra).
  assert (A2 : A t ^ 2 = x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) by (unfold A; rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra). split; trivial.
  unfold hyperbolic, eq111_p, eq112_rho. set (a := arcsinh (nrm (u t) (w t) / A t)).
    assert (sa : sinh a = nrm (u t) (w t) / A t) by apply sinh_arcsinh. split. rewrite sa. field. lra.
  pose proof (cosh2 a) as c2. pose proof (cosh_pos a) as c0. pose proof (nrm_pos (x t) (y t)). apply Rsqr_inj; trivial. apply Rmult_le_pos; lra.
    rewrite !Rsqr_pow2, Rpow_mult_distr, c2, sa, nrm_sq.
  pose proof (nrm_sq (u t) (w t)). field_simplify_eq; [ | lra ]. lra.
Qed.
Definition angle_of x y u w := let c := (x * u + y * w) / (nrm x y * nrm u w) in if Rle_dec (x * w - y * u) 0 then acos c else - acos c.
Lemma angle_exists x y u w : 0 < nrm x y -> 0 < nrm u w -> - PI < angle_of x y u w <= PI /\ angle x y u w (angle_of x y u w).
Proof.
  intros r0 p0. pose proof (nrm_sq x y) as r2. pose proof (nrm_sq u w) as p2. unfold angle, angle_of. set (r := nrm x y) in *.
    set (p := nrm u w) in *. cbv zeta. set (c := (x * u + y * w) / (r * p)). set (l := (x * w - y * u) / (r * p)).
  assert (rp : 0 < r * p) by nra. assert (cl : c ^ 2 + l ^ 2 = 1). { unfold c, l. field_simplify_eq; [ | lra ]. ring [r2 p2]. }
  assert (c1 : -1 <= c <= 1) by (split; nra). pose proof (acos_bound c) as [a0 a1]. pose proof (cos_acos c c1) as ca.
    pose proof (sin_acos c c1) as sa.
  assert (q : sqrt (1 - c²) = Rabs l) by (rewrite <- sqrt_Rsqr_abs; f_equal; rewrite !Rsqr_pow2; lra). rewrite q in sa.
    assert (le : x * w - y * u = l * (r * p)) by (unfold l; field; lra).
  destruct (Rle_dec (x * w - y * u) 0) as [k | k]; rewrite ?cos_neg, ?sin_neg, ca, sa, le.
  - rewrite Rabs_left1 by nra. pose proof PI_RGT_0. split; [ lra | ]. unfold c. split; field; lra.
  - assert (l0 : 0 < l) by nra. rewrite Rabs_pos_eq by lra. assert (acos c <> PI). { intros e. rewrite e, cos_PI in ca. nra. } split; [ lra | ].
    unfold c. split; field; lra.
Qed.
(* one that never stops: from rho = 2 outward, p = 1 *)
Lemma slip_witness : exists x y u w, spin x y u w /\ 1 < x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2) /\ forall t, 0 <= t -> 0 < nrm (u t) (w t).
Proof.
  destruct (table_exists 2 0 1 0) as (x & y & u & w & S & e1 & e2 & e3 & e4). exists x, y, u, w. split; trivial. split. rewrite e1, e2, e3, e4. lra.
  intros t Ht. apply (never_stops x y u w S 0); try lra; rewrite e1, e2, e3, e4. lra.
  pose proof (nrm_pos 1 0). pose proof (sqrt_pos (2 ^ 2 + 0 ^ 2 - (1 ^ 2 + 0 ^ 2))). nra.
Qed.
(* a motion that escapes, with all that goes with it *)
Lemma an_escape : exists x y u w A alpha, spin x y u w /\ (forall t, 0 <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha t)) /\
  eq127_least_a < A 0 /\
  (forall t, 0 <= t -> 0 < nrm (u t) (w t)) /\ (exists psi, forall t, 0 <= t -> - PI < psi t <= PI /\ angle (x t) (y t) (u t) (w t) (psi t)) /\
  (exists dA, forall t, 0 <= t -> rder A t (dA t)) /\ (exists dalpha, forall t, 0 <= t -> 0 < nrm (u t) (w t) -> rder alpha t (dalpha t)) /\
  exists len, (forall t, 0 < t -> continuity_pt len t) /\ forall t, 0 <= t -> rder len t (eq105_arc_rate (nrm (u t) (w t))).
Proof.
  destruct slip_witness as (x & y & u & w & S & E1 & P). destruct (inner_exists x y u w 0 S (Rle_refl 0) ltac:(lra)) as (A & alpha & Ae & In).
    exists x, y, u, w, A, alpha.
  assert (p0 : forall t, 0 <= t -> 0 < nrm (u t) (w t)) by (intros t Ht; specialize (P t Ht); lra).
  assert (ps : forall t, 0 <= t -> - PI < angle_of (x t) (y t) (u t) (w t) <= PI /\ angle (x t) (y t) (u t) (w t) (angle_of (x t) (y t) (u t) (w t))).
  { intros t Ht. apply angle_exists; auto. destruct (In t Ht) as (A0 & _ & e). rewrite e. unfold eq112_rho. pose proof (cosh_pos (alpha t)). nra. }
  assert (R : forall t, 0 <= t -> rder A t (eq113_a_rate (alpha t)) /\ rder alpha t (eq114_alpha_rate (A t) (alpha t) (angle_of (x t) (y t) (u t) (w
    t)))).
  { intros t Ht. destruct (ps t Ht) as [_ [a1 _]]. pose proof (A_never_falls x y u w S 0 t ltac:(lra)).
    destruct (rates_inside x y u w S t Ht (p0 t Ht) _ alpha 1 Rlt_0_1 ltac:(lra) a1) as [R1 R2].
    { intros r Hr. rewrite <- Ae. apply In. lra. } rewrite <- Ae in R2. split; trivial. destruct R1 as (F & F1 & F2). exists F. split; trivial.
      intros r Hr. rewrite Ae. now apply F2. }
  split; trivial. split; trivial. split. { rewrite Ae. unfold eq127_least_a. rewrite <- sqrt_1 at 1. apply sqrt_lt_1_alt. lra. } split; trivial.
  split. { exists (fun t => angle_of (x t) (y t) (u t) (w t)). exact ps. } split. { exists (fun t => eq113_a_rate (alpha t)). intros t Ht.
    now apply R. }
  split. { exists (fun t => eq114_alpha_rate (A t) (alpha t) (angle_of (x t) (y t) (u t) (w t))). intros t Ht _. now apply R. }
  exists (fun t => (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) * / 2). split; intros t Ht.
  - cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.
  - eapply rder_eq. apply (rder_mult (fun t => x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) (fun _ => / 2)); [ apply (E_rate x y u w S t Ht) | rd ].
    unfold eq105_arc_rate. field.
Qed.
Ltac an_escape := intros H; pose proof (Rle_refl 0); destruct an_escape as (x & y & u & w & A & alpha & S & In & A1 & p0 & (psi & Hpsi) & (dA & HdA)
  & (dalpha & Hda) & len & Hlen & Hlen');
  first [ eapply (H x y u w A alpha 0); eassumption | idtac ].
Lemma eq_126__occurs : ltac:(occurs eq_126).
Proof. an_escape. apply (H x y u w A alpha (psi 0) 0 1); trivial; try lra. now apply p0. intros r Hr. apply In. lra. now apply Hpsi. Qed.
Lemma eq_127__occurs : ltac:(occurs eq_127). Proof. an_escape. Qed.
Lemma s4_A_never_decreases__occurs : ltac:(occurs s4_A_never_decreases). Proof. an_escape. Qed.
Lemma s4_escape_if_A_above_1__occurs : ltac:(occurs s4_escape_if_A_above_1). Proof. an_escape. Qed.
Lemma eq_128__occurs : ltac:(occurs eq_128). Proof. an_escape. Qed.
Lemma eq_128__printed__occurs : ltac:(occurs eq_128__printed). Proof. an_escape. Qed.
Lemma eq_129__occurs : ltac:(occurs eq_129). Proof. an_escape. Qed.
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
  destruct (table_exists (A0 * cosh a) 0 (A0 * sinh a * cos psi0) (- (A0 * sinh a * sin psi0))) as (x & y & u & w & S & e1 & e2 & e3 & e4).
  pose proof (sin2_cos2 psi0) as sc. rewrite !Rsqr_pow2 in sc. assert (E0 : x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2) = A0 ^ 2).
  { rewrite e1, e2, e3, e4. transitivity (A0 ^ 2 * (cosh a ^ 2 - sinh a ^ 2 * (sin psi0 ^ 2 + cos psi0 ^ 2))). ring. rewrite sc, ch. ring. }
  destruct (inner_exists x y u w 0 S (Rle_refl 0)) as (A & alpha & Ae & In). rewrite E0. nra.
  assert (rn : nrm (x 0) (y 0) = A0 * cosh a). { rewrite e1, e2. unfold nrm. replace ((A0 * cosh a) ^ 2 + 0 ^ 2) with ((A0 * cosh a) ^ 2) by ring.
    apply sqrt_pow2. nra. }
  assert (pn : nrm (u 0) (w 0) = A0 * sinh a). { rewrite e3, e4. unfold nrm. replace (_ ^ 2 + _ ^ 2) with ((A0 * sinh a) ^ 2 * (sin psi0 ^ 2 + cos
    psi0 ^ 2)) by ring. rewrite sc, Rmult_1_r. apply sqrt_pow2. nra. }
  assert (A00 : A 0 = A0) by (rewrite Ae, E0; apply sqrt_pow2; lra).
  exists x, y, u, w, A, alpha, (fun t => if Req_EM_T t 0 then psi0 else if Rlt_dec 0 (nrm (u t) (w t)) then angle_of (x t) (y t) (u t) (w t) else 0).
  split; trivial. split; trivial. split; [ | split; trivial; split ].
  - intros t Ht. destruct (In t Ht) as (At & _ & k2). destruct (Req_EM_T t 0) as [-> | n]; [ | destruct (Rlt_dec 0 (nrm (u t) (w t))) as [k | k] ].
    + split. lra. unfold angle. rewrite rn, pn, e1, e2, e3, e4. split; ring.
    + apply angle_exists; trivial. rewrite k2. unfold eq112_rho. apply Rmult_lt_0_compat; trivial. apply cosh_pos.
    + pose proof PI_RGT_0. split. lra. pose proof (nrm_pos (u t) (w t)). assert (z : nrm (u t) (w t) = 0) by lra.
      destruct (stop0 u w t z) as [z1 z2]. unfold angle. rewrite z, z1, z2. split; ring.
  - now destruct (Req_EM_T 0 0).
  - destruct (In 0 (Rle_refl 0)) as (_ & k1 & _). unfold eq111_p in k1. rewrite pn, A00 in k1.
    rewrite <- (arcsinh_sinh (alpha 0)), <- (arcsinh_sinh a). f_equal. nra.
Qed.
(* ... and one that is caught as (127) says: from rho = 1/2, p = 1/4 *)
Lemma eq_127__caught__occurs : exists x y u w A alpha, spin x y u w /\ (forall t, 0 <= t -> 0 < A t /\ hyperbolic (x t) (y t) (u t) (w t) (A t) (alpha
  t)) /\
  A 0 < eq127_least_a /\ 0 < alpha 0 < ln (1 / A 0).
Proof.
  destruct (table_exists (/ 2) 0 (/ 4) 0) as (x & y & u & w & S & e1 & e2 & e3 & e4).
    destruct (inner_exists x y u w 0 S (Rle_refl 0)) as (A & alpha & Ae & In). rewrite e1, e2, e3, e4. lra.
  exists x, y, u, w, A, alpha. split; trivial. split; trivial. destruct (inside x y u w A alpha 0 In 0 (Rle_refl 0)) as (A0 & A2 & _ & k1 & _ & sum &
    _). rewrite e1, e2, e3, e4 in *.
  assert (n : forall a, 0 <= a -> nrm a 0 = a) by (intros a Ha; unfold nrm; replace (a ^ 2 + 0 ^ 2) with (a ^ 2) by ring; now apply sqrt_pow2).
    rewrite !n in * by lra.
  unfold eq127_least_a. split. nra. split. { apply sinh_sign. nra. } rewrite <- (ln_exp (alpha 0)). apply ln_increasing. apply exp_pos.
    apply Rlt_div_r; trivial. lra.
Qed.
