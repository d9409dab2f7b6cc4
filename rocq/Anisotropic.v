(* Section 2.4: friction that differs forward and backward, under the drive sin. q = lambda_- / lambda_+ is the ratio of the
   frictions, l = lambda0 the friction forward. slides, late_slide, reached, course are defined in Anisotropic/Slips.v. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion HalfPeriod Drawn Line Slips Regions Curves Transverse Formulas.
Open Scope R_scope.

Ltac emptied T := lazymatch T with
  | forall x : ?A, @?B x => constr:(forall x : A, ltac:(let b := eval cbv beta in (B x) in let r := emptied b in exact r))
  | _ => constr:(False) end.
Ltac occurs t := let T := type of t in let r := emptied T in exact (~ r).

(* At every q >= 1 and lambda0 > 0 there is a motion of the drive's period to which every motion is drawn. *)
Theorem at_large_times q l : 1 <= q -> 0 < l -> exists W, late_slide q l W.
Proof. apply late_slide_exists. Qed.
Ltac witness q l := let W := fresh "W" in let HW := fresh "HW" in destruct (at_large_times q l ltac:(lra) ltac:(lra)) as [W HW].

(* (51): while it slides forward the velocity has the rate sin - lambda0, at every moment of every motion. *)
Theorem eq_51 q l t0 w t : slides q l t0 w -> t0 <= t -> 0 < w t -> rder w t (eq51_rate l t).
Proof. intros M h p. destruct (l_law _ _ _ _ _ M t h) as (f & (_ & F & _) & X). rewrite F in X by trivial. eapply rder_eq; [ exact X | unfold eq51_rate; ring ]. Qed.
Lemma eq_51__occurs : ltac:(occurs eq_51).
Proof.
  intros H. destruct (region_4 2 (1/2)) as (e & W & _ & HW & _ & ([C _] & F & _) & _); try lra. exact (H 2 (1/2) _ W _ (ls_slides _ _ _ HW _) (Rle_refl _) (F ((asin (1/2) + e) / 2) ltac:(lra))).
Qed.

(* (52): while it slides backward, sin + q lambda0. *)
Theorem eq_52 q l t0 w t : slides q l t0 w -> t0 <= t -> w t < 0 -> rder w t (eq52_rate q l t).
Proof. intros M h p. destruct (l_law _ _ _ _ _ M t h) as (f & (_ & _ & F) & X). rewrite F in X by trivial. exact X. Qed.
Lemma eq_52__occurs : ltac:(occurs eq_52).
Proof.
  intros H. witness 1 (1/9). destruct (proj2 (back_where 1 (1/9) W ltac:(lra) ltac:(lra) HW)) as [t Ht]; [ | exact (H 1 (1/9) t W t (ls_slides _ _ _ HW t) (Rle_refl t) Ht) ].
  split; [ lra | ]. destruct Y_exists as (x & Y & _). destruct (Y_facts x Y). apply (below_C_E x); trivial; lra.
Qed.

(* (53), curve A: for each q one lambda0 has it, and the motion at large times has an interval of rest exactly above that. *)
Theorem eq_53 q l W : 1 <= q -> 0 < l -> late_slide q l W -> exists a, 0 < a < 1 /\
  (forall l, 0 < l -> (eq53_sides_1 (eq53_k q) l = eq53_sides_2 (eq53_k q) l <-> l = a)) /\
  ((exists s d, 0 < d /\ forall t, s <= t <= s + d -> W t = 0) <-> a < l).
Proof.
  intros hq h0 HW. destruct (A_exists q hq) as (a & ha & A). exists a. split; [ trivial | split ].
  - intros k hk. destruct (A_sides q a k hq ltac:(lra) A hk) as [S1 S2]. unfold below_A, above_A in *. split; [ intros e; lra | intros ->; exact A ].
  - rewrite (rest_where q l W hq h0 HW). apply A_sides; trivial; lra.
Qed.
Lemma eq_53__occurs : ltac:(occurs eq_53).
Proof. intros H. witness 2 (1/2). refine (H 2 (1/2) W _ _ HW); lra. Qed.

(* (54), curve B: where the drive begins to pull backward, at PI + arcsin (q lambda0), the motion at large times still goes forward
   exactly below B; on B and above it rests there. *)
Theorem eq_54 q l W : 1 <= q -> 0 < l -> q * l < 1 -> late_slide q l W ->
  (0 < W (PI + asin (q * l)) <-> eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l)) /\
  (W (PI + asin (q * l)) = 0 <-> eq54_sides_1 l (q * l) <= eq54_sides_2 l (q * l)).
Proof. intros hq h0 h1 HW. destruct (forward_where q l W hq h0 HW h1) as [-> ->]. unfold below_B. split; split; intros; lra. Qed.
Lemma eq_54__occurs : ltac:(occurs eq_54).
Proof. intros H. witness 2 (1/3). refine (H 2 (1/3) W _ _ _ HW); lra. Qed.
(* Up to the q of Y, Y included, one lambda0 up to 1/q is on B; beyond it none is: B ends at Y. *)
Theorem eq_54__one x q : is_Y x -> 1 <= q -> (q <= q_Y x -> exists b, 0 < b <= 1 / q /\ forall l, 0 < l <= 1 / q -> (eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l) <-> l = b)) /\
  (q_Y x < q -> forall l, 0 < l <= 1 / q -> eq54_sides_1 l (q * l) <> eq54_sides_2 l (q * l)).
