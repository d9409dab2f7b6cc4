(* Section 2.2: a block on a plane that is shaken along a line, by (21). `block` is a motion in the paper's units, `shaken` one in those of (22) to
   (24), from any velocity and at any phase of the drive at the start; `w33` and `w38` are (33) and (38) continued, `slip_end` is (32). *)
Require Import Reals Lra Psatz ZArith List.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion General Exists Formulas HalfPeriod Drawn Analysis Steady Shaken LargeTime AcrossStop Zeros Across
  Sequences Stages.
Open Scope R_scope.

(* ---- drive and friction: (25) to (30) ---- *)
Lemma units_pos mu g A0 : 0 < A0 -> 0 <= mu * g -> 0 <= eq22_lambda0 mu g A0.
Proof. intros hA h0. apply Rmult_le_pos; [ trivial | left; now apply Rinv_0_lt_compat ]. Qed.
Lemma drive_size A0 varpi t : nrm (eq21_acceleration_1 A0 varpi t) (eq21_acceleration_2 A0 varpi t) = Rabs A0 * Rabs (sin (varpi * t)).
Proof. unfold eq21_acceleration_1, eq21_acceleration_2. now rewrite nrm_x, Rabs_mult, Rabs_Ropp. Qed.
(* (25) says that A0 exceeds mu g; exactly then the acceleration exceeds what friction can hold, at some time, and a block cannot rest for ever. *)
Theorem eq_25 mu g A0 varpi t0 : 0 < A0 -> 0 < varpi -> let lam := eq22_lambda0 mu g A0 in
  (eq25_sides_1 lam < eq25_sides_2 lam <-> mu * g < A0) /\
  (eq25_sides_1 lam < eq25_sides_2 lam <-> exists t, mu * g < nrm (eq21_acceleration_1 A0 varpi t) (eq21_acceleration_2 A0 varpi t)) /\
  (0 <= mu * g -> (eq25_sides_1 lam < eq25_sides_2 lam <-> ~ block mu g A0 varpi t0 (fun _ => 0) (fun _ => 0))).
Proof.
  intros hA hv lam. unfold eq25_sides_1, eq25_sides_2. assert (e1 : lam < 1 <-> mu * g < A0) by (symmetry; apply Rdiv_lt_1; trivial).
  rewrite e1. split; [ tauto | split ].
  - split.
    + intros H. exists (PI / 2 / varpi). rewrite drive_size. replace (varpi * (PI / 2 / varpi)) with (PI / 2) by (field; lra).
      rewrite sin_PI2, Rabs_R1, Rabs_pos_eq; lra.
    + intros [t H]. rewrite drive_size, Rabs_pos_eq in H by lra. pose proof (sin_1 (varpi * t)). nra.
  - intros h0. split.
    + intros H B. destruct (phase_after (varpi * t0) (PI / 2) 0) as (s & hs & ph). apply (block_units mu g A0 varpi t0 _ _ hA hv) in B.
      pose proof (rest_needs_friction lam _ _ _ (units_pos _ _ _ hA h0) B 0 (s + 1) s ltac:(lra) ltac:(lra)) as Q.
      destruct (at_sin _ _ _ 0 ph) as [E _]. rewrite !Rplus_0_r, sin_PI2 in E. unfold eq23_phase in Q. rewrite E, Rabs_R1 in Q.
      enough (1 <= lam) by (apply e1 in H; lra). apply Q. intros t _. unfold eq24_w. field. lra.
    + intros H. apply Rnot_le_lt. intros k. apply H, (block_units mu g A0 varpi t0 _ _ hA hv).
      eapply motion_eq; [ apply (at_rest lam (eq23_phase varpi t0)) | .. ]; trivial; [ apply Rle_div_r; lra | .. ]; intros; unfold eq24_w; field; lra.
Qed.

(* In the units (22) to (24) every block obeys one law, whose constants are lambda0 and the phase at the start. *)
Theorem eq_26__units mu g A0 varpi t0 vx vy : 0 < A0 -> 0 < varpi ->
  (block mu g A0 varpi t0 vx vy <->
   shaken (eq22_lambda0 mu g A0) (eq23_phase varpi t0) (fun s => eq24_w varpi (vx (s / varpi)) A0) (fun s => eq24_w varpi (vy (s / varpi)) A0)).
Proof. apply block_units. Qed.
(* (26): the rate of w by the phase, whenever vy has vanished and vx has not. *)
Theorem eq_26 mu g A0 varpi t0 vx vy t : 0 < A0 -> 0 < varpi -> 0 <= mu * g -> block mu g A0 varpi t0 vx vy -> 0 <= t -> vx t <> 0 -> vy t = 0 ->
  rder (fun s => eq24_w varpi (vx (s / varpi)) A0) (eq23_phase varpi t)
    (eq26_rate (eq22_lambda0 mu g A0) (eq23_phase varpi (t0 + t)) (eq24_w varpi (vx t) A0)).
Proof.
  intros hA hv h0 B ht hx hy. apply (block_units mu g A0 varpi t0 _ _ hA hv) in B. pose proof (units_pos _ _ _ hA h0) as l0.
  set (l := eq22_lambda0 mu g A0) in *.
  destruct (law l _ _ _ l0 B (eq23_phase varpi t)) as (fx & fy & _ & [E _] & _ & X & _); [ unfold eq23_phase; nra | ].
  assert (e : eq23_phase varpi t / varpi = t) by (unfold eq23_phase; field; lra). rewrite !e, hy in E. set (w := eq24_w varpi (vx t) A0) in *.
  replace (eq24_w varpi 0 A0) with 0 in E by (unfold eq24_w; field; lra). rewrite nrm_x in E.
  assert (w0 : w <> 0) by (unfold w, eq24_w, Rdiv; repeat apply Rmult_integral_contrapositive_currified; trivial; try apply Rinv_neq_0_compat; lra).
  pose proof (Rabs_pos_lt _ w0). unfold eq26_rate. rewrite <- (pow2_abs w), sqrt_pow2 by apply Rabs_pos.
  eapply rder_eq; [ exact X | ]. unfold eq23_phase in *. rewrite Rmult_plus_distr_l. unfold Rminus. f_equal.
  apply (Rmult_eq_reg_l (Rabs w)); [ rewrite E; field; lra | lra ].
Qed.

Section FourPoints.
Variable lam : R.
Hypothesis hl : 0 <= lam <= 1.
(* The drive equals friction once in each quarter of a period, at (27), (28), (29), (30). *)
Theorem eq_27 phi : 0 <= phi <= PI / 2 -> (Rabs (sin phi) = lam <-> phi = eq27_phi1 lam).
Proof.
  intros H. rewrite Rabs_pos_eq by (apply sin_ge_0; lra). split; [ intros <- | intros -> ]; unfold eq27_phi1;
  [ rewrite asin_sin | rewrite sin_asin ]; lra.
Qed.
Theorem eq_28 phi : PI / 2 <= phi <= PI -> (Rabs (sin phi) = lam <-> phi = eq28_phi2 lam).
Proof. intros H. rewrite <- sin_PI_x, eq_27 by lra. unfold eq28_phi2, eq27_phi1. split; intros; lra. Qed.
Theorem eq_29 phi : PI <= phi <= 3 * (PI / 2) -> (Rabs (sin phi) = lam <-> phi = eq29_phi3 lam).
Proof. intros H. rewrite <- sin_PI_x, <- Rabs_Ropp, <- sin_neg, eq_27 by lra. unfold eq29_phi3, eq27_phi1. split; intros; lra. Qed.
Theorem eq_30 phi : 3 * (PI / 2) <= phi <= 2 * PI -> (Rabs (sin phi) = lam <-> phi = eq30_phi4 lam).
Proof. intros H. replace (sin phi) with (- sin (2 * PI - phi)) by (rewrite sin_2PI_minus; ring). rewrite Rabs_Ropp, eq_27 by lra.
unfold eq30_phi4, eq27_phi1. split; intros; lra. Qed.
End FourPoints.
(* They are four, all of a period; at lambda0 = 0 there would be two. *)
Theorem s22_four_points lam : 0 < lam < 1 -> let points := eq27_phi1 lam :: eq28_phi2 lam :: eq29_phi3 lam :: eq30_phi4 lam :: nil in
  NoDup points /\ INR (length points) = s22_points /\ forall phi, 0 <= phi < 2 * PI -> (Rabs (sin phi) = lam <-> In phi points).
Proof.
  intros hl points. destruct (asin_range lam hl) as [[a c] _]. unfold points. split; [ | split ].
  - unfold eq27_phi1, eq28_phi2, eq29_phi3, eq30_phi4. repeat constructor; simpl; intuition lra.
  - unfold s22_points. simpl. ring.
  - intros phi H. assert (h : 0 <= lam <= 1) by lra. simpl. split.
    + intros E. destruct (Rle_lt_dec phi (PI / 2)); [ left; symmetry; apply eq_27; trivial; lra | right ].
      destruct (Rle_lt_dec phi PI); [ left; symmetry; apply eq_28; trivial; lra | right ].
      destruct (Rle_lt_dec phi (3 * (PI / 2))); [ left; symmetry; apply eq_29 | right; left; symmetry; apply eq_30 ]; trivial; lra.
    + intros [<- | [<- | [<- | [<- | []]]]]; [ apply (eq_27 lam h) | apply (eq_28 lam h) | apply (eq_29 lam h) | apply (eq_30 lam h) ];
      unfold eq27_phi1, eq28_phi2, eq29_phi3, eq30_phi4; trivial; lra.
