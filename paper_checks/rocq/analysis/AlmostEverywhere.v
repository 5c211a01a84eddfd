(** Almost everywhere, without measure theory: null sets by covers, absolute continuity by lists of intervals.
    An absolutely continuous function with a derivative >= 0 outside a null set does not decrease. *)
From Coq Require Import List Cantor.
From InertialPair Require Import Dini.
Import ListNotations.

(** covered by open intervals of any small total length *)
Definition null (N : R -> Prop) := forall e, 0 < e -> exists a b : nat -> R, (forall n, a n <= b n) /\
  (forall t, N t -> exists n, a n < t < b n) /\ forall n, sum_f_R0 (fun i => b i - a i) n <= e.

(** intervals from lo to hi, in order and without overlap *)
Fixpoint chain (l : list (R * R)) lo hi :=
  match l with [] => lo <= hi | (p, q) :: l => lo <= p <= q /\ chain l q hi end.
(** how long they are together *)
Fixpoint lengths (l : list (R * R)) := match l with [] => 0 | (p, q) :: l => q - p + lengths l end.
(** how much f changes on them *)
Fixpoint moves (f : R -> R) (l : list (R * R)) := match l with [] => 0 | (p, q) ::
  l => Rabs (f q - f p) + moves f l end.

(** absolutely continuous on every [0, T] *)
Definition ac (f : R -> R) := forall T, 0 <= T -> forall e, 0 < e -> exists d, 0 < d /\
  forall l, chain l 0 T -> lengths l <= d -> moves f l <= e.

(** *** Chains *)
Lemma chain_le l : forall lo hi, chain l lo hi -> lo <= hi.
Proof. induction l as [|(p, q) l IH]; simpl; auto. intros lo hi (H & C). specialize (IH q hi C). lra. Qed.
Lemma chain_on l : forall lo hi hi', chain l lo hi -> hi <= hi' -> chain l lo hi'.
Proof. induction l as [|(p, q) l IH]; simpl; [intros; lra|]. intros lo hi hi' (H & C) L. split; eauto. Qed.
Lemma chain_from l lo lo' hi : chain l lo hi -> lo' <= lo -> chain l lo' hi.
Proof. destruct l as [|(p, q) l]; simpl; [intros; lra|]. intros (H & C) L. split; [lra|auto]. Qed.
Lemma chain_snoc l r c : r <= c -> forall lo, chain l lo r -> chain (l ++ [(r, c)]) lo c.
Proof. intros Hr. induction l as [|(p, q) l IH]; simpl; intros lo C; [lra|]. destruct C. split; auto. Qed.
Lemma lengths_snoc l r c : lengths (l ++ [(r, c)]) = lengths l + (c - r).
Proof. induction l as [|(p, q) l IH]; simpl; [ring|rewrite IH; ring]. Qed.
Lemma moves_snoc f l r c : moves f (l ++ [(r, c)]) = moves f l + Rabs (f c - f r).
Proof. induction l as [|(p, q) l IH]; simpl; [ring|rewrite IH; ring]. Qed.

(** *** What is absolutely continuous *)
Lemma ac_0 : ac (fun _ => 0).
Proof.
  intros T HT e He. exists 1. split; [lra|]. intros l _ _. apply Rle_trans with 0; [right|lra].
  induction l as [|(p, q) l IH]; simpl; [auto|]. rewrite IH, Rminus_diag_eq, Rabs_R0; auto; lra.
Qed.
(** what moves no more than two such functions and the time, up to a factor, which may depend on T *)
Lemma ac_by f g h : ac f -> ac g -> (forall T, 0 <= T -> exists K, 0 <= K /\ forall r t, 0 <= r <= t ->
  t <= T -> Rabs (h t - h r) <= K * (Rabs (f t - f r) + Rabs (g t - g r) + (t - r))) -> ac h.
