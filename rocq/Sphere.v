(* Section 3: the sphere; and what rest needs *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Turntable.
Open Scope R_scope.

Lemma rder_unique f t l m : rder f t l -> rder f t m -> l = m.
Proof.
  assert (P : forall l m, rder f t l -> rder f t m -> m <= l).
  { intros l' m' H K. apply le_epsilon. intros e He.
    destruct (rder_step f t l' H (e / 2) ltac:(lra)) as (d1 & p1 & h1).
    destruct (rder_step (fun s => - f s) t (- m') (rder_opp f t m' K) (e / 2) ltac:(lra)) as (d2 & p2 & h2).
    set (h := Rmin d1 d2 / 2). assert (0 < Rmin d1 d2) by (apply Rmin_pos; trivial). pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
    specialize (h1 h ltac:(unfold h; lra)). specialize (h2 h ltac:(unfold h; lra)). assert (0 < h) by (unfold h; lra). nra. }
  intros. apply Rle_antisym; auto.
Qed.
Lemma rder_zero f t d : 0 < d -> (forall s, t <= s < t + d -> f s = 0) -> rder f t 0.
Proof.
  intros Hd H. exists (fun s => if Rlt_dec s (t + d) then 0 else f s). split.
  - apply (is_derive_ext_loc (fun _ => 0)); [ | auto_derive; trivial ]. exists (mkposreal d Hd). intros s Hs. change (Rabs (s - t) < d) in Hs. apply Rabs_def2 in Hs.
    destruct (Rlt_dec s (t + d)); trivial. lra.
  - intros s Hs. destruct (Rlt_dec s (t + d)); trivial. symmetry. apply H. lra.
Qed.
(* s2-no-permanent-rest: while at rest, |A| <= mu g *)
Theorem rest_needs k Ax Ay vx vy s d : 0 <= k -> motion k Ax Ay vx vy -> 0 <= s -> 0 < d ->
  (forall t, s <= t < s + d -> vx t = 0 /\ vy t = 0) -> nrm (Ax s) (Ay s) <= k.
Proof.
  intros Hk M Hs Hd H. destruct (m_law _ _ _ _ _ M s Hs) as (fx & fy & [B _] & X & Y).
  assert (X0 : rder vx s 0) by (apply (rder_zero vx s d); trivial; intros; now apply H).
  assert (Y0 : rder vy s 0) by (apply (rder_zero vy s d); trivial; intros; now apply H).
  pose proof (rder_unique _ _ _ _ X X0). pose proof (rder_unique _ _ _ _ Y Y0).
  unfold nrm. rewrite <- (sqrt_pow2 k) by trivial. apply sqrt_le_1_alt. replace (Ax s) with fx by lra. replace (Ay s) with fy by lra. exact B.
Qed.
(* s4-rest-radius, both ways *)
Theorem rest_radius a b : spin (fun _ => a) (fun _ => b) (fun _ => 0) (fun _ => 0) <-> a ^ 2 + b ^ 2 <= 1.
Proof.
  assert (n0 : nrm 0 0 = 0) by (unfold nrm; replace (0 ^ 2 + 0 ^ 2) with 0 by ring; apply sqrt_0).
  assert (Z : forall c t, rder (fun _ => c) t 0) by (intros; apply rder_of; auto_derive; trivial). split.
  - intros S. destruct (s_law _ _ _ _ S 0 (Rle_refl 0)) as (_ & _ & fx & fy & [B _] & U & W).
    pose proof (rder_unique _ _ _ _ U (Z 0 0)). pose proof (rder_unique _ _ _ _ W (Z 0 0)). replace a with (- fx) by lra. replace b with (- fy) by lra. nra.
  - intros H. split; [ intros; cont | intros; cont | intros; cont | intros; cont | ]. intros t _. split; [ apply Z | split; [ apply Z | ] ]. exists (- a), (- b). split; [ split; [ nra | rewrite n0; ring ] | ].
    split; (eapply rder_eq; [ apply Z | ring ]).
Qed.

(* (59), (60) with Coulomb's law at the point of contact: mass m, moment I, radius R; k = mu g *)
Record sphere (m J rad k : R) (Ax Ay vx vy ox oy oz : R -> R) : Prop := {
  b_c : forall t, 0 < t -> continuity_pt vx t /\ continuity_pt vy t /\ continuity_pt ox t /\ continuity_pt oy t /\ continuity_pt oz t;
  b_law : forall t, 0 <= t -> exists Fx Fy, coulomb (m * k) (vx t - rad * oy t) (vy t + rad * ox t) Fx Fy /\
    rder vx t (Fx / m - Ax t) /\ rder vy t (Fy / m - Ay t) /\
    rder ox t (rad * Fy / J) /\ rder oy t (- rad * Fx / J) /\ rder oz t 0 }.
Section Sphere.
Variables (m J rad k : R) (Ax Ay vx vy ox oy oz : R -> R).
Hypothesis hm : 0 < m. Hypothesis hJ : 0 < J. Hypothesis hr : 0 < rad. Hypothesis hk : 0 <= k.
Hypothesis B : sphere m J rad k Ax Ay vx vy ox oy oz.
Let b := 1 + / (J / (m * rad ^ 2)).   (* (62), (67) *)

(* s3-reduction, rolling included: the slip velocity is a particle's velocity with b mu for mu *)
Theorem reduction : motion (b * k) Ax Ay (fun t => vx t - rad * oy t) (fun t => vy t + rad * ox t).
Proof.
  assert (hb : b = 1 + m * rad ^ 2 / J) by (unfold b; field; lra). assert (b0 : 0 < b). { rewrite hb. assert (0 < m * rad ^ 2 / J) by (apply Rdiv_lt_0_compat; [ apply Rmult_lt_0_compat; [ | apply pow_lt ] | ]; lra). lra. }
  split.
  - intros t Ht. destruct (b_c _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (c1 & c2 & c3 & c4 & _). cont.
  - intros t Ht. destruct (b_c _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (c1 & c2 & c3 & c4 & _). cont.
  - intros t Ht. destruct (b_law _ _ _ _ _ _ _ _ _ _ _ B t Ht) as (Fx & Fy & [C P] & X & Y & OX & OY & OZ).
    exists (b * (Fx / m)), (b * (Fy / m)). split; [ split | split ].
    + replace ((b * (Fx / m)) ^ 2 + (b * (Fy / m)) ^ 2) with ((b / m) ^ 2 * (Fx ^ 2 + Fy ^ 2)) by (field; lra).
      replace ((b * k) ^ 2) with ((b / m) ^ 2 * (m * k) ^ 2) by (field; lra). apply Rmult_le_compat_l; [ apply pow2_ge_0 | exact C ].
    + set (n := nrm _ _) in *. transitivity (b / m * (Fx * (vx t - rad * oy t) + Fy * (vy t + rad * ox t))). field; lra. rewrite P. field; lra.
    + eapply rder_eq. rd. rewrite hb. field. lra.
    + eapply rder_eq. rd. rewrite hb. field. lra.
Qed.
Theorem spin_constant t : 0 <= t -> oz t = oz 0.
Proof.
  intros Ht. apply rder_const; trivial; intros s Hs. now apply (b_c _ _ _ _ _ _ _ _ _ _ _ B s).
  now destruct (b_law _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (Fx & Fy & _ & _ & _ & _ & _ & OZ).
Qed.
(* (79), with dimensions: nu is a primitive of A *)
Theorem eq79 nu t : 0 <= t -> (forall s, 0 < s -> continuity_pt nu s) -> (forall s, 0 <= s -> rder nu s (Ax s)) ->
  vx t = - (1 - / b) * nu t + (vx t - rad * oy t) * / b + (vx 0 + (1 - / b) * nu 0 - (vx 0 - rad * oy 0) * / b).
Proof.
  intros Ht C D. assert (hb : b = 1 + m * rad ^ 2 / J) by (unfold b; field; lra). assert (b0 : 0 < b). { rewrite hb. assert (0 < m * rad ^ 2 / J) by (apply Rdiv_lt_0_compat; [ apply Rmult_lt_0_compat; [ | apply pow_lt ] | ]; lra). lra. }
  enough (vx t + (1 - / b) * nu t - (vx t - rad * oy t) * / b = vx 0 + (1 - / b) * nu 0 - (vx 0 - rad * oy 0) * / b) by lra.
  apply (rder_const (fun t => vx t + (1 - / b) * nu t - (vx t - rad * oy t) * / b)); trivial; intros s Hs.
  - destruct (b_c _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (c1 & c2 & c3 & c4 & _). pose proof (C s ltac:(lra)). cont.
  - destruct (b_law _ _ _ _ _ _ _ _ _ _ _ B s ltac:(lra)) as (Fx & Fy & _ & X & Y & OX & OY & OZ). pose proof (D s ltac:(lra)).
    eapply rder_eq. rd. rewrite hb. field. assert (0 < m * rad ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; lra). lra.
Qed.
End Sphere.
