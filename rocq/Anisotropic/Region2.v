(* 2.4: region II, corrected: above A, below B, C and E *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic Steady Aniso Formulas Regions Region3 Attract Region1.
Open Scope R_scope.

Lemma x_cos_lt x : 0 < x < PI -> x * cos x < sin x.
Proof.
  intros h. enough (0 < sin x - x * cos x) by lra. replace 0 with (sin 0 - 0 * cos 0) by (rewrite sin_0; ring).
  apply (up (fun x => sin x - x * cos x) (fun x => x * sin x)); [ lra | intros; auto_derive; trivial; ring | ].
  intros c Hc. apply Rmult_lt_0_compat; [ lra | apply sin_gt_0; lra ].
Qed.
(* the right side of (53) grows with K *)
Lemma side_A_grows l K L : 0 < K <= L -> L < PI -> eq53_sides_2 K l <= eq53_sides_2 L l.
Proof.
  intros [h0 [h1 | ->]] h2; [ | lra ]. left. unfold eq53_sides_2, cot. 
  assert (P : forall c, K <= c <= L -> 0 < sin c) by (intros; apply sin_gt_0; lra).
  apply (up (fun K => K / sin K ^ 2 - cos K / sin K) (fun c => 2 * (sin c - c * cos c) / sin c ^ 3)); trivial.
  - intros c Hc. specialize (P c Hc). pose proof (sin2_cos2 c) as I. rewrite !Rsqr_pow2 in I. auto_derive. repeat split; nra.
    replace (2 * (sin c - c * cos c) / sin c ^ 3) with ((2 * sin c + 0 - 2 * c * cos c) / sin c ^ 3) by (f_equal; ring).
    field_simplify_eq; [ | lra ]. replace (cos c ^ 2) with (1 - sin c ^ 2) by lra. ring.
  - intros c Hc. specialize (P c ltac:(lra)). pose proof (x_cos_lt c ltac:(lra)). apply Rdiv_lt_0_compat; [ lra | now apply pow_lt ].
Qed.
(* a forward slip from phi1 that lasts 2 L has (53) with L for K *)
Lemma slip_side l L : 0 < l < 1 -> 0 < L < PI -> fwd l (asin l) (asin l + 2 * L) = 0 -> eq53_sides_1 L l = eq53_sides_2 L l.
Proof.
  intros hl hL z. destruct (p1_range l hl) as [[a b] e]. set (al := asin l) in *. set (c := al + L). unfold eq53_sides_1, eq53_sides_2, cot.
  assert (s0 : 0 < sin L) by (apply sin_gt_0; lra). pose proof (x_cos_lt L hL) as xl. pose proof (sin2_cos2 L) as I. rewrite !Rsqr_pow2 in I. pose proof (sin2_cos2 c) as Ic. rewrite !Rsqr_pow2 in Ic.
  assert (h1 : sin c * sin L = l * L). { unfold fwd in z. replace (al + 2 * L) with (c + L) in z by (unfold c; ring). replace (cos al) with (cos (c - L)) in z by (f_equal; unfold c; ring). rewrite cos_minus, cos_plus in z. unfold c in *. lra. }
  assert (h2 : sin c * cos L - cos c * sin L = l). { rewrite <- sin_minus, <- e. f_equal. unfold c; ring. }
  set (s := sin L) in *. set (C := cos L) in *. set (S := sin c) in *. set (x := cos c) in *.
  assert (L0 : 0 < L - s * C). { assert (s < L) by (apply sin_lt_x; lra). assert (s * C <= s) by (unfold C; pose proof (COS_bound L); nra). lra. }
  assert (h3 : (s ^ 2) ^ 2 * (1 - l ^ 2) = (l * (L - s * C)) ^ 2).
  { assert (h4 : x * s ^ 2 = l * L * C - l * s) by (replace (x * s ^ 2) with (S * s * C - (S * C - x * s) * s) by ring; rewrite h1, h2; ring).
    assert (h5 : (s * (l * L)) ^ 2 + (l * L * C - l * s) ^ 2 = (s ^ 2) ^ 2) by (rewrite <- h4, <- h1; replace ((s ^ 2) ^ 2) with ((s ^ 2) ^ 2 * (S ^ 2 + x ^ 2)) by (rewrite Ic; ring); ring).
    assert (C2 : C ^ 2 = 1 - s ^ 2) by lra.
    assert (h6 : l ^ 2 * (L ^ 2 * s ^ 2 + L ^ 2 * C ^ 2 - 2 * L * s * C + s ^ 2) = (s ^ 2) ^ 2) by (rewrite <- h5; ring). rewrite C2 in h6.
    replace ((l * (L - s * C)) ^ 2) with (l ^ 2 * (L ^ 2 - 2 * L * s * C + s ^ 2 * C ^ 2)) by ring. rewrite C2. lra. }
  assert (h4 : s ^ 2 * sqrt (1 - l ^ 2) = l * (L - s * C)).
  { set (r := sqrt (1 - l ^ 2)). assert (r2 : r ^ 2 = 1 - l ^ 2) by (unfold r; apply pow2_sqrt; nra). assert (0 <= r) by apply sqrt_pos. rewrite <- r2, <- Rpow_mult_distr in h3.
    apply Rsqr_inj; [ nra | apply Rmult_le_pos; lra | rewrite !Rsqr_pow2; trivial ]. }
  apply (Rmult_eq_reg_l (l * s ^ 2)); [ | apply Rgt_not_eq, Rmult_lt_0_compat; [ lra | now apply pow_lt ] ].
  replace (l * s ^ 2 * (sqrt (1 - l ^ 2) / l)) with (s ^ 2 * sqrt (1 - l ^ 2)) by (field; lra). rewrite h4. field. lra.
Qed.

(* s24-region-2, corrected: forward from phi1, at once backward, then rest; every motion along the line becomes this one *)
Theorem s24_region_2 l q : 1 <= q -> 0 < l -> l < eq55_lambda0 q -> eq53_sides_1 (eq53_k q) l < eq53_sides_2 (eq53_k q) l ->
  eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l) -> right_anisotropic_e_sides_1 l (q * l) < right_anisotropic_e_sides_2 l (q * l) ->
  exists e e' W, PI + asin (q * l) < e < 2 * PI - asin (q * l) /\ 2 * PI - asin (q * l) < e' < 2 * PI + asin l /\ steady l (q * l) W /\ reached l (q * l) W /\
  (forall t, asin l < t < e -> 0 < W t) /\ (forall t, e < t < e' -> W t < 0) /\ (forall t, e' <= t <= 2 * PI + asin l -> W t = 0).
