(* The large-time motions (33) and (38) as functions of the phase; they are motions from every phase on, and every motion of the plane becomes (33)
   above lambda_c, tends to (38) up to it, and is at rest from some time on where friction is never exceeded. *)
Require Import Reals Lra Psatz ZArith FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas Pieces Periodic Pulse Aniso Steady AttractPlane Reached Shaken.
Open Scope R_scope.

(* the phase phi, less whole periods, in the period that begins at start *)
Definition in_period (start phi : R) : R := phi - IZR (floor (2 * PI) (phi - start)) * (2 * PI).
(* (33), continued with the period 2 pi; e is its phitilde2 *)
Definition w33 (lam e phi : R) : R :=
  let p1 := eq27_phi1 lam in let p3 := eq29_phi3 lam in let x := in_period (eq33_ends_1 p1 e p3) phi in
  if Rlt_dec x (eq33_ends_2 p1 e p3) then eq33_w_1 lam p1 p3 x else if Rlt_dec x (eq33_ends_3 p1 e p3) then eq33_w_2 lam p1 p3 x
  else if Rlt_dec x (eq33_ends_4 p1 e p3) then eq33_w_3 lam p1 p3 x else eq33_w_4 lam p1 p3 x.
(* (38) with (39), continued with the period 2 pi *)
Definition w38 (lam phi : R) : R :=
  let p := eq39_phi_t1 lam in let x := in_period (eq38_ends_1 p) phi in
  if Rlt_dec x (eq38_ends_2 p) then eq38_w_1 lam p x else eq38_w_2 lam p x.

Lemma ext_first g t : 0 <= t < PI -> ext PI g t = g t.
Proof. intros H. rewrite (ext_on PI g PI_RGT_0 0) by (simpl; lra). unfold sg; simpl. rewrite Rmult_1_l. f_equal. ring. Qed.
Lemma ext_turn g p phi : let x := in_period p phi in p <= x < p + 2 * PI /\
  ext PI g (phi - p) = if Rlt_dec x (p + PI) then g (x - p) else - g (x - p - PI).
Proof.
  intros x. pose proof PI_RGT_0. assert (h2 : 0 < 2 * PI) by lra. unfold x, in_period.
  pose proof (proj2 (floor_spec (2 * PI) h2 (phi - p) _) eq_refl) as H1. set (n := floor (2 * PI) (phi - p)) in *. split; [ lra | ].
  replace (phi - p) with (phi - IZR n * (2 * PI) - p + IZR n * (2 * PI)) by ring. rewrite (whole_periods (ext PI g)) by (intros; now apply ext_period).
  assert (h3 : p <= phi - IZR n * (2 * PI) < p + 2 * PI) by lra. set (y := phi - IZR n * (2 * PI)) in *. destruct (Rlt_dec y (p + PI)).
  - apply ext_first. lra.
  - replace (y - p) with (y - p - PI + PI) by ring. rewrite ext_anti, ext_first by lra. do 2 f_equal. ring.
Qed.
Lemma steady_any l p g phi0 : motion l (fun t => - sin (p + t)) (fun _ => 0) (ext PI g) (fun _ => 0) ->
  shaken l phi0 (fun s => ext PI g (phi0 + s - p)) (fun _ => 0).
Proof.
  intros M. pose proof PI_RGT_0. rewrite shaken_sin. destruct (per_spec p (2 * PI) ltac:(lra) phi0) as [n Hn].
  eapply motion_eq. apply (motion_later _ _ _ _ _ (phi0 - IZR n * (2 * PI) - p) ltac:(lra)) in M. exact M. all: trivial; intros s; cbv beta.
  - f_equal. rewrite <- (sin_Z _ n). f_equal. ring.
  - rewrite <- (whole_periods (ext PI g) _ n) by (intros; now apply ext_period). f_equal. ring.
Qed.

