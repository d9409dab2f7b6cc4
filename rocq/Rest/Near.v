(* From A, alpha and psi to the walls of Barriers.v, for small alpha: sinh and cosh by their first terms, what is left bounded.
   With that: the fates near alpha = 0 by the corrected boundary, and the starts with rest at s by the corrected surface. *)
Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas Turntable Fate Alpha TableAngle Stops Bounded Barriers Sides.
Import ListNotations.
Open Scope R_scope.

Lemma sh_mean a : 0 < a -> exists c, 0 < c < a /\ sinh a = cosh c * a.
Proof.
  intros Ha. destruct (MVT_cor2 sinh cosh 0 a Ha) as (c & e & Hc). intros; apply derivable_pt_lim_sinh.
  exists c. split; trivial. rewrite sinh_0 in e. lra.
Qed.
Lemma ch_le a b : 0 <= a <= b -> 1 <= cosh a <= cosh b.
Proof.
  intros H. assert (s0 : 0 <= sinh a). { rewrite <- sinh_0. destruct (Rle_lt_or_eq_dec 0 a ltac:(lra)) as [l | <-]; [ left;
  now apply sinh_lt | lra ]. }
  assert (s1 : sinh a <= sinh b). { destruct (Rle_lt_or_eq_dec a b ltac:(lra)) as [l | <-]; [ left; now apply sinh_lt | lra ]. }
  pose proof (cosh2 a). pose proof (cosh2 b). pose proof (cosh_pos a). pose proof (cosh_pos b). split; nra.
Qed.
Lemma hyp_small a : 0 < a <= 1 -> exists e1 e2, 0 <= e1 <= 2 /\ 0 <= e2 <= 2 /\ sinh a = a + a ^ 3 * e1 /\ cosh a = 1 + a ^ 2 * e2.
Proof.
  intros Ha. assert (c1 : forall c, 0 <= c <= 1 -> cosh c <= 2).
  { intros c Hc. pose proof (ch_le c 1 Hc) as k. enough (cosh 1 <= 2) by lra. unfold cosh. pose proof exp_le_3.
  pose proof (exp_increasing (- (1)) 0 ltac:(lra)) as e. rewrite exp_0 in e. lra. }
  assert (k : 0 <= cosh a - 1 <= a ^ 2 * 2).
  { replace a with (2 * (a / 2)) at 1 2 by field. rewrite cosh_double. destruct (sh_mean (a / 2) ltac:(lra)) as (c & Hc & ->).
  pose proof (c1 c ltac:(lra)).
    pose proof (ch_le 0 c ltac:(lra)). assert (0 <= cosh c * (a / 2) <= a) by (split; nra). split; nra. }
  destruct (sh_mean a ltac:(lra)) as (c & Hc & e). pose proof (ch_le c a ltac:(lra)) as cc.
  assert (a2 : 0 < a ^ 2) by (apply pow_lt; lra). assert (a3 : 0 < a ^ 3) by (apply pow_lt; lra).
  exists ((cosh c - 1) / a ^ 2), ((cosh a - 1) / a ^ 2). repeat split; try (apply Rle_div_r; lra); try (apply Rle_div_l; lra).
  - rewrite e. field. lra.
  - field. lra.
Qed.

(* ---- the boundary ---- *)
Definition f2 C S := 7 / 6 * C ^ 4 + 2 * S * C ^ 3 - S ^ 2 * C ^ 2 + 2 / 3 * S ^ 3 * C - 1 / 4 * S ^ 4.
Definition zb al C S := C ^ 2 - al * f2 C S.
Definition fa C S := / 2 - 5 / 24 + 0 * (C + S).
Definition fb C S := - (5 / 12) * (C ^ 2 - S ^ 2) - 4 / 3 * (2 * S * C).
Definition fc C S := - (5 / 24) * (C ^ 2 - S ^ 2) ^ 2 - 2 / 3 * (2 * S * C) * (C ^ 2 - S ^ 2).
Definition slope_m A b al C S := al * (1 + (C ^ 2 - S ^ 2) * (A + b)) + al ^ 2 * ((A + b) * fa C S + (A ^ 2 + A * b + b ^ 2) * fb C S + (A ^ 3 + A ^
  2 * b + A * b ^ 2 + b ^ 3) * fc C S).
