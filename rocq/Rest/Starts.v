(* Starts with given A, alpha, psi and small alpha: which side of the corrected boundary tells whether the particle comes to rest inside rho = 1;
   the starts with
   rest at s lie on the corrected surface; between there is a start that does neither. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas TableLaws TableMotions TableAngle Fate Alpha Stops Threshold Barriers Sides Near Arrives.
Open Scope R_scope.

(* «$(x,y)$ with the velocity $(u,w)$ is a motion on the table that starts with the hyperbolic parameters $A$ and $alpha$ and the angle $psi$» *)
Definition from (A alpha psi : R) (x y u w : R -> R) : Prop :=
  spin x y u w /\ hyperbolic (x 0) (y 0) (u 0) (w 0) A alpha /\ position_angle (x 0) (y 0) (u 0) (w 0) psi.
(* at the time T the velocity is, in the limit, opposite to the position: «the particle at $(x,y)$ comes straight in as the time tends to $T$» *)
Definition straight_in (T : R) (x y u w : R -> R) : Prop := left_lim (fun t => (x t * u t + y t * w t) / (nrm (x t) (y t) * nrm (u t) (w t))) T (-
  (1)).

Lemma values A al psi x y u w : 0 < A -> 0 < al -> from A al psi x y u w -> nrm (u 0) (w 0) = A * sinh al /\ 0 < sinh al /\
  x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2) = A ^ 2 /\
  (x 0 * u 0 + y 0 * w 0) * / nrm (u 0) (w 0) = A * cosh al * cos psi /\ (x 0 * w 0 - y 0 * u 0) * / nrm (u 0) (w 0) = - (A * cosh al * sin psi).
Proof.
  intros A0 a0 (S & [e1 e2] & P). unfold eq111_p, eq112_rho in *. assert (s0 : 0 < sinh al) by (rewrite <- sinh_0; now apply sinh_lt).
  split; trivial. split; trivial.
  apply angle_iff in P as [p1 p2]. rewrite <- !nrm_sq, p1, p2, e1, e2. rewrite !Rpow_mult_distr, cosh2. repeat split; try ring; field; nra.
Qed.
Lemma sinh_small al : 0 < al <= 1 -> sinh al <= 3 * al.
Proof. intros Ha. destruct (hyp_small al Ha) as (e1 & _ & h1 & _ & -> & _). assert (al ^ 3 <= al) by (simpl; nra).
  assert (0 < al ^ 3) by (apply pow_lt; lra). nra. Qed.
Lemma cube_small A al : 0 < A <= 1 -> 0 < al <= 1 -> 0 < sinh al -> 0 <= (A * sinh al) ^ 3 <= 27 * al ^ 3.
Proof.
  intros HA Ha s0. pose proof (sinh_small al Ha). split. apply pow_le; nra. replace (27 * al ^ 3) with ((3 * al) ^ 3) by ring. apply pow_incr.
  split; nra.
Qed.
(* the corrected boundary does not exceed 1 by more than 7 alpha^3; it is nowhere below its least, and is its least at psi = 2 alpha, up to alpha^3 *)
Lemma unit_sizes C S : C ^ 2 + S ^ 2 = 1 -> -1 <= C <= 1 /\ -1 <= S <= 1. Proof. intros H. split; nra. Qed.
Lemma products a b : -1 <= a <= 1 -> -1 <= b <= 1 -> -1 <= a * b <= 1. Proof. intros. split; nra. Qed.
Lemma boundary_top al psi : 0 < al -> right_rest_boundary_a al psi <= 1 + 7 * al ^ 3.
Proof.
  intros a0. rewrite boundary_f2. destruct (half_angle psi) as (h1 & _). set (C := cos (psi / 2)) in *. set (S := sin (psi / 2)) in *.
  destruct (unit_sizes C S h1) as [c1 s1].
  set (h := 11 / 12 * C ^ 3 + 2 * S * C ^ 2 - S ^ 2 * C + 2 / 3 * S ^ 3 + C / 2).
  assert (e : 1 - al * zb al C S = 1 - al * (C - al * h / 2) ^ 2 - al ^ 2 / 4 * (C ^ 2 + S ^ 2) ^ 2 + al ^ 2 / 2 * C ^ 2 * (C ^ 2 + S ^ 2 - 1) + al ^
  3 * h ^ 2 / 4).
  { unfold zb, f2, h. field. } rewrite e, h1. assert (h2 : h ^ 2 <= 28).
  { pose proof (products C C c1 c1) as b1. pose proof (products S C s1 c1) as b2. pose proof (products S S s1 s1) as b3.
  pose proof (products _ _ b1 c1). pose proof (products _ _ b2 c1). pose proof (products _ _ b3 c1). pose proof (products _ _ b3 s1).
    assert (- (51 / 10) <= h <= 51 / 10) by (unfold h; simpl; lra). nra. }
  assert (0 < al ^ 3) by (apply pow_lt; lra). pose proof (pow2_ge_0 (C - al * h / 2)). pose proof (pow2_ge_0 al). nra.
