(* The slip from rest at the phase phi1 = asin l, where it ends and what lambda_c has to do with it;
and half a period of the steady motions (33), with
   rests, and (38), without. Phases are counted from the start of the forward slip. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas HalfPeriod Drawn Analysis.
Open Scope R_scope.

(* takes the least and the greatest of two numbers apart *)
Ltac cases := unfold Rmin, Rmax in *; repeat match goal with
  | |- context [Rle_dec ?a ?b] => destruct (Rle_dec a b) | H : context [Rle_dec ?a ?b] |- _ => destruct (Rle_dec a b) end.
Ltac minmax := cases; try lra.

Lemma ext_period T g : 0 < T -> forall t, ext T g (t + 2 * T) = ext T g t.
Proof. intros hT t. replace (t + 2 * T) with (t + T + T) by ring. rewrite !ext_anti by trivial. ring. Qed.
Lemma sin_2PI_minus x : sin (2 * PI - x) = - sin x. Proof. rewrite sin_minus, cos_2PI, sin_2PI. ring. Qed.
Lemma sin_1 x : Rabs (sin x) <= 1. Proof. apply Rabs_le, SIN_bound. Qed.
Lemma sin_size x y : Rabs (sin x) <= Rabs (sin y) + Rabs (x - y).
Proof. pose proof (sin_near x y). pose proof (Rabs_triang_inv (sin x) (sin y)). lra. Qed.

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
Lemma sign_of x y l : 0 < x + y -> 0 <= l -> 4 * ((x - y) * (x + y)) = (4 + PI ^ 2) * (eq37_lambda_c ^ 2 - l ^ 2) ->
  exists c, 0 < c /\ (x - y) * c = eq37_lambda_c - l.
Proof.
  intros s hl E. destruct lambda_c_is as [b _]. set (L := eq37_lambda_c) in *. pose proof (pow2_ge_0 PI).
  assert (D : 0 < (4 + PI ^ 2) * (L + l)) by nra.
  exists (4 * (x + y) / ((4 + PI ^ 2) * (L + l))). split; [ apply Rdiv_lt_0_compat; lra | ].
  transitivity (4 * ((x - y) * (x + y)) / ((4 + PI ^ 2) * (L + l))); [ | rewrite E ]; field; nra.
Qed.
(* the left side of (35) has the sign of lambda_c - l *)
Lemma left_sign l : 0 <= l <= 1 -> exists c, 0 < c /\ eq35_left l * c = eq37_lambda_c - l.
Proof.
  intros H. destruct lambda_c_is as [_ e]. pose proof PI_RGT_0. pose proof (sqrt_pos (1 - l ^ 2)).
  assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (apply pow2_sqrt; nra).
  destruct (sign_of (sqrt (1 - l ^ 2)) (PI * l / 2) l) as (c & c0 & E); [ | lra | rewrite Rmult_minus_distr_l, e; lra | exists (c / 2);
  unfold eq35_left; lra ].
  destruct H as [[h | <-] _]; [ assert (0 < PI * l) by nra; lra | replace (1 - 0 ^ 2) with 1 by ring; rewrite sqrt_1; lra ].
Qed.
(* the drive at the phase (39) exceeds friction where l is below lambda_c *)
Lemma turn_sign l : 0 <= l -> PI * l / 2 <= 1 -> exists c, 0 < c /\ (sin (eq39_phi_t1 l) - l) * c = eq37_lambda_c - l.
Proof.
  intros H H1. destruct lambda_c_is as [b e]. pose proof PI_RGT_0. unfold eq39_phi_t1. set (p := acos (PI * l / 2)). assert (0 <= PI * l) by nra.
  assert (C : cos p = PI * l / 2) by (apply cos_acos; lra). assert (S : 0 <= sin p) by (apply sin_ge_0; apply acos_bound).
  assert (S2 : sin p ^ 2 = 1 - (PI * l / 2) ^ 2) by (rewrite <- C, <- !Rsqr_pow2; apply sin2). apply sign_of; trivial; [ | nra ].
  destruct H as [h | <-]; [ lra | ]. enough (sin p <> 0) by lra. intros z. rewrite z in S2. lra.
Qed.
Lemma small l : 0 <= l <= eq37_lambda_c -> 0 <= PI * l / 2 < 1.
Proof. intros h. destruct lambda_c_is as [b e]. pose proof PI_RGT_0. assert (0 <= PI * l <= PI * eq37_lambda_c) by nra.
assert (PI * eq37_lambda_c < 2) by nra. lra. Qed.

Section Steady.
Variable l : R.
Hypothesis hl : 0 < l < 1.
Notation p1 := (asin l).
(* (31), counted from phi1 *)
Definition h t := - l * t + cos p1 - cos (p1 + t).
Notation p1_range := (asin_range l hl).
Lemma h_der t : is_derive h t (sin (p1 + t) - l).
Proof. unfold h. auto_derive; trivial. ring. Qed.
Lemma h_cont t : continuity_pt h t. Proof. exact (cont_of _ _ _ (h_der t)). Qed.
Lemma h_0 : h 0 = 0. Proof. unfold h. rewrite Rplus_0_r. ring. Qed.
Lemma sin_below x : PI - p1 <= x <= PI + p1 -> Rabs (sin x) <= l.
Proof.
  destruct p1_range as [[a b] e]. intros H. rewrite <- e, <- (sin_PI_x x). apply Rabs_le. rewrite <- sin_neg. split; apply sin_incr_1; lra.
Qed.
(* (31) and (38) from p on: up while the drive beats friction, and down after it *)
Lemma slip_up (f : R -> R) p s t : (forall t, is_derive f t (sin (p + t) - l)) -> p1 <= p + s -> s < t -> p + t <= PI - p1 -> f s < f t.
Proof. intros D a b c. apply (up f (fun t => sin (p + t) - l)); [ lra | auto | ]. intros x Hx. pose proof (sin_above l (p + x) hl). lra. Qed.
Lemma slip_down (f : R -> R) p s t : (forall t, is_derive f t (sin (p + t) - l)) -> PI - p1 <= p + s -> s < t -> p + t <= 2 * PI + p1 -> f t < f s.
Proof.
  intros D a b c. apply Ropp_lt_cancel. apply (up (fun t => - f t) (fun t => - (sin (p + t) - l))); [ lra | | ].
  - intros x Hx. apply (is_derive_opp f), D.
  - intros x Hx. pose proof (sin_less l (p + x) hl). lra.
Qed.
Lemma slip_top (f : R -> R) p t : (forall t, is_derive f t (sin (p + t) - l)) -> p1 <= p -> 0 <= t -> p + t <= 2 * PI + p1 -> f t <= f (PI - p1 - p).
Proof.
  intros D a b c. destruct (Rtotal_order t (PI - p1 - p)) as [k | [-> | k]]; [ left; apply (slip_up f p) | lra | left; apply (slip_down f p) ];
  trivial; lra.
Qed.
(* (32): one end, between phi2 and phi4 *)
Lemma slip_once : exists tau, PI - 2 * p1 < tau < 2 * PI - 2 * p1 /\ h tau = 0 /\ (forall t, 0 < t < tau -> 0 < h t) /\
  (forall t, tau < t <= 2 * PI -> h t < 0).
Proof.
  destruct p1_range as [[a b] e]. pose proof PI_RGT_0. pose proof (slip_up h p1 0) as u. rewrite h_0 in u.
  assert (d : h (2 * PI - 2 * p1) < 0).
  { unfold h. replace (p1 + (2 * PI - 2 * p1)) with (- p1 + 2 * PI) by ring. rewrite cos_per, cos_neg.
    assert (0 < l * (2 * PI - 2 * p1)) by (apply Rmult_lt_0_compat; lra). lra. }
  pose proof (u (PI - 2 * p1) h_der ltac:(lra) ltac:(lra) ltac:(lra)).
  destruct (IVT_cor h (PI - 2 * p1) (2 * PI - 2 * p1) h_cont) as [z [z1 z2]]; [ lra | nra | ].
  assert (z <> PI - 2 * p1) by (intros ->; lra). assert (z <> 2 * PI - 2 * p1) by (intros ->; lra). exists z.
  split; [ lra | split; [ trivial | split ] ]; intros t Ht; [ destruct (Rle_lt_dec t (PI - 2 * p1)) | ]; [ apply (u t h_der); lra | | ];
  rewrite <- z2;
  apply (slip_down h p1); try apply h_der; lra.
Qed.
(* (34) is (35) *)
Lemma h_PI : h PI = eq35_left l.
Proof.
  unfold h, eq35_left. rewrite (Rplus_comm p1), (Rplus_comm PI), neg_cos, cos_asin_pow by lra. ring.
Qed.

Lemma coulomb_forward w : 0 <= w -> coulomb l w 0 (- l) 0.
Proof. intros H. split; [ nra | ]. rewrite nrm_x0 by trivial. ring. Qed.
Lemma anti p t : - sin (p + (t + PI)) = - - sin (p + t).
Proof. rewrite <- Rplus_assoc, neg_sin. ring. Qed.
(* a slip g over half a period, from p on, repeated with both signs: a motion from every phase on *)
Lemma repeated p g phi0 : g PI = - g 0 -> (forall t, 0 <= t <= PI -> continuity_pt g t) ->
  (forall t, 0 <= t < PI -> exists f, coulomb l (g t) 0 f 0 /\ rder g t (f - - sin (p + t))) ->
  motion l (fun s => - sin (p + (phi0 - p + s))) (fun _ => 0) (fun s => ext PI g (phi0 - p + s)) (fun _ => 0).
Proof. intros. apply (half_period_from l PI (fun t => - sin (p + t)) g PI_RGT_0); trivial. apply anti. Qed.

(* (33): slip, then rest *)
Definition g33 tau t := if Rlt_dec t tau then h t else 0.
Lemma steady33 tau phi0 : 0 < tau < PI -> h tau = 0 -> (forall t, 0 < t < tau -> 0 < h t) ->
  motion l (fun s => - sin (p1 + (phi0 - p1 + s))) (fun _ => 0) (fun s => ext PI (g33 tau) (phi0 - p1 + s)) (fun _ => 0).
Proof.
  intros ht z P. destruct p1_range as [[a b] e]. pose proof PI_RGT_0.
  assert (t2 : PI - 2 * p1 < tau). { apply Rnot_le_lt. intros k. pose proof (slip_up h p1 0 tau h_der). rewrite h_0 in *. lra. }
  assert (S : forall t, t < tau -> g33 tau t = h t) by (intros; unfold g33; destruct Rlt_dec; lra).
  assert (R : forall t, tau <= t -> g33 tau t = 0) by (intros; unfold g33; destruct Rlt_dec; lra).
  apply repeated.
  - rewrite R, S, h_0 by lra. ring.
  - intros t _. apply (continuity_pt_ext (fun t => h (Rmin t tau))).
    { intros s. unfold g33. destruct Rlt_dec; minmax; trivial. replace s with tau by lra. trivial. }
    apply (continuity_pt_comp (fun t => Rmin t tau) h); [ | apply h_cont ]. apply (cont_lip _ t 1 1 Rlt_0_1). intros s _.
    rewrite Rmult_1_l. unfold Rabs. minmax; repeat destruct Rcase_abs; lra.
  - intros t Ht. destruct (Rlt_dec t tau) as [k | k].
    + exists (- l). rewrite S by lra. split. apply coulomb_forward. destruct (Req_dec t 0) as [-> | ]; [ rewrite h_0; lra | left; apply P; lra ].
      apply (rder_loc _ h t _ (tau - t)); [ lra | intros; symmetry; apply S; lra | ].
      replace (- l - - sin (p1 + t)) with (sin (p1 + t) - l) by ring. apply h_der.
    + exists (- sin (p1 + t)). rewrite R by lra. split.
      * pose proof (sin_below (p1 + t) ltac:(lra)) as B. apply Rabs_le_between in B. split; [ nra | ]. rewrite nrm_x0 by lra. ring.
      * apply (rder_loc _ (fun _ => 0) t _ 1); [ lra | intros; symmetry; apply R; lra | ].
        replace (- sin (p1 + t) - - sin (p1 + t)) with 0 by ring. auto_derive; trivial.
Qed.

(* (38): it turns at once; its start is (39) *)
Hypothesis hc : l <= eq37_lambda_c.
Definition g38 p t := - l * t + cos p - cos (p + t).
Notation p := (eq39_phi_t1 l).
Lemma p_facts : p1 <= p < PI / 2 /\ cos p = PI * l / 2 /\ (l < eq37_lambda_c -> p1 < p).
Proof.
  pose proof (small l ltac:(lra)) as s. destruct p1_range as [[a b] e1]. destruct (turn_sign l ltac:(lra) ltac:(lra)) as (c & c0 & S).
  pose proof PI_RGT_0.
  assert (e : cos p = PI * l / 2) by (apply cos_acos; lra). assert (B : 0 < p < PI) by (unfold eq39_phi_t1; apply acos_bound_lt; nra).
  assert (B2 : p < PI / 2). { apply Rnot_le_lt. intros k. pose proof (cos_le_0 p ltac:(lra) ltac:(lra)). nra. }
  repeat split; trivial.
  - apply Rnot_lt_le. intros k. pose proof (sin_increasing_1 p p1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) k). nra.
  - intros k. apply Rnot_le_lt. intros q. pose proof (sin_incr_1 p p1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) q). nra.
