(* Section 4: slipping motions on the turntable exist, by Picard with the direction of the slip made Lipschitz *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Fate Alpha Picard.
Open Scope R_scope.

Lemma nrm_lip a b a' b' : Rabs (nrm a b - nrm a' b') <= Rabs (a - a') + Rabs (b - b').
Proof.
  assert (H : forall a b a' b', nrm a b <= nrm a' b' + (Rabs (a - a') + Rabs (b - b'))).
  { clear. intros a b a' b'. pose proof (nrm_sq a b) as e1. pose proof (nrm_sq a' b') as e2. pose proof (nrm_pos a b). pose proof (nrm_pos a' b').
    pose proof (power_bound (nrm a' b') (- a') (- b') (a - a') (b - b') H0 ltac:(lra)) as Q.
    pose proof (nrm_sq (a - a') (b - b')) as e3. pose proof (nrm_pos (a - a') (b - b')).
    pose proof (pow2_abs (a - a')) as k1. pose proof (pow2_abs (b - b')) as k2. pose proof (Rabs_pos (a - a')). pose proof (Rabs_pos (b - b')).
    set (n := nrm a b) in *. set (m := nrm a' b') in *. set (k := nrm (a - a') (b - b')) in *.
    assert (n <= m + k) by nra. assert (k <= Rabs (a - a') + Rabs (b - b')) by nra. lra. }
  pose proof (H a b a' b'). pose proof (H a' b' a b) as K. rewrite (Rabs_minus_sym a'), (Rabs_minus_sym b') in K. apply Rabs_le. lra.
Qed.
Lemma Rmax_lip d a b : Rabs (Rmax d a - Rmax d b) <= Rabs (a - b).
Proof. unfold Rmax, Rabs. repeat (destruct Rle_dec || destruct Rcase_abs); lra. Qed.
Lemma nrm_ge a b : Rabs a <= nrm a b /\ Rabs b <= nrm a b.
Proof.
  pose proof (nrm_sq a b). pose proof (nrm_pos a b). pose proof (pow2_ge_0 a). pose proof (pow2_ge_0 b). pose proof (pow2_abs a). pose proof (pow2_abs b).
  pose proof (Rabs_pos a). pose proof (Rabs_pos b). split; nra.
Qed.
Lemma ratio_lip d a m a' m' D : 0 < d -> d <= m -> d <= m' -> Rabs a' <= m' -> Rabs (a - a') <= D -> Rabs (m - m') <= 2 * D ->
  Rabs (a / m - a' / m') <= 3 / d * D.
Proof.
  intros Hd hm hm' ha hD hM. replace (a / m - a' / m') with (((a - a') + a' / m' * (m' - m)) * / m) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ m)) by (left; apply Rinv_0_lt_compat; lra).
  assert (q : Rabs (a' / m') <= 1). { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ m')) by (left; apply Rinv_0_lt_compat; lra). apply Rle_div_l; lra. }
  assert (s : Rabs (a - a' + a' / m' * (m' - m)) <= 3 * D).
  { eapply Rle_trans; [ apply Rabs_triang | ]. rewrite Rabs_mult, (Rabs_minus_sym m' m). pose proof (Rabs_pos (m - m')). nra. }
  assert (r : / m <= / d) by (apply Rinv_le_contravar; lra). assert (0 < / m) by (apply Rinv_0_lt_compat; lra).
  pose proof (Rabs_pos (a - a' + a' / m' * (m' - m))). unfold Rdiv. apply Rle_trans with (3 * D * / d); [ | lra ]. apply Rmult_le_compat; lra.
Qed.
(* (89) with p, below the speed d, replaced by d *)
Definition slope d (v : place -> R) := Rmax d (nrm (v pu) (v pw)).
Definition field89 d i v := match i with
  | px => v pu | py => v pw
  | pu => v px + 2 * v pw - v pu / slope d v
  | pw => v py - 2 * v pu - v pw / slope d v end.
