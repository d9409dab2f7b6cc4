(* Below lambda_c, that a passage of w through zero multiplies the logarithm of wy by the stated factor up to terms that stay bounded: how far the
   zeros of w are from those of (38), and how fast these distances fall, as that logarithm grows. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Exists Formulas HalfPeriod Drawn Analysis Steady Shaken LargeTime Zeros Across Sequences.
Open Scope R_scope.

Lemma cos_beside p x : Rabs (cos (p + x) - cos p + sin p * x) <= x ^ 2.
Proof.
  destruct (MVT_gen cos p (p + x) (fun t => - sin t)) as (c & hc & E).
  - intros t _. auto_derive; trivial. ring.
  - intros t _. apply continuity_cos.
  - replace (cos (p + x) - cos p + sin p * x) with ((sin p - sin c) * x) by (rewrite E; ring). rewrite Rabs_mult. pose proof (sin_near p c) as S.
    assert (Rabs (p - c) <= Rabs x). { unfold Rmin, Rmax in hc. unfold Rabs. destruct Rle_dec; repeat destruct Rcase_abs; lra. }
    rewrite <- (pow2_abs x). pose proof (Rabs_pos x). nra.
Qed.

Section Stages.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 < l < eq37_lambda_c.
Hypothesis M : shaken l phi0 w wy.
Hypothesis N : forall s, 0 <= s -> wy s <> 0.
Notation p := (eq39_phi_t1 l).
Notation d := (sin (eq39_phi_t1 l)).
Notation k := ((sin (eq39_phi_t1 l) - l) / (2 * l)).
Notation v t := (nrm (w t) (wy t)).
Notation Q t := (ln (wy t ^ 2)).
Notation Y t := (sqrt (wy t ^ 2)).
(* how far the motion is from (38) *)
Notation off t := (Rabs (w t - w38 l (phi0 + t)) + sqrt (wy t ^ 2)).
Lemma Q_falls a b : 0 <= a <= b -> Q b <= Q a.
Proof.
  intros h. destruct (moving l phi0 w wy (proj1 hl) M b ltac:(lra) ltac:(apply N; lra)) as (y2 & _).
  apply Rcomplements.ln_le; trivial. now apply (wy_falls l phi0 w wy (proj1 hl) M).
Qed.
(* while w has one sign it departs from a motion on the line by what wy loses, at most *)
Lemma departs g a b : g = 1 \/ g = -1 -> 0 <= a <= b -> (forall t, a <= t < b -> 0 <= g * w t) ->
  Rabs (w b + cos (phi0 + b) + g * l * b - (w a + cos (phi0 + a) + g * l * a)) <= Y a - Y b.
Proof.
  intros hg hab S. enough (T : forall s, s = 1 \/ s = -1 -> s * (w b + cos (phi0 + b) + g * l * b) + Y b <= s * (w a + cos (phi0 + a) + g * l * a) + Y a).
  { pose proof (T 1 ltac:(auto)). pose proof (T (-1) ltac:(auto)). apply Rabs_le. lra. }
  intros s hs. assert (C : forall u, is_derive (fun t => cos (phi0 + t)) u (- sin (phi0 + u))) by (intros; auto_derive; trivial; ring).
  apply (rder_decr (fun t => s * (w t + cos (phi0 + t) + g * l * t) + Y t)); [ lra | | ]; intros t Ht;
  destruct (moving l phi0 w wy (proj1 hl) M t ltac:(lra) ltac:(apply N; lra)) as (y2 & n1 & D & _).
  - assert (continuity_pt (fun t => cos (phi0 + t)) t) by exact (cont_of _ _ _ (C t)).
    assert (continuity_pt (fun t => sqrt (wy t ^ 2)) t) by (apply cont_root; [ conts M | lra ]). conts M.
  - destruct (law l phi0 w wy ltac:(lra) M t ltac:(lra)) as (fx & fy & _ & [E _] & _ & X & _).
    eexists. split.
    { apply (rder_plus (fun t => s * (w t + cos (phi0 + t) + g * l * t)) (fun t => Y t)).
      - apply (rder_mult (fun _ => s)); [ rd | ]. apply (rder_plus (fun t => w t + cos (phi0 + t))).
        + apply (rder_plus w); [ exact X | exact (rder_of _ _ _ (C t)) ].
        + apply (rder_of (fun t => g * l * t) t (g * l)). auto_derive; trivial. ring.
      - apply (rder_root _ _ _ D y2). }
    cbv beta. pose proof (sqrt_lt_R0 _ y2) as y0. assert (yy : Y t ^ 2 = wy t ^ 2) by (apply pow2_sqrt; lra). set (y := Y t) in *.
    pose proof (nrm_sq (w t) (wy t)) as n2. rewrite <- yy in *. set (r := v t) in *. pose proof (Rabs_pos (w t)). assert (r0 : 0 < r) by lra.
    specialize (S t Ht). assert (g2 : g * g = 1) by (destruct hg as [-> | ->]; ring). set (z := g * w t) in *.
    assert (wz : w t = g * z) by (unfold z; rewrite <- Rmult_assoc, g2; ring). assert (ef : fx = - l * (g * z) / r) by (rewrite <- wz, <- E; field; lra).
    assert (z2 : w t ^ 2 = z ^ 2) by (rewrite wz; transitivity (g * g * z ^ 2); [ ring | rewrite g2; ring ]).
    assert (zr : z <= r <= z + y). { split; [ apply Rnot_lt_le; intros q; nra | apply Rnot_lt_le; intros q; nra ]. }
    match goal with |- ?G <= 0 => replace G with (l / r * (s * g * (r - z) - y)) end.
    2: { rewrite ef. field. lra. }
    assert (0 < l / r) by (apply Rdiv_lt_0_compat; lra). assert (s * g * (r - z) <= y) by (destruct hs as [-> | ->]; destruct hg as [-> | ->]; lra). nra.
Qed.
(* a passage, up to C and what the distance of the zeros makes: to half a period later, and to the zero *)
Lemma passing u : 0 < u < PI -> exists C s1, 0 <= s1 /\ forall s j, s1 <= s -> phi0 + s = p + IZR (j - 1) * PI + u ->
  exists z, s <= z <= s + PI /\ (forall y, s <= y <= s + PI -> (w y = 0 <-> y = z)) /\
  (forall t, s <= t < z -> sg j * w t <= 0) /\ (forall t, z <= t < s + PI -> 0 <= sg j * w t) /\
  let x := Rabs (z - (s + PI - u)) in x <= d / 2 /\ forall t a, t = s + PI /\ a = k \/ t = z /\ a = / 2 + k ->
    Rabs (a * Q t - (1 + k) * Q s) <= x / (2 * l) * (Q s - Q (s + PI)) + C.
Proof.
  intros hu. pose proof PI_RGT_0. destruct (room l hl) as (ra & rb). destruct (z_1 l hl) as [h1 _].
  pose proof (d_l l (proj1 hl) (proj2 hl)) as dl. set (del := Rmin (Rmin u (PI - u) / 2) (Rmin d (Rmin (p - asin l) (PI / 2 - p)) / 2)).
  assert (hd : 0 < del /\ del < u /\ del < PI - u /\ del <= d / 2 /\ del <= (p - asin l) / 2 /\ del < PI / 2 - p) by (unfold del; minmax). clearbody del.
  set (c := sin (p - del) - l). assert (c0 : 0 < c) by (pose proof (sin_above l (p - del) h1 ltac:(lra)); unfold c; lra).
  destruct (late_sign l phi0 w wy hl M del) as (m & s1 & m0 & s10 & S); [ lra | ]. destruct (late_speed l phi0 w wy (proj1 hl) M (proj2 hl)) as (V0 & s2 & s20 & V).
  destruct (one_zero l phi0 w wy hl M del ltac:(lra)) as (s3 & O).
  exists (2 * (Rabs (ln m) + Rabs (ln (2 * V0))) + (2 / m + / c) * PI), (Rmax (Rmax s1 s2) (s3 + PI)). split; [ minmax | ]. intros s j hs ph.
  assert (hs' : s1 <= s /\ s2 <= s /\ s3 + PI <= s) by minmax. rewrite minus_IZR in ph.
  set (Z := s + PI - u). assert (Z0 : 0 < Z - del) by (unfold Z; lra). set (e := sg j).
  assert (ee : e = 1 \/ e = -1) by apply sg_cases. assert (es : sg (j - 1) = - e). { pose proof (sg_succ (j - 1)) as g. replace (j - 1 + 1)%Z with j in g by ring. unfold e. rewrite g. ring. }
  assert (A : forall t, s <= t <= Z - del -> m <= - e * w t) by (intros t Ht; rewrite <- es; apply S; rewrite ?minus_IZR; unfold Z in *; lra).
  assert (B : forall t, Z + del <= t <= s + PI -> m <= e * w t) by (intros t Ht; apply S; unfold Z in *; lra).
  destruct (O Z j ltac:(unfold Z; lra) ltac:(unfold Z; lra)) as (z & hz & Oz). assert (wz : w z = 0) by (apply Oz; lra). exists z.
  assert (G : forall y1 y2, Z - del <= y1 <= y2 -> y2 <= Z + del -> c * (y2 - y1) <= e * w y2 - e * w y1).
  { intros y1 y2 hy hy2. assert (F : - (e * w y2) + c * y2 <= - (e * w y1) + c * y1); [ | lra ].
    apply (rder_decr (fun t => - (e * w t) + c * t)); [ lra | | ]; intros t Ht; [ conts M | ].
    destruct (law l phi0 w wy ltac:(lra) M t ltac:(unfold Z in *; lra)) as (fx & fy & _ & _ & F & X & _). eexists. split. rd. cbv beta.
    assert (K : sin (p - del) <= e * sin (phi0 + t)). { unfold e. rewrite (drive_at j (phi0 + t) (p + (t - Z))) by (unfold Z; lra). apply sin_incr_1; lra. }
    unfold c. destruct ee as [f | f]; rewrite f in *; lra. }
  assert (far : forall t, Z - del <= t <= Z + del -> c * Rabs (t - z) <= Rabs (w t)).
  { intros t Ht. pose proof (Rle_abs (w t)). pose proof (Rabs_maj2 (w t)). destruct (Rle_lt_dec t z) as [q | q].
    - pose proof (G t z ltac:(lra) ltac:(lra)) as g. rewrite wz in g. rewrite Rabs_left1 by lra. destruct ee as [f | f]; rewrite f in *; lra.
    - pose proof (G z t ltac:(lra) ltac:(lra)) as g. rewrite wz in g. rewrite Rabs_pos_eq by lra. destruct ee as [f | f]; rewrite f in *; lra. }
  split; [ unfold Z in *; lra | split; [ intros y hy; apply Oz; unfold Z; lra | split; [ | split ] ] ].
  { intros t Ht. fold e. destruct (Rle_lt_dec t (Z - del)) as [q | q]; [ specialize (A t ltac:(lra)); lra | ].
    pose proof (G t z ltac:(lra) ltac:(lra)) as g. rewrite wz in g. assert (0 <= c * (z - t)) by nra. lra. }
  { intros t Ht. fold e. destruct (Rle_lt_dec (Z + del) t) as [q | q]; [ specialize (B t ltac:(lra)); lra | ].
    pose proof (G z t ltac:(lra) ltac:(lra)) as g. rewrite wz in g. assert (0 <= c * (t - z)) by nra. lra. }
  cbv zeta. fold Z. set (x := Rabs (z - Z)). assert (x0 : 0 <= x) by apply Rabs_pos. set (eta := x / (2 * l)). assert (le : 2 * l * eta = x) by (unfold eta; field; lra).
  assert (im : 0 < / m) by now apply Rinv_0_lt_compat. assert (ic : 0 < / c) by now apply Rinv_0_lt_compat.
  assert (T : forall r g, s <= r <= s + PI -> g = 1 \/ g = -1 -> g * (ln (v r + e * w r) + k * Q r) + eta * Q r - (2 / m + / c) * r <=
    g * (ln (v s + e * w s) + k * Q s) + eta * Q s - (2 / m + / c) * s).
  { intros r0 g hr hg. apply (rder_decr (fun t => g * (ln (v t + e * w t) + k * Q t) + eta * Q t - (2 / m + / c) * t)); [ lra | | ]; intros t Ht;
    destruct (moving l phi0 w wy (proj1 hl) M t ltac:(lra) ltac:(apply N; lra)) as (y2 & n1 & D & E); destruct (E e ee) as [q L].
    - conts M.
    - apply (rder_log (fun t => wy t ^ 2)) in D; trivial. apply (rder_log (fun t => v t + e * w t)) in L; trivial. eexists. split. rds.
      cbv beta. pose proof (Rabs_pos (w t)). set (b := e * sin (phi0 + t)). set (r := v t) in *. match goal with |- ?x <= 0 =>
        replace x with ((g * (b - d) - 2 * l * eta) / r - (2 / m + / c)) by (unfold b; field; lra) end.
      assert (near : Rabs (b - d) <= Rabs (t - Z)).
      { unfold b, e. rewrite (drive_at j (phi0 + t) (p + (t - Z))) by (unfold Z; lra).
        replace (t - Z) with (p + (t - Z) - p) at 2 by ring. apply sin_near. }
      assert (gb : g * (b - d) <= Rabs (b - d)) by (pose proof (Rle_abs (b - d)); pose proof (Rabs_maj2 (b - d)); destruct hg as [-> | ->]; lra).
      rewrite le.
      enough ((g * (b - d) - x) / r <= 2 / m + / c) by lra.
      destruct (Rle_lt_dec (Rabs (t - Z)) del) as [k1 | k1].
      { apply Rabs_le_between in k1. specialize (far t ltac:(lra)). pose proof (Rabs_triang (t - z) (z - Z)) as tr.
        replace (t - z + (z - Z)) with (t - Z) in tr by ring. fold x in tr. apply Rle_trans with (/ c); [ | unfold Rdiv; lra ]. apply Rle_div_l; [ lra | ].
        assert (hh : / c * (c * Rabs (t - z)) <= / c * r) by (apply Rmult_le_compat_l; lra). rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l in hh by lra. lra. }
      assert (rm : m <= r). { apply Rle_trans with (Rabs (w t)); [ | lra ].
      destruct (Rle_lt_dec t Z); [ rewrite Rabs_left1 in k1 by lra; specialize (A t ltac:(lra))
        | rewrite Rabs_pos_eq in k1 by lra; specialize (B t ltac:(lra)) ]; pose proof (Rle_abs (w t)); pose proof (Rabs_maj2 (w t));
        destruct ee as [f | f];
        rewrite f in *; lra. }
      assert (g * (b - d) <= 2). { pose proof (SIN_bound (phi0 + t)). pose proof (SIN_bound p). unfold b.
      destruct hg as [-> | ->]; destruct ee as [-> | ->]; lra. }
      apply Rle_div_l; [ lra | ]. assert (2 <= 2 / m * r) by (replace 2 with (2 / m * m) at 1 by (field; lra); apply Rmult_le_compat_l; unfold Rdiv;
      lra). assert (0 <= / c * r) by nra. lra. }
  assert (size : forall t g, s <= t -> g = 1 \/ g = -1 -> m <= g * w t -> Rabs (ln (v t + g * w t)) <= Rabs (ln m) + Rabs (ln (2 * V0))).
  { intros t g ht hg K. specialize (V t ltac:(lra)). destruct (moving l phi0 w wy (proj1 hl) M t ltac:(lra) ltac:(apply N; lra)) as (_ & n1 & _). apply Rabs_def2 in n1.
    assert (m <= v t + g * w t <= 2 * V0) by (destruct hg as [-> | ->]; lra). pose proof (Rabs_maj2 (ln m)). pose proof (Rle_abs (ln (2 * V0))).
    pose proof (Rabs_pos (ln m)). pose proof (Rabs_pos (ln (2 * V0))).
    assert (ln m <= ln (v t + g * w t) <= ln (2 * V0)) by (split; apply Rcomplements.ln_le; lra). apply Rabs_le. lra. }
  assert (eo : - e = 1 \/ - e = -1) by (destruct ee as [-> | ->]; [ right | left ]; ring).
  pose proof (size s (- e) ltac:(lra) eo (A s ltac:(unfold Z; lra))) as r2.
  assert (r3 : ln (v s + e * w s) = Q s - ln (v s + - e * w s)).
  { destruct (moving l phi0 w wy (proj1 hl) M s ltac:(lra) ltac:(apply N; lra)) as (_ & _ & _ & E). destruct (E e ee) as [x1 _]. destruct (E (- e) eo) as [x2 _].
    enough (K : Q s = ln (v s + e * w s) + ln (v s + - e * w s)) by lra. rewrite <- ln_mult by trivial.
    f_equal. transitivity (v s ^ 2 - e ^ 2 * w s ^ 2); [ | ring ]. rewrite nrm_sq. destruct ee as [-> | ->]; ring. }
  split; [ apply Rabs_le; unfold Z in *; lra | ]. intros t a ta. assert (ht : s <= t <= s + PI) by (unfold Z in *; lra).
  assert (r1 : Rabs (ln (v t + e * w t) + k * Q t - a * Q t) <= Rabs (ln m) + Rabs (ln (2 * V0))).
  { destruct ta as [[-> ->] | [-> ->]].
    - replace (_ + k * Q (s + PI) - _) with (ln (v (s + PI) + e * w (s + PI))) by ring. apply size; trivial; [ lra | apply B; unfold Z; lra ].
    - destruct (moving l phi0 w wy (proj1 hl) M z ltac:(lra) ltac:(apply N; lra)) as (_ & n1 & _). pose proof (nrm_sq (w z) (wy z)) as n2.
      rewrite wz in *. rewrite Rabs_R0 in n1. replace (wy z ^ 2) with (nrm 0 (wy z) ^ 2) by lra. rewrite ln_pow by trivial. simpl.
      match goal with |- Rabs ?y <= _ => replace y with 0 by (rewrite Rmult_0_r, Rplus_0_r; field; lra) end.
      rewrite Rabs_R0. pose proof (Rabs_pos (ln m)). pose proof (Rabs_pos (ln (2 * V0))). lra. }
  assert (0 <= eta * (Q t - Q (s + PI))). { apply Rmult_le_pos; [ apply Rle_div_r; lra | pose proof (Q_falls t (s + PI) ltac:(lra)); lra ]. }
  assert ((2 / m + / c) * (t - s) <= (2 / m + / c) * PI) by (apply Rmult_le_compat_l; unfold Rdiv; lra).
  rewrite r3 in T. pose proof (T t 1 ht ltac:(auto)). pose proof (T t (-1) ht ltac:(auto)). apply Rabs_le_between in r1, r2. apply Rabs_le. lra.
Qed.
(* how the distance from (38), half a period before and after, goes with the distance of the zeros *)
Lemma settle u s j z : 0 <= s -> phi0 + s = p + IZR (j - 1) * PI + u -> 0 < u < PI -> s <= z <= s + PI -> w z = 0 ->
  (forall t, s <= t < z -> sg j * w t <= 0) -> (forall t, z <= t < s + PI -> 0 <= sg j * w t) ->
  let x := Rabs (z - (s + PI - u)) in (d + l) * x - x ^ 2 <= off s /\ off (s + PI) <= (d - l) * x + x ^ 2 + Y s.
Proof.
  intros hs ph hu hz wz A B X. pose proof PI_RGT_0. destruct (z_1 l hl) as [z1 z2]. destruct (p_facts l z1 (proj2 z2)) as (_ & cp & _).
  pose proof (d_l l (proj1 hl) (proj2 hl)) as dl. pose proof (sqrt_pos (wy z ^ 2)).
  rewrite minus_IZR in ph. set (e := sg j) in *. assert (ee : e = 1 \/ e = -1) by apply sg_cases.
  assert (eo : - e = 1 \/ - e = -1) by (destruct ee as [-> | ->]; [ right | left ]; ring).
  pose proof (departs (- e) s z eo ltac:(lra) ltac:(intros t Ht; specialize (A t Ht); lra)) as E1.
  pose proof (departs e z (s + PI) ee ltac:(lra) B) as E2. rewrite wz in *.
  assert (C : forall t q, phi0 + t = p + q + IZR j * PI -> cos (phi0 + t) = e * cos (p + q)).
  { intros t q E. rewrite (a_shift PI cos neg_cos _ j). fold e. do 2 f_equal. lra. }
  set (x := z - (s + PI - u)) in *. rewrite (C z x) in E1, E2 by (unfold x; lra). rewrite (C (s + PI) u) in E2 by lra.
  assert (Cs : cos (phi0 + s) = - (e * cos (p + u))). { rewrite <- (C (s + PI) u) by lra. rewrite <- Rplus_assoc, neg_cos. ring. } rewrite Cs in E1.
  assert (W : w38 l (phi0 + (s + PI)) = e * g38 l p u). { rewrite (w38_on l j) by lra. fold e. do 2 f_equal. lra. }
  assert (Ws : w38 l (phi0 + s) = - (e * g38 l p u)). { rewrite <- W, <- Rplus_assoc, w38_anti. ring. } rewrite W, Ws. unfold g38. rewrite cp.
  pose proof (cos_beside p x) as T. rewrite cp in T. set (c1 := cos (p + u)) in *. set (c2 := cos (p + x)) in *. clearbody c1 c2.
  set (yz := Y z) in *; clearbody yz. assert (zx : z = x + (s + PI - u)) by (unfold x; ring). rewrite zx in E1, E2. clearbody x.
  assert (x2 : X ^ 2 = x ^ 2) by apply pow2_abs. rewrite x2. assert (hX : X = Rabs x) by trivial. clearbody X. subst X. clear A B C.
  apply Rabs_le_between in E1, E2, T. assert (hp : 0 <= (d - l) * Rabs x) by (apply Rmult_le_pos; [ lra | apply Rabs_pos ]).
  unfold Rabs in hp |- *; repeat destruct Rcase_abs; destruct ee as [f | f]; rewrite f in *; split; lra.
Qed.
End Stages.
