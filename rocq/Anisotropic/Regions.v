(* 2.4: what the motion at large times does for every q >= 1 and 0 < lambda0 < 1, on the curves too. The slip from sin^-1 lambda0 ends at
   some phase e, and the curves A, B, E of (53), (54) and the correction say where e is: at sin^-1 lambda0 + 2 K, where the drive begins,
   or where it ceases, to pull backward. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn Line Formulas.
From Slipbook Require Export Slips.
Open Scope R_scope.

Notation K := eq53_k.
(* a chain of statements, each at hand or by lra *)
Ltac and_so := repeat match goal with |- _ /\ _ => split; [ solve [ assumption | lra ] | ] end; try assumption; try lra.
(* below A, B and E: their left side is larger (below A, B), or smaller (below E); dimensionless *)
Definition below_A q l : Prop := eq53_sides_2 (K q) l < eq53_sides_1 (K q) l.
Definition above_A q l : Prop := eq53_sides_1 (K q) l < eq53_sides_2 (K q) l.
Definition below_B q l : Prop := eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l).
Definition above_B q l : Prop := eq54_sides_1 l (q * l) < eq54_sides_2 l (q * l).
Definition below_E q l : Prop := right_anisotropic_e_sides_1 l (q * l) < right_anisotropic_e_sides_2 l (q * l).
Definition above_E q l : Prop := right_anisotropic_e_sides_2 l (q * l) < right_anisotropic_e_sides_1 l (q * l).

Lemma K_facts q : 1 <= q -> PI / 2 <= K q < PI /\ q * (PI - K q) = K q /\ (1 < q -> PI / 2 < K q) /\ 0 < sin (K q).
Proof.
  intros hq. pose proof PI_RGT_0. assert (e : q * (PI - K q) = K q) by (unfold eq53_k; field; lra).
  assert (K q < PI) by nra. assert (PI / 2 <= K q) by nra. repeat split; trivial; [ intros; nra | apply sin_gt_0; lra ].
Qed.
Lemma al_be q l : 1 <= q -> 0 < l -> q * l < 1 -> 0 < asin l <= asin (q * l) /\ asin (q * l) < PI / 2.
Proof.
  intros hq h0 h1. assert (l <= q * l) by nra. destruct (asin_range l) as [a _]; [ lra | ]. destruct (asin_range (q * l)) as [b _]; [ lra | ].
  repeat split; try lra. destruct (Req_dec l (q * l)) as [<- | n]; [ | left; apply asin_up ]; lra.
Qed.
(* the velocity of the slip from asin l at the three phases *)
Lemma at_A q l : 1 <= q -> 0 < l <= 1 -> fwd l (asin l) (asin l + 2 * K q) = 2 * l * sin (K q) ^ 2 * (eq53_sides_1 (K q) l - eq53_sides_2 (K q) l).
Proof.
  intros hq hl. destruct (K_facts q hq) as (_ & _ & _ & s). destruct (asin_closed l hl) as [_ e]. unfold fwd, eq53_sides_1, eq53_sides_2, cot.
  rewrite <- cos_asin_pow, cos_plus, cos_2a_sin, sin_2a, e by lra. field. lra.
Qed.
Lemma at_B q l : 0 < l <= 1 -> 0 < q * l <= 1 -> fwd l (asin l) (PI + asin (q * l)) = eq54_sides_1 l (q * l) - eq54_sides_2 l (q * l).
Proof. intros h1 h2. unfold fwd, eq54_sides_1, eq54_sides_2. rewrite Rplus_comm, neg_cos, !cos_asin_pow by lra. ring. Qed.
Lemma at_E q l : 0 < l <= 1 -> 0 < q * l <= 1 -> fwd l (asin l) (2 * PI - asin (q * l)) = right_anisotropic_e_sides_1 l (q * l) - right_anisotropic_e_sides_2 l (q * l).
Proof.
  intros h1 h2. unfold fwd, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. rewrite <- !cos_asin_pow by lra.
  replace (2 * PI - asin (q * l)) with (- asin (q * l) + 2 * PI) by ring. rewrite cos_per, cos_neg. ring.
