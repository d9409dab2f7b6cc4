(* Section 4: between the starts that are caught and those that escape there are starts that do neither *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate Picard Exist Exist2.
Open Scope R_scope.

(* what comes of two starts that differ in x by at most d *)
Lemma depend x1 y1 u1 w1 x2 y2 u2 w2 d t : spin x1 y1 u1 w1 -> spin x2 y2 u2 w2 -> y1 0 = y2 0 -> u1 0 = u2 0 -> w1 0 = w2 0 -> Rabs (x1 0 - x2 0) <= d -> 0 <= t ->
  Rabs (nrm (x1 t) (y1 t) - nrm (x2 t) (y2 t)) <= 2 * d * exp t /\ Rabs (nrm (u1 t) (w1 t) - nrm (u2 t) (w2 t)) <= 2 * d * exp t.
Proof.
  intros S1 S2 ey eu ew Hd Ht. pose proof (table_apart _ _ _ _ _ _ _ _ S1 S2 0 t ltac:(lra)) as H. rewrite ey, eu, ew, Rmult_0_r, exp_0 in H.
  pose proof (exp_pos t) as q0. assert (d0 : 0 <= d) by (pose proof (Rabs_pos (x1 0 - x2 0)); lra).
  assert (e : exp (- (2) * t) * exp t ^ 2 = 1). { replace (exp t ^ 2) with (exp t * exp t) by ring. rewrite <- !exp_plus. replace (- (2) * t + (t + t)) with 0 by ring. apply exp_0. }
  set (D := (x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 + (u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2) in *.
  apply (Rmult_le_compat_r (exp t ^ 2)) in H; [ | nra ]. rewrite Rmult_assoc, e in H.
  assert (x2d : (x1 0 - x2 0) ^ 2 <= d ^ 2) by (rewrite <- pow2_abs; apply pow_incr; split; trivial; apply Rabs_pos).
  assert (K : D <= (d * exp t) ^ 2). { replace ((d * exp t) ^ 2) with (d ^ 2 * exp t ^ 2) by ring. pose proof (Rmult_le_compat_r (exp t ^ 2) _ _ ltac:(nra) x2d). lra. }
  unfold D in K. pose proof (pow2_ge_0 (x1 t - x2 t)). pose proof (pow2_ge_0 (y1 t - y2 t)). pose proof (pow2_ge_0 (u1 t - u2 t)). pose proof (pow2_ge_0 (w1 t - w2 t)).
  assert (de0 : 0 <= d * exp t) by (apply Rmult_le_pos; lra).
  split; (eapply Rle_trans; [ apply nrm_lip | ]).
  - pose proof (abs_of_sq (x1 t - x2 t) _ de0 ltac:(lra)). pose proof (abs_of_sq (y1 t - y2 t) _ de0 ltac:(lra)). lra.
  - pose proof (abs_of_sq (u1 t - u2 t) _ de0 ltac:(lra)). pose proof (abs_of_sq (w1 t - w2 t) _ de0 ltac:(lra)). lra.
Qed.
Lemma above_one a b : 0 <= a -> 1 < a ^ 2 - b ^ 2 <-> nrm 1 b < a.
Proof. intros Ha. pose proof (nrm_sq 1 b). pose proof (nrm_pos 1 b). split; intros; nra. Qed.

Theorem s4_boundary_exists u0 w0 : nrm u0 w0 < 1 -> exists x y u w, spin x y u w /\ 0 <= x 0 /\ y 0 = 0 /\ u 0 = u0 /\ w 0 = w0 /\
  forall t, 0 <= t -> 1 <= nrm (x t) (y t) + nrm (u t) (w t) /\ x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2) <= 1.
Proof.
  intros H1. set (c r i := match i with px => r | py => 0 | pu => u0 | pw => w0 end).
  set (X r := V (c r) px). set (Y r := V (c r) py). set (U r := V (c r) pu). set (W r := V (c r) pw).
  assert (S : forall r, spin (X r) (Y r) (U r) (W r)) by (intros; apply V_spin).
  assert (i1 : forall r, X r 0 = r) by (intros; apply (V_0 (c r) px)). assert (i2 : forall r, Y r 0 = 0) by (intros; apply (V_0 (c r) py)).
  assert (i3 : forall r, U r 0 = u0) by (intros; apply (V_0 (c r) pu)). assert (i4 : forall r, W r 0 = w0) by (intros; apply (V_0 (c r) pw)).
  set (rho r t := nrm (X r t) (Y r t)). set (p r t := nrm (U r t) (W r t)).
  assert (dep : forall r q d t, Rabs (r - q) <= d -> 0 <= t -> Rabs (rho r t - rho q t) <= 2 * d * exp t /\ Rabs (p r t - p q t) <= 2 * d * exp t).
  { intros r q d t Hd Ht. apply (depend _ _ _ _ _ _ _ _ d t (S r) (S q)); rewrite ?i1, ?i2, ?i3, ?i4; trivial. }
  set (C r := 0 <= r /\ exists t, 0 <= t /\ rho r t + p r t < 1).
  assert (n0 : nrm 0 0 = 0) by (unfold nrm; replace (0 ^ 2 + 0 ^ 2) with 0 by ring; apply sqrt_0).
  assert (C0 : C 0). { split. lra. exists 0. split. lra. unfold rho, p. rewrite i1, i2, i3, i4, n0. lra. }
  assert (en : forall r t, X r t ^ 2 + Y r t ^ 2 - (U r t ^ 2 + W r t ^ 2) = rho r t ^ 2 - p r t ^ 2) by (intros; unfold rho, p; rewrite !nrm_sq; ring).
  (* what is caught had rho^2 - p^2 <= 1 all the time *)
  assert (low : forall r s, C r -> 0 <= s -> rho r s ^ 2 - p r s ^ 2 <= 1).
  { intros r s [r0 (t & Ht & K)] Hs. apply Rnot_lt_le. intros k. 
    destruct (Rle_lt_dec s t) as [st | st].
    - pose proof (A_never_falls _ _ _ _ (S r) s t ltac:(lra)) as M. rewrite !en in M. pose proof (nrm_pos (X r t) (Y r t)). pose proof (nrm_pos (U r t) (W r t)). unfold rho, p in *. nra.
    - pose proof (m_falls _ _ _ _ (S r) t s ltac:(lra) K) as M. pose proof (nrm_pos (X r s) (Y r s)). pose proof (nrm_pos (U r s) (W r s)). unfold rho, p in *. nra. }
  destruct (completeness C) as [z [z1 z2]].
  { exists 2. intros r Hr. pose proof (low r 0 Hr (Rle_refl 0)) as M. unfold rho, p in M. rewrite i1, i2, i3, i4, nrm_sq in M. destruct Hr as [r0 _]. pose proof (nrm_pos u0 w0). nra. }
  { exists 0. exact C0. }
  assert (z0 : 0 <= z) by (apply z1, C0).
  exists (X z), (Y z), (U z), (W z). rewrite i1, i2, i3, i4. repeat (split; [ now trivial | ]). intros t Ht. fold (rho z t). fold (p z t). rewrite en.
  pose proof (exp_pos t) as et. split; apply Rnot_lt_le; intros k.
  - (* z caught: so is a little more *)
    set (d := (1 - (rho z t + p z t)) / (8 * exp t)). assert (d0 : 0 < d) by (apply Rdiv_lt_0_compat; lra).
    destruct (dep (z + d) z d t) as [k1 k2]; [ replace (z + d - z) with d by ring; rewrite Rabs_pos_eq; lra | trivial | ].
    assert (q : 8 * (d * exp t) = 1 - (rho z t + p z t)) by (unfold d; field; lra). apply Rabs_le_between in k1, k2.
    assert (z + d <= z); [ | lra ]. apply z1. split. lra. exists t. split; trivial. lra.
  - (* z escapes: so does a little less, but some of that is caught *)
    apply above_one in k; [ | apply nrm_pos ]. set (d := (rho z t - nrm 1 (p z t)) / (8 * exp t)). assert (d0 : 0 < d) by (apply Rdiv_lt_0_compat; lra).
    assert (q : 8 * (d * exp t) = rho z t - nrm 1 (p z t)) by (unfold d; field; lra).
    assert (z <= z - d); [ | lra ]. apply z2. intros r Hr. apply Rnot_lt_le. intros rz. assert (rz2 : r <= z) by (apply z1, Hr).
    destruct (dep r z d t) as [k1 k2]; [ apply Rabs_le; lra | trivial | ].
    pose proof (nrm_lip 1 (p r t) 1 (p z t)) as k3. rewrite Rminus_eq_0, Rabs_R0 in k3. 
    pose proof (low r t Hr Ht) as M. apply Rle_not_lt in M. apply M, above_one. apply nrm_pos. apply Rabs_le_between in k1, k3. lra.
Qed.
(* the exception of s4-dichotomy is not empty: from some place a particle of this velocity comes to rest just on rho = 1, or creeps there for ever *)
Corollary s4_dichotomy_exception u0 w0 : nrm u0 w0 < 1 -> exists x y u w, spin x y u w /\ 0 <= x 0 /\ y 0 = 0 /\ u 0 = u0 /\ w 0 = w0 /\
  ((exists T, 0 <= T /\ nrm (x T) (y T) = 1 /\ forall t, T <= t -> x t = x T /\ y t = y T /\ u t = 0 /\ w t = 0) \/
   (exists a b : R, a ^ 2 + b ^ 2 = 1 /\ is_lim x p_infty a /\ is_lim y p_infty b /\ is_lim u p_infty 0 /\ is_lim w p_infty 0 /\
     forall t, 0 <= t -> 0 < nrm (u t) (w t))).
Proof.
  intros H. destruct (s4_boundary_exists u0 w0 H) as (x & y & u & w & S & x0 & y0 & e1 & e2 & K). exists x, y, u, w. repeat (split; [ now trivial | ]).
  destruct (s4_dichotomy__fates _ _ _ _ S) as [(T & T0 & r1 & R) | [far | creep]]; [ left | exfalso | right; exact creep ].
  - exists T. split; trivial. split; trivial. destruct (K T T0) as [k _]. destruct (R T (Rle_refl T)) as (_ & _ & z1 & z2). rewrite (at_rest u w T z1 z2) in k. lra.
  - destruct (bounded_ends x y u w S 1) as (a & b & Ha & Hb & _). { intros t Ht. apply K, Ht. }
    destruct (lim_near x a 1 Ha Rlt_0_1) as (T1 & T10 & H1). destruct (lim_near y b 1 Hb Rlt_0_1) as (T2 & T20 & H2).
    destruct (far (Rabs a + Rabs b + 2)) as (T3 & T30 & H3). set (t := T1 + T2 + T3).
    specialize (H1 t ltac:(unfold t; lra)). specialize (H2 t ltac:(unfold t; lra)). specialize (H3 t ltac:(unfold t; lra)).
    pose proof (nrm_lip (x t) (y t) a b) as Q. pose proof (nrm_lip a b 0 0) as Q2. rewrite !Rminus_0_r in Q2.
    assert (n0 : nrm 0 0 = 0) by (unfold nrm; replace (0 ^ 2 + 0 ^ 2) with 0 by ring; apply sqrt_0). rewrite n0 in Q2.
    assert (Rabs (x t - a) <= 1) by (apply Rabs_le; lra). assert (Rabs (y t - b) <= 1) by (apply Rabs_le; lra). apply Rabs_le_between in Q, Q2. lra.
Qed.
