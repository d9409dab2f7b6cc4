(* Every escape as prey and predator. With d = pi/2 - psi: z = tan(d/2), h = tanh alpha, N = cosh alpha/(2 A z) and
   P = 1/(z^2 (exp(4 alpha) - 1)). Wherever h goes to 1, N settles at 3/4 and P at 1/2 (V falls), (N - 3/4)/z at 3 sqrt 2/32 and
   (P - 1/2)/z at 3 sqrt 2/8 (Q falls), and 1/z is t - (3 sqrt 2/4) ln t + o(ln t). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable2 Fate Late.
Open Scope R_scope.

Definition z_rate z P := - (2 * z ^ 2 * (1 - (1 - z ^ 2) * P)).
Definition prey_rate z h N P := 2 * z * N * (1 + h * / (1 + z ^ 2) - 2 * h * N - (1 - z ^ 2) * P).
Definition predator_rate z N P := 4 * z * P * (1 - (1 - z ^ 2) * P - 2 * (1 + z ^ 2 * P) * (/ (1 + z ^ 2) - N)).
(* what is known of an escape from the time T on *)
Record hunt (T : R) (z h N P : R -> R) : Prop := {
  h_from : 1 <= T;
  h_pos : forall t, T <= t -> 0 < z t /\ 0 < h t < 1 /\ 0 < N t /\ 0 < P t /\ (1 - h t) ^ 2 = 4 * P t * h t * z t ^ 2;
  h_cont : forall t, T < t -> continuity_pt z t /\ continuity_pt N t /\ continuity_pt P t;
  h_law : forall t, T <= t -> rder z t (z_rate (z t) (P t)) /\ rder N t (prey_rate (z t) (h t) (N t) (P t)) /\
            rder P t (predator_rate (z t) (N t) (P t));
  h_one : is_lim h p_infty 1 }.

(* y - 1 - ln y measures how far y is from 1 *)
Definition off y := y - 1 - ln y.
Lemma off_least y : 0 < y -> (sqrt y - 1) ^ 2 <= off y.
Proof.
  intros H. assert (s0 : 0 < sqrt y) by (apply sqrt_lt_R0, H). assert (s2 : sqrt y * sqrt y = y) by (apply sqrt_sqrt; lra).
  pose proof (ln_below _ s0). unfold off. rewrite <- s2 at 3. rewrite ln_mult by trivial. nra.
Qed.
Lemma off_most y : 0 < y -> off y <= (y - 1) ^ 2 / y.
Proof.
  intros H. pose proof (ln_below (/ y) ltac:(now apply Rinv_0_lt_compat)) as k. rewrite ln_Rinv in k by trivial. unfold off.
  replace ((y - 1) ^ 2 / y) with (y - 2 + / y) by (field; lra). lra.
Qed.
(* V' <= - n^2 - q^2 + small *)
Lemma V_falls z h N P eta : 0 < z -> z ^ 2 <= eta -> 0 < h < 1 -> 1 - h <= eta -> 0 < N -> 0 < P -> z ^ 2 * P <= eta -> eta <= / 18 ->
  4 * (N - 3 / 4) * (1 + h * / (1 + z ^ 2) - 2 * h * N - (1 - z ^ 2) * P) +
  2 * (P - / 2) * (1 - (1 - z ^ 2) * P - 2 * (1 + z ^ 2 * P) * (/ (1 + z ^ 2) - N)) <= - ((N - 3 / 4) ^ 2 + (P - / 2) ^ 2) + 13 * eta.
Proof.
  intros z0 z2 hh h1 N0 P0 m1 e1. set (k := / (1 + z ^ 2)). set (m := z ^ 2 * P) in *. set (a := N - 3 / 4). set (b := P - / 2).
  assert (zz : 0 < z ^ 2) by nra. assert (m0 : 0 < m) by (unfold m; nra).
  assert (k0 : 0 < k) by (apply Rinv_0_lt_compat; lra). assert (kz : 1 - k = z ^ 2 * k) by (unfold k; field; lra). assert (k1 : k < 1) by nra. assert (k2 : 1 - k <= eta) by nra.
  set (d1 := - (1 - h * k) + 2 * (1 - h) * N + m). set (d2 := m * (1 - 2 * k + 2 * N) + 2 * (1 - k)).
  replace (1 + h * k - 2 * h * N - (1 - z ^ 2) * P) with (- 2 * a - b + d1) by (unfold a, b, d1, m; field).
  replace (1 - (1 - z ^ 2) * P - 2 * (1 + m) * (k - N)) with (2 * a - b + d2) by (unfold a, b, d2, m; field).
  set (X := Rabs a). set (Y := Rabs b). assert (X2 : X ^ 2 = a ^ 2) by apply pow2_abs. assert (Y2 : Y ^ 2 = b ^ 2) by apply pow2_abs.
  assert (X0 : 0 <= X) by apply Rabs_pos. assert (Y0 : 0 <= Y) by apply Rabs_pos.
  assert (NX : N <= X + 1) by (pose proof (Rle_abs a); unfold X, a in *; lra).
  assert (B1 : Rabs d1 <= eta * (4 + 2 * X)).
  { assert (0 <= (1 - h) * N <= eta * (X + 1)) by (split; [ nra | apply Rmult_le_compat; lra ]). assert (h * k = h - h * (1 - k)) by ring. assert (h * (1 - k) <= 1 - k) by nra.
    apply Rabs_le. unfold d1. nra. }
  assert (B2 : Rabs d2 <= eta * (5 + 2 * X)).
  { assert (m * (2 * N) <= eta * (2 * (X + 1))) by (apply Rmult_le_compat; lra). assert (0 <= m * N) by nra. assert (m * k <= m) by nra. assert (0 <= m * k) by nra.
    apply Rabs_le. unfold d2. nra. }
  assert (C1 : a * d1 <= X * (eta * (4 + 2 * X))). { eapply Rle_trans; [ apply Rle_abs | rewrite Rabs_mult; apply Rmult_le_compat_l; trivial ]. }
  assert (C2 : b * d2 <= Y * (eta * (5 + 2 * X))). { eapply Rle_trans; [ apply Rle_abs | rewrite Rabs_mult; apply Rmult_le_compat_l; trivial ]. }
  assert (e0 : 0 <= eta) by lra.
  assert (D : 4 * (X * (4 + 2 * X)) + 2 * (Y * (5 + 2 * X)) <= 13 + 18 * X ^ 2 + 7 * Y ^ 2) by (pose proof (pow2_ge_0 (X - 1)); pose proof (pow2_ge_0 (Y - 1)); pose proof (pow2_ge_0 (X - Y)); nra).
  apply (Rmult_le_compat_l eta) in D; trivial. assert (eta * X ^ 2 <= / 18 * X ^ 2) by (apply Rmult_le_compat_r; nra). assert (eta * Y ^ 2 <= / 18 * Y ^ 2) by (apply Rmult_le_compat_r; nra).
  rewrite <- X2, <- Y2 in *. nra.
Qed.
(* Q' <= - (x^2 + y^2)/2 + small *)
Lemma Q_falls x y e1 e2 eta : 0 < eta <= / 14 -> Rabs e1 <= eta * (Rabs x + Rabs y + 1) -> Rabs e2 <= eta * (Rabs x + Rabs y + 1) ->
  16 / 3 * x * (- x - 3 / 4 * y + e1) + 2 * y * (2 * x - / 2 * y + e2) <= - (x ^ 2 + y ^ 2) / 2 + 4 * eta.
Proof.
  intros He B1 B2. set (X := Rabs x) in *. set (Y := Rabs y) in *. assert (X2 : X ^ 2 = x ^ 2) by apply pow2_abs. assert (Y2 : Y ^ 2 = y ^ 2) by apply pow2_abs.
  assert (X0 : 0 <= X) by apply Rabs_pos. assert (Y0 : 0 <= Y) by apply Rabs_pos.
  assert (C1 : x * e1 <= X * (eta * (X + Y + 1))). { eapply Rle_trans; [ apply Rle_abs | rewrite Rabs_mult; apply Rmult_le_compat_l; trivial ]. }
  assert (C2 : y * e2 <= Y * (eta * (X + Y + 1))). { eapply Rle_trans; [ apply Rle_abs | rewrite Rabs_mult; apply Rmult_le_compat_l; trivial ]. }
  assert (D : 6 * (X * (X + Y + 1)) + 2 * (Y * (X + Y + 1)) <= 13 * X ^ 2 + 7 * Y ^ 2 + 4) by (pose proof (pow2_ge_0 (X - 1)); pose proof (pow2_ge_0 (Y - 1)); pose proof (pow2_ge_0 (X - Y)); nra).
  apply (Rmult_le_compat_l eta) in D; [ | lra ]. assert (eta * X ^ 2 <= / 14 * X ^ 2) by (apply Rmult_le_compat_r; nra). assert (eta * Y ^ 2 <= / 14 * Y ^ 2) by (apply Rmult_le_compat_r; nra).
  assert (0 <= X * (eta * (X + Y + 1))) by (apply Rmult_le_pos; nra). rewrite <- X2, <- Y2 in *. nra.
Qed.

Section Hunt.
Variables (T : R) (z h N P : R -> R).
Hypothesis H : hunt T z h N P.
Let T1 : 1 <= T := h_from _ _ _ _ _ H.
Let h1 : is_lim h p_infty 1 := h_one _ _ _ _ _ H.

(* z^2 P = 1/(exp(4 alpha) - 1) vanishes, and with it z *)
Lemma little : tends (fun t => z t ^ 2 * P t) 0.
Proof.
  apply (tends_ext T (fun t => (1 - h t) ^ 2 * / (4 * h t))).
  - intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (_ & hh & _ & _ & e). rewrite e. field. lra.
  - limit. lra. field.
Qed.
Lemma z_below eta : 0 < eta -> exists T', T <= T' /\ forall t, T' <= t -> z t <= eta.
Proof.
  intros He. assert (e2 : 0 < eta ^ 2) by nra. destruct (in_the_end T _ 0 (eta ^ 2 / 2) little ltac:(lra)) as (T2 & T20 & HT).
  destruct (sinks_ever z eta (eta ^ 2) 1 T2) as (T3 & T30 & H3); try lra.
  - intros t Ht. apply (h_cont _ _ _ _ _ H). lra.
  - intros t Ht. specialize (HT t Ht). apply Rabs_def2 in HT. destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & _ & _ & P0 & _).
    eexists. split. apply (h_law _ _ _ _ _ H). lra. intros k. unfold z_rate.
    assert (eta ^ 2 / (t + 1) <= eta ^ 2) by (apply Rle_div_l; [ lra | nra ]). set (m := z t ^ 2 * P t) in *. assert (0 < z t ^ 2) by nra. assert (eta ^ 2 <= z t ^ 2) by nra.
    replace (2 * z t ^ 2 * (1 - (1 - z t ^ 2) * P t)) with (2 * z t ^ 2 - 2 * m + 2 * (m * z t ^ 2)) by (unfold m; ring).
    assert (0 < m) by (unfold m; nra). assert (0 < m * z t ^ 2) by nra. lra.
  - exists T3. split; trivial. lra.
Qed.
Lemma z_zero : tends z 0.
Proof.
  apply by_square. intros e He. destruct (z_below (sqrt e)) as (T' & T0 & HT). now apply sqrt_lt_R0. exists T'. intros t Ht. specialize (HT t Ht).
  destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & _). replace e with (sqrt e ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra). nra.
Qed.
Lemma dinv t : T <= t -> rder (fun t => / z t) t (2 * (1 - (1 - z t ^ 2) * P t)).
Proof.
  intros Ht. destruct (h_law _ _ _ _ _ H t Ht) as (Z & _). destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). eapply rder_eq. rdq. lra. unfold z_rate. field. lra.
Qed.
Lemma cinv t : T < t -> continuity_pt (fun t => / z t) t.
Proof. intros Ht. destruct (h_cont _ _ _ _ _ H t Ht) as (Z & _). destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & _). contq. lra. Qed.
(* the clock in which they hunt goes as ln t at least *)
Lemma clock : exists T' c, T <= T' /\ 0 <= c /\ forall t, T' <= t -> / (t + c) <= 2 * z t.
Proof.
  destruct (z_below 1 Rlt_0_1) as (T' & T0 & HT). exists T', (Rmax 0 (/ z T' / 2)). split; trivial. split. apply Rmax_l.
  intros t Ht. destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & _). pose proof (Rmax_l 0 (/ z T' / 2)). pose proof (Rmax_r 0 (/ z T' / 2)).
  assert (K : / z t - 2 * t <= / z T' - 2 * T').
  { apply (rder_decr (fun t => / z t - 2 * t)); trivial; intros r Hr.
    - pose proof (cinv r ltac:(lra)). contq.
    - eexists. split. apply (rder_minus (fun t => / z t)); [ apply dinv; lra | rdq ]. destruct (h_pos _ _ _ _ _ H r ltac:(lra)) as (zr & _ & _ & P0 & _).
      specialize (HT r ltac:(lra)). assert (0 <= (1 - z r ^ 2) * P r) by (apply Rmult_le_pos; nra). lra. }
  assert (/ (t + Rmax 0 (/ z T' / 2)) <= / (/ z t / 2)). { apply Rinv_le_contravar; [ | lra ]. assert (0 < / z t) by now apply Rinv_0_lt_compat. lra. }
  replace (/ (/ z t / 2)) with (2 * z t) in H2 by (field; lra). trivial.
Qed.
(* what falls in that clock sinks *)
Lemma hunted f e m T0 : T <= T0 -> 0 < m -> (forall t, T0 < t -> continuity_pt f t) ->
  (forall t, T0 <= t -> exists l, rder f t (2 * z t * l) /\ (e <= f t -> l <= - m)) -> exists T', T0 <= T' /\ forall t, T' <= t -> f t <= e.
Proof.
  intros T00 m0 C D. destruct clock as (T2 & c & T20 & c0 & HT). set (T3 := Rmax T0 T2). pose proof (Rmax_l T0 T2). pose proof (Rmax_r T0 T2). fold T3 in H0, H1.
  destruct (sinks_ever f e m c T3) as (T' & T'0 & K); try lra.
  - intros. apply C. lra.
  - intros t Ht. destruct (D t ltac:(lra)) as (l & L & k). exists (2 * z t * l). split; trivial. intros q. specialize (k q). specialize (HT t ltac:(lra)).
    unfold Rdiv. assert (m * / (t + c) <= m * (2 * z t)) by (apply Rmult_le_compat_l; lra). assert (0 < / (t + c)) by (apply Rinv_0_lt_compat; lra). nra.
  - exists T'. split; trivial. lra.
Qed.

Definition V t := 3 * off (4 / 3 * N t) + off (2 * P t) * / 2.
Lemma V_small e : 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> V t <= e.
Proof.
  intros He. set (mu := Rmin (/ 64) (e / 8)). assert (mu0 : 0 < mu) by (apply Rmin_pos; lra). assert (mu1 : mu <= / 64) by apply Rmin_l. assert (mu2 : mu <= e / 8) by apply Rmin_r.
  set (eta := Rmin (/ 18) (mu / 26)). assert (eta0 : 0 < eta) by (apply Rmin_pos; lra). assert (eta1 : eta <= / 18) by apply Rmin_l. assert (eta2 : eta <= mu / 26) by apply Rmin_r.
  destruct (in_the_end T _ 0 eta little eta0) as (Ta & Ta0 & Ha). destruct (in_the_end Ta _ 1 eta h1 eta0) as (Tb & Tb0 & Hb). destruct (z_below eta eta0) as (Tc & Tc0 & Hc).
  set (T0 := Rmax Tb Tc). pose proof (Rmax_l Tb Tc). pose proof (Rmax_r Tb Tc). fold T0 in H0, H1.
  destruct (hunted V e (mu / 2) T0) as (T' & T'0 & K); try lra.
  - intros t Ht. destruct (h_cont _ _ _ _ _ H t ltac:(lra)) as (_ & CN & CP). destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (_ & _ & N0 & P0 & _). unfold V, off. contq; lra.
  - intros t Ht. destruct (h_law _ _ _ _ _ H t ltac:(lra)) as (_ & DN & DP). destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & hh & N0 & P0 & _).
    exists (4 * (N t - 3 / 4) * (1 + h t * / (1 + z t ^ 2) - 2 * h t * N t - (1 - z t ^ 2) * P t) +
      2 * (P t - / 2) * (1 - (1 - z t ^ 2) * P t - 2 * (1 + z t ^ 2 * P t) * (/ (1 + z t ^ 2) - N t))).
    split. { unfold V, off. eapply rder_eq. rdq; lra. unfold prey_rate, predator_rate. field. repeat split; nra. }
    intros k. specialize (Ha t ltac:(lra)). specialize (Hb t ltac:(lra)). specialize (Hc t ltac:(lra)). apply Rabs_def2 in Ha, Hb.
    eapply Rle_trans. apply (V_falls (z t) (h t) (N t) (P t) eta); trivial; try lra. nra.
    assert (far : mu <= (N t - 3 / 4) ^ 2 + (P t - / 2) ^ 2); [ | lra ]. apply Rnot_lt_le. intros n. set (a := N t - 3 / 4) in *. set (b := P t - / 2) in *.
    assert (a1 : - / 8 < a < / 8) by (pose proof (pow2_ge_0 b); split; nra). assert (b1 : - / 8 < b < / 8) by (pose proof (pow2_ge_0 a); split; nra).
    pose proof (off_most (4 / 3 * N t) ltac:(lra)) as o1. pose proof (off_most (2 * P t) ltac:(lra)) as o2.
    assert (q1 : (4 / 3 * N t - 1) ^ 2 / (4 / 3 * N t) <= 32 / 15 * a ^ 2). { apply Rle_div_l. lra. replace (4 / 3 * N t - 1) with (4 / 3 * a) by (unfold a; field). replace (N t) with (a + 3 / 4) by (unfold a; ring). pose proof (pow2_ge_0 a). nra. }
    assert (q2 : (2 * P t - 1) ^ 2 / (2 * P t) <= 16 / 3 * b ^ 2). { apply Rle_div_l. lra. replace (2 * P t - 1) with (2 * b) by (unfold b; field). replace (P t) with (b + / 2) by (unfold b; ring). pose proof (pow2_ge_0 b). nra. }
    unfold V in k. pose proof (pow2_ge_0 a). pose proof (pow2_ge_0 b). lra.
  - exists T'. split; trivial. lra.
Qed.
Theorem settles : tends N (3 / 4) /\ tends P (1 / 2).
Proof.
  assert (K : tends (fun t => sqrt (4 / 3 * N t)) 1 /\ tends (fun t => sqrt (2 * P t)) 1).
  { split; apply by_square; intros e He; (destruct (V_small (e / 2)) as (T' & T0 & HT); [ lra | exists T'; intros t Ht; specialize (HT t Ht) ]);
      destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (_ & _ & N0 & P0 & _); pose proof (off_least (4 / 3 * N t) ltac:(lra)); pose proof (off_least (2 * P t) ltac:(lra));
      pose proof (pow2_ge_0 (sqrt (4 / 3 * N t) - 1)); pose proof (pow2_ge_0 (sqrt (2 * P t) - 1)); unfold V in HT; lra. }
  destruct K as [K1 K2]. split.
  - apply (tends_ext T (fun t => 3 / 4 * sqrt (4 / 3 * N t) ^ 2)); [ | limit; field ]. intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (_ & _ & N0 & _). rewrite <- Rsqr_pow2, Rsqr_sqrt; lra.
  - apply (tends_ext T (fun t => 1 / 2 * sqrt (2 * P t) ^ 2)); [ | limit; field ]. intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (_ & _ & _ & P0 & _). rewrite <- Rsqr_pow2, Rsqr_sqrt; lra.
Qed.
Let N1 := proj1 settles.
Let P1 := proj2 settles.
Let z1 := z_zero.
Lemma w_limit : tends (fun t => (1 - h t) * / z t) (sqrt 2).
Proof.
  apply (tends_ext T (fun t => sqrt (4 * P t * h t))).
  - intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & hh & _ & P0 & e). assert (0 < / z t) by now apply Rinv_0_lt_compat. rewrite <- (sqrt_pow2 ((1 - h t) * / z t)) by nra.
    f_equal. rewrite Rpow_mult_distr, e. field. lra.
  - eapply tends_eq. lim. lra. f_equal. field.
Qed.
Theorem first_order : tends (fun t => / z t / t) 1.
Proof.
  apply (hospital T _ (fun t => 2 * (1 - (1 - z t ^ 2) * P t)) (fun t => t) (fun _ => 1)).
  - intros t Ht. split. now apply dinv. split; [ rdq | lra ].
  - intros t Ht. split. now apply cinv. contq.
  - limit. field.
  - apply is_lim_id.
Qed.

(* the deviations, in units of z *)
Notation q t := ((N t - 3 / 4) * / z t).
Notation v t := ((P t - / 2) * / z t).
Notation w t := ((1 - h t) * / z t).
Notation k t := (/ (1 + z t ^ 2)).
Definition c10 t := N t * w t * (2 * N t - 1) + N t * z t * (P t - k t * h t).
Definition c11 t := - 2 * N t + 1 - (1 - z t ^ 2) * P t.
Definition c20 t := 2 * P t * z t * (P t + 2 * (1 - P t) * k t + 2 * P t * N t).
Definition c22 t := - 2 * P t + 1 - (1 - z t ^ 2) * P t.
Lemma dq t : T <= t -> rder (fun t => q t) t (2 * z t * (c11 t * q t - N t * v t + c10 t)).
Proof.
  intros Ht. destruct (h_law _ _ _ _ _ H t Ht) as (DZ & DN & _). destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). eapply rder_eq. rdq. lra.
  unfold z_rate, prey_rate, c11, c10. field. split; nra.
Qed.
Lemma dv t : T <= t -> rder (fun t => v t) t (2 * z t * (4 * P t * q t + c22 t * v t + c20 t)).
Proof.
  intros Ht. destruct (h_law _ _ _ _ _ H t Ht) as (DZ & _ & DP). destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). eapply rder_eq. rdq. lra.
  unfold z_rate, predator_rate, c22, c20. field. split; nra.
Qed.
Definition q0 := 3 * sqrt 2 / 32.
Definition v0 := 3 * sqrt 2 / 8.
Definition Q t := 8 / 3 * (q t - q0) ^ 2 + (v t - v0) ^ 2.
Lemma Q_small e : 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> Q t <= e.
Proof.
  intros He. set (eta := Rmin (/ 14) (e / 48)). assert (eta0 : 0 < eta) by (apply Rmin_pos; lra). assert (eta1 : eta <= / 14) by apply Rmin_l. assert (eta2 : eta <= e / 48) by apply Rmin_r.
  pose proof w_limit as W. cbv beta in W.
  assert (L10 : tends c10 (3 / 8 * sqrt 2)). { unfold c10. limit. lra. field. }
  assert (L20 : tends c20 0). { unfold c20. limit. lra. field. }
  assert (L11 : tends c11 (- 1)). { unfold c11. limit. field. }
  assert (L22 : tends c22 (- / 2)). { unfold c22. limit. field. }
  set (d1 t := c11 t * q0 - N t * v0 + c10 t). set (d2 t := 4 * P t * q0 + c22 t * v0 + c20 t).
  assert (D1 : tends d1 0). { unfold d1. limit. unfold q0, v0. field. } assert (D2 : tends d2 0). { unfold d2. limit. unfold q0, v0. field. }
  destruct (in_the_end T _ _ eta L11 eta0) as (Ta & Ta0 & Ha). destruct (in_the_end Ta _ _ eta L22 eta0) as (Tb & Tb0 & Hb). destruct (in_the_end Tb _ _ eta D1 eta0) as (Tc & Tc0 & Hc).
  destruct (in_the_end Tc _ _ eta D2 eta0) as (Td & Td0 & Hd). destruct (in_the_end Td _ _ (eta / 4) N1 ltac:(lra)) as (Te & Te0 & Hee). destruct (in_the_end Te _ _ (eta / 4) P1 ltac:(lra)) as (Tf & Tf0 & Hf).
  destruct (hunted Q e (e / 12) Tf) as (T' & T'0 & K); try lra.
  - intros t Ht. destruct (h_cont _ _ _ _ _ H t ltac:(lra)) as (_ & CN & CP). pose proof (cinv t ltac:(lra)) as CZ. unfold Q. repeat (first [ exact CZ | contq ]).
  - intros t Ht. set (x := q t - q0). set (y := v t - v0). set (e1 := (c11 t + 1) * x + (3 / 4 - N t) * y + d1 t). set (e2 := (4 * P t - 2) * x + (c22 t + / 2) * y + d2 t).
    exists (16 / 3 * x * (- x - 3 / 4 * y + e1) + 2 * y * (2 * x - / 2 * y + e2)). split.
    { unfold Q. eapply rder_eq. apply (rder_plus (fun t => 8 / 3 * (q t - q0) ^ 2) (fun t => (v t - v0) ^ 2)).
      - apply (rder_mult (fun _ => 8 / 3) (fun t => (q t - q0) ^ 2)); [ rdq | ]. apply (rder_pow (fun t => q t - q0)), (rder_minus (fun t => q t)); [ apply dq; lra | rdq ].
      - apply (rder_pow (fun t => v t - v0)), (rder_minus (fun t => v t)); [ apply dv; lra | rdq ].
      - cbv beta. fold x y. simpl INR. simpl pred. replace (q t) with (x + q0) by (unfold x; ring). replace (v t) with (y + v0) by (unfold y; ring). unfold e1, e2, d1, d2. field. }
    intros far. specialize (Ha t ltac:(lra)). specialize (Hb t ltac:(lra)). specialize (Hc t ltac:(lra)). specialize (Hd t ltac:(lra)). specialize (Hee t ltac:(lra)). specialize (Hf t ltac:(lra)).
    assert (bound : forall a b c, Rabs a <= eta -> Rabs b <= eta -> Rabs c <= eta -> Rabs (a * x + b * y + c) <= eta * (Rabs x + Rabs y + 1)).
    { intros a b c A B C. pose proof (Rabs_triang (a * x + b * y) c). pose proof (Rabs_triang (a * x) (b * y)). rewrite !Rabs_mult in *. pose proof (Rabs_pos x). pose proof (Rabs_pos y). nra. }
    eapply Rle_trans. apply (Q_falls x y e1 e2 eta); [ lra | apply bound | apply bound ].
    + replace (c11 t + 1) with (c11 t - - 1) by ring. lra.
    + rewrite Rabs_minus_sym. lra.
    + rewrite Rminus_0_r in Hc. lra.
    + replace (4 * P t - 2) with (4 * (P t - 1 / 2)) by field. rewrite Rabs_mult, (Rabs_pos_eq 4) by lra. lra.
    + replace (c22 t + / 2) with (c22 t - - / 2) by ring. lra.
    + rewrite Rminus_0_r in Hd. lra.
    + unfold Q in far. fold x y in far. pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 y). lra.
  - exists T'. split; trivial. lra.
