(* Section 2.4: friction that differs forward and backward, under the drive sin. q = lambda_- / lambda_+ is the ratio of the
   frictions, l = lambda0 the friction forward. slides, late_slide, reached, course are defined in Anisotropic/Slips.v. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion HalfPeriod Drawn Line Slips Regions Curves Transverse Formulas.
Open Scope R_scope.

(* where two sides are equal, by where either is larger *)
Lemma on_curve x y l c : (y < x <-> l < c) /\ (x < y <-> c < l) -> (x = y <-> l = c).
Proof. intros [[A A'] [B B']]. destruct (total_order_T l c) as [[k | k] | k]; lra. Qed.

(* At every q >= 1 and lambda0 > 0 there is a motion of the drive's period to which every motion is drawn. *)
Theorem at_large_times q l : 1 <= q -> 0 < l -> exists W, late_slide q l W.
Proof. apply late_slide_exists. Qed.
Ltac witness q l := let W := fresh "W" in let HW := fresh "HW" in destruct (at_large_times q l ltac:(lra) ltac:(lra)) as [W HW].

(* (51): while it slides forward the velocity has the rate sin - lambda0, at every moment of every motion. *)
Theorem eq_51 q l t0 w t : slides q l t0 w -> t0 <= t -> 0 < w t -> rder w t (eq51_rate l t).
Proof. intros M h p. destruct (l_law _ _ _ _ _ M t h) as (f & (_ & F & _) & X). rewrite F in X by trivial.
  eapply rder_eq; [ exact X | unfold eq51_rate; ring ]. Qed.
Lemma eq_51__occurs : ltac:(occurs eq_51).
Proof.
  intros H. destruct (late_exists 2 (1/2)) as (a & e & b & e' & W & HW & ([C _] & F & _) & _); try lra.
  exact (H 2 (1/2) _ W _ (ls_slides _ _ _ HW _) (Rle_refl _) (F ((a + e) / 2) ltac:(lra))).
Qed.

(* (52): while it slides backward, sin + q lambda0. *)
Theorem eq_52 q l t0 w t : slides q l t0 w -> t0 <= t -> w t < 0 -> rder w t (eq52_rate q l t).
Proof. intros M h p. destruct (l_law _ _ _ _ _ M t h) as (f & (_ & _ & F) & X). rewrite F in X by trivial. exact X. Qed.
Lemma eq_52__occurs : ltac:(occurs eq_52).
Proof.
  intros H. witness 1 (1/9). destruct (proj2 (back_where 1 (1/9) W ltac:(lra) ltac:(lra) HW)) as [t Ht]; [ |
  exact (H 1 (1/9) t W t (ls_slides _ _ _ HW t) (Rle_refl t) Ht) ].
  split; [ lra | ]. destruct Y_exists as (x & Y & _). destruct (Y_facts x Y). apply (below_C_E x); trivial; lra.
Qed.

(* (53), curve A: for each q one lambda0 has it, and the motion at large times has an interval of rest exactly above that. *)
Theorem eq_53 q l W : 1 <= q -> 0 < l -> late_slide q l W -> exists a, 0 < a < 1 /\
  (forall l, 0 < l -> (eq53_sides_1 (eq53_k q) l = eq53_sides_2 (eq53_k q) l <-> l = a)) /\
  ((exists s d, 0 < d /\ forall t, s <= t <= s + d -> W t = 0) <-> a < l).
Proof.
  intros hq h0 HW. destruct (A_splits q hq) as (a & ha & _ & S). exists a. split; [ trivial | split ].
  - intros k hk. apply on_curve, S, hk.
  - rewrite (rest_where q l W hq h0 HW). apply S, h0.
Qed.
Lemma eq_53__occurs : ltac:(occurs eq_53).
Proof. intros H. witness 2 (1/2). refine (H 2 (1/2) W _ _ HW); lra. Qed.

(* (54), curve B, up to C: where the drive begins to pull backward, at PI + arcsin (q lambda0), the motion at large times still goes forward
   exactly below B; on B and above it rests there. *)
Theorem eq_54 q l W : 1 <= q -> 0 < l -> q * l <= 1 -> late_slide q l W ->
  (0 < W (PI + asin (q * l)) <-> eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l)) /\
  (W (PI + asin (q * l)) = 0 <-> eq54_sides_1 l (q * l) <= eq54_sides_2 l (q * l)).
Proof. intros hq h0 h1 HW. destruct (forward_where q l W hq h0 HW h1) as [-> ->]. unfold below_B. lra. Qed.
Lemma eq_54__occurs : ltac:(occurs eq_54).
Proof. intros H. witness 2 (1/3). refine (H 2 (1/3) W _ _ _ HW); lra. Qed.
(* Up to the q of Y, Y included, one lambda0 up to 1/q is on B; beyond it none is: B ends at Y. *)
Theorem eq_54__one x q : is_Y x -> 1 <= q -> (q <= q_Y x -> exists b, 0 < b <= 1 / q /\ forall l, 0 < l <= 1 / q -> (eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l) <-> l = b)) /\
  (q_Y x < q -> forall l, 0 < l <= 1 / q -> eq54_sides_1 l (q * l) <> eq54_sides_2 l (q * l)).
Proof.
  intros Y hq. destruct (inv_q q hq) as (i & _). split.
  - intros h. destruct (B_root x q Y (conj hq h)) as (b & hb & _ & S). exists b. split; [ trivial | ]. intros l hl. apply on_curve, S, hl.
  - intros h l hl. pose proof (up_to_C_B x q l Y h hl) as B. unfold below_B in B. lra.
Qed.

(* (55), curve C, as corrected: up to the q of Y the motion at large times goes backward exactly below C. *)
Theorem eq_55 r q l W : is_Y r -> 1 <= q <= q_Y r -> 0 < l -> late_slide q l W -> ((exists t, W t < 0) <-> l < eq55_lambda0 q).
Proof.
  intros Y hq h0 HW. rewrite (back_where q l W ltac:(lra) h0 HW), C_q by lra. split; [ tauto | ]. intros h. split; trivial. now apply (below_C_E r).
Qed.
Lemma eq_55__occurs : ltac:(occurs eq_55).
Proof. intros H. destruct Y_exists as (x & Y & _). destruct (Y_facts x Y). witness 2 (1/3). refine (H x 2 (1/3) W Y _ _ HW); lra. Qed.
(* As printed it holds up to the q of Y and no further. *)
Theorem eq_55__printed x q : is_Y x -> 1 <= q -> ((forall l W, 0 < l -> late_slide q l W -> ((exists t, W t < 0) <-> l < eq55_lambda0 q)) <-> q <= q_Y x).
Proof.
  intros Y hq. split; [ | intros h l W h0 HW; now apply (eq_55 x) ]. intros P. apply Rnot_lt_le. intros k.
  destruct (E_root x q Y (Rlt_le _ _ k)) as (b & hb & bu & S).
  destruct (late_slide_exists q b hq ltac:(lra)) as [W HW]. assert (Q : exists t, W t < 0) by (apply (P b W); trivial; unfold eq55_lambda0; lra).
  apply (back_where q b W hq ltac:(lra) HW) in Q. apply proj2, (S b hb) in Q. lra.
Qed.

(* (56), curve D: the motion at large times moves at all exactly below D. *)
Theorem eq_56 q l W : 1 <= q -> 0 < l -> late_slide q l W -> ((exists t, W t <> 0) <-> l < eq56_lambda0).
Proof. exact (moves_where q l W). Qed.
Lemma eq_56__occurs : ltac:(occurs eq_56).
Proof. intros H. witness 2 (1/2). refine (H 2 (1/2) W _ _ HW); lra. Qed.

(* (57): A and B have this point in common, and no other with q >= 1 (of A none is beyond q lambda0 = 1, where B is not defined). *)
Theorem s24_X q l : 1 <= q -> 0 < l ->
  (eq53_sides_1 (eq53_k q) l = eq53_sides_2 (eq53_k q) l /\ eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l) <-> q = eq57_x_1 /\ l = eq57_x_2).
