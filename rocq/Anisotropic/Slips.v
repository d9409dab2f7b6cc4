(* 2.4: the slips of the drive sin, forward from a and backward from b, and the periodic motion that they make with the
   rests between them. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn Line Formulas.
Open Scope R_scope.

(* (51), (52) with rest: a motion along the drive from the phase t0 on. l is lambda0, the friction forward, q l the friction
   backward; the velocity w is in units of A0/varpi. *)
Definition slides (q l t0 : R) (w : R -> R) : Prop := line l (eq50_lambda_minus q l) sin t0 w.
(* W is the motion at large times: it has the drive's period, is a motion, and every motion tends to it. *)
Record late_slide (q l : R) (W : R -> R) : Prop := {
  ls_slides : forall t0, slides q l t0 W;
  ls_per : forall t, W (t + 2 * PI) = W t;
  ls_drawn : forall t0 w, slides q l t0 w -> is_lim (fun t => w t - W t) p_infty 0 }.
(* every motion is equal to it from some time on *)
Definition reached (q l : R) (W : R -> R) : Prop := forall t0 w, slides q l t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> w t = W t.
(* in a period, from a on, W goes forward to e, rests to b, goes backward to e' and rests; each of the last three may have no length *)
Definition course (a e b e' : R) (W : R -> R) : Prop := (a < e <= b /\ b <= e' <= a + 2 * PI) /\ (forall t, a < t < e -> 0 < W t) /\
  (forall t, e <= t <= b -> W t = 0) /\ (forall t, b < t < e' -> W t < 0) /\ (forall t, e' <= t <= a + 2 * PI -> W t = 0).

(* a chain of statements, each at hand or by lra *)
Ltac and_so := repeat match goal with |- _ /\ _ => split; [ solve [ assumption | lra ] | ] end; try assumption; try lra.
Lemma late_slide_unique q l W U : late_slide q l W -> late_slide q l U -> forall t, W t = U t.
Proof.
  intros [MW PW _] [_ PU DU] t. pose proof PI_RGT_0.
  pose proof (per_zero (fun t => W t - U t) (2 * PI) ltac:(lra) ltac:(intros s; cbv beta; now rewrite PW, PU) (DU 0 W (MW 0)) t). cbv beta in *. lra.
Qed.
Lemma reached_late q l W : (forall t0, slides q l t0 W) -> (forall t, W (t + 2 * PI) = W t) -> reached q l W -> late_slide q l W.
Proof. intros M P R. split; trivial. intros t0 w Hw. destruct (R t0 w Hw) as (t1 & _ & H). apply (lim_eventually _ t1). intros t Ht. rewrite H by trivial. ring. Qed.

(* ---- sines ---- *)
Lemma up f f' a b : a < b -> (forall c, a <= c <= b -> is_derive f c (f' c)) -> (forall c, a < c < b -> 0 < f' c) -> f a < f b.
Proof.
  intros H D P. destruct (MVT_cor2 f f' a b H) as (c & E & Hc). { intros; now apply is_derive_Reals, D. }
  specialize (P c Hc). nra.
Qed.
Lemma sin_2PI t : sin (t - 2 * PI) = sin t.
Proof. rewrite <- (sin_period (t - 2 * PI) 1). f_equal. simpl. ring. Qed.
Lemma sin_per t : sin (t + 2 * PI) = sin t.
Proof. rewrite <- (sin_2PI (t + 2 * PI)). f_equal. ring. Qed.
Lemma cos_per t : cos (t + 2 * PI) = cos t.
Proof. rewrite <- (cos_period t 1). f_equal. simpl. ring. Qed.
Lemma cos_asin_pow x : -1 <= x <= 1 -> cos (asin x) = sqrt (1 - x ^ 2).
Proof. intros H. rewrite cos_asin by trivial. f_equal. unfold Rsqr. ring. Qed.
Lemma x_cos_lt x : 0 < x < PI -> x * cos x < sin x.
Proof.
  intros h. enough (0 < sin x - x * cos x) by lra. replace 0 with (sin 0 - 0 * cos 0) by (rewrite sin_0; ring).
  apply (up (fun x => sin x - x * cos x) (fun x => x * sin x)); [ lra | intros; auto_derive; trivial; ring | ].
  intros c Hc. apply Rmult_lt_0_compat; [ lra | apply sin_gt_0; lra ].
Qed.
Lemma asin_range l : 0 < l < 1 -> 0 < asin l < PI / 2 /\ sin (asin l) = l.
Proof.
  intros hl. assert (e : sin (asin l) = l) by (apply sin_asin; lra). assert (b : - (PI / 2) < asin l < PI / 2) by (apply asin_bound_lt; lra).
  repeat split; trivial; try lra. apply Rnot_le_lt. intros k. pose proof (sin_incr_1 (asin l) 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). rewrite sin_0 in *. lra.
Qed.
(* where the drive exceeds l, and where it does not fall below - l *)
Lemma sin_above l x : 0 < l < 1 -> asin l < x < PI - asin l -> l < sin x.
Proof.
  intros hl H. destruct (asin_range l hl) as [[a b] e]. rewrite <- e. destruct (Rle_lt_dec x (PI / 2)).
  - apply sin_increasing_1; lra.
  - rewrite <- (sin_PI_x x). apply sin_increasing_1; lra.
Qed.
Lemma between_asin l x : 0 < l < 1 -> - (PI / 2) < x < 3 * (PI / 2) -> (l <= sin x -> asin l <= x <= PI - asin l) /\ (l < sin x -> asin l < x < PI - asin l).
Proof.
  intros hl hx. destruct (asin_range l hl) as [[a b] e]. split; intros H; split; (apply Rnot_lt_le || apply Rnot_le_lt); intros k.
  - pose proof (sin_increasing_1 x (asin l)). lra.
  - pose proof (sin_increasing_1 (PI - x) (asin l)). rewrite sin_PI_x in *. lra.
  - pose proof (sin_incr_1 x (asin l)). lra.
  - pose proof (sin_incr_1 (PI - x) (asin l)). rewrite sin_PI_x in *. lra.
Qed.
Lemma sin_less l t : 0 < l < 1 -> PI - asin l < t < 2 * PI + asin l -> sin t < l.
Proof.
  intros hl H. destruct (asin_range l hl) as [[a b] e]. rewrite <- e. destruct (Rle_lt_dec t (3 * (PI / 2))).
  - rewrite <- (sin_PI_x t). apply sin_increasing_1; lra.
  - rewrite <- (sin_2PI t). apply sin_increasing_1; lra.
Qed.
Lemma not_back m t : 0 < m < 1 -> - asin m < t < PI + asin m -> - m < sin t.
Proof.
  intros hm H. replace (sin t) with (- sin (t + PI)) by (rewrite neg_sin; ring). pose proof (sin_less m (t + PI) hm ltac:(lra)). lra.
Qed.
Lemma not_back_le m t : 0 < m < 1 -> - asin m <= t <= PI + asin m -> - m <= sin t.
Proof.
  intros hm H. destruct (asin_range m hm) as [_ e]. destruct (Req_dec t (- asin m)) as [-> | n]. rewrite sin_neg. lra.
  destruct (Req_dec t (PI + asin m)) as [-> | n2]. rewrite Rplus_comm, neg_sin. lra. left. apply not_back; trivial. lra.
Qed.

(* (51), (52) integrated: forward from a, backward from b *)
Definition fwd (l a t : R) : R := cos a - cos t - l * (t - a).
Definition bwd (m b t : R) : R := cos b - cos t + m * (t - b).
Lemma fwd_der l a t : is_derive (fwd l a) t (sin t - l). Proof. unfold fwd. auto_derive; trivial. ring. Qed.
Lemma bwd_der m b t : is_derive (bwd m b) t (sin t + m). Proof. unfold bwd. auto_derive; trivial. ring. Qed.
Lemma bwd_fwd m b t : bwd m b t = - fwd m (b - PI) (t - PI).
Proof. unfold bwd, fwd. rewrite !cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma fwd_cont l a t : continuity_pt (fwd l a) t. Proof. apply derivable_continuous_pt. exists (sin t - l). apply is_derive_Reals, fwd_der. Qed.
Lemma bwd_cont l a t : continuity_pt (bwd l a) t. Proof. apply derivable_continuous_pt. exists (sin t + l). apply is_derive_Reals, bwd_der. Qed.
Lemma fwd_0 l a : fwd l a a = 0. Proof. unfold fwd. ring. Qed.
Lemma bwd_0 m b : bwd m b b = 0. Proof. unfold bwd. ring. Qed.

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

(* forward from a to e, rest to b, backward to e', rest: a motion *)
Lemma two_slips l m a e b e' : 0 < l -> 0 < m -> a < e <= b -> b <= e' <= a + 2 * PI -> fwd l a e = 0 -> bwd m b e' = 0 ->
  (forall t, a < t < e -> 0 < fwd l a t) -> (forall t, b < t < e' -> bwd m b t < 0) ->
  (forall t, e <= t < b -> - m <= sin t <= l) -> (forall t, e' <= t < a + 2 * PI -> - m <= sin t <= l) ->
  exists W, (forall t0, line l m sin t0 W) /\ (forall t, W (t + 2 * PI) = W t) /\ course a e b e' W /\ forall t, a <= t <= e -> W t = fwd l a t.
Proof.
  intros hl hm h1 h2 z z' P N R1 R2. pose proof PI_RGT_0. set (g := glue e (fwd l a) (glue b (fun _ => 0) (glue e' (bwd m b) (fun _ => 0)))).
  assert (g0 : glue e' (bwd m b) (fun _ => 0) b = 0) by (unfold glue; destruct (Rlt_dec b e'); [ apply bwd_0 | trivial ]).
  assert (g1 : glue b (fun _ => 0) (glue e' (bwd m b) (fun _ => 0)) e = 0) by (destruct (Req_dec e b) as [-> | n]; [ rewrite glue_r; trivial; lra | apply glue_l; lra ]).
  assert (ge : g (a + 2 * PI) = 0) by (unfold g; now rewrite !glue_r by lra). assert (ga : g a = 0) by (unfold g; rewrite glue_l by lra; apply fwd_0).
  assert (A : arc l m sin a (a + 2 * PI) g).
  { apply arc_glue; [ lra | | apply arc_glue; [ lra | | apply arc_glue; [ lra | | | trivial ] | auto ] | lra ].
    - apply arc_fwd; try lra. intros t Ht. destruct (Req_dec t a) as [-> | ]. rewrite fwd_0; lra. left; apply P; lra.
    - apply arc_rest; try lra. trivial.
    - apply arc_bwd; try lra. intros t Ht. destruct (Req_dec t b) as [-> | ]. rewrite bwd_0; lra. left; apply N; lra.
    - apply arc_rest; try lra. trivial. }
  destruct (periodic_line l m sin a (2 * PI) g ltac:(lra) sin_per ltac:(lra) A) as (W & L & Q & on).
  exists W. split; [ trivial | split; [ trivial | split; [ split; [ lra | split; [ | split; [ | split ] ] ] | ] ] ]; intros t Ht; rewrite on by lra; unfold g.
  - rewrite glue_l by lra. now apply P.
  - rewrite glue_r by lra. destruct (Req_dec t b) as [-> | n]; [ rewrite glue_r; trivial; lra | apply glue_l; lra ].
  - rewrite glue_r, glue_r, glue_l by lra. now apply N.
  - now rewrite !glue_r by lra.
  - destruct (Req_dec t e) as [-> | n]; [ rewrite glue_r by lra; lra | apply glue_l; lra ].
Qed.

(* a rest with friction to spare is reached by all; a course that never rests attracts all *)
Lemma rest_reached q l W r s : (forall t0, slides q l t0 W) -> (forall t, W (t + 2 * PI) = W t) -> r < s -> (forall t, r <= t <= s -> W t = 0) -> - (q * l) < sin r < l ->
  late_slide q l W /\ reached q l W.
Proof.
  intros M P H Z S. pose proof PI_RGT_0. assert (R : reached q l W).
  { intros t0 w Hw. apply (captured l (q * l) (2 * PI) sin W ltac:(lra) M P r s); trivial. apply sin_per. apply continuity_sin. }
  split; trivial. now apply reached_late.
Qed.
Lemma course_attracts q l W a e b : 0 < q -> 0 < l -> (forall t0, slides q l t0 W) -> (forall t, W (t + 2 * PI) = W t) -> b < a + 2 * PI -> course a e b (a + 2 * PI) W -> late_slide q l W.
Proof.
  intros hq hl M P hb ([H1 H2] & F & _ & B & Z). pose proof PI_RGT_0. split; trivial. intros t0 w Hw.
  set (d := Rmin (e - a) (a + 2 * PI - b)). assert (d0 : 0 < d) by (apply Rmin_pos; lra). assert (d1 : d <= e - a /\ d <= a + 2 * PI - b) by (split; [ apply Rmin_l | apply Rmin_r ]).
  apply (line_attracts l (q * l) (2 * PI) sin W ltac:(lra) M P 1 a d) with (t0 := t0); trivial.
  - now apply Rmult_lt_0_compat.
  - intros t. apply Rabs_le, SIN_bound.
  - rewrite <- P. apply Z. lra.
  - intros t Ht. rewrite <- P. apply B. lra.
  - intros t Ht. apply F. lra.
Qed.

(* ---- how a forward slip rises and falls; from asin l on it ends once, before the next asin l ---- *)
Section Forward.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Lemma fwd_rises a s t : asin l <= s < t -> t <= PI - asin l -> fwd l a s < fwd l a t.
Proof.
  intros H1 H2. apply (up (fwd l a) (fun t => sin t - l)); [ lra | intros; apply fwd_der | ]. intros c Hc. pose proof (sin_above l c hl). lra.
Qed.
Lemma fwd_falls a s t : PI - asin l <= s < t -> t <= 2 * PI + asin l -> fwd l a t < fwd l a s.
Proof.
  intros H1 H2. apply Ropp_lt_cancel. apply (up (fun t => - fwd l a t) (fun t => - (sin t - l))); [ lra | intros; apply (is_derive_opp (fwd l a)), fwd_der | ].
  intros c Hc. pose proof (sin_less l c hl). lra.
Qed.
Lemma fwd_pos a b : asin l <= a -> a < b <= 2 * PI + asin l -> a <= PI - asin l -> 0 <= fwd l a b -> forall t, a < t < b -> 0 < fwd l a t.
Proof.
  intros H1 H2 H3 H4 t Ht. destruct (Rle_lt_dec t (PI - asin l)).
  - rewrite <- (fwd_0 l a). apply fwd_rises; lra.
  - apply Rle_lt_trans with (1 := H4). apply fwd_falls; lra.
Qed.
Lemma fwd_end : exists e, PI - asin l < e < 2 * PI + asin l /\ fwd l (asin l) e = 0 /\ (forall t, asin l < t < e -> 0 < fwd l (asin l) t) /\
  forall t, e < t <= 2 * PI + asin l -> fwd l (asin l) t < 0.
Proof.
  destruct (asin_range l hl) as [[a b] e]. pose proof PI_RGT_0.
  assert (H1 : 0 < fwd l (asin l) (PI - asin l)). { rewrite <- (fwd_0 l (asin l)). apply fwd_rises; lra. }
  assert (H2 : fwd l (asin l) (2 * PI + asin l) < 0). { unfold fwd. rewrite (Rplus_comm (2 * PI)), cos_per. nra. }
  destruct (IVT_cor (fwd l (asin l)) (PI - asin l) (2 * PI + asin l)) as [z [z1 z2]]; [ intros x; apply fwd_cont | lra | nra | ].
  assert (z <> PI - asin l) by (intros ->; lra). assert (z <> 2 * PI + asin l) by (intros ->; lra).
  exists z. repeat split; try lra. apply fwd_pos; lra. intros t Ht. rewrite <- z2. apply fwd_falls; lra.
Qed.
End Forward.
