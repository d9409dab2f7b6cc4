(* 2.3: the mean theorem for a continuous periodic drive along a line, with the integral; and for the sine *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Reached Dini AcrossStop Mean.
Open Scope R_scope.

Section Periodic.
Variables (k T : R) (h vx vy : R -> R).
Hypothesis hk : 0 <= k.
Hypothesis hT : 0 < T.
Hypothesis ch : forall t, continuity_pt h t.
Hypothesis ph : forall t, h (t + T) = h t.
Hypothesis hm : RInt (fun s => Rabs (h s)) 0 T < k * T.
Hypothesis M : motion k (fun t => - h t) (fun _ => 0) vx vy.
Definition total t := RInt (fun s => Rabs (h s)) 0 t.
Lemma ca t : continuity_pt (fun s => Rabs (h s)) t.
Proof. apply (continuity_pt_comp h Rabs). apply ch. apply Rcontinuity_abs. Qed.
Lemma total_der t : is_derive total t (Rabs (h t)).
Proof.
  assert (c : forall z, continuous (fun s => Rabs (h s)) z) by (intros z; apply continuity_pt_filterlim, ca).
  apply (is_derive_RInt (fun s => Rabs (h s)) total 0 t); [ | apply c ].
  exists (mkposreal 1 Rlt_0_1). intros y _. exact (RInt_correct (fun s => Rabs (h s)) 0 y (ex_RInt_continuous (fun s => Rabs (h s)) 0 y (fun z _ => c z))).
Qed.
Lemma pull_is t : nrm (- h t) 0 = Rabs (h t).
Proof. unfold nrm. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. ring. Qed.
Theorem rest_is_certain_periodic t : nrm (vx 0) (vy 0) / (k - RInt (fun s => Rabs (h s)) 0 T / T) + T <= t ->
  exists s d, t <= s <= t + T /\ 0 < d /\ forall u, s <= u <= s + d -> vx u = 0 /\ vy u = 0.
Proof.
  assert (C : forall t, continuity_pt total t) by (intros s; apply derivable_continuous_pt; exists (Rabs (h s)); apply is_derive_Reals, total_der).
  apply (rest_is_certain k (fun t => - h t) (fun _ => 0) vx vy hk M T (RInt (fun s => Rabs (h s)) 0 T) total); trivial; try (intros; apply C).
  - intros s _. rewrite pull_is. apply rder_of, total_der.
  - intros s hs. enough (total (s + T) - total s = total (0 + T) - total 0).
    { rewrite Rplus_0_l in H. unfold total in *. rewrite (RInt_point 0) in H. change zero with 0 in H. lra. }
    apply (rder_const (fun s => total (s + T) - total s)); trivial; intros y Hy.
    + apply (continuity_pt_minus (fun s => total (s + T)) total). apply (continuity_pt_comp (fun s => s + T) total). cont. apply C. apply C.
    + eapply rder_eq. apply (rder_minus (fun s => total (s + T)) total). apply rder_of. apply (is_derive_comp total (fun s => s + T)). apply total_der. auto_derive; trivial. apply rder_of, total_der.
      rewrite ph. change scal with Rmult. ring.
  - intros s _ e he. destruct (ca s e he) as (d & d0 & D). exists d. split; trivial. intros y Hy. rewrite !pull_is. destruct (Req_dec s y) as [<- | ne].
    + rewrite Rminus_diag_eq, Rabs_R0; trivial.
    + apply D. split. split; [ exact I | trivial ]. simpl. unfold R_dist. apply Rabs_def1; lra.
Qed.
End Periodic.
