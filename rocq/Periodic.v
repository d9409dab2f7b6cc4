(* Section 2.3: any periodic drive h along a line in place of the sine; trains of pulses. moves, late, caught, rests, restless are
   defined in Periodic/Drawn.v, pulse in Periodic/Pulses.v. l is lambda0, the friction over the largest drive. *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis General Drawn Line Median Mean Generic Steps Share Pulses HalfPeriod Formulas.
Open Scope R_scope.

(* Under pulses of any width between 0 and 1 and any friction there is a motion of the drive's period to which all are drawn. *)
Theorem pulses_at_large_times eta l : 0 < eta < 1 -> 0 < l -> exists W, late l (pulse eta) W.
Proof.
  intros he h0. destruct (Rle_lt_dec l eta) as [k | k]; [ exists (w_below l eta); apply w_below_late; lra | ].
  destruct (Rlt_le_dec l 1); [ exists (w44 l eta); apply w44_late; lra | exists (fun _ => 0); now apply pulses_still ].
Qed.

Lemma late_eq l h W U : late l h W -> late l h U -> W = U.
Proof. intros A B. apply functional_extensionality. now apply (late_unique l h). Qed.
Ltac pulsed T eta l := let W := fresh "W" in let HW := fresh "HW" in intros T; destruct (pulses_at_large_times eta l) as [W HW]; [ lra | lra
  | refine (T eta l W _ _ HW); unfold eq46_lambda_c; lra ].

(* (44): with the friction between eta and 1 the motion at large times is this, and every motion of the plane, from any phase of the drive
   on, is equal to it from some time on. *)
Theorem eq_44 eta l W : 0 < eta < 1 -> eq46_lambda_c eta < l < 1 -> late l (pulse eta) W ->
  (forall ph, 0 <= ph <= eq44_ends_1 l eta -> W ph = eq44_cases_1 l eta ph) /\
  (forall ph, eq44_ends_1 l eta <= ph <= eq44_ends_2 l eta -> W ph = eq44_cases_2 l eta ph) /\
  (forall ph, eq44_ends_2 l eta <= ph <= PI -> W ph = eq44_cases_3 l eta ph) /\ caught l (pulse eta) W.
Proof.
  unfold eq46_lambda_c. intros he hl HW. destruct (w44_late l eta) as (_ & L & C); try lra.
  destruct (w44_cases l eta) as (_ & _ & C1 & C2 & C3); try lra.
  rewrite (late_eq _ _ _ _ HW L). auto.
Qed.
Lemma eq_44__occurs : ltac:(occurs eq_44).
Proof. pulsed T (1/3) (1/2). Qed.
(* Up to eta it passes through 0 without rest, at the phase PI (eta - lambda0) / 2, and goes forward for half a period from there. *)
Theorem eq_44__below eta l W : 0 < eta < 1 -> 0 < l <= eq46_lambda_c eta -> late l (pulse eta) W ->
  let b := right_periodic_small_friction_start l eta in
  (forall ph, b <= ph <= right_periodic_small_friction_ends_1 eta -> W ph = right_periodic_small_friction_cases_1 l eta ph) /\
  (forall ph, right_periodic_small_friction_ends_1 eta <= ph < right_periodic_small_friction_ends_2 eta ->
    W ph = right_periodic_small_friction_cases_2 l eta ph) /\
  (forall ph, right_periodic_small_friction_ends_2 eta <= ph < PI + b -> W ph = right_periodic_small_friction_cases_3 l eta ph) /\
  W b = 0 /\ forall ph, b < ph < PI + b -> 0 < W ph.
Proof.
  unfold eq46_lambda_c. intros he hl HW. destruct (w_below_late l eta) as (_ & L & Z & P); try lra.
  destruct (below_cases l eta) as (C1 & C2 & C3); try lra.
  rewrite (late_eq _ _ _ _ HW L). auto.
Qed.
Lemma eq_44__below__occurs : ltac:(occurs eq_44__below).
Proof. pulsed T (1/2) (1/3). Qed.

(* (45): half a period later the motion at large times is its own opposite, for every friction. *)
Theorem eq_45 eta l W : 0 < eta < 1 -> 0 < l -> late l (pulse eta) W -> forall ph, W (PI + ph) = eq45_w (W ph).
Proof.
  unfold eq45_w. intros he h0 HW ph. rewrite Rplus_comm. destruct (Rle_lt_dec l eta) as [k | k]; [ | destruct (Rlt_le_dec l 1) as [k1 | k1] ].
  - destruct (w_below_late l eta) as (A & L & _); try lra. rewrite (late_eq _ _ _ _ HW L). apply A.
  - destruct (w44_late l eta) as (A & L & _); try lra. rewrite (late_eq _ _ _ _ HW L). apply A.
  - rewrite (late_eq _ _ _ _ HW (proj1 (pulses_still l eta he k1))). ring.
Qed.
Lemma eq_45__occurs : ltac:(occurs eq_45).
Proof. intros H. destruct (pulses_at_large_times (1/3) (1/2)) as [W HW]; try lra. refine (H (1/3) (1/2) W _ _ HW 0); lra. Qed.

(* (46): the motion at large times has an interval of rest exactly where the friction exceeds lambda_c = eta. *)
Theorem eq_46 eta l W : 0 < eta < 1 -> 0 < l -> late l (pulse eta) W -> ((exists s d, 0 < d /\ forall t, s <= t <= s + d ->
  W t = 0) <-> eq46_lambda_c eta < l).
Proof.
  unfold eq46_lambda_c. intros he h0 HW. pose proof PI_RGT_0. split.
  - intros (s & d & hd & Z). apply Rnot_le_lt. intros k. destruct (w_below_late l eta) as (A & L & _ & P); try lra.
    rewrite (late_eq _ _ _ _ HW L) in Z.
    set (b := right_periodic_small_friction_start l eta) in *. destruct (per_spec b PI H s) as [n Hn].
    assert (U : exists u, s <= u <= s + d /\ b + IZR n * PI < u < b + (IZR n + 1) * PI).
    { exists (s + Rmin d (b + (IZR n + 1) * PI - s) / 2). unfold Rmin. destruct Rle_dec; lra. }
    destruct U as (u & U1 & U2). specialize (Z u U1). rewrite (a_shift PI _ A u n) in Z. specialize (P (u - IZR n * PI) ltac:(lra)).
    destruct (sg_cases n) as [e | e]; rewrite e in Z; lra.
  - intros k. destruct (Rlt_le_dec l 1) as [k1 | k1].
    + destruct (w44_late l eta) as (_ & L & _); try lra. destruct (w44_cases l eta) as (e0 & e1 & _ & _ & C); try lra.
      rewrite (late_eq _ _ _ _ HW L).
      exists (eta * PI / l), (PI - eta * PI / l). split; [ lra | ]. intros t Ht. apply C. lra.
    + exists 0, 1. rewrite (late_eq _ _ _ _ HW (proj1 (pulses_still l eta he k1))). split; auto with real.
Qed.
Lemma eq_46__occurs : ltac:(occurs eq_46).
Proof. pulsed T (1/3) (1/2). Qed.

(* Very large friction: under every drive of the size 1 at most, with the friction above that, every motion of the plane comes to rest within
   the time v0 / (lambda0 - 1), and stays. *)
Theorem s23_rest_above_one h l p vx vy : (forall t, Rabs (h t) <= s23_rest_sides_1 l) -> s23_rest_sides_1 l < s23_rest_sides_2 l ->
  moves l h p vx vy -> forall t, nrm (vx 0) (vy 0) / (l - 1) <= t -> vx t = 0 /\ vy t = 0.
Proof.
  unfold s23_rest_sides_1, s23_rest_sides_2. intros hh hl M. apply (weak_stops l 1 _ _ vx vy ltac:(lra) M). intros t _.
  rewrite nrm_x, Rabs_Ropp. apply hh.
Qed.
Lemma s23_rest_above_one__occurs : ltac:(occurs s23_rest_above_one).
Proof.
  intros H. destruct (pulses_at_large_times (1/3) 2) as [W HW]; try lra. refine (H (pulse (1/3)) 2 0 _ _ _ _ (late_moves _ _ _ HW 0) _ (Rle_refl _));
    unfold s23_rest_sides_1, s23_rest_sides_2; [ | lra ].
  intros t. destruct (pulse_size (1/3) t); lra.
Qed.

(* Every generic drive has a least friction lambda_c, between 0 and 1, above which each motion of the plane has rest and motion in every late
   period, up to friction as strong as the drive, and another friction below which no motion has rests at large times. Between the two the
   behaviour may change: under the drive step_drive there is no rest at 1/8, rest at 1/5, none at 1/2, and rest again above its lambda_c. *)
Theorem s23_threshold_exists : (forall h, generic h -> exists lc, 0 < lc < 1 /\ (forall l, lc < l < 1 -> has_rests l h s23_rests_2) /\
    (forall x, 0 <= x -> (forall l, x < l < 1 -> has_rests l h s23_rests_2) -> lc <= x) /\
    exists l0, 0 < l0 <= lc /\ forall l, 0 < l < l0 -> has_rests l h s23_rests_1) /\
  (generic step_drive /\ has_rests (1 / 8) step_drive s23_rests_1 /\ has_rests (1 / 5) step_drive s23_rests_2 /\
    has_rests (1 / 2) step_drive s23_rests_1).
Proof. exact (conj threshold (conj steps_generic (conj steps_none (conj steps_some steps_none_again)))). Qed.
(* It needs a drive that is smaller than its largest size for some time: otherwise there is no rest at any friction below 1. *)
Theorem s23_threshold_exists__needs_smaller h l : (forall t, Rabs (h t) = s23_largest) -> 0 <= l < s23_largest -> has_rests l h s23_rests_1.
Proof. exact (fun hh hl => unsteady_none h l ltac:(intros t; rewrite hh; apply hl) (proj1 hl)). Qed.
Lemma s23_threshold_exists__needs_smaller__occurs : ltac:(occurs s23_threshold_exists__needs_smaller).
Proof. intros H. apply (H (fun _ => 1) 0); unfold s23_largest; intros; rewrite ?Rabs_R1; lra. Qed.
(* And it needs a drive that does not vanish at the median of its antiderivative: under this one there is rest at every friction. *)
Theorem s23_threshold_exists__needs_median : normalised halting /\ (exists t, Rabs (halting t) < 1) /\ mean halting = 0 /\
  forall l, 0 < l < 1 -> has_rests l halting s23_rests_2.
Proof.
  pose proof PI_RGT_0. split; [ | split; [ | split; [ | exact halting_rests ] ] ]; [ apply three_normalised | exists (PI / 4)
    | apply three_mean ]; try lra; try (rewrite Rabs_R0; lra).
  unfold halting. rewrite (proj2 (proj2 (three_first (PI / 8) (PI / 4) 0 ltac:(lra) (PI / 4)))), Rabs_R0; lra.
Qed.
(* Where friction is below the size of the mean of the drive the particle is driven away for ever. *)
Theorem s23_threshold_exists__with_mean h l p vx vy : normalised h -> 0 <= l < Rabs (mean h) -> moves l h p vx vy ->
  is_lim (fun t => Rabs (vx t)) p_infty p_infty.
Proof.
  intros N hl M. apply is_lim_spec. intros x. assert (S : exists s, (s = 1 \/ s = -1) /\ s * mean h = Rabs (mean h)).
  { unfold Rabs. destruct Rcase_abs; [ exists (-1) | exists 1 ]; split; auto; ring. }
  destruct S as (s & hs & e). destruct (below_the_mean h N s l p vx vy x hs ltac:(lra) M) as (t1 & _ & B). exists t1. intros t Ht.
  specialize (B t ltac:(lra)).
  destruct hs as [-> | ->]; revert B; unfold Rabs; destruct Rcase_abs; lra.
Qed.
Lemma s23_threshold_exists__with_mean__occurs : ltac:(occurs s23_threshold_exists__with_mean).
Proof.
  intros H. assert (m : mean (fun _ => 1) = 1) by (unfold mean; rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; pose proof PI_RGT_0;
    field; lra).
  assert (N : normalised (fun _ => 1)) by (split; [ trivial | intros t; apply cont_rcont; cont | intros; apply ex_RInt_const | | intros l Hl;
    exists 0 ]; rewrite Rabs_R1; lra || auto with real).
  destruct (has_a_motion _ N (1 / 2) 0) as (vx & vy & M); [ lra | ]. refine (H (fun _ => 1) (1 / 2) 0 vx vy N _ M). rewrite m, Rabs_R1. lra.
Qed.

(* For a drive of the size 1 at single instants only the part of each late period for which the particle rests, from whatever start, tends to
   the whole period as the friction tends to 1. *)
Theorem s23_mostly_at_rest h eps : normalised h -> full_at_instants h -> 0 < eps -> exists l0, l0 < 1 /\ forall l, l0 < l < 1 ->
  forall p vx vy, moves l h p vx vy -> exists t1, forall t, t1 <= t ->
  rests_for (fun t => nrm (vx t) (vy t)) t (t + 2 * PI) (2 * PI * (s23_late_share - eps)).
Proof. exact (fun N F he => mostly_at_rest h N F eps he). Qed.
Lemma s23_mostly_at_rest__occurs : ltac:(occurs s23_mostly_at_rest).
Proof. intros H. exact (H sin 1 sine_normalised sine_full Rlt_0_1). Qed.

(* The condition of (44), as corrected: the motion at large times vanishes before the drive, which is 0 from eta PI on, becomes nonzero again, at
   PI, exactly where lambda0 > eta. *)
Theorem s23_nonzero_again eta l W : 0 < eta < 1 -> 0 < l < 1 -> late l (pulse eta) W ->
  (forall ph, eta * PI <= ph < PI -> right_periodic_nonzero_again (pulse eta ph) = 0) /\
  (forall ph, PI <= ph < PI + eta * PI -> right_periodic_nonzero_again (pulse eta ph) <> 0) /\
  ((exists ph, eta * PI <= ph < PI /\ W ph = 0) <-> eq46_lambda_c eta < l).
Proof.
  unfold right_periodic_nonzero_again, eq46_lambda_c. intros he hl HW. pose proof PI_RGT_0. assert (0 < eta * PI < PI) by (split; nra).
  split; [ intros ph Hph; apply pulse_on; lra | split ].
  - intros ph Hph. replace ph with (ph - PI + PI) by ring. rewrite pulse_anti, (proj1 (pulse_on eta (ph - PI) ltac:(lra))) by lra. lra.
  - split.
    + intros (ph & Hph & Z). apply Rnot_le_lt. intros k. destruct (w_below_late l eta) as (_ & L & _ & P); try lra.
      rewrite (late_eq _ _ _ _ HW L) in Z.
      specialize (P ph). unfold right_periodic_small_friction_start in P. specialize (P ltac:(nra)). lra.
    + intros k. destruct (w44_late l eta) as (_ & L & _); try lra. destruct (w44_cases l eta) as (e0 & e1 & _ & _ & C); try lra.
      exists (eta * PI / l). rewrite (late_eq _ _ _ _ HW L). split; [ lra | apply C; lra ].
Qed.
Lemma s23_nonzero_again__occurs : ltac:(occurs s23_nonzero_again).
Proof. pulsed T (1/3) (1/2). Qed.
(* It is not the friction: the particle still slides in the gap, up to eta PI / lambda0, or, with the friction at most eta, all through it, and
   friction gives it the rate - lambda0 there, not 0. *)
Theorem s23_nonzero_again__printed eta l W ph : 0 < eta < 1 -> 0 < l < 1 -> late l (pulse eta) W ->
  eta * PI <= ph < PI -> ph < eq44_ends_2 l eta -> 0 < W ph /\
  pulse eta ph = 0 /\ rder W ph (pulse eta ph + Formulas.s23_nonzero_again (- l)) /\ Formulas.s23_nonzero_again (- l) <> 0.
Proof.
  unfold Formulas.s23_nonzero_again, eq44_ends_2. intros he hl HW gap slides.
  pose proof PI_RGT_0. assert (0 < eta * PI) by nra. assert (Z : pulse eta ph = 0) by (apply pulse_on; lra). rewrite Z.
  enough (K : 0 < W ph /\ exists f d, 0 < d /\ (forall s, ph <= s < ph + d -> f s = W s) /\ is_derive f ph (- l)).
  { destruct K as (P & f & d & d0 & same & D). split; trivial. split; [ trivial | split; [ | lra ] ]. rewrite Rplus_0_l.
    apply (rder_loc W f ph _ d d0); [ intros; auto | trivial ]. }
  destruct (Rle_lt_dec l eta) as [k | k].
  - destruct (w_below_late l eta) as (_ & L & _ & P); try lra. destruct (below_cases l eta) as (_ & C & _); try lra.
    rewrite (late_eq _ _ _ _ HW L). unfold right_periodic_small_friction_start in P. split. apply P. nra.
    exists (right_periodic_small_friction_cases_2 l eta), (PI - ph). split; [ lra | split ].
    + intros s Hs. symmetry. apply C. lra.
    + unfold right_periodic_small_friction_cases_2. auto_derive; trivial. ring.
  - destruct (w44_cases l eta) as (e0 & e1 & _ & C & _); try lra. destruct (w44_late l eta) as (_ & L & _); try lra.
    rewrite (late_eq _ _ _ _ HW L). split.
    + rewrite C by lra. unfold eq44_cases_2. apply (Rmult_lt_compat_l l) in slides; [ | lra ].
      replace (l * (eta * PI / l)) with (eta * PI) in slides by (field; lra). lra.
    + exists (eq44_cases_2 l eta), (eta * PI / l - ph). split; [ lra | split ].
      * intros s Hs. symmetry. apply C. lra.
      * unfold eq44_cases_2. auto_derive; trivial. ring.
Qed.
Lemma s23_nonzero_again__printed__occurs : ltac:(occurs s23_nonzero_again__printed).
Proof.
  intros H. destruct (pulses_at_large_times (1/3) (1/2)) as [W HW]; try lra. pose proof PI_RGT_0.
  refine (H (1/3) (1/2) W (1/3 * PI) _ _ HW _ _); unfold eq44_ends_2; lra.
Qed.

(* The largest size of the pulses is 1 at every width above 0. *)
Theorem s23_pulses_normalised eta : 0 < eta <= 1 -> (forall t, Rabs (pulse eta t) <= s23_largest) /\ exists t, Rabs (pulse eta t) = s23_largest.
Proof.
  unfold s23_largest. intros he. pose proof PI_RGT_0. split; [ intros t; destruct (pulse_size eta t); lra | ]. exists 0.
  rewrite (proj1 (pulse_on eta 0 ltac:(lra))) by nra. apply Rabs_R1.
Qed.
(* At the width 0, the paper's example, there is no pulse. *)
Theorem s23_pulses_normalised__needs_width t : pulse 0 t = 0.
Proof. destruct (pulse_cases 0 t) as (n & s & hs & ->). rewrite (proj2 (pulse_on 0 s hs)) by lra. ring. Qed.

(* The two extremes. Width 1: lambda_c is 1, and for no friction below 1 does any motion ever rest. Width 0: lambda_c is 0, and with any
   friction every motion is at rest from v0 / lambda0 on. *)
Theorem s23_pulse_phases : (eq46_lambda_c 1 = 1 /\ forall l p vx vy, 0 <= l < 1 -> moves l (pulse 1) p vx vy ->
    forall s d, 0 <= s -> 0 < d -> exists t, s <= t <= s + d /\ nrm (vx t) (vy t) <> 0) /\
  (eq46_lambda_c 0 = 0 /\ forall l p vx vy, 0 < l -> moves l (pulse 0) p vx vy -> forall t, nrm (vx 0) (vy 0) / l <= t -> vx t = 0 /\ vy t = 0).
Proof.
  split; (split; [ reflexivity | ]); intros l p vx vy hl M.
  - intros s d hs hd. apply Classical_Prop.NNPP. intros no. assert (R : Rabs (pulse 1 (p + s)) <= l).
    { apply (rest_held l _ p vx vy s d); trivial; [ lra | ]. intros u Hu. apply Classical_Prop.NNPP. intros n. apply no. eauto. }
    destruct (pulse_cases 1 (p + s)) as (n & r & hr & e). rewrite e, (proj1 (pulse_on 1 r hr)) in R by lra.
    apply Rabs_le_between in R. destruct (sg_cases n) as [q | q]; rewrite q in R; lra.
  - intros t Ht. apply (weak_stops l 0 _ _ vx vy ltac:(lra) M); [ | now rewrite Rminus_0_r ]. clear t Ht. intros t _.
    rewrite nrm_x, s23_pulses_normalised__needs_width, Ropp_0, Rabs_R0. lra.
Qed.
(* Without friction what moves goes on at the width 0. *)
Theorem s23_pulse_phases__needs_friction : moves 0 (pulse 0) 0 (fun _ => 1) (fun _ => 0).
Proof.
  split; [ intros; cont | intros; cont | intros t _ ]. exists 0, 0. split; [ split; ring_simplify; lra | ].
  rewrite s23_pulses_normalised__needs_width. split; (eapply rder_eq; [ rd | ring ]).
Qed.
