(** Trajectories as theorems: what a table of events says about a motion ([unfolds]), and a program that accepts a table
    only if it is true of every motion of its scene ([Check.sound]). The program bounds the closed forms of Waves.v by
    interval arithmetic; which one is left open. *)
From Coq Require Import Reals QArith Qreals List Bool Lra Psatz.
From Interval.Real Require Import Xreal.
From Interval.Interval Require Import Interval.
From InertialPair Require Import Dini Pair Waves.
Import ListNotations.
Local Open Scope R_scope.

(** *** Statements *)
(** a scene: the pair, and the state at the time 0 *)
Record scene := Scene { m1 : Q; m2 : Q; a1 : Q; a2 : Q; b : Q; x_0 : Q; v1_0 : Q; v2_0 : Q }.

(** a motion of the scene *)
Definition motion sc x v1 v2 s :=
  solution (Q2R (m1 sc)) (Q2R (m2 sc)) (Q2R (a1 sc)) (Q2R (a2 sc)) (Q2R (b sc)) x v1 v2 s /\
  x 0 = Q2R (x_0 sc) /\ v1 0 = Q2R (v1_0 sc) /\ v2 0 = Q2R (v2_0 sc).

(** slipping with v1 > v2 ([true]) or v1 < v2 ([false]); or sticking *)
Inductive mode := Slip (ahead : bool) | Stick.

(** what it says of the two velocities *)
Definition in_mode m v1 v2 := match m with Slip true => v2 < v1 | Slip false => v1 < v2 | Stick => v1 = v2 end.

(** an event: the mode that ends with it, the bounds of its time, of body 1's place there and of the common velocity *)
Record event := Event { mode_until : mode; time : Q * Q; place : Q * Q; speed : Q * Q }.

(** the end: the mode, the time, the bounds of the place, of the velocities and of v1 - v2 *)
Record ending := Ending { last_mode : mode; last : Q; last_place : Q * Q; last_v1 : Q * Q; last_v2 : Q * Q;
  last_relative : Q * Q }.

(** between two rationals *)
Definition within (i : Q * Q) r := Q2R (fst i) <= r <= Q2R (snd i).

(** From t on the motion runs through the events and comes to the end:
    between two events it is in the mode that is said,
  at every time; at an event both velocities are equal. *)
Fixpoint unfolds (x v1 v2 : R -> R) (t : R) (events : list event) (e : ending) : Prop :=
  match events with
  | now :: later => exists t', t < t' /\ within (time now) t' /\ within (place now) (x t') /\
    within (speed now) (v1 t') /\
      v1 t' = v2 t' /\ (forall u, t < u < t' -> in_mode (mode_until now) (v1 u) (v2 u)) /\ unfolds x v1 v2 t' later e
  | [] => t < Q2R (last e) /\ (forall u, t < u <= Q2R (last e) -> in_mode (last_mode e) (v1 u) (v2 u)) /\
      within (last_place e) (x (Q2R (last e))) /\ within (last_v1 e) (v1 (Q2R (last e))) /\
      within (last_v2 e) (v2 (Q2R (last e))) /\ within (last_relative e) (v1 (Q2R (last e)) - v2 (Q2R (last e)))
  end.

(** *** The program *)
(** what helps it with an event: bounds of the time since the event before, and which way a stick ends *)
Record hint := Hint { least : Q; most : Q; towards : bool }.

(** what is known of a state beside bounds: nothing; a contact; the edge on which a stick has ended *)
Inductive start := Off | Touch | Edge (ahead : bool).

(** a sign *)
Definition sign (k : bool) := if k then 1 else -1.
(** one or the other *)
Lemma sign_cases k : sign k = 1 \/ sign k = -1. Proof. destruct k; auto. Qed.

(** the rational numbers that are checked to be positive, or in order *)
Definition posQ q := (0 <? Qnum q)%Z.
(** as said *)
Lemma posQ_spec q : posQ q = true -> 0 < Q2R q.
Proof.
  intros H. apply Z.ltb_lt in H. unfold Q2R. apply Rmult_lt_0_compat; [apply (IZR_lt 0); auto|].
  apply Rinv_0_lt_compat, (IZR_lt 0). apply Pos2Z.is_pos.
Qed.
(** not negative *)
Definition nonnegQ q := (0 <=? Qnum q)%Z.
(** as said *)
Lemma nonnegQ_spec q : nonnegQ q = true -> 0 <= Q2R q.
Proof.
  intros H. apply Z.leb_le in H. unfold Q2R. apply Rmult_le_pos; [apply (IZR_le 0); auto|].
  apply Rlt_le, Rinv_0_lt_compat, (IZR_lt 0). apply Pos2Z.is_pos.
