(* Polynomials in finitely many variables are bounded where the variables are: for residuals whose size is not computed. *)
Require Import Reals Lra Psatz.
Open Scope R_scope.

Definition bnd (f : (nat -> R) -> R) := forall M, 0 <= M -> exists K, 0 < K /\ forall v, (forall i, Rabs (v i) <= M) -> Rabs (f v) <= K.
Lemma bnd_var i : bnd (fun v => v i).
Proof. intros M HM. exists (M + 1). split. lra. intros v Hv. specialize (Hv i). lra. Qed.
Lemma bnd_const c : bnd (fun _ => c).
Proof. intros M HM. exists (Rabs c + 1). pose proof (Rabs_pos c). split. lra. intros. lra. Qed.
Lemma bnd_plus f g : bnd f -> bnd g -> bnd (fun v => f v + g v).
Proof.
  intros F G M HM. destruct (F M HM) as (K & k & H). destruct (G M HM) as (K' & k' & H'). exists (K + K'). split. lra.
  intros v Hv. specialize (H v Hv). specialize (H' v Hv). pose proof (Rabs_triang (f v) (g v)). lra.
Qed.
Lemma bnd_mult f g : bnd f -> bnd g -> bnd (fun v => f v * g v).
Proof.
  intros F G M HM. destruct (F M HM) as (K & k & H). destruct (G M HM) as (K' & k' & H'). exists (K * K'). split. now apply Rmult_lt_0_compat.
  intros v Hv. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
Qed.
Lemma bnd_opp f : bnd f -> bnd (fun v => - f v).
Proof. intros F M HM. destruct (F M HM) as (K & k & H). exists K. split; trivial. intros v Hv. rewrite Rabs_Ropp. auto. Qed.
Lemma bnd_minus f g : bnd f -> bnd g -> bnd (fun v => f v - g v).
Proof. intros F G. apply (bnd_plus f (fun v => - g v)); trivial. now apply bnd_opp. Qed.
Lemma bnd_pow f n : bnd f -> bnd (fun v => f v ^ n).
Proof. intros F. induction n; simpl. apply bnd_const. now apply bnd_mult. Qed.
Ltac bounded := match goal with
  | |- bnd (fun v => @?a v + @?b v) => apply (bnd_plus a b); bounded
  | |- bnd (fun v => @?a v - @?b v) => apply (bnd_minus a b); bounded
  | |- bnd (fun v => @?a v * @?b v) => apply (bnd_mult a b); bounded
  | |- bnd (fun v => - @?a v) => apply (bnd_opp a); bounded
  | |- bnd (fun v => @?a v ^ ?n) => apply (bnd_pow a n); bounded
  | |- bnd (fun v => v ?i) => apply bnd_var
  | |- bnd (fun _ => ?c) => apply bnd_const
  end.
(* the values of the variables, in order *)
Fixpoint vals (l : list R) (i : nat) : R := match l, i with
  | cons r _, O => r
  | cons _ l', S j => vals l' j
  | nil, _ => 0
  end.
Lemma vals_le M l : 0 <= M -> (forall r, List.In r l -> Rabs r <= M) -> forall i, Rabs (vals l i) <= M.
Proof.
  intros HM. induction l as [ | r l IH]; intros H [ | i]; simpl; try (rewrite Rabs_R0; exact HM). apply H. now left. apply IH. intros q Hq. apply H.
  now right.
Qed.
