(* On either side of the walls: below the lower one every motion comes to rest inside rho = 1, above the upper one it escapes;
   what comes to rest at s started between the two walls of s. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Fate Alpha Stops Bounded Barriers.
Open Scope R_scope.

Lemma wall_cont K s P X L t : continuity_pt P t -> continuity_pt X t -> continuity_pt L t -> continuity_pt (fun t => wall K s (P t) (X t) (L t)) t.
Proof. intros. unfold wall, wb, q2, q3. cont. Qed.
Lemma ws_cont K g s P X L t : continuity_pt P t -> continuity_pt X t -> continuity_pt L t ->
  continuity_pt (fun t => g * ws s (P t) (X t) (L t) - K * P t ^ 3) t.
Proof. intros. unfold ws, qs. cont. Qed.
(* what changes at the rate f / 2 at least while it is positive *)
Lemma grows f a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) -> (forall t, a <= t < b -> exists m, rder f t m /\ (0 < f t ->
  f t / 2 <= m)) ->
  0 < f a -> f a * (1 + (b - a) / 2) <= f b.
Proof.
  intros Hab C D f0. assert (up : forall t, a <= t <= b -> f a <= f t).
  { intros t Ht. apply Ropp_le_cancel. apply (rder_stays (fun t => - f t)); [ lra | intros r Hr; apply continuity_pt_opp, C; lra | | lra ].
    intros r Hr. destruct (D r ltac:(lra)) as (m & Hm & k). exists (- m). split. now apply rder_opp. intros. specialize (k ltac:(lra)). lra. }
  enough (f a / 2 * b - f b <= f a / 2 * a - f a) by lra. apply (rder_decr (fun t => f a / 2 * t - f t)); trivial; intros t Ht.
  - cont.
  - destruct (D t Ht) as (m & Hm & k). eexists. split. rd. specialize (up t ltac:(lra)). specialize (k ltac:(lra)). lra.
Qed.

Section Sides.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Ltac conts := table S.

Lemma E_of t : 0 < p t -> xi t ^ 2 + ell t ^ 2 - p t ^ 2 = E t.
Proof. intros N. rewrite (xi_ell x y u w t N), nrm_sq. ring. Qed.

Lemma E_rate t : 0 <= t -> rder (fun t => E t) t (2 * p t).
Proof. intros Ht. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & [B P] & U & W). eapply rder_eq. rd. simpl. lra. Qed.
(* p / A does not grow while A <= 1 *)
Lemma small h b : 0 < h -> p 0 ^ 2 < h ^ 2 * E 0 -> (forall t, 0 <= t < b -> 0 < p t) -> (forall t, 0 <= t < b -> E t <= 1) ->
  forall t, 0 <= t < b -> p t <= h.
Proof.
  intros h0 H0 N HE t Ht. enough (k : p t ^ 2 - h ^ 2 * E t <= p 0 ^ 2 - h ^ 2 * E 0).
  { specialize (HE t Ht). pose proof (nrm_pos (u t) (w t)). assert (h ^ 2 * E t <= h ^ 2 * 1) by (apply Rmult_le_compat_l; nra). nra. }
  apply (rder_stays (fun t => p t ^ 2 - h ^ 2 * E t)); [ lra | | | lra ]; intros r Hr.
  - apply (continuity_pt_minus (fun t => p t ^ 2) (fun t => h ^ 2 * E t)); conts.
  - specialize (N r ltac:(lra)). specialize (HE r ltac:(lra)). eexists. split.
    { apply (rder_minus (fun t => p t ^ 2) (fun t => h ^ 2 * E t)); [ apply (rder_pow (fun t => p t)), (dp x y u w S); lra
        | apply (rder_mult (fun _ => h ^ 2) (fun t => E t)); [ rd | apply E_rate; lra ] ]. }
    intros k. pose proof (E_of r N) as e. pose proof (pow2_ge_0 (ell r)). set (X := xi r) in *. set (q := p r) in *. simpl INR. simpl pred.
    rewrite pow_1.
    match goal with |- ?g <= 0 => replace g with (2 * q * (X - (1 + h ^ 2))) by (simpl; ring) end.
    assert (h ^ 2 * E r <= h ^ 2 * 1) by (apply Rmult_le_compat_l; nra). pose proof (pow2_ge_0 h). enough (X <= 1 + h ^ 2) by nra. nra.