Qed.
Theorem deviations : tends (fun t => q t) q0 /\ tends (fun t => v t) v0.
Proof.
  split; apply by_square; intros e He; destruct (Q_small e He) as (T' & T0 & HT); exists T'; intros t Ht; specialize (HT t Ht); unfold Q in HT;
    pose proof (pow2_ge_0 (q t - q0)); pose proof (pow2_ge_0 (v t - v0)); lra.
Qed.
(* 1/z lags behind the time *)
Theorem lags : near (fun t => / z t / t) (- (2 * v0)).
Proof.
  destruct deviations as [_ Lv]. cbv beta in Lv. pose proof first_order as L1. cbv beta in L1. pose proof (tends_inv _ _ L1 R1_neq_R0) as L2. cbv beta in L2.
  apply (tends_ext (Rmax T (exp 1)) (fun t => (/ z t - t) / ln t)).
  { intros t Ht. pose proof (Rmax_l T (exp 1)). pose proof (Rmax_r T (exp 1)). destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & _). pose proof (lnt t ltac:(lra)). field. lra. }
  apply (hospital T _ (fun t => 2 * (1 - (1 - z t ^ 2) * P t) - 1) ln (fun t => 1 / t)).
  - intros t Ht. split; [ | split ].
    + apply (rder_minus (fun t => / z t) (fun t => t)); [ now apply dinv | rdq ].
    + apply (rder_ln (fun t => t)); [ rdq | lra ].
    + apply Rdiv_lt_0_compat; lra.
  - intros t Ht. split. { pose proof (cinv t Ht). contq. } apply (cont_ln (fun t => t)); [ contq | lra ].
  - apply (tends_ext T (fun t => / (/ z t / t) * (2 * z t * P t - 2 * v t))).
    + intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). field. lra.
    + limit. unfold v0. field.
  - exact is_lim_ln_p.
