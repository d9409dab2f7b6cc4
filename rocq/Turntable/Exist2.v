(* Section 4: from every place and velocity there is a motion on the turntable, slipping or at rest *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Pieces Fate Alpha Picard Exist.
Open Scope R_scope.

(* a motion whose friction loses at most d of its power *)
Definition almost d ux uy fx fy := fx ^ 2 + fy ^ 2 <= 1 /\ fx * ux + fy * uy <= d - nrm ux uy.
Record near d (x y u w : R -> R) : Prop := {
  n_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt u t /\ continuity_pt w t;
  n_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, almost d (u t) (w t) fx fy /\
            rder u t (x t + 2 * w t + fx) /\ rder w t (y t - 2 * u t + fy) }.
Lemma spin_near x y u w : spin x y u w -> near 0 x y u w.
Proof.
  intros S. split. intros t Ht. split; [ | split; [ | split ] ]; [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; trivial.
  intros t Ht. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & [B P] & U & W). split; trivial. split; trivial. exists fx, fy. split; [ split; lra | auto ].
Qed.
Lemma near_apart d1 d2 x1 y1 u1 w1 x2 y2 u2 w2 : near d1 x1 y1 u1 w1 -> near d2 x2 y2 u2 w2 -> forall s t, 0 <= s <= t ->
  ((x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 + (u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2 + (d1 + d2)) * exp (- (2) * t) <=
  ((x1 s - x2 s) ^ 2 + (y1 s - y2 s) ^ 2 + (u1 s - u2 s) ^ 2 + (w1 s - w2 s) ^ 2 + (d1 + d2)) * exp (- (2) * s).
Proof.
  intros S1 S2 s t Hst. apply (rder_decr (fun t => ((x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 + (u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2 + (d1 + d2)) * exp (- (2) * t))); [ lra | | ]; intros r Hr.
  - destruct (n_c _ _ _ _ _ S1 r) as (? & ? & ? & ?); [ lra | ]. destruct (n_c _ _ _ _ _ S2 r) as (? & ? & ? & ?); [ lra | ]. cont.
  - destruct (n_law _ _ _ _ _ S1 r) as (X1 & Y1 & f1 & g1 & [B1 P1] & U1 & W1); [ lra | ].
    destruct (n_law _ _ _ _ _ S2 r) as (X2 & Y2 & f2 & g2 & [B2 P2] & U2 & W2); [ lra | ].
    eexists. split. rd. cbv beta. simpl pred. simpl INR. set (e := exp _). assert (e0 : 0 < e) by apply exp_pos.
    pose proof (power_bound 1 f2 g2 (u1 r) (w1 r) Rle_0_1 ltac:(lra)). pose proof (power_bound 1 f1 g1 (u2 r) (w2 r) Rle_0_1 ltac:(lra)).
    pose proof (pow2_ge_0 (x1 r - x2 r - (u1 r - u2 r))). pose proof (pow2_ge_0 (y1 r - y2 r - (w1 r - w2 r))).
    match goal with |- ?a * e + ?d * (?c * e) <= 0 => assert (a + d * c <= 0); [ | nra ] end. lra.
Qed.
Lemma almost_field d u w : 0 < d -> almost d u w (- (u / Rmax d (nrm u w))) (- (w / Rmax d (nrm u w))).
Proof.
  intros Hd. pose proof (nrm_sq u w) as e. pose proof (nrm_pos u w). set (n := nrm u w) in *. pose proof (Rmax_l d n). pose proof (Rmax_r d n). set (m := Rmax d n) in *. split; fold n.
  - replace ((- (u / m)) ^ 2 + (- (w / m)) ^ 2) with (n ^ 2 / m ^ 2) by (rewrite e; field; lra). apply Rle_div_l; nra.
  - replace (- (u / m) * u + - (w / m) * w) with (- (n ^ 2 / m)) by (rewrite e; field; lra). enough (n - d <= n ^ 2 / m) by lra. apply Rle_div_r. lra.
    unfold m, Rmax. destruct Rle_dec; nra.
Qed.
Lemma lim_geo (a : nat -> R) B : (forall n, Rabs (a (S n) - a n) <= B * (/ 2) ^ n) -> {l | forall n, Rabs (a n - l) <= 2 * B * (/ 2) ^ n}.
Proof.
  intros H. assert (B0 : 0 <= B). { specialize (H 0%nat). pose proof (Rabs_pos (a 1%nat - a 0%nat)). simpl in H. lra. }
  destruct (squeeze (fun n => a n - 2 * B * (/ 2) ^ n) (fun n => a n + 2 * B * (/ 2) ^ n)) as [l Hl].
  - intros n. specialize (H n). apply Rabs_le_between in H. simpl pow. lra.
  - intros n. specialize (H n). apply Rabs_le_between in H. simpl pow. lra.
  - intros n. assert (0 < (/ 2) ^ n) by (apply pow_lt; lra). nra.
  - exists l. intros n. specialize (Hl n). apply Rabs_le. lra.
Qed.
Lemma same_growth f g f' g' a b D : a <= b -> (forall s, a <= s <= b -> is_derive f s (f' s)) -> (forall s, a <= s <= b -> is_derive g s (g' s)) ->
  (forall s, a <= s <= b -> Rabs (f' s - g' s) <= D) -> Rabs ((f b - f a) - (g b - g a)) <= D * (b - a).
Proof.
  assert (H : forall f g f' g', a <= b -> (forall s, a <= s <= b -> is_derive f s (f' s)) -> (forall s, a <= s <= b -> is_derive g s (g' s)) ->
    (forall s, a <= s <= b -> Rabs (f' s - g' s) <= D) -> (f b - f a) - (g b - g a) <= D * (b - a)).
  { clear. intros f g f' g' Hab Df Dg H. enough (f b - g b - D * b <= f a - g a - D * a) by lra. apply (rder_decr (fun s => f s - g s - D * s)); trivial; intros s Hs.
    - pose proof (der_cont _ _ _ (Df s ltac:(lra))). pose proof (der_cont _ _ _ (Dg s ltac:(lra))). cont.
    - specialize (H s ltac:(lra)). pose proof (rder_of _ _ _ (Df s ltac:(lra))). pose proof (rder_of _ _ _ (Dg s ltac:(lra))). eexists. split. rd. apply Rabs_le_between in H. lra. }
  intros Hab Df Dg K. pose proof (H f g f' g' Hab Df Dg K). pose proof (H g f g' f' Hab Dg Df ltac:(intros; rewrite Rabs_minus_sym; auto)). apply Rabs_le. lra.
Qed.
Lemma zero_of (z C : R) : (forall n, Rabs z <= C * (/ 2) ^ n) -> z = 0.
Proof.
  intros H. destruct (Req_dec z 0) as [e | e]; trivial. exfalso. apply Rabs_pos_lt in e. destruct (halves C _ e) as [n Hn]. specialize (H n). lra.
Qed.
(* the limit of functions has the limit of their rates as its right derivative *)
Lemma limit_der (f f' : nat -> R -> R) F g a b C N : a < b -> (forall n s, a <= s <= b -> is_derive (f n) s (f' n s)) ->
  (forall n s, a <= s <= b -> Rabs (f n s - F s) <= C * (/ 2) ^ n) -> (forall n s, (N <= n)%nat -> a <= s <= b -> Rabs (f' n s - g s) <= C * (/ 2) ^ n) ->
  (forall t, continuity_pt g t) -> rder F a (g a).
Proof.
  intros Hab D HF Hg Cg. set (G := fun s => (F a - RInt g 0 a) + RInt g 0 s).
  assert (DG : forall s, is_derive G s (g s)) by (intros; apply primitive; trivial).
  assert (C0 : 0 <= C). { specialize (HF 0%nat a ltac:(lra)). pose proof (Rabs_pos (f 0%nat a - F a)). simpl in HF. lra. }
  apply (rder_loc F G a (g a) (b - a)); [ lra | | apply DG ]. intros s Hs. enough (F s - G s = 0) by lra.
  apply (zero_of _ (C * (2 + (b - a)) * 2 ^ N)). intros n. 
  assert (K : Rabs (F s - G s) <= C * (2 + (b - a)) * (/ 2) ^ (n + N)).
  { assert (L : (N <= n + N)%nat) by apply Nat.le_add_l. pose proof (HF (n + N)%nat s ltac:(lra)) as H1. pose proof (HF (n + N)%nat a ltac:(lra)) as H2.
    pose proof (same_growth (f (n + N)%nat) G (f' (n + N)%nat) g a s _ ltac:(lra) ltac:(intros; apply D; lra) ltac:(intros; apply DG) ltac:(intros; apply Hg; trivial; lra)) as H3.
    assert (Ga : G a = F a) by (unfold G; ring). assert (q : 0 < (/ 2) ^ (n + N)) by (apply pow_lt; lra). set (r := (/ 2) ^ (n + N)) in *.
    assert (C * r * (s - a) <= C * r * (b - a)) by (apply Rmult_le_compat_l; [ nra | lra ]).
    apply Rabs_le_between in H1, H2, H3. apply Rabs_le. lra. }
  eapply Rle_trans; [ exact K | ]. rewrite pow_add. assert ((/ 2) ^ N <= 2 ^ N). { apply pow_incr. lra. }
  assert (q : 0 < (/ 2) ^ n) by (apply pow_lt; lra). assert (0 <= C * (2 + (b - a))) by (apply Rmult_le_pos; lra). 
  replace (C * (2 + (b - a)) * 2 ^ N * (/ 2) ^ n) with (C * (2 + (b - a)) * ((/ 2) ^ n * 2 ^ N)) by ring. apply Rmult_le_compat_l; trivial. apply Rmult_le_compat_l; lra.
Qed.
Lemma rder_intro f t l : (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs (f (t + h) - f t - l * h) <= e * h) -> rder f t l.
Proof.
  intros H. exists (fun s => if Rlt_dec s t then f t + l * (s - t) else f s). split.
  - apply is_derive_Reals. intros e He. destruct (H (e / 2) ltac:(lra)) as (d & d0 & Hd). exists (mkposreal d d0). simpl. intros h h0 hd.
    apply Rabs_def2 in hd. destruct (Rlt_dec t t); [ lra | ]. destruct (Rlt_dec (t + h) t).
    + replace ((f t + l * (t + h - t) - f t) / h - l) with 0 by (field; lra). rewrite Rabs_R0. lra.
    + specialize (Hd h ltac:(lra)). replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - l * h) / h) by (field; lra).
      unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ h)) by (left; apply Rinv_0_lt_compat; lra). apply Rle_lt_trans with (e / 2); [ | lra ]. apply Rle_div_l; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Definition de (n : nat) := (/ 4) ^ n.
Lemma de_pos n : 0 < de n. Proof. apply pow_lt. lra. Qed.
Lemma de_sq n : de n = ((/ 2) ^ n) ^ 2.
Proof. unfold de. induction n as [ | n IH ]; simpl in *; [ ring | rewrite IH; field ]. Qed.
Lemma half_pos n : 0 < (/ 2) ^ n <= 1.
Proof. split. apply pow_lt. lra. rewrite <- (pow1 n). apply pow_incr. lra. Qed.
Lemma eventually D e : 0 <= D -> 0 < e -> exists N, forall n, (N <= n)%nat -> D * (/ 2) ^ n < e.
Proof.
  intros HD He. destruct (halves D e He) as [N HN]. exists N. intros n Hn. apply Rle_lt_trans with (2 := HN). apply Rmult_le_compat_l; trivial.
  replace n with (N + (n - N))%nat by (apply Nat.add_comm || (rewrite Nat.add_comm; apply Nat.sub_add; trivial)). rewrite pow_add. destruct (half_pos N). destruct (half_pos (n - N)). nra.
Qed.
Lemma abs_of_sq z k : 0 <= k -> z ^ 2 <= k ^ 2 -> Rabs z <= k.
Proof. intros. apply Rabs_le. split; nra. Qed.
Lemma near_pos f t : continuity_pt f t -> 0 < f t -> exists d, 0 < d /\ forall s, t - d < s < t + d -> 0 < f s.
Proof.
  intros C P. apply continuity_pt_filterlim in C. destruct (C (fun y => 0 < y) (open_gt 0 _ P)) as [d Hd].
  exists d. split. apply cond_pos. intros s Hs. apply Hd. change (Rabs (s - t) < d). apply Rabs_def1; lra.
Qed.

Section Exist.
Variable c : place -> R.
Definition Z n := proj1_sig (regular (de n) (de_pos n) c).
Lemma Z_spec n : (forall i, Z n i 0 = c i) /\ (forall i t, continuity_pt (Z n i) t) /\
  forall i t, 0 <= t -> is_derive (Z n i) t (field89 (de n) i (fun j => Z n j t)).
Proof. exact (proj2_sig (regular (de n) (de_pos n) c)). Qed.
Lemma Z_near n : near (de n) (Z n px) (Z n py) (Z n pu) (Z n pw).
Proof.
  destruct (Z_spec n) as (_ & C & D). split. { intros; repeat split; apply C. } intros t Ht. split. { apply rder_of, (D px t Ht). } split. { apply rder_of, (D py t Ht). }
  eexists. eexists. split. apply (almost_field (de n)), de_pos. split; (eapply rder_eq; [ apply rder_of | ]). apply (D pu t Ht). simpl. unfold slope. ring. apply (D pw t Ht). simpl. unfold slope. ring.
Qed.
Lemma Z_step n i t : 0 <= t -> Rabs (Z (S n) i t - Z n i t) <= 2 * exp t * (/ 2) ^ n.
Proof.
  intros Ht. pose proof (near_apart _ _ _ _ _ _ _ _ _ _ (Z_near (S n)) (Z_near n) 0 t ltac:(lra)) as H.
  destruct (Z_spec n) as (I & _). destruct (Z_spec (S n)) as (J & _). rewrite !I, !J in H. rewrite Rmult_0_r, exp_0 in H.
  assert (q0 : 0 < exp t) by apply exp_pos. assert (e : exp (- (2) * t) * exp t ^ 2 = 1). { replace (exp t ^ 2) with (exp t * exp t) by ring. rewrite <- !exp_plus. replace (- (2) * t + (t + t)) with 0 by ring. apply exp_0. }
  assert (d1 : de (S n) = de n / 4) by (unfold de; simpl; field). pose proof (de_pos n) as d0. pose proof (de_sq n) as dq. destruct (half_pos n) as [h0 h1].
  set (D := (Z (S n) px t - Z n px t) ^ 2 + (Z (S n) py t - Z n py t) ^ 2 + (Z (S n) pu t - Z n pu t) ^ 2 + (Z (S n) pw t - Z n pw t) ^ 2) in *.
  apply (Rmult_le_compat_r (exp t ^ 2)) in H; [ | nra ]. rewrite Rmult_assoc, e in H.
  assert (K : D <= (2 * exp t * (/ 2) ^ n) ^ 2). { replace ((2 * exp t * (/ 2) ^ n) ^ 2) with (4 * exp t ^ 2 * de n) by (rewrite dq; ring). rewrite d1 in H. pose proof (Rmult_lt_0_compat _ _ d0 (pow_lt _ 2 q0)). nra. }
  apply abs_of_sq. { apply Rmult_le_pos; lra. } unfold D in K.
  pose proof (pow2_ge_0 (Z (S n) px t - Z n px t)). pose proof (pow2_ge_0 (Z (S n) py t - Z n py t)). pose proof (pow2_ge_0 (Z (S n) pu t - Z n pu t)). pose proof (pow2_ge_0 (Z (S n) pw t - Z n pw t)).
  destruct i; lra.
Qed.
Definition V i t := proj1_sig (lim_geo (fun n => Z n i (Rmax 0 t)) (2 * exp (Rmax 0 t)) (fun n => Z_step n i (Rmax 0 t) (Rmax_l 0 t))).
Lemma V_close n i t : Rabs (Z n i (Rmax 0 t) - V i t) <= 4 * exp (Rmax 0 t) * (/ 2) ^ n.
Proof.
  unfold V. destruct (lim_geo _ _ _) as [l Hl]. simpl. replace (4 * exp (Rmax 0 t)) with (2 * (2 * exp (Rmax 0 t))) by ring. apply Hl.
Qed.
Lemma V_uniform n i s b : 0 <= s <= b -> Rabs (Z n i s - V i s) <= 4 * exp b * (/ 2) ^ n.
Proof.
  intros Hs. pose proof (V_close n i s) as H. rewrite (Rmax_right 0 s) in H by lra. eapply Rle_trans; [ exact H | ]. destruct (half_pos n). apply Rmult_le_compat_r; [ lra | ].
  destruct (proj2 Hs) as [k | ->]; [ pose proof (exp_increasing s b k) | ]; lra.
Qed.
Lemma V_0 i : V i 0 = c i.
Proof.
  enough (c i - V i 0 = 0) by lra. apply (zero_of _ (4 * exp 0)). intros n. rewrite <- (proj1 (Z_spec n)). apply V_uniform. lra.
Qed.
Lemma V_cont i t : continuity_pt (V i) t.
Proof.
  intros e He. set (T := Rmax 0 t + 1). destruct (halves (4 * exp T) (e / 3) ltac:(lra)) as [n Hn].
  destruct (proj1 (proj2 (Z_spec n)) i (Rmax 0 t) (e / 3) ltac:(lra)) as (d & d0 & Hd). exists (Rmin d 1). split. apply Rmin_pos; lra.
  intros s [_ Hs]. simpl in *. unfold R_dist in *. pose proof (Rmin_l d 1). pose proof (Rmin_r d 1). pose proof (Rmax_near s t) as M.
  assert (nr : forall r, Rmax 0 r <= T -> Rabs (Z n i (Rmax 0 r) - V i r) < e / 3).
  { intros r Hr. eapply Rle_lt_trans; [ apply V_close | ]. eapply Rle_lt_trans; [ | exact Hn ]. destruct (half_pos n). apply Rmult_le_compat_r; [ lra | ].
    destruct Hr as [Hr | ->]; [ pose proof (exp_increasing _ _ Hr) | ]; lra. }
  assert (mid : Rabs (Z n i (Rmax 0 s) - Z n i (Rmax 0 t)) < e / 3).
  { destruct (Req_dec (Rmax 0 s) (Rmax 0 t)) as [-> | ne]. rewrite Rminus_eq_0, Rabs_R0. lra. apply Hd. split; [ split; [ exact I | auto ] | lra ]. }
  assert (Ms : Rmax 0 s <= T). { assert (Rabs (Rmax 0 s - Rmax 0 t) < 1) as Q by lra. apply Rabs_def2 in Q. unfold T. lra. }
  pose proof (nr s Ms) as N1. pose proof (nr t ltac:(unfold T; lra)) as N2. apply Rabs_def2 in N1, N2, mid. apply Rabs_def1; lra.
Qed.
Lemma V_der i t d N b : 0 <= t < b -> 0 < d ->
  (forall n s, (N <= n)%nat -> t <= s <= b -> field89 (de n) i (fun j => Z n j s) = field89 d i (fun j => Z n j s)) -> rder (V i) t (field89 d i (fun j => V j t)).
Proof.
  intros Ht Hd H. assert (d3 : 0 < 3 / d) by (apply Rdiv_lt_0_compat; lra). pose proof (exp_pos b) as eb.
  apply (limit_der (fun n => Z n i) (fun n s => field89 (de n) i (fun j => Z n j s)) (V i) (fun s => field89 d i (fun j => V j s)) t b ((3 + 3 / d) * (4 * exp b)) N).
  - lra.
  - intros n s Hs. apply Z_spec. lra.
  - intros n s Hs. eapply Rle_trans; [ apply (V_uniform n i s b); lra | ]. destruct (half_pos n). apply Rmult_le_compat_r; [ lra | ]. nra.
  - intros n s Hn Hs. rewrite (H n s Hn Hs), Rmult_assoc. apply field89_lip; trivial. intros j. apply V_uniform. lra.
  - intros s. apply (cont_F (field89 d) (3 + 3 / d) ltac:(lra) (field89_lip d Hd) i V). intros; apply V_cont.
Qed.
Notation p t := (nrm (V pu t) (V pw t)).
Lemma V_slip t : 0 <= t -> 0 < p t -> rder (V pu) t (V px t + 2 * V pw t - V pu t / p t) /\ rder (V pw) t (V py t - 2 * V pu t - V pw t / p t).
Proof.
  intros Ht P. set (q := p t) in *. destruct (near_pos (fun s => p s - q / 2) t) as (d & d0 & Hd). { cont; apply V_cont. } { fold q. lra. } cbv beta in Hd.
  set (b := t + d / 2). pose proof (exp_pos b) as eb. destruct (eventually (8 * exp b + 1) (q / 4)) as [N HN]; [ lra | lra | ].
  assert (K : forall n s, (N <= n)%nat -> t <= s <= b -> slope (de n) (fun j => Z n j s) = slope (q / 4) (fun j => Z n j s)).
  { intros n s Hn Hs. unfold slope. specialize (HN n Hn). specialize (Hd s ltac:(unfold b in Hs; lra)). destruct (half_pos n) as [h0 h1]. pose proof (de_sq n).
    pose proof (V_uniform n pu s b ltac:(lra)) as Qu. pose proof (V_uniform n pw s b ltac:(lra)) as Qw. pose proof (nrm_lip (Z n pu s) (Z n pw s) (V pu s) (V pw s)) as Q.
    assert (Q2 : Rabs (nrm (Z n pu s) (Z n pw s) - p s) <= 8 * exp b * (/ 2) ^ n) by lra. apply Rabs_le_between in Q2.
    assert (0 < exp b * (/ 2) ^ n) by (apply Rmult_lt_0_compat; lra). assert (de n <= (/ 2) ^ n) by nra. rewrite !Rmax_right; lra. }
  assert (m : slope (q / 4) (fun j => V j t) = q). { unfold slope. fold q. apply Rmax_right. lra. }
  split; (eapply rder_eq; [ eapply (V_der _ t (q / 4) N b); [ unfold b; lra | lra | intros n s Hn Hs; simpl; rewrite (K n s Hn Hs); reflexivity ] | simpl; now rewrite m ]).
Qed.
Lemma V_rest t s i : 0 <= t <= s -> p t = 0 -> V px t ^ 2 + V py t ^ 2 <= 1 -> V i s = V i t.
Proof.
  intros Hts z r1. destruct (stop0 (V pu) (V pw) t z) as [z1 z2]. apply rest_radius, spin_near in r1. enough (V i s - V i t = 0) by lra.
  apply (zero_of _ (9 * exp t * exp s + 4 * exp s)). intros n. pose proof (near_apart _ _ _ _ _ _ _ _ _ _ (Z_near n) r1 t s Hts) as H.
  pose proof (de_pos n) as d0. pose proof (de_sq n) as dq. destruct (half_pos n) as [h0 h1]. 
  assert (qt : 1 <= exp t) by (pose proof (exp_ineq1_le t); lra). assert (qs : 1 <= exp s) by (pose proof (exp_ineq1_le s); lra).
  assert (et : exp (- (2) * t) <= 1). { rewrite <- exp_0. destruct (proj1 Hts) as [k | <-]; [ left; apply exp_increasing; lra | right; f_equal; ring ]. }
  assert (es : exp (- (2) * s) * exp s ^ 2 = 1). { replace (exp s ^ 2) with (exp s * exp s) by ring. rewrite <- !exp_plus. replace (- (2) * s + (s + s)) with 0 by ring. apply exp_0. }
  assert (sq : forall j, (Z n j t - V j t) ^ 2 <= 16 * exp t ^ 2 * de n).
  { intros j. pose proof (V_uniform n j t t ltac:(lra)) as Q. rewrite <- (pow2_abs (Z n j t - V j t)). replace (16 * exp t ^ 2 * de n) with ((4 * exp t * (/ 2) ^ n) ^ 2) by (rewrite dq; ring). apply pow_incr. split; trivial. apply Rabs_pos. }
  pose proof (sq px) as s1. pose proof (sq py) as s2. pose proof (sq pu) as s3. pose proof (sq pw) as s4. rewrite z1 in s3. rewrite z2 in s4.
  set (Dt := (Z n px t - V px t) ^ 2 + (Z n py t - V py t) ^ 2 + (Z n pu t - 0) ^ 2 + (Z n pw t - 0) ^ 2) in *.
  set (Ds := (Z n px s - V px t) ^ 2 + (Z n py s - V py t) ^ 2 + (Z n pu s - 0) ^ 2 + (Z n pw s - 0) ^ 2) in *.
  assert (D1 : 0 <= Dt + (de n + 0) <= 81 * exp t ^ 2 * de n). { split. unfold Dt. pose proof (pow2_ge_0 (Z n px t - V px t)). pose proof (pow2_ge_0 (Z n py t - V py t)). pose proof (pow2_ge_0 (Z n pu t - 0)). pose proof (pow2_ge_0 (Z n pw t - 0)). lra.
    assert (1 * de n <= exp t ^ 2 * de n) by (apply Rmult_le_compat_r; nra). unfold Dt. lra. }
  assert (H1 : (Ds + (de n + 0)) * exp (- (2) * s) <= 81 * exp t ^ 2 * de n).
  { eapply Rle_trans; [ exact H | ]. apply Rle_trans with ((Dt + (de n + 0)) * 1); [ apply Rmult_le_compat_l; lra | lra ]. }
  apply (Rmult_le_compat_r (exp s ^ 2)) in H1; [ | nra ]. rewrite Rmult_assoc, es in H1.
  assert (K : Ds <= (9 * exp t * exp s * (/ 2) ^ n) ^ 2). { replace ((9 * exp t * exp s * (/ 2) ^ n) ^ 2) with (81 * exp t ^ 2 * de n * exp s ^ 2) by (rewrite dq; ring). lra. }
  assert (Q : Rabs (Z n i s - V i t) <= 9 * exp t * exp s * (/ 2) ^ n).
  { apply abs_of_sq. { apply Rmult_le_pos; [ | lra ]. nra. } unfold Ds in K.
    pose proof (pow2_ge_0 (Z n px s - V px t)). pose proof (pow2_ge_0 (Z n py s - V py t)). pose proof (pow2_ge_0 (Z n pu s - 0)). pose proof (pow2_ge_0 (Z n pw s - 0)).
    destruct i; rewrite ?z1, ?z2; lra. }
  pose proof (V_uniform n i s s ltac:(lra)) as Q2. apply Rabs_le_between in Q, Q2. apply Rabs_le. lra.
Qed.
(* put down outside rho = 1, at rest for one moment: it starts outward *)
Lemma V_release t : 0 <= t -> p t = 0 -> 1 < nrm (V px t) (V py t) ->
  rder (V pu) t (V px t * (1 - / nrm (V px t) (V py t))) /\ rder (V pw) t (V py t * (1 - / nrm (V px t) (V py t))).
Proof.
  intros Ht z r1. destruct (stop0 (V pu) (V pw) t z) as [z1 z2]. pose proof (nrm_sq (V px t) (V py t)) as rr. set (r := nrm (V px t) (V py t)) in *.
  set (k := r - 1). set (a := V px t / r). set (b := V py t / r). set (x1 := V px t) in *. set (y1 := V py t) in *.
  assert (xa : x1 = r * a) by (unfold a; field; lra). assert (ya : y1 = r * b) by (unfold b; field; lra).
  assert (ab : a ^ 2 + b ^ 2 = 1). { apply (Rmult_eq_reg_l (r ^ 2)); [ | nra ]. transitivity ((r * a) ^ 2 + (r * b) ^ 2). ring. rewrite <- xa, <- ya. lra. }
  replace (x1 * (1 - / r)) with (k * a) by (unfold k; rewrite xa; field; lra). replace (y1 * (1 - / r)) with (k * b) by (unfold k; rewrite ya; field; lra).
  assert (k0 : 0 < k) by (unfold k; lra). clear z.
  set (D n s := (Z n px s - (x1 + k * a * (s - t) ^ 2 * / 2)) ^ 2 + (Z n py s - (y1 + k * b * (s - t) ^ 2 * / 2)) ^ 2 + (Z n pu s - k * a * (s - t)) ^ 2 + (Z n pw s - k * b * (s - t)) ^ 2).
  pose proof (exp_pos t) as qt0. assert (qt : 1 <= exp t) by (pose proof (exp_ineq1_le t); lra).
  assert (start : forall n, D n t <= 64 * exp t ^ 2 * de n).
  { intros n. assert (sq : forall j, (Z n j t - V j t) ^ 2 <= 16 * exp t ^ 2 * de n).
    { intros j. pose proof (V_uniform n j t t ltac:(lra)) as Q. rewrite <- (pow2_abs (Z n j t - V j t)). replace (16 * exp t ^ 2 * de n) with ((4 * exp t * (/ 2) ^ n) ^ 2) by (rewrite de_sq; ring). apply pow_incr. split; trivial. apply Rabs_pos. }
    pose proof (sq px) as s1. pose proof (sq py) as s2. pose proof (sq pu) as s3. pose proof (sq pw) as s4. rewrite z1 in s3. rewrite z2 in s4. fold x1 in s1. fold y1 in s2.
    unfold D. rewrite Rminus_eq_0. replace (x1 + k * a * 0 ^ 2 * / 2) with x1 by ring. replace (y1 + k * b * 0 ^ 2 * / 2) with y1 by ring. rewrite !Rmult_0_r. lra. }
  assert (grow : forall n h, 0 <= h <= 1 -> D n (t + h) <= exp 3 * (66 * exp t ^ 2 * de n + 2 * k ^ 2 * h ^ 3)).
  { intros n h Hh. pose proof (de_pos n) as d0.
    assert (K : D n (t + h) * exp (- (3) * (t + h - t)) - 2 * de n * (t + h - t) - 5 * k ^ 2 * / 3 * (t + h - t) ^ 3 <= D n t * exp (- (3) * (t - t)) - 2 * de n * (t - t) - 5 * k ^ 2 * / 3 * (t - t) ^ 3).
    { apply (rder_decr (fun s => D n s * exp (- (3) * (s - t)) - 2 * de n * (s - t) - 5 * k ^ 2 * / 3 * (s - t) ^ 3)); [ lra | | ]; intros s Hs.
      - unfold D. cont; apply (proj1 (proj2 (Z_spec n))).
      - destruct (n_law _ _ _ _ _ (Z_near n) s ltac:(lra)) as (X & Y & fx & fy & [B P] & U & W). unfold D. eexists. split. rd. cbv beta. simpl pred. simpl INR.
        set (e := exp (- (3) * (s - t))). assert (e0 : 0 < e <= 1). { split. apply exp_pos. unfold e. rewrite <- exp_0. destruct (proj1 Hs) as [q | <-]; [ left; apply exp_increasing; lra | right; f_equal; ring ]. }
        set (m := s - t) in *. assert (m0 : 0 <= m <= 1) by (unfold m; lra).
        set (dx := Z n px s - (x1 + k * a * m ^ 2 * / 2)) in *. set (dy := Z n py s - (y1 + k * b * m ^ 2 * / 2)) in *. set (du := Z n pu s - k * a * m) in *. set (dw := Z n pw s - k * b * m) in *.
        pose proof (power_bound 1 fx fy a b Rle_0_1 ltac:(lra)) as Q1. assert (en : nrm a b = 1) by (unfold nrm; rewrite ab; apply sqrt_1). rewrite en in Q1.
        pose proof (power_bound 1 a b (- Z n pu s) (- Z n pw s) Rle_0_1 ltac:(lra)) as Q2. assert (en2 : nrm (- Z n pu s) (- Z n pw s) = nrm (Z n pu s) (Z n pw s)) by (unfold nrm; f_equal; ring). rewrite en2 in Q2.
        assert (Q3 : (fx + a) * du + (fy + b) * dw <= de n).
        { unfold du, dw. assert (k * m * (- (1)) <= k * m * (fx * a + fy * b)) by (apply Rmult_le_compat_l; [ nra | lra ]).
          replace ((fx + a) * (Z n pu s - k * a * m) + (fy + b) * (Z n pw s - k * b * m)) with (fx * Z n pu s + fy * Z n pw s + (a * Z n pu s + b * Z n pw s) - k * m * (fx * a + fy * b) - k * m * (a ^ 2 + b ^ 2)) by ring. rewrite ab. lra. }
        (* what the candidate lacks *)
        set (rx := - (k * a * m ^ 2 * / 2) - 2 * (k * b * m)). set (ry := - (k * b * m ^ 2 * / 2) + 2 * (k * a * m)).
        assert (rs : rx ^ 2 + ry ^ 2 <= 5 * k ^ 2 * m ^ 2).
        { replace (rx ^ 2 + ry ^ 2) with (k ^ 2 * m ^ 2 * (m ^ 2 * / 4 + 4) * (a ^ 2 + b ^ 2)) by (unfold rx, ry; field). rewrite ab, Rmult_1_r. replace (5 * k ^ 2 * m ^ 2) with (k ^ 2 * m ^ 2 * 5) by ring.
          apply Rmult_le_compat_l; [ apply Rmult_le_pos; apply pow2_ge_0 | nra ]. }
        assert (main : 2 * dx * du + 2 * dy * dw + 2 * du * (dx + 2 * dw + (fx + a) - rx) + 2 * dw * (dy - 2 * du + (fy + b) - ry) <= 3 * (dx ^ 2 + dy ^ 2 + du ^ 2 + dw ^ 2) + (2 * de n + 5 * k ^ 2 * m ^ 2)).
        { pose proof (pow2_ge_0 (dx - du)). pose proof (pow2_ge_0 (dy - dw)). pose proof (pow2_ge_0 (du + rx)). pose proof (pow2_ge_0 (dw + ry)). pose proof (pow2_ge_0 dx). pose proof (pow2_ge_0 dy). nra. }
        assert (eu : Z n px s + 2 * Z n pw s + fx - k * a = dx + 2 * dw + (fx + a) - rx) by (unfold dx, dw, rx; rewrite xa; unfold k; ring).
        assert (ew : Z n py s - 2 * Z n pu s + fy - k * b = dy - 2 * du + (fy + b) - ry) by (unfold dy, du, ry; rewrite ya; unfold k; ring).
        set (L := 2 * dx * du + 2 * dy * dw + 2 * du * (dx + 2 * dw + (fx + a) - rx) + 2 * dw * (dy - 2 * du + (fy + b) - ry)) in *. set (DD := dx ^ 2 + dy ^ 2 + du ^ 2 + dw ^ 2) in *.
        assert (c0 : 0 <= 2 * de n + 5 * k ^ 2 * m ^ 2). { assert (0 <= k ^ 2 * m ^ 2) by (apply Rmult_le_pos; apply pow2_ge_0). lra. }
        match goal with |- ?g <= 0 => replace g with ((L - 3 * DD) * e - (2 * de n + 5 * k ^ 2 * m ^ 2)) end. nra.
        unfold L, DD. rewrite <- eu, <- ew. unfold du, dw. field. }
    replace (t + h - t) with h in K by ring. rewrite Rminus_eq_0, Rmult_0_r, exp_0 in K. specialize (start n).
    assert (e3 : exp (- (3) * h) * exp (3 * h) = 1). { rewrite <- exp_plus. replace (- (3) * h + 3 * h) with 0 by ring. apply exp_0. }
    assert (e4 : exp (3 * h) <= exp 3). { destruct (proj2 Hh) as [q | ->]; [ left; apply exp_increasing; lra | right; f_equal; ring ]. }
    pose proof (exp_pos (3 * h)) as e5. assert (h3 : 0 <= h ^ 3) by (apply pow_le; lra). assert (kk : 0 <= k ^ 2) by apply pow2_ge_0.
    assert (K2 : D n (t + h) * exp (- (3) * h) <= 66 * exp t ^ 2 * de n + 2 * k ^ 2 * h ^ 3).
    { assert (1 * de n <= exp t ^ 2 * de n) by (apply Rmult_le_compat_r; nra). assert (0 <= k ^ 2 * h ^ 3) by (apply Rmult_le_pos; trivial). assert (de n * h <= de n) by nra. lra. }
    apply (Rmult_le_compat_r (exp (3 * h))) in K2; [ | lra ]. rewrite Rmult_assoc, e3 in K2. 
    assert (c0 : 0 <= 66 * exp t ^ 2 * de n + 2 * k ^ 2 * h ^ 3). { assert (0 <= exp t ^ 2 * de n) by (apply Rmult_le_pos; nra). assert (0 <= k ^ 2 * h ^ 3) by (apply Rmult_le_pos; trivial). lra. }
    rewrite (Rmult_comm (exp 3)). eapply Rle_trans; [ rewrite Rmult_1_r in K2; exact K2 | ]. now apply Rmult_le_compat_l. }
  assert (close : forall i v, (i = pu /\ v = k * a) \/ (i = pw /\ v = k * b) -> rder (V i) t v).
  { intros i v Hi. apply rder_intro. intros e He. set (C := 8 * exp 3 * k ^ 2 + 1). assert (e30 : 0 < exp 3) by apply exp_pos. assert (C0 : 1 <= C). { unfold C. assert (0 <= exp 3 * k ^ 2) by (apply Rmult_le_pos; nra). lra. }
    exists (Rmin 1 (e ^ 2 / C)). split. { apply Rmin_pos; [ lra | apply Rdiv_lt_0_compat; nra ]. } intros h Hh. pose proof (Rmin_l 1 (e ^ 2 / C)). pose proof (Rmin_r 1 (e ^ 2 / C)).
    assert (hC : h * C <= e ^ 2). { apply Rle_div_r; lra. }
    assert (hb : exp 3 * (2 * k ^ 2 * h ^ 3) <= (e * h / 2) ^ 2). { replace ((e * h / 2) ^ 2) with (h ^ 2 * (e ^ 2 / 4)) by field. replace (exp 3 * (2 * k ^ 2 * h ^ 3)) with (h ^ 2 * (h * (8 * exp 3 * k ^ 2) / 4)) by field. apply Rmult_le_compat_l; [ nra | ]. unfold C in hC. lra. }
    set (M := 9 * exp 2 * exp t + 4 * exp (t + 1)).
    assert (all : forall n, Rabs (V i (t + h) - v * h) <= e * h / 2 + M * (/ 2) ^ n).
    { intros n. specialize (grow n h ltac:(lra)). destruct (half_pos n) as [h0 h1]. pose proof (V_uniform n i (t + h) (t + 1) ltac:(lra)) as Q.
      assert (ex : exp 3 <= exp 2 ^ 2). { replace (exp 2 ^ 2) with (exp 2 * exp 2) by ring. rewrite <- exp_plus. left. apply exp_increasing. lra. }
      assert (Q2 : Rabs (Z n i (t + h) - v * h) <= e * h / 2 + 9 * exp 2 * exp t * (/ 2) ^ n).
      { pose proof (exp_pos 2). assert (p1 : 0 < exp 2 * exp t) by (apply Rmult_lt_0_compat; lra). assert (p2 : 0 < 9 * exp 2 * exp t * (/ 2) ^ n) by (rewrite Rmult_assoc; apply Rmult_lt_0_compat; nra).
        apply abs_of_sq. nra. apply Rle_trans with (D n (t + h)).
        - unfold D. replace (t + h - t) with h by ring. pose proof (pow2_ge_0 (Z n px (t + h) - (x1 + k * a * h ^ 2 * / 2))). pose proof (pow2_ge_0 (Z n py (t + h) - (y1 + k * b * h ^ 2 * / 2))).
          pose proof (pow2_ge_0 (Z n pu (t + h) - k * a * h)). pose proof (pow2_ge_0 (Z n pw (t + h) - k * b * h)). destruct Hi as [[-> ->] | [-> ->]]; lra.
        - eapply Rle_trans; [ exact grow | ]. assert (exp 3 * (66 * exp t ^ 2 * de n) <= (9 * exp 2 * exp t * (/ 2) ^ n) ^ 2).
          { replace ((9 * exp 2 * exp t * (/ 2) ^ n) ^ 2) with (81 * exp 2 ^ 2 * (exp t ^ 2 * de n)) by (rewrite de_sq; ring). pose proof (de_pos n). assert (0 <= exp t ^ 2 * de n) by (apply Rmult_le_pos; nra).
            replace (exp 3 * (66 * exp t ^ 2 * de n)) with (66 * exp 3 * (exp t ^ 2 * de n)) by ring. apply Rmult_le_compat_r; trivial. lra. }
          assert (0 <= e * h / 2 * (9 * exp 2 * exp t * (/ 2) ^ n)) by (apply Rmult_le_pos; nra). rewrite Rmult_plus_distr_l. lra. }
      apply Rabs_le_between in Q, Q2. unfold M. apply Rabs_le. lra. }
    assert (Vt : V i t = 0) by (destruct Hi as [[-> _] | [-> _]]; trivial). rewrite Vt, Rminus_0_r.
    apply Rnot_lt_le. intros bad. destruct (halves M (e * h / 2)) as [n Hn]. nra. specialize (all n). lra. }
  split; apply close; auto.
Qed.
Lemma V_spin : spin (V px) (V py) (V pu) (V pw).
Proof.
  split; try (intros; apply V_cont). intros t Ht.
  split. { apply (V_der px t 1 0 (t + 1)); try lra. reflexivity. } split. { apply (V_der py t 1 0 (t + 1)); try lra. reflexivity. }
  destruct (nrm_pos (V pu t) (V pw t)) as [P | z].
  - destruct (V_slip t Ht P) as [U W]. exists (- 1 * V pu t / p t), (- 1 * V pw t / p t). split.
    + apply coulomb_iff. lra. right. split. lra. auto.
    + split; (eapply rder_eq; [ eassumption | field; lra ]).
  - symmetry in z. destruct (stop0 (V pu) (V pw) t z) as [z1 z2]. pose proof (nrm_sq (V px t) (V py t)) as rr. pose proof (nrm_pos (V px t) (V py t)).
    set (r := nrm (V px t) (V py t)) in *. destruct (Rle_lt_dec r 1) as [r1 | r1].
    + assert (in1 : V px t ^ 2 + V py t ^ 2 <= 1) by nra. exists (- V px t), (- V py t). split. { split. nra. rewrite z, z1, z2. ring. }
      assert (Q : forall i, V i t = 0 -> rder (V i) t 0). { intros i e. apply (rder_zero (V i) t 1 Rlt_0_1). intros s Hs. rewrite <- e. apply V_rest; trivial; lra. }
      split; (eapply rder_eq; [ apply Q; trivial | rewrite ?z1, ?z2; ring ]).
    + destruct (V_release t Ht z r1) as [U W]. fold r in U, W. exists (- (V px t / r)), (- (V py t / r)). split.
      * split. { replace ((- (V px t / r)) ^ 2 + (- (V py t / r)) ^ 2) with ((V px t ^ 2 + V py t ^ 2) / r ^ 2) by (field; lra). rewrite <- rr. right. field. lra. } rewrite z, z1, z2. ring.
      * split; (eapply rder_eq; [ eassumption | rewrite ?z1, ?z2; field; lra ]).
Qed.
End Exist.

(* every start has a motion ... *)
Theorem table_exists x0 y0 u0 w0 : exists x y u w, spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0.
Proof.
  set (c i := match i with px => x0 | py => y0 | pu => u0 | pw => w0 end).
  exists (V c px), (V c py), (V c pu), (V c pw). split. apply V_spin. rewrite !V_0. auto.
Qed.
(* ... and one only *)
Corollary table_one_motion x0 y0 u0 w0 : exists x y u w, (spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0) /\
  forall x' y' u' w', spin x' y' u' w' -> x' 0 = x0 -> y' 0 = y0 -> u' 0 = u0 -> w' 0 = w0 ->
  forall t, 0 <= t -> x' t = x t /\ y' t = y t /\ u' t = u t /\ w' t = w t.
Proof.
  destruct (table_exists x0 y0 u0 w0) as (x & y & u & w & S & e1 & e2 & e3 & e4). exists x, y, u, w. split; auto.
  intros x' y' u' w' S' f1 f2 f3 f4 t Ht. apply (table_unique _ _ _ _ _ _ _ _ 0 S' S); congruence || lra.
Qed.
