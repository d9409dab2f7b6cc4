(* 2.3: the pulses (42), (43) and the motion at large times under them, with the friction above and below the width eta; for friction
   above 1, rest. Each is put together from straight pieces, and all motions of the plane are drawn to it. *)
Require Import Reals Lra Psatz FunctionalExtensionality.
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
  destruct (plane_reached l (2 * PI) (x - p) (s - p) (fun t => - h (p + t)) (fun t => W (p + t))) with (vx := vx) (vy := vy) as (t1 & h1 & H1); trivial; try (unfold x; lra).
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
Lemma passing_late z d : (forall t, Rabs (h t) <= 1) -> 0 < d -> W z = 0 -> (forall t, z - d < t < z -> W t < 0) -> (forall t, z < t < z + d -> 0 < W t) -> late l h W.
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
  intros H. unfold pulse. rewrite ext_first by trivial. unfold eq42_end, eq42_cases_1, eq42_cases_2. destruct (Rlt_dec t (eta * PI)); split; intros; trivial; lra.
Qed.
Lemma pulse_anti eta t : pulse eta (t + PI) = - pulse eta t.
Proof. apply ext_anti, PI_RGT_0. Qed.
Lemma pulse_cases eta t : exists n s, 0 <= s < PI /\ pulse eta t = sg n * pulse eta s.
Proof.
  pose proof PI_RGT_0. pose proof (proj2 (floor_spec PI H t (floor PI t)) eq_refl) as F. set (n := floor PI t) in *. exists n, (t - IZR n * PI). split; [ lra | ].
  unfold pulse at 2. rewrite ext_first by lra. unfold pulse. apply ext_on; trivial.
Qed.
Lemma pulse_size eta t : Rabs (pulse eta t) = 0 \/ Rabs (pulse eta t) = 1.
Proof.
  destruct (pulse_cases eta t) as (n & s & hs & ->). destruct (pulse_on eta s hs) as [P1 P0].
  destruct (Rlt_le_dec s (eta * PI)); [ rewrite P1 by trivial; right | rewrite P0 by trivial; left ]; destruct (sg_cases n) as [-> | ->]; rewrite ?Rmult_0_r, ?Rmult_1_r, ?Rabs_R0, ?Rabs_R1, ?Rabs_Ropp, ?Rabs_R1; trivial.
  replace (-1) with (- (1)) by ring. now rewrite Rabs_Ropp, Rabs_R1.
Qed.
(* straight pieces: under the constant drive c a slip forward, and a rest *)
Lemma arc_slip l h c p q f : 0 <= l -> (forall t, is_derive f t (c - l)) -> (forall t, p <= t < q -> h t = c /\ 0 <= f t) -> arc l l h p q f.
Proof.
  intros hl D H. split; intros t Ht. apply derivable_continuous_pt. exists (c - l). apply is_derive_Reals, D.
  exists (- l). destruct (H t Ht) as [-> P]. repeat split; try lra. eapply rder_eq. apply rder_of, D. ring.
Qed.
Lemma arc_still l h p q : (forall t, p <= t < q -> Rabs (h t) <= l) -> arc l l h p q (fun _ => 0).
Proof.
  intros H. split; intros t Ht. cont. exists (- h t). specialize (H t Ht). apply Rabs_le_between in H. repeat split; try lra. eapply rder_eq. rd. ring.
Qed.
Ltac slope := intros; unfold eq44_cases_1, eq44_cases_2, right_periodic_small_friction_cases_1, right_periodic_small_friction_cases_2, right_periodic_small_friction_cases_3;
  auto_derive; trivial; ring.

(* every motion becomes one that rests to the end of the gap *)
Lemma gap_caught eta l W r : 0 < eta < 1 -> 0 < l -> (forall t, W (t + PI) = - W t) -> (forall p, moves l (pulse eta) p (fun t => W (p + t)) (fun _ => 0)) ->
  eta * PI <= r < PI -> (forall t, r <= t <= PI -> W t = 0) -> caught l (pulse eta) W.
Proof.
  intros he hl A M hr Z. pose proof PI_RGT_0. apply (rest_caught l (pulse eta) W hl (pulse_anti eta) A M r PI 0); [ lra | trivial | | rewrite Rabs_R0; trivial ].
  intros t Ht. apply pulse_on; nra.
