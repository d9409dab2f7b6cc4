(* Section 3: the sphere on an accelerated plane, from Newton's law and Coulomb's at the point of contact *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas Constant Steady Shaken LargeTime Sinusoidal Drawn Pulses Periodic HalfPeriod Drawn Line Body Reduction Driven
    Rolls Analysis.
From Slipbook Require Export AtRest.
Open Scope R_scope.

(* ---- the laws ---- *)
(* the sphere in the laboratory: the plane has the velocity (Px, Py) there, the centre (Vx, Vy); friction alone acts along the plane.
   «in the laboratory a sphere of the mass $m$, the moment of inertia $J$ and the radius $rad$, with $\mu g=k$, has the velocity $(Vx,Vy)$ and the
       angular
   velocity $(ox,oy,oz)$ on a plane that has the velocity $(Px,Py)$» *)
Record sphere_laboratory (m J rad k : R) (Px Py Vx Vy ox oy oz : R -> R) : Prop := {
  l_c : forall t, 0 < t -> continuity_pt Px t /\ continuity_pt Py t /\ continuity_pt Vx t /\ continuity_pt Vy t /\
    continuity_pt ox t /\ continuity_pt oy t /\ continuity_pt oz t;
  l_law : forall t, 0 <= t -> exists Fx Fy, coulomb (m * k) (slip_x rad Vx oy t - Px t) (slip_y rad Vy ox t - Py t) Fx Fy /\
    rder Vx t (Fx / m) /\ rder Vy t (Fy / m) /\ rder ox t (rad * Fy / J) /\ rder oy t (- rad * Fx / J) /\ rder oz t 0 }.
(* Seen from the plane, whose velocity has the rate A, that sphere obeys (59): its momentum has the rate -m A + F, with the same friction F. *)
Theorem eq_59 m J rad k Ax Ay Px Py Vx Vy ox oy oz t : 0 < m -> sphere_laboratory m J rad k Px Py Vx Vy ox oy oz ->
  (forall t, 0 <= t -> rder Px t (Ax t) /\ rder Py t (Ay t)) -> 0 <= t ->
  exists Fx Fy, coulomb (m * k) (slip_x rad (fun t => Vx t - Px t) oy t) (slip_y rad (fun t => Vy t - Py t) ox t) Fx Fy /\
    rder Vx t (Fx / m) /\ rder Vy t (Fy / m) /\
    rder (fun t => m * (Vx t - Px t)) t (eq59_momentum_rate_1 m (Ax t) (Ay t) 0 Fx Fy 0) /\
    rder (fun t => m * (Vy t - Py t)) t (eq59_momentum_rate_2 m (Ax t) (Ay t) 0 Fx Fy 0) /\ eq59_momentum_rate_3 m (Ax t) (Ay t) 0 Fx Fy 0 = 0.
Proof.
  intros hm [_ L] HP Ht. destruct (L t Ht) as (Fx & Fy & C & X & Y & _). destruct (HP t Ht) as [PX PY]. exists Fx, Fy.
  unfold slip_x, slip_y, eq59_momentum_rate_1, eq59_momentum_rate_2, eq59_momentum_rate_3 in *.
    split; [ | split; [ trivial | split; [ trivial | split; [ | split ] ] ] ].
  - replace (Vx t - Px t - rad * oy t) with (Vx t - rad * oy t - Px t) by ring. replace (Vy t - Py t + rad * ox t) with (Vy t + rad * ox t - Py t)
    by ring. exact C.
  - eapply rder_eq; [ rd | field; lra ].
  - eapply rder_eq; [ rd | field; lra ].
  - ring.
Qed.
Lemma eq_59__occurs : ltac:(occurs eq_59).
Proof.
  intros H. destruct example_slides as [[_ L] _]. refine (H 1 1 1 (/ 4 * 1) (fun _ => -1) (fun _ => 0) (fun t => - t) (fun _ => 0) (fun t =>
    example_v t - t) (fun _ => 1)
    (fun _ => -1) example_o (fun _ => 2) 1 _ _ _ _); try lra; [ split; intros t Ht | intros t Ht; split; (eapply rder_eq; [ rd | ring ]) ].
  - unfold example_v, example_o. repeat split; cont.
  - destruct (L t Ht) as (Fx & Fy & C & X & Y & OX & OY & OZ). exists Fx, Fy. unfold slip_x, slip_y in *. laws. replace (example_v t - t - 1 *
      example_o t - - t) with (example_v t - 1 * example_o t) by ring.
        rewrite Rminus_0_r.
    split; [ exact C | repeat split ]; (eapply rder_eq; [ rd | field ]).
Qed.
(* The body turns as J omega' = R x F, whatever its masses, if their moment is the same about every axis. Its angular momentum about the centre, of
   the velocities (vx, vy, vz) of its parts, changes by the moments of the forces: F and the plane's push N at the contact (0, 0, -rad); weight and
   inertia, (gx, gy, gz) per mass, everywhere. *)
Theorem eq_60 J mass rad X Y Z vx vy vz ox oy oz t Fx Fy N gx gy gz : one_moment J mass -> rigid X Y Z ox oy oz ->
  (forall t a b c, 0 <= t -> rder (fun t => X t a b c) t (vx t a b c) /\ rder (fun t => Y t a b c) t (vy t a b c) /\
    rder (fun t => Z t a b c) t (vz t a b c)) -> 0 <= t ->
  rder (fun t => moment mass (Y t) (Z t) (vy t) (vz t)) t (0 * N - (- rad) * Fy + moment mass (Y t) (Z t) (fun _ _ _ => gy) (fun _ _ _ => gz)) ->
  rder (fun t => moment mass (Z t) (X t) (vz t) (vx t)) t (- rad * Fx - 0 * N + moment mass (Z t) (X t) (fun _ _ _ => gz) (fun _ _ _ => gx)) ->
  rder (fun t => moment mass (X t) (Y t) (vx t) (vy t)) t (0 * Fy - 0 * Fx + moment mass (X t) (Y t) (fun _ _ _ => gx) (fun _ _ _ => gy)) ->
  rder (fun t => J * ox t) t (eq60_spin_rate_1 0 0 (- rad) Fx Fy 0) /\ rder (fun t => J * oy t) t (eq60_spin_rate_2 0 0 (- rad) Fx Fy 0) /\
  rder (fun t => J * oz t) t (eq60_spin_rate_3 0 0 (- rad) Fx Fy 0).
Proof.
  intros B D V Ht L1 L2 L3. destruct (body_spin J mass B X Y Z vx vy vz ox oy oz D V) as [K W]. destruct (W t Ht gx gy gz) as (w1 & w2 & w3).
  rewrite w1 in L1. rewrite w2 in L2. rewrite w3 in L3. unfold eq60_spin_rate_1, eq60_spin_rate_2, eq60_spin_rate_3.
  split; [ refine (rder_eq _ _ _ _ (rder_ext _ _ _ _ _ L1) _) | split; [ refine (rder_eq _ _ _ _ (rder_ext _ _ _ _ _ L2) _)
    | refine (rder_eq _ _ _ _ (rder_ext _ _ _ _ _ L3) _) ] ];
    try ring; intros s Hs; apply (K s); lra.
Qed.
(* a body that turns faster and faster about the first axis under a steady friction across it *)
Lemma eq_60__occurs : ltac:(occurs eq_60).
Proof.
  intros H. pose (th := fun t => t + t ^ 2 / 2). pose (x := fun _ a _ _ : R => a). pose (y := fun t _ b c : R => b * cos (th t) - c * sin (th t)).
    pose (z := fun t _ b c : R => b * sin (th t) + c * cos (th t)).
  assert (cs : forall t, cos (th t) ^ 2 + sin (th t) ^ 2 = 1) by (intros t; pose proof (sin2_cos2 (th t)) as I; rewrite !Rsqr_pow2 in I; lra).
  assert (D : rigid x y z (fun t => 1 + t) (fun _ => 0) (fun _ => 0)).
  { split.
    - intros t _. specialize (cs t). exists 1, 0, 0, 0, (cos (th t)), (sin (th t)), 0, (- sin (th t)), (cos (th t)). unfold x, y, z.
      repeat split; try ring; nra.
    - intros t a b c _. assert (Dt : rder th t (1 + t)) by (unfold th; apply rder_of; auto_derive; trivial; field).
      assert (Dc : rder (fun t => cos (th t)) t (- sin (th t) * (1 + t))) by (apply rder_comp; trivial; auto_derive; trivial; ring).
      assert (Ds : rder (fun t => sin (th t)) t (cos (th t) * (1 + t))) by (apply rder_comp; trivial; auto_derive; trivial; ring).
      unfold x, y, z. repeat split; (eapply rder_eq; [ rd | ring ]). }
  refine (H 1 (six 1) 1 x y z _ _ _ _ _ _ 1 0 1 1 0 0 (-1) (six_alike 1) D (turning _ _ _ _ _ _ D) ltac:(lra) _ _ _);
    destruct (body_spin 1 (six 1) (six_alike 1) x y z _ _ _ _ _ _ D (turning _ _ _ _ _ _ D)) as [K W];
      destruct (W 1 ltac:(lra) 0 0 (-1)) as (w1 & w2 & w3); cbv beta in *;
    rewrite ?w1, ?w2, ?w3; (eapply rder_ext; [ intros s Hs; symmetry; apply (K s); lra | eapply rder_eq; [ rd | ring ] ]).
Qed.

(* ---- while it slides, with dimensions ---- *)
Section Sliding.
Variables (m J rad mu g : R) (Ax Ay vx vy ox oy oz : R -> R) (t : R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hmu : 0 <= mu. Hypothesis hg : 0 <= g.
Hypothesis S : sphere m J rad (mu * g) Ax Ay vx vy ox oy oz.
Hypothesis ht : 0 <= t.
Hypothesis slides : ~ rolls rad vx vy ox oy t.
Ltac opened := destruct (sliding m J rad (mu * g) hm hJ Ax Ay vx vy ox oy oz t ltac:(now apply Rmult_le_pos) S ht slides) as (n0 & X & Y & OX & OY &
  OZ);
  unfold eq61_contact_1, eq61_contact_2, eq61_contact_3 in *; set (n := nrm _ _) in *.
Ltac length n := match goal with |- context [sqrt ?e] => replace (sqrt e) with n by (unfold n, nrm, slip_x, slip_y; f_equal; ring) end.
Ltac rate n := unfold slip_x, slip_y in *; eapply rder_eq; [ rd | length n; field; lra ].
(* The acceleration of the centre of a sliding sphere. *)
Theorem eq_63 : let rate f := f (Ax t) (Ay t) 0 mu g (vx t) (vy t) 0 (ox t) (oy t) (oz t) (eq61_contact_1 rad) (eq61_contact_2 rad) (eq61_contact_3
  rad) in
  rder vx t (rate eq63_velocity_rate_1) /\ rder vy t (rate eq63_velocity_rate_2) /\ rate eq63_velocity_rate_3 = 0.
Proof. opened. unfold eq63_velocity_rate_1, eq63_velocity_rate_2, eq63_velocity_rate_3. split; [ rate n | split; [ rate n | length n; field;
  lra ] ]. Qed.
(* The rate of its spin. *)
Theorem eq_64 : let rate f := f mu g (vx t) (vy t) 0 (ox t) (oy t) (oz t) (eq61_contact_1 rad) (eq61_contact_2 rad) (eq61_contact_3 rad) in
  let c := eq62_kappa J m rad * rad ^ 2 in
  rder (fun t => c * ox t) t (rate eq64_spin_rate_1) /\ rder (fun t => c * oy t) t (rate eq64_spin_rate_2) /\
    rder (fun t => c * oz t) t (rate eq64_spin_rate_3).
Proof. opened. unfold eq64_spin_rate_1, eq64_spin_rate_2, eq64_spin_rate_3, eq62_kappa. cbv zeta. repeat split; rate n. Qed.
(* The rate of omega x R, the spin's share of the slip. *)
Theorem eq_65 : let rate f := f (eq62_kappa J m rad) mu g (vx t) (vy t) 0 (ox t) (oy t) (oz t) (eq61_contact_1 rad) (eq61_contact_2 rad)
  (eq61_contact_3 rad) in
  rder (fun t => oy t * eq61_contact_3 rad - oz t * eq61_contact_2 rad) t (rate eq65_spin_slip_rate_1) /\
  rder (fun t => oz t * eq61_contact_1 rad - ox t * eq61_contact_3 rad) t (rate eq65_spin_slip_rate_2) /\
  rder (fun t => ox t * eq61_contact_2 rad - oy t * eq61_contact_1 rad) t (rate eq65_spin_slip_rate_3).
Proof. opened. unfold eq65_spin_slip_rate_1, eq65_spin_slip_rate_2, eq65_spin_slip_rate_3, eq62_kappa. cbv zeta. repeat split; rate n. Qed.
(* The rate of the slip velocity. *)
Theorem eq_66 : let rate f := f (Ax t) (Ay t) 0 (eq67_factor (eq62_kappa J m rad)) mu g (slip_x rad vx oy t) (slip_y rad vy ox t) 0 in
  rder (slip_x rad vx oy) t (rate eq66_slip_rate_1) /\ rder (slip_y rad vy ox) t (rate eq66_slip_rate_2) /\ rate eq66_slip_rate_3 = 0.
Proof.
  opened. unfold eq66_slip_rate_1, eq66_slip_rate_2, eq66_slip_rate_3, eq67_factor, eq62_kappa. cbv zeta.
    split; [ rate n | split; [ rate n | length n; field; lra ] ].
Qed.
End Sliding.
Ltac sliding_example := intros H; destruct example_slides as [? N]; eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _ 1);
  first [ eassumption | lra | match goal with K : forall t, _ -> ~ _ |- ~ _ => apply K; lra end ].
Lemma eq_63__occurs : ltac:(occurs eq_63).
Proof. sliding_example. Qed.
Lemma eq_64__occurs : ltac:(occurs eq_64).
Proof. sliding_example. Qed.
Lemma eq_65__occurs : ltac:(occurs eq_65).
Proof. sliding_example. Qed.
Lemma eq_66__occurs : ltac:(occurs eq_66).
Proof. sliding_example. Qed.

(* ---- in the units of (68) to (72); dot is the rate over tau ---- *)
(* the time at which (69) is tau. «$\sqrt{rad/(mu\,g)}\,tau$» *)
Definition clock (rad mu g tau : R) : R := sqrt (rad / (mu * g)) * tau.
(* dimensionless, at the time at which (69) is tau: the place of the centre (68), the angular velocity (70), the slip velocity (71) and the plane's
   acceleration (72), along the axes 1, 2, 3 *)
Definition rho_1 rad mu g (x y : R -> R) tau := eq68_position_1 rad (x (clock rad mu g tau)) (y (clock rad mu g tau)) 0.
Definition rho_2 rad mu g (x y : R -> R) tau := eq68_position_2 rad (x (clock rad mu g tau)) (y (clock rad mu g tau)) 0.
Definition zeta_1 rad mu g (ox oy oz : R -> R) tau := let t := clock rad mu g tau in eq70_spin_1 rad mu g (ox t) (oy t) (oz t).
Definition zeta_2 rad mu g (ox oy oz : R -> R) tau := let t := clock rad mu g tau in eq70_spin_2 rad mu g (ox t) (oy t) (oz t).
Definition zeta_3 rad mu g (ox oy oz : R -> R) tau := let t := clock rad mu g tau in eq70_spin_3 rad mu g (ox t) (oy t) (oz t).
Definition u_1 rad mu g (vx vy ox oy : R -> R) tau := let t := clock rad mu g tau in eq71_slip_1 rad mu g (slip_x rad vx oy t) (slip_y rad vy ox t) 0.
Definition u_2 rad mu g (vx vy ox oy : R -> R) tau := let t := clock rad mu g tau in eq71_slip_2 rad mu g (slip_x rad vx oy t) (slip_y rad vy ox t) 0.
Definition gamma_1 rad mu g (Ax Ay : R -> R) tau := let t := clock rad mu g tau in eq72_acceleration_1 mu g (Ax t) (Ay t) 0.
Definition gamma_2 rad mu g (Ax Ay : R -> R) tau := let t := clock rad mu g tau in eq72_acceleration_2 mu g (Ax t) (Ay t) 0.
(* the velocity v of the centre in the unit of (71), dimensionless: by eq_73 the rate of rho *)
Definition rhodot rad mu g (v : R -> R) tau := v (clock rad mu g tau) / sqrt (mu * g * rad).
Section Units.
Variables (m J rad mu g : R) (Ax Ay X Y vx vy ox oy oz : R -> R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hmu : 0 < mu. Hypothesis hg : 0 < g.
Hypothesis S : sphere m J rad (mu * g) Ax Ay vx vy ox oy oz.
(* the place of the centre *)
Hypothesis centre : forall t, 0 <= t -> rder X t (vx t) /\ rder Y t (vy t).
Notation b := (eq67_factor (eq62_kappa J m rad)).
Notation T := (clock rad mu g).
Notation u1 := (u_1 rad mu g vx vy ox oy). Notation u2 := (u_2 rad mu g vx vy ox oy).
Notation v1 := (rhodot rad mu g vx). Notation v2 := (rhodot rad mu g vy).
Notation g1 := (gamma_1 rad mu g Ax Ay). Notation g2 := (gamma_2 rad mu g Ax Ay).
Let q := sqrt (mu * g * rad).
Lemma unit_facts : 0 < mu * g /\ 0 < q /\ q ^ 2 = mu * g * rad /\ sqrt (rad / (mu * g)) = q / (mu * g) /\ sqrt (mu * g / rad) = q / rad.
Proof.
  assert (k0 : 0 < mu * g) by (apply Rmult_lt_0_compat; lra). assert (0 < mu * g * rad) by (apply Rmult_lt_0_compat; lra). unfold q.
  repeat split; trivial. now apply sqrt_lt_R0. apply pow2_sqrt; lra.
  - replace (rad / (mu * g)) with (mu * g * rad / (mu * g) ^ 2) by (field; lra). rewrite sqrt_div_alt by (apply pow_lt; lra). rewrite sqrt_pow2; lra.
  - replace (mu * g / rad) with (mu * g * rad / rad ^ 2) by (field; lra). rewrite sqrt_div_alt by (apply pow_lt; lra). rewrite sqrt_pow2; lra.
Qed.
Lemma clock_is tau : eq69_time rad mu g (T tau) = tau.
Proof. destruct unit_facts as (k0 & q0 & e & e1 & e2). unfold eq69_time, clock. rewrite e1, e2.
  replace (q / rad * (q / (mu * g) * tau)) with (q ^ 2 / (mu * g * rad) * tau) by (field; lra). rewrite e. field. lra. Qed.
Lemma clock_pos tau : 0 <= tau -> 0 <= T tau.
Proof. intros H. unfold clock. apply Rmult_le_pos; [ apply sqrt_pos | trivial ]. Qed.
Notation z1 := (zeta_1 rad mu g ox oy oz). Notation z2 := (zeta_2 rad mu g ox oy oz). Notation z3 := (zeta_3 rad mu g ox oy oz).
(* in these units it is a sphere of the radius 1, with mu g = 1 *)
Lemma sphere_in_units : sphere m (J / rad ^ 2) 1 1 g1 g2 v1 v2 z1 z2 z3.
Proof.
  destruct unit_facts as (k0 & q0 & e & e1 & _). assert (ek : mu * g = q ^ 2 / rad) by (rewrite e; field; lra).
  assert (ec : q / (mu * g) = rad / q) by (rewrite ek; field; lra). assert (c0 : 0 < rad / q) by now apply Rdiv_lt_0_compat. destruct S as [C L].
  unfold zeta_1, zeta_2, zeta_3, gamma_1, gamma_2, rhodot, eq70_spin_1, eq70_spin_2, eq70_spin_3, eq72_acceleration_1, eq72_acceleration_2, clock.
      fold q.
  rewrite e1, ec. set (c := rad / q) in *. split; intros t Ht.
  - destruct (C (c * t) ltac:(now apply Rmult_lt_0_compat)) as (c1 & c2 & c3 & c4 & c5). apply cont_time in c1, c2, c3, c4, c5. unfold Rdiv. repeat
      split; cont.
  - destruct (L (c * t) ltac:(apply Rmult_le_pos; lra)) as (Fx & Fy & F & VX & VY & OX & OY & OZ). exists (/ (mu * g) * Fx), (/ (mu * g) * Fy).
    apply (coulomb_force (/ (mu * g))), (coulomb_velocity (/ q)) in F; [ | left; now apply Rinv_0_lt_compat ].
    apply rder_time in VX, VY, OX, OY, OZ; trivial. laws. split; [ | repeat split; (eapply rder_eq; [ unfold Rdiv; rd | rewrite ?ek; unfold c; field;
        lra ]) ].
    replace (m * 1) with (/ (mu * g) * (m * (mu * g))) by (field; lra). unfold slip_x, slip_y, c in *.
    replace (vx (rad / q * t) / q - _) with (/ q * (vx (rad / q * t) - rad * oy (rad / q * t))) by (field; lra).
    replace (vy (rad / q * t) / q + _) with (/ q * (vy (rad / q * t) + rad * ox (rad / q * t))) by (field; lra). exact F.
Qed.
Lemma slip_by_spin : slip_x 1 v1 z2 = u1 /\ slip_y 1 v2 z1 = u2.
Proof.
  destruct unit_facts as (k0 & q0 & e & e1 & _). assert (ek : mu * g = q ^ 2 / rad) by (rewrite e; field; lra).
  split; extensionality tau; unfold slip_x, slip_y, u_1, u_2, rhodot, zeta_1, zeta_2, eq70_spin_1, eq70_spin_2, eq71_slip_1, eq71_slip_2, slip_x,
      slip_y;
    cbv zeta; fold q; rewrite e1; replace (q / (mu * g)) with (rad / q) by (rewrite ek; field; lra); field; lra.
Qed.
Lemma in_units : 0 < J / rad ^ 2 /\ factor m (J / rad ^ 2) 1 = b /\ slip_x 1 v1 z2 = u1 /\ slip_y 1 v2 z1 = u2.
Proof.
  assert (r2 : 0 < rad ^ 2) by now apply pow_lt. split; [ now apply Rdiv_lt_0_compat | split; [ unfold factor, eq67_factor, eq62_kappa; field; lra |
      exact slip_by_spin ] ].
Qed.
Lemma slip_in_units : motion b g1 g2 u1 u2.
Proof.
  destruct in_units as (J0 & eb & <- & <-). replace b with (factor m (J / rad ^ 2) 1 * 1) by (rewrite eb; ring). now apply (slip_moves m (J / rad ^
      2) 1 1 hm J0 Rlt_0_1 _ _ _ _ _ _ _ sphere_in_units).
Qed.
Section While.
Variable tau : R.
Hypothesis ht : 0 <= tau.
Hypothesis slides : ~ rolls rad vx vy ox oy (T tau).
Lemma rates : let n := nrm (u1 tau) (u2 tau) in 0 < n /\ sqrt (u1 tau ^ 2 + u2 tau ^ 2 + 0 ^ 2) = n /\
  rder v1 tau (- g1 tau - u1 tau / n) /\ rder v2 tau (- g2 tau - u2 tau / n) /\ rder u1 tau (- g1 tau - b * (u1 tau / n)) /\ rder u2 tau (- g2 tau -
      b * (u2 tau / n)).
Proof.
  destruct in_units as (J0 & eb & ex & ey). destruct (factor_is m J rad hm hJ hr) as [_ b1]. change (factor m J rad) with b in b1.
  assert (N : ~ rolls 1 v1 v2 z1 z2 tau).
  { unfold rolls. rewrite ex, ey. intros [n1 n2]. apply slides. destruct unit_facts as (_ & q0 & _). unfold u_1, u_2, eq71_slip_1, eq71_slip_2 in *.
      fold q in n1, n2.
    assert (0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). split; apply (Rmult_eq_reg_l (1 / q)); lra. }
  destruct (sliding m (J / rad ^ 2) 1 1 hm J0 _ _ _ _ _ _ _ tau Rle_0_1 sphere_in_units ht N) as (n0 & VX & VY & _). rewrite ex, ey in *.
  destruct (slip_rates b _ _ _ _ ltac:(lra) slip_in_units tau ht ltac:(lra)) as [UX UY].
  split; [ trivial | split; [ unfold nrm; f_equal; ring | split; [ | split; [ | split; trivial ] ] ] ]; (eapply rder_eq; [ eassumption | ring ]).
Qed.
Ltac rated := destruct rates as (n0 & en & VX & VY & UX & UY).
(* The centre of a sliding sphere: rho has the rate rhodot, and that the rate (73). *)
Theorem eq_73 : let rate f := f (g1 tau) (g2 tau) 0 (u1 tau) (u2 tau) 0 in
  rder (rho_1 rad mu g X Y) tau (v1 tau) /\ rder (rho_2 rad mu g X Y) tau (v2 tau) /\
  rder v1 tau (rate eq73_velocity_rate_1) /\ rder v2 tau (rate eq73_velocity_rate_2) /\ rate eq73_velocity_rate_3 = 0.
Proof.
  destruct unit_facts as (k0 & q0 & e & e1 & e2). destruct (centre (T tau) (clock_pos tau ht)) as [CX CY]. assert (c0 : 0 < q / (mu * g)) by now
      apply Rdiv_lt_0_compat.
  assert (ek : mu * g = q ^ 2 / rad) by (rewrite e; field; lra).
  rated. unfold eq73_velocity_rate_1, eq73_velocity_rate_2, eq73_velocity_rate_3. rewrite en. split; [ | split; [ | split; [ exact VX | split; [
      exact VY | field; lra ] ] ] ];
    unfold rho_1, rho_2, eq68_position_1, eq68_position_2, rhodot, clock in *; fold q; rewrite e1 in *; apply rder_time in CX, CY; trivial; unfold
        Rdiv in *;
    (eapply rder_eq; [ rd | rewrite ek; field; lra ]).
Qed.
(* The slip velocity. *)
Theorem eq_74 : let rate f := f b (g1 tau) (g2 tau) 0 (u1 tau) (u2 tau) 0 in
  rder u1 tau (rate eq74_slip_rate_1) /\ rder u2 tau (rate eq74_slip_rate_2) /\ rate eq74_slip_rate_3 = 0.
Proof. rated. unfold eq74_slip_rate_1, eq74_slip_rate_2, eq74_slip_rate_3. rewrite en. split; [ exact UX | split; [ exact UY | field; lra ] ]. Qed.
(* Friction alone changes rhodot + nu, for every nu with the rate gamma. *)
Theorem eq_77 nu1 nu2 : rder nu1 tau (eq76_nu_rate_1 (g1 tau) (g2 tau) 0) -> rder nu2 tau (eq76_nu_rate_2 (g1 tau) (g2 tau) 0) ->
  let rate f := f (u1 tau) (u2 tau) 0 in
  rder (fun tau => v1 tau + nu1 tau) tau (rate eq77_rate_1) /\ rder (fun tau => v2 tau + nu2 tau) tau (rate eq77_rate_2) /\ rate eq77_rate_3 = 0.
Proof.
  intros N1 N2 rate. unfold rate, eq76_nu_rate_1, eq76_nu_rate_2, eq77_rate_1, eq77_rate_2, eq77_rate_3 in *. rated. rewrite en.
  split; [ | split; [ | field; lra ] ]; (eapply rder_eq; [ rd | ring ]).
Qed.
(* And u + nu. *)
Theorem eq_78 nu1 nu2 : rder nu1 tau (eq76_nu_rate_1 (g1 tau) (g2 tau) 0) -> rder nu2 tau (eq76_nu_rate_2 (g1 tau) (g2 tau) 0) ->
  let rate f := f b (u1 tau) (u2 tau) 0 in
  rder (fun tau => u1 tau + nu1 tau) tau (rate eq78_rate_1) /\ rder (fun tau => u2 tau + nu2 tau) tau (rate eq78_rate_2) /\ rate eq78_rate_3 = 0.
Proof.
  intros N1 N2 rate. unfold rate, eq76_nu_rate_1, eq76_nu_rate_2, eq78_rate_1, eq78_rate_2, eq78_rate_3 in *. rated. rewrite en.
  split; [ | split; [ | field; lra ] ]; (eapply rder_eq; [ rd | ring ]).
Qed.
End While.
(* The spin is zeta_3 about the vertical and minus z x (u - rhodot), sliding or rolling. *)
Theorem eq_75 tau : let spin f := f (zeta_3 rad mu g ox oy oz tau) (u1 tau) (u2 tau) 0 (v1 tau) (v2 tau) 0 in
  zeta_1 rad mu g ox oy oz tau = spin right_sphere_spin_1 /\ zeta_2 rad mu g ox oy oz tau = spin right_sphere_spin_2 /\
    zeta_3 rad mu g ox oy oz tau = spin right_sphere_spin_3.
Proof.
  unfold right_sphere_spin_1, right_sphere_spin_2, right_sphere_spin_3. destruct slip_by_spin as [<- <-]. unfold slip_x, slip_y. repeat split; ring.
Qed.
(* The print, plus z x (u - rhodot), gives the spin only while the sphere does not turn about any horizontal axis. *)
Theorem eq_75__printed tau : let spin f := f (zeta_3 rad mu g ox oy oz tau) (u1 tau) (u2 tau) 0 (v1 tau) (v2 tau) 0 in
  (zeta_1 rad mu g ox oy oz tau = spin eq75_spin_1 /\ zeta_2 rad mu g ox oy oz tau = spin eq75_spin_2 /\
    zeta_3 rad mu g ox oy oz tau = spin eq75_spin_3) <->
  ox (T tau) = 0 /\ oy (T tau) = 0.
Proof.
  destruct unit_facts as (k0 & q0 & _ & e1 & _). unfold eq75_spin_1, eq75_spin_2, eq75_spin_3. destruct slip_by_spin as [<- <-]. unfold slip_x,
      slip_y.
  unfold zeta_1, zeta_2, eq70_spin_1, eq70_spin_2. cbv zeta. rewrite e1. assert (s0 : 0 < q / (mu * g)) by (apply Rdiv_lt_0_compat; lra). split.
  - intros (p1 & p2 & _). split; (apply (Rmult_eq_reg_l (q / (mu * g))); lra).
  - intros [-> ->]. lra.
Qed.
(* For every nu with the rate gamma there is a constant c so that the velocity of the centre is (79) at all times, sliding, rolling and in between. *)
Theorem eq_79 nu1 nu2 : (forall tau, 0 <= tau -> rder nu1 tau (eq76_nu_rate_1 (g1 tau) (g2 tau) 0) /\
  rder nu2 tau (eq76_nu_rate_2 (g1 tau) (g2 tau) 0)) ->
  (forall tau, 0 < tau -> continuity_pt nu1 tau /\ continuity_pt nu2 tau) ->
  exists c1 c2, forall tau, 0 <= tau -> let velocity f := f b (nu1 tau) (nu2 tau) 0 (u1 tau) (u2 tau) 0 c1 c2 0 in
  v1 tau = velocity eq79_velocity_1 /\ v2 tau = velocity eq79_velocity_2 /\ 0 = velocity eq79_velocity_3.
Proof.
  intros N cn. destruct in_units as (J0 & eb & ex & ey). destruct (factor_is m J rad hm hJ hr) as [_ b1]. change (factor m J rad) with b in b1.
  pose proof (fun tau => kept m (J / rad ^ 2) 1 1 hm J0 Rlt_0_1 _ _ _ _ _ _ _ nu1 nu2 tau sphere_in_units
    ltac:(split; intros; [ now apply cn | now apply N ]) ltac:(split; intros; [ now apply cn | now apply N ])) as K.
  rewrite eb, ?ex, ?ey in *. exists (v1 0 + (1 - / b) * nu1 0 - u1 0 * / b), (v2 0 + (1 - / b) * nu2 0 - u2 0 * / b). intros tau Ht.
  destruct (K tau Ht) as [<- <-]. unfold eq79_velocity_1, eq79_velocity_2, eq79_velocity_3. repeat split; field; lra.
Qed.
(* zeta_3 keeps its value, and enters nothing else: with any other constant spin about the vertical the rest is a motion as before. *)
Theorem s3_spin_constant : (forall tau, 0 <= tau -> rder (zeta_3 rad mu g ox oy oz) tau s3_zeta3_rate /\
  zeta_3 rad mu g ox oy oz tau = zeta_3 rad mu g ox oy oz 0) /\
  forall w, sphere m J rad (mu * g) Ax Ay vx vy ox oy (fun _ => w).
Proof.
  split.
  - intros tau Ht. destruct in_units as (J0 & _). split; [ | apply (spin_z m (J / rad ^ 2) 1 1 J0 _ _ _ _ _ _ _ tau sphere_in_units Ht) ].
    destruct (b_law _ _ _ _ _ _ _ _ _ _ _ sphere_in_units tau Ht) as (Fx & Fy & _ & _ & _ & _ & _ & OZ). laws. eapply rder_eq; [ exact OZ | unfold
        s3_zeta3_rate; field; lra ].
  - intros w. destruct S as [c L]. split.
    + intros t Ht. destruct (c t Ht) as (c1 & c2 & c3 & c4 & _). repeat split; trivial. cont.
    + intros t Ht. destruct (L t Ht) as (Fx & Fy & C & VX & VY & OX & OY & _). exists Fx, Fy. repeat (split; trivial). unfold eq60_spin_rate_3.
      eapply rder_eq; [ rd | field; lra ].
Qed.
End Units.
Ltac unit_example := intros H; destruct example_slides as [S N]; assert (Z : 0 <= clock 1 (/ 4) 1 1) by (apply clock_pos; lra);
  assert (N1 : forall tau, rder (fun tau => -1 / (/ 4 * 1) * tau) tau (-1 / (/ 4 * 1))) by (intros tau; eapply rder_eq; [ rd | field ]);
  assert (N2 : forall tau, rder (fun _ => 0) tau (0 / (/ 4 * 1))) by (intros tau; eapply rder_eq; [ rd | field ]);
  assert (P : forall t, 0 <= t -> rder (fun t => t + 3 / 8 * t ^ 2) t (example_v t) /\ rder (fun t => t) t 1)
    by (intros t _; unfold example_v; split; (eapply rder_eq; [ rd | simpl; field ])).
Ltac rate_of_nu := match goal with K : forall tau, rder _ tau _ |- rder _ _ _ => exact (K _) end.
Ltac filled := first [ match goal with |- 0 <= ?t => is_evar t; unify t 1; lra end | eassumption | lra | match goal with K : forall t, _ ->
  ~ _ |- ~ _ => apply K; first [ assumption | lra ] end
  | rate_of_nu | intros; split; rate_of_nu | intros; split; cont ].
Lemma eq_73__occurs : ltac:(occurs eq_73).
Proof. unit_example. eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _ _ _); filled. Qed.
Lemma eq_74__occurs : ltac:(occurs eq_74).
Proof. unit_example. eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _); filled. Qed.
Lemma eq_77__occurs : ltac:(occurs eq_77).
Proof. unit_example. eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _); filled. Qed.
Lemma eq_78__occurs : ltac:(occurs eq_78).
Proof. unit_example. eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _); filled. Qed.
Lemma eq_79__occurs : ltac:(occurs eq_79).
Proof. unit_example. eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _); filled. Qed.
Lemma s3_spin_constant__occurs : ltac:(occurs s3_spin_constant).
Proof. unit_example. eapply (H 1 1 1 (/ 4) 1 _ _ _ _ _ _ _); filled. Qed.