Proof.
  intros Y hq. destruct (Y_facts x Y) as (y3 & _). assert (i : q * (1 / q) = 1) by (field; lra). assert (j : forall l, l <= 1 / q -> q * l <= 1) by (intros; rewrite <- i; apply Rmult_le_compat_l; lra).
  assert (i0 : 0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). assert (i1 : 1 / q <= 1) by (apply Rle_div_l; lra). split.
  - intros h. enough (E : exists b, 0 < b <= 1 / q /\ on_B q b).
    { destruct E as (b & hb & B). exists b. split; trivial. intros l hl. destruct (B_sides q b l hq) as [S1 S2]; auto; try lra; [ apply j; lra | apply j; lra | ].
      unfold below_B, above_B in *. split; [ intros e; lra | intros ->; exact B ]. }
    destruct (Req_dec q (q_Y x)) as [e | n]. { exists (1 / q). split; [ lra | ]. now apply (B_meets_C x q). }
    destruct (Req_dec q 1) as [-> | n1].
    + destruct (A_exists 1 ltac:(lra)) as (a & ha & A). exists a. split; [ lra | ]. apply A_B_at_1 in A; [ | lra ]. apply A_B_at_1; lra.
    + destruct (A_exists q hq) as (a & ha & A). destruct (B_exists x q a Y ltac:(lra) ltac:(lra) A) as (b & hb & B). exists b. split; trivial. lra.
  - intros h l hl e. destruct (Req_dec l (1 / q)) as [-> | n]. { apply (B_meets_C x q (1 / q) Y hq eq_refl) in e. lra. }
    assert (b : below_B q l) by (apply (below_C_B x); trivial; try lra; apply C_q; [ lra | unfold eq55_lambda0; lra ]). unfold below_B in b. lra.
Qed.

(* (55), curve C, as corrected: up to the q of Y the motion at large times goes backward exactly below C. *)
Theorem eq_55 r q l W : is_Y r -> 1 <= q <= q_Y r -> 0 < l -> late_slide q l W -> ((exists t, W t < 0) <-> l < eq55_lambda0 q).
Proof.
  intros Y hq h0 HW. rewrite (back_where q l W ltac:(lra) h0 HW), C_q by lra. split; [ now intros [h _] | ]. intros h. split; trivial. now apply (below_C_E r).
Qed.
Lemma eq_55__occurs : ltac:(occurs eq_55).
Proof. intros H. destruct Y_exists as (x & Y & _). destruct (Y_facts x Y). witness 2 (1/3). refine (H x 2 (1/3) W Y _ _ HW); lra. Qed.
(* As printed it holds up to the q of Y and no further. *)
Theorem eq_55__printed x q : is_Y x -> 1 <= q -> ((forall l W, 0 < l -> late_slide q l W -> ((exists t, W t < 0) <-> l < eq55_lambda0 q)) <-> q <= q_Y x).
Proof.
  intros Y hq. split; [ | intros h l W h0 HW; now apply (eq_55 x) ]. intros P. apply Rnot_lt_le. intros k. destruct (A_exists q hq) as (a & ha & A).
  destruct (E_exists x q a Y k ltac:(lra) A) as (b & hb & E). destruct (late_slide_exists q b hq ltac:(lra)) as [W HW].
  pose proof (proj2 (P b W ltac:(lra) HW) (proj2 hb)) as Q. apply (back_where q b W hq ltac:(lra) HW) in Q. destruct Q as [_ Q]. unfold below_E, on_E in *. lra.