(* ---- (38), up to lambda_c ---- *)
Section Turns.
Variable l : R.
Notation p := (eq39_phi_t1 l).
Lemma w38_ext phi : w38 l phi = ext PI (g38 l p) (phi - p).
Proof.
  destruct (ext_turn (g38 l p) p phi) as [H ->]. unfold w38, eq38_ends_1, eq38_ends_2. set (x := in_period p phi) in *.
  unfold eq38_w_1, eq38_w_2, g38. destruct (Rlt_dec x (p + PI)). replace (p + (x - p)) with x by ring. ring.
  rewrite <- (Ropp_involutive (cos x)), <- neg_cos. replace (p + (x - p - PI)) with (x - PI) by ring.
  replace (cos (x + PI)) with (cos (x - PI)) by (rewrite <- (cos_2PI_plus (x - PI)); f_equal; ring). ring.
Qed.
Lemma w38_anti x : w38 l (x + PI) = - w38 l x.
Proof. rewrite !w38_ext. replace (x + PI - p) with (x - p + PI) by ring. apply ext_anti, PI_RGT_0. Qed.
Lemma w38_period x : w38 l (x + 2 * PI) = w38 l x.
Proof. replace (x + 2 * PI) with (x + PI + PI) by ring. rewrite !w38_anti. ring. Qed.
Lemma w38_turn : w38 l p = 0.
Proof. pose proof PI_RGT_0. rewrite w38_ext, ext_first by lra. replace (p - p) with 0 by ring. unfold g38. rewrite Rplus_0_r. ring. Qed.
Hypothesis hl : 0 < l <= eq37_lambda_c.
Lemma below_1 : 0 < l < 1. Proof. pose proof lambda_c_between. lra. Qed.
Lemma w38_on x : p <= x <= p + PI -> w38 l x = g38 l p (x - p).
Proof.
  intros H. pose proof PI_RGT_0. rewrite w38_ext. destruct (Req_dec x (p + PI)) as [-> | ]; [ | apply ext_first; lra ].
  replace (p + PI - p) with (0 + PI) by ring. rewrite ext_anti, ext_first by lra. rewrite Rplus_0_l. rewrite (g_PI l below_1 (proj2 hl)), g_0. ring.
Qed.
Lemma w38_pos x : p < x < p + PI -> 0 < w38 l x.
Proof. intros H. rewrite w38_on by lra. apply (g_pos l below_1 (proj2 hl)). lra. Qed.
Lemma w38_motion phi0 : shaken l phi0 (fun s => w38 l (phi0 + s)) (fun _ => 0).
Proof.
  eapply motion_eq. apply (steady_any l p (g38 l p) phi0 (steady38 l below_1 (proj2 hl))). all: trivial. intros s. now rewrite w38_ext.
Qed.
Lemma w38_attracts phi0 w wy : shaken l phi0 w wy -> is_lim (fun s => w s - w38 l (phi0 + s)) p_infty 0 /\ is_lim wy p_infty 0.
Proof.
  intros M. pose proof (w38_motion phi0) as W. rewrite shaken_sin in M, W. pose proof PI_RGT_0.
  apply (plane_attracts l 1 (2 * PI) (p - phi0) PI (fun s => - sin (phi0 + s)) (fun s => w38 l (phi0 + s))); trivial; try lra.
  - intros s. rewrite Rabs_Ropp. apply Rabs_le, SIN_bound.
  - intros s. replace (phi0 + (s + 2 * PI)) with (phi0 + s + 2 * PI) by ring. apply w38_period.
  - replace (phi0 + (p - phi0)) with p by ring. apply w38_turn.
  - intros s Hs. pose proof (w38_pos (phi0 + s + PI) ltac:(lra)) as P. rewrite w38_anti in P. lra.
  - intros s Hs. apply w38_pos. lra.
Qed.
(* zero at two phases of each period, only *)
Lemma w38_zeros x : w38 l x = 0 <-> exists n, x = p + IZR n * PI.
Proof.
  pose proof PI_RGT_0. split.
  - intros E. destruct (per_spec p PI ltac:(lra) x) as [n Hn]. exists n. destruct (Req_dec x (p + IZR n * PI)) as [ | ne]; trivial. exfalso.
    rewrite w38_ext in E. rewrite (ext_on PI _ PI_RGT_0 n) in E by lra. pose proof (g_pos l below_1 (proj2 hl) (x - p - IZR n * PI) ltac:(lra)) as P.
    destruct (sg_cases n) as [e | e]; rewrite e in E; lra.
  - intros [n ->]. rewrite w38_ext, (ext_on PI _ PI_RGT_0 n) by lra. replace (p + IZR n * PI - p - IZR n * PI) with 0 by ring. rewrite g_0. ring.
