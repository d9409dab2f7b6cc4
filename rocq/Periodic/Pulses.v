(* 2.3: the pulses (42), (43) and the motion at large times under them, with the friction above and below the width eta; for friction
   above 1, rest. Each is put together from straight pieces, and all motions of the plane are drawn to it. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis General HalfPeriod Drawn Line Formulas.
Open Scope R_scope.

(* ---- drives and velocities that are their own opposite half a period later ---- *)
Lemma half_per (f : R -> R) : (forall t, f (t + PI) = - f t) -> forall t, f (t + 2 * PI) = f t.
Proof. intros A t. replace (t + 2 * PI) with (t + PI + PI) by ring. rewrite !A. ring. Qed.
Section Opposite.
Variables (l : R) (h W : R -> R).
Hypothesis hl : 0 < l.
Hypothesis ha : forall t, h (t + PI) = - h t.
Hypothesis Wa : forall t, W (t + PI) = - W t.
Hypothesis M : forall p, moves l h p (fun t => W (p + t)) (fun _ => 0).
(* every motion becomes one that rests where the drive is steady and below friction *)
Lemma rest_caught r s c : r < s -> (forall t, r <= t <= s -> W t = 0) -> (forall t, r <= t < s -> h t = c) -> Rabs c < l -> caught l h W.
Proof.
  intros Hr Z C hc p vx vy V. set (x := (r + s) / 2).
  destruct (plane_reached l (2 * PI) (x - p) (s - p) (fun t => - h (p + t)) (fun t => W (p + t))) with (vx := vx) (vy := vy) as (t1 & h1 & H1);
    trivial; try (unfold x; lra).
  - pose proof PI_RGT_0. lra.
  - intros t. now rewrite <- Rplus_assoc, half_per.
  - apply M.
  - intros t. now rewrite <- Rplus_assoc, half_per.
  - intros t Ht. apply Z. unfold x in Ht. lra.
  - rewrite C, Rabs_Ropp by (unfold x; lra). trivial.
  - apply (cont_glue _ (fun _ => - c) (fun _ => - c) _ ((s - r) / 2)); try cont; unfold x; [ lra | | ]; intros t Ht; rewrite C by lra; trivial.
  - exists t1. auto.
Qed.
(* every motion tends to one that passes from backward to forward at once *)
Lemma passing_late z d : (forall t, Rabs (h t) <= 1) -> 0 < d -> W z = 0 -> (forall t, z - d < t < z -> W t < 0) ->
  (forall t, z < t < z + d -> 0 < W t) -> late l h W.
Proof.
  intros hB hd Z A B. pose proof PI_RGT_0. split; trivial. now apply half_per. intros p vx vy V.
  apply (plane_attracts l 1 (2 * PI) (z - p) d (fun t => - h (p + t)) (fun t => W (p + t))); trivial; try lra.
  - intros t. rewrite Rabs_Ropp. apply hB.
  - apply M.
  - intros t. now rewrite <- Rplus_assoc, half_per.
  - now replace (p + (z - p)) with z by ring.
  - intros t Ht. apply A. lra.
  - intros t Ht. apply B. lra.
Qed.
End Opposite.

(* (42), and (43) for all other phases *)
Definition pulse (eta : R) : R -> R := ext PI (fun ph => if Rlt_dec ph (eq42_end eta) then eq42_cases_1 else eq42_cases_2).
Lemma pulse_on eta t : 0 <= t < PI -> (t < eta * PI -> pulse eta t = 1) /\ (eta * PI <= t -> pulse eta t = 0).
Proof.
  intros H. unfold pulse. rewrite ext_first by trivial. unfold eq42_end, eq42_cases_1, eq42_cases_2.
  destruct (Rlt_dec t (eta * PI)); split; intros; trivial; lra.
Qed.
Lemma pulse_anti eta t : pulse eta (t + PI) = - pulse eta t.
Proof. apply ext_anti, PI_RGT_0. Qed.
Lemma pulse_cases eta t : exists n s, 0 <= s < PI /\ pulse eta t = sg n * pulse eta s.
Proof.
  pose proof PI_RGT_0. pose proof (proj2 (floor_spec PI H t (floor PI t)) eq_refl) as F. set (n := floor PI t) in *. exists n, (t - IZR n * PI).
  split; [ lra | ].
  unfold pulse at 2. rewrite ext_first by lra. unfold pulse. apply ext_on; trivial.
Qed.
Lemma pulse_size eta t : Rabs (pulse eta t) = 0 \/ Rabs (pulse eta t) = 1.
Proof.
  destruct (pulse_cases eta t) as (n & s & hs & ->). destruct (pulse_on eta s hs) as [P1 P0].
  destruct (Rlt_le_dec s (eta * PI)); [ rewrite P1 by trivial; right | rewrite P0 by trivial; left ]; destruct (sg_cases n) as [-> | ->];
    rewrite ?Rmult_0_r, ?Rmult_1_r, ?Rabs_R0, ?Rabs_R1, ?Rabs_Ropp, ?Rabs_R1; trivial.
  replace (-1) with (- (1)) by ring. now rewrite Rabs_Ropp, Rabs_R1.
Qed.
(* straight pieces: under the constant drive c a slip of the sense s, and a rest *)
Lemma arc_slip s l h c p q f : 0 <= l -> s = 1 \/ s = -1 -> (forall t, is_derive f t (c - s * l)) -> (forall t, p <= t < q -> h t = c /\
  0 <= s * f t) -> arc l l h p q f.
Proof.
  intros hl hs D H. split; intros t Ht; [ eapply cont_of, D | ]. exists (- s * l). destruct (H t Ht) as [-> P].
  split; [ destruct hs as [-> | ->]; repeat split; lra | eapply rder_eq; [ apply rder_of, D | ring ] ].
Qed.
Lemma arc_still l h p q : (forall t, p <= t < q -> Rabs (h t) <= l) -> arc l l h p q (fun _ => 0).
Proof.
  intros H. split; intros t Ht. cont. exists (- h t). specialize (H t Ht). apply Rabs_le_between in H. repeat split; try lra. eapply rder_eq.
  rd. ring.
Qed.
Ltac cases := unfold eq44_ends_1, eq44_ends_2, eq44_cases_1, eq44_cases_2, eq44_cases_3, right_periodic_small_friction_ends_1,
  right_periodic_small_friction_ends_2,
  right_periodic_small_friction_cases_1, right_periodic_small_friction_cases_2, right_periodic_small_friction_cases_3,
    right_periodic_small_friction_start in *.
Ltac slope := intros; cases; auto_derive; trivial; field.

(* every motion becomes one that rests to the end of the gap *)
Lemma gap_caught eta l W r : 0 < eta < 1 -> 0 < l -> (forall t, W (t + PI) = - W t) ->
  (forall p, moves l (pulse eta) p (fun t => W (p + t)) (fun _ => 0)) ->
  eta * PI <= r < PI -> (forall t, r <= t <= PI -> W t = 0) -> caught l (pulse eta) W.
Proof.
  intros he hl A M hr Z. pose proof PI_RGT_0. apply (rest_caught l (pulse eta) W hl (pulse_anti eta) A M r PI 0); [ lra | trivial |
    | rewrite Rabs_R0; trivial ].
  intros t Ht. apply pulse_on; nra.
Qed.

(* (44): from the width eta of the pulses on, to 1 *)
Definition w44 (l eta : R) : R -> R := ext PI (glue (eq44_ends_1 l eta) (eq44_cases_1 l eta) (glue (eq44_ends_2 l eta) (eq44_cases_2 l eta)
  (eq44_cases_3 l eta))).
Lemma w44_cases l eta : 0 < eta < l -> l < 1 -> 0 < eta * PI < eta * PI / l /\ eta * PI / l < PI /\ (forall ph, 0 <= ph <= eta * PI ->
  w44 l eta ph = eq44_cases_1 l eta ph) /\
  (forall ph, eta * PI <= ph <= eta * PI / l -> w44 l eta ph = eq44_cases_2 l eta ph) /\ (forall ph, eta * PI / l <= ph <= PI ->
    w44 l eta ph = eq44_cases_3 l eta ph).
Proof.
  intros h1 h2. pose proof PI_RGT_0. assert (e0 : 0 < eta * PI) by nra. assert (e1 : l * (eta * PI / l) = eta * PI) by (field; lra).
  assert (e2 : eta * PI < eta * PI / l) by (apply (Rmult_lt_reg_l l); [ lra | rewrite e1; nra ]).
  assert (e3 : eta * PI / l < PI) by (apply (Rmult_lt_reg_l l); [ lra | rewrite e1; nra ]).
  unfold w44, eq44_ends_1, eq44_ends_2. split; [ lra | split; [ lra | ] ].
  assert (last : ext PI (glue (eta * PI) (eq44_cases_1 l eta) (glue (eta * PI / l) (eq44_cases_2 l eta) (eq44_cases_3 l eta))) PI = 0).
  { match goal with |- ext PI ?G PI = 0 => pose proof (ext_anti PI G H 0) as Q end. rewrite Rplus_0_l in Q. rewrite Q, ext_first, glue_l by lra.
    unfold eq44_cases_1. ring. }
  split; [ | split ]; intros ph Hph.
  - rewrite ext_first by lra. destruct (Req_dec ph (eta * PI)) as [-> | n]; [ rewrite glue_r, glue_l by lra; unfold eq44_cases_1, eq44_cases_2;
    ring | apply glue_l; lra ].
  - rewrite ext_first, glue_r by lra. destruct (Req_dec ph (eta * PI / l)) as [-> | n]; [ rewrite glue_r by lra;
    unfold eq44_cases_2, eq44_cases_3; lra | apply glue_l; lra ].
  - destruct (Req_dec ph PI) as [-> | n]; [ exact last | rewrite ext_first, !glue_r by lra; trivial ].
Qed.
Lemma w44_late l eta : 0 < eta < l -> l < 1 -> (forall ph, w44 l eta (ph + PI) = - w44 l eta ph) /\ late l (pulse eta) (w44 l eta) /\
  caught l (pulse eta) (w44 l eta).
Proof.
  intros h1 h2. destruct (w44_cases l eta h1 h2) as (e0 & e1 & C1 & C2 & C3). pose proof PI_RGT_0.
  assert (el : l * (eta * PI / l) = eta * PI) by (field; lra).
  assert (A : forall ph, w44 l eta (ph + PI) = - w44 l eta ph) by (intros; apply ext_anti; trivial).
  assert (M : forall p, moves l (pulse eta) p (fun t => w44 l eta (p + t)) (fun _ => 0)).
  { apply half_arc; trivial; [ lra | apply pulse_anti | | ]; unfold eq44_ends_1, eq44_ends_2.
    - rewrite !glue_r, glue_l by lra. unfold eq44_cases_3, eq44_cases_1. ring.
    - apply arc_glue; [ lra | | apply arc_glue; [ lra | | | unfold eq44_cases_2, eq44_cases_3; lra ] | rewrite glue_l by lra;
      unfold eq44_cases_1, eq44_cases_2; ring ].
      + apply (arc_slip 1 l _ 1); [ lra | auto | slope | ]. intros t Ht. split; [ apply pulse_on; lra | unfold eq44_cases_1; nra ].
      + apply (arc_slip 1 l _ 0); [ lra | auto | slope | ]. intros t Ht. split; [ apply pulse_on; lra | unfold eq44_cases_2; nra ].
      + apply arc_still. intros t Ht. rewrite (proj2 (pulse_on eta t ltac:(lra))) by lra. rewrite Rabs_R0. lra. }
  assert (C : caught l (pulse eta) (w44 l eta)) by (apply (gap_caught eta l _ (eta * PI / l)); trivial; lra || (intros; apply C3; lra)).
  split; [ trivial | split; trivial ]. apply caught_late; trivial. now apply half_per.
Qed.

(* up to the width: it passes from backward to forward at once, at the phase right_periodic_small_friction_start *)
Section Below.
Variables l eta : R.
Hypothesis h1 : 0 < l <= eta.
Hypothesis h2 : eta < 1.
Notation b := (right_periodic_small_friction_start l eta).
Notation c1 := (right_periodic_small_friction_cases_1 l eta).
Notation c2 := (right_periodic_small_friction_cases_2 l eta).
Notation c3 := (right_periodic_small_friction_cases_3 l eta).
Definition w_below : R -> R := ext PI (glue b (fun ph => - c3 (ph + PI)) (glue (eta * PI) c1 c2)).
Lemma below_places : 0 <= b < eta * PI /\ eta * PI < PI /\ 2 * b = PI * (eta - l).
Proof. pose proof PI_RGT_0. cases. repeat split; nra. Qed.
Lemma below_pieces t : c1 t = (1 - l) * (t - b) /\ c2 t = (1 + l) * b + l * (PI - t) /\ c3 t = (1 + l) * (PI + b - t).
Proof. cases. repeat split; field. Qed.
Lemma below_cases : (forall ph, b <= ph <= eta * PI -> w_below ph = c1 ph) /\ (forall ph, eta * PI <= ph < PI -> w_below ph = c2 ph) /\
  (forall ph, PI <= ph < PI + b -> w_below ph = c3 ph).
Proof.
  pose proof PI_RGT_0. destruct below_places as (hb & ep & eb). unfold w_below. split; [ | split ]; intros ph Hph.
  - rewrite ext_first, glue_r by lra. destruct (Req_dec ph (eta * PI)) as [-> | n]; [ rewrite glue_r by lra; cases; ring | apply glue_l; lra ].
  - now rewrite ext_first, !glue_r by lra.
  - replace ph with (ph - PI + PI) by ring. rewrite ext_anti, ext_first, glue_l by lra. ring.
Qed.
Lemma w_below_late : (forall ph, w_below (ph + PI) = - w_below ph) /\ late l (pulse eta) w_below /\ w_below b = 0 /\
  forall ph, b < ph < PI + b -> 0 < w_below ph.
Proof.
  pose proof PI_RGT_0. destruct below_places as (hb & ep & eb). destruct below_cases as (C1 & C2 & C3). pose proof below_pieces as P.
  assert (A : forall ph, w_below (ph + PI) = - w_below ph) by (intros ph; now apply ext_anti).
  assert (Z : w_below b = 0) by (rewrite C1 by lra; destruct (P b) as [-> _]; ring).
  assert (Pos : forall ph, b < ph < PI + b -> 0 < w_below ph).
  { intros ph Hph. destruct (P ph) as (p1 & p2 & p3). destruct (Rlt_le_dec ph (eta * PI)); [ rewrite C1, p1 by lra; nra | ].
    destruct (Rlt_le_dec ph PI); [ rewrite C2, p2 by lra | rewrite C3, p3 by lra ]; nra. }
  split; [ trivial | split; [ | split; trivial ] ]. apply (passing_late l (pulse eta) w_below ltac:(lra) A) with (z := b) (d := PI); trivial.
  - apply half_arc; trivial; [ lra | apply pulse_anti | | ].
    + rewrite !glue_r by lra. destruct (Req_dec b 0) as [e | e]; [ rewrite e, glue_r, glue_l by lra | rewrite glue_l by lra ];
        destruct (P PI) as (_ & -> & _); [ destruct (P 0) as (-> & _) | destruct (P (0 + PI)) as (_ & _ & ->) ]; rewrite ?e; ring.
    + apply arc_glue; [ lra | | apply arc_glue; [ lra | | | cases; ring ] | rewrite glue_l by lra;
      destruct (P b) as (-> & _), (P (b + PI)) as (_ & _ & ->); ring ].
      * apply (arc_slip (-1) l _ 1); [ lra | auto | slope | ]. intros t Ht. split; [ apply pulse_on; lra
        | destruct (P (t + PI)) as (_ & _ & ->); nra ].
      * apply (arc_slip 1 l _ 1); [ lra | auto | slope | ]. intros t Ht. split; [ apply pulse_on; lra | destruct (P t) as (-> & _); nra ].
      * apply (arc_slip 1 l _ 0); [ lra | auto | slope | ]. intros t Ht. split; [ apply pulse_on; lra | destruct (P t) as (_ & -> & _); nra ].
  - intros t. destruct (pulse_size eta t) as [-> | ->]; lra.
  - intros t Ht. specialize (Pos (t + PI) ltac:(lra)). rewrite A in Pos. lra.
  - intros t Ht. apply Pos. lra.
Qed.
End Below.
(* friction as strong as the pulses, or stronger: rest *)
Lemma pulses_still l eta : 0 < eta < 1 -> 1 <= l -> late l (pulse eta) (fun _ => 0) /\ caught l (pulse eta) (fun _ => 0).
Proof.
  intros he hl. pose proof PI_RGT_0. assert (M : forall p, moves l (pulse eta) p (fun t => (fun _ => 0) (p + t)) (fun _ => 0)).
  { intros p. split; [ intros; cont | intros; cont | intros t _ ]. exists (- pulse eta (p + t)), 0.
    split; [ split | split; (eapply rder_eq; [ rd | ring ]) ].
    - assert (Rabs (pulse eta (p + t)) <= l) as B by (destruct (pulse_size eta (p + t)) as [-> | ->]; lra). apply Rabs_le_between in B. nra.
    - rewrite nrm_x, Rabs_R0. ring. }
  assert (C : caught l (pulse eta) (fun _ => 0)) by (apply (gap_caught eta l _ (eta * PI)); trivial; try lra; [ intros; ring | nra ]).
  split; trivial. now apply caught_late.
Qed.