Qed.

(* (56), curve D: the motion at large times moves at all exactly below D. *)
Theorem eq_56 q l W : 1 <= q -> 0 < l -> late_slide q l W -> ((exists t, W t <> 0) <-> l < eq56_lambda0).
Proof. exact (moves_where q l W). Qed.
Lemma eq_56__occurs : ltac:(occurs eq_56).
Proof. intros H. witness 2 (1/2). refine (H 2 (1/2) W _ _ HW); lra. Qed.

(* (57): A and B have this point in common, and no other with q >= 1 and q lambda0 <= 1, where B is defined. *)
Theorem s24_X q l : 1 <= q -> 0 < l -> q * l <= 1 ->
  (eq53_sides_1 (eq53_k q) l = eq53_sides_2 (eq53_k q) l /\ eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l) <-> q = eq57_x_1 /\ l = eq57_x_2).
Proof.
  intros hq h0 h1. unfold eq57_x_1. split.
  - intros [A B]. destruct (A_order q l hq h0 A) as (l1 & _ & _ & _ & N). destruct (Req_dec q 1) as [-> | n]; [ | specialize (N ltac:(lra)); unfold below_B in N; lra ].
    split; trivial. apply A_B_at_1; [ lra | exact B ].
  - intros [-> ->]. split; apply A_B_at_1; trivial; lra.
Qed.
(* (57): the point is one, on both curves, and its lambda0 is lambda_c of (37). *)
Theorem eq_57 : eq57_x_2 = eq37_lambda_c /\ 0 < eq57_x_2 < 1 /\ eq53_sides_1 (eq53_k eq57_x_1) eq57_x_2 = eq53_sides_2 (eq53_k eq57_x_1) eq57_x_2 /\
  eq54_sides_1 eq57_x_2 (eq57_x_1 * eq57_x_2) = eq54_sides_2 eq57_x_2 (eq57_x_1 * eq57_x_2).
Proof.
  split; [ reflexivity | ]. assert (b : 0 < eq57_x_2 < 1).
  { unfold eq57_x_2. pose proof PI_RGT_0. assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra). assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (apply pow2_sqrt; nra).
    split; [ apply Rdiv_lt_0_compat | apply Rlt_div_l ]; nra. }
  split; trivial. apply s24_X; [ | | unfold eq57_x_1 | split; trivial ]; unfold eq57_x_1; lra.
Qed.

(* B meets C at Y only, q = sqrt (1 + x^2) and lambda0 = 1/q with the least x > 0 that has tan x = x; and B touches C there: just before Y
   it leaves it with the square of the distance. *)
Theorem s24_Y x : is_Y x -> (forall q l, 1 <= q -> (l = eq55_lambda0 q /\ eq54_sides_1 l (q * l) = eq54_sides_2 l (q * l) <-> q = q_Y x /\ l = right_anisotropic_y_from_root_2 x)) /\
  forall q b, 4 <= q < q_Y x -> 0 < b <= eq55_lambda0 q -> eq54_sides_1 b (q * b) = eq54_sides_2 b (q * b) -> 0 < eq55_lambda0 q - b <= (q_Y x - q) ^ 2.
