(* The block shaken by (21), and what (1) says of every motion of it from every start: units, how much the velocity can change, the slip from a rest
   at phi1, and where rests are possible. *)
Require Import Reals Lra Psatz ZArith FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Formulas HalfPeriod Drawn Analysis Steady.
Open Scope R_scope.

(* The block on a plane with the acceleration (21), of size A0 (a length over a time squared) and frequency varpi: (vx, vy) is its velocity at the
time t
   after the start, which is at t0; mu g is the largest friction. «$(vx,vy)$ is a motion from the time $t0$ on under the acceleration
   $-A0\sin(varpi\,t)$ along $x$, with the friction $mu\,g$» *)
Definition block (mu g A0 varpi t0 : R) (vx vy : R -> R) : Prop :=
  motion (mu * g) (fun t => eq21_acceleration_1 A0 varpi (t0 + t)) (fun t => eq21_acceleration_2 A0 varpi (t0 + t)) vx vy.
(* The same in units in which g, A0 and varpi are 1, so that all is dimensionless: lam is (22), phi0 the phase at the start, s how far the phase has
   gone on since, (w, wy) the velocity in units of A0/varpi. «$(w,wy)$ is a motion in the units of (22) to (24), from the phase $phi0$ on, with the
   friction $\lambda_0=lam$» *)
Definition shaken (lam phi0 : R) (w wy : R -> R) : Prop := block lam 1 1 1 phi0 w wy.
(* At s, after a start at phi0, the phase is phi, up to whole periods; in radians. «$phi0+s$ is $phi$ up to whole periods» *)
Definition at_phase (phi0 s phi : R) : Prop := exists n, phi0 + s = phi + IZR n * (2 * PI).
(* phitilde2, in radians: the smallest solution of (32) above phi1. «$e$ is the smallest solution of (32) above $\phi_1$, with the friction
   $\lambda_0=lam$» *)
Definition slip_end (lam e : R) : Prop :=
  eq27_phi1 lam < e /\ eq32_left lam (eq27_phi1 lam) e = 0 /\ forall x, eq27_phi1 lam < x < e -> eq32_left lam (eq27_phi1 lam) x <> 0.

Lemma motion_eq k a b x y k' a' b' x' y' : motion k a b x y -> k = k' -> (forall s, a s = a' s) -> (forall s, b s = b' s) ->
  (forall s, x s = x' s) -> (forall s, y s = y' s) -> motion k' a' b' x' y'.
Proof.
  intros M <- A B X Y. now rewrite <- (functional_extensionality _ _ A), <- (functional_extensionality _ _ B), <- (functional_extensionality _ _ X),
  <- (functional_extensionality _ _ Y).
Qed.
Lemma shaken_sin lam phi0 w wy : shaken lam phi0 w wy = motion lam (fun s => - sin (phi0 + s)) (fun _ => 0) w wy.
Proof.
  unfold shaken, block, eq21_acceleration_1, eq21_acceleration_2. rewrite Rmult_1_r. f_equal.
  apply functional_extensionality. intros s. rewrite Rmult_1_l. ring.
Qed.

(* ---- units ---- *)
Lemma motion_scale k A B v w c b : 0 < c -> 0 < b -> motion k A B v w ->
  motion (c * b * k) (fun s => c * b * A (b * s)) (fun s => c * b * B (b * s)) (fun s => c * v (b * s)) (fun s => c * w (b * s)).
Proof.
  intros hc hb [cv cw L]. assert (S : forall f t, (forall u, 0 < u -> continuity_pt f u) -> 0 < t -> continuity_pt (fun s => c * f (b * s)) t).
  { intros f t H Ht. pose proof (cont_time b f t (H (b * t) ltac:(nra))). cont. }
  split; [ intros; now apply S | intros; now apply S | ]. intros t Ht. destruct (L (b * t)) as (fx & fy & [F P] & X & Y); [ nra | ].
  exists (c * b * fx), (c * b * fy). split; [ split | split ].
  - rewrite !(Rpow_mult_distr (c * b)), <- Rmult_plus_distr_l. apply Rmult_le_compat_l; [ apply pow2_ge_0 | trivial ].
  - rewrite nrm_scale by lra. transitivity (c * b * c * (fx * v (b * t) + fy * w (b * t))); [ ring | rewrite P; ring ].
  - eapply rder_eq; [ apply (rder_mult (fun _ => c) (fun s => v (b * s))); [ rd | apply rder_time; eassumption ] | ring ].
  - eapply rder_eq; [ apply (rder_mult (fun _ => c) (fun s => w (b * s))); [ rd | apply rder_time; eassumption ] | ring ].