Qed.

(* (44): from the width eta of the pulses on, to 1 *)
Definition w44 (l eta : R) : R -> R := ext PI (glue (eq44_ends_1 l eta) (eq44_cases_1 l eta) (glue (eq44_ends_2 l eta) (eq44_cases_2 l eta) (eq44_cases_3 l eta))).
Lemma w44_cases l eta : 0 < eta < l -> l < 1 -> 0 < eta * PI < eta * PI / l /\ eta * PI / l < PI /\ (forall ph, 0 <= ph <= eta * PI -> w44 l eta ph = eq44_cases_1 l eta ph) /\
  (forall ph, eta * PI <= ph <= eta * PI / l -> w44 l eta ph = eq44_cases_2 l eta ph) /\ (forall ph, eta * PI / l <= ph <= PI -> w44 l eta ph = eq44_cases_3 l eta ph).
Proof.
  intros h1 h2. pose proof PI_RGT_0. assert (e0 : 0 < eta * PI) by nra. assert (e1 : l * (eta * PI / l) = eta * PI) by (field; lra). assert (e2 : eta * PI < eta * PI / l) by (apply (Rmult_lt_reg_l l); [ lra | rewrite e1; nra ]). assert (e3 : eta * PI / l < PI) by (apply (Rmult_lt_reg_l l); [ lra | rewrite e1; nra ]).
  unfold w44, eq44_ends_1, eq44_ends_2. split; [ lra | split; [ lra | ] ].
  assert (last : ext PI (glue (eta * PI) (eq44_cases_1 l eta) (glue (eta * PI / l) (eq44_cases_2 l eta) (eq44_cases_3 l eta))) PI = 0).
  { match goal with |- ext PI ?G PI = 0 => pose proof (ext_anti PI G H 0) as Q end. rewrite Rplus_0_l in Q. rewrite Q, ext_first, glue_l by lra. unfold eq44_cases_1. ring. }
  split; [ | split ]; intros ph Hph.
  - rewrite ext_first by lra. destruct (Req_dec ph (eta * PI)) as [-> | n]; [ rewrite glue_r, glue_l by lra; unfold eq44_cases_1, eq44_cases_2; ring | apply glue_l; lra ].
  - rewrite ext_first, glue_r by lra. destruct (Req_dec ph (eta * PI / l)) as [-> | n]; [ rewrite glue_r by lra; unfold eq44_cases_2, eq44_cases_3; lra | apply glue_l; lra ].
  - destruct (Req_dec ph PI) as [-> | n]; [ exact last | rewrite ext_first, !glue_r by lra; trivial ].
Qed.
Lemma w44_late l eta : 0 < eta < l -> l < 1 -> (forall ph, w44 l eta (ph + PI) = - w44 l eta ph) /\ late l (pulse eta) (w44 l eta) /\ caught l (pulse eta) (w44 l eta).
Proof.
  intros h1 h2. destruct (w44_cases l eta h1 h2) as (e0 & e1 & C1 & C2 & C3). pose proof PI_RGT_0. assert (el : l * (eta * PI / l) = eta * PI) by (field; lra).
  assert (A : forall ph, w44 l eta (ph + PI) = - w44 l eta ph) by (intros; apply ext_anti; trivial).
  assert (M : forall p, moves l (pulse eta) p (fun t => w44 l eta (p + t)) (fun _ => 0)).
  { apply half_arc; trivial; [ lra | apply pulse_anti | | ]; unfold eq44_ends_1, eq44_ends_2.
    - rewrite !glue_r, glue_l by lra. unfold eq44_cases_3, eq44_cases_1. ring.
    - apply arc_glue; [ lra | | apply arc_glue; [ lra | | | unfold eq44_cases_2, eq44_cases_3; lra ] | rewrite glue_l by lra; unfold eq44_cases_1, eq44_cases_2; ring ].
      + apply (arc_slip l _ 1); [ lra | slope | ]. intros t Ht. split; [ apply pulse_on; lra | unfold eq44_cases_1; nra ].
      + apply (arc_slip l _ 0); [ lra | slope | ]. intros t Ht. split; [ apply pulse_on; lra | unfold eq44_cases_2; nra ].
      + apply arc_still. intros t Ht. rewrite (proj2 (pulse_on eta t ltac:(lra))) by lra. rewrite Rabs_R0. lra. }
  assert (C : caught l (pulse eta) (w44 l eta)) by (apply (gap_caught eta l _ (eta * PI / l)); trivial; lra || (intros; apply C3; lra)).
  split; [ trivial | split; trivial ]. apply caught_late; trivial. now apply half_per.