Qed.
Lemma g_der q t : is_derive (g38 q) t (sin (q + t) - l).
Proof. unfold g38. auto_derive; trivial. ring. Qed.
Lemma g_0 q : g38 q 0 = 0. Proof. unfold g38. rewrite Rplus_0_r. ring. Qed.
Lemma g_PI : g38 p PI = 0. Proof. unfold g38. destruct p_facts as [_ [c _]]. rewrite neg_cos, c. field. Qed.
Lemma g_pos t : 0 < t < PI -> 0 < g38 p t.
Proof.
  intros H. destruct p_facts as [[a b] _]. destruct p1_range as [[a1 b1] _]. destruct (Rle_lt_dec t (PI - p1 - p)).
  - rewrite <- (g_0 p). apply (slip_up _ p); try apply g_der; lra.
  - rewrite <- g_PI. apply (slip_down _ p); try apply g_der; lra.
Qed.
Lemma steady38 phi0 : motion l (fun s => - sin (p + (phi0 - p + s))) (fun _ => 0) (fun s => ext PI (g38 p) (phi0 - p + s)) (fun _ => 0).
Proof.
  pose proof PI_RGT_0. apply repeated.
  - rewrite g_0, g_PI. ring.
  - intros t _. exact (cont_of _ _ _ (g_der p t)).
  - intros t Ht. exists (- l). split. apply coulomb_forward. destruct (Req_dec t 0) as [-> | ]; [ rewrite g_0; lra | left; apply g_pos; lra ].
    apply rder_of. replace (- l - - sin (p + t)) with (sin (p + t) - l) by ring. apply g_der.
Qed.
End Steady.
