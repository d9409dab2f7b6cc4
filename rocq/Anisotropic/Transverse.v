(* 2.4: the velocity across the drive, under a friction that depends on the direction of the velocity: it falls to 0. If it stayed
   above e, its square would fall at a rate of at least 1/t and so below every bound. *)
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
  assert (P : forall t fy, 0 <= t -> nrm (vx t) (vy t) * fy = - k (vx t) (vy t) * vy t -> vy t * fy <= 0).
  { intros t fy _ e. destruct (nrm_pos (vx t) (vy t)) as [p | p].
    - apply (Rmult_le_reg_l (nrm (vx t) (vy t))); trivial. specialize (hK (vx t) (vy t)). pose proof (pow2_ge_0 (vy t)). replace (nrm (vx t) (vy t) * (vy t * fy)) with (vy t * (nrm (vx t) (vy t) * fy)) by ring. rewrite e. nra.
    - destruct (nrm_zero _ _ (eq_sym p)) as [_ ->]. lra. }
  assert (M : forall s t, 0 <= s <= t -> vy t ^ 2 <= vy s ^ 2).
  { intros s t H. apply (rder_decr (fun t => vy t ^ 2)); [ lra | intros u Hu; cont; apply cy; lra | intros u Hu ]. destruct (L u) as (fx & fy & X & Y & E & F); [ lra | ].
    eexists. split. rd. simpl. specialize (P u fy ltac:(lra) F). lra. }
  apply lim_zero. intros e he. enough (T : exists T, 0 <= T /\ vy T ^ 2 <= e ^ 2).
  { destruct T as (T & T0 & HT). exists T. intros t Ht. specialize (M T t ltac:(lra)). rewrite <- (Rabs_pos_eq e) by lra. apply Rsqr_le_abs_0. rewrite !Rsqr_pow2. lra. }
  apply Classical_Prop.NNPP. intros no. assert (B : forall t, 0 <= t -> e ^ 2 < vy t ^ 2) by (intros t Ht; apply Rnot_le_lt; intros q; apply no; eauto). clear no.
  assert (N : forall t, 0 <= t -> 0 < nrm (vx t) (vy t)) by (intros t Ht; specialize (B t Ht); pose proof (nrm_sq (vx t) (vy t)); pose proof (nrm_pos (vx t) (vy t)); nra).
  set (n0 := nrm (vx 0) (vy 0)) in *. assert (p0 : 0 < n0) by (apply N; lra). set (b := a + 1). assert (b0 : 0 < b) by (unfold b; lra).
  assert (G : forall t, 0 <= t -> nrm (vx t) (vy t) <= n0 + b * t).
  { intros t Ht. enough (nrm (vx t) (vy t) - b * t <= nrm (vx 0) (vy 0) - b * 0) by (unfold n0; lra).
    apply (rder_decr (fun t => nrm (vx t) (vy t) - b * t)); [ lra | intros u Hu; cont; [ apply cx | apply cy ]; lra | intros u Hu ]. destruct (L u) as (fx & fy & X & Y & E & F); [ lra | ].
    specialize (N u ltac:(lra)). eexists. split. rd. lra. set (n := nrm (vx u) (vy u)) in *. pose proof (nrm_sq (vx u) (vy u)) as q. fold n in q.
    assert (fr : vx u * fx + vy u * fy <= 0). { apply (Rmult_le_reg_l n); trivial. replace (n * (vx u * fx + vy u * fy)) with (vx u * (n * fx) + vy u * (n * fy)) by ring. rewrite E, F. specialize (hK (vx u) (vy u)). nra. }
    assert (pu : - (vx u * Ax u) <= a * n). { specialize (hA u ltac:(lra)). apply Rabs_le_between in hA. assert (- n <= vx u <= n) by nra. nra. }
    assert ((vx u * (fx - Ax u) + vy u * fy) / n <= a); [ apply Rle_div_l; lra | unfold b; lra ]. }
  set (c := 2 * k0 * e ^ 2 / b). assert (ee : 0 < e ^ 2) by (apply pow_lt; lra). assert (c0 : 0 < c) by (unfold c; apply Rdiv_lt_0_compat; nra).
  assert (S : forall t, 0 <= t -> vy t ^ 2 + c * ln (n0 + b * t) <= vy 0 ^ 2 + c * ln (n0 + b * 0)).
  { intros t Ht. apply (rder_decr (fun t => vy t ^ 2 + c * ln (n0 + b * t))); trivial; intros u Hu; assert (q0 : 0 < n0 + b * u) by nra.
    - cont; [ apply cy; lra | trivial ].
    - destruct (L u) as (fx & fy & X & Y & E & F); [ lra | ]. eexists. split. rd. exact q0. cbv beta. simpl. specialize (N u ltac:(lra)). specialize (G u ltac:(lra)). specialize (B u ltac:(lra)). specialize (hK (vx u) (vy u)).
      set (n := nrm (vx u) (vy u)) in *. assert (f1 : vy u * fy <= - (k0 * e ^ 2 / n)).
      { apply (Rmult_le_reg_l n); trivial. replace (n * (vy u * fy)) with (vy u * (n * fy)) by ring. rewrite F. replace (n * - (k0 * e ^ 2 / n)) with (- (k0 * e ^ 2)) by (field; lra). assert (0 <= e ^ 2) by nra. nra. }
      assert (f2 : k0 * e ^ 2 / (n0 + b * u) <= k0 * e ^ 2 / n) by (apply Rmult_le_compat_l; [ nra | apply Rinv_le_contravar; trivial ]).
      replace (c * ((0 + (0 * u + b * 1)) / (n0 + b * u))) with (2 * (k0 * e ^ 2 / (n0 + b * u))) by (unfold c; field; lra). lra. }
  set (T := n0 * (exp ((vy 0 ^ 2 + 1) / c) - 1) / b). assert (E1 : n0 + b * T = n0 * exp ((vy 0 ^ 2 + 1) / c)) by (unfold T; field; lra).
  assert (T0 : 0 <= T). { unfold T. apply Rmult_le_pos; [ | left; now apply Rinv_0_lt_compat ]. apply Rmult_le_pos; [ lra | ].
    assert (0 <= (vy 0 ^ 2 + 1) / c) by (apply Rmult_le_pos; [ nra | left; now apply Rinv_0_lt_compat ]). pose proof (exp_ineq1_le ((vy 0 ^ 2 + 1) / c)). lra. }
  specialize (S T T0). rewrite E1, Rmult_0_r, Rplus_0_r, ln_mult, ln_exp in S by (trivial; apply exp_pos). pose proof (pow2_ge_0 (vy T)).
  replace (c * (ln n0 + (vy 0 ^ 2 + 1) / c)) with (c * ln n0 + vy 0 ^ 2 + 1) in S by (field; lra). lra.
Qed.
