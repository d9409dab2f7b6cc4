(* Two surfaces in the space of (p, xi, ell) that sliding motions cross in one direction only, after a move by K p^3.
   On w = 0 with w below the polynomial equation of the boundary between rest and escape, up to p^3, w changes at a rate of the
   order p^3 at most; on ws = 0, the equation of the starts with rest at s, at a rate of the order p^2. *)
Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Fate Alpha Stops Bounded.
Import ListNotations.
Open Scope R_scope.

(* ---- the boundary ---- *)
Definition q2 X L := / 2 - 5 / 24 * (1 + X) ^ 2 + 2 / 3 * L * (2 + X).
Definition q3 X L := 17 / 36 + 49 / 48 * (1 + X) + L * (- (2 / 15) - 73 / 90 * ((1 + X) + (1 + X) ^ 2)).
Definition wb P X L := X ^ 2 + L ^ 2 - P ^ 2 - 1 + P * (1 + X) + P ^ 2 * q2 X L + P ^ 3 * q3 X L.
Definition n2 X L := - (5 / 12) * (1 + X) + 2 / 3 * L.
Definition n3 X L := 4 / 3 + 49 / 48 - 73 / 90 * L * (1 + 2 * (1 + X)).
Definition q3X X L := 49 / 48 - 73 / 90 * L * (1 + 2 * (1 + X)).
Definition q3L (X L : R) := - (2 / 15) - 73 / 90 * ((1 + X) + (1 + X) ^ 2).
(* what is left of the rate of w *)
Definition rest_b P X L := (- q3 X L + n2 X L + (2 * L * q3X X L - 2 * X * q3L X L) + n2 X L * (1 - q2 X L) - n3 X L * (1 + X))
  + P * (q3X X L - n2 X L * q3 X L + n3 X L * (1 - q2 X L)) - P ^ 2 * (n3 X L * q3 X L).

Lemma wb_rate P X L t : P t <> 0 -> rder P t (X t - 1) -> rder X t ((P t + L t) ^ 2 / P t) -> rder L t (- X t * (2 * P t + L t) / P t) ->
  rder (fun t => wb (P t) (X t) (L t)) t
    ((1 + P t * n2 (X t) (L t) + P t ^ 2 * n3 (X t) (L t)) * wb (P t) (X t) (L t) + P t ^ 3 * rest_b (P t) (X t) (L t)).
Proof.
  intros N HP HX HL. unfold wb at 1, q2 at 1, q3 at 1. eapply rder_eq. rd. simpl INR. simpl pred.
  unfold rest_b, wb, n2, n3, q3X, q3L, q2, q3. field. exact N.
Qed.
Lemma wb_bounds : exists B, 0 < B /\ forall P X L, Rabs P <= 2 -> Rabs X <= 2 -> Rabs L <= 2 ->
  Rabs (q2 X L) <= B /\ Rabs (q3 X L) <= B /\ Rabs (n2 X L) <= B /\ Rabs (n3 X L) <= B /\ Rabs (rest_b P X L) <= B.
Proof.
  assert (b1 : bnd (fun v => q2 (v 1%nat) (v 2%nat))) by (unfold q2; bounded).
  assert (b2 : bnd (fun v => q3 (v 1%nat) (v 2%nat))) by (unfold q3; bounded).
  assert (b3 : bnd (fun v => n2 (v 1%nat) (v 2%nat))) by (unfold n2; bounded).
  assert (b4 : bnd (fun v => n3 (v 1%nat) (v 2%nat))) by (unfold n3; bounded).
  assert (b5 : bnd (fun v => rest_b (v O) (v 1%nat) (v 2%nat))) by (unfold rest_b, n2, n3, q3X, q3L, q2, q3; bounded).
  destruct (b1 2 ltac:(lra)) as (B1 & p1 & H1). destruct (b2 2 ltac:(lra)) as (B2 & p2 & H2). destruct (b3 2 ltac:(lra)) as (B3 & p3 & H3).
  destruct (b4 2 ltac:(lra)) as (B4 & p4 & H4). destruct (b5 2 ltac:(lra)) as (B5 & p5 & H5).
  exists (B1 + B2 + B3 + B4 + B5). split. lra. intros P X L HP HX HL.
  assert (V : forall i, Rabs (vals [P; X; L] i) <= 2). { apply vals_le. lra. intros r [<- | [<- | [<- | []]]]; trivial. }
  specialize (H1 _ V). specialize (H2 _ V). specialize (H3 _ V). specialize (H4 _ V). specialize (H5 _ V). simpl in *. repeat split; lra.
