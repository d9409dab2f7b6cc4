(* The angle psi and the hyperbolic parameters as functions of the time: their rates, for (100) to (121), and motions that have them *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion TableLaws TableMotions Formulas.
Open Scope R_scope.

(* (111), (112); dimensionless. «$\lvert(u,w)\rvert=A\sinh alpha$ and $\lvert(x,y)\rvert=A\cosh alpha$» *)
Definition hyperbolic x y u w A alpha := nrm u w = eq111_p A alpha /\ nrm x y = eq112_rho A alpha.
(* (117), (118); dimensionless. «$\lvert(u,w)\rvert=B\cosh beta$ and $\lvert(x,y)\rvert=B\sinh beta$» *)
Definition hyperbolic_B x y u w B beta := nrm u w = eq117_p B beta /\ nrm x y = eq118_rho B beta.

Lemma hyperbolic_exists r q : 0 <= q < r -> let A := sqrt (r ^ 2 - q ^ 2) in q = A * sinh (arcsinh (q / A)) /\ r = A * cosh (arcsinh (q / A)).
Proof.
  intros H A. assert (A0 : 0 < A) by (apply sqrt_lt_R0; nra). assert (AA : A ^ 2 = r ^ 2 - q ^ 2) by (apply pow2_sqrt; nra).
  set (a := arcsinh _). assert (e : q = A * sinh a) by (unfold a; rewrite sinh_arcsinh; field; lra). split; trivial. pose proof (cosh_pos a).
  apply Rsqr_inj; [ lra | nra | ]. rewrite !Rsqr_pow2, Rpow_mult_distr, cosh2. rewrite e in AA at 1. lra.
Qed.
(* alpha, where f = A sinh alpha *)
Lemma rder_alpha f A al t d f' A' : 0 < d -> (forall s, t <= s < t + d -> 0 < A s /\ f s = A s * sinh (al s)) -> rder f t f' -> rder A t A' ->
  rder al t ((f' - A' * sinh (al t)) / (A t * cosh (al t))).
Proof.
  intros Hd H F DA. destruct (H t ltac:(lra)) as [A0 e]. pose proof (cosh_pos (al t)) as c0.
  apply (rder_near al (fun s => arcsinh (f s * / A s)) t _ d Hd). { intros s Hs. destruct (H s Hs) as [As ->].
    replace (A s * sinh (al s) * / A s) with (sinh (al s)) by (field; lra). apply arcsinh_sinh. }
  eapply rder_eq. apply (rder_comp (fun s => f s * / A s) arcsinh); [ apply (rder_mult f (fun s => / A s)); [ exact F | apply rder_inv;
    [ exact DA | lra ] ] | apply is_derive_Reals, derivable_pt_lim_arcsinh ].
  rewrite e. replace (A t * sinh (al t) * / A t) with (sinh (al t)) by (field; lra). rewrite (Rplus_comm _ 1), <- cosh2, sqrt_pow2 by lra. field. lra.
Qed.

(* q = A sinh a and r = A cosh a, from t on while q < r: A and a have rates where r^2 - q^2 and q have *)
Lemma hyperbolic_rates r q G A a t g : (forall s, 0 <= q s /\ 0 <= r s /\ G s = r s ^ 2 - q s ^ 2) -> rder G t g -> q t < r t ->
  (forall s, t <= s -> q s < r s -> q s = A s * sinh (a s) /\ r s = A s * cosh (a s)) ->
  0 < A t /\ rder A t (g / (2 * A t)) /\ forall q', rder q t q' -> rder a t ((q' - g / (2 * A t) * sinh (a t)) / (A t * cosh (a t))).
Proof.
  intros B D H K. assert (G0 : 0 < G t) by (destruct (B t) as (? & ? & ->); nra). destruct (right_pos _ _ _ D G0) as (d & d0 & Hd).
  assert (N : forall s, t <= s < t + d -> 0 < A s /\ sqrt (G s) = A s /\ q s = A s * sinh (a s)).
  { intros s Hs. assert (0 < G s) by (destruct (Req_dec s t) as [-> | ne]; trivial; apply Hd; lra). destruct (B s) as (b1 & b2 & b3).
    destruct (K s ltac:(lra) ltac:(nra)) as [k1 k2]. pose proof (cosh_pos (a s)).
    assert (e : G s = A s ^ 2) by (rewrite b3, k1, k2, !Rpow_mult_distr, cosh2; ring).
    assert (0 < A s) by nra. repeat split; trivial. rewrite e. apply sqrt_pow2. lra. }
  destruct (N t ltac:(lra)) as (A0 & e & _). assert (DA : rder A t (g / (2 * A t))).
  { apply (rder_near A (fun s => sqrt (G s)) t _ d d0). { intros s Hs. destruct (N s Hs) as (? & ? & ?). trivial. } eapply rder_eq.
  apply (rder_root G t g D G0). rewrite e. field. lra. }
  split; trivial. split; trivial. intros q' Q. apply (rder_alpha q A a t d q' _ d0); trivial. intros s Hs.
  destruct (N s Hs) as (? & ? & ?). now split.
Qed.

Section Angles.
Variables x y u w psi : R -> R.
Hypothesis S : spin x y u w.
Hypothesis P : forall t, 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).

Lemma xi_psi t : 0 <= t -> p t <> 0 -> xi t = rho t * cos (psi t) /\ ell t = - rho t * sin (psi t).
Proof. intros Ht N. destruct (proj1 (angle_iff _ _ _ _ _) (P t Ht)) as [e1 e2]. rewrite e1, e2. split; field; trivial. Qed.

Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis N : p t <> 0.
Lemma psi_rates : rder (fun t => p t) t (rho t * cos (psi t) - 1) /\
  rder (fun s => - rho s * sin (psi s)) t (- (rho t * cos (psi t) * (2 * p t + - rho t * sin (psi t)) / p t)) /\
  rder (fun s => rho s * cos (psi s)) t ((p t + - rho t * sin (psi t)) ^ 2 / p t).
Proof.
  destruct (xi_psi t ht N) as [ex el]. destruct (slips_on x y u w S t ht N) as (d & d0 & Hd). split. { rewrite <- ex. now apply (dp x y u w S).
    } split.
  - apply (rder_near _ (fun s => ell s) t _ d d0). { intros s Hs. apply xi_psi; [ lra | ]. specialize (Hd s Hs). lra. }
    eapply rder_eq. apply (eq100 x y u w S t ht N). rewrite <- ex, <- el. field. exact N.
  - apply (rder_near _ (fun s => xi s) t _ d d0). { intros s Hs. apply xi_psi; [ lra | ]. specialize (Hd s Hs). lra. }
    eapply rder_eq. apply (eq101 x y u w S t ht N). now rewrite <- el.
Qed.
Hypothesis r0 : rho t <> 0.
Lemma rho_rate : rder (fun t => rho t) t (p t * cos (psi t)).
Proof. eapply rder_eq. apply (rder_rho x y u w S t ht N r0). destruct (proj1 (angle_iff _ _ _ _ _) (P t ht)) as [e1 _]. rewrite e1. field. exact r0.
  Qed.
(* near t, psi is psi t + arcsin (sin psi cos (psi t) - cos psi sin (psi t)) *)
Lemma psi_rate : right_continuous psi t -> rder psi t (eq109_psi_rate (p t) (rho t) (psi t)).
Proof.
  intros C. pose proof psi_rates as (_ & DL & DX). pose proof rho_rate as DR. set (c := cos (psi t)) in *. set (z := sin (psi t)) in *.
  assert (e : z ^ 2 = 1 - c ^ 2) by (unfold z, c; pose proof (unit_circle (psi t)); lra). pose proof (nrm_pos (x t) (y t)).
  set (f s := (- (- rho s * sin (psi s)) * c - rho s * cos (psi s) * z) * / rho s).
  assert (D : rder f t (eq109_psi_rate (p t) (rho t) (psi t))).
  { unfold f. eapply rder_eq. rds. exact r0. cbv beta. fold c z. unfold eq109_psi_rate. fold z. set (n := p t) in *. set (m := rho t) in *. field_simplify_eq; [ | lra ]. ring [e]. }
  assert (ft : f t = 0) by (unfold f; fold c z; field; exact r0).
  pose proof PI_RGT_0. destruct (C (PI / 2)) as (d1 & d10 & H1). lra. destruct (right_pos _ _ _ DR) as (d2 & d20 & H2). lra.
  apply (rder_near psi (fun s => psi t + asin (f s)) t _ (Rmin d1 d2)). now apply Rmin_pos.
  - intros s Hs. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). specialize (H1 s ltac:(lra)). apply Rabs_def2 in H1.
    assert (rs : rho s <> 0). { destruct (Req_dec s t) as [-> | ne]; trivial. specialize (H2 s ltac:(lra)). lra. }
    replace (f s) with (sin (psi s - psi t)) by (rewrite sin_minus; fold c z; unfold f; field; exact rs). rewrite asin_sin by lra. ring.
  - eapply rder_eq. apply (rder_plus (fun _ => psi t)); [ rd | ]. apply (rder_comp f asin t _ 1 D). 2: ring.
    rewrite ft. apply is_derive_Reals. assert (b : -1 < 0 < 1) by lra. apply (derive_pt_eq_1 _ _ _ (derivable_pt_asin 0 b)). rewrite derive_pt_asin.
    replace (1 - 0²) with 1 by (unfold Rsqr; ring). rewrite sqrt_1. field.
