(* The starts that neither come to rest inside rho = 1 nor escape fill no volume. Of two motions rho_12^2 - p_12^2, with the distances of place and
   velocity, never falls; so of two that end at the same place of the circle the places differ no more than the velocities, always: turned
   so that they end at the same place, such starts depend on velocity and angle only, by a Lipschitz function. *)
Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate TableMotions Threshold.
Import ListNotations.
Open Scope R_scope.

Lemma two_apart x1 y1 u1 w1 x2 y2 u2 w2 s t : spin x1 y1 u1 w1 -> spin x2 y2 u2 w2 -> 0 <= s <= t ->
  (x1 s - x2 s) ^ 2 + (y1 s - y2 s) ^ 2 - ((u1 s - u2 s) ^ 2 + (w1 s - w2 s) ^ 2) <=
  (x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 - ((u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^ 2).
Proof.
  intros S1 S2 Hst. apply Ropp_le_cancel. apply (rder_decr (fun t => - ((x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 - ((u1 t - u2 t) ^ 2 + (w1 t - w2 t) ^
  2)))); [ lra | | ]; intros r Hr.
  - cont; first [ apply (s_cx _ _ _ _ S1) | apply (s_cy _ _ _ _ S1) | apply (s_cu _ _ _ _ S1) | apply (s_cw _ _ _ _ S1) 
      | apply (s_cx _ _ _ _ S2) | apply (s_cy _ _ _ _ S2) | apply (s_cu _ _ _ _ S2) | apply (s_cw _ _ _ _ S2) ]; lra.
  - destruct (s_law _ _ _ _ S1 r) as (X1 & Y1 & f1 & g1 & [B1 P1] & U1 & W1); [ lra | ].
    destruct (s_law _ _ _ _ S2 r) as (X2 & Y2 & f2 & g2 & [B2 P2] & U2 & W2); [ lra | ].
    pose proof (power_bound _ _ _ (u1 r) (w1 r) Rle_0_1 B2). pose proof (power_bound _ _ _ (u2 r) (w2 r) Rle_0_1 B1).
    eexists. split. rd. simpl INR. simpl pred. rewrite !pow_1.
    match goal with |- ?g <= 0 => replace g with (2 * ((f1 * u1 r + g1 * w1 r) + (f2 * u2 r + g2 * w2 r) - (f1 * u2 r + g1 * w2 r) - (f2 * u1 r + g2
    * w1 r))) by ring end. lra.
Qed.
(* the table looks the same from every side *)
Lemma spin_turn c s x y u w : c ^ 2 + s ^ 2 = 1 -> spin x y u w ->
  spin (fun t => c * x t - s * y t) (fun t => s * x t + c * y t) (fun t => c * u t - s * w t) (fun t => s * u t + c * w t).
Proof.
  intros Hc S. split; intros t Ht; try (table S).
  destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & [B P] & U & W).
  split; [ | split ]; [ eapply rder_eq; [ rd | ring ] | eapply rder_eq; [ rd | ring ] | ].
  exists (c * fx - s * fy), (s * fx + c * fy). split; [ split | split ].
  - replace ((c * fx - s * fy) ^ 2 + (s * fx + c * fy) ^ 2) with ((c ^ 2 + s ^ 2) * (fx ^ 2 + fy ^ 2)) by ring. rewrite Hc. lra.
  - transitivity ((c ^ 2 + s ^ 2) * (fx * u t + fy * w t)). ring. rewrite Hc, P. rewrite Rmult_1_l. f_equal. unfold nrm. f_equal.
    replace ((c * u t - s * w t) ^ 2 + (s * u t + c * w t) ^ 2) with ((c ^ 2 + s ^ 2) * (u t ^ 2 + w t ^ 2)) by ring. rewrite Hc. ring.
  - eapply rder_eq. rd. ring.
  - eapply rder_eq. rd. ring.
Qed.

(* the motion from the start z comes to rest just on rho = 1, or creeps there for ever
   «the starts from which a motion comes to rest just at the distance $1$ from the axis, or creeps there for ever» *)
Definition on_edge (z : place -> R) : Prop := exists x y u w, spin x y u w /\ x 0 = z px /\ y 0 = z py /\ u 0 = z pu /\ w 0 = z pw /\
  (rests_at 1 x y u w \/ creeps x y u w).
(* the volume of cubes of starts, four numbers each; a cube is its centre and half its edge. «the volume of the cubes $l$» *)
Definition volume (l : list ((place -> R) * R)) := fold_right (fun c v => (2 * snd c) ^ 4 + v) 0 l.
(* Starts fill no volume: what of them lies in a box is covered by finitely many cubes of a total volume as small as one likes.
   «the volume of $P$ is $0$» *)
Definition no_volume (P : (place -> R) -> Prop) : Prop := forall N eps, 0 < N -> 0 < eps -> exists l, volume l <= eps /\
  forall z, P z -> (forall i, Rabs (z i) <= N) -> exists c h, In (c, h) l /\ forall i, Rabs (z i - c i) <= h.
Lemma volume_app l m : volume (l ++ m) = volume l + volume m.
Proof. induction l as [ | c l IH ]; simpl; [ ring | ]. fold (volume (l ++ m)) (volume l). rewrite IH. ring. Qed.
Lemma volume_equal l h : volume (map (fun c => (c, h)) l) = INR (length l) * (2 * h) ^ 4.
Proof.
  induction l as [ | c l IH ]; cbn [map length]. simpl. ring. rewrite S_INR. change (volume ((c, h) :: ?m)) with ((2 * h) ^ 4 + volume m).
  unfold volume in *. cbn [fold_right snd]. rewrite IH. ring.
Qed.

(* it ends at the angle th *)
Definition ends z th := exists x y u w, spin x y u w /\ x 0 = z px /\ y 0 = z py /\ u 0 = z pu /\ w 0 = z pw /\
  is_lim x p_infty (cos th) /\ is_lim y p_infty (sin th) /\ is_lim u p_infty 0 /\ is_lim w p_infty 0.
Lemma angle_of a b : a ^ 2 + b ^ 2 = 1 -> exists th, Rabs th <= 4 /\ a = cos th /\ b = sin th.
Proof.
  intros H. assert (a1 : -1 <= a <= 1) by (split; nra). pose proof (acos_bound a). pose proof PI_4. pose proof (cos_acos a a1) as c.
  pose proof (sin_acos a a1) as s.
  replace (1 - a²) with (b ^ 2) in s by (unfold Rsqr; lra). destruct (Rle_lt_dec 0 b) as [k | k].
  - exists (acos a). rewrite c, s, sqrt_pow2 by trivial. repeat split; trivial. apply Rabs_le. lra.
  - exists (- acos a). rewrite cos_neg, sin_neg, c, s. replace (b ^ 2) with ((- b) ^ 2) by ring. rewrite sqrt_pow2 by lra.
    repeat split; trivial; try ring. apply Rabs_le. lra.
Qed.
Lemma edge_ends z : on_edge z -> exists th, Rabs th <= 4 /\ ends z th.
Proof.
  intros (x & y & u & w & S & e1 & e2 & e3 & e4 & [(T & T0 & e & still) | (a & b & e & Ha & Hb & Hu & Hw & _)]).
  - assert (q : x T ^ 2 + y T ^ 2 = 1) by (rewrite <- nrm_sq, e; ring). destruct (angle_of _ _ q) as (th & H & ex & ey). exists th. split; trivial.
    exists x, y, u, w.
    assert (L : forall f (c : R), (forall t, T <= t -> f t = c) -> is_lim f p_infty c).
    { intros f c Hf. apply is_lim_spec. intros d. exists T. intros t Ht. rewrite Hf, Rminus_eq_0, Rabs_R0 by lra. apply cond_pos. }
    rewrite <- ex, <- ey. repeat (split; [ now trivial | ]). repeat split; apply L; intros t Ht; now apply still.
  - destruct (angle_of _ _ e) as (th & H & -> & ->). exists th. split; trivial. exists x, y, u, w. tauto.
Qed.
Lemma cos_abs d : Rabs (1 - cos d) <= Rabs d.
Proof. pose proof (cos_near 0 d) as k. rewrite cos_0 in k. now rewrite Rminus_0_l, Rabs_Ropp in k. Qed.
(* the place depends on velocity and angle only, and little on either *)
Lemma ends_close z z' th th' e N : ends z th -> ends z' th' -> 0 <= N -> (forall i, Rabs (z' i) <= N) -> Rabs (th - th') <= e ->
  Rabs (z pu - z' pu) <= e -> Rabs (z pw - z' pw) <= e ->
  forall i, Rabs (z i - z' i) <= (2 + 6 * N) * e.
Proof.
  intros (x & y & u & w & S & e1 & e2 & e3 & e4 & Lx & Ly & Lu & Lw) (x' & y' & u' & w' & S' & e1' & e2' & e3' & e4' & Lx' & Ly' & Lu' & Lw') HN Hz
  Ht Hu Hw.
  set (d := th - th') in *. set (c := cos d). set (s := sin d). assert (cs : c ^ 2 + s ^ 2 = 1) by (pose proof (sin2_cos2 d) as q; unfold Rsqr in q;
  unfold c, s; lra).
  assert (e0 : 0 <= e) by (pose proof (Rabs_pos d); lra). pose proof (spin_turn c s x' y' u' w' cs S') as T.
  assert (lim : forall f g (a b k l : R), is_lim f p_infty a -> is_lim g p_infty b -> is_lim (fun t => k * f t + l * g t) p_infty (k * a + l * b)).
  { intros f g a b k l Hf Hg. apply (is_lim_plus' _ _ p_infty (k * a) (l * b));
  [ apply (is_lim_scal_l f k p_infty a Hf) | apply (is_lim_scal_l g l p_infty b Hg) ]. }
  assert (D0 : (x 0 - (c * x' 0 - s * y' 0)) ^ 2 + (y 0 - (s * x' 0 + c * y' 0)) ^ 2 <= (u 0 - (c * u' 0 - s * w' 0)) ^ 2 + (w 0 - (s * u' 0 + c * w'
  0)) ^ 2).
  { assert (X : is_lim (fun t => x t - (c * x' t - s * y' t)) p_infty 0).
    { pose proof (lim x' y' _ _ c (- s) Lx' Ly') as L. pose proof (is_lim_minus' _ _ p_infty _ _ Lx L) as M.
    replace (cos th - (c * cos th' + - s * sin th')) with 0 in M.
      apply (is_lim_ext (fun t => x t - (c * x' t + - s * y' t))); trivial. intros; ring.
      replace th with (d + th') by (unfold d; ring). rewrite cos_plus. unfold c, s. ring. }
    assert (Y : is_lim (fun t => y t - (s * x' t + c * y' t)) p_infty 0).
    { pose proof (lim x' y' _ _ s c Lx' Ly') as L. pose proof (is_lim_minus' _ _ p_infty _ _ Ly L) as M.
    replace (sin th - (s * cos th' + c * sin th')) with 0 in M; trivial.
      replace th with (d + th') by (unfold d; ring). rewrite sin_plus. unfold c, s. ring. }
    enough (k : (x 0 - (c * x' 0 - s * y' 0)) ^ 2 + (y 0 - (s * x' 0 + c * y' 0)) ^ 2 - ((u 0 - (c * u' 0 - s * w' 0)) ^ 2 + (w 0 - (s * u' 0 + c *
    w' 0)) ^ 2) <= 0) by lra.
    apply le_epsilon. intros eps Heps. set (r := Rmin 1 (eps / 2)). assert (r0 : 0 < r) by (apply Rmin_pos; lra).
    assert (r1 : r <= 1) by apply Rmin_l. assert (r2 : r <= eps / 2) by apply Rmin_r.
    destruct (lim_near _ 0 r X r0) as (T1 & T10 & H1). destruct (lim_near _ 0 r Y r0) as (T2 & T20 & H2). specialize (H1 (T1 + T2) ltac:(lra)).
    specialize (H2 (T1 + T2) ltac:(lra)). cbv beta in H1, H2.
    pose proof (two_apart _ _ _ _ _ _ _ _ 0 (T1 + T2) S T ltac:(lra)) as M. cbv beta in M. eapply Rle_trans; [ exact M | ].
    set (a := x (T1 + T2) - _) in *. set (b := y (T1 + T2) - _) in *. pose proof (pow2_ge_0 (u (T1 + T2) - (c * u' (T1 + T2) - s * w' (T1 + T2)))).
    pose proof (pow2_ge_0 (w (T1 + T2) - (s * u' (T1 + T2) + c * w' (T1 + T2)))).
    assert (a ^ 2 <= r * 1) by nra. assert (b ^ 2 <= r * 1) by nra. lra. }
  rewrite e1, e2, e3, e4, e1', e2', e3', e4' in D0. clear - D0 Hz Ht Hu Hw e0 HN.
  assert (c1 : Rabs (1 - c) <= e) by (pose proof (cos_abs d); unfold c; lra). assert (s1 : Rabs s <= e) by (pose proof (sin_abs d); unfold s; lra).
  clearbody c s.
  assert (tu : forall a b, Rabs a <= N -> Rabs b <= N -> Rabs ((1 - c) * a + s * b) <= 2 * N * e).
  { intros a b Ha Hb. eapply Rle_trans; [ apply Rabs_triang | ]. rewrite !Rabs_mult.
    pose proof (Rmult_le_compat _ _ _ _ (Rabs_pos (1 - c)) (Rabs_pos a) c1 Ha). pose proof (Rmult_le_compat _ _ _ _ (Rabs_pos s) (Rabs_pos b) s1 Hb).
    lra. }
  assert (neg : forall a, Rabs a <= N -> Rabs (- a) <= N) by (intros a Ha; now rewrite Rabs_Ropp).
  pose proof (tu (z' px) (z' py) (Hz px) (Hz py)) as t1. pose proof (tu (z' py) (- z' px) (Hz py) (neg _ (Hz px))) as t2.
  pose proof (tu (z' pu) (z' pw) (Hz pu) (Hz pw)) as t3. pose proof (tu (z' pw) (- z' pu) (Hz pw) (neg _ (Hz pu))) as t4.
  apply Rabs_le_between in t1, t2, t3, t4, Hu, Hw. set (q := (1 + 2 * N) * e) in *. assert (q0 : 0 <= q) by (unfold q; apply Rmult_le_pos; lra).
  assert (uu : - q <= z pu - (c * z' pu - s * z' pw) <= q) by (unfold q; lra).
  assert (ww : - q <= z pw - (s * z' pu + c * z' pw) <= q) by (unfold q; lra).
  set (du := z pu - (c * z' pu - s * z' pw)) in *. set (dw := z pw - (s * z' pu + c * z' pw)) in *.
  assert (sq : forall d, - q <= d <= q -> d ^ 2 <= q ^ 2) by (intros; nra). pose proof (sq du uu). pose proof (sq dw ww).
  set (dx := z px - (c * z' px - s * z' py)) in *. set (dy := z py - (s * z' px + c * z' py)) in *. pose proof (pow2_ge_0 dx).
  pose proof (pow2_ge_0 dy).
  assert (ax : - (2 * q) <= dx <= 2 * q) by (split; nra). assert (ay : - (2 * q) <= dy <= 2 * q) by (split; nra).
  assert (Ne : 0 <= N * e) by (apply Rmult_le_pos; lra).
  intros []; apply Rabs_le; unfold dx, dy, q in *; split; lra.
Qed.
(* the middle of one of n equal parts of [-M, M] is close *)
Definition mid M n i := - M + (2 * INR i + 1) * (M / INR n).
Lemma locate M n a : 0 < M -> (0 < n)%nat -> Rabs a < M -> exists i, (i < n)%nat /\ Rabs (a - mid M n i) <= M / INR n.
Proof.
  intros HM Hn Ha. apply lt_0_INR in Hn. apply Rabs_def2 in Ha. set (h := M / INR n). assert (h0 : 0 < h) by now apply Rdiv_lt_0_compat.
  assert (hn : h * INR n = M) by (unfold h; field; lra).
  set (v := (a + M) / (2 * h)). assert (hv : v * (2 * h) = a + M) by (unfold v; field; lra).
  assert (v0 : 0 <= v) by (apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]).
  destruct (nfloor_ex v v0) as [i [i1 i2]]. exists i. split. { apply INR_lt. nra. } unfold mid. fold h. apply Rabs_le. split; nra.
Qed.
Lemma cover (X : Type) (Q : X -> (place -> R) -> Prop) h cells : (forall c z z', Q c z -> Q c z' -> forall i, Rabs (z i - z' i) <= h) ->
  exists l, (length l <= length cells)%nat /\ forall c z, In c cells -> Q c z -> exists q, In q l /\ forall i, Rabs (z i - q i) <= h.
Proof.
  intros H. induction cells as [ | c cells (l & Hl & IH)].
  - exists []. split. trivial. intros c z [].
  - destruct (Classical_Prop.classic (exists z, Q c z)) as [(z0 & Hz0) | no].
    + exists (z0 :: l). split. simpl. now apply le_n_S. intros c' z [<- | Hc] Hz. exists z0. split. now left. intros i. now apply (H c).
      destruct (IH c' z Hc Hz) as (q & Hq & K). exists q. split; trivial. now right.
    + exists l. split. simpl. now apply le_S. intros c' z [<- | Hc] Hz. exfalso. eauto. eauto.
Qed.
(* what depends on three numbers, of a size below M, and little on each, is covered by n^3 cubes *)
Lemma grid M n g (P : (place -> R) -> R -> R -> R -> Prop) : 0 < M -> (0 < n)%nat ->
  (forall z a b c z' a' b' c', P z a b c -> P z' a' b' c' -> Rabs (a - a') <= 2 * (M / INR n) -> Rabs (b - b') <= 2 * (M / INR n) ->
    Rabs (c - c') <= 2 * (M / INR n) -> forall i, Rabs (z i - z' i) <= g) ->
  exists l, (length l <= n * n * n)%nat /\ forall z a b c, P z a b c -> Rabs a < M -> Rabs b < M -> Rabs c < M ->
    exists q, In q l /\ forall i, Rabs (z i - q i) <= g.
Proof.
  intros HM Hn H. set (Q := fun (m : nat * nat * nat) z => exists a b c, P z a b c /\ Rabs (a - mid M n (fst (fst m))) <= M / INR n /\
    Rabs (b - mid M n (snd (fst m))) <= M / INR n /\ Rabs (c - mid M n (snd m)) <= M / INR n).
  destruct (cover _ Q g (list_prod (list_prod (seq 0 n) (seq 0 n)) (seq 0 n))) as (l & Hl & K).
  { intros m z z' (a & b & c & E1 & a1 & a2 & a3) (a' & b' & c' & E2 & b1 & b2 & b3). apply Rabs_le_between in a1, a2, a3, b1, b2, b3.
    apply (H z a b c z' a' b' c'); trivial; apply Rabs_le; lra. }
  exists l. split. now rewrite !prod_length, !seq_length in Hl. intros z a b c Hz Ha Hb Hc.
  destruct (locate M n a HM Hn Ha) as (i1 & j1 & k1). destruct (locate M n b HM Hn Hb) as (i2 & j2 & k2).
  destruct (locate M n c HM Hn Hc) as (i3 & j3 & k3).
  apply (K (i1, i2, i3)); [ | now exists a, b, c ]. repeat apply in_prod; apply in_seq; simpl; split; auto using Nat.le_0_l.
Qed.
Lemma fine_enough M k eps : 0 < M -> 0 < k -> 0 < eps -> exists n, (0 < n)%nat /\ forall l : list (place -> R), (length l <= n * n * n)%nat ->
  volume (map (fun c => (c, k * (2 * (M / INR n)))) l) <= eps.
Proof.
  intros HM Hk He. set (K := (4 * k * M) ^ 4). assert (K0 : 0 < K) by (apply pow_lt; repeat apply Rmult_lt_0_compat; lra).
  destruct (nfloor_ex (K / eps)) as [m [_ m2]]. { left. now apply Rdiv_lt_0_compat. } set (n := S m). exists n. split. apply Nat.lt_0_succ.
  assert (nn : INR n = INR m + 1) by apply S_INR. assert (n0 : 0 < INR n) by (rewrite nn; pose proof (pos_INR m); lra).
  assert (Kn : K <= eps * INR n). { rewrite nn. replace K with (K / eps * eps) by (field; lra). rewrite Rmult_comm. apply Rmult_le_compat_l; lra. }
  intros l Hl. rewrite volume_equal. apply le_INR in Hl. rewrite !mult_INR in Hl.
  assert (h4 : 0 <= (2 * (k * (2 * (M / INR n)))) ^ 4) by (apply pow_le; repeat apply Rmult_le_pos; try lra; left; now apply Rinv_0_lt_compat).
  eapply Rle_trans. apply Rmult_le_compat_r; [ exact h4 | exact Hl ]. apply (Rmult_le_reg_r (INR n)); trivial.
  eapply Rle_trans; [ right | exact Kn ]. unfold K. field. lra.
Qed.
Lemma covered l h z : (exists q, In q l /\ forall i, Rabs (z i - q i) <= h) -> exists c h', In (c, h') (map (fun c => (c, h)) l) /\
  forall i : place, Rabs (z i - c i) <= h'.
Proof. intros (q & Hq & K). exists q, h. split; trivial. apply in_map_iff. now exists q. Qed.
Theorem edge_thin : no_volume on_edge.
Proof.
  intros N eps HN Heps. destruct (fine_enough (N + 5) (2 + 6 * N) eps) as (n & Hn & V); try lra.
  destruct (grid (N + 5) n ((2 + 6 * N) * (2 * ((N + 5) / INR n))) (fun z a b c => ends z a /\ (forall i, Rabs (z i) <= N) /\ z pu = b /\ z pw = c))
    as (l & Hl & H); [ lra | trivial | | ].
  { intros z a b c z' a' b' c' (E1 & B1 & <- & <-) (E2 & B2 & <- & <-) h1 h2 h3. apply (ends_close z z' a a'); trivial; lra. }
  eexists. split; [ exact (V l Hl) | ]. intros z Hz B. destruct (edge_ends z Hz) as (th & t4 & Hth). apply covered.
  pose proof (B pu). pose proof (B pw). apply (H z th (z pu) (z pw)); try lra. auto.
Qed.
