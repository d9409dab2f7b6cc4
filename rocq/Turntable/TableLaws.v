(* The laws of motion on the table, (86) and (89), with rest; the angle psi; the rates while the particle slips *)
Require Import Reals Lra Psatz FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Slipbook Require Import Motion Formulas.
From Slipbook Require Export Analysis.
Open Scope R_scope.

(* (89) in the units of (87), (88): position (x, y) and velocity (u, w) on the table; friction has the size 1.
   «$(x,y)$ with the velocity $(u,w)$ is a motion on the table by (89)» *)
Record spin (x y u w : R -> R) : Prop := {
  s_cx : forall t, 0 < t -> continuity_pt x t;  s_cy : forall t, 0 < t -> continuity_pt y t;
  s_cu : forall t, 0 < t -> continuity_pt u t;  s_cw : forall t, 0 < t -> continuity_pt w t;
  s_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, coulomb 1 (u t) (w t) fx fy /\
            rder u t (x t + 2 * w t + fx) /\ rder w t (y t - 2 * u t + fy) }.
(* (86) with its dimensions: the table turns at the rate Om (per time), k = mu g (an acceleration).
   «$(x,y)$ with the velocity $(u,w)$ is a motion by (86) on a table that turns at the rate $Om$, with friction of the size $k$» *)
Record turntable (Om k : R) (x y u w : R -> R) : Prop := {
  t_c : forall t, 0 < t -> continuity_pt x t /\ continuity_pt y t /\ continuity_pt u t /\ continuity_pt w t;
  t_law : forall t, 0 <= t -> rder x t (u t) /\ rder y t (w t) /\ exists fx fy, coulomb k (u t) (w t) fx fy /\
            rder u t (Om ^ 2 * x t + 2 * Om * w t + fx) /\ rder w t (Om ^ 2 * y t - 2 * Om * u t + fy) }.
(* (105), in the unit of length of u and w. «$s$ is the length of the path of what has the velocity $(u,w)$» *)
Definition arc_length (u w s : R -> R) :=
  (forall t, 0 < t -> continuity_pt s t) /\ forall t, 0 <= t -> rder s t (eq105_arc_rate (nrm (u t) (w t))).
(* psi is the angle of the position with respect to the velocity, counterclockwise: the direction of (u, w), turned by psi
   (radians), is that of (x, y); at rest and on the axis it may be any. «$psi$ is the angle from the velocity $(u,w)$ to the position $(x,y)$» *)
Definition position_angle x y u w psi :=
  nrm u w * x = nrm x y * (u * cos psi - w * sin psi) /\ nrm u w * y = nrm x y * (u * sin psi + w * cos psi).
(* the same motion in the units of (87) and (88); velocities go with them; all dimensionless.
   «$(rx,ry)$ and $(pu,pw)$ are the place $(x,y)$ and the velocity $(u,w)$ in the units of (87) and (88)» *)
Definition in_units (Om mu g : R) (x y u w rx ry pu pw : R -> R) := forall t,
  rx (eq88_time Om t) = eq87_position_1 Om mu g (x t) (y t) /\ ry (eq88_time Om t) = eq87_position_2 Om mu g (x t) (y t) /\
  pu (eq88_time Om t) = Om / (mu * g) * u t /\ pw (eq88_time Om t) = Om / (mu * g) * w t.
(* f approaches f t from the right. «$f$ is continuous from the right at $t$» *)
Definition right_continuous (f : R -> R) t := forall e, 0 < e -> exists d, 0 < d /\ forall s, t <= s < t + d -> Rabs (f s - f t) < e.
(* position_angle by products. «$psi$ is the angle from the velocity $(u,w)$ to the position $(x,y)$» *)
Definition angle x y u w psi := x * u + y * w = nrm x y * nrm u w * cos psi /\ x * w - y * u = - (nrm x y * nrm u w * sin psi).

Ltac table S := cont; first [ apply (s_cx _ _ _ _ S) | apply (s_cy _ _ _ _ S) | apply (s_cu _ _ _ _ S) | apply (s_cw _ _ _ _ S) ]; lra.

Lemma rder_right_continuous f t l : rder f t l -> right_continuous f t.
Proof.
  intros [F [H K]] e He. destruct (cont_eps F t e (cont_of F t l H) He) as (d & d0 & Hd). exists d. split; trivial. intros s Hs.
  rewrite <- !K by lra. apply Hd, Rabs_def1; lra.
