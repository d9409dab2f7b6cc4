(* Below lambda_c the velocity of every motion, not of (38) only, has late two zeros in each period: beside a zero of (38) the drive beats friction,
   so that w is strictly monotone there, and elsewhere w is as close to (38) as one likes. *)
Require Import Reals Lra Psatz ZArith Ranalysis5.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas HalfPeriod Drawn Analysis Steady Shaken LargeTime.
Open Scope R_scope.

Lemma sg_sg n : sg n * sg n = 1. Proof. destruct (sg_cases n) as [-> | ->]; ring. Qed.
Lemma drive_at n x y : x = y + IZR n * PI -> sg n * sin x = sin y.
Proof. intros ->. rewrite (a_shift PI sin neg_sin _ n), <- Rmult_assoc, sg_sg, Rmult_1_l. f_equal. ring. Qed.
Section Zeros.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 < l < eq37_lambda_c.
Hypothesis M : shaken l phi0 w wy.
Notation p := (eq39_phi_t1 l).
Lemma z_1 : 0 < l < 1 /\ 0 < l <= eq37_lambda_c. Proof. pose proof lambda_c_between. lra. Qed.
Lemma room : 0 < asin l < p /\ p < PI / 2.
Proof. destruct (p_facts l (proj1 z_1) ltac:(lra)) as [a [_ c]]. destruct (asin_range l (proj1 z_1)) as [b _]. specialize (c (proj2 hl)). lra. Qed.
(* with the sign of the drive, the velocity grows beside a zero of (38) *)
Lemma grows d Z j y1 y2 : 0 < d <= (p - asin l) / 2 -> phi0 + Z = p + IZR j * PI -> 0 <= Z - d -> Z - d <= y1 < y2 -> y2 <= Z + d ->
  sg j * w y1 < sg j * w y2.
Proof.
  intros hd hZ h0 hy hy2. destruct room as (a & b). pose proof (gain l phi0 w wy ltac:(lra) M y1 y2 ltac:(lra)) as G.
  assert (C : forall y, cos (phi0 + y) = sg j * cos (p + (y - Z))) by (intros y; rewrite (a_shift PI cos neg_cos (phi0 + y) j); do 2 f_equal; lra).
  rewrite !C in G. pose proof (slip_up l (proj1 z_1) (g38 l p) p (y1 - Z) (y2 - Z) (g_der l p) ltac:(lra) ltac:(lra) ltac:(lra)) as U.
  unfold g38 in U. destruct (sg_cases j) as [e | e]; rewrite e in *; lra.
Qed.
(* away from the zeros of (38) the velocity has late the sign of (38), and a size *)
Lemma late_sign d : 0 < d < PI / 2 -> exists m s1, 0 < m /\ 0 <= s1 /\ forall s j, s1 <= s -> d <= phi0 + s - p - IZR j * PI <= PI - d ->
  m <= sg j * w s.
Proof.
  intros hd. destruct (continuity_ab_min (g38 l p) d (PI - d) ltac:(lra)) as (x & X1 & X2). { intros c _. exact (cont_of _ _ _ (g_der l p c)). }
  destruct z_1 as [z1 z2]. pose proof (g_pos l z1 (proj2 z2) x ltac:(lra)) as m0. set (m := g38 l p x) in *.
  destruct (near_38 l z2 phi0 w wy (m / 2) M ltac:(lra)) as (s1 & s0 & H). exists (m / 2), s1. split; [ lra | split; trivial ]. intros s j hs K.
  destruct (H s hs) as [D _]. apply Rabs_def2 in D. specialize (X1 _ K). rewrite (w38_on l j) in D by lra.
  destruct (sg_cases j) as [e | e]; rewrite e in *; lra.
Qed.
Lemma one_zero d : 0 < d <= (p - asin l) / 2 -> exists s1, forall Z j, phi0 + Z = p + IZR j * PI -> s1 <= Z - PI ->
  exists z, Z - d < z < Z + d /\ forall y, Z - PI + d <= y <= Z + PI - d -> (w y = 0 <-> y = z).
