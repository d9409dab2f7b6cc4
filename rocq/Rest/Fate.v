(* One motion per start; rest lasts where rho <= 1; what has rho + p < 1 is caught; each motion comes to rest, escapes,
   or creeps towards rho = 1 for ever. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere.
From Slipbook Require Export Analysis.
Open Scope R_scope.

(* two motions on one table: their distance grows at most as exp t; hence one motion per start *)
Theorem table_apart x1 y1 u1 w1 x2 y2 u2 w2 : spin x1 y1 u1 w1 -> spin x2 y2 u2 w2 -> forall s t, 0 <= s <= t ->
  ((x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 + (u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2) * exp (- (2) * t) <=
  ((x1 s - x2 s) ^ 2 + (y1 s - y2 s) ^ 2 + (u1 s - u2 s) ^ 2 + (w1 s - w2 s) ^ 2) * exp (- (2) * s).
Proof.
  intros S1 S2 s t Hst. apply (rder_decr (fun t => ((x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 + (u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2) * exp (- (2) *
  t))); [ lra | | ]; intros r Hr.
  - cont; first [ apply (s_cx _ _ _ _ S1) | apply (s_cy _ _ _ _ S1) | apply (s_cu _ _ _ _ S1) | apply (s_cw _ _ _ _ S1) 
      | apply (s_cx _ _ _ _ S2) | apply (s_cy _ _ _ _ S2) | apply (s_cu _ _ _ _ S2) | apply (s_cw _ _ _ _ S2) ]; lra.
  - destruct (s_law _ _ _ _ S1 r) as (X1 & Y1 & f1 & g1 & [B1 P1] & U1 & W1); [ lra | ].
    destruct (s_law _ _ _ _ S2 r) as (X2 & Y2 & f2 & g2 & [B2 P2] & U2 & W2); [ lra | ].
    eexists. split. rd. cbv beta. simpl pred. simpl INR. set (e := exp _). assert (e0 : 0 < e) by apply exp_pos.
    pose proof (power_bound _ _ _ (u1 r) (w1 r) Rle_0_1 B2). pose proof (power_bound _ _ _ (u2 r) (w2 r) Rle_0_1 B1).
    pose proof (pow2_ge_0 (x1 r - x2 r - (u1 r - u2 r))). pose proof (pow2_ge_0 (y1 r - y2 r - (w1 r - w2 r))).
    match goal with |- ?a * e + ?d * (?c * e) <= 0 => assert (a + d * c <= 0); [ | nra ] end. lra.
Qed.
Corollary table_unique x1 y1 u1 w1 x2 y2 u2 w2 s : spin x1 y1 u1 w1 -> spin x2 y2 u2 w2 -> 0 <= s ->
  x1 s = x2 s -> y1 s = y2 s -> u1 s = u2 s -> w1 s = w2 s ->
  forall t, s <= t -> x1 t = x2 t /\ y1 t = y2 t /\ u1 t = u2 t /\ w1 t = w2 t.
Proof.
  intros S1 S2 Hs ex ey eu ew t Ht. pose proof (table_apart _ _ _ _ _ _ _ _ S1 S2 s t ltac:(lra)) as H.
  rewrite ex, ey, eu, ew in H. set (D := (x1 t - x2 t) ^ 2 + _ + _ + _) in H. assert (D0 : D <= 0).
  { apply (Rmult_le_reg_r (exp (- (2) * t))). apply exp_pos. eapply Rle_trans; [ exact H | right; ring ]. }
  unfold D in D0. pose proof (pow2_ge_0 (x1 t - x2 t)). pose proof (pow2_ge_0 (y1 t - y2 t)). pose proof (pow2_ge_0 (u1 t - u2 t)).
  pose proof (pow2_ge_0 (w1 t - w2 t)).
  repeat split; nra.
Qed.

Lemma root_le a d : 0 <= d -> sqrt (a ^ 2 + d ^ 2) <= Rabs a + d.
Proof.
  intros Hd. pose proof (Rabs_pos a). rewrite <- (sqrt_pow2 (Rabs a + d)) by lra. apply sqrt_le_1_alt. rewrite <- (pow2_abs a). nra.
Qed.
(* what does not grow while it is negative does not grow *)
Lemma rder_stays f a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) ->
  (forall t, a <= t < b -> exists l, rder f t l /\ (f t < 0 -> l <= 0)) -> f a < 0 -> f b <= f a.
Proof.
  intros Hab C D H. apply (real_ind (fun t => f t <= f a) a b); try lra.
  - intros t Ht K. apply Rnot_lt_le. intros bad. assert (Q : continuity_pt (fun s => f s - f a) t) by (apply (continuity_pt_minus f); [ apply C,
    Ht | cont ]).
    apply continuity_pt_filterlim in Q. assert (P : locally t (fun s => 0 < f s - f a)). { apply (Q (fun y => 0 < y)). apply (open_gt 0). lra. }
    destruct P as [d P]. set (s := t - Rmin d (t - a) / 2). pose proof (cond_pos d). assert (0 < Rmin d (t - a)) by (apply Rmin_pos; lra).
    pose proof (Rmin_l d (t - a)). pose proof (Rmin_r d (t - a)). specialize (K s ltac:(unfold s; lra)).
    assert (B : ball t d s). { change (Rabs (s - t) < d). apply Rabs_def1; unfold s; lra. } specialize (P s B). lra.
  - intros t Ht K. destruct (D t Ht) as (l & L & l0). destruct (rder_step f t l L 1 Rlt_0_1) as (d & d0 & Hd).
    assert (ft : f t <= f a) by (apply K; lra). specialize (l0 ltac:(lra)).
    set (m := Rmin d (Rmin (b - t) (- f a))). assert (m0 : 0 < m) by (repeat apply Rmin_pos; lra).
    assert (m1 : m <= d) by apply Rmin_l. assert (m2 : m <= b - t) by (eapply Rle_trans; [ apply Rmin_r | apply Rmin_l ]).
    assert (m3 : m <= - f a) by (eapply Rle_trans; [ apply Rmin_r | apply Rmin_r ]).
    assert (N : forall r, t <= r < t + m -> f r < 0).
    { intros r [[r0 | <-] r1]; [ | lra ]. specialize (Hd (r - t) ltac:(lra)). replace (t + (r - t)) with r in Hd by ring. nra. }
    exists m. split; trivial. intros s Hs. apply Rle_trans with (f t); trivial.
    apply (rder_decr f); [ lra | intros; apply C; lra | ]. intros r Hr. destruct (D r ltac:(lra)) as (l' & L' & k). exists l'. split; trivial.
    apply k, N; lra.
Qed.

Lemma mono_lim f M : (forall s t, 0 <= s <= t -> f s <= f t) -> (forall t, 0 <= t -> f t <= M) ->
  exists l : R, is_lim f p_infty l /\ forall t, 0 <= t -> f t <= l.
Proof.
  intros H B. destruct (completeness (fun r => exists t, 0 <= t /\ r = f t)) as [l [l1 l2]].
  { exists M. intros r (t & Ht & ->). auto. } { exists (f 0), 0. split; trivial; lra. }
  assert (up : forall t, 0 <= t -> f t <= l) by (intros t Ht; apply l1; exists t; auto).
  exists l. split; trivial. apply is_lim_spec. intros eps. pose proof (cond_pos eps).
  destruct (Classical_Prop.classic (exists t, 0 <= t /\ l - eps < f t)) as [(T & T0 & HT) | no].
  - exists T. intros t Ht. specialize (H T t ltac:(lra)). specialize (up t ltac:(lra)). apply Rabs_def1; lra.
  - exfalso. assert (l <= l - eps); [ | lra ]. apply l2. intros r (t & Ht & ->). apply Rnot_lt_le. intros k. apply no. eauto.
Qed.

(* the fates of a particle on the table at (x, y) with the velocity (u, w), dimensionless: it is at rest from some moment on,
   at the distance s from the axis;
   «the particle at $(x,y)$ is at rest from some moment on, at the distance $s$ from the axis» *)
Definition rests_at (s : R) (x y u w : R -> R) : Prop :=
  exists T, 0 <= T /\ nrm (x T) (y T) = s /\ forall t, T <= t -> x t = x T /\ y t = y T /\ u t = 0 /\ w t = 0.
(* ... in the end farther away than any distance, for good; «the particle at $(x,y)$ escapes: in the end it is farther away than any distance,
   for good» *)
Definition escapes (x y : R -> R) : Prop := forall M, exists T, 0 <= T /\ forall t, T <= t -> M < nrm (x t) (y t).
(* ... nearer and nearer to a place of the circle rho = 1 and slower and slower, without ever coming to a stop
   «the particle at $(x,y)$ creeps towards a place at the distance $1$ from the axis, slower and slower, and never stops» *)
Definition creeps (x y u w : R -> R) : Prop := exists a b : R, a ^ 2 + b ^ 2 = 1 /\ is_lim x p_infty a /\ is_lim y p_infty b /\
  is_lim u p_infty 0 /\ is_lim w p_infty 0 /\ forall t, 0 <= t -> 0 < nrm (u t) (w t).

Section Fate.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Ltac conts := table S.

Lemma stop0 t : p t = 0 -> u t = 0 /\ w t = 0.
Proof. intros e. apply sq_sum. rewrite <- nrm_sq, e. lra. Qed.
Lemma at_rest t : u t = 0 -> w t = 0 -> p t = 0.
Proof. intros -> ->. unfold nrm. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. apply sqrt_0. Qed.

(* inside the circle rho = 1, and on it, rest lasts *)
Theorem table_rest_lasts s t : 0 <= s <= t -> p s = 0 -> x s ^ 2 + y s ^ 2 <= 1 ->
  x t = x s /\ y t = y s /\ u t = 0 /\ w t = 0.
Proof.
  intros Hst N H. destruct (stop0 s N). apply rest_radius in H.
  apply (table_unique _ _ _ _ _ _ _ _ s S H); trivial; lra.
Qed.
(* s4-rest-radius: outside it does not last *)
Theorem table_rest_needs s d : 0 <= s -> 0 < d -> (forall t, s <= t < s + d -> p t = 0) -> x s ^ 2 + y s ^ 2 <= 1.
Proof.
  intros Hs Hd H. destruct (s_law _ _ _ _ S s Hs) as (_ & _ & fx & fy & [B _] & U & W).
  destruct (stop0 s (H s ltac:(lra))) as [u0 w0].
  pose proof (rder_unique _ _ _ _ U (rder_zero u s d Hd ltac:(intros; now apply stop0, H))).
  pose proof (rder_unique _ _ _ _ W (rder_zero w s d Hd ltac:(intros; now apply stop0, H))). 
  rewrite u0, w0 in *. replace (x s) with (- fx) by lra. replace (y s) with (- fy) by lra. nra.
Qed.

Lemma m_falls s t : 0 <= s <= t -> rho s + p s < 1 -> rho t + p t <= rho s + p s.
Proof.
  intros Hst H. apply le_epsilon. intros e0 He0. set (d := Rmin (e0 / 2) ((1 - (rho s + p s)) / 3)).
  assert (d0 : 0 < d) by (apply Rmin_pos; lra). assert (d1 : d <= e0 / 2) by apply Rmin_l. assert (d2 : d <= (1 - (rho s + p s)) / 3) by apply Rmin_r.
  set (q t := sqrt (x t ^ 2 + y t ^ 2 + d ^ 2)). set (P t := sqrt (u t ^ 2 + w t ^ 2 + d ^ 2)).
  assert (dd : 0 < d ^ 2) by nra.
  assert (pos : forall a b, 0 < a ^ 2 + b ^ 2 + d ^ 2) by (intros a b; pose proof (pow2_ge_0 a); pose proof (pow2_ge_0 b); lra).
  assert (q1 : forall t, rho t <= q t <= rho t + d).
  { intros r. split. apply sqrt_le_1_alt; lra. unfold q. rewrite <- nrm_sq. rewrite <- (Rabs_pos_eq (rho r)) at 2 by apply nrm_pos.
  apply root_le; lra. }
  assert (P1 : forall t, p t <= P t <= p t + d).
  { intros r. split. apply sqrt_le_1_alt; lra. unfold P. rewrite <- nrm_sq. rewrite <- (Rabs_pos_eq (p r)) at 2 by apply nrm_pos. apply root_le; lra.
  }
  pose proof (q1 s) as qs. pose proof (P1 s) as Ps.
  assert (K : q t + P t - 1 <= q s + P s - 1).
  { apply (rder_stays (fun t => q t + P t - 1)); try lra.
    - intros r Hr. apply (continuity_pt_minus (fun t => q t + P t)); [ apply (continuity_pt_plus q P) | cont ]; apply cont_root; try (left;
      apply pos); conts.
    - intros r Hr. destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B PW] & U & W); [ lra | ].
      eexists. split. apply (rder_minus (fun t => q t + P t)); [ apply (rder_plus q P); apply rder_root; try apply pos; rd | rd ].
      cbv beta. intros N. pose proof (q1 r) as qr. pose proof (P1 r) as Pr. pose proof (nrm_pos (u r) (w r)) as p0.
      pose proof (nrm_pos (x r) (y r)) as r0.
      change (sqrt (x r ^ 2 + y r ^ 2 + d ^ 2)) with (q r). change (sqrt (u r ^ 2 + w r ^ 2 + d ^ 2)) with (P r).
      assert (qq : 0 < q r) by (apply sqrt_lt_R0, pos). assert (PP : 0 < P r) by (apply sqrt_lt_R0, pos).
      pose proof (power_bound (p r) (u r) (w r) (- x r) (- y r) p0 ltac:(rewrite nrm_sq; lra)) as Q.
      assert (en : nrm (- x r) (- y r) = rho r) by (unfold nrm; f_equal; ring). rewrite en in Q.
      set (sg := x r * u r + y r * w r).
      assert (a1 : sg / q r <= p r). { apply Rle_div_l; trivial. unfold sg. nra. }
      assert (a2 : (sg - p r) / P r <= - p r). { apply Rle_div_l; trivial. unfold sg. nra. }
      simpl INR. simpl pred. 
      match goal with |- ?g <= 0 => replace g with (sg / q r + (sg - p r) / P r) end. lra.
      replace (p r) with (- (fx * u r + fy * w r)) by lra. unfold sg. field. lra. }
  pose proof (q1 t). pose proof (P1 t). lra.
Qed.

(* caught *)
Theorem caught s t : 0 <= s -> rho s + p s < 1 -> s + p s / (1 - (rho s + p s)) <= t ->
  u t = 0 /\ w t = 0 /\ rho t <= rho s + p s.
Proof.
  intros Hs H Ht. set (m := rho s + p s) in *. pose proof (nrm_pos (u s) (w s)) as p0. 
  assert (st : s <= t). { assert (0 <= p s / (1 - m)); [ | lra ]. apply Rmult_le_pos; trivial. left. apply Rinv_0_lt_compat. lra. }
  assert (M : forall r, s <= r -> rho r + p r <= m) by (intros r Hr; apply m_falls; trivial; lra).
  enough (z : p t = 0). { destruct (stop0 t z). repeat split; trivial. specialize (M t st). lra. }
  apply Classical_Prop.NNPP. intros z.
  assert (N : forall r, s <= r <= t -> p r <> 0).
  { intros r Hr e. apply z, at_rest; apply (table_rest_lasts r t); trivial; try lra; rewrite <- nrm_sq; specialize (M r ltac:(lra));
  pose proof (nrm_pos (x r) (y r)); nra. }
  assert (K : p t + (1 - m) * t <= p s + (1 - m) * s).
  { apply (rder_decr (fun t => p t + (1 - m) * t)); trivial; intros r Hr.
    - conts.
    - specialize (N r ltac:(lra)). specialize (M r ltac:(lra)). pose proof (nrm_pos (u r) (w r)). eexists. split.
      apply (rder_plus (fun t => p t)); [ apply (eq99 x y u w S r ltac:(lra) N) | rd ]. cbv beta.
      pose proof (power_bound (p r) (u r) (w r) (- x r) (- y r) ltac:(lra) ltac:(rewrite nrm_sq; lra)) as Q.
      assert (en : nrm (- x r) (- y r) = rho r) by (unfold nrm; f_equal; ring). rewrite en in Q.
      assert ((x r * u r + y r * w r) / p r <= rho r) by (apply Rle_div_l; lra). lra. }
  pose proof (nrm_pos (u t) (w t)). apply (Rmult_le_compat_r (1 - m)) in Ht; [ | lra ].
  replace ((s + p s / (1 - m)) * (1 - m)) with ((1 - m) * s + p s) in Ht by (field; lra). lra.
Qed.

(* the way made is at least the distance: rho^2 - p^2 grows at twice the speed *)
Lemma path s t : 0 <= s <= t -> nrm (x t - x s) (y t - y s) <= (E t - E s) / 2.
Proof.
  intros Hst. apply le_epsilon. intros d Hd. assert (dd : 0 < d ^ 2) by nra.
  set (D t := (x t - x s) ^ 2 + (y t - y s) ^ 2 + d ^ 2).
  assert (pos : forall t, 0 < D t) by (intros r; unfold D; pose proof (pow2_ge_0 (x r - x s)); pose proof (pow2_ge_0 (y r - y s)); lra).
  apply Rle_trans with (sqrt (D t)). { unfold nrm, D. apply sqrt_le_1_alt. lra. }
  assert (e : sqrt (D s) = d). { unfold D. replace ((x s - x s) ^ 2 + (y s - y s) ^ 2 + d ^ 2) with (d ^ 2) by ring. apply sqrt_pow2. lra. }
  enough (sqrt (D t) - E t * / 2 <= sqrt (D s) - E s * / 2) by lra.
  apply (rder_decr (fun t => sqrt (D t) - E t * / 2)); [ lra | | ]; intros r Hr.
  - apply (continuity_pt_minus (fun t => sqrt (D t)) (fun t => E t * / 2)); [ apply cont_root; [ unfold D | left; apply pos ] | ]; conts.
  - destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ].
    eexists. split. apply (rder_minus (fun t => sqrt (D t)) (fun t => E t * / 2)); [ apply rder_root; [ unfold D; rd | apply pos ] | rd ].
    simpl INR. simpl pred. assert (q : 0 < sqrt (D r)) by (apply sqrt_lt_R0, pos).
    pose proof (power_bound (p r) (u r) (w r) (- (x r - x s)) (- (y r - y s)) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q.
    assert (en : nrm (- (x r - x s)) (- (y r - y s)) <= sqrt (D r)). { unfold nrm, D. apply sqrt_le_1_alt. lra. }
    pose proof (nrm_pos (u r) (w r)).
    assert (((x r - x s) * u r + (y r - y s) * w r) / sqrt (D r) <= p r). { apply Rle_div_l; trivial. nra. }
    match goal with |- ?a * ?b - ?c <= 0 => replace (a * b) with (((x r - x s) * u r + (y r - y s) * w r) / sqrt (D r)) by (field; lra) end. lra.
Qed.

(* (b): where E = rho^2 - p^2 is bounded the motion ends at a place of the disc rho <= 1, with p -> 0 *)
Lemma bounded_ends M : (forall t, 0 <= t -> E t <= M) -> exists a b : R, is_lim x p_infty a /\ is_lim y p_infty b /\
  is_lim u p_infty 0 /\ is_lim w p_infty 0 /\ a ^ 2 + b ^ 2 <= 1 /\ forall t, 0 <= t -> E t <= a ^ 2 + b ^ 2.
Proof.
  intros HM. pose proof (A_never_falls x y u w S) as up.
  assert (far : forall s t, 0 <= s <= t -> Rabs (x t - x s) <= (E t - E s) / 2 /\ Rabs (y t - y s) <= (E t - E s) / 2).
  { intros s t Hst. pose proof (path s t Hst). split; (eapply Rle_trans; [ | apply H ]); unfold nrm; rewrite <- sqrt_Rsqr_abs; apply sqrt_le_1_alt;
      unfold Rsqr; pose proof (pow2_ge_0 (x t - x s)); pose proof (pow2_ge_0 (y t - y s)); lra. }
  destruct (mono_lim (fun t => E t) M) as (L & HL & EL); trivial.
  assert (lim : forall f, (forall s t, 0 <= s <= t -> Rabs (f t - f s) <= (E t - E s) / 2) -> exists a : R, is_lim f p_infty a).
  { intros f Hf. destruct (mono_lim (fun t => f t + E t * / 2) (f 0 - E 0 / 2 + M)) as (l & Hl & _).
    - intros s t Hst. specialize (Hf s t Hst). apply Rabs_le_between in Hf. lra.
    - intros t Ht. specialize (Hf 0 t ltac:(lra)). apply Rabs_le_between in Hf. specialize (HM t Ht). lra.
    - exists (l - L * / 2). apply (is_lim_ext (fun t => f t + E t * / 2 - E t * / 2)). intros; ring.
      apply (is_lim_minus' _ _ p_infty l (L * / 2)); trivial. apply (is_lim_scal_r (fun t => E t) (/ 2) p_infty L HL). }
  destruct (lim x) as [a Ha]. { intros; now apply far. } destruct (lim y) as [b Hb]. { intros; now apply far. }
  assert (sq : forall f (c : R), is_lim f p_infty c -> is_lim (fun t => f t ^ 2) p_infty (c ^ 2)).
  { intros f c Hc. apply (is_lim_ext (fun t => f t * f t)). intros; ring. replace (c ^ 2) with (c * c) by ring.
  apply (is_lim_mult f f p_infty c c); trivial. exact I. }
  assert (Hp : is_lim (fun t => u t ^ 2 + w t ^ 2) p_infty (a ^ 2 + b ^ 2 - L)).
  { apply (is_lim_ext (fun t => x t ^ 2 + y t ^ 2 - E t)). intros; ring. apply (is_lim_minus' _ _ p_infty (a ^ 2 + b ^ 2) L); trivial.
    apply (is_lim_plus' _ _ p_infty (a ^ 2) (b ^ 2)); apply sq; trivial. }
  set (P := a ^ 2 + b ^ 2 - L) in *.
  assert (P0 : P = 0).
  { destruct (Rtotal_order P 0) as [n | [z | n]]; trivial; exfalso.
    - destruct (lim_near _ P (- P) Hp ltac:(lra)) as (T & T0 & HT). specialize (HT T ltac:(lra)). pose proof (pow2_ge_0 (u T)).
      pose proof (pow2_ge_0 (w T)). lra.
    - destruct (lim_near _ P (P / 2) Hp ltac:(lra)) as (T & T0 & HT). set (c := sqrt (P / 2)). assert (c0 : 0 < c) by (apply sqrt_lt_R0; lra).
      assert (ps : forall t, T <= t -> c <= p t) by (intros t Ht; apply sqrt_le_1_alt; specialize (HT t Ht); lra).
      set (t1 := T + (M - E T) / c + 1). assert (Tt : T <= t1). { unfold t1. assert (0 <= (M - E T) / c); [ | lra ]. apply Rmult_le_pos.
      specialize (HM T T0); lra. left; now apply Rinv_0_lt_compat. }
      assert (K : 2 * c * t1 - E t1 <= 2 * c * T - E T).
      { apply (rder_decr (fun t => 2 * c * t - E t)); trivial; intros r Hr'. conts.
        destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B PW] & U & W); [ lra | ]. eexists. split. rd. simpl INR. simpl pred.
        specialize (ps r ltac:(lra)). lra. }
      specialize (HM t1 ltac:(lra)). assert (q : c * t1 = c * T + (M - E T) + c) by (unfold t1; field; lra).
      pose proof (up T t1 ltac:(lra)). lra. }
  assert (small : forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> p t < e).
  { intros e He. destruct (lim_near _ P (e ^ 2) Hp ltac:(nra)) as (T & T0 & HT). exists T. split; trivial. intros t Ht. specialize (HT t Ht).
    pose proof (nrm_sq (u t) (w t)). pose proof (nrm_pos (u t) (w t)). nra. }
  assert (zero : forall f, (forall t, f t ^ 2 <= u t ^ 2 + w t ^ 2) -> is_lim f p_infty 0).
  { intros f Hf. apply is_lim_spec. intros e. destruct (small e (cond_pos e)) as (T & T0 & HT). exists T. intros t Ht. specialize (HT t ltac:(lra)).
  specialize (Hf t).
    rewrite <- nrm_sq in Hf. pose proof (nrm_pos (u t) (w t)). rewrite Rminus_0_r. rewrite <- (pow2_abs (f t)) in Hf. pose proof (Rabs_pos (f t)).
    simpl. nra. }
  assert (Lab : L = a ^ 2 + b ^ 2) by (unfold P in P0; lra). clear P0.
  exists a, b. split; trivial. split; trivial. split. { apply zero. intros; pose proof (pow2_ge_0 (w t)); lra. } split. { apply zero.
  intros; pose proof (pow2_ge_0 (u t)); lra. }
  split. 2: { intros t Ht. specialize (EL t Ht). lra. }
  enough (L <= 1) by lra. apply Rnot_lt_le. intros k. pose proof (nrm_sq a b) as rr. pose proof (nrm_pos a b) as r0. set (r := nrm a b) in *.
  assert (rL : r ^ 2 = L) by lra.
  assert (r1 : 1 < r) by nra. assert (d0 : 0 < L - r) by nra.
  assert (Hab : is_lim (fun t => a * x t + b * y t) p_infty L).
  { replace L with (a * a + b * b) by (rewrite Lab; ring). apply (is_lim_plus' _ _ p_infty (a * a) (b * b));
  [ apply (is_lim_scal_l x a p_infty a Ha) | apply (is_lim_scal_l y b p_infty b Hb) ]. }
  destruct (lim_near _ _ ((L - r) / 4) Hab ltac:(lra)) as (T1 & T10 & HT1).
  destruct (small ((L - r) / (8 * r))) as (T2 & T20 & HT2). { apply Rdiv_lt_0_compat; lra. }
  set (T := Rmax T1 T2). pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2). fold T in H, H0.
  assert (pr : forall t, T <= t -> r * p t < (L - r) / 8).
  { intros t Ht. specialize (HT2 t ltac:(lra)). apply (Rmult_lt_compat_l r) in HT2; [ | lra ].
  replace (r * ((L - r) / (8 * r))) with ((L - r) / 8) in HT2 by (field; lra). exact HT2. }
  assert (G : - (a * u (T + 1) + b * w (T + 1)) + (L - r) / 2 * (T + 1) <= - (a * u T + b * w T) + (L - r) / 2 * T).
  { apply (rder_decr (fun t => - (a * u t + b * w t) + (L - r) / 2 * t)); [ lra | | ]; intros s Hs. conts.
    destruct (s_law _ _ _ _ S s) as (X & Y & fx & fy & [B PW] & U & W); [ lra | ]. eexists. split. rd.
    specialize (HT1 s ltac:(lra)). specialize (pr s ltac:(lra)).
    pose proof (power_bound 1 fx fy a b Rle_0_1 B) as Q1. fold r in Q1.
    pose proof (power_bound (p s) (w s) (- u s) a b (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q2. fold r in Q2. lra. }
  assert (bd : forall t, T <= t -> - ((L - r) / 8) <= a * u t + b * w t <= (L - r) / 8).
  { intros t Ht. specialize (pr t Ht). pose proof (power_bound (p t) (u t) (w t) a b (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q1. fold r in Q1.
    pose proof (power_bound (p t) (- u t) (- w t) a b (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q2. fold r in Q2. lra. }
  pose proof (bd T ltac:(lra)). pose proof (bd (T + 1) ltac:(lra)). lra.
Qed.

(* with A > 1, A and rho grow without bound *)
Theorem unbounded_above_1 s : 0 <= s -> 1 < E s -> forall M, exists T, s <= T /\ forall t, T <= t -> M < E t.
Proof.
  intros Hs H M. pose proof (A_never_falls x y u w S) as up.
  destruct (Classical_Prop.classic (exists T, s <= T /\ M < E T)) as [(T & T0 & HT) | n].
  - exists T. split; trivial. intros t Ht. specialize (up T t ltac:(lra)). lra.
  - exfalso. assert (below : forall t, s <= t -> E t <= M) by (intros t Ht; apply Rnot_lt_le; intros k; apply n; eauto).
    destruct (bounded_ends M) as (a & b & _ & _ & _ & _ & L1 & EL).
    { intros t Ht. destruct (Rle_lt_dec s t); auto. specialize (up t s ltac:(lra)). specialize (below s ltac:(lra)). lra. }
    specialize (EL s Hs). lra.
Qed.
Lemma rests_from T : 0 <= T -> p T = 0 -> rho T <= 1 -> rests_at (rho T) x y u w.
Proof.
  intros T0 z r1. exists T. split; trivial. split; trivial. intros t Ht. apply table_rest_lasts; trivial; try lra.
  rewrite <- nrm_sq. pose proof (nrm_pos (x T) (y T)). nra.
Qed.
Lemma escapes_from s : 0 <= s -> 1 < E s -> escapes x y.
Proof.
  intros Hs H M. destruct (unbounded_above_1 s Hs H (M ^ 2)) as (T & T0 & HT). exists T. split. lra. intros t Ht. specialize (HT t Ht).
  pose proof (nrm_sq (x t) (y t)). pose proof (nrm_pos (x t) (y t)). pose proof (pow2_ge_0 (u t)). pose proof (pow2_ge_0 (w t)). nra.
Qed.
Theorem fates : (exists s, s <= 1 /\ rests_at s x y u w) \/ escapes x y \/ creeps x y u w.
Proof.
  pose proof (A_never_falls x y u w S) as up.
  destruct (Classical_Prop.classic (exists M, forall t, 0 <= t -> E t <= M)) as [[M HM] | no].
  - destruct (bounded_ends M HM) as (a & b & Ha & Hb & Hu & Hw & L1 & EL).
    destruct (Classical_Prop.classic (exists T, 0 <= T /\ p T = 0)) as [(T & T0 & z) | never].
    + left. exists (rho T). assert (rho T <= 1); [ | split; trivial; now apply rests_from ]. specialize (EL T T0). destruct (stop0 T z) as [z1 z2].
      rewrite z1, z2 in EL.
      pose proof (nrm_sq (x T) (y T)). pose proof (nrm_pos (x T) (y T)). nra.
    + right. right. exists a, b. assert (pos : forall t, 0 <= t -> 0 < p t).
      { intros t Ht. destruct (nrm_pos (u t) (w t)) as [k | k]; trivial. exfalso. apply never. exists t. auto. }
      repeat split; trivial. apply Rle_antisym; trivial. apply Rnot_lt_le. intros k.
      set (r := nrm a b). pose proof (nrm_sq a b) as rr. pose proof (nrm_pos a b) as r0. fold r in rr, r0. assert (r1 : r < 1) by nra.
      assert (near : forall f (c e : R), is_lim f p_infty c -> 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (f t - c) < e).
      { intros f c e Hf He. destruct (lim_near f c e Hf He) as (T & T0 & HT). exists T. split; trivial. intros t Ht. specialize (HT t Ht).
      apply Rabs_def1; lra. }
      set (e := (1 - r) / 8). destruct (near x a e Ha) as (T1 & T10 & H1); [ unfold e; lra | ].
      destruct (near y b e Hb) as (T2 & T20 & H2); [ unfold e; lra | ].
      destruct (near u 0 e Hu) as (T3 & T30 & H3); [ unfold e; lra | ]. destruct (near w 0 e Hw) as (T4 & T40 & H4); [ unfold e; lra | ].
      set (T := T1 + T2 + T3 + T4). specialize (H1 T ltac:(unfold T; lra)). specialize (H2 T ltac:(unfold T; lra)).
      specialize (H3 T ltac:(unfold T; lra)). specialize (H4 T ltac:(unfold T; lra)).
      apply Rabs_def2 in H1, H2, H3, H4.
      assert (sum : rho T + p T < 1).
      { pose proof (nrm_sq (x T) (y T)). pose proof (nrm_sq (u T) (w T)). pose proof (nrm_pos (x T) (y T)). pose proof (nrm_pos (u T) (w T)).
        assert (p T <= 2 * e) by nra.
        pose proof (nrm_sq (x T - a) (y T - b)). pose proof (nrm_pos (x T - a) (y T - b)). set (n := nrm (x T - a) (y T - b)) in *.
        pose proof (power_bound r (- a) (- b) (x T - a) (y T - b) r0 ltac:(lra)) as Q. fold n in Q.
        assert (n <= 2 * e) by nra. assert (rho T <= r + n) by nra. unfold e in *. lra. }
      destruct (caught T (T + p T / (1 - (rho T + p T))) ltac:(unfold T; lra) sum (Rle_refl _)) as (z1 & z2 & _).
      assert (0 <= p T / (1 - (rho T + p T))). { apply Rmult_le_pos. apply nrm_pos. left; apply Rinv_0_lt_compat; lra. }
      specialize (pos (T + p T / (1 - (rho T + p T))) ltac:(unfold T in *; lra)). rewrite (at_rest _ z1 z2) in pos. lra.
  - right. left. intros M. destruct (Classical_Prop.classic (exists T, 0 <= T /\ M ^ 2 < E T)) as [(T & T0 & HT) | n].
    + exists T. split; trivial. intros t Ht. specialize (up T t ltac:(lra)). pose proof (nrm_sq (x t) (y t)). pose proof (nrm_pos (x t) (y t)).
      pose proof (pow2_ge_0 (u t)). pose proof (pow2_ge_0 (w t)). nra.
    + exfalso. apply no. exists (M ^ 2). intros t Ht. apply Rnot_lt_le. intros k. apply n. eauto.
Qed.
End Fate.
