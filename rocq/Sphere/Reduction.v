(* The sphere: Newton's law for its centre and its spin, Coulomb's law at the point of contact. Its slip velocity is a particle's velocity with b mu
   for mu; the velocity of the centre follows from it up to a constant, (79), and back: so where particles have motions, spheres have them. *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas Exists Analysis.
Open Scope R_scope.

(* dr/dt + omega x R of (61), (71): the velocity, along x, of the point of contact, (0, 0, - rad) from the centre, against the plane *)
Definition slip_x (rad : R) (vx oy : R -> R) (t : R) : R := vx t - rad * oy t.
(* and along y *)
Definition slip_y (rad : R) (vy ox : R -> R) (t : R) : R := vy t + rad * ox t.

(* (59), (60) with Coulomb's law at the contact, rolling included: mass m, moment of inertia J, radius rad, mu g = k. The plane has the acceleration
   (Ax, Ay), the centre the velocity (vx, vy) against the plane, the sphere the angular velocity (ox, oy, oz); the friction is (Fx, Fy).
   «a sphere of the mass $m$, the moment of inertia $J$ and the radius $rad$, with $\mu g=k$, has the velocity $(vx,vy)$ and the angular velocity
   $(ox,oy,oz)$ on a plane that has the acceleration $(Ax,Ay)$» *)
Record sphere (m J rad k : R) (Ax Ay vx vy ox oy oz : R -> R) : Prop := {
  b_c : forall t, 0 < t -> continuity_pt vx t /\ continuity_pt vy t /\ continuity_pt ox t /\ continuity_pt oy t /\ continuity_pt oz t;
  b_law : forall t, 0 <= t -> exists Fx Fy, coulomb (m * k) (slip_x rad vx oy t) (slip_y rad vy ox t) Fx Fy /\
    rder vx t (eq59_momentum_rate_1 m (Ax t) (Ay t) 0 Fx Fy 0 / m) /\ rder vy t (eq59_momentum_rate_2 m (Ax t) (Ay t) 0 Fx Fy 0 / m) /\
    rder ox t (eq60_spin_rate_1 0 0 (- rad) Fx Fy 0 / J) /\ rder oy t (eq60_spin_rate_2 0 0 (- rad) Fx Fy 0 / J) /\
    rder oz t (eq60_spin_rate_3 0 0 (- rad) Fx Fy 0 / J) }.
(* the point of contact is at rest on the plane; else the sphere slides. «the sphere rolls at $t$» *)
Definition rolls (rad : R) (vx vy ox oy : R -> R) (t : R) : Prop := slip_x rad vx oy t = 0 /\ slip_y rad vy ox t = 0.
(* b of (67), by (62): dimensionless, 7/2 for a solid sphere *)
Definition factor (m J rad : R) : R := eq67_factor (eq62_kappa J m rad).
(* (76): nu' = A, A may jump. «$nu$ is an integral of $A$» *)
Definition primitive (nu A : R -> R) : Prop := (forall t, 0 < t -> continuity_pt nu t) /\ (forall t, 0 <= t -> rder nu t (A t)).

Lemma primitive_of A : (forall t, continuity_pt A t) -> primitive (RInt A 0) A.
Proof. intros C. split; intros t _; [ eapply cont_of | apply rder_of ]; now apply primitive_rate. Qed.

Ltac laws := unfold eq59_momentum_rate_1, eq59_momentum_rate_2, eq60_spin_rate_1, eq60_spin_rate_2, eq60_spin_rate_3 in *.

(* ---- Coulomb's law in other units ---- *)
Lemma coulomb_force c k ux uy fx fy : coulomb k ux uy fx fy -> coulomb (c * k) ux uy (c * fx) (c * fy).
Proof.
  intros [B P]. split. 2: transitivity (c * (fx * ux + fy * uy)); [ ring | rewrite P; ring ].
  replace ((c * fx) ^ 2 + (c * fy) ^ 2) with (c ^ 2 * (fx ^ 2 + fy ^ 2)) by ring. rewrite Rpow_mult_distr.
    apply Rmult_le_compat_l; [ apply pow2_ge_0 | exact B ].
Qed.
Lemma coulomb_velocity c k ux uy fx fy : 0 <= c -> coulomb k ux uy fx fy -> coulomb k (c * ux) (c * uy) fx fy.
Proof. intros hc [B P]. split; trivial. rewrite nrm_scale by trivial. transitivity (c * (fx * ux + fy * uy)); [ ring | rewrite P; ring ]. Qed.
(* the same motion in other units: 1 / c that of velocity, s that of time *)
Lemma motion_in_units c s k Ax Ay vx vy k' Bx By wx wy : 0 < c -> 0 < s -> motion k Ax Ay vx vy -> k' = c * s * k ->
  (forall t, Bx t = c * s * Ax (s * t)) -> (forall t, By t = c * s * Ay (s * t)) -> (forall t, wx t = c * vx (s * t)) ->
    (forall t, wy t = c * vy (s * t)) ->
  motion k' Bx By wx wy.
Proof.
  intros hc hs [cx cy L] -> eA eB ex ey. apply functional_extensionality in ex. apply functional_extensionality in ey. subst wx wy. split.
  - intros t Ht. apply (continuity_pt_mult (fun _ => c)); [ cont | apply cont_time, cx; nra ].
  - intros t Ht. apply (continuity_pt_mult (fun _ => c)); [ cont | apply cont_time, cy; nra ].
  - intros t Ht. destruct (L (s * t)) as (fx & fy & C & X & Y); [ nra | ]. exists (c * s * fx), (c * s * fy). rewrite eA, eB.
    split; [ apply coulomb_velocity; [ lra | now apply coulomb_force ] | ].
    apply rder_time in X; trivial. apply rder_time in Y; trivial.
    split; (eapply rder_eq; [ apply (rder_mult (fun _ => c)); [ rd | eassumption ] | ring ]).
Qed.

(* ---- the sphere ---- *)
Section Sphere.
Variables (m J rad k : R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad.
Notation b := (factor m J rad).
Lemma factor_is : b = 1 + m * rad ^ 2 / J /\ 1 < b.
Proof.
  assert (0 < m * rad ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; lra). assert (e : b = 1 + m * rad ^ 2 / J) by (unfold factor,
    eq67_factor, eq62_kappa; field; lra).
  split; trivial. rewrite e. assert (0 < m * rad ^ 2 / J) by now apply Rdiv_lt_0_compat. lra.
Qed.
Ltac lawful H := destruct H as (Fx & Fy & C & X & Y & OX & OY & OZ); laws.

Section Given.
Variables (Ax Ay vx vy ox oy oz : R -> R).
Lemma slip_moves : sphere m J rad k Ax Ay vx vy ox oy oz -> motion (b * k) Ax Ay (slip_x rad vx oy) (slip_y rad vy ox).
Proof.
  destruct factor_is as [eb b1]. intros [c L]. unfold slip_x, slip_y. split.
  - intros t Ht. destruct (c t Ht) as (c1 & c2 & c3 & c4 & _). cont.
  - intros t Ht. destruct (c t Ht) as (c1 & c2 & c3 & c4 & _). cont.
  - intros t Ht. lawful (L t Ht). exists (b / m * Fx), (b / m * Fy). split; [ | split ].
    + replace (b * k) with (b / m * (m * k)) by (field; lra). now apply coulomb_force.
    + eapply rder_eq; [ rd | rewrite eb; field; lra ].
    + eapply rder_eq; [ rd | rewrite eb; field; lra ].
Qed.
Lemma sliding t : 0 <= k -> sphere m J rad k Ax Ay vx vy ox oy oz -> 0 <= t -> ~ rolls rad vx vy ox oy t ->
  let u := slip_x rad vx oy t in let w := slip_y rad vy ox t in let n := nrm u w in 0 < n /\
  rder vx t (- Ax t - k * (u / n)) /\ rder vy t (- Ay t - k * (w / n)) /\ rder ox t (- (m * rad * k / J) * (w / n)) /\
    rder oy t (m * rad * k / J * (u / n)) /\ rder oz t 0.
Proof.
  intros hk S Ht N u w n. assert (n0 : 0 < n).
  { destruct (nrm_pos u w) as [p | p]; trivial. exfalso. apply N. pose proof (nrm_sq u w) as e. rewrite <- p in e. apply sq_sum. fold u w. lra. }
  split; trivial. lawful (b_law _ _ _ _ _ _ _ _ _ _ _ S t Ht). fold u w in C.
  apply coulomb_slip in C; [ | apply Rmult_le_pos; lra ]. fold n in C. destruct C as [C1 C2].
  assert (fx : Fx = - (m * k) * u / n) by (rewrite <- C1; field; lra). assert (fy : Fy = - (m * k) * w / n) by (rewrite <- C2; field; lra).
  rewrite fx, fy in *. repeat split; (eapply rder_eq; [ eassumption | field; lra ]).
Qed.
(* (79): nu' = A *)
Lemma kept nux nuy t : sphere m J rad k Ax Ay vx vy ox oy oz -> primitive nux Ax -> primitive nuy Ay -> 0 <= t ->
  vx t + (1 - / b) * nux t - slip_x rad vx oy t * / b = vx 0 + (1 - / b) * nux 0 - slip_x rad vx oy 0 * / b /\
  vy t + (1 - / b) * nuy t - slip_y rad vy ox t * / b = vy 0 + (1 - / b) * nuy 0 - slip_y rad vy ox 0 * / b.
Proof.
  destruct factor_is as [eb b1]. intros [c L] [cx Nx] [cy Ny] Ht. unfold slip_x, slip_y. assert (0 < m * rad ^ 2) by (apply Rmult_lt_0_compat; [ |
      apply pow_lt ]; lra).
  split; [ apply (rder_const (fun t => vx t + (1 - / b) * nux t - (vx t - rad * oy t) * / b))
    | apply (rder_const (fun t => vy t + (1 - / b) * nuy t - (vy t + rad * ox t) * / b)) ]; trivial; intros s Hs;
    try (destruct (c s ltac:(lra)) as (c1 & c2 & c3 & c4 & _); pose proof (cx s ltac:(lra)); pose proof (cy s ltac:(lra)); cont);
    lawful (L s ltac:(lra)); pose proof (Nx s ltac:(lra)); pose proof (Ny s ltac:(lra)); (eapply rder_eq; [ rd | rewrite eb; field; lra ]).
Qed.
Lemma spin_z t : sphere m J rad k Ax Ay vx vy ox oy oz -> 0 <= t -> oz t = oz 0.
Proof.
  intros [c L] Ht. apply rder_const; trivial; intros s Hs; [ now apply (c s) | ].
  lawful (L s ltac:(lra)). eapply rder_eq; [ exact OZ | field; lra ].
Qed.
(* and back *)
Lemma sphere_of_slip nux nuy cx cy : motion (b * k) Ax Ay (slip_x rad vx oy) (slip_y rad vy ox) -> primitive nux Ax -> primitive nuy Ay ->
  (forall t, 0 <= t -> vx t = - (1 - / b) * nux t + slip_x rad vx oy t * / b + cx) ->
  (forall t, 0 <= t -> vy t = - (1 - / b) * nuy t + slip_y rad vy ox t * / b + cy) ->
  (forall t, 0 <= t -> oz t = oz 0) -> sphere m J rad k Ax Ay vx vy ox oy oz.
Proof.
  destruct factor_is as [eb b1]. assert (pos : 0 < m * rad ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; lra).
  intros [cu cw L] [cn1 N1] [cn2 N2] ex ey ez. set (u := slip_x rad vx oy) in *. set (w := slip_y rad vy ox) in *.
  assert (eoy : forall s, (vx s - u s) * / rad = oy s) by (intros s; unfold u, slip_x; field; lra).
  assert (eox : forall s, (w s - vy s) * / rad = ox s) by (intros s; unfold w, slip_y; field; lra).
  assert (cx' : forall t, 0 < t -> continuity_pt vx t).
  { intros t Ht. pose proof (cn1 t Ht). pose proof (cu t Ht). apply (cont_ext (fun t => - (1 - / b) * nux t + u t * / b + cx)); [ lra | intros;
    symmetry; auto | cont ]. }
  assert (cy' : forall t, 0 < t -> continuity_pt vy t).
  { intros t Ht. pose proof (cn2 t Ht). pose proof (cw t Ht). apply (cont_ext (fun t => - (1 - / b) * nuy t + w t * / b + cy)); [ lra | intros;
    symmetry; auto | cont ]. }
  split.
  - intros t Ht. pose proof (cx' t Ht). pose proof (cy' t Ht). pose proof (cu t Ht). pose proof (cw t Ht). repeat split; trivial.
    + apply (continuity_pt_ext (fun s => (w s - vy s) * / rad)); trivial. cont.
    + apply (continuity_pt_ext (fun s => (vx s - u s) * / rad)); trivial. cont.
    + apply (cont_ext (fun _ => oz 0)); [ lra | intros; symmetry; auto | cont ].
  - intros t Ht. destruct (L t Ht) as (fx & fy & C & U & W). exists (m / b * fx), (m / b * fy). pose proof (N1 t Ht). pose proof (N2 t Ht).
    laws.
    assert (X : rder vx t (fx / b - Ax t)).
    { apply (rder_ext (fun t => - (1 - / b) * nux t + u t * / b + cx)); [ intros; symmetry; apply ex; lra | ]. eapply rder_eq; [ rd | field; lra ]. }
    assert (Y : rder vy t (fy / b - Ay t)).
    { apply (rder_ext (fun t => - (1 - / b) * nuy t + w t * / b + cy)); [ intros; symmetry; apply ey; lra | ]. eapply rder_eq; [ rd | field; lra ]. }
    split; [ | repeat split ].
    + replace (m * k) with (m / b * (b * k)) by (field; lra). now apply coulomb_force.
    + eapply rder_eq; [ exact X | field; lra ].
    + eapply rder_eq; [ exact Y | field; lra ].
    + apply (rder_ext (fun s => (w s - vy s) * / rad)); [ intros; apply eox | ]. eapply rder_eq; [ rd | rewrite eb; field; lra ].
    + apply (rder_ext (fun s => (vx s - u s) * / rad)); [ intros; apply eoy | ]. eapply rder_eq; [ rd | rewrite eb; field; lra ].
    + apply (rder_ext (fun _ => oz 0)); [ intros; symmetry; apply ez; lra | ]. eapply rder_eq; [ rd | field; lra ].
Qed.
End Given.

(* each particle's motion with b mu is the slip of a sphere with mu, whatever the velocity v0 of its centre and its spin about the vertical at the
  start *)
Lemma sphere_with_slip Ax Ay ux uy nux nuy v0x v0y w : motion (b * k) Ax Ay ux uy -> primitive nux Ax -> primitive nuy Ay ->
  exists vx vy ox oy, sphere m J rad k Ax Ay vx vy ox oy (fun _ => w) /\ slip_x rad vx oy = ux /\ slip_y rad vy ox = uy /\ vx 0 = v0x /\ vy 0 = v0y.
Proof.
  destruct factor_is as [_ b1]. intros M N1 N2. pose (cx := v0x + (1 - / b) * nux 0 - ux 0 * / b). pose (cy := v0y + (1 - / b) * nuy 0 - uy 0 * / b).
  pose (vx := fun t => - (1 - / b) * nux t + ux t * / b + cx). pose (vy := fun t => - (1 - / b) * nuy t + uy t * / b + cy).
  exists vx, vy, (fun t => (uy t - vy t) / rad), (fun t => (vx t - ux t) / rad).
  assert (ex : slip_x rad vx (fun t => (vx t - ux t) / rad) = ux) by (apply functional_extensionality; intros t; unfold slip_x; field; lra).
  assert (ey : slip_y rad vy (fun t => (uy t - vy t) / rad) = uy) by (apply functional_extensionality; intros t; unfold slip_y; field; lra).
  split; [ | repeat split; trivial; unfold vx, vy, cx, cy; ring ].
  apply (sphere_of_slip _ _ _ _ _ _ _ nux nuy cx cy); trivial; rewrite ?ex, ?ey; trivial; intros; reflexivity.
Qed.
End Sphere.

(* from every slip and every velocity of the centre a sphere has a motion under every continuous drive *)
Lemma sphere_exists m J rad k Ax Ay ux uy vx0 vy0 w : 0 < m -> 0 < J -> 0 < rad -> 0 <= k -> (forall t, continuity_pt Ax t /\ continuity_pt Ay t) ->
  exists vx vy ox oy, sphere m J rad k Ax Ay vx vy ox oy (fun _ => w) /\ slip_x rad vx oy 0 = ux /\ slip_y rad vy ox 0 = uy /\ vx 0 = vx0 /\ vy 0 =
      vy0.
Proof.
  intros hm hJ hr hk C. destruct (factor_is m J rad hm hJ hr) as [_ b1].
  destruct (plane_has_a_motion (factor m J rad * k) Ax Ay ux uy) as (x & y & M & <- & <-); [ apply Rmult_le_pos; lra | auto | ].
  destruct (sphere_with_slip m J rad k hm hJ hr Ax Ay x y _ _ vx0 vy0 w M (primitive_of Ax (fun t => proj1 (C t))) (primitive_of Ay (fun t => proj2
      (C t))))
    as (vx & vy & ox & oy & S & <- & <- & R). exists vx, vy, ox, oy. repeat (split; trivial).
Qed.

(* an example: the plane is pulled back under the sphere, which slides forward faster and faster, moves across at a steady speed, and spins *)
Definition example_v (t : R) : R := 1 + 3 / 4 * t.
Definition example_o (t : R) : R := / 4 * t.
Lemma example_slides : sphere 1 1 1 (/ 4 * 1) (fun _ => -1) (fun _ => 0) example_v (fun _ => 1) (fun _ => -1) example_o (fun _ => 2) /\
  forall t, 0 <= t -> ~ rolls 1 example_v (fun _ => 1) (fun _ => -1) example_o t.
Proof.
  unfold example_v, example_o. split; [ split; intros t Ht | intros t Ht [H _]; unfold slip_x in H; lra ].
  - repeat split; cont.
  - exists (- / 4), 0. unfold slip_x, slip_y. laws.
    assert (n : nrm (1 + 3 / 4 * t - 1 * (/ 4 * t)) (1 + 1 * -1) = 1 + / 2 * t).
    { unfold nrm. replace ((1 + 3 / 4 * t - 1 * (/ 4 * t)) ^ 2 + (1 + 1 * -1) ^ 2) with ((1 + / 2 * t) ^ 2) by field. apply sqrt_pow2. lra. }
    split; [ split; [ lra | rewrite n; field ] | repeat split; (eapply rder_eq; [ rd | field ]) ].
Qed.
