(* Two sequences L and x: when x L stays bounded where L grows, and x falls, by a factor, up to small terms; and that what each time is multiplied by
   a factor, up to bounded terms, goes as the powers of it. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* L times 1 + 1/f is f L', but for a part h, small beside f, of the growth, and C, small beside L: by what L grows *)
Lemma growth f h C L L' : 0 < f -> 0 <= C -> 1 + 2 * C <= L -> 0 <= h <= 1 -> h <= f / 2 -> Rabs ((1 + f) * L - f * L') <= h * (L' - L) + C ->
  (1 + / (2 * (1 + f))) * L <= L' /\ L' <= (1 + f) / f * L * (1 + 2 * (h / f)) + 2 * (C / f).
Proof.
  intros f0 C0 l1 h1 h2 R. apply Rabs_le_between in R. split.
  - set (i := / (2 * (1 + f))). assert (hi : 0 < i /\ 2 * (f + 1) * i = 1) by (unfold i; split; [ apply Rinv_0_lt_compat; lra | field; lra ]).
    apply Rmult_le_reg_l with (f + h); [ lra | ]. assert ((f + h) * i * L <= (f + 1) * i * L) by (repeat apply Rmult_le_compat_r; lra). nra.
  - set (g := h / f). assert (hg : f * g = h) by (unfold g; field; lra). assert (g1 : 0 <= g <= / 2) by nra.
    apply Rmult_le_reg_l with (f * (1 - g)); [ nra | ].
    replace (f * (1 - g) * ((1 + f) / f * L * (1 + 2 * g) + 2 * (C / f))) with ((1 + f) * L * ((1 - g) * (1 + 2 * g)) + 2 * (1 - g) * C) by (field;
      lra).
    assert ((1 + f) * L * 1 <= (1 + f) * L * ((1 - g) * (1 + 2 * g))) by (apply Rmult_le_compat_l; nra). nra.
Qed.
Lemma stays_bounded (L x : nat -> R) F q c : 1 < F -> 1 < q -> 0 <= c ->
  (forall n, 1 <= L n /\ q * L n <= L (S n) /\ 0 <= x n <= 1 /\ c * F * x n <= (F - 1) / 2) ->
  (forall n, L (S n) <= F * L n * (1 + c * x n) + c) ->
  (forall n, x (S n) <= x n / F + c * x n ^ 2 + c / L n ^ 2) ->
  exists B, forall n, x n * L n <= B.
Proof.
  intros hF hq hc H HL HX. set (f := / F). assert (fF : f * F = 1) by (unfold f; field; lra). assert (f0 : 0 < f <= 1).
  { unfold f. split; [ apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra ]. }
  set (r := f * ((F + 1) / 2)). assert (hr : 0 < 1 - r) by (unfold r; nra). set (i n := / L n).
  assert (hi : forall n, 0 < i n <= 1 /\ i n * L n = 1 /\ i (S n) <= / q * i n).
  { intros n. destruct (H n) as (l1 & g & _). unfold i. split; [ split | split ]; [ apply Rinv_0_lt_compat; lra | | field; lra | ].
    - rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
    - rewrite <- Rinv_mult. apply Rinv_le_contravar; trivial. nra. }
  assert (hx : forall n, x (S n) <= f * x n + c * x n ^ 2 + c * i n ^ 2).
  { intros n. destruct (H n) as (l1 & _). specialize (HX n). unfold i, f. rewrite pow_inv. unfold Rdiv in HX. lra. }
  assert (shrinks : forall n, x (S n) <= r * x n + c * i n).
  { intros n. specialize (hx n). destruct (H n) as (_ & _ & x0 & x1), (hi n) as (i0 & _).
    assert (c * i n ^ 2 <= c * i n) by (apply Rmult_le_compat_l; nra).
    assert (f * x n * (c * F * x n) <= f * x n * ((F - 1) / 2)) by (apply Rmult_le_compat_l; [ apply Rmult_le_pos | ]; lra).
    replace (f * x n * (c * F * x n)) with (f * F * (c * x n ^ 2)) in * by ring. rewrite fF in *. unfold r. lra. }
  set (c2 := (1 + F) * (1 + c) ^ 2 * c). assert (h2 : 0 <= c2) by (apply Rmult_le_pos; nra).
  assert (step : forall n, x (S n) * L (S n) <= x n * L n * (1 + c2 * x n) + c2 * (x n + i n)).
  { intros n. destruct (H n) as (l1 & _ & x0 & _), (H (S n)) as (l2 & _ & x1 & _), (hi n) as (i0 & e & _). specialize (HL n). specialize (hx n).
    set (a := x n) in *. set (j := i n) in *. apply Rle_trans with ((f * a + c * a ^ 2 + c * j ^ 2) * (F * L n * (1 + c * a) + c)).
    { apply Rmult_le_compat; lra. }
    replace ((f * a + c * a ^ 2 + c * j ^ 2) * (F * L n * (1 + c * a) + c)) with
      (a * L n * (f * F + c * F * a) * (1 + c * a) + c * a * (f + c * a) + c * F * j * (j * L n) * (1 + c * a) + c ^ 2 * j ^ 2) by ring.
    rewrite fF, e. assert (t : 0 <= c * a <= c) by nra. assert (0 <= c * F * a) by nra. assert (0 <= c * F) by nra. assert (0 <= c ^ 2 * F) by nra.
    assert (A : (1 + c * F * a) * (1 + c * a) <= 1 + c2 * a).
    { replace (c2 * a) with ((1 + F) * (1 + c) ^ 2 * (c * a)) by (unfold c2; ring). assert (0 <= c * F * (c * a)) by nra.
      assert (c * F * a * (c * a) <= c * F * (c * a)) by nra. nra. }
    assert (a * L n * ((1 + c * F * a) * (1 + c * a)) <= a * L n * (1 + c2 * a)) by (apply Rmult_le_compat_l; nra).
    assert (c * a * (f + c * a) <= c * a * (1 + c)) by (apply Rmult_le_compat_l; lra).
    assert (c * F * j * (1 + c * a) <= c * F * j * (1 + c)) by (apply Rmult_le_compat_l; nra). assert (c ^ 2 * j ^ 2 <= c ^ 2 * j) by nra.
    assert (c * (1 + c) <= c2 /\ c * F * (1 + c) + c ^ 2 <= c2).
    { unfold c2. replace ((1 + F) * (1 + c) ^ 2 * c) with (c * (1 + c) * ((1 + F) * (1 + c))) by ring. split; nra. }
    nra. }
  (* (1 + x L) exp (A x + D / L) falls *)
  set (A := c2 / (1 - r)). assert (hA : 0 <= A /\ A * (1 - r) = c2) by (unfold A; split; [ apply Rdiv_le_0_compat; lra | field; lra ]).
  set (D := (c2 + A * c) / (1 - / q)). assert (iq : 0 < 1 - / q).
  { assert (/ q < / 1) by (apply Rinv_lt_contravar; lra). rewrite Rinv_1 in *. lra. }
  assert (hD : 0 <= D /\ D * (1 - / q) = c2 + A * c) by (unfold D; split; [ apply Rdiv_le_0_compat; nra | field; split; lra ]).
  set (V := fun n => (1 + x n * L n) * exp (A * x n + D * i n)). assert (fall : forall n, V (S n) <= V n).
  { intros n. destruct (H n) as (l1 & _ & x0 & _), (hi n) as (i0 & _ & i1). specialize (step n). specialize (shrinks n). unfold V.
    set (a := x n) in *. set (b := x (S n)) in *. set (t := c2 * (a + i n)). assert (0 <= t) by (unfold t; nra). assert (0 <= a * L n) by nra.
    apply Rle_trans with ((1 + a * L n) * exp t * exp (A * b + D * i (S n))).
    { apply Rmult_le_compat_r; [ left; apply exp_pos | ]. apply Rle_trans with ((1 + a * L n) * (1 + t)).
      - assert (0 <= a * L n * (c2 * i n)) by (apply Rmult_le_pos; nra). unfold t. nra.
      - apply Rmult_le_compat_l; [ lra | apply exp_ineq1_le ]. }
    rewrite Rmult_assoc, <- exp_plus. apply Rmult_le_compat_l; [ lra | ].
    assert (D * i (S n) <= D * (/ q * i n)) by (apply Rmult_le_compat_l; lra).
    assert (A * b <= A * (r * a + c * i n)) by (apply Rmult_le_compat_l; lra).
    assert (D * (1 - / q) * i n = (c2 + A * c) * i n) by (now rewrite (proj2 hD)). assert (A * (1 - r) * a = c2 * a) by (now rewrite (proj2 hA)).
    assert (W : t + (A * b + D * i (S n)) <= A * a + D * i n) by (unfold t; lra). destruct W as [W | ->]; [ left; now apply exp_increasing | lra ]. }
  exists (V 0%nat). intros n. apply Rle_trans with (V n). 2: { induction n as [ | n IH ]; [ lra | ]. specialize (fall n). lra. }
  unfold V. destruct (H n) as (l1 & _ & x0 & _), (hi n) as (i0 & _). assert (0 <= A * x n + D * i n) by (assert (0 <= A * x n) by nra; nra).
  pose proof (exp_ineq1_le (A * x n + D * i n)). assert (0 <= x n * L n) by nra. nra.
Qed.
Lemma as_powers (L : nat -> R) F C : 1 < F -> (forall n, Rabs (L (S n) - F * L n) <= C) -> (exists n, C / (F - 1) < L n) ->
  exists a, 0 < a /\ forall n, Rabs (L n - a * F ^ n) <= C / (F - 1).
Proof.
  intros hF H [n0 H0]. set (K := C / (F - 1)) in *. assert (hK : K * (F - 1) = C) by (unfold K; field; lra).
  assert (P : forall n, 0 < F ^ n) by (intros; apply pow_lt; lra).
  assert (G : Un_growing (fun n => (L n - K) / F ^ n)).
  { intros n. specialize (H n). apply Rabs_le_between in H. pose proof (P n). apply Rle_div_l; trivial.
    replace ((L (S n) - K) / F ^ S n * F ^ n) with ((L (S n) - K) / F) by (simpl; field; split; lra). apply Rle_div_r; lra. }
  assert (D : Un_decreasing (fun n => (L n + K) / F ^ n)).
  { intros n. specialize (H n). apply Rabs_le_between in H. pose proof (P n). apply Rle_div_l; [ apply P | ].
    replace ((L n + K) / F ^ n * F ^ S n) with ((L n + K) * F) by (simpl; field; lra). lra. }
  assert (K0 : 0 <= K) by (pose proof (Rabs_pos (L 1%nat - F * L 0%nat)); specialize (H 0%nat); nra).
  assert (B : forall n m, (L n - K) / F ^ n <= (L m + K) / F ^ m).
  { intros n m. apply Rle_trans with ((L (n + m)%nat - K) / F ^ (n + m)); [ apply (tech9 _ G); auto with arith | ].
    apply Rle_trans with ((L (n + m)%nat + K) / F ^ (n + m)); [ apply Rmult_le_compat_r; [ left; apply Rinv_0_lt_compat, P | lra ] | ].
    apply (decreasing_prop _ m (n + m) D). auto with arith. }
  destruct (completeness (fun y => exists n, y = (L n - K) / F ^ n)) as (a & A1 & A2).
  { exists ((L 0%nat + K) / F ^ 0). intros y [n ->]. apply B. } { now exists ((L 0%nat - K) / F ^ 0), 0%nat. }
  exists a. split; [ apply Rlt_le_trans with ((L n0 - K) / F ^ n0); [ apply Rdiv_lt_0_compat; [ lra | trivial ] | apply A1; now exists n0 ] | ].
  intros n. specialize (P n). assert (X : (L n - K) / F ^ n <= a) by (apply A1; now exists n). apply Rle_div_l in X; trivial.
  assert (Y : a <= (L n + K) / F ^ n) by (apply A2; intros y [m ->]; apply B). apply Rle_div_r in Y; trivial. apply Rabs_le. lra.
Qed.
(* the ratio of its growths, one after the other *)
Lemma ratio_of_growths (y : nat -> R) a G C : 1 < G -> 0 < a -> (forall n, Rabs (y n + a * G ^ n) <= C) ->
  is_lim_seq (fun n => (y (S (S n)) - y (S n)) / (y (S n) - y n)) G.
Proof.
  intros hG a0 H. set (v n := (y (S n) - y n) / G ^ n). set (c := - a * (G - 1)). assert (c0 : c <> 0) by (unfold c; nra).
  assert (V : is_lim_seq v c).
  { assert (E : forall k, is_lim_seq (fun n => c + k * (/ G) ^ n) c).
    { intros k. enough (X : is_lim_seq (fun n => c + k * (/ G) ^ n) (c + k * 0)) by (rewrite Rmult_0_r, Rplus_0_r in X; exact X).
      apply is_lim_seq_plus'; [ apply is_lim_seq_const | ]. apply is_lim_seq_mult'; [ apply is_lim_seq_const | ].
      apply is_lim_seq_geom. rewrite Rabs_pos_eq; [ rewrite <- Rinv_1; apply Rinv_lt_contravar | left; apply Rinv_0_lt_compat ]; lra. }
    refine (is_lim_seq_le_le _ _ _ _ _ (E (- (2 * C))) (E (2 * C))). intros n. pose proof (H n) as A. pose proof (H (S n)) as B.
    apply Rabs_le_between in A, B. simpl in B. assert (P : 0 < G ^ n) by (apply pow_lt; lra). rewrite pow_inv.
    fold (Rdiv (- (2 * C)) (G ^ n)) (Rdiv (2 * C) (G ^ n)).
    assert (cv : c * G ^ n = - (a * (G * G ^ n)) + a * G ^ n) by (unfold c; ring). set (g := G ^ n) in *. unfold v. fold g.
    replace c with (c * g / g) by (field; lra). unfold Rdiv. rewrite <- !Rmult_plus_distr_r. assert (0 < / g) by now apply Rinv_0_lt_compat.
    split; apply Rmult_le_compat_r; lra. }
  apply (is_lim_seq_ext (fun n => G * (v (S n) / v n))).
  - intros n. unfold v, Rdiv. simpl. rewrite !Rinv_mult, Rinv_inv. set (i := / (y (S n) - y n)). field. split; [ apply pow_nonzero | ]; lra.
  - enough (X : is_lim_seq (fun n => G * (v (S n) / v n)) (G * (c / c))) by (replace (G * (c / c)) with G in X by (field; trivial); exact X).
    apply is_lim_seq_mult'; [ apply is_lim_seq_const | ].
    apply is_lim_seq_div'; trivial. now apply (proj1 (is_lim_seq_incr_1 v c)).
Qed.
