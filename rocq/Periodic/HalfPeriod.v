(* Functions in pieces; and what half a period that ends with the opposite of its beginning, or a whole one that ends
   where it began, becomes when it is repeated for ever: a motion for all times. *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
From Slipbook Require Export Analysis.
Open Scope R_scope.


Definition sg (n : Z) : R := if Z.even n then 1 else -1.
Lemma sg_succ n : sg (n + 1) = - sg n.
Proof. unfold sg. rewrite Z.add_1_r, Z.even_succ, <- Z.negb_even. destruct (Z.even n); simpl; lra. Qed.
Lemma sg_cases n : sg n = 1 \/ sg n = -1. Proof. unfold sg. destruct (Z.even n); auto. Qed.

(* ---- tiles: on each span of length T the function F is a tile, which ends with what the next begins with ---- *)
Section Tiles.
Variable T : R.
Hypothesis hT : 0 < T.
Definition floor t := Int_part (t / T).
Lemma floor_spec t n : IZR n * T <= t < (IZR n + 1) * T <-> floor t = n.
Proof.
  unfold floor. destruct (base_Int_part (t / T)) as [h1 h2]. set (m := Int_part (t / T)) in *.
  assert (e : t = t / T * T) by (field; lra). split.
  - intros H. assert (IZR n <= t / T < IZR n + 1) by (rewrite e in H; split; [ apply (Rmult_le_reg_r T) | apply (Rmult_lt_reg_r T) ]; lra).
    apply Z.le_antisymm; apply Z.lt_succ_r; apply lt_IZR; rewrite succ_IZR; lra.
  - intros <-. assert (IZR m * T <= t / T * T) by (apply Rmult_le_compat_r; lra).
    assert (t / T * T < (IZR m + 1) * T) by (apply Rmult_lt_compat_r; lra). lra.
Qed.
Lemma tiles_cont F (G : Z -> R -> R) t : (forall n s, IZR n * T <= s < (IZR n + 1) * T -> F s = G n (s - IZR n * T)) ->
  (forall n s, 0 <= s <= T -> continuity_pt (G n) s) -> (forall n, G n T = G (n + 1)%Z 0) -> continuity_pt F t.
Proof.
  intros on c e. pose proof (proj2 (floor_spec t (floor t)) eq_refl) as H. set (n := floor t) in *.
  assert (C : forall m, 0 <= t - IZR m * T <= T -> continuity_pt (fun s => G m (s - IZR m * T)) t) by (intros; now apply cont_shift, c).
  destruct (Req_dec t (IZR n * T)) as [q | q].
  - apply (cont_glue F (fun s => G (n - 1)%Z (s - IZR (n - 1) * T)) (fun s => G n (s - IZR n * T)) t T); trivial.
    + intros s Hs. destruct (Req_dec s t) as [-> | k]; [ | apply on; rewrite minus_IZR; lra ].
      rewrite (on n), minus_IZR by lra. replace (t - IZR n * T) with 0 by lra. replace (t - (IZR n - 1) * T) with T by lra. rewrite e. f_equal. lia.
    + intros s Hs. apply on. lra.
    + apply C. rewrite minus_IZR. lra.
    + apply C. lra.
  - set (d := Rmin (t - IZR n * T) ((IZR n + 1) * T - t)). assert (0 < d) by (apply Rmin_pos; lra).
    assert (d <= t - IZR n * T /\ d <= (IZR n + 1) * T - t) by (split; [ apply Rmin_l | apply Rmin_r ]).
    apply (cont_glue F (fun s => G n (s - IZR n * T)) (fun s => G n (s - IZR n * T)) t d); trivial; try (apply C; lra); intros s Hs; apply on; lra.
Qed.
Lemma tiles_rder F (g : R -> R) n t l : (forall s, IZR n * T <= s < (IZR n + 1) * T -> F s = g (s - IZR n * T)) -> IZR n * T <= t < (IZR n + 1) * T ->
  rder g (t - IZR n * T) l -> rder F t l.
Proof.
  intros on H R. apply (rder_near F (fun s => g (s - IZR n * T)) t _ ((IZR n + 1) * T - t)); [ lra | intros s Hs; symmetry; apply on; lra |
  now apply rder_shift ].
Qed.
Lemma shift_Z (b : R -> R) : (forall t, b (t + T) = b t) -> forall n t, b (t - IZR n * T) = b t.
Proof.
  intros hb n t.
  assert (P : forall k : nat, forall t, b (t + INR k * T) = b t).
  { induction k as [ | k IH ]; intros u. f_equal. simpl. ring. rewrite S_INR. replace (u + (INR k + 1) * T) with (u + INR k * T + T) by ring.
    rewrite hb. apply IH. }
  destruct (Z_le_dec 0 n) as [q | q].
  - rewrite <- (P (Z.to_nat n) (t - IZR n * T)). f_equal. rewrite INR_IZR_INZ, Z2Nat.id by lia. ring.
  - rewrite <- (P (Z.to_nat (- n)) t). f_equal. rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia. ring.
Qed.
End Tiles.

Lemma per_spec p T (hT : 0 < T) t : exists n, p + IZR n * T <= t < p + (IZR n + 1) * T.
Proof. exists (floor T (t - p)). pose proof (proj2 (floor_spec T hT (t - p) _) eq_refl). lra. Qed.
(* g on [p, p + T), repeated *)
Definition per (p T : R) (g : R -> R) t := g (t - IZR (floor T (t - p)) * T).
Lemma per_on p T g (hT : 0 < T) n t : p + IZR n * T <= t < p + (IZR n + 1) * T -> per p T g t = g (t - IZR n * T).
Proof. intros H. unfold per. replace (floor T (t - p)) with n; trivial. symmetry. apply floor_spec; trivial. lra. Qed.
Lemma per_per p T g (hT : 0 < T) t : per p T g (t + T) = per p T g t.
Proof.
  destruct (per_spec p T hT t) as [n Hn]. rewrite (per_on p T g hT n t Hn), (per_on p T g hT (n + 1) (t + T)) by (rewrite plus_IZR; lra).
  f_equal. rewrite plus_IZR. ring.
Qed.
(* g on [0, T), then - g, and so on *)
Definition ext (T : R) (g : R -> R) t := sg (floor T t) * g (t - IZR (floor T t) * T).
Lemma ext_on T g (hT : 0 < T) n t : IZR n * T <= t < (IZR n + 1) * T -> ext T g t = sg n * g (t - IZR n * T).
Proof. intros H. apply floor_spec in H; trivial. unfold ext. now rewrite H. Qed.
Lemma ext_anti T g : 0 < T -> forall t, ext T g (t + T) = - ext T g t.
Proof.
  intros hT t. pose proof (proj2 (floor_spec T hT t (floor T t)) eq_refl) as H. set (n := floor T t) in *.
  rewrite (ext_on T g hT n t H), (ext_on T g hT (n + 1) (t + T)) by (rewrite plus_IZR; lra).
  rewrite sg_succ, plus_IZR. replace (t + T - (IZR n + 1) * T) with (t - IZR n * T) by ring. ring.
Qed.
Lemma ext_first T g t : 0 <= t < T -> ext T g t = g t.
Proof. intros H. rewrite (ext_on T g ltac:(lra) 0) by (simpl; lra). unfold sg; simpl. rewrite Rmult_1_l. f_equal. ring. Qed.

Section Half.
Variables (k T : R) (a g : R -> R).
Hypothesis hT : 0 < T.
Hypothesis ha : forall t, a (t + T) = - a t.
Hypothesis hg : g T = - g 0.
Hypothesis cg : forall t, 0 <= t <= T -> continuity_pt g t.
Hypothesis lg : forall t, 0 <= t < T -> exists f, coulomb k (g t) 0 f 0 /\ rder g t (f - a t).
Lemma a_shift t n : a t = sg n * a (t - IZR n * T).
Proof.
  assert (D : forall t, a (t + 2 * T) = a t) by (intros s; replace (s + 2 * T) with (s + T + T) by ring; rewrite !ha; ring).
  destruct (Z.Even_or_Odd n) as [[m ->] | [m ->]].
  - rewrite <- (shift_Z (2 * T) a D m t), mult_IZR. unfold sg. rewrite Z.even_mul. simpl. rewrite Rmult_1_l. f_equal. ring.
  - rewrite sg_succ, <- (shift_Z (2 * T) a D m t), plus_IZR, mult_IZR. unfold sg. rewrite Z.even_mul. simpl.
    replace (t - IZR m * (2 * T)) with (t - (2 * IZR m + 1) * T + T) by ring. rewrite ha. ring.
Qed.
(* from any phase p of the drive on *)
Theorem half_period_from p : motion k (fun t => a (p + t)) (fun _ => 0) (fun t => ext T g (p + t)) (fun _ => 0).
Proof.
  split; [ intros t _; apply cont_phase | intros; cont | intros t _; set (u := p + t) ].
  - apply (tiles_cont T hT _ (fun n s => sg n * g s)); [ intros; now apply ext_on | | intros n; rewrite hg, sg_succ; ring ].
    intros n s Hs. apply (continuity_pt_mult (fun _ => sg n)); [ cont | now apply cg ].
  - pose proof (proj2 (floor_spec T hT u (floor T u)) eq_refl) as H. set (n := floor T u) in *.
    destruct (lg (u - IZR n * T)) as (f & [B P] & D); [ lra | ]. exists (sg n * f), 0. repeat split.
    + destruct (sg_cases n) as [-> | ->]; nra.
    + rewrite (ext_on T g hT n) by lra. destruct (sg_cases n) as [-> | ->].
      * rewrite !Rmult_1_l. exact P.
      * replace (nrm (-1 * g (u - IZR n * T)) 0) with (nrm (g (u - IZR n * T)) 0) by (unfold nrm; f_equal; ring). lra.
    + apply (rder_phase (ext T g)). apply (tiles_rder T (ext T g) (fun s => sg n * g s) n); [ intros; now apply ext_on | trivial | ].
      rewrite (a_shift u n). eapply rder_eq. apply (rder_mult (fun _ => sg n)). rd. exact D. ring.
    + eapply rder_eq. rd. ring.
Qed.
Theorem half_period : motion k a (fun _ => 0) (ext T g) (fun _ => 0).
Proof.
  destruct (half_period_from 0) as [c d L]. split; trivial; intros t Ht.
  - apply (continuity_pt_ext (fun t => ext T g (0 + t))); [ intros; f_equal; ring | now apply c ].
  - destruct (L t Ht) as (f & f' & C & X & Y). exists f, f'. rewrite Rplus_0_l in *. split; [ trivial | split; trivial ].
    apply (rder_near _ (fun t => ext T g (0 + t)) _ _ 1); [ lra | intros; f_equal; ring | trivial ].
Qed.
End Half.