Proof.
  intros F G B T HT e He. destruct (B T HT) as (K & HK & Q). set (c := e / (3 * (K + 1))).
  assert (Hc : 0 < c) by positive. destruct (F T HT c Hc) as (d1 & H1 & K1), (G T HT c Hc) as (d2 & H2 & K2).
  smaller c (Rmin d1 d2). intros l C L. specialize (K1 l C ltac:(lra)). specialize (K2 l C ltac:(lra)).
  assert (M : forall l lo, 0 <= lo -> chain l lo T -> moves h l <= K * (moves f l + moves g l + lengths l)).
  { clear l C L K1 K2. induction l as [|(p, q) l IH]; simpl; intros lo Hlo C; [lra|]. destruct C as (Hp & C).
    pose proof (chain_le _ _ _ C). specialize (IH q ltac:(lra) C). specialize (Q p q ltac:(lra) ltac:(lra)).
    lra. }
  specialize (M l 0 (Rle_refl 0) C). replace e with ((K + 1) * (3 * c)) by (unfold c; field; lra). nra.
Qed.
Lemma ac_plus f g : ac f -> ac g -> ac (fun t => f t + g t).
Proof.
  intros F G. apply (ac_by f g); auto. intros T _. exists 1. split; [lra|]. intros r t Hr _.
  pose proof (Rabs_triang (f t - f r) (g t - g r)) as Q.
  replace (_ + _) with (f t + g t - (f r + g r)) in Q by ring. lra.
Qed.
Lemma ac_scal c f : ac f -> ac (fun t => c * f t).
Proof.
  intros F. apply (ac_by f f); auto. intros T _. exists (Rabs c). split; [positive|]. intros r t Hr _.
  rewrite <- Rmult_minus_distr_l, Rabs_mult. pose proof (Rabs_pos (f t - f r)). scale.
Qed.
(** Lipschitz functions, the constant depending on T *)
Lemma ac_lip f : (forall T, 0 <= T -> exists K, 0 <= K /\ forall r t, 0 <= r <= t -> t <= T ->
  Rabs (f t - f r) <= K * (t - r)) -> ac f.
Proof.
  intros L. apply (ac_by _ _ f ac_0 ac_0). intros T HT. destruct (L T HT) as (K & HK & Q). exists K.
  split; auto. intros r t Hr Ht. rewrite Rminus_0_r, Rabs_R0, !Rplus_0_l. auto.
Qed.
(** of what is equal from 0 on *)
Lemma ac_ext f g : (forall t, 0 <= t -> f t = g t) -> ac f -> ac g.
Proof.
  intros E F. apply (ac_by f f); auto. intros T _. exists 1. split; [lra|]. intros r t Hr _.
  rewrite <- !E by lra. pose proof (Rabs_pos (f t - f r)). lra.
Qed.
Lemma ac_linear k : ac (fun t => k * t).
Proof.
  apply ac_lip. exists (Rabs k). split; [apply Rabs_pos|]. intros r t Hr _.
  rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (t - r)); lra.
Qed.
Lemma ac_const c : ac (fun _ => c).
Proof. apply ac_lip. exists 0. split; [lra|]. intros. rewrite Rminus_diag_eq, Rabs_R0 by auto. lra. Qed.
Lemma cont_ac f : ac f -> cont f.
Proof.
  intros F t Ht e He. destruct (F (t + 1) ltac:(lra) (e / 2) ltac:(lra)) as (d & Hd & K).
  exists (Rmin d 1); split; [positive|]. intros s Hs Hd1. pose proof (Rmin_l d 1). pose proof (Rmin_r d 1).
  apply Rabs_def2 in Hd1. destruct (Rle_dec s t).
  - specialize (K [(s, t)]). simpl in K. rewrite Rabs_minus_sym. lra.
  - specialize (K [(t, s)]). simpl in K. lra.
Qed.

(** *** The theorem *)
(** t moved into [a, b] *)
Definition clamp a b t := Rmax a (Rmin t b).
Lemma clamp_grows a b r t : r <= t -> clamp a b r <= clamp a b t.
Proof. intros. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.
(** at most by b - a *)
Lemma clamp_range a b r t : a <= b -> clamp a b t - clamp a b r <= b - a.
Proof. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.
(** inside it is t *)
Lemma clamp_inside a b t : a < t < b -> clamp a b t = t.
Proof. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.