Qed.
Lemma boundary_low al psi : 0 < al -> right_rest_boundary_least al - 10 * al ^ 3 <= right_rest_boundary_a al psi /\
  (psi = 2 * al -> right_rest_boundary_a al psi <= right_rest_boundary_least al + 18 * al ^ 3).
Proof.
  intros a0. rewrite boundary_f2. unfold right_rest_boundary_least. destruct (half_angle psi) as (h1 & _). pose proof (sin_abs (psi / 2)) as sa.
  set (C := cos (psi / 2)) in *. set (S := sin (psi / 2)) in *. destruct (unit_sizes C S h1) as [c1 s1].
  set (G := 2 * C ^ 3 - 7 / 6 * S * (1 + C ^ 2) - S * C ^ 2 + 2 / 3 * S ^ 2 * C - 1 / 4 * S ^ 3).
  assert (e : 1 - al * zb al C S = 1 - al + 7 / 6 * al ^ 2 + al * (S + al * G / 2) ^ 2 - al ^ 3 * G ^ 2 / 4 + al * (1 - C ^ 2 - S ^ 2) + al ^ 2 * (7
  / 6) * (C ^ 2 + 1) * (C ^ 2 + S ^ 2 - 1)).
  { unfold zb, f2, G. field. } rewrite e, h1. replace (1 - C ^ 2 - S ^ 2) with 0 by lra. assert (b : - (25 / 4) <= G <= 25 / 4).
  { pose proof (products C C c1 c1) as b1. pose proof (products S C s1 c1) as b2. pose proof (products S S s1 s1) as b3.
  pose proof (products _ _ b1 c1). pose proof (products _ _ b2 c1). pose proof (products _ _ b3 c1). pose proof (products _ _ b3 s1).
    unfold G; simpl; lra. }
  assert (q : 0 < al ^ 3) by (apply pow_lt; lra). assert (G2 : G ^ 2 <= 40) by nra. pose proof (pow2_ge_0 (S + al * G / 2)). split. nra.
  intros ->. replace (2 * al / 2) with al in sa by field. rewrite (Rabs_pos_eq al) in sa by lra. apply Rabs_le_between in sa.
  assert ((S + al * G / 2) ^ 2 <= (33 / 8 * al) ^ 2) by (apply pow_maj_Rabs; apply Rabs_le; nra). pose proof (pow2_ge_0 G). nra.
Qed.

Theorem walls : exists K a0, 0 < K /\ 0 < a0 <= 1 /\ forall A al psi x y u w, 0 < A -> 0 < al < a0 -> from A al psi x y u w ->
  (A < right_rest_boundary_a al psi - K * al ^ 3 -> exists T, 0 <= T /\ nrm (u T) (w T) = 0 /\ nrm (x T) (y T) < 1) /\
  (right_rest_boundary_a al psi + K * al ^ 3 < A -> exists T, 0 <= T /\ 1 < x T ^ 2 + y T ^ 2 - (u T ^ 2 + w T ^ 2)).
