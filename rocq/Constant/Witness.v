(* The constant pull has its motion from every start at an angle, for lambda <= 1: the theorems on it are not empty *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

Section Inverse.
Variables (F f : R -> R) (m : R).
Hypothesis hm : 0 < m.
Hypothesis dF : forall s, is_derive F s (f s).
Hypothesis low : forall s, m <= f s.
Hypothesis F0 : F 0 = 0.
Lemma F_up a b : a <= b -> m * (b - a) <= F b - F a.
Proof.
  intros [H | ->]; [ | lra ]. destruct (MVT_cor2 F f a b H) as (c & e & _). { intros; now apply is_derive_Reals. }
  rewrite e. apply Rmult_le_compat_r; [ lra | apply low ].
Qed.
Lemma F_cont : continuity F.
Proof. intros s. apply derivable_continuous_pt. exists (f s). apply is_derive_Reals, dF. Qed.
Definition inverse_sig (t : R) : { s : R | F s = t }.
Proof.
  assert (C : continuity (fun s => F s - t)) by (intros s; apply continuity_pt_minus; [ apply F_cont | apply continuity_pt_const; intros ? ?; reflexivity ]).
  pose proof (Rabs_pos t) as p. pose proof (Rle_abs t). pose proof (Rle_abs (- t)) as q. rewrite Rabs_Ropp in q.
  assert (0 <= Rabs t / m) by (apply Rmult_le_pos; [ trivial | left; now apply Rinv_0_lt_compat ]). assert (e : m * (Rabs t / m) = Rabs t) by (field; lra).
  destruct (IVT_cor (fun s => F s - t) (- (Rabs t / m)) (Rabs t / m) C) as [z [_ Hz]]; [ lra | | exists z; lra ].
  pose proof (F_up 0 (Rabs t / m) ltac:(lra)). pose proof (F_up (- (Rabs t / m)) 0 ltac:(lra)). rewrite F0 in *. nra.
Qed.
Definition G t := proj1_sig (inverse_sig t).
Lemma FG t : F (G t) = t. Proof. exact (proj2_sig (inverse_sig t)). Qed.
Lemma G_lip a b : Rabs (G b - G a) <= Rabs (b - a) / m.
Proof.
  apply Rle_div_r; trivial. rewrite <- (FG a), <- (FG b) at 2. destruct (Rle_lt_dec (G a) (G b)) as [k | k].
  - pose proof (F_up _ _ k). rewrite !Rabs_pos_eq; nra.
  - pose proof (F_up _ _ (Rlt_le _ _ k)). rewrite !Rabs_left1; nra.
Qed.
Lemma dG t : is_derive G t (/ f (G t)).
Proof.
  apply is_derive_Reals. intros e He. pose proof (low (G t)) as l0.
  assert (D := dF (G t)). apply is_derive_Reals in D. assert (em : 0 < e * m * m / 2) by (apply Rdiv_lt_0_compat; [ repeat apply Rmult_lt_0_compat | ]; lra). destruct (D _ em) as [d Hd]. 
  assert (dm : 0 < d * m) by (apply Rmult_lt_0_compat; [ apply cond_pos | trivial ]). exists (mkposreal _ dm). intros h h0 hh. simpl in hh.
  set (k := G (t + h) - G t). pose proof (G_lip t (t + h)) as L. replace (t + h - t) with h in L by ring. fold k in L.
  assert (eh : F (G t + k) - F (G t) = h). { unfold k. replace (G t + (G (t + h) - G t)) with (G (t + h)) by ring. rewrite !FG. ring. }
  assert (k0 : k <> 0). { intros z. rewrite z, Rplus_0_r in eh. apply h0. lra. }
  assert (kd : Rabs k < d). { apply Rle_lt_trans with (1 := L). apply Rlt_div_l; trivial. }
  specialize (Hd k k0 kd). rewrite eh in Hd. set (q := h / k) in *.
  assert (q0 : m <= q). { unfold q. destruct (Rle_lt_dec 0 k) as [p | p].
    - apply Rle_div_r; [ lra | ]. rewrite <- eh. pose proof (F_up (G t) (G t + k) ltac:(lra)). lra.
    - replace (h / k) with ((- h) / (- k)) by (field; trivial). apply Rle_div_r; [ lra | ]. rewrite <- eh. pose proof (F_up (G t + k) (G t) ltac:(lra)). lra. }
  replace (k / h - / f (G t)) with (- (q - f (G t)) * / (q * f (G t))) by (unfold q; field; repeat split; trivial; lra).
  rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; nra).
  apply Rle_lt_trans with (e * m * m / 2 * / (m * m)). 2: { replace (e * m * m / 2 * / (m * m)) with (e / 2) by (field; lra). lra. }
  apply Rmult_le_compat; [ apply Rabs_pos | left; apply Rinv_0_lt_compat; nra | lra | apply Rinv_le_contravar; nra ].
