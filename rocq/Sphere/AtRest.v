(* What the right derivative says at rest: it is one number, and 0 where the function is 0 for a while. So a particle that rests for a while needs
   |A| <= mu g, and a place on the turntable holds a particle at rest just when its distance from the axis is at most mu g / Omega^2. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Turntable.
Open Scope R_scope.

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
Lemma rder_zero f t d : 0 < d -> (forall s, t <= s < t + d -> f s = 0) -> rder f t 0.
Proof.
  intros Hd H. exists (fun s => if Rlt_dec s (t + d) then 0 else f s). split.
  - apply (is_derive_ext_loc (fun _ => 0)); [ | auto_derive; trivial ]. exists (mkposreal d Hd). intros s Hs. change (Rabs (s - t) < d) in Hs.
    apply Rabs_def2 in Hs.
    destruct (Rlt_dec s (t + d)); trivial. lra.
  - intros s Hs. destruct (Rlt_dec s (t + d)); trivial. symmetry. apply H. lra.
Qed.
(* s2-no-permanent-rest: while at rest, |A| <= mu g *)
Theorem rest_needs k Ax Ay vx vy s d : 0 <= k -> motion k Ax Ay vx vy -> 0 <= s -> 0 < d ->
  (forall t, s <= t < s + d -> vx t = 0 /\ vy t = 0) -> nrm (Ax s) (Ay s) <= k.
Proof.
  intros Hk M Hs Hd H. destruct (m_law _ _ _ _ _ M s Hs) as (fx & fy & [B _] & X & Y).
  assert (X0 : rder vx s 0) by (apply (rder_zero vx s d); trivial; intros; now apply H).
  assert (Y0 : rder vy s 0) by (apply (rder_zero vy s d); trivial; intros; now apply H).
  pose proof (rder_unique _ _ _ _ X X0). pose proof (rder_unique _ _ _ _ Y Y0).
  unfold nrm. rewrite <- (sqrt_pow2 k) by trivial. apply sqrt_le_1_alt. replace (Ax s) with fx by lra. replace (Ay s) with fy by lra. exact B.
Qed.
(* s4-rest-radius, both ways *)
Theorem rest_radius a b : spin (fun _ => a) (fun _ => b) (fun _ => 0) (fun _ => 0) <-> a ^ 2 + b ^ 2 <= 1.
Proof.
  assert (n0 : nrm 0 0 = 0) by (unfold nrm; replace (0 ^ 2 + 0 ^ 2) with 0 by ring; apply sqrt_0).
  assert (Z : forall c t, rder (fun _ => c) t 0) by (intros; apply rder_of; auto_derive; trivial). split.
  - intros S. destruct (s_law _ _ _ _ S 0 (Rle_refl 0)) as (_ & _ & fx & fy & [B _] & U & W).
    pose proof (rder_unique _ _ _ _ U (Z 0 0)). pose proof (rder_unique _ _ _ _ W (Z 0 0)). replace a with (- fx) by lra.
      replace b with (- fy) by lra. nra.
  - intros H. split; [ intros; cont | intros; cont | intros; cont | intros; cont | ]. intros t _. split; [ apply Z | split; [ apply Z | ] ].
    exists (- a), (- b). split; [ split; [ nra | rewrite n0; ring ] | ].
    split; (eapply rder_eq; [ apply Z | ring ]).
Qed.
