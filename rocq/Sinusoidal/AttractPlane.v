(* A drive along x: every motion of the plane beside one on the line, W. The squared distance of their velocities never grows, and falls where W
   turns by an amount that depends on the distance alone (nearer); so a periodic W that turns at once attracts every motion (plane_attracts). *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Periodic Pulse Aniso Attract.
Open Scope R_scope.

Lemma nrm_line x : nrm x 0 = Rabs x.
Proof. unfold nrm. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. ring. Qed.
Lemma nrm_ge x y : Rabs x <= nrm x y /\ Rabs y <= nrm x y.
Proof. split; unfold nrm; rewrite <- sqrt_Rsqr_abs; apply sqrt_le_1_alt; unfold Rsqr; nra. Qed.
Lemma abs_of_sq x y e : 0 < e -> x ^ 2 + y ^ 2 <= e ^ 2 -> Rabs x <= e /\ Rabs y <= e.
Proof.
  intros he H. pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 y). rewrite <- (Rabs_pos_eq e) by lra.
  split; apply Rsqr_le_abs_0; rewrite !Rsqr_pow2; lra.
Qed.

Section Two.
Variables (k B : R) (a W vx vy : R -> R).
Hypothesis hk : 0 < k.
Hypothesis hB : forall t, Rabs (a t) <= B.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis HV : motion k a (fun _ => 0) vx vy.
Definition gap t := (vx t - W t) ^ 2 + vy t ^ 2.
Lemma gap_falls s t : 0 <= s <= t -> gap t <= gap s.
Proof.
  intros H. unfold gap. pose proof (contraction k a (fun _ => 0) vx vy W (fun _ => 0) ltac:(lra) HV HW s t H) as K. cbv beta in K.
  rewrite !Rminus_0_r in K. exact K.
