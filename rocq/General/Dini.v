(* Functions without a right derivative: they do not grow if no step upwards is steeper than any eps *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis.
Open Scope R_scope.

Lemma dini_decr f a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) ->
  (forall t, a <= t < b -> forall eps, 0 < eps -> exists d, 0 < d /\ forall h, 0 < h < d -> f (t + h) <= f t + eps * h) -> f b <= f a.
Proof.
  intros Hab Hc Hd. apply Rnot_lt_le. intros k. assert (ab : a < b) by (destruct Hab as [ | <-]; lra). set (e := (f b - f a) / (2 * (b - a))).
  assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  assert (f b <= f a + e * (b - a)). 2: { replace (e * (b - a)) with ((f b - f a) / 2) in H by (unfold e; field; lra). lra. }
  apply (real_ind (fun t => f t <= f a + e * (t - a)) a b); try lra.
  - intros t Ht H. apply Rnot_lt_le. intros n. destruct (left_pos (fun s => f s - (f a + e * (s - a))) t) as (d & d0 & P); [ specialize (Hc t Ht);
    cont | lra | ].
    assert (0 < Rmin d (t - a)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (t - a)). pose proof (Rmin_r d (t - a)).
    specialize (P (t - Rmin d (t - a) / 2) ltac:(lra)). specialize (H (t - Rmin d (t - a) / 2) ltac:(lra)). lra.
  - intros t Ht H. destruct (Hd t Ht e He) as (d & d0 & D). exists d. split; trivial. intros s Hs. specialize (D (s - t) ltac:(lra)).
    specialize (H t ltac:(lra)). replace (t + (s - t)) with s in D by ring. lra.
Qed.

(* a function below M, or at M and not growing, stays below M to first order *)
Lemma below_step f t l M : rder f t l -> f t <= M -> (M <= f t -> l <= 0) -> forall eps, 0 < eps -> exists d, 0 < d /\ forall h,
  0 < h < d -> f (t + h) <= M + eps * h.
Proof.
  intros H h1 h2 eps he. destruct (Rle_lt_dec M (f t)) as [k | k].
  - destruct (rder_step _ _ _ H eps he) as (d & d0 & S). exists d. split; trivial. intros h hh. specialize (S h hh). specialize (h2 k). nra.
  - destruct (rder_step _ _ _ H 1 ltac:(lra)) as (d & d0 & S). set (c := Rabs l + 1). assert (0 < c) by (unfold c; pose proof (Rabs_pos l); lra).
    exists (Rmin d ((M - f t) / c)). split. apply Rmin_pos; trivial. apply Rdiv_lt_0_compat; lra.
    intros h hh. pose proof (Rmin_l d ((M - f t) / c)). pose proof (Rmin_r d ((M - f t) / c)). specialize (S h ltac:(lra)).
    assert (c * h <= M - f t). { replace (M - f t) with (c * ((M - f t) / c)) by (field; lra). apply Rmult_le_compat_l; lra. }
    pose proof (Rle_abs l). unfold c in *. nra.
Qed.
