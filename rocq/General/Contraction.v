(* Lemmas on every motion in the plane: two of them never move apart, rest under a weak drive lasts, the rates while it slips, turned axes. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis.
Open Scope R_scope.

(* where this is imported, cont knows that the velocity of a motion is continuous *)
Module Continuous.
#[export] Hint Extern 2 (continuity_pt _ _) => (eapply m_cx + eapply m_cy); [ eassumption | lra ] : core.
End Continuous.
Import Continuous.

(* two motions under one drive never move apart *)
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
(* a weak drive: rest lasts *)
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

(* the same motion with the axes turned: x' along (ex, ey) *)
Lemma motion_turned ex ey k Ax Ay Bx By vx vy : ex ^ 2 + ey ^ 2 = 1 -> (forall t, Bx t = ex * Ax t + ey * Ay t) ->
  (forall t, By t = ex * Ay t - ey * Ax t) -> motion k Ax Ay vx vy -> motion k Bx By (fun t => ex * vx t + ey * vy t) (fun t => ex * vy t - ey * vx
  t).
Proof.
  intros He HB HC [c d M]. split. { intros t Ht. specialize (c t Ht). specialize (d t Ht). cont. } { intros t Ht. specialize (c t Ht).
  specialize (d t Ht). cont. }
  intros t Ht. destruct (M t Ht) as (fx & fy & [B P] & X & Y). exists (ex * fx + ey * fy), (ex * fy - ey * fx). split; [ split | split ].
  - replace ((ex * fx + ey * fy) ^ 2 + (ex * fy - ey * fx) ^ 2) with ((ex ^ 2 + ey ^ 2) * (fx ^ 2 + fy ^ 2)) by ring. rewrite He. lra.
  - replace (nrm (ex * vx t + ey * vy t) (ex * vy t - ey * vx t)) with (nrm (vx t) (vy t)).
    transitivity ((ex ^ 2 + ey ^ 2) * (fx * vx t + fy * vy t)); [ ring | rewrite He, P; ring ].
    unfold nrm. f_equal. transitivity ((ex ^ 2 + ey ^ 2) * (vx t ^ 2 + vy t ^ 2)); [ rewrite He | ]; ring.
  - eapply rder_eq. rd. rewrite HB. ring.
  - eapply rder_eq. rd. rewrite HC. ring.
Qed.
Lemma nrm_turned ex ey x y : ex ^ 2 + ey ^ 2 = 1 -> nrm (ex * x + ey * y) (ex * y - ey * x) = nrm x y.
Proof. intros He. unfold nrm. f_equal. transitivity ((ex ^ 2 + ey ^ 2) * (x ^ 2 + y ^ 2)); [ | rewrite He ]; ring. Qed.

Section Rates.
Variables (k : R) (Ax Ay vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis M : motion k Ax Ay vx vy.
Notation v t := (nrm (vx t) (vy t)).
(* while it slips *)
Lemma slip_rates t : 0 <= t -> v t <> 0 -> rder vx t (- Ax t - k * (vx t / v t)) /\ rder vy t (- Ay t - k * (vy t / v t)).
Proof.
  intros Ht N. destruct (m_law _ _ _ _ _ M t Ht) as (fx & fy & C & X & Y). destruct (coulomb_slip _ _ _ _ _ hk C) as [e1 e2].
  split; (eapply rder_eq; [ eassumption | apply (Rmult_eq_reg_l (v t)); trivial ]).
  - replace (v t * (fx - Ax t)) with (v t * fx - v t * Ax t) by ring. rewrite e1. field. exact N.
  - replace (v t * (fy - Ay t)) with (v t * fy - v t * Ay t) by ring. rewrite e2. field. exact N.
Qed.
Lemma speed_rate t : 0 <= t -> v t <> 0 -> rder (fun s => v s) t (- (Ax t * (vx t / v t) + Ay t * (vy t / v t)) - k).
Proof.
  intros Ht N. destruct (slip_rates t Ht N) as [X Y]. eapply rder_eq. rd. exact N. pose proof (nrm_sq (vx t) (vy t)) as e.
  set (n := v t) in *. field_simplify_eq; [ | exact N ]. replace (vy t ^ 2) with (n ^ 2 - vx t ^ 2) by lra. ring.
Qed.
(* at rest the rates are what friction leaves of the drive *)
Lemma rest_rates t : 0 <= t -> v t = 0 -> exists lx ly, rder vx t lx /\ rder vy t ly /\ rder (fun s => v s) t (nrm lx ly) /\ nrm (lx + Ax t) (ly + Ay
  t) <= k.
Proof.
  intros Ht e. destruct (nrm_zero _ _ e) as [e1 e2]. destruct (m_law _ _ _ _ _ M t Ht) as (fx & fy & [B _] & X & Y).
  exists (fx - Ax t), (fy - Ay t). repeat split; trivial. now apply rder_nrm0. apply nrm_le; trivial. eapply Rle_trans; [ right | exact B ]. ring.
Qed.
End Rates.

(* a drive below a < k: the speed falls at k - a, at least *)
Section Weak.
Variables (k a : R) (Ax Ay vx vy : R -> R).
Hypothesis ha : 0 <= a < k.
Hypothesis M : motion k Ax Ay vx vy.
Hypothesis HA : forall t, 0 <= t -> nrm (Ax t) (Ay t) <= a.
Notation v t := (nrm (vx t) (vy t)).
Lemma weak_rest s t : 0 <= s <= t -> v s = 0 -> v t = 0.
Proof.
  intros Hs e. destruct (nrm_zero _ _ e) as [e1 e2]. destruct (rest_lasts k Ax Ay vx vy s ltac:(lra) M) with (t := t) as [-> ->]; trivial; try lra.
  intros u Hu. specialize (HA u ltac:(lra)). lra. apply nrm_0.
Qed.
Lemma weak_falls s t : 0 <= s <= t -> v t <> 0 -> v t + (k - a) * t <= v s + (k - a) * s.
Proof.
  intros Hs N. apply (rder_decr (fun t => v t + (k - a) * t)); [ lra | | ]; intros u Hu.
  - cont.
  - assert (Nu : v u <> 0) by (intros e; apply N, (weak_rest u t); [ lra | exact e ]).
    pose proof (speed_rate k Ax Ay vx vy ltac:(lra) M u ltac:(lra) Nu) as S. eexists. split. rds.
    pose proof (nrm_pos (vx u) (vy u)). pose proof (dot_abs (Ax u) (Ay u) (vx u) (vy u)) as D. apply Rabs_le_between in D.
    specialize (HA u ltac:(lra)).
    set (n := v u) in *. replace (Ax u * (vx u / n) + Ay u * (vy u / n)) with ((Ax u * vx u + Ay u * vy u) / n) by (field; trivial).
    assert (- a <= (Ax u * vx u + Ay u * vy u) / n) by (apply Rle_div_r; [ lra | nra ]). lra.
Qed.
Theorem weak_stops t : v 0 / (k - a) <= t -> vx t = 0 /\ vy t = 0.
Proof.
  intros Ht. apply Rle_div_l in Ht; [ | lra ]. pose proof (nrm_pos (vx 0) (vy 0)). assert (t0 : 0 <= t) by nra. apply nrm_zero.
  destruct (Req_dec (v t) 0) as [z | z]; trivial. pose proof (weak_falls 0 t ltac:(lra) z). pose proof (nrm_pos (vx t) (vy t)). lra.
Qed.
End Weak.
