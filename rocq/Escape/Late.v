(* Functions of time in the end: what stays positive (`stays_pos`), what sinks below a level (`sinks`), l'Hôpital's rule for right
   derivatives (`hospital`), limits taken apart (tactic `lim`), and laws with a first correction c (ln t)/t (`near`). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Analysis.
Open Scope R_scope.

Lemma ln_mono a b : 0 < a <= b -> ln a <= ln b.
Proof. intros [a0 [k | <-]]; [ left; now apply ln_increasing | lra ]. Qed.
Lemma root_sq a : 0 <= a -> sqrt a ^ 2 = a.
Proof. intros H. rewrite <- Rsqr_pow2. now apply Rsqr_sqrt. Qed.

(* ---- right derivatives and continuity of quotients, too ---- *)
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
  | |- continuity_pt (fun t => ?c) _ => apply continuity_pt_const; intros ? ?; reflexivity
  | |- continuity_pt (fun t => / @?a t) _ => apply (cont_inv a); [ contq | ]
  | |- continuity_pt (fun t => ln (@?a t)) _ => apply (cont_ln a); [ contq | ]
  | |- continuity_pt (fun t => nrm (@?a t) (@?b t)) _ => apply (cont_nrm a b); contq
  | |- continuity_pt (fun t => - @?a t) _ => apply (continuity_pt_opp a); contq
  | |- continuity_pt (fun t => @?a t + @?b t) _ => apply (continuity_pt_plus a b); contq
  | |- continuity_pt (fun t => @?a t - @?b t) _ => apply (continuity_pt_minus a b); contq
  | |- continuity_pt (fun t => @?a t * @?b t) _ => apply (continuity_pt_mult a b); contq
  | |- continuity_pt (fun t => @?a t ^ ?n) _ =>
      apply (continuity_pt_comp a (fun x => x ^ n)); [ contq | apply derivable_continuous_pt, derivable_pt_pow ]
  | |- continuity_pt (fun t => t) _ => apply derivable_continuous_pt, derivable_pt_id
  | _ => idtac
  end.
(* ... of what is made of the place and velocity of the motion S *)
Ltac conts S := contq; try first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; try lra.

(* ---- what stays positive, what sinks ---- *)
(* just before b *)
Lemma just_before a b f : a < b -> continuity_pt f b -> 0 < f b -> exists r, a <= r < b /\ forall t, r <= t <= b -> 0 < f t.
Proof.
  intros ab C P. destruct (left_pos f b C P) as (d & d0 & H). pose proof (Rmin_l d (b - a)). pose proof (Rmin_r d (b - a)).
  assert (0 < Rmin d (b - a)) by (apply Rmin_pos; lra). exists (b - Rmin d (b - a) / 2). split. lra. intros t Ht. apply H. lra.
Qed.
Lemma stays_pos f a b : (forall t, a < t <= b -> continuity_pt f t) -> (forall t, a <= t < b -> 0 < f t -> exists l, rder f t l) -> 0 < f a ->
  (forall t, a < t <= b -> (forall r, a <= r < t -> 0 < f r) -> f t <> 0) -> forall t, a <= t <= b -> 0 < f t.
Proof.
  intros C D H N. apply real_ind; trivial.
  - intros t Ht K. destruct (Rtotal_order (f t) 0) as [k | [k | k]]; trivial; exfalso. 2: now apply (N t Ht K).
    destruct (just_before a t (fun t => - f t)) as (r & Hr & H1); [ lra | apply continuity_pt_opp, C, Ht | lra | ].
    specialize (H1 r ltac:(lra)). specialize (K r ltac:(lra)). lra.
  - intros t Ht K. specialize (K t ltac:(lra)). destruct (D t Ht K) as [l L]. exact (right_pos f t l L K).
Qed.
Lemma square_above y : is_derive (fun z => z * Rabs z + z ^ 2) y (2 * Rabs y + 2 * y).
Proof.
  apply (is_derive_plus (fun z => z * Rabs z) (fun z => z ^ 2)); [ | auto_derive; trivial; ring ]. destruct (Req_dec y 0) as [-> | n].
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
      apply derivable_continuous_pt. eexists. apply is_derive_Reals, square_above.
    - destruct (D t Ht) as (l & L & k). eexists. split. exact (rder_comp f (fun z => z * Rabs z + z ^ 2) t l _ L (square_above _)).
      destruct (Rle_lt_dec 0 (f t)) as [q | q]; [ specialize (k q); rewrite Rabs_pos_eq by lra; nra | rewrite Rabs_left by lra; lra ]. }
  rewrite (Rabs_left1 (f a)) in K by lra. apply Rnot_lt_le. intros n. rewrite Rabs_pos_eq in K by lra. nra.
