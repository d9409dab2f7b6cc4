(* The velocity across the drive: linear while it is large; faster than every exponential in the end; and, below lambda_c, by how much a passage of
   w through zero multiplies its logarithm in the limit. The last by the logarithm of T = wy/(v + w), whose rate is -sin/v, that of wy being -l/v. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Rates Formulas Pieces Periodic Aniso Steady AttractPlane Shaken LargeTime Zeros.
Open Scope R_scope.

(* friction near one axis: n is the speed, x the fast component, y the slow one *)
Lemma nearly x y : 0 < x -> let q := (y / x) ^ 2 in x <= nrm x y /\ (1 - q / 2) * nrm x y <= x.
Proof.
  intros hx q. pose proof (nrm_sq x y) as N. pose proof (nrm_pos x y). assert (Q : q * x ^ 2 = y ^ 2) by (unfold q; field; lra).
  assert (q0 : 0 <= q) by apply pow2_ge_0. set (n := nrm x y) in *. assert (a : x <= n) by nra. split; trivial.
  assert (b : n <= x * (1 + q / 2)). { apply Rsqr_incr_0_var; [ rewrite !Rsqr_pow2; nra | nra ]. }
  destruct (Rle_lt_dec (1 - q / 2) 0). nra. apply Rle_trans with ((1 - q / 2) * (x * (1 + q / 2))); [ apply Rmult_le_compat_l; lra | ].
  assert (0 <= q ^ 2 * x) by (apply Rmult_le_pos; [ apply pow2_ge_0 | lra ]). nra.
Qed.

Section Across.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 < l.
Hypothesis M : shaken l phi0 w wy.
Lemma l0 : 0 <= l. Proof. lra. Qed.
Lemma wy_falls s t : 0 <= s <= t -> wy t ^ 2 <= wy s ^ 2.
Proof. pose proof M as H. rewrite shaken_sin in H. apply (across_falls _ _ _ _ l0 H). Qed.

(* from s on, for a unit of phase, the speed is 2 (phase since s + e) at most: then wy^2 is multiplied by e^l at most *)
Lemma shrinks s e : 0 <= s -> 0 < e -> (forall t, s <= t <= s + 1 -> nrm (w t) (wy t) <= 2 * (t - s + e)) -> wy (s + 1) ^ 2 <= wy s ^ 2 * exp (l * ln e).
Proof.
  intros hs he H. assert (F : wy (s + 1) ^ 2 * exp (l * ln (s + 1 - s + e)) <= wy s ^ 2 * exp (l * ln (s - s + e))).
  { apply (rder_decr (fun t => wy t ^ 2 * exp (l * ln (t - s + e)))); [ lra | | ]; intros t Ht.
    - cont; [ apply (cont_wy l phi0 w wy M) | ]; lra.
    - destruct (law l phi0 w wy l0 M t) as (fx & fy & C & _ & _ & X & Y); [ lra | ]. specialize (H t ltac:(lra)).
      eexists. split. rd. lra. cbv beta. set (E := exp _). assert (0 < E) by apply exp_pos. set (x := t - s + e) in *. assert (0 < x) by (unfold x; lra).
      destruct (coulomb_slip _ _ _ _ _ l0 C) as [_ F]. pose proof (nrm_ge (w t) (wy t)) as [_ N]. set (n := nrm (w t) (wy t)) in *.
      assert (K : 2 * (wy t * fy) + l * wy t ^ 2 / x <= 0).
      { destruct (Req_dec (wy t) 0) as [-> | z]; [ unfold Rdiv; lra | ]. assert (0 < n) by (pose proof (Rabs_pos_lt _ z); lra). assert (0 < wy t ^ 2) by nra.
        replace fy with (- l * wy t / n) by (rewrite <- F; field; lra). replace (2 * (wy t * (- l * wy t / n)) + l * wy t ^ 2 / x) with (l * wy t ^ 2 * (n - 2 * x) / (n * x)) by (field; lra).
        assert (0 < n * x) by nra. apply Rle_div_l; trivial. assert (0 <= l * wy t ^ 2) by nra. nra. }
      match goal with |- ?g <= 0 => replace g with (E * (2 * (wy t * fy) + l * wy t ^ 2 / x)) by (simpl; field; lra) end. nra. }
  replace (s - s + e) with e in F by ring. replace (s + 1 - s + e) with (1 + e) in F by ring.
  assert (1 <= exp (l * ln (1 + e))). { rewrite <- exp_0 at 1. left. apply exp_increasing. apply Rmult_lt_0_compat; trivial. rewrite <- ln_1. apply ln_increasing; lra. }
  pose proof (pow2_ge_0 (wy (s + 1))). nra.
Qed.

(* faster than every exponential *)
Hypothesis hc : l <= eq37_lambda_c.
Notation p := (eq39_phi_t1 l).
Lemma late_shrinks k : 0 <= k -> exists s0, 0 <= s0 /\ forall s, s0 <= s -> wy (s + 4 * PI) ^ 2 <= wy s ^ 2 * exp (- k).
Proof.
  intros hk. set (e := exp (- k / l)). assert (he : 0 < e) by apply exp_pos. assert (le : l * ln e = - k) by (unfold e; rewrite ln_exp; field; lra).
  destruct (w38_attracts l (conj hl hc) phi0 w wy M) as [X Y]. apply is_lim_spec in X. apply is_lim_spec in Y.
  destruct (X (mkposreal e he)) as [T HT]. destruct (Y (mkposreal e he)) as [U HU]. simpl in HT, HU. pose proof PI2_3_2. pose proof lambda_c_between.
  pose proof (Rmax_l (Rmax (T + 1) (U + 1)) 0) as m1. pose proof (Rmax_r (Rmax (T + 1) (U + 1)) 0) as m2. pose proof (Rmax_l (T + 1) (U + 1)). pose proof (Rmax_r (T + 1) (U + 1)).
  exists (Rmax (Rmax (T + 1) (U + 1)) 0). split; trivial. intros s hs. destruct (phase_after phi0 p s) as (z & hz & ph).
  apply Rle_trans with (wy (z + 1) ^ 2); [ apply wy_falls; lra | ]. rewrite <- le. apply Rle_trans with (wy z ^ 2 * exp (l * ln e)).
  2: { apply Rmult_le_compat_r; [ left; apply exp_pos | apply wy_falls; lra ]. }
  apply shrinks; [ lra | trivial | ]. intros t Ht. specialize (HT t ltac:(lra)). specialize (HU t ltac:(lra)). rewrite Rminus_0_r in HT, HU.
  assert (W0 : w38 l (phi0 + z) = 0). { destruct ph as [n ->]. rewrite (whole_periods (w38 l)) by (intros; now apply w38_period). apply w38_turn. }
  pose proof (gain l phi0 _ _ l0 (w38_motion l (conj hl hc) phi0) z t ltac:(lra)) as G. cbv beta in G. rewrite W0 in G.
  assert (C : Rabs (cos (phi0 + z) - cos (phi0 + t)) <= t - z).
  { rewrite Rabs_minus_sym. destruct (MVT_abs cos (fun x => - sin x) (phi0 + z) (phi0 + t)) as (c & -> & _). intros; apply derivable_pt_lim_cos. pose proof (SIN_bound c).
    rewrite Rabs_Ropp. replace (phi0 + t - (phi0 + z)) with (t - z) by ring. rewrite (Rabs_pos_eq (t - z)) by lra. rewrite <- (Rmult_1_l (t - z)) at 2. apply Rmult_le_compat_r; [ lra | apply Rabs_le; lra ]. }
  apply Rabs_le_between in C. apply Rabs_def2 in HT. apply Rabs_def2 in HU.
  assert (A : Rabs (w t) <= 2 * (t - z) + e). { assert (l * (t - z) <= 1 * (t - z)) by (apply Rmult_le_compat_r; lra). apply Rabs_le; lra. }
  apply Rle_trans with (Rabs (w t) + Rabs (wy t)). 2: { assert (Rabs (wy t) <= e) by (apply Rabs_le; lra). lra. }
  unfold nrm. rewrite <- (sqrt_pow2 (Rabs (w t) + Rabs (wy t))) by (pose proof (Rabs_pos (w t)); pose proof (Rabs_pos (wy t)); lra). apply sqrt_le_1_alt.
  rewrite <- (pow2_abs (w t)), <- (pow2_abs (wy t)). pose proof (Rabs_pos (w t)). pose proof (Rabs_pos (wy t)). nra.
Qed.
Lemma superexponential k : is_lim (fun s => wy s * exp (k * s)) p_infty 0.
Proof.
  set (K := Rabs k + 1). assert (hK : 0 < K /\ k + 1 <= K) by (unfold K; pose proof (Rabs_pos k); pose proof (Rle_abs k); lra). pose proof PI_RGT_0.
  set (T := 4 * PI). destruct (late_shrinks (2 * K * T) ltac:(unfold T; nra)) as (s0 & h0 & S). fold T in S. set (G s := wy s ^ 2 * exp (2 * K * s)).
  assert (G0 : forall s, 0 <= G s) by (intros s; apply Rmult_le_pos; [ apply pow2_ge_0 | left; apply exp_pos ]). set (C := wy 0 ^ 2 * exp (2 * K * (s0 + T))).
  assert (up1 : forall s, 0 <= s <= s0 + T -> G s <= C).
  { intros s hs. unfold G, C. apply Rmult_le_compat; [ apply pow2_ge_0 | left; apply exp_pos | apply wy_falls; lra | ]. destruct (Req_dec s (s0 + T)) as [-> | ]; [ lra | left; apply exp_increasing; nra ]. }
  assert (upn : forall n s, 0 <= s <= s0 + T + INR n * T -> G s <= C).
  { induction n as [ | n IH ]; intros s hs. apply up1. simpl in hs. lra. rewrite S_INR in hs. destruct (Rle_lt_dec s (s0 + T)) as [a | a]; [ apply up1; lra | ].
    apply Rle_trans with (G (s - T)). 2: { apply IH. unfold T in *. lra. } specialize (S (s - T) ltac:(lra)). replace (s - T + T) with s in S by ring. unfold G.
    replace (2 * K * (s - T)) with (2 * K * s + - (2 * K * T)) by ring. rewrite exp_plus. pose proof (exp_pos (2 * K * s)). nra. }
  apply (lim_of_bound _ C (fun s => exp (2 * s))).
  - unfold C. apply Rmult_le_pos; [ apply pow2_ge_0 | left; apply exp_pos ].
  - intros s hs. destruct (nat_above (s / T)) as [n Hn]. apply Rlt_div_l in Hn; [ | unfold T; lra ]. apply Rle_trans with (G s); [ | apply (upn n); unfold T in *; lra ].
    unfold G. rewrite Rpow_mult_distr, Rmult_assoc. apply Rmult_le_compat_l; [ apply pow2_ge_0 | ]. replace (exp (k * s) ^ 2) with (exp (k * s) * exp (k * s)) by ring. rewrite <- !exp_plus.
    destruct (Req_dec (k * s + k * s + 2 * s) (2 * K * s)) as [-> | ]; [ lra | left; apply exp_increasing ]. assert (k * s + s <= K * s) by nra. lra.
  - intros B. exists (Rabs B). split. apply Rabs_pos. intros s hs. pose proof (exp_ineq1_le (2 * s)). pose proof (Rle_abs B). pose proof (Rabs_pos B). lra.
Qed.
End Across.

(* ---- passages through zero ---- *)
Section Passages.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 < l < eq37_lambda_c.
Hypothesis M : shaken l phi0 w wy.
Hypothesis N : forall s, 0 <= s -> wy s <> 0.
Notation p := (eq39_phi_t1 l).
Notation d := (sin (eq39_phi_t1 l)).
Notation v t := (nrm (w t) (wy t)).
Notation Q t := (ln (wy t ^ 2)).
Lemma moving t : 0 <= t -> 0 < wy t ^ 2 /\ Rabs (w t) < v t /\ exists fx fy, rder w t (sin (phi0 + t) + fx) /\ rder wy t fy /\ fx = - l * w t / v t /\ fy = - l * wy t / v t.
Proof.
  intros ht. specialize (N t ht). assert (y2 : 0 < wy t ^ 2) by (pose proof (pow2_ge_0 (wy t)); nra). pose proof (nrm_sq (w t) (wy t)) as n2. pose proof (nrm_pos (w t) (wy t)) as n0.
  assert (n1 : Rabs (w t) < v t). { rewrite <- (pow2_abs (w t)) in n2. pose proof (Rabs_pos (w t)). nra. }
  pose proof (Rabs_pos (w t)). destruct (law l phi0 w wy (Rlt_le _ _ (proj1 hl)) M t ht) as (fx & fy & C & _ & _ & X & Y).
  destruct (coulomb_slip _ _ _ _ _ (Rlt_le _ _ (proj1 hl)) C) as [E F]. split; [ trivial | split; [ trivial | ] ]. exists fx, fy. repeat split; trivial; [ rewrite <- E | rewrite <- F ]; field; lra.
Qed.
(* while |w| is not small, ln wy^2 changes little *)
Lemma slow m a b : 0 < m -> 0 <= a <= b -> (forall t, a <= t <= b -> m <= Rabs (w t)) -> Q a - 2 * l / m * (b - a) <= Q b <= Q a.
Proof.
  intros hm H S. split.
  - enough (- Q b - 2 * l / m * b <= - Q a - 2 * l / m * a) by lra. apply (rder_decr (fun t => - Q t - 2 * l / m * t)); [ lra | | ]; intros t Ht; destruct (moving t ltac:(lra)) as (y2 & n1 & fx & fy & X & Y & Ex & Ey).
    + cont. apply (cont_wy l phi0 w wy M). lra. lra.
    + eexists. split. rd. lra. specialize (S t ltac:(lra)). assert (n0 : 0 < v t) by (pose proof (Rabs_pos (w t)); lra). assert (y0 : wy t <> 0) by (apply N; lra). rewrite Ey. set (n := nrm (w t) (wy t)) in *.
      match goal with |- ?g <= 0 => replace g with (2 * l * (m - n) / (n * m)) by (simpl; field; lra) end. assert (0 < n * m) by nra. apply Rle_div_l; trivial. nra.
  - destruct (moving b ltac:(lra)) as (y2 & _). apply Rcomplements.ln_le; [ trivial | apply (wy_falls l phi0 w wy (proj1 hl) M); lra ].
Qed.
(* R + k ln wy^2, R = ln (v + e w), moves in the direction s as long as e sin - l is beyond 2 l k *)
Lemma tilt e s k a b : e = 1 \/ e = -1 -> s = 1 \/ s = -1 -> 0 <= a <= b -> (forall t, a <= t < b -> s * (2 * l * k) <= s * (e * sin (phi0 + t) - l)) ->
  s * (ln (v a + e * w a) + k * Q a) <= s * (ln (v b + e * w b) + k * Q b).
Proof.
  intros he hs H S. apply Ropp_le_cancel. rewrite <- !Ropp_mult_distr_l_reverse.
  assert (P : forall t, 0 <= t -> 0 < v t + e * w t). { intros t ht. destruct (moving t ht) as (_ & n1 & _). apply Rabs_def2 in n1. destruct he as [-> | ->]; lra. }
  apply (rder_decr (fun t => - s * (ln (v t + e * w t) + k * Q t))); [ lra | | ]; intros t Ht; destruct (moving t ltac:(lra)) as (y2 & n1 & fx & fy & X & Y & Ex & Ey).
  - cont; try (apply (cont_wy l phi0 w wy M) || apply (cont_w l phi0 w wy M)); try lra. apply P. lra.
  - assert (n0 : 0 < v t) by (pose proof (Rabs_pos (w t)); lra). pose proof (P t ltac:(lra)) as Pt. assert (y0 : wy t <> 0) by (apply N; lra). pose proof (nrm_sq (w t) (wy t)) as n2.
    eexists. split. rd; [ lra | exact Pt | lra ]. specialize (S t ltac:(lra)). cbv beta. set (n := nrm (w t) (wy t)) in *.
    match goal with |- ?g <= 0 => replace g with (- (s * (e * sin (phi0 + t) - l) - s * (2 * l * k)) / n) end.
    + apply Rle_div_l; lra.
    + rewrite Ex, Ey. replace ((w t * (sin (phi0 + t) + - l * w t / n) + wy t * (- l * wy t / n)) / n) with ((w t * sin (phi0 + t) - l * n) / n).
      * destruct he as [-> | ->]; simpl; field; lra.
      * replace (w t * (sin (phi0 + t) + - l * w t / n) + wy t * (- l * wy t / n)) with (w t * sin (phi0 + t) - l * (w t ^ 2 + wy t ^ 2) / n) by (field; lra). rewrite <- n2. field. lra.
Qed.
Lemma late_speed : exists s1, 0 <= s1 /\ forall s, s1 <= s -> v s <= 8.
Proof.
  pose proof lambda_c_between. assert (hp : 0 < l <= eq37_lambda_c) by lra. destruct (w38_attracts l hp phi0 w wy M) as [X Y]. apply is_lim_spec in X. apply is_lim_spec in Y.
  destruct (X (mkposreal 1 Rlt_0_1)) as [T HT]. destruct (Y (mkposreal 1 Rlt_0_1)) as [U HU]. simpl in HT, HU. pose proof PI_RGT_0. pose proof PI_4.
  pose proof (Rmax_l (Rmax (T + 1) (U + 1)) 0). pose proof (Rmax_r (Rmax (T + 1) (U + 1)) 0). pose proof (Rmax_l (T + 1) (U + 1)). pose proof (Rmax_r (T + 1) (U + 1)).
  exists (Rmax (Rmax (T + 1) (U + 1)) 0). split; trivial. intros s hs. specialize (HT s ltac:(lra)). specialize (HU s ltac:(lra)). rewrite Rminus_0_r in HT, HU.
  assert (B : Rabs (w38 l (phi0 + s)) <= 6).
  { destruct (per_spec p PI ltac:(lra) (phi0 + s)) as [n Hn]. rewrite w38_ext, (ext_on PI _ PI_RGT_0 n) by lra. unfold g38. set (x := phi0 + s - p - IZR n * PI) in *.
    pose proof (COS_bound p). pose proof (COS_bound (p + x)). assert (0 <= l * x <= 4) by (unfold x; split; nra). apply Rabs_le. destruct (sg_cases n) as [-> | ->]; lra. }
  apply Rabs_le_between in B. apply Rabs_def2 in HT. assert (A : Rabs (w s) <= 7) by (apply Rabs_le; lra). pose proof (Rabs_pos (w s)). pose proof (Rabs_pos (wy s)).
  unfold nrm. rewrite <- (sqrt_pow2 8) by lra. apply sqrt_le_1_alt. rewrite <- (pow2_abs (w s)), <- (pow2_abs (wy s)). nra.
Qed.
(* from u before the passage to u after it, up to C *)
Lemma passage_bounds u del : 0 < del -> del <= (d - l) / 2 -> del < u < PI - del -> let k1 := (d - del - l) / (2 * l) in let k2 := (d + del - l) / (2 * l) in
  exists C s1, 0 <= C /\ forall s n, s1 <= s -> phi0 + s = p + IZR n * PI + u -> (1 + k1) * Q s - C <= k1 * Q (s + PI) /\ k2 * Q (s + PI) <= (1 + k2) * Q s + C.
Proof.
  intros h0 h1 hu k1 k2. destruct (late_sign l phi0 w wy hl M del) as (m & s1 & m0 & s10 & S). lra. destruct late_speed as (s2 & s20 & V). pose proof PI_RGT_0.
  assert (hk : 0 <= k1 /\ 0 <= k2) by (unfold k1, k2; split; apply Rmult_le_pos; try lra; left; apply Rinv_0_lt_compat; lra).
  set (A := 2 * l / m * PI). assert (A0 : 0 <= A) by (unfold A; apply Rmult_le_pos; [ apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ] | lra ]).
  assert (l16 : 0 < ln 16) by (rewrite <- ln_1; apply ln_increasing; lra). set (C := (1 + k1) * A + k1 * A + 2 * ln 16 + 2 * Rabs (ln m)).
  assert (C0 : 0 <= C). { pose proof (Rabs_pos (ln m)). assert (0 <= (1 + k1) * A) by nra. assert (0 <= k1 * A) by nra. unfold C. lra. }
  exists C, (Rmax s1 s2). split; trivial. intros s n hs ph. pose proof (Rmax_l s1 s2). pose proof (Rmax_r s1 s2). set (Z := s + (PI - u)). set (e := sg (n + 1)).
  assert (I1 : IZR (n + 1) = IZR n + 1) by apply plus_IZR. assert (ee : e = 1 \/ e = -1) by apply sg_cases. assert (es : sg n = - e) by (unfold e; rewrite sg_succ; ring).
  assert (B : forall t, s <= t <= Z - del -> m <= - e * w t) by (intros t Ht; rewrite <- es; apply S; unfold Z in *; lra).
  assert (D : forall t, Z + del <= t <= s + PI -> m <= e * w t) by (intros t Ht; apply S; rewrite ?I1; unfold Z in *; lra).
  assert (big : forall t, m <= - e * w t \/ m <= e * w t -> m <= Rabs (w t)) by (intros t [K | K]; destruct ee as [E | E]; rewrite E in K; unfold Rabs; destruct (Rcase_abs (w t)); lra).
  assert (q1 : Q s - A <= Q (Z - del) <= Q s).
  { destruct (slow m s (Z - del) m0) as [x1 x2]; [ unfold Z; lra | auto | ]. split; trivial. apply Rle_trans with (2 := x1). unfold A. assert (2 * l / m * (Z - del - s) <= 2 * l / m * PI); [ | lra ].
    apply Rmult_le_compat_l; [ | unfold Z; lra ]. apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]. }
  assert (q2 : Q (Z + del) - A <= Q (s + PI) <= Q (Z + del)).
  { destruct (slow m (Z + del) (s + PI) m0) as [x1 x2]; [ unfold Z; lra | auto | ]. split; trivial. apply Rle_trans with (2 := x1). unfold A. assert (2 * l / m * (s + PI - (Z + del)) <= 2 * l / m * PI); [ | lra ].
    apply Rmult_le_compat_l; [ | unfold Z; lra ]. apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]. }
  assert (sn : forall t, Z - del <= t <= Z + del -> d - del <= e * sin (phi0 + t) <= d + del).
  { intros t Ht. rewrite (a_shift PI sin neg_sin (phi0 + t) (n + 1)). fold e. rewrite I1. replace (phi0 + t - (IZR n + 1) * PI) with (p + (t - Z)) by (unfold Z; lra).
    rewrite <- Rmult_assoc. replace (e * e) with 1 by (destruct ee as [-> | ->]; ring). rewrite Rmult_1_l. destruct (MVT_abs sin cos p (p + (t - Z))) as (c & E & _). intros; apply derivable_pt_lim_sin.
    pose proof (COS_bound c). assert (Rabs (cos c) <= 1) by (apply Rabs_le; lra). replace (p + (t - Z) - p) with (t - Z) in E by ring. assert (Rabs (t - Z) <= del) by (apply Rabs_le; lra).
    assert (K : Rabs (sin (p + (t - Z)) - sin p) <= del) by (rewrite E; pose proof (Rabs_pos (t - Z)); pose proof (Rabs_pos (cos c)); nra). apply Rabs_le_between in K. lra. }
  assert (k1e : 2 * l * k1 = d - del - l) by (unfold k1; field; lra). assert (k2e : 2 * l * k2 = d + del - l) by (unfold k2; field; lra).
  pose proof (tilt e 1 k1 (Z - del) (Z + del) ee ltac:(auto) ltac:(unfold Z; lra)) as T1. pose proof (tilt e (-1) k2 (Z - del) (Z + del) ee ltac:(auto) ltac:(unfold Z; lra)) as T2.
  specialize (T1 ltac:(intros t Ht; rewrite k1e; specialize (sn t ltac:(lra)); lra)). specialize (T2 ltac:(intros t Ht; rewrite k2e; specialize (sn t ltac:(lra)); lra)).
  (* the ends: v + |w| lies between m and 16 *)
  assert (size : forall t g, s <= t -> g = 1 \/ g = -1 -> m <= g * w t -> - Rabs (ln m) <= ln (v t + g * w t) <= ln 16).
  { intros t g ht hg K. specialize (V t ltac:(lra)). destruct (moving t ltac:(lra)) as (_ & n1 & _). apply Rabs_def2 in n1. assert (m <= v t + g * w t <= 16) by (destruct hg as [-> | ->]; lra). split.
    - apply Rle_trans with (ln m). pose proof (Rle_abs (- ln m)) as G. rewrite Rabs_Ropp in G. lra. apply Rcomplements.ln_le; lra.
    - apply Rcomplements.ln_le; lra. }
  pose proof (size (Z + del) e ltac:(unfold Z; lra) ee (D (Z + del) ltac:(unfold Z; lra))) as rb.
  pose proof (size (Z - del) (- e) ltac:(unfold Z; lra) ltac:(destruct ee as [-> | ->]; [ right | left ]; ring) (B (Z - del) ltac:(unfold Z; lra))) as ra.
  assert (ra2 : ln (v (Z - del) + e * w (Z - del)) = Q (Z - del) - ln (v (Z - del) + - e * w (Z - del))).
  { destruct (moving (Z - del) ltac:(unfold Z; lra)) as (_ & n1 & _). apply Rabs_def2 in n1. pose proof (nrm_sq (w (Z - del)) (wy (Z - del))) as n2.
    assert (0 < v (Z - del) + e * w (Z - del) /\ 0 < v (Z - del) + - e * w (Z - del)) as [x1 x2] by (destruct ee as [-> | ->]; lra).
    enough (E : ln (v (Z - del) + e * w (Z - del)) + ln (v (Z - del) + - e * w (Z - del)) = Q (Z - del)) by lra. rewrite <- ln_mult by trivial.
    f_equal. transitivity (v (Z - del) ^ 2 - e ^ 2 * w (Z - del) ^ 2); [ ring | ]. rewrite n2. destruct ee as [-> | ->]; ring. }
  rewrite ra2 in T1, T2. assert ((1 + k1) * (Q s - A) <= (1 + k1) * Q (Z - del)) by (apply Rmult_le_compat_l; lra). assert (k1 * (Q (Z + del) - A) <= k1 * Q (s + PI)) by (apply Rmult_le_compat_l; lra).
  assert (k2 * Q (s + PI) <= k2 * Q (Z + del)) by (apply Rmult_le_compat_l; lra). assert ((1 + k2) * Q (Z - del) <= (1 + k2) * Q s) by (apply Rmult_le_compat_l; lra).
  assert (0 <= (1 + k1) * A) by nra. assert (0 <= k1 * A) by nra. pose proof (Rabs_pos (ln m)). unfold C. split; lra.