(* ---- 3.1: the plane is pulled steadily ---- *)
Section Pulled.
Variables (m J rad mu g A : R) (vx vy ox oy oz u theta : R -> R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hmu : 0 < mu. Hypothesis hg : 0 < g. Hypothesis hA : 0 < A.
Hypothesis S : sphere m J rad (mu * g) (fun _ => eq3_acceleration_1 A) (fun _ => eq3_acceleration_2 A) vx vy ox oy oz.
Hypothesis P : polar (u_1 rad mu g vx vy ox oy) (u_2 rad mu g vx vy ox oy) u theta.
Notation lam := (eq80_lambda (eq67_factor (eq62_kappa J m rad)) mu g A).
Notation gamma := (eq72_acceleration_1 mu g A 0 0).
Lemma pulled_facts : 0 < gamma /\ 0 < lam /\ pulled gamma lam (u_1 rad mu g vx vy ox oy) (u_2 rad mu g vx vy ox oy).
Proof.
  assert (k0 : 0 < mu * g) by (apply Rmult_lt_0_compat; lra). destruct (factor_is m J rad hm hJ hr) as [_ b1]. unfold factor in b1. unfold
      eq72_acceleration_1, eq80_lambda.
  split; [ now apply Rdiv_lt_0_compat | split ]. { apply Rdiv_lt_0_compat; trivial. rewrite Rmult_assoc. apply Rmult_lt_0_compat; lra. }
  pose proof (slip_in_units m J rad mu g _ _ vx vy ox oy oz hm hJ hr hmu hg S) as M. unfold pulled, gamma_1, gamma_2, eq72_acceleration_1,
      eq72_acceleration_2, eq3_acceleration_1, eq3_acceleration_2 in *.
  replace (- A / (mu * g)) with (- (A / (mu * g))) in M by (field; lra). replace (0 / (mu * g)) with 0 in M by (field; lra).
  replace (A / (mu * g) * _) with (eq67_factor (eq62_kappa J m rad)); [ exact M | field; lra ].
Qed.
Let hG : 0 < gamma := proj1 pulled_facts. Let hl : 0 <= lam := Rlt_le _ _ (proj1 (proj2 pulled_facts)). Let M := proj2 (proj2 pulled_facts).
(* The slip speed against the angle, as long as it slides, from every slip at an angle to the line of the pull. *)
Theorem eq_81 tau : 0 <= tau -> (forall s, 0 <= s <= tau -> 0 < u s) -> theta 0 <> 0 -> theta 0 <> PI ->
  0 < tan (theta tau / 2) / tan (theta 0 / 2) /\ u tau = eq81_slip lam (u 0) (theta 0) (theta tau).
Proof. exact (eq_11 gamma lam _ _ u theta hG hl M P tau). Qed.
(* The time against the angle, with gamma = A/(mu g). *)
Theorem eq_82 tau : 0 <= tau -> (forall s, 0 <= s <= tau -> 0 < u s) -> theta 0 <> 0 -> theta 0 <> PI -> lam <> 1 -> lam + cos (theta 0) <> 0 ->
  tau = right_sphere_time lam gamma (u 0) (theta 0) (theta tau).
Proof. exact (eq_13 gamma lam _ _ u theta hG hl M P tau). Qed.
(* The print, which lacks gamma, holds exactly where gamma is 1. *)
Theorem eq_82__printed tau : 0 < tau -> (forall s, 0 <= s <= tau -> 0 < u s) -> theta 0 <> 0 -> theta 0 <> PI -> lam <> 1 -> lam + cos (theta 0) <> 0
    ->
  (tau = eq82_time lam (u 0) (theta 0) (theta tau) <-> gamma = 1).
Proof.
  intros Ht H n0 n1 l1 n2. pose proof pulled_facts as (g0 & l0 & _). pose proof (eq_82 tau ltac:(lra) H n0 n1 l1 n2) as E.
  unfold right_sphere_time in E. unfold eq82_time. set (c := _ / _ * _ - 1) in *. assert (n3 : 1 - lam ^ 2 <> 0) by nra.
  replace (_ / (1 - lam ^ 2) * c) with (gamma * tau) by (rewrite E; field; lra). split; intros K; nra.
Qed.
(* The slip speed against time and angle, up to the moment at which the slip ends. *)
Theorem eq_83 tau : 0 <= tau -> (forall s, 0 <= s < tau -> 0 < u s) -> lam + cos (theta tau) <> 0 ->
  u tau = right_sphere_slip_at_time lam gamma (u 0) (theta 0) (theta tau) tau.
Proof. exact (eq_14 gamma lam _ _ u theta hG hl M P tau). Qed.
(* The print lacks the same gamma: it holds where gamma or lambda is 1, and there only. *)
Theorem eq_83__printed tau : 0 < tau -> (forall s, 0 <= s < tau -> 0 < u s) -> lam + cos (theta tau) <> 0 ->
  (u tau = eq83_slip_at_time lam (u 0) (theta 0) (theta tau) tau <-> gamma = 1 \/ lam = 1).
Proof.
  intros Ht H n. rewrite (eq_83 tau ltac:(lra) H n). pose proof pulled_facts as (_ & l0 & _). unfold right_sphere_slip_at_time, eq83_slip_at_time.
      split.
  - intros K. apply Rmult_eq_reg_r in K; [ | now apply Rinv_neq_0_compat ]. destruct (Req_dec lam 1); [ now right | left ].
    apply (Rmult_eq_reg_l ((1 - lam ^ 2) * tau)); [ lra | ]. apply Rmult_integral_contrapositive. split; nra.
  - intros [-> | ->]; f_equal; ring.
Qed.

End Pulled.

(* a sphere that slides across at first, with b = 2, lambda = 1/2, gamma = 4 *)
Lemma thrown_across : exists vx vy ox oy u theta,
  sphere 1 1 1 (1 * 1) (fun _ => eq3_acceleration_1 4) (fun _ => eq3_acceleration_2 4) vx vy ox oy (fun _ => 1) /\
  polar (u_1 1 1 1 vx vy ox oy) (u_2 1 1 1 vx vy ox oy) u theta /\ theta 0 = PI / 2 /\ eq80_lambda (eq67_factor (eq62_kappa 1 1 1)) 1 1 4 = / 2 /\
  forall tau, 0 <= tau -> 0 < u tau /\ / 2 + cos (theta tau) <> 0.
Proof.
  destruct (pull_has_a_motion 4 (/ 2) 1 (PI / 2)) as (x & y & u & theta & M & P & u0 & th); try (pose proof PI_RGT_0; lra).
  assert (pos : forall t, 0 <= t -> 0 < u t)
    by (intros; eapply (goes 4 (/ 2) x y u theta); try eassumption; try lra; rewrite th; pose proof PI_RGT_0; lra).
  assert (x0 : x 0 = 0) by (destruct (P 0 (Rle_refl 0)) as (_ & _ & e & _); rewrite e, th; unfold eq4_velocity_1; rewrite cos_PI2; ring).
  assert (I : forall c, primitive (RInt (fun _ => c) 0) (fun _ => c)) by (intros; apply primitive_of; intros; cont).
  assert (M' : motion (factor 1 1 1 * (1 * 1)) (fun _ => eq3_acceleration_1 4) (fun _ => eq3_acceleration_2 4) x y)
    by (replace (factor 1 1 1 * (1 * 1)) with (4 * / 2) by (unfold factor, eq67_factor, eq62_kappa; field); exact M).
  destruct (sphere_with_slip 1 1 1 (1 * 1) Rlt_0_1 Rlt_0_1 Rlt_0_1 _ _ x y _ _ 0 0 1 M' (I _) (I _)) as (vx & vy & ox & oy & S & ex & ey & _).
  assert (E : u_1 1 1 1 vx vy ox oy = x /\ u_2 1 1 1 vx vy ox oy = y) by (split; extensionality t; unfold u_1, u_2, eq71_slip_1, eq71_slip_2, clock;
      cbv zeta;
    rewrite ?ex, ?ey, !Rmult_1_l, Rdiv_1, sqrt_1, Rdiv_1, !Rmult_1_l; trivial).
  exists vx, vy, ox, oy, u, theta. destruct E as [-> ->]. repeat (split; trivial); [ unfold eq80_lambda, eq67_factor, eq62_kappa; field | now apply pos | ].
  pose proof (moved 4 (/ 2) x y u ltac:(lra) ltac:(lra) M (polar_speed x y u theta P) tau ltac:(trivial)) as r.
  destruct (P tau ltac:(trivial)) as (_ & _ & e & _). unfold eq4_velocity_1 in e. intros z. replace (cos (theta tau)) with (- / 2) in e by lra.
  rewrite x0, u0, e in r. enough (/ 2 * 1 + 0 + (1 - (/ 2) ^ 2) * 4 * tau = 0) by lra. rewrite <- r; [ field | ].
  intros t Ht. apply Rgt_not_eq, pos; lra.
Qed.
Ltac thrown := intros H; destruct thrown_across as (vx & vy & ox & oy & u & theta & S & P & th & el & R); pose proof PI_RGT_0;
  apply (H 1 1 1 1 1 4 _ _ _ _ _ u theta ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) S P 1);
  rewrite ?el, ?th, ?cos_PI2; try lra; [ intros; apply R; lra | .. ]; apply R; lra.
Lemma eq_81__occurs : ltac:(occurs eq_81).
Proof. thrown. Qed.
Lemma eq_82__occurs : ltac:(occurs eq_82).
Proof. thrown. Qed.
Lemma eq_82__printed__occurs : ltac:(occurs eq_82__printed).
Proof. thrown. Qed.
Lemma eq_83__occurs : ltac:(occurs eq_83).
Proof. thrown. Qed.
Lemma eq_83__printed__occurs : ltac:(occurs eq_83__printed).
Proof. thrown. Qed.

(* ---- the reduction ---- *)
(* A sphere moves so, and only so: the slip velocity is a particle's velocity under the same A with b mu for mu, rolling being rest; the velocity of
  the
   centre is then (79), nu being any integral of A; the spin (75), with a constant about the vertical. *)
Theorem s3_reduction m J rad mu g Ax Ay nux nuy vx vy ox oy oz : 0 < m -> 0 < J -> 0 < rad -> primitive nux Ax -> primitive nuy Ay ->
  let b := eq67_factor (eq62_kappa J m rad) in let ux := slip_x rad vx oy in let uy := slip_y rad vy ox in
  sphere m J rad (mu * g) Ax Ay vx vy ox oy oz <->
  motion (b * mu * g) Ax Ay ux uy /\
  (exists cx cy, forall t, 0 <= t -> let velocity f := f b (nux t) (nuy t) 0 (ux t) (uy t) 0 cx cy 0 in vx t = velocity eq79_velocity_1 /\
    vy t = velocity eq79_velocity_2) /\
  (forall t, 0 <= t -> let spin f := f (rad * oz 0) (ux t) (uy t) 0 (vx t) (vy t) 0 in
    rad * ox t = spin right_sphere_spin_1 /\ rad * oy t = spin right_sphere_spin_2 /\ rad * oz t = spin right_sphere_spin_3).
Proof.
  intros hm hJ hr P1 P2 b ux uy. destruct (factor_is m J rad hm hJ hr) as [_ b1]. change (factor m J rad) with b in b1.
    unfold right_sphere_spin_1, right_sphere_spin_2, right_sphere_spin_3, eq79_velocity_1, eq79_velocity_2. cbv zeta beta.
  replace (b * mu * g) with (b * (mu * g)) by ring. split.
  - intros S. split; [ exact (slip_moves m J rad (mu * g) hm hJ hr _ _ _ _ _ _ _ S) | split ].
    + exists (vx 0 + (1 - / b) * nux 0 - ux 0 * / b), (vy 0 + (1 - / b) * nuy 0 - uy 0 * / b). intros t Ht.
      destruct (kept m J rad (mu * g) hm hJ hr _ _ _ _ _ _ _ _ _ t S P1 P2 Ht) as [K1 K2]. change (factor m J rad) with b in K1, K2. fold ux in K1.
          fold uy in K2.
      rewrite <- K1, <- K2. split; field; lra.
    + intros t Ht. rewrite (spin_z m J rad (mu * g) hJ _ _ _ _ _ _ _ t S Ht). unfold ux, uy, slip_x, slip_y. repeat split; ring.
  - intros (M & (cx & cy & V) & Z). apply (sphere_of_slip m J rad (mu * g) hm hJ hr Ax Ay vx vy ox oy oz nux nuy cx cy); trivial.
    + intros t Ht. destruct (V t Ht) as [-> _]. change (factor m J rad) with b. fold ux. field. lra.
    + intros t Ht. destruct (V t Ht) as [_ ->]. change (factor m J rad) with b. fold uy. field. lra.
    + intros t Ht. destruct (Z t Ht) as (_ & _ & e). apply (Rmult_eq_reg_l rad); lra.
Qed.
Lemma s3_reduction__occurs : ltac:(occurs s3_reduction).
Proof. intros H. pose (f := fun _ : R => 0). apply (H 1 1 1 1 1 f f f f f f f f f); try lra; (split; intros; unfold f; [ cont | rd ]). Qed.

(* ---- 3.2: the plane is shaken, (21), from any moment t0 of the drive on ---- *)
(* Of every sphere with some friction, from some time on: in each period of the drive its slip along the drive is zero at two instants, or on two
   intervals, on which it rolls, or it rolls for good. A period may begin at any phase but those of the zeros of (38) in the first case, in which the
       slip
   across the drive fades away; in the second it is counted from the end of a rolling. Where the slip is zero the centre moves as the spin has it. *)
Theorem s32_rolling_trichotomy m J rad mu g A0 varpi t0 lam vx vy ox oy oz : 0 < m -> 0 < J -> 0 < rad -> 0 < A0 -> 0 < varpi ->
  lam = eq84_lambda (eq67_factor (eq62_kappa J m rad)) mu g A0 -> 0 < lam ->
  sphere m J rad (mu * g) (fun t => eq21_acceleration_1 A0 varpi (t0 + t)) (fun t => eq21_acceleration_2 A0 varpi (t0 + t)) vx vy ox oy oz ->
  let ux := slip_x rad vx oy in let uy := slip_y rad vy ox in let T := 2 * PI / varpi in
  let at_ phi t := at_phase (eq23_phase varpi t0) (eq23_phase varpi t) phi in
  (lam < eq37_lambda_c -> is_lim uy p_infty 0 /\ forall phi, (forall n, phi <> eq39_phi_t1 lam + IZR n * PI) -> exists t1, forall t, t1 <= t -> at_
      phi t ->
    exists z1 z2, t < z1 < z2 /\ z2 < t + T /\ forall z, t <= z <= t + T -> (ux z = 0 <-> z = z1 \/ z = z2)) /\
  (eq37_lambda_c < lam < 1 -> exists d t1, 0 < d < T / 2 /\ slip_end lam (eq27_phi1 lam + eq23_phase varpi d) /\
    forall t, t1 <= t -> at_ (eq27_phi1 lam) t -> forall z, t < z <= t + T ->
    (ux z = 0 <-> t + d <= z <= t + T / 2 \/ t + T / 2 + d <= z <= t + T) /\ (ux z = 0 -> uy z = 0)) /\
  (1 <= lam -> exists t1, forall t, t1 <= t -> ux t = 0 /\ uy t = 0) /\ forall t, ux t = 0 /\ uy t = 0 -> vx t = rad * oy t /\ vy t = - rad * ox t.
Proof.
  intros hm hJ hr hA hv el h0 S ux uy T at_. pose proof PI_RGT_0.
  pose proof (slip_driven m J rad mu g A0 varpi t0 sin hm hJ hr hA hv vx vy ox oy oz S) as M. rewrite <- el in M. unfold moves in M. rewrite <-
      shaken_sin in M.
  set (w := w_x A0 varpi rad vx oy) in *. set (wy := w_y A0 varpi rad vy ox) in *. assert (c : 0 < A0 / varpi) by now apply Rdiv_lt_0_compat.
  assert (ex : forall t, ux t = A0 / varpi * w (varpi * t)) by exact (of_w A0 varpi hA hv ux).
  assert (ey : forall t, uy t = A0 / varpi * wy (varpi * t)) by exact (of_w A0 varpi hA hv uy).
  assert (zx : forall t, ux t = 0 <-> w (varpi * t) = 0) by (intros t; rewrite ex; split; [ intros; apply (Rmult_eq_reg_l (A0 / varpi)); lra | intros
      ->; ring ]).
  assert (zy : forall t, wy (varpi * t) = 0 -> uy t = 0) by (intros t e; rewrite ey, e; ring).
  assert (per : varpi * T = 2 * PI) by (unfold T; field; lra).
  assert (late : forall s1 t, s1 / varpi <= t -> s1 <= varpi * t) by (intros s1 t k; rewrite Rmult_comm; now apply Rle_div_l).
  destruct (s22_trichotomy lam _ w wy h0 M) as (K1 & K2 & K3). unfold at_, eq23_phase. split; [ | split; [ | split ] ].
  - intros hc. split.
    + apply (is_lim_ext (fun t => A0 / varpi * wy (varpi * t))); [ intros; now rewrite ey | ]. apply lim_units; trivial. now apply (eq_38 lam _ w wy
        ltac:(lra) M).
    + intros phi ne. destruct (K1 hc phi ne) as (s1 & Z). exists (s1 / varpi). intros t Ht ph. destruct (Z _ (late _ _ Ht) ph) as (z1 & z2 & a & b &
        E).
      exists (z1 / varpi), (z2 / varpi). rewrite <- per in *.
      assert (d1 : varpi * (z1 / varpi) = z1) by (field; lra). assert (d2 : varpi * (z2 / varpi) = z2) by (field; lra).
      split; [ | split ]; try (split; apply (Rmult_lt_reg_l varpi); lra); [ apply (Rmult_lt_reg_l varpi); lra | ]. intros z Hz. rewrite zx, E by nra.
      split; (intros [k | k]; [ left | right ]); [ apply (Rmult_eq_reg_l varpi) .. | | ]; try lra; rewrite k; lra.
  - intros hc. pose proof lambda_c_between. destruct (K2 hc) as (d & s1 & hd & E & Z). destruct (slip_end_exists lam ltac:(lra)) as [e E'].
    destruct (eq_33 lam e _ w wy ltac:(lra) E' (proj1 (eq_36 lam e ltac:(lra) E') (proj1 hc)) M) as (_ & s2 & R). exists (d / varpi), (Rmax s1 s2 /
        varpi).
    assert (d1 : varpi * (d / varpi) = d) by (field; lra). assert (d2 : varpi * (T / 2) = PI) by lra. rewrite d1.
    split; [ split; apply (Rmult_lt_reg_l varpi); lra | split; [ trivial | ] ]. intros t Ht ph z Hz. apply late in Ht. pose proof (Rmax_l s1 s2).
        pose proof (Rmax_r s1 s2).
    assert (up : forall a b, a <= b -> varpi * a <= varpi * b) by (intros; apply Rmult_le_compat_l; lra).
    pose proof (Rmult_lt_compat_l varpi _ _ hv (proj1 Hz)). pose proof (up _ _ (proj2 Hz)).
    split; [ | intros _; apply zy, R; lra ]. rewrite zx, (Z (varpi * t) ltac:(lra) ph) by lra.
    split; (intros [[k k'] | [k k']]; [ left | right ]); try (split; apply (Rmult_le_reg_l varpi); lra); apply up in k, k'; lra.
  - intros h1. destruct (all_stop lam _ w wy h1 M) as (s1 & _ & R). exists (s1 / varpi). intros t Ht. destruct (R _ (late _ _ Ht)). now split; [
      apply zx | apply zy ].
  - unfold ux, uy, slip_x, slip_y. intros t [e1 e2]. lra.
Qed.
Lemma s32_rolling_trichotomy__occurs : ltac:(occurs s32_rolling_trichotomy).
Proof.
  intros H. destruct (sphere_exists 1 1 1 (/ 4 * 1) (fun t => eq21_acceleration_1 1 1 (0 + t)) (fun t => eq21_acceleration_2 1 1 (0 + t)) 1 1 0 0 0)
      as
    (vx & vy & ox & oy & S & _); try lra; [ intros t; unfold eq21_acceleration_1, eq21_acceleration_2; split; [ apply derivable_continuous_pt; reg |
        cont ] | ].
  apply (H 1 1 1 (/ 4) 1 1 1 0 (/ 2) vx vy ox oy (fun _ => 0)); trivial; unfold eq84_lambda, eq67_factor, eq62_kappa; lra.
Qed.
(* The motion that is approached up to lambda_c: a sphere that slips along the drive only, by (38), and rolls at two instants per period. *)
Theorem s32_rolling_trichotomy__approached m J rad mu g A0 varpi t0 lam : 0 < m -> 0 < J -> 0 < rad -> 0 < A0 -> 0 < varpi ->
  lam = eq84_lambda (eq67_factor (eq62_kappa J m rad)) mu g A0 -> 0 < lam <= eq37_lambda_c ->
  let S := sphere m J rad (mu * g) (fun t => eq21_acceleration_1 A0 varpi (t0 + t)) (fun t => eq21_acceleration_2 A0 varpi (t0 + t)) in
  exists px py qx qy qz, S px py qx qy qz /\ (forall t, eq24_w varpi (slip_x rad px qy t) A0 = w38 lam (eq23_phase varpi (t0 + t)) /\
    slip_y rad py qx t = 0 /\ (rolls rad px py qx qy t <-> exists n, eq23_phase varpi (t0 + t) = eq39_phi_t1 lam + IZR n * PI)) /\
  forall vx vy ox oy oz, S vx vy ox oy oz -> is_lim (fun t => slip_x rad vx oy t - slip_x rad px qy t) p_infty 0 /\ is_lim (slip_y rad vy ox) p_infty
      0.
Proof.
  intros hm hJ hr hA hv el hl S. pose proof (w38_motion lam hl (eq23_phase varpi t0)) as W. rewrite shaken_sin, el in W.
  assert (I : forall phi, continuity_pt (fun s => - cos s) phi /\ rder (fun s => - cos s) phi (sin phi)).
  { intros phi. assert (D : is_derive (fun s => - cos s) phi (sin phi)) by (auto_derive; trivial; ring). split; [ now apply (cont_of _ _ _ D) | now
      apply rder_of ]. }
  destruct (sphere_driven m J rad mu g A0 varpi t0 sin hm hJ hr hA hv _ _ _ I W) as (px & py & qx & qy & qz & Sp & e1 & e2). rewrite <- el in e1.
      exists px, py, qx, qy, qz.
  assert (c : 0 < A0 / varpi) by now apply Rdiv_lt_0_compat. assert (E : forall t, varpi * t / varpi = t) by (intros; field; lra).
  assert (x : forall t, eq24_w varpi (slip_x rad px qy t) A0 = w38 lam (eq23_phase varpi (t0 + t))).
  { intros t. transitivity (w_x A0 varpi rad px qy (varpi * t)); [ unfold w_x; now rewrite E | rewrite e1; unfold eq23_phase; f_equal; ring ]. }
  assert (y : forall t, slip_y rad py qx t = 0) by (intros t; rewrite (of_w A0 varpi hA hv); change (A0 / varpi * w_y A0 varpi rad py qx (varpi * t)
      = 0); rewrite e2; ring).
  split; [ exact Sp | split; [ intros t; split; [ apply x | split; [ apply y | ] ] | ] ].
  - rewrite <- (w38_zeros lam hl), <- x. unfold rolls. rewrite y. unfold eq24_w. split; [ intros [-> _]; field; lra | intros z; split; trivial ].
    apply (Rmult_eq_reg_l (varpi / A0)); [ transitivity (varpi * slip_x rad px qy t / A0); [ field; lra | rewrite z; ring ] | apply Rgt_not_eq; now
        apply Rdiv_lt_0_compat ].
  - intros vx vy ox oy oz Sv. apply slip_driven in Sv; trivial. unfold moves in Sv. rewrite <- el, <- shaken_sin in Sv.
    destruct (w38_attracts lam hl _ _ _ Sv) as [X Y].
    apply (lim_units _ (A0 / varpi) varpi hv) in X, Y. split; [ refine (is_lim_ext _ _ _ _ _ X) | refine (is_lim_ext _ _ _ _ _ Y) ]; intros t; cbv
        beta.
    + rewrite (of_w A0 varpi hA hv (slip_x rad vx oy)), (of_w A0 varpi hA hv (slip_x rad px qy)).
      fold (w_x A0 varpi rad vx oy (varpi * t)) (w_x A0 varpi rad px qy (varpi * t)). rewrite e1. ring.
    + symmetry. exact (of_w A0 varpi hA hv (slip_y rad vy ox) t).
Qed.
Lemma s32_rolling_trichotomy__approached__occurs : ltac:(occurs s32_rolling_trichotomy__approached).
Proof. intros H. pose proof quarter. apply (H 1 1 1 (/ 8) 1 1 1 0 (/ 4)); unfold eq84_lambda, eq67_factor, eq62_kappa; lra. Qed.

(* ---- 3.3, 3.4 ---- *)
(* A sphere under A0 h(varpi t) along a line, h having an integral H, from any moment t0 of the drive on. Whatever holds of the velocities of all
   particles under h with lambda_0 of (84) in the place of (22) holds of the slip velocities of all such spheres, in the same units, and the other way
   round; the sphere rolls when the particle rests. *)
Theorem s33_any_drive m J rad mu g A0 varpi t0 h H (P : (R -> R) -> (R -> R) -> Prop) : 0 < m -> 0 < J -> 0 < rad -> 0 < A0 -> 0 < varpi ->
  (forall phi, continuity_pt H phi /\ rder H phi (h phi)) ->
  ((forall vx vy ox oy oz, sphere m J rad (mu * g) (fun t => - A0 * h (eq23_phase varpi (t0 + t))) (fun _ => 0) vx vy ox oy oz ->
    P (w_x A0 varpi rad vx oy) (w_y A0 varpi rad vy ox)) <->
   (forall wx wy, moves (eq84_lambda (eq67_factor (eq62_kappa J m rad)) mu g A0) h (eq23_phase varpi t0) wx wy -> P wx wy)) /\
  (forall vx vy ox oy t, rolls rad vx vy ox oy t <-> w_x A0 varpi rad vx oy (varpi * t) = 0 /\ w_y A0 varpi rad vy ox (varpi * t) = 0).
Proof.
  intros hm hJ hr hA hv I. split; [ split; intros K | intros; now apply rolls_at ].
  - intros wx wy M. destruct (sphere_driven m J rad mu g A0 varpi t0 h hm hJ hr hA hv H wx wy I M) as (vx & vy & ox & oy & oz & S & <- & <-).
    now apply (K vx vy ox oy oz).
  - intros vx vy ox oy oz S. apply K. now apply (slip_driven m J rad mu g A0 varpi t0 h hm hJ hr hA hv vx vy ox oy oz).
Qed.
Lemma s33_any_drive__occurs : ltac:(occurs s33_any_drive).
Proof.
  intros H. destruct (pulse_integral (/ 2)) as [F I]; [ lra | ]. apply (H 1 1 1 1 1 1 1 0 (pulse (/ 2)) F (fun _ _ => True)); trivial; lra.
Qed.
(* Above lambda_0 = 1, |h| being at most 1, it rolls for good, from the time on that its slip at the start takes to go. *)
Theorem s33_any_drive__above_one m J rad mu g A0 varpi t0 h lam vx vy ox oy oz t : 0 < m -> 0 < J -> 0 < rad -> 0 < A0 ->
  (forall phi, Rabs (h phi) <= 1) ->
  lam = eq84_lambda (eq67_factor (eq62_kappa J m rad)) mu g A0 -> 1 < lam ->
  sphere m J rad (mu * g) (fun t => - A0 * h (eq23_phase varpi (t0 + t))) (fun _ => 0) vx vy ox oy oz ->
  nrm (slip_x rad vx oy 0) (slip_y rad vy ox 0) / ((lam - 1) * A0) <= t -> rolls rad vx vy ox oy t.
Proof.
  intros hm hJ hr hA hh el hl S Ht. apply (slip_moves m J rad (mu * g) hm hJ hr) in S.
  assert (e : factor m J rad * (mu * g) = lam * A0) by (rewrite el; unfold eq84_lambda, factor; field; lra). rewrite e in S.
  apply (weak_stops (lam * A0) A0 _ _ _ _ ltac:(nra) S); [ | now replace (lam * A0 - A0) with ((lam - 1) * A0) by ring ].
  intros s _. rewrite nrm_x, Rabs_mult, Rabs_Ropp, Rabs_pos_eq by lra. specialize (hh (eq23_phase varpi (t0 + s))). nra.
Qed.
Lemma s33_any_drive__above_one__occurs : ltac:(occurs s33_any_drive__above_one).
Proof.
  intros H. destruct (sphere_exists 1 1 1 (1 * 1) (fun _ => - (1) * 1) (fun _ => 0) 1 0 0 0 0) as (vx & vy & ox & oy & S & e1 & e2 & _); try lra; [
      split; cont | ].
  apply (H 1 1 1 1 1 1 1 0 (fun _ => 1) 2 vx vy ox oy (fun _ => 0) 1); trivial; try lra.
  - intros _. rewrite Rabs_R1. lra.
  - unfold eq84_lambda, eq67_factor, eq62_kappa. field.
  - rewrite e1, e2, nrm_x0; lra.
Qed.
(* Under the pulses (42), (43), from any moment of the drive on: every sphere has intervals of rolling, as late as one likes, exactly where lambda_0
   of (84) exceeds the same lambda_c = eta as the particle's. *)
Theorem s33_pulse m J rad mu g A0 varpi eta t0 lam vx vy ox oy oz : 0 < m -> 0 < J -> 0 < rad -> 0 < A0 -> 0 < varpi -> 0 < eta < 1 ->
  lam = eq84_lambda (eq67_factor (eq62_kappa J m rad)) mu g A0 -> 0 < lam ->
  sphere m J rad (mu * g) (fun t => - A0 * pulse eta (eq23_phase varpi (t0 + t))) (fun _ => 0) vx vy ox oy oz ->
  ((forall t1, exists s d, t1 <= s /\ 0 < d /\ forall t, s <= t <= s + d -> rolls rad vx vy ox oy t) <-> eq46_lambda_c eta < lam).
Proof.
  intros hm hJ hr hA hv he el h0 S. apply slip_driven in S; trivial. rewrite <- el in S. rewrite <- (rests_above eta lam _ _ _ he h0 S).
  assert (E : forall s, varpi * (s / varpi) = s) by (intros; field; lra). assert (up : forall s t, s <= t -> varpi * s <= varpi * t) by (intros;
      apply Rmult_le_compat_l; lra).
  split; intros K t1.
  - destruct (K (t1 / varpi)) as (s & d & Hs & Hd & Z). exists (varpi * s), (varpi * d). apply up in Hs. rewrite E in Hs.
    split; [ trivial | split; [ now apply Rmult_lt_0_compat | ] ]. intros t Ht. specialize (E t). rewrite <- E.
    apply rolls_at, Z; trivial. split; apply (Rmult_le_reg_l varpi); lra.
  - destruct (K (varpi * t1)) as (s & d & Hs & Hd & Z). exists (s / varpi), (d / varpi). pose proof (E s). pose proof (E d).
    split; [ apply (Rmult_le_reg_l varpi); lra | split; [ now apply Rdiv_lt_0_compat | ] ].
    intros t [H1 H2]. apply up in H1, H2. apply (proj2 (rolls_at rad A0 varpi hA hv vx vy ox oy t)), Z. lra.
Qed.
Lemma s33_pulse__occurs : ltac:(occurs s33_pulse).
Proof.
  intros H. destruct (pulses_at_large_times (/ 2) (3 / 4)) as [W L]; try lra. destruct (pulse_integral (/ 2)) as [F I]; [ lra | ].
  assert (e : 3 / 4 = eq84_lambda (eq67_factor (eq62_kappa 1 1 1)) (3 / 8) 1 1) by (unfold eq84_lambda, eq67_factor, eq62_kappa; field).
  pose proof (late_moves _ _ _ L (eq23_phase 1 0)) as M. rewrite e in M.
  destruct (sphere_driven 1 1 1 (3 / 8) 1 1 1 0 (pulse (/ 2)) Rlt_0_1 Rlt_0_1 Rlt_0_1 Rlt_0_1 Rlt_0_1 F _ _ I M) as (vx & vy & ox & oy & oz & S & _).
  apply (H 1 1 1 (3 / 8) 1 1 1 (/ 2) 0 (3 / 4) vx vy ox oy oz); trivial; lra.
Qed.
(* Friction mu_plus forward and mu_minus backward, drive (21): whatever holds of all velocities of the particle of 2.4 with lambda_0 of (85) and
   q = mu_minus / mu_plus, its regions with them, holds of all slip velocities of spheres along the line, and the other way round. *)
Theorem s34_anisotropic m J rad mu_plus mu_minus g A0 varpi t0 (P : (R -> R) -> Prop) : 0 < m -> 0 < J -> 0 < rad -> 0 < mu_plus -> 0 < g ->
  0 < A0 -> 0 < varpi ->
  let lam := eq85_lambda (eq67_factor (eq62_kappa J m rad)) mu_plus g A0 in
  (forall v o, sphere_on_line m J rad (mu_plus * g) (mu_minus * g) (eq21_acceleration_1 A0 varpi) t0 v o -> P (w_x A0 varpi rad v o)) <->
  (forall w, line (eq49_lambda_plus lam) (eq50_lambda_minus (mu_minus / mu_plus) lam) sin (varpi * t0) w -> P w).
Proof.
  intros hm hJ hr hmu hg hA hv lam. assert (p : 0 < A0 / varpi) by now apply Rdiv_lt_0_compat.
    assert (p' : 0 < varpi / A0) by now apply Rdiv_lt_0_compat. assert (0 < / varpi) by now apply Rinv_0_lt_compat.
  unfold eq49_lambda_plus, eq50_lambda_minus. split; intros K.
  - intros w L. apply (line_in_units (A0 / varpi) varpi _ _ _ _ _ (factor m J rad * (mu_plus * g)) (factor m J rad * (mu_minus * g))
      (fun t => - eq21_acceleration_1 A0 varpi t) t0 (fun t => A0 / varpi * w (varpi * t))) in L; trivial.
    + destruct (on_line_with_slip m J rad hm hJ hr (mu_plus * g) (mu_minus * g) (eq21_acceleration_1 A0 varpi) (fun t => A0 / varpi * cos (varpi *
      t)) t0 (fun t => A0 / varpi * w (varpi * t))) with (2 := L) as (v & o & S & e).
      * intros t. unfold eq21_acceleration_1. auto_derive; trivial. field. lra.
      * replace w with (w_x A0 varpi rad v o); [ now apply K | ]. extensionality phi. unfold w_x. rewrite e. unfold eq24_w.
        replace (varpi * (phi / varpi)) with phi by (field; lra). field; lra.
    + unfold lam, eq85_lambda, factor. field. lra.
    + unfold lam, eq85_lambda, factor. field. lra.
    + intros t. unfold eq21_acceleration_1. field. lra.
  - intros v o S. apply K. apply slip_on_line in S; trivial.
    apply (line_in_units (varpi / A0) (/ varpi) _ _ _ _ _ lam (mu_minus / mu_plus * lam) sin (varpi * t0) (w_x A0 varpi rad v o)) in S; trivial.
    + unfold lam, eq85_lambda, factor. field. lra.
    + unfold lam, eq85_lambda, factor. field. lra.
    + intros t. unfold eq21_acceleration_1. replace (varpi * (/ varpi * t)) with t by (field; lra). field. lra.
    + field. lra.
    + intros t. unfold w_x, eq24_w. rewrite (Rmult_comm (/ varpi)). unfold Rdiv. ring.
Qed.
Lemma s34_anisotropic__occurs : ltac:(occurs s34_anisotropic).
Proof. intros H. apply (H 1 1 1 1 2 1 1 1 0 (fun _ => True)); lra. Qed.
