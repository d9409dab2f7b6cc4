(* Motions with A > 1: the speed vanishes at most once; xi = rho cos psi grows without bound, and p beside rho - p. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Turntable2 Sphere Fate.
Open Scope R_scope.

Lemma right_pos f t l : rder f t l -> 0 < f t -> exists d, 0 < d /\ forall s, t < s < t + d -> 0 < f s.
Proof.
  intros [F [H K]] P. assert (C : continuity_pt F t) by (apply derivable_continuous_pt; exists l; now apply is_derive_Reals).
  apply continuity_pt_filterlim in C. rewrite <- K in P by lra. destruct (C (fun y => 0 < y) (open_gt 0 _ P)) as [d Hd].
  exists d. split. apply cond_pos. intros s Hs. rewrite <- K by lra. apply Hd. change (Rabs (s - t) < d). apply Rabs_def1; lra.
Qed.
Lemma left_pos f t : continuity_pt f t -> 0 < f t -> exists d, 0 < d /\ forall s, t - d < s <= t -> 0 < f s.
Proof.
  intros C P. apply continuity_pt_filterlim in C. destruct (C (fun y => 0 < y) (open_gt 0 _ P)) as [d Hd].
  exists d. split. apply cond_pos. intros s Hs. apply Hd. change (Rabs (s - t) < d). apply Rabs_def1; pose proof (cond_pos d); lra.
Qed.

Section Alpha.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Ltac conts := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

Lemma cont_xi t : 0 < t -> p t <> 0 -> continuity_pt (fun t => xi t) t.
Proof.
  intros Ht N. apply (continuity_pt_mult (fun t => x t * u t + y t * w t) (fun t => / p t)). conts.
  apply (continuity_pt_inv (fun t => p t)); trivial. conts.
Qed.
(* xi = rho cos psi never falls while it slips *)
Theorem xi_never_falls s t : 0 <= s <= t -> (forall r, s <= r <= t -> 0 < p r) -> xi s <= xi t.
Proof.
  intros Hst N. enough (- xi t <= - xi s) by lra. apply (rder_decr (fun t => - xi t)); [ lra | | ]; intros r Hr.
  - apply (continuity_pt_opp (fun t => xi t)), cont_xi; [ lra | ]. specialize (N r ltac:(lra)). lra.
  - specialize (N r ltac:(lra)). eexists. split. apply (rder_opp (fun t => xi t)), (eq101 x y u w S r ltac:(lra) ltac:(lra)).
    enough (0 <= (p r + ell r) ^ 2 / p r) by lra. apply Rmult_le_pos. apply pow2_ge_0. left. now apply Rinv_0_lt_compat.
Qed.
Lemma xi_p t : 0 < p t -> xi t * p t = x t * u t + y t * w t /\ ell t * p t = x t * w t - y t * u t /\ xi t ^ 2 + ell t ^ 2 = rho t ^ 2.
Proof.
  intros N. repeat split; try (field; lra). rewrite !Rpow_mult_distr. rewrite nrm_sq. pose proof (nrm_sq (u t) (w t)) as e. set (n := p t) in *.
  field_simplify_eq; [ | lra ]. rewrite e. ring.
Qed.

(* the speed never vanishes, unless it comes straight in; cos psi > - 1 / cosh alpha is enough *)
Theorem never_stops s : 0 <= s -> 1 < E s -> 0 < x s * u s + y s * w s + sqrt (E s) * p s ->
  forall t, s <= t -> 0 < p t.
Proof.
  intros Hs HE H0. pose proof (A_never_falls x y u w S) as up. set (a := sqrt (E s)) in *.
  assert (aa : a ^ 2 = E s) by (unfold a; rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra).
  assert (a1 : 1 < a) by (unfold a; rewrite <- sqrt_1; apply sqrt_lt_1_alt; lra).
  assert (ps : 0 < p s). { destruct (nrm_pos (u s) (w s)) as [k | k]; trivial. exfalso. destruct (stop0 u w s (eq_sym k)) as [z1 z2]. rewrite <- k, z1, z2 in H0. lra. }
  assert (x0 : - a < xi s). { apply (Rmult_lt_reg_r (p s)); trivial. rewrite (proj1 (xi_p s ps)). lra. }
  set (c0 := Rmax 1 (- xi s)). assert (c1 : 1 <= c0) by apply Rmax_l. assert (c2 : - xi s <= c0) by apply Rmax_r.
  assert (c3 : c0 < a) by (apply Rmax_lub_lt; lra). set (c := (c0 + a) / 2). assert (cc : c0 < c < a) by (unfold c; lra).
  intros t Ht. apply (real_ind (fun t => 0 < p t) s t); trivial; try lra.
  - intros T HT N. destruct (nrm_pos (u T) (w T)) as [k | k]; trivial. exfalso. symmetry in k. destruct (stop0 u w T k) as [z1 z2].
    assert (r2 : c < rho T). { pose proof (up s T ltac:(lra)) as g. rewrite z1, z2 in g. pose proof (nrm_sq (x T) (y T)). pose proof (nrm_pos (x T) (y T)). nra. }
    destruct (left_pos (fun t => rho t - p t - c) T) as (d & d0 & Hd). conts. cbv beta. lra.
    set (r := T - Rmin d (T - s) / 2). assert (0 < Rmin d (T - s)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (T - s)). pose proof (Rmin_r d (T - s)).
    assert (K : - (x T * u T + y T * w T + c * p T) <= - (x r * u r + y r * w r + c * p r)).
    { apply (rder_decr (fun t => - (x t * u t + y t * w t + c * p t))); [ unfold r; lra | unfold r; intros; conts | ].
      intros q Hq. assert (q1 : s <= q < T) by (unfold r in Hq; lra). specialize (Hd q ltac:(unfold r in Hq; lra)). cbv beta in Hd.
      pose proof (N q q1) as pq. destruct (slip x y u w S q ltac:(lra) ltac:(lra)) as (X & Y & U & W).
      pose proof (xi_never_falls s q ltac:(lra) ltac:(intros; apply N; lra)) as xq. destruct (xi_p q pq) as (e1 & e2 & e3).
      eexists. split. apply (rder_opp (fun t => x t * u t + y t * w t + c * p t)), (rder_plus (fun t => x t * u t + y t * w t)); [ rd | ].
      apply (rder_mult (fun _ => c) (fun t => p t)); [ rd | apply (dp x y u w S q ltac:(lra) ltac:(lra)) ].
      pose proof (nrm_sq (u q) (w q)) as n2. pose proof (nrm_sq (x q) (y q)) as m2. pose proof (nrm_pos (x q) (y q)).
      set (z := xi q) in *. set (l := ell q) in *. set (n := p q) in *. set (m := rho q) in *. cbv beta.
      match goal with |- ?g <= 0 => replace g with (- (n ^ 2 + m ^ 2 + 2 * n * l + (c - 1) * z - c)) end.
      2: { replace (x q * (x q + 2 * w q - u q / n)) with (x q ^ 2 + 2 * (x q * w q) - (x q * u q) / n) by (field; lra).
           replace (y q * (y q - 2 * u q - w q / n)) with (y q ^ 2 - 2 * (y q * u q) - (y q * w q) / n) by (field; lra).
           replace z with ((x q * u q) / n + (y q * w q) / n) by (unfold z; fold n; field; lra). rewrite m2, n2. nra. }
      assert (- m <= l) by nra. assert ((c - 1) * - c <= (c - 1) * z) by (apply Rmult_le_compat_l; lra). assert (c ^ 2 < (m - n) ^ 2) by nra. nra. }
    rewrite k, z1, z2 in K. assert (rT : s <= r < T) by (unfold r; lra). pose proof (N r rT) as pr.
    pose proof (xi_never_falls s r ltac:(lra) ltac:(intros; apply N; lra)) as xr. destruct (xi_p r pr) as (e1 & _). rewrite <- e1 in K. nra.
  - intros r Hr N. apply (right_pos (fun t => p t) r (xi r - 1)). apply (dp x y u w S r ltac:(lra)). specialize (N r ltac:(lra)). lra. apply N; lra.
Qed.
(* it stops at most once *)
Theorem stops_once s : 0 <= s -> 1 < E s -> p s = 0 -> forall t, s < t -> 0 < p t.
Proof.
  intros Hs HE z t Ht. pose proof (A_never_falls x y u w S) as up. destruct (stop0 u w s z) as [z1 z2].
  destruct (s_law _ _ _ _ S s Hs) as (X & Y & fx & fy & [B P] & U & W).
  pose proof (nrm_sq (x s) (y s)) as m2. pose proof (nrm_pos (x s) (y s)).
  assert (m1 : 1 < rho s). { rewrite z1, z2 in HE. nra. }
  assert (D : rder (fun t => - (x t * u t + y t * w t)) s (- (rho s ^ 2 + (x s * fx + y s * fy)))).
  { eapply rder_eq. rd. rewrite z1, z2, m2. ring. }
  pose proof (power_bound 1 fx fy (x s) (y s) Rle_0_1 B) as Q.
  destruct (rder_step _ _ _ D ((rho s ^ 2 - rho s) / 2)) as (d & d0 & Hd); [ nra | ]. cbv beta in Hd.
  set (h := Rmin d (t - s) / 2). assert (0 < Rmin d (t - s)) by (apply Rmin_pos; lra). pose proof (Rmin_l d (t - s)). pose proof (Rmin_r d (t - s)).
  specialize (Hd h ltac:(unfold h; lra)). rewrite z1, z2 in Hd. assert (h0 : 0 < h) by (unfold h; lra).
  set (g := rho s ^ 2 + (x s * fx + y s * fy)) in *. set (k := (rho s ^ 2 - rho s) / 2) in *. assert (gk : 0 < k /\ 2 * k <= g) by (unfold g, k; split; nra).
  assert ((- g + k) * h < 0) by nra. assert (up0 : 0 < x (s + h) * u (s + h) + y (s + h) * w (s + h)) by lra.
  apply (never_stops (s + h)); try (unfold h; lra).
  - specialize (up s (s + h) ltac:(unfold h; lra)). lra.
  - pose proof (nrm_pos (u (s + h)) (w (s + h))). pose proof (sqrt_pos (E (s + h))). nra.
Qed.

Lemma slips_for_ever s : 0 <= s -> 1 < E s -> exists T, s <= T /\ forall t, T <= t -> 0 < p t.
Proof.
  intros Hs HE. destruct (Classical_Prop.classic (exists T, s <= T /\ p T = 0)) as [(T & T0 & z) | n].
  - exists (T + 1). split; [ lra | ]. intros t Ht. apply (stops_once T); trivial; try lra. pose proof (A_never_falls x y u w S s T ltac:(lra)). lra.
  - exists s. split; [ lra | ]. intros t Ht. destruct (nrm_pos (u t) (w t)) as [k | k]; trivial. exfalso. eauto.
Qed.
Lemma xi_grows s K0 : 0 <= s -> 1 < E s -> (forall t, s <= t -> 0 < p t) -> exists T, s <= T /\ forall t, T <= t -> K0 < xi t.
Proof.
  intros Hs HE N. pose proof (A_never_falls x y u w S) as up.
  assert (mono : forall r t, s <= r <= t -> xi r <= xi t) by (intros r t Hr; apply xi_never_falls; [ lra | intros; apply N; lra ]).
  destruct (Classical_Prop.classic (exists T, s <= T /\ K0 < xi T)) as [(T & T0 & HT) | n].
  { exists T. split; trivial. intros t Ht. specialize (mono T t ltac:(lra)). lra. } exfalso.
  set (K := Rmax K0 (Rmax 1 (- xi s))). assert (k0 : K0 <= K) by apply Rmax_l. assert (k1 : 1 <= K) by (eapply Rle_trans; [ apply Rmax_l | apply Rmax_r ]).
  assert (k2 : - xi s <= K) by (eapply Rle_trans; [ apply Rmax_r | apply Rmax_r ]).
  assert (below : forall t, s <= t -> - K <= xi t <= K).
  { intros t Ht. split. specialize (mono s t ltac:(lra)). lra. apply Rle_trans with K0; trivial. apply Rnot_lt_le. intros k. apply n. eauto. }
  assert (energy : forall t, s <= t -> p t ^ 2 <= (K - 1) * E t + p s ^ 2).
  { intros t Ht. enough (p t ^ 2 - (K - 1) * E t <= p s ^ 2 - (K - 1) * E s) by nra.
    apply (rder_decr (fun t => p t ^ 2 - (K - 1) * E t)); trivial; intros r Hr. conts.
    destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ]. pose proof (N r ltac:(lra)) as pr. destruct (xi_p r pr) as (e1 & _). destruct (below r ltac:(lra)) as [_ b2].
    eexists. split. rd. lra. simpl INR. simpl pred. pose proof (nrm_sq (u r) (w r)). set (z := xi r) in *. set (n' := p r) in *.
    match goal with |- ?g <= 0 => replace g with (2 * n' * (z - K)) end. nra.
    transitivity (2 * (x r * u r + y r * w r - n') - (K - 1) * (2 * n')). rewrite <- e1. ring. replace n' with (- (fx * u r + fy * w r)) at 1 2 by lra. field_simplify_eq; [ | lra ]. ring. }
  destruct (unbounded_above_1 x y u w S s Hs HE (2 * K ^ 2 + p s ^ 2)) as (T & T0 & HT).
  set (c := / (8 * K * (2 * K + 1))). assert (c0 : 0 < c) by (apply Rinv_0_lt_compat; nra).
  assert (up2 : forall t, T <= t -> - xi t + c * t <= - xi T + c * T).
  { intros t Ht. apply (rder_decr (fun t => - xi t + c * t)); trivial; intros r Hr.
    - apply (continuity_pt_plus (fun t => - xi t) (fun t => c * t)); [ apply (continuity_pt_opp (fun t => xi t)), cont_xi; [ lra | ] | cont ]. specialize (N r ltac:(lra)). lra.
    - pose proof (N r ltac:(lra)) as pr. eexists. split. apply (rder_plus (fun t => - xi t) (fun t => c * t)); [ apply (rder_opp (fun t => xi t)), (eq101 x y u w S r ltac:(lra) ltac:(lra)) | rd ].
      destruct (xi_p r pr) as (_ & _ & e3). destruct (below r ltac:(lra)) as [b1 b2]. specialize (HT r ltac:(lra)). specialize (energy r ltac:(lra)).
      pose proof (nrm_sq (u r) (w r)) as n2. pose proof (nrm_sq (x r) (y r)) as m2. rewrite m2 in e3. set (z := xi r) in *. set (l := ell r) in *. set (n' := p r) in *. set (e := E r) in *.
      assert (ee : x r ^ 2 + y r ^ 2 = e + n' ^ 2) by (rewrite n2; unfold e; ring). rewrite ee in e3. clear ee.
      pose proof (pow2_ge_0 (p s)). assert (z2 : z ^ 2 <= K ^ 2) by nra. assert (e1 : 1 <= e) by nra.
      pose proof (pow2_ge_0 K). assert (pe : n' ^ 2 <= K * e) by lra. assert (ke : 1 <= K * e) by nra. assert (pk : n' <= K * e) by (clear - pe ke pr; set (v := K * e) in *; nra).
      set (Q := (n' + l) ^ 2). set (R' := (l - n') ^ 2).
      assert (qr : Q * R' = (e - z ^ 2) ^ 2). { unfold Q, R'. replace ((n' + l) ^ 2 * (l - n') ^ 2) with ((l ^ 2 - n' ^ 2) ^ 2) by ring. f_equal. lra. }
      assert (q1 : (e / 2) ^ 2 <= Q * R') by (rewrite qr; apply pow_incr; lra).
      assert (r1 : R' <= 2 * e * (2 * K + 1)). { unfold R'. assert (0 <= (l + n') ^ 2) by apply pow2_ge_0. nra. }
      assert (Q0 : 0 <= Q) by apply pow2_ge_0.
      assert (q2 : e <= Q * (8 * (2 * K + 1))). { apply (Rmult_le_reg_l e); [ lra | ]. assert (Q * R' <= Q * (2 * e * (2 * K + 1))) by (apply Rmult_le_compat_l; trivial). lra. }
      assert (q3 : c * n' <= Q). { apply (Rmult_le_reg_l (8 * K * (2 * K + 1))); [ nra | ]. replace (8 * K * (2 * K + 1) * (c * n')) with n' by (unfold c; field; nra). nra. }
      enough (c <= Q / n') by lra. apply Rle_div_r; trivial. }
  set (t1 := T + (2 * K + 1) / c). assert (Tt : T <= t1). { unfold t1. assert (0 < (2 * K + 1) / c) by (apply Rdiv_lt_0_compat; lra). lra. }
  specialize (up2 t1 Tt). pose proof (below T T0). pose proof (below t1 ltac:(lra)). assert (c * t1 = c * T + 2 * K + 1) by (unfold t1; field; lra). lra.
Qed.
(* p / (rho - p) grows without bound *)
Lemma ratio_grows s N0 : 0 <= s -> 1 < E s -> 0 <= N0 -> exists T, s <= T /\ forall t, T <= t -> 0 < p t /\ N0 * (rho t - p t) <= p t.
Proof.
  intros Hs HE n0. pose proof (A_never_falls x y u w S) as up. destruct (slips_for_ever s Hs HE) as (T1 & T10 & N).
  assert (E1 : forall t, s <= t -> 1 < E t) by (intros t Ht; specialize (up s t ltac:(lra)); lra).
  destruct (xi_grows T1 (N0 + 2) ltac:(lra) (E1 T1 T10) N) as (T & T0 & HT).
  assert (rp : forall t, s <= t -> 1 < rho t /\ p t < rho t).
  { intros t Ht. specialize (E1 t Ht). pose proof (nrm_sq (x t) (y t)). pose proof (nrm_sq (u t) (w t)). pose proof (nrm_pos (x t) (y t)). pose proof (nrm_pos (u t) (w t)). pose proof (pow2_ge_0 (p t)). split; nra. }
  assert (fast : forall t, T <= t -> - p t + (N0 + 1) * t <= - p T + (N0 + 1) * T).
  { intros t Ht. apply (rder_decr (fun t => - p t + (N0 + 1) * t)); trivial; intros r Hr. conts.
    pose proof (N r ltac:(lra)). eexists. split. apply (rder_plus (fun t => - p t)); [ apply (rder_opp (fun t => p t)), (dp x y u w S r ltac:(lra) ltac:(lra)) | rd ].
    specialize (HT r ltac:(lra)). lra. }
  assert (slow : forall t, T <= t -> rho t - p t - t <= rho T - p T - T).
  { intros t Ht. apply (rder_decr (fun t => rho t - p t - t)); trivial; intros r Hr. conts.
    pose proof (N r ltac:(lra)) as pr. destruct (slip x y u w S r ltac:(lra) ltac:(lra)) as (X & Y & U & W). destruct (rp r ltac:(lra)) as [r1 r2]. destruct (xi_p r pr) as (e1 & _).
    eexists. split. apply (rder_minus (fun t => rho t - p t)); [ apply (rder_minus (fun t => rho t) (fun t => p t)); [ rd; lra | apply (dp x y u w S r ltac:(lra) ltac:(lra)) ] | rd ].
    specialize (HT r ltac:(lra)). set (z := xi r) in *. rewrite <- e1. assert (z * p r / rho r <= z); [ | lra ]. apply Rle_div_l; nra. }
  set (T2 := T + N0 * (rho T - p T)). destruct (rp T ltac:(lra)). assert (T <= T2) by (unfold T2; nra).
  exists T2. split; [ lra | ]. intros t Ht. split; [ apply N; lra | ]. specialize (fast t ltac:(lra)). specialize (slow t ltac:(lra)). pose proof (nrm_pos (u T) (w T)). unfold T2 in Ht. nra.
Qed.
End Alpha.
