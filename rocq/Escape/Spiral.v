(* From Newton's law to the spiral: the four numbers of Prey.v of a motion with A > 1 hunt as they should (`escape_hunts`);
   so rho, p, A and exp(2 alpha) have their laws, each with its first correction, for every such motion. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Fate Alpha Formulas Late Prey.
Open Scope R_scope.

(* the rates of N and P from those of rho, p, A^2 and z *)
Lemma hunt_rates (r p e z : R -> R) t : 0 < z t -> 0 < p t < r t -> e t = (r t - p t) * (r t + p t) ->
  rder r t (2 * z t * / (1 + z t ^ 2) * p t) -> rder p t (2 * z t * / (1 + z t ^ 2) * r t - 1) -> rder e t (2 * p t) ->
  rder z t (z_rate (z t) ((r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2))) ->
  rder (fun t => r t * / (2 * e t * z t)) t (prey_rate (z t) (p t * / r t) (r t * / (2 * e t * z t)) ((r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2))) /\
  rder (fun t => (r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2)) t
    (predator_rate (z t) (r t * / (2 * e t * z t)) ((r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2))).
Proof.
  intros z0 pr ee Dr Dp De Dz. assert (e0 : 0 < e t) by (rewrite ee; nra). assert (zz : 0 < z t ^ 2) by nra. split.
  - eapply rder_eq. rdq. nra. unfold z_rate, prey_rate. set (P := (r t - p t) ^ 2 * / (4 * r t * p t * z t ^ 2)). field. repeat split; nra.
  - eapply rder_eq. rdq. apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; lra. unfold z_rate, predator_rate. rewrite ee. simpl INR. simpl pred. field. repeat split; nra.
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
Ltac conts := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

Lemma late s : 0 <= s -> 1 < E s -> exists T, s <= T /\ 1 <= T /\ forall t, T <= t -> 0 < p t /\ 0 < xi t /\ 1 < E t.
Proof.
  intros Hs HE. destruct (slips_for_ever x y u w S s Hs HE) as (T1 & T10 & N). pose proof (A_never_falls x y u w S) as up. pose proof (up s T1 ltac:(lra)).
  destruct (xi_grows x y u w S T1 0 ltac:(lra) ltac:(lra) N) as (T2 & T20 & HT). exists (Rmax 1 T2). pose proof (Rmax_l 1 T2). pose proof (Rmax_r 1 T2).
  split. lra. split. lra. intros t Ht. split. apply N; lra. split. apply HT; lra. pose proof (up s t ltac:(lra)). lra.
Qed.
Section Slips.
Variable t : R.
Hypothesis ht : 0 < t. Hypothesis p0 : 0 < p t. Hypothesis xi0 : 0 < xi t. Hypothesis E1 : 1 < E t.
Lemma shape : p t < rho t /\ 0 < rho t - ell t /\ E t = (rho t - p t) * (rho t + p t) /\ 0 < z_of t /\
  xi t = rho t * (2 * z_of t * / (1 + z_of t ^ 2)) /\ ell t = - (rho t * ((1 - z_of t ^ 2) * / (1 + z_of t ^ 2))) /\
  z_of t ^ 2 = (rho t + ell t) / (rho t - ell t).
Proof.
  destruct (xi_p x y u w t p0) as (_ & _ & e). assert (ee : E t = (rho t - p t) * (rho t + p t)). { transitivity (rho t ^ 2 - p t ^ 2). rewrite !nrm_sq. ring. ring. }
  pose proof (nrm_pos (x t) (y t)). assert (pr : p t < rho t) by (rewrite ee in E1; nra). unfold z_of. set (r := rho t) in *. set (z := xi t) in *. set (l := ell t) in *.
  assert (D : 0 < r - l) by nra. assert (z2 : (z * / (r - l)) ^ 2 = (r + l) / (r - l)). { rewrite Rpow_mult_distr. replace (z ^ 2) with ((r - l) * (r + l)) by (transitivity (r ^ 2 - l ^ 2); [ ring | lra ]). field. lra. }
  repeat split; trivial. { apply Rmult_lt_0_compat; trivial. now apply Rinv_0_lt_compat. } all: rewrite z2; field; lra.
Qed.
Lemma d_rho : rder (fun t => rho t) t (2 * z_of t * / (1 + z_of t ^ 2) * p t).
Proof.
  destruct shape as (pr & D & ee & z0 & xe & _). destruct (slip x y u w S t ltac:(lra) ltac:(lra)) as (X & Y & U & W). destruct (xi_p x y u w t p0) as (e1 & _).
  eapply rder_eq. rd. lra. rewrite <- e1, xe. field. split; nra.
Qed.
Lemma d_p : rder (fun t => p t) t (2 * z_of t * / (1 + z_of t ^ 2) * rho t - 1).
Proof. destruct shape as (pr & D & ee & z0 & xe & _). eapply rder_eq. apply (dp x y u w S t); lra. rewrite xe. ring. Qed.
Lemma d_E : rder (fun t => E t) t (2 * p t).
Proof.
  destruct (s_law _ _ _ _ S t ltac:(lra)) as (X & Y & fx & fy & [B P] & U & W). eapply rder_eq. rd. simpl. lra.
Qed.
Lemma d_z : rder z_of t (z_rate (z_of t) (P_of t)).
Proof.
  destruct shape as (pr & D & ee & z0 & _ & _ & z2). destruct (xi_p x y u w t p0) as (e1 & _ & e3). destruct (slip x y u w S t ltac:(lra) ltac:(lra)) as (X & Y & U & W).
  assert (Dr : rder (fun t => rho t) t (xi t * p t / rho t)). { eapply rder_eq. rd. lra. rewrite e1. reflexivity. }
  eapply rder_eq. unfold z_of. apply (rder_mult (fun t => xi t) (fun t => / (rho t - ell t))). apply (eq101 x y u w S t); lra.
  apply (rder_inv (fun t => rho t - ell t)); [ | lra ]. apply (rder_minus (fun t => rho t) (fun t => ell t)); [ exact Dr | apply (eq100 x y u w S t); lra ].
  cbv beta. assert (zP : z_of t ^ 2 * P_of t = (rho t - p t) ^ 2 / (4 * rho t * p t)) by (unfold P_of; field; lra). unfold z_rate.
  replace (2 * z_of t ^ 2 * (1 - (1 - z_of t ^ 2) * P_of t)) with (2 * z_of t ^ 2 - 2 * (z_of t ^ 2 * P_of t) * (1 - z_of t ^ 2)) by ring. rewrite zP, z2.
  set (r := rho t) in *. set (z := xi t) in *. set (l := ell t) in *. set (n := p t) in *. clearbody r z l n. field_simplify_eq; [ | lra ].
  assert (e : z ^ 2 = r ^ 2 - l ^ 2) by lra. ring [e].
Qed.
End Slips.
Theorem escape_hunts s : 0 <= s -> 1 < E s -> exists T, s <= T /\ hunt T z_of h_of N_of P_of /\ forall t, T <= t -> 0 < p t /\ 0 < xi t /\ 1 < E t.
Proof.
  intros Hs HE. destruct (late s Hs HE) as (T & Ts & T1 & HT). exists T. split; trivial. split; trivial. split; trivial.
  - intros t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & D & ee & z0 & _). assert (zz : 0 < z_of t ^ 2) by nra.
    split; trivial. unfold h_of, N_of, P_of. repeat split.
    + apply Rmult_lt_0_compat; [ | apply Rinv_0_lt_compat ]; lra.
    + apply (Rmult_lt_reg_r (rho t)); [ lra | rewrite Rmult_assoc, Rinv_l; lra ].
    + apply Rmult_lt_0_compat; [ lra | apply Rinv_0_lt_compat; nra ].
    + apply Rmult_lt_0_compat; [ nra | apply Rinv_0_lt_compat ]. assert (0 < rho t * p t) by nra. nra.
    + field. lra.
  - intros t Ht. destruct (HT t ltac:(lra)) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & D & ee & z0 & _). assert (zz : 0 < z_of t ^ 2) by nra.
    assert (Cr : continuity_pt (fun t => rho t) t) by conts. assert (Cp : continuity_pt (fun t => p t) t) by conts. assert (CE : continuity_pt (fun t => E t) t) by conts.
    assert (Cz : continuity_pt z_of t).
    { apply (continuity_pt_mult (fun t => xi t) (fun t => / (rho t - ell t))). apply (cont_xi x y u w S); lra. apply (cont_inv (fun t => rho t - ell t)); [ | lra ].
      apply (continuity_pt_minus (fun t => rho t)); trivial. apply (continuity_pt_mult (fun t => x t * w t - y t * u t) (fun t => / p t)). conts. apply (cont_inv (fun t => p t)); trivial. lra. }
    split; trivial. split.
    + apply (continuity_pt_mult (fun t => rho t) (fun t => / (2 * E t * z_of t))); trivial. apply (cont_inv (fun t => 2 * E t * z_of t)); [ | nra ].
      apply (continuity_pt_mult (fun t => 2 * E t)); trivial. apply (continuity_pt_mult (fun _ => 2)); trivial. contq.
    + apply (continuity_pt_mult (fun t => (rho t - p t) ^ 2) (fun t => / (4 * rho t * p t * z_of t ^ 2))).
      * apply (continuity_pt_comp (fun t => rho t - p t) (fun y => y ^ 2)); [ now apply (continuity_pt_minus (fun t => rho t)) | contq ].
      * apply (cont_inv (fun t => 4 * rho t * p t * z_of t ^ 2)). 2: { assert (0 < rho t * p t) by nra. nra. }
        apply (continuity_pt_mult (fun t => 4 * rho t * p t)). apply (continuity_pt_mult (fun t => 4 * rho t)); trivial. apply (continuity_pt_mult (fun _ => 4)); trivial. contq.
        apply (continuity_pt_comp z_of (fun y => y ^ 2)); trivial. contq.
  - intros t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & D & ee & z0 & _). split. apply d_z; trivial; lra.
    apply (hunt_rates (fun t => rho t) (fun t => p t) (fun t => E t) z_of t); trivial; try lra. apply d_rho; trivial; lra. apply d_p; trivial; lra. apply d_E; trivial; lra. apply d_z; trivial; lra.
  - apply is_lim_spec. intros e. pose proof (cond_pos e). set (n := 1 + / e). assert (n0 : 0 < / e) by (apply Rinv_0_lt_compat; lra). destruct (ratio_grows x y u w S s n Hs HE ltac:(unfold n; lra)) as (T2 & _ & H2).
    exists (Rmax T T2). intros t Ht. pose proof (Rmax_l T T2). pose proof (Rmax_r T T2). destruct (HT t ltac:(lra)) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & D & ee & z0 & _). destruct (H2 t ltac:(lra)) as [_ k].
    unfold h_of. replace (p t * / rho t - 1) with (- ((rho t - p t) / rho t)) by (field; lra). rewrite Rabs_Ropp, Rabs_pos_eq. 2: { apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]. }
    apply Rlt_div_l. lra. assert (e * n = e + 1) by (unfold n; field; lra). assert (e * (n * (rho t - p t)) <= e * p t) by (apply Rmult_le_compat_l; lra). nra.
