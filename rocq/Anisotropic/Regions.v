(* 2.4: the regions of the drive sin, for friction l forward and m = q l backward *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion General Pieces Periodic Steady Aniso Formulas.
Open Scope R_scope.

(* (51), (52) integrated: forward from a, backward from b *)
Definition fwd (l a t : R) : R := cos a - cos t - l * (t - a).
Definition bwd (m b t : R) : R := cos b - cos t + m * (t - b).
Lemma fwd_der l a t : is_derive (fwd l a) t (sin t - l). Proof. unfold fwd. auto_derive; trivial. ring. Qed.
Lemma bwd_der m b t : is_derive (bwd m b) t (sin t + m). Proof. unfold bwd. auto_derive; trivial. ring. Qed.
Lemma bwd_fwd m b t : bwd m b t = - fwd m (b - PI) (t - PI).
Proof. unfold bwd, fwd. rewrite !cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma fwd_cont l a t : continuity_pt (fwd l a) t. Proof. apply derivable_continuous_pt. exists (sin t - l). apply is_derive_Reals, fwd_der. Qed.
Lemma bwd_cont l a t : continuity_pt (bwd l a) t. Proof. apply derivable_continuous_pt. exists (sin t + l). apply is_derive_Reals, bwd_der. Qed.

(* the steady motion, and what becomes of the others *)
Definition steady l m (W : R -> R) : Prop := (forall t0, line l m sin t0 W) /\ forall t, W (t + 2 * PI) = W t.
Definition reached l m (W : R -> R) : Prop := forall t0 w, line l m sin t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> w t = W t.

Section Arcs.
Variables l m p q : R.
Hypothesis hl : 0 <= l.
Hypothesis hm : 0 <= m.
Lemma arc_fwd a : (forall t, p <= t < q -> 0 <= fwd l a t) -> arc l m sin p q (fwd l a).
Proof.
  intros H. split; intros t Ht. apply fwd_cont. exists (- l). specialize (H t Ht). repeat split; try lra. apply rder_of. apply fwd_der.
Qed.
Lemma arc_bwd b : (forall t, p <= t < q -> bwd m b t <= 0) -> arc l m sin p q (bwd m b).
Proof.
  intros H. split; intros t Ht. apply bwd_cont. exists m. specialize (H t Ht). repeat split; try lra. apply rder_of. apply bwd_der.
Qed.
Lemma arc_rest : (forall t, p <= t < q -> - m <= sin t <= l) -> arc l m sin p q (fun _ => 0).
Proof.
  intros H. split; intros t Ht. cont. exists (- sin t). specialize (H t Ht). repeat split; try lra. eapply rder_eq. rd. ring.
Qed.
End Arcs.

(* how a forward slip rises and falls *)
Section Forward.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Lemma sin_less t : PI - asin l < t < 2 * PI + asin l -> sin t < l.
Proof.
  destruct (p1_range l hl) as [[a b] e]. intros H. rewrite <- e. destruct (Rle_lt_dec t (3 * (PI / 2))).
  - rewrite <- (sin_PI_x t). apply sin_increasing_1; lra.
  - replace (sin t) with (sin (t - 2 * PI)) by (rewrite <- (sin_period (t - 2 * PI) 1); f_equal; simpl; ring). apply sin_increasing_1; lra.
Qed.
Lemma fwd_rises a s t : asin l <= s < t -> t <= PI - asin l -> fwd l a s < fwd l a t.
Proof.
  intros H1 H2. apply (up (fwd l a) (fun t => sin t - l)); [ lra | intros; apply fwd_der | ]. intros c Hc. pose proof (sin_above l hl c). lra.
Qed.
Lemma fwd_falls a s t : PI - asin l <= s < t -> t <= 2 * PI + asin l -> fwd l a t < fwd l a s.
Proof.
  intros H1 H2. apply Ropp_lt_cancel. apply (up (fun t => - fwd l a t) (fun t => - (sin t - l))); [ lra | intros; apply (is_derive_opp (fwd l a)), fwd_der | ].
  intros c Hc. pose proof (sin_less c). lra.
Qed.
Lemma fwd_pos a b : asin l <= a -> a < b <= 2 * PI + asin l -> a <= PI - asin l -> 0 <= fwd l a b -> forall t, a < t < b -> 0 < fwd l a t.
Proof.
  intros H1 H2 H3 H4 t Ht. destruct (Rle_lt_dec t (PI - asin l)).
  - replace 0 with (fwd l a a) by (unfold fwd; ring). apply fwd_rises; lra.
  - apply Rle_lt_trans with (1 := H4). apply fwd_falls; lra.
Qed.
(* (32) for every l: from the phase phi1 on it ends once, before the next phi1 *)
Lemma fwd_end : exists e, PI - asin l < e < 2 * PI + asin l /\ fwd l (asin l) e = 0 /\ forall t, asin l < t < e -> 0 < fwd l (asin l) t.
Proof.
  destruct (p1_range l hl) as [[a b] e]. pose proof PI_RGT_0.
  assert (H1 : 0 < fwd l (asin l) (PI - asin l)). { replace 0 with (fwd l (asin l) (asin l)) by (unfold fwd; ring). apply fwd_rises; lra. }
  assert (H2 : fwd l (asin l) (2 * PI + asin l) < 0). { unfold fwd. replace (cos (2 * PI + asin l)) with (cos (asin l)) by (rewrite <- (cos_period (asin l) 1); f_equal; simpl; ring). nra. }
  destruct (IVT_cor (fwd l (asin l)) (PI - asin l) (2 * PI + asin l)) as [z [z1 z2]]; [ intros x; apply fwd_cont | lra | nra | ].
  assert (z <> PI - asin l) by (intros ->; lra). assert (z <> 2 * PI + asin l) by (intros ->; lra).
  exists z. repeat split; try lra. apply fwd_pos; lra.
Qed.

(* forward from phi1, then rest: where the drive does not pull it backward before the next phi1 *)
Variable m : R.
Hypothesis hm : 0 < m.
Lemma sin_2PI t : sin (t - 2 * PI) = sin t.
Proof. rewrite <- (sin_period (t - 2 * PI) 1). f_equal. simpl. ring. Qed.
Lemma slip_and_rest e : PI - asin l < e < 2 * PI + asin l -> fwd l (asin l) e = 0 -> (forall t, e <= t <= 2 * PI + asin l -> - m <= sin t) ->
  exists W, steady l m W /\ reached l m W /\ (forall t, asin l < t < e -> W t = fwd l (asin l) t) /\ (forall t, e <= t <= 2 * PI + asin l -> W t = 0).
Proof.
  intros He z Hs. destruct (p1_range l hl) as [[a b] ea]. pose proof PI_RGT_0. pose (g := glue e (fwd l (asin l)) (fun _ => 0)).
  assert (P : forall t, asin l < t < e -> 0 < fwd l (asin l) t) by (apply fwd_pos; lra).
  assert (A : arc l m sin (asin l) (asin l + 2 * PI) g).
  { apply arc_glue; [ lra | | | trivial ].
    - apply arc_fwd; try lra. intros t Ht. destruct (Req_dec t (asin l)) as [-> | ]. unfold fwd; lra. left; apply P; lra.
    - apply arc_rest; try lra. intros t Ht. split; [ apply Hs; lra | left; apply sin_less; lra ]. }
  assert (G : g (asin l + 2 * PI) = g (asin l)).
  { unfold g, glue. destruct (Rlt_dec (asin l + 2 * PI) e); [ lra | ]. destruct (Rlt_dec (asin l) e); [ unfold fwd; ring | trivial ]. }
  assert (S : forall t, sin (t + 2 * PI) = sin t) by (intros t; rewrite <- (sin_2PI (t + 2 * PI)); f_equal; ring).
  set (W := per (asin l) (2 * PI) g). assert (hT : 0 < 2 * PI) by lra.
  assert (L : forall t0, line l m sin t0 W) by (apply per_line; trivial).
  assert (Q : forall t, W (t + 2 * PI) = W t) by (intros t; apply per_per; trivial).
  assert (on : forall t, asin l <= t < asin l + 2 * PI -> W t = g t).
  { intros t Ht. unfold W. rewrite (per_on (asin l) (2 * PI) g hT 0) by (simpl; lra). f_equal. ring. }
  assert (Z : forall t, e <= t <= 2 * PI + asin l -> W t = 0).
  { intros t Ht. destruct (Req_dec t (2 * PI + asin l)) as [-> | ne].
    - rewrite Rplus_comm, Q, on by lra. unfold g, glue. destruct (Rlt_dec (asin l) e); [ unfold fwd; ring | trivial ].
    - rewrite on by lra. unfold g, glue. destruct (Rlt_dec t e); lra. }
  exists W. split; [ split; trivial | split; [ | split; [ | trivial ] ] ].
  - intros t0 w Hw. set (r := Rmax e (2 * PI + asin l / 2)). assert (e <= r /\ 2 * PI + asin l / 2 <= r < 2 * PI + asin l).
    { unfold r. split. apply Rmax_l. split. apply Rmax_r. apply Rmax_lub_lt; lra. }
    apply (captured l m (2 * PI) r (2 * PI + asin l) sin W); trivial; try lra.
    + intros t Ht. apply Z; lra.
    + split; [ | apply sin_less; lra ]. apply Rlt_trans with 0; [ lra | ]. rewrite <- sin_2PI. apply sin_gt_0; lra.
    + apply derivable_continuous_pt, derivable_pt_sin.
  - intros t Ht. rewrite on by lra. unfold g, glue. destruct (Rlt_dec t e); [ trivial | lra ].
Qed.
End Forward.

Lemma cos_asin_pow x : -1 <= x <= 1 -> cos (asin x) = sqrt (1 - x ^ 2).
Proof. intros H. rewrite cos_asin by trivial. f_equal. unfold Rsqr. ring. Qed.

(* s24-region-4: between C and D *)
Theorem s24_region_4 l q : 0 < q -> eq55_lambda0 q <= l < 1 -> exists e W, PI - asin l < e < 2 * PI + asin l /\ steady l (q * l) W /\ reached l (q * l) W /\
  (forall t, asin l < t < e -> 0 < W t) /\ (forall t, e <= t <= 2 * PI + asin l -> W t = 0).
Proof.
  unfold eq55_lambda0. intros hq [h1 h2]. assert (0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). assert (hl : 0 < l < 1) by lra.
  assert (hm : 1 <= q * l). { apply Rle_div_l in h1; lra. }
  destruct (fwd_end l hl) as (e & He & z & P). destruct (slip_and_rest l hl (q * l) ltac:(lra) e He z) as (W & S & R & A & B).
  - intros t _. pose proof (SIN_bound t). lra.
  - exists e, W. split; [ trivial | split; [ trivial | split; [ trivial | split; [ | trivial ] ] ] ]. intros t Ht. rewrite A by trivial. apply P; trivial.
Qed.

(* curve E: the forward slip lasts until the drive no longer pulls backward; from there to C nothing goes back *)
Definition above_E q l : Prop := right_anisotropic_e_sides_2 l (q * l) <= right_anisotropic_e_sides_1 l (q * l).
Theorem s24_between_E_and_C l q : 0 < q -> 0 < l < 1 -> l < eq55_lambda0 q -> above_E q l -> exists e W, 2 * PI - asin (q * l) <= e < 2 * PI + asin l /\
  steady l (q * l) W /\ reached l (q * l) W /\ (forall t, asin l < t < e -> 0 < W t) /\ (forall t, e <= t <= 2 * PI + asin l -> W t = 0).
Proof.
  unfold eq55_lambda0, above_E, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. intros hq hl h1 E. apply Rlt_div_r in h1; trivial. assert (hm : 0 < q * l < 1) by nra.
  destruct (fwd_end l hl) as (e & He & z & P). destruct (p1_range l hl) as [[a b] ea]. destruct (p1_range (q * l) hm) as [[a' b'] eb].
  rewrite <- !cos_asin_pow in E by lra. set (be := asin (q * l)) in *.
  assert (F : 0 <= fwd l (asin l) (2 * PI - be)).
  { unfold fwd. replace (cos (2 * PI - be)) with (cos be) by (rewrite <- (cos_neg be), <- (cos_period (- be) 1); f_equal; simpl; ring). lra. }
  assert (e1 : 2 * PI - be <= e). { apply Rnot_lt_le. intros k. pose proof (fwd_falls l hl (asin l) e (2 * PI - be)). lra. }
  destruct (slip_and_rest l hl (q * l) (proj1 hm) e He z) as (W & S & R & A & B).
  - intros t Ht. rewrite <- sin_2PI, <- eb, <- sin_neg. apply sin_incr_1; lra.
  - exists e, W. split; [ lra | split; [ trivial | split; [ trivial | split; [ | trivial ] ] ] ]. intros t Ht. rewrite A by trivial. apply P; trivial.
Qed.
Lemma never_back l q W e : 0 < l < 1 -> steady l (q * l) W -> (forall t, asin l < t < e -> 0 < W t) -> (forall t, e <= t <= 2 * PI + asin l -> W t = 0) -> 
  e < 2 * PI + asin l -> forall t, 0 <= W t.
Proof.
  intros hl [_ Q] P Z He t. pose proof PI_RGT_0. destruct (per_spec (asin l) (2 * PI) ltac:(lra) t) as [n Hn]. rewrite <- (shift_Z (2 * PI) W Q n t).
  set (s := t - IZR n * (2 * PI)). assert (Hs : asin l <= s < asin l + 2 * PI) by (unfold s; lra).
  destruct (Req_dec s (asin l)) as [-> | k]. rewrite <- Q, Z; lra. destruct (Rlt_le_dec s e). left; apply P; lra. rewrite Z; lra.
Qed.

(* s24-region-2 as printed: above A, below B and below C there is backward motion in each period *)
Definition printed_region_2 q l : Prop := eq53_sides_1 (eq53_k q) l < eq53_sides_2 (eq53_k q) l /\
  eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l) /\ l < eq55_lambda0 q.