Qed.

(* moved by K p^3, upwards (s = 1) or downwards (s = -1) *)
Definition wall K s P X L := s * wb P X L - K * P ^ 3.
(* it is the sum of rho^2 - p^2 - 1 and what vanishes with p; on rho^2 - p^2 = 1 the lower wall has been passed;
   whoever is beyond a wall gets away from it *)
Lemma wall_rate : exists K p0, 0 < K /\ 0 < p0 <= 1 /\
  (forall P X L, 0 <= P <= p0 -> X ^ 2 + L ^ 2 - P ^ 2 <= 1 -> Rabs (wb P X L - (X ^ 2 + L ^ 2 - P ^ 2 - 1)) <= K * P) /\
  (forall P X L, 0 < P <= p0 -> X ^ 2 + L ^ 2 - P ^ 2 = 1 -> wall K (- (1)) P X L <= 0) /\
  forall s P X L t, s = 1 \/ s = - (1) -> 0 < P t <= p0 -> X t ^ 2 + L t ^ 2 - P t ^ 2 <= 1 ->
  rder P t (X t - 1) -> rder X t ((P t + L t) ^ 2 / P t) -> rder L t (- X t * (2 * P t + L t) / P t) -> 
  exists m, rder (fun t => wall K s (P t) (X t) (L t)) t m /\ (0 < wall K s (P t) (X t) (L t) -> wall K s (P t) (X t) (L t) / 2 <= m).
