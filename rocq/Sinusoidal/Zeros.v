(* Below lambda_c the velocity of every motion, not of (38) only, has late two zeros in each period: beside a zero of (38) the drive beats friction,
   so that w is strictly monotone there, and elsewhere w is as close to (38) as one likes. *)
Require Import Reals Lra Psatz ZArith Ranalysis5.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas Pieces Periodic Aniso Steady Shaken LargeTime.
Open Scope R_scope.

Section Zeros.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 < l < eq37_lambda_c.
Hypothesis M : shaken l phi0 w wy.
Notation p := (eq39_phi_t1 l).
Lemma z_1 : 0 < l < 1. Proof. pose proof lambda_c_between. lra. Qed.
Lemma z_0 : 0 <= l. Proof. lra. Qed.
Lemma z_c : l <= eq37_lambda_c. Proof. lra. Qed.
Lemma z_p : 0 < l <= eq37_lambda_c. Proof. lra. Qed.
Lemma room : asin l < p /\ p < PI / 2 /\ 0 < asin l.
Proof. destruct (p_facts l z_1 z_c) as [a [_ c]]. destruct (p1_range l z_1) as [b _]. specialize (c (proj2 hl)). lra. Qed.
(* with the sign of the drive, the velocity grows beside a zero of (38) *)
Lemma grows d Z j y1 y2 : 0 < d <= (p - asin l) / 2 -> phi0 + Z = p + IZR j * PI -> 0 <= Z - d -> Z - d <= y1 < y2 -> y2 <= Z + d -> sg j * w y1 < sg j * w y2.
Proof.
  intros hd hZ h0 hy hy2. destruct room as (a & b & c). pose proof (gain l phi0 w wy z_0 M y1 y2 ltac:(lra)) as G.
  assert (C : forall y, cos (phi0 + y) = sg j * cos (p + (y - Z))).
  { intros y. rewrite (a_shift PI cos neg_cos (phi0 + y) j). f_equal. f_equal. lra. }
  rewrite !C in G. assert (U : g38 l p (y1 - Z) < g38 l p (y2 - Z)).
  { apply (up (g38 l p) (fun t => sin (p + t) - l)); [ lra | intros; apply g_der | ]. intros x Hx. pose proof (sin_above l z_1 (p + x)). lra. }
  unfold g38 in U. destruct (sg_cases j) as [e | e]; rewrite e in *; lra.
Qed.
Lemma crossing d Z j : 0 < d <= (p - asin l) / 2 -> phi0 + Z = p + IZR j * PI -> 0 < Z - d -> sg j * w (Z - d) < 0 -> 0 < sg j * w (Z + d) ->
  exists z, Z - d < z < Z + d /\ w z = 0 /\ forall y, Z - d <= y <= Z + d -> w y = 0 -> y = z.
Proof.
  intros hd hZ h0 n q. destruct (IVT_interv (fun y => sg j * w y) (Z - d) (Z + d)) as [z [z1 z2]]; trivial; [ | lra | ].
  - intros y Hy. cont. apply (cont_w l phi0 w wy M). lra.
  - assert (z <> Z - d) by (intros ->; lra). assert (z <> Z + d) by (intros ->; lra). assert (wz : w z = 0) by (destruct (sg_cases j) as [e | e]; rewrite e in z2; lra).
    exists z. split; [ lra | split; [ trivial | ] ]. intros y Hy wy0. destruct (Rtotal_order y z) as [k | [k | k]]; trivial; exfalso.
    + pose proof (grows d Z j y z hd hZ ltac:(lra) ltac:(lra) ltac:(lra)) as g. rewrite wz, wy0 in g. lra.
    + pose proof (grows d Z j z y hd hZ ltac:(lra) ltac:(lra) ltac:(lra)) as g. rewrite wz, wy0 in g. lra.
Qed.
(* away from the zeros of (38) the velocity has late the sign of (38), and a size *)
Lemma late_sign d : 0 < d < PI / 2 -> exists m s1, 0 < m /\ 1 <= s1 /\ forall s j, s1 <= s -> d <= phi0 + s - p - IZR j * PI <= PI - d -> m <= sg j * w s.
Proof.
  intros hd. destruct (continuity_ab_min (g38 l p) d (PI - d) ltac:(lra)) as (x & X1 & X2).
  { intros c _. apply derivable_continuous_pt. exists (sin (p + c) - l). apply is_derive_Reals, g_der. }
  pose proof (g_pos l z_1 z_c x ltac:(lra)) as m0. set (m := g38 l p x) in *.
  destruct (w38_attracts l z_p phi0 w wy M) as [L _]. apply is_lim_spec in L. destruct (L (mkposreal (m / 2) ltac:(lra))) as [T HT]. simpl in HT.
  exists (m / 2), (Rmax (T + 1) 1). split; [ lra | split; [ apply Rmax_r | ] ]. intros s j hs H. pose proof (Rmax_l (T + 1) 1).
  specialize (HT s ltac:(lra)). rewrite Rminus_0_r in HT. apply Rabs_def2 in HT. specialize (X1 (phi0 + s - p - IZR j * PI) H).
  rewrite w38_ext, (ext_on PI _ PI_RGT_0 j) in HT by lra. destruct (sg_cases j) as [e | e]; rewrite e in *; lra.
