(* 2.3: where the pull is below friction in the mean over a time T, rests are certain *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn Median General Dini.
Open Scope R_scope.


(* the last zero before b *)
Lemma last_zero (f : R -> R) a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) -> f a = 0 ->
  exists s, a <= s <= b /\ f s = 0 /\ forall t, s < t <= b -> f t <> 0.
Proof.
  intros H C e. destruct (completeness (fun t => a <= t <= b /\ f t = 0)) as [s [S1 S2]].
  { exists b. intros t [Ht _]. lra. } { exists a. split; lra. }
  assert (a <= s) by (apply S1; split; lra). assert (s <= b) by (apply S2; intros t [Ht _]; lra).
  exists s. split; [ lra | ]. split. 2: { intros t Ht z. assert (t <= s) by (apply S1; split; [ lra | trivial ]). lra. }
  destruct (Req_dec s a) as [-> | ne]; trivial. destruct (Req_dec (f s) 0) as [ | z]; trivial. exfalso.
  assert (0 < Rabs (f s)) by now apply Rabs_pos_lt. destruct (C s ltac:(lra) (Rabs (f s)) H2) as (d & d0 & D).
  assert (U : s <= s - d). { apply S2. intros t [Ht zt]. apply Rnot_lt_le. intros k. pose proof (S1 t (conj Ht zt)). destruct (Req_dec s t) as [<- | nt]; [ contradiction | ].
    assert (K : Rabs (f t - f s) < Rabs (f s)). { apply D. split. split; [ exact I | trivial ]. simpl. unfold R_dist. apply Rabs_def1; lra. }
    rewrite zt, Rminus_0_l, Rabs_Ropp in K. lra. }
  lra.
Qed.

Section Mean.
Variables (k : R) (Ax Ay vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis M : motion k Ax Ay vx vy.
Notation pull t := (nrm (Ax t) (Ay t)).
Notation v t := (nrm (vx t) (vy t)).

(* the speed grows at the pull less friction at most, at rests too *)
Lemma grow K p q : k <= K -> 0 <= p <= q -> (forall t, p <= t < q -> pull t <= K) -> v q <= v p + (K - k) * (q - p).
Proof.
  intros hK H S. apply le_epsilon. intros e he.
  assert (D : forall t, e ^ 2 <= vx t ^ 2 + vy t ^ 2 + e ^ 2) by (intros t; pose proof (pow2_ge_0 (vx t)); pose proof (pow2_ge_0 (vy t)); lra). assert (e2 : 0 < e ^ 2) by nra.
  set (s t := sqrt (vx t ^ 2 + vy t ^ 2 + e ^ 2)). assert (s2 : forall t, s t ^ 2 = v t ^ 2 + e ^ 2). { intros t. unfold s. rewrite pow2_sqrt, nrm_sq. ring. specialize (D t). lra. }
  assert (s0 : forall t, 0 < s t) by (intros t; unfold s; apply sqrt_lt_R0; specialize (D t); lra).
  assert (lo : forall t, v t <= s t). { intros t. pose proof (s2 t). pose proof (s0 t). pose proof (nrm_pos (vx t) (vy t)). nra. }
  assert (up : s p <= v p + e). { pose proof (s2 p). pose proof (s0 p). pose proof (nrm_pos (vx p) (vy p)). nra. }
  enough (s q - (K - k) * q <= s p - (K - k) * p) by (specialize (lo q); lra).
  apply (rder_decr (fun t => s t - (K - k) * t)); [ lra | | ]; intros t Ht.
  - apply (continuity_pt_minus s (fun t => (K - k) * t)); [ | cont ]. apply (continuity_pt_comp (fun t => vx t ^ 2 + vy t ^ 2 + e ^ 2) sqrt).
    cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra. apply continuity_pt_sqrt. specialize (D t). lra.
  - destruct (m_law _ _ _ _ _ M t) as (fx & fy & [C P] & X & Y); [ lra | ].
    assert (Q : Ax t ^ 2 + Ay t ^ 2 <= K ^ 2). { rewrite <- nrm_sq. apply pow_incr. split; [ apply nrm_pos | apply S; lra ]. }
    assert (K0 : 0 <= K) by lra. pose proof (power_bound _ _ _ (vx t) (vy t) K0 Q) as R.
    eexists. split. apply (rder_minus s (fun t => (K - k) * t)); [ | rd ]. apply (rder_comp (fun t => vx t ^ 2 + vy t ^ 2 + e ^ 2) sqrt). rd.
    apply is_derive_Reals, derivable_pt_lim_sqrt. specialize (D t). lra.
    fold (s t). specialize (s0 t). specialize (lo t). set (n := v t) in *. 
    match goal with |- ?g <= 0 => replace g with (((fx * vx t + fy * vy t) - (Ax t * vx t + Ay t * vy t)) / s t - (K - k)) by (simpl; field; lra) end.
    assert (((fx * vx t + fy * vy t) - (Ax t * vx t + Ay t * vy t)) / s t <= K - k); [ | lra ]. apply Rle_div_l; trivial. rewrite P.
    assert ((K - k) * n <= (K - k) * s t) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* J adds up the pull; over each T it grows by m < k T *)
