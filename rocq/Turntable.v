(* Section 4 up to (125): a particle that slips or rests on a turning table, in the paper's order *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas TableMotions Lab TableAngle QuasiFixed.
From Slipbook Require Export TableLaws.
Open Scope R_scope.

(* a motion from the start given, with its angle, at the moment 0 *)
Ltac from x0 y0 u0 w0 := destruct (motion_with_angle x0 y0 u0 w0) as (x & y & u & w & psi & S & P & (e1 & e2 & e3 & e4) & Q);
  pose proof (Rle_refl 0) as now.
Ltac start := repeat match goal with e : ?f 0 = _ |- context [?f 0] => rewrite e end; repeat first [ rewrite nrm_x0 by lra | rewrite nrm_0y by lra ].

(* ---- the law and its units ---- *)
(* (86): friction alone accelerates a particle in the laboratory; seen from the table its law is that of (86), rests included, and while it slides
  just (86) *)
Theorem eq_86 Om mu g X Y U W x y u w : 0 <= mu * g -> laboratory Om (mu * g) X Y U W -> same_particle Om X Y U W x y u w ->
  turntable Om (mu * g) x y u w /\ forall t, 0 <= t -> nrm (u t) (w t) <> 0 ->
  rder u t (eq86_acceleration_1 Om mu g (x t) (y t) (u t) (w t)) /\ rder w t (eq86_acceleration_2 Om mu g (x t) (y t) (u t) (w t)).
Proof.
  intros Hk S T. apply seen_lab in S. apply (turned Om _ _ _ _ _ _ _ _ _ _ _ T) in S. rewrite Rplus_0_l in S. apply seen_table in S. split; trivial.
    intros t Ht N.
  destruct (slides _ _ _ _ _ _ t Hk S Ht N) as [DU DW]. unfold eq86_acceleration_1, eq86_acceleration_2. fold (nrm (u t) (w t)).
  split; (eapply rder_eq; [ eassumption | field; exact N ]).
Qed.
(* and what moves on the table by that law moves in the laboratory by friction alone *)
Theorem eq_86__back Om mu g X Y U W x y u w : turntable Om (mu * g) x y u w -> same_particle Om X Y U W x y u w -> laboratory Om (mu * g) X Y U W.
Proof.
  intros S T. apply seen_table in S. apply same_back in T. apply (turned (- Om) _ _ _ _ _ _ _ _ _ _ _ T) in S. rewrite Rplus_opp_r in S.
    now apply seen_lab in S.
Qed.
Lemma eq_86__occurs : ltac:(occurs eq_86).
Proof.
  intros H. destruct (turntable_exists 2 (3 * 10) 1 0 1 5) as (x & y & u & w & S & _); try lra.
  assert (T : exists X Y U W, same_particle 2 X Y U W x y u w) by (do 4 eexists; apply same_back; intros t; repeat split).
  destruct T as (X & Y & U & W & T). exact (H 2 3 10 _ _ _ _ x y u w ltac:(lra) (eq_86__back _ _ _ _ _ _ _ _ _ _ _ S T) T).
Qed.
Lemma eq_86__back__occurs : ltac:(occurs eq_86__back).
Proof. intros H. apply eq_86__occurs. intros Om mu g X Y U W x y u w Hk S T. now apply (H Om mu g X Y U W x y u w);
  [ apply (eq_86 Om mu g X Y U W) | ]. Qed.

(* (89): in the units of (87) and (88) every motion by (86) is one by (89), rests included, for all Omega and mu g > 0 *)
Theorem eq_89 Om mu g x y u w rx ry pu pw : 0 < Om -> 0 < mu * g -> turntable Om (mu * g) x y u w ->
  in_units Om mu g x y u w rx ry pu pw ->
  spin rx ry pu pw /\ forall tau, 0 <= tau -> nrm (pu tau) (pw tau) <> 0 ->
  rder pu tau (eq89_acceleration_1 (rx tau) (ry tau) (pu tau) (pw tau)) /\ rder pw tau (eq89_acceleration_2 (rx tau) (ry tau) (pu tau) (pw tau)).
Proof.
  intros HO Hk S T. apply (units _ _ _ _ _ _ _ _ _ _ _ HO Hk T) in S. split; trivial. intros tau Ht N.
  destruct (slip _ _ _ _ S tau Ht N) as (_ & _ & DU & DW). unfold eq89_acceleration_1, eq89_acceleration_2. fold (nrm (pu tau) (pw tau)).
  split; (eapply rder_eq; [ eassumption | field; exact N ]).
Qed.
(* and back *)
Theorem eq_89__back Om mu g x y u w rx ry pu pw : 0 < Om -> 0 < mu * g -> spin rx ry pu pw ->
  in_units Om mu g x y u w rx ry pu pw -> turntable Om (mu * g) x y u w.
Proof. intros HO Hk S T. now apply (units _ _ _ _ _ _ _ _ _ _ _ HO Hk T) in S. Qed.
(* every motion by (89) is one by (86) in such units, for every Omega and mu g > 0 *)
Lemma units_exist Om mu g rx ry pu pw : 0 < Om -> 0 < mu * g -> let k := mu * g in in_units Om mu g (fun t => k / Om ^ 2 * rx (Om * t))
  (fun t => k / Om ^ 2 * ry (Om * t)) (fun t => k / Om * pu (Om * t)) (fun t => k / Om * pw (Om * t)) rx ry pu pw.
Proof. intros HO Hk k t. unfold eq88_time, eq87_position_1, eq87_position_2. fold k in Hk |- *. repeat split; field; lra. Qed.
Ltac at_units := intros H; destruct (table_exists 1 0 1 5) as (rx & ry & pu & pw & S & _);
  pose proof (units_exist 2 3 10 rx ry pu pw ltac:(lra) ltac:(lra)) as T.
Lemma eq_89__occurs : ltac:(occurs eq_89).
Proof. at_units. refine (H 2 3 10 _ _ _ _ rx ry pu pw _ _ (eq_89__back _ _ _ _ _ _ _ _ _ _ _ _ _ S T) T); lra. Qed.
Lemma eq_89__back__occurs : ltac:(occurs eq_89__back).
Proof. at_units. refine (H 2 3 10 _ _ _ _ rx ry pu pw _ _ S T); lra. Qed.

(* A solution for Omega, mirrored, is one for - Omega, and back; so Omega > 0 is no loss. (86) says so, too *)
Theorem s4_mirror Om mu g x y u w : (turntable Om (mu * g) x y u w <-> turntable (- Om) (mu * g) x (fun t => - y t) u (fun t => - w t)) /\
  forall a b c d, eq86_acceleration_1 (- Om) mu g a (- b) c (- d) = eq86_acceleration_1 Om mu g a b c d /\
    eq86_acceleration_2 (- Om) mu g a (- b) c (- d) = - eq86_acceleration_2 Om mu g a b c d.
Proof.
  split. split; [ apply mirrored | ].
  - intros S. apply mirrored in S. rewrite Ropp_involutive in S.
    assert (e : forall f : R -> R, (fun t => - - f t) = f) by (intros f; extensionality t; apply Ropp_involutive). now rewrite !e in S.
  - intros a b c d. unfold eq86_acceleration_1, eq86_acceleration_2. replace ((- d) ^ 2) with (d ^ 2) by ring. split; ring.
Qed.

Section Motions.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Variable t : R.
Hypothesis ht : 0 <= t.
Section Projections.
Variables ax ay : R.
Hypothesis U : rder u t ax.
Hypothesis W : rder w t ay.
Ltac sliding N := destruct (slip _ _ _ _ S t ht N) as (_ & _ & U' & W'); rewrite (rder_unique _ _ _ _ U U'), (rder_unique _ _ _ _ W W');
  unfold eq91_moment, eq92_virial; fold (nrm (u t) (w t)); field; exact N.
(* (90) at every moment, at rest too: (ax, ay) is the acceleration *)
Theorem eq_90 : u t * ax + w t * ay = eq90_power (x t) (y t) (u t) (w t).
Proof.
  destruct (s_law _ _ _ _ S t ht) as (_ & _ & fx & fy & [_ P] & U' & W'). rewrite (rder_unique _ _ _ _ U U'), (rder_unique _ _ _ _ W W').
    unfold eq90_power. fold (nrm (u t) (w t)). lra.
Qed.
Hypothesis N : p t <> 0.
(* (91) while it slips *)
Theorem eq_91 : x t * ay - y t * ax = eq91_moment (x t) (y t) (u t) (w t).
Proof. sliding N. Qed.
(* (92) while it slips *)
Theorem eq_92 : x t * ax + y t * ay + (u t ^ 2 + w t ^ 2) = eq92_virial (x t) (y t) (u t) (w t).
Proof. sliding N. Qed.
End Projections.
End Motions.
Lemma eq_90__occurs : ltac:(occurs eq_90).
Proof. intros H. from 0 2 1 0. destruct (s_law _ _ _ _ S 0 now) as (_ & _ & fx & fy & _ & U & W). exact (H x y u w S 0 now _ _ U W). Qed.
Lemma eq_91__occurs : ltac:(occurs eq_91).
Proof. intros H. from 0 2 1 0. destruct (s_law _ _ _ _ S 0 now) as (_ & _ & fx & fy & _ & U & W). apply (H x y u w S 0 now _ _ U W). start. lra. Qed.
Lemma eq_92__occurs : ltac:(occurs eq_92). Proof. exact eq_91__occurs. Qed.

(* ---- p, xi and ell ---- *)
(* (96): with psi of any position and velocity, and ell by (95) *)
Theorem eq_96 x y u w psi : position_angle x y u w psi ->
  let p := eq93_speed u w in let l := eq95_ell (nrm x y) psi in eq96_angular_momentum_1 p l x y u w = eq96_angular_momentum_2 p l x y u w.
Proof. intros [_ e]%angle_iff p l. unfold eq96_angular_momentum_2. rewrite e.
  unfold eq96_angular_momentum_1, p, l, eq95_ell. change (eq93_speed u w) with (nrm u w). ring. Qed.
Lemma eq_96__occurs : ltac:(occurs eq_96). Proof. intros H. destruct (angle_exists 1 2 3 4) as [psi [P _]]. exact (H _ _ _ _ psi P). Qed.
(* (97): with xi by (94) *)
Theorem eq_97 x y u w psi : position_angle x y u w psi ->
  let p := eq93_speed u w in let xi := eq94_xi (nrm x y) psi in eq97_radial_1 p xi x y u w = eq97_radial_2 p xi x y u w.
Proof. intros [e _]%angle_iff p xi. unfold eq97_radial_2. rewrite e.
  unfold eq97_radial_1, p, xi, eq94_xi. change (eq93_speed u w) with (nrm u w). ring. Qed.
Lemma eq_97__occurs : ltac:(occurs eq_97). Proof. exact eq_96__occurs. Qed.
(* (98): for every angle *)
Theorem eq_98 x y psi : let l := eq95_ell (nrm x y) psi in let xi := eq94_xi (nrm x y) psi in eq98_distance_1 x y l xi = eq98_distance_2 x y l xi.
Proof. intros l xi. unfold eq98_distance_1, eq98_distance_2, l, xi, eq94_xi, eq95_ell.
  rewrite <- nrm_sq, <- (Rmult_1_r (nrm x y ^ 2)), <- (unit_circle psi). ring. Qed.

Section Angle.
Variables x y u w psi : R -> R.
Hypothesis S : spin x y u w.
Hypothesis P : forall t, 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation xi t := (eq94_xi (nrm (x t) (y t)) (psi t)).
Notation ell t := (eq95_ell (nrm (x t) (y t)) (psi t)).
Variable t : R.
Hypothesis ht : 0 <= t.
Lemma products : p t * xi t = x t * u t + y t * w t /\ p t * ell t = x t * w t - y t * u t.
Proof. destruct (proj1 (angle_iff _ _ _ _ _) (P t ht)) as [-> ->]. unfold eq94_xi, eq95_ell. split; ring. Qed.
Ltac fold_sizes := cbv beta; set (n := p t) in *; set (l := ell t) in *; set (z := xi t) in *.
Ltac only_rate z n := split; [ intros h; apply (Rmult_eq_reg_r (z / n));
  [ lra | now apply Rmult_integral_contrapositive_currified, Rinv_neq_0_compat ]
  | intros ->; field; trivial ].
(* (99) while it slips *)
Theorem eq_99 : p t <> 0 -> rder (fun t => p t) t (eq99_p_rate (xi t)).
Proof. intros N. apply (psi_rates x y u w psi S P t ht N). Qed.
(* (100) while it slips *)
Theorem eq_100 : p t <> 0 -> rder (fun t => ell t) t (eq100_ell_rate (p t) (ell t) (xi t)).
Proof. intros N. apply (psi_rates x y u w psi S P t ht N). Qed.
(* (101) while it slips *)
Theorem eq_101 : p t <> 0 -> rder (fun t => xi t) t (eq101_xi_rate (p t) (ell t)).
Proof. intros N. apply (psi_rates x y u w psi S P t ht N). Qed.
(* (99) is Newton's law (89), projected on the velocity *)
Theorem s4_projection_tangential : p t <> 0 -> let X := x t in let Y := y t in let V := u t in let Z := w t in
  s4_tangential_rate X Y V Z = (eq89_acceleration_1 X Y V Z * V + eq89_acceleration_2 X Y V Z * Z) / p t /\
  s4_tangential_rate X Y V Z = eq99_p_rate (xi t) /\ rder (fun t => p t) t (s4_tangential_rate X Y V Z).
Proof.
  intros N X Y V Z. split. reflexivity. assert (e : s4_tangential_rate X Y V Z = eq99_p_rate (xi t)).
  { unfold s4_tangential_rate, X, Y, V, Z. fold (nrm (u t) (w t)). transitivity ((x t * u t + y t * w t) / p t - (u t ^ 2 + w t ^ 2) / p t ^ 2).
    field. exact N. rewrite <- (proj1 products), <- nrm_sq. unfold eq99_p_rate. set (z := xi t). field. exact N. }
  split; trivial. rewrite e. exact (eq_99 N).
Qed.
(* (100) is (91), the law of the angular momentum p ell, combined with the rate of p; with q for that rate, as the formula printed has it, only q =
  (99) will do *)
Theorem s4_projection_azimuthal : p t <> 0 -> rder (fun t => p t * ell t) t (eq91_moment (x t) (y t) (u t) (w t)) /\
  rder (fun t => p t) t (eq99_p_rate (xi t)) /\
  rder (fun t => ell t) t (right_turntable_azimuthal_rate (p t) (ell t) (xi t)) /\ right_turntable_azimuthal_rate (p t) (ell t) (xi t) =
    eq100_ell_rate (p t) (ell t) (xi t) /\
  forall q, ell t <> 0 -> (s4_azimuthal_rate (p t) (ell t) (xi t) q = eq100_ell_rate (p t) (ell t) (xi t) <-> q = eq99_p_rate (xi t)).
Proof.
  intros N. pose proof (eq_99 N) as D1. pose proof (eq_100 N) as D2. destruct products as [k1 k2]. unfold eq91_moment. fold (nrm (u t) (w t)).
  rewrite <- k1, <- k2. unfold s4_azimuthal_rate, right_turntable_azimuthal_rate, eq99_p_rate, eq100_ell_rate in *. fold_sizes.
  split. { eapply rder_eq. apply (rder_mult (fun t => p t) (fun t => ell t)); eassumption. cbv beta. fold n l z. field. exact N. }
  split; trivial. split. { eapply rder_eq. exact D2. field. exact N. } split. { field. exact N. } intros q l0. only_rate l n.
Qed.
(* (101) is (92), the law along the radius (of p xi), combined with the rate of p; no other rate will do *)
Theorem s4_projection_radial : p t <> 0 -> rder (fun t => p t * xi t) t (eq92_virial (x t) (y t) (u t) (w t)) /\
  rder (fun t => p t) t (eq99_p_rate (xi t)) /\
  rder (fun t => xi t) t (right_turntable_radial_rate (p t) (ell t) (xi t)) /\ right_turntable_radial_rate (p t) (ell t) (xi t) = eq101_xi_rate (p t)
    (ell t) /\
  forall q, xi t <> 0 -> (s4_radial_rate (p t) (ell t) (xi t) q = eq101_xi_rate (p t) (ell t) <-> q = eq99_p_rate (xi t)).
Proof.
  intros N. pose proof (eq_99 N) as D1. pose proof (eq_101 N) as D2. destruct products as [k1 k2]. pose proof (eq_98 (x t) (y t) (psi t)) as k3.
  cbv zeta in k3. unfold eq98_distance_1, eq98_distance_2 in k3. unfold eq92_virial. fold (nrm (u t) (w t)).
  rewrite <- k1, <- k2, k3, <- (nrm_sq (u t) (w t)).
  unfold s4_radial_rate, right_turntable_radial_rate, eq99_p_rate, eq101_xi_rate in *. fold_sizes.
  split. { eapply rder_eq. apply (rder_mult (fun t => p t) (fun t => xi t)); eassumption. cbv beta. fold n l z. field. exact N. }
  split; trivial. split. { eapply rder_eq. exact D2. field. exact N. } split. { field. exact N. } intros q l0. only_rate z n.
Qed.
(* (102): rho d rho / d tau is all of this *)
Theorem eq_102 rho' l' xi' p' : p t <> 0 -> rder (fun t => rho t) t rho' -> rder (fun t => ell t) t l' -> rder (fun t => xi t) t xi' ->
  rder (fun t => p t) t p' ->
  rho t * rho' = eq102_rate_1 (ell t) l' (xi t) xi' (p t) p' /\ rho t * rho' = eq102_rate_2 (ell t) l' (xi t) xi' (p t) p' /\
    rho t * rho' = eq102_rate_3 (ell t) l' (xi t) xi' (p t) p'.
Proof.
  intros N DR DL DX DP. rewrite (rder_unique _ _ _ _ DL (eq_100 N)), (rder_unique _ _ _ _ DX (eq_101 N)), (rder_unique _ _ _ _ DP (eq_99 N)).
  destruct (s_law _ _ _ _ S t ht) as (X & Y & _). assert (D2 : rder (fun t => rho t ^ 2) t (2 * (x t * u t + y t * w t))).
  { apply (rder_ext (fun t => x t ^ 2 + y t ^ 2)). { intros; symmetry; apply nrm_sq. } eapply rder_eq. rd. simpl. ring. }
  pose proof (rder_unique _ _ _ _ D2 (rder_pow (fun t => rho t) 2 t _ DR)) as e. simpl INR in e. simpl pow in e. rewrite <- (proj1 products) in e.
  unfold eq102_rate_1, eq102_rate_2, eq102_rate_3, eq99_p_rate, eq100_ell_rate, eq101_xi_rate.
  replace (rho t * rho') with (p t * xi t) by lra. repeat split; try ring. set (l := ell t). set (z := xi t). field. exact N.
Qed.
(* (107) while it slips *)
Theorem eq_107 : p t <> 0 -> rder (fun t => p t) t (eq107_p_rate (rho t) (psi t)).
Proof. exact eq_99. Qed.
(* (108) off the axis, at rest too *)
Theorem eq_108 : rho t <> 0 -> rder (fun t => rho t) t (eq108_rho_rate (p t) (psi t)).
Proof.
  intros r0. destruct (s_law _ _ _ _ S t ht) as (X & Y & _). destruct (proj1 (angle_iff _ _ _ _ _) (P t ht)) as [e1 _].
  eapply rder_eq. rd. exact r0. rewrite e1. unfold eq108_rho_rate. field. exact r0.
Qed.
(* (109) while it slips off the axis; psi without jumps, as any angle that is followed *)
Theorem eq_109 : p t <> 0 -> rho t <> 0 -> right_continuous psi t -> rder psi t (eq109_psi_rate (p t) (rho t) (psi t)).
Proof. intros N r0. apply (psi_rate x y u w psi S P t ht N r0). Qed.
End Angle.

Lemma eq_99__occurs : ltac:(occurs eq_99).
Proof. intros H. from 0 2 1 0. apply (H x y u w psi S P 0 now). start. lra. Qed.
Lemma eq_100__occurs : ltac:(occurs eq_100). Proof. exact eq_99__occurs. Qed.
Lemma eq_101__occurs : ltac:(occurs eq_101). Proof. exact eq_99__occurs. Qed.
Lemma eq_107__occurs : ltac:(occurs eq_107). Proof. exact eq_99__occurs. Qed.
Lemma s4_projection_tangential__occurs : ltac:(occurs s4_projection_tangential). Proof. exact eq_99__occurs. Qed.
Lemma s4_projection_azimuthal__occurs : ltac:(occurs s4_projection_azimuthal). Proof. exact eq_99__occurs. Qed.
Lemma s4_projection_radial__occurs : ltac:(occurs s4_projection_radial). Proof. exact eq_99__occurs. Qed.
Lemma eq_102__occurs : ltac:(occurs eq_102).
Proof.
  intros H. from 0 2 1 0. assert (N : nrm (u 0) (w 0) <> 0) by (start; lra). assert (M : nrm (x 0) (y 0) <> 0) by (start; lra).
  exact (H x y u w psi S P 0 now _ _ _ _ N (eq_108 _ _ _ _ _ S P 0 now M) (eq_100 _ _ _ _ _ S P 0 now N) (eq_101 _ _ _ _ _ S P 0 now N)
    (eq_99 _ _ _ _ _ S P 0 now N)).
Qed.
Lemma eq_108__occurs : ltac:(occurs eq_108).
Proof. intros H. from 0 2 1 0. apply (H x y u w psi S P 0 now). start. lra. Qed.
Lemma eq_109__occurs : ltac:(occurs eq_109).
Proof. intros H. from 0 2 1 0. apply (H x y u w psi S P 0 now); [ start; lra .. | apply Q; start; lra ]. Qed.

(* ---- energy ---- *)
(* (103) at every moment, at rest too *)
Theorem eq_103 x y u w t : spin x y u w -> 0 <= t -> rder (fun t => eq103_energy (nrm (u t) (w t)) (nrm (x t) (y t))) t (eq103_energy_rate (nrm (u t)
  (w t))).
Proof.
  intros S Ht. pose proof (E_rate x y u w S t Ht). apply (rder_ext (fun t => (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) * - / 2)).
  { intros s _. unfold eq103_energy. rewrite !nrm_sq. field. } eapply rder_eq. rds. unfold eq103_energy_rate. inR. field.
Qed.
Lemma eq_103__occurs : ltac:(occurs eq_103).
Proof. intros H. from 0 2 1 0. exact (H x y u w 0 S now). Qed.
(* (104) of every motion, with the length of its path, rests included *)
Theorem eq_104 x y u w s t : spin x y u w -> arc_length u w s -> 0 <= t ->
  eq104_constant (nrm (u t) (w t)) (nrm (x t) (y t)) (s t) = eq104_constant (nrm (u 0) (w 0)) (nrm (x 0) (y 0)) (s 0).
Proof.
  intros S [cs ds] Ht. apply (rder_const (fun t => eq104_constant (nrm (u t) (w t)) (nrm (x t) (y t)) (s t))); trivial; intros r Hr;
    unfold eq104_constant, Rdiv.
  - cont; first [ apply cs | apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.
  - eapply rder_eq. apply (rder_plus (fun t => (nrm (u t) (w t) ^ 2 - nrm (x t) (y t) ^ 2) * / 2) s); [ apply (eq_103 x y u w r S); lra | apply ds;
    lra ]. unfold eq103_energy_rate, eq105_arc_rate. ring.
Qed.
Lemma eq_104__occurs : ltac:(occurs eq_104).
Proof. intros H. from 0 2 1 0. apply (H x y u w _ 0 S (arc_exists 1 1 x y u w Rlt_0_1 (proj1 (spin_is_turntable _ _ _ _) S)) now). Qed.
(* The equations (99) to (101), of whatever functions, have (104) for a constant once s is joined to them by (105);
  what p, ell, xi give alone falls at the rate p *)
Theorem s4_constant_of_motion p l xi s T : (forall t, 0 < t < T -> continuity_pt p t /\ continuity_pt l t /\ continuity_pt xi t /\
  continuity_pt s t) ->
  (forall t, 0 <= t < T -> p t <> 0 /\ rder p t (eq99_p_rate (xi t)) /\ rder l t (eq100_ell_rate (p t) (l t) (xi t)) /\
    rder xi t (eq101_xi_rate (p t) (l t)) /\ rder s t (eq105_arc_rate (p t))) ->
  forall t, 0 <= t < T -> eq104_constant (p t) (nrm (l t) (xi t)) (s t) = eq104_constant (p 0) (nrm (l 0) (xi 0)) (s 0) /\
  rder (fun t => eq103_energy (p t) (nrm (l t) (xi t))) t (- p t).
Proof.
  intros C D. assert (K : forall t, 0 <= t < T -> rder (fun t => eq103_energy (p t) (nrm (l t) (xi t))) t (- p t)).
  { intros t Ht. destruct (D t Ht) as (N & DP & DL & DX & _). apply (rder_near _ (fun t => (p t ^ 2 - (l t ^ 2 + xi t ^ 2)) * / 2) t _ 1 Rlt_0_1).
    { intros r _. unfold eq103_energy. now rewrite nrm_sq. } eapply rder_eq. rd. simpl. unfold eq99_p_rate, eq100_ell_rate, eq101_xi_rate. field.
      exact N. }
  intros t Ht. split; [ | now apply K ]. apply (rder_const (fun t => eq104_constant (p t) (nrm (l t) (xi t)) (s t))); [ lra | | ]; intros r Hr;
    unfold eq104_constant, Rdiv.
  - destruct (C r ltac:(lra)) as (? & ? & ? & ?). cont.
  - destruct (D r ltac:(lra)) as (_ & _ & _ & _ & DS). eapply rder_eq. apply (rder_plus (fun t => (p t ^ 2 - nrm (l t) (xi t) ^ 2) * / 2) s);
    [ apply K; lra | exact DS ].
    unfold eq105_arc_rate. ring.
Qed.
Lemma s4_constant_of_motion__occurs : ltac:(occurs s4_constant_of_motion).
Proof.
  intros H. from 0 2 1 0. assert (N : nrm (u 0) (w 0) <> 0) by (start; lra). destruct (slips_on _ _ _ _ S 0 now N) as (d & d0 & Hd).
    rewrite Rplus_0_l in Hd.
  destruct (arc_exists 1 1 x y u w Rlt_0_1 (proj1 (spin_is_turntable _ _ _ _) S)) as [cs ds].
  eapply (H (fun t => nrm (u t) (w t)) (fun t => (x t * w t - y t * u t) * / nrm (u t) (w t)) (fun t => (x t * u t + y t * w t) * / nrm (u t) (w t)) _
    d); [ | | exact (conj now d0) ]; intros t Ht.
  - specialize (Hd t ltac:(lra)). pose proof (cont_inv (fun t => nrm (u t) (w t)) t ltac:(table S) ltac:(lra)) as ci.
    repeat split; [ table S | | | apply cs; lra ]; (apply (continuity_pt_mult (fun t => _)); [ table S | exact ci ]).
  - specialize (Hd t ltac:(lra)). assert (n : nrm (u t) (w t) <> 0) by lra. repeat split; trivial;
    [ now apply (dp x y u w S) | | now apply (eq101 x y u w S) | now apply ds ].
    eapply rder_eq. now apply (eq100 x y u w S). unfold eq100_ell_rate. field. exact n.
Qed.

Section Energy.
Variables (m mu g Om : R) (x y u w s : R -> R).
Hypothesis S : turntable Om (mu * g) x y u w.
Hypothesis L : arc_length u w s.
Variable t : R.
Hypothesis ht : 0 <= t.
(* (106) as corrected, with m mu g s, of every motion with its dimensions, rests included *)
Theorem eq_106 : right_turntable_constant m mu g Om (x t) (y t) (u t) (w t) (s t) = right_turntable_constant m mu g Om (x 0) (y 0) (u 0) (w 0) (s 0).
Proof.
  destruct L as [cs ds]. apply (rder_const (fun t => right_turntable_constant m mu g Om (x t) (y t) (u t) (w t) (s t))); trivial; intros r Hr;
    unfold right_turntable_constant, Rdiv.
  - destruct (t_c _ _ _ _ _ _ S r ltac:(lra)) as (? & ? & ? & ?). pose proof (cs r ltac:(lra)). cont.
  - destruct (t_law _ _ _ _ _ _ S r ltac:(lra)) as (X & Y & fx & fy & [B P] & U & W). pose proof (ds r ltac:(lra)) as D. unfold eq105_arc_rate in D.
    eapply rder_eq. rd. simpl. set (n := nrm _ _) in *. transitivity (m * (fx * u r + fy * w r + mu * g * n)). field. rewrite P. ring.
Qed.
Lemma two_ways a b : m <> 0 -> g <> 0 -> m * g * ((1 - mu) * (a - b)) = 0 <-> mu = 1 \/ a = b.
Proof.
  intros hm hg. split; [ | intros [-> | ->]; ring ]. intros Z. apply Rmult_integral in Z as [Z | Z]; apply Rmult_integral in Z as [Z | Z]; try easy; lra.
Qed.
(* the printed m g s keeps the sum just where mu = 1 or nothing has moved *)
Theorem eq_106__printed : m <> 0 -> g <> 0 -> (eq106_constant m g Om (x t) (y t) (u t) (w t) (s t) = eq106_constant m g Om (x 0) (y 0) (u 0) (w 0)
  (s 0) <-> mu = 1 \/ s t = s 0).
Proof.
  intros hm hg. rewrite <- (two_ways (s t) (s 0) hm hg). pose proof eq_106 as E. unfold eq106_constant, right_turntable_constant in *. split; lra.
Qed.
(* Work and energy on the table: the Coriolis force has no power; - m mu g s changes as the friction (fx, fy) per mass works;
  kinetic energy gains by the centrifugal force and by friction.
   The printed - m g s is the work of friction just where mu = 1 or the particle rests *)
Theorem s4_coriolis_no_work fx fy : coulomb (mu * g) (u t) (w t) fx fy -> coriolis_power m Om (u t) (w t) = 0 /\
  rder (fun t => right_turntable_friction_work m mu g (s t)) t (m * (fx * u t + fy * w t)) /\
  rder (fun t => m / 2 * (u t ^ 2 + w t ^ 2)) t (m * Om ^ 2 * (x t * u t + y t * w t) + coriolis_power m Om (u t) (w t) + m * (fx * u t + fy * w
    t)) /\
  (m <> 0 -> g <> 0 -> (rder (fun t => friction_work m g (s t)) t (m * (fx * u t + fy * w t)) <-> mu = 1 \/ nrm (u t) (w t) = 0)).
Proof.
  intros [_ P]. destruct L as [_ ds]. specialize (ds t ht). unfold eq105_arc_rate in ds.
    destruct (t_law _ _ _ _ _ _ S t ht) as (_ & _ & gx & gy & [_ Q] & U & W).
  assert (c0 : coriolis_power m Om (u t) (w t) = 0) by (unfold coriolis_power; ring). rewrite c0, P. set (n := nrm (u t) (w t)) in *. split; trivial.
    split.
  { unfold right_turntable_friction_work. eapply rder_eq. rd. ring. } split.
  { eapply rder_eq. unfold Rdiv. rd. simpl. transitivity (m * Om ^ 2 * (x t * u t + y t * w t) + m * (gx * u t + gy * w t)). field. rewrite Q. ring. }
  intros hm hg. rewrite <- (two_ways n 0 hm hg). assert (D : rder (fun t => friction_work m g (s t)) t (- (m * g * n))).
  { unfold friction_work. eapply rder_eq; [ rd | ring ]. } split; intros Z. pose proof (rder_unique _ _ _ _ D Z). lra. eapply rder_eq. exact D. lra.
Qed.
End Energy.
Ltac with_dimensions H := destruct (turntable_exists 2 (3 * 10) 0 2 1 0) as (x & y & u & w & S & e1 & e2 & e3 & e4); try lra;
  pose proof (Rle_refl 0) as now.
Lemma eq_106__occurs : ltac:(occurs eq_106).
Proof. intros H. with_dimensions H. exact (H 4 3 10 2 x y u w _ S (arc_exists 2 (3 * 10) x y u w ltac:(lra) S) 0 now). Qed.
Lemma eq_106__printed__occurs : ltac:(occurs eq_106__printed).
Proof. intros H. with_dimensions H. apply (H 4 3 10 2 x y u w _ S (arc_exists 2 (3 * 10) x y u w ltac:(lra) S) 0 now); lra. Qed.
Lemma s4_coriolis_no_work__occurs : ltac:(occurs s4_coriolis_no_work).
Proof.
  intros H. with_dimensions H. destruct (t_law _ _ _ _ _ _ S 0 now) as (_ & _ & fx & fy & C & _).
    exact (H 4 3 10 2 x y u w _ S (arc_exists 2 (3 * 10) x y u w ltac:(lra) S) 0 now fx fy C).
Qed.

(* ---- hyperbolic parameters, p < rho: A and alpha by (111) and (112) ---- *)
Section Inner.
Variables x y u w psi A al : R -> R.
Hypothesis S : spin x y u w.
Hypothesis P : forall t, 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t).
Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis K : forall s, t <= s -> hyperbolic (x s) (y s) (u s) (w s) (A s) (al s).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Lemma inner : eq110_case (p t) (rho t) < 0 -> p t < rho t.
Proof. unfold eq110_case. pose proof (nrm_pos (u t) (w t)). pose proof (nrm_pos (x t) (y t)). intros. nra. Qed.
(* (113) at every moment with p < rho, at rest too *)
Theorem eq_113 : eq110_case (p t) (rho t) < 0 -> rder A t (eq113_a_rate (al t)).
Proof. intros H. apply (inner_rates x y u w A al S t ht (inner H) K). Qed.
(* (114) while it slips *)
Theorem eq_114 : eq110_case (p t) (rho t) < 0 -> p t <> 0 -> rder al t (eq114_alpha_rate (A t) (al t) (psi t)).
Proof. intros H N. exact (alpha_rate x y u w psi A al S P t ht (inner H) N K). Qed.
Lemma parameters : p t <> 0 -> 0 < A t /\ 0 < al t /\ rho t <> 0.
Proof.
  intros N. destruct (K t (Rle_refl t)) as [k1 k2]. unfold eq111_p, eq112_rho in *. pose proof (nrm_pos (u t) (w t)). pose proof (nrm_pos (x t) (y t)).
  pose proof (cosh_pos (al t)). assert (A0 : 0 < A t) by (destruct (Req_dec (A t) 0) as [k | k]; [ rewrite k in k1; lra | nra ]).
  split; trivial. split; [ apply sinh_sign | ]; nra.
Qed.
(* (115) while it slips: alpha > 0 *)
Theorem eq_115 : p t <> 0 -> right_continuous psi t -> rder psi t (eq115_psi_rate (al t) (psi t)).
Proof.
  intros N C. destruct (parameters N) as (A0 & al0 & r0). pose proof (psi_rate x y u w psi S P t ht N r0 C) as D.
  destruct (K t (Rle_refl t)) as [k1 k2]. rewrite k1, k2 in D. apply sinh_lt in al0. rewrite sinh_0 in al0.
  now rewrite <- (proj1 (psi_rate_hyperbolic (A t) (al t) (psi t) ltac:(lra) ltac:(lra))).
Qed.
(* (124): of the angles within a quarter turn of 0, psi of a motion stands still at psi_1, and at no other ... *)
Theorem eq_124 : p t <> 0 -> right_continuous psi t -> - (PI / 2) <= psi t <= PI / 2 -> (rder psi t 0 <-> psi t = eq124_psi1 (al t)).
Proof.
  intros N C B. destruct (parameters N) as (_ & al0 & _). pose proof (eq_115 N C) as D. pose proof (stands (al t) al0 (psi t)) as Q.
    pose proof (tanh_range (al t) al0). unfold eq124_psi1. split.
  - intros Z. assert (e : sin (psi t) = tanh (2 * al t)) by (apply Q, (rder_unique _ _ _ _ D Z)). rewrite <- e. symmetry. now apply asin_sin.
  - intros e. eapply rder_eq. exact D. apply Q. rewrite e. apply sin_asin. lra.
Qed.
(* (125): ... and of those on the other side at psi_2, and at no other *)
Theorem eq_125 : p t <> 0 -> right_continuous psi t -> PI / 2 <= psi t <= 3 * (PI / 2) -> (rder psi t 0 <-> psi t = eq125_psi2 (al t)).
Proof.
  intros N C B. destruct (parameters N) as (_ & al0 & _). pose proof (eq_115 N C) as D. pose proof (stands (al t) al0 (psi t)) as Q.
    pose proof (tanh_range (al t) al0). unfold eq125_psi2. split.
  - intros Z. assert (e : sin (psi t) = tanh (2 * al t)) by (apply Q, (rder_unique _ _ _ _ D Z)). rewrite <- e, <- sin_PI_x, asin_sin by lra. ring.
  - intros e. eapply rder_eq. exact D. apply Q. rewrite e, sin_PI_x. apply sin_asin. lra.
Qed.
End Inner.
(* p = 1, rho = 2, psi = pi/2: a quarter turn from both sides *)
Ltac inner_start := from 0 2 1 0; match goal with S : spin ?x ?y ?u ?w, Q : _ -> _ -> let _ := _ in let _ := _ in _ -> right_continuous ?psi _ /\
  _ |- _ =>
  destruct (with_A x y u w S) as (A & al & K); [ start; lra | ]; assert (I : eq110_case (nrm (u 0) (w 0)) (nrm (x 0) (y 0)) < 0) by (unfold
    eq110_case; start; lra);
  assert (N : nrm (u 0) (w 0) <> 0) by (start; lra); destruct Q as [C q]; [ start; lra .. | ];
  assert (B : psi 0 = PI / 2) by (rewrite q; unfold half_angle; start; replace ((2 * 1 - 0 * 0) / (2 * 1 + (0 * 1 + 2 * 0))) with 1 by field;
    rewrite atan_1; field) end.
Lemma eq_113__occurs : ltac:(occurs eq_113). Proof. intros H. inner_start. exact (H x y u w A al S 0 now K I). Qed.
Lemma eq_114__occurs : ltac:(occurs eq_114). Proof. intros H. inner_start. exact (H x y u w psi A al S P 0 now K I N). Qed.
Lemma eq_115__occurs : ltac:(occurs eq_115). Proof. intros H. inner_start. exact (H x y u w psi A al S P 0 now K N C). Qed.
Lemma eq_124__occurs : ltac:(occurs eq_124). Proof. intros H. inner_start. pose proof PI_RGT_0. apply (H x y u w psi A al S P 0 now K N C). lra. Qed.
Lemma eq_125__occurs : ltac:(occurs eq_125). Proof. intros H. inner_start. pose proof PI_RGT_0. apply (H x y u w psi A al S P 0 now K N C). lra. Qed.

(* ---- p > rho: B and beta by (117) and (118) ---- *)
(* the value at the imaginary unit of a formula f of first degree. «$f(\mathrm i)$» *)
Definition at_i (f : R -> R) : C := (f 0, f 1 - f 0).
(* of a complex number z. «$\sinh(z)$» *)
Definition csinh (z : C) : C := (sinh (fst z) * cos (snd z), cosh (fst z) * sin (snd z)).
(* of a complex number z. «$\cosh(z)$» *)
Definition ccosh (z : C) : C := (cosh (fst z) * cos (snd z), sinh (fst z) * sin (snd z)).
(* by real and imaginary part. «$f$ has the right derivative $l$ at $t$» *)
Definition crder (f : R -> C) t (l : C) := rder (fun s => fst (f s)) t (fst l) /\ rder (fun s => snd (f s)) t (snd l).
Section Outer.
Variables x y u w psi B be : R -> R.
Hypothesis S : spin x y u w.
Hypothesis P : forall t, 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t).
Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis K : forall s, t <= s -> nrm (x s) (y s) < nrm (u s) (w s) -> hyperbolic_B (x s) (y s) (u s) (w s) (B s) (be s).
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Hypothesis fast : 0 < eq116_case (p t) (rho t).
Lemma outer : rho t < p t.
Proof. unfold eq116_case in fast. pose proof (nrm_pos (u t) (w t)). pose proof (nrm_pos (x t) (y t)). nra. Qed.
(* (119) at every moment with p > rho *)
Theorem eq_119 : rder B t (eq119_b_rate (be t)).
Proof. apply (outer_rates x y u w B be S t ht outer K). Qed.
(* (120) off the axis *)
Theorem eq_120 : rho t <> 0 -> rder be t (eq120_beta_rate (B t) (be t) (psi t)).
Proof.
  intros r0. pose proof outer as o. pose proof (nrm_pos (x t) (y t)). destruct (outer_rates x y u w B be S t ht o K) as (B0 & _ & D).
  pose proof (cosh_pos (be t)).
  eapply rder_eq. { apply D, (rho_rate x y u w psi S P t ht); lra. } destruct (K t (Rle_refl t) o) as [-> _].
  unfold eq117_p, eq119_b_rate, eq120_beta_rate. field. lra.
Qed.
(* (121) off the axis: beta > 0 *)
Theorem eq_121 : rho t <> 0 -> right_continuous psi t -> rder psi t (eq121_psi_rate (be t) (psi t)).
Proof.
  intros r0 C. pose proof outer as o. pose proof (nrm_pos (x t) (y t)). pose proof (psi_rate x y u w psi S P t ht ltac:(lra) r0 C) as D.
  destruct (K t (Rle_refl t) o) as [k1 k2]. rewrite k1, k2 in *. unfold eq118_rho in r0.
  now rewrite <- (proj2 (psi_rate_hyperbolic (B t) (be t) (psi t) ltac:(nra) ltac:(nra))).
Qed.
(* the complex A of (122) and alpha of (123) *)
Notation A_i s := (at_i (fun i => eq122_a i (B s))).
Notation alpha_i s := (at_i (fun i => eq123_alpha i (be s))).
Lemma complex_parameters s : A_i s = (0, - B s) /\ alpha_i s = (be s, PI / 2).
Proof. unfold at_i, eq122_a, eq123_alpha. split; f_equal; field. Qed.
Ltac parts := destruct (complex_parameters t) as [ea eb]; rewrite ?ea, ?eb; unfold csinh, ccosh; cbn [fst snd]; rewrite ?cos_PI2, ?sin_PI2.
(* (122) with (123): p = A sinh alpha and rho = A cosh alpha, (111) and (112), for this complex A and no other; and A has the rate (113) *)
Theorem eq_122 : (forall A, (RtoC (p t) = A * csinh (alpha_i t) /\ RtoC (rho t) = A * ccosh (alpha_i t))%C <-> A = A_i t) /\
  crder (fun s => A_i s) t (csinh (alpha_i t)).
Proof.
  pose proof eq_119 as D. destruct (K t (Rle_refl t) outer) as [k1 k2]. unfold eq117_p, eq118_rho, eq119_b_rate in *. pose proof (cosh_pos (be t)).
    split.
  - intros [a b]. parts. rewrite k1, k2. unfold RtoC, Cmult. cbn [fst snd]. split.
    + intros [h _]. injection h as h1 h2. f_equal; apply (Rmult_eq_reg_r (cosh (be t))); lra.
    + intros h. injection h as -> ->. split; f_equal; ring.
  - parts. split; cbn [fst snd]; unfold at_i, eq122_a; cbn [fst snd]; (eapply rder_eq; [ rd | cbv beta; ring ]).
Qed.
(* (123) with (122): alpha has the rate (114) and psi the rate (115) of these complex A and alpha *)
Theorem eq_123 : rho t <> 0 -> right_continuous psi t -> crder (fun s => alpha_i s) t (RtoC (cos (psi t)) - ccosh (alpha_i t) / A_i t)%C /\
  exists l, rder psi t l /\ RtoC l = (2 * (1 - RtoC (sin (psi t)) * (ccosh (2 * alpha_i t) / csinh (2 * alpha_i t))))%C.
Proof.
  intros r0 C. pose proof (eq_120 r0) as D. pose proof (eq_121 r0 C) as D'. destruct (outer_rates x y u w B be S t ht outer K) as (B0 & _).
  destruct (K t (Rle_refl t) outer) as [_ k]. unfold eq118_rho in k. assert (s0 : sinh (be t) <> 0) by (intros z; rewrite z in k; lra).
    pose proof (cosh_pos (be t)) as c0. split.
  - parts. split; cbn [fst snd]; unfold at_i, eq123_alpha; cbn [fst snd];
    (eapply rder_eq; [ rd | unfold eq120_beta_rate, RtoC, Cminus, Cplus, Copp, Cdiv, Cmult, Cinv; cbn [fst snd]; field; nra ]).
  - exists (eq121_psi_rate (be t) (psi t)). split; trivial. replace (2 * alpha_i t)%C with (2 * be t, PI) by (parts; unfold RtoC, Cmult;
    cbn [fst snd]; f_equal; field).
    unfold csinh, ccosh. cbn [fst snd]. rewrite cos_PI, sin_PI. assert (sinh (2 * be t) <> 0) by (rewrite sinh_double; nra).
    apply injective_projections; unfold eq121_psi_rate, coth, RtoC, Cminus, Cplus, Copp, Cdiv, Cmult, Cinv; cbn [fst snd]; field; nra.
Qed.
End Outer.
Ltac outer_start := from 0 1 2 0; match goal with S : spin ?x ?y ?u ?w, Q : _ -> _ -> let _ := _ in let _ := _ in _ -> right_continuous _ _ /\
  _ |- _ => destruct (with_B x y u w) as (B & be & K);
  assert (I : 0 < eq116_case (nrm (u 0) (w 0)) (nrm (x 0) (y 0))) by (unfold eq116_case; start; lra); assert (N : nrm (x 0) (y 0) <> 0) by (start;
    lra); destruct Q as [C q]; [ start; lra .. | ] end.
Lemma eq_119__occurs : ltac:(occurs eq_119). Proof. intros H. outer_start. exact (H x y u w B be S 0 now (fun s _ => K s) I). Qed.
Lemma eq_120__occurs : ltac:(occurs eq_120). Proof. intros H. outer_start. exact (H x y u w psi B be S P 0 now (fun s _ => K s) I N). Qed.
Lemma eq_121__occurs : ltac:(occurs eq_121). Proof. intros H. outer_start. exact (H x y u w psi B be S P 0 now (fun s _ => K s) I N C). Qed.
Lemma eq_122__occurs : ltac:(occurs eq_122). Proof. exact eq_119__occurs. Qed.
Lemma eq_123__occurs : ltac:(occurs eq_123). Proof. exact eq_121__occurs. Qed.

(* psi_1 attracts and psi_2 repels, alpha held fixed: of every solution of (115) that does not start at psi_2 (up to whole turns) the ratio of
   sin ((psi - psi_1)/2) to sin ((psi - psi_2)/2) falls exactly at the rate 2 / sinh 2 alpha, so that psi goes to psi_1 (up to whole turns),
   however near psi_2 it started *)
Theorem s4_quasi_fixed_stability al psi : 0 < al -> (forall t, 0 < t -> continuity_pt psi t) ->
  (forall t, 0 <= t -> rder psi t (eq115_psi_rate al (psi t))) -> sin ((psi 0 - eq125_psi2 al) / 2) <> 0 ->
  let from1 t := sin ((psi t - eq124_psi1 al) / 2) in let from2 t := sin ((psi t - eq125_psi2 al) / 2) in
  (forall t, 0 <= t -> from2 t <> 0 /\ from1 t / from2 t = exp (- (2 / sinh (2 * al) * t)) * (from1 0 / from2 0)) /\ is_lim from1 p_infty 0.
Proof.
  intros Ha C D N f1 f2. split; [ | exact (attracted al Ha psi C D N) ]. intros t Ht. pose proof (stays_away al Ha psi C D N t Ht) as M. split;
  trivial.
  pose proof (ratio_falls al Ha psi C D t Ht) as R. fold (f1 t) (f1 0) (f2 t) (f2 0) in R. fold (f2 t) in M. fold (f2 0) in N.
  pose proof (exp_pos (2 / sinh (2 * al) * t)). rewrite exp_Ropp. set (e := exp _) in *. field_simplify_eq; lra.
Qed.
Lemma s4_quasi_fixed_stability__occurs : ltac:(occurs s4_quasi_fixed_stability).
Proof.
  intros H. destruct (frozen_exists 1 Rlt_0_1) as (psi & D & N). apply (H 1 psi Rlt_0_1); trivial; intros; [ eapply cont_of | apply rder_of ];
  apply D.
Qed.
