(* A ball on a turning table moves as a coin on a slower one; not in the paper *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Work.
Open Scope R_scope.

(* seen from the room: centre (x, y), velocity (vx, vy), spin (ox, oy); the table turns at the rate Om about the origin, friction acts on the slip at the contact *)
Record ball_on_table (m J rad Om k : R) (x y vx vy ox oy : R -> R) : Prop := {
  o_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt vx t /\ continuity_pt vy t /\ continuity_pt ox t /\ continuity_pt oy t;
  o_law : forall t, 0 <= t -> rder x t (vx t) /\ rder y t (vy t) /\
    exists Fx Fy, coulomb (m * k) (vx t - rad * oy t + Om * y t) (vy t + rad * ox t - Om * x t) Fx Fy /\
    rder vx t (Fx / m) /\ rder vy t (Fy / m) /\ rder ox t (rad * Fy / J) /\ rder oy t (- rad * Fx / J) }.

Section Ball.
Variables (m J rad Om k : R) (x y vx vy ox oy : R -> R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hO : Om <> 0.
Hypothesis B : ball_on_table m J rad Om k x y vx vy ox oy.
Definition kap := J / (m * rad ^ 2).
Definition bb := 1 + / kap.
(* what the ball keeps, and the centre of the slower table *)
Definition keep_x t := vx t + kap * rad * oy t.
Definition keep_y t := vy t - kap * rad * ox t.
Definition x0 := - keep_y 0 / (kap * Om).
Definition y0 := keep_x 0 / (kap * Om).
Lemma kap_pos : 0 < kap. Proof. unfold kap. apply Rdiv_lt_0_compat; trivial. apply Rmult_lt_0_compat; trivial. now apply pow_lt. Qed.
Theorem kept t : 0 <= t -> keep_x t = keep_x 0 /\ keep_y t = keep_y 0.
Proof.
  intros Ht. split; [ apply (rder_const (fun t => vx t + kap * rad * oy t)) | apply (rder_const (fun t => vy t - kap * rad * ox t)) ]; trivial; intros s Hs;
    try (destruct (o_c _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (? & ? & ? & ? & ? & ?); cont);
    destruct (o_law _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (? & ? & Fx & Fy & _ & ? & ? & ? & ?); (eapply rder_eq; [ rd | unfold kap; field; repeat split; lra ]).
Qed.
(* the slip velocity is b times that of a coin on a table that turns at Om / b about (x0, y0) *)
Lemma slip_is t : 0 <= t -> vx t - rad * oy t + Om * y t = bb * (vx t + Om / bb * (y t - y0)) /\ vy t + rad * ox t - Om * x t = bb * (vy t - Om / bb * (x t - x0)).
Proof.
  intros Ht. pose proof kap_pos. assert (b0 : 0 < bb) by (unfold bb; pose proof (Rinv_0_lt_compat _ H); lra). destruct (kept t Ht) as [e1 e2]. unfold x0, y0. rewrite <- e1, <- e2. unfold keep_x, keep_y.
  split; [ replace (bb * (vx t + Om / bb * (y t - (vx t + kap * rad * oy t) / (kap * Om)))) with (bb * vx t + Om * (y t - (vx t + kap * rad * oy t) / (kap * Om))) by (field; repeat split; lra)
         | replace (bb * (vy t - Om / bb * (x t - - (vy t - kap * rad * ox t) / (kap * Om)))) with (bb * vy t - Om * (x t - - (vy t - kap * rad * ox t) / (kap * Om))) by (field; repeat split; lra) ];
    unfold bb; field; repeat split; lra.
Qed.
(* seen from that slower table *)
Definition om := Om / bb.
Definition X t := cos (om * t) * (x t - x0) + sin (om * t) * (y t - y0).
Definition Y t := cos (om * t) * (y t - y0) - sin (om * t) * (x t - x0).
Definition U t := cos (om * t) * (vx t + om * (y t - y0)) + sin (om * t) * (vy t - om * (x t - x0)).
Definition W t := cos (om * t) * (vy t - om * (x t - x0)) - sin (om * t) * (vx t + om * (y t - y0)).
Lemma turn_sq c s a b : c ^ 2 + s ^ 2 = 1 -> (c * a + s * b) ^ 2 + (c * b - s * a) ^ 2 = a ^ 2 + b ^ 2.
Proof. intros e. replace (a ^ 2 + b ^ 2) with ((c ^ 2 + s ^ 2) * (a ^ 2 + b ^ 2)) by (rewrite e; ring). ring. Qed.

Theorem ball_is_coin : turntable (Om / bb) k X Y U W.
Proof.
  pose proof kap_pos as kp. assert (b0 : 0 < bb) by (unfold bb; pose proof (Rinv_0_lt_compat _ kp); lra).
  assert (Cc : forall t, continuity_pt (fun t => cos (om * t)) t) by (intros; apply (continuity_pt_comp (fun t => om * t) cos); [ cont | apply continuity_cos ]).
  assert (Cs : forall t, continuity_pt (fun t => sin (om * t)) t) by (intros; apply (continuity_pt_comp (fun t => om * t) sin); [ cont | apply continuity_sin ]).
  fold om. split.
  - intros t Ht. destruct (o_c _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (? & ? & ? & ? & _). unfold X, Y, U, W. repeat split; cont.
  - intros t Ht. destruct (o_law _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (Px & Py & Fx & Fy & [C P] & Vx & Vy & _). destruct (slip_is t Ht) as [s1 s2]. rewrite s1, s2 in P. fold om in P.
    assert (cs : cos (om * t) ^ 2 + sin (om * t) ^ 2 = 1) by (pose proof (sin2_cos2 (om * t)) as I; rewrite !Rsqr_pow2 in I; lra).
    split; [ unfold X, U; eapply rder_eq; [ rd | simpl; ring ] | split; [ unfold Y, W; eapply rder_eq; [ rd | simpl; ring ] | ] ].
    exists (cos (om * t) * (Fx / m) + sin (om * t) * (Fy / m)), (cos (om * t) * (Fy / m) - sin (om * t) * (Fx / m)). split; [ | split; [ unfold U, X, W; eapply rder_eq; [ rd | simpl; ring ] | unfold W, Y, U; eapply rder_eq; [ rd | simpl; ring ] ] ].
    set (a := vx t + om * (y t - y0)) in *. set (b := vy t - om * (x t - x0)) in *. unfold U, W. fold a b. set (c := cos (om * t)) in *. set (s := sin (om * t)) in *. split.
    + rewrite turn_sq by trivial. replace ((Fx / m) ^ 2 + (Fy / m) ^ 2) with ((Fx ^ 2 + Fy ^ 2) * / m ^ 2) by (field; lra). replace (k ^ 2) with ((m * k) ^ 2 * / m ^ 2) by (field; lra).
      apply Rmult_le_compat_r; trivial. left. apply Rinv_0_lt_compat. now apply pow_lt.
    + assert (n : nrm (c * a + s * b) (c * b - s * a) = nrm a b) by (unfold nrm; f_equal; now apply turn_sq). rewrite n.
      assert (n2 : nrm (bb * a) (bb * b) = bb * nrm a b). { unfold nrm. replace ((bb * a) ^ 2 + (bb * b) ^ 2) with (bb ^ 2 * (a ^ 2 + b ^ 2)) by ring. rewrite sqrt_mult by (pose proof (pow2_ge_0 a); pose proof (pow2_ge_0 b); pose proof (pow2_ge_0 bb); lra). rewrite sqrt_pow2; lra. }
      rewrite n2 in P. assert (P2 : Fx * a + Fy * b = - (m * k) * nrm a b) by (apply (Rmult_eq_reg_l bb); lra).
      transitivity ((c ^ 2 + s ^ 2) * ((Fx * a + Fy * b) / m)); [ field; lra | ]. rewrite cs, P2. field. lra.
Qed.
End Ball.