Qed.
End Inverse.

Section Pull.
Variables (A lam v0 c s0 : R).   (* c = cos (theta0 / 2), s0 = sin (theta0 / 2) *)
Hypothesis hA : 0 < A. Hypothesis hl : 0 <= lam <= 1. Hypothesis hv : 0 < v0. Hypothesis hc : 0 < c. Hypothesis hs : 0 < s0.
(* s = - ln (tan (theta / 2) / tan (theta0 / 2)) *)
Definition N s := v0 * (c ^ 2 * exp ((1 - lam) * s) + s0 ^ 2 * exp (- (1 + lam) * s)).
Definition X s := v0 * (c ^ 2 * exp ((1 - lam) * s) - s0 ^ 2 * exp (- (1 + lam) * s)).
Definition Y s := 2 * v0 * c * s0 * exp (- lam * s).
Lemma polar s : nrm (X s) (Y s) = N s /\ 0 < N s.
Proof.
  pose proof (exp_pos ((1 - lam) * s)). pose proof (exp_pos (- (1 + lam) * s)). assert (0 < c ^ 2) by nra. assert (0 < s0 ^ 2) by nra.
  assert (P : 0 < N s) by (unfold N; apply Rmult_lt_0_compat; nra). split; trivial. unfold nrm.
  replace (X s ^ 2 + Y s ^ 2) with (Rsqr (N s)). apply sqrt_Rsqr; lra.
  assert (E : exp (- lam * s) ^ 2 = exp ((1 - lam) * s) * exp (- (1 + lam) * s)) by (simpl; rewrite Rmult_1_r, <- !exp_plus; f_equal; ring).
  unfold X, Y, N, Rsqr. replace ((2 * v0 * c * s0 * exp (- lam * s)) ^ 2) with (4 * v0 ^ 2 * c ^ 2 * s0 ^ 2 * exp (- lam * s) ^ 2) by ring. rewrite E. ring.
Qed.
Let m := v0 * Rmin (c ^ 2) (s0 ^ 2) / A.
Lemma N_low s : m <= N s / A.
Proof.
  unfold m. apply Rmult_le_compat_r; [ left; now apply Rinv_0_lt_compat | ]. unfold N. apply Rmult_le_compat_l; [ lra | ].
  pose proof (exp_pos ((1 - lam) * s)). pose proof (exp_pos (- (1 + lam) * s)). assert (0 < c ^ 2) by nra. assert (0 < s0 ^ 2) by nra.
  pose proof (exp_ineq1_le ((1 - lam) * s)). pose proof (exp_ineq1_le (- (1 + lam) * s)). pose proof (Rmin_l (c ^ 2) (s0 ^ 2)). pose proof (Rmin_r (c ^ 2) (s0 ^ 2)).
  destruct (Rle_lt_dec 0 s).
  - assert (0 <= (1 - lam) * s) by nra. assert (c ^ 2 * 1 <= c ^ 2 * exp ((1 - lam) * s)) by (apply Rmult_le_compat_l; lra). nra.
  - assert (0 <= - (1 + lam) * s) by nra. assert (s0 ^ 2 * 1 <= s0 ^ 2 * exp (- (1 + lam) * s)) by (apply Rmult_le_compat_l; lra). nra.
