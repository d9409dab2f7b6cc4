(* 2.3: with the friction little below the largest drive the particle rests for most of each late period: with friction l, s > 1 - l, where
   |h| <= 1 - s its speed falls at the rate s - (1 - l) until it rests, elsewhere it grows at 1 - l at most, and that is a short time. *)
Require Import Reals Lra Psatz ZArith List.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis HalfPeriod Drawn Median Mean Generic Steps.
Open Scope R_scope.

(* v is 0 on finitely many intervals in [a, b], which one after the other are found from a on, of the length x together *)
Inductive rest_time (v : R -> R) (a : R) : R -> R -> Prop :=
  | rest_none : rest_time v a a 0
  | rest_wait b c x : rest_time v a b x -> b <= c -> rest_time v a c x
  | rest_more b c x : rest_time v a b x -> b <= c -> (forall t, b <= t <= c -> v t = 0) -> rest_time v a c (x + (c - b)).
(* «between $a$ and $b$, $v$ is $0$ for the time $x$ or more, in finitely many intervals» *)
Definition rests_for (v : R -> R) (a b x : R) : Prop := exists y, x <= y /\ rest_time v a b y.
(* «$\lvert h\rvert=1$, also as a limit from one side, only at single instants, finitely many in a period» *)
Definition full_at_instants (h : R -> R) : Prop := exists L : list R, forall t, 0 <= t <= 2 * PI -> ~ In t L ->
  exists e, 0 < e /\ forall s, Rabs (s - t) < e -> Rabs (h s) <= 1 - e.

Lemma rest_time_le v a b x : rest_time v a b x -> a <= b.
Proof. induction 1; lra. Qed.
(* finitely many instants leave out a place in each interval *)
Lemma left_out (L : list R) a b : a < b -> exists x, a < x < b /\ ~ In x L.
Proof.
  revert a b. induction L as [ | l L IH ]; intros a b H; [ exists ((a + b) / 2); simpl; split; [ lra | tauto ] | ].
  destruct (IH a b H) as (x & Hx & n). destruct (Req_dec l x) as [-> | k]; [ | exists x; simpl; tauto ].
  destruct (IH a x ltac:(lra)) as (y & Hy & m). exists y. split; [ lra | ]. simpl. intros [e | e]; [ lra | tauto ].
Qed.
(* the time up to x for which x is within e of one of the instants, each counted *)
Fixpoint near_instants (e : R) (L : list R) (x : R) : R := match L with nil => 0
  | l :: L' => Rmax (- e) (Rmin e (x - l)) + near_instants e L' x end.
Ltac minmax := unfold Rmax, Rmin; repeat destruct Rle_dec; lra.
Lemma near_up e L x y : x <= y -> near_instants e L x <= near_instants e L y.
Proof. intros H. induction L as [ | l L IH ]; simpl; [ lra | ]. assert (Rmax (- e) (Rmin e (x - l)) <= Rmax (- e) (Rmin e (y - l))) by minmax.
lra. Qed.
Lemma near_all e L x y : 0 < e -> near_instants e L y - near_instants e L x <= 2 * e * INR (length L).
Proof.
  intros he. induction L as [ | l L IH ]; [ simpl; lra | ]. simpl length. rewrite S_INR. simpl near_instants.
  assert (Rmax (- e) (Rmin e (y - l)) - Rmax (- e) (Rmin e (x - l)) <= 2 * e) by minmax. lra.
Qed.
Lemma near_in e L l x y : In l L -> l - e <= x <= y -> y <= l + e -> near_instants e L x + (y - x) <= near_instants e L y.
Proof.
  intros I Hx Hy. induction L as [ | i L IH ]; simpl in *; [ contradiction | ]. destruct I as [-> | I].
  - pose proof (near_up e L x y ltac:(lra)). assert (Rmax (- e) (Rmin e (y - l)) - Rmax (- e) (Rmin e (x - l)) = y - x) by minmax. lra.
  - specialize (IH I). assert (Rmax (- e) (Rmin e (x - i)) <= Rmax (- e) (Rmin e (y - i))) by minmax. lra.
Qed.

Section Share.
Variable h : R -> R.
Hypothesis N : normalised h.
(* but for e around the instants |h| stays below 1 *)
Lemma below_one L e : 0 < e -> (forall t, 0 <= t <= 2 * PI -> ~ In t L -> exists e, 0 < e /\ forall s, Rabs (s - t) < e -> Rabs (h s) <= 1 - e) ->
  exists s, 0 < s /\ forall t, 0 <= t <= 2 * PI -> (exists l, In l L /\ Rabs (t - l) < e) \/ Rabs (h t) <= 1 - s.
Proof.
  intros he F. pose proof PI_RGT_0. apply uniform; [ lra | intros s d t Hd [I | I]; [ now left | right; lra ] | ].
  intros t Ht. destruct (Classical_Prop.classic (In t L)) as [I | I]; [ exists e; split; eauto | destruct (F t Ht I) as (d & d0 & D); exists d;
    auto ].