Qed.
(* a motion that repeats itself is (38) *)
Lemma periodic_is_38 phi0 w wy P : shaken l phi0 w wy -> 0 < P -> (forall s, 0 <= s -> w (s + P) = w s /\ wy (s + P) = wy s) ->
  forall s, 0 <= s -> w s = w38 l (phi0 + s) /\ wy s = 0.
Proof.
  intros M hP per s hs. destruct (w38_attracts phi0 w wy M) as [X Y]. pose proof PI_RGT_0.
  assert (Pn : forall n s, 0 <= s -> w (s + INR n * P) = w s /\ wy (s + INR n * P) = wy s).
  { induction n as [ | n IH ]; intros u hu. simpl. rewrite Rmult_0_l, Rplus_0_r. auto. rewrite S_INR. replace (u + (INR n + 1) * P) with (u + INR n * P + P) by ring.
    pose proof (pos_INR n). assert (0 <= INR n * P) by nra. destruct (per (u + INR n * P)) as [-> ->]; [ lra | ]. now apply IH. }
  assert (late : forall f : R -> R, is_lim f p_infty 0 -> forall e, 0 < e -> forall c, 0 < c -> exists n, forall u, 0 <= u -> Rabs (f (u + INR n * c)) < e).
  { intros f F e he c hc. apply is_lim_spec in F. destruct (F (mkposreal e he)) as [T HT]. destruct (nat_above (T / c)) as [n Hn]. exists n. intros u hu.
    apply Rlt_div_l in Hn; trivial. specialize (HT (u + INR n * c) ltac:(lra)). rewrite Rminus_0_r in HT. exact HT. }
  assert (two : forall n x, w38 l (x + INR n * (2 * PI)) = w38 l x) by (intros n x; rewrite INR_IZR_INZ; apply (whole_periods (w38 l)), w38_period).
  assert (zero : forall x, (forall e, 0 < e -> Rabs x < e) -> x = 0).
  { intros x Z. destruct (Req_dec x 0) as [ | ne]; trivial. specialize (Z (Rabs x) (Rabs_pos_lt x ne)). lra. }
  (* P is a period of (38), too *)
  assert (same : forall u, 0 <= u -> w38 l (phi0 + (u + P)) = w38 l (phi0 + u)).
  { intros u hu. enough (w38 l (phi0 + (u + P)) - w38 l (phi0 + u) = 0) by lra. apply zero. intros e he. destruct (late _ X (e / 2) ltac:(lra) (2 * PI) ltac:(lra)) as [n N].
    assert (0 <= INR n * (2 * PI)) by (pose proof (pos_INR n); nra). pose proof (N u hu) as N1. pose proof (N (u + P) ltac:(lra)) as N2.
    replace (u + P + INR n * (2 * PI)) with (u + INR n * (2 * PI) + P) in N2 at 1 by ring. rewrite (proj1 (per (u + INR n * (2 * PI)) ltac:(lra))) in N2.
    rewrite <- !Rplus_assoc, two in N1. rewrite <- !Rplus_assoc, two in N2. rewrite <- Rplus_assoc. apply Rabs_def2 in N1. apply Rabs_def2 in N2. apply Rabs_def1; lra. }
  assert (samen : forall n u, 0 <= u -> w38 l (phi0 + (u + INR n * P)) = w38 l (phi0 + u)).
  { induction n as [ | n IH ]; intros u hu. simpl. rewrite Rmult_0_l, Rplus_0_r. trivial. rewrite S_INR. replace (u + (INR n + 1) * P) with (u + INR n * P + P) by ring.
    rewrite same, IH; trivial. pose proof (pos_INR n). assert (0 <= INR n * P) by nra. lra. }
  split; [ enough (w s - w38 l (phi0 + s) = 0) by lra | ]; apply zero; intros e he.
  - destruct (late _ X e he P hP) as [n N]. specialize (N s hs). now rewrite samen, (proj1 (Pn n s hs)) in N.
  - destruct (late _ Y e he P hP) as [n N]. specialize (N s hs). now rewrite (proj2 (Pn n s hs)) in N.
