(* A motion on the table enclosed by the kernel, step by step: two polynomials stand for it, and as friction brings motions together no bound
   on its change of direction is needed *)
Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Fate.
Open Scope R_scope.

(* the polynomial of these coefficients, the constant first, and the coefficients of its derivative *)
Fixpoint poly (c : list R) h := match c with nil => 0 | a :: l => a + h * poly l h end.
Fixpoint dlist (n : Z) (c : list R) := match c with nil => nil | a :: l => IZR n * a :: dlist (n + 1) l end.
Definition D (c : list R) := dlist 1 (tl c).
(* the squared distance of a motion from a state, at the moment s *)
Definition off (x y u w : R -> R) s X Y U W := (x s - X) ^ 2 + (y s - Y) ^ 2 + (u s - U) ^ 2 + (w s - W) ^ 2.
(* the square of what (89) has more than polynomials X, Y for the place *)
Definition lack X Y h := let p := nrm (poly (D X) h) (poly (D Y) h) in
  (poly (D (D X)) h - (poly X h + 2 * poly (D Y) h - poly (D X) h / p)) ^ 2 + (poly (D (D Y)) h - (poly Y h - 2 * poly (D X) h - poly (D Y) h / p))
    ^ 2.

Lemma dlist_next l : forall n h, poly (dlist (n + 1) l) h = poly (dlist n l) h + poly l h.
Proof. induction l as [ | a l IH ]; intros n h; simpl; [ ring | rewrite IH, plus_IZR; ring ]. Qed.
Lemma poly_der c h : is_derive (poly c) h (poly (D c) h).
Proof.
  revert h. induction c as [ | a c IH ]; intros h. { apply (is_derive_ext (fun _ => 0)). reflexivity. auto_derive; trivial. }
  replace (poly (D (a :: c)) h) with (0 + (1 * poly c h + h * poly (D c) h)).
  - apply (is_derive_plus (fun _ => a) (fun t => t * poly c t)). auto_derive; trivial.
  apply (is_derive_mult (fun t => t) (poly c)); [ auto_derive; trivial | apply IH | intros; apply Rmult_comm ].
  - unfold D. simpl. destruct c as [ | b c ]; simpl. ring. pose proof (dlist_next c 1 h) as k. simpl in k. rewrite k. ring.
Qed.
Lemma rder_poly c s t : rder (fun t => poly c (t - s)) t (poly (D c) (t - s)).
Proof.
  apply rder_of. replace (poly (D c) (t - s)) with (1 * poly (D c) (t - s)) by ring.
  apply (is_derive_comp (poly c) (fun t => t - s)); [ apply poly_der | auto_derive; trivial; ring ].
Qed.
Lemma cont_poly c s t : continuity_pt (fun t => poly c (t - s)) t.
Proof.
  apply derivable_continuous_pt. exists (1 * poly (D c) (t - s)). apply is_derive_Reals.
  apply (is_derive_comp (poly c) (fun t => t - s)); [ apply poly_der | auto_derive; trivial; ring ].
