(* Section 4: rest on the turntable, and what becomes of a motion. Units: mu g = Omega = 1, so that every number here has no dimension. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas TableLaws Sphere Fate Picard TableMotions Thin.
Open Scope R_scope.

Ltac emptied T := lazymatch T with
  | forall x : ?A, @?B x => constr:(forall x : A, ltac:(let b := eval cbv beta in (B x) in let r := emptied b in exact r))
  | _ => constr:(False) end.
Ltac occurs t := let T := type of t in let r := emptied T in exact (~ r).

Lemma within a b : nrm a b <= eq139_largest_sigma <-> a ^ 2 + b ^ 2 <= 1.
Proof. unfold eq139_largest_sigma. pose proof (nrm_sq a b). pose proof (nrm_pos a b). split; nra. Qed.

(* (139): rest at a place is a motion exactly where its distance from the axis is at most 1 *)
Theorem eq_139 a b : spin (fun _ => a) (fun _ => b) (fun _ => 0) (fun _ => 0) <-> nrm a b <= eq139_largest_sigma.
Proof. rewrite within. apply rest_radius. Qed.

(* Who is at rest for a while is at a distance of at most 1; and who has no speed there stays for ever. *)
Theorem s4_rest_radius x y u w (S : spin x y u w) :
  (forall s d, 0 <= s -> 0 < d -> (forall t, s <= t < s + d -> nrm (u t) (w t) = 0) -> nrm (x s) (y s) <= eq139_largest_sigma) /\
  (forall s t, 0 <= s <= t -> nrm (u s) (w s) = 0 -> nrm (x s) (y s) <= eq139_largest_sigma -> x t = x s /\ y t = y s /\ u t = 0 /\ w t = 0).
Proof.
  split.
  - intros s d Hs Hd K. apply within. exact (table_rest_needs x y u w S s d Hs Hd K).
  - intros s t Hs z K. apply (table_rest_lasts x y u w S s t Hs z). now apply within.
Qed.
Lemma s4_rest_radius__occurs : ltac:(occurs s4_rest_radius).
Proof. intros H. destruct (table_exists 2 0 1 0) as (x & y & u & w & S & _). exact (H x y u w S). Qed.

(* Every motion comes to rest, goes farther than any distance for good, or creeps towards a place of rho = 1 for ever. Those that neither rest nor
   escape start from a set of no volume. *)
Theorem s4_dichotomy :
  (forall x y u w, spin x y u w -> (exists s, s <= eq139_largest_sigma /\ rests_at s x y u w) \/ escapes x y \/ creeps x y u w) /\
  no_volume (fun z => exists x y u w, spin x y u w /\ x 0 = z px /\ y 0 = z py /\ u 0 = z pu /\ w 0 = z pw /\
    ~ (exists s, rests_at s x y u w) /\ ~ escapes x y).
Proof.
  split. exact fates. intros N eps HN He. destruct (edge_thin N eps HN He) as (l & h & h0 & small & K). exists l, h. split; trivial. split; trivial.
  intros z (x & y & u & w & S & a & b & c & d & no_rest & no_escape) Hz. apply K; trivial. exists x, y, u, w. do 5 (split; trivial).
  destruct (fates x y u w S) as [(s & _ & r) | [e | c']]; [ elim no_rest; eauto | now elim no_escape | now right ].
Qed.
