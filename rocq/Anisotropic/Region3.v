(* 2.4: region III, between B and C: two rests *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic Steady Aniso Formulas Regions.
Open Scope R_scope.

Lemma x_cos_sin x : 0 <= x <= PI / 2 -> x * cos x <= sin x.
Proof.
  intros [[h0 | <-] h]. 2: rewrite sin_0; lra.
  enough (0 < sin x - x * cos x) by lra. replace 0 with (sin 0 - 0 * cos 0) by (rewrite sin_0; ring).
  apply (up (fun x => sin x - x * cos x) (fun x => x * sin x)); [ lra | intros; auto_derive; trivial; ring | ].
  intros c Hc. apply Rmult_lt_0_compat; [ lra | apply sin_gt_0; lra ].
Qed.
(* where the forward slip ends before the backward one begins, the backward slip ends before the forward one begins *)
Lemma second_rest a b : 0 < a <= b -> b < PI / 2 -> cos a + cos b < sin a * (PI + b - a) -> cos a + cos b < sin b * (PI + a - b).
Proof.
  intros h1 h2 H. pose proof PI_RGT_0. pose proof PI2_3_2. destruct (Rle_lt_dec (sin a * (PI + b - a)) (sin b * (PI + a - b))) as [k | k]; [ lra | ].
  set (s := (a + b) / 2). set (d := (b - a) / 2). assert (ea : a = s - d) by (unfold s, d; field). assert (eb : b = s + d) by (unfold s, d; field).
  assert (hd : 0 <= d < PI / 4) by (unfold d; lra). assert (hs : 0 < s < PI / 2) by (unfold s; lra). clearbody s d. subst a b.
  rewrite cos_minus, cos_plus, sin_plus, sin_minus in *.
  assert (0 < cos s) by (apply cos_gt_0; lra). assert (0 < sin s) by (apply sin_gt_0; lra). assert (0 < cos d) by (apply cos_gt_0; lra). assert (0 <= sin d) by (apply sin_ge_0; lra).
  pose proof (x_cos_sin d ltac:(lra)). set (Cs := cos s) in *. set (Ss := sin s) in *. set (Cd := cos d) in *. set (Sd := sin d) in *.
  assert (K : 2 * PI * (Cs * Sd) < 4 * d * (Ss * Cd)) by nra.
  assert (d0 : 0 < d). { destruct hd as [[q | <-] _]; [ trivial | ]. assert (0 <= Cs * Sd) by nra. nra. }
  assert (L : PI * Cs < 2 * Ss).
  { apply (Rmult_lt_reg_r (d * Cd)); [ nra | ]. assert (PI * Cs * (d * Cd) <= PI * Cs * Sd) by (apply Rmult_le_compat_l; nra). lra. }
  assert (0 <= Cs * Sd) by nra. assert (0 < Ss * Cd) by nra.
  assert (Ss * Cd * (PI / 2) <= (Ss * Cd + Cs * Sd) * (PI + (s - d) - (s + d))) by nra.
  assert (2 * (Cs * Cd) < Ss * Cd * (PI / 2)); [ | lra ].
  replace (Ss * Cd * (PI / 2)) with (2 * Ss * Cd * (PI / 4)) by field. assert (PI * Cs * Cd * (PI / 4) < 2 * Ss * Cd * (PI / 4)).
  { apply Rmult_lt_compat_r; [ lra | ]. apply Rmult_lt_compat_r; trivial. }
  assert (2 * (Cs * Cd) <= PI * Cs * Cd * (PI / 4)); [ | lra ]. assert (0 < Cs * Cd) by nra. assert (9 < PI * PI) by nra. nra.
Qed.

(* s24-region-3: forward from phi1, rest, backward from PI + asin (q l), rest *)
Theorem s24_region_3 l q : 1 <= q -> 0 < l -> l < eq55_lambda0 q -> eq54_sides_1 l (q * l) < eq54_sides_2 l (q * l) ->
  exists e e' W, PI - asin l < e < PI + asin (q * l) /\ PI + asin (q * l) < e' < 2 * PI + asin l /\ steady l (q * l) W /\ reached l (q * l) W /\
  (forall t, asin l < t < e -> 0 < W t) /\ (forall t, e <= t <= PI + asin (q * l) -> W t = 0) /\
  (forall t, PI + asin (q * l) < t < e' -> W t < 0) /\ (forall t, e' <= t <= 2 * PI + asin l -> W t = 0).
Proof.
  unfold eq55_lambda0, eq54_sides_1, eq54_sides_2. intros hq h0 h1 B. apply Rlt_div_r in h1; [ | lra ]. assert (hm : 0 < q * l < 1) by nra. assert (hl : 0 < l < 1) by nra.
  destruct (fwd_end l hl) as (e & He & z & P). destruct (p1_range l hl) as [[a b] ea]. destruct (fwd_end (q * l) hm) as (f & Hf & zf & Pf). destruct (p1_range (q * l) hm) as [[a' b'] eb].
  rewrite <- !cos_asin_pow in B by lra. assert (ab : asin l <= asin (q * l)). { apply Rnot_lt_le. intros k. pose proof (sin_increasing_1 (asin (q * l)) (asin l)). nra. }
  set (al := asin l) in *. set (be := asin (q * l)) in *. set (m := q * l) in *.
  pose proof (second_rest al be ltac:(lra) b' ltac:(rewrite ea; lra)) as B2. rewrite eb in B2. pose proof PI_RGT_0 as pi0.
  assert (e1 : e < PI + be). { apply Rnot_le_lt. intros k. assert (F : fwd l al (PI + be) < 0) by (unfold fwd; rewrite Rplus_comm, neg_cos; lra).
    destruct (Req_dec e (PI + be)) as [-> | ]; [ lra | ]. specialize (P (PI + be) ltac:(lra)). lra. }
  assert (f1 : f < PI + al). { apply Rnot_le_lt. intros k. assert (F : fwd m be (PI + al) < 0) by (unfold fwd; rewrite Rplus_comm, neg_cos; lra).
    destruct (Req_dec f (PI + al)) as [-> | ]; [ lra | ]. specialize (Pf (PI + al) ltac:(lra)). lra. }
  assert (bf : forall t, bwd m (PI + be) t = - fwd m be (t - PI)) by (intros t; rewrite bwd_fwd; do 2 f_equal; ring).
  assert (Q : forall t, PI + be < t < PI + f -> bwd m (PI + be) t < 0) by (intros t Ht; rewrite bf; specialize (Pf (t - PI) ltac:(lra)); lra).
  pose (g := glue e (fwd l al) (glue (PI + be) (fun _ => 0) (glue (PI + f) (bwd m (PI + be)) (fun _ => 0)))).
  assert (G1 : forall t, t < e -> g t = fwd l al t) by (intros t k; unfold g, glue; destruct (Rlt_dec t e); [ trivial | lra ]).
  assert (G2 : forall t, e <= t < PI + be -> g t = 0) by (intros t k; unfold g, glue; destruct (Rlt_dec t e); [ lra | ]; destruct (Rlt_dec t (PI + be)); [ trivial | lra ]).
  assert (G3 : forall t, PI + be <= t < PI + f -> g t = bwd m (PI + be) t) by (intros t k; unfold g, glue; destruct (Rlt_dec t e); [ lra | ]; destruct (Rlt_dec t (PI + be)); [ lra | ]; destruct (Rlt_dec t (PI + f)); [ trivial | lra ]).
  assert (G4 : forall t, PI + f <= t -> g t = 0) by (intros t k; unfold g, glue; destruct (Rlt_dec t e); [ lra | ]; destruct (Rlt_dec t (PI + be)); [ lra | ]; destruct (Rlt_dec t (PI + f)); [ lra | trivial ]).
  assert (low : forall t, PI / 2 <= t < PI + be -> - m < sin t). { intros t Ht. rewrite <- eb, <- neg_sin, Rplus_comm. apply sin_decreasing_1; lra. }
  assert (A : arc l m sin al (al + 2 * PI) g).
  { apply arc_glue; [ lra | | apply arc_glue; [ lra | | apply arc_glue; [ lra | | | ] | ] | ].
    - apply arc_fwd; try lra. intros t Ht. destruct (Req_dec t al) as [-> | ]. unfold fwd; lra. left; apply P; lra.
    - apply arc_rest; try lra. intros t Ht. pose proof (low t ltac:(lra)). pose proof (sin_less l hl t) as K. fold al in K. lra.
    - apply arc_bwd; try lra. intros t Ht. destruct (Req_dec t (PI + be)) as [-> | ]. unfold bwd; lra. left; apply Q; lra.
    - apply arc_rest; try lra. intros t Ht. split. rewrite <- sin_2PI, <- eb, <- sin_neg. apply sin_incr_1; lra. left. apply sin_less; trivial. fold al. lra.
    - rewrite bf. replace (PI + f - PI) with f by ring. lra.
    - unfold glue. destruct (Rlt_dec (PI + be) (PI + f)); [ unfold bwd; ring | trivial ].
    - unfold glue. destruct (Rlt_dec e (PI + be)); [ trivial | lra ]. }
  assert (G : g (al + 2 * PI) = g al). { rewrite G4, G1 by lra. unfold fwd; ring. }
  assert (S : forall t, sin (t + 2 * PI) = sin t) by (intros t; rewrite <- (sin_2PI (t + 2 * PI)); f_equal; ring).
  set (W := per al (2 * PI) g). assert (hT : 0 < 2 * PI) by lra.
  assert (L : forall t0, line l m sin t0 W) by (apply per_line; trivial).
  assert (R : forall t, W (t + 2 * PI) = W t) by (intros t; apply per_per; trivial).
  assert (on : forall t, al <= t < al + 2 * PI -> W t = g t).
  { intros t Ht. unfold W. rewrite (per_on al (2 * PI) g hT 0) by (simpl; lra). f_equal. ring. }
  assert (Z : forall t, e <= t <= PI + be -> W t = 0).
  { intros t Ht. rewrite on by lra. destruct (Req_dec t (PI + be)) as [-> | ]. rewrite G3 by lra. unfold bwd; ring. apply G2; lra. }
  exists e, (PI + f), W. split; [ lra | split; [ lra | split; [ split; trivial | split; [ | split; [ | split; [ trivial | split ] ] ] ] ] ].
  - intros t0 w Hw. apply (captured l m (2 * PI) ((e + (PI + be)) / 2) (PI + be) sin W); trivial; try lra.
    + intros t Ht. apply Z; lra.
    + split. apply low; lra. apply sin_less; trivial. fold al. lra.
    + apply derivable_continuous_pt, derivable_pt_sin.
  - intros t Ht. rewrite on, G1 by lra. apply P; lra.
  - intros t Ht. rewrite on, G3 by lra. apply Q; lra.
  - intros t Ht. destruct (Req_dec t (2 * PI + al)) as [-> | ne]; [ | rewrite on, G4 by lra; trivial ].
    rewrite Rplus_comm, R, on, G1 by lra. unfold fwd; ring.
Qed.
