(* Section 2.2: a block on a plane that is shaken along a line, by (21). `block` is a motion in the paper's units, `shaken` one in those of (22) to
   (24), from any velocity and at any phase of the drive at the start; `w33` and `w38` are (33) and (38) continued, `slip_end` is (32). *)
Require Import Reals Lra Psatz ZArith List.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion General Formulas Pieces Periodic Aniso Rates.
From Slipbook Require Import Steady AttractPlane Reached Shaken LargeTime AcrossStop Zeros Across.
Open Scope R_scope.

Ltac emptied T := lazymatch T with
  | forall x : ?A, @?B x => constr:(forall x : A, ltac:(let b := eval cbv beta in (B x) in let r := emptied b in exact r))
  | _ => constr:(False) end.
Ltac occurs t := let T := type of t in let r := emptied T in exact (~ r).

(* ---- drive and friction: (25) to (30) ---- *)
(* (25) says that A0 exceeds mu g; exactly then the acceleration exceeds what friction can hold, at some time, and a block cannot rest for ever. *)
Theorem eq_25 mu g A0 varpi t0 : 0 < A0 -> 0 < varpi -> let lam := eq22_lambda0 mu g A0 in
  (eq25_sides_1 lam < eq25_sides_2 lam <-> mu * g < A0) /\
  (eq25_sides_1 lam < eq25_sides_2 lam <-> exists t, mu * g < nrm (eq21_acceleration_1 A0 varpi t) (eq21_acceleration_2 A0 varpi t)) /\
  (0 <= mu * g -> (eq25_sides_1 lam < eq25_sides_2 lam <-> ~ block mu g A0 varpi t0 (fun _ => 0) (fun _ => 0))).
Proof.
  intros hA hv lam. unfold eq25_sides_1, eq25_sides_2. assert (e1 : lam < 1 <-> mu * g < A0) by (unfold lam, eq22_lambda0; rewrite <- Rdiv_lt_1 by trivial; tauto).
  assert (sz : forall t, nrm (eq21_acceleration_1 A0 varpi t) (eq21_acceleration_2 A0 varpi t) = A0 * Rabs (sin (varpi * t))).
  { intros t. unfold eq21_acceleration_1, eq21_acceleration_2. rewrite nrm_line, Rabs_mult, Rabs_Ropp, (Rabs_pos_eq A0) by lra. trivial. }
  assert (peak : forall c, exists t, varpi * (c + t) = PI / 2 + IZR 0 /\ True) by (intros c; exists (PI / 2 / varpi - c); split; [ simpl; field; lra | trivial ]).
  rewrite e1. split; [ tauto | split ].
  - split.
    + intros H. destruct (peak 0) as (t & E & _). exists t. rewrite sz. rewrite Rplus_0_l in E. rewrite E, Rplus_0_r, sin_PI2, Rabs_R1. lra.
    + intros [t H]. rewrite sz in H. pose proof (SIN_bound (varpi * t)). assert (Rabs (sin (varpi * t)) <= 1) by (apply Rabs_le; lra). nra.
  - intros h0. split.
    + intros H B. destruct (phase_after (varpi * t0) (PI / 2) 0) as (s & hs & ph). apply (block_units mu g A0 varpi t0 _ _ hA hv) in B.
      destruct ph as [n E]. pose proof (rest_needs_friction lam (varpi * t0) _ _ ltac:(unfold lam, eq22_lambda0; apply Rmult_le_pos; [ trivial | left; now apply Rinv_0_lt_compat ]) B 0 (s + 1) s ltac:(lra) ltac:(lra)) as Q.
      rewrite E, sin_Z, sin_PI2, Rabs_R1 in Q. enough (1 <= lam) by (apply e1 in H; lra). apply Q. intros t _. unfold eq24_w. field. lra.
    + intros H. apply Rnot_le_lt. intros k. apply H. split; [ intros; cont | intros; cont | ]. intros t _. exists (eq21_acceleration_1 A0 varpi (t0 + t)), (eq21_acceleration_2 A0 varpi (t0 + t)).
      pose proof (nrm_sq (eq21_acceleration_1 A0 varpi (t0 + t)) (eq21_acceleration_2 A0 varpi (t0 + t))) as N. rewrite sz in N. pose proof (SIN_bound (varpi * (t0 + t))).
      assert (S : 0 <= Rabs (sin (varpi * (t0 + t))) <= 1) by (split; [ apply Rabs_pos | apply Rabs_le; lra ]). split; [ split; [ rewrite <- N; apply pow_incr; split; nra | rewrite nrm_forward by lra; ring ] | ].
      split; (eapply rder_eq; [ rd | ring ]).
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
  intros hA hv h0 B ht hx hy. apply (block_units mu g A0 varpi t0 _ _ hA hv) in B. set (l := eq22_lambda0 mu g A0) in *.
  assert (l0 : 0 <= l) by (unfold l, eq22_lambda0; apply Rmult_le_pos; [ trivial | left; now apply Rinv_0_lt_compat ]).
  destruct (law l _ _ _ l0 B (eq23_phase varpi t)) as (fx & fy & C & _ & _ & X & _); [ unfold eq23_phase; nra | ]. eapply rder_eq; [ exact X | ].
  assert (e : eq23_phase varpi t / varpi = t) by (unfold eq23_phase; field; lra). destruct (coulomb_slip _ _ _ _ _ l0 C) as [E _]. rewrite !e in E. rewrite hy in E.
  set (w := eq24_w varpi (vx t) A0) in *. replace (eq24_w varpi 0 A0) with 0 in E by (unfold eq24_w; field; lra). rewrite nrm_line in E.
  assert (w0 : w <> 0). { unfold w, eq24_w. intros z. apply hx. apply (Rmult_eq_reg_l (varpi / A0)); [ rewrite Rmult_0_r, <- z; field; lra | ]. apply Rmult_integral_contrapositive_currified; [ lra | apply Rinv_neq_0_compat; lra ]. }
  pose proof (Rabs_pos_lt _ w0). unfold eq26_rate. rewrite <- (pow2_abs w), sqrt_pow2 by apply Rabs_pos.
  replace (eq23_phase varpi (t0 + t)) with (eq23_phase varpi t0 + eq23_phase varpi t) by (unfold eq23_phase; ring). unfold Rminus. f_equal.
  apply (Rmult_eq_reg_l (Rabs w)); [ rewrite E; field; lra | lra ].
