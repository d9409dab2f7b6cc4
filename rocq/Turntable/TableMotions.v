(* From every place and velocity there is a motion on the table, slipping or at rest. A particle in a plane whose acceleration is given has one
   (General/Exists.v); it is given by the place and velocity of another particle, that of one more, and so on (turn): their distances shrink
   as 2^-n, and what they tend to drives itself (limit). *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis TableLaws Formulas.
From Slipbook.General Require Import Contraction Exists.
Open Scope R_scope.

(* the four coordinates of a state: those of the place and of the velocity *)
Inductive place := px | py | pu | pw.

(* ---- limits as data: nothing is chosen ---- *)
Lemma half_pos n : 0 < (/ 2) ^ n <= 1.
Proof. split. apply pow_lt. lra. rewrite <- (pow1 n). apply pow_incr. lra. Qed.
Lemma halves D e : 0 < e -> exists n, D * (/ 2) ^ n < e.
Proof.
  intros He. pose proof (Rabs_pos D). destruct (pow_lt_1_zero (/ 2) ltac:(rewrite Rabs_pos_eq; lra) (e / (Rabs D + 1))) as [n Hn].
  { apply Rdiv_lt_0_compat; lra. }
  exists n. specialize (Hn n (le_n n)). destruct (half_pos n). rewrite Rabs_pos_eq in Hn by lra. apply Rlt_div_r in Hn; [ | lra ].
  pose proof (Rle_abs D). nra.
Qed.
Lemma le_by_halves a b C : (forall n, a <= b + C * (/ 2) ^ n) -> a <= b.
Proof. intros H. apply Rnot_lt_le. intros k. destruct (halves C (a - b)) as [n Hn]. lra. specialize (H n). lra. Qed.
Definition geo (a : nat -> R) B := forall n, Rabs (a (S n) - a n) <= B / 2 * (/ 2) ^ n.
Lemma lim_geo a : (exists B, geo a B) -> {l | forall B, geo a B -> forall n, Rabs (a n - l) <= B * (/ 2) ^ n}.
Proof.
  intros E. assert (K : forall B, geo a B -> 0 <= B /\ forall n k, Rabs (a (n + k)%nat - a n) <= B * (/ 2) ^ n - B * (/ 2) ^ (n + k)).
  { intros B H. split. { specialize (H 0%nat). pose proof (Rabs_pos (a 1%nat - a 0%nat)). simpl in H. lra. }
    induction k as [ | k IH ]. rewrite Nat.add_0_r, !Rminus_eq_0, Rabs_R0; lra.
    rewrite Nat.add_succ_r. specialize (H (n + k)%nat). simpl pow. apply Rabs_le_between in H, IH. apply Rabs_le. lra. }
  destruct (Rcomplete.R_complete a) as [l Hl].
  - intros e He. destruct E as [B H]. destruct (K B H) as [B0 M]. destruct (halves (2 * B) e He) as [N HN]. exists N. intros n m Hn Hm.
    assert (Q : forall n, (n >= N)%nat -> Rabs (a n - a N) <= B * (/ 2) ^ N).
    { intros k Hk. replace k with (N + (k - N))%nat by lia. destruct (half_pos (N + (k - N))). specialize (M N (k - N)%nat). nra. }
    pose proof (Q n Hn) as k1. pose proof (Q m Hm) as k2. apply Rabs_le_between in k1, k2. apply Rabs_def1; lra.
  - exists l. intros B H n. destruct (K B H) as [B0 M]. apply le_epsilon. intros e He. destruct (Hl e He) as [N HN].
    specialize (HN (n + N)%nat ltac:(lia)). unfold R_dist in HN. specialize (M n N). destruct (half_pos (n + N)).
    apply Rabs_def2 in HN. apply Rabs_le_between in M. apply Rabs_le. nra.
Qed.
(* what is just one number *)
Lemma pick (P : R -> Prop) : (exists r, P r) -> (forall r s, P r -> P s -> r = s) -> {r | P r}.
Proof.
  intros E U. destruct (completeness P) as [m [m1 m2]]; trivial. { destruct E as [r p]. exists r. intros s q. now right; apply U. }
  exists m. destruct E as [r p]. replace m with r; trivial. apply Rle_antisym; [ now apply m1 | apply m2; intros s q; now right; apply U ].
Qed.

(* ---- functions that begin at 0 ---- *)
Lemma cont_from f l : (forall t, 0 < t -> continuity_pt f t) -> rder f 0 l -> forall t, continuity_pt (fun s => f (Rmax 0 s)) t.
Proof.
  intros C [F [D E]] t. assert (K : forall c t, continuity_pt (fun _ : R => c : R) t) by (intros; cont).
  destruct (Rtotal_order t 0) as [k | [-> | k]].
  - apply (cont_glue _ (fun _ => f 0) (fun _ => f 0) t (- t)); trivial; try lra; intros; now rewrite Rmax_left by lra.
  - apply (cont_glue _ (fun _ => f 0) F 0 1); trivial; try lra; [ | | now apply (cont_of F 0 l) ]; intros.
    now rewrite Rmax_left by lra. rewrite Rmax_right, E; trivial; lra.
  - apply (cont_ext f); auto. intros. now rewrite Rmax_right.
Qed.
Lemma exp_up a b : a <= b -> exp a <= exp b.
Proof. intros [H | ->]; [ left; now apply exp_increasing | lra ]. Qed.
(* a limit that is uniform up to each moment is continuous *)
Lemma cont_limit (f : nat -> R -> R) F C L t : 0 <= L -> (forall n s, continuity_pt (f n) s) ->
  (forall n s, Rabs (f n s - F s) <= C * exp (L * Rmax 0 s) * (/ 2) ^ n) -> continuity_pt F t.
Proof.
  intros HL Cf H e He. set (q := exp (L * (Rmax 0 t + 1))). destruct (halves (C * q) (e / 3) ltac:(lra)) as [n Hn].
  destruct (cont_eps (f n) t (e / 3) (Cf n t) ltac:(lra)) as (d & d0 & Hd). exists (Rmin d 1). split. apply Rmin_pos; lra.
  intros s [_ Hs]. simpl in *. unfold R_dist in *. apply Rmin_Rgt_l in Hs as [s1 s2]. destruct (half_pos n) as [h0 _].
  assert (C0 : 0 <= C). { specialize (H 0%nat 0). pose proof (Rabs_pos (f 0%nat 0 - F 0)). pose proof (exp_pos (L * Rmax 0 0)). simpl in H. nra. }
  assert (N : forall r, Rabs (r - t) < 1 -> Rabs (f n r - F r) < e / 3).
  { intros r Hr. eapply Rle_lt_trans; [ apply H | ]. eapply Rle_lt_trans; [ | exact Hn ]. apply Rmult_le_compat_r; [ lra | ]. apply Rmult_le_compat_l;
    trivial. apply exp_up, Rmult_le_compat_l; trivial. apply Rabs_def2 in Hr. unfold Rmax. repeat destruct Rle_dec; lra. }
  pose proof (N s s2) as n1. pose proof (N t ltac:(rewrite Rminus_eq_0, Rabs_R0; lra)) as n2. specialize (Hd s s1).
  apply Rabs_def2 in n1, n2, Hd. apply Rabs_def1; lra.
Qed.
(* what moves no faster than this goes no farther than that *)
Lemma drift D K t : (forall s, 0 < s -> continuity_pt D s) -> D 0 = 0 ->
  (forall s, 0 <= s -> exists l, rder D s l /\ l <= 10 * D s + K * exp (20 * s)) -> 0 <= K -> 0 <= t -> D t <= K / 10 * exp (20 * t).
Proof.
  intros C D0 H hK Ht. assert (e : forall s, exp (20 * s) * exp (- (10) * s) = exp (10 * s)) by (intros; rewrite <- exp_plus; f_equal; ring).
  assert (M : D t * exp (- (10) * t) - K / 10 * exp (10 * t) <= D 0 * exp (- (10) * 0) - K / 10 * exp (10 * 0)).
  { apply (rder_decr (fun t => D t * exp (- (10) * t) - K / 10 * exp (10 * t))); trivial; intros s Hs.
    - specialize (C s ltac:(lra)). cont.
    - destruct (H s ltac:(lra)) as (l & L & b). eexists. split. rd. cbv beta. rewrite <- (e s). pose proof (exp_pos (- (10) * s)). nra. }
  rewrite D0, Rmult_0_l, Rmult_0_r, exp_0, <- (e t) in M. pose proof (exp_pos (- (10) * t)).
  apply (Rmult_le_reg_r (exp (- (10) * t))); trivial. lra.
Qed.

(* ---- a motion that is driven by another ---- *)
Definition good (f : place -> R -> R) := forall i t, continuity_pt (f i) t /\ f i t = f i (Rmax 0 t).
Definition driven (c : place -> R) (f g : place -> R -> R) := (forall i, g i 0 = c i) /\ forall t, 0 <= t ->
  rder (g px) t (f pu t) /\ rder (g py) t (f pw t) /\ exists fx fy, coulomb 1 (g pu t) (g pw t) fx fy /\
  rder (g pu) t (f px t + 2 * f pw t + fx) /\ rder (g pw) t (f py t - 2 * f pu t + fy).
Section Exist.
Variable c : place -> R.
Lemma drive f : good f -> {g | good g /\ driven c f g}.
Proof.
  intros G. assert (C : forall i t, continuity_pt (f i) t) by apply G. set (Ax t := - (f px t + 2 * f pw t)). set (Ay t := - (f py t - 2 * f pu t)).
  assert (E : exists vx vy, motion 1 Ax Ay vx vy /\ vx 0 = c pu /\ vy 0 = c pw).
  { apply plane_has_a_motion. lra. intros t _. pose proof (fun i => C i t). split; unfold Ax, Ay; cont. }
  set (Q (b : bool) t r := forall vx vy, motion 1 Ax Ay vx vy -> vx 0 = c pu -> vy 0 = c pw -> r = (if b then vx else vy) (Rmax 0 t)).
  assert (q : forall b t, {r | Q b t r}).
  { intros b t. apply pick.
    - destruct E as (vx & vy & M & e1 & e2). exists ((if b then vx else vy) (Rmax 0 t)). intros wx wy N f1 f2.
      destruct (uniqueness 1 Ax Ay vx vy wx wy Rle_0_1 M N ltac:(lra) ltac:(lra) (Rmax 0 t) (Rmax_l 0 t)). now destruct b.
    - destruct E as (vx & vy & M & e1 & e2). intros r s Hr Hs. rewrite (Hr vx vy), (Hs vx vy); trivial. }
  set (g i t := match i with px => c px + RInt (f pu) 0 (Rmax 0 t) | py => c py + RInt (f pw) 0 (Rmax 0 t) | pu => proj1_sig (q true t) |
    pw => proj1_sig (q false t) end).
  exists g. destruct E as (vx & vy & M & e1 & e2). pose proof (m_law _ _ _ _ _ M) as L. destruct (L 0 (Rle_refl 0)) as (? & ? & _ & Dx & Dy).
  assert (gu : g pu = fun t => vx (Rmax 0 t)) by (apply functional_extensionality; intros t; now apply (proj2_sig (q true t) vx vy)).
  assert (gw : g pw = fun t => vy (Rmax 0 t)) by (apply functional_extensionality; intros t; now apply (proj2_sig (q false t) vx vy)).
  assert (I : forall i a t, is_derive (fun t => a + RInt (f i) 0 t) t (f i t)).
  { intros i a t. rewrite <- (Rplus_0_l (f i t)). apply (is_derive_plus (fun _ => a)); [ auto_derive; trivial | now apply primitive_rate ]. }
  assert (on : forall h t l, 0 <= t -> rder h t l -> rder (fun t => h (Rmax 0 t)) t l).
  { intros h t l Ht. apply rder_ext. intros s Hs. now rewrite Rmax_right by lra. }
  split; [ | split ].
  - intros i t. split. 2: destruct i; rewrite ?gu, ?gw; unfold g; now rewrite (Rmax_right 0 (Rmax 0 t)) by apply Rmax_l.
    destruct i; rewrite ?gu, ?gw.
    1: apply (cont_from (fun t => c px + RInt (f pu) 0 t) (f pu 0)); [ intros; eapply cont_of, I | apply rder_of, I ].
    1: apply (cont_from (fun t => c py + RInt (f pw) 0 t) (f pw 0)); [ intros; eapply cont_of, I | apply rder_of, I ].
    + apply (cont_from vx _ (m_cx _ _ _ _ _ M) Dx).
    + apply (cont_from vy _ (m_cy _ _ _ _ _ M) Dy).
  - intros i. assert (z : Rmax 0 0 = 0) by apply Rmax_left, Rle_refl. destruct i; rewrite ?gu, ?gw; unfold g; rewrite z, ?RInt_point; trivial;
  apply Rplus_0_r.
  - intros t Ht. split. { apply (on (fun t => c px + RInt (f pu) 0 t)), rder_of, I. exact Ht. }
    split. { apply (on (fun t => c py + RInt (f pw) 0 t)), rder_of, I. exact Ht. }
    destruct (L t Ht) as (fx & fy & F & X & Y). exists fx, fy. rewrite gu, gw. cbv beta. rewrite Rmax_right by trivial. split; [ exact F | ].
    split; (eapply rder_eq; [ apply on; eassumption | unfold Ax, Ay; ring ]).
Qed.
(* the squared distance *)
Definition far (f g : place -> R -> R) t := (f px t - g px t) ^ 2 + (f py t - g py t) ^ 2 + (f pu t - g pu t) ^ 2 + (f pw t - g pw t) ^ 2.
Ltac squares := repeat match goal with |- context [(?a - ?b) ^ 2] => lazymatch goal with H : 0 <= (a - b) ^ 2 |- _ => fail | _ =>
  pose proof (pow2_ge_0 (a - b)) end end.
Lemma far_ge f g i t : 0 <= (f i t - g i t) ^ 2 <= far f g t.
Proof. split. apply pow2_ge_0. unfold far. squares. destruct i; lra. Qed.
(* what is driven by two that are near is nearer *)
Lemma nearer f f' g g' m t : good g -> good g' -> driven c f g -> driven c f' g' ->
  (forall t, 0 <= t -> far f f' t <= m * exp (20 * t)) -> 0 <= t -> far g g' t <= m / 4 * exp (20 * t).
Proof.
  intros G G' [z D] [z' D'] H Ht. assert (C : forall i t, continuity_pt (g i) t) by apply G. assert (C' : forall i t, continuity_pt (g' i) t) by apply G'.
  assert (m0 : 0 <= m). { specialize (H 0 (Rle_refl 0)). rewrite Rmult_0_r, exp_0 in H. pose proof (far_ge f f' px 0). lra. }
  apply Rle_trans with (m / 10 * exp (20 * t)); [ | pose proof (exp_pos (20 * t)); nra ].
  apply drift; trivial. { intros. unfold far. cont. } { unfold far. rewrite !z, !z'. ring. }
  intros s Hs. destruct (D s Hs) as (X & Y & fx & fy & [B P] & U & W). destruct (D' s Hs) as (X' & Y' & hx & hy & [B' P'] & U' & W').
  eexists. split. unfold far. rd. cbv beta. simpl pred. simpl INR. specialize (H s Hs). unfold far in *.
  pose proof (power_bound 1 fx fy (g' pu s) (g' pw s) Rle_0_1 B). pose proof (power_bound 1 hx hy (g pu s) (g pw s) Rle_0_1 B').
  set (a := f px s - f' px s) in *. set (b := f py s - f' py s) in *. set (d := f pu s - f' pu s) in *. set (e := f pw s - f' pw s) in *.
  pose proof (pow2_ge_0 (10 * (g px s - g' px s) - d)). pose proof (pow2_ge_0 (10 * (g py s - g' py s) - e)).
  pose proof (pow2_ge_0 (10 * (g pu s - g' pu s) - (a + 2 * e))). pose proof (pow2_ge_0 (10 * (g pw s - g' pw s) - (b - 2 * d))).
  pose proof (pow2_ge_0 (2 * a - e)). pose proof (pow2_ge_0 (2 * b + d)). pose proof (pow2_ge_0 a). pose proof (pow2_ge_0 b). pose proof (pow2_ge_0 d).
  pose proof (pow2_ge_0 e). unfold a, b, d, e in *. lra.
Qed.
(* from rest at the start, driven again and again *)
Lemma still_good : good (fun i _ => c i). Proof. intros i t. split; trivial. cont. Qed.
Fixpoint turn n : {f | good f} := match n with
  | O => exist _ _ still_good
  | S n => let (g, H) := drive _ (proj2_sig (turn n)) in exist _ g (proj1 H) end.
Notation phi n := (proj1_sig (turn n)).
Lemma phi_good n : good (phi n). Proof. exact (proj2_sig (turn n)). Qed.
Lemma phi_driven n : driven c (phi n) (phi (S n)).
Proof. simpl. destruct (drive _ _) as [g [H K]]. exact K. Qed.
Lemma first : exists K, 0 <= K /\ forall t, 0 <= t -> far (phi 1) (phi 0) t <= K * exp (20 * t).
Proof.
  destruct (phi_driven 0) as [z D]. pose proof (phi_good 1) as G. set (g := phi 1) in *. simpl in D. change (phi 0) with (fun i (_ : R) => c i).
  assert (C : forall i t, continuity_pt (g i) t) by apply G. clearbody g. clear G.
  set (K := c pu ^ 2 + c pw ^ 2 + 2 * ((c px + 2 * c pw) ^ 2 + (c py - 2 * c pu) ^ 2 + 1)). exists K.
  assert (K0 : 0 <= K). { unfold K. pose proof (pow2_ge_0 (c pu)). pose proof (pow2_ge_0 (c pw)). pose proof (pow2_ge_0 (c px + 2 * c pw)). squares. lra. }
  split; trivial. intros t Ht. apply Rle_trans with (K / 10 * exp (20 * t)); [ | pose proof (exp_pos (20 * t)); nra ].
  apply drift; trivial. { intros. unfold far. cont. } { unfold far. rewrite !z. ring. }
  intros s Hs. destruct (D s Hs) as (X & Y & fx & fy & [B P] & U & W). pose proof (exp_up 0 (20 * s) ltac:(lra)) as e. rewrite exp_0 in e.
  assert (Ke : K <= K * exp (20 * s)) by nra. eexists. split. unfold far. rd. cbv beta. simpl pred. simpl INR. unfold far. squares.
  pose proof (pow2_ge_0 (g px s - c px - c pu)). pose proof (pow2_ge_0 (g py s - c py - c pw)).
  pose proof (pow2_ge_0 (g pu s - c pu - (c px + 2 * c pw + fx))). pose proof (pow2_ge_0 (g pw s - c pw - (c py - 2 * c pu + fy))).
  pose proof (pow2_ge_0 (c px + 2 * c pw - fx)). pose proof (pow2_ge_0 (c py - 2 * c pu - fy)). unfold K in Ke at 1. lra.
Qed.
Lemma phi_near : exists K, 0 <= K /\ forall n t, 0 <= t -> far (phi (S n)) (phi n) t <= K * ((/ 2) ^ n) ^ 2 * exp (20 * t).
Proof.
  destruct first as (K & K0 & H). exists K. split; trivial. induction n as [ | n IH ]; intros t Ht.
  { replace (K * ((/ 2) ^ 0) ^ 2) with K by (simpl; ring). auto. }
  replace (K * ((/ 2) ^ S n) ^ 2) with (K * ((/ 2) ^ n) ^ 2 / 4) by (simpl pow; field).
  apply (nearer (phi (S n)) (phi n)); auto using phi_good, phi_driven.
Qed.
(* the limit is driven by itself: it is the motion *)
Lemma exp_10 t : exp (20 * t) = exp (10 * t) ^ 2.
Proof. simpl. rewrite Rmult_1_r, <- exp_plus. f_equal. ring. Qed.
Lemma limit : {V | good V /\ driven c V V}.
Proof.
  assert (E : exists B, 0 <= B /\ forall i t, geo (fun n => phi n i t) (B * exp (10 * Rmax 0 t))).
  { destruct phi_near as (K & K0 & H). exists (2 * sqrt K). pose proof (sqrt_pos K). split. lra. intros i t n. pose proof (exp_pos (10 * Rmax 0 t)).
    destruct (half_pos n). rewrite (proj2 (phi_good (S n) i t)), (proj2 (phi_good n i t)). apply abs_of_sq.
    { repeat apply Rmult_le_pos; lra. }
    specialize (H n _ (Rmax_l 0 t)). rewrite exp_10 in H. eapply Rle_trans; [ apply far_ge | eapply Rle_trans; [ exact H | right ] ].
    rewrite <- (pow2_sqrt K K0) at 1. field. }
  assert (lims : forall i t, {l | forall B, geo (fun n => phi n i t) B -> forall n, Rabs (phi n i t - l) <= B * (/ 2) ^ n}).
  { intros i t. apply (lim_geo (fun n => phi n i t)). destruct E as (B & _ & H). now exists (B * exp (10 * Rmax 0 t)). }
  set (W i t := proj1_sig (lims i (Rmax 0 t))).
  assert (N : exists B, 0 <= B /\ forall n i t, Rabs (phi n i t - W i t) <= B * exp (10 * Rmax 0 t) * (/ 2) ^ n).
  { destruct E as (B & B0 & H). exists B. split; trivial. intros n i t. unfold W. rewrite (proj2 (phi_good n i t)).
    rewrite <- (Rmax_right 0 (Rmax 0 t)) at 3 by apply Rmax_l. apply (proj2_sig (lims i (Rmax 0 t))), H. }
  assert (G : good W).
  { intros i t. split. 2: unfold W; now rewrite (Rmax_right 0 (Rmax 0 t)) by apply Rmax_l. destruct N as (B & _ & H).
    apply (cont_limit (fun n => phi n i) (W i) B 10); [ lra | intros n s; apply (phi_good n i s) | auto ]. }
  destruct (drive W G) as (V & GV & D). exists V. split; trivial. replace W with V in D at 1; trivial.
  apply functional_extensionality. intros i. apply functional_extensionality. intros s. rewrite (proj2 (GV i s)), (proj2 (G i s)).
  pose proof (Rmax_l 0 s) as Ht. set (t := Rmax 0 s) in *. apply Rminus_diag_uniq, abs_zero. destruct N as (B & B0 & H).
  apply (le_by_halves _ _ (2 * B * exp (10 * t))). intros n. pose proof (exp_pos (10 * t)). destruct (half_pos n).
  assert (Q : far V (phi (S n)) t <= 4 * (B * (/ 2) ^ n) ^ 2 / 4 * exp (20 * t)).
  { apply (nearer W (phi n)); auto using phi_good, phi_driven. intros r Hr. assert (M : forall j, (W j r - phi n j r) ^ 2 <= (B * exp (10 * r) * (/ 2) ^ n) ^ 2).
    { intros j. specialize (H n j r). rewrite Rmax_right in H by trivial. rewrite <- pow2_abs, Rabs_minus_sym. apply pow_incr. split; trivial. apply Rabs_pos. }
    rewrite exp_10. unfold far. pose proof (M px). pose proof (M py). pose proof (M pu). pose proof (M pw). lra. }
  specialize (H (S n) i t). rewrite Rmax_right in H by trivial. simpl pow in H. rewrite exp_10 in Q. pose proof (far_ge V (phi (S n)) i t).
  assert (M : Rabs (V i t - phi (S n) i t) <= B * exp (10 * t) * (/ 2) ^ n). { apply abs_of_sq; [ apply Rmult_le_pos; nra | lra ]. }
  apply Rabs_le_between in H, M. apply Rabs_le. lra.
Qed.
Definition V := proj1_sig limit.
Lemma V_0 i : V i 0 = c i. Proof. apply (proj2_sig limit). Qed.
Lemma V_spin : spin (V px) (V py) (V pu) (V pw).
Proof. unfold V. destruct limit as (V & G & z & D). simpl. split; try apply D; intros; apply G. Qed.
End Exist.

(* every start has a motion; that it has one only is shown in Rest/Fate.v *)
Theorem table_exists x0 y0 u0 w0 : exists x y u w, spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0.
Proof.
  set (c i := match i with px => x0 | py => y0 | pu => u0 | pw => w0 end).
  exists (V c px), (V c py), (V c pu), (V c pw). split. apply V_spin. rewrite !V_0. auto.
Qed.
(* with dimensions *)
Theorem turntable_exists Om k x0 y0 u0 w0 : 0 < Om -> 0 < k -> exists x y u w, turntable Om k x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0.
Proof.
  intros HO Hk. destruct (table_exists (Om ^ 2 / k * x0) (Om ^ 2 / k * y0) (Om / k * u0) (Om / k * w0)) as (x & y & u & w & S & e1 & e2 & e3 & e4).
  apply spin_is_turntable, (rescale _ _ Om (k / Om ^ 2)) in S; trivial; [ | apply Rdiv_lt_0_compat; nra ].
  rewrite Rmult_1_r in S. replace (k / Om ^ 2 * Om ^ 2 * 1) with k in S by (field; lra). do 4 eexists. split. exact S.
  cbv beta. rewrite Rmult_0_r, e1, e2, e3, e4. repeat split; field; lra.
Qed.
