(* 2.3: how the speed changes, at rests too; where the pull is below friction in the mean over a time T, rests are certain. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Contraction Median.
Open Scope R_scope.

(* the last zero before b *)
Lemma last_zero (f : R -> R) a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) -> f a = 0 ->
  exists s, a <= s <= b /\ f s = 0 /\ forall t, s < t <= b -> f t <> 0.
Proof.
  intros H C e. destruct (completeness (fun t => a <= t <= b /\ f t = 0)) as [s [S1 S2]]. { exists b. intros t [Ht _]. lra. } { exists a.
  split; lra. }
  assert (a <= s) by (apply S1; split; lra). assert (s <= b) by (apply S2; intros t [Ht _]; lra).
  exists s. split; [ lra | split ]. 2: { intros t Ht z. assert (t <= s) by (apply S1; split; [ lra | trivial ]). lra. }
  destruct (Req_dec s a) as [-> | ne]; trivial. destruct (Req_dec (f s) 0) as [ | z]; trivial. exfalso.
  destruct (cont_eps f s (Rabs (f s)) (C s ltac:(lra)) (Rabs_pos_lt _ z)) as (d & d0 & D).
  enough (s <= s - d) by lra. apply S2. intros t [Ht zt]. apply Rnot_lt_le. intros k. pose proof (S1 t (conj Ht zt)).
  specialize (D t ltac:(apply Rabs_def1; lra)). rewrite zt, Rminus_0_l, Rabs_Ropp in D. lra.
Qed.