Qed.

Section FourPoints.
Variable lam : R.
Hypothesis hl : 0 <= lam <= 1.
Let b : 0 <= asin lam <= PI / 2 /\ sin (asin lam) = lam.
Proof.
  pose proof (asin_bound lam). assert (e : sin (asin lam) = lam) by (apply sin_asin; lra). split; [ split; [ | lra ] | trivial ].
  apply Rnot_lt_le. intros k. pose proof (sin_lt_0_var (asin lam)). pose proof PI_RGT_0. lra.
Qed.
(* The drive equals friction once in each quarter of a period, at (27), (28), (29), (30). *)
Theorem eq_27 phi : 0 <= phi <= PI / 2 -> (Rabs (sin phi) = lam <-> phi = eq27_phi1 lam).
Proof.
  intros H. unfold eq27_phi1. destruct b as [b1 b2]. pose proof PI_RGT_0. rewrite Rabs_pos_eq by (apply sin_ge_0; lra). split; intros E.
  - rewrite <- E. rewrite asin_sin; lra.
  - now rewrite E.
Qed.
Theorem eq_28 phi : PI / 2 <= phi <= PI -> (Rabs (sin phi) = lam <-> phi = eq28_phi2 lam).
Proof. intros H. rewrite <- sin_PI_x, eq_27 by lra. unfold eq28_phi2, eq27_phi1. split; intros; lra. Qed.
Theorem eq_29 phi : PI <= phi <= 3 * (PI / 2) -> (Rabs (sin phi) = lam <-> phi = eq29_phi3 lam).
Proof. intros H. rewrite <- sin_PI_x, <- Rabs_Ropp, <- sin_neg, eq_27 by lra. unfold eq29_phi3, eq27_phi1. split; intros; lra. Qed.
Theorem eq_30 phi : 3 * (PI / 2) <= phi <= 2 * PI -> (Rabs (sin phi) = lam <-> phi = eq30_phi4 lam).
Proof. intros H. replace (sin phi) with (- sin (2 * PI - phi)) by (rewrite sin_2PI_minus; ring). rewrite Rabs_Ropp, eq_27 by lra. unfold eq30_phi4, eq27_phi1. split; intros; lra. Qed.
End FourPoints.
(* They are four, all of a period; at lambda0 = 0 there would be two. *)
Theorem s22_four_points lam : 0 < lam < 1 -> let points := eq27_phi1 lam :: eq28_phi2 lam :: eq29_phi3 lam :: eq30_phi4 lam :: nil in
  NoDup points /\ INR (length points) = s22_points /\ forall phi, 0 <= phi < 2 * PI -> (Rabs (sin phi) = lam <-> In phi points).
Proof.
  intros hl points. destruct (p1_range lam hl) as [[a c] _]. unfold points. split; [ | split ].
  - unfold eq27_phi1, eq28_phi2, eq29_phi3, eq30_phi4. repeat constructor; simpl; intuition lra.
  - unfold s22_points. simpl. ring.
  - intros phi H. assert (h : 0 <= lam <= 1) by lra. simpl. pose proof (eq_27 lam h phi). pose proof (eq_28 lam h phi). pose proof (eq_29 lam h phi). pose proof (eq_30 lam h phi).
    unfold eq27_phi1, eq28_phi2, eq29_phi3, eq30_phi4 in *.
    destruct (Rle_lt_dec phi (PI / 2)); [ | destruct (Rle_lt_dec phi PI); [ | destruct (Rle_lt_dec phi (3 * (PI / 2))) ] ]; split; intros K; try (destruct K as [K | [K | [K | [K | []]]]]); intuition lra.
Qed.
Theorem s22_four_points__needs_friction : let p := 0 in eq27_phi1 p = 0 /\ eq28_phi2 p = PI /\ eq29_phi3 p = PI /\ eq30_phi4 p = 2 * PI.
Proof. cbv zeta. unfold eq27_phi1, eq28_phi2, eq29_phi3, eq30_phi4. rewrite asin_0. repeat split; ring. Qed.

(* ---- rests, and the slip after one: (31), (32) ---- *)
(* A rest that ends does so at phi1 or phi3: at s the velocity, zero on [r, s], ceases to be zero. *)
Theorem s22_rest_ends lam phi0 w wy r s : 0 <= lam -> shaken lam phi0 w wy -> 0 <= r < s -> (forall t, r <= t <= s -> w t = 0 /\ wy t = 0) ->
  (forall d, 0 < d -> exists t, s < t < s + d /\ (w t <> 0 \/ wy t <> 0)) -> at_phase phi0 s (eq27_phi1 lam) \/ at_phase phi0 s (eq29_phi3 lam).
