(* Functions with right derivatives, beyond Motion.v: nothing here is about tables *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
From Slipbook.General Require Import Rates.
Open Scope R_scope.

(* f approaches f t from the right *)
Definition right_continuous (f : R -> R) t := forall e, 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> Rabs (f s - f t) < e.

Lemma rder_near f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> rder g t l -> rder f t l.
Proof. apply rder_ext. Qed.
Lemma rder_unique f t l m : rder f t l -> rder f t m -> l = m.
Proof. apply rder_one. Qed.
Lemma abs_of_sq z k : 0 <= k -> z ^ 2 <= k ^ 2 -> Rabs z <= k.
Proof. intros. apply Rabs_le. split; nra. Qed.
Lemma rder_cube f t l K : 0 <= K -> (forall h, 0 <= h <= 1 -> (f (t + h) - (f t + h * l)) ^ 2 <= K * h ^ 3) -> rder f t l.
Proof.
  intros HK H. apply rder_intro. intros e He. exists (Rmin 1 (e ^ 2 / (K + 1))). split. { apply Rmin_pos; [ lra | apply Rdiv_lt_0_compat; nra ]. }
  intros h Hh. pose proof (Rmin_l 1 (e ^ 2 / (K + 1))). pose proof (Rmin_r 1 (e ^ 2 / (K + 1))).
    assert (k : h * (K + 1) <= e ^ 2) by (apply Rle_div_r; lra).
  apply abs_of_sq. nra. specialize (H h ltac:(lra)). replace (f (t + h) - f t - l * h) with (f (t + h) - (f t + h * l)) by ring.
  apply Rle_trans with (K * h ^ 3); trivial. replace (K * h ^ 3) with (h ^ 2 * (h * K)) by ring. replace ((e * h) ^ 2) with (h ^ 2 * e ^ 2) by ring.
    apply Rmult_le_compat_l; nra.
Qed.
Lemma rder_right_continuous f t l : rder f t l -> right_continuous f t.
Proof.
  intros [F [H K]] e He. assert (C : continuity_pt F t) by (apply derivable_continuous_pt; exists l; now apply is_derive_Reals).
  destruct (C e He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs. rewrite <- !K by lra.
  destruct (Req_dec s t) as [-> | ne]. rewrite Rminus_eq_0, Rabs_R0; lra. apply Hd. split. { split. exact I. auto. } simpl. unfold R_dist.
    apply Rabs_def1; lra.
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
(* another unit of time *)
Lemma rder_time c g t l : 0 < c -> rder g (c * t) l -> rder (fun s => g (c * s)) t (c * l).
Proof.
  intros Hc [G [H K]]. exists (fun s => G (c * s)). split. 2: intros s Hs; apply K; nra.
  apply (is_derive_comp G (fun s => c * s)). exact H. auto_derive; trivial. ring.
Qed.
Lemma cont_time c g t : continuity_pt g (c * t) -> continuity_pt (fun s => g (c * s)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => c * s) g); trivial. cont. Qed.
