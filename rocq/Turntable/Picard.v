(* An equation in four unknowns with a Lipschitz right side has a solution for all t >= 0 (Picard's iteration) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

Inductive place := px | py | pu | pw.

(* ---- sequences that converge as 2^-n, with the limit as data: no choice is needed ---- *)
Lemma half_pos n : 0 < (/ 2) ^ n <= 1.
Proof. split. apply pow_lt. lra. rewrite <- (pow1 n). apply pow_incr. lra. Qed.
Lemma halves D e : 0 < e -> exists n, D * (/ 2) ^ n < e.
Proof.
  intros He. destruct (Rle_lt_dec D 0) as [k | k]. exists 0%nat. simpl. lra.
  destruct (pow_lt_1_zero (/ 2) ltac:(rewrite Rabs_pos_eq; lra) (e / D)) as [n Hn]. apply Rdiv_lt_0_compat; trivial.
  exists n. specialize (Hn n (le_n n)). apply Rabs_def2 in Hn. destruct Hn as [Hn _]. apply (Rmult_lt_compat_l D) in Hn; trivial.
  replace (D * (e / D)) with e in Hn by (field; lra). exact Hn.
Qed.
Lemma le_by_halves a b C : (forall n, a <= b + C * (/ 2) ^ n) -> a <= b.
Proof. intros H. apply Rnot_lt_le. intros k. destruct (halves C (a - b)) as [n Hn]. lra. specialize (H n). lra. Qed.
Lemma squeeze (a b : nat -> R) : (forall n, a n <= a (S n)) -> (forall n, b (S n) <= b n) -> (forall n, a n <= b n) ->
  {l | forall n, a n <= l <= b n}.
Proof.
  intros Ha Hb Hab.
  assert (ma : forall n m, (n <= m)%nat -> a n <= a m) by (induction 1; [ lra | eapply Rle_trans; eauto ]).
  assert (mb : forall n m, (n <= m)%nat -> b m <= b n) by (induction 1; [ lra | eapply Rle_trans; eauto ]).
  assert (all : forall n m, a n <= b m).
  { intros n m. apply Rle_trans with (a (max n m)). apply ma, Nat.le_max_l. apply Rle_trans with (b (max n m)); auto. apply mb, Nat.le_max_r. }
  destruct (completeness (fun r => exists n, r = a n)) as [l [l1 l2]].
  { exists (b 0%nat). intros r (n & ->). auto. } { exists (a 0%nat), 0%nat. auto. }
  exists l. intros n. split. apply l1; eauto. apply l2. intros r (m & ->). auto.
Qed.
Lemma lim_geo (a : nat -> R) B : (forall n, Rabs (a (S n) - a n) <= B / 2 * (/ 2) ^ n) -> {l | forall n, Rabs (a n - l) <= B * (/ 2) ^ n}.
Proof.
  intros H. assert (B0 : 0 <= B). { specialize (H 0%nat). pose proof (Rabs_pos (a 1%nat - a 0%nat)). simpl in H. lra. }
  destruct (squeeze (fun n => a n - B * (/ 2) ^ n) (fun n => a n + B * (/ 2) ^ n)) as [l Hl]; [ | | | exists l; intros n; specialize (Hl n); apply Rabs_le; lra ];
    intros n; specialize (H n); apply Rabs_le_between in H; destruct (half_pos n); simpl pow; nra.
Qed.
Lemma der_cont f t l : is_derive f t l -> continuity_pt f t.
Proof. intros H. apply derivable_continuous_pt. exists l. now apply is_derive_Reals. Qed.
Lemma exp_up a b : a <= b -> exp a <= exp b.
Proof. intros [H | ->]; [ left; now apply exp_increasing | lra ]. Qed.
(* a limit that is uniform up to each moment is continuous *)
Lemma cont_limit (f : nat -> R -> R) F C L t : 0 <= L -> (forall n s, continuity_pt (f n) s) ->
  (forall n s, Rabs (f n (Rmax 0 s) - F s) <= C * exp (L * Rmax 0 s) * (/ 2) ^ n) -> continuity_pt F t.
Proof.
  intros HL Cf H e He. set (T := Rmax 0 t + 1). assert (C0 : 0 <= C).
  { specialize (H 0%nat t). pose proof (Rabs_pos (f 0%nat (Rmax 0 t) - F t)). pose proof (exp_pos (L * Rmax 0 t)). simpl in H. nra. }
  destruct (halves (C * exp (L * T)) (e / 3) ltac:(lra)) as [n Hn].
  destruct (Cf n (Rmax 0 t) (e / 3) ltac:(lra)) as (d & d0 & Hd). exists (Rmin d 1). split. apply Rmin_pos; lra.
  intros s [_ Hs]. simpl in *. unfold R_dist in *. pose proof (Rmin_l d 1). pose proof (Rmin_r d 1).
  assert (M : Rabs (Rmax 0 s - Rmax 0 t) <= Rabs (s - t)) by (unfold Rmax, Rabs; repeat (destruct Rle_dec || destruct Rcase_abs); lra).
  assert (near : forall r, Rmax 0 r <= T -> Rabs (f n (Rmax 0 r) - F r) < e / 3).
  { intros r Hr. eapply Rle_lt_trans; [ apply H | ]. eapply Rle_lt_trans; [ | exact Hn ]. destruct (half_pos n).
    apply Rmult_le_compat_r; [ lra | ]. apply Rmult_le_compat_l; trivial. apply exp_up. nra. }
  assert (mid : Rabs (f n (Rmax 0 s) - f n (Rmax 0 t)) < e / 3).
  { destruct (Req_dec (Rmax 0 s) (Rmax 0 t)) as [-> | ne]. rewrite Rminus_eq_0, Rabs_R0. lra. apply Hd. split; [ split; [ exact I | auto ] | lra ]. }
  assert (Ms : Rmax 0 s <= T). { assert (Rabs (Rmax 0 s - Rmax 0 t) < 1) as Q by lra. apply Rabs_def2 in Q. unfold T. lra. }
  pose proof (near s Ms) as N1. pose proof (near t ltac:(unfold T; lra)) as N2. apply Rabs_def2 in N1, N2, mid. apply Rabs_def1; lra.
Qed.
Lemma primitive (g : R -> R) a : (forall t, continuity_pt g t) -> forall t, is_derive (fun s => a + RInt g 0 s) t (g t).
Proof.
  intros H t. assert (Hc : forall s, continuous g s) by (intros s; apply continuity_pt_filterlim, H).
  replace (g t) with (0 + g t) by ring. apply (is_derive_plus (fun _ => a) (fun s => RInt g 0 s)). auto_derive; trivial.
  apply (is_derive_RInt g (fun s => RInt g 0 s) 0 t); [ | apply Hc ].
  exists (mkposreal 1 Rlt_0_1). intros s _. apply (RInt_correct g 0 s), (ex_RInt_continuous g 0 s). intros; apply Hc.
Qed.

Section Picard.
Variable F : place -> (place -> R) -> R.
Variable L : R.
Hypothesis hL : 0 < L.
Hypothesis HF : forall v v' D, (forall j, Rabs (v j - v' j) <= D) -> forall i, Rabs (F i v - F i v') <= L * D.
Variable c : place -> R.

Lemma cont_F i (f : place -> R -> R) t : (forall j, continuity_pt (f j) t) -> continuity_pt (fun s => F i (fun j => f j s)) t.
Proof.
  intros H e He. assert (e1 : e / (2 * L) > 0) by (apply Rdiv_lt_0_compat; lra).
  destruct (H px _ e1) as (d1 & p1 & h1). destruct (H py _ e1) as (d2 & p2 & h2). destruct (H pu _ e1) as (d3 & p3 & h3). destruct (H pw _ e1) as (d4 & p4 & h4).
  exists (Rmin (Rmin d1 d2) (Rmin d3 d4)). split. repeat apply Rmin_pos; trivial.
  intros s [Hs1 Hs2]. simpl in *. unfold R_dist in *.
  apply Rle_lt_trans with (L * (e / (2 * L))). 2: { replace (L * (e / (2 * L))) with (e / 2) by (field; lra). lra. }
  pose proof (Rmin_l (Rmin d1 d2) (Rmin d3 d4)). pose proof (Rmin_r (Rmin d1 d2) (Rmin d3 d4)).
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). pose proof (Rmin_l d3 d4). pose proof (Rmin_r d3 d4).
  apply (HF (fun j => f j s) (fun j => f j t)). intros j. left. destruct j; [ apply h1 | apply h2 | apply h3 | apply h4 ]; split; trivial; lra.