Proof.
  intros hl M H rest ends.
  assert (held : ~ exists d, 0 < d /\ forall t, s <= t < s + d -> Rabs (sin (phi0 + t)) <= lam).
  { intros (d & d0 & D). destruct (ends d d0) as (t & Ht & K). destruct (rest s ltac:(lra)). destruct (stays lam phi0 w wy hl M s t); trivial; [ lra | intros; apply D; lra | tauto ]. }
  destruct (Rle_lt_dec 1 lam) as [k | k]. { exfalso. apply held. exists 1. split; [ lra | ]. intros t _. pose proof (SIN_bound (phi0 + t)). apply Rabs_le; lra. }
  assert (before : forall t, r <= t < s -> Rabs (sin (phi0 + t)) <= lam) by (intros t Ht; apply (rest_needs_friction lam phi0 w wy hl M r s); try lra; intros; apply rest; lra).
  destruct hl as [h0 | <-].
  2: { exfalso. set (u := Rmax r (s - 1)). assert (r <= u < s /\ s - 1 <= u) by (unfold u; repeat split; [ apply Rmax_l | apply Rmax_lub_lt; lra | apply Rmax_r ]).
       set (y := (u + s) / 2). assert (Z : forall t, r <= t < s -> sin (phi0 + t) = 0) by (intros t Ht; specialize (before t Ht); apply Rabs_le_between in before; lra).
       assert (S : 0 < sin (y - u)) by (pose proof PI2_3_2; apply sin_gt_0; unfold y; lra). replace (y - u) with (phi0 + y - (phi0 + u)) in S by ring. rewrite sin_minus, !Z in S by (unfold y; lra). lra. }
  assert (hl : 0 < lam < 1) by lra. destruct (p1_range lam hl) as [[a b] e]. unfold eq27_phi1, eq29_phi3. destruct (phase_in (asin lam) phi0 s) as (x & hx & ph).
  assert (sh : forall u, sin (phi0 + (s + u)) = sin (x + u)) by (intros u; apply (at_sin phi0 s x u ph)).
  destruct (Req_dec x (asin lam)) as [-> | x1]; [ auto | ]. destruct (Req_dec x (PI + asin lam)) as [-> | x2]; [ auto | exfalso ].
  (* where the drive is the stronger there was no rest; where it is not, none ends *)
  assert (strong : ~ exists d, 0 < d /\ forall u, - d < u < 0 -> lam < Rabs (sin (x + u))).
  { intros (d & d0 & D). set (u := - Rmin (d / 2) (s - r)). assert (0 < Rmin (d / 2) (s - r)) by (apply Rmin_pos; lra). pose proof (Rmin_l (d / 2) (s - r)). pose proof (Rmin_r (d / 2) (s - r)).
    specialize (D u ltac:(unfold u; lra)). specialize (before (s + u) ltac:(unfold u; lra)). rewrite sh in before. lra. }
  assert (weak : forall c, 0 < c -> (forall u, 0 <= u < c -> Rabs (sin (x + u)) <= lam) -> False).
  { intros c c0 W. apply held. exists c. split; trivial. intros t Ht. replace t with (s + (t - s)) by ring. rewrite sh. apply W. lra. }
  assert (mirror : forall y, Rabs (sin (y + PI)) = Rabs (sin y)) by (intros y; now rewrite neg_sin, Rabs_Ropp).
  destruct (Rlt_le_dec x (PI - asin lam)) as [q | q].
  { apply strong. exists (x - asin lam). split; [ lra | ]. intros u hu. apply Rlt_le_trans with (2 := Rle_abs _). apply sin_above; lra. }
  destruct (Rlt_le_dec x (PI + asin lam)) as [q1 | q1]. { apply (weak (PI + asin lam - x)); [ lra | ]. intros u hu. apply sin_below; lra. }
  destruct (Rlt_le_dec x (2 * PI - asin lam)) as [q2 | q2].
  { apply strong. exists (x - PI - asin lam). split; [ lra | ]. intros u hu. replace (x + u) with (x + u - PI + PI) by ring. rewrite mirror. apply Rlt_le_trans with (2 := Rle_abs _). apply sin_above; lra. }
  apply (weak (2 * PI + asin lam - x)); [ lra | ]. intros u hu. replace (x + u) with (x + u - PI + PI) by ring. rewrite mirror. apply sin_below; lra.
Qed.

(* (31): a block that is at rest when the drive is at phi1 moves by (31), forward, until phitilde2, where it stops, if for a moment only. *)
Theorem eq_31 lam e phi0 w wy c phi : 0 <= lam < 1 -> slip_end lam e -> shaken lam phi0 w wy -> 0 <= c -> at_phase phi0 c (eq27_phi1 lam) ->
  w c = 0 -> wy c = 0 -> eq27_phi1 lam <= phi <= e -> let s := c + (phi - eq27_phi1 lam) in
  w s = eq31_w lam (eq27_phi1 lam) phi /\ wy s = 0 /\ (eq27_phi1 lam < phi < e -> 0 < w s).
Proof.
  intros hl E M hc ph w0 wy0 hphi s.
  assert (P : forall t, 0 < t < e - asin lam -> 0 < h lam t).
  { destruct hl as [[h0 | <-] h1]; [ apply (slip_end_is lam e ltac:(lra) E) | ]. destruct E as (E1 & _ & E3). intros t Ht. specialize (E3 (asin 0 + t) ltac:(unfold eq27_phi1 in *; lra)).
    rewrite left_h in E3. replace (asin 0 + t - asin 0) with t in E3 by ring. unfold h in *. rewrite asin_0, Rplus_0_l, cos_0 in *. pose proof (COS_bound t). lra. }
  destruct (slip_is lam phi0 w wy (proj1 hl) M c (phi - asin lam) (e - asin lam) hc ph w0 wy0) as [a b].
  - intros t Ht. destruct (Req_dec t 0) as [-> | ]; [ rewrite h_0; lra | left; apply P; lra ].
  - unfold eq27_phi1 in hphi. lra.
  - unfold s, eq27_phi1 in *. rewrite a, b. split; [ | split; [ trivial | intros; apply P; lra ] ]. unfold eq31_w, h. replace (asin lam + (phi - asin lam)) with phi by ring. ring.
Qed.

