(* Functions of time in the end: what sinks below a level (`sinks`), l'Hôpital's rule for right derivatives (`hospital`),
   limits taken apart (tactic `lim`), and laws with a first correction c (ln t)/t (`near`). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable2 Fate.
Open Scope R_scope.

Lemma ln_mono a b : 0 < a <= b -> ln a <= ln b.
Proof. intros [a0 [k | <-]]; [ left; now apply ln_increasing | lra ]. Qed.
Lemma ln_below y : 0 < y -> ln y <= y - 1.
Proof. intros H. pose proof (exp_ineq1_le (ln y)) as k. rewrite exp_ln in k; lra. Qed.

(* ---- right derivatives and continuity of quotients, too ---- *)
Lemma cont_inv f t : continuity_pt f t -> f t <> 0 -> continuity_pt (fun s => / f s) t.
Proof. intros C N. now apply (continuity_pt_inv f). Qed.
Lemma rder_fixed (c t : R) : rder (fun _ => c) t 0.
Proof. apply rder_of. auto_derive; trivial. Qed.
Ltac rdq := match goal with
  | _ => eassumption
  | |- rder (fun _ => ?c) _ _ => apply rder_fixed
  | |- rder (fun t => / @?a t) _ _ => apply (rder_inv a); [ rdq | ]
  | |- rder (fun t => ln (@?a t)) _ _ => apply (rder_ln a); [ rdq | ]
  | |- rder (fun t => - @?a t) _ _ => apply (rder_opp a); rdq
  | |- rder (fun t => @?a t + @?b t) _ _ => apply (rder_plus a b); rdq
  | |- rder (fun t => @?a t - @?b t) _ _ => apply (rder_minus a b); rdq
  | |- rder (fun t => @?a t * @?b t) _ _ => apply (rder_mult a b); rdq
  | |- rder (fun t => @?a t ^ ?n) _ _ => apply (rder_pow a n); rdq
  | _ => apply rder_of; auto_derive; trivial
  end.
Ltac contq := match goal with
  | _ => assumption
  | |- continuity_pt (fun t => / @?a t) _ => apply (cont_inv a); [ contq | ]
  | |- continuity_pt (fun t => ln (@?a t)) _ => apply (cont_ln a); [ contq | ]
  | |- continuity_pt (fun t => - @?a t) _ => apply (continuity_pt_opp a); contq
  | |- continuity_pt (fun t => @?a t + @?b t) _ => apply (continuity_pt_plus a b); contq
  | |- continuity_pt (fun t => @?a t - @?b t) _ => apply (continuity_pt_minus a b); contq
  | |- continuity_pt (fun t => @?a t * @?b t) _ => apply (continuity_pt_mult a b); contq
  | |- continuity_pt (fun t => @?a t ^ ?n) _ =>
      apply (continuity_pt_comp a (fun x => x ^ n)); [ contq | apply derivable_continuous_pt, derivable_pt_pow ]
  | |- continuity_pt (fun t => ?c) _ => apply continuity_pt_const; intros ? ?; reflexivity
  | |- continuity_pt (fun t => t) _ => apply derivable_continuous_pt, derivable_pt_id
  | _ => eauto
  end.

(* ---- sinking ---- *)
Lemma square_above y : is_derive (fun z => z * Rabs z + z ^ 2) y (2 * Rabs y + 2 * y).
Proof.
  apply (is_derive_plus (fun z => z * Rabs z) (fun z => z ^ 2)); [ | auto_derive; trivial; ring ].
  destruct (Req_dec y 0) as [-> | n].
  - apply is_derive_Reals. intros e He. exists (mkposreal e He). intros d d0 Hd. simpl in Hd.
    replace (((0 + d) * Rabs (0 + d) - 0 * Rabs 0) / d - 2 * Rabs 0) with (Rabs d) by (rewrite Rplus_0_l, Rabs_R0; field; trivial).
    now rewrite Rabs_Rabsolu.
  - auto_derive; trivial. destruct (Rlt_dec 0 y) as [k | k]; [ rewrite sign_eq_1, Rabs_pos_eq | rewrite sign_eq_m1, Rabs_left ]; lra.
Qed.
(* what does not grow where it is not negative does not become positive *)
Lemma barrier f a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t) ->
  (forall t, a <= t < b -> exists l, rder f t l /\ (0 <= f t -> l <= 0)) -> f a <= 0 -> f b <= 0.
