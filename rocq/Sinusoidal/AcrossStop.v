(* The last stage across the drive: where friction exceeds the drive, what is left of the velocity is lost in a finite time, which is known.
   l |v| + d |w| falls at the rate l^2 - d^2 (by steps: |w| need not have a derivative). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Dini AttractPlane Reached Shaken.
Open Scope R_scope.

Section Stop.
Variables (l d phi0 : R) (w wy : R -> R).
Hypothesis hd : 0 <= d < l.
Hypothesis M : shaken l phi0 w wy.
Lemma stops_within s u : 0 <= s -> s + (l * nrm (w s) (wy s) + d * Rabs (w s)) / (l ^ 2 - d ^ 2) <= u ->
  (forall t, s <= t <= u -> Rabs (sin (phi0 + t)) <= d) -> w u = 0 /\ wy u = 0.
Proof.
  intros hs hu hA. assert (hl : 0 <= l) by lra. assert (kd : 0 < l ^ 2 - d ^ 2) by nra. set (L0 := l * nrm (w s) (wy s) + d * Rabs (w s)) in *.
  set (r := L0 / (l ^ 2 - d ^ 2)) in *. assert (er : (l ^ 2 - d ^ 2) * r = L0) by (unfold r; field; lra).
  assert (L1 : 0 <= L0). { pose proof (nrm_pos (w s) (wy s)). pose proof (Rabs_pos (w s)). unfold L0. nra. } assert (r0 : 0 <= r) by nra.
  destruct (Req_dec (nrm (w u) (wy u)) 0) as [z | z]; [ apply nrm_zero, z | exfalso ].
  assert (N : forall t, s <= t <= u -> 0 < nrm (w t) (wy t)).
  { intros t Ht. destruct (nrm_pos (w t) (wy t)) as [p | p]; trivial. exfalso. apply z. symmetry in p. destruct (nrm_zero _ _ p) as [p1 p2].
    destruct (stays l phi0 w wy hl M t u) as [q1 q2]; trivial; [ lra | | ]. intros y Hy. specialize (hA y ltac:(lra)). lra.
    rewrite q1, q2. rewrite nrm_line. apply Rabs_R0. }
  assert (F : l * nrm (w u) (wy u) + d * Rabs (w u) + (l ^ 2 - d ^ 2) * u <= L0 + (l ^ 2 - d ^ 2) * s).
  { apply (dini_decr (fun t => l * nrm (w t) (wy t) + d * Rabs (w t) + (l ^ 2 - d ^ 2) * t)); [ lra | | ]; intros t Ht.
    - pose proof (cont_w l phi0 w wy M t ltac:(lra)). pose proof (cont_wy l phi0 w wy M t ltac:(lra)).
      apply (continuity_pt_plus (fun t => l * nrm (w t) (wy t) + d * Rabs (w t)) (fun t => (l ^ 2 - d ^ 2) * t)); [ | cont ].
      apply (continuity_pt_plus (fun t => l * nrm (w t) (wy t)) (fun t => d * Rabs (w t))). cont.
      apply (continuity_pt_mult (fun _ => d) (fun t => Rabs (w t))). cont. apply (continuity_pt_comp w Rabs); trivial. apply Rcontinuity_abs.
    - destruct (law l phi0 w wy hl M t) as (fx & fy & C & _ & _ & X & Y); [ lra | ]. specialize (N t ltac:(lra)). specialize (hA t ltac:(lra)). apply Rabs_le_between in hA.
      set (a := sin (phi0 + t)) in *. destruct (coulomb_slip _ _ _ _ _ hl C) as [E _]. destruct C as [_ P].
      assert (D : forall g, g = 1 \/ g = -1 -> exists r, rder (fun t => l * nrm (w t) (wy t) + g * d * w t + (l ^ 2 - d ^ 2) * t) t r /\
        r * nrm (w t) (wy t) = (a - g * d) * (l * w t + g * d * nrm (w t) (wy t))).
      { intros g hg. eexists. split. rd. lra. set (n := nrm (w t) (wy t)) in *. cbv beta. assert (gg : g * g = 1) by (destruct hg as [-> | ->]; ring).
        match goal with |- ?x * n = _ => replace (x * n) with (l * ((fx * w t + fy * wy t) + a * w t) + g * d * (n * fx) + g * d * a * n + (l ^ 2 - d ^ 2) * n) by (field; lra) end.
        rewrite P, E. replace ((a - g * d) * (l * w t + g * d * n)) with (a * l * w t + a * g * d * n - g * d * l * w t - (g * g) * d ^ 2 * n) by ring. rewrite gg. ring. }
      intros eps he. set (n := nrm (w t) (wy t)) in *. set (G := l * n + d * Rabs (w t) + (l ^ 2 - d ^ 2) * t).
      assert (sg : (0 <= w t /\ Rabs (w t) = w t) \/ (w t < 0 /\ Rabs (w t) = - w t)) by (destruct (Rle_lt_dec 0 (w t)); [ left; rewrite Rabs_pos_eq | right; rewrite Rabs_left ]; auto).
      assert (step : forall g, g = 1 \/ g = -1 -> exists d1, 0 < d1 /\ forall y, 0 < y < d1 -> l * nrm (w (t + y)) (wy (t + y)) + g * d * w (t + y) + (l ^ 2 - d ^ 2) * (t + y) <= G + eps * y).
      { intros g hg. destruct (D g hg) as (r1 & D1 & E1). apply (below_step _ _ _ G D1); trivial; fold n.
        - unfold G. destruct hg as [-> | ->]; destruct sg as [[? ->] | [? ->]]; nra.
        - unfold G. intros K. apply Rnot_lt_le. intros q. assert (q1 : 0 < r1 * n) by nra. rewrite E1 in q1.
          assert (0 <= g * d * w t) by (destruct hg as [-> | ->]; destruct sg as [[? s2] | [? s2]]; rewrite s2 in K; nra).
          assert (k1 : 0 <= l * (g * w t) + d * n).
          { destruct (Req_dec d 0) as [z0 | z0]; [ rewrite z0 in *; assert (a = 0) as e0 by lra; rewrite e0 in q1; lra | ]. assert (0 <= g * w t) by nra. nra. }
          destruct hg as [-> | ->]; [ assert (0 <= (d - a) * (l * (1 * w t) + d * n)) | assert (0 <= (d + a) * (l * (-1 * w t) + d * n)) ]; try (apply Rmult_le_pos; lra); lra. }
      destruct (step 1 ltac:(auto)) as (d1 & p1 & S1). destruct (step (-1) ltac:(auto)) as (d2 & p2 & S2).
      exists (Rmin d1 d2). split. apply Rmin_pos; trivial. intros y hy. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). specialize (S1 y ltac:(lra)). specialize (S2 y ltac:(lra)).
      fold n. fold G. unfold Rabs at 1. destruct (Rcase_abs (w (t + y))); lra. }
  pose proof (N u ltac:(lra)). pose proof (Rabs_pos (w u)). assert (0 < l * nrm (w u) (wy u)) by nra. assert (0 <= d * Rabs (w u)) by nra. nra.
Qed.
End Stop.
