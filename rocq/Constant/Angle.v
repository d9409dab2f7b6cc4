(* Speed and angle of the velocity: (4), the tangent of half the angle, and the rate at which the angle turns. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas.
From Slipbook.General Require Import Contraction.
From Slipbook.Constant Require Import Slip.
Import Continuous.
Open Scope R_scope.

(* (4): the angle with the x-axis in radians above -PI up to PI; at rest it may be any.
   «$v$ is the speed, and $theta\in(-\pi,\pi]$ the angle, of the velocity $(vx,vy)$» *)
Definition polar vx vy v theta := forall t, 0 <= t -> 0 <= v t /\ - PI < theta t <= PI /\ vx t = eq4_velocity_1 (v t) (theta t) /\ vy t =
  eq4_velocity_2 (v t) (theta t).

Lemma polar_speed vx vy v theta : polar vx vy v theta -> forall t, 0 <= t -> nrm (vx t) (vy t) = v t.
Proof.
  intros P t Ht. destruct (P t Ht) as (p & _ & -> & ->). unfold eq4_velocity_1, eq4_velocity_2. rewrite nrm_scale by trivial. unfold nrm.
  rewrite unit_circle, sqrt_1. ring.
Qed.
Lemma half_angle th : - PI < th < PI -> 0 < 1 + cos th /\ tan (th / 2) = sin th / (1 + cos th).
Proof.
  intros H. assert (c0 : 0 < cos (th / 2)) by (apply cos_gt_0; lra). replace th with (2 * (th / 2)) at 1 3 4 by field. rewrite sin_2a, cos_2a_cos.
  unfold tan. split. nra. field. split; nra.
Qed.
(* the sine is positive above the axis, and only there *)
Lemma sin_up th : - PI < th <= PI -> 0 < sin th -> 0 < th < PI.
Proof.
  intros H s. destruct (Rtotal_order th 0) as [k | [-> | k]]; [ pose proof (sin_lt_0_var th); lra | rewrite sin_0 in s; lra | ].
  destruct (Req_dec th PI) as [-> | n]; [ rewrite sin_PI in s | ]; lra.
Qed.
Lemma sin_no th : - PI < th <= PI -> th <> 0 -> th <> PI -> sin th <> 0.
Proof. intros H n0 n1. destruct (Rdichotomy _ _ n0) as [k | k]; [ pose proof (sin_lt_0_var th) | pose proof (sin_gt_0 th) ]; lra. Qed.

(* an angle of the velocity (x, y) *)
Definition direction_of x y := if Rlt_dec y 0 then - acos (x / nrm x y) else acos (x / nrm x y).
Lemma angle_polar x y : - PI < direction_of x y <= PI /\ x = eq4_velocity_1 (nrm x y) (direction_of x y) /\ y = eq4_velocity_2 (nrm x y) (direction_of x y).
Proof.
  unfold direction_of, eq4_velocity_1, eq4_velocity_2. pose proof (nrm_sq x y) as e. destruct (abs_nrm x y) as [b _]. apply Rabs_le_between in b.
  pose proof PI_RGT_0.
  destruct (Req_dec (nrm x y) 0) as [z | z]. { destruct (nrm_zero _ _ z) as [-> ->]. rewrite z. unfold Rdiv. rewrite Rmult_0_l, acos_0.
  destruct Rlt_dec; lra. }
  pose proof (nrm_pos x y). set (n := nrm x y) in *. set (u := x / n). assert (eu : n * u = x) by (unfold u; field; trivial).
  assert (U : -1 <= u <= 1) by nra.
  pose proof (acos_bound u). pose proof (cos_acos u U) as c. pose proof (sin_acos u U) as s. assert (sy : n * sqrt (1 - u²) = Rabs y).
  { rewrite <- (sqrt_pow2 n) at 1 by lra. rewrite <- sqrt_mult_alt by apply pow2_ge_0. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr.
    rewrite <- eu in e. lra. }
  destruct Rlt_dec as [k | k]; rewrite ?cos_neg, ?sin_neg, c, s.
  - rewrite Rabs_left in sy by trivial. repeat split; try lra. enough (acos u <> PI) by lra. intros q. rewrite q, cos_PI in c. rewrite <- c in *. nra.
  - rewrite Rabs_pos_eq in sy; repeat split; lra.
Qed.

Section Turn.
Variables (A lam : R) (vx vy v theta : R -> R).
Hypothesis hA : 0 < A.
Hypothesis hl : 0 <= lam.
Hypothesis M : pulled A lam vx vy.
Hypothesis P : polar vx vy v theta.
Let V := polar_speed vx vy v theta P.
(* speed + vx is positive where it slips, not straight against the pull *)
Lemma plus_is t : 0 <= t -> 0 < v t -> theta t <> PI -> 0 < v t + vx t /\ tan (theta t / 2) = vy t / (v t + vx t).
Proof.
  intros Ht p N. destruct (P t Ht) as (_ & b & -> & ->). destruct (half_angle (theta t) ltac:(lra)) as [c ->].
  unfold eq4_velocity_1, eq4_velocity_2. split. nra. field. split; nra.
Qed.
Lemma angle_is t : 0 <= t -> 0 < v t + vx t -> 0 < v t /\ theta t <> PI /\ theta t = 2 * atan (vy t / (v t + vx t)).
Proof.
  intros Ht C. destruct (P t Ht) as (p & b & ex & _). unfold eq4_velocity_1 in ex.
  assert (v0 : 0 < v t) by (destruct p as [ | z]; trivial; rewrite <- z in *; lra).
  assert (n : theta t <> PI) by (intros k; rewrite k, cos_PI in ex; lra). repeat split; trivial. destruct (plus_is t Ht v0 n) as [_ <-].
  rewrite atan_tan by lra. field.
Qed.
Lemma angle_cont t : 0 < t -> 0 < v t + vx t -> continuity_pt theta t.
Proof.
  intros Ht C. assert (cv := cv A lam vx vy v M V t Ht). assert (cx : continuity_pt vx t) by cont. assert (cy : continuity_pt vy t) by cont.
  assert (cc : continuity_pt (fun s => v s + vx s) t) by cont. destruct (cont_eps _ t _ cc C) as (d & d0 & Hd).
  apply (cont_glue theta (fun s => 2 * atan (vy s * / (v s + vx s))) (fun s => 2 * atan (vy s * / (v s + vx s))) t (Rmin d t)).
  apply Rmin_pos; trivial.
  1, 2: intros s Hs; pose proof (Rmin_l d t); pose proof (Rmin_r d t); apply angle_is; [ lra | specialize (Hd s ltac:(apply Rabs_def1; lra));
  apply Rabs_def2 in Hd; lra ].
  1, 2: apply (continuity_pt_mult (fun _ => 2)); [ cont | apply (continuity_pt_comp (fun s => vy s * / (v s + vx s)) atan) ];
    [ apply continuity_pt_mult; [ trivial | apply (cont_inv (fun s => v s + vx s));
    [ trivial | lra ] ] | apply derivable_continuous_pt, derivable_pt_atan ].
Qed.
Lemma angle_rate t : 0 <= t -> 0 < v t -> theta t <> PI -> rder theta t (- (A * sin (theta t) / v t)).
Proof.
  intros Ht p N. destruct (plus_is t Ht p N) as [C _]. destruct (pull_rates A lam vx vy v hA hl M V t Ht ltac:(lra)) as (X & Y & S).
  assert (D := rder_plus v vx t _ _ S X). destruct (rder_near_pos _ _ _ D C) as (d & d0 & Hd).
  apply (rder_near _ (fun s => 2 * atan (vy s * / (v s + vx s))) t _ d d0).
  - intros s Hs. symmetry. apply angle_is. lra. specialize (Hd (s - t) ltac:(lra)). now replace (t + (s - t)) with s in Hd by ring.
  - pose proof (rder_mult _ _ _ _ _ Y (rder_inv _ _ _ D (Rgt_not_eq _ _ C))) as Q. cbv beta in Q.
    eapply rder_eq. apply (rder_mult (fun _ => 2)); [ rd | eapply (rder_comp _ atan); [ exact Q | apply is_derive_Reals, derivable_pt_lim_atan ] ].
    cbv beta. destruct (P t Ht) as (_ & _ & _ & ey). destruct (sides vx vy v V t Ht) as (_ & _ & y2). unfold eq4_velocity_2 in ey.
    replace (sin (theta t)) with (vy t / v t) by (rewrite ey; field; lra).
    set (m := v t) in *. set (x := vx t) in *. set (y := vy t) in *. assert (e1 : 1 + (y * / (m + x)) ^ 2 = 2 * m / (m + x)).
    { rewrite Rpow_mult_distr, <- y2. field. lra. } rewrite e1. field. lra.
Qed.
(* the velocity is near the x-axis, and so is the angle *)
Lemma angle_small e : 0 < e -> exists q, 0 < q /\ forall t, 0 <= t -> 0 < vx t -> Rabs (vy t) <= q * vx t -> Rabs (theta t) < e.
Proof.
  intros He. destruct (cont_eps atan 0 (e / 2)) as (q & q0 & Hq). apply derivable_continuous_pt, derivable_pt_atan. lra. rewrite atan_0 in Hq.
  exists (q / 2). split. lra. intros t Ht x y.
  destruct (sides vx vy v V t Ht) as (_ & b & _). destruct (angle_is t Ht ltac:(lra)) as (_ & _ & ->). rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
  specialize (Hq (vy t / (v t + vx t))).
  rewrite !Rminus_0_r in Hq. enough (Rabs (vy t / (v t + vx t)) < q) by (specialize (Hq H); lra).
  rewrite Rabs_div, (Rabs_pos_eq (v t + vx t)) by lra. apply Rlt_div_l; nra.
Qed.
End Turn.