Lemma field89_lip d : 0 < d -> forall v v' D, (forall j, Rabs (v j - v' j) <= D) -> forall i, Rabs (field89 d i v - field89 d i v') <= (3 + 3 / d) * D.
Proof.
  intros Hd v v' D H. pose proof (H px) as Hx. pose proof (H py) as Hy. pose proof (H pu) as Hu. pose proof (H pw) as Hw.
  assert (D0 : 0 <= D) by (pose proof (Rabs_pos (v px - v' px)); lra). assert (d0 : 0 < 3 / d) by (apply Rdiv_lt_0_compat; lra).
  assert (M : Rabs (slope d v - slope d v') <= 2 * D). { eapply Rle_trans; [ apply Rmax_lip | ]. eapply Rle_trans; [ apply nrm_lip | lra ]. }
  assert (m1 : d <= slope d v) by apply Rmax_l. assert (m2 : d <= slope d v') by apply Rmax_l.
  assert (m3 : nrm (v' pu) (v' pw) <= slope d v') by apply Rmax_r. destruct (nrm_ge (v' pu) (v' pw)).
  pose proof (ratio_lip d (v pu) _ (v' pu) _ D Hd m1 m2 ltac:(lra) Hu M) as Ru. pose proof (ratio_lip d (v pw) _ (v' pw) _ D Hd m1 m2 ltac:(lra) Hw M) as Rw.
  assert (0 <= 3 / d * D) by (apply Rmult_le_pos; lra).
  apply Rabs_le_between in Hx, Hy, Hu, Hw, Ru, Rw. intros i. apply Rabs_le. destruct i; simpl; lra.
Qed.
Definition regular d (Hd : 0 < d) c := picard (field89 d) (3 + 3 / d) ltac:(assert (0 < 3 / d) by (apply Rdiv_lt_0_compat; lra); lra) (field89_lip d Hd) c.

(* every start that slips with xi >= 1, that is rho cos psi >= 1, has a motion; its speed never falls *)
Theorem slip_exists x0 y0 u0 w0 : 0 < nrm u0 w0 -> nrm u0 w0 <= x0 * u0 + y0 * w0 ->
  exists x y u w, spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0 /\ forall t, 0 <= t -> nrm u0 w0 <= nrm (u t) (w t).
Proof.
  intros p0 H0. set (d := nrm u0 w0 / 2). assert (Hd : 0 < d) by (unfold d; lra).
  destruct (regular d Hd (fun i => match i with px => x0 | py => y0 | pu => u0 | pw => w0 end)) as (f & I0 & C & D).
  set (x := f px). set (y := f py). set (u := f pu). set (w := f pw).
  pose proof (I0 px) as ix. pose proof (I0 py) as iy. pose proof (I0 pu) as iu. pose proof (I0 pw) as iw. simpl in ix, iy, iu, iw. fold x in ix. fold y in iy. fold u in iu. fold w in iw.
  assert (X : forall t, 0 <= t -> rder x t (u t)) by (intros; apply rder_of, (D px); trivial).
  assert (Y : forall t, 0 <= t -> rder y t (w t)) by (intros; apply rder_of, (D py); trivial).
  assert (U : forall t, 0 <= t -> d < nrm (u t) (w t) -> rder u t (x t + 2 * w t - u t / nrm (u t) (w t))).
  { intros t Ht k. eapply rder_eq. apply rder_of, (D pu); trivial. simpl. unfold slope. fold x u w. rewrite Rmax_right by lra. reflexivity. }
  assert (W : forall t, 0 <= t -> d < nrm (u t) (w t) -> rder w t (y t - 2 * u t - w t / nrm (u t) (w t))).
  { intros t Ht k. eapply rder_eq. apply rder_of, (D pw); trivial. simpl. unfold slope. fold y u w. rewrite Rmax_right by lra. reflexivity. }
  assert (up : forall T, 0 <= T -> (forall t, 0 <= t < T -> d < nrm (u t) (w t)) -> nrm u0 w0 <= nrm (u T) (w T)).
  { intros T HT K. 
    assert (sg : forall t, 0 <= t <= T -> t < T -> nrm (u t) (w t) <= x t * u t + y t * w t).
    { intros t Ht tT. assert (Q : 1 <= (x t * u t + y t * w t) * / nrm (u t) (w t)).
      { apply Rle_trans with ((x 0 * u 0 + y 0 * w 0) * / nrm (u 0) (w 0)). rewrite ix, iy, iu, iw. apply Rle_div_r; lra.
        apply Ropp_le_cancel. apply (rder_decr (fun t => - ((x t * u t + y t * w t) * / nrm (u t) (w t)))); [ lra | | ]; intros r Hr.
        - apply (continuity_pt_opp (fun t => (x t * u t + y t * w t) * / nrm (u t) (w t))), (continuity_pt_mult (fun t => x t * u t + y t * w t) (fun t => / nrm (u t) (w t))). cont; apply C.
          specialize (K r ltac:(lra)). apply (continuity_pt_inv (fun t => nrm (u t) (w t))); [ cont; apply C | lra ].
        - specialize (K r ltac:(lra)). specialize (X r ltac:(lra)). specialize (Y r ltac:(lra)). specialize (U r ltac:(lra) K). specialize (W r ltac:(lra) K).
          pose proof (nrm_sq (u r) (w r)) as e. eexists. split. apply (rder_opp (fun t => (x t * u t + y t * w t) * / nrm (u t) (w t))), (rder_mult (fun t => x t * u t + y t * w t)); [ rd | ].
          apply (rder_inv (fun t => nrm (u t) (w t))); [ rd | ]; lra.
          cbv beta. set (n := nrm (u r) (w r)) in *.
          match goal with |- ?g <= 0 => replace g with (- (/ n ^ 3 * (n ^ 2 + (x r * w r - y r * u r)) ^ 2)) end.
          assert (0 < / n ^ 3) by (apply Rinv_0_lt_compat, pow_lt; lra). pose proof (Rmult_le_pos _ _ (Rlt_le _ _ H) (pow2_ge_0 (n ^ 2 + (x r * w r - y r * u r)))). lra.
          inR. field_simplify_eq; [ | lra ]. ring [e]. }
      specialize (K t ltac:(lra)). apply (Rmult_le_compat_r (nrm (u t) (w t))) in Q; [ | lra ]. rewrite Rmult_assoc, Rinv_l in Q; lra. }
    rewrite <- iu, <- iw. apply Ropp_le_cancel. apply (rder_decr (fun t => - nrm (u t) (w t))); trivial; intros r Hr.
    - cont; apply C.
    - specialize (K r ltac:(lra)). specialize (U r ltac:(lra) K). specialize (W r ltac:(lra) K). specialize (sg r ltac:(lra) ltac:(lra)). pose proof (nrm_sq (u r) (w r)) as e.
      eexists. split. rd. lra. cbv beta. set (n := nrm (u r) (w r)) in *.
      match goal with |- ?g <= 0 => replace g with (- (/ n * (x r * u r + y r * w r - n))) end.
      assert (0 < / n) by (apply Rinv_0_lt_compat; lra). nra. inR. field_simplify_eq; [ | lra ]. ring [e]. }
  assert (all : forall t, 0 <= t -> d < nrm (u t) (w t)).
  { intros t Ht. apply (real_ind (fun t => d < nrm (u t) (w t)) 0 t); trivial; try lra.
    - rewrite iu, iw. unfold d. lra.
    - intros T HT K. specialize (up T ltac:(lra)). assert (nrm u0 w0 <= nrm (u T) (w T)); [ | unfold d; lra ]. apply up. intros; apply K; lra.
    - intros r Hr K. pose proof (K r ltac:(lra)) as k. specialize (U r ltac:(lra) k). specialize (W r ltac:(lra) k).
      destruct (right_pos (fun s => nrm (u s) (w s) - d) r _ ltac:(apply rder_minus; [ rd; lra | rd ])) as (e & e0 & He). lra.
      exists e. split; trivial. intros s Hs. specialize (He s Hs). lra. }
  exists x, y, u, w. split. 2: { repeat (split; trivial). intros t Ht. apply up; trivial. intros; apply all; lra. }
  split; try (intros; apply C). intros t Ht. split; auto. split; auto. specialize (all t Ht).
  exists (- 1 * u t / nrm (u t) (w t)), (- 1 * w t / nrm (u t) (w t)). split.
  - apply coulomb_iff. lra. right. split. lra. auto.
  - split; (eapply rder_eq; [ first [ apply U | apply W ]; trivial | field; lra ]).
Qed.
(* a motion with A > 1 stands: what s4_escape_if_A_above_1, s4_alpha_unbounded, xi_never_falls say is not said of nothing *)
Corollary slip_witness : exists x y u w, spin x y u w /\ 1 < x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2) /\ forall t, 0 <= t -> 1 <= nrm (u t) (w t).
Proof.
  assert (e : nrm 1 0 = 1) by (unfold nrm; replace (1 ^ 2 + 0 ^ 2) with 1 by ring; apply sqrt_1).
  destruct (slip_exists 2 0 1 0) as (x & y & u & w & S & e1 & e2 & e3 & e4 & P); rewrite ?e; try lra.
  exists x, y, u, w. split; trivial. rewrite e1, e2, e3, e4. rewrite e in P. split; trivial. lra.
Qed.