Qed.
Theorem s22_four_points__needs_friction : let p := 0 in eq27_phi1 p = 0 /\ eq28_phi2 p = PI /\ eq29_phi3 p = PI /\ eq30_phi4 p = 2 * PI.
Proof. cbv zeta. unfold eq27_phi1, eq28_phi2, eq29_phi3, eq30_phi4. rewrite asin_0. repeat split; ring. Qed.

(* ---- rests, and the slip after one: (31), (32) ---- *)
Lemma sine_vanishes x y : 0 < y - x < PI -> sin x = 0 -> sin y = 0 -> False.
Proof. intros H X Y. pose proof (sin_gt_0 (y - x) ltac:(lra) ltac:(lra)) as S. rewrite sin_minus, X, Y in S. lra. Qed.
(* A rest that ends does so at phi1 or phi3: at s the velocity, zero on [r, s], ceases to be zero. *)
Theorem s22_rest_ends lam phi0 w wy r s : 0 <= lam -> shaken lam phi0 w wy -> 0 <= r < s -> (forall t, r <= t <= s -> w t = 0 /\ wy t = 0) ->
  (forall d, 0 < d -> exists t, s < t < s + d /\ (w t <> 0 \/ wy t <> 0)) -> at_phase phi0 s (eq27_phi1 lam) \/ at_phase phi0 s (eq29_phi3 lam).
Proof.
  intros hl M H rest ends.
  assert (held : forall d, 0 < d -> ~ forall t, s <= t < s + d -> Rabs (sin (phi0 + t)) <= lam).
  { intros d d0 D. destruct (ends d d0) as (t & Ht & K). destruct (rest s ltac:(lra)).
    destruct (stays lam phi0 w wy hl M s t); trivial; [ lra | intros; apply D; lra | tauto ]. }
  destruct (Rle_lt_dec 1 lam) as [k | k]. { exfalso. apply (held 1 Rlt_0_1). intros t _. pose proof (sin_1 (phi0 + t)). lra. }
  assert (before : forall t, r <= t < s -> Rabs (sin (phi0 + t)) <= lam) by (intros t Ht; apply (rest_needs_friction lam phi0 w wy hl M r s);
  try lra; intros; apply rest; lra).
  pose proof PI2_3_2. destruct hl as [h0 | <-].
  2: { exfalso. set (y := Rmax r (s - 1)). assert (hy : r <= y < s /\ s - 1 <= y) by (unfold y; minmax).
       assert (Z : forall t, r <= t < s -> sin (phi0 + t) = 0) by (intros t Ht; specialize (before t Ht); apply Rabs_le_between in before; lra).
       apply (sine_vanishes (phi0 + y) (phi0 + (y + s) / 2)); [ | apply Z | apply Z ]; lra. }
  assert (hl : 0 < lam < 1) by lra. destruct (asin_range lam hl) as [[a b] _]. destruct (phase_in (asin lam) phi0 s) as (x & hx & ph).
  assert (X : forall u, sin (phi0 + (s + u)) = sin (x + u)) by (intros u; apply (at_sin phi0 s x u ph)).
  (* where the drive is the stronger there was no rest; where it is not, none ends *)
  assert (no : forall y, asin lam < y < PI + asin lam -> ~ forall u, Rabs (sin (phi0 + (s + u))) = Rabs (sin (y + u))).
  { intros y hy Y. destruct (Rle_lt_dec y (PI - asin lam)) as [q | q].
    - set (u := Rmax (r - s) ((asin lam - y) / 2)). assert (hu : r <= s + u < s /\ asin lam < y + u < y) by (unfold u; minmax).
      specialize (before _ (proj1 hu)). rewrite Y in before. pose proof (sin_above lam (y + u) hl ltac:(lra)). pose proof (Rle_abs (sin (y + u))).
      lra.
    - apply (held (PI + asin lam - y)); [ lra | ]. intros t Ht. replace t with (s + (t - s)) by ring. rewrite Y. apply sin_below; lra. }
  unfold eq27_phi1, eq29_phi3. destruct (Req_dec x (asin lam)) as [-> | x1]; [ now auto | ].
  destruct (Req_dec x (PI + asin lam)) as [-> | x2]; [ now auto | exfalso ].
  destruct (Rlt_le_dec x (PI + asin lam)); [ apply (no x) | apply (no (x - PI)) ]; try lra; intros u; rewrite X; trivial.
  rewrite <- (Rabs_Ropp (sin (x - PI + u))), <- neg_sin. do 2 f_equal. ring.
Qed.

(* (31): a block that is at rest when the drive is at phi1 moves by (31), forward, until phitilde2, where it stops, if for a moment only. *)
Theorem eq_31 lam e phi0 w wy c phi : 0 <= lam < 1 -> slip_end lam e -> shaken lam phi0 w wy -> 0 <= c -> at_phase phi0 c (eq27_phi1 lam) ->
  w c = 0 -> wy c = 0 -> eq27_phi1 lam <= phi <= e -> let s := c + (phi - eq27_phi1 lam) in
  w s = eq31_w lam (eq27_phi1 lam) phi /\ wy s = 0 /\ (eq27_phi1 lam < phi < e -> 0 < w s).
Proof.
  intros hl E M hc ph w0 wy0 hphi s.
  assert (P : forall t, 0 < t < e - asin lam -> 0 < h lam t).
  { destruct hl as [[h0 | <-] h1]; [ apply (slip_end_is lam e ltac:(lra) E) | ]. destruct E as (E1 & _ & E3). intros t Ht.
    specialize (E3 (asin 0 + t) ltac:(unfold eq27_phi1 in *; lra)).
    rewrite left_h in E3. replace (asin 0 + t - asin 0) with t in E3 by ring. unfold h in *. rewrite asin_0, Rplus_0_l, cos_0 in *.
    pose proof (COS_bound t). lra. }
  unfold s, eq27_phi1 in *. destruct (slip_is lam phi0 w wy (proj1 hl) M c (phi - asin lam) (e - asin lam) hc ph w0 wy0 P) as [-> ->]; [ lra | ].
  split; [ unfold eq31_w, h; rewrite Rplus_minus; ring | split; [ trivial | intros; apply P; lra ] ].
Qed.

(* (32) has one smallest solution above phi1, and there each slip that begins at a rest at phi1 ends: forward before, zero at it. *)
Theorem eq_32 lam : 0 < lam < 1 -> exists e, slip_end lam e /\ (forall e', slip_end lam e' -> e' = e) /\
  forall phi0 w wy c, shaken lam phi0 w wy -> 0 <= c -> at_phase phi0 c (eq27_phi1 lam) -> w c = 0 -> wy c = 0 ->
    (forall s, c < s < c + (e - eq27_phi1 lam) -> 0 < w s) /\ w (c + (e - eq27_phi1 lam)) = 0.
Proof.
  intros hl. destruct (slip_end_exists lam hl) as [e E]. exists e. split; [ trivial | split ].
  - intros e' E'. exact (slip_end_one lam e e' E E').
  - intros phi0 w wy c M hc ph w0 wy0. pose proof E as (E1 & E2 & _).
    assert (S : forall phi, eq27_phi1 lam <= phi <= e -> _) by (intros phi; exact (eq_31 lam e phi0 w wy c phi ltac:(lra) E M hc ph w0 wy0)). split.
    + intros s Hs. destruct (S (eq27_phi1 lam + (s - c)) ltac:(lra)) as (_ & _ & P).
      replace (c + (eq27_phi1 lam + (s - c) - eq27_phi1 lam)) with s in P by ring. apply P. lra.
    + destruct (S e ltac:(lra)) as (-> & _). rewrite <- E2. unfold eq31_w, eq32_left. ring.
Qed.
(* where the slip ends, to ten decimals *)
Theorem eq_32__digits e : (slip_end (1 / sqrt 2) e -> Rabs (e - 3.1974093073) <= 5e-11) /\ (slip_end (3 / 5) e -> Rabs (e - 3.5234549058) <= 5e-11) /\
  (slip_end (9 / 10) e -> Rabs (e - 2.4824327945) <= 5e-11).
Proof.
  assert (N : forall lam x, let a := atan (lam / sqrt (1 - lam ^ 2)) in slip_end lam e -> 0 < lam < 1 -> a < x - 5e-11 -> x + 5e-11 <= 2 * PI ->
    0 < - lam * (x - 5e-11 - a) + cos a - cos (x - 5e-11) -> - lam * (x + 5e-11 - a) + cos a - cos (x + 5e-11) < 0 -> Rabs (e - x) <= 5e-11).
  { intros lam x a E hl. unfold a. rewrite <- Rsqr_pow2, <- asin_atan by lra. intros h1 h2 X Y. destruct (slip_end_is lam e hl E) as (A & z & P & N).
    apply Rabs_le. specialize (P (x + 5e-11 - asin lam)). specialize (N (x - 5e-11 - asin lam)). unfold h in *. rewrite Rplus_minus in *.
    destruct (asin_range lam hl) as [b _]. split; apply Rnot_lt_le; intros k; lra. }
  repeat split; intros E; apply (N _ _ E); try split; interval with (i_prec 60).
Qed.
(* The slip ends between phi2 and phi4. *)
Theorem s22_phi2_bracket lam e : 0 < lam < 1 -> slip_end lam e -> eq28_phi2 lam < e < eq30_phi4 lam.
Proof. intros hl E. destruct (slip_end_is lam e hl E) as (A & _). unfold eq28_phi2, eq30_phi4. lra. Qed.
Theorem s22_phi2_bracket__needs_friction e : slip_end 0 e -> e = eq30_phi4 0.
Proof.
  intros (E1 & E2 & E3). unfold eq32_left, eq27_phi1, eq30_phi4 in *. rewrite asin_0, cos_0 in *. pose proof PI_RGT_0.
  destruct (Rle_lt_dec e (2 * PI)) as [k | k]. 2: { exfalso. apply (E3 (2 * PI)). lra. rewrite cos_2PI. ring. }
  destruct (Req_dec e (2 * PI)) as [ | ne]; [ lra | exfalso ]. pose proof (sin_gt_0 (e / 2) ltac:(lra) ltac:(lra)).
  pose proof (cos_2a_sin (e / 2)) as C.
  replace (2 * (e / 2)) with e in C by field. nra.
Qed.

(* ---- above lambda_c: (33) to (37) ---- *)
(* (34), (35), (36): each says that the slip ends before the next one, backward, begins; (35) is (34). *)
Lemma left_34 lam : 0 < lam < 1 -> eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam) = eq35_left lam.
Proof. intros hl. rewrite <- h_PI by trivial. unfold eq34_left, eq29_phi3, eq27_phi1, h. rewrite (Rplus_comm PI). ring. Qed.
Theorem eq_34 lam e : 0 < lam < 1 -> slip_end lam e -> (eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam) < 0 <-> e < eq29_phi3 lam).
Proof. intros hl E. rewrite left_34 by trivial. now apply early_end. Qed.
Theorem eq_35 lam e : 0 < lam < 1 -> slip_end lam e -> eq35_left lam = eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam)
  /\ (eq35_left lam < 0 <-> e < eq29_phi3 lam).
