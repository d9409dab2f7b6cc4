(* The critical radius: the kernel follows the two motions that are put down at rest in the laboratory at 0.872 and at 0.8721 until it is settled
   that they rest or escape (Reckoned.v); some start between does neither (Threshold.v) *)
Require Import Reals Lra Psatz ZArith Lia.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis TableLaws Lab Turntable Fate TableMotions Threshold Enclosed.
From Slipbook Require Reckoned.
Open Scope R_scope.

(* mu g = Omega = 1: a particle is put down at the time 0 in the laboratory, at (X 0, Y 0), without speed there; on the table, which turns below it,
   it is at (x, y) and has the velocity (u, w). «the particle at $(X,Y)$ in the laboratory, under the friction of a table that turns below it, is put
   down there at rest; relative to the table it is at $(x,y)$ with the velocity $(u,w)$» *)
Definition put_down (X Y U W x y u w : R -> R) : Prop := laboratory 1 1 X Y U W /\ same_particle 1 X Y U W x y u w /\ U 0 = 0 /\ W 0 = 0.

Lemma put_down_exists r : exists X Y U W x y u w, put_down X Y U W x y u w /\ X 0 = r /\ Y 0 = 0.
Proof.
  destruct (table_exists r 0 0 (- r)) as (x & y & u & w & S & ex & ey & eu & ew). apply spin_is_turntable in S.
  assert (T : exists X Y U W, same_particle 1 X Y U W x y u w) by (do 4 eexists; apply same_back; intros t; repeat split).
  destruct T as (X & Y & U & W & T). assert (L : laboratory 1 1 X Y U W). { replace 1 with (1 * 1) at 2 by ring.
  apply (eq_86__back 1 1 1 X Y U W x y u w); trivial. now rewrite Rmult_1_l. }
  exists X, Y, U, W, x, y, u, w. destruct (proj1 (same_back _ _ _ _ _ _ _ _ _) T 0) as (e1 & e2 & e3 & e4).
  rewrite Rmult_0_r, cos_0, sin_0, ex, ey, ?eu, ?ew in *. unfold put_down. repeat split; try apply L; try apply T; lra.
Qed.
(* the law has no direction *)
Lemma turn_nrm c s a b : c ^ 2 + s ^ 2 = 1 -> nrm (c * a + s * b) (c * b - s * a) = nrm a b.
Proof. intros e. unfold nrm. f_equal. transitivity ((c ^ 2 + s ^ 2) * (a ^ 2 + b ^ 2)). ring. rewrite e. ring. Qed.
Lemma turned_spin c s x y u w : c ^ 2 + s ^ 2 = 1 -> spin x y u w ->
  spin (fun t => c * x t + s * y t) (fun t => c * y t - s * x t) (fun t => c * u t + s * w t) (fun t => c * w t - s * u t).
Proof.
  intros e S. split; try (intros t Ht; table S). intros t Ht. destruct (s_law _ _ _ _ S t Ht) as (DX & DY & fx & fy & [B P] & DU & DW).
  split. { eapply rder_eq; [ rd | ring ]. } split. { eapply rder_eq; [ rd | ring ]. } exists (c * fx + s * fy), (c * fy - s * fx).
  split; [ split | split; (eapply rder_eq; [ rd | ring ]) ].
  - replace ((c * fx + s * fy) ^ 2 + (c * fy - s * fx) ^ 2) with ((c ^ 2 + s ^ 2) * (fx ^ 2 + fy ^ 2)) by ring. now rewrite e, Rmult_1_l.
  - rewrite turn_nrm by trivial. rewrite <- P. transitivity ((c ^ 2 + s ^ 2) * (fx * u t + fy * w t)). ring. rewrite e. ring.
Qed.
(* a motion that starts so on the first axis *)
Definition starts_at r x y u w := spin x y u w /\ x 0 = r /\ y 0 = 0 /\ u 0 = 0 /\ w 0 = - r.
Lemma on_axis X Y U W x y u w : put_down X Y U W x y u w -> 0 < nrm (X 0) (Y 0) -> spin x y u w /\ exists x' y' u' w', starts_at (nrm (X 0) (Y 0))
  x' y' u' w' /\
  forall t, nrm (x' t) (y' t) = nrm (x t) (y t) /\ nrm (u' t) (w' t) = nrm (u t) (w t).