Qed.

(* ---- the laws ---- *)
Section Laws.
Variable T : R.
Hypothesis H : hunt T z_of h_of N_of P_of.
Hypothesis HT : forall t, T <= t -> 0 < p t /\ 0 < xi t /\ 1 < E t.
Definition U t := / z_of t / t.
Definition n_of t := 4 / 3 * N_of t.
Definition g_of t := (1 + h_of t) / 2.
Definition o_of t := (1 - h_of t) * / z_of t / sqrt 2.
Lemma near_U : near U (- (3 * sqrt 2 / 4)). Proof. eapply near_eq. exact (lags _ _ _ _ _ H). unfold v0. field. Qed.
Lemma near_n : near n_of 0. Proof. exact (near_N _ _ _ _ _ H). Qed.
Lemma near_g1 : near g_of 0. Proof. exact (near_g _ _ _ _ _ H). Qed.
Lemma near_o : near o_of 0. Proof. exact (near_w _ _ _ _ _ H). Qed.
Lemma near_h1 : near h_of 0. Proof. exact (near_h _ _ _ _ _ H). Qed.
Lemma root2 : 0 < sqrt 2 /\ sqrt 2 ^ 2 = 2.
Proof. split. apply sqrt_lt_R0; lra. rewrite <- Rsqr_pow2. apply Rsqr_sqrt. lra. Qed.
(* everything at the moment t in z, N, h and (1 - h)/z *)
Lemma state t : T <= t -> 0 < t /\ 0 < z_of t /\ 0 < h_of t < 1 /\ 0 < N_of t /\ 0 < 1 - h_of t /\ p t = h_of t * rho t /\
  rho t = / (2 * N_of t * (1 + h_of t) * ((1 - h_of t) * / z_of t) * z_of t ^ 2) /\ E t = / (4 * N_of t ^ 2 * (1 + h_of t) * ((1 - h_of t) * / z_of t) * z_of t ^ 3).