Proof. intros hl E. rewrite left_34 by trivial. split; trivial. now apply early_end. Qed.
Theorem eq_36 lam e : 0 < lam < 1 -> slip_end lam e -> (eq36_sides_2 lam < eq36_sides_1 lam <-> e < eq29_phi3 lam).
Proof. apply early_end. Qed.
(* (37) is the one zero of (35). *)
Theorem eq_37 lam : 0 <= lam <= 1 -> (eq35_left lam = 0 <-> lam = eq37_lambda_c) /\ (eq35_left lam < 0 <-> eq37_lambda_c < lam).
Proof. intros hl. destruct (left_sign lam hl) as (c & c0 & S). repeat split; intros; nra. Qed.
Theorem eq_37__digits : Rabs (eq37_lambda_c - 0.5370292721463151) <= 1e-16 /\ Rabs (asin eq37_lambda_c - 0.5669115049410095) <= 1e-15.
Proof.
  split; [ unfold eq37_lambda_c; interval with (i_prec 80) | ]. rewrite asin_atan by (pose proof lambda_c_between; lra).
  unfold Rsqr, eq37_lambda_c. interval with (i_prec 80).
Qed.
(* (33): where the slip ends before phi3 it is a motion, from every phase on, and every motion becomes it after a finite time. *)
Theorem eq_33 lam e phi0 w wy : 0 < lam < 1 -> slip_end lam e -> e < eq29_phi3 lam -> shaken lam phi0 w wy ->
  shaken lam phi0 (fun s => w33 lam e (phi0 + s)) (fun _ => 0) /\ exists s1, forall s, s1 <= s -> w s = w33 lam e (phi0 + s) /\ wy s = 0.
Proof. intros hl E q M. split. now apply w33_motion. destruct (w33_reached lam e hl E q phi0 w wy M) as (s1 & _ & R). now exists s1. Qed.
(* So every motion rests, from some time on, from phitilde2 to phi3 and from half a period later to phi1 + 2 pi, and moves in between. *)
Theorem s22_rest_interval lam e phi0 w wy : 0 < lam < 1 -> slip_end lam e -> e < eq29_phi3 lam -> shaken lam phi0 w wy ->
  exists s1, forall s phi, s1 <= s -> at_phase phi0 s phi -> wy s = 0 /\
    (eq27_phi1 lam < phi < e -> 0 < w s) /\ (e <= phi <= eq29_phi3 lam -> w s = 0) /\
    (eq29_phi3 lam < phi < e + PI -> w s < 0) /\ (e + PI <= phi <= eq27_phi1 lam + 2 * PI -> w s = 0).
Proof.
  intros hl E q M. destruct (w33_reached lam e hl E q phi0 w wy M) as (s1 & _ & R). exists s1. intros s phi hs [n ph]. destruct (R s hs) as [-> ->].
  rewrite ph, (whole_periods (w33 lam e)) by (intros; now apply w33_period).
  unfold eq29_phi3, eq27_phi1 in *. split; [ trivial | ]. assert (back : w33 lam e phi = - w33 lam e (phi - PI))
  by (rewrite <- (w33_anti lam e hl E q); f_equal; ring).
  repeat split; intros H; [ now apply w33_slip | apply w33_rest; trivial; lra | | ].
  - rewrite back. pose proof (w33_slip lam e hl E q (phi - PI) ltac:(lra)). lra.
  - rewrite back, (w33_rest lam e hl E q) by lra. ring.
Qed.

(* ---- up to lambda_c: (38) to (41) ---- *)
(* (38): up to lambda_c it is a motion, from every phase on, and every motion tends to it. *)
Theorem eq_38 lam phi0 w wy : 0 < lam <= eq37_lambda_c -> shaken lam phi0 w wy ->
  shaken lam phi0 (fun s => w38 lam (phi0 + s)) (fun _ => 0) /\ is_lim (fun s => w s - w38 lam (phi0 + s)) p_infty 0 /\ is_lim wy p_infty 0.
Proof. intros hl M. split. now apply w38_motion. now apply w38_attracts. Qed.
(* (39) is the one phase of a period at which a motion that repeats itself with the other sign after half a period turns forward. *)
Theorem eq_39 lam phi : 0 < lam <= eq37_lambda_c -> 0 <= phi < 2 * PI ->
  (phi = eq39_phi_t1 lam <-> exists W : R -> R, (forall phi0, shaken lam phi0 (fun s => W (phi0 + s)) (fun _ => 0)) /\ (forall x, W (x + PI)
  = - W x) /\
    W phi = 0 /\ forall x, phi < x < phi + PI -> 0 < W x).
Proof.
  intros hl hphi. pose proof PI_RGT_0. split.
  - intros ->. exists (w38 lam). split; [ | split; [ | split ] ]; intros;
    [ now apply w38_motion | apply w38_anti | rewrite <- (w38_turn lam 0); f_equal; ring | now apply w38_pos ].
  - intros (W & M & A & z & P). assert (same : forall s, W (phi + s) - w38 lam (phi + s) = 0).
    { apply (per_zero (fun s => W (phi + s) - w38 lam (phi + s)) (2 * PI)); [ lra | | apply (w38_attracts lam hl phi _ _ (M phi)) ].
      intros s. rewrite <- Rplus_assoc, (twice W A), w38_period. ring. }
    pose proof (same 0) as s0. rewrite Rplus_0_r, z in s0. assert (s1 : w38 lam phi = 0) by lra. apply (w38_zeros lam hl) in s1.
    destruct s1 as [n Hn].
    destruct (below_1 lam hl) as [l0 l1]. destruct (p_facts lam ltac:(lra) (proj2 hl)) as [[a b] _].
    destruct (asin_range lam ltac:(lra)) as [[a1 _] _].
    assert (n = 0 \/ n = 1)%Z as [-> | ->]; [ | lra | exfalso ].
    { assert (-1 < IZR n < 2) as [n1 n2] by (split; nra). apply lt_IZR in n1. apply lt_IZR in n2. lia. }
    pose proof (P (phi + PI / 2) ltac:(lra)) as Q. specialize (same (PI / 2)).
    replace (phi + PI / 2) with (eq39_phi_t1 lam + PI / 2 + PI) in * by lra. rewrite w38_anti in same.
    pose proof (w38_pos lam hl (eq39_phi_t1 lam + PI / 2) ltac:(lra)). lra.
Qed.
(* (40): (38) is a motion where lambda0 is lambda_c at most; below, the drive exceeds friction where (38) is zero. *)
Theorem eq_40 lam : 0 < lam -> PI * lam / 2 <= 1 -> ((forall phi0, shaken lam phi0 (fun s => w38 lam (phi0 + s)) (fun _ => 0))
  <-> lam <= eq37_lambda_c) /\
  (lam < sin (eq39_phi_t1 lam) <-> eq40_sides_1 lam < eq40_sides_2 lam).