Proof.
  intros (L & T & U0 & W0) r0. set (r := nrm (X 0) (Y 0)) in *. assert (S : spin x y u w).
  { apply spin_is_turntable. replace 1 with (1 * 1) at 2 by ring. apply (eq_86 1 1 1 X Y U W); trivial. lra. now rewrite Rmult_1_l. }
  split; trivial. set (c := X 0 / r). set (s := Y 0 / r). pose proof (nrm_sq (X 0) (Y 0)) as e. fold r in e.
  assert (cs : c ^ 2 + s ^ 2 = 1). { unfold c, s. transitivity ((X 0 ^ 2 + Y 0 ^ 2) / r ^ 2). field; lra. rewrite <- e. field; lra. }
  exists (fun t => c * x t + s * y t), (fun t => c * y t - s * x t), (fun t => c * u t + s * w t), (fun t => c * w t - s * u t).
  split. 2: intros t; split; now apply turn_nrm. split. now apply turned_spin. destruct (T 0) as (-> & -> & -> & ->).
  rewrite Rmult_0_r, cos_0, sin_0, U0, W0. assert (k : c * X 0 + s * Y 0 = r). { unfold c, s. transitivity ((X 0 ^ 2 + Y 0 ^ 2) / r). field; lra.
  rewrite <- e. field; lra. }
  assert (m : c * Y 0 - s * X 0 = 0) by (unfold c, s; field; lra). repeat split; lra.
Qed.

(* what the kernel reckons: some seconds *)
Definition reckoned r := Reckoned.run 150 2 (r * 2 ^ 40 / 10000) 0 0 (- (r * 2 ^ 40 / 10000)).
Lemma reckoned_rests : reckoned 8720 = Reckoned.rests. Proof. vm_cast_no_check (eq_refl Reckoned.rests). Qed.
Lemma reckoned_leaves : reckoned 8721 = Reckoned.leaves. Proof. vm_cast_no_check (eq_refl Reckoned.leaves). Qed.
Lemma reckons r x y u w : starts_at (IZR r / 10000) x y u w ->
  match reckoned r with Reckoned.rests => Reckoned.caught_once x y u w | Reckoned.leaves => Reckoned.free_once x y u w | Reckoned.open => True end.
Proof.
  intros (S & ex & ey & eu & ew). apply (Reckoned.run_says _ _ _ _ S). lia. exists 0. split. lra. unfold off. rewrite ex, ey, eu, ew.
  pose proof (Z.div_mod (r * 2 ^ 40) 10000 ltac:(lia)) as e. pose proof (Z.mod_pos_bound (r * 2 ^ 40) 10000 ltac:(lia)) as [m0 m1].
  apply (f_equal IZR) in e.
  rewrite plus_IZR, !mult_IZR in e. change (IZR (2 ^ 40)) with 1099511627776 in e. apply IZR_le in m0. apply IZR_lt in m1. rewrite opp_IZR.
  change (IZR Reckoned.one) with 1099511627776. set (q := IZR (r * 2 ^ 40 / 10000)) in *. set (m := IZR ((r * 2 ^ 40) mod 10000)) in *.
  replace (IZR r / 10000 - q / 1099511627776) with (m / 10995116277760000) by lra.
  replace (- (IZR r / 10000) - - q / 1099511627776) with (- m / 10995116277760000) by lra. nra.
Qed.
Lemma inner_start x y u w : starts_at 0.872 x y u w -> Reckoned.caught_once x y u w.
Proof. intros H. pose proof (reckons 8720 x y u w) as K. rewrite reckoned_rests in K. apply K. now replace (8720 / 10000) with 0.872 by lra. Qed.
Lemma outer_start x y u w : starts_at 0.8721 x y u w -> Reckoned.free_once x y u w.
Proof. intros H. pose proof (reckons 8721 x y u w) as K. rewrite reckoned_leaves in K. apply K. now replace (8721 / 10000) with 0.8721 by lra. Qed.

