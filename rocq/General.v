(* What holds of every motion with friction *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

(* (a) two motions under one drive never move apart *)
Theorem contraction k Ax Ay x1 y1 x2 y2 : 0 <= k ->
  motion k Ax Ay x1 y1 -> motion k Ax Ay x2 y2 -> forall s t, 0 <= s <= t ->
  (x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 <= (x1 s - x2 s) ^ 2 + (y1 s - y2 s) ^ 2.
Proof.
  intros Hk [c1 d1 M1] [c2 d2 M2] s t Hst.
  apply (rder_decr (fun t => (x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2)); [ lra | | ]; intros u Hu.
  - cont; match goal with H : _ |- _ => apply H; lra end.
  - destruct (M1 u) as (fx1 & fy1 & [B1 P1] & X1 & Y1); [ lra | ].
    destruct (M2 u) as (fx2 & fy2 & [B2 P2] & X2 & Y2); [ lra | ].
    eexists. split. rd. simpl.
    pose proof (power_bound _ _ _ (x1 u) (y1 u) Hk B2). pose proof (power_bound _ _ _ (x2 u) (y2 u) Hk B1). lra.
Qed.

Corollary uniqueness k Ax Ay x1 y1 x2 y2 : 0 <= k ->
  motion k Ax Ay x1 y1 -> motion k Ax Ay x2 y2 -> x1 0 = x2 0 -> y1 0 = y2 0 ->
  forall t, 0 <= t -> x1 t = x2 t /\ y1 t = y2 t.
Proof.
  intros Hk M1 M2 e1 e2 t Ht. pose proof (contraction _ _ _ _ _ _ _ Hk M1 M2 0 t ltac:(lra)) as H.
  rewrite e1, e2 in H. destruct (sq_sum (x1 t - x2 t) (y1 t - y2 t)); lra.
Qed.

(* s2-perpendicular-decays, first half *)
Theorem across_falls k Ax vx vy : 0 <= k -> motion k Ax (fun _ => 0) vx vy ->
  forall s t, 0 <= s <= t -> vy t ^ 2 <= vy s ^ 2.
Proof.
  intros Hk [c d M] s t Hst.
  apply (rder_decr (fun t => vy t ^ 2)); [ lra | | ]; intros u Hu.
  - cont; apply d; lra.
  - destruct (M u) as (fx & fy & C & X & Y); [ lra | ]. eexists. split. rd. simpl.
    destruct (coulomb_slip _ _ _ _ _ Hk C) as [_ e]. pose proof (nrm_sq (vx u) (vy u)).
    destruct (nrm_pos (vx u) (vy u)) as [p | p].
    + assert (vy u * fy <= 0). { apply (Rmult_le_reg_l (nrm (vx u) (vy u))); [ trivial | ]. replace (nrm (vx u) (vy u) * (vy u * fy)) with (- k * vy u ^ 2) by (rewrite <- Rmult_assoc, (Rmult_comm _ (vy u)), Rmult_assoc, e; ring). pose proof (pow2_ge_0 (vy u)). nra. } lra.
    + assert (vy u = 0) as -> by nra. lra.
Qed.

(* weak drive: rest lasts *)
Theorem rest_lasts k Ax Ay vx vy s : 0 <= k -> motion k Ax Ay vx vy -> 0 <= s ->
  (forall t, s <= t -> nrm (Ax t) (Ay t) <= k) -> vx s = 0 -> vy s = 0 ->
  forall t, s <= t -> vx t = 0 /\ vy t = 0.
Proof.
  intros Hk [c d M] Hs HA e1 e2 t Hst. apply sq_sum.
  replace 0 with (vx s ^ 2 + vy s ^ 2) by (rewrite e1, e2; ring).
  apply (rder_decr (fun t => vx t ^ 2 + vy t ^ 2)); [ lra | | ]; intros u Hu.
  - cont; [ apply c | apply d ]; lra.
  - destruct (M u) as (fx & fy & [B P] & X & Y); [ lra | ]. eexists. split. rd. simpl.
    assert (Q : Ax u ^ 2 + Ay u ^ 2 <= k ^ 2).
    { rewrite <- nrm_sq. pose proof (nrm_pos (Ax u) (Ay u)). specialize (HA u). apply pow_incr. split; [ | apply HA ]; lra. }
    pose proof (power_bound _ _ _ (vx u) (vy u) Hk Q). lra.
Qed.

(* s2-stops-if-weak, with the time *)
Theorem weak_stops k a Ax Ay vx vy : 0 <= a < k -> motion k Ax Ay vx vy ->
  (forall t, 0 <= t -> nrm (Ax t) (Ay t) <= a) ->
  forall t, nrm (vx 0) (vy 0) / (k - a) <= t -> vx t = 0 /\ vy t = 0.
Proof.
  intros Ha M HA t Ht. pose proof M as [c d L].
  assert (t0 : 0 <= t). { eapply Rle_trans; [ | apply Ht ]. apply Rmult_le_pos. apply nrm_pos. left. apply Rinv_0_lt_compat. lra. }
  apply (Rmult_le_compat_r (k - a)) in Ht; [ | lra ]. unfold Rdiv in Ht. rewrite Rmult_assoc, Rinv_l in Ht by lra.
  assert (K : nrm (vx t) (vy t) = 0 -> vx t = 0 /\ vy t = 0).
  { intros e. apply sq_sum. rewrite <- nrm_sq, e. lra. }
  destruct (Req_dec (nrm (vx t) (vy t)) 0) as [z | z]; [ auto | exfalso ].
  assert (N : forall s, 0 <= s < t -> nrm (vx s) (vy s) <> 0).
  { intros s Hs e. destruct (rest_lasts k Ax Ay vx vy s) with (t := t) as [e1 e2]; try lra; trivial.
    - intros u Hu. specialize (HA u). lra.
    - pose proof (nrm_sq (vx s) (vy s)). rewrite e in *. nra.
    - pose proof (nrm_sq (vx s) (vy s)). rewrite e in *. nra.
    - apply z. rewrite e1, e2. unfold nrm. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. apply sqrt_0. }
  assert (F : nrm (vx t) (vy t) + (k - a) * t <= nrm (vx 0) (vy 0) + (k - a) * 0).
  { apply (rder_decr (fun t => nrm (vx t) (vy t) + (k - a) * t)); [ lra | | ]; intros u Hu.
    - cont; [ apply c | apply d ]; lra.
    - destruct (L u) as (fx & fy & [B P] & X & Y); [ lra | ]. eexists. split. rd. apply N; lra.
      set (n := nrm (vx u) (vy u)) in *. assert (0 < n) by (pose proof (nrm_pos (vx u) (vy u)); specialize (N u Hu); unfold n in *; lra).
      assert (Q : Ax u ^ 2 + Ay u ^ 2 <= a ^ 2).
      { rewrite <- nrm_sq. pose proof (nrm_pos (Ax u) (Ay u)). specialize (HA u). apply pow_incr. split; [ | apply HA ]; lra. }
      pose proof (power_bound _ _ _ (vx u) (vy u) (proj1 Ha) Q). fold n in H0.
      replace (vx u * (fx - Ax u) + vy u * (fy - Ay u)) with ((fx * vx u + fy * vy u) - (Ax u * vx u + Ay u * vy u)) by ring.
      assert ((fx * vx u + fy * vy u - (Ax u * vx u + Ay u * vy u)) / n <= - (k - a)).
      { apply Rle_div_l; [ lra | ]. lra. } lra. }
  pose proof (nrm_pos (vx t) (vy t)). lra.
Qed.
