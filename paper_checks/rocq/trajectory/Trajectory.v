(** Trajectories as theorems: what a table of events says about a motion ([unfolds]), and a program that accepts a table
    only if it is true of every motion of its scene ([Check.sound]). The program bounds the closed forms of Waves.v by
    interval arithmetic; which one is left open. *)
From Coq Require Import QArith Qreals List Bool.
From Interval.Real Require Import Xreal.
From Interval.Interval Require Import Interval.
From InertialPair Require Import Dini Pair Pursuit Forced ForcedExistence Arcs VaryingFriction Waves.
Import ListNotations.

(** *** Statements *)
(** from the time [since] on: the friction, and the force on body 1, a polynomial of the time since [from] and sines *)
Record spell := Spell { since : Q; friction : Q; push : steady Q }.
(** a scene: the pair, the state at the time 0, and what acts from then on, spell after spell *)
Record scene := Scene { m1 : Q; m2 : Q; a1 : Q; a2 : Q; x_0 : Q; v1_0 : Q; x2_0 : Q; v2_0 : Q; first_spell : spell;
  later_spells : list spell }.

(** rational coefficients as real ones *)
Definition in_R (y : steady Q) := Steady (Q2R (from y)) (map Q2R (poly y)) (map (fun z =>
  Tone (Q2R (in_sine z)) (Q2R (in_cosine z)) (Q2R (rise_sine z)) (Q2R (rise_cosine z)) (Q2R (turn z)) (Q2R (phase z)))
    (tones y)).
(** the force at the time t *)
Fixpoint force_at now later t := match later with
  | next :: later => if Rlt_dec t (Q2R (since next)) then sval real (in_R (push now)) t else force_at next later t
  | [] => sval real (in_R (push now)) t end.