Qed.
End Sides.

(* the fates, by the side of the walls on which a motion starts with alpha small *)
Lemma sides : exists K h, 0 < K /\ 0 < h <= 1 /\ forall x y u w, spin x y u w -> 0 < nrm (u 0) (w 0) ->
  nrm (u 0) (w 0) ^ 2 < h ^ 2 * (x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2)) -> x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2) <= 1 ->
  let xi := (x 0 * u 0 + y 0 * w 0) * / nrm (u 0) (w 0) in let ell := (x 0 * w 0 - y 0 * u 0) * / nrm (u 0) (w 0) in
  (0 < wall K (- (1)) (nrm (u 0) (w 0)) xi ell -> exists T, 0 <= T /\ nrm (u T) (w T) = 0 /\ nrm (x T) (y T) < 1) /\
  (0 < wall K 1 (nrm (u 0) (w 0)) xi ell -> exists T, 0 <= T /\ 1 < x T ^ 2 + y T ^ 2 - (u T ^ 2 + w T ^ 2)).
Proof.
  destruct wall_rate as (K & h & K0 & h0 & near & at1 & rate). exists K, h. split; trivial. split; trivial. intros x y u w S p0 Hh E0.
  set (p t := nrm (u t) (w t)). set (X t := (x t * u t + y t * w t) * / nrm (u t) (w t)). set (L t := (x t * w t - y t * u t) * / nrm (u t) (w t)).
  set (E t := x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)). change (0 < p 0) in p0. change (p 0 ^ 2 < h ^ 2 * E 0) in Hh. change (E 0 <= 1) in E0.
  cbv zeta. fold (p 0) (X 0) (L 0).
  assert (Epos : 0 < E 0) by (assert (0 < p 0 ^ 2) by nra; assert (0 < h ^ 2) by nra; nra).
  assert (Eup : forall s t, 0 <= s <= t -> E s <= E t) by (intros; now apply (A_never_falls x y u w S)).
  assert (Eof : forall t, 0 < p t -> X t ^ 2 + L t ^ 2 - p t ^ 2 = E t) by (intros t; apply (E_of x y u w)).
  assert (cE : forall t, 0 < t -> continuity_pt E t).
  { intros t Ht. unfold E. table S. }
  assert (cp : forall t, 0 < t -> continuity_pt p t).
  { intros t Ht. unfold p. cont; first [ apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra. }
  set (V s t := wall K s (p t) (X t) (L t)).
  assert (gr : forall s b, s = 1 \/ s = - (1) -> (forall t, 0 <= t < b -> 0 < p t) -> (forall t, 0 <= t < b -> E t <= 1) -> 0 < V s 0 ->
    forall t, 0 <= t < b -> V s 0 * (1 + t / 2) <= V s t /\ 0 < p t <= h).
  { intros s b Hs N HE V0 t Ht. assert (sm : forall t, 0 <= t < b -> 0 < p t <= h). { intros r Hr. split. now apply N.
  apply (small x y u w S h b); trivial. lra. }
    split; [ | now apply sm ]. pose proof (reduced_spin x y u w S 0 b (Rle_refl 0) N) as R. replace (t / 2) with ((t - 0) / 2) by field.
    apply (grows (V s)); trivial; try lra; intros r Hr.
    - destruct (r_cont _ _ _ _ _ R r ltac:(lra)) as (c1 & c2 & c3). now apply (wall_cont K s p X L).
    - destruct (r_rate _ _ _ _ _ R r ltac:(lra)) as (d1 & d2 & d3). specialize (sm r ltac:(lra)). apply (rate s p X L r); trivial.
      rewrite (Eof r) by lra. apply HE. lra. }
  assert (low : forall s t, s = 1 \/ s = - (1) -> 0 < p t <= h -> E t <= 1 -> V s t <= s * (E t - 1) + K * p t).
  { intros s t Hs Hp HE. pose proof (near (p t) (X t) (L t) ltac:(lra)) as n. rewrite Eof in n by lra. specialize (n HE). apply Rabs_le_between in n.
    unfold V, wall. assert (0 < K * p t ^ 3) by (apply Rmult_lt_0_compat; trivial; apply pow_lt; lra). destruct Hs; subst s; lra. }
  assert (ever : forall s, s = 1 \/ s = - (1) -> (forall t, 0 <= t -> 0 < p t) -> (forall t, 0 <= t -> E t <= 1) -> 0 < V s 0 -> False).
  { intros s Hs N HE V0. set (t := 2 * (1 + K) / V s 0). assert (t0 : 0 <= t) by (apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]).
    destruct (gr s (t + 1) Hs ltac:(intros; apply N; lra) ltac:(intros; apply HE; lra) V0 t ltac:(lra)) as [g1 g2].
    specialize (low s t Hs g2 (HE t t0)). assert (e : V s 0 * t = 2 * (1 + K)) by (unfold t; field; lra). pose proof (Eup 0 t ltac:(lra)).
    specialize (HE t t0).
    assert (s * (E t - 1) <= 1) by (destruct Hs; subst s; lra). assert (K * p t <= K * 1) by (apply Rmult_le_compat_l; lra). lra. }
  assert (stop : forall s T, s = 1 \/ s = - (1) -> 0 < T -> p T = 0 -> (forall t, 0 <= t < T -> 0 < p t) -> (forall t, 0 <= t < T -> E t <= 1) ->
  0 < V s 0 -> 0 < s * (E T - 1)).
  { intros s T Hs HT pT N HE V0. enough (k : - (s * (E T - 1) + K * p T) <= - V s 0) by (rewrite pT in k; lra).
    apply (ll_le (fun t => - (s * (E t - 1) + K * p t)) T _ 0); trivial.
    - apply (ll_cont (fun t => - (s * (E t - 1) + K * p t))). cont.
    - intros t Ht. destruct (gr s T Hs N HE V0 t Ht) as [g1 g2]. specialize (low s t Hs g2 (HE t Ht)).
      assert (0 <= V s 0 * t) by (apply Rmult_le_pos; lra). lra. }
  assert (two : forall t, E t <= 1 -> p t = 0 -> forall r, t <= r -> 0 <= t -> p r = 0).
  { intros t HE pt r Hr Ht. destruct (stop0 u w t pt) as [z1 z2]. destruct (table_rest_lasts x y u w S t r ltac:(lra) pt) as (_ & _ & e1 & e2).
    unfold E in HE. rewrite z1, z2 in HE. lra. now apply at_rest. }
  split; intros V0.
  - (* below *) change (0 < V (- (1)) 0) in V0.
    assert (below : forall b, (forall t, 0 <= t < b -> 0 < p t) -> forall t, 0 <= t < b -> E t < 1).
    { assert (one : forall b t, (forall t, 0 <= t < b -> 0 < p t) -> (forall r, 0 <= r <= t -> E r <= 1) -> 0 <= t < b -> E t < 1).
      { intros b t N HE Ht. destruct (HE t ltac:(lra)) as [l | e]; trivial. exfalso.
        pose proof (N t Ht) as pt.
        assert (Vt : V (- (1)) 0 <= V (- (1)) t /\ 0 < p t <= h).
        { destruct (Rle_lt_or_eq_dec 0 t ltac:(lra)) as [t0 | <-]; [ | split; [ lra | split; trivial; nra ] ].
          pose proof (reduced_spin x y u w S 0 b (Rle_refl 0) N) as R.
          assert (sm : forall r, 0 <= r < t -> 0 < p r <= h). { intros r Hr. apply (gr (- (1)) t); trivial. now right. intros; apply N; lra.
          intros; apply HE; lra. }
          assert (pth : p t <= h). { apply (left_le p h 0 t); trivial. apply cp; lra. intros r Hr. now apply sm. }
          split; [ | lra ]. apply Ropp_le_cancel. apply (ll_le (fun t => - V (- (1)) t) t _ 0); trivial.
          - apply (ll_cont (fun t => - V (- (1)) t)). destruct (r_cont _ _ _ _ _ R t ltac:(lra)) as (c1 & c2 & c3). apply continuity_pt_opp.
            now apply (wall_cont K (- (1)) p X L).
          - intros r Hr. destruct (gr (- (1)) t ltac:(now right) ltac:(intros; apply N; lra) ltac:(intros; apply HE; lra) V0 r Hr).
            assert (0 <= V (- (1)) 0 * r) by (apply Rmult_le_pos; lra). lra. }
        destruct Vt as [v1 v2]. specialize (at1 (p t) (X t) (L t) v2). rewrite (Eof t pt) in at1. specialize (at1 e). unfold V in v1 at 2. lra. }
      intros b N t Ht. apply (real_ind (fun t => E t < 1) 0 t); try lra.
      - apply (one b 0); trivial; [ | lra ]. intros r Hr. replace r with 0 by lra. exact E0.
      - intros r Hr H. assert (Er : E r <= 1). { apply (left_le E 1 0 r); [ lra | apply cE; lra | intros q Hq; left; now apply H ]. }
        apply (one b r); trivial; [ | lra ]. intros q Hq. destruct (Req_dec q r) as [-> | ne]; trivial. left. apply H. lra.
      - intros r Hr H. destruct (right_pos (fun t => 1 - E t) r (0 - 2 * p r)) as (d & d0 & Hd).
        { apply (rder_minus (fun _ => 1) E); [ rd | apply (E_rate x y u w S); lra ]. } { specialize (H r ltac:(lra)). lra. }
        exists d. split; trivial. intros q Hq. specialize (Hd q Hq). cbv beta in Hd. lra. }
    destruct (first_stop x y u w S p0) as [N | (T & T0 & pT & N)].
    + exfalso. apply (ever (- (1))); trivial. now right. intros t Ht. left. apply (below (t + 1)); [ intros; apply N | ]; lra.
    + exists T. split. lra. split; trivial. pose proof (stop (- (1)) T ltac:(now right) T0 pT N ltac:(intros; left; now apply (below T)) V0) as k.
      destruct (stop0 u w T pT) as [z1 z2]. unfold E in k. rewrite z1, z2 in k. pose proof (nrm_sq (x T) (y T)). pose proof (nrm_pos (x T) (y T)).
      nra.
  - (* above *) change (0 < V 1 0) in V0.
    apply Classical_Prop.NNPP. intros no. assert (HE : forall t, 0 <= t -> E t <= 1). { intros t Ht. apply Rnot_lt_le. intros k. apply no. exists t.
    auto. }
    destruct (first_stop x y u w S p0) as [N | (T & T0 & pT & N)].
    + apply (ever 1); auto.
    + pose proof (stop 1 T ltac:(now left) T0 pT N ltac:(intros; apply HE; lra) V0). specialize (HE T ltac:(lra)). lra.