Qed.
Lemma angle_iff x y u w psi : position_angle x y u w psi <-> angle x y u w psi.
Proof.
  unfold position_angle, angle. pose proof (nrm_sq u w) as e. destruct (Req_dec (nrm u w) 0) as [z | z].
  - destruct (nrm_zero u w z) as [-> ->]. rewrite z. split; intros _; split; ring.
  - set (n := nrm u w) in *. set (m := nrm x y). split; intros [h1 h2]; split; apply (Rmult_eq_reg_l n); trivial.
    + transitivity (n * x * u + n * y * w). ring. rewrite h1, h2. ring [e].
    + transitivity (n * x * w - n * y * u). ring. rewrite h1, h2. ring [e].
    + transitivity (u * (x * u + y * w) + w * (x * w - y * u)). ring [e]. rewrite h1, h2. ring.
    + transitivity (w * (x * u + y * w) - u * (x * w - y * u)). ring [e]. rewrite h1, h2. ring.
Qed.
(* an angle for each state: pi where the position is just against the velocity, else by the tangent of its half *)
Definition half_angle c d m := 2 * atan (d / (m + c)).
Lemma angle_exists x y u w : let c := x * u + y * w in let d := y * u - x * w in let m := nrm x y * nrm u w in
  { psi | position_angle x y u w psi /\ (m + c <> 0 -> psi = half_angle c d m) }.
Proof.
  intros c d m. assert (e : d ^ 2 = m ^ 2 - c ^ 2) by (unfold m; rewrite Rpow_mult_distr, !nrm_sq; unfold c, d; ring).
  assert (F : forall psi, c = m * cos psi -> d = m * sin psi -> position_angle x y u w psi).
  { intros psi h1 h2. apply angle_iff. split; [ exact h1 | ]. fold m. unfold d in h2. lra. }
  destruct (Req_EM_T (m + c) 0) as [z | z]. { exists PI. split; [ | lra ]. apply F; rewrite ?cos_PI, ?sin_PI; nra. }
  exists (half_angle c d m). split; trivial. unfold half_angle. destruct (twice_atan (d / (m + c))) as [h1 h2].
  assert (n : (m + c) ^ 2 + d ^ 2 <> 0) by nra.
  apply F; rewrite ?h1, ?h2; field_simplify_eq; try (split; trivial; nra); ring [e].
Qed.

Section Slip.
Variables x y u w : R -> R.
Hypothesis S : spin x y u w.
Notation p t := (nrm (u t) (w t)).
Notation rho t := (nrm (x t) (y t)).
Notation E t := (x t ^ 2 + y t ^ 2 - (u t ^ 2 + w t ^ 2)).
Notation xi t := ((x t * u t + y t * w t) * / nrm (u t) (w t)).
Notation ell t := ((x t * w t - y t * u t) * / nrm (u t) (w t)).

(* rho^2 - p^2 grows at the rate 2 p, at rest too: A of (113) never decreases *)
Lemma E_rate t : 0 <= t -> rder (fun t => E t) t (2 * p t).
Proof. intros Ht. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & [_ P] & U & W). eapply rder_eq. rd. simpl. lra. Qed.
Lemma A_never_falls s t : 0 <= s <= t -> E s <= E t.
Proof.
  intros Hst. apply Ropp_le_cancel. apply (rder_decr (fun t => - E t)); [ lra | | ]; intros r Hr. table S.
  exists (- (2 * p r)). split. apply (rder_opp (fun t => E t)), E_rate; lra. pose proof (nrm_pos (u r) (w r)). lra.
Qed.
Lemma slip t : 0 <= t -> p t <> 0 -> rder x t (u t) /\ rder y t (w t) /\
  rder u t (x t + 2 * w t - u t / p t) /\ rder w t (y t - 2 * u t - w t / p t).
Proof.
  intros Ht N. destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W). apply coulomb_iff in C; [ | lra ].
  destruct C as [[z _] | (_ & -> & ->)]; [ lra | ]. repeat split; trivial; (eapply rder_eq; [ eassumption | field; trivial ]).
Qed.