Qed.
Variables (l p : R) (vx vy : R -> R).
Hypothesis hl : 0 <= l <= 1.
Hypothesis M : moves l h p vx vy.
Notation v t := (nrm (vx t) (vy t)).
Lemma grows_little x y : 0 <= x <= y -> v y <= v x + (1 - l) * (y - x).
Proof.
  intros Hx. apply (grows l (fun t => - h (p + t)) (fun _ => 0)); trivial; try lra. exact (pulled_right h N p). intros t _. rewrite pulled. apply N.
Qed.
(* the time without rest in a period *)
Lemma moving_time L e s a b : 0 < e -> 0 <= 1 - l < s -> 0 < a <= b -> (forall x, a <= x <= b -> (exists i, In i L /\
  Rabs (p + x - i) < e) \/ Rabs (h (p + x)) <= 1 - s) ->
  exists y, rest_time (fun t => v t) a b y /\ v b + (s - (1 - l)) * (b - a - y) <= v a + s * (4 * e * INR (length L)).
Proof.
  intros he hs Hab F. set (E x := near_instants (2 * e) L (p + x)).
  destruct (creep (fun x => exists y, rest_time (fun t => v t) a x y /\ v x + (s - (1 - l)) * (x - a - y) <= v a + s * (E x - E a)) a b) as (y &
    R & Q); [ lra | exists 0; split; [ constructor | lra ] | | ].
  2: { exists y. split; trivial. pose proof (near_all (2 * e) L (p + a) (p + b) ltac:(lra)) as K. fold (E a) in K. fold (E b) in K.
       assert (s * (E b - E a) <= s * (4 * e * INR (length L))) by (apply Rmult_le_compat_l; lra). lra. }
  intros u Hu. destruct (Classical_Prop.classic (exists i, In i L /\ Rabs (p + u - i) < 2 * e)) as [(i & I & Hi) | no].
  - exists (2 * e - Rabs (p + u - i)). split; [ lra | ]. intros x y Hx Hy ax yb (r & R & Q). exists r.
    split; [ apply (rest_wait _ _ x); trivial; lra | ].
    pose proof (grows_little x y ltac:(lra)). assert (K : E x + (y - x) <= E y).
    { assert (- Rabs (p + u - i) <= p + u - i <= Rabs (p + u - i)) by (apply Rabs_le_between; lra).
      replace (y - x) with (p + y - (p + x)) by ring. apply (near_in _ _ i); trivial; lra. }
    assert (s * (E x + (y - x)) <= s * E y) by (apply Rmult_le_compat_l; lra). lra.
  - exists e. split; trivial. intros x y Hx Hy ax yb (r & R & Q). assert (K : E x <= E y) by (apply near_up; lra).
    assert (s * E x <= s * E y) by (apply Rmult_le_compat_l; lra).
    destruct (comes_to_rest l (fun t => - h (p + t)) (fun _ => 0) vx vy ltac:(lra) M (pulled_right h N p) (s - (1 - l)) x y) as [G
      | (z & Hz & G & Z)]; try lra.
    + intros t Ht. rewrite pulled. destruct (F t ltac:(lra)) as [(i & I & Hi) | ]; [ exfalso | lra ]. apply no. exists i. split; trivial.
      apply Rabs_def2 in Hi. apply Rabs_def1; lra.
    + exists r. split; [ apply (rest_wait _ _ x); trivial; lra | lra ].
    + exists (r + (y - z)). split; [ apply (rest_more _ _ z); trivial; [ apply (rest_wait _ _ x); trivial; lra | lra ] | ].
      rewrite (Z y) by lra. lra.
Qed.
End Share.

Lemma mostly_at_rest h : normalised h -> full_at_instants h -> forall eps, 0 < eps -> exists l0, l0 < 1 /\ forall l, l0 < l < 1 ->
  forall p vx vy, moves l h p vx vy ->
  exists t1, forall t, t1 <= t -> rests_for (fun t => nrm (vx t) (vy t)) t (t + 2 * PI) (2 * PI * (1 - eps)).