(* (32) has one smallest solution above phi1, and there each slip that begins at a rest at phi1 ends: forward before, zero at it. *)
Theorem eq_32 lam : 0 < lam < 1 -> exists e, slip_end lam e /\ (forall e', slip_end lam e' -> e' = e) /\
  forall phi0 w wy c, shaken lam phi0 w wy -> 0 <= c -> at_phase phi0 c (eq27_phi1 lam) -> w c = 0 -> wy c = 0 ->
    (forall s, c < s < c + (e - eq27_phi1 lam) -> 0 < w s) /\ w (c + (e - eq27_phi1 lam)) = 0.
Proof.
  intros hl. destruct (slip_end_exists lam hl) as [e E]. exists e. split; [ trivial | split ].
  - intros e' E'. destruct (slip_end_is lam e hl E) as (_ & z & P & _). destruct (slip_end_is lam e' hl E') as (a & z' & P' & _). destruct (slip_end_is lam e hl E) as (a0 & _). destruct (p1_range lam hl) as [b _].
    destruct (Rtotal_order e' e) as [k | [k | k]]; trivial; exfalso; [ specialize (P (e' - asin lam)) | specialize (P' (e - asin lam)) ]; lra.
  - intros phi0 w wy c M hc ph w0 wy0. pose proof E as (E1 & E2 & _). split.
    + intros s Hs. destruct (eq_31 lam e phi0 w wy c (eq27_phi1 lam + (s - c)) ltac:(lra) E M hc ph w0 wy0 ltac:(lra)) as (_ & _ & P). replace (c + (eq27_phi1 lam + (s - c) - eq27_phi1 lam)) with s in P by ring. apply P. lra.
    + destruct (eq_31 lam e phi0 w wy c e ltac:(lra) E M hc ph w0 wy0 ltac:(lra)) as (-> & _). rewrite <- E2. unfold eq31_w, eq32_left. ring.
Qed.
Lemma slip_end_near lam e x y : 0 < lam < 1 -> slip_end lam e -> asin lam < x <= 2 * PI -> asin lam < y <= 2 * PI ->
  0 < h lam (x - asin lam) -> h lam (y - asin lam) < 0 -> x < e < y.
Proof.
  intros hl E hx hy X Y. destruct (slip_end_is lam e hl E) as (A & z & P & N). destruct (p1_range lam hl) as [b _]. split; apply Rnot_le_lt; intros k.
  - destruct (Req_dec e x) as [-> | ne]; [ lra | ]. specialize (N (x - asin lam)). lra.
  - destruct (Req_dec e y) as [-> | ne]; [ lra | ]. specialize (P (y - asin lam)). lra.
Qed.
(* where the slip ends, to ten decimals *)
Theorem eq_32__digits e : (slip_end (1 / sqrt 2) e -> Rabs (e - 3.1974093073) <= 5e-11) /\ (slip_end (3 / 5) e -> Rabs (e - 3.5234549058) <= 5e-11) /\
  (slip_end (9 / 10) e -> Rabs (e - 2.4824327945) <= 5e-11).
Proof.
  assert (N : forall lam x y, 0 < lam < 1 -> slip_end lam e -> atan (lam / sqrt (1 - lam ^ 2)) < x <= 2 * PI -> atan (lam / sqrt (1 - lam ^ 2)) < y <= 2 * PI ->
    0 < h lam (x - atan (lam / sqrt (1 - lam ^ 2))) -> h lam (y - atan (lam / sqrt (1 - lam ^ 2))) < 0 -> x < e < y).
  { intros lam x y hl E. replace (lam ^ 2) with (Rsqr lam) by (unfold Rsqr; ring). rewrite <- asin_atan by lra. now apply slip_end_near. }
  repeat split; intros E; apply Rabs_le.
  - destruct (N (1 / sqrt 2) (3.1974093073 - 5e-11) (3.1974093073 + 5e-11)); trivial; try (split; interval with (i_prec 60)); [ | | lra ]; unfold h; rewrite asin_atan by (split; interval with (i_prec 60)); unfold Rsqr; interval with (i_prec 60).
  - destruct (N (3 / 5) (3.5234549058 - 5e-11) (3.5234549058 + 5e-11)); trivial; try (split; interval with (i_prec 60)); [ | | lra ]; unfold h; rewrite asin_atan by lra; unfold Rsqr; interval with (i_prec 60).
  - destruct (N (9 / 10) (2.4824327945 - 5e-11) (2.4824327945 + 5e-11)); trivial; try (split; interval with (i_prec 60)); [ | | lra ]; unfold h; rewrite asin_atan by lra; unfold Rsqr; interval with (i_prec 60).
Qed.
(* The slip ends between phi2 and phi4. *)
Theorem s22_phi2_bracket lam e : 0 < lam < 1 -> slip_end lam e -> eq28_phi2 lam < e < eq30_phi4 lam.
Proof. intros hl E. destruct (slip_end_is lam e hl E) as (A & _). unfold eq28_phi2, eq30_phi4. lra. Qed.
Theorem s22_phi2_bracket__needs_friction e : slip_end 0 e -> e = eq30_phi4 0.
Proof.
  intros (E1 & E2 & E3). unfold eq32_left, eq27_phi1, eq30_phi4 in *. rewrite asin_0, cos_0 in *. pose proof PI_RGT_0.
  destruct (Rle_lt_dec e (2 * PI)) as [k | k]. 2: { exfalso. apply (E3 (2 * PI)). lra. rewrite cos_2PI. ring. }
  destruct (Req_dec e (2 * PI)) as [ | ne]; [ lra | exfalso ]. pose proof (sin_gt_0 (e / 2) ltac:(lra) ltac:(lra)). pose proof (cos_2a_sin (e / 2)) as C.
  replace (2 * (e / 2)) with e in C by field. nra.
Qed.

(* ---- above lambda_c: (33) to (37) ---- *)
(* (34), (35), (36): each says that the slip ends before the next one, backward, begins; (35) is (34). *)
Theorem eq_34 lam e : 0 < lam < 1 -> slip_end lam e -> (eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam) < 0 <-> e < eq29_phi3 lam).
Proof.
  intros hl E. destruct (slip_end_is lam e hl E) as (A & z & P & N). pose proof PI_RGT_0. replace (eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam)) with (h lam PI).
  2: { unfold eq34_left, eq29_phi3, eq27_phi1, h. rewrite (Rplus_comm PI). ring. } unfold eq29_phi3. split; intros H0; [ apply Rnot_le_lt; intros k | apply N; lra ].
  destruct (Req_dec (e - asin lam) PI) as [q | q]; [ rewrite q in z; lra | ]. specialize (P PI). lra.
