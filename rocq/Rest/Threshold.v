(* Between the starts that come to rest inside a distance s and those whose rho^2 - p^2 exceeds s^2 there is one that does neither: the
   supremum along a line of starts. It comes to rest at s, or, if s = 1, it may creep for ever. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate TableMotions.
Open Scope R_scope.

(* what comes of two starts that differ by at most d *)
Lemma depend c1 c2 d t : (forall i, Rabs (c1 i - c2 i) <= d) -> 0 <= t ->
  Rabs (nrm (V c1 px t) (V c1 py t) - nrm (V c2 px t) (V c2 py t)) <= 4 * d * exp t /\
  Rabs (nrm (V c1 pu t) (V c1 pw t) - nrm (V c2 pu t) (V c2 pw t)) <= 4 * d * exp t.
Proof.
  intros Hd Ht. pose proof (table_apart _ _ _ _ _ _ _ _ (V_spin c1) (V_spin c2) 0 t ltac:(lra)) as H. rewrite !V_0, Rmult_0_r, exp_0 in H.
  pose proof (exp_pos t) as q0. assert (d0 : 0 <= d) by (pose proof (Hd px); pose proof (Rabs_pos (c1 px - c2 px)); lra).
  assert (e : exp (- (2) * t) * exp t ^ 2 = 1). { replace (exp t ^ 2) with (exp t * exp t) by ring. rewrite <- !exp_plus.
  replace (- (2) * t + (t + t)) with 0 by ring. apply exp_0. }
  assert (sq : forall i, (c1 i - c2 i) ^ 2 <= d ^ 2) by (intros i; rewrite <- pow2_abs; apply pow_incr; split; auto using Rabs_pos).
  set (D := (V c1 px t - V c2 px t) ^ 2 + _ + _ + _) in H.
  assert (K : D <= (2 * d * exp t) ^ 2).
  { replace D with (D * exp (- (2) * t) * exp t ^ 2) by (rewrite Rmult_assoc, e; ring).
  replace ((2 * d * exp t) ^ 2) with (4 * d ^ 2 * exp t ^ 2) by ring.
    apply Rmult_le_compat_r; [ apply pow2_ge_0 | ]. pose proof (sq px). pose proof (sq py). pose proof (sq pu). pose proof (sq pw). lra. }
  unfold D in K. pose proof (pow2_ge_0 (V c1 px t - V c2 px t)). pose proof (pow2_ge_0 (V c1 py t - V c2 py t)).
  pose proof (pow2_ge_0 (V c1 pu t - V c2 pu t)). pose proof (pow2_ge_0 (V c1 pw t - V c2 pw t)).
  assert (de0 : 0 <= 2 * d * exp t) by (apply Rmult_le_pos; lra).
  split; (eapply Rle_trans; [ apply nrm_near | ]).
  - pose proof (abs_of_sq (V c1 px t - V c2 px t) _ de0 ltac:(lra)). pose proof (abs_of_sq (V c1 py t - V c2 py t) _ de0 ltac:(lra)). lra.
  - pose proof (abs_of_sq (V c1 pu t - V c2 pu t) _ de0 ltac:(lra)). pose proof (abs_of_sq (V c1 pw t - V c2 pw t) _ de0 ltac:(lra)). lra.
Qed.
Lemma above_s s a b : 0 <= a -> s ^ 2 < a ^ 2 - b ^ 2 <-> nrm s b < a.
Proof. intros Ha. pose proof (nrm_sq s b). pose proof (nrm_pos s b). split; intros; nra. Qed.

Section Threshold.
Variables (c : R -> place -> R) (l s R0 : R).
Hypothesis l0 : 0 < l.
Hypothesis Hs : 0 < s <= 1.
Hypothesis lip : forall r q i, Rabs (c r i - c q i) <= l * Rabs (r - q).
Notation rho r t := (nrm (V (c r) px t) (V (c r) py t)).
Notation p r t := (nrm (V (c r) pu t) (V (c r) pw t)).
Hypothesis inside : exists t, 0 <= t /\ rho 0 t + p 0 t < s.
Hypothesis outside : forall r, R0 <= r -> exists t, 0 <= t /\ s ^ 2 < rho r t ^ 2 - p r t ^ 2.

Lemma threshold : exists r, 0 <= r /\ forall t, 0 <= t -> s <= rho r t + p r t /\ rho r t ^ 2 - p r t ^ 2 <= s ^ 2.
Proof.
  assert (dep : forall r q d t, Rabs (r - q) <= d -> 0 <= t -> Rabs (rho r t - rho q t) <= 4 * (l * d) * exp t /\
  Rabs (p r t - p q t) <= 4 * (l * d) * exp t).
  { intros r q d t Hd Ht. apply depend; trivial. intros i. eapply Rle_trans; [ apply lip | ]. apply Rmult_le_compat_l; lra. }
  set (C r := 0 <= r /\ exists t, 0 <= t /\ rho r t + p r t < s).
  assert (C0 : C 0) by (split; [ lra | exact inside ]).
  assert (en : forall r t, V (c r) px t ^ 2 + V (c r) py t ^ 2 - (V (c r) pu t ^ 2 + V (c r) pw t ^ 2) = rho r t ^ 2 - p r t ^ 2) by (intros;
  rewrite !nrm_sq; ring).
  (* what is caught had rho^2 - p^2 <= s^2 all the time *)
  assert (low : forall r t, C r -> 0 <= t -> rho r t ^ 2 - p r t ^ 2 <= s ^ 2).
  { intros r t [r0 (q & Hq & K)] Ht. pose proof (nrm_pos (V (c r) px q) (V (c r) py q)). pose proof (nrm_pos (V (c r) pu q) (V (c r) pw q)).
    destruct (Rle_lt_dec t q) as [tq | tq].
    - pose proof (A_never_falls _ _ _ _ (V_spin (c r)) t q ltac:(lra)) as M. rewrite !en in M. nra.
    - pose proof (m_falls _ _ _ _ (V_spin (c r)) q t ltac:(lra) ltac:(lra)) as M. pose proof (nrm_pos (V (c r) px t) (V (c r) py t)).
      pose proof (nrm_pos (V (c r) pu t) (V (c r) pw t)). nra. }
  destruct (completeness C) as [z [z1 z2]].
  { exists R0. intros r Hr. apply Rnot_lt_le. intros k. destruct (outside r ltac:(lra)) as (t & Ht & M). pose proof (low r t Hr Ht). lra. }
  { exists 0. exact C0. }
  assert (z0 : 0 <= z) by (apply z1, C0). exists z. split; trivial. intros t Ht. pose proof (exp_pos t) as et. 
  assert (le : 0 < l * exp t) by (apply Rmult_lt_0_compat; lra). split; apply Rnot_lt_le; intros k.
  - (* z caught: so is a little more *)
    set (d := (s - (rho z t + p z t)) / (16 * (l * exp t))). assert (d0 : 0 < d) by (apply Rdiv_lt_0_compat; lra).
    destruct (dep (z + d) z d t) as [k1 k2]; [ replace (z + d - z) with d by ring; rewrite Rabs_pos_eq; lra | trivial | ].
    assert (q : 16 * (l * d * exp t) = s - (rho z t + p z t)) by (unfold d; field; split; lra). apply Rabs_le_between in k1, k2.
    assert (z + d <= z); [ | lra ]. apply z1. split. lra. exists t. split; trivial. lra.
  - (* z escapes: so does a little less, but some of that is caught *)
    apply above_s in k; [ | apply nrm_pos ]. set (d := (rho z t - nrm s (p z t)) / (16 * (l * exp t))).
    assert (d0 : 0 < d) by (apply Rdiv_lt_0_compat; lra).
    assert (q : 16 * (l * d * exp t) = rho z t - nrm s (p z t)) by (unfold d; field; split; lra).
    assert (z <= z - d); [ | lra ]. apply z2. intros r Hr. apply Rnot_lt_le. intros rz. assert (rz2 : r <= z) by (apply z1, Hr).
    destruct (dep r z d t) as [k1 k2]; [ apply Rabs_le; lra | trivial | ].
    pose proof (nrm_near s (p r t) s (p z t)) as k3. rewrite Rminus_eq_0, Rabs_R0 in k3. 
    pose proof (low r t Hr Ht) as M. apply Rle_not_lt in M. apply M, above_s. apply nrm_pos. apply Rabs_le_between in k1, k3. lra.
Qed.
End Threshold.

Lemma lim_E x y u w (a b : R) : is_lim x p_infty a -> is_lim y p_infty b -> is_lim u p_infty 0 -> is_lim w p_infty 0 ->
  is_lim (fun t => x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) p_infty (a ^ 2 + b ^ 2).
Proof.
  intros Hx Hy Hu Hw. assert (sq : forall f (c : R), is_lim f p_infty c -> is_lim (fun t => f t ^ 2) p_infty (c ^ 2)).
  { intros f c Hc. apply (is_lim_ext (fun t => f t * f t)). intros; ring. replace (c ^ 2) with (c * c) by ring.
  apply (is_lim_mult f f p_infty c c); trivial. exact I. }
  replace (a ^ 2 + b ^ 2) with (a ^ 2 + b ^ 2 - (0 ^ 2 + 0 ^ 2)) by ring.
  apply (is_lim_minus' _ _ p_infty (a ^ 2 + b ^ 2) (0 ^ 2 + 0 ^ 2)); apply is_lim_plus'; auto.
Qed.
(* who is never caught and never has rho^2 - p^2 > s^2 comes to rest at s, or creeps and s = 1 *)
Lemma neither x y u w s : spin x y u w -> 0 < s <= 1 ->
  (forall t, 0 <= t -> s <= nrm (x t) (y t) + nrm (u t) (w t) /\ nrm (x t) (y t) ^ 2 - nrm (u t) (w t) ^ 2 <= s ^ 2) ->
  rests_at s x y u w \/ (s = 1 /\ creeps x y u w).
Proof.
  intros S Hs K. assert (HE : forall t, 0 <= t -> x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2) <= s ^ 2) by (intros t Ht; destruct (K t Ht) as [_ k];
  rewrite !nrm_sq in k; lra).
  destruct (fates _ _ _ _ S) as [(r & r1 & T & T0 & e & R) | [far | creep]].
  - left. replace s with r. now exists T. destruct (K T T0) as [k1 k2]. destruct (R T (Rle_refl T)) as (_ & _ & z1 & z2).
    rewrite z1, z2, nrm_0, e in k1, k2. pose proof (nrm_pos (x T) (y T)). nra.
  - exfalso. destruct (bounded_ends x y u w S _ HE) as (a & b & Ha & Hb & _).
    destruct (lim_near x a 1 Ha Rlt_0_1) as (T1 & T10 & H1). destruct (lim_near y b 1 Hb Rlt_0_1) as (T2 & T20 & H2).
    destruct (far (Rabs a + Rabs b + 2)) as (T3 & T30 & H3). set (t := T1 + T2 + T3).
    specialize (H1 t ltac:(unfold t; lra)). specialize (H2 t ltac:(unfold t; lra)). specialize (H3 t ltac:(unfold t; lra)).
    pose proof (nrm_near (x t) (y t) a b) as Q. pose proof (nrm_near a b 0 0) as Q2. rewrite !Rminus_0_r, nrm_0 in Q2.
    assert (Rabs (x t - a) <= 1) by (apply Rabs_le; lra). assert (Rabs (y t - b) <= 1) by (apply Rabs_le; lra). apply Rabs_le_between in Q, Q2. lra.
  - right. split; trivial. destruct creep as (a & b & e & Ha & Hb & Hu & Hw & _). pose proof (lim_E x y u w a b Ha Hb Hu Hw) as L. rewrite e in L.
    apply Rle_antisym. lra. apply Rnot_lt_le. intros k. destruct (lim_near _ 1 (1 - s ^ 2) L ltac:(nra)) as (T & T0 & HT).
    specialize (HT T (Rle_refl T)). specialize (HE T T0). lra.
Qed.