Qed.
(* what falls at the rate m / (t + c) at least wherever it is not below e is below e in the end, and stays *)
Lemma sinks f e m c T : 0 < T + c -> 0 < m -> (forall t, T < t -> continuity_pt f t) ->
  (forall t, T <= t -> exists l, rder f t l /\ (e <= f t -> l <= - (m / (t + c)))) -> exists T', T <= T' /\ forall t, T' <= t -> f t <= e.
Proof.
  intros Tc m0 C D. set (K := (f T - e) / m + ln (T + c)). exists (Rmax T (exp K - c)). split. apply Rmax_l.
  intros b Hb. pose proof (Rmax_l T (exp K - c)). pose proof (Rmax_r T (exp K - c)). enough (f b - e + m * (ln (b + c) - ln (b + c)) <= 0) by lra.
  apply (barrier (fun t => f t - e + m * (ln (t + c) - ln (b + c))) T b); cbv beta; [ lra | | | ].
  - intros t Ht. pose proof (C t ltac:(lra)). contq. lra.
  - intros t Ht. destruct (D t ltac:(lra)) as (l & L & k). exists (l + m / (t + c)). split. { eapply rder_eq. rdq; lra. field. lra. }
    intros P. assert (ln (t + c) <= ln (b + c)) by (apply ln_mono; lra). specialize (k ltac:(nra)). lra.
  - assert (k : K <= ln (b + c)) by (rewrite <- (ln_exp K); apply ln_mono; split; [ apply exp_pos | lra ]).
    replace (f T - e) with (m * (K - ln (T + c))) by (unfold K; field; lra). nra.
Qed.

