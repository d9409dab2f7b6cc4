(* (104), (106): work and energy on the turntable, with dimensions; rest included *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion.
Open Scope R_scope.

(* (86): the rate of turning Om, mu g = k *)
Record turntable (Om k : R) (x y u w : R -> R) : Prop := {
  t_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt u t /\ continuity_pt w t;
  t_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, coulomb k (u t) (w t) fx fy /\
            rder u t (Om ^ 2 * x t + 2 * Om * w t + fx) /\ rder w t (Om ^ 2 * y t - 2 * Om * u t + fy) }.
Section Work.
Variables (m g mu Om : R) (x y u w s : R -> R).
Hypothesis S : turntable Om (mu * g) x y u w.
(* (105): s is the length of the path *)
Hypothesis cs : forall t, 0 < t -> continuity_pt s t.
Hypothesis ds : forall t, 0 <= t -> rder s t (nrm (u t) (w t)).
(* the left side of (106) with the factor c for the last term; the print has c = m g *)
Definition eq106 c t := m / 2 * (u t ^ 2 + w t ^ 2) - m * Om ^ 2 / 2 * (x t ^ 2 + y t ^ 2) + c * s t.

Theorem eq106_right t : 0 <= t -> eq106 (m * (mu * g)) t = eq106 (m * (mu * g)) 0.
Proof.
  intros Ht. unfold eq106. apply (rder_const (fun t => m / 2 * (u t ^ 2 + w t ^ 2) - m * Om ^ 2 / 2 * (x t ^ 2 + y t ^ 2) + m * (mu * g) * s t)); trivial; intros r Hr.
  - destruct (t_c _ _ _ _ _ _ S r ltac:(lra)) as (c1 & c2 & c3 & c4). pose proof (cs r ltac:(lra)). cont.
  - destruct (t_law _ _ _ _ _ _ S r ltac:(lra)) as (X & Y & fx & fy & [B P] & U & W). pose proof (ds r ltac:(lra)) as D.
    eapply rder_eq. rd. simpl. set (n := nrm _ _) in *. transitivity (m * (fx * u r + fy * w r + mu * g * n)). field. rewrite P. ring.
Qed.
(* the print: constant only where mu = 1 or nothing has moved *)
Theorem eq106_iff t : 0 <= t -> m <> 0 -> g <> 0 -> (eq106 (m * g) t = eq106 (m * g) 0 <-> mu = 1 \/ s t = s 0).
Proof.
  intros Ht hm hg. pose proof (eq106_right t Ht) as E. unfold eq106 in *.
  assert (K : forall c, m / 2 * (u t ^ 2 + w t ^ 2) - m * Om ^ 2 / 2 * (x t ^ 2 + y t ^ 2) + c * s t - (m / 2 * (u 0 ^ 2 + w 0 ^ 2) - m * Om ^ 2 / 2 * (x 0 ^ 2 + y 0 ^ 2) + c * s 0)
     = (c - m * (mu * g)) * (s t - s 0)) by (intros; lra).
  specialize (K (m * g)). replace ((m * g - m * (mu * g)) * (s t - s 0)) with (m * g * ((1 - mu) * (s t - s 0))) in K by ring. split.
  - intros Q. assert (Z : m * g * ((1 - mu) * (s t - s 0)) = 0) by lra. apply Rmult_integral in Z as [Z | Z].
    + apply Rmult_integral in Z. tauto.
    + apply Rmult_integral in Z as [Z | Z]; [ left | right ]; lra.
  - intros Q. assert (Z : (1 - mu) * (s t - s 0) = 0) by (destruct Q as [-> | ->]; ring). rewrite Z in K. lra.
Qed.
End Work.