Proof.
  intros N [L F] eps he. pose proof PI_RGT_0. set (n := INR (length L)). assert (n0 : 0 <= n) by apply pos_INR.
  set (e := PI * eps / (16 * (n + 1))). assert (e0 : 0 < e) by (unfold e; apply Rdiv_lt_0_compat; nra). assert (en : 16 * e * n <= PI * eps).
  { assert (16 * e * (n + 1) = PI * eps) by (unfold e; field; lra). nra. }
  destruct (below_one h L e e0 F) as (s & s0 & S). assert (m1 : mean (fun t => Rabs (h t)) < 1).
  { apply mean_below_one; trivial. destruct (left_out L 0 (2 * PI) ltac:(lra)) as (x & Hx & I). destruct (F x ltac:(lra) I) as (d & d0 & D).
    exists x. specialize (D x). rewrite Rminus_eq_0, Rabs_R0 in D. specialize (D d0). lra. }
  set (g := Rmin (s / 2) (s * eps / 4)). assert (g0 : 0 < g) by (apply Rmin_pos; nra).
  assert (gs : g <= s / 2 /\ g <= s * eps / 4) by (split; [ apply Rmin_l | apply Rmin_r ]).
  exists (Rmax (1 - g) (Rmax 0 (mean (fun t => Rabs (h t))))). split; [ unfold Rmax; repeat destruct Rle_dec; lra | ]. intros l [l0 l1] p vx vy M.
  apply Rmax_Rlt in l0 as [lg l0]. apply Rmax_Rlt in l0 as [l0 lm]. destruct (above_the_mean h N l ltac:(lra) p vx vy M) as [(_ & [t0 R] & _)
    | [k _]]; [ | lra ].
  exists (Rmax 0 t0 + 4 * PI). intros t Ht. pose proof (Rmax_l 0 t0). pose proof (Rmax_r 0 t0).
  destruct (R (t - 2 * PI) ltac:(lra)) as (z & d & Hz & hd & Z). pose proof (grows_little h N l p vx vy ltac:(lra) M z t ltac:(lra)) as vt.
  rewrite (Z z) in vt by lra.
  destruct (per_spec 0 (2 * PI) ltac:(lra) (p + t)) as [k Hk]. set (K := map (fun i => i + IZR k * (2 * PI)) L ++ map (fun i => i + (IZR k + 1) *
    (2 * PI)) L).
  assert (lK : INR (length K) = 2 * n) by (unfold K, n; rewrite app_length, !map_length, plus_INR; ring).
  destruct (moving_time h N l p vx vy ltac:(lra) M K e s t (t + 2 * PI)) as (y & Y & Q); try lra.
  - intros x Hx. assert (A : forall j, 0 <= p + x - IZR j * (2 * PI) <= 2 * PI -> (forall i, In i L -> In (i + IZR j * (2 * PI)) K) ->
    (exists i, In i K /\ Rabs (p + x - i) < e) \/ Rabs (h (p + x)) <= 1 - s).
    { intros j Hj I. rewrite <- (shift_Z (2 * PI) h (d_per N) j). destruct (S _ Hj) as [(i & Ii & Hi) | ]; [ left | now right ].
      exists (i + IZR j * (2 * PI)). split; [ now apply I | ].
      now replace (p + x - (i + IZR j * (2 * PI))) with (p + x - IZR j * (2 * PI) - i) by ring. }
    destruct (Rle_dec (p + x - IZR k * (2 * PI)) (2 * PI)); [ apply (A k) | apply (A (k + 1)%Z) ]; rewrite ?plus_IZR; try lra; intros i I;
      unfold K; apply in_or_app.
    + left. now apply (in_map (fun i => i + IZR k * (2 * PI))).
    + right. now apply (in_map (fun i => i + (IZR k + 1) * (2 * PI))).
  - exists y. split; trivial. rewrite lK in Q. pose proof (nrm_pos (vx (t + 2 * PI)) (vy (t + 2 * PI))) as v0. pose proof (rest_time_le _ _ _ _ Y).
    assert (q1 : (1 - l) * (t - z) <= g * (2 * PI)) by (apply Rmult_le_compat;
      lra). assert (q2 : s * (4 * e * (2 * n)) <= s * (PI * eps / 2)) by (apply Rmult_le_compat_l; lra).
    assert (q3 : g * (2 * PI) <= s * eps / 4 * (2 * PI)) by (apply Rmult_le_compat_r; lra).
    apply Rnot_lt_le. intros far. assert (x0 : 2 * PI * eps < 2 * PI - y) by lra. assert (0 < 2 * PI * eps) by nra.
    assert (s / 2 * (2 * PI - y) <= (s - (1 - l)) * (2 * PI - y)) by (apply Rmult_le_compat_r; lra).
    assert (s / 2 * (2 * PI * eps) < s / 2 * (2 * PI - y)) by (apply Rmult_lt_compat_l; lra).
    replace (t + 2 * PI - t - y) with (2 * PI - y) in Q by ring. lra.
Qed.

Lemma sine_full : full_at_instants sin.
Proof.
  exists (PI / 2 :: 3 * (PI / 2) :: nil). intros t Ht I. simpl in I. assert (S : Rabs (sin t) < 1).
  { pose proof (SIN_bound t). apply Rnot_le_lt. intros k. destruct (cos_eq_0_2PI_0 t) as [e | e]; try lra.
    pose proof (unit_circle t). assert (1 <= sin t ^ 2) by (rewrite <- pow2_abs; nra). nra. }
  exists ((1 - Rabs (sin t)) / 2). split; [ lra | ]. intros s Hs. pose proof (sin_near s t). pose proof (Rabs_triang_inv (sin s) (sin t)). lra.
Qed.