(* ---- limits as the time goes to infinity ---- *)
Notation tends f l := (is_lim f p_infty (Finite l)).
Lemma tends_eq f (l l' : R) : tends f l -> l = l' -> tends f l'. Proof. now intros H <-. Qed.
Lemma tends_ext T f g (l : R) : (forall t, T <= t -> f t = g t) -> tends f l -> tends g l.
Proof. intros H. apply is_lim_ext_loc. exists T. intros t Ht. apply H. lra. Qed.
Lemma tends_comp g f (l : R) : tends f l -> continuity_pt g l -> tends (fun t => g (f t)) (g l).
Proof. intros H C. apply (filterlim_comp _ _ _ f g _ _ _ H). now apply continuity_pt_filterlim. Qed.
Lemma tends_mult f g (l m : R) : tends f l -> tends g m -> tends (fun t => f t * g t) (l * m).
Proof. intros H K. exact (is_lim_mult f g p_infty l m H K I). Qed.
Ltac lim := match goal with
  | |- is_lim (fun _ => ?c) _ _ => apply is_lim_const
  | _ => eassumption
  | |- is_lim (fun t => sqrt (@?a t)) _ _ => apply (tends_comp sqrt a); [ lim | apply continuity_pt_sqrt ]
  | |- is_lim (fun t => ln (@?a t)) _ _ => apply (tends_comp ln a); [ lim | apply (cont_ln (fun y => y)); [ contq | ] ]
  | |- is_lim (fun t => / @?a t) _ _ => apply (tends_comp Rinv a); [ lim | apply (cont_inv (fun y => y)); [ contq | ] ]
  | |- is_lim (fun t => Rabs (@?a t)) _ _ => apply (tends_comp Rabs a); [ lim | apply Rcontinuity_abs ]
  | |- is_lim (fun t => - @?a t) _ _ => apply (tends_comp Ropp a); [ lim | apply (continuity_pt_opp (fun y => y)); contq ]
  | |- is_lim (fun t => @?a t ^ ?n) _ _ => apply (tends_comp (fun y => y ^ n) a); [ lim | contq ]
  | |- is_lim (fun t => @?a t + @?b t) _ _ => apply (is_lim_plus' a b); lim
  | |- is_lim (fun t => @?a t - @?b t) _ _ => apply (is_lim_minus' a b); lim
  | |- is_lim (fun t => @?a t * @?b t) _ _ => apply (tends_mult a b); lim
  | |- is_lim (fun t => @?a t / @?b t) _ _ => apply (tends_mult a (fun t => / b t)); lim
  end.
(* leaves the conditions, then the value *)
Ltac limit := eapply tends_eq; [ lim | ]; cbv beta.
(* in the end it is within e of its limit *)
Lemma in_the_end T f (l e : R) : tends f l -> 0 < e -> exists T', T <= T' /\ forall t, T' <= t -> l - e < f t < l + e.
Proof.
  intros H He. destruct (lim_near f l e H He) as (T' & T0 & HT). exists (Rmax T T'). split. apply Rmax_l.
  intros t Ht. pose proof (Rmax_r T T'). apply HT. lra.
Qed.
Lemma by_square f (l : R) : (forall e, 0 < e -> exists T, forall t, T <= t -> (f t - l) ^ 2 <= e) -> tends f l.
Proof.
  intros H. apply is_lim_spec. intros e. pose proof (cond_pos e). destruct (H (e ^ 2 / 4)) as [T HT]. nra.
  exists T. intros t Ht. specialize (HT t ltac:(lra)). simpl. apply Rabs_def1; nra.
Qed.

(* l'Hôpital *)
Lemma hospital_half T f df g dg m m' : (forall t, T <= t -> rder f t (df t) /\ rder g t (dg t) /\ df t <= m * dg t) -> m < m' ->
  (forall t, T < t -> continuity_pt f t /\ continuity_pt g t) -> is_lim g p_infty p_infty -> exists T', T <= T' /\ forall t, T' <= t -> f t < m' * g
    t.
Proof.
  intros D Hm C G. set (c := f T - m * g T). apply is_lim_spec in G. destruct (G (c / (m' - m))) as [T2 HG]. exists (Rmax T (T2 + 1)).
  split. apply Rmax_l. intros t Ht. pose proof (Rmax_l T (T2 + 1)). pose proof (Rmax_r T (T2 + 1)). specialize (HG t ltac:(lra)).
  apply Rlt_div_l in HG; [ | lra ]. enough (f t - m * g t <= c) by lra. apply (rder_decr (fun t => f t - m * g t)); [ lra | | ]; intros r Hr.
  - destruct (C r ltac:(lra)). contq.
  - destruct (D r ltac:(lra)) as (F & K & k). eexists. split. rdq. lra.
Qed.
Lemma hospital T f df g dg (L : R) : (forall t, T <= t -> rder f t (df t) /\ rder g t (dg t) /\ 0 < dg t) ->
  (forall t, T < t -> continuity_pt f t /\ continuity_pt g t) -> tends (fun t => df t / dg t) L -> is_lim g p_infty p_infty ->
  tends (fun t => f t / g t) L.
Proof.
  intros D C H G. apply is_lim_spec. intros eps. pose proof (cond_pos eps) as ep.
    destruct (in_the_end T _ L (eps / 2) H ltac:(lra)) as (T1 & T10 & HT).
  assert (near : forall t, T1 <= t -> (L - eps / 2) * dg t <= df t <= (L + eps / 2) * dg t).
  { intros t Ht. specialize (HT t Ht). destruct (D t ltac:(lra)) as (_ & _ & k).
    replace (df t) with (df t / dg t * dg t) by (field; lra). split; apply Rmult_le_compat_r; lra. }
  destruct (hospital_half T1 f df g dg (L + eps / 2) (L + eps)) as (T2 & T20 & H2); trivial; try lra.
  { intros t Ht. destruct (D t ltac:(lra)) as (F & K & _). specialize (near t Ht). repeat split; trivial. lra. } { intros; apply C; lra. }
  destruct (hospital_half T1 (fun t => - f t) (fun t => - df t) g dg (- (L - eps / 2)) (- (L - eps))) as (T3 & T30 & H3); trivial; try lra.
  { intros t Ht. destruct (D t ltac:(lra)) as (F & K & _). specialize (near t Ht). repeat split; trivial. now apply rder_opp. lra. }
  { intros t Ht. destruct (C t ltac:(lra)). split; contq. }
  apply is_lim_spec in G. destruct (G 0) as [T4 H4]. exists (Rmax (Rmax T2 T3) T4). intros t Ht. pose proof (Rmax_l T2 T3). pose proof (Rmax_r T2 T3).
  pose proof (Rmax_l (Rmax T2 T3) T4). pose proof (Rmax_r (Rmax T2 T3) T4). specialize (H4 t ltac:(lra)). specialize (H2 t ltac:(lra)).
  specialize (H3 t ltac:(lra)). enough (L - eps < f t / g t < L + eps) by (apply Rabs_def1; lra).
  split; [ apply Rlt_div_r | apply Rlt_div_l ]; lra.
Qed.

(* f = 1 + c (ln t)/t + o((ln t)/t) *)
Definition near f (c : R) := is_lim (fun t => (f t - 1) * (t / ln t)) p_infty c.
Lemma lnt t : exp 1 <= t -> 1 <= ln t /\ 1 < t.
Proof. intros H. pose proof (exp_ineq1 1). split. rewrite <- (ln_exp 1). apply ln_mono. split; trivial. apply exp_pos. lra. Qed.
Lemma near_one f c : near f c -> tends f 1.
Proof.
  intros H. pose proof is_lim_div_ln_p as Z. apply (tends_ext (exp 1) (fun t => (f t - 1) * (t / ln t) * (ln t / t) + 1)).
  - intros t Ht. destruct (lnt t Ht). field. lra.
  - eapply tends_eq. apply is_lim_plus'; [ apply tends_mult; [ exact H | exact Z ] | apply is_lim_const ]. ring.
Qed.
Lemma near_eq f c c' : near f c -> c = c' -> near f c'. Proof. now intros H <-. Qed.
Lemma near_ext T f g c : (forall t, T <= t -> f t = g t) -> near f c -> near g c.
Proof. intros H. apply (tends_ext T). intros t Ht. now rewrite H. Qed.
Lemma near_mult f g c d : near f c -> near g d -> near (fun t => f t * g t) (c + d).
Proof.
  intros F G. pose proof (near_one g d G) as G1. apply (is_lim_ext (fun t => (f t - 1) * (t / ln t) * g t + (g t - 1) * (t / ln t))).
  - intros t. ring.
  - eapply tends_eq. apply is_lim_plus'; [ apply tends_mult; [ exact F | exact G1 ] | exact G ]. ring.
Qed.
(* what goes through 1 at 1, with the slope a *)
Lemma near_comp g a f c : is_derive g 1 a -> g 1 = 1 -> near f c -> near (fun t => g (f t)) (a * c).
Proof.
  intros G e F. pose proof (near_one f c F) as F1. set (q h := if Req_EM_T h 1 then a else (g h - 1) / (h - 1)).
  assert (Q : continuity_pt q 1).
  { apply is_derive_Reals in G. intros eps He. destruct (G eps He) as [d Hd]. exists d. split. apply cond_pos. intros h [_ hd].
    simpl in *. unfold R_dist, q in *. destruct (Req_EM_T 1 1); [ | lra ]. destruct (Req_EM_T h 1) as [-> | n]. now rewrite Rminus_eq_0, Rabs_R0.
    specialize (Hd (h - 1) ltac:(lra) hd). replace (1 + (h - 1)) with h in Hd by ring. now rewrite e in Hd. }
  apply (is_lim_ext (fun t => q (f t) * ((f t - 1) * (t / ln t)))).
  - intros t. unfold q. destruct (Req_EM_T (f t) 1) as [-> | n]. rewrite e. ring. unfold Rdiv. set (k := t * / ln t). field. lra.
  - replace a with (q 1) by (unfold q; now destruct (Req_EM_T 1 1)). apply tends_mult; trivial. now apply tends_comp.
Qed.
Lemma near_root f c : near f c -> near (fun t => sqrt (f t)) (/ 2 * c).
Proof. apply near_comp; [ | apply sqrt_1 ]. auto_derive. lra. rewrite sqrt_1. field. Qed.
Lemma near_inv f c : near f c -> near (fun t => / f t) (- (1) * c).
Proof. apply near_comp; [ | apply Rinv_1 ]. auto_derive. lra. field. Qed.
Lemma near_pow f n c : near f c -> near (fun t => f t ^ n) (INR n * c).
Proof. apply (near_comp (fun y => y ^ n)); [ | apply pow1 ]. auto_derive; trivial. rewrite pow1. ring. Qed.
Ltac nears := match goal with
  | _ => eassumption
  | |- near (fun t => sqrt (@?a t)) _ => apply (near_root a); nears
  | |- near (fun t => / @?a t) _ => apply (near_inv a); nears
  | |- near (fun t => @?a t * @?b t) _ => apply (near_mult a b); nears
  | |- near (fun t => @?a t / @?b t) _ => apply (near_mult a (fun t => / b t)); nears
  | |- near (fun t => @?a t ^ ?n) _ => apply (near_pow a n); nears
  end.
Lemma inv_ln : tends (fun t => / ln t) 0.
Proof. exact (is_lim_inv ln p_infty p_infty is_lim_ln_p ltac:(discriminate)). Qed.
(* what differs from 1 by a bounded multiple of 1/t has no term in (ln t)/t *)
Lemma near_small T f g (l : R) : tends g l -> (forall t, T <= t -> f t = 1 + g t / t) -> near f 0.
Proof.
  intros G H. pose proof inv_ln as Z. cbv beta in Z. apply (tends_ext (Rmax T (exp 1)) (fun t => g t * / ln t)).
  - intros t Ht. pose proof (Rmax_l T (exp 1)). pose proof (Rmax_r T (exp 1)). rewrite H by lra. destruct (lnt t ltac:(lra)). field. lra.
  - limit. ring.
Qed.