Proof.
  intros hq h0. unfold eq57_x_1. destruct (A_splits q hq) as (a & ha & a1 & S). split.
  - intros [A B]. apply (on_curve _ _ _ _ (S l h0)) in A. subst a. destruct (A_order q l hq ha) as (_ & _ & N); [ rewrite (proj2 (S l h0)); lra | ].
    destruct (Req_dec q 1) as [e | n]; [ auto | specialize (N ltac:(lra)); unfold below_B in N; lra ].
  - intros [-> ->]. rewrite <- a1 in * by trivial. destruct (at_1 a h0) as [B1 B2].
    assert (A : eq53_sides_1 (K 1) a = eq53_sides_2 (K 1) a) by now apply (on_curve _ _ _ _ (S a h0)). split; [ exact A | ].
    unfold below_A, above_A, below_B, above_B in *. lra.
Qed.
(* (57): the point is one, on both curves, and its lambda0 is lambda_c of (37). *)
Theorem eq_57 : eq57_x_2 = eq37_lambda_c /\ 0 < eq57_x_2 < 1 /\ eq53_sides_1 (eq53_k eq57_x_1) eq57_x_2 = eq53_sides_2 (eq53_k eq57_x_1) eq57_x_2 /\
  eq54_sides_1 eq57_x_2 (eq57_x_1 * eq57_x_2) = eq54_sides_2 eq57_x_2 (eq57_x_1 * eq57_x_2).
