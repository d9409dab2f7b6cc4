(* Functions with right derivatives, beyond Motion.v: nothing here is about tables *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

(* f approaches f t from the right *)
Definition right_continuous (f : R -> R) t := forall e, 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> Rabs (f s - f t) < e.

Lemma rder_loc f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> is_derive g t l -> rder f t l.
Proof.
  intros Hd E H. exists (fun s => if Rlt_dec s t then g s else f s). split.
  - apply (is_derive_ext_loc g); trivial. exists (mkposreal d Hd). intros s Hs. change (Rabs (s - t) < d) in Hs.
    apply Rabs_def2 in Hs. destruct (Rlt_dec s t); trivial. apply E; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Lemma rder_near f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> rder g t l -> rder f t l.
Proof. intros Hd E [G [H K]]. apply (rder_loc f G t l d); trivial. intros s Hs. rewrite K by lra. now apply E. Qed.
Lemma rder_unique f t l m : rder f t l -> rder f t m -> l = m.
Proof.
  assert (P : forall l m, rder f t l -> rder f t m -> m <= l).
  { intros l' m' H K. apply le_epsilon. intros e He.
    destruct (rder_step f t l' H (e / 2) ltac:(lra)) as (d1 & p1 & h1).
    destruct (rder_step (fun s => - f s) t (- m') (rder_opp f t m' K) (e / 2) ltac:(lra)) as (d2 & p2 & h2).
    set (h := Rmin d1 d2 / 2). assert (0 < Rmin d1 d2) by (apply Rmin_pos; trivial). pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
    specialize (h1 h ltac:(unfold h; lra)). specialize (h2 h ltac:(unfold h; lra)). assert (0 < h) by (unfold h; lra). nra. }
  intros. apply Rle_antisym; auto.
Qed.
Lemma rder_intro f t l : (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs (f (t + h) - f t - l * h) <= e * h) -> rder f t l.
Proof.
  intros H. exists (fun s => if Rlt_dec s t then f t + l * (s - t) else f s). split.
  - apply is_derive_Reals. intros e He. destruct (H (e / 2) ltac:(lra)) as (d & d0 & Hd). exists (mkposreal d d0). simpl. intros h h0 hd.
    apply Rabs_def2 in hd. destruct (Rlt_dec t t); [ lra | ]. destruct (Rlt_dec (t + h) t).
    + replace ((f t + l * (t + h - t) - f t) / h - l) with 0 by (field; lra). rewrite Rabs_R0. lra.
    + specialize (Hd h ltac:(lra)). replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - l * h) / h) by (field; lra).
      unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ h)) by (left; apply Rinv_0_lt_compat; lra). apply Rle_lt_trans with (e / 2); [ | lra ]. apply Rle_div_l; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Lemma abs_of_sq z k : 0 <= k -> z ^ 2 <= k ^ 2 -> Rabs z <= k.
Proof. intros. apply Rabs_le. split; nra. Qed.
Lemma rder_cube f t l K : 0 <= K -> (forall h, 0 <= h <= 1 -> (f (t + h) - (f t + h * l)) ^ 2 <= K * h ^ 3) -> rder f t l.
Proof.
  intros HK H. apply rder_intro. intros e He. exists (Rmin 1 (e ^ 2 / (K + 1))). split. { apply Rmin_pos; [ lra | apply Rdiv_lt_0_compat; nra ]. }
  intros h Hh. pose proof (Rmin_l 1 (e ^ 2 / (K + 1))). pose proof (Rmin_r 1 (e ^ 2 / (K + 1))). assert (k : h * (K + 1) <= e ^ 2) by (apply Rle_div_r; lra).
  apply abs_of_sq. nra. specialize (H h ltac:(lra)). replace (f (t + h) - f t - l * h) with (f (t + h) - (f t + h * l)) by ring.
  apply Rle_trans with (K * h ^ 3); trivial. replace (K * h ^ 3) with (h ^ 2 * (h * K)) by ring. replace ((e * h) ^ 2) with (h ^ 2 * e ^ 2) by ring. apply Rmult_le_compat_l; nra.