Qed.
(* a bound for a difference from one for the difference of the rates *)
Lemma compare f g f' g' B t : 0 <= t -> 0 <= B -> f 0 = g 0 -> (forall s, 0 <= s <= t -> is_derive f s (f' s)) ->
  (forall s, 0 <= s <= t -> is_derive g s (g' s)) -> (forall s, 0 <= s <= t -> Rabs (f' s - g' s) <= L * (B * exp (2 * L * s))) ->
  Rabs (f t - g t) <= B / 2 * exp (2 * L * t).
Proof.
  assert (half : forall f g f' g', 0 <= t -> 0 <= B -> f 0 = g 0 -> (forall s, 0 <= s <= t -> is_derive f s (f' s)) ->
    (forall s, 0 <= s <= t -> is_derive g s (g' s)) -> (forall s, 0 <= s <= t -> Rabs (f' s - g' s) <= L * (B * exp (2 * L * s))) ->
    f t - g t <= B / 2 * exp (2 * L * t)).
  { clear f g f' g'. intros f g f' g' Ht HB e0 Df Dg H. assert (K : f t - g t - B / 2 * exp (2 * L * t) <= f 0 - g 0 - B / 2 * exp (2 * L * 0)).
    { apply (rder_decr (fun t => f t - g t - B / 2 * exp (2 * L * t))); trivial; intros s Hs.
      - pose proof (der_cont _ _ _ (Df s ltac:(lra))). pose proof (der_cont _ _ _ (Dg s ltac:(lra))). cont.
      - specialize (H s ltac:(lra)). apply Rabs_le_between in H. pose proof (rder_of _ _ _ (Df s ltac:(lra))). pose proof (rder_of _ _ _ (Dg s ltac:(lra))). eexists. split. rd. lra. }
    rewrite Rmult_0_r, exp_0, e0 in K. lra. }
  intros Ht HB e0 Df Dg H. pose proof (half f g f' g' Ht HB e0 Df Dg H).
  pose proof (half g f g' f' Ht HB (eq_sym e0) Dg Df ltac:(intros; rewrite Rabs_minus_sym; auto)). apply Rabs_le. lra.
Qed.

Fixpoint phi n i t := match n with O => c i | S m => c i + RInt (fun s => F i (fun j => phi m j s)) 0 t end.
Lemma phi_cont n : forall i t, continuity_pt (phi n i) t.
Proof.
  induction n as [ | n IH ]; intros i t. apply continuity_pt_const. intros ? ?. reflexivity.
  apply (der_cont _ _ (F i (fun j => phi n j t))), (primitive (fun s => F i (fun j => phi n j s)) (c i)). intros; apply cont_F; auto.
Qed.
Lemma phi_der n i t : is_derive (phi (S n) i) t (F i (fun j => phi n j t)).
Proof. apply (primitive (fun s => F i (fun j => phi n j s)) (c i)). intros; apply cont_F; intros; apply phi_cont. Qed.
Lemma phi_0 n i : phi n i 0 = c i.
Proof. destruct n; simpl; trivial. rewrite RInt_point. apply Rplus_0_r. Qed.

Let B := (Rabs (F px c) + Rabs (F py c) + Rabs (F pu c) + Rabs (F pw c)) / L.
Lemma B_above i : 0 <= Rabs (F i c) <= L * B.
Proof.
  unfold B. replace (L * _) with (Rabs (F px c) + Rabs (F py c) + Rabs (F pu c) + Rabs (F pw c)) by (field; lra).
  pose proof (Rabs_pos (F px c)). pose proof (Rabs_pos (F py c)). pose proof (Rabs_pos (F pu c)). pose proof (Rabs_pos (F pw c)). destruct i; lra.
Qed.
Lemma B_pos : 0 <= B. Proof. pose proof (B_above px). nra. Qed.
Lemma picard_step n : forall i t, 0 <= t -> Rabs (phi (S n) i t - phi n i t) <= B * exp (2 * L * t) / 2 * (/ 2) ^ n.
Proof.
  pose proof B_pos as b0. induction n as [ | n IH ]; intros i t Ht.
  - replace (B * exp (2 * L * t) / 2 * (/ 2) ^ 0) with (B / 2 * exp (2 * L * t)) by (simpl; field).
    apply (compare (phi 1 i) (phi 0 i) (fun s => F i (fun j => phi 0 j s)) (fun _ => 0)); trivial.
    now rewrite !phi_0. intros; apply phi_der. intros; simpl; auto_derive; trivial.
    intros s Hs. rewrite Rminus_0_r. simpl. change (fun j => c j) with c. pose proof (B_above i). apply Rle_trans with (L * B); [ lra | ].
    apply Rmult_le_compat_l; [ lra | ]. rewrite <- (Rmult_1_r B) at 1. apply Rmult_le_compat_l; trivial. rewrite <- exp_0. apply exp_up. nra.
  - destruct (half_pos n). replace (B * exp (2 * L * t) / 2 * (/ 2) ^ S n) with (B / 2 * (/ 2) ^ n / 2 * exp (2 * L * t)) by (simpl; field).
    apply (compare (phi (S (S n)) i) (phi (S n) i) (fun s => F i (fun j => phi (S n) j s)) (fun s => F i (fun j => phi n j s))); trivial; [ nra | | | | ].
    now rewrite !phi_0. intros; apply phi_der. intros; apply phi_der.
    intros s Hs. apply HF. intros j. eapply Rle_trans; [ apply IH; lra | right; field ].
Qed.
Lemma lim_at i t : {l | forall n, Rabs (phi n i (Rmax 0 t) - l) <= B * exp (2 * L * Rmax 0 t) * (/ 2) ^ n}.
Proof. apply (lim_geo (fun n => phi n i (Rmax 0 t))). intros n. apply picard_step, Rmax_l. Qed.
Definition lim i t := proj1_sig (lim_at i t).
Lemma picard_near n i t : Rabs (phi n i (Rmax 0 t) - lim i t) <= B * exp (2 * L * Rmax 0 t) * (/ 2) ^ n.
Proof. unfold lim. destruct (lim_at i t) as [l Hl]. apply Hl. Qed.
Lemma lim_cont i t : continuity_pt (lim i) t.
Proof. apply (cont_limit (fun n => phi n i) (lim i) B (2 * L) t); [ lra | intros; apply phi_cont | intros; apply picard_near ]. Qed.
Definition sol i t := c i + RInt (fun s => F i (fun j => lim j s)) 0 t.
Lemma sol_der i t : is_derive (sol i) t (F i (fun j => lim j t)).
Proof. apply (primitive (fun s => F i (fun j => lim j s)) (c i)). intros; apply cont_F; intros; apply lim_cont. Qed.
Lemma sol_0 i : sol i 0 = c i.
Proof. unfold sol. rewrite RInt_point. apply Rplus_0_r. Qed.
Lemma sol_lim i t : 0 <= t -> lim i t = sol i t.
Proof.
  intros Ht. pose proof B_pos as b0. assert (N : forall n s j, 0 <= s -> Rabs (phi n j s - lim j s) <= B * exp (2 * L * s) * (/ 2) ^ n).
  { intros n s j Hs. pose proof (picard_near n j s) as H. rewrite (Rmax_right 0 s) in H by lra. exact H. }
  assert (Q : Rabs (lim i t - sol i t) <= 0). 2: { apply Rabs_le_between in Q. lra. }
  apply (le_by_halves _ _ (B * exp (2 * L * t))). intros n. rewrite Rplus_0_l. destruct (half_pos n).
  assert (N2 : Rabs (phi (S n) i t - sol i t) <= B * (/ 2) ^ n / 2 * exp (2 * L * t)).
  { apply (compare (phi (S n) i) (sol i) (fun s => F i (fun j => phi n j s)) (fun s => F i (fun j => lim j s))); trivial; [ nra | | | | ].
    now rewrite phi_0, sol_0. intros; apply phi_der. intros; apply sol_der. intros s Hs. apply HF. intros j. eapply Rle_trans; [ apply N; lra | right; ring ]. }
  pose proof (N (S n) t i Ht) as N3. simpl pow in N3. apply Rabs_le_between in N2, N3. apply Rabs_le; lra.
Qed.
Theorem picard : { f : place -> R -> R | (forall i, f i 0 = c i) /\ (forall i t, continuity_pt (f i) t) /\
  forall i t, 0 <= t -> is_derive (f i) t (F i (fun j => f j t)) }.
Proof.
  exists sol. split. exact sol_0. split. intros i t. exact (der_cont _ _ _ (sol_der i t)).
  intros i t Ht. replace (F i (fun j => sol j t)) with (F i (fun j => lim j t)). apply sol_der.
  assert (Q : Rabs (F i (fun j => lim j t) - F i (fun j => sol j t)) <= L * 0). { apply HF. intros j. rewrite sol_lim, Rminus_eq_0, Rabs_R0; lra. }
  apply Rabs_le_between in Q. lra.
Qed.
End Picard.