Proof.
  split; [ reflexivity | ]. destruct (A_splits 1 ltac:(lra)) as (a & ha & a1 & _). rewrite <- a1 by trivial. split; trivial. rewrite a1 by trivial.
  apply s24_X; [ | | split; trivial ]; unfold eq57_x_1; rewrite <- ?a1 by trivial; lra.
Qed.

(* B meets C at Y only, q = sqrt (1 + x^2) and lambda0 = 1/q with the least x > 0 that has tan x = x; and B touches C there: before Y
   it leaves it with the square of the distance. *)
Theorem s24_Y x : is_Y x -> (forall q l, 1 <= q -> (l = eq55_lambda0 q /\ eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l) <-> q = q_Y x /\ l = right_anisotropic_y_from_root_2 x)) /\
  forall q b, 1 <= q < q_Y x -> 0 < b <= eq55_lambda0 q -> eq54_sides_1 b (q * b) = eq54_sides_2 b (q * b) -> 0 < eq55_lambda0 q - b <= (q_Y x - q) ^ 2 / 8.
Proof.
  intros Y. split.
  - intros q l hq. destruct (corner x q Y hq) as (_ & _ & c & _). unfold side_B in c. split.
    + intros [-> B]. assert (q = q_Y x) as -> by (apply c; unfold eq55_lambda0 in B; lra). split; reflexivity.
    + intros [-> ->]. split; [ reflexivity | ]. unfold right_anisotropic_y_from_root_2. assert (Z := proj2 c eq_refl). unfold q_Y in Z.
      fold (q_Y x) in *. lra.
  - intros q b hq hb B. apply (B_touches_C x q b Y hq hb). unfold side_B. lra.
