(* Motions with A > 1: the speed vanishes at most once; xi = rho cos psi grows without bound, and p beside rho - p. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Analysis Sphere Fate Late.
Open Scope R_scope.

Section Alpha.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Let up := A_never_falls x y u w S.

Lemma cont_xi t : 0 < t -> p t <> 0 -> continuity_pt (fun t => xi t) t.
Proof. intros Ht N. conts S. Qed.
Lemma d_xi t : 0 <= t -> 0 < p t -> rder (fun t => xi t) t ((p t + ell t) ^ 2 / p t).
Proof. intros Ht N. apply (eq101 x y u w S t Ht). lra. Qed.
Lemma d_p t : 0 <= t -> 0 < p t -> rder (fun t => p t) t (xi t - 1).
Proof. intros Ht N. apply (dp x y u w S t Ht). lra. Qed.
(* xi = rho cos psi never falls while it slips *)
Theorem xi_never_falls s t : 0 <= s <= t -> (forall r, s <= r <= t -> 0 < p r) -> xi s <= xi t.
Proof.
  intros Hst N. enough (- xi t <= - xi s) by lra. apply (rder_decr (fun t => - xi t)); [ lra | | ]; intros r Hr; specialize (N r ltac:(lra)).
  - conts S.
  - eexists. split. apply (rder_opp (fun t => xi t)), d_xi; lra. pose proof (Rinv_0_lt_compat _ N). pose proof (pow2_ge_0 (p r + ell r)).
    unfold Rdiv. nra.
Qed.
Lemma xi_p t : 0 < p t -> xi t * p t = x t * u t + y t * w t /\ ell t * p t = x t * w t - y t * u t /\ xi t ^ 2 + ell t ^ 2 = rho t ^ 2.
Proof.
  intros N. repeat split; try (field; lra). rewrite !Rpow_mult_distr, nrm_sq. pose proof (nrm_sq (u t) (w t)) as e. set (n := p t) in *.
  field_simplify_eq; [ ring [e] | lra ].
Qed.
Lemma E_is t : E t = rho t ^ 2 - p t ^ 2.
Proof. rewrite !nrm_sq. ring. Qed.
Lemma slow t : 0 < E t -> p t < rho t.
Proof. rewrite E_is. pose proof (nrm_pos (x t) (y t)). pose proof (nrm_pos (u t) (w t)). nra. Qed.

(* the speed never vanishes, unless it comes straight in; cos psi > - 1 / cosh alpha is enough *)
Theorem never_stops s : 0 <= s -> 1 < E s -> 0 < x s * u s + y s * w s + sqrt (E s) * p s -> forall t, s <= t -> 0 < p t.
Proof.
  intros Hs HE H0 t Ht. set (a := sqrt (E s)) in *. assert (aa : a ^ 2 = E s) by (apply root_sq; lra).
  assert (a1 : 1 < a) by (unfold a; rewrite <- sqrt_1; apply sqrt_lt_1_alt; lra).
  assert (ps : 0 < p s). { destruct (nrm_pos (u s) (w s)) as [k | k]; trivial. destruct (nrm_zero _ _ (eq_sym k)) as [z1 z2].
    rewrite <- k, z1, z2 in H0. lra. }
  assert (x0 : - a < xi s) by (apply (Rmult_lt_reg_r (p s)); trivial; rewrite (proj1 (xi_p s ps)); lra).
  assert (C : exists c, 1 <= c < a /\ - xi s < c).
  { pose proof (Rmax_l 1 (- xi s)). pose proof (Rmax_r 1 (- xi s)). exists ((Rmax 1 (- xi s) + a) / 2).
    assert (Rmax 1 (- xi s) < a) by (apply Rmax_lub_lt; lra). lra. }
  destruct C as (c & Hc & xc). apply (stays_pos (fun t => p t) s t); trivial; try lra; try (intros T HT).
  { conts S. } { intros N. eexists. apply d_p; lra. }
  intros N k. destruct (nrm_zero _ _ k) as [z1 z2]. pose proof (nrm_pos (x T) (y T)).
  assert (mono : forall r, s <= r < T -> - c < xi r) by (intros r Hr; pose proof (xi_never_falls s r ltac:(lra) ltac:(intros; apply N; lra)); lra).
  destruct (just_before s T (fun t => rho t - p t - c)) as (r & Hr & Hd); [ lra | conts S | | ].
  { pose proof (up s T ltac:(lra)) as g. rewrite (E_is T), k in g. nra. }
  assert (K : - (x T * u T + y T * w T + c * p T) <= - (x r * u r + y r * w r + c * p r)).
  { apply (rder_decr (fun t => - (x t * u t + y t * w t + c * p t))); [ lra | intros; conts S | ]. intros q Hq.
    specialize (Hd q ltac:(lra)). cbv beta in Hd. pose proof (N q ltac:(lra)) as pq. pose proof (mono q ltac:(lra)) as xq.
    destruct (slip x y u w S q ltac:(lra) ltac:(lra)) as (X & Y & U & W). pose proof (d_p q ltac:(lra) pq) as P. eexists. split. rds.
    destruct (xi_p q pq) as (e1 & e2 & e3). pose proof (nrm_sq (u q) (w q)). pose proof (nrm_sq (x q) (y q)). pose proof (nrm_pos (x q) (y q)).
    set (z := xi q) in *. set (l := ell q) in *. assert (ez : (x q * u q + y q * w q) * / p q = z) by reflexivity. set (n := p q) in *.
      set (m := rho q) in *.
    assert (- m <= l) by nra. assert ((c - 1) * - c <= (c - 1) * z) by (apply Rmult_le_compat_l; lra).
    assert (0 <= n * (l + m)) by (apply Rmult_le_pos; lra). assert (c ^ 2 < (m - n) ^ 2) by nra. unfold Rdiv. nra. }
  specialize (N r Hr). specialize (mono r Hr). rewrite k, z1, z2, <- (proj1 (xi_p r N)) in K. nra.
Qed.
(* it stops at most once *)
Theorem stops_once s : 0 <= s -> 1 < E s -> p s = 0 -> forall t, s < t -> 0 < p t.
Proof.
  intros Hs HE z t Ht. destruct (nrm_zero _ _ z) as [z1 z2]. destruct (s_law _ _ _ _ S s Hs) as (X & Y & fx & fy & [B P] & U & W).
  pose proof (nrm_sq (x s) (y s)) as m2. assert (m1 : 1 < rho s). { rewrite E_is, z in HE. pose proof (nrm_pos (x s) (y s)). nra. }
  pose proof (power_bound 1 fx fy (x s) (y s) Rle_0_1 B) as Q.
  destruct (rder_falls (fun t => - (x t * u t + y t * w t)) s (- (rho s ^ 2 + (x s * fx + y s * fy)))) as (d & d0 & Hd).
  { eapply rder_eq. rd. rewrite z1, z2, m2. ring. } { nra. }
  set (h := Rmin d (t - s) / 2). pose proof (Rmin_l d (t - s)). pose proof (Rmin_r d (t - s)). assert (0 < Rmin d (t - s)) by (apply Rmin_pos; lra).
  specialize (Hd h ltac:(unfold h; lra)). cbv beta in Hd. rewrite z1, z2 in Hd. pose proof (up s (s + h) ltac:(unfold h; lra)).
  pose proof (nrm_pos (u (s + h)) (w (s + h))). pose proof (sqrt_pos (E (s + h))). apply (never_stops (s + h)); try (unfold h; lra). lra. nra.
Qed.
Lemma slips_for_ever s : 0 <= s -> 1 < E s -> exists T, s <= T /\ forall t, T <= t -> 0 < p t.
Proof.
  intros Hs HE. destruct (Classical_Prop.classic (exists T, s <= T /\ p T = 0)) as [(T & T0 & z) | n].
  - exists (T + 1). split; [ lra | ]. intros t Ht. pose proof (up s T ltac:(lra)). apply (stops_once T); trivial; lra.
  - exists s. split; [ lra | ]. intros t Ht. destruct (nrm_pos (u t) (w t)) as [k | k]; trivial. exfalso. eauto.
Qed.
(* at what rate xi grows at least while it is between - K and K *)
Lemma xi_rate K n l e z : 1 <= K -> 0 < n -> 2 * K ^ 2 <= e -> - K <= z <= K -> n ^ 2 <= K * e -> z ^ 2 + l ^ 2 = e + n ^ 2 ->
  / (8 * K * (2 * K + 1)) <= (n + l) ^ 2 / n.
Proof.
  intros HK n0 He Hz Hn H. assert (z ^ 2 <= K ^ 2) by nra. assert (K <= K ^ 2) by nra. assert (e1 : 0 < e) by lra.
  set (Q := (n + l) ^ 2). assert (Q0 : 0 <= Q) by apply pow2_ge_0. assert (r1 : (l - n) ^ 2 <= 2 * e * (2 * K + 1)) by (unfold Q in Q0; nra).
  assert (q1 : (e / 2) ^ 2 <= Q * (l - n) ^ 2).
  { replace (Q * (l - n) ^ 2) with ((l ^ 2 - n ^ 2) ^ 2) by (unfold Q; ring). apply pow_incr. lra. }
  assert (q2 : e <= 8 * (2 * K + 1) * Q). { apply (Rmult_le_reg_l e); trivial. apply (Rmult_le_compat_l Q) in r1; trivial. lra. }
  assert (pk : n <= K * e). { apply Rnot_lt_le. intros k. assert (1 <= K * e) by nra. nra. }
  apply Rle_div_r; trivial. apply (Rmult_le_reg_l (8 * K * (2 * K + 1))); [ nra | ].
  replace (8 * K * (2 * K + 1) * (/ (8 * K * (2 * K + 1)) * n)) with n by (field; lra). nra.
Qed.
Lemma xi_grows s K0 : 0 <= s -> 1 < E s -> (forall t, s <= t -> 0 < p t) -> exists T, s <= T /\ forall t, T <= t -> K0 < xi t.
Proof.
  intros Hs HE N. assert (mono : forall r t, s <= r <= t -> xi r <= xi t) by (intros r t Hr; apply xi_never_falls; [ lra | intros; apply N; lra ]).
  destruct (Classical_Prop.classic (exists T, s <= T /\ K0 < xi T)) as [(T & T0 & HT) | n].
  { exists T. split; trivial. intros t Ht. specialize (mono T t ltac:(lra)). lra. } exfalso.
  set (K := 1 + Rabs K0 + Rabs (xi s)). pose proof (Rabs_pos K0). pose proof (Rabs_pos (xi s)). assert (k1 : 1 <= K) by (unfold K; lra).
  assert (below : forall t, s <= t -> - K <= xi t <= K).
  { intros t Ht. specialize (mono s t ltac:(lra)). pose proof (Rle_abs (- xi s)) as a. rewrite Rabs_Ropp in a. pose proof (Rle_abs K0).
    assert (xi t <= K0) by (apply Rnot_lt_le; intros k; apply n; eauto). unfold K. lra. }
  assert (energy : forall t, s <= t -> p t ^ 2 <= (K - 1) * E t + p s ^ 2).
  { intros t Ht. enough (p t ^ 2 - (K - 1) * E t <= p s ^ 2 - (K - 1) * E s) by nra.
    apply (rder_decr (fun t => p t ^ 2 - (K - 1) * E t)); trivial; intros r Hr. conts S.
    pose proof (N r ltac:(lra)) as pr. pose proof (d_p r ltac:(lra) pr) as P. pose proof (E_rate x y u w S r ltac:(lra)) as D.
    eexists. split. apply (rder_minus (fun t => p t ^ 2) (fun t => (K - 1) * E t));
      [ apply (rder_pow (fun t => p t) 2 _ _ P) | apply (rder_mult (fun _ => K - 1)); [ rd | exact D ] ].
    destruct (below r ltac:(lra)). set (z := xi r) in *. simpl. nra. }
  destruct (unbounded_above_1 x y u w S s Hs HE (2 * K ^ 2 + p s ^ 2)) as (T & T0 & HT).
  set (c := / (8 * K * (2 * K + 1))). assert (c0 : 0 < c) by (apply Rinv_0_lt_compat; nra).
  set (t1 := T + (2 * K + 1) / c). assert (ct : c * t1 = c * T + 2 * K + 1) by (unfold t1; field; lra). assert (Tt : T <= t1) by nra.
  pose proof (below T T0). pose proof (below t1 ltac:(lra)). enough (c * t1 - xi t1 <= c * T - xi T) by lra.
  apply (rder_decr (fun t => c * t - xi t)); trivial; intros r Hr; pose proof (N r ltac:(lra)) as pr. conts S.
  pose proof (d_xi r ltac:(lra) pr) as D. eexists. split. apply (rder_minus (fun t => c * t) (fun t => xi t)); [ rd | exact D ].
  destruct (xi_p r pr) as (_ & _ & e3). specialize (HT r ltac:(lra)). specialize (energy r ltac:(lra)). pose proof (pow2_ge_0 (p s)).
    pose proof (pow2_ge_0 K).
  enough (c <= (p r + ell r) ^ 2 / p r) by lra. apply (xi_rate K _ _ (E r) (xi r)); trivial; try lra. apply below; lra. rewrite E_is. lra.
Qed.
(* p / (rho - p) grows without bound *)
Lemma ratio_grows s N0 : 0 <= s -> 1 < E s -> 0 <= N0 -> exists T, s <= T /\ forall t, T <= t -> 0 < p t /\ N0 * (rho t - p t) <= p t.
Proof.
  intros Hs HE n0. destruct (slips_for_ever s Hs HE) as (T1 & T10 & N).
  assert (rp : forall t, s <= t -> 1 < E t /\ p t < rho t). { intros t Ht. specialize (up s t ltac:(lra)). split. lra. apply slow. lra. }
  destruct (xi_grows T1 (N0 + 2) ltac:(lra) (proj1 (rp T1 T10)) N) as (T & T0 & HT).
  exists (T + N0 * (rho T - p T)). destruct (rp T ltac:(lra)) as [_ rT].
  assert (g0 : 0 <= N0 * (rho T - p T)) by (apply Rmult_le_pos; lra). split; [ lra | ]. intros t Ht. assert (Tt : T <= t) by lra.
  split; [ apply N; lra | ]. pose proof (nrm_pos (u T) (w T)).
  assert (fast : (N0 + 1) * t - p t <= (N0 + 1) * T - p T).
  { apply (rder_decr (fun t => (N0 + 1) * t - p t)); trivial; intros r Hr. conts S. specialize (HT r ltac:(lra)).
    eexists. split. apply (rder_minus (fun t => (N0 + 1) * t)); [ rd | apply (d_p r ltac:(lra) (N r ltac:(lra))) ]. lra. }
  enough (rho t - p t - t <= rho T - p T - T) by nra.
  apply (rder_decr (fun t => rho t - p t - t)); trivial; intros r Hr. conts S. pose proof (N r ltac:(lra)) as pr.
    destruct (rp r ltac:(lra)) as [_ r2].
  pose proof (d_p r ltac:(lra) pr). pose proof (rder_rho x y u w S r ltac:(lra) ltac:(lra) ltac:(lra)). specialize (HT r ltac:(lra)).
  destruct (xi_p r pr) as [e1 _].
  eexists. split. rds. set (z := xi r) in *. rewrite <- e1. enough (z * p r / rho r <= z) by lra. apply Rle_div_l; nra.
Qed.
End Alpha.
