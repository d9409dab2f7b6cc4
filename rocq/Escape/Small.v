(* Near alpha = 0 the angle psi relaxes: g = 1 - cos psi falls at the rate kk/p at least while it is neither small nor near 2, and the speed p
   changes at a bounded rate. So while g falls, g + c ln p and g - c ln p fall too: p stays within a factor, and g has time enough. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Analysis Sphere Fate Late Alpha.
Open Scope R_scope.

Lemma turn_falls m L sg : 0 < m <= sg / 4 -> sg ^ 2 <= L ^ 2 -> sg ^ 2 / 2 / m <= 2 * L + (/ m + m) * L ^ 2.
Proof.
  intros Hm H. apply Rle_div_l. lra. replace ((2 * L + (/ m + m) * L ^ 2) * m) with (2 * L * m + L ^ 2 + (m * L) ^ 2) by (field; lra).
  assert (m ^ 2 <= L ^ 2 / 16) by nra. pose proof (pow2_ge_0 (2 * m + L / 2)). pose proof (pow2_ge_0 (m * L)). nra.
Qed.
Lemma leg a b c : 0 <= c -> a ^ 2 + b ^ 2 = c ^ 2 -> - c <= a <= c.
Proof. intros c0 H. pose proof (pow2_ge_0 b). split; nra. Qed.

Lemma between a b v : a < b -> 0 < (v - a) * (b - v) -> a < v < b.
Proof. intros. split; nra. Qed.

Section Small.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Definition g t := 1 - xi t * / rho t.

Lemma d_g t : 0 <= t -> 0 < p t -> 0 < rho t -> rder g t (- (2 * (ell t / rho t) + (/ (p t / rho t) + p t / rho t) * (ell t / rho t) ^ 2)).
Proof.
  intros Ht p0 r0. destruct (xi_p x y u w t p0) as (e1 & _ & e3). pose proof (d_xi x y u w S t Ht p0).
  pose proof (rder_rho x y u w S t Ht ltac:(lra) ltac:(lra)). eapply rder_eq. unfold g. rdq. lra. cbv beta. rewrite <- e1. set (r := rho t) in *.
    set (z := xi t) in *. set (l := ell t) in *.
  set (n := p t) in *. clearbody r z l n. field_simplify_eq; [ | lra ]. assert (e : z ^ 2 = r ^ 2 - l ^ 2) by lra. ring [e].
Qed.
Lemma g_between t : 0 < p t -> 0 < rho t -> 0 <= g t <= 2 /\ (ell t / rho t) ^ 2 = g t * (2 - g t).
Proof.
  intros p0 r0. destruct (xi_p x y u w t p0) as (_ & _ & e3). unfold g. pose proof (Rinv_0_lt_compat _ r0). pose proof (leg _ _ _ (nrm_pos _ _) e3).
  assert (rho t * / rho t = 1) by (field; lra). split. split; nra.
  set (z := xi t) in *. set (r := rho t) in *. set (l := ell t) in *. field_simplify_eq; lra.
Qed.

Variables (s A0 e top hi sg W : R).
Hypothesis s0 : 0 <= s. Hypothesis a0 : 0 < A0. Hypothesis Es : E s = A0 ^ 2.
Hypothesis levels : 0 < e <= top /\ top < hi < 2. Hypothesis gs : g s <= top. Hypothesis ps : 0 < p s.
Hypothesis sg0 : 0 < sg. Hypothesis sg2 : sg ^ 2 = e * (2 - hi). Hypothesis HW : 0 < W <= 1 /\ W <= sg / 4.
Let kk := sg ^ 2 * A0 / 2.
Lemma rho_from t : s <= t -> A0 <= rho t.
Proof.
  intros Ht. pose proof (A_never_falls x y u w S s t ltac:(lra)) as H. rewrite Es, (E_is x y u w t) in H. pose proof (nrm_pos (x t) (y t)).
  pose proof (pow2_ge_0 (p t)). nra.
Qed.
Lemma c_g t : s < t -> 0 < p t -> continuity_pt g t.
Proof. intros Ht p0. pose proof (rho_from t ltac:(lra)). unfold g. conts S. Qed.
Lemma kk0 n : 0 < n -> 0 < kk / n.
Proof. intros H. pose proof (pow_lt sg 2 sg0). unfold kk. repeat apply Rdiv_lt_0_compat; try apply Rmult_lt_0_compat; lra. Qed.
Lemma falls t : s <= t -> 0 < p t <= W * rho t -> exists l, rder g t l /\ (e <= g t <= hi -> l <= - (kk / p t)).
Proof.
  intros Ht Hp. pose proof (rho_from t Ht) as r0. destruct (g_between t ltac:(lra) ltac:(lra)) as [_ L2]. eexists. split. apply d_g; lra.
  intros Hg. apply Ropp_le_contravar. eapply Rle_trans; [ | apply (turn_falls _ _ sg) ].
  - replace (sg ^ 2 / 2 / (p t / rho t)) with (sg ^ 2 / 2 * rho t / p t) by (field; lra). unfold kk, Rdiv.
    apply Rmult_le_compat_r. left; apply Rinv_0_lt_compat; lra. apply (Rmult_le_compat_l (sg ^ 2)) in r0; [ lra | apply pow2_ge_0 ].
  - split. apply Rdiv_lt_0_compat; lra. apply Rle_div_l. lra. nra.
  - rewrite L2, sg2. apply Rmult_le_compat; lra.
Qed.
Definition slips t := forall r, s <= r <= t -> 0 < p r <= W * rho r.
Lemma g_below t : s <= t -> slips t -> g t < hi.
Proof.
  intros Ht H. enough (0 < hi - g t) by lra. apply (stays_pos (fun r => hi - g r) s t); try lra.
  - intros r Hr. pose proof (c_g r ltac:(lra) ltac:(apply H; lra)). contq.
  - intros r Hr _. destruct (falls r ltac:(lra) (H r ltac:(lra))) as (l & L & _). eexists. rdq.
  - intros q Hq K k. enough (g q - top <= 0) by lra. apply (barrier (fun r => g r - top) s q); try lra; intros r Hr; specialize (H r ltac:(lra)).
    + pose proof (c_g r ltac:(lra) ltac:(lra)). contq.
    + destruct (falls r ltac:(lra) H) as (l & L & l0). specialize (K r ltac:(lra)). pose proof (kk0 (p r) ltac:(lra)). eexists. split. rdq.
      intros b. specialize (l0 ltac:(lra)). lra.
Qed.
Lemma g_stays T t : s <= T <= t -> slips t -> g T <= e -> g t <= e.
Proof.
  intros Ht H gT. enough (g t - e <= 0) by lra. apply (barrier (fun r => g r - e) T t); try lra; intros r Hr; pose proof (H r ltac:(lra)).
  - pose proof (c_g r ltac:(lra) ltac:(lra)). contq.
  - destruct (falls r ltac:(lra) ltac:(trivial)) as (l & L & l0). pose proof (g_below r ltac:(lra) ltac:(intros q Hq; apply H; lra)).
    pose proof (kk0 (p r) ltac:(lra)). eexists. split. rdq. intros b. specialize (l0 ltac:(lra)). lra.
Qed.
Let k := kk / (3 * A0 + 1).
Let La := exp (3 / k).
Hypothesis small : p s * La < W * A0. Hypothesis brief : p s * La * 3 / kk <= 1.
Lemma soon : exists T, s <= T <= s + p s * La * 3 / kk /\ (forall r, s <= r <= T -> 0 < p r < W * A0) /\ g T <= e.
Proof.
  assert (q0 : 0 < kk) by (pose proof (kk0 1 Rlt_0_1); lra). assert (k0 : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  assert (L1 : 1 < La) by (unfold La; rewrite <- exp_0; apply exp_increasing, Rdiv_lt_0_compat; lra).
  set (lo := p s / La). set (up := p s * La) in *. assert (l0 : 0 < lo) by (apply Rdiv_lt_0_compat; lra).
  assert (l1 : lo < p s) by (apply Rlt_div_l; nra). assert (u1 : p s < up) by (unfold up; nra).
  assert (uA : up <= A0) by nra.
  assert (lnL : k * ln La = 3) by (unfold La; rewrite ln_exp; field; lra).
  assert (t10 : 0 < up * 3 / kk) by (apply Rdiv_lt_0_compat; nra). set (t1 := up * 3 / kk) in *. apply Classical_Prop.NNPP. intros no.
  assert (W1 : forall t, s <= t -> 0 < p t <= up -> 0 < p t <= W * rho t) by (intros t Ht H; pose proof (rho_from t Ht); nra).
  assert (gf : forall t, s <= t <= s + t1 -> (forall r, s <= r <= t -> 0 < p r <= up) -> exists l, rder g t l /\ l <= - (kk / p t)).
  { intros t Ht H. destruct (falls t ltac:(lra)) as (l & L & K). apply W1, H; lra. exists l. split; trivial. apply K.
    split. 2: { left. apply g_below. lra. intros r Hr. apply W1, H; lra. }
    left. apply Rnot_le_lt. intros n. apply no. exists t. split; trivial. split; trivial. intros r Hr. specialize (H r Hr). lra. }
  assert (range : forall t, s <= t -> 0 < p t -> 0 <= g t <= 2) by (intros t Ht p0; pose proof (rho_from t Ht); apply g_between; lra).
  assert (in_up : forall t, 0 < (p t - lo) * (up - p t) -> lo < p t < up) by (intros t; apply between; lra).
  assert (all : forall t, s <= t <= s + t1 -> lo < p t < up).
  { intros t Ht. apply in_up. revert t Ht. apply stays_pos.
    - intros. conts S.
    - intros t Ht H. apply in_up in H. pose proof (d_p x y u w S t ltac:(lra) ltac:(lra)). eexists.
      apply (rder_mult (fun t => p t - lo) (fun t => up - p t)); [ apply (rder_minus (fun t => p t)) | apply (rder_minus (fun _ => up)) ]; rdq.
    - apply Rmult_lt_0_compat; lra.
    - intros t Ht H z. assert (pt : p t = lo \/ p t = up) by (destruct (Rmult_integral _ _ z); lra).
      assert (b : forall r, s <= r <= t -> 0 < p r <= up).
      { intros r Hr. destruct (Req_dec r t) as [-> | n]; [ lra | specialize (in_up r (H r ltac:(lra))); lra ]. }
      assert (rt : forall r, s <= r <= t -> rho r <= 3 * A0).
      { intros r Hr. enough (rho r - A0 * r <= rho s - A0 * s).
        { pose proof (E_is x y u w s). assert (p s ^ 2 <= A0 ^ 2) by (apply pow_incr; lra).
          assert (rho s <= 2 * A0) by (clear - H1 H2 Es a0; eapply Rle_trans; [ apply Rle_abs | apply abs_of_sq; nra ]).
          assert (A0 * (r - s) <= A0 * 1) by (apply Rmult_le_compat_l; lra). lra. }
        apply (rder_decr (fun r => rho r - A0 * r)); [ lra | intros; conts S | ]. intros q Hq. specialize (b q ltac:(lra)).
        pose proof (rho_from q ltac:(lra)). pose proof (rder_rho x y u w S q ltac:(lra) ltac:(lra) ltac:(lra)).
        eexists. split. apply (rder_minus (fun r => rho r)); [ eassumption | rd ]. destruct (xi_p x y u w q ltac:(lra)) as (e1 & _ & e3).
        pose proof (leg _ _ _ (nrm_pos _ _) e3). set (z' := xi q) in *. rewrite <- e1. enough (z' * p q / rho q <= A0) by lra.
        apply Rle_div_l. lra. apply Rle_trans with (rho q * p q); [ | rewrite Rmult_comm ]; apply Rmult_le_compat_r; lra. }
      assert (mono : forall c, - k <= c <= k -> g t + c * ln (p t) <= g s + c * ln (p s)).
      { intros c Hc. apply (rder_decr (fun t => g t + c * ln (p t))); [ lra | | ]; intros r Hr; specialize (b r ltac:(lra)) as br.
        - pose proof (c_g r ltac:(lra) ltac:(lra)). conts S.
        - destruct (gf r ltac:(lra)) as (l & L & lb). { intros; apply b; lra. } pose proof (d_p x y u w S r ltac:(lra) ltac:(lra)).
          eexists. split. apply (rder_plus g); [ exact L | apply (rder_mult (fun _ => c)); [ rdq | apply (rder_ln (fun t => p t));
            [ eassumption | lra ] ] ].
          specialize (rt r ltac:(lra)). destruct (xi_p x y u w r ltac:(lra)) as (_ & _ & e3). pose proof (leg _ _ _ (nrm_pos _ _) e3).
          set (z' := xi r) in *. enough (l + c * (z' - 1) / p r <= 0) by lra.
          assert (c * (z' - 1) / p r <= kk / p r); [ | lra ]. unfold Rdiv. apply Rmult_le_compat_r. left; apply Rinv_0_lt_compat; lra.
          replace kk with (k * (3 * A0 + 1)) by (unfold k; field; lra). apply Rle_trans with (Rabs c * Rabs (z' - 1)).
          rewrite <- Rabs_mult. apply Rle_abs. apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; lra. }
      pose proof (range t ltac:(lra) ltac:(lra)). pose proof (range s ltac:(lra) ps). pose proof (mono k ltac:(lra)).
        pose proof (mono (- k) ltac:(lra)).
      destruct pt as [e1 | e1]; rewrite e1 in *; unfold lo, up in *; [ rewrite ln_div in * by lra | rewrite ln_mult in * by lra ]; lra. }
  assert (K : g (s + t1) + kk / up * (s + t1) <= g s + kk / up * s).
  { apply (rder_decr (fun t => g t + kk / up * t)); [ lra | | ]; intros r Hr; pose proof (all r ltac:(lra)).
    - pose proof (c_g r ltac:(lra) ltac:(lra)). contq.
    - destruct (gf r ltac:(lra)) as (l & L & lb). { intros q Hq. specialize (all q ltac:(lra)). lra. } eexists. split.
      apply (rder_plus g); [ exact L | rd ].
      assert (kk / up <= kk / p r); [ | lra ]. apply Rmult_le_compat_l. lra. apply Rinv_le_contravar; lra. }
  pose proof (all (s + t1) ltac:(lra)). pose proof (range (s + t1) ltac:(lra) ltac:(lra)). pose proof (range s ltac:(lra) ps).
  assert (kk / up * t1 = 3) by (unfold t1; field; lra). lra.
Qed.
End Small.

(* within the time tau the angle comes below the bound, and stays there while p is small beside rho *)
Theorem relaxes A0 c0 e kap tau : 0 < A0 -> -1 < c0 <= 1 -> 0 < e < 1 -> 0 < kap -> 0 < tau -> exists W start, 0 < W <= kap /\ 0 < start <= W * A0 /\
  forall x y u w s, spin x y u w -> 0 <= s -> x s ^ 2 + y s ^ 2 - (u s ^ 2 + w s ^ 2) = A0 ^ 2 -> 0 < nrm (u s) (w s) < start ->
  x s * u s + y s * w s = nrm (x s) (y s) * nrm (u s) (w s) * c0 ->
  exists T, s <= T <= s + tau /\ (forall r, s <= r <= T -> 0 < nrm (u r) (w r) < W * A0) /\
  forall t, T <= t -> (forall r, s <= r <= t -> 0 < nrm (u r) (w r) <= W * nrm (x r) (y r)) ->
  (1 - e) * (nrm (x t) (y t) * nrm (u t) (w t)) <= x t * u t + y t * w t.
Proof.
  intros a0 Hc He Hk Ht. set (top := Rmax e (1 - c0)). set (hi := (3 - c0) / 2). pose proof (Rmax_l e (1 - c0)). pose proof (Rmax_r e (1 - c0)).
  assert (th : top < hi) by (apply Rmax_lub_lt; unfold hi; lra). fold top in H, H0. set (sg := sqrt (e * (2 - hi))).
  assert (eh : 0 < e * (2 - hi)) by (unfold hi; nra). assert (g0 : 0 < sg) by now apply sqrt_lt_R0.
    assert (g2 : sg ^ 2 = e * (2 - hi)) by (apply root_sq; lra).
  set (W := Rmin kap (Rmin 1 (sg / 4))). assert (W0 : 0 < W) by (repeat apply Rmin_pos; lra).
  assert (HW : W <= kap /\ W <= 1 /\ W <= sg / 4) by (unfold W, Rmin; repeat destruct Rle_dec; lra).
  set (kk := sg ^ 2 * A0 / 2). assert (q0 : 0 < kk) by (unfold kk; rewrite g2; nra). set (La := exp (3 / (kk / (3 * A0 + 1)))).
  assert (L0 : 0 < La) by apply exp_pos.
    assert (L1 : 1 <= La) by (rewrite <- exp_0; left; apply exp_increasing; apply Rdiv_lt_0_compat; [ | apply Rdiv_lt_0_compat ]; lra).
  set (m := Rmin (W * A0) (Rmin tau 1 * kk / 3)). assert (m0 : 0 < m).
  { apply Rmin_pos. nra. apply Rdiv_lt_0_compat; [ apply Rmult_lt_0_compat; trivial; apply Rmin_pos | ]; lra. }
  assert (Hm : m <= W * A0 /\ m * 3 / kk <= tau /\ m * 3 / kk <= 1).
  { split. apply Rmin_l. pose proof (Rmin_r (W * A0) (Rmin tau 1 * kk / 3)) as b. fold m in b. pose proof (Rmin_l tau 1). pose proof (Rmin_r tau 1).
    assert (m * 3 / kk <= Rmin tau 1) by (apply Rle_div_l; trivial; lra). lra. }
  exists W, (m / La). split. lra. split. { split. now apply Rdiv_lt_0_compat. apply Rle_div_l; nra. }
  intros x y u w s S s0 Es [ps pm] cs. apply Rlt_div_r in pm; trivial. set (n := nrm (u s) (w s)) in *.
  assert (b : n * La * 3 / kk <= m * 3 / kk) by (apply Rmult_le_compat_r; [ left; now apply Rinv_0_lt_compat | lra ]).
  assert (rs : 0 < nrm (x s) (y s)) by (pose proof (rho_from x y u w S s A0 s0 a0 Es s (Rle_refl s)); lra).
  assert (gs : g x y u w s <= top). { unfold g. rewrite cs. fold n. replace (_ * / n * / _) with c0 by (field; lra). lra. }
  assert (lv : 0 < e <= top /\ top < hi < 2) by (unfold hi in *; lra).
  assert (f1 : n * La < W * A0) by lra. assert (f2 : n * La * 3 / kk <= 1) by lra.
  destruct (soon x y u w S s A0 e top hi sg W s0 a0 Es lv gs ps g0 g2 ltac:(lra) f1 f2) as (T & HT & HP & gT).
  exists T. split. { change (s <= T <= s + n * La * 3 / kk) in HT. lra. } split; trivial. intros t Ht' sl.
  pose proof (g_stays x y u w S s A0 e top hi sg W s0 a0 Es lv gs g0 g2 ltac:(lra) T t ltac:(lra) sl gT) as K.
  pose proof (rho_from x y u w S s A0 s0 a0 Es t ltac:(lra)) as r0. destruct (sl t ltac:(lra)) as [p0 _]. rewrite <- (proj1 (xi_p x y u w t p0)).
  unfold g in K. set (z := _ * / nrm (u t) (w t)) in *. set (r := nrm (x t) (y t)) in *.
  assert ((1 - e) * r <= z) by (replace z with (z * / r * r) by (field; lra); apply Rmult_le_compat_r; lra). nra.
Qed.
