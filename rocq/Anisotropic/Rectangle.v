(* 2.4: a whole rectangle of region II as printed, in which nothing goes back *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion Periodic Aniso Formulas Regions Points.
Open Scope R_scope.

Lemma rectangle l q : 9 <= q <= 9.5 -> 0.1 <= l <= 0.105 -> printed_region_2 q l /\ above_E q l.
Proof.
  intros hq hl. assert (b : 0.9 <= q * l <= 0.9975) by (split; nra).
  unfold printed_region_2, above_E, eq55_lambda0. unfold eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2, cot.
  rewrite (asin_as_atan l _ ltac:(lra) eq_refl), (asin_as_atan (q * l) _ ltac:(lra) eq_refl). set (m := q * l) in *. clearbody m.
  split; [ split; [ | split ] | ].
  - apply Rminus_gt_0_lt. interval with (i_prec 60, i_bisect q, i_bisect l).
  - apply Rminus_gt_0_lt. interval with (i_prec 60, i_bisect m, i_bisect l).
  - apply Rlt_div_r; [ lra | ]. nra.
  - apply Rminus_le. interval with (i_prec 60, i_bisect m, i_bisect l).
Qed.
Theorem s24_region_2_wrong_on_a_rectangle l q : 9 <= q <= 9.5 -> 0.1 <= l <= 0.105 -> printed_region_2 q l /\
  exists W, steady l (q * l) W /\ reached l (q * l) W /\ (forall t, 0 <= W t) /\ exists t, 0 < W t.
Proof.
  intros hq hl. destruct (rectangle l q hq hl) as [P E]. split; trivial. destruct (s24_between_E_and_C l q) as (e & W & He & S & R & F & Z); trivial; try lra; [ apply P | ].
  exists W. split; [ trivial | split; [ trivial | split ] ]. apply (never_back l q W e); trivial; lra.
  pose proof PI_RGT_0. assert (a : asin l < e). { destruct (Steady.p1_range l ltac:(lra)) as [[? ?] _]. destruct (Steady.p1_range (q * l)) as [[? ?] _]. split; nra. lra. }
  exists ((asin l + e) / 2). apply F. lra.
Qed.