Qed.
(* Within d of the polynomials' start at s: within (d + e) exp h - e of their end at s + h, if they lack e at most *)
Theorem enclosed x y u w s h X Y e d : spin x y u w -> 0 <= s -> 0 <= h -> 0 <= e -> 0 < d -> (forall r, 0 <= r <= h -> lack X Y r <= e ^ 2) ->
  off x y u w s (poly X 0) (poly Y 0) (poly (D X) 0) (poly (D Y) 0) < d ^ 2 ->
  off x y u w (s + h) (poly X h) (poly Y h) (poly (D X) h) (poly (D Y) h) < ((d + e) * exp h - e) ^ 2.
Proof.
  intros S Hs Hh He Hd R O. set (G t := off x y u w t (poly X (t - s)) (poly Y (t - s)) (poly (D X) (t - s)) (poly (D Y) (t - s))).
  set (z := d ^ 2 - G s).
  assert (z0 : 0 < z) by (unfold z, G; rewrite Rminus_eq_0; lra). assert (G0 : forall t, 0 <= G t).
  { intros t. unfold G, off. repeat apply Rplus_le_le_0_compat; apply pow2_ge_0. }
  set (q t := sqrt (G t + z)). assert (q0 : forall t, 0 < q t) by (intros t; apply sqrt_lt_R0; specialize (G0 t); lra).
  assert (qq : forall t, q t ^ 2 = G t + z) by (intros t; unfold q; rewrite <- Rsqr_pow2; apply Rsqr_sqrt; specialize (G0 t); lra).
  assert (K : (q (s + h) + e) * exp (- (s + h - s)) <= (q s + e) * exp (- (s - s))).
  { apply (rder_decr (fun t => (q t + e) * exp (- (t - s)))); [ lra | | ]; intros t Ht.
    - assert (cq : continuity_pt q t). { apply (continuity_pt_comp (fun t => G t + z) sqrt); [ | apply continuity_pt_sqrt; specialize (G0 t); lra ].
        pose proof (cont_poly X s t). pose proof (cont_poly Y s t). pose proof (cont_poly (D X) s t). pose proof (cont_poly (D Y) s t).
        unfold G, off. cont; trivial;
        first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra. } cont.
    - destruct (s_law _ _ _ _ S t ltac:(lra)) as (DX & DY & fx & fy & [B P] & DU & DW). specialize (R (t - s) ltac:(lra)). unfold lack in R.
      pose proof (rder_poly X s t) as pX. pose proof (rder_poly Y s t) as pY. pose proof (rder_poly (D X) s t) as pU.
      pose proof (rder_poly (D Y) s t) as pW.
      pose proof (qq t) as k. pose proof (q0 t) as k0. assert (DG := rder_root (fun t => G t + z) t). fold q in DG.
      set (a2 := poly (D (D X)) (t - s)) in *. set (b2 := poly (D (D Y)) (t - s)) in *. set (a1 := poly (D X) (t - s)) in *.
      set (b1 := poly (D Y) (t - s)) in *.
      set (a0 := poly X (t - s)) in *. set (b0 := poly Y (t - s)) in *. cbv zeta in R. set (n := nrm a1 b1) in *.
      assert (gg : (a1 / n) ^ 2 + (b1 / n) ^ 2 <= 1 /\ (a1 / n) * a1 + (b1 / n) * b1 = n).
      { pose proof (nrm_sq a1 b1) as e1. fold n in e1. destruct (Req_dec n 0) as [n0 | n0].
        - destruct (sq_sum a1 b1) as [-> ->]. rewrite <- e1, n0. lra. rewrite n0. unfold Rdiv. rewrite !Rmult_0_l. split; lra.
        - split. replace ((a1 / n) ^ 2 + (b1 / n) ^ 2) with ((a1 ^ 2 + b1 ^ 2) / n ^ 2) by (field; trivial). rewrite <- e1. right. field. trivial.
          transitivity ((a1 ^ 2 + b1 ^ 2) / n). field; trivial. rewrite <- e1. field. trivial. }
      destruct gg as [g1 g2]. set (ga := a1 / n) in *. set (gb := b1 / n) in *. set (ra := a2 - (a0 + 2 * b1 - ga)) in *.
      set (rb := b2 - (b0 - 2 * a1 - gb)) in *.
      pose proof (power_bound 1 fx fy a1 b1 Rle_0_1 ltac:(lra)) as Q1. fold n in Q1.
      pose proof (power_bound 1 (- ga) (- gb) (u t) (w t) Rle_0_1 ltac:(lra)) as Q2.
      set (dx := x t - a0). set (dy := y t - b0). set (du := u t - a1). set (dw := w t - b1).
      assert (Q3 : (fx + ga) * du + (fy + gb) * dw <= 0) by (unfold du, dw; lra).
      pose proof (nrm_sq du dw) as m2. pose proof (nrm_pos du dw) as m0. set (m := nrm du dw) in *.
      assert (Q4 : - (ra * du + rb * dw) <= e * m). { pose proof (power_bound e ra rb du dw He R) as Q. fold m in Q. lra. }
      assert (GG : G t = dx ^ 2 + dy ^ 2 + m ^ 2) by (rewrite m2; unfold G, off; fold a0 b0 a1 b1; unfold dx, dy, du, dw; ring).
      assert (mq : m <= q t). { pose proof (pow2_ge_0 dx). pose proof (pow2_ge_0 dy). nra. }
      set (T := 2 * (2 * (dx * du + dy * dw) + ((fx + ga) * du + (fy + gb) * dw) - (ra * du + rb * dw))).
      assert (DT : rder (fun t => G t + z) t T). { eapply rder_eq. unfold G, off. rd. unfold T, ra, rb, dx, dy, du, dw. fold a0 b0 a1 b1 a2 b2.
      simpl. ring. }
      specialize (DG T DT ltac:(specialize (G0 t); lra)). eexists. split.
      apply (rder_mult (fun t => q t + e) (fun t => exp (- (t - s)))); [ apply (rder_plus q (fun _ => e)); [ exact DG | rd ] | rd ].
      cbv beta. set (ex := exp (- (t - s))). assert (e0 : 0 < ex) by apply exp_pos. fold (q t).
      assert (main : T <= 2 * q t * (q t + e)). { pose proof (pow2_ge_0 (dx - du)). pose proof (pow2_ge_0 (dy - dw)). unfold T. nra. }
      match goal with |- ?g <= 0 => replace g with (- (ex * / (2 * q t) * (2 * q t * (q t + e) - T))) by (field; lra) end.
      assert (0 <= ex * / (2 * q t)) by (apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]). nra. }
  rewrite Rminus_eq_0, Ropp_0, exp_0 in K. replace (s + h - s) with h in K by ring.
  assert (qs : q s = d) by (unfold q, z; replace (G s + (d ^ 2 - G s)) with (d ^ 2) by ring; apply sqrt_pow2; lra).
  rewrite qs in K. assert (E : exp (- h) * exp h = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0). pose proof (exp_pos h) as eh.
  apply (Rmult_le_compat_r (exp h)) in K; [ | lra ]. rewrite Rmult_assoc, E in K. pose proof (qq (s + h)) as k. pose proof (q0 (s + h)).
  apply Rlt_le_trans with (q (s + h) ^ 2). 2: apply pow_incr; lra. rewrite k. unfold G. replace (s + h - s) with h by ring. lra.