Proof.
  destruct near_b as (K1 & a1 & K10 & Ha1 & nb). destruct sides as (K2 & h & K20 & Hh & sd). cbv zeta in sd. set (K := 4 * (K1 + 27 * K2) + 10).
  set (a0 := Rmin a1 (h / 3)).
  assert (r1 : a0 <= a1) by apply Rmin_l. assert (r2 : a0 <= h / 3) by apply Rmin_r. assert (r0 : 0 < a0) by (apply Rmin_pos; lra). exists K, a0.
  split. unfold K; lra. split. lra.
  intros A al psi x y u w A0 Hal F. pose proof F as (S & _). destruct (values A al psi x y u w A0 ltac:(lra) F) as (ep & s0 & eE & ex & el).
  assert (al3 : 0 < al ^ 3) by (apply pow_lt; lra). pose proof (boundary_top al psi ltac:(lra)) as top.
  destruct (Rle_lt_dec A 1) as [A1 | A1].
  - destruct (nb A al psi ltac:(lra) ltac:(lra)) as (m & m0 & B). pose proof (cube_small A al ltac:(lra) ltac:(lra) s0) as c.
    pose proof (sinh_small al ltac:(lra)) as ss.
    assert (K2 * (A * sinh al) ^ 3 <= K2 * (27 * al ^ 3)) by (apply Rmult_le_compat_l; lra).
    destruct (sd x y u w S) as [d1 d2]. { rewrite ep. nra. } { rewrite ep, eE. rewrite Rpow_mult_distr, (Rmult_comm (A ^ 2)).
    apply Rmult_lt_compat_r. nra. nra. } { rewrite eE. nra. }
    rewrite ex, el, ep in d1, d2. apply Rabs_le_between in B. unfold wall in d1, d2. set (b := wb _ _ _) in *.
    set (d := A - right_rest_boundary_a al psi) in *.
    assert (Kc : 0 < K * al ^ 3) by (apply Rmult_lt_0_compat; unfold K; lra). split; intros k; [ apply d1 | apply d2 ].
    + assert (d < - (K * al ^ 3)) by (unfold d; lra). assert (d * m <= d * / 4) by nra. unfold K in *. lra.
    + assert (K * al ^ 3 < d) by (unfold d; lra). assert (d * / 4 <= d * m) by nra. unfold K in *. lra.
  - split; intros k. { exfalso. unfold K in k. nra. } exists 0. rewrite eE. split; nra.
Qed.

(* a start of each A, alpha, psi *)
Definition start A al psi i := match i with px => A * (cosh al * cos psi) | py => A * (cosh al * sin psi) | pu => A * sinh al | pw => A * 0 end.
Lemma start_from A al psi : 0 <= A -> 0 < al -> from A al psi (V (start A al psi) px) (V (start A al psi) py) (V (start A al psi) pu) (V (start A al
  psi) pw).
Proof.
  intros A0 a0. assert (s0 : 0 < sinh al) by (rewrite <- sinh_0; now apply sinh_lt). pose proof (cosh_pos al). split. apply V_spin.
  unfold hyperbolic, position_angle. rewrite !V_0. unfold start, eq111_p, eq112_rho. rewrite Rmult_0_r.
  assert (e1 : nrm (A * sinh al) 0 = A * sinh al) by (apply nrm_x0;
  nra). assert (e2 : nrm (A * (cosh al * cos psi)) (A * (cosh al * sin psi)) = A * cosh al).
  { unfold nrm. replace ((A * (cosh al * cos psi)) ^ 2 + (A * (cosh al * sin psi)) ^ 2) with ((A * cosh al) ^ 2 * (Rsqr (sin psi) + Rsqr (cos psi)))
  by (unfold Rsqr; ring).
    rewrite sin2_cos2, Rmult_1_r. apply sqrt_pow2. nra. } rewrite e1, e2. repeat split; ring.