Qed.
Lemma block_units mu g A0 varpi t0 vx vy : 0 < A0 -> 0 < varpi ->
  (block mu g A0 varpi t0 vx vy <->
   shaken (eq22_lambda0 mu g A0) (eq23_phase varpi t0) (fun s => eq24_w varpi (vx (s / varpi)) A0) (fun s => eq24_w varpi (vy (s / varpi)) A0)).
Proof.
  intros hA hv. unfold block, shaken, block, eq21_acceleration_1, eq21_acceleration_2, eq22_lambda0, eq23_phase, eq24_w.
  assert (0 < / varpi) by now apply Rinv_0_lt_compat. assert (0 < / A0) by now apply Rinv_0_lt_compat.
  split; intros M.
  - eapply motion_eq. apply (motion_scale _ _ _ _ _ (varpi / A0) (/ varpi)) in M; [ exact M | apply Rdiv_lt_0_compat; lra | trivial ].
    all: try intros s; cbv beta; try (unfold Rdiv; rewrite (Rmult_comm s)); try (field; lra).
    replace (1 * (varpi * t0 + s)) with (varpi * (t0 + / varpi * s)) by (field; lra). field; lra.
  - eapply motion_eq. apply (motion_scale _ _ _ _ _ (A0 / varpi) varpi) in M; [ exact M | apply Rdiv_lt_0_compat; lra | trivial ].
    all: try intros s; cbv beta; try (replace (varpi * s / varpi) with s by (field; lra)); try (field; lra).
    replace (1 * (varpi * t0 + varpi * s)) with (varpi * (t0 + s)) by ring. field; lra.
Qed.
(* ---- periods ---- *)
Lemma whole_periods (f : R -> R) x n : (forall x, f (x + 2 * PI) = f x) -> f (x + IZR n * (2 * PI)) = f x.
Proof. intros H. rewrite <- (shift_Z (2 * PI) f H n (x + IZR n * (2 * PI))). f_equal. ring. Qed.
Lemma phase_in start phi0 s : exists x, start <= x < start + 2 * PI /\ at_phase phi0 s x.
Proof.
  pose proof PI_RGT_0. destruct (per_spec start (2 * PI) ltac:(lra) (phi0 + s)) as [n Hn]. exists (phi0 + s - IZR n * (2 * PI)).
  split; [ lra | ]. exists n. ring.
Qed.
(* a moment as late as one likes at which the drive is at a given phase *)
Lemma phase_after phi0 phi T : exists s, T <= s < T + 2 * PI /\ at_phase phi0 s phi.
Proof. destruct (phase_in T (- phi0) phi) as (s & hs & n & E). exists s. split; [ lra | ]. exists (- n)%Z. rewrite opp_IZR. lra. Qed.
Lemma at_sin phi0 s phi u : at_phase phi0 s phi -> sin (phi0 + (s + u)) = sin (phi + u) /\ cos (phi0 + (s + u)) = cos (phi + u).
Proof.
  intros [n E]. replace (phi0 + (s + u)) with (phi + u + IZR n * (2 * PI)) by lra.
  rewrite (whole_periods sin _ n sin_per), (whole_periods cos _ n cos_per). auto.
Qed.
(* continuity of what is made of the velocities of the motion M *)
Ltac conts M := cont; first [ lra | (apply (m_cx _ _ _ _ _ M) || apply (m_cy _ _ _ _ _ M)); lra ].

Section Motion.
Variables (l phi0 : R) (w wy : R -> R).
Hypothesis hl : 0 <= l.
Hypothesis M : shaken l phi0 w wy.
Lemma law s : 0 <= s -> exists fx fy, coulomb l (w s) (wy s) fx fy /\ (nrm (w s) (wy s) * fx = - l * w s /\ nrm (w s) (wy s) * fy = - l * wy s) /\
  - l <= fx <= l /\ rder w s (sin (phi0 + s) + fx) /\ rder wy s fy.
Proof.
  intros hs. rewrite shaken_sin in M. destruct (m_law _ _ _ _ _ M s hs) as (fx & fy & C & X & Y). exists fx, fy. pose proof (proj1 C).
  split; [ trivial | split; [ now apply coulomb_slip | split; [ nra | split ] ] ]. eapply rder_eq; [ exact X | ring ].
  eapply rder_eq; [ exact Y | ring ].