Qed.
Lemma two_zeros psi : (forall n, psi <> p + IZR n * PI) -> exists s1, forall s, s1 <= s -> at_phase phi0 s psi ->
  exists z1 z2, s < z1 < z2 /\ z2 < s + 2 * PI /\ forall z, s <= z <= s + 2 * PI -> (w z = 0 <-> z = z1 \/ z = z2).
Proof.
  intros ne. pose proof PI_RGT_0. destruct room as (ra & rb & rc). destruct (per_spec p PI ltac:(lra) psi) as [n Hn]. set (u := psi - p - IZR n * PI).
  assert (hu : 0 < u < PI). { specialize (ne n). unfold u. split; [ | lra ]. destruct (Rle_lt_or_eq_dec _ _ (proj1 Hn)); lra. }
  set (d := Rmin ((p - asin l) / 2) (Rmin u (PI - u) / 2)).
  assert (hd : 0 < d /\ d <= (p - asin l) / 2 /\ d < u /\ d < PI - u).
  { assert (0 < Rmin u (PI - u)) by (apply Rmin_pos; lra). pose proof (Rmin_l u (PI - u)). pose proof (Rmin_r u (PI - u)).
    pose proof (Rmin_r ((p - asin l) / 2) (Rmin u (PI - u) / 2)) as R. pose proof (Rmin_l ((p - asin l) / 2) (Rmin u (PI - u) / 2)) as L. fold d in R, L.
    assert (0 < d) by (unfold d; apply Rmin_pos; lra). lra. }
  clearbody d. destruct (late_sign d ltac:(lra)) as (m & s1 & m0 & s0 & S). exists (s1 + d). intros s hs [k Hk].
  set (Z1 := s + (PI - u)). set (Z2 := s + (2 * PI - u)). set (j := (n + 2 * k)%Z). assert (Ij : IZR j = IZR n + 2 * IZR k) by (unfold j; rewrite plus_IZR, mult_IZR; trivial).
  assert (I1 : IZR (j + 1) = IZR j + 1) by apply plus_IZR. assert (I2 : IZR (j + 1 + 1) = IZR j + 1 + 1) by now rewrite plus_IZR, I1.
  assert (E1 : phi0 + Z1 = p + IZR (j + 1) * PI) by (rewrite I1, Ij; unfold Z1, u; lra). assert (E2 : phi0 + Z2 = p + IZR (j + 1 + 1) * PI) by (rewrite I2, Ij; unfold Z2, u; lra).
  assert (g1 : sg (j + 1) = - sg j) by apply sg_succ. assert (g2 : sg (j + 1 + 1) = sg j) by (rewrite !sg_succ; ring).
  assert (off : forall y, phi0 + y - p - IZR j * PI = u + (y - s)) by (intros y; rewrite Ij; unfold u; lra).
  assert (A : forall y, s <= y <= Z1 - d -> 0 < sg j * w y) by (intros y Hy; apply Rlt_le_trans with (1 := m0); apply S; rewrite ?off; unfold Z1 in *; lra).
  assert (B : forall y, Z1 + d <= y <= Z2 - d -> sg j * w y < 0).
  { intros y Hy. enough (m <= sg (j + 1) * w y) by (rewrite g1 in *; lra). apply S; [ unfold Z1 in *; lra | ]. rewrite I1. pose proof (off y). unfold Z1, Z2 in *. lra. }
  assert (C : forall y, Z2 + d <= y <= s + 2 * PI -> 0 < sg j * w y).
  { intros y Hy. enough (m <= sg (j + 1 + 1) * w y) by (rewrite g2 in *; lra). apply S; [ unfold Z2 in *; lra | ]. rewrite I2. pose proof (off y). unfold Z2 in *. lra. }
  destruct (crossing d Z1 (j + 1) ltac:(lra) E1) as (z1 & h1 & w1 & u1); [ unfold Z1; lra | | | ].
  { rewrite g1. specialize (A (Z1 - d)). unfold Z1 in *. lra. } { rewrite g1. specialize (B (Z1 + d)). unfold Z1, Z2 in *. lra. }
  destruct (crossing d Z2 (j + 1 + 1) ltac:(lra) E2) as (z2 & h2 & w2 & u2); [ unfold Z2; lra | | | ].
  { rewrite g2. apply B. unfold Z1, Z2. lra. } { rewrite g2. apply C. unfold Z2. lra. }
  exists z1, z2. unfold Z1, Z2 in h1, h2. split; [ lra | split; [ lra | ] ]. intros z hz. split; [ | intros [-> | ->]; trivial ]. intros wz.
  destruct (Rle_lt_dec z (Z1 - d)) as [k1 | k1]; [ specialize (A z ltac:(lra)); rewrite wz in A; lra | ].
  destruct (Rle_lt_dec z (Z1 + d)) as [k2 | k2]; [ left; apply u1; trivial; lra | ].
  destruct (Rle_lt_dec z (Z2 - d)) as [k3 | k3]; [ specialize (B z ltac:(lra)); rewrite wz in B; lra | ].
  destruct (Rle_lt_dec z (Z2 + d)) as [k4 | k4]; [ right; apply u2; trivial; lra | ]. specialize (C z ltac:(lra)). rewrite wz in C. lra.
Qed.
End Zeros.