Qed.
(* (58): there is one such x, and Y's digits are as printed, to half of the last one. *)
Theorem eq_58 : exists x, is_Y x /\ (forall y, is_Y y -> y = x) /\ Rabs (q_Y x - eq58_y_1) < 1 / 2000 /\ Rabs (right_anisotropic_y_from_root_2 x - eq58_y_2) < 1 / 2000.
Proof.
  destruct Y_exists as (x & Y & hx). exists x. split; [ trivial | split; [ intros y Hy; now apply Y_unique | ] ].
  unfold q_Y, right_anisotropic_y_from_root_2, eq58_y_1, eq58_y_2. split; apply Rabs_def1; apply Rminus_gt_0_lt; interval with (i_prec 60).
Qed.

(* The velocity across the drive falls to 0, too, under a friction that depends on the direction, if it is nowhere weaker than some k0 > 0. *)
Theorem s24_vy_vanishes k k0 a Ax vx vy : 0 < k0 -> (forall ux uy, k0 <= k ux uy) -> (forall t, 0 <= t -> Rabs (Ax t) <= a) ->
  directed k Ax vx vy -> is_lim vy p_infty s24_late_vy.
Proof. apply across_directed. Qed.
Lemma s24_vy_vanishes__occurs : ltac:(occurs s24_vy_vanishes).
Proof.
  intros H. assert (N : forall y, 1 <= nrm 1 y) by (intros y; pose proof (abs_nrm 1 y) as [n _]; rewrite Rabs_R1 in n; exact n).
  refine (H (fun ux uy => Rmax 1 (nrm ux uy)) 1 1 (fun _ => -1) (fun _ => 1) (fun t => exp (- t)) _ _ _ _); [ lra | intros; apply Rmax_l | intros;
  rewrite Rabs_left; lra | ].
  split; [ intros; cont | intros; cont | ]. intros t _. exists (-1), (- exp (- t)). rewrite Rmax_right by apply N.
  repeat split; try ring; eapply rder_eq; (rd || ring).
Qed.
(* Without friction it need not. *)
Theorem s24_vy_vanishes__needs_friction : directed (fun _ _ => 0) (fun _ => 0) (fun _ => 0) (fun _ => 1).
Proof. split; [ intros; cont | intros; cont | ]. intros t _. exists 0, 0. repeat split; try ring; eapply rder_eq; (rd || ring). Qed.

(* A motion with q < 1 is, half a period later and the other way round, one with 1/q > 1 and the friction q lambda0 forward; and back. *)
Theorem s24_q_at_least_one q l t0 w : 0 < q -> (slides q l t0 w <-> slides (s24_mirrored_1 q l) (s24_mirrored_2 q l) (t0 + PI) (fun t => - w (t - PI))) /\ (q < 1 -> 1 < s24_mirrored_1 q l).
Proof.
  intros hq. unfold slides, eq50_lambda_minus, s24_mirrored_1, s24_mirrored_2. replace (1 / q * (q * l)) with l by (field; lra).
  split; [ | intros h; apply Rlt_div_r; lra ].
  assert (P : forall c, (forall t, sin (t - c) = - sin t) -> forall l m t0 w, line l m sin t0 w -> line m l sin (t0 + c) (fun t => - w (t - c))).
  { clear. intros c S l m t0 w [C L]. split; intros t Ht; [ apply (continuity_pt_opp (fun t => w (t - c))), cont_shift, C; lra | ].
    destruct (L (t - c)) as (f & F & X); [ lra | ]. exists (- f). split; [ unfold dry in *; repeat split; intros; lra | ].
    eapply rder_eq; [ apply (rder_opp (fun t => w (t - c))), rder_shift, X | rewrite S; ring ]. }
  split; intros M; [ apply P; trivial; intros; rewrite sin_minus, cos_PI, sin_PI; ring | ].
  apply (P (- PI)) in M; [ | intros; replace (t - - PI) with (t + PI) by ring; apply neg_sin ]. replace (t0 + PI + - PI) with t0 in M by ring.
  assert (E : forall t, - - w (t - - PI - PI) = w t) by (intros; rewrite Ropp_involutive; f_equal; ring). destruct M as [C L].
  split; intros t Ht; [ apply (continuity_pt_ext _ _ _ E); auto | ]. destruct (L t Ht) as (f & F & X). exists f. rewrite E in F. split; trivial.
  now apply (rder_ext _ _ _ _ (fun s _ => E s)).
Qed.
Lemma s24_q_at_least_one__occurs : ltac:(occurs s24_q_at_least_one). Proof. intros H. refine (H 1 1 0 (fun _ => 0) _). lra. Qed.

(* I, below A: forward, at once backward, and so on without rest; every motion is drawn to this one, and none rests from some time on. *)
Theorem s24_region_1 q l : 1 <= q -> 0 < l -> eq53_sides_2 (eq53_k q) l < eq53_sides_1 (eq53_k q) l ->
  exists a e W, late_slide q l W /\ course a e e (a + 2 * PI) W /\ a < e < a + 2 * PI /\ forall t0 w, slides q l t0 w -> restless w.
Proof.
  intros hq h0 bA. destruct (A_splits q hq) as (a0 & ha & _ & S). destruct (late_slide_exists q l hq h0) as [W HW].
  assert (hl : 0 < l < 1) by (apply S in bA; lra).
  destruct (proj1 (kinds q l W hq hl HW)) as (a & e & he & Co); [ unfold above_A; lra | ]. exists a, e, W.
  split; [ trivial | split; [ trivial | split; [ lra | now apply restless_I ] ] ].
Qed.
(* Without friction it need not: this motion never goes backward. *)
Theorem s24_region_1__needs_friction q : slides q 0 0 (fun t => 2 - cos t) /\ forall t, 0 < 2 - cos t.
Proof.
  split; [ | intros t; pose proof (COS_bound t); lra ]. split. intros t _. apply derivable_continuous_pt. reg. intros t _. pose proof (COS_bound t).
  exists 0. split.
  - unfold dry, eq50_lambda_minus. repeat split; intros; lra.
  - apply rder_of. auto_derive; trivial. ring.
Qed.

(* II, as corrected: above A, below B up to the q of Y and below E from there on: forward, at once backward, rest. Between E and C (beyond Y)
   nothing goes backward: forward, and rest. Every motion becomes this one. *)
Theorem s24_region_2 x q l : is_Y x -> 1 <= q -> 0 < l -> eq53_sides_1 (eq53_k q) l < eq53_sides_2 (eq53_k q) l -> l < eq55_lambda0 q ->
  ((q <= q_Y x -> eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l)) -> (q_Y x <= q -> right_anisotropic_e_sides_1 l (q * l) < right_anisotropic_e_sides_2 l (q * l)) ->
     exists a e e' W, e < e' < a + 2 * PI /\ late_slide q l W /\ reached q l W /\ course a e e e' W) /\
  (right_anisotropic_e_sides_2 l (q * l) < right_anisotropic_e_sides_1 l (q * l) -> exists a e W, e < a + 2 * PI /\ late_slide q l W /\ reached q l W /\ course a e e e W).
Proof.
  intros Y hq h0 A h1. apply C_q in h1; [ | lra ]. assert (hl : 0 < l < 1) by nra. destruct (late_slide_exists q l hq h0) as [W HW].
  destruct (kinds q l W hq hl HW) as (_ & K2 & _ & K4). destruct (inv_q q hq) as (_ & _ & i). split.
  - intros hB hE. destruct (K2 A h1) as (a & e & e' & he & R & Co); [ | | exists a, e, e', W; auto ].
    + destruct (Rle_lt_dec q (q_Y x)) as [k | k]; [ specialize (hB k) | pose proof (up_to_C_B x q l Y k ltac:(split; [ trivial | left;
      now apply i ])) as b; unfold below_B in b ]; unfold above_B; lra.
    + destruct (Rle_lt_dec q (q_Y x)) as [k | k]; [ apply (below_C_E x); trivial; lra | apply hE; lra ].
  - intros E. destruct K4 as (a & e & he & R & Co); [ unfold below_E; lra | exists a, e, W; auto ].
Qed.
(* As printed, below B and C, it holds up to the q of Y and no further. *)
Theorem s24_region_2__printed x q : is_Y x -> 1 <= q -> ((forall l W, 0 < l -> eq53_sides_1 (eq53_k q) l < eq53_sides_2 (eq53_k q) l ->
  eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l) -> l < eq55_lambda0 q -> late_slide q l W -> exists t, W t < 0) <-> q <= q_Y x).
