(* 2.4: each region holds a point: the theorems on regions are of something *)
Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Formulas Regions.
Open Scope R_scope.
Lemma asin_as_atan x y : -1 < x < 1 -> y = x / sqrt (1 - x ^ 2) -> asin x = atan y.
Proof. intros h ->. rewrite asin_atan by trivial. do 4 f_equal. unfold Rsqr. ring. Qed.
Ltac sides := unfold eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, eq55_lambda0, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2, cot.
Ltac asins := repeat match goal with |- context [asin ?x] => rewrite (asin_as_atan x _ ltac:(lra) eq_refl) end; interval with (i_prec 60).

(* I: q = 2, lambda0 = 1/5 *)
Theorem point_1 : eq53_sides_2 (eq53_k 2) (1 / 5) < eq53_sides_1 (eq53_k 2) (1 / 5).
Proof. sides. interval with (i_prec 60). Qed.
(* II: q = 2, lambda0 = 7/20 *)
Theorem point_2 : 7 / 20 < eq55_lambda0 2 /\ eq53_sides_1 (eq53_k 2) (7 / 20) < eq53_sides_2 (eq53_k 2) (7 / 20) /\
  eq54_sides_2 (7 / 20) (2 * (7 / 20)) < eq54_sides_1 (7 / 20) (2 * (7 / 20)) /\ right_anisotropic_e_sides_1 (7 / 20) (2 * (7 / 20)) < right_anisotropic_e_sides_2 (7 / 20) (2 * (7 / 20)).
Proof. sides. repeat split; [ lra | interval with (i_prec 60) | asins | asins ]. Qed.
(* III: q = 2, lambda0 = 9/20 *)
Theorem point_3 : 9 / 20 < eq55_lambda0 2 /\ eq54_sides_1 (9 / 20) (2 * (9 / 20)) < eq54_sides_2 (9 / 20) (2 * (9 / 20)).
Proof. sides. split; [ lra | asins ]. Qed.
(* IV: q = 2, lambda0 = 1/2 *)
Theorem point_4 : eq55_lambda0 2 <= 1 / 2 < 1.
Proof. sides. lra. Qed.