Qed.
(* of the starts with given alpha and psi, one neither comes to rest inside rho = s nor gets beyond rho^2 - p^2 = s^2 *)
Lemma between s al psi : 0 < s <= 1 -> 0 < al -> exists A x y u w, 0 < A /\ from A al psi x y u w /\
  forall t, 0 <= t -> s <= nrm (x t) (y t) + nrm (u t) (w t) /\ nrm (x t) (y t) ^ 2 - nrm (u t) (w t) ^ 2 <= s ^ 2.
Proof.
  intros Hs a0. assert (s0 : 0 < sinh al) by (rewrite <- sinh_0; now apply sinh_lt). pose proof (cosh_pos al) as c0. pose proof (cosh2 al) as cs.
  assert (sc : sinh al <= cosh al) by nra.
  destruct (threshold (fun r => start r al psi) (cosh al) s 2 c0 Hs) as (A & A0 & K).
  - intros r q i. assert (k : forall a, Rabs a <= cosh al -> Rabs (r * a - q * a) <= cosh al * Rabs (r - q)).
    { intros a Ha. replace (r * a - q * a) with (a * (r - q)) by ring. rewrite Rabs_mult. apply Rmult_le_compat_r; trivial. apply Rabs_pos. }
    pose proof (COS_bound psi). pose proof (SIN_bound psi). destruct i; apply k; apply Rabs_le; split; nra.
  - exists 0. rewrite !V_0. unfold start. rewrite !Rmult_0_l. rewrite nrm_x0 by lra. lra.
  - intros r Hr. assert (A0 : 0 <= r) by lra. pose proof (start_from r al psi A0 a0) as F.
    destruct (values r al psi _ _ _ _ ltac:(lra) a0 F) as (_ & _ & e & _). exists 0. rewrite !nrm_sq, e. split; nra.
  - exists A, (V (start A al psi) px), (V (start A al psi) py), (V (start A al psi) pu), (V (start A al psi) pw).
    assert (A1 : 0 < A). { destruct A0 as [k | k]; trivial. exfalso. destruct (K 0 (Rle_refl 0)) as [k1 _]. rewrite !V_0 in k1. rewrite <- k in k1.
    unfold start in k1. rewrite !Rmult_0_l, nrm_x0 in k1 by lra. lra. }
    split; trivial. split; trivial. apply start_from; lra.
Qed.
(* the first stop of a motion that comes to rest inside rho = 1 is its last *)
Lemma stops_for_good s x y u w : spin x y u w -> 0 <= s <= 1 -> 0 < nrm (u 0) (w 0) -> rests_at s x y u w ->
  exists T, 0 < T /\ nrm (u T) (w T) = 0 /\ nrm (x T) (y T) = s /\ forall t, 0 <= t < T -> 0 < nrm (u t) (w t).
Proof.
  intros S Hs p0 (T' & T0' & e & still). destruct (still T' (Rle_refl _)) as (_ & _ & z1 & z2). pose proof (at_rest u w T' z1 z2) as pT'.
  destruct (first_stop x y u w S p0) as [N | (T & T0 & pT & N)]. { specialize (N T' T0'). lra. }
  exists T. assert (TT : T <= T') by (apply Rnot_lt_le; intros k; specialize (N T' ltac:(lra)); lra). repeat split; trivial.
  pose proof (A_never_falls x y u w S T T' ltac:(lra)) as up. rewrite <- !nrm_sq, pT, pT', e in up.
  destruct (table_rest_lasts x y u w S T T' ltac:(lra) pT) as (e1 & e2 & _). rewrite <- nrm_sq; nra.
  rewrite e1, e2 in e. exact e.
Qed.
Lemma straight_at_one x y u w T : spin x y u w -> 0 < T -> nrm (u T) (w T) = 0 -> nrm (x T) (y T) = 1 -> (forall t, 0 <= t < T ->
  0 < nrm (u t) (w t)) -> straight_in T x y u w.
Proof.
  intros S T0 z e N. pose proof (stops_at_one x y u w S T T0 z N e) as L.
  assert (R : left_lim (fun t => nrm (x t) (y t)) T 1). { rewrite <- e. apply (ll_cont (fun t => nrm (x t) (y t))).
  cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) ]; lra. }
  unfold straight_in. eapply ll_eq. eapply ll_soon. 2: apply (ll_mult _ _ _ _ _ L (ll_inv _ _ _ R ltac:(lra))). 2: field.
  destruct (ll_from _ 0 T _ (1 / 2) T0 R ltac:(lra)) as (r & Hr & H). apply (soon_after r); [ lra | ]. intros t Ht. specialize (H t Ht).
  specialize (N t ltac:(lra)). cbv beta. field. lra.
