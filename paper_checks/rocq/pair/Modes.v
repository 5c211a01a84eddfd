(** Modes: stick, slip forwards, slip backwards. A motion changes its mode finitely often in bounded time if one mode
    lasts for a while after every time and before every time. *)
From Coq Require Import Classical.
From InertialPair Require Import Dini.

(** between two times the pair sticks, or slips with one sign *)
Definition one_mode (v1 v2 : R -> R) p q := (forall t, p < t < q -> v1 t = v2 t) \/
  (forall t, p < t < q -> v2 t < v1 t) \/ (forall t, p < t < q -> v1 t < v2 t).

(** from r to t the pair has modes that change at most at finitely many times *)
Definition finitely_many_modes (v1 v2 : R -> R) r t := exists (n : nat) (p : nat -> R), p O = r /\ p n = t /\
  forall i, (i < n)%nat -> p i <= p (S i) /\ one_mode v1 v2 (p i) (p (S i)).

(** *** Finitely many, from one on each side of every time *)

(** one more interval *)
Lemma modes_append v1 v2 r t q : finitely_many_modes v1 v2 r t -> t <= q -> one_mode v1 v2 t q -> finitely_many_modes
  v1 v2 r q.
Proof.
  intros (n & p & P0 & Pn & Step) Hq M. exists (S n), (fun i => if Nat.leb i n then p i else q).
  split; [auto|]. split; [replace (Nat.leb (S n) n) with false by (symmetry; apply Nat.leb_gt; lia); auto|].
  intros i Hi. replace (Nat.leb i n) with true by (symmetry; apply Nat.leb_le; lia).
  destruct (Nat.eq_dec i n) as [->|N].
  - replace (Nat.leb (S n) n) with false by (symmetry; apply Nat.leb_gt; lia). rewrite Pn. auto.
  - replace (Nat.leb (S i) n) with true by (symmetry; apply Nat.leb_le; lia). apply Step. lia.
Qed.

(** a slip towards k *)
Lemma one_sided k (v1 v2 : R -> R) p q : k = 1 \/ k = -1 -> (forall t, p < t < q -> 0 < k * (v1 t - v2 t)) ->
  one_mode v1 v2 p q.
Proof. intros [->| ->] S; [right; left|right; right]; intros t Ht; specialize (S t Ht); lra. Qed.

(** a mode lasts on every part of an interval *)
Lemma one_mode_within v1 v2 p q p' q' : one_mode v1 v2 p q -> p <= p' -> q' <= q -> one_mode v1 v2 p' q'.
Proof. intros [M|[M|M]] Hp Hq; [left|right; left|right; right]; intros t Ht; apply M; lra. Qed.

(** a mode on each side of every time: the interval up to which there are finitely many has no end *)
Lemma modes_by_compactness v1 v2 T : 0 <= T ->
  (forall t, 0 <= t < T -> exists d, 0 < d /\ one_mode v1 v2 t (t + d)) ->
  (forall t, 0 < t <= T -> exists d, 0 < d /\ one_mode v1 v2 (t - d) t) -> finitely_many_modes v1 v2 0 T.
Proof.
  intros HT After Before. apply (onward (finitely_many_modes v1 v2 0) 0 T); [auto| | | |lra].
  - exists O, (fun _ => 0). repeat split; intros; lia.
  - intros c Hc All. destruct (Before c ltac:(lra)) as (d & Hd & M).
    destruct (just_before 0 c d) as (t & Ht & Near); [lra|auto|].
    apply (modes_append v1 v2 0 t); [apply All; lra|lra|]. apply (one_mode_within v1 v2 (c - d) c); auto; lra.
  - intros c Hc Fc. destruct (After c ltac:(lra)) as (d & Hd & M). exists d; split; auto. intros u Hu.
    apply (modes_append v1 v2 0 c); [auto|lra|]. apply (one_mode_within v1 v2 c (c + d)); auto; lra.
Qed.


(** without a zero a continuous function keeps its sign *)
Lemma no_zero_one_sign v1 v2 p q : cont (fun t => v1 t - v2 t) -> 0 <= p -> (forall t, p < t < q -> v1 t <> v2 t) ->
  one_mode v1 v2 p q.
Proof.
  intros C Hp Nz. assert (Same : forall r t, p < r <= t -> t < q -> 0 < (v1 r - v2 r) * (v1 t - v2 t)).
  { intros r t Hr Ht. apply Rnot_le_lt. intros N. destruct (cont_IVT _ r t C ltac:(lra) N) as (c & Hc & Z).
    apply (Nz c); lra. }
  destruct (Rlt_dec p q) as [Lt|N]; [|left; intros t Ht; lra]. set (m := (p + q) / 2).
  assert (Hm : p < m < q) by (unfold m; lra). assert (All : forall t, p < t < q -> 0 < (v1 m - v2 m) * (v1 t - v2 t)).
  { intros t Ht. destruct (Rle_dec m t); [apply Same; lra|]. rewrite Rmult_comm. apply Same; lra. }
  destruct (Rdichotomy _ _ (Nz m Hm)); [right; right|right; left]; intros t Ht; specialize (All t Ht); nra.
Qed.

(** apart at a time, the bodies are apart nearby *)
Lemma apart_nearby v1 v2 t : cont (fun t => v1 t - v2 t) -> 0 <= t -> v1 t <> v2 t ->
  exists d, 0 < d /\ forall r, 0 <= r -> Rabs (r - t) < d -> v1 r <> v2 r.
Proof.
  intros C Ht N. destruct (C t Ht (Rabs (v1 t - v2 t))) as (d & Hd & K); [apply Rabs_pos_lt; lra|].
  exists d. split; auto. intros r Hr Near E. specialize (K r Hr Near). cbv beta in K.
  replace (v1 r - v2 r - (v1 t - v2 t)) with (- (v1 t - v2 t)) in K by lra. rewrite Rabs_Ropp in K. lra.
Qed.

(** times of change lie between the ends *)
Lemma times_within (n : nat) (p : nat -> R) : (forall i, (i < n)%nat -> p i <= p (S i)) ->
  forall i, (i <= n)%nat -> p O <= p i <= p n.
Proof.
  intros Step. assert (Up : forall j i, (i + j <= n)%nat -> p i <= p (i + j)%nat).
  { induction j as [|j IH]; intros i Hi; [rewrite Nat.add_0_r; lra|]. specialize (IH i ltac:(lia)).
    specialize (Step (i + j)%nat ltac:(lia)). replace (i + S j)%nat with (S (i + j)) by lia. lra. }
  intros i Hi. split; [apply (Up i O); lia|]. replace n with (i + (n - i))%nat by lia. apply Up. lia.
Qed.