(** friction and duration of all spells but the last, and the last one's friction *)
Fixpoint pieces now later := match later with
  | next :: later => (Q2R (friction now), Q2R (since next) - Q2R (since now)) :: pieces next later | [] => [] end.
Fixpoint last_friction now later := match later with
  | next :: later => last_friction next later | [] => Q2R (friction now) end.

(** a motion of the scene; x2 is where body 2 is *)
Definition motion sc x v1 x2 v2 := exists U, cont U /\
  (forall t, 0 <= t -> rderiv U t (force_at (first_spell sc) (later_spells sc) t)) /\
  varying (Q2R (m1 sc)) (Q2R (m2 sc)) (Q2R (a1 sc)) (Q2R (a2 sc)) (pieces (first_spell sc) (later_spells sc))
    (last_friction (first_spell sc) (later_spells sc)) U x v1 v2 /\
  cont x2 /\ (forall t, 0 <= t -> rderiv x2 t (v2 t)) /\
  x 0 = Q2R (x_0 sc) /\ v1 0 = Q2R (v1_0 sc) /\ x2 0 = Q2R (x2_0 sc) /\ v2 0 = Q2R (v2_0 sc).

(** slipping with v1 > v2 ([true]) or v1 < v2 ([false]); or sticking *)
Inductive mode := Slip (ahead : bool) | Stick.

(** what it says of the two velocities *)
Definition in_mode m v1 v2 := match m with Slip true => v2 < v1 | Slip false => v1 < v2 | Stick => v1 = v2 end.

(** an event: the mode that ends with it, the bounds of its time, of both places there and of the common velocity *)
Record event := Event { mode_until : mode; time : Q * Q; place : Q * Q; place2 : Q * Q; speed : Q * Q }.

(** the end: the mode, the time, the bounds of the state and of v1 - v2, and whether the pair sticks from then on *)
Record ending := Ending { last_mode : mode; last : Q; last_place : Q * Q; last_v1 : Q * Q; last_place2 : Q * Q;
  last_v2 : Q * Q; last_relative : Q * Q; for_ever : bool }.

(** between two rationals *)
Definition within (i : Q * Q) r := Q2R (fst i) <= r <= Q2R (snd i).

(** From t on the motion runs through the events and comes to the end: between two events it is in the mode that is
    said, at every time; at an event both velocities are equal. *)
Fixpoint unfolds (x v1 x2 v2 : R -> R) (t : R) (events : list event) (e : ending) : Prop :=
  match events with
  | now :: later => exists t', t < t' /\ within (time now) t' /\ within (place now) (x t') /\
    within (place2 now) (x2 t') /\ within (speed now) (v1 t') /\ v1 t' = v2 t' /\
    (forall u, t < u < t' -> in_mode (mode_until now) (v1 u) (v2 u)) /\ unfolds x v1 x2 v2 t' later e
  | [] => t < Q2R (last e) /\ (forall u, t < u <= Q2R (last e) -> in_mode (last_mode e) (v1 u) (v2 u)) /\
      within (last_place e) (x (Q2R (last e))) /\ within (last_v1 e) (v1 (Q2R (last e))) /\
      within (last_place2 e) (x2 (Q2R (last e))) /\ within (last_v2 e) (v2 (Q2R (last e))) /\
      within (last_relative e) (v1 (Q2R (last e)) - v2 (Q2R (last e))) /\
      (for_ever e = true -> forall u, Q2R (last e) < u -> v1 u = v2 u)
  end.

(** the mode until the next event *)
Definition current events e := match events with now :: _ => mode_until now | [] => last_mode e end.
(** what lasts longer *)
Lemma unfolds_earlier x v1 x2 v2 t t' events e : t < t' ->
  (forall u, t < u <= t' -> in_mode (current events e) (v1 u) (v2 u)) -> unfolds x v1 x2 v2 t' events e ->
  unfolds x v1 x2 v2 t events e.
Proof.
  intros Ht M. destruct events as [|now later]; cbn [unfolds current] in *.
  - intros (Hl & Q & Rest). split; [lra|]. split; [|auto]. intros u Hu. destruct (Rle_dec u t'); [apply M|apply Q]; lra.
  - intros (r & Hr & A & B & C & D & E & Q & Rest). exists r. split; [lra|]. repeat (split; [assumption|]).
    split; [|auto]. intros u Hu. destruct (Rle_dec u t'); [apply M|apply Q]; lra.
Qed.

(** *** Spells *)
Section Spells.
Context (M1 M2 A1 A2 : R) (Hm1 : 0 < M1) (Hm2 : 0 < M2) (Ha1 : 0 <= A1) (Ha2 : 0 < A2).

(** a motion of constant friction from a time on, along which x, v1 and v2 run for the time d *)
Lemma forced_obeys B f U y w1 w2 s x v1 v2 S d : 0 < B -> 0 <= S -> forced M1 M2 A1 A2 B U y w1 w2 s ->
  (forall t, 0 <= t < d -> rderiv U t (sval real f (S + t))) ->
  (forall t, 0 <= t <= d -> x (S + t) = y t /\ v1 (S + t) = w1 t /\ v2 (S + t) = w2 t) ->
  obeys M1 M2 A1 A2 B f S (S + d) x v1 v2.
Proof.
  intros HB HS F DU E t0 T X V1 V2 g Ht HT Hd A X0 V10 V20 u Hu.
  destruct (E (t0 - S) ltac:(lra)) as (P0 & P1 & P2). destruct (E (t0 - S + u) ltac:(lra)) as (Q0 & Q1 & Q2).
  replace (S + (t0 - S)) with t0 in * by ring. replace (S + (t0 - S + u)) with (t0 + u) in * by ring.
  rewrite Q0, Q1, Q2. apply (follow_arc M1 M2 A1 A2 B Hm1 Hm2 Ha1 Ha2 HB U (fun u => sval real f (t0 + u))
    y w1 w2 s X V1 V2 g T (t0 - S)); auto; try lra; try congruence.
  intros t Hr. replace (t0 + (t - (t0 - S))) with (S + t) by ring. apply DU. lra.
Qed.

(** from every state another motion runs beside it, and the two are never further apart than at first *)
Definition beside B f lo hi (x v1 v2 : R -> R) := forall t0 X V1 V2, lo <= t0 <= hi -> exists y w1 y2 w2,
  (y t0 = X /\ w1 t0 = V1 /\ y2 t0 = 0 /\ w2 t0 = V2) /\ obeys M1 M2 A1 A2 B f t0 hi y w1 w2 /\
  cont y2 /\ (forall t, 0 <= t -> rderiv y2 t (w2 t)) /\
  forall t, t0 <= t <= hi ->
  energy M1 M2 A2 (x t - y t) (v1 t - w1 t) (v2 t - w2 t) <= energy M1 M2 A2 (x t0 - X) (v1 t0 - V1) (v2 t0 - V2).
(** both *)
Definition follows B f lo hi x v1 v2 := obeys M1 M2 A1 A2 B f lo hi x v1 v2 /\ beside B f lo hi x v1 v2.

Lemma forced_follows B f U y w1 w2 s x v1 v2 S d : 0 < B -> 0 <= S -> forced M1 M2 A1 A2 B U y w1 w2 s ->
  (forall t, 0 <= t < d -> rderiv U t (sval real f (S + t))) ->
  (forall t, 0 <= t <= d -> x (S + t) = y t /\ v1 (S + t) = w1 t /\ v2 (S + t) = w2 t) ->
  follows B f S (S + d) x v1 v2.
Proof.
  intros HB HS F DU E. split; [eapply forced_obeys; eauto|]. intros t0 X V1 V2 Ht. set (r := t0 - S).
  assert (Hr : 0 <= r <= d) by (unfold r; lra). replace t0 with (S + r) in * by (unfold r; ring).
  pose proof (forced_shift M1 M2 A1 A2 B U y w1 w2 s r ltac:(lra) F) as Sh.
  destruct (forced_existence M1 M2 A1 A2 B X V1 V2 _ Hm1 Hm2 Ha1 Ha2 HB (f_cU _ _ _ _ _ _ _ _ _ _ Sh))
    as (z & u1 & u2 & s' & G & Z0 & U10 & U20).
  set (late := fun (h : R -> R) t => h (Rmax 0 (t - (S + r)))).
  assert (L : forall h t, 0 <= t -> late h (S + r + t) = h t).
  { intros h t Hh. unfold late. rewrite Rmax_right by lra. f_equal. ring. }
  assert (C : cont (late u2)).
  { apply cont_path with (c := fun t => Rmax 0 (t - (S + r))); [intros; apply Rmax_l| |
      exact (moves_cv2 M1 M2 A1 A2 B Hm2 _ _ _ _ _ _ G)].
    intros p q. unfold Rmax. repeat destruct Rle_dec; unfold Rabs; repeat destruct Rcase_abs; lra. }
  exists (late z), (late u1), (fun t => integral (late u2) t - integral (late u2) (S + r)), (late u2).
  split; [|split; [|split; [|split]]].
  - rewrite <- (Rplus_0_r (S + r)), !L by lra. repeat split; auto; lra.
  - replace (S + d) with (S + r + (d - r)) by ring. eapply forced_obeys; eauto; [lra| |]; intros t Hu.
    + rewrite Rplus_assoc. apply rderiv_earlier, DU. lra.
    + rewrite !L by lra. auto.
  - continuous.
  - intros t Hu. rate. ring.
  - intros t Hu. replace t with (S + r + (t - (S + r))) by ring. set (u := t - (S + r)).
    assert (Hu' : 0 <= u <= d - r) by (unfold u; lra).
    pose proof (forced_contraction M1 M2 A1 A2 B Hm1 Hm2 Ha1 HB _ _ _ _ _ _ _ _ _ 0 u Sh G ltac:(lra)) as Q.
    cbv beta in Q. rewrite Rplus_0_r in Q. rewrite !L, Rplus_assoc by lra.
    destruct (E r Hr) as (-> & -> & ->), (E (r + u) ltac:(lra)) as (-> & -> & ->). rewrite <- Z0, <- U10, <- U20.
    exact Q.
Qed.

(** spell after spell *)
Fixpoint runs x v1 v2 now later : Prop := 0 < Q2R (friction now) /\ 0 <= Q2R (since now) /\ match later with
  | next :: later => Q2R (since now) < Q2R (since next) /\
      follows (Q2R (friction now)) (in_R (push now)) (Q2R (since now)) (Q2R (since next)) x v1 v2 /\
      runs x v1 v2 next later
  | [] => forall hi, follows (Q2R (friction now)) (in_R (push now)) (Q2R (since now)) hi x v1 v2 end.

(** all have a friction, one after the other *)
Fixpoint in_order now later : Prop := 0 < Q2R (friction now) /\ 0 <= Q2R (since now) /\ match later with
  | next :: later => Q2R (since now) < Q2R (since next) /\ in_order next later | [] => True end.

(** U, x', v1' and v2' run from the time at which the first spell begins *)
Lemma varying_runs x v1 v2 later : forall now U x' v1' v2', in_order now later ->
  (forall t, 0 <= t -> rderiv U t (force_at now later (Q2R (since now) + t))) ->
  (forall t, 0 <= t ->
    x (Q2R (since now) + t) = x' t /\ v1 (Q2R (since now) + t) = v1' t /\ v2 (Q2R (since now) + t) = v2' t) ->
  varying M1 M2 A1 A2 (pieces now later) (last_friction now later) U x' v1' v2' -> runs x v1 v2 now later.
Proof.
  induction later as [|next later IH]; intros now U x' v1' v2' O DU E V.
  - destruct O as (Hb & Hs & _). split; [auto|]. split; [auto|]. intros hi. destruct V as (s & F).
    destruct (Rle_dec (Q2R (since now)) hi) as [Hh|Hh].
    + replace hi with (Q2R (since now) + (hi - Q2R (since now))) by ring.
      apply (forced_follows _ _ U x' v1' v2' s); auto; intros t Ht; [apply DU|apply E]; lra.
    + split; [intros t0 T X V1 V2 g Ht HT Hd|intros t0 X V1 V2 Ht]; exfalso; lra.
  - destruct O as (Hb & Hs & Hn & O). split; [auto|]. split; [auto|]. split; [auto|].
    destruct V as ((y & w1 & w2 & s & F & K) & V). set (d := Q2R (since next) - Q2R (since now)) in *. split.
    + replace (Q2R (since next)) with (Q2R (since now) + d) by (unfold d; ring).
      apply (forced_follows _ _ U y w1 w2 s); auto; intros t Ht.
      * specialize (DU t ltac:(lra)). simpl in DU. destruct Rlt_dec in DU; [exact DU|unfold d in Ht; lra].
      * destruct (K t Ht) as (<- & <- & <-). apply E. lra.
    + assert (Hd : forall t, Q2R (since now) + (d + t) = Q2R (since next) + t) by (intros; unfold d; ring).
      refine (IH next _ _ _ _ O _ _ V); intros t Ht; rewrite <- Hd.
      * apply rderiv_earlier. eapply rderiv_eq; [|apply DU; unfold d; lra]. simpl. rewrite Hd.
        destruct Rlt_dec; [lra|auto].
      * apply E. unfold d. lra.
Qed.
End Spells.

(** *** Answers *)
(** rational numbers; their sines are not asked for *)
Definition rational := Arith 0%Q Qplus Qminus Qmult Qdiv Qopp (fun q => q) (fun q => q).
Lemma in_R_padd l : forall k, map Q2R (padd rational l k) = padd real (map Q2R l) (map Q2R k).
Proof. induction l as [|c l IH]; intros [|d k]; auto. cbn [padd map]. rewrite IH. rewrite Q2R_plus. auto. Qed.
Lemma in_R_dpoly l : map Q2R (dpoly rational l) = dpoly real (map Q2R l).
Proof.
  induction l as [|c [|d l] IH]; auto. change (dpoly rational (c :: d :: l)) with
    (padd rational (d :: l) (0%Q :: dpoly rational (d :: l))). rewrite in_R_padd. cbn [map] in *. rewrite IH.
  rewrite RMicromega.Q2R_0. reflexivity.
Qed.
Lemma pval_times c l u : pval real (map Q2R (map (Qmult c) l)) u = Q2R c * pval real (map Q2R l) u.
Proof. induction l as [|d l IH]; cbn [map]; rewrite ?pval_cons, ?IH, ?Q2R_mult; [unfold pval; simpl|]; ring. Qed.
(** coefficients that are all 0 *)
Definition vanishes := forallb (Qeq_bool 0).
Lemma vanishes_spec l u : vanishes l = true -> pval real (map Q2R l) u = 0.
Proof.
  induction l as [|c l IH]; auto. cbn [vanishes forallb map]. intros E. apply andb_true_iff in E. destruct E as (E & F).
  rewrite pval_cons, IH by auto. apply Qeq_bool_iff, Qeq_eqR in E. lra.
Qed.
(** m y'' + a1 y' + a2 y = f *)
Fixpoint tones_answer m a1 a2 (ys fs : list (tone Q)) : bool := match ys, fs with
  | y :: ys, f :: fs => let y' := dtone rational y in let y'' := dtone rational y' in
      Qeq_bool (turn y) (turn f) && Qeq_bool (phase y) (phase f) &&
      forallb (fun part => Qeq_bool (m * part y'' + a1 * part y' + a2 * part y) (part f))
        [in_sine (T := Q); in_cosine (T := Q); rise_sine (T := Q); rise_cosine (T := Q)] && tones_answer m a1 a2 ys fs
  | [], [] => true | _, _ => false end.
(** the same of all of an answer *)
Definition is_answer m a1 a2 (y f : steady Q) := let l := poly y in
  let l' := dpoly rational l in
  Qeq_bool (from y) (from f) && tones_answer m a1 a2 (tones y) (tones f) &&
  vanishes (padd rational (map (Qmult m) (dpoly rational l')) (padd rational (map (Qmult a1) l')
    (padd rational (map (Qmult a2) l) (map (Qmult (-1)) (poly f))))).
Lemma is_answer_spec m a1 a2 y f : is_answer m a1 a2 y f = true -> answers (Q2R m) (Q2R a1) (Q2R a2) (in_R y) (in_R f).
Proof.
  intros E. apply andb_true_iff in E. destruct E as (E & V). apply andb_true_iff in E. destruct E as (E & W). intros t.
  apply Qeq_bool_iff, Qeq_eqR in E. apply (vanishes_spec _ (t - Q2R (from f))) in V.
  rewrite !in_R_padd, !pval_padd, !pval_times, !in_R_dpoly in V. unfold sval, dsteady, in_R.
  cbn [from poly tones add sub real]. rewrite E. revert V.
  generalize (pval real (dpoly real (dpoly real (map Q2R (poly y)))) (t - Q2R (from f))).
  generalize (pval real (dpoly real (map Q2R (poly y))) (t - Q2R (from f))).
  generalize (pval real (map Q2R (poly y)) (t - Q2R (from f))).
  generalize (pval real (map Q2R (poly f)) (t - Q2R (from f))). intros p0 p1 p2 p3 V. revert W. generalize (tones f).
  induction (tones y) as [|z zs IH]; intros [|w ws]; cbn [tones_answer map fold_right];
    try discriminate; [intros _; lra|]. intros W. cbn [forallb] in W. rewrite !andb_true_iff in W.
  destruct W as (((W & P) & S & C & S' & C' & _) & Rest). rewrite <- (IH ws Rest).
  apply Qeq_bool_iff, Qeq_eqR in W, P, S, C, S', C'.
  cbn [dtone in_sine in_cosine rise_sine rise_cosine turn phase add sub neg mul rational] in S, C, S', C'.
  unfold tval; simpl. rewrite <- W, <- P, <- S, <- C, <- S', <- C'.
  repeat first [rewrite Q2R_plus | rewrite Q2R_mult | rewrite Q2R_minus | rewrite Q2R_opp]. ring.
Qed.

(** *** The program *)
(** A motion that is close: its state at the time [start], and how far, in the energy norm, ours was from it then. *)
Record close := Close { start_at : Q; start_x : Q; start_v1 : Q; start_v2 : Q; radius : Q }.
(** What comes with a rest: nothing; a stick that breaks; a new close motion, with the events of the one before since its
    start: mode, bounds of the time since the event before, which way a stick ends. *)
Inductive rests := Goes | Breaks | Renews (steps : list (mode * Q * Q * bool)) (new : close).
(** what helps it, event by event: in how many bits; an event, with bounds of the time since the one before or since a
    rest, and which way a stick ends; a rest at a time, where the spell may end, and a stick may break, and for how long
    the mode before it surely lasts; the end; a time until which it then still sticks as long, and then for ever *)
Inductive hint := Hit (bits : positive) (least most : Q) (towards : bool)
  | Rest (bits : positive) (until least : Q) (which : rests) | Last (bits : positive) (least : Q)
  | Ever (bits : positive) (until least : Q).

(** the triangle inequality of the energy norm *)
Lemma energy_triangle m1 m2 a2 x v1 v2 y w1 w2 p q : 0 <= m1 -> 0 <= m2 -> 0 <= a2 -> 0 < p -> 0 < q ->
  energy m1 m2 a2 x v1 v2 <= p ^ 2 -> energy m1 m2 a2 y w1 w2 <= q ^ 2 ->
  energy m1 m2 a2 (x + y) (v1 + w1) (v2 + w2) <= (p + q) ^ 2.
Proof.
  intros H1 H2 H3 Hp Hq E F. assert (S : 0 <= energy m1 m2 a2 (q * x - p * y) (q * v1 - p * w1) (q * v2 - p * w2)).
  { unfold energy. positive. }
  apply (Rmult_le_compat_l (q * (p + q))) in E; [|positive]. apply (Rmult_le_compat_l (p * (p + q))) in F; [|positive].
  apply Rmult_le_reg_l with (p * q); [positive|]. unfold energy in *. lra.
Qed.

(** what is known of a state beside bounds: nothing; a contact; the edge on which a stick has ended *)
Inductive start := Off | Touch | Edge (ahead : bool).

(** the rational numbers that are checked to be positive, or in order *)
Definition posQ q := (0 <? Qnum q)%Z.
Lemma posQ_spec q : posQ q = true -> 0 < Q2R q.
Proof. intros H. apply Z.ltb_lt in H. rewrite <- RMicromega.Q2R_0. apply Qlt_Rlt. unfold Qlt. simpl. lia. Qed.
(** not negative *)
Definition nonnegQ q := (0 <=? Qnum q)%Z.
Lemma nonnegQ_spec q : nonnegQ q = true -> 0 <= Q2R q.
Proof. intros H. apply Z.leb_le in H. rewrite <- RMicromega.Q2R_0. apply Qle_Rle. unfold Qle. simpl. lia. Qed.
(** the middle of two *)
Definition mid p q := Qred ((p + q) * (1 # 2)).
Lemma mid_spec p q : Q2R (mid p q) = (Q2R p + Q2R q) / 2.
Proof. unfold mid. rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_mult, Q2R_plus. unfold Q2R at 3; simpl. field. Qed.

Module Check (I : IntervalOps).
Module J := IntervalExt I.

(** the interval has the number *)
Definition has i r := contains (I.convert i) (Xreal r).

(** a wave of intervals, with the sign of the square of its frequency, which is known exactly, and the frequency *)
Record bounded := Bounded { parts : wave I.type; side : comparison; root : I.type }.

(** whether damping is below (Gt), at or beyond its critical value *)
Definition on_side c d := match c with Gt => 0 < d | Eq => d = 0 | Lt => d < 0 end.

(** the intervals have the numbers *)
Record has_tone (Z : tone I.type) (z : tone R) : Prop := { h_in_sine : has (in_sine Z) (in_sine z);
  h_in_cosine : has (in_cosine Z) (in_cosine z); h_rise_sine : has (rise_sine Z) (rise_sine z);
  h_rise_cosine : has (rise_cosine Z) (rise_cosine z); h_turn : has (turn Z) (turn z); h_phase : has (phase Z) (phase z) }.
(** of a force *)
Record has_steady (Y : steady I.type) (y : steady R) : Prop := { h_from : has (from Y) (from y);
  h_poly : Forall2 has (poly Y) (poly y); h_tones : Forall2 has_tone (tones Y) (tones y) }.
(** the wave of intervals has the wave *)
Record has_parts (F f : wave _) : Prop := { h_still : has (still F) (still f);
  h_drift : has (drift F) (drift f); h_even : has (even F) (even f); h_odd : has (odd F) (odd f);
  h_decay : has (decay F) (decay f); h_square : has (square F) (square f); h_clock : has (clock F) (clock f);
  h_answer : has_steady (answer F) (answer f) }.
(** with its frequency *)
Record has_wave (F : bounded) (f : wave R) : Prop := { h_parts : has_parts (parts F) f;
  h_side : on_side (side F) (square f); h_root : has (root F) (sqrt (Rabs (square f))) }.
(** of a pair *)
Record has_kit (K : kit I.type) (k : kit R) : Prop := { h_k1 : has (k1 K) (k1 k); h_k2 : has (k2 K) (k2 k);
  h_kM : has (kM K) (kM k); h_ka1 : has (ka1 K) (ka1 k); h_ka2 : has (ka2 K) (ka2 k); h_kb : has (kb K) (kb k);
  h_slow1 : has (slow1 K) (slow1 k); h_stiff1 : has (stiff1 K) (stiff1 k); h_slowM : has (slowM K) (slowM k);
  h_stiffM : has (stiffM K) (stiffM k); h_answer1 : has_steady (answer1 K) (answer1 k);
  h_answerM : has_steady (answerM K) (answerM k); h_force : has_steady (force K) (force k) }.

(** known to be positive *)
Definition pos i := match I.sign_strict i with Xgt => true | _ => false end.
(** known not to be negative *)
Definition nonneg i := match I.sign_large i with Xgt | Xeq => true | _ => false end.

Lemma pos_spec i r : pos i = true -> has i r -> 0 < r.
Proof.
  unfold pos, has. pose proof (I.sign_strict_correct i) as C. destruct I.sign_strict; try discriminate.
  intros _ H. exact (proj2 (C _ H)).
Qed.
Lemma nonneg_spec i r : nonneg i = true -> has i r -> 0 <= r.
Proof.
  unfold nonneg, has. pose proof (I.sign_large_correct i) as C. destruct I.sign_large; try discriminate; intros _ H.
  - specialize (C _ H). injection C as ->. lra.
  - exact (proj2 (C _ H)).
Qed.

Section Precision.
Variable p : I.precision.

(** the rational number *)
Definition rat q := I.div p (I.fromZ p (Qnum q)) (I.fromZ p (Zpos (Qden q))).
(** the rational numbers between two *)
Definition hull q r := I.join (rat q) (rat r).
(** sines and cosines of a short interval: by its middle and their slope, which takes half the time *)
Definition by_slope (f : I.type -> I.type) i := let c := I.singleton (I.midpoint i) in let d := I.sub p i c in
  if pos (I.add p (rat (1 # 4096)) d) then if pos (I.sub p (rat (1 # 4096)) d) then
    I.add p (f c) (I.mul p d (hull (-1) 1)) else f i else f i.
Definition sin_by := by_slope (I.sin p).
Definition cos_by := by_slope (I.cos p).
(** intervals *)
Definition boxes := Arith I.zero (I.add p) (I.sub p) (I.mul p) (I.div p) I.neg sin_by cos_by.
(** a force *)
Definition in_I (y : steady Q) := Steady (rat (from y)) (map rat (poly y)) (map (fun z =>
  Tone (rat (in_sine z)) (rat (in_cosine z)) (rat (rise_sine z)) (rat (rise_cosine z)) (rat (turn z)) (rat (phase z)))
    (tones y)).

Lemma has_rat q : has (rat q) (Q2R q).
Proof. apply J.div_correct; apply I.fromZ_correct. Qed.
Lemma has_hull q r u : Q2R q <= u <= Q2R r -> has (hull q r) u.
Proof. intros Hu. exact (J.join_correct _ _ _ _ _ (has_rat q) (has_rat r) Hu). Qed.
Lemma has_by_slope f (g g' : R -> R) i r : (forall i r, has i r -> has (f i) (g r)) ->
  (forall x, is_derive g x (g' x) /\ -1 <= g' x <= 1) -> has i r -> has (by_slope f i) (g r).
Proof.
  intros F D Hi. unfold by_slope. destruct (pos _); auto. destruct (pos _); auto.
  pose proof (I.singleton_correct (I.midpoint i)) as Hc. set (c := proj_val _) in Hc.
  destruct (MVT_gen g c r g') as (z & _ & E); [intros; apply D| |].
  { intros. apply derivable_continuous_pt. eexists. apply is_derive_Reals, D. }
  replace (g r) with (g c + (r - c) * g' z) by lra.
  refine (J.add_correct p _ _ _ _ (F _ _ Hc) (J.mul_correct p _ _ _ _ (J.sub_correct p _ _ _ _ Hi Hc) _)).
  apply has_hull. pose proof (proj2 (D z)). lra.
Qed.
Lemma has_sin_by i r : has i r -> has (sin_by i) (sin r).
Proof.
  apply (has_by_slope _ _ cos); [apply J.sin_correct|]. intros x.
  split; [apply is_derive_Reals, derivable_pt_lim_sin|apply COS_bound].
Qed.
Lemma has_cos_by i r : has i r -> has (cos_by i) (cos r).
Proof.
  apply (has_by_slope _ _ (fun x => - sin x)); [apply J.cos_correct|]. intros x.
  split; [apply is_derive_Reals, derivable_pt_lim_cos|pose proof (SIN_bound x); lra].
Qed.

(** what a swing is made of at a time; beyond the critical damping two exponentials, which are bounded one by one *)
Definition swung F u :=
  let f := parts F in let w := root F in
  let faded g := I.exp p (I.neg (I.mul p g u)) in
  match side F with
  | Gt => let phase := I.mul p w u in let e := faded (decay f) in
      (I.mul p e (cos_by phase), I.mul p e (I.div p (sin_by phase) w))
  | Eq => let e := faded (decay f) in (e, I.mul p e u)
  | Lt => (faded (I.sub p (decay f) w), faded (I.add p (decay f) w))
  end.
(** sine and cosine of its tones *)
Definition sung F u := let t := I.add p (clock (parts F)) u in
  map (fun z => let a := I.add p (I.mul p (turn z) t) (phase z) in (sin_by a, cos_by a)) (tones (answer (parts F))).
(** a sum of tones at the time t *)
Fixpoint chord t (i : I.type) zs bs := match zs, bs with
  | z :: zs, (s, c) :: bs => I.add p (I.add p (I.mul p (I.add p (in_sine z) (I.mul p (rise_sine z) t)) s)
      (I.mul p (I.add p (in_cosine z) (I.mul p (rise_cosine z) t)) c)) (chord t i zs bs)
  | _, _ => i end.
(** the value of a wave, from these *)
Definition made F u b bs :=
  let f := parts F in
  let swinging := match side F with
  | Lt => let half := rat (1 # 2) in let other := I.div p (odd f) (root F) in
      I.add p (I.mul p (I.mul p half (I.add p (even f) other)) (fst b))
        (I.mul p (I.mul p half (I.sub p (even f) other)) (snd b))
  | _ => I.add p (I.mul p (even f) (fst b)) (I.mul p (odd f) (snd b)) end in
  I.add p (I.add p (I.add p (still f) (I.mul p (drift f) u)) swinging)
    (let t := I.add p (clock f) u in
      chord t (pval boxes (poly (answer f)) (I.sub p t (from (answer f)))) (tones (answer f)) bs).
(** the value of a wave *)
Definition value F u := made F u (swung F u) (sung F u).
(** its derivative *)
Definition steep F := Bounded (sloped boxes (parts F)) (side F) (root F).

(** what is computed has what is meant *)
Ltac has := cbn [add sub mul div neg zero sin_of cos_of real boxes]; repeat first [assumption | apply has_rat
  | apply J.zero_correct | apply J.add_correct | apply J.sub_correct
  | apply J.mul_correct | apply J.div_correct | apply J.neg_correct | apply J.sqrt_correct | apply J.exp_correct
  | apply has_cos_by | apply has_sin_by].

Lemma has_map {S T U V} (P : S -> T -> Prop) (Q : U -> V -> Prop) f g l k : (forall x y, P x y -> Q (f x) (g y)) ->
  Forall2 P l k -> Forall2 Q (map f l) (map g k).
Proof. intros E. induction 1; constructor; auto. Qed.
Lemma has_in_I y : has_steady (in_I y) (in_R y).
Proof.
  constructor; cbn [from poly tones in_I in_R]; [has| |].
  - induction (poly y); constructor; auto. apply has_rat.
  - induction (tones y); constructor; auto. constructor; apply has_rat.
Qed.
Lemma has_pval L l i u : Forall2 has L l -> has i u -> has (pval boxes L i) (pval real l u).
Proof. intros H Hu. induction H; unfold pval in *; cbn [fold_right]; has. Qed.
Lemma has_padd L l : Forall2 has L l -> forall K k, Forall2 has K k -> Forall2 has (padd boxes L K) (padd real l k).
Proof. induction 1; intros K k HK; [destruct HK; constructor; auto|]. destruct HK; constructor; auto. has. Qed.
Lemma has_dpoly L l : Forall2 has L l -> Forall2 has (dpoly boxes L) (dpoly real l).
Proof.
  induction 1 as [|C c L l Hc H IH]; [constructor|]. destruct H as [|D d L l Hd H]; [constructor|].
  exact (has_padd _ _ (Forall2_cons _ _ Hd H) _ _ (Forall2_cons _ _ (J.zero_correct : has I.zero 0) IH)).
Qed.
Lemma has_dsteady Y y : has_steady Y y -> has_steady (dsteady boxes Y) (dsteady real y).
Proof.
  intros []. constructor; cbn [from poly tones dsteady]; auto using has_dpoly. apply (has_map has_tone); auto.
  intros Z z []. constructor; cbn [in_sine in_cosine rise_sine rise_cosine turn phase dtone]; has.
Qed.
Lemma has_scaled F f Y y : (forall i r, has i r -> has (F i) (f r)) -> has_steady Y y ->
  has_steady (scaled F Y) (scaled f y).
Proof.
  intros E []. constructor; cbn [from poly tones scaled]; auto; [apply (has_map has); auto|].
  apply (has_map has_tone); auto. intros Z z []. constructor; simpl; auto.
Qed.
Lemma has_sval Y y i t : has_steady Y y -> has i t -> has (sval boxes Y i) (sval real y t).
Proof.
  intros [Hf Hp Ht] Hi. unfold sval. induction Ht as [|Z z L l [] H IH]; cbn [fold_right].
  - apply has_pval; has.
  - unfold tval. has.
Qed.
Lemma has_signed k i r : has i r -> has (signed boxes k i) (signed real k r).
Proof. intros H. destruct k; simpl; has. Qed.
Lemma has_swing G g D d C c Y y T t X x V v : has G g -> has D d -> has C c -> has_steady Y y -> has T t -> has X x ->
  has V v -> has_parts (swing boxes G D C Y T X V) (swing real g d c y t x v).
Proof.
  intros HG HD HC HY HT HX HV. pose proof (has_sval Y y T t HY HT).
  pose proof (has_sval _ _ T t (has_dsteady Y y HY) HT).
  constructor; cbn [swing still drift even odd decay square clock answer]; has; auto.
Qed.
Lemma has_sloped F f : has_parts F f -> has_parts (sloped boxes F) (slope f).
Proof.
  intros []. constructor; cbn [still drift even odd decay square clock answer sloped]; auto using has_dsteady; has.
Qed.

End Precision.
Ltac has :=
  cbn [add sub mul div neg zero sin_of cos_of real boxes still drift even odd decay square clock answer];
  repeat first [assumption | apply has_rat | apply J.zero_correct | apply J.add_correct | apply J.sub_correct
  | apply J.mul_correct | apply J.div_correct | apply J.neg_correct | apply J.sqrt_correct | apply J.exp_correct
  | apply has_cos_by | apply has_sin_by | apply has_signed | apply has_sval | apply has_scaled; intros].

(** a swing beyond the critical damping *)
Lemma two_exponentials g w even odd u : 0 < w ->
  exp (- (g * u)) * (even * cosh (w * u) + odd * (sinh (w * u) / w)) =
  Q2R (1 # 2) * (even + odd / w) * exp (- ((g - w) * u)) + Q2R (1 # 2) * (even - odd / w) * exp (- ((g + w) * u)).
Proof.
  intros Hw. replace (- ((g - w) * u)) with (- (g * u) + w * u) by ring.
  replace (- ((g + w) * u)) with (- (g * u) + - (w * u)) by ring. rewrite !exp_plus. unfold cosh, sinh, Q2R; simpl.
  field; lra.
Qed.
(** frequencies and phases *)
Definition angles (f : wave R) := map (fun z => (turn z, phase z)) (tones (answer f)).
(** what a swing is made of *)
Definition has_swung c g d u (b : I.type * I.type) := match c with
  | Lt => has (fst b) (exp (- ((g - sqrt (Rabs d)) * u))) /\ has (snd b) (exp (- ((g + sqrt (Rabs d)) * u)))
  | _ => has (fst b) (exp (- (g * u)) * cosine d u) /\ has (snd b) (exp (- (g * u)) * sine d u) end.
(** sines and cosines *)
Definition has_sung t := Forall2 (fun (b : I.type * I.type) (z : R * R) =>
  has (fst b) (sin (fst z * t + snd z)) /\ has (snd b) (cos (fst z * t + snd z))).
Lemma swung_spec p F f u i : has_wave F f -> has i u -> has_swung (side F) (decay f) (square f) u (swung p F i).
Proof.
  intros [[] S W] Hu. unfold swung, has_swung, cosine, sine. destruct (side F); simpl in S; cbn [fst snd];
    repeat (destruct Rlt_dec; try lra); rewrite ?Rmult_1_r; split; has.
Qed.
Lemma sung_spec p F f u i : has_wave F f -> has i u -> has_sung (clock f + u) (sung p F i) (angles f).
Proof.
  intros [[] _ _] Hu. unfold sung, angles, has_sung. apply (has_map has_tone); [|apply h_answer0]. intros Z z [].
  split; has.
Qed.
Lemma has_made p F f u i b bs : has_wave F f -> has i u -> has_swung (side F) (decay f) (square f) u b ->
  has_sung (clock f + u) bs (angles f) -> has (made p F i b bs) (val f u).
Proof.
  intros [[] S W] Hu Hb Hs. unfold made, val. apply J.add_correct.
  - apply J.add_correct; [has|]. unfold has_swung in Hb. destruct (side F); destruct Hb as (Hc & Hd).
    + rewrite Rmult_plus_distr_l, <- !Rmult_assoc, !(Rmult_comm (exp _)), !Rmult_assoc. has.
    + simpl in S. unfold cosine, sine. repeat (destruct Rlt_dec; try lra).
      rewrite two_exponentials by (apply frequency_sq; lra). has.
    + rewrite Rmult_plus_distr_l, <- !Rmult_assoc, !(Rmult_comm (exp _)), !Rmult_assoc. has.
  - destruct h_answer0 as [Hf Hp Ht]. unfold sval. unfold angles in Hs. revert bs Hs.
    induction Ht as [|Z z L l [] H IH]; intros bs Hs; cbn [fold_right map] in *.
    + destruct bs; apply has_pval; auto; has.
    + inversion Hs as [|B z' bs' l' (Hsin & Hcos) Hr]; subst. destruct B as (s, c). cbn [chord]. cbn [fst snd] in *.
      specialize (IH _ Hr). unfold tval. has.
Qed.
Lemma has_value p F f u i : has_wave F f -> has i u -> has (value p F i) (val f u).
Proof. intros. apply has_made; auto using swung_spec, sung_spec. Qed.
Lemma has_steep p F f : has_wave F f -> has_wave (steep p F) (slope f).
Proof. intros []. constructor; cbn [steep parts side root]; auto using has_sloped. Qed.
(** what a swing is made of serves all waves of a phase, and so the sines of its tones *)
Lemma has_shared p F f G g u i : has_wave F f -> has i u -> has_wave G g -> side G = side F -> decay g = decay f ->
  square g = square f -> clock g = clock f -> angles g = angles f -> has (made p G i (swung p F i) (sung p F i)) (val g u).
Proof.
  intros W Hi V S D Q C A.
  apply has_made; auto; [rewrite S, D, Q; apply swung_spec|rewrite C, A; apply sung_spec]; auto.
Qed.
Lemma angles_slope f : angles (slope f) = angles f.
Proof. unfold angles. cbn. rewrite map_map. reflexivity. Qed.

Section Program.
(** the precision of states, that of signs, and how often an interval is halved *)
Variables (p q : I.precision) (depth : nat).

(** *** Positive on an interval *)
(** between a and b, the values at both being positive: by its bounds, or rising, falling, concave, or convex and rising
    at first, or by halves *)
Fixpoint stays depth (F F' F'' : bounded) a b : bool :=
  let i := hull q a b in let swing := swung q F i in let sines := sung q F i in
  if pos (made q F i swing sines) then true else
  let d := made q F' i swing sines in
  if nonneg d then true else if nonneg (I.neg d) then true else
  let e := made q F'' i swing sines in
  if nonneg (I.neg e) then true else
  if (if nonneg e then nonneg (value q F' (rat q a)) else false) then true else
  match depth with
  | O => false
  | S depth => let c := mid a b in
      if pos (value q F (rat q c)) then if stays depth F F' F'' a c then stays depth F F' F'' c b else false else false
  end.

Lemma stays_spec n F f a b : has_wave F f -> stays n F (steep q F) (steep q (steep q F)) a b = true ->
  Q2R a <= Q2R b -> 0 < val f (Q2R a) -> 0 < val f (Q2R b) -> forall u, Q2R a <= u <= Q2R b -> 0 < val f u.
Proof.
  intros W. pose proof (has_steep q _ _ W) as W'. pose proof (has_steep q _ _ W') as W''. revert a b.
  assert (S' : forall i u, has i u -> has (made q (steep q F) i (swung q F i) (sung q F i)) (val (slope f) u)).
  { intros. apply (has_shared q F f); auto using angles_slope. }
  assert (S'' : forall i u, has i u ->
    has (made q (steep q (steep q F)) i (swung q F i) (sung q F i)) (val (slope (slope f)) u)).
  { intros. apply (has_shared q F f); auto. rewrite !angles_slope. auto. }
  induction n as [|n IH]; intros a b; cbn [stays]; cbv zeta; intros St Hab Pa Pb u Hu; revert St.
  all: destruct (pos (made q F _ _ _)) eqn:E0; [intros _; apply (pos_spec _ _ E0), has_value, has_hull; auto|].
  all: destruct (nonneg (made q (steep q F) _ _ _)) eqn:E1; [intros _; apply (rising_positive f (Q2R a) (Q2R b)); auto;
    intros r Hr; apply (nonneg_spec _ _ E1), S', has_hull; auto|].
  all: destruct (nonneg (I.neg (made q (steep q F) _ _ _))) eqn:E2;
    [intros _; apply (falling_positive f (Q2R a) (Q2R b)); auto; intros r Hr; apply Ropp_le_cancel; rewrite Ropp_0;
      apply (nonneg_spec _ _ E2), J.neg_correct, S', has_hull; auto|].
  all: destruct (nonneg (I.neg (made q (steep q (steep q F)) _ _ _))) eqn:E3;
    [intros _; apply (concave_positive f (Q2R a) (Q2R b)); auto; intros r Hr; apply Ropp_le_cancel; rewrite Ropp_0;
      apply (nonneg_spec _ _ E3), J.neg_correct, S'', has_hull; auto|].
  all: destruct (if nonneg (made q (steep q (steep q F)) _ _ _) then _ else false) eqn:E6;
    [intros _; destruct (nonneg (made q (steep q (steep q F)) _ _ _)) eqn:E7; [|discriminate];
      apply (convex_positive f (Q2R a) (Q2R b)); auto; [apply (nonneg_spec _ _ E6), has_value; auto; apply has_rat|
        intros r Hr; apply (nonneg_spec _ _ E7), S'', has_hull; auto]|].
  - discriminate.
  - destruct (pos (value q F (rat q (mid a b)))) eqn:E4; [|discriminate].
    destruct (stays n F (steep q F) (steep q (steep q F)) a (mid a b)) eqn:E5; [|discriminate]. intros St.
    assert (Pc : 0 < val f (Q2R (mid a b))) by (apply (pos_spec _ _ E4), has_value, has_rat; auto).
    destruct (Rle_dec u (Q2R (mid a b))).
    + apply (IH a (mid a b)); auto; lra.
    + apply (IH (mid a b) b); auto; lra.
Qed.

(** how long a wave is surely positive from now on, found by halves *)
Fixpoint early n (F : bounded) d : option Q :=
  if pos (value q F (hull q 0 d)) then Some d else match n with O => None | S n => early n F (mid 0 d) end.

Lemma early_spec n F f d e : has_wave F f -> early n F d = Some e -> 0 < Q2R d ->
  0 < Q2R e <= Q2R d /\ forall u, 0 <= u <= Q2R e -> 0 < val f u.
Proof.
  intros W. revert d. induction n as [|n IH]; intros d; cbn [early]; intros E Hd;
    destruct (pos (value q F (hull q 0 d))) eqn:E0.
  1, 3: injection E as <-; split; [lra|]; intros u Hu; apply (pos_spec _ _ E0), has_value, has_hull; auto;
    rewrite RMicromega.Q2R_0; auto.
  - discriminate.
  - pose proof (mid_spec 0 d) as Mid. destruct (IH (mid 0 d) E) as (Q & P); [lra|]. split; [lra|auto].
Qed.

(** positive after 0 up to b, whatever the start is *)
Definition begins how k F b at_b : bool :=
  let F' := steep q F in let F'' := steep q F' in
  posQ b && pos at_b &&
  match how with
  | Off => pos (value p F (rat p 0)) && stays depth F F' F'' 0 b
  | Touch => match early depth F' (mid 0 b) with
      | Some d => pos (value q F (rat q d)) && stays depth F F' F'' d b | None => false end
  | Edge k' => eqb k' k && match early depth F'' (mid 0 b) with
      | Some d => pos (value q F (rat q d)) && stays depth F F' F'' d b | None => false end
  end.

Lemma begins_spec how k F f b at_b : has_wave F f -> has at_b (val f (Q2R b)) -> begins how k F b at_b = true ->
  match how with Off => True | Touch => val f 0 = 0
  | Edge k' => k' = k -> val f 0 = 0 /\ val (slope f) 0 = 0 end -> 0 < Q2R b /\ 0 <= val f 0 /\ (forall u, 0 < u <= Q2R b -> 0 < val f u).
Proof.
  intros W Hb0 B At. pose proof (has_steep q _ _ W) as W'. pose proof (has_steep q _ _ W') as W''.
  unfold begins in B. rewrite !andb_true_iff in B. destruct B as ((Hb & Pb) & C). apply posQ_spec in Hb.
  apply pos_spec with (r := val f (Q2R b)) in Pb; [|auto]. split; auto. pose proof (mid_spec 0 b) as Mid.
  assert (Rest : forall d, 0 < Q2R d <= Q2R (mid 0 b) ->
    pos (value q F (rat q d)) && stays depth F (steep q F) (steep q (steep q F)) d b = true ->
    (forall u, 0 < u <= Q2R d -> 0 < val f u) -> forall u, 0 < u <= Q2R b -> 0 < val f u).
  { intros d Hd E Q u Hu. apply andb_true_iff in E. destruct E as (Pd & St).
    destruct (Rle_dec u (Q2R d)); [apply Q; lra|]. apply (stays_spec depth F f d b); auto; [lra| |lra].
    apply (pos_spec _ _ Pd), has_value, has_rat; auto. }
  destruct how as [| |k']; rewrite ?andb_true_iff in C.
  - destruct C as (P0 & St). apply pos_spec with (r := val f 0) in P0.
    + split; [lra|]. intros u Hu. apply (stays_spec depth F f 0 b); auto; rewrite ?RMicromega.Q2R_0; auto; lra.
    + apply has_value; auto. rewrite <- RMicromega.Q2R_0. apply has_rat.
  - rewrite At. split; [lra|]. destruct (early depth (steep q F) (mid 0 b)) as [d|] eqn:E; [|discriminate].
    destruct (early_spec _ _ _ _ _ W' E ltac:(lra)) as (Hd & Q). apply (Rest d); auto.
    apply leaves_zero; auto; lra.
  - destruct C as (Hk & C). destruct (At (eqb_prop _ _ Hk)) as (Z & S). split; [lra|].
    destruct (early depth (steep q (steep q F)) (mid 0 b)) as [d|] eqn:E; [|discriminate].
    destruct (early_spec _ _ _ _ _ W'' E ltac:(lra)) as (Hd & Q). apply (Rest d); auto. intros u Hu.
    destruct (val_mean f 0 u ltac:(lra)) as (c & Hc & Ef). assert (0 < val (slope f) c); [|nra].
    apply (leaves_zero (slope f) (Q2R d)); auto; lra.
Qed.


(** *** The pair *)
(** the numbers of the pair, and of both swings the sign of the square of the frequency, and the frequency *)
Record pair := Pair { numbers : kit I.type; side1 : comparison; root1 : I.type; sideM : comparison; rootM : I.type }.

(** how fast a swing of the mass m decays *)
Definition fadeQ sc m := Qred (a1 sc / (2 * m)).
(** the square of its frequency *)
Definition squareQ sc m := Qred (a2 sc / m - fadeQ sc m * fadeQ sc m).
(** the mass of both bodies *)
Definition both sc := (m1 sc + m2 sc)%Q.
(** all that is computed once, from how each mass answers to the force *)
Definition tuned sc now (ys : steady Q * steady Q) :=
  let d1 := squareQ sc (m1 sc) in let dM := squareQ sc (both sc) in
  Pair (Kit (rat p (m1 sc)) (rat p (m2 sc)) (rat p (both sc)) (rat p (a1 sc)) (rat p (a2 sc)) (rat p (friction now))
      (rat p (fadeQ sc (m1 sc))) (rat p d1) (rat p (fadeQ sc (both sc))) (rat p dM)
      (in_I p (fst ys)) (in_I p (snd ys)) (in_I p (push now)))
    (d1 ?= 0)%Q (I.sqrt p (I.abs (rat p d1))) (dM ?= 0)%Q (I.sqrt p (I.abs (rat p dM))).

(** a state: its time, places and velocities, and what else is known of it *)
Record state := State { at_t : I.type; at_x : I.type; at_v1 : I.type; at_x2 : I.type; at_v2 : I.type; how : start }.

(** the waves of a state *)
Definition slides K st k := Bounded (slide (boxes p) (numbers K) k (at_t st) (at_x st) (at_v1 st)) (side1 K) (root1 K).
(** its guard *)
Definition guards K st k f := Bounded (guard_of (boxes p) (numbers K) k (parts f) (at_v2 st)) (side1 K) (root1 K).
(** its stick *)
Definition sticks K st := Bounded (stuck (boxes p) (numbers K) (at_t st) (at_x st) (at_v1 st)) (sideM K) (rootM K).
(** what friction has left in it *)
Definition grips K k f := Bounded (grip_of (boxes p) (numbers K) k (parts f)) (sideM K) (rootM K).
(** the value of a wave next to a time at which it is known: a time d after [most], not before [least] *)
Definition near F known least most d := I.add p known (I.mul p (value q (steep q F) (hull p least most)) d).
Lemma has_near F f known least most i u : has_wave F f -> has known (val f (Q2R most)) -> Q2R least <= u <= Q2R most ->
  has i (u - Q2R most) -> has (near F known least most i) (val f u).
Proof.
  intros W Hk Hu Hi. destruct (MVT_gen (val f) (Q2R most) u (val (slope f))) as (c & Hc & E).
  { intros. apply derive_val. }
  { intros. apply derivable_continuous_pt. eexists. apply is_derive_Reals, derive_val. }
  rewrite Rmin_right, Rmax_left in Hc by lra.
  replace (val f u) with (val f (Q2R most) + val (slope f) c * (u - Q2R most)) by lra. unfold near.
  assert (has (value q (steep q F) (hull p least most)) (val (slope f) c)) by (apply has_value;
    [apply has_steep; auto|apply has_hull; lra]). has.
Qed.

(** inside the bounds *)
Definition inside i (c : Q * Q) := nonneg (I.sub p i (rat p (fst c))) && nonneg (I.sub p (rat p (snd c)) i).
(** known to touch *)
Definition touches h := match h with Off => false | _ => true end.
(** what is known of the friction that is left towards k in a stick: nothing, or that there is none yet *)
Definition held h k := match h with Edge k' => if eqb k' k then Touch else Off | _ => Off end.
(** not after the end of the spell *)
Definition fits final i := match final with Some q => nonneg (I.sub p (rat p q) i) | None => true end.
Definition upto final until := match final with Some q => Qle_bool until q | None => true end.
(** where body 2 is after the time u, the velocity being w then *)
Definition behind st w u := I.add p (at_x2 st) (I.mul p (I.mul p (rat p (1 # 2)) (I.add p (at_v2 st) w)) u).

(** the wave of body 1 in a mode, and the one that ends it where it comes to 0: the guard, or the grip towards k' *)
Definition path K st m := match m with Slip k => slides K st k | Stick => sticks K st end.
Definition front K st m k' f := match m with Slip k => guards K st k f | Stick => grips K k' f end.
(** the values of all waves of a phase at a time, from what one of them computes *)
Definition at_time F i := let b := swung p F i in let bs := sung p F i in fun G => made p G i b bs.
(** the mode lasts: until lo, where its front has the value at_lo; a stick does not end on the other side until hi *)
Definition keeps K st m k' f lo at_lo hi (on : bounded -> I.type) := match m with
  | Slip k => begins (how st) k (front K st m k' f) lo at_lo
  | Stick => let G := grips K (negb k') f in touches (how st) &&
      begins (held (how st) k') k' (front K st m k' f) lo at_lo &&
      begins (held (how st) (negb k')) (negb k') G hi (on G) end.
(** the state at the time t, after the time u, from the values of its waves *)
Definition moved K st m f t u (on : bounded -> I.type) h :=
  let x := on f in match m with
  | Slip k => let w := drive (boxes p) (numbers K) k (at_v2 st) u in
      State t x (if touches h then w else on (steep p f)) (behind st w u) w h
  | Stick => let v := on (steep p f) in
      State t match h with Edge k => edge (boxes p) (numbers K) k t v | _ => x end v
        (I.add p (at_x2 st) (I.sub p x (at_x st))) v h end.

(** the state at the next event, if the table is right about the mode until then *)
Definition step K final st m least most (k' : bool) : option state :=
  let u := hull p least most in let d := hull p (least - most) 0 in
  let f := path K st m in let F := front K st m k' f in let on := at_time F (rat p most) in
  if Qle_bool least most && fits final (I.add p (at_t st) (rat p most)) &&
    keeps K st m k' f least (near F (on F) least most (rat p (least - most))) most on && nonneg (I.neg (on F))
  then Some (moved K st m f (I.add p (at_t st) u) u (fun F => near F (on F) least most d)
    match m with Slip _ => Touch | Stick => Edge k' end) else None.

(** the state at the time [until], in the same mode, and v1 - v2 there; the mode surely lasts for the time [least] *)
Definition rest K final st m until least : option (state * I.type) :=
  let u := I.sub p (rat p until) (at_t st) in let f := path K st m in let F := front K st m true f in
  let on := at_time F (rat p least) in let on_u := at_time F u in
  if pos u && nonneg (I.sub p (rat p least) u) && upto final until && keeps K st m true f least (on F) least on
  then Some (moved K st m f (rat p until) u on_u match m with Slip _ => Off | Stick => Touch end,
    match m with Slip k => signed (boxes p) k (on_u F) | Stick => I.zero end) else None.

(** a stick that lasts for ever, if the force is constant *)
Definition captive K st := touches (how st) && nonneg (spare (boxes p) (numbers K) (at_t st) (at_x st) (at_v1 st)).

(** the state that a close motion starts from *)
Definition starting a := State (rat p (start_at a)) (rat p (start_x a)) (rat p (start_v1 a)) I.zero (rat p (start_v2 a))
  (if Qeq_bool (start_v1 a) (start_v2 a) then Touch else Off).
(** its state after some events *)
Fixpoint passes K final st (steps : list (mode * Q * Q * bool)) : option state := match steps with
  | (m, least, most, k) :: steps => match step K final st m least most k with
      | Some st => passes K final st steps | None => None end
  | [] => Some st end.
(** the energy of the difference from a state is at most r^2 *)
Definition small K st a r := let sq i := I.mul p i i in let K := numbers K in
  nonneg (I.sub p (rat p (2 * (r * r))) (I.add p (I.add p
    (I.mul p (ka2 K) (sq (I.sub p (at_x st) (rat p (start_x a)))))
    (I.mul p (k1 K) (sq (I.sub p (at_v1 st) (rat p (start_v1 a))))))
    (I.mul p (k2 K) (sq (I.sub p (at_v2 st) (rat p (start_v2 a))))))).
(** the state st at the time [until] in the mode m is close to the motion b: a was close before, or nothing was known *)
Definition renewed K st m until least a steps b := Qeq_bool (start_at b) until && nonnegQ (radius b) && match a with
  | None => small K st b (radius b)
  | Some a => posQ (radius a) && posQ (radius b - radius a) && Qle_bool (start_at a) until && match passes K (Some until) (starting a) steps with
      | Some st => match rest K (Some until) st m until least with
        | Some (st, _) => small K st b (radius b - radius a) | None => false end
      | None => false end end.
(** r sqrt(2 / m) about a number *)
Definition about c r m := let d := I.mul p (rat p r) (I.sqrt p (I.div p (rat p 2) m)) in
  I.join (I.sub p (rat p c) d) (I.add p (rat p c) d).
(** the states close to a motion; body 2 is where it was *)
Definition closest K st a := let K := numbers K in State (at_t st) (about (start_x a) (radius a) (ka2 K))
  (about (start_v1 a) (radius a) (k1 K)) (at_x2 st) (about (start_v2 a) (radius a) (k2 K)) (how st).

(** an event is as the table says *)
Definition agrees st now := touches (how st) && inside (at_t st) (time now) && inside (at_x st) (place now) &&
  inside (at_x2 st) (place2 now) && inside (at_v1 st) (speed now).
(** and so is the end *)
Definition ends (st : state) w e := inside (at_x st) (last_place e) && inside (at_v1 st) (last_v1 e) &&
  inside (at_x2 st) (last_place2 e) && inside (at_v2 st) (last_v2 e) && inside w (last_relative e).
End Program.

Section Table.
Variables (bits_of : positive -> I.precision) (q : I.precision) (depth : nat).
Variable sc : scene.

(** the state at the time 0 *)
Definition on_edge (k : bool) := let f := push (first_spell sc) in forallb (fun z => Qeq_bool (phase z) 0) (tones f) &&
  Qeq_bool (m2 sc * (a2 sc * x_0 sc + a1 sc * v1_0 sc
      - fold_right (fun z r => in_cosine z + r) (pval rational (poly f) (0 - from f)) (tones f))%Q)
    ((if k then -1 else 1) * (friction (first_spell sc) * both sc)).
Definition initial p := State (rat p 0) (rat p (x_0 sc)) (rat p (v1_0 sc)) (rat p (x2_0 sc)) (rat p (v2_0 sc))
  (if Qeq_bool (v1_0 sc) (v2_0 sc) then
     if on_edge true then Edge true else if on_edge false then Edge false else Touch else Off).

(** when a spell ends *)
Definition until_next (later : list spell) := match later with next :: _ => Some (since next) | [] => None end.

(** a constant force *)
Definition constant (f : steady Q) := match tones f with [] => vanishes (tl (poly f)) | _ => false end.
(** whether the pair sticks for ever, if the table says so *)
Definition lasts now (later : list spell) y st e hints := match hints, later with
  | [Ever bits until least], [] => let p := bits_of bits in let K := tuned p sc now y in constant (push now) &&
      match rest p q depth K None st Stick until least with Some (st, _) => captive p K st | None => false end
  | [], _ => negb (for_ever e) | _, _ => false end.

(** event after event, spell after spell; ys: how both masses answer in each; a: a motion that is close *)
Fixpoint goes now later ys st a events e hints : bool := match hints, ys with
  | Hit bits least most k :: hints, y :: _ => let p := bits_of bits in
      match events with
      | ev :: events => match step p q depth (tuned p sc now y) (until_next later) st (mode_until ev) least most k with
        | Some st => if agrees p st ev then goes now later ys st a events e hints else false | None => false end
      | [] => false end
  | Rest bits until least which :: hints, y :: ys' => let p := bits_of bits in let K := tuned p sc now y in
      let on st a events := match later with
        | next :: later' => if Qeq_bool until (since next) then goes next later' ys' st a events e hints
            else goes now later ys st a events e hints
        | [] => goes now later ys st a events e hints end in
      match rest p q depth K (until_next later) st (current events e) until least with
      | Some (st, _) => match which, events with
        | Goes, _ => on st None events
        | Breaks, ev :: events => if agrees p st ev then on st None events else false
        | Renews steps b, _ => if renewed p q depth K st (current events e) until least a steps b
            then on (closest p K st b) (Some b) events else false
        | _, _ => false end
      | None => false end
  | Last bits least :: hints, y :: _ => let p := bits_of bits in
      match events, rest p q depth (tuned p sc now y) (until_next later) st (last_mode e) (last e) least with
      | [], Some (st, w) => ends p st w e && lasts now later y st e hints | _, _ => false end
  | _, _ => false
  end.

(** what a spell has to be *)
Fixpoint fair_spells now later (ys : list (steady Q * steady Q)) {struct ys} : bool := posQ (friction now) && nonnegQ (since now) &&
  match ys with
  | y :: ys => is_answer (m1 sc) (a1 sc) (a2 sc) (fst y) (push now) &&
      is_answer (both sc) (a1 sc) (a2 sc) (snd y) (push now) &&
      match later with next :: later => negb (Qle_bool (since next) (since now)) && fair_spells next later ys
      | [] => true end
  | [] => false end.
(** and a scene: masses and stiffness positive, damping not negative *)
Definition fair ys := posQ (m1 sc) && posQ (m2 sc) && nonnegQ (a1 sc) && posQ (a2 sc) &&
  Qeq_bool (since (first_spell sc)) 0 && fair_spells (first_spell sc) (later_spells sc) ys.

(** the program; the first number of bits is that of the start *)
Definition check bits ys events e hints : bool :=
  fair ys && goes (first_spell sc) (later_spells sc) ys (initial (bits_of bits)) None events e hints.

(** until the end of a spell *)
Definition upto_end (final : option Q) hi := match final with Some q => hi <= Q2R q | None => True end.

(** *** It is right *)
Let M1 := Q2R (m1 sc).
Let M2 := Q2R (m2 sc).
Let A1 := Q2R (a1 sc).
Let A2 := Q2R (a2 sc).
Hypotheses (Hm1 : 0 < M1) (Hm2 : 0 < M2) (Ha1 : 0 <= A1) (Ha2 : 0 < A2).

Lemma both_spec : Q2R (both sc) = M1 + M2.
Proof. apply Q2R_plus. Qed.
(** the sign of a rational number *)
Lemma on_side_Q d : on_side (d ?= 0)%Q (Q2R d).
Proof.
  destruct (Qcompare_spec d 0); simpl; rewrite <- RMicromega.Q2R_0; [apply Qeq_eqR|apply Qlt_Rlt|apply Qlt_Rlt]; auto.
Qed.
Lemma constant_spec g r s : constant g = true -> sval real (in_R g) r = sval real (in_R g) s.
Proof.
  unfold constant. destruct g as [g [|c l] [|]]; try discriminate; cbn [tones poly tl]; intros E; [reflexivity|].
  unfold sval, in_R; cbn [tones poly from map fold_right]. rewrite !pval_cons, !vanishes_spec by auto. ring.
Qed.
Lemma not_0 m : 0 < Q2R m -> ~ (m == 0)%Q.
Proof. intros Hm E. apply Qeq_eqR in E. lra. Qed.
Lemma fadeQ_spec m : 0 < Q2R m -> Q2R (fadeQ sc m) = fade (Q2R m) A1.
Proof.
  intros Hm. assert (E : Q2R (2 * m) = 2 * Q2R m) by (rewrite Q2R_mult; unfold Q2R at 1; simpl; lra).
  unfold fadeQ, fade. rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_div, E; auto. apply not_0. lra.
Qed.
Lemma squareQ_spec m : 0 < Q2R m -> Q2R (squareQ sc m) = A2 / Q2R m - fade (Q2R m) A1 * fade (Q2R m) A1.
Proof.
  intros Hm. unfold squareQ.
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_minus, Q2R_div, Q2R_mult, !fadeQ_spec by (auto using not_0). auto.
Qed.

(** the bounds hold at the time t *)
Definition knows (x v1 x2 v2 : R -> R) B f st t := has (at_t st) t /\ has (at_x st) (x t) /\
  has (at_v1 st) (v1 t) /\ has (at_x2 st) (x2 t) /\ has (at_v2 st) (v2 t) /\
  match how st with Off => True | Touch => v1 t = v2 t
  | Edge k => v1 t = v2 t /\ A2 * x t + A1 * v1 t - sval real f t = - (sign k * (B * (M1 + M2) / M2)) end.
(** a motion was close to another one, not before the time lo *)
Definition is_close (x v1 v2 : R -> R) lo a := match a with None => True
  | Some a => let s := Q2R (start_at a) in lo <= s /\ energy M1 M2 A2 (x s - Q2R (start_x a))
      (v1 s - Q2R (start_v1 a)) (v2 s - Q2R (start_v2 a)) <= Q2R (radius a) ^ 2 end.

Section Spell.
Variables (now : spell) (y : steady Q * steady Q) (p : I.precision).
Let B := Q2R (friction now).
Let f := in_R (push now).
(** what a spell is *)
Definition answered := 0 < B /\ 0 <= Q2R (since now) /\ answers M1 A1 A2 (in_R (fst y)) f /\
  answers (M1 + M2) A1 A2 (in_R (snd y)) f.
Hypothesis An : answered.
Let Hb : 0 < B := proj1 An.
Let Hy1 := proj1 (proj2 (proj2 An)).
Let HyM := proj2 (proj2 (proj2 An)).
Let K := tuned p sc now y.
Let k := real_kit M1 M2 A1 A2 B (in_R (fst y)) (in_R (snd y)) f.

(** the computed numbers are those of the scene *)
Lemma has_tuned : has_kit (numbers K) k.
Proof.
  unfold K, k, tuned, real_kit. rewrite <- both_spec. assert (0 < Q2R (both sc)) by (rewrite both_spec; lra).
  constructor; cbn [numbers k1 k2 kM ka1 ka2 kb slow1 stiff1 slowM stiffM answer1 answerM force]; unfold M1;
    rewrite <- ?squareQ_spec, <- ?fadeQ_spec by auto; try apply has_rat; apply has_in_I.
Qed.
(** the side of a swing *)
Lemma has_side m F w : 0 < Q2R m -> has_parts F w -> square w = A2 / Q2R m - fade (Q2R m) A1 * fade (Q2R m) A1 ->
  has_wave (Bounded F (squareQ sc m ?= 0)%Q (I.sqrt p (I.abs (rat p (squareQ sc m))))) w.
Proof.
  intros Hm HF E. rewrite <- squareQ_spec in E by auto. constructor; auto; rewrite E; [apply on_side_Q|].
  apply J.sqrt_correct, (I.abs_correct _ (Xreal (Q2R (squareQ sc m)))), has_rat.
Qed.

Section Motion.
Context (x v1 x2 v2 : R -> R) (Cx2 : cont x2) (Dx2 : forall t, 0 <= t -> rderiv x2 t (v2 t)).
Context (first : R) (final : option Q) (Hs : 0 <= first).
Hypothesis H : forall hi, upto_end final hi -> obeys M1 M2 A1 A2 B f first hi x v1 v2.
Local Notation known := (knows x v1 x2 v2).

Section State.
Context (st : state) (t : R) (Kn : known B f st t) (Ht : first <= t).
Let pw m := match m with Slip s => slide real k s t (x t) (v1 t) | Stick => stuck real k t (x t) (v1 t) end.
Let fw m k' := match m with Slip s => guard real k s t (x t) (v1 t) (v2 t) | Stick => grip real k k' t (x t) (v1 t) end.

Lemma has_path m : has_wave (path p K st m) (pw m).
Proof.
  destruct Kn as (? & ? & ? & ? & ? & _), has_tuned.
  destruct m; [apply (has_side (m1 sc))|apply (has_side (both sc))]; rewrite ?both_spec; auto; try lra;
    apply has_swing; has.
Qed.
Lemma has_front m k' : has_wave (front p K st m k' (path p K st m)) (fw m k').
Proof.
  pose proof (has_sloped p _ _ (h_parts _ _ (has_path m))) as W. pose proof (has_sloped p _ _ W) as [].
  destruct Kn as (? & ? & ? & ? & ? & _), has_tuned, W.
  destruct m; [apply (has_side (m1 sc))|apply (has_side (both sc))]; rewrite ?both_spec; auto; try lra;
    constructor; has.
Qed.

(** the front, once it is accepted *)
Lemma front_begins m k' hi i : has i (val (fw m k') (Q2R hi)) ->
  begins p q depth match m with Slip _ => how st | Stick => held (how st) k' end
    match m with Slip s => s | Stick => k' end (front p K st m k' (path p K st m)) hi i = true ->
  0 < Q2R hi /\ 0 <= val (fw m k') 0 /\ (forall u, 0 < u <= Q2R hi -> 0 < val (fw m k') u).
Proof.
  intros Hi E. destruct Kn as (_ & _ & _ & _ & _ & Kh).
  apply (begins_spec _ _ _ _ _ _ _ _ _ (has_front m k') Hi E).
  destruct m as [s|]; unfold fw; destruct (how st) as [| |k'']; simpl; auto.
  - rewrite <- Kh. apply guard_touch; auto.
  - intros ->. destruct Kh as (<- & Ex). split; [apply guard_touch|apply guard_edge]; auto.
  - destruct (eqb k'' k') eqn:Ek; auto. apply eqb_prop in Ek. subst k''. apply grip_edge; auto. apply Kh.
Qed.
(** a touching state touches *)
Lemma knows_touch : touches (how st) = true -> v1 t = v2 t.
Proof. destruct Kn as (_ & _ & _ & _ & _ & Kh). destruct (how st); try discriminate; intuition. Qed.
(** the spell lasts *)
Lemma fits_spec i r : fits p final i = true -> has i r -> upto_end final r.
Proof.
  unfold fits, upto_end. destruct final as [e|]; auto. intros E Hi.
  apply nonneg_spec with (r := Q2R e - r) in E; [lra|has].
Qed.
(** the motion runs along the waves of the mode at the time r from now *)
Definition along m k' r := x (t + r) = val (pw m) r /\ v1 (t + r) = val (slope (pw m)) r /\
  v2 (t + r) = match m with Slip s => drive real k s (v2 t) r | Stick => val (slope (pw m)) r end /\
  v1 (t + r) - v2 (t + r) = match m with Slip s => sign s * val (fw m k') r | Stick => 0 end.
Lemma along_mode m k' r : along m k' r -> 0 < val (fw m k') r -> in_mode m (v1 (t + r)) (v2 (t + r)).
Proof. intros (_ & _ & _ & E) P. destruct m as [[|]|]; simpl in *; lra. Qed.
(** it does as long as its front is positive; a stick, as long as friction holds on the other side, too *)
Lemma phase m k' u hi : upto_end final (t + u) -> 0 <= u <= hi -> 0 <= val (fw m k') 0 ->
  (forall r, 0 < r < u -> 0 < val (fw m k') r) ->
  (m = Stick -> v1 t = v2 t /\ forall r, 0 <= r <= hi -> 0 <= val (fw m (negb k')) r) ->
  forall r, 0 <= r <= u -> along m k' r.
Proof.
  intros Hf Hu Z P St r Hr. assert (Nn : forall r, 0 <= r < u -> 0 <= val (fw m k') r).
  { intros c Hc. destruct (Req_dec c 0) as [->|]; auto. apply Rlt_le, P; lra. }
  unfold along. destruct m as [s|].
  - destruct (slip_phase M1 M2 A1 A2 B Hm1 Hm2 Ha2 _ (in_R (snd y)) _ Hy1 x v1 v2 _ _ (H _ Hf) t Ht s u
      ltac:(lra) ltac:(lra) Nn r Hr) as (-> & -> & ->). unfold fw, pw, k. rewrite val_guard by auto.
    destruct s; simpl; repeat split; ring.
  - destruct (St eq_refl) as (Ev & O). destruct (stick_phase M1 M2 A1 A2 B Hm1 Hm2 Hb (in_R (fst y)) _ _ HyM
      x v1 v2 _ _ (H _ Hf) t Ht u ltac:(lra) ltac:(lra) Ev) with (u := r) as (-> & -> & ->); auto;
      [|repeat split; ring]. intros c Hc. specialize (Nn c Hc). specialize (O c ltac:(lra)). destruct k'; auto.
Qed.
(** where friction has nothing left a stick is on the edge *)
Lemma at_edge k' u : along Stick k' u -> val (fw Stick k') u = 0 ->
  A2 * x (t + u) + A1 * v1 (t + u) - sval real f (t + u) = - (sign k' * (B * (M1 + M2) / M2)).
Proof.
  intros (-> & -> & _) E. unfold fw, pw, k in *. rewrite val_grip in E.
  pose proof (stuck_law M1 M2 A1 A2 B Hm1 Hm2 (in_R (fst y)) (in_R (snd y)) f HyM t (x t) (v1 t) u) as L.
  replace (sign k' * (B * (M1 + M2) / M2)) with ((M1 + M2) * (sign k' * (B / M2))) by (field; lra).
  destruct k'; simpl in *; nra.
Qed.
(** body 2 on the way *)
Lemma place2_along m k' u : 0 <= u -> (forall r, 0 <= r <= u -> along m k' r) -> x2 (t + u) = match m with
  | Slip _ => x2 t + Q2R (1 # 2) * (v2 t + v2 (t + u)) * u | Stick => x2 t + (x (t + u) - x t) end.
Proof.
  intros Hu A. destruct m as [s|].
  - rewrite (same_way x2 v2 (fun r => v2 t * r + signed real s B / M2 / 2 * (r * r)) (drive real k s (v2 t))
      t u); auto; [|lra|intros r; unfold drive; simpl; fold B; auto_derive; auto; lra|intros r Hr; apply A,
      Hr]. destruct (A u ltac:(lra)) as (_ & _ & -> & _). unfold drive, Q2R; simpl. fold B. lra.
  - rewrite (same_way x2 v2 (val (pw Stick)) (val (slope (pw Stick))) t u); auto;
      [|lra|apply derive_val|intros r Hr; apply A, Hr].
    rewrite (proj1 (A u ltac:(lra))). do 2 f_equal. symmetry. destruct (A 0 ltac:(lra)) as (E & _).
    rewrite Rplus_0_r in E. auto.
Qed.

(** what is computed once serves all waves of a phase *)
Lemma on_time m k' i u (on := at_time p (front p K st m k' (path p K st m)) i) : has i u ->
  has (on (front p K st m k' (path p K st m))) (val (fw m k') u) /\ has (on (path p K st m)) (val (pw m) u) /\
  has (on (steep p (path p K st m))) (val (slope (pw m)) u) /\
  (m = Stick -> has (on (front p K st m (negb k') (path p K st m))) (val (fw m (negb k')) u)).
Proof.
  intros Hi.
  assert (S : forall F w, has_wave F w -> side F = side (front p K st m k' (path p K st m)) -> decay w = decay (fw m k')
    -> square w = square (fw m k') -> clock w = clock (fw m k') -> angles w = angles (fw m k') -> has (on F) (val w u))
    by (intros F w; exact (has_shared p _ _ F w u i (has_front m k') Hi)). pose proof (has_path m) as W.
  pose proof (has_steep p _ _ W).
  split; [|split; [|split]]; try intros _; apply S; auto using has_front; destruct m; try reflexivity;
    unfold angles; cbn; rewrite ?map_map; reflexivity.
Qed.
(** the mode lasts *)
Lemma keeps_spec m k' lo i hi on : has i (val (fw m k') (Q2R lo)) ->
  (m = Stick -> has (on (front p K st m (negb k') (path p K st m))) (val (fw m (negb k')) (Q2R hi))) ->
  keeps p q depth K st m k' (path p K st m) lo i hi on = true ->
  0 < Q2R lo /\ 0 <= val (fw m k') 0 /\ (forall u, 0 < u <= Q2R lo -> 0 < val (fw m k') u) /\
  (m = Stick -> v1 t = v2 t /\ forall u, 0 <= u <= Q2R hi -> 0 <= val (fw m (negb k')) u).
Proof.
  intros Hi Ho E. destruct m as [s|].
  - destruct (front_begins (Slip s) k' lo i Hi E) as (A & Z & P). repeat (split; [assumption|]). discriminate.
  - unfold keeps in E. rewrite !andb_true_iff in E. destruct E as ((To & E1) & E2).
    destruct (front_begins Stick k' lo i Hi E1) as (A & Z & P).
    destruct (front_begins Stick (negb k') hi _ (Ho eq_refl) E2) as (_ & Z' & P').
    repeat (split; [assumption|]). intros _. split; [apply knows_touch, To|]. intros u Hu.
    destruct (Req_dec u 0) as [->|]; auto. apply Rlt_le, P'; lra.
Qed.
(** the state that it comes to *)
Lemma moved_spec m k' it iu u on hw : 0 <= u -> has it (t + u) -> has iu u ->
  has (on (path p K st m)) (val (pw m) u) -> has (on (steep p (path p K st m))) (val (slope (pw m)) u) ->
  (forall r, 0 <= r <= u -> along m k' r) ->
  forall B' f', (B' = B /\ f' = f \/ forall s, hw <> Edge s) -> match hw with Off => True
    | Touch => v1 (t + u) = v2 (t + u) | Edge s => v1 (t + u) = v2 (t + u) /\
    A2 * x (t + u) + A1 * v1 (t + u) - sval real f' (t + u) = - (sign s * (B' * (M1 + M2) / M2)) end ->
  known B' f' (moved p K st m (path p K st m) it iu on hw) (t + u).
Proof.
  intros Hu Hit Hiu Hx Hv A B' f' Kb Kh. pose proof Kn as (Kt & Kx & K1 & Kx2 & K2 & _).
  pose proof (place2_along m k' u Hu A) as X2. destruct (A u ltac:(lra)) as (Ex & E1 & E2 & _).
  rewrite <- Ex in Hx. rewrite <- E1 in Hv. unfold knows, moved. rewrite X2.
  destruct m as [s|]; cbn [at_t at_x at_v1 at_x2 at_v2 how]; (split; [exact Hit|]).
  - assert (Hw : has (drive (boxes p) (numbers K) s (at_v2 st) iu) (v2 (t + u))).
    { rewrite E2. destruct has_tuned. unfold drive. has. }
    split; [exact Hx|]. split; [|split; [unfold behind; has|auto]].
    destruct hw; cbn [touches]; [exact Hv|rewrite Kh|rewrite (proj1 Kh)]; exact Hw.
  - rewrite <- E1 in E2. split; [|split; [exact Hv|split; [has|split; [rewrite E2; exact Hv|exact Kh]]]].
    destruct hw as [| |s]; auto. destruct Kb as [(-> & ->)|N]; [|destruct (N s); auto].
    replace (x (t + u)) with (edge real k s (t + u) (v1 (t + u))); [destruct has_tuned; unfold edge; has|].
    unfold edge; simpl. rewrite signed_real. fold A1 A2. apply Rmult_eq_reg_l with A2; [|lra].
    replace (A2 * x (t + u)) with (sval real f (t + u) - sign s * (B * (M1 + M2) / M2) - A1 * v1 (t + u))
      by lra. field; lra.
Qed.

(** one event *)
Lemma step_sound m least most k' st' : step p q depth K final st m least most k' = Some st' ->
  exists t', t < t' /\ v1 t' = v2 t' /\ (forall u, t < u < t' -> in_mode m (v1 u) (v2 u)) /\ known B f st' t'.
Proof.
  pose proof Kn as (Kt & _). unfold step. destruct (_ && nonneg _) eqn:C; [|discriminate]. intros E. injection E as <-.
  rewrite !andb_true_iff in C. destruct C as (((E0 & Ef) & Ek) & En). apply Qle_bool_iff, Qle_Rle in E0.
  pose proof (has_rat p most) as Hmost. apply fits_spec with (r := t + Q2R most) in Ef; [|has].
  destruct (on_time m k' _ _ Hmost) as (Hend & Hpath & Hsteep & Hother).
  set (on := at_time p (front p K st m k' (path p K st m)) (rat p most)) in *.
  set (F := front p K st m k' (path p K st m)) in *.
  assert (Hleast : has (near p q F (on F) least most (rat p (least - most))) (val (fw m k') (Q2R least))).
  { apply has_near; [exact (has_front m k')|exact Hend|lra|]. rewrite <- Q2R_minus. apply has_rat. }
  destruct (keeps_spec _ _ _ _ _ _ Hleast Hother Ek) as (Hl & Z & P & St).
  apply nonneg_spec with (r := - val (fw m k') (Q2R most)) in En; [|apply J.neg_correct; auto].
  destruct (wave_root (fw m k') (Q2R least) (Q2R most) ltac:(lra) P ltac:(lra)) as (u & Hu & E & Q).
  assert (A : forall r, 0 <= r <= u -> along m k' r).
  { apply (phase m k' u (Q2R most)); auto; [|lra]. unfold upto_end in *. destruct final; lra. }
  assert (Ev : v1 (t + u) = v2 (t + u)).
  { destruct (A u ltac:(lra)) as (_ & _ & _ & Er). rewrite E in Er. destruct m; lra. }
  exists (t + u). split; [lra|]. split; [auto|]. split.
  - intros r Hr. replace r with (t + (r - t)) by ring. apply along_mode with k'; [apply A|apply Q]; lra.
  - assert (Hh : has (hull p least most) u) by (apply has_hull; lra).
    assert (Hd : has (hull p (least - most) 0) (u - Q2R most)).
    { apply has_hull. rewrite Q2R_minus, RMicromega.Q2R_0. lra. }
    apply (moved_spec m k'); auto; [lra|has|apply has_near; auto using has_path; lra|..].
    + apply has_near; auto using has_path, has_steep. lra.
    + destruct m; [auto|]. split; [auto|]. apply at_edge; auto. apply A; lra.
Qed.
(** a rest *)
Lemma rest_sound m until least st' w : rest p q depth K final st m until least = Some (st', w) ->
  t < Q2R until /\ upto_end final (Q2R until) /\
  (forall u, t < u <= Q2R until -> in_mode m (v1 u) (v2 u)) /\ (forall B' f', known B' f' st' (Q2R until)) /\
  has w (v1 (Q2R until) - v2 (Q2R until)).
Proof.
  pose proof Kn as (Kt & _). unfold rest. set (iu := I.sub p (rat p until) (at_t st)).
  destruct (_ && keeps _ _ _ _ _ _ _ _ _ _ _ _) eqn:C; [|discriminate]. intros E. injection E as <- <-.
  rewrite !andb_true_iff in C. destruct C as (((E1 & E2) & Ef) & Ek).
  assert (Hu : has iu (Q2R until - t)) by (unfold iu; has). set (u := Q2R until - t) in *.
  assert (Eu : Q2R until = t + u) by (unfold u; ring). apply pos_spec with (r := u) in E1; auto.
  apply nonneg_spec with (r := Q2R least - u) in E2; [|has]. assert (Fin : upto_end final (Q2R until)).
  { unfold upto, upto_end in *. destruct final; auto. apply Qle_Rle, Qle_bool_iff, Ef. }
  assert (Hc : has (rat p until) (t + u)) by (rewrite <- Eu; has). rewrite Eu in Fin |- *.
  destruct (on_time m true _ _ (has_rat p least)) as (Hleast & _ & _ & Hother).
  destruct (on_time m true _ _ Hu) as (Hend & Hpath & Hsteep & _).
  destruct (keeps_spec _ _ _ _ _ _ Hleast Hother Ek) as (Hl & Z & P & St).
  assert (A : forall r, 0 <= r <= u -> along m true r).
  { apply (phase m true u (Q2R least)); auto; [lra|]. intros r Hr. apply P; lra. }
  assert (In : forall r, 0 < r <= u -> in_mode m (v1 (t + r)) (v2 (t + r))).
  { intros r Hr. apply along_mode with true; [apply A|apply P]; lra. }
  split; [lra|]. split; [auto|]. split; [|split].
  - intros r Hr. replace r with (t + (r - t)) by ring. apply In. lra.
  - intros B' f'. apply (moved_spec m true); auto; [lra|right; destruct m; discriminate|].
    destruct m; [exact I|apply (In u); lra].
  - destruct (A u ltac:(lra)) as (_ & _ & _ & ->). destruct m as [s|]; [|apply J.zero_correct].
    rewrite <- signed_real. apply has_signed, Hend.
Qed.

(** a stick for ever *)
Lemma captive_spec : final = None -> constant (push now) = true -> captive p K st = true -> forall u, t < u -> v1 u = v2 u.
Proof.
  intros Ef Co E u Hu. rewrite Ef in H. apply andb_true_iff in E. destruct E as (To & Sp).
  pose proof Kn as (Kt & Kx & K1 & _). replace u with (t + (u - t)) by ring.
  apply (stick_for_ever M1 M2 A1 A2 B Hm1 Hm2 Ha1 Ha2 Hb (in_R (fst y)) (in_R (snd y)) f HyM x v1 v2 first u
    (H u I)); auto using knows_touch; try lra.
  - intros r. apply constant_spec, Co.
  - apply (nonneg_spec _ _ Sp). destruct has_tuned. unfold spare. has.
Qed.
End State.

(** several events *)
Lemma passes_sound steps : forall st t st', known B f st t -> first <= t ->
  passes p q depth K final st steps = Some st' -> exists t', first <= t' /\ known B f st' t'.
Proof.
  induction steps as [|(((m, least), most), k') steps IH]; cbn [passes]; intros st t st' Kn Ht E.
  - injection E as <-. eauto.
  - destruct (step _ _ _ _ _ _ _ _ _ _) as [st1|] eqn:E1; [|discriminate].
    destruct (step_sound st t Kn Ht _ _ _ _ _ E1) as (t1 & Ht1 & _ & _ & Kn1). apply (IH st1 t1); auto. lra.
Qed.
(** a small difference *)
Lemma small_spec st t a r : known B f st t -> small p K st a r = true ->
  energy M1 M2 A2 (x t - Q2R (start_x a)) (v1 t - Q2R (start_v1 a)) (v2 t - Q2R (start_v2 a)) <= Q2R r ^ 2.
Proof.
  intros (_ & Hx & H1 & _ & H2 & _) E. pose proof has_tuned as T. unfold small in E. set (c := x t - Q2R (start_x a)).
  set (d := v1 t - Q2R (start_v1 a)). set (e := v2 t - Q2R (start_v2 a)).
  apply nonneg_spec with (r := Q2R (2 * (r * r)) - (A2 * (c * c) + M1 * (d * d) + M2 * (e * e))) in E;
    [|unfold c, d, e; has]. rewrite !Q2R_mult in E. unfold energy. lra.
Qed.
End Motion.

Section Close.
Variables x v1 x2 v2 : R -> R.
Local Notation known := (knows x v1 x2 v2).
Lemma renewed_sound st m until least a steps b : follows M1 M2 A1 A2 B f (Q2R (since now)) (Q2R until) x v1
  v2 -> is_close x v1 v2 (Q2R (since now)) a -> known B f st (Q2R until) ->
  renewed p q depth K st m until least a steps b = true -> Q2R (start_at b) = Q2R until /\
  0 <= Q2R (radius b) /\ is_close x v1 v2 (Q2R until) (Some b).
Proof.
  intros (_ & Beside) Cl Kn E. unfold renewed in E. rewrite !andb_true_iff in E.
  destruct E as ((Eb & Rb) & E). apply Qeq_bool_iff, Qeq_eqR in Eb. apply nonnegQ_spec in Rb. split; [auto|].
  split; [auto|]. unfold is_close. rewrite Eb. split; [lra|]. destruct a as [a|].
  - rewrite !andb_true_iff in E. destruct E as (((Ra & Rd) & Hu) & E). apply posQ_spec in Ra.
    apply posQ_spec in Rd. apply Qle_bool_iff, Qle_Rle in Hu. destruct Cl as (Ha & Cl).
    set (s := Q2R (start_at a)) in *. pose proof (proj1 (proj2 An)) as Hs.
    destruct (Beside s (Q2R (start_x a)) (Q2R (start_v1 a)) (Q2R (start_v2 a)) ltac:(lra))
      as (z & u1 & z2 & u2 & (Z0 & U1 & Z2 & U2) & Ob & C2 & D2 & Near).
    destruct (passes _ _ _ _ _ _ _) as [st1|] eqn:E1; [|discriminate].
    destruct (rest _ _ _ _ _ _ _ _ _) as [(st2, w)|] eqn:E2; [|discriminate].
    assert (H : forall hi, hi <= Q2R until -> obeys M1 M2 A1 A2 B f s hi z u1 u2).
    { intros hi Hh t0 T X V1 V2 g Ht HT Hd. apply Ob; auto. lra. }
    assert (K0 : knows z u1 z2 u2 B f (starting p a) s).
    { unfold knows, starting; cbn [at_t at_x at_v1 at_x2 at_v2 how]. rewrite Z0, U1, Z2, U2.
      repeat (split; [try apply has_rat; try apply J.zero_correct|]). destruct (Qeq_bool _ _) eqn:Q; auto.
      apply Qeq_bool_iff, Qeq_eqR in Q. auto. }
    destruct (passes_sound z u1 z2 u2 C2 D2 s (Some until) ltac:(lra) H steps _ s st1 K0 (Rle_refl s) E1)
      as (t1 & Ht1 & K1).
    destruct (rest_sound z u1 z2 u2 C2 D2 s (Some until) ltac:(lra) H _ t1 K1 Ht1 _ _ _ _ _ E2)
      as (Ht2 & _ & _ & K2 & _). pose proof (small_spec z u1 z2 u2 _ _ _ _ (K2 B f) E) as Sm.
    rewrite Q2R_minus in Sm, Rd. pose proof (Rle_trans _ _ _ (Near (Q2R until) ltac:(lra)) Cl) as Sn.
    pose proof (energy_triangle M1 M2 A2 _ _ _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(lra) Ra Rd Sn Sm) as T.
    eapply Rle_trans; [|eapply Rle_trans; [exact T|]]; [right; f_equal; ring|right; ring].
  - exact (small_spec x v1 x2 v2 _ _ _ _ Kn E).
Qed.

Lemma about_spec c r M m u : has M m -> 0 < m -> 0 <= Q2R r -> m * (u - Q2R c) ^ 2 <= 2 * Q2R r ^ 2 ->
  has (about p c r M) u.
Proof.
  intros HM Hm Hr Hu. apply (root_bound m) in Hu; auto.
  replace (2 * Q2R r ^ 2 / m) with (Q2R r ^ 2 * (2 / m)) in Hu by (field; lra).
  rewrite sqrt_mult_alt, sqrt_pow2 in Hu by positive. apply Rabs_inv in Hu. assert (E : Q2R 2 = 2) by lra.
  assert (D : has (I.mul p (rat p r) (I.sqrt p (I.div p (rat p 2) M))) (Q2R r * sqrt (2 / m)))
    by (rewrite <- E; has).
  apply (J.join_correct _ _ (Q2R c - Q2R r * sqrt (2 / m)) (Q2R c + Q2R r * sqrt (2 / m))); [has|has|lra].
Qed.
Lemma closest_spec st b t : t = Q2R (start_at b) -> 0 <= Q2R (radius b) -> is_close x v1 v2 t (Some b) ->
  (forall B' f', known B' f' st t) -> forall B' f', known B' f' (closest p K st b) t.
Proof.
  intros Et Hr (_ & Cl) Kn B' f'. rewrite <- Et in Cl. destruct has_tuned.
  destruct (Kn B' f') as (Kt & _ & _ & K2 & _ & Kh).
  unfold closest, knows; cbn [at_t at_x at_v1 at_x2 at_v2 how].
  destruct (energy_parts M1 M2 A2 Hm1 Hm2 Ha2 _ _ _ _ Cl) as (Ex & E1 & E2). split; [auto|].
  split; [apply about_spec with A2; auto|]. split; [apply about_spec with M1; auto|]. split; [auto|].
  split; [apply about_spec with M2; auto|auto].
Qed.
End Close.
End Spell.

Section Whole.
Context (x v1 x2 v2 : R -> R) (Cx2 : cont x2) (Dx2 : forall t, 0 <= t -> rderiv x2 t (v2 t)).
Local Notation known := (knows x v1 x2 v2).

(** inside the bounds *)
Lemma inside_spec p i c r : inside p i c = true -> has i r -> within c r.
Proof.
  intros E Hi. apply andb_true_iff in E. destruct E as (E1 & E2).
  apply nonneg_spec with (r := r - Q2R (fst c)) in E1; [|has]. apply nonneg_spec with (r := Q2R (snd c) - r) in E2;
    [|has].
  split; lra.
Qed.
(** an event *)
Lemma agrees_spec B f p st ev later e t t' : known B f st t' -> agrees p st ev = true -> t < t' ->
  (forall u, t < u < t' -> in_mode (mode_until ev) (v1 u) (v2 u)) -> unfolds x v1 x2 v2 t' later e ->
  unfolds x v1 x2 v2 t (ev :: later) e.
Proof.
  intros (Kt & Kx & K1 & Kx2 & K2 & Kh) E Ht M U. unfold agrees in E. rewrite !andb_true_iff in E.
  destruct E as ((((E0 & E1) & E2) & E3) & E4). exists t'. repeat (split; [solve [auto; eapply inside_spec; eauto]|]).
  destruct (how st); try discriminate; intuition.
Qed.

(** what a spell is *)
Lemma fair_now now later y ys : fair_spells now later (y :: ys) = true -> answered now y.
Proof.
  cbn [fair_spells]. rewrite !andb_true_iff. intros ((F & S) & ((Y1 & YM) & _)). apply posQ_spec in F.
  apply nonnegQ_spec in S. apply is_answer_spec in Y1. apply is_answer_spec in YM. rewrite both_spec in YM.
  repeat split; auto.
Qed.
(** along what it runs, and beside what *)
Lemma follows_less B f lo hi hi' y w1 w2 : hi' <= hi -> follows M1 M2 A1 A2 B f lo hi y w1 w2 ->
  follows M1 M2 A1 A2 B f lo hi' y w1 w2.
Proof.
  assert (Less : forall lo y w1 w2, hi' <= hi -> obeys M1 M2 A1 A2 B f lo hi y w1 w2 -> obeys M1 M2 A1 A2 B f lo hi' y
    w1 w2).
  { intros l z u1 u2 Hh O t0 T X V1 V2 g Ht HT Hd. apply O; auto. lra. }
  intros Hh (O & N). split; [auto|]. intros t0 X V1 V2 Ht.
  destruct (N t0 X V1 V2 ltac:(lra)) as (z & u1 & z2 & u2 & St &
    Oz & C & D & E). exists z, u1, z2, u2. repeat (split; [auto|]). intros t Hu. apply E. lra.
Qed.
Lemma runs_now now later : runs M1 M2 A1 A2 x v1 v2 now later ->
  forall hi, upto_end (until_next later) hi ->
    follows M1 M2 A1 A2 (Q2R (friction now)) (in_R (push now)) (Q2R (since now)) hi x v1 v2.
Proof.
  destruct later as [|next later]; cbn [runs until_next]; intros (_ & _ & R); [auto|].
  intros hi Hh. exact (follows_less _ _ _ _ _ _ _ _ Hh (proj1 (proj2 R))).
Qed.

(** a stick for ever *)
Lemma lasts_sound now later y st t e hints : answered now y -> (forall hi, upto_end (until_next later) hi ->
    obeys M1 M2 A1 A2 (Q2R (friction now)) (in_R (push now)) (Q2R (since now)) hi x v1 v2) ->
  Q2R (since now) <= t -> known (Q2R (friction now)) (in_R (push now)) st t ->
  lasts now later y st e hints = true -> for_ever e = true -> forall u, t < u -> v1 u = v2 u.
Proof.
  intros An Ob Ht Kn. pose proof (proj1 (proj2 An)) as Hs. unfold lasts.
  destruct hints as [|[| | |bits until least] [|]]; [intros E Ev; rewrite Ev in E; discriminate| | | | | | |
    destruct later; [|discriminate]|]; try discriminate. rewrite andb_true_iff. intros (Co & R) _ u Hu.
  destruct (rest _ _ _ _ _ _ _ _ _) as [(st', w)|] eqn:E; [|discriminate].
  destruct (rest_sound now y _ An x v1 x2 v2 Cx2 Dx2 _ None Hs Ob st t Kn Ht _ _ _ _ _ E)
    as (Ht' & _ & Q & Kn' & _). destruct (Rle_dec u (Q2R until)); [apply Q; lra|].
  apply (captive_spec now y (bits_of bits) An x v1 x2 v2 _ None Ob st' (Q2R until)); auto; lra.
Qed.

(** all events *)
Lemma goes_sound e hints : forall now later ys st a events t, fair_spells now later ys = true ->
  runs M1 M2 A1 A2 x v1 v2 now later -> Q2R (since now) <= t -> known (Q2R (friction now)) (in_R (push now)) st t ->
  is_close x v1 v2 (Q2R (since now)) a -> goes now later ys st a events e hints = true ->
    unfolds x v1 x2 v2 t events e.
Proof.
  induction hints as [|hint hints IH]; intros now later ys st a events t Fa Ru Ht Kn Cl; [destruct ys; discriminate|].
  destruct ys as [|y ys]; [destruct hint; try discriminate; destruct hints; discriminate|].
  pose proof (fair_now _ _ _ _ Fa) as An. pose proof (proj1 (proj2 An)) as Hs.
  pose proof (runs_now _ _ Ru) as Fo. pose proof (fun hi Hh => proj1 (Fo hi Hh)) as Ob.
  destruct hint as [bits least most k'|bits until least which|bits least|]; cbn [goes]; [| | |discriminate].
  - destruct events as [|ev events]; [discriminate|].
    destruct (step _ _ _ _ _ _ _ _ _ _) as [st'|] eqn:E; [|discriminate].
    destruct (agrees _ _ _) eqn:Ea; [|discriminate]. intros G.
    destruct (step_sound now y _ An x v1 x2 v2 Cx2 Dx2 _ _ Hs Ob st t Kn Ht _ _ _ _ _ E)
      as (t' & Ht' & Ev & Q & Kn'). apply (agrees_spec _ _ _ _ _ _ _ _ _ Kn' Ea Ht' Q).
    apply (IH now later (y :: ys) st' a); auto. lra.
  - destruct (rest _ _ _ _ _ _ _ _ _) as [(st', w)|] eqn:E; [|discriminate].
    destruct (rest_sound now y _ An x v1 x2 v2 Cx2 Dx2 _ _ Hs Ob st t Kn Ht _ _ _ _ _ E)
      as (Ht' & Fin & Q & Kn' & _). set (on := fun st a events => match later with
      | next :: later' => if Qeq_bool until (since next) then goes next later' ys st a events e hints
          else goes now later (y :: ys) st a events e hints
      | [] => goes now later (y :: ys) st a events e hints end).
    assert (Go : forall st a events, on st a events = true -> (forall B' f', known B' f' st (Q2R until)) ->
      is_close x v1 v2 (Q2R until) a -> unfolds x v1 x2 v2 (Q2R until) events e).
    { intros st1 a1 evs G Kn1 Cl1. assert (Cl' : forall lo, lo <= Q2R until -> is_close x v1 v2 lo a1).
      { intros lo Hlo. destruct a1; simpl in *; auto. split; [lra|apply Cl1]. }
      assert (Same : goes now later (y :: ys) st1 a1 evs e hints = true -> unfolds x v1 x2 v2 (Q2R until) evs e).
      { intros G'. apply (IH now later (y :: ys) st1 a1); auto; [lra|apply Cl'; lra]. }
      unfold on in G. destruct later as [|next later]; auto.
      destruct (Qeq_bool until (since next)) eqn:Eq; auto. apply Qeq_bool_iff, Qeq_eqR in Eq.
      cbn [fair_spells] in Fa. rewrite !andb_true_iff in Fa.
      apply (IH next later ys st1 a1); auto; [apply Fa|apply Ru|lra|apply Cl'; lra]. }
    destruct which as [| |steps b].
    + intros G. apply (unfolds_earlier _ _ _ _ t (Q2R until)); auto. apply (Go st' None); simpl; auto.
    + destruct events as [|ev events]; [discriminate|]. destruct (agrees _ _ _) eqn:Ea; [|discriminate]. intros G.
      apply (agrees_spec (Q2R (friction now)) (in_R (push now)) _ st' _ _ _ _ (Q2R until)) with (2 := Ea); auto.
      * intros u Hu. apply Q. lra.
      * apply (Go st' None); simpl; auto.
    + destruct (renewed _ _ _ _ _ _ _ _ _ _ _) eqn:En; [|discriminate]. intros G.
      destruct (renewed_sound now y _ An x v1 x2 v2 st' _ until least a steps b (Fo _ Fin) Cl (Kn' _ _) En)
        as (Eb & Rb & Cl'). apply (unfolds_earlier _ _ _ _ t (Q2R until)); auto.
      apply (Go _ (Some b) events G); auto. apply closest_spec; auto.
  - destruct events as [|]; [|discriminate]. destruct (rest _ _ _ _ _ _ _ _ _) as [(st', w)|] eqn:E; [|discriminate].
    destruct (rest_sound now y _ An x v1 x2 v2 Cx2 Dx2 _ _ Hs Ob st t Kn Ht _ _ _ _ _ E)
      as (Ht' & _ & Q & Kn' & Kw). unfold ends. rewrite !andb_true_iff.
    intros (((((B0 & B1) & B2) & B3) & B4) & Ev).
    destruct (Kn' 0 (in_R (push now))) as (_ & Kx & K1 & Kx2 & K2 & _).
    repeat (split; [solve [auto; eapply inside_spec; eauto]|]).
    apply (lasts_sound now later y st' (Q2R (last e)) e hints); auto. lra.
Qed.
End Whole.

Lemma in_R_pval l u : Q2R (pval rational l u) = pval real (map Q2R l) (Q2R u).
Proof.
  induction l as [|c l IH]; [apply RMicromega.Q2R_0|]. cbn [map]. rewrite pval_cons, <- IH, <- Q2R_mult, <- Q2R_plus.
  auto.
Qed.
Lemma on_edge_spec k : on_edge k = true -> A2 * Q2R (x_0 sc) + A1 * Q2R (v1_0 sc)
  - sval real (in_R (push (first_spell sc))) 0 = - (sign k * (Q2R (friction (first_spell sc)) * (M1 + M2) / M2)).
Proof.
  unfold on_edge. set (g := push (first_spell sc)). rewrite andb_true_iff. intros (Ph & E).
  assert (S : sval real (in_R g) 0 =
    Q2R (fold_right (fun z r => in_cosine z + r)%Q (pval rational (poly g) (0 - from g)%Q) (tones g))).
  { clear E. unfold sval, in_R; cbn [tones poly from].
    induction (tones g) as [|z zs IH]; cbn [map fold_right forallb] in *.
    - rewrite in_R_pval, Q2R_minus, RMicromega.Q2R_0. reflexivity.
    - apply andb_true_iff in Ph. destruct Ph as (P & Ph). apply Qeq_bool_iff, Qeq_eqR in P.
      rewrite Q2R_plus, <- IH by auto. unfold tval; cbn [in_sine in_cosine turn phase add mul sin_of cos_of real].
      rewrite P, RMicromega.Q2R_0, !Rmult_0_r, !Rplus_0_r, sin_0, cos_0. ring. }
  rewrite S. apply Qeq_bool_iff, Qeq_eqR in E. unfold both in E.
  rewrite Q2R_mult, Q2R_minus, Q2R_plus, !Q2R_mult, Q2R_plus in E.
  replace (Q2R (if k then -1 else 1)) with (- sign k) in E by (destruct k; simpl; lra).
  apply Rmult_eq_reg_l with M2; [|lra]. unfold A1, A2, M1, M2 in *. rewrite E. field; lra.
Qed.
End Table.

(** spells in order *)
Lemma fair_order sc later : forall now ys, fair_spells sc now later ys = true -> in_order now later.
Proof.
  induction later as [|next l IH]; intros now [|z zs]; cbn [fair_spells in_order];
    rewrite !andb_true_iff; intros ((F & S) & Rest); try discriminate; apply posQ_spec in F; apply nonnegQ_spec in S;
    [auto|]. destruct Rest as (_ & L & Rest). split; [auto|]. split; [auto|]. split; [|eapply IH; eauto].
  apply negb_true_iff in L. apply Qlt_Rlt, Qnot_le_lt. intros Q. apply Qle_bool_iff in Q. congruence.
Qed.

(** What the program accepts is true of every motion of the scene. *)
Theorem sound bits_of q depth sc bits ys events e hints : check bits_of q depth sc bits ys events e hints = true ->
  forall x v1 x2 v2, motion sc x v1 x2 v2 -> unfolds x v1 x2 v2 0 events e.
Proof.
  intros E x v1 x2 v2 (U & CU & DU & V & C2 & D2 & X0 & V10 & X20 & V20).
  apply andb_true_iff in E. destruct E as (Fa & G). unfold fair in Fa. rewrite !andb_true_iff in Fa.
  destruct Fa as (((((Fm1 & Fm2) & Fa1) & Fa2) & F0) & Fs).
  apply posQ_spec in Fm1. apply posQ_spec in Fm2. apply posQ_spec in Fa2. apply nonnegQ_spec in Fa1.
  apply Qeq_bool_iff, Qeq_eqR in F0. rewrite RMicromega.Q2R_0 in F0.
  apply (goes_sound bits_of q depth sc Fm1 Fm2 Fa1 Fa2 x v1 x2 v2 C2 D2 e hints (first_spell sc) (later_spells sc) ys
    (initial sc (bits_of bits)) None); simpl; auto; [|lra|].
  - apply (varying_runs _ _ _ _ Fm1 Fm2 Fa1 Fa2 x v1 v2 _ _ U x v1 v2); eauto using fair_order; intros t Ht;
      rewrite F0, Rplus_0_l; auto.
  - unfold knows, initial; cbn [at_t at_x at_v1 at_x2 at_v2 how]. rewrite X0, V10, X20, V20.
    repeat (split; [try apply has_rat|]).
    + rewrite <- RMicromega.Q2R_0. apply has_rat.
    + destruct (Qeq_bool (v1_0 sc) (v2_0 sc)) eqn:E; auto. apply Qeq_bool_iff, Qeq_eqR in E.
      destruct (on_edge sc true) eqn:E1; [|destruct (on_edge sc false) eqn:E2]; auto; split; auto;
        apply on_edge_spec; auto.
Qed.
End Check.
