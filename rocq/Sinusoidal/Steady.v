(* 2.2: from lambda_c on there is the motion (33), with its rests *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic.
Open Scope R_scope.

Lemma up f f' a b : a < b -> (forall c, a <= c <= b -> is_derive f c (f' c)) -> (forall c, a < c < b -> 0 < f' c) -> f a < f b.
Proof.
  intros H D P. destruct (MVT_cor2 f f' a b H) as (c & E & Hc). { intros; now apply is_derive_Reals, D. }
  specialize (P c Hc). nra.
Qed.

Section Steady.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Let p1 := asin l.
Definition h t := - l * t + cos p1 - cos (p1 + t).
Lemma p1_range : 0 < p1 < PI / 2 /\ sin p1 = l.
Proof.
  assert (e : sin p1 = l) by (unfold p1; apply sin_asin; lra). assert (b : - (PI / 2) < p1 < PI / 2) by (unfold p1; apply asin_bound_lt; lra).
  repeat split; trivial; try lra. apply Rnot_le_lt. intros k. pose proof (sin_incr_1 p1 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). rewrite sin_0 in *. lra.
Qed.
Lemma h_der t : is_derive h t (sin (p1 + t) - l).
Proof. unfold h. auto_derive; trivial. ring. Qed.
Lemma sin_above x : p1 < x < PI - p1 -> l < sin x.
Proof.
  destruct p1_range as [[a b] e]. intros H. rewrite <- e. destruct (Rle_lt_dec x (PI / 2)).
  - apply sin_increasing_1; lra.
  - rewrite <- (sin_PI_x x). apply sin_increasing_1; lra.
Qed.
Lemma sin_below x : PI - p1 <= x <= PI + p1 -> Rabs (sin x) <= l.
Proof.
  destruct p1_range as [[a b] e]. intros H. rewrite <- e. replace (sin x) with (sin (PI - x)) by apply sin_PI_x.
  apply Rabs_le. rewrite <- sin_neg. split; apply sin_incr_1; lra.
Qed.
Lemma h_up t : 0 < t <= PI - 2 * p1 -> 0 < h t.
Proof.
  intros H. replace 0 with (h 0) by (unfold h; rewrite Rplus_0_r; ring).
  apply (up h (fun t => sin (p1 + t) - l)); [ lra | intros; apply h_der | ]. intros c Hc. pose proof (sin_above (p1 + c)). lra.
Qed.
Lemma h_down s t : PI - 2 * p1 <= s < t -> t <= PI -> h t < h s.
Proof.
  intros H1 H2. apply Ropp_lt_cancel. apply (up (fun t => - h t) (fun t => - (sin (p1 + t) - l))); [ lra | | ].
  - intros c Hc. apply (is_derive_opp h), h_der.
  - intros c Hc. destruct p1_range as [[a b] e]. enough (sin (p1 + c) < l) by lra.
    rewrite <- e. rewrite <- (sin_PI_x (p1 + c)). apply sin_increasing_1; lra.
Qed.
(* (34) to (37): the slip ends within half a period *)
Lemma h_PI : h PI < 0 <-> eq37_lambda_c < l.
Proof.
  pose proof (eq36 l ltac:(lra)) as K. destruct p1_range as [[a b] e]. unfold h. rewrite Rplus_comm, neg_cos.
  assert (c : cos p1 = sqrt (1 - l ^ 2)). { unfold p1. rewrite cos_asin by lra. f_equal. unfold Rsqr. ring. }
  rewrite c, <- K. split; intros; lra.
Qed.

(* (32): its end, unique; s22-phi2-bracket *)
Theorem eq32 : eq37_lambda_c < l -> exists tau, PI - 2 * p1 < tau < PI /\ h tau = 0 /\ forall t, 0 < t < tau -> 0 < h t.
Proof.
  intros H. apply h_PI in H. destruct p1_range as [[a b] e]. pose proof PI_RGT_0. pose proof (h_up (PI - 2 * p1) ltac:(lra)) as u.
  assert (C : continuity h) by (intros x; apply derivable_continuous_pt; exists (sin (p1 + x) - l); apply is_derive_Reals, h_der).
  destruct (IVT_cor h (PI - 2 * p1) PI C ltac:(lra) ltac:(nra)) as [z [z1 z2]].
  assert (z <> PI - 2 * p1) by (intros ->; lra). assert (z <> PI) by (intros ->; lra). exists z. repeat split; try lra. intros t Ht.
  destruct (Rle_lt_dec t (PI - 2 * p1)). apply h_up; lra. rewrite <- z2. apply h_down; lra.
Qed.

(* (33): slip from phi1 to the end, rest, and the same with the other sign half a period later *)
Definition g33 tau t := if Rlt_dec t tau then h t else 0.
Theorem eq33 : eq37_lambda_c < l -> exists tau, 0 < tau < PI /\ h tau = 0 /\
  motion l (fun t => - sin (p1 + t)) (fun _ => 0) (ext PI (g33 tau)) (fun _ => 0) /\
  (forall t, tau <= t < PI -> ext PI (g33 tau) t = 0) /\ (forall t, 0 < t < tau -> 0 < ext PI (g33 tau) t).
Proof.
  intros H. destruct (eq32 H) as (tau & h1 & h2 & h3). destruct p1_range as [[a b] e]. pose proof PI_RGT_0.
  assert (C : forall x, continuity_pt h x) by (intros x; apply derivable_continuous_pt; exists (sin (p1 + x) - l); apply is_derive_Reals, h_der).
  assert (h0 : h 0 = 0) by (unfold h; rewrite Rplus_0_r; ring).
  assert (on : forall t, 0 <= t < PI -> ext PI (g33 tau) t = g33 tau t).
  { intros t Ht. rewrite (ext_on PI (g33 tau) PI_RGT_0 0) by (simpl; lra). unfold sg; simpl. rewrite Rmult_1_l. f_equal. ring. }
  exists tau. split; [ lra | ]. split; [ trivial | ]. split; [ | split ].
  2: { intros t Ht. rewrite on by lra. unfold g33. destruct (Rlt_dec t tau); trivial; lra. }
  2: { intros t Ht. rewrite on by lra. unfold g33. destruct (Rlt_dec t tau); [ apply h3; lra | lra ]. }
  apply half_period; trivial.
  - intros t. replace (p1 + (t + PI)) with (p1 + t + PI) by ring. rewrite neg_sin. ring.
  - unfold g33. destruct (Rlt_dec PI tau); [ lra | ]. destruct (Rlt_dec 0 tau); [ rewrite h0; ring | lra ].
  - intros t Ht. destruct (total_order_T t tau) as [[k | ->] | k].
    + apply (cont_glue _ h h t (tau - t)); trivial; [ lra | | ]; intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra.
    + apply (cont_glue _ h (fun _ => 0) tau 1); trivial; [ lra | | | cont ]; intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; try lra.
      replace s with tau by lra. auto.
    + apply (cont_glue _ (fun _ => 0) (fun _ => 0) t (t - tau)); [ lra | | | cont | cont ]; intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra.
  - intros t Ht. unfold g33 at 1. destruct (Rlt_dec t tau).
    + exists (- l). assert (0 <= h t) by (destruct (Req_dec t 0) as [-> | ]; [ lra | left; apply h3; lra ]). split.
      * split; [ nra | ]. unfold nrm. replace (h t ^ 2 + 0 ^ 2) with (Rsqr (h t)) by (unfold Rsqr; ring). rewrite sqrt_Rsqr by trivial. ring.
      * apply (rder_loc _ h t _ (tau - t)); [ lra | intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra | ].
        replace (- l - - sin (p1 + t)) with (sin (p1 + t) - l) by ring. apply h_der.
    + exists (- sin (p1 + t)). split.
      * pose proof (sin_below (p1 + t) ltac:(lra)) as B. apply Rabs_le_between in B. split; [ nra | ]. unfold nrm. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. rewrite sqrt_0. ring.
      * apply (rder_loc _ (fun _ => 0) t _ 1); [ lra | intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra | ].
        replace (- sin (p1 + t) - - sin (p1 + t)) with 0 by ring. auto_derive; trivial.
Qed.
End Steady.
