(* (90) to (92), (100), (101), (107) to (109), (113) to (115) for every motion while it slips *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Turntable.
Open Scope R_scope.

Section Rates.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis N : nrm (u t) (w t) <> 0.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).

Lemma rder_inv f s l : rder f s l -> f s <> 0 -> rder (fun r => / f r) s (- l / f s ^ 2).
Proof. intros H K. eapply rder_eq. apply (rder_comp f Rinv s l (- / f s ^ 2) H). auto_derive; trivial. field; trivial. field; trivial. Qed.
Ltac rates := destruct (slip x y u w S t ht N) as (X & Y & U & W); pose proof (nrm_sq (u t) (w t)) as e.
Lemma dp : rder (fun t => p t) t (xi t - 1).
Proof. exact (eq99 x y u w S t ht N). Qed.
Theorem eq101 : rder (fun t => xi t) t ((p t + ell t) ^ 2 / p t).
Proof.
  rates. pose proof (rder_inv _ _ _ dp N) as I. eapply rder_eq. apply (rder_mult (fun t => x t * u t + y t * w t) (fun t => / p t)); [ rd | exact I ].
  set (n := p t) in *. inR. field_simplify_eq; [ | trivial ]. ring [e].
Qed.
Theorem eq100 : rder (fun t => ell t) t (- xi t * (2 * p t + ell t) / p t).
Proof.
  rates. pose proof (rder_inv _ _ _ dp N) as I. eapply rder_eq. apply (rder_mult (fun t => x t * w t - y t * u t) (fun t => / p t)); [ rd | exact I ].
  set (n := p t) in *. inR. field_simplify_eq; [ | trivial ]. replace (w t ^ 2) with (n ^ 2 - u t ^ 2) by lra. ring.
Qed.
(* (107), (108) with the angle psi from the velocity to the position *)
Theorem eq108 psi : rho t <> 0 -> x t * u t + y t * w t = rho t * p t * cos psi -> rder (fun t => rho t) t (p t * cos psi).
Proof.
  intros K E. rates. eapply rder_eq. rd. exact K. rewrite E. field. exact K.
Qed.
Theorem eq107 psi : x t * u t + y t * w t = rho t * p t * cos psi -> rder (fun t => p t) t (rho t * cos psi - 1).
Proof. intros E. eapply rder_eq. apply dp. rewrite E. field. exact N. Qed.
(* (113): A = sqrt (rho^2 - p^2), sinh alpha = p / A *)
Theorem eq113 : 0 < x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2) ->
  rder (fun t => sqrt (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2))) t (p t / sqrt (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2))).
Proof.
  intros K. rates. set (A := sqrt _). assert (a : 0 < A) by (apply sqrt_lt_R0; exact K).
  eapply rder_eq. apply (rder_comp (fun t => x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)) sqrt); [ rd | apply is_derive_Reals, derivable_pt_lim_sqrt; exact K ].
  cbv beta. fold A. simpl. set (n := p t) in *. inR. field_simplify_eq; [ | lra ]. replace (w t ^ 2) with (n ^ 2 - u t ^ 2) by lra. ring.
Qed.
End Rates.