Proof.
  destruct wb_bounds as (B & B0 & HB). set (p0 := Rmin (/ 6) (/ (4 * B))).
  assert (a1 : p0 <= / 6) by apply Rmin_l. assert (a2 : p0 <= / (4 * B)) by apply Rmin_r.
  assert (a0 : 0 < p0) by (apply Rmin_pos; [ lra | apply Rinv_0_lt_compat; lra ]).
  assert (a3 : p0 * B <= / 4). { apply (Rmult_le_compat_r B) in a2; [ | lra ]. replace (/ (4 * B) * B) with (/ 4) in a2 by (field; lra). exact a2. }
  assert (box : forall P X L, 0 <= P <= p0 -> X ^ 2 + L ^ 2 - P ^ 2 <= 1 -> Rabs P <= 2 /\ Rabs X <= 2 /\ Rabs L <= 2).
  { intros P X L HP HE. pose proof (pow2_ge_0 X). pose proof (pow2_ge_0 L). repeat split; apply Rabs_le; split; nra. }
  set (K := 4 * B + 20). exists K, p0. split. unfold K; lra. split. lra. split; [ | split ].
  - intros P X L HP HE. destruct (box P X L HP HE) as (b1 & b2 & b3). destruct (HB P X L b1 b2 b3) as (H1 & H2 & _).
    apply Rabs_le_between in b2, H1, H2. unfold wb. replace (X ^ 2 + L ^ 2 - P ^ 2 - 1 + P * (1 + X) + P ^ 2 * q2 X L + P ^ 3 * q3 X L - (X ^ 2 + L ^
    2 - P ^ 2 - 1))
      with (P * (1 + X + P * q2 X L + P ^ 2 * q3 X L)) by ring.
    rewrite Rabs_mult, Rabs_pos_eq, Rmult_comm by lra. apply Rmult_le_compat_r; [ lra | ]. set (a := q2 X L) in *. set (b := q3 X L) in *.
    assert (- B <= P * a <= B) by (split; nra). assert (- B <= P ^ 2 * b <= B) by (assert (0 <= P ^ 2 <= 1) by nra; split; nra). apply Rabs_le.
    unfold K. lra.
  - intros P X L HP HE. destruct (box P X L ltac:(lra) ltac:(lra)) as (b1 & b2 & b3). destruct (HB P X L b1 b2 b3) as (_ & H2 & _).
    apply Rabs_le_between in H2. unfold wall, wb. set (b := q3 X L) in *. rewrite HE. unfold q2.
    set (z := 1 + X). assert (l2 : L ^ 2 = P ^ 2 + 2 * z - z ^ 2) by (unfold z; lra). assert (z0 : - (P ^ 2 / 2) <= z <= 2 + P ^ 2 / 2).
    { pose proof (pow2_ge_0 L). unfold z. split; nra. } replace (2 + X) with (1 + z) by (unfold z; ring). clearbody z.
    enough (0 <= P * (z + P / 2 - 5 / 24 * P * z ^ 2 + 2 / 3 * P * L * (1 + z) + P ^ 2 * (b + K))) by lra. apply Rmult_le_pos. lra.
    assert (k1 : - (L ^ 2 / 8 + 18 * P ^ 2) <= 2 / 3 * P * L * (1 + z)).
    { pose proof (pow2_ge_0 (L / 4 + 4 / 3 * (P * (1 + z)))).
      assert (p2 : 0 <= P ^ 2 <= / 36) by (split; nra).
      assert (z1 : 0 <= 1 + z <= 31 / 10) by lra.
      assert (z2 : (1 + z) ^ 2 <= 10) by nra.
      assert (z3 : P ^ 2 * (1 + z) ^ 2 <= P ^ 2 * 10) by (apply Rmult_le_compat_l; lra).
      replace ((L / 4 + 4 / 3 * (P * (1 + z))) ^ 2) with (L ^ 2 / 16 + 2 / 3 * P * L * (1 + z) + 16 / 9 * (P ^ 2 * (1 + z) ^ 2)) in H by field.
      pose proof (pow2_ge_0 L). lra. }
    assert (k2 : 5 / 24 * P * z ^ 2 <= z ^ 2 / 8) by (pose proof (pow2_ge_0 z); nra). 
    assert (k3 : P ^ 2 * 20 <= P ^ 2 * (b + K)) by (apply Rmult_le_compat_l; [ apply pow2_ge_0 | unfold K; lra ]).
    pose proof (pow2_ge_0 P). lra.
  - intros s P X L t Hs [P0 P1] HE HP HX HL.
    destruct (box (P t) (X t) (L t) ltac:(lra) HE) as (b1 & b2 & b3). destruct (HB _ _ _ b1 b2 b3) as (_ & _ & H3 & H4 & H5).
    apply Rabs_le_between in H3, H4, H5. unfold wall. pose proof (pow2_ge_0 (L t)).
    eexists. split. apply (rder_minus (fun t => s * wb (P t) (X t) (L t)) (fun t => K * P t ^ 3)).
    { apply (rder_mult (fun _ => s) (fun t => wb (P t) (X t) (L t))); [ rd | apply wb_rate; trivial; lra ]. } rd.
    cbv beta. simpl INR. simpl pred. intros V0. set (w := wb (P t) (X t) (L t)) in *. set (z := rest_b (P t) (X t) (L t)) in *.
    set (n := n2 (X t) (L t)) in *. set (n' := n3 (X t) (L t)) in *. set (q := P t) in *.
    assert (x1 : X t - 1 <= q ^ 2 / 2) by nra.
    assert (m1 : / 2 <= 1 + q * n + q ^ 2 * n').
    { assert (qB : q * B <= / 4) by nra. assert (- (q * B) <= q * n) by nra. assert (q ^ 2 <= q) by nra.
    assert (0 <= q ^ 2 * (n' + B)) by (apply Rmult_le_pos; [ apply pow2_ge_0 | lra ]).
      assert (q ^ 2 * B <= q * B) by (apply Rmult_le_compat_r; lra). lra. }
    set (m := 1 + q * n + q ^ 2 * n') in *. clearbody m w z. clear H3 H4 HB n n' b1 b2 b3 box.
    assert (q3 : 0 < q ^ 3) by (apply pow_lt; lra).
    assert (sz : - B <= s * z) by (destruct Hs; subst s; lra).
    set (V := s * w - K * q ^ 3) in *.
    match goal with |- _ <= ?g => replace g with (m * V + q ^ 3 * (K * m + s * z) - 3 * K * q ^ 2 * (X t - 1)) end.
    2: { unfold V. simpl. ring. }
    assert (V / 2 <= m * V) by nra. assert (q ^ 3 * (K / 4) <= q ^ 3 * (K * m + s * z)) by (apply Rmult_le_compat_l; unfold K in *; nra).
    assert (h : 3 * K * q ^ 2 * (X t - 1) <= 3 * K * q ^ 2 * (q ^ 2 / 2)) by (apply Rmult_le_compat_l; unfold K; nra).
    replace (3 * K * q ^ 2 * (q ^ 2 / 2)) with (q ^ 3 * (K / 4) * (6 * q)) in h by field. 
    assert (q ^ 3 * (K / 4) * (6 * q) <= q ^ 3 * (K / 4) * 1) by (apply Rmult_le_compat_l; unfold K; nra). lra.
Qed.

(* ---- the starts with rest at s ---- *)
Definition qs s X := / 2 + (1 + X) ^ 2 * (/ (2 * (1 - s ^ 2))).
Definition ws s P X L := X ^ 2 + L ^ 2 - P ^ 2 - s ^ 2 + P ^ 2 * qs s X.
Lemma ws_rate s P X L t : s ^ 2 <> 1 -> P t <> 0 -> rder P t (X t - 1) -> rder X t ((P t + L t) ^ 2 / P t) ->
  rder L t (- X t * (2 * P t + L t) / P t) ->
  rder (fun t => ws s (P t) (X t) (L t)) t
    ((1 + X t) / (1 - s ^ 2) * (P t * ws s (P t) (X t) (L t) + P t ^ 2 * (2 * L t + P t * (2 - qs s (X t))))).
Proof.
  intros Hs N HP HX HL. unfold ws at 1, qs at 1. eapply rder_eq. rd. simpl INR. simpl pred. unfold ws, qs. field. split; trivial. intros k. apply Hs.
  lra.
Qed.
Lemma walls_rate s : 0 < s < 1 -> exists K p0, 0 < K /\ 0 < p0 <= 1 /\ forall g P X L t, g = 1 \/ g = - (1) -> 0 < P t <= p0 ->
  X t ^ 2 + L t ^ 2 - P t ^ 2 <= s ^ 2 ->
  rder P t (X t - 1) -> rder X t ((P t + L t) ^ 2 / P t) -> rder L t (- X t * (2 * P t + L t) / P t) -> 
  exists m, rder (fun t => g * ws s (P t) (X t) (L t) - K * P t ^ 3) t m /\ (0 < g * ws s (P t) (X t) (L t) - K * P t ^ 3 -> 0 <= m).
Proof.
  intros Hs. set (d := / (1 - s ^ 2)). assert (d0 : 0 < d) by (apply Rinv_0_lt_compat; nra).
  assert (b : bnd (fun v => (1 + v 1%nat) * v 3%nat * (2 * v 2%nat + v O * (2 - (/ 2 + (1 + v 1%nat) ^ 2 * (v 3%nat * / 2)))))) by bounded.
  destruct (b (2 + d) ltac:(lra)) as (B & B0 & HB). set (K := B / (1 - s)). assert (K0 : 0 < K) by (apply Rdiv_lt_0_compat; lra).
  assert (KB : K * (1 - s) = B) by (unfold K; field; lra). exists K, ((1 - s) / 2). split; trivial. split. lra.
  intros g P X L t Hg [P0 P1] HE HP HX HL. pose proof (pow2_ge_0 (X t)). pose proof (pow2_ge_0 (L t)).
  assert (l2 : X t ^ 2 + L t ^ 2 <= 2) by nra. assert (x1 : - (s + P t) <= X t <= s + P t) by (split; nra).
  assert (V : forall i, Rabs (vals [P t; X t; L t; d] i) <= 2 + d).
  { apply vals_le. lra. intros r [<- | [<- | [<- | [<- | []]]]]; apply Rabs_le; split; nra. }
  specialize (HB _ V). cbn [vals] in HB. apply Rabs_le_between in HB.
  eexists. split. apply (rder_minus (fun t => g * ws s (P t) (X t) (L t)) (fun t => K * P t ^ 3)).
  { apply (rder_mult (fun _ => g) (fun t => ws s (P t) (X t) (L t))); [ rd | apply ws_rate; trivial; nra ]. } rd.
  cbv beta. simpl INR. simpl pred. intros V0. set (w' := ws s (P t) (X t) (L t)) in *. set (q := P t) in *.
  assert (eq : qs s (X t) = / 2 + (1 + X t) ^ 2 * (d * / 2)) by (unfold qs, d; field; nra). rewrite eq.
  set (z := (1 + X t) * d * (2 * L t + q * (2 - (/ 2 + (1 + X t) ^ 2 * (d * / 2))))) in *.
  match goal with |- _ <= ?h => replace h with ((1 + X t) * d * q * (g * w' - K * q ^ 3) + q ^ 2 * ((1 + X t) * d * q ^ 2 * K + g * z + 3 * K * (1 -
  X t))) end.
  2: { unfold z. unfold d. simpl. field. nra. }
  assert (m0 : 0 <= (1 + X t) * d) by (apply Rmult_le_pos; lra). assert (gz : - B <= g * z) by (destruct Hg; subst g; lra).
  assert (k1 : B <= 3 * K * (1 - X t)) by nra. assert (0 <= (1 + X t) * d * q ^ 2 * K) by (apply Rmult_le_pos; [ apply Rmult_le_pos;
  [ exact m0 | apply pow2_ge_0 ] | lra ]).
  apply Rplus_le_le_0_compat; apply Rmult_le_pos; try (apply pow2_ge_0); try lra. apply Rmult_le_pos; lra.
Qed.
