(* The steps of Enclosed.v by the kernel itself, in whole numbers: Taylor's polynomials of a motion on the table are reckoned, a bound on what they
   lack of (89) and a bound on the error at the end of the step, and so on until rho + p < 1 or rho^2 - p^2 > 1 in all that is enclosed *)
Require Import Reals Lra Psatz List ZArith Bool Lia.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis Turntable Fate Enclosed.
Import ListNotations.
Open Scope Z_scope.

(* dimensionless (mu g = Omega = 1): a length or a speed of 1 is 2^40 units here, a time of 1 is 1024 *)
Definition one := 2 ^ 40.
Definition fall a := Z.shiftr a 40.
Definition part n a := Z.shiftr (n * a) 10.
(* polynomials by their coefficients *)
Fixpoint add a b := match a, b with nil, _ => b | _, nil => a | x :: a, y :: b => x + y :: add a b end.
Definition times k := map (Z.mul k).
Fixpoint mul a b := match a with nil => nil | x :: a => add (times x b) (0 :: mul a b) end.
Fixpoint square a := match a with nil => nil | x :: a => x * x :: add (times (2 * x) a) (0 :: square a) end.
Fixpoint next n l := match l with nil => nil | a :: l => n * a :: next (n + 1) l end.
Definition slope l := next 1 (tl l).
(* no value is greater until the time n; the value then, up to 2 *)
Fixpoint most n l := match l with nil => 0 | a :: l => Z.abs a + (part n (most n l) + 1) end.
Fixpoint value n l := match l with nil => 0 | a :: l => a + part n (value n l) end.

