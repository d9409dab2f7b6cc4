(* 2.4: what the motion is at large times for every q >= 1 and lambda0 > 0, on the curves too: in each region a course (Slips.v)
   is built and every motion is drawn to it. (53) to (55) and E are signs of a slip from sin^-1 lambda0 at certain phases. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn Line Formulas.
From Slipbook Require Export Slips.
Open Scope R_scope.

Notation K := eq53_k.
(* below A, B and E of (53), (54) and the correction: their left side is larger (below B), or smaller (below E) *)
Definition below_A q l : Prop := eq53_sides_2 (K q) l < eq53_sides_1 (K q) l.
Definition above_A q l : Prop := eq53_sides_1 (K q) l < eq53_sides_2 (K q) l.
Definition on_A q l : Prop := eq53_sides_1 (K q) l = eq53_sides_2 (K q) l.
Definition below_B q l : Prop := eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l).
Definition above_B q l : Prop := eq54_sides_1 l (q * l) < eq54_sides_2 l (q * l).
Definition on_B q l : Prop := eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l).
Definition below_E q l : Prop := right_anisotropic_e_sides_1 l (q * l) < right_anisotropic_e_sides_2 l (q * l).
Definition above_E q l : Prop := right_anisotropic_e_sides_2 l (q * l) < right_anisotropic_e_sides_1 l (q * l).
Definition on_E q l : Prop := right_anisotropic_e_sides_1 l (q * l) = right_anisotropic_e_sides_2 l (q * l).

(* B and E: the velocity of the slip from asin l where the drive begins, or ceases, to pull backward *)
Definition arc_B q l := fwd l (asin l) (PI + asin (q * l)).
Definition arc_E q l := fwd l (asin l) (2 * PI - asin (q * l)).
Lemma arc_B_is q l : 0 < l <= 1 -> 0 < q * l <= 1 -> arc_B q l = eq54_sides_1 l (q * l) - eq54_sides_2 l (q * l).
Proof. intros h1 h2. unfold arc_B, fwd, eq54_sides_1, eq54_sides_2. rewrite Rplus_comm, neg_cos, !cos_asin_pow by lra. ring. Qed.
Lemma arc_E_is q l : 0 < l <= 1 -> 0 < q * l <= 1 -> arc_E q l = right_anisotropic_e_sides_1 l (q * l) - right_anisotropic_e_sides_2 l (q * l).
Proof.
  intros h1 h2. unfold arc_E, fwd, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. rewrite <- !cos_asin_pow by lra.
  replace (2 * PI - asin (q * l)) with (- asin (q * l) + 2 * PI) by ring. rewrite cos_per, cos_neg. ring.
Qed.
Lemma K_facts q : 1 <= q -> PI / 2 <= K q < PI /\ q * (PI - K q) = K q /\ (1 < q -> PI / 2 < K q).
Proof.
  intros hq. pose proof PI_RGT_0. assert (e : q * (PI - K q) = K q) by (unfold eq53_k; field; lra).
  assert (K q < PI) by nra. repeat split; trivial; intros; nra.
Qed.

(* ---- curve A ---- *)
(* the right side of (53) grows with K *)
Lemma side_A_grows l K L : 0 < K < L -> L < PI -> eq53_sides_2 K l < eq53_sides_2 L l.
Proof.
  intros h1 h2. unfold eq53_sides_2, cot. assert (P : forall c, K <= c <= L -> 0 < sin c) by (intros; apply sin_gt_0; lra).
  apply (up (fun K => K / sin K ^ 2 - cos K / sin K) (fun c => 2 * (sin c - c * cos c) / sin c ^ 3)); [ lra | | ].
  - intros c Hc. specialize (P c Hc). pose proof (sin2_cos2 c) as I. rewrite !Rsqr_pow2 in I. auto_derive. repeat split; nra.
    replace (2 * (sin c - c * cos c) / sin c ^ 3) with ((2 * sin c + 0 - 2 * c * cos c) / sin c ^ 3) by (f_equal; ring).
    field_simplify_eq; [ | lra ]. replace (cos c ^ 2) with (1 - sin c ^ 2) by lra. ring.
  - intros c Hc. specialize (P c ltac:(lra)). pose proof (x_cos_lt c ltac:(lra)). apply Rdiv_lt_0_compat; [ lra | now apply pow_lt ].