Qed.
Lemma end_and_curves q l e : 1 <= q -> 0 < l < 1 -> ends l (asin l) e ->
  (above_A q l <-> e < asin l + 2 * K q) /\ (below_A q l <-> asin l + 2 * K q < e) /\
  (q * l < 1 -> (above_B q l <-> e < PI + asin (q * l)) /\ (below_B q l <-> PI + asin (q * l) < e) /\ (below_E q l <-> e < 2 * PI - asin (q * l))).
Proof.
  intros hq hl E. destruct (K_facts q hq) as (k & _ & _ & s).
  assert (c : 0 < 2 * l * sin (K q) ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; lra).
  destruct (end_is l _ e (asin l + 2 * K q) E) as [A1 A2]; [ lra | ]. rewrite at_A in A1, A2 by lra. unfold above_A, below_A.
  split; [ rewrite <- A2; split; intros; nra | split; [ rewrite <- A1; split; intros; nra | ] ].
  intros h1. assert (0 < q * l) by nra. destruct (al_be q l hq ltac:(lra) h1). destruct (end_is l _ e (PI + asin (q * l)) E) as [B1 B2]; [ lra | ].
  destruct (end_is l _ e (2 * PI - asin (q * l)) E) as [_ E2]; [ lra | ].
  rewrite at_B in B1, B2 by lra. rewrite at_E in E2 by lra. unfold above_B, below_B, below_E. rewrite <- B1, <- B2, <- E2. lra.
Qed.

(* ---- I, and A: a slip of the length 2 K with the middle c, and one of 2 PI - 2 K back ---- *)
Lemma far_phase z : 0 < z < PI / 2 -> z * cos z < (PI / 2 + z) * (PI / 2 - z) * sin z.
Proof.
  intros H. pose proof PI2_3_2. pose proof PI_4. destruct (Rle_lt_dec z 1) as [k | k].
  - pose proof (x_cos_lt z ltac:(lra)). assert (0 < sin z) by (apply sin_gt_0; lra). assert (1 <= (PI / 2 + z) * (PI / 2 - z)) by nra. nra.
  - rewrite <- (sin_shift z), <- (cos_shift z). set (y := PI / 2 - z). assert (0 < y <= PI / 3) by (unfold y; lra).
    pose proof (sin_lt_x y ltac:(lra)).
    assert (1 / 2 <= cos y) by (rewrite <- cos_PI3; apply cos_decr_1; lra). assert (z <= (PI / 2 + z) * cos y) by nra. nra.
