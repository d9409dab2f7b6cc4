(* (60) from the law of rotation: of a rigid body with one moment of inertia about every axis the spin about the centre is J omega. The mass may be
   spread in any way: all that is used of it is that what polynomials of second degree in the place add up to is linear. *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Analysis.
Open Scope R_scope.

(* mass f: what f adds up to over the body, f (a, b, c) dm; a, b, c are the places on three axes through the centre that turn with the body.
   The centre is that of the mass; the moment is J about each of the three axes, and so about every one.
   «the body has the moment of inertia $J$ about every axis through its centre» *)
Record one_moment (J : R) (mass : (R -> R -> R -> R) -> R) : Prop := {
  linear : forall k1 k2 k3 k4 k5 k6 k7 k8 k9,
    mass (fun a b c => k1 * a ^ 2 + k2 * b ^ 2 + k3 * c ^ 2 + k4 * (a * b) + k5 * (b * c) + k6 * (c * a) + k7 * a + k8 * b + k9 * c) =
    k1 * mass (fun a b c => a ^ 2) + k2 * mass (fun a b c => b ^ 2) + k3 * mass (fun a b c => c ^ 2) + k4 * mass (fun a b c => a * b) +
    k5 * mass (fun a b c => b * c) + k6 * mass (fun a b c => c * a) + k7 * mass (fun a b c => a) + k8 * mass (fun a b c => b) + k9 * mass (fun a b c
        => c);
  centred : mass (fun a b c => a) = 0 /\ mass (fun a b c => b) = 0 /\ mass (fun a b c => c) = 0;
  no_products : mass (fun a b c => a * b) = 0 /\ mass (fun a b c => b * c) = 0 /\ mass (fun a b c => c * a) = 0;
  moments : mass (fun a b c => b ^ 2 + c ^ 2) = J /\ mass (fun a b c => c ^ 2 + a ^ 2) = J /\ mass (fun a b c => a ^ 2 + b ^ 2) = J }.
(* a moment about the centre along one axis: p, q are the coordinates along the two others, fp, fq the components there of a vector per mass *)
Definition moment (mass : (R -> R -> R -> R) -> R) (p q fp fq : R -> R -> R -> R) : R := mass (fun a b c => p a b c * fq a b c - q a b c * fp a b c).
(* (x, y, z) t a b c is where the part (a, b, c) of the body is, from the centre: the body is carried along and turned, as a whole, with the angular
   velocity (ox, oy, oz). «the body turns, as a whole, with the angular velocity $(ox,oy,oz)$» *)
Record rigid (x y z : R -> R -> R -> R -> R) (ox oy oz : R -> R) : Prop := {
  upright : forall t, 0 <= t -> exists a1 a2 a3 b1 b2 b3 c1 c2 c3,
    (a1 ^ 2 + b1 ^ 2 + c1 ^ 2 = 1 /\ a2 ^ 2 + b2 ^ 2 + c2 ^ 2 = 1 /\ a3 ^ 2 + b3 ^ 2 + c3 ^ 2 = 1) /\
    (a1 * a2 + b1 * b2 + c1 * c2 = 0 /\ a2 * a3 + b2 * b3 + c2 * c3 = 0 /\ a3 * a1 + b3 * b1 + c3 * c1 = 0) /\
    forall a b c, x t a b c = a * a1 + b * b1 + c * c1 /\ y t a b c = a * a2 + b * b2 + c * c2 /\ z t a b c = a * a3 + b * b3 + c * c3;
  turning : forall t a b c, 0 <= t -> rder (fun t => x t a b c) t (oy t * z t a b c - oz t * y t a b c) /\
    rder (fun t => y t a b c) t (oz t * x t a b c - ox t * z t a b c) /\ rder (fun t => z t a b c) t (ox t * y t a b c - oy t * x t a b c) }.

Section Body.
Variables (J : R) (mass : (R -> R -> R -> R) -> R).
Hypothesis B : one_moment J mass.
Ltac places := let a := fresh in let b := fresh in let c := fresh in extensionality a; extensionality b; extensionality c.
Lemma polynomial k1 k2 k3 k4 k5 k6 k7 k8 k9 f :
  (fun a b c => k1 * a ^ 2 + k2 * b ^ 2 + k3 * c ^ 2 + k4 * (a * b) + k5 * (b * c) + k6 * (c * a) + k7 * a + k8 * b + k9 * c) = f ->
  mass f = J / 2 * (k1 + k2 + k3).
Proof.
  destruct B as [L (l1 & l2 & l3) (n1 & n2 & n3) (m1 & m2 & m3)]. intros <-. assert (E : forall f g, f = g -> mass f = mass g) by congruence.
  pose proof (L 0 1 1 0 0 0 0 0 0) as e1. pose proof (L 1 0 1 0 0 0 0 0 0) as e2. pose proof (L 1 1 0 0 0 0 0 0 0) as e3.
  rewrite (E _ (fun a b c => b ^ 2 + c ^ 2)), m1 in e1 by (places; ring). rewrite (E _ (fun a b c => c ^ 2 + a ^ 2)), m2 in e2 by (places; ring).
  rewrite (E _ (fun a b c => a ^ 2 + b ^ 2)), m3 in e3 by (places; ring). rewrite L, l1, l2, l3, n1, n2, n3.
  replace (mass (fun a b c => a ^ 2)) with (J / 2) by lra. replace (mass (fun a b c => b ^ 2)) with (J / 2) by lra.
  replace (mass (fun a b c => c ^ 2)) with (J / 2) by lra. field.
Qed.
(* one component of x (x) (omega (x) x), for any three rows at right angles *)
Lemma spin_part a1 b1 c1 a2 b2 c2 a3 b3 c3 o1 o2 o3 : a2 ^ 2 + b2 ^ 2 + c2 ^ 2 = 1 -> a3 ^ 2 + b3 ^ 2 + c3 ^ 2 = 1 ->
  a1 * a2 + b1 * b2 + c1 * c2 = 0 -> a3 * a1 + b3 * b1 + c3 * c1 = 0 ->
  let x a b c := a * a1 + b * b1 + c * c1 in let y a b c := a * a2 + b * b2 + c * c2 in let z a b c := a * a3 + b * b3 + c * c3 in
  mass (fun a b c => y a b c * (o1 * y a b c - o2 * x a b c) - z a b c * (o3 * x a b c - o1 * z a b c)) = J * o1.
Proof.
  intros e2 e3 e12 e31 x y z. pose (q p2 p3 p1 r2 r3 r1 := o1 * (p2 * r2 + p3 * r3) - o2 * ((p1 * r2 + r1 * p2) / 2) - o3 * ((p1 * r3 + r1 * p3) /
    2)).
  rewrite (polynomial (q a2 a3 a1 a2 a3 a1) (q b2 b3 b1 b2 b3 b1) (q c2 c3 c1 c2 c3 c1) (2 * q a2 a3 a1 b2 b3 b1) (2 * q b2 b3 b1 c2 c3 c1) (2 * q c2
      c3 c1 a2 a3 a1) 0 0 0)
    by (places; unfold q, x, y, z; field).
  unfold q. transitivity (J / 2 * (o1 * ((a2 ^ 2 + b2 ^ 2 + c2 ^ 2) + (a3 ^ 2 + b3 ^ 2 + c3 ^ 2)) - o2 * (a1 * a2 + b1 * b2 + c1
    * c2) - o3 * (a3 * a1 + b3 * b1 + c3 * c1))).
  field. rewrite e2, e3, e12, e31. field.
Qed.
Ltac matched Q P := destruct Q as (q1 & q2 & q3); rewrite ?q1, ?q2, ?q3; destruct P as (p1 & p2 & p3); rewrite ?p1, ?p2, ?p3; trivial.
(* the spin is J omega, and what acts everywhere alike has no moment *)
Lemma body_spin x y z vx vy vz ox oy oz : rigid x y z ox oy oz ->
  (forall t a b c, 0 <= t -> rder (fun t => x t a b c) t (vx t a b c) /\ rder (fun t => y t a b c) t (vy t a b c) /\
    rder (fun t => z t a b c) t (vz t a b c)) ->
  (forall t, 0 <= t -> moment mass (y t) (z t) (vy t) (vz t) = J * ox t /\ moment mass (z t) (x t) (vz t) (vx t) = J * oy t /\
    moment mass (x t) (y t) (vx t) (vy t) = J * oz t) /\
  (forall t, 0 <= t -> forall gx gy gz, moment mass (y t) (z t) (fun _ _ _ => gy) (fun _ _ _ => gz) = 0 /\
    moment mass (z t) (x t) (fun _ _ _ => gz) (fun _ _ _ => gx) = 0 /\ moment mass (x t) (y t) (fun _ _ _ => gx) (fun _ _ _ => gy) = 0).
Proof.
  intros [U T] V. split; intros t Ht; destruct (U t Ht) as (a1 & a2 & a3 & b1 & b2 & b3 & c1 & c2 & c3 & (e1 & e2 & e3) & (e12 & e23 & e31) & P).
  - assert (Q : forall a b c, vx t a b c = oy t * z t a b c - oz t * y t a b c /\ vy t a b c = oz t * x t a b c - ox t * z t a b c /\
    vz t a b c = ox t * y t a b c - oy t * x t a b c).
    { intros a b c. destruct (T t a b c Ht) as (T1 & T2 & T3). destruct (V t a b c Ht) as (V1 & V2 & V3).
      repeat split; eapply rder_unique; eassumption. }
    unfold moment. split; [ | split ].
    + rewrite <- (spin_part a1 b1 c1 a2 b2 c2 a3 b3 c3 (ox t) (oy t) (oz t)); try lra. f_equal. extensionality a. extensionality b.
      extensionality c. matched (Q a b c) (P a b c).
    + rewrite <- (spin_part a2 b2 c2 a3 b3 c3 a1 b1 c1 (oy t) (oz t) (ox t)); try lra. f_equal. extensionality a. extensionality b.
      extensionality c. matched (Q a b c) (P a b c).
    + rewrite <- (spin_part a3 b3 c3 a1 b1 c1 a2 b2 c2 (oz t) (ox t) (oy t)); try lra. f_equal. extensionality a. extensionality b.
      extensionality c. matched (Q a b c) (P a b c).
  - intros gx gy gz. unfold moment.
    assert (Z : forall k7 k8 k9 f, (fun a b c => 0 * a ^ 2 + 0 * b ^ 2 + 0 * c ^ 2 + 0 * (a * b) + 0 * (b * c) + 0 * (c * a) + k7 * a + k8 * b + k9 *
        c) = f -> mass f = 0)
      by (intros k7 k8 k9 f E; rewrite (polynomial _ _ _ _ _ _ _ _ _ _ E); field).
    split; [ apply (Z (a2 * gz - a3 * gy) (b2 * gz - b3 * gy) (c2 * gz - c3 * gy)) | split; [ apply (Z (a3 * gx - a1 * gz) (b3 * gx - b1 * gz) (c3 *
        gx - c1 * gz))
      | apply (Z (a1 * gy - a2 * gx) (b1 * gy - b2 * gx) (c1 * gy - c2 * gx)) ] ];
      extensionality a; extensionality b; extensionality c; destruct (P a b c) as (p1 & p2 & p3); rewrite ?p1, ?p2, ?p3; ring.
Qed.
End Body.
(* six equal masses at one distance on three axes *)
Definition six (J : R) (f : R -> R -> R -> R) : R := J / 4 * (f 1 0 0 + f (-1) 0 0 + f 0 1 0 + f 0 (-1) 0 + f 0 0 1 + f 0 0 (-1)).
Lemma six_alike J : one_moment J (six J).
Proof. split; unfold six; intros; repeat split; field. Qed.
