(* 2.4, 3.4: the rates, the mirror, the sphere, the point X *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic Aniso Formulas.
Open Scope R_scope.

(* (51), (52): the rates while it moves *)
Theorem eq51 l q t0 w t : line l (q * l) sin t0 w -> t0 <= t -> 0 < w t -> rder w t (eq51_rate l t).
Proof. intros M h p. destruct (l_law _ _ _ _ _ M t h) as (f & (_ & F & _) & X). rewrite F in X by trivial. eapply rder_eq; [ exact X | unfold eq51_rate; ring ]. Qed.
Theorem eq52 l q t0 w t : line l (q * l) sin t0 w -> t0 <= t -> w t < 0 -> rder w t (eq52_rate q l t).
Proof. intros M h p. destruct (l_law _ _ _ _ _ M t h) as (f & (_ & _ & F) & X). rewrite F in X by trivial. exact X. Qed.

(* s24-q-at-least-one: half a period later and the other way round, forward and backward friction change places *)
Theorem s24_q_at_least_one l m t0 w : line l m sin t0 w <-> line m l sin (t0 + PI) (fun t => - w (t - PI)).
Proof.
  assert (P : forall l m t0 w, line l m sin t0 w -> line m l sin (t0 + PI) (fun t => - w (t - PI))).
  { clear. intros l m t0 w [c L]. split.
    - intros t Ht. apply (continuity_pt_opp (fun t => w (t - PI))). apply cont_shift, c. lra.
    - intros t Ht. destruct (L (t - PI)) as (f & (F1 & F2 & F3) & X); [ lra | ]. exists (- f). split.
      + split; [ lra | split; intros k; [ rewrite F3 | rewrite F2 ]; lra ].
      + eapply rder_eq. apply (rder_opp (fun t => w (t - PI))). apply rder_shift, X. rewrite sin_minus, cos_PI, sin_PI. ring. }
  split; [ apply P | ]. intros M. apply P in M. destruct M as [c L]. assert (S : forall t, sin (t - 2 * PI) = sin t) by (intros t; rewrite <- (sin_period (t - 2 * PI) 1); f_equal; simpl; ring).
  split.
  - intros t Ht. specialize (c (t + 2 * PI) ltac:(lra)). apply (continuity_pt_comp (fun t => t + 2 * PI)) in c; [ | cont ].
    apply (continuity_pt_ext (comp (fun t => - - w (t - PI - PI)) (fun t => t + 2 * PI))); trivial. intros s. unfold comp. rewrite Ropp_involutive. f_equal. ring.
  - intros t Ht. destruct (L (t + 2 * PI) ltac:(lra)) as (f & F & X). exists f. rewrite Ropp_involutive in F. replace (t + 2 * PI - PI - PI) with t in F by ring. split; trivial.
    destruct X as [G [X1 X2]]. exists (fun t => G (t + 2 * PI)). split.
    + replace (sin t + f) with (1 * (sin (t + 2 * PI) + f)) by (rewrite <- (S (t + 2 * PI)); replace (t + 2 * PI - 2 * PI) with t by ring; ring).
      apply (is_derive_comp G (fun t => t + 2 * PI)). exact X1. auto_derive; trivial; ring.
    + intros s Hs. rewrite X2 by lra. rewrite Ropp_involutive. f_equal. ring.
Qed.

(* s34-anisotropic, (85): a sphere that moves and turns along the line; F is the friction, o the spin about the other axis *)
Record sphere_line (m J rad l n : R) (a : R -> R) (t0 : R) (v o : R -> R) : Prop := {
  sl_c : forall t, t0 < t -> continuity_pt v t /\ continuity_pt o t;
  sl_law : forall t, t0 <= t -> exists F, dry (m * l) (m * n) (v t - rad * o t) F /\ rder v t (F / m + a t) /\ rder o t (- rad * F / J) }.
Theorem s34_anisotropic m J rad l n a t0 v o : 0 < m -> 0 < J -> sphere_line m J rad l n a t0 v o ->
  let b := 1 + m * rad ^ 2 / J in line (b * l) (b * n) a t0 (fun t => v t - rad * o t).
Proof.
  intros hm hJ [c L] b. assert (b0 : 0 < b). { unfold b. assert (0 <= m * rad ^ 2 / J); [ | lra ]. apply Rmult_le_pos; [ | left; now apply Rinv_0_lt_compat ]. pose proof (pow2_ge_0 rad). nra. }
  assert (bm : 0 < b / m) by (apply Rdiv_lt_0_compat; lra). assert (e : forall x, b * x = b / m * (m * x)) by (intros; field; lra). split.
  - intros t Ht. destruct (c t Ht). cont.
  - intros t Ht. destruct (L t Ht) as (F & ((F1 & F2) & F3 & F4) & X & Y). exists (b / m * F). split.
    + rewrite !e. split; [ split; nra | split; intros k ]. rewrite F3 by trivial; ring. rewrite F4 by trivial; ring.
    + eapply rder_eq. rd. unfold b. field. lra.
Qed.

(* s24-X, (57): at q = 1 the curves A and B pass through lambda_c, and only there *)
Lemma at_lambda_c l : 0 < l <= 1 -> (sqrt (1 - l ^ 2) = l * (PI / 2) <-> l = eq57_x_2).
Proof.
  intros hl. unfold eq57_x_2. pose proof PI_RGT_0. assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra). assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (apply pow2_sqrt; nra).
  assert (Q : 0 <= sqrt (1 - l ^ 2)) by apply sqrt_pos. assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (apply pow2_sqrt; nra). set (r := sqrt (4 + PI ^ 2)) in *. set (s := sqrt (1 - l ^ 2)) in *.
  assert (K : (l * r) ^ 2 = l ^ 2 * (4 + PI ^ 2)) by (rewrite <- S2; ring). split; intros E.
  - rewrite E in Q2. apply (Rmult_eq_reg_r r); [ | lra ]. replace (2 / r * r) with 2 by (field; lra). apply Rsqr_inj; [ nra | lra | rewrite !Rsqr_pow2; nra ].
  - apply Rsqr_inj; [ trivial | nra | rewrite !Rsqr_pow2, Q2 ]. assert (l * r = 2) by (rewrite E; field; lra). rewrite H0 in K. nra.
Qed.
Theorem s24_X l : 0 < l <= 1 -> (eq53_sides_1 (eq53_k eq57_x_1) l = eq53_sides_2 (eq53_k eq57_x_1) l <-> l = eq57_x_2) /\
  (eq54_sides_1 l (eq57_x_1 * l) = eq54_sides_2 l (eq57_x_1 * l) <-> l = eq57_x_2).
Proof.
  intros hl. rewrite <- (at_lambda_c l hl). unfold eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, eq57_x_1, cot.
  replace (PI * 1 / (1 + 1)) with (PI / 2) by field. rewrite sin_PI2, cos_PI2, !Rmult_1_l. split; split; intros E.
  - apply (Rmult_eq_reg_r (/ l)); [ | apply Rinv_neq_0_compat; lra ]. unfold Rdiv in E at 1. rewrite E. field. lra.
  - rewrite E. field. lra.
  - lra.
  - lra.
Qed.