Proof.
  intros h0 h1. destruct (turn_sign lam ltac:(lra) h1) as (c & c0 & S). change (eq40_sides_2 lam) with eq37_lambda_c. unfold eq40_sides_1.
  split; [ | split; intros; nra ].
  split; [ | intros; apply w38_motion; lra ]. intros M. apply Rnot_lt_le. intros k. set (p := eq39_phi_t1 lam) in *. pose proof PI_RGT_0.
  assert (neg : sin p < lam) by nra. assert (0 <= sin p) by (apply sin_ge_0; apply acos_bound). set (u := Rmin (lam - sin p) (PI / 2)).
  assert (hu : 0 < u <= lam - sin p /\ u < PI) by (unfold u; minmax). pose proof (w38_turn lam 0) as z. rewrite Rmult_0_l, Rplus_0_r in z.
  fold p in z.
  assert (rest : forall t, 0 <= t < 0 + u -> g38 lam p t = 0).
  { intros t ht. destruct (stays lam p _ _ ltac:(lra) (M p) 0 t) as [e _]; [ lra | | now rewrite Rplus_0_r | trivial | ].
    - intros y hy. pose proof (sin_size (p + y) p) as D. replace (p + y - p) with y in D by ring.
      rewrite (Rabs_pos_eq (sin p)), (Rabs_pos_eq y) in D by lra. lra.
    - cbv beta in e. rewrite (w38_on lam 0) in e by (fold p; lra). fold p in e. unfold sg in e. simpl in e. rewrite Rmult_1_l in e. rewrite <- e.
      f_equal. ring. }
  pose proof (rder_unique _ _ _ _ (rder_of _ _ _ (g_der lam p 0)) (rder_zero _ 0 u ltac:(lra) rest)) as e. rewrite Rplus_0_r in e. lra.
Qed.
(* (41): (38) turns forward after the drive has come to beat friction, exactly below lambda_c. *)
Theorem eq_41 lam : 0 < lam < 1 -> PI * lam / 2 <= 1 -> let p := eq39_phi_t1 lam in let p1 := eq27_phi1 lam in (eq41_sides_2 p p1 < eq41_sides_1 p
  p1 <-> lam < eq37_lambda_c).
Proof.
  intros hl h1 p p1. unfold eq41_sides_1, eq41_sides_2, p, p1, eq27_phi1. split; intros H; [ | apply p_facts; lra ].
  destruct (turn_sign lam ltac:(lra) h1) as (c & c0 & S). destruct (asin_range lam hl) as [[a b] e]. pose proof PI_RGT_0.
  assert (eq39_phi_t1 lam <= PI / 2). { apply Rnot_lt_le. intros q. pose proof (acos_bound (PI * lam / 2)). unfold eq39_phi_t1 in *.
    pose proof (cos_lt_0 _ q ltac:(lra)) as n. rewrite cos_acos in n by nra. nra. }
  pose proof (sin_increasing_1 (asin lam) (eq39_phi_t1 lam) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H). nra.
Qed.

(* ---- at large times ---- *)
(* With any friction the velocity across the drive tends to zero. *)
Theorem s22_vy_vanishes mu g A0 varpi t0 vx vy : 0 < mu * g -> block mu g A0 varpi t0 vx vy -> is_lim vy p_infty s22_late_vy.
Proof.
  intros h0 B. apply (across_vanishes (mu * g) (fun t => eq21_acceleration_1 A0 varpi (t0 + t)) vx vy (Rlt_le _ _ h0) B (Rabs A0 + 1)); trivial;
  [ pose proof (Rabs_pos A0); lra | ].
  intros t _. unfold eq21_acceleration_1. rewrite Rabs_mult, Rabs_Ropp. pose proof (sin_1 (varpi * (t0 + t))). pose proof (Rabs_pos A0). nra.
Qed.
(* Without friction there is a motion that keeps its velocity across, and whose velocity along is never zero. *)
Theorem s22_vy_vanishes__needs_friction : shaken 0 0 (fun s => 2 - cos s) (fun _ => 1) /\ forall s, 0 < 2 - cos s.
Proof.
  split. 2: { intros s. pose proof (COS_bound s). lra. } rewrite shaken_sin. split; [ | intros; cont | ].
  - intros s _. apply derivable_continuous_pt. reg.
  - intros s _. exists 0, 0. split; [ split; [ lra | ring ] | ]. split; [ | eapply rder_eq; [ rd | ring ] ]. apply rder_of. auto_derive; trivial.
    rewrite Rplus_0_l. ring.
Qed.
(* A drive weaker than friction: after this time the block is at rest, for good. *)
Theorem s22_weak_drive_stops mu g A0 varpi t0 vx vy t : 0 < A0 < mu * g -> block mu g A0 varpi t0 vx vy -> nrm (vx 0) (vy 0) / (mu * g - A0) <= t ->
  vx t = 0 /\ vy t = 0.
Proof.
  intros h B. apply (weak_stops (mu * g) A0 _ _ vx vy ltac:(lra) B). intros u _. rewrite drive_size. pose proof (sin_1 (varpi * (t0 + u))).
  rewrite (Rabs_pos_eq A0) by lra. nra.
Qed.
(* A drive that can be stronger: however late, vx reaches a size that does not depend on the motion. *)
Theorem s22_vx_stays mu g A0 varpi t0 vx vy : 0 <= mu * g < A0 -> 0 < varpi -> block mu g A0 varpi t0 vx vy ->
  let b := PI / 2 - eq27_phi1 (eq22_lambda0 mu g A0) in let c := A0 / varpi * (sin b - b * cos b) in
  0 < c /\ (forall T, exists t, T <= t /\ c <= Rabs (vx t)) /\ ~ is_lim vx p_infty 0.
Proof.
  intros h hv B b c. apply (block_units mu g A0 varpi t0 _ _ ltac:(lra) hv) in B. set (l := eq22_lambda0 mu g A0) in *.
  pose proof (units_pos mu g A0 ltac:(lra) (proj1 h)) as l0. fold l in l0.
  assert (l1 : l < 1) by (unfold l, eq22_lambda0; apply Rlt_div_l; lra). assert (hb : 0 < b < PI /\ cos b = l).
  { unfold b, eq27_phi1. rewrite cos_shift, sin_asin by lra. pose proof (asin_bound_lt l ltac:(lra)). split; [ lra | trivial ]. }
  destruct hb as [hb cb]. set (k := sin b - b * cos b) in *. assert (k0 : 0 < k).
  { pose proof (up (fun b => sin b - b * cos b) (fun b => b * sin b) 0 b ltac:(lra)) as U. cbv beta in U. fold k in U.
    rewrite sin_0, Rmult_0_l, Rminus_0_r in U. apply U; [ intros; auto_derive; trivial; ring | ].
    intros y Hy. apply Rmult_lt_0_compat; [ lra | apply sin_gt_0; lra ]. }
  assert (V : 0 < A0 / varpi) by (apply Rdiv_lt_0_compat; lra). assert (c0 : 0 < c) by (unfold c; now apply Rmult_lt_0_compat).
  assert (F : forall T, exists t, T <= t /\ c <= Rabs (vx t)).
  { intros T. destruct (phase_after (eq23_phase varpi t0) (asin l) (Rmax 0 (varpi * T))) as (s & hs & ph).
    assert (hT : 0 <= s /\ varpi * T <= s) by minmax.
    pose proof (gain l _ _ _ l0 B s (s + 2 * b) ltac:(lra)) as [G _]. cbv beta in G. destruct (at_sin _ s _ 0 ph) as [_ c1]. rewrite !Rplus_0_r in c1.
    destruct (at_sin _ s _ (2 * b) ph) as [_ c2]. rewrite c1, c2 in G.
    replace (asin l) with (PI / 2 - b) in G by (unfold b, eq27_phi1; ring). replace (PI / 2 - b + 2 * b) with (PI / 2 + b) in G by ring.
    replace (cos (PI / 2 + b)) with (- sin b) in G by (rewrite sin_cos; ring). rewrite cos_shift, <- cb in G.
    assert (sz : forall x, eq24_w varpi x A0 * (A0 / varpi) = x) by (intros; unfold eq24_w; field; lra).
    apply (Rmult_le_compat_r (A0 / varpi)) in G; [ | lra ]. rewrite (Rmult_minus_distr_r (eq24_w _ _ _)), !sz in G.
    assert (H : 2 * c <= vx ((s + 2 * b) / varpi) - vx (s / varpi)) by (unfold c, k in *; lra). assert (P : forall u, s <= u -> T <= u / varpi) by
    (intros; apply Rle_div_r; lra).
    destruct (Rle_lt_dec c (Rabs (vx (s / varpi)))) as [q | q]; [ exists (s / varpi) | exists ((s + 2 * b) / varpi) ]; (split; [ apply P; lra | ]);
    trivial.
    apply Rabs_def2 in q. pose proof (Rle_abs (vx ((s + 2 * b) / varpi))). lra. }
  split; [ trivial | split; [ trivial | ] ]. intros L. destruct (lim_near _ _ c L c0) as (T & _ & HT). destruct (F T) as (t & ht & K).
  specialize (HT t ht). assert (Rabs (vx t) < c) by (apply Rabs_def1; lra). lra.
Qed.
(* Friction along and across the drive while w is not zero: across it is -lambda0 wy/|w|, along it is lambda0 against w, but for (wy/w)^2/2 of it. *)
Theorem s22_friction_across lam phi0 w wy s : 0 <= lam -> shaken lam phi0 w wy -> 0 <= s -> w s <> 0 -> exists fx fy,
  rder w s (fx - eq21_acceleration_1 1 1 (phi0 + s)) /\ rder wy s (fy - eq21_acceleration_2 1 1 (phi0 + s)) /\
  Rabs (fy - s22_across_friction lam (w s) (wy s)) <= (wy s / w s) ^ 2 / 2 * Rabs (s22_across_friction lam (w s) (wy s)) /\
  Rabs (fx - - lam * (w s / Rabs (w s))) <= (wy s / w s) ^ 2 / 2 * lam.