Qed.
(** the middle of two *)
Definition mid p q := Qred ((p + q) * (1 # 2)).
(** as said *)
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

(** the wave of intervals has the wave *)
Record has_wave (F : bounded) (f : wave R) : Prop := { h_still : has (still (parts F)) (still f);
  h_drift : has (drift (parts F)) (drift f); h_even : has (even (parts F)) (even f);
  h_odd : has (odd (parts F)) (odd f); h_decay : has (decay (parts F)) (decay f);
  h_square : has (square (parts F)) (square f); h_side : on_side (side F) (square f);
  h_root : has (root F) (sqrt (Rabs (square f))) }.

(** known to be positive *)
Definition pos i := match I.sign_strict i with Xgt => true | _ => false end.
(** known not to be negative *)
Definition nonneg i := match I.sign_large i with Xgt | Xeq => true | _ => false end.

(** as said *)
Lemma pos_spec i r : pos i = true -> has i r -> 0 < r.
Proof.
  unfold pos, has. pose proof (I.sign_strict_correct i) as C. destruct I.sign_strict; try discriminate.
  intros _ H. exact (proj2 (C _ H)).
Qed.
(** as said *)
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
(** the sign times the number *)
Definition signed (k : bool) i := if k then i else I.neg i.

(** as said *)
Lemma has_rat q : has (rat q) (Q2R q).
Proof. apply J.div_correct; apply I.fromZ_correct. Qed.
(** as said *)
Lemma has_hull q r u : Q2R q <= u <= Q2R r -> has (hull q r) u.
Proof. intros Hu. exact (J.join_correct _ _ _ _ _ (has_rat q) (has_rat r) Hu). Qed.
(** as said *)
Lemma has_signed k i r : has i r -> has (signed k i) (sign k * r).
Proof.
  intros H. destruct k; unfold sign, signed.
  - rewrite Rmult_1_l; auto.
  - replace (-1 * r) with (- r) by ring. apply J.neg_correct; auto.
Qed.

(** the swing of a wave; beyond the critical damping it is a sum of two exponentials, which are bounded one by one *)
Definition swinging F u :=
  let f := parts F in let w := root F in
  let faded g := I.exp p (I.neg (I.mul p g u)) in
  match side F with
  | Gt => let phase := I.mul p w u in
      I.mul p (faded (decay f)) (I.add p (I.mul p (even f) (I.cos p phase))
        (I.mul p (odd f) (I.div p (I.sin p phase) w)))
  | Eq => I.mul p (faded (decay f)) (I.add p (even f) (I.mul p (odd f) u))
  | Lt => let half := rat (1 # 2) in let other := I.div p (odd f) w in
      I.add p (I.mul p (I.mul p half (I.add p (even f) other)) (faded (I.sub p (decay f) w)))
        (I.mul p (I.mul p half (I.sub p (even f) other)) (faded (I.add p (decay f) w)))
  end.
(** the value of a wave *)
Definition value F u := let f := parts F in I.add p (I.add p (still f) (I.mul p (drift f) u)) (swinging F u).
(** its derivative *)
Definition sloped F := let f := parts F in
  Bounded (Wave (drift f) I.zero (I.sub p (odd f) (I.mul p (decay f) (even f)))
    (I.sub p (I.neg (I.mul p (square f) (even f))) (I.mul p (decay f) (odd f))) (decay f) (square f)) (side F) (root F).
End Precision.

(** what is computed has what is meant *)
Ltac has := repeat first [assumption | apply has_rat | apply J.zero_correct | apply J.add_correct | apply J.sub_correct
  | apply J.mul_correct | apply J.div_correct | apply J.neg_correct | apply J.sqrt_correct | apply J.exp_correct
  | apply J.cos_correct | apply J.sin_correct | apply has_signed].

(** a swing beyond the critical damping *)
Lemma two_exponentials g w even odd u : 0 < w ->
  exp (- (g * u)) * (even * cosh (w * u) + odd * (sinh (w * u) / w)) =
  Q2R (1 # 2) * (even + odd / w) * exp (- ((g - w) * u)) + Q2R (1 # 2) * (even - odd / w) * exp (- ((g + w) * u)).
Proof.
  intros Hw. replace (- ((g - w) * u)) with (- (g * u) + w * u) by ring.
  replace (- ((g + w) * u)) with (- (g * u) + - (w * u)) by ring. rewrite !exp_plus. unfold cosh, sinh, Q2R; simpl.
  field; lra.
Qed.
(** as said *)
Lemma has_value p F f u i : has_wave F f -> has i u -> has (value p F i) (val f u).
Proof.
  intros [? ? ? ? ? ? S W] Hu. unfold value, val. apply J.add_correct; [has|]. unfold swinging, cosine, sine.
  destruct (side F); simpl in S; repeat (destruct Rlt_dec; try lra).
  - rewrite Rmult_1_r. has.
  - rewrite two_exponentials by (apply frequency_sq; lra). has.
  - has.
Qed.
(** as said *)
Lemma has_sloped p F f : has_wave F f -> has_wave (sloped p F) (slope f).
Proof. intros []. unfold sloped, slope. constructor; simpl; auto; has. Qed.

Section Program.
(** the precision of states, that of signs, and how often an interval is halved *)
Variables (p q : I.precision) (depth : nat).

(** *** Positive on an interval *)
(** between a and b, the values at both being positive: by its bounds, or rising, falling or concave, or by halves *)
Fixpoint stays depth (F F' F'' : bounded) a b : bool :=
  let i := hull q a b in
  if pos (value q F i) then true else
  let d := value q F' i in
  if nonneg d then true else if nonneg (I.neg d) then true else
  if nonneg (I.neg (value q F'' i)) then true else
  match depth with
  | O => false
  | S depth => let c := mid a b in
      if pos (value q F (rat q c)) then if stays depth F F' F'' a c then stays depth F F' F'' c b else false else false
  end.

(** as said *)
Lemma stays_spec n F f a b : has_wave F f -> stays n F (sloped q F) (sloped q (sloped q F)) a b = true ->
  Q2R a <= Q2R b -> 0 < val f (Q2R a) -> 0 < val f (Q2R b) -> forall u, Q2R a <= u <= Q2R b -> 0 < val f u.
Proof.
  intros W. pose proof (has_sloped q _ _ W) as W'. pose proof (has_sloped q _ _ W') as W''. revert a b.
  induction n as [|n IH]; intros a b; cbn [stays]; intros St Hab Pa Pb u Hu;
    destruct (pos (value q F (hull q a b))) eqn:E0.
  1, 3: apply (pos_spec _ _ E0), has_value, has_hull; auto.
  all: destruct (nonneg (value q (sloped q F) (hull q a b))) eqn:E1.
  1, 3: apply (rising_positive f (Q2R a) (Q2R b)); auto; intros r Hr; apply (nonneg_spec _ _ E1), has_value, has_hull;
    auto.
  all: destruct (nonneg (I.neg (value q (sloped q F) (hull q a b)))) eqn:E2.
  1, 3: apply (falling_positive f (Q2R a) (Q2R b)); auto; intros r Hr; apply Ropp_le_cancel; rewrite Ropp_0;
    apply (nonneg_spec _ _ E2), J.neg_correct, has_value, has_hull; auto.
  all: destruct (nonneg (I.neg (value q (sloped q (sloped q F)) (hull q a b)))) eqn:E3.
  1, 3: apply (concave_positive f (Q2R a) (Q2R b)); auto; intros r Hr; apply Ropp_le_cancel; rewrite Ropp_0;
    apply (nonneg_spec _ _ E3), J.neg_correct, has_value, has_hull; auto.
  - discriminate.
  - destruct (pos (value q F (rat q (mid a b)))) eqn:E4; [|discriminate].
    destruct (stays n F (sloped q F) (sloped q (sloped q F)) a (mid a b)) eqn:E5; [|discriminate].
    assert (Pc : 0 < val f (Q2R (mid a b))) by (apply (pos_spec _ _ E4), has_value, has_rat; auto).
    pose proof (mid_spec a b) as Mid. destruct (Rle_dec u (Q2R (mid a b))).
    + apply (IH a (mid a b)); auto; lra.
    + apply (IH (mid a b) b); auto; lra.
Qed.

(** how long a wave is surely positive from now on, found by halves *)
Fixpoint early n (F : bounded) d : option Q :=
  if pos (value q F (hull q 0 d)) then Some d else match n with O => None | S n => early n F (mid 0 d) end.

(** as said *)
Lemma early_spec n F f d e : has_wave F f -> early n F d = Some e -> 0 < Q2R d ->
  0 < Q2R e <= Q2R d /\ forall u, 0 <= u <= Q2R e -> 0 < val f u.
Proof.
  intros W. revert d. induction n as [|n IH]; intros d; cbn [early]; intros E Hd;
    destruct (pos (value q F (hull q 0 d))) eqn:E0.
  1, 3: injection E as <-; split; [lra|]; intros u Hu; apply (pos_spec _ _ E0), has_value, has_hull; auto;
    rewrite RMicromega.Q2R_0; auto.
  - discriminate.
  - pose proof (mid_spec 0 d) as Mid. rewrite RMicromega.Q2R_0 in Mid. destruct (IH (mid 0 d) E) as (Q & P); [lra|].
    split; [lra|auto].
Qed.

(** positive after 0 up to b, whatever the start is *)
Definition begins how k F b : bool :=
  let F' := sloped q F in let F'' := sloped q F' in
  posQ b && pos (value p F (rat p b)) &&
  match how with
  | Off => pos (value p F (rat p 0)) && stays depth F F' F'' 0 b
  | Touch => match early depth F' (mid 0 b) with
      | Some d => pos (value q F (rat q d)) && stays depth F F' F'' d b | None => false end
  | Edge k' => eqb k' k && match early depth F'' (mid 0 b) with
      | Some d => pos (value q F (rat q d)) && stays depth F F' F'' d b | None => false end
  end.

(** as said *)
Lemma begins_spec how k F f b : has_wave F f -> begins how k F b = true ->
  (how = Touch -> val f 0 = 0) -> (how = Edge k -> val f 0 = 0 /\ val (slope f) 0 = 0) ->
  0 < Q2R b /\ 0 <= val f 0 /\ (forall u, 0 < u <= Q2R b -> 0 < val f u).
Proof.
  intros W B At Ae. pose proof (has_sloped q _ _ W) as W'. pose proof (has_sloped q _ _ W') as W''.
  unfold begins in B. apply andb_true_iff in B. destruct B as (B & C). apply andb_true_iff in B.
    destruct B as (Hb & Pb).
  apply posQ_spec in Hb. apply pos_spec with (r := val f (Q2R b)) in Pb; [|apply has_value, has_rat; auto].
  split; auto. pose proof (mid_spec 0 b) as Mid. rewrite RMicromega.Q2R_0 in Mid.
  assert (Rest : forall d, 0 < Q2R d <= Q2R (mid 0 b) ->
    pos (value q F (rat q d)) && stays depth F (sloped q F) (sloped q
    (sloped q F)) d b = true ->
    (forall u, 0 < u <= Q2R d -> 0 < val f u) -> forall u, 0 < u <= Q2R b -> 0 < val f u).
  { intros d Hd E Q u Hu. apply andb_true_iff in E. destruct E as (Pd & St). destruct (Rle_dec u (Q2R d));
    [apply Q; lra|].
    apply (stays_spec depth F f d b); auto; [lra| |lra]. apply (pos_spec _ _ Pd), has_value, has_rat; auto. }
  destruct how as [| |k'].
  - apply andb_true_iff in C. destruct C as (P0 & St). apply pos_spec with (r := val f 0) in P0.
    + split; [lra|]. intros u Hu. apply (stays_spec depth F f 0 b); auto; rewrite ?RMicromega.Q2R_0; auto; lra.
    + apply has_value; auto. rewrite <- RMicromega.Q2R_0. apply has_rat.
  - rewrite (At eq_refl). split; [lra|]. destruct (early depth (sloped q F) (mid 0 b)) as [d|] eqn:E; [|discriminate].
    destruct (early_spec _ _ _ _ _ W' E ltac:(lra)) as (Hd & Q). apply (Rest d); auto.
    apply leaves_zero; auto. rewrite (At eq_refl); lra.
  - apply andb_true_iff in C. destruct C as (Hk & C). apply eqb_prop in Hk. subst k'. destruct (Ae eq_refl) as (Z & S).
    rewrite Z. split; [lra|]. destruct (early depth (sloped q (sloped q F)) (mid 0 b)) as [d|] eqn:E; [|discriminate].
    destruct (early_spec _ _ _ _ _ W'' E ltac:(lra)) as (Hd & Q). apply (Rest d); auto. intros u Hu.
    destruct (val_mean f 0 u ltac:(lra)) as (c & Hc & Ef). rewrite Z in Ef.
    assert (0 < val (slope f) c); [|nra]. apply (leaves_zero (slope f) (Q2R d)); auto; lra.
Qed.

(** *** The pair *)
(** the free swing of a mass: its decay, the square of its frequency, the sign of that, and the frequency *)
Record tone := Tone { slow : I.type; stiff : I.type; kind : comparison; pitch : I.type }.
(** the numbers of a scene, computed once *)
Record kit := Kit { j1 : I.type; j2 : I.type; jM : I.type; c1 : I.type; c2 : I.type; cb : I.type;
  alone : tone; together : tone }.

(** how fast a swing of the mass m decays, and the square of its frequency *)
Definition fadeQ sc m := Qred (a1 sc / (2 * m)).
(** the square of its frequency *)
Definition squareQ sc m := Qred (a2 sc / m - fadeQ sc m * fadeQ sc m).
(** the mass of both bodies *)
Definition both sc := (m1 sc + m2 sc)%Q.
(** the swing of a mass *)
Definition tuned sc m := let d := squareQ sc m in
  Tone (rat p (fadeQ sc m)) (rat p d) (d ?= 0)%Q (I.sqrt p (I.abs (rat p d))).
(** the numbers *)
Definition numbers sc := Kit (rat p (m1 sc)) (rat p (m2 sc)) (rat p (both sc)) (rat p (a1 sc)) (rat p (a2 sc))
  (rat p (b sc)) (tuned sc (m1 sc)) (tuned sc (both sc)).

(** what a scene has to be: masses, stiffness and friction positive, damping not negative *)
Definition fair sc := posQ (m1 sc) && posQ (m2 sc) && nonnegQ (a1 sc) && posQ (a2 sc) && posQ (b sc).

(** the waves of Waves.v *)
Definition swings T c x v := let y := I.sub p x c in
  Bounded (Wave c I.zero y (I.add p v (I.mul p (slow T) y)) (slow T) (stiff T)) (kind T) (pitch T).
(** body 1 in a slip *)
Definition slides K k x v1 := swings (alone K) (I.neg (I.div p (signed k (cb K)) (c2 K))) x v1.
(** body 2's velocity in a slip *)
Definition drives K k v2 u := I.add p v2 (I.mul p (I.div p (signed k (cb K)) (j2 K)) u).
(** the guard of a slip *)
Definition guards K k x v1 v2 := let F := sloped p (slides K k x v1) in
  let f := parts F in
  Bounded (Wave (I.neg (signed k v2)) (I.neg (I.div p (cb K) (j2 K))) (signed k (even f)) (signed k (odd f))
    (decay f) (square f)) (side F) (root F).
(** both bodies in a stick *)
Definition sticks K x v := swings (together K) I.zero x v.
(** the guard of a stick *)
Definition grips K k x v := let F := sloped p (sloped p (sticks K x v)) in
  let f := parts F in
  Bounded (Wave (I.div p (cb K) (j2 K)) I.zero (I.neg (signed k (even f))) (I.neg (signed k (odd f)))
    (decay f) (square f)) (side F) (root F).

(** where a stick ends towards k with the velocity v *)
Definition edge K k v := I.div p
  (I.sub p (I.neg (signed k (I.div p (I.mul p (cb K) (jM K)) (j2 K)))) (I.mul p (c1 K) v)) (c2 K).

(** a state: its time, place and velocities, and what else is known of it *)
Record state := State { clock : I.type; at_x : I.type; at_v1 : I.type; at_v2 : I.type; how : start }.

(** whether a stick at the start is at its end towards k *)
Definition on_edge sc (k : bool) :=
  Qeq_bool (m2 sc * (a2 sc * x_0 sc + a1 sc * v1_0 sc)) ((if k then -1 else 1) * (b sc * both sc)).
(** the state at the time 0 *)
Definition initial sc := State (rat p 0) (rat p (x_0 sc)) (rat p (v1_0 sc)) (rat p (v2_0 sc))
  (if Qeq_bool (v1_0 sc) (v2_0 sc) then
     if on_edge sc true then Edge true else if on_edge sc false then Edge false else Touch
   else Off).

(** inside the bounds *)
Definition inside i (c : Q * Q) := nonneg (I.sub p i (rat p (fst c))) && nonneg (I.sub p (rat p (snd c)) i).

(** known to touch *)
Definition touches h := match h with Off => false | _ => true end.

(** what is known of the friction that is left towards k in a stick: nothing, or that there is none yet *)
Definition held h k := match h with Edge k' => if eqb k' k then Touch else Off | _ => Off end.

(** the state at the next event, if the table is right about the mode until then *)
Definition step K st m h : option state :=
  let u := hull p (least h) (most h) in
  match m with
  | Slip k =>
      let F := guards K k (at_x st) (at_v1 st) (at_v2 st) in
      if Qle_bool (least h) (most h) && begins (how st) k F (least h) && nonneg (I.neg (value p F (rat p (most h))))
      then
        let v := drives K k (at_v2 st) u in
        Some (State (I.add p (clock st) u) (value p (slides K k (at_x st) (at_v1 st)) u) v v Touch)
      else None
  | Stick =>
      let k := towards h in
      let F := grips K k (at_x st) (at_v1 st) in
      let G := grips K (negb k) (at_x st) (at_v1 st) in
      if touches (how st) && Qle_bool (least h) (most h) && begins (held (how st) k) k F (least h) &&
        begins (held (how st) (negb k)) (negb k) G (most h) && nonneg (I.neg (value p F (rat p (most h)))) then
        let v := value p (sloped p (sticks K (at_x st) (at_v1 st))) u in
        Some (State (I.add p (clock st) u) (edge K k v) v v (Edge k))
      else None
  end.

(** the end, if the table is right about it; the hint says for how long at least the mode lasts *)
Definition ends K st e h : bool :=
  let u := I.sub p (rat p (last e)) (clock st) in
  pos u && nonneg (I.sub p (rat p (least h)) u) &&
  match last_mode e with
  | Slip k =>
      let f := slides K k (at_x st) (at_v1 st) in
      let F := guards K k (at_x st) (at_v1 st) (at_v2 st) in
      begins (how st) k F (least h) &&
      inside (value p f u) (last_place e) && inside (value p (sloped p f) u) (last_v1 e) &&
      inside (drives K k (at_v2 st) u) (last_v2 e) && inside (signed k (value p F u)) (last_relative e)
  | Stick =>
      let f := sticks K (at_x st) (at_v1 st) in
      touches (how st) && begins (held (how st) true) true (grips K true (at_x st) (at_v1 st)) (least h) &&
      begins (held (how st) false) false (grips K false (at_x st) (at_v1 st)) (least h) &&
      inside (value p f u) (last_place e) && inside (value p (sloped p f) u) (last_v1 e) &&
      inside (value p (sloped p f) u) (last_v2 e) &&
      inside I.zero (last_relative e)
  end.

(** event after event *)
Fixpoint goes K st events e hints : bool :=
  match events, hints with
  | now :: later, h :: hints => match step K st (mode_until now) h with
      | Some st => if inside (clock st) (time now) && inside (at_x st) (place now) && inside (at_v1 st) (speed now)
          then goes K st later e hints else false
      | None => false end
  | [], [h] => ends K st e h
  | _, _ => false
  end.

(** the program *)
Definition check sc events e hints : bool := fair sc && goes (numbers sc) (initial sc) events e hints.

(** *** It is right *)
(** as said *)
Lemma on_edge_spec sc k : 0 < Q2R (m2 sc) -> on_edge sc k = true ->
  Q2R (a2 sc) * Q2R (x_0 sc) + Q2R (a1 sc) * Q2R (v1_0 sc) =
  - (sign k * (Q2R (b sc) * (Q2R (m1 sc) + Q2R (m2 sc)) / Q2R (m2 sc))).
Proof.
  intros Hm E. apply Qeq_bool_iff, Qeq_eqR in E. unfold both in E. rewrite !Q2R_mult, !Q2R_plus, !Q2R_mult in E.
  replace (Q2R (if k then -1 else 1)) with (- sign k) in E by (destruct k; unfold Q2R; simpl; lra).
  apply Rmult_eq_reg_l with (Q2R (m2 sc)); [|lra]. rewrite E. field; lra.
Qed.

Section Sound.
Variable sc : scene.
Let M1 := Q2R (m1 sc).
Let M2 := Q2R (m2 sc).
Let A1 := Q2R (a1 sc).
Let A2 := Q2R (a2 sc).
Let B := Q2R (b sc).
Hypotheses (Hm1 : 0 < M1) (Hm2 : 0 < M2) (Ha1 : 0 <= A1) (Ha2 : 0 < A2) (Hb : 0 < B).

(** the computed swing is that of the mass *)
Record has_tone (T : tone) m : Prop := { h_slow : has (slow T) (fade m A1);
  h_stiff : has (stiff T) (A2 / m - fade m A1 * fade m A1); h_kind : on_side (kind T) (A2 / m - fade m A1 * fade m A1);
  h_pitch : has (pitch T) (sqrt (Rabs (A2 / m - fade m A1 * fade m A1))) }.
(** the computed numbers are those of the scene *)
Record has_kit (K : kit) : Prop := { h_j1 : has (j1 K) M1; h_j2 : has (j2 K) M2; h_jM : has (jM K) (M1 + M2);
  h_c1 : has (c1 K) A1; h_c2 : has (c2 K) A2; h_cb : has (cb K) B;
  h_alone : has_tone (alone K) M1; h_together : has_tone (together K) (M1 + M2) }.

(** the sign of a rational number *)
Lemma on_side_Q d : on_side (d ?= 0)%Q (Q2R d).
Proof.
  destruct (Qcompare_spec d 0); simpl; rewrite <- RMicromega.Q2R_0; [apply Qeq_eqR|apply Qlt_Rlt|apply Qlt_Rlt]; auto.
Qed.
(** a positive number is not 0 *)
Lemma not_0 m : 0 < Q2R m -> ~ (m == 0)%Q.
Proof. intros Hm E. apply Qeq_eqR in E. rewrite RMicromega.Q2R_0 in E. lra. Qed.
(** as said *)
Lemma fadeQ_spec m : 0 < Q2R m -> Q2R (fadeQ sc m) = fade (Q2R m) A1.
Proof.
  intros Hm. assert (E : Q2R (2 * m) = 2 * Q2R m) by (rewrite Q2R_mult; unfold Q2R at 1; simpl; lra).
  unfold fadeQ, fade. rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_div, E; auto. apply not_0. lra.
Qed.
(** as said *)
Lemma squareQ_spec m : 0 < Q2R m -> Q2R (squareQ sc m) = A2 / Q2R m - fade (Q2R m) A1 * fade (Q2R m) A1.
Proof.
  intros Hm. unfold squareQ.
  rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_minus, Q2R_div, Q2R_mult, !fadeQ_spec by (auto using not_0). auto.
Qed.
(** as said *)
Lemma has_tuned m : 0 < Q2R m -> has_tone (tuned sc m) (Q2R m).
Proof.
  intros Hm. unfold tuned. constructor; simpl; rewrite <- ?squareQ_spec by auto; auto using has_rat, on_side_Q.
  - rewrite <- fadeQ_spec by auto. apply has_rat.
  - apply J.sqrt_correct, (I.abs_correct _ (Xreal (Q2R (squareQ sc m)))), has_rat.
Qed.
(** as said *)
Lemma has_numbers : has_kit (numbers sc).
Proof.
  assert (E : M1 + M2 = Q2R (both sc)) by (unfold both; rewrite Q2R_plus; auto).
  unfold numbers. constructor; rewrite ?E; simpl; try apply has_tuned; try apply has_rat; auto. rewrite <- E. lra.
Qed.

Section Kit.
Variable K : kit.
Hypothesis HK : has_kit K.

(** as said *)
Lemma has_swings T c x v m c' x' v' : has_tone T m -> has c c' -> has x x' -> has v v' ->
  has_wave (swings T c x v) (swing A1 A2 m c' x' v').
Proof. intros []. intros. unfold swings, swing. constructor; simpl; auto; has. Qed.
(** as said *)
Lemma has_slides k x v x' v' : has x x' -> has v v' -> has_wave (slides K k x v) (slide M1 A1 A2 B (sign k) x' v').
Proof. destruct HK. intros. unfold slides, slide. apply has_swings; has. Qed.
(** as said *)
Lemma has_sticks x v x' v' : has x x' -> has v v' -> has_wave (sticks K x v) (stuck M1 M2 A1 A2 x' v').
Proof. destruct HK. intros. unfold sticks, stuck. apply has_swings; has. Qed.
(** as said *)
Lemma has_drives k v u v' u' : has v v' -> has u u' -> has (drives K k v u) (v' + sign k * B / M2 * u').
Proof. destruct HK. intros. unfold drives. has. Qed.
(** as said *)
Lemma has_guards k x v w x' v' w' : has x x' -> has v v' -> has w w' ->
  has_wave (guards K k x v w) (guard M1 M2 A1 A2 B (sign k) x' v' w').
Proof.
  intros Hx Hv Hw. destruct (has_sloped p _ _ (has_slides k x v x' v' Hx Hv)). destruct HK. unfold guards, guard.
  constructor; simpl; auto; has.
Qed.
(** as said *)
Lemma has_grips k x v x' v' : has x x' -> has v v' -> has_wave (grips K k x v) (grip M1 M2 A1 A2 B (sign k) x' v').
Proof.
  intros Hx Hv. destruct (has_sloped p _ _ (has_sloped p _ _ (has_sticks x v x' v' Hx Hv))). destruct HK.
  unfold grips, grip. constructor; simpl; auto; has.
Qed.

Variables x v1 v2 s : R -> R.
Hypothesis H : solution M1 M2 A1 A2 B x v1 v2 s.

(** the bounds hold at the time t *)
Definition knows st t := has (clock st) t /\ has (at_x st) (x t) /\ has (at_v1 st) (v1 t) /\ has (at_v2 st) (v2 t) /\
  match how st with Off => True | Touch => v1 t = v2 t
  | Edge k => v1 t = v2 t /\ A2 * x t + A1 * v1 t = - (sign k * (B * (M1 + M2) / M2)) end.

(** the guard of a slip, once it is accepted *)
Lemma slip_begins st t k hi : knows st t ->
  begins (how st) k (guards K k (at_x st) (at_v1 st) (at_v2 st)) hi = true ->
  0 < Q2R hi /\ 0 <= val (guard M1 M2 A1 A2 B (sign k) (x t) (v1 t) (v2 t)) 0 /\
  (forall u, 0 < u <= Q2R hi -> 0 < val (guard M1 M2 A1 A2 B (sign k) (x t) (v1 t) (v2 t)) u).
Proof.
  intros (Kt & Kx & K1 & K2 & Kh) E. apply (begins_spec (how st) k (guards K k (at_x st) (at_v1 st) (at_v2 st))); auto.
  - apply has_guards; auto.
  - intros Eh. rewrite Eh in Kh. rewrite <- Kh. apply guard_touch; auto using sign_cases.
  - intros Eh. rewrite Eh in Kh. destruct Kh as (Ev & Ex). rewrite <- Ev. split.
    + apply guard_touch; auto using sign_cases.
    + apply guard_edge; auto using sign_cases.
Qed.

(** and that of a stick *)
Lemma stick_begins st t k hi : knows st t ->
  begins (held (how st) k) k (grips K k (at_x st) (at_v1 st)) hi = true ->
  0 < Q2R hi /\ 0 <= val (grip M1 M2 A1 A2 B (sign k) (x t) (v1 t)) 0 /\
  (forall u, 0 < u <= Q2R hi -> 0 < val (grip M1 M2 A1 A2 B (sign k) (x t) (v1 t)) u).
Proof.
  intros (Kt & Kx & K1 & K2 & Kh) E. apply (begins_spec (held (how st) k) k (grips K k (at_x st) (at_v1 st))); auto.
  - apply has_grips; auto.
  - unfold held. destruct (how st) as [| |k']; try discriminate. destruct (eqb k' k) eqn:Ek; [|discriminate].
    apply eqb_prop in Ek. subst k'. intros _. apply grip_edge; auto using sign_cases. apply Kh.
  - unfold held. destruct (how st) as [| |k']; try discriminate. destruct (eqb k' k); discriminate.
Qed.

(** a touching state touches *)
Lemma knows_touch st t : knows st t -> touches (how st) = true -> v1 t = v2 t.
Proof. intros (_ & _ & _ & _ & Kh). destruct (how st); try discriminate; intuition. Qed.

(** one event *)
Lemma step_sound st t m h st' : 0 <= t -> knows st t -> step K st m h = Some st' ->
  exists t', t < t' /\ v1 t' = v2 t' /\ (forall u, t < u < t' -> in_mode m (v1 u) (v2 u)) /\ knows st' t'.
Proof.
  intros Ht Kn. pose proof Kn as (Kt & Kx & K1 & K2 & Kh). destruct m as [k|]; cbn [step].
  - destruct (Qle_bool (least h) (most h)) eqn:E0; [|discriminate].
    destruct (begins _ _ _ _) eqn:E1; [|discriminate]. destruct (nonneg _) eqn:E2; [|discriminate]. intros E.
    injection E as <-. apply Qle_bool_iff, Qle_Rle in E0. destruct (slip_begins st t k (least h) Kn E1) as (Hl & Z & P).
    apply nonneg_spec with (r := - val (guard M1 M2 A1 A2 B (sign k) (x t) (v1 t) (v2 t)) (Q2R (most h))) in E2;
      [|apply J.neg_correct, has_value, has_rat; apply has_guards; auto].
    destruct (slip_until M1 M2 A1 A2 B Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H t Ht (sign k) (Q2R (least h)) (Q2R (most h)))
      as (u & Hu & Q & Ev & Ex & E3); auto using sign_cases; [lra|].
    assert (Hh : has (hull p (least h) (most h)) u) by (apply has_hull; lra).
    assert (Hv : has (drives K k (at_v2 st) (hull p (least h) (most h))) (v2 (t + u))) by (rewrite E3;
      apply has_drives; auto).
    exists (t + u). split; [lra|]. split; [auto|]. split.
    + intros r Hr. specialize (Q (r - t) ltac:(lra)). replace (t + (r - t)) with r in Q by ring.
      destruct k; simpl in *; lra.
    + unfold knows; cbn [clock at_x at_v1 at_v2 how]. split; [has|]. split; [|rewrite Ev; auto].
      rewrite Ex. apply has_value; auto. apply has_slides; auto.
  - destruct (touches (how st)) eqn:Et; [|discriminate]. destruct (Qle_bool (least h) (most h)) eqn:E0; [|discriminate].
    destruct (begins _ _ (grips K (towards h) _ _) _) eqn:E1; [|discriminate].
    destruct (begins _ _ (grips K (negb (towards h)) _ _) _) eqn:E2; [|discriminate].
    destruct (nonneg _) eqn:E3; [|discriminate]. intros E. injection E as <-. set (k := towards h) in *.
    apply Qle_bool_iff, Qle_Rle in E0. pose proof (knows_touch st t Kn Et) as Ev0.
    destruct (stick_begins st t k (least h) Kn E1) as (Hl & Z & P).
    destruct (stick_begins st t (negb k) (most h) Kn E2) as (Hm & Z' & P').
    replace (sign (negb k)) with (- sign k) in Z', P' by (destruct k; simpl; ring).
    apply nonneg_spec with (r := - val (grip M1 M2 A1 A2 B (sign k) (x t) (v1 t)) (Q2R (most h))) in E3;
      [|apply J.neg_correct, has_value, has_rat; apply has_grips; auto].
    destruct (stick_until M1 M2 A1 A2 B Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H t Ht (sign k) (Q2R (least h)) (Q2R (most
      h)))
      as (u & Hu & Ev & Ee & _ & E4); auto using sign_cases; [|lra|].
    { intros r Hr. destruct (Req_dec r 0) as [->|]; auto. apply Rlt_le, P'; lra. }
    assert (Hh : has (hull p (least h) (most h)) u) by (apply has_hull; lra).
    assert (Hv : has (value p (sloped p (sticks K (at_x st) (at_v1 st))) (hull p (least h) (most h))) (v1 (t + u))).
    { rewrite E4. apply has_value; auto. apply has_sloped, has_sticks; auto. }
    exists (t + u). split; [lra|]. split; [apply Ev; lra|]. split.
    + intros r Hr. specialize (Ev (r - t) ltac:(lra)). replace (t + (r - t)) with r in Ev by ring. auto.
    + unfold knows; cbn [clock at_x at_v1 at_v2 how]. rewrite <- (Ev u) by lra. split; [has|]. split; [|auto].
      replace (x (t + u)) with ((- (sign k * (B * (M1 + M2) / M2)) - A1 * v1 (t + u)) / A2) by (rewrite <- Ee; field;
        lra).
      destruct HK. unfold edge. has.
Qed.

(** inside the bounds *)
Lemma inside_spec i c r : inside i c = true -> has i r -> within c r.
Proof.
  intros E Hi. apply andb_true_iff in E. destruct E as (E1 & E2).
  apply nonneg_spec with (r := r - Q2R (fst c)) in E1; [|has]. apply nonneg_spec with (r := Q2R (snd c) - r) in E2;
    [|has].
  split; lra.
Qed.

(** the end *)
Lemma ends_sound st t e h : 0 <= t -> knows st t -> ends K st e h = true -> unfolds x v1 v2 t [] e.
Proof.
  intros Ht Kn. pose proof Kn as (Kt & Kx & K1 & K2 & Kh). unfold ends. set (iu := I.sub p (rat p (last e)) (clock st)).
  assert (Hu : has iu (Q2R (last e) - t)) by (unfold iu; has). set (u := Q2R (last e) - t) in *.
  intros E. apply andb_true_iff in E. destruct E as (E & Em). apply andb_true_iff in E. destruct E as (E1 & E2).
  apply pos_spec with (r := u) in E1; auto. apply nonneg_spec with (r := Q2R (least h) - u) in E2; [|has].
  assert (Eu : Q2R (last e) = t + u) by (unfold u; ring). cbn [unfolds]. split; [lra|]. rewrite Eu.
  destruct (last_mode e) as [k|].
  - rewrite !andb_true_iff in Em. destruct Em as ((((Em & B0) & B1) & B2) & B3).
    destruct (slip_begins st t k (least h) Kn Em) as (Hl & Z & P).
    assert (Nn : forall r, 0 <= r < u -> 0 <= val (guard M1 M2 A1 A2 B (sign k) (x t) (v1 t) (v2 t)) r).
    { intros r Hr. destruct (Req_dec r 0) as [->|]; auto. apply Rlt_le, P; lra. }
    assert (F := slip_phase M1 M2 A1 A2 B Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H t Ht (sign k) u (sign_cases k) ltac:(lra) Nn).
    assert (G : forall r, 0 <= r <= u ->
      sign k * (v1 (t + r) - v2 (t + r)) = val (guard M1 M2 A1 A2 B (sign k) (x t) (v1 t)
      (v2 t)) r).
    { intros r Hr. destruct (F r Hr) as (_ & -> & ->). rewrite val_guard by auto using sign_cases. auto. }
    destruct (F u ltac:(lra)) as (Fx & F1 & F2). pose proof (has_slides k _ _ _ _ Kx K1) as W. split; [|split; [|split;
      [|split]]].
    + intros r Hr. specialize (P (r - t) ltac:(lra)). rewrite <- G in P by lra. replace (t + (r - t)) with r in P
      by ring.
      destruct k; simpl in *; lra.
    + apply (inside_spec _ _ _ B0). rewrite Fx. apply has_value; auto.
    + apply (inside_spec _ _ _ B1). rewrite F1. apply has_value; auto. apply has_sloped; auto.
    + apply (inside_spec _ _ _ B2). rewrite F2. apply has_drives; auto.
    + apply (inside_spec _ _ _ B3).
      replace (v1 (t + u) - v2 (t + u)) with (sign k * (sign k * (v1 (t + u) - v2 (t + u)))) by (destruct k; simpl;
        ring).
      rewrite G by lra. apply has_signed, has_value; auto. apply has_guards; auto.
  - rewrite !andb_true_iff in Em. destruct Em as ((((((Em & C1) & C2) & B0) & B1) & B2) & B3).
    pose proof (knows_touch st t Kn Em) as Ev0.
    destruct (stick_begins st t true (least h) Kn C1) as (Hl & Z & P).
    destruct (stick_begins st t false (least h) Kn C2) as (_ & Z' & P').
    assert (Both : forall r, 0 <= r < u -> 0 <= val (grip M1 M2 A1 A2 B 1 (x t) (v1 t)) r /\
      0 <= val (grip M1 M2 A1 A2 B (-1) (x t) (v1 t)) r).
    { intros r Hr. destruct (Req_dec r 0) as [->|]; auto. split; apply Rlt_le; [apply P|apply P']; lra. }
    assert (F := stick_phase M1 M2 A1 A2 B Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H t Ht u ltac:(lra) Ev0 Both).
    destruct (F u ltac:(lra)) as (Fx & F1 & F2). pose proof (has_sticks _ _ _ _ Kx K1) as W. split;
      [|split; [|split; [|split]]].
    + intros r Hr. destruct (F (r - t) ltac:(lra)) as (_ & G1 & G2). replace (t + (r - t)) with r in * by ring.
      simpl. congruence.
    + apply (inside_spec _ _ _ B0). rewrite Fx. apply has_value; auto.
    + apply (inside_spec _ _ _ B1). rewrite F1. apply has_value; auto. apply has_sloped; auto.
    + apply (inside_spec _ _ _ B2). rewrite F2. apply has_value; auto. apply has_sloped; auto.
    + apply (inside_spec _ _ _ B3). rewrite F1, F2, Rminus_diag_eq by auto. apply J.zero_correct.
Qed.

(** all events *)
Lemma goes_sound e events : forall hints st t, 0 <= t -> knows st t -> goes K st events e hints = true ->
  unfolds x v1 v2 t events e.
Proof.
  induction events as [|now later IH]; intros [|h hints] st t Ht Kn; cbn [goes]; try discriminate.
  - destruct hints; [|discriminate]. apply ends_sound; auto.
  - destruct (step K st (mode_until now) h) as [st'|] eqn:E; [|discriminate].
    destruct (inside (clock st') (time now)) eqn:E1; [|discriminate].
    destruct (inside (at_x st') (place now)) eqn:E2; [|discriminate].
    destruct (inside (at_v1 st') (speed now)) eqn:E3; [|discriminate]. intros G.
    destruct (step_sound st t _ _ _ Ht Kn E) as (t' & Ht' & Ev & Q & Kn'). pose proof Kn' as (Kt & Kx & K1 & _ & _).
    exists t'. repeat (split; [solve [auto; eapply inside_spec; eauto]|]). apply (IH hints st' t'); auto; lra.
Qed.
End Kit.
End Sound.

(** What the program accepts is true of every motion of the scene. *)
Theorem sound sc events e hints : check sc events e hints = true -> forall x v1 v2 s, motion sc x v1 v2 s ->
  unfolds x v1 v2 0 events e.
Proof.
  intros E x v1 v2 s (H & X0 & V1 & V2). apply andb_true_iff in E. destruct E as (Fa & G). unfold fair in Fa.
  repeat (apply andb_true_iff in Fa; let A := fresh "P" in destruct Fa as (Fa & A)).
  apply posQ_spec in Fa. apply posQ_spec in P2. apply posQ_spec in P0. apply posQ_spec in P. apply nonnegQ_spec in P1.
  apply (goes_sound sc) with (K := numbers sc) (s := s) (hints := hints) (st := initial sc); auto; try lra.
  - apply has_numbers; auto.
  - unfold knows, initial; cbn [clock at_x at_v1 at_v2 how]. rewrite X0, V1, V2. repeat (split; [|]); try apply has_rat.
    + rewrite <- RMicromega.Q2R_0. apply has_rat.
    + destruct (Qeq_bool (v1_0 sc) (v2_0 sc)) eqn:E; auto. apply Qeq_bool_iff, Qeq_eqR in E.
      destruct (on_edge sc true) eqn:E1; [|destruct (on_edge sc false) eqn:E2]; auto; split; auto;
        apply on_edge_spec; auto.
Qed.
End Program.
End Check.