Proof.
  intros Y hq. split.
  - intros P. apply Rnot_lt_le. intros k. destruct (E_root x q Y (Rlt_le _ _ k)) as (b & hb & bu & S). assert (b1 : b < 1 / q) by lra.
    destruct (late_slide_exists q b hq ltac:(lra)) as [W HW].
    assert (nE : ~ below_E q b) by (rewrite (proj1 (S b hb)); lra). assert (Q : exists t, W t < 0).
    { apply (P b W); trivial; [ lra | | now apply (up_to_C_B x) ]. apply Rnot_le_lt. intros nA. destruct (inv_q q hq) as (_ & _ & i).
      destruct (A_order q b hq) as (_ & E & _); [ split; [ lra | ]; destruct (i b) as [_ i']; apply i' in b1; nra | unfold above_A; lra |
      contradiction ]. }
    apply (back_where q b W hq ltac:(lra) HW) in Q. tauto.
  - intros k l W h0 _ _ h1 HW. apply (back_where q l W hq h0 HW). apply C_q in h1; [ | lra ]. split; trivial. now apply (below_C_E x).
Qed.
(* For one, at q = 9, lambda0 = 1/10 the three printed conditions hold, and no motion goes backward from some time on. *)
Theorem s24_region_2__at_9 : eq53_sides_1 (eq53_k 9) (1 / 10) < eq53_sides_2 (eq53_k 9) (1 / 10) /\ eq54_sides_2 (1 / 10) (9 * (1 / 10)) < eq54_sides_1 (1 / 10) (9 * (1 / 10)) /\ 1 / 10 < eq55_lambda0 9 /\
  forall t0 w, slides 9 (1 / 10) t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> 0 <= w t.
Proof.
  assert (S : forall x, -1 < x < 1 -> asin x = atan (x / sqrt (1 - x ^ 2))) by (intros x hx; rewrite asin_atan by trivial; do 4 f_equal;
  unfold Rsqr; ring).
  unfold eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, eq55_lambda0. rewrite !S by lra. unfold cot.
  split; [ interval with (i_prec 60) | split; [ interval with (i_prec 60) | split; [ lra | ] ] ].
  assert (E : ~ below_E 9 (1 / 10)) by (unfold below_E, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2; rewrite !S by lra;
  apply Rle_not_lt, Rminus_le; interval with (i_prec 60)).
  destruct (late_slide_exists 9 (1 / 10)) as [W HW]; [ lra | lra | ]. destruct (kinds 9 (1 / 10) W ltac:(lra) ltac:(lra) HW) as (_ & _ & _ & K4).
  destruct K4 as (a & e & he & R & Co); [ tauto | ].
  intros t0 w Hw. destruct (R t0 w Hw) as (t1 & h1 & ew). exists t1. split; trivial. intros t Ht. rewrite ew by trivial. apply Rnot_lt_le. intros n.
  assert (N : exists t, W t < 0) by eauto. apply (course_back W _ _ _ _ (ls_per _ _ _ HW) Co) in N. lra.
Qed.
(* III, between B and C: forward, rest, backward, rest. Every motion becomes this one. *)
Theorem s24_region_3 q l : 1 <= q -> 0 < l -> l < eq55_lambda0 q -> eq54_sides_1 l (q * l) < eq54_sides_2 l (q * l) ->
  exists a e b e' W, e < b < e' /\ e' < a + 2 * PI /\ late_slide q l W /\ reached q l W /\ course a e b e' W.
Proof.
  intros hq h0 h1 B. apply C_q in h1; [ | lra ]. destruct (late_slide_exists q l hq h0) as [W HW].
  destruct (kinds q l W hq ltac:(nra) HW) as (_ & _ & K3 & _).
  destruct (K3 h1 B) as (a & e & b & e' & (he & he') & R & Co). exists a, e, b, e', W. auto.
