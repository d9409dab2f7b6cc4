(* The laboratory, where friction alone accelerates the particle: (86) is its law seen from the table (turned) *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion TableLaws.
Open Scope R_scope.

(* position (X, Y) and velocity (U, W) in the laboratory; below it the table turns at the rate Om and has the velocity (- Om Y, Om X); k = mu g.
   «$(X,Y)$ with the velocity $(U,W)$ is a motion in the laboratory under friction of the size $k$ alone, on a table that turns at the rate $Om$» *)
Record laboratory (Om k : R) (X Y U W : R -> R) : Prop := {
  l_c : forall t, 0 < t -> continuity_pt X t /\ continuity_pt Y t /\ continuity_pt U t /\ continuity_pt W t;
  l_law : forall t, 0 <= t -> rder X t (U t) /\ rder Y t (W t) /\
            exists fx fy, coulomb k (U t + Om * Y t) (W t - Om * X t) fx fy /\ rder U t fx /\ rder W t fy }.
(* (x, y) and (u, w): place and velocity of the same particle relative to the table, along axes that turn with it.
   «$(x,y)$, $(u,w)$ are place and velocity on the table, which turns at the rate $Om$, of what has $(X,Y)$, $(U,W)$ in the laboratory» *)
Definition same_particle (Om : R) (X Y U W x y u w : R -> R) := forall t,
  x t = cos (Om * t) * X t + sin (Om * t) * Y t /\ y t = cos (Om * t) * Y t - sin (Om * t) * X t /\
  u t = cos (Om * t) * (U t + Om * Y t) + sin (Om * t) * (W t - Om * X t) /\
  w t = cos (Om * t) * (W t - Om * X t) - sin (Om * t) * (U t + Om * Y t).

(* the law in a frame that turns at the rate o, for a table that turns at the rate Om *)
Record seen (o Om k : R) (x y u w : R -> R) : Prop := {
  f_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt u t /\ continuity_pt w t;
  f_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, coulomb k (u t + (Om - o) * y t) (w t - (Om - o) * x t) fx fy /\
            rder u t (o ^ 2 * x t + 2 * o * w t + fx) /\ rder w t (o ^ 2 * y t - 2 * o * u t + fy) }.
Ltac same_law := split; intros [C L]; split; trivial; intros t Ht; destruct (L t Ht) as (X & Y & fx & fy & F & U & W); split; trivial; split; trivial;
  exists fx, fy; rewrite ?Rminus_0_r, ?Rminus_eq_0, ?Rmult_0_l, ?Rplus_0_r, ?Rminus_0_r in *; split; trivial;
  split; (eapply rder_eq; [ eassumption | ring ]).
Lemma seen_lab Om k x y u w : seen 0 Om k x y u w <-> laboratory Om k x y u w.
Proof. same_law. Qed.
Lemma seen_table Om k x y u w : seen Om Om k x y u w <-> turntable Om k x y u w.
Proof. same_law. Qed.
Lemma turned q o Om k X Y U W x y u w : same_particle q X Y U W x y u w -> seen o Om k X Y U W -> seen (o + q) Om k x y u w.
Proof.
  intros T S. replace x with (fun t => cos (q * t) * X t + sin (q * t) * Y t) by (extensionality t; symmetry; apply (T t)).
  replace y with (fun t => cos (q * t) * Y t - sin (q * t) * X t) by (extensionality t; symmetry; apply (T t)).
  replace u with (fun t => cos (q * t) * (U t + q * Y t) + sin (q * t) * (W t - q * X t)) by (extensionality t; symmetry; apply (T t)).
  replace w with (fun t => cos (q * t) * (W t - q * X t) - sin (q * t) * (U t + q * Y t)) by (extensionality t; symmetry; apply (T t)).
  assert (dc : forall t, is_derive (fun t => cos (q * t)) t (- q * sin (q * t))) by (intros; auto_derive; trivial; ring).
  assert (ds : forall t, is_derive (fun t => sin (q * t)) t (q * cos (q * t))) by (intros; auto_derive; trivial; ring). split; intros t Ht.
  - destruct (f_c _ _ _ _ _ _ _ S t Ht) as (cX & cY & cU & cW). pose proof (cont_of _ _ _ (dc t)). pose proof (cont_of _ _ _ (ds t)).
  repeat split; cont.
  - destruct (f_law _ _ _ _ _ _ _ S t Ht) as (DX & DY & fx & fy & [B P] & DU & DW). specialize (dc t). specialize (ds t). apply rder_of in dc, ds.
    pose proof (unit_circle (q * t)) as e. set (s := sin (q * t)) in *. set (c := cos (q * t)) in *.
    split. { eapply rder_eq; [ rd | fold s; fold c; ring ]. } split. { eapply rder_eq; [ rd | fold s; fold c; ring ]. }
    exists (c * fx + s * fy), (c * fy - s * fx). split; [ split | split; (eapply rder_eq; [ rd | fold s; fold c; ring ]) ].
    + replace ((c * fx + s * fy) ^ 2 + (c * fy - s * fx) ^ 2) with ((c ^ 2 + s ^ 2) * (fx ^ 2 + fy ^ 2)) by ring. rewrite e, Rmult_1_l. exact B.
    + set (a := U t + (Om - o) * Y t) in *. set (b := W t - (Om - o) * X t) in *.
      replace (c * (U t + q * Y t) + s * (W t - q * X t) + (Om - (o + q)) * (c * Y t - s * X t)) with (c * a + s * b) by (unfold a, b; ring).
      replace (c * (W t - q * X t) - s * (U t + q * Y t) - (Om - (o + q)) * (c * X t + s * Y t)) with (c * b - s * a) by (unfold a, b; ring).
      replace (nrm (c * a + s * b) (c * b - s * a)) with (nrm a b) by (unfold nrm; f_equal; rewrite <- (Rmult_1_l (a ^ 2 + b ^ 2)), <- e; ring).
      transitivity ((c ^ 2 + s ^ 2) * (fx * a + fy * b)). ring. rewrite e, P. ring.
Qed.
Lemma same_back Om X Y U W x y u w : same_particle Om X Y U W x y u w <-> same_particle (- Om) x y u w X Y U W.
Proof.
  assert (H : forall Om X Y U W x y u w, same_particle Om X Y U W x y u w -> same_particle (- Om) x y u w X Y U W).
  { clear. intros Om X Y U W x y u w T t. destruct (T t) as (-> & -> & -> & ->). rewrite Ropp_mult_distr_l_reverse, cos_neg, sin_neg.
    assert (e2 : cos (Om * t) ^ 2 = 1 - sin (Om * t) ^ 2) by (pose proof (unit_circle (Om * t)); lra).
    repeat split; ring [e2]. }
  split; intros T; [ now apply H | ]. apply H in T. now rewrite Ropp_involutive in T.
Qed.