Qed.
(* Within e of the polynomials' end of one step are those of the next that start within g of it *)
Lemma moved x y u w s X Y U W X' Y' U' W' d g d' : 0 <= d -> 0 <= g -> d + g <= d' -> (X - X') ^ 2 + (Y - Y') ^ 2 + (U - U') ^ 2 + (W - W')
  ^ 2 <= g ^ 2 ->
  off x y u w s X Y U W < d ^ 2 -> off x y u w s X' Y' U' W' < d' ^ 2.
Proof.
  intros d0 g0 dg G O. unfold off in *. set (a := x s - X) in *. set (b := y s - Y) in *. set (c := u s - U) in *. set (f := w s - W) in *.
  set (a' := X - X') in *. set (b' := Y - Y') in *. set (c' := U - U') in *. set (f' := W - W') in *.
  replace (x s - X') with (a + a') by (unfold a, a'; ring). replace (y s - Y') with (b + b') by (unfold b, b'; ring).
  replace (u s - U') with (c + c') by (unfold c, c'; ring). replace (w s - W') with (f + f') by (unfold f, f'; ring).
  apply Rlt_le_trans with ((d + g) ^ 2). 2: apply pow_incr; lra.
  assert (C : a * a' + b * b' + c * c' + f * f' <= d * g).
  { apply Rsqr_incr_0_var; [ | nra ]. unfold Rsqr.
    assert (L : (a * a' + b * b' + c * c' + f * f') ^ 2 <= (a ^ 2 + b ^ 2 + c ^ 2 + f ^ 2) * (a' ^ 2 + b' ^ 2 + c' ^ 2 + f' ^ 2)).
    { pose proof (pow2_ge_0 (a * b' - b * a')). pose proof (pow2_ge_0 (a * c' - c * a')). pose proof (pow2_ge_0 (a * f' - f * a')).
      pose proof (pow2_ge_0 (b * c' - c * b')). pose proof (pow2_ge_0 (b * f' - f * b')). pose proof (pow2_ge_0 (c * f' - f * c')). lra. }
    assert ((a ^ 2 + b ^ 2 + c ^ 2 + f ^ 2) * (a' ^ 2 + b' ^ 2 + c' ^ 2 + f' ^ 2) <= d ^ 2 * g ^ 2).
    { apply Rmult_le_compat; trivial; try lra; pose proof (pow2_ge_0 a); pose proof (pow2_ge_0 b); pose proof (pow2_ge_0 c); pose proof (pow2_ge_0 f);
      pose proof (pow2_ge_0 a'); pose proof (pow2_ge_0 b'); pose proof (pow2_ge_0 c'); pose proof (pow2_ge_0 f'); lra. }
    lra. }
  lra.
Qed.
Section Steps.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Definition near X Y U W d := exists s, 0 <= s /\ off x y u w s X Y U W < d ^ 2.
Lemma one_step X Y h e d X' Y' U' W' g d' : near (poly X 0) (poly Y 0) (poly (D X) 0) (poly (D Y) 0) d -> 0 <= h /\ 0 <= e /\ 0 < d /\ 0 <= g ->
  (forall r, 0 <= r <= h -> lack X Y r <= e ^ 2) ->
  (poly X h - X') ^ 2 + (poly Y h - Y') ^ 2 + (poly (D X) h - U') ^ 2 + (poly (D Y) h - W') ^ 2 <= g ^ 2 ->
  (d + e) * exp h - e + g <= d' -> near X' Y' U' W' d'.
Proof.
  intros (s & s0 & O) (h0 & e0 & d0 & g0) R G K. exists (s + h). split. lra. eapply moved; [ | exact g0 | exact K | exact G | ].
  2: now apply (enclosed x y u w s h X Y e d). pose proof (exp_ineq1_le h). nra.
Qed.
Lemma sides X Y U W d s : 0 <= d -> off x y u w s X Y U W < d ^ 2 ->
  Rabs (x s - X) <= d /\ Rabs (y s - Y) <= d /\ Rabs (u s - U) <= d /\ Rabs (w s - W) <= d.
Proof.
  intros d0 O. unfold off in O. pose proof (pow2_ge_0 (x s - X)). pose proof (pow2_ge_0 (y s - Y)). pose proof (pow2_ge_0 (u s - U)).
  pose proof (pow2_ge_0 (w s - W)). repeat split; apply abs_of_sq; lra.
Qed.
End Steps.
