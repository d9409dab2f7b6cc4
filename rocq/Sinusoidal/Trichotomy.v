(* 2.2, summary: small, large and very large friction; every start, every phase, the whole plane *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Sinusoidal Periodic Steady Steady2 Pulse Aniso AttractPlane Reached Phases.
Open Scope R_scope.

Lemma ext_cell T g t : 0 < T -> exists n, 0 <= t - IZR n * T < T /\ (ext T g t = 0 <-> g (t - IZR n * T) = 0).
Proof.
  intros hT. pose proof (proj2 (floor_spec T hT t (floor T t)) eq_refl) as H. exists (floor T t). split; [ lra | ]. rewrite (ext_on T g hT _ t H).
  destruct (sg_cases (floor T t)) as [-> | ->]; split; intros; lra.
Qed.
(* small friction: zero at two phases of each period, only *)
Theorem w38_zeros l ph : 0 < l < eq37_lambda_c -> (w38 l ph = 0 <-> exists n, ph = eq39_phi1 l + IZR n * PI).
Proof.
  intros [h0 h1]. pose proof lambda_c_between. pose proof PI_RGT_0. assert (hl : 0 < l < 1) by lra. pose proof (g_pos l hl h1) as P. set (p := eq39_phi1 l) in *. unfold w38. fold p.
  assert (g0 : g38 l p 0 = 0) by (unfold g38; rewrite Rplus_0_r; ring). split.
  - intros E. destruct (ext_cell PI (g38 l p) (ph - p) PI_RGT_0) as (n & Hn & Z). apply Z in E. exists n. destruct (Req_dec (ph - p - IZR n * PI) 0) as [e | e]; [ lra | ].
    specialize (P (ph - p - IZR n * PI) ltac:(lra)). lra.
  - intros [n ->]. rewrite (ext_on PI (g38 l p) PI_RGT_0 n) by lra. replace (p + IZR n * PI - p - IZR n * PI) with 0 by ring. rewrite g0. ring.
Qed.
(* large friction: zero from the end of each slip to the next phase at which the drive overcomes it *)
Theorem w33_zeros l tau ph : 0 < l < 1 -> 0 < tau < PI -> h l tau = 0 -> (w33 l tau ph = 0 <-> exists n, asin l + IZR n * PI + tau <= ph <= asin l + IZR (n + 1) * PI).
Proof.
  intros hl ht z. pose proof PI_RGT_0. destruct (p1_range l hl) as [[a b] e]. unfold w33. assert (h0 : h l 0 = 0) by (unfold h; rewrite Rplus_0_r; ring).
  assert (P : forall t, 0 < t < tau -> 0 < h l t). { intros t Ht. destruct (Rle_lt_dec t (PI - 2 * asin l)). apply h_up; trivial; lra. rewrite <- z. apply h_down; trivial; lra. }
  split.
  - intros E. destruct (ext_cell PI (g33 l tau) (ph - asin l) PI_RGT_0) as (n & Hn & Z). apply Z in E. set (t := ph - asin l - IZR n * PI) in *. unfold g33 in E. destruct (Rlt_dec t tau).
    + destruct (Req_dec t 0) as [e0 | e0]. exists (n - 1)%Z. replace (n - 1 + 1)%Z with n by ring. rewrite minus_IZR. unfold t in *. lra. specialize (P t ltac:(lra)). lra.
    + exists n. rewrite plus_IZR. unfold t in *. lra.
  - intros [n Hn]. rewrite plus_IZR in Hn. destruct (Req_dec ph (asin l + (IZR n + 1) * PI)) as [-> | ne].
    + rewrite (ext_on PI (g33 l tau) PI_RGT_0 (n + 1)) by (rewrite plus_IZR; lra). rewrite plus_IZR. replace (asin l + (IZR n + 1) * PI - asin l - (IZR n + 1) * PI) with 0 by ring. unfold g33. destruct (Rlt_dec 0 tau); [ rewrite h0; ring | lra ].
    + rewrite (ext_on PI (g33 l tau) PI_RGT_0 n) by lra. unfold g33. destruct (Rlt_dec (ph - asin l - IZR n * PI) tau); [ lra | ring ].
Qed.
Theorem s22_trichotomy l ph vx vy : 0 < l -> motion l (fun t => - sin (ph + t)) (fun _ => 0) vx vy ->
  (l < eq37_lambda_c -> is_lim (fun t => vx t - w38 l (ph + t)) p_infty 0 /\ is_lim vy p_infty 0) /\
  (eq37_lambda_c < l < 1 -> exists tau t1, 0 < tau < PI /\ h l tau = 0 /\ forall t, t1 <= t -> vx t = w33 l tau (ph + t) /\ vy t = 0) /\
  (1 < l -> forall t, nrm (vx 0) (vy 0) / (l - 1) <= t -> vx t = 0 /\ vy t = 0).
Proof.
  intros h0 M. split; [ | split ]; intros hl.
  - now apply eq38_is_the_large_time_motion.
  - destruct (eq33_is_the_large_time_motion l hl) as (tau & t0 & z & R). destruct (R ph vx vy M) as [t1 E]. now exists tau, t1.
  - apply (weak_stops l 1 _ _ vx vy ltac:(lra) M). intros t _. unfold nrm. replace ((- sin (ph + t)) ^ 2 + 0 ^ 2) with (Rsqr (sin (ph + t))) by (unfold Rsqr; ring). rewrite sqrt_Rsqr_abs. apply Rabs_le, SIN_bound.
Qed.