Qed.
End Turns.

(* ---- (33), above lambda_c ---- *)
Lemma left_h l x : eq32_left l (eq27_phi1 l) x = h l (x - asin l).
Proof. unfold eq32_left, eq27_phi1, h. replace (asin l + (x - asin l)) with x by ring. ring. Qed.
Lemma slip_end_is l e : 0 < l < 1 -> slip_end l e -> let tau := e - asin l in
  PI - 2 * asin l < tau < 2 * PI - 2 * asin l /\ h l tau = 0 /\ (forall t, 0 < t < tau -> 0 < h l t) /\ (forall t, tau < t <= 2 * PI -> h l t < 0).
Proof.
  intros hl (E1 & E2 & E3) tau. destruct (slip_once l hl) as (u & U & z & P & N). destruct (p1_range l hl) as [[a b] _]. rewrite left_h in E2. fold tau in E2.
  assert (0 < tau) by (unfold tau, eq27_phi1 in *; lra). enough (tau = u) as -> by auto. destruct (Rtotal_order tau u) as [k | [k | k]]; trivial; exfalso.
  - specialize (P tau ltac:(lra)). lra.
  - apply (E3 (asin l + u)). unfold tau, eq27_phi1 in *. lra. rewrite left_h. rewrite <- z. f_equal. ring.
Qed.
Lemma slip_end_exists l : 0 < l < 1 -> exists e, slip_end l e.
Proof.
  intros hl. destruct (slip_once l hl) as (u & U & z & P & N). destruct (p1_range l hl) as [[a b] _]. exists (asin l + u). unfold slip_end, eq27_phi1.
  split; [ lra | ]. fold (eq27_phi1 l). rewrite left_h. split. rewrite <- z. f_equal. unfold eq27_phi1. ring.
  intros x Hx. rewrite left_h. specialize (P (x - asin l)). unfold eq27_phi1 in *. lra.
Qed.

Section Rests.
Variables l e : R.
Hypothesis hl : 0 < l < 1.
Hypothesis he : slip_end l e.
Hypothesis early : e < eq29_phi3 l.
Notation p1 := (asin l).
Lemma ends : PI - p1 < e < PI + p1 /\ h l (e - p1) = 0 /\ forall t, 0 < t < e - p1 -> 0 < h l t.
Proof. destruct (slip_end_is l e hl he) as (A & B & C & _). unfold eq29_phi3 in early. split; [ lra | auto ]. Qed.
Lemma w33_ext phi : w33 l e phi = ext PI (g33 l (e - p1)) (phi - p1).
Proof.
  destruct (ext_turn (g33 l (e - p1)) p1 phi) as [H ->]. destruct (p1_range l hl) as [[a b] _]. destruct ends as [o _].
  unfold w33, eq33_ends_1, eq33_ends_2, eq33_ends_3, eq33_ends_4, eq29_phi3, eq27_phi1. set (x := in_period p1 phi) in *.
  unfold g33, h, eq33_w_1, eq33_w_2, eq33_w_3, eq33_w_4. repeat match goal with |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b) end; try lra.
  - replace (p1 + (x - p1)) with x by ring. ring.
  - rewrite <- (Ropp_involutive (cos x)), <- neg_cos. replace (p1 + (x - p1 - PI)) with (x - PI) by ring.
    replace (cos (x + PI)) with (cos (x - PI)) by (rewrite <- (cos_2PI_plus (x - PI)); f_equal; ring). rewrite (Rplus_comm PI p1), neg_cos. ring.
Qed.
Lemma w33_anti x : w33 l e (x + PI) = - w33 l e x.
Proof. rewrite !w33_ext. replace (x + PI - p1) with (x - p1 + PI) by ring. apply ext_anti, PI_RGT_0. Qed.
Lemma w33_period x : w33 l e (x + 2 * PI) = w33 l e x.
Proof. replace (x + 2 * PI) with (x + PI + PI) by ring. rewrite !w33_anti. ring. Qed.
Lemma w33_slip x : p1 < x < e -> 0 < w33 l e x.
Proof.
  intros H. destruct ends as (o & _ & P). destruct (p1_range l hl) as [[a b] _]. rewrite w33_ext, ext_first by lra.
  unfold g33. destruct (Rlt_dec (x - p1) (e - p1)); [ apply P | ]; lra.