(* Taylor's coefficients by (89), each list from the last one back; s is p^2 and q is 1 / p. Nothing is to be proved of them. *)
Fixpoint dot m d a b := match a, b with x :: a, y :: b => m * x * y + dot (m + d) d a b | _, _ => 0 end.
Fixpoint series (more : nat) k xs ys us ws ss qs := match more with O => (rev xs, rev ys, rev qs) | S more =>
  let s := dot 1 0 us (rev us) + dot 1 0 ws (rev ws) in
  let q := match ss with nil => one * one / Z.sqrt s | _ => dot (- k) (-1) (s :: ss) (rev qs) / (2 * k * last ss s) end in
  let forward := q :: qs in let qs := rev forward in
  let u := (hd 0 xs + 2 * hd 0 ws - fall (dot 1 0 us qs)) / (k + 1) in
  let w := (hd 0 ys - 2 * hd 0 us - fall (dot 1 0 ws qs)) / (k + 1) in
  series more (k + 1) (hd 0 us / (k + 1) :: xs) (hd 0 ws / (k + 1) :: ys) (u :: us) (w :: ws) (s :: ss) forward end.
(* what X, Y lack of (89) until the time n, if Q is nearly 1 / p *)
Definition lacking X Y Q := let U := slope X in let W := slope Y in let gx := map fall (mul U Q) in let gy := map fall (mul W Q) in
  let a := add (add (slope U) (add (times (-1) X) (times (-2) W))) gx in
  let b := add (add (slope W) (add (times (-1) Y) (times 2 U))) gy in
  let c := add (add (square gx) (square gy)) [- one ^ 2] in
  fun n => most n a + most n b + 2 * fall (most n c + 4 * (most n gx + most n gy)) + 8.
(* the longest step, of some, on which they lack less than 2^-22 *)
Fixpoint fit (tries : nat) e n := match tries with O => n | S tries => if e n <? 2 ^ 18 then n else fit tries e (n * 9 / 10) end.
(* what an error d has become at the end of the step n *)
Definition grown n d e := (d + e) * (4 * 2 ^ 30 + 4 * 2 ^ 20 * n + 2 * 2 ^ 10 * n ^ 2 + n ^ 3) / 2 ^ 32 + 5 - e.

(* what is within d of the state (x, y, u, w) comes to rest, leaves for good, or is still under way *)
Inductive fate := rests | leaves | open.
Definition caught_by d x y u w := let m := Z.sqrt (u ^ 2 + w ^ 2) + 1 + 2 * d in
  (m <? one) && ((Z.abs x + d) ^ 2 + (Z.abs y + d) ^ 2 <? (one - m) ^ 2).
Definition free_by d x y u w := one ^ 2 <? x ^ 2 + y ^ 2 - u ^ 2 - w ^ 2 - 2 * d * (Z.abs x + Z.abs y + Z.abs u + Z.abs w + d).
(* what becomes of all motions within d of a state, in so many steps *)
Fixpoint run (steps : nat) d x y u w := if caught_by d x y u w then rests else if free_by d x y u w then leaves else
  match steps with O => open | S steps =>
  let '(lX, lY, Q) := series 8 0 [x] [y] [u] [w] nil nil in let X := x :: u :: tl (tl lX) in let Y := y :: w :: tl (tl lY) in
  let lack := lacking X Y Q in let n := fit 40 lack 512 in let e := lack n in
  if (0 <=? n) && (n <=? 512) && (0 <=? e) && (0 <? d) && (most n (0 :: tl Q) <? hd 0 Q)
  then run steps (grown n d e) (value n X) (value n Y) (value n (slope X)) (value n (slope Y)) else open end.

Open Scope R_scope.
Local Notation S1 := (IZR one).
Lemma one_pos : 0 < S1. Proof. unfold one. change (IZR (2 ^ 40)) with (IZR 1099511627776). lra. Qed.
Definition val l h := poly (map IZR l) h.
Definition re l := map (fun a => IZR a / S1) l.
Lemma val_re l h : poly (re l) h = val l h / S1.
Proof. pose proof one_pos. unfold val. induction l as [ | a l IH ]; simpl. field; lra. fold (re l). rewrite IH. field. lra. Qed.
Lemma D_re l : D (re l) = re (slope l).
Proof.
  destruct l as [ | a l ]; trivial. unfold D, slope. simpl tl. generalize 1%Z. induction l as [ | b l IH ]; intros n; simpl; trivial.
  fold (re l). rewrite IH, mult_IZR. f_equal. unfold Rdiv. ring.
Qed.
Lemma val_add a : forall b h, val (add a b) h = val a h + val b h.
Proof. unfold val. induction a as [ | x a IH ]; intros [ | y b ] h; simpl; rewrite ?IH, ?plus_IZR; ring. Qed.
Lemma val_times k l h : val (times k l) h = IZR k * val l h.
Proof. unfold val, times. induction l as [ | a l IH ]; cbn [map poly]. ring. rewrite mult_IZR, IH. ring. Qed.
Lemma val_mul a b h : val (mul a b) h = val a h * val b h.
Proof. induction a as [ | x a IH ]; simpl. unfold val; simpl; ring. rewrite val_add, val_times. unfold val in *. simpl. rewrite IH. ring. Qed.
Lemma val_square a h : val (square a) h = val a h ^ 2.
Proof.
  induction a as [ | x a IH ]. unfold val; simpl; ring. change (val (square (x :: a)) h) with (IZR (x * x) + h * val (add (times (2 * x) a)
    (0%Z :: square a)) h).
  rewrite val_add, val_times. change (val (0%Z :: square a) h) with (0 + h * val (square a) h). change (val (x :: a) h) with (IZR x + h * val a h).
  rewrite IH, !mult_IZR. ring.
Qed.
(* a shift is a division, rounded down *)
Lemma shifted a k : (0 <= k)%Z -> let q := IZR a / IZR (2 ^ k) - IZR (Z.shiftr a k) in 0 <= q <= 1.
Proof.
  intros Hk q. unfold q. rewrite Z.shiftr_div_pow2 by trivial. assert (p : (0 < 2 ^ k)%Z) by (apply Z.pow_pos_nonneg; lia).
  pose proof (Z.div_mod a (2 ^ k) ltac:(lia)) as e. pose proof (Z.mod_pos_bound a (2 ^ k) p) as [m1 m2]. apply IZR_lt in p, m2. apply IZR_le in m1.
  replace (IZR a / IZR (2 ^ k) - IZR (a / 2 ^ k)) with (IZR (a mod 2 ^ k) / IZR (2 ^ k)).
  - split. apply Rdiv_le_0_compat; trivial. apply Rle_div_l; lra.
  - rewrite e at 2. rewrite plus_IZR, mult_IZR. field. lra.
Qed.
Lemma fallen a : 0 <= IZR a / S1 - IZR (fall a) <= 1. Proof. apply (shifted a 40). lia. Qed.
Lemma parted n a : 0 <= IZR n / 1024 * IZR a - IZR (part n a) <= 1.
Proof. pose proof (shifted (n * a) 10 ltac:(lia)) as q. cbv zeta in q. change (IZR (2 ^ 10)) with 1024 in q. rewrite mult_IZR in q. unfold part.
lra. Qed.
Lemma val_most n l h : 0 <= h <= IZR n / 1024 -> Rabs (val l h) <= IZR (most n l).
Proof.
  intros Hh. induction l as [ | a l IH ]. unfold val; simpl. rewrite Rabs_R0. lra. change (val (a :: l) h) with (IZR a + h * val l h).
  simpl most. rewrite !plus_IZR, abs_IZR. pose proof (parted n (most n l)). eapply Rle_trans; [ apply Rabs_triang | ]. apply Rplus_le_compat_l.
  rewrite Rabs_mult, (Rabs_pos_eq h) by lra. pose proof (Rabs_pos (val l h)). nra.
Qed.
Lemma val_value n l : (0 <= n <= 512)%Z -> Rabs (val l (IZR n / 1024) - IZR (value n l)) <= 2.
Proof.
  intros [n0 n1]. apply IZR_le in n0, n1. induction l as [ | a l IH ]. unfold val; simpl. rewrite Rabs_pos_eq; lra.
  change (val (a :: l) (IZR n / 1024)) with (IZR a + IZR n / 1024 * val l (IZR n / 1024)).
  simpl value. rewrite plus_IZR. pose proof (parted n (value n l)). set (h := IZR n / 1024) in *. assert (0 <= h <= / 2) by (unfold h; lra).
  apply Rabs_le_between in IH. apply Rabs_le. nra.
Qed.
Lemma val_fall l h : 0 <= h <= / 2 -> Rabs (val l h / S1 - val (map fall l) h) <= 2.
Proof.
  intros Hh. pose proof one_pos. induction l as [ | a l IH ]. unfold val; simpl. rewrite Rabs_pos_eq; lra. simpl map.
  change (val (a :: l) h) with (IZR a + h * val l h). change (val (fall a :: map fall l) h) with (IZR (fall a) + h * val (map fall l) h).
  pose proof (fallen a). replace ((IZR a + h * val l h) / S1) with (IZR a / S1 + h * (val l h / S1)) by (field; lra).
  apply Rabs_le_between in IH. apply Rabs_le. nra.
Qed.
(* a vector times what is nearly its size's inverse *)
Lemma unit_near a b q d : 0 <= q -> Rabs (q ^ 2 * (a ^ 2 + b ^ 2) - 1) <= d -> Rabs (a / nrm a b - a * q) <= d /\ Rabs (b / nrm a b - b * q) <= d.
Proof.
  intros q0 H. rewrite <- (nrm_sq a b) in H. pose proof (nrm_pos a b) as n0. pose proof (nrm_sq a b) as e. set (n := nrm a b) in *.
  assert (K : forall c, c ^ 2 <= n ^ 2 -> Rabs (c / n - c * q) <= d).
  { intros c Hc. destruct n0 as [n0 | n0].
    - replace (c / n - c * q) with (c / n * (1 - n * q)) by (field; lra). rewrite Rabs_mult. assert (Rabs (c / n) <= 1).
      { apply abs_of_sq. lra. replace ((c / n) ^ 2) with (c ^ 2 / n ^ 2) by (field; lra). apply Rle_div_l; nra. }
      assert (Rabs (1 - n * q) <= d). { replace (q ^ 2 * n ^ 2 - 1) with ((1 - n * q) * - (1 + n * q)) in H by ring.
      rewrite Rabs_mult, (Rabs_Ropp (1 + n * q)), (Rabs_pos_eq (1 + n * q)) in H by nra.
        pose proof (Rabs_pos (1 - n * q)). assert (0 <= n * q) by nra. nra. }
      pose proof (Rabs_pos (c / n)). pose proof (Rabs_pos (1 - n * q)). nra.
    - rewrite <- n0 in *. assert (c = 0) as -> by nra. unfold Rdiv. rewrite !Rmult_0_l, Rminus_0_r, Rabs_R0.
    pose proof (Rabs_pos (q ^ 2 * 0 ^ 2 - 1)). lra. }
  split; apply K; rewrite e; pose proof (pow2_ge_0 a); pose proof (pow2_ge_0 b); lra.
Qed.
Lemma sqZ a : IZR (a ^ 2) = IZR a ^ 2. Proof. symmetry. exact (pow_IZR a 2). Qed.
Lemma cubeZ a : IZR (a ^ 3) = IZR a ^ 3. Proof. symmetry. exact (pow_IZR a 3). Qed.
Ltac units := repeat first [ rewrite sqZ in * | rewrite cubeZ in * | rewrite plus_IZR in * | rewrite minus_IZR in * | rewrite mult_IZR in * |
  rewrite opp_IZR in * | rewrite abs_IZR in * ].
(* what the polynomials lack, by numbers *)
Lemma lacks X Y Q n h : (n <= 512)%Z -> (most n (0%Z :: tl Q) < hd 0%Z Q)%Z -> 0 <= h <= IZR n / 1024 -> (0 <= lacking X Y Q n)%Z ->
  lack (re X) (re Y) h <= (IZR (lacking X Y Q n) / S1) ^ 2.
Proof.
  intros Hn HQ Hh He. pose proof one_pos as s0. assert (h1 : h <= / 2) by (apply IZR_le in Hn; lra). unfold lacking in *. cbv zeta in *.
  set (U := slope X) in *. set (W := slope Y) in *. set (gx := map fall (mul U Q)) in *. set (gy := map fall (mul W Q)) in *.
  set (a := add (add (slope U) _) gx) in *. set (b := add (add (slope W) _) gy) in *. set (c := add _ [_]) in *.
  pose proof (val_most n a h Hh) as ba. pose proof (val_most n b h Hh) as bb. pose proof (val_most n c h Hh) as bc.
  pose proof (val_most n gx h Hh) as bx. pose proof (val_most n gy h Hh) as be.
  pose proof (val_fall (mul U Q) h ltac:(lra)) as fx. pose proof (val_fall (mul W Q) h ltac:(lra)) as fy. fold gx in fx. fold gy in fy.
  unfold a in ba at 1. unfold b in bb at 1. unfold c in bc at 1. rewrite !val_add, ?val_times, ?val_square in *. rewrite !val_mul in fx, fy.
  assert (q0 : 0 <= val Q h).
  { destruct Q as [ | q Q ]. simpl in HQ. unfold val; simpl; lra. pose proof (val_most n (0%Z :: Q) h Hh) as k. simpl tl in HQ. simpl hd in HQ.
  apply IZR_lt in HQ.
    change (val (0%Z :: Q) h) with (0 + h * val Q h) in k. change (val (q :: Q) h) with (IZR q + h * val Q h). apply Rabs_le_between in k. lra. }
  change (val [(- one ^ 2)%Z] h) with (IZR (- one ^ 2) + h * 0) in bc. replace (IZR (- one ^ 2) + h * 0) with (- S1 ^ 2) in bc.
  2: { rewrite opp_IZR, sqZ. ring. }
  set (m := (most n c + 4 * (most n gx + most n gy))%Z) in *. pose proof (fallen m) as fm.
  unfold lack. cbv zeta. rewrite !D_re, !val_re. fold U W. set (u := val U h) in *. set (w := val W h) in *. set (q := val Q h) in *.
  set (GX := val gx h) in *. set (GY := val gy h) in *. set (E := IZR (fall m)) in *. 
  destruct (unit_near (u / S1) (w / S1) (q / S1) ((E + 2) / S1)) as [k1 k2]. { apply Rdiv_le_0_compat; trivial. }
  { replace ((q / S1) ^ 2 * ((u / S1) ^ 2 + (w / S1) ^ 2) - 1) with (((u * q / S1) ^ 2 + (w * q / S1) ^ 2 - S1 ^ 2) / S1 ^ 2) by (field; lra).
    set (A := u * q / S1) in *. set (B := w * q / S1) in *. unfold Rdiv.
    rewrite Rabs_mult, (Rabs_pos_eq (/ S1 ^ 2)) by (left; apply Rinv_0_lt_compat; nra).
    assert (sq : forall A G M, Rabs (A - G) <= 2 -> Rabs G <= M -> Rabs (A ^ 2 - G ^ 2) <= 4 * M + 4).
    { clear. intros A G M d g. replace (A ^ 2 - G ^ 2) with ((A - G) * ((A - G) + 2 * G)) by ring. rewrite Rabs_mult.
      pose proof (Rabs_triang (A - G) (2 * G)) as t. rewrite (Rabs_mult 2), (Rabs_pos_eq 2) in t by lra. pose proof (Rabs_pos (A - G)).
      pose proof (Rabs_pos (A - G + 2 * G)). nra. }
    pose proof (sq A GX _ fx bx) as t1. pose proof (sq B GY _ fy be) as t2.
    assert (t : Rabs (A ^ 2 + B ^ 2 - S1 ^ 2) <= IZR m + 8).
    { unfold m. units. apply Rabs_le_between in t1, t2, bc. apply Rabs_le. lra. }
    apply Rmult_le_reg_r with (S1 ^ 2). nra. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by nra.
    replace ((E + 2) * / S1 * S1 ^ 2) with ((E + 2) * S1) by (field; lra).
    assert (IZR m <= (E + 1) * S1). { destruct fm as [_ fm]. fold E in fm. replace (IZR m) with (IZR m / S1 * S1) by (field; lra). nra. }
    assert (8 <= S1) by (unfold one; change (IZR (2 ^ 40)) with (IZR 1099511627776); lra). lra. }
  set (p := nrm (u / S1) (w / S1)) in *.
  assert (side : forall v x z u G M, Rabs (v + (-1 * x + z) + G) <= M -> Rabs (u * q / S1 - G) <= 2 -> Rabs (u / S1 / p - u / S1 * (q / S1))
    <= (E + 2) / S1 ->
    Rabs (v / S1 - (x / S1 - z / S1 - u / S1 / p)) <= (M + 4 + E) / S1).
  { intros v x z u' G M d1 d2 d3. replace (u' / S1 * (q / S1)) with (u' * q / S1 / S1) in d3 by (field; lra). set (A := u' * q / S1) in *.
    replace (v / S1 - (x / S1 - z / S1 - u' / S1 / p)) with ((v + (-1 * x + z) + G) / S1 + (A - G) / S1 + (u' / S1 / p - A / S1)) by (unfold Rdiv;
      ring).
    assert (sc : forall r M, Rabs r <= M -> Rabs (r / S1) <= M / S1).
    { intros r N k. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ S1)) by (left; now apply Rinv_0_lt_compat). apply Rmult_le_compat_r; trivial.
    left; now apply Rinv_0_lt_compat. }
    apply sc in d1, d2. replace ((M + 4 + E) / S1) with (M / S1 + 2 / S1 + (E + 2) / S1) by (field; lra).
    eapply Rle_trans; [ apply Rabs_triang | ]. apply Rplus_le_compat; trivial. eapply Rle_trans; [ apply Rabs_triang | ]. lra. }
  pose proof (side (val (slope U) h) (val X h) (-2 * w) u GX _ ba fx k1) as r1.
  pose proof (side (val (slope W) h) (val Y h) (2 * u) w GY _ bb fy k2) as r2.
  replace (val X h / S1 - -2 * w / S1 - u / S1 / p) with (val X h / S1 + 2 * (w / S1) - u / S1 / p) in r1 by (unfold Rdiv; ring).
  replace (val Y h / S1 - 2 * u / S1 - w / S1 / p) with (val Y h / S1 - 2 * (u / S1) - w / S1 / p) in r2 by (unfold Rdiv; ring).
  match goal with |- ?A ^ 2 + ?B ^ 2 <= _ => rewrite <- (pow2_abs A), <- (pow2_abs B) end. units. fold E.
  replace ((IZR (most n a) + IZR (most n b) + 2 * E + 8) / S1) with ((IZR (most n a) + 4 + E) / S1 + (IZR (most n b) + 4 + E) / S1) by (field; lra).
  set (A := Rabs _) in r1 |- *. set (B := Rabs _) in r2 |- *. assert (0 <= A) by apply Rabs_pos. assert (0 <= B) by apply Rabs_pos. nra.
