(* A periodic motion on the line that rests in each period, with friction to spare at one moment of the rest, is reached by every motion of the plane. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Aniso AttractPlane.
Open Scope R_scope.

Lemma nrm_zero x y : nrm x y = 0 -> x = 0 /\ y = 0.
Proof. intros e. apply sq_sum. rewrite <- nrm_sq, e. lra. Qed.
(* while it moves under a pull of k - c at most, the speed falls at the rate c at least *)
Lemma speed_falls_2 k Ax Ay vx vy c p q : motion k Ax Ay vx vy -> 0 <= p <= q ->
  (forall t, p <= t <= q -> nrm (vx t) (vy t) <> 0 /\ nrm (Ax t) (Ay t) <= k - c) -> nrm (vx q) (vy q) + c * (q - p) <= nrm (vx p) (vy p).
Proof.
  intros M H S. enough (nrm (vx q) (vy q) + c * q <= nrm (vx p) (vy p) + c * p) by lra.
  apply (rder_decr (fun t => nrm (vx t) (vy t) + c * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.
  - destruct (m_law _ _ _ _ _ M t) as (fx & fy & [B P] & X & Y); [ lra | ]. destruct (S t) as [N A]; [ lra | ].
    eexists. split. rd. trivial. set (n := nrm (vx t) (vy t)) in *. assert (0 < n) by (pose proof (nrm_pos (vx t) (vy t)); unfold n in *; lra).
    assert (Q : Ax t ^ 2 + Ay t ^ 2 <= (k - c) ^ 2) by (rewrite <- nrm_sq; apply pow_incr; pose proof (nrm_pos (Ax t) (Ay t)); lra).
    assert (kc : 0 <= k - c) by (pose proof (nrm_pos (Ax t) (Ay t)); lra). pose proof (power_bound _ _ _ (vx t) (vy t) kc Q) as R. fold n in R.
    assert ((vx t * (fx - Ax t) + vy t * (fy - Ay t)) / n <= - c); [ apply Rle_div_l; lra | lra ].
Qed.

Section Reached.
Variables (k T r s : R) (a W : R -> R).
Hypothesis hk : 0 < k.
Hypothesis hT : 0 < T.
Hypothesis ha : forall t, a (t + T) = a t.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis hW : forall t, W (t + T) = W t.
Hypothesis hrs : r < s.
Hypothesis rest : forall t, r <= t <= s -> W t = 0.
Hypothesis spare : Rabs (a r) < k.
Hypothesis ca : continuity_pt a r.
Theorem plane_reached vx vy : motion k a (fun _ => 0) vx vy -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> vx t = W t /\ vy t = 0.
Proof.
  intros HV. set (c := (k - Rabs (a r)) / 2). destruct (ca c) as (d & d0 & Hd); [ unfold c; lra | ].
  set (b := Rmin d (Rmin (s - r) T) / 2). pose proof (Rmin_l d (Rmin (s - r) T)). pose proof (Rmin_r d (Rmin (s - r) T)). pose proof (Rmin_l (s - r) T). pose proof (Rmin_r (s - r) T).
  assert (b0 : 0 < Rmin d (Rmin (s - r) T)) by (repeat apply Rmin_pos; lra).
  assert (bb : 0 < b < d /\ b < s - r /\ b < T) by (unfold b; lra). assert (cc : 0 < c /\ Rabs (a r) = k - 2 * c) by (unfold c; lra). clearbody b c.
  assert (near : forall t, r <= t <= r + b -> Rabs (a t) <= k - c).
  { intros t Ht. destruct (Req_dec r t) as [<- | ne]. lra. specialize (Hd t). simpl in Hd. unfold R_dist in Hd.
    assert (Rabs (a t - a r) < c) as K. { apply Hd. split. split; [ exact I | trivial ]. apply Rabs_def1; lra. }
    pose proof (Rabs_triang_inv (a t) (a r)). lra. }
  set (D t := nrm (vx t - W t) (vy t)).
  assert (C : forall s t, 0 <= s <= t -> D t <= D s). { intros s0 t Ht. unfold D, nrm. apply sqrt_le_1_alt. apply (gap_falls k a W vx vy hk HW HV s0 t Ht). }
  destruct (drain D 0 (2 * T) (c * b) 0) as (t1 & t1a & Ht1); try lra; trivial.
  - apply Rmult_lt_0_compat; lra.
  - intros; apply nrm_pos.
  - intros t Ht. destruct (per_spec r T hT (t + T)) as [n Hn]. set (x := r + IZR n * T). assert (x1 : t <= x <= t + T) by (unfold x; lra). assert (x2 : x + b <= t + 2 * T) by lra.
    assert (on : forall y, x <= y <= x + b -> W y = 0 /\ Rabs (a y) <= k - c).
    { intros y Hy. rewrite <- (shift_Z T W hW n y), <- (shift_Z T a ha n y). split; [ apply rest | apply near ]; unfold x in *; lra. } clearbody x.
    assert (De : forall y, x <= y <= x + b -> D y = nrm (vx y) (vy y)) by (intros y Hy; unfold D; destruct (on y Hy) as [-> _]; f_equal; ring).
    destruct (Req_dec (D (x + b)) 0) as [z | z].
    + left. rewrite <- z. apply C. lra.
    + right. apply Rle_trans with (D (x + b)); [ apply C; lra | ]. apply Rle_trans with (D x - c * b); [ | pose proof (C t x ltac:(lra)); lra ].
      rewrite !De by lra. enough (nrm (vx (x + b)) (vy (x + b)) + c * (x + b - x) <= nrm (vx x) (vy x)) by lra. apply (speed_falls_2 k a (fun _ => 0)); trivial; [ lra | ].
      intros y Hy. split.
      * intros e. apply z. rewrite <- De in e by trivial. pose proof (C y (x + b) ltac:(lra)) as Q. pose proof (nrm_pos (vx (x + b) - W (x + b)) (vy (x + b))) as P. fold (D (x + b)) in P. lra.
      * destruct (on y Hy) as [_ q]. rewrite nrm_line. exact q.
  - exists t1. split; trivial. intros t Ht. destruct (nrm_zero (vx t - W t) (vy t)); [ | lra ]. specialize (Ht1 t Ht). pose proof (nrm_pos (vx t - W t) (vy t)). unfold D in Ht1. lra.
Qed.
End Reached.
