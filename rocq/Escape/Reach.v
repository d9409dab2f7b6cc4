(* Towards theorem 20: seen from the laboratory the acceleration is the friction, so rho grows at most as t^2 / 2 *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable Sphere Fate Alpha.
Open Scope R_scope.

Section Lab.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
(* the speed that the laboratory sees *)
Notation lab t := (nrm (u t - y t) (w t + x t)).
Ltac conts := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

(* a length grows no faster than B where it does so whenever it is not 0 *)
Lemma length_below (f g B : R -> R) s t : s <= t -> (forall r, s < r <= t -> continuity_pt f r /\ continuity_pt g r /\ continuity_pt B r) ->
  (forall r, s <= r < t -> exists a b c, rder f r a /\ rder g r b /\ rder B r c /\ 0 <= c /\ f r * a + g r * b <= c * nrm (f r) (g r)) ->
  nrm (f t) (g t) - nrm (f s) (g s) <= B t - B s.
Proof.
  intros Hst C D. apply le_epsilon. intros d Hd. set (q r := sqrt (f r ^ 2 + g r ^ 2 + d ^ 2)). assert (dd : 0 < d ^ 2) by nra.
  assert (pos : forall r, 0 < f r ^ 2 + g r ^ 2 + d ^ 2) by (intros r; pose proof (pow2_ge_0 (f r)); pose proof (pow2_ge_0 (g r)); lra).
  assert (q1 : forall r, nrm (f r) (g r) <= q r <= nrm (f r) (g r) + d).
  { intros r. split. apply sqrt_le_1_alt; lra. unfold q. rewrite <- nrm_sq. rewrite <- (Rabs_pos_eq (nrm (f r) (g r))) at 2 by apply nrm_pos. apply root_le; lra. }
  assert (K : q t - B t <= q s - B s).
  { apply (rder_decr (fun r => q r - B r)); trivial; intros r Hr; [ destruct (C r Hr) as (c1 & c2 & c3) | destruct (D r Hr) as (a & b & c & F & G & H & c0 & P) ].
    - apply (continuity_pt_minus q B); trivial. apply cont_root; [ cont | left; apply pos ].
    - eexists. split. apply (rder_minus q B); [ apply rder_root; [ rd | apply pos ] | exact H ]. simpl INR. simpl pred. cbv beta.
      change (sqrt (f r ^ 2 + g r ^ 2 + d ^ 2)) with (q r). assert (qq : 0 < q r) by (apply sqrt_lt_R0, pos). specialize (q1 r).
      match goal with |- ?z - c <= 0 => replace z with ((f r * a + g r * b) / q r) by (field; lra) end.
      enough ((f r * a + g r * b) / q r <= c) by lra. apply Rle_div_l; trivial. nra. }
  pose proof (q1 t). pose proof (q1 s). lra.
Qed.
Theorem lab_speed s t : 0 <= s <= t -> lab t <= lab s + (t - s).
Proof.
  intros Hst. enough (lab t - lab s <= t - s) by lra.
  apply (length_below (fun t => u t - y t) (fun t => w t + x t) (fun t => t) s t); [ lra | | ]; intros r Hr.
  - split; [ conts | split; [ conts | cont ] ].
  - destruct (s_law _ _ _ _ S r) as (X & Y & fx & fy & [B P] & U & W); [ lra | ]. exists (w r + x r + fx), (- (u r - y r) + fy), 1.
    split. { eapply rder_eq; [ rd | ring ]. } split. { eapply rder_eq; [ rd | ring ]. } split. { apply rder_of. auto_derive; trivial. } split. lra.
    pose proof (power_bound 1 fx fy (- (u r - y r)) (- (w r + x r)) Rle_0_1 ltac:(lra)) as Q.
    replace (nrm (- (u r - y r)) (- (w r + x r))) with (lab r) in Q by (unfold nrm; f_equal; ring). lra.
Qed.
Theorem place_below s t : 0 <= s <= t -> rho t <= rho s + lab s * (t - s) + (t - s) ^ 2 / 2.
Proof.
  intros Hst. enough (rho t - rho s <= (lab s * (t - s) + (t - s) ^ 2 * / 2) - (lab s * (s - s) + (s - s) ^ 2 * / 2)) by lra.
  apply (length_below x y (fun t => lab s * (t - s) + (t - s) ^ 2 * / 2) s t); [ lra | | ]; intros r Hr.
  - split; [ apply (s_cx _ _ _ _ S); lra | split; [ apply (s_cy _ _ _ _ S); lra | cont ] ].
  - destruct (s_law _ _ _ _ S r) as (X & Y & _); [ lra | ]. exists (u r), (w r), (lab s + (r - s)). split; trivial. split; trivial. split. { apply rder_of. auto_derive; trivial. field. }
    pose proof (nrm_pos (u s - y s) (w s + x s)). split. lra. apply Rle_trans with (lab r * rho r).
    + pose proof (power_bound (lab r) (u r - y r) (w r + x r) (- x r) (- y r) (nrm_pos _ _) ltac:(rewrite nrm_sq; lra)) as Q.
      replace (nrm (- x r) (- y r)) with (rho r) in Q by (unfold nrm; f_equal; ring). lra.
    + apply Rmult_le_compat_r. apply nrm_pos. pose proof (lab_speed s r ltac:(lra)). lra.
Qed.
End Lab.
