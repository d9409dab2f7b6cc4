(* Below lambda_c a passage of w through zero multiplies the logarithm of wy by the stated factor up to terms that stay bounded: by the logarithm of
   v + w, by how far the zeros of w are from those of (38), and by how fast these distances fall as that logarithm grows. *)
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
Lemma below_log y : 0 < y -> 0 < - ln (y ^ 2) -> y <= 16 / (- ln (y ^ 2)) ^ 2.
Proof.
  intros y0 h. rewrite ln_pow in * by trivial. simpl INR in *. set (a := - ln y / 2).
  replace (- ((1 + 1) * ln y)) with (4 * a) in * by (unfold a; field).
  assert (e : exp (- a) * exp (- a) = y) by (rewrite <- exp_plus; replace (- a + - a) with (ln y) by (unfold a; field); now apply exp_ln).
  pose proof (exp_both a). pose proof (exp_ineq1_le a). pose proof (exp_pos (- a)). apply Rle_div_r; [ nra | ]. rewrite <- e.
  assert (exp (- a) * a <= 1) by nra. assert (0 <= exp (- a) * a) by nra. nra.
Qed.
Lemma over c x B : 0 < c -> Rabs (c * x) <= B -> Rabs x <= B / c.
Proof. intros c0. rewrite Rabs_mult, (Rabs_pos_eq c) by lra. intros. apply Rle_div_r; lra. Qed.
(* by the sign, which is 1 or -1 *)
Ltac signs E := let f := fresh in destruct E as [f | f]; rewrite f in *; lra.

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
Notation go t := (moving l phi0 w wy (proj1 hl) M t ltac:(lra) ltac:(apply N; lra)) (only parsing).
Lemma l_d : l < d. Proof. exact (d_l l (proj1 hl) (proj2 hl)). Qed.
(* how far the motion is from (38) *)
Notation off t := (Rabs (w t - w38 l (phi0 + t)) + sqrt (wy t ^ 2)).
Lemma Q_falls a b : 0 <= a <= b -> Q b <= Q a.
Proof.
  intros h. destruct (go b) as (y2 & _).
  apply Rcomplements.ln_le; trivial. now apply (wy_falls l phi0 w wy (proj1 hl) M).
Qed.
(* while w has one sign it departs from a motion on the line by what wy loses, at most *)
Lemma departs g a b : g = 1 \/ g = -1 -> 0 <= a <= b -> (forall t, a <= t < b -> 0 <= g * w t) ->
  Rabs (w b + cos (phi0 + b) + g * l * b - (w a + cos (phi0 + a) + g * l * a)) <= Y a - Y b.
Proof.
  intros hg hab S. enough (T : forall s, s = 1 \/ s = -1 -> s * (w b + cos (phi0 + b) + g * l * b) + Y b <=
    s * (w a + cos (phi0 + a) + g * l * a) + Y a).
  { pose proof (T 1 ltac:(auto)). pose proof (T (-1) ltac:(auto)). apply Rabs_le. lra. }
  intros s hs. assert (C : forall u, is_derive (fun t => cos (phi0 + t)) u (- sin (phi0 + u))) by (intros; auto_derive; trivial; ring).
  apply (rder_decr (fun t => s * (w t + cos (phi0 + t) + g * l * t) + Y t)); [ lra | | ]; intros t Ht;
  destruct (go t) as (y2 & n1 & D & _).
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
    assert (wz : w t = g * z) by (unfold z; rewrite <- Rmult_assoc, g2; ring).
    assert (ef : fx = - l * (g * z) / r) by (rewrite <- wz, <- E; field; lra).
    assert (z2 : w t ^ 2 = z ^ 2) by (rewrite wz; transitivity (g * g * z ^ 2); [ ring | rewrite g2; ring ]).
    assert (zr : z <= r <= z + y) by (split; apply Rnot_lt_le; intros q; nra).
    match goal with |- ?G <= 0 => replace G with (l / r * (s * g * (r - z) - y)) by (rewrite ef; field; lra) end.
    assert (0 < l / r) by (apply Rdiv_lt_0_compat; lra). assert (s * g * (r - z) <= y) by (destruct hs as [-> | ->]; signs hg). nra.
Qed.
(* s is by the phase u behind a zero of (38); z is the one zero of w in half a period from s on *)
Notation after u s j := (phi0 + s = p + IZR (j - 1) * PI + u).
Notation turns z s := (s <= z <= s + PI /\ forall y, s <= y <= s + PI -> (w y = 0 <-> y = z)).
Notation ends t a s z := (t = s + PI /\ a = k \/ t = z /\ a = / 2 + k).
(* a passage, up to C and what the distance of the zeros makes: to half a period later, and to the zero *)
Lemma passing u : 0 < u < PI -> exists C s1, 0 <= s1 /\ forall s j, s1 <= s -> after u s j ->
  exists z, turns z s /\
  (forall t, s <= t < z -> sg j * w t <= 0) /\ (forall t, z <= t < s + PI -> 0 <= sg j * w t) /\
  let x := Rabs (z - (s + PI - u)) in x <= d / 2 /\ forall t a, ends t a s z ->
    Rabs (a * Q t - (1 + k) * Q s) <= x / (2 * l) * (Q s - Q (s + PI)) + C.
