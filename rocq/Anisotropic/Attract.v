(* 2.2, 2.4: a motion that reverses at once, without rest, attracts every other *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces Periodic Aniso.
Open Scope R_scope.

Lemma lim_zero (f : R -> R) : (forall e, 0 < e -> exists t1, forall t, t1 <= t -> Rabs (f t) <= e) -> is_lim f p_infty 0.
Proof.
  intros H. apply is_lim_spec. intros eps. destruct (H (eps / 2)) as [t1 h]. apply is_pos_div_2. exists t1. intros t Ht.
  rewrite Rminus_0_r. specialize (h t ltac:(lra)). pose proof (cond_pos eps). lra.
Qed.

(* one goes forward while the other goes back: friction brings them together at the rate l + m *)
Lemma opposite l m a t0 w u p q : line l m a t0 w -> line l m a t0 u -> t0 <= p <= q -> (forall y, p <= y <= q -> 0 < w y /\ u y < 0) ->
  (w q - u q) + (l + m) * (q - p) <= w p - u p.
Proof.
  intros [cw Lw] [cu Lu] H S. enough ((w q - u q) + (l + m) * q <= (w p - u p) + (l + m) * p) by lra.
  apply (rder_decr (fun t => (w t - u t) + (l + m) * t)); [ lra | | ]; intros t Ht.
  - cont; [ apply cw | apply cu ]; lra.
  - destruct (Lw t) as (f & (_ & F & _) & X); [ lra | ]. destruct (Lu t) as (g & (_ & _ & G) & Y); [ lra | ]. destruct (S t) as [s1 s2]; [ lra | ].
    eexists. split. rd. rewrite F, G by trivial. lra.
Qed.
Lemma line_lipschitz l m a t0 w B x y : 0 <= l -> 0 <= m -> (forall t, Rabs (a t) <= B) -> line l m a t0 w -> t0 <= x <= y -> 
  Rabs (w y - w x) <= (B + l + m) * (y - x).
Proof.
  intros hl hm hB [c L] H. apply Rabs_le. 
  enough (w y - (B + l + m) * y <= w x - (B + l + m) * x /\ - w y - (B + l + m) * y <= - w x - (B + l + m) * x) by lra.
  split; [ apply (rder_decr (fun t => w t - (B + l + m) * t)) | apply (rder_decr (fun t => - w t - (B + l + m) * t)) ]; try lra; intros t Ht; try (cont; apply c; lra);
    destruct (L t) as (f & (F & _) & X); try lra; (eexists; split; [ rd | ]); specialize (hB t); apply Rabs_le_between in hB; lra.
Qed.

Section Line.
Variables (l m B T z d : R) (a W : R -> R).
Hypothesis hl : 0 < l.
Hypothesis hm : 0 < m.
Hypothesis hT : 0 < T.
Hypothesis hB : forall t, Rabs (a t) <= B.
Hypothesis HW : forall t0, line l m a t0 W.
Hypothesis hW : forall t, W (t + T) = W t.
Hypothesis hd : 0 < d.
Hypothesis zero : W z = 0.
Hypothesis before : forall t, z - d < t < z -> W t < 0.
Hypothesis after : forall t, z < t < z + d -> 0 < W t.
Theorem line_attracts t0 w : line l m a t0 w -> is_lim (fun t => w t - W t) p_infty 0.
Proof.
  intros Hw. apply lim_zero. intros e he. set (L := B + l + m). assert (B0 : 0 <= B) by (pose proof (hB 0); pose proof (Rabs_pos (a 0)); lra).
  assert (Lp : 0 < L) by (unfold L; lra). set (h := Rmin (d / 2) (Rmin (T / 2) (e / (2 * L)))).
  assert (hh : 0 < h /\ h <= d / 2 /\ h <= T / 2 /\ L * h <= e / 2).
  { assert (0 < e / (2 * L)) by (apply Rdiv_lt_0_compat; lra). pose proof (Rmin_l (d / 2) (Rmin (T / 2) (e / (2 * L)))). pose proof (Rmin_r (d / 2) (Rmin (T / 2) (e / (2 * L)))).
    pose proof (Rmin_l (T / 2) (e / (2 * L))). pose proof (Rmin_r (T / 2) (e / (2 * L))). fold h in H0, H1. split; [ unfold h; repeat apply Rmin_pos; lra | ]. repeat split; try lra.
    replace (e / 2) with (L * (e / (2 * L))) by (field; lra). apply Rmult_le_compat_l; lra. }
  clearbody h. 
  assert (C : forall s t, t0 <= s <= t -> Rabs (w t - W t) <= Rabs (w s - W s)) by (apply (line_contraction l m a t0); auto).
  destruct (drain (fun t => Rabs (w t - W t)) t0 (2 * T) ((l + m) * (h / 2)) e) as (t1 & _ & Ht1); try lra; trivial.
  - apply Rmult_lt_0_compat; lra.
  - intros; apply Rabs_pos.
  - intros t Ht. destruct (per_spec z T hT (t + T + h)) as [n Hn]. set (x := z + IZR n * T). assert (x1 : t <= x - h /\ x + h <= t + 2 * T) by (unfold x; lra).
    assert (on : forall y, W (y - IZR n * T) = W y) by (intros; apply shift_Z; trivial).
    assert (Wx : W x = 0) by (rewrite <- on; unfold x; replace (z + IZR n * T - IZR n * T) with z by ring; trivial).
    assert (Wb : forall y, x - d < y < x -> W y < 0) by (intros y Hy; rewrite <- on; apply before; unfold x in *; lra).
    assert (Wa : forall y, x < y < x + d -> 0 < W y) by (intros y Hy; rewrite <- on; apply after; unfold x in *; lra).
    destruct (Rle_lt_dec (Rabs (w (t + 2 * T) - W (t + 2 * T))) e) as [k | k]; [ left; trivial | right ].
    assert (K : e < Rabs (w x)) by (pose proof (C x (t + 2 * T) ltac:(lra)) as K; rewrite Wx, Rminus_0_r in K; lra). 
    destruct (Rle_lt_dec 0 (w x)) as [s | s].
    + rewrite Rabs_right in K by lra. apply Rle_trans with (Rabs (w (x - h / 2) - W (x - h / 2))); [ apply C; lra | ].
      assert (P : forall y, x - h <= y <= x - h / 2 -> 0 < w y /\ W y < 0).
      { intros y Hy. split; [ | apply Wb; lra ]. pose proof (line_lipschitz l m a t0 w B y x ltac:(lra) ltac:(lra) hB Hw ltac:(lra)) as Q. fold L in Q.
        apply Rabs_le_between in Q. assert (L * (x - y) <= L * h) by (apply Rmult_le_compat_l; lra). lra. }
      pose proof (opposite l m a t0 w W (x - h) (x - h / 2) Hw (HW t0) ltac:(lra) P). destruct (P (x - h) ltac:(lra)). destruct (P (x - h / 2) ltac:(lra)).
      pose proof (C t (x - h) ltac:(lra)) as D. rewrite Rabs_right in D by lra. rewrite Rabs_right by lra. lra.
    + rewrite Rabs_left in K by lra. apply Rle_trans with (Rabs (w (x + h) - W (x + h))); [ apply C; lra | ].
      assert (P : forall y, x + h / 2 <= y <= x + h -> 0 < W y /\ w y < 0).
      { intros y Hy. split; [ apply Wa; lra | ]. pose proof (line_lipschitz l m a t0 w B x y ltac:(lra) ltac:(lra) hB Hw ltac:(lra)) as Q. fold L in Q.
        apply Rabs_le_between in Q. assert (L * (y - x) <= L * h) by (apply Rmult_le_compat_l; lra). lra. }
      pose proof (opposite l m a t0 W w (x + h / 2) (x + h) (HW t0) Hw ltac:(lra) P). destruct (P (x + h / 2) ltac:(lra)). destruct (P (x + h) ltac:(lra)).
      pose proof (C t (x + h / 2) ltac:(lra)) as D. rewrite Rabs_left in D by lra. rewrite Rabs_left by lra. lra.
  - exists t1. intros t Ht. apply Ht1, Ht.
Qed.
End Line.
