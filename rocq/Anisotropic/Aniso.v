(* 2.4: friction on a line that differs forward and backward *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic.
Open Scope R_scope.

(* the force of friction at the velocity w: - l forward, m backward, anything between at rest *)
Definition dry (l m w f : R) : Prop := - l <= f <= m /\ (0 < w -> f = - l) /\ (w < 0 -> f = m).

(* (51), (52) with rest: a motion along the line from t0 on, under the pull a *)
Record line (l m : R) (a : R -> R) (t0 : R) (w : R -> R) : Prop := {
  l_c : forall t, t0 < t -> continuity_pt w t;
  l_law : forall t, t0 <= t -> exists f, dry l m (w t) f /\ rder w t (a t + f) }.

(* with l = m it is the motion of the plane, along its first axis *)
Theorem line_isotropic k Ax v : 0 <= k ->
  (line k k (fun t => - Ax t) 0 v <-> motion k Ax (fun _ => 0) v (fun _ => 0)).
Proof.
  intros Hk. split.
  - intros [c L]. split; trivial. intros; cont. intros t Ht. destruct (L t Ht) as (f & [D [P N]] & R). exists f, 0. split; [ split | split ].
    + nra.
    + unfold nrm. replace (v t ^ 2 + 0 ^ 2) with (Rsqr (v t)) by (unfold Rsqr; ring). rewrite sqrt_Rsqr_abs. unfold Rabs.
      destruct (Rcase_abs (v t)) as [n | n]. rewrite N by lra; ring. destruct n as [n | n]. rewrite P by lra; ring. rewrite n; ring.
    + eapply rder_eq; [ exact R | ring ].
    + eapply rder_eq; [ rd | ring ].
  - intros [c _ L]. split; trivial. intros t Ht. destruct (L t Ht) as (fx & fy & C & R & _). exists fx.
    destruct (coulomb_slip _ _ _ _ _ Hk C) as [E _]. destruct C as [B _]. pose proof (nrm_sq (v t) 0) as N. pose proof (nrm_pos (v t) 0).
    split; [ | eapply rder_eq; [ exact R | ring ] ]. split; [ nra | split ].
    + intros p. assert (e : nrm (v t) 0 = v t) by nra. rewrite e in E. nra.
    + intros p. assert (e : nrm (v t) 0 = - v t) by nra. rewrite e in E. nra.
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
Corollary line_uniqueness l m a t0 w u : line l m a t0 w -> line l m a t0 u -> w t0 = u t0 -> forall t, t0 <= t -> w t = u t.
Proof.
  intros W U e t Ht. pose proof (line_contraction _ _ _ _ _ _ W U t0 t ltac:(lra)) as H.
  replace (w t0 - u t0) with 0 in H by lra. rewrite Rabs_R0 in H. pose proof (Rabs_pos (w t - u t)).
  destruct (Req_dec (w t - u t) 0); [ lra | ]. pose proof (Rabs_pos_lt _ H1). lra.
Qed.
Lemma line_later l m a t0 t1 w : t0 <= t1 -> line l m a t0 w -> line l m a t1 w.
Proof. intros H [c L]. split; intros; [ apply c | apply L ]; lra. Qed.

(* ---- motions in pieces ---- *)
Definition arc (l m : R) (a : R -> R) (p q : R) (w : R -> R) : Prop :=
  (forall t, p <= t <= q -> continuity_pt w t) /\ (forall t, p <= t < q -> exists f, dry l m (w t) f /\ rder w t (a t + f)).
Definition glue (q : R) (u v : R -> R) t := if Rlt_dec t q then u t else v t.

Lemma arc_glue l m a p q r u v : p < q < r -> arc l m a p q u -> arc l m a q r v -> u q = v q -> arc l m a p r (glue q u v).
Proof.
  intros H [cu U] [cv V] e.
  assert (L : forall t, t < q -> glue q u v t = u t) by (intros t k; unfold glue; destruct (Rlt_dec t q); [ trivial | lra ]).
  assert (R : forall t, q <= t -> glue q u v t = v t) by (intros t k; unfold glue; destruct (Rlt_dec t q); [ lra | trivial ]).
  split.
  - intros t Ht. destruct (total_order_T t q) as [[k | ->] | k].
    + apply (cont_glue _ u u t (q - t)); [ lra | | | apply cu; lra | apply cu; lra ]; intros s Hs; apply L; lra.
    + apply (cont_glue _ u v q 1); [ lra | | | apply cu; lra | apply cv; lra ]; intros s Hs; [ | apply R; lra ].
      destruct (Req_dec s q) as [-> | ]; [ rewrite R by lra; auto | apply L; lra ].
    + apply (cont_glue _ v v t (t - q)); [ lra | | | apply cv; lra | apply cv; lra ]; intros s Hs; apply R; lra.
  - intros t Ht. destruct (Rlt_le_dec t q) as [k | k].
    + destruct (U t) as (f & F & X); [ lra | ]. exists f. rewrite L by trivial. split; trivial.
      apply (rder_near _ u t _ (q - t)); [ lra | | trivial ]. intros s Hs. rewrite L by lra. trivial.
    + destruct (V t) as (f & F & X); [ lra | ]. exists f. rewrite R by trivial. split; trivial.
      apply (rder_near _ v t _ 1); [ lra | | trivial ]. intros s Hs. rewrite R by lra. trivial.
Qed.

(* a period that ends where it began, repeated for ever *)
Definition per (p T : R) (g : R -> R) t := g (t - IZR (floor T (t - p)) * T).
Section Per.
Variables (l m p T : R) (a g : R -> R).
Hypothesis hT : 0 < T.
Hypothesis ha : forall t, a (t + T) = a t.
Hypothesis hg : g (p + T) = g p.
Hypothesis A : arc l m a p (p + T) g.
Lemma per_on n t : p + IZR n * T <= t < p + (IZR n + 1) * T -> per p T g t = g (t - IZR n * T).
Proof. intros H. unfold per. replace (floor T (t - p)) with n; trivial. symmetry. apply floor_spec; trivial. lra. Qed.
Lemma per_spec t : exists n, p + IZR n * T <= t < p + (IZR n + 1) * T.
Proof. exists (floor T (t - p)). pose proof (proj2 (floor_spec T hT (t - p) _) eq_refl). lra. Qed.
Lemma per_per t : per p T g (t + T) = per p T g t.
Proof.
  destruct (per_spec t) as [n Hn]. rewrite (per_on n t Hn), (per_on (n + 1) (t + T)) by (rewrite plus_IZR; lra).
  f_equal. rewrite plus_IZR. ring.
Qed.
Lemma shift_Z (b : R -> R) : (forall t, b (t + T) = b t) -> forall n t, b (t - IZR n * T) = b t.
Proof.
  intros hb n t.
  assert (P : forall k : nat, forall t, b (t + INR k * T) = b t).
  { induction k as [ | k IH ]; intros u. f_equal. simpl. ring. rewrite S_INR. replace (u + (INR k + 1) * T) with (u + INR k * T + T) by ring. rewrite hb. apply IH. }
  destruct (Z_le_dec 0 n) as [q | q].
  - rewrite <- (P (Z.to_nat n) (t - IZR n * T)). f_equal. rewrite INR_IZR_INZ, Z2Nat.id by lia. ring.
  - rewrite <- (P (Z.to_nat (- n)) t). f_equal. rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia. ring.
Qed.
Theorem per_line t0 : line l m a t0 (per p T g).
Proof.
  destruct A as [c L]. split.
  - intros t _. destruct (per_spec t) as [n Hn].
    assert (C : forall k, p <= t - IZR k * T <= p + T -> continuity_pt (fun s => g (s - IZR k * T)) t) by (intros; apply cont_shift, c; trivial).
    destruct (Req_dec t (p + IZR n * T)) as [e | ne].
    + apply (cont_glue _ (fun s => g (s - IZR (n - 1) * T)) (fun s => g (s - IZR n * T)) t T); trivial.
      * intros s Hs. destruct (Req_dec s t) as [-> | k].
        -- rewrite (per_on n) by lra. rewrite minus_IZR. replace (t - IZR n * T) with p by lra. rewrite <- hg. f_equal. lra.
        -- apply per_on. rewrite minus_IZR. lra.
      * intros s Hs. apply per_on. lra.
      * apply C. rewrite minus_IZR. lra.
      * apply C. lra.
    + apply (cont_glue _ (fun s => g (s - IZR n * T)) (fun s => g (s - IZR n * T)) t (Rmin (t - p - IZR n * T) (p + (IZR n + 1) * T - t))).
      * apply Rmin_pos; lra.
      * intros s Hs. apply per_on. pose proof (Rmin_l (t - p - IZR n * T) (p + (IZR n + 1) * T - t)). lra.
      * intros s Hs. apply per_on. pose proof (Rmin_r (t - p - IZR n * T) (p + (IZR n + 1) * T - t)). lra.
      * apply C. lra.
      * apply C. lra.
  - intros t _. destruct (per_spec t) as [n Hn]. destruct (L (t - IZR n * T)) as (f & F & X); [ lra | ].
    exists f. rewrite (per_on n) by lra. split; trivial.
    apply (rder_near _ (fun s => g (s - IZR n * T)) t _ (p + (IZR n + 1) * T - t)); [ lra | intros s Hs; symmetry; apply per_on; lra | ].
    rewrite (shift_Z a ha) in X. apply rder_shift, X.
Qed.
End Per.

Lemma nat_above x : exists n, x < INR n.
Proof.
  destruct (Rle_lt_dec 0 x) as [k | k]; [ | exists 0%nat; exact k ]. destruct (nfloor_ex x k) as [n Hn].
  exists (S n). rewrite S_INR. lra.
Qed.
(* ---- what falls by c in each time T, or is below e ---- *)
Lemma drain (D : R -> R) t0 T c e : 0 < T -> 0 < c -> (forall t, t0 <= t -> 0 <= D t) -> (forall s t, t0 <= s <= t -> D t <= D s) ->
  (forall t, t0 <= t -> D (t + T) <= e \/ D (t + T) <= D t - c) -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> D t <= e.
Proof.
  intros hT hc P M F.
  assert (Q : forall n, D (t0 + INR n * T) <= e \/ D (t0 + INR n * T) <= D t0 - INR n * c).
  { induction n as [ | n IH ]. right. simpl. rewrite Rmult_0_l, Rplus_0_r. lra.
    assert (0 <= INR n * T) by (apply Rmult_le_pos; [ apply pos_INR | lra ]).
    rewrite S_INR. replace (t0 + (INR n + 1) * T) with (t0 + INR n * T + T) by ring.
    destruct (F (t0 + INR n * T) ltac:(lra)) as [k | k]; [ auto | ]. destruct IH as [j | j]. left. lra. right. lra. }
  destruct (nat_above (D t0 / c)) as [n Hn]. apply Rlt_div_l in Hn; [ | lra ].
  assert (N : 0 <= INR n * T) by (apply Rmult_le_pos; [ apply pos_INR | lra ]).
  exists (t0 + INR n * T). split; [ lra | ]. intros t Ht. specialize (M (t0 + INR n * T) t ltac:(lra)). destruct (Q n); [ lra | ].
  specialize (P (t0 + INR n * T) ltac:(lra)). lra.
Qed.

(* while it moves against friction with c to spare, its speed falls at the rate c at least *)
Lemma speed_falls l m a t0 w c x y : line l m a t0 w -> t0 <= x <= y -> (forall z, x <= z <= y -> w z <> 0 /\ - m + c <= a z <= l - c) ->
  Rabs (w y) + c * (y - x) <= Rabs (w x).
Proof.
  intros Hw H on. assert (R : forall y, Rabs y = nrm y 0). { intros z. unfold nrm. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. ring. }
  rewrite !R. enough (nrm (w y) 0 + c * y <= nrm (w x) 0 + c * x) by lra.
  apply (rder_decr (fun y => nrm (w y) 0 + c * y)); [ lra | | ]; intros z Hz.
  - cont. apply (l_c _ _ _ _ _ Hw). lra.
  - destruct (l_law _ _ _ _ _ Hw z) as (f & (F1 & F2 & F3) & X); [ lra | ]. destruct (on z) as [N B]; [ lra | ].
    eexists. split. rd. rewrite <- R. apply Rabs_no_R0. trivial. rewrite <- R.
    destruct (Rdichotomy _ _ N) as [k | k].
    + rewrite (Rabs_left _ k), F3 by trivial. match goal with |- ?g <= 0 => replace g with (- (a z + m) + c) by (field; lra) end. lra.
    + rewrite (Rabs_right (w z)), F2 by lra. match goal with |- ?g <= 0 => replace g with (a z - l + c) by (field; lra) end. lra.
Qed.
Lemma abs_zero x : Rabs x <= 0 -> x = 0.
Proof. intros H. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra. Qed.

(* a motion that rests once in each period, with friction to spare at one moment of it, is reached by every motion *)
Section Captured.
Variables (l m T r s : R) (a W : R -> R).
Hypothesis hT : 0 < T.
Hypothesis ha : forall t, a (t + T) = a t.
Hypothesis HW : forall t0, line l m a t0 W.
Hypothesis hW : forall t, W (t + T) = W t.
Hypothesis hrs : r < s.
Hypothesis rest : forall t, r <= t <= s -> W t = 0.
Hypothesis spare : - m < a r < l.
Hypothesis ca : continuity_pt a r.
Theorem captured t0 w : line l m a t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> w t = W t.
Proof.
  intros Hw. set (c := Rmin (l - a r) (m + a r) / 2).
  assert (c0 : 0 < Rmin (l - a r) (m + a r)) by (apply Rmin_pos; lra). pose proof (Rmin_l (l - a r) (m + a r)) as c1. pose proof (Rmin_r (l - a r) (m + a r)) as c2.
  destruct (ca c) as (d & d0 & Hd); [ unfold c; lra | ].
  set (b := Rmin d (Rmin (s - r) T) / 2). pose proof (Rmin_l d (Rmin (s - r) T)). pose proof (Rmin_r d (Rmin (s - r) T)). pose proof (Rmin_l (s - r) T). pose proof (Rmin_r (s - r) T).
  assert (b0 : 0 < Rmin d (Rmin (s - r) T)) by (repeat apply Rmin_pos; lra).
  assert (bb : 0 < b < d /\ b < s - r /\ b < T) by (unfold b; lra). assert (cc : 0 < c /\ 2 * c <= l - a r /\ 2 * c <= m + a r) by (unfold c; lra).
  clearbody b c.
  assert (near : forall t, r <= t <= r + b -> - m + c <= a t <= l - c).
  { intros t Ht. destruct (Req_dec r t) as [<- | ne]. lra. specialize (Hd t). simpl in Hd. unfold R_dist in Hd.
    assert (Rabs (a t - a r) < c) as K. { apply Hd. split. split; [ exact I | trivial ]. apply Rabs_def1; lra. }
    apply Rabs_def2 in K. lra. }
  assert (H4 : forall s t, t0 <= s <= t -> Rabs (w t - W t) <= Rabs (w s - W s)) by (apply (line_contraction l m a t0); auto).
  destruct (drain (fun t => Rabs (w t - W t)) t0 (2 * T) (c * b) 0) as (t1 & t1a & Ht1); try lra; trivial.
  - apply Rmult_lt_0_compat; lra.
  - intros; apply Rabs_pos.
  - intros t Ht. destruct (per_spec r T hT (t + T)) as [n Hn].
    set (x := r + IZR n * T). assert (x1 : t <= x <= t + T) by (unfold x; lra). assert (x2 : x + b <= t + 2 * T) by (lra).
    assert (on : forall y, x <= y <= x + b -> W y = 0 /\ - m + c <= a y <= l - c).
    { intros y Hy. rewrite <- (shift_Z T W hW n y), <- (shift_Z T a ha n y). split; [ apply rest | apply near ]; unfold x in *; lra. }
    destruct (Req_dec (w (x + b) - W (x + b)) 0) as [z | z].
    + left. pose proof (H4 (x + b) (t + 2 * T) ltac:(lra)) as K. rewrite z, Rabs_R0 in K. exact K.
    + right. apply Rle_trans with (Rabs (w (x + b) - W (x + b))); [ apply H4; lra | ].
      apply Rle_trans with (Rabs (w x - W x) - c * b); [ | pose proof (H4 t x ltac:(lra)); lra ].
      assert (N : forall y, x <= y <= x + b -> w y <> 0).
      { intros y Hy e. apply z. pose proof (H4 y (x + b) ltac:(lra)) as K. destruct (on y Hy) as [e1 _]. rewrite e, e1, Rminus_0_r, Rabs_R0 in K.
        destruct (Req_dec (w (x + b) - W (x + b)) 0) as [ | q]; trivial. pose proof (Rabs_pos_lt _ q). lra. }
      destruct (on x) as [-> _]; [ lra | ]. destruct (on (x + b)) as [-> _]; [ lra | ]. rewrite !Rminus_0_r.
      enough (Rabs (w (x + b)) + c * (x + b - x) <= Rabs (w x)) by lra. apply (speed_falls l m a t0); trivial; [ lra | ].
      intros y Hy. split; [ apply N | apply on ]; lra.
  - exists t1. split; trivial. intros t Ht. enough (w t - W t = 0) by lra. now apply abs_zero, Ht1.
Qed.
End Captured.

(* s24-region-5: above D everything stops, and when *)
Theorem s24_region_5 l q t0 w : 1 <= q -> 1 < l -> line l (q * l) sin t0 w -> forall t, t0 + Rabs (w t0) / (l - 1) <= t -> w t = 0.
Proof.
  intros hq hl Hw t Ht. assert (q * l >= l) by nra. set (x := Rabs (w t0) / (l - 1)) in *. assert (e : (l - 1) * x = Rabs (w t0)) by (unfold x; field; lra).
  pose proof (Rabs_pos (w t0)). assert (0 <= x) by nra.
  assert (Z : line l (q * l) sin t0 (fun _ => 0)).
  { split. intros; cont. intros y _. pose proof (SIN_bound y). exists (- sin y). split. repeat split; lra. eapply rder_eq. rd. ring. }
  destruct (Req_dec (w t) 0) as [ | z]; trivial. apply abs_zero.
  enough (Rabs (w t) + (l - 1) * (t - t0) <= Rabs (w t0)) by nra. apply (speed_falls l (q * l) sin t0); trivial; [ lra | ].
  intros y Hy. pose proof (SIN_bound y). split; [ | lra ]. intros e0. apply z. 
  pose proof (line_contraction _ _ _ _ _ _ Hw Z y t ltac:(lra)) as K. cbv beta in K. rewrite e0, !Rminus_0_r, Rabs_R0 in K. now apply abs_zero.
Qed.