Qed.
(* a forward slip from asin l that lasts 2 L has (53) with L for K *)
Lemma slip_side l L : 0 < l < 1 -> 0 < L < PI -> fwd l (asin l) (asin l + 2 * L) = 0 -> eq53_sides_1 L l = eq53_sides_2 L l /\ sin (asin l + L) * sin L = l * L.
Proof.
  intros hl hL z. destruct (asin_range l hl) as [[a b] e]. set (al := asin l) in *. set (c := al + L).
  assert (s0 : 0 < sin L) by (apply sin_gt_0; lra). pose proof (sin2_cos2 L) as I. rewrite !Rsqr_pow2 in I.
  assert (ca : cos al = cos c * cos L + sin c * sin L) by (rewrite <- cos_minus; f_equal; unfold c; ring).
  assert (h1 : sin c * sin L = l * L).
  { unfold fwd in z. replace (al + 2 * L) with (c + L) in z by (unfold c; ring). rewrite cos_plus, ca in z. unfold c in *. lra. }
  assert (h2 : sin c * cos L - cos c * sin L = l). { rewrite <- sin_minus, <- e. f_equal. unfold c; ring. }
  split; trivial. unfold eq53_sides_1, eq53_sides_2, cot. rewrite <- cos_asin_pow by lra. fold al. clearbody c al. set (s := sin L) in *. set (C := cos L) in *.
  apply (Rmult_eq_reg_l (l * s ^ 2)); [ | apply Rgt_not_eq, Rmult_lt_0_compat; [ lra | now apply pow_lt ] ].
  replace (l * s ^ 2 * (cos al / l)) with (s ^ 2 * cos al) by (field; lra). replace (l * s ^ 2 * (L / s ^ 2 - C / s)) with (l * (L - s * C)) by (field; lra).
  transitivity ((s * C) * (cos c * s) + s ^ 2 * (sin c * s)); [ rewrite ca; ring | ]. replace (cos c * s) with (sin c * C - l) by lra.
  transitivity ((C ^ 2 + s ^ 2) * (sin c * s) - l * s * C); [ ring | ]. rewrite h1, Rplus_comm, I. ring.
Qed.
(* so a slip from asin l is shorter than 2 K exactly above A *)
Lemma shorter_A q l e : 1 <= q -> 0 < l < 1 -> asin l < e < 2 * PI + asin l -> fwd l (asin l) e = 0 ->
  (above_A q l <-> e - asin l < 2 * K q) /\ (on_A q l <-> e - asin l = 2 * K q).