Proof.
  intros Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & D & ee & z0 & _). destruct (h_pos _ _ _ _ _ H t Ht) as (_ & hh & N0 & _). pose proof (h_from _ _ _ _ _ H).
  split. lra. split; trivial. split; trivial. split; trivial. split. lra. split. { unfold h_of. field. lra. }
  unfold N_of, h_of. rewrite ee. split; field; repeat split; nra.
Qed.
Ltac by_state t Ht := destruct (state t Ht) as (t0 & z0 & hh & N0 & h1 & pe & re & Ee); destruct root2 as [s0 s2].
Theorem law_rho : near (fun t => rho t / right_escape_rho t) (- (3 * sqrt 2 / 2)).
Proof.
  apply (near_ext T (fun t => U t ^ 2 * / n_of t * / g_of t * / o_of t)).
  - intros t Ht. by_state t Ht. rewrite re. unfold right_escape_rho, U, n_of, g_of, o_of. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - pose proof near_U. pose proof near_n. pose proof near_g1. pose proof near_o. eapply near_eq. nears. simpl INR. field.
Qed.
Theorem law_p : near (fun t => p t / right_escape_rho t) (- (3 * sqrt 2 / 2)).
Proof.
  apply (near_ext T (fun t => h_of t * (rho t / right_escape_rho t))).
  - intros t Ht. by_state t Ht. rewrite pe. unfold Rdiv. ring.
  - eapply near_eq. apply near_mult. apply near_h1. apply law_rho. ring.
