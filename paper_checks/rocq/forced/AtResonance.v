(** A sine at the frequency of body 1 alone, without a damper, of the amplitude 4 b/pi: just what friction takes. There
    is a family of motions that slip for ever, one way for half a period and then the other way; so every motion is
    bounded, and none attracts the others. *)
From InertialPair Require Import Dini Pair EnergyLimit Forced Approach Arcs Nonstop NonstopUndamped.

Section Edge.
Variables m1 m2 a2 b om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om) (Tuned : a2 = m1 * om ^ 2).
(** the amplitude *)
Let F := 4 * b / PI.
(** half a period *)
Let T := PI / om.
(** how fast body 2 is at the turns *)
Let h := PI * b / (2 * m2 * om).
Let k := F / (2 * m1 * om).

(** one of the family: its place, and the velocities of both bodies, from a turn to the next *)
Definition edge_x c t := (F / 2 - m1 * om * h) / a2 * sin (om * t) - b / a2 - (c + k * (om * t)) * cos (om * t) / om.
Definition edge_v1 c t := (c + k * (om * t)) * sin (om * t) - h * cos (om * t).
Definition edge_v2 t := b / m2 * t - h.

(** by how much it is faster than body 2 *)
Lemma edge_ahead c t : edge_v1 c t - edge_v2 t =
  (c + k * (om * t)) * sin (om * t) + b / (m2 * om) * (PI / 2 * (1 - cos (om * t)) - om * t).
Proof. unfold edge_v1, edge_v2, h. field. lra. Qed.

(** it does slip forwards: faster between the turns *)
Lemma edge_slips c t : b / (m2 * om) <= c -> 0 < t < T -> edge_v2 t < edge_v1 c t.
Proof.
  intros Hc Ht. pose proof PI_RGT_0 as P. assert (Hg : 0 < b / (m2 * om)) by positive. set (g := b / (m2 * om)) in *.
  assert (Kp : 0 < k) by (unfold k, F; positive). set (y := om * t).
  assert (Hy : 0 < y < PI). { unfold y, T in *. split; [positive|]. replace PI with (om * (PI / om)) by (field; lra).
    apply Rmult_lt_compat_l; lra. }
  assert (S : 0 < sin y) by (apply sin_gt_0; lra). pose proof (half_turn y Hy) as G.
  apply (Rmult_lt_compat_l g) in G; [|lra]. assert (g * sin y <= c * sin y) by (apply Rmult_le_compat_r; lra).
  assert (0 < k * y * sin y) by positive. pose proof (edge_ahead c t) as E. fold g y in E. lra.
Qed.

(** and for no smaller c *)
Lemma edge_least c : (forall t, 0 < t < T -> edge_v2 t < edge_v1 c t) -> b / (m2 * om) <= c.
Proof.
  intros H. pose proof PI_RGT_0 as P. assert (HT : 0 < T) by (unfold T; positive). apply Rnot_lt_le. intros L.
  set (l := om * (b / (m2 * om) - c)). assert (Hl : 0 < l) by (apply Rmult_lt_0_compat; lra).
  assert (D : rderiv (fun t => edge_v1 c t - edge_v2 t) 0 (- l)).
  { apply rderiv_of_derive. unfold edge_v1, edge_v2. auto_derive; auto.
    rewrite !Rmult_0_r, sin_0, cos_0. unfold l. field. lra. }
  assert (Z : edge_v1 c 0 - edge_v2 0 = 0) by
    (unfold edge_v1, edge_v2; rewrite !Rmult_0_r, sin_0, cos_0; ring).
  destruct (D l Hl) as (d & Hd & K). set (t := Rmin (d / 2) (T / 2)). least t. assert (0 < t) by positive.
  specialize (K t ltac:(lra)). specialize (H t ltac:(lra)). rewrite Rplus_0_l in K. by_sizes.
Qed.

(** half a period as an arc of a motion *)
Lemma edge_arc c : b / (m2 * om) <= c -> forced_arc m1 m2 0 a2 b T (fun t => F * sin (om * t + 0)) (edge_x c) (edge_v1 c) edge_v2 (fun _ => 1).
Proof.
  intros Hc. pose proof PI_RGT_0 as P. apply slip_arc; auto.
  - intros t. unfold edge_x, edge_v1. auto_derive; auto. rewrite Tuned. unfold k, F, h. field. repeat split; lra.
  - intros t. unfold edge_x, edge_v1. auto_derive; auto. rewrite Rplus_0_r, Tuned. unfold k, F, h. field. repeat split; lra.
  - intros t. unfold edge_v2. auto_derive; auto. field. lra.
  - intros t Ht. destruct (Req_dec t 0) as [->|N]; [|pose proof (edge_slips c t Hc ltac:(lra)); lra].
    unfold edge_v1, edge_v2. rewrite !Rmult_0_r, sin_0, cos_0. lra.
