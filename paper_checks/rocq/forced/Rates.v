(** Continuity and rates from the right of what is made of parts, by those of the parts; upper rates; roots. *)
From InertialPair Require Export Dini Pair Pursuit.

(** the size of a number with a sign before it *)
Lemma Rabs_sign k z : k = 1 \/ k = -1 -> Rabs (k * z) = Rabs z.
Proof. intros [-> | ->]; rewrite Rabs_mult; [rewrite Rabs_R1|rewrite Rabs_m1]; ring. Qed.

(** linear arithmetic with bounds of sizes *)
Ltac by_sizes := repeat match goal with H : Rabs _ <= _ |- _ => apply Rabs_inv in H
  | H : Rabs _ < _ |- _ => apply Rabs_def2 in H end; first [lra | apply Rabs_le; lra
  | apply Rabs_def1; lra | split; nra | apply Rabs_le; split; nra].
(** what a minimum is not more than *)
Ltac least c := let m := eval unfold c in c in min_bounds m; pose proof (eq_refl c : c = m).

(** what repeats after P, after any number of times; and every time by one of the first turn *)
Lemma repeats {A} (f : R -> A) P n t : 0 <= P -> (forall t, 0 <= t -> f (P + t) = f t) -> 0 <= t ->
  f (INR n * P + t) = f t.
Proof.
  intros HP E Ht. induction n as [|n IH]; [simpl; f_equal; ring|]. rewrite S_INR.
  replace ((INR n + 1) * P + t) with (P + (INR n * P + t)) by ring. rewrite E; auto.
  pose proof (pos_INR n). positive.
Qed.
Lemma one_turn P t : 0 < P -> 0 <= t -> exists n u, t = INR n * P + u /\ 0 <= u < P.
Proof.
  intros HP Ht. destruct (nfloor_ex (t / P)) as (n & Lo & Hi); [positive|]. exists n, (t - INR n * P).
  apply (Rmult_le_compat_r P) in Lo; [|lra]. apply (Rmult_lt_compat_r P) in Hi; [|auto].
  replace (t / P * P) with t in * by (field; lra). split; [ring|lra].
Qed.

(** exp rises *)
Lemma exp_mono p q : p <= q -> exp p <= exp q.
Proof. intros [L|<-]; [apply Rlt_le, exp_increasing; auto|lra]. Qed.

(** *** Upper rates from the right *)
Lemma dini_eq f t k l : k = l -> dini_le f t k -> dini_le f t l.
Proof. intros ->; auto. Qed.
Lemma dini_ext f g t k : (forall u, f u = g u) -> dini_le f t k -> dini_le g t k.
Proof. intros E F e He. destruct (F e He) as (d & Hd & K). exists d. split; auto. intros h Hh. rewrite <- !E. auto. Qed.
Lemma dini_add f g t k l : dini_le f t k -> dini_le g t l -> dini_le (fun u => f u + g u) t (k + l).
Proof.
  intros F G e He. destruct (F (e / 2)) as (d & Hd & K); [lra|]. destruct (G (e / 2)) as (d' & Hd' & K'); [lra|].
  smaller d d'. intros h Hh. specialize (K h ltac:(lra)). specialize (K' h ltac:(lra)). lra.
Qed.
(** of a Lipschitz function times one that is not negative *)
Lemma dini_lip_mult U G t F l d : 0 <= t -> 0 < d -> (forall p q, 0 <= p <= q -> Rabs (U q - U p) <= F * (q - p)) ->
  (forall u, t <= u < t + d -> 0 <= G u) -> rderiv G t l -> dini_le (fun u => U u * G u) t (F * G t + U t * l).
Proof.
  intros Ht Hd L P D e He.
  pose proof (little_plus _ _ (little_scal F _ (big_mult _ _ big_id (rderiv_big _ _ _ D))) (little_scal (U t) _ D)) as
    Li.
  destruct (Li e He) as (d' & Hd' & K). smaller d d'. intros h Hh. specialize (K h ltac:(lra)). apply Rabs_inv in K.
  pose proof (L t (t + h) ltac:(lra)) as B. apply Rabs_inv in B. pose proof (P (t + h) ltac:(lra)) as Ph.
  assert ((U (t + h) - U t) * G (t + h) <= F * (t + h - t) * G (t + h)) by scale. lra.
Qed.
(** of a root: it is concave, and carries an upper rate over without a condition on the increment *)
Lemma sqrt_dini y t k : (forall u, 0 <= y u) -> 0 < sqrt (y t) -> dini_le y t k ->
  dini_le (fun u => sqrt (y u)) t (k / (2 * sqrt (y t))).
Proof.
  intros P Sp F e He. destruct (F (2 * sqrt (y t) * e)) as (d & Hd & K); [nra|]. exists d; split; auto. intros h Hh.
  specialize (K h Hh). pose proof (sqrt_sqrt _ (P (t + h))). pose proof (sqrt_sqrt _ (P t)).
  apply Rmult_le_reg_l with (2 * sqrt (y t)); [lra|]. pose proof (pow2_ge_0 (sqrt (y (t + h)) - sqrt (y t))).
  replace (2 * sqrt (y t) * ((k / (2 * sqrt (y t)) + e) * h)) with ((k + 2 * sqrt (y t) * e) * h) by (field; lra). lra.
Qed.

