(* When every motion of the plane is drawn to a periodic one along a straight drive: it is reached in a finite time if it
   rests with friction to spare, and approached if it passes from backward to forward at once. Two motions never move
   apart, and in each period they come nearer by a fixed amount, as long as they are not near. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General HalfPeriod.
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
  specialize (F n). cbv zeta in F. assert (Hx : t < z + IZR n * T <= t + T) by lra. set (x := z + IZR n * T) in *. pose proof (M (x + b) (t + (T + b)) ltac:(lra)). pose proof (M t x ltac:(lra)).
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
(* while it moves under a pull of k - c at most, the speed falls at the rate c at least *)
Lemma speed_falls_2 k Ax Ay vx vy c p q : motion k Ax Ay vx vy -> 0 <= p <= q ->
  (forall t, p <= t <= q -> nrm (vx t) (vy t) <> 0 /\ nrm (Ax t) (Ay t) <= k - c) -> nrm (vx q) (vy q) + c * (q - p) <= nrm (vx p) (vy p).
Proof.
  intros M H S. enough (nrm (vx q) (vy q) + c * q <= nrm (vx p) (vy p) + c * p) by lra.
  apply (rder_decr (fun t => nrm (vx t) (vy t) + c * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.
  - destruct (m_law _ _ _ _ _ M t) as (fx & fy & [B P] & X & Y); [ lra | ]. destruct (S t) as [N A]; [ lra | ].
    eexists. split. rd. trivial. set (n := nrm (vx t) (vy t)) in *. assert (0 < n) by (pose proof (nrm_pos (vx t) (vy t)); unfold n in *; lra).
    assert (Q : Ax t ^ 2 + Ay t ^ 2 <= (k - c) ^ 2) by (rewrite <- nrm_sq; apply pow_incr; pose proof (nrm_pos (Ax t) (Ay t)); lra).
    assert (kc : 0 <= k - c) by (pose proof (nrm_pos (Ax t) (Ay t)); lra). pose proof (power_bound _ _ _ (vx t) (vy t) kc Q) as R. fold n in R.
    assert ((vx t * (fx - Ax t) + vy t * (fy - Ay t)) / n <= - c); [ apply Rle_div_l; lra | lra ].
Qed.

Section Two.
Variables (k : R) (a W vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis HV : motion k a (fun _ => 0) vx vy.
Definition gap t := (vx t - W t) ^ 2 + vy t ^ 2.
Lemma gap_falls s t : 0 <= s <= t -> gap t <= gap s.
Proof.
  intros H. unfold gap. pose proof (contraction k a (fun _ => 0) vx vy W (fun _ => 0) hk HV HW s t H) as K. cbv beta in K. rewrite !Rminus_0_r in K. exact K.
Qed.
(* while the straight motion goes to the side s and the other does not, the gap falls *)
Lemma gap_loss s n p q : s = 1 \/ s = -1 -> 0 <= p <= q -> (forall y, p <= y < q -> 0 < s * W y /\ n <= nrm (vx y) (vy y) - s * vx y) ->
  gap q + 2 * k * n * (q - p) <= gap p.
Proof.
  intros hs H S. enough (gap q + 2 * k * n * q <= gap p + 2 * k * n * p) by lra. unfold gap.
  apply (rder_decr (fun t => (vx t - W t) ^ 2 + vy t ^ 2 + 2 * k * n * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply (m_cx _ _ _ _ _ HV) | apply (m_cx _ _ _ _ _ HW) | apply (m_cy _ _ _ _ _ HV) ]; lra.
  - destruct (m_law _ _ _ _ _ HV t) as (fx & fy & [C1 C2] & X & Y); [ lra | ]. destruct (m_law _ _ _ _ _ HW t) as (F & G & C & Z & _); [ lra | ].
    destruct (coulomb_slip _ _ _ _ _ hk C) as [E _]. destruct (S t Ht) as [s1 s2].
    assert (e : nrm (W t) 0 = s * W t) by (rewrite nrm_x; destruct hs as [-> | ->]; [ rewrite Rabs_pos_eq | rewrite Rabs_left ]; lra).
    assert (eF : F = - k * s) by (rewrite e in E; destruct hs as [-> | ->]; nra). subst F.
    assert (hf : - k <= fx <= k) by nra. assert (b : - (fx * W t) <= k * (s * W t)) by (destruct hs as [-> | ->]; nra).
    eexists. split. rd. set (v := nrm (vx t) (vy t)) in *. set (w := s * W t) in *. assert (ss : s * s = 1) by (destruct hs as [-> | ->]; ring).
    assert (k * n <= k * (v - s * vx t)) by (apply Rmult_le_compat_l; trivial).
    match goal with |- ?g <= 0 => replace g with (2 * ((fx * vx t + fy * vy t) - fx * W t + k * s * vx t - k * w + k * n)) by (unfold w; simpl; ring) end.
    rewrite C2. lra.
Qed.
End Two.
Lemma lipschitz k B a vx vy x y : 0 <= k -> (forall t, Rabs (a t) <= B) -> motion k a (fun _ => 0) vx vy -> 0 <= x <= y -> vx y - vx x <= (B + k) * (y - x).
Proof.
  intros hk hB M H. enough (vx y - (B + k) * y <= vx x - (B + k) * x) by lra.
  apply (rder_decr (fun t => vx t - (B + k) * t)); [ lra | | ]; intros t Ht.
  - cont. apply (m_cx _ _ _ _ _ M). lra.
  - destruct (m_law _ _ _ _ _ M t) as (fx & fy & [C1 C2] & X & Y); [ lra | ]. specialize (hB t). apply Rabs_le_between in hB. assert (fx <= k) by nra.
    eexists. split. rd. lra.
Qed.

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
  intros HV. assert (hk' : 0 <= k) by lra. set (D := gap W vx vy). pose proof (gap_falls k a W vx vy hk' HW HV) as C. fold D in C.
  enough (S : forall e, 0 < e -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> D t <= e ^ 2).
  { split; apply lim_zero; intros e he; destruct (S e he) as (t1 & _ & h); exists t1; intros t Ht; specialize (h t Ht); unfold D, gap in h;
      pose proof (pow2_ge_0 (vx t - W t)); pose proof (pow2_ge_0 (vy t)); rewrite <- (Rabs_pos_eq e) by lra; apply Rsqr_le_abs_0; rewrite !Rsqr_pow2; lra. }
  intros e he. set (L := B + k). assert (Lp : 0 < L) by (unfold L; pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra).
  assert (e0 : 0 < e / (8 * L)) by (apply Rdiv_lt_0_compat; lra). set (h := Rmin (d / 2) (e / (8 * L))).
  assert (hh : 0 < h /\ h < d /\ L * h <= e / 8).
  { unfold h. pose proof (Rmin_l (d / 2) (e / (8 * L))). pose proof (Rmin_r (d / 2) (e / (8 * L))). split; [ apply Rmin_pos; lra | split; [ lra | ] ].
    replace (e / 8) with (L * (e / (8 * L))) by (field; lra). apply Rmult_le_compat_l; lra. } clearbody h.
  apply (drain_windows D 0 (z - h) T (2 * h) (2 * k * (e / 4) * (h / 2)) (e ^ 2)); try lra; trivial.
  { repeat apply Rmult_lt_0_compat; lra. }
  { intros t _. unfold D, gap. pose proof (pow2_ge_0 (vx t - W t)). pose proof (pow2_ge_0 (vy t)). lra. }
  intros n y0 Hy0. unfold y0 in *. clear y0. set (x := z + IZR n * T). replace (z - h + IZR n * T) with (x - h) in * by (unfold x; ring).
  replace (x - h + 2 * h) with (x + h) by ring. intros K.
  assert (on : forall y, W (y - IZR n * T) = W y) by (intros; apply shift_Z; trivial).
  assert (Wx : W x = 0) by (rewrite <- on; unfold x; replace (z + IZR n * T - IZR n * T) with z by ring; trivial).
  assert (Wb : forall y, x - h <= y < x -> W y < 0) by (intros y Hy; rewrite <- on; apply before; unfold x in *; lra).
  assert (Wa : forall y, x < y <= x + h -> 0 < W y) by (intros y Hy; rewrite <- on; apply after; unfold x in *; lra). clearbody x.
  assert (Lip : forall f f' p q, motion k a (fun _ => 0) f f' -> x - h <= p <= q -> q <= x + h -> q - p <= h -> f q - f p <= e / 8).
  { intros f f' p q F Hp Hq hpq. pose proof (lipschitz k B a f f' p q hk' hB F ltac:(lra)) as Q. fold L in Q. assert (L * (q - p) <= L * h) by (apply Rmult_le_compat_l; lra). lra. }
  assert (far : forall y, x - h <= y <= x + h -> 3 * e / 4 <= nrm (vx y) (vy y)).
  { intros y Hy. pose proof (C y (x + h) ltac:(lra)) as Q. assert (w : - (e / 8) <= W y <= e / 8).
    { destruct (total_order_T y x) as [[q | ->] | q]; [ | lra | ].
      pose proof (Lip W _ y x HW ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (Wb y ltac:(lra)). lra.
      pose proof (Lip W _ x y HW ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (Wa y ltac:(lra)). lra. }
    unfold D in Q, K. unfold gap in Q at 2. pose proof (nrm_sq (vx y) (vy y)) as N. pose proof (nrm_pos (vx y) (vy y)) as N0. set (v := nrm (vx y) (vy y)) in *.
    assert (vv : - v <= vx y <= v) by nra. apply Rnot_lt_le. intros q. assert (- (vx y * W y) <= v * (e / 8)) by nra. nra. }
  destruct (Rle_lt_dec 0 (vx x)) as [s | s].
  - pose proof (gap_loss k a W vx vy hk' HW HV (-1) (e / 4) (x - h) x ltac:(auto) ltac:(lra)) as P. fold D in P. pose proof (C x (x + h) ltac:(lra)).
    assert (D x + 2 * k * (e / 4) * (x - (x - h)) <= D (x - h)).
    { apply P. intros y Hy. specialize (Wb y ltac:(lra)). split; [ lra | ]. pose proof (Lip vx _ y x HV ltac:(lra) ltac:(lra) ltac:(lra)). specialize (far y ltac:(lra)). lra. }
    assert (0 <= 2 * k * (e / 4) * (h / 2)) by (repeat apply Rmult_le_pos; lra). nra.
  - pose proof (gap_loss k a W vx vy hk' HW HV 1 (e / 4) (x + h / 2) (x + h) ltac:(auto) ltac:(lra)) as P. fold D in P. pose proof (C (x - h) (x + h / 2) ltac:(lra)).
    assert (D (x + h) + 2 * k * (e / 4) * (x + h - (x + h / 2)) <= D (x + h / 2)).
    { apply P. intros y Hy. specialize (Wa y ltac:(lra)). split; [ lra | ]. pose proof (Lip vx _ x y HV ltac:(lra) ltac:(lra) ltac:(lra)). specialize (far y ltac:(lra)). lra. }
    lra.
Qed.
End Plane.

Section Reached.
Variables (k T r s : R) (a W : R -> R).
Hypothesis hk : 0 < k.
Hypothesis hT : 0 < T.
Hypothesis ha : forall t, a (t + T) = a t.
Hypothesis HW : motion k a (fun _ => 0) W (fun _ => 0).
Hypothesis hW : forall t, W (t + T) = W t.
Hypothesis hrs : r < s.
Hypothesis rest : forall t, r <= t <= s -> W t = 0.
Hypothesis spare : Rabs (a r) < k.
Hypothesis ca : continuity_pt a r.
Theorem plane_reached vx vy : motion k a (fun _ => 0) vx vy -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> vx t = W t /\ vy t = 0.
Proof.
  intros HV. assert (hk' : 0 <= k) by lra. set (D t := nrm (vx t - W t) (vy t)). apply Rabs_def2 in spare.
  destruct (spare_lasts a k k r ca ltac:(lra)) as (b' & c & b0 & c0 & near). set (b := Rmin b' (s - r)). assert (bb : 0 < b) by (apply Rmin_pos; lra).
  assert (b1 : b <= b' /\ b <= s - r) by (split; [ apply Rmin_l | apply Rmin_r ]). clearbody b.
  assert (C : forall s t, 0 <= s <= t -> D t <= D s). { intros s0 t Ht. unfold D, nrm. apply sqrt_le_1_alt, (gap_falls k a W vx vy hk' HW HV s0 t Ht). }
  destruct (drain_windows D 0 r T b (c * b) 0) as (t1 & t1a & Ht1); try lra; trivial.
  - apply Rmult_lt_0_compat; lra.
  - intros; apply nrm_pos.
  - intros n x Hx K. assert (on : forall y, x <= y <= x + b -> W y = 0 /\ Rabs (a y) <= k - c).
    { intros y Hy. rewrite <- (shift_Z T W hW n y), <- (shift_Z T a ha n y). split; [ apply rest; unfold x in *; lra | ].
      specialize (near (y - IZR n * T) ltac:(unfold x in *; lra)). apply Rabs_le. lra. } clearbody x.
    assert (De : forall y, x <= y <= x + b -> D y = nrm (vx y) (vy y)) by (intros y Hy; unfold D; destruct (on y Hy) as [-> _]; f_equal; ring).
    rewrite !De in * by lra. enough (nrm (vx (x + b)) (vy (x + b)) + c * (x + b - x) <= nrm (vx x) (vy x)) by lra. apply (speed_falls_2 k a (fun _ => 0)); trivial; [ lra | ].
    intros y Hy. rewrite nrm_x. split; [ | now apply on ]. pose proof (C y (x + b) ltac:(lra)) as Q. rewrite !De in Q by lra. lra.
  - exists t1. split; trivial. intros t Ht. destruct (nrm_zero (vx t - W t) (vy t)); [ | lra ]. specialize (Ht1 t Ht). pose proof (nrm_pos (vx t - W t) (vy t)). unfold D in Ht1. lra.
Qed.
End Reached.

(* (26) with h in place of the sine: a particle in the plane, along x under the drive h, from the phase p of the drive on;
   velocities in units of A0/varpi, l = lambda0. *)
Definition moves (l : R) (h : R -> R) (p : R) (vx vy : R -> R) : Prop := motion l (fun t => - h (p + t)) (fun _ => 0) vx vy.
(* W is the motion at large times under h: it has the drive's period, is a motion, and every motion tends to it. *)
Record late (l : R) (h W : R -> R) : Prop := {
  late_per : forall ph, W (ph + 2 * PI) = W ph;
  late_moves : forall p, moves l h p (fun t => W (p + t)) (fun _ => 0);
  late_drawn : forall p vx vy, moves l h p vx vy -> is_lim (fun t => vx t - W (p + t)) p_infty 0 /\ is_lim vy p_infty 0 }.
(* every motion is equal to W from some time on *)
Definition caught (l : R) (h W : R -> R) : Prop := forall p vx vy, moves l h p vx vy -> exists t1, 0 <= t1 /\ forall t, t1 <= t -> vx t = W (p + t) /\ vy t = 0.

Lemma caught_late l h W : (forall t, W (t + 2 * PI) = W t) -> (forall p, moves l h p (fun t => W (p + t)) (fun _ => 0)) -> caught l h W -> late l h W.
Proof.
  intros P M C. split; trivial. intros p vx vy V. destruct (C p vx vy V) as (t1 & _ & H). 
  split; apply (lim_eventually _ t1); intros t Ht; destruct (H t Ht) as [e1 e2]; rewrite ?e1, ?e2; ring.
Qed.
Lemma late_unique l h W U : late l h W -> late l h U -> forall t, W t = U t.
Proof.
  intros [PW MW _] [PU _ DU] t. destruct (DU 0 _ _ (MW 0)) as [L _]. 
  pose proof (per_zero (fun t => W (0 + t) - U (0 + t)) (2 * PI) ltac:(pose proof PI_RGT_0; lra)) as Z. cbv beta in Z. specialize (Z ltac:(intros s; rewrite <- !Rplus_assoc, PW, PU; ring) L t).
  rewrite Rplus_0_l in Z. lra.
Qed.
(* at large times each period holds an interval of rest; or there is none. v is a velocity, or a speed *)
Definition rests (v : R -> R) : Prop := exists t1, forall t, t1 <= t -> exists s d, t <= s <= t + 2 * PI /\ 0 < d /\ forall u, s <= u <= s + d -> v u = 0.
Definition restless (v : R -> R) : Prop := exists t1, forall s d, t1 <= s -> 0 < d -> exists u, s <= u <= s + d /\ v u <> 0.
(* at rest the right derivative is 0 *)
Lemma rder_rest v s d l : 0 < d -> (forall u, s <= u <= s + d -> v u = 0) -> rder v s l -> l = 0.
Proof.
  intros hd Z R. enough (P : forall f l, rder f s l -> (forall u, s <= u <= s + d -> f u = 0) -> 0 <= l).
  { pose proof (P v l R Z). pose proof (P _ _ (rder_opp _ _ _ R)) as Q. cbv beta in Q. specialize (Q ltac:(intros u Hu; rewrite Z; trivial; ring)). lra. }
  clear Z R. intros f k R Z. apply Rnot_lt_le. intros n. destruct (rder_step f s k R (- k / 2) ltac:(lra)) as (b & b0 & H).
  assert (0 < Rmin b d) by (apply Rmin_pos; trivial). pose proof (Rmin_l b d). pose proof (Rmin_r b d). specialize (H (Rmin b d / 2) ltac:(lra)).
  rewrite !Z in H by lra. nra.
Qed.
