(* Section 4: rest on the turntable, and what becomes of a motion. Units: mu g = Omega = 1, so that every number here has no dimension. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Formulas TableLaws Sphere Fate TableMotions TableAngle Stops Threshold Thin Late Near
  Arrives AngleAtRest LastMoments Starts StraightIn Critical.
Open Scope R_scope.

Lemma within a b : nrm a b <= eq139_largest_sigma <-> a ^ 2 + b ^ 2 <= 1.
Proof. unfold eq139_largest_sigma. pose proof (nrm_sq a b). pose proof (nrm_pos a b). split; nra. Qed.

(* (139): rest at a place is a motion exactly where its distance from the axis is at most 1 *)
Theorem eq_139 a b : spin (fun _ => a) (fun _ => b) (fun _ => 0) (fun _ => 0) <-> nrm a b <= eq139_largest_sigma.
Proof. rewrite within. apply rest_radius. Qed.

(* Who is at rest for a while is at a distance of at most 1; and who has no speed there stays for ever. *)
Theorem s4_rest_radius x y u w (S : spin x y u w) :
  (forall s d, 0 <= s -> 0 < d -> (forall t, s <= t < s + d -> nrm (u t) (w t) = 0) -> nrm (x s) (y s) <= eq139_largest_sigma) /\
  (forall s t, 0 <= s <= t -> nrm (u s) (w s) = 0 -> nrm (x s) (y s) <= eq139_largest_sigma -> x t = x s /\ y t = y s /\ u t = 0 /\ w t = 0).
Proof.
  split.
  - intros s d Hs Hd K. apply within. exact (table_rest_needs x y u w S s d Hs Hd K).
  - intros s t Hs z K. apply (table_rest_lasts x y u w S s t Hs z). now apply within.
Qed.
Lemma s4_rest_radius__occurs : ltac:(occurs s4_rest_radius).
Proof. intros H. destruct (table_exists 2 0 1 0) as (x & y & u & w & S & _). exact (H x y u w S). Qed.

(* The critical radius is 0.8720...: a particle put down at rest in the laboratory at 0.872 comes to rest on the table inside the distance 1; put down
   at 0.8721 it escapes; at every radius there is such a motion; and for some radius between it does neither, it comes to rest just on rho = 1 or creeps there for ever. *)
Theorem s4_rest_radius__critical :
  (forall r, exists X Y U W x y u w, put_down X Y U W x y u w /\ X 0 = r /\ Y 0 = 0) /\
  (forall X Y U W x y u w, put_down X Y U W x y u w ->
    (nrm (X 0) (Y 0) = 0.872 -> exists s, s < eq139_largest_sigma /\ rests_at s x y u w) /\ (nrm (X 0) (Y 0) = 0.8721 -> escapes x y)) /\
  exists r, 0.872 < r < 0.8721 /\ forall X Y U W x y u w, put_down X Y U W x y u w -> nrm (X 0) (Y 0) = r ->
    rests_at eq139_largest_sigma x y u w \/ creeps x y u w.
Proof.
  unfold eq139_largest_sigma. split; [ exact put_down_exists | split ].
  - intros X Y U W x y u w P. split; intros e; destruct (on_axis X Y U W x y u w P) as (S & x' & y' & u' & w' & A & N); try lra; rewrite e in A.
    + apply caught_rests; trivial. destruct (inner_start _ _ _ _ A) as (t & Ht & K). exists t. destruct (N t) as [<- <-]. now split.
    + apply (free_escapes x y u w); trivial. destruct (outer_start _ _ _ _ A) as (t & Ht & K). exists t. destruct (N t) as [<- <-]. now split.
  - destruct border as (r & Hr & K). exists r. split; trivial. intros X Y U W x y u w P e.
    destruct (on_axis X Y U W x y u w P) as (S & x' & y' & u' & w' & A & N). lra. rewrite e in A.
    destruct (neither x y u w 1 S ltac:(lra)) as [k | [_ k]]; auto. intros t Ht. destruct (N t) as [<- <-]. now apply (K x' y' u' w').
Qed.

(* From every start there is a motion. Every motion comes to rest, goes farther than any distance for good, or creeps towards a place of rho = 1
   for ever. The starts of those that creep, and of those that come to rest just on rho = 1, fill no volume. *)
Theorem s4_dichotomy :
  (forall x0 y0 u0 w0, exists x y u w, spin x y u w /\ x 0 = x0 /\ y 0 = y0 /\ u 0 = u0 /\ w 0 = w0) /\
  (forall x y u w, spin x y u w -> (exists s, s <= eq139_largest_sigma /\ rests_at s x y u w) \/ escapes x y \/ creeps x y u w) /\
  no_volume on_edge.
Proof. exact (conj table_exists (conj fates edge_thin)). Qed.

(* ---- how a particle comes to rest ---- *)
Section NearRest.
Variables (x y u w A alpha psi : R -> R) (sigma T : R).
Hypothesis table : spin x y u w.
Hypothesis rest : comes_to_rest sigma T x y u w A alpha psi.

(* alpha and psi tend to zero, and the particle stops inside the distance 1 - unless it comes straight in, with |psi| -> pi; the starts of those that
   do so fill no volume *)
Theorem s4_near_rest : left_lim alpha T s4_near_rest_limits_1 /\
  ((left_lim psi T s4_near_rest_limits_2 /\ 0 < sigma < eq139_largest_sigma) \/
    left_lim (fun t => Rabs (psi t)) T PI /\ straight_starts (start_of x y u w)) /\
  no_volume straight_starts.
Proof.
  pose proof (sigma_pos x y u w A alpha psi sigma T table rest). split; [ apply (A_to x y u w A alpha psi sigma T table rest) | split;
    [ | exact straight_thin ] ].
  destruct (psi_ends x y u w A alpha psi sigma T table rest) as [[L s1] | L]; [ left | right ]; repeat split; trivial.
  exists x, y, u, w, psi, T. destruct (c_slips _ _ _ _ _ _ _ _ _ rest) as [T0 N]. destruct (c_rest _ _ _ _ _ _ _ _ _ rest) as [z _].
  do 7 (split; [ now trivial | ]). split; trivial. intros t Ht. split. now apply N. apply (c_psi _ _ _ _ _ _ _ _ _ rest). lra.
Qed.

Hypothesis not_straight : left_lim psi T 0.
Lemma inside : 0 < sigma < 1.
Proof.
  split. exact (sigma_pos x y u w A alpha psi sigma T table rest). destruct (psi_ends x y u w A alpha psi sigma T table rest) as [[_ s1] | L];
  trivial. exfalso.
  enough (PI = 0) by (pose proof PI_RGT_0; lra). apply (ll_uniq _ _ _ _ L). rewrite <- Rabs_R0.
  apply (ll_comp Rabs psi T 0 not_straight), Rcontinuity_abs.
Qed.
Lemma rate_is f f' g s s' : s < T -> s' < T -> (forall t, s <= t < T -> rder f t (g t)) -> (forall t, s' <= t < T -> rder f t (f' t)) ->
  soon T (fun t => f' t = g t).
Proof.
  intros Hs Hs' G F. generalize (soon_and _ _ _ (soon_after s T _ Hs G) (soon_after s' T _ Hs' F)). apply soon_imp. intros t (d1 & d2).
  exact (rder_unique _ _ _ _ d2 d1).
Qed.
Lemma known s0 : s0 < T -> exists s, arrives sigma s T A alpha psi /\
  (forall f', (forall t, s0 <= t < T -> rder alpha t (f' t)) -> soon T (fun t => f' t = eq114_alpha_rate (A t) (alpha t) (psi t))) /\
  (forall f', (forall t, s0 <= t < T -> rder psi t (f' t)) -> soon T (fun t => f' t = eq115_psi_rate (alpha t) (psi t))) /\
  (forall f', (forall t, s0 <= t < T -> rder A t (f' t)) -> soon T (fun t => f' t = eq113_a_rate (alpha t))).
Proof.
  intros Hs0. destruct (arriving x y u w A alpha psi sigma T table rest not_straight) as (s & Hs & V). exists s. split; trivial.
  repeat split; intros f'; apply (rate_is _ _ _ s s0 (proj2 Hs) Hs0); intros t Ht; apply (v_rate _ _ _ _ _ _ V t Ht).
Qed.
Lemma T_after : 0 < T. Proof. exact (T_pos x y u w A alpha psi sigma T rest). Qed.
Ltac arrive s0 := destruct (known s0 ltac:(first [ assumption | exact T_after ])) as (r & V & Ka & Kp & KA); pose proof inside as In.
(* (140): the rate of alpha tends to 1 - 1/sigma *)
Theorem eq_140 dalpha s (before : s < T) (rate_alpha : forall t, s <= t < T -> rder alpha t (dalpha t)) : left_lim dalpha T (eq140_alpha_rate sigma).
Proof. arrive s. pose proof (Ka _ rate_alpha) as D. exact (ll_soon _ _ _ _ D (dal_limit _ _ _ _ _ _ In V)). Qed.
(* (141): the ratio of alpha to its law, with the time counted from the rest, tends to 1 *)
Theorem eq_141 : left_lim (fun t => alpha t / eq141_alpha sigma (t - T)) T 1.
Proof. arrive 0. exact (alpha_limit _ _ _ _ _ _ In V). Qed.
(* (142): its sides differ by less and less, measured by 1 + |psi|/alpha; for a rest beyond sigma = 1/4 also as they stand *)
Theorem eq_142 dalpha dpsi s (before : s < T) (rate_alpha : forall t, s <= t < T -> rder alpha t (dalpha t))
  (rate_psi : forall t, s <= t < T -> rder psi t (dpsi t)) :
  left_lim (fun t => (eq142_left sigma (dpsi t / dalpha t) - eq142_right (alpha t) (psi t)) / (1 + Rabs (psi t) / alpha t)) T 0 /\
  (/ 4 < sigma -> left_lim (fun t => eq142_left sigma (dpsi t / dalpha t) - eq142_right (alpha t) (psi t)) T 0).
Proof.
  arrive s. pose proof (Ka _ rate_alpha) as D. apply Kp in rate_psi. pose proof (soon_and _ _ _ D rate_psi) as E. split.
  - refine (ll_soon _ _ _ _ _ (psi_law _ _ _ _ _ _ In V)). revert E. apply soon_imp. intros t (-> & ->). reflexivity.
  - intros q. refine (ll_soon _ _ _ _ _ (psi_law_plain _ _ _ _ _ _ In V q)). revert E. apply soon_imp. intros t (-> & ->). reflexivity.
Qed.
(* (143): for a constant c, psi differs from its law by what is small beside either of its terms, of the orders alpha and alpha^(sigma/(1 - sigma)) *)
Theorem eq_143 : / 4 < sigma < 3 / 4 -> sigma <> / 2 -> exists c, left_lim (fun t => (psi t - eq143_psi sigma c (alpha t)) / alpha t) T 0 /\
  left_lim (fun t => (psi t - eq143_psi sigma c (alpha t)) / (alpha t * Rpower (alpha t) (eq143_exponent sigma))) T 0.
Proof.
  intros q h. arrive 0. destruct (psi_solution _ _ _ _ _ _ In V q h) as (c & D & D0 & B). exists c. set (k := sigma / (1 - sigma)) in *.
  pose proof (al_soon _ _ _ _ _ _ V) as a0. pose proof (v_al _ _ _ _ _ _ V) as al0.
  assert (kb : / 3 < k < 3) by (unfold k; split; [ apply Rlt_div_r | apply Rlt_div_l ]; lra).
  assert (m : 1 < 3 * Rmin 1 k /\ k < 3 * Rmin 1 k) by (unfold Rmin; destruct (Rle_dec 1 k); lra). set (b := 3 * Rmin 1 k) in *.
  assert (to : forall a, a < b -> left_lim (fun t => (psi t - eq143_psi sigma c (alpha t)) / Rpower (alpha t) a) T 0).
  { intros a ab. apply (ll_squeeze _ (fun t => D * Rpower (alpha t) (b - a))).
    - generalize (soon_and _ _ _ a0 B). apply soon_imp. intros t (p & q'). unfold Rdiv.
      rewrite Rabs_mult, <- Rpower_Ropp, (Rabs_pos_eq (Rpower _ _)) by (left; apply power_pos).
      unfold Rminus at 2. rewrite Rpower_plus, <- Rmult_assoc. apply Rmult_le_compat_r; [ left; apply power_pos | exact q' ].
    - eapply ll_eq. apply (ll_mult (fun _ => D)); [ apply ll_const | apply (ll_power alpha T (b - a) a0 al0); lra ]. ring. }
  split; [ apply (ll_soon (fun t => (psi t - eq143_psi sigma c (alpha t)) / Rpower (alpha t) 1)) | apply (ll_soon (fun t => (psi t - eq143_psi sigma
  c (alpha t)) / Rpower (alpha t) k)) ];
    try (apply to; tauto); revert a0; apply soon_imp; intros t p. now rewrite Rpower_1.
  f_equal. rewrite <- (Rpower_1 (alpha t)) at 1 by trivial. rewrite <- Rpower_plus. f_equal. unfold eq143_exponent, k. field. lra.
Qed.
(* at sigma = 1/2, where both terms of (143) are infinite: psi = 2 alpha (c - ln alpha), up to what is small beside alpha *)
Theorem eq_143__one_half : sigma = / 2 -> exists c, left_lim (fun t => (psi t - right_rest_psi_at_one_half c (alpha t)) / alpha t) T 0.
Proof.
  intros h. arrive 0. destruct (psi_one_half _ _ _ _ _ _ In V h) as (c & D & D0 & B). exists c. pose proof (al_soon _ _ _ _ _ _ V) as a0.
  pose proof (v_al _ _ _ _ _ _ V) as al0.
  apply (ll_squeeze _ (fun t => D * Rpower (alpha t) (3 / 2 - 1))). 2: { eapply ll_eq.
  apply (ll_mult (fun _ => D)); [ apply ll_const | apply (ll_power alpha T _ a0 al0); lra ]. ring. }
  generalize (soon_and _ _ _ a0 B). apply soon_imp. intros t (p & q). unfold Rdiv at 1.
  rewrite Rabs_mult, (Rabs_pos_eq (/ alpha t)) by (left; now apply Rinv_0_lt_compat).
  unfold Rminus at 2. rewrite Rpower_plus, Rpower_Ropp, Rpower_1, <- Rmult_assoc by trivial.
  apply Rmult_le_compat_r; [ left; now apply Rinv_0_lt_compat | exact q ].
Qed.
(* (144): the ratio of its sides tends to 1 *)
Theorem eq_144 dalpha dA s (before : s < T) (rate_alpha : forall t, s <= t < T -> rder alpha t (dalpha t))
  (rate_A : forall t, s <= t < T -> rder A t (dA t)) :
  left_lim (fun t => eq144_left sigma (dA t / dalpha t) / eq144_right (alpha t)) T 1.
Proof.
  arrive s. pose proof (Ka _ rate_alpha) as D. apply KA in rate_A. refine (ll_soon _ _ _ _ _ (A_law _ _ _ _ _ _ In V)).
  generalize (soon_and _ _ _ D rate_A). apply soon_imp. intros t (-> & ->). reflexivity.
Qed.
(* (145): A tends to sigma, and differs from its law by what is small beside alpha^2 *)
Theorem eq_145 : left_lim A T sigma /\ left_lim (fun t => (A t - eq145_a sigma (alpha t)) / alpha t ^ 2) T 0.
Proof.
  arrive 0. split. apply V. pose proof (A_limit _ _ _ _ _ _ In V) as L. apply (ll_soon (fun t => (A t - sigma) / alpha t ^ 2 - sigma / (sigma - 1) /
  2)).
  - generalize (al_soon _ _ _ _ _ _ V). apply soon_imp. intros t a0. unfold eq145_a. field. lra.
  - eapply ll_eq. apply ll_minus; [ exact L | apply ll_const ]. ring.
Qed.
End NearRest.

(* Taken as a function of alpha the right side of (143) solves (142), for every constant c *)
Theorem eq_143__solves sigma c alpha : 0 < sigma < 1 -> sigma <> / 2 -> 0 < alpha -> exists slope, is_derive (eq143_psi sigma c) alpha slope /\
  eq142_left sigma slope = eq142_right alpha (eq143_psi sigma c alpha).
Proof.
  intros Hs h a0. exists (2 * (sigma / (2 * sigma - 1)) + 2 * c * (sigma / (1 - sigma)) * Rpower alpha ((2 * sigma - 1) / (1 - sigma))). split.
  - unfold eq143_psi, Rpower. auto_derive; trivial. field. repeat split; lra.
  - unfold eq142_left, eq142_right, eq143_psi. field. repeat split; lra.
Qed.

(* ---- starts with small alpha ---- *)
Lemma off_145 sigma alpha psi : 0 < sigma < 1 -> right_rest_surface_a sigma alpha psi - eq145_a sigma alpha =
  sigma ^ 2 * alpha ^ 2 * / (4 * (1 - sigma ^ 2)) * ((1 - cos psi) * (2 + sigma + sigma * cos psi)).
Proof.
  intros Hs. pose proof (bend_q sigma psi Hs) as e. unfold right_rest_surface_a, eq145_a in *. rewrite pow1 in e. set (b := (_ / _ + _) + _) in *.
  replace (sigma * alpha ^ 2 * b) with (alpha ^ 2 * (sigma - (sigma - sigma * 1 * b))) by ring. rewrite e. field. repeat split; nra.
Qed.
(* The starts from which the particle comes to rest at sigma lie on the corrected surface, up to alpha^3, whatever psi is,
   and there is one for each alpha and psi; for
   small psi it is (145) *)
Theorem s4_psi_free sigma : 0 < sigma < 1 -> exists K alpha0, 0 < K /\ 0 < alpha0 /\ forall alpha psi, 0 < alpha < alpha0 ->
  (forall A x y u w, 0 < A -> from A alpha psi x y u w -> rests_at sigma x y u w ->
  Rabs (A - right_rest_surface_a sigma alpha psi) <= K * alpha ^ 3) /\
  (exists A x y u w, 0 < A /\ from A alpha psi x y u w /\ rests_at sigma x y u w) /\
  Rabs (right_rest_surface_a sigma alpha psi - eq145_a sigma alpha) <= K * (alpha * psi) ^ 2.
Proof.
  intros Hs. destruct (on_surface sigma Hs) as (K & a0 & K0 & Ha & H). assert (i0 : 0 < / (1 - sigma ^ 2)) by (apply Rinv_0_lt_compat; nra).
  exists (K + / (1 - sigma ^ 2)), a0. split. lra. split. lra.
  intros alpha psi Hal. assert (0 < alpha ^ 3) by (apply pow_lt; lra). split; [ | split ].
  - intros A x y u w A0 F R. specialize (H A alpha psi x y u w A0 Hal F R). nra.
  - destruct (between sigma alpha psi ltac:(lra) ltac:(lra)) as (A & x & y & u & w & A0 & F & B). exists A, x, y, u, w. split; trivial.
    split; trivial.
    destruct (neither x y u w sigma (proj1 F) ltac:(lra) B) as [R | [e _]]; [ exact R | lra ].
  - pose proof (off_145 sigma alpha psi Hs) as q.
    rewrite q, !Rabs_mult. pose proof (cos_quadratic psi) as c. rewrite Rabs_minus_sym in c. pose proof (COS_bound psi).
    rewrite (Rabs_pos_eq (2 + _ + _)) by nra.
    rewrite (Rabs_pos_eq (sigma ^ 2)), (Rabs_pos_eq (alpha ^ 2)) by apply pow2_ge_0.
    rewrite (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; nra). rewrite Rpow_mult_distr, Rinv_mult_distr by nra.
    assert (c4 : Rabs (1 - cos psi) * (2 + sigma + sigma * cos psi) <= psi ^ 2 * 4) by (apply Rmult_le_compat; try apply Rabs_pos; nra).
    set (i := / (1 - sigma ^ 2)) in *. assert (P : 0 <= alpha ^ 2 * i) by (apply Rmult_le_pos; [ apply pow2_ge_0 | lra ]).
    assert (p2 : 0 <= alpha ^ 2 * psi ^ 2) by (rewrite <- Rpow_mult_distr; apply pow2_ge_0).
    apply Rle_trans with (1 * (alpha ^ 2 * i) * / 4 * (psi ^ 2 * 4)).
    + replace (sigma ^ 2 * alpha ^ 2 * (/ 4 * i)) with (sigma ^ 2 * (alpha ^ 2 * i) * / 4) by ring. apply Rmult_le_compat; trivial. nra.
      apply Rmult_le_pos; [ apply Rabs_pos | nra ]. apply Rmult_le_compat_r. lra. apply Rmult_le_compat_r; nra.
    + nra.
Qed.
(* (145) with any other psi misses that surface, and with it every start with rest at sigma, by a fixed multiple of alpha^2 at least *)
Theorem s4_psi_free__printed sigma psi : 0 < sigma < 1 ->
  (forall alpha, 0 < alpha -> (right_rest_surface_a sigma alpha psi = eq145_a sigma alpha <-> cos psi = 1)) /\
  (cos psi <> 1 -> exists c alpha0, 0 < c /\ 0 < alpha0 /\ forall alpha A x y u w, 0 < alpha < alpha0 -> 0 < A -> from A alpha psi x y u w ->
    rests_at sigma x y u w -> c * alpha ^ 2 <= Rabs (A - eq145_a sigma alpha)).
Proof.
  intros Hs. pose proof (COS_bound psi). assert (i0 : 0 < / (4 * (1 - sigma ^ 2))) by (apply Rinv_0_lt_compat; nra).
  set (k := sigma ^ 2 * / (4 * (1 - sigma ^ 2)) * (2 + sigma + sigma * cos psi)).
  assert (k0 : 0 < k) by (unfold k; repeat apply Rmult_lt_0_compat; nra).
  assert (q : forall alpha, right_rest_surface_a sigma alpha psi - eq145_a sigma alpha = k * (1 - cos psi) * alpha ^ 2).
  { intros alpha. rewrite off_145 by trivial. unfold k. ring. }
  split.
  - intros alpha a0. specialize (q alpha). assert (P : 0 < k * alpha ^ 2) by (apply Rmult_lt_0_compat; nra).
    split; intros z; [ | rewrite z in q; lra ].
    assert (z2 : k * alpha ^ 2 * (1 - cos psi) = 0) by lra. apply Rmult_integral in z2. lra.
  - intros n. destruct (on_surface sigma Hs) as (K & a0 & K0 & Ha & H0). set (c := k * (1 - cos psi)) in *.
    assert (c0 : 0 < c) by (apply Rmult_lt_0_compat; lra). exists (c / 2), (Rmin a0 (c / (2 * K))).
    split. lra. split. apply Rmin_pos; [ lra | apply Rdiv_lt_0_compat; lra ]. intros alpha A x y u w Hal A0 F R.
    pose proof (Rmin_l a0 (c / (2 * K))). pose proof (Rmin_r a0 (c / (2 * K))). specialize (H0 A alpha psi x y u w A0 ltac:(lra) F R).
    assert (e : alpha * K <= c / 2). { replace (c / 2) with (c / (2 * K) * K) by (field; lra). apply Rmult_le_compat_r; lra. }
    assert (a2 : 0 < alpha ^ 2) by (apply pow_lt; lra). assert (small : K * alpha ^ 3 <= c / 2 * alpha ^ 2) by nra.
    specialize (q alpha). apply Rabs_le_between in H0. eapply Rle_trans; [ | apply Rle_abs ]. lra.
Qed.
(* The corrected boundary between rest and escape, for small alpha and every psi: below it by more than K alpha^3 the particle comes to rest inside
   the distance 1, above
   by more it escapes; for each alpha and psi there is an A between from which it creeps towards rho = 1 for ever,
   or comes straight in and stops there *)
Theorem s4_envelope_is_boundary : exists K alpha0, 0 < K /\ 0 < alpha0 /\ forall alpha psi, 0 < alpha < alpha0 ->
  (forall A x y u w, 0 < A -> from A alpha psi x y u w ->
    (A < right_rest_boundary_a alpha psi - K * alpha ^ 3 -> exists s, s < 1 /\ rests_at s x y u w) /\
    (right_rest_boundary_a alpha psi + K * alpha ^ 3 < A -> escapes x y)) /\
  (exists A x y u w, 0 < A /\ Rabs (A - right_rest_boundary_a alpha psi) <= K * alpha ^ 3 /\ from A alpha psi x y u w /\
    (creeps x y u w \/ exists T, 0 < T /\ nrm (x T) (y T) = 1 /\ (forall t, T <= t -> x t = x T /\ y t = y T) /\ straight_in T x y u w)).
Proof.
  destruct walls as (K & a0 & K0 & Ha & H). exists K, a0. split; trivial. split. lra. intros alpha psi Hal. split.
  - intros A x y u w A0 F. destruct (H A alpha psi x y u w A0 Hal F) as [d1 d2]. split; intros k.
    + destruct (d1 k) as (T & T0 & z & r). exists (nrm (x T) (y T)). split; trivial. apply (rests_from x y u w (proj1 F) T T0 z). lra.
    + destruct (d2 k) as (T & T0 & e). exact (escapes_from x y u w (proj1 F) T T0 e).
  - destruct (between 1 alpha psi ltac:(lra) ltac:(lra)) as (A & x & y & u & w & A0 & F & B). exists A, x, y, u, w.
    destruct (H A alpha psi x y u w A0 Hal F) as [d1 d2].
    split; trivial. split; [ | split; trivial ].
    + apply Rabs_le. split; apply Rnot_lt_le; intros k.
      * destruct (d1 ltac:(lra)) as (T & T0 & z & r). destruct (B T T0) as [b _]. lra.
      * destruct (d2 ltac:(lra)) as (T & T0 & e). destruct (B T T0) as [_ b]. rewrite !nrm_sq in b. lra.
    + destruct (neither x y u w 1 (proj1 F) ltac:(lra) B) as [R | [_ c]]; [ right | now left ].
      destruct (values A alpha psi x y u w A0 ltac:(lra) F) as (ep & s0 & _).
      destruct (stops_for_good 1 x y u w (proj1 F) ltac:(lra) ltac:(rewrite ep; nra) R) as (T & T0 & z & e & N). exists T. split; trivial.
      split; trivial. split.
      * intros t Ht. destruct (table_rest_lasts x y u w (proj1 F) T t ltac:(lra) z) as (e1 & e2 & _); [ rewrite <- nrm_sq, e; lra | now split ].
      * exact (straight_at_one x y u w T (proj1 F) T0 z e N).
Qed.
(* there are motions from every such start *)
Lemma s4_envelope_is_boundary__occurs A alpha psi : 0 < A -> 0 < alpha -> exists x y u w, from A alpha psi x y u w.
Proof. intros A0 a0. do 4 eexists. exact (start_from A alpha psi ltac:(lra) a0). Qed.
(* (146), of the motion to lowest order in 1 - A and alpha, dA/dt = alpha and dalpha/dt = A - 1: the surface of the starts with rest at sigma,
   and its slope *)
Theorem eq_146__saddle A alpha T sigma : sigma < 1 -> 0 <= T -> (forall t, 0 < t <= T -> continuity_pt A t /\ continuity_pt alpha t) ->
  (forall t, 0 <= t < T -> rder A t (alpha t) /\ rder alpha t (A t - 1)) -> A T = sigma -> alpha T = 0 -> A 0 < 1 ->
  let surface s := 1 - sqrt ((1 - s) ^ 2 + alpha 0 ^ 2) in A 0 = surface sigma /\ is_derive surface sigma (right_rest_surface_slope sigma (alpha 0)).
Proof.
  intros Hs HT C D eA ea A1 surface. assert (P : 0 < (1 - sigma) ^ 2 + alpha 0 ^ 2) by (pose proof (pow2_ge_0 (alpha 0)); nra). split.
  - assert (k : (A T - 1) ^ 2 - alpha T ^ 2 = (A 0 - 1) ^ 2 - alpha 0 ^ 2).
    { apply (rder_const (fun t => (A t - 1) ^ 2 - alpha t ^ 2)); trivial; intros t Ht. destruct (C t Ht). contq. destruct (D t Ht). eapply rder_eq.
    rdq. simpl. ring. }
    unfold surface. rewrite eA, ea in k. replace ((1 - sigma) ^ 2 + alpha 0 ^ 2) with ((1 - A 0) ^ 2) by lra. rewrite sqrt_pow2; lra.
  - unfold surface, right_rest_surface_slope. auto_derive. lra.
    replace ((1 + - sigma) * ((1 + - sigma) * 1) + alpha 0 * (alpha 0 * 1)) with ((1 - sigma) ^ 2 + alpha 0 ^ 2) by ring. field.
    apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.
(* (146) as printed is the derivative of (145); where it vanishes, at alpha = sqrt 2 (1 - sigma), the slope of that surface is 1/sqrt 3 *)
Theorem eq_146__printed sigma alpha : sigma < 1 -> is_derive (fun s => eq145_a s alpha) sigma (eq146_right sigma alpha) /\
  eq146_right sigma (sqrt 2 * (1 - sigma)) = 0 /\ right_rest_surface_slope sigma (sqrt 2 * (1 - sigma)) = / sqrt 3.
Proof.
  intros Hs. assert (e : sqrt 2 ^ 2 = 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra). unfold eq145_a, eq146_right, right_rest_surface_slope.
  rewrite Rpow_mult_distr, e. split; [ | split ].
  - auto_derive. lra. field. lra.
  - field. lra.
  - replace ((1 - sigma) ^ 2 + 2 * (1 - sigma) ^ 2) with (3 * (1 - sigma) ^ 2) by ring. rewrite sqrt_mult, sqrt_pow2 by nra. field. split; [ | lra ].
    apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.
(* Where that boundary is lowest over psi, in place of (147): below 1 - alpha + 7/6 alpha^2 by more than K alpha^3 the particle comes to rest,
   whatever psi is; with
   psi = 2 alpha it escapes from above by more *)
Theorem eq_147 : exists K alpha0, 0 < K /\ 0 < alpha0 /\ forall A alpha psi x y u w, 0 < A -> 0 < alpha < alpha0 -> from A alpha psi x y u w ->
  (A < right_rest_boundary_least alpha - K * alpha ^ 3 -> exists s, s < 1 /\ rests_at s x y u w) /\
  (psi = 2 * alpha -> right_rest_boundary_least alpha + K * alpha ^ 3 < A -> escapes x y).
Proof.
  destruct s4_envelope_is_boundary as (K & a0 & K0 & Ha & H). exists (K + 18), a0. split. lra. split; trivial. intros A alpha psi x y u w A0 Hal F.
  destruct (H alpha psi Hal) as [H1 _]. destruct (H1 A x y u w A0 F) as [d1 d2]. destruct (boundary_low alpha psi ltac:(lra)) as [l1 l2].
  assert (0 < alpha ^ 3) by (apply pow_lt; lra). split.
  - intros k. apply d1. lra.
  - intros e k. apply d2. specialize (l2 e). lra.
Qed.
(* (147) as printed is not the boundary: whatever psi is, from some A above it the particle comes to rest *)
Theorem eq_147__printed : exists alpha0, 0 < alpha0 /\ forall alpha psi, 0 < alpha < alpha0 -> eq147_a alpha < 1 - 11 / 10 * alpha /\
  forall A x y u w, eq147_a alpha < A < 1 - 11 / 10 * alpha -> from A alpha psi x y u w -> exists s, s < 1 /\ rests_at s x y u w.
Proof.
  destruct eq_147 as (K & a0 & K0 & Ha & H). assert (i0 : 0 < / (10 * (K + 1))) by (apply Rinv_0_lt_compat; lra).
  exists (Rmin (Rmin a0 (/ 2)) (/ (10 * (K + 1)))). split. repeat apply Rmin_pos; lra.
  intros alpha psi Hal. pose proof (Rmin_l (Rmin a0 (/ 2)) (/ (10 * (K + 1)))). pose proof (Rmin_r (Rmin a0 (/ 2)) (/ (10 * (K + 1)))).
  pose proof (Rmin_l a0 (/ 2)). pose proof (Rmin_r a0 (/ 2)).
  assert (q : alpha * (10 * (K + 1)) < 1). { apply (Rmult_lt_reg_r (/ (10 * (K + 1)))); trivial. rewrite Rmult_assoc, Rinv_r by lra. lra. }
  split. { unfold eq147_a. assert (s2 : 7 / 5 < sqrt 2) by (rewrite <- (sqrt_pow2 (7 / 5)) by lra; apply sqrt_lt_1_alt; lra).
  assert (e : sqrt 2 ^ 2 = 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra).
    assert (i : / sqrt 2 = sqrt 2 / 2) by (apply (Rmult_eq_reg_l (sqrt 2)); [ rewrite Rinv_r; nra | lra ]). unfold Rdiv. rewrite i.
    replace ((1 - alpha * (sqrt 2 / 2)) ^ 2) with (1 - alpha * sqrt 2 + alpha ^ 2 * sqrt 2 ^ 2 / 4) by field. rewrite e. nra. }
  intros A x y u w HA F. assert (0 <= eq147_a alpha) by (unfold eq147_a; apply pow2_ge_0). apply (H A alpha psi x y u w); trivial; try lra.
  unfold right_rest_boundary_least.
  assert (alpha ^ 3 * K <= alpha / 10). { replace (alpha ^ 3 * K) with (alpha * (alpha * (alpha * K))) by ring. assert (alpha * K <= / 10) by lra.
  assert (0 <= alpha * K) by nra. nra. }
  pose proof (pow2_ge_0 alpha). lra.
Qed.

(* a particle that is put down at the distance 3/5 with a speed of 1/20 across comes to rest between 1/2 and 3/4 *)
Lemma a_rest : exists x y u w A al psi sigma T s, spin x y u w /\ comes_to_rest sigma T x y u w A al psi /\ left_lim psi T 0 /\
  / 2 < sigma < 3 / 4 /\ arrives sigma s T A al psi.
Proof.
  assert (e1 : nrm (3 / 5) 0 = 3 / 5) by (apply nrm_x0; lra). assert (e2 : nrm 0 (1 / 20) = 1 / 20) by (apply nrm_0y; lra).
  destruct (rest_of_start (3 / 5) 0 0 (1 / 20)) as (x & y & u & w & A & al & psi & sigma & T & S & R & L & s1 & s2); rewrite ?e1, ?e2 in *; try lra.
  destruct (arriving x y u w A al psi sigma T S R L) as (s & _ & V). pose proof (sigma_pos x y u w A al psi sigma T S R).
  exists x, y, u, w, A, al, psi, sigma, T, s.
  repeat (split; [ now trivial | ]). split; trivial. split; nra.
Qed.
Ltac rest_at_3_5 := intros H; destruct a_rest as (x & y & u & w & A & al & psi & sigma & T & s & S & R & L & Hs & V);
  pose proof (v_rate _ _ _ _ _ _ V) as D;
  pose proof (v_time _ _ _ _ _ _ V) as sT; specialize (H x y u w A al psi sigma T S R); first [ exact H | specialize (H L);
  first [ exact H | apply H; lra | exact (H _ s sT (fun t Ht => proj1 (proj2 (D t Ht)))) | exact (H _ _ s sT (fun t Ht => proj1 (proj2 (D t Ht)))
  (fun t Ht => proj2 (proj2 (D t Ht))))
    | exact (H _ _ s sT (fun t Ht => proj1 (proj2 (D t Ht))) (fun t Ht => proj1 (D t Ht))) ] ].
Lemma s4_near_rest__occurs : ltac:(occurs s4_near_rest). Proof. rest_at_3_5. Qed.
Lemma eq_140__occurs : ltac:(occurs eq_140). Proof. rest_at_3_5. Qed.
Lemma eq_141__occurs : ltac:(occurs eq_141). Proof. rest_at_3_5. Qed.
Lemma eq_142__occurs : ltac:(occurs eq_142). Proof. rest_at_3_5. Qed.
Lemma eq_143__occurs : ltac:(occurs eq_143). Proof. rest_at_3_5. Qed.
Lemma eq_144__occurs : ltac:(occurs eq_144). Proof. rest_at_3_5. Qed.
Lemma eq_145__occurs : ltac:(occurs eq_145). Proof. rest_at_3_5. Qed.
(* from some A with alpha = 1 and psi = 0 it comes to rest at the distance 1/2 *)
Lemma eq_143__one_half__occurs : ltac:(occurs eq_143__one_half).
Proof.
  intros H. destruct (between (/ 2) 1 0 ltac:(lra) ltac:(lra)) as (A0 & x & y & u & w & A1 & F & B). pose proof (proj1 F) as S.
  destruct (values A0 1 0 x y u w A1 Rlt_0_1 F) as (ep & s0 & eE & ex & _).
  destruct (neither x y u w (/ 2) S ltac:(lra) B) as [R | [e _]]; [ | lra ]. assert (p0 : 0 < nrm (u 0) (w 0)) by (rewrite ep; nra).
  destruct (stops_for_good (/ 2) x y u w S ltac:(lra) p0 R) as (T & T0 & z & e & N). pose proof (cosh_pos 1). pose proof (nrm_pos (x 0) (y 0)).
  rewrite <- !nrm_sq in eE. rewrite cos_0 in ex.
  destruct (rest_of_motion x y u w T S T0 z N) as (A & al & psi & C & L); [ nra | | rewrite e in C;
  exact (H x y u w A al psi (/ 2) T S C L eq_refl) ].
  replace (x 0 * u 0 + y 0 * w 0) with ((x 0 * u 0 + y 0 * w 0) * / nrm (u 0) (w 0) * nrm (u 0) (w 0)) by (field; lra). rewrite ex.
  rewrite Rmult_1_r. apply Rmult_le_pos; [ apply Rmult_le_pos | ]; lra.
Qed.
Lemma eq_146__saddle__occurs : ltac:(occurs eq_146__saddle).
Proof.
  intros H. apply (H (fun t => 1 - cosh (1 + - t) / 2) (fun t => sinh (1 + - t) / 2) 1 (/ 2)); try lra; try (intros t _; split); cbv beta.
  - apply (cont_of _ _ (sinh (1 + - t) / 2)). unfold cosh, sinh. auto_derive; trivial. field.
  - apply (cont_of _ _ (- cosh (1 + - t) / 2)). unfold cosh, sinh. auto_derive; trivial. field.
  - apply rder_of. unfold cosh, sinh. auto_derive; trivial. field.
  - apply rder_of. unfold cosh, sinh. auto_derive; trivial. field.
  - rewrite Rplus_opp_r, cosh_0. field.
  - rewrite Rplus_opp_r, sinh_0. field.
  - pose proof (cosh_pos (1 + - 0)). lra.
Qed.
