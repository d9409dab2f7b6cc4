(* A motion on the table until it comes to rest: alpha -> 0 and A -> sigma, and either psi -> 0, sigma < 1 and the laws of Arrives.v hold, or it comes
   straight in, with |psi| -> pi. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas Turntable TableMotions TableAngle Fate Alpha Stops Late Near Arrives.
Open Scope R_scope.

(* The particle slips from the moment 0 (any moment of its last slip with p < rho) until T, and is at rest then, at the distance sigma from the axis;
   A and alpha are
   the hyperbolic parameters (111), (112) of its motion, and psi, between - pi and pi, is the angle of its position with respect to its velocity.
   Dimensionless.
   «the particle at $(x,y)$ with the velocity $(u,w)$, with the hyperbolic parameters $A$ and $al$ and the angle $psi\in(-\pi,\pi]$ between velocity
   and position, slips
   until the moment $T$ and is at rest then, at the distance $sigma$ from the axis» *)
Record comes_to_rest (sigma T : R) (x y u w A al psi : R -> R) : Prop := {
  c_slips : 0 < T /\ forall t, 0 <= t < T -> 0 < nrm (u t) (w t);
  c_rest : nrm (u T) (w T) = 0 /\ nrm (x T) (y T) = sigma;
  c_A : forall t, 0 <= t -> hyperbolic (x t) (y t) (u t) (w t) (A t) (al t);
  c_psi : forall t, 0 <= t -> - PI < psi t <= PI /\ position_angle (x t) (y t) (u t) (w t) (psi t) }.

Lemma right_of_cont f t : continuity_pt f t -> right_continuous f t.
Proof.
  intros C e He. destruct (cont_eps f t e C He) as (d & d0 & H). exists d. split; trivial. intros r Hr. apply H. rewrite Rabs_pos_eq; lra.
Qed.
Lemma cont_local f g t d : 0 < d -> (forall r, t - d < r < t + d -> f r = g r) -> continuity_pt g t -> continuity_pt f t.
Proof.
  intros Hd H. apply continuity_pt_ext_loc. exists (mkposreal d Hd). intros r B. symmetry. apply H. change (Rabs (r - t) < d) in B.
  apply Rabs_def2 in B. lra.
Qed.

Section Motion.
Variables x y u w A al psi : R -> R.
Variables sigma T : R.
Hypothesis S : spin x y u w.
Hypothesis R : comes_to_rest sigma T x y u w A al psi.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Ltac conts := table S.

Lemma T_pos : 0 < T. Proof. apply R. Qed.
Lemma slipping t : 0 <= t < T -> 0 < p t. Proof. apply R. Qed.
Lemma angles t : 0 <= t -> position_angle (x t) (y t) (u t) (w t) (psi t). Proof. intros Ht. now apply (c_psi _ _ _ _ _ _ _ _ _ R). Qed.
Lemma E_is t : E t = rho t ^ 2 - p t ^ 2. Proof. rewrite !nrm_sq. ring. Qed.
Lemma parameters t : 0 <= t < T -> 0 < A t /\ 0 < al t /\ p t < rho t.
Proof.
  intros Ht. pose proof (slipping t Ht) as p0. destruct (c_A _ _ _ _ _ _ _ _ _ R t ltac:(lra)) as [k1 k2]. unfold eq111_p, eq112_rho in *.
  pose proof (nrm_pos (x t) (y t)).
  pose proof (cosh_pos (al t)). rewrite k1 in p0. assert (A0 : 0 < A t) by (destruct (Rtotal_order (A t) 0) as [k | [k | k]]; trivial;
  [ nra | rewrite k in p0; lra ]). split; trivial.
  assert (s0 : 0 < sinh (al t)) by nra. split. { apply Rnot_le_lt. intros k.
  assert (sinh (al t) <= sinh 0) by (destruct k as [k | ->]; [ left; now apply sinh_lt | lra ]). rewrite sinh_0 in *. lra. }
  rewrite k1, k2. pose proof (cosh2 (al t)). apply Rmult_lt_compat_l; trivial. nra.
Qed.
Lemma E_pos t : 0 <= t -> 0 < E t.
Proof.
  intros Ht. pose proof (A_never_falls x y u w S 0 t ltac:(lra)). pose proof T_pos. destruct (parameters 0 ltac:(lra)) as (_ & _ & k).
  rewrite (E_is 0) in *. pose proof (nrm_pos (u 0) (w 0)). nra.
Qed.
Lemma sigma_pos : 0 < sigma.
Proof. pose proof (E_pos T ltac:(pose proof T_pos; lra)) as k. destruct (c_rest _ _ _ _ _ _ _ _ _ R) as [z e]. rewrite E_is, z, e in k.
  pose proof (nrm_pos (x T) (y T)). nra. Qed.
Lemma A_is t : 0 <= t -> A t = sqrt (E t).
Proof.
  intros Ht. destruct (c_A _ _ _ _ _ _ _ _ _ R t Ht) as [k1 k2]. pose proof (nrm_pos (x t) (y t)). pose proof (cosh_pos (al t)). rewrite k2 in *.
  unfold eq111_p, eq112_rho in *.
  assert (e : E t = A t ^ 2) by (rewrite E_is, k1, k2, !Rpow_mult_distr, cosh2; ring). rewrite e. symmetry. apply sqrt_pow2. nra.
Qed.
Lemma al_is t : 0 <= t -> al t = arcsinh (p t * / sqrt (E t)).
Proof.
  intros Ht. rewrite <- A_is by trivial. destruct (c_A _ _ _ _ _ _ _ _ _ R t Ht) as [-> _]. unfold eq111_p.
  assert (0 < A t) by (rewrite A_is by trivial; now apply sqrt_lt_R0, E_pos).
  replace (A t * sinh (al t) * / A t) with (sinh (al t)) by (field; lra). symmetry. apply arcsinh_sinh.
Qed.
Lemma cont_A t : 0 < t -> continuity_pt A t /\ continuity_pt al t.
Proof.
  intros Ht. assert (cA : continuity_pt (fun t => sqrt (E t)) t) by (apply cont_root; [ conts | left; apply E_pos; lra ]).
  split. { apply (cont_local _ (fun t => sqrt (E t)) t t Ht); trivial. intros; apply A_is; lra. }
  apply (cont_local _ (fun t => arcsinh (p t * / sqrt (E t))) t t Ht). { intros; apply al_is; lra. }
  apply (continuity_pt_comp (fun t => p t * / sqrt (E t)) arcsinh). 2: { apply derivable_continuous_pt. eexists. apply derivable_pt_lim_arcsinh. }
  apply (continuity_pt_mult (fun t => p t) (fun t => / sqrt (E t))). conts. apply cont_inv; trivial. apply Rgt_not_eq, sqrt_lt_R0, E_pos. lra.
Qed.
Lemma at_the_end : A T = sigma /\ al T = 0.
Proof.
  pose proof T_pos. destruct (c_rest _ _ _ _ _ _ _ _ _ R) as [z e]. pose proof (nrm_pos (x T) (y T)). split.
  - rewrite A_is, E_is, z, e by lra. replace (sigma ^ 2 - 0 ^ 2) with (sigma ^ 2) by ring. apply sqrt_pow2. lra.
  - rewrite al_is, z, Rmult_0_l by lra. replace 0 with (sinh 0) at 1 by apply sinh_0. apply arcsinh_sinh.
Qed.
Lemma A_to : left_lim A T sigma /\ left_lim al T 0.
Proof. destruct (cont_A T T_pos) as [c1 c2]. destruct at_the_end as [<- <-]. split; now apply ll_cont. Qed.
Lemma rho_to_sigma : left_lim (fun t => rho t) T sigma.
Proof. pose proof T_pos. destruct (c_rest _ _ _ _ _ _ _ _ _ R) as [_ <-]. apply (ll_cont (fun t => rho t)). conts. Qed.

(* psi -> 0, and then it stops inside rho = 1, or |psi| -> pi *)
Lemma psi_ends : (left_lim psi T 0 /\ sigma < 1) \/ left_lim (fun t => Rabs (psi t)) T PI.
Proof.
  pose proof T_pos as T0. pose proof sigma_pos as s0. destruct (c_rest _ _ _ _ _ _ _ _ _ R) as [z e]. pose proof rho_to_sigma as lr.
  pose proof PI_RGT_0 as pp.
  assert (cs : forall t, 0 <= t < T -> xi t = rho t * cos (psi t)) by (intros t Ht; apply (xi_psi x y u w psi angles);
  [ lra | pose proof (slipping t Ht); lra ]).
  assert (c : forall l, left_lim (fun t => xi t) T l -> left_lim (fun t => cos (psi t)) T (l / sigma)).
  { intros l Hl. apply (ll_soon (fun t => xi t / rho t)). { apply (soon_after 0 T _ T0). intros t Ht. rewrite cs by trivial.
  destruct (parameters t Ht) as (_ & _ & k). pose proof (nrm_pos (u t) (w t)). field. lra. }
    ll. lra. }
  assert (ab : forall t, 0 <= t < T -> cos (Rabs (psi t)) = cos (psi t) /\ 0 <= Rabs (psi t) <= PI).
  { intros t Ht. destruct (c_psi _ _ _ _ _ _ _ _ _ R t ltac:(lra)) as [[b1 b2] _]. unfold Rabs.
  destruct (Rcase_abs (psi t)); [ rewrite cos_neg | ]; split; trivial; lra. }
  assert (conv : forall m, (m = 0 \/ m = PI) -> left_lim (fun t => cos (psi t)) T (cos m) -> left_lim (fun t => Rabs (psi t)) T m).
  { intros m Hm L eps He. set (d := Rmin eps 1). assert (d0 : 0 < d <= 1) by (split; [ apply Rmin_pos; lra | apply Rmin_r ]).
  assert (d1 : d <= eps) by apply Rmin_l. pose proof PI2_1 as P2.
    destruct (soon_from 0 T _ T0 (soon_near _ _ _ (1 - cos d) L ltac:(enough (cos d < cos 0) by (rewrite cos_0 in *; lra); apply cos_decreasing_1;
    lra))) as (r & Hr & K).
    exists (T - r). split. lra. intros t Ht. specialize (K t ltac:(lra)). cbv beta in K. destruct (ab t ltac:(lra)) as [e1 b]. rewrite <- e1 in K.
    apply Rabs_def2 in K. set (v := Rabs (psi t)) in *.
    destruct Hm as [-> | ->].
    - rewrite cos_0 in K. rewrite Rminus_0_r, Rabs_pos_eq by lra. apply Rlt_le_trans with d; trivial. apply Rnot_le_lt. intros k.
      assert (cos v <= cos d) by (apply cos_decr_1; lra). lra.
    - rewrite cos_PI in K. rewrite Rabs_left1 by lra. apply Rlt_le_trans with d; trivial. apply Rnot_le_lt. intros k.
      assert (cos (PI - d) <= cos v) by (apply cos_decr_1; lra).
      replace (PI - d) with (- (d - PI)) in H by ring. rewrite cos_neg in H. replace (d - PI) with (d + - PI) in H by ring.
      rewrite cos_plus, cos_neg, sin_neg, cos_PI, sin_PI in H. lra. }
  pose proof (stops_along x y u w S T T0 z slipping) as a. rewrite e in a. destruct a as [a | a].
  - left. split.
    + pose proof (conv 0 ltac:(now left)) as k. rewrite cos_0 in k. specialize (k ltac:(eapply ll_eq; [ apply (c _ a) | field; lra ])). intros q Hq.
      destruct (k q Hq) as (d & d0 & H). exists d. split; trivial.
      intros t Ht. specialize (H t Ht). rewrite Rminus_0_r in *. rewrite Rabs_Rabsolu in H. exact H.
    + rewrite <- e. apply (stops_inside x y u w S T T0 z slipping); rewrite e; trivial.
  - right. apply conv. now right. rewrite cos_PI. eapply ll_eq. apply (c _ a). field. lra.
Qed.
Lemma arriving : left_lim psi T 0 -> exists s, 0 < s < T /\ arrives sigma s T A al psi.
Proof.
  intros L. pose proof T_pos as T0. pose proof sigma_pos as s0. pose proof PI2_1 as P2.
  destruct (soon_from 0 T _ T0 (soon_near _ _ _ 1 L Rlt_0_1)) as (s & Hs & H).
  exists ((s + T) / 2). split. lra.
  assert (near0 : forall t, s <= t < T -> - (PI / 2) < psi t < PI / 2) by (intros t Ht; specialize (H t Ht); cbv beta in H; rewrite Rminus_0_r in H;
  apply Rabs_def2 in H; lra).
  assert (cpsi : forall t, s < t < T -> continuity_pt psi t).
  { intros t Ht. set (d := Rmin (t - s) (T - t)). assert (d0 : 0 < d) by (apply Rmin_pos; lra). pose proof (Rmin_l (t - s) (T - t)).
  pose proof (Rmin_r (t - s) (T - t)).
    apply (cont_local _ (fun t => asin (- ell t * / rho t)) t d d0).
    - intros r Hr. fold d in H0, H1. pose proof (near0 r ltac:(lra)) as n. destruct (parameters r ltac:(lra)) as (_ & _ & k).
      pose proof (nrm_pos (u r) (w r)). pose proof (slipping r ltac:(lra)).
      destruct (xi_psi x y u w psi angles r ltac:(lra) ltac:(lra)) as [_ ->].
      replace (- (- rho r * sin (psi r)) * / rho r) with (sin (psi r)) by (field; lra). symmetry. apply asin_sin. lra.
    - destruct (parameters t ltac:(lra)) as (_ & _ & k). pose proof (slipping t ltac:(lra)).
      apply (continuity_pt_comp (fun t => - ell t * / rho t) asin).
      + apply (continuity_pt_mult (fun t => - ell t) (fun t => / rho t)); [ apply (continuity_pt_opp (fun t => ell t)),
        (continuity_pt_mult (fun t => x t * w t - y t * u t) (fun t => / p t)); [ conts | ] | ];
          [ apply (cont_inv (fun t => p t)) | apply (cont_inv (fun t => rho t)) ]; try conts; lra.
      + destruct (xi_psi x y u w psi angles t ltac:(lra) ltac:(lra)) as [_ ->].
        replace (- (- rho t * sin (psi t)) * / rho t) with (sin (psi t)) by (field; lra).
        apply derivable_continuous_pt, derivable_pt_asin. pose proof (near0 t ltac:(lra)) as n. pose proof (cos_gt_0 (psi t) ltac:(lra) ltac:(lra)).
        pose proof (sin2_cos2 (psi t)) as q. unfold Rsqr in q. split; nra. }
  assert (K : forall t, 0 <= t -> forall r, t <= r -> hyperbolic (x r) (y r) (u r) (w r) (A r) (al r)) by (intros t Ht r Hr;
  apply (c_A _ _ _ _ _ _ _ _ _ R); lra).
  split; try lra; try apply A_to; trivial.
  - intros t Ht. destruct (parameters t ltac:(lra)) as (h1 & h2 & _). now split.
  - intros t Ht. destruct (cont_A t ltac:(lra)). auto with real. repeat split; trivial. apply cpsi. lra.
  - intros t Ht. pose proof (slipping t ltac:(lra)) as p0. destruct (parameters t ltac:(lra)) as (_ & _ & k). pose proof (nrm_pos (u t) (w t)).
    pose proof (K t ltac:(lra)) as Kt. pose proof angles as P.
    assert (c : eq110_case (p t) (rho t) < 0) by (unfold eq110_case; nra). repeat split.
    + eapply eq_113; try eassumption; try lra; auto.
    + eapply eq_114; try eassumption; try lra; auto.
    + eapply eq_115; try eassumption; try lra; auto. apply right_of_cont, cpsi. lra.
Qed.
End Motion.

(* ---- motions that do so ---- *)
Lemma angle_chosen x y u w : { psi | - PI < psi <= PI /\ position_angle x y u w psi }.
Proof.
  destruct (Req_EM_T (nrm x y * nrm u w + (x * u + y * w)) 0) as [z | z].
  - exists PI. pose proof PI_RGT_0. split. lra. apply angle_iff. unfold angle. rewrite cos_PI, sin_PI. pose proof (nrm_sq x y) as e1.
    pose proof (nrm_sq u w) as e2.
    assert (q : (x * w - y * u) ^ 2 = 0). { transitivity (nrm x y ^ 2 * nrm u w ^ 2 - (x * u + y * w) ^ 2). rewrite e1, e2. ring.
    replace (x * u + y * w) with (- (nrm x y * nrm u w)) by lra. ring. }
    split. lra. nra.
  - destruct (angle_exists x y u w) as (psi & P & Q). exists psi. split; trivial. rewrite (Q z). unfold TableLaws.half_angle.
    pose proof (atan_bound ((y * u - x * w) / (nrm x y * nrm u w + (x * u + y * w)))). lra.
Qed.
(* who slips with p < rho until T, and does not come in at first, has psi -> 0 *)
Lemma rest_of_motion x y u w T : spin x y u w -> 0 < T -> nrm (u T) (w T) = 0 -> (forall t, 0 <= t < T -> 0 < nrm (u t) (w t)) ->
  nrm (u 0) (w 0) < nrm (x 0) (y 0) -> 0 <= x 0 * u 0 + y 0 * w 0 -> exists A al psi, comes_to_rest (nrm (x T) (y T)) T x y u w A al psi /\
  left_lim psi T 0.
Proof.
  intros S T0 z N Hp Hx. destruct (with_A x y u w S Hp) as (A & al & K). set (psi t := proj1_sig (angle_chosen (x t) (y t) (u t) (w t))).
  assert (R : comes_to_rest (nrm (x T) (y T)) T x y u w A al psi). { split; auto. intros t _.
  apply (proj2_sig (angle_chosen (x t) (y t) (u t) (w t))). }
  exists A, al, psi. split; trivial. destruct (psi_ends x y u w A al psi _ T S R) as [[L _] | L]; trivial. exfalso. pose proof PI2_1 as P2.
  destruct (ll_from _ 0 T _ 1 T0 L Rlt_0_1) as (s & Hs & H). specialize (H s ltac:(lra)). cbv beta in H.
  pose proof (xi_never_falls x y u w S 0 s ltac:(lra) ltac:(intros; apply N; lra)) as up. pose proof (N s ltac:(lra)) as ps.
  pose proof (N 0 ltac:(lra)).
  assert (x0 : 0 <= (x 0 * u 0 + y 0 * w 0) * / nrm (u 0) (w 0)) by (apply Rmult_le_pos; [ trivial | left; apply Rinv_0_lt_compat; lra ]).
  destruct (xi_psi x y u w psi (angles x y u w A al psi _ T R) s ltac:(lra) ltac:(lra)) as [e _]. rewrite e in up.
  destruct (parameters x y u w A al psi _ T R s ltac:(lra)) as (_ & _ & k).
  destruct (c_psi _ _ _ _ _ _ _ _ _ R s ltac:(lra)) as [B _]. assert (cos (psi s) < 0).
  { unfold Rabs in H. destruct (Rcase_abs (psi s)). rewrite <- cos_neg. apply cos_lt_0; lra. apply cos_lt_0; lra. } nra.
Qed.
(* who starts with rho + p < 1, too *)
Lemma rest_of_start x0 y0 u0 w0 : 0 < nrm u0 w0 < nrm x0 y0 -> nrm x0 y0 + nrm u0 w0 < 1 -> 0 <= x0 * u0 + y0 * w0 -> exists x y u w A al psi sigma T,
  spin x y u w /\ comes_to_rest sigma T x y u w A al psi /\ left_lim psi T 0 /\ nrm x0 y0 ^ 2 - nrm u0 w0 ^ 2 <= sigma ^ 2 /\
  sigma <= nrm x0 y0 + nrm u0 w0.
Proof.
  intros Hp Hm Hx. destruct (table_exists x0 y0 u0 w0) as (x & y & u & w & S & <- & <- & <- & <-).
  destruct (first_stop x y u w S ltac:(lra)) as [N | (T & T0 & z & N)].
  - exfalso. destruct (caught x y u w S 0 _ (Rle_refl 0) Hm (Rle_refl _)) as (z1 & z2 & _). set (t := 0 + _) in *. assert (t0 : 0 <= t).
    { unfold t. rewrite Rplus_0_l. apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]. } specialize (N t t0).
    rewrite (at_rest u w t z1 z2) in N. lra.
  - destruct (rest_of_motion x y u w T S T0 z N ltac:(lra) Hx) as (A & al & psi & R & L). exists x, y, u, w, A, al, psi, (nrm (x T) (y T)), T.
    do 3 (split; trivial). split.
    + pose proof (A_never_falls x y u w S 0 T ltac:(lra)) as up. rewrite <- !nrm_sq, z in up. lra.
    + pose proof (m_falls x y u w S 0 T ltac:(lra) Hm) as k. rewrite z in k. lra.
Qed.