Proof.
  intros Y. split.
  - intros q l hq. split.
    + intros [e B]. apply (B_meets_C x q l Y hq e) in B. rewrite e, B. split; reflexivity.
    + intros [-> ->]. split; [ reflexivity | ]. apply (B_meets_C x (q_Y x)); trivial.
  - intros q b hq hb B. apply (B_touches_C x q b Y hq (proj1 hb)); trivial. destruct hb as [_ hb]. unfold eq55_lambda0 in hb. apply (Rmult_le_compat_l q) in hb; [ | lra ]. replace (q * (1 / q)) with 1 in hb by (field; lra). trivial.
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
  intros H. set (vy t := if Rlt_dec t 1 then 1 - t else 0). assert (C : forall k m t, continuity_pt (fun t => k * t + m) t) by (intros; cont).
  refine (H (fun ux _ => if Rlt_dec ux 0 then 2 else 1) 1 0 (fun _ => 0) (fun _ => 0) vy _ _ _ _); [ lra | intros; destruct Rlt_dec; lra | intros; rewrite Rabs_R0; lra | ].
  split; [ intros; cont | intros t _ | intros t _ ].
  - destruct (total_order_T t 1) as [[k | ->] | k].
    + apply (cont_glue vy (fun t => -1 * t + 1) (fun t => -1 * t + 1) t (1 - t)); auto; [ lra | | ]; intros s Hs; unfold vy; destruct (Rlt_dec s 1); lra.
    + apply (cont_glue vy (fun t => -1 * t + 1) (fun t => 0 * t + 0) 1 1); auto; [ lra | | ]; intros s Hs; unfold vy; destruct (Rlt_dec s 1); lra.
    + apply (cont_glue vy (fun t => 0 * t + 0) (fun t => 0 * t + 0) t (t - 1)); auto; [ lra | | ]; intros s Hs; unfold vy; destruct (Rlt_dec s 1); lra.
  - destruct (Rlt_dec 0 0) as [n | _]; [ lra | ]. destruct (Rlt_le_dec t 1) as [k | k]; exists 0; eexists; (split; [ eapply rder_eq; [ rd | ring ] | ]).
    + split; [ apply (rder_loc vy (fun t => 1 - t) t _ (1 - t)); [ lra | intros s Hs; unfold vy; destruct (Rlt_dec s 1); lra | auto_derive; trivial; ring_simplify; reflexivity ] | ].
      rewrite Rmult_0_r. unfold vy. destruct (Rlt_dec t 1); [ | lra ]. unfold nrm. replace (0 ^ 2 + (1 - t) ^ 2) with (Rsqr (1 - t)) by (unfold Rsqr; ring). rewrite sqrt_Rsqr by lra. split; ring.
    + split; [ apply (rder_loc vy (fun _ => 0) t _ 1); [ lra | intros s Hs; unfold vy; destruct (Rlt_dec s 1); lra | auto_derive; trivial ] | ].
      unfold vy. destruct (Rlt_dec t 1); [ lra | ]. split; ring.
Qed.
(* Without friction it need not. *)
Theorem s24_vy_vanishes__needs_friction : directed (fun _ _ => 0) (fun _ => 0) (fun _ => 0) (fun _ => 1).
Proof. split; [ intros; cont | intros; cont | ]. intros t _. exists 0, 0. repeat split; try ring; eapply rder_eq; (rd || ring). Qed.

(* A motion with q < 1 is, half a period later and the other way round, one with 1/q > 1 and the friction q lambda0 forward; and back. *)
Theorem s24_q_at_least_one q l t0 w : 0 < q -> (slides q l t0 w <-> slides (s24_mirrored_1 q l) (s24_mirrored_2 q l) (t0 + PI) (fun t => - w (t - PI))) /\ (q < 1 -> 1 < s24_mirrored_1 q l).
Proof.
  intros hq. unfold slides, eq50_lambda_minus, s24_mirrored_1, s24_mirrored_2. replace (1 / q * (q * l)) with l by (field; lra). split.
  2: { intros h. apply Rlt_div_r; lra. }
  assert (P : forall l m t0 w, line l m sin t0 w -> line m l sin (t0 + PI) (fun t => - w (t - PI))).
  { clear. intros l m t0 w [c L]. split.
    - intros t Ht. apply (continuity_pt_opp (fun t => w (t - PI))). apply cont_shift, c. lra.
    - intros t Ht. destruct (L (t - PI)) as (f & (F1 & F2 & F3) & X); [ lra | ]. exists (- f). split.
      + split; [ lra | split; intros k; [ rewrite F3 | rewrite F2 ]; lra ].
      + eapply rder_eq. apply (rder_opp (fun t => w (t - PI))). apply rder_shift, X. rewrite sin_minus, cos_PI, sin_PI. ring. }
  split; [ apply P | ]. intros M. apply P in M. destruct M as [c L]. split.
  - intros t Ht. apply (continuity_pt_ext (fun t => - - w (t - PI - PI + 2 * PI))). intros s. rewrite Ropp_involutive. f_equal. ring.
    apply (continuity_pt_ext (fun s => (fun t => - - w (t - PI - PI)) (2 * PI + s))). intros s. do 3 f_equal. ring. apply (cont_phase (fun t => - - w (t - PI - PI)) (2 * PI) t), c. lra.
  - intros t Ht. destruct (L (2 * PI + t) ltac:(lra)) as (f & F & X). exists f. rewrite Ropp_involutive in F. replace (2 * PI + t - PI - PI) with t in F by ring. split; trivial.
    replace (sin t) with (sin (2 * PI + t)) by (rewrite Rplus_comm; apply sin_per). apply rder_phase in X. apply (rder_near w (fun s => - - w (2 * PI + s - PI - PI)) t _ 1); [ lra | | exact X ].
    intros s _. rewrite Ropp_involutive. f_equal. ring.
