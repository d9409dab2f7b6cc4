(* Every escape as prey and predator. With d = pi/2 - psi: z = tan(d/2), h = tanh alpha, N = cosh alpha/(2 A z) and
   P = 1/(z^2 (exp(4 alpha) - 1)). Wherever h goes to 1, N settles at 3/4 and P at 1/2 (V falls), (N - 3/4)/z at 3 sqrt 2/32 and
   (P - 1/2)/z at 3 sqrt 2/8 (Q falls), and 1/z is t - (3 sqrt 2/4) ln t + o(ln t). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Late.
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
  intros H. pose proof (sqrt_lt_R0 y H) as s0. pose proof (root_sq y ltac:(lra)) as s2. pose proof (exp_ineq1_le (ln (sqrt y))) as k.
    rewrite exp_ln in k by trivial.
  unfold off. replace (ln y) with (2 * ln (sqrt y)). nra. rewrite <- s2 at 2. rewrite <- Rsqr_pow2. unfold Rsqr. rewrite ln_mult by trivial. ring.
Qed.
Lemma off_most y : / 2 <= y -> off y <= 2 * (y - 1) ^ 2.
Proof.
  intros H. pose proof (exp_ineq1_le (ln (/ y))) as k. rewrite exp_ln in k by (apply Rinv_0_lt_compat; lra). rewrite ln_Rinv in k by lra. unfold off.
  apply Rle_trans with ((y - 1) ^ 2 / y). replace ((y - 1) ^ 2 / y) with (y - 2 + / y) by (field; lra). lra.
  apply Rle_div_l. lra. pose proof (pow2_ge_0 (y - 1)). nra.
Qed.
Lemma errors x y f1 f2 f3 : x * (f1 * x + f2 * y + f3) <= (Rabs f1 + Rabs f2 + Rabs f3) * (Rabs x * (Rabs x + Rabs y + 1)).
Proof.
  eapply Rle_trans. apply Rle_abs. rewrite Rabs_mult. pose proof (Rabs_triang (f1 * x + f2 * y) f3). pose proof (Rabs_triang (f1 * x) (f2 * y)).
  rewrite !Rabs_mult in *. pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (Rabs_pos f1). pose proof (Rabs_pos f2).
    pose proof (Rabs_pos f3).
  rewrite (Rmult_comm (Rabs x)), <- Rmult_assoc, (Rmult_comm _ (Rabs x)), (Rmult_comm _ (Rabs x)), Rmult_assoc. apply Rmult_le_compat_l; nra.
Qed.

Section Hunt.
Variables (T : R) (z h N P : R -> R).
Hypothesis H : hunt T z h N P.
Let T1 : 1 <= T := h_from _ _ _ _ _ H.
Let h1 : is_lim h p_infty 1 := h_one _ _ _ _ _ H.
Ltac at_ t := destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (z0 & hh & N0 & P0 & e0); pose proof (Rinv_0_lt_compat _ z0) as i0;
  destruct (h_law _ _ _ _ _ H t ltac:(lra)) as (DZ & DN & DP).
Ltac conth t := destruct (h_cont _ _ _ _ _ H t ltac:(lra)) as (CZ & CN & CP); contq.

(* z^2 P = 1/(exp(4 alpha) - 1) vanishes, and with it z *)
Lemma little : tends (fun t => z t ^ 2 * P t) 0.
Proof.
  apply (tends_ext T (fun t => (1 - h t) ^ 2 * / (4 * h t))).
  - intros t Ht. at_ t. rewrite e0. field. lra.
  - limit. lra. field.
Qed.
Lemma z_below eta : 0 < eta -> exists T', T <= T' /\ forall t, T' <= t -> z t <= eta.
Proof.
  intros He. assert (e2 : 0 < eta ^ 2) by nra. destruct (in_the_end T _ 0 (eta ^ 2 / 2) little ltac:(lra)) as (T2 & T20 & HT).
  destruct (sinks z eta (eta ^ 2) 1 T2) as (T3 & T30 & H3); try lra.
  - intros t Ht. conth t.
  - intros t Ht. specialize (HT t ltac:(lra)). at_ t. eexists. split. exact DZ. intros k. unfold z_rate.
    assert (eta ^ 2 / (t + 1) <= eta ^ 2) by (apply Rle_div_l; [ lra | nra ]). set (m := z t ^ 2 * P t) in *. assert (eta ^ 2 <= z t ^ 2) by nra.
    assert (0 < m) by (unfold m; assert (0 < z t ^ 2) by nra; nra). assert (0 < m * z t ^ 2) by nra.
    replace (2 * z t ^ 2 * (1 - (1 - z t ^ 2) * P t)) with (2 * z t ^ 2 - 2 * m + 2 * (m * z t ^ 2)) by (unfold m; ring). lra.
  - exists T3. split; trivial. lra.
Qed.
Lemma z_zero : tends z 0.
Proof.
  apply by_square. intros e He. destruct (z_below (sqrt e)) as (T' & T0 & HT). now apply sqrt_lt_R0. exists T'. intros t Ht. specialize (HT t Ht).
  at_ t. rewrite <- (root_sq e) by lra. nra.
Qed.
Lemma dinv t : T <= t -> rder (fun t => / z t) t (2 * (1 - (1 - z t ^ 2) * P t)).
Proof. intros Ht. at_ t. eapply rder_eq. rdq. lra. unfold z_rate. field. lra. Qed.
Lemma cinv t : T < t -> continuity_pt (fun t => / z t) t.
Proof. intros Ht. at_ t. conth t. lra. Qed.
(* the clock in which they hunt goes as ln t at least *)
Lemma clock : exists T' c, T <= T' /\ 0 <= c /\ forall t, T' <= t -> / (t + c) <= 2 * z t.
Proof.
  destruct (z_below 1 Rlt_0_1) as (T' & T0 & HT). at_ T'. exists T', (/ z T' / 2). split; trivial. split. lra. intros t Ht.
  assert (K : / z t - 2 * t <= / z T' - 2 * T').
  { apply (rder_decr (fun t => / z t - 2 * t)); trivial; intros r Hr.
    - pose proof (cinv r ltac:(lra)). contq.
    - eexists. split. apply (rder_minus (fun t => / z t)); [ apply dinv; lra | rdq ]. clear - H T0 Hr HT. specialize (HT r ltac:(lra)).
      destruct (h_pos _ _ _ _ _ H r ltac:(lra)) as (z0 & _ & _ & P0 & _). assert (0 <= (1 - z r ^ 2) * P r) by (apply Rmult_le_pos; nra). lra. }
  clear e0. destruct (h_pos _ _ _ _ _ H t ltac:(lra)) as (zt & _). rewrite <- (Rinv_involutive (2 * z t)), Rinv_mult_distr by lra.
  pose proof (Rinv_0_lt_compat _ zt). apply Rinv_le_contravar; lra.
Qed.
(* what falls in that clock sinks *)
Lemma hunted f e m T0 : T <= T0 -> 0 < m -> (forall t, T0 < t -> continuity_pt f t) ->
  (forall t, T0 <= t -> exists l, rder f t (2 * z t * l) /\ (e <= f t -> l <= - m)) -> exists T', T0 <= T' /\ forall t, T' <= t -> f t <= e.
Proof.
  intros T00 m0 C D. destruct clock as (T2 & c & T20 & c0 & HT). pose proof (Rmax_l T0 T2). pose proof (Rmax_r T0 T2).
  destruct (sinks f e m c (Rmax T0 T2)) as (T' & T'0 & K); try lra.
  - intros. apply C. lra.
  - intros t Ht. destruct (D t ltac:(lra)) as (l & L & k). exists (2 * z t * l). split; trivial. intros q. specialize (k q).
    specialize (HT t ltac:(lra)). pose proof (Rinv_0_lt_compat (t + c) ltac:(lra)). unfold Rdiv.
    assert (m * / (t + c) <= m * (2 * z t)) by (apply Rmult_le_compat_l; lra). nra.
  - exists T'. split; trivial. lra.
Qed.
(* ... and so does what falls as the squares of a and b, but for vanishing multiples *)
Lemma pair_sinks f a b l F G : tends F 0 -> tends G 0 -> (forall t, T < t -> continuity_pt f t) ->
  (forall t, T <= t -> rder f t (2 * z t * l t) /\ l t <= - (a t ^ 2 + b t ^ 2) + F t * (Rabs (a t) * (Rabs (a t) + Rabs (b t) + 1)) +
    G t * (Rabs (b t) * (Rabs (b t) + Rabs (a t) + 1))) ->
  (forall e, 0 < e -> exists mu, 0 < mu /\ forall t, T <= t -> a t ^ 2 + b t ^ 2 < mu -> f t < e) ->
  forall e, 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> f t <= e.
Proof.
  intros LF LG C D M e He. destruct (M e He) as (mu & m0 & Hm). set (eta := Rmin (/ 6) (mu / 2)). assert (et0 : 0 < eta) by (apply Rmin_pos; lra).
  assert (et1 : eta <= / 6) by apply Rmin_l. assert (et2 : eta <= mu / 2) by apply Rmin_r.
  destruct (in_the_end T F 0 eta LF et0) as (Ta & Ta0 & Ha). destruct (in_the_end Ta G 0 eta LG et0) as (Tb & Tb0 & Hb).
  destruct (hunted f e (mu / 4) Tb) as (T' & T'0 & K); try lra.
  - intros. apply C. lra.
  - intros t Ht. destruct (D t ltac:(lra)) as [L B]. exists (l t). split; trivial. intros k.
    assert (far : mu <= a t ^ 2 + b t ^ 2) by (apply Rnot_lt_le; intros n; pose proof (Hm t ltac:(lra) n); lra).
    specialize (Ha t ltac:(lra)). specialize (Hb t Ht). pose proof (Rabs_pos (a t)). pose proof (Rabs_pos (b t)).
    rewrite <- (pow2_abs (a t)), <- (pow2_abs (b t)) in *. set (X := Rabs (a t)) in *. set (Y := Rabs (b t)) in *. eapply Rle_trans. exact B.
    assert (F t * (X * (X + Y + 1)) <= eta * (X * (X + Y + 1))) by (apply Rmult_le_compat_r; nra).
    assert (G t * (Y * (Y + X + 1)) <= eta * (Y * (Y + X + 1))) by (apply Rmult_le_compat_r; nra).
    assert (q : (X + Y) ^ 2 + (X + Y) <= 3 * (X ^ 2 + Y ^ 2) + / 2) by (pose proof (pow2_ge_0 (X + Y - 1)); pose proof (pow2_ge_0 (X - Y)); lra).
    apply (Rmult_le_compat_l eta) in q; [ | lra ]. assert (eta * (X ^ 2 + Y ^ 2) <= / 6 * (X ^ 2 + Y ^ 2)) by (apply Rmult_le_compat_r; nra). lra.
  - exists T'. split; trivial. lra.
Qed.

Notation k t := (/ (1 + z t ^ 2)).
Definition V t := 3 * off (4 / 3 * N t) + off (2 * P t) * / 2.
Lemma V_small e : 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> V t <= e.
Proof.
  pose proof little as Lm. pose proof z_zero as Lz. set (c1 t := / 2 + h t * k t - 3 / 2 * h t + z t ^ 2 * P t). set (c2 t := 2 * (1 - h t)).
  set (c3 t := / 2 + z t ^ 2 * P t - 2 * (1 + z t ^ 2 * P t) * (k t - 3 / 4)). set (c4 t := 2 * (z t ^ 2 * P t)).
  assert (L1 : tends c1 0) by (unfold c1; limit; [ lra | field ]). assert (L2 : tends c2 0) by (unfold c2; limit; ring).
  assert (L3 : tends c3 0) by (unfold c3; limit; [ lra | field ]). assert (L4 : tends c4 0) by (unfold c4; limit; ring).
  apply (pair_sinks V (fun t => N t - 3 / 4) (fun t => P t - / 2)
    (fun t => 4 * (N t - 3 / 4) * (1 + h t * k t - 2 * h t * N t - (1 - z t ^ 2) * P t) +
      2 * (P t - / 2) * (1 - (1 - z t ^ 2) * P t - 2 * (1 + z t ^ 2 * P t) * (k t - N t)))
    (fun t => Rabs (4 * c2 t) + Rabs 0 + Rabs (4 * c1 t)) (fun t => Rabs 0 + Rabs (2 * c4 t) + Rabs (2 * c3 t))).
  - limit. rewrite !Rmult_0_r, Rabs_R0. ring.
  - limit. rewrite !Rmult_0_r, Rabs_R0. ring.
  - intros t Ht. at_ t. unfold V, off. conth t; lra.
  - intros t Ht. at_ t. split. { unfold V, off. eapply rder_eq. rdq; lra. unfold prey_rate, predator_rate. field. repeat split; nra. }
    pose proof (errors (N t - 3 / 4) (P t - / 2) (4 * c2 t) 0 (4 * c1 t)). pose proof (errors (P t - / 2) (N t - 3 / 4) 0 (2 * c4 t) (2 * c3 t)).
    pose proof (pow2_ge_0 (N t - 3 / 4)). pose proof (pow2_ge_0 (P t - / 2)). unfold c1, c2, c3, c4 in *. set (kt := k t) in *. lra.
  - intros e' He. exists (Rmin (/ 64) (e' / 11)). split. apply Rmin_pos; lra. intros t Ht q. pose proof (Rmin_l (/ 64) (e' / 11)).
    pose proof (Rmin_r (/ 64) (e' / 11)). pose proof (pow2_ge_0 (N t - 3 / 4)). pose proof (pow2_ge_0 (P t - / 2)).
    assert (/ 2 < N t) by nra. assert (/ 4 < P t) by nra. pose proof (off_most (4 / 3 * N t) ltac:(lra)).
      pose proof (off_most (2 * P t) ltac:(lra)). unfold V. lra.
Qed.
Theorem settles : tends N (3 / 4) /\ tends P (1 / 2).
Proof.
  assert (K : tends (fun t => sqrt (4 / 3 * N t)) 1 /\ tends (fun t => sqrt (2 * P t)) 1).
  { split; apply by_square; intros e He; (destruct (V_small (e / 2)) as (T' & T0 & HT); [ lra | exists T'; intros t Ht; specialize (HT t Ht) ]);
      at_ t; pose proof (off_least (4 / 3 * N t) ltac:(lra)); pose proof (off_least (2 * P t) ltac:(lra));
      pose proof (pow2_ge_0 (sqrt (4 / 3 * N t) - 1)); pose proof (pow2_ge_0 (sqrt (2 * P t) - 1)); unfold V in HT; lra. }
  destruct K as [K1 K2].
    split; [ apply (tends_ext T (fun t => 3 / 4 * sqrt (4 / 3 * N t) ^ 2)) | apply (tends_ext T (fun t => 1 / 2 * sqrt (2 * P t) ^ 2)) ];
    try (limit; field); intros t Ht; at_ t; rewrite root_sq; lra.
Qed.
Let N1 := proj1 settles.
Let P1 := proj2 settles.
Let z1 := z_zero.
Lemma w_limit : tends (fun t => (1 - h t) * / z t) (sqrt 2).
Proof.
  apply (tends_ext T (fun t => sqrt (4 * P t * h t))).
  - intros t Ht. at_ t. rewrite <- (sqrt_pow2 ((1 - h t) * / z t)) by nra. f_equal. rewrite Rpow_mult_distr, e0. field. lra.
  - limit. lra. f_equal. field.
Qed.
Theorem first_order : tends (fun t => / z t / t) 1.
Proof.
  apply (hospital T _ (fun t => 2 * (1 - (1 - z t ^ 2) * P t)) (fun t => t) (fun _ => 1)).
  - intros t Ht. split. now apply dinv. split; [ rdq | lra ].
  - intros t Ht. split. now apply cinv. contq.
  - limit; lra.
  - apply is_lim_id.
Qed.

(* the deviations, in units of z *)
Notation q t := ((N t - 3 / 4) * / z t).
Notation v t := ((P t - / 2) * / z t).
Notation w t := ((1 - h t) * / z t).
Definition c10 t := N t * w t * (2 * N t - 1) + N t * z t * (P t - k t * h t).
Definition c11 t := - 2 * N t + 1 - (1 - z t ^ 2) * P t.
Definition c20 t := 2 * P t * z t * (P t + 2 * (1 - P t) * k t + 2 * P t * N t).
Definition c22 t := - 2 * P t + 1 - (1 - z t ^ 2) * P t.
Lemma dq t : T <= t -> rder (fun t => q t) t (2 * z t * (c11 t * q t - N t * v t + c10 t)).
Proof. intros Ht. at_ t. eapply rder_eq. rdq. lra. unfold z_rate, prey_rate, c11, c10. field. split; nra. Qed.
Lemma dv t : T <= t -> rder (fun t => v t) t (2 * z t * (4 * P t * q t + c22 t * v t + c20 t)).
Proof. intros Ht. at_ t. eapply rder_eq. rdq. lra. unfold z_rate, predator_rate, c22, c20. field. split; nra. Qed.
Definition q0 := 3 * sqrt 2 / 32.
Definition v0 := 3 * sqrt 2 / 8.
Definition Q t := 8 / 3 * (q t - q0) ^ 2 + (v t - v0) ^ 2.
Lemma Q_small e : 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> Q t <= e.
Proof.
  pose proof w_limit as W. cbv beta in W. set (f1 t := c11 t + 1). set (f2 t := 3 / 4 - N t). set (f3 t := c11 t * q0 - N t * v0 + c10 t).
  set (f4 t := 4 * P t - 2). set (f5 t := c22 t + / 2). set (f6 t := 4 * P t * q0 + c22 t * v0 + c20 t).
  assert (L1 : tends f1 0) by (unfold f1, c11; limit; field). assert (L2 : tends f2 0) by (unfold f2; limit; field).
  assert (L3 : tends f3 0) by (unfold f3, c11, c10; limit; [ lra | unfold q0, v0; field ]). assert (L4 : tends f4 0) by (unfold f4; limit; field).
  assert (L5 : tends f5 0) by (unfold f5, c22; limit; field).
  assert (L6 : tends f6 0) by (unfold f6, c22, c20; limit; [ lra | unfold q0, v0; field ]).
  apply (pair_sinks Q (fun t => q t - q0) (fun t => v t - v0)
    (fun t => 16 / 3 * (q t - q0) * (c11 t * q t - N t * v t + c10 t) + 2 * (v t - v0) * (4 * P t * q t + c22 t * v t + c20 t))
    (fun t => Rabs (16 / 3 * f1 t) + Rabs (16 / 3 * f2 t) + Rabs (16 / 3 * f3 t)) (fun t => Rabs (2 * f5 t) + Rabs (2 * f4 t) + Rabs (2 * f6 t))).
  - limit. rewrite !Rmult_0_r, Rabs_R0. ring.
  - limit. rewrite !Rmult_0_r, Rabs_R0. ring.
  - intros t Ht. pose proof (cinv t Ht) as CI. cbv beta in CI. unfold Q. conth t.
  - intros t Ht. pose proof (dq t Ht) as D1. pose proof (dv t Ht) as D2. set (x := q t - q0). set (y := v t - v0). split.
    { unfold Q. eapply rder_eq. apply (rder_plus (fun t => 8 / 3 * (q t - q0) ^ 2) (fun t => (v t - v0) ^ 2)).
      - apply (rder_mult (fun _ => 8 / 3)); [ rdq | ]. apply (rder_pow (fun t => q t - q0)), (rder_minus (fun t => q t)); [ exact D1 | rdq ].
      - apply (rder_pow (fun t => v t - v0)), (rder_minus (fun t => v t)); [ exact D2 | rdq ].
      - cbv beta. simpl INR. simpl pred. fold x y. field. destruct (h_pos _ _ _ _ _ H t Ht) as [z0 _]. lra. }
    pose proof (errors x y (16 / 3 * f1 t) (16 / 3 * f2 t) (16 / 3 * f3 t)). pose proof (errors y x (2 * f5 t) (2 * f4 t) (2 * f6 t)).
    replace (q t) with (x + q0) by (unfold x; ring). replace (v t) with (y + v0) by (unfold y; ring). pose proof (pow2_ge_0 x).
    unfold f1, f2, f3, f4, f5, f6 in *. lra.
  - intros e' He. exists (3 / 8 * e'). split. lra. intros t Ht ht. unfold Q. pose proof (pow2_ge_0 (v t - v0)). lra.
Qed.
Theorem deviations : tends (fun t => q t) q0 /\ tends (fun t => v t) v0.
Proof.
  split; apply by_square; intros e He; destruct (Q_small e He) as (T' & T0 & HT); exists T'; intros t Ht; specialize (HT t Ht); unfold Q in HT;
    pose proof (pow2_ge_0 (q t - q0)); pose proof (pow2_ge_0 (v t - v0)); lra.
Qed.
Lemma zt_limit : tends (fun t => z t * t) 1.
Proof.
  pose proof first_order as L1. cbv beta in L1. apply (tends_ext T (fun t => / (/ z t / t))); [ | limit; lra ]. intros t Ht. at_ t. field. lra.
Qed.
(* 1/z lags behind the time *)
Theorem lags : near (fun t => / z t / t) (- (2 * v0)).
Proof.
  destruct deviations as [_ Lv]. cbv beta in Lv. pose proof zt_limit as L2. cbv beta in L2.
    apply (tends_ext (Rmax T (exp 1)) (fun t => (/ z t - t) / ln t)).
  { intros t Ht. pose proof (Rmax_l T (exp 1)). pose proof (Rmax_r T (exp 1)). at_ t. destruct (lnt t ltac:(lra)). field. lra. }
  apply (hospital T _ (fun t => 2 * (1 - (1 - z t ^ 2) * P t) - 1) ln (fun t => 1 / t)).
  - intros t Ht. split; [ | split ].
    + apply (rder_minus (fun t => / z t) (fun t => t)); [ now apply dinv | rdq ].
    + apply (rder_ln (fun t => t)); [ rdq | lra ].
    + apply Rdiv_lt_0_compat; lra.
  - intros t Ht. split. { pose proof (cinv t Ht). contq. } apply (cont_ln (fun t => t)); [ contq | lra ].
  - apply (tends_ext T (fun t => z t * t * (2 * z t * P t - 2 * v t))). { intros t Ht. at_ t. field. lra. } limit. unfold v0. field.
  - exact is_lim_ln_p.
Qed.
(* N, P and h differ from their limits by multiples of 1/t *)
Lemma near_multiple f g (l : R) : tends g l -> (forall t, T <= t -> f t = 1 + g t * z t) -> near f 0.
Proof.
  intros G E. apply (near_small T f (fun t => g t * (z t * t)) (l * 1)). apply tends_mult; [ exact G | exact zt_limit ]. intros t Ht.
    rewrite E by trivial. field. lra.
Qed.
Theorem near_N : near (fun t => 4 / 3 * N t) 0.
Proof. destruct deviations as [L _]. eapply near_multiple. apply (tends_mult (fun _ => 4 / 3)); [ apply is_lim_const | exact L ]. intros t Ht.
    at_ t. field. lra. Qed.
Theorem near_P : near (fun t => 2 * P t) 0.
Proof. destruct deviations as [_ L]. eapply near_multiple. apply (tends_mult (fun _ => 2)); [ apply is_lim_const | exact L ]. intros t Ht. at_ t.
    field. lra. Qed.
Theorem near_h : near h 0.
Proof. eapply near_multiple. apply (tends_mult (fun _ => - (1))); [ apply is_lim_const | exact w_limit ]. intros t Ht. at_ t. field. lra. Qed.
End Hunt.
