(* 2.3: where a periodic drive of the size 1 lets the particle rest. Above the mean of |h| there is rest in every late period; below the size of
   the mean of h, and where h is 0 in the mean and does not vanish at the median of its primitive, little friction leaves no rest. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis HalfPeriod Drawn Line Straight Exists Median Mean.
Open Scope R_scope.
#[local] Arguments m_cx {k Ax Ay vx vy}.
#[local] Arguments m_law {k Ax Ay vx vy}.

(* the drive, dimensionless; piecewise continuous functions are meant, at a jump with the limit from the right:
   «$h$ has the period $2\pi$, is continuous from the right and integrable, and the least upper bound of $\lvert h\rvert$ is $1$» *)
Record normalised (h : R -> R) : Prop := { d_per : forall t, h (t + 2 * PI) = h t; d_right : forall t, rcont h t; d_int : forall a b, ex_RInt h a b;
  d_size : forall t, Rabs (h t) <= 1; d_full : forall l, l < 1 -> exists t, l < Rabs (h t) }.
Arguments d_per {h}.
Arguments d_right {h}.
Arguments d_int {h}.
Arguments d_size {h}.
Arguments d_full {h}.
(* «the mean of $f$ over a period» *)
Definition mean (f : R -> R) : R := RInt f 0 (2 * PI) / (2 * PI).
(* «$h$ is generic: $\lvert h\rvert<1$ for some time in each period, and if the mean of $h$ is $0$, then $h$ does not vanish, also as a limit
   from one side, where its antiderivative is at its median» *)
Record generic (h : R -> R) : Prop := { g_drive : normalised h; g_below : exists t, Rabs (h t) < 1;
  g_median : mean h = 0 -> exists c, median (RInt h 0) c /\
    forall t, RInt h 0 t = c -> exists e, 0 < e /\ forall s, Rabs (s - t) < e -> e <= Rabs (h s) }.
(* «under the drive $h$ and the friction $l$ each motion of the plane has, if $n=1$, rest and motion in every late period, and if $n=0$, from some
   time on no rest» *)
Definition has_rests (l : R) (h : R -> R) (n : R) : Prop := forall p vx vy, moves l h p vx vy -> let v t := nrm (vx t) (vy t) in
  (n = 1 /\ rests v /\ forall t, 0 <= t -> exists u, t <= u <= t + 2 * PI /\ v u <> 0) \/ (n = 0 /\ restless v).

(* a rest begins only where friction can hold *)
Lemma rest_held l h p vx vy s d : 0 <= l -> moves l h p vx vy -> 0 <= s -> 0 < d -> (forall u, s <= u <= s + d -> nrm (vx u) (vy u) = 0) ->
  Rabs (h (p + s)) <= l.
Proof.
  intros hl M hs hd Z. destruct (m_law M s hs) as (fx & fy & [B _] & X & _).
  pose proof (rder_rest vx s d _ hd (fun u hu => proj1 (nrm_zero _ _ (Z u hu))) X). apply Rabs_le. assert (fx ^ 2 <= l ^ 2) by nra. split; nra.
Qed.

(* where it is 0 at large times only where the drive is above friction, there are none *)
Lemma held_nowhere l h p vx vy t1 : 0 <= l -> moves l h p vx vy -> 0 <= t1 -> (forall s, t1 <= s -> vx s = 0 -> vy s = 0 -> l < Rabs (h (p + s))) ->
  restless (fun t => nrm (vx t) (vy t)).
Proof.
  intros hl M h1 S. exists t1. intros s d Hs hd. apply Classical_Prop.NNPP. intros no.
  assert (Z : forall u, s <= u <= s + d -> nrm (vx u) (vy u) = 0) by (intros u Hu; apply Classical_Prop.NNPP; intros n; apply no; eauto).
  destruct (nrm_zero _ _ (Z s ltac:(lra))) as [z1 z2]. pose proof (rest_held l h p vx vy s d hl M ltac:(lra) hd Z). specialize (S s Hs z1 z2). lra.
Qed.
Lemma unsteady_none h l : (forall t, l < Rabs (h t)) -> 0 <= l -> has_rests l h 0.
Proof. intros hh hl p vx vy M. right. split; trivial. apply (held_nowhere l h p vx vy 0); auto; lra. Qed.

Section Drive.
Variable h : R -> R.
Hypothesis N : normalised h.
Notation G := (RInt h 0).
Notation J := (RInt (fun t => Rabs (h t)) 0).
Lemma abs_int a b : ex_RInt (fun t => Rabs (h t)) a b. Proof. apply (ex_RInt_norm h), N. Qed.
Lemma abs_right t : rcont (fun t => Rabs (h t)) t.
Proof. intros e he. destruct (d_right N t e he) as (d & d0 & D). exists d. split; trivial. intros s Hs.
eapply Rle_lt_trans; [ apply Rabs_triang_inv2 | now apply D ]. Qed.
Lemma abs_size t : Rabs (Rabs (h t)) <= 1. Proof. rewrite Rabs_Rabsolu. apply N. Qed.
Lemma pulled p t : nrm (- h (p + t)) 0 = Rabs (h (p + t)). Proof. now rewrite nrm_x, Rabs_Ropp. Qed.
Lemma pulled_right p t : 0 <= t -> rcont (fun t => nrm (- h (p + t)) 0) t.
Proof. intros _ e he. destruct (abs_right (p + t) e he) as (b & b0 & B). exists b. split; trivial. intros r Hr. rewrite !pulled. apply B. lra. Qed.
Lemma mean_below_one : (exists t, Rabs (h t) < 1) -> mean (fun t => Rabs (h t)) < 1.
Proof.
  intros [t Ht]. pose proof PI_RGT_0. unfold mean. apply Rlt_div_l; [ lra | ]. destruct (abs_right t ((1 - Rabs (h t)) / 2)) as (d & d0 & D);
    [ lra | ].
  set (b := Rmin d PI / 2). assert (Hb : 0 < b < d /\ b < PI) by (unfold b, Rmin; destruct Rle_dec; lra).
  pose proof (prim_per _ abs_int (2 * PI) t (fun s => f_equal Rabs (d_per N s))) as P. pose proof (prim_between _ abs_int t (t + b)).
  pose proof (prim_between _ abs_int (t + b) (t + 2 * PI)).
  assert (A : forall s u x, s <= u -> (forall r, s <= r <= u -> Rabs (h r) <= x) -> RInt (fun t => Rabs (h t)) s u <= (u - s) * x).
  { intros s u x Hs B. eapply Rle_trans; [ apply Rle_abs | ]. apply abs_RInt_le_const; trivial; [ apply abs_int | ].
    intros; rewrite Rabs_Rabsolu. now apply B. }
  pose proof (A t (t + b) ((1 + Rabs (h t)) / 2) ltac:(lra)) as K. pose proof (A (t + b) (t + 2 * PI) 1 ltac:(lra) ltac:(intros; apply N)).
  specialize (K ltac:(intros r Hr; specialize (D r ltac:(lra)); apply Rabs_def2 in D; lra)). nra.
Qed.
Lemma has_a_motion l p : 0 <= l -> exists vx vy, moves l h p vx vy.
Proof.
  intros hl. destruct (drive_has_a_motion l (fun t => - h (p + t)) (fun _ => 0) (fun t => - G (p + t)) (fun _ => 0) 0 0) as (vx & vy & M & _);
    [ lra | | | | | exists vx, vy; exact M ].
  - intros t Ht. split; [ | cont ]. apply (continuity_pt_opp (fun t => G (p + t))), cont_phase, (prim_cont h 1); apply N.
  - intros t Ht. split; [ | rd ]. apply (rder_opp (fun t => G (p + t))), rder_phase, prim_rder; apply N.
  - intros T. exists 1. intros t _. rewrite nrm_x, Rabs_Ropp. apply N.
  - intros t e Ht he. destruct (d_right N (p + t) e he) as (d & d0 & D). exists d. split; trivial. intros s Hs. rewrite Rminus_0_r, nrm_x.
    replace (- h (p + s) - - h (p + t)) with (- (h (p + s) - h (p + t))) by ring. rewrite Rabs_Ropp. left. apply D. lra.
Qed.
(* below 1 no rest lasts for a period *)
Lemma moves_again l p vx vy t : 0 <= l < 1 -> moves l h p vx vy -> 0 <= t -> exists u, t <= u <= t + 2 * PI /\ nrm (vx u) (vy u) <> 0.
Proof.
  intros hl M Ht. pose proof PI_RGT_0. apply Classical_Prop.NNPP. intros no. destruct (d_full N l ltac:(lra)) as [x Hx].
  destruct (per_spec (p + t) (2 * PI) ltac:(lra) x) as [n Hn].
  rewrite <- (shift_Z (2 * PI) h (d_per N) n x) in Hx. set (y := x - IZR n * (2 * PI)) in *.
  enough (Rabs (h (p + (y - p))) <= l) by (replace (p + (y - p)) with y in * by ring; lra).
  apply (rest_held l h p vx vy (y - p) (t + 2 * PI - (y - p))); trivial; try (unfold y; lra). intros u Hu. apply Classical_Prop.NNPP. intros n0.
  apply no. exists u. unfold y in *. split; [ lra | trivial ].
Qed.
Lemma above_the_mean l : mean (fun t => Rabs (h t)) < l < 1 -> has_rests l h 1.
Proof.
  intros hl p vx vy M. pose proof PI_RGT_0. left. assert (m0 : 0 <= mean (fun t => Rabs (h t))).
  { unfold mean. apply Rle_div_r; [ lra | ]. rewrite Rmult_0_l. apply RInt_ge_0; [ lra | apply abs_int | intros; apply Rabs_pos ]. }
  split; trivial. split; [ | intros t Ht; apply (moves_again l p); trivial; lra ].
  exists (nrm (vx 0) (vy 0) / (l - J (2 * PI) / (2 * PI)) + 2 * PI). intros t Ht.
  apply (rest_is_certain l (fun t => - h (p + t)) (fun _ => 0) vx vy) with (m := J (2 * PI)) (J := fun t => J (p + t)); trivial; try lra.
  - apply pulled_right.
  - intros u _. apply cont_phase, (prim_cont _ 1); [ apply abs_int | apply abs_size ].
  - intros u _. rewrite pulled. apply (rder_phase J), (prim_rder _ abs_int), abs_right.
  - intros u _. rewrite <- Rplus_assoc. apply (prim_per _ abs_int). intros s; apply f_equal, N.
  - apply Rlt_div_l; [ lra | apply hl ].
Qed.
(* below the size of the mean of h it is driven away: its velocity grows beyond each number x *)
Lemma below_the_mean s l p vx vy x : s = 1 \/ s = -1 -> 0 <= l < s * mean h -> moves l h p vx vy -> exists t1, 0 <= t1 /\ forall t, t1 <= t ->
  x < s * vx t.
Proof.
  intros hs hl M. pose proof PI_RGT_0. set (m := mean h) in *. assert (em : 2 * PI * m = G (2 * PI)) by (unfold m, mean; field; lra).
  assert (D : forall t, 0 <= t -> s * vx 0 - s * G (p + 0) - l * t <= s * vx t - s * G (p + t)).
  { intros t Ht. enough (- s * vx t + s * G (p + t) - l * t <= - s * vx 0 + s * G (p + 0) - l * 0) by lra.
    apply (rder_decr (fun t => - s * vx t + s * G (p + t) - l * t)); trivial; intros r Hr.
    - pose proof (cont_phase G p r (prim_cont h 1 (d_int N) (d_size N) (p + r))). cont.
    - destruct (m_law M r ltac:(lra)) as (fx & fy & [B _] & X & _). pose proof (rder_phase G p r _ (prim_rder h (d_int N) (p + r) (d_right N _)))
      as Y.
      eexists. split; [ apply (rder_minus (fun t => - s * vx t + s * G (p + t)) (fun t => l * t));
        [ apply (rder_plus (fun t => - s * vx t) (fun t => s * G (p + t))); [ apply (rder_mult (fun _ => - s))
        | apply (rder_mult (fun _ => s)) ] | ]; rd | ].
      assert (- l <= fx <= l) by nra. destruct hs as [-> | ->]; lra. }
  (* G grows at the rate m, but for what it does within a period *)
  assert (P : forall t, 0 <= t -> s * m * t - 2 * (2 * PI) <= s * (G (p + t) - G (p + 0))).
  { intros t Ht. destruct (nfloor_ex (t / (2 * PI))) as [k Hk]; [ apply Rle_div_r; lra | ].
    assert (Hk' : INR k * (2 * PI) <= t < (INR k + 1) * (2 * PI)) by (destruct Hk; split; [ apply Rle_div_r | apply Rlt_div_l ]; lra).
    assert (P : G (p + 0) + INR k * (2 * PI * m) = G (p + INR k * (2 * PI))).
    { clear Hk Hk'. induction k as [ | j IH ]; [ simpl; rewrite !Rmult_0_l; ring | ]. rewrite S_INR.
      replace (p + (INR j + 1) * (2 * PI)) with (p + INR j * (2 * PI) + 2 * PI) by ring.
      rewrite (prim_per h (d_int N) _ _ (d_per N)), <- IH, <- em. ring. }
    pose proof (prim_lip h 1 (d_int N) (d_size N) (p + INR k * (2 * PI)) (p + t) ltac:(lra)) as K. rewrite <- P in K. apply Rabs_le_between in K.
    pose proof (prim_lip h 1 (d_int N) (d_size N) 0 (2 * PI) ltac:(lra)) as B. rewrite RInt_point in B. unfold zero in B. simpl in B.
    rewrite Rminus_0_r, <- em in B. apply Rabs_le_between in B.
    assert (- 1 <= m <= 1) by nra. destruct hs as [-> | ->]; nra. }
  destruct (grows_line (s * m - l) (s * vx 0 - 4 * PI) (x + 1) ltac:(lra)) as (t1 & t10 & L). exists t1. split; trivial. intros t Ht.
  specialize (D t ltac:(lra)). specialize (P t ltac:(lra)). specialize (L t Ht). lra.
Qed.
Lemma driven_away s l : s = 1 \/ s = -1 -> 0 <= l < s * mean h -> has_rests l h 0.
Proof.
  intros hs hl p vx vy M. right. split; trivial. destruct (below_the_mean s l p vx vy 0 hs hl M) as (t1 & _ & B). exists t1. intros t d Ht hd.
  exists t. split; [ lra | ].
  intros Z. destruct (nrm_zero _ _ Z) as [z _]. specialize (B t Ht). rewrite z in B. lra.
Qed.
Lemma prim_closed t : mean h = 0 -> G (t + 2 * PI) = G t.
Proof.
  intros m0. pose proof PI_RGT_0. rewrite (prim_per h (d_int N) _ _ (d_per N)). unfold mean in m0. apply (Rmult_eq_compat_r (2 * PI)) in m0.
  field_simplify in m0; lra.
Qed.
(* h keeps away from 0 where its primitive is near the median *)
Lemma away_from_zero c : mean h = 0 -> (forall t, G t = c -> exists e, 0 < e /\ forall s, Rabs (s - t) < e -> e <= Rabs (h s)) ->
  exists e, 0 < e /\ forall t, Rabs (G t - c) <= e -> e <= Rabs (h t).
Proof.
  intros m0 A. pose proof PI_RGT_0. pose proof (fun t => prim_closed t m0) as per.
  destruct (uniform (fun e t => Rabs (G t - c) <= e -> e <= Rabs (h t)) 0 (2 * PI)) as (e & e0 & E); [ lra | intros e d t Hd Q K;
    specialize (Q ltac:(lra)); lra | | ].
  2: { exists e. split; trivial. intros t. destruct (per_spec 0 (2 * PI) ltac:(lra) t) as [n Hn].
       rewrite <- (shift_Z (2 * PI) h (d_per N) n t), <- (shift_Z (2 * PI) G per n t). apply E. lra. }
  intros t _. destruct (Req_dec (G t) c) as [q | q]; [ destruct (A t q) as (e & e0 & E); exists e; auto | ].
  assert (0 < Rabs (G t - c)) by (apply Rabs_pos_lt; lra). exists (Rabs (G t - c) / 2). split; [ lra | ]. intros s Hs B. exfalso.
  assert (K : Rabs (G t - G s) < Rabs (G t - c) / 2).
  { apply Rabs_def2 in Hs. destruct (Rle_dec s t); [ | rewrite Rabs_minus_sym ]; (eapply Rle_lt_trans;
    [ apply (prim_lip h 1 (d_int N) (d_size N)); lra | lra ]). }
  pose proof (Rabs_triang (G t - G s) (G s - c)) as T. replace (G t - G s + (G s - c)) with (G t - c) in T by ring. lra.
Qed.
(* no mean: little friction leaves no rest *)
Lemma little_friction c : mean h = 0 -> median G c -> (forall t, G t = c -> exists e, 0 < e /\ forall s, Rabs (s - t) < e -> e <= Rabs (h s)) ->
  exists l0, 0 < l0 /\ forall l, 0 < l < l0 -> has_rests l h 0.
Proof.
  intros m0 hc A. pose proof PI_RGT_0. pose proof PI_4. destruct (away_from_zero c m0 A) as (e & e0 & E). exists (e / 4). split; [ lra | ].
  intros l hl p vx vy M. right. split; trivial.
  destruct (Classical_Prop.classic (exists s, 0 <= s /\ nrm (vx s) (vy s) = 0)) as [(s & Hs & Z) | no].
  - assert (Y : forall t, s <= t -> vy t = 0).
    { intros t Ht. pose proof (across_falls l _ vx vy ltac:(lra) M s t ltac:(lra)). destruct (nrm_zero _ _ Z) as [_ z]. rewrite z in *. nra. }
    assert (K : little l h G (p + s) (fun x => vx (x - p))).
    { split; try apply N; [ lra | apply (prim_cont h 1); apply N | intros; apply prim_rder; apply N | | ].
      - intros t. now apply prim_closed.
      - split; intros t Ht; [ apply cont_shift, (m_cx M); lra | ]. destruct (m_law M (t - p)) as (fx & fy & C & X & _); [ lra | ]. exists fx.
        rewrite Y in C by lra. destruct (coulomb_slip l _ _ _ _ ltac:(lra) C) as [Q _]. destruct C as [B _]. rewrite nrm_x in Q.
        replace (p + (t - p)) with t in X by ring. split.
        + split; [ nra | split; intros k; [ rewrite Rabs_pos_eq in Q by lra | rewrite Rabs_left in Q by lra ]; nra ].
        + apply rder_shift. eapply rder_eq; [ exact X | ring ]. }
    destruct (near_median l h G (p + s) _ c (e - PI * l) K hc) as (t1 & Ht1 & B); [ nra | ].
    apply (held_nowhere l h p vx vy (t1 - p)); trivial; try lra. intros t Ht z _.
    specialize (B (p + t) ltac:(lra)). cbv beta in B. replace (p + t - p) with t in B by ring. rewrite z, <- Rabs_Ropp in B.
    replace (- (0 - (G (p + t) - c))) with (G (p + t) - c) in B by ring. specialize (E (p + t) ltac:(lra)). lra.
  - exists 0. intros s d Hs hd. exists s. split; [ lra | ]. intros Z. apply no. exists s. auto.
Qed.
End Drive.

Lemma rests_not_restless v : rests v -> restless v -> False.
Proof.
  intros [a A] [b B]. destruct (A (Rmax a b) (Rmax_l _ _)) as (s & d & Hs & hd & Z). pose proof (Rmax_r a b).
  destruct (B s d ltac:(lra) hd) as (u & Hu & n). apply n, Z, Hu.
Qed.
(* between rests for every friction above lc and none for little friction *)
Lemma threshold h : generic h -> exists lc, 0 < lc < 1 /\ (forall l, lc < l < 1 -> has_rests l h 1) /\ (forall x, 0 <= x ->
  (forall l, x < l < 1 -> has_rests l h 1) -> lc <= x) /\
  exists l0, 0 < l0 <= lc /\ forall l, 0 < l < l0 -> has_rests l h 0.
Proof.
  intros [N b m]. pose proof (mean_below_one h N b) as m1. assert (S : exists l0, 0 < l0 <= 1 /\ forall l, 0 < l < l0 -> has_rests l h 0).
  { enough (S : exists l0, 0 < l0 /\ forall l, 0 < l < l0 -> has_rests l h 0) by (destruct S as (l0 & p & S); exists (Rmin l0 1); split;
    [ unfold Rmin; destruct Rle_dec; lra | intros l Hl; apply S; pose proof (Rmin_l l0 1); lra ]).
    destruct (total_order_T (mean h) 0) as [[k | k] | k].
    - exists (- mean h). split; [ lra | ]. intros l Hl. apply (driven_away h N (-1)); [ auto | lra ].
    - destruct (m k) as (c & hc & A). now apply (little_friction h N c).
    - exists (mean h). split; [ lra | ]. intros l Hl. apply (driven_away h N 1); [ auto | lra ]. }
  destruct S as (l0 & Hl0 & S). assert (no : forall l, 0 < l < l0 -> ~ has_rests l h 1).
  { intros l Hl R. destruct (has_a_motion h N l 0 ltac:(lra)) as (vx & vy & M). destruct (R _ _ _ M) as [(_ & r & _) | [e _]]; [ | lra ].
    destruct (S l Hl _ _ _ M) as [[e _] | [_ r']]; [ lra | ].
    exact (rests_not_restless _ r r'). }
  destruct (completeness (fun l => 0 < l < 1 /\ ~ has_rests l h 1)) as [z [z1 z2]]. { exists 1. intros l Hl. lra. } { exists (l0 / 2).
  split; [ lra | apply no; lra ]. }
  assert (z < 1). { apply Rle_lt_trans with (Rmax 0 (mean (fun t => Rabs (h t)))); [ | unfold Rmax; destruct Rle_dec; lra ]. apply z2.
  intros l [Hl n]. pose proof (Rmax_r 0 (mean (fun t => Rabs (h t)))).
    apply Rnot_lt_le. intros k. apply n, above_the_mean; trivial. lra. }
  assert (l0 <= z). { apply Rnot_lt_le. intros k. assert (0 < z) by (pose proof (z1 (l0 / 2) ltac:(split; [ lra | apply no; lra ])); lra).
    pose proof (z1 ((z + l0) / 2) ltac:(split; [ lra | apply no; lra ])). lra. }
  exists z. split; [ lra | split; [ | split ] ].
  - intros l Hl. apply Classical_Prop.NNPP. intros n. pose proof (z1 l ltac:(split; [ lra | trivial ])). lra.
  - intros x Hx R. apply z2. intros l [Hl n]. apply Rnot_lt_le. intros k. apply n, R. lra.
  - exists l0. split; [ lra | trivial ].
Qed.