Proof.
  intros hl M hs hw. destruct (law lam phi0 w wy hl M s hs) as (fx & fy & _ & [E F] & _ & X & Y). exists fx, fy.
  pose proof (Rabs_pos_lt _ hw) as x0. pose proof (nearly (Rabs (w s)) (wy s) x0) as n1.
  replace (nrm (Rabs (w s)) (wy s)) with (nrm (w s) (wy s)) in n1 by (unfold nrm; now rewrite pow2_abs).
  replace ((wy s / Rabs (w s)) ^ 2) with ((wy s / w s) ^ 2) in n1 by (unfold Rdiv; rewrite !Rpow_mult_distr, !pow_inv, pow2_abs; trivial).
  pose proof (abs_nrm (w s) (wy s)) as [n0 _]. set (q := (wy s / w s) ^ 2) in *. set (n := nrm (w s) (wy s)) in *. set (x := Rabs (w s)) in *.
  assert (near : Rabs (x / n - 1) <= q / 2) by (apply Rabs_le; lra). unfold s22_across_friction, eq21_acceleration_1, eq21_acceleration_2.
  replace (sqrt (w s ^ 2)) with x by (unfold x; rewrite <- (pow2_abs (w s)), sqrt_pow2; trivial; apply Rabs_pos).
  assert (part : forall f y, n * f = - lam * y -> Rabs (f - - lam * y / x) <= q / 2 * Rabs (- lam * y / x)).
  { intros f y e. replace (f - - lam * y / x) with ((x / n - 1) * (- lam * y / x)). rewrite Rabs_mult.
    apply Rmult_le_compat_r; [ apply Rabs_pos | trivial ].
    replace f with (- lam * y / n) by (rewrite <- e; field; lra). field; lra. }
  split; [ eapply rder_eq; [ exact X | rewrite Rmult_1_l; ring ] | split; [ eapply rder_eq; [ exact Y | ring ] | split; [ now apply part | ] ] ].
  replace (- lam * (w s / x)) with (- lam * w s / x) by (field; lra). apply Rle_trans with (1 := part fx (w s) E). right. f_equal.
  unfold Rdiv. rewrite !Rabs_mult, Rabs_Ropp, Rabs_inv, (Rabs_pos_eq lam) by trivial. fold x. rewrite (Rabs_pos_eq x) by lra. field. lra.
Qed.
(* Whatever the two starts, and at every friction but none: the difference of the two vx tends to zero. *)
Theorem s22_attractor_ignores_vy lam phi0 w wy u uy : 0 < lam -> shaken lam phi0 w wy -> shaken lam phi0 u uy ->
  is_lim (fun s => w s - u s) p_infty 0 /\
  (w 0 = u 0 -> w 0 <> 0 -> forall d, 0 < d -> (forall s, 0 <= s < d -> w s = u s) -> Rabs (wy 0) = Rabs (uy 0)).
Proof.
  intros h0 M N. split.
  - destruct (one_drawn lam h0) as [W D]. apply (is_lim_ext (fun s => (w s - W (phi0 + s)) - (u s - W (phi0 + s)))). intros; ring.
    replace 0 with (0 - 0) by ring. apply is_lim_minus'; eauto.
  - intros e0 hw d hd S. destruct (law lam phi0 w wy ltac:(lra) M 0 ltac:(lra)) as (fx & fy & _ & [E _] & _ & X & _).
    destruct (law lam phi0 u uy ltac:(lra) N 0 ltac:(lra)) as (gx & gy & _ & [F _] & _ & Y & _).
    pose proof (rder_unique _ _ _ _ X (rder_near w u 0 _ d hd ltac:(intros; symmetry; apply S; lra) Y)) as e. assert (e1 : fx = gx) by lra.
    rewrite <- e0, <- e1 in F. assert (fx <> 0) by (intros z; rewrite z in E; apply hw; nra).
    pose proof (nrm_sq (w 0) (wy 0)) as n1. pose proof (nrm_sq (w 0) (uy 0)) as n2.
    rewrite (Rmult_eq_reg_r fx (nrm (w 0) (wy 0)) (nrm (w 0) (uy 0))) in n1 by lra. apply Rsqr_eq_abs_0. rewrite !Rsqr_pow2. lra.
Qed.

(* ---- below lambda_c no rest, and how many there are above ---- *)
(* A slip from a rest at phi1 lasts longer than half the period, and a period after its start the block goes backward. *)
Theorem s22_slip_longer_than_half lam e phi0 w wy c : 0 < lam < eq37_lambda_c -> slip_end lam e -> shaken lam phi0 w wy -> 0 <= c ->
  at_phase phi0 c (eq27_phi1 lam) -> w c = 0 -> wy c = 0 -> PI < e - eq27_phi1 lam /\ w (c + 2 * PI) < 0.
Proof.
  intros [h0 hc] E M c0 ph w0 wy0. pose proof lambda_c_between. assert (hl : 0 < lam < 1) by lra. pose proof PI_RGT_0.
  destruct (slip_end_is lam e hl E) as (A & z & P & N). destruct (asin_range lam hl) as [b _]. destruct (early_end lam e hl E) as [_ L].
  unfold eq29_phi3 in L. unfold eq27_phi1 in *. assert (long : PI < e - asin lam).
  { apply Rnot_le_lt. intros [q | q]; [ lra | ]. rewrite q, h_PI in z by trivial. destruct (left_sign lam ltac:(lra)) as (k & k0 & S). nra.
    } split; trivial.
  set (tau := e - asin lam) in *. destruct (slip_is lam phi0 w wy (Rlt_le _ _ h0) M c tau tau c0 ph w0 wy0 P) as [q _]; [ lra | ].
  pose proof (gain lam phi0 w wy (Rlt_le _ _ h0) M (c + tau) (c + 2 * PI) ltac:(lra)) as [_ G]. destruct (at_sin phi0 c _ tau ph) as [_ c1].
  destruct (at_sin phi0 c _ (2 * PI) ph) as [_ c2]. rewrite c1, c2, q, z, cos_per in G. unfold h in z. nra.
Qed.
Lemma drive_low lam : 0 < lam < 1 -> forall x, PI - asin lam <= x <= asin lam + 2 * PI -> sin x <= lam.
Proof.
  intros hl x H. destruct (asin_range lam hl) as [[a b] e]. destruct (Req_dec x (PI - asin lam)) as [-> | ]; [ rewrite sin_PI_x; lra | ].
  destruct (Req_dec x (asin lam + 2 * PI)) as [-> | ]; [ rewrite sin_per; lra | ]. left. apply sin_less; lra.
Qed.
(* The period of the slip: after phitilde2 the drive cannot start a slip forward until phi1 + 2 pi, and from there on it
   does; its sum over it is 0. *)
Theorem s22_rest_of_period lam e : 0 < lam < 1 -> slip_end lam e -> let last := right_sinusoidal_rest_of_period_end (eq27_phi1 lam) in
  e < last /\ (forall y, e <= y -> ((forall x, e <= x <= y -> sin x <= lam) <-> y <= last)) /\ is_RInt sin (eq27_phi1 lam) last 0.
Proof.
  intros hl E last. destruct (slip_end_is lam e hl E) as (A & _). destruct (asin_range lam hl) as [[a b] s].
  unfold last, right_sinusoidal_rest_of_period_end, eq27_phi1. split; [ lra | split ].
  - intros y hy. split; [ | intros H x hx; apply drive_low; lra ]. intros H. apply Rnot_lt_le. intros k.
    set (x := Rmin y (asin lam + 2 * PI + (PI / 2 - asin lam))). assert (hx : asin lam + 2 * PI < x <= y /\ x <= 2 * PI + PI / 2) by (unfold x;
    minmax).
    pose proof (H x ltac:(lra)) as L. pose proof (sin_above lam (x - 2 * PI) hl ltac:(lra)) as Q. rewrite <- sin_per in Q.
    replace (x - 2 * PI + 2 * PI) with x in Q by ring. lra.
  - replace 0 with (minus (- cos (asin lam + 2 * PI)) (- cos (asin lam))) by (rewrite cos_per; unfold minus, plus, opp; simpl; ring).
    apply (is_RInt_derive (fun x => - cos x) sin); intros x _; [ auto_derive; trivial; ring | apply continuity_pt_filterlim, continuity_sin ].
Qed.
(* As printed, with phi for phi1, that is so at phi = phi1 only. *)
Theorem s22_rest_of_period__printed lam e phi : 0 < lam < 1 -> slip_end lam e -> e <= s22_rest_of_period_end phi ->
  ((forall y, e <= y -> ((forall x, e <= x <= y -> sin x <= lam) <-> y <= s22_rest_of_period_end phi)) <-> phi = eq27_phi1 lam).
