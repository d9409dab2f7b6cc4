(* 2.4: region I, below A: forward and backward without rest *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic Steady Aniso Formulas Regions Region3 Attract.
Open Scope R_scope.

Lemma between_asin m x : 0 < m < 1 -> - (PI / 2) < x < 3 * (PI / 2) -> m < sin x -> asin m < x < PI - asin m.
Proof.
  intros hm hx H. destruct (p1_range m hm) as [[a b] e]. split; apply Rnot_le_lt; intros k.
  - pose proof (sin_incr_1 x (asin m)). lra.
  - pose proof (sin_incr_1 (PI - x) (asin m)). rewrite sin_PI_x in *. lra.
Qed.
Lemma far_phase z : 0 <= z < PI / 2 -> z * cos z <= (PI / 2 + z) * (PI / 2 - z) * sin z.
Proof.
  intros H. pose proof PI2_3_2. pose proof PI_4. destruct (Rle_lt_dec z 1) as [k | k].
  - pose proof (x_cos_sin z ltac:(lra)). assert (0 <= sin z) by (apply sin_ge_0; lra). assert (1 <= (PI / 2 + z) * (PI / 2 - z)) by nra. nra.
  - rewrite <- (sin_shift z), <- (cos_shift z). set (y := PI / 2 - z). assert (0 < y <= PI / 3) by (unfold y; lra). pose proof (sin_lt_x y ltac:(lra)).
    assert (1 / 2 <= cos y). { rewrite <- cos_PI3. apply cos_decr_1; lra. }
    apply Rle_trans with (z * y). nra. replace ((PI / 2 + z) * y * cos y) with (y * ((PI / 2 + z) * cos y)) by ring. rewrite (Rmult_comm z). apply Rmult_le_compat_l; [ lra | ]. nra.
Qed.

(* the middle of the forward slip, where sin c = l K / sin K *)
Definition middle l q := PI - asin (l * eq53_k q / sin (eq53_k q)).
Section One.
Variables l q : R.
Hypothesis hq : 1 <= q.
Hypothesis h0 : 0 < l.
Notation K := (eq53_k q).
Hypothesis below_A : eq53_sides_2 K l < eq53_sides_1 K l.
Notation c := (middle l q).
Lemma K_facts : PI / 2 <= K < PI /\ q * (PI - K) = K.
Proof.
  pose proof PI_RGT_0. assert (e : q * (PI - K) = K) by (unfold eq53_k; field; lra).
  split; trivial. assert (K < PI) by nra. split; trivial. nra.
Qed.
Lemma l_less : l < 1.
Proof.
  destruct K_facts as [k _]. pose proof PI_RGT_0. assert (s : 0 < sin K) by (apply sin_gt_0; lra). assert (C : cos K <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra).
  unfold eq53_sides_1, eq53_sides_2, cot in below_A. apply Rnot_le_lt. intros n.
  assert (z : sqrt (1 - l ^ 2) = 0) by (apply sqrt_neg_0; nra). rewrite z in below_A. unfold Rdiv in below_A. rewrite Rmult_0_l in below_A.
  assert (0 < K * / sin K ^ 2) by (apply Rdiv_lt_0_compat; nra). assert (0 < / sin K) by now apply Rinv_0_lt_compat. nra.
Qed.
(* the box of region I: the two identities behind curve A *)
Lemma box : 0 < l * K / sin K < 1 /\ l < sin (c - K) /\ q * l < - sin (c + K) /\ sin c * sin K = l * K /\ PI / 2 < c < PI.
Proof.
  destruct K_facts as [k kq]. pose proof l_less as l1. pose proof PI_RGT_0. assert (s0 : 0 < sin K) by (apply sin_gt_0; lra). assert (C0 : cos K <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra).
  assert (far : (2 * K - PI) * sin K <= - (2 * K * (PI - K) * cos K)).
  { pose proof (far_phase (K - PI / 2) ltac:(lra)) as F. replace (cos (K - PI / 2)) with (sin K) in F by (rewrite cos_minus, cos_PI2, sin_PI2; ring).
    replace (sin (K - PI / 2)) with (- cos K) in F by (rewrite sin_minus, cos_PI2, sin_PI2; ring). nra. }
  pose proof (sin2_cos2 K) as I. rewrite !Rsqr_pow2 in I. unfold eq53_sides_1, eq53_sides_2, cot in below_A. set (s := sin K) in *. set (C := cos K) in *.
  set (r := sqrt (1 - l ^ 2)) in *. assert (r0 : 0 <= r) by apply sqrt_pos. assert (r2 : r ^ 2 = 1 - l ^ 2) by (unfold r; apply pow2_sqrt; nra).
  assert (h1 : l * (K - s * C) < s ^ 2 * r).
  { apply (Rmult_lt_compat_l (l * s ^ 2)) in below_A; [ | apply Rmult_lt_0_compat; [ | apply pow_lt ]; trivial ]. replace (l * s ^ 2 * (K / s ^ 2 - C / s)) with (l * (K - s * C)) in below_A by (field; lra).
    replace (l * s ^ 2 * (r / l)) with (s ^ 2 * r) in below_A by (field; lra). trivial. }
  assert (h2 : (l * (K - s * C)) ^ 2 < (s ^ 2 * r) ^ 2) by (apply sq_lt; split; [ | trivial ]; apply Rmult_le_pos; nra).
  assert (h3 : (l * (s - K * C)) ^ 2 < (s ^ 2) ^ 2 - (s * (l * K)) ^ 2).
  { rewrite (Rpow_mult_distr (s ^ 2) r), r2 in h2. replace ((l * (s - K * C)) ^ 2) with (l ^ 2 * (s ^ 2 - 2 * K * s * C + K ^ 2 * C ^ 2)) by ring.
    replace ((l * (K - s * C)) ^ 2) with (l ^ 2 * (K ^ 2 - 2 * K * s * C + s ^ 2 * C ^ 2)) in h2 by ring. replace (C ^ 2) with (1 - s ^ 2) in * by lra. nra. }
  assert (h4 : l * K < s). { apply Rnot_le_lt. intros n. assert (0 <= (l * (s - K * C)) ^ 2) by apply pow2_ge_0. assert (s ^ 2 <= s * (l * K)) by nra. assert ((s ^ 2) ^ 2 <= (s * (l * K)) ^ 2) by (apply pow_incr; nra). lra. }
  set (S := l * K / s). assert (S0 : 0 < S < 1). { split. apply Rdiv_lt_0_compat; nra. apply Rlt_div_l; lra. }
  destruct (p1_range S S0) as [[a b] e]. assert (ec : c = PI - asin S) by reflexivity. assert (sc : sin c = S) by (rewrite ec, sin_PI_x; trivial).
  assert (cc : cos c = - cos (asin S)) by (rewrite ec, cos_minus, cos_PI, sin_PI; ring). set (x := cos (asin S)) in *.
  assert (x0 : 0 < x) by (apply cos_gt_0; lra). assert (x2 : x ^ 2 = 1 - S ^ 2). { pose proof (sin2_cos2 (asin S)) as J. rewrite !Rsqr_pow2, e in J. fold x in J. lra. }
  assert (Ss : S * s = l * K) by (unfold S; field; lra).
  assert (h5 : l * (s - K * C) < s ^ 2 * x).
  { apply sq_lt_inv. nra. rewrite (Rpow_mult_distr (s ^ 2)), x2. apply Rlt_le_trans with (1 := h3). rewrite <- Ss. right. ring. }
  split; [ trivial | ]. split; [ | split; [ | split; [ rewrite sc; trivial | rewrite ec; lra ] ] ].
  - rewrite sin_minus, sc, cc. fold s C. apply (Rmult_lt_reg_r s); trivial. replace ((S * C - - x * s) * s) with (S * s * C + s ^ 2 * x) by ring. rewrite Ss. lra.
  - rewrite sin_plus, sc, cc. fold s C. apply (Rmult_lt_reg_r s); trivial. replace (- (S * C + - x * s) * s) with (s ^ 2 * x - S * s * C) by ring. rewrite Ss.
    assert ((q - 1) * s <= - (2 * K * C)). { apply (Rmult_le_reg_r (PI - K)); [ lra | ]. replace ((q - 1) * s * (PI - K)) with ((q * (PI - K) - (PI - K)) * s) by ring. rewrite kq. nra. } nra.
Qed.

(* s24-region-1: forward from c - K to c + K, backward from there to c - K + 2 PI, and every motion along the line tends to it *)
Theorem s24_region_1 : exists W, steady l (q * l) W /\ (forall t0 w, line l (q * l) sin t0 w -> is_lim (fun t => w t - W t) p_infty 0) /\
  (forall t, c - K < t < c + K -> 0 < W t /\ W t = fwd l (c - K) t) /\ (forall t, c + K < t < c - K + 2 * PI -> W t < 0 /\ W t = bwd (q * l) (c + K) t).
Proof.
  destruct box as (S & p1 & p2 & S2 & cr). destruct K_facts as [k kq]. pose proof l_less as l1. pose proof PI_RGT_0. set (m := q * l) in *.
  assert (hm : 0 < m < 1). { pose proof (SIN_bound (c + K)). unfold m in *. split; nra. }
  pose proof (between_asin l (c - K) ltac:(lra) ltac:(lra) p1) as b1.
  assert (sh : - sin (c + K) = sin (c + K - PI)) by (rewrite (sin_minus (c + K)), cos_PI, sin_PI; ring). rewrite sh in p2.
  pose proof (between_asin m (c + K - PI) hm ltac:(lra) p2) as b2. destruct (p1_range l ltac:(lra)) as [[al _] _]. destruct (p1_range m hm) as [[be _] _].
  assert (z1 : fwd l (c - K) (c + K) = 0) by (unfold fwd; rewrite cos_minus, cos_plus; lra).
  assert (z2 : bwd m (c + K) (c - K + 2 * PI) = 0).
  { unfold bwd. replace (cos (c - K + 2 * PI)) with (cos (c - K)) by (rewrite <- (cos_period (c - K) 1); f_equal; simpl; ring). rewrite cos_minus, cos_plus. unfold m.
    replace (q * l * (c - K + 2 * PI - (c + K))) with (2 * l * (q * (PI - K))) by ring. rewrite kq. lra. }
  assert (P : forall t, c - K < t < c + K -> 0 < fwd l (c - K) t) by (apply fwd_pos; lra).
  assert (N : forall t, c + K < t < c - K + 2 * PI -> bwd m (c + K) t < 0).
  { intros t Ht. rewrite bwd_fwd. rewrite bwd_fwd in z2. pose proof (fwd_pos m hm (c + K - PI) (c - K + 2 * PI - PI) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) (t - PI) ltac:(lra)). lra. }
  pose (g := glue (c + K) (fwd l (c - K)) (bwd m (c + K))).
  assert (A : arc l m sin (c - K) (c - K + 2 * PI) g).
  { apply arc_glue; [ lra | | | rewrite z1; unfold bwd; ring ].
    - apply arc_fwd; try lra. intros t Ht. destruct (Req_dec t (c - K)) as [-> | ]. unfold fwd; lra. left; apply P; lra.
    - apply arc_bwd; try lra. intros t Ht. destruct (Req_dec t (c + K)) as [-> | ]. unfold bwd; lra. left; apply N; lra. }
  assert (g0 : g (c - K) = 0). { unfold g, glue. destruct (Rlt_dec (c - K) (c + K)); [ unfold fwd; ring | lra ]. }
  assert (G : g (c - K + 2 * PI) = g (c - K)). { rewrite g0. unfold g, glue. destruct (Rlt_dec (c - K + 2 * PI) (c + K)); [ lra | trivial ]. }
  assert (Sp : forall t, sin (t + 2 * PI) = sin t) by (intros t; rewrite <- (sin_2PI (t + 2 * PI)); f_equal; ring).
  set (W := per (c - K) (2 * PI) g). assert (hT : 0 < 2 * PI) by lra.
  assert (L : forall t0, line l m sin t0 W) by (apply per_line; trivial).
  assert (R : forall t, W (t + 2 * PI) = W t) by (intros t; apply per_per; trivial).
  assert (on : forall t, c - K <= t < c - K + 2 * PI -> W t = g t).
  { intros t Ht. unfold W. rewrite (per_on (c - K) (2 * PI) g hT 0) by (simpl; lra). f_equal. ring. }
  assert (W1 : forall t, c - K < t < c + K -> 0 < W t /\ W t = fwd l (c - K) t).
  { intros t Ht. rewrite on by lra. unfold g, glue. destruct (Rlt_dec t (c + K)); [ | lra ]. split; trivial. apply P, Ht. }
  assert (W2 : forall t, c + K < t < c - K + 2 * PI -> W t < 0 /\ W t = bwd m (c + K) t).
  { intros t Ht. rewrite on by lra. unfold g, glue. destruct (Rlt_dec t (c + K)); [ lra | ]. split; trivial. apply N, Ht. }
  exists W. split; [ split; trivial | split; [ | split; trivial ] ].
  intros t0 w Hw. apply (line_attracts l m 1 (2 * PI) (c - K) (Rmin (2 * K) (2 * PI - 2 * K)) sin W) with (t0 := t0); trivial; try lra.
  - intros t. apply Rabs_le. apply SIN_bound.
  - apply Rmin_pos; lra.
  - rewrite on by lra. trivial.
  - intros t Ht. rewrite <- R. pose proof (Rmin_r (2 * K) (2 * PI - 2 * K)). apply W2. lra.
  - intros t Ht. pose proof (Rmin_l (2 * K) (2 * PI - 2 * K)). apply W1. lra.
Qed.
End One.
