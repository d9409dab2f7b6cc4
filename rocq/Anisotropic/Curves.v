(* 2.4: each of the curves A, B and E has one point at most for each q >= 1; the point Y where B and E end on C; and what the motion at
   large times does on either side of each. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion HalfPeriod Drawn Line Slips Regions Formulas.
Open Scope R_scope.

(* ---- A: where cot (asin l) has a given value ---- *)
Lemma cot_root r : 0 < r -> let a := / sqrt (1 + r ^ 2) in 0 < a < 1 /\ forall l, 0 < l -> (r < sqrt (1 - l ^ 2) / l <-> l < a) /\ (sqrt (1 - l ^ 2) / l < r <-> a < l).
Proof.
  intros hr. cbv zeta. assert (S : 0 < sqrt (1 + r ^ 2)) by (apply sqrt_lt_R0; nra).
  assert (S2 : sqrt (1 + r ^ 2) ^ 2 = 1 + r ^ 2) by (apply pow2_sqrt; nra). set (s := sqrt (1 + r ^ 2)) in *.
  assert (i : / s * s = 1) by (apply Rinv_l; lra). assert (i0 : 0 < / s) by now apply Rinv_0_lt_compat. split; [ nra | ]. intros l h.
  assert (U : 0 <= sqrt (1 - l ^ 2) /\ (l < 1 -> sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) /\ (1 <= l -> sqrt (1 - l ^ 2) = 0)).
  { split; [ apply sqrt_pos | split; intros; [ apply pow2_sqrt | apply sqrt_neg_0 ]; nra ]. }
  destruct U as (u & u1 & u2). set (v := sqrt (1 - l ^ 2)) in *. rewrite <- (Rlt_div_r _ _ _ h), (Rlt_div_l _ _ _ h).
  assert (L : (l < / s <-> l * s < 1) /\ (/ s < l <-> 1 < l * s)) by (split; split; intros; nra). destruct L as [-> ->].
  assert (Q : (l * s) ^ 2 = l ^ 2 + (r * l) ^ 2) by (rewrite Rpow_mult_distr, S2; ring). assert (0 < r * l) by nra. assert (0 < l * s) by nra.
  set (x := l * s) in *. set (y := r * l) in *. clearbody x y v.
  destruct (Rlt_le_dec l 1) as [k | k]; [ specialize (u1 k) | specialize (u2 k) ]; split; split; intros; nra.
Qed.
Lemma side_A_pos q : 1 <= q -> 0 < eq53_sides_2 (K q) 0.
Proof.
  intros hq. destruct (K_facts q hq) as (k & _ & _ & s). assert (cos (K q) <= 0) by (rewrite <- cos_PI2; apply cos_decr_1; lra).
  unfold eq53_sides_2, cot, Rdiv.
  assert (0 < K q * / sin (K q) ^ 2) by (apply Rdiv_lt_0_compat; nra). assert (0 < / sin (K q)) by now apply Rinv_0_lt_compat. nra.
Qed.
Lemma A_splits q : 1 <= q -> exists a, 0 < a < 1 /\ (q = 1 -> a = eq57_x_2) /\ forall l, 0 < l -> (below_A q l <-> l < a) /\ (above_A q l <-> a < l).
Proof.
  intros hq. destruct (cot_root _ (side_A_pos q hq)) as [i S]. eexists. split; [ exact i | split; [ | exact S ] ]. intros ->.
  unfold eq53_k, eq53_sides_2, eq57_x_2, cot.
  replace (PI * 1 / (1 + 1)) with (PI / 2) by field. rewrite sin_PI2, cos_PI2.
  replace (4 + PI ^ 2) with (2 ^ 2 * (1 + (PI / 2 / 1 ^ 2 - 0 / 1) ^ 2)) by field.
  rewrite sqrt_mult, sqrt_pow2 by nra. field. apply Rgt_not_eq, sqrt_lt_R0. nra.
Qed.
Lemma at_1 l : 0 < l -> (below_B 1 l <-> below_A 1 l) /\ (above_B 1 l <-> above_A 1 l).
Proof.
  intros h. unfold below_A, above_A, below_B, above_B, eq53_k, eq53_sides_1, eq53_sides_2, eq54_sides_1, eq54_sides_2, cot. rewrite !Rmult_1_l.
  replace (PI * 1 / (1 + 1)) with (PI / 2) by field. rewrite sin_PI2, cos_PI2. replace (PI / 2 / 1 ^ 2 - 0 / 1) with (PI / 2) by field.
  rewrite <- (Rlt_div_r _ _ _ h), (Rlt_div_l _ _ _ h). lra.
Qed.

(* ---- B and E: over lambda0, what decides falls ---- *)
Definition side_B q l := eq54_sides_1 l (q * l) - eq54_sides_2 l (q * l).
Definition side_E q l := right_anisotropic_e_sides_2 l (q * l) - right_anisotropic_e_sides_1 l (q * l).
Lemma asin_cont : exists A, (forall x, continuity_pt A x) /\ forall x, -1 <= x <= 1 -> asin x = A x.
Proof.
  assert (sq : forall x, continuity_pt (fun x => sqrt (1 - x ^ 2)) x).
  { intros x. apply (continuity_pt_comp (fun x => 1 - x ^ 2) sqrt); [ cont | apply continuity_pt_filterlim, continuous_sqrt ]. }
  exists (fun x => 2 * atan (x * / (1 + sqrt (1 - x ^ 2)))). split; intros x.
  - cont. apply (continuity_pt_comp (fun x => x * / (1 + sqrt (1 - x ^ 2))) atan); [ | apply derivable_continuous_pt, derivable_pt_atan ].
    cont. apply (continuity_pt_inv (fun x => 1 + sqrt (1 - x ^ 2))); [ cont | ]. pose proof (sqrt_pos (1 - x ^ 2)). lra.
  - intros hx. pose proof (asin_bound x). rewrite <- cos_asin_pow by trivial. rewrite <- (sin_asin x) at 2 by trivial. set (t := asin x / 2).
    replace (asin x) with (2 * t) by (unfold t; field).
    assert (c : 0 < cos t) by (apply cos_gt_0; unfold t; pose proof PI_RGT_0; lra). rewrite sin_2a, cos_2a_cos.
    replace (2 * sin t * cos t * / (1 + (2 * cos t * cos t - 1))) with (tan t) by (unfold tan; field; split; nra).
    rewrite atan_tan; [ ring | unfold t; pose proof PI_RGT_0; lra ].
Qed.
Lemma one_root F G u p : 0 < p <= u -> (forall a b, 0 < a < b -> b <= u -> F b / b < F a / a) -> (forall x, continuity_pt G x) -> (forall l, p <= l <= u -> F l = G l) -> 0 < F p -> F u <= 0 ->
  exists c, p < c <= u /\ (c = u <-> F u = 0) /\ forall l, 0 < l <= u -> (0 < F l <-> l < c) /\ (F l < 0 <-> c < l).
Proof.
  intros hp D C E h1 h2. destruct (IVT_cor G p u) as [c [hc z]]; [ exact C | lra | rewrite <- !E by lra; nra | ]. rewrite <- E in z by lra.
  assert (c <> p) by (intros ->; lra). exists c.
  assert (S : forall l, 0 < l <= u -> (l < c -> 0 < F l) /\ (c < l -> F l < 0)).
  { intros l hl. assert (e : F l = F l / l * l) by (field; lra).
    split; intros k; [ pose proof (D l c ltac:(lra) ltac:(lra)) as Q | pose proof (D c l ltac:(lra) ltac:(lra)) as Q ]; rewrite z in Q;
    unfold Rdiv in Q at 1 + 2; nra. }
  split; [ lra | split; [ split; [ now intros <- | ] | ] ].
  - intros e. destruct (S u ltac:(lra)). lra.
  - intros l hl. destruct (S l hl). destruct (total_order_T l c) as [[k | ->] | k]; [ specialize (H0 k) | | specialize (H1 k) ]; lra.
Qed.
Lemma cot_falls a b : 0 < a < b -> b <= PI / 2 -> cot b + b < cot a + a.
Proof.
  intros h1 h2. apply Ropp_lt_cancel. unfold cot. pose proof PI_RGT_0.
  assert (P : forall c, a <= c <= b -> 0 < sin c) by (intros; apply sin_gt_0; lra).
  apply (up (fun x => - (cos x / sin x + x)) (fun x => (cos x / sin x) ^ 2)); [ lra | | ]; intros c Hc; specialize (P c ltac:(lra)).
  - pose proof (unit_circle c). auto_derive; [ lra | ]. field_simplify_eq; [ | lra ]. nra.
  - assert (0 < cos c) by (apply cos_gt_0; lra). apply pow_lt, Rdiv_lt_0_compat; trivial.
Qed.
Lemma B_over q l : 0 < l <= 1 -> 0 < q * l <= 1 -> side_B q l / l = (cot (asin l) + asin l) + q * cot (asin (q * l)) - asin (q * l) - PI.
Proof.
  intros h1 h2. unfold side_B, cot. rewrite <- at_B by trivial. destruct (asin_closed l h1) as [_ e]. destruct (asin_closed (q * l) h2) as [_ e'].
  unfold fwd. rewrite e, e', Rplus_comm, neg_cos. field. split; nra.
Qed.
Lemma B_falls q a b : 1 <= q -> 0 < a < b -> b <= 1 / q -> side_B q b / b < side_B q a / a.
Proof.
  intros hq h1 h2. apply Rle_div_r in h2; [ | lra ]. assert (q * a < q * b <= 1) by nra. assert (b <= 1) by nra. assert (0 < q * a) by nra.
  rewrite !B_over by lra.
  pose proof (asin_up a b ltac:(lra) ltac:(lra)). pose proof (asin_up (q * a) (q * b) ltac:(lra) ltac:(lra)).
  destruct (asin_closed a), (asin_closed b), (asin_closed (q * a)), (asin_closed (q * b)); try lra.
  pose proof (cot_falls (asin a) (asin b) ltac:(lra) ltac:(lra)). pose proof (cot_falls (asin (q * a)) (asin (q * b)) ltac:(lra) ltac:(lra)). nra.
Qed.
Lemma E_over q l : 1 < q -> 0 < l -> q * l <= 1 -> side_E q l / l = 2 * PI - asin l - asin (q * l) - (q ^ 2 - 1) * (l / (cos (asin l) + cos (asin (q * l)))) /\ 0 < cos (asin l) /\ 0 <= cos (asin (q * l)).
Proof.
  intros hq h1 h2. assert (hl : 0 < l < 1) by nra. assert (hm : 0 < q * l <= 1) by nra. destruct (asin_range l hl) as [a e].
  destruct (asin_closed (q * l) hm) as [a' e'].
  assert (c1 : 0 < cos (asin l)) by (apply cos_gt_0; lra). assert (c2 : 0 <= cos (asin (q * l))) by (apply cos_ge_0; lra).
  split; [ | split; trivial ].
  unfold side_E, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. rewrite <- !cos_asin_pow by lra. pose proof (unit_circle (asin l)) as I.
  pose proof (unit_circle (asin (q * l))) as J. rewrite e in I. rewrite e' in J.
  field_simplify_eq; [ | lra ]. replace (cos (asin l) ^ 2) with (1 - l ^ 2) by lra. replace (cos (asin (q * l)) ^ 2) with (1 - (q * l) ^ 2) by lra.
  ring.
Qed.
Lemma E_falls q a b : 1 < q -> 0 < a < b -> b <= 1 / q -> side_E q b / b < side_E q a / a.
Proof.
  intros hq h1 h2. apply Rle_div_r in h2; [ | lra ]. assert (q * a < q * b <= 1) by nra. assert (b <= 1) by nra. assert (0 < q * a) by nra.
  destruct (E_over q a hq) as (-> & a1 & a2); try lra. destruct (E_over q b hq) as (-> & b1 & b2); try lra.
  pose proof (asin_up a b ltac:(lra) ltac:(lra)). pose proof (asin_up (q * a) (q * b) ltac:(lra) ltac:(lra)).
  destruct (asin_closed a), (asin_closed b), (asin_closed (q * a)), (asin_closed (q * b)); try lra.
  assert (c1 : cos (asin b) <= cos (asin a)) by (apply cos_decr_1; lra).
  assert (c2 : cos (asin (q * b)) <= cos (asin (q * a))) by (apply cos_decr_1; lra).
  assert (D : a / (cos (asin a) + cos (asin (q * a))) <= b / (cos (asin b) + cos (asin (q * b)))).
  { apply Rmult_le_compat; try lra; [ left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra ]. }
  assert (0 < q ^ 2 - 1) by nra. nra.
Qed.

(* ---- Y: where both end on C. x is the length of the slip there ---- *)
(* dimensionless: «$x$ is the least positive root of $\tan x=x$» *)
Definition is_Y (x : R) : Prop := PI < x < 3 * PI / 2 /\ tan x = x.
Notation q_Y := right_anisotropic_y_from_root_1.
Lemma Y_sine x : PI < x < 3 * PI / 2 -> (tan x = x <-> x * cos x - sin x = 0).
Proof.
  intros h. assert (cos x < 0) by (apply cos_lt_0; lra). unfold tan. split; intros e.
  - rewrite <- e at 1. field. lra.
  - apply (Rmult_eq_reg_r (cos x)); [ | lra ]. field_simplify; lra.
Qed.
Lemma Y_exists : exists x, is_Y x /\ 4.4926 < x < 4.4935.
Proof.
  assert (S : 4.4926 * cos 4.4926 - sin 4.4926 < 0 /\ 0 < 4.4935 * cos 4.4935 - sin 4.4935) by (split; interval with (i_prec 60)).
  destruct (IVT_cor (fun x => x * cos x - sin x) 4.4926 4.4935) as [x [h z]]; [ intros x; apply derivable_continuous_pt; reg | lra | nra | ].
  assert (B : PI < 4.4926 /\ 4.4935 < 3 * PI / 2) by (split; interval with (i_prec 60)).
  assert (N : x <> 4.4926 /\ x <> 4.4935) by (split; intros ->; lra). exists x. split; [ split; [ lra | apply Y_sine; lra ] | lra ].
Qed.
Lemma Y_unique x y : is_Y x -> is_Y y -> x = y.
Proof.
  assert (P : forall x y, is_Y x -> is_Y y -> ~ x < y).
  { intros a b [ha ea] [hb eb] k. apply Y_sine in ea; trivial. apply Y_sine in eb; trivial.
    pose proof (up (fun x => x * cos x - sin x) (fun x => - (x * sin x)) a b k) as U. cbv beta in U. rewrite ea, eb in U. enough (0 < 0) by lra.
    apply U.
    - intros c _. auto_derive; trivial; ring.
    - intros c Hc. assert (sin c < 0) by (apply sin_lt_0; lra). nra. }
  intros X Y. destruct (total_order_T x y) as [[k | k] | k]; trivial; exfalso; revert k; now apply P.
Qed.
Lemma Y_facts x : is_Y x -> 3 < q_Y x /\ asin (1 / q_Y x) = 3 * PI / 2 - x /\ sin (3 * PI / 2 - x) = 1 / q_Y x /\ cot (3 * PI / 2 - x) = x.
Proof.
  intros [h e]. pose proof PI2_3_2. apply Y_sine in e; trivial. assert (c0 : cos x < 0) by (apply cos_lt_0; lra). pose proof (unit_circle x) as I.
  unfold q_Y. assert (s : 0 < sqrt (1 + x ^ 2)) by (apply sqrt_lt_R0; nra).
  assert (s2 : sqrt (1 + x ^ 2) ^ 2 = 1 + x ^ 2) by (apply pow2_sqrt; nra). set (r := sqrt (1 + x ^ 2)) in *.
  assert (c : - cos x * r = 1). { apply Rsqr_inj; [ nra | lra | ]. rewrite !Rsqr_pow2, Rpow_mult_distr, s2.
  replace (sin x) with (x * cos x) in I by lra. lra. }
  assert (s3 : sin (3 * PI / 2 - x) = - cos x /\ cos (3 * PI / 2 - x) = - sin x) by (replace (3 * PI / 2) with (3 * (PI / 2)) by field;
  rewrite sin_minus, cos_minus, sin_3PI2, cos_3PI2; split; ring).
  destruct s3 as [s3 c3]. assert (i : 1 / r = - cos x) by (rewrite <- c; field; lra). unfold cot. rewrite s3, c3, i.
  replace (sin x) with (x * cos x) by lra.
  split; [ nra | split; [ rewrite <- s3; apply asin_sin; lra | split; [ trivial | field; lra ] ] ].
Qed.
Lemma inv_q q : 1 <= q -> 0 < 1 / q <= 1 /\ q * (1 / q) = 1 /\ forall l, (l <= 1 / q <-> q * l <= 1) /\ (l < 1 / q <-> q * l < 1).
Proof.
  intros hq. assert (i : q * (1 / q) = 1) by (field; lra). assert (0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). repeat split; trivial; intros; nra.
Qed.
Lemma C_q q l : 1 <= q -> (l < eq55_lambda0 q <-> q * l < 1).
Proof. intros hq. apply (inv_q q hq). Qed.
(* on C, B and E are one, and decide for Y *)
Lemma corner x q : is_Y x -> 1 <= q -> side_E q (1 / q) = - side_B q (1 / q) /\ (side_B q (1 / q) < 0 <-> q < q_Y x) /\ (side_B q (1 / q) = 0 <-> q = q_Y x) /\ (0 < side_B q (1 / q) <-> q_Y x < q).
Proof.
  intros Y hq. destruct (Y_facts x Y) as (y3 & yA & _ & yc). split.
  - unfold side_E, side_B, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2, eq54_sides_1, eq54_sides_2.
    destruct (inv_q q hq) as (_ & -> & _). rewrite asin_1. replace (1 - 1 ^ 2) with 0 by ring. rewrite sqrt_0. field. lra.
  - set (c q := cot (asin (1 / q)) + asin (1 / q)).
    assert (P : forall q, 1 <= q -> side_B q (1 / q) = (c q - 3 * PI / 2) * (1 / q)).
    { clear q hq. intros q hq. destruct (inv_q q hq) as (i & e & _).
      replace (side_B q (1 / q)) with (side_B q (1 / q) / (1 / q) * (1 / q)) by (field; lra).
      f_equal. rewrite B_over, e by lra. rewrite asin_1. unfold cot at 2. rewrite cos_PI2, sin_PI2. unfold c. field. }
    assert (Z : c (q_Y x) = 3 * PI / 2) by (unfold c; rewrite yA, yc; ring). destruct (inv_q q hq) as (i & _). rewrite P by trivial.
    assert (M : forall a b, 1 <= a < b -> c a < c b).
    { intros a b hab. destruct (inv_q a), (inv_q b); try lra.
      apply cot_falls; [ split; [ apply asin_closed; lra | apply asin_up; [ split; [ lra | ] | lra ] ] | apply asin_closed; lra ]. unfold Rdiv.
      rewrite !Rmult_1_l. apply Rinv_lt_contravar; nra. }
    destruct (total_order_T q (q_Y x)) as [[k | ->] | k]; [ pose proof (M q (q_Y x)) | rewrite Z | pose proof (M (q_Y x) q) ]; repeat split; intros;
    nra.
Qed.

(* B up to Y, E from Y on: one point for each q; and where there is none *)
Lemma sides_cont q : (exists G, (forall l, continuity_pt G l) /\ forall l, 0 < l <= 1 -> 0 < q * l <= 1 -> side_B q l = G l) /\ exists G, (forall l, continuity_pt G l) /\ forall l, 0 < l <= 1 -> 0 < q * l <= 1 -> side_E q l = G l.
Proof.
  destruct asin_cont as (A & C & E). assert (sq : forall f l, continuity_pt f l -> continuity_pt (fun x => sqrt (1 - f x ^ 2)) l).
  { intros f l F. apply (continuity_pt_comp (fun x => 1 - f x ^ 2) sqrt); [ cont | apply continuity_pt_filterlim, continuous_sqrt ]. }
  assert (Aq : forall l, continuity_pt (fun l => A (q * l)) l) by (intros; apply (continuity_pt_comp (fun l => q * l) A); [ cont | trivial ]).
  split; eexists; (split; [ intros l | intros l h1 h2; unfold side_B, side_E, eq54_sides_1, eq54_sides_2, right_anisotropic_e_sides_1,
  right_anisotropic_e_sides_2; rewrite !E by lra; reflexivity ]);
    cont; (apply (sq (fun l => l)) || apply (sq (fun l => q * l))); cont.
Qed.
Lemma B_root x q : is_Y x -> 1 <= q <= q_Y x -> exists b, 0 < b <= 1 / q /\ (b = 1 / q <-> q = q_Y x) /\ forall l, 0 < l <= 1 / q -> (below_B q l <-> l < b) /\ (above_B q l <-> b < l).
Proof.
  intros Y hq. destruct (inv_q q) as (i & iq & il); [ lra | ]. destruct (corner x q Y) as (_ & c1 & c2 & _); [ lra | ].
  destruct (A_splits q) as (a & ha & a1 & SA); [ lra | ]. destruct (Y_facts x Y) as (y3 & _).
  destruct (Req_dec q 1) as [-> | n].
  - exists a. split; [ lra | split; [ lra | ] ]. intros l hl. destruct (at_1 l) as [-> ->]; [ lra | ]. apply SA. lra.
  - destruct (A_order q a) as (qa & _ & AB); try lra. { rewrite (proj2 (SA a (proj1 ha))). lra. } specialize (AB ltac:(lra)).
    destruct (proj1 (sides_cont q)) as (G & C & E). destruct (il a) as [_ ia].
    destruct (one_root (side_B q) G (1 / q) a) as (b & hb & bu & S); trivial; [ tauto || lra | intros; apply B_falls; lra | intros l hl; apply E;
    [ lra | destruct (il l); split; [ nra | tauto ] ] | unfold side_B, below_B in *; lra | destruct (Req_dec q (q_Y x)); [ right; tauto | left;
    apply c1; lra ] | ].
    exists b. split; [ lra | split; [ tauto | ] ]. intros l hl. destruct (S l hl) as [<- <-]. unfold side_B, below_B, above_B. lra.
Qed.
Lemma E_root x q : is_Y x -> q_Y x <= q -> exists b, 0 < b <= 1 / q /\ (b = 1 / q <-> q = q_Y x) /\ forall l, 0 < l <= 1 / q -> (below_E q l <-> l < b) /\ (above_E q l <-> b < l).
Proof.
  intros Y hq. destruct (Y_facts x Y) as (y3 & _). destruct (inv_q q) as (i & iq & il); [ lra | ].
  destruct (corner x q Y) as (ec & _ & c2 & c3); [ lra | ]. destruct (A_splits q) as (a & ha & _ & SA); [ lra | ].
  destruct (A_order q a) as (qa & AE & _); try lra. { rewrite (proj2 (SA a (proj1 ha))). lra. } destruct (proj2 (sides_cont q)) as (G & C & E).
  destruct (il a) as [_ ia].
  destruct (one_root (side_E q) G (1 / q) a) as (b & hb & bu & S); trivial; [ tauto || lra | intros; apply E_falls; lra | intros l hl; apply E;
  [ lra | destruct (il l); split; [ nra | tauto ] ] | unfold side_E, below_E in *; lra | rewrite ec; destruct (Req_dec q (q_Y x)); [ right; lra |
  left; lra ] | ].
  exists b. split; [ lra | split; [ rewrite bu, <- c2, ec; lra | ] ]. intros l hl. destruct (S l hl) as [<- <-]. unfold side_E, below_E, above_E. lra.
Qed.
(* up to Y nothing below C is above E, beyond Y everything up to C is below B *)
Lemma below_C_E x q l : is_Y x -> 1 <= q <= q_Y x -> 0 < l -> q * l < 1 -> below_E q l.
Proof.
  intros Y hq h0 h1. destruct (inv_q q) as (i & iq & il); [ lra | ]. destruct (Req_dec q 1) as [-> | n].
  - unfold below_E, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. rewrite Rmult_1_l. destruct (asin_range l ltac:(lra)). nra.
  - destruct (corner x q Y) as (e & _ & _ & c); [ lra | ]. assert (li : l < 1 / q) by now apply il.
    pose proof (E_falls q l (1 / q) ltac:(lra) ltac:(lra) ltac:(lra)) as D.
    assert (0 <= side_E q (1 / q) / (1 / q)) by (apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]).
    assert (P : 0 < side_E q l / l * l) by (apply Rmult_lt_0_compat; lra).
    replace (side_E q l / l * l) with (side_E q l) in P by (field; lra). unfold below_E, side_E in *. lra.
Qed.
Lemma up_to_C_B x q l : is_Y x -> q_Y x < q -> 0 < l <= 1 / q -> below_B q l.
Proof.
  intros Y hq h. destruct (Y_facts x Y) as (y3 & _). destruct (corner x q Y) as (_ & _ & _ & c); [ lra | ]. apply c in hq.
  destruct (proj2 h) as [k | ->]; [ | unfold below_B, side_B in *; lra ].
  pose proof (B_falls q l (1 / q) ltac:(lra) ltac:(lra) ltac:(lra)) as D. assert (0 < side_B q (1 / q) / (1 / q)) by (apply Rdiv_lt_0_compat; lra).
  assert (P : 0 < side_B q l / l * l) by (apply Rmult_lt_0_compat; lra).
  replace (side_B q l / l * l) with (side_B q l) in P by (field; lra). unfold below_B, side_B in *. lra.
Qed.
(* where B nears C it leaves it with the square of the distance *)
Lemma B_touches_C x q b : is_Y x -> 1 <= q < q_Y x -> 0 < b <= 1 / q -> side_B q b = 0 -> 0 < 1 / q - b <= (q_Y x - q) ^ 2 / 8.
Proof.
  intros Y hq hb B. destruct (Y_facts x Y) as (y3 & _ & sg & yc). destruct (inv_q q) as (i & iq & il); [ lra | ]. destruct Y as [hx ex].
  assert (bq : b < 1 / q) by (destruct hb as [_ [k | ->]]; trivial; destruct (corner x q (conj hx ex)) as (_ & c & _); lra).
  assert (qb : q * b < 1) by now apply il.
  assert (hm : 0 < q * b) by nra. pose proof (B_over q b ltac:(lra) ltac:(lra)) as z. rewrite B in z. unfold Rdiv in z at 1. rewrite Rmult_0_l in z.
  destruct (asin_range b ltac:(lra)) as [a0 ea]. destruct (asin_range (q * b) ltac:(lra)) as [be0 eb]. set (al := asin b) in *.
  set (psi := PI / 2 - asin (q * b)). set (g := 3 * PI / 2 - x) in *. pose proof PI2_3_2.
  assert (cb : psi < cot (asin (q * b))).
  { unfold cot. apply Rlt_div_r; [ lra | ]. replace (asin (q * b)) with (PI / 2 - psi) by (unfold psi; ring). rewrite sin_shift, cos_shift.
    apply x_cos_lt. unfold psi. lra. }
  assert (z2 : (1 + q) * psi <= (cot g + g) - (cot al + al)) by (assert (q * psi <= q * cot (asin (q * b))) by nra; unfold psi, g in *; lra).
  assert (p0 : 0 < psi) by (unfold psi; lra). assert (D : g < al) by (apply Rnot_le_lt; intros [k | k];
  [ pose proof (cot_falls al g ltac:(lra) ltac:(unfold g; lra)) | rewrite k in z2 ]; nra).
  assert (h : - (/ sin g - cot g - g) < - (/ sin al - cot al - al)).
  { apply (up (fun t => - (/ sin t - cos t / sin t - t)) (fun t => cos t * (1 - cos t) / sin t ^ 2)); trivial; intros c hc;
    assert (s : 0 < sin c) by (apply sin_gt_0; unfold g in *; lra); pose proof (unit_circle c).
    - auto_derive; [ lra | ]. field_simplify_eq; [ | lra ]. nra.
    - assert (0 < cos c) by (apply cos_gt_0; unfold g in *; lra). assert (cos c < 1) by (assert (0 < sin c ^ 2) by (now apply pow_lt); nra).
      apply Rdiv_lt_0_compat; [ nra | now apply pow_lt ]. }
  assert (e : / sin g = q_Y x) by (rewrite sg; field; lra). rewrite ea, e in h.
  assert (q < / b) by (apply (Rmult_lt_reg_r b); [ lra | rewrite Rinv_l; lra ]).
  assert (p1 : psi <= (q_Y x - q) / 2) by nra. assert (c : 1 - q * b <= psi ^ 2 / 2).
  { rewrite <- eb at 1. replace (asin (q * b)) with (PI / 2 - psi) by (unfold psi; ring). rewrite sin_shift.
    replace psi with (2 * (psi / 2)) at 1 by field. rewrite cos_2a_sin.
    assert (0 < sin (psi / 2)) by (apply sin_gt_0; unfold psi; lra). pose proof (sin_lt_x (psi / 2) ltac:(lra)). nra. }
  split; [ lra | ]. assert (1 / q - b <= 1 - q * b) by nra. nra.
Qed.

(* ---- what the motion at large times does on either side of each ---- *)
Section Behaviour.
Variables (q l : R) (W : R -> R).
Hypothesis hq : 1 <= q.
Hypothesis h0 : 0 < l.
Hypothesis HW : late_slide q l W.
Lemma rest_above_1 : 1 <= l -> forall t, W t = 0.
Proof. intros h t. rewrite <- (late_slide_unique q l _ W (still q l hq h) HW). trivial. Qed.
Lemma rest_where : (exists s d, 0 < d /\ forall t, s <= t <= s + d -> W t = 0) <-> above_A q l.
Proof.
  destruct (Rlt_le_dec l 1) as [h | h].
  - destruct (late_course q l W hq ltac:(lra) HW) as (a & e & b & e' & Co & P & _).
    rewrite (course_rests _ _ _ _ _ (ls_per _ _ _ HW) Co), (p_rests _ _ _ _ _ _ P). split; [ | auto ]. intros [k | k]; trivial.
    apply (p_rests _ _ _ _ _ _ P), Classical_Prop.NNPP. intros N. destruct (p_start _ _ _ _ _ _ P N). lra.
  - split; [ intros _ | exists 0, 1; split; [ lra | intros; now apply rest_above_1 ] ]. destruct (A_splits q hq) as (a & ha & _ & S). apply S; lra.
Qed.
Lemma back_where : (exists t, W t < 0) <-> q * l < 1 /\ below_E q l.
Proof.
  destruct (Rlt_le_dec l 1) as [h | h].
  - destruct (late_course q l W hq ltac:(lra) HW) as (a & e & b & e' & Co & P & _).
    now rewrite (course_back _ _ _ _ _ (ls_per _ _ _ HW) Co), (p_back _ _ _ _ _ _ P).
  - split; [ intros [t Ht]; rewrite rest_above_1 in Ht by trivial; lra | nra ].
Qed.
(* where the drive begins to pull backward the particle still goes forward below B, and rests on B and above *)
Lemma forward_where : q * l <= 1 -> (0 < W (PI + asin (q * l)) <-> below_B q l) /\ (W (PI + asin (q * l)) = 0 <-> ~ below_B q l).
Proof.
  intros h. destruct (Rlt_le_dec l 1) as [h1 | h1].
  2: { rewrite rest_above_1 by trivial. enough (~ below_B q l) by (repeat split; intros; trivial; try contradiction; lra).
  assert (q = 1) as -> by nra. destruct (A_splits 1) as (a & ha & _ & S); [ lra | ].
    rewrite (proj1 (at_1 l h0)), (proj1 (S l h0)). lra. }
  destruct (late_course q l W hq ltac:(lra) HW) as (a & e & b & e' & (_ & F & Z & _ & Z') & P & _).
  destruct (p_turn _ _ _ _ _ _ P h) as (T & T' & B). set (s := PI + asin (q * l)) in *.
  assert (R : e <= s -> W s = 0) by (intros k; destruct T'; [ apply Z | destruct (Rle_lt_dec s b); [ apply Z | apply Z' ] ]; lra).
  specialize (F s). rewrite B. destruct (Rle_lt_dec e s) as [k | k]; [ specialize (R k) | specialize (F ltac:(lra)) ]; split; split; intros; lra.
Qed.
Lemma moves_where : (exists t, W t <> 0) <-> l < 1.
Proof.
  split; [ intros [t Ht]; apply Rnot_le_lt; intros h; now apply Ht, rest_above_1 | intros h ].
  destruct (late_course q l W hq ltac:(lra) HW) as (a & e & b & e' & ([C _] & F & _) & _). exists ((a + e) / 2). apply Rgt_not_eq, F. lra.
Qed.
End Behaviour.
(* in region I no motion rests from some time on: where friction could hold it, the motion at large times is fast *)
Lemma restless_I q l : 1 <= q -> below_A q l -> 0 < l -> forall t0 w, slides q l t0 w -> restless w.
Proof.
  intros hq bA h0 t0 w Hw. pose proof PI_RGT_0. assert (N : ~ above_A q l) by (unfold below_A, above_A in *; lra).
  assert (hl : 0 < l < 1) by (destruct (A_splits q hq) as (a & ha & _ & S); apply S in bA; lra).
  destruct (late_exists q l hq hl) as (a & e & b & e' & W & [M P D] & ([C1 C2] & F & _ & B & _) & Pt & _).
  destruct (p_start _ _ _ _ _ _ Pt N) as ((<- & eb) & ha & ha' & he' & he). specialize (ha' bA). specialize (he (or_intror bA)).
  rewrite (p_rests _ _ _ _ _ _ Pt) in N. destruct (proj1 (p_back _ _ _ _ _ _ Pt) eb) as [m1 _]. destruct (al_be q l hq h0 m1) as [ab b1].
  destruct (asin_range l hl) as [_ ea]. set (m := q * l) in *. assert (m0 : 0 < m) by (unfold m; nra).
  assert (cW : forall t, continuity_pt W t) by (intros t; apply (l_c _ _ _ _ _ (M (t - 1))); lra).
  set (d := Rmin (W (PI + asin m)) (- W (2 * PI + asin l))). assert (d0 : 0 < d). { apply Rmin_pos; [ apply F; lra | ].
  assert (W (2 * PI + asin l) < 0) by (apply B; lra). lra. }
  assert (d1 : d <= W (PI + asin m) /\ d <= - W (2 * PI + asin l)) by (split; [ apply Rmin_l | apply Rmin_r ]). clearbody d.
  assert (fast : forall t, - m <= sin t <= l -> d <= Rabs (W t)).
  { intros t Ht. destruct (fold_phase W P (PI - asin l) t) as (n & hn & sh). rewrite <- (sh t). set (s := t - IZR n * (2 * PI)) in *.
    assert (es : sin s = sin t) by (unfold s; apply shift_Z, sin_per).
    assert (s1 : s <= 2 * PI + asin l) by (apply Rnot_lt_le; intros k; pose proof (sin_above l (s - 2 * PI) hl ltac:(lra)); rewrite sin_2PI in *;
    lra).
    destruct (Rle_lt_dec s (PI + asin m)) as [k | k]; [ | assert (s2 : 2 * PI - asin m <= s) by (apply Rnot_lt_le; intros k';
    pose proof (sin_above m (s - PI) ltac:(lra) ltac:(lra)); rewrite sin_minus, cos_PI, sin_PI in *; lra) ].
    - apply Rle_trans with (W s); [ | apply Rle_abs ]. apply Rle_trans with (1 := proj1 d1). apply rder_decr; [ trivial | auto | ]. intros u hu.
      destruct (l_law _ _ _ _ _ (M u) u) as (f & (_ & F1 & _) & R); [ lra | ]. rewrite F1 in R by (apply F; lra).
      eexists. split; [ exact R | ]. destruct (proj1 hu) as [j | j]; [ pose proof (sin_less l u hl) | rewrite <- j ]; lra.
    - apply Rle_trans with (- W s); [ | rewrite <- Rabs_Ropp; apply Rle_abs ]. apply Rle_trans with (1 := proj2 d1).
      apply (rder_decr (fun t => - W t)); [ trivial | intros; cont | ]. intros u hu.
      destruct (l_law _ _ _ _ _ (M u) u) as (f & (_ & _ & F1) & R); [ lra | ]. rewrite F1 in R by (apply B; lra). eexists. split; [ rd | ].
      pose proof (not_back m (u - 2 * PI) ltac:(lra) ltac:(lra)). rewrite sin_2PI in *. unfold eq50_lambda_minus. fold m. lra. }
  destruct (lim_near _ 0 d (D t0 w Hw) d0) as (t1 & _ & L). exists (Rmax t0 t1). intros s r hs hr. pose proof (Rmax_l t0 t1).
  pose proof (Rmax_r t0 t1).
  apply Classical_Prop.NNPP. intros no. assert (Z : forall u, s <= u <= s + r -> w u = 0) by (intros u Hu; apply Classical_Prop.NNPP; intros nz;
  apply no; exists u; auto).
  destruct (l_law _ _ _ _ _ Hw s ltac:(lra)) as (f & (Fr & _) & R). pose proof (rder_rest w s r _ hr Z R) as e0. unfold eq50_lambda_minus in Fr.
  fold m in Fr.
  specialize (fast s ltac:(lra)). specialize (L s ltac:(lra)). rewrite Z in L by lra. unfold Rabs in fast. destruct (Rcase_abs (W s)); lra.
Qed.