Proof.
  intros hu. pose proof PI_RGT_0. destruct (room l hl) as (ra & rb). destruct (z_1 l hl) as [h1 _].
  pose proof l_d as dl. set (del := Rmin (Rmin u (PI - u) / 2) (Rmin d (Rmin (p - asin l) (PI / 2 - p)) / 2)).
  assert (hd : 0 < del /\ del < u /\ del < PI - u /\ del <= d / 2 /\ del <= (p - asin l) / 2 /\ del < PI / 2 - p) by (unfold del; minmax).
  clearbody del.
  set (c := sin (p - del) - l). assert (c0 : 0 < c) by (pose proof (sin_above l (p - del) h1 ltac:(lra)); unfold c; lra).
  destruct (late_sign l phi0 w wy hl M del) as (m & s1 & m0 & s10 & S); [ lra | ].
  destruct (late_speed l phi0 w wy (proj1 hl) M (proj2 hl)) as (V0 & s2 & s20 & V).
  destruct (one_zero l phi0 w wy hl M del ltac:(lra)) as (s3 & O).
  set (W := Rabs (ln m) + Rabs (ln (2 * V0))). assert (W0 : Rabs (ln m) <= W /\ Rabs (ln (2 * V0)) <= W).
  { unfold W. pose proof (Rabs_pos (ln m)). pose proof (Rabs_pos (ln (2 * V0))). lra. }
  exists (2 * W + (2 / m + / c) * PI), (Rmax (Rmax s1 s2) (s3 + PI)). split; [ minmax | ]. intros s j hs ph.
  assert (hs' : s1 <= s /\ s2 <= s /\ s3 + PI <= s) by minmax. rewrite minus_IZR in ph.
  set (Z := s + PI - u). assert (Z0 : 0 < Z - del) by (unfold Z; lra). set (e := sg j).
  assert (ee : e = 1 \/ e = -1) by apply sg_cases. assert (es : sg (j - 1) = - e).
  { pose proof (sg_succ (j - 1)) as g. rewrite Z.sub_add in g. unfold e. lra. }
  assert (A : forall t, s <= t <= Z - del -> m <= - e * w t) by (intros t Ht; rewrite <- es; apply S; rewrite ?minus_IZR; unfold Z in *; lra).
  assert (B : forall t, Z + del <= t <= s + PI -> m <= e * w t) by (intros t Ht; apply S; unfold Z in *; lra).
  destruct (O Z j ltac:(unfold Z; lra) ltac:(unfold Z; lra)) as (z & hz & Oz). assert (wz : w z = 0) by (apply Oz; lra). exists z.
  assert (G : forall y1 y2, Z - del <= y1 <= y2 -> y2 <= Z + del -> c * (y2 - y1) <= e * w y2 - e * w y1).
  { intros y1 y2 hy hy2. assert (F : - (e * w y2) + c * y2 <= - (e * w y1) + c * y1); [ | lra ].
    apply (rder_decr (fun t => - (e * w t) + c * t)); [ lra | | ]; intros t Ht; [ conts M | ].
    destruct (law l phi0 w wy ltac:(lra) M t ltac:(unfold Z in *; lra)) as (fx & fy & _ & _ & F & X & _). eexists. split. rd. cbv beta.
    assert (K : sin (p - del) <= e * sin (phi0 + t)). { unfold e. rewrite (drive_at j (phi0 + t) (p + (t - Z))) by (unfold Z; lra).
    apply sin_incr_1; lra. }
    unfold c. signs ee. }
  assert (far : forall t, Z - del <= t <= Z + del -> c * Rabs (t - z) <= Rabs (w t)).
  { intros t Ht. pose proof (Rle_abs (w t)). pose proof (Rabs_maj2 (w t)). unfold Rabs at 1. destruct Rcase_abs;
    [ pose proof (G t z ltac:(lra) ltac:(lra)) as g | pose proof (G z t ltac:(lra) ltac:(lra)) as g ]; rewrite wz in g; signs ee. }
  split; [ split; [ unfold Z in *; lra | intros y hy; apply Oz; unfold Z; lra ] | split; [ | split ] ].
  { intros t Ht. fold e. destruct (Rle_lt_dec t (Z - del)) as [q | q]; [ specialize (A t ltac:(lra)); lra | ].
    pose proof (G t z ltac:(lra) ltac:(lra)) as g. rewrite wz in g. assert (0 <= c * (z - t)) by (apply Rmult_le_pos; lra). lra. }
  { intros t Ht. fold e. destruct (Rle_lt_dec (Z + del) t) as [q | q]; [ specialize (B t ltac:(lra)); lra | ].
    pose proof (G z t ltac:(lra) ltac:(lra)) as g. rewrite wz in g. assert (0 <= c * (t - z)) by (apply Rmult_le_pos; lra). lra. }
  cbv zeta. fold Z. set (x := Rabs (z - Z)). assert (x0 : 0 <= x) by apply Rabs_pos. set (eta := x / (2 * l)).
  assert (le : 2 * l * eta = x) by (unfold eta; field; lra).
  assert (im : 0 < / m) by now apply Rinv_0_lt_compat. assert (ic : 0 < / c) by now apply Rinv_0_lt_compat.
  assert (T : forall r g, s <= r <= s + PI -> g = 1 \/ g = -1 -> g * (ln (v r + e * w r) + k * Q r) + eta * Q r - (2 / m + / c) * r <=
    g * (ln (v s + e * w s) + k * Q s) + eta * Q s - (2 / m + / c) * s).
  { intros r0 g hr hg. apply (rder_decr (fun t => g * (ln (v t + e * w t) + k * Q t) + eta * Q t - (2 / m + / c) * t)); [ lra | | ]; intros t Ht;
    destruct (go t) as (y2 & n1 & D & E); destruct (E e ee) as [q L].
    - conts M.
    - apply (rder_log (fun t => wy t ^ 2)) in D; trivial. apply (rder_log (fun t => v t + e * w t)) in L; trivial. eexists. split. rds.
      cbv beta. pose proof (Rabs_pos (w t)). set (b := e * sin (phi0 + t)). set (r := v t) in *. match goal with |- ?x <= 0 =>
        replace x with ((g * (b - d) - 2 * l * eta) / r - (2 / m + / c)) by (unfold b; field; lra) end.
      assert (near : Rabs (b - d) <= Rabs (t - Z)).
      { unfold b, e. rewrite (drive_at j (phi0 + t) (p + (t - Z))) by (unfold Z; lra).
        replace (t - Z) with (p + (t - Z) - p) at 2 by ring. apply sin_near. }
      assert (gb : g * (b - d) <= Rabs (b - d)) by (pose proof (Rle_abs (b - d)); pose proof (Rabs_maj2 (b - d)); signs hg).
      rewrite le. enough ((g * (b - d) - x) / r <= 2 / m + / c) by lra.
      destruct (Rle_lt_dec (Rabs (t - Z)) del) as [k1 | k1].
      { apply Rabs_le_between in k1. specialize (far t ltac:(lra)). pose proof (Rabs_triang (t - z) (z - Z)) as tr.
        replace (t - z + (z - Z)) with (t - Z) in tr by ring. fold x in tr. apply Rle_trans with (/ c); [ | unfold Rdiv; lra ].
        apply Rle_div_l; [ lra | ].
        assert (hh : / c * (c * Rabs (t - z)) <= / c * r) by (apply Rmult_le_compat_l; lra). rewrite <- Rmult_assoc, Rinv_l in hh; lra. }
      assert (rm : m <= r).
      { apply Rabs_def2 in n1. unfold Rabs in k1. destruct Rcase_abs; [ specialize (A t ltac:(lra)) | specialize (B t ltac:(lra)) ]; signs ee. }
      assert (g * (b - d) <= 2). { pose proof (SIN_bound (phi0 + t)). pose proof (SIN_bound p). unfold b.
      destruct hg as [-> | ->]; signs ee. }
      apply Rle_div_l; [ lra | ]. assert (2 <= 2 / m * r) by (replace 2 with (2 / m * m) at 1 by (field; lra); apply Rmult_le_compat_l; unfold Rdiv;
      lra). assert (0 <= / c * r) by (apply Rmult_le_pos; lra). lra. }
  assert (size : forall t g, s <= t -> g = 1 \/ g = -1 -> m <= g * w t -> Rabs (ln (v t + g * w t)) <= W).
  { intros t g ht hg K. specialize (V t ltac:(lra)). destruct (go t) as (_ & n1 & _). apply Rabs_def2 in n1.
    assert (m <= v t + g * w t <= 2 * V0) by (signs hg). pose proof (Rabs_maj2 (ln m)). pose proof (Rle_abs (ln (2 * V0))).
    assert (ln m <= ln (v t + g * w t) <= ln (2 * V0)) by (split; apply Rcomplements.ln_le; lra). apply Rabs_le. lra. }
  assert (eo : - e = 1 \/ - e = -1) by (destruct ee as [-> | ->]; [ right | left ]; ring).
  pose proof (size s (- e) ltac:(lra) eo (A s ltac:(unfold Z; lra))) as r2.
  assert (r3 : ln (v s + e * w s) = Q s - ln (v s + - e * w s)).
  { destruct (go s) as (_ & _ & _ & E). destruct (E e ee) as [x1 _]. destruct (E (- e) eo) as [x2 _].
    enough (K : Q s = ln (v s + e * w s) + ln (v s + - e * w s)) by lra. rewrite <- ln_mult by trivial.
    f_equal. transitivity (v s ^ 2 - e ^ 2 * w s ^ 2); [ | ring ]. rewrite nrm_sq. destruct ee as [-> | ->]; ring. }
  split; [ apply Rabs_le; unfold Z in *; lra | ]. intros t a ta. assert (ht : s <= t <= s + PI) by (unfold Z in *; lra).
  assert (r1 : Rabs (ln (v t + e * w t) + k * Q t - a * Q t) <= W).
  { destruct ta as [[-> ->] | [-> ->]].
    - replace (_ + k * Q (s + PI) - _) with (ln (v (s + PI) + e * w (s + PI))) by ring. apply size; trivial; [ lra | apply B; unfold Z; lra ].
    - destruct (go z) as (_ & n1 & _). pose proof (nrm_sq (w z) (wy z)) as n2.
      rewrite wz in *. rewrite Rabs_R0 in n1. replace (wy z ^ 2) with (nrm 0 (wy z) ^ 2) by lra. rewrite ln_pow by trivial. simpl.
      match goal with |- Rabs ?y <= _ => replace y with 0 by (rewrite Rmult_0_r, Rplus_0_r; field; lra) end.
      rewrite Rabs_R0. pose proof (Rabs_pos (ln m)). lra. }
  assert (0 <= eta * (Q t - Q (s + PI))). { apply Rmult_le_pos; [ apply Rle_div_r; lra | pose proof (Q_falls t (s + PI) ltac:(lra)); lra ]. }
  assert ((2 / m + / c) * (t - s) <= (2 / m + / c) * PI) by (apply Rmult_le_compat_l; unfold Rdiv; lra).
  rewrite r3 in T. pose proof (T t 1 ht ltac:(auto)). pose proof (T t (-1) ht ltac:(auto)). apply Rabs_le_between in r1, r2. apply Rabs_le. lra.
Qed.
(* how the distance from (38), half a period before and after, goes with the distance of the zeros *)
Lemma settle u s j z : 0 <= s -> after u s j -> 0 < u < PI -> s <= z <= s + PI -> w z = 0 ->
  (forall t, s <= t < z -> sg j * w t <= 0) -> (forall t, z <= t < s + PI -> 0 <= sg j * w t) ->
  let x := Rabs (z - (s + PI - u)) in (d + l) * x - x ^ 2 <= off s /\ off (s + PI) <= (d - l) * x + x ^ 2 + Y s.
Proof.
  intros hs ph hu hz wz A B X. pose proof PI_RGT_0. destruct (z_1 l hl) as [z1 z2]. destruct (p_facts l z1 (proj2 z2)) as (_ & cp & _).
  pose proof l_d as dl. pose proof (sqrt_pos (wy z ^ 2)).
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
(* both, by how far the motion is from (38) before *)
Notation F := ((1 + k) / k).
Lemma k_pos : 0 < k. Proof. pose proof l_d. apply Rdiv_lt_0_compat; lra. Qed.
Lemma factor_is : F = right_sinusoidal_passage_factor l d.
Proof. pose proof l_d. unfold right_sinusoidal_passage_factor. field. repeat split; lra. Qed.
Lemma step u : 0 < u < PI -> exists b C s1, 0 < b /\ 0 <= C /\ 0 <= s1 /\ forall s j, s1 <= s -> after u s j ->
  off (s + PI) <= off s / F + b * off s ^ 2 + Y s /\ exists z, turns z s /\
  forall t a, ends t a s z -> Rabs (a * Q t - (1 + k) * Q s) <= b * off s * (Q s - Q (s + PI)) + C.
Proof.
  intros hu. pose proof l_d as dl. pose proof PI_RGT_0. destruct (passing u hu) as (C & s1 & s10 & P).
  assert (b1 : 0 < / (l * (d + l))) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra).
  assert (b2 : 0 < 8 * d / (d + l) ^ 3) by (apply Rdiv_lt_0_compat; [ lra | apply pow_lt; lra ]).
  exists (/ (l * (d + l)) + 8 * d / (d + l) ^ 3), (Rabs C), s1. split; [ lra | split; [ apply Rabs_pos | split; trivial ] ]. intros s j hs ph.
  destruct (P s j hs ph) as (z & [hz Oz] & A & B & xd & R). assert (wz : w z = 0) by (apply Oz; trivial).
  destruct (settle u s j z ltac:(lra) ph hu hz wz A B) as [S1 S2]. set (x := Rabs (z - (s + PI - u))) in *. assert (x0 : 0 <= x) by apply Rabs_pos.
  set (o := off s) in *. assert (small : x <= 2 * o / (d + l)) by (apply Rle_div_r; nra). assert (o0 : 0 <= o) by nra. split.
  - assert (E : (d + l) * off (s + PI) <= (d - l) * o + 2 * d * x ^ 2 + (d + l) * Y s) by nra.
    assert (x2 : x ^ 2 <= (2 * o / (d + l)) ^ 2) by (apply pow_incr; lra).
    assert (2 * d * x ^ 2 <= 2 * d * (2 * o / (d + l)) ^ 2) by (apply Rmult_le_compat_l; lra). assert (0 <= / (l * (d + l)) * o ^ 2) by nra.
    apply Rmult_le_reg_l with (d + l); [ lra | ].
    replace ((d + l) * (o / F + (/ (l * (d + l)) + 8 * d / (d + l) ^ 3) * o ^ 2 + Y s)) with
      ((d - l) * o + 2 * d * (2 * o / (d + l)) ^ 2 + (d + l) * Y s + (d + l) * (/ (l * (d + l)) * o ^ 2)); [ nra | field; repeat split; lra ].
  - exists z. split; [ auto | ]. intros t a ta. specialize (R t a ta). pose proof (Rle_abs C).
    assert (q : 0 <= Q s - Q (s + PI)) by (pose proof (Q_falls s (s + PI) ltac:(lra)); lra). eapply Rle_trans; [ exact R | ].
    apply Rplus_le_compat; trivial. apply Rmult_le_compat_r; trivial. apply Rle_trans with (/ (l * (d + l)) * o); [ | nra ].
    replace (/ (l * (d + l)) * o) with (2 * o / (d + l) / (2 * l)) by (field; lra). apply Rmult_le_compat_r; trivial.
    left. apply Rinv_0_lt_compat. lra.