(** *** Parts *)
Lemma cont_comp g f : (forall t, 0 <= t -> continuity_pt g (f t)) -> cont f -> cont (fun t => g (f t)).
Proof.
  intros G C t Ht e He. destruct (G t Ht e He) as (d & Hd & K). destruct (C t Ht d Hd) as (d' & Hd' & K').
  exists d'. split; auto. intros u Hu N. destruct (Req_dec (f u) (f t)) as [->|E];
    [rewrite Rminus_diag_eq, Rabs_R0; auto|].
  apply K. split; [split; [exact I|auto]|apply K'; auto].
Qed.

Lemma rderiv_same f t : rderiv (fun u => f u - f u) t 0.
Proof. apply rderiv_ext with (fun _ => 0); [intros; ring|apply rderiv_const]. Qed.

(** what is known of a motion; files that define motions say more *)
Ltac motion := fail.
(** continuity of what is made of continuous functions, or is smooth *)
Ltac continuous := first [assumption | apply cont_const | motion
  | lazymatch goal with
    | |- cont (fun u => @?f u + @?g u) => apply (cont_plus f g); continuous
    | |- cont (fun u => @?f u - @?g u) => apply (cont_minus f g); continuous
    | |- cont (fun u => @?f u * @?g u) => apply (cont_mult f g); continuous
    | |- cont (fun u => @?f u ^ 2) => apply (cont_mult f (fun u => f u * 1)); continuous
    | |- cont (fun u => @?f u / ?c) => apply (cont_mult f (fun _ => / c)); continuous
    | |- cont (fun u => - @?f u) => apply (cont_opp f); continuous
    | |- cont (fun u => Rabs (@?f u)) => apply (cont_abs f); continuous
    | |- cont (fun u => ?f (?t + u)) => apply (cont_shift f t); [lra|continuous]
    | |- cont (fun u => ?f u) => is_var f; unfold f; continuous
    | |- cont ?f => is_var f; unfold f; continuous
    end
  | apply integral_cont; continuous
  | match goal with D : forall t, is_derive ?f t _ |- cont ?f => exact (cont_of_derive _ _ D)
    | D : forall t, is_derive ?f t _ |- cont (fun u => ?f u) => exact (cont_of_derive _ _ D) end
  | eapply cont_of_derive; intros; auto_derive; [repeat split; auto; lra|reflexivity]].
(** the rate from the right, as what the rates of the parts make of it *)
Ltac rates := first [apply rderiv_const | motion
  | match goal with D : context [rderiv _ _ _] |- _ => eapply D; solve [auto | lra] end
  | lazymatch goal with
    | |- rderiv (fun u => @?f u + @?g u) _ _ => eapply (rderiv_plus f g); rates
    | |- rderiv (fun u => @?f u - @?g u) _ _ => eapply (rderiv_minus f g); rates
    | |- rderiv (fun u => - @?f u) _ _ => eapply (rderiv_opp f); rates
    | |- rderiv (fun u => @?f u * @?g u) _ _ => first [eapply rderiv_scal; rates | eapply (rderiv_mult f g); rates]
    | |- rderiv (fun u => @?f u ^ 2) _ _ => eapply (rderiv_mult f (fun u => f u * 1)); rates
    | |- rderiv (fun u => @?f u / _) _ _ => eapply (rderiv_mult f); rates
    | |- rderiv (fun u => ?f u) _ _ => is_var f; unfold f; rates
    | |- rderiv ?f _ _ => is_var f; unfold f; rates
    end
  | eapply rderiv_eq; [|eapply integral_rderiv; [continuous|solve [auto | lra]]]; reflexivity
  | match goal with D : forall t, is_derive ?f t _ |- rderiv ?f _ _ => eapply rderiv_of_derive, D
    | D : forall t, is_derive ?f t _ |- rderiv (fun u => ?f u) _ _ => eapply rderiv_of_derive, D end
  | eapply rderiv_of_derive; auto_derive; [repeat split; auto; lra|reflexivity]].
(** what is left is that this is the rate wanted *)
Ltac rate := eapply rderiv_eq; [|rates]; cbv beta.
(** a derivative, by those that are known *)
Ltac derive := auto_derive; [repeat split; first [match goal with
      D : forall t, is_derive ?f t _ |- ex_derive (fun x => ?f x) _ => eexists; apply D end | auto; lra]
  |repeat match goal with D : forall t, is_derive ?f t _ |- context [Derive (fun x => ?f x) ?t] =>
     rewrite (is_derive_unique (fun x : R => f x) _ _ (D t)) end].
(** the mean value theorem *)
Lemma mean_value f f' p q : p < q -> (forall t, is_derive f t (f' t)) ->
  exists c, p < c < q /\ f q - f p = f' c * (q - p).
Proof.
  intros Hp D. destruct (MVT_cor2 f f' p q Hp) as (c & E & Hc); [intros; apply is_derive_Reals, D|eauto].
Qed.

(** what is slower than an arc gains less *)
Lemma slower y w Y W p q : cont y -> 0 <= p <= q -> (forall u, is_derive Y u (W u)) ->
  (forall u, p <= u < q -> rderiv y u (w u) /\ w u <= W u) -> y q - y p <= Y q - Y p.
Proof.
  intros C Hp D S. cut (y q - Y q <= y p - Y p); [lra|].
  apply (rderiv_mono (fun u => y u - Y u) p q (fun u => w u - W u)); [continuous|auto|].
  intros u Hu. destruct (S u Hu). split; [rates|lra].
Qed.
(** and what runs along with it gains as much *)
Lemma same_gain y w Y W p q : cont y -> 0 <= p <= q -> (forall u, is_derive Y u (W u)) ->
  (forall u, p <= u < q -> rderiv y u (w u) /\ w u = W u) -> y q - y p = Y q - Y p.
Proof.
  intros C Hp D S. pose proof (rderiv_line (fun u => y u - Y u) 0 p q ltac:(continuous) Hp) as L. cbv beta in L.
  cut (y q - Y q - (y p - Y p) = 0 * (q - p)); [lra|]. apply L. intros u Hu. destruct (S u Hu). rate. lra.
Qed.