Qed.
Lemma gain q : 1 <= q -> (q - 1) * sin (K q) <= - 2 * K q * cos (K q) /\ (1 < q -> (q - 1) * sin (K q) < - 2 * K q * cos (K q)).
Proof.
  intros hq. destruct (K_facts q hq) as (hk & kq & kq' & s0). set (k := K q) in *. assert (F : 1 < q -> (q - 1) * sin k < - 2 * k * cos k).
  { intros h. pose proof (far_phase (k - PI / 2) ltac:(lra)) as F. rewrite sin_minus, cos_minus, cos_PI2, sin_PI2 in F.
    replace (PI / 2 + (k - PI / 2)) with k in F by ring. replace (PI / 2 - (k - PI / 2)) with (PI - k) in F by field.
    apply (Rmult_lt_reg_r (PI - k)); [ lra | ]. replace ((q - 1) * sin k * (PI - k)) with ((q * (PI - k) - (PI - k)) * sin k) by ring. rewrite kq.
    lra. }
  split; trivial. destruct (Req_dec q 1) as [e | ne]; [ | left; apply F; lra ]. assert (k = PI / 2) as -> by (rewrite e in kq; lra).
  rewrite e, cos_PI2. lra.
Qed.
Lemma fwd_mid l c k : fwd l (c - k) (c + k) = 2 * (sin c * sin k - l * k).
Proof. unfold fwd. rewrite cos_minus, cos_plus. ring. Qed.
Lemma region_1 q l e (m := q * l) : 1 <= q -> 0 < l < 1 -> ends l (asin l) e -> asin l + 2 * K q <= e -> exists a e1, asin l <= a < PI / 2 /\ ends l a e1 /\
  m < 1 /\ PI + asin m <= e1 < 2 * PI - asin m /\ ends m (e1 - PI) (a + PI) /\ e1 = a + 2 * K q /\ (1 < q -> PI + asin m < e1) /\ (a = asin l /\ e1 = e \/ asin l < a /\ e1 < e /\ PI + asin m < e1).
Proof.
  intros hq hl E he. destruct (K_facts q hq) as (hk & kq & _ & s0). destruct (gain q hq) as [g g']. destruct (asin_range l hl) as [a0 ea].
  set (k := K q) in *. pose proof PI_RGT_0.
  set (S := l * k / sin k). assert (eS : S * sin k = l * k) by (unfold S; field; lra). assert (S0 : 0 < S) by (apply Rdiv_lt_0_compat; nra).
  assert (hS : S <= sin (asin l + k)).
  { assert (z : 0 <= fwd l (asin l + k - k) (asin l + k + k)). { replace (asin l + k - k) with (asin l) by ring.
    replace (asin l + k + k) with (asin l + 2 * k) by ring. destruct E as ((_ & z) & P & _). destruct he as [h | ->]; [ left; apply P | ]; lra. }
    rewrite fwd_mid in z. apply (Rmult_le_reg_r (sin k)); lra. }
  assert (S1 : S < 1) by (pose proof (sin_decreasing_1 (PI / 2) (asin l + k)); rewrite sin_PI2 in *; lra).
  destruct (asin_range S ltac:(lra)) as [c0 ec].
  set (c := PI - asin S). assert (sc : sin c = S) by (unfold c; now rewrite sin_PI_x). assert (hc : PI / 2 < c < PI) by (unfold c; lra). clearbody c.
  assert (ha : asin l <= c - k) by (apply Rnot_lt_le; intros h; pose proof (sin_decreasing_1 c (asin l + k)); lra).
  assert (za : l <= sin (c - k) /\ (asin l < c - k -> l < sin (c - k))).
  { assert (asin l < c - k -> l < sin (c - k)) by (intros; apply sin_above; lra). split; trivial. destruct ha as [h | <-]; [ left; auto | lra ]. }
  assert (zm : m <= - sin (c + k) /\ (1 < q \/ asin l < c - k -> m < - sin (c + k))).
  { assert (e1 : - sin (c + k) = sin (c - k) - 2 * S * cos k) by (rewrite sin_plus, sin_minus, sc; ring). rewrite e1. unfold m.
    assert (d : sin k * (- 2 * S * cos k) = l * (- 2 * k * cos k)) by (transitivity (- 2 * cos k * (S * sin k)); [ ring | rewrite eS; ring ]).
    split; [ enough (l * (q - 1) <= - 2 * S * cos k) by lra; apply (Rmult_le_reg_l (sin k)); [ | rewrite d ]; nra | intros [h | h];
    [ specialize (g' h) | ] ].
    - enough (l * (q - 1) < - 2 * S * cos k) by lra. apply (Rmult_lt_reg_l (sin k)); [ | rewrite d ]; nra.
    - enough (l * (q - 1) <= - 2 * S * cos k) by (destruct za; lra). apply (Rmult_le_reg_l (sin k)); [ | rewrite d ]; nra. }
  assert (m1 : m < 1). { pose proof (SIN_bound (c + k)). destruct (Req_dec q 1) as [e1 | n]; [ unfold m; rewrite e1 | ]; lra. }
  assert (m0 : 0 < m) by (unfold m; nra). destruct (asin_range m ltac:(lra)) as [b0 eb].
  assert (sy : sin (c + k - PI) = - sin (c + k)) by (rewrite sin_minus, cos_PI, sin_PI; ring).
  assert (y1 : PI + asin m <= c + k) by (apply Rnot_lt_le; intros h; pose proof (sin_increasing_1 (c + k - PI) (asin m)); lra).
  assert (y2 : c + k < 2 * PI - asin m).
  { destruct (Req_dec q 1) as [e1 | n]; [ rewrite e1 in kq; lra | ]. assert (z : m < - sin (c + k)) by (apply zm; lra). apply Rnot_le_lt.
    intros [h | h]; [ pose proof (sin_less m (c + k - PI) ltac:(lra) ltac:(lra)); lra | ]. rewrite <- h in sy, z.
    replace (2 * PI - asin m - PI) with (PI - asin m) in sy by ring. rewrite sin_PI_x in sy. lra. }
  assert (y3 : 1 < q \/ asin l < c - k -> PI + asin m < c + k).
  { intros h. apply zm in h. destruct y1 as [ | y]; trivial. rewrite <- y in sy, h. replace (PI + asin m - PI) with (asin m) in sy by ring. lra. }
  assert (Ea : ends l (c - k) (c + k)) by (apply ends_at; try lra; rewrite fwd_mid, sc; lra).
  assert (Eb : ends m (c + k - PI) (c - k + PI)).
  { apply ends_at; try lra. replace (c + k - PI) with (c - (PI - k)) by ring. replace (c - k + PI) with (c + (PI - k)) by ring.
    rewrite fwd_mid, sin_PI_x, sc. unfold m. nra. }
  exists (c - k), (c + k). and_so. destruct ha as [h | h].
  - right. and_so. split; [ | auto ]. apply (end_is l (asin l) e (c + k) E); [ lra | ].
    pose proof (fwd_rises l hl (asin l) (asin l) (c - k) ltac:(lra) ltac:(lra)). destruct Ea as ((_ & z) & _). unfold fwd in *. lra.
  - left. split; [ lra | ]. rewrite <- h in Ea. destruct Ea as ((? & z) & _). destruct (end_is l (asin l) e (c + k) E); lra.
Qed.

(* where the forward slip ends before the drive pulls backward, the slip backward ends before the drive pulls forward *)
Lemma second_rest a b : 0 < a <= b -> b < PI / 2 -> cos a + cos b < sin a * (PI + b - a) -> cos a + cos b < sin b * (PI + a - b).
Proof.
  intros h1 h2 H. pose proof PI2_3_2. set (s := (a + b) / 2). set (d := (b - a) / 2). assert (ea : a = s - d) by (unfold s, d; field).
  assert (eb : b = s + d) by (unfold s, d; field).
  assert (hd : 0 <= d < PI / 4) by (unfold d; lra). assert (hs : 0 < s < PI / 2) by (unfold s; lra). clearbody s d. subst a b.
  rewrite cos_minus, cos_plus, sin_plus, sin_minus in *.
  assert (0 < cos s) by (apply cos_gt_0; lra). assert (0 < cos d) by (apply cos_gt_0; lra).
  assert (xd : d * cos d <= sin d) by (destruct hd as [[h | <-] _]; [ left; apply x_cos_lt | rewrite sin_0 ]; lra).
  set (X := cos s * cos d) in *. set (Y := sin s * cos d) in *. set (Z := cos s * sin d) in *. assert (X0 : 0 < X) by (unfold X; nra).
  assert (XZ : d * X <= Z) by (unfold X, Z; nra). clearbody X Y Z.
  assert (G : 2 * X + 2 * (d * X) * (PI + 2 * d) < (Y + Z) * (PI + 2 * d)) by nra. assert (p : 4 <= (PI + 2 * d) * (PI - 2 * d)) by nra.
  apply (Rmult_lt_reg_r (PI + 2 * d)); [ lra | ]. apply (Rmult_lt_compat_r (PI - 2 * d)) in G; [ | lra ].
  assert (0 <= d * X * ((PI + 2 * d) * (PI - 2 * d) - 4)) by (apply Rmult_le_pos; nra). lra.
Qed.

Lemma end_and_B q l e : 1 <= q -> 0 < l < 1 -> ends l (asin l) e -> q * l <= 1 -> asin l < PI + asin (q * l) < asin l + 2 * PI /\ (below_B q l <-> PI + asin (q * l) < e).
Proof.
  intros hq hl E h. assert (0 < q * l) by nra. destruct (asin_range l hl) as [a _]. destruct (asin_closed (q * l)) as [b _]; [ lra | ].
  split; [ lra | ].
  destruct (end_is l _ e (PI + asin (q * l)) E) as [B _]; [ lra | ]. rewrite at_B in B by lra. rewrite <- B. unfold below_B. lra.
Qed.
(* what the curves say of the course a, e, b, e' *)
Record pattern q l a e b e' : Prop := {
  p_rests : above_A q l <-> e' < a + 2 * PI;
  p_back : b < e' <-> q * l < 1 /\ below_E q l;
  p_stops : (e < b <-> q * l < 1 /\ above_B q l) /\ (e < b -> b < e');
  p_turn : q * l <= 1 -> a < PI + asin (q * l) < a + 2 * PI /\ (PI + asin (q * l) <= b \/ b = e') /\ (below_B q l <-> PI + asin (q * l) < e);
  p_start : ~ above_A q l -> (e = b /\ b < e') /\ asin l <= a < PI / 2 /\ (below_A q l -> asin l < a) /\ e < 2 * PI - asin (q * l) /\ (1 < q \/ below_A q l -> PI + asin (q * l) < e) }.
Lemma late_exists q l : 1 <= q -> 0 < l < 1 -> exists a e b e' W, late_slide q l W /\ course a e b e' W /\ pattern q l a e b e' /\ (e' < a + 2 * PI -> reached q l W).
Proof.
  intros hq hl. assert (hm : 0 < q * l) by nra. destruct (asin_range l hl) as [a0 ea]. destruct (slip_ends l hl (asin l)) as [e E]; [ lra | ].
  pose proof PI_RGT_0. destruct (K_facts q hq) as (k & kq & _).
  destruct (end_and_curves q l e hq hl E) as (A & A' & BE). pose proof E as ((he & z) & _). pose proof (end_and_B q l e hq hl E) as EB.
  assert (IV : 1 <= q * l \/ 2 * PI - asin (q * l) <= e -> exists W,
  late_slide q l W /\ course (asin l) e e e W /\ (e < asin l + 2 * PI -> reached q l W)).
  { intros h. apply course_late; trivial; try lra; auto. }
  destruct (Rle_lt_dec (asin l + 2 * K q) e) as [hA | hA]; [ | assert (nA : above_A q l) by now apply A ].
  - destruct (region_1 q l e hq hl E hA) as (a & e1 & ha & E1 & m1 & y & Eb & e2 & q1 & T). destruct (asin_range (q * l)) as [b0 _]; [ lra | ].
    destruct (BE m1) as (B & B' & En).
    destruct (course_late q l a e1 e1 (a + 2 * PI)) as (W & HW & Co & R); auto; try (intros; lra). { right.
    replace (a + 2 * PI - PI) with (a + PI) by ring. auto. }
    assert (X : below_E q l).
    { apply En, Rnot_le_lt. intros h. destruct (IV (or_intror h)) as (U & HU & CU & _).
      assert (N : exists t, U t < 0); [ | apply (course_back U _ _ _ _ (ls_per _ _ _ HU) CU) in N; lra ].
      destruct (proj2 (course_back W _ _ _ _ (ls_per _ _ _ HW) Co)) as [t Ht]; [ lra | ]. exists t. now rewrite (late_slide_unique q l U W HU HW). }
    exists a, e1, e1, (a + 2 * PI), W. split; [ trivial | split; [ trivial | split; [ | intros; lra ] ] ]. split.
    + rewrite A. lra.
    + split; [ auto | lra ].
    + rewrite B. lra.
    + intros _. rewrite B'. lra.
    + rewrite A'. intros _. split; [ lra | split; [ lra | split; [ lra | split; [ lra | intros [h | h]; [ auto | lra ] ] ] ] ].
  - destruct (Rle_lt_dec 1 (q * l)) as [h | h]; [ | destruct (BE h) as (B & B' & En); destruct (al_be q l hq ltac:(lra) h) as [ab b0];
    destruct (Rle_lt_dec (2 * PI - asin (q * l)) e) as [h' | h'] ].
    + destruct (IV (or_introl h)) as (W & HW & Co & R). exists (asin l), e, e, e, W. and_so. split; [ | trivial ]. split; intuition lra.
    + destruct (IV (or_intror h')) as (W & HW & Co & R). exists (asin l), e, e, e, W. and_so. split; [ | trivial ].
      split; rewrite ?B, ?B', ?En; intuition lra.
    + set (be := asin (q * l)) in *. set (b := Rmax e (PI + be)).
      assert (hb : b = e /\ PI + be <= e \/ b = PI + be /\ e < PI + be) by (unfold b, Rmax; destruct Rle_dec; lra).
      assert (hb' : PI + be <= b < 2 * PI - be) by lra.
      destruct (slip_ends (q * l) ltac:(lra) (b - PI)) as [f F]; [ fold be; lra | ]. pose proof F as ((hf & _) & _). fold be in hf.
      assert (f1 : f < PI + asin l).
      { apply (end_is (q * l) _ f (PI + asin l) F); [ fold be; lra | ]. unfold fwd in *. destruct hb as [[-> hb] | [-> hb]].
        - rewrite cos_minus, cos_PI, sin_PI, (Rplus_comm PI), neg_cos.
          assert (q * (2 * PI - (e - asin l)) * l > (e - asin l) * l); [ apply Rmult_lt_compat_r; nra | lra ].
        - replace (PI + be - PI) with be by ring. rewrite (Rplus_comm PI), neg_cos. destruct (asin_range (q * l)) as [_ eb]; [ lra | ].
          pose proof (second_rest (asin l) be ab b0) as Q. fold be in eb. rewrite ea, eb in Q.
          destruct (end_is l _ e (PI + be) E) as [_ D]; [ lra | ]. unfold fwd in D. rewrite (Rplus_comm PI be), neg_cos in D. lra. }
      destruct (course_late q l (asin l) e b (PI + f)) as (W & HW & Co & R); auto; try lra; fold be.
      { destruct hb as [[-> ?] | [-> ?]]; [ left | right ]; lra. }
      { right. and_so. replace (PI + f - PI) with f by ring. trivial. }
      { left. lra. }
      exists (asin l), e, b, (PI + f), W. and_so. split; [ | trivial ]. split; fold be; rewrite ?B, ?B', ?En; intuition lra.
Qed.
Lemma late_course q l W : 1 <= q -> 0 < l < 1 -> late_slide q l W -> exists a e b e', course a e b e' W /\ pattern q l a e b e' /\ (e' < a + 2 * PI -> reached q l W).
Proof.
  intros hq hl HW. destruct (late_exists q l hq hl) as (a & e & b & e' & U & HU & Co & P & R). pose proof (late_slide_unique q l U W HU HW) as E.
  exists a, e, b, e'. split; [ | split; trivial ].
  - destruct Co as (C & C1 & C2 & C3 & C4). split; [ trivial | ]. repeat split; intros t Ht; rewrite <- E; auto.
  - intros k t0 w Hw. destruct (R k t0 w Hw) as (t1 & h & ew). exists t1. split; trivial. intros. rewrite <- E. auto.
Qed.
(* the kinds I, II, III and IV *)
Lemma kinds q l W : 1 <= q -> 0 < l < 1 -> late_slide q l W ->
  (~ above_A q l -> exists a e, a < e < a + 2 * PI /\ course a e e (a + 2 * PI) W) /\
  (above_A q l -> q * l < 1 -> ~ above_B q l -> below_E q l -> exists a e e', e < e' < a + 2 * PI /\ reached q l W /\ course a e e e' W) /\
  (q * l < 1 -> above_B q l -> exists a e b e', (e < b < e' /\ e' < a + 2 * PI) /\ reached q l W /\ course a e b e' W) /\
  (~ (q * l < 1 /\ below_E q l) -> exists a e, e < a + 2 * PI /\ reached q l W /\ course a e e e W).
Proof.
  intros hq hl HW. destruct (late_course q l W hq hl HW) as (a & e & b & e' & Co & [A E [B B'] _ S] & R).
  assert (A' : e < b \/ b = e' -> e' < a + 2 * PI) by (intros h; apply A, Classical_Prop.NNPP; intros N; specialize (S N); lra).
  destruct (proj1 Co) as [C1 C2]. split; [ | split; [ | split ] ].
  - intros h. destruct (S h) as ((<- & h2) & _). replace e' with (a + 2 * PI) in * by (rewrite A in h; lra). exists a, e. split; [ lra | trivial ].
  - intros h1 h2 h3 h4. apply A in h1. replace b with e in * by (destruct (Rle_lt_or_eq_dec e b (proj2 C1)); [ tauto | trivial ]). exists a, e, e'.
    split; [ split; [ tauto | lra ] | auto ].
  - intros h1 h2. assert (h3 : e < b) by tauto. exists a, e, b, e'. split; [ tauto | ]. assert (e' < a + 2 * PI) by tauto. auto.
  - intros h. replace e' with b in * by (destruct (Rle_lt_or_eq_dec b e' (proj1 C2)); [ tauto | trivial ]).
    replace b with e in * by (destruct (Rle_lt_or_eq_dec e b (proj2 C1)) as [k | k]; [ specialize (B' k); lra | trivial ]). exists a, e.
    assert (e < a + 2 * PI) by (apply A'; auto). auto.
Qed.
(* a point that is not above A is below B and E, but X is on B *)
Lemma A_order q l : 1 <= q -> 0 < l < 1 -> ~ above_A q l -> q * l < 1 /\ below_E q l /\ (1 < q -> below_B q l).
Proof.
  intros hq hl N. destruct (late_exists q l hq hl) as (a & e & b & e' & W & _ & _ & P & _).
  destruct (p_start _ _ _ _ _ _ P N) as (h & _ & _ & _ & h1).
  destruct (proj1 (p_back _ _ _ _ _ _ P) (proj2 h)) as [m E]. split; [ trivial | split; [ trivial | ] ]. intros q1.
  apply (p_turn _ _ _ _ _ _ P (Rlt_le _ _ m)). auto.
Qed.
(* on D and above it nothing moves *)
Lemma still q l : 1 <= q -> 1 <= l -> late_slide q l (fun _ => 0).
Proof.
  intros hq hl. assert (l <= q * l) by nra. pose proof PI_RGT_0. assert (M : forall t0, slides q l t0 (fun _ => 0)).
  { intros t0. split; intros; [ cont | ]. exists (- sin t). pose proof (SIN_bound t).
    split; [ unfold dry, eq50_lambda_minus; lra | apply rder_of; auto_derive; trivial; ring ]. }
  split; trivial. intros t0 w Hw. destruct (captured l (q * l) (2 * PI) sin (fun _ => 0) ltac:(lra) M ltac:(trivial) 0 1) with (t0 := t0) (w := w)
  as (t1 & _ & h); trivial; try lra; [ apply sin_per | rewrite sin_0; lra | apply continuity_sin | ].
  apply (lim_eventually _ t1). intros t Ht. rewrite h by trivial. ring.
Qed.
Lemma late_slide_exists q l : 1 <= q -> 0 < l -> exists W, late_slide q l W.
Proof. intros hq h0. destruct (Rlt_le_dec l 1) as [h | h]; [ destruct (late_exists q l) as (a & e & b & e' & W & HW & _); eauto | eexists;
  now apply still ]. Qed.