Qed.
Lemma s24_q_at_least_one__occurs : ltac:(occurs s24_q_at_least_one). Proof. intros H. refine (H 1 1 0 (fun _ => 0) _). lra. Qed.

(* I, below A: forward, at once backward, and so on without rest; every motion is drawn to this one, and none rests from some time on. *)
Theorem s24_region_1 q l : 1 <= q -> 0 < l -> eq53_sides_2 (eq53_k q) l < eq53_sides_1 (eq53_k q) l ->
  exists a e W, late_slide q l W /\ course a e e (a + 2 * PI) W /\ a < e < a + 2 * PI /\ forall t0 w, slides q l t0 w -> restless w.
Proof.
  intros hq h0 bA. destruct (region_1 q l hq h0 ltac:(unfold above_A; lra)) as (W & HW & Co & _). destruct (K_facts q hq) as (k & _). exists (middle q l - K q), (middle q l + K q), W.
  split; [ trivial | split; [ trivial | split; [ lra | ] ] ]. now apply restless_I.
Qed.
(* Without friction it need not: this motion never goes backward. *)
Theorem s24_region_1__needs_friction q : slides q 0 0 (fun t => 2 - cos t) /\ forall t, 0 < 2 - cos t.
Proof.
  split; [ | intros t; pose proof (COS_bound t); lra ]. split. intros t _. apply derivable_continuous_pt. reg. intros t _. pose proof (COS_bound t). exists 0. split.
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
  intros Y hq h0 A h1. apply C_q in h1; [ | lra ]. assert (hm : 0 < q * l < 1) by nra. assert (hl : 0 < l < 1) by nra. split.
  - intros hB hE. assert (B : ~ above_B q l). { destruct (Rle_lt_dec q (q_Y x)) as [k | k]; [ specialize (hB k) | pose proof (below_C_B x q l Y ltac:(lra) h0 h1) as b; unfold below_B in b ]; unfold above_B; lra. }
    assert (E : below_E q l) by (destruct (Rle_lt_dec q (q_Y x)) as [k | k]; [ apply (below_C_E x); trivial; lra | apply hE; lra ]).
    destruct (region_2 q l hq hl hm A B E) as (e & e' & W & he & _ & he' & HW & R & Co). exists (asin l), e, e', W. split; [ lra | auto ].
  - intros E. destruct (region_4 q l hq hl) as (e & W & he & HW & R & Co & _). right. split; [ trivial; lra | unfold below_E; lra ]. exists (asin l), e, W. split; [ lra | auto ].
Qed.
(* As printed, below B and C, it holds up to the q of Y and no further. *)
Theorem s24_region_2__printed x q : is_Y x -> 1 <= q -> ((forall l W, 0 < l -> eq53_sides_1 (eq53_k q) l < eq53_sides_2 (eq53_k q) l ->
  eq54_sides_2 l (q * l) < eq54_sides_1 l (q * l) -> l < eq55_lambda0 q -> late_slide q l W -> exists t, W t < 0) <-> q <= q_Y x).
Proof.
  intros Y hq. split.
  - intros P. apply Rnot_lt_le. intros k. destruct (A_exists q hq) as (a & ha & A). destruct (E_exists x q a Y k ltac:(lra) A) as (b & hb & E). destruct (late_slide_exists q b hq ltac:(lra)) as [W HW].
    assert (qb : q * b < 1) by (apply C_q; [ lra | apply hb ]). assert (Q : exists t, W t < 0).
    { apply (P b W); trivial; [ lra | apply (A_sides q a b hq); trivial; lra | apply (below_C_B x); trivial; lra | apply hb ]. }
    apply (back_where q b W hq ltac:(lra) HW) in Q. destruct Q as [_ Q]. unfold below_E, on_E in *. lra.
  - intros k l W h0 _ _ h1 HW. apply (back_where q l W hq h0 HW). apply C_q in h1; [ | lra ]. split; trivial. now apply (below_C_E x).
