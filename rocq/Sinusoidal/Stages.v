(* Below lambda_c, that a passage of w through zero multiplies the logarithm of wy by the stated factor up to terms that stay bounded: how far the
   zeros of w are from those of (38), and how fast these distances fall, as that logarithm grows. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Exists Formulas HalfPeriod Drawn Analysis Steady Shaken LargeTime Zeros Across.
Open Scope R_scope.

(* ---- sequences: L grows at most by the factor by which x falls, but for terms with finite sums ---- *)
Lemma stays_bounded (L x : nat -> R) F q r c : 1 < F -> 1 < q -> 0 <= r < 1 -> 0 <= c ->
  (forall n, 1 <= L n /\ q * L n <= L (S n) /\ 0 <= x n <= 1) ->
  (forall n, L (S n) <= F * L n * (1 + c * x n) + c) ->
  (forall n, x (S n) <= x n / F * (1 + c * x n + c * x (S n)) + c / L n ^ 2) ->
  (forall n, x (S n) <= r * x n + c / L n) ->
  exists B, forall n, x n * L n <= B.
Proof.
  intros hF hq hr hc H HL HX HR. set (c2 := c * (2 + 2 * c) + c * F * (1 + c) + c ^ 2).
  assert (h2 : 0 <= c2 /\ c * (2 + 2 * c) <= c2 /\ c * F * (1 + c) + c ^ 2 <= c2).
  { assert (0 <= c * (2 + 2 * c)) by nra. assert (0 <= c * F * (1 + c)) by (repeat apply Rmult_le_pos; lra). unfold c2. nra. }
  assert (step : forall n, x (S n) * L (S n) <= x n * L n * (1 + c2 * (x n + x (S n))) + c2 * (x n + / L n)).
  { intros n. destruct (H n) as (l1 & _ & x0). destruct (H (S n)) as (l2 & _ & x1). specialize (HL n). specialize (HX n).
    set (i := / L n). assert (hi : 0 < i <= 1) by (unfold i; split; [ apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra ]).
    assert (iL : i * L n = 1) by (unfold i; field; lra).
    replace (c / L n ^ 2) with (c * i ^ 2) in HX by (unfold i; field; lra). set (a := x n) in *. set (b := x (S n)) in *. set (X := 1 + c * a + c * b) in *.
    assert (hX : 1 <= X <= 1 + 2 * c) by (unfold X; nra). set (f := / F). assert (hf : 0 < f < 1). { unfold f. split; [ apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1;
    apply Rinv_lt_contravar; lra ]. } assert (fF : f * F = 1) by (unfold f; field; lra). replace (a / F) with (a * f) in HX by (unfold f, Rdiv; trivial).
    set (U := a * f * X + c * i ^ 2) in *. set (V := F * L n * (1 + c * a) + c) in *.
    assert (b * L (S n) <= U * V) by (apply Rmult_le_compat; lra).
    assert (E : U * V = a * L n * (X * (1 + c * a)) + c * a * f * X + c * F * i * (1 + c * a) + c ^ 2 * i ^ 2).
    { unfold U, V. transitivity (a * L n * (f * F) * (X * (1 + c * a)) + c * a * f * X + c * F * i * (i * L n) * (1 + c * a) + c ^ 2 * i ^ 2); [ ring | ].
      rewrite fF, iL. ring. }
    assert (t1 : X * (1 + c * a) <= 1 + c2 * (a + b)).
    { assert (c * a * X <= c * a * (1 + 2 * c)) by (apply Rmult_le_compat_l; nra). assert (c * (2 + 2 * c) * (a + b) <= c2 * (a + b)) by (apply Rmult_le_compat_r; lra).
      assert (0 <= c * b * (1 + 2 * c)) by (repeat apply Rmult_le_pos; lra). unfold X in *. nra. }
    assert (t2 : c * a * f * X <= c2 * a).
    { assert (c * a * (f * X) <= c * a * (1 * (1 + 2 * c))) by (apply Rmult_le_compat_l; [ nra | apply Rmult_le_compat; lra ]).
      assert (c * (2 + 2 * c) * a <= c2 * a) by (apply Rmult_le_compat_r; lra). nra. }
    assert (t3 : c * F * i * (1 + c * a) + c ^ 2 * i ^ 2 <= c2 * i).
    { assert (c * F * i * (1 + c * a) <= c * F * i * (1 + c)). { apply Rmult_le_compat_l; [ repeat apply Rmult_le_pos; lra | nra ]. }
      assert (c ^ 2 * i ^ 2 <= c ^ 2 * i) by (apply Rmult_le_compat_l; [ apply pow2_ge_0 | nra ]).
      assert ((c * F * (1 + c) + c ^ 2) * i <= c2 * i) by (apply Rmult_le_compat_r; lra). lra. }
    assert (a * L n * (X * (1 + c * a)) <= a * L n * (1 + c2 * (a + b))) by (apply Rmult_le_compat_l; nra). lra. }
  (* (1 + x L) exp (A x + B / L) falls *)
  set (A := 2 * c2 / (1 - r) + c2). set (D := (c2 + c2 * c + A * c) / (1 - / q)).
  assert (iq : 0 < / q < 1) by (split; [ apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_lt_contravar; lra ]).
  assert (hA : 0 <= A /\ A * (1 - r) >= 2 * c2). { assert (0 <= 2 * c2 / (1 - r)) by (apply Rdiv_le_0_compat; lra). unfold A. split; [ lra | ].
    replace ((2 * c2 / (1 - r) + c2) * (1 - r)) with (2 * c2 + c2 * (1 - r)) by (field; lra). nra. }
  assert (hD : 0 <= D /\ D * (1 - / q) = c2 + c2 * c + A * c). { unfold D. split; [ apply Rdiv_le_0_compat; [ | lra ] | field; lra ].
    assert (0 <= c2 * c) by nra. assert (0 <= A * c) by nra. lra. }
  set (V := fun n => (1 + x n * L n) * exp (A * x n + D * / L n)).
  assert (fall : forall n, V (S n) <= V n).
  { intros n. destruct (H n) as (l1 & g & x0). destruct (H (S n)) as (l2 & _ & x1). specialize (step n). specialize (HR n). unfold V.
    set (i := / L n) in *. assert (hi : 0 < i) by (unfold i; apply Rinv_0_lt_compat; lra). assert (hi' : / L (S n) <= / q * i).
    { unfold i. rewrite <- Rinv_mult. apply Rinv_le_contravar; trivial. nra. } unfold Rdiv in HR. fold i in HR.
    set (a := x n) in *. set (b := x (S n)) in *. set (t := c2 * (a + b + i)). assert (0 <= t) by (unfold t; nra). assert (0 <= a * L n) by nra.
    assert (P : 1 + b * L (S n) <= (1 + a * L n) * exp t). { apply Rle_trans with ((1 + a * L n) * (1 + t)); [ | apply Rmult_le_compat_l; [ lra | apply exp_ineq1_le ] ].
      assert (0 <= a * L n * (c2 * i)) by (apply Rmult_le_pos; nra). assert (0 <= c2 * b) by nra. unfold t. nra. }
    apply Rle_trans with ((1 + a * L n) * exp t * exp (A * b + D * / L (S n))); [ apply Rmult_le_compat_r; [ left; apply exp_pos | trivial ] | ].
    rewrite Rmult_assoc, <- exp_plus. apply Rmult_le_compat_l; [ lra | ].
    assert (D * / L (S n) <= D * (/ q * i)) by (apply Rmult_le_compat_l; lra). assert (A * b <= A * (r * a + c * i)) by (apply Rmult_le_compat_l; lra).
    assert (c2 * b <= c2 * (r * a + c * i)) by (apply Rmult_le_compat_l; lra). assert (D * (1 - / q) * i = (c2 + c2 * c + A * c) * i) by (now rewrite (proj2 hD)).
    assert (2 * c2 * a <= A * (1 - r) * a) by (apply Rmult_le_compat_r; lra). assert (c2 * r * a <= c2 * 1 * a) by (apply Rmult_le_compat_r; nra).
    assert (W : t + (A * b + D * / L (S n)) <= A * a + D * i) by (unfold t; lra).
    destruct W as [W | ->]; [ left; now apply exp_increasing | lra ]. }
  exists (V 0%nat). intros n. apply Rle_trans with (V n). 2: { induction n as [ | n IH ]; [ lra | ]. specialize (fall n). lra. }
  unfold V. destruct (H n) as (l1 & _ & x0). assert (0 < / L n) by (apply Rinv_0_lt_compat; lra).
  assert (0 <= A * x n + D * / L n) by (assert (0 <= A * x n) by nra; nra). pose proof (exp_ineq1_le (A * x n + D * / L n)). assert (0 <= x n * L n) by nra. nra.
Qed.

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
(* a passage, up to C and what the distance of the zeros makes *)
Lemma passing u : 0 < u < PI -> exists C s1, 0 <= s1 /\ forall s j, s1 <= s -> phi0 + s = p + IZR (j - 1) * PI + u ->
  exists z, s <= z <= s + PI /\ w z = 0 /\ (forall t, s <= t < z -> sg j * w t <= 0) /\ (forall t, z <= t < s + PI -> 0 <= sg j * w t) /\
  Rabs (k * Q (s + PI) - (1 + k) * Q s) <= Rabs (z - (s + PI - u)) / (2 * l) * (Q s - Q (s + PI)) + C.
Proof.
  intros hu. pose proof PI_RGT_0. destruct (room l hl) as (ra & rb). destruct (z_1 l hl) as [h1 _].
  set (del := Rmin (Rmin u (PI - u) / 2) (Rmin (p - asin l) (PI / 2 - p) / 2)).
  assert (hd : 0 < del /\ del < u /\ del < PI - u /\ del <= (p - asin l) / 2 /\ del < PI / 2 - p) by (unfold del; minmax). clearbody del.
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
  split; [ unfold Z in *; lra | split; [ trivial | split; [ | split ] ] ].
  { intros t Ht. fold e. destruct (Rle_lt_dec t (Z - del)) as [q | q]; [ specialize (A t ltac:(lra)); lra | ].
    pose proof (G t z ltac:(lra) ltac:(lra)) as g. rewrite wz in g. assert (0 <= c * (z - t)) by nra. lra. }
  { intros t Ht. fold e. destruct (Rle_lt_dec (Z + del) t) as [q | q]; [ specialize (B t ltac:(lra)); lra | ].
    pose proof (G z t ltac:(lra) ltac:(lra)) as g. rewrite wz in g. assert (0 <= c * (t - z)) by nra. lra. }
  fold Z. set (x := Rabs (z - Z)). assert (x0 : 0 <= x) by apply Rabs_pos. set (eta := x / (2 * l)). assert (le : 2 * l * eta = x) by (unfold eta; field; lra).
  assert (T : forall g, g = 1 \/ g = -1 -> g * (ln (v (s + PI) + e * w (s + PI)) + k * Q (s + PI)) + eta * Q (s + PI) - (2 / m + / c) * (s + PI) <=
    g * (ln (v s + e * w s) + k * Q s) + eta * Q s - (2 / m + / c) * s).
  { intros g hg. apply (rder_decr (fun t => g * (ln (v t + e * w t) + k * Q t) + eta * Q t - (2 / m + / c) * t)); [ lra | | ]; intros t Ht;
    destruct (moving l phi0 w wy (proj1 hl) M t ltac:(lra) ltac:(apply N; lra)) as (y2 & n1 & D & E); destruct (E e ee) as [q L].
    - conts M.
    - apply (rder_log (fun t => wy t ^ 2)) in D; trivial. apply (rder_log (fun t => v t + e * w t)) in L; trivial. eexists. split. rds.
      cbv beta. pose proof (Rabs_pos (w t)). set (b := e * sin (phi0 + t)). set (r := v t) in *. match goal with |- ?x <= 0 =>
        replace x with ((g * (b - d) - 2 * l * eta) / r - (2 / m + / c)) by (unfold b; field; lra) end.
      assert (near : Rabs (b - d) <= Rabs (t - Z)).
      { unfold b, e. rewrite (drive_at j (phi0 + t) (p + (t - Z))) by (unfold Z; lra).
        replace (t - Z) with (p + (t - Z) - p) at 2 by ring. apply sin_near. }
      assert (gb : g * (b - d) <= Rabs (b - d)) by (pose proof (Rle_abs (b - d)); pose proof (Rabs_maj2 (b - d)); destruct hg as [-> | ->]; lra).
      rewrite le. assert (0 < / m) by now apply Rinv_0_lt_compat. assert (0 < / c) by now apply Rinv_0_lt_compat.
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
  pose proof (size (s + PI) e ltac:(lra) ee (B (s + PI) ltac:(unfold Z; lra))) as r1.
  pose proof (size s (- e) ltac:(lra) eo (A s ltac:(unfold Z; lra))) as r2.
  assert (r3 : ln (v s + e * w s) = Q s - ln (v s + - e * w s)).
  { destruct (moving l phi0 w wy (proj1 hl) M s ltac:(lra) ltac:(apply N; lra)) as (_ & _ & _ & E). destruct (E e ee) as [x1 _]. destruct (E (- e) eo) as [x2 _].
    enough (K : Q s = ln (v s + e * w s) + ln (v s + - e * w s)) by lra. rewrite <- ln_mult by trivial.
    f_equal. transitivity (v s ^ 2 - e ^ 2 * w s ^ 2); [ | ring ]. rewrite nrm_sq. destruct ee as [-> | ->]; ring. }
  rewrite r3 in T. pose proof (T 1 ltac:(auto)). pose proof (T (-1) ltac:(auto)). apply Rabs_le_between in r1, r2. apply Rabs_le. lra.
Qed.
End Stages.