Qed.
Lemma gap_pos t : 0 <= gap t.
Proof. unfold gap. pose proof (pow2_ge_0 (vx t - W t)). pose proof (pow2_ge_0 (vy t)). lra. Qed.
(* along any direction the velocity changes at the rate B + k at most *)
Lemma along c s e x y : c ^ 2 + s ^ 2 = 1 -> e = 1 \/ e = -1 -> 0 <= x <= y -> e * ((c * vx y + s * vy y) - (c * vx x + s * vy x)) <= (B + k) * (y - x).
Proof.
  intros cs he H. enough (e * (c * vx y + s * vy y) - (B + k) * y <= e * (c * vx x + s * vy x) - (B + k) * x) by lra.
  apply (rder_decr (fun t => e * (c * vx t + s * vy t) - (B + k) * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply (m_cx _ _ _ _ _ HV) | apply (m_cy _ _ _ _ _ HV) ]; lra.
  - destruct (m_law _ _ _ _ _ HV t) as (fx & fy & [C1 C2] & X & Y); [ lra | ]. specialize (hB t). apply Rabs_le_between in hB.
    assert (k0 : 0 <= k) by lra. pose proof (power_bound k fx fy (- e * c) (- e * s) k0 C1) as P. 
    assert (n1 : nrm (- e * c) (- e * s) = 1). { unfold nrm. replace ((- e * c) ^ 2 + (- e * s) ^ 2) with (e ^ 2 * (c ^ 2 + s ^ 2)) by ring. rewrite cs. replace (e ^ 2) with 1 by (destruct he as [-> | ->]; ring). rewrite Rmult_1_r. apply sqrt_1. }
    rewrite n1 in P. assert (c1 : -1 <= e * c <= 1) by (assert (c ^ 2 <= 1) by (pose proof (pow2_ge_0 s); lra); destruct he as [-> | ->]; nra).
    eexists. split. rd. simpl. assert (- (a t * (e * c)) <= B) by nra. lra.
Qed.
(* the gap falls by twice k times the integral of what is below |v| - s vx, here a line *)
Lemma gap_loss_line s n0 n1 p q : s = 1 \/ s = -1 -> 0 <= p <= q -> (forall y, p <= y < q -> 0 < s * W y /\ n0 + n1 * y <= nrm (vx y) (vy y) - s * vx y) ->
  gap q + 2 * k * (n0 * q + n1 * q ^ 2 / 2) <= gap p + 2 * k * (n0 * p + n1 * p ^ 2 / 2).
Proof.
  intros hs H S. unfold gap.
  apply (rder_decr (fun t => (vx t - W t) ^ 2 + vy t ^ 2 + 2 * k * (n0 * t + n1 * t ^ 2 / 2))); [ lra | | ]; intros t Ht.
  - apply (continuity_pt_plus (fun t => (vx t - W t) ^ 2 + vy t ^ 2) (fun t => 2 * k * (n0 * t + n1 * t ^ 2 / 2))).
    cont; [ apply (m_cx _ _ _ _ _ HV) | apply (m_cx _ _ _ _ _ HW) | apply (m_cy _ _ _ _ _ HV) ]; lra.
    apply derivable_continuous_pt. reg.
  - destruct (m_law _ _ _ _ _ HV t) as (fx & fy & [C1 C2] & X & Y); [ lra | ]. destruct (m_law _ _ _ _ _ HW t) as (F & G & C & Z & _); [ lra | ]. assert (k0 : 0 <= k) by lra.
    destruct (coulomb_slip _ _ _ _ _ k0 C) as [E _]. destruct (S t) as [s1 s2]; [ lra | ]. pose proof (nrm_sq (W t) 0) as N. pose proof (nrm_pos (W t) 0).
    assert (e : nrm (W t) 0 = s * W t) by (destruct hs as [-> | ->]; nra). assert (eF : F = - k * s) by (rewrite e in E; destruct hs as [-> | ->]; nra). subst F.
    assert (hf : - k <= fx <= k) by nra. assert (b : - (fx * W t) <= k * (s * W t)) by (destruct hs as [-> | ->]; nra).
    set (v := nrm (vx t) (vy t)) in *. set (w := s * W t) in *. assert (ss : s * s = 1) by (destruct hs as [-> | ->]; ring). set (n := n0 + n1 * t) in *.
    assert (k * n <= k * (v - s * vx t)) by (apply Rmult_le_compat_l; trivial).
    exists (2 * ((fx * vx t + fy * vy t) - fx * W t + k * s * vx t - k * w + k * n)). split; [ | rewrite C2; lra ].
    eapply rder_eq. apply (rder_plus (fun t => (vx t - W t) ^ 2 + vy t ^ 2) (fun t => 2 * k * (n0 * t + n1 * t ^ 2 / 2))). rd. apply rder_of. auto_derive; trivial. unfold w, n. simpl. field.
Qed.

(* W turns at x and keeps its sign for d on either side: so much nearer it is afterwards *)
Lemma nearer x d : 0 < d -> 0 <= x - d -> W x = 0 -> (forall t, x - d < t < x -> W t < 0) -> (forall t, x < t < x + d -> 0 < W t) ->
  let e := sqrt (gap (x + d)) in Rmin (k * e ^ 2 / (2 * (B + k))) (k * d * e) <= gap (x - d) - gap (x + d).
Proof.
  intros hd hx Wx Wb Wa e. set (D := gap) in *. assert (M : forall s t, 0 <= s <= t -> D t <= D s) by exact gap_falls.
  assert (B0 : 0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra). set (L := B + k). assert (Lp : 0 < L) by (unfold L; lra).
  assert (e0 : 0 <= e) by apply sqrt_pos. assert (e2 : e ^ 2 = D (x + d)) by (apply pow2_sqrt, gap_pos).
  destruct e0 as [e0 | e0]. 2: { rewrite <- e0. replace (k * 0 ^ 2 / (2 * L)) with 0 by (unfold Rdiv; ring). pose proof (Rmin_l 0 (k * d * 0)). pose proof (M (x - d) (x + d) ltac:(lra)). lra. }
  set (n := nrm (vx x) (vy x)). assert (n2 : n ^ 2 = D x) by (unfold n, D, gap; rewrite nrm_sq, Wx; ring). pose proof (nrm_pos (vx x) (vy x)) as n0. fold n in n0.
  assert (en : e <= n). { pose proof (M x (x + d) ltac:(lra)). nra. }
  (* |v| - s vx falls from n at the rate 2 L at most *)
  assert (Q : forall s y, s = 1 \/ s = -1 -> 0 <= - s * vx x -> 0 <= y -> e - 2 * L * Rabs (y - x) <= nrm (vx y) (vy y) - s * vx y).
  { intros s y hs sg hy. set (c := vx x / n). set (c' := vy x / n). assert (cs : c ^ 2 + c' ^ 2 = 1). { unfold c, c'. replace ((vx x / n) ^ 2 + (vy x / n) ^ 2) with ((vx x ^ 2 + vy x ^ 2) / n ^ 2) by (field; lra). rewrite <- nrm_sq. fold n. field. lra. }
    assert (cv : c * vx x + c' * vy x = n). { unfold c, c'. replace (vx x / n * vx x + vy x / n * vy x) with ((vx x ^ 2 + vy x ^ 2) / n) by (field; lra). rewrite <- nrm_sq. fold n. field. lra. }
    assert (big : c * vx y + c' * vy y <= nrm (vx y) (vy y)). { pose proof (power_bound 1 (- c) (- c') (vx y) (vy y) ltac:(lra)) as P. assert (- (1) * nrm (vx y) (vy y) <= - c * vx y + - c' * vy y); [ apply P | lra ]. replace ((- c) ^ 2 + (- c') ^ 2) with (c ^ 2 + c' ^ 2) by ring. lra. }
    assert (one : 1 ^ 2 + 0 ^ 2 = 1) by ring. unfold L. destruct (Rle_lt_dec x y).
    - rewrite Rabs_pos_eq by lra. pose proof (along c c' (-1) x y cs ltac:(auto) ltac:(lra)). pose proof (along 1 0 1 x y one ltac:(auto) ltac:(lra)). pose proof (along 1 0 (-1) x y one ltac:(auto) ltac:(lra)). destruct hs as [-> | ->]; lra.
    - rewrite Rabs_left by lra. pose proof (along c c' 1 y x cs ltac:(auto) ltac:(lra)). pose proof (along 1 0 1 y x one ltac:(auto) ltac:(lra)). pose proof (along 1 0 (-1) y x one ltac:(auto) ltac:(lra)). destruct hs as [-> | ->]; lra. }
  set (b := Rmin d (e / (2 * L))). assert (b1 : b <= d) by apply Rmin_l. assert (b2 : b <= e / (2 * L)) by apply Rmin_r. assert (b0 : 0 < b) by (apply Rmin_pos; [ lra | apply Rdiv_lt_0_compat; lra ]).
  assert (bL : 2 * L * b <= e). { replace e with (2 * L * (e / (2 * L))) by (field; lra). apply Rmult_le_compat_l; lra. }
  assert (G : Rmin (k * e ^ 2 / (2 * L)) (k * d * e) <= 2 * k * (e * b - L * b ^ 2)).
  { unfold b in *. destruct (Rle_lt_dec d (e / (2 * L))) as [c | c].
    - rewrite (Rmin_left d) in * by trivial. apply Rle_trans with (1 := Rmin_r _ _). assert (0 <= k * d * (e - 2 * L * d)) by (apply Rmult_le_pos; [ apply Rmult_le_pos |]; lra). nra.
    - rewrite (Rmin_right d) in * by lra. apply Rle_trans with (1 := Rmin_l _ _). right. field. lra. }
  apply Rle_trans with (1 := G). clear G. apply le_epsilon. intros eps he. set (g := Rmin (b / 2) (eps / (2 * k * e))). assert (ke : 0 < 2 * k * e) by (apply Rmult_lt_0_compat; lra).
  assert (g1 : g <= b / 2) by apply Rmin_l. assert (g0 : 0 < g) by (apply Rmin_pos; [ lra | now apply Rdiv_lt_0_compat ]).
  assert (g2 : 2 * k * e * g <= eps). { replace eps with (2 * k * e * (eps / (2 * k * e))) by (field; lra). apply Rmult_le_compat_l; [ lra | apply Rmin_r ]. }
  assert (loss : 2 * k * (e * b - L * b ^ 2) - 2 * k * e * g <= 2 * k * (e * (b - g) - L * (b - g) ^ 2)).
  { assert (0 <= 2 * k * (L * (g * (2 * b - g)))); [ | lra ]. repeat apply Rmult_le_pos; lra. }
  destruct (Rle_lt_dec 0 (vx x)) as [s | s].
  - pose proof (gap_loss_line (-1) (e - 2 * L * x) (2 * L) (x - b + g) x ltac:(auto) ltac:(lra)) as P.
    assert (K : D x + 2 * k * ((e - 2 * L * x) * x + 2 * L * x ^ 2 / 2) <= D (x - b + g) + 2 * k * ((e - 2 * L * x) * (x - b + g) + 2 * L * (x - b + g) ^ 2 / 2)).
    { apply P. intros y Hy. split. specialize (Wb y ltac:(lra)). lra. pose proof (Q (-1) y ltac:(auto) ltac:(lra) ltac:(lra)) as Z. rewrite Rabs_left in Z by lra. lra. }
    pose proof (M (x - d) (x - b + g) ltac:(lra)). pose proof (M x (x + d) ltac:(lra)).
    assert (2 * k * ((e - 2 * L * x) * x + 2 * L * x ^ 2 / 2) - 2 * k * ((e - 2 * L * x) * (x - b + g) + 2 * L * (x - b + g) ^ 2 / 2) = 2 * k * (e * (b - g) - L * (b - g) ^ 2)) by field. lra.
  - pose proof (gap_loss_line 1 (e + 2 * L * x) (- 2 * L) (x + g) (x + b) ltac:(auto) ltac:(lra)) as P.
    assert (K : D (x + b) + 2 * k * ((e + 2 * L * x) * (x + b) + - 2 * L * (x + b) ^ 2 / 2) <= D (x + g) + 2 * k * ((e + 2 * L * x) * (x + g) + - 2 * L * (x + g) ^ 2 / 2)).
    { apply P. intros y Hy. split. specialize (Wa y ltac:(lra)). lra. pose proof (Q 1 y ltac:(auto) ltac:(lra) ltac:(lra)) as Z. rewrite Rabs_pos_eq in Z by lra. lra. }
    pose proof (M (x - d) (x + g) ltac:(lra)). pose proof (M (x + b) (x + d) ltac:(lra)).
    assert (2 * k * ((e + 2 * L * x) * (x + b) + - 2 * L * (x + b) ^ 2 / 2) - 2 * k * ((e + 2 * L * x) * (x + g) + - 2 * L * (x + g) ^ 2 / 2) = 2 * k * (e * (b - g) - L * (b ^ 2 - g ^ 2))) by field.
    assert (0 <= 2 * k * (L * g ^ 2)) by (repeat apply Rmult_le_pos; try apply pow2_ge_0; lra). lra.
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
  intros HV. set (D := gap W vx vy). assert (B0 : 0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra).
  enough (S : forall e, 0 < e -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> D t <= e ^ 2).
  { split; apply lim_zero; intros e he; destruct (S e he) as (t1 & _ & h); exists t1; intros t Ht; now destruct (abs_of_sq _ _ e he (h t Ht)). }
  intros e he. set (h := Rmin d (T / 2)). assert (hh : 0 < h /\ h <= d /\ h <= T / 2) by (unfold h; repeat split; [ apply Rmin_pos; lra | apply Rmin_l | apply Rmin_r ]).
  clearbody h. pose proof (gap_falls k a W vx vy hk HW HV) as M. fold D in M. set (c := Rmin (k * e ^ 2 / (2 * (B + k))) (k * h * e)).
  assert (kB : 0 < / (2 * (B + k))) by (apply Rinv_0_lt_compat; lra). assert (e2 : 0 < e ^ 2) by nra.
  assert (c0 : 0 < c) by (unfold c; apply Rmin_pos; [ apply Rmult_lt_0_compat; trivial; nra | repeat apply Rmult_lt_0_compat; lra ]).
  apply (drain D 0 (2 * T) c (e ^ 2)); trivial; try lra; [ intros; apply gap_pos | ].
  intros t Ht. destruct (per_spec z T hT (t + T + h)) as [n Hn]. set (x := z + IZR n * T). assert (x1 : t <= x - h /\ x + h <= t + 2 * T) by (unfold x; lra).
  assert (on : forall y, W (y - IZR n * T) = W y) by (intros; apply shift_Z; trivial).
  pose proof (M (x + h) (t + 2 * T) ltac:(lra)) as m1. pose proof (M t (x - h) ltac:(lra)) as m2.
  destruct (Rle_lt_dec (D (x + h)) (e ^ 2)) as [q | q]; [ left; lra | right ]. set (E := sqrt (D (x + h))).
  assert (EE : e <= E) by (unfold E; rewrite <- (sqrt_pow2 e) by lra; apply sqrt_le_1_alt; lra). assert (E2 : e ^ 2 <= E ^ 2) by (apply pow_incr; lra).
  enough (c <= D (x - h) - D (x + h)) by lra. apply Rle_trans with (Rmin (k * E ^ 2 / (2 * (B + k))) (k * h * E)).
  - apply Rmin_glb; [ apply Rle_trans with (1 := Rmin_l _ _) | apply Rle_trans with (1 := Rmin_r _ _) ].
    apply Rmult_le_compat_r; [ lra | nra ]. apply Rmult_le_compat_l; [ nra | trivial ].
  - apply (nearer k B a W vx vy hk hB HW HV x h); try lra.
    + rewrite <- on. unfold x. replace (z + IZR n * T - IZR n * T) with z by ring. trivial.
    + intros y Hy. rewrite <- on. apply before. unfold x in *. lra.
    + intros y Hy. rewrite <- on. apply after. unfold x in *. lra.
Qed.
End Plane.

Lemma ext_period T g : 0 < T -> forall t, ext T g (t + 2 * T) = ext T g t.
Proof. intros hT t. replace (t + 2 * T) with (t + T + T) by ring. rewrite !ext_anti by trivial. ring. Qed.
