(* What Analysis.v has under other names. *)
Require Import Reals.
From Slipbook Require Import Motion.
From Slipbook Require Export Analysis.
Open Scope R_scope.

Lemma rder_ext f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> rder g t l -> rder f t l.
Proof. apply rder_near. Qed.
Lemma rder_one f t l m : rder f t l -> rder f t m -> l = m.
Proof. apply rder_unique. Qed.