Proof.
  intros Hab C D H. assert (K : f b * Rabs (f b) + f b ^ 2 <= f a * Rabs (f a) + f a ^ 2).
  { apply (rder_decr (fun t => f t * Rabs (f t) + f t ^ 2)); trivial; intros t Ht.
    - apply (continuity_pt_comp f (fun z => z * Rabs z + z ^ 2)); [ now apply C | ].
      apply derivable_continuous_pt. exists (2 * Rabs (f t) + 2 * f t). apply is_derive_Reals, square_above.
    - destruct (D t Ht) as (l & L & k). eexists. split. apply (rder_comp f (fun z => z * Rabs z + z ^ 2) t l (2 * Rabs (f t) + 2 * f t) L), square_above.
      destruct (Rle_lt_dec 0 (f t)) as [q | q]; [ specialize (k q); rewrite Rabs_pos_eq by lra; nra | rewrite Rabs_left by lra; lra ]. }
  rewrite (Rabs_left1 (f a)) in K by lra. apply Rnot_lt_le. intros n. rewrite Rabs_pos_eq in K by lra. nra.
Qed.
(* what falls at the rate m / (t + c) at least wherever it is not below e is below e in the end, and stays *)
Lemma sinks f e m c a b : a <= b -> 0 < a + c -> 0 <= m -> (forall t, a < t <= b -> continuity_pt f t) ->
  (forall t, a <= t < b -> exists l, rder f t l /\ (e <= f t -> l <= - (m / (t + c)))) ->
  f a - e <= m * (ln (b + c) - ln (a + c)) -> f b <= e.
Proof.
  intros Hab ac m0 C D H. enough (f b - e + m * (ln (b + c) - ln (b + c)) <= 0) by lra.
  apply (barrier (fun t => f t - e + m * (ln (t + c) - ln (b + c))) a b); trivial; cbv beta; [ | | lra ]; intros t Ht.
  - contq; lra.
  - destruct (D t Ht) as (l & L & k). exists (l + m / (t + c)). split. { eapply rder_eq. rdq; lra. field. lra. }
    intros P. assert (ln (t + c) <= ln (b + c)) by (apply ln_mono; lra). assert (m * (ln (t + c) - ln (b + c)) <= 0) by nra.
    specialize (k ltac:(lra)). lra.
Qed.
Lemma sinks_ever f e m c T : 0 < T + c -> 0 < m -> (forall t, T < t -> continuity_pt f t) ->
  (forall t, T <= t -> exists l, rder f t l /\ (e <= f t -> l <= - (m / (t + c)))) -> exists T', T <= T' /\ forall t, T' <= t -> f t <= e.
Proof.
  intros Tc m0 C D. set (K := (f T - e) / m + ln (T + c)). exists (Rmax T (exp K - c)). split. apply Rmax_l.
  intros t Ht. pose proof (Rmax_l T (exp K - c)). pose proof (Rmax_r T (exp K - c)). apply (sinks f e m c T t); try lra.
  - intros. apply C. lra.
  - intros. apply D. lra.
  - assert (K <= ln (t + c)). { rewrite <- (ln_exp K). apply ln_mono. split. apply exp_pos. lra. }
    replace (f T - e) with (m * (K - ln (T + c))) by (unfold K; field; lra). apply Rmult_le_compat_l; lra.
Qed.

