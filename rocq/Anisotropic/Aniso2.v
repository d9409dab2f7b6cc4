(* 3.4, for section 3's chapter: the slip of a sphere that moves and turns along the drive obeys the law of 2.4. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion HalfPeriod Line.
From Slipbook Require Export Curves.
Open Scope R_scope.

(* s34-anisotropic, (85): a sphere that moves and turns along the line; F is the friction, o the spin about the other axis *)
Record sphere_line (m J rad l n : R) (a : R -> R) (t0 : R) (v o : R -> R) : Prop := {
  sl_c : forall t, t0 < t -> continuity_pt v t /\ continuity_pt o t;
  sl_law : forall t, t0 <= t -> exists F, dry (m * l) (m * n) (v t - rad * o t) F /\ rder v t (F / m + a t) /\ rder o t (- rad * F / J) }.
Theorem s34_anisotropic m J rad l n a t0 v o : 0 < m -> 0 < J -> sphere_line m J rad l n a t0 v o ->
  let b := 1 + m * rad ^ 2 / J in line (b * l) (b * n) a t0 (fun t => v t - rad * o t).
Proof.
  intros hm hJ [c L] b. assert (b0 : 0 < b). { unfold b. assert (0 <= m * rad ^ 2 / J); [ | lra ]. apply Rmult_le_pos; [ | left; now apply Rinv_0_lt_compat ]. pose proof (pow2_ge_0 rad). nra. }
  assert (bm : 0 < b / m) by (apply Rdiv_lt_0_compat; lra). assert (e : forall x, b * x = b / m * (m * x)) by (intros; field; lra). split.
  - intros t Ht. destruct (c t Ht). cont.
  - intros t Ht. destruct (L t Ht) as (F & ((F1 & F2) & F3 & F4) & X & Y). exists (b / m * F). split.
    + rewrite !e. split; [ split; nra | split; intros k ]. rewrite F3 by trivial; ring. rewrite F4 by trivial; ring.
    + eapply rder_eq. rd. unfold b. field. lra.
Qed.
