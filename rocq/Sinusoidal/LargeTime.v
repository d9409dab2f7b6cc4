(* The large-time motions (33) and (38) as functions of the phase; they are motions from every phase on, and every motion of the plane becomes (33)
   above lambda_c, tends to (38) up to it, and is at rest from some time on where friction is never exceeded. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas HalfPeriod Drawn Analysis Steady Shaken.
Open Scope R_scope.

(* the phase phi in radians, less whole periods, in the period that begins at start *)
Definition in_period (start phi : R) : R := phi - IZR (floor (2 * PI) (phi - start)) * (2 * PI).
(* (33), dimensionless, continued with the period 2 pi; e is its phitilde2. «$\mathfrak{w}^{(33)}_{lam,e}(phi)$» *)
Definition w33 (lam e phi : R) : R :=
  let p1 := eq27_phi1 lam in let p3 := eq29_phi3 lam in let x := in_period (eq33_ends_1 p1 e p3) phi in
  if Rlt_dec x (eq33_ends_2 p1 e p3) then eq33_w_1 lam p1 p3 x else if Rlt_dec x (eq33_ends_3 p1 e p3) then eq33_w_2 lam p1 p3 x
  else if Rlt_dec x (eq33_ends_4 p1 e p3) then eq33_w_3 lam p1 p3 x else eq33_w_4 lam p1 p3 x.
(* (38) with (39), dimensionless, continued with the period 2 pi. «$\mathfrak{w}^{(38)}_{lam}(phi)$» *)
Definition w38 (lam phi : R) : R :=
  let p := eq39_phi_t1 lam in let x := in_period (eq38_ends_1 p) phi in
  if Rlt_dec x (eq38_ends_2 p) then eq38_w_1 lam p x else eq38_w_2 lam p x.

Lemma ext_turn g p phi : let x := in_period p phi in p <= x < p + 2 * PI /\
  ext PI g (phi - p) = if Rlt_dec x (p + PI) then g (x - p) else - g (x - p - PI).
Proof.
  intros x. pose proof PI_RGT_0. unfold x, in_period.
  pose proof (proj2 (floor_spec (2 * PI) ltac:(lra) (phi - p) _) eq_refl) as H1. set (n := floor (2 * PI) (phi - p)) in *. split; [ lra | ].
  rewrite <- (whole_periods (ext PI g) _ (- n)), opp_IZR by (intros; now apply ext_period).
  replace (phi - p + - IZR n * (2 * PI)) with (phi - IZR n * (2 * PI) - p) by ring. assert (h : p <= phi - IZR n * (2 * PI) < p + 2 * PI) by lra.
  set (y := phi - IZR n * (2 * PI)) in *. destruct Rlt_dec.
  - apply ext_first. lra.
  - replace (y - p) with (y - p - PI + PI) at 1 by ring. now rewrite ext_anti, ext_first by lra.
Qed.
Lemma ext_bound g B : (forall t, 0 <= t < PI -> Rabs (g t) <= B) -> forall x, Rabs (ext PI g x) <= B.
Proof.
  intros H x. destruct (per_spec 0 PI PI_RGT_0 x) as [n Hn]. rewrite (ext_on PI g PI_RGT_0 n), Rabs_mult by lra.
  replace (Rabs (sg n)) with 1 by (destruct (sg_cases n) as [-> | ->]; unfold Rabs; destruct Rcase_abs; lra). rewrite Rmult_1_l. apply H. lra.
Qed.
Lemma twice (f : R -> R) : (forall x, f (x + PI) = - f x) -> forall x, f (x + 2 * PI) = f x.
Proof. intros A x. replace (x + 2 * PI) with (x + PI + PI) by ring. rewrite !A. ring. Qed.
Lemma cos_back x : cos (x - PI) = - cos x. Proof. rewrite <- (Ropp_involutive (cos (x - PI))), <- neg_cos. do 2 f_equal. ring. Qed.
Lemma anti_at g p x : ext PI g (x + PI - p) = - ext PI g (x - p).
Proof. replace (x + PI - p) with (x - p + PI) by ring. apply ext_anti, PI_RGT_0. Qed.
Lemma shaken_from l p g W phi0 : (forall phi, W phi = ext PI g (phi - p)) ->
  motion l (fun s => - sin (p + (phi0 - p + s))) (fun _ => 0) (fun s => ext PI g (phi0 - p + s)) (fun _ => 0) ->
  shaken l phi0 (fun s => W (phi0 + s)) (fun _ => 0).
Proof.
  intros E M. rewrite shaken_sin. eapply motion_eq; [ exact M | trivial | intros s; cbv beta; do 2 f_equal; ring | trivial | intros s; cbv beta;
  rewrite E; f_equal; ring | trivial ].
Qed.
Lemma drive_period phi0 s : - sin (phi0 + (s + 2 * PI)) = - sin (phi0 + s). Proof. now rewrite <- Rplus_assoc, sin_per. Qed.
Lemma drive_cont phi0 s : continuity_pt (fun s => - sin (phi0 + s)) s.
Proof. apply (continuity_pt_opp (fun s => sin (phi0 + s))), derivable_continuous_pt. reg. Qed.

(* ---- (38), up to lambda_c ---- *)
Section Turns.
Variable l : R.
Notation p := (eq39_phi_t1 l).
Lemma w38_ext phi : w38 l phi = ext PI (g38 l p) (phi - p).
Proof.
  destruct (ext_turn (g38 l p) p phi) as [H ->]. unfold w38, eq38_ends_1, eq38_ends_2. set (x := in_period p phi) in *.
  unfold eq38_w_1, eq38_w_2, g38. destruct Rlt_dec; rewrite ?Rplus_minus; [ ring | ].
  replace (p + (x - p - PI)) with (x - PI) by ring. rewrite cos_back. ring.
Qed.
Lemma w38_anti x : w38 l (x + PI) = - w38 l x. Proof. rewrite !w38_ext. apply anti_at. Qed.
Lemma w38_period x : w38 l (x + 2 * PI) = w38 l x. Proof. apply twice, w38_anti. Qed.
Hypothesis hl : 0 < l <= eq37_lambda_c.
Lemma below_1 : 0 < l < 1. Proof. pose proof lambda_c_between. lra. Qed.
Lemma w38_pos x : p < x < p + PI -> 0 < w38 l x.
Proof. intros H. rewrite w38_ext, ext_first by lra. apply (g_pos l below_1 (proj2 hl)). lra. Qed.
Lemma w38_most phi : Rabs (w38 l phi) <= w38 l (PI - asin l).
Proof.
  pose proof PI_RGT_0. destruct (p_facts l below_1 (proj2 hl)) as [a _]. destruct (asin_range l below_1) as [b _].
  rewrite !w38_ext, (ext_first PI _ (PI - asin l - p)) by lra. apply ext_bound. intros t ht. rewrite Rabs_pos_eq.
  - apply (slip_top l below_1 _ p t (g_der l p)); lra.
  - destruct (Req_dec t 0) as [-> | ]; [ rewrite g_0; lra | left; apply (g_pos l below_1 (proj2 hl)); lra ].
Qed.
Lemma w38_motion phi0 : shaken l phi0 (fun s => w38 l (phi0 + s)) (fun _ => 0).
Proof. exact (shaken_from l p _ _ phi0 w38_ext (steady38 l below_1 (proj2 hl) phi0)). Qed.
(* zero at two phases of each period, only *)
Lemma w38_on n x : p + IZR n * PI <= x < p + (IZR n + 1) * PI -> w38 l x = sg n * g38 l p (x - p - IZR n * PI).
Proof. intros H. rewrite w38_ext. apply (ext_on PI _ PI_RGT_0 n). lra. Qed.
Lemma w38_turn n : w38 l (p + IZR n * PI) = 0.
Proof. pose proof PI_RGT_0. rewrite (w38_on n) by lra. replace (p + IZR n * PI - p - IZR n * PI) with 0 by ring. rewrite g_0. ring. Qed.
Lemma w38_zeros x : w38 l x = 0 <-> exists n, x = p + IZR n * PI.
Proof.
  pose proof PI_RGT_0. split; [ | intros [n ->]; apply w38_turn ]. intros E. destruct (per_spec p PI ltac:(lra) x) as [n Hn]. exists n.
  destruct (Req_dec x (p + IZR n * PI)) as [ | ne]; trivial. exfalso. rewrite (w38_on n x Hn) in E.
  pose proof (g_pos l below_1 (proj2 hl) (x - p - IZR n * PI) ltac:(lra)) as P. destruct (sg_cases n) as [e | e]; rewrite e in E; lra.
Qed.
Lemma w38_attracts phi0 w wy : shaken l phi0 w wy -> is_lim (fun s => w s - w38 l (phi0 + s)) p_infty 0 /\ is_lim wy p_infty 0.
Proof.
  intros M. pose proof (w38_motion phi0) as W. rewrite shaken_sin in M, W. pose proof PI_RGT_0. pose proof (w38_turn 0) as z.
  apply (plane_attracts l 1 (2 * PI) (p - phi0) PI (fun s => - sin (phi0 + s)) (fun s => w38 l (phi0 + s))); trivial; try lra.
  - intros s. rewrite Rabs_Ropp. apply sin_1.
  - intros s. rewrite <- Rplus_assoc. apply w38_period.
  - rewrite <- z. f_equal. ring.
  - intros s Hs. pose proof (w38_pos (phi0 + s + PI) ltac:(lra)) as P. rewrite w38_anti in P. lra.
  - intros s Hs. apply w38_pos. lra.
Qed.
(* from some time on every motion is as near to (38) as one likes *)
Lemma near_38 phi0 w wy e : shaken l phi0 w wy -> 0 < e -> exists s1, 0 <= s1 /\ forall s, s1 <= s -> Rabs (w s - w38 l (phi0 + s)) < e /\ Rabs (wy
  s) < e.
Proof.
  intros M he. destruct (w38_attracts phi0 w wy M) as [X Y]. destruct (lim_near _ _ e X he) as (a & a0 & A).
  destruct (lim_near _ _ e Y he) as (b & b0 & B).
  exists (Rmax a b). split; [ minmax | ]. intros s hs. specialize (A s ltac:(minmax)). specialize (B s ltac:(minmax)).
  split; apply Rabs_def1; lra.
Qed.
End Turns.

(* ---- (33), above lambda_c ---- *)
Lemma left_h l x : eq32_left l (eq27_phi1 l) x = h l (x - asin l).
Proof. unfold eq32_left, eq27_phi1, h. rewrite Rplus_minus. ring. Qed.
Lemma slip_end_one l e e' : slip_end l e -> slip_end l e' -> e' = e.
Proof.
  intros (a & b & c) (a' & b' & c'). destruct (Rtotal_order e' e) as [k | [k | k]]; trivial; exfalso; [ apply (c e') | apply (c' e) ]; trivial; lra.
Qed.
Definition slips l tau := PI - 2 * asin l < tau < 2 * PI - 2 * asin l /\ h l tau = 0 /\ (forall t, 0 < t < tau -> 0 < h l t) /\
  forall t, tau < t <= 2 * PI -> h l t < 0.
Lemma slip_end_ex l : 0 < l < 1 -> exists e, slip_end l e /\ slips l (e - asin l).
Proof.
  intros hl. destruct (slip_once l hl) as (u & F). destruct (asin_range l hl) as [[a b] _]. exists (asin l + u).
  assert (e0 : eq27_phi1 l = asin l) by reflexivity.
  replace (asin l + u - asin l) with u by ring. split; [ | exact F ]. destruct F as (U & z & P & _). split; [ lra | ].
  split; [ rewrite left_h, <- z; f_equal; ring | ]. intros x Hx. rewrite left_h. specialize (P (x - asin l)). lra.
Qed.
Lemma slip_end_is l e : 0 < l < 1 -> slip_end l e -> slips l (e - asin l).
Proof. intros hl E. destruct (slip_end_ex l hl) as (e' & E' & F). now rewrite (slip_end_one l e' e E' E). Qed.
Lemma slip_end_exists l : 0 < l < 1 -> exists e, slip_end l e. Proof. intros hl. destruct (slip_end_ex l hl) as (e & E & _). now exists e. Qed.
Lemma early_end l e : 0 < l < 1 -> slip_end l e -> (eq35_left l < 0 <-> e < eq29_phi3 l) /\ (eq37_lambda_c < l <-> e < eq29_phi3 l).
Proof.
  intros hl E. destruct (slip_end_is l e hl E) as (A & z & P & N). pose proof PI_RGT_0. destruct (left_sign l ltac:(lra)) as (c & c0 & S).
  destruct (asin_range l hl) as [b _]. rewrite <- h_PI in * by trivial. unfold eq29_phi3. enough (h l PI < 0 <-> e < PI + asin l) as Q.
  { split; [ exact Q | rewrite <- Q; split; intros; nra ]. }
  split; intros H0; [ apply Rnot_le_lt; intros k | apply N; lra ].
  destruct (Req_dec (e - asin l) PI) as [q | q]; [ rewrite q in z; lra | ]. specialize (P PI). lra.
Qed.
Lemma early_exists l : eq37_lambda_c < l < 1 -> exists e, slip_end l e /\ e < eq29_phi3 l.
Proof.
  intros hl. pose proof lambda_c_between. destruct (slip_end_exists l ltac:(lra)) as [e E]. exists e. split; trivial.
  apply (early_end l e ltac:(lra) E). lra.
Qed.

Section Rests.
Variables l e : R.
Hypothesis hl : 0 < l < 1.
Hypothesis he : slip_end l e.
Hypothesis early : e < eq29_phi3 l.
Notation p1 := (asin l).
Lemma ends : 0 < p1 < PI / 2 /\ PI - p1 < e < PI + p1 /\ h l (e - p1) = 0 /\ forall t, 0 < t < e - p1 -> 0 < h l t.
Proof. destruct (slip_end_is l e hl he) as (A & B & C & _). destruct (asin_range l hl). unfold eq29_phi3 in early.
  split; [ lra | split; [ lra | auto ] ]. Qed.
Lemma w33_ext phi : w33 l e phi = ext PI (g33 l (e - p1)) (phi - p1).
Proof.
  destruct (ext_turn (g33 l (e - p1)) p1 phi) as [H ->]. destruct ends as (b & o & _).
  unfold w33, eq33_ends_1, eq33_ends_2, eq33_ends_3, eq33_ends_4, eq29_phi3, eq27_phi1. set (x := in_period p1 phi) in *.
  unfold g33, h, eq33_w_1, eq33_w_2, eq33_w_3, eq33_w_4. repeat destruct Rlt_dec; try lra; rewrite ?Rplus_minus; [ ring | ].
  replace (p1 + (x - p1 - PI)) with (x - PI) by ring. rewrite cos_back, (Rplus_comm PI p1), neg_cos. ring.
Qed.
Lemma w33_anti x : w33 l e (x + PI) = - w33 l e x. Proof. rewrite !w33_ext. apply anti_at. Qed.
Lemma w33_period x : w33 l e (x + 2 * PI) = w33 l e x. Proof. apply twice, w33_anti. Qed.
Lemma w33_slip x : p1 < x < e -> 0 < w33 l e x.
Proof. intros H. destruct ends as (b & o & _ & P). rewrite w33_ext, ext_first by lra. unfold g33. destruct Rlt_dec; [ apply P | ]; lra. Qed.
Lemma w33_rest x : e <= x <= p1 + PI -> w33 l e x = 0.
Proof.
  intros H. destruct ends as (b & o & _). pose proof PI_RGT_0. destruct (Req_dec x (p1 + PI)) as [-> | ne]; [ rewrite w33_anti | ];
  rewrite w33_ext, ext_first by lra; unfold g33; destruct Rlt_dec; try lra. replace (p1 - p1) with 0 by ring. rewrite h_0. ring.
Qed.
Lemma w33_most phi : Rabs (w33 l e phi) <= w33 l e (PI - p1).
Proof.
  destruct ends as (b & o & _ & P). rewrite !w33_ext, (ext_first PI _ (PI - p1 - p1)) by lra. unfold g33 at 2. destruct Rlt_dec; [ | lra ].
  assert (0 < h l (PI - p1 - p1)) by (apply P; lra). apply ext_bound. intros t ht. unfold g33. destruct Rlt_dec; [ | rewrite Rabs_R0; lra ].
  rewrite Rabs_pos_eq; [ apply (slip_top l hl _ p1 t (h_der l)); lra | destruct (Req_dec t 0) as [-> | ]; [ rewrite h_0; lra | left; apply P; lra ] ].
Qed.
Lemma w33_motion phi0 : shaken l phi0 (fun s => w33 l e (phi0 + s)) (fun _ => 0).
Proof. destruct ends as (b & o & z & P). apply (shaken_from l p1 _ _ phi0 w33_ext), steady33; trivial. lra. Qed.
Lemma w33_reached phi0 w wy : shaken l phi0 w wy -> exists s1, 0 <= s1 /\ forall s, s1 <= s -> w s = w33 l e (phi0 + s) /\ wy s = 0.
Proof.
  intros M. pose proof (w33_motion phi0) as W. rewrite shaken_sin in M, W. pose proof PI_RGT_0. destruct ends as (b & o & z & P).
  apply (plane_reached l (2 * PI) ((e + PI + p1) / 2 - phi0) (PI + p1 - phi0) (fun s => - sin (phi0 + s)) (fun s => w33 l e (phi0 + s))); trivial;
  try lra; [ apply drive_period | intros s; rewrite <- Rplus_assoc; apply w33_period | intros s Hs; apply w33_rest; lra | | apply drive_cont ].
  rewrite Rabs_Ropp, Rplus_minus. set (x := (e + PI + p1) / 2). assert (PI - p1 < x < PI + p1) by (unfold x; lra).
  pose proof (sin_less l (2 * PI - x) hl ltac:(lra)) as B. rewrite sin_2PI_minus in B. apply Rabs_def1; [ apply sin_less | ]; lra.
Qed.
End Rests.

(* ---- from lambda0 = 1 on everything stops ---- *)
Lemma at_rest l phi0 : 1 <= l -> shaken l phi0 (fun _ => 0) (fun _ => 0).
Proof.
  intros hl. rewrite shaken_sin. split; [ intros; cont | intros; cont | ]. intros t _. exists (- sin (phi0 + t)), 0.
  pose proof (SIN_bound (phi0 + t)).
  split; [ split; [ nra | rewrite nrm_x0 by lra; ring ] | ]. split; (eapply rder_eq; [ rd | ring ]).
Qed.
Lemma all_stop l phi0 w wy : 1 <= l -> shaken l phi0 w wy -> exists s1, 0 <= s1 /\ forall s, s1 <= s -> w s = 0 /\ wy s = 0.
Proof.
  intros hl M. pose proof (at_rest l phi0 hl) as W. rewrite shaken_sin in M, W. pose proof PI_RGT_0.
  apply (plane_reached l (2 * PI) (- phi0) (- phi0 + 1) (fun s => - sin (phi0 + s)) (fun _ => 0)); trivial; try lra;
  [ apply drive_period | | apply drive_cont ]. rewrite Rplus_opp_r, sin_0, Ropp_0, Rabs_R0. lra.
Qed.

(* ---- at every friction all motions become one, or tend to one ---- *)
Lemma one_reached l : eq37_lambda_c < l -> exists W, forall phi0 w wy, shaken l phi0 w wy ->
  exists s1, 0 <= s1 /\ forall s, s1 <= s -> w s = W (phi0 + s) /\ wy s = 0.
Proof.
  intros k. pose proof lambda_c_between. destruct (Rlt_le_dec l 1) as [k1 | k1].
  - destruct (early_exists l ltac:(lra)) as (e & E & q). exists (w33 l e). now apply w33_reached; [ lra | | ].
  - exists (fun _ => 0). intros phi0 w wy. now apply all_stop.
Qed.
Lemma one_drawn l : 0 < l -> exists W, forall phi0 w wy, shaken l phi0 w wy -> is_lim (fun s => w s - W (phi0 + s)) p_infty 0.
Proof.
  intros h0. destruct (Rle_lt_dec l eq37_lambda_c) as [k | k]; [ exists (w38 l); intros phi0 w wy M;
  now apply (w38_attracts l (conj h0 k) phi0 w wy) | ].
  destruct (one_reached l k) as [W R]. exists W. intros phi0 w wy M. destruct (R phi0 w wy M) as (s1 & _ & S).
  apply (lim_eventually _ s1). intros s hs. rewrite (proj1 (S s hs)). ring.
Qed.