(* ---- limits as the time goes to infinity ---- *)
Notation tends f l := (is_lim f p_infty (Finite l)).
Lemma tends_eq f (l l' : R) : tends f l -> l = l' -> tends f l'. Proof. now intros H <-. Qed.
Lemma tends_ext T f g (l : R) : (forall t, T <= t -> f t = g t) -> tends f l -> tends g l.
Proof. intros H. apply is_lim_ext_loc. exists T. intros t Ht. apply H. lra. Qed.
Lemma tends_comp f g (l : R) : continuity_pt g l -> tends f l -> tends (fun t => g (f t)) (g l).
Proof. intros C H. apply (filterlim_comp _ _ _ f g _ _ _ H). now apply continuity_pt_filterlim. Qed.
Lemma tends_plus f g (l m : R) : tends f l -> tends g m -> tends (fun t => f t + g t) (l + m).
Proof. exact (is_lim_plus' f g p_infty l m). Qed.
Lemma tends_minus f g (l m : R) : tends f l -> tends g m -> tends (fun t => f t - g t) (l - m).
Proof. exact (is_lim_minus' f g p_infty l m). Qed.
Lemma tends_mult f g (l m : R) : tends f l -> tends g m -> tends (fun t => f t * g t) (l * m).
Proof. intros H K. exact (is_lim_mult f g p_infty l m H K I). Qed.
Lemma tends_opp f (l : R) : tends f l -> tends (fun t => - f t) (- l).
Proof. exact (is_lim_opp f p_infty l). Qed.
Lemma tends_inv f (l : R) : tends f l -> l <> 0 -> tends (fun t => / f t) (/ l).
Proof. intros H N. apply (tends_comp f Rinv); trivial. apply (cont_inv (fun y => y)); trivial. contq. Qed.
Lemma tends_pow f n (l : R) : tends f l -> tends (fun t => f t ^ n) (l ^ n).
Proof. intros H. apply (tends_comp f (fun y => y ^ n)); trivial. contq. Qed.
Lemma tends_root f (l : R) : tends f l -> 0 <= l -> tends (fun t => sqrt (f t)) (sqrt l).
Proof. intros H N. apply (tends_comp f sqrt); trivial. apply continuity_pt_sqrt, N. Qed.
Lemma tends_ln f (l : R) : tends f l -> 0 < l -> tends (fun t => ln (f t)) (ln l).
Proof. intros H N. apply (tends_comp f ln); trivial. apply (cont_ln (fun y => y)); trivial. contq. Qed.
Ltac lim := match goal with
  | |- is_lim (fun _ => ?c) _ _ => apply is_lim_const
  | _ => eassumption
  | |- is_lim (fun t => sqrt (@?a t)) _ _ => apply (tends_root a); [ lim | ]
  | |- is_lim (fun t => ln (@?a t)) _ _ => apply (tends_ln a); [ lim | ]
  | |- is_lim (fun t => / @?a t) _ _ => apply (tends_inv a); [ lim | ]
  | |- is_lim (fun t => - @?a t) _ _ => apply (tends_opp a); lim
  | |- is_lim (fun t => @?a t + @?b t) _ _ => apply (tends_plus a b); lim
  | |- is_lim (fun t => @?a t - @?b t) _ _ => apply (tends_minus a b); lim
  | |- is_lim (fun t => @?a t * @?b t) _ _ => apply (tends_mult a b); lim
  | |- is_lim (fun t => @?a t / @?b t) _ _ => apply (tends_mult a (fun t => / b t)); lim
  | |- is_lim (fun t => @?a t ^ ?n) _ _ => apply (tends_pow a n); lim
  end.
Ltac limit := eapply tends_eq; [ lim | ].
(* in the end it is within e of its limit *)
Lemma in_the_end T f (l e : R) : tends f l -> 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> Rabs (f t - l) < e.
Proof.
  intros H He. destruct (lim_near f l e H He) as (T' & T0 & HT). exists (Rmax T T'). split. apply Rmax_l.
  intros t Ht. pose proof (Rmax_r T T'). specialize (HT t ltac:(lra)). apply Rabs_def1; lra.
Qed.
Lemma by_square f (l : R) : (forall e, 0 < e -> exists T, forall t, T <= t -> (f t - l) ^ 2 <= e) -> tends f l.
Proof.
  intros H. apply is_lim_spec. intros e. pose proof (cond_pos e). destruct (H (e ^ 2 / 4)) as [T HT]. nra.
  exists T. intros t Ht. specialize (HT t ltac:(lra)). rewrite <- pow2_abs in HT. pose proof (Rabs_pos (f t - l)). simpl. nra.
Qed.

Lemma squeeze T f g : (forall t, T <= t -> Rabs (f t) <= g t) -> tends g 0 -> tends f 0.
Proof.
  intros B G. apply is_lim_spec. intros e. destruct (in_the_end T g 0 e G (cond_pos e)) as (T' & T0 & H). exists T'. intros t Ht.
  specialize (H t ltac:(lra)). specialize (B t ltac:(lra)). rewrite Rminus_0_r in *. apply Rabs_def2 in H. simpl. lra.
Qed.

(* l'Hôpital *)
Lemma hospital T f df g dg (L : R) : (forall t, T <= t -> rder f t (df t) /\ rder g t (dg t) /\ 0 < dg t) ->
  (forall t, T < t -> continuity_pt f t /\ continuity_pt g t) -> tends (fun t => df t / dg t) L -> is_lim g p_infty p_infty ->
  tends (fun t => f t / g t) L.
Proof.
  intros D C H G. apply is_lim_spec. intros eps. pose proof (cond_pos eps) as ep. set (e := eps / 3).
  assert (e0 : 0 < e) by (unfold e; lra). destruct (in_the_end T _ L e H e0) as (T1 & T10 & HT).
  assert (near : forall t, T1 <= t -> (L - e) * dg t <= df t <= (L + e) * dg t).
  { intros t Ht. specialize (HT t Ht). apply Rabs_def2 in HT. destruct (D t ltac:(lra)) as (_ & _ & k).
    replace (df t) with (df t / dg t * dg t) by (field; lra). split; apply Rmult_le_compat_r; lra. }
  assert (up : forall t, T1 <= t -> f t - (L + e) * g t <= f T1 - (L + e) * g T1).
  { intros t Ht. apply (rder_decr (fun t => f t - (L + e) * g t)); trivial; intros r Hr.
    - destruct (C r ltac:(lra)). contq.
    - destruct (D r ltac:(lra)) as (F & K & _). specialize (near r ltac:(lra)). eexists. split. rdq. lra. }
  assert (lo : forall t, T1 <= t -> (L - e) * g t - f t <= (L - e) * g T1 - f T1).
  { intros t Ht. apply (rder_decr (fun t => (L - e) * g t - f t)); trivial; intros r Hr.
    - destruct (C r ltac:(lra)). contq.
    - destruct (D r ltac:(lra)) as (F & K & _). specialize (near r ltac:(lra)). eexists. split. rdq. lra. }
  set (c1 := f T1 - (L + e) * g T1) in *. set (c2 := (L - e) * g T1 - f T1) in *.
  apply is_lim_spec in G. destruct (G ((Rabs c1 + Rabs c2) / e)) as [T2 HG]. exists (Rmax T1 T2). intros t Ht.
  pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2). specialize (HG t ltac:(lra)). specialize (up t ltac:(lra)). specialize (lo t ltac:(lra)).
  pose proof (Rle_abs c1). pose proof (Rle_abs c2). pose proof (Rabs_pos c1). pose proof (Rabs_pos c2).
  assert (g0 : 0 < g t). { eapply Rle_lt_trans; [ | apply HG ]. apply Rmult_le_pos; [ lra | left; now apply Rinv_0_lt_compat ]. }
  assert (k : Rabs c1 + Rabs c2 < e * g t). { apply (Rmult_lt_compat_r e) in HG; trivial. unfold Rdiv in HG. rewrite Rmult_assoc, Rinv_l in HG; lra. }
  apply Rabs_def1; apply (Rmult_lt_reg_r (g t)); trivial.
  - replace ((f t / g t - L) * g t) with (f t - L * g t) by (field; lra). unfold e in *; nra.
  - replace ((f t / g t - L) * g t) with (f t - L * g t) by (field; lra). unfold e in *; nra.
Qed.

(* f = 1 + c (ln t)/t + o((ln t)/t) *)
Definition near f (c : R) := is_lim (fun t => (f t - 1) * (t / ln t)) p_infty c.
Lemma lnt t : exp 1 <= t -> 1 <= ln t.
Proof. intros H. rewrite <- (ln_exp 1). apply ln_mono. split; trivial. apply exp_pos. Qed.
Lemma exp1 : 1 < exp 1.
Proof. pose proof (exp_ineq1 1). lra. Qed.
Lemma near_one f c : near f c -> tends f 1.
Proof.
  intros H. apply (tends_ext (exp 1) (fun t => (f t - 1) * (t / ln t) * (ln t / t) + 1)).
  - intros t Ht. pose proof (lnt t Ht). pose proof exp1. field. lra.
  - pose proof is_lim_div_ln_p as Z. eapply tends_eq. apply tends_plus; [ apply tends_mult; [ exact H | exact Z ] | apply is_lim_const ]. ring.
Qed.
Lemma near_eq f c c' : near f c -> c = c' -> near f c'. Proof. now intros H <-. Qed.
Lemma near_ext T f g c : (forall t, T <= t -> f t = g t) -> near f c -> near g c.
Proof. intros H. apply (tends_ext T). intros t Ht. now rewrite H. Qed.
Lemma near_mult f g c d : near f c -> near g d -> near (fun t => f t * g t) (c + d).
Proof.
  intros F G. pose proof (near_one g d G) as G1. apply (is_lim_ext (fun t => (f t - 1) * (t / ln t) * g t + (g t - 1) * (t / ln t))).
  - intros t. ring.
  - eapply tends_eq. apply tends_plus; [ apply tends_mult; [ exact F | exact G1 ] | exact G ]. ring.
Qed.
Lemma near_inv f c : near f c -> near (fun t => / f t) (- c).
Proof.
  intros F. pose proof (near_one f c F) as F1. destruct (in_the_end 0 f 1 1 F1 Rlt_0_1) as (T & _ & HT).
  apply (tends_ext T (fun t => - ((f t - 1) * (t / ln t)) * / f t)).
  - intros t Ht. specialize (HT t Ht). apply Rabs_def2 in HT. unfold Rdiv. set (k := t * / ln t). field. lra.
  - eapply tends_eq. apply tends_mult; [ apply tends_opp; exact F | apply tends_inv; [ exact F1 | lra ] ]. field.
Qed.
Lemma near_root f c : near f c -> near (fun t => sqrt (f t)) (c / 2).
Proof.
  intros F. pose proof (near_one f c F) as F1. destruct (in_the_end 0 f 1 1 F1 Rlt_0_1) as (T & _ & HT).
  apply (tends_ext T (fun t => (f t - 1) * (t / ln t) * / (sqrt (f t) + 1))).
  - intros t Ht. specialize (HT t Ht). apply Rabs_def2 in HT. assert (q : f t = sqrt (f t) ^ 2) by (rewrite <- Rsqr_pow2, Rsqr_sqrt; lra).
    pose proof (sqrt_pos (f t)). rewrite q at 1. unfold Rdiv. set (k := t * / ln t). field. lra.
  - eapply tends_eq. apply tends_mult; [ exact F | apply tends_inv; [ apply tends_plus; [ apply tends_root; [ exact F1 | lra ] | apply is_lim_const ] | ] ].
    + rewrite sqrt_1. lra.
    + rewrite sqrt_1. field.
Qed.
(* 1/t and 1/ln t vanish *)
Lemma inv_time : tends (fun t => / t) 0.
Proof. exact (is_lim_inv (fun t => t) p_infty p_infty (is_lim_id p_infty) ltac:(discriminate)). Qed.
Lemma inv_ln : tends (fun t => / ln t) 0.
Proof. exact (is_lim_inv ln p_infty p_infty is_lim_ln_p ltac:(discriminate)). Qed.
(* what differs from 1 by a bounded multiple of 1/t has no term in (ln t)/t *)
Lemma near_small f g (l : R) : tends g l -> (exists T, forall t, T <= t -> f t = 1 + g t / t) -> near f 0.
Proof.
  intros G [T H]. apply (tends_ext (Rmax T (exp 1)) (fun t => g t * / ln t)).
  - intros t Ht. pose proof (Rmax_l T (exp 1)). pose proof (Rmax_r T (exp 1)). rewrite H by lra. pose proof (lnt t ltac:(lra)). pose proof exp1. field. lra.
  - replace 0 with (l * 0) by ring. apply tends_mult; trivial. exact inv_ln.
Qed.
Lemma near_pow f c n : near f c -> near (fun t => f t ^ n) (INR n * c).
Proof.
  intros F. induction n as [ | n IH].
  - eapply near_eq. apply (near_small _ (fun _ => 0) 0). apply is_lim_const. exists 0. intros. simpl. unfold Rdiv. ring. simpl. ring.
  - eapply near_eq. apply (near_mult f (fun t => f t ^ n)); eassumption. rewrite S_INR. ring.
Qed.
Lemma near_plus f g c : near f c -> tends (fun t => g t * (t / ln t)) 0 -> near (fun t => f t + g t) c.
Proof.
  intros F G. apply (is_lim_ext (fun t => (f t - 1) * (t / ln t) + g t * (t / ln t))). intros; ring.
  eapply tends_eq. apply tends_plus; [ exact F | exact G ]. ring.
Qed.
Ltac nears := match goal with
  | _ => eassumption
  | |- near (fun t => sqrt (@?a t)) _ => apply (near_root a); nears
  | |- near (fun t => / @?a t) _ => apply (near_inv a); nears
  | |- near (fun t => @?a t * @?b t) _ => apply (near_mult a b); nears
  | |- near (fun t => @?a t / @?b t) _ => apply (near_mult a (fun t => / b t)); nears
  | |- near (fun t => @?a t ^ ?n) _ => eapply (near_pow a _ n); nears
  end.
