(* Under the pulses every motion of the plane has rests for ever if the friction is above the width eta, and else ceases to. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General HalfPeriod Drawn Line Pulses Formulas Periodic Analysis.
Open Scope R_scope.

Section Pulsed.
Variables (eta l p : R) (vx vy : R -> R).
Hypothesis he : 0 < eta < 1. Hypothesis h0 : 0 < l. Hypothesis M : moves l (pulse eta) p vx vy.
(* at rest for a while friction holds the particle *)
Lemma rest_in_gap s d : l < 1 -> 0 <= s -> 0 < d -> (forall t, s <= t <= s + d -> vx t = 0) -> pulse eta (p + s) = 0.
Proof.
  intros l1 Hs Hd Z. destruct (m_law _ _ _ _ _ M s Hs) as (fx & fy & [B _] & X & _).
  pose proof (rder_unique _ _ _ _ X (rder_zero vx s d Hd ltac:(intros; apply Z; lra))) as e.
  destruct (pulse_size eta (p + s)) as [k | k]; [ now apply abs_zero, Req_le | ]. pose proof (pow2_ge_0 fy). replace fx with (- pulse eta (p + s)) in
      B by lra.
  rewrite <- (pow2_abs (- _)), Rabs_Ropp, k in B. nra.
Qed.
(* until the next pulse *)
Lemma rest_till n s : IZR n * PI + eta * PI <= p + s < (IZR n + 1) * PI -> 0 <= s -> vx s = 0 -> vy s = 0 ->
  vx ((IZR n + 1) * PI - p) = 0 /\ vy ((IZR n + 1) * PI - p) = 0.
Proof.
  intros Hn Hs e1 e2. pose proof PI_RGT_0. assert (0 < eta * PI) by now apply Rmult_lt_0_compat. apply sq_sum. replace 0 with (vx s ^ 2 + vy s ^ 2)
      by (rewrite e1, e2; ring).
  apply (rder_decr (fun t => vx t ^ 2 + vy t ^ 2)); [ lra | | ]; intros u Hu.
  - cont; [ apply (m_cx _ _ _ _ _ M) | apply (m_cy _ _ _ _ _ M) ]; lra.
  - destruct (m_law _ _ _ _ _ M u ltac:(lra)) as (fx & fy & [_ P] & X & Y). eexists. split; [ rd | ]. simpl.
    assert (z : pulse eta (p + u) = 0).
    { unfold pulse. rewrite (ext_on PI _ H n) by lra. destruct Rlt_dec as [k | k]; [ exfalso; unfold eq42_end in k; lra | unfold eq42_cases_2; ring
        ]. }
    rewrite z. pose proof (nrm_pos (vx u) (vy u)). nra.
Qed.
Theorem rests_above : (forall t1, exists s d, t1 <= s /\ 0 < d /\ forall t, s <= t <= s + d -> vx t = 0 /\ vy t = 0) <-> eq46_lambda_c eta < l.
Proof.
  unfold eq46_lambda_c. pose proof PI_RGT_0 as pi. assert (ep : 0 < eta * PI < PI) by nra. split.
  - intros R. apply Rnot_le_lt. intros k. destruct (w_below_late l eta) as (A & L & w0 & P); try lra. set (W := w_below l eta) in *. set (b :=
      right_periodic_small_friction_start l eta) in *.
    assert (eb : b = PI * (eta - l) / 2) by reflexivity.
    assert (next : forall t1, exists s, t1 <= s /\ 0 <= s /\ vx s = 0 /\ vy s = 0 /\ exists n, p + s = (IZR n + 1) * PI).
    { intros t1. destruct (R (Rmax 0 t1)) as (s & d & Hs & Hd & Z). pose proof (Rmax_l 0 t1). pose proof (Rmax_r 0 t1).
      pose proof (rest_in_gap s d ltac:(lra) ltac:(lra) Hd ltac:(intros; now apply Z)) as g. destruct (per_spec 0 PI pi (p + s)) as [n Hn].
      assert (q : IZR n * PI + eta * PI <= p + s).
      { apply Rnot_lt_le. intros q. unfold pulse in g. rewrite (ext_on PI _ pi n) in g by lra. unfold eq42_end, eq42_cases_1 in g.
        destruct Rlt_dec; [ destruct (sg_cases n) as [e | e]; rewrite e in g; lra | lra ]. }
      destruct (rest_till n s ltac:(lra) ltac:(lra)) as [e1 e2]; try (apply Z; lra). exists ((IZR n + 1) * PI - p). split; [ lra | split; [ lra |
          split; [ trivial | split; [ trivial | ] ] ] ].
      exists n. ring. }
    assert (size : forall n, Rabs (W ((IZR n + 1) * PI)) = Rabs (W PI)).
    { intros n. rewrite <- (shift_Z PI (fun t => Rabs (W t)) ltac:(intros t; cbv beta; now rewrite A, Rabs_Ropp) n). do 2 f_equal. ring. }
    assert (D := proj1 (late_drawn _ _ _ L p vx vy M)). destruct (Req_dec l eta) as [e | e].
    + destruct (next 0) as (s & _ & Hs & e1 & e2 & n & Hn). assert (ws : W (p + s) = 0).
      { apply abs_zero. rewrite Hn, size, <- (Rplus_0_l PI), A, Rabs_Ropp. replace 0 with b at 1 by (rewrite eb, e; field). rewrite w0, Rabs_R0. lra.
          }
      destruct (R s) as (s' & d & Hs' & Hd & Z). enough (eq46_lambda_c eta < l) by (unfold eq46_lambda_c in *; lra).
      apply (proj1 (eq_46 eta l W he h0 L)). exists (p + s'), d. split; trivial. intros t Ht. destruct (Z (t - p) ltac:(lra)) as [z1 z2].
      pose proof (contraction l _ _ _ _ _ _ ltac:(lra) M (late_moves _ _ _ L p) s (t - p) ltac:(lra)) as C. cbv beta in C. replace (p + (t - p)) with
          t in C by ring.
      rewrite e1, e2, ws, z1, z2 in C. nra.
    + assert (wp : 0 < W PI) by (apply P; rewrite eb; nra).
      destruct (lim_near _ _ _ D wp) as (T & _ & HT). destruct (next T) as (s & Ts & _ & e1 & _ & n & Hn). specialize (HT s Ts). rewrite e1, Hn in HT.
      specialize (size n). rewrite (Rabs_pos_eq (W PI)) in size by lra. unfold Rabs in size. destruct Rcase_abs; lra.
  - intros k t1. assert (G : exists W r, caught l (pulse eta) W /\ (forall t, W (t + 2 * PI) = W t) /\ eta * PI <= r < PI /\ forall t, r <= t <= PI
      -> W t = 0).
    { destruct (Rlt_le_dec l 1) as [l1 | l1].
      - destruct (w44_late l eta ltac:(lra) l1) as (_ & L & C). destruct (w44_cases l eta ltac:(lra) l1) as (a1 & a2 & _ & _ & Z).
        exists (w44 l eta), (eta * PI / l). split; [ trivial | split; [ apply L | split; [ lra | exact Z ] ] ].
      - exists (fun _ => 0), (eta * PI). split; [ now apply pulses_still | split; [ trivial | split; [ lra | trivial ] ] ]. }
    destruct G as (W & r & C & T & hr & Z). destruct (C p vx vy M) as (t2 & _ & E). destruct (per_spec (r - p) (2 * PI) ltac:(lra) (Rmax t1 t2)) as
        [n Hn].
    pose proof (Rmax_l t1 t2). pose proof (Rmax_r t1 t2). exists (r - p + (IZR n + 1) * (2 * PI)), (PI - r). split; [ lra | split; [ lra | ] ].
        intros t Ht.
    destruct (E t ltac:(lra)) as [-> ->]. split; trivial. rewrite <- (shift_Z (2 * PI) W T (n + 1)), plus_IZR. apply Z. lra.
Qed.
End Pulsed.
(* without friction a motion is an integral of the drive: the pulses have one *)
Lemma pulse_integral eta : 0 < eta < 1 -> exists H, forall phi, continuity_pt H phi /\ rder H phi (pulse eta phi).
Proof.
  intros he. pose proof PI_RGT_0 as pi. set (c := eta * PI). assert (c0 : 0 < c < PI) by (unfold c; nra).
  pose (g := glue c (fun t => t - c / 2) (fun _ => c / 2)). exists (ext PI g). intros phi.
  assert (M : moves 0 (pulse eta) (phi - 1) (fun t => ext PI g (phi - 1 + t)) (fun _ => 0)).
  { apply half_arc; [ lra | trivial | apply pulse_anti | unfold g; rewrite glue_r, glue_l by lra; field | apply arc_glue; [ lra | .. | field ] ];
      (split; intros t Ht; [ | exists 0; destruct (pulse_on eta t ltac:(lra)) as [P1 P0] ]).
    - unfold Rdiv. cont.
    - rewrite P1 by (unfold c in *; lra). unfold dry. repeat split; try lra. eapply rder_eq; [ unfold Rdiv; rd | ring ].
    - cont.
    - rewrite P0 by (unfold c in *; lra). unfold dry. repeat split; try lra. eapply rder_eq; [ rd | ring ]. }
  assert (E : forall s, ext PI g (phi - 1 + (s - (phi - 1))) = ext PI g s) by (intros; f_equal; ring). split.
  - apply (continuity_pt_ext _ _ _ E), (cont_shift (fun t => ext PI g (phi - 1 + t)) (phi - 1)), (m_cx _ _ _ _ _ M). lra.
  - destruct (m_law _ _ _ _ _ M (phi - (phi - 1)) ltac:(lra)) as (fx & fy & [B _] & X & _). pose proof (pow2_ge_0 fy). pose proof (pow2_ge_0 fx).
    apply rder_shift in X. eapply rder_eq; [ exact (rder_ext _ _ _ _ (fun s _ => E s) X) | ]. cbv beta. replace (phi - 1 + (phi - (phi - 1))) with
        phi by ring. nra.
Qed.
