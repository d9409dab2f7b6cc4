(* 2.2: how much nearer to (38) a period brings every motion of the plane *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic Steady Steady2 Pulse Aniso Attract AttractPlane.
Open Scope R_scope.

Section Rate.
Variables (k B : R) (a W vx vy : R -> R).
Hypothesis hk : 0 < k.
Hypothesis hB : forall t, Rabs (a t) <= B.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis HV : motion k a (fun _ => 0) vx vy.
Let D := gap W vx vy.
Lemma B_pos : 0 <= B. Proof. pose proof (hB 0). pose proof (Rabs_pos (a 0)). lra. Qed.
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
  D q + 2 * k * (n0 * q + n1 * q ^ 2 / 2) <= D p + 2 * k * (n0 * p + n1 * p ^ 2 / 2).
Proof.
  intros hs H S. unfold D, gap.
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

(* W turns at x and keeps its sign for d on either side: theorem 10's inequality *)
Theorem nearer x d : 0 < d -> 0 <= x - d -> W x = 0 -> (forall t, x - d < t < x -> W t < 0) -> (forall t, x < t < x + d -> 0 < W t) ->
  let e := sqrt (D (x + d)) in Rmin (k * e ^ 2 / (2 * (B + k))) (k * d * e) <= D (x - d) - D (x + d).
Proof.
  intros hd hx Wx Wb Wa e. assert (hk' : 0 <= k) by lra. pose proof (gap_falls k a W vx vy hk' HW HV) as M. fold D in M. pose proof B_pos. set (L := B + k). assert (Lp : 0 < L) by (unfold L; lra).
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
End Rate.

(* theorem 10 for (38): the squared distance in the plane of velocities falls from half a period before the upward zero at x to half a period after it *)
Theorem eq38_nearer l vx vy n : 0 < l < eq37_lambda_c -> let p := eq39_phi1 l in let W := ext PI (g38 l p) in motion l (fun t => - sin (p + t)) (fun _ => 0) vx vy ->
  let x := INR (S n) * (2 * PI) in let D := gap W vx vy in let e := sqrt (D (x + PI)) in Rmin (l * e ^ 2 / (2 * (1 + l))) (l * PI * e) <= D (x - PI) - D (x + PI).
Proof.
  intros [h0 h1] p W M x D e. pose proof lambda_c_between. assert (hl : 0 < l < 1) by lra. destruct (eq38 l hl h1) as [HW P]. fold p in HW, P. fold W in HW, P. pose proof PI_RGT_0 as pi0.
  assert (x1 : 2 * PI <= x) by (unfold x; rewrite S_INR; pose proof (pos_INR n); nra).
  assert (R : forall t, W (x + t) = W t).
  { intros t. unfold x. clear. induction (S n) as [ | m IH ]. simpl. f_equal. ring. rewrite S_INR. replace ((INR m + 1) * (2 * PI) + t) with (INR m * (2 * PI) + t + 2 * PI) by ring. unfold W. rewrite ext_period by apply PI_RGT_0. exact IH. }
  assert (W0 : W 0 = 0) by (unfold W; rewrite (ext_on PI _ PI_RGT_0 0) by (simpl; lra); unfold g38; simpl; replace (p + (0 - 0 * PI)) with p by ring; ring).
  assert (hB : forall t, Rabs (- sin (p + t)) <= 1) by (intros t; rewrite Rabs_Ropp; apply Rabs_le, SIN_bound).
  apply (nearer l 1 (fun t => - sin (p + t)) W vx vy h0 hB HW M x PI); try lra.
  - replace x with (x + 0) by ring. rewrite R. exact W0.
  - intros t Ht. replace t with (x + (t - x)) by ring. rewrite R. specialize (P (t - x + PI) ltac:(lra)). unfold W in P. rewrite ext_anti in P by trivial. unfold W. lra.
  - intros t Ht. replace t with (x + (t - x)) by ring. rewrite R. apply P. lra.
Qed.
