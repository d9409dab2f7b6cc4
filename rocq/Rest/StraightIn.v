(* The starts of what comes straight in fill no volume. While it does so its speed is at least (1 + s) times the time left, with s the distance of
   the rest; so of two that rest at the same moment, farther out than eta, the distance before is at most a multiple, known by eta, of that of their
   places of rest: the start depends on three numbers, by a Lipschitz function. Those that rest nearer to the axis lie close to a set given by the
   time and the velocity. *)
Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate Alpha Late TableMotions Threshold Stops Thin Arrives.
Import ListNotations.
Open Scope R_scope.

Lemma spin_later c x y u w : 0 <= c -> spin x y u w -> spin (fun t => x (t + c)) (fun t => y (t + c)) (fun t => u (t + c)) (fun t => w (t + c)).
Proof.
  intros Hc S. split; intros t Ht.
  - apply cont_after, S. lra.
  - apply cont_after, S. lra.
  - apply cont_after, S. lra.
  - apply cont_after, S. lra.
  - destruct (s_law _ _ _ _ S (t + c) ltac:(lra)) as (X & Y & fx & fy & C & U & W).
    split; [ now apply rder_after | split; [ now apply rder_after | ] ]. exists fx, fy. split; trivial.
    split; [ apply (rder_after u) | apply (rder_after w) ]; trivial.
Qed.
Lemma friction_apart u1 w1 u2 w2 m : 0 < m -> m <= nrm u1 w1 -> m <= nrm u2 w2 ->
  (u1 - u2) * (u1 / nrm u1 w1 - u2 / nrm u2 w2) + (w1 - w2) * (w1 / nrm u1 w1 - w2 / nrm u2 w2) <= ((u1 - u2) ^ 2 + (w1 - w2) ^ 2) / m.
Proof.
  intros m0 h1 h2. pose proof (nrm_sq u1 w1) as e1. pose proof (nrm_sq u2 w2) as e2. pose proof (dot_le u1 w1 u2 w2) as c.
  set (p1 := nrm u1 w1) in *. set (p2 := nrm u2 w2) in *. clearbody p1 p2.
  assert (i1 : / p1 <= / m) by (apply Rinv_le_contravar; lra). assert (i2 : / p2 <= / m) by (apply Rinv_le_contravar; lra).
  assert (im : 0 < / m) by now apply Rinv_0_lt_compat.
  apply Rle_trans with ((/ p1 + / p2) * (p1 * p2 - (u1 * u2 + w1 * w2))).
  { right. transitivity ((u1 ^ 2 + w1 ^ 2) / p1 + (u2 ^ 2 + w2 ^ 2) / p2 - (u1 * u2 + w1 * w2) * (/ p1 + / p2)). field. lra.
    rewrite <- e1, <- e2. field. lra. }
  apply Rle_trans with (2 * / m * (p1 * p2 - (u1 * u2 + w1 * w2))). { apply Rmult_le_compat_r; lra. }
  replace ((u1 - u2) ^ 2 + (w1 - w2) ^ 2) with (p1 ^ 2 + p2 ^ 2 - 2 * (u1 * u2 + w1 * w2)) by (rewrite e1, e2; ring). unfold Rdiv.
  pose proof (pow2_ge_0 (p1 - p2)). nra.
Qed.

