(* Lengths, right derivatives and limits: what Motion.v has not. The speed has a right derivative at rest, too. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

(* ---- lengths ---- *)
Lemma nrm_le x y a : 0 <= a -> x ^ 2 + y ^ 2 <= a ^ 2 -> nrm x y <= a.
Proof. intros Ha H. unfold nrm. rewrite <- (sqrt_pow2 a) by trivial. now apply sqrt_le_1_alt. Qed.
Lemma nrm_scale c x y : 0 <= c -> nrm (c * x) (c * y) = c * nrm x y.
Proof.
  intros H. unfold nrm. replace ((c * x) ^ 2 + (c * y) ^ 2) with (c ^ 2 * (x ^ 2 + y ^ 2)) by ring.
  rewrite sqrt_mult_alt by apply pow2_ge_0. now rewrite sqrt_pow2.
Qed.
Lemma nrm_zero x y : nrm x y = 0 -> x = 0 /\ y = 0.
Proof. intros e. apply sq_sum. rewrite <- nrm_sq, e. lra. Qed.
Lemma nrm_0 : nrm 0 0 = 0.
Proof. unfold nrm. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. apply sqrt_0. Qed.
Lemma dot_le a b x y : a * x + b * y <= nrm a b * nrm x y.
Proof.
  pose proof (nrm_sq a b). pose proof (power_bound (nrm a b) (- a) (- b) x y (nrm_pos a b) ltac:(lra)). lra.
Qed.
Lemma dot_abs a b x y : Rabs (a * x + b * y) <= nrm a b * nrm x y.
Proof.
  pose proof (nrm_sq a b). pose proof (power_bound (nrm a b) a b x y (nrm_pos a b) ltac:(lra)). pose proof (dot_le a b x y). apply Rabs_le. lra.
Qed.
Lemma nrm_add a b x y : nrm (a + x) (b + y) <= nrm a b + nrm x y.
Proof.
  pose proof (nrm_pos a b). pose proof (nrm_pos x y). pose proof (nrm_sq a b). pose proof (nrm_sq x y). pose proof (dot_le a b x y). apply nrm_le; nra.
Qed.
Lemma nrm_abs x y : nrm x y <= Rabs x + Rabs y.
Proof.
  pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (pow2_abs x). pose proof (pow2_abs y). apply nrm_le; nra.
Qed.
Lemma abs_nrm x y : Rabs x <= nrm x y /\ Rabs y <= nrm x y.
Proof.
  pose proof (nrm_sq x y). pose proof (nrm_pos x y). pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 y).
  split; apply Rabs_le; split; nra.
Qed.
Lemma nrm_near a b a' b' : Rabs (nrm a b - nrm a' b') <= Rabs (a - a') + Rabs (b - b').
Proof.
  pose proof (nrm_add a' b' (a - a') (b - b')) as H. pose proof (nrm_add a b (a' - a) (b' - b)) as K.
  replace (a' + (a - a')) with a in H by ring. replace (b' + (b - b')) with b in H by ring.
  replace (a + (a' - a)) with a' in K by ring. replace (b + (b' - b)) with b' in K by ring.
  pose proof (nrm_abs (a - a') (b - b')). pose proof (nrm_abs (a' - a) (b' - b)) as L.
  rewrite (Rabs_minus_sym a'), (Rabs_minus_sym b') in L. apply Rabs_le. lra.
Qed.

(* ---- right derivatives ---- *)
Lemma rder_intro f t l : (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs (f (t + h) - f t - l * h) <= e * h) -> rder f t l.
Proof.
  intros H. exists (fun s => if Rlt_dec s t then f t + l * (s - t) else f s). split.
  - apply is_derive_Reals. intros e He. destruct (H (e / 2) ltac:(lra)) as (d & d0 & Hd). exists (mkposreal d d0). simpl. intros h h0 hd.
    apply Rabs_def2 in hd. destruct (Rlt_dec t t); [ lra | ]. destruct (Rlt_dec (t + h) t).
    + replace ((f t + l * (t + h - t) - f t) / h - l) with 0 by (field; lra). rewrite Rabs_R0. lra.
    + specialize (Hd h ltac:(lra)). replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - l * h) / h) by (field; lra).
      unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ h)) by (left; apply Rinv_0_lt_compat; lra).
      apply Rle_lt_trans with (e / 2); [ | lra ]. apply Rle_div_l; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Lemma rder_elim f t l : rder f t l -> forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs (f (t + h) - f t - l * h) <= e * h.
Proof.
  intros H e He. destruct (rder_step _ _ _ H e He) as (a & a0 & Ha). destruct (rder_step _ _ _ (rder_opp _ _ _ H) e He) as (b & b0 & Hb).
  exists (Rmin a b). split. now apply Rmin_pos. intros h Hh. pose proof (Rmin_l a b). pose proof (Rmin_r a b).
  specialize (Ha h ltac:(lra)). specialize (Hb h ltac:(lra)). cbv beta in Hb. apply Rabs_le. lra.
