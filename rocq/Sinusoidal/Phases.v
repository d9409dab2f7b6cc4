(* 2.2: whatever the velocity and the phase at the start: (38) and (33) as functions of the phase *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic Steady Steady2 Pulse Aniso AttractPlane Reached.
Open Scope R_scope.

Lemma motion_later k Ax Ay vx vy c : 0 <= c -> motion k Ax Ay vx vy -> motion k (fun t => Ax (t + c)) (fun t => Ay (t + c)) (fun t => vx (t + c)) (fun t => vy (t + c)).
Proof.
  intros hc [cx cy L]. assert (S : forall f t, f = (fun t => t + c) -> continuity_pt f t) by (intros f t ->; cont). split.
  - intros t Ht. apply (continuity_pt_comp (fun t => t + c) vx). now apply S. apply cx. lra.
  - intros t Ht. apply (continuity_pt_comp (fun t => t + c) vy). now apply S. apply cy. lra.
  - intros t Ht. destruct (L (t + c)) as (fx & fy & C & [F [X1 X2]] & [G [Y1 Y2]]); [ lra | ]. exists fx, fy. split; [ trivial | split ].
    + exists (fun t => F (t + c)). split. replace (fx - Ax (t + c)) with (1 * (fx - Ax (t + c))) by ring. apply (is_derive_comp F (fun t => t + c)). exact X1. auto_derive; trivial; ring. intros s Hs. apply X2. lra.
    + exists (fun t => G (t + c)). split. replace (fy - Ay (t + c)) with (1 * (fy - Ay (t + c))) by ring. apply (is_derive_comp G (fun t => t + c)). exact Y1. auto_derive; trivial; ring. intros s Hs. apply Y2. lra.
Qed.
Lemma lim_later f c : is_lim (fun t => f (t + c)) p_infty 0 -> is_lim f p_infty 0.
Proof.
  intros H. apply is_lim_spec. apply is_lim_spec in H. intros eps. destruct (H eps) as [T HT]. exists (T + c). intros t Ht. specialize (HT (t - c) ltac:(lra)).
  replace (t - c + c) with t in HT by ring. exact HT.
Qed.
(* a whole number of periods after the start the drive is at the phase p *)
Lemma next_phase p ph : exists n, 0 <= p + IZR n * (2 * PI) - ph.
Proof.
  pose proof PI_RGT_0. destruct (per_spec p (2 * PI) ltac:(lra) ph) as [n Hn]. exists (n + 1)%Z. rewrite plus_IZR. lra.
Qed.
Lemma sin_Z x n : sin (x + IZR n * (2 * PI)) = sin x.
Proof.
  rewrite <- (shift_Z (2 * PI) sin) with (n := n) (t := x + IZR n * (2 * PI)). f_equal. ring. intros t. rewrite <- (sin_period t 1). f_equal. simpl. ring.
Qed.
Lemma start_at k p ph n vx vy : 0 <= p + IZR n * (2 * PI) - ph -> motion k (fun t => - sin (ph + t)) (fun _ => 0) vx vy ->
  motion k (fun t => - sin (p + t)) (fun _ => 0) (fun t => vx (t + (p + IZR n * (2 * PI) - ph))) (fun t => vy (t + (p + IZR n * (2 * PI) - ph))).
Proof.
  intros hn M. destruct (motion_later _ _ _ _ _ _ hn M) as [cx cy L]. split; trivial. intros t Ht. destruct (L t Ht) as (fx & fy & C & X & Y). exists fx, fy.
  split; [ trivial | split; trivial ]. eapply rder_eq; [ exact X | ]. f_equal. f_equal. rewrite <- (sin_Z (p + t) n). f_equal. ring.
Qed.

Definition w38 l ph := ext PI (g38 l (eq39_phi1 l)) (ph - eq39_phi1 l).
Theorem eq38_is_the_large_time_motion l ph vx vy : 0 < l < eq37_lambda_c -> motion l (fun t => - sin (ph + t)) (fun _ => 0) vx vy ->
  is_lim (fun t => vx t - w38 l (ph + t)) p_infty 0 /\ is_lim vy p_infty 0.
Proof.
  intros hl M. set (p := eq39_phi1 l). destruct (next_phase p ph) as [n Hn]. destruct (eq38_attracts l _ _ hl (start_at _ p ph n vx vy Hn M)) as [X Y]. fold p in X. set (c := p + IZR n * (2 * PI) - ph) in *.
  split; apply (lim_later _ c); [ | exact Y ]. apply (is_lim_ext (fun t => vx (t + c) - ext PI (g38 l p) t)); trivial. intros t. f_equal. unfold w38. fold p.
  pose proof PI_RGT_0. rewrite <- (shift_Z (2 * PI) (ext PI (g38 l p))) with (n := n) (t := ph + (t + c) - p). f_equal. unfold c. ring. intros s. now apply ext_period.
Qed.
Definition w33 l tau ph := ext PI (g33 l tau) (ph - asin l).
Theorem eq33_is_the_large_time_motion l : eq37_lambda_c < l < 1 -> exists tau, 0 < tau < PI /\ h l tau = 0 /\ forall ph vx vy,
  motion l (fun t => - sin (ph + t)) (fun _ => 0) vx vy -> exists t1, forall t, t1 <= t -> vx t = w33 l tau (ph + t) /\ vy t = 0.
Proof.
  intros hl. pose proof lambda_c_between. destruct (eq33_reached l ltac:(lra) ltac:(lra)) as (tau & h0 & h1 & _ & _ & R). exists tau. split; [ trivial | split; [ trivial | ] ]. intros ph vx vy M.
  destruct (next_phase (asin l) ph) as [n Hn]. destruct (R _ _ (start_at _ (asin l) ph n vx vy Hn M)) as (t1 & _ & E). set (c := asin l + IZR n * (2 * PI) - ph) in *.
  exists (t1 + c). intros t Ht. destruct (E (t - c)) as [e1 e2]; [ lra | ]. replace (t - c + c) with t in * by ring. rewrite e1. split; trivial. unfold w33.
  pose proof PI_RGT_0. rewrite <- (shift_Z (2 * PI) (ext PI (g33 l tau))) with (n := n) (t := ph + t - asin l). f_equal. unfold c. ring. intros s. now apply ext_period.
Qed.
(* s22-attractor-ignores-vy: two motions of whatever start have the same large-time vx; s22-vy-vanishes *)
Theorem s22_attractor_ignores_vy l ph vx vy ux uy : 0 < l < 1 -> l <> eq37_lambda_c ->
  motion l (fun t => - sin (ph + t)) (fun _ => 0) vx vy -> motion l (fun t => - sin (ph + t)) (fun _ => 0) ux uy -> is_lim (fun t => vx t - ux t) p_infty 0.
Proof.
  intros hl ne M N. destruct (Rlt_le_dec l eq37_lambda_c) as [k | k].
  - destruct (eq38_is_the_large_time_motion l ph vx vy ltac:(lra) M) as [X _]. destruct (eq38_is_the_large_time_motion l ph ux uy ltac:(lra) N) as [Y _].
    apply (is_lim_ext (fun t => (vx t - w38 l (ph + t)) - (ux t - w38 l (ph + t)))). intros; ring. replace 0 with (0 - 0) by ring. now apply is_lim_minus'.
  - destruct (eq33_is_the_large_time_motion l ltac:(lra)) as (tau & _ & _ & R). destruct (R ph vx vy M) as [t1 E1]. destruct (R ph ux uy N) as [t2 E2].
    apply is_lim_spec. intros eps. exists (Rmax t1 t2). intros t Ht. pose proof (Rmax_l t1 t2). pose proof (Rmax_r t1 t2). destruct (E1 t ltac:(lra)) as [-> _]. destruct (E2 t ltac:(lra)) as [-> _].
    match goal with |- Rabs ?x < _ => replace x with 0 by ring end. rewrite Rabs_R0. apply cond_pos.
Qed.
