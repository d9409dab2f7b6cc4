(* 2.4: the slips of the drive sin, forward from a and backward from b, and the periodic motion that they make with the
   rests between them. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn Line Formulas.
Open Scope R_scope.

(* (51), (52) with rest. l is lambda0; the velocity w is in units of A0/varpi, the time is the phase of the drive sin, in radians.
   «$w$ is a motion along the drive from the phase $t0$ on, with the friction $l$ forward and $q\,l$ backward» *)
Definition slides (q l t0 : R) (w : R -> R) : Prop := line l (eq50_lambda_minus q l) sin t0 w.
(* W has the drive's period, is a motion, and every motion tends to it. «$W$ is the motion at large times with the friction $l$ forward and
   $q\,l$ backward» *)
Record late_slide (q l : R) (W : R -> R) : Prop := {
  ls_slides : forall t0, slides q l t0 W;
  ls_per : forall t, W (t + 2 * PI) = W t;
  ls_drawn : forall t0 w, slides q l t0 w -> is_lim (fun t => w t - W t) p_infty 0 }.
(* «every motion with the friction $l$ forward and $q\,l$ backward is equal to $W$ from some time on» *)
Definition reached (q l : R) (W : R -> R) : Prop := forall t0 w, slides q l t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> w t = W t.
(* each but the slip forward may have no length. «$a<e\leq b\leq e'\leq a+2\pi$, and from $a$ on $W$ goes forward to $e$, rests to $b$, goes
   backward to $e'$, and rests to $a+2\pi$» *)
Definition course (a e b e' : R) (W : R -> R) : Prop := (a < e <= b /\ b <= e' <= a + 2 * PI) /\ (forall t, a < t < e -> 0 < W t) /\
  (forall t, e <= t <= b -> W t = 0) /\ (forall t, b < t < e' -> W t < 0) /\ (forall t, e' <= t <= a + 2 * PI -> W t = 0).

Lemma late_slide_unique q l W U : late_slide q l W -> late_slide q l U -> forall t, W t = U t.
Proof.
  intros [MW PW _] [_ PU DU] t. pose proof PI_RGT_0.
  pose proof (per_zero (fun t => W t - U t) (2 * PI) ltac:(lra) ltac:(intros s; cbv beta; now rewrite PW, PU) (DU 0 W (MW 0)) t). cbv beta in *. lra.
Qed.
(* ---- sines ---- *)
Lemma sin_2PI t : sin (t - 2 * PI) = sin t.
Proof. rewrite <- (sin_per (t - 2 * PI)). f_equal. ring. Qed.
Lemma x_cos_lt x : 0 < x < PI -> x * cos x < sin x.
Proof.
  intros h. enough (0 < sin x - x * cos x) by lra. replace 0 with (sin 0 - 0 * cos 0) by (rewrite sin_0; ring).
  apply (up (fun x => sin x - x * cos x) (fun x => x * sin x)); [ lra | intros; auto_derive; trivial; ring | ].
  intros c Hc. apply Rmult_lt_0_compat; [ lra | apply sin_gt_0; lra ].
Qed.
Lemma asin_closed l : 0 < l <= 1 -> 0 < asin l <= PI / 2 /\ sin (asin l) = l.
Proof. intros [h [k | ->]]; [ destruct (asin_range l); lra | ]. rewrite asin_1, sin_PI2. pose proof PI_RGT_0. lra. Qed.
Lemma asin_up a b : 0 < a < b -> b <= 1 -> asin a < asin b.
Proof.
  intros h1 h2. destruct (asin_closed a) as [ha ea]; [ lra | ]. destruct (asin_closed b) as [hb eb]; [ lra | ]. apply Rnot_le_lt. intros k.
  pose proof (sin_incr_1 (asin b) (asin a)). lra.
Qed.
(* where the drive does not fall below - m *)
Lemma not_back m t : 0 < m < 1 -> - asin m <= t <= PI + asin m -> - m <= sin t.
Proof.
  intros hm H. destruct (asin_range m hm) as [_ e]. destruct (Req_dec t (- asin m)) as [-> | n]; [ rewrite sin_neg; lra | ].
  destruct (Req_dec t (PI + asin m)) as [-> | n2]; [ rewrite Rplus_comm, neg_sin; lra | ]. pose proof (sin_less m (t + PI) hm ltac:(lra)).
  rewrite neg_sin in *. lra.
Qed.

(* (51), (52) integrated: forward from a, backward from b *)
Definition fwd (l a t : R) : R := cos a - cos t - l * (t - a).
Definition bwd (m b t : R) : R := cos b - cos t + m * (t - b).
Lemma fwd_der l a t : is_derive (fwd l a) t (sin t + - l). Proof. unfold fwd. auto_derive; trivial. ring. Qed.
Lemma bwd_der m b t : is_derive (bwd m b) t (sin t + m). Proof. unfold bwd. auto_derive; trivial. ring. Qed.
Lemma bwd_fwd m b t : bwd m b t = - fwd m (b - PI) (t - PI).
Proof. unfold bwd, fwd. rewrite !cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma fwd_0 l a : fwd l a a = 0. Proof. unfold fwd. ring. Qed.

(* ---- a forward slip from a, while the drive exceeds friction there, ends once before it can begin again: at e ---- *)
Definition ends l a e := (PI - asin l < e < 2 * PI + asin l /\ fwd l a e = 0) /\ (forall t, a < t < e -> 0 < fwd l a t) /\ forall t, e < t <= 2 * PI + asin l -> fwd l a t < 0.
Lemma end_is l a e t : ends l a e -> a < t <= 2 * PI + asin l -> (0 < fwd l a t <-> t < e) /\ (fwd l a t < 0 <-> e < t).
Proof.
  intros ((He & z) & P & N) Ht. destruct (total_order_T t e) as [[k | ->] | k]; [ specialize (P t ltac:(lra)) | | specialize (N t ltac:(lra)) ]; lra.
Qed.
Section Forward.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Lemma fwd_rises a s t : asin l <= s < t -> t <= PI - asin l -> fwd l a s < fwd l a t.
Proof. intros H1 H2. apply (up (fwd l a) (fun t => sin t + - l)); [ lra | intros; apply fwd_der | ]. intros c Hc. pose proof (sin_above l c hl).
  lra. Qed.
Lemma fwd_falls a s t : PI - asin l <= s < t -> t <= 2 * PI + asin l -> fwd l a t < fwd l a s.
Proof.
  intros H1 H2. apply Ropp_lt_cancel. apply (up (fun t => - fwd l a t) (fun t => - (sin t + - l))); [ lra | intros; apply (is_derive_opp (fwd l a)),
  fwd_der | ].
  intros c Hc. pose proof (sin_less l c hl). lra.
Qed.
Lemma slip_ends a : asin l <= a < PI - asin l -> exists e, ends l a e.
Proof.
  intros ha. destruct (asin_range l hl) as [[a0 b] _]. pose proof PI_RGT_0.
  assert (H1 : 0 < fwd l a (PI - asin l)) by (rewrite <- (fwd_0 l a); apply fwd_rises; lra).
  assert (H2 : fwd l a (2 * PI + asin l) < 0).
  { assert (k : fwd l a (asin l) <= fwd l a a) by (destruct ha as [[k | ->] ?]; [ left; apply fwd_rises | ]; lra). unfold fwd in *.
    rewrite Rplus_comm, cos_per. nra. }
  destruct (IVT_cor (fwd l a) (PI - asin l) (2 * PI + asin l)) as [z [z1 z2]]; [ intros x; eapply cont_of, fwd_der | lra | nra | ].
  assert (z <> PI - asin l /\ z <> 2 * PI + asin l) by (split; intros ->; lra). exists z. split; [ lra | ]. split; intros t Ht.
  - destruct (Rle_lt_dec t (PI - asin l)); [ rewrite <- (fwd_0 l a); apply fwd_rises; lra | rewrite <- z2; apply fwd_falls; lra ].
  - rewrite <- z2. apply fwd_falls; lra.
Qed.
Lemma ends_at a t : asin l <= a < PI - asin l -> a < t <= 2 * PI + asin l -> fwd l a t = 0 -> ends l a t.
Proof. intros ha ht z. destruct (slip_ends a ha) as [e He]. destruct (end_is l a e t He ht).
  destruct (total_order_T t e) as [[k | ->] | k]; trivial; lra. Qed.
End Forward.

(* forward from a to e, rest to b, backward to e', rest: a motion *)
Lemma arc_of l m p q w f : (forall t, is_derive w t (sin t + f t)) -> (forall t, p <= t < q -> dry l m (w t) (f t)) -> arc l m sin p q w.
Proof. intros D F. split; intros t Ht; [ now apply (cont_of _ _ _ (D t)) | exists (f t); split; [ auto | now apply rder_of ] ]. Qed.
Lemma two_slips l m a e b e' : 0 < l -> 0 < m -> a < e <= b -> b <= e' <= a + 2 * PI -> fwd l a e = 0 -> bwd m b e' = 0 ->
  (forall t, a < t < e -> 0 < fwd l a t) -> (forall t, b < t < e' -> bwd m b t < 0) ->
  (forall t, e <= t < b -> - m <= sin t <= l) -> (forall t, e' <= t < a + 2 * PI -> - m <= sin t <= l) ->
  exists W, (forall t0, line l m sin t0 W) /\ (forall t, W (t + 2 * PI) = W t) /\ course a e b e' W.
Proof.
  intros hl hm h1 h2 z z' P N R1 R2. pose proof PI_RGT_0. assert (b0 : bwd m b b = 0) by (unfold bwd; ring).
  set (g := glue e (fwd l a) (glue b (fun _ => 0) (glue e' (bwd m b) (fun _ => 0)))).
  assert (g0 : glue e' (bwd m b) (fun _ => 0) b = 0) by (unfold glue; now destruct (Rlt_dec b e')).
  assert (g1 : glue b (fun _ => 0) (glue e' (bwd m b) (fun _ => 0)) e = 0) by (destruct (Req_dec e b) as [-> | n]; [ now rewrite glue_r by lra |
  apply glue_l; lra ]).
  assert (ge : g (a + 2 * PI) = 0) by (unfold g; now rewrite !glue_r by lra). assert (ga : g a = 0) by (unfold g; rewrite glue_l by lra; apply fwd_0).
  assert (Z : forall t, is_derive (fun _ : R => 0) t (sin t + - sin t)) by (intros; auto_derive; trivial; ring).
  assert (A : arc l m sin a (a + 2 * PI) g).
  { apply arc_glue; [ lra | | apply arc_glue; [ lra | | apply arc_glue; [ lra | | | trivial ] | auto ] | lra ];
      [ apply (arc_of _ _ _ _ _ _ (fwd_der l a)) | apply (arc_of _ _ _ _ _ _ Z) | apply (arc_of _ _ _ _ _ _ (bwd_der m b)) |
      apply (arc_of _ _ _ _ _ _ Z) ]; intros t Ht; unfold dry.
    - assert (0 <= fwd l a t) by (destruct (proj1 Ht) as [k | <-]; [ left; apply P; lra | rewrite fwd_0; lra ]). lra.
    - specialize (R1 t Ht). lra.
    - assert (bwd m b t <= 0) by (destruct (proj1 Ht) as [k | <-]; [ left; apply N | ]; lra). lra.
    - specialize (R2 t Ht). lra. }
  destruct (periodic_line l m sin a (2 * PI) g ltac:(lra) sin_per ltac:(lra) A) as (W & L & Q & on).
  exists W. split; [ trivial | split; [ trivial | split; [ lra | split; [ | split; [ | split ] ] ] ] ]; intros t Ht; rewrite on by lra; unfold g.
  - rewrite glue_l by lra. now apply P.
  - rewrite glue_r by lra. destruct (Req_dec t b) as [-> | n]; [ now rewrite glue_r by lra | apply glue_l; lra ].
  - rewrite glue_r, glue_r, glue_l by lra. now apply N.
  - now rewrite !glue_r by lra.
Qed.
(* it is the motion at large times: where it rests before asin l it has friction to spare, and all reach it; where it never rests it attracts all *)
Lemma course_late q l a e b e' (m := q * l) : 1 <= q -> 0 < l < 1 -> asin l <= a < PI - asin l -> ends l a e ->
  e = b \/ (m < 1 /\ e <= b <= PI + asin m) -> b = e' \/ (m < 1 /\ PI + asin m <= b < 2 * PI - asin m /\ ends m (b - PI) (e' - PI)) -> (m < 1 -> 2 * PI - asin m <= e') ->
  (a = asin l /\ e' < a + 2 * PI) \/ (e = b /\ b < e' /\ e' = a + 2 * PI) -> exists W, late_slide q l W /\ course a e b e' W /\ (e' < a + 2 * PI -> reached q l W).
Proof.
  intros hq hl ha ((E & z) & P & N) F B R H. destruct (asin_range l hl) as [[a0 a1] _]. pose proof PI_RGT_0. assert (m0 : l <= m) by (unfold m; nra).
  assert (B' : b <= e' /\ bwd m b e' = 0 /\ forall t, b < t < e' -> bwd m b t < 0).
  { destruct B as [-> | (_ & hb & (? & zb) & Pb & _)]; [ unfold bwd; repeat split; intros; lra | ]. rewrite bwd_fwd. repeat split; try lra.
    intros t Ht. rewrite bwd_fwd. specialize (Pb (t - PI)). lra. }
  assert (Q : forall t, e <= t <= 2 * PI + asin l -> sin t <= l) by (intros t [k [j | ->]]; [ left; apply sin_less | rewrite Rplus_comm, sin_per;
  destruct (asin_range l hl) ]; lra).
  destruct (two_slips l m a e b e') as (W & L & Per & C); try tauto; try lra.
  { intros t Ht. destruct F as [-> | (m1 & hb)]; [ lra | ]. destruct (asin_range m ltac:(lra)). split; [ apply not_back | apply Q ]; lra. }
  { intros t Ht. split; [ | apply Q; lra ]. destruct (Rle_lt_dec 1 m); [ pose proof (SIN_bound t); lra | ]. rewrite <- sin_2PI.
    apply not_back; [ | destruct (asin_range m) ]; lra. }
  exists W. assert (RE : e' < a + 2 * PI -> reached q l W).
  { intros k t0 w Hw. destruct H as [[-> _] | H]; [ | lra ]. pose proof (Rmax_l e' (2 * PI)). pose proof (Rmax_r e' (2 * PI)).
    pose proof (Rmax_lub_lt e' (2 * PI) (2 * PI + asin l)).
    apply (captured l m (2 * PI) sin W ltac:(lra) L Per ((Rmax e' (2 * PI) + (2 * PI + asin l)) / 2) (2 * PI + asin l)); trivial; [ apply sin_per |
    lra | intros t Ht; apply C; lra | | apply continuity_sin ].
    split; [ rewrite <- sin_2PI; apply Rlt_trans with 0; [ lra | apply sin_gt_0; lra ] | apply sin_less; lra ]. }
  split; [ | split; trivial ]. split; trivial. intros t0 w Hw. destruct (Rlt_le_dec e' (a + 2 * PI)) as [k | k].
  - destruct (RE k t0 w Hw) as (t1 & _ & h). apply (lim_eventually _ t1). intros t Ht. rewrite h by trivial. ring.
  - destruct C as (_ & CF & _ & CB & CZ). pose proof (Rmin_l (e - a) (a + 2 * PI - b)). pose proof (Rmin_r (e - a) (a + 2 * PI - b)).
    assert (d0 : 0 < Rmin (e - a) (a + 2 * PI - b)) by (apply Rmin_pos; lra). set (d := Rmin _ _) in *.
    apply (line_attracts l m (2 * PI) sin W ltac:(lra) L Per 1 a d) with (t0 := t0); trivial; try lra; try (intros t Ht; apply CF; lra).
    + intros t. apply Rabs_le, SIN_bound.
    + rewrite <- Per. apply CZ. lra.
    + intros t Ht. rewrite <- Per. apply CB. lra.
Qed.

(* what a course does, at any phase *)
Section Course.
Variables (W : R -> R) (a e b e' : R).
Hypothesis P : forall t, W (t + 2 * PI) = W t.
Hypothesis C : course a e b e' W.
Lemma fold_phase p t : exists n, p <= t - IZR n * (2 * PI) < p + 2 * PI /\ forall s, W (s - IZR n * (2 * PI)) = W s.
Proof. pose proof PI_RGT_0. destruct (per_spec p (2 * PI) ltac:(lra) t) as [n Hn]. exists n. split; [ lra | ]. intros. now apply shift_Z. Qed.
Lemma course_back : (exists t, W t < 0) <-> b < e'.
Proof.
  destruct C as ([C1 C2] & F & Z & B & Z'). split; [ | intros h; exists ((b + e') / 2); apply B; lra ]. intros [t Ht]. apply Rnot_le_lt. intros k.
  destruct (fold_phase a t) as (n & hn & S). rewrite <- S in Ht. set (s := t - IZR n * (2 * PI)) in *. pose proof (Z' (a + 2 * PI)). rewrite P in *.
  destruct (Req_dec s a) as [-> | ]; [ lra | ]. specialize (F s). specialize (Z s). specialize (Z' s). lra.
Qed.
Lemma course_rests : (exists s d, 0 < d /\ forall t, s <= t <= s + d -> W t = 0) <-> e < b \/ e' < a + 2 * PI.
Proof.
  destruct C as ([C1 C2] & F & Z & B & Z'). split.
  - intros (t & d & hd & R). apply Classical_Prop.NNPP. intros no. destruct (fold_phase a t) as (n & hn & S). set (s := t - IZR n * (2 * PI)) in *.
    assert (R' : forall u, s <= u <= s + d -> W u = 0) by (intros u hu; replace u with (u + IZR n * (2 * PI) - IZR n * (2 * PI)) by ring; rewrite S;
    apply R; unfold s in hu; lra).
    set (q := if Rlt_le_dec s e then e else a + 2 * PI). assert (s < q) by (unfold q; destruct Rlt_le_dec; lra).
    assert (0 < Rmin d (q - s)) by (apply Rmin_pos; lra).
    pose proof (Rmin_l d (q - s)). pose proof (Rmin_r d (q - s)). specialize (R' (s + Rmin d (q - s) / 2) ltac:(lra)). unfold q in *.
    destruct Rlt_le_dec; [ specialize (F (s + Rmin d (e - s) / 2)) | specialize (B (s + Rmin d (a + 2 * PI - s) / 2)) ]; lra.
  - intros [k | k]; [ exists e, (b - e) | exists e', (a + 2 * PI - e') ]; (split; [ lra | intros t Ht; first [ apply Z; lra | apply Z'; lra ] ]).
Qed.
End Course.