Qed.
(* For one, at q = 9, lambda0 = 1/10 the three printed conditions hold, and no motion goes backward from some time on. *)
Theorem s24_region_2__at_9 : eq53_sides_1 (eq53_k 9) (1 / 10) < eq53_sides_2 (eq53_k 9) (1 / 10) /\ eq54_sides_2 (1 / 10) (9 * (1 / 10)) < eq54_sides_1 (1 / 10) (9 * (1 / 10)) /\ 1 / 10 < eq55_lambda0 9 /\
  forall t0 w, slides 9 (1 / 10) t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> 0 <= w t.
Proof.
  assert (S : forall x, -1 < x < 1 -> asin x = atan (x / sqrt (1 - x ^ 2))) by (intros x hx; rewrite asin_atan by trivial; do 4 f_equal; unfold Rsqr; ring).
  unfold eq53_sides_1, eq53_sides_2, eq53_k, eq54_sides_1, eq54_sides_2, eq55_lambda0. rewrite !S by lra. unfold cot. split; [ interval with (i_prec 60) | split; [ interval with (i_prec 60) | split; [ lra | ] ] ].
  assert (E : ~ below_E 9 (1 / 10)) by (unfold below_E, right_anisotropic_e_sides_1, right_anisotropic_e_sides_2; rewrite !S by lra; apply Rle_not_lt, Rminus_le; interval with (i_prec 60)).
  intros t0 w Hw. assert (D : 1 <= 9 * (1 / 10) \/ (9 * (1 / 10) < 1 /\ ~ below_E 9 (1 / 10))) by (right; split; [ lra | exact E ]).
  destruct (region_4 9 (1 / 10) ltac:(lra) ltac:(lra) D) as (e & W & he & HW & Re & Co & _). destruct (Re t0 w Hw) as (t1 & h1 & ew). exists t1. split; trivial. intros t Ht. rewrite ew by trivial. apply Rnot_lt_le. intros n.
  destruct (proj1 (back_where 9 (1 / 10) W ltac:(lra) ltac:(lra) HW) (ex_intro _ t n)) as [_ b]. contradiction.
Qed.
(* III, between B and C: forward, rest, backward, rest. Every motion becomes this one. *)
Theorem s24_region_3 q l : 1 <= q -> 0 < l -> l < eq55_lambda0 q -> eq54_sides_1 l (q * l) < eq54_sides_2 l (q * l) ->
  exists a e b e' W, e < b < e' /\ e' < a + 2 * PI /\ late_slide q l W /\ reached q l W /\ course a e b e' W.
Proof.
  intros hq h0 h1 B. apply C_q in h1; [ | lra ]. assert (hm : 0 < q * l < 1) by nra. assert (hl : 0 < l < 1) by nra.
  destruct (region_3 q l hq hl hm B) as (e & e' & W & he & he' & HW & R & Co). exists (asin l), e, (PI + asin (q * l)), e', W. split; [ lra | split; [ lra | auto ] ].
Qed.
(* So there is no region III beyond Y. *)
Theorem s24_region_3__ends x q l : is_Y x -> 1 <= q -> 0 < l -> l < eq55_lambda0 q -> eq54_sides_1 l (q * l) < eq54_sides_2 l (q * l) -> q < q_Y x.
Proof.
  intros Y hq h0 h1 B. apply Rnot_le_lt. intros k. apply C_q in h1; [ | lra ]. pose proof (below_C_B x q l Y k h0 h1) as b. unfold below_B in b. lra.
Qed.
(* IV, between C and D: forward, and rest. Every motion becomes this one. *)
Theorem s24_region_4 q l : 1 <= q -> eq55_lambda0 q <= l < eq56_lambda0 -> exists a e W, e < a + 2 * PI /\ late_slide q l W /\ reached q l W /\ course a e e e W.
Proof.
  unfold eq55_lambda0, eq56_lambda0. intros hq [h1 h2]. assert (0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). assert (0 < l) by lra. apply Rle_div_l in h1; [ | lra ].
  destruct (region_4 q l hq) as (e & W & he & HW & R & Co & _); [ lra | left; lra | ]. exists (asin l), e, W. split; [ lra | auto ].
