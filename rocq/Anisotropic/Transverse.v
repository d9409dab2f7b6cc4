(* 2.4: the velocity across the drive, under a friction that depends on the direction of the velocity: it falls to 0, for its square
   times a logarithm of the time never grows. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn.
Open Scope R_scope.

(* (1) under a drive along x, with a friction against the velocity whose size k depends on the velocity (so on its direction);
   what holds the particle while it rests is left open. «$(vx,vy)$ is a motion under the acceleration $(Ax,0)$, with a friction against the
   velocity $u$ of the size $k(u_x,u_y)$» *)
Record directed (k : R -> R -> R) (Ax vx vy : R -> R) : Prop := {
  d_cx : forall t, 0 < t -> continuity_pt vx t;
  d_cy : forall t, 0 < t -> continuity_pt vy t;
  d_law : forall t, 0 <= t -> exists fx fy, rder vx t (fx - Ax t) /\ rder vy t fy /\
    nrm (vx t) (vy t) * fx = - k (vx t) (vy t) * vx t /\ nrm (vx t) (vy t) * fy = - k (vx t) (vy t) * vy t }.

Lemma across_directed k k0 a Ax vx vy : 0 < k0 -> (forall ux uy, k0 <= k ux uy) -> (forall t, 0 <= t -> Rabs (Ax t) <= a) ->
  directed k Ax vx vy -> is_lim vy p_infty 0.
Proof.
  intros hk hK hA [cx cy L]. assert (a0 : 0 <= a) by (pose proof (hA 0 ltac:(lra)); pose proof (Rabs_pos (Ax 0)); lra).
  set (m t := sqrt (1 + (vx t ^ 2 + vy t ^ 2))). assert (m1 : forall t, 1 <= m t /\ nrm (vx t) (vy t) <= m t).
  { intros t. pose proof (pow2_ge_0 (vx t)). pose proof (pow2_ge_0 (vy t)). unfold m. rewrite <- sqrt_1 at 1. unfold nrm.
    split; apply sqrt_le_1_alt; lra. }
  (* the force along the velocity, and across *)
  assert (F : forall t fx fy, nrm (vx t) (vy t) * fx = - k (vx t) (vy t) * vx t -> nrm (vx t) (vy t) * fy = - k (vx t) (vy t) * vy t -> vx t * fx +
  vy t * fy <= 0 /\ m t * (vy t * fy) <= - k0 * vy t ^ 2 \/ nrm (vx t) (vy t) = 0).
  { intros t fx fy E1 E2. destruct (nrm_pos (vx t) (vy t)) as [p | p]; [ left | now right ]. destruct (m1 t) as [m0 m2].
    specialize (hK (vx t) (vy t)). set (n := nrm (vx t) (vy t)) in *. set (kk := k (vx t) (vy t)) in *.
    assert (q : vy t * fy <= 0) by (apply (Rmult_le_reg_l n); trivial; replace (n * (vy t * fy)) with (vy t * (n * fy)) by ring; rewrite E2; nra).
    assert (n * (vy t * fy) <= - k0 * vy t ^ 2) by (replace (n * (vy t * fy)) with (vy t * (n * fy)) by ring; rewrite E2; nra).
    split; [ | nra ]. apply (Rmult_le_reg_l n); trivial. replace (n * (vx t * fx + vy t * fy)) with (vx t * (n * fx) + vy t * (n * fy)) by ring.
    rewrite E1, E2. nra. }
  set (b := a + 1). set (N t := m 0 + b * t). assert (G : forall t, 0 <= t -> m t <= N t).
  { intros t Ht. enough (m t - b * t <= m 0 - b * 0) by (unfold N; lra). apply (rder_decr (fun t => m t - b * t)); [ lra | | ]; intros u Hu.
    - assert (0 <= vx u ^ 2 + vy u ^ 2) by (apply Rplus_le_le_0_compat; apply pow2_ge_0). cont.
      apply (cont_root (fun t => 1 + (vx t ^ 2 + vy t ^ 2))); [ cont; [ apply cx | apply cy ]; lra | lra ].
    - destruct (L u) as (fx & fy & X & Y & E1 & E2); [ lra | ]. assert (0 <= vx u ^ 2 + vy u ^ 2) by (apply Rplus_le_le_0_compat; apply pow2_ge_0).
      eexists. split; [ apply (rder_minus m); [ apply (rder_root (fun t => 1 + (vx t ^ 2 + vy t ^ 2))); [ rd | lra ] | rd ] | ].
      fold (m u). destruct (m1 u) as [m0 m2]. specialize (hA u ltac:(lra)). destruct (abs_nrm (vx u) (vy u)) as [v _]. apply Rabs_le_between in v.
      apply Rabs_le_between in hA.
      assert (P : vx u * fx + vy u * fy <= 0) by (destruct (F u fx fy E1 E2) as [[P _] | z]; [ lra | destruct (nrm_zero _ _ z) as [-> ->]; lra ]).
      assert (Q : - (vx u * Ax u) <= a * m u) by nra.
      assert (/ (2 * m u) * (2 * (vx u * fx + vy u * fy) - 2 * (vx u * Ax u)) <= a); [ | simpl; unfold b; lra ]. rewrite Rmult_comm.
      apply Rle_div_l; nra. }
  assert (N1 : forall t, 0 <= t -> 1 <= N t) by (intros t Ht; destruct (m1 t); specialize (G t Ht); lra).
  assert (c0 : 0 < 2 * k0 / b) by (apply Rdiv_lt_0_compat; unfold b; lra). set (c := 2 * k0 / b) in *.
  apply (lim_of_bound vy (vy 0 ^ 2 * (1 + c * ln (N 0))) (fun t => 1 + c * ln (N t))).
  - pose proof (ln_le 1 (N 0) Rlt_0_1 (N1 0 (Rle_refl _))) as l0. rewrite ln_1 in l0. apply Rmult_le_pos; [ apply pow2_ge_0 | nra ].
  - intros t Ht. apply (rder_decr (fun t => vy t ^ 2 * (1 + c * ln (N t)))); trivial; intros u Hu; specialize (N1 u ltac:(lra)); [ unfold N in *;
    cont; [ apply cy | ]; lra | ].
    destruct (L u) as (fx & fy & X & Y & E1 & E2); [ lra | ]. unfold N in *. eexists. split; [ rd; lra | ]. cbv beta. specialize (G u ltac:(lra)).
    pose proof (ln_le 1 _ Rlt_0_1 N1) as l0. rewrite ln_1 in l0. set (n := m 0 + b * u) in *.
    assert (H : vy u * fy <= - (k0 * vy u ^ 2 / n)).
    { destruct (F u fx fy E1 E2) as [[_ P] | z]; [ | destruct (nrm_zero _ _ z) as [_ ->]; unfold Rdiv; lra ]. destruct (m1 u). apply Ropp_le_cancel.
      rewrite Ropp_involutive. apply Rle_div_l; [ lra | ]. assert (vy u * fy <= 0) by nra. nra. }
    assert (0 <= k0 * vy u ^ 2 / n) by (apply Rmult_le_pos; [ pose proof (pow2_ge_0 (vy u)); nra | left; apply Rinv_0_lt_compat; lra ]).
    replace (vy u ^ 2 * (0 + (0 * ln n + c * ((0 + (0 * u + b * 1)) / n)))) with (2 * (k0 * vy u ^ 2 / n)) by (unfold c, b in *; field; lra). simpl.
    assert (0 <= c * ln n) by nra. nra.
  - intros A. destruct (grows_line b (m 0) (exp (A / c))) as (T & T0 & HT); [ unfold b; lra | ]. exists T. split; trivial. intros t Ht.
    specialize (HT t Ht). fold (N t) in HT.
    pose proof (ln_le _ _ (exp_pos _) HT) as l0. rewrite ln_exp in l0. apply (Rmult_le_compat_l c) in l0; [ | lra ].
    replace (c * (A / c)) with A in l0 by (field; lra). lra.
Qed.