Qed.
Notation F := (right_sinusoidal_passage_factor l d).
Lemma passage_factor s0 : 0 <= s0 -> (forall n, phi0 + s0 <> p + IZR n * PI) ->
  is_lim_seq (fun j => ln (Rabs (wy (s0 + INR (S j) * PI))) / ln (Rabs (wy (s0 + INR j * PI)))) F.
Proof.
  intros hs ne. pose proof PI_RGT_0. pose proof lambda_c_between. destruct (turn_sign l ltac:(lra)) as (c & c0 & dl).
  { pose proof (small l ltac:(lra) ltac:(lra)). lra. } assert (dl1 : l < d) by nra. clear c c0 dl.
  apply is_lim_seq_spec. intros eps. destruct (per_spec p PI ltac:(lra) (phi0 + s0)) as [n Hn]. set (u := phi0 + s0 - p - IZR n * PI).
  assert (hu : 0 < u < PI). { specialize (ne n). unfold u. split; [ | lra ]. destruct (Rle_lt_or_eq_dec _ _ (proj1 Hn)); lra. }
  assert (ep := cond_pos eps). set (g := d - l). assert (g0 : 0 < g) by (unfold g; lra).
  set (del := Rmin (Rmin u (PI - u) / 2) (Rmin (g / 2) (eps * g ^ 2 / (16 * l)))).
  assert (x1 : 0 < eps * g ^ 2 / (16 * l)) by (apply Rdiv_lt_0_compat; [ apply Rmult_lt_0_compat; [ trivial | nra ] | lra ]). assert (x2 : 0 < Rmin u (PI - u)) by (apply Rmin_pos; lra).
  assert (hd : 0 < del) by (unfold del; repeat apply Rmin_pos; lra).
  assert (hd1 : del < u < PI - del). { pose proof (Rmin_l (Rmin u (PI - u) / 2) (Rmin (g / 2) (eps * g ^ 2 / (16 * l)))) as a. fold del in a. pose proof (Rmin_l u (PI - u)). pose proof (Rmin_r u (PI - u)). lra. }
  assert (hd2 : del <= g / 2 /\ 16 * l * del <= eps * g ^ 2).
  { pose proof (Rmin_r (Rmin u (PI - u) / 2) (Rmin (g / 2) (eps * g ^ 2 / (16 * l)))) as a. fold del in a. pose proof (Rmin_l (g / 2) (eps * g ^ 2 / (16 * l))). pose proof (Rmin_r (g / 2) (eps * g ^ 2 / (16 * l))) as b.
    split; [ lra | ]. assert (del <= eps * g ^ 2 / (16 * l)) as q by lra. apply Rle_div_r in q; lra. }
  clearbody del. destruct (passage_bounds u del hd ltac:(fold g; lra) hd1) as (C & s1 & C0 & B). set (k1 := (d - del - l) / (2 * l)) in *. set (k2 := (d + del - l) / (2 * l)) in *.
  assert (hk1 : 0 < k1) by (unfold k1, g in *; apply Rdiv_lt_0_compat; lra). assert (hk2 : 0 < k2) by (unfold k2, g in *; apply Rdiv_lt_0_compat; lra).
  (* wy is late so small that C does not matter *)
  set (X := Rmax 1 (4 * C / (eps * k1))). destruct (w38_attracts l ltac:(lra) phi0 w wy M) as [_ Y]. apply is_lim_spec in Y. destruct (Y (mkposreal (exp (- X)) (exp_pos _))) as [U HU]. simpl in HU.
  destruct (nat_above ((Rmax (Rmax s1 (U + 1)) 0) / PI)) as [J HJ]. apply Rlt_div_l in HJ; trivial. exists J. intros j hj. apply le_INR in hj.
  pose proof (Rmax_l (Rmax s1 (U + 1)) 0). pose proof (Rmax_r (Rmax s1 (U + 1)) 0). pose proof (Rmax_l s1 (U + 1)). pose proof (Rmax_r s1 (U + 1)).
  set (s := s0 + INR j * PI). assert (hs1 : s1 <= s /\ U < s /\ 0 <= s) by (unfold s; nra). replace (s0 + INR (S j) * PI) with (s + PI) by (rewrite S_INR; unfold s; ring).
  destruct (B s (n + Z.of_nat j)%Z ltac:(lra)) as [b1 b2]. { rewrite plus_IZR, <- INR_IZR_INZ. unfold s, u. ring. }
  assert (L2 : forall t, 0 <= t -> Q t = 2 * ln (Rabs (wy t))). { intros t ht. rewrite <- (pow2_abs (wy t)). replace (Rabs (wy t) ^ 2) with (Rabs (wy t) * Rabs (wy t)) by ring. rewrite ln_mult by (apply Rabs_pos_lt; now apply N). ring. }
  rewrite !L2 in b1, b2 by lra. set (x := - ln (Rabs (wy s))). set (x' := - ln (Rabs (wy (s + PI)))). assert (Xx : X <= x).
  { unfold x. rewrite <- (Ropp_involutive X). apply Ropp_le_contravar. rewrite <- (ln_exp (- X)). specialize (HU s ltac:(lra)). rewrite Rminus_0_r in HU. apply Rcomplements.ln_le; [ apply Rabs_pos_lt, N; lra | lra ]. }
  pose proof (Rmax_l 1 (4 * C / (eps * k1))) as X1. pose proof (Rmax_r 1 (4 * C / (eps * k1))) as X2. fold X in X1, X2. assert (x0 : 0 < x) by lra.
  assert (CX : 4 * C <= eps * k1 * x). { apply Rle_div_l in X2. apply Rle_trans with (1 := X2). rewrite Rmult_comm. apply Rmult_le_compat_l; nra. nra. }
  replace (ln (Rabs (wy (s + PI))) / ln (Rabs (wy s))) with (x' / x) by (unfold x, x' in *; field; lra).
  assert (u1 : k1 * x' <= (1 + k1) * x + C / 2) by (unfold x, x'; lra). assert (u2 : (1 + k2) * x - C / 2 <= k2 * x') by (unfold x, x'; lra).
  assert (e1 : (1 + k1) / k1 <= F + eps / 2).
  { unfold right_sinusoidal_passage_factor, k1. replace ((1 + (d - del - l) / (2 * l)) / ((d - del - l) / (2 * l))) with ((d + l) / (d - l) + 2 * l * del / ((g - del) * g)) by (unfold g; field; unfold g in *; lra).
    apply Rplus_le_compat_l. assert (0 < (g - del) * g) by nra. apply Rle_div_l; trivial. assert (g / 2 * g <= (g - del) * g) by nra. nra. }
  assert (e2 : F - eps / 2 <= (1 + k2) / k2).
  { unfold right_sinusoidal_passage_factor, k2. replace ((1 + (d + del - l) / (2 * l)) / ((d + del - l) / (2 * l))) with ((d + l) / (d - l) - 2 * l * del / ((g + del) * g)) by (unfold g; field; unfold g in *; lra).
    enough (2 * l * del / ((g + del) * g) <= eps / 2) by lra. assert (0 < (g + del) * g) by nra. apply Rle_div_l; trivial. assert (g * g <= (g + del) * g) by nra. nra. }
  assert (f1 : x' / x <= (1 + k1) / k1 + eps / 8). { apply Rle_div_l; trivial. apply (Rmult_le_reg_l k1); trivial. replace (k1 * (((1 + k1) / k1 + eps / 8) * x)) with ((1 + k1) * x + eps * k1 * x / 8) by (field; lra). lra. }
  assert (k12 : k1 <= k2) by (unfold k1, k2; apply Rmult_le_compat_r; [ left; apply Rinv_0_lt_compat; lra | lra ]).
  assert (f2 : (1 + k2) / k2 - eps / 8 <= x' / x). { apply Rle_div_r; trivial. apply (Rmult_le_reg_l k2); trivial. replace (k2 * (((1 + k2) / k2 - eps / 8) * x)) with ((1 + k2) * x - eps * k2 * x / 8) by (field; lra).
    assert (eps * k1 * x <= eps * k2 * x) by (apply Rmult_le_compat_r; [ lra | apply Rmult_le_compat_l; lra ]). lra. }
  apply Rabs_def1; lra.
Qed.
End Passages.
