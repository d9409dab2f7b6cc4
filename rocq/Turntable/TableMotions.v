(* From every place and velocity there is one motion on the table, slipping or at rest. Motions whose friction loses at most d of its power stay close
   (near_apart); they exist (Picard, with the direction of the slip made Lipschitz); for d = 4^-n they converge, and the limit has the right rates (follow) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion TableLaws Picard.
Open Scope R_scope.

Definition almost d ux uy fx fy := fx ^ 2 + fy ^ 2 <= 1 /\ fx * ux + fy * uy <= d - nrm ux uy.
Record near d (f : place -> R -> R) : Prop := {
  n_c : forall i t, 0 < t -> continuity_pt (f i) t;
  n_law : forall t, 0 <= t -> rder (f px) t (f pu t) /\ rder (f py) t (f pw t) /\ exists fx fy, almost d (f pu t) (f pw t) fx fy /\
            rder (f pu) t (f px t + 2 * f pw t + fx) /\ rder (f pw) t (f py t - 2 * f pu t + fy) }.
Definition state (x y u w : R -> R) i := match i with px => x | py => y | pu => u | pw => w end.
Lemma spin_near x y u w : spin x y u w -> near 0 (state x y u w).
Proof.
  intros S. split. { intros i t Ht. destruct i; [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; trivial. }
  intros t Ht. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & [B P] & U & W). split; trivial. split; trivial. exists fx, fy. split; [ split; simpl; lra | auto ].
Qed.
(* the squared distance of two motions *)
Definition far (f g : place -> R -> R) t := (f px t - g px t) ^ 2 + (f py t - g py t) ^ 2 + (f pu t - g pu t) ^ 2 + (f pw t - g pw t) ^ 2.
Lemma far_ge f g i t : 0 <= (f i t - g i t) ^ 2 <= far f g t.
Proof.
  unfold far. pose proof (pow2_ge_0 (f px t - g px t)). pose proof (pow2_ge_0 (f py t - g py t)). pose proof (pow2_ge_0 (f pu t - g pu t)). pose proof (pow2_ge_0 (f pw t - g pw t)).
  destruct i; lra.
Qed.
Lemma near_apart d1 d2 f g s t : near d1 f -> near d2 g -> 0 <= s <= t -> (far f g t + (d1 + d2)) * exp (- (2) * t) <= (far f g s + (d1 + d2)) * exp (- (2) * s).
Proof.
  intros S1 S2 Hst. apply (rder_decr (fun t => (far f g t + (d1 + d2)) * exp (- (2) * t))); [ lra | | ]; intros r Hr; unfold far.
  - pose proof (fun i => n_c _ _ S1 i r ltac:(lra)). pose proof (fun i => n_c _ _ S2 i r ltac:(lra)). cont.
  - destruct (n_law _ _ S1 r) as (X1 & Y1 & f1 & g1 & [B1 P1] & U1 & W1); [ lra | ].
    destruct (n_law _ _ S2 r) as (X2 & Y2 & f2 & g2 & [B2 P2] & U2 & W2); [ lra | ].
    eexists. split. rd. cbv beta. simpl pred. simpl INR. set (e := exp _). assert (e0 : 0 < e) by apply exp_pos.
    pose proof (power_bound 1 f2 g2 (f pu r) (f pw r) Rle_0_1 ltac:(lra)). pose proof (power_bound 1 f1 g1 (g pu r) (g pw r) Rle_0_1 ltac:(lra)).
    pose proof (pow2_ge_0 (f px r - g px r - (f pu r - g pu r))). pose proof (pow2_ge_0 (f py r - g py r - (f pw r - g pw r))).
    match goal with |- ?a * e + ?d * (?c * e) <= 0 => assert (a + d * c <= 0); [ | nra ] end. lra.
Qed.

(* A motion, almost, against the straight line from a state v with the friction (fx, fy) there: they part as h^3, if that friction loses h^2 at most along the line *)
Definition rate (v : place -> R) fx fy i := match i with px => v pu | py => v pw | pu => v px + 2 * v pw + fx | pw => v py - 2 * v pu + fy end.
Section Follow.
Variables (d t fx fy C : R) (v : place -> R) (f : place -> R -> R).
Notation a i := (rate v fx fy i).
Definition line i s := v i + (s - t) * a i.
Definition bend := a pu ^ 2 + a pw ^ 2 + (v pu + 2 * a pw) ^ 2 + (v pw - 2 * a pu) ^ 2 + 2 * C.
Hypothesis S : near d f.
Hypothesis hd : 0 <= d.
Hypothesis ht : 0 <= t.
Hypothesis hf : fx ^ 2 + fy ^ 2 <= 1.
Hypothesis hC : forall h, 0 <= h <= 1 -> nrm (v pu + h * a pu) (v pw + h * a pw) + (fx * (v pu + h * a pu) + fy * (v pw + h * a pw)) <= C * h ^ 2.

Lemma bend_pos : 0 <= bend.
Proof.
  pose proof (hC 1 ltac:(lra)) as H. pose proof (power_bound 1 fx fy (v pu + 1 * a pu) (v pw + 1 * a pw) Rle_0_1 ltac:(lra)). unfold bend.
  pose proof (pow2_ge_0 (a pu)). pose proof (pow2_ge_0 (a pw)). pose proof (pow2_ge_0 (v pu + 2 * a pw)). pose proof (pow2_ge_0 (v pw - 2 * a pu)). lra.
Qed.
Lemma follow h : 0 <= h <= 1 -> far f line (t + h) <= exp 3 * (far f line t + 2 * d + bend * h ^ 3).
Proof.
  intros Hh. pose proof bend_pos as b0. set (K := bend) in *.
  set (G s := far f line s * exp (- (3) * (s - t)) - 2 * d * (s - t) - K * / 3 * (s - t) ^ 3).
  assert (M : G (t + h) <= G t).
  { apply (rder_decr G); [ lra | | ]; intros s Hs; unfold G, far, line.
    - pose proof (fun i => n_c _ _ S i s ltac:(lra)). cont.
    - destruct (n_law _ _ S s ltac:(lra)) as (X & Y & gx & gy & [B P] & U & W). eexists. split. rd. cbv beta. simpl pred. simpl INR.
      set (e := exp (- (3) * (s - t))). assert (e0 : 0 < e <= 1). { split. apply exp_pos. rewrite <- exp_0. apply exp_up. lra. }
      set (m := s - t) in *. assert (m0 : 0 <= m <= 1) by (unfold m; lra). specialize (hC m m0).
      set (dx := f px s - (v px + m * a px)) in *. set (dy := f py s - (v py + m * a py)) in *. set (du := f pu s - (v pu + m * a pu)) in *. set (dw := f pw s - (v pw + m * a pw)) in *.
      pose proof (power_bound 1 gx gy (v pu + m * a pu) (v pw + m * a pw) Rle_0_1 ltac:(lra)) as Q1. pose proof (power_bound 1 fx fy (f pu s) (f pw s) Rle_0_1 ltac:(lra)) as Q2.
      assert (Q3 : (gx - fx) * du + (gy - fy) * dw <= d + C * m ^ 2) by (unfold du, dw; lra).
      set (D := dx ^ 2 + dy ^ 2 + du ^ 2 + dw ^ 2) in *.
      set (T := 2 * dx * (du + m * a pu) + 2 * dy * (dw + m * a pw) + 2 * du * (dx + 2 * dw + m * (v pu + 2 * a pw) + (gx - fx)) + 2 * dw * (dy - 2 * du + m * (v pw - 2 * a pu) + (gy - fy))).
      assert (main : T <= 3 * D + (2 * d + K * m ^ 2)).
      { pose proof (pow2_ge_0 (dx - m * a pu)). pose proof (pow2_ge_0 (dy - m * a pw)). pose proof (pow2_ge_0 (du - m * (v pu + 2 * a pw))). pose proof (pow2_ge_0 (dw - m * (v pw - 2 * a pu))).
        pose proof (pow2_ge_0 (dx - du)). pose proof (pow2_ge_0 (dy - dw)). unfold T, D, K, bend. lra. }
      assert (c0 : 0 <= 2 * d + K * m ^ 2). { pose proof (Rmult_le_pos _ _ b0 (pow2_ge_0 m)). lra. }
      match goal with |- ?g <= 0 => replace g with ((T - 3 * D) * e - (2 * d + K * m ^ 2)) end. nra.
      unfold T, D, dx, dy, du, dw. simpl. field. }
  unfold G in M. replace (t + h - t) with h in M by ring. rewrite Rminus_eq_0, Rmult_0_r, exp_0 in M.
  assert (e1 : exp (- (3) * h) * exp (3 * h) = 1) by (rewrite <- exp_plus; replace (- (3) * h + 3 * h) with 0 by ring; apply exp_0).
  assert (e2 : exp (3 * h) <= exp 3) by (apply exp_up; lra). pose proof (exp_pos (3 * h)). pose proof (far_ge f line px t).
  assert (h3 : 0 <= K * h ^ 3) by (apply Rmult_le_pos; [ trivial | apply pow_le; lra ]).
  assert (M2 : far f line (t + h) * exp (- (3) * h) <= far f line t + 2 * d + K * h ^ 3) by nra.
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
Lemma Z_near n : near (de n) (Z n).
Proof.
  destruct (Z_spec n) as (_ & C & D). split. { intros; apply C. } intros t Ht. split. { apply rder_of, (D px t Ht). } split. { apply rder_of, (D py t Ht). }
  eexists. eexists. split. apply (almost_field (de n)), de_pos. split; (eapply rder_eq; [ apply rder_of | ]). apply (D pu t Ht). simpl. ring. apply (D pw t Ht). simpl. ring.
Qed.
Lemma Z_step n i t : 0 <= t -> Rabs (Z (S n) i t - Z n i t) <= 4 * exp t / 2 * (/ 2) ^ n.
Proof.
  intros Ht. pose proof (near_apart _ _ _ _ 0 t (Z_near (S n)) (Z_near n) ltac:(lra)) as H.
  assert (z : far (Z (S n)) (Z n) 0 = 0) by (unfold far; rewrite !(proj1 (Z_spec _)); ring). rewrite z, Rmult_0_r, exp_0 in H.
  assert (q0 : 0 < exp t) by apply exp_pos. assert (e : exp (- (2) * t) * exp t ^ 2 = 1). { replace (exp t ^ 2) with (exp t * exp t) by ring. rewrite <- !exp_plus. replace (- (2) * t + (t + t)) with 0 by ring. apply exp_0. }
  assert (d1 : de (S n) = de n / 4) by (unfold de; simpl; field). pose proof (de_pos n) as d0. destruct (half_pos n) as [h0 h1]. pose proof (far_ge (Z (S n)) (Z n) i t) as D.
  apply (Rmult_le_compat_r (exp t ^ 2)) in H; [ | nra ]. rewrite Rmult_assoc, e in H. apply abs_of_sq. { apply Rmult_le_pos; lra. }
  replace ((4 * exp t / 2 * (/ 2) ^ n) ^ 2) with (4 * exp t ^ 2 * de n) by (rewrite de_sq; field). rewrite d1 in H. pose proof (Rmult_lt_0_compat _ _ d0 (pow_lt _ 2 q0)). nra.
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
Lemma V_rates t fx fy C : let v i := V i t in let a := rate v fx fy in 0 <= t -> fx ^ 2 + fy ^ 2 <= 1 ->
  (forall h, 0 <= h <= 1 -> nrm (v pu + h * a pu) (v pw + h * a pw) + (fx * (v pu + h * a pu) + fy * (v pw + h * a pw)) <= C * h ^ 2) -> forall i, rder (V i) t (a i).
Proof.
  intros v a Ht hf hC i. set (K := bend fx fy C v). pose proof (bend_pos fx fy C v hf hC) as K0. fold K in K0. pose proof (exp_pos 3) as e3.
  apply (rder_cube _ _ _ (2 * (exp 3 * K))). nra. intros h Hh. apply (le_by_halves _ _ (32 * exp (t + h) ^ 2 + 2 * exp 3 * (64 * exp t ^ 2 + 2))). intros n.
  pose proof (follow (de n) t fx fy C v _ (Z_near n) (Rlt_le _ _ (de_pos n)) Ht hf hC h Hh) as F. fold K in F. set (l := line t fx fy v) in *.
  pose proof (far_ge (Z n) l i (t + h)) as H. pose proof (V_uniform n i (t + h) ltac:(lra)) as Q. pose proof (de_half n) as d1. destruct (half_pos n) as [h0 _].
  assert (G : far (Z n) l t <= 64 * exp t ^ 2 * (/ 2) ^ n).
  { unfold far, l, line. rewrite Rminus_eq_0, !Rmult_0_l, !Rplus_0_r. pose proof (V_uniform n px t Ht). pose proof (V_uniform n py t Ht). pose proof (V_uniform n pu t Ht). pose proof (V_uniform n pw t Ht). unfold v. lra. }
  replace (V i t + h * a i) with (l i (t + h)) by (unfold l, line; fold a; replace (t + h - t) with h by ring; reflexivity).
  set (z := Z n i (t + h)) in *. set (r := V i (t + h)) in *. assert (M : (r - l i (t + h)) ^ 2 <= 2 * (z - r) ^ 2 + 2 * (z - l i (t + h)) ^ 2) by (pose proof (pow2_ge_0 (2 * z - r - l i (t + h))); lra).
  assert (F2 : far (Z n) l (t + h) <= exp 3 * (64 * exp t ^ 2 * (/ 2) ^ n + 2 * (/ 2) ^ n + K * h ^ 3)). { eapply Rle_trans; [ exact F | ]. apply Rmult_le_compat_l; lra. }
  lra.
Qed.
Lemma V_spin : spin (V px) (V py) (V pu) (V pw).
Proof.
  split; try (intros; apply V_cont). intros t Ht. set (v i := V i t).
  enough (exists fx fy C, coulomb 1 (v pu) (v pw) fx fy /\ forall h, 0 <= h <= 1 -> let b i := v i + h * rate v fx fy i in nrm (b pu) (b pw) + (fx * b pu + fy * b pw) <= C * h ^ 2) as (fx & fy & C & F & H).
  { pose proof F as [F1 _]. pose proof (V_rates t fx fy C Ht ltac:(lra) H) as R. split; [ exact (R px) | split; [ exact (R py) | ] ]. exists fx, fy. split; [ exact F | split; [ exact (R pu) | exact (R pw) ] ]. }
  set (x0 := v px). set (y0 := v py). set (u0 := v pu). set (w0 := v pw). pose proof (nrm_sq u0 w0) as pp. pose proof (nrm_sq x0 y0) as rr. destruct (nrm_pos u0 w0) as [P | z].
  - (* it slips *)
    set (p := nrm u0 w0) in *. set (fx := - (1) * u0 / p). set (fy := - (1) * w0 / p). set (ax := rate v fx fy pu). set (ay := rate v fx fy pw).
    exists fx, fy, ((ax ^ 2 + ay ^ 2) / p). split. { apply coulomb_iff. lra. right. fold p. split; [ lra | auto ]. }
    intros h Hh b. change (b pu) with (u0 + h * ax). change (b pw) with (w0 + h * ay). pose proof (nrm_sq ax ay) as aa. pose proof (nrm_pos ax ay) as a0. set (M := nrm ax ay) in *. set (q := (u0 * ax + w0 * ay) / p).
    assert (fL : fx * (u0 + h * ax) + fy * (w0 + h * ay) = - (p + h * q)). { unfold fx, fy, q. apply (Rmult_eq_reg_l p); [ | lra ]. field_simplify; [ | lra | lra ]. rewrite pp. ring. }
    pose proof (power_bound p u0 w0 ax ay (Rlt_le _ _ P) ltac:(lra)) as Q. fold M in Q. rewrite fL, <- aa.
    set (g := p + h * q + h ^ 2 * M ^ 2 / p). enough (nrm (u0 + h * ax) (w0 + h * ay) <= g) by (unfold g in *; lra).
    assert (pq : p * q = u0 * ax + w0 * ay) by (unfold q; field; lra).
    assert (g0 : 0 <= g). { apply (Rmult_le_reg_l p); trivial. unfold g. replace (p * (p + h * q + h ^ 2 * M ^ 2 / p)) with (p ^ 2 + h * (p * q) + h ^ 2 * M ^ 2) by (field; lra). rewrite pq. assert (h * - (p * M) <= h * (u0 * ax + w0 * ay)) by (apply Rmult_le_compat_l; lra). nra. }
    unfold nrm. rewrite <- (sqrt_pow2 g) by trivial. apply sqrt_le_1_alt.
    replace ((u0 + h * ax) ^ 2 + (w0 + h * ay) ^ 2) with (p ^ 2 + 2 * h * (p * q) + h ^ 2 * M ^ 2) by (rewrite pp, pq, aa; ring).
    enough (g ^ 2 - (p ^ 2 + 2 * h * (p * q) + h ^ 2 * M ^ 2) = h ^ 2 * ((q + h * M ^ 2 / p) ^ 2 + M ^ 2)) by (pose proof (Rmult_le_pos _ _ (pow2_ge_0 h) (Rplus_le_le_0_compat _ _ (pow2_ge_0 (q + h * M ^ 2 / p)) (pow2_ge_0 M))); lra).
    unfold g. field. lra.
  - (* it stands: with friction against its place, as much as there is of it up to 1 *)
    symmetry in z. destruct (stops u0 w0 z) as [z1 z2]. pose proof (nrm_pos x0 y0). set (r := nrm x0 y0) in *. pose proof (Rmax_l 1 r). pose proof (Rmax_r 1 r). set (m := Rmax 1 r) in *.
    exists (- (x0 / m)), (- (y0 / m)), 0. split. { split; [ | rewrite z, z1, z2; ring ]. replace ((- (x0 / m)) ^ 2 + (- (y0 / m)) ^ 2) with (r ^ 2 / m ^ 2) by (rewrite rr; field; lra). apply Rle_div_l; nra. }
    intros h Hh b. set (k := h * (1 - / m)). assert (k0 : 0 <= k). { apply Rmult_le_pos; [ lra | ]. assert (/ m <= / 1) by (apply Rinv_le_contravar; lra). lra. }
    assert (b1 : b pu = k * x0) by (unfold b, rate, k; fold u0 w0 x0; rewrite z1, z2; field; lra). assert (b2 : b pw = k * y0) by (unfold b, rate, k; fold u0 w0 y0; rewrite z1, z2; field; lra).
    rewrite b1, b2, nrm_scale by trivial. fold r. replace (- (x0 / m) * (k * x0) + - (y0 / m) * (k * y0)) with (- (k * (r ^ 2 / m))) by (rewrite rr; field; lra).
    unfold k, m, Rmax. destruct Rle_dec; right; field; lra.
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
  intros x' y' u' w' S' f1 f2 f3 f4 t Ht. pose proof (near_apart _ _ _ _ 0 t (spin_near _ _ _ _ S') (spin_near _ _ _ _ S) ltac:(lra)) as H. set (f := state x' y' u' w') in *. set (g := state x y u w) in *.
  assert (z : far f g 0 = 0) by (unfold far, f, g; simpl; rewrite e1, e2, e3, e4, f1, f2, f3, f4; ring). rewrite z in H. assert (D : far f g t <= 0).
  { apply (Rmult_le_reg_r (exp (- (2) * t))). apply exp_pos. lra. }
  pose proof (far_ge f g px t). pose proof (far_ge f g py t). pose proof (far_ge f g pu t). pose proof (far_ge f g pw t). unfold f, g, state in *. repeat split; nra.
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