Qed.
(* up to C only *)
Lemma passages u : 0 < u < PI -> exists C s1, 0 <= s1 /\ forall s j, s1 <= s -> after u s j ->
  exists z, turns z s /\
  forall t a, ends t a s z -> Rabs (a * Q t - (1 + k) * Q s) <= C.
Proof.
  intros hu. pose proof PI_RGT_0. pose proof k_pos as k0. destruct (step u hu) as (b & C & s1 & b0 & C0 & s10 & P). set (f := k) in *.
  set (G := (1 + f) / f) in *.
  assert (fG : f * G = 1 + f) by (unfold G; field; lra). assert (G1 : 1 < G) by nra.
  set (c := 16 + b + 2 * b / f + 2 * C / f). set (m := 1 + 2 * c * G / (G - 1) + b + 2 * b / f).
  assert (hb : 0 < b / f) by (apply Rdiv_lt_0_compat; lra). assert (hC : 0 <= C / f) by (apply Rdiv_le_0_compat; lra).
  assert (hc : 16 <= c /\ b <= c /\ 2 * (b / f) <= c /\ 2 * (C / f) <= c) by (unfold c; lra).
  assert (hm : 0 < c * G / (G - 1)) by (apply Rdiv_lt_0_compat; nra). assert (m0 : 0 < m /\ 0 < / m) by (split; [ | apply Rinv_0_lt_compat ];
    unfold m; lra).
  destruct (z_1 l hl) as [_ z2]. set (e := Rmin (/ m / 2) (exp (- (1 + 2 * C)))).
  assert (he : 0 < e /\ 2 * e <= / m /\ e <= exp (- (1 + 2 * C))) by (unfold e; pose proof (exp_pos (- (1 + 2 * C))); minmax).
  destruct (near_38 l z2 phi0 w wy e M (proj1 he)) as (s2 & s20 & near).
  assert (late : forall s, s2 <= s -> 1 + 2 * C <= - Q s /\ 0 <= off s <= 1 /\ c * G * off s <= (G - 1) / 2 /\ b * off s <= f / 2 /\ b * off s <= 1 /\
    Y s <= 16 / (- Q s) ^ 2).
  { intros s hs. destruct (near s hs) as [X1 X2]. destruct (go s) as (y2 & _).
    assert (E1 : exp (- (1 + 2 * C)) < 1) by (pose proof (exp_increasing (- (1 + 2 * C)) 0 ltac:(lra)); rewrite exp_0 in *; lra).
    pose proof (Rabs_pos (w s - w38 l (phi0 + s))). pose proof (Rabs_pos_lt _ (N s ltac:(lra))) as y0. rewrite <- (pow2_abs (wy s)) in *.
    set (y := Rabs (wy s)) in *.
    assert (q : ln (y ^ 2) < - (1 + 2 * C)) by (rewrite <- (ln_exp (- (1 + 2 * C))); apply ln_increasing; nra).
    rewrite sqrt_pow2 by lra. set (o := Rabs _ + y) in *. assert (om : m * o <= 1).
    { assert (m * o <= m * / m) by (apply Rmult_le_compat_l; unfold o; lra). rewrite Rinv_r in *; lra. }
    assert (o0 : 0 <= o) by (unfold o; lra). assert (0 <= b * o /\ 0 <= b / f * o /\ 0 <= c * G / (G - 1) * o) by (repeat split; apply Rmult_le_pos;
      lra).
    assert (om2 : o + 2 * (c * G / (G - 1) * o) + b * o + 2 * (b / f * o) <= 1) by (unfold m in om; lra).
    assert (U1 : c * G / (G - 1) * o * (G - 1) <= / 2 * (G - 1)) by (apply Rmult_le_compat_r; lra).
    assert (U2 : b / f * o * f <= / 2 * f) by (apply Rmult_le_compat_r; lra).
    replace (c * G / (G - 1) * o * (G - 1)) with (c * G * o) in U1 by (field; lra). replace (b / f * o * f) with (b * o) in U2 by (field; lra).
    repeat split; try lra. apply below_log; lra. }
  assert (bounds : forall s j, Rmax s1 s2 <= s -> after u s j -> (1 + / (2 * (1 + f))) * - Q s <= - Q (s + PI) /\
    - Q (s + PI) <= G * - Q s * (1 + c * off s) + c /\ off (s + PI) <= off s / G + c * off s ^ 2 + c / (- Q s) ^ 2).
  { intros s j hs ph. destruct (late s ltac:(minmax)) as (L1 & o0 & o1 & o2 & o3 & y1). destruct (P s j ltac:(minmax) ph) as (X & z & _ & R).
    specialize (R (s + PI) f (or_introl (conj eq_refl eq_refl))). set (L := - Q s) in *. set (L' := - Q (s + PI)) in *. set (o := off s) in *.
    replace (f * Q (s + PI) - (1 + f) * Q s) with ((1 + f) * L - f * L') in R by (unfold L, L'; ring).
    replace (Q s - Q (s + PI)) with (L' - L) in R by (unfold L, L'; ring).
    destruct (growth f (b * o) C L L' k0 C0 L1 ltac:(split; [ apply Rmult_le_pos | ]; lra) o2 R) as [R1 R2]. fold G in R2. split; [ trivial | split ].
    - assert (2 * (b * o / f) <= c * o) by (replace (2 * (b * o / f)) with (2 * (b / f) * o) by (field; lra); apply Rmult_le_compat_r; lra).
      assert (G * L * (2 * (b * o / f)) <= G * L * (c * o)) by (apply Rmult_le_compat_l; [ apply Rmult_le_pos | ]; lra). lra.
    - assert (b * o ^ 2 <= c * o ^ 2) by (apply Rmult_le_compat_r; [ apply pow2_ge_0 | lra ]). assert (16 / L ^ 2 <= c / L ^ 2); [ | lra ].
      apply Rmult_le_compat_r; [ left; apply Rinv_0_lt_compat, pow_lt | ]; lra. }
  (* the moments half a period apart *)
  destruct (per_spec (p + u) PI PI_RGT_0 (phi0 + Rmax s1 s2 + PI)) as [i Hi]. set (s0 := p + u + IZR i * PI - phi0). set (T n := s0 + INR n * PI).
  assert (h0 : Rmax s1 s2 <= s0) by (unfold s0; lra).
  assert (TT : forall n, Rmax s1 s2 <= T n /\ T (S n) = T n + PI /\ phi0 + T n = p + IZR (i + Z.of_nat n + 1 - 1) * PI + u).
  { intros n. pose proof (Rmult_le_pos _ _ (pos_INR n) (Rlt_le _ _ PI_RGT_0)). split; [ unfold T; lra | split; [ unfold T; rewrite S_INR; ring | ] ].
    replace (i + Z.of_nat n + 1 - 1)%Z with (i + Z.of_nat n)%Z by ring. rewrite plus_IZR, <- INR_IZR_INZ. unfold T, s0. ring. }
  destruct (stays_bounded (fun n => - Q (T n)) (fun n => off (T n)) G (1 + / (2 * (1 + f))) c) as [B HB]; trivial; try lra.
  { assert (0 < / (2 * (1 + f))) by (apply Rinv_0_lt_compat; lra). lra. }
  1-3: intros n; destruct (TT n) as (t1 & E & ph); destruct (bounds _ _ t1 ph) as (Z1 & Z2 & Z3); rewrite ?E; trivial.
  { destruct (late (T n)) as (q1 & q2 & q3 & _); [ minmax | lra ]. }
  exists (b * (G * B * (1 + c) + c) + C), s0. split; [ minmax | ]. intros s j hs ph.
  destruct (P s j ltac:(minmax) ph) as (_ & z & hz & R). exists z. split; trivial. intros t a ta.
  eapply Rle_trans; [ exact (R t a ta) | ].
  assert (K : exists n, s = T n).
  { exists (Z.to_nat (j - 1 - i)). unfold T. rewrite INR_IZR_INZ, Z2Nat.id; [ rewrite minus_IZR; unfold s0; lra | ].
    apply le_IZR. rewrite !minus_IZR in *. assert (IZR i <= IZR j - 1); [ apply Rmult_le_reg_r with PI; unfold s0 in hs; lra | lra ]. }
  destruct K as [n ->]. specialize (HB n). destruct (bounds _ _ (proj1 (TT n)) ph) as (_ & Z2 & _).
  destruct (late (T n)) as (q1 & q2 & _); [ destruct (TT n); minmax | ].
  cbv beta in HB. set (o := off (T n)) in *. set (L := - Q (T n)) in *. assert (W : o * (Q (T n) - Q (T n + PI)) <= G * B * (1 + c) + c).
  { apply Rle_trans with (o * (G * L * (1 + c * o) + c)); [ apply Rmult_le_compat_l; unfold L in *; lra | ].
    assert (c * o <= c * 1) by (apply Rmult_le_compat_l; lra).
    assert (0 <= o * L) by (apply Rmult_le_pos; lra). assert (0 <= c * o) by (apply Rmult_le_pos; lra).
    assert (G * (o * L) * (1 + c * o) <= G * B * (1 + c)) by (apply Rmult_le_compat; try apply Rmult_le_pos; try apply Rmult_le_compat_l; lra). lra. }
  apply (Rmult_le_compat_l b) in W; lra.
Qed.
(* so for the logarithm of |wy|, from the start on, from one moment to another *)
Notation J t := (ln (Rabs (wy t))).
Lemma Q_H t : 0 <= t -> Q t = 2 * J t.
Proof. intros ht. rewrite <- (pow2_abs (wy t)), ln_pow by (apply Rabs_pos_lt; now apply N). simpl. ring. Qed.
Lemma always (P : R -> R -> Prop) T C : 0 <= T -> (forall a b, P a b -> 0 <= a <= b /\
  (a < T -> b <= T + 2 * PI) /\ (T <= a -> Rabs (Q b - F * Q a) <= C)) ->
  exists C, forall a b, P a b -> Rabs (J b - F * J a) <= C.
Proof.
  intros hT A. pose proof PI_RGT_0. pose proof k_pos as k0. set (G := F). assert (hG : 0 < G) by (unfold G; apply Rdiv_lt_0_compat; lra).
  set (K := Rabs (J 0) + Rabs (J (T + 2 * PI))). assert (hK : forall t, 0 <= t <= T + 2 * PI -> Rabs (J t) <= K).
  { intros t ht. pose proof (Q_falls 0 t ltac:(lra)). pose proof (Q_falls t (T + 2 * PI) ltac:(lra)). rewrite !Q_H in * by lra.
    unfold K, Rabs at 1. pose proof (Rle_abs (J 0)). pose proof (Rabs_pos (J 0)). pose proof (Rabs_maj2 (J (T + 2 * PI))).
    pose proof (Rabs_pos (J (T + 2 * PI))). destruct Rcase_abs; lra. }
  assert (0 <= K) by (pose proof (hK 0 ltac:(lra)); pose proof (Rabs_pos (J 0)); lra). assert (0 <= G * K) by (apply Rmult_le_pos; lra).
  exists (Rabs C + K + G * K). intros a b p1. destruct (A a b p1) as (hab & early & late). pose proof (Rle_abs C). pose proof (Rabs_pos C).
  destruct (Rle_lt_dec T a) as [q | q].
  - specialize (late q). fold G in late. rewrite !Q_H in late by lra. apply Rabs_le_between in late. apply Rabs_le. lra.
  - specialize (early q). pose proof (hK a ltac:(lra)) as Ka. pose proof (hK b ltac:(lra)) as Kb. apply Rabs_le_between in Ka, Kb.
    assert (- (G * K) <= G * J a <= G * K) by (rewrite Ropp_mult_distr_r; split; apply Rmult_le_compat_l; lra). apply Rabs_le. lra.
Qed.
Lemma by_zeros : exists C, forall z z', 0 <= z < z' -> w z = 0 -> w z' = 0 -> (forall t, z < t < z' -> w t <> 0) -> Rabs (J z' - F * J z) <= C.
Proof.
  pose proof PI_RGT_0. pose proof k_pos as k0. destruct (passages (PI / 2) ltac:(lra)) as (C & s1 & s10 & P).
  assert (G : forall t, exists s m, t < s + PI /\ s <= t /\ phi0 + s = p + IZR (m + 1 - 1) * PI + PI / 2).
  { intros t. destruct (per_spec (p + PI / 2) PI PI_RGT_0 (phi0 + t)) as [m Hm]. exists (p + PI / 2 + IZR m * PI - phi0), m.
    replace (m + 1 - 1)%Z with m by ring. lra. }
  destruct (always (fun z z' => 0 <= z < z' /\ w z = 0 /\ w z' = 0 /\ forall t, z < t < z' -> w t <> 0) (s1 + PI) ((2 + 3 * k) * C / ((/ 2 + k) * k)))
    as [B HB]; [ lra | | exists B; intros; now apply HB ].
  intros a b (hab & wa & wb & no). split; [ lra | split ].
  - intros hs. destruct (G (s1 + PI + PI)) as (s & m & g1 & g2 & ph). destruct (P s _ ltac:(lra) ph) as (y & [hy Oy] & _). apply Rnot_lt_le. intros q.
    apply (no y); [ lra | now apply Oy ].
  - intros hs. destruct (G a) as (s & m & g1 & g2 & ph). destruct (P s _ ltac:(lra) ph) as (y & [hy Oy] & Ry).
    assert (a = y) by (apply Oy; trivial; lra). subst y. destruct (P (s + PI) (m + 1 + 1)%Z) as (y & [hy' Oy'] & Ry');
      [ lra | rewrite !minus_IZR, !plus_IZR in *; lra | ].
    assert (s + PI < b). { apply Rnot_le_lt. intros q. assert (b = a) by (apply Oy; trivial; lra). lra. }
    assert (b = y). { apply Oy'; trivial. split; [ lra | ]. apply Rnot_lt_le. intros q. apply (no y); [ lra | apply Oy'; lra ]. } subst y.
    pose proof (Ry _ _ (or_introl (conj eq_refl eq_refl))) as r1. pose proof (Ry _ _ (or_intror (conj eq_refl eq_refl))) as r2.
    pose proof (Ry' _ _ (or_intror (conj eq_refl eq_refl))) as r3. set (f := k) in *. apply Rabs_le_between in r1, r2, r3. apply over; [ nra | ].
    replace ((/ 2 + f) * f * (Q b - (1 + f) / f * Q a)) with (f * ((/ 2 + f) * Q b - (1 + f) * Q (s + PI))
      + (1 + f) * (f * Q (s + PI) - (1 + f) * Q s) - (1 + f) * ((/ 2 + f) * Q a - (1 + f) * Q s)) by (field; lra).
    assert (A : forall g x, 0 <= g -> - C <= x <= C -> - (g * C) <= g * x <= g * C) by (intros; split; nra).
    apply (A (1 + f)) in r1, r2; try lra. apply (A f) in r3; try lra. apply Rabs_le. lra.
Qed.
Lemma by_halves s0 : 0 <= s0 -> (forall n, phi0 + s0 <> p + IZR n * PI) -> exists C, forall n,
  let t := s0 + INR n * PI in Rabs (J (t + PI) - F * J t) <= C.
Proof.
  intros hs ne. pose proof PI_RGT_0. pose proof k_pos as k0. destruct (per_spec p PI ltac:(lra) (phi0 + s0)) as [m Hm].
  destruct (passages (phi0 + s0 - p - IZR m * PI)) as (C & s1 & s10 & P); [ destruct (Rdichotomy _ _ (ne m)); lra | ].
  destruct (always (fun a b => exists n, a = s0 + INR n * PI /\ b = a + PI) s1 (C / k)) as [B HB]; [ trivial | | exists B; intros n t; apply HB;
    now exists n ].
  intros a b (n & Ea & ->). pose proof (Rmult_le_pos _ _ (pos_INR n) (Rlt_le _ _ PI_RGT_0)).
  split; [ lra | split; [ lra | ] ]. intros h1. destruct (P a (m + Z.of_nat n + 1)%Z h1) as (z & _ & K).
  { rewrite minus_IZR, !plus_IZR, <- INR_IZR_INZ, Ea. ring. }
  specialize (K _ _ (or_introl (conj eq_refl eq_refl))). set (f := k) in *. apply over; trivial.
  replace (f * (Q (a + PI) - (1 + f) / f * Q a)) with (f * Q (a + PI) - (1 + f) * Q a) by (field; lra). exact K.
Qed.
Lemma doubly s0 : 0 <= s0 -> (forall n, phi0 + s0 <> p + IZR n * PI) -> exists a C, 0 < a /\ forall n,
  let t := s0 + INR n * PI in Rabs (J (t + PI) - F * J t) <= C /\ Rabs (J t + a * F ^ n) <= C.
Proof.
  intros hs ne. pose proof PI_RGT_0. pose proof k_pos as k0. destruct (by_halves s0 hs ne) as [C HC]. set (G := F) in *.
  assert (G1 : 1 < G) by (unfold G; apply Rlt_div_r; lra). assert (C0 : 0 <= C) by (eapply Rle_trans; [ apply Rabs_pos | apply (HC 0%nat) ]).
  assert (C1 : 0 <= C / (G - 1)) by (apply Rdiv_le_0_compat; lra). destruct (as_powers (fun n => - J (s0 + INR n * PI)) G C G1) as (a & a0 & A).
  - intros n. rewrite <- Rabs_Ropp, S_INR. replace (s0 + (INR n + 1) * PI) with (s0 + INR n * PI + PI) by ring.
    replace (- _) with (J (s0 + INR n * PI + PI) - G * J (s0 + INR n * PI)) by ring. apply HC.
  - destruct (z_1 l hl) as [_ z2]. destruct (near_38 l z2 phi0 w wy _ M (exp_pos (- (C / (G - 1))))) as (s1 & s10 & near).
    destruct (nat_above (s1 / PI)) as [n Hn]. apply Rlt_div_l in Hn; trivial. exists n. destruct (near (s0 + INR n * PI) ltac:(lra)) as [_ small].
    apply ln_increasing in small; [ | apply Rabs_pos_lt, N; lra ]. rewrite ln_exp in small. lra.
  - exists a, (C + C / (G - 1)). split; trivial. intros n t. specialize (HC n). specialize (A n). rewrite <- Rabs_Ropp in A.
    replace (- (- J _ - a * G ^ n)) with (J t + a * G ^ n) in A by (unfold t; ring). fold t in HC. lra.
Qed.
End Stages.
