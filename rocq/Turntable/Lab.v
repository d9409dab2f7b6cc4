(* The laboratory, where friction alone accelerates the particle: (86) is its law seen from the table (turned); how fast a particle can get away *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion TableLaws.
Open Scope R_scope.

(* position (X, Y) and velocity (U, W) in the laboratory; below it the table turns at the rate Om and has the velocity (- Om Y, Om X); k = mu g *)
Record laboratory (Om k : R) (X Y U W : R -> R) : Prop := {
  l_c : forall t, 0 < t -> continuity_pt X t /\ continuity_pt Y t /\ continuity_pt U t /\ continuity_pt W t;
  l_law : forall t, 0 <= t -> rder X t (U t) /\ rder Y t (W t) /\
            exists fx fy, coulomb k (U t + Om * Y t) (W t - Om * X t) fx fy /\ rder U t fx /\ rder W t fy }.
(* (x, y) and (u, w): place and velocity of the same particle relative to the table, along axes that turn with it *)
Definition same_particle (Om : R) (X Y U W x y u w : R -> R) := forall t,
  x t = cos (Om * t) * X t + sin (Om * t) * Y t /\ y t = cos (Om * t) * Y t - sin (Om * t) * X t /\
  u t = cos (Om * t) * (U t + Om * Y t) + sin (Om * t) * (W t - Om * X t) /\
  w t = cos (Om * t) * (W t - Om * X t) - sin (Om * t) * (U t + Om * Y t).

(* the law in a frame that turns at the rate o, for a table that turns at the rate Om *)
Record seen (o Om k : R) (x y u w : R -> R) : Prop := {
  f_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt u t /\ continuity_pt w t;
  f_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, coulomb k (u t + (Om - o) * y t) (w t - (Om - o) * x t) fx fy /\
            rder u t (o ^ 2 * x t + 2 * o * w t + fx) /\ rder w t (o ^ 2 * y t - 2 * o * u t + fy) }.
Lemma seen_lab Om k x y u w : seen 0 Om k x y u w <-> laboratory Om k x y u w.
Proof.
  split; intros S; split; try apply S; intros t Ht.
  - destruct (f_law _ _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W). rewrite Rminus_0_r in C. split; [ | split ]; trivial. exists fx, fy.
    split; [ exact C | split; (eapply rder_eq; [ eassumption | ring ]) ].
  - destruct (l_law _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W). split; [ | split ]; trivial. exists fx, fy. rewrite Rminus_0_r.
    split; [ exact C | split; (eapply rder_eq; [ eassumption | ring ]) ].
Qed.
Lemma seen_table Om k x y u w : seen Om Om k x y u w <-> turntable Om k x y u w.
Proof.
  split; intros S; split; try apply S; intros t Ht.
  - destruct (f_law _ _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W). rewrite Rminus_eq_0, !Rmult_0_l, Rplus_0_r, Rminus_0_r in C. split; [ | split ]; trivial. now exists fx, fy.
  - destruct (t_law _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W). split; [ | split ]; trivial. exists fx, fy. rewrite Rminus_eq_0, !Rmult_0_l, Rplus_0_r, Rminus_0_r. auto.
Qed.
Lemma turned q o Om k X Y U W x y u w : same_particle q X Y U W x y u w -> seen o Om k X Y U W -> seen (o + q) Om k x y u w.
Proof.
  intros T S. replace x with (fun t => cos (q * t) * X t + sin (q * t) * Y t) by (extensionality t; symmetry; apply (T t)).
  replace y with (fun t => cos (q * t) * Y t - sin (q * t) * X t) by (extensionality t; symmetry; apply (T t)).
  replace u with (fun t => cos (q * t) * (U t + q * Y t) + sin (q * t) * (W t - q * X t)) by (extensionality t; symmetry; apply (T t)).
  replace w with (fun t => cos (q * t) * (W t - q * X t) - sin (q * t) * (U t + q * Y t)) by (extensionality t; symmetry; apply (T t)). split.
  - intros t Ht. destruct (f_c _ _ _ _ _ _ _ S t Ht) as (cX & cY & cU & cW).
    assert (cc : continuity_pt (fun t => cos (q * t)) t) by (apply (continuity_pt_comp (fun t => q * t) cos); [ cont | apply continuity_cos ]).
    assert (cs : continuity_pt (fun t => sin (q * t)) t) by (apply (continuity_pt_comp (fun t => q * t) sin); [ cont | apply continuity_sin ]).
    repeat split; cont; assumption.
  - intros t Ht. destruct (f_law _ _ _ _ _ _ _ S t Ht) as (DX & DY & fx & fy & [B P] & DU & DW).
    assert (dc : rder (fun t => cos (q * t)) t (- q * sin (q * t))) by (apply rder_of; auto_derive; trivial; ring).
    assert (ds : rder (fun t => sin (q * t)) t (q * cos (q * t))) by (apply rder_of; auto_derive; trivial; ring).
    pose proof (sin2_cos2 (q * t)) as e. unfold Rsqr in e. set (s := sin (q * t)) in *. set (c := cos (q * t)) in *.
    split. { eapply rder_eq; [ rd | fold s; fold c; ring ]. } split. { eapply rder_eq; [ rd | fold s; fold c; ring ]. }
    exists (c * fx + s * fy), (c * fy - s * fx). split; [ split | split; (eapply rder_eq; [ rd | fold s; fold c; ring ]) ].
    + replace ((c * fx + s * fy) ^ 2 + (c * fy - s * fx) ^ 2) with ((s * s + c * c) * (fx ^ 2 + fy ^ 2)) by ring. rewrite e, Rmult_1_l. exact B.
    + set (a := U t + (Om - o) * Y t) in *. set (b := W t - (Om - o) * X t) in *.
      replace (c * (U t + q * Y t) + s * (W t - q * X t) + (Om - (o + q)) * (c * Y t - s * X t)) with (c * a + s * b) by (unfold a, b; ring).
      replace (c * (W t - q * X t) - s * (U t + q * Y t) - (Om - (o + q)) * (c * X t + s * Y t)) with (c * b - s * a) by (unfold a, b; ring).
      replace (nrm (c * a + s * b) (c * b - s * a)) with (nrm a b). 2: { unfold nrm. f_equal. transitivity ((s * s + c * c) * (a ^ 2 + b ^ 2)). rewrite e. ring. ring. }
      transitivity ((s * s + c * c) * (fx * a + fy * b)). ring. rewrite e, P. ring.
Qed.
Lemma same_back Om X Y U W x y u w : same_particle Om X Y U W x y u w <-> same_particle (- Om) x y u w X Y U W.
Proof.
  assert (H : forall Om X Y U W x y u w, same_particle Om X Y U W x y u w -> same_particle (- Om) x y u w X Y U W).
  { clear. intros Om X Y U W x y u w T t. destruct (T t) as (-> & -> & -> & ->). rewrite Ropp_mult_distr_l_reverse, cos_neg, sin_neg.
    pose proof (sin2_cos2 (Om * t)) as e. unfold Rsqr in e. set (s := sin (Om * t)) in *. set (c := cos (Om * t)) in *. assert (e2 : c * c = 1 - s * s) by lra.
    repeat split; ring [e2]. }
  split; intros T; [ now apply H | ]. apply H in T. now rewrite Ropp_involutive in T.
Qed.

Section Lab.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation rho t := (nrm (x t) (y t)).
(* the speed that the laboratory sees *)
Notation lab t := (nrm (u t - y t) (w t + x t)).
Lemma lab_speed s t : 0 <= s <= t -> lab t <= lab s + (t - s).
Proof.
  intros Hst. enough (lab t - lab s <= t - s) by lra.
  apply (length_below (fun t => u t - y t) (fun t => w t + x t) (fun t => t) s t); [ lra | | ]; intros r Hr.
  - split; [ table S | split; [ table S | cont ] ].
  - destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ]. exists (w r + x r + fx), (- (u r - y r) + fy), 1.
    split. { eapply rder_eq; [ rd | ring ]. } split. { eapply rder_eq; [ rd | ring ]. } split. { apply rder_of. auto_derive; trivial. } split. lra.
    pose proof (power_bound 1 fx fy (- (u r - y r)) (- (w r + x r)) Rle_0_1 ltac:(lra)) as Q.
    replace (nrm (- (u r - y r)) (- (w r + x r))) with (lab r) in Q by (unfold nrm; f_equal; ring). lra.
