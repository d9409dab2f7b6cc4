(* The velocity across the drive: linear while it is large; faster than every exponential in the end; zero only where the block stops. With the rates
   of ln wy, which is -l/v, and of ln (v + w), which is (sin - l)/v. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Exists Formulas HalfPeriod Drawn Analysis Steady Shaken LargeTime Zeros.
Open Scope R_scope.

(* friction near one axis: n is the speed, x the fast component, y the slow one *)
Lemma nearly x y : 0 < x -> let q := (y / x) ^ 2 in 1 - q / 2 <= x / nrm x y <= 1.
Proof.
  intros hx q. pose proof (nrm_sq x y) as N. pose proof (nrm_pos x y). assert (Q : q * x ^ 2 = y ^ 2) by (unfold q; field; lra).
  assert (q0 : 0 <= q) by apply pow2_ge_0. set (n := nrm x y) in *. assert (a : x <= n) by nra.
  assert (b : n <= x * (1 + q / 2)). { apply Rsqr_incr_0_var; [ rewrite !Rsqr_pow2; nra | nra ]. }
  split; [ apply Rle_div_r | apply Rle_div_l ]; try lra. assert (0 <= q ^ 2 * x) by (apply Rmult_le_pos; [ apply pow2_ge_0 | lra ]).
  destruct (Rle_lt_dec (1 - q / 2) 0); nra.
Qed.
Lemma iterate (G : R -> R) s0 T C : 0 < T -> (forall s, s0 <= s <= s0 + T -> G s <= C) -> (forall s, s0 <= s -> G (s + T) <= G s) ->
  forall s, s0 <= s -> G s <= C.
Proof.
  intros hT A B s hs. destruct (nat_above ((s - s0) / T)) as [n Hn]. apply Rlt_div_l in Hn; trivial. revert s hs Hn.
  induction n as [ | n IH ]; intros s hs hn; [ simpl in hn; lra | rewrite S_INR in hn ]. destruct (Rle_lt_dec s (s0 + T)); [ apply A; lra | ].
  replace s with (s - T + T) by ring. eapply Rle_trans; [ apply B | apply IH ]; lra.
Qed.

Section Across.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 < l.
Hypothesis M : shaken l phi0 w wy.
Notation v t := (nrm (w t) (wy t)).
Notation Q t := (ln (wy t ^ 2)).
Lemma wy_falls s t : 0 <= s <= t -> wy t ^ 2 <= wy s ^ 2.
Proof. pose proof M as H. rewrite shaken_sin in H. apply (across_falls _ _ _ _ (Rlt_le _ _ hl) H). Qed.
Lemma wy_before s t : 0 <= s <= t -> wy t <> 0 -> wy s <> 0.
Proof. intros hs n z. pose proof (wy_falls s t hs) as F. rewrite z in F. apply n. nra. Qed.
(* while it moves across: the rates of wy^2 and of v + e w *)
Lemma moving t : 0 <= t -> wy t <> 0 -> 0 < wy t ^ 2 /\ Rabs (w t) < v t /\ rder (fun s => wy s ^ 2) t (- (2 * l / v t) * wy t ^ 2) /\
  forall e, e = 1 \/ e = -1 -> 0 < v t + e * w t /\ rder (fun s => v s + e * w s) t ((e * sin (phi0 + t) - l) / v t * (v t + e * w t)).
Proof.
  intros ht n. assert (y2 : 0 < wy t ^ 2) by (pose proof (pow2_ge_0 (wy t)); nra). pose proof (nrm_sq (w t) (wy t)) as n2.
  pose proof (nrm_pos (w t) (wy t)) as n0. pose proof (Rabs_pos (w t)).
  assert (n1 : Rabs (w t) < v t) by (rewrite <- (pow2_abs (w t)) in n2; nra).
  destruct (law l phi0 w wy (Rlt_le _ _ hl) M t ht) as (fx & fy & [_ P] & [E F] & _ & X & Y). set (m := v t) in *.
  split; [ trivial | split; [ trivial | split ] ].
  - eapply rder_eq. rd. assert (e : fy = - l * wy t / m) by (rewrite <- F; field; lra). rewrite e. simpl. field. lra.
  - intros e he. split; [ pose proof (Rabs_def2 _ _ n1); destruct he as [-> | ->]; lra | ].
    eapply rder_eq; [ apply (rder_plus (fun s => v s) (fun s => e * w s)); [ apply (rder_nrm w wy t _ _ X Y); fold m; lra | rd ] | fold m ].
    replace (w t * (sin (phi0 + t) + fx) + wy t * fy) with (w t * sin (phi0 + t) - l * m) by lra.
    assert (ef : fx = - l * w t / m) by (rewrite <- E; field; lra). rewrite ef. destruct he as [-> | ->]; field; lra.
Qed.
Lemma rder_log f t r : rder f t (r * f t) -> 0 < f t -> rder (fun s => ln (f s)) t r.
Proof. intros D P. eapply rder_eq; [ exact (rder_ln f t _ D P) | field; lra ]. Qed.
(* from s on, for a unit of phase, the speed is 2 (phase since s + e) at most: then wy^2 is multiplied by e^l at most *)
Lemma shrinks s e : 0 <= s -> 0 < e -> (forall t, s <= t <= s + 1 -> v t <= 2 * (t - s + e)) -> wy (s + 1) ^ 2 <= wy s ^ 2 * exp (l * ln e).
Proof.
  intros hs he H. pose proof (exp_pos (l * ln e)). destruct (Req_dec (wy (s + 1)) 0) as [-> | n]; [ pose proof (pow2_ge_0 (wy s)); nra | ].
  assert (A : forall t, s <= t <= s + 1 -> wy t <> 0) by (intros t Ht; apply (wy_before t (s + 1)); trivial; lra).
  assert (F : Q (s + 1) + l * ln (s + 1 - s + e) <= Q s + l * ln (s - s + e)).
  { apply (rder_decr (fun t => Q t + l * ln (t - s + e))); [ lra | | ]; intros t Ht; destruct (moving t ltac:(lra) ltac:(apply A;
    lra)) as (y2 & n1 & D & _).
    - conts M.
    - specialize (H t ltac:(lra)). pose proof (Rabs_pos (w t)). pose proof (rder_log _ t _ D y2). eexists. split. rds. lra. cbv beta.
      assert (/ (2 * (t - s + e)) <= / v t) by (apply Rinv_le_contravar; lra). rewrite Rinv_mult in *. unfold Rdiv. nra. }
  replace (s + 1 - s + e) with (1 + e) in F by ring. replace (s - s + e) with e in F by ring.
  destruct (moving s hs ltac:(apply A; lra)) as (y1 & _). destruct (moving (s + 1) ltac:(lra) n) as (y2 & _).
  assert (0 < ln (1 + e)) by (rewrite <- ln_1; apply ln_increasing; lra).
  rewrite <- (exp_ln (wy (s + 1) ^ 2)), <- (exp_ln (wy s ^ 2)), <- exp_plus by trivial.
  left. apply exp_increasing. nra.
Qed.

(* faster than every exponential *)
Lemma late_shrinks k : l <= eq37_lambda_c -> exists s0, 0 <= s0 /\ forall s, s0 <= s -> wy (s + 4 * PI) ^ 2 <= wy s ^ 2 * exp (- k).
Proof.
  intros hc. set (e := exp (- k / l)). assert (he : 0 < e) by apply exp_pos. assert (le : l * ln e = - k) by (unfold e; rewrite ln_exp; field; lra).
  destruct (near_38 l (conj hl hc) phi0 w wy (e / 2) M ltac:(lra)) as (s1 & s0 & H). pose proof PI2_3_2. pose proof lambda_c_between.
  exists s1. split; trivial. intros s hs. destruct (phase_after phi0 (eq39_phi_t1 l) s) as (z & hz & n & ph).
  apply Rle_trans with (wy (z + 1) ^ 2); [ apply wy_falls; lra | ]. rewrite <- le. apply Rle_trans with (wy z ^ 2 * exp (l * ln e)).
  2: { apply Rmult_le_compat_r; [ left; apply exp_pos | apply wy_falls; lra ]. }
  apply shrinks; [ lra | trivial | ]. intros t Ht. destruct (H t ltac:(lra)) as [X Y]. apply Rabs_def2 in X.
  pose proof (gain l phi0 _ _ (Rlt_le _ _ hl) (w38_motion l (conj hl hc) phi0) z t ltac:(lra)) as G. cbv beta in G.
  replace (w38 l (phi0 + z)) with 0 in G by (rewrite ph, (whole_periods (w38 l)) by (intros; now apply w38_period); rewrite <- (w38_turn l 0);
  f_equal; ring).
  pose proof (cos_near (phi0 + z) (phi0 + t)) as C. replace (phi0 + z - (phi0 + t)) with (- (t - z)) in C by ring.
  rewrite Rabs_Ropp, (Rabs_pos_eq (t - z)) in C by lra. apply Rabs_le_between in C.
  assert (l * (t - z) <= 1 * (t - z)) by (apply Rmult_le_compat_r; lra). eapply Rle_trans; [ apply nrm_abs | ].
  assert (Rabs (w t) <= 2 * (t - z) + e / 2) by (apply Rabs_le; lra). lra.
Qed.
Lemma superexponential k : l <= eq37_lambda_c -> is_lim (fun s => wy s * exp (k * s)) p_infty 0.
Proof.
  intros hc. pose proof PI_RGT_0. set (K := Rabs k + 1). assert (hK : 0 < K /\ k + 1 <= K) by (unfold K; pose proof (Rabs_pos k);
  pose proof (Rle_abs k); lra).
  destruct (late_shrinks (2 * K * (4 * PI)) hc) as (s0 & h0 & S). assert (m : forall a b, a <= b -> exp a <= exp b).
  { intros a b [ab | ->]; [ left; now apply exp_increasing | lra ]. } set (C := wy 0 ^ 2 * exp (2 * K * (s0 + 4 * PI))).
  assert (first : forall s, 0 <= s <= s0 + 4 * PI -> wy s ^ 2 * exp (2 * K * s) <= C).
  { intros s hs. apply Rmult_le_compat; [ apply pow2_ge_0 | left; apply exp_pos | apply wy_falls; lra | apply m; nra ]. }
  assert (G : forall s, 0 <= s -> wy s ^ 2 * exp (2 * K * s) <= C).
  { intros s hs. destruct (Rle_lt_dec s s0); [ apply first; lra | ].
    apply (iterate (fun s => wy s ^ 2 * exp (2 * K * s)) s0 (4 * PI)); [ lra | intros u hu; apply first; lra | | lra ]. intros u hu.
    specialize (S u hu).
    replace (2 * K * (u + 4 * PI)) with (2 * K * (4 * PI) + 2 * K * u) by ring. rewrite exp_plus, <- Rmult_assoc. rewrite exp_Ropp in S.
    apply Rmult_le_compat_r; [ left; apply exp_pos | ]. set (E := exp (2 * K * (4 * PI))) in *. assert (0 < E) by apply exp_pos.
    apply (Rmult_le_compat_r E) in S; [ | lra ]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in S by lra. exact S. }
  apply (lim_of_bound _ C (fun s => exp (2 * s))).
  - unfold C. apply Rmult_le_pos; [ apply pow2_ge_0 | left; apply exp_pos ].
  - intros s hs. eapply Rle_trans; [ | apply (G s hs) ]. replace ((wy s * exp (k * s)) ^ 2) with (wy s ^ 2 * (exp (k * s) * exp (k * s))) by ring.
    rewrite Rmult_assoc, <- !exp_plus. apply Rmult_le_compat_l; [ apply pow2_ge_0 | apply m; nra ].
  - intros B. apply grows_exp. lra.
Qed.

(* where wy becomes zero first the block stops *)
Lemma first_zero s u : 0 <= s < u -> wy s <> 0 -> wy u = 0 -> exists z, s < z <= u /\ wy z = 0 /\ w z = 0 /\ forall t, s <= t < z -> wy t <> 0.
Proof.
  intros hs ns zu. apply Classical_Prop.NNPP. intros no. apply (real_ind (fun t => wy t <> 0) s u ns) with (t := u); trivial; [ | | lra ].
  - intros z hz before yz. apply no. exists z. split; [ lra | split; [ trivial | split; [ | trivial ] ] ].
    destruct (Req_dec (w z) 0) as [ | nw]; trivial. exfalso. apply Rabs_pos_lt in nw. set (m := Rabs (w z) / 2).
    destruct (cont_eps w z m (m_cx _ _ _ _ _ M z ltac:(lra)) ltac:(unfold m; lra)) as (r & r0 & R). set (c := Rmax s (z - r / 2)).
    assert (hc : s <= c < z /\ z - r < c) by (unfold c; minmax).
    assert (F : - (wy z ^ 2 * exp (2 * l / m * z)) <= - (wy c ^ 2 * exp (2 * l / m * c))).
    { apply (rder_decr (fun t => - (wy t ^ 2 * exp (2 * l / m * t)))); [ lra | | ]; intros x Hx; [ conts M | ].
      destruct (moving x ltac:(lra) ltac:(apply before; lra)) as (x2 & n1 & D & _). eexists. split.
      apply rder_opp, (rder_mult (fun t => wy t ^ 2)); [ exact D | rd ]. cbv beta.
      specialize (R x ltac:(apply Rabs_def1; lra)). pose proof (Rabs_triang_inv (w z) (w x)). rewrite Rabs_minus_sym in R.
      assert (m <= v x) by (unfold m in *; lra). assert (/ v x <= / m) by (apply Rinv_le_contravar; unfold m in *; lra).
      pose proof (exp_pos (2 * l / m * x)).
      set (q := wy x ^ 2) in *. clearbody q. set (E := exp (2 * l / m * x)) in *.
      assert (0 <= l * q * E * (/ m - / v x)) by (repeat apply Rmult_le_pos; lra).
      match goal with |- ?g <= 0 => replace g with (- (2 * (l * q * E * (/ m - / v x)))) by (unfold Rdiv; ring) end. lra. }
    rewrite yz in F. destruct (moving c ltac:(lra) ltac:(apply before; lra)) as (y2 & _). pose proof (exp_pos (2 * l / m * c)). nra.
  - intros t ht before. destruct (moving t ltac:(lra) ltac:(apply before; lra)) as (y2 & _ & D & _). destruct (right_pos _ _ _ D y2) as (d & d0 & K).
    exists d. split; trivial. intros x hx z. specialize (K x hx). cbv beta in K. rewrite z in K. lra.
Qed.

(* ---- below lambda_c ---- *)
Hypothesis hc : l < eq37_lambda_c.
Lemma d_l : l < sin (eq39_phi_t1 l). Proof. destruct (turn_sign l) as (c & c0 & T); [ lra | pose proof (small l); lra | nra ]. Qed.
Lemma late_speed : exists V s1, 0 <= s1 /\ forall s, s1 <= s -> v s <= V.
Proof.
  destruct (z_1 l (conj hl hc)) as [_ z2]. destruct (near_38 l z2 phi0 w wy 1 M Rlt_0_1) as (s1 & s0 & H). exists (w38 l (PI - asin l) + 2), s1.
  split; trivial. intros s hs. destruct (H s hs) as [X Y]. pose proof (w38_most l z2 (phi0 + s)).
  pose proof (Rabs_triang_inv (w s) (w38 l (phi0 + s))).
  eapply Rle_trans; [ apply nrm_abs | lra ].
Qed.
End Across.

(* There are such motions: from a small velocity across at a zero of (38) on, the block could stop only where (38) is nearly zero, and there the drive
   beats friction, so that v + w, or v - w, grows. *)
Lemma never_zero l : 0 < l < eq37_lambda_c -> exists w wy, shaken l (eq39_phi_t1 l) w wy /\ forall s, 0 <= s -> wy s <> 0.
Proof.
  intros hl. destruct (z_1 l hl) as [h1 hp]. pose proof PI_RGT_0. destruct (room l hl) as (ra & rb). set (p := eq39_phi_t1 l) in *.
  set (d := (p - asin l) / 2). destruct (continuity_ab_min (g38 l p) d (PI - d)) as (x & X & hx); [ unfold d; lra | | ].
  { intros c _. exact (cont_of _ _ _ (g_der l p c)). }
  assert (m0 : 0 < g38 l p x) by (apply (g_pos l h1 (proj2 hp)); unfold d in *; lra). set (e := g38 l p x / 2).
  destruct (plane_has_a_motion l (fun s => - sin (p + s)) (fun _ => 0) 0 e ltac:(lra)) as (w & wy & M & w0 & y0).
  { intros t _. split; [ apply drive_cont | cont ]. }
  rewrite <- shaken_sin in M. exists w, wy. split; trivial. intros u hu yu. assert (e0 : 0 < e) by (unfold e; lra).
  assert (u <> 0) by (intros ->; lra). destruct (first_zero l p w wy (proj1 hl) M 0 u ltac:(lra) ltac:(lra) yu) as (z & hz & yz & wz & before).
  (* so (38) is nearly zero there *)
  pose proof (w38_motion l hp p) as W. pose proof M as M'. rewrite shaken_sin in W, M'.
  pose proof (contraction l _ _ w wy _ _ ltac:(lra) M' W 0 z ltac:(lra)) as G. cbv beta in G. rewrite wz, yz, w0, y0, Rplus_0_r in G.
  replace (w38 l p) with 0 in G by (rewrite <- (w38_turn l 0); f_equal; unfold p; ring).
  destruct (per_spec (p - d) PI ltac:(lra) (p + z)) as [j Hj]. set (a := p + z - p - IZR j * PI).
  assert (near : - d <= a <= d).
  { split; [ unfold a; lra | ]. apply Rnot_lt_le. intros q. assert (K : g38 l p x <= g38 l p a) by (apply X; unfold a in *; lra).
    rewrite (w38_on l j) in G by (unfold a, d, p in *; lra). fold p in G. fold a in G.
    assert (e < g38 l p a) by (unfold e in *; lra). destruct (sg_cases j) as [Ej | Ej]; rewrite Ej in G; nra. }
  set (g := sg j). assert (gg : g = 1 \/ g = -1) by apply sg_cases. set (b := Rmax 0 (z - d)).
  assert (hb : 0 <= b < z /\ z - d <= b) by (unfold b, d; minmax). destruct (moving l p w wy (proj1 hl) M b ltac:(lra) ltac:(apply before;
  lra)) as (_ & _ & _ & Mb).
  destruct (Mb g gg) as [pb _].
  assert (F : - (nrm (w z) (wy z) + g * w z) <= - (nrm (w b) (wy b) + g * w b)); [ | rewrite wz, yz, nrm_0 in F; lra ].
  apply (rder_decr (fun s => - (nrm (w s) (wy s) + g * w s))); [ lra | | ]; intros s hs; [ conts M | ].
  destruct (moving l p w wy (proj1 hl) M s ltac:(lra) ltac:(apply before; lra)) as (_ & n1 & _ & E); destruct (E g gg) as [q D].
  - eexists. split; [ apply rder_opp, D | ].
    assert (S : l <= g * sin (p + s)).
    { unfold g. rewrite (drive_at j (p + s) (p + a + (s - z))) by (unfold a; ring). destruct (asin_range l h1) as [_ es].
      destruct (Req_dec (p + a + (s - z)) (asin l)) as [-> | ]; [ rewrite es; lra | left; apply sin_above; trivial; unfold d in *; lra ]. }
    pose proof (Rabs_pos (w s)). assert (0 <= (g * sin (p + s) - l) / nrm (w s) (wy s) * (nrm (w s) (wy s) + g * w s)); [ | lra ].
    repeat apply Rmult_le_pos; try lra. left; apply Rinv_0_lt_compat; lra.
Qed.
