(* 2.2: across the drive, at a stop: the velocity is zero after a finite time, exactly *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Reached Dini.
Open Scope R_scope.

Section Stop.
Variables (k d : R) (a vx vy : R -> R).
Hypothesis hd : 0 <= d < k.
Hypothesis M : motion k a (fun _ => 0) vx vy.
(* a weak drive, for a while: rest lasts as long *)
Lemma rest_while Ay s u : motion k a Ay vx vy -> 0 <= s <= u -> (forall t, s <= t < u -> nrm (a t) (Ay t) <= k) -> vx s = 0 -> vy s = 0 -> vx u = 0 /\ vy u = 0.
Proof.
  intros [c cy L] H HA e1 e2. apply sq_sum. replace 0 with (vx s ^ 2 + vy s ^ 2) by (rewrite e1, e2; ring).
  apply (rder_decr (fun t => vx t ^ 2 + vy t ^ 2)); [ lra | | ]; intros t Ht.
  - cont; [ apply c | apply cy ]; lra.
  - destruct (L t) as (fx & fy & [B P] & X & Y); [ lra | ]. eexists. split. rd. simpl.
    assert (Q : a t ^ 2 + Ay t ^ 2 <= k ^ 2). { rewrite <- nrm_sq. apply pow_incr. split; [ apply nrm_pos | apply HA; trivial ]. }
    assert (k0 : 0 <= k) by lra. pose proof (power_bound _ _ _ (vx t) (vy t) k0 Q). lra.
Qed.
(* s22-vy-two-stages: while |a| <= d < k, from a moment with vx = 0 on, it is at rest after k |vy| / (k^2 - d^2) *)
Theorem across_at_a_stop s u : 0 <= s -> vx s = 0 -> s + k * Rabs (vy s) / (k ^ 2 - d ^ 2) <= u -> (forall t, s <= t <= u -> Rabs (a t) <= d) -> vx u = 0 /\ vy u = 0.
Proof.
  intros hs e0 hu hA. assert (kd : 0 < k ^ 2 - d ^ 2) by nra. set (r := k * Rabs (vy s) / (k ^ 2 - d ^ 2)) in *. assert (er : (k ^ 2 - d ^ 2) * r = k * Rabs (vy s)) by (unfold r; field; lra).
  assert (r0 : 0 <= r). { pose proof (Rabs_pos (vy s)). nra. }
  destruct (Req_dec (nrm (vx u) (vy u)) 0) as [z | z]; [ apply nrm_zero, z | exfalso ].
  assert (N : forall t, s <= t <= u -> 0 < nrm (vx t) (vy t)).
  { intros t Ht. destruct (nrm_pos (vx t) (vy t)) as [p | p]; trivial. exfalso. apply z. symmetry in p. destruct (nrm_zero _ _ p) as [p1 p2].
    destruct (rest_while (fun _ => 0) t u M ltac:(lra)) as [q1 q2]; trivial.
    - intros y Hy. unfold nrm. replace (a y ^ 2 + 0 ^ 2) with (Rsqr (a y)) by (unfold Rsqr; ring). rewrite sqrt_Rsqr_abs. specialize (hA y ltac:(lra)). lra.
    - transitivity (nrm (vx t) (vy t)); trivial. rewrite q1, q2, p1, p2. trivial. }
  assert (F : k * nrm (vx u) (vy u) + d * Rabs (vx u) + (k ^ 2 - d ^ 2) * u <= k * nrm (vx s) (vy s) + d * Rabs (vx s) + (k ^ 2 - d ^ 2) * s).
  { apply (dini_decr (fun t => k * nrm (vx t) (vy t) + d * Rabs (vx t) + (k ^ 2 - d ^ 2) * t)); [ lra | | ]; intros t Ht.
    - apply (continuity_pt_plus (fun t => k * nrm (vx t) (vy t) + d * Rabs (vx t)) (fun t => (k ^ 2 - d ^ 2) * t)); [ | cont ].
      apply (continuity_pt_plus (fun t => k * nrm (vx t) (vy t)) (fun t => d * Rabs (vx t))). cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.
      apply (continuity_pt_mult (fun _ => d) (fun t => Rabs (vx t))). cont. apply (continuity_pt_comp vx Rabs). apply (m_cx _ _ _ _ _ M); lra. apply Rcontinuity_abs.
    - destruct (m_law _ _ _ _ _ M t) as (fx & fy & C & X & Y); [ lra | ]. specialize (N t ltac:(lra)). specialize (hA t ltac:(lra)). apply Rabs_le_between in hA.
      assert (k0 : 0 <= k) by lra. destruct (coulomb_slip _ _ _ _ _ k0 C) as [E _]. destruct C as [_ P]. 
      assert (D : forall g, g = 1 \/ g = -1 -> exists l, rder (fun t => k * nrm (vx t) (vy t) + g * d * vx t + (k ^ 2 - d ^ 2) * t) t l /\ 
        l * nrm (vx t) (vy t) = - (a t + g * d) * (k * vx t + g * d * nrm (vx t) (vy t))).
      { intros g hg. eexists. split. rd. lra. set (n := nrm (vx t) (vy t)) in *. cbv beta. assert (gg : g * g = 1) by (destruct hg as [-> | ->]; ring).
        match goal with |- ?x * n = _ => replace (x * n) with (k * ((fx * vx t + fy * vy t) - a t * vx t) + g * d * (n * fx) - g * d * a t * n + (k ^ 2 - d ^ 2) * n) by (field; lra) end.
        rewrite P, E. replace (- (a t + g * d) * (k * vx t + g * d * n)) with (- (a t * k * vx t + a t * g * d * n + g * d * k * vx t + (g * g) * d ^ 2 * n)) by ring. rewrite gg. ring. }
      intros eps he. set (n := nrm (vx t) (vy t)) in *. set (G := k * n + d * Rabs (vx t) + (k ^ 2 - d ^ 2) * t).
      destruct (D 1 ltac:(auto)) as (l1 & D1 & E1). destruct (D (-1) ltac:(auto)) as (l2 & D2 & E2).
      assert (sg : (0 <= vx t /\ Rabs (vx t) = vx t) \/ (vx t < 0 /\ Rabs (vx t) = - vx t)) by (destruct (Rle_lt_dec 0 (vx t)); [ left; rewrite Rabs_pos_eq | right; rewrite Rabs_left ]; auto).
      destruct (below_step _ _ _ G D1) with (eps := eps) as (d1 & p1 & S1); trivial.
      { fold n. unfold G. destruct sg as [[? ->] | [? ->]]; nra. }
      { fold n. unfold G. intros K. apply Rnot_lt_le. intros q. assert (0 < l1 * n) by nra. rewrite E1 in H. assert (0 <= d * vx t) by (destruct sg as [[s1 _] | [s1 s2]]; [ nra | rewrite s2 in K; nra ]).
        destruct (Req_dec d 0) as [z0 | z0]. assert (a t = 0) by lra. rewrite H1, z0 in H. lra. assert (0 <= vx t) by nra. assert (0 <= (a t + 1 * d) * (k * vx t + 1 * d * n)) by (apply Rmult_le_pos; nra). lra. }
      destruct (below_step _ _ _ G D2) with (eps := eps) as (d2 & p2 & S2); trivial.
      { fold n. unfold G. destruct sg as [[? ->] | [? ->]]; nra. }
      { fold n. unfold G. intros K. apply Rnot_lt_le. intros q. assert (0 < l2 * n) by nra. rewrite E2 in H. assert (d * vx t <= 0) by (destruct sg as [[s1 s2] | [s1 _]]; [ rewrite s2 in K; nra | nra ]).
        destruct (Req_dec d 0) as [z0 | z0]. assert (a t = 0) by lra. rewrite H1, z0 in H. lra. assert (vx t <= 0) by nra. assert (0 <= (d - a t) * (d * n - k * vx t)) by (apply Rmult_le_pos; nra). lra. }
      exists (Rmin d1 d2). split. apply Rmin_pos; trivial. intros h hh. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). specialize (S1 h ltac:(lra)). specialize (S2 h ltac:(lra)). fold n. fold G.
      unfold Rabs at 1. destruct (Rcase_abs (vx (t + h))); lra. }
  rewrite e0, Rabs_R0 in F. replace (nrm 0 (vy s)) with (Rabs (vy s)) in F by (unfold nrm; rewrite <- sqrt_Rsqr_abs; f_equal; unfold Rsqr; ring).
  pose proof (N u ltac:(lra)). pose proof (Rabs_pos (vx u)). assert (0 < k * nrm (vx u) (vy u)) by nra. assert (0 <= d * Rabs (vx u)) by nra. nra.
Qed.
End Stop.