Qed.

Lemma on_surface s : 0 < s < 1 -> exists K a0, 0 < K /\ 0 < a0 <= 1 /\ forall A al psi x y u w, 0 < A -> 0 < al < a0 -> from A al psi x y u w ->
  rests_at s x y u w ->
  Rabs (A - right_rest_surface_a s al psi) <= K * al ^ 3.
Proof.
  intros Hs. destruct (between_walls s Hs) as (K1 & h & K10 & Hh & bw). destruct (near_s s Hs) as (K2 & a2 & K20 & Ha2 & ns).
  set (a0 := Rmin a2 (h / 3)).
  assert (r1 : a0 <= a2) by apply Rmin_l. assert (r2 : a0 <= h / 3) by apply Rmin_r. assert (r0 : 0 < a0) by (apply Rmin_pos; lra).
  set (K := (27 * K1 + K2) * (2 / s)).
  assert (i0 : 0 < 2 / s) by (apply Rdiv_lt_0_compat; lra). exists K, a0. split. unfold K; nra. split. lra. intros A al psi x y u w A0 Hal F rest.
  pose proof F as (S & _).
  destruct (values A al psi x y u w A0 ltac:(lra) F) as (ep & s0 & eE & ex & el).
  destruct (stops_for_good s x y u w S ltac:(lra) ltac:(rewrite ep; nra) rest) as (T & T0 & pT & rT & N).
  pose proof (A_never_falls x y u w S 0 T ltac:(lra)) as up. rewrite eE, <- !nrm_sq, pT, rT in up. assert (A1 : A <= 1) by nra.
  pose proof (cube_small A al ltac:(lra) ltac:(lra) s0) as c. pose proof (sinh_small al ltac:(lra)) as ss.
  specialize (bw x y u w T S T0 pT rT N). rewrite ex, el, ep, eE in bw. assert (bw' := bw ltac:(rewrite Rpow_mult_distr, (Rmult_comm (A ^ 2));
  apply Rmult_lt_compat_r; nra)). clear bw.
  destruct (ns A al psi ltac:(lra) ltac:(lra)) as (m & m0 & B). set (b := ws _ _ _ _) in *. set (B0 := right_rest_surface_a s al psi) in *.
  assert (q : Rabs (A - B0) * m <= (27 * K1 + K2) * al ^ 3).
  { rewrite <- (Rabs_pos_eq m) at 1 by lra. rewrite <- Rabs_mult. replace ((A - B0) * m) with (b + - (b - (A - B0) * m)) by ring.
  eapply Rle_trans; [ apply Rabs_triang | ]. rewrite Rabs_Ropp.
    assert (K1 * (A * sinh al) ^ 3 <= K1 * (27 * al ^ 3)) by (apply Rmult_le_compat_l; lra). lra. }
  pose proof (Rabs_pos (A - B0)). unfold K. replace ((27 * K1 + K2) * (2 / s) * al ^ 3) with ((27 * K1 + K2) * al ^ 3 * (2 / s)) by ring.
  apply Rle_trans with (Rabs (A - B0) * m * (2 / s)). 2: apply Rmult_le_compat_r; lra. rewrite Rmult_assoc. rewrite <- (Rmult_1_r (Rabs _)) at 1.
  apply Rmult_le_compat_l; trivial.
  apply Rle_trans with (s / 2 * (2 / s)). right; field; lra. apply Rmult_le_compat_r; lra.
Qed.