Qed.

(* what comes to rest at s started between the walls of s *)
Lemma between_walls s : 0 < s < 1 -> exists K h, 0 < K /\ 0 < h <= 1 /\ forall x y u w T, spin x y u w -> 0 < T -> nrm (u T) (w T) = 0 ->
  nrm (x T) (y T) = s ->
  (forall t, 0 <= t < T -> 0 < nrm (u t) (w t)) -> nrm (u 0) (w 0) ^ 2 < h ^ 2 * (x 0 ^ 2 + y 0 ^ 2 - (u 0 ^ 2 + w 0 ^ 2)) ->
  Rabs (ws s (nrm (u 0) (w 0)) ((x 0 * u 0 + y 0 * w 0) * / nrm (u 0) (w 0)) ((x 0 * w 0 - y 0 * u 0) * / nrm (u 0) (w 0))) <= K * nrm (u 0) (w 0) ^
  3.
Proof.
  intros Hs. destruct (walls_rate s Hs) as (K & h & K0 & h0 & rate). exists K, h. split; trivial. split; trivial.
  intros x y u w T S T0 pT rT N Hh. 
  set (p t := nrm (u t) (w t)) in *. set (X t := (x t * u t + y t * w t) * / nrm (u t) (w t)).
  set (L t := (x t * w t - y t * u t) * / nrm (u t) (w t)).
  change (Rabs (ws s (p 0) (X 0) (L 0)) <= K * p 0 ^ 3).
  set (E t := x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) in *.
  assert (ET : E T = s ^ 2). { unfold E. destruct (stop0 u w T pT) as [-> ->]. rewrite <- rT, nrm_sq. ring. }
  assert (HE : forall t, 0 <= t < T -> E t <= s ^ 2). { intros t Ht. rewrite <- ET. apply (A_never_falls x y u w S). lra. }
  assert (s1 : s ^ 2 <= 1) by nra.
  assert (sm : forall t, 0 <= t < T -> 0 < p t <= h). { intros t Ht. split. now apply N. apply (small x y u w S h T); trivial. lra. intros r Hr.
  specialize (HE r Hr). unfold E in HE. lra. }
  pose proof (reduced_spin x y u w S 0 T (Rle_refl 0) N) as R.
  assert (Eof : forall t, 0 <= t < T -> X t ^ 2 + L t ^ 2 - p t ^ 2 = E t) by (intros t Ht; now apply (E_of x y u w), N).
  assert (one : forall g, g = 1 \/ g = - (1) -> g * ws s (p 0) (X 0) (L 0) - K * p 0 ^ 3 <= 0).
  { intros g Hg. apply Rnot_lt_le. intros k. set (V t := g * ws s (p t) (X t) (L t) - K * p t ^ 3). assert (up : forall t, 0 <= t < T -> V 0 <= V t).
    { intros t Ht. apply Ropp_le_cancel. apply (rder_stays (fun t => - V t)); [ lra | | | unfold V; lra ]; intros r Hr.
      - destruct (r_cont _ _ _ _ _ R r ltac:(lra)) as (c1 & c2 & c3). apply continuity_pt_opp. now apply (ws_cont K g s p X L).
      - destruct (r_rate _ _ _ _ _ R r ltac:(lra)) as (d1 & d2 & d3).
        destruct (rate g p X L r Hg (sm r ltac:(lra)) ltac:(rewrite Eof by lra; apply HE; lra) d1 d2 d3) as (m & Hm & km). exists (- m). split.
        now apply rder_opp. unfold V. intros. specialize (km ltac:(lra)). lra. }
    set (C := 1 + 9 * / (2 * (1 - s ^ 2))). assert (d0 : 0 < / (2 * (1 - s ^ 2))) by (apply Rinv_0_lt_compat; nra).
    assert (lim : left_lim (fun t => - (g * (E t - s ^ 2) + C * p t)) T (- (g * (E T - s ^ 2) + C * p T))).
    { apply (ll_cont (fun t => - (g * (E t - s ^ 2) + C * p t))). unfold E, p. table S. }
    assert (V0 : 0 < V 0) by exact k.
    enough (- (g * (E T - s ^ 2) + C * p T) <= - V 0) by (unfold p in H; rewrite pT, ET in H; lra).
    apply (ll_le _ _ _ 0 _ lim); trivial. intros t Ht. specialize (up t Ht). specialize (sm t Ht). pose proof (Eof t Ht) as e. specialize (HE t Ht).
    unfold V in up at 2. unfold ws in up. rewrite e in up. assert (q : 0 <= qs s (X t) <= C).
    { unfold qs, C. set (c := / (2 * (1 - s ^ 2))) in *. assert (p1 : p t ^ 2 <= 1) by nra. pose proof (pow2_ge_0 (L t)).
    pose proof (pow2_ge_0 (X t - 1)). pose proof (pow2_ge_0 (1 + X t)).
      assert (0 <= (1 + X t) ^ 2 * c) by (apply Rmult_le_pos; lra). assert ((1 + X t) ^ 2 * c <= 9 * c) by (apply Rmult_le_compat_r; lra). lra. }
    assert (0 < K * p t ^ 3) by (apply Rmult_lt_0_compat; trivial; apply pow_lt; lra).
    set (v := qs s (X t)) in *. set (n := p t) in *. assert (a1 : n * v <= 1 * C) by (apply Rmult_le_compat; lra).
    assert (a2 : n * (n * v) <= n * (1 * C)) by (apply Rmult_le_compat_l; lra).
    assert (a3 : 0 <= n * (n * v)) by (repeat apply Rmult_le_pos; lra). assert (a4 : 0 <= C * n) by (apply Rmult_le_pos; lra).
    replace (n ^ 2 * v) with (n * (n * v)) in up by ring. cbv beta. fold n. destruct Hg; subst g; lra. }
  apply Rabs_le. pose proof (one 1 ltac:(now left)). pose proof (one (- (1)) ltac:(now right)). lra.
Qed.
