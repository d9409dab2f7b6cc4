(* Analysis that every chapter may use and that knows no mechanics: lengths, right derivatives, sines, limits. Of two tactics `occurs` makes
   the statement that the hypotheses of a theorem can be met. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

(* the statement T with False for its conclusion *)
Ltac emptied T := lazymatch T with
  | forall x : ?A, @?B x => let z := fresh "z" in constr:(forall z : A, ltac:(let b := eval cbv beta in (B z) in let r := emptied b in exact r))
  | _ => constr:(False) end.
(* ... is false: there are motions, numbers ... that meet every hypothesis of the theorem t *)
Ltac occurs t := let T := type of t in let T := eval cbv zeta in T in let r := emptied T in exact (~ r).

(* ---- lengths ---- *)
Lemma abs_of_sq z k : 0 <= k -> z ^ 2 <= k ^ 2 -> Rabs z <= k.
Proof. intros. apply Rabs_le. split; nra. Qed.
Lemma abs_zero x : Rabs x <= 0 -> x = 0.
Proof. intros. apply cond_eq. intros. rewrite Rminus_0_r. lra. Qed.
Lemma nrm_x x : nrm x 0 = Rabs x.
Proof. unfold nrm. rewrite pow_i, Rplus_0_r, <- Rsqr_pow2 by auto. apply sqrt_Rsqr_abs. Qed.
Lemma nrm_x0 a : 0 <= a -> nrm a 0 = a.
Proof. intros. rewrite nrm_x. now apply Rabs_pos_eq. Qed.
Lemma nrm_0y a : 0 <= a -> nrm 0 a = a.
Proof. intros. rewrite <- (nrm_x0 a) at 2 by trivial. unfold nrm. f_equal. ring. Qed.
Lemma nrm_0 : nrm 0 0 = 0.
Proof. apply nrm_x0. lra. Qed.
Lemma nrm_le x y a : 0 <= a -> x ^ 2 + y ^ 2 <= a ^ 2 -> nrm x y <= a.
Proof. intros Ha H. unfold nrm. rewrite <- (sqrt_pow2 a) by trivial. now apply sqrt_le_1_alt. Qed.
Lemma nrm_scale c x y : 0 <= c -> nrm (c * x) (c * y) = c * nrm x y.
Proof. intros. unfold nrm. rewrite <- (sqrt_pow2 c) at 3 by trivial. rewrite <- sqrt_mult_alt by apply pow2_ge_0. f_equal. ring. Qed.
Lemma nrm_zero x y : nrm x y = 0 -> x = 0 /\ y = 0.
Proof. intros e. apply sq_sum. rewrite <- nrm_sq, e. lra. Qed.
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
  pose proof (nrm_pos a b). pose proof (nrm_pos x y). pose proof (nrm_sq a b). pose proof (nrm_sq x y). pose proof (dot_le a b x y).
  apply nrm_le; nra.
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
(* f has the right derivative of what it agrees with for a while *)
Lemma rder_loc f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> is_derive g t l -> rder f t l.
Proof.
  intros Hd E H. exists (fun s => if Rlt_dec s t then g s else f s). split.
  - apply (is_derive_ext_loc g); trivial. exists (mkposreal d Hd). intros s Hs. change (Rabs (s - t) < d) in Hs.
    apply Rabs_def2 in Hs. destruct (Rlt_dec s t); trivial. apply E; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Lemma rder_near f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> rder g t l -> rder f t l.
Proof. intros Hd E [G [H K]]. apply (rder_loc f G t l d); trivial. intros s Hs. rewrite K by lra. apply E, Hs. Qed.
Lemma rder_ext f g t l : (forall s, t <= s -> f s = g s) -> rder f t l -> rder g t l.
Proof. intros E. apply (rder_near _ _ _ _ 1 Rlt_0_1). intros. apply E. lra. Qed.
Lemma rder_fixed (c t : R) : rder (fun _ => c) t 0.
Proof. apply rder_of. auto_derive; trivial. Qed.
Lemma rder_zero f t d : 0 < d -> (forall s, t <= s < t + d -> f s = 0) -> rder f t 0.
Proof. intros Hd H. apply (rder_near f (fun _ => 0) t 0 d Hd); [ | apply rder_fixed ]. intros. symmetry. auto. Qed.
Lemma rder_falls f t l : rder f t l -> l < 0 -> exists d, 0 < d /\ forall h, 0 < h < d -> f (t + h) < f t.
Proof. intros H L. destruct (rder_step _ _ _ H (- l / 2) ltac:(lra)) as (d & d0 & Hd). exists d. split; trivial. intros h k. specialize (Hd h k). nra. Qed.
Lemma rder_unique f t l m : rder f t l -> rder f t m -> l = m.
Proof.
  assert (P : forall a b, rder f t a -> rder f t b -> b <= a); [ | intros; apply Rle_antisym; auto ]. intros a b A B. apply Rnot_lt_le. intros k.
  destruct (rder_falls _ _ _ (rder_minus _ _ _ _ _ A B) ltac:(lra)) as (d & d0 & H). specialize (H (d / 2) ltac:(lra)). cbv beta in H. lra.
Qed.
(* what is positive stays so for a while *)
Lemma right_pos f t l : rder f t l -> 0 < f t -> exists d, 0 < d /\ forall s, t < s < t + d -> 0 < f s.
Proof.
  intros [F [H E]] P. rewrite <- E in P by lra. assert (C : continuous F t) by (apply (ex_derive_continuous F); now exists l).
  destruct (C (fun y => 0 < y) (open_gt 0 _ P)) as [d Hd]. exists d. split; [ apply cond_pos | ]. intros s Hs. rewrite <- E by lra. apply Hd.
  apply Rabs_def1; unfold minus, plus, opp; simpl; lra.
Qed.
Lemma left_pos f t : continuity_pt f t -> 0 < f t -> exists d, 0 < d /\ forall s, t - d < s <= t -> 0 < f s.
Proof.
  intros C P. apply continuity_pt_filterlim in C. destruct (C (fun y => 0 < y) (open_gt 0 _ P)) as [d Hd]. exists d. split; [ apply cond_pos | ].
  intros s Hs. apply Hd, Rabs_def1; pose proof (cond_pos d); unfold minus, plus, opp; simpl; lra.
Qed.
Lemma rder_near_pos f t l : rder f t l -> 0 < f t -> exists d, 0 < d /\ forall h, 0 <= h < d -> 0 < f (t + h).
Proof.
  intros H P. destruct (right_pos f t l H P) as (d & d0 & Hd). exists d. split; trivial.
  intros h [[h0 | <-] h1]; [ apply Hd; lra | now rewrite Rplus_0_r ].
Qed.
Lemma rder_inv f t l : rder f t l -> f t <> 0 -> rder (fun s => / f s) t (- l / f t ^ 2).
Proof. intros H K. eapply rder_eq. apply (rder_comp f Rinv t l (- / f t ^ 2) H). auto_derive; trivial. field; trivial. field; trivial. Qed.
Lemma rder_root f t l : rder f t l -> 0 < f t -> rder (fun s => sqrt (f s)) t (/ (2 * sqrt (f t)) * l).
Proof. intros H P. apply (rder_comp f sqrt); [ exact H | apply is_derive_Reals, derivable_pt_lim_sqrt, P ]. Qed.
Lemma rder_sin f t l : rder f t l -> rder (fun s => sin (f s)) t (cos (f t) * l).
Proof. intros H. apply (rder_comp f sin); [ exact H | apply is_derive_Reals, derivable_pt_lim_sin ]. Qed.
(* time counted otherwise: in another unit, from another moment *)
Lemma rder_clock g h t l m : rder g (h t) l -> is_derive h t m -> (forall s, t <= s -> h t <= h s) -> rder (fun s => g (h s)) t (m * l).
Proof. intros [G [H K]] D M. exists (fun s => G (h s)). split; [ now apply (is_derive_comp G h) | intros s Hs; now apply K, M ]. Qed.
Ltac clocked := intros; eapply rder_eq; [ eapply (rder_clock _ (fun s => _)); [ eassumption | auto_derive; trivial | intros; nra ] | ring ].
Lemma rder_time c g t l : 0 < c -> rder g (c * t) l -> rder (fun s => g (c * s)) t (c * l).
Proof. clocked. Qed.
Lemma rder_phase g p t l : rder g (p + t) l -> rder (fun s => g (p + s)) t l.
Proof. clocked. Qed.
Lemma rder_after g c t l : rder g (t + c) l -> rder (fun s => g (s + c)) t l.
Proof. clocked. Qed.
Lemma rder_shift g c t l : rder g (t - c) l -> rder (fun s => g (s - c)) t l.
Proof. clocked. Qed.
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

(* ---- continuity ---- *)
Lemma cont_of f t l : is_derive f t l -> continuity_pt f t.
Proof. intros H. apply derivable_continuous_pt. exists l. now apply is_derive_Reals. Qed.
Lemma cont_eps f t e : continuity_pt f t -> 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (f s - f t) < e.
Proof.
  intros C He. destruct (C e He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs. destruct (Req_dec t s) as [<- | N].
  - rewrite Rminus_eq_0, Rabs_R0. exact He.
  - apply Hd. split; [ split; trivial; exact I | exact Hs ].
Qed.
Lemma cont_lip f t r L : 0 < r -> (forall s, Rabs (s - t) < r -> Rabs (f s - f t) <= L * Rabs (s - t)) -> continuity_pt f t.
Proof.
  intros r0 H e He. set (c := Rabs L + 1). assert (c0 : 0 < c) by (unfold c; pose proof (Rabs_pos L); lra). exists (Rmin r (e / c)).
  split. apply Rmin_pos; trivial. now apply Rdiv_lt_0_compat. intros s [_ Hs]. simpl in *. unfold R_dist in *.
  pose proof (Rmin_l r (e / c)). pose proof (Rmin_r r (e / c)). specialize (H s ltac:(lra)). assert (Rabs (s - t) * c < e) by (apply Rlt_div_r; lra).
  pose proof (Rle_abs L). pose proof (Rabs_pos (s - t)). unfold c in *. nra.
Qed.
(* f is g up to t and h from t on *)
Lemma cont_glue f g h t d : 0 < d -> (forall s, t - d < s <= t -> f s = g s) -> (forall s, t <= s < t + d -> f s = h s) ->
  continuity_pt g t -> continuity_pt h t -> continuity_pt f t.
Proof.
  intros Hd Eg Eh Cg Ch e He. destruct (Cg e He) as (a & a0 & Ha). destruct (Ch e He) as (b & b0 & Hb).
  exists (Rmin d (Rmin a b)). split; [ repeat apply Rmin_pos; trivial | ]. intros s [Hs1 Hs]. simpl in *. unfold R_dist in *.
  apply Rmin_Rgt_l in Hs as [q Hs]. apply Rmin_Rgt_l in Hs as [qa qb]. pose proof (Rabs_def2 _ _ q). destruct (Rle_lt_dec s t).
  - rewrite (Eg s), (Eg t) by lra. now apply Ha.
  - rewrite (Eh s), (Eh t) by lra. now apply Hb.
Qed.
Lemma cont_ext f g t : 0 < t -> (forall s, 0 <= s -> f s = g s) -> continuity_pt f t -> continuity_pt g t.
Proof. intros t0 E C. apply (cont_glue g f f t t); trivial; intros; symmetry; apply E; lra. Qed.
Lemma cont_inv f t : continuity_pt f t -> f t <> 0 -> continuity_pt (fun s => / f s) t.
Proof. apply continuity_pt_inv. Qed.
Lemma cont_root f t : continuity_pt f t -> 0 <= f t -> continuity_pt (fun s => sqrt (f s)) t.
Proof. intros H P. apply (continuity_pt_comp f sqrt); trivial. apply continuity_pt_sqrt, P. Qed.
Lemma cont_time c g t : continuity_pt g (c * t) -> continuity_pt (fun s => g (c * s)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => c * s) g); trivial. cont. Qed.
Lemma cont_phase g p t : continuity_pt g (p + t) -> continuity_pt (fun s => g (p + s)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => p + s) g); trivial. cont. Qed.
Lemma cont_after g c t : continuity_pt g (t + c) -> continuity_pt (fun s => g (s + c)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => s + c) g); trivial. cont. Qed.
Lemma cont_shift g c t : continuity_pt g (t - c) -> continuity_pt (fun s => g (s - c)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => s - c) g); trivial. cont. Qed.
(* what is never 0 keeps its sign *)
Lemma keeps_sign f l t : 0 <= t -> (forall s, 0 < s <= t -> continuity_pt f s) -> rder f 0 l -> (forall s, 0 <= s <= t -> f s <> 0) ->
  0 < f 0 -> 0 < f t.
