(* From Newton's law to the spiral: the four numbers of Prey.v of a motion with A > 1 hunt as they should; so rho, p, A^2 and cos psi have
   their laws, each with its first correction, for every such motion (`escape_laws`). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Analysis Sphere Fate Formulas Late Alpha Prey.
Open Scope R_scope.

Lemma root2 : 0 < sqrt 2 /\ sqrt 2 ^ 2 = 2.
Proof. split. apply sqrt_lt_R0; lra. apply root_sq. lra. Qed.
(* the rates of N and P from those of rho, p, A^2 and z *)
Lemma hunt_rates (r p e z : R -> R) t : 0 < z t -> 0 < p t < r t -> e t = (r t - p t) * (r t + p t) ->
  rder r t (2 * z t * / (1 + z t ^ 2) * p t) -> rder p t (2 * z t * / (1 + z t ^ 2) * r t - 1) -> rder e t (2 * p t) ->
  let N t := r t * / (2 * e t * z t) in let P t := (r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2) in rder z t (z_rate (z t) (P t)) ->
  rder N t (prey_rate (z t) (p t * / r t) (N t) (P t)) /\ rder P t (predator_rate (z t) (N t) (P t)).
Proof.
  intros z0 pr ee Dr Dp De N P Dz. assert (e0 : 0 < e t) by (rewrite ee; nra). assert (zz : 0 < z t ^ 2) by nra. unfold N, P in *. split.
  - eapply rder_eq. rdq. nra. unfold z_rate, prey_rate. set (P' := (r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2)). field. repeat split; nra.
  - eapply rder_eq. rdq. apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; lra. unfold z_rate, predator_rate. rewrite ee. simpl INR. simpl pred.
    field. repeat split; nra.
Qed.

Section Spiral.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Definition z_of t := xi t * / (rho t - ell t).
Definition h_of t := p t * / rho t.
Definition N_of t := rho t * / (2 * E t * z_of t).
Definition P_of t := (rho t - p t) ^ 2 * / (4 * rho t * p t * z_of t ^ 2).

Lemma late s : 0 <= s -> 1 < E s -> exists T, s <= T /\ 1 <= T /\ forall t, T <= t -> 0 < p t /\ 0 < xi t /\ 1 < E t.
Proof.
  intros Hs HE. destruct (slips_for_ever x y u w S s Hs HE) as (T1 & T10 & N). pose proof (A_never_falls x y u w S) as up.
    pose proof (up s T1 ltac:(lra)).
  destruct (xi_grows x y u w S T1 0 ltac:(lra) ltac:(lra) N) as (T2 & T20 & HT). exists (Rmax 1 T2). pose proof (Rmax_l 1 T2).
    pose proof (Rmax_r 1 T2).
  repeat split; try lra. apply N; lra. apply HT; lra. pose proof (up s t ltac:(lra)). lra.
Qed.
Section Slips.
Variable t : R.
Hypothesis ht : 0 < t. Hypothesis p0 : 0 < p t. Hypothesis xi0 : 0 < xi t. Hypothesis E1 : 1 < E t.
Lemma shape : p t < rho t /\ 0 < rho t - ell t /\ E t = (rho t - p t) * (rho t + p t) /\ 0 < z_of t /\
  xi t = rho t * (2 * z_of t * / (1 + z_of t ^ 2)) /\ ell t = - (rho t * ((1 - z_of t ^ 2) * / (1 + z_of t ^ 2))) /\
  z_of t ^ 2 = (rho t + ell t) / (rho t - ell t).
Proof.
  destruct (xi_p x y u w t p0) as (_ & _ & e). pose proof (slow x y u w t ltac:(lra)) as pr. pose proof (E_is x y u w t) as ee. unfold z_of.
  set (r := rho t) in *. set (z := xi t) in *. set (l := ell t) in *. assert (D : 0 < r - l) by nra.
  assert (z2 : (z * / (r - l)) ^ 2 = (r + l) / (r - l)) by (field_simplify_eq; [ | lra ]; lra).
  repeat split; trivial. rewrite ee; ring. { apply Rmult_lt_0_compat; trivial. now apply Rinv_0_lt_compat. } all: rewrite z2; field; lra.
Qed.
Lemma hunt_at : (1 - h_of t) ^ 2 = 4 * P_of t * h_of t * z_of t ^ 2 /\ 0 < h_of t < 1 /\ 0 < N_of t /\ 0 < P_of t /\ rder z_of t (z_rate (z_of t)
    (P_of t)) /\
  rder N_of t (prey_rate (z_of t) (h_of t) (N_of t) (P_of t)) /\ rder P_of t (predator_rate (z_of t) (N_of t) (P_of t)) /\
  continuity_pt z_of t /\ continuity_pt N_of t /\ continuity_pt P_of t.
Proof.
  destruct shape as (pr & D & ee & z0 & xe & _ & z2). destruct (xi_p x y u w t p0) as (e1 & _ & e3). assert (zz : 0 < z_of t ^ 2) by nra.
  assert (rp : 0 < rho t * p t) by nra. pose proof (Rinv_0_lt_compat (rho t) ltac:(lra)).
  assert (Dr : rder (fun t => rho t) t (xi t * p t / rho t)).
  { eapply rder_eq. apply (rder_rho x y u w S t); lra. rewrite e1. reflexivity. }
  pose proof (d_p x y u w S t ltac:(lra) p0) as Dp. pose proof (E_rate x y u w S t ltac:(lra)) as DE.
  assert (Dz : rder z_of t (z_rate (z_of t) (P_of t))).
  { eapply rder_eq. unfold z_of. apply (rder_mult (fun t => xi t) (fun t => / (rho t - ell t))). apply (d_xi x y u w S t); lra.
    apply (rder_inv (fun t => rho t - ell t)); [ | lra ].
      apply (rder_minus (fun t => rho t) (fun t => ell t)); [ exact Dr | apply (eq100 x y u w S t); lra ].
    cbv beta. assert (zP : z_of t ^ 2 * P_of t = (rho t - p t) ^ 2 / (4 * rho t * p t)) by (unfold P_of; field; lra). unfold z_rate.
    replace (2 * z_of t ^ 2 * (1 - (1 - z_of t ^ 2) * P_of t)) with (2 * z_of t ^ 2 - 2 * (z_of t ^ 2 * P_of t) * (1 - z_of t ^ 2)) by ring.
    rewrite zP, z2. set (r := rho t) in *. set (z := xi t) in *. set (l := ell t) in *. set (n := p t) in *. clearbody r z l n.
    field_simplify_eq; [ | lra ]. assert (e : z ^ 2 = r ^ 2 - l ^ 2) by lra. ring [e]. }
  assert (Cz : continuity_pt z_of t) by (unfold z_of; conts S).
  split. { unfold h_of, P_of. field. lra. } split. { unfold h_of. split. nra. apply (Rlt_div_l (p t) 1 (rho t)); lra. }
  split. { unfold N_of. apply Rmult_lt_0_compat; [ lra | apply Rinv_0_lt_compat; nra ]. }
  split. { unfold P_of. apply Rmult_lt_0_compat; [ nra | apply Rinv_0_lt_compat; nra ]. } split; trivial.
  destruct (hunt_rates (fun t => rho t) (fun t => p t) (fun t => E t) z_of t) as [DN DP]; trivial; try lra.
  { eapply rder_eq. exact Dr. rewrite xe. field. split; nra. } { eapply rder_eq. exact Dp. rewrite xe. ring. }
  repeat (split; trivial); unfold N_of, P_of; conts S; apply Rgt_not_eq; nra.
Qed.
End Slips.
Lemma ratio s T : 0 <= s -> 1 < E s -> (forall t, T <= t -> 0 < p t /\ 0 < xi t /\ 1 < E t) -> 1 <= T -> is_lim h_of p_infty 1.
Proof.
  intros Hs HE HT T1. apply is_lim_spec. intros e. pose proof (cond_pos e) as e0. pose proof (Rinv_0_lt_compat _ e0).
  destruct (ratio_grows x y u w S s (1 + / e) Hs HE ltac:(lra)) as (T2 & _ & H2). exists (Rmax T T2). intros t Ht. pose proof (Rmax_l T T2).
    pose proof (Rmax_r T T2).
  destruct (HT t ltac:(lra)) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & _). destruct (H2 t ltac:(lra)) as [_ k].
  unfold h_of. replace (p t * / rho t - 1) with (- ((rho t - p t) / rho t)) by (field; lra). rewrite Rabs_Ropp, Rabs_pos_eq.
  2: { apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]. }
  apply Rlt_div_l. lra. apply (Rmult_le_compat_l e) in k; [ | lra ].
    replace (e * ((1 + / e) * (rho t - p t))) with ((e + 1) * (rho t - p t)) in k by (field; lra). nra.