Qed.

(* up to the width: it passes from backward to forward at once, at the phase right_periodic_small_friction_start *)
Notation start := right_periodic_small_friction_start.
Definition below44 (l eta : R) : R -> R := glue (right_periodic_small_friction_ends_1 eta) (right_periodic_small_friction_cases_1 l eta)
  (glue (right_periodic_small_friction_ends_2 eta) (right_periodic_small_friction_cases_2 l eta) (right_periodic_small_friction_cases_3 l eta)).
Definition w_below (l eta ph : R) : R := ext PI (fun s => below44 l eta (start l eta + s)) (ph - start l eta).
Lemma w_below_on l eta ph : start l eta <= ph < PI + start l eta -> w_below l eta ph = below44 l eta ph.
Proof. intros H. unfold w_below. rewrite ext_first by lra. f_equal. ring. Qed.
Lemma w_below_late l eta : 0 < l <= eta -> eta < 1 -> (forall ph, w_below l eta (ph + PI) = - w_below l eta ph) /\ late l (pulse eta) (w_below l eta) /\
  w_below l eta (start l eta) = 0 /\ forall ph, start l eta < ph < PI + start l eta -> 0 < w_below l eta ph.
Proof.
  intros h1 h2. pose proof PI_RGT_0. set (b := start l eta). assert (hb : 0 <= b < eta * PI) by (unfold b, start; nra). assert (eb : 2 * b = PI * (eta - l)) by (unfold b, start; field). assert (ep : eta * PI < PI) by nra.
  assert (A : forall ph, w_below l eta (ph + PI) = - w_below l eta ph) by (intros ph; unfold w_below; rewrite <- ext_anti by trivial; f_equal; ring).
  set (c1 := right_periodic_small_friction_cases_1 l eta). set (c2 := right_periodic_small_friction_cases_2 l eta). set (c3 := right_periodic_small_friction_cases_3 l eta).
  assert (P1 : forall t, b <= t -> 0 <= c1 t /\ (b < t -> 0 < c1 t)) by (intros t Ht; unfold c1, right_periodic_small_friction_cases_1; fold (start l eta); fold b; split; intros; nra).
  assert (v2 : c2 PI = (1 + l) * b) by (unfold c2, right_periodic_small_friction_cases_2; fold (start l eta); fold b; nra).
  assert (P2 : forall t, c2 t = (1 + l) * b + l * (PI - t)) by (intros t; rewrite <- v2; unfold c2, right_periodic_small_friction_cases_2; ring).
  assert (P3 : forall t, c3 t = (1 + l) * (PI + b - t)) by (intros t; transitivity (c2 PI - (1 + l) * (t - PI)); [ unfold c2, c3, right_periodic_small_friction_cases_2, right_periodic_small_friction_cases_3; ring | rewrite v2; ring ]).
  assert (j1 : c1 (eta * PI) = c2 (eta * PI)) by (unfold c1, c2, right_periodic_small_friction_cases_1, right_periodic_small_friction_cases_2; ring).
  assert (j2 : c2 PI = c3 PI) by (rewrite v2, P3; ring).
  assert (M : forall p, moves l (pulse eta) p (fun t => w_below l eta (p + t)) (fun _ => 0)).
  { intros p. pose proof (half_arc l (fun s => pulse eta (b + s)) PI (fun s => below44 l eta (b + s)) ltac:(lra) H) as Q. unfold moves, w_below. fold b.
    replace (fun t => - pulse eta (p + t)) with (fun t => - pulse eta (b + (p - b + t))) by (apply functional_extensionality; intros t; do 2 f_equal; ring).
    replace (fun t => ext PI (fun s => below44 l eta (b + s)) (p + t - b)) with (fun t => ext PI (fun s => below44 l eta (b + s)) (p - b + t)) by (apply functional_extensionality; intros t; f_equal; ring).
    apply Q.
    - intros t. rewrite <- pulse_anti. f_equal. ring.
    - rewrite Rplus_0_r. unfold below44, right_periodic_small_friction_ends_1, right_periodic_small_friction_ends_2. rewrite (glue_r _ _ _ (b + PI)), (glue_r _ _ _ (b + PI)), glue_l by lra.
      fold c1 c3. rewrite P3. unfold c1, right_periodic_small_friction_cases_1. fold (start l eta). fold b. ring.
    - assert (R : arc l l (pulse eta) b (b + PI) (below44 l eta)).
      { unfold below44, right_periodic_small_friction_ends_1, right_periodic_small_friction_ends_2. fold c1 c2 c3.
        apply arc_glue; [ lra | | apply arc_glue; [ lra | | | trivial ] | rewrite glue_l by lra; trivial ].
        - apply (arc_slip l _ 1); [ lra | unfold c1; slope | ]. intros t Ht. split; [ apply pulse_on; lra | apply P1; lra ].
        - apply (arc_slip l _ 0); [ lra | unfold c2; slope | ]. intros t Ht. split; [ apply pulse_on; lra | rewrite P2; nra ].
        - apply (arc_slip l _ (-1)); [ lra | unfold c3; slope | ]. intros t Ht. split; [ | rewrite P3; nra ].
          replace t with (t - PI + PI) by ring. rewrite pulse_anti, (proj1 (pulse_on eta (t - PI) ltac:(lra))) by lra. ring. }
      destruct R as [R1 R2]. split; intros t Ht; [ apply cont_phase, R1; lra | ]. destruct (R2 (b + t)) as (f & F & X); [ lra | ]. exists f. split; [ exact F | now apply rder_phase ]. }
  assert (Z : w_below l eta b = 0) by (rewrite w_below_on by (fold b; lra); unfold below44, right_periodic_small_friction_ends_1; rewrite glue_l by lra; unfold right_periodic_small_friction_cases_1; fold (start l eta); fold b; ring).
  assert (Pos : forall ph, b < ph < PI + b -> 0 < w_below l eta ph).
  { intros ph Hph. rewrite w_below_on by (fold b; lra). unfold below44, right_periodic_small_friction_ends_1, right_periodic_small_friction_ends_2. fold c1 c2 c3.
    destruct (Rlt_le_dec ph (eta * PI)); [ rewrite glue_l by trivial; apply P1; lra | rewrite glue_r by trivial ].
    destruct (Rlt_le_dec ph PI); [ rewrite glue_l, P2 by trivial | rewrite glue_r, P3 by trivial ]; nra. }
  split; [ trivial | split; [ | split; trivial ] ]. apply (passing_late l (pulse eta) (w_below l eta) ltac:(lra) A M b PI); trivial.
  - intros t. destruct (pulse_size eta t) as [-> | ->]; lra.
  - intros t Ht. specialize (Pos (t + PI) ltac:(lra)). rewrite A in Pos. lra.
  - intros t Ht. apply Pos. lra.
Qed.
(* friction as strong as the pulses, or stronger: rest *)
Lemma pulses_still l eta : 0 < eta < 1 -> 1 <= l -> late l (pulse eta) (fun _ => 0) /\ caught l (pulse eta) (fun _ => 0).
Proof.
  intros he hl. pose proof PI_RGT_0. assert (M : forall p, moves l (pulse eta) p (fun t => (fun _ => 0) (p + t)) (fun _ => 0)).
  { intros p. split; [ intros; cont | intros; cont | intros t _ ]. exists (- pulse eta (p + t)), 0. split; [ split | split; (eapply rder_eq; [ rd | ring ]) ].
    - assert (Rabs (pulse eta (p + t)) <= l) as B by (destruct (pulse_size eta (p + t)) as [-> | ->]; lra). apply Rabs_le_between in B. nra.
    - rewrite nrm_x, Rabs_R0. ring. }
  assert (C : caught l (pulse eta) (fun _ => 0)) by (apply (gap_caught eta l _ (eta * PI)); trivial; try lra; [ intros; ring | nra ]). split; trivial. now apply caught_late.
Qed.