Qed.
(* IV, between C and D: forward, and rest. Every motion becomes this one. *)
Theorem s24_region_4 q l : 1 <= q -> eq55_lambda0 q <= l < eq56_lambda0 -> exists a e W, e < a + 2 * PI /\ late_slide q l W /\ reached q l W /\ course a e e e W.
Proof.
  unfold eq55_lambda0, eq56_lambda0. intros hq [h1 h2]. destruct (inv_q q hq) as (i0 & _ & i).
  destruct (late_slide_exists q l hq ltac:(lra)) as [W HW]. destruct (kinds q l W hq ltac:(lra) HW) as (_ & _ & _ & K4).
  destruct K4 as (a & e & he & R & Co); [ rewrite <- (proj2 (i l)); lra | exists a, e, W; auto ].
Qed.
(* V, above D: every motion comes to rest, with the speed |w| at t0 within the time |w| / (lambda0 - 1), and stays. *)
Theorem s24_region_5 q l t0 w : 1 <= q -> eq56_lambda0 < l -> slides q l t0 w -> forall t, t0 + Rabs (w t0) / (l - 1) <= t -> w t = 0.
Proof.
  unfold eq56_lambda0. intros hq hl Hw t Ht. assert (q * l >= l) by nra. set (x := Rabs (w t0) / (l - 1)) in *.
  assert (e : (l - 1) * x = Rabs (w t0)) by (unfold x; field; lra).
  pose proof (Rabs_pos (w t0)). assert (0 <= x) by nra. destruct (still q l hq ltac:(lra)) as [Z _ _].
  destruct (Req_dec (w t) 0) as [ | z]; trivial. apply abs_zero. enough (Rabs (w t) + (l - 1) * (t - t0) <= Rabs (w t0)) by nra. rewrite <- !nrm_x.
  apply (speed_falls _ _ _ _ _ _ _ (line_two _ _ _ _ _ _ Hw (Z t0))); [ lra | ]. intros y Hy. pose proof (SIN_bound y). unfold eq50_lambda_minus.
  rewrite nrm_x. split; [ trivial | split; [ | lra ] ]. intros e0. apply z.
  pose proof (line_contraction _ _ _ _ _ _ Hw (Z t0) y t ltac:(lra)) as C. cbv beta in C. rewrite !Rminus_0_r, e0 in C. now apply abs_zero.