Proof.
  intros hq hl He z. destruct (K_facts q hq) as [k _]. pose proof PI_RGT_0. set (L := (e - asin l) / 2). assert (hL : 0 < L < PI) by (unfold L; lra).
  destruct (slip_side l L hl hL) as [E _]. replace (asin l + 2 * L) with e by (unfold L; field). exact z.
  assert (E' : eq53_sides_1 (K q) l = eq53_sides_2 L l) by exact E. unfold above_A, on_A. rewrite E'. replace (e - asin l) with (2 * L) by (unfold L; field).
  destruct (total_order_T L (K q)) as [[c | <-] | c]; [ pose proof (side_A_grows l L (K q) ltac:(lra) ltac:(lra)) | | pose proof (side_A_grows l (K q) L ltac:(lra) ltac:(lra)) ]; lra.
Qed.
Lemma far_phase z : 0 < z < PI / 2 -> z * cos z < (PI / 2 + z) * (PI / 2 - z) * sin z.
Proof.
  intros H. pose proof PI2_3_2. pose proof PI_4. destruct (Rle_lt_dec z 1) as [k | k].
  - pose proof (x_cos_lt z ltac:(lra)). assert (0 < sin z) by (apply sin_gt_0; lra). assert (1 <= (PI / 2 + z) * (PI / 2 - z)) by nra. nra.
  - rewrite <- (sin_shift z), <- (cos_shift z). set (y := PI / 2 - z). assert (0 < y <= PI / 3) by (unfold y; lra). pose proof (sin_lt_x y ltac:(lra)).
    assert (1 / 2 <= cos y). { rewrite <- cos_PI3. apply cos_decr_1; lra. }
    apply Rlt_le_trans with (z * y). nra. replace ((PI / 2 + z) * y * cos y) with (y * ((PI / 2 + z) * cos y)) by ring. rewrite (Rmult_comm z). apply Rmult_le_compat_l; [ lra | ]. nra.
Qed.
Lemma side_A_pos q l : 1 <= q -> 0 < eq53_sides_2 (K q) l.
Proof.
  intros hq. destruct (K_facts q hq) as [k _]. pose proof PI_RGT_0. assert (s : 0 < sin (K q)) by (apply sin_gt_0; lra).
  assert (C : cos (K q) <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra). unfold eq53_sides_2, cot, Rdiv. 
  assert (0 < K q * / sin (K q) ^ 2) by (apply Rdiv_lt_0_compat; nra). assert (0 < / sin (K q)) by now apply Rinv_0_lt_compat. nra.
Qed.
Lemma not_above_A q l : 1 <= q -> 0 < l -> ~ above_A q l -> l < 1.
Proof.
  intros hq h0 N. pose proof (side_A_pos q l hq). apply Rnot_le_lt. intros n. apply N. unfold above_A, eq53_sides_1. rewrite sqrt_neg_0 by nra. unfold Rdiv. rewrite Rmult_0_l. trivial.
Qed.
(* the box of region I, and of A: where a slip of the length 2 K around c begins and ends *)
Section Box.
Variables l q : R.
Hypothesis hq : 1 <= q.
Hypothesis h0 : 0 < l.
Hypothesis N : ~ above_A q l.
Notation k := (K q).
(* (53) in squares *)
Lemma box_squares (lt : R -> R -> Prop) : (lt = Rle \/ (lt = Rlt /\ below_A q l)) -> lt ((l * (sin k - k * cos k)) ^ 2) ((sin k ^ 2) ^ 2 - (sin k * (l * k)) ^ 2).
Proof.
  destruct (K_facts q hq) as (hk & kq & kq'). pose proof (not_above_A q l hq h0 N) as l1. pose proof PI_RGT_0.
  assert (s0 : 0 < sin k) by (apply sin_gt_0; lra). assert (C0 : cos k <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra).
  pose proof (sin2_cos2 k) as I. rewrite !Rsqr_pow2 in I.
  assert (B : eq53_sides_2 k l <= eq53_sides_1 k l) by (apply Rnot_lt_le, N). unfold below_A, eq53_sides_1, eq53_sides_2, cot in *. set (s := sin k) in *. set (C := cos k) in *.
  set (r := sqrt (1 - l ^ 2)) in *. assert (r0 : 0 <= r) by apply sqrt_pos. assert (r2 : r ^ 2 = 1 - l ^ 2) by (unfold r; apply pow2_sqrt; nra).
  assert (p : 0 < l * s ^ 2) by (apply Rmult_lt_0_compat; [ | apply pow_lt ]; trivial). assert (u : 0 <= l * (k - s * C)) by (apply Rmult_le_pos; nra).
  assert (e1 : l * (k - s * C) = l * s ^ 2 * (k / s ^ 2 - C / s)) by (field; lra). assert (e2 : s ^ 2 * r = l * s ^ 2 * (r / l)) by (field; lra).
  assert (S : (s ^ 2) ^ 2 - (s * (l * k)) ^ 2 - (l * (s - k * C)) ^ 2 = (s ^ 2 * r) ^ 2 - (l * (k - s * C)) ^ 2).
  { rewrite (Rpow_mult_distr (s ^ 2) r), r2. replace ((l * (s - k * C)) ^ 2) with (l ^ 2 * (s ^ 2 - 2 * k * s * C + k ^ 2 * C ^ 2)) by ring.
    replace ((l * (k - s * C)) ^ 2) with (l ^ 2 * (k ^ 2 - 2 * k * s * C + s ^ 2 * C ^ 2)) by ring. replace (C ^ 2) with (1 - s ^ 2) by lra. ring. }
  intros [-> | [-> B']].
  - apply (Rmult_le_compat_l (l * s ^ 2)) in B; [ | lra ]. rewrite <- e1, <- e2 in B. assert ((l * (k - s * C)) ^ 2 <= (s ^ 2 * r) ^ 2) by (apply pow_incr; lra). lra.
  - apply (Rmult_lt_compat_l (l * s ^ 2)) in B'; [ | lra ]. rewrite <- e1, <- e2 in B'. assert ((l * (k - s * C)) ^ 2 < (s ^ 2 * r) ^ 2) by nra. lra.
Qed.
Lemma box_sine : l * k < sin k.
Proof.
  destruct (K_facts q hq) as (hk & kq & kq'). pose proof (not_above_A q l hq h0 N) as l1. pose proof PI_RGT_0.
  assert (s0 : 0 < sin k) by (apply sin_gt_0; lra). assert (C0 : cos k <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra).
  pose proof (sin2_cos2 k) as I. rewrite !Rsqr_pow2 in I.
  pose proof (box_squares Rle (or_introl eq_refl)) as B. apply Rnot_le_lt. intros n. assert ((sin k ^ 2) ^ 2 <= (sin k * (l * k)) ^ 2) by (apply pow_incr; nra).
  assert (0 < l * (sin k - k * cos k)) by (apply Rmult_lt_0_compat; nra). nra.
Qed.
Lemma box c : PI / 2 <= c <= 3 * (PI / 2) -> sin c * sin k = l * k -> l <= sin (c - k) /\ q * l <= - sin (c + k) /\
  (below_A q l -> l < sin (c - k) /\ q * l < - sin (c + k)) /\ (1 < q -> q * l < - sin (c + k)).
Proof.
  intros hc S2.
  destruct (K_facts q hq) as (hk & kq & kq'). pose proof (not_above_A q l hq h0 N) as l1. pose proof PI_RGT_0.
  assert (s0 : 0 < sin k) by (apply sin_gt_0; lra). assert (C0 : cos k <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra).
  pose proof (sin2_cos2 k) as I. rewrite !Rsqr_pow2 in I.
  assert (far : (q - 1) * sin k <= - (2 * k * cos k) /\ (1 < q -> (q - 1) * sin k < - (2 * k * cos k))).
  { assert (F : PI / 2 < k -> (q - 1) * sin k < - (2 * k * cos k)).
    { intros h. pose proof (far_phase (k - PI / 2) ltac:(lra)) as F. replace (cos (k - PI / 2)) with (sin k) in F by (rewrite cos_minus, cos_PI2, sin_PI2; ring).
      replace (sin (k - PI / 2)) with (- cos k) in F by (rewrite sin_minus, cos_PI2, sin_PI2; ring).
      apply (Rmult_lt_reg_r (PI - k)); [ lra | ]. replace ((q - 1) * sin k * (PI - k)) with ((q * (PI - k) - (PI - k)) * sin k) by ring. rewrite kq. nra. }
    split; [ | intros; apply F, kq'; trivial ]. destruct (Req_dec q 1) as [e | ne]; [ | left; apply F, kq'; lra ]. replace (q - 1) with 0 by lra. nra. }
  assert (D : 0 <= - cos c) by (pose proof (cos_le_0 c ltac:(lra) ltac:(lra)); lra).
  pose proof box_sine as bs. pose proof (sin2_cos2 c) as J. rewrite !Rsqr_pow2 in J.
  rewrite sin_minus, sin_plus. set (s := sin k) in *. set (C := cos k) in *. set (S := sin c) in *. set (x := - cos c) in *. replace (cos c) with (- x) by (unfold x; ring).
  assert (E : (s ^ 2) ^ 2 - (s * (l * k)) ^ 2 = (s ^ 2 * x) ^ 2).
  { rewrite <- S2. replace ((s * (S * s)) ^ 2) with ((s ^ 2) ^ 2 * S ^ 2) by ring. replace (S ^ 2) with (1 - x ^ 2) by (unfold x; lra). ring. }
  pose proof (box_squares Rle (or_introl eq_refl)) as Q. pose proof (fun b => box_squares Rlt (or_intror (conj eq_refl b))) as Q'. fold s C in Q, Q'. rewrite E in Q, Q'.
  assert (sx : 0 <= s ^ 2 * x) by (apply Rmult_le_pos; [ nra | trivial ]). assert (u : 0 < l * (s - k * C)) by (apply Rmult_lt_0_compat; nra).
  assert (P : l * (s - k * C) <= s ^ 2 * x) by nra. assert (P' : below_A q l -> l * (s - k * C) < s ^ 2 * x) by (intros b; specialize (Q' b); nra).
  assert (e1 : (S * C - - x * s) * s = l * k * C + s ^ 2 * x) by (rewrite <- S2; ring). assert (e2 : - (S * C + - x * s) * s = s ^ 2 * x - l * k * C) by (rewrite <- S2; ring).
  assert (e3 : l * ((q - 1) * s) <= l * - (2 * k * C)) by (apply Rmult_le_compat_l; lra).
  split; [ | split; [ | split; [ intros b; specialize (P' b); split | intros h; assert (l * ((q - 1) * s) < l * - (2 * k * C)) by (apply Rmult_lt_compat_l; [ lra | now apply far ]) ] ] ];
    (apply (Rmult_le_reg_r s) || apply (Rmult_lt_reg_r s)); trivial; (rewrite e1 || rewrite e2); lra.
Qed.
End Box.

(* ---- the regions ---- *)
(* I and A: forward from c - K to c + K, backward from there to c - K + 2 PI *)
Definition middle q l := PI - asin (l * K q / sin (K q)).
Lemma region_1 q l : 1 <= q -> 0 < l -> ~ above_A q l -> let a := middle q l - K q in let e := middle q l + K q in exists W, late_slide q l W /\ course a e e (a + 2 * PI) W /\
  (forall t, a <= t <= e -> W t = fwd l a t) /\ asin l <= a /\ a <= PI - asin l /\ PI + asin (q * l) <= e <= 2 * PI - asin (q * l) /\ q * l < 1 /\
  l <= sin a /\ q * l <= - sin e /\ (below_A q l -> l < sin a /\ q * l < - sin e) /\ (1 < q -> q * l < - sin e).
Proof.
  intros hq h0 N. destruct (K_facts q hq) as (hk & kq & _). pose proof (not_above_A q l hq h0 N) as l1. pose proof PI_RGT_0.
  pose proof (box_sine l q hq h0 N) as bs. assert (s0 : 0 < sin (K q)) by (apply sin_gt_0; lra). unfold middle. set (S := l * K q / sin (K q)).
  assert (S0 : 0 < S < 1) by (split; [ apply Rdiv_lt_0_compat; nra | apply Rlt_div_l; lra ]). destruct (asin_range S S0) as [[r1 r2] e]. set (c := PI - asin S).
  assert (S2 : sin c * sin (K q) = l * K q) by (unfold c; rewrite sin_PI_x, e; unfold S; field; lra). assert (cr : PI / 2 < c < PI) by (unfold c; lra). clearbody c.
  destruct (box l q hq h0 N c ltac:(lra) S2) as (p1 & p2 & p3 & p4). cbv zeta. set (k := K q) in *. set (m := q * l) in *.
  assert (hm : 0 < m < 1). { split; [ unfold m; nra | ]. pose proof (SIN_bound (c + k)). destruct (Req_dec q 1) as [-> | n]; [ unfold m; lra | specialize (p4 ltac:(lra)); lra ]. }
  destruct (between_asin l (c - k) ltac:(lra) ltac:(lra)) as [b1 _]. specialize (b1 p1).
  destruct (between_asin m (c + k - PI) hm ltac:(lra)) as [b2 _]. rewrite sin_minus, cos_PI, sin_PI in b2. specialize (b2 ltac:(lra)).
  destruct (asin_range l ltac:(lra)) as [[al _] _]. destruct (asin_range m hm) as [[be _] _].
  assert (z1 : fwd l (c - k) (c + k) = 0) by (unfold fwd; rewrite cos_minus, cos_plus; lra).
  assert (z2 : bwd m (c + k) (c - k + 2 * PI) = 0).
  { unfold bwd. rewrite cos_per, cos_minus, cos_plus. unfold m. replace (q * l * (c - k + 2 * PI - (c + k))) with (2 * l * (q * (PI - k))) by ring. rewrite kq. lra. }
  destruct (two_slips l m (c - k) (c + k) (c + k) (c - k + 2 * PI)) as (W & L & P & Co & F); trivial; try lra; try (intros; lra).
  - apply fwd_pos; lra.
  - intros t Ht. rewrite bwd_fwd. rewrite bwd_fwd in z2. pose proof (fwd_pos m hm (c + k - PI) (c - k + 2 * PI - PI) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) (t - PI) ltac:(lra)). lra.
  - exists W. split; [ apply (course_attracts q l W (c - k) (c + k) (c + k)); trivial; lra | and_so ].
Qed.

Section Above.
Variables q l : R.
Hypothesis hq : 1 <= q.
Hypothesis hl : 0 < l < 1.
Notation al := (asin l).
Notation be := (asin (q * l)).
Notation e_of e := (PI - al < e < 2 * PI + al /\ fwd l al e = 0 /\ (forall t, al < t < e -> 0 < fwd l al t) /\ forall t, e < t <= 2 * PI + al -> fwd l al t < 0).
Lemma end_is e t : e_of e -> al < t <= 2 * PI + al -> (0 < fwd l al t <-> t < e) /\ (fwd l al t < 0 <-> e < t) /\ (fwd l al t = 0 <-> t = e).
Proof.
  intros (He & z & P & N) Ht. destruct (total_order_T t e) as [[k | ->] | k]; [ specialize (P t ltac:(lra)) | | specialize (N t ltac:(lra)) ]; repeat split; intros; lra.
Qed.
(* IV, with C, and from E on: forward, and rest *)
Lemma region_4 : 1 <= q * l \/ (q * l < 1 /\ ~ below_E q l) -> exists e W, PI - al < e < 2 * PI + al /\ late_slide q l W /\ reached q l W /\ course al e e e W /\ (q * l < 1 -> 0 < W (PI + be)).
Proof.
  intros H. destruct (fwd_end l hl) as (e & He). pose proof He as (He1 & z & P & N). destruct (asin_range l hl) as [[a b] _]. pose proof PI_RGT_0.
  assert (R : forall t, e <= t <= 2 * PI + al -> - (q * l) <= sin t <= l).
  { intros t Ht. split. 2: { destruct (Req_dec t (2 * PI + al)) as [-> | n]. rewrite Rplus_comm, sin_per. destruct (asin_range l hl). lra. left. apply sin_less; lra. }
    destruct H as [H | [h1 h2]]; [ pose proof (SIN_bound t); lra | ]. assert (hm : 0 < q * l < 1) by nra. destruct (asin_range (q * l) hm) as [[a' b'] _].
    assert (al <= be). { apply Rnot_lt_le. intros k. pose proof (sin_increasing_1 be al). destruct (asin_range (q * l) hm) as [_ s]. destruct (asin_range l hl) as [_ s2]. rewrite s, s2 in *. nra. }
    assert (2 * PI - be <= e).
    { pose proof (end_is e (2 * PI - be) He ltac:(lra)) as [_ [E _]]. fold (arc_E q l) in E. rewrite arc_E_is in E by lra. unfold below_E in h2. apply Rnot_lt_le. intros k. apply h2. apply E in k. lra. }
    rewrite <- sin_2PI. apply not_back_le; trivial. lra. }
  destruct (two_slips l (q * l) al e e e) as (W & L & Q & Co & F); trivial; try lra; try (intros; lra).
  - nra.
  - apply bwd_0.
  - intros t Ht. apply R. lra.
  - destruct (rest_reached q l W ((Rmax e (2 * PI) + (2 * PI + al)) / 2) (2 * PI + al) L Q) as [A B].
    + pose proof (Rmax_lub_lt e (2 * PI) (2 * PI + al)). lra.
    + intros t Ht. apply Co. pose proof (Rmax_l e (2 * PI)). pose proof (Rmax_lub_lt e (2 * PI) (2 * PI + al)). lra.
    + set (r := (Rmax e (2 * PI) + (2 * PI + al)) / 2). assert (2 * PI < r < 2 * PI + al /\ e < r) by (unfold r; pose proof (Rmax_l e (2 * PI)); pose proof (Rmax_r e (2 * PI)); pose proof (Rmax_lub_lt e (2 * PI) (2 * PI + al)); lra).
      split; [ | apply sin_less; lra ]. apply Rlt_trans with 0; [ nra | ]. rewrite <- sin_2PI. apply sin_gt_0; lra.
    + exists e, W. and_so. intros h1. destruct H as [H | [_ h2]]; [ lra | ].
      assert (hm : 0 < q * l < 1) by nra. destruct (asin_range (q * l) hm) as [[a' b'] _].
      pose proof (end_is e (2 * PI - be) He ltac:(lra)) as [_ [E _]]. fold (arc_E q l) in E. rewrite arc_E_is in E by lra. unfold below_E in h2.
      apply Co. split; [ lra | ]. apply Rlt_le_trans with (2 * PI - be); [ lra | ]. apply Rnot_lt_le. intros k. apply h2. apply E in k. lra.
Qed.

Hypothesis hm : 0 < q * l < 1.
Lemma al_be : 0 < al <= be /\ be < PI / 2.
Proof.
  destruct (asin_range (q * l) hm) as [[a' b'] s]. destruct (asin_range l hl) as [[a b] s2]. repeat split; trivial.
  apply Rnot_lt_le. intros k. pose proof (sin_increasing_1 be al). rewrite s, s2 in *. nra.
Qed.
Lemma where_B_E e : e_of e -> (above_B q l <-> e < PI + be) /\ (below_B q l <-> PI + be < e) /\ (below_E q l <-> e < 2 * PI - be).
Proof.
  intros He. destruct al_be as [a b]. pose proof PI_RGT_0. pose proof (end_is e (PI + be) He ltac:(lra)) as (B1 & B2 & _). pose proof (end_is e (2 * PI - be) He ltac:(lra)) as (_ & E & _).
  fold (arc_B q l) in B1, B2. fold (arc_E q l) in E. rewrite arc_B_is in B1, B2 by lra. rewrite arc_E_is in E by lra. unfold above_B, below_B, below_E.
  split; [ | split ]; [ rewrite <- B2 | rewrite <- B1 | rewrite <- E ]; lra.
Qed.
(* II, with B: forward, at once backward, rest *)
Lemma region_2 : above_A q l -> ~ above_B q l -> below_E q l -> exists e e' W, PI + be <= e < 2 * PI - be /\ (below_B q l <-> PI + be < e) /\ 2 * PI - be < e' < 2 * PI + al /\
  late_slide q l W /\ reached q l W /\ course al e e e' W.
Proof.
  intros hA hB hE. destruct (fwd_end l hl) as (e & He). pose proof He as (He1 & z & P & N). destruct al_be as [[a ab] b]. pose proof PI_RGT_0. destruct (K_facts q hq) as (k & kq & _).
  destruct (where_B_E e He) as (B1 & B2 & E). rewrite B1 in hB. apply E in hE. destruct (shorter_A q l e hq hl ltac:(lra) z) as [A _]. apply A in hA.
  assert (c1 : bwd (q * l) e (2 * PI - be) < 0).
  { rewrite bwd_fwd. pose proof (fwd_rises (q * l) hm (e - PI) (e - PI) (2 * PI - be - PI) ltac:(lra) ltac:(lra)) as Q. rewrite fwd_0 in Q. lra. }
  assert (c2 : 0 < bwd (q * l) e (2 * PI + al)).
  { unfold bwd. rewrite (Rplus_comm (2 * PI)), cos_per. unfold fwd in z. assert (q * (e - al) < q * (2 * K q)) by nra. nra. }
  destruct (IVT_cor (bwd (q * l) e) (2 * PI - be) (2 * PI + al)) as [e' [He' z']]; [ intros x; apply bwd_cont | lra | nra | ].
  assert (e' <> 2 * PI - be) by (intros ->; lra). assert (e' <> 2 * PI + al) by (intros ->; lra).
  assert (low : forall t, 2 * PI - be < t < 2 * PI + al -> - (q * l) < sin t < l) by (intros t Ht; split; [ rewrite <- sin_2PI; apply not_back | apply sin_less ]; trivial; lra).
  destruct (two_slips l (q * l) al e e e') as (W & L & Q & Co & F); trivial; try lra; try (intros; lra).
  - intros t Ht. rewrite bwd_fwd. rewrite bwd_fwd in z'. pose proof (fwd_pos (q * l) hm (e - PI) (e' - PI) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) (t - PI) ltac:(lra)). lra.
  - intros t Ht. specialize (low t ltac:(lra)). lra.
  - destruct (rest_reached q l W ((e' + (2 * PI + al)) / 2) (2 * PI + al) L Q) as [M R]; [ lra | intros t Ht; apply Co; lra | apply low; lra | ].
    exists e, e', W. and_so.
Qed.

(* III: forward, rest, backward, rest. Where the forward slip ends before the backward one begins, that one ends before the next forward one begins *)
Lemma second_rest a b : 0 < a <= b -> b < PI / 2 -> cos a + cos b < sin a * (PI + b - a) -> cos a + cos b < sin b * (PI + a - b).
Proof.
  intros h1 h2 H. pose proof PI_RGT_0. pose proof PI2_3_2. destruct (Rle_lt_dec (sin a * (PI + b - a)) (sin b * (PI + a - b))) as [k | k]; [ lra | ].
  set (s := (a + b) / 2). set (d := (b - a) / 2). assert (ea : a = s - d) by (unfold s, d; field). assert (eb : b = s + d) by (unfold s, d; field).
  assert (hd : 0 <= d < PI / 4) by (unfold d; lra). assert (hs : 0 < s < PI / 2) by (unfold s; lra). clearbody s d. subst a b.
  rewrite cos_minus, cos_plus, sin_plus, sin_minus in *.
  assert (0 < cos s) by (apply cos_gt_0; lra). assert (0 < sin s) by (apply sin_gt_0; lra). assert (0 < cos d) by (apply cos_gt_0; lra). assert (0 <= sin d) by (apply sin_ge_0; lra).
  assert (xd : d * cos d <= sin d) by (destruct (Req_dec d 0) as [-> | ]; [ rewrite sin_0; lra | left; apply x_cos_lt; lra ]). set (Cs := cos s) in *. set (Ss := sin s) in *. set (Cd := cos d) in *. set (Sd := sin d) in *.
  assert (K : 2 * PI * (Cs * Sd) < 4 * d * (Ss * Cd)) by nra.
  assert (d0 : 0 < d). { destruct hd as [[h | <-] _]; [ trivial | ]. assert (0 <= Cs * Sd) by nra. nra. }
  assert (L : PI * Cs < 2 * Ss).
  { apply (Rmult_lt_reg_r (d * Cd)); [ nra | ]. assert (PI * Cs * (d * Cd) <= PI * Cs * Sd) by (apply Rmult_le_compat_l; nra). lra. }
  assert (0 <= Cs * Sd) by nra. assert (0 < Ss * Cd) by nra.
  assert (Ss * Cd * (PI / 2) <= (Ss * Cd + Cs * Sd) * (PI + (s - d) - (s + d))) by nra.
  assert (2 * (Cs * Cd) < Ss * Cd * (PI / 2)); [ | lra ].
  replace (Ss * Cd * (PI / 2)) with (2 * Ss * Cd * (PI / 4)) by field. assert (PI * Cs * Cd * (PI / 4) < 2 * Ss * Cd * (PI / 4)).
  { apply Rmult_lt_compat_r; [ lra | ]. apply Rmult_lt_compat_r; trivial. }
  assert (2 * (Cs * Cd) <= PI * Cs * Cd * (PI / 4)); [ | lra ]. assert (0 < Cs * Cd) by nra. assert (9 < PI * PI) by nra. nra.
Qed.
Lemma region_3 : above_B q l -> exists e e' W, PI - al < e < PI + be /\ PI + be < e' < 2 * PI + al /\ late_slide q l W /\ reached q l W /\ course al e (PI + be) e' W.
Proof.
  intros B. destruct (fwd_end l hl) as (e & He). pose proof He as (He1 & z & P & N). destruct (fwd_end (q * l) hm) as (f & Hf & zf & Pf & Nf). destruct al_be as [[a ab] b]. pose proof PI_RGT_0.
  destruct (asin_range l hl) as [_ ea]. destruct (asin_range (q * l) hm) as [_ eb].
  assert (B2 : cos al + cos be < sin al * (PI + be - al)) by (unfold above_B, eq54_sides_1, eq54_sides_2 in B; rewrite !cos_asin_pow, ea by lra; exact B).
  apply second_rest in B2; trivial; [ | lra ]. rewrite eb in B2. apply (proj1 (where_B_E e He)) in B.
  assert (f1 : f < PI + al). { apply Rnot_le_lt. intros k. assert (F : fwd (q * l) be (PI + al) < 0) by (unfold fwd; rewrite Rplus_comm, neg_cos; lra).
    destruct (Req_dec f (PI + al)) as [-> | ]; [ lra | ]. specialize (Pf (PI + al) ltac:(lra)). lra. }
  assert (bf : forall t, bwd (q * l) (PI + be) t = - fwd (q * l) be (t - PI)) by (intros t; rewrite bwd_fwd; do 2 f_equal; ring).
  assert (low : forall t, e < t < PI + be -> - (q * l) < sin t < l) by (intros t Ht; split; [ apply not_back | apply sin_less ]; trivial; lra).
  assert (low2 : forall t, 2 * PI - be <= t < 2 * PI + al -> - (q * l) <= sin t <= l) by (intros t Ht; split; [ rewrite <- sin_2PI; apply not_back_le | left; apply sin_less ]; trivial; lra).
  destruct (two_slips l (q * l) al e (PI + be) (PI + f)) as (W & L & Q & Co & F); trivial; try lra.
  - rewrite bf. replace (PI + f - PI) with f by ring. lra.
  - intros t Ht. rewrite bf. specialize (Pf (t - PI) ltac:(lra)). lra.
  - intros t Ht. split; [ apply not_back_le | left; apply sin_less ]; trivial; lra.
  - intros t Ht. apply low2. lra.
  - destruct (rest_reached q l W ((e + (PI + be)) / 2) (PI + be) L Q) as [M R]; [ lra | intros t Ht; apply (proj1 (proj2 (proj2 Co))); lra | apply low; lra | ].
    exists e, (PI + f), W. and_so.
Qed.
End Above.
(* V, with D: at rest for ever *)
Lemma region_5 q l : 1 <= q -> 1 <= l -> late_slide q l (fun _ => 0) /\ reached q l (fun _ => 0).
Proof.
  intros hq hl. assert (l <= q * l) by nra. apply (rest_reached q l (fun _ => 0) 0 1); trivial; try lra; [ | rewrite sin_0; lra ].
  split. intros; cont. intros y _. pose proof (SIN_bound y). exists (- sin y). split. split; [ unfold eq50_lambda_minus; lra | split; intros; lra ]. eapply rder_eq. rd. ring.
Qed.