Proof.
  intros hl E hp. destruct (s22_rest_of_period lam e hl E) as (l1 & R & _). set (last := right_sinusoidal_rest_of_period_end (eq27_phi1 lam)) in *.
  assert (same : last = eq27_phi1 lam + 2 * PI) by reflexivity. unfold s22_rest_of_period_end in *. split.
  - intros P. assert (phi + 2 * PI <= last) by (apply R; trivial; apply P; lra). assert (last <= phi + 2 * PI) by (apply P; [ lra | apply R; lra ]).
    lra.
  - intros ->. exact R.
Qed.
(* Below lambda_c no motion that repeats itself, with any period, has a velocity along the drive that vanishes on an interval. *)
Theorem s22_no_rest_below lam phi0 w wy P r s : 0 <= lam < eq37_lambda_c -> shaken lam phi0 w wy -> 0 < P ->
  (forall t, 0 <= t -> w (t + P) = w t /\ wy (t + P) = wy t) -> 0 <= r < s -> exists t, r <= t <= s /\ w t <> 0.
Proof.
  intros hl M hP per H. apply Classical_Prop.NNPP. intros no. assert (Z : forall n t, r <= t <= s -> w (t + INR n * P) = 0).
  { intros n t Ht. destruct (Req_dec (w t) 0) as [e | e]; [ | exfalso; apply no; now exists t ]. rewrite <- e. clear e.
    induction n as [ | n IH ]; [ f_equal; simpl; ring | ]. rewrite S_INR, <- IH. replace (t + (INR n + 1) * P) with (t + INR n * P + P) by ring.
    apply per. pose proof (pos_INR n). nra. }
  pose proof PI2_3_2. destruct hl as [[h0 | <-] hc].
  - destruct (two_zeros lam phi0 w wy (conj h0 hc) M (PI / 2)) as (s1 & O).
    { intros n E. destruct (room lam (conj h0 hc)). assert (0 < IZR n < 1) as [n0 n1] by (split; nra). apply lt_IZR in n0. apply lt_IZR in n1. lia. }
    destruct (nat_above ((s1 + 2 * PI - r) / P)) as [n Hn]. apply Rlt_div_l in Hn; trivial. set (m := (r + s) / 2).
    destruct (phase_after phi0 (PI / 2) (m + INR n * P - 2 * PI)) as (S & hS & ph).
    destruct (O S ltac:(unfold m in *; lra) ph) as (z1 & z2 & _ & _ & I). set (d := Rmin ((s - r) / 4) ((m + INR n * P - S) / 2)).
    assert (hd : 0 < d /\ 4 * d <= s - r /\ 2 * d <= m + INR n * P - S) by (unfold d; minmax).
    assert (hit : forall c, 0 <= c <= 2 -> m - c * d + INR n * P = z1 \/ m - c * d + INR n * P = z2).
    { intros c hc'. assert (0 <= c * d <= 2 * d) by nra. apply I; [ lra | apply Z; unfold m; lra ]. }
    destruct (hit 0 ltac:(lra)); destruct (hit 1 ltac:(lra)); destruct (hit 2 ltac:(lra)); lra.
  - set (y := Rmin ((r + s) / 2) (r + 1)). assert (hy : r < y < s /\ y <= r + 1) by (unfold y; minmax).
    assert (Q : forall t, r <= t < s -> sin (phi0 + t) = 0).
    { intros t Ht. pose proof (rest_needs_friction 0 phi0 w wy (Rle_refl 0) M r s t ltac:(lra) ltac:(lra)) as B.
      apply Rabs_eq_0, Rle_antisym; [ | apply Rabs_pos ].
      apply B. intros x hx. rewrite <- (Z 0%nat x ltac:(lra)). f_equal. simpl. ring. }
    apply (sine_vanishes (phi0 + r) (phi0 + y)); [ lra | apply Q; lra | apply Q; lra ].
Qed.
(* Small, large and very large friction: of every motion, from some time on, in each period, the zeros of vx. A period may begin at any
   phase but those of the zeros of (38) in the first case; in the second it is counted from the end of a rest. *)
Theorem s22_trichotomy lam phi0 w wy : 0 < lam -> shaken lam phi0 w wy ->
  (lam < eq37_lambda_c -> forall phi, (forall n, phi <> eq39_phi_t1 lam + IZR n * PI) -> exists s1, forall s, s1 <= s -> at_phase phi0 s phi ->
    exists z1 z2, s < z1 < z2 /\ z2 < s + 2 * PI /\ forall z, s <= z <= s + 2 * PI -> (w z = 0 <-> z = z1 \/ z = z2)) /\
  (eq37_lambda_c < lam < 1 -> exists tau s1, 0 < tau < PI /\ slip_end lam (eq27_phi1 lam + tau) /\ forall s, s1 <= s ->
  at_phase phi0 s (eq27_phi1 lam) ->
    forall z, s < z <= s + 2 * PI -> (w z = 0 <-> s + tau <= z <= s + PI \/ s + PI + tau <= z <= s + 2 * PI)) /\
  (1 <= lam -> exists s1, forall s, s1 <= s -> w s = 0).
Proof.
  intros h0 M. split; [ | split ].
  - intros hc phi ne. apply (two_zeros lam phi0 w wy ltac:(lra) M phi ne).
  - intros hc. pose proof lambda_c_between. assert (hl : 0 < lam < 1) by lra. destruct (early_exists lam hc) as (e & E & q).
    destruct (s22_rest_interval lam e phi0 w wy hl E q M) as [s1 R]. destruct (ends lam e hl E q) as (b & o & _). exists (e - asin lam), s1.
    split; [ lra | split; [ unfold eq27_phi1; now rewrite Rplus_minus | ] ].
    intros s hs [n ph] z hz. destruct (R z (asin lam + (z - s)) ltac:(lra)) as (_ & r1 & r2 & r3 & r4). { exists n. unfold eq27_phi1 in ph. lra. }
    unfold eq27_phi1, eq29_phi3 in *. split.
    + intros wz. rewrite wz in *. destruct (Rlt_le_dec z (s + (e - asin lam))); [ lra | ]. destruct (Rle_lt_dec z (s + PI)); [ left; lra | ].
      right. split; [ | lra ]. apply Rnot_lt_le. intros k. lra.
    + intros [K | K]; [ apply r2 | apply r4 ]; lra.
  - intros h1. destruct (all_stop lam phi0 w wy h1 M) as (s1 & _ & R). exists s1. intros s hs. now destruct (R s hs).
Qed.
(* Without friction it fails: this motion has no zero. *)
Theorem s22_trichotomy__needs_friction : shaken 0 0 (fun s => 2 - cos s) (fun _ => 1) /\ forall s, 2 - cos s <> 0.
Proof. destruct s22_vy_vanishes__needs_friction as [M P]. split; trivial. intros s. specialize (P s). lra. Qed.

(* ---- the two stages of the velocity across ---- *)
Lemma drive_is lam : 0 <= lam <= eq37_lambda_c -> right_sinusoidal_drive_at_zero lam = sin (eq39_phi_t1 lam).
Proof.
  intros hl. pose proof (small lam hl). unfold right_sinusoidal_drive_at_zero, eq39_phi_t1. rewrite sin_acos by lra. f_equal. unfold Rsqr. ring.
Qed.
(* While wy is large it falls at the rate lambda0, but for (w/wy)^2/2 of it. Above lambda_c it is zero after a finite time; what is left of it where w
   is zero, while friction exceeds a drive of size d at most, is lost within the stated phase. It becomes zero only where the block stops, and then
   for good. Below lambda_c, if it does not, each passage of w through zero multiplies ln |wy| by the stated factor up to a bounded difference: from
   a zero of w to the next, and between moments half a period apart, at any phase but those of the zeros of (38). So |wy| falls as the exponential
   of an exponential. *)
Theorem s22_vy_two_stages lam phi0 w wy : 0 < lam -> shaken lam phi0 w wy ->
  (forall s, 0 <= s -> 0 < wy s ->
    exists r, rder wy s r /\ s22_first_stage_slope lam <= r <= s22_first_stage_slope lam + lam * (w s / wy s) ^ 2 / 2) /\
  (eq37_lambda_c < lam -> exists s1, forall s, s1 <= s -> wy s = 0) /\
  (forall d s, 0 <= d < lam -> 0 <= s -> w s = 0 -> let u := s + right_sinusoidal_last_stage lam d (Rabs (wy s)) in
    (forall t, s <= t <= u -> Rabs (sin (phi0 + t)) <= d) -> w u = 0 /\ wy u = 0) /\
  (forall s u, 0 <= s < u -> wy s <> 0 -> wy u = 0 -> (exists t, s < t <= u /\ w t = 0 /\ wy t = 0) /\ forall t, u <= t -> wy t = 0) /\
  (lam < eq37_lambda_c -> (forall s, 0 <= s -> wy s <> 0) ->
    let d := right_sinusoidal_drive_at_zero lam in let F := right_sinusoidal_passage_factor lam d in let y s := ln (Rabs (wy s)) in
    d = sin (eq39_phi_t1 lam) /\ 1 < F /\
    (exists C, forall z z', 0 <= z < z' -> w z = 0 -> w z' = 0 -> (forall t, z < t < z' -> w t <> 0) -> Rabs (y z' - F * y z) <= C) /\
    forall s, 0 <= s -> (forall n, phi0 + s <> eq39_phi_t1 lam + IZR n * PI) -> exists a C, 0 < a /\ forall n, let t := s + INR n * PI in
      Rabs (y (t + PI) - F * y t) <= C /\ Rabs (y t + a * F ^ n) <= C).
Proof.
  intros h0 M. split; [ | split; [ | split; [ | split ] ] ].
  - intros s hs y0. destruct (law lam phi0 w wy ltac:(lra) M s hs) as (fx & fy & _ & [_ E] & _ & _ & Y). exists fy. split; trivial.
    pose proof (nearly (wy s) (w s) y0) as n1. pose proof (abs_nrm (w s) (wy s)) as [_ n0]. pose proof (Rle_abs (wy s)).
    replace (nrm (wy s) (w s)) with (nrm (w s) (wy s)) in n1 by (unfold nrm; f_equal; ring). unfold s22_first_stage_slope.
    set (n := nrm (w s) (wy s)) in *.
    assert (e : fy = - lam * (wy s / n)) by (apply (Rmult_eq_reg_l n); [ rewrite E; field; lra | lra ]). rewrite e. split; nra.
  - intros hc. destruct (one_reached lam hc) as [W R]. destruct (R phi0 w wy M) as (s1 & _ & Z). exists s1. intros s hs. now destruct (Z s hs).
  - intros d s hd hs w0 u A. assert (0 < lam ^ 2 - d ^ 2) by nra. assert (0 <= right_sinusoidal_last_stage lam d (Rabs (wy s))).
    { apply Rle_div_r; trivial. pose proof (Rabs_pos (wy s)). nra. }
    apply (stops_within lam d phi0 w wy s u hd M); trivial; [ unfold u; lra | ]. right. unfold u, right_sinusoidal_last_stage. field. lra.
  - intros s u hs y0 yu. split. 2: { intros t ht. pose proof (wy_falls lam phi0 w wy h0 M u t ltac:(lra)). rewrite yu in *. nra. }
    destruct (first_zero lam phi0 w wy h0 M s u hs y0 yu) as (t & ht & z1 & z2 & _). now exists t.
  - intros hc N. assert (hl : 0 < lam < eq37_lambda_c) by lra. cbv zeta. rewrite drive_is, <- factor_is by (trivial; lra). pose proof (k_pos lam hl).
    split; [ trivial | split; [ apply Rlt_div_r; lra | split ] ]. now apply (by_zeros lam phi0). now apply (doubly lam phi0 w).
Qed.
(* So the ratio of the falls of ln |wy| in a period and in the one before tends to the square of that factor, which is not the printed 1; *)
Theorem s22_vy_two_stages__printed lam phi0 w wy s : 0 < lam < eq37_lambda_c -> shaken lam phi0 w wy -> (forall s, 0 <= s -> wy s <> 0) -> 0 <= s ->
  (forall n, phi0 + s <> eq39_phi_t1 lam + IZR n * PI) ->
  let F := right_sinusoidal_passage_factor lam (right_sinusoidal_drive_at_zero lam) in
  let change t := ln (Rabs (wy (t + 2 * PI))) - ln (Rabs (wy t)) in
  is_lim_seq (fun n => change (s + INR n * (2 * PI) + 2 * PI) / change (s + INR n * (2 * PI))) (F ^ 2) /\ F ^ 2 <> s22_second_stage_ratio.
Proof.
  intros hl M N hs ne F change. destruct (s22_vy_two_stages lam phi0 w wy (proj1 hl) M) as (_ & _ & _ & _ & B).
  destruct (B (proj2 hl) N) as (_ & F1 & _ & D). destruct (D s hs ne) as (a & C & a0 & K). fold F in F1, K. unfold s22_second_stage_ratio.
  split; [ | nra ].
  set (y n := ln (Rabs (wy (s + INR n * (2 * PI))))). apply (is_lim_seq_ext (fun n => (y (S (S n)) - y (S n)) / (y (S n) - y n))).
  - intros n. unfold y, change. rewrite !S_INR. replace (s + (INR n + 1) * (2 * PI)) with (s + INR n * (2 * PI) + 2 * PI) by ring.
    now replace (s + (INR n + 1 + 1) * (2 * PI)) with (s + INR n * (2 * PI) + 2 * PI + 2 * PI) by ring.
  - apply (ratio_of_growths y a (F ^ 2) C); [ nra | trivial | ]. intros n. destruct (K (2 * n)%nat) as [_ E]. rewrite pow_mult, mult_INR in E.
    unfold y. replace (INR n * (2 * PI)) with (INR 2 * INR n * PI) by (simpl; ring). exact E.
Qed.
(* and with any friction wy falls in the end faster than every exponential, from every start. *)
Theorem s22_vy_two_stages__not_exponential lam phi0 w wy k : 0 < lam -> shaken lam phi0 w wy -> is_lim (fun s => wy s * exp (k * s)) p_infty 0.
Proof.
  intros h0 M. destruct (Rle_lt_dec lam eq37_lambda_c) as [q | q]. now apply (superexponential lam phi0 w).
  destruct (proj1 (proj2 (s22_vy_two_stages lam phi0 w wy h0 M)) q) as [s1 Z]. apply is_lim_spec. intros eps. exists s1. intros s hs.
  rewrite Z by lra.
  rewrite Rmult_0_l, Rminus_0_r, Rabs_R0. apply cond_pos.
Qed.

(* ---- the figures ---- *)
Lemma a_block mu g A0 varpi t0 vx0 vy0 : 0 <= mu * g -> exists vx vy, block mu g A0 varpi t0 vx vy /\ vx 0 = vx0 /\ vy 0 = vy0.
Proof.
  intros h. apply plane_has_a_motion; trivial. intros t _. unfold eq21_acceleration_1, eq21_acceleration_2. split; [ | cont ].
  apply derivable_continuous_pt. reg.
Qed.
Lemma a_motion lam phi0 w0 wy0 : 0 <= lam -> exists w wy, shaken lam phi0 w wy /\ w 0 = w0 /\ wy 0 = wy0.
Proof. intros h. apply a_block. lra. Qed.
(* Figure 2: for one initial w and every initial wy there is one curve; those of different size of wy part at once; all tend to the same W. *)
Theorem fig_2 lam : 0 < lam -> exists W, forall phi0 w0 y0, w0 <> 0 -> exists w wy, shaken lam phi0 w wy /\ w 0 = w0 /\ wy 0 = y0 /\
  is_lim (fun s => w s - W (phi0 + s)) p_infty 0 /\ forall u uy, shaken lam phi0 u uy -> u 0 = w0 ->
    (uy 0 = y0 -> forall s, 0 <= s -> u s = w s) /\ (Rabs (uy 0) <> Rabs y0 -> forall d, 0 < d -> exists s, 0 < s < d /\ u s <> w s).
Proof.
  intros h0. destruct (one_drawn lam h0) as [W D]. exists W. intros phi0 w0 y0 n0.
  destruct (a_motion lam phi0 w0 y0 ltac:(lra)) as (w & wy & M & e1 & e2).
  exists w, wy. do 3 (split; trivial). split; [ now apply (D phi0 w wy M) | intros u uy H H0; split ].
  - intros e3 s hs. pose proof (contraction (lam * 1) _ _ u uy w wy ltac:(lra) H M 0 s ltac:(lra)) as C. rewrite H0, e1, e2, e3 in C.
    destruct (sq_sum (u s - w s) (uy s - wy s)); lra.
  - intros ne d hd. apply Classical_Prop.NNPP. intros no. apply ne. rewrite <- e2.
    apply (proj2 (s22_attractor_ignores_vy lam phi0 u uy w wy h0 H M) ltac:(congruence) ltac:(congruence) d hd). intros s hs.
    destruct (Req_dec s 0) as [-> | ]; [ congruence | ]. destruct (Req_dec (u s) (w s)); trivial. exfalso. apply no. exists s.
    split; [ lra | trivial ].
Qed.
(* Figure 3: at the friction 1/pi every motion tends to (38), whose phase (39) is pi/3; it is largest at phi2, and the mark 0.8 is below that. *)
Theorem fig_3 : let lam := 1 / PI in eq39_phi_t1 lam = PI / 3 /\ (forall phi0 w wy, shaken lam phi0 w wy -> is_lim (fun s => w s - w38 lam (phi0 +
  s)) p_infty 0) /\
  (forall phi, Rabs (w38 lam phi) <= w38 lam (eq28_phi2 lam)) /\ 0.8 < w38 lam (eq28_phi2 lam) /\ Rabs (w38 lam (eq28_phi2 lam) - 0.884) <= 5e-4.
Proof.
  intros lam. pose proof PI_RGT_0. assert (hl : 0 < lam <= eq37_lambda_c) by (unfold lam, eq37_lambda_c; split; interval with (i_prec 60)). destruct (below_1 lam hl).
  assert (e : eq39_phi_t1 lam = PI / 3).
  { unfold eq39_phi_t1, lam. replace (PI * (1 / PI) / 2) with (cos (PI / 3)) by (rewrite cos_PI3; field; lra). apply acos_cos. lra. }
  assert (V : Rabs (w38 lam (eq28_phi2 lam) - 0.884) <= 5e-4).
  { unfold eq28_phi2. destruct (asin_range lam ltac:(lra)) as [b _]. rewrite w38_ext, e, ext_first by lra. unfold g38.
    rewrite Rplus_minus, asin_atan by lra.
    unfold Rsqr, lam. rewrite cos_PI3. interval with (i_prec 60). }
  repeat split; trivial; [ intros phi0 w wy M; now apply (w38_attracts lam hl phi0 w wy) | intros; now apply w38_most | apply Rabs_le_between in V;
  lra ].
Qed.
(* Figure 4: at the friction 1/sqrt 2 the slip ends before phi3 and every motion becomes (33);
it is largest at phi2, and the mark 0.3 is below that. *)
Theorem fig_4 e : slip_end (1 / sqrt 2) e -> let lam := 1 / sqrt 2 in e < eq29_phi3 lam /\
  (forall phi0 w wy, shaken lam phi0 w wy -> exists s1, forall s, s1 <= s -> w s = w33 lam e (phi0 + s)) /\
  (forall phi, Rabs (w33 lam e phi) <= w33 lam e (eq28_phi2 lam)) /\ 0.3 < w33 lam e (eq28_phi2 lam) /\
  w33 lam e (eq28_phi2 lam) = sqrt 2 * (1 - PI / 4).
Proof.
  intros E lam. fold lam in E. pose proof PI_RGT_0. assert (hl : 0 < lam < 1) by (unfold lam; split; interval with (i_prec 60)).
  assert (q : e < eq29_phi3 lam) by (apply (early_end lam e hl E); unfold lam, eq37_lambda_c; interval with (i_prec 60)).
  assert (a : asin lam = PI / 4) by (unfold lam; rewrite <- sin_PI4; apply asin_sin; lra).
  assert (V : w33 lam e (eq28_phi2 lam) = sqrt 2 * (1 - PI / 4)).
  { unfold eq28_phi2. destruct (ends lam e hl E q) as (b & o & _). rewrite w33_ext, ext_first by (trivial; lra). unfold g33.
    destruct Rlt_dec; [ | lra ].
    unfold h. rewrite a in *. replace (PI / 4 + (PI - PI / 4 - PI / 4)) with (PI - PI / 4) by ring. rewrite Rtrigo_facts.cos_pi_minus, cos_PI4.
    pose proof (sqrt_lt_R0 2 ltac:(lra)). pose proof (pow2_sqrt 2 ltac:(lra)) as s2. unfold lam.
    replace (sqrt 2) with (2 / sqrt 2) at 4 by (field_simplify_eq; lra).
    field. lra. }
  split; [ trivial | split; [ | split; [ intros; now apply w33_most | split; [ rewrite V; interval with (i_prec 60) | trivial ] ] ] ].
  intros phi0 w wy M. destruct (w33_reached lam e hl E q phi0 w wy M) as (s1 & _ & R). exists s1. intros s hs. now destruct (R s hs).
Qed.

(* ---- The motions of which these theorems speak exist ---- *)
(* a motion at the friction l from the velocity (a, b) at the phase p *)
Ltac start l p a b := destruct (a_motion l p a b) as (w & wy & M & w0 & y0); [ lra | ].
Ltac shake mu A b := destruct (a_block mu 1 A 3 0 1 b) as (x & y & M & x0 & y0); [ lra | ].
Lemma quarter : 1 / 4 < eq37_lambda_c < 3 / 4. Proof. unfold eq37_lambda_c. split; interval with (i_prec 60). Qed.
Lemma at_start phi : at_phase phi 0 phi. Proof. exists 0%Z. simpl. ring. Qed.
(* friction 3/4, with rests *)
Lemma some_rests : exists e, slip_end (3 / 4) e /\ e < eq29_phi3 (3 / 4). Proof. pose proof quarter. apply early_exists. lra. Qed.
Lemma eq_26__occurs : ltac:(occurs eq_26).
Proof. intros H. shake 1 2 0. refine (H 1 1 2 3 0 x y 0 _ _ _ M _ _ y0); lra. Qed.
Lemma s22_rest_ends__occurs : ltac:(occurs s22_rest_ends).
Proof.
  intros H. destruct some_rests as (e & E & q). assert (hl : 0 < 3 / 4 < 1) by lra. destruct (ends _ e hl E q) as (b & o & _).
  refine (H (3 / 4) e _ _ 0 (PI + asin (3 / 4) - e) _ (w33_motion (3 / 4) e hl E q e) _ _ _); try lra.
  - intros t Ht. split; trivial. apply w33_rest; trivial. lra.
  - intros d d0. set (u := Rmin d (e - asin (3 / 4)) / 2). assert (hu : 0 < u < d /\ u < e - asin (3 / 4)) by (unfold u; minmax).
    exists (PI + asin (3 / 4) - e + u). split; [ lra | left ]. replace (e + (PI + asin (3 / 4) - e + u)) with (asin (3 / 4) + u + PI) by ring.
    rewrite w33_anti by trivial. pose proof (w33_slip (3 / 4) e hl E q (asin (3 / 4) + u) ltac:(lra)). lra.
Qed.
Lemma eq_31__occurs : ltac:(occurs eq_31).
Proof.
  intros H. destruct some_rests as (e & E & _). start (3 / 4) (eq27_phi1 (3 / 4)) 0 0.
  pose proof E as [h _].
  refine (H (3 / 4) e _ w wy 0 e _ E M _ (at_start _) w0 y0 _); lra.
Qed.
Lemma eq_33__occurs : ltac:(occurs eq_33).
Proof. intros H. destruct some_rests as (e & E & q). start (3 / 4) 0 1 1.
refine (H (3 / 4) e 0 w wy _ E q M). lra. Qed.
Lemma s22_rest_interval__occurs : ltac:(occurs s22_rest_interval).
Proof. intros H. destruct some_rests as (e & E & q). start (3 / 4) 0 1 1.
refine (H (3 / 4) e 0 w wy _ E q M). lra. Qed.
Lemma eq_38__occurs : ltac:(occurs eq_38).
Proof. intros H. pose proof quarter. start (1 / 4) 0 1 1. refine (H (1 / 4) 0 w wy _ M). lra. Qed.
Lemma s22_vy_vanishes__occurs : ltac:(occurs s22_vy_vanishes).
Proof. intros H. shake 1 2 1. refine (H 1 1 2 3 0 x y _ M). lra. Qed.
Lemma s22_weak_drive_stops__occurs : ltac:(occurs s22_weak_drive_stops).
Proof. intros H. shake 2 1 1. refine (H 2 1 1 3 0 x y _ _ M (Rle_refl _)). lra. Qed.
Lemma s22_vx_stays__occurs : ltac:(occurs s22_vx_stays).
Proof. intros H. shake 1 2 1. refine (H 1 1 2 3 0 x y _ _ M); lra. Qed.
Lemma s22_friction_across__occurs : ltac:(occurs s22_friction_across).
Proof. intros H. start 1 0 1 1. refine (H 1 0 w wy 0 _ M _ _); lra. Qed.
Lemma s22_attractor_ignores_vy__occurs : ltac:(occurs s22_attractor_ignores_vy).
Proof. intros H. start 1 0 1 1. destruct (a_motion 1 0 1 2) as (u & uy & N & _). lra.
refine (H 1 0 w wy u uy _ M N). lra. Qed.
Lemma s22_slip_longer_than_half__occurs : ltac:(occurs s22_slip_longer_than_half).
Proof.
  intros H. pose proof quarter. destruct (slip_end_exists (1 / 4) ltac:(lra)) as [e E].
  start (1 / 4) (eq27_phi1 (1 / 4)) 0 0.
  refine (H (1 / 4) e _ w wy 0 _ E M _ (at_start _) w0 y0); lra.
Qed.
Lemma s22_no_rest_below__occurs : ltac:(occurs s22_no_rest_below).
Proof.
  intros H. pose proof quarter. pose proof PI_RGT_0. refine (H (1 / 4) 0 _ _ (2 * PI) 0 1 _ (w38_motion (1 / 4) _ 0) _ _ _); try lra.
  intros t _. split; trivial. rewrite <- (w38_period (1 / 4) (0 + t)). f_equal. ring.
Qed.
Lemma s22_trichotomy__occurs : ltac:(occurs s22_trichotomy).
Proof. intros H. start 1 0 1 1. refine (H 1 0 w wy _ M). lra. Qed.
Lemma s22_vy_two_stages__occurs : ltac:(occurs s22_vy_two_stages).
Proof. intros H. start 1 0 1 1. refine (H 1 0 w wy _ M). lra. Qed.
Lemma s22_vy_two_stages__printed__occurs : ltac:(occurs s22_vy_two_stages__printed).
Proof.
  intros H. pose proof quarter. pose proof PI_RGT_0. assert (hl : 0 < 1 / 4 < eq37_lambda_c) by lra.
  destruct (never_zero (1 / 4) hl) as (w & wy & M & N).
  refine (H (1 / 4) _ w wy 1 hl M N _ _); [ lra | ]. intros n E. pose proof PI2_3_2. assert (0 < IZR n < 1) as [n0 n1] by (split; nra).
  apply lt_IZR in n0. apply lt_IZR in n1. lia.
Qed.
Lemma s22_vy_two_stages__not_exponential__occurs : ltac:(occurs s22_vy_two_stages__not_exponential).
Proof. intros H. start 1 0 1 1. refine (H 1 0 w wy 1 _ M). lra. Qed.
Lemma fig_4__occurs : ltac:(occurs fig_4).
Proof. intros H. destruct (slip_end_exists (1 / sqrt 2)) as [e E]; [ split; interval with (i_prec 60) | exact (H e E) ]. Qed.