(* who is caught rests, who is free escapes *)
Lemma caught_rests x y u w : spin x y u w -> Reckoned.caught_once x y u w -> exists s, s < 1 /\ rests_at s x y u w.
Proof.
  intros S (s & s0 & k). set (t := s + nrm (u s) (w s) / (1 - (nrm (x s) (y s) + nrm (u s) (w s)))).
  destruct (caught x y u w S s t s0 k (Rle_refl _)) as (z1 & z2 & r1).
  assert (t0 : 0 <= t). { apply Rplus_le_le_0_compat; trivial. apply Rdiv_le_0_compat. apply nrm_pos. lra. }
  exists (nrm (x t) (y t)). split. lra. apply (rests_from x y u w S t t0); [ rewrite z1, z2; apply nrm_0 | lra ].
Qed.
Lemma free_escapes x y u w : spin x y u w -> Reckoned.free_once x y u w -> escapes x y.
Proof. intros S (s & s0 & k). apply (escapes_from x y u w S s s0). rewrite !nrm_sq in k. lra. Qed.

(* the starts between, and the last of them that is not beyond the border *)
Definition at_radius r (i : place) := match i with px => r | py => 0 | pu => 0 | pw => - r end.
Lemma V_starts r : starts_at r (V (at_radius r) px) (V (at_radius r) py) (V (at_radius r) pu) (V (at_radius r) pw).
Proof. split. apply V_spin. rewrite !V_0. auto. Qed.
Lemma border : exists r, 0.872 < r < 0.8721 /\ forall x y u w, starts_at r x y u w ->
  forall t, 0 <= t -> 1 <= nrm (x t) (y t) + nrm (u t) (w t) /\ nrm (x t) (y t) ^ 2 - nrm (u t) (w t) ^ 2 <= 1 ^ 2.
Proof.
  set (k r := Rmax 0.872 (Rmin r 0.8721)). assert (k0 : forall r, r <= 0.872 -> k r = 0.872) by (intros r H; unfold k; rewrite Rmin_left, Rmax_left;
    lra).
  assert (k1 : forall r, 0.8721 <= r -> k r = 0.8721) by (intros r H; unfold k; rewrite Rmin_right, Rmax_right; lra).
  destruct (threshold (fun r => at_radius (k r)) 1 1 0.8721 Rlt_0_1 ltac:(lra)) as (z & z0 & K).
  - assert (L : forall r q, Rabs (k r - k q) <= 1 * Rabs (r - q)). { intros r q. unfold k, Rmax, Rmin, Rabs.
  repeat destruct Rle_dec; repeat destruct Rcase_abs; lra. }
    intros r q i. specialize (L r q). pose proof (Rabs_pos (k r - k q)).
    destruct i; cbn [at_radius]; trivial; try (rewrite Rminus_eq_0, Rabs_R0; lra).
    replace (- k r - - k q) with (- (k r - k q)) by ring. now rewrite Rabs_Ropp.
  - rewrite k0 by lra. exact (inner_start _ _ _ _ (V_starts 0.872)).
  - intros r Hr. rewrite k1 by lra. destruct (outer_start _ _ _ _ (V_starts 0.8721)) as (t & Ht & H). exists t. split; trivial. lra.
  - assert (N0 : 0.872 < z). { apply Rnot_le_lt. intros H. destruct (inner_start _ _ _ _ (V_starts 0.872)) as (t & Ht & N). specialize (K t Ht).
  rewrite (k0 z H) in K. lra. }
    assert (N1 : z < 0.8721). { apply Rnot_le_lt. intros H. destruct (outer_start _ _ _ _ (V_starts 0.8721)) as (t & Ht & N). specialize (K t Ht).
    rewrite (k1 z H) in K. lra. }
    exists z. split. lra. intros x y u w (S & ex & ey & eu & ew) t Ht. specialize (K t Ht).
    replace (k z) with z in K by (unfold k; rewrite Rmin_left, Rmax_right; lra).
    destruct (V_starts z) as (S' & ex' & ey' & eu' & ew').
    destruct (table_unique _ _ _ _ _ _ _ _ 0 S S' (Rle_refl 0) ltac:(congruence) ltac:(congruence) ltac:(congruence) ltac:(congruence) t Ht)
      as (-> & -> & -> & ->). exact K.
Qed.