Variables (T m : R) (J : R -> R).
Hypothesis hT : 0 < T.
Hypothesis cJ : forall t, 0 < t -> continuity_pt J t.
Hypothesis rJ : forall t, 0 <= t -> rder J t (pull t).
Hypothesis pJ : forall t, 0 <= t -> J (t + T) = J t + m.
Hypothesis hm : m < k * T.
Hypothesis cA : forall t, 0 <= t -> rcont (fun t => pull t) t.

Lemma change p q : 0 <= p <= q -> (forall t, p <= t < q -> v t <> 0 \/ k <= pull t) -> v q - J q + k * q <= v p - J p + k * p.
Proof.
  intros H S. apply (dini_decr (fun t => v t - J t + k * t)); [ lra | | ].
  - intros t Ht. cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) | apply cJ ]; lra.
  - intros t Ht e he. destruct (Req_dec (v t) 0) as [z | z].
    + destruct (S t ltac:(lra)) as [q0 | q0]; [ contradiction | ]. destruct (cA t ltac:(lra) (e / 2) ltac:(lra)) as (d1 & p1 & D1).
      destruct (rder_step (fun t => - J t) t _ (rder_opp _ _ _ (rJ t ltac:(lra))) (e / 2) ltac:(lra)) as (d2 & p2 & D2).
      exists (Rmin d1 d2). split. now apply Rmin_pos. intros h hh. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). specialize (D2 h ltac:(lra)).
      pose proof (grow (pull t + e / 2) t (t + h) ltac:(lra) ltac:(lra)) as G. enough (v (t + h) <= v t + (pull t + e / 2 - k) * (t + h - t)) by lra.
      apply G. intros y Hy. specialize (D1 y ltac:(lra)). apply Rabs_def2 in D1. cbv beta in D1. lra.
    + destruct (m_law _ _ _ _ _ M t) as (fx & fy & [C P] & X & Y); [ lra | ]. pose proof (rJ t ltac:(lra)) as RJ.
      assert (R : rder (fun t => v t - J t + k * t) t ((vx t * (fx - Ax t) + vy t * (fy - Ay t)) / v t - pull t + k)) by (eapply rder_eq; [ rd; exact z | ring ]).
      apply (below_step _ _ _ (v t - J t + k * t) R); trivial; [ lra | intros _ ].
      pose proof (nrm_pos (Ax t) (Ay t)) as A0. pose proof (nrm_sq (Ax t) (Ay t)) as A2. pose proof (power_bound _ _ _ (vx t) (vy t) A0 (Req_le _ _ (eq_sym A2))) as Q.
      pose proof (nrm_pos (vx t) (vy t)). set (n := v t) in *. assert ((vx t * (fx - Ax t) + vy t * (fy - Ay t)) / n <= pull t - k); [ apply Rle_div_l; lra | lra ].
Qed.
Lemma J_n n : J (INR n * T) = J 0 + INR n * m.
Proof.
  induction n as [ | n IH ]. simpl. rewrite !Rmult_0_l. ring. assert (0 <= INR n * T) by (apply Rmult_le_pos; [ apply pos_INR | lra ]).
  rewrite S_INR. replace ((INR n + 1) * T) with (INR n * T + T) by ring. rewrite pJ, IH by trivial. ring.