Qed.
Theorem eq_35 lam e : 0 < lam < 1 -> slip_end lam e -> eq35_left lam = eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam) /\ (eq35_left lam < 0 <-> e < eq29_phi3 lam).
Proof.
  intros hl E. assert (e0 : eq35_left lam = eq34_left lam (eq27_phi1 lam) (eq29_phi3 lam)).
  { rewrite <- h_PI by trivial. unfold eq34_left, eq29_phi3, eq27_phi1, h. rewrite (Rplus_comm PI). ring. } split; trivial. rewrite e0. now apply eq_34.
Qed.
Theorem eq_36 lam e : 0 < lam < 1 -> slip_end lam e -> (eq36_sides_2 lam < eq36_sides_1 lam <-> e < eq29_phi3 lam).
Proof.
  intros hl E. rewrite <- (proj2 (eq_35 lam e hl E)). change (eq36_sides_2 lam) with eq37_lambda_c. unfold eq36_sides_1. destruct (left_sign lam ltac:(lra)) as (c & c0 & S). split; intros; nra.
Qed.
(* (37) is the one zero of (35). *)
Theorem eq_37 lam : 0 <= lam <= 1 -> (eq35_left lam = 0 <-> lam = eq37_lambda_c) /\ (eq35_left lam < 0 <-> eq37_lambda_c < lam).
Proof. intros hl. destruct (left_sign lam hl) as (c & c0 & S). repeat split; intros; nra. Qed.
Theorem eq_37__digits : Rabs (eq37_lambda_c - 0.5370292721463151) <= 1e-16 /\ Rabs (asin eq37_lambda_c - 0.5669115049410095) <= 1e-15.
Proof.
  split; [ unfold eq37_lambda_c; interval with (i_prec 80) | ]. rewrite asin_atan by (pose proof lambda_c_between; lra). unfold Rsqr, eq37_lambda_c. interval with (i_prec 80).
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
  intros hl E q M. destruct (w33_reached lam e hl E q phi0 w wy M) as (s1 & _ & R). exists s1. intros s phi hs [n ph]. destruct (R s hs) as [-> ->]. rewrite ph, (whole_periods (w33 lam e)) by (intros; now apply w33_period).
  unfold eq29_phi3, eq27_phi1 in *. split; [ trivial | ]. assert (back : w33 lam e phi = - w33 lam e (phi - PI)) by (rewrite <- (w33_anti lam e hl E q); f_equal; ring).
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
  (phi = eq39_phi_t1 lam <-> exists W : R -> R, (forall phi0, shaken lam phi0 (fun s => W (phi0 + s)) (fun _ => 0)) /\ (forall x, W (x + PI) = - W x) /\
    W phi = 0 /\ forall x, phi < x < phi + PI -> 0 < W x).
Proof.
  intros hl hphi. pose proof PI_RGT_0. split.
  - intros ->. exists (w38 lam). split; [ | split; [ | split ] ]; intros; [ now apply w38_motion | apply w38_anti | apply w38_turn | now apply w38_pos ].
  - intros (W & M & A & z & P). assert (same : forall s, 0 <= s -> W (phi + s) = w38 lam (phi + s)).
    { intros s hs. apply (periodic_is_38 lam hl phi (fun s => W (phi + s)) (fun _ => 0) (2 * PI) (M phi)); trivial; [ lra | ]. intros u _. split; trivial. replace (phi + (u + 2 * PI)) with (phi + u + PI + PI) by ring. rewrite !A. ring. }
    pose proof (same 0 ltac:(lra)) as s0. rewrite Rplus_0_r, z in s0. symmetry in s0. apply (w38_zeros lam hl) in s0. destruct s0 as [n Hn].
    pose proof lambda_c_between. destruct (p_facts lam ltac:(lra) (proj2 hl)) as [[a b] _]. destruct (p1_range lam ltac:(lra)) as [[a1 _] _].
    assert (n = 0 \/ n = 1)%Z as [-> | ->]. { assert (-1 < IZR n < 2) as [n1 n2] by (split; nra). apply lt_IZR in n1. apply lt_IZR in n2. lia. } simpl in Hn. lra. exfalso.
    pose proof (P (phi + PI / 2) ltac:(lra)) as Q. rewrite same in Q by lra. replace (phi + PI / 2) with (eq39_phi_t1 lam + PI / 2 + PI) in Q by lra. rewrite w38_anti in Q.
    pose proof (w38_pos lam hl (eq39_phi_t1 lam + PI / 2) ltac:(lra)). lra.
Qed.
(* (40): (38) is a motion where lambda0 is lambda_c at most; below, the drive exceeds friction where (38) is zero. *)
Theorem eq_40 lam : 0 < lam -> PI * lam / 2 <= 1 -> ((forall phi0, shaken lam phi0 (fun s => w38 lam (phi0 + s)) (fun _ => 0)) <-> lam <= eq37_lambda_c) /\
  (lam < sin (eq39_phi_t1 lam) <-> eq40_sides_1 lam < eq40_sides_2 lam).