Proof.
  unfold eq55_lambda0, eq54_sides_1, eq54_sides_2, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. intros hq h0 h1 hA hB hE. apply Rlt_div_r in h1; [ | lra ].
  assert (hm : 0 < q * l < 1) by nra. assert (hl : 0 < l < 1) by nra. destruct (K_facts q hq) as [k kq]. set (K := eq53_k q) in *.
  destruct (fwd_end l hl) as (e & He & z & P). destruct (p1_range l hl) as [[a b] ea]. destruct (p1_range (q * l) hm) as [[a' b'] eb].
  rewrite <- !cos_asin_pow in hB, hE by lra. pose proof PI_RGT_0 as pi0.
  assert (e1 : PI + asin (q * l) < e). { apply Rnot_le_lt. intros k1. assert (F : 0 < fwd l (asin l) (PI + asin (q * l))) by (unfold fwd; rewrite Rplus_comm, neg_cos; lra).
    destruct k1 as [k1 | k1]; [ | rewrite <- k1 in F; lra ]. destruct (Rle_lt_dec (PI + asin (q * l)) (2 * PI + asin l)). pose proof (fwd_falls l hl (asin l) e (PI + asin (q * l))). lra. lra. }
  assert (e2 : e < 2 * PI - asin (q * l)). { apply Rnot_le_lt. intros k1. assert (F : fwd l (asin l) (2 * PI - asin (q * l)) < 0).
    { unfold fwd. replace (cos (2 * PI - asin (q * l))) with (cos (asin (q * l))) by (rewrite <- (cos_neg (asin (q * l))), <- (cos_period (- asin (q * l)) 1); f_equal; simpl; ring). lra. }
    destruct k1 as [k1 | k1]; [ | rewrite k1 in F; lra ]. specialize (P (2 * PI - asin (q * l)) ltac:(lra)). lra. }
  assert (short : e - asin l < 2 * K).
  { apply Rnot_le_lt. intros k1. set (L := (e - asin l) / 2). assert (hL : K <= L < PI) by (unfold L; lra). pose proof (slip_side l L hl ltac:(lra)) as E. 
    replace (asin l + 2 * L) with e in E by (unfold L; field). specialize (E z). pose proof (side_A_grows l K L ltac:(lra) ltac:(lra)). unfold eq53_sides_1 in *. lra. }
  set (m := q * l) in *. set (al := asin l) in *. set (be := asin m) in *.
  assert (c1 : bwd m e (2 * PI - be) < 0). { rewrite bwd_fwd. enough (fwd m (e - PI) (e - PI) < fwd m (e - PI) (2 * PI - be - PI)) as Q by (unfold fwd in Q at 1; lra). apply fwd_rises; fold be; lra. }
  assert (c2 : 0 < bwd m e (2 * PI + al)).
  { unfold bwd. replace (cos (2 * PI + al)) with (cos al) by (rewrite <- (cos_period al 1); f_equal; simpl; ring). unfold fwd in z.
    assert (q * (2 * K) < q * (2 * PI + al - e) + q * (2 * K) - 2 * K); [ | unfold m; nra ]. assert (q * (e - al) < q * (2 * K)) by nra. nra. }
  destruct (IVT_cor (bwd m e) (2 * PI - be) (2 * PI + al)) as [e' [He' z']]; [ intros x; apply bwd_cont | lra | nra | ].
  assert (e' <> 2 * PI - be) by (intros ->; lra). assert (e' <> 2 * PI + al) by (intros ->; lra).
  assert (Q : forall t, e < t < e' -> bwd m e t < 0).
  { intros t Ht. rewrite bwd_fwd. rewrite bwd_fwd in z'. pose proof (fwd_pos m hm (e - PI) (e' - PI)) as F. fold be in F. specialize (F ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) (t - PI) ltac:(lra)). lra. }
  pose (g := glue e (fwd l al) (glue e' (bwd m e) (fun _ => 0))).
  assert (G1 : forall t, t < e -> g t = fwd l al t) by (intros t k1; unfold g, glue; destruct (Rlt_dec t e); [ trivial | lra ]).
  assert (G3 : forall t, e <= t < e' -> g t = bwd m e t) by (intros t k1; unfold g, glue; destruct (Rlt_dec t e); [ lra | ]; destruct (Rlt_dec t e'); [ trivial | lra ]).
  assert (G4 : forall t, e' <= t -> g t = 0) by (intros t k1; unfold g, glue; destruct (Rlt_dec t e); [ lra | ]; destruct (Rlt_dec t e'); [ lra | trivial ]).
  assert (low : forall t, 2 * PI - be <= t <= 2 * PI + al -> - m <= sin t). { intros t Ht. rewrite <- sin_2PI, <- eb, <- sin_neg. apply sin_incr_1; lra. }
  assert (A : arc l m sin al (al + 2 * PI) g).
  { apply arc_glue; [ lra | | apply arc_glue; [ lra | | | trivial ] | ].
    - apply arc_fwd; try lra. intros t Ht. destruct (Req_dec t al) as [-> | ]. unfold fwd; lra. left; apply P; lra.
    - apply arc_bwd; try lra. intros t Ht. destruct (Req_dec t e) as [-> | ]. unfold bwd; lra. left; apply Q; lra.
    - apply arc_rest; try lra. intros t Ht. split. apply low; lra. left. apply sin_less; trivial. fold al. lra.
    - rewrite z. unfold glue. destruct (Rlt_dec e e'); [ unfold bwd; ring | trivial ]. }
  assert (G : g (al + 2 * PI) = g al). { rewrite G4, G1 by lra. unfold fwd; ring. }
  assert (S : forall t, sin (t + 2 * PI) = sin t) by (intros t; rewrite <- (sin_2PI (t + 2 * PI)); f_equal; ring).
  set (W := per al (2 * PI) g). assert (hT : 0 < 2 * PI) by lra.
  assert (L : forall t0, line l m sin t0 W) by (apply per_line; trivial).
  assert (R : forall t, W (t + 2 * PI) = W t) by (intros t; apply per_per; trivial).
  assert (on : forall t, al <= t < al + 2 * PI -> W t = g t).
  { intros t Ht. unfold W. rewrite (per_on al (2 * PI) g hT 0) by (simpl; lra). f_equal. ring. }
  assert (Z : forall t, e' <= t <= 2 * PI + al -> W t = 0).
  { intros t Ht. destruct (Req_dec t (2 * PI + al)) as [-> | ne]; [ | rewrite on, G4 by lra; trivial ]. rewrite Rplus_comm, R, on, G1 by lra. unfold fwd; ring. }
  exists e, e', W. split; [ lra | split; [ lra | split; [ split; trivial | split; [ | split; [ | split; [ | trivial ] ] ] ] ] ].
  - intros t0 w Hw. set (r := (e' + (2 * PI + al)) / 2). assert (hr : e' < r < 2 * PI + al) by (unfold r; lra). clearbody r.
    apply (captured l m (2 * PI) r (2 * PI + al) sin W); trivial; try lra.
    + intros t Ht. apply Z; lra.
    + split. rewrite <- sin_2PI, <- eb, <- sin_neg. apply sin_increasing_1; lra. apply sin_less; trivial. fold al. lra.
    + apply derivable_continuous_pt, derivable_pt_sin.
  - intros t Ht. rewrite on, G1 by lra. apply P; lra.
  - intros t Ht. rewrite on, G3 by lra. apply Q; lra.
Qed.