Qed.
Lemma s24_region_5__occurs : ltac:(occurs s24_region_5).
Proof. intros H. destruct (late_slide_exists 2 2) as [W HW]; try lra.
  refine (H 2 2 0 W _ _ (ls_slides _ _ _ HW 0) _ (Rle_refl _)); unfold eq56_lambda0; lra. Qed.

(* Figure 5, corrected, for q > 1: A below B below C up to Y, and A below E, below C, from Y on, all below D. Between them the motion at large
   times is of the kinds I to V; m is B up to Y and E from Y on, c is C up to Y and E from Y on. *)
Theorem fig_5 r q : is_Y r -> 1 < q -> exists a m c, 0 < a < m /\ m <= c <= eq55_lambda0 q /\ eq53_sides_1 (eq53_k q) a = eq53_sides_2 (eq53_k q) a /\
  (q <= q_Y r -> eq54_sides_1 m (q * m) = eq54_sides_2 m (q * m) /\ c = eq55_lambda0 q /\ (m = c <-> q = q_Y r)) /\
  (q_Y r <= q -> right_anisotropic_e_sides_1 m (q * m) = right_anisotropic_e_sides_2 m (q * m) /\ c = m /\ (m = eq55_lambda0 q <-> q = q_Y r)) /\
  forall l W, 0 < l -> late_slide q l W ->
  (l < a -> exists a e, a < e < a + 2 * PI /\ course a e e (a + 2 * PI) W) /\ (a < l < m -> exists a e e', e < e' < a + 2 * PI /\ course a e e e' W) /\
  (m < l < c -> exists a e b e', e < b < e' /\ e' < a + 2 * PI /\ course a e b e' W) /\ (c < l < 1 -> exists a e, e < a + 2 * PI /\ course a e e e W) /\ (1 < l -> forall t, W t = 0).
Proof.
  intros Y hq. assert (hq1 : 1 <= q) by lra. destruct (A_splits q hq1) as (a & ha & _ & SA). destruct (inv_q q hq1) as (i & iq & il).
  destruct (A_order q a hq1 ha) as (qa & AE & AB); [ rewrite (proj2 (SA a (proj1 ha))); lra | ]. specialize (AB hq).
  assert (a1 : a < 1 / q) by now apply il.
  assert (X : exists m c, a < m <= c /\ c <= 1 / q /\ (q <= q_Y r -> (forall l,
  0 < l <= 1 / q -> (below_B q l <-> l < m) /\ (above_B q l <-> m < l)) /\ c = 1 / q /\ (m = c <-> q = q_Y r)) /\
    (q_Y r <= q -> (forall l, 0 < l <= 1 / q -> (below_E q l <-> l < m) /\ (above_E q l <-> m < l)) /\ c = m /\ (m = 1 / q <-> q = q_Y r))).
  { destruct (Rlt_le_dec (q_Y r) q) as [k | k].
    - destruct (E_root r q Y (Rlt_le _ _ k)) as (b & hb & bu & S). assert (a < b) by (apply S; [ lra | trivial ]). exists b, b.
      repeat split; trivial; try apply S; try tauto; intros; lra.
    - destruct (B_root r q Y (conj hq1 k)) as (b & hb & bu & S). assert (a < b) by (apply S; [ lra | trivial ]). exists b, (1 / q). and_so.
      split; [ tauto | ]. intros k'. assert (e : q = q_Y r) by lra. apply bu in e as ->.
      destruct (E_root r q Y k') as (b' & hb' & bu' & S'). assert (b' = 1 / q) as -> by (apply bu'; lra). tauto. }
  destruct X as (m & c & hm & hc & XB & XE). exists a, m, c.
  assert (1 / q < 1) by (apply Rlt_div_l; lra). split; [ lra | split; [ unfold eq55_lambda0; lra | split; [ now apply (on_curve _ _ _ _ (SA a (proj1 ha))) | split; [ |
  split ] ] ] ].
  { intros k. destruct (XB k) as (S & h). split; [ apply (on_curve _ _ _ _ (S m ltac:(lra))) | ]; trivial. }
  { intros k. destruct (XE k) as (S & h). split; [ symmetry | trivial ]. apply (on_curve _ _ _ _ (S m ltac:(lra))). trivial. }
  intros l W h0 HW. destruct (Rlt_le_dec 1 l) as [l1 | l1].
  { repeat (split; [ intros; lra | ]). intros _. apply (rest_above_1 q l W hq1 HW). lra. }
  destruct (Req_dec l 1) as [-> | n]. { repeat split; intros; exfalso; lra. }
  destruct (kinds q l W hq1 ltac:(lra) HW) as (K1 & K2 & K3 & K4). destruct (SA l h0) as [S1 S2]. destruct (il l) as [_ il'].
  split; [ intros h; apply K1; intros nA; apply S2 in nA; lra | split; [ | split; [ | split; [ | intros; lra ] ] ] ]; intros h.
  - assert (q1 : q * l < 1) by (apply il'; lra). destruct (K2 ltac:(tauto) q1) as (a' & e & e' & k); [ | | exists a', e, e'; tauto ].
    + destruct (Rle_lt_dec q (q_Y r)) as [k | k]; [ rewrite (proj2 (proj1 (XB k) l ltac:(lra))); lra | pose proof (up_to_C_B r q l Y k ltac:(lra));
      unfold above_B, below_B in *; lra ].
    + destruct (Rle_lt_dec q (q_Y r)) as [k | k]; [ apply (below_C_E r); trivial; lra | apply (proj1 (XE ltac:(lra))); lra ].
  - destruct (Rle_lt_dec q (q_Y r)) as [k | k]; [ | destruct (XE ltac:(lra)) as (_ & ? & _); lra ].
    destruct K3 as (a' & e & b & e' & k'); [ apply il'; lra | apply (proj1 (XB k)); lra | exists a', e, b, e'; tauto ].
  - destruct K4 as (a' & e & k'); [ | exists a', e; tauto ]. intros [q1 E]. apply il' in q1.
    destruct (Rle_lt_dec q (q_Y r)) as [k | k]; [ destruct (XB k); lra | ].
    destruct (XE ltac:(lra)) as (S & ? & _). apply S in E; lra.
Qed.