Qed.
End Angles.

Section Hyperbolic.
Variables x y u w psi A al : R -> R.
Hypothesis S : spin x y u w.
Hypothesis P : forall t, 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Lemma sizes s : 0 <= p s /\ 0 <= rho s /\ E s = rho s ^ 2 - p s ^ 2.
Proof. rewrite !nrm_sq. repeat split; try apply nrm_pos. Qed.
Lemma inner_rates t (ht : 0 <= t) : p t < rho t -> (forall s, t <= s -> hyperbolic (x s) (y s) (u s) (w s) (A s) (al s)) -> 0 < A t /\ rder A t (sinh (al t)) /\
  forall p', rder (fun s => p s) t p' -> rder al t ((p' - sinh (al t) * sinh (al t)) / (A t * cosh (al t))).
Proof.
  intros H K. destruct (hyperbolic_rates (fun s => rho s) (fun s => p s) (fun s => E s) A al t _ sizes (E_rate x y u w S t ht) H) as (A0 & DA & Da).
  { intros s Hs _. now apply K. } replace (2 * p t / (2 * A t)) with (sinh (al t)) in *; auto.
  destruct (K t (Rle_refl t)) as [-> _]. unfold eq111_p. field. lra.
Qed.
Lemma A_rate t (ht : 0 <= t) : p t < rho t -> (forall s, t <= s -> hyperbolic (x s) (y s) (u s) (w s) (A s) (al s)) ->
  (forall s, t <= s -> 0 < A s) /\ rder A t (sinh (al t)).
Proof.
  intros H K. split. 2: now apply inner_rates. intros s Hs. apply (inner_rates s ltac:(lra)). 2: intros; apply K; lra.
  pose proof (A_never_falls x y u w S t s ltac:(lra)). destruct (sizes t) as (? & ? & e). destruct (sizes s) as (? & ? & e'). rewrite e, e' in *. nra.
Qed.
Lemma alpha_rate t (ht : 0 <= t) : p t < rho t -> p t <> 0 -> (forall s, t <= s -> hyperbolic (x s) (y s) (u s) (w s) (A s) (al s)) ->
  rder al t (eq114_alpha_rate (A t) (al t) (psi t)).
Proof.
  intros H N K. destruct (inner_rates t ht H K) as (A0 & _ & D). destruct (psi_rates x y u w psi S P t ht N) as (DP & _).
  destruct (K t (Rle_refl t)) as [_ k]. pose proof (cosh_pos (al t)). eapply rder_eq. apply (D _ DP). rewrite k. unfold eq114_alpha_rate, eq112_rho.
  field_simplify_eq; [ | lra ]. ring [(cosh2 (al t))].
Qed.
Lemma outer_rates t (ht : 0 <= t) : rho t < p t -> (forall s, t <= s -> rho s < p s -> hyperbolic_B (x s) (y s) (u s) (w s) (A s) (al s)) ->
  0 < A t /\ rder A t (eq119_b_rate (al t)) /\
  forall r', rder (fun s => rho s) t r' -> rder al t ((r' - eq119_b_rate (al t) * sinh (al t)) / (A t * cosh (al t))).
Proof.
  intros H K. destruct (hyperbolic_rates (fun s => p s) (fun s => rho s) (fun s => - E s) A al t (- (2 * p t))) as (A0 & DA & Da); trivial.
  { intros s. destruct (sizes s) as (? & ? & ->). repeat split; trivial. ring. } { apply (rder_opp (fun s => E s)), (E_rate x y u w S t ht). }
  { intros s Hs h. destruct (K s Hs h). auto. } replace (- (2 * p t) / (2 * A t)) with (eq119_b_rate (al t)) in *; auto.
  destruct (K t (Rle_refl t) H) as [-> _]. unfold eq119_b_rate, eq117_p. field. lra.
Qed.
End Hyperbolic.
(* (115) and (121) are (109) *)
Lemma psi_rate_hyperbolic A a psi : A <> 0 -> sinh a <> 0 -> eq109_psi_rate (A * sinh a) (A * cosh a) psi = eq115_psi_rate a psi /\
  eq109_psi_rate (A * cosh a) (A * sinh a) psi = eq121_psi_rate a psi.
Proof.
  intros n z. pose proof (cosh_pos a). unfold eq109_psi_rate, eq115_psi_rate, eq121_psi_rate, coth. rewrite cosh_double, sinh_double.
  split; (field_simplify_eq; [ | lra ]); ring [(cosh2 a)].
Qed.

(* ---- motions that have all this: every start, its angle, A and alpha, B and beta ---- *)
Lemma motion_with_angle x0 y0 u0 w0 : exists x y u w psi, spin x y u w /\ (forall t, 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t)) /\
  (x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0) /\ (0 < nrm x0 y0 -> 0 < nrm u0 w0 -> let c := x0 * u0 + y0 * w0 in let m := nrm x0 y0 * nrm u0 w0 in
  m + c <> 0 -> right_continuous psi 0 /\ psi 0 = half_angle c (y0 * u0 - x0 * w0) m).
Proof.
  destruct (table_exists x0 y0 u0 w0) as (x & y & u & w & S & e1 & e2 & e3 & e4). exists x, y, u, w, (fun t => proj1_sig (angle_exists (x t) (y t) (u
    t) (w t))). split; trivial.
  set (c t := x t * u t + y t * w t). set (d t := y t * u t - x t * w t). set (m t := nrm (x t) (y t) * nrm (u t) (w t)).
  assert (H : forall t, let psi := proj1_sig (angle_exists (x t) (y t) (u t) (w t)) in position_angle (x t) (y t) (u t) (w t) psi /\
    (m t + c t <> 0 -> psi = 2 * atan (d t * / (m t + c t)))) by (intros t psi; apply (proj2_sig (angle_exists (x t) (y t) (u t) (w t)))).
  split. { intros t _. apply H. } split; auto. rewrite <- e1, <- e2, <- e3, <- e4. intros r0 p0. cbv zeta.
    change (m 0 + c 0 <> 0 -> right_continuous (fun t => proj1_sig (angle_exists (x t) (y t) (u t) (w t))) 0 /\
    proj1_sig (angle_exists (x 0) (y 0) (u 0) (w 0)) = half_angle (c 0) (d 0) (m 0)).
  intros D0. split. 2: now apply (H 0). destruct (s_law _ _ _ _ S 0 (Rle_refl 0)) as (X & Y & fx & fy & _ & U & W).
  assert (D : exists l, rder (fun t => m t + c t) 0 l) by (eexists; unfold m, c; rd; lra). destruct D as [l D].
  assert (D2 : exists l, rder d 0 l) by (eexists; unfold d; rd). destruct D2 as [l2 D2].
  destruct (right_pos (fun t => (m t + c t) ^ 2) 0 _ (rder_pow _ 2 _ _ D) ltac:(now apply pow2_gt_0)) as (d1 & d0 & Hd).
  eapply rder_right_continuous, (rder_near _ (fun t => 2 * atan (d t * / (m t + c t))) 0 _ d1 d0).
  - intros s Hs. symmetry. apply (H s). destruct (Req_dec s 0) as [-> | ne]; trivial. specialize (Hd s ltac:(lra)). intros z. rewrite z in Hd. lra.
  - apply (rder_mult (fun _ => 2)); [ rd | ]. apply (rder_comp (fun t => d t * / (m t + c t)) atan);
    [ | apply is_derive_Reals, derivable_pt_lim_atan ].
    apply (rder_mult d); [ exact D2 | apply (rder_inv _ _ _ D D0) ].
Qed.
(* A and alpha, or B and beta, of two sizes *)
Lemma hyperbolic_pair (q r : R -> R) : exists A a, forall t, 0 <= q t < r t -> q t = A t * sinh (a t) /\ r t = A t * cosh (a t).
Proof. exists (fun t => sqrt (r t ^ 2 - q t ^ 2)), (fun t => arcsinh (q t / sqrt (r t ^ 2 - q t ^ 2))). intros t. apply hyperbolic_exists. Qed.
Lemma with_A x y u w : spin x y u w -> nrm (u 0) (w 0) < nrm (x 0) (y 0) -> exists A al, forall t, 0 <= t ->
  hyperbolic (x t) (y t) (u t) (w t) (A t) (al t).
Proof.
  intros S H. destruct (hyperbolic_pair (fun t => nrm (u t) (w t)) (fun t => nrm (x t) (y t))) as (A & a & K). exists A, a. intros t Ht. apply (K t).
  pose proof (A_never_falls x y u w S 0 t ltac:(lra)) as M. rewrite <- !nrm_sq in M.
  pose proof (nrm_pos (x t) (y t)). pose proof (nrm_pos (u t) (w t)). pose proof (nrm_pos (u 0) (w 0)). split; [ trivial | nra ].
Qed.
Lemma with_B (x y u w : R -> R) : exists B be, forall t, nrm (x t) (y t) < nrm (u t) (w t) -> hyperbolic_B (x t) (y t) (u t) (w t) (B t) (be t).
Proof.
  destruct (hyperbolic_pair (fun t => nrm (x t) (y t)) (fun t => nrm (u t) (w t))) as (A & a & K). exists A, a. intros t H.
  destruct (K t) as [k1 k2]; [ split; [ apply nrm_pos | exact H ] | now split ].
Qed.