Qed.
Theorem law_E : near (fun t => E t / (sqrt 2 / 9 * t ^ 3)) (- (9 * sqrt 2 / 4)).
Proof.
  apply (near_ext T (fun t => U t ^ 3 * / n_of t ^ 2 * / g_of t * / o_of t)).
  - intros t Ht. by_state t Ht. rewrite Ee. unfold U, n_of, g_of, o_of. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - pose proof near_U. pose proof near_n. pose proof near_g1. pose proof near_o. eapply near_eq.
    nears. simpl INR. field.
Qed.
(* exp(2 alpha) = (rho + p)/(rho - p) *)
Theorem law_alpha : near (fun t => (rho t + p t) / (rho t - p t) / right_escape_twice_alpha_exp t) (- (3 * sqrt 2 / 4)).
Proof.
  apply (near_ext T (fun t => U t * g_of t * / o_of t)).
  - intros t Ht. by_state t Ht. destruct (HT t Ht) as (p0 & x0 & E1). destruct (shape t p0 x0 E1) as (pr & _).
    replace ((rho t + p t) / (rho t - p t)) with ((1 + h_of t) / (1 - h_of t)). 2: { rewrite pe. rewrite pe in pr. field. split; nra. }
    unfold right_escape_twice_alpha_exp, U, g_of, o_of. field_simplify_eq; [ ring [s2] | repeat split; lra ].
  - pose proof near_U. pose proof near_g1. pose proof near_o. eapply near_eq. nears. field.
Qed.
End Laws.
End Spiral.
