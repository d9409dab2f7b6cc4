(* Near alpha = 0 the angle psi relaxes: g = 1 - cos psi falls at the rate sigma^2 rho/(2p) at least while it is not small and psi
   not near pi; p, and so the time, is either long small, or falls to 0, and in both cases g has time enough. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Fate Alpha Lab Late Reach.
Open Scope R_scope.

Lemma turn_falls L m sg : 0 < m -> 0 < sg -> m <= sg / 4 -> sg ^ 2 <= L ^ 2 -> - (2 * L + (/ m + m) * L ^ 2) <= - (sg ^ 2 / (2 * m)).
Proof.
  intros m0 s0 ms sL. assert (im : 0 < / m) by now apply Rinv_0_lt_compat. assert (k1 : 4 <= sg * / m). { apply (Rmult_le_reg_r m); trivial.
    rewrite Rmult_assoc, Rinv_l; lra. }
  assert (aL : sg <= Rabs L). { pose proof (Rabs_pos L). rewrite <- (pow2_abs L) in sL. nra. } pose proof (Rle_abs (- L)) as l1.
    rewrite Rabs_Ropp in l1. rewrite <- (pow2_abs L). rewrite <- (pow2_abs L) in sL. set (l := Rabs L) in *.
  assert (k2 : 4 * l <= l * (sg * / m)) by nra. assert (k3 : l * (sg * / m) <= l ^ 2 * / m). { replace (l * (sg * / m)) with (l * sg * / m) by ring.
    apply Rmult_le_compat_r; nra. }
  replace (sg ^ 2 / (2 * m)) with (sg ^ 2 * / m / 2) by (field; lra). assert (sg ^ 2 * / m <= l ^ 2 * / m) by (apply Rmult_le_compat_r; lra).
    assert (0 <= m * l ^ 2) by nra. nra.
Qed.

Lemma leg a b c : 0 <= c -> a ^ 2 + b ^ 2 = c ^ 2 -> - c <= a <= c.
Proof. intros c0 H. pose proof (pow2_ge_0 b). split; nra. Qed.

Section Small.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Definition g t := 1 - xi t * / rho t.
Ltac conts := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

Lemma d_g t : 0 <= t -> 0 < p t -> 0 < rho t -> rder g t (- (2 * (ell t / rho t) + (/ (p t / rho t) + p t / rho t) * (ell t / rho t) ^ 2)).
Proof.
  intros Ht p0 r0. destruct (slip x y u w S t Ht ltac:(lra)) as (X & Y & U & W). destruct (xi_p x y u w t p0) as (e1 & _ & e3).
  eapply rder_eq. unfold g. apply (rder_minus (fun _ => 1) (fun t => xi t * / rho t)); [ apply rder_fixed | ].
    apply (rder_mult (fun t => xi t) (fun t => / rho t)). apply (eq101 x y u w S t Ht); lra.
  apply (rder_inv (fun t => rho t)); [ rd | ]; lra. cbv beta. rewrite <- e1. set (r := rho t) in *. set (z := xi t) in *. set (l := ell t) in *.
    set (n := p t) in *. clearbody r z l n.
  field_simplify_eq; [ | lra ]. assert (e : z ^ 2 = r ^ 2 - l ^ 2) by lra. ring [e].
Qed.
Lemma c_g t : 0 < t -> 0 < p t -> 0 < rho t -> continuity_pt g t.
Proof.
  intros Ht p0 r0. apply (continuity_pt_minus (fun _ => 1)). contq. apply (continuity_pt_mult (fun t => xi t)). apply (cont_xi x y u w S); lra.
    apply (cont_inv (fun t => rho t)); [ conts | lra ].
Qed.
Lemma g_between t : 0 < p t -> 0 < rho t -> 0 <= g t <= 2 /\ (ell t / rho t) ^ 2 = g t * (2 - g t).
Proof.
  intros p0 r0. destruct (xi_p x y u w t p0) as (_ & _ & e3). unfold g. assert (i0 : 0 < / rho t) by now apply Rinv_0_lt_compat.
    pose proof (leg _ _ _ (nrm_pos _ _) e3) as b.
  assert (q : rho t * / rho t = 1) by (field; lra). split. split; nra. unfold Rdiv. rewrite Rpow_mult_distr.
    replace (ell t ^ 2) with (rho t ^ 2 - xi t ^ 2) by lra. field. lra.
Qed.

Variables (s A0 c0 e kap tau : R).
Hypothesis s0 : 0 <= s. Hypothesis a0 : 0 < A0. Hypothesis c1 : -1 < c0 <= 1. Hypothesis He : 0 < e <= 1. Hypothesis k0 : 0 < kap.
  Hypothesis tau0 : 0 < tau.
Let top := Rmax e (1 - c0).
Let dl := (2 - top) / 2.
Let sg := sqrt (e * dl).
Definition window := Rmin kap (sg / 4).
Let R := 5 * A0 + 1.
Let t1 := Rmin tau (Rmin 1 (window * A0 / (4 * R))).
Let m := A0 * sg ^ 2 / 2 / R.
Definition start := Rmin (window * A0 / 4) (Rmin A0 (R * t1 * exp (- (2 / m)))).
Lemma sizes : 1 - c0 <= top /\ e <= top < 2 /\ 0 < dl /\ 0 < sg /\ sg ^ 2 = e * dl /\ 0 < window /\ window <= kap /\ window <= sg / 4 /\
  0 < R /\ 0 < t1 /\ t1 <= tau /\ t1 <= 1 /\ R * t1 <= window * A0 / 4 /\ 0 < m /\ 0 < start /\ start <= window * A0 / 4 /\ start <= A0 /\ start <= R
    * t1 * exp (- (2 / m)).
Proof.
  assert (h1 : 1 - c0 <= top) by apply Rmax_r. assert (h2 : e <= top) by apply Rmax_l. assert (h3 : top < 2) by (apply Rmax_lub_lt; lra).
    assert (h4 : 0 < dl) by (unfold dl; lra).
  assert (h5 : 0 < e * dl) by nra. assert (h6 : 0 < sg) by now apply sqrt_lt_R0. assert (h7 : sg ^ 2 = e * dl) by (unfold sg; rewrite <- Rsqr_pow2;
    apply Rsqr_sqrt; lra).
  assert (h8 : 0 < window) by (apply Rmin_pos; lra). assert (h9 : 0 < R) by (unfold R; lra). assert (h10 : 0 < window * A0) by nra.
    assert (h11 : 0 < t1) by (repeat apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; lra).
  assert (h12 : t1 <= window * A0 / (4 * R)) by (eapply Rle_trans; [ apply Rmin_r | apply Rmin_r ]). assert (h13 : R * t1 <= window * A0 / 4).
    { apply (Rmult_le_compat_l R) in h12; [ | lra ]. replace (R * (window * A0 / (4 * R))) with (window * A0 / 4) in h12 by (field; lra). trivial. }
  assert (h14 : 0 < m). { unfold m. apply Rdiv_lt_0_compat; trivial. rewrite h7. nra.
    } assert (h15 : 0 < R * t1 * exp (- (2 / m))) by (apply Rmult_lt_0_compat; [ nra | apply exp_pos ]).
  repeat split; trivial. apply Rmin_l. apply Rmin_r. apply Rmin_l. eapply Rle_trans; [ apply Rmin_r | apply Rmin_l ]. repeat apply Rmin_pos; lra.
    apply Rmin_l. eapply Rle_trans; [ apply Rmin_r | apply Rmin_l ]. eapply Rle_trans; [ apply Rmin_r | apply Rmin_r ].
Qed.
Hypothesis Es : E s = A0 ^ 2.
Hypothesis ps : 0 < p s < start.
Hypothesis cs : xi s = rho s * c0.
Definition slips t := forall r, s <= r <= t -> 0 < p r /\ p r <= window * rho r.
Lemma rho_from t : s <= t -> A0 <= rho t.
Proof. intros Ht. pose proof (A_never_falls x y u w S s t ltac:(lra)). pose proof (nrm_sq (x t) (y t)). pose proof (nrm_pos (x t) (y t)).
  pose proof (pow2_ge_0 (u t)). pose proof (pow2_ge_0 (w t)). nra. Qed.
Lemma g_rate t : s <= t -> 0 < p t -> p t <= window * rho t -> e <= g t <= top + dl -> exists l, rder g t l /\ l <= - (sg ^ 2 * A0 / 2 / p t).
Proof.
  intros Ht p0 pw gt. destruct sizes as (_ & tp & d0 & g0 & g2 & _ & _ & w4 & _). pose proof (rho_from t Ht) as r0.
    destruct (g_between t p0 ltac:(lra)) as [_ L2].
  eexists. split. apply d_g; lra. eapply Rle_trans. apply (turn_falls _ _ sg); trivial. apply Rdiv_lt_0_compat; lra. { apply Rle_div_l. lra.
    eapply Rle_trans; [ exact pw | apply Rmult_le_compat_r; lra ]. }
  - rewrite L2, g2. unfold dl in *. apply Rmult_le_compat; lra.
  - replace (sg ^ 2 / (2 * (p t / rho t))) with (sg ^ 2 * rho t / 2 / p t) by (field; lra). apply Ropp_le_contravar. unfold Rdiv.
    apply Rmult_le_compat_r. left; now apply Rinv_0_lt_compat. apply Rmult_le_compat_r. lra. apply Rmult_le_compat_l. apply pow2_ge_0. trivial.
Qed.
Lemma g_s : g s <= top.
Proof. destruct sizes as (h1 & _). pose proof (rho_from s (Rle_refl s)). unfold g. rewrite cs.
  replace (1 - rho s * c0 * / rho s) with (1 - c0) by (field; lra). trivial. Qed.
Lemma neg q : 0 < p q -> - (sg ^ 2 * A0 / 2 / p q) <= 0.
Proof.
  intros p0. destruct sizes as (_ & _ & _ & g0 & _). assert (0 < sg ^ 2 * A0 / 2 / p q); [ | lra ]. apply Rdiv_lt_0_compat; trivial.
  assert (0 < sg ^ 2) by now apply pow_lt. assert (0 < sg ^ 2 * A0) by now apply Rmult_lt_0_compat. lra.
Qed.
Lemma g_top t : s <= t -> slips t -> g t <= top.
Proof.
  intros Ht W. destruct sizes as (_ & tp & d0 & g0 & g2 & _).
  apply (real_ind (fun r => g r <= top) s t); try lra.
  - apply g_s.
  - intros r Hr K. apply Rnot_lt_le. intros bad. pose proof (rho_from r ltac:(lra)). destruct (W r ltac:(lra)) as [p0 _].
    destruct (left_pos (fun q => g q - top) r) as (d & dd & Hd). { apply (continuity_pt_minus g (fun _ => top)); [ apply c_g; lra | contq ]. } lra.
    assert (0 < Rmin d (r - s)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (r - s)). pose proof (Rmin_r d (r - s)).
      specialize (Hd (r - Rmin d (r - s) / 2) ltac:(lra)). specialize (K (r - Rmin d (r - s) / 2) ltac:(lra)). lra.
  - intros r Hr K. pose proof (K r ltac:(lra)) as kr. pose proof (rho_from r ltac:(lra)). destruct (W r ltac:(lra)) as [p0 _].
    destruct (right_pos (fun q => top + dl - g q) r _ (rder_minus (fun _ => top + dl) g r _ _ (rder_fixed _ _) (d_g r ltac:(lra) p0 ltac:(lra)))) as
      (d & dd & Hd). lra.
    exists (Rmin d (t - r)). split. apply Rmin_pos; lra. intros q Hq. pose proof (Rmin_l d (t - r)). pose proof (Rmin_r d (t - r)).
      enough (g q - top <= 0) by lra.
    apply (barrier (fun q => g q - top) r q); try lra.
    + intros v Hv. destruct (W v ltac:(lra)) as [pv _]. pose proof (rho_from v ltac:(lra)). apply (continuity_pt_minus g (fun _ => top));
      [ apply c_g; lra | contq ].
    + intros v Hv. destruct (W v ltac:(lra)) as [pv wv]. pose proof (rho_from v ltac:(lra)). assert (gv : g v <= top + dl).
      { destruct (Req_dec v r) as [-> | n]. lra. specialize (Hd v ltac:(lra)). lra. }
      destruct (Rle_lt_dec e (g v)) as [k | k].
      * destruct (g_rate v ltac:(lra) pv wv ltac:(lra)) as (l & L & l0). exists (l - 0). split. apply (rder_minus g); [ exact L |
        apply rder_fixed ]. intros _. pose proof (neg v pv). lra.
      * eexists. split. apply (rder_minus g); [ apply d_g; lra | apply rder_fixed ]. intros b. lra.
Qed.
Lemma g_stays T t : s <= T <= t -> slips t -> g T <= e -> g t <= e.
Proof.
  intros Ht W gT. assert (W' : forall r, T <= r <= t -> slips r) by (intros r Hr q Hq; apply W; lra). enough (g t - e <= 0) by lra.
    apply (barrier (fun q => g q - e) T t); try lra; intros v Hv; destruct (W v ltac:(lra)) as [pv wv]; pose proof (rho_from v ltac:(lra)).
  - apply (continuity_pt_minus g (fun _ => e)); [ apply c_g; lra | contq ].
  - pose proof (g_top v ltac:(lra) (W' v ltac:(lra))). destruct sizes as (_ & tp & d0 & g0 & g2 & _). destruct (Rle_lt_dec e (g v)) as [k | k].
    + destruct (g_rate v ltac:(lra) pv wv ltac:(lra)) as (l & L & l0). exists (l - 0). split. apply (rder_minus g); [ exact L | apply rder_fixed ].
      intros _. pose proof (neg v pv). lra.
    + eexists. split. apply (rder_minus g); [ apply d_g; lra | apply rder_fixed ]. intros b. lra.
Qed.
Lemma rho_to t : s <= t <= s + 1 -> rho t <= R.
Proof.
  intros Ht. destruct sizes as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & sA & _).
    pose proof (place_below x y u w S s t ltac:(lra)) as B.
  pose proof (nrm_sq (x s) (y s)) as r2. pose proof (nrm_sq (u s) (w s)) as p2. pose proof (nrm_pos (x s) (y s)).
    assert (rs : rho s <= 2 * A0) by nra.
  assert (lab : nrm (u s - y s) (w s + x s) <= 3 * A0).
  { pose proof (nrm_sq (u s - y s) (w s + x s)) as l2. pose proof (nrm_pos (u s - y s) (w s + x s)).
    pose proof (power_bound (p s) (u s) (w s) (y s) (- x s) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q.
    replace (nrm (y s) (- x s)) with (rho s) in Q by (unfold nrm; f_equal; ring). nra. }
  pose proof (nrm_pos (u s - y s) (w s + x s)). unfold R. nra.
Qed.
Lemma p_to t : s <= t <= s + t1 -> (forall r, s <= r <= t -> 0 < p r) -> p t <= p s + R * (t - s) /\ slips t.
Proof.
  intros Ht N. destruct sizes as (_ & _ & _ & _ & _ & w0 & _ & _ & R0 & _ & _ & t11 & Rt & _ & _ & sw & _).
    assert (K : forall q, s <= q <= t -> p q <= p s + R * (q - s)).
  { intros q Hq. enough (p q - R * q <= p s - R * s) by lra. apply (rder_decr (fun q => p q - R * q)); try lra; intros v Hv. conts.
    pose proof (N v ltac:(lra)) as pv. eexists. split. apply (rder_minus (fun q => p q)); [ apply (dp x y u w S v); lra | rdq ].
    pose proof (rho_to v ltac:(lra)). destruct (xi_p x y u w v pv) as (_ & _ & e3). pose proof (leg _ _ _ (nrm_pos _ _) e3). lra. }
  split. apply K; lra. intros q Hq. split. apply N; lra. specialize (K q ltac:(lra)). pose proof (rho_from q ltac:(lra)).
    assert (R * (q - s) <= R * t1) by (apply Rmult_le_compat_l; lra). nra.
Qed.
Lemma soon : exists T, s <= T <= s + t1 /\ (forall r, s <= r <= T -> 0 < p r) /\ g T <= e.
Proof.
  apply Classical_Prop.NNPP. intros no. destruct sizes as (_ & tp & d0 & g0 & g2 & w0 & _ & _ & R0 & t10 & _ & t11 & Rt & m0 & _ & sw & _ & sx).
  assert (high : forall r, s <= r <= s + t1 -> (forall q, s <= q <= r -> 0 < p q) -> exists l, rder g r l /\ l <= - (m * R / p r)).
  { intros r Hr N. destruct (p_to r Hr N) as [_ W]. destruct (W r ltac:(lra)) as [pr wr]. pose proof (g_top r ltac:(lra) W).
    assert (e < g r) by (apply Rnot_le_lt; intros k; apply no; exists r; auto).
    destruct (g_rate r ltac:(lra) pr wr ltac:(lra)) as (l & L & l0). exists l. split; trivial.
      replace (m * R / p r) with (sg ^ 2 * A0 / 2 / p r) by (unfold m; field; lra). trivial. }
  assert (all : forall r, s <= r <= s + t1 -> 0 < p r).
  { apply real_ind. lra.
    - intros r Hr N. destruct (nrm_pos (u r) (w r)) as [k | k]; trivial. exfalso. set (k1 := m * R / (R + 1)).
      assert (k10 : 0 < k1) by (apply Rdiv_lt_0_compat; nra).
      set (eta := p s * exp (- (3 / k1))). assert (eta0 : 0 < eta) by (apply Rmult_lt_0_compat; [ lra | apply exp_pos ]).
      destruct (left_pos (fun q => eta - p q) r) as (d & dd & Hd). conts. lra. set (q := r - Rmin d (r - s) / 2).
        assert (0 < Rmin d (r - s)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (r - s)). pose proof (Rmin_r d (r - s)).
      specialize (Hd q ltac:(unfold q; lra)). assert (sq : s <= q < r) by (unfold q; lra). assert (pq : 0 < p q) by (apply N; lra).
      assert (B : g q - k1 * ln (p q) <= g s - k1 * ln (p s)).
      { apply (rder_decr (fun t => g t - k1 * ln (p t))); [ lra | | ]; intros v Hv; pose proof (N v ltac:(lra)) as pv;
        pose proof (rho_from v ltac:(lra)).
        - apply (continuity_pt_minus g (fun t => k1 * ln (p t))); [ apply c_g; lra | ]. apply (continuity_pt_mult (fun _ => k1)); [ contq | ].
          apply (cont_ln (fun t => p t)); [ conts | lra ].
        - destruct (high v ltac:(lra) ltac:(intros; apply N; lra)) as (l & L & l0). eexists. split. apply (rder_minus g); [ exact L | ].
          apply (rder_mult (fun _ => k1)); [ apply rder_fixed | ]. apply (rder_ln (fun t => p t)); [ apply (dp x y u w S v); lra | lra ].
          pose proof (rho_to v ltac:(lra)). destruct (xi_p x y u w v pv) as (_ & _ & e3). pose proof (leg _ _ _ (nrm_pos _ _) e3).
          assert (i0 : 0 < / p v) by now apply Rinv_0_lt_compat. replace (m * R / p v) with (k1 * (R + 1) * / p v) in l0 by (unfold k1; field; lra).
            unfold Rdiv. rewrite Rmult_0_l, Rplus_0_l.
          assert (F : 0 <= (xi v - 1 + (R + 1)) * / p v) by (apply Rmult_le_pos; lra). clear - F l0 k10. apply (Rmult_le_compat_l k1) in F; lra. }
      assert (ln (p q) <= ln (p s) - 3 / k1). { replace (ln (p s) - 3 / k1) with (ln eta). apply ln_mono; lra. unfold eta.
        rewrite ln_mult by (try lra; apply exp_pos). rewrite ln_exp. ring. }
      assert (k1 * ln (p q) <= k1 * (ln (p s) - 3 / k1)) by (apply Rmult_le_compat_l; lra).
        replace (k1 * (ln (p s) - 3 / k1)) with (k1 * ln (p s) - 3) in H3 by (field; lra).
      pose proof (rho_from q ltac:(lra)). pose proof (rho_from s ltac:(lra)). destruct (g_between q pq ltac:(lra)) as [gq _].
        destruct (g_between s ltac:(lra) ltac:(lra)) as [gs _]. lra.
    - intros r Hr N. apply (right_pos (fun t => p t) r (xi r - 1)). apply (dp x y u w S r). lra. specialize (N r ltac:(lra)). lra. apply N; lra. }
  apply no. exists (s + t1). split. lra. split. intros; apply all; lra. assert (p s * / R > 0) by (apply Rmult_lt_0_compat; [ lra |
    now apply Rinv_0_lt_compat ]).
  apply (sinks g e m (p s * / R - s) s (s + t1)); try lra.
  - intros v Hv. pose proof (rho_from v ltac:(lra)). apply c_g; try lra. apply all; lra.
  - intros v Hv. destruct (high v ltac:(lra) ltac:(intros; apply all; lra)) as (l & L & l0). exists l. split; trivial. intros _. eapply Rle_trans;
    [ exact l0 | ]. apply Ropp_le_contravar.
    pose proof (all v ltac:(lra)) as pv. destruct (p_to v ltac:(lra) ltac:(intros; apply all; lra)) as [B _].
      replace (m / (v + (p s * / R - s))) with (m * R * / (p s + R * (v - s))). 2: { field. split; [ lra | ]. assert (0 <= R * (v - s)) by nra. lra. }
    unfold Rdiv. apply Rmult_le_compat_l. nra. apply Rinv_le_contravar; lra.
  - replace (s + (p s * / R - s)) with (p s * / R) by ring. replace (s + t1 + (p s * / R - s)) with (t1 + p s * / R) by ring.
    assert (ln (p s * / R) <= ln t1 - 2 / m). { replace (ln t1 - 2 / m) with (ln (t1 * exp (- (2 / m)))). apply ln_mono. split; trivial.
      apply Rle_div_l; trivial. nra. rewrite ln_mult by (try lra; apply exp_pos). rewrite ln_exp. ring. }
    assert (ln t1 <= ln (t1 + p s * / R)) by (apply ln_mono; lra). pose proof (rho_from s ltac:(lra)).
      destruct (g_between s ltac:(lra) ltac:(lra)) as [gs _].
    assert (m * (2 / m) <= m * (ln (t1 + p s * / R) - ln (p s * / R))) by (apply Rmult_le_compat_l; lra).
      replace (m * (2 / m)) with 2 in H3 by (field; lra). lra.
Qed.
(* within the time tau the angle comes below the bound, and stays there while p is small beside rho *)
Theorem relaxes : exists T, s <= T <= s + tau /\ (forall r, s <= r <= T -> 0 < p r /\ p r <= window * A0 / 2) /\
  forall t, T <= t -> (forall r, s <= r <= t -> 0 < p r /\ p r <= window * rho r) -> (1 - e) * rho t <= xi t.
Proof.
  destruct soon as (T & HT & N & gT). destruct sizes as (_ & _ & _ & _ & _ & w0 & _ & _ & R0 & t10 & tt & t11 & Rt & _ & _ & sw & _). exists T.
    split. lra. split.
  - intros r Hr. split. apply N; lra. destruct (p_to r ltac:(lra) ltac:(intros; apply N; lra)) as [B _].
    assert (R * (r - s) <= R * t1) by (apply Rmult_le_compat_l; lra). lra.
  - intros t Ht W. pose proof (g_stays T t ltac:(lra) W gT) as K. pose proof (rho_from t ltac:(lra)). unfold g in K.
    assert (1 - e <= xi t * / rho t) by lra. apply (Rmult_le_compat_r (rho t)) in H0; [ | lra ].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r in H0; lra.
Qed.
End Small.