Proof.
  intros hd. destruct room as (a & b). destruct (late_sign d ltac:(lra)) as (m & s1 & m0 & s0 & S). exists s1. intros Z j hZ hs.
  assert (A : forall y, Z - PI + d <= y <= Z - d -> sg j * w y < 0).
  { intros y Hy. pose proof (S y (j - 1)%Z ltac:(lra) ltac:(rewrite minus_IZR; lra)) as Q. pose proof (sg_succ (j - 1)) as g.
    replace (j - 1 + 1)%Z with j in g by ring. rewrite g. lra. }
  assert (B : forall y, Z + d <= y <= Z + PI - d -> 0 < sg j * w y) by (intros y Hy; pose proof (S y j ltac:(lra) ltac:(lra)); lra).
  destruct (IVT_interv (fun y => sg j * w y) (Z - d) (Z + d)) as [z [z1 z2]]; [ | lra | apply A; lra | apply B; lra | ].
  { intros y Hy. conts M. }
  pose proof (A (Z - d) ltac:(lra)). pose proof (B (Z + d) ltac:(lra)). assert (z <> Z - d) by (intros ->; lra).
  assert (z <> Z + d) by (intros ->; lra).
  exists z. split; [ lra | ]. assert (O : forall y, w y = 0 <-> sg j * w y = 0) by (intros y; destruct (sg_cases j) as [-> | ->]; lra).
  intros y Hy. rewrite O. split; [ intros y0 | intros ->; trivial ]. destruct (Rle_lt_dec y (Z - d)) as [k | k]; [ specialize (A y); lra | ].
  destruct (Rle_lt_dec (Z + d) y) as [k1 | k1]; [ specialize (B y); lra | ].
  destruct (Rtotal_order y z) as [q | [q | q]]; trivial; exfalso; [ pose proof (grows d Z j y z hd hZ) | pose proof (grows d Z j z y hd hZ) ]; lra.
Qed.
Lemma two_zeros psi : (forall n, psi <> p + IZR n * PI) -> exists s1, forall s, s1 <= s -> at_phase phi0 s psi ->
  exists z1 z2, s < z1 < z2 /\ z2 < s + 2 * PI /\ forall z, s <= z <= s + 2 * PI -> (w z = 0 <-> z = z1 \/ z = z2).
Proof.
  intros ne. pose proof PI_RGT_0. destruct room as (ra & rb). destruct (per_spec p PI ltac:(lra) psi) as [n Hn]. set (u := psi - p - IZR n * PI).
  assert (hu : 0 < u < PI) by (destruct (Rdichotomy _ _ (ne n)); unfold u; lra). set (d := Rmin ((p - asin l) / 2) (Rmin u (PI - u) / 2)).
  assert (hd : 0 < d /\ d <= (p - asin l) / 2 /\ d < u /\ d < PI - u) by (unfold d; minmax). clearbody d.
  destruct (one_zero d ltac:(lra)) as (s1 & S). exists (s1 + PI). intros s hs [k Hk]. unfold u in *. set (j := (n + 1 + 2 * k)%Z).
  assert (Ij : IZR j = IZR n + 1 + 2 * IZR k) by (unfold j; rewrite !plus_IZR, mult_IZR; trivial).
  destruct (S (s + (PI - u)) j) as (z1 & h1 & O1); [ rewrite Ij; unfold u; lra | unfold u; lra | ].
  destruct (S (s + (2 * PI - u)) (j + 1)%Z) as (z2 & h2 & O2); [ rewrite plus_IZR, Ij; unfold u; lra | unfold u; lra | ]. fold u in hu.
  exists z1, z2. split; [ unfold u in *; lra | split; [ unfold u in *; lra | ] ]. intros z hz.
  assert (w z1 = 0 /\ w z2 = 0) as [e1 e2] by (split; [ apply O1 | apply O2 ]; unfold u in *; lra).
  split; [ intros w0 | intros [-> | ->]; trivial ].
  destruct (Rle_lt_dec z (s + (PI - u) + PI - d)); [ left; apply O1 | right; apply O2 ]; trivial; unfold u in *; lra.
Qed.
End Zeros.