Variable t : R.
Hypothesis ht : 0 <= t.
Hypothesis N : nrm (u t) (w t) <> 0.
Ltac rates := destruct (slip t ht N) as (X & Y & U & W); pose proof (nrm_sq (u t) (w t)) as e.
Lemma dp : rder (fun t => p t) t (xi t - 1).
Proof. rates. eapply rder_eq; [ rd; exact N | ]. set (n := p t) in *. inR. field_simplify_eq; [ | trivial ]. ring [e]. Qed.
Lemma eq99 : rder (fun t => p t) t ((x t * u t + y t * w t) / p t - 1).
Proof. exact dp. Qed.
Ltac rate_over := rates; pose proof dp; eapply rder_eq; [ rds; exact N | ]; set (n := p t) in *; inR; field_simplify_eq; [ | trivial ].
Lemma eq101 : rder (fun t => xi t) t ((p t + ell t) ^ 2 / p t).
Proof. rate_over. ring [e]. Qed.
Lemma eq100 : rder (fun t => ell t) t (- xi t * (2 * p t + ell t) / p t).
Proof. rate_over. ring [e]. Qed.
Lemma rder_rho : rho t <> 0 -> rder (fun t => rho t) t ((x t * u t + y t * w t) * / rho t).
Proof. intros K. rates. eapply rder_eq. rd. exact K. reflexivity. Qed.
(* it goes on slipping for a while *)
Lemma slips_on : exists d, 0 < d /\ forall s, t <= s < t + d -> 0 < p s.
Proof.
  pose proof (nrm_pos (u t) (w t)). destruct (right_pos _ _ _ dp) as (d & d0 & H1). lra. exists d. split; trivial. intros s Hs.
    destruct (Req_dec s t) as [-> | ne]. lra. apply H1. lra.
Qed.
End Slip.

(* while it slides, friction is k against the velocity *)
Lemma slides Om k x y u w t : 0 <= k -> turntable Om k x y u w -> 0 <= t -> nrm (u t) (w t) <> 0 ->
  rder u t (Om ^ 2 * x t + 2 * Om * w t - k * u t / nrm (u t) (w t)) /\ rder w t (Om ^ 2 * y t - 2 * Om * u t - k * w t / nrm (u t) (w t)).
Proof.
  intros Hk S Ht N. destruct (t_law _ _ _ _ _ _ S t Ht) as (_ & _ & fx & fy & C & U & W). apply coulomb_iff in C; trivial.
  destruct C as [[z _] | (_ & -> & ->)]; [ lra | ]. split; (eapply rder_eq; [ eassumption | field; trivial ]).
Qed.
Lemma spin_is_turntable x y u w : spin x y u w <-> turntable 1 1 x y u w.
Proof.
  split; intros S; split; try (intros t Ht; first [ now destruct (t_c _ _ _ _ _ _ S t Ht) as (? & ? & ? & ?) | repeat split; now apply S ]);
    intros t Ht; [ destruct (s_law _ _ _ _ S t Ht) as (X & Y & fx & fy & C & U & W) | destruct (t_law _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & C &
    U & W) ];
    repeat (split; trivial); exists fx, fy; repeat (split; trivial); (eapply rder_eq; [ eassumption | ring ]).
Qed.
(* other units: lengths L times as large, times shorter by c *)
Lemma rescale Om k c L x y u w : 0 < c -> 0 < L -> turntable Om k x y u w ->
  turntable (c * Om) (L * c ^ 2 * k) (fun t => L * x (c * t)) (fun t => L * y (c * t)) (fun t => L * c * u (c * t)) (fun t => L * c * w (c * t)).
Proof.
  intros Hc HL S. split.
  - intros t Ht. destruct (t_c _ _ _ _ _ _ S (c * t)) as (? & ? & ? & ?). { nra. }
    repeat split; (apply (continuity_pt_mult (fun _ => _)); [ cont | now apply cont_time ]).
  - intros t Ht. destruct (t_law _ _ _ _ _ _ S (c * t)) as (X & Y & fx & fy & [B P] & U & W). { nra. } apply (rder_time c) in X, Y, U, W; trivial.
    split. { eapply rder_eq. rds. ring. } split. { eapply rder_eq. rds. ring. }
    exists (L * c ^ 2 * fx), (L * c ^ 2 * fy). split. { split.
      - replace ((L * c ^ 2 * fx) ^ 2 + (L * c ^ 2 * fy) ^ 2) with ((L * c ^ 2) ^ 2 * (fx ^ 2 + fy ^ 2)) by ring. rewrite (Rpow_mult_distr _ k).
        apply Rmult_le_compat_l; trivial. apply pow2_ge_0.
      - rewrite nrm_scale by nra. transitivity (L * c ^ 2 * (L * c) * (fx * u (c * t) + fy * w (c * t))). ring. rewrite P. ring. }
    split; (eapply rder_eq; [ rds | ring ]).
