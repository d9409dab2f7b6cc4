(* 2.3: a drive in steps under which rests come and go with the friction. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis HalfPeriod Drawn Line Median Mean Generic Pulses.
Open Scope R_scope.

(* a drive h whose second half period is the opposite of the first *)
Section Halves.
Variable h : R -> R.
Hypothesis ha : forall t, h (t + PI) = - h t.
Hypothesis hi : forall a b, ex_RInt h a b.
Notation G := (RInt h 0).
Lemma half_prim t : G (t + PI) = G PI - G t.
Proof.
  pose proof (prim_between h hi PI (t + PI)) as P. pose proof (RInt_comp_lin h 1 PI 0 t) as L. rewrite Rmult_0_r, !Rplus_0_l, Rmult_1_l in L.
  enough (E : RInt h PI (t + PI) = - G t) by lra. rewrite <- L by apply hi. change (- G t) with (opp (G t)).
  rewrite <- (RInt_opp h 0 t) by apply hi. apply RInt_ext. intros s _. rewrite Rmult_1_l, ha, Rmult_1_l. reflexivity.
Qed.
Lemma half_median H c : (forall t, continuity_pt H t) -> (forall t, H (t + PI) = 2 * c - H t) -> median H c.
Proof.
  intros cH aH x. pose proof PI_RGT_0. assert (E : forall x, RInt (fun t => Rabs (H t - x)) 0 (2 * PI) = RInt (fun t => Rabs (H t - x) + Rabs (H
    t - (2 * c - x))) 0 PI).
  { intros y. pose proof (cont_int _ (abs_cont H cH y)) as Ai. rewrite <- (RInt_Chasles _ 0 PI (2 * PI)) by apply Ai.
    rewrite (RInt_plus (fun t => Rabs (H t - y)) (fun t => Rabs (H t - (2 * c - y)))) by (apply cont_int; auto). f_equal.
    pose proof (RInt_comp_lin (fun t => Rabs (H t - y)) 1 PI 0 PI) as L. rewrite Rmult_0_r, !Rplus_0_l, Rmult_1_l in L.
    replace (2 * PI) with (PI + PI) by ring. rewrite <- L by apply Ai.
    apply RInt_ext. intros s _. rewrite !Rmult_1_l, aH, <- Rabs_Ropp. f_equal. ring. }
  rewrite !E. apply RInt_le; [ lra | | | ]; try (apply cont_int; intros; cont).
  intros t _. abs.
Qed.
End Halves.
(* integrable on each half period, integrable *)
Lemma int_halves (h : R -> R) : (forall n, ex_RInt h (IZR n * PI) ((IZR n + 1) * PI)) -> forall a b, ex_RInt h a b.
Proof.
  intros I a b. pose proof PI_RGT_0. assert (J : forall (k : nat), ex_RInt h (0 - INR k * PI) (0 + INR k * PI)).
  { induction k as [ | k IH ]; [ simpl; replace (0 - 0 * PI) with (0 + 0 * PI) by ring; apply ex_RInt_point | ].
    apply (ex_RInt_Chasles h _ (0 + INR k * PI)); [ apply (ex_RInt_Chasles h _ (0 - INR k * PI)); trivial | ].
    - pose proof (I (- Z.of_nat k - 1)%Z) as K. rewrite minus_IZR, opp_IZR, <- INR_IZR_INZ in K. rewrite S_INR.
      replace (0 - (INR k + 1) * PI) with ((- INR k - 1) * PI) by ring.
      replace (0 - INR k * PI) with ((- INR k - 1 + 1) * PI) by ring. trivial.
    - pose proof (I (Z.of_nat k)) as K. rewrite <- INR_IZR_INZ in K. now rewrite S_INR, !Rplus_0_l. }
  destruct (nat_above ((Rabs a + Rabs b) / PI)) as [n Hn]. apply Rlt_div_l in Hn; trivial. pose proof (Rabs_pos a). pose proof (Rabs_pos b).
  apply (ex_RInt_inside h a b 0 (INR n * PI) (J n)); rewrite Rminus_0_r; lra.
Qed.

(* 1 up to a, then -1 up to b, and u to the end of the half period; the other one by (43) *)
Section Three.
Variables a b u : R.
Hypothesis H : 0 < a < b /\ b < PI.
Definition three : R -> R := ext PI (fun s => if Rlt_dec s a then 1 else if Rlt_dec s b then -1 else u).
Lemma three_on n t : let s := t - IZR n * PI in (0 <= s < a -> three t = sg n) /\ (a <= s < b -> three t = - sg n) /\ (b <= s < PI ->
  three t = sg n * u).
Proof. pose proof PI_RGT_0 as p. cbv zeta. unfold three. repeat split; intros K; rewrite (ext_on PI _ p n) by lra; repeat destruct Rlt_dec; lra.
Qed.
Lemma three_first t : (0 <= t < a -> three t = 1) /\ (a <= t < b -> three t = -1) /\ (b <= t < PI -> three t = u).
Proof. unfold three. repeat split; intros K; rewrite ext_first by lra; repeat destruct Rlt_dec; lra. Qed.
Lemma three_anti t : three (t + PI) = - three t. Proof. apply ext_anti, PI_RGT_0. Qed.
(* each phase is within a step *)
Lemma three_step t : exists x y c, x <= t < y /\ (forall s, x <= s < y -> three s = c) /\ (Rabs c = 1 \/ Rabs c = Rabs u).
Proof.
  pose proof PI_RGT_0 as p. destruct (per_spec 0 PI p t) as [n Hn]. assert (A : Rabs (sg n) = 1) by (destruct (sg_cases n) as [-> | ->]; abs).
  destruct (Rlt_le_dec (t - IZR n * PI) a); [ | destruct (Rlt_le_dec (t - IZR n * PI) b) ].
  - exists (IZR n * PI), (IZR n * PI + a), (sg n). split; [ lra | split; auto ]. intros s Hs. apply three_on. lra.
  - exists (IZR n * PI + a), (IZR n * PI + b), (- sg n). split; [ lra | split; [ | rewrite Rabs_Ropp; auto ] ]. intros s Hs. apply (three_on n).
    lra.
  - exists (IZR n * PI + b), ((IZR n + 1) * PI), (sg n * u). split; [ lra | split ]. intros s Hs. apply (three_on n). lra. right.
    rewrite Rabs_mult, A. ring.
Qed.
Hypothesis hu : Rabs u <= 1.
Lemma three_normalised : normalised three.
Proof.
  pose proof PI_RGT_0 as p. split.
  - apply half_per, three_anti.
  - intros t e he. destruct (three_step t) as (x & y & c & Ht & S & _). exists (y - t). split; [ lra | ]. intros s Hs. rewrite !S by lra.
    rewrite Rminus_eq_0, Rabs_R0. trivial.
  - apply int_halves. intros n.
    assert (C : forall x y c, x <= y -> (forall s, x <= s < y -> three s = c) -> ex_RInt three x y).
    { intros x y c Hxy S. apply (ex_RInt_ext (fun _ => c)); [ | apply ex_RInt_const ]. intros s Hs.
      rewrite Rmin_left, Rmax_right in Hs by trivial. symmetry. apply S. lra. }
    apply (ex_RInt_Chasles _ _ (IZR n * PI + a)); [ | apply (ex_RInt_Chasles _ _ (IZR n * PI + b)) ].
    + apply (C _ _ (sg n)); [ lra | ]. intros s Hs. apply (three_on n). lra.
    + apply (C _ _ (- sg n)); [ lra | ]. intros s Hs. apply (three_on n). lra.
    + apply (C _ _ (sg n * u)); [ lra | ]. intros s Hs. apply (three_on n). lra.
  - intros t. destruct (three_step t) as (x & y & c & Ht & S & [e | e]); rewrite S, e by trivial; lra.
  - intros l Hl. exists 0. rewrite (proj1 (three_first 0)) by lra. abs.
Qed.
Lemma three_mean : mean three = 0.
Proof.
  pose proof (half_prim three three_anti (d_int three_normalised) PI) as K. replace (PI + PI) with (2 * PI) in K by ring. unfold mean.
  rewrite K. unfold Rdiv. rewrite Rminus_eq_0. apply Rmult_0_l.
Qed.
End Three.

(* Dimensionless: 1 for half of each half period, then -1 up to 7 PI / 8 of it, then 1/6; in the next one the opposite. «$h_{\mathrm s}$» *)
Definition step_drive : R -> R := three (PI / 2) (7 * PI / 8) (1 / 6).
Lemma steps_places : 0 < PI / 2 < 7 * PI / 8 /\ 7 * PI / 8 < PI. Proof. pose proof PI_RGT_0. lra. Qed.
Lemma sixth : Rabs (1 / 6) = 1 / 6. Proof. apply Rabs_pos_eq. lra. Qed.
Lemma steps_anti t : step_drive (t + PI) = - step_drive t. Proof. apply three_anti. Qed.
Lemma steps_on n t : let s := t - IZR n * PI in (0 <= s < PI / 2 -> step_drive t = sg n) /\ (PI / 2 <= s < 7 * PI / 8 ->
  step_drive t = - sg n) /\ (7 * PI / 8 <= s < PI -> step_drive t = sg n * (1 / 6)).
Proof. exact (three_on _ _ _ steps_places n t). Qed.
Lemma steps_first t : (0 <= t < PI / 2 -> step_drive t = 1) /\ (PI / 2 <= t < 7 * PI / 8 -> step_drive t = -1) /\ (7 * PI / 8 <= t < PI ->
  step_drive t = 1 / 6).
Proof. exact (three_first _ _ _ steps_places t). Qed.
Lemma steps_normalised : normalised step_drive. Proof. apply three_normalised; [ exact steps_places | rewrite sixth; lra ]. Qed.
Lemma steps_size t : 1 / 6 <= Rabs (step_drive t).
Proof. destruct (three_step _ _ (1 / 6) steps_places t) as (x & y & c & Ht & S & e). rewrite sixth in e. unfold step_drive.
rewrite S by trivial. lra. Qed.
Lemma steps_generic : generic step_drive.
Proof.
  pose proof PI_RGT_0 as p. pose proof steps_normalised as N. split; trivial.
  - exists (7 * PI / 8). unfold step_drive. rewrite (proj2 (proj2 (steps_first _))), sixth; lra.
  - intros _. exists (RInt step_drive 0 PI / 2). split.
    + apply half_median; [ apply (prim_cont step_drive 1); apply N | ]. intros t. rewrite (half_prim step_drive steps_anti (d_int N)). field.
    + intros t _. exists (1 / 6). split; [ lra | ]. intros s _. apply steps_size.
Qed.
(* friction below every step: no rest *)
Lemma steps_none : has_rests (1 / 8) step_drive 0.
Proof. apply unsteady_none; [ intros t; pose proof (steps_size t) | ]; lra. Qed.

(* straight pieces of a velocity that keeps the sense s *)
Lemma straight l h p q c s y : 0 <= l -> p <= q -> s = 1 \/ s = -1 -> (forall t, p <= t < q -> h t = c) -> 0 <= s * y ->
  0 <= s * (y + (c - s * l) * (q - p)) ->
  arc l l h p q (fun t => y + (c - s * l) * (t - p)).
Proof.
  intros hl Hpq hs H a b. apply (arc_slip s l h c); trivial; [ intros; auto_derive; trivial; ring | ]. intros t Ht. split; [ now apply H | ].
  assert (K : 0 <= s * (y + (c - s * l) * (t - p)) * (q - p)).
  { replace (s * (y + (c - s * l) * (t - p)) * (q - p)) with (s * y * (q - t) + s * (y + (c - s * l) * (q - p)) * (t - p)) by ring.
    apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra. }
  apply (Rmult_le_reg_r (q - p)); lra.
Qed.
Ltac glued := repeat ((rewrite glue_l by lra) || (rewrite glue_r by lra)); cbv beta; try lra.
(* an arc of straight pieces under the steps F *)
Ltac pieces F := repeat (apply arc_glue; [ lra | | | glued ]);
  first [ apply arc_still; intros t Ht; rewrite (proj2 (proj2 (F t))) by lra; abs | apply straight; try lra; auto; intros t Ht; apply F; lra ].
(* all become one that rests: rests *)
Lemma caught_rests l h W r s c : normalised h -> 0 < l < 1 -> (forall t, h (t + PI) = - h t) -> (forall t, W (t + PI) = - W t) ->
  (forall p, moves l h p (fun t => W (p + t)) (fun _ => 0)) ->
  0 <= r < s -> (forall t, r <= t <= s -> W t = 0) -> (forall t, r <= t < s -> h t = c) -> Rabs c < l -> has_rests l h 1.
Proof.
  intros N hl ha A M hr Z C hc p vx vy V. pose proof PI_RGT_0. left. split; trivial. split; [ | intros; apply (moves_again h N l p); trivial; lra ].
  destruct (rest_caught l h W ltac:(lra) ha A M r s c ltac:(lra) Z C hc p vx vy V) as (t1 & h1 & E). exists t1. intros t Ht.
  destruct (per_spec (p + t) (2 * PI) ltac:(lra) r) as [n Hn].
  exists (r - IZR n * (2 * PI) - p), (s - r). split; [ lra | split; [ lra | ] ]. intros u Hu. destruct (E u ltac:(lra)) as [-> ->].
  rewrite <- (shift_Z (2 * PI) W (half_per W A) (- n)), Z, nrm_x by (rewrite opp_IZR; lra). apply Rabs_R0.
Qed.
(* half a period of the motion at large times with the friction 1/5: forward, backward, and rest to the end *)
Definition w5 : R -> R := ext PI (glue (PI / 2) (fun t => 0 + (1 - 1 * (1 / 5)) * (t - 0)) (glue (5 * PI / 6) (fun t => 2 * PI / 5 + (-1 - 1 * (1
  / 5)) * (t - PI / 2))
  (glue (7 * PI / 8) (fun t => 0 + (-1 - -1 * (1 / 5)) * (t - 5 * PI / 6)) (glue (85 * PI / 88) (fun t => - PI / 30 + (1 / 6 - -1 * (1 / 5)) * (t
    - 7 * PI / 8)) (fun _ => 0))))).
Lemma steps_some : has_rests (1 / 5) step_drive 1.
Proof.
  pose proof PI_RGT_0 as p. assert (A : forall t, w5 (t + PI) = - w5 t) by (intros; now apply ext_anti).
  apply (caught_rests (1 / 5) step_drive w5) with (r := 85 * PI / 88) (s := PI) (c := 1 / 6); trivial; try lra; [ apply steps_normalised
    | apply steps_anti | | | | rewrite sixth; lra ].
  - apply half_arc; try lra; [ apply steps_anti | glued | pieces steps_first ].
  - intros t Ht. destruct (Req_dec t PI) as [-> | n]; [ rewrite <- (Rplus_0_l PI), A | ]; unfold w5; rewrite ext_first by lra; glued.
  - intros t Ht. apply steps_first. lra.
Qed.
(* Dimensionless: 1 up to PI / 8, -1 up to PI / 4, and 0 for the rest of each half period; in the next one the opposite. Its primitive is at its
   median where it is 0. «$h_0$» *)
Definition halting : R -> R := three (PI / 8) (PI / 4) 0.
(* there is rest at every friction; x is for how long the particle goes forward against the drive *)
Lemma halting_rests l : 0 < l < 1 -> has_rests l halting 1.
Proof.
  intros hl. unfold halting. pose proof PI_RGT_0 as p. assert (P : 0 < PI / 8 < PI / 4 /\ PI / 4 < PI) by lra.
  assert (F := three_first (PI / 8) (PI / 4) 0 P : forall t, _ ).
  set (x := (1 - l) / (1 + l) * (PI / 8)). assert (ex : x * (1 + l) = (1 - l) * (PI / 8)) by (unfold x; field; lra).
  assert (x0 : 0 < x) by (unfold x; apply Rmult_lt_0_compat; [ apply Rdiv_lt_0_compat | ]; lra).
  assert (xl : 0 < x * l) by nra. assert (pl : 0 < l * PI) by nra. assert (x1 : x < PI / 8) by nra. clearbody x.
  set (g := glue (PI / 8) (fun t => 0 + (1 - 1 * l) * (t - 0)) (glue (PI / 8 + x) (fun t => (1 - l) * (PI / 8) + (-1 - 1 * l) * (t - PI / 8))
    (glue (PI / 4) (fun t => 0 + (-1 - -1 * l) * (t - (PI / 8 + x))) (glue (PI / 4 + 2 * x) (fun t => - (2 * l * x) + (0 - -1 * l) * (t - PI /
      4)) (fun _ => 0))))).
  assert (A : forall t, ext PI g (t + PI) = - ext PI g t) by (intros; now apply ext_anti).
  apply (caught_rests l (three (PI / 8) (PI / 4) 0) (ext PI g)) with (r := PI / 4 + 2 * x) (s := PI) (c := 0); trivial; try lra;
    [ apply three_normalised; [ lra | abs ] | apply three_anti | | | | abs ].
  - apply half_arc; try lra; [ apply three_anti | unfold g; glued | unfold g; pieces F ].
  - intros t Ht. destruct (Req_dec t PI) as [-> | n]; [ pose proof (A 0) as K; rewrite Rplus_0_l in K; rewrite K | ]; unfold g;
    rewrite ext_first by lra; glued.
  - intros t Ht. apply F. lra.
Qed.
(* with the friction 1/2: forward, and backward at once *)
Definition w2 : R -> R := ext PI (glue (PI / 2) (fun t => PI / 64 + (1 - 1 * (1 / 2)) * (t - 0)) (glue (65 * PI / 96) (fun t => 17 * PI / 64 +
  (-1 - 1 * (1 / 2)) * (t - PI / 2))
  (glue (7 * PI / 8) (fun t => 0 + (-1 - -1 * (1 / 2)) * (t - 65 * PI / 96)) (fun t => - 19 * PI / 192 + (1 / 6 - -1 * (1 / 2)) * (t - 7 * PI /
    8))))).
Lemma w2_late : late (1 / 2) step_drive w2.
Proof.
  pose proof PI_RGT_0 as p. assert (A : forall t, w2 (t + PI) = - w2 t) by (intros; now apply ext_anti).
  assert (B : forall t, w2 t = - w2 (t + PI)) by (intros; rewrite A; ring).
  apply (passing_late (1 / 2) step_drive w2) with (z := - 31 * PI / 96) (d := PI / 16); trivial; try lra.
  - apply half_arc; try lra; [ apply steps_anti | glued | pieces steps_first ].
  - apply steps_normalised.
  - rewrite B. unfold w2. rewrite ext_first by lra. glued.
  - intros t Ht. rewrite B. unfold w2. rewrite ext_first by lra. glued.
  - intros t Ht. rewrite B. unfold w2. rewrite ext_first by lra. glued.
Qed.
Lemma steps_none_again : has_rests (1 / 2) step_drive 0.
Proof.
  intros p vx vy M. pose proof PI_RGT_0 as pp. right. split; trivial. destruct (late_drawn _ _ _ w2_late p vx vy M) as [L _].
  destruct (Analysis.lim_near _ _ (PI / 64) L ltac:(lra)) as (t1 & t10 & D). apply (held_nowhere (1 / 2) step_drive p vx vy t1); trivial; [ lra | ].
  intros s Hs z _. apply Rnot_le_lt. intros R. specialize (D s Hs). cbv beta in D. rewrite z in D.
  destruct (per_spec 0 PI pp (p + s)) as [n Hn]. destruct (steps_on n (p + s)) as (S1 & S2 & S3).
  assert (q : sg n = 1 \/ sg n = -1) by apply sg_cases. unfold w2 in D. rewrite (ext_on PI _ pp n) in D by lra.
  assert (Hx : 0 <= p + s - IZR n * PI < PI) by lra. set (x := p + s - IZR n * PI) in *.
  destruct (Rlt_le_dec x (PI / 2)); [ | destruct (Rlt_le_dec x (7 * PI / 8)) ].
  - rewrite S1 in R by lra. apply Rabs_le_between in R. destruct q as [e | e]; rewrite e in R; lra.
  - rewrite S2 in R by lra. apply Rabs_le_between in R. destruct q as [e | e]; rewrite e in R; lra.
  - revert D. glued. destruct q as [-> | ->]; intros D; lra.
Qed.

(* the sine *)
Lemma sine_normalised : normalised sin.
Proof.
  assert (C : forall t, continuity_pt sin t) by apply continuity_sin. split.
  - apply sin_per.
  - intros t. apply cont_rcont, C.
  - now apply cont_int.
  - intros t. apply Rabs_le, SIN_bound.
  - intros l Hl. exists (PI / 2). rewrite sin_PI2, Rabs_R1. trivial.
Qed.
