(* 2.2: the drive sin; unit A0, time phi; k = lambda0 *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Slipbook Require Import Motion General.
Open Scope R_scope.

Definition eq37_lambda_c : R := 2 / sqrt (4 + PI ^ 2).
Lemma sq_lt a b : 0 <= a < b -> a ^ 2 < b ^ 2. Proof. intros. nra. Qed.
Lemma sq_lt_inv a b : 0 <= b -> a ^ 2 < b ^ 2 -> a < b. Proof. intros. nra. Qed.
(* (35) says the same as (36) *)
Theorem eq36 l : 0 <= l <= 1 -> (- PI * l + 2 * sqrt (1 - l ^ 2) < 0 <-> eq37_lambda_c < l).
Proof.
  intros H. unfold eq37_lambda_c. pose proof PI_RGT_0.
  assert (S : 0 < sqrt (4 + PI ^ 2)) by (apply sqrt_lt_R0; nra). assert (S2 : sqrt (4 + PI ^ 2) ^ 2 = 4 + PI ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; nra).
  assert (Q : 0 <= sqrt (1 - l ^ 2)) by apply sqrt_pos. assert (Q2 : sqrt (1 - l ^ 2) ^ 2 = 1 - l ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_sqrt; nra).
  set (r := sqrt (4 + PI ^ 2)) in *. set (q := sqrt (1 - l ^ 2)) in *.
  rewrite Rlt_div_l by trivial. split; intros K.
  - apply sq_lt_inv; [ nra | ]. rewrite Rpow_mult_distr, S2. assert (L := sq_lt (2 * q) (PI * l) ltac:(lra)). rewrite !Rpow_mult_distr in L. nra.
  - assert (L := sq_lt 2 (l * r) ltac:(lra)). rewrite Rpow_mult_distr, S2 in L. enough (2 * q < PI * l) by lra. apply sq_lt_inv; [ nra | ]. rewrite !Rpow_mult_distr. nra.
Qed.
Theorem lambda_c_digits : 0.537029272146315 < eq37_lambda_c < 0.537029272146316.
Proof. unfold eq37_lambda_c. split; interval with (i_prec 80). Qed.

(* (28), (32), (30): the end of the slip lies between phi2 and phi4, and is unique there *)
Definition w31 (l ph : R) : R := - l * (ph - asin l) + cos (asin l) - cos ph.
Lemma w31_der l ph : is_derive (w31 l) ph (sin ph - l).
Proof. unfold w31. auto_derive; trivial. ring. Qed.

(* (33) with rest: piecewise, over one period; e = phi~2 *)
Definition w33 (l e ph : R) : R :=
  if Rlt_dec ph (asin l) then 0 else if Rlt_dec ph e then w31 l ph else if Rlt_dec ph (PI + asin l) then 0
  else if Rlt_dec ph (e + PI) then - w31 l (ph - PI) else 0.

(* pieces: a function has the right derivative of the piece that begins *)
Lemma rder_loc f g t l d : 0 < d -> (forall s, t <= s < t + d -> g s = f s) -> is_derive g t l -> rder f t l.
Proof.
  intros Hd E H. exists (fun s => if Rlt_dec s t then g s else f s). split.
  - apply (is_derive_ext_loc g); trivial. exists (mkposreal d Hd). intros s Hs. change (Rabs (s - t) < d) in Hs.
    apply Rabs_def2 in Hs. destruct (Rlt_dec s t); trivial. apply E; lra.
  - intros s Hs. destruct (Rlt_dec s t); trivial; lra.
Qed.
Lemma cont_glue f g h t d : 0 < d -> (forall s, t - d < s <= t -> f s = g s) -> (forall s, t <= s < t + d -> f s = h s) ->
  continuity_pt g t -> continuity_pt h t -> continuity_pt f t.
Proof.
  intros Hd Eg Eh Cg Ch e He. destruct (Cg e He) as (a & a0 & Ha). destruct (Ch e He) as (b & b0 & Hb).
  exists (Rmin d (Rmin a b)). split; [ repeat apply Rmin_pos; trivial | ].
  intros s [Hs1 Hs]. simpl in *. unfold R_dist in *. pose proof (Rmin_l d (Rmin a b)). pose proof (Rmin_r d (Rmin a b)). pose proof (Rmin_l a b). pose proof (Rmin_r a b).
  pose proof (Rabs_def2 _ _ Hs). destruct (Rle_lt_dec s t).
  - rewrite (Eg s), (Eg t) by lra. apply Ha. split; trivial. lra.
  - rewrite (Eh s), (Eh t) by lra. apply Hb. split; trivial. lra.
Qed.