Qed.

(* the laws of every motion with A > 1 *)
Theorem escape_laws s : 0 <= s -> 1 < E s -> exists T, s <= T /\ 1 <= T /\ (forall t, T <= t -> 0 < p t /\ 0 < xi t /\ 1 < E t) /\
  near (fun t => rho t / right_escape_rho t) (- (3 * sqrt 2 / 2)) /\ near (fun t => p t / right_escape_rho t) (- (3 * sqrt 2 / 2)) /\
  near (fun t => E t / (sqrt 2 / 9 * t ^ 3)) (- (9 * sqrt 2 / 4)) /\ near (fun t => xi t / rho t / right_escape_lag t) (3 * sqrt 2 / 4) /\
  tends (fun t => t * (1 + ell t / rho t)) 0.
Proof.
  intros Hs HE. destruct (late s Hs HE) as (T & Ts & T1 & HT). exists T. do 3 (split; trivial). destruct root2 as [s0 s2].
  assert (H : hunt T z_of h_of N_of P_of).
  { split; trivial. 4: now apply (ratio s T).
    all: intros t Ht; destruct (HT t ltac:(lra)) as (p0 & x0 & E1); destruct (shape t p0 x0 E1) as (_ & _ & _ & z0 & _);
    pose proof (hunt_at t ltac:(lra) p0 x0 E1) as K; tauto. }
  pose proof (lags _ _ _ _ _ H) as NU. pose proof (near_N _ _ _ _ _ H) as Nn. pose proof (near_P _ _ _ _ _ H) as NP.
    pose proof (near_h _ _ _ _ _ H) as Nh.
  pose proof (z_zero _ _ _ _ _ H) as Lz. pose proof (zt_limit _ _ _ _ _ H) as Lt. cbv beta in NU, Nn, NP, Lt.
  assert (Ng : near (fun t => (1 + h_of t) / 2) 0).
  { eapply near_eq. apply (near_comp (fun y => (1 + y) / 2) (/ 2) h_of 0); [ auto_derive; [ trivial | lra ] | lra | exact Nh ]. ring. }
  assert (state : forall t, T <= t -> 0 < t /\ 0 < z_of t /\ 0 < h_of t < 1 /\ 0 < N_of t /\ 0 < P_of t /\ 0 < rho t /\ p t = h_of t * rho t /\
    (1 - h_of t) ^ 2 = 4 * P_of t * h_of t * z_of t ^ 2 /\ rho t = / (2 * N_of t * (1 + h_of t) * (1 - h_of t) * z_of t) /\ E t = rho t / (2 * N_of
      t * z_of t)).
  { intros t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & D & ee & z0 & _).
    destruct (h_pos _ _ _ _ _ H t Ht) as (_ & hh & N0 & P0 & e). repeat (split; [ lra || trivial | ]). { unfold h_of. field. lra. }
    all: unfold N_of, h_of; rewrite ee; field; repeat split; nra. }
  assert (law_rho : near (fun t => rho t / right_escape_rho t) (- (3 * sqrt 2 / 2))).
  { apply (near_ext T (fun t => sqrt ((/ z_of t / t) ^ 4 * / (4 / 3 * N_of t) ^ 2 * / ((1 + h_of t) / 2) ^ 2 * / (2 * P_of t) * / h_of t))).
    - intros t Ht. destruct (state t Ht) as (t0 & z0 & hh & N0 & P0 & r0 & _ & e & re & _). assert (t2 : 0 < t ^ 2) by nra. unfold right_escape_rho.
      assert (R0 : 0 < rho t / (1 / (3 * sqrt 2) * t ^ 2)) by (apply Rdiv_lt_0_compat; trivial; apply Rmult_lt_0_compat; trivial;
        apply Rdiv_lt_0_compat; lra).
      rewrite <- (sqrt_pow2 (rho t / _)) by lra. f_equal. rewrite re.
        transitivity (18 * / (t ^ 4 * 4 * N_of t ^ 2 * (1 + h_of t) ^ 2 * z_of t ^ 2 * (1 - h_of t) ^ 2)).
      rewrite e. field. repeat split; lra. field_simplify_eq; [ ring [s2] | repeat split; lra ].
    - eapply near_eq. nears. simpl INR. unfold v0. field. }
  split; trivial. split. { apply (near_ext T (fun t => h_of t * (rho t / right_escape_rho t))).
    - intros t Ht. destruct (state t Ht) as (_ & _ & _ & _ & _ & _ & -> & _). unfold Rdiv. ring.
    - eapply near_eq. nears. ring. }
  split. { apply (near_ext T (fun t => rho t / right_escape_rho t * (/ z_of t / t) * / (4 / 3 * N_of t))).
    - intros t Ht. destruct (state t Ht) as (t0 & z0 & hh & N0 & P0 & r0 & _ & e & _ & ->). unfold right_escape_rho.
      field_simplify_eq; [ ring [s2] | repeat split; lra ].
    - eapply near_eq. nears. unfold v0. field. }
  assert (angles : forall t, T <= t -> 0 < t /\ 0 < z_of t /\ xi t / rho t = 2 * z_of t * / (1 + z_of t ^ 2) /\ 1 + ell t / rho t = 2 * z_of t ^ 2 *
    / (1 + z_of t ^ 2)).
  { intros t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & _ & _ & z0 & -> & -> & _). repeat (split; [ lra | ]).
    split; field; split; nra. }
  split.
  - apply (near_ext T (fun t => / (/ z_of t / t) * / (1 + z_of t ^ 2))).
    + intros t Ht. destruct (angles t Ht) as (t0 & z0 & -> & _). unfold right_escape_lag. field. repeat split; nra.
    + eapply near_eq. apply near_mult; [ nears | ]. apply (near_inv (fun t => 1 + z_of t ^ 2)), (near_small T _ (fun t => z_of t * t * z_of t) 0).
      limit; ring.
      intros t Ht. field. lra. unfold v0. field.
  - apply (tends_ext T (fun t => 2 * (z_of t * t) * z_of t * / (1 + z_of t ^ 2))). { intros t Ht. destruct (angles t Ht) as (t0 & z0 & _ & ->).
    ring. } limit. lra. field.
Qed.
End Spiral.