Qed.
Theorem pull_has_a_motion : exists vx vy, motion (A * lam) (fun _ => - A) (fun _ => 0) vx vy /\
  vx 0 = v0 * (c ^ 2 - s0 ^ 2) /\ vy 0 = 2 * v0 * c * s0.
Proof.
  assert (hm : 0 < m). { unfold m. apply Rdiv_lt_0_compat; trivial. apply Rmult_lt_0_compat; trivial. apply Rmin_pos; nra. }
  assert (cN : forall s, continuous (fun s => N s / A) s). { intros s. apply (ex_derive_continuous (fun s => N s / A)). unfold N. auto_derive. lra. }
  set (F := fun s => RInt (fun s => N s / A) 0 s).
  assert (dF : forall s, is_derive F s (N s / A)).
  { intros s. apply (is_derive_RInt (fun s => N s / A) F 0 s); [ | apply cN ]. exists (mkposreal 1 Rlt_0_1). intros y _. exact (RInt_correct (fun s => N s / A) 0 y (ex_RInt_continuous (fun s => N s / A) 0 y (fun z _ => cN z))). }
  assert (F0 : F 0 = 0) by exact (RInt_point 0 (fun s => N s / A)).
  set (g := G F (fun s => N s / A) m hm dF N_low F0).
  assert (Dg : forall t, is_derive g t (A / N (g t))).
  { intros t. destruct (polar (g t)) as [_ p]. replace (A / N (g t)) with (/ (N (g t) / A)) by (field; lra). apply dG. }
  assert (g0 : g 0 = 0). { pose proof (FG F (fun s => N s / A) m hm dF N_low F0 0) as E. fold g in E.
    destruct (Rtotal_order (g 0) 0) as [k | [k | k]]; trivial; exfalso.
    pose proof (F_up F (fun s => N s / A) m dF N_low (g 0) 0 ltac:(lra)). rewrite E, F0 in *. nra.
    pose proof (F_up F (fun s => N s / A) m dF N_low 0 (g 0) ltac:(lra)). rewrite E, F0 in *. nra. }
  assert (DX : forall t, is_derive (fun t => X (g t)) t (A - A * lam * (X (g t) / N (g t)))).
  { intros t. destruct (polar (g t)) as [_ p]. replace (A - A * lam * (X (g t) / N (g t))) with (A / N (g t) * (N (g t) - lam * X (g t))) by (field; lra).
    apply (is_derive_comp X g); [ | apply Dg ]. unfold X, N. auto_derive; trivial. ring. }
  assert (DY : forall t, is_derive (fun t => Y (g t)) t (- A * lam * (Y (g t) / N (g t)))).
  { intros t. destruct (polar (g t)) as [_ p]. replace (- A * lam * (Y (g t) / N (g t))) with (A / N (g t) * (- lam * Y (g t))) by (field; lra).
    apply (is_derive_comp Y g); [ | apply Dg ]. unfold Y. auto_derive; trivial. ring. }
  exists (fun t => X (g t)), (fun t => Y (g t)). split; [ split | ].
  - intros t _. apply derivable_continuous_pt. eexists. apply is_derive_Reals, DX.
  - intros t _. apply derivable_continuous_pt. eexists. apply is_derive_Reals, DY.
  - intros t _. destruct (polar (g t)) as [e p]. exists (- (A * lam) * (X (g t) / N (g t))), (- (A * lam) * (Y (g t) / N (g t))). split; [ | split ].
    + apply coulomb_iff. nra. right. rewrite e. repeat split; [ lra | field; lra | field; lra ].
    + apply rder_of. replace (- (A * lam) * (X (g t) / N (g t)) - - A) with (A - A * lam * (X (g t) / N (g t))) by ring. apply DX.
    + apply rder_of. replace (- (A * lam) * (Y (g t) / N (g t)) - 0) with (- A * lam * (Y (g t) / N (g t))) by ring. apply DY.
  - rewrite g0. unfold X, Y. rewrite !Rmult_0_r, exp_0. split; ring.
Qed.
End Pull.