Definition left_1 A al C S e1 e2 := let c := C ^ 2 - S ^ 2 in let s := 2 * S * C in let h := 1 + al ^ 2 * e2 in
  A * e1 * (1 + A * h * c) + A ^ 2 * c * e2 + A ^ 3 * (1 + al ^ 2 * e1) ^ 3 * q3 (A * h * c) (- A * h * s)
  + al * A ^ 2 * (2 * e1 + al ^ 2 * e1 ^ 2) * q2 (A * h * c) (- A * h * s)
  + al * A ^ 2 * (- (5 / 24) * e2 * A * c * (2 + A * c * h + A * c) + 2 / 3 * (- A * s) * (2 * e2 + A * c * e2 * (2 + al ^ 2 * e2))).
Definition left_2 al C S := let c := C ^ 2 - S ^ 2 in let z := zb al C S in let b := 1 - al * z in
  - f2 C S * (z + C ^ 2) + f2 C S * (1 + 2 * c) + z ^ 2 * c - z * ((b + 1) * fa C S + (b ^ 2 + b + 1) * fb C S + (b ^ 3 + b ^ 2 + b + 1) * fc C S).
Lemma wb_near A al C S e1 e2 : C ^ 2 + S ^ 2 = 1 -> (A * (1 + al ^ 2 * e2)) ^ 2 - (A * (al + al ^ 3 * e1)) ^ 2 = A ^ 2 ->
  let b := 1 - al * zb al C S in let h := 1 + al ^ 2 * e2 in
  wb (A * (al + al ^ 3 * e1)) (A * h * (C ^ 2 - S ^ 2)) (- A * h * (2 * S * C)) = (A - b) * (A + b + slope_m A b al C S) + al ^ 3 * (left_1 A al C S
  e1 e2 + left_2 al C S).
