(* Lemmas on the motion under a constant pull, v its speed: how c speed + vx changes, slipping or at rest; when it stops;
   how speed and direction are tied while it
   slips (the logarithm of (10)); what happens at large times, and before a stop. No angle is used. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
From Slipbook.General Require Import Contraction Straight.
Import Continuous.
Open Scope R_scope.

(* The pull A is an acceleration, lam the friction in its unit, dimensionless: (5).
   «$(vx,vy)$ is a motion under the acceleration $(A,0)$, with the friction $\mu g=A\,lam$» *)
Definition pulled A lam vx vy := motion (A * lam) (fun _ => eq3_acceleration_1 A) (fun _ => eq3_acceleration_2 A) vx vy.

Section Pull.
Variables (A lam : R) (vx vy v : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : pulled A lam vx vy.
Hypothesis V : forall t, 0 <= t -> nrm (vx t) (vy t) = v t.
Lemma hk : 0 <= A * lam. Proof. apply Rmult_le_pos; lra. Qed.
Lemma hd : 1 < lam -> 0 < A * (lam ^ 2 - 1). Proof. intros h. apply Rmult_lt_0_compat; nra. Qed.
Lemma cv t : 0 < t -> continuity_pt v t.
Proof.
  intros Ht. apply (cont_ext (fun s => nrm (vx s) (vy s))); trivial. cont.
Qed.
Local Hint Extern 2 (continuity_pt _ _) => apply cv; lra : core.
Lemma sides t : 0 <= t -> 0 <= v t + vx t /\ 0 <= v t - vx t /\ (v t + vx t) * (v t - vx t) = vy t ^ 2.
Proof. intros Ht. rewrite <- V by trivial. destruct (abs_nrm (vx t) (vy t)) as [b _]. apply Rabs_le_between in b. pose proof (nrm_sq (vx t) (vy t)).
  lra. Qed.
Lemma speed_ext t l : 0 <= t -> rder (fun s => nrm (vx s) (vy s)) t l -> rder v t l.
Proof. intros Ht. apply rder_ext. intros s Hs. apply V. lra. Qed.
Lemma pull_rates t : 0 <= t -> v t <> 0 ->
  rder vx t (A - A * lam * (vx t / v t)) /\ rder vy t (- A * lam * (vy t / v t)) /\ rder v t (A * (vx t / v t) - A * lam).
Proof.
  intros Ht. rewrite <- V by trivial. intros N. destruct (slip_rates _ _ _ _ _ hk M t Ht N) as [X Y].
  pose proof (speed_ext t _ Ht (speed_rate _ _ _ _ _ hk M t Ht N)) as S.
  unfold eq3_acceleration_1, eq3_acceleration_2 in *. split; [ | split ]; (eapply rder_eq; [ eassumption | ring ]).
Qed.
(* in every motion, at all times *)
Lemma rises c s t : 0 <= c -> 0 <= s <= t -> c * v s + vx s + A * (1 - c * lam - Rabs (c - lam)) * (t - s) <= c * v t + vx t.
Proof.
  intros hc Hs. set (r := 1 - c * lam - Rabs (c - lam)). enough (- (c * v t + vx t) + A * r * t <= - (c * v s + vx s) + A * r * s) by lra.
  apply (rder_decr (fun t => - (c * v t + vx t) + A * r * t)); [ lra | intros; cont | intros q Hq ]. destruct (Req_dec (v q) 0) as [z | z].
  - rewrite <- V in z by lra. destruct (rest_rates _ _ _ _ _ hk M q ltac:(lra) z) as (lx & ly & X & _ & N & b). apply speed_ext in N; [ | lra ].
    eexists. split. rds. cbv beta.
    destruct (abs_nrm lx ly) as [n _]. pose proof (proj1 (abs_nrm (lx + - A) (ly + 0))). unfold eq3_acceleration_1, eq3_acceleration_2 in b.
    apply Rabs_le_between in n, H.
    pose proof (Rle_abs (lam - c)). rewrite Rabs_minus_sym in H0. assert (r <= (1 + c) * (1 - lam)) by (unfold r; lra).
    assert (A * r <= A * ((1 + c) * (1 - lam))) by (apply Rmult_le_compat_l; lra).
    assert (c * (A * (1 - lam)) <= c * nrm lx ly) by (apply Rmult_le_compat_l; lra). lra.
  - destruct (pull_rates q ltac:(lra) z) as (X & _ & S). eexists. split. rds. cbv beta. destruct (sides q) as (a & b & _). lra. set (u := vx q / v q).
    assert (Rabs u <= 1). { unfold u. rewrite Rabs_div by trivial. rewrite (Rabs_pos_eq (v q)) by lra. apply Rle_div_l. lra. rewrite Rmult_1_l.
    apply Rabs_le. lra. }
    assert (w : Rabs ((c - lam) * u) <= Rabs (c - lam) * 1) by (rewrite Rabs_mult; apply Rmult_le_compat_l; [ apply Rabs_pos | trivial ]).
    apply Rabs_le_between in w.
    assert (0 <= A * ((c - lam) * u + Rabs (c - lam))) by (apply Rmult_le_pos; lra). unfold r. lra.
Qed.
Lemma plus_rises s t : lam <= 1 -> 0 <= s <= t -> v s + vx s <= v t + vx t.
Proof. intros h Hs. pose proof (rises 1 s t Rle_0_1 Hs) as r. rewrite (Rabs_pos_eq (1 - lam)) in r; lra. Qed.
Lemma forward_grows s t : 0 <= s <= t -> vx s + A * (1 - lam) * (t - s) <= vx t.
Proof. intros Hs. pose proof (rises 0 s t (Rle_refl 0) Hs) as r. rewrite Rabs_minus_sym, Rminus_0_r, Rabs_pos_eq in r; lra. Qed.
Lemma across_smaller s t : 0 <= s <= t -> vy t ^ 2 <= vy s ^ 2.
Proof. exact (across_falls (A * lam) (fun _ => - A) vx vy hk M s t). Qed.
(* lambda speed + vx changes at a constant rate while it slips: (14) *)
Lemma moved t : 0 <= t -> (forall s, 0 <= s < t -> v s <> 0) -> lam * v t + vx t = lam * v 0 + vx 0 + (1 - lam ^ 2) * A * t.
Proof.
  intros Ht N. enough (lam * v t + vx t - (1 - lam ^ 2) * A * t = lam * v 0 + vx 0 - (1 - lam ^ 2) * A * 0) by lra.
  apply (rder_const (fun t => lam * v t + vx t - (1 - lam ^ 2) * A * t)); trivial; intros s Hs. cont.
  destruct (pull_rates s ltac:(lra) (N s Hs)) as (X & _ & S). eapply rder_eq. rds. cbv beta. field. exact (N s Hs).
Qed.

(* ---- lambda >= 1: rest lasts; lambda > 1: it comes when lambda speed + vx is used up, and not before ---- *)
Section Strong.
Hypothesis h1 : 1 <= lam.
Lemma stays s t : 0 <= s <= t -> v s = 0 -> v t = 0.
Proof.
  intros Hs e. rewrite <- V in e |- * by lra. destruct (nrm_zero _ _ e).
  destruct (rest_lasts _ _ _ _ _ s hk M ltac:(lra)) with (t := t) as [-> ->]; trivial; try lra; [ | apply nrm_0 ].
  intros _ _. apply nrm_le. apply hk. unfold eq3_acceleration_1, eq3_acceleration_2. assert (A * 1 <= A * lam) by (apply Rmult_le_compat_l; lra). nra.
Qed.
Lemma moved_to t : 0 <= t -> v t <> 0 -> lam * v t + vx t = lam * v 0 + vx 0 + (1 - lam ^ 2) * A * t.
Proof. intros Ht N. apply moved; trivial. intros s Hs e. apply N, (stays s t); lra. Qed.
Lemma rest_after t : 1 < lam -> 0 <= t -> lam * v 0 + vx 0 <= A * (lam ^ 2 - 1) * t -> v t = 0.
Proof. intros h Ht H. destruct (Req_dec (v t) 0) as [z | z]; trivial. exfalso. pose proof (moved_to t Ht z). destruct (sides t Ht). nra. Qed.
Lemma slip_before t : 0 <= t -> A * (lam ^ 2 - 1) * t < lam * v 0 + vx 0 -> v t <> 0.
Proof. intros Ht H e. pose proof (rises lam 0 t hl ltac:(lra)) as r. rewrite Rminus_eq_0, Rabs_R0 in r. destruct (sides t Ht) as (a & b & _).
  rewrite e in *. nra. Qed.
End Strong.

(* ---- while it slips, from a start that is not straight against the pull ---- *)
Section Turn.
Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis slips : forall s, 0 <= s <= t -> v s <> 0.
Hypothesis C0 : 0 < v 0 + vx 0.
Lemma slip_above : exists m, 0 < m /\ forall s, 0 <= s <= t -> m <= v s.
Proof.
  pose proof (slips t ltac:(lra)). destruct (sides t ht) as (a & b & _). destruct (Rle_lt_dec lam 1) as [h | h].
  - exists ((v 0 + vx 0) / 2). split. lra. intros s Hs. pose proof (plus_rises 0 s h ltac:(lra)). destruct (sides s); lra.
  - exists ((lam * v t + vx t) / (lam + 1)). split. apply Rdiv_lt_0_compat; nra. intros s Hs. apply Rle_div_l. lra.
    destruct (sides s) as (_ & d & _). lra.
    rewrite (moved t ht) by (intros; apply slips; lra). pose proof (moved s (proj1 Hs) ltac:(intros; apply slips; lra)). pose proof (hd h). nra.
Qed.
(* what changes at a multiple of itself over the speed keeps its sign *)
Lemma kept f c : (forall s, 0 < s <= t -> continuity_pt f s) -> (forall s, 0 <= s <= t -> rder f s (c * (f s / v s))) -> 0 < f 0 -> 0 < f t.
Proof.
  intros Cf D P. destruct slip_above as (m & m0 & Hm). set (K := 2 * Rabs c / m). apply (keeps_sign f (c * (f 0 / v 0))); trivial. apply D; lra.
  intros q Hq z.
  assert (E : - (f q ^ 2 * exp (K * q)) <= - (f 0 ^ 2 * exp (K * 0))).
  { apply (rder_decr (fun t => - (f t ^ 2 * exp (K * t)))); try lra; intros s Hs. specialize (Cf s ltac:(lra)). cont.
    eexists. split. pose proof (D s ltac:(lra)). rd. cbv beta. specialize (Hm s ltac:(lra)).
    assert (r : 0 < / v s <= / m) by (split; [ apply Rinv_0_lt_compat | apply Rinv_le_contravar ]; lra).
    pose proof (exp_pos (K * s)). set (x := exp (K * s)) in *. unfold K. pose proof (Rle_abs (- c)) as c1. rewrite Rabs_Ropp in c1.
    pose proof (Rabs_pos c).
    assert (- c * / v s <= Rabs c * / m). { apply Rle_trans with (Rabs c * / v s); [ apply Rmult_le_compat_r; lra | apply Rmult_le_compat_l; lra ]. }
    assert (0 <= 2 * f s ^ 2 * x) by (apply Rmult_le_pos; [ nra | lra ]). simpl pred. simpl INR. unfold Rdiv. nra. }
  rewrite z, Rmult_0_r, exp_0 in E. nra.
Qed.
Lemma plus_positive : 0 < v t + vx t.
Proof.
  apply (kept (fun s => v s + vx s) ((1 - lam) * A)); trivial; intros s Hs. cont.
  destruct (pull_rates s ltac:(lra) (slips s Hs)) as (X & _ & S). eapply rder_eq. rds. field. exact (slips s Hs).
Qed.
Lemma across_kept : vy 0 <> 0 -> 0 < vy t * vy 0.
Proof.
  intros Y. apply (kept (fun s => vy s * vy 0) (- lam * A)); [ intros; cont | intros s Hs | destruct (Rdichotomy _ _ Y); nra ].
  destruct (pull_rates s ltac:(lra) (slips s Hs)) as (_ & D & _). eapply rder_eq. rd. field. exact (slips s Hs).
Qed.
End Turn.
(* (10) in logarithms, and as a power: vy / (speed + vx) is the tangent of half the angle *)
Lemma power_law t : 0 <= t -> (forall s, 0 <= s <= t -> v s <> 0) -> vy 0 <> 0 ->
  let r := vy t / (v t + vx t) / (vy 0 / (v 0 + vx 0)) in
  0 < v 0 + vx 0 /\ 0 < v t + vx t /\ 0 < vy t * vy 0 /\ 0 < r /\ vy t / vy 0 = Rpower r lam /\
  (1 - lam) * ln (vy t * vy 0) + lam * ln (v t + vx t) = (1 - lam) * ln (vy 0 * vy 0) + lam * ln (v 0 + vx 0).
Proof.
  intros Ht N Y r. destruct (sides 0 (Rle_refl 0)) as (a & b & e). assert (y2 : 0 < vy 0 * vy 0) by (destruct (Rdichotomy _ _ Y); nra).
  assert (C0 : 0 < v 0 + vx 0) by nra.
  assert (P : forall s, 0 <= s <= t -> 0 < v s + vx s /\ 0 < vy s * vy 0).
  { intros s Hs. split; [ apply plus_positive | apply across_kept ]; trivial; try lra; intros; apply N; lra. } destruct (P t ltac:(lra)) as [Ct P1].
  assert (L : (1 - lam) * ln (vy t * vy 0) + lam * ln (v t + vx t) = (1 - lam) * ln (vy 0 * vy 0) + lam * ln (v 0 + vx 0)).
  { apply (rder_const (fun t => (1 - lam) * ln (vy t * vy 0) + lam * ln (v t + vx t))); trivial; intros s Hs; destruct (P s ltac:(lra)).
    cont; trivial.
    destruct (pull_rates s ltac:(lra) (N s ltac:(lra))) as (X & D & S). eapply rder_eq.
    apply (rder_plus (fun t => (1 - lam) * ln (vy t * vy 0)) (fun t => lam * ln (v t + vx t))); [ rd; trivial | apply (rder_mult (fun _ => lam));
    [ rd | apply rder_ln; [ rds | trivial ] ] ].
    cbv beta. field. repeat split; trivial; try lra; [ apply N; lra | intros z; rewrite z in *; lra ]. }
  assert (er : r = vy t * vy 0 / (vy 0 * vy 0) * ((v 0 + vx 0) / (v t + vx t))) by (unfold r; field; repeat split; trivial; lra).
  assert (q0 : 0 < vy t * vy 0 / (vy 0 * vy 0)) by now apply Rdiv_lt_0_compat.
  assert (q1 : 0 < (v 0 + vx 0) / (v t + vx t)) by now apply Rdiv_lt_0_compat.
  assert (r0 : 0 < r) by (rewrite er; now apply Rmult_lt_0_compat). repeat split; trivial.
  replace (vy t / vy 0) with (vy t * vy 0 / (vy 0 * vy 0)) by (field; trivial).
  unfold Rpower. rewrite er, ln_mult, !ln_div by trivial. rewrite <- (exp_ln (vy t * vy 0 / _)) at 1 by trivial. rewrite ln_div by trivial. f_equal.
  lra.
Qed.
(* lambda > 1: the velocity turns into the x-axis before it stops *)
Lemma turns_before_stop : 1 < lam -> 0 < v 0 + vx 0 -> forall e, 0 < e -> exists d, 0 < d /\
  forall t, 0 <= t -> v t <> 0 -> lam * v t + vx t < d -> 0 < vx t /\ Rabs (vy t) <= e * vx t.
Proof.
  intros h C0 e He. assert (slips : forall t, 0 <= t -> v t <> 0 -> forall s, 0 <= s <= t -> v s <> 0) by (intros t Ht N s Hs z;
  apply N, (stays ltac:(lra) s t); trivial; lra).
  destruct (Req_dec (vy 0) 0) as [z | Y].
  - exists 1. split. lra. intros t Ht N _. pose proof (plus_positive t Ht (slips t Ht N) C0). pose proof (across_smaller 0 t ltac:(lra)) as y.
    rewrite z in y. destruct (sides t Ht) as (_ & b & p).
    assert (y0 : vy t = 0) by nra. rewrite y0 in *. rewrite Rabs_R0. assert (v t - vx t = 0) by nra. split; nra.
  - set (q := Rmin (1 / 2) (e / 4)). assert (q0 : 0 < q) by (apply Rmin_pos; lra). pose proof (Rmin_l (1 / 2) (e / 4)) as q1.
    pose proof (Rmin_r (1 / 2) (e / 4)) as q2. fold q in q1, q2.
    pose proof (Rabs_pos_lt _ Y) as y0. set (K := (1 - lam) * ln (vy 0 * vy 0) + lam * ln (v 0 + vx 0)).
    exists (exp (K + (lam - 1) * ln (q * Rabs (vy 0)))). split. apply exp_pos.
    intros t Ht N J. destruct (power_law t Ht (slips t Ht N) Y) as (_ & C & P & _ & _ & L). fold K in L. destruct (sides t Ht) as (_ & b & p).
    set (c := v t + vx t) in *.
    assert (lc : ln c < K + (lam - 1) * ln (q * Rabs (vy 0))). { rewrite <- (ln_exp (K + _)). apply ln_increasing; trivial.
    apply Rle_lt_trans with (2 := J). assert (0 <= (lam - 1) * v t) by (apply Rmult_le_pos; unfold c in C; lra). unfold c. lra. }
    assert (y : Rabs (vy t) < q * c).
    { apply (Rmult_lt_reg_r (Rabs (vy 0))); trivial. rewrite <- Rabs_mult, Rabs_pos_eq by lra. apply ln_lt_inv; trivial.
      repeat apply Rmult_lt_0_compat; trivial.
      replace (q * c * Rabs (vy 0)) with (q * Rabs (vy 0) * c) by ring.
      rewrite (ln_mult (q * Rabs (vy 0))) by (trivial; now apply Rmult_lt_0_compat). apply (Rmult_lt_reg_l (lam - 1)); lra. }
    pose proof (Rabs_pos (vy t)). assert (y2 : vy t ^ 2 <= (q * c) ^ 2) by (rewrite <- pow2_abs; apply pow_incr; lra).
    assert (v t - vx t <= q ^ 2 * c) by (apply (Rmult_le_reg_l c); trivial; nra).
    assert (q ^ 2 * c <= / 4 * c) by (apply Rmult_le_compat_r; nra). assert (c / 4 <= vx t) by (unfold c in *; lra). split. lra.
    apply Rle_trans with (e / 4 * c); nra.
Qed.
End Pull.

(* ---- lambda = 1 ---- *)
Section Critical.
Variables (A : R) (vx vy v : R -> R).
Hypothesis hA : 0 < A.
Hypothesis M : pulled A 1 vx vy.
Hypothesis V : forall t, 0 <= t -> nrm (vx t) (vy t) = v t.
Lemma plus_stays t : 0 <= t -> v t + vx t = v 0 + vx 0.
Proof.
  intros Ht. pose proof (plus_rises A 1 vx vy v hA Rle_0_1 M V 0 t ltac:(lra) ltac:(lra)) as r. destruct (Req_dec (v t) 0) as [z | z].
  - pose proof (sides vx vy v V t Ht). pose proof (sides vx vy v V 0 (Rle_refl 0)). lra.
  - pose proof (moved_to A 1 vx vy v hA Rle_0_1 M V (Rle_refl 1) t Ht z). lra.
Qed.
(* straight against the pull: it stops, and stays *)
Lemma straight_stops t : v 0 + vx 0 = 0 -> 0 <= t -> v 0 / (2 * A) <= t -> v t = 0.
Proof.
  intros z Ht Hs. destruct (Req_dec (v t) 0) as [e | N]; trivial. exfalso. apply Rle_div_l in Hs; [ | lra ].
  assert (K : v t + 2 * A * t <= v 0 + 2 * A * 0).
  { apply (rder_decr (fun t => v t + 2 * A * t)); trivial; intros s H. pose proof (cv A 1 vx vy v M V s ltac:(lra)). cont.
    assert (Ns : v s <> 0) by (intros q; apply N, (stays A 1 vx vy v hA Rle_0_1 M V (Rle_refl 1) s t); lra).
    destruct (pull_rates A 1 vx vy v hA Rle_0_1 M V s ltac:(lra) Ns) as (_ & _ & S).
    eexists. split. rds. pose proof (plus_stays s ltac:(lra)) as es. replace (vx s) with (- v s) by lra. right. field. exact Ns. }
  pose proof (sides vx vy v V t Ht). lra.
Qed.
Lemma critical_late : is_lim vy p_infty 0 /\ is_lim vx p_infty ((v 0 + vx 0) / 2).
Proof.
  assert (L : is_lim vy p_infty 0). { apply (across_vanishes (A * 1) (fun _ => - A) vx vy ltac:(lra) M A); trivial; [ | lra ]. intros t _.
  rewrite Rabs_Ropp, Rabs_pos_eq; lra. } split; trivial.
  destruct (sides vx vy v V 0 (Rle_refl 0)) as ([p | z] & _).
  - set (C := v 0 + vx 0) in *. apply (is_lim_ext_loc (fun t => C / 2 - vy t ^ 2 / (2 * C))).
    + exists 0. intros t Ht. pose proof (plus_stays t ltac:(lra)) as e. fold C in e. destruct (sides vx vy v V t ltac:(lra)) as (_ & _ & s).
      rewrite e in s. rewrite <- s. replace (v t) with (C - vx t) by lra. field. lra.
    + replace (Finite (C / 2)) with (Finite ((fun y => C / 2 - y ^ 2 / (2 * C)) 0)) by (f_equal; field; lra).
      apply (is_lim_comp_continuous vy (fun y => C / 2 - y ^ 2 / (2 * C))); trivial. apply continuity_pt_filterlim. unfold Rdiv. cont.
  - rewrite <- z. replace (0 / 2) with 0 by field. apply (lim_eventually _ (Rmax 0 (v 0 / (2 * A)))). intros t Ht.
    pose proof (Rmax_l 0 (v 0 / (2 * A))). pose proof (Rmax_r 0 (v 0 / (2 * A))). pose proof (sides vx vy v V t ltac:(lra)).
    rewrite (straight_stops t) in * by lra. lra.
Qed.
End Critical.

(* lambda <= 1, but for lambda = 1 from rest or straight against the pull: the velocity turns into the x-axis *)
Theorem turns_forward A lam vx vy v : 0 < A -> 0 <= lam <= 1 -> pulled A lam vx vy -> (forall t,
  0 <= t -> nrm (vx t) (vy t) = v t) -> (lam < 1 \/ 0 < v 0 + vx 0) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> 0 < vx t /\ Rabs (vy t) <= e * vx t.
Proof.
  intros hA [hl h1] M V h e He. destruct (Rlt_le_dec lam 1) as [l1 | l1].
  - assert (g : 0 < A * (1 - lam)) by nra. destruct (grows_line _ (vx 0) (Rabs (vy 0) / e + 1) g) as (T & T0 & HT). exists T. split; trivial.
    intros t Ht. specialize (HT t Ht).
    pose proof (forward_grows A lam vx vy v hA hl M V 0 t ltac:(lra)). assert (Rabs (vy 0) / e <= vx t) by lra. apply Rle_div_l in H0; trivial.
    assert (Rabs (vy t) <= Rabs (vy 0)). { apply Rsqr_le_abs_0. unfold Rsqr. pose proof (across_smaller A lam vx vy hA hl M 0 t ltac:(lra)). lra.
    } pose proof (Rdiv_le_0_compat _ _ (Rabs_pos (vy 0)) He). split; lra.
  - assert (lam = 1) as -> by lra. assert (C0 : 0 < v 0 + vx 0) by lra. destruct (critical_late A vx vy v hA M V) as [Ly Lx].
    set (m := (v 0 + vx 0) / 2) in *. assert (m0 : 0 < m / 2) by (unfold m; lra).
    destruct (lim_near _ _ (e * (m / 2)) Ly) as (T1 & P1 & H1). nra. destruct (lim_near _ _ _ Lx m0) as (T2 & P2 & H2). exists (T1 + T2). split.
    lra. intros t Ht.
    specialize (H1 t ltac:(lra)). specialize (H2 t ltac:(lra)). assert (e * (m / 2) <= e * vx t) by (apply Rmult_le_compat_l; lra). split. lra.
    apply Rabs_le. lra.
Qed.
