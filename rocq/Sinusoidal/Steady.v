(* The slip from rest at the phase phi1 = asin l, where it ends and what lambda_c has to do with it; the steady motions (33), with rests, and (38),
   without. Times are counted from the start of the forward slip; motions come by half_period from half of their period. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas Pieces Periodic.
Open Scope R_scope.

Lemma up f f' a b : a < b -> (forall c, a <= c <= b -> is_derive f c (f' c)) -> (forall c, a < c < b -> 0 < f' c) -> f a < f b.
Proof.
  intros H D P. destruct (MVT_cor2 f f' a b H) as (c & E & Hc). { intros; now apply is_derive_Reals, D. }
  specialize (P c Hc). nra.
Qed.
Lemma cos_2PI_minus x : cos (2 * PI - x) = cos x. Proof. rewrite cos_minus, cos_2PI, sin_2PI. ring. Qed.
Lemma sin_2PI_minus x : sin (2 * PI - x) = - sin x. Proof. rewrite sin_minus, cos_2PI, sin_2PI. ring. Qed.
Lemma sin_2PI_plus x : sin (x + 2 * PI) = sin x. Proof. rewrite <- (sin_period x 1). f_equal. simpl. ring. Qed.
Lemma cos_2PI_plus x : cos (x + 2 * PI) = cos x. Proof. rewrite <- (cos_period x 1). f_equal. simpl. ring. Qed.

(* ---- lambda_c ---- *)
Lemma lambda_c_is : 0 < eq37_lambda_c < 1 /\ (4 + PI ^ 2) * eq37_lambda_c ^ 2 = 4.
Proof.
  unfold eq37_lambda_c. pose proof PI_RGT_0. assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra).
  assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (apply pow2_sqrt; nra). split; [ split | ].
  - apply Rdiv_lt_0_compat; lra.
  - apply Rlt_div_l; trivial. nra.
  - set (r := sqrt (4 + PI ^ 2)) in *. rewrite <- S2. field. lra.
Qed.
Lemma lambda_c_between : 0 < eq37_lambda_c < 1. Proof. apply lambda_c_is. Qed.
(* the left side of (35) has the sign of lambda_c - l *)
Lemma left_sign l : 0 <= l <= 1 -> exists c, 0 < c /\ eq35_left l * c = eq37_lambda_c - l.
Proof.
  intros H. destruct lambda_c_is as [b e]. pose proof PI_RGT_0. unfold eq35_left. assert (Q : 0 <= sqrt (1 - l ^ 2)) by apply sqrt_pos.
  assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (apply pow2_sqrt; nra). set (q := sqrt (1 - l ^ 2)) in *. set (L := eq37_lambda_c) in *.
  assert (0 <= PI * l) by nra. assert (P : 0 < 2 * q + PI * l). { destruct H as [[h | <-] _]; [ nra | ]. assert (q <> 0) by (intros z; rewrite z in Q2; lra). lra. }
  assert (D : 0 < (4 + PI ^ 2) * (L + l)) by nra. exists ((2 * q + PI * l) / ((4 + PI ^ 2) * (L + l))). split; [ now apply Rdiv_lt_0_compat | ].
  apply (Rmult_eq_reg_r ((4 + PI ^ 2) * (L + l))); [ | lra ].
  transitivity ((2 * q) ^ 2 - (PI * l) ^ 2); [ field; nra | ]. rewrite Rpow_mult_distr, Q2.
  replace ((L - l) * ((4 + PI ^ 2) * (L + l))) with ((4 + PI ^ 2) * L ^ 2 - (4 + PI ^ 2) * l ^ 2) by ring. rewrite e. ring.
Qed.
(* the drive at the phase (39) exceeds friction where l is below lambda_c *)
Lemma turn_sign l : 0 <= l -> PI * l / 2 <= 1 -> exists c, 0 < c /\ (sin (eq39_phi_t1 l) - l) * c = eq37_lambda_c - l.
Proof.
  intros H H1. destruct lambda_c_is as [b e]. pose proof PI_RGT_0. unfold eq39_phi_t1. set (p := acos (PI * l / 2)). assert (0 <= PI * l) by nra.
  assert (C : cos p = PI * l / 2) by (apply cos_acos; lra). assert (B : 0 <= p <= PI) by apply acos_bound.
  assert (S : 0 <= sin p) by (apply sin_ge_0; lra). assert (S2 : sin p ^ 2 = 1 - (PI * l / 2) ^ 2) by (rewrite <- C, <- !Rsqr_pow2; apply sin2).
  set (L := eq37_lambda_c) in *. assert (P : 0 < sin p + l). { destruct H as [h | <-]; [ lra | ]. assert (sin p <> 0) by (intros z; rewrite z in S2; lra). lra. }
  assert (D : 0 < (4 + PI ^ 2) * (L + l)) by nra. exists (4 * (sin p + l) / ((4 + PI ^ 2) * (L + l))). split; [ apply Rdiv_lt_0_compat; lra | ].
  apply (Rmult_eq_reg_r ((4 + PI ^ 2) * (L + l))); [ | lra ].
  transitivity (4 * (sin p ^ 2 - l ^ 2)); [ field; nra | ]. rewrite S2.
  replace ((L - l) * ((4 + PI ^ 2) * (L + l))) with ((4 + PI ^ 2) * L ^ 2 - (4 + PI ^ 2) * l ^ 2) by ring. rewrite e. field.
Qed.

Section Steady.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Notation p1 := (asin l).
(* (31), counted from phi1 *)
Definition h t := - l * t + cos p1 - cos (p1 + t).
Lemma p1_range : 0 < p1 < PI / 2 /\ sin p1 = l.
Proof.
  assert (e : sin p1 = l) by (apply sin_asin; lra). assert (b : - (PI / 2) < p1 < PI / 2) by (apply asin_bound_lt; lra).
  repeat split; trivial; try lra. apply Rnot_le_lt. intros k. pose proof (sin_incr_1 p1 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). rewrite sin_0 in *. lra.
Qed.
Lemma cos_p1 : cos p1 = sqrt (1 - l ^ 2).
Proof. rewrite cos_asin by lra. f_equal. unfold Rsqr. ring. Qed.
Lemma h_der t : is_derive h t (sin (p1 + t) - l).
Proof. unfold h. auto_derive; trivial. ring. Qed.
Lemma h_cont t : continuity_pt h t.
Proof. apply derivable_continuous_pt. exists (sin (p1 + t) - l). apply is_derive_Reals, h_der. Qed.
Lemma h_0 : h 0 = 0. Proof. unfold h. rewrite Rplus_0_r. ring. Qed.
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
Lemma sin_low x : PI - p1 < x < 2 * PI + p1 -> sin x < l.
Proof.
  destruct p1_range as [[a b] e]. intros H. rewrite <- e. destruct (Rle_lt_dec x (3 * (PI / 2))).
  - rewrite <- (sin_PI_x x). apply sin_increasing_1; lra.
  - replace (sin x) with (sin (x - 2 * PI)) by (rewrite <- (sin_2PI_plus (x - 2 * PI)); f_equal; ring). apply sin_increasing_1; lra.
Qed.
Lemma h_up t : 0 < t <= PI - 2 * p1 -> 0 < h t.
Proof.
  intros H. rewrite <- h_0.
  apply (up h (fun t => sin (p1 + t) - l)); [ lra | intros; apply h_der | ]. intros c Hc. pose proof (sin_above (p1 + c)). lra.
Qed.
Lemma h_down s t : PI - 2 * p1 <= s < t -> t <= 2 * PI -> h t < h s.
Proof.
  intros H1 H2. apply Ropp_lt_cancel. apply (up (fun t => - h t) (fun t => - (sin (p1 + t) - l))); [ lra | | ].
  - intros c Hc. apply (is_derive_opp h), h_der.
  - intros c Hc. pose proof (sin_low (p1 + c)). lra.
Qed.
(* (32): one end, between phi2 and phi4 *)
Lemma slip_once : exists tau, PI - 2 * p1 < tau < 2 * PI - 2 * p1 /\ h tau = 0 /\ (forall t, 0 < t < tau -> 0 < h t) /\ (forall t, tau < t <= 2 * PI -> h t < 0).
Proof.
  destruct p1_range as [[a b] e]. pose proof PI_RGT_0. pose proof (h_up (PI - 2 * p1) ltac:(lra)) as u.
  assert (d : h (2 * PI - 2 * p1) < 0). { unfold h. replace (p1 + (2 * PI - 2 * p1)) with (2 * PI - p1) by ring. rewrite cos_2PI_minus. nra. }
  destruct (IVT_cor h (PI - 2 * p1) (2 * PI - 2 * p1)) as [z [z1 z2]]; [ intros x; apply h_cont | lra | nra | ].
  assert (z <> PI - 2 * p1) by (intros ->; lra). assert (z <> 2 * PI - 2 * p1) by (intros ->; lra). exists z.
  split; [ lra | split; [ trivial | split ] ]; intros t Ht; [ | rewrite <- z2; apply h_down; lra ].
  destruct (Rle_lt_dec t (PI - 2 * p1)). apply h_up; lra. rewrite <- z2. apply h_down; lra.
Qed.
(* (34) is (35) *)
Lemma h_PI : h PI = eq35_left l.
Proof. unfold h, eq35_left. rewrite (Rplus_comm p1), (Rplus_comm PI), neg_cos, <- cos_p1. ring. Qed.

Lemma coulomb_forward w : 0 <= w -> coulomb l w 0 (- l) 0.
Proof. intros H. split; [ nra | ]. rewrite nrm_forward by trivial. ring. Qed.
Lemma anti p : forall t, - sin (p + (t + PI)) = - - sin (p + t).
Proof. intros t. rewrite <- Rplus_assoc, neg_sin. ring. Qed.

(* (33): slip, rest, and the same with the other sign half a period later *)
Definition g33 tau t := if Rlt_dec t tau then h t else 0.
Lemma steady33 tau : 0 < tau < PI -> h tau = 0 -> (forall t, 0 < t < tau -> 0 < h t) -> motion l (fun t => - sin (p1 + t)) (fun _ => 0) (ext PI (g33 tau)) (fun _ => 0).
Proof.
  intros ht z P. destruct p1_range as [[a b] e]. pose proof PI_RGT_0.
  assert (t2 : PI - 2 * p1 < tau). { apply Rnot_le_lt. intros k. pose proof (h_up tau ltac:(lra)). lra. }
  apply half_period; trivial; [ apply anti | | | ].
  - unfold g33. destruct (Rlt_dec PI tau); [ lra | ]. destruct (Rlt_dec 0 tau); [ rewrite h_0; ring | lra ].
  - intros t Ht. destruct (total_order_T t tau) as [[k | ->] | k].
    + apply (cont_glue _ h h t (tau - t)); try apply h_cont; [ lra | | ]; intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra.
    + apply (cont_glue _ h (fun _ => 0) tau 1); try apply h_cont; [ lra | | | cont ]; intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; try lra.
      replace s with tau by lra. auto.
    + apply (cont_glue _ (fun _ => 0) (fun _ => 0) t (t - tau)); [ lra | | | cont | cont ]; intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra.
  - intros t Ht. unfold g33 at 1. destruct (Rlt_dec t tau).
    + exists (- l). split. apply coulomb_forward. destruct (Req_dec t 0) as [-> | ]; [ rewrite h_0; lra | left; apply P; lra ].
      apply (rder_loc _ h t _ (tau - t)); [ lra | intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra | ].
      replace (- l - - sin (p1 + t)) with (sin (p1 + t) - l) by ring. apply h_der.
    + exists (- sin (p1 + t)). split.
      * pose proof (sin_below (p1 + t) ltac:(lra)) as B. apply Rabs_le_between in B. split; [ nra | ]. rewrite nrm_forward by lra. ring.
      * apply (rder_loc _ (fun _ => 0) t _ 1); [ lra | intros s Hs; unfold g33; destruct (Rlt_dec s tau); trivial; lra | ].
        replace (- sin (p1 + t) - - sin (p1 + t)) with 0 by ring. auto_derive; trivial.
Qed.

(* (38): it turns at once; its start is (39) *)
Hypothesis hc : l <= eq37_lambda_c.
Definition g38 p t := - l * t + cos p - cos (p + t).
Notation p := (eq39_phi_t1 l).
Lemma small : 0 < PI * l / 2 < 1.
Proof. destruct lambda_c_is as [b e]. pose proof PI_RGT_0. split; [ nra | ]. apply sq_lt_inv; [ lra | ]. assert (l ^ 2 <= eq37_lambda_c ^ 2) by (apply pow_incr; lra). nra. Qed.
Lemma p_facts : p1 <= p < PI / 2 /\ cos p = PI * l / 2 /\ (l < eq37_lambda_c -> p1 < p).
Proof.
  pose proof small as s. destruct p1_range as [[a b] e1]. destruct (turn_sign l ltac:(lra) ltac:(lra)) as (c & c0 & S). pose proof PI_RGT_0.
  assert (e : cos p = PI * l / 2) by (apply cos_acos; lra). assert (B : 0 < p < PI) by (unfold eq39_phi_t1; apply acos_bound_lt; lra).
  assert (B2 : p < PI / 2). { apply Rnot_le_lt. intros k. pose proof (cos_decr_1 (PI / 2) p ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). rewrite cos_PI2 in *. lra. }
  assert (S1 : l <= sin p) by nra. repeat split; trivial.
  - apply Rnot_lt_le. intros k. pose proof (sin_increasing_1 p p1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). lra.
  - intros k. apply Rnot_le_lt. intros q. pose proof (sin_incr_1 p p1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) q). nra.
