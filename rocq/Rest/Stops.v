(* How a sliding motion stops, in the three numbers P = p, X = xi = rho cos psi, L = ell = - rho sin psi, which are a closed
   system: xi never falls, so it has a limit; ln p + c xi + k t would not fall if ell stayed away from 0, or if rho -> 1 with
   xi -> 1, and p could not come to 0. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate Alpha.
Open Scope R_scope.

(* f tends to l as t comes up to T from below: «$f\to l$ as its argument tends to $T$ from below» *)
Definition left_lim (f : R -> R) (T l : R) := forall e, 0 < e -> exists d, 0 < d /\ forall t, T - d < t < T -> Rabs (f t - l) < e.

(* P holds from some moment before T on *)
Definition soon (T : R) (P : R -> Prop) := exists d, 0 < d /\ forall t, T - d < t < T -> P t.
Lemma soon_and T P Q : soon T P -> soon T Q -> soon T (fun t => P t /\ Q t).
Proof.
  intros (d & d0 & H) (d' & d1 & H'). exists (Rmin d d'). split. now apply Rmin_pos. intros t Ht. pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  split; [ apply H | apply H' ]; lra.
Qed.
Lemma soon_imp T (P Q : R -> Prop) : (forall t, P t -> Q t) -> soon T P -> soon T Q.
Proof. intros H (d & d0 & K). exists d. split; auto. Qed.
Lemma soon_after s T (P : R -> Prop) : s < T -> (forall t, s <= t < T -> P t) -> soon T P.
Proof. intros Hs H. exists (T - s). split. lra. intros t Ht. apply H. lra. Qed.
Lemma soon_from s T P : s < T -> soon T P -> exists s', s < s' < T /\ forall t, s' <= t < T -> P t.
Proof.
  intros Hs (d & d0 & H). exists (Rmax (T - d / 2) ((s + T) / 2)). pose proof (Rmax_l (T - d / 2) ((s + T) / 2)).
  pose proof (Rmax_r (T - d / 2) ((s + T) / 2)).
  assert (Rmax (T - d / 2) ((s + T) / 2) < T) by (apply Rmax_lub_lt; lra). split. lra. intros t Ht. apply H. lra.
Qed.
Lemma ll_iff f T l : left_lim f T l <-> filterlim f (at_left T) (locally l).
Proof.
  split.
  - intros H P [e HP]. destruct (H e (cond_pos e)) as (d & d0 & Hd). exists (mkposreal d d0). intros y B Hy. apply HP, Hd.
    change (Rabs (y - T) < d) in B. apply Rabs_def2 in B. lra.
  - intros H e He. destruct (H (fun y => Rabs (y - l) < e)) as [d Hd]. { exists (mkposreal e He). intros y B. exact B. }
    exists d. split. apply cond_pos. intros t Ht. apply Hd; [ | lra ]. change (Rabs (t - T) < d). apply Rabs_def1; lra.
Qed.
Lemma ll_eq f T l l' : left_lim f T l -> l = l' -> left_lim f T l'. Proof. now intros H <-. Qed.
Lemma ll_const c T : left_lim (fun _ => c) T c.
Proof. intros e He. exists 1. split. lra. intros. rewrite Rminus_eq_0, Rabs_R0. exact He. Qed.
Lemma ll_comp g f T l : left_lim f T l -> continuity_pt g l -> left_lim (fun t => g (f t)) T (g l).
Proof. rewrite !ll_iff. intros H C. apply continuity_pt_filterlim in C. exact (filterlim_comp _ _ _ f g _ _ _ H C). Qed.
Lemma ll_plus f g T l m : left_lim f T l -> left_lim g T m -> left_lim (fun t => f t + g t) T (l + m).
Proof. rewrite !ll_iff. intros H K. eapply filterlim_comp_2; [ exact H | exact K | exact (filterlim_plus l m) ]. Qed.
Lemma ll_mult f g T l m : left_lim f T l -> left_lim g T m -> left_lim (fun t => f t * g t) T (l * m).
Proof. rewrite !ll_iff. intros H K. eapply filterlim_comp_2; [ exact H | exact K | exact (filterlim_mult l m) ]. Qed.
Lemma ll_opp f T l : left_lim f T l -> left_lim (fun t => - f t) T (- l).
Proof. intros H. apply (ll_comp Ropp f T l H). apply (continuity_pt_opp (fun x => x)). cont. Qed.
Lemma ll_minus f g T l m : left_lim f T l -> left_lim g T m -> left_lim (fun t => f t - g t) T (l - m).
Proof. intros H K. apply (ll_plus f (fun t => - g t) T l (- m) H), ll_opp, K. Qed.
Lemma ll_pow f n T l : left_lim f T l -> left_lim (fun t => f t ^ n) T (l ^ n).
Proof. intros H. apply (ll_comp (fun x => x ^ n) f T l H). apply derivable_continuous_pt, derivable_pt_pow. Qed.
Lemma ll_inv f T l : left_lim f T l -> l <> 0 -> left_lim (fun t => / f t) T (/ l).
Proof. intros H N. apply (ll_comp Rinv f T l H). apply (continuity_pt_inv (fun x => x)); trivial. cont. Qed.
Lemma ll_cont f T : continuity_pt f T -> left_lim f T (f T).
Proof.
  intros C. apply ll_iff. apply continuity_pt_filterlim in C. intros P HP. specialize (C P HP). destruct C as [d Hd].
  exists d. intros y B _. exact (Hd y B).
Qed.
(* a bound on the left of T holds at T *)
Lemma left_le f c s T : s < T -> continuity_pt f T -> (forall t, s <= t < T -> f t <= c) -> f T <= c.
Proof.
  intros sT C H. apply Rnot_lt_le. intros k. destruct (soon_from s T _ sT (ll_cont f T C (f T - c) ltac:(lra))) as (t & Ht & K).
  specialize (K t ltac:(lra)). specialize (H t ltac:(lra)). apply Rabs_def2 in K. lra.
Qed.
Lemma ll_soon f g T l : soon T (fun t => g t = f t) -> left_lim f T l -> left_lim g T l.
Proof. intros K H e He. generalize (soon_and _ _ _ K (H e He)). apply soon_imp. intros t [-> h]. exact h. Qed.
Lemma ll_ext f g T l d : 0 < d -> (forall t, T - d < t < T -> g t = f t) -> left_lim f T l -> left_lim g T l.
Proof. intros Hd K. apply ll_soon. now exists d. Qed.
Lemma ll_squeeze f g T : soon T (fun t => Rabs (f t) <= g t) -> left_lim g T 0 -> left_lim f T 0.
Proof.
  intros B G e He. generalize (soon_and _ _ _ B (G e He)). apply soon_imp. intros t [h1 h2]. rewrite Rminus_0_r in *. apply Rabs_def2 in h2. lra.
Qed.
Lemma soon_near f T l e : left_lim f T l -> 0 < e -> soon T (fun t => Rabs (f t - l) < e). Proof. intros H He. exact (H e He). Qed.
(* between any s < T and T there is a moment from which on f is near its limit *)
Lemma ll_from f s T l e : s < T -> left_lim f T l -> 0 < e -> exists s', s < s' < T /\ forall t, s' <= t < T -> l - e < f t < l + e.
Proof. intros Hs H He. destruct (soon_from s T _ Hs (H e He)) as (s' & S' & K). exists s'. split; trivial. intros t Ht. specialize (K t Ht).
  apply Rabs_def2 in K. lra. Qed.
Lemma ll_le f T l s c : left_lim f T l -> s < T -> (forall t, s <= t < T -> f t <= c) -> l <= c.
Proof. intros H sT B. apply Rnot_lt_le. intros k. destruct (ll_from f s T l (l - c) sT H ltac:(lra)) as (t & Ht & K). specialize (K t ltac:(lra)).
  specialize (B t ltac:(lra)). lra. Qed.
Lemma ll_uniq f T l m : left_lim f T l -> left_lim f T m -> l = m.
Proof.
  intros H K. apply Req_lt_aux. intros e. pose proof (cond_pos e). destruct (ll_from f (T - 1) T l (e / 2) ltac:(lra) H ltac:(lra)) as (s & Hs & B).
  destruct (ll_from f s T m (e / 2) ltac:(lra) K ltac:(lra)) as (r & Hr & C). specialize (B r ltac:(lra)). specialize (C r ltac:(lra)).
  apply Rabs_def1; lra.
Qed.
Lemma ll_mono f s T M : s < T -> (forall a b, s <= a <= b -> b < T -> f a <= f b) -> (forall t, s <= t < T -> f t <= M) ->
  exists l, left_lim f T l /\ forall t, s <= t < T -> f t <= l.
Proof.
  intros sT H B. destruct (completeness (fun r => exists t, s <= t < T /\ r = f t)) as [l [l1 l2]].
  { exists M. intros r (t & Ht & ->). auto. } { exists (f s), s. split; trivial; lra. }
  assert (up : forall t, s <= t < T -> f t <= l) by (intros t Ht; apply l1; exists t; auto).
  exists l. split; trivial. intros e He. destruct (Classical_Prop.classic (exists t, s <= t < T /\ l - e < f t)) as [(a & Ha & K) | no].
  - exists (T - a). split; [ lra | ]. intros t Ht. specialize (H a t ltac:(lra) ltac:(lra)). specialize (up t ltac:(lra)). apply Rabs_def1; lra.
  - exfalso. assert (l <= l - e); [ | lra ]. apply l2. intros r (t & Ht & ->). apply Rnot_lt_le. intros k. apply no. eauto.
Qed.
(* what has a right derivative >= 0 up to T stays below its limit there *)
Lemma ll_incr f s T l : left_lim f T l -> (forall t, s < t < T -> continuity_pt f t) ->
  (forall t, s <= t < T -> exists m, rder f t m /\ 0 <= m) -> forall t, s <= t < T -> f t <= l.
Proof.
  intros H C D t Ht. apply Ropp_le_cancel. apply (ll_le (fun t => - f t) T (- l) t); [ now apply ll_opp | lra | ]. intros b Hb.
  apply (rder_decr (fun t => - f t)); [ lra | | ]; intros r Hr.
  - apply continuity_pt_opp, C. lra.
  - destruct (D r ltac:(lra)) as (m & Hm & m0). exists (- m). split; [ now apply rder_opp | lra ].
Qed.
Ltac ll := match goal with
  | |- left_lim (fun t => @?a t + @?b t) _ _ => apply (ll_plus a b); ll
  | |- left_lim (fun t => @?a t - @?b t) _ _ => apply (ll_minus a b); ll
  | |- left_lim (fun t => @?a t * @?b t) _ _ => apply (ll_mult a b); ll
  | |- left_lim (fun t => @?a t / @?b t) _ _ => apply (ll_mult a (fun t => / b t)); ll
  | |- left_lim (fun t => - @?a t) _ _ => apply (ll_opp a); ll
  | |- left_lim (fun t => / @?a t) _ _ => apply (ll_inv a); [ ll | ]
  | |- left_lim (fun t => @?a t ^ ?n) _ _ => apply (ll_pow a n); ll
  | |- left_lim (fun t => ?f t) _ _ => eassumption
  | |- left_lim (fun _ => ?c) _ _ => apply ll_const
  | |- _ => eassumption
  end.

(* (99) to (101) while it slips, for three functions of the time *)
Record reduced (P X L : R -> R) (a b : R) : Prop := {
  r_pos : forall t, a <= t < b -> 0 < P t;
  r_cont : forall t, a < t < b -> continuity_pt P t /\ continuity_pt X t /\ continuity_pt L t;
  r_rate : forall t, a <= t < b -> rder P t (X t - 1) /\ rder X t ((P t + L t) ^ 2 / P t) /\ rder L t (- X t * (2 * P t + L t) / P t) }.


Section Reduced.
Variables (P X L : R -> R) (a T : R).
Hypothesis Hr : reduced P X L a T.
Hypothesis aT : a < T.

Ltac at_ t := let Ht := fresh in assert (Ht : a <= t < T) by lra; pose proof (r_pos _ _ _ _ _ Hr t Ht);
  destruct (r_rate _ _ _ _ _ Hr t Ht) as (? & ? & ?).
Ltac conts := cont; apply (r_cont _ _ _ _ _ Hr); lra.

Lemma X_up s t : a <= s <= t -> t < T -> X s <= X t.
Proof.
  intros Hs Ht. apply Ropp_le_cancel. apply (rder_decr (fun t => - X t)); [ lra | | ]; intros r Hr'. conts.
  at_ r. eexists. split. rd. enough (0 <= (P r + L r) ^ 2 / P r) by lra. apply Rmult_le_pos. apply pow2_ge_0. left. now apply Rinv_0_lt_compat.
Qed.
Lemma E_rate t : a <= t < T -> rder (fun t => X t ^ 2 + L t ^ 2 - P t ^ 2) t (2 * P t).
Proof. intros Ht. at_ t. eapply rder_eq. rd. simpl. field. lra. Qed.
Lemma no_stop s c k M : a <= s < T -> 0 <= c -> 0 <= k -> (forall t, s <= t < T -> X t <= M) ->
  (forall t, s <= t < T -> 1 - X t <= c * (P t + L t) ^ 2 + k * P t) -> exists m, 0 < m /\ forall t, s <= t < T -> m <= P t.
Proof.
  intros Hs c0 k0 HM H. exists (exp (ln (P s) + c * X s + k * s - c * M - k * T)). split. apply exp_pos. intros t Ht.
  assert (up : - (ln (P t) + c * X t + k * t) <= - (ln (P s) + c * X s + k * s)).
  { apply (rder_decr (fun t => - (ln (P t) + c * X t + k * t))); [ lra | | ]; intros r Hr'; at_ r; specialize (H r ltac:(lra)).
    - cont; try (apply (r_cont _ _ _ _ _ Hr); lra). trivial.
    - eexists. split. rd. trivial.
      match goal with |- ?g <= 0 => replace g with (- ((X r - 1 + c * (P r + L r) ^ 2 + k * P r) / P r)) by (field; lra) end.
      enough (0 <= (X r - 1 + c * (P r + L r) ^ 2 + k * P r) / P r) by lra. apply Rmult_le_pos. lra. left. now apply Rinv_0_lt_compat. }
  rewrite <- (exp_ln (P t)) by (at_ t; trivial). specialize (HM t Ht).
  assert (c * X t <= c * M) by (apply Rmult_le_compat_l; lra). assert (k * t <= k * T) by (apply Rmult_le_compat_l; lra).
  destruct (Rle_lt_or_eq_dec (ln (P s) + c * X s + k * s - c * M - k * T) (ln (P t)) ltac:(lra)) as [l | <-]; [ left;
  now apply exp_increasing | lra ].
Qed.

Hypothesis P0 : left_lim P T 0.
Variable r : R.
Hypothesis r0 : 0 <= r.
Hypothesis rho : left_lim (fun t => X t ^ 2 + L t ^ 2) T (r ^ 2).

Lemma X_limit : exists s l, a <= s < T /\ left_lim X T l /\ l ^ 2 <= r ^ 2 /\ forall t, s <= t < T -> - (r + 1) <= X t <= l.
Proof.
  destruct (ll_from _ a T _ 1 aT rho Rlt_0_1) as (s & Hs & Hd). assert (sT : s < T) by lra.
  assert (B : forall t, s <= t < T -> - (r + 1) <= X t <= r + 1) by (intros t Ht; specialize (Hd t Ht); cbv beta in Hd; pose proof (pow2_ge_0 (L t));
  split; nra).
  destruct (ll_mono X s T (r + 1) sT) as (l & Hl & l1). { intros; apply X_up; lra. } { intros; now apply B. }
  exists s, l. repeat split; trivial; try lra.
  - apply Rnot_lt_le. intros k. destruct (ll_from (fun t => X t ^ 2 - (X t ^ 2 + L t ^ 2)) s T (l ^ 2 - r ^ 2) (l ^ 2 - r ^ 2) sT) as (t & Ht & K);
    [ ll | lra | ].
    specialize (K t ltac:(lra)). cbv beta in K. pose proof (pow2_ge_0 (L t)). lra.
  - now apply B.
  - now apply l1.
Qed.
(* it stops along its path: psi -> 0, or psi -> pi *)
Lemma along : left_lim X T r \/ left_lim X T (- r).
Proof.
  destruct X_limit as (s & l & Hs & Hl & l2 & B). destruct (Req_dec (l ^ 2) (r ^ 2)) as [e | ne].
  { assert (z : (l - r) * (l + r) = 0) by lra. apply Rmult_integral in z. destruct z; [ left | right ]; eapply ll_eq; try exact Hl; lra. }
  exfalso. set (c := r ^ 2 - l ^ 2). assert (c0 : 0 < c) by (unfold c; lra).
  destruct (ll_from (fun t => X t ^ 2 + L t ^ 2 - X t ^ 2) s T (r ^ 2 - l ^ 2) (c / 2)) as (s1 & S1 & Hd); [ lra | ll | lra | ]. fold c in Hd.
  destruct (ll_from _ s1 T _ 1 ltac:(lra) P0 Rlt_0_1) as (s' & S2 & Hd').
  set (k := 4 * (r + 2) / c). assert (k0 : 0 < k) by (apply Rdiv_lt_0_compat; lra). assert (kc : k * c = 4 * (r + 2)) by (unfold k; field; lra).
  destruct (no_stop s' k k l) as (m & m0 & Hm); try lra.
  - intros t Ht. apply B. lra.
  - intros t Ht. specialize (Hd t ltac:(lra)). specialize (Hd' t ltac:(lra)). cbv beta in Hd. destruct (B t ltac:(lra)) as [b1 b2].
    pose proof (r_pos _ _ _ _ _ Hr t ltac:(lra)) as pt. assert (q : L t ^ 2 / 2 - P t <= (P t + L t) ^ 2) by (pose proof (pow2_ge_0 (2 * P t + L t));
    nra).
    assert (k * (c / 4 - P t) <= k * (P t + L t) ^ 2) by (apply Rmult_le_compat_l; lra). lra.
  - destruct (ll_from _ s' T _ m ltac:(lra) P0 m0) as (t & Ht & K). specialize (K t ltac:(lra)). specialize (Hm t ltac:(lra)). lra.
Qed.
(* at rho = 1 it stops coming straight in only *)
Lemma at_one : r = 1 -> left_lim X T (- (1)).
Proof.
  intros e1. destruct along as [H | H]; [ exfalso | now rewrite <- e1 ].
  destruct X_limit as (s & l & Hs & Hl & _ & B). rewrite e1 in H. assert (l = 1) by now apply (ll_uniq X T). subst l.
  destruct (ll_from _ s T _ 1 ltac:(lra) P0 Rlt_0_1) as (s1 & S1 & Hd). destruct (ll_from _ s1 T _ 1 ltac:(lra) H Rlt_0_1) as (s' & S2 & Hd').
  assert (E1 : forall t, s' <= t < T -> 1 <= X t ^ 2 + L t ^ 2 - P t ^ 2 + 2 * P t * (T - t)).
  { intros t Ht. apply (ll_le (fun t => X t ^ 2 + L t ^ 2 - P t ^ 2) T 1 t); [ | lra | ].
    { eapply ll_eq. apply (ll_minus (fun t => X t ^ 2 + L t ^ 2) (fun t => P t ^ 2)); [ exact rho | apply ll_pow, P0 ]. rewrite e1. ring. }
    assert (Pd : forall q, t <= q < T -> P q <= P t).
    { intros q Hq. apply (rder_decr P); [ lra | | ]; intros z Hz. conts. at_ z. eexists. split. eassumption. destruct (B z ltac:(lra)). lra. }
    intros b Hb. enough (X b ^ 2 + L b ^ 2 - P b ^ 2 - 2 * P t * b <= X t ^ 2 + L t ^ 2 - P t ^ 2 - 2 * P t * t).
    { at_ t. assert (0 <= P t * (T - b)) by nra. lra. }
    apply (rder_decr (fun b => X b ^ 2 + L b ^ 2 - P b ^ 2 - 2 * P t * b)); [ lra | | ]; intros z Hz. conts.
    at_ z. eexists. split. apply (rder_minus (fun b => X b ^ 2 + L b ^ 2 - P b ^ 2)); [ apply E_rate; lra | rd ]. specialize (Pd z ltac:(lra)). lra. }
  destruct (no_stop s' 2 (2 * (T - s') + 1) 1) as (m & m0 & Hm); try lra.
  - intros t Ht. apply B. lra.
  - intros t Ht. specialize (Hd t ltac:(lra)). specialize (Hd' t ltac:(lra)). specialize (E1 t Ht). destruct (B t ltac:(lra)) as [_ b2]. at_ t.
    assert (1 - X t <= 1 - X t ^ 2) by nra. assert (L t ^ 2 <= 2 * (P t + L t) ^ 2 + 2 * P t ^ 2) by (pose proof (pow2_ge_0 (L t + 2 * P t)); nra).
    assert (P t * (T - t) <= P t * (T - s')) by (apply Rmult_le_compat_l; lra). nra.
  - destruct (ll_from _ s' T _ m ltac:(lra) P0 m0) as (t & Ht & K). specialize (K t ltac:(lra)). specialize (Hm t ltac:(lra)). lra.
Qed.
End Reduced.

Section Stops.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).
Ltac conts := table S.

Lemma reduced_spin a b : 0 <= a -> (forall t, a <= t < b -> 0 < p t) -> reduced (fun t => p t) (fun t => xi t) (fun t => ell t) a b.
Proof.
  intros Ha N. split; trivial; intros t Ht; pose proof (N t ltac:(lra)) as pt.
  - repeat split. conts. apply (cont_xi x y u w S); lra.
    apply (continuity_pt_mult (fun t => x t * w t - y t * u t) (fun t => / p t)). conts. apply (continuity_pt_inv (fun t => p t)); [ conts | lra ].
  - repeat split; [ apply (dp x y u w S) | apply (eq101 x y u w S) | apply (eq100 x y u w S) ]; lra.
Qed.
Lemma xi_ell t : 0 < p t -> xi t ^ 2 + ell t ^ 2 = x t ^ 2 + y t ^ 2.
Proof. intros N. rewrite <- (nrm_sq (x t)). now apply (xi_p x y u w). Qed.
(* a motion slips for ever, or there is a first stop *)
Lemma first_stop : 0 < p 0 -> (forall t, 0 <= t -> 0 < p t) \/ exists T, 0 < T /\ p T = 0 /\ forall t, 0 <= t < T -> 0 < p t.
Proof.
  intros p0. destruct (Classical_Prop.classic (exists T, 0 < T /\ p T = 0 /\ forall t, 0 <= t < T -> 0 < p t)) as [ok | no]; [ now right | left ].
  intros t Ht. apply (real_ind (fun t => 0 < p t) 0 t); trivial; try lra.
  - intros T HT N. destruct (nrm_pos (u T) (w T)) as [k | k]; trivial. exfalso. apply no. exists T. repeat split; auto; lra.
  - intros r Hr N. specialize (N r ltac:(lra)). apply (right_pos (fun t => p t) r (xi r - 1)); [ apply (dp x y u w S r); lra | exact N ].
Qed.

Variable T : R.
Hypothesis T0 : 0 < T.
Hypothesis pT : p T = 0.
Hypothesis N : forall t, 0 <= t < T -> 0 < p t.

Lemma p_to_0 : left_lim (fun t => p t) T 0.
Proof. rewrite <- pT. apply (ll_cont (fun t => p t)). conts. Qed.
Lemma rho_to : left_lim (fun t => xi t ^ 2 + ell t ^ 2) T (rho T ^ 2).
Proof.
  apply (ll_ext (fun t => x t ^ 2 + y t ^ 2) _ T _ T); trivial. intros t Ht. apply xi_ell, N. lra.
  rewrite nrm_sq. apply (ll_cont (fun t => x t ^ 2 + y t ^ 2)). conts.
Qed.
Lemma stops_along : left_lim (fun t => xi t) T (rho T) \/ left_lim (fun t => xi t) T (- rho T).
Proof. apply (along _ _ _ 0 T (reduced_spin 0 T (Rle_refl 0) N) T0 p_to_0); [ apply nrm_pos | exact rho_to ]. Qed.
Lemma stops_at_one : rho T = 1 -> left_lim (fun t => xi t) T (- (1)).
Proof. intros e. apply (at_one _ _ _ 0 T (reduced_spin 0 T (Rle_refl 0) N) T0 p_to_0 (rho T)); trivial. apply nrm_pos. exact rho_to. Qed.
(* with psi -> 0 it stops inside rho = 1 *)
Lemma stops_inside : left_lim (fun t => xi t) T (rho T) -> 0 < rho T -> rho T < 1.
Proof.
  intros H r0. destruct (Rtotal_order (rho T) 1) as [l | [e | g]]; trivial; exfalso.
  - assert (e2 : - (1) = rho T) by (apply (ll_uniq (fun t => xi t) T); [ now apply stops_at_one | exact H ]). lra.
  - destruct (ll_from _ 0 T _ (rho T - 1) T0 H ltac:(lra)) as (s & Hs & Hd). pose proof (N s ltac:(lra)).
    enough (- p T <= - p s) by lra. apply (rder_decr (fun t => - p t)); [ lra | intros; conts | ]. intros r Hr. eexists. split.
    apply (rder_opp (fun t => p t)), (dp x y u w S r); [ lra | ]. specialize (N r ltac:(lra)). lra. specialize (Hd r ltac:(lra)). cbv beta in Hd. lra.
Qed.
End Stops.