Qed.
Lemma rder_ext f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> rder g t l -> rder f t l.
Proof.
  intros Hd E H. apply rder_intro. intros e He. destruct (rder_elim _ _ _ H e He) as (c & c0 & Hc). exists (Rmin c d). split. now apply Rmin_pos.
  intros h Hh. pose proof (Rmin_l c d). pose proof (Rmin_r c d). rewrite <- !E by lra. apply Hc. lra.
Qed.
Lemma rder_one f t l m : rder f t l -> rder f t m -> l = m.
Proof.
  intros H K. apply cond_eq. intros e He. destruct (rder_elim _ _ _ H (e / 4) ltac:(lra)) as (a & a0 & Ha).
  destruct (rder_elim _ _ _ K (e / 4) ltac:(lra)) as (b & b0 & Hb). assert (p : 0 < Rmin a b) by now apply Rmin_pos.
  pose proof (Rmin_l a b). pose proof (Rmin_r a b). set (h := Rmin a b / 2) in *. specialize (Ha h ltac:(unfold h; lra)). specialize (Hb h ltac:(unfold h; lra)).
  apply Rabs_le_between in Ha, Hb. assert (h0 : 0 < h) by (unfold h; lra). apply Rabs_def1; nra.
Qed.
(* the speed at rest *)
Lemma rder_nrm0 f g t l m : rder f t l -> rder g t m -> f t = 0 -> g t = 0 -> rder (fun s => nrm (f s) (g s)) t (nrm l m).
Proof.
  intros F G e1 e2. apply rder_intro. intros e He. destruct (rder_elim _ _ _ F (e / 2) ltac:(lra)) as (a & a0 & Ha).
  destruct (rder_elim _ _ _ G (e / 2) ltac:(lra)) as (b & b0 & Hb). exists (Rmin a b). split. now apply Rmin_pos. intros h Hh.
  pose proof (Rmin_l a b). pose proof (Rmin_r a b). specialize (Ha h ltac:(lra)). specialize (Hb h ltac:(lra)).
  rewrite e1 in *. rewrite e2 in *. rewrite nrm_0, Rminus_0_r in *. rewrite Rmult_comm, <- nrm_scale by lra.
  eapply Rle_trans; [ apply nrm_near | ]. rewrite !(Rmult_comm h). lra.
Qed.
(* a slope below a bound, and steeper than 0 *)
Lemma rder_lip f a s t : s <= t -> (forall r, s < r <= t -> continuity_pt f r) -> (forall r, s <= r < t -> exists l, rder f r l /\ Rabs l <= a) ->
  Rabs (f t - f s) <= a * (t - s).
Proof.
  intros Hst C D. assert (K : f t - a * t <= f s - a * s /\ - f t - a * t <= - f s - a * s).
  { split; [ apply (rder_decr (fun r => f r - a * r)) | apply (rder_decr (fun r => - f r - a * r)) ]; trivial; intros r Hr.
    1, 3: specialize (C r Hr); cont.
    all: destruct (D r Hr) as (l & L & b); apply Rabs_le_between in b; eexists; split; [ rd | lra ]. }
  apply Rabs_le. lra.
Qed.
Lemma rder_falls f t l : rder f t l -> l < 0 -> exists d, 0 < d /\ forall h, 0 < h < d -> f (t + h) < f t.
Proof. intros H L. destruct (rder_step _ _ _ H (- l / 2) ltac:(lra)) as (d & d0 & Hd). exists d. split; trivial. intros h Hh. specialize (Hd h Hh). nra. Qed.
Lemma rder_near_pos f t l : rder f t l -> 0 < f t -> exists d, 0 < d /\ forall h, 0 <= h < d -> 0 < f (t + h).
Proof.
  intros H P. destruct (rder_elim _ _ _ H 1 Rlt_0_1) as (d & d0 & Hd). set (c := Rabs l + 1). assert (c0 : 0 < c) by (unfold c; pose proof (Rabs_pos l); lra).
  exists (Rmin d (f t / c)). split. apply Rmin_pos; trivial. now apply Rdiv_lt_0_compat. intros h Hh. pose proof (Rmin_l d (f t / c)). pose proof (Rmin_r d (f t / c)).
  destruct (proj1 Hh) as [h0 | <-]; [ | now rewrite Rplus_0_r ]. specialize (Hd h ltac:(lra)). apply Rabs_le_between in Hd. 
  assert (h * c < f t) by (apply Rlt_div_r; lra). pose proof (Rle_abs (- l)) as q. rewrite Rabs_Ropp in q. unfold c in *. nra.
