(* 2.3: the pulses (42), (43) and the motion (44), (45), from lambda_c = eta on (46) *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic.
Open Scope R_scope.

Lemma ext_anti T g : 0 < T -> forall t, ext T g (t + T) = - ext T g t.
Proof.
  intros hT t. pose proof (proj2 (floor_spec T hT t (floor T t)) eq_refl) as H. set (n := floor T t) in *.
  rewrite (ext_on T g hT n t H), (ext_on T g hT (n + 1) (t + T)) by (rewrite plus_IZR; lra).
  rewrite sg_succ, plus_IZR. replace (t + T - (IZR n + 1) * T) with (t - IZR n * T) by ring. ring.
Qed.

Section Pulse.
Variables l eta : R.
Hypothesis he : 0 < eta < 1.
Hypothesis hl : eta < l < 1.
Let e := eta * PI.
Definition h42 t := if Rlt_dec t e then 1 else 0.
Definition drive t := - ext PI h42 t.
Definition g44 t := if Rlt_dec t e then (1 - l) * t else if Rlt_dec t (e / l) then (1 - l) * e - l * (t - e) else 0.
Lemma order : 0 < e < e / l /\ e / l < PI /\ l * (e / l) = e.
Proof.
  pose proof PI_RGT_0. assert (0 < e) by (unfold e; nra). assert (q : l * (e / l) = e) by (field; lra).
  repeat split; trivial. apply (Rmult_lt_reg_l l); [ lra | rewrite q; nra ]. apply (Rmult_lt_reg_l l); [ lra | rewrite q; unfold e; nra ].
Qed.
Lemma on g t : 0 <= t < PI -> ext PI g t = g t.
Proof. intros H. rewrite (ext_on PI g PI_RGT_0 0) by (simpl; lra). unfold sg; simpl. rewrite Rmult_1_l. f_equal. ring. Qed.
Ltac here := unfold g44, h42; repeat match goal with |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b) end; try lra.

Theorem eq44 : motion l drive (fun _ => 0) (ext PI g44) (fun _ => 0) /\ (forall t, e / l <= t < PI -> ext PI g44 t = 0).
Proof.
  destruct order as ([a b] & c & d). pose proof PI_RGT_0. split; [ | intros t Ht; rewrite on by lra; here ].
  assert (L : forall k m t, continuity_pt (fun t => k * t + m) t) by (intros; cont).
  apply half_period; trivial.
  - intros t. unfold drive. rewrite ext_anti by trivial. ring.
  - here.
  - intros t Ht. destruct (total_order_T t e) as [[k | k] | k]; [ | | destruct (total_order_T t (e / l)) as [[m | m] | m] ].
    + apply (cont_glue g44 (fun t => (1 - l) * t + 0) (fun t => (1 - l) * t + 0) t (e - t)); auto; try lra; intros s Hs; here.
    + apply (cont_glue g44 (fun t => (1 - l) * t + 0) (fun t => - l * t + e) t (e / l - e)); auto; try lra; intros s Hs; here; replace s with e by lra; lra.
    + apply (cont_glue g44 (fun t => - l * t + e) (fun t => - l * t + e) t (Rmin (t - e) (e / l - t))); auto; [ apply Rmin_pos; lra | | ]; intros s Hs;
        pose proof (Rmin_l (t - e) (e / l - t)); pose proof (Rmin_r (t - e) (e / l - t)); here.
    + apply (cont_glue g44 (fun t => - l * t + e) (fun t => 0 * t + 0) t (e / l - e)); auto; try lra; intros s Hs; here; replace s with (e / l) by lra; lra.
    + apply (cont_glue g44 (fun t => 0 * t + 0) (fun t => 0 * t + 0) t (t - e / l)); auto; try lra; intros s Hs; here.
  - assert (P : forall y, 0 <= y -> coulomb l y 0 (- l) 0).
    { intros y Hy. split; [ nra | ]. unfold nrm. replace (y ^ 2 + 0 ^ 2) with (Rsqr y) by (unfold Rsqr; ring). rewrite sqrt_Rsqr by trivial. ring. }
    intros t Ht. unfold drive. rewrite on by lra. destruct (Rlt_dec t e) as [k | k]; [ | destruct (Rlt_dec t (e / l)) as [m | m] ].
    + exists (- l). split; [ apply P; here; nra | ]. apply (rder_loc g44 (fun t => (1 - l) * t) t _ (e - t)); [ lra | intros s Hs; here | here; auto_derive; trivial; ring ].
    + exists (- l). split; [ apply P; here; nra | ]. apply (rder_loc g44 (fun t => (1 - l) * e - l * (t - e)) t _ (e / l - t)); [ lra | intros s Hs; here | here; auto_derive; trivial; ring ].
    + exists 0. split; [ split; [ nra | here; unfold nrm; replace (0 ^ 2 + 0 ^ 2) with 0 by ring; rewrite sqrt_0; ring ] | ].
      apply (rder_loc g44 (fun _ => 0) t _ 1); [ lra | intros s Hs; here | here; auto_derive; trivial; ring ].
Qed.
End Pulse.
