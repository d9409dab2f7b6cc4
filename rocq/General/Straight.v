(* Drives along the x-axis: the velocity across dies out, a drive that stays above k by a margin speeds the particle up,
   one that stays above k without a margin
   need not. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis.
From Slipbook.General Require Import Contraction.
Import Continuous.
Open Scope R_scope.

Section Straight.
Variables (k : R) (Ax vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis M : motion k Ax (fun _ => 0) vx vy.
Notation v t := (nrm (vx t) (vy t)).
(* the rates, slipping or not *)
Lemma across_force s : 0 <= s -> exists lx ly, rder vx s lx /\ rder vy s ly /\ Rabs (lx + Ax s) <= k /\ Rabs ly <= k /\ v s * ly = - k * vy s /\ vy s
  * ly <= 0.
Proof.
  intros Hs. destruct (m_law _ _ _ _ _ M s Hs) as (fx & fy & C & X & Y). destruct (coulomb_slip _ _ _ _ _ hk C) as [_ e]. destruct C as [B _].
  destruct (abs_nrm fx fy). pose proof (nrm_le fx fy k hk B). exists (fx - Ax s), (fy - 0). rewrite Rminus_0_r in *.
  replace (fx - Ax s + Ax s) with fx by ring. repeat split; trivial; try lra.
  destruct (nrm_pos (vx s) (vy s)) as [p | p]; [ | destruct (nrm_zero _ _ (eq_sym p)) as [_ ->]; lra ]. pose proof (pow2_ge_0 (vy s)).
  apply (Rmult_le_reg_l (v s)); trivial. replace (v s * (vy s * fy)) with (vy s * (v s * fy)) by ring. rewrite e. nra.
Qed.
Theorem across_falls s t : 0 <= s <= t -> vy t ^ 2 <= vy s ^ 2.
Proof.
  intros Hst. apply (rder_decr (fun t => vy t ^ 2)); [ lra | intros; cont | ]. intros u Hu.
  destruct (across_force u) as (lx & ly & _ & Y & _ & _ & _ & P); [ lra | ].
  eexists. split. rd. simpl. lra.
Qed.
Theorem across_falls_strictly s t : 0 < k -> 0 <= s < t -> vy s <> 0 -> vy t ^ 2 < vy s ^ 2.
Proof.
  intros k0 Hst N. destruct (across_force s) as (lx & ly & _ & Y & _ & _ & e & P); [ lra | ].
  assert (q : vy s * ly <> 0) by (intros z; apply Rmult_integral in z as [z | z]; nra).
  destruct (rder_falls _ _ _ (rder_pow vy 2 s ly Y)) as (d & d0 & Hd). simpl. lra. assert (p : 0 < Rmin d (t - s)) by (apply Rmin_pos; lra).
  pose proof (Rmin_l d (t - s)). pose proof (Rmin_r d (t - s)).
  specialize (Hd (Rmin d (t - s) / 2) ltac:(lra)). pose proof (across_falls (s + Rmin d (t - s) / 2) t ltac:(lra)). lra.
Qed.
(* a bounded drive: the speed grows at a bounded rate b, the velocity across falls as t^(-k/b), at least *)
Theorem across_vanishes a : 0 < a -> (forall t, 0 <= t -> Rabs (Ax t) <= a) -> 0 < k -> is_lim vy p_infty 0.
Proof.
  intros ha hA k0. set (b := 2 * (a + k)). assert (ec : v 0 + 1 = v 0 + 1) by trivial. revert ec. generalize (v 0 + 1) at 2. intros c ec.
  set (L t := c + b * t). assert (b0 : 0 < b) by (unfold b; lra).
  assert (vL : forall t, 0 <= t -> 0 < L t /\ v t <= L t).
  { intros t Ht. assert (K : Rabs (vx t - vx 0) <= (a + k) * (t - 0) /\ Rabs (vy t - vy 0) <= (a + k) * (t - 0)).
    { split; apply rder_lip; trivial; intros s Hs; try cont; destruct (across_force s) as (lx & ly & X & Y & B & B' & _); try lra; eexists; (split;
      [ eassumption | ]); [ | lra ].
      specialize (hA s ltac:(lra)). apply Rabs_le_between in B, hA. apply Rabs_le. lra. }
    pose proof (nrm_near (vx t) (vy t) (vx 0) (vy 0)) as N. apply Rabs_le_between in N. pose proof (nrm_pos (vx 0) (vy 0)). unfold L, b. split; nra. }
  set (B t := exp (2 * k / b * ln (L t))). apply (lim_of_bound vy (vy 0 ^ 2 * B 0) B). { apply Rmult_le_pos. apply pow2_ge_0. left. apply exp_pos. }
  - intros t Ht. unfold B. apply (rder_decr (fun t => vy t ^ 2 * exp (2 * k / b * ln (L t)))); trivial; intros s Hs;
    destruct (vL s ltac:(lra)) as [p l]; [ unfold L; cont; exact p | ].
    destruct (across_force s) as (lx & ly & _ & Y & _ & _ & e & P); [ lra | ]. unfold L in *. eexists. split. rd. exact p. cbv beta.
    set (E := exp _). assert (0 < E) by apply exp_pos. set (m := c + b * s) in *.
    match goal with |- ?g <= 0 => replace g with (2 * E / m * (m * (vy s * ly) + k * vy s ^ 2)) by (simpl; field; lra) end.
    assert (0 <= 2 * E / m) by (apply Rdiv_le_0_compat; lra). assert (m * (vy s * ly) <= v s * (vy s * ly)) by nra.
    replace (v s * (vy s * ly)) with (- k * vy s ^ 2) in * by (rewrite <- Rmult_assoc, (Rmult_comm (v s)), Rmult_assoc, e; ring). nra.
  - intros K. assert (h : 0 < 2 * k / b) by (apply Rdiv_lt_0_compat; lra).
    destruct (grows_line b c (exp (Rabs K / (2 * k / b))) b0) as (T & T0 & HT). exists T. split; trivial. intros t Ht.
    specialize (HT t Ht). apply Rcomplements.ln_le in HT; [ | apply exp_pos ]. rewrite ln_exp in HT. apply Rle_div_l in HT; trivial. unfold B.
    pose proof (exp_ineq1_le (2 * k / b * ln (L t))). pose proof (Rle_abs K). unfold L in *. lra.
Qed.
(* a drive towards +x above k + delta: the speed grows at delta / 2 from some time on *)
Theorem speeds_up delta : 0 < delta -> (forall t, 0 <= t -> k + delta <= - Ax t) -> exists T, 0 <= T /\ forall s t,
  T <= s <= t -> v s + delta / 2 * (t - s) <= v t.
Proof.
  intros hd hA. assert (G : forall t, 0 <= t -> vx 0 + delta * t <= vx t).
  { intros t Ht. enough (- vx t + delta * t <= - vx 0 + delta * 0) by lra.
    apply (rder_decr (fun t => - vx t + delta * t)); [ trivial | intros; cont | intros s Hs ].
    destruct (across_force s) as (lx & ly & X & _ & b & _); [ lra | ]. apply Rabs_le_between in b. specialize (hA s ltac:(lra)). eexists. split. rd.
    lra. }
  set (Y := Rabs (vy 0)). destruct (grows_line delta (vx 0) ((2 * k / delta + 1) * Y + 1) hd) as (T & T0 & HT). exists T. split; trivial.
  intros s t Hst.
  enough (- v t + delta / 2 * t <= - v s + delta / 2 * s) by lra.
  apply (rder_decr (fun t => - v t + delta / 2 * t)); [ lra | intros; cont | intros u Hu ].
  specialize (HT u ltac:(lra)). specialize (G u ltac:(lra)). specialize (hA u ltac:(lra)). assert (x : (2 * k / delta + 1) * Y + 1 <= vx u) by lra.
  clear HT G.
  assert (Rabs (vy u) <= Y) by (apply Rsqr_le_abs_0; pose proof (across_falls 0 u ltac:(lra)); unfold Rsqr; lra). pose proof (Rabs_pos (vy 0)).
  fold Y in H0. assert (0 <= 2 * k / delta) by (apply Rdiv_le_0_compat; lra).
  assert (x1 : 1 <= vx u) by nra. pose proof (nrm_abs (vx u) (vy u)) as nb. destruct (abs_nrm (vx u) (vy u)) as [na _].
  rewrite (Rabs_pos_eq (vx u)) in na, nb by lra.
  pose proof (speed_rate k Ax (fun _ => 0) vx vy hk M u ltac:(lra) ltac:(lra)) as S. cbv beta in S. eexists. split. rds. set (n := v u) in *.
  assert (c : (k + delta / 2) * n <= (k + delta) * vx u).
  { apply (Rmult_le_compat_l (delta / 2)) in x; [ | lra ]. replace (delta / 2 * ((2 * k / delta + 1) * Y + 1)) with ((k + delta / 2) * Y + delta / 2)
    in x by (field; lra).
    assert ((k + delta / 2) * n <= (k + delta / 2) * (vx u + Y)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (u0 : 0 <= vx u / n) by (apply Rdiv_le_0_compat; lra).
  assert (k + delta / 2 <= (k + delta) * (vx u / n)) by (replace ((k + delta) * (vx u / n)) with ((k + delta) * vx u / n) by (field; lra);
  apply Rle_div_r; lra). nra.
Qed.
End Straight.

(* k = 1: a drive a(t) > 1 towards +x for ever, and a motion (u, w) that loses speed for ever; n is its speed *)
Theorem no_margin : exists a u w, (forall t, 0 <= t -> 1 < a t) /\ (forall t,
  0 <= t -> continuity_pt a t) /\ motion 1 (fun t => - a t) (fun _ => 0) u w /\
  forall s t, 0 <= s < t -> nrm (u t) (w t) < nrm (u s) (w s).
Proof.
  set (z t := exp (- (2) * t)). set (n t := 1 + z t / 8). set (w t := exp (- t) / sqrt (n t)). set (u t := sqrt (n t ^ 2 - z t / n t)).
  set (a t := n t * (1 - z t / 4) / u t).
  assert (Z : forall t, 0 <= t -> 0 < z t <= 1). { intros t Ht. split. apply exp_pos. unfold z. rewrite <- exp_0.
  destruct Ht as [h | <-]; [ left; apply exp_increasing; lra | right; f_equal; ring ]. }
  assert (n1 : forall t, 1 < n t) by (intros t; unfold n; pose proof (exp_pos (- (2) * t)); fold (z t) in *; lra).
  assert (W : forall t, w t ^ 2 = z t / n t). { intros t. specialize (n1 t). unfold w, z. unfold Rdiv.
  rewrite Rpow_mult_distr, pow_inv, pow2_sqrt by lra. f_equal. simpl. rewrite Rmult_1_r, <- exp_plus. f_equal. ring. }
  assert (U : forall t, 0 <= t -> 1 / 9 < n t ^ 2 - z t / n t). { intros t Ht. specialize (Z t Ht). specialize (n1 t).
  assert (z t / n t <= 8 / 9) by (apply Rle_div_l; unfold n; lra). nra. }
  assert (U2 : forall t, 0 <= t -> 0 < u t /\ u t ^ 2 = n t ^ 2 - z t / n t). { intros t Ht. specialize (U t Ht). split. apply sqrt_lt_R0. lra.
  apply pow2_sqrt. lra. }
  assert (N : forall t, 0 <= t -> nrm (u t) (w t) = n t). { intros t Ht. destruct (U2 t Ht) as [_ e]. unfold nrm. rewrite W, e.
  replace (_ + _) with (n t ^ 2) by ring. apply sqrt_pow2. specialize (n1 t). lra. }
  assert (Dz : forall t, rder z t (- 2 * z t)) by (intros t; apply rder_of; unfold z; auto_derive; trivial; ring).
  assert (Dn : forall t, rder n t (- z t / 4)) by (intros t; pose proof (Dz t); unfold n, Rdiv; eapply rder_eq; [ rds | field ]).
  assert (ez : forall t, z t = 8 * (n t - 1)) by (intros t; unfold n; field).
  assert (Dw : forall t, rder w t (- (w t / n t))).
  { intros t. specialize (n1 t). pose proof (pow2_sqrt (n t) ltac:(lra)) as e. assert (r0 : 0 < sqrt (n t)) by (apply sqrt_lt_R0; lra).
    eapply rder_eq.
    apply (rder_mult (fun t => exp (- t)) (fun t => / sqrt (n t))); [ rd | apply (rder_inv (fun t => sqrt (n t))); [ apply rder_root;
    [ apply Dn | lra ] | lra ] ].
    cbv beta. unfold w. rewrite ez. set (r := sqrt (n t)) in *. rewrite <- e. field. lra. }
  assert (Du : forall t, 0 <= t -> rder u t (a t - u t / n t)).
  { intros t Ht. specialize (n1 t). specialize (U t Ht). destruct (U2 t Ht) as [u0 e]. eapply rder_eq.
    apply (rder_root (fun t => n t ^ 2 - z t * / n t)); [ | unfold Rdiv in U; cbv beta; lra ].
    apply (rder_minus (fun t => n t ^ 2)); [ apply rder_pow, Dn | apply rder_mult; [ apply Dz | apply rder_inv; [ apply Dn | lra ] ] ].
    cbv beta. change (sqrt (n t ^ 2 - z t * / n t)) with (u t). unfold a. simpl pred. simpl INR. rewrite ez in *. field_simplify_eq; [ | lra ].
    rewrite e. field. lra. }
  assert (cz : forall t, continuity_pt z t) by (intros; unfold z; cont). assert (cn : forall t, continuity_pt n t) by (intros; unfold n, Rdiv; cont).
  assert (cu : forall t, 0 <= t -> continuity_pt u t).
  { intros t Ht. apply (cont_root (fun t => n t ^ 2 - z t * / n t)); [ | specialize (U t Ht); unfold Rdiv in U; cbv beta; lra ].
    apply (continuity_pt_minus (fun t => n t ^ 2)); [ cont | apply (continuity_pt_mult z (fun t => / n t)); [ cont | apply cont_inv;
    [ cont | specialize (n1 t); lra ] ] ]. }
  exists a, u, w. split; [ | split; [ | split; [ split | ] ] ].
  - intros t Ht. specialize (Z t Ht). specialize (n1 t). destruct (U2 t Ht) as [u0 e]. unfold a. apply Rlt_div_r; trivial. rewrite Rmult_1_l.
    apply Rnot_le_lt. intros b.
    assert (eq : z t / n t * n t = z t) by (field; lra). set (q := z t / n t) in *. assert (n98 : n t <= 9 / 8) by (unfold n; lra).
    assert (n t ^ 3 <= 3 / 2) by nra. assert (q0 : 0 < q) by nra.
    assert ((n t * (1 - z t / 4)) ^ 2 <= u t ^ 2) by (apply pow_incr; nra). nra.
  - intros t Ht. destruct (U2 t Ht). apply (continuity_pt_mult (fun t => n t * (1 - z t / 4)) (fun t => / u t)); [ unfold Rdiv;
    cont | apply cont_inv; [ auto | lra ] ].
  - intros. apply cu. lra.
  - intros t Ht. specialize (n1 t). assert (0 < sqrt (n t)) by (apply sqrt_lt_R0; lra).
    apply (continuity_pt_mult (fun t => exp (- t)) (fun t => / sqrt (n t))); [ cont | ].
    apply (cont_inv (fun t => sqrt (n t))); [ apply cont_root; [ auto | lra ] | lra ].
  - intros t Ht. specialize (n1 t). exists (- (u t / n t)), (- (w t / n t)). rewrite !Rminus_0_r. destruct (U2 t Ht) as [_ e].
    pose proof (W t) as eW. split; [ | split; [ | apply Dw ] ].
    + unfold coulomb. rewrite N by trivial. split.
      * right. transitivity ((u t ^ 2 + w t ^ 2) / n t ^ 2); [ field; lra | rewrite e, eW; field; lra ].
      * transitivity (- (u t ^ 2 + w t ^ 2) / n t); [ field; lra | rewrite e, eW; field; lra ].
    + eapply rder_eq. now apply Du. ring.
  - intros s t Hst. rewrite !N by lra. unfold n, z. assert (exp (- (2) * t) < exp (- (2) * s)) by (apply exp_increasing; lra). lra.
Qed.