Section Grows.
Context (f f' : R -> R) (N : R -> Prop) (p q : R) (F : ac f) (HN : null N) (Hp : 0 <= p <= q).
Hypothesis D : forall t, p <= t <= q -> ~ N t -> is_derive f t (f' t) /\ 0 <= f' t.

(** near a point with a derivative >= 0 *)
Lemma hardly_falls t e : 0 < e -> is_derive f t (f' t) -> 0 <= f' t ->
  exists d, 0 < d /\ forall r c, t - d < r <= t -> t <= c < t + d -> - e * (c - r) <= f c - f r.
Proof.
  intros He Df Pf. destruct (derive_near f t _ e Df He) as (d & Hd & K). exists d; split; auto. intros r c Hr Hc.
  pose proof (K r ltac:(apply Rabs_def1; lra)) as A. pose proof (K c ltac:(apply Rabs_def1; lra)) as B.
  rewrite (Rabs_left1 (r - t)) in A by lra. rewrite (Rabs_pos_eq (c - t)) in B by lra. apply Rabs_inv in A, B. nra.
Qed.

(** An absolutely continuous function with a derivative >= 0 almost everywhere does not decrease. *)
Theorem ac_grows : f p <= f q.
Proof.
  apply Rnot_lt_le. intros Lt. set (e := (f p - f q) / (2 * (q - p + 1))). assert (He : 0 < e) by positive.
  destruct (F q ltac:(lra) e He) as (d & Hd & K). destruct (HN d Hd) as (a & b & Hab & Cov & Sm).
  set (La := fun n t => sum_f_R0 (fun i => clamp (a i) (b i) t) n).
  assert (LaG : forall n r t, r <= t -> La n r <= La n t).
  { intros n r t Hr. apply sum_Rle. intros i _. apply clamp_grows; auto. }
  assert (LaN : forall n m r t, r <= t -> La n t - La n r <= La (n + m)%nat t - La (n + m)%nat r).
  { intros n m r t Hr. induction m as [|m IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r. unfold La in *.
    simpl. pose proof (clamp_grows (a (S (n + m))) (b (S (n + m))) r t Hr). lra. }
  assert (LaI : forall n r t, a n < r -> r <= t -> t < b n -> t - r <= La n t - La n r).
  { intros n r t Hr Ht Hb. destruct n as [|n]; unfold La; simpl.
    - rewrite !clamp_inside by lra. lra.
    - rewrite !(clamp_inside (a (S n)) (b (S n))) by lra.
      pose proof (sum_Rle (fun i => clamp (a i) (b i) r) (fun i => clamp (a i) (b i) t) n
        (fun i _ => clamp_grows (a i) (b i) r t Ht)). lra. }
  assert (LaS : forall n, La n q - La n p <= d).
  { intros n. apply Rle_trans with (2 := Sm n). unfold La. rewrite <- minus_sum. apply sum_Rle. intros i _.
    apply clamp_range; auto. }
  set (P := fun r => exists l n, chain l p r /\ lengths l <= La n r - La n p /\ - e * (r - p) - moves f l <= f r - f p).
  assert (Step : forall r c, p <= r <= c -> (- e * (c - r) <= f c - f r \/ exists n, a n < r /\ c < b n) -> P r -> P c).
  { intros r c Hr [Q|(n & Hn & Hn')] (l & m & Ch & Ln & Mv).
    - exists l, m. split; [apply chain_on with r; auto; lra|]. pose proof (LaG m r c). lra.
    - exists (l ++ [(r, c)]), (n + m)%nat. split; [apply chain_snoc; auto; lra|]. rewrite lengths_snoc, moves_snoc.
      pose proof (LaN n m r c ltac:(lra)). pose proof (LaN m n p r ltac:(lra)) as J. rewrite (Nat.add_comm m n) in J.
      pose proof (LaI n r c Hn ltac:(lra) Hn'). pose proof (Rle_abs (- (f c - f r))) as A. rewrite Rabs_Ropp in A. nra.
  }
  assert (Near : forall c, p <= c <= q -> exists h, 0 < h /\ forall r t, c - h < r <= c -> c <= t < c + h ->
    - e * (t - r) <= f t - f r \/ exists n, a n < r /\ t < b n).
  { intros c Hc. destruct (Classical_Prop.classic (N c)) as [Nc|Nc].
    - destruct (Cov c Nc) as (n & Hn). exists (Rmin (c - a n) (b n - c)). split; [positive|]. right. exists n.
      pose proof (Rmin_l (c - a n) (b n - c)). pose proof (Rmin_r (c - a n) (b n - c)). lra.
    - destruct (D c Hc Nc) as (Df & Pf). destruct (hardly_falls c e He Df Pf) as (h & Hh & Q). exists h; split; auto.
      }
  assert (Pq : P q).
  { apply (onward P p q); [lra| | | |lra].
    - exists [], O. simpl. repeat split; lra.
    - intros c Hc All. destruct (Near c ltac:(lra)) as (h & Hh & Q).
      destruct (just_before p c h) as (r & Hr & Hr'); [lra|auto|]. apply (Step r c); [lra| |apply All; lra].
      apply Q; lra.
    - intros c Hc Pc. destruct (Near c ltac:(lra)) as (h & Hh & Q). exists h; split; auto. intros r Hr.
      apply (Step c r); auto; [lra|]. apply Q; lra. }
  destruct Pq as (l & n & Ch & Ln & Mv). pose proof (LaS n).
  specialize (K l (chain_from l p 0 q Ch ltac:(lra)) ltac:(lra)).
  assert (e * (2 * (q - p + 1)) = f p - f q) by (unfold e; field; lra). nra.
Qed.
End Grows.

(** bounds of the derivative almost everywhere are bounds of the slope *)
Corollary ac_slope f N p q lo hi : ac f -> null N -> 0 <= p <= q ->
  (forall t, p <= t <= q -> ~ N t -> exists l, is_derive f t l /\ lo <= l <= hi) ->
  lo * (q - p) <= f q - f p <= hi * (q - p).
Proof.
  intros F HN Hp D.
  assert (G : forall k m, (forall t, p <= t <= q -> ~ N t -> exists l, is_derive f t l /\ 0 <= k * l + m) ->
    k * f p + m * p <= k * f q + m * q).
  { intros k m E. apply (ac_grows (fun t => k * f t + m * t) (fun t => k * Derive f t + m) N p q); auto.
    - apply ac_plus; [apply ac_scal; auto|apply ac_linear].
    - intros t Ht Nt. destruct (E t Ht Nt) as (l & Dl & Hl). rewrite (is_derive_unique _ _ _ Dl). split; auto.
      apply (is_derive_plus (fun t => k * f t) (fun t => m * t)).
      + apply (is_derive_scal f t k l Dl).
      + auto_derive; auto; ring. }
  split.
  - cut (1 * f p + - lo * p <= 1 * f q + - lo * q); [lra|]. apply G. intros t Ht Nt. destruct (D t Ht Nt) as (l & Dl
    & Hl). exists l. split; auto; lra.
  - cut (-1 * f p + hi * p <= -1 * f q + hi * q); [lra|]. apply G. intros t Ht Nt.
    destruct (D t Ht Nt) as (l & Dl & Hl). exists l. split; auto; lra.
Qed.

(** a derivative that is continuous almost everywhere is a right derivative everywhere *)
Corollary ac_rderiv f g t : ac f -> cont g -> 0 <= t ->
  (forall T, 0 <= T -> exists N, null N /\ forall u, 0 <= u <= T -> ~ N u -> is_derive f u (g u)) -> rderiv f t (g t).
Proof.
  intros F G Ht D e He. destruct (D (t + 1) ltac:(lra)) as (N & HN & Dn). destruct (G t Ht e He) as (d & Hd & K).
  exists (Rmin d 1); split; [positive|]. intros h Hh. pose proof (Rmin_l d 1). pose proof (Rmin_r d 1).
  destruct (ac_slope f N t (t + h) (g t - e) (g t + e)) as (A & B); auto; [lra| |].
  - intros u Hu Nu. exists (g u). split; [apply Dn; auto; lra|]. specialize (K u ltac:(lra)).
    assert (Q : Rabs (u - t) < d) by (rewrite Rabs_pos_eq; lra). specialize (K Q). apply Rabs_def2 in K. lra.
  - apply Rabs_le. lra.
Qed.

(** the times of a sequence *)
Lemma null_points (p : nat -> R) : null (fun t => exists n, t = p n).
Proof.
  intros e He. set (h := fun n : nat => e / 2 * (1 / 2) ^ S n).
  assert (Hh : forall n, 0 < h n) by (intros n; apply Rmult_lt_0_compat; [lra|positive]).
  exists (fun n => p n - h n), (fun n => p n + h n). split; [|split].
  - intros n. specialize (Hh n). lra.
  - intros t (n & ->). exists n. specialize (Hh n). lra.
  - intros n. apply Rle_trans with (e * (1 - (1 / 2) ^ S n)).
    + induction n as [|n IH]; [unfold h; simpl; lra|]. rewrite tech5. unfold h at 3 4. simpl pow in *. lra.
    + assert (0 < (1 / 2) ^ S n) by positive. nra.
Qed.

(** *** Null sets *)
(** of two one *)
Lemma null_or N P : null N -> null P -> null (fun t => N t \/ P t).
Proof.
  intros HN HP e He. destruct (HN (e / 2) ltac:(lra)) as (a & b & Ab & Ac & As).
  destruct (HP (e / 2) ltac:(lra)) as (c & d & Cb & Cc & Cs).
  set (mix := fun (f g : nat -> R) n => if Nat.even n then f (Nat.div2 n) else g (Nat.div2 n)).
  assert (Even : forall f g n, mix f g (2 * n)%nat = f n).
  { intros f g n. unfold mix. rewrite Nat.even_mul, Nat.div2_double. auto. }
  assert (Odd : forall f g n, mix f g (S (2 * n)) = g n).
  { intros f g n. unfold mix. rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul, Nat.div2_succ_double. auto. }
  assert (Le : forall i, mix a c i <= mix b d i) by (intros i; unfold mix; destruct Nat.even; auto).
  exists (mix a c), (mix b d). split; [auto|split].
  - intros t [Nt|Pt].
    + destruct (Ac t Nt) as (n & Hn). exists (2 * n)%nat. rewrite !Even. auto.
    + destruct (Cc t Pt) as (n & Hn). exists (S (2 * n)). rewrite !Odd. auto.
  - intros n. set (g := fun i => mix b d i - mix a c i).
    assert (Twice : forall m, sum_f_R0 g (S (2 * m)) = sum_f_R0 (fun i => b i - a i) m + sum_f_R0 (fun i => d i - c i)
      m).
    { induction m as [|m IH].
      - auto.
      - replace (S (2 * S m)) with (S (S (S (2 * m)))) by lia. rewrite (tech5 g (S (S (2 * m)))),
        (tech5 g (S (2 * m))), IH. rewrite !tech5. unfold g.
        replace (S (S (2 * m))) with (2 * S m)%nat by lia. rewrite !Even, !Odd. ring. }
    assert (Grow : forall m k, sum_f_R0 g m <= sum_f_R0 g (m + k)).
    { induction k as [|k IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r, tech5. specialize (Le (S (m + k))).
      unfold g at 3. lra. }
    pose proof (Grow n (S n)) as G. replace (n + S n)%nat with (S (2 * n)) in G by lia. rewrite Twice in G.
    specialize (As n). specialize (Cs n). lra.
Qed.

(** times before each of which there are none for a while *)
Lemma null_first (E : R -> Prop) :
  (forall t, E t -> 0 <= t /\ exists d, 0 < d /\ forall r, t - d < r < t -> ~ E r) -> null E.
Proof.
  intros Iso.
  (* every rational number is given a point: the first time from it on *)
  set (low := fun n => INR (snd (of_nat n)) / (INR (fst (of_nat n)) + 1)).
  set (p := fun n => real (Glb_Rbar (fun r => E r /\ low n <= r))). assert (In : forall t, E t -> exists n, t = p n).
  { intros t Et. destruct (Iso t Et) as (Ht & d & Hd & No). destruct (nfloor_ex (1 / d)) as (i & Hi); [positive|].
    pose proof (pos_INR i). destruct (nfloor_ex (t * (INR i + 1))) as (k & Hk); [positive|].
    assert (Wd : 1 / d * d = 1) by (field; lra). assert (Ln : low (to_nat (i, k)) * (INR i + 1) = INR k).
    { unfold low. rewrite cancel_of_to. simpl. field. lra. }
    exists (to_nat (i, k)). unfold p. rewrite (is_glb_Rbar_unique _ t); auto. split.
    - intros r (Er & Hr). apply Rnot_lt_le. intros Lt. apply (No r); [split; nra|auto].
    - intros b Hb. apply Hb. split; [auto|nra]. }
  intros e He. destruct (null_points p e He) as (a & b & Ab & Ac & As). exists a, b. auto.
Qed.

(** *** Almost all times of [0, oo) *)
Definition almost (P : R -> Prop) := forall T, 0 <= T -> exists N, null N /\ forall t, 0 <= t <= T -> ~ N t -> P t.

Lemma almost_and P Q : almost P -> almost Q -> almost (fun t => P t /\ Q t).
Proof.
  intros A B T HT. destruct (A T HT) as (N & HN & F), (B T HT) as (N' & HN' & G). exists (fun t => N t \/ N' t).
  split; [apply null_or; auto|]. split; [apply F|apply G]; auto.
Qed.
Lemma almost_impl (P Q : R -> Prop) : (forall t, 0 <= t -> P t -> Q t) -> almost P -> almost Q.
Proof. intros I A T HT. destruct (A T HT) as (N & HN & F). exists N. split; auto. intros t Ht No. apply I; [lra|auto]. Qed.
(** almost all times of a set have others of it just before *)
Lemma almost_crowded (E : R -> Prop) : almost (fun t => E t -> forall d, 0 < d -> exists r, t - d < r < t /\ E r).
Proof.
  intros T HT. exists (fun t => 0 <= t /\ E t /\ exists d, 0 < d /\ forall r, t - d < r < t -> ~ E r). split.
  - apply null_first. intros t (Ht & Et & d & Hd & No). split; [auto|]. exists d. split; [auto|].
    intros r Hr (_ & Er & _). exact (No r Hr Er).
  - intros t Ht No Et d Hd. apply Classical_Prop.NNPP. intros F. apply No. repeat split; [lra|auto|]. exists d.
    split; [auto|]. eauto.
Qed.
(** almost all zeros are no simple ones *)
Lemma almost_no_simple_zero f : almost (fun t => f t = 0 -> forall l, is_derive f t l -> l = 0).
Proof.
  apply (almost_impl _ _) with (2 := almost_crowded (fun t => f t = 0)). intros t _ Cr Z l D.
  destruct (Req_dec l 0) as [|Nl]; auto. apply Rabs_pos_lt in Nl.
  destruct (derive_near f t l (Rabs l / 2) D ltac:(lra)) as (d & Hd & K). destruct (Cr Z d Hd) as (r & Hr & Zr).
  specialize (K r ltac:(apply Rabs_def1; lra)). pose proof (Rabs_pos_lt (r - t) ltac:(lra)).
  replace (f r - f t - l * (r - t)) with (- (l * (r - t))) in K by lra. rewrite Rabs_Ropp, Rabs_mult in K. nra.
Qed.
(** a single time is none of them *)
Lemma almost_not c : almost (fun t => t <> c).
Proof.
  apply (almost_impl (fun t => t = c -> forall d, 0 < d -> exists r, t - d < r < t /\ r = c));
    [|apply (almost_crowded (fun t => t = c))].
  intros t _ Cr Z. destruct (Cr Z 1) as (r & Hr & ->); lra.
Qed.
Lemma almost_later : almost (fun t => 0 < t).
Proof. apply (almost_impl (fun t => t <> 0)); [intros; lra|apply almost_not]. Qed.
(** until each time there are some at which it holds *)
Lemma almost_some P T : 0 < T -> almost P -> exists t, 0 <= t <= T /\ P t.
Proof.
  intros HT A. apply Classical_Prop.NNPP. intros No. destruct (A T ltac:(lra)) as (N & HN & F).
  pose proof (ac_grows (fun t => -1 * t) (fun _ => 0) N 0 T (ac_linear (-1)) HN ltac:(lra)) as G.
  cut (-1 * 0 <= -1 * T); [lra|]. apply G. intros t Ht Nt. exfalso. eauto.
Qed.
