(* Motion along a line with a friction that differs forward and backward: the law; motions put together from arcs; when
   every motion is drawn to a periodic one. Time is the phase of the drive, so that no shifts are needed. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Drawn.
Open Scope R_scope.

(* the force of friction at the velocity w: - l forward, m backward, anything between at rest *)
Definition dry (l m w f : R) : Prop := - l <= f <= m /\ (0 < w -> f = - l) /\ (w < 0 -> f = m).

(* (51), (52) with rest, for any drive a: a motion along the line from t0 on *)
Record line (l m : R) (a : R -> R) (t0 : R) (w : R -> R) : Prop := {
  l_c : forall t, t0 < t -> continuity_pt w t;
  l_law : forall t, t0 <= t -> exists f, dry l m (w t) f /\ rder w t (a t + f) }.

(* with l = m it is the motion of the plane, along its first axis *)
Lemma dry_coulomb k w f : 0 <= k -> dry k k w f -> coulomb k w 0 f 0.
Proof.
  intros hk (D & P & N). split; [ nra | ]. rewrite nrm_x. unfold Rabs. destruct (Rcase_abs w) as [n | n]. rewrite N by lra; ring.
  destruct n as [n | n]. rewrite P by lra; ring. rewrite n; ring.
Qed.
(* two motions along a line, as motions of the plane *)
Lemma dry_brakes l m u w f g : dry l m u f -> dry l m w g -> brakes l m u 0 w f 0 g.
Proof.
  intros (F & F1 & F2) (G & G1 & G2). unfold brakes. rewrite nrm_x. split; [ lra | split; [ lra | split; [ | split ] ] ].
  - destruct (Rtotal_order u w) as [k | [-> | k]]; [ | lra | ].
    + assert (f >= g) by (destruct (Rlt_le_dec u 0); [ rewrite F2 | rewrite G1 ]; lra). nra.
    + assert (f <= g) by (destruct (Rlt_le_dec 0 u); [ rewrite F1 | rewrite G2 ]; lra). nra.
  - intros s n [-> | ->] hw hn.
    + rewrite G1 by lra. destruct (Rlt_le_dec u 0) as [k | k]; [ rewrite Rabs_left in hn by trivial; rewrite F2 by trivial |
      rewrite Rabs_pos_eq in hn by trivial ]; nra.
    + rewrite G2 by lra. destruct (Rlt_le_dec 0 u) as [k | k]; [ rewrite Rabs_pos_eq in hn by lra; rewrite F1 by trivial |
      rewrite Rabs_left1 in hn by trivial ]; nra.
  - intros c -> b. destruct (total_order_T u 0) as [[k | ->] | k]; [ rewrite Rabs_left, F2 by trivial | rewrite Rabs_R0 | rewrite Rabs_pos_eq,
    F1 by lra ]; nra.
Qed.
Lemma line_two l m a t0 w u : line l m a t0 w -> line l m a t0 u -> two_motions l m a t0 w (fun _ => 0) u.
Proof.
  intros [cw W] [cu U]. split; [ intros; split; [ auto | split; [ cont | auto ] ] | ]. intros t Ht. destruct (W t Ht) as (f & F & X).
  destruct (U t Ht) as (g & G & Y). exists f, 0, g.
  split; [ now apply dry_brakes | split; [ trivial | split; [ apply rder_fixed | trivial ] ] ].
Qed.
(* friction never drives two velocities apart *)
Theorem line_contraction l m a t0 w u : line l m a t0 w -> line l m a t0 u -> forall s t, t0 <= s <= t -> Rabs (w t - u t) <= Rabs (w s - u s).
Proof.
  intros H K s t Hst. pose proof (gap_falls _ _ _ _ _ _ _ (line_two _ _ _ _ _ _ H K) s t Hst) as G. unfold gap in G.
  apply abs_of_sq; [ apply Rabs_pos | rewrite pow2_abs; lra ].
Qed.

(* ---- motions in pieces ---- *)
Definition arc (l m : R) (a : R -> R) (p q : R) (w : R -> R) : Prop :=
  (forall t, p <= t <= q -> continuity_pt w t) /\ (forall t, p <= t < q -> exists f, dry l m (w t) f /\ rder w t (a t + f)).
Definition glue (q : R) (u v : R -> R) t := if Rlt_dec t q then u t else v t.
Lemma glue_l q u v t : t < q -> glue q u v t = u t. Proof. intros k. unfold glue. destruct (Rlt_dec t q); [ trivial | lra ]. Qed.
Lemma glue_r q u v t : q <= t -> glue q u v t = v t. Proof. intros k. unfold glue. destruct (Rlt_dec t q); [ lra | trivial ]. Qed.
Lemma arc_glue l m a p q r u v : p <= q <= r -> arc l m a p q u -> arc l m a q r v -> u q = v q -> arc l m a p r (glue q u v).
Proof.
  intros H [cu U] [cv V] e. split.
  - intros t Ht. destruct (total_order_T t q) as [[k | ->] | k].
    + apply (cont_glue _ u u t (q - t)); [ lra | | | apply cu; lra | apply cu; lra ]; intros s Hs; apply glue_l; lra.
    + apply (cont_glue _ u v q 1); [ lra | | | apply cu; lra | apply cv; lra ]; intros s Hs; [ | apply glue_r; lra ].
      destruct (Req_dec s q) as [-> | ]; [ rewrite glue_r by lra; auto | apply glue_l; lra ].
    + apply (cont_glue _ v v t (t - q)); [ lra | | | apply cv; lra | apply cv; lra ]; intros s Hs; apply glue_r; lra.
  - intros t Ht. destruct (Rlt_le_dec t q) as [k | k].
    + destruct (U t) as (f & F & X); [ lra | ]. exists f. rewrite glue_l by trivial. split; trivial.
      apply (rder_near _ u t _ (q - t)); [ lra | | trivial ]. intros s Hs. rewrite glue_l by lra. trivial.
    + destruct (V t) as (f & F & X); [ lra | ]. exists f. rewrite glue_r by trivial. split; trivial.
      apply (rder_near _ v t _ 1); [ lra | | trivial ]. intros s Hs. rewrite glue_r by lra. trivial.
Qed.
(* a period that ends where it began, repeated for ever, is a motion *)
Lemma periodic_line l m a p T g : 0 < T -> (forall t, a (t + T) = a t) -> g (p + T) = g p -> arc l m a p (p + T) g ->
  exists W, (forall t0, line l m a t0 W) /\ (forall t, W (t + T) = W t) /\ forall t, p <= t <= p + T -> W t = g t.
Proof.
  intros hT ha hg [c L]. assert (on : forall n t, p + IZR n * T <= t < p + (IZR n + 1) * T -> per p T g t = g (t - IZR n * T)) by (intros;
  now apply per_on).
  exists (per p T g). split; [ | split; [ intros; now apply per_per | ] ].
  - intros t0. split; intros t _.
    + apply (continuity_pt_ext (fun t => per p T g (p + (t - p)))); [ intros; f_equal; ring | ].
      apply (cont_shift (fun s => per p T g (p + s)) p), (tiles_cont T hT _ (fun _ s => g (p + s))).
      * intros n s Hs. rewrite (on n) by lra. f_equal. ring.
      * intros _ s Hs. apply cont_phase, c. lra.
      * intros _. rewrite Rplus_0_r. trivial.
    + destruct (per_spec p T hT t) as [n Hn]. destruct (L (t - IZR n * T)) as (f & F & X); [ lra | ]. exists f. rewrite (on n) by lra. split; trivial.
      rewrite (shift_Z T a ha) in X. apply (rder_near _ (fun s => g (s - IZR n * T)) t _ (p + (IZR n + 1) * T - t)); [ lra | intros s Hs; symmetry;
      apply on; lra | ].
      now apply rder_shift.
  - intros t Ht. destruct (Req_dec t (p + T)) as [-> | ne].
    + rewrite (on 1%Z) by lra. rewrite hg. f_equal. ring.
    + rewrite (on 0%Z) by lra. f_equal. ring.
Qed.

(* so is, in the plane, an arc of half a period that ends with the opposite of its beginning *)
Lemma half_arc l h T g : 0 <= l -> 0 < T -> (forall t, h (t + T) = - h t) -> g T = - g 0 -> arc l l h 0 T g -> forall p, moves l h p (fun t => ext T g (p + t)) (fun _ => 0).
Proof.
  intros hl hT ha hg [c L] p. apply (half_period_from l T (fun t => - h t) g); trivial; [ intros t; rewrite ha; ring | ].
  intros t Ht. destruct (L t Ht) as (f & F & X). exists f. split; [ now apply dry_coulomb | eapply rder_eq; [ exact X | ring ] ].
Qed.

Section Drawn.
Variables (l m T : R) (a W : R -> R).
Hypothesis hT : 0 < T.
Hypothesis HW : forall t0, line l m a t0 W.
Hypothesis hW : forall t, W (t + T) = W t.
(* a periodic motion that rests, with friction to spare at one moment of it, is reached by every motion *)
Theorem captured r s : (forall t, a (t + T) = a t) -> r < s -> (forall t, r <= t <= s -> W t = 0) -> - m < a r < l -> continuity_pt a r ->
  forall t0 w, line l m a t0 w -> exists t1, t0 <= t1 /\ forall t, t1 <= t -> w t = W t.
Proof.
  intros ha hrs rest spare ca t0 w Hw. destruct (two_meet _ _ _ _ _ _ _ (line_two _ _ _ _ _ _ Hw (HW t0)) T hT hW r s ha hrs rest spare ca) as (t1 &
  h & E). exists t1. split; trivial. intros t Ht. now apply E.
Qed.
(* one that passes from backward to forward at once attracts every motion *)
Theorem line_attracts B z d : 0 < l -> 0 < m -> (forall t, Rabs (a t) <= B) -> 0 < d -> W z = 0 -> (forall t, z - d < t < z -> W t < 0) -> (forall t, z < t < z + d -> 0 < W t) ->
  forall t0 w, line l m a t0 w -> is_lim (fun t => w t - W t) p_infty 0.
Proof.
  intros hl hm hB hd Z b f t0 w Hw. assert (0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra).
  apply (two_attract _ _ _ _ _ _ _ (line_two _ _ _ _ _ _ Hw (HW t0)) T hT hW B z d); trivial; lra.
Qed.
End Drawn.