Qed.
(* the drive, and friction at most l one way or the other *)
Lemma gain s t : 0 <= s <= t ->
  cos (phi0 + s) - cos (phi0 + t) - l * (t - s) <= w t - w s <= cos (phi0 + s) - cos (phi0 + t) + l * (t - s).
Proof.
  intros H. assert (D : forall u, is_derive (fun t => cos (phi0 + t)) u (- sin (phi0 + u))) by (intros; auto_derive; trivial; ring).
  enough (A : Rabs (w t + cos (phi0 + t) - (w s + cos (phi0 + s))) <= l * (t - s)) by (apply Rabs_le_between in A; lra).
  apply (rder_lip (fun t => w t + cos (phi0 + t))); [ lra | | ]; intros u Hu.
  - pose proof (cont_of _ _ _ (D u)). conts M.
  - destruct (law u) as (fx & fy & _ & _ & F & X & _); [ lra | ]. exists fx. split; [ | apply Rabs_le; lra ].
    eapply rder_eq; [ apply (rder_plus w (fun t => cos (phi0 + t))); [ exact X | exact (rder_of _ _ _ (D u)) ] | ring ].
Qed.
(* a rest ends only where the drive exceeds friction; a while of rest needs it not to *)
Lemma stays s u : 0 <= s <= u -> (forall t, s <= t < u -> Rabs (sin (phi0 + t)) <= l) -> w s = 0 -> wy s = 0 -> w u = 0 /\ wy u = 0.
Proof.
  intros H HA e1 e2. apply sq_sum. replace 0 with (w s ^ 2 + wy s ^ 2) by (rewrite e1, e2; ring).
  apply (rder_decr (fun t => w t ^ 2 + wy t ^ 2)); [ lra | | ]; intros t Ht; [ conts M | ].
  destruct (law t) as (fx & fy & [_ P] & _ & _ & X & Y); [ lra | ]. eexists. split. rd. simpl.
  pose proof (dot_le (sin (phi0 + t)) 0 (w t) (wy t)) as Q. rewrite nrm_x in Q. specialize (HA t Ht). pose proof (nrm_pos (w t) (wy t)). nra.
Qed.
Lemma rest_needs_friction r s t : 0 <= r <= t -> t < s -> (forall t, r <= t < s -> w t = 0) -> Rabs (sin (phi0 + t)) <= l.
Proof.
  intros Ht Hs W. destruct (law t) as (fx & fy & _ & _ & F & X & _); [ lra | ].
  pose proof (rder_unique w t _ _ X (rder_zero w t (s - t) ltac:(lra) ltac:(intros; apply W; lra))). apply Rabs_le. lra.
Qed.
(* (31): from a rest at phi1 on *)
Lemma slip_is c u tau : 0 <= c -> at_phase phi0 c (asin l) -> w c = 0 -> wy c = 0 -> (forall t, 0 < t < tau -> 0 < h l t) -> 0 <= u <= tau ->
  w (c + u) = h l u /\ wy (c + u) = 0.
Proof.
  intros hc P e1 e2 Q Hu. destruct (sq_sum (w (c + u) - h l (c + u - c)) (wy (c + u))) as [a b].
  - replace 0 with ((w c - h l (c - c)) ^ 2 + wy c ^ 2) by (replace (c - c) with 0 by ring; rewrite e1, e2, h_0; ring).
    apply (rder_decr (fun t => (w t - h l (t - c)) ^ 2 + wy t ^ 2)); [ lra | | ]; intros t Ht.
    + assert (continuity_pt (fun t => h l (t - c)) t) by apply cont_shift, h_cont. conts M.
    + destruct (law t) as (fx & fy & [_ C] & _ & F & X & Y); [ lra | ].
      assert (D : rder (fun t => h l (t - c)) t (sin (asin l + (t - c)) - l)) by (apply rder_shift, rder_of, h_der).
      destruct (at_sin phi0 c (asin l) (t - c) P) as [S _]. replace (c + (t - c)) with t in S by ring. rewrite S in X.
      assert (0 <= h l (t - c)) by (destruct (Req_dec (t - c) 0) as [-> | ]; [ rewrite h_0; lra | left; apply Q; lra ]).
      eexists. split. rd. pose proof (abs_nrm (w t) (wy t)) as [N _]. pose proof (Rle_abs (w t)).
      match goal with |- ?g <= 0 => replace g with (2 * ((fx * w t + fy * wy t) + l * w t - h l (t - c) * (fx + l))) by (simpl; ring) end.
      rewrite C. nra.
  - replace (c + u - c) with u in a by ring. lra.
Qed.
End Motion.