Section Back.
Variables (x1 y1 u1 w1 x2 y2 u2 w2 : R -> R) (T eta B M : R).
Hypothesis S1 : spin x1 y1 u1 w1.
Hypothesis S2 : spin x2 y2 u2 w2.
Hypothesis T0 : 0 < T <= M.
Hypothesis eta0 : 0 < eta.
Hypothesis fast1 : forall t, 0 <= t < T -> (1 + eta) * (T - t) <= nrm (u1 t) (w1 t).
Hypothesis fast2 : forall t, 0 <= t < T -> (1 + eta) * (T - t) <= nrm (u2 t) (w2 t).
Hypothesis slow : forall t, 0 <= t < T -> (u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2 <= B * (T - t) ^ 2.
Hypothesis still : u1 T = 0 /\ w1 T = 0 /\ u2 T = 0 /\ w2 T = 0.
Notation F t := ((u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2).
Notation D t := ((x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2).
Let a := / (1 + eta).
Let mu := 1 - a.
Let c := M / mu.
Let E := exp (c * M).
Lemma a_mu : 0 < a < 1 /\ 0 < mu < 1.
Proof.
  assert (0 < a) by (apply Rinv_0_lt_compat; lra). assert (a < 1). { unfold a. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. } unfold mu. lra.
Qed.
Lemma places t : 0 <= t <= T -> D t <= F t + D T.
Proof. intros Ht. pose proof (two_apart _ _ _ _ _ _ _ _ t T S1 S2 Ht) as k. destruct still as (-> & -> & -> & ->) in k. nra. Qed.
Lemma back t : 0 <= t < T -> F t <= E * D T / mu ^ 2 * (T - t) ^ 2.
Proof.
  destruct a_mu as [Ha Hm]. set (d := D T). assert (d0 : 0 <= d) by (unfold d; pose proof (pow2_ge_0 (x1 T - x2 T));
    pose proof (pow2_ge_0 (y1 T - y2 T)); lra).
  set (k := E * d / mu ^ 2). assert (E0 : 0 < E) by apply exp_pos. assert (m2 : 0 < mu ^ 2) by (apply pow_lt; lra).
  assert (k0 : 0 <= k) by (apply Rmult_le_pos; [ nra | left; now apply Rinv_0_lt_compat ]).
  assert (c0 : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  set (K t := F t * Rpower (T - t) (- (1 + a)) * exp (c * t) - k * Rpower (T - t) mu).
  assert (tau : soon T (fun t => 0 < T - t)) by (exists 1; split; [ lra | intros; lra ]).
  assert (lt : left_lim (fun t => T - t) T 0) by (eapply ll_eq; [ apply (ll_cont (fun t => T - t)); cont | ring ]).
  assert (L : left_lim K T 0).
  { assert (q : left_lim (fun t => Rpower (T - t) mu) T 0) by (apply ll_power; trivial; lra).
    assert (q1 : left_lim (fun t => F t * Rpower (T - t) (- (1 + a)) * exp (c * t)) T 0).
    { apply (ll_squeeze _ (fun t => B * E * Rpower (T - t) mu)).
      - apply (soon_after 0); [ lra | ]. intros r Hr. pose proof (slow r Hr) as b. set (P := Rpower (T - r) (- (1 + a))).
        assert (P0 : 0 < P) by apply power_pos.
        assert (F0 : 0 <= F r) by (pose proof (pow2_ge_0 (u1 r - u2 r)); pose proof (pow2_ge_0 (w1 r - w2 r)); lra).
        assert (e0 : 0 < exp (c * r) <= E). { split. apply exp_pos. unfold E.
          destruct (Rle_lt_or_eq_dec (c * r) (c * M) ltac:(nra)) as [l | ->]; [ left; now apply exp_increasing | lra ]. }
        rewrite Rabs_pos_eq by (repeat apply Rmult_le_pos; lra).
        replace (B * E * Rpower (T - r) mu) with (B * (T - r) ^ 2 * P * E).
        + apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. apply Rmult_le_compat_r; lra.
        + replace mu with (2 + - (1 + a)) by (unfold mu; ring). rewrite Rpower_plus. fold P. replace (Rpower (T - r) 2) with ((T - r) ^ 2). ring.
          rewrite <- Rpower_pow by lra. reflexivity.
      - eapply ll_eq. apply (ll_mult (fun _ => B * E)); [ apply ll_const | exact q ]. ring. }
    eapply ll_eq. exact (ll_minus _ _ T _ _ q1 (ll_mult _ _ T _ _ (ll_const k T) q)). ring. }
  assert (up : forall t, 0 <= t < T -> K t <= 0).
  { apply (ll_incr K 0 T 0 L); intros r Hr.
    - assert (cp : forall e, continuity_pt (fun t => Rpower (T - t) e) r) by (intros e; apply (cont_power (fun t => T - t)); [ cont | lra ]).
      unfold K. apply (continuity_pt_minus (fun t => F t * Rpower (T - t) (- (1 + a)) * exp (c * t)) (fun t => k * Rpower (T - t) mu)).
      + apply (continuity_pt_mult (fun t => F t * Rpower (T - t) (- (1 + a))) (fun t => exp (c * t))); [ | cont ].
        apply (continuity_pt_mult (fun t => F t) (fun t => Rpower (T - t) (- (1 + a)))); [ | apply cp ].
        cont; first [ apply (s_cu _ _ _ _ S1) | apply (s_cw _ _ _ _ S1) | apply (s_cu _ _ _ _ S2) | apply (s_cw _ _ _ _ S2) ]; lra.
      + apply (continuity_pt_mult (fun _ => k)); [ cont | apply cp ].
    - pose proof (fast1 r Hr) as f1. pose proof (fast2 r Hr) as f2. set (tt := T - r) in *. assert (t0 : 0 < tt) by (unfold tt; lra).
      assert (m0 : 0 < (1 + eta) * tt) by nra.
      destruct (slip x1 y1 u1 w1 S1 r ltac:(lra) ltac:(lra)) as (X1 & Y1 & U1 & W1).
        destruct (slip x2 y2 u2 w2 S2 r ltac:(lra) ltac:(lra)) as (X2 & Y2 & U2 & W2).
      assert (dt : rder (fun t => T - t) r (- (1))) by (eapply rder_eq; [ rd | ring ]).
      assert (dF : rder (fun t => F t) r (2 * ((u1 r - u2 r) * (x1 r - x2 r) + (w1 r - w2 r) * (y1 r - y2 r)) - 2 *
        ((u1 r - u2 r) * (u1 r / nrm (u1 r) (w1 r) - u2 r / nrm (u2 r) (w2 r)) + (w1 r - w2 r) * (w1 r / nrm (u1 r) (w1 r) - w2 r / nrm (u2 r) (w2
          r))))).
      { eapply rder_eq. rd. simpl INR. simpl pred. ring. }
      eexists. split.
      { apply (rder_minus (fun t => F t * Rpower (T - t) (- (1 + a)) * exp (c * t)) (fun t => k * Rpower (T - t) mu)).
        - apply (rder_mult (fun t => F t * Rpower (T - t) (- (1 + a))) (fun t => exp (c * t))).
          apply (rder_mult (fun t => F t) (fun t => Rpower (T - t) (- (1 + a)))); [ exact dF | apply (rder_power _ _ _ _ dt); lra ]. rd.
        - apply (rder_mult (fun _ => k)); [ apply rder_fixed | apply (rder_power _ _ _ _ dt); lra ]. }
      cbv beta. fold tt. pose proof (friction_apart (u1 r) (w1 r) (u2 r) (w2 r) _ m0 f1 f2) as f. pose proof (places r ltac:(lra)) as pl.
        fold d in pl.
      set (fr := _ + _ * (w1 r / _ - _)) in *. set (X := (u1 r - u2 r) * (x1 r - x2 r) + _) in *.
      assert (F0 : 0 <= F r) by (pose proof (pow2_ge_0 (u1 r - u2 r)); pose proof (pow2_ge_0 (w1 r - w2 r)); lra).
      assert (kx : 0 <= mu / tt * F r + 2 * X + tt / mu * D r).
      { replace (mu / tt * F r + 2 * X + tt / mu * D r) with (mu / tt * ((u1 r - u2 r + tt / mu * (x1 r - x2 r)) ^ 2 + (w1 r - w2 r + tt / mu * (y1
        r - y2 r)) ^ 2))
          by (unfold X; field; lra).
        apply Rmult_le_pos. left; apply Rdiv_lt_0_compat; lra. pose proof (pow2_ge_0 (u1 r - u2 r + tt / mu * (x1 r - x2 r))).
        pose proof (pow2_ge_0 (w1 r - w2 r + tt / mu * (y1 r - y2 r))). lra. }
      set (f' := F r) in *. set (D' := D r) in *. replace (f' / ((1 + eta) * tt)) with (a * f' / tt) in f by (unfold a; field; lra).
      set (P := Rpower tt (- (1 + a))). assert (P0 : 0 < P) by apply power_pos.
      replace (Rpower tt (- (1 + a) - 1)) with (P / tt). 2: { unfold Rminus. rewrite (Rpower_plus _ (- (1))). fold P.
        rewrite Rpower_Ropp, Rpower_1 by trivial. reflexivity. }
      replace (Rpower tt (mu - 1)) with (P * tt). 2: { unfold P. rewrite <- (Rpower_1 tt) at 2 by trivial. rewrite <- Rpower_plus. f_equal.
        unfold mu. ring. }
      assert (e0 : 0 < exp (c * r) <= E). { split. apply exp_pos. unfold E.
        destruct (Rle_lt_or_eq_dec (c * r) (c * M) ltac:(nra)) as [l | ->]; [ left; now apply exp_increasing | lra ]. }
      set (e := exp (c * r)) in *.
      assert (low : - (tt / mu * d) <= 2 * X - 2 * fr + (1 + a) * f' / tt + c * f').
      { assert (tm : tt / mu <= c). { unfold c, Rdiv. apply Rmult_le_compat_r. left; apply Rinv_0_lt_compat; lra. unfold tt; lra. }
        assert (0 <= tt / mu) by (left; apply Rdiv_lt_0_compat; lra).
        assert (tt / mu * D' <= tt / mu * (f' + d)) by (apply Rmult_le_compat_l; lra).
          assert (tt / mu * f' <= c * f') by (apply Rmult_le_compat_r; lra).
        replace ((1 + a) * f' / tt) with (2 * (a * f' / tt) + mu / tt * f') by (unfold mu; field; lra). lra. }
      match goal with |- 0 <= ?g => replace g with (P * e * (2 * X - 2 * fr + (1 + a) * f' / tt + c * f') + k * mu * (P * tt)) end.
      2: { unfold X, fr. field. lra. }
      replace (k * mu * (P * tt)) with (E * (P * (tt / mu * d))) by (unfold k; field; lra).
      assert (Q : 0 <= P * (tt / mu * d)) by (apply Rmult_le_pos; [ lra | apply Rmult_le_pos; [ left; apply Rdiv_lt_0_compat; lra | trivial ] ]).
      assert (P * e * - (tt / mu * d) <= P * e * (2 * X - 2 * fr + (1 + a) * f' / tt + c * f')) by (apply Rmult_le_compat_l; nra). nra. }
  intros Ht. specialize (up t Ht). unfold K in up. set (tt := T - t) in *. assert (t0 : 0 < tt) by (unfold tt; lra).
  assert (F0 : 0 <= F t) by (pose proof (pow2_ge_0 (u1 t - u2 t)); pose proof (pow2_ge_0 (w1 t - w2 t)); lra).
  assert (e1 : 1 <= exp (c * t)). { rewrite <- exp_0. destruct (Rle_lt_or_eq_dec 0 (c * t) ltac:(nra)) as [l | <-]; [ left;
    now apply exp_increasing | lra ]. }
  set (P := Rpower tt (- (1 + a))) in *. assert (P0 : 0 < P) by apply power_pos.
  replace (Rpower tt mu) with (P * tt ^ 2) in up.
  2: { replace mu with (- (1 + a) + 2) by (unfold mu; ring). rewrite Rpower_plus. fold P. replace (Rpower tt 2) with (tt ^ 2); trivial.
    rewrite <- Rpower_pow by lra. reflexivity. }
  apply (Rmult_le_reg_l P); trivial. assert (q : 0 <= F t * P) by (apply Rmult_le_pos; lra).
    assert (F t * P * 1 <= F t * P * exp (c * t)) by (apply Rmult_le_compat_l; lra). fold k. lra.
Qed.
End Back.

(* the motion from z comes to rest at T, at (s cos th, s sin th), and comes straight in *)
Record straight (s th T : R) (z : place -> R) (x y u w : R -> R) : Prop := {
  i_spin : spin x y u w;  i_T : 0 < T;  i_s : 0 <= s;
  i_start : x 0 = z px /\ y 0 = z py /\ u 0 = z pu /\ w 0 = z pw;
  i_end : x T = s * cos th /\ y T = s * sin th /\ u T = 0 /\ w T = 0;
  i_in : forall t, 0 <= t < T -> 0 < nrm (u t) (w t) /\ (x t * u t + y t * w t) * / nrm (u t) (w t) <= - s }.

Section Straight.
Variables (s th T : R) (z : place -> R) (x y u w : R -> R) (N : R).
Hypothesis I : straight s th T z x y u w.
Hypothesis N0 : 0 < N.
Hypothesis box : forall i, Rabs (z i) <= N.
Notation p t := (nrm (u t) (w t)).
Let S := i_spin _ _ _ _ _ _ _ _ I.
Let T0 := i_T _ _ _ _ _ _ _ _ I.
Let s0 := i_s _ _ _ _ _ _ _ _ I.
Definition reach := N + 4 * N ^ 2.
Definition fastest := reach + 4 * N + 1.
Lemma brakes a b : 0 <= a <= b -> b <= T -> p b + (1 + s) * b <= p a + (1 + s) * a.
Proof.
  intros Hab HT. apply (rder_decr (fun t => p t + (1 + s) * t)); [ lra | intros; table S | ]. intros r Hr.
  destruct (i_in _ _ _ _ _ _ _ _ I r ltac:(lra)) as [p0 xi]. eexists. split.
  apply (rder_plus (fun t => p t)); [ apply (d_p x y u w S r); lra | rd ]. cbv beta. lra.
Qed.
Lemma at_T : p T = 0.
Proof. destruct (i_end _ _ _ _ _ _ _ _ I) as (_ & _ & -> & ->). apply nrm_0. Qed.
Lemma p0_le : p 0 <= 2 * N.
Proof. destruct (i_start _ _ _ _ _ _ _ _ I) as (_ & _ & -> & ->). pose proof (nrm_abs (z pu) (z pw)). pose proof (box pu). pose proof (box pw). lra.
  Qed.
Lemma fast t : 0 <= t <= T -> (1 + s) * (T - t) <= p t.
Proof. intros Ht. pose proof (brakes t T ltac:(lra) ltac:(lra)). rewrite at_T in *. lra. Qed.
Lemma p_le t : 0 <= t <= T -> p t <= 2 * N.
Proof. intros Ht. pose proof (brakes 0 t ltac:(lra) ltac:(lra)). pose proof p0_le. nra. Qed.
Lemma T_le : T <= 2 * N. Proof. pose proof (fast 0 ltac:(lra)). pose proof p0_le. nra. Qed.
Lemma uw_le t : 0 <= t <= T -> Rabs (u t) <= 2 * N /\ Rabs (w t) <= 2 * N.
Proof. intros Ht. pose proof (p_le t Ht). destruct (abs_nrm (u t) (w t)). lra. Qed.
Lemma xy_le t : 0 <= t <= T -> Rabs (x t) <= reach /\ Rabs (y t) <= reach.
Proof.
  intros Ht. pose proof T_le. destruct (i_start _ _ _ _ _ _ _ _ I) as (e1 & e2 & _). pose proof (box px) as b1. pose proof (box py) as b2.
  rewrite <- e1 in b1. rewrite <- e2 in b2. assert (Nt : 2 * N * (t - 0) <= 4 * N ^ 2) by nra. unfold reach.
  assert (K : Rabs (x t - x 0) <= 2 * N * (t - 0) /\ Rabs (y t - y 0) <= 2 * N * (t - 0)).
  { split; (apply rder_lip; [ lra | intros; apply S; lra | ]); intros r Hr; destruct (s_law _ _ _ _ S r ltac:(lra)) as (X & Y & _);
      destruct (uw_le r ltac:(lra)); eauto. }
  destruct K as [k1 k2]. apply Rabs_le_between in k1, k2, b1, b2. split; apply Rabs_le; lra.
Qed.
Lemma s_le : s <= 2 * reach.
Proof.
  destruct (i_end _ _ _ _ _ _ _ _ I) as (e1 & e2 & _). destruct (xy_le T ltac:(lra)) as [k1 k2]. rewrite e1 in k1. rewrite e2 in k2.
  apply Rabs_le_between in k1, k2. pose proof (sin2_cos2 th) as q. unfold Rsqr in q. assert (r0 : 0 < reach) by (unfold reach; nra).
  assert (c2 : (s * cos th) ^ 2 <= reach ^ 2) by nra. assert (s2 : (s * sin th) ^ 2 <= reach ^ 2) by nra.
  assert (s ^ 2 = (s * cos th) ^ 2 + (s * sin th) ^ 2) by (transitivity (s ^ 2 * (sin th * sin th + cos th * cos th)); [ rewrite q; ring | ring ]).
    nra.
Qed.
Lemma moderate a b : 0 <= a <= b -> b <= T -> (Rabs (x b - x a) <= fastest * (b - a) /\ Rabs (y b - y a) <= fastest * (b - a)) /\
  Rabs (u b - u a) <= fastest * (b - a) /\ Rabs (w b - w a) <= fastest * (b - a).
Proof.
  intros Hab HT. assert (r0 : 0 < reach) by (unfold reach; nra).
  repeat split; (apply rder_lip; [ lra | intros; apply S; lra | ]); intros r Hr; destruct (i_in _ _ _ _ _ _ _ _ I r ltac:(lra)) as [p0 _];
    destruct (slip x y u w S r ltac:(lra) ltac:(lra)) as (X & Y & U & W); eexists; (split; [ eassumption | ]);
    destruct (uw_le r ltac:(lra)) as [k1 k2]; destruct (xy_le r ltac:(lra)) as [k3 k4]; unfold fastest; try lra.
  - assert (k5 : Rabs (u r / p r) <= 1). { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; now apply Rinv_0_lt_compat).
      destruct (abs_nrm (u r) (w r)). apply Rle_div_l; lra. }
    apply Rabs_le_between in k1, k2, k3, k4, k5. apply Rabs_le. lra.
  - assert (k5 : Rabs (w r / p r) <= 1). { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; now apply Rinv_0_lt_compat).
      destruct (abs_nrm (u r) (w r)). apply Rle_div_l; lra. }
    apply Rabs_le_between in k1, k2, k3, k4, k5. apply Rabs_le. lra.
Qed.
End Straight.
Definition apart s th s' th' := (s * cos th - s' * cos th') ^ 2 + (s * sin th - s' * sin th') ^ 2.
Lemma meet N s1 th1 T1 z1 x1 y1 u1 w1 s2 th2 T2 z2 x2 y2 u2 w2 : 0 < N -> (forall i, Rabs (z1 i) <= N) -> (forall i, Rabs (z2 i) <= N) ->
  straight s1 th1 T1 z1 x1 y1 u1 w1 -> straight s2 th2 T2 z2 x2 y2 u2 w2 -> T2 <= T1 -> exists q : place -> R,
  (forall i, Rabs (z1 i - q i) <= fastest N * (T1 - T2)) /\
  (q px - z2 px) ^ 2 + (q py - z2 py) ^ 2 <= (q pu - z2 pu) ^ 2 + (q pw - z2 pw) ^ 2 + apart s1 th1 s2 th2 /\
  forall eta, 0 < eta -> eta <= s1 -> eta <= s2 -> (q pu - z2 pu) ^ 2 + (q pw - z2 pw) ^ 2 <=
    exp (2 * N / (1 - / (1 + eta)) * (2 * N)) / (1 - / (1 + eta)) ^ 2 * (2 * N) ^ 2 * apart s1 th1 s2 th2.
Proof.
  intros HN b1 b2 I1 I2 HT. set (c := T1 - T2). assert (c0 : 0 <= c) by (unfold c; lra).
  pose proof (i_T _ _ _ _ _ _ _ _ I1) as T10. pose proof (i_T _ _ _ _ _ _ _ _ I2) as T20. pose proof (T_le _ _ _ _ _ _ _ _ N I2 b2) as TN.
  pose proof (spin_later c x1 y1 u1 w1 c0 (i_spin _ _ _ _ _ _ _ _ I1)) as S1. pose proof (i_spin _ _ _ _ _ _ _ _ I2) as S2.
  destruct (i_start _ _ _ _ _ _ _ _ I1) as (e1 & e2 & e3 & e4). destruct (i_start _ _ _ _ _ _ _ _ I2) as (f1 & f2 & f3 & f4).
  destruct (i_end _ _ _ _ _ _ _ _ I1) as (g1 & g2 & g3 & g4). destruct (i_end _ _ _ _ _ _ _ _ I2) as (h1 & h2 & h3 & h4).
  assert (ec : T2 + c = T1) by (unfold c; ring).
  assert (still : u1 (T2 + c) = 0 /\ w1 (T2 + c) = 0 /\ u2 T2 = 0 /\ w2 T2 = 0) by (rewrite ec; auto).
  exists (fun i => match i with px => x1 (0 + c) | py => y1 (0 + c) | pu => u1 (0 + c) | pw => w1 (0 + c) end).
  assert (R0 : 0 <= fastest N) by (unfold fastest, reach; nra). split; [ | split ].
  - destruct (moderate _ _ _ _ _ _ _ _ N I1 HN b1 0 c ltac:(lra) ltac:(unfold c; lra)) as ((k1 & k2) & k3 & k4).
    rewrite Rplus_0_l. rewrite Rminus_0_r in *. fold c. rewrite e1, e2, e3, e4 in *. intros []; now rewrite Rabs_minus_sym.
  - pose proof (places _ _ _ _ _ _ _ _ T2 S1 S2 still 0 ltac:(lra)) as k. cbv beta in k. rewrite ec, g1, g2, h1, h2, f1, f2, f3, f4 in k. exact k.
  - intros eta eta0 l1 l2.
    pose proof (back _ _ _ _ _ _ _ _ T2 eta (8 * fastest N ^ 2) (2 * N) S1 S2 ltac:(lra) eta0) as k. cbv beta in k.
    assert (K1 : forall t, 0 <= t < T2 -> (1 + eta) * (T2 - t) <= nrm (u1 (t + c)) (w1 (t + c))).
    { intros t Ht. pose proof (fast _ _ _ _ _ _ _ _ I1 (t + c) ltac:(unfold c; lra)) as f.
      replace (T1 - (t + c)) with (T2 - t) in f by (unfold c; ring). nra. }
    assert (K2 : forall t, 0 <= t < T2 -> (1 + eta) * (T2 - t) <= nrm (u2 t) (w2 t)).
    { intros t Ht. pose proof (fast _ _ _ _ _ _ _ _ I2 t ltac:(lra)) as f. nra. }
    assert (K3 : forall t, 0 <= t < T2 -> (u1 (t + c) - u2 t) ^ 2 + (w1 (t + c) - w2 t) ^ 2 <= 8 * fastest N ^ 2 * (T2 - t) ^ 2).
    { intros t Ht. destruct (moderate _ _ _ _ _ _ _ _ N I1 HN b1 (t + c) T1 ltac:(unfold c; lra) ltac:(lra)) as (_ & m1 & m2).
      destruct (moderate _ _ _ _ _ _ _ _ N I2 HN b2 t T2 ltac:(lra) ltac:(lra)) as (_ & m3 & m4). rewrite g3 in m1. rewrite g4 in m2.
        rewrite h3 in m3.
      rewrite h4 in m4. replace (T1 - (t + c)) with (T2 - t) in * by (unfold c; ring). set (v := fastest N * (T2 - t)) in *.
      apply Rabs_le_between in m1, m2, m3, m4. assert (v0 : 0 <= v) by lra.
        replace (8 * fastest N ^ 2 * (T2 - t) ^ 2) with (2 * (2 * v) ^ 2) by (unfold v; ring).
      assert ((u1 (t + c) - u2 t) ^ 2 <= (2 * v) ^ 2) by (apply pow_maj_Rabs, Rabs_le; lra).
      assert ((w1 (t + c) - w2 t) ^ 2 <= (2 * v) ^ 2) by (apply pow_maj_Rabs, Rabs_le; lra). lra. }
    specialize (k K1 K2 K3 still 0 ltac:(lra)). rewrite ec, g1, g2, h1, h2, f3, f4, Rminus_0_r in k. fold (apart s1 th1 s2 th2) in k.
    eapply Rle_trans; [ exact k | ]. set (mu := 1 - / (1 + eta)). set (E := exp _). assert (E0 : 0 < E) by apply exp_pos.
    assert (d0 : 0 <= apart s1 th1 s2 th2) by (unfold apart; pose proof (pow2_ge_0 (s1 * cos th1 - s2 * cos th2));
      pose proof (pow2_ge_0 (s1 * sin th1 - s2 * sin th2)); lra).
    assert (m0 : 0 < mu) by (destruct (a_mu eta eta0); unfold mu; lra). assert (i0 : 0 < / mu ^ 2) by (apply Rinv_0_lt_compat, pow_lt, m0).
    replace (E / mu ^ 2 * (2 * N) ^ 2 * apart s1 th1 s2 th2) with (E * apart s1 th1 s2 th2 / mu ^ 2 * (2 * N) ^ 2) by (unfold Rdiv; ring).
    apply Rmult_le_compat_l. apply Rmult_le_pos; [ apply Rmult_le_pos; lra | lra ]. apply pow_incr. lra.
Qed.
(* the starts of what comes to rest farther out than eta *)
Lemma close_out N eta : 0 < N -> 0 < eta -> exists k, 0 < k /\ forall e s1 th1 T1 z1 x1 y1 u1 w1 s2 th2 T2 z2 x2 y2 u2 w2, (forall i, Rabs (z1 i) <=
  N) ->
  (forall i, Rabs (z2 i) <= N) -> straight s1 th1 T1 z1 x1 y1 u1 w1 -> straight s2 th2 T2 z2 x2 y2 u2 w2 -> T2 <= T1 -> eta <= s1 -> eta <= s2 ->
  Rabs (s1 - s2) <= e -> Rabs (th1 - th2) <= e -> Rabs (T1 - T2) <= e -> forall i, Rabs (z1 i - z2 i) <= k * e.
Proof.
  intros HN He. set (C := exp (2 * N / (1 - / (1 + eta)) * (2 * N)) / (1 - / (1 + eta)) ^ 2 * (2 * N) ^ 2).
  assert (C0 : 0 <= C). { destruct (a_mu eta He) as [_ m]. unfold C. apply Rmult_le_pos; [ apply Rmult_le_pos; [ left; apply exp_pos | left;
    apply Rinv_0_lt_compat, pow_lt; lra ] | apply pow2_ge_0 ]. }
  set (r := 1 + 2 * reach N). assert (r0 : 0 < r) by (unfold r, reach; nra). set (Q := (C + 1) * (2 * r ^ 2) + 1).
  assert (Q1 : 1 <= Q) by (unfold Q; pose proof (pow2_ge_0 r); nra). assert (R0 : 0 <= fastest N) by (unfold fastest, reach; nra).
  exists (fastest N + Q). split. lra. intros e s1 th1 T1 z1 x1 y1 u1 w1 s2 th2 T2 z2 x2 y2 u2 w2 b1 b2 I1 I2 HT l1 l2 hs hth hT.
  destruct (meet N _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN b1 b2 I1 I2 HT) as (q & near & D & F). specialize (F eta He l1 l2). fold C in F.
  assert (e0 : 0 <= e) by (pose proof (Rabs_pos (s1 - s2)); lra). pose proof (s_le _ _ _ _ _ _ _ _ N I2 HN b2) as sN.
    pose proof (i_s _ _ _ _ _ _ _ _ I2) as s20.
  assert (d : apart s1 th1 s2 th2 <= 2 * (r * e) ^ 2).
  { assert (one : forall f g, Rabs f <= 1 -> Rabs (f - g) <= Rabs (th1 - th2) -> (s1 * f - s2 * g) ^ 2 <= (r * e) ^ 2).
    { intros f g hf hg. apply pow_maj_Rabs. replace (s1 * f - s2 * g) with ((s1 - s2) * f + s2 * (f - g)) by ring.
      eapply Rle_trans; [ apply Rabs_triang | ].
      rewrite !Rabs_mult, (Rabs_pos_eq s2) by lra. assert (Rabs (s1 - s2) * Rabs f <= e * 1) by (apply Rmult_le_compat; auto using Rabs_pos).
      assert (s2 * Rabs (f - g) <= 2 * reach N * e) by (apply Rmult_le_compat; try lra; apply Rabs_pos). unfold r. lra. }
    unfold apart. pose proof (one (cos th1) (cos th2) ltac:(apply Rabs_le, COS_bound) (cos_near th1 th2)).
    pose proof (one (sin th1) (sin th2) ltac:(apply Rabs_le, SIN_bound) (sin_near th1 th2)). lra. }
  assert (e2 : 0 <= e ^ 2) by apply pow2_ge_0. assert (all : (C + 1) * apart s1 th1 s2 th2 <= (Q * e) ^ 2).
  { apply Rle_trans with ((C + 1) * (2 * (r * e) ^ 2)). apply Rmult_le_compat_l; lra. replace ((Q * e) ^ 2) with (Q * Q * e ^ 2) by ring.
    apply Rle_trans with (Q * e ^ 2). unfold Q. nra. nra. }
  assert (d0 : 0 <= apart s1 th1 s2 th2) by (unfold apart; pose proof (pow2_ge_0 (s1 * cos th1 - s2 * cos th2));
    pose proof (pow2_ge_0 (s1 * sin th1 - s2 * sin th2)); lra).
  assert (Qe : 0 <= Q * e) by nra.
  assert (B : forall i, Rabs (q i - z2 i) <= Q * e).
  { pose proof (pow2_ge_0 (q px - z2 px)). pose proof (pow2_ge_0 (q py - z2 py)). pose proof (pow2_ge_0 (q pu - z2 pu)).
    pose proof (pow2_ge_0 (q pw - z2 pw)).
    intros []; apply abs_of_sq; lra. }
  intros i. replace (z1 i - z2 i) with ((z1 i - q i) + (q i - z2 i)) by ring. eapply Rle_trans; [ apply Rabs_triang | ].
  specialize (near i). specialize (B i). rewrite Rabs_pos_eq in hT by lra.
    assert (fastest N * (T1 - T2) <= fastest N * e) by (apply Rmult_le_compat_l; lra). lra.
Qed.
(* and nearer than that to the axis *)
Lemma close_in N e s1 th1 T1 z1 x1 y1 u1 w1 s2 th2 T2 z2 x2 y2 u2 w2 : 0 < N -> (forall i, Rabs (z1 i) <= N) ->
  (forall i, Rabs (z2 i) <= N) -> straight s1 th1 T1 z1 x1 y1 u1 w1 -> straight s2 th2 T2 z2 x2 y2 u2 w2 -> T2 <= T1 -> s1 <= e -> s2 <= e ->
  Rabs (T1 - T2) <= e -> Rabs (z1 pu - z2 pu) <= e -> Rabs (z1 pw - z2 pw) <= e -> forall i, Rabs (z1 i - z2 i) <= (3 * fastest N + 5) * e.
Proof.
  intros HN b1 b2 I1 I2 HT l1 l2 hT hu hw. destruct (meet N _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN b1 b2 I1 I2 HT) as (q & near & D & _).
  pose proof (i_s _ _ _ _ _ _ _ _ I1) as s10. pose proof (i_s _ _ _ _ _ _ _ _ I2) as s20.
    assert (R0 : 0 <= fastest N) by (unfold fastest, reach; nra).
  set (f := fastest N) in *. rewrite Rabs_pos_eq in hT by lra. assert (fe : f * (T1 - T2) <= f * e) by (apply Rmult_le_compat_l; lra).
  assert (fe0 : 0 <= f * e) by (apply Rmult_le_pos; lra). set (v := (f + 1) * e). assert (v0 : 0 <= v) by (unfold v; lra).
  assert (d : apart s1 th1 s2 th2 <= 8 * e ^ 2).
  { assert (one : forall f g, Rabs f <= 1 -> Rabs g <= 1 -> (s1 * f - s2 * g) ^ 2 <= (2 * e) ^ 2).
    { intros a b ha hb. apply Rabs_le_between in ha, hb. apply pow_maj_Rabs, Rabs_le. nra. }
    unfold apart. pose proof (one (cos th1) (cos th2) ltac:(apply Rabs_le, COS_bound) ltac:(apply Rabs_le, COS_bound)).
    pose proof (one (sin th1) (sin th2) ltac:(apply Rabs_le, SIN_bound) ltac:(apply Rabs_le, SIN_bound)). lra. }
  assert (uw : forall i, Rabs (z1 i - z2 i) <= e -> (q i - z2 i) ^ 2 <= v ^ 2).
  { intros i h. specialize (near i). apply pow_maj_Rabs. apply Rabs_le_between in near, h. apply Rabs_le. unfold v. lra. }
  pose proof (uw pu hu) as k1. pose proof (uw pw hw) as k2. pose proof (pow2_ge_0 (q px - z2 px)). pose proof (pow2_ge_0 (q py - z2 py)).
  assert (B : forall i, i = px \/ i = py -> Rabs (q i - z2 i) <= 2 * v + 3 * e).
  { intros i Hi. apply abs_of_sq. lra. apply Rle_trans with (2 * v ^ 2 + 8 * e ^ 2). destruct Hi as [-> | ->]; lra. nra. }
  assert (P : forall i, i = px \/ i = py -> Rabs (z1 i - z2 i) <= (3 * f + 5) * e).
  { intros i Hi. specialize (B i Hi). specialize (near i). apply Rabs_le_between in B, near. unfold v in B. apply Rabs_le. lra. }
  intros []; auto; lra.
Qed.

(* the particle slips from the start z on until it is at rest, and comes straight in: psi, the angle of its position with respect to its velocity,
   tends to pi in size
   «the starts from which the particle slips until it is at rest, and comes straight in then, $|\psi|\to\pi$» *)
Definition straight_starts (z : place -> R) : Prop := exists x y u w psi T, spin x y u w /\ x 0 = z px /\ y 0 = z py /\ u 0 = z pu /\ w 0 = z pw /\
  0 < T /\ nrm (u T) (w T) = 0 /\ (forall t, 0 <= t < T -> 0 < nrm (u t) (w t) /\ position_angle (x t) (y t) (u t) (w t) (psi t)) /\
  left_lim (fun t => Rabs (psi t)) T PI.
(* «the start of $(x,y)$ with the velocity $(u,w)$» *)
Definition start_of (x y u w : R -> R) (i : place) : R := match i with px => x 0 | py => y 0 | pu => u 0 | pw => w 0 end.
Lemma straight_of z : straight_starts z -> exists s th T x y u w, Rabs th <= 4 /\ straight s th T z x y u w.
Proof.
  intros (x & y & u & w & psi & T & S & e1 & e2 & e3 & e4 & T0 & z0 & K & L). set (s := nrm (x T) (y T)). pose proof (nrm_pos (x T) (y T)) as s0.
    fold s in s0.
  assert (A : exists th, Rabs th <= 4 /\ x T = s * cos th /\ y T = s * sin th).
  { destruct (Rle_lt_or_eq_dec 0 s s0) as [p | z1].
    - destruct (angle_of (x T / s) (y T / s)) as (th & H & c1 & c2).
      { replace ((x T / s) ^ 2 + (y T / s) ^ 2) with ((x T ^ 2 + y T ^ 2) / s ^ 2) by (field; lra). rewrite <- nrm_sq. fold s. field. lra. }
      exists th. rewrite <- c1, <- c2. repeat split; trivial; field; lra.
    - exists 0. destruct (nrm_zero (x T) (y T)) as [-> ->]. now symmetry. rewrite Rabs_R0, <- z1. repeat split; lra. }
  destruct A as (th & H & c1 & c2). destruct (nrm_zero _ _ z0) as [u0 w0]. exists s, th, T, x, y, u, w. split; trivial. split; auto.
  intros t Ht. destruct (K t Ht) as [p0 _]. split; trivial.
  assert (lx : left_lim (fun t => - ((x t * u t + y t * w t) * / nrm (u t) (w t))) T s).
  { assert (lr : left_lim (fun t => nrm (x t) (y t)) T s) by (apply (ll_cont (fun t => nrm (x t) (y t))); cont;
    first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) ]; lra).
    pose proof (ll_comp cos _ _ _ L (continuity_cos PI)) as lc. rewrite cos_PI in lc. cbv beta in lc.
    eapply ll_eq. eapply ll_soon. 2: exact (ll_opp _ _ _ (ll_mult _ _ _ _ _ lr lc)). 2: ring.
    apply (soon_after 0 T _ T0). intros r Hr. destruct (K r Hr) as [q P]. apply angle_iff in P as [P _]. rewrite P. cbv beta.
    replace (cos (Rabs (psi r))) with (cos (psi r)). field. lra. unfold Rabs. destruct (Rcase_abs (psi r)); [ now rewrite cos_neg | trivial ]. }
  enough (s <= - ((x t * u t + y t * w t) * / nrm (u t) (w t))) by lra. apply (ll_le _ T s t _ lx); [ lra | ]. intros r Hr.
  apply Ropp_le_contravar. apply (xi_never_falls x y u w S t r); [ lra | ]. intros v Hv. apply K. lra.