Proof.
  intros h0 h1. destruct (turn_sign lam ltac:(lra) h1) as (c & c0 & S). change (eq40_sides_2 lam) with eq37_lambda_c. unfold eq40_sides_1. split; [ | split; intros; nra ].
  split; [ | intros; apply w38_motion; lra ]. intros M. apply Rnot_lt_le. intros k. set (p := eq39_phi_t1 lam) in *. pose proof PI_RGT_0. assert (D : is_derive (g38 lam p) 0 (sin p - lam)).
  { replace (sin p - lam) with (sin (p + 0) - lam) by (rewrite Rplus_0_r; trivial). apply g_der. } assert (neg : sin p - lam < 0) by nra.
  destruct (rder_step _ _ _ (rder_of _ _ _ D) (- (sin p - lam) / 2) ltac:(lra)) as (d & d0 & St). set (u := Rmin d PI / 2). assert (0 < Rmin d PI) by (apply Rmin_pos; lra). pose proof (Rmin_l d PI). pose proof (Rmin_r d PI).
  assert (hu : 0 < u < d /\ u < PI) by (unfold u; lra). specialize (St u ltac:(lra)). rewrite Rplus_0_l in St. replace (g38 lam p 0) with 0 in St by (unfold g38; rewrite Rplus_0_r; ring). assert (wn : g38 lam p u < 0) by nra.
  assert (on : forall t, 0 <= t < PI -> w38 lam (p + t) = g38 lam p t). { intros t Ht. rewrite w38_ext. fold p. replace (p + t - p) with t by ring. now apply ext_first. }
  destruct (law lam p _ _ ltac:(lra) (M p) u ltac:(lra)) as (fx & fy & C & _ & _ & X & _). cbv beta in C, X. rewrite (on u) in C by lra. destruct (coulomb_slip _ _ _ _ _ (Rlt_le _ _ h0) C) as [Q _].
  rewrite nrm_line, Rabs_left in Q by trivial. enough (sin (p + u) + fx = sin (p + u) - lam) by nra.
  apply (rder_unique (fun s => w38 lam (p + s)) (g38 lam p) u _ _ (PI - u)); trivial; [ lra | intros s Hs; apply on; lra | apply rder_of, g_der ].
Qed.
(* (41): (38) turns forward after the drive has come to beat friction, exactly below lambda_c. *)
Theorem eq_41 lam : 0 < lam < 1 -> PI * lam / 2 <= 1 -> let p := eq39_phi_t1 lam in let p1 := eq27_phi1 lam in (eq41_sides_2 p p1 < eq41_sides_1 p p1 <-> lam < eq37_lambda_c).
Proof.
  intros hl h1 p p1. unfold eq41_sides_1, eq41_sides_2, p, p1, eq27_phi1. split; intros H; [ | apply p_facts; lra ]. apply Rnot_le_lt. intros k.
  destruct (turn_sign lam ltac:(lra) h1) as (c & c0 & S). destruct (p1_range lam hl) as [[a b] e]. assert (sin (eq39_phi_t1 lam) <= lam) by nra. pose proof PI_RGT_0.
  assert (eq39_phi_t1 lam <= PI / 2). { apply Rnot_lt_le. intros q. assert (cos (eq39_phi_t1 lam) < 0). { rewrite <- cos_PI2. apply cos_decreasing_1; try lra. unfold eq39_phi_t1. apply acos_bound. }
    unfold eq39_phi_t1 in H2. rewrite cos_acos in H2 by nra. nra. }
  pose proof (sin_increasing_1 (asin lam) (eq39_phi_t1 lam) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H). lra.
Qed.

(* ---- at large times ---- *)
Lemma units_pos mu g A0 : 0 < A0 -> 0 <= mu * g -> 0 <= eq22_lambda0 mu g A0.
Proof. intros hA h0. unfold eq22_lambda0. apply Rmult_le_pos; [ trivial | left; now apply Rinv_0_lt_compat ]. Qed.
(* With any friction the velocity across the drive tends to zero. *)
Theorem s22_vy_vanishes mu g A0 varpi t0 vx vy : 0 < mu * g -> block mu g A0 varpi t0 vx vy -> is_lim vy p_infty s22_late_vy.
Proof.
  intros h0 B. apply (across_vanishes (mu * g) (fun t => eq21_acceleration_1 A0 varpi (t0 + t)) vx vy (Rlt_le _ _ h0) B (Rabs A0 + 1)); trivial; [ pose proof (Rabs_pos A0); lra | ].
  intros t _. unfold eq21_acceleration_1. pose proof (SIN_bound (varpi * (t0 + t))). rewrite Rabs_mult, Rabs_Ropp. assert (Rabs (sin (varpi * (t0 + t))) <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos A0). nra.
Qed.
(* Without friction there is a motion that keeps its velocity across, and whose velocity along is never zero. *)
Theorem s22_vy_vanishes__needs_friction : shaken 0 0 (fun s => 2 - cos s) (fun _ => 1) /\ forall s, 0 < 2 - cos s.
Proof.
  split. 2: { intros s. pose proof (COS_bound s). lra. } rewrite shaken_sin. split; [ | intros; cont | ].
  - intros s _. apply derivable_continuous_pt. reg.
  - intros s _. exists 0, 0. split; [ split; [ lra | ring ] | ]. split; [ | eapply rder_eq; [ rd | ring ] ]. apply rder_of. auto_derive; trivial. rewrite Rplus_0_l. ring.
Qed.
(* A drive weaker than friction: after this time the block is at rest, for good. *)
Theorem s22_weak_drive_stops mu g A0 varpi t0 vx vy t : 0 < A0 < mu * g -> block mu g A0 varpi t0 vx vy -> nrm (vx 0) (vy 0) / (mu * g - A0) <= t ->
  vx t = 0 /\ vy t = 0.
Proof.
  intros h B. apply (weak_stops (mu * g) A0 _ _ vx vy ltac:(lra) B). intros u _. unfold eq21_acceleration_1, eq21_acceleration_2. rewrite nrm_line, Rabs_mult, Rabs_Ropp.
  pose proof (SIN_bound (varpi * (t0 + u))). assert (Rabs (sin (varpi * (t0 + u))) <= 1) by (apply Rabs_le; lra). rewrite (Rabs_pos_eq A0) by lra. nra.