Qed.
Lemma rder_right_continuous f t l : rder f t l -> right_continuous f t.
Proof.
  intros [F [H K]] e He. assert (C : continuity_pt F t) by (apply derivable_continuous_pt; exists l; now apply is_derive_Reals).
  destruct (C e He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs. rewrite <- !K by lra.
  destruct (Req_dec s t) as [-> | ne]. rewrite Rminus_eq_0, Rabs_R0; lra. apply Hd. split. { split. exact I. auto. } simpl. unfold R_dist. apply Rabs_def1; lra.
Qed.
Lemma right_pos f t l : rder f t l -> 0 < f t -> exists d, 0 < d /\ forall s, t < s < t + d -> 0 < f s.
Proof.
  intros H P. destruct (rder_right_continuous f t l H (f t) P) as (d & d0 & Hd). exists d. split; trivial. intros s Hs.
  specialize (Hd s ltac:(lra)). apply Rabs_def2 in Hd. lra.
Qed.
Lemma rder_inv f s l : rder f s l -> f s <> 0 -> rder (fun r => / f r) s (- l / f s ^ 2).
Proof. intros H K. eapply rder_eq. apply (rder_comp f Rinv s l (- / f s ^ 2) H). auto_derive; trivial. field; trivial. field; trivial. Qed.
Lemma rder_root f t l : rder f t l -> 0 < f t -> rder (fun s => sqrt (f s)) t (/ (2 * sqrt (f t)) * l).
Proof. intros H P. apply (rder_comp f sqrt); [ exact H | apply is_derive_Reals, derivable_pt_lim_sqrt, P ]. Qed.
Lemma rder_sin f t l : rder f t l -> rder (fun s => sin (f s)) t (cos (f t) * l).
Proof. intros H. apply (rder_comp f sin); [ exact H | apply is_derive_Reals, derivable_pt_lim_sin ]. Qed.
Lemma cont_root f t : continuity_pt f t -> 0 <= f t -> continuity_pt (fun s => sqrt (f s)) t.
Proof. intros H P. apply (continuity_pt_comp f sqrt); trivial. apply continuity_pt_sqrt, P. Qed.
(* another unit of time *)
Lemma rder_time c g t l : 0 < c -> rder g (c * t) l -> rder (fun s => g (c * s)) t (c * l).
Proof.
  intros Hc [G [H K]]. exists (fun s => G (c * s)). split. 2: intros s Hs; apply K; nra.
  apply (is_derive_comp G (fun s => c * s)). exact H. auto_derive; trivial. ring.
Qed.
Lemma cont_time c g t : continuity_pt g (c * t) -> continuity_pt (fun s => g (c * s)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => c * s) g); trivial. cont. Qed.
(* a property that holds at a, passes to limits from the left and a little to the right holds on [a, b] *)
Lemma real_ind (P : R -> Prop) a b : P a -> (forall t, a < t <= b -> (forall s, a <= s < t -> P s) -> P t) ->
  (forall t, a <= t < b -> (forall s, a <= s <= t -> P s) -> exists d, 0 < d /\ forall s, t < s < t + d -> P s) ->
  forall t, a <= t <= b -> P t.
Proof.
  intros H0 H1 H2. assert (K : forall t, a <= t <= b -> forall s, a <= s <= t -> P s).
  2: { intros t Ht. apply (K t); lra. }
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
(* a length grows no faster than B if it does so whenever it is not 0 *)
Lemma length_below (f g B : R -> R) s t : s <= t -> (forall r, s < r <= t -> continuity_pt f r /\ continuity_pt g r /\ continuity_pt B r) ->
  (forall r, s <= r < t -> exists a b c, rder f r a /\ rder g r b /\ rder B r c /\ 0 <= c /\ f r * a + g r * b <= c * nrm (f r) (g r)) ->
  nrm (f t) (g t) - nrm (f s) (g s) <= B t - B s.
Proof.
  intros Hst C D. apply le_epsilon. intros d Hd. set (q r := sqrt (f r ^ 2 + g r ^ 2 + d ^ 2)). assert (dd : 0 < d ^ 2) by nra.
  assert (pos : forall r, 0 < f r ^ 2 + g r ^ 2 + d ^ 2) by (intros r; pose proof (pow2_ge_0 (f r)); pose proof (pow2_ge_0 (g r)); lra).
  assert (q1 : forall r, nrm (f r) (g r) <= q r <= nrm (f r) (g r) + d).
  { intros r. pose proof (nrm_pos (f r) (g r)). split. apply sqrt_le_1_alt; lra.
    rewrite <- (sqrt_pow2 (nrm (f r) (g r) + d)) by lra. apply sqrt_le_1_alt. rewrite <- nrm_sq. nra. }
  assert (K : q t - B t <= q s - B s).
  { apply (rder_decr (fun r => q r - B r)); trivial; intros r Hr; [ destruct (C r Hr) as (c1 & c2 & c3) | destruct (D r Hr) as (a & b & c & F & G & H & c0 & P) ].
    - apply (continuity_pt_minus q B); trivial. apply cont_root; [ cont | left; apply pos ].
    - eexists. split. apply (rder_minus q B); [ apply rder_root; [ rd | apply pos ] | exact H ]. simpl INR. simpl pred. cbv beta.
      change (sqrt (f r ^ 2 + g r ^ 2 + d ^ 2)) with (q r). assert (qq : 0 < q r) by (apply sqrt_lt_R0, pos). specialize (q1 r).
      match goal with |- ?z - c <= 0 => replace z with ((f r * a + g r * b) / q r) by (field; lra) end.
      enough ((f r * a + g r * b) / q r <= c) by lra. apply Rle_div_l; trivial. nra. }
  pose proof (q1 t). pose proof (q1 s). lra.
Qed.
