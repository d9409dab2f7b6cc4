(* (104), (106), (109), (113) to (115), (124), (125) of every motion on the turntable *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Pieces Periodic Steady Work Fate Alpha Formulas.
Open Scope R_scope.

(* (90) to (93): psi is the angle from the velocity to the position *)
Definition angle x y u w psi := x * u + y * w = nrm x y * nrm u w * cos psi /\ x * w - y * u = - (nrm x y * nrm u w * sin psi).
(* (111), (112) *)
Definition hyperbolic x y u w A alpha := nrm u w = eq111_p A alpha /\ nrm x y = eq112_rho A alpha.

Lemma cosh_pos a : 0 < cosh a.
Proof. unfold cosh. pose proof (exp_pos a). pose proof (exp_pos (- a)). lra. Qed.

Section Angles.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Ltac conts := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

(* (104), (105), rest included *)
Theorem eq_104 s : (forall t, 0 < t -> continuity_pt s t) -> (forall t, 0 <= t -> rder s t (eq105_arc_rate (p t))) ->
  forall t, 0 <= t -> eq104_constant (p t) (rho t) (s t) = eq104_constant (p 0) (rho 0) (s 0).
Proof.
  intros cs ds t Ht. unfold eq104_constant. rewrite !nrm_sq.
  apply (rder_const (fun t => (u t ^ 2 + w t ^ 2 - (x t ^ 2 + y t ^ 2)) * / 2 + s t)); trivial; intros r Hr.
  - apply (continuity_pt_plus (fun t => (u t ^ 2 + w t ^ 2 - (x t ^ 2 + y t ^ 2)) * / 2) s); [ conts | apply cs; lra ].
  - eapply rder_eq. apply (rder_plus (fun t => (u t ^ 2 + w t ^ 2 - (x t ^ 2 + y t ^ 2)) * / 2) s); [ apply (eq103 x y u w S); lra | apply ds; lra ].
    unfold eq105_arc_rate. ring.
Qed.

Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis N : 0 < p t.

Lemma rho_pos psi : angle (x t) (y t) (u t) (w t) psi -> 0 < rho t -> xi t = rho t * cos psi /\ ell t = - (rho t * sin psi).
Proof. intros [e1 e2] r0. rewrite e1, e2. split; field; lra. Qed.

(* (109): psi as a continuous function of the time *)
Theorem eq_109 psi d : 0 < d -> 0 < rho t -> continuity_pt psi t -> (forall s, t <= s < t + d -> angle (x s) (y s) (u s) (w s) (psi s)) ->
  rder psi t (eq109_psi_rate (p t) (rho t) (psi t)).
Proof.
  intros Hd r0 C H. destruct (rho_pos _ (H t ltac:(lra)) r0) as [exi eell].
  assert (R0 : rder (fun t => rho t) t (p t * cos (psi t))) by (apply (eq108 x y u w S t ht ltac:(lra) (psi t) ltac:(lra)), (H t ltac:(lra))).
  set (sn s := - ell s * / rho s). set (cs s := xi s * / rho s).
  assert (D : rder (fun s => sn s * cos (psi t) - cs s * sin (psi t)) t (eq109_psi_rate (p t) (rho t) (psi t))).
  { unfold sn, cs. eapply rder_eq. apply (rder_minus (fun s => - ell s * / rho s * cos (psi t)) (fun s => xi s * / rho s * sin (psi t))).
    - apply (rder_mult (fun s => - ell s * / rho s) (fun _ => cos (psi t))); [ | rd ]. apply (rder_mult (fun s => - ell s) (fun s => / rho s)).
      apply (rder_opp (fun s => ell s)), (eq100 x y u w S t ht ltac:(lra)). apply (rder_inv (fun s => rho s)); [ exact R0 | lra ].
    - apply (rder_mult (fun s => xi s * / rho s) (fun _ => sin (psi t))); [ | rd ]. apply (rder_mult (fun s => xi s) (fun s => / rho s)).
      apply (eq101 x y u w S t ht ltac:(lra)). apply (rder_inv (fun s => rho s)); [ exact R0 | lra ].
    - cbv beta. rewrite exi, eell. unfold eq109_psi_rate. set (n := p t) in *. set (m := rho t) in *. set (c := cos (psi t)). set (z := sin (psi t)).
      assert (e : z ^ 2 = 1 - c ^ 2) by (unfold z, c; pose proof (sin2_cos2 (psi t)); unfold Rsqr in *; lra).
      field_simplify_eq; [ | lra ]. ring [e]. }
  assert (V : exists d1, 0 < d1 /\ forall s, t <= s < t + d1 -> - (PI / 2) < psi s - psi t < PI / 2).
  { destruct (C (PI / 2)) as (d1 & d10 & H1). pose proof PI_RGT_0; lra. exists d1. split; trivial. intros s Hs. pose proof PI_RGT_0.
    destruct (Req_dec s t) as [-> | ne]. lra. simpl in H1. unfold R_dist in H1. specialize (H1 s). assert (Q : Rabs (psi s - psi t) < PI / 2).
    { apply H1. split; [ split; [ exact I | auto ] | apply Rabs_def1; lra ]. } apply Rabs_def2 in Q. lra. }
  assert (P : exists d2, 0 < d2 /\ forall s, t < s < t + d2 -> 0 < p s * rho s).
  { apply (right_pos (fun s => p s * rho s) t _ (rder_mult (fun s => p s) (fun s => rho s) t _ _ (dp x y u w S t ht ltac:(lra)) R0)). nra. }
  destruct V as (d1 & d10 & H1). destruct P as (d2 & d20 & H2).
  apply (rder_near psi (fun s => psi t + asin (sn s * cos (psi t) - cs s * sin (psi t))) t _ (Rmin d (Rmin d1 d2))). repeat apply Rmin_pos; trivial.
  - intros s Hs. pose proof (Rmin_l d (Rmin d1 d2)). pose proof (Rmin_r d (Rmin d1 d2)). pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
    specialize (H1 s ltac:(lra)). destruct (H s ltac:(lra)) as [a1 a2].
    assert (Q : 0 < p s * rho s). { destruct (Req_dec s t) as [-> | ne]. nra. apply H2; lra. } pose proof (nrm_pos (u s) (w s)). pose proof (nrm_pos (x s) (y s)).
    assert (p s <> 0) by nra. assert (rho s <> 0) by nra. unfold sn, cs. rewrite a1, a2.
    replace (- (- (rho s * p s * sin (psi s)) * / p s) * / rho s) with (sin (psi s)) by (field; split; trivial).
    replace (rho s * p s * cos (psi s) * / p s * / rho s) with (cos (psi s)) by (field; split; trivial).
    rewrite <- sin_minus, asin_sin by lra. ring.
  - eapply rder_eq. apply (rder_plus (fun _ => psi t)); [ rd | ]. apply (rder_comp _ asin t _ 1 D).
    2: ring. assert (z : sn t * cos (psi t) - cs t * sin (psi t) = 0). { unfold sn, cs. rewrite exi, eell. field. lra. }
    rewrite z. apply is_derive_Reals. assert (b : -1 < 0 < 1) by lra. apply (derive_pt_eq_1 _ _ _ (derivable_pt_asin 0 b)). rewrite derive_pt_asin.
    replace (1 - 0²) with 1 by (unfold Rsqr; ring). rewrite sqrt_1. field.
Qed.

(* (113) and (114): A = sqrt (rho^2 - p^2), alpha by (111) *)
Theorem eq_114 psi al d : 0 < d -> 0 < E t -> x t * u t + y t * w t = rho t * p t * cos psi ->
  (forall s, t <= s < t + d -> hyperbolic (x s) (y s) (u s) (w s) (sqrt (E s)) (al s)) ->
  rder (fun s => sqrt (E s)) t (eq113_a_rate (al t)) /\ rder al t (eq114_alpha_rate (sqrt (E t)) (al t) psi).
Proof.
  intros Hd E0 e H. pose proof (eq113 x y u w S t ht ltac:(lra) E0) as DA. destruct (H t ltac:(lra)) as [e1 e2]. unfold eq111_p, eq112_rho in *.
  assert (A0 : 0 < sqrt (E t)) by (apply sqrt_lt_R0; trivial).
  assert (ez : sinh (al t) = p t / sqrt (E t)) by (rewrite e1; field; lra). assert (ec : cosh (al t) = rho t / sqrt (E t)) by (rewrite e2; field; lra).
  split. { unfold eq113_a_rate. rewrite ez. exact DA. }
  apply (rder_near al (fun s => arcsinh (p s * / sqrt (E s))) t _ d Hd).
  - intros s Hs. destruct (H s Hs) as [k _]. unfold eq111_p in k. rewrite k. pose proof (A_never_falls x y u w S t s ltac:(lra)).
    replace (sqrt (E s) * sinh (al s) * / sqrt (E s)) with (sinh (al s)). apply arcsinh_sinh.
    field. assert (0 < sqrt (E s)) by (apply sqrt_lt_R0; lra). lra.
  - eapply rder_eq. apply (rder_comp (fun s => p s * / sqrt (E s)) arcsinh).
    + apply (rder_mult (fun s => p s) (fun s => / sqrt (E s))). apply (eq107 x y u w S t ht ltac:(lra) psi e). apply (rder_inv (fun s => sqrt (E s))); [ exact DA | lra ].
    + apply is_derive_Reals, derivable_pt_lim_arcsinh.
    + cbv beta. unfold eq114_alpha_rate. rewrite ec. replace (sqrt ((p t * / sqrt (E t)) ^ 2 + 1)) with (rho t / sqrt (E t)).
      * assert (r0 : 0 < rho t). { rewrite e2. apply Rmult_lt_0_compat; trivial. apply cosh_pos. }
        assert (aa : sqrt (E t) ^ 2 = rho t ^ 2 - p t ^ 2) by (rewrite !nrm_sq, <- Rsqr_pow2; apply Rsqr_sqrt; lra).
        set (a := sqrt (E t)) in *. set (n := p t) in *. set (m := rho t) in *. field_simplify_eq; [ | lra ]. ring [aa].
      * symmetry. rewrite <- ec. rewrite <- (sqrt_pow2 (cosh (al t))) by (left; apply cosh_pos). f_equal. change (p t * / sqrt (E t)) with (p t / sqrt (E t)). rewrite <- ez.
        unfold sinh, cosh. assert (k : exp (al t) * exp (- al t) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). field_simplify. nra.
Qed.
(* (115) *)
Theorem eq_115 psi A al d : 0 < d -> 0 < A -> hyperbolic (x t) (y t) (u t) (w t) A al -> continuity_pt psi t ->
  (forall s, t <= s < t + d -> angle (x s) (y s) (u s) (w s) (psi s)) -> rder psi t (eq115_psi_rate al (psi t)).
Proof.
  intros Hd A0 [e1 e2] C H. unfold eq111_p, eq112_rho in *. pose proof (cosh_pos al) as c0. assert (r0 : 0 < rho t) by (rewrite e2; nra).
  assert (z0 : 0 < sinh al). { rewrite e1 in N. nra. }
  eapply rder_eq. apply (eq_109 psi d); trivial. unfold eq109_psi_rate, eq115_psi_rate, coth. rewrite e1, e2.
  replace (cosh (2 * al)) with (cosh al ^ 2 + sinh al ^ 2). replace (sinh (2 * al)) with (2 * sinh al * cosh al). field. lra.
  - unfold sinh, cosh. replace (2 * al) with (al + al) by ring. rewrite Ropp_plus_distr, !exp_plus. field.
  - unfold sinh, cosh. replace (2 * al) with (al + al) by ring. rewrite Ropp_plus_distr, !exp_plus. field.
Qed.
End Angles.

(* (124), (125): within a turn (115) is zero at these two angles and nowhere else *)
Theorem eq_124_125_zeros al psi : 0 < al -> - PI < psi <= PI -> eq115_psi_rate al psi = 0 <-> psi = eq124_psi1 al \/ psi = eq125_psi2 al.
Proof.
  intros Ha Hp. unfold eq115_psi_rate, eq124_psi1, eq125_psi2, coth, tanh. pose proof (cosh_pos (2 * al)) as c0.
  assert (z0 : 0 < sinh (2 * al)) by (rewrite <- sinh_0; apply sinh_lt; lra).
  assert (T1 : 0 < sinh (2 * al) / cosh (2 * al) < 1).
  { split. now apply Rdiv_lt_0_compat. apply Rlt_div_l; trivial. unfold sinh, cosh. pose proof (exp_pos (- (2 * al))). lra. }
  set (T := sinh (2 * al) / cosh (2 * al)) in *.
  assert (eqv : 2 * (1 - sin psi * (cosh (2 * al) / sinh (2 * al))) = 0 <-> sin psi = T).
  { replace (cosh (2 * al) / sinh (2 * al)) with (/ T) by (unfold T; field; lra). split; intros h.
    - replace (sin psi) with (sin psi * / T * T) by (field; lra). replace (sin psi * / T) with 1 by lra. ring.
    - rewrite h. field. lra. }
  rewrite eqv. split.
  - intros h. assert (0 < psi). { apply Rnot_le_lt. intros k. destruct k as [k | k]. pose proof (sin_lt_0_var psi ltac:(lra) k). lra. rewrite k, sin_0 in h. lra. }
    destruct (Rle_lt_dec psi (PI / 2)); [ left | right ]; rewrite <- h.
    + symmetry. apply asin_sin. lra.
    + rewrite <- sin_PI_x, asin_sin by lra. ring.
  - intros [-> | ->]; [ | rewrite sin_PI_x ]; apply sin_asin; lra.
Qed.
(* ... so that psi of a motion stands still just there *)
Theorem eq_124_125 x y u w t psi A al d : spin x y u w -> 0 <= t -> 0 < nrm (u t) (w t) -> 0 < d -> 0 < A -> hyperbolic (x t) (y t) (u t) (w t) A al ->
  continuity_pt psi t -> - PI < psi t <= PI -> (forall s, t <= s < t + d -> angle (x s) (y s) (u s) (w s) (psi s)) ->
  rder psi t 0 <-> psi t = eq124_psi1 al \/ psi t = eq125_psi2 al.
Proof.
  intros S ht N Hd A0 Hy C Hp H. pose proof (eq_115 x y u w S t ht N psi A al d Hd A0 Hy C H) as D.
  assert (al0 : 0 < al). { destruct Hy as [e _]. unfold eq111_p in e. rewrite e in N. apply Rnot_le_lt. intros k.
    assert (sinh al <= 0). { rewrite <- sinh_0. destruct k as [k | ->]; [ left; now apply sinh_lt | lra ]. } nra. }
  rewrite <- (eq_124_125_zeros al (psi t) al0 Hp). split.
  - intros Z. apply (rder_unique _ _ _ _ D Z).
  - intros <-. exact D.
Qed.
(* (106), as printed and as corrected, of every motion: Work.v says it of these formulas *)
Theorem eq_106 m g mu Om x y u w s : turntable Om (mu * g) x y u w -> (forall t, 0 < t -> continuity_pt s t) ->
  (forall t, 0 <= t -> rder s t (nrm (u t) (w t))) -> forall t, 0 <= t ->
  right_turntable_constant m mu g Om (x t) (y t) (u t) (w t) (s t) = right_turntable_constant m mu g Om (x 0) (y 0) (u 0) (w 0) (s 0) /\
  (m <> 0 -> g <> 0 -> (eq106_constant m g Om (x t) (y t) (u t) (w t) (s t) = eq106_constant m g Om (x 0) (y 0) (u 0) (w 0) (s 0) <-> mu = 1 \/ s t = s 0)).
Proof.
  intros S cs ds t Ht.
  assert (k1 : forall r, right_turntable_constant m mu g Om (x r) (y r) (u r) (w r) (s r) = eq106 m Om x y u w s (m * (mu * g)) r) by (intros; unfold right_turntable_constant, eq106; field).
  assert (k2 : forall r, eq106_constant m g Om (x r) (y r) (u r) (w r) (s r) = eq106 m Om x y u w s (m * g) r) by (intros; unfold eq106_constant, eq106; field).
  rewrite !k1, !k2. split. now apply (eq106_right m g mu Om x y u w s S cs ds). intros. now apply (eq106_iff m g mu Om x y u w s S cs ds).
Qed.
(* s4-quasi-fixed-stability: (115) drives psi towards (124) and away from (125), from everywhere within a turn *)
Theorem s4_quasi_fixed_stability al psi : 0 < al ->
  (eq124_psi1 al < psi < eq125_psi2 al -> eq115_psi_rate al psi < 0) /\
  (eq125_psi2 al - 2 * PI < psi < eq124_psi1 al -> 0 < eq115_psi_rate al psi).
Proof.
  intros Ha. unfold eq115_psi_rate, eq124_psi1, eq125_psi2, coth, tanh. pose proof (cosh_pos (2 * al)) as c0.
  assert (z0 : 0 < sinh (2 * al)) by (rewrite <- sinh_0; apply sinh_lt; lra).
  assert (T1 : 0 < sinh (2 * al) / cosh (2 * al) < 1).
  { split. now apply Rdiv_lt_0_compat. apply Rlt_div_l; trivial. unfold sinh, cosh. pose proof (exp_pos (- (2 * al))). lra. }
  set (T := sinh (2 * al) / cosh (2 * al)) in *. replace (cosh (2 * al) / sinh (2 * al)) with (/ T) by (unfold T; field; lra).
  assert (q : T * / T = 1) by (field; lra). assert (q0 : 0 < / T) by (apply Rinv_0_lt_compat; lra).
  pose proof (p1_range T T1) as [[a1 a2] a3]. split; intros H.
  - pose proof (sin_above T T1 psi H). nra.
  - assert (sin psi < T); [ | nra ]. rewrite <- a3. destruct (Rle_lt_dec (- (PI / 2)) psi).
    + apply sin_increasing_1; lra.
    + replace (sin psi) with (sin (- PI - psi)). apply sin_increasing_1; lra.
      replace (- PI - psi) with (- (PI + psi)) by ring. rewrite sin_neg, Rplus_comm, neg_sin. ring.
Qed.