Proof.
  intros HC HA b h. assert (HS : S ^ 2 = 1 - C ^ 2) by lra.
  transitivity (A ^ 2 - 1 + A * (al + al ^ 3 * e1) * (1 + A * h * (C ^ 2 - S ^ 2)) + (A * (al + al ^ 3 * e1)) ^ 2 * q2 (A * h * (C ^ 2 - S ^ 2)) (- A
  * h * (2 * S * C))
    + (A * (al + al ^ 3 * e1)) ^ 3 * q3 (A * h * (C ^ 2 - S ^ 2)) (- A * h * (2 * S * C))).
  { unfold wb. rewrite <- HA. fold h. assert (k : (C ^ 2 - S ^ 2) ^ 2 + (2 * S * C) ^ 2 = 1). { transitivity ((C ^ 2 + S ^ 2) ^ 2). ring. rewrite HC.
  ring. }
    replace ((A * h * (C ^ 2 - S ^ 2)) ^ 2 + (- A * h * (2 * S * C)) ^ 2) with ((A * h) ^ 2 * ((C ^ 2 - S ^ 2) ^ 2 + (2 * S * C) ^ 2)) by ring.
    rewrite k. ring. }
  transitivity (A ^ 2 - 1 + A * al * (1 + A * (C ^ 2 - S ^ 2)) + al ^ 2 * (A ^ 2 * fa C S + A ^ 3 * fb C S + A ^ 4 * fc C S) + al ^ 3 * left_1 A al C
  S e1 e2).
  { unfold left_1. cbv zeta. fold h. set (Q3 := q3 _ _). unfold q2, fa, fb, fc, h. field. }
  transitivity ((A - b) * (A + b + slope_m A b al C S) + (b ^ 2 - 1 + b * al * (1 + b * (C ^ 2 - S ^ 2)) + al ^ 2 * (b ^ 2 * fa C S + b ^ 3 * fb C S
  + b ^ 4 * fc C S)) + al ^ 3 * left_1 A al C S e1 e2).
  { unfold slope_m. ring. }
  enough (k : b ^ 2 - 1 + b * al * (1 + b * (C ^ 2 - S ^ 2)) + al ^ 2 * (b ^ 2 * fa C S + b ^ 3 * fb C S + b ^ 4 * fc C S) = al ^ 3 * left_2 al C S)
  by (rewrite k; ring).
  unfold left_2. cbv zeta. fold b. set (z := zb al C S) in *.
  transitivity (al ^ 2 * (2 * f2 C S + C ^ 4 - C ^ 2 * (1 + 2 * (C ^ 2 - S ^ 2)) + (fa C S + fb C S + fc C S))
    + al ^ 3 * (- f2 C S * (z + C ^ 2) + f2 C S * (1 + 2 * (C ^ 2 - S ^ 2)) + z ^ 2 * (C ^ 2 - S ^ 2) - z * ((b + 1) * fa C S + (b ^ 2 + b + 1) * fb
      C S + (b ^ 3 + b ^ 2 + b + 1) * fc C S))
    + al * (1 - C ^ 2 - S ^ 2)).
  { set (a1 := fa C S). set (a2 := fb C S). set (a3 := fc C S). unfold b, z, zb. set (f := f2 C S). ring. }
  enough (k : 2 * f2 C S + C ^ 4 - C ^ 2 * (1 + 2 * (C ^ 2 - S ^ 2)) + (fa C S + fb C S + fc C S) = 0) by (rewrite k;
  replace (1 - C ^ 2 - S ^ 2) with 0 by lra; ring).
  unfold f2, fa, fb, fc. replace (S ^ 4) with (S ^ 2 * S ^ 2) by ring. replace (S ^ 3) with (S ^ 2 * S) by ring. rewrite HS. ring_simplify. 
  replace (S ^ 2) with (1 - C ^ 2). field.
Qed.
Lemma boundary_f2 al psi : right_rest_boundary_a al psi = 1 - al * zb al (cos (psi / 2)) (sin (psi / 2)).
Proof. unfold right_rest_boundary_a, zb, f2. field. Qed.
Lemma half_angle psi : cos (psi / 2) ^ 2 + sin (psi / 2) ^ 2 = 1 /\ cos psi = cos (psi / 2) ^ 2 - sin (psi / 2) ^ 2 /\
  sin psi = 2 * sin (psi / 2) * cos (psi / 2).
Proof.
  pose proof (sin2_cos2 (psi / 2)) as e. unfold Rsqr in e. pose proof (cos_2a (psi / 2)) as c2. pose proof (sin_2a (psi / 2)) as s2.
  replace (2 * (psi / 2)) with psi in c2, s2 by field. repeat split; lra.
Qed.
Lemma near_b : exists K a0, 0 < K /\ 0 < a0 <= 1 /\ forall A al psi, 0 < A <= 1 -> 0 < al < a0 ->
  exists m, / 4 <= m /\ Rabs (wb (A * sinh al) (A * cosh al * cos psi) (- (A * cosh al * sin psi)) - (A - right_rest_boundary_a al psi) * m) <= K *
  al ^ 3.