Qed.
Lemma g_der t : is_derive (g38 p) t (sin (p + t) - l).
Proof. unfold g38. auto_derive; trivial. ring. Qed.
Lemma g_0 : g38 p 0 = 0. Proof. unfold g38. rewrite Rplus_0_r. ring. Qed.
Lemma g_PI : g38 p PI = 0. Proof. unfold g38. destruct p_facts as [_ [c _]]. rewrite neg_cos, c. field. Qed.
Lemma g_pos t : 0 < t < PI -> 0 < g38 p t.
Proof.
  intros H. destruct p_facts as [[a b] [c _]]. destruct p1_range as [[a1 b1] e1]. destruct (Rle_lt_dec t (PI - p1 - p)).
  - rewrite <- g_0. apply (up (g38 p) (fun t => sin (p + t) - l)); [ lra | intros; apply g_der | ]. intros x Hx. pose proof (sin_above (p + x)). lra.
  - rewrite <- g_PI. apply Ropp_lt_cancel. apply (up (fun t => - g38 p t) (fun t => - (sin (p + t) - l))); [ lra | intros; apply (is_derive_opp (g38 p)), g_der | ].
    intros x Hx. pose proof (sin_low (p + x)). lra.
Qed.
Lemma steady38 : motion l (fun t => - sin (p + t)) (fun _ => 0) (ext PI (g38 p)) (fun _ => 0).
Proof.
  pose proof PI_RGT_0. apply half_period; trivial; [ apply anti | rewrite g_0, g_PI; ring | | ].
  - intros t _. apply derivable_continuous_pt. exists (sin (p + t) - l). apply is_derive_Reals, g_der.
  - intros t Ht. exists (- l). split. apply coulomb_forward. destruct (Req_dec t 0) as [-> | ]; [ rewrite g_0; lra | left; apply g_pos; lra ].
    apply rder_of. replace (- l - - sin (p + t)) with (sin (p + t) - l) by ring. apply g_der.
Qed.
End Steady.
