(* 2.3: little friction. A drive of mean 0 has a primitive H of its period. From some time on the velocity w of each motion along the line
   differs from H - c, with c the median of H, by PI lambda0 at most, but for as little as one likes: otherwise H - c would drive it forward
   for more than half of each period. So it is 0 only where H is near its median. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis HalfPeriod Drawn Line.
Open Scope R_scope.
(* what cont and auto may use *)
#[export] Hint Extern 3 (_ < _) => lra : core.
#[export] Hint Resolve m_cx m_cy Rcontinuity_abs : core.
#[local] Arguments m_cx {k Ax Ay vx vy}.
#[local] Arguments m_cy {k Ax Ay vx vy}.
#[local] Arguments m_law {k Ax Ay vx vy}.
#[local] Arguments l_c {l m a t0 w}.
#[local] Arguments l_law {l m a t0 w}.
#[local] Arguments late_moves {l h W}.
#[local] Arguments late_drawn {l h W}.

(* the right limit of f at t is f(t): «$f$ is continuous from the right at $t$» *)
Definition rcont (f : R -> R) (t : R) : Prop := forall e, 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> Rabs (f s - f t) < e.
(* a median of H, which has the period 2 PI: «the mean of $\lvert H-x\rvert$ over a period is least at $x=c$, a median of $H$» *)
Definition median (H : R -> R) (c : R) : Prop := forall x, RInt (fun t => Rabs (H t - c)) 0 (2 * PI) <= RInt (fun t => Rabs (H t - x)) 0 (2 * PI).

(* what holds at a, and passes on from x to y near each place, holds at b *)
Lemma creep (P : R -> Prop) a b : a <= b -> P a ->
  (forall t, a <= t <= b -> exists e, 0 < e /\ forall x y, t - e < x <= y -> y < t + e -> a <= x -> y <= b -> P x -> P y) -> P b.
Proof.
  intros H Pa S. destruct (completeness (fun x => a <= x <= b /\ P x)) as [s [S1 S2]]. { exists b. intros x [Hx _]. lra. }
  { exists a. split; trivial. lra. }
  assert (a <= s) by (apply S1; split; trivial; lra). assert (s <= b) by (apply S2; intros x [Hx _]; lra).
  destruct (S s ltac:(lra)) as (e & e0 & C). assert (X : exists x, s - e < x <= s /\ a <= x /\ P x).
  { apply Classical_Prop.NNPP. intros no. assert (s <= s - e); [ | lra ]. apply S2. intros x [Hx Px]. apply Rnot_lt_le. intros k. apply no.
    exists x. pose proof (S1 x (conj Hx Px)). split; [ lra | split; [ apply Hx | trivial ] ]. }
  destruct X as (x & Hx & ax & Px). set (y := Rmin b (s + e / 2)). assert (Hy : y <= b /\ s <= y < s + e) by (unfold y, Rmin; destruct Rle_dec;
    lra).
  assert (Py : P y) by (apply (C x y); lra || trivial). pose proof (S1 y ltac:(split; trivial; lra)). replace b with y; trivial.
  unfold y, Rmin in *. destruct Rle_dec; lra.
Qed.
(* what holds near each place, and also with less for e, holds on the whole with one e *)
Lemma uniform (Q : R -> R -> Prop) a b : a <= b -> (forall e d t, 0 < d <= e -> Q e t -> Q d t) ->
  (forall t, a <= t <= b -> exists e, 0 < e /\ forall s, Rabs (s - t) < e -> Q e s) -> exists e, 0 < e /\ forall t, a <= t <= b -> Q e t.
Proof.
  intros H Q1 L. apply (creep (fun x => exists e, 0 < e /\ forall t, a <= t <= x -> Q e t) a); trivial.
  - destruct (L a ltac:(lra)) as (e & e0 & E). exists e. split; trivial. intros t Ht. apply E, Rabs_def1; lra.
  - intros t Ht. destruct (L t Ht) as (e & e0 & E). exists e. split; trivial. intros x y Hx Hy _ _ (d & d0 & B).
    pose proof (Rmin_pos d e d0 e0). pose proof (Rmin_l d e). pose proof (Rmin_r d e). exists (Rmin d e). split; trivial.
    intros s Hs. destruct (Rle_dec s x); [ apply (Q1 d), B | apply (Q1 e), E, Rabs_def1 ]; lra.
Qed.

(* ---- primitives ---- *)
Section Primitive.
Variables (f : R -> R) (B : R).
Hypothesis fi : forall a b, ex_RInt f a b.
Hypothesis fB : forall t, Rabs (f t) <= B.
Notation F := (RInt f 0).
Lemma prim_between s t : F t - F s = RInt f s t.
Proof. rewrite <- (RInt_Chasles f 0 s t) by apply fi. change (RInt f 0 s + RInt f s t - RInt f 0 s = RInt f s t). ring. Qed.
Lemma prim_lip s t : s <= t -> Rabs (F t - F s) <= B * (t - s).
Proof. intros H. rewrite prim_between, Rmult_comm. apply abs_RInt_le_const; auto. Qed.
Lemma prim_cont t : continuity_pt F t.
Proof.
  apply (cont_lip F t 1 B Rlt_0_1). intros s _. destruct (Rle_dec s t).
  - rewrite Rabs_minus_sym, (Rabs_minus_sym s t), (Rabs_pos_eq (t - s)) by lra. now apply prim_lip.
  - rewrite (Rabs_pos_eq (s - t)) by lra. apply prim_lip. lra.
Qed.
Lemma prim_rder t : rcont f t -> rder F t (f t).
Proof.
  intros C. apply rder_intro. intros e he. destruct (C e he) as (d & d0 & D). exists d. split; trivial. intros h Hh. rewrite prim_between.
  assert (K : RInt f t (t + h) - f t * h = RInt (fun s => f s - f t) t (t + h)).
  { rewrite (RInt_minus f (fun _ => f t)) by (apply fi || apply ex_RInt_const). rewrite RInt_const. unfold minus, plus, opp, scal; simpl.
    unfold mult; simpl. ring. }
  rewrite K, (Rmult_comm e). replace h with (t + h - t) at 2 by ring. apply abs_RInt_le_const; [ lra | | ].
  - apply (ex_RInt_minus f (fun _ => f t)); [ apply fi | apply ex_RInt_const ].
  - intros s Hs. left. apply D. lra.
Qed.
Lemma prim_per T t : (forall s, f (s + T) = f s) -> F (t + T) = F t + F T.
Proof.
  intros P. pose proof (RInt_comp_lin f 1 T 0 t) as L. rewrite Rmult_0_r, !Rplus_0_l, Rmult_1_l in L.
  enough (F (t + T) - F T = F t) by lra. rewrite prim_between, <- L by apply fi. apply RInt_ext. intros s _.
  rewrite Rmult_1_l, P. f_equal. ring.
Qed.
End Primitive.
Lemma cont_int f : (forall t, continuity_pt f t) -> forall a b, ex_RInt f a b.
Proof. intros C a b. apply (ex_RInt_continuous f). intros z _. apply continuity_pt_filterlim, C. Qed.
Lemma cont_rcont f t : continuity_pt f t -> rcont f t.
Proof.
  intros C e he. destruct (cont_eps f t e C he) as (d & d0 & D). exists d. split; trivial. intros s Hs. apply D, Rabs_def1; lra.
Qed.
(* a continuous function that is not negative, and whose integral is not positive, is 0 *)
Lemma int_zero f B b : (forall t, continuity_pt f t) -> (forall t, 0 <= f t <= B) -> RInt f 0 b <= 0 -> forall t, 0 <= t < b -> f t = 0.
Proof.
  intros C hf hb t Ht. pose proof (cont_int f C) as fi. assert (fB : forall t, Rabs (f t) <= B) by (intros s; specialize (hf s);
    rewrite Rabs_pos_eq; lra).
  assert (N : forall s u, s <= u -> RInt f 0 s <= RInt f 0 u).
  { intros s u Hs. enough (0 <= RInt f s u) by (pose proof (prim_between f fi s u); lra). apply RInt_ge_0; trivial. intros; apply hf. }
  assert (Z : forall s, 0 <= s <= b -> RInt f 0 s = 0).
  { intros s Hs. pose proof (N 0 s ltac:(lra)) as K. pose proof (N s b ltac:(lra)). rewrite RInt_point in K. unfold zero in K. simpl in K. lra. }
  apply (rder_rest (RInt f 0) t (b - t)); [ lra | intros; apply Z; lra | apply (prim_rder f fi), cont_rcont, C ].
Qed.
Ltac abs := unfold Rabs in *; repeat destruct Rcase_abs; try lra.

(* below its median the mean distance from a continuous H grows *)
Section Strict.
Variables (H : R -> R) (c e : R).
Hypothesis cH : forall t, continuity_pt H t.
Hypothesis hc : median H c.
Hypothesis he : 0 < e.
Lemma abs_cont x t : continuity_pt (fun t => Rabs (H t - x)) t.
Proof. apply (continuity_pt_comp (fun t => H t - x) Rabs); cont. Qed.
Hint Resolve abs_cont : core.
Notation dist x := (RInt (fun t => Rabs (H t - x)) 0 (2 * PI)).
Lemma dist_minus x y : RInt (fun t => Rabs (H t - x) - Rabs (H t - y)) 0 (2 * PI) = dist x - dist y.
Proof. apply (RInt_minus (fun t => Rabs (H t - x)) (fun t => Rabs (H t - y))); apply cont_int, abs_cont. Qed.
Lemma median_strict : dist c < dist (c - e).
Proof.
  apply Rnot_le_lt. intros no. pose proof PI_RGT_0. pose proof (hc (c - e / 2)) as m.
  set (f t := Rabs (H t - (c - e)) - Rabs (H t - (c - e / 2)) - (Rabs (H t - (c - e / 2)) - Rabs (H t - c))).
  assert (Z : forall t, 0 <= t < 2 * PI -> f t = 0).
  { apply (int_zero f e).
    - intros t. unfold f. cont.
    - intros t. unfold f. abs.
    - unfold f. rewrite (RInt_minus (fun t => Rabs (H t - (c - e)) - Rabs (H t - (c - e / 2))) (fun t => Rabs (H t - (c - e / 2)) - Rabs (H t -
      c))), !dist_minus
        by (apply cont_int; intros; cont).
      unfold minus, plus, opp; simpl. lra. }
  assert (O : forall t, 0 <= t < 2 * PI -> H t <= c - e \/ c <= H t). { intros t Ht. specialize (Z t Ht). unfold f in Z. abs. }
  (* so H is on one side of the gap *)
  assert (S : forall s, s = 1 \/ s = -1 -> e / 2 <= s * (H 0 - (c - e / 2)) -> dist (c - e) - dist c = 2 * PI * (s * e)).
  { intros s hs s0. rewrite <- dist_minus, (RInt_ext _ (fun _ => s * e)); [ rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; ring | ].
    intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. destruct (Rlt_le_dec (s * (H t - (c - e / 2))) (e / 2)) as [k | k].
    - exfalso. destruct (Ranalysis5.IVT_interv (fun t => - (s * (H t - (c - e / 2)))) 0 t) as (z & Hz & ez); try lra; [ intros; cont | | ].
      + destruct hs as [-> | ->]; destruct (O t ltac:(lra)); lra.
      + destruct hs as [-> | ->]; destruct (O z ltac:(lra)); lra.
    - destruct hs as [-> | ->]; abs. }
  destruct (O 0 ltac:(lra)) as [k | k]; [ pose proof (S (-1) ltac:(auto) ltac:(lra)); pose proof (hc (c - e))
    | pose proof (S 1 ltac:(auto) ltac:(lra)) ]; nra.
Qed.
End Strict.
#[export] Hint Resolve abs_cont : core.

Lemma line_opp l h t0 w : line l l h t0 w -> line l l (fun t => - h t) t0 (fun t => - w t).
Proof.
  intros [c L]. split; intros t Ht; [ cont | ]. destruct (L t Ht) as (f & (F & P & N) & X). exists (- f). split.
  - split; [ lra | split; intros k; rewrite ?P, ?N by lra; lra ].
  - eapply rder_eq; [ apply rder_opp, X | ring ].
Qed.
Lemma median_opp H c : median H c -> median (fun t => - H t) (- c).
Proof.
  intros m x. specialize (m (- x)). rewrite (RInt_ext _ (fun t => Rabs (H t - c))), (RInt_ext (fun t => Rabs (- H t - x)) (fun t => Rabs (H t - -
    x))); trivial; intros t _;
    rewrite <- Rabs_Ropp; f_equal; ring.
Qed.

(* w is a motion along the line from t0 on; H is a primitive of the drive, of its period *)
Record little (l : R) (h H : R -> R) (t0 : R) (w : R -> R) : Prop := {
  k_l : 0 < l; k_size : forall t, Rabs (h t) <= 1; k_per : forall t, h (t + 2 * PI) = h t; k_c : forall t, continuity_pt H t;
  k_r : forall t, rder H t (h t); k_p : forall t, H (t + 2 * PI) = H t; k_line : line l l h t0 w }.
#[local] Arguments k_l {l h H t0 w}.
#[local] Arguments k_size {l h H t0 w}.
#[local] Arguments k_per {l h H t0 w}.
#[local] Arguments k_c {l h H t0 w}.
#[local] Arguments k_r {l h H t0 w}.
#[local] Arguments k_p {l h H t0 w}.
#[local] Arguments k_line {l h H t0 w}.
Lemma little_opp l h H t0 w : little l h H t0 w -> little l (fun t => - h t) (fun t => - H t) t0 (fun t => - w t).
Proof.
  intros []. split; trivial; try (intros; rewrite ?Rabs_Ropp, ?k_per0, ?k_p0; trivial); [ cont | now apply rder_opp | now apply line_opp ].
Qed.
Section Little.
Variables (l : R) (h H w : R -> R) (t0 : R).
Hypothesis S : little l h H t0 w.
Notation step t := (w (t + 2 * PI) - w t).
Lemma w_cont t : t0 < t -> continuity_pt w t. Proof. apply (l_c (k_line S)). Qed.
Hint Resolve w_cont : core.
(* what is left of the velocity without the drive changes at the rate of friction *)
Lemma bare r : t0 <= r -> exists f, dry l l (w r) f /\ rder w r (h r + f) /\ rder (fun t => w t - H t) r f.
Proof.
  intros Hr. destruct (l_law (k_line S) r Hr) as (f & F & X). exists f. split; trivial. split; trivial.
  eapply rder_eq; [ apply rder_minus; [ exact X | apply (k_r S) ] | ring ].
Qed.
Lemma bare_cont r : t0 < r -> continuity_pt (fun t => w t - H t) r.
Proof. intros Hr. pose proof (k_c S r). cont. Qed.
Hint Resolve bare_cont : core.
Lemma step_cont t : t0 < t -> continuity_pt (fun t => step t) t.
Proof.
  intros Ht. pose proof PI_RGT_0. apply (continuity_pt_minus (fun t => w (t + 2 * PI)) w); [ apply cont_after | ]; apply w_cont; lra.
Qed.
Lemma step_falls s t : t0 <= s <= t -> Rabs (step t) <= Rabs (step s).
Proof.
  intros Hs. pose proof PI_RGT_0. apply (line_contraction l l h t0 (fun t => w (t + 2 * PI)) w); trivial; [ | apply (k_line S) ].
  split; intros r Hr.
  - apply cont_after, w_cont. lra.
  - destruct (bare (r + 2 * PI)) as (f & D & X & _); [ lra | ]. exists f. split; trivial. rewrite (k_per S) in X. now apply rder_after.
Qed.
(* it cannot gain in each period: it would go forward throughout one *)
Lemma no_gain e t1 : 0 < e -> t0 <= t1 -> ~ forall t, t1 <= t -> e < step t.
Proof.
  intros he Ht1 G. pose proof PI_RGT_0. pose proof (k_l S) as hl. assert (N : forall n, w t1 + INR n * e <= w (t1 + INR n * (2 * PI))).
  { induction n as [ | n IH ]; [ simpl; rewrite !Rmult_0_l, !Rplus_0_r; lra | ]. pose proof (pos_INR n).
    specialize (G (t1 + INR n * (2 * PI)) ltac:(nra)).
    rewrite S_INR. replace (t1 + (INR n + 1) * (2 * PI)) with (t1 + INR n * (2 * PI) + 2 * PI) by ring. lra. }
  destruct (nat_above ((2 * PI * (1 + l) - w t1) / e)) as [n Hn]. apply Rlt_div_l in Hn; trivial. specialize (N n). pose proof (pos_INR n).
  set (t := t1 + INR n * (2 * PI)) in *. assert (tt : t1 <= t) by (unfold t; nra). specialize (G t tt). enough (step t <= - l * (2 * PI)) by nra.
  assert (P : forall s, t <= s <= t + 2 * PI -> 0 < w s).
  { intros s Hs. assert (K : Rabs (w s - w t) <= (1 + l) * (s - t)); [ | apply Rabs_le_between in K; nra ].
    apply rder_lip; [ lra | intros; apply w_cont; lra | ]. intros r Hr. destruct (bare r) as (f & (F & _) & X & _); [ lra | ].
    exists (h r + f). split; trivial. pose proof (k_size S r) as B. apply Rabs_le_between in B. apply Rabs_le. lra. }
  enough (w (t + 2 * PI) - H (t + 2 * PI) + l * (t + 2 * PI) <= w t - H t + l * t) by (rewrite (k_p S) in *; lra).
  apply (rder_decr (fun t => w t - H t + l * t)); [ lra | | ]; intros r Hr.
  - pose proof (k_c S r). cont.
  - destruct (bare r) as (f & (_ & F & _) & _ & X); [ lra | ]. rewrite F in X by (apply P; lra). eexists.
    split; [ apply (rder_plus (fun t => w t - H t) (fun t => l * t)); [ exact X | rd ] | lra ].
Qed.
(* where it is far above H - c throughout a period, it loses a fixed amount in that period *)
Lemma loses c e y : median H c -> 0 < e -> t0 <= y -> (forall t, y <= t <= y + 2 * PI -> c - e <= H t -> 0 < w t) ->
  e * step y <= - l * (RInt (fun t => Rabs (H t - (c - e))) 0 (2 * PI) - RInt (fun t => Rabs (H t - c)) 0 (2 * PI)).
Proof.
  intros hc he hy P. pose proof PI_RGT_0. pose proof (k_c S) as cH. pose proof (k_l S) as hl. pose proof (k_p S) as pH.
  rewrite <- (dist_minus H cH). set (f t := Rabs (H t - (c - e)) - Rabs (H t - c)). assert (cf : forall t, continuity_pt f t).
  { intros t. unfold f. cont. }
  assert (fB : forall t, Rabs (f t) <= e) by (intros t; unfold f; abs). pose proof (cont_int f cf) as fi.
  pose proof (prim_per f fi (2 * PI) y ltac:(intros t; unfold f; now rewrite pH)) as Q. set (F := RInt f 0) in *.
  enough (e * (w (y + 2 * PI) - H (y + 2 * PI)) + l * F (y + 2 * PI) <= e * (w y - H y) + l * F y) by (rewrite pH, Q in *; lra).
  apply (rder_decr (fun t => e * (w t - H t) + l * F t)); [ lra | | ]; intros r Hr.
  - pose proof (prim_cont f e fi fB r). cont.
  - destruct (bare r) as (g & (g0 & g1 & _) & _ & X); [ lra | ]. pose proof (prim_rder f fi r (cont_rcont _ _ (cf r))) as Y. fold F in Y.
    eexists. split; [ apply (rder_plus (fun t => e * (w t - H t)) (fun t => l * F t)); [ apply (rder_mult (fun _ => e)); [ rd | exact X ]
      | apply (rder_mult (fun _ => l)); [ rd | exact Y ] ] | ].
    specialize (fB r). apply Rabs_le_between in fB. destruct (Rle_dec (c - e) (H r)) as [k | k].
    + rewrite g1 by (apply P; lra). nra.
    + assert (f r = - e) as -> by (unfold f; abs). nra.
Qed.
End Little.

(* late motions are above H - c by PI l at most, but for as little as one likes *)
Lemma above_median l h H t0 w c e : little l h H t0 w -> median H c -> 0 < e -> exists t1, t0 <= t1 /\ forall t, t1 <= t ->
  w t - (H t - c) <= PI * l + e.
Proof.
  intros S hc he. pose proof PI_RGT_0. pose proof (k_l S) as hl. pose proof (median_strict H c e (k_c S) hc he) as k.
  pose proof (fun y => loses l h H w t0 S c e y hc he) as Q.
  
  set (d := RInt (fun t => Rabs (H t - (c - e))) 0 (2 * PI) - RInt (fun t => Rabs (H t - c)) 0 (2 * PI)) in Q.
  assert (d0 : 0 < l * d / e) by (apply Rdiv_lt_0_compat; trivial; apply Rmult_lt_0_compat; unfold d; lra). clear k. apply Classical_Prop.NNPP.
  intros no.
  assert (A : forall t1, t0 <= t1 -> exists y, t1 <= y /\ w (y + 2 * PI) - w y <= - (l * d / e)).
  { intros t1 Ht1. apply Classical_Prop.NNPP. intros n1. apply no. exists (t1 + PI). split; [ lra | ]. intros t Ht. apply Rnot_lt_le.
    intros far. apply n1. exists (t - PI). split; [ lra | ].
    enough (e * (w (t - PI + 2 * PI) - w (t - PI)) <= - l * d) by (apply Ropp_le_cancel; rewrite Ropp_involutive; apply Rle_div_l; lra).
    apply Q; [ lra | ]. intros s Hs k.
    assert (K : Rabs ((w t - H t) - (w s - H s)) <= l * PI).
    { assert (K : forall a b, t0 <= a <= b -> b - a <= PI -> Rabs ((w b - H b) - (w a - H a)) <= l * PI).
      { intros a b Hab hab. apply Rle_trans with (l * (b - a)); [ | nra ]. apply (rder_lip (fun t => w t - H t)); [ lra | | ]; intros r Hr;
        [ apply (bare_cont _ _ _ _ _ S); lra | ].
        destruct (bare _ _ _ _ _ S r) as (f & (F & _) & _ & X); [ lra | ]. exists f. split; [ exact X | apply Rabs_le; lra ]. }
      destruct (Rle_dec s t); [ | rewrite Rabs_minus_sym ]; apply K; lra. }
    apply Rabs_le_between in K. lra. }
  apply (no_gain _ _ _ _ _ (little_opp _ _ _ _ _ S) (l * d / e / 2) (t0 + 1) ltac:(lra) ltac:(lra)). intros t Ht. cbv beta. apply Rnot_le_lt.
  intros k.
  destruct (A t ltac:(lra)) as (y & Hy & Ey). pose proof (step_falls _ _ _ _ _ S t y ltac:(lra)) as K.
  rewrite (Rabs_left (w (y + 2 * PI) - w y)) in K by lra.
  assert (0 < w (t + 2 * PI) - w t) by (unfold Rabs in K; destruct Rcase_abs; lra). assert (ty : t < y) by (destruct Hy as [ | <-]; lra).
  destruct (Ranalysis5.IVT_interv (fun t => - (w (t + 2 * PI) - w t)) t y) as (z & Hz & ez); try lra.
  - intros a Ha. apply (continuity_pt_opp (fun t => w (t + 2 * PI) - w t)), (step_cont _ _ _ _ _ S). lra.
  - destruct (A z ltac:(lra)) as (x & Hx & Ex). pose proof (step_falls _ _ _ _ _ S z x ltac:(lra)) as J.
    assert (zz : w (z + 2 * PI) - w z = 0) by lra.
    rewrite zz, Rabs_R0 in J. pose proof (Rabs_pos (w (x + 2 * PI) - w x)). rewrite Rabs_left in J by lra. lra.
Qed.
Lemma near_median l h H t0 w c e : little l h H t0 w -> median H c -> 0 < e -> exists t1, t0 <= t1 /\ forall t, t1 <= t ->
  Rabs (w t - (H t - c)) <= PI * l + e.
Proof.
  intros S hc he. destruct (above_median l h H t0 w c e S hc he) as (a & Ha & A). destruct (above_median _ _ _ _ _ _ e (little_opp _ _ _ _ _ S)
    (median_opp _ _ hc) he) as (b & Hb & B).
  exists (Rmax a b). pose proof (Rmax_l a b). pose proof (Rmax_r a b). split; [ lra | ]. intros t Ht. specialize (A t ltac:(lra)).
  specialize (B t ltac:(lra)). cbv beta in B. apply Rabs_le. lra.
Qed.
