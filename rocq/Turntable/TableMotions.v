(* From every place and velocity there is one motion on the table, slipping or at rest. Motions whose friction loses at most d of its power stay close
   (near_apart); they exist (Picard, with the direction of the slip made Lipschitz); for d = 4^-n they converge, and the limit has the right rates (follow) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion TableLaws Picard.
Open Scope R_scope.

Definition almost d ux uy fx fy := fx ^ 2 + fy ^ 2 <= 1 /\ fx * ux + fy * uy <= d - nrm ux uy.
Record near d (x y u w : R -> R) : Prop := {
  n_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt u t /\ continuity_pt w t;
  n_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, almost d (u t) (w t) fx fy /\
            rder u t (x t + 2 * w t + fx) /\ rder w t (y t - 2 * u t + fy) }.
Lemma spin_near x y u w : spin x y u w -> near 0 x y u w.
Proof.
  intros S. split. intros t Ht. repeat split; [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; trivial.
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

(* A motion, almost, against the straight line from a state with the friction (fx, fy) there: they part as h^3, if the friction loses h^2 at most along it *)
Section Follow.
Variables d t x0 y0 u0 w0 fx fy C : R.
Variables x y u w : R -> R.
Notation ax := (x0 + 2 * w0 + fx).
Notation ay := (y0 - 2 * u0 + fy).
Definition gap s := (x s - (x0 + (s - t) * u0)) ^ 2 + (y s - (y0 + (s - t) * w0)) ^ 2 + (u s - (u0 + (s - t) * ax)) ^ 2 + (w s - (w0 + (s - t) * ay)) ^ 2.
Definition bend := ax ^ 2 + ay ^ 2 + (u0 + 2 * ay) ^ 2 + (w0 - 2 * ax) ^ 2 + 2 * C.
Hypothesis S : near d x y u w.
Hypothesis hd : 0 <= d.
Hypothesis ht : 0 <= t.
Hypothesis hf : fx ^ 2 + fy ^ 2 <= 1.
Hypothesis hC : forall h, 0 <= h <= 1 -> nrm (u0 + h * ax) (w0 + h * ay) + (fx * (u0 + h * ax) + fy * (w0 + h * ay)) <= C * h ^ 2.

Lemma bend_pos : 0 <= bend.
Proof.
  pose proof (hC 1 ltac:(lra)) as H. pose proof (power_bound 1 fx fy (u0 + 1 * ax) (w0 + 1 * ay) Rle_0_1 ltac:(lra)). unfold bend.
  pose proof (pow2_ge_0 ax). pose proof (pow2_ge_0 ay). pose proof (pow2_ge_0 (u0 + 2 * ay)). pose proof (pow2_ge_0 (w0 - 2 * ax)). lra.
Qed.
Lemma follow h : 0 <= h <= 1 -> gap (t + h) <= exp 3 * (gap t + 2 * d + bend * h ^ 3).
Proof.
  intros Hh. pose proof bend_pos as b0. set (K := bend) in *.
  assert (M : gap (t + h) * exp (- (3) * (t + h - t)) - 2 * d * (t + h - t) - K * / 3 * (t + h - t) ^ 3 <= gap t * exp (- (3) * (t - t)) - 2 * d * (t - t) - K * / 3 * (t - t) ^ 3).
  { apply (rder_decr (fun s => gap s * exp (- (3) * (s - t)) - 2 * d * (s - t) - K * / 3 * (s - t) ^ 3)); [ lra | | ]; intros s Hs; unfold gap.
    - destruct (n_c _ _ _ _ _ S s) as (? & ? & ? & ?); [ lra | ]. cont.
    - destruct (n_law _ _ _ _ _ S s ltac:(lra)) as (X & Y & gx & gy & [B P] & U & W). eexists. split. rd. cbv beta. simpl pred. simpl INR.
      set (e := exp (- (3) * (s - t))). assert (e0 : 0 < e <= 1). { split. apply exp_pos. rewrite <- exp_0. apply exp_up. lra. }
      set (m := s - t) in *. assert (m0 : 0 <= m <= 1) by (unfold m; lra). specialize (hC m m0).
      set (dx := x s - (x0 + m * u0)) in *. set (dy := y s - (y0 + m * w0)) in *. set (du := u s - (u0 + m * ax)) in *. set (dw := w s - (w0 + m * ay)) in *.
      pose proof (power_bound 1 gx gy (u0 + m * ax) (w0 + m * ay) Rle_0_1 ltac:(lra)) as Q1. pose proof (power_bound 1 fx fy (u s) (w s) Rle_0_1 ltac:(lra)) as Q2.
      assert (Q3 : (gx - fx) * du + (gy - fy) * dw <= d + C * m ^ 2) by (unfold du, dw; lra).
      set (G := dx ^ 2 + dy ^ 2 + du ^ 2 + dw ^ 2) in *.
      set (T := 2 * dx * (du + m * ax) + 2 * dy * (dw + m * ay) + 2 * du * (dx + 2 * dw + m * (u0 + 2 * ay) + (gx - fx)) + 2 * dw * (dy - 2 * du + m * (w0 - 2 * ax) + (gy - fy))).
      assert (main : T <= 3 * G + (2 * d + K * m ^ 2)).
      { pose proof (pow2_ge_0 (dx - m * ax)). pose proof (pow2_ge_0 (dy - m * ay)). pose proof (pow2_ge_0 (du - m * (u0 + 2 * ay))). pose proof (pow2_ge_0 (dw - m * (w0 - 2 * ax))).
        pose proof (pow2_ge_0 (dx - du)). pose proof (pow2_ge_0 (dy - dw)). unfold T, G, K, bend. lra. }
      assert (c0 : 0 <= 2 * d + K * m ^ 2). { pose proof (Rmult_le_pos _ _ b0 (pow2_ge_0 m)). lra. }
      match goal with |- ?g <= 0 => replace g with ((T - 3 * G) * e - (2 * d + K * m ^ 2)) end. nra.
      unfold T, G, dx, dy, du, dw. field. }
  replace (t + h - t) with h in M by ring. rewrite Rminus_eq_0, Rmult_0_r, exp_0 in M.
  assert (e1 : exp (- (3) * h) * exp (3 * h) = 1) by (rewrite <- exp_plus; replace (- (3) * h + 3 * h) with 0 by ring; apply exp_0).
  assert (e2 : exp (3 * h) <= exp 3) by (apply exp_up; lra). pose proof (exp_pos (3 * h)).
  assert (h3 : 0 <= K * h ^ 3) by (apply Rmult_le_pos; [ trivial | apply pow_le; lra ]). assert (0 <= gap t).
  { unfold gap. rewrite Rminus_eq_0. apply Rplus_le_le_0_compat; [ apply Rplus_le_le_0_compat; [ apply Rplus_le_le_0_compat | ] | ]; apply pow2_ge_0. }
  assert (M2 : gap (t + h) * exp (- (3) * h) <= gap t + 2 * d + K * h ^ 3) by nra.
  apply (Rmult_le_compat_r (exp (3 * h))) in M2; [ | lra ]. rewrite Rmult_assoc, e1, Rmult_1_r in M2. eapply Rle_trans; [ exact M2 | ]. rewrite (Rmult_comm (exp 3)). apply Rmult_le_compat_l; lra.
Qed.
End Follow.

(* ---- (89) with the direction of the slip made Lipschitz ---- *)
Lemma nrm_lip a b a' b' : Rabs (nrm a b - nrm a' b') <= Rabs (a - a') + Rabs (b - b').
Proof.
  assert (H : forall a b a' b', nrm a b <= nrm a' b' + (Rabs (a - a') + Rabs (b - b'))).
  { clear. intros a b a' b'. pose proof (nrm_sq a b) as e1. pose proof (nrm_sq a' b') as e2. pose proof (nrm_pos a b). pose proof (nrm_pos a' b').
    pose proof (power_bound (nrm a' b') (- a') (- b') (a - a') (b - b') H0 ltac:(lra)) as Q.
    pose proof (nrm_sq (a - a') (b - b')) as e3. pose proof (nrm_pos (a - a') (b - b')).
    pose proof (pow2_abs (a - a')) as k1. pose proof (pow2_abs (b - b')) as k2. pose proof (Rabs_pos (a - a')). pose proof (Rabs_pos (b - b')).
    set (n := nrm a b) in *. set (m := nrm a' b') in *. set (k := nrm (a - a') (b - b')) in *.
    assert (n <= m + k) by nra. assert (k <= Rabs (a - a') + Rabs (b - b')) by nra. lra. }
  pose proof (H a b a' b'). pose proof (H a' b' a b) as K. rewrite (Rabs_minus_sym a'), (Rabs_minus_sym b') in K. apply Rabs_le. lra.
Qed.
Lemma nrm_ge a b : Rabs a <= nrm a b /\ Rabs b <= nrm a b.
Proof. pose proof (nrm_pos a b). pose proof (pow2_ge_0 a). pose proof (pow2_ge_0 b). split; apply abs_of_sq; trivial; rewrite nrm_sq; lra. Qed.
Lemma ratio_lip d a n a' n' D : 0 < d -> 0 <= n -> Rabs a' <= n' -> Rabs (a - a') <= D -> Rabs (n - n') <= 2 * D ->
  Rabs (a / (d + n) - a' / (d + n')) <= 3 / d * D.
Proof.
  intros Hd n0 ha hD hN. pose proof (Rabs_pos a'). replace (a / (d + n) - a' / (d + n')) with (((a - a') + a' / (d + n') * (n' - n)) * / (d + n)) by (field; lra).
  assert (r : 0 < / (d + n) <= / d) by (split; [ apply Rinv_0_lt_compat | apply Rinv_le_contravar ]; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ (d + n))) by lra.
  assert (q : Rabs (a' / (d + n')) <= 1). { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ (d + n'))) by (left; apply Rinv_0_lt_compat; lra). apply Rle_div_l; lra. }
  assert (s : Rabs (a - a' + a' / (d + n') * (n' - n)) <= 3 * D).
  { eapply Rle_trans; [ apply Rabs_triang | ]. rewrite Rabs_mult, (Rabs_minus_sym n' n). pose proof (Rabs_pos (n - n')). nra. }
  pose proof (Rabs_pos (a - a' + a' / (d + n') * (n' - n))). unfold Rdiv. apply Rle_trans with (3 * D * / d); [ | lra ]. apply Rmult_le_compat; lra.
Qed.
Definition field89 d i (v : place -> R) := match i with
  | px => v pu | py => v pw
  | pu => v px + 2 * v pw - v pu / (d + nrm (v pu) (v pw))
  | pw => v py - 2 * v pu - v pw / (d + nrm (v pu) (v pw)) end.
Lemma field89_lip d : 0 < d -> forall v v' D, (forall j, Rabs (v j - v' j) <= D) -> forall i, Rabs (field89 d i v - field89 d i v') <= (3 + 3 / d) * D.
Proof.
  intros Hd v v' D H. pose proof (H px) as Hx. pose proof (H py) as Hy. pose proof (H pu) as Hu. pose proof (H pw) as Hw.
  assert (D0 : 0 <= D) by (pose proof (Rabs_pos (v px - v' px)); lra). assert (d0 : 0 < 3 / d) by (apply Rdiv_lt_0_compat; lra).
  assert (M : Rabs (nrm (v pu) (v pw) - nrm (v' pu) (v' pw)) <= 2 * D) by (eapply Rle_trans; [ apply nrm_lip | lra ]).
  destruct (nrm_ge (v' pu) (v' pw)) as [g1 g2]. pose proof (nrm_pos (v pu) (v pw)) as n0.
  pose proof (ratio_lip d _ _ _ _ D Hd n0 g1 Hu M) as Ru. pose proof (ratio_lip d _ _ _ _ D Hd n0 g2 Hw M) as Rw.
  assert (0 <= 3 / d * D) by (apply Rmult_le_pos; lra).
  apply Rabs_le_between in Hx, Hy, Hu, Hw, Ru, Rw. intros i. apply Rabs_le. destruct i; simpl; lra.
Qed.
Lemma almost_field d u w : 0 < d -> almost d u w (- (u / (d + nrm u w))) (- (w / (d + nrm u w))).
Proof.
  intros Hd. pose proof (nrm_sq u w) as e. pose proof (nrm_pos u w). set (n := nrm u w) in *. split; fold n.
  - replace ((- (u / (d + n))) ^ 2 + (- (w / (d + n))) ^ 2) with (n ^ 2 / (d + n) ^ 2) by (rewrite e; field; lra). apply Rle_div_l; nra.
  - replace (- (u / (d + n)) * u + - (w / (d + n)) * w) with (- (n ^ 2 / (d + n))) by (rewrite e; field; lra). enough (n - d <= n ^ 2 / (d + n)) by lra. apply Rle_div_r; nra.
Qed.

Section Exist.
Variable c : place -> R.
Definition de (n : nat) := (/ 4) ^ n.
Lemma de_pos n : 0 < de n. Proof. apply pow_lt. lra. Qed.
Lemma de_sq n : de n = ((/ 2) ^ n) ^ 2.
Proof. unfold de. rewrite <- pow_mult, Nat.mul_comm, pow_mult. f_equal. field. Qed.
Lemma de_half n : de n <= (/ 2) ^ n.
Proof. rewrite de_sq. destruct (half_pos n). nra. Qed.
Lemma regular n : { f : place -> R -> R | (forall i, f i 0 = c i) /\ (forall i t, continuity_pt (f i) t) /\
  forall i t, 0 <= t -> is_derive (f i) t (field89 (de n) i (fun j => f j t)) }.
Proof.
  pose proof (de_pos n) as d0. apply (picard (field89 (de n)) (3 + 3 / de n)); [ | now apply field89_lip ]. assert (0 < 3 / de n) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.
Definition Z n := proj1_sig (regular n).
Lemma Z_spec n : (forall i, Z n i 0 = c i) /\ (forall i t, continuity_pt (Z n i) t) /\
  forall i t, 0 <= t -> is_derive (Z n i) t (field89 (de n) i (fun j => Z n j t)).
Proof. exact (proj2_sig (regular n)). Qed.
Lemma Z_near n : near (de n) (Z n px) (Z n py) (Z n pu) (Z n pw).
Proof.
  destruct (Z_spec n) as (_ & C & D). split. { intros; repeat split; apply C. } intros t Ht. split. { apply rder_of, (D px t Ht). } split. { apply rder_of, (D py t Ht). }
  eexists. eexists. split. apply (almost_field (de n)), de_pos. split; (eapply rder_eq; [ apply rder_of | ]). apply (D pu t Ht). simpl. ring. apply (D pw t Ht). simpl. ring.
Qed.
Lemma Z_step n i t : 0 <= t -> Rabs (Z (S n) i t - Z n i t) <= 4 * exp t / 2 * (/ 2) ^ n.
Proof.
  intros Ht. pose proof (near_apart _ _ _ _ _ _ _ _ _ _ (Z_near (S n)) (Z_near n) 0 t ltac:(lra)) as H.
  destruct (Z_spec n) as (I & _). destruct (Z_spec (S n)) as (J & _). rewrite !I, !J in H. rewrite Rmult_0_r, exp_0 in H.
  assert (q0 : 0 < exp t) by apply exp_pos. assert (e : exp (- (2) * t) * exp t ^ 2 = 1). { replace (exp t ^ 2) with (exp t * exp t) by ring. rewrite <- !exp_plus. replace (- (2) * t + (t + t)) with 0 by ring. apply exp_0. }
  assert (d1 : de (S n) = de n / 4) by (unfold de; simpl; field). pose proof (de_pos n) as d0. destruct (half_pos n) as [h0 h1].
  set (D := (Z (S n) px t - Z n px t) ^ 2 + (Z (S n) py t - Z n py t) ^ 2 + (Z (S n) pu t - Z n pu t) ^ 2 + (Z (S n) pw t - Z n pw t) ^ 2) in *.
  apply (Rmult_le_compat_r (exp t ^ 2)) in H; [ | nra ]. rewrite Rmult_assoc, e in H.
  assert (K : D <= (4 * exp t / 2 * (/ 2) ^ n) ^ 2). { replace ((4 * exp t / 2 * (/ 2) ^ n) ^ 2) with (4 * exp t ^ 2 * de n) by (rewrite de_sq; field). rewrite d1 in H. pose proof (Rmult_lt_0_compat _ _ d0 (pow_lt _ 2 q0)). nra. }
  apply abs_of_sq. { apply Rmult_le_pos; lra. } unfold D in K.
  pose proof (pow2_ge_0 (Z (S n) px t - Z n px t)). pose proof (pow2_ge_0 (Z (S n) py t - Z n py t)). pose proof (pow2_ge_0 (Z (S n) pu t - Z n pu t)). pose proof (pow2_ge_0 (Z (S n) pw t - Z n pw t)).
  destruct i; lra.
Qed.
(* the limit: it is the motion *)
Definition V i t := proj1_sig (lim_geo (fun n => Z n i (Rmax 0 t)) (4 * exp (Rmax 0 t)) (fun n => Z_step n i (Rmax 0 t) (Rmax_l 0 t))).
Lemma V_close n i t : Rabs (Z n i (Rmax 0 t) - V i t) <= 4 * exp (Rmax 0 t) * (/ 2) ^ n.
Proof. unfold V. destruct (lim_geo _ _ _) as [l Hl]. apply Hl. Qed.
Lemma V_uniform n i s : 0 <= s -> (Z n i s - V i s) ^ 2 <= 16 * exp s ^ 2 * (/ 2) ^ n.
Proof.
  intros Hs. pose proof (V_close n i s) as H. rewrite (Rmax_right 0 s) in H by lra. rewrite <- pow2_abs. pose proof (Rabs_pos (Z n i s - V i s)). pose proof (exp_pos s). destruct (half_pos n).
  apply Rle_trans with ((4 * exp s * (/ 2) ^ n) ^ 2). apply pow_incr; lra. replace ((4 * exp s * (/ 2) ^ n) ^ 2) with (16 * exp s ^ 2 * ((/ 2) ^ n) ^ 2) by ring.
  apply Rmult_le_compat_l; nra.
Qed.
Lemma V_0 i : V i 0 = c i.
Proof.
  assert (Q : (c i - V i 0) ^ 2 <= 0). { apply (le_by_halves _ _ (16 * exp 0 ^ 2)). intros n. rewrite Rplus_0_l, <- (proj1 (Z_spec n)). apply V_uniform. lra. } nra.
Qed.
Lemma V_cont i t : continuity_pt (V i) t.
Proof. apply (cont_limit (fun n => Z n i) (V i) 4 1 t); [ lra | intros n; apply (Z_spec n) | intros n s; rewrite Rmult_1_l; apply V_close ]. Qed.
(* friction that is right at t, and loses only h^2 along the straight line from there, gives the rates at t *)
Lemma V_rates t fx fy C : 0 <= t -> fx ^ 2 + fy ^ 2 <= 1 ->
  (forall h, 0 <= h <= 1 -> let a := V pu t + h * (V px t + 2 * V pw t + fx) in let b := V pw t + h * (V py t - 2 * V pu t + fy) in nrm a b + (fx * a + fy * b) <= C * h ^ 2) ->
  rder (V px) t (V pu t) /\ rder (V py) t (V pw t) /\ rder (V pu) t (V px t + 2 * V pw t + fx) /\ rder (V pw) t (V py t - 2 * V pu t + fy).
Proof.
  intros Ht hf hC. set (K := bend (V px t) (V py t) (V pu t) (V pw t) fx fy C). pose proof (bend_pos (V px t) (V py t) (V pu t) (V pw t) fx fy C hf hC) as K0. fold K in K0.
  pose proof (exp_pos 3) as e3. assert (rate : forall i l, (forall n h, 0 <= h <= 1 ->
    (Z n i (t + h) - (V i t + h * l)) ^ 2 <= gap t (V px t) (V py t) (V pu t) (V pw t) fx fy (Z n px) (Z n py) (Z n pu) (Z n pw) (t + h)) -> rder (V i) t l).
  { intros i l H. apply (rder_cube _ _ _ (2 * (exp 3 * K))). nra. intros h Hh. apply (le_by_halves _ _ (32 * exp (t + h) ^ 2 + 2 * exp 3 * (64 * exp t ^ 2 + 2))). intros n.
    specialize (H n h Hh). pose proof (follow (de n) t _ _ _ _ fx fy C _ _ _ _ (Z_near n) (Rlt_le _ _ (de_pos n)) Ht hf hC h Hh) as F. fold K in F.
    pose proof (V_uniform n i (t + h) ltac:(lra)) as Q. pose proof (de_half n) as d1. destruct (half_pos n) as [h0 _].
    assert (G : gap t (V px t) (V py t) (V pu t) (V pw t) fx fy (Z n px) (Z n py) (Z n pu) (Z n pw) t <= 64 * exp t ^ 2 * (/ 2) ^ n).
    { unfold gap. rewrite Rminus_eq_0, !Rmult_0_l, !Rplus_0_r. pose proof (V_uniform n px t Ht). pose proof (V_uniform n py t Ht). pose proof (V_uniform n pu t Ht). pose proof (V_uniform n pw t Ht). lra. }
    set (z := Z n i (t + h)) in *. set (v := V i (t + h)) in *. set (r := V i t + h * l) in *.
    assert (M : (v - r) ^ 2 <= 2 * (z - v) ^ 2 + 2 * (z - r) ^ 2) by (pose proof (pow2_ge_0 (2 * z - v - r)); lra).
    set (g := gap _ _ _ _ _ _ _ _ _ _ _ (t + h)) in *. set (g0 := gap _ _ _ _ _ _ _ _ _ _ _ t) in *.
    assert (F2 : g <= exp 3 * (64 * exp t ^ 2 * (/ 2) ^ n + 2 * (/ 2) ^ n + K * h ^ 3)). { eapply Rle_trans; [ exact F | ]. apply Rmult_le_compat_l; lra. }
    lra. }
  assert (G : forall n h, gap t (V px t) (V py t) (V pu t) (V pw t) fx fy (Z n px) (Z n py) (Z n pu) (Z n pw) (t + h) =
    (Z n px (t + h) - (V px t + h * V pu t)) ^ 2 + (Z n py (t + h) - (V py t + h * V pw t)) ^ 2 + (Z n pu (t + h) - (V pu t + h * (V px t + 2 * V pw t + fx))) ^ 2 +
    (Z n pw (t + h) - (V pw t + h * (V py t - 2 * V pu t + fy))) ^ 2). { intros n h. unfold gap. now replace (t + h - t) with h by ring. }
  repeat split; apply rate; intros n h Hh; rewrite G;
  pose proof (pow2_ge_0 (Z n px (t + h) - (V px t + h * V pu t))); pose proof (pow2_ge_0 (Z n py (t + h) - (V py t + h * V pw t)));
  pose proof (pow2_ge_0 (Z n pu (t + h) - (V pu t + h * (V px t + 2 * V pw t + fx)))); pose proof (pow2_ge_0 (Z n pw (t + h) - (V pw t + h * (V py t - 2 * V pu t + fy)))); lra.
Qed.
Lemma V_spin : spin (V px) (V py) (V pu) (V pw).
Proof.
  split; try (intros; apply V_cont). intros t Ht. set (x0 := V px t). set (y0 := V py t). set (u0 := V pu t). set (w0 := V pw t).
  enough (exists fx fy C, coulomb 1 u0 w0 fx fy /\ forall h, 0 <= h <= 1 -> let a := u0 + h * (x0 + 2 * w0 + fx) in let b := w0 + h * (y0 - 2 * u0 + fy) in nrm a b + (fx * a + fy * b) <= C * h ^ 2) as (fx & fy & C & F & H).
  { pose proof F as [F1 _]. destruct (V_rates t fx fy C Ht ltac:(lra) H) as (X & Y & U & W). split; [ exact X | split; [ exact Y | ] ]. exists fx, fy. auto. }
  pose proof (nrm_sq u0 w0) as pp. pose proof (nrm_sq x0 y0) as rr. destruct (nrm_pos u0 w0) as [P | z].
  - (* it slips *)
    set (p := nrm u0 w0) in *. set (fx := - (1) * u0 / p). set (fy := - (1) * w0 / p). set (ax := x0 + 2 * w0 + fx). set (ay := y0 - 2 * u0 + fy).
    exists fx, fy, ((ax ^ 2 + ay ^ 2) / p). split. { apply coulomb_iff. lra. right. fold p. split; [ lra | auto ]. }
    intros h Hh a b. pose proof (nrm_sq ax ay) as aa. pose proof (nrm_pos ax ay) as a0. set (M := nrm ax ay) in *. set (q := (u0 * ax + w0 * ay) / p).
    assert (fL : fx * a + fy * b = - (p + h * q)). { unfold fx, fy, a, b, q. fold ax. fold ay. apply (Rmult_eq_reg_l p); [ | lra ]. field_simplify; [ | lra | lra ]. rewrite pp. ring. }
    pose proof (power_bound p u0 w0 ax ay (Rlt_le _ _ P) ltac:(lra)) as Q. fold M in Q. rewrite fL, <- aa.
    set (g := p + h * q + h ^ 2 * M ^ 2 / p). enough (nrm a b <= g) by (unfold g in *; lra).
    assert (pq : p * q = u0 * ax + w0 * ay) by (unfold q; field; lra).
    assert (g0 : 0 <= g). { apply (Rmult_le_reg_l p); trivial. unfold g. replace (p * (p + h * q + h ^ 2 * M ^ 2 / p)) with (p ^ 2 + h * (p * q) + h ^ 2 * M ^ 2) by (field; lra). rewrite pq. assert (h * - (p * M) <= h * (u0 * ax + w0 * ay)) by (apply Rmult_le_compat_l; lra). nra. }
    unfold nrm. rewrite <- (sqrt_pow2 g) by trivial. apply sqrt_le_1_alt.
    replace (a ^ 2 + b ^ 2) with (p ^ 2 + 2 * h * (p * q) + h ^ 2 * M ^ 2) by (rewrite pp, pq, aa; unfold a, b; fold ax; fold ay; ring).
    enough (g ^ 2 - (p ^ 2 + 2 * h * (p * q) + h ^ 2 * M ^ 2) = h ^ 2 * ((q + h * M ^ 2 / p) ^ 2 + M ^ 2)) by (pose proof (Rmult_le_pos _ _ (pow2_ge_0 h) (Rplus_le_le_0_compat _ _ (pow2_ge_0 (q + h * M ^ 2 / p)) (pow2_ge_0 M))); lra).
    unfold g. field. lra.
  - symmetry in z. destruct (stops u0 w0 z) as [z1 z2]. destruct (Rle_lt_dec (nrm x0 y0) 1) as [r1 | r1]; pose proof (nrm_pos x0 y0); set (r := nrm x0 y0) in *.
    + (* it rests *) exists (- x0), (- y0), 0. split. { split. nra. rewrite z, z1, z2. ring. } intros h Hh a b. unfold a, b. rewrite z1, z2.
      replace (0 + h * (x0 + 2 * 0 + - x0)) with 0 by ring. replace (0 + h * (y0 - 2 * 0 + - y0)) with 0 by ring. rewrite nrm_x0; lra.
    + (* it is put down outside rho = 1 *) exists (- (x0 / r)), (- (y0 / r)), 0. split. { split; [ | rewrite z, z1, z2; ring ]. right. replace ((- (x0 / r)) ^ 2 + (- (y0 / r)) ^ 2) with ((x0 ^ 2 + y0 ^ 2) / r ^ 2) by (field; lra). rewrite <- rr. field. lra. }
      intros h Hh a b. unfold a, b. rewrite z1, z2. set (k := h * (1 - / r)). assert (k0 : 0 <= k). { apply Rmult_le_pos; [ lra | ]. assert (/ r < / 1) by (apply Rinv_lt_contravar; lra). lra. }
      replace (0 + h * (x0 + 2 * 0 + - (x0 / r))) with (k * x0) by (unfold k; field; lra). replace (0 + h * (y0 - 2 * 0 + - (y0 / r))) with (k * y0) by (unfold k; field; lra).
      rewrite nrm_scale by trivial. fold r. replace (- (x0 / r) * (k * x0) + - (y0 / r) * (k * y0)) with (- (k * ((x0 ^ 2 + y0 ^ 2) / r))) by (field; lra). rewrite <- rr. right. field. lra.
Qed.
End Exist.

(* every start has a motion ... *)
Theorem table_exists x0 y0 u0 w0 : exists x y u w, spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0.
Proof.
  set (c i := match i with px => x0 | py => y0 | pu => u0 | pw => w0 end).
  exists (V c px), (V c py), (V c pu), (V c pw). split. apply V_spin. rewrite !V_0. auto.
Qed.
(* ... and one only *)
Theorem table_one_motion x0 y0 u0 w0 : exists x y u w, (spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0) /\
  forall x' y' u' w', spin x' y' u' w' -> x' 0 = x0 -> y' 0 = y0 -> u' 0 = u0 -> w' 0 = w0 ->
  forall t, 0 <= t -> x' t = x t /\ y' t = y t /\ u' t = u t /\ w' t = w t.
Proof.
  destruct (table_exists x0 y0 u0 w0) as (x & y & u & w & S & e1 & e2 & e3 & e4). exists x, y, u, w. split; auto.
  intros x' y' u' w' S' f1 f2 f3 f4 t Ht. pose proof (near_apart _ _ _ _ _ _ _ _ _ _ (spin_near _ _ _ _ S') (spin_near _ _ _ _ S) 0 t ltac:(lra)) as H.
  rewrite e1, e2, e3, e4, f1, f2, f3, f4, !Rminus_eq_0 in H. pose proof (exp_pos (- (2) * t)).
  pose proof (pow2_ge_0 (x' t - x t)). pose proof (pow2_ge_0 (y' t - y t)). pose proof (pow2_ge_0 (u' t - u t)). pose proof (pow2_ge_0 (w' t - w t)).
  assert (D : (x' t - x t) ^ 2 + (y' t - y t) ^ 2 + (u' t - u t) ^ 2 + (w' t - w t) ^ 2 + (0 + 0) <= 0).
  { apply (Rmult_le_reg_r (exp (- (2) * t))); trivial. eapply Rle_trans; [ exact H | right; ring ]. } repeat split; nra.
Qed.
(* with dimensions, for every rate of turning and every friction *)
Theorem turntable_exists Om k x0 y0 u0 w0 : Om <> 0 -> 0 < k -> exists x y u w, turntable Om k x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0.
Proof.
  assert (pos : forall Om y0 w0, 0 < Om -> 0 < k -> exists x y u w, turntable Om k x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0).
  { clear. intros Om y0 w0 HO Hk. destruct (table_exists (Om ^ 2 / k * x0) (Om ^ 2 / k * y0) (Om / k * u0) (Om / k * w0)) as (x & y & u & w & S & e1 & e2 & e3 & e4).
    exists (fun t => k / Om ^ 2 * x (Om * t)), (fun t => k / Om ^ 2 * y (Om * t)), (fun t => k / Om * u (Om * t)), (fun t => k / Om * w (Om * t)). split.
    - apply (units Om k _ _ _ _ x y u w HO Hk); trivial; intros t; field; lra.
    - rewrite Rmult_0_r, e1, e2, e3, e4. repeat split; field; lra. }
  intros HO Hk. destruct (Rlt_dec 0 Om) as [h | h]. { now apply pos. }
  destruct (pos (- Om) (- y0) (- w0)) as (x & y & u & w & S & e1 & e2 & e3 & e4); try lra. apply mirrored in S. rewrite Ropp_involutive in S.
  exists x, (fun t => - y t), u, (fun t => - w t). rewrite e2, e4. repeat split; trivial; try apply S; lra.
Qed.
