(* Every start in the plane has a motion, whatever the drive.
   Steps of length d, with the friction of their ends, miss Coulomb's law by a multiple of d;
   what misses it by little stays close together (near_apart), so the steps converge; and near each moment the limit stays close to a straight
   line in the plane of velocities that obeys the law (start_line), slipping or at rest. *)
Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis.
Open Scope R_scope.

(* a motion on [S, T] whose friction lacks at most d of its power, and whose law is missed by at most e *)
Record near (k d e S T : R) (Ax Ay x y : R -> R) : Prop := {
  near_c : forall t, S < t <= T -> continuity_pt x t /\ continuity_pt y t;
  near_law : forall t, S <= t < T -> exists fx fy lx ly, fx ^ 2 + fy ^ 2 <= k ^ 2 /\ fx * x t + fy * y t <= d - k * nrm (x t) (y t) /\
    rder x t lx /\ rder y t ly /\ nrm (lx - fx + Ax t) (ly - fy + Ay t) <= e }.
Lemma near_sub k d e S T S' T' Ax Ay x y : near k d e S T Ax Ay x y -> S <= S' -> T' <= T -> near k d e S' T' Ax Ay x y.
Proof. intros [C L] H1 H2. split; intros t Ht; [ apply C | apply L ]; lra. Qed.

Lemma root_bound x y q : 0 <= q -> Rabs x <= sqrt (x ^ 2 + y ^ 2 + q ^ 2) /\ Rabs y <= sqrt (x ^ 2 + y ^ 2 + q ^ 2) /\
  q <= sqrt (x ^ 2 + y ^ 2 + q ^ 2) <= Rabs x + Rabs y + q.
Proof.
  intros Hq. assert (e : sqrt (x ^ 2 + y ^ 2 + q ^ 2) = nrm (nrm x y) q) by (unfold nrm at 1; now rewrite nrm_sq). rewrite e.
  destruct (abs_nrm x y). destruct (abs_nrm (nrm x y) q) as [a b]. pose proof (nrm_abs x y). pose proof (nrm_abs (nrm x y) q) as c.
  pose proof (nrm_pos x y). rewrite Rabs_pos_eq in a by trivial. rewrite (Rabs_pos_eq q) in * by trivial.
  rewrite (Rabs_pos_eq (nrm x y)) in c by trivial. lra.
Qed.

Lemma near_apart k d1 d2 e1 e2 S T q Ax Ay x1 y1 x2 y2 : 0 <= k -> 0 < q -> 0 <= d1 + d2 -> 0 <= e1 + e2 -> S <= T ->
  near k d1 e1 S T Ax Ay x1 y1 -> near k d2 e2 S T Ax Ay x2 y2 ->
  sqrt ((x1 T - x2 T) ^ 2 + (y1 T - y2 T) ^ 2 + q ^ 2) <=
  sqrt ((x1 S - x2 S) ^ 2 + (y1 S - y2 S) ^ 2 + q ^ 2) + ((d1 + d2) / q + (e1 + e2)) * (T - S).