Qed.
(* A drive that can be stronger: however late, vx reaches a size that does not depend on the motion. *)
Theorem s22_vx_stays mu g A0 varpi t0 vx vy : 0 <= mu * g < A0 -> 0 < varpi -> block mu g A0 varpi t0 vx vy ->
  let b := PI / 2 - eq27_phi1 (eq22_lambda0 mu g A0) in let c := A0 / varpi * (sin b - b * cos b) in
  0 < c /\ (forall T, exists t, T <= t /\ c <= Rabs (vx t)) /\ ~ is_lim vx p_infty 0.
Proof.
  intros h hv B b c. apply (block_units mu g A0 varpi t0 _ _ ltac:(lra) hv) in B. set (l := eq22_lambda0 mu g A0) in *. pose proof (units_pos mu g A0 ltac:(lra) (proj1 h)) as l0. fold l in l0.
  assert (l1 : l < 1) by (unfold l, eq22_lambda0; apply Rlt_div_l; lra). assert (hb : 0 < b <= PI / 2 /\ cos b = l).
  { unfold b, eq27_phi1. rewrite cos_shift, sin_asin by lra. pose proof (asin_bound_lt l ltac:(lra)). split; [ | trivial ]. destruct l0 as [l0 | <-]; [ destruct (p1_range l ltac:(lra)); lra | rewrite asin_0; pose proof PI_RGT_0; lra ]. }
  destruct hb as [hb cb]. assert (k0 : 0 < sin b - b * cos b).
  { replace 0 with (sin 0 - 0 * cos 0) by (rewrite sin_0; ring). apply (up (fun b => sin b - b * cos b) (fun b => b * sin b)); [ lra | intros; auto_derive; trivial; ring | ].
    intros y Hy. apply Rmult_lt_0_compat; [ lra | apply sin_gt_0; lra ]. }
  assert (V : 0 < A0 / varpi) by (apply Rdiv_lt_0_compat; lra). assert (c0 : 0 < c) by (unfold c; now apply Rmult_lt_0_compat).
  assert (F : forall T, exists t, T <= t /\ c <= Rabs (vx t)).
  { intros T. destruct (phase_after (eq23_phase varpi t0) (asin l) (Rmax 0 (varpi * T))) as (s & hs & ph). pose proof (Rmax_l 0 (varpi * T)). pose proof (Rmax_r 0 (varpi * T)).
    pose proof (gain l _ _ _ l0 B s (s + 2 * b) ltac:(lra)) as G. cbv beta in G. destruct (at_sin _ s _ 0 ph) as [_ c1]. rewrite !Rplus_0_r in c1. destruct (at_sin _ s _ (2 * b) ph) as [_ c2]. rewrite c1, c2 in G.
    replace (asin l + 2 * b) with (PI - asin l) in G by (unfold b, eq27_phi1; field). rewrite (cos_minus PI), cos_PI, sin_PI in G. replace (cos (asin l)) with (sin b) in G by (unfold b, eq27_phi1; apply sin_shift).
    assert (hT : forall u, 0 <= u -> T <= (s + u) / varpi) by (intros u hu; apply Rle_div_r; lra). assert (sz : forall x, eq24_w varpi x A0 = x / (A0 / varpi)) by (intros; unfold eq24_w; field; lra). rewrite !sz in G.
    rewrite <- cb in G. set (k := sin b - b * cos b) in *. set (x := vx (s / varpi)) in *. set (y := vx ((s + 2 * b) / varpi)) in *.
    destruct (Rle_lt_dec c (Rabs y)) as [q | q]. exists ((s + 2 * b) / varpi). split; [ apply hT; lra | trivial ].
    exists (s / varpi). split; [ replace s with (s + 0) by ring; apply hT; lra | ]. fold x. apply Rabs_def2 in q. replace y with (y / (A0 / varpi) * (A0 / varpi)) in q by (field; lra). apply Rle_trans with (2 := Rabs_maj2 x).
    replace x with (x / (A0 / varpi) * (A0 / varpi)) by (field; lra). unfold c in *. fold k in q |- *. set (r := A0 / varpi) in *. assert (2 * k <= y / r - x / r) by (unfold k; lra). nra. }
  split; [ trivial | split; [ trivial | ] ]. intros L. apply is_lim_spec in L. destruct (L (mkposreal c c0)) as [T HT]. destruct (F (T + 1)) as (t & ht & K). specialize (HT t ltac:(lra)). rewrite Rminus_0_r in HT. simpl in HT. lra.
Qed.
(* Friction along and across the drive while w is not zero: across it is -lambda0 wy/|w|, along it is lambda0 against w, but for (wy/w)^2/2 of it. *)
Theorem s22_friction_across lam phi0 w wy s : 0 <= lam -> shaken lam phi0 w wy -> 0 <= s -> w s <> 0 -> exists fx fy,
  rder w s (fx - eq21_acceleration_1 1 1 (phi0 + s)) /\ rder wy s (fy - eq21_acceleration_2 1 1 (phi0 + s)) /\
  Rabs (fy - s22_across_friction lam (w s) (wy s)) <= (wy s / w s) ^ 2 / 2 * Rabs (s22_across_friction lam (w s) (wy s)) /\
  Rabs (fx - - lam * (w s / Rabs (w s))) <= (wy s / w s) ^ 2 / 2 * lam.
