(* Lemmas on the motion under a constant pull: while it slips, speed + vx and speed - vx change at (1 - lambda) A and -(1 + lambda) A times themselves
   over the speed; when it stops; how the two are tied (the logarithm of (10)); what happens at large times. No angle is used. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas.
From Slipbook.General Require Import Rates Contraction Exists Straight.
Open Scope R_scope.

(* a motion under the constant pull of (3), friction lambda A (in A's unit, an acceleration): (5) *)
Definition pulled A lam vx vy := motion (A * lam) (fun _ => eq3_acceleration_1 A) (fun _ => eq3_acceleration_2 A) vx vy.

(* what is not negative and falls at no more than K times itself stays positive *)
Lemma stays_positive f K t : 0 <= t -> (forall s, 0 < s <= t -> continuity_pt f s) -> (forall s, 0 <= s < t -> exists l, rder f s l /\ - K * f s <= l) -> 0 < f 0 -> 0 < f t.
Proof.
  intros Ht C D P. enough (E : - (f t * exp (K * t)) <= - (f 0 * exp (K * 0))).
  { rewrite Rmult_0_r, exp_0 in E. pose proof (exp_pos (K * t)). nra. }
  apply (rder_decr (fun t => - (f t * exp (K * t)))); trivial; intros s Hs. specialize (C s Hs). cont.
  destruct (D s Hs) as (l & L & b). eexists. split. rd. cbv beta. pose proof (exp_pos (K * s)). nra.
Qed.

Section Pull.
Variables (A lam : R) (vx vy : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : pulled A lam vx vy.
Notation v t := (nrm (vx t) (vy t)).
Lemma hk : 0 <= A * lam. Proof. apply Rmult_le_pos; lra. Qed.
Lemma cx t : 0 < t -> continuity_pt vx t. Proof. apply (m_cx _ _ _ _ _ M). Qed.
Lemma cy t : 0 < t -> continuity_pt vy t. Proof. apply (m_cy _ _ _ _ _ M). Qed.
Lemma cv t : 0 < t -> continuity_pt (fun s => v s) t. Proof. apply (speed_cont _ _ _ _ _ M). Qed.
Lemma pull_rates t : 0 <= t -> v t <> 0 -> rder vx t (A - A * lam * (vx t / v t)) /\ rder vy t (- A * lam * (vy t / v t)) /\
  rder (fun s => v s) t (A * (vx t / v t) - A * lam).
Proof.
  intros Ht N. destruct (slip_rates _ _ _ _ _ hk M t Ht N) as [X Y]. pose proof (speed_rate _ _ _ _ _ hk M t Ht N) as S.
  unfold eq3_acceleration_1, eq3_acceleration_2 in *. split; [ | split ]; (eapply rder_eq; [ eassumption | ring ]).
Qed.
Lemma side_rates t : 0 <= t -> v t <> 0 -> rder (fun s => v s + vx s) t ((1 - lam) * A * ((v t + vx t) / v t)) /\
  rder (fun s => v s - vx s) t (- ((1 + lam) * A * ((v t - vx t) / v t))).
Proof.
  intros Ht N. destruct (pull_rates t Ht N) as (X & _ & S).
  split; eapply rder_eq; [ apply (rder_plus _ _ _ _ _ S X) | field; exact N | apply (rder_minus _ _ _ _ _ S X) | field; exact N ].
Qed.
Lemma sides t : 0 <= v t + vx t /\ 0 <= v t - vx t /\ (v t + vx t) * (v t - vx t) = vy t ^ 2.
Proof. destruct (abs_nrm (vx t) (vy t)) as [b _]. apply Rabs_le_between in b. pose proof (nrm_sq (vx t) (vy t)). repeat split; lra. Qed.
Lemma stays s t : 1 <= lam -> 0 <= s <= t -> v s = 0 -> v t = 0.
Proof.
  intros h Hs e. destruct (nrm_zero _ _ e) as [e1 e2]. destruct (rest_lasts _ _ _ _ _ s hk M ltac:(lra)) with (t := t) as [-> ->]; trivial; try lra; [ | apply nrm_0 ].
  intros _ _. apply nrm_le. apply hk. unfold eq3_acceleration_1, eq3_acceleration_2. assert (A * 1 <= A * lam) by (apply Rmult_le_compat_l; lra). nra.
Qed.
(* lambda speed + vx changes at a constant rate while it slips: (14) *)
Lemma moved t : 0 <= t -> (forall s, 0 <= s < t -> v s <> 0) -> lam * v t + vx t = lam * v 0 + vx 0 + (1 - lam ^ 2) * A * t.
Proof.
  intros Ht N. enough (lam * v t + vx t - (1 - lam ^ 2) * A * t = lam * v 0 + vx 0 - (1 - lam ^ 2) * A * 0) by lra.
  apply (rder_const (fun t => lam * v t + vx t - (1 - lam ^ 2) * A * t)); trivial; intros s Hs.
  - pose proof (cx s ltac:(lra)). pose proof (cy s ltac:(lra)). cont.
  - destruct (pull_rates s ltac:(lra) (N s Hs)) as (X & _ & S). eapply rder_eq.
    apply (rder_minus (fun t => lam * v t + vx t)); [ apply (rder_plus (fun t => lam * v t)); [ apply (rder_mult (fun _ => lam)); [ rd | exact S ] | exact X ] | rd ].
    cbv beta. field. exact (N s Hs).
Qed.

(* ---- lambda > 1: rest from T on, and not before ---- *)
Notation T := ((lam * v 0 + vx 0) / (A * (lam ^ 2 - 1))).
Section Strong.
Hypothesis h1 : 1 < lam.
Lemma hd : 0 < A * (lam ^ 2 - 1). Proof. apply Rmult_lt_0_compat; nra. Qed.
Lemma left_over t : 0 <= t -> v t <> 0 -> lam * v t + vx t = A * (lam ^ 2 - 1) * (T - t).
Proof.
  intros Ht N. rewrite (moved t Ht). pose proof hd. field. nra. intros s Hs e. apply N, (stays s t); lra.
Qed.
Lemma T_pos : 0 <= T.
Proof. apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat, hd ]. destruct (sides 0) as (a & b & _). pose proof (nrm_pos (vx 0) (vy 0)). nra. Qed.
Theorem rest_after t : T <= t -> v t = 0.
Proof.
  intros Ht. pose proof T_pos. destruct (Req_dec (v t) 0) as [z | z]; trivial. exfalso. pose proof (left_over t ltac:(lra) z) as e. pose proof hd.
  destruct (sides t) as (a & b & _). pose proof (nrm_pos (vx t) (vy t)). nra.
Qed.
(* lambda speed + vx + (lambda^2 - 1) A t never falls, at rest too *)
Theorem slip_before t : 0 <= t < T -> v t <> 0.
Proof.
  intros Ht e. pose proof hd as d.
  assert (E : - (lam * v t + vx t + A * (lam ^ 2 - 1) * t) <= - (lam * v 0 + vx 0 + A * (lam ^ 2 - 1) * 0)).
  { apply (rder_decr (fun t => - (lam * v t + vx t + A * (lam ^ 2 - 1) * t))); [ lra | | ]; intros s Hs.
    - pose proof (cx s ltac:(lra)). pose proof (cy s ltac:(lra)). cont.
    - destruct (Req_dec (v s) 0) as [z | z].
      + exists (- (A * (lam ^ 2 - 1))). split; [ | lra ]. apply (rder_ext _ (fun t => - (A * (lam ^ 2 - 1) * t)) s _ 1 Rlt_0_1).
        { intros r Hr. pose proof (stays s r ltac:(lra) ltac:(lra) z) as er. rewrite er. destruct (nrm_zero _ _ er) as [-> _]. ring. } eapply rder_eq. rd. ring.
      + destruct (pull_rates s ltac:(lra) z) as (X & _ & S). exists 0. split; [ | lra ]. eapply rder_eq.
        apply (rder_opp (fun t => lam * v t + vx t + A * (lam ^ 2 - 1) * t)), (rder_plus (fun t => lam * v t + vx t)); [ apply (rder_plus (fun t => lam * v t)); [ apply (rder_mult (fun _ => lam)); [ rd | exact S ] | exact X ] | rd ].
        cbv beta. field. exact z. }
  rewrite e in E. destruct (nrm_zero _ _ e) as [e1 _]. rewrite e1 in E.
  assert (A * (lam ^ 2 - 1) * t < lam * v 0 + vx 0); [ | lra ]. destruct Ht as [_ Ht]. apply Rlt_div_r in Ht; trivial. lra.
Qed.
End Strong.

(* ---- while it slips at an angle ---- *)
Lemma plus_rises s t : lam <= 1 -> 0 <= s <= t -> v s + vx s <= v t + vx t.
Proof.
  intros h Hs. apply Ropp_le_cancel, (rder_decr (fun t => - (v t + vx t))); [ lra | | ]; intros r Hr.
  - pose proof (cx r ltac:(lra)). pose proof (cy r ltac:(lra)). cont.
  - destruct (Req_dec (v r) 0) as [z | z].
    + destruct (rest_rates _ _ _ _ _ hk M r ltac:(lra) z) as (lx & ly & X & _ & N & _). eexists. split. apply (rder_opp (fun t => v t + vx t)), (rder_plus _ _ _ _ _ N X).
      destruct (abs_nrm lx ly) as [b _]. apply Rabs_le_between in b. lra.
    + destruct (side_rates r ltac:(lra) z) as [P _]. eexists. split. apply (rder_opp _ _ _ P). destruct (sides r) as (a & _). pose proof (nrm_pos (vx r) (vy r)).
      assert (0 <= (v r + vx r) / v r) by (apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ]; lra). assert (0 <= (1 - lam) * A) by (apply Rmult_le_pos; lra). nra.
Qed.
(* the speed has a lower bound *)
Lemma slip_above t : 0 <= t -> (forall s, 0 <= s <= t -> v s <> 0) -> 0 < v 0 + vx 0 -> exists m, 0 < m /\ forall s, 0 <= s <= t -> m <= v s.
Proof.
  intros Ht N C0. destruct (Rle_lt_dec lam 1) as [h | h].
  - exists ((v 0 + vx 0) / 2). split. lra. intros s Hs. pose proof (plus_rises 0 s h ltac:(lra)). destruct (sides s) as (_ & b & _). lra.
  - exists ((lam * v t + vx t) / (lam + 1)). pose proof (nrm_pos (vx t) (vy t)). pose proof (N t ltac:(lra)). destruct (sides t) as (a & _).
    split. apply Rdiv_lt_0_compat; nra. intros s Hs. apply Rle_div_l. lra. destruct (sides s) as (_ & b & _).
    assert (lam * v t + vx t <= lam * v s + vx s); [ | lra ]. pose proof (moved t Ht (fun r Hr => N r ltac:(lra))). pose proof (moved s (proj1 Hs) (fun r Hr => N r ltac:(lra))).
    assert (0 <= A * (lam ^ 2 - 1) * (t - s)) by (apply Rmult_le_pos; [ left; exact (hd h) | lra ]). lra.
Qed.
Section Turn.
Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis slips : forall s, 0 <= s <= t -> v s <> 0.
Lemma plus_positive : 0 < v 0 + vx 0 -> 0 < v t + vx t.
Proof.
  intros C0. destruct (slip_above t ht slips C0) as (m & m0 & Hm). apply (stays_positive (fun s => v s + vx s) (lam * A / m)); trivial; intros s Hs.
  - pose proof (cx s ltac:(lra)). pose proof (cy s ltac:(lra)). cont.
  - destruct (side_rates s ltac:(lra) (slips s ltac:(lra))) as [P _]. eexists. split. exact P. specialize (Hm s ltac:(lra)). destruct (sides s) as (a & _).
    replace ((v s + vx s) / v s) with ((v s + vx s) * / v s) by reflexivity. assert (i : 0 < / v s <= / m) by (split; [ apply Rinv_0_lt_compat | apply Rinv_le_contravar ]; lra).
    assert ((v s + vx s) * / v s <= (v s + vx s) * / m) by (apply Rmult_le_compat_l; lra). assert (0 <= (v s + vx s) * / v s) by (apply Rmult_le_pos; lra).
    pose proof hk. set (c := (v s + vx s) * / v s) in *. unfold Rdiv. assert (A * lam * c <= A * lam * ((v s + vx s) * / m)) by (apply Rmult_le_compat_l; lra). nra.
Qed.
Lemma minus_positive : 0 < v 0 + vx 0 -> 0 < v 0 - vx 0 -> 0 < v t - vx t.
Proof.
  intros C0 S0. destruct (slip_above t ht slips C0) as (m & m0 & Hm). apply (stays_positive (fun s => v s - vx s) ((1 + lam) * A / m)); trivial; intros s Hs.
  - pose proof (cx s ltac:(lra)). pose proof (cy s ltac:(lra)). cont.
  - destruct (side_rates s ltac:(lra) (slips s ltac:(lra))) as [_ P]. eexists. split. exact P. specialize (Hm s ltac:(lra)). destruct (sides s) as (_ & b & _).
    assert (i : / v s <= / m) by (apply Rinv_le_contravar; lra). assert ((v s - vx s) * / v s <= (v s - vx s) * / m) by (apply Rmult_le_compat_l; lra).
    assert (0 <= (1 + lam) * A) by (apply Rmult_le_pos; lra). unfold Rdiv. set (c := (v s - vx s) * / v s) in *.
    assert ((1 + lam) * A * c <= (1 + lam) * A * ((v s - vx s) * / m)) by (apply Rmult_le_compat_l; lra). lra.
Qed.
End Turn.
(* (10), in logarithms *)
Lemma law10 t : 0 <= t -> (forall s, 0 <= s <= t -> v s <> 0) -> 0 < v 0 + vx 0 -> 0 < v 0 - vx 0 ->
  (1 + lam) * ln (v t + vx t) + (1 - lam) * ln (v t - vx t) = (1 + lam) * ln (v 0 + vx 0) + (1 - lam) * ln (v 0 - vx 0).
Proof.
  intros Ht N C0 S0. assert (P : forall s, 0 <= s <= t -> 0 < v s + vx s /\ 0 < v s - vx s).
  { intros s Hs. split; [ apply plus_positive | apply minus_positive ]; trivial; try lra; intros; apply N; lra. }
  apply (rder_const (fun t => (1 + lam) * ln (v t + vx t) + (1 - lam) * ln (v t - vx t))); trivial; intros s Hs; destruct (P s ltac:(lra)) as [p1 p2].
  - pose proof (cx s ltac:(lra)). pose proof (cy s ltac:(lra)). cont; trivial.
  - destruct (side_rates s ltac:(lra) (N s ltac:(lra))) as [X Y]. eapply rder_eq.
    apply (rder_plus (fun t => (1 + lam) * ln (v t + vx t))); [ apply (rder_mult (fun _ => 1 + lam)); [ rd | apply (rder_ln _ _ _ X p1) ]
      | apply (rder_mult (fun _ => 1 - lam)); [ rd | apply (rder_ln _ _ _ Y p2) ] ].
    cbv beta. field. pose proof (N s ltac:(lra)). repeat split; lra.
Qed.
(* the same as a power: vy / (speed + vx) is the tangent of half the angle *)
Lemma power_law t : 0 <= t -> (forall s, 0 <= s <= t -> v s <> 0) -> vy 0 <> 0 ->
  let r := vy t / (v t + vx t) / (vy 0 / (v 0 + vx 0)) in
  0 < v 0 + vx 0 /\ 0 < v t + vx t /\ 0 < v t - vx t /\ 0 < vy t * vy 0 /\ 0 < r /\ vy t / vy 0 = Rpower r lam.
Proof.
  intros Ht N Y r. assert (y2 : 0 < vy 0 ^ 2) by (destruct (Rdichotomy _ _ Y); nra). destruct (sides 0) as (a & b & e).
  assert (C0 : 0 < v 0 + vx 0) by nra. assert (S0 : 0 < v 0 - vx 0) by nra.
  pose proof (plus_positive t Ht N C0) as Ct. pose proof (minus_positive t Ht N C0 S0) as St.
  assert (P : 0 < vy t * vy 0).
  { destruct (pull_rates 0 (Rle_refl 0) (N 0 ltac:(lra))) as (_ & D & _).
    apply (keeps_sign (fun s => vy s * vy 0) (- A * lam * (vy 0 / v 0) * vy 0)); trivial; try nra.
    - intros s Hs. pose proof (cy s ltac:(lra)). cont.
    - eapply rder_eq. rd. ring.
    - intros s Hs z. destruct (sides s) as (_ & _ & es). assert (0 < v s + vx s) by (apply plus_positive; trivial; try lra; intros; apply N; lra).
      assert (0 < v s - vx s) by (apply minus_positive; trivial; try lra; intros; apply N; lra). assert (vy s = 0) by (apply (Rmult_eq_reg_r (vy 0)); lra). nra. }
  assert (q0 : 0 < vy t / vy 0). { replace (vy t / vy 0) with (vy t * vy 0 / vy 0 ^ 2) by (field; trivial). now apply Rdiv_lt_0_compat. }
  assert (er : r = vy t / vy 0 * ((v 0 + vx 0) / (v t + vx t))) by (unfold r; field; repeat split; trivial; lra).
  assert (r0 : 0 < r). { rewrite er. apply Rmult_lt_0_compat; trivial. now apply Rdiv_lt_0_compat. } repeat split; trivial.
  unfold Rpower. rewrite <- (exp_ln (vy t / vy 0)) by trivial. f_equal. rewrite er, ln_mult, (ln_div (v 0 + vx 0)) by (trivial; now apply Rdiv_lt_0_compat).
  assert (L : 2 * ln (vy t / vy 0) = ln (v t + vx t) + ln (v t - vx t) - (ln (v 0 + vx 0) + ln (v 0 - vx 0))).
  { replace (2 * ln (vy t / vy 0)) with (ln (vy t / vy 0) + ln (vy t / vy 0)) by ring. rewrite <- !ln_mult, <- ln_div by (trivial; nra). f_equal.
    destruct (sides t) as (_ & _ & et). rewrite et, e. field. trivial. }
  pose proof (law10 t Ht N C0 S0). apply (Rmult_eq_compat_l (1 - lam)) in L. lra.
Qed.

(* ---- lambda <= 1: at large times ---- *)
Lemma forward_grows s t : 0 <= s <= t -> vx s + A * (1 - lam) * (t - s) <= vx t.
Proof.
  intros Hs. enough (- vx t + A * (1 - lam) * t <= - vx s + A * (1 - lam) * s) by lra. apply (rder_decr (fun t => - vx t + A * (1 - lam) * t)); [ lra | | ]; intros r Hr.
  - pose proof (cx r ltac:(lra)). cont.
  - destruct (m_law _ _ _ _ _ M r ltac:(lra)) as (fx & fy & [B _] & X & _). unfold eq3_acceleration_1 in X. eexists. split. rd.
    pose proof hk. assert (- (A * lam) <= fx) by (pose proof (pow2_ge_0 fy); nra). lra.
Qed.
Lemma across_smaller s t : 0 <= s <= t -> vy t ^ 2 <= vy s ^ 2.
Proof. exact (across_falls (A * lam) (fun _ => - A) vx vy hk M s t). Qed.
End Pull.

Section Critical.
Variables (A : R) (vx vy : R -> R).
Hypothesis hA : 0 < A.
Hypothesis M : pulled A 1 vx vy.
Notation v t := (nrm (vx t) (vy t)).
Lemma plus_stays t : 0 <= t -> v t + vx t = v 0 + vx 0.
Proof.
  intros Ht. apply Rle_antisym; [ | apply (plus_rises A 1 vx vy hA Rle_0_1 M); lra ]. apply (rder_decr (fun t => v t + vx t)); trivial; intros s Hs.
  - pose proof (cx A 1 vx vy M s ltac:(lra)). pose proof (cy A 1 vx vy M s ltac:(lra)). cont.
  - exists 0. split; [ | lra ]. destruct (Req_dec (v s) 0) as [z | z].
    + apply (rder_ext _ (fun _ => 0) s _ 1 Rlt_0_1); [ | rd ]. intros r Hr. pose proof (stays A 1 vx vy hA Rle_0_1 M s r ltac:(lra) ltac:(lra) z) as er. rewrite er.
      destruct (nrm_zero _ _ er) as [-> _]. ring.
    + eapply rder_eq. apply (proj1 (side_rates A 1 vx vy hA Rle_0_1 M s ltac:(lra) z)). field. exact z.
Qed.
(* not at rest, nor straight against the pull *)
Section Moves.
Hypothesis hC : 0 < v 0 + vx 0.
Notation C := (v 0 + vx 0).
Lemma moves t : 0 <= t -> 0 < v t /\ v t = (C + vy t ^ 2 / C) / 2.
Proof.
  intros Ht. pose proof (plus_stays t Ht) as e. destruct (sides vx vy t) as (_ & _ & p). rewrite e in p.
  assert (E : v t = (C + vy t ^ 2 / C) / 2). { rewrite <- p. replace (C * (v t - vx t) / C) with (v t - vx t) by (field; lra). lra. } split; trivial.
  rewrite E. assert (0 <= vy t ^ 2 / C) by (apply Rmult_le_pos; [ apply pow2_ge_0 | left; now apply Rinv_0_lt_compat ]). lra.
Qed.
Theorem across_falls_exp t : 0 <= t -> vy t ^ 2 * exp (2 * A / v 0 * t) <= vy 0 ^ 2.
Proof.
  intros Ht. destruct (moves 0 (Rle_refl 0)) as [b0 b1]. replace (vy 0 ^ 2) with (vy 0 ^ 2 * exp (2 * A / v 0 * 0)) by (rewrite Rmult_0_r, exp_0; ring).
  apply (rder_decr (fun t => vy t ^ 2 * exp (2 * A / v 0 * t))); trivial; intros s Hs. { pose proof (cy A 1 vx vy M s ltac:(lra)). cont. }
  destruct (moves s ltac:(lra)) as [n0 n1]. destruct (pull_rates A 1 vx vy hA Rle_0_1 M s ltac:(lra) ltac:(lra)) as (_ & Y & _).
  eexists. split. rd. cbv beta. set (E := exp _). assert (0 < E) by apply exp_pos. pose proof (across_smaller A 1 vx vy hA Rle_0_1 M 0 s ltac:(lra)) as F.
  assert (nB : v s <= v 0). { assert (vy s ^ 2 / C <= vy 0 ^ 2 / C) by (apply Rmult_le_compat_r; [ left; now apply Rinv_0_lt_compat | exact F ]). lra. }
  set (n := v s) in *. set (B := v 0) in *. assert (K : / B <= / n) by (apply Rinv_le_contravar; lra). pose proof (pow2_ge_0 (vy s)).
  match goal with |- ?g <= 0 => replace g with (2 * A * E * vy s ^ 2 * (/ B - / n)) by (simpl; field; lra) end.
  assert (0 <= 2 * A * E * vy s ^ 2) by (apply Rmult_le_pos; [ nra | trivial ]). nra.
Qed.
Lemma moves_late : is_lim vy p_infty 0 /\ is_lim vx p_infty (C / 2).
Proof.
  destruct (moves 0 (Rle_refl 0)) as [b0 _]. assert (h : 0 < 2 * A / v 0) by (apply Rdiv_lt_0_compat; lra). assert (G := fun K => grows_exp (2 * A / v 0) K h). split.
  - apply (lim_of_bound vy (vy 0 ^ 2) (fun t => exp (2 * A / v 0 * t))); [ apply pow2_ge_0 | exact across_falls_exp | exact G ].
  - assert (L : is_lim (fun t => vx t - C / 2) p_infty 0).
    { apply (lim_of_bound _ ((vy 0 ^ 2) ^ 2 / (4 * C ^ 2)) (fun t => exp (2 * A / v 0 * t))); [ | | exact G ].
      - apply Rmult_le_pos; [ apply pow2_ge_0 | left; apply Rinv_0_lt_compat; nra ].
      - intros t Ht. destruct (moves t Ht) as [n0 n1]. pose proof (plus_stays t Ht) as e. pose proof (across_falls_exp t Ht) as r. pose proof (across_smaller A 1 vx vy hA Rle_0_1 M 0 t ltac:(lra)) as F.
        set (E := exp (2 * A / v 0 * t)) in *. replace (vx t - C / 2) with (- (vy t ^ 2 / (2 * C))) by (replace (vx t) with (C - v t) by lra; rewrite n1; field; lra).
        replace ((- (vy t ^ 2 / (2 * C))) ^ 2 * E) with (vy t ^ 2 * (vy t ^ 2 * E) / (4 * C ^ 2)) by (field; lra).
        apply Rmult_le_compat_r; [ left; apply Rinv_0_lt_compat; nra | ]. pose proof (pow2_ge_0 (vy t)). assert (0 < E) by apply exp_pos. simpl in *. nra. }
    replace (C / 2) with (0 + C / 2) by ring. apply (is_lim_ext (fun t => vx t - C / 2 + C / 2)); [ intros; ring | ].
    apply (is_lim_plus' _ (fun _ => C / 2)); [ exact L | apply is_lim_const ].
Qed.
End Moves.
(* straight against the pull: it stops, and stays *)
Lemma straight_stops t : v 0 + vx 0 = 0 -> 0 <= t -> v 0 / (2 * A) < t -> v t = 0.
Proof.
  intros z Ht Hs. destruct (Req_dec (v t) 0) as [e | N]; trivial. exfalso. apply Rlt_div_l in Hs; [ | lra ]. pose proof (plus_stays t Ht) as e.
  assert (K : v t + 2 * A * t <= v 0 + 2 * A * 0).
  { apply (rder_decr (fun t => v t + 2 * A * t)); trivial; intros s H.
    - pose proof (cx A 1 vx vy M s ltac:(lra)). pose proof (cy A 1 vx vy M s ltac:(lra)). cont.
    - assert (Ns : v s <> 0) by (intros q; apply N, (stays A 1 vx vy hA Rle_0_1 M s t); lra). destruct (pull_rates A 1 vx vy hA Rle_0_1 M s ltac:(lra) Ns) as (_ & _ & S).
      eexists. split. apply (rder_plus (fun t => v t)); [ exact S | rd ]. pose proof (plus_stays s ltac:(lra)) as es.
      assert (q : vx s / v s = - (1)) by (apply (Rmult_eq_reg_r (v s)); trivial; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by trivial; lra). rewrite q. lra. }
  pose proof (nrm_pos (vx t) (vy t)). lra.
Qed.
Theorem critical_late : is_lim vy p_infty 0 /\ is_lim vx p_infty ((v 0 + vx 0) / 2).
Proof.
  destruct (sides vx vy 0) as ([p | z] & _). now apply moves_late.
  assert (R : forall f : R -> R, (forall t, v t = 0 -> f t = 0) -> is_lim f p_infty 0).
  { intros f Hf. apply is_lim_spec. intros eps. exists (Rmax 0 (v 0 / (2 * A))). intros t Ht. pose proof (Rmax_l 0 (v 0 / (2 * A))). pose proof (Rmax_r 0 (v 0 / (2 * A))).
    rewrite (Hf t), Rminus_0_r, Rabs_R0. apply cond_pos. apply straight_stops; lra. }
  rewrite <- z. replace (0 / 2) with 0 by field. split; apply R; intros t e; now destruct (nrm_zero _ _ e).
Qed.
End Critical.

(* lambda <= 1, but for lambda = 1 from rest or straight against the pull: the velocity turns into the x-axis *)
Theorem turns_forward A lam vx vy : 0 < A -> 0 <= lam <= 1 -> pulled A lam vx vy -> (lam < 1 \/ 0 < nrm (vx 0) (vy 0) + vx 0) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> 0 < vx t /\ Rabs (vy t) <= e * vx t.
Proof.
  intros hA hl M h e He. assert (small : forall t, 0 <= t -> Rabs (vy t) <= Rabs (vy 0)).
  { intros t Ht. apply Rsqr_le_abs_0. unfold Rsqr. pose proof (across_smaller A lam vx vy hA (proj1 hl) M 0 t ltac:(lra)). lra. }
  destruct (Rlt_le_dec lam 1) as [l1 | l1].
  - assert (g : 0 < A * (1 - lam)) by (apply Rmult_lt_0_compat; lra). destruct (grows_line _ (vx 0) (Rabs (vy 0) / e + 1) g) as (T & T0 & HT). exists T. split; trivial.
    intros t Ht. specialize (HT t Ht). pose proof (forward_grows A lam vx vy hA (proj1 hl) M 0 t ltac:(lra)). pose proof (Rabs_pos (vy 0)). specialize (small t ltac:(lra)).
    assert (Rabs (vy 0) / e <= vx t) by lra. assert (0 <= Rabs (vy 0) / e) by (apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ]; trivial).
    split. lra. apply Rle_div_l in H1; lra.
  - assert (lam = 1) as -> by lra. assert (C0 : 0 < nrm (vx 0) (vy 0) + vx 0) by lra. destruct (moves_late A vx vy hA M C0) as [L _]. set (C := nrm (vx 0) (vy 0) + vx 0) in *.
    apply is_lim_spec in L. set (q := Rmin (C / 2) (e * C / 4)). assert (q0 : 0 < q) by (unfold q; apply Rmin_pos; nra). destruct (L (mkposreal q q0)) as [T HT].
    exists (Rmax 0 T + 1). pose proof (Rmax_l 0 T). pose proof (Rmax_r 0 T). split. lra. intros t Ht. specialize (HT t ltac:(lra)). simpl in HT. rewrite Rminus_0_r in HT.
    destruct (moves A vx vy hA M C0 t ltac:(lra)) as [_ n]. pose proof (plus_stays A vx vy hA M t ltac:(lra)) as s. fold C in n, s.
    pose proof (Rmin_l (C / 2) (e * C / 4)) as m1. pose proof (Rmin_r (C / 2) (e * C / 4)) as m2. fold q in m1, m2.
    assert (y2 : vy t ^ 2 <= C ^ 2 / 4). { rewrite <- pow2_abs. replace (C ^ 2 / 4) with ((C / 2) ^ 2) by field. apply pow_incr. pose proof (Rabs_pos (vy t)). lra. }
    assert (vy t ^ 2 / C <= C / 4) by (apply Rle_div_l; lra). assert (C / 4 <= vx t) by lra. split. lra. assert (e * (C / 4) <= e * vx t) by (apply Rmult_le_compat_l; lra). lra.
Qed.
(* lambda > 1: the velocity turns into the x-axis before it stops, but for a start straight against the pull *)
Theorem turns_before_stop A lam vx vy : 0 < A -> 1 < lam -> pulled A lam vx vy -> 0 < nrm (vx 0) (vy 0) + vx 0 ->
  let T := (lam * nrm (vx 0) (vy 0) + vx 0) / (A * (lam ^ 2 - 1)) in
  forall e, 0 < e -> exists d, 0 < d /\ forall t, 0 <= t < T -> T - d < t -> 0 < vx t /\ Rabs (vy t) <= e * vx t.
Proof.
  intros hA h1 M C0 T e He. assert (hl : 0 <= lam) by lra. set (v t := nrm (vx t) (vy t)). fold (v 0) in C0, T.
  assert (slips : forall t, 0 <= t < T -> forall s, 0 <= s <= t -> v s <> 0).
  { intros t Ht s Hs. apply (slip_before A lam vx vy hA hl M h1 s). fold (v 0) T. lra. }
  assert (Cp : forall t, 0 <= t < T -> 0 < v t + vx t) by (intros t Ht; apply (plus_positive A lam vx vy hA hl M t); trivial; [ lra | apply (slips t Ht) ]).
  destruct (sides vx vy 0) as (_ & [S0 | z] & _); fold (v 0) in *.
  - set (q := Rmin (1 / 2) (e ^ 2 / 16)). assert (q0 : 0 < q) by (apply Rmin_pos; nra). pose proof (Rmin_l (1 / 2) (e ^ 2 / 16)) as q1. pose proof (Rmin_r (1 / 2) (e ^ 2 / 16)) as q2. fold q in q1, q2.
    set (K := (1 + lam) * ln (v 0 + vx 0) + (1 - lam) * ln (v 0 - vx 0)). set (c := exp ((K + (lam - 1) * ln q) / 2)).
    assert (c0 : 0 < c) by apply exp_pos. assert (g0 : 0 < 2 * A * (lam + 1)) by nra. exists (c / (2 * A * (lam + 1))). split. now apply Rdiv_lt_0_compat.
    intros t Ht Hd. specialize (slips t Ht). specialize (Cp t Ht). pose proof (minus_positive A lam vx vy hA hl M t ltac:(lra) slips C0 S0) as Sp. fold (v t) in Sp.
    pose proof (law10 A lam vx vy hA hl M t ltac:(lra) slips C0 S0) as L. fold (v t) (v 0) in L. fold K in L.
    pose proof (left_over A lam vx vy hA hl M h1 t ltac:(lra) (slips t ltac:(lra))) as E. fold (v 0) in E. fold T in E. fold (v t) in E.
    set (C := v t + vx t) in *. set (S := v t - vx t) in *. assert (ev : v t = (C + S) / 2) by (unfold C, S; field). assert (ex : vx t = (C - S) / 2) by (unfold C, S; field).
    assert (Cc : C < c). { assert (T - t < c / (2 * A * (lam + 1))) by lra. apply Rlt_div_r in H; trivial.
      assert (F : (lam - 1) * ((lam + 1) * A * (T - t)) = lam * v t + vx t) by (rewrite E; ring). rewrite ev, ex in F.
      assert ((lam - 1) * ((lam + 1) * A * (T - t)) >= (lam - 1) * (C / 2)) by nra. assert ((lam + 1) * A * (T - t) >= C / 2) by nra. lra. }
    assert (Sq : S < q * C). { assert (lc : ln C < (K + (lam - 1) * ln q) / 2) by (rewrite <- (ln_exp ((K + (lam - 1) * ln q) / 2)); now apply ln_increasing).
      apply ln_lt_inv; trivial. now apply Rmult_lt_0_compat. rewrite ln_mult by trivial. apply (Rmult_lt_reg_l (lam - 1)); nra. }
    destruct (sides vx vy t) as (_ & _ & y). fold (v t) C S in y. assert (x0 : C / 4 <= vx t) by nra. split. lra.
    rewrite <- (Rabs_pos_eq (e * vx t)) by nra. apply Rsqr_le_abs_0. unfold Rsqr.
    assert (C * S <= e ^ 2 / 16 * C ^ 2) by nra. assert (C / 4 * (C / 4) <= vx t * vx t) by (apply Rmult_le_compat; lra). assert (0 <= e ^ 2) by nra. nra.
  - exists 1. split. lra. intros t Ht _. specialize (slips t Ht). specialize (Cp t Ht).
    assert (F : v t - vx t <= v 0 - vx 0).
    { apply (rder_decr (fun t => v t - vx t)); [ lra | | ]; intros s Hs. unfold v. pose proof (cx A lam vx vy M s ltac:(lra)). pose proof (cy A lam vx vy M s ltac:(lra)). cont.
      destruct (side_rates A lam vx vy hA hl M s ltac:(lra) (slips s ltac:(lra))) as [_ P]. eexists. split. exact P. destruct (sides vx vy s) as (_ & b & _). pose proof (nrm_pos (vx s) (vy s)). pose proof (slips s ltac:(lra)).
      fold (v s) in *. assert (0 <= (v s - vx s) / v s) by (apply Rmult_le_pos; [ | left; apply Rinv_0_lt_compat ]; lra). assert (0 <= (1 + lam) * A) by nra. nra. }
    destruct (sides vx vy t) as (_ & b & y). fold (v t) in b, y. assert (z' : v t - vx t = 0) by lra. rewrite z' in y. assert (y0 : vy t = 0) by nra. rewrite y0, Rabs_R0. split; nra.
Qed.