Qed.
(* N, P, h and (1 - h)/z differ from their limits by multiples of 1/t *)
Lemma zt_limit : tends (fun t => z t * t) 1.
Proof.
  pose proof first_order as L1. cbv beta in L1. apply (tends_ext T (fun t => / (/ z t / t))); [ | limit; lra ].
  intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). field. lra.
Qed.
Lemma near_multiple f g (l : R) : tends g l -> (forall t, T <= t -> f t = 1 + g t * z t) -> near f 0.
Proof.
  intros G E. apply (near_small f (fun t => g t * (z t * t)) (l * 1)). apply tends_mult; [ exact G | exact zt_limit ].
  exists T. intros t Ht. rewrite E by trivial. field. lra.
Qed.
Theorem near_N : near (fun t => 4 / 3 * N t) 0.
Proof.
  destruct deviations as [Lq _]. apply (near_multiple _ (fun t => 4 / 3 * q t) (4 / 3 * q0)). apply (tends_mult (fun _ => 4 / 3)); [ apply is_lim_const | exact Lq ].
  intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). field. lra.
Qed.
Theorem near_P : near (fun t => 2 * P t) 0.
Proof.
  destruct deviations as [_ Lv]. apply (near_multiple _ (fun t => 2 * v t) (2 * v0)). apply (tends_mult (fun _ => 2)); [ apply is_lim_const | exact Lv ].
  intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). field. lra.