Proof.
  intros hl M hs hw. destruct (law lam phi0 w wy hl M s hs) as (fx & fy & C & _ & _ & X & Y). exists fx, fy. destruct (coulomb_slip _ _ _ _ _ hl C) as [E F].
  pose proof (Rabs_pos_lt _ hw) as x0. destruct (nearly (Rabs (w s)) (wy s) x0) as [n1 n2]. assert (en : nrm (Rabs (w s)) (wy s) = nrm (w s) (wy s)) by (unfold nrm; now rewrite pow2_abs). rewrite en in *.
  replace ((wy s / Rabs (w s)) ^ 2) with ((wy s / w s) ^ 2) in n2 by (unfold Rdiv; rewrite !Rpow_mult_distr, <- !Rinv_pow, pow2_abs by lra; trivial).
  set (q := (wy s / w s) ^ 2) in *. set (n := nrm (w s) (wy s)) in *. set (x := Rabs (w s)) in *. assert (n0 : 0 < n) by lra.
  assert (small : Rabs (x / n - 1) <= q / 2). { assert (x / n <= 1) by (apply Rle_div_l; lra). assert (1 - q / 2 <= x / n) by (apply Rle_div_r; trivial). apply Rabs_le; lra. }
  unfold s22_across_friction, eq21_acceleration_1, eq21_acceleration_2. replace (sqrt (w s ^ 2)) with x by (unfold x; rewrite <- (pow2_abs (w s)), sqrt_pow2; trivial; apply Rabs_pos).
  split; [ eapply rder_eq; [ exact X | rewrite Rmult_1_l; ring ] | split; [ eapply rder_eq; [ exact Y | ring ] | split ] ].
  - replace (fy - - lam * wy s / x) with ((x / n - 1) * (- lam * wy s / x)). rewrite Rabs_mult. apply Rmult_le_compat_r; [ apply Rabs_pos | trivial ].
    replace fy with (- lam * wy s / n) by (rewrite <- F; field; lra). field; lra.
  - replace (fx - - lam * (w s / x)) with ((x / n - 1) * (- lam * (w s / x))). rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; trivial.
    rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq lam) by trivial. unfold Rdiv. rewrite Rabs_mult, Rabs_inv. fold x. rewrite Rabs_Rabsolu || idtac. replace (Rabs x) with x by (symmetry; apply Rabs_pos_eq; lra). right. field. lra.
    replace fx with (- lam * w s / n) by (rewrite <- E; field; lra). field; lra.
Qed.
(* Whatever the two starts, and at every friction but none: the difference of the two vx tends to zero. *)
Theorem s22_attractor_ignores_vy lam phi0 w wy u uy : 0 < lam -> shaken lam phi0 w wy -> shaken lam phi0 u uy -> is_lim (fun s => w s - u s) p_infty 0 /\
  (w 0 = u 0 -> w 0 <> 0 -> forall d, 0 < d -> (forall s, 0 <= s < d -> w s = u s) -> Rabs (wy 0) = Rabs (uy 0)).
Proof.
  intros h0 M N. split.
  - assert (same : (exists s1, forall s, s1 <= s -> w s = u s) -> is_lim (fun s => w s - u s) p_infty 0).
    { intros [s1 S]. apply is_lim_spec. intros eps. exists s1. intros s hs. rewrite S by lra. replace (u s - u s - 0) with 0 by ring. rewrite Rabs_R0. apply cond_pos. }
    destruct (Rle_lt_dec lam eq37_lambda_c) as [k | k].
    { destruct (w38_attracts lam ltac:(lra) phi0 w wy M) as [X _]. destruct (w38_attracts lam ltac:(lra) phi0 u uy N) as [Y _].
      apply (is_lim_ext (fun s => (w s - w38 lam (phi0 + s)) - (u s - w38 lam (phi0 + s)))). intros; ring. replace 0 with (0 - 0) by ring. now apply is_lim_minus'. }
    apply same. destruct (Rlt_le_dec lam 1) as [k1 | k1].
    + destruct (slip_end_exists lam ltac:(lra)) as [e E]. assert (q : e < eq29_phi3 lam) by (apply (eq_36 lam e ltac:(lra) E); exact k).
      destruct (w33_reached lam e ltac:(lra) E q phi0 w wy M) as (s1 & _ & R). destruct (w33_reached lam e ltac:(lra) E q phi0 u uy N) as (s2 & _ & R').
      exists (Rmax s1 s2). intros s hs. pose proof (Rmax_l s1 s2). pose proof (Rmax_r s1 s2). rewrite (proj1 (R s ltac:(lra))), (proj1 (R' s ltac:(lra))). trivial.
    + destruct (all_stop lam phi0 w wy k1 M) as (s1 & _ & R). destruct (all_stop lam phi0 u uy k1 N) as (s2 & _ & R').
      exists (Rmax s1 s2). intros s hs. pose proof (Rmax_l s1 s2). pose proof (Rmax_r s1 s2). rewrite (proj1 (R s ltac:(lra))), (proj1 (R' s ltac:(lra))). trivial.
  - intros e0 hw d hd S. destruct (law lam phi0 w wy ltac:(lra) M 0 ltac:(lra)) as (fx & fy & C & _ & _ & X & _). destruct (law lam phi0 u uy ltac:(lra) N 0 ltac:(lra)) as (gx & gy & D & _ & _ & Y & _).
    assert (e : sin (phi0 + 0) + fx = sin (phi0 + 0) + gx) by (apply (rder_unique w u 0 _ _ d); trivial; intros s Hs; apply S; lra). assert (e1 : fx = gx) by lra.
    destruct (coulomb_slip _ _ _ _ _ (Rlt_le _ _ h0) C) as [E _]. destruct (coulomb_slip _ _ _ _ _ (Rlt_le _ _ h0) D) as [F _]. rewrite <- e0, <- e1 in F.
    pose proof (nrm_sq (w 0) (wy 0)) as n1. pose proof (nrm_sq (w 0) (uy 0)) as n2. assert (fx <> 0) by (intros z; rewrite z in E; apply hw; nra).
    assert (en : nrm (w 0) (wy 0) = nrm (w 0) (uy 0)) by (apply (Rmult_eq_reg_r fx); [ lra | trivial ]). rewrite en in n1. apply Rsqr_eq_abs_0. rewrite !Rsqr_pow2. lra.
Qed.