Qed.
(* V, above D: every motion comes to rest, with the speed |w| at t0 within the time |w| / (lambda0 - 1), and stays. *)
Theorem s24_region_5 q l t0 w : 1 <= q -> eq56_lambda0 < l -> slides q l t0 w -> forall t, t0 + Rabs (w t0) / (l - 1) <= t -> w t = 0.
Proof.
  unfold eq56_lambda0. intros hq hl Hw t Ht. assert (q * l >= l) by nra. set (x := Rabs (w t0) / (l - 1)) in *. assert (e : (l - 1) * x = Rabs (w t0)) by (unfold x; field; lra).
  pose proof (Rabs_pos (w t0)). assert (0 <= x) by nra. destruct (region_5 q l hq ltac:(lra)) as [[Z _ _] _].
  destruct (Req_dec (w t) 0) as [ | z]; trivial. apply abs_zero. enough (Rabs (w t) + (l - 1) * (t - t0) <= Rabs (w t0)) by nra. apply (speed_falls l (q * l) sin t0); trivial; [ lra | ].
  intros y Hy. pose proof (SIN_bound y). split; [ | lra ]. intros e0. apply z.
  pose proof (line_contraction _ _ _ _ _ _ Hw (Z t0) y t ltac:(lra)) as C. cbv beta in C. rewrite e0, !Rminus_0_r, Rabs_R0 in C. now apply abs_zero.
Qed.
Lemma s24_region_5__occurs : ltac:(occurs s24_region_5).
Proof. intros H. destruct (late_slide_exists 2 2) as [W HW]; try lra. refine (H 2 2 0 W _ _ (ls_slides _ _ _ HW 0) _ (Rle_refl _)); unfold eq56_lambda0; lra. Qed.

(* Figure 5, corrected, for q > 1: A below B below C up to Y, and A below E, below C, from Y on, all below D. Between them the motion at large
   times is of the kinds I to V; m is B up to Y and E from Y on, c is C up to Y and E from Y on. *)