Qed.
Lemma w33_rest x : e <= x <= p1 + PI -> w33 l e x = 0.
Proof.
  intros H. destruct ends as (o & _ & P). destruct (p1_range l hl) as [[a b] _]. pose proof PI_RGT_0. destruct (Req_dec x (p1 + PI)) as [-> | ne].
  - rewrite w33_anti, w33_ext, ext_first by lra. unfold g33. destruct (Rlt_dec (p1 - p1) (e - p1)); [ | lra ]. replace (p1 - p1) with 0 by ring. rewrite h_0. ring.
  - rewrite w33_ext, ext_first by lra. unfold g33. destruct (Rlt_dec (x - p1) (e - p1)); lra.
Qed.
Lemma w33_motion phi0 : shaken l phi0 (fun s => w33 l e (phi0 + s)) (fun _ => 0).
Proof.
  destruct ends as (o & z & P). destruct (p1_range l hl) as [[a b] _].
  eapply motion_eq. apply (steady_any l p1 (g33 l (e - p1)) phi0 (steady33 l hl (e - p1) ltac:(lra) z P)). all: trivial. intros s. now rewrite w33_ext.
Qed.
Lemma w33_reached phi0 w wy : shaken l phi0 w wy -> exists s1, 0 <= s1 /\ forall s, s1 <= s -> w s = w33 l e (phi0 + s) /\ wy s = 0.
Proof.
  intros M. pose proof (w33_motion phi0) as W. rewrite shaken_sin in M, W. pose proof PI_RGT_0. destruct ends as (o & z & P). destruct (p1_range l hl) as [[a b] e1].
  apply (plane_reached l (2 * PI) ((e + PI + p1) / 2 - phi0) (PI + p1 - phi0) (fun s => - sin (phi0 + s)) (fun s => w33 l e (phi0 + s))); trivial; try lra.
  - intros s. f_equal. rewrite <- (sin_2PI_plus (phi0 + s)). f_equal. ring.
  - intros s. replace (phi0 + (s + 2 * PI)) with (phi0 + s + 2 * PI) by ring. apply w33_period.
  - intros s Hs. apply w33_rest. lra.
  - rewrite Rabs_Ropp. replace (phi0 + ((e + PI + p1) / 2 - phi0)) with ((e + PI + p1) / 2) by ring. set (x := (e + PI + p1) / 2). assert (PI - p1 < x < PI + p1) by (unfold x; lra).
    rewrite <- e1. rewrite <- (sin_PI_x x). apply Rabs_def1; [ | rewrite <- sin_neg ]; apply sin_increasing_1; lra.
  - apply (continuity_pt_opp (fun s => sin (phi0 + s))), derivable_continuous_pt. reg.
Qed.
End Rests.

(* ---- from lambda0 = 1 on everything stops ---- *)
Lemma all_stop l phi0 w wy : 1 <= l -> shaken l phi0 w wy -> exists s1, 0 <= s1 /\ forall s, s1 <= s -> w s = 0 /\ wy s = 0.
Proof.
  intros hl M. rewrite shaken_sin in M. pose proof PI_RGT_0.
  apply (plane_reached l (2 * PI) (- phi0) (- phi0 + 1) (fun s => - sin (phi0 + s)) (fun _ => 0)); trivial; try lra.
  - intros s. f_equal. rewrite <- (sin_2PI_plus (phi0 + s)). f_equal. ring.
  - split; [ intros; cont | intros; cont | ]. intros t _. exists (- sin (phi0 + t)), 0. pose proof (SIN_bound (phi0 + t)). split; [ split; [ nra | rewrite nrm_forward by lra; ring ] | ].
    split; (eapply rder_eq; [ rd | ring ]).
  - replace (phi0 + - phi0) with 0 by ring. rewrite sin_0, Ropp_0, Rabs_R0. lra.
  - apply (continuity_pt_opp (fun s => sin (phi0 + s))), derivable_continuous_pt. reg.
Qed.