Qed.
Lemma place_below s t : 0 <= s <= t -> rho t <= rho s + lab s * (t - s) + (t - s) ^ 2 / 2.
Proof.
  intros Hst. enough (rho t - rho s <= (lab s * (t - s) + (t - s) ^ 2 * / 2) - (lab s * (s - s) + (s - s) ^ 2 * / 2)) by lra.
  apply (length_below x y (fun t => lab s * (t - s) + (t - s) ^ 2 * / 2) s t); [ lra | | ]; intros r Hr.
  - split; [ apply (s_cx _ _ _ _ S); lra | split; [ apply (s_cy _ _ _ _ S); lra | cont ] ].
  - destruct (s_law _ _ _ _ S r) as (X & Y & _); [ lra | ]. exists (u r), (w r), (lab s + (r - s)). split; trivial. split; trivial. split. { apply rder_of. auto_derive; trivial. field. }
    pose proof (nrm_pos (u s - y s) (w s + x s)). split. lra. apply Rle_trans with (lab r * rho r).
    + pose proof (power_bound (lab r) (u r - y r) (w r + x r) (- x r) (- y r) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q.
      replace (nrm (- x r) (- y r)) with (rho r) in Q by (unfold nrm; f_equal; ring). lra.
    + apply Rmult_le_compat_r. apply nrm_pos. pose proof (lab_speed s r ltac:(lra)). lra.
Qed.
End Lab.