Proof.
  assert (B1 : bnd (fun v => left_1 (v 0%nat) (v 1%nat) (v 2%nat) (v 3%nat) (v 4%nat) (v 5%nat) + left_2 (v 1%nat) (v 2%nat) (v 3%nat))).
  { unfold left_1, left_2, zb, f2, fa, fb, fc, q2, q3. bounded. }
  assert (B2 : bnd (fun v => 1 + (v 2%nat ^ 2 - v 3%nat ^ 2) * (v 0%nat + (1 - v 1%nat * zb (v 1%nat) (v 2%nat) (v 3%nat))) +
    v 1%nat * ((v 0%nat + (1 - v 1%nat * zb (v 1%nat) (v 2%nat) (v 3%nat))) * fa (v 2%nat) (v 3%nat) + (v 0%nat ^ 2 + v 0%nat * (1 - v 1%nat * zb (v
    1%nat) (v 2%nat) (v 3%nat)) + (1 - v 1%nat * zb (v 1%nat) (v 2%nat) (v 3%nat)) ^ 2) * fb (v 2%nat) (v 3%nat) + (v 0%nat ^ 3 + v 0%nat ^ 2 * (1 -
    v 1%nat * zb (v 1%nat) (v 2%nat) (v 3%nat)) + v 0%nat * (1 - v 1%nat * zb (v 1%nat) (v 2%nat) (v 3%nat)) ^ 2 + (1 - v 1%nat * zb (v 1%nat) (v
    2%nat) (v 3%nat)) ^ 3) * fc (v 2%nat) (v 3%nat)))).
  { unfold zb, f2, fa, fb, fc. bounded. }
  assert (B3 : bnd (fun v => zb (v 1%nat) (v 2%nat) (v 3%nat))) by (unfold zb, f2; bounded).
  destruct (B1 2 ltac:(lra)) as (K & K0 & H1). destruct (B2 2 ltac:(lra)) as (K2 & K20 & H2). destruct (B3 2 ltac:(lra)) as (K3 & K30 & H3).
  assert (a00 : 0 < / (4 * (K2 + K3 + 1)) <= 1). { split. apply Rinv_0_lt_compat; lra. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  exists K, (/ (4 * (K2 + K3 + 1))). split; trivial. split; trivial. intros A al psi HA Hal.
  assert (ka : al * (K2 + K3 + 1) <= / 4). { replace (/ 4) with (/ (4 * (K2 + K3 + 1)) * (K2 + K3 + 1)) by (field; lra).
  apply Rmult_le_compat_r; lra. }
  destruct (hyp_small al ltac:(lra)) as (e1 & e2 & H4 & H5 & es & ec). destruct (half_angle psi) as (h1 & h2 & h3).
  set (C := cos (psi / 2)) in *. set (S := sin (psi / 2)) in *.
  assert (V : forall i, Rabs (vals [A; al; C; S; e1; e2] i) <= 2).
  { apply vals_le. lra. pose proof (COS_bound (psi / 2)) as cb. pose proof (SIN_bound (psi / 2)) as sb. fold C in cb. fold S in sb. intros r Hr.
  simpl in Hr. repeat (destruct Hr as [<- | Hr]; [ apply Rabs_le; lra | ]). destruct Hr. }
  specialize (H1 _ V). specialize (H2 _ V). specialize (H3 _ V). cbn [vals] in H1, H2, H3. set (b := 1 - al * zb al C S) in *.
  exists (A + b + slope_m A b al C S). apply Rabs_le_between in H2, H3. split.
  - assert (- (al * K2) <= slope_m A b al C S).
    { unfold slope_m. match type of H2 with _ <= ?g <= _ => apply Rle_trans with (al * g) end. nra. right. unfold b. ring. }
    assert (al * zb al C S <= al * K3) by nra. assert (1 - al * K3 <= b) by (unfold b; lra). lra.
  - rewrite boundary_f2. fold C S b. rewrite es, ec, h2, h3. pose proof (wb_near A al C S e1 e2 h1) as k. cbv zeta in k. fold b in k.
    replace (A * (1 + al ^ 2 * e2) * (C ^ 2 - S ^ 2)) with (A * (1 + al ^ 2 * e2) * (C ^ 2 - S ^ 2)) by ring.
    replace (- (A * (1 + al ^ 2 * e2) * (2 * S * C))) with (- A * (1 + al ^ 2 * e2) * (2 * S * C)) by ring. rewrite k.
    2: { rewrite <- es, <- ec. rewrite !Rpow_mult_distr, cosh2. ring. }
    match goal with |- Rabs ?g <= _ => replace g with (al ^ 3 * (left_1 A al C S e1 e2 + left_2 al C S)) by ring end.
    rewrite Rabs_mult, Rabs_pos_eq, Rmult_comm by (apply pow_le; lra). apply Rmult_le_compat_r; [ apply pow_le; lra | exact H1 ].
Qed.

(* ---- the starts with rest at s ---- *)
Definition slope_s s d A al c := A + (s - s * al ^ 2 * (/ 4 + (1 + s * c) ^ 2 * d * / 2)) +
  al ^ 2 * ((A + s) * (/ 2 + d) + (A ^ 2 + A * s + s ^ 2) * (2 * d * c) + (A ^ 3 + A ^ 2 * s + A * s ^ 2 + s ^ 3) * (d * c ^ 2)).
Definition left_s s d A al c e1 e2 := let be := / 4 + (1 + s * c) ^ 2 * d * / 2 in let h := 1 + al ^ 2 * e2 in
  s ^ 2 * be ^ 2 + A ^ 3 * d * c * e2 * (2 + A * h * c + A * c) + A ^ 2 * (2 * e1 + al ^ 2 * e1 ^ 2) * (/ 2 + (1 + A * h * c) ^ 2 * d)
  - s * be * ((A + s) * (/ 2 + d) + (A ^ 2 + A * s + s ^ 2) * (2 * d * c) + (A ^ 3 + A ^ 2 * s + A * s ^ 2 + s ^ 3) * (d * c ^ 2)).
Lemma ws_near s d A al c e1 e2 : let be := / 4 + (1 + s * c) ^ 2 * d * / 2 in let h := 1 + al ^ 2 * e2 in
  A ^ 2 - s ^ 2 + (A * (al + al ^ 3 * e1)) ^ 2 * (/ 2 + (1 + A * h * c) ^ 2 * d) = (A - (s - s * al ^ 2 * be)) * slope_s s d A al c + al ^ 4 * left_s
  s d A al c e1 e2.
Proof. unfold slope_s, left_s. cbv zeta. field. Qed.
Lemma bend_q s psi : 0 < s < 1 -> right_rest_surface_a s 1 psi = s - s * (/ 4 + (1 + s * cos psi) ^ 2 * / (2 * (1 - s ^ 2)) * / 2).
Proof.
  intros Hs. unfold right_rest_surface_a. destruct (half_angle psi) as (h1 & -> & _). set (C := cos (psi / 2)) in *. set (S := sin (psi / 2)) in *.
  replace (S ^ 2) with (1 - C ^ 2) by lra. field. nra.
Qed.
Lemma near_s s : 0 < s < 1 -> exists K a0, 0 < K /\ 0 < a0 <= 1 /\ forall A al psi, 0 < A <= 1 -> 0 < al < a0 ->
  exists m, s / 2 <= m /\ Rabs (ws s (A * sinh al) (A * cosh al * cos psi) (- (A * cosh al * sin psi)) - (A - right_rest_surface_a s al psi) * m) <=
  K * al ^ 3.
Proof.
  intros Hs. set (d := / (2 * (1 - s ^ 2))). assert (d0 : 0 < d) by (apply Rinv_0_lt_compat; nra).
  assert (B1 : bnd (fun v => left_s (v 0%nat) (v 1%nat) (v 2%nat) (v 3%nat) (v 4%nat) (v 5%nat) (v 6%nat))) by (unfold left_s; bounded).
  assert (B2 : bnd (fun v => - (v 0%nat * (/ 4 + (1 + v 0%nat * v 4%nat) ^ 2 * v 1%nat * / 2)) + ((v 2%nat + v 0%nat) * (/ 2 + v 1%nat) + (v 2%nat ^
  2 + v 2%nat * v 0%nat + v 0%nat ^ 2) * (2 * v 1%nat * v 4%nat)
    + (v 2%nat ^ 3 + v 2%nat ^ 2 * v 0%nat + v 2%nat * v 0%nat ^ 2 + v 0%nat ^ 3) * (v 1%nat * v 4%nat ^ 2)))) by bounded.
  destruct (B1 (2 + d) ltac:(lra)) as (K & K0 & H1). destruct (B2 (2 + d) ltac:(lra)) as (K2 & K20 & H2).
  assert (a00 : 0 < s / (2 * (K2 + 1)) <= 1). { split. apply Rdiv_lt_0_compat; lra. apply Rle_div_l; lra. }
  exists K, (s / (2 * (K2 + 1))). split; trivial. split; trivial. intros A al psi HA Hal.
  assert (ka : al * (K2 + 1) <= s / 2). { replace (s / 2) with (s / (2 * (K2 + 1)) * (K2 + 1)) by (field; lra). apply Rmult_le_compat_r; lra. }
  destruct (hyp_small al ltac:(lra)) as (e1 & e2 & H4 & H5 & es & ec).
  assert (V : forall i, Rabs (vals [s; d; A; al; cos psi; e1; e2] i) <= 2 + d).
  { apply vals_le. lra. pose proof (COS_bound psi) as cb. intros r Hr. simpl in Hr. repeat (destruct Hr as [<- | Hr]; [ apply Rabs_le; lra | ]).
  destruct Hr. }
  specialize (H1 _ V). specialize (H2 _ V). cbn [vals] in H1, H2. set (c := cos psi) in *.
  exists (slope_s s d A al c). apply Rabs_le_between in H2. split.
  - match type of H2 with _ <= ?g <= _ => assert (e : slope_s s d A al c = A + s + al ^ 2 * g) by (unfold slope_s; ring); rewrite e;
    set (z := g) in * end.
    assert (al ^ 2 <= al) by nra. assert (0 <= al ^ 2 * (z + K2)) by (apply Rmult_le_pos; [ apply pow2_ge_0 | lra ]).
    assert (al ^ 2 * K2 <= al * K2) by (apply Rmult_le_compat_r; lra). lra.
  - assert (eb : right_rest_surface_a s al psi = s - s * al ^ 2 * (/ 4 + (1 + s * c) ^ 2 * d * / 2)).
    { pose proof (bend_q s psi Hs) as k. fold d c in k. unfold right_rest_surface_a in *. set (q := (_ / _ + _) + _) in *. rewrite pow1 in k.
    assert (q' : s * q = s * (/ 4 + (1 + s * c) ^ 2 * d * / 2)) by lra.
      transitivity (s - al ^ 2 * (s * q)). ring. rewrite q'. ring. }
    assert (ew : ws s (A * sinh al) (A * cosh al * c) (- (A * cosh al * sin psi)) = A ^ 2 - s ^ 2 + (A * (al + al ^ 3 * e1)) ^ 2 * (/ 2 + (1 + A * (1
    + al ^ 2 * e2) * c) ^ 2 * d)).
    { unfold ws, qs. fold d. assert (k : A ^ 2 = (A * cosh al) ^ 2 * (c ^ 2 + sin psi ^ 2) - (A * sinh al) ^ 2).
      { pose proof (sin2_cos2 psi) as q. unfold Rsqr in q. fold c in q. replace (c ^ 2 + sin psi ^ 2) with 1 by lra. rewrite !Rpow_mult_distr, cosh2.
      ring. }
      rewrite k at 1. rewrite es, ec. ring. }
    rewrite eb, ew. pose proof (ws_near s d A al c e1 e2) as k. cbv zeta in k. rewrite k.
    match goal with |- Rabs ?g <= _ => replace g with (al ^ 3 * (al * left_s s d A al c e1 e2)) by ring end.
    rewrite Rabs_mult, Rabs_pos_eq, Rmult_comm by (apply pow_le; lra). apply Rmult_le_compat_r; [ apply pow_le; lra | ].
    rewrite Rabs_mult, Rabs_pos_eq by lra. pose proof (Rabs_pos (left_s s d A al c e1 e2)). nra.
Qed.