Qed.

(** *** a motion that slips for ever, for these c *)

Lemma edge_motion c : b / (m2 * om) <= c -> exists x v1 v2 s, nonstop m1 m2 0 a2 b om F 0 x v1 v2 s /\
  forall t, 0 <= t <= T -> x t = edge_x c t /\ v1 t = edge_v1 c t /\ v2 t = edge_v2 t.
Proof.
  intros Hc. pose proof PI_RGT_0 as P. assert (OT : om * T = PI) by (unfold T; field; lra).
  apply (nonstop_arc m1 m2 0 a2 b om Hm1 Hm2 (Rle_refl 0) Ha2 Hb Hom F 0 _ _ _ (edge_arc c Hc)).
  1: intros; apply edge_slips; auto.
  all: fold T; unfold edge_x, edge_v1, edge_v2.
  all: rewrite ?OT, ?sin_PI, ?cos_PI, !Rmult_0_r, ?sin_0, ?cos_0, ?Tuned.
  all: unfold k, F, h, T; field; repeat split; lra.
Qed.

(** [resonance-edge] With $a_1=0$, under $u=\frac{4b}{\pi}\sin\omega_1t$ there is a family of motions that slip
    permanently, one way for half a period and then the other way, in closed form: for $c\geqslant\frac{b}{m_2\omega_1}$,
    and for no smaller $c$. *)
Theorem edge_family c : b / (m2 * om) <= c <-> exists x v1 v2 s, nonstop m1 m2 0 a2 b om F 0 x v1 v2 s /\
  forall t, 0 <= t <= T -> x t = edge_x c t /\ v1 t = edge_v1 c t /\ v2 t = edge_v2 t.
Proof.
  split; [apply edge_motion|]. intros (x & v1 & v2 & s & (_ & Slips & _) & Q). apply edge_least. intros t Ht.
  destruct (Q t ltac:(lra)) as (_ & <- & <-). apply Slips. unfold T in Ht. lra.
Qed.

(** *** so every motion is bounded *)

(** [resonance-edge-bounded] With $a_1=0$, every motion under $u=\frac{4b}{\pi}\sin\omega_1t$ is bounded. *)
Theorem edge_bounded x v1 v2 s : forced m1 m2 0 a2 b (wave F om 0) x v1 v2 s ->
  exists B, forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B /\ Rabs (v2 t) <= B.
Proof.
  intros H. pose proof PI_RGT_0 as P. assert (HT : 0 < T) by (unfold T; positive).
  destruct (edge_motion (b / (m2 * om)) (Rle_refl _)) as (y & w1 & w2 & z & (Hy & _ & Anti) & _).
  fold T in Anti. assert (Bd : forall f, cont f -> (forall t, 0 <= t -> f (T + t) = - f t) ->
    exists B, forall t, 0 <= t -> Rabs (f t) <= B).
  { intros f Cf Af. destruct (cont_bounded f T Cf ltac:(lra)) as (B & HB). exists B. intros t Ht.
    destruct (one_turn T t HT Ht) as (n & u & -> & Hu). rewrite (repeats (fun t => Rabs (f t)) T); try lra.
    - apply HB. lra.
    - intros r Hr. rewrite Af, Rabs_Ropp; auto. }
  destruct (Bd y) as (B1 & H1); [continuous|intros; apply Anti; auto|].
  destruct (Bd w1) as (B2 & H2); [continuous|intros; apply Anti; auto|].
  destruct (Bd w2) as (B3 & H3); [continuous|intros; apply Anti; auto|].
  set (D := fun t => energy m1 m2 a2 (x t - y t) (v1 t - w1 t) (v2 t - w2 t)).
  assert (Mono : forall t, 0 <= t -> D t <= D 0)
    by (intros t Ht; apply (forced_contraction m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ _ 0 t H Hy); lra).
  exists (B1 + B2 + B3 + reach m1 m2 a2 (D 0)). intros t Ht.
  specialize (H1 t Ht). specialize (H2 t Ht). specialize (H3 t Ht).
  pose proof (Rabs_pos (y t)). pose proof (Rabs_pos (w1 t)). pose proof (Rabs_pos (w2 t)).
  apply (beside m1 m2 a2 _ _ _ (y t) (w1 t) (w2 t) _ (D 0)); auto; [exact (Mono t Ht)|lra].
Qed.
End Edge.
