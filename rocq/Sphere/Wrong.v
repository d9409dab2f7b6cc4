(* Two prints that are wrong, each with what is right *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion General Constant Angle.
Open Scope R_scope.

(* ---- (75) ---- *)
Definition vec : Type := R * R * R.
Definition add (a b : vec) : vec := let '(a1, a2, a3) := a in let '(b1, b2, b3) := b in (a1 + b1, a2 + b2, a3 + b3).
Definition scale (c : R) (a : vec) : vec := let '(a1, a2, a3) := a in (c * a1, c * a2, c * a3).
Definition cross (a b : vec) : vec := let '(a1, a2, a3) := a in let '(b1, b2, b3) := b in
  (a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1).
Definition ez : vec := (0, 0, 1).
(* (71) in the units of (68) to (70): u = drho/dtau + zeta x (-z) *)
Definition eq71_u (rho' zeta : vec) : vec := add rho' (cross zeta (scale (-1) ez)).
Definition eq75 (zeta3 : R) (u rho' : vec) : vec := add (scale zeta3 ez) (cross ez (add u (scale (-1) rho'))).
Definition eq75_right (zeta3 : R) (u rho' : vec) : vec := add (scale zeta3 ez) (scale (-1) (cross ez (add u (scale (-1) rho')))).

Theorem eq75_right_holds r1 r2 z1 z2 z3 :
  let rho' := (r1, r2, 0) in let zeta := (z1, z2, z3) in zeta = eq75_right z3 (eq71_u rho' zeta) rho'.
Proof. cbn. repeat f_equal; ring. Qed.
(* the print holds for spin about the vertical only *)
Theorem eq75_iff r1 r2 z1 z2 z3 :
  let rho' := (r1, r2, 0) in let zeta := (z1, z2, z3) in zeta = eq75 z3 (eq71_u rho' zeta) rho' <-> z1 = 0 /\ z2 = 0.
Proof. cbn. split. intros E. injection E. intros. lra. intros [-> ->]. repeat f_equal; ring. Qed.

(* ---- (82): the time of (13) with gamma for A; the print has 1 for gamma ---- *)
Definition eq82 (lam u0 th0 th : R) : R :=
  u0 * (lam + cos th0) / (1 - lam ^ 2) * ((lam + cos th) * sin th0 / ((lam + cos th0) * sin th) * Rpower (tan (th / 2) / tan (th0 / 2)) lam - 1).
Definition eq82_right (gamma lam u0 th0 th : R) : R := eq13_time lam gamma u0 th0 th.

Section Sphere.
Variables (gamma lam : R) (ux uy u theta : R -> R) (t : R).
Hypothesis hA : 0 < gamma.
Hypothesis hl : 0 <= lam.
(* (74): b = gamma lam *)
Hypothesis M : motion (gamma * lam) (fun _ => - gamma) (fun _ => 0) ux uy.
Hypothesis ht : 0 < t.
Hypothesis polar : forall s, 0 <= s <= t -> 0 < u s /\ 0 < theta s < PI /\ ux s = u s * cos (theta s) /\ uy s = u s * sin (theta s).
Hypothesis h1 : lam <> 1.
Hypothesis h0 : lam + cos (theta 0) <> 0.

Theorem eq82_right_holds : t = eq82_right gamma lam (u 0) (theta 0) (theta t).
Proof. apply (eq13 gamma lam ux uy u theta t); trivial; lra. Qed.
Theorem eq82_iff : t = eq82 lam (u 0) (theta 0) (theta t) <-> gamma = 1.
Proof.
  pose proof eq82_right_holds as E. assert (1 - lam ^ 2 <> 0) by nra.
  assert (K : eq82 lam (u 0) (theta 0) (theta t) = gamma * eq82_right gamma lam (u 0) (theta 0) (theta t)).
  { unfold eq82, eq82_right, eq13_time. set (X := _ - 1). field. lra. }
  rewrite <- E in K. rewrite K. split; intros; nra.
Qed.
End Sphere.
