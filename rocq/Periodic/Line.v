(* Motion along a line with a friction that differs forward and backward: the law; motions put together from arcs; when
   every motion is drawn to a periodic one. Time is the phase of the drive, so that no shifts are needed. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn.
Open Scope R_scope.

(* the force of friction at the velocity w: - l forward, m backward, anything between at rest *)
Definition dry (l m w f : R) : Prop := - l <= f <= m /\ (0 < w -> f = - l) /\ (w < 0 -> f = m).

(* (51), (52) with rest, for any drive a: a motion along the line from t0 on *)
Record line (l m : R) (a : R -> R) (t0 : R) (w : R -> R) : Prop := {
  l_c : forall t, t0 < t -> continuity_pt w t;
  l_law : forall t, t0 <= t -> exists f, dry l m (w t) f /\ rder w t (a t + f) }.

(* with l = m it is the motion of the plane, along its first axis *)
Lemma dry_coulomb k w f : 0 <= k -> dry k k w f -> coulomb k w 0 f 0.
Proof.
  intros hk (D & P & N). split; [ nra | ]. rewrite nrm_x. unfold Rabs. destruct (Rcase_abs w) as [n | n]. rewrite N by lra; ring.
  destruct n as [n | n]. rewrite P by lra; ring. rewrite n; ring.
Qed.
Theorem line_isotropic k Ax v : 0 <= k ->
  (line k k (fun t => - Ax t) 0 v <-> motion k Ax (fun _ => 0) v (fun _ => 0)).
Proof.
  intros Hk. split.
  - intros [c L]. split; trivial. intros; cont. intros t Ht. destruct (L t Ht) as (f & D & R). exists f, 0. split; [ now apply dry_coulomb | split ].
    + eapply rder_eq; [ exact R | ring ].
    + eapply rder_eq; [ rd | ring ].
  - intros [c _ L]. split; trivial. intros t Ht. destruct (L t Ht) as (fx & fy & C & R & _). exists fx.
    destruct (coulomb_slip _ _ _ _ _ Hk C) as [E _]. destruct C as [B _]. rewrite nrm_x in E.
    split; [ | eapply rder_eq; [ exact R | ring ] ]. split; [ nra | split; intros p ].
    + rewrite Rabs_pos_eq in E by lra. nra.
    + rewrite Rabs_left in E by lra. nra.
Qed.

(* friction never drives two velocities apart *)
Lemma dry_mono l m w f u g : dry l m w f -> dry l m u g -> (w - u) * (f - g) <= 0.
Proof.
  intros (A & B & C) (D & E & F). destruct (Rtotal_order w u) as [k | [-> | k]]; [ | lra | ].
  - destruct (Rlt_le_dec 0 u). rewrite E by lra. nra. destruct (Rlt_le_dec w 0). rewrite C by lra. nra. lra.
  - destruct (Rlt_le_dec 0 w). rewrite B by lra. nra. destruct (Rlt_le_dec u 0). rewrite F by lra. nra. lra.
Qed.
Theorem line_contraction l m a t0 w u : line l m a t0 w -> line l m a t0 u ->
  forall s t, t0 <= s <= t -> Rabs (w t - u t) <= Rabs (w s - u s).
Proof.
  intros [cw W] [cu U] s t Hst. apply Rsqr_le_abs_0. rewrite !Rsqr_pow2.
  apply (rder_decr (fun t => (w t - u t) ^ 2)); [ lra | | ]; intros x Hx.
  - cont; [ apply cw | apply cu ]; lra.
  - destruct (W x) as (f & F & X); [ lra | ]. destruct (U x) as (g & G & Y); [ lra | ]. eexists. split. rd. simpl.
    pose proof (dry_mono _ _ _ _ _ _ F G). lra.
Qed.

(* ---- motions in pieces ---- *)
Definition arc (l m : R) (a : R -> R) (p q : R) (w : R -> R) : Prop :=
  (forall t, p <= t <= q -> continuity_pt w t) /\ (forall t, p <= t < q -> exists f, dry l m (w t) f /\ rder w t (a t + f)).
Definition glue (q : R) (u v : R -> R) t := if Rlt_dec t q then u t else v t.
Lemma glue_l q u v t : t < q -> glue q u v t = u t. Proof. intros k. unfold glue. destruct (Rlt_dec t q); [ trivial | lra ]. Qed.
Lemma glue_r q u v t : q <= t -> glue q u v t = v t. Proof. intros k. unfold glue. destruct (Rlt_dec t q); [ lra | trivial ]. Qed.
Lemma arc_glue l m a p q r u v : p <= q <= r -> arc l m a p q u -> arc l m a q r v -> u q = v q -> arc l m a p r (glue q u v).
Proof.
  intros H [cu U] [cv V] e. split.
  - intros t Ht. destruct (total_order_T t q) as [[k | ->] | k].
    + apply (cont_glue _ u u t (q - t)); [ lra | | | apply cu; lra | apply cu; lra ]; intros s Hs; apply glue_l; lra.
    + apply (cont_glue _ u v q 1); [ lra | | | apply cu; lra | apply cv; lra ]; intros s Hs; [ | apply glue_r; lra ].
      destruct (Req_dec s q) as [-> | ]; [ rewrite glue_r by lra; auto | apply glue_l; lra ].
    + apply (cont_glue _ v v t (t - q)); [ lra | | | apply cv; lra | apply cv; lra ]; intros s Hs; apply glue_r; lra.
  - intros t Ht. destruct (Rlt_le_dec t q) as [k | k].
    + destruct (U t) as (f & F & X); [ lra | ]. exists f. rewrite glue_l by trivial. split; trivial.
      apply (rder_near _ u t _ (q - t)); [ lra | | trivial ]. intros s Hs. rewrite glue_l by lra. trivial.
    + destruct (V t) as (f & F & X); [ lra | ]. exists f. rewrite glue_r by trivial. split; trivial.
      apply (rder_near _ v t _ 1); [ lra | | trivial ]. intros s Hs. rewrite glue_r by lra. trivial.
Qed.
(* a period that ends where it began, repeated for ever, is a motion *)
Lemma periodic_line l m a p T g : 0 < T -> (forall t, a (t + T) = a t) -> g (p + T) = g p -> arc l m a p (p + T) g ->
  exists W, (forall t0, line l m a t0 W) /\ (forall t, W (t + T) = W t) /\ forall t, p <= t <= p + T -> W t = g t.
Proof.
  intros hT ha hg [c L]. assert (on : forall n t, p + IZR n * T <= t < p + (IZR n + 1) * T -> per p T g t = g (t - IZR n * T)) by (intros; now apply per_on).
  exists (per p T g). split; [ | split; [ intros; now apply per_per | ] ].
  - intros t0. split; intros t _.
    + apply (continuity_pt_ext (fun t => per p T g (p + (t - p)))); [ intros; f_equal; ring | ].
      apply (cont_shift (fun s => per p T g (p + s)) p), (tiles_cont T hT _ (fun _ s => g (p + s))).
      * intros n s Hs. rewrite (on n) by lra. f_equal. ring.
      * intros _ s Hs. apply cont_phase, c. lra.
      * intros _. rewrite Rplus_0_r. trivial.
    + destruct (per_spec p T hT t) as [n Hn]. destruct (L (t - IZR n * T)) as (f & F & X); [ lra | ]. exists f. rewrite (on n) by lra. split; trivial.
      rewrite (shift_Z T a ha) in X. apply (rder_near _ (fun s => g (s - IZR n * T)) t _ (p + (IZR n + 1) * T - t)); [ lra | intros s Hs; symmetry; apply on; lra | ].
      now apply rder_shift.
  - intros t Ht. destruct (Req_dec t (p + T)) as [-> | ne].
    + rewrite (on 1%Z) by lra. rewrite hg. f_equal. ring.
    + rewrite (on 0%Z) by lra. f_equal. ring.
Qed.

(* so is, in the plane, an arc of half a period that ends with the opposite of its beginning *)
Lemma half_arc l h T g : 0 <= l -> 0 < T -> (forall t, h (t + T) = - h t) -> g T = - g 0 -> arc l l h 0 T g -> forall p, moves l h p (fun t => ext T g (p + t)) (fun _ => 0).
Proof.
  intros hl hT ha hg [c L] p. apply (half_period_from l T (fun t => - h t) g); trivial; [ intros t; rewrite ha; ring | ].
  intros t Ht. destruct (L t Ht) as (f & F & X). exists f. split; [ now apply dry_coulomb | eapply rder_eq; [ exact X | ring ] ].
Qed.

(* while it moves against friction with c to spare, its speed falls at the rate c at least *)
Lemma speed_falls l m a t0 w c x y : line l m a t0 w -> t0 <= x <= y -> (forall z, x <= z <= y -> w z <> 0 /\ - m + c <= a z <= l - c) ->
  Rabs (w y) + c * (y - x) <= Rabs (w x).
Proof.
  intros Hw H on. rewrite <- !nrm_x. enough (nrm (w y) 0 + c * y <= nrm (w x) 0 + c * x) by lra.
  apply (rder_decr (fun y => nrm (w y) 0 + c * y)); [ lra | | ]; intros z Hz.
  - cont. apply (l_c _ _ _ _ _ Hw). lra.
  - destruct (l_law _ _ _ _ _ Hw z) as (f & (F1 & F2 & F3) & X); [ lra | ]. destruct (on z) as [N B]; [ lra | ].
    eexists. split. rd. rewrite nrm_x. apply Rabs_no_R0. trivial. rewrite nrm_x.
    destruct (Rdichotomy _ _ N) as [k | k].
    + rewrite (Rabs_left _ k), F3 by trivial. match goal with |- ?g <= 0 => replace g with (- (a z + m) + c) by (field; lra) end. lra.
    + rewrite (Rabs_right (w z)), F2 by lra. match goal with |- ?g <= 0 => replace g with (a z - l + c) by (field; lra) end. lra.
Qed.

Section Drawn.
Variables (l m T : R) (a W : R -> R).
Hypothesis hT : 0 < T.
Hypothesis HW : forall t0, line l m a t0 W.
Hypothesis hW : forall t, W (t + T) = W t.
(* a periodic motion that rests, with friction to spare at one moment of it, is reached by every motion *)
Theorem captured r s : (forall t, a (t + T) = a t) -> r < s -> (forall t, r <= t <= s -> W t = 0) -> - m < a r < l -> continuity_pt a r ->
  forall t0 w, line l m a t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> w t = W t.
Proof.
  intros ha hrs rest spare ca t0 w Hw. destruct (spare_lasts a m l r ca spare) as (b' & c & b0 & c0 & near). set (b := Rmin b' (s - r)).
  assert (bb : 0 < b) by (apply Rmin_pos; lra). assert (b1 : b <= b' /\ b <= s - r) by (split; [ apply Rmin_l | apply Rmin_r ]). clearbody b.
  assert (C : forall s t, t0 <= s <= t -> Rabs (w t - W t) <= Rabs (w s - W s)) by (apply (line_contraction l m a t0); auto).
  destruct (drain_windows (fun t => Rabs (w t - W t)) t0 r T b (c * b) 0) as (t1 & t1a & Ht1); try lra; trivial.
  - apply Rmult_lt_0_compat; lra.
  - intros; apply Rabs_pos.
  - intros n x Hx K. assert (on : forall y, x <= y <= x + b -> W y = 0 /\ - m + c <= a y <= l - c).
    { intros y Hy. rewrite <- (shift_Z T W hW n y), <- (shift_Z T a ha n y). split; [ apply rest | apply near ]; unfold x in *; lra. } clearbody x.
    assert (De : forall y, x <= y <= x + b -> Rabs (w y - W y) = Rabs (w y)) by (intros y Hy; destruct (on y Hy) as [-> _]; f_equal; ring).
    rewrite !De in * by lra. enough (Rabs (w (x + b)) + c * (x + b - x) <= Rabs (w x)) by lra. apply (speed_falls l m a t0); trivial; [ lra | ].
    intros y Hy. split; [ | now apply on ]. intros e. pose proof (C y (x + b) ltac:(lra)) as Q. rewrite !De, e, Rabs_R0 in Q by lra. lra.
  - exists t1. split; trivial. intros t Ht. enough (w t - W t = 0) by lra. now apply abs_zero, Ht1.
Qed.

(* one goes forward while the other goes back: friction brings them together at the rate l + m *)
Lemma opposite t0 w u p q : line l m a t0 w -> line l m a t0 u -> t0 <= p <= q -> (forall y, p <= y < q -> 0 < w y /\ u y < 0) ->
  (w q - u q) + (l + m) * (q - p) <= w p - u p.
Proof.
  intros [cw Lw] [cu Lu] H S. enough ((w q - u q) + (l + m) * q <= (w p - u p) + (l + m) * p) by lra.
  apply (rder_decr (fun t => (w t - u t) + (l + m) * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply cw | apply cu ]; lra.
  - destruct (Lw t) as (f & (_ & F & _) & X); [ lra | ]. destruct (Lu t) as (g & (_ & _ & G) & Y); [ lra | ]. destruct (S t) as [s1 s2]; [ lra | ].
    eexists. split. rd. rewrite F, G by trivial. lra.
Qed.
Lemma line_rises B t0 w x y : (forall t, Rabs (a t) <= B) -> line l m a t0 w -> t0 <= x <= y -> w y - w x <= (B + m) * (y - x).
Proof.
  intros hB [c L] H. enough (w y - (B + m) * y <= w x - (B + m) * x) by lra.
  apply (rder_decr (fun t => w t - (B + m) * t)); [ lra | intros t Ht; cont; apply c; lra | intros t Ht ].
  destruct (L t) as (f & (F & _) & X); [ lra | ]. eexists. split. rd. specialize (hB t). apply Rabs_le_between in hB. lra.
Qed.
(* one that passes from backward to forward at once attracts every motion *)
Theorem line_attracts B z d : 0 < l -> 0 < m -> (forall t, Rabs (a t) <= B) -> 0 < d -> W z = 0 -> (forall t, z - d < t < z -> W t < 0) -> (forall t, z < t < z + d -> 0 < W t) ->
  forall t0 w, line l m a t0 w -> is_lim (fun t => w t - W t) p_infty 0.
Proof.
  intros hl hm hB hd zero before after t0 w Hw. apply lim_zero. intros e he. set (L := B + m).
  assert (Lp : 0 < L) by (unfold L; pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra).
  assert (e0 : 0 < e / (4 * L)) by (apply Rdiv_lt_0_compat; lra). set (h := Rmin (d / 2) (e / (4 * L))).
  assert (hh : 0 < h /\ h < d /\ L * h <= e / 4).
  { unfold h. pose proof (Rmin_l (d / 2) (e / (4 * L))). pose proof (Rmin_r (d / 2) (e / (4 * L))). split; [ apply Rmin_pos; lra | split; [ lra | ] ].
    replace (e / 4) with (L * (e / (4 * L))) by (field; lra). apply Rmult_le_compat_l; lra. } clearbody h.
  assert (C : forall s t, t0 <= s <= t -> Rabs (w t - W t) <= Rabs (w s - W s)) by (apply (line_contraction l m a t0); auto).
  destruct (drain_windows (fun t => Rabs (w t - W t)) t0 (z - h) T (2 * h) ((l + m) * (h / 2)) e) as (t1 & _ & Ht1); try lra.
  - apply Rmult_lt_0_compat; lra.
  - intros; apply Rabs_pos.
  - exact C.
  - intros n y0 Hy0. unfold y0 in *. clear y0. set (x := z + IZR n * T). replace (z - h + IZR n * T) with (x - h) in * by (unfold x; ring).
    replace (x - h + 2 * h) with (x + h) by ring. intros K.
    assert (on : forall y, W (y - IZR n * T) = W y) by (intros; apply shift_Z; trivial).
    assert (Wx : W x = 0) by (rewrite <- on; unfold x; replace (z + IZR n * T - IZR n * T) with z by ring; trivial).
    assert (Wb : forall y, x - h <= y < x -> W y < 0) by (intros y Hy; rewrite <- on; apply before; unfold x in *; lra).
    assert (Wa : forall y, x < y <= x + h -> 0 < W y) by (intros y Hy; rewrite <- on; apply after; unfold x in *; lra). clearbody x.
    assert (Lip : forall f p q, line l m a t0 f -> x - h <= p <= q -> q <= x + h -> q - p <= h -> f q - f p <= e / 4).
    { intros f p q F Hp Hq hpq. pose proof (line_rises B t0 f p q hB F ltac:(lra)) as Q. fold L in Q. assert (L * (q - p) <= L * h) by (apply Rmult_le_compat_l; lra). lra. }
    assert (far : forall y, x - h <= y <= x + h -> e < Rabs (w y - W y)) by (intros y Hy; pose proof (C y (x + h) ltac:(lra)); lra).
    destruct (Rle_lt_dec 0 (w x)) as [s | s].
    + assert (P : forall y, x - h <= y < x -> 0 < w y /\ W y < 0).
      { intros y Hy. specialize (Wb y Hy). split; trivial. pose proof (Lip w y x Hw ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (Lip W y x (HW t0) ltac:(lra) ltac:(lra) ltac:(lra)).
        specialize (far y ltac:(lra)). apply Rnot_le_lt. intros q. unfold Rabs in far. destruct (Rcase_abs (w y - W y)); lra. }
      pose proof (opposite t0 w W (x - h) x Hw (HW t0) ltac:(lra) P). destruct (P (x - h) ltac:(lra)). pose proof (C x (x + h) ltac:(lra)).
      rewrite (Rabs_pos_eq (w x - W x)) in * by lra. rewrite (Rabs_pos_eq (w (x - h) - W (x - h))) by lra. assert (0 < (l + m) * (h / 2)) by (apply Rmult_lt_0_compat; lra). lra.
    + assert (P : forall y, x <= y <= x + h -> w y < 0).
      { intros y Hy. pose proof (Lip w x y Hw ltac:(lra) ltac:(lra) ltac:(lra)). specialize (far y ltac:(lra)).
        destruct (Req_dec y x) as [-> | ne]; trivial. pose proof (Lip W x y (HW t0) ltac:(lra) ltac:(lra) ltac:(lra)). specialize (Wa y ltac:(lra)).
        apply Rnot_le_lt. intros q. unfold Rabs in far. destruct (Rcase_abs (w y - W y)); lra. }
      pose proof (opposite t0 W w (x + h / 2) (x + h) (HW t0) Hw ltac:(lra)) as Q.
      assert (A : forall y, x + h / 2 <= y < x + h -> 0 < W y /\ w y < 0) by (intros y Hy; split; [ apply Wa | apply P ]; lra). specialize (Q A).
      pose proof (C (x - h) (x + h / 2) ltac:(lra)) as E. pose proof (P (x + h) ltac:(lra)). pose proof (Wa (x + h) ltac:(lra)).
      pose proof (P (x + h / 2) ltac:(lra)). pose proof (Wa (x + h / 2) ltac:(lra)). rewrite Rabs_left in E by lra. rewrite Rabs_left by lra. lra.
  - exists t1. intros t Ht. apply Ht1, Ht.
Qed.
End Drawn.
