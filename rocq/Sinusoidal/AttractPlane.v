(* 2.2: (38) attracts every motion of the plane, (33) is reached by every motion of the plane *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic Steady Steady2 Pulse Aniso Attract.
Open Scope R_scope.

Lemma nrm_ge x y : Rabs x <= nrm x y /\ Rabs y <= nrm x y.
Proof. split; unfold nrm; rewrite <- sqrt_Rsqr_abs; apply sqrt_le_1_alt; unfold Rsqr; nra. Qed.

Lemma abs_of_sq x y e : 0 < e -> x ^ 2 + y ^ 2 <= e ^ 2 -> Rabs x <= e /\ Rabs y <= e.
Proof.
  intros he H. pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 y). rewrite <- (Rabs_pos_eq e) by lra.
  split; apply Rsqr_le_abs_0; rewrite !Rsqr_pow2; lra.
Qed.

Section Two.
Variables (k B : R) (a W vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis hB : forall t, Rabs (a t) <= B.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis HV : motion k a (fun _ => 0) vx vy.
Definition gap t := (vx t - W t) ^ 2 + vy t ^ 2.
Lemma gap_falls s t : 0 <= s <= t -> gap t <= gap s.
Proof.
  intros H. unfold gap. pose proof (contraction k a (fun _ => 0) vx vy W (fun _ => 0) hk HV HW s t H) as K. cbv beta in K. rewrite !Rminus_0_r in K. exact K.
Qed.
Lemma gap_pos t : 0 <= gap t.
Proof. unfold gap. pose proof (pow2_ge_0 (vx t - W t)). pose proof (pow2_ge_0 (vy t)). lra. Qed.

(* while the straight motion goes to the side s and the other does not, the gap falls *)
Lemma gap_loss s n p q : s = 1 \/ s = -1 -> 0 <= p <= q -> (forall y, p <= y <= q -> 0 < s * W y /\ n <= nrm (vx y) (vy y) - s * vx y) ->
  gap q + 2 * k * n * (q - p) <= gap p.
Proof.
  intros hs H S. enough (gap q + 2 * k * n * q <= gap p + 2 * k * n * p) by lra. unfold gap.
  apply (rder_decr (fun t => (vx t - W t) ^ 2 + vy t ^ 2 + 2 * k * n * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply (m_cx _ _ _ _ _ HV) | apply (m_cx _ _ _ _ _ HW) | apply (m_cy _ _ _ _ _ HV) ]; lra.
  - destruct (m_law _ _ _ _ _ HV t) as (fx & fy & [C1 C2] & X & Y); [ lra | ]. destruct (m_law _ _ _ _ _ HW t) as (F & G & C & Z & _); [ lra | ].
    destruct (coulomb_slip _ _ _ _ _ hk C) as [E _]. destruct (S t) as [s1 s2]; [ lra | ]. pose proof (nrm_sq (W t) 0) as N. pose proof (nrm_pos (W t) 0).
    assert (e : nrm (W t) 0 = s * W t) by (destruct hs as [-> | ->]; nra). assert (eF : F = - k * s) by (rewrite e in E; destruct hs as [-> | ->]; nra). subst F.
    assert (hf : - k <= fx <= k) by nra. assert (b : - (fx * W t) <= k * (s * W t)) by (destruct hs as [-> | ->]; nra).
    eexists. split. rd. set (v := nrm (vx t) (vy t)) in *. set (w := s * W t) in *. assert (ss : s * s = 1) by (destruct hs as [-> | ->]; ring).
    assert (k * n <= k * (v - s * vx t)) by (apply Rmult_le_compat_l; trivial).
    match goal with |- ?g <= 0 => replace g with (2 * ((fx * vx t + fy * vy t) - fx * W t + k * s * vx t - k * w + k * n)) by (unfold w; simpl; ring) end.
    rewrite C2. lra.
Qed.
Lemma lipschitz x y : 0 <= x <= y -> Rabs (vx y - vx x) <= (B + k) * (y - x) /\ Rabs (vy y - vy x) <= (B + k) * (y - x).
Proof.
  intros H. assert (B0 : 0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra). assert (A : forall f c, (f = vx /\ c = a) \/ (f = vy /\ c = (fun _ => 0)) -> forall e, e = 1 \/ e = -1 -> e * (f y - f x) <= (B + k) * (y - x)).
  { intros f c hf e he. enough (e * f y - (B + k) * y <= e * f x - (B + k) * x) by lra.
    apply (rder_decr (fun t => e * f t - (B + k) * t)); [ lra | | ]; intros t Ht.
    - destruct hf as [[-> _] | [-> _]]; cont; [ apply (m_cx _ _ _ _ _ HV) | apply (m_cy _ _ _ _ _ HV) ]; lra.
    - destruct (m_law _ _ _ _ _ HV t) as (fx & fy & [C1 C2] & X & Y); [ lra | ]. specialize (hB t). apply Rabs_le_between in hB.
      assert (- k <= fx <= k /\ - k <= fy <= k) by nra.
      destruct hf as [[-> _] | [-> _]]; (eexists; split; [ rd | ]); destruct he as [-> | ->]; lra. }
  split; apply Rabs_le; [ pose proof (A vx a) as Q | pose proof (A vy (fun _ => 0)) as Q ]; pose proof (Q ltac:(auto) 1 ltac:(auto)); pose proof (Q ltac:(auto) (-1) ltac:(auto)); lra.
Qed.
End Two.

Section Plane.
Variables (k B T z d : R) (a W : R -> R).
Hypothesis hk : 0 < k.
Hypothesis hB : forall t, Rabs (a t) <= B.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis hT : 0 < T.
Hypothesis hW : forall t, W (t + T) = W t.
Hypothesis hd : 0 < d.
Hypothesis zero : W z = 0.
Hypothesis before : forall t, z - d < t < z -> W t < 0.
Hypothesis after : forall t, z < t < z + d -> 0 < W t.
Theorem plane_attracts vx vy : motion k a (fun _ => 0) vx vy -> is_lim (fun t => vx t - W t) p_infty 0 /\ is_lim vy p_infty 0.
Proof.
  intros HV. set (D := gap W vx vy). assert (hk' : 0 <= k) by lra.
  enough (S : forall e, 0 < e -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> D t <= e ^ 2).
  { split; apply lim_zero; intros e he; destruct (S e he) as (t1 & _ & h); exists t1; intros t Ht; now destruct (abs_of_sq _ _ e he (h t Ht)). }
  intros e he. set (L := B + k). assert (B0 : 0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra). assert (Lp : 0 < L) by (unfold L; lra).
  set (h := Rmin (d / 2) (Rmin (T / 2) (e / (8 * L)))). assert (hh : 0 < h /\ h <= d / 2 /\ h <= T / 2 /\ L * h <= e / 8).
  { assert (0 < e / (8 * L)) by (apply Rdiv_lt_0_compat; lra). pose proof (Rmin_l (d / 2) (Rmin (T / 2) (e / (8 * L)))). pose proof (Rmin_r (d / 2) (Rmin (T / 2) (e / (8 * L)))).
    pose proof (Rmin_l (T / 2) (e / (8 * L))). pose proof (Rmin_r (T / 2) (e / (8 * L))). fold h in H0, H1. split; [ unfold h; repeat apply Rmin_pos; lra | ]. repeat split; try lra.
    replace (e / 8) with (L * (e / (8 * L))) by (field; lra). apply Rmult_le_compat_l; lra. }
  clearbody h. pose proof (gap_falls k a W vx vy hk' HW HV) as C.
  apply (drain D 0 (2 * T) (2 * k * (e / 4) * (h / 2)) (e ^ 2)); try lra; [ repeat apply Rmult_lt_0_compat; lra | intros; apply gap_pos | exact C | ].
  intros t Ht. destruct (per_spec z T hT (t + T + h)) as [n Hn]. set (x := z + IZR n * T). assert (x1 : t <= x - h /\ x + h <= t + 2 * T) by (unfold x; lra).
  assert (on : forall y, W (y - IZR n * T) = W y) by (intros; apply shift_Z; trivial).
  assert (Wx : W x = 0) by (rewrite <- on; unfold x; replace (z + IZR n * T - IZR n * T) with z by ring; trivial).
  assert (Wb : forall y, x - d < y < x -> W y < 0) by (intros y Hy; rewrite <- on; apply before; unfold x in *; lra).
  assert (Wa : forall y, x < y < x + d -> 0 < W y) by (intros y Hy; rewrite <- on; apply after; unfold x in *; lra). clearbody x.
  destruct (Rle_lt_dec (D (t + 2 * T)) (e ^ 2)) as [K | K]; [ left; trivial | right ].
  assert (big : e ^ 2 < vx x ^ 2 + vy x ^ 2). { pose proof (C x (t + 2 * T) ltac:(lra)) as Q. unfold D, gap in *. rewrite Wx, Rminus_0_r in Q. lra. }
  assert (N : forall s y, s = 1 \/ s = -1 -> x - h <= y <= x + h -> 0 <= y -> 0 <= - s * vx x -> e / 4 <= nrm (vx y) (vy y) - s * vx y).
  { intros s y hs Hy y0 sg. assert (Lip : Rabs (vx y - vx x) <= e / 8 /\ Rabs (vy y - vy x) <= e / 8).
    { destruct (Rle_lt_dec x y).
      - destruct (lipschitz k B a vx vy hk' hB HV x y ltac:(lra)) as [A1 A2]. fold L in A1, A2. assert (L * (y - x) <= L * h) by (apply Rmult_le_compat_l; lra). lra.
      - destruct (lipschitz k B a vx vy hk' hB HV y x ltac:(lra)) as [A1 A2]. fold L in A1, A2. rewrite Rabs_minus_sym in A1, A2. assert (L * (x - y) <= L * h) by (apply Rmult_le_compat_l; lra). lra. }
    destruct Lip as [L1 L2]. apply Rabs_le_between in L1. apply Rabs_le_between in L2. destruct (nrm_ge (vx y) (vy y)) as [n1 n2]. apply Rabs_le_between in n1. apply Rabs_le_between in n2.
    assert (Q : e / 2 <= - s * vx x \/ e / 2 <= vy x \/ vy x <= - (e / 2)).
    { destruct (Rle_lt_dec (e / 2) (- s * vx x)); [ auto | right ]. assert (vx x ^ 2 = (- s * vx x) ^ 2) by (destruct hs as [-> | ->]; ring). 
      destruct (Rle_lt_dec (e / 2) (vy x)); [ auto | right ]. apply Rnot_lt_le. intros q. nra. }
    assert (- s * vx x - e / 8 <= - s * vx y) by (destruct hs as [-> | ->]; lra). lra. }
  destruct (Rle_lt_dec 0 (vx x)) as [s | s].
  - apply Rle_trans with (D (x - h / 2)); [ apply C; lra | ]. pose proof (C t (x - h) ltac:(lra)) as Q. fold D in Q.
    pose proof (gap_loss k a W vx vy hk' HW HV (-1) (e / 4) (x - h) (x - h / 2) ltac:(auto) ltac:(lra)) as P. fold D in P. 
    assert (D (x - h / 2) + 2 * k * (e / 4) * (x - h / 2 - (x - h)) <= D (x - h)); [ apply P | lra ]. intros y Hy. specialize (Wb y ltac:(lra)). split; [ lra | apply N; auto; lra ].
  - apply Rle_trans with (D (x + h)); [ apply C; lra | ]. pose proof (C t (x + h / 2) ltac:(lra)) as Q. fold D in Q.
    pose proof (gap_loss k a W vx vy hk' HW HV 1 (e / 4) (x + h / 2) (x + h) ltac:(auto) ltac:(lra)) as P. fold D in P. 
    assert (D (x + h) + 2 * k * (e / 4) * (x + h - (x + h / 2)) <= D (x + h / 2)); [ apply P | lra ]. intros y Hy. specialize (Wa y ltac:(lra)). split; [ lra | apply N; auto; lra ].
Qed.
End Plane.

Lemma ext_period T g : 0 < T -> forall t, ext T g (t + 2 * T) = ext T g t.
Proof. intros hT t. replace (t + 2 * T) with (t + T + T) by ring. rewrite !ext_anti by trivial. ring. Qed.

Lemma lambda_c_between : 0 < eq37_lambda_c < 1.
Proof.
  pose proof PI_RGT_0. assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra). assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (apply pow2_sqrt; nra).
  unfold eq37_lambda_c. split. apply Rdiv_lt_0_compat; lra. apply Rlt_div_l; trivial. nra.
Qed.
(* s22-trichotomy below lambda_c: every motion of the plane tends to (38) *)
Theorem eq38_attracts l vx vy : 0 < l < eq37_lambda_c -> let p := eq39_phi1 l in let W := ext PI (g38 l p) in
  motion l (fun t => - sin (p + t)) (fun _ => 0) vx vy -> is_lim (fun t => vx t - W t) p_infty 0 /\ is_lim vy p_infty 0.
Proof.
  intros [h0 h1] p W M. pose proof lambda_c_between. assert (hl : 0 < l < 1) by lra. destruct (eq38 l hl h1) as [HW P]. fold p in HW, P. fold W in HW, P. pose proof PI_RGT_0.
  assert (A : forall t, W (t + PI) = - W t) by (intros t; apply ext_anti; trivial).
  apply (plane_attracts l 1 (2 * PI) 0 PI (fun t => - sin (p + t)) W); trivial; try lra.
  - intros t. rewrite Rabs_Ropp. apply Rabs_le, SIN_bound.
  - intros t. apply ext_period; trivial.
  - unfold W. rewrite (ext_on PI _ PI_RGT_0 0) by (simpl; lra). unfold g38. simpl. replace (p + (0 - 0 * PI)) with p by ring. ring.
  - intros t Ht. specialize (P (t + PI) ltac:(lra)). rewrite A in P. lra.
  - intros t Ht. apply P. lra.
Qed.
