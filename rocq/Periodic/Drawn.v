(* When every motion under a periodic drive along a line, in the plane or with another friction backward than forward, is drawn to a periodic
   one: it is reached in a finite time if it rests with friction to spare, and approached if it passes from backward to forward at once.
   Two motions never move apart, and in each period they come nearer by a fixed amount, as long as they are not near. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod.
From Slipbook Require Export Analysis.
Open Scope R_scope.

(* what has a period and the limit 0 is 0 *)
Lemma per_zero (f : R -> R) T : 0 < T -> (forall t, f (t + T) = f t) -> is_lim f p_infty 0 -> forall t, f t = 0.
Proof.
  intros hT P L t. destruct (Req_dec (f t) 0) as [ | n]; trivial. exfalso. destruct (lim_near f 0 (Rabs (f t)) L (Rabs_pos_lt _ n)) as (t1 & _ & H).
  destruct (per_spec t T hT t1) as [z Hz]. specialize (H (t - IZR (- z - 1) * T)). rewrite shift_Z in H by trivial.
  rewrite minus_IZR, opp_IZR in H. specialize (H ltac:(lra)). unfold Rabs in H. destruct (Rcase_abs (f t)); lra.
Qed.
(* ---- what falls by c in each time T, or is below e ---- *)
Lemma drain (D : R -> R) t0 T c e : 0 < T -> 0 < c -> (forall t, t0 <= t -> 0 <= D t) -> (forall s t, t0 <= s <= t -> D t <= D s) ->
  (forall t, t0 <= t -> D (t + T) <= e \/ D (t + T) <= D t - c) -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> D t <= e.
Proof.
  intros hT hc P M F.
  assert (Q : forall n, D (t0 + INR n * T) <= e \/ D (t0 + INR n * T) <= D t0 - INR n * c).
  { induction n as [ | n IH ]. right. simpl. rewrite Rmult_0_l, Rplus_0_r. lra.
    assert (0 <= INR n * T) by (apply Rmult_le_pos; [ apply pos_INR | lra ]).
    rewrite S_INR. replace (t0 + (INR n + 1) * T) with (t0 + INR n * T + T) by ring.
    destruct (F (t0 + INR n * T) ltac:(lra)) as [k | k]; [ auto | ]. destruct IH as [j | j]. left. lra. right. lra. }
  destruct (nat_above (D t0 / c)) as [n Hn]. apply Rlt_div_l in Hn; [ | lra ].
  assert (N : 0 <= INR n * T) by (apply Rmult_le_pos; [ apply pos_INR | lra ]).
  exists (t0 + INR n * T). split; [ lra | ]. intros t Ht. specialize (M (t0 + INR n * T) t ltac:(lra)). destruct (Q n); [ lra | ].
  specialize (P (t0 + INR n * T) ltac:(lra)). lra.
Qed.
(* the same, where the fall is known for one window of length b in each period *)
Lemma drain_windows (D : R -> R) t0 z T b c e : 0 < T -> 0 <= b -> 0 < c -> (forall t, t0 <= t -> 0 <= D t) -> (forall s t, t0 <= s <= t -> D t <= D s) ->
  (forall n, let x := z + IZR n * T in t0 <= x -> e < D (x + b) -> D (x + b) + c <= D x) -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> D t <= e.
Proof.
  intros hT hb hc P M F. apply (drain D t0 (T + b) c e); try lra; trivial. intros t Ht. destruct (per_spec z T hT (t + T)) as [n Hn].
  specialize (F n). cbv zeta in F. assert (Hx : t < z + IZR n * T <= t + T) by lra. set (x := z + IZR n * T) in *.
  pose proof (M (x + b) (t + (T + b)) ltac:(lra)). pose proof (M t x ltac:(lra)).
  destruct (Rle_lt_dec (D (x + b)) e) as [k | k]; [ left; lra | right; specialize (F ltac:(lra) k); lra ].
Qed.
(* a function that is between - m and l at r keeps away from both for a while *)
Lemma spare_lasts (a : R -> R) m l r : continuity_pt a r -> - m < a r < l -> exists b c, 0 < b /\ 0 < c /\ forall t, r <= t <= r + b -> - m + c <= a t <= l - c.
Proof.
  intros ca H. set (c := Rmin (l - a r) (m + a r) / 2). assert (c0 : 0 < Rmin (l - a r) (m + a r)) by (apply Rmin_pos; lra).
  pose proof (Rmin_l (l - a r) (m + a r)). pose proof (Rmin_r (l - a r) (m + a r)). destruct (ca c) as (d & d0 & Hd); [ unfold c; lra | ].
  exists (d / 2), c. split; [ lra | split; [ unfold c; lra | ] ]. intros t Ht. destruct (Req_dec r t) as [<- | ne]; [ unfold c; lra | ].
  assert (K : Rabs (a t - a r) < c). { apply Hd. split. split; [ exact I | trivial ]. simpl. unfold R_dist. apply Rabs_def1; lra. }
  apply Rabs_def2 in K. unfold c in *. lra.
Qed.
(* ---- two motions under one drive a along x, of which the second, W, stays on that line; friction has at most the size l forward and m backward.
   brakes: what the forces fx, fy at the velocity u and g at w do to the distance of the velocities ---- *)
Definition brakes (l m ux uy w fx fy g : R) : Prop := fx <= m /\ g <= m /\ (ux - w) * (fx - g) + uy * fy <= 0 /\
  (forall s n, s = 1 \/ s = -1 -> 0 < s * w -> 0 <= n <= nrm ux uy - s * ux -> 2 * ((ux - w) * (fx - g) + uy * fy) <= - (l + m) * n) /\
  (forall c, w = 0 -> - m + c <= - g <= l - c -> ux * (fx - g) + uy * fy <= - c * nrm ux uy).
Definition two_motions (l m : R) (a : R -> R) (t0 : R) (vx vy W : R -> R) : Prop :=
  (forall t, t0 < t -> continuity_pt vx t /\ continuity_pt vy t /\ continuity_pt W t) /\
  forall t, t0 <= t -> exists fx fy g, brakes l m (vx t) (vy t) (W t) fx fy g /\ rder vx t (a t + fx) /\ rder vy t fy /\ rder W t (a t + g).
Lemma coulomb_brakes k ux uy w fx fy g h : 0 <= k -> coulomb k ux uy fx fy -> coulomb k w 0 g h -> brakes k k ux uy w fx fy g.
Proof.
  intros hk [F P] C. destruct (coulomb_slip _ _ _ _ _ hk C) as [E _]. destruct C as [G Q]. rewrite nrm_x in *. assert (f : - k <= fx <= k) by nra.
  assert (g0 : - k <= g <= k) by nra. destruct (abs_nrm ux uy) as [u _].
  apply Rabs_le_between in u. set (v := nrm ux uy) in *. assert (X : (ux - w) * (fx - g) + uy * fy = - k * v - fx * w - k * Rabs w - g * ux) by lra.
  assert (S : forall s, s = 1 \/ s = -1 -> 0 < s * w -> Rabs w = s * w /\ g = - k * s /\ - (fx * w) <= k * (s * w)).
  { intros s [-> | ->] h0; [ rewrite Rabs_pos_eq in * by lra | rewrite Rabs_left in * by lra ]; repeat split; nra. }
  assert (L : forall s n, s = 1 \/ s = -1 -> 0 < s * w -> 0 <= n <= v - s * ux -> 2 * ((ux - w) * (fx - g) + uy * fy) <= - (k + k) * n).
  { intros s n hs h0 hn. destruct (S s hs h0) as (e & -> & b). rewrite X, e. assert (k * n <= k * (v - s * ux)) by (apply Rmult_le_compat_l; lra).
    lra. }
  repeat split; try lra; trivial.
  - destruct (total_order_T w 0) as [[n | ->] | n]; [ specialize (L (-1) 0) | rewrite X, Rabs_R0; nra | specialize (L 1 0) ]; lra.
  - intros c -> b. fold v. rewrite Rabs_R0, Rminus_0_r in X. assert (0 <= (k - c + g) * (v + ux)) by (apply Rmult_le_pos; lra).
    assert (0 <= (k - c - g) * (v - ux)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma plane_two k a vx vy W : 0 <= k -> motion k a (fun _ => 0) W (fun _ => 0) -> motion k a (fun _ => 0) vx vy -> two_motions k k (fun t => - a t) 0 vx vy W.
Proof.
  intros hk [cW _ LW] [cx cy L]. split; [ auto | ]. intros t Ht. destruct (L t Ht) as (fx & fy & C & X & Y).
  destruct (LW t Ht) as (g & h & D & Z & _). exists fx, fy, g.
  split; [ now apply (coulomb_brakes _ _ _ _ _ _ _ h) | repeat split; eapply rder_eq; eauto; ring ].
Qed.

Section Two.
Variables (l m t0 : R) (a vx vy W : R -> R).
Hypothesis M : two_motions l m a t0 vx vy W.
Definition gap t := (vx t - W t) ^ 2 + vy t ^ 2.
Ltac law t := destruct (proj2 M t) as (fx & fy & g & (B1 & B2 & B3 & B4 & B5) & X & Y & Z); [ lra | ].
Ltac conts := let u := fresh "u" in let H := fresh "H" in intros u H; destruct (proj1 M u) as (? & ? & ?); [ lra | cont ].
Lemma gap_falls s t : t0 <= s <= t -> gap t <= gap s.
Proof. intros H. unfold gap. apply (rder_decr (fun t => (vx t - W t) ^ 2 + vy t ^ 2)); [ lra | conts | ]. intros u Hu. law u. eexists.
  split; [ rd | simpl; lra ]. Qed.
(* while W goes to the side s and the other does not, the gap falls *)
Lemma gap_loss s n p q : s = 1 \/ s = -1 -> 0 <= n -> t0 <= p <= q -> (forall y, p <= y < q -> 0 < s * W y /\ n <= nrm (vx y) (vy y) - s * vx y) -> gap q + (l + m) * n * (q - p) <= gap p.
Proof.
  intros hs hn H S. enough (gap q + (l + m) * n * q <= gap p + (l + m) * n * p) by lra. unfold gap.
  apply (rder_decr (fun t => (vx t - W t) ^ 2 + vy t ^ 2 + (l + m) * n * t)); [ lra | conts | ]. intros u Hu. law u. destruct (S u Hu) as [s1 s2].
  specialize (B4 s n hs s1 (conj hn s2)). eexists. split; [ rd | simpl; lra ].
Qed.
Lemma rises B : (forall t, Rabs (a t) <= B) -> forall x y, t0 <= x <= y -> vx y - vx x <= (B + m) * (y - x) /\ W y - W x <= (B + m) * (y - x).
Proof.
  intros hB x y H. enough (vx y - (B + m) * y <= vx x - (B + m) * x /\ W y - (B + m) * y <= W x - (B + m) * x) by lra.
  split; [ apply (rder_decr (fun t => vx t - (B + m) * t)) | apply (rder_decr (fun t => W t - (B + m) * t)) ]; try lra; try conts;
    intros u Hu; law u; specialize (hB u); apply Rabs_le_between in hB; eexists; (split; [ rd | lra ]).
Qed.
(* while W rests, and friction could bear c more, the speed falls at the rate c *)
Lemma speed_falls c x y : t0 <= x <= y -> (forall z, x <= z <= y -> W z = 0 /\ nrm (vx z) (vy z) <> 0 /\ - m + c <= a z <= l - c) -> nrm (vx y) (vy y) + c * (y - x) <= nrm (vx x) (vy x).
Proof.
  intros H on. enough (nrm (vx y) (vy y) + c * y <= nrm (vx x) (vy x) + c * x) by lra.
  apply (rder_decr (fun t => nrm (vx t) (vy t) + c * t)); [ lra | conts | ]. intros u Hu. law u. destruct (on u) as (w0 & N & A); [ lra | ].
  assert (e : a u + g = 0) by (apply (rder_unique W u); [ trivial | apply (rder_zero W u (y - u)); [ lra | intros; apply on; lra ] ]).
  specialize (B5 c w0 ltac:(lra)).
  eexists. split; [ rd; trivial | ]. pose proof (nrm_pos (vx u) (vy u)). set (v := nrm (vx u) (vy u)) in *.
  assert ((vx u * (a u + fx) + vy u * fy) / v <= - c); [ apply Rle_div_l; [ lra | ] | lra ]. replace (a u) with (- g) by lra. lra.
Qed.
Variable T : R.
Hypothesis hT : 0 < T.
Hypothesis hW : forall t, W (t + T) = W t.
(* where W passes from backward to forward at once the other is drawn to it *)
Lemma two_attract B z d : 0 < l + m -> (forall t, Rabs (a t) <= B) -> 0 < B + m -> 0 < d -> W z = 0 -> (forall t, z - d < t < z -> W t < 0) -> (forall t, z < t < z + d -> 0 < W t) ->
  is_lim (fun t => vx t - W t) p_infty 0 /\ is_lim vy p_infty 0.
Proof.
  intros hk hB Lp hd zero before after. enough (S : forall e, 0 < e -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> gap t <= e ^ 2).
  { split; apply lim_zero; intros e he; destruct (S e he) as (t1 & _ & h); exists t1; intros t Ht; specialize (h t Ht); unfold gap in h;
    pose proof (pow2_ge_0 (vx t - W t)); pose proof (pow2_ge_0 (vy t)); apply abs_of_sq; lra. }
  intros e he. set (L := B + m) in *. assert (e0 : 0 < e / (8 * L)) by (apply Rdiv_lt_0_compat; lra). set (h := Rmin (d / 2) (e / (8 * L))).
  assert (hh : 0 < h /\ h < d /\ L * h <= e / 8).
  { unfold h. pose proof (Rmin_l (d / 2) (e / (8 * L))). pose proof (Rmin_r (d / 2) (e / (8 * L))). split; [ apply Rmin_pos; lra | split; [ lra | ] ].
    replace (e / 8) with (L * (e / (8 * L))) by (field; lra). apply Rmult_le_compat_l; lra. } clearbody h.
  assert (c0 : 0 < (l + m) * (e / 4) * (h / 2)) by (repeat apply Rmult_lt_0_compat; lra). pose proof gap_falls as C.
  apply (drain_windows gap t0 (z - h) T (2 * h) ((l + m) * (e / 4) * (h / 2)) (e ^ 2)); try lra; trivial; [ intros t _; apply Rplus_le_le_0_compat;
  apply pow2_ge_0 | ].
  intros n y0 Hy0. unfold y0 in *. clear y0. set (x := z + IZR n * T). replace (z - h + IZR n * T) with (x - h) in * by (unfold x; ring).
  replace (x - h + 2 * h) with (x + h) by ring. intros K.
  assert (on : forall y, W (y - IZR n * T) = W y) by (intros; now apply shift_Z).
  assert (Wx : W x = 0) by (rewrite <- on; unfold x; replace (z + IZR n * T - IZR n * T) with z by ring; trivial).
  assert (Wb : forall y, x - h <= y < x -> W y < 0) by (intros y Hy; rewrite <- on; apply before; unfold x in *; lra).
  assert (Wa : forall y, x < y <= x + h -> 0 < W y) by (intros y Hy; rewrite <- on; apply after; unfold x in *; lra). clearbody x.
  assert (Lip : forall p q, x - h <= p <= q -> q <= x + h -> q - p <= h -> vx q - vx p <= e / 8 /\ W q - W p <= e / 8).
  { intros p q Hp Hq hpq. destruct (rises B hB p q ltac:(lra)) as [Q1 Q2]. fold L in Q1, Q2.
    assert (L * (q - p) <= L * h) by (apply Rmult_le_compat_l; lra). lra. }
  assert (far : forall y, x - h <= y <= x + h -> 3 * e / 4 <= nrm (vx y) (vy y)).
  { intros y Hy. pose proof (C y (x + h) ltac:(lra)) as Q. assert (w : - (e / 8) <= W y <= e / 8).
    { destruct (total_order_T y x) as [[q | ->] | q]; [ destruct (Lip y x); try lra; specialize (Wb y) | | destruct (Lip x y); try lra;
      specialize (Wa y) ]; lra. }
    unfold gap in Q at 2. pose proof (nrm_sq (vx y) (vy y)) as N. pose proof (nrm_pos (vx y) (vy y)) as N0. set (v := nrm (vx y) (vy y)) in *.
    assert (vv : - v <= vx y <= v) by nra. apply Rnot_lt_le. intros q. assert (- (vx y * W y) <= v * (e / 8)) by nra. nra. }
  destruct (Rle_lt_dec 0 (vx x)) as [s | s].
  - pose proof (gap_loss (-1) (e / 4) (x - h) x ltac:(auto) ltac:(lra) ltac:(lra)) as P. pose proof (C x (x + h) ltac:(lra)).
    assert (gap x + (l + m) * (e / 4) * (x - (x - h)) <= gap (x - h)); [ apply P | nra ].
    intros y Hy. specialize (Wb y ltac:(lra)). destruct (Lip y x); try lra. specialize (far y ltac:(lra)). lra.
  - pose proof (gap_loss 1 (e / 4) (x + h / 2) (x + h) ltac:(auto) ltac:(lra) ltac:(lra)) as P. pose proof (C (x - h) (x + h / 2) ltac:(lra)).
    assert (gap (x + h) + (l + m) * (e / 4) * (x + h - (x + h / 2)) <= gap (x + h / 2)); [ apply P | lra ].
    intros y Hy. specialize (Wa y ltac:(lra)). destruct (Lip x y); try lra. specialize (far y ltac:(lra)). lra.
Qed.
(* where W rests with friction to spare the other reaches it *)
Lemma two_meet r s : (forall t, a (t + T) = a t) -> r < s -> (forall t, r <= t <= s -> W t = 0) -> - m < a r < l -> continuity_pt a r -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> vx t = W t /\ vy t = 0.
Proof.
  intros ha hrs rest spare ca. destruct (spare_lasts a m l r ca spare) as (b' & c & b0 & c0 & near). set (b := Rmin b' (s - r)).
  assert (bb : 0 < b) by (apply Rmin_pos; lra).
  assert (b1 : b <= b' /\ b <= s - r) by (split; [ apply Rmin_l | apply Rmin_r ]). clearbody b. set (D t := nrm (vx t - W t) (vy t)).
  assert (C : forall s t, t0 <= s <= t -> D t <= D s) by (intros x y H; unfold D, nrm; apply sqrt_le_1_alt; now apply gap_falls).
  destruct (drain_windows D t0 r T b (c * b) 0) as (t1 & t1a & Ht1); try lra; trivial; [ now apply Rmult_lt_0_compat | intros; apply nrm_pos | | ].
  - intros n x Hx K. assert (on : forall y, x <= y <= x + b -> W y = 0 /\ - m + c <= a y <= l - c).
    { intros y Hy. rewrite <- (shift_Z T W hW n y), <- (shift_Z T a ha n y). split; [ apply rest | apply near ]; unfold x in *; lra. } clearbody x.
    assert (De : forall y, x <= y <= x + b -> D y = nrm (vx y) (vy y)) by (intros y Hy; unfold D; destruct (on y Hy) as [-> _]; f_equal; ring).
    pose proof (speed_falls c x (x + b) ltac:(lra)) as F. rewrite <- !De in F by lra. replace (x + b - x) with b in F by ring. apply F. intros y Hy.
    destruct (on y Hy). repeat split; try lra. pose proof (C y (x + b) ltac:(lra)). rewrite <- De; lra.
  - exists t1. split; trivial. intros t Ht. destruct (nrm_zero (vx t - W t) (vy t)); [ | lra ]. specialize (Ht1 t Ht).
    pose proof (nrm_pos (vx t - W t) (vy t)). unfold D in Ht1. lra.
Qed.
End Two.
Theorem plane_attracts k B T z d (a W : R -> R) : 0 < k -> (forall t, Rabs (a t) <= B) -> motion k a (fun _ => 0) W (fun _ => 0) -> 0 < T -> (forall t, W (t + T) = W t) -> 0 < d -> W z = 0 ->
  (forall t, z - d < t < z -> W t < 0) -> (forall t, z < t < z + d -> 0 < W t) -> forall vx vy, motion k a (fun _ => 0) vx vy -> is_lim (fun t => vx t - W t) p_infty 0 /\ is_lim vy p_infty 0.
Proof.
  intros hk hB HW hT hW hd Z b f vx vy HV. assert (0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra).
  apply (two_attract k k 0 _ vx vy W (plane_two k a vx vy W ltac:(lra) HW HV) T hT hW B z d); trivial; try lra. intros t. now rewrite Rabs_Ropp.
Qed.
Theorem plane_reached k T r s (a W : R -> R) : 0 < k -> 0 < T -> (forall t, a (t + T) = a t) -> motion k a (fun _ => 0) W (fun _ => 0) -> (forall t, W (t + T) = W t) -> r < s -> (forall t, r <= t <= s -> W t = 0) ->
  Rabs (a r) < k -> continuity_pt a r -> forall vx vy, motion k a (fun _ => 0) vx vy -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> vx t = W t /\ vy t = 0.
Proof.
  intros hk hT ha HW hW hrs Z S ca vx vy HV. apply Rabs_def2 in S.
  apply (two_meet k k 0 _ vx vy W (plane_two k a vx vy W ltac:(lra) HW HV) T hT hW r s); trivial; try lra; [ intros; now rewrite ha |
  now apply continuity_pt_opp ].
Qed.

(* (26) with h in place of the sine; velocities in units of A0/varpi, l = lambda0. «$(vx,vy)$ is a motion of the plane under the drive $h$ along
   the first axis, from its phase $p$ on, with the friction $l$» *)
Definition moves (l : R) (h : R -> R) (p : R) (vx vy : R -> R) : Prop := motion l (fun t => - h (p + t)) (fun _ => 0) vx vy.
(* W has the drive's period, is a motion, and every motion tends to it. «$W$ is the motion at large times under the drive $h$ and the friction
   $l$» *)
Record late (l : R) (h W : R -> R) : Prop := {
  late_per : forall ph, W (ph + 2 * PI) = W ph;
  late_moves : forall p, moves l h p (fun t => W (p + t)) (fun _ => 0);
  late_drawn : forall p vx vy, moves l h p vx vy -> is_lim (fun t => vx t - W (p + t)) p_infty 0 /\ is_lim vy p_infty 0 }.
(* «every motion of the plane under the drive $h$ and the friction $l$ is equal to $W$ from some time on» *)
Definition caught (l : R) (h W : R -> R) : Prop := forall p vx vy, moves l h p vx vy -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> vx t = W (p + t) /\ vy t = 0.

Lemma caught_late l h W : (forall t, W (t + 2 * PI) = W t) -> (forall p, moves l h p (fun t => W (p + t)) (fun _ => 0)) -> caught l h W -> late l h W.
Proof.
  intros P M C. split; trivial. intros p vx vy V. destruct (C p vx vy V) as (t1 & _ & H). 
  split; apply (lim_eventually _ t1); intros t Ht; destruct (H t Ht) as [e1 e2]; rewrite ?e1, ?e2; ring.
Qed.
Lemma late_unique l h W U : late l h W -> late l h U -> forall t, W t = U t.
Proof.
  intros [PW MW _] [PU _ DU] t. destruct (DU 0 _ _ (MW 0)) as [L _]. 
  pose proof (per_zero (fun t => W (0 + t) - U (0 + t)) (2 * PI) ltac:(pose proof PI_RGT_0; lra)) as Z. cbv beta in Z.
  specialize (Z ltac:(intros s; rewrite <- !Rplus_assoc, PW, PU; ring) L t).
  rewrite Rplus_0_l in Z. lra.
Qed.
(* v is a velocity, or a speed: «from some time on each period holds an interval in which $v=0$» *)
Definition rests (v : R -> R) : Prop := exists t1, forall t, t1 <= t -> exists s d, t <= s <= t + 2 * PI /\ 0 < d /\ forall u, s <= u <= s + d -> v u = 0.
(* «from some time on $v$ is $0$ in no interval» *)
Definition restless (v : R -> R) : Prop := exists t1, forall s d, t1 <= s -> 0 < d -> exists u, s <= u <= s + d /\ v u <> 0.
(* at rest the right derivative is 0 *)
Lemma rder_rest v s d l : 0 < d -> (forall u, s <= u <= s + d -> v u = 0) -> rder v s l -> l = 0.
Proof.
  intros hd Z R. apply (rder_unique v s l 0 R), (rder_zero v s d hd). intros. apply Z. lra.
Qed.