Qed.
Lemma back (f : R -> R) a b c d : a * b = 1 -> c * d = 1 -> (fun t => a * (b * f (c * (d * t)))) = f.
Proof. intros e1 e2. extensionality t. now rewrite <- !Rmult_assoc, e1, e2, !Rmult_1_l. Qed.
(* (86) in the units of (87), (88) is (89), both ways *)
Lemma units Om mu g x y u w rx ry pu pw : 0 < Om -> 0 < mu * g -> in_units Om mu g x y u w rx ry pu pw ->
  turntable Om (mu * g) x y u w <-> spin rx ry pu pw.
Proof.
  unfold in_units, eq87_position_1, eq87_position_2, eq88_time. set (k := mu * g). intros HO Hk T. rewrite spin_is_turntable.
  assert (E : x = (fun t => k / Om ^ 2 * rx (Om * t)) /\ y = (fun t => k / Om ^ 2 * ry (Om * t)) /\ u = (fun t => k / Om ^ 2 * Om * pu (Om * t)) /\
    w = (fun t => k / Om ^ 2 * Om * pw (Om * t))).
  { repeat split; extensionality t; destruct (T t) as (e1 & e2 & e3 & e4); rewrite ?e1, ?e2, ?e3, ?e4; field; lra. }
  destruct E as (-> & -> & -> & ->). split; intros S.
  - apply (rescale _ _ (/ Om) (Om ^ 2 / k)) in S; [ | now apply Rinv_0_lt_compat | apply Rdiv_lt_0_compat; nra ].
    rewrite !back in S by (field; lra). now replace (/ Om * Om) with 1 in S; [ replace (Om ^ 2 / k * (/ Om) ^ 2 * k) with 1 in S | ]; try (field;
    lra).
  - apply (rescale _ _ Om (k / Om ^ 2)) in S; trivial; [ | apply Rdiv_lt_0_compat; nra ].
    rewrite Rmult_1_r in S. now replace (k / Om ^ 2 * Om ^ 2 * 1) with k in S by (field; lra).
Qed.
Lemma mirrored Om k x y u w : turntable Om k x y u w -> turntable (- Om) k x (fun t => - y t) u (fun t => - w t).
Proof.
  intros S. split.
  - intros t Ht. destruct (t_c _ _ _ _ _ _ S t Ht) as (? & ? & ? & ?). repeat split; trivial; cont.
  - intros t Ht. destruct (t_law _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & [B P] & U & W). split; [ exact X | ]. split; [ now apply rder_opp | ].
    exists fx, (- fy). split. { split. lra. replace (nrm (u t) (- w t)) with (nrm (u t) (w t)) by (unfold nrm; f_equal; ring). lra. }
    split. { eapply rder_eq; [ exact U | ring ]. } eapply rder_eq; [ apply rder_opp, W | ring ].
Qed.
(* the length of its path, by the energy *)
Lemma arc_exists Om k x y u w : 0 < k -> turntable Om k x y u w -> arc_length u w (fun t => (Om ^ 2 * (x t ^ 2 + y t ^ 2) - (u t ^ 2 + w t ^ 2)) * /
  (2 * k)).
Proof.
  intros Hk S. split; intros t Ht.
  - destruct (t_c _ _ _ _ _ _ S t Ht) as (? & ? & ? & ?). cont.
  - destruct (t_law _ _ _ _ _ _ S t Ht) as (X & Y & fx & fy & [_ P] & U & W). unfold eq105_arc_rate. eapply rder_eq. rd. simpl.
    set (n := nrm _ _) in *.
    transitivity (- (fx * u t + fy * w t) / k). field; lra. rewrite P. field. lra.
Qed.
