(* The last stage across the drive: where friction exceeds the drive, what is left of the velocity is lost in a finite time, which is known.
   The greater of l |v| + d w and l |v| - d w falls at the rate l^2 - d^2 (by steps: it need not have a derivative). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Dini Drawn Analysis Steady Shaken.
Open Scope R_scope.

Lemma max_decr f g a b : a <= b -> (forall t, a < t <= b -> continuity_pt f t /\ continuity_pt g t) -> (forall t, a <= t < b -> exists k m,
  rder f t k /\ rder g t m /\ (g t <= f t -> k <= 0) /\ (f t <= g t -> m <= 0)) -> Rmax (f b) (g b) <= Rmax (f a) (g a).
Proof.
  intros hab C D. apply (dini_decr (fun t => Rmax (f t) (g t)) a b hab); [ | ]; intros t ht.
  - destruct (C t ht). apply (continuity_pt_ext (fun t => (f t + g t + Rabs (f t - g t)) / 2)).
    { intros s. unfold Rabs. destruct Rcase_abs; minmax. } unfold Rdiv. cont.
      apply (continuity_pt_comp (fun t => f t - g t) Rabs); [ cont | apply Rcontinuity_abs ].
  - destruct (D t ht) as (k & m & F & G & hk & hm). intros e he.
    destruct (below_step f t k (Rmax (f t) (g t)) F ltac:(minmax) ltac:(intros; apply hk; minmax) e he) as (x & x0 & X).
    destruct (below_step g t m (Rmax (f t) (g t)) G ltac:(minmax) ltac:(intros; apply hm; minmax) e he) as (y & y0 & Y).
    exists (Rmin x y). split; [ now apply Rmin_pos | ]. intros h hh. pose proof (Rmin_l x y). pose proof (Rmin_r x y).
    apply Rmax_lub; [ apply X | apply Y ]; lra.
Qed.
Lemma stops_within l d phi0 w wy s u : 0 <= d < l -> shaken l phi0 w wy -> 0 <= s <= u -> w s = 0 -> l * Rabs (wy s) <= (l ^ 2 - d ^ 2) * (u - s) ->
  (forall t, s <= t <= u -> Rabs (sin (phi0 + t)) <= d) -> w u = 0 /\ wy u = 0.
Proof.
  intros hd M hs w0 hu hA. assert (hl : 0 <= l) by lra. destruct (Req_dec (nrm (w u) (wy u)) 0) as [z | z]; [ apply nrm_zero, z | exfalso ].
  assert (N : forall t, s <= t <= u -> 0 < nrm (w t) (wy t)).
  { intros t Ht. destruct (nrm_pos (w t) (wy t)) as [p | p]; trivial. exfalso. apply z. symmetry in p. destruct (nrm_zero _ _ p) as [p1 p2].
    destruct (stays l phi0 w wy hl M t u) as [-> ->]; trivial; [ lra | | apply nrm_0 ]. intros y Hy. specialize (hA y ltac:(lra)). lra. }
  set (J g t := l * nrm (w t) (wy t) + g * d * w t + (l ^ 2 - d ^ 2) * t).
  assert (F : Rmax (J 1 u) (J (-1) u) <= Rmax (J 1 s) (J (-1) s)).
  { apply max_decr; [ lra | | ]; intros t Ht; [ split; unfold J; conts M | ].
    destruct (law l phi0 w wy hl M t) as (fx & fy & [_ P] & [E _] & _ & X & Y); [ lra | ]. specialize (N t ltac:(lra)). specialize (hA t ltac:(lra)).
    set (n := nrm (w t) (wy t)) in *. set (a := sin (phi0 + t)) in *. apply Rabs_le_between in hA.
    assert (D : forall g, g * g = 1 -> rder (J g) t ((a - g * d) * (l * w t + g * d * n) / n)).
    { intros g gg. unfold J. eapply rder_eq. rd. fold n. lra. fold n. replace (w t * (a + fx) + wy t * fy) with (a * w t - l * n) by lra.
      assert (ef : fx = - l * w t / n) by (rewrite <- E; field; lra). rewrite ef.
      transitivity (((a - g * d) * (l * w t + g * d * n) + (g * g - 1) * d ^ 2 * n) / n); [ field; lra | rewrite gg; f_equal; ring ]. }
    eexists. eexists. split; [ apply D; ring | split; [ apply D; ring | ] ]. unfold J. fold n.
    assert (sgn : forall q, q = 0 \/ 0 <= d -> 0 <= d * q -> d = 0 \/ 0 <= q) by (intros q _ hq; destruct (Req_dec d 0); [ auto | right; nra ]).
    split; intros K; apply Rle_div_l; trivial; assert (0 <= d * n) by nra.
    - destruct (sgn (w t) ltac:(lra) ltac:(lra)) as [d0 | q]; [ replace (a - 1 * d) with 0 by lra;
      lra | assert (0 <= (d - a) * (l * w t + d * n)) by (apply Rmult_le_pos; nra); lra ].
    - destruct (sgn (- w t) ltac:(lra) ltac:(lra)) as [d0 | q]; [ replace (a - -1 * d) with 0 by lra;
      lra | assert (0 <= (a + d) * (l * - w t + d * n)) by (apply Rmult_le_pos; nra); lra ]. }
  unfold J in F. rewrite w0 in F. replace (nrm 0 (wy s)) with (Rabs (wy s)) in F. 2: { rewrite <- nrm_x. unfold nrm. f_equal. ring. }
  assert (0 < l * nrm (w u) (wy u)) by (apply Rmult_lt_0_compat; [ lra | apply N; lra ]). clear - F H hu. minmax.
Qed.
