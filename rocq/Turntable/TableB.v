(* (116) to (121): the other side, p > rho, of every motion on the turntable *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Pieces Periodic Fate Alpha TableAngle Formulas.
Open Scope R_scope.

(* (117), (118) *)
Definition hyperbolic_B x y u w B beta := nrm u w = eq117_p B beta /\ nrm x y = eq118_rho B beta.

Section Other.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation G t := (u t ^ 2 + w t ^ 2 - (x t ^ 2 + y t ^ 2)).
Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis G0 : 0 < G t.
Hypothesis r0 : 0 < rho t.

Lemma p_pos : 0 < p t.
Proof. pose proof (nrm_sq (u t) (w t)). pose proof (nrm_pos (u t) (w t)). pose proof (pow2_ge_0 (x t)). pose proof (pow2_ge_0 (y t)). nra. Qed.
Theorem eq_119_120 psi be d : 0 < d -> x t * u t + y t * w t = rho t * p t * cos psi ->
  (forall s, t <= s < t + d -> 0 < G s /\ hyperbolic_B (x s) (y s) (u s) (w s) (sqrt (G s)) (be s)) ->
  rder (fun s => sqrt (G s)) t (eq119_b_rate (be t)) /\ rder be t (eq120_beta_rate (sqrt (G t)) (be t) psi).
Proof.
  intros Hd e H. pose proof p_pos as p0. destruct (H t ltac:(lra)) as [_ [e1 e2]]. unfold eq117_p, eq118_rho, eq119_b_rate, eq120_beta_rate in *.
  assert (A0 : 0 < sqrt (G t)) by (apply sqrt_lt_R0; trivial).
  assert (DB : rder (fun s => sqrt (G s)) t (- (p t / sqrt (G t)))).
  { destruct (slip x y u w S t ht ltac:(lra)) as (X & Y & U & W). pose proof (nrm_sq (u t) (w t)) as n2. eapply rder_eq. apply rder_root; [ rd | exact G0 ]. cbv beta. simpl INR. simpl pred.
    set (a := sqrt (G t)) in *. set (n := p t) in *. inR. field_simplify_eq; [ | lra ]. ring [n2]. }
  assert (ec : cosh (be t) = p t / sqrt (G t)) by (rewrite e1; field; lra). assert (ez : sinh (be t) = rho t / sqrt (G t)) by (rewrite e2; field; lra).
  split. { rewrite ec. exact DB. }
  apply (rder_near be (fun s => arcsinh (rho s * / sqrt (G s))) t _ d Hd).
  - intros s Hs. destruct (H s Hs) as [k0 [_ k]]. unfold eq118_rho in k. rewrite k. replace (sqrt (G s) * sinh (be s) * / sqrt (G s)) with (sinh (be s)). apply arcsinh_sinh.
    field. assert (0 < sqrt (G s)) by (apply sqrt_lt_R0; lra). lra.
  - eapply rder_eq. apply (rder_comp (fun s => rho s * / sqrt (G s)) arcsinh).
    + apply (rder_mult (fun s => rho s) (fun s => / sqrt (G s))). apply (eq108 x y u w S t ht ltac:(lra) psi); [ lra | exact e ]. apply (rder_inv (fun s => sqrt (G s))); [ exact DB | lra ].
    + apply is_derive_Reals, derivable_pt_lim_arcsinh.
    + cbv beta. rewrite ez. replace (sqrt ((rho t * / sqrt (G t)) ^ 2 + 1)) with (p t / sqrt (G t)).
      * set (a := sqrt (G t)) in *. set (n := p t) in *. set (m := rho t) in *. field. lra.
      * symmetry. rewrite <- ec. rewrite <- (sqrt_pow2 (cosh (be t))) by (left; apply cosh_pos). f_equal. change (rho t * / sqrt (G t)) with (rho t / sqrt (G t)). rewrite <- ez.
        unfold sinh, cosh. assert (k : exp (be t) * exp (- be t) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). field_simplify. nra.
Qed.
Theorem eq_121 psi B be d : 0 < d -> 0 < B -> hyperbolic_B (x t) (y t) (u t) (w t) B be -> continuity_pt psi t ->
  (forall s, t <= s < t + d -> angle (x s) (y s) (u s) (w s) (psi s)) -> rder psi t (eq121_psi_rate be (psi t)).
Proof.
  intros Hd B0 [e1 e2] C H. unfold eq117_p, eq118_rho in *. pose proof p_pos as p0. pose proof (cosh_pos be) as c0. 
  assert (z0 : 0 < sinh be). { rewrite e2 in r0. nra. }
  eapply rder_eq. apply (eq_109 x y u w S t ht p0 psi d); trivial. unfold eq109_psi_rate, eq121_psi_rate, coth. rewrite e1, e2.
  replace (cosh (2 * be)) with (cosh be ^ 2 + sinh be ^ 2). replace (sinh (2 * be)) with (2 * sinh be * cosh be). field. lra.
  - unfold sinh, cosh. replace (2 * be) with (be + be) by ring. rewrite Ropp_plus_distr, !exp_plus. field.
  - unfold sinh, cosh. replace (2 * be) with (be + be) by ring. rewrite Ropp_plus_distr, !exp_plus. field.
Qed.
End Other.