Qed.
Theorem straight_thin : no_volume straight_starts.
Proof.
  intros N eps HN He. assert (rN : 0 < reach N) by (unfold reach; nra). assert (R0 : 0 <= fastest N) by (unfold fastest, reach; nra).
  destruct (fine_enough (2 * N + 1) (3 * fastest N + 5) (eps / 2)) as (n & Hn & V); try lra. pose proof (lt_0_INR n Hn) as n0.
  set (e := 2 * ((2 * N + 1) / INR n)) in *. assert (e0 : 0 < e) by (unfold e; assert (0 < (2 * N + 1) / INR n) by (apply Rdiv_lt_0_compat; lra);
    lra).
  destruct (grid (2 * N + 1) n ((3 * fastest N + 5) * e) (fun z a b c => exists s th x y u w, straight s th a z x y u w /\ s <= e /\ (forall i, Rabs
    (z i) <= N) /\ z pu = b /\ z pw = c))
    as (l & Hl & H); [ lra | trivial | fold e | ].
  { intros z a b c z' a' b' c' (s & th & x & y & u & w & I & hs & B & <- & <-) (s' & th' & x' & y' & u' & w' & I' & hs' & B' & <- & <-) h1 h2 h3.
    destruct (Rle_lt_dec a' a) as [k | k]; [ exact (close_in N e _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN B B' I I' k hs hs' h1 h2 h3) | ].
    rewrite Rabs_minus_sym in h1, h2, h3. intros i. rewrite Rabs_minus_sym. revert i.
    exact (close_in N e _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN B' B I' I ltac:(lra) hs' hs h1 h2 h3). }
  destruct (close_out N e HN e0) as (k2 & k20 & C). set (M := 5 + 2 * reach N + 2 * N).
  destruct (fine_enough M k2 (eps / 2)) as (m & Hm & V2); try (unfold M; lra). set (d := 2 * (M / INR m)) in *.
  destruct (grid M m (k2 * d) (fun z a b c => exists x y u w, straight a b c z x y u w /\ e <= a /\ (forall i, Rabs (z i) <= N)))
    as (l2 & Hl2 & H2); [ unfold M; lra | trivial | fold d | ].
  { intros z a b c z' a' b' c' (x & y & u & w & I & hs & B) (x' & y' & u' & w' & I' & hs' & B') h1 h2 h3.
    destruct (Rle_lt_dec c' c) as [k | k]; [ exact (C d _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ B B' I I' k hs hs' h1 h2 h3) | ].
    rewrite Rabs_minus_sym in h1, h2, h3. intros i. rewrite Rabs_minus_sym. revert i.
    exact (C d _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ B' B I' I ltac:(lra) hs' hs h1 h2 h3). }
  exists (map (fun c => (c, (3 * fastest N + 5) * e)) l ++ map (fun c => (c, k2 * d)) l2). rewrite volume_app. split. { pose proof (V l Hl).
    pose proof (V2 l2 Hl2). apply Rle_trans with (eps / 2 + eps / 2); [ | lra ].
    apply Rplus_le_compat; trivial. }
  intros z Hz B. destruct (straight_of z Hz) as (s & th & T & x & y & u & w & h4 & I).
  pose proof (T_le _ _ _ _ _ _ _ _ N I B). pose proof (i_T _ _ _ _ _ _ _ _ I). pose proof (i_s _ _ _ _ _ _ _ _ I).
    pose proof (s_le _ _ _ _ _ _ _ _ N I HN B).
  pose proof (B pu). pose proof (B pw). destruct (Rle_lt_dec s e) as [k | k].
  - destruct (covered l ((3 * fastest N + 5) * e) z) as (c & h & i & q).
    { apply (H z T (z pu) (z pw)); [ exists s, th, x, y, u, w; auto | rewrite Rabs_pos_eq by lra | | ]; lra. }
    exists c, h. split; trivial. apply in_or_app. now left.
  - destruct (covered l2 (k2 * d) z) as (c & h & i & q).
    { apply (H2 z s th T); [ exists x, y, u, w; repeat split; auto; try apply I; lra | rewrite Rabs_pos_eq by lra; unfold M; lra | unfold M;
      lra | rewrite Rabs_pos_eq by lra; unfold M; lra ]. }
    exists c, h. split; trivial. apply in_or_app. now right.
Qed.
