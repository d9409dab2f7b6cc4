(* The angle psi and the hyperbolic parameters as functions of the time: their rates, for (100) to (121), and motions that have them *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion TableLaws TableMotions Formulas.
Open Scope R_scope.

(* (111), (112) *)
Definition hyperbolic x y u w A alpha := nrm u w = eq111_p A alpha /\ nrm x y = eq112_rho A alpha.
(* (117), (118) *)
Definition hyperbolic_B x y u w B beta := nrm u w = eq117_p B beta /\ nrm x y = eq118_rho B beta.

Lemma amplitude A a r q : r = A * cosh a -> q = A * sinh a -> 0 <= r -> A = sqrt (r ^ 2 - q ^ 2).
Proof.
  intros -> -> H. pose proof (cosh_pos a). replace ((A * cosh a) ^ 2 - (A * sinh a) ^ 2) with (A ^ 2) by (rewrite !Rpow_mult_distr, cosh2; ring).
    symmetry. apply sqrt_pow2. nra.
Qed.
Lemma hyperbolic_exists r q : 0 <= q < r -> let A := sqrt (r ^ 2 - q ^ 2) in q = A * sinh (arcsinh (q / A)) /\ r = A * cosh (arcsinh (q / A)).
Proof.
  intros H A. assert (A0 : 0 < A) by (apply sqrt_lt_R0; nra). assert (AA : A ^ 2 = r ^ 2 - q ^ 2) by (unfold A; rewrite <- Rsqr_pow2; apply Rsqr_sqrt;
    nra).
  rewrite sinh_arcsinh. split. field; lra. pose proof (cosh2 (arcsinh (q / A))) as e. rewrite sinh_arcsinh in e.
    pose proof (cosh_pos (arcsinh (q / A))) as c0. set (c := cosh _) in *.
  assert (k : (A * c) ^ 2 = r ^ 2). { rewrite Rpow_mult_distr, e. transitivity (q ^ 2 + A ^ 2). field; lra. lra. }
  apply Rsqr_inj; [ lra | nra | rewrite !Rsqr_pow2; lra ].
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
  assert (e : z ^ 2 = 1 - c ^ 2) by (unfold z, c; pose proof (sin2_cos2 (psi t)); unfold Rsqr in *; lra). pose proof (nrm_pos (x t) (y t)).
  set (f s := (- (- rho s * sin (psi s)) * c - rho s * cos (psi s) * z) * / rho s).
  assert (D : rder f t (eq109_psi_rate (p t) (rho t) (psi t))).
  { eapply rder_eq. apply (rder_mult (fun s => - (- rho s * sin (psi s)) * c - rho s * cos (psi s) * z) (fun s => / rho s));
    [ | apply (rder_inv (fun s => rho s)); [ exact DR | exact r0 ] ].
    apply (rder_minus (fun s => - (- rho s * sin (psi s)) * c) (fun s => rho s * cos (psi s) * z));
    [ apply (rder_mult (fun s => - (- rho s * sin (psi s))) (fun _ => c)); [ apply (rder_opp (fun s => - rho s * sin (psi s))), DL | rd ]
    | apply (rder_mult (fun s => rho s * cos (psi s)) (fun _ => z)); [ exact DX | rd ] ].
    cbv beta. fold c z. unfold eq109_psi_rate. fold z. set (n := p t) in *. set (m := rho t) in *. field_simplify_eq; [ | lra ]. ring [e]. }
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
Variable t : R.
Hypothesis ht : 0 <= t.
Lemma E_is s : E s = rho s ^ 2 - p s ^ 2.
Proof. rewrite !nrm_sq. ring. Qed.
Lemma A_rate : p t < rho t -> (forall s, t <= s -> hyperbolic (x s) (y s) (u s) (w s) (A s) (al s)) -> (forall s, t <= s -> 0 < A s) /\
  rder A t (sinh (al t)).
Proof.
  intros H K. assert (AE : forall s, t <= s -> sqrt (E s) = A s).
  { intros s Hs. destruct (K s Hs) as [k1 k2]. rewrite E_is. symmetry. apply (amplitude _ (al s)); trivial. apply nrm_pos. }
  assert (E0 : forall s, t <= s -> 0 < E s). { intros s Hs. pose proof (A_never_falls x y u w S t s ltac:(lra)). rewrite !E_is in *.
    pose proof (nrm_pos (u t) (w t)). nra. }
  assert (A0 : forall s, t <= s -> 0 < A s) by (intros s Hs; rewrite <- AE by trivial; now apply sqrt_lt_R0, E0). split; trivial.
  apply (rder_near A (fun s => sqrt (E s)) t _ 1 Rlt_0_1). { intros; apply AE; lra. }
  eapply rder_eq. apply (rder_root (fun s => E s)); [ apply (E_rate x y u w S t ht) | apply E0; lra ]. specialize (A0 t ltac:(lra)). cbv beta.
    rewrite AE by lra.
  destruct (K t ltac:(lra)) as [-> _]. unfold eq111_p. field. lra.
Qed.
Lemma alpha_rate : p t < rho t -> p t <> 0 -> (forall s, t <= s -> hyperbolic (x s) (y s) (u s) (w s) (A s) (al s)) ->
  rder al t (eq114_alpha_rate (A t) (al t) (psi t)).
Proof.
  intros H N K. destruct (A_rate H K) as [A0 DA]. destruct (psi_rates x y u w psi S P t ht N) as (DP & _). specialize (A0 t (Rle_refl t)) as a0.
  eapply rder_eq. eapply (rder_alpha (fun s => p s) A al t 1 _ _ Rlt_0_1); [ | exact DP | exact DA ]. { intros s Hs. split. apply A0; lra.
    apply K; lra. }
  destruct (K t (Rle_refl t)) as [_ ->]. pose proof (cosh_pos (al t)). pose proof (cosh2 (al t)) as e. unfold eq114_alpha_rate, eq112_rho.
    field_simplify_eq; [ | lra ]. ring [e].
Qed.
Lemma B_rates : rho t < p t -> (forall s, t <= s -> rho s < p s -> hyperbolic_B (x s) (y s) (u s) (w s) (A s) (al s)) ->
  0 < A t /\ rder A t (eq119_b_rate (al t)) /\ (rho t <> 0 -> rder al t (eq120_beta_rate (A t) (al t) (psi t))).
Proof.
  intros H K. pose proof (nrm_pos (x t) (y t)) as m0. assert (D : rder (fun s => - E s) t (- (2 * p t))) by (apply (rder_opp (fun s => E s)), (E_rate
    x y u w S t ht)).
  assert (near : exists d, 0 < d /\ forall s, t <= s < t + d -> 0 < - E s).
  { assert (0 < - E t) by (rewrite E_is; nra). destruct (right_pos _ _ _ D H0) as (d & d0 & Hd). exists d. split; trivial. intros s Hs.
    destruct (Req_dec s t) as [-> | ne]; trivial. apply Hd; lra. }
  destruct near as (d & d0 & Hd).
  assert (fast : forall s, t <= s < t + d -> rho s < p s). { intros s Hs. specialize (Hd s Hs). rewrite E_is in Hd. pose proof (nrm_pos (x s) (y s)).
    pose proof (nrm_pos (u s) (w s)). nra. }
  assert (AE : forall s, t <= s < t + d -> sqrt (- E s) = A s).
  { intros s Hs. destruct (K s ltac:(lra) (fast s Hs)) as [k1 k2]. replace (- E s) with (p s ^ 2 - rho s ^ 2) by (rewrite E_is; ring). symmetry.
    apply (amplitude _ (al s)); trivial. apply nrm_pos. }
  assert (A0 : forall s, t <= s < t + d -> 0 < A s) by (intros s Hs; rewrite <- AE by trivial; now apply sqrt_lt_R0, Hd).
  assert (a0 : 0 < A t) by (apply A0; lra). destruct (K t ltac:(lra) H) as [k1 k2]. unfold eq117_p, eq118_rho in *.
    pose proof (cosh_pos (al t)) as c0.
  assert (DA : rder A t (- cosh (al t))).
  { apply (rder_near A (fun s => sqrt (- E s)) t _ d d0). { intros; apply AE; lra. } eapply rder_eq.
    apply (rder_root (fun s => - E s)); [ exact D | apply Hd; lra ].
    cbv beta. rewrite AE by lra. rewrite k1. field. lra. }
  split; trivial. split; trivial. intros r0. eapply rder_eq. eapply (rder_alpha (fun s => rho s) A al t d _ _ d0); [ | | exact DA ].
  { intros s Hs. split. now apply A0. apply K; [ lra | now apply fast ]. } { apply (rho_rate x y u w psi S P t ht); lra. }
  rewrite k1. unfold eq120_beta_rate. field. lra.
Qed.
End Hyperbolic.
(* (115) and (121) are (109) *)
Lemma psi_rate_hyperbolic a : sinh a <> 0 -> sinh a / cosh a + cosh a / sinh a = 2 * coth (2 * a).
Proof. intros H. pose proof (cosh_pos a). unfold coth. rewrite cosh_double, sinh_double. field_simplify_eq; [ | lra ]. ring [(cosh2 a)]. Qed.

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
    apply (rder_mult d (fun t => / (m t + c t))); [ exact D2 | apply (rder_inv (fun t => m t + c t)); [ exact D | exact D0 ] ].
Qed.
Lemma with_A x y u w : spin x y u w -> nrm (u 0) (w 0) < nrm (x 0) (y 0) -> exists A al, forall t, 0 <= t ->
  hyperbolic (x t) (y t) (u t) (w t) (A t) (al t).
Proof.
  intros S H. set (r t := nrm (x t) (y t)). set (q t := nrm (u t) (w t)). exists (fun t => sqrt (r t ^ 2 - q t ^ 2)), (fun t => arcsinh (q t / sqrt (r
    t ^ 2 - q t ^ 2))). intros t Ht.
  apply (hyperbolic_exists (r t) (q t)). pose proof (A_never_falls x y u w S 0 t ltac:(lra)) as M. rewrite <- !nrm_sq in M.
  pose proof (nrm_pos (x t) (y t)). pose proof (nrm_pos (u t) (w t)). pose proof (nrm_pos (u 0) (w 0)). unfold r, q. split; [ trivial | nra ].
Qed.
Lemma with_B (x y u w : R -> R) : exists B be, forall t, nrm (x t) (y t) < nrm (u t) (w t) -> hyperbolic_B (x t) (y t) (u t) (w t) (B t) (be t).
Proof.
  set (r t := nrm (u t) (w t)). set (q t := nrm (x t) (y t)). exists (fun t => sqrt (r t ^ 2 - q t ^ 2)), (fun t => arcsinh (q t / sqrt (r t ^ 2 - q
    t ^ 2))). intros t H.
  destruct (hyperbolic_exists (r t) (q t)) as [h1 h2]. { pose proof (nrm_pos (x t) (y t)). unfold r, q in *. lra. } split; trivial.
Qed.
