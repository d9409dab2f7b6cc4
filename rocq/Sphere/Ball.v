(* A ball on a turning table moves as a coin on a slower one, by the factor b; not in the paper. v - kappa omega x R is kept; so the slip velocity
  is b
   times that of the ball's centre against a table that turns at Omega / b about a point that the start sets. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas Reduction Work.
Open Scope R_scope.

(* seen from the room: centre (x, y), velocity (vx, vy), spin (ox, oy); the table turns at the rate Om about the origin, friction acts on the slip
  at the contact *)
Record ball_on_table (m J rad Om k : R) (x y vx vy ox oy : R -> R) : Prop := {
  o_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt vx t /\ continuity_pt vy t /\ continuity_pt ox t /\
    continuity_pt oy t;
  o_law : forall t, 0 <= t -> rder x t (vx t) /\ rder y t (vy t) /\
    exists Fx Fy, coulomb (m * k) (slip_x rad vx oy t + Om * y t) (slip_y rad vy ox t - Om * x t) Fx Fy /\
    rder vx t (Fx / m) /\ rder vy t (Fy / m) /\ rder ox t (rad * Fy / J) /\ rder oy t (- rad * Fx / J) }.

Section Ball.
Variables (m J rad Om k : R) (x y vx vy ox oy : R -> R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hO : Om <> 0.
Hypothesis B : ball_on_table m J rad Om k x y vx vy ox oy.
Notation kappa := (eq62_kappa J m rad).
Notation b := (factor m J rad).
(* what the ball keeps, and the centre of the slower table *)
Definition keep_x t := vx t + eq62_kappa J m rad * rad * oy t.
Definition keep_y t := vy t - eq62_kappa J m rad * rad * ox t.
Definition x0 := - keep_y 0 / (eq62_kappa J m rad * Om).
Definition y0 := keep_x 0 / (eq62_kappa J m rad * Om).
Lemma kappa_pos : 0 < kappa /\ b = 1 + / kappa.
Proof. split; [ | unfold factor, eq67_factor; lra ]. unfold eq62_kappa. apply Rdiv_lt_0_compat; trivial. apply Rmult_lt_0_compat; trivial.
  now apply pow_lt. Qed.
Theorem kept t : 0 <= t -> keep_x t = keep_x 0 /\ keep_y t = keep_y 0.
Proof.
  assert (0 < m * rad ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; lra).
  intros Ht. split; [ apply (rder_const (fun t => vx t + kappa * rad * oy t)) | apply (rder_const (fun t => vy t - kappa * rad * ox t)) ]; trivial;
    intros s Hs;
    try (destruct (o_c _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (? & ? & ? & ? & ? & ?); cont);
    destruct (o_law _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (? & ? & Fx & Fy & _ & ? & ? & ? & ?); (eapply rder_eq; [ rd | unfold eq62_kappa;
      field; repeat split; lra ]).
Qed.
(* the slip velocity is b times that of a coin on a table that turns at om = Om / b about (x0, y0) *)
Definition om := Om / factor m J rad.
Lemma slip_is t : 0 <= t -> slip_x rad vx oy t + Om * y t = b * (vx t + om * (y t - y0)) /\ slip_y rad vy ox t - Om * x t = b * (vy t - om * (x t -
  x0)).
Proof.
  intros Ht. destruct kappa_pos as [kp eb]. assert (0 < / kappa) by now apply Rinv_0_lt_compat. assert (b0 : 0 < b) by lra.
  destruct (kept t Ht) as [e1 e2]. unfold x0, y0, om, slip_x, slip_y. rewrite <- e1, <- e2. unfold keep_x, keep_y. set (c := kappa) in *.
  assert (D : forall z w, b * (z + Om / b * w) = b * z + Om * w) by (intros; field; lra).
  assert (D' : forall z w, b * (z - Om / b * w) = b * z - Om * w) by (intros; field; lra).
  split; [ rewrite D | rewrite D' ]; rewrite eb; field; repeat split; lra.
Qed.
(* seen from that slower table *)
Definition X t := cos (om * t) * (x t - x0) + sin (om * t) * (y t - y0).
Definition Y t := cos (om * t) * (y t - y0) - sin (om * t) * (x t - x0).
Definition U t := cos (om * t) * (vx t + om * (y t - y0)) + sin (om * t) * (vy t - om * (x t - x0)).
Definition W t := cos (om * t) * (vy t - om * (x t - x0)) - sin (om * t) * (vx t + om * (y t - y0)).
Lemma turn_sq c s p q : c ^ 2 + s ^ 2 = 1 -> (c * p + s * q) ^ 2 + (c * q - s * p) ^ 2 = p ^ 2 + q ^ 2.
Proof. intros e. replace (p ^ 2 + q ^ 2) with ((c ^ 2 + s ^ 2) * (p ^ 2 + q ^ 2)) by (rewrite e; ring). ring. Qed.
(* The ball's centre, seen so, is a coin on that table: rolling is rest. *)
Theorem ball_is_coin : turntable (Om / factor m J rad) k X Y U W.
Proof.
  destruct kappa_pos as [kp eb]. assert (b0 : 0 < b) by (pose proof (Rinv_0_lt_compat _ kp); lra).
  assert (Cc : forall t, continuity_pt (fun t => cos (om * t)) t) by (intros; apply (continuity_pt_comp (fun t => om * t) cos);
    [ cont | apply continuity_cos ]).
  assert (Cs : forall t, continuity_pt (fun t => sin (om * t)) t) by (intros; apply (continuity_pt_comp (fun t => om * t) sin);
    [ cont | apply continuity_sin ]).
  fold om. split.
  - intros t Ht. destruct (o_c _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (? & ? & ? & ? & _). unfold X, Y, U, W. repeat split; cont.
  - intros t Ht. destruct (o_law _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (Px & Py & Fx & Fy & C & Vx & Vy & _). destruct (slip_is t Ht) as [s1 s2].
    rewrite s1, s2 in C.
    assert (cs : cos (om * t) ^ 2 + sin (om * t) ^ 2 = 1) by (pose proof (sin2_cos2 (om * t)) as I; rewrite !Rsqr_pow2 in I; lra).
    apply (coulomb_force (/ m)), (coulomb_velocity (/ b)) in C; [ | left; now apply Rinv_0_lt_compat ].
      rewrite <- !Rmult_assoc, !Rinv_l, !Rmult_1_l in C by lra.
    split; [ unfold X, U; eapply rder_eq; [ rd | simpl; ring ] | split; [ unfold Y, W; eapply rder_eq; [ rd | simpl; ring ] | ] ].
    exists (cos (om * t) * (/ m * Fx) + sin (om * t) * (/ m * Fy)), (cos (om * t) * (/ m * Fy) - sin (om * t) * (/ m * Fx)).
    split; [ | split; [ unfold U, X, W | unfold W, Y, U ]; (eapply rder_eq; [ rd | simpl; field; lra ]) ].
    unfold U, W. set (p := vx t + om * (y t - y0)) in *. set (r := vy t - om * (x t - x0)) in *. destruct C as [C P].
      split; [ now rewrite turn_sq | ].
    replace (nrm _ _) with (nrm p r) by (unfold nrm; f_equal; symmetry; now apply turn_sq). rewrite <- P.
    transitivity ((cos (om * t) ^ 2 + sin (om * t) ^ 2) * (/ m * Fx * p + / m * Fy * r)); [ ring | rewrite cs; ring ].
Qed.
End Ball.