Qed.
Theorem near_h : near h 0.
Proof.
  apply (near_multiple _ (fun t => - w t) (- sqrt 2)). apply tends_opp. exact w_limit.
  intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). field. lra.
Qed.
Theorem near_g : near (fun t => (1 + h t) / 2) 0.
Proof.
  apply (near_multiple _ (fun t => - / 2 * w t) (- / 2 * sqrt 2)). apply (tends_mult (fun _ => - / 2)); [ apply is_lim_const | exact w_limit ].
  intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & _). field. lra.
Qed.
Theorem near_w : near (fun t => w t / sqrt 2) 0.
Proof.
  apply (near_ext T (fun t => sqrt (2 * P t * h t))).
  - intros t Ht. destruct (h_pos _ _ _ _ _ H t Ht) as (z0 & hh & _ & P0 & e). assert (0 < / z t) by now apply Rinv_0_lt_compat. assert (s0 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
    assert (s2 : sqrt 2 ^ 2 = 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra). assert (0 <= w t / sqrt 2) by (apply Rmult_le_pos; [ nra | left; now apply Rinv_0_lt_compat ]).
    rewrite <- (sqrt_pow2 (w t / sqrt 2)) by trivial. f_equal. unfold Rdiv. rewrite !Rpow_mult_distr, e, !pow_inv, s2. field. lra.
  - eapply near_eq. apply (near_root (fun t => 2 * P t * h t)), (near_mult (fun t => 2 * P t)); [ exact near_P | exact near_h ]. field.
Qed.
End Hunt.