Qed.
Lemma cont_lip f t r L : 0 < r -> (forall s, Rabs (s - t) < r -> Rabs (f s - f t) <= L * Rabs (s - t)) -> continuity_pt f t.
Proof.
  intros r0 H e He. set (c := Rabs L + 1). assert (c0 : 0 < c) by (unfold c; pose proof (Rabs_pos L); lra). exists (Rmin r (e / c)).
  split. apply Rmin_pos; trivial. now apply Rdiv_lt_0_compat. intros s [_ Hs]. simpl in *. unfold R_dist in *.
  pose proof (Rmin_l r (e / c)). pose proof (Rmin_r r (e / c)). specialize (H s ltac:(lra)). assert (Rabs (s - t) * c < e) by (apply Rlt_div_r; lra).
  pose proof (Rle_abs L). pose proof (Rabs_pos (s - t)). unfold c in *. nra.
Qed.
(* what is never 0 keeps its sign *)
Lemma keeps_sign f l t : 0 <= t -> (forall s, 0 < s <= t -> continuity_pt f s) -> rder f 0 l -> (forall s, 0 <= s <= t -> f s <> 0) -> 0 < f 0 -> 0 < f t.
Proof.
  intros Ht C D N P. destruct (rder_near_pos f 0 l D P) as (d & d0 & Hd). apply Rnot_le_lt. intros B.
  assert (t0 : t <> 0) by (intros ->; lra). set (s := Rmin d t / 2). assert (q : 0 < Rmin d t) by (apply Rmin_pos; lra).
  pose proof (Rmin_l d t). pose proof (Rmin_r d t). specialize (Hd s ltac:(unfold s; lra)). rewrite Rplus_0_l in Hd.
  assert (f t <> 0) by (apply N; lra).
  destruct (Ranalysis5.IVT_interv (fun r => - f r) s t) as (z & hz & ez); try (unfold s; lra); try lra.
  - intros r Hr. apply (continuity_pt_opp f), C. unfold s in Hr. lra.
  - apply (N z); [ unfold s in hz | ]; lra.
Qed.

(* ---- limits ---- *)
(* a square below c / B goes to zero *)
Lemma lim_of_bound f (c : R) (B : R -> R) : 0 <= c -> (forall t, 0 <= t -> f t ^ 2 * B t <= c) -> 
  (forall K, exists T, 0 <= T /\ forall t, T <= t -> K <= B t) -> is_lim f p_infty 0.
Proof.
  intros Hc H HB. apply is_lim_spec. intros eps. destruct (HB (c / eps ^ 2 + 1)) as (T & T0 & HT).
  exists T. intros t Ht. rewrite Rminus_0_r. specialize (H t ltac:(lra)). specialize (HT t ltac:(lra)).
  pose proof (cond_pos eps) as ep. set (e := pos eps) in *. apply Rnot_le_lt. intros K.
  assert (e ^ 2 <= f t ^ 2) by (rewrite <- (pow2_abs (f t)); apply pow_incr; lra).
  assert (0 < e ^ 2) by nra. assert (0 <= c / e ^ 2) by (apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]).
  assert (e ^ 2 * (c / e ^ 2 + 1) = c + e ^ 2) by (field; lra). nra.
Qed.
(* a x + b -> infinity, and exp (a x) *)
Lemma grows_line a b K : 0 < a -> exists T, 0 <= T /\ forall t, T <= t -> K <= b + a * t.
Proof.
  intros ha. exists (Rabs (K - b) / a). assert (0 <= Rabs (K - b) / a) by (apply Rmult_le_pos; [ apply Rabs_pos | left; now apply Rinv_0_lt_compat ]).
  split; trivial. intros t Ht. apply (Rmult_le_compat_l a) in Ht; [ | lra ]. replace (a * (Rabs (K - b) / a)) with (Rabs (K - b)) in Ht by (field; lra).
  pose proof (Rle_abs (K - b)). lra.
Qed.
Lemma grows_exp a K : 0 < a -> exists T, 0 <= T /\ forall t, T <= t -> K <= exp (a * t).
Proof.
  intros ha. destruct (grows_line a 1 K ha) as (T & T0 & HT). exists T. split; trivial. intros t Ht. specialize (HT t Ht).
  pose proof (exp_ineq1_le (a * t)). lra.
Qed.
Lemma cont_eps f t e : continuity_pt f t -> 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (f s - f t) < e.
Proof.
  intros C He. destruct (C e He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs. destruct (Req_dec t s) as [<- | N].
  - rewrite Rminus_eq_0, Rabs_R0. exact He.
  - apply Hd. split; [ split; trivial; exact I | exact Hs ].
Qed.
(* rd, but with the rates that are known as hypotheses *)
Ltac rds := match goal with
  | |- rder _ _ _ => eassumption
  | |- rder (fun t => @?a t + @?b t) _ _ => apply (rder_plus a b); rds
  | |- rder (fun t => @?a t - @?b t) _ _ => apply (rder_minus a b); rds
  | |- rder (fun t => @?a t * @?b t) _ _ => apply (rder_mult a b); rds
  | |- rder (fun t => - @?a t) _ _ => apply (rder_opp a); rds
  | |- _ => rd
  end.
