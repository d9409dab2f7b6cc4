(* Functions in pieces: they have the derivative of the piece that begins; squares and order. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

Lemma sq_lt a b : 0 <= a < b -> a ^ 2 < b ^ 2. Proof. intros. nra. Qed.
Lemma sq_lt_inv a b : 0 <= b -> a ^ 2 < b ^ 2 -> a < b. Proof. intros. nra. Qed.

Lemma rder_loc f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> is_derive g t l -> rder f t l.
Proof.
  intros Hd E H. exists (fun s => if Rlt_dec s t then g s else f s). split.
  - apply (is_derive_ext_loc g); trivial. exists (mkposreal d Hd). intros s Hs. change (Rabs (s - t) < d) in Hs.
    apply Rabs_def2 in Hs. destruct (Rlt_dec s t); trivial. apply E; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Lemma cont_glue f g h t d : 0 < d -> (forall s, t - d < s <= t -> f s = g s) -> (forall s, t <= s < t + d -> f s = h s) ->
  continuity_pt g t -> continuity_pt h t -> continuity_pt f t.
Proof.
  intros Hd Eg Eh Cg Ch e He. destruct (Cg e He) as (a & a0 & Ha). destruct (Ch e He) as (b & b0 & Hb).
  exists (Rmin d (Rmin a b)). split; [ repeat apply Rmin_pos; trivial | ].
  intros s [Hs1 Hs]. simpl in *. unfold R_dist in *.
  pose proof (Rmin_l d (Rmin a b)). pose proof (Rmin_r d (Rmin a b)). pose proof (Rmin_l a b). pose proof (Rmin_r a b).
  pose proof (Rabs_def2 _ _ Hs). destruct (Rle_lt_dec s t).
  - rewrite (Eg s), (Eg t) by lra. apply Ha. split; trivial. lra.
  - rewrite (Eh s), (Eh t) by lra. apply Hb. split; trivial. lra.
Qed.

Lemma nrm_forward x : 0 <= x -> nrm x 0 = x.
Proof. intros H. unfold nrm. replace (x ^ 2 + 0 ^ 2) with (Rsqr x) by (unfold Rsqr; ring). now apply sqrt_Rsqr. Qed.
(* there is one right derivative *)
Lemma rder_unique f g t l m d : 0 < d -> (forall s, t <= s < t + d -> f s = g s) -> rder f t l -> rder g t m -> l = m.
Proof.
  intros hd. assert (A : forall f g l m, (forall s, t <= s < t + d -> f s = g s) -> rder f t l -> rder g t m -> m <= l).
  { clear f g l m. intros f g l m E F G. apply le_epsilon. intros e he. destruct (rder_step _ _ _ F (e / 2) ltac:(lra)) as (a & a0 & A).
    destruct (rder_step _ _ _ (rder_opp _ _ _ G) (e / 2) ltac:(lra)) as (b & b0 & B). cbv beta in B. set (x := Rmin d (Rmin a b) / 2).
    pose proof (Rmin_l d (Rmin a b)). pose proof (Rmin_r d (Rmin a b)). pose proof (Rmin_l a b). pose proof (Rmin_r a b).
    assert (0 < Rmin d (Rmin a b)) by (repeat apply Rmin_pos; trivial). assert (xx : 0 < x /\ x < a /\ x < b /\ x < d) by (unfold x; lra).
    specialize (A x ltac:(lra)). specialize (B x ltac:(lra)). rewrite !E in A by lra. nra. }
  intros E F G. apply Rle_antisym; [ apply (A g f) | apply (A f g) ]; trivial. intros s Hs. symmetry. now apply E.
Qed.