Qed.
(* at a moment of rest with friction to spare a rest begins *)
Lemma begins s : 0 <= s -> v s = 0 -> pull s < k -> exists d, 0 < d /\ forall t, s <= t <= s + d -> vx t = 0 /\ vy t = 0.
Proof.
  intros h0 z h1. destruct (cA s h0 (k - pull s) ltac:(lra)) as (d & d0 & D). exists d. split; trivial. intros t Ht. destruct (nrm_zero _ _ z) as [z1 z2].
  apply sq_sum. replace 0 with (vx s ^ 2 + vy s ^ 2) by (rewrite z1, z2; ring).
  apply (rder_decr (fun t => vx t ^ 2 + vy t ^ 2)); [ lra | | ]; intros y Hy.
  - cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.
  - destruct (m_law _ _ _ _ _ M y) as (fx & fy & [B P] & X & Y); [ lra | ]. eexists. split. rd. simpl. specialize (D y ltac:(lra)). apply Rabs_def2 in D. cbv beta in D.
    assert (Q : Ax y ^ 2 + Ay y ^ 2 <= k ^ 2). { rewrite <- nrm_sq. apply pow_incr. split; [ apply nrm_pos | lra ]. }
    pose proof (power_bound _ _ _ (vx y) (vy y) hk Q). lra.
Qed.

(* s23-threshold-exists, above: from some time on each span of length T holds a rest *)
Theorem rest_is_certain t : v 0 / (k - m / T) + T <= t -> exists s d, t <= s <= t + T /\ 0 < d /\ forall u, s <= u <= s + d -> vx u = 0 /\ vy u = 0.
Proof.
  intros Ht. assert (g0 : 0 < k * T - m) by lra. assert (e0 : v 0 / (k - m / T) = T * (v 0 / (k * T - m))) by (field; split; lra). rewrite e0 in Ht. clear e0.
  set (x := v 0 / (k * T - m)) in *. assert (ex : x * (k * T - m) = v 0) by (unfold x; field; lra). pose proof (nrm_pos (vx 0) (vy 0)) as v0. assert (x0 : 0 <= x) by nra.
  destruct (nfloor_ex x x0) as [n Hn]. assert (N : (INR n + 1) * T <= t) by nra. pose proof (pos_INR n) as n0.
  (* a first zero *)
  assert (Z0 : exists s, 0 <= s <= t /\ v s = 0).
  { apply Classical_Prop.NNPP. intros no. pose proof (change 0 ((INR n + 1) * T) ltac:(nra)) as C. rewrite <- S_INR, J_n, S_INR in C.
    pose proof (nrm_pos (vx ((INR n + 1) * T)) (vy ((INR n + 1) * T))). enough (v 0 < (INR n + 1) * (k * T - m)).
    { assert (v ((INR n + 1) * T) - (J 0 + (INR n + 1) * m) + k * ((INR n + 1) * T) <= v 0 - J 0 + k * 0); [ apply C | lra ]. intros y Hy. left. intros e. apply no. exists y. lra. }
    rewrite <- ex. apply Rmult_lt_compat_r; lra. }
  destruct Z0 as (s0 & Hs0 & z0).
  (* the last zero before t, and one with friction to spare after it *)
  destruct (last_zero (fun t => v t) s0 t) as (s & Hs & z & L); [ lra | intros y Hy; cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra | trivial | ].
  assert (E : exists y, s <= y < s + T /\ v y = 0 /\ pull y < k).
  { apply Classical_Prop.NNPP. intros no. pose proof (change s (s + T) ltac:(lra)) as C. rewrite pJ in C by lra. cbv beta in z. rewrite z in C.
    pose proof (nrm_pos (vx (s + T)) (vy (s + T))). assert (v (s + T) - (J s + m) + k * (s + T) <= 0 - J s + k * s); [ apply C | lra ].
    intros y Hy. destruct (Req_dec (v y) 0) as [e | e]; [ right | left; trivial ]. apply Rnot_lt_le. intros q. apply no. exists y. auto. }
  destruct E as (y & Hy & zy & Ky). destruct (begins y ltac:(lra) zy Ky) as (d & d0 & D).
  assert (t <= y). { apply Rnot_lt_le. intros k1. set (w := Rmin t (y + d)). assert (y < w <= t /\ w <= y + d) by (unfold w; split; [ split; [ apply Rmin_glb_lt; lra | apply Rmin_l ] | apply Rmin_r ]).
    apply (L w ltac:(lra)). destruct (D w ltac:(lra)) as [-> ->]. unfold nrm. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. apply sqrt_0. }
  exists y, d. split; [ lra | auto ].
Qed.
End Mean.
