(* Functions without a right derivative: they do not grow if no step upwards is steeper than any eps *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General.
Open Scope R_scope.

Lemma dini_decr f a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) ->
  (forall t, a <= t < b -> forall eps, 0 < eps -> exists d, 0 < d /\ forall h, 0 < h < d -> f (t + h) <= f t + eps * h) -> f b <= f a.
Proof.
  intros Hab Hc Hd. apply le_epsilon. intros eps0 Heps0.
  destruct Hab as [Hab | <-]; [ | lra ].
  set (e := eps0 / (b - a)). assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  replace eps0 with (e * (b - a)) by (unfold e; field; lra).
  destruct (Rle_lt_dec (f b) (f a + e * (b - a))) as [ok | bad]; [ exact ok | exfalso ].
  set (S := fun t => a <= t <= b /\ f t <= f a + e * (t - a)).
  destruct (completeness S) as [s [Hs1 Hs2]].
  { exists b. intros x [Hx _]. lra. }
  { exists a. split; lra. }
  assert (Ha : a <= s) by (apply Hs1; split; lra).
  assert (Hb : s <= b) by (apply Hs2; intros x [Hx _]; lra).
  assert (Hin : f s <= f a + e * (s - a)).
  { destruct (Rle_lt_dec (f s) (f a + e * (s - a))) as [ok | b2]; [ exact ok | exfalso ].
    assert (s <> a) by (intros ->; lra).
    set (g := fun t : R => f t - (f a + e * (t - a))).
    assert (C : continuity_pt g s).
    { apply continuity_pt_minus. apply Hc; lra.
      apply derivable_continuous_pt. reg. }
    assert (P : locally s (fun t : R => 0 < g t)).
    { apply continuity_pt_filterlim in C. apply (C (fun y => 0 < y)). apply (open_gt 0). unfold g; lra. }
    destruct P as [d P]. 
    assert (U : is_upper_bound S (s - d / 2)).
    { intros x [Hx1 Hx2]. destruct (Rle_lt_dec x (s - d/2)) as [k|k]; [ exact k | exfalso ].
      assert (x <= s) by (apply Hs1; split; assumption).
      assert (Q : ball s d x). { change (Rabs (x - s) < d). apply Rabs_def1; destruct d; simpl in *; lra. }
      specialize (P x Q). unfold g in P; simpl in P; lra. }
    specialize (Hs2 _ U). destruct d; simpl in *; lra. }
  assert (s <> b) by (intros ->; lra).
  destruct (Hd s ltac:(lra) e He) as [d [d0 Hh]].
  set (h := Rmin d (b - s) / 2).
  assert (0 < Rmin d (b - s)) by (apply Rmin_pos; lra).
  assert (h1 : 0 < h < d) by (unfold h; pose proof (Rmin_l d (b - s)); lra).
  assert (h2 : h < b - s) by (unfold h; pose proof (Rmin_r d (b - s)); lra).
  specialize (Hh h h1).
  assert (S (s + h)) by (split; [ lra | nra ]).
  specialize (Hs1 _ H1). lra.
Qed.

(* a function below M, or at M and not growing, stays below M to first order *)
Lemma below_step f t l M : rder f t l -> f t <= M -> (M <= f t -> l <= 0) -> forall eps, 0 < eps -> exists d, 0 < d /\ forall h, 0 < h < d -> f (t + h) <= M + eps * h.
Proof.
  intros H h1 h2 eps he. destruct (Rle_lt_dec M (f t)) as [k | k].
  - destruct (rder_step _ _ _ H eps he) as (d & d0 & S). exists d. split; trivial. intros h hh. specialize (S h hh). specialize (h2 k). nra.
  - destruct (rder_step _ _ _ H 1 ltac:(lra)) as (d & d0 & S). set (c := Rabs l + 1). assert (0 < c) by (unfold c; pose proof (Rabs_pos l); lra).
    exists (Rmin d ((M - f t) / c)). split. apply Rmin_pos; trivial. apply Rdiv_lt_0_compat; lra.
    intros h hh. pose proof (Rmin_l d ((M - f t) / c)). pose proof (Rmin_r d ((M - f t) / c)). specialize (S h ltac:(lra)).
    assert (c * h <= M - f t). { replace (M - f t) with (c * ((M - f t) / c)) by (field; lra). apply Rmult_le_compat_l; lra. }
    pose proof (Rle_abs l). unfold c in *. nra.
Qed.
