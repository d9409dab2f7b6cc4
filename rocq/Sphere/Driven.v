(* A sphere under a drive along a line, in the units of (23), (24): its slip velocity is a particle's with lambda_0 of (84), and each such motion of a
   particle is the slip of a sphere. The same along the line for friction that differs forward and backward, (85). *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General HalfPeriod Drawn Line Formulas Analysis Reduction.
Open Scope R_scope.

(* the slip velocity along x as (24) has it, in the unit A0 / varpi, at the phase phi of (23), at the time phi / varpi *)
Definition w_x (A0 varpi rad : R) (vx oy : R -> R) (phi : R) : R := eq24_w varpi (slip_x rad vx oy (phi / varpi)) A0.
(* and along y *)
Definition w_y (A0 varpi rad : R) (vy ox : R -> R) (phi : R) : R := eq24_w varpi (slip_y rad vy ox (phi / varpi)) A0.

Lemma lim_units f c s : 0 < s -> is_lim f p_infty 0 -> is_lim (fun t => c * f (s * t)) p_infty 0.
Proof.
  intros hs L. replace 0 with (c * 0) by ring. apply (is_lim_scal_l (fun t => f (s * t)) c p_infty 0), lim_zero. intros e he.
  destruct (Analysis.lim_near _ _ _ L he) as (s1 & _ & B). exists (s1 / s). intros t Ht. apply Rle_div_l in Ht; trivial. specialize (B (s * t)
      ltac:(lra)). apply Rabs_le. lra.
Qed.
Section Driven.
Variables (m J rad mu g A0 varpi t0 : R) (h : R -> R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hA : 0 < A0. Hypothesis hv : 0 < varpi.
Notation lam := (eq84_lambda (eq67_factor (eq62_kappa J m rad)) mu g A0).
Notation driven := (sphere m J rad (mu * g) (fun t => - A0 * h (eq23_phase varpi (t0 + t))) (fun _ => 0)).
Lemma of_w f t : f t = A0 / varpi * eq24_w varpi (f (varpi * t / varpi)) A0.
Proof. replace (varpi * t / varpi) with t by (field; lra). unfold eq24_w. field. lra. Qed.
(* rolling is rest *)
Lemma rolls_at vx vy ox oy t : rolls rad vx vy ox oy t <-> w_x A0 varpi rad vx oy (varpi * t) = 0 /\ w_y A0 varpi rad vy ox (varpi * t) = 0.
Proof.
  unfold rolls. rewrite (of_w (slip_x rad vx oy)), (of_w (slip_y rad vy ox)). fold (w_x A0 varpi rad vx oy (varpi * t)) (w_y A0 varpi rad vy ox
      (varpi * t)).
  assert (0 < A0 / varpi) by now apply Rdiv_lt_0_compat. split; intros [e1 e2]; split; rewrite ?e1, ?e2; try ring; apply (Rmult_eq_reg_l (A0 /
      varpi)); lra.
Qed.
Lemma slip_driven vx vy ox oy oz : driven vx vy ox oy oz -> moves lam h (eq23_phase varpi t0) (w_x A0 varpi rad vx oy) (w_y A0 varpi rad vy ox).
Proof.
  intros S. apply (slip_moves m J rad (mu * g) hm hJ hr) in S.
  apply (motion_in_units (varpi / A0) (/ varpi) _ _ _ _ _ lam (fun s => - h (eq23_phase varpi t0 + s)) (fun _ => 0) (w_x A0 varpi rad vx oy) (w_y A0
      varpi rad vy ox)) in S;
    trivial; [ now apply Rdiv_lt_0_compat | now apply Rinv_0_lt_compat | .. ]; try intros t; unfold eq84_lambda, factor, w_x, w_y, eq24_w,
        eq23_phase; try ring.
  - field. lra.
  - replace (varpi * (t0 + / varpi * t)) with (varpi * t0 + t) by (field; lra). field. lra.
  - rewrite (Rmult_comm (/ varpi)). unfold Rdiv. ring.
  - rewrite (Rmult_comm (/ varpi)). unfold Rdiv. ring.
Qed.
(* H is an integral of h *)
Lemma sphere_driven H wx wy : (forall phi, continuity_pt H phi /\ rder H phi (h phi)) -> moves lam h (eq23_phase varpi t0) wx wy ->
  exists vx vy ox oy oz, driven vx vy ox oy oz /\ w_x A0 varpi rad vx oy = wx /\ w_y A0 varpi rad vy ox = wy.
Proof.
  intros I M. assert (p : 0 < A0 / varpi) by now apply Rdiv_lt_0_compat.
  apply (motion_in_units (A0 / varpi) varpi _ _ _ _ _ (factor m J rad * (mu * g)) (fun t => - A0 * h (eq23_phase varpi (t0 + t))) (fun _ => 0)
    (fun t => A0 / varpi * wx (varpi * t)) (fun t => A0 / varpi * wy (varpi * t))) in M; trivial.
  - destruct (sphere_with_slip m J rad (mu * g) hm hJ hr _ _ _ _ (fun t => - (A0 / varpi) * H (eq23_phase varpi (t0 + t))) (fun _ => 0) 0 0 0 M)
      as (vx & vy & ox & oy & S & e1 & e2 & _); unfold eq23_phase; [ split; intros t Ht .. | ].
    + apply (continuity_pt_mult (fun _ => - (A0 / varpi))); [ cont | apply (continuity_pt_comp (fun t => varpi * (t0 + t)) H); [ cont | apply I ] ].
    + eapply rder_eq; [ apply (rder_mult (fun _ => - (A0 / varpi))); [ rd | apply (rder_phase (fun s => H (varpi * s))), rder_time; [ trivial | apply
        I ] ] | field; lra ].
    + cont.
    + rd.
    + exists vx, vy, ox, oy, (fun _ => 0). split; [ trivial | ]. unfold w_x, w_y. rewrite e1, e2.
      split; extensionality phi; unfold eq24_w; replace (varpi * (phi / varpi)) with phi by (field; lra); field; lra.
  - unfold eq84_lambda, factor. field. lra.
  - intros t. unfold eq23_phase. rewrite Rmult_plus_distr_l. field. lra.
  - intros t. ring.
Qed.
End Driven.

(* ---- along a line ---- *)
(* (59), (60) for a sphere whose velocity v, slip and drive A are along x, from the time t0 on; o is its angular velocity about y; the friction per
    mass
   is kf against a forward slip, kb against a backward one. «a sphere of the mass $m$, the moment of inertia $J$ and the radius $rad$, with
   $\mu_+g=kf$ and $\mu_-g=kb$, has from $t0$ on the velocity $v$ and the angular velocity $o$ on a plane that has the acceleration $A$» *)
Record sphere_on_line (m J rad kf kb : R) (A : R -> R) (t0 : R) (v o : R -> R) : Prop := {
  sl_c : forall t, t0 < t -> continuity_pt v t /\ continuity_pt o t;
  sl_law : forall t, t0 <= t -> exists F, dry (m * kf) (m * kb) (slip_x rad v o t) F /\
    rder v t (eq59_momentum_rate_1 m (A t) 0 0 F 0 0 / m) /\ rder o t (eq60_spin_rate_2 0 0 (- rad) F 0 0 / J) }.
Lemma dry_force c l n w f : 0 < c -> dry l n w f -> dry (c * l) (c * n) w (c * f).
Proof. intros hc ((F1 & F2) & F3 & F4). repeat split; nra. Qed.
Lemma dry_velocity c l n w f : 0 < c -> dry l n w f -> dry l n (c * w) f.
Proof. intros hc ((F1 & F2) & F3 & F4). repeat split; trivial; intros k; [ apply F3 | apply F4 ]; nra. Qed.
Lemma line_in_units c s l n a t0 w l' n' a' t0' w' : 0 < c -> 0 < s -> line l n a t0 w -> l' = c * s * l -> n' = c * s * n ->
  (forall t, a' t = c * s * a (s * t)) -> s * t0' = t0 -> (forall t, w' t = c * w (s * t)) -> line l' n' a' t0' w'.
Proof.
  intros hc hs [C L] -> -> ea et ew. apply functional_extensionality in ew. subst w'. assert (cs : 0 < c * s) by now apply Rmult_lt_0_compat.
    split; intros t Ht.
  - apply (continuity_pt_mult (fun _ => c)); [ cont | apply cont_time, C; rewrite <- et; now apply Rmult_lt_compat_l ].
  - destruct (L (s * t)) as (f & F & X); [ rewrite <- et; apply Rmult_le_compat_l; lra | ]. exists (c * s * f).
    split; [ apply dry_velocity; trivial; now apply dry_force | ].
    rewrite ea. apply rder_time in X; trivial. eapply rder_eq; [ apply (rder_mult (fun _ => c)); [ rd | exact X ] | ring ].
Qed.
Section Line.
Variables (m J rad : R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad.
Lemma slip_on_line kf kb A t0 v o : sphere_on_line m J rad kf kb A t0 v o -> line (factor m J rad * kf) (factor m J rad * kb) (fun t => - A t) t0
  (slip_x rad v o).
Proof.
  destruct (factor_is m J rad hm hJ hr) as [eb b1]. assert (bm : 0 < factor m J rad / m) by (apply Rdiv_lt_0_compat; lra). intros [c L].
    unfold slip_x in *. split.
  - intros t Ht. destruct (c t Ht). cont.
  - intros t Ht. destruct (L t Ht) as (F & D & X & Y). unfold eq59_momentum_rate_1, eq60_spin_rate_2 in X, Y. exists (factor m J rad / m * F). split.
    + replace (factor m J rad * kf) with (factor m J rad / m * (m * kf)) by (field; lra). replace (factor m J rad * kb) with (factor m J rad / m *
      (m * kb)) by (field; lra). now apply dry_force.
    + eapply rder_eq; [ rd | rewrite eb; field; lra ].
Qed.
Lemma on_line_with_slip kf kb A nu t0 u : (forall t : R, is_derive nu t (A t)) -> line (factor m J rad * kf) (factor m J rad * kb) (fun t => - A t)
  t0 u ->
  exists v o, sphere_on_line m J rad kf kb A t0 v o /\ slip_x rad v o = u.
Proof.
  destruct (factor_is m J rad hm hJ hr) as [eb b1]. set (bb := factor m J rad) in *. intros N [c L].
    pose (v := fun t : R => - (1 - / bb) * nu t + u t * / bb). exists v, (fun t : R => (v t - u t) * / rad).
  assert (e : slip_x rad v (fun t => (v t - u t) * / rad) = u) by (extensionality t; unfold slip_x; field; lra). split; trivial.
  assert (pos : 0 < m * rad ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; lra).
  assert (cn : forall t, continuity_pt nu t) by (intros t; apply derivable_continuous_pt; exists (A t); apply is_derive_Reals, N). split.
  - intros t Ht. pose proof (c t Ht). pose proof (cn t). unfold v. split; cont.
  - intros t Ht. destruct (L t Ht) as (f & F & X). pose proof (rder_of _ _ _ (N t)). exists (m / bb * f). rewrite e.
    unfold eq59_momentum_rate_1, eq60_spin_rate_2, v. split; [ | split ].
    + replace (m * kf) with (m / bb * (bb * kf)) by (field; lra). replace (m * kb) with (m / bb * (bb * kb)) by (field; lra).
      apply dry_force; trivial. apply Rdiv_lt_0_compat; lra.
    + eapply rder_eq; [ rd | field; lra ].
    + eapply rder_eq; [ rd | rewrite eb; field; lra ].
Qed.
End Line.