Proof.
  intros Hk Hq Hd He HST [C1 L1] [C2 L2]. set (Q t := (x1 t - x2 t) ^ 2 + (y1 t - y2 t) ^ 2 + q ^ 2). set (c := (d1 + d2) / q + (e1 + e2)).
  assert (Qp : forall t, 0 < Q t) by (intros t; unfold Q; pose proof (pow2_ge_0 (x1 t - x2 t)); pose proof (pow2_ge_0 (y1 t - y2 t)); nra).
  enough (sqrt (Q T) - c * T <= sqrt (Q S) - c * S) by (unfold Q in *; lra).
  apply (rder_decr (fun t => sqrt (Q t) - c * t)); trivial; intros s Hs.
  - destruct (C1 s Hs). destruct (C2 s Hs). apply (continuity_pt_minus (fun t => sqrt (Q t)) (fun t => c * t)); [ | cont ].
    apply cont_root; [ unfold Q; cont | left; apply Qp ].
  - destruct (L1 s Hs) as (fx & fy & lx & ly & B & P & X & Y & N). destruct (L2 s Hs) as (gx & gy & mx & my & B' & P' & X' & Y' & N').
    set (M := (x1 s - x2 s) * (lx - mx) + (y1 s - y2 s) * (ly - my)).
    assert (DQ : rder Q s (2 * M)) by (eapply rder_eq; [ unfold Q; rd | unfold M; simpl; ring ]).
    eexists. split. apply (rder_minus (fun t => sqrt (Q t)) (fun t => c * t)); [ | rd ].
    apply (rder_root Q _ _ DQ (Qp s)). cbv beta.
    destruct (root_bound (x1 s - x2 s) (y1 s - y2 s) q ltac:(lra)) as (_ & _ & r0 & _). fold (Q s) in r0.
    assert (D0 : nrm (x1 s - x2 s) (y1 s - y2 s) <= sqrt (Q s)) by (unfold nrm, Q; apply sqrt_le_1_alt; pose proof (pow2_ge_0 q); lra).
    set (r := sqrt (Q s)) in *. replace (/ (2 * r) * (2 * M)) with (M / r) by (field; lra).
    enough (M / r <= c) by lra. apply Rle_div_l. lra. unfold c. rewrite Rmult_plus_distr_r.
    assert (K1 : d1 + d2 <= (d1 + d2) / q * r). { replace ((d1 + d2) / q * r) with ((d1 + d2) * (r / q)) by (field; lra).
      assert (1 <= r / q) by (apply Rle_div_r; lra). nra. }
    pose proof (power_bound _ _ _ (x2 s) (y2 s) Hk B). pose proof (power_bound _ _ _ (x1 s) (y1 s) Hk B').
    pose proof (dot_abs (lx - fx + Ax s) (ly - fy + Ay s) (x1 s - x2 s) (y1 s - y2 s)) as R1.
    pose proof (dot_abs (mx - gx + Ax s) (my - gy + Ay s) (x1 s - x2 s) (y1 s - y2 s)) as R2.
    set (D := nrm (x1 s - x2 s) (y1 s - y2 s)) in *. assert (Dp : 0 <= D) by apply nrm_pos.
    apply Rabs_le_between in R1, R2. apply (Rmult_le_compat_r D) in N, N'; trivial.
    assert ((e1 + e2) * D <= (e1 + e2) * r) by (apply Rmult_le_compat_l; trivial). unfold M. lra.
Qed.

(* the friction factor of one step: -brake y is the friction, y - d * brake y the velocity at the end of the step, y the one without friction *)
Definition brake k d yx yy := k / Rmax (k * d) (nrm yx yy).
Lemma brake_law k d yx yy : 0 <= k -> 0 < d ->
  coulomb k (yx - d * (brake k d yx yy * yx)) (yy - d * (brake k d yx yy * yy)) (- (brake k d yx yy * yx)) (- (brake k d yx yy * yy)).
Proof.
  intros Hk Hd. unfold brake. pose proof (nrm_sq yx yy) as e. pose proof (nrm_pos yx yy) as n0. set (n := nrm yx yy) in *.
  set (b := k / Rmax (k * d) n).
  assert (Q : 0 <= b /\ d * b <= 1 /\ b * n <= k /\ (1 - d * b) * (k - b * n) = 0).
  { destruct Hk as [Hk | <-]. 2: { unfold b, Rdiv. rewrite Rmult_0_l. lra. } assert (kd : 0 < k * d) by nra. unfold b, Rmax.
    destruct Rle_dec as [c | c].
    - replace (k / n * n) with k by (field; lra). assert (0 < k / n) by (apply Rdiv_lt_0_compat; lra). repeat split; try lra.
      replace (d * (k / n)) with (k * d / n) by (field; lra). apply Rle_div_l; lra.
    - replace (k / (k * d)) with (/ d) by (field; lra). rewrite Rinv_r by lra. assert (0 < / d) by now apply Rinv_0_lt_compat. repeat split; try lra.
      rewrite Rmult_comm. apply Rle_div_l; lra. }
  destruct Q as (b0 & b1 & b2 & b3). split.
  - replace ((- (b * yx)) ^ 2 + (- (b * yy)) ^ 2) with (b ^ 2 * (yx ^ 2 + yy ^ 2)) by ring. rewrite <- e.
    replace (b ^ 2 * n ^ 2) with ((b * n) ^ 2) by ring.
    apply pow_incr. split; trivial. now apply Rmult_le_pos.
  - replace (yx - d * (b * yx)) with ((1 - d * b) * yx) by ring. replace (yy - d * (b * yy)) with ((1 - d * b) * yy) by ring.
    rewrite nrm_scale by lra. fold n. transitivity (- (b * (1 - d * b)) * (yx ^ 2 + yy ^ 2)). ring. rewrite <- e. 
    assert (n * ((1 - d * b) * (k - b * n)) = 0) by (rewrite b3; ring). lra.
Qed.

(* from every velocity, under every drive of the moment, a straight line in the plane of velocities obeys the law to second order *)
Lemma start_line k vx vy ax ay : 0 <= k -> exists fx fy C r, coulomb k vx vy fx fy /\ 0 <= C /\ 0 < r /\ forall h, 0 <= h < r ->
  fx * (vx + (fx - ax) * h) + fy * (vy + (fy - ay) * h) <= C * h ^ 2 - k * nrm (vx + (fx - ax) * h) (vy + (fy - ay) * h).
Proof.
  intros Hk. destruct (nrm_pos vx vy) as [n0 | z].
  - set (n := nrm vx vy) in *. set (fx := - k * vx / n). set (fy := - k * vy / n). set (lx := fx - ax). set (ly := fy - ay). set (L := nrm lx ly).
    assert (L0 : 0 <= L) by apply nrm_pos. pose proof (nrm_sq lx ly) as eL. fold L in eL. pose proof (nrm_sq vx vy) as en. fold n in en.
    exists fx, fy, (k * L ^ 2 / n), (n / (2 * (L + 1))). split. { apply coulomb_iff; trivial. right. fold n. unfold fx, fy. repeat split; lra. }
    split. { apply Rmult_le_pos; [ nra | left; now apply Rinv_0_lt_compat ]. } split. { apply Rdiv_lt_0_compat; lra. }
    intros h [h0 h1]. apply Rlt_div_r in h1; [ | lra ]. set (ux := vx + lx * h). set (uy := vy + ly * h).
    set (p := (vx * ux + vy * uy) / n). pose proof (dot_abs lx ly vx vy) as Q. fold L n in Q. apply Rabs_le_between in Q.
    assert (p1 : n / 2 <= p). { unfold p. apply -> (Rle_div_r (n / 2)); trivial. unfold ux, uy. nra. }
    assert (U : nrm ux uy <= p + h ^ 2 * L ^ 2 / n).
    { assert (q0 : 0 <= h ^ 2 * L ^ 2 / n) by (apply Rmult_le_pos; [ nra | left; now apply Rinv_0_lt_compat ]). apply nrm_le. lra.
      assert (E : ux ^ 2 + uy ^ 2 = p ^ 2 + h ^ 2 * ((vx * ly - vy * lx) ^ 2 / n ^ 2)).
      { unfold p. apply (Rmult_eq_reg_r (n ^ 2)); [ | nra ]. replace ((((vx * ux + vy * uy) / n) ^ 2 + h ^ 2 * ((vx * ly - vy * lx) ^ 2 / n ^ 2)) * n
        ^ 2)
          with ((vx * ux + vy * uy) ^ 2 + h ^ 2 * (vx * ly - vy * lx) ^ 2) by (field; lra). rewrite en. unfold ux, uy. ring. }
      assert (X : (vx * ly - vy * lx) ^ 2 / n ^ 2 <= L ^ 2). { apply Rle_div_l. nra. rewrite eL, en. pose proof (pow2_ge_0 (vx * lx + vy * ly)).
      nra. }
      assert (h ^ 2 * ((vx * ly - vy * lx) ^ 2 / n ^ 2) <= h ^ 2 * L ^ 2) by (apply Rmult_le_compat_l; [ apply pow2_ge_0 | trivial ]).
      assert (e : h ^ 2 * L ^ 2 = n * (h ^ 2 * L ^ 2 / n)) by (field; lra).
      set (w := h ^ 2 * L ^ 2 / n) in *. assert (n * w <= 2 * p * w) by (apply Rmult_le_compat_r; lra). rewrite E. pose proof (pow2_ge_0 w). lra. }
    change (fx * ux + fy * uy <= k * L ^ 2 / n * h ^ 2 - k * nrm ux uy).
    replace (fx * ux + fy * uy) with (- (k * p)) by (unfold fx, fy, p; field; lra).
    apply (Rmult_le_compat_l k) in U; trivial. replace (k * L ^ 2 / n * h ^ 2) with (k * (h ^ 2 * L ^ 2 / n)) by (field; lra). lra.
  - destruct (nrm_zero _ _ (eq_sym z)) as [-> ->]. pose proof (brake_law k 1 (- ax) (- ay) Hk Rlt_0_1) as [B P].
    set (b := brake k 1 (- ax) (- ay)) in *.
    exists (- (b * - ax)), (- (b * - ay)), 0, 1. split. { split; trivial. rewrite nrm_0. ring. } split. lra. split. lra. intros h Hh.
    rewrite !Rplus_0_l, !(Rmult_comm _ h), nrm_scale by lra. replace (- (b * - ax) - ax) with (- ax - 1 * (b * - ax)) by ring.
    replace (- (b * - ay) - ay) with (- ay - 1 * (b * - ay)) by ring. apply (Rmult_eq_compat_l h) in P. lra.
Qed.

Definition clamp d s := Rmax 0 (Rmin d s).
Lemma clamp_0 d s : s <= 0 -> 0 < d -> clamp d s = 0. Proof. intros. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.
Lemma clamp_mid d s : 0 <= s <= d -> clamp d s = s. Proof. intros. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.
Lemma clamp_d d s : d <= s -> 0 < d -> clamp d s = d. Proof. intros. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.

(* a drive A, by components (true: x, false: y), with its primitive H: jumps of A are allowed *)
Section Exist.
Variables (k : R) (A H : bool -> R -> R) (c : bool -> R).
Hypothesis hk : 0 <= k.
Hypothesis cH : forall b t, 0 < t -> continuity_pt (H b) t.
Hypothesis dH : forall b t, 0 <= t -> rder (H b) t (A b t).
Hypothesis hA : forall T, exists a, 0 <= a /\ forall b t, 0 <= t <= T -> Rabs (A b t) <= a.
Hypothesis rA : forall b t e, 0 <= t -> 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> Rabs (A b s - A b t) <= e.

(* n steps of length d, without the drive: velocity + H *)
Definition fric d (g : bool -> R -> R) e b := - (brake k d (g true e - H true e) (g false e - H false e) * (g b e - H b e)).
Fixpoint steps d n b s := match n with O => c b + H b 0 | S j => steps d j b s + fric d (steps d j) (INR (S j) * d) b * clamp d (s - INR j * d) end.
Definition trail d n b s := steps d n b s - H b s.

Section Step.
Variable d : R.
Hypothesis hd : 0 < d <= 1.
Lemma steps_late j b s s' : INR j * d <= s -> INR j * d <= s' -> steps d j b s = steps d j b s'.
Proof.
  induction j as [ | j IH ]; intros h h'; cbn [steps]; trivial. rewrite S_INR in h, h'. rewrite (IH ltac:(lra) ltac:(lra)), !clamp_d by lra.
  reflexivity.
Qed.
Lemma steps_early n j b s : (j <= n)%nat -> s <= INR j * d -> steps d n b s = steps d j b s.
Proof.
  induction 1 as [ | n L IH ]; intros h; cbn [steps]; trivial. apply le_INR in L. apply (Rmult_le_compat_r d) in L; [ | lra ].
  rewrite IH, clamp_0 by lra. ring.
Qed.
Lemma steps_at n j b s : (j < n)%nat -> INR j * d <= s <= INR (S j) * d ->
  steps d n b s = steps d j b (INR (S j) * d) + fric d (steps d j) (INR (S j) * d) b * (s - INR j * d).
Proof.
  intros L h. rewrite (steps_early n (S j)) by (trivial; lra). cbn [steps]. rewrite S_INR in *. rewrite clamp_mid by lra.
  rewrite (steps_late j b s ((INR j + 1) * d)) by lra. reflexivity.
Qed.
Lemma steps_cont n b t : continuity_pt (steps d n b) t.
Proof.
  induction n as [ | n IH ]; cbn [steps]. cont. apply (continuity_pt_plus (steps d n b)); trivial. apply continuity_pt_mult. cont.
  apply (cont_lip _ t 1 1 Rlt_0_1). intros s _. unfold clamp, Rmax, Rmin, Rabs. repeat (destruct Rle_dec || destruct Rcase_abs); lra.
Qed.
Lemma step_law j : coulomb k (trail d (S j) true (INR (S j) * d)) (trail d (S j) false (INR (S j) * d))
  (fric d (steps d j) (INR (S j) * d) true) (fric d (steps d j) (INR (S j) * d) false).
Proof.
  pose proof (brake_law k d (steps d j true (INR (S j) * d) - H true (INR (S j) * d)) (steps d j false (INR (S j) * d) - H false (INR (S j) * d)) hk
  (proj1 hd)) as B.
  unfold trail. rewrite !(steps_at (S j) j) by (try lia; rewrite S_INR; lra). unfold fric in *.
  replace (INR (S j) * d - INR j * d) with d by (rewrite S_INR; ring).
  match goal with |- coulomb _ ?u ?v _ _ => match type of B with coulomb _ ?u' ?v' _ _ => replace u with u' by ring;
  replace v with v' by ring end end. exact B.
Qed.
Lemma H_lip T a b s t : (forall b t, 0 <= t <= T -> Rabs (A b t) <= a) -> 0 <= s <= t -> t <= T -> Rabs (H b t - H b s) <= a * (t - s).
Proof. intros Ha Hs Ht. apply rder_lip; try lra; intros r Hr. apply cH; lra. exists (A b r). split; [ apply dH | apply Ha ]; lra. Qed.
Lemma trail_near n T a : 0 <= a -> (forall b t, 0 <= t <= T + 1 -> Rabs (A b t) <= a) -> T <= INR n * d ->
  near k (4 * k * (k + a) * d) 0 0 T (A true) (A false) (trail d n true) (trail d n false).
Proof.
  intros a0 Ha HT. split. { intros t Ht. split; (apply continuity_pt_minus; [ apply steps_cont | apply cH; lra ]). }
  intros t Ht. destruct (nfloor_ex (t / d)) as [j [j1 j2]]. { apply Rmult_le_pos; [ lra | left; apply Rinv_0_lt_compat; lra ]. }
  apply Rle_div_r in j1; [ | lra ]. apply Rlt_div_l in j2; [ | lra ].
  assert (jn : (j < n)%nat). { apply INR_lt, (Rmult_lt_reg_r d); lra. }
  set (e := INR (S j) * d). assert (ee : e = INR j * d + d) by (unfold e; rewrite S_INR; ring). set (F := fric d (steps d j) e).
  assert (at_ : forall b s, INR j * d <= s <= e -> trail d n b s = steps d j b e + F b * (s - INR j * d) - H b s).
  { intros b s Hs. unfold trail. now rewrite (steps_at n j) by trivial. }
  destruct (step_law j) as [B P]. fold e F in B, P. assert (F1 : forall b, Rabs (F b) <= k).
  { intros b. apply Rabs_le. pose proof (pow2_ge_0 (F true)). pose proof (pow2_ge_0 (F false)). destruct b; split; nra. }
  assert (R : forall b, rder (trail d n b) t (F b - A b t)).
  { intros b. apply (rder_minus (steps d n b)); [ | apply dH; lra ].
    apply (rder_near _ (fun s => steps d j b e + F b * (s - INR j * d)) t _ (e - t)); [ lra | | eapply rder_eq; [ rd | ring ] ].
    intros s Hs. symmetry. apply steps_at; trivial. fold e. lra. }
  exists (F true), (F false), (F true - A true t), (F false - A false t). split; trivial. split; [ | split; [ | split ] ].
  - set (D := (k + a) * d). assert (E : forall b, Rabs (trail d n b t - trail d (S j) b e) <= D).
    { intros b. assert (e1 : trail d (S j) b e = trail d n b e). { unfold trail. rewrite (steps_early n (S j)) by (trivial; fold e; lra).
      reflexivity. }
      rewrite e1, !at_ by lra. pose proof (H_lip (T + 1) a b t e Ha ltac:(lra) ltac:(lra)) as L.
      replace (steps d j b e + F b * (t - INR j * d) - H b t - (steps d j b e + F b * (e - INR j * d) - H b e)) with ((H b e - H b t) + - (F b * (e -
      t))) by ring.
      eapply Rle_trans; [ apply Rabs_triang | ]. rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (e - t)) by lra. specialize (F1 b).
      pose proof (Rabs_pos (F b)).
      unfold D. assert (a * (e - t) <= a * d) by (apply Rmult_le_compat_l; lra).
      assert (Rabs (F b) * (e - t) <= k * d) by (apply Rmult_le_compat; lra). lra. }
    pose proof (E true) as E1. pose proof (E false) as E2. set (zx := trail d (S j) true e) in *. set (zy := trail d (S j) false e) in *.
    set (wx := trail d n true t) in *. set (wy := trail d n false t) in *. pose proof (nrm_near wx wy zx zy) as N. apply Rabs_le_between in N.
    pose proof (F1 true) as G1. pose proof (F1 false) as G2. assert (D0 : 0 <= D) by (unfold D; apply Rmult_le_pos; lra).
    assert (K : F true * (wx - zx) + F false * (wy - zy) <= 2 * k * D).
    { assert (X : forall f z, Rabs f <= k -> Rabs z <= D -> f * z <= k * D). { intros f z hf hz. eapply Rle_trans; [ apply Rle_abs | ].
      rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
      pose proof (X _ _ G1 E1). pose proof (X _ _ G2 E2). lra. }
    assert (k * nrm wx wy <= k * (nrm zx zy + 2 * D)) by (apply Rmult_le_compat_l; lra).
    replace (4 * k * (k + a) * d) with (4 * k * D) by (unfold D; ring). lra.
  - apply R.
  - apply R.
  - apply nrm_le. lra. right. ring.
Qed.
End Step.

Definition dn n := / INR (S n).
Definition walk n b t := trail (dn n) (S n * S n) b t.
Lemma dn_pos n : 0 < dn n <= 1.
Proof.
  unfold dn. assert (1 <= INR (S n)) by (rewrite S_INR; pose proof (pos_INR n); lra). split. apply Rinv_0_lt_compat; lra. rewrite <- Rinv_1.
  apply Rinv_le_contravar; lra.
Qed.
Lemma dn_small e : 0 < e -> exists N, forall n, (N <= n)%nat -> dn n < e /\ / e <= INR (S n).
Proof.
  intros He. destruct (archimed_cor1 e He) as (N & h & p). exists N. intros n Hn. apply lt_0_INR in p.
  assert (INR N <= INR (S n)) by (apply le_INR; lia).
  split. apply Rle_lt_trans with (2 := h). now apply Rinv_le_contravar. apply Rle_trans with (INR N); trivial. rewrite <- (Rinv_inv (INR N)).
  apply Rinv_le_contravar; [ now apply Rinv_0_lt_compat | lra ].
Qed.
Lemma walk_near n T a : 0 <= a -> (forall b t, 0 <= t <= T + 1 -> Rabs (A b t) <= a) -> T <= INR (S n) ->
  near k (4 * k * (k + a) * dn n) 0 0 T (A true) (A false) (walk n true) (walk n false).
Proof.
  intros a0 Ha HT. apply trail_near; trivial. apply dn_pos. rewrite mult_INR. unfold dn.
  replace (INR (S n) * INR (S n) * / INR (S n)) with (INR (S n)) by (field; apply not_0_INR; lia). exact HT.
Qed.
Lemma walk_0 n b : walk n b 0 = c b.
Proof. unfold walk, trail. rewrite (steps_early (dn n) (dn_pos n) _ 0) by (try lia; simpl; lra). simpl. ring. Qed.
Lemma walk_cauchy T e : 0 <= T -> 0 < e -> exists N, forall n m b t,
  (N <= n)%nat -> (N <= m)%nat -> 0 <= t <= T -> Rabs (walk n b t - walk m b t) <= e.
Proof.
  intros HT He. destruct (hA (T + 1)) as (a & a0 & Ha). set (C := 4 * k * (k + a)). assert (C0 : 0 <= C) by (unfold C; apply Rmult_le_pos; nra).
  set (q := e / 2). assert (q0 : 0 < q) by (unfold q; lra). assert (g0 : 0 < q ^ 2 / (2 * (C + 1) * (T + 1))) by (apply Rdiv_lt_0_compat; nra).
  destruct (dn_small _ g0) as [N1 H1]. destruct (dn_small (/ (T + 1)) ltac:(apply Rinv_0_lt_compat; lra)) as [N2 H2].
  exists (max N1 N2). intros n m b t Hn Hm Ht.
  destruct (H1 n ltac:(lia)) as [sn _]. destruct (H1 m ltac:(lia)) as [sm _]. destruct (H2 n ltac:(lia)) as [_ ln].
  destruct (H2 m ltac:(lia)) as [_ lm]. rewrite Rinv_inv in ln, lm.
  pose proof (dn_pos n). pose proof (dn_pos m).
  pose proof (near_apart k (C * dn n) (C * dn m) 0 0 0 t q _ _ _ _ _ _ hk q0 ltac:(nra) ltac:(lra) (proj1 Ht)
    (near_sub _ _ _ _ _ _ _ _ _ _ _ (walk_near n T a a0 Ha ltac:(lra)) (Rle_refl 0) (proj2 Ht)) (near_sub _ _ _ _ _ _ _ _ _ _ _ (walk_near m T a a0
    Ha ltac:(lra)) (Rle_refl 0) (proj2 Ht))) as K.
  rewrite !walk_0, !Rminus_eq_0 in K. replace (0 ^ 2 + 0 ^ 2 + q ^ 2) with (q ^ 2) in K by ring.
  rewrite sqrt_pow2, Rminus_0_r, !Rplus_0_r in K by lra.
  destruct (root_bound (walk n true t - walk m true t) (walk n false t - walk m false t) q ltac:(lra)) as (r1 & r2 & _).
  assert (G : (C * dn n + C * dn m) / q * t <= q).
  { replace ((C * dn n + C * dn m) / q * t) with (C * (dn n + dn m) * t / q) by (field; lra). apply Rle_div_l; trivial.
    set (g := q ^ 2 / (2 * (C + 1) * (T + 1))) in *. assert (eg : g * (2 * (C + 1) * (T + 1)) = q ^ 2) by (unfold g; field; lra).
    assert (C * (dn n + dn m) * t <= (C + 1) * (2 * g) * (T + 1)) by (apply Rmult_le_compat; try nra; apply Rmult_le_compat; lra). nra. }
  destruct b; unfold q in *; lra.
Qed.
Definition end_of b t := real (Lim_seq (fun n => walk n b t)).
Lemma end_lim b t e : 0 <= t -> 0 < e -> exists N, forall n, (N <= n)%nat -> Rabs (walk n b t - end_of b t) < e.
Proof.
  intros Ht He. assert (Q : ex_finite_lim_seq (fun n => walk n b t)).
  { apply ex_lim_seq_cauchy_corr. intros eps. destruct (walk_cauchy t (eps / 2) Ht) as [N HN]. { pose proof (cond_pos eps). lra. }
    exists N. intros n m Hn Hm. pose proof (cond_pos eps). specialize (HN n m b t Hn Hm ltac:(lra)). lra. }
  destruct Q as [l Hl]. assert (e1 : end_of b t = l) by (unfold end_of; now rewrite (is_lim_seq_unique _ _ Hl)). rewrite e1.
  apply is_lim_seq_spec in Hl. destruct (Hl (mkposreal e He)) as [N HN]. exists N. exact HN.
Qed.
Lemma end_0 b : end_of b 0 = c b.
Proof.
  apply cond_eq. intros e He. destruct (end_lim b 0 e (Rle_refl 0) He) as [N HN]. specialize (HN N (le_n N)). rewrite walk_0 in HN.
  rewrite Rabs_minus_sym. exact HN.
Qed.
Lemma end_lip T : 0 <= T -> exists L, forall b s t, 0 <= s <= t -> t <= T -> Rabs (end_of b t - end_of b s) <= L * (t - s).
Proof.
  intros HT. destruct (hA (T + 1)) as (a & a0 & Ha). exists (k + a). intros b s t Hs Ht. apply le_epsilon. intros e He.
  destruct (end_lim b s (e / 2) ltac:(lra) ltac:(lra)) as [N1 H1]. destruct (end_lim b t (e / 2) ltac:(lra) ltac:(lra)) as [N2 H2].
  destruct (dn_small (/ (T + 1)) ltac:(apply Rinv_0_lt_compat; lra)) as [N3 H3]. set (n := max N1 (max N2 N3)).
  specialize (H1 n ltac:(unfold n; lia)). specialize (H2 n ltac:(unfold n; lia)). destruct (H3 n ltac:(unfold n; lia)) as [_ l3].
  rewrite Rinv_inv in l3.
  destruct (walk_near n T a a0 Ha ltac:(lra)) as [C L].
  assert (K : Rabs (walk n b t - walk n b s) <= (k + a) * (t - s)).
  { apply rder_lip. lra. intros r Hr. destruct (C r ltac:(lra)). destruct b; trivial. intros r Hr.
    destruct (L r ltac:(lra)) as (fx & fy & lx & ly & B & _ & X & Y & E).
    destruct (abs_nrm (lx - fx + A true r) (ly - fy + A false r)) as [E1 E2]. pose proof (Ha true r ltac:(lra)) as A1.
    pose proof (Ha false r ltac:(lra)) as A2.
    assert (Fx : - k <= fx <= k) by (pose proof (pow2_ge_0 fy); nra). assert (Fy : - k <= fy <= k) by (pose proof (pow2_ge_0 fx); nra).
    assert (Z1 := Rle_trans _ _ _ E1 E). assert (Z2 := Rle_trans _ _ _ E2 E). apply Rabs_le_between in Z1, Z2, A1, A2.
    destruct b; eexists; (split; [ eassumption | apply Rabs_le; lra ]). }
  apply Rabs_le_between in K. apply Rabs_def2 in H1, H2. apply Rabs_le. lra.
Qed.
Lemma end_cont b t : 0 < t -> continuity_pt (end_of b) t.
Proof.
  intros Ht. destruct (end_lip (t + 1) ltac:(lra)) as [L HL]. apply (cont_lip _ t (Rmin t 1) L). apply Rmin_pos; lra.
  intros s Hs. pose proof (Rmin_l t 1). pose proof (Rmin_r t 1). apply Rabs_def2 in Hs. destruct (Rle_lt_dec t s).
  - rewrite (Rabs_pos_eq (s - t)) by lra. apply HL; lra.
  - rewrite Rabs_minus_sym, (Rabs_left (s - t)) by lra. replace (- (s - t)) with (t - s) by ring. apply HL; lra.
Qed.
Lemma end_law t : 0 <= t -> exists fx fy, coulomb k (end_of true t) (end_of false t) fx fy /\ rder (end_of true) t (fx - A true t) /\ rder (end_of
  false) t (fy - A false t).
Proof.
  intros Ht. destruct (start_line k (end_of true t) (end_of false t) (A true t) (A false t) hk) as (fx & fy & C & r & Hf & C0 & r0 & Hr).
  exists fx, fy. split; trivial. set (l b := match b with true => fx | false => fy end - A b t).
  enough (Q : forall b, rder (end_of b) t (l b)) by (split; [ apply (Q true) | apply (Q false) ]).
  destruct (hA (t + 2)) as (a & a0 & Ha). set (C' := 4 * k * (k + a)). assert (C1 : 0 <= C') by (unfold C'; apply Rmult_le_pos; nra).
  intros b. apply rder_intro. intros e0 He0. set (e := e0 / 5). assert (He : 0 < e) by (unfold e; lra).
  destruct (rA true t e Ht He) as (r1 & p1 & A1). destruct (rA false t e Ht He) as (r2 & p2 & A2).
  set (r3 := e ^ 2 / (C + 1)). assert (p3 : 0 < r3) by (apply Rdiv_lt_0_compat; nra).
  exists (Rmin (Rmin r 1) (Rmin (Rmin r1 r2) r3)). split. { repeat apply Rmin_pos; lra. } intros h [h0 Hh].
  apply Rmin_Rgt_l in Hh as [h12 Hh]. apply Rmin_Rgt_l in h12 as [h1 h2]. apply Rmin_Rgt_l in Hh as [h34 h5]. apply Rmin_Rgt_l in h34 as [h3 h4].
  unfold Rgt in *. apply Rlt_div_r in h5; [ | lra ]. set (u b s := end_of b t + l b * (s - t)).
  assert (U : near k (C * h ^ 2) (2 * e) t (t + h) (A true) (A false) (u true) (u false)).
  { split. { intros s _. unfold u. split; cont. } intros s Hs. exists fx, fy, (l true), (l false). split. apply Hf. split; [ | split; [ | split ] ].
    - specialize (Hr (s - t) ltac:(lra)). unfold u, l. assert ((s - t) ^ 2 <= h ^ 2) by (apply pow_incr; lra).
      assert (C * (s - t) ^ 2 <= C * h ^ 2) by now apply Rmult_le_compat_l. lra.
    - unfold u. eapply rder_eq. rd. ring.
    - unfold u. eapply rder_eq. rd. ring.
    - unfold l. specialize (A1 s ltac:(lra)). specialize (A2 s ltac:(lra)). eapply Rle_trans; [ apply nrm_abs | ].
      replace (fx - A true t - fx + A true s) with (A true s - A true t) by ring.
      replace (fy - A false t - fy + A false s) with (A false s - A false t) by ring. lra. }
  set (q := e * h). assert (q0 : 0 < q) by (unfold q; nra). apply le_epsilon. intros z0 Hz0. set (z := z0 / 4).
  assert (Hz : 0 < z) by (unfold z; lra).
  destruct (end_lim true t z Ht Hz) as [N1 H1]. destruct (end_lim false t z Ht Hz) as [N2 H2].
  destruct (end_lim b (t + h) z ltac:(lra) Hz) as [N3 H3].
  destruct (dn_small (z * e / (C' + 1))) as [N4 H4]. { apply Rdiv_lt_0_compat; nra.
  } destruct (dn_small (/ (t + 1)) ltac:(apply Rinv_0_lt_compat; lra)) as [N5 H5].
  set (n := max N1 (max N2 (max N3 (max N4 N5)))).
  specialize (H1 n ltac:(unfold n; lia)). specialize (H2 n ltac:(unfold n; lia)). specialize (H3 n ltac:(unfold n; lia)).
  destruct (H4 n ltac:(unfold n; lia)) as [s4 _]. destruct (H5 n ltac:(unfold n; lia)) as [_ l5]. rewrite Rinv_inv in l5.
  pose proof (dn_pos n) as [d0 _].
  assert (Wn := near_sub _ _ _ _ _ t (t + h) _ _ _ _ (walk_near n (t + 1) a a0 ltac:(intros; apply Ha; lra) l5) Ht ltac:(lra)). fold C' in Wn.
  pose proof (near_apart k (C' * dn n) (C * h ^ 2) 0 (2 * e) t (t + h) q _ _ _ _ _ _ hk q0 ltac:(nra) ltac:(lra) ltac:(lra) Wn U) as K.
  destruct (root_bound (walk n true (t + h) - u true (t + h)) (walk n false (t + h) - u false (t + h)) q ltac:(lra)) as (k1 & k2 & _).
  destruct (root_bound (walk n true t - u true t) (walk n false t - u false t) q ltac:(lra)) as (_ & _ & _ & k3).
  assert (u0 : forall b, u b t = end_of b t) by (intros; unfold u; ring). rewrite !u0 in K, k3.
  assert (G : ((C' * dn n + C * h ^ 2) / q + (0 + 2 * e)) * (t + h - t) <= z + 3 * e * h).
  { replace (((C' * dn n + C * h ^ 2) / q + (0 + 2 * e)) * (t + h - t)) with ((C' * dn n + C * h ^ 2) / e + 2 * e * h) by (unfold q; field; lra).
    enough ((C' * dn n + C * h ^ 2) / e <= z + e * h) by lra. apply Rle_div_l; trivial. apply Rlt_div_r in s4; [ | lra ].
    assert (C * h ^ 2 <= e ^ 2 * h) by (replace (C * h ^ 2) with (C * h * h) by ring; apply Rmult_le_compat_r; nra). nra. }
  assert (F : Rabs (walk n b (t + h) - u b (t + h)) <= 3 * z + 4 * e * h) by (unfold q in *; destruct b; lra).
  unfold u in F. replace (t + h - t) with h in F by ring. apply Rabs_def2 in H3. apply Rabs_le_between in F. apply Rabs_le. unfold z, e in *. nra.
Qed.
Lemma end_motion : motion k (A true) (A false) (end_of true) (end_of false) /\ forall b, end_of b 0 = c b.
Proof. split; [ split; intros; [ apply end_cont | apply end_cont | apply end_law ]; trivial | apply end_0 ]. Qed.
End Exist.

(* Every start has a motion under every drive that is continuous, or jumps and is continuous from the right: Hx, Hy are its primitives. *)
Theorem drive_has_a_motion k Ax Ay Hx Hy vx0 vy0 : 0 <= k ->
  (forall t, 0 < t -> continuity_pt Hx t /\ continuity_pt Hy t) -> (forall t, 0 <= t -> rder Hx t (Ax t) /\ rder Hy t (Ay t)) ->
  (forall T, exists a, forall t, 0 <= t <= T -> nrm (Ax t) (Ay t) <= a) ->
  (forall t e, 0 <= t -> 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> nrm (Ax s - Ax t) (Ay s - Ay t) <= e) ->
  exists vx vy, motion k Ax Ay vx vy /\ vx 0 = vx0 /\ vy 0 = vy0.
Proof.
  intros Hk C D B J. set (two := fun (f g : R -> R) (b : bool) => if b then f else g). set (c := fun b : bool => if b then vx0 else vy0).
  assert (cH : forall b t, 0 < t -> continuity_pt (two Hx Hy b) t) by (intros b t Ht; destruct (C t Ht); destruct b; trivial).
  assert (dH : forall b t, 0 <= t -> rder (two Hx Hy b) t (two Ax Ay b t)) by (intros b t Ht; destruct (D t Ht); destruct b; trivial).
  assert (hA : forall T, exists a, 0 <= a /\ forall b t, 0 <= t <= T -> Rabs (two Ax Ay b t) <= a).
  { intros T. destruct (B T) as [a Ha]. exists (Rabs a). split. apply Rabs_pos. intros b t Ht. specialize (Ha t Ht). destruct (abs_nrm (Ax t) (Ay t)). pose proof (Rle_abs a).
    destruct b; simpl; lra. }
  assert (rA : forall b t e, 0 <= t -> 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> Rabs (two Ax Ay b s - two Ax Ay b t) <= e).
  { intros b t e Ht He. destruct (J t e Ht He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs. specialize (Hd s Hs). destruct (abs_nrm (Ax s - Ax t) (Ay s - Ay t)).
    destruct b; simpl; lra. }
  destruct (end_motion k (two Ax Ay) (two Hx Hy) c Hk cH dH hA rA) as [M e].
  exists (end_of k (two Hx Hy) c true), (end_of k (two Hx Hy) c false). exact (conj M (conj (e true) (e false))).
Qed.
(* Every start has a motion under every continuous drive. *)
Theorem plane_has_a_motion k Ax Ay vx0 vy0 : 0 <= k -> (forall t, 0 <= t -> continuity_pt Ax t /\ continuity_pt Ay t) ->
  exists vx vy, motion k Ax Ay vx vy /\ vx 0 = vx0 /\ vy 0 = vy0.
Proof.
  intros Hk C. set (A (b : bool) t := (if b then Ax else Ay) (Rmax 0 t)). set (H b := RInt (A b) 0). set (c (b : bool) := if b then vx0 else vy0).
  assert (cA : forall b t, continuity_pt (A b) t).
  { intros b t. apply (continuity_pt_comp (Rmax 0) (if b then Ax else Ay)); [ | destruct b; apply C, Rmax_l ]. apply (cont_lip _ t 1 1 Rlt_0_1).
    intros s _. unfold Rmax, Rabs. repeat (destruct Rle_dec || destruct Rcase_abs); lra. }
  assert (D : forall b t, is_derive (H b) t (A b t)) by (intros b; apply primitive_rate, cA).
  assert (M : motion k (A true) (A false) (end_of k H c true) (end_of k H c false) /\ forall b, end_of k H c b 0 = c b).
  { apply (end_motion k A H c Hk).
    - intros b t _. apply (cont_of _ _ _ (D b t)).
    - intros b t _. apply rder_of, D.
    - intros T. assert (B : forall b, exists a, 0 <= a /\ forall t, 0 <= t <= T -> Rabs (A b t) <= a).
      { intros b. destruct (Rle_lt_dec 0 T) as [HT | HT]; [ | exists 0; split; intros; lra ].
        destruct (continuity_ab_maj (fun t => Rabs (A b t)) 0 T HT) as (m & Hm & _).
        intros t _. apply (continuity_pt_comp (A b) Rabs); [ apply cA | apply Rcontinuity_abs ]. exists (Rabs (A b m)).
        split; [ apply Rabs_pos | exact Hm ]. }
      destruct (B true) as (a1 & p1 & B1). destruct (B false) as (a2 & p2 & B2). exists (a1 + a2). split. lra. intros b t Ht. specialize (B1 t Ht).
      specialize (B2 t Ht). destruct b; lra.
    - intros b t e _ He. destruct (cont_eps (A b) t e (cA b t) He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs. left.
      apply Hd, Rabs_def1; lra. }
  exists (end_of k H c true), (end_of k H c false). destruct M as [[cx cy L] e]. split; [ | split; apply e ]. split; trivial. intros t Ht.
  destruct (L t Ht) as (fx & fy & F). unfold A in F. rewrite Rmax_right in F by trivial. eauto.
Qed.
