(* 2.4: the curves A, B, C and E for every q >= 1: each has one point at most, in which order they lie, the point Y where
   B and E end on C; and what the motion at large times does on either side of each. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion HalfPeriod Drawn Line Slips Regions Formulas.
Open Scope R_scope.

(* ---- A ---- *)
Lemma A_falls k a b : 0 < a < b -> b <= 1 -> eq53_sides_1 k b < eq53_sides_1 k a.
Proof.
  intros h1 h2. unfold eq53_sides_1. assert (0 < sqrt (1 - a ^ 2)) by (apply sqrt_lt_R0; nra). assert (sqrt (1 - b ^ 2) <= sqrt (1 - a ^ 2)) by (apply sqrt_le_1_alt; nra).
  set (u := sqrt (1 - a ^ 2)) in *. pose proof (sqrt_pos (1 - b ^ 2)). set (v := sqrt (1 - b ^ 2)) in *. apply (Rmult_lt_reg_r (a * b)); [ nra | ].
  replace (v / b * (a * b)) with (v * a) by (field; lra). replace (u / a * (a * b)) with (u * b) by (field; lra). nra.
Qed.
Lemma A_exists q : 1 <= q -> exists a, 0 < a < 1 /\ on_A q a.
Proof.
  intros hq. unfold on_A, eq53_sides_1. change (eq53_sides_2 (K q)) with (fun _ : R => eq53_sides_2 (K q) 0). cbv beta. pose proof (side_A_pos q 0 hq) as hr. set (r := eq53_sides_2 (K q) 0) in *.
  assert (S : 0 < sqrt (1 + r ^ 2)) by (apply sqrt_lt_R0; nra). assert (S2 : sqrt (1 + r ^ 2) ^ 2 = 1 + r ^ 2) by (apply pow2_sqrt; nra). set (s := sqrt (1 + r ^ 2)) in *.
  assert (s1 : 1 < s) by nra. exists (/ s). assert (i : 0 < / s < 1) by (split; [ now apply Rinv_0_lt_compat | rewrite <- Rinv_1; apply Rinv_lt_contravar; lra ]). split; trivial.
  replace (1 - (/ s) ^ 2) with (Rsqr (r / s)). rewrite sqrt_Rsqr. field; lra. apply Rlt_le, Rdiv_lt_0_compat; trivial.
  unfold Rsqr. apply (Rmult_eq_reg_r (s ^ 2)); [ | nra ]. transitivity (r ^ 2). field; lra. transitivity (s ^ 2 - 1). lra. field. lra.
Qed.
Lemma A_sides q a l : 1 <= q -> 0 < a <= 1 -> on_A q a -> 0 < l -> (below_A q l <-> l < a) /\ (above_A q l <-> a < l).
Proof.
  intros hq ha A hl. unfold below_A, above_A, on_A in *. change (eq53_sides_2 (K q) a) with (eq53_sides_2 (K q) l) in A. pose proof (side_A_pos q l hq) as P.
  destruct (Rle_lt_dec l 1) as [k | k].
  - destruct (total_order_T l a) as [[c | ->] | c]; [ pose proof (A_falls (K q) l a) | | pose proof (A_falls (K q) a l) ]; lra.
  - enough (eq53_sides_1 (K q) l = 0) by lra. unfold eq53_sides_1. rewrite sqrt_neg_0 by nra. unfold Rdiv. ring.
Qed.
(* a point of A lies below C, below E, and below B if q > 1 *)
Lemma A_order q l : 1 <= q -> 0 < l -> on_A q l -> l < 1 /\ q * l < 1 /\ below_E q l /\ ~ above_B q l /\ (1 < q -> below_B q l).
Proof.
  intros hq h0 A. assert (N : ~ above_A q l) by (unfold above_A, on_A in *; lra). pose proof (not_above_A q l hq h0 N) as l1.
  destruct (region_1 q l hq h0 N) as (W & _ & _ & _ & _ & _ & _ & m1 & _). assert (hm : 0 < q * l < 1) by nra. assert (hl : 0 < l < 1) by lra.
  destruct (fwd_end l hl) as (e & He). pose proof He as (He1 & z & _). destruct (asin_range l hl) as [[a0 ab] _]. destruct (al_be q l hq hl hm) as [[_ a1] b].
  destruct (shorter_A q l e hq hl ltac:(lra) z) as [_ E]. apply E in A. clear E. destruct (K_facts q hq) as (hk & _ & _). pose proof PI_RGT_0.
  assert (e1 : e = asin l + 2 * K q) by lra. rewrite e1 in z. destruct (slip_side l (K q) hl ltac:(lra) z) as [_ S].
  destruct (box l q hq h0 N (asin l + K q) ltac:(lra) S) as (_ & p2 & _ & p4). replace (asin l + K q + K q) with e in * by lra.
  replace (- sin e) with (sin (e - PI)) in * by (rewrite sin_minus, cos_PI, sin_PI; ring).
  destruct (between_asin (q * l) (e - PI) hm ltac:(lra)) as [b1 b2]. specialize (b1 p2). destruct (where_B_E q l hq hl hm e He) as (B1 & B2 & E).
  assert (hE : e < 2 * PI - asin (q * l)). { destruct (Req_dec q 1) as [-> | n]; [ | specialize (b2 (p4 ltac:(lra))); lra ]. unfold eq53_k in e1. rewrite Rmult_1_l in *. replace (PI * 1 / (1 + 1)) with (PI / 2) in e1 by field. lra. }
  rewrite B1, B2, E. split; [ trivial | split; [ trivial | split; [ trivial | split; [ lra | ] ] ] ]. intros h. specialize (b2 (p4 h)). lra.
Qed.

(* ---- B and E: over lambda0, the velocity that decides falls, or grows, with lambda0 ---- *)
Lemma asin_closed l : 0 < l <= 1 -> 0 < asin l <= PI / 2 /\ sin (asin l) = l.
Proof.
  intros [h [k | ->]]; [ destruct (asin_range l); lra | ]. rewrite asin_1, sin_PI2. pose proof PI_RGT_0. lra.
Qed.
Lemma asin_up a b : 0 < a < b -> b <= 1 -> asin a < asin b.
Proof.
  intros h1 h2. destruct (asin_closed a ltac:(lra)) as [[a0 a1] ea]. destruct (asin_closed b ltac:(lra)) as [[b0 b1] eb]. apply Rnot_le_lt. intros k.
  pose proof PI_RGT_0. pose proof (sin_incr_1 (asin b) (asin a)). lra.
Qed.
Lemma cot_falls a b : 0 < a < b -> b <= PI / 2 -> cot b + b < cot a + a.
Proof.
  intros h1 h2. apply Ropp_lt_cancel. unfold cot. pose proof PI_RGT_0. assert (P : forall c, a <= c <= b -> 0 < sin c) by (intros; apply sin_gt_0; lra).
  apply (up (fun x => - (cos x / sin x + x)) (fun x => (cos x / sin x) ^ 2)); [ lra | | ].
  - intros c Hc. specialize (P c Hc). pose proof (sin2_cos2 c) as I. rewrite !Rsqr_pow2 in I. auto_derive; [ lra | ]. field_simplify_eq; [ | lra ]. nra.
  - intros c Hc. specialize (P c ltac:(lra)). assert (0 < cos c) by (apply cos_gt_0; lra). apply pow_lt, Rdiv_lt_0_compat; trivial.
Qed.
Lemma B_over q l : 0 < l <= 1 -> 0 < q * l <= 1 -> arc_B q l / l = (cot (asin l) + asin l) + q * cot (asin (q * l)) - asin (q * l) - PI.
Proof.
  intros h1 h2. destruct (asin_closed l h1) as [_ e]. destruct (asin_closed (q * l) h2) as [_ e']. unfold arc_B, fwd, cot. rewrite e, e', Rplus_comm, neg_cos. field. split; nra.
Qed.
Lemma B_falls q a b : 1 <= q -> 0 < a < b -> q * b <= 1 -> arc_B q b / b < arc_B q a / a.
Proof.
  intros hq h1 h2. assert (q * a < q * b) by nra. assert (b <= 1) by nra. assert (0 < q * a) by nra. rewrite !B_over by lra. destruct (asin_closed a ltac:(lra)). destruct (asin_closed (q * a) ltac:(lra)).
  pose proof (cot_falls (asin a) (asin b)) as c1. pose proof (cot_falls (asin (q * a)) (asin (q * b))) as c2. pose proof (asin_up a b ltac:(lra) ltac:(lra)). pose proof (asin_up (q * a) (q * b) ltac:(lra) ltac:(lra)).
  destruct (asin_closed b ltac:(lra)). destruct (asin_closed (q * b) ltac:(lra)). specialize (c1 ltac:(lra) ltac:(lra)). specialize (c2 ltac:(lra) ltac:(lra)). nra.
Qed.
Lemma E_over q l : 1 < q -> 0 < l -> q * l <= 1 -> arc_E q l / l = (q ^ 2 - 1) * (l / (cos (asin l) + cos (asin (q * l)))) + asin l + asin (q * l) - 2 * PI /\ 0 < cos (asin l) /\ 0 <= cos (asin (q * l)).
Proof.
  intros hq h1 h2. assert (hl : 0 < l < 1) by nra. assert (hm : 0 < q * l <= 1) by nra. destruct (asin_range l hl) as [[a b] e]. destruct (asin_closed (q * l) hm) as [[a' b'] e'].
  assert (c1 : 0 < cos (asin l)) by (apply cos_gt_0; lra). assert (c2 : 0 <= cos (asin (q * l))) by (apply cos_ge_0; lra). split; [ | split; trivial ].
  pose proof (sin2_cos2 (asin l)) as I. rewrite !Rsqr_pow2, e in I. pose proof (sin2_cos2 (asin (q * l))) as J. rewrite !Rsqr_pow2, e' in J.
  unfold arc_E, fwd. replace (2 * PI - asin (q * l)) with (- asin (q * l) + 2 * PI) by ring. rewrite cos_per, cos_neg. field_simplify_eq; [ | lra ].
  replace (cos (asin l) ^ 2) with (1 - l ^ 2) by lra. replace (cos (asin (q * l)) ^ 2) with (1 - (q * l) ^ 2) by lra. ring.
Qed.
Lemma E_grows q a b : 1 < q -> 0 < a < b -> q * b <= 1 -> arc_E q a / a < arc_E q b / b.
Proof.
  intros hq h1 h2. assert (q * a < q * b) by nra. assert (b < 1) by nra. assert (0 < q * a) by nra. destruct (E_over q a hq) as (-> & a1 & a2); try lra. destruct (E_over q b hq) as (-> & b1 & b2); try lra.
  pose proof (asin_up a b ltac:(lra) ltac:(lra)). pose proof (asin_up (q * a) (q * b) ltac:(lra) ltac:(lra)). destruct (asin_closed a ltac:(lra)). destruct (asin_closed (q * a) ltac:(lra)).
  destruct (asin_closed b ltac:(lra)). destruct (asin_closed (q * b) ltac:(lra)).
  assert (c1 : cos (asin b) <= cos (asin a)) by (apply cos_decr_1; lra). assert (c2 : cos (asin (q * b)) <= cos (asin (q * a))) by (apply cos_decr_1; lra).
  assert (D : a / (cos (asin a) + cos (asin (q * a))) < b / (cos (asin b) + cos (asin (q * b)))); [ | assert (0 < q ^ 2 - 1) by nra; nra ].
  apply Rlt_div_l; [ lra | ]. assert (1 <= (cos (asin a) + cos (asin (q * a))) / (cos (asin b) + cos (asin (q * b)))) by (apply Rle_div_r; lra).
  replace (b / (cos (asin b) + cos (asin (q * b))) * (cos (asin a) + cos (asin (q * a)))) with (b * ((cos (asin a) + cos (asin (q * a))) / (cos (asin b) + cos (asin (q * b))))) by (field; lra). nra.
Qed.
Lemma B_sign q l : 1 <= q -> 0 < l -> q * l <= 1 -> (below_B q l <-> 0 < arc_B q l / l) /\ (above_B q l <-> arc_B q l / l < 0) /\ (on_B q l <-> arc_B q l / l = 0).
Proof.
  intros hq h1 h2. assert (0 < q * l) by nra. assert (l <= 1) by nra. assert (e : arc_B q l = arc_B q l / l * l) by (field; lra). rewrite arc_B_is in e at 1 by lra.
  unfold below_B, above_B, on_B. set (x := arc_B q l / l) in *. repeat split; intros; nra.
Qed.
Lemma E_sign q l : 1 <= q -> 0 < l -> q * l <= 1 -> (above_E q l <-> 0 < arc_E q l / l) /\ (below_E q l <-> arc_E q l / l < 0) /\ (on_E q l <-> arc_E q l / l = 0).
Proof.
  intros hq h1 h2. assert (0 < q * l) by nra. assert (l <= 1) by nra. assert (e : arc_E q l = arc_E q l / l * l) by (field; lra). rewrite arc_E_is in e at 1 by lra.
  unfold below_E, above_E, on_E. set (x := arc_E q l / l) in *. repeat split; intros; nra.
Qed.

(* ---- Y: where both end on C. x is the length of the slip there, the least positive root of tan x = x ---- *)
Definition is_Y (x : R) : Prop := PI < x < 3 * PI / 2 /\ tan x = x.
Notation q_Y := right_anisotropic_y_from_root_1.
Lemma Y_sine x : PI < x < 3 * PI / 2 -> (tan x = x <-> sin x - x * cos x = 0).
Proof.
  intros h. assert (cos x < 0) by (apply cos_lt_0; lra). unfold tan. split; intros e.
  - rewrite <- e at 2. field. lra.
  - apply (Rmult_eq_reg_r (cos x)); [ | lra ]. replace (sin x / cos x * cos x) with (sin x) by (field; lra). lra.
Qed.
Lemma Y_exists : exists x, is_Y x /\ 4.4926 < x < 4.4935.
Proof.
  assert (S : 4.4926 * cos 4.4926 - sin 4.4926 < 0 /\ 0 < 4.4935 * cos 4.4935 - sin 4.4935) by (split; interval with (i_prec 60)).
  destruct (IVT_cor (fun x => x * cos x - sin x) 4.4926 4.4935) as [x [h z]].
  - intros x. apply derivable_continuous_pt. reg.
  - lra.
  - nra.
  - assert (B : PI < 4.4926 /\ 4.4935 < 3 * PI / 2) by (split; interval with (i_prec 60)).
    assert (N : x <> 4.4926 /\ x <> 4.4935) by (split; intros ->; lra). exists x. split; [ split; [ lra | apply Y_sine; lra ] | lra ].
Qed.
Lemma Y_unique x y : is_Y x -> is_Y y -> x = y.
Proof.
  assert (P : forall x y, is_Y x -> is_Y y -> ~ x < y).
  { intros a b [ha ea] [hb eb] k. apply Y_sine in ea; trivial. apply Y_sine in eb; trivial.
    pose proof (up (fun x => - (sin x - x * cos x)) (fun x => - (x * sin x)) a b k) as U. cbv beta in U. rewrite ea, eb in U. enough (- 0 < - 0) by lra. apply U.
    - intros c _. auto_derive; trivial; ring.
    - intros c Hc. assert (sin c < 0) by (apply sin_lt_0; lra). nra. }
  intros X Y. destruct (total_order_T x y) as [[k | k] | k]; trivial; exfalso; revert k; now apply P.
Qed.
Lemma Y_facts x : is_Y x -> 3 < q_Y x /\ q_Y x ^ 2 = 1 + x ^ 2 /\ asin (1 / q_Y x) = 3 * PI / 2 - x /\ cot (3 * PI / 2 - x) = x.
Proof.
  intros [h e]. pose proof PI2_3_2. apply Y_sine in e; trivial. assert (c0 : cos x < 0) by (apply cos_lt_0; lra). pose proof (sin2_cos2 x) as I. rewrite !Rsqr_pow2 in I.
  unfold q_Y. assert (s : 0 < sqrt (1 + x ^ 2)) by (apply sqrt_lt_R0; nra). assert (s2 : sqrt (1 + x ^ 2) ^ 2 = 1 + x ^ 2) by (apply pow2_sqrt; nra). set (r := sqrt (1 + x ^ 2)) in *.
  assert (c : - cos x * r = 1). { apply Rsqr_inj; [ nra | lra | ]. rewrite !Rsqr_pow2, Rpow_mult_distr, s2. replace (sin x) with (x * cos x) in I by lra. lra. }
  assert (s3 : sin (3 * PI / 2 - x) = - cos x) by (rewrite sin_minus; replace (3 * PI / 2) with (3 * (PI / 2)) by field; rewrite sin_3PI2, cos_3PI2; ring).
  assert (c3 : cos (3 * PI / 2 - x) = - sin x) by (rewrite cos_minus; replace (3 * PI / 2) with (3 * (PI / 2)) by field; rewrite sin_3PI2, cos_3PI2; ring).
  split; [ nra | split; [ trivial | split ] ].
  - replace (1 / r) with (- cos x) by (rewrite <- c; field; lra). rewrite <- s3. apply asin_sin. lra.
  - unfold cot. rewrite s3, c3. replace (sin x) with (x * cos x) by lra. field. lra.
Qed.
Lemma corner x q : is_Y x -> 1 <= q -> arc_E q (1 / q) = arc_B q (1 / q) /\ (arc_B q (1 / q) / (1 / q) < 0 <-> q < q_Y x) /\ (0 < arc_B q (1 / q) / (1 / q) <-> q_Y x < q) /\ (arc_B q (1 / q) / (1 / q) = 0 <-> q = q_Y x).
Proof.
  intros Y hq. destruct (Y_facts x Y) as (y3 & _ & yA & yc). split.
  - unfold arc_E, arc_B. replace (q * (1 / q)) with 1 by (field; lra). rewrite asin_1. f_equal. field.
  - assert (P : forall q, 1 <= q -> 0 < 1 / q <= 1 /\ arc_B q (1 / q) / (1 / q) = cot (asin (1 / q)) + asin (1 / q) - 3 * PI / 2).
    { clear q hq. intros q hq. assert (i : 0 < 1 / q <= 1) by (split; [ apply Rdiv_lt_0_compat | apply Rle_div_l ]; lra). split; trivial.
      rewrite B_over; replace (q * (1 / q)) with 1 by (field; lra); try lra. rewrite asin_1. unfold cot at 2. rewrite cos_PI2, sin_PI2. field. }
    destruct (P q hq) as [i ->]. destruct (P (q_Y x) ltac:(lra)) as [j _].
    assert (Z : cot (asin (1 / q_Y x)) + asin (1 / q_Y x) - 3 * PI / 2 = 0) by (rewrite yA, yc; ring).
    assert (M : forall a b, 1 <= a < b -> 1 / b < 1 / a) by (intros a b hab; unfold Rdiv; rewrite !Rmult_1_l; apply Rinv_lt_contravar; nra).
    destruct (asin_closed (1 / q) i) as [? _]. destruct (asin_closed (1 / q_Y x) j) as [? _].
    destruct (total_order_T q (q_Y x)) as [[k | ->] | k]; [ | repeat split; lra | ].
    + pose proof (asin_up _ _ (conj (proj1 j) (M q (q_Y x) ltac:(lra))) (proj2 i)). pose proof (cot_falls (asin (1 / q_Y x)) (asin (1 / q)) ltac:(lra) ltac:(lra)). repeat split; lra.
    + pose proof (asin_up _ _ (conj (proj1 i) (M (q_Y x) q ltac:(lra))) (proj2 j)). pose proof (cot_falls (asin (1 / q)) (asin (1 / q_Y x)) ltac:(lra) ltac:(lra)). repeat split; lra.
Qed.
(* up to Y nothing below C is above E, beyond Y everything below C is below B *)
Lemma below_C_E x q l : is_Y x -> 1 <= q <= q_Y x -> 0 < l -> q * l < 1 -> below_E q l.
Proof.
  intros Y hq h0 h1. apply E_sign; try lra. destruct (Req_dec q 1) as [-> | n].
  - rewrite Rmult_1_l in *. destruct (asin_range l ltac:(lra)) as [[a b] _]. unfold arc_E, fwd. rewrite Rmult_1_l. replace (2 * PI - asin l) with (- asin l + 2 * PI) at 1 by ring.
    rewrite cos_per, cos_neg. replace ((cos (asin l) - cos (asin l) - l * (2 * PI - asin l - asin l)) / l) with (2 * asin l - 2 * PI) by (field; lra). pose proof PI_RGT_0. lra.
  - destruct (corner x q Y ltac:(lra)) as (e & c1 & c2 & c3). rewrite <- e in *. apply Rlt_le_trans with (arc_E q (1 / q) / (1 / q)).
    + apply E_grows; [ lra | split; [ trivial | apply Rlt_div_r; lra ] | right; field; lra ].
    + destruct (Req_dec q (q_Y x)) as [k | k]; [ apply c3 in k; lra | left; apply c1; lra ].
Qed.
Lemma below_C_B x q l : is_Y x -> q_Y x <= q -> 0 < l -> q * l < 1 -> below_B q l.
Proof.
  intros Y hq h0 h1. destruct (Y_facts x Y) as (y3 & _). apply B_sign; try lra. destruct (corner x q Y ltac:(lra)) as (e & c1 & c2 & c3).
  apply Rle_lt_trans with (arc_B q (1 / q) / (1 / q)).
  - destruct (Req_dec q (q_Y x)) as [k | k]; [ apply c3 in k; lra | left; apply c2; lra ].
  - apply B_falls; [ lra | split; [ trivial | apply Rlt_div_r; lra ] | right; field; lra ].
Qed.
(* the roots, by the angle be = asin (q lambda0) *)
Lemma alpha_cont q b : 1 < q -> continuity_pt (fun b => asin (sin b / q)) b.
Proof.
  intros hq. apply (continuity_pt_comp (fun b => sin b / q) asin). apply derivable_continuous_pt. reg; lra.
  apply derivable_continuous_pt, derivable_pt_asin. pose proof (SIN_bound b). split; [ apply Rlt_div_r | apply Rlt_div_l ]; lra.
Qed.
Lemma arc_cont q (c : R -> R) : 1 < q -> (forall b, continuity_pt c b) -> forall b, continuity_pt (fun b => fwd (sin b / q) (asin (sin b / q)) (c b)) b.
Proof.
  intros hq C b. pose proof (alpha_cont q b hq) as A. assert (S : continuity_pt (fun b => sin b / q) b) by (apply derivable_continuous_pt; reg; lra).
  unfold fwd. apply (continuity_pt_minus (fun b => cos (asin (sin b / q)) - cos (c b)) (fun b => sin b / q * (c b - asin (sin b / q)))).
  - apply (continuity_pt_minus (fun b => cos (asin (sin b / q))) (fun b => cos (c b))).
    + apply (continuity_pt_comp (fun b => asin (sin b / q)) cos); [ trivial | apply continuity_cos ].
    + apply (continuity_pt_comp c cos); [ apply C | apply continuity_cos ].
  - apply (continuity_pt_mult (fun b => sin b / q) (fun b => c b - asin (sin b / q))); trivial. now apply (continuity_pt_minus c (fun b => asin (sin b / q))).
Qed.
Lemma root_between q l1 (c : R -> R) : let F l := fwd l (asin l) (c (asin (q * l))) in 1 < q -> 0 < l1 -> q * l1 < 1 -> (forall b, continuity_pt c b) ->
  F l1 < 0 < F (1 / q) \/ F (1 / q) < 0 < F l1 -> exists l, l1 < l < 1 / q /\ F l = 0.
Proof.
  intros F hq h1 h2 C S. destruct (asin_range (q * l1) ltac:(nra)) as [[a b] e]. set (G b := fwd (sin b / q) (asin (sin b / q)) (c b)).
  assert (FG : forall z, asin (q * l1) <= z <= PI / 2 -> G z = F (sin z / q)).
  { intros z hz. unfold F, G. replace (q * (sin z / q)) with (sin z) by (field; lra). rewrite asin_sin; trivial. lra. }
  assert (e1 : G (asin (q * l1)) = F l1) by (rewrite FG, e by lra; f_equal; field; lra). assert (e2 : G (PI / 2) = F (1 / q)) by (rewrite FG, sin_PI2 by lra; trivial).
  assert (R : exists z, asin (q * l1) <= z <= PI / 2 /\ G z = 0).
  { pose proof (arc_cont q c hq C) as GC. destruct S as [S | S].
    - destruct (Ranalysis5.IVT_interv G (asin (q * l1)) (PI / 2)) as [z Hz]; [ intros; apply GC | lra | lra | lra | exists z; exact Hz ].
    - destruct (Ranalysis5.IVT_interv (fun b => - G b) (asin (q * l1)) (PI / 2)) as [z [Hz z0]]; [ intros; apply (continuity_pt_opp G), GC | lra | lra | lra | exists z; split; lra ]. }
  destruct R as (z & hz & z0). assert (z <> asin (q * l1)) by (intros ->; lra). assert (z <> PI / 2) by (intros ->; lra).
  exists (sin z / q). rewrite <- FG by lra. split; [ | trivial ]. split; [ replace l1 with (sin (asin (q * l1)) / q) by (rewrite e; field; lra) | rewrite <- sin_PI2 ];
    (apply Rmult_lt_compat_r; [ apply Rinv_0_lt_compat; lra | apply sin_increasing_1; lra ]).
Qed.
(* for q > 1: A lies below C, and so does B, above A, up to Y, or E, above A, from Y on *)
Lemma B_exists x q a : is_Y x -> 1 < q < q_Y x -> 0 < a -> on_A q a -> exists b, a < b < 1 / q /\ on_B q b.
Proof.
  intros Y hq ha A. destruct (A_order q a ltac:(lra) ltac:(lra) A) as (_ & qa & _ & _ & AB). specialize (AB ltac:(lra)). destruct (corner x q Y ltac:(lra)) as (_ & c1 & _).
  assert (i : 0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). pose proof (proj2 c1 ltac:(lra)) as c2. 
  destruct (root_between q a (fun b => PI + b)) as (b & hb & z); try lra; [ intros; cont | right | ].
  - apply B_sign in AB; try lra. fold (arc_B q (1 / q)) (arc_B q a). unfold Rdiv in c2, AB. split; [ | ]; [ apply (Rmult_lt_reg_r (/ (1 / q))) | apply (Rmult_lt_reg_r (/ a)) ]; try (apply Rinv_0_lt_compat; lra); lra.
  - exists b. split; trivial. apply B_sign; try lra. apply Rlt_le. destruct hb as [_ hb]. apply (Rmult_lt_compat_l q) in hb; [ | lra ]. replace (q * (1 / q)) with 1 in hb by (field; lra). trivial.
    fold (arc_B q b) in z. rewrite z. unfold Rdiv. ring.
Qed.
Lemma E_exists x q a : is_Y x -> q_Y x < q -> 0 < a -> on_A q a -> exists b, a < b < 1 / q /\ on_E q b.
Proof.
  intros Y hq ha A. destruct (Y_facts x Y) as (y3 & _). destruct (A_order q a ltac:(lra) ltac:(lra) A) as (_ & qa & AE & _). destruct (corner x q Y ltac:(lra)) as (e & _ & c1 & _).
  assert (i : 0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). pose proof (proj2 c1 ltac:(lra)) as c2. rewrite <- e in c2.
  destruct (root_between q a (fun b => 2 * PI - b)) as (b & hb & z); try lra; [ intros; cont | left | ].
  - apply E_sign in AE; try lra. fold (arc_E q (1 / q)) (arc_E q a). unfold Rdiv in c2, AE. split; [ | ]; [ apply (Rmult_lt_reg_r (/ a)) | apply (Rmult_lt_reg_r (/ (1 / q))) ]; try (apply Rinv_0_lt_compat; lra); lra.
  - exists b. split; trivial. apply E_sign; try lra. apply Rlt_le. destruct hb as [_ hb]. apply (Rmult_lt_compat_l q) in hb; [ | lra ]. replace (q * (1 / q)) with 1 in hb by (field; lra). trivial.
    fold (arc_E q b) in z. rewrite z. unfold Rdiv. ring.
Qed.
Lemma B_sides q b l : 1 <= q -> 0 < b -> q * b <= 1 -> on_B q b -> 0 < l -> q * l <= 1 -> (below_B q l <-> l < b) /\ (above_B q l <-> b < l).
Proof.
  intros hq h1 h2 B h3 h4. destruct (B_sign q l hq h3 h4) as (-> & -> & _). apply B_sign in B; trivial.
  destruct (total_order_T l b) as [[k | ->] | k]; [ pose proof (B_falls q l b hq) | | pose proof (B_falls q b l hq) ]; split; split; intros; lra.
Qed.
Lemma E_sides q b l : 1 < q -> 0 < b -> q * b <= 1 -> on_E q b -> 0 < l -> q * l <= 1 -> (below_E q l <-> l < b) /\ (above_E q l <-> b < l).
Proof.
  intros hq h1 h2 B h3 h4. destruct (E_sign q l ltac:(lra) h3 h4) as (-> & -> & _). apply E_sign in B; try lra.
  destruct (total_order_T l b) as [[k | ->] | k]; [ pose proof (E_grows q l b hq) | | pose proof (E_grows q b l hq) ]; split; split; intros; lra.
Qed.
(* at q = 1 both A and B are at lambda_c *)
Lemma at_lambda_c l : 0 < l <= 1 -> (sqrt (1 - l ^ 2) = l * (PI / 2) <-> l = eq57_x_2).
Proof.
  intros hl. unfold eq57_x_2. pose proof PI_RGT_0. assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra). assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (apply pow2_sqrt; nra).
  assert (Q : 0 <= sqrt (1 - l ^ 2)) by apply sqrt_pos. assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (apply pow2_sqrt; nra). set (r := sqrt (4 + PI ^ 2)) in *. set (s := sqrt (1 - l ^ 2)) in *.
  assert (K : (l * r) ^ 2 = l ^ 2 * (4 + PI ^ 2)) by (rewrite <- S2; ring). split; intros E.
  - rewrite E in Q2. apply (Rmult_eq_reg_r r); [ | lra ]. replace (2 / r * r) with 2 by (field; lra). apply Rsqr_inj; [ nra | lra | rewrite !Rsqr_pow2; nra ].
  - apply Rsqr_inj; [ trivial | nra | rewrite !Rsqr_pow2, Q2 ]. assert (l * r = 2) by (rewrite E; field; lra). rewrite H0 in K. nra.
Qed.
Lemma A_B_at_1 l : 0 < l <= 1 -> (on_A 1 l <-> l = eq57_x_2) /\ (on_B 1 l <-> l = eq57_x_2).
Proof.
  intros hl. rewrite <- (at_lambda_c l hl). unfold on_A, on_B, eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, cot.
  replace (PI * 1 / (1 + 1)) with (PI / 2) by field. rewrite sin_PI2, cos_PI2, !Rmult_1_l. split; split; intros E.
  - apply (Rmult_eq_reg_r (/ l)); [ | apply Rinv_neq_0_compat; lra ]. unfold Rdiv in E at 1. rewrite E. field. lra.
  - rewrite E. field. lra.
  - lra.
  - lra.
Qed.

(* below A and on it one is below E, and below B but at X *)
Lemma A_below q l : 1 <= q -> 0 < l -> ~ above_A q l -> l < 1 /\ q * l < 1 /\ below_E q l /\ ~ above_B q l /\ (1 < q -> below_B q l).
Proof.
  intros hq h0 N. destruct (A_exists q hq) as (a & ha & A). destruct (A_order q a hq ltac:(lra) A) as (a1 & qa & AE & AB & AB'). destruct (A_sides q a l hq ltac:(lra) A h0) as [_ S]. rewrite S in N.
  destruct (Req_dec l a) as [-> | n]; [ repeat split; trivial; lra | ]. assert (la : l < a) by lra. assert (ql : q * l < q * a) by (apply Rmult_lt_compat_l; lra).
  destruct (B_sign q l hq h0 ltac:(lra)) as (B1 & B2 & _). destruct (B_sign q a hq ltac:(lra) ltac:(lra)) as (_ & B3 & _). rewrite B3 in AB. pose proof (B_falls q l a hq ltac:(lra) ltac:(lra)).
  rewrite B1, B2. split; [ lra | split; [ lra | split; [ | split; [ | intros ]; lra ] ] ]. destruct (Req_dec q 1) as [-> | q1].
  - destruct Y_exists as (x & Y & _). destruct (Y_facts x Y). apply (below_C_E x); trivial; lra.
  - apply E_sign in AE; try lra. apply E_sign; try lra. pose proof (E_grows q l a). lra.
Qed.

(* ---- what the motion at large times does on either side of each curve ---- *)
Lemma course_at a e b e' W t : (forall t, W (t + 2 * PI) = W t) -> course a e b e' W -> exists s, a <= s < a + 2 * PI /\ W s = W t /\ forall d, W (s + d) = W (t + d).
Proof.
  intros P _. pose proof PI_RGT_0. destruct (per_spec a (2 * PI) ltac:(lra) t) as [n Hn]. exists (t - IZR n * (2 * PI)). split; [ lra | split; [ now apply shift_Z | ] ].
  intros d. rewrite <- (shift_Z (2 * PI) W P n (t + d)). f_equal. ring.
Qed.
Section Behaviour.
Variables (q l : R) (W : R -> R).
Hypothesis hq : 1 <= q.
Hypothesis h0 : 0 < l.
Hypothesis HW : late_slide q l W.
Notation same H := (late_slide_unique q l _ _ H HW).
(* which region a point is in *)
Inductive place : Prop :=
  | at_I : ~ above_A q l -> place
  | at_II : 0 < l < 1 -> 0 < q * l < 1 -> above_A q l -> ~ above_B q l -> below_E q l -> place
  | at_III : 0 < l < 1 -> 0 < q * l < 1 -> above_A q l -> above_B q l -> below_E q l -> place
  | at_IV : 0 < l < 1 -> above_A q l -> 1 <= q * l \/ (q * l < 1 /\ ~ below_E q l) -> place
  | at_V : 1 <= l -> above_A q l -> place.
Lemma places : place.
Proof.
  destruct (Rlt_le_dec (eq53_sides_1 (K q) l) (eq53_sides_2 (K q) l)) as [A | A]; [ | now apply at_I, Rle_not_lt ].
  destruct (Rlt_le_dec l 1) as [h1 | h1]; [ | now apply at_V ]. destruct (Rlt_le_dec (q * l) 1) as [h2 | h2]; [ | apply at_IV; auto ].
  assert (hm : 0 < q * l) by nra. destruct (Rlt_le_dec (right_anisotropic_e_sides_1 l (q * l)) (right_anisotropic_e_sides_2 l (q * l))) as [E | E].
  - destruct (Rlt_le_dec (eq54_sides_1 l (q * l)) (eq54_sides_2 l (q * l))) as [B | B]; [ apply at_III | apply at_II ]; auto. now apply Rle_not_lt.
  - apply at_IV; auto. right. split; trivial. now apply Rle_not_lt.
Qed.
Lemma rest_where : (exists s d, 0 < d /\ forall t, s <= t <= s + d -> W t = 0) <-> above_A q l.
Proof.
  pose proof PI_RGT_0. split.
  - intros (s & d & hd & Z). destruct (Classical_Prop.classic (above_A q l)) as [ | N]; trivial. exfalso.
    destruct (region_1 q l hq h0 N) as (U & HU & C & _). rename C into Co. pose proof (same HU) as E. destruct (course_at _ _ _ _ U s (ls_per _ _ _ HU) Co) as (s' & hs & _ & sh).
    set (a := middle q l - K q) in *. set (e := middle q l + K q) in *. destruct Co as ([C1 C2] & F & _ & B & _).
    assert (Z' : forall u, 0 <= u <= d -> U (s' + u) = 0) by (intros u hu; rewrite sh, E; apply Z; lra).
    destruct (Rlt_le_dec s' e) as [k | k].
    + set (u := Rmin d (e - s') / 2). assert (0 < Rmin d (e - s')) by (apply Rmin_pos; lra). pose proof (Rmin_l d (e - s')). pose proof (Rmin_r d (e - s')).
      specialize (F (s' + u)). specialize (Z' u). unfold u in *. lra.
    + set (u := Rmin d (a + 2 * PI - s') / 2). assert (0 < Rmin d (a + 2 * PI - s')) by (apply Rmin_pos; lra). pose proof (Rmin_l d (a + 2 * PI - s')). pose proof (Rmin_r d (a + 2 * PI - s')).
      specialize (B (s' + u)). specialize (Z' u). unfold u in *. lra.
  - intros A. destruct places as [N | hl hm _ B E | hl hm _ B E | hl _ D | h1 _]; [ contradiction | | | | ].
    + destruct (region_2 q l hq hl hm A B E) as (e & e' & U & _ & _ & he & HU & _ & Co). exists e', (2 * PI + asin l - e'). split; [ lra | ]. intros t Ht. rewrite <- (same HU). apply Co. lra.
    + destruct (region_3 q l hq hl hm B) as (e & e' & U & he & he' & HU & _ & Co). exists e', (2 * PI + asin l - e'). split; [ lra | ]. intros t Ht. rewrite <- (same HU). apply Co. lra.
    + destruct (region_4 q l hq hl D) as (e & U & he & HU & _ & Co & _). exists e, (2 * PI + asin l - e). split; [ lra | ]. intros t Ht. rewrite <- (same HU). apply Co. lra.
    + exists 0, 1. split; [ lra | ]. intros t _. rewrite <- (same (proj1 (region_5 q l hq h1))). trivial.
Qed.
Lemma back_where : (exists t, W t < 0) <-> q * l < 1 /\ below_E q l.
Proof.
  pose proof PI_RGT_0. split.
  - intros [t Ht]. destruct places as [N | hl hm _ B E | hl hm _ B E | hl _ D | h1 _]; try (split; [ lra | trivial ]; fail).
    + destruct (A_below q l hq h0 N) as (_ & a & b & _). auto.
    + exfalso. destruct (region_4 q l hq hl D) as (e & U & he & HU & _ & Co & _). rewrite <- (same HU) in Ht. destruct (course_at _ _ _ _ U t (ls_per _ _ _ HU) Co) as (s & hs & es & _).
      rewrite <- es in Ht. destruct Co as (_ & F & _ & _ & Z). destruct (Req_dec s (asin l)) as [-> | n]. { rewrite <- (ls_per _ _ _ HU), Z in Ht; lra. }
      destruct (Rlt_le_dec s e); [ specialize (F s) | specialize (Z s) ]; lra.
    + exfalso. rewrite <- (same (proj1 (region_5 q l hq h1))) in Ht. lra.
  - intros [h2 E]. destruct places as [N | hl hm A B _ | hl hm _ B _ | hl _ D | h1 _].
    + destruct (region_1 q l hq h0 N) as (U & HU & ([C1 C2] & _ & _ & B & _) & _). destruct (K_facts q hq) as (k & _). eexists. rewrite <- (same HU). apply (B ((middle q l + K q + (middle q l - K q + 2 * PI)) / 2)). lra.
    + destruct (region_2 q l hq hl hm) as (e & e' & U & he & _ & he' & HU & _ & (_ & _ & _ & N & _)); trivial.
      exists ((e + e') / 2). rewrite <- (same HU). apply N. lra.
    + destruct (region_3 q l hq hl hm B) as (e & e' & U & he & he' & HU & _ & (_ & _ & _ & N & _)). exists ((PI + asin (q * l) + e') / 2). rewrite <- (same HU). apply N. lra.
    + destruct D as [D | [_ D]]; [ lra | contradiction ].
    + nra.
Qed.
(* where the drive begins to pull backward the particle still goes forward below B, and rests on B and above *)
Lemma forward_where : q * l < 1 -> (0 < W (PI + asin (q * l)) <-> below_B q l) /\ (W (PI + asin (q * l)) = 0 <-> ~ below_B q l).
Proof.
  intros h2. assert (hm : 0 < q * l < 1) by nra. assert (hl : 0 < l < 1) by nra. destruct (al_be q l hq hl hm) as [[a ab] b]. pose proof PI_RGT_0. set (be := asin (q * l)) in *.
  enough (S : (below_B q l /\ 0 < W (PI + be)) \/ (~ below_B q l /\ W (PI + be) = 0)) by (destruct S as [[S1 S2] | [S1 S2]]; repeat split; intros; first [ assumption | contradiction | exfalso; lra ]).
  destruct places as [N | _ _ A B E | _ _ _ B _ | _ _ D | h1 _]; [ | | | | lra ].
  - destruct (region_1 q l hq h0 N) as (U & HU & Co & F & a1 & a2 & e1 & _ & s1 & s2 & s3 & s4). rewrite <- (same HU). fold be in e1. set (a0 := middle q l - K q) in *. set (e := middle q l + K q) in *.
    destruct (Req_dec e (PI + be)) as [z | n].
    + assert (sm : sin e = - (q * l)) by (rewrite z, Rplus_comm, neg_sin; unfold be; destruct (asin_range (q * l) hm) as [_ ->]; ring).
      right. split; [ | rewrite <- z; apply (proj1 (proj2 (proj2 Co))); destruct Co as ([? ?] & _); lra ].
      assert (q1 : q = 1) by (destruct (Req_dec q 1); trivial; specialize (s4 ltac:(lra)); lra).
      assert (on : on_A q l). { unfold on_A. assert (~ below_A q l) by (intros bA; destruct (s3 bA); lra). unfold below_A, above_A in *. lra. }
      assert (ll : l <= 1) by lra. rewrite q1 in *. apply A_B_at_1 in on; [ | lra ]. assert (oB : on_B 1 l) by (apply A_B_at_1; lra). unfold on_B, below_B in *. lra.
    + left. split; [ | apply Co; lra ]. assert (P : 0 < U (PI + be)) by (apply Co; lra). rewrite F in P by lra.
      assert (0 < arc_B q l). { unfold arc_B. fold be. apply Rlt_le_trans with (1 := P). enough (0 <= fwd l (asin l) a0) by (unfold fwd in *; lra).
        destruct (Req_dec a0 (asin l)) as [-> | k]; [ rewrite fwd_0; lra | ]. left. rewrite <- (fwd_0 l (asin l)) at 1. apply fwd_rises; lra. }
      rewrite arc_B_is in H0 by lra. unfold below_B. lra.
  - destruct (region_2 q l hq hl hm A B E) as (e & e' & U & he & hB & he' & HU & _ & Co). rewrite <- (same HU). fold be in he, hB, he'. rewrite hB.
    destruct (Req_dec e (PI + be)) as [z | n]; [ right | left ]; (split; [ lra | ]); [ rewrite <- z; apply (proj1 (proj2 (proj2 Co))) | apply (proj1 (proj2 Co)) ]; lra.
  - right. destruct (region_3 q l hq hl hm B) as (e & e' & U & he & he' & HU & _ & Co). rewrite <- (same HU). split; [ unfold above_B, below_B in *; lra | ]. fold be in he. apply (proj1 (proj2 (proj2 Co))). fold be. lra.
  - left. destruct (region_4 q l hq hl D) as (e & U & He & HU & _ & Co & P). rewrite <- (same HU). split; [ | now apply P ]. destruct D as [D | [_ D]]; [ lra | ].
    destruct (fwd_end l hl) as (e0 & He0). destruct (where_B_E q l hq hl hm e0 He0) as (_ & -> & E). rewrite E in D. fold be in D |- *. lra.
Qed.
Lemma moves_where : (exists t, W t <> 0) <-> l < 1.
Proof.
  pose proof PI_RGT_0. split.
  - intros [t Ht]. apply Rnot_le_lt. intros h1. apply Ht. rewrite <- (same (proj1 (region_5 q l hq h1))). trivial.
  - intros h1. destruct places as [N | hl hm A B E | hl hm _ B _ | hl _ D | h2 _]; [ | | | | lra ].
    + destruct (region_1 q l hq h0 N) as (U & HU & ([C _] & F & _) & _). exists ((middle q l - K q + (middle q l + K q)) / 2). rewrite <- (same HU). apply Rgt_not_eq, F. lra.
    + destruct (region_2 q l hq hl hm A B E) as (e & e' & U & _ & _ & _ & HU & _ & ([C _] & F & _)). exists ((asin l + e) / 2). rewrite <- (same HU). apply Rgt_not_eq, F. lra.
    + destruct (region_3 q l hq hl hm B) as (e & e' & U & _ & _ & HU & _ & ([C _] & F & _)). exists ((asin l + e) / 2). rewrite <- (same HU). apply Rgt_not_eq, F. lra.
    + destruct (region_4 q l hq hl D) as (e & U & _ & HU & _ & ([C _] & F & _) & _). exists ((asin l + e) / 2). rewrite <- (same HU). apply Rgt_not_eq, F. lra.
Qed.
End Behaviour.
(* there is such a motion at every point *)
Lemma late_slide_exists q l : 1 <= q -> 0 < l -> exists W, late_slide q l W.
Proof.
  intros hq h0. destruct (places q l hq h0) as [N | hl hm A B E | hl hm _ B _ | hl _ D | h1 _].
  - destruct (region_1 q l hq h0 N) as (U & HU & _). eauto.
  - destruct (region_2 q l hq hl hm A B E) as (e & e' & U & _ & _ & _ & HU & _). eauto.
  - destruct (region_3 q l hq hl hm B) as (e & e' & U & _ & _ & HU & _). eauto.
  - destruct (region_4 q l hq hl D) as (e & U & _ & HU & _). eauto.
  - exists (fun _ => 0). now apply region_5.
Qed.
(* in region I no motion rests from some time on: where it would, the drive exceeds friction *)
Lemma restless_I q l : 1 <= q -> below_A q l -> 0 < l -> forall t0 w, slides q l t0 w -> restless w.
Proof.
  intros hq bA h0 t0 w Hw. assert (N : ~ above_A q l) by (unfold below_A, above_A in *; lra). destruct (region_1 q l hq h0 N) as (W & [M P D] & Co & F & a1 & a2 & e1 & m1 & _ & _ & S & _). destruct (S bA) as [s1 s2]. clear S.
  set (a := middle q l - K q) in *. set (e := middle q l + K q) in *. pose proof PI_RGT_0. set (m := q * l) in *.
  set (G t := W t ^ 2 + (Rabs (sin t - l) + (sin t - l)) + (Rabs (- m - sin t) + (- m - sin t))).
  assert (cW : forall t, continuity_pt W t) by (intros t; apply (l_c _ _ _ _ _ (M (t - 1))); lra). assert (cS : forall t, continuity_pt sin t) by (intros; apply continuity_sin).
  assert (cG : forall t, continuity_pt G t).
  { assert (cA : forall f t, continuity_pt f t -> continuity_pt (fun t => Rabs (f t)) t) by (intros f t C; apply (continuity_pt_comp f Rabs); [ trivial | apply Rcontinuity_abs ]).
    intros t. unfold G. cont; apply cA; cont. }
  assert (G0 : forall t, 0 < G t).
  { intros t. unfold G. pose proof (pow2_ge_0 (W t)). pose proof (Rle_abs (- (sin t - l))) as r1. pose proof (Rle_abs (- (- m - sin t))) as r2. rewrite Rabs_Ropp in r1, r2.
    destruct (Req_dec (W t) 0) as [z | n]; [ | assert (0 < W t ^ 2) by (apply pow2_gt_0, n); lra ].
    destruct (course_at _ _ _ _ W t P Co) as (s & hs & es & sh). destruct (per_spec a (2 * PI) ltac:(lra) t) as [k Hk]. set (s' := t - IZR k * (2 * PI)). assert (hs' : a <= s' < a + 2 * PI) by (unfold s'; lra).
    assert (es' : W s' = 0) by (unfold s'; rewrite shift_Z; trivial). assert (ss : sin s' = sin t) by (unfold s'; apply shift_Z, sin_per). destruct Co as ([C1 C2] & F1 & _ & B1 & _).
    destruct (Req_dec s' a) as [y | ny]. { rewrite <- ss, y. pose proof (Rle_abs (sin a - l)). rewrite <- ss, y in *. lra. }
    destruct (Req_dec s' e) as [y2 | ny2]. { rewrite <- ss, y2. pose proof (Rle_abs (- m - sin e)). rewrite <- ss, y2 in *. lra. }
    destruct (Rlt_le_dec s' e); [ specialize (F1 s') | specialize (B1 s') ]; lra. }
  destruct (continuity_ab_min G 0 (2 * PI) ltac:(lra) ltac:(intros; apply cG)) as [z [Hz _]]. pose proof (G0 z) as gz.
  assert (all : forall t, G z <= G t).
  { intros t. destruct (per_spec 0 (2 * PI) ltac:(lra) t) as [k Hk]. assert (e0 : G (t - IZR k * (2 * PI)) = G t) by (apply (shift_Z (2 * PI) G); intros u; unfold G; now rewrite P, sin_per). rewrite <- e0. apply Hz. lra. }
  set (d := Rmin 1 (G z / 2)). assert (d0 : 0 < d) by (apply Rmin_pos; lra). assert (d1 : d <= 1 /\ d <= G z / 2) by (split; [ apply Rmin_l | apply Rmin_r ]).
  destruct (lim_near _ 0 d (D t0 w Hw) d0) as [t1 L]. exists (Rmax t0 t1). intros s b hs hb. pose proof (Rmax_l t0 t1). pose proof (Rmax_r t0 t1).
  apply Classical_Prop.NNPP. intros no. assert (Z : forall u, s <= u <= s + b -> w u = 0) by (intros u Hu; apply Classical_Prop.NNPP; intros nz; apply no; exists u; auto).
  destruct (l_law _ _ _ _ _ Hw s ltac:(lra)) as (f & (Fr & _) & R). pose proof (rder_rest w s b _ hb Z R) as e0. unfold eq50_lambda_minus in Fr. fold m in Fr.
  specialize (L s ltac:(lra)). rewrite Z, Rminus_0_r, Rminus_0_l, Rabs_Ropp in L by lra. specialize (all s). unfold G in all at 2.
  rewrite (Rabs_left1 (sin s - l)), (Rabs_left1 (- m - sin s)) in all by lra. pose proof (pow2_abs (W s)). pose proof (Rabs_pos (W s)). nra.
Qed.

(* ---- C, and the contact of B with it at Y ---- *)
Lemma C_q q : 0 < q -> forall l, l < eq55_lambda0 q <-> q * l < 1.
Proof.
  intros hq l. unfold eq55_lambda0. rewrite (Rmult_comm q). symmetry. now apply Rlt_div_r.
Qed.
Lemma B_meets_C x q l : is_Y x -> 1 <= q -> l = eq55_lambda0 q -> (on_B q l <-> q = q_Y x).
Proof.
  intros Y hq ->. unfold eq55_lambda0. assert (0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). destruct (corner x q Y hq) as (_ & _ & _ & <-). apply B_sign; trivial. right. field. lra.
Qed.
Lemma B_touches_C x q b : is_Y x -> 4 <= q < q_Y x -> 0 < b -> q * b <= 1 -> on_B q b -> 0 < 1 / q - b <= (q_Y x - q) ^ 2.
Proof.
  intros Y hq hb qb B. assert (qb' : q * b < 1).
  { destruct qb as [ | e]; trivial. exfalso. assert (b = eq55_lambda0 q) by (unfold eq55_lambda0; rewrite <- e; field; lra). apply (B_meets_C x q b Y) in B; trivial; lra. }
  destruct (Y_facts x Y) as (y3 & y2 & yA & yc). destruct Y as [hx ex]. pose proof PI2_3_2. pose proof PI_4.
  assert (hm : 0 < q * b < 1) by nra. assert (b1 : 0 < b < 1) by nra. pose proof (proj1 (proj2 (proj2 (B_sign q b ltac:(lra) hb qb))) B) as z. rewrite B_over in z by lra.
  destruct (asin_range b b1) as [[a0 a1] ea]. destruct (asin_range (q * b) hm) as [[be0 be1] eb]. set (al := asin b) in *. set (be := asin (q * b)) in *. set (psi := PI / 2 - be). set (g := 3 * PI / 2 - x) in *.
  assert (g0 : 0 < g < PI / 2) by (unfold g; lra). assert (sg0 : sin g = 1 / q_Y x) by (rewrite <- yA; apply sin_asin; split; [ assert (0 < 1 / q_Y x) by (apply Rdiv_lt_0_compat; lra) | apply Rle_div_l ]; lra).
  assert (cb : psi < cot be). { unfold cot. apply Rlt_div_r; [ apply sin_gt_0; lra | ]. replace be with (PI / 2 - psi) by (unfold psi; ring). rewrite sin_shift, cos_shift. apply x_cos_lt. unfold psi. lra. }
  assert (P : forall c, 0 < c < PI / 2 -> 0 < sin c /\ 0 < cos c) by (intros; split; [ apply sin_gt_0 | apply cos_gt_0 ]; lra).
  assert (D : g < al). { apply Rnot_le_lt. intros k. assert (cot g + g <= cot al + al) by (destruct k as [k | ->]; [ left; apply cot_falls; lra | lra ]). assert (0 < q * cot be) by (unfold psi in *; nra). unfold psi, g in *. lra. }
  destruct (MVT_cor2 (fun t => cot t + t) (fun t => - (cos t / sin t) ^ 2) g al D) as (c & e1 & hc).
  { intros c hc. destruct (P c ltac:(lra)). pose proof (sin2_cos2 c) as I. rewrite !Rsqr_pow2 in I. apply is_derive_Reals. unfold cot. auto_derive; [ lra | ]. field_simplify_eq; [ | lra ]. nra. }
  destruct (MVT_cor2 sin cos g al D) as (c' & e2 & hc'). { intros u _. apply derivable_pt_lim_sin. }
  destruct (P c ltac:(lra)) as [sc cc]. destruct (P g g0) as [sg' cg']. destruct (P al ltac:(lra)) as [sa ca].
  assert (cx : 0 < cos c / sin c <= x). { split; [ now apply Rdiv_lt_0_compat | ]. rewrite <- yc. unfold cot. assert (cos c <= cos g) by (apply cos_decr_1; lra). assert (sin g <= sin c) by (apply sin_incr_1; lra).
    apply Rle_div_l; trivial. replace (cos g / sin g * sin c) with (cos g * (sin c / sin g)) by (field; lra). assert (1 <= sin c / sin g) by (apply Rle_div_r; lra). nra. }
  assert (h1 : (1 + q) * psi <= x ^ 2 * (al - g)).
  { assert ((cos c / sin c) ^ 2 <= x ^ 2) by (apply pow_incr; lra). assert ((cos c / sin c) ^ 2 * (al - g) <= x ^ 2 * (al - g)) by (apply Rmult_le_compat_r; lra). assert (q * psi <= q * cot be) by nra. rewrite yc in e1. unfold psi, g in *. lra. }
  assert (h2 : 96 / 100 * (al - g) <= 1 / q - 1 / q_Y x).
  { assert (ca2 : 96 / 100 <= cos al). { pose proof (sin2_cos2 al) as I. rewrite !Rsqr_pow2, ea in I. assert (b <= 1 / 4) by nra. apply Rnot_lt_le. intros k. nra. }
    assert (cos al <= cos c') by (apply cos_decr_1; lra). rewrite ea, sg0 in e2. assert (b < 1 / q) by (apply Rlt_div_r; lra). assert (96 / 100 * (al - g) <= cos c' * (al - g)) by (apply Rmult_le_compat_r; lra). lra. }
  assert (h3 : 1 / q - 1 / q_Y x <= (q_Y x - q) / (4 * q_Y x)).
  { replace (1 / q - 1 / q_Y x) with ((q_Y x - q) / (q * q_Y x)) by (field; lra). apply Rmult_le_compat_l; [ lra | ]. apply Rinv_le_contravar; nra. }
  assert (h4 : psi <= (q_Y x - q) / 2).
  { assert (Yb : q_Y x < 7) by (clear - y2 hx H0 y3; assert (x < 6) by lra; nra). assert (d0 : 0 < q_Y x - q) by lra. set (d := q_Y x - q) in *. assert (e4 : d / (4 * q_Y x) * (4 * q_Y x) = d) by (field; lra). set (w := d / (4 * q_Y x)) in *. assert (w0 : 0 < w) by (unfold w; apply Rdiv_lt_0_compat; lra).
    assert (al - g <= 105 / 100 * w) by lra. assert (x ^ 2 * (al - g) <= q_Y x ^ 2 * (105 / 100 * w)) by (apply Rmult_le_compat; nra). assert (5 * psi <= (1 + q) * psi) by (apply Rmult_le_compat_r; unfold psi; lra). nra. }
  assert (h5 : 1 - q * b <= psi ^ 2 / 2).
  { rewrite <- eb. replace be with (PI / 2 - psi) by (unfold psi; ring). rewrite sin_shift. replace psi with (2 * (psi / 2)) at 1 by field. rewrite cos_2a_sin.
    assert (p0 : 0 < psi / 2 < PI / 2) by (unfold psi; lra). destruct (P (psi / 2) p0). pose proof (sin_lt_x (psi / 2) ltac:(lra)). nra. }
  replace (1 / q - b) with ((1 - q * b) / q) by (field; lra). split; [ apply Rdiv_lt_0_compat; lra | ]. apply Rle_div_l; [ lra | ].
  assert (0 < psi) by (unfold psi; lra). assert (psi ^ 2 <= ((q_Y x - q) / 2) ^ 2) by (apply pow_incr; lra). assert (0 < (q_Y x - q) ^ 2) by (apply pow_lt; lra). nra.
Qed.