Proof.
  intros Ht C D N P. destruct (rder_near_pos f 0 l D P) as (d & d0 & Hd). apply Rnot_le_lt. intros B.
  assert (t0 : t <> 0) by (intros ->; lra). set (s := Rmin d t / 2). assert (q : 0 < Rmin d t) by (apply Rmin_pos; lra).
  pose proof (Rmin_l d t). pose proof (Rmin_r d t). specialize (Hd s ltac:(unfold s; lra)). rewrite Rplus_0_l in Hd.
  assert (f t <> 0) by (apply N; lra).
  destruct (Ranalysis5.IVT_interv (fun r => - f r) s t) as (z & hz & ez); try (unfold s; lra); try lra.
  - intros r Hr. apply (continuity_pt_opp f), C. unfold s in Hr. lra.
  - apply (N z); [ unfold s in hz | ]; lra.
Qed.
(* a function with a positive derivative rises *)
Lemma up f f' a b : a < b -> (forall c, a <= c <= b -> is_derive f c (f' c)) -> (forall c, a < c < b -> 0 < f' c) -> f a < f b.
Proof. intros H D P. destruct (MVT_cor2 f f' a b H) as (c & E & Hc). { intros; now apply is_derive_Reals, D. } specialize (P c Hc). nra. Qed.
(* the primitive of a continuous function *)
Lemma primitive_rate g : (forall t, continuity_pt g t) -> forall t, is_derive (RInt g 0) t (g t).
Proof.
  intros H t. assert (C : forall s, continuous g s) by (intros s; apply continuity_pt_filterlim, H). apply (is_derive_RInt g (RInt g 0) 0 t), C.
  exists (mkposreal 1 Rlt_0_1). intros s _. apply (RInt_correct g 0 s), (ex_RInt_continuous g 0 s). auto.
Qed.
(* a property that holds at a, passes to limits from the left and a little to the right holds on [a, b] *)
Lemma real_ind (P : R -> Prop) a b : P a -> (forall t, a < t <= b -> (forall s, a <= s < t -> P s) -> P t) ->
  (forall t, a <= t < b -> (forall s, a <= s <= t -> P s) -> exists d, 0 < d /\ forall s, t < s < t + d -> P s) ->
  forall t, a <= t <= b -> P t.
Proof.
  intros H0 H1 H2. enough (K : forall t, a <= t <= b -> forall s, a <= s <= t -> P s) by (intros t Ht; apply (K t); lra).
  intros t Ht. apply Classical_Prop.NNPP. intros bad.
  set (S := fun r => a <= r <= t /\ forall s, a <= s <= r -> P s).
  assert (Sa : S a) by (split; [ lra | intros s Hs; replace s with a by lra; exact H0 ]).
  destruct (completeness S) as [c [c1 c2]]. { exists t. intros r [Hr _]. lra. } { now exists a. }
  assert (ac : a <= c) by (apply c1, Sa). assert (ct : c <= t) by (apply c2; intros r [Hr _]; lra).
  assert (L : forall s, a <= s < c -> P s).
  { intros s Hs. apply Classical_Prop.NNPP. intros n. assert (c <= s); [ | lra ]. apply c2. intros r [Hr Q].
    apply Rnot_lt_le. intros k. apply n, Q. lra. }
  assert (Q : forall s, a <= s <= c -> P s).
  { intros s [s0 [s1 | ->]]. apply L; lra. destruct s0 as [s0 | <-]; trivial. apply H1; trivial; lra. }
  destruct (Req_dec c t) as [-> | ne]. now apply bad.
  destruct (H2 c ltac:(lra) Q) as (d & d0 & Hd). set (r := c + Rmin d (t - c) / 2).
  assert (0 < Rmin d (t - c)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (t - c)). pose proof (Rmin_r d (t - c)).
  assert (Sr : S r). { split. unfold r; lra. intros s Hs. destruct (Rle_lt_dec s c). apply Q; lra. apply Hd. unfold r in Hs; lra. }
  specialize (c1 r Sr). unfold r in c1. lra.
Qed.

(* ---- sines ---- *)
Lemma unit_circle x : cos x ^ 2 + sin x ^ 2 = 1.
Proof. rewrite <- !Rsqr_pow2, Rplus_comm. apply sin2_cos2. Qed.
Lemma sin_per t : sin (t + 2 * PI) = sin t.
Proof. rewrite <- (sin_period t 1). f_equal. simpl. ring. Qed.
Lemma cos_per t : cos (t + 2 * PI) = cos t.
Proof. rewrite <- (cos_period t 1). f_equal. simpl. ring. Qed.
Lemma sin_near a b : Rabs (sin a - sin b) <= Rabs (a - b).
Proof.
  rewrite <- (Rmult_1_l (Rabs (a - b))). apply (bounded_variation sin cos). intros t _. split; [ apply is_derive_sin | apply Rabs_le, COS_bound ].
Qed.
Lemma cos_near a b : Rabs (cos a - cos b) <= Rabs (a - b).
Proof.
  rewrite <- (Rmult_1_l (Rabs (a - b))). apply (bounded_variation cos (fun t => - sin t)). intros t _. split; [ apply is_derive_cos | ].
  rewrite Rabs_Ropp. apply Rabs_le, SIN_bound.
Qed.
Lemma sin_abs d : Rabs (sin d) <= Rabs d.
Proof. pose proof (sin_near d 0) as H. now rewrite sin_0, !Rminus_0_r in H. Qed.
Lemma twice_atan z : cos (2 * atan z) = (1 - z ^ 2) / (1 + z ^ 2) /\ sin (2 * atan z) = 2 * z / (1 + z ^ 2).
Proof.
  rewrite cos_2a, sin_2a, sin_atan, cos_atan, Rsqr_pow2. pose proof (pow2_ge_0 z). pose proof (pow2_sqrt (1 + z ^ 2) ltac:(lra)) as s.
  set (r := sqrt _) in *. assert (r <> 0) by (intros k; rewrite k in s; lra). rewrite <- s. split; field; trivial.
Qed.
Lemma cos_asin_pow x : -1 <= x <= 1 -> cos (asin x) = sqrt (1 - x ^ 2).
Proof. intros H. rewrite cos_asin by trivial. f_equal. unfold Rsqr. ring. Qed.
Lemma asin_range l : 0 < l < 1 -> 0 < asin l < PI / 2 /\ sin (asin l) = l.
Proof.
  intros hl. assert (e : sin (asin l) = l) by (apply sin_asin; lra). assert (b : - (PI / 2) < asin l < PI / 2) by (apply asin_bound_lt; lra).
  repeat split; trivial; try lra. apply Rnot_le_lt. intros k. pose proof (sin_incr_1 (asin l) 0). rewrite sin_0 in *. lra.
Qed.
(* where the sine is above l, and where below *)
Lemma sin_above l x : 0 < l < 1 -> asin l < x < PI - asin l -> l < sin x.
Proof.
  intros hl H. destruct (asin_range l hl) as [[a b] e]. rewrite <- e. destruct (Rle_lt_dec x (PI / 2)).
  - apply sin_increasing_1; lra.
  - rewrite <- (sin_PI_x x). apply sin_increasing_1; lra.
Qed.
Lemma sin_less l t : 0 < l < 1 -> PI - asin l < t < 2 * PI + asin l -> sin t < l.
Proof.
  intros hl H. destruct (asin_range l hl) as [[a b] e]. rewrite <- e. destruct (Rle_lt_dec t (3 * (PI / 2))).
  - rewrite <- (sin_PI_x t). apply sin_increasing_1; lra.
  - replace t with (t - 2 * PI + 2 * PI) by ring. rewrite sin_per. apply sin_increasing_1; lra.
Qed.

(* ---- hyperbolic functions ---- *)
Lemma exp_both a : exp a * exp (- a) = 1.
Proof. rewrite <- exp_plus, Rplus_opp_r. apply exp_0. Qed.
Lemma cosh_pos a : 0 < cosh a.
Proof. unfold cosh. pose proof (exp_pos a). pose proof (exp_pos (- a)). lra. Qed.
Lemma cosh2 a : cosh a ^ 2 = 1 + sinh a ^ 2.
Proof. unfold cosh, sinh. pose proof (exp_both a). nra. Qed.
Lemma cosh_from_1 a : 1 <= cosh a.
Proof. pose proof (cosh2 a). pose proof (cosh_pos a). nra. Qed.
Lemma cosh_double a : cosh (2 * a) = 1 + 2 * sinh a ^ 2.
Proof. unfold cosh, sinh. pose proof (exp_both a). replace (2 * a) with (a + a) by ring. rewrite Ropp_plus_distr, !exp_plus. nra. Qed.
Lemma sinh_double a : sinh (2 * a) = 2 * sinh a * cosh a.
Proof. unfold cosh, sinh. replace (2 * a) with (a + a) by ring. rewrite Ropp_plus_distr, !exp_plus. field. Qed.
Lemma sinh_sign a : 0 < sinh a -> 0 < a.
Proof. intros H. apply Rnot_le_lt. intros [k | ->]; [ apply sinh_lt in k | ]; rewrite sinh_0 in *; lra. Qed.

(* ---- limits for t to infinity ---- *)
Lemma nat_above x : exists n, x < INR n.
Proof.
  destruct (Rle_lt_dec 0 x) as [k | k]; [ | exists 0%nat; exact k ]. destruct (nfloor_ex x k) as [n Hn].
  exists (S n). rewrite S_INR. lra.
Qed.
Lemma lim_zero (f : R -> R) : (forall e, 0 < e -> exists t1, forall t, t1 <= t -> Rabs (f t) <= e) -> is_lim f p_infty 0.
Proof.
  intros H. apply is_lim_spec. intros e. pose proof (cond_pos e). destruct (H (e / 2)) as [t1 h]; [ lra | ]. exists t1. intros t Ht.
  rewrite Rminus_0_r. specialize (h t ltac:(lra)). lra.
Qed.
Lemma lim_eventually (f : R -> R) t1 : (forall t, t1 <= t -> f t = 0) -> is_lim f p_infty 0.
Proof. intros H. apply lim_zero. intros e He. exists t1. intros t Ht. rewrite H, Rabs_R0 by trivial. lra. Qed.
Lemma lim_near (f : R -> R) (l e : R) : is_lim f p_infty l -> 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> l - e < f t < l + e.
Proof.
  intros H He. apply is_lim_spec in H. destruct (H (mkposreal e He)) as [T HT]. simpl in HT. exists (Rmax 0 (T + 1)). split; [ apply Rmax_l | ].
  intros t Ht. pose proof (Rmax_r 0 (T + 1)). specialize (HT t ltac:(lra)). apply Rabs_def2 in HT. lra.
Qed.
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
  split; trivial. intros t Ht. apply Rle_div_l in Ht; trivial. pose proof (Rle_abs (K - b)). lra.
Qed.
Lemma grows_exp a K : 0 < a -> exists T, 0 <= T /\ forall t, T <= t -> K <= exp (a * t).
Proof.
  intros ha. destruct (grows_line a 1 K ha) as (T & T0 & HT). exists T. split; trivial. intros t Ht. specialize (HT t Ht).
  pose proof (exp_ineq1_le (a * t)). lra.
Qed.
(* rd, but with the rates that are known as hypotheses, and quotients *)
Ltac rds := match goal with
  | |- rder _ _ _ => eassumption
  | |- rder (fun _ => ?c) _ _ => apply rder_fixed
  | |- rder (fun t => @?a t + @?b t) _ _ => apply (rder_plus a b); rds
  | |- rder (fun t => @?a t - @?b t) _ _ => apply (rder_minus a b); rds
  | |- rder (fun t => @?a t * @?b t) _ _ => apply (rder_mult a b); rds
  | |- rder (fun t => - @?a t) _ _ => apply (rder_opp a); rds
  | |- rder (fun t => / @?a t) _ _ => apply (rder_inv a); [ rds | ]
  | |- _ => rd
  end.
