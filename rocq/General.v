(* Section 2, a particle on a rough plane that has any acceleration: (1), (2) and the four general properties, of every motion. *)
Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
From Slipbook Require Export Analysis Contraction Straight.
From Slipbook.General Require Import Exists.
Open Scope R_scope.

(* (1): while the particle slips its velocity relative to the plane has the printed rate; (Ax, Ay) is the plane's acceleration. *)
Theorem eq_1 mu g Ax Ay vx vy : 0 <= mu * g -> motion (mu * g) Ax Ay vx vy -> forall t, 0 <= t -> nrm (vx t) (vy t) <> 0 ->
  rder vx t (eq1_velocity_rate_1 (Ax t) (Ay t) mu g (vx t) (vy t)) /\ rder vy t (eq1_velocity_rate_2 (Ax t) (Ay t) mu g (vx t) (vy t)).
Proof. exact (slip_rates (mu * g) Ax Ay vx vy). Qed.
(* (1) is said in the plane's frame: where in the laboratory friction alone acts, the velocity relative to the plane is a motion. *)
Theorem eq_1__laboratory k Ax Ay Ux Uy Vx Vy :
  (forall t, 0 < t -> continuity_pt Ux t /\ continuity_pt Uy t /\ continuity_pt Vx t /\ continuity_pt Vy t) ->
  (forall t, 0 <= t -> rder Ux t (Ax t) /\ rder Uy t (Ay t)) ->
  (forall t, 0 <= t -> exists fx fy, coulomb k (Vx t - Ux t) (Vy t - Uy t) fx fy /\ rder Vx t fx /\ rder Vy t fy) ->
  motion k Ax Ay (fun t => Vx t - Ux t) (fun t => Vy t - Uy t).
Proof.
  intros C U V. split. 1, 2: intros t Ht; destruct (C t Ht) as (? & ? & ? & ?); cont.
  intros t Ht. destruct (U t Ht). destruct (V t Ht) as (fx & fy & B & X & Y). exists fx, fy. repeat split; try apply B; rd.
Qed.
(* (2): while it slips its speed has the printed rate. *)
Theorem eq_2 mu g Ax Ay vx vy : 0 <= mu * g -> motion (mu * g) Ax Ay vx vy -> forall t, 0 <= t -> nrm (vx t) (vy t) <> 0 ->
  rder (fun s => nrm (vx s) (vy s)) t (eq2_speed_rate (Ax t) (Ay t) mu g (vx t) (vy t)).
Proof. exact (speed_rate (mu * g) Ax Ay vx vy). Qed.

(* A drive of size a, at most, below mu g: the speed falls until the particle is at rest, at the time v0 / (mu g - a) at the latest,
   and it stays there. *)
Theorem s2_stops_if_weak mu g a Ax Ay vx vy : motion (mu * g) Ax Ay vx vy -> a < s2_stops_below mu g -> (forall t,
  0 <= t -> nrm (Ax t) (Ay t) <= a) ->
  (forall s t, 0 <= s < t -> nrm (vx s) (vy s) <> 0 -> nrm (vx t) (vy t) < nrm (vx s) (vy s)) /\
  forall t, nrm (vx 0) (vy 0) / (s2_stops_below mu g - a) <= t -> vx t = 0 /\ vy t = 0.
Proof.
  unfold s2_stops_below. intros M ha HA. assert (a0 : 0 <= a) by (pose proof (nrm_pos (Ax 0) (Ay 0)); specialize (HA 0 (Rle_refl 0)); lra). split.
  - intros s t Hst N. pose proof (nrm_pos (vx s) (vy s)). destruct (Req_dec (nrm (vx t) (vy t)) 0) as [-> | z]; [ lra | ].
    pose proof (weak_falls (mu * g) a Ax Ay vx vy ltac:(lra) M HA s t ltac:(lra) z). nra.
  - apply (weak_stops (mu * g) a Ax Ay vx vy); trivial. lra.
Qed.
(* If at times as late as one likes the drive is above mu g, the particle is not at rest for ever: after each time it moves again. *)
Theorem s2_no_permanent_rest mu g Ax Ay vx vy : 0 <= mu * g -> motion (mu * g) Ax Ay vx vy ->
  (forall T, exists t, T <= t /\ s2_rest_ends_above mu g < nrm (Ax t) (Ay t)) -> forall T, exists t, T <= t /\ nrm (vx t) (vy t) <> 0.
Proof.
  intros hk M H T. destruct (H (Rmax 0 T)) as (t & Ht & K). unfold s2_rest_ends_above in K. pose proof (Rmax_l 0 T). pose proof (Rmax_r 0 T).
  destruct (Req_dec (nrm (vx t) (vy t)) 0) as [z | z]; [ | exists t; split; [ lra | trivial ] ].
  destruct (rest_rates _ _ _ _ _ hk M t ltac:(lra) z) as (lx & ly & _ & _ & N & b). pose proof (nrm_add (lx + Ax t) (ly + Ay t) (- lx) (- ly)) as c.
  replace (lx + Ax t + - lx) with (Ax t) in c by ring. replace (ly + Ay t + - ly) with (Ay t) in c by ring.
  replace (nrm (- lx) (- ly)) with (nrm lx ly) in c by (unfold nrm; f_equal; ring).
  destruct (rder_falls _ _ _ (rder_opp _ _ _ N)) as (d & d0 & Hd). lra. exists (t + d / 2). split. lra. specialize (Hd (d / 2) ltac:(lra)).
  cbv beta in Hd. lra.
Qed.
(* A motion obeys its law at each moment. Where the law is asked for only between single moments the printed statement fails: a drive that is above
   mu g at
   single moments, however late, leaves the particle at rest. *)
Theorem s2_no_permanent_rest__needs_a_stretch : exists A : R -> R, (forall T, exists t, T <= t /\ s2_rest_ends_above 1 1 < A t) /\
  forall t, (forall n : Z, t <> IZR n) -> exists fx fy, coulomb (1 * 1) 0 0 fx fy /\ rder (fun _ => 0) t (fx - A t) /\ rder (fun _ => 0) t (fy - 0).
Proof.
  exists (fun t => if Req_EM_T t (IZR (Int_part t)) then 2 else 0). split.
  - intros T. destruct (nat_above T) as [n Hn]. rewrite INR_IZR_INZ in Hn. exists (IZR (Z.of_nat n)). split. lra. destruct Req_EM_T as [e | N].
    unfold s2_rest_ends_above. lra.
    exfalso. apply N. f_equal. unfold Int_part. rewrite <- (tech_up (IZR (Z.of_nat n)) (Z.of_nat n + 1)); rewrite ?plus_IZR; try lra. lia.
  - intros t Ht. exists 0, 0. split. { split; rewrite ?nrm_0; lra. } destruct Req_EM_T as [e | N]. { exfalso. exact (Ht _ e). }
    split; (eapply rder_eq; [ rd | ring ]).
Qed.
(* A drive of fixed direction (ex, ey) that stays above mu g by a margin delta: from some time T on the speed grows at delta / 2, at least. *)
Theorem s2_speeds_up_if_strong mu g ex ey a delta vx vy : 0 <= mu * g -> ex ^ 2 + ey ^ 2 = 1 -> motion (mu * g) (fun t => a t * ex) (fun t => a t *
  ey) vx vy ->
  0 < delta -> (forall t, 0 <= t -> s2_speeds_up_above mu g + delta <= a t) ->
  exists T, 0 <= T /\ forall s t, T <= s <= t -> nrm (vx s) (vy s) + delta / 2 * (t - s) <= nrm (vx t) (vy t).
Proof.
  intros hk He M hd hA. unfold s2_speeds_up_above in hA. assert (He' : (- ex) ^ 2 + (- ey) ^ 2 = 1) by lra.
  assert (N : motion (mu * g) (fun t => - a t) (fun _ => 0) (fun t => - ex * vx t + - ey * vy t) (fun t => - ex * vy t - - ey * vx t)).
  { apply (motion_turned (- ex) (- ey) _ (fun t => a t * ex) (fun t => a t * ey)); trivial; intros t; cbv beta;
    [ transitivity (- a t * (ex ^ 2 + ey ^ 2)); [ rewrite He | ] | ]; ring. }
  destruct (speeds_up (mu * g) (fun t => - a t) _ _ hk N delta hd) as (T & T0 & HT).
  { intros t Ht. specialize (hA t Ht). lra. } exists T. split; trivial. intros s t Hst. specialize (HT s t Hst). now rewrite !nrm_turned in HT.
Qed.
(* Without a margin it fails: a drive along a fixed line, above mu g = 1 at all times, and a motion that loses speed for ever. *)
Theorem s2_speeds_up_if_strong__needs_a_margin : exists a vx vy, (forall t, 0 <= t -> s2_speeds_up_above 1 1 < a t /\ continuity_pt a t) /\
  motion (1 * 1) (fun t => a t * - 1) (fun t => a t * 0) vx vy /\ forall s t, 0 <= s < t -> nrm (vx t) (vy t) < nrm (vx s) (vy s).
Proof.
  destruct no_margin as (a & u & w & a1 & ca & [c d L] & F). exists a, u, w. split. { intros t Ht. unfold s2_speeds_up_above. rewrite Rmult_1_l.
  auto. } split; [ | exact F ]. rewrite Rmult_1_l. split; trivial.
  intros t Ht. destruct (L t Ht) as (fx & fy & C & X & Y). exists fx, fy. split; trivial. split; (eapply rder_eq; [ eassumption | ring ]).
Qed.
(* A drive of fixed direction (ex, ey): the velocity across it, w, never grows in size, and falls as long as it is not 0;
   if the drive is bounded, w -> 0. *)
Theorem s2_perpendicular_decays mu g ex ey a vx vy : 0 < mu * g -> ex ^ 2 + ey ^ 2 = 1 -> motion (mu * g) (fun t => a t * ex) (fun t => a t * ey) vx
  vy ->
  let w t := ex * vy t - ey * vx t in
  (forall s t, 0 <= s < t -> Rabs (w t) <= Rabs (w s) /\ (w s <> 0 -> 0 < s2_across_trend * (Rabs (w t) - Rabs (w s)))) /\
  ((exists b, forall t, 0 <= t -> Rabs (a t) <= b) -> is_lim w p_infty s2_across_limit).
Proof.
  intros hk He M w. assert (hk' := Rlt_le _ _ hk).
  assert (N : motion (mu * g) a (fun _ => 0) (fun t => ex * vx t + ey * vy t) w).
  { apply (motion_turned ex ey _ (fun t => a t * ex) (fun t => a t * ey)); trivial; intros t; cbv beta; [ transitivity (a t * (ex ^ 2 + ey ^ 2));
    [ rewrite He | ] | ]; ring. }
  split. intros s t Hst. split.
  - apply Rsqr_le_abs_0. unfold Rsqr. pose proof (across_falls _ _ _ _ hk' N s t ltac:(lra)). lra.
  - intros Nz. unfold s2_across_trend. enough (Rabs (w t) < Rabs (w s)) by lra. apply Rsqr_lt_abs_0. unfold Rsqr.
    pose proof (across_falls_strictly _ _ _ _ hk' N s t hk Hst Nz). lra.
  - intros [b Hb]. unfold s2_across_limit. apply (across_vanishes _ _ _ _ hk' N (Rabs b + 1)); trivial. pose proof (Rabs_pos b); lra.
    intros t Ht. specialize (Hb t Ht). pose proof (Rle_abs b). lra.
Qed.
(* Without friction the velocity across the drive stays as it is. *)
Theorem s2_perpendicular_decays__needs_friction a vx vy : motion 0 a (fun _ => 0) vx vy -> forall t, 0 <= t -> vy t = vy 0.
Proof.
  intros M t Ht. apply rder_const; trivial. intros; apply (m_cy _ _ _ _ _ M); lra. intros s Hs.
  destruct (m_law _ _ _ _ _ M s ltac:(lra)) as (fx & fy & [B _] & _ & Y). eapply rder_eq. exact Y.
  assert (fy = 0) by (pose proof (pow2_ge_0 fx); nra). lra.
Qed.

(* The motions of which these theorems speak exist. *)
Lemma plane_steady k ax ay vx0 vy0 : 0 <= k -> exists vx vy, motion k (fun _ => ax) (fun _ => ay) vx vy /\ vx 0 = vx0 /\ vy 0 = vy0.
Proof. intros hk. apply plane_has_a_motion; trivial. intros. split; cont. Qed.
(* every start has one motion, and no other *)
Theorem plane_one_motion k Ax Ay vx0 vy0 : 0 <= k -> (forall t, 0 <= t -> continuity_pt Ax t /\ continuity_pt Ay t) ->
  exists vx vy, (motion k Ax Ay vx vy /\ vx 0 = vx0 /\ vy 0 = vy0) /\
  forall ux uy, motion k Ax Ay ux uy -> ux 0 = vx0 -> uy 0 = vy0 -> forall t, 0 <= t -> ux t = vx t /\ uy t = vy t.
Proof.
  intros hk C. destruct (plane_has_a_motion k Ax Ay vx0 vy0 hk C) as (vx & vy & M & e1 & e2). exists vx, vy. split; auto.
  intros ux uy N f1 f2. apply (uniqueness k Ax Ay ux uy vx vy hk N M); congruence.
Qed.
Lemma nrm_1 x : nrm x 1 <> 0. Proof. intros e. destruct (nrm_zero _ _ e). lra. Qed.
Lemma eq_1__occurs : ltac:(occurs eq_1).
Proof.
  intros H. destruct (plane_steady (1 * 1) 2 0 0 1) as (vx & vy & M & e1 & e2). lra. refine (H 1 1 _ _ vx vy _ M 0 _ _); try lra. rewrite e2.
  apply nrm_1.
Qed.
Lemma eq_1__laboratory__occurs : ltac:(occurs eq_1__laboratory).
Proof.
  intros H. destruct (plane_steady 1 2 0 0 1) as (vx & vy & [c d M] & _). lra.
  assert (cl : forall t, continuity_pt (fun t => 2 * t) t) by (intros; cont).
  assert (c0 : forall t, continuity_pt (fun _ : R => 0) t) by (intros; cont).
  refine (H 1 (fun _ => 2) (fun _ => 0) (fun t => 2 * t) (fun _ => 0) (fun t => vx t + 2 * t) vy _ _ _).
  - intros t Ht. specialize (c t Ht). repeat split; auto. cont.
  - intros t Ht. split; (eapply rder_eq; [ rd | ring ]).
  - intros t Ht. destruct (M t Ht) as (fx & fy & C & X & Y). exists fx, fy. split.
    + replace (vx t + 2 * t - 2 * t) with (vx t) by ring. rewrite Rminus_0_r. exact C.
    + split; (eapply rder_eq; [ rd | ring ]).
Qed.
Lemma eq_2__occurs : ltac:(occurs eq_2).
Proof.
  intros H. destruct (plane_steady (1 * 1) 2 0 0 1) as (vx & vy & M & e1 & e2). lra. refine (H 1 1 _ _ vx vy _ M 0 _ _); try lra. rewrite e2.
  apply nrm_1.
Qed.
Lemma s2_stops_if_weak__occurs : ltac:(occurs s2_stops_if_weak).
Proof.
  intros H. destruct (plane_steady (1 * 1) (1 / 2) 0 0 1) as (vx & vy & M & _). lra. refine (H 1 1 (1 / 2) _ _ vx vy M _ _). unfold s2_stops_below.
  lra.
  intros t _. apply nrm_le; lra.
Qed.
(* witness: the drive 2 sin t *)
Lemma s2_no_permanent_rest__occurs : ltac:(occurs s2_no_permanent_rest).
Proof.
  intros H. destruct (plane_has_a_motion (1 * 1) (fun t => 2 * sin t) (fun _ => 0) 0 1) as (vx & vy & M & _). lra. { intros t _.
  split; [ reg | cont ]. }
  refine (H 1 1 _ _ vx vy _ M _ 0). lra. intros T. destruct (nat_above T) as [n Hn]. exists (PI / 2 + 2 * INR n * PI).
  pose proof PI2_1. pose proof (pos_INR n). split. nra. rewrite sin_period, sin_PI2, nrm_x0; unfold s2_rest_ends_above; lra.
Qed.
Lemma s2_speeds_up_if_strong__occurs : ltac:(occurs s2_speeds_up_if_strong).
Proof.
  intros H. destruct (plane_steady (1 * 1) (2 * 1) (2 * 0) 0 1) as (vx & vy & M & _). lra. refine (H 1 1 1 0 (fun _ => 2) 1 vx vy _ _ M _ _); try lra.
  intros. unfold s2_speeds_up_above. lra.
Qed.
Lemma s2_perpendicular_decays__occurs : ltac:(occurs s2_perpendicular_decays).
Proof. intros H. destruct (plane_steady (1 * 1) (2 * 1) (2 * 0) 0 1) as (vx & vy & M & _). lra. refine (H 1 1 1 0 (fun _ => 2) vx vy _ _ M); lra. Qed.
Lemma s2_perpendicular_decays__needs_friction__occurs : ltac:(occurs s2_perpendicular_decays__needs_friction).
Proof. intros H. destruct (plane_steady 0 1 0 0 1) as (vx & vy & M & _). lra. exact (H (fun _ => 1) vx vy M 0 (Rle_refl 0)). Qed.