Theorem fig_5 r q : is_Y r -> 1 < q -> exists a m c, 0 < a < m /\ m <= c < 1 /\ eq53_sides_1 (eq53_k q) a = eq53_sides_2 (eq53_k q) a /\
  (q <= q_Y r -> eq54_sides_1 m (q * m) = eq54_sides_2 m (q * m) /\ c = eq55_lambda0 q /\ (m = c <-> q = q_Y r)) /\
  (q_Y r <= q -> right_anisotropic_e_sides_1 m (q * m) = right_anisotropic_e_sides_2 m (q * m) /\ c = m /\ (m = eq55_lambda0 q <-> q = q_Y r)) /\
  forall l W, 0 < l -> late_slide q l W ->
  (l < a -> exists a e, a < e < a + 2 * PI /\ course a e e (a + 2 * PI) W) /\ (a < l < m -> exists a e e', e < e' < a + 2 * PI /\ course a e e e' W) /\
  (m < l < c -> exists a e b e', e < b < e' /\ e' < a + 2 * PI /\ course a e b e' W) /\ (c < l < 1 -> exists a e, e < a + 2 * PI /\ course a e e e W) /\ (1 < l -> forall t, W t = 0).
Proof.
  intros Y hq. assert (hq1 : 1 <= q) by lra. destruct (Y_facts r Y) as (y3 & _). destruct (A_exists q hq1) as (a & ha & A). destruct (A_order q a hq1 ltac:(lra) A) as (_ & qa & _ & _ & AB).
  assert (i : q * (1 / q) = 1) by (field; lra). assert (i0 : 0 < 1 / q < 1) by (split; [ apply Rdiv_lt_0_compat | apply Rlt_div_l ]; lra).
  assert (a1 : a < 1 / q) by (apply C_q; unfold eq55_lambda0; lra || trivial). destruct (corner r q Y hq1) as (ce & _).
  assert (X : exists m c, a < m <= c /\ c <= 1 / q /\ (q <= q_Y r -> on_B q m /\ c = 1 / q /\ (m = c <-> q = q_Y r)) /\ (q_Y r <= q -> on_E q m /\ c = m /\ (m = 1 / q <-> q = q_Y r))).
  { destruct (total_order_T q (q_Y r)) as [[k | k] | k].
    - destruct (B_exists r q a Y ltac:(lra) ltac:(lra) A) as (b & hb & B). exists b, (1 / q). repeat split; trivial; intros; lra.
    - exists (1 / q), (1 / q). assert (B : on_B q (1 / q)) by (now apply (B_meets_C r)). assert (E : on_E q (1 / q)) by (apply E_sign; try lra; rewrite ce; apply B_sign; trivial; lra). repeat split; trivial; intros; lra.
    - destruct (E_exists r q a Y k ltac:(lra) A) as (b & hb & E). exists b, b. repeat split; trivial; intros; lra. }
  destruct X as (m & c & hm & hc & XB & XE). exists a, m, c. split; [ lra | split; [ lra | split; [ exact A | split; [ exact XB | split; [ exact XE | ] ] ] ] ].
  intros l W h0 HW. assert (ext : forall a e b e' U, late_slide q l U -> course a e b e' U -> course a e b e' W).
  { intros a' e b e' U HU (C & C1 & C2 & C3 & C4). pose proof (late_slide_unique q l U W HU HW) as E. split; [ trivial | ]. repeat split; intros t Ht; rewrite <- E; auto. }
  destruct (A_sides q a l hq1 ltac:(lra) A h0) as [S1 S2]. split; [ | split; [ | split; [ | split ] ] ].
  - intros h. destruct (s24_region_1 q l hq1 h0) as (a' & e & U & HU & Co & He & _); [ now apply S1 | ]. exists a', e. split; [ trivial | now apply (ext _ _ _ _ U) ].
  - intros h. destruct (s24_region_2 r q l Y hq1 h0) as [(a' & e & e' & U & He & HU & _ & Co) _]; [ apply S2; lra | unfold eq55_lambda0; lra | | | ].
    + intros k. destruct (XB k) as (B & _). apply (B_sides q m l); trivial; try lra. rewrite <- i. apply Rmult_le_compat_l; lra. rewrite <- i. apply Rmult_le_compat_l; lra.
    + intros k. destruct (XE k) as (E & _). apply (E_sides q m l); trivial; try lra. rewrite <- i. apply Rmult_le_compat_l; lra. rewrite <- i. apply Rmult_le_compat_l; lra.
    + exists a', e, e'. split; [ trivial | now apply (ext _ _ _ _ U) ].
  - intros h. destruct (Rle_lt_dec q (q_Y r)) as [k | k]; [ | destruct (XE ltac:(lra)) as (_ & ? & _); lra ]. destruct (XB k) as (B & _).
    destruct (s24_region_3 q l hq1 h0) as (a' & e & b & e' & U & H1 & H2 & HU & _ & Co); [ unfold eq55_lambda0; lra | | exists a', e, b, e'; split; [ trivial | split; [ trivial | now apply (ext _ _ _ _ U) ] ] ].
    apply (B_sides q m l); trivial; try lra. rewrite <- i. apply Rmult_le_compat_l; lra. rewrite <- i. apply Rmult_le_compat_l; lra.
  - intros h. assert (hl : 0 < l < 1) by lra. destruct (region_4 q l hq1 hl) as (e & U & He & HU & _ & Co & _).
    + destruct (Rle_lt_dec 1 (q * l)) as [k | k]; [ now left | right; split; [ trivial | ] ]. apply C_q in k; [ | lra ]. unfold eq55_lambda0 in k.
      destruct (Rlt_le_dec q (q_Y r)) as [k1 | k1]; [ destruct (XB ltac:(lra)) as (_ & ? & _); lra | ]. destruct (XE k1) as (E & ? & _). assert (M : above_E q l).
      { apply (E_sides q m l); trivial; try lra; rewrite <- i; apply Rmult_le_compat_l; lra. } unfold above_E, below_E in *. lra.
    + exists (asin l), e. split; [ lra | now apply (ext _ _ _ _ U) ].
  - intros h t. rewrite <- (late_slide_unique q l _ W (proj1 (region_5 q l hq1 ltac:(lra))) HW). trivial.
Qed.