Qed.
Lemma exp_small h : 0 <= h <= 1 -> exp h <= 1 + h + h ^ 2 / 2 + h ^ 3 / 4.
Proof.
  intros Hh. set (f t := - ((1 + t + t ^ 2 / 2 + t ^ 3 / 4) * exp (- t))). assert (K : f h <= f 0).
  { apply rder_decr; [ lra | | ]; intros t Ht. { apply derivable_continuous_pt. unfold f. reg. }
    exists (- ((t ^ 2 - t ^ 3) / 4 * exp (- t))). split. apply rder_of. unfold f. auto_derive; trivial. field. pose proof (exp_pos (- t)).
    assert (0 <= t ^ 2 - t ^ 3) by nra. nra. }
  unfold f in K. rewrite Ropp_0, exp_0 in K. assert (e : exp (- h) * exp h = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  pose proof (exp_pos h) as e0.
  apply Rmult_le_reg_r with (exp (- h)). apply exp_pos. rewrite Rmult_comm, e. lra.
Qed.
Lemma grows n d e : (0 <= n <= 512)%Z -> (0 <= e)%Z -> (0 <= d)%Z ->
  (IZR d / S1 + IZR e / S1) * exp (IZR n / 1024) - IZR e / S1 + 4 / S1 <= IZR (grown n d e) / S1.
Proof.
  intros [n0 n1] He Hd. pose proof one_pos. apply IZR_le in n0, n1, He, Hd. pose proof (exp_small (IZR n / 1024) ltac:(lra)) as K.
  set (h := IZR n / 1024) in *.
  assert (Q : (IZR d + IZR e) * (1 + h + h ^ 2 / 2 + h ^ 3 / 4) <= IZR ((d + e) * (4 * 2 ^ 30 + 4 * 2 ^ 20 * n + 2 * 2 ^ 10 * n ^ 2 + n ^ 3)
    / 2 ^ 32) + 1).
  { set (N := ((d + e) * _)%Z). pose proof (Z.div_mod N (2 ^ 32) ltac:(lia)) as q. pose proof (Z.mod_pos_bound N (2 ^ 32) ltac:(lia)) as [_ m].
    assert (IZR N <= (IZR (N / 2 ^ 32) + 1) * 4294967296). { rewrite <- plus_IZR, <- mult_IZR. apply IZR_le. lia. }
    replace ((IZR d + IZR e) * (1 + h + h ^ 2 / 2 + h ^ 3 / 4)) with (IZR N / 4294967296); [ lra | ].
    unfold N, h. rewrite !mult_IZR, !plus_IZR, !mult_IZR, sqZ, cubeZ. change (IZR (2 ^ 30)) with 1073741824. change (IZR (2 ^ 20)) with 1048576.
    change (IZR (2 ^ 10)) with 1024. field. }
  unfold grown. units. assert (M : (IZR d + IZR e) * exp h <= (IZR d + IZR e) * (1 + h + h ^ 2 / 2 + h ^ 3 / 4)) by (apply Rmult_le_compat_l; lra).
  replace ((IZR d / S1 + IZR e / S1) * exp h - IZR e / S1 + 4 / S1) with (((IZR d + IZR e) * exp h - IZR e + 4) / S1) by (field; lra).
  apply Rmult_le_compat_r. left; now apply Rinv_0_lt_compat. lra.
Qed.
Section Run.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Definition within d X Y U W := near x y u w (IZR X / S1) (IZR Y / S1) (IZR U / S1) (IZR W / S1) (IZR d / S1).
(* it is caught: rho + p < 1 at some time, or free: rho^2 - p^2 > 1 *)
Definition caught_once := exists s, 0 <= s /\ nrm (x s) (y s) + nrm (u s) (w s) < 1.
Definition free_once := exists s, 0 <= s /\ 1 < nrm (x s) (y s) ^ 2 - nrm (u s) (w s) ^ 2.

Lemma inside d X Y U W : (0 <= d)%Z -> within d X Y U W -> exists s, 0 <= s /\ let near a A := Rabs (S1 * a - IZR A) <= IZR d in
  near (x s) X /\ near (y s) Y /\ near (u s) U /\ near (w s) W.
Proof.
  intros Hd (s & s0 & O). pose proof one_pos. apply IZR_le in Hd. exists s. split; trivial.
  assert (d0 : 0 <= IZR d / S1) by (apply Rdiv_le_0_compat; trivial).
  destruct (sides _ _ _ _ _ _ _ _ _ _ d0 O) as (a & b & c & f).
  assert (K : forall r A, Rabs (r - IZR A / S1) <= IZR d / S1 -> Rabs (S1 * r - IZR A) <= IZR d).
  { intros r A k. replace (S1 * r - IZR A) with (S1 * (r - IZR A / S1)) by (field; lra). rewrite Rabs_mult, (Rabs_pos_eq S1) by lra.
    apply Rmult_le_compat_l with (r := S1) in k; [ | lra ]. now replace (S1 * (IZR d / S1)) with (IZR d) in k by (field; lra). }
  cbv zeta. auto.
Qed.
Lemma scaled a b : nrm (S1 * a) (S1 * b) = S1 * nrm a b.
Proof. pose proof one_pos. unfold nrm. replace ((S1 * a) ^ 2 + (S1 * b) ^ 2) with (S1 ^ 2 * (a ^ 2 + b ^ 2)) by ring.
rewrite sqrt_mult, sqrt_pow2; try nra. Qed.
Lemma is_caught d X Y U W : (0 <= d)%Z -> within d X Y U W -> caught_by d X Y U W = true -> caught_once.
Proof.
  intros Hd N B. destruct (inside d X Y U W Hd N) as (s & s0 & k1 & k2 & k3 & k4). exists s. split; trivial. pose proof one_pos as q0.
  apply IZR_le in Hd.
  unfold caught_by in B. cbv zeta in B. apply andb_true_iff in B as [b1 b2]. apply Z.ltb_lt in b1, b2. set (r := Z.sqrt (U ^ 2 + W ^ 2)) in *.
  assert (P : nrm (IZR U) (IZR W) <= IZR r + 1).
  { apply nrm_le. pose proof (Z.sqrt_nonneg (U ^ 2 + W ^ 2)) as z. apply IZR_le in z. fold r in z. lra.
    destruct (Z.sqrt_spec (U ^ 2 + W ^ 2)) as [_ z]. nia. fold r in z. apply IZR_lt in z. rewrite <- Z.add_1_r, mult_IZR, !plus_IZR, !sqZ in z. lra. }
  set (m := (r + 1 + 2 * d)%Z) in *. pose proof (nrm_near (S1 * u s) (S1 * w s) (IZR U) (IZR W)) as Q. apply Rabs_le_between in Q.
  assert (p1 : nrm (S1 * u s) (S1 * w s) <= IZR m) by (unfold m; units; lra).
  assert (p2 : nrm (S1 * x s) (S1 * y s) < S1 - IZR m).
  { apply IZR_lt in b1, b2. assert (side : forall a A, Rabs (a - IZR A) <= IZR d -> a ^ 2 <= (Rabs (IZR A) + IZR d) ^ 2).
    { intros a A k. rewrite <- (pow2_abs a). apply pow_incr. split. apply Rabs_pos. pose proof (Rabs_triang (a - IZR A) (IZR A)) as t.
    replace (a - IZR A + IZR A) with a in t by ring. lra. }
    pose proof (side _ _ k1). pose proof (side _ _ k2).
    rewrite plus_IZR, !sqZ, minus_IZR, !plus_IZR, !abs_IZR in b2.
    apply Rle_lt_trans with (sqrt ((Rabs (IZR X) + IZR d) ^ 2 + (Rabs (IZR Y) + IZR d) ^ 2)).
    apply sqrt_le_1_alt. lra. rewrite <- (sqrt_pow2 (S1 - IZR m)) by lra. apply sqrt_lt_1_alt. split; trivial.
    pose proof (pow2_ge_0 (Rabs (IZR X) + IZR d)). pose proof (pow2_ge_0 (Rabs (IZR Y) + IZR d)). lra. }
  rewrite scaled in p1, p2. nra.
Qed.
Lemma is_free d X Y U W : (0 <= d)%Z -> within d X Y U W -> free_by d X Y U W = true -> free_once.
Proof.
  intros Hd N B. destruct (inside d X Y U W Hd N) as (s & s0 & k1 & k2 & k3 & k4). exists s. split; trivial. pose proof one_pos as q0.
  apply IZR_le in Hd.
  unfold free_by in B. apply Z.ltb_lt, IZR_lt in B. rewrite !nrm_sq. 
  assert (sq : forall a A, Rabs (a - IZR A) <= IZR d -> IZR A ^ 2 - 2 * IZR d * Rabs (IZR A) <= a ^ 2 <= IZR A ^ 2 + 2 * IZR d * Rabs (IZR A)
    + IZR d ^ 2).
  { intros a A k. set (z := a - IZR A) in *. replace (a ^ 2) with (IZR A ^ 2 + 2 * (z * IZR A) + z ^ 2) by (unfold z; ring).
    assert (t : Rabs (z * IZR A) <= IZR d * Rabs (IZR A)) by (rewrite Rabs_mult; apply Rmult_le_compat_r; trivial; apply Rabs_pos).
    apply Rabs_le_between in t, k. pose proof (pow2_ge_0 z). nra. }
  pose proof (sq _ _ k1). pose proof (sq _ _ k2). pose proof (sq _ _ k3). pose proof (sq _ _ k4).
  repeat (rewrite minus_IZR in B || rewrite plus_IZR in B || rewrite mult_IZR in B).
  rewrite !sqZ, !abs_IZR in B. nra.
Qed.
Theorem run_says steps : forall d X Y U W, (0 <= d)%Z -> within d X Y U W -> match run steps d X Y U W with rests => caught_once | leaves =>
  free_once | open => True end.
Proof.
  induction steps as [ | steps IH ]; intros d X Y U W Hd N; cbn [run]; destruct (caught_by d X Y U W) eqn:c; try (now apply (is_caught d X Y U W));
    destruct (free_by d X Y U W) eqn:f; try (now apply (is_free d X Y U W)); trivial.
  destruct (series 8 0 [X] [Y] [U] [W] [] []) as [[lX lY] Q]. set (PX := X :: U :: tl (tl lX)). set (PY := Y :: W :: tl (tl lY)).
  set (n := fit 40 (lacking PX PY Q) 512).
  set (e := lacking PX PY Q n). destruct (_ && _) eqn:b; trivial. repeat (apply andb_true_iff in b as [b ?]).
  repeat match goal with k : _ = true |- _ => first [ apply Z.leb_le in k | apply Z.ltb_lt in k ] end. pose proof one_pos as q0.
  assert (g0 : 0 <= 4 / S1) by (apply Rdiv_le_0_compat; lra). assert (h0 : 0 <= IZR n / 1024) by (apply IZR_le in b; lra).
  assert (e0 : 0 <= IZR e / S1) by (apply Rdiv_le_0_compat; trivial; now apply IZR_le).
  assert (d0 : 0 < IZR d / S1) by (apply Rdiv_lt_0_compat; trivial; now apply IZR_lt).
  pose proof (grows n d e ltac:(lia) ltac:(lia) ltac:(lia)) as G. apply IH.
  - assert (k : 0 <= IZR (grown n d e) / S1). { eapply Rle_trans; [ | exact G ]. pose proof (exp_ineq1_le (IZR n / 1024)). nra. }
    apply le_IZR. apply Rmult_le_compat_r with (r := S1) in k; [ | lra ]. rewrite Rmult_0_l in k.
    now replace (IZR (grown n d e) / S1 * S1) with (IZR (grown n d e)) in k by (field; lra).
  - unfold within. apply (one_step x y u w S (re PX) (re PY) (IZR n / 1024) (IZR e / S1) (IZR d / S1) _ _ _ _ (4 / S1)); trivial.
    + rewrite !D_re. unfold PX, PY, slope. simpl next. simpl re. simpl poly. rewrite !Rmult_0_l, !Rplus_0_r.
    change (match U with Z0 => 0%Z | _ => U end) with (1 * U)%Z.
      destruct U, W; exact N.
    + auto.
    + intros r Hr. apply lacks; trivial.
    + rewrite !D_re, !val_re. assert (K : forall l, (val l (IZR n / 1024) / S1 - IZR (value n l) / S1) ^ 2 <= 4 / S1 ^ 2).
      { intros l. pose proof (val_value n l ltac:(lia)) as v. replace ((val l (IZR n / 1024) / S1 - IZR (value n l) / S1) ^ 2)
        with ((val l (IZR n / 1024) - IZR (value n l)) ^ 2 / S1 ^ 2) by (field; lra).
        apply Rmult_le_compat_r. left. apply Rinv_0_lt_compat. nra. rewrite <- pow2_abs.
        pose proof (Rabs_pos (val l (IZR n / 1024) - IZR (value n l))). nra. }
      pose proof (K PX). pose proof (K PY). pose proof (K (slope PX)). pose proof (K (slope PY)).
      replace ((4 / S1) ^ 2) with (4 / S1 ^ 2 + 4 / S1 ^ 2 + 4 / S1 ^ 2 + 4 / S1 ^ 2) by (field; lra). lra.
Qed.
End Run.
