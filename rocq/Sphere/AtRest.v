(* A place on the turntable holds a particle at rest just when its distance from the axis is at most mu g / Omega^2. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Turntable.
From Slipbook Require Analysis.
Open Scope R_scope.

Notation rder_unique := Analysis.rder_unique.
Notation rder_zero := Analysis.rder_zero.
(* s4-rest-radius, both ways *)
Theorem rest_radius a b : spin (fun _ => a) (fun _ => b) (fun _ => 0) (fun _ => 0) <-> a ^ 2 + b ^ 2 <= 1.
Proof.
  split.
  - intros S. destruct (s_law _ _ _ _ S 0 (Rle_refl 0)) as (_ & _ & fx & fy & [B _] & U & W).
    pose proof (rder_unique _ _ _ _ U (Analysis.rder_fixed 0 0)). pose proof (rder_unique _ _ _ _ W (Analysis.rder_fixed 0 0)).
    replace a with (- fx) by lra. replace b with (- fy) by lra. nra.
  - intros H. split; [ intros; cont .. | intros t _; split; [ | split ]; try apply Analysis.rder_fixed ].
    exists (- a), (- b). split; [ split; [ nra | rewrite Analysis.nrm_0; ring ] | split; (eapply rder_eq; [ apply Analysis.rder_fixed | ring ]) ].
Qed.