Lemma asin_1_10 : asin (1 / 10) = atan (1 / 10 / sqrt (1 - 1 / 100)).
Proof. rewrite asin_atan by lra. do 3 f_equal. unfold Rsqr. field. Qed.
Lemma asin_9_10 : asin (9 * (1 / 10)) = atan (9 / 10 / sqrt (1 - 81 / 100)).
Proof. rewrite asin_atan by lra. f_equal. f_equal. field. f_equal. f_equal. unfold Rsqr. field. Qed.
Lemma printed_at_9 : printed_region_2 9 (1 / 10).
Proof.
  unfold printed_region_2, eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, eq55_lambda0. rewrite asin_1_10, asin_9_10. repeat split.
  - unfold cot. interval with (i_prec 60).
  - interval with (i_prec 60).
  - lra.
Qed.
Lemma E_at_9 : above_E 9 (1 / 10).
Proof. unfold above_E, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2. rewrite asin_1_10, asin_9_10. interval with (i_prec 60). Qed.
(* at q = 9, lambda0 = 1/10, inside that region, no motion goes back for ever *)
Theorem s24_region_2_wrong : printed_region_2 9 (1 / 10) /\
  forall t0 w, line (1 / 10) (9 * (1 / 10)) sin t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> 0 <= w t.
Proof.
  split. apply printed_at_9. intros t0 w Hw. destruct (s24_between_E_and_C (1 / 10) 9) as (e & W & He & S & R & P & Z); try lra; [ unfold eq55_lambda0; lra | apply E_at_9 | ].
  destruct (R t0 w Hw) as (t1 & h & E). exists t1. split; trivial. intros t Ht. rewrite E by trivial. apply (never_back (1 / 10) 9 W e); trivial; lra.
Qed.