Section Mean.
Variables (k : R) (Ax Ay vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis M : motion k Ax Ay vx vy.
Notation pull t := (nrm (Ax t) (Ay t)).
Notation v t := (nrm (vx t) (vy t)).
Hypothesis cA : forall t, 0 <= t -> rcont (fun t => pull t) t.

Lemma slip_rate t : 0 <= t -> v t <> 0 -> exists r, rder (fun t => v t) t r /\ r <= pull t - k.
Proof.
  intros Ht N. eexists. split; [ now apply (speed_rate k Ax Ay) | ]. pose proof (dot_le (- Ax t) (- Ay t) (vx t) (vy t)) as D.
  replace (nrm (- Ax t) (- Ay t)) with (pull t) in D by (unfold nrm; f_equal; ring). pose proof (nrm_pos (vx t) (vy t)). set (n := v t) in *.
  replace (Ax t * (vx t / n) + Ay t * (vy t / n)) with (- ((- Ax t * vx t + - Ay t * vy t) / n)) by (field; trivial).
  assert ((- Ax t * vx t + - Ay t * vy t) / n <= pull t) by (apply Rle_div_l; lra). lra.
Qed.
(* the speed grows at the pull less friction at most, or is 0 where friction holds *)
Lemma right_rate t : 0 <= t -> exists r, rder (fun t => v t) t r /\ forall j, pull t <= j -> v t <> 0 \/ k <= j -> r <= j - k.
Proof.
  intros Ht. destruct (Req_dec (v t) 0) as [z | z]; [ | destruct (slip_rate t Ht z) as (r & R & b); exists r; split; trivial; intros; lra ].
  destruct (rest_rates k Ax Ay vx vy hk M t Ht z) as (lx & ly & _ & _ & R & _). exists (nrm lx ly). split; trivial.
  intros j hj [ | kj]; [ contradiction | ].
  set (r := nrm lx ly) in *. apply Rnot_lt_le. intros far. set (e := (r - (j - k)) / 4).
  destruct (rder_elim _ _ _ R e ltac:(unfold e; lra)) as (a & a0 & A).
  destruct (cA t Ht e ltac:(unfold e; lra)) as (b & b0 & B). assert (ab : 0 < Rmin a b) by now apply Rmin_pos. pose proof (Rmin_l a b).
  pose proof (Rmin_r a b).
  assert (P : forall h, 0 < h < Rmin a b -> (r - e) * h <= v (t + h) <= (r + e) * h).
  { intros h hh. specialize (A h ltac:(lra)). cbv beta in A. rewrite z in A. apply Rabs_le_between in A. lra. }
  set (x := Rmin a b / 2). set (q := x * (e / (4 * (r + e)))). assert (re : 0 < r + e /\ 0 < r - e) by (unfold e; lra).
  assert (q0 : 0 < q) by (unfold q; apply Rmult_lt_0_compat; [ unfold x; lra | apply Rdiv_lt_0_compat; unfold e; lra ]).
  assert (qe : (r + e) * q = e * x / 4) by (unfold q; field; lra). assert (qx : q < x) by (apply (Rmult_lt_reg_l (r + e)); [ lra | rewrite qe;
    unfold x, e in *; nra ]).
  destruct (P q ltac:(unfold x in *; lra)) as [_ Pq]. destruct (P x ltac:(unfold x in *; lra)) as [Px _].
  assert (F : v (t + x) - (j + e - k) * (t + x) <= v (t + q) - (j + e - k) * (t + q)).
  { apply (rder_decr (fun t => v t - (j + e - k) * t)); [ lra | | ]; intros s Hs.
    - cont.
    - destruct (P (s - t) ltac:(unfold x in *; lra)) as [Ps _]. replace (t + (s - t)) with s in Ps by ring.
      destruct (slip_rate s) as (r' & R' & b'); [ lra | intros n; rewrite n in Ps; nra | ].
      eexists. split; [ apply (rder_minus (fun t => v t)); [ exact R' | rd ] | ]. specialize (B s ltac:(unfold x in *; lra)).
      apply Rabs_def2 in B. lra. }
  unfold e in *. nra.
Qed.
Lemma change (J j : R -> R) p q : 0 <= p <= q -> (forall t, p < t <= q -> continuity_pt J t) ->
  (forall t, p <= t < q -> rder J t (j t) /\ pull t <= j t /\ (v t <> 0 \/ k <= j t)) -> v q - J q + k * q <= v p - J p + k * p.
Proof.
  intros H C S. apply (rder_decr (fun t => v t - J t + k * t)); [ lra | | ]; intros t Ht.
  - specialize (C t ltac:(lra)). cont.
  - destruct (S t Ht) as (RJ & a & b). destruct (right_rate t) as (r & R & Q); [ lra | ]. specialize (Q _ a b).
    eexists. split; [ apply (rder_plus (fun t => v t - J t) (fun t => k * t)); [ apply (rder_minus (fun t => v t) J); [ exact R | exact RJ ]
      | rd ] | lra ].
Qed.
Lemma grows K p q : k <= K -> 0 <= p <= q -> (forall t, p <= t < q -> pull t <= K) -> v q <= v p + (K - k) * (q - p).
Proof.
  intros hK H S. enough (v q - K * q + k * q <= v p - K * p + k * p) by lra. apply (change (fun t => K * t) (fun _ => K)); trivial; [ intros;
    cont | ].
  intros t Ht. split; [ eapply rder_eq; [ rd | ring ] | auto ].
Qed.
Lemma falls c p q : 0 <= p <= q -> (forall t, p <= t < q -> pull t <= k - c /\ v t <> 0) -> v q + c * (q - p) <= v p.
Proof.
  intros H S. enough (v q - (k - c) * q + k * q <= v p - (k - c) * p + k * p) by lra. apply (change (fun t => (k - c) * t) (fun _ => k - c));
    trivial; [ intros; cont | ].
  intros t Ht. destruct (S t Ht). split; [ eapply rder_eq; [ rd | ring ] | auto ].
Qed.
Lemma rest_held_on s t : 0 <= s <= t -> v s = 0 -> (forall u, s <= u < t -> pull u <= k) -> v t = 0.
Proof. intros H z S. pose proof (grows k s t ltac:(lra) H S). pose proof (nrm_pos (vx t) (vy t)). lra. Qed.
(* at a moment of rest with friction to spare a rest begins *)
Lemma begins s : 0 <= s -> v s = 0 -> pull s < k -> exists d, 0 < d /\ forall t, s <= t <= s + d -> v t = 0.
Proof.
  intros h0 z h1. destruct (cA s h0 (k - pull s) ltac:(lra)) as (d & d0 & D). exists d. split; trivial. intros t Ht.
  apply (rest_held_on s); trivial; [ lra | ].
  intros u Hu. specialize (D u ltac:(lra)). apply Rabs_def2 in D. lra.
Qed.

(* J adds up the pull; over each T it grows by m < k T: from some time on each span of length T holds a rest *)
Theorem rest_is_certain T m J t : 0 < T -> (forall t, 0 < t -> continuity_pt J t) -> (forall t, 0 <= t -> rder J t (pull t)) ->
  (forall t, 0 <= t -> J (t + T) = J t + m) ->
  m < k * T -> v 0 / (k - m / T) + T <= t -> exists s d, t <= s <= t + T /\ 0 < d /\ forall u, s <= u <= s + d -> v u = 0.
Proof.
  intros hT cJ rJ pJ hm Ht. assert (C : forall p q, 0 <= p <= q -> (forall t, p <= t < q -> v t <> 0 \/ k <= pull t) ->
    v q - J q + k * q <= v p - J p + k * p).
  { intros p q H S. apply (change J (fun t => pull t)); trivial; [ intros; apply cJ; lra | ]. intros u Hu. specialize (S u Hu).
    split; [ apply rJ; lra | lra ]. }
  assert (e0 : v 0 / (k - m / T) = T * (v 0 / (k * T - m))) by (field; split; lra). rewrite e0 in Ht. clear e0.
  set (x := v 0 / (k * T - m)) in *. assert (ex : x * (k * T - m) = v 0) by (unfold x; field; lra). pose proof (nrm_pos (vx 0) (vy 0)) as v0.
  assert (x0 : 0 <= x) by nra.
  destruct (nfloor_ex x x0) as [n Hn]. assert (N : (INR n + 1) * T <= t) by nra. pose proof (pos_INR n) as n0.
  (* a first zero *)
  assert (Z0 : exists s, 0 <= s <= t /\ v s = 0).
  { apply Classical_Prop.NNPP. intros no. assert (J_n : forall n, J (INR n * T) = J 0 + INR n * m).
    { induction n1 as [ | i IH ]; [ simpl; rewrite !Rmult_0_l; ring | ]. rewrite S_INR. replace ((INR i + 1) * T) with (INR i * T + T) by ring.
      pose proof (pos_INR i). rewrite pJ, IH by nra. ring. }
    pose proof (C 0 ((INR n + 1) * T) ltac:(nra)) as Q. rewrite <- S_INR, J_n, S_INR in Q.
    pose proof (nrm_pos (vx ((INR n + 1) * T)) (vy ((INR n + 1) * T))).
    enough (v 0 < (INR n + 1) * (k * T - m)) by (enough (v ((INR n + 1) * T) - (J 0 + (INR n + 1) * m) + k * ((INR n + 1) * T) <= v 0 - J 0 + k *
      0) by lra; apply Q; intros y Hy; left; intros e; apply no; exists y; lra).
    rewrite <- ex. apply Rmult_lt_compat_r; lra. }
  destruct Z0 as (s0 & Hs0 & z0).
  (* the last zero before t, and one with friction to spare after it *)
  destruct (last_zero (fun t => v t) s0 t) as (s & Hs & z & L); trivial; [ lra | intros; cont | ].
  assert (E : exists y, s <= y < s + T /\ v y = 0 /\ pull y < k).
  { apply Classical_Prop.NNPP. intros no. pose proof (C s (s + T) ltac:(lra)) as Q. rewrite pJ in Q by lra. cbv beta in z. rewrite z in Q.
    pose proof (nrm_pos (vx (s + T)) (vy (s + T))). enough (v (s + T) - (J s + m) + k * (s + T) <= 0 - J s + k * s) by lra. apply Q.
    intros y Hy. destruct (Req_dec (v y) 0) as [e | e]; [ right | left; trivial ]. apply Rnot_lt_le. intros q. apply no. exists y. auto. }
  destruct E as (y & Hy & zy & Ky). destruct (begins y ltac:(lra) zy Ky) as (d & d0 & D). exists y, d. split; [ | auto ].
  enough (t <= y) by lra. apply Rnot_lt_le. intros k1. apply (L (Rmin t (y + d))); [ | apply D ]; unfold Rmin; destruct Rle_dec; lra.
Qed.
(* where the pull is c below friction the particle moves for a while, and rests then *)
Lemma comes_to_rest c x y : 0 < x <= y -> (forall t, x <= t < y -> pull t <= k - c) -> 0 <= c ->
  v y + c * (y - x) <= v x \/ exists z, x <= z <= y /\ c * (z - x) <= v x /\ forall t, z <= t <= y -> v t = 0.
Proof.
  intros Hx S hc. destruct (Classical_Prop.classic (exists z, x <= z < y /\ v z = 0)) as [(z0 & Hz0 & e0) | no].
  - right. destruct (last_zero (fun t => v (- t)) (- z0) (- x)) as (z & Hz & e & L); [ lra | | now rewrite Ropp_involutive | ].
    { intros t Ht. apply (continuity_pt_comp (fun t => - t) (fun t => v t)); cont. }
    exists (- z). split; [ lra | split ].
    + enough (v (- z) + c * (- z - x) <= v x) by (rewrite e in *; lra). apply falls; [ lra | ]. intros t Ht. split; [ apply S; lra | ].
      rewrite <- (Ropp_involutive t). apply L. lra.
    + intros t Ht. apply (rest_held_on (- z)); trivial; [ lra | ]. intros u Hu. specialize (S u ltac:(lra)). lra.
  - left. apply falls; [ lra | ]. intros t Ht. split; [ now apply S | ]. intros e. apply no. exists t. auto.
Qed.
End Mean.
