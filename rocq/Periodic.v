(* A half period that ends with the opposite of what it began with makes a motion for all times *)
Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Pieces.
Open Scope R_scope.

Lemma rder_near f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> rder g t l -> rder f t l.
Proof.
  intros Hd E [G [H K]]. apply (rder_loc f G t l d); trivial. intros s Hs. rewrite K by lra. apply E, Hs.
Qed.
Lemma rder_shift g c t l : rder g (t - c) l -> rder (fun s => g (s - c)) t l.
Proof.
  intros [G [H K]]. exists (fun s => G (s - c)). split. 2: intros; apply K; lra.
  replace l with (1 * l) by ring. apply (is_derive_comp G (fun s => s - c)). exact H. auto_derive; trivial; try ring.
Qed.
Lemma cont_shift g c t : continuity_pt g (t - c) -> continuity_pt (fun s => g (s - c)) t.
Proof. intros H. apply (continuity_pt_comp (fun s => s - c) g); trivial. cont. Qed.

Definition sg (n : Z) : R := if Z.even n then 1 else -1.
Lemma sg_succ n : sg (n + 1) = - sg n.
Proof. unfold sg. rewrite Z.add_1_r, Z.even_succ, <- Z.negb_even. destruct (Z.even n); simpl; lra. Qed.
Lemma sg_cases n : sg n = 1 \/ sg n = -1. Proof. unfold sg. destruct (Z.even n); auto. Qed.

Section Half.
Variables (k T : R) (a g : R -> R).
Hypothesis hT : 0 < T.
Hypothesis ha : forall t, a (t + T) = - a t.
Hypothesis hg : g T = - g 0.
Hypothesis cg : forall t, 0 <= t <= T -> continuity_pt g t.
Hypothesis lg : forall t, 0 <= t < T -> exists f, coulomb k (g t) 0 f 0 /\ rder g t (f - a t).

Definition floor t := Int_part (t / T).
Definition ext t := sg (floor t) * g (t - IZR (floor t) * T).

Lemma floor_spec t n : IZR n * T <= t < (IZR n + 1) * T <-> floor t = n.
Proof.
  unfold floor. destruct (base_Int_part (t / T)) as [h1 h2]. set (m := Int_part (t / T)) in *.
  assert (e : t = t / T * T) by (field; lra). split.
  - intros H. assert (IZR n <= t / T < IZR n + 1) by (rewrite e in H; split; [ apply (Rmult_le_reg_r T) | apply (Rmult_lt_reg_r T) ]; lra).
    apply Z.le_antisymm; apply Z.lt_succ_r; apply lt_IZR; rewrite succ_IZR; lra.
  - intros <-. assert (IZR m * T <= t / T * T) by (apply Rmult_le_compat_r; lra). assert (t / T * T < (IZR m + 1) * T) by (apply Rmult_lt_compat_r; lra). lra.
Qed.
Lemma a_shift t n : a t = sg n * a (t - IZR n * T).
Proof.
  assert (P : forall m : nat, forall t, a (t + INR m * T) = sg (Z.of_nat m) * a t).
  { induction m as [ | m IH ]; intros u. simpl. rewrite Rmult_0_l, Rplus_0_r. unfold sg; simpl; ring.
    rewrite S_INR, Nat2Z.inj_succ, <- Z.add_1_r, sg_succ. replace (u + (INR m + 1) * T) with (u + INR m * T + T) by ring. rewrite ha, IH. ring. }
  destruct (Z_le_dec 0 n) as [p | p].
  - rewrite <- (Z2Nat.id n p), <- INR_IZR_INZ, <- P. f_equal. ring.
  - assert (q : (0 <= - n)%Z) by lia. rewrite <- (Z.opp_involutive n), <- (Z2Nat.id (- n) q). set (m := Z.to_nat (- n)). rewrite opp_IZR, <- INR_IZR_INZ.
    replace (t - - INR m * T) with (t + INR m * T) by ring. rewrite P. unfold sg. rewrite Z.even_opp. destruct (Z.even (Z.of_nat m)); ring.
Qed.
Lemma ext_on n t : IZR n * T <= t < (IZR n + 1) * T -> ext t = sg n * g (t - IZR n * T).
Proof. intros H. apply floor_spec in H. unfold ext. now rewrite H. Qed.

Theorem half_period : motion k a (fun _ => 0) ext (fun _ => 0).
Proof.
  split.
  - intros t _. pose proof (proj2 (floor_spec t (floor t)) eq_refl) as H. set (n := floor t) in *.
    assert (C : forall m, 0 <= t - IZR m * T <= T -> continuity_pt (fun s => sg m * g (s - IZR m * T)) t).
    { intros m Hm. apply (continuity_pt_mult (fun _ => sg m)). cont. apply cont_shift, cg, Hm. }
    destruct (Req_dec t (IZR n * T)) as [e | ne].
    + apply (cont_glue ext (fun s => sg (n - 1) * g (s - IZR (n - 1) * T)) (fun s => sg n * g (s - IZR n * T)) t T); trivial.
      * intros s Hs. destruct (Req_dec s t) as [-> | k1]. 
        -- rewrite (ext_on n) by lra. rewrite minus_IZR. replace (t - IZR n * T) with 0 by lra. replace (t - (IZR n - 1) * T) with T by lra. rewrite hg.
           replace n with (n - 1 + 1)%Z at 1 by ring. rewrite sg_succ. ring.
        -- apply ext_on. rewrite minus_IZR. lra.
      * intros s Hs. apply ext_on. lra.
      * apply C. rewrite minus_IZR. lra.
      * apply C. lra.
    + apply (cont_glue ext (fun s => sg n * g (s - IZR n * T)) (fun s => sg n * g (s - IZR n * T)) t (Rmin (t - IZR n * T) ((IZR n + 1) * T - t))).
      * apply Rmin_pos; lra.
      * intros s Hs. apply ext_on. pose proof (Rmin_l (t - IZR n * T) ((IZR n + 1) * T - t)). lra.
      * intros s Hs. apply ext_on. pose proof (Rmin_r (t - IZR n * T) ((IZR n + 1) * T - t)). lra.
      * apply C. lra.
      * apply C. lra.
  - intros; cont.
  - intros t _. pose proof (proj2 (floor_spec t (floor t)) eq_refl) as H. set (n := floor t) in *.
    destruct (lg (t - IZR n * T)) as (f & [B P] & D); [ lra | ]. exists (sg n * f), 0. repeat split.
    + destruct (sg_cases n) as [-> | ->]; nra.
    + rewrite (ext_on n) by lra. destruct (sg_cases n) as [-> | ->].
      * rewrite !Rmult_1_l. exact P.
      * replace (nrm (-1 * g (t - IZR n * T)) 0) with (nrm (g (t - IZR n * T)) 0) by (unfold nrm; f_equal; ring). lra.
    + apply (rder_near ext (fun s => sg n * g (s - IZR n * T)) t _ ((IZR n + 1) * T - t)); [ lra | intros s Hs; symmetry; apply ext_on; lra | ].
      rewrite (a_shift t n). eapply rder_eq. apply (rder_mult (fun _ => sg n)). rd. apply rder_shift, D. ring.
    + eapply rder_eq. rd. ring.
Qed.
End Half.
