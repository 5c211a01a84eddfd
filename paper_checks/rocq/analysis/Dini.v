(** Right increments: o(h), O(h), right derivatives; the Dini monotonicity lemma. *)
From Coq Require Export Reals Lra Lia Psatz.
From Coquelicot Require Export Coquelicot.
Global Open Scope R_scope.

Lemma Rabs_inv x a : Rabs x <= a -> - a <= x <= a.
Proof. intros H. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra. Qed.

(** signs of what is made of positive numbers, part by part *)
Ltac positive := first [assumption | lra | (match goal with
  | |- 0 < _ * _ => apply Rmult_lt_0_compat | |- 0 < _ / _ => apply Rdiv_lt_0_compat
  | |- 0 < _ + _ => apply Rplus_lt_0_compat | |- 0 < / _ => apply Rinv_0_lt_compat | |- 0 < _ ^ _ => apply pow_lt
  | |- 0 < sqrt _ => apply sqrt_lt_R0 | |- 0 < Rmin _ _ => apply Rmin_glb_lt
  | |- 0 <= _ ^ 2 => apply pow2_ge_0 | |- 0 <= sqrt _ => apply sqrt_pos | |- 0 <= Rabs _ => apply Rabs_pos
  | |- 0 <= _ * _ => apply Rmult_le_pos | |- 0 <= _ / _ => apply Rdiv_le_0_compat
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat | |- 0 <= / _ => apply Rlt_le
  | |- 0 < ?x => is_var x; unfold x | |- 0 <= ?x => is_var x; unfold x end; positive)].
(** the smallest of some positive numbers serves where each of them does *)
Ltac min_bounds m := lazymatch m with
  | Rmin ?a ?b => pose proof (Rmin_l a b); pose proof (Rmin_r a b); min_bounds a; min_bounds b | _ => idtac end.
Ltac smaller a b := exists (Rmin a b); min_bounds (Rmin a b); split; [positive|].
(** a product is compared by one of its factors *)
Ltac scale := first [apply Rmult_le_compat_l | apply Rmult_le_compat_r | apply Rmult_lt_compat_l
  | apply Rmult_lt_compat_r]; first [positive | auto].
(** and a quotient by c without its denominator *)
Ltac undivide c := first [refine (proj2 (Rle_div_l _ _ c _) _) | refine (proj1 (Rle_div_r _ _ c _) _)
  | refine (proj2 (Rlt_div_l _ _ c _) _) | refine (proj1 (Rlt_div_r _ _ c _) _)]; [apply Rlt_gt; positive|].

(** from both signs, and from squares, to absolute values *)
Lemma abs_by y c : (forall k, k = 1 \/ k = -1 -> k * y <= c) -> Rabs y <= c.
Proof. intros Q. apply Rabs_le. pose proof (Q 1 ltac:(auto)). pose proof (Q (-1) ltac:(auto)). lra. Qed.
Lemma sq_le_abs y z : 0 <= z -> y ^ 2 <= z ^ 2 -> - z <= y <= z.
Proof. intros; split; nra. Qed.

(** f (h) = o(h) for h -> 0+ *)
Definition little (f : R -> R) :=
  forall eps, 0 < eps -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs (f h) <= eps * h.
(** f (h) = O(h) for h -> 0+ *)
Definition big (f : R -> R) :=
  exists C d, 0 < C /\ 0 < d /\ forall h, 0 < h < d -> Rabs (f h) <= C * h.
(** l is the right derivative of f at t *)
Definition rderiv (f : R -> R) (t l : R) := little (fun h => f (t + h) - f t - l * h).
(** the upper right derivative of f at t is at most l *)
Definition dini_le (f : R -> R) (t l : R) :=
  forall eps, 0 < eps -> exists d, 0 < d /\ forall h, 0 < h < d -> f (t + h) - f t <= (l + eps) * h.
(** continuity on [0, +oo) *)
Definition cont (f : R -> R) :=
  forall t, 0 <= t -> forall eps, 0 < eps -> exists d, 0 < d /\
  forall s, 0 <= s -> Rabs (s - t) < d -> Rabs (f s - f t) < eps.

(** what holds for all small h > 0, and what follows from it *)
Lemma soon {P Q : R -> Prop} : (exists d, 0 < d /\ forall h, 0 < h < d -> P h) ->
  (forall h, 0 < h -> P h -> Q h) -> exists d, 0 < d /\ forall h, 0 < h < d -> Q h.
Proof. intros (d & Hd & K) F. exists d. split; auto. intros h Hh. apply F; [lra|auto]. Qed.
Lemma soon_both {P P' Q : R -> Prop} : (exists d, 0 < d /\ forall h, 0 < h < d -> P h) ->
  (exists d, 0 < d /\ forall h, 0 < h < d -> P' h) -> (forall h, 0 < h -> P h -> P' h -> Q h) ->
  exists d, 0 < d /\ forall h, 0 < h < d -> Q h.
Proof.
  intros (d & Hd & K) (d' & Hd' & K') F. smaller d d'. intros h Hh. apply F; [lra|apply K|apply K']; lra.
Qed.

Lemma little_le f g : (forall h, 0 < h -> Rabs (g h) <= Rabs (f h)) -> little f -> little g.
Proof. intros E H e He. apply (soon (H e He)). intros h Hh. apply Rle_trans. auto. Qed.
Lemma little_ext f g : (forall h, f h = g h) -> little f -> little g.
Proof. intros E. apply little_le. intros. rewrite E. lra. Qed.

Lemma little_abs f : little f -> little (fun h => Rabs (f h)).
Proof. apply little_le. intros. rewrite Rabs_Rabsolu. lra. Qed.
Lemma little_0 : little (fun _ => 0).
Proof. intros e He; exists 1; split; [lra|]. intros h Hh; rewrite Rabs_R0; nra. Qed.

Lemma little_plus f g : little f -> little g -> little (fun h => f h + g h).
Proof.
  intros F G e He. apply (soon_both (F (e / 2) ltac:(lra)) (G (e / 2) ltac:(lra))). intros h _ A B.
  pose proof (Rabs_triang (f h) (g h)). lra.
Qed.

Lemma little_scal c f : little f -> little (fun h => c * f h).
Proof.
  intros F e He. pose proof (Rabs_pos c). apply (soon (F (e / (Rabs c + 1)) ltac:(positive))). intros h Hh K.
  rewrite Rabs_mult. pose proof (Rabs_pos (f h)).
  replace e with (e / (Rabs c + 1) * (Rabs c + 1)) by (field; lra). nra.
Qed.

Lemma little_minus f g : little f -> little g -> little (fun h => f h - g h).
Proof. intros F G. eapply little_ext; [|exact (little_plus _ _ F (little_scal (-1) _ G))]. intros; simpl; ring. Qed.

Lemma little_big f : little f -> big f.
Proof. intros F. destruct (F 1) as (d & ? & K); [lra|]. exists 1, d; repeat split; try lra; auto. Qed.

Lemma big_id : big (fun h => h).
Proof. exists 1, 1; repeat split; try lra. intros; rewrite Rabs_pos_eq; lra. Qed.

Lemma big_le f g : (forall h, 0 < h -> Rabs (g h) <= Rabs (f h)) -> big f -> big g.
Proof.
  intros E (C & d & ? & ? & K). exists C, d; repeat split; auto. intros; eapply Rle_trans; [apply E; lra|auto].
Qed.
Lemma big_ext f g : (forall h, f h = g h) -> big f -> big g.
Proof. intros E. apply big_le. intros. rewrite E. lra. Qed.

Lemma big_plus f g : big f -> big g -> big (fun h => f h + g h).
Proof.
  intros (C1 & d1 & ? & ? & K1) (C2 & d2 & ? & ? & K2). exists (C1 + C2). smaller d1 d2. split; [positive|].
  intros h Hh. specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). pose proof (Rabs_triang (f h) (g h)). lra.
Qed.

Lemma big_scal c f : big f -> big (fun h => c * f h).
Proof.
  intros (C & d & ? & ? & K). pose proof (Rabs_pos c). exists ((Rabs c + 1) * C), d; repeat split; auto; [nra|].
  intros h Hh. rewrite Rabs_mult. specialize (K h Hh). nra.
Qed.

Lemma big_minus f g : big f -> big g -> big (fun h => f h - g h).
Proof. intros F G. eapply big_ext; [|exact (big_plus _ _ F (big_scal (-1) _ G))]. intros; simpl; ring. Qed.

Lemma big_mult f g : big f -> big g -> little (fun h => f h * g h).
Proof.
  intros (C1 & d1 & ? & ? & K1) (C2 & d2 & ? & ? & K2) e He. assert (0 < C1 * C2) by positive.
  smaller (e / (C1 * C2)) (Rmin d1 d2). intros h Hh. specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)).
  assert (Q : h <= e / (C1 * C2)) by lra. apply Rle_div_r in Q; [|lra]. rewrite Rabs_mult.
  apply Rle_trans with (C1 * h * (C2 * h)); [apply Rmult_le_compat; auto using Rabs_pos|nra].
Qed.

Lemma rderiv_big f t l : rderiv f t l -> big (fun h => f (t + h) - f t).
Proof.
  intros H. apply big_ext with (fun h => (f (t+h) - f t - l*h) + l * h); [intros; ring|].
  apply big_plus; [apply little_big; auto | apply big_scal, big_id].
Qed.

(** right derivatives of functions that are equal from some time on *)
Lemma rderiv_ext f g t l : (forall u, t <= u -> f u = g u) -> rderiv f t l -> rderiv g t l.
Proof.
  intros E H e He. apply (soon (H e He)). intros h Hh. rewrite <- !E by lra. auto.
Qed.

Lemma rderiv_near f g t l d : 0 < d -> (forall u, t <= u < t + d -> f u = g u) -> rderiv f t l -> rderiv g t l.
Proof.
  intros Hd E F e He. destruct (F e He) as (d' & Hd' & K). smaller d d'. intros h Hh. rewrite <- !E by lra.
  apply K; lra.
Qed.

Lemma rderiv_plus f g t l k : rderiv f t l -> rderiv g t k -> rderiv (fun u => f u + g u) t (l + k).
Proof. intros F G. eapply little_ext; [|exact (little_plus _ _ F G)]. intros; simpl; ring. Qed.

Lemma rderiv_scal c f t l : rderiv f t l -> rderiv (fun u => c * f u) t (c * l).
Proof. intros F. eapply little_ext; [|exact (little_scal c _ F)]. intros; simpl; ring. Qed.

Lemma rderiv_opp f t l : rderiv f t l -> rderiv (fun u => - f u) t (- l).
Proof. intros F. eapply little_ext; [|exact (little_scal (-1) _ F)]. intros; simpl; ring. Qed.

Lemma rderiv_minus f g t l k : rderiv f t l -> rderiv g t k -> rderiv (fun u => f u - g u) t (l - k).
Proof. intros F G. eapply little_ext; [|exact (little_minus _ _ F G)]. intros; simpl; ring. Qed.

Lemma rderiv_const c t : rderiv (fun _ => c) t 0.
Proof. eapply little_ext; [|exact little_0]. intros; simpl; ring. Qed.

Lemma rderiv_mult f g t l k : rderiv f t l -> rderiv g t k -> rderiv (fun u => f u * g u) t (l * g t + f t * k).
Proof.
  intros F G.
  eapply little_ext; [|exact (little_plus _ _ (little_plus _ _ (little_scal (g t) _ F) (little_scal (f t) _ G))
    (big_mult _ _ (rderiv_big _ _ _ F) (rderiv_big _ _ _ G)))].
  intros; simpl; ring.
Qed.

(** of a function that runs later *)
Lemma rderiv_later f t l T : rderiv f (t - T) l -> rderiv (fun u => f (u - T)) t l.
Proof. intros F. eapply little_ext; [|exact F]. intros h; simpl. replace (t + h - T) with (t - T + h) by ring. auto.
  Qed.

(** of a function that runs earlier *)
Lemma rderiv_earlier f t l T : rderiv f (T + t) l -> rderiv (fun u => f (T + u)) t l.
Proof. intros F. eapply little_ext; [|exact F]. intros h; simpl. rewrite Rplus_assoc. auto. Qed.

Lemma rderiv_eq f t l k : l = k -> rderiv f t l -> rderiv f t k.
Proof. intros ->; auto. Qed.

Lemma rderiv_dini f t l k : l <= k -> rderiv f t l -> dini_le f t k.
Proof.
  intros Hl H e He. apply (soon (H e He)). intros h Hh K. apply Rabs_inv in K. nra.
Qed.
Lemma dini_weaken f t l k : l <= k -> dini_le f t l -> dini_le f t k.
Proof. intros Hl D e He. apply (soon (D e He)). intros h Hh K. nra. Qed.
Lemma dini_scal c f t k : 0 < c -> dini_le f t k -> dini_le (fun u => c * f u) t (c * k).
Proof.
  intros Hc D e He. apply (soon (D (e / c) ltac:(positive))). intros h Hh K.
  replace e with (c * (e / c)) by (field; lra). nra.
Qed.
Lemma dini_plus f g t k l : dini_le f t k -> rderiv g t l -> dini_le (fun u => f u + g u) t (k + l).
Proof.
  intros F G e He. apply (soon_both (F (e / 2) ltac:(lra)) (G (e / 2) ltac:(lra))). intros h _ K K'.
  apply Rabs_inv in K'. lra.
Qed.
(** an increment k h - p h + o(h), where p takes little or nothing back *)
Lemma dini_increment f t k p : little (fun h => f (t + h) - f t - k * h + p h) ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> - e * h <= p h) -> dini_le f t k.
Proof.
  intros F P e He. apply (soon_both (F (e / 2) ltac:(lra)) (P (e / 2) ltac:(lra))). intros h _ A B.
  apply Rabs_inv in A. lra.
Qed.

Lemma cont_ext f g : (forall u, 0 <= u -> f u = g u) -> cont f -> cont g.
Proof.
  intros E F t Ht e He. destruct (F t Ht e He) as (d & ? & K). exists d; split; auto. intros s Hs Hd.
  rewrite <- !E by auto. auto.
Qed.

(** it is that of Coquelicot, of the function made constant before 0 *)
Lemma continuous_near (f : R -> R) t e : continuous f t -> 0 < e ->
  exists d, 0 < d /\ forall u, Rabs (u - t) < d -> Rabs (f u - f t) < e.
Proof.
  intros C He. destruct (proj1 (filterlim_locally _ _) C (mkposreal e He)) as (d & K). exists d.
  split; [apply cond_pos|exact K].
Qed.
Lemma cont_of_continuous f : (forall t, 0 <= t -> continuous f t) -> cont f.
Proof. intros C t Ht e He. destruct (continuous_near f t e (C t Ht) He) as (d & Hd & K). eauto. Qed.
Lemma cont_iff f : cont f <-> forall t, continuous (fun u => f (Rmax 0 u)) t.
Proof.
  split; intros C.
  - intros t. apply filterlim_locally. intros (e & He). destruct (C (Rmax 0 t) (Rmax_l _ _) e He) as (d & Hd & K).
    exists (mkposreal d Hd). intros u Hu. apply K; [apply Rmax_l|]. eapply Rle_lt_trans; [|exact Hu]. unfold Rmax.
    repeat destruct Rle_dec; apply Rabs_le; unfold abs, minus, plus, opp; simpl; split_Rabs; lra.
  - apply cont_ext with (fun u => f (Rmax 0 u)); [intros; rewrite Rmax_right; auto|apply cont_of_continuous; auto].
Qed.
Lemma cont_abs f : cont f -> cont (fun u => Rabs (f u)).
Proof. rewrite !cont_iff. auto using continuous_Rabs_comp. Qed.

Lemma cont_const c : cont (fun _ => c).
Proof. apply cont_iff. intros t. apply continuous_const. Qed.

Lemma cont_plus f g : cont f -> cont g -> cont (fun u => f u + g u).
Proof. rewrite !cont_iff. intros F G t. exact (continuous_plus _ _ _ (F t) (G t)). Qed.

Lemma cont_mult f g : cont f -> cont g -> cont (fun u => f u * g u).
Proof. rewrite !cont_iff. intros F G t. exact (continuous_mult _ _ _ (F t) (G t)). Qed.

Lemma cont_scal c f : cont f -> cont (fun u => c * f u).
Proof. apply cont_mult; auto. apply cont_const. Qed.

Lemma cont_minus f g : cont f -> cont g -> cont (fun u => f u - g u).
Proof. rewrite !cont_iff. intros F G t. exact (continuous_minus _ _ _ (F t) (G t)). Qed.

Lemma cont_opp f : cont f -> cont (fun t => - f t).
Proof. rewrite !cont_iff. intros F t. exact (continuous_opp _ _ (F t)). Qed.

(** of a function shifted in time *)
Lemma cont_shift f s : 0 <= s -> cont f -> cont (fun u => f (s + u)).
Proof.
  intros Hs F t Ht e He. destruct (F (s + t)) with (eps := e) as (d & ? & K); try lra.
  exists d; split; auto. intros r Hr Hd. apply K; [lra|]. replace (s + r - (s + t)) with (r - t) by ring; auto.
Qed.

Lemma lip_cont f K : 0 <= K -> (forall r t, 0 <= r <= t -> Rabs (f t - f r) <= K * (t - r)) -> cont f.
Proof.
  intros HK L t Ht e He. exists (e / (K + 1)); split; [positive|]. intros s Hs Hd. apply Rlt_div_r in Hd; [|lra].
  destruct (Rle_dec s t); [rewrite Rabs_left1 in Hd by lra; rewrite Rabs_minus_sym; pose proof (L s t ltac:(lra))|
    rewrite Rabs_pos_eq in Hd by lra; pose proof (L t s ltac:(lra))]; nra.
Qed.

(** ** What holds at a time, of what came before, and for a while after each time at which it holds, holds for ever *)
Lemma onward (P : R -> Prop) a c : a <= c -> P a ->
  (forall t, a < t <= c -> (forall u, a <= u < t -> P u) -> P t) ->
  (forall t, a <= t < c -> P t -> exists d, 0 < d /\ forall u, t < u < t + d -> P u) -> forall t, a <= t <= c -> P t.
Proof.
  intros Hac Pa Lim Step. set (A := fun r => a <= r <= c /\ forall u, a <= u <= r -> P u).
  assert (Aa : A a) by (split; [lra|intros u Hu; replace u with a by lra; auto]).
  destruct (completeness A) as (m & Ub & Lub); [exists c; intros r (Hr & _); lra|exists a; auto|].
  assert (Hm : a <= m <= c) by (split; [auto|apply Lub; intros r (Hr & _); lra]).
  assert (Below : forall u, a <= u < m -> P u).
  { intros u Hu. apply Classical_Prop.NNPP. intros N. assert (m <= u); [|lra]. apply Lub. intros r (Hr & Q).
    apply Rnot_lt_le. intros L. apply N, Q. lra. }
  assert (Upto : forall u, a <= u <= m -> P u).
  { intros u Hu. destruct (Req_dec u m) as [->|]; [|apply Below; lra].
    destruct (Req_dec a m) as [<-|]; [auto|apply Lim; [lra|auto]]. }
  destruct (Req_dec m c) as [<-|]; [exact Upto|]. destruct (Step m) as (d & Hd & Q); [lra|apply Upto; lra|].
  set (r := Rmin (m + d / 2) c). assert (r <= m + d / 2) by apply Rmin_l. assert (r <= c) by apply Rmin_r.
  assert (m < r) by (apply Rmin_glb_lt; lra). assert (r <= m); [|lra]. apply Ub. split; [lra|]. intros u Hu.
  destruct (Rle_dec u m); [apply Upto|apply Q]; lra.
Qed.

(** there are times just before a time *)
Lemma just_before a t d : a < t -> 0 < d -> exists u, a <= u < t /\ t - d < u.
Proof.
  intros Ha Hd. exists (Rmax a (t - d / 2)). pose proof (Rmax_l a (t - d / 2)). pose proof (Rmax_r a (t - d / 2)).
  split; [split; [auto|apply Rmax_lub_lt; lra]|lra].
Qed.

(** a bound before a time is one at that time *)
Lemma cont_le f k a t : cont f -> 0 <= a < t -> (forall u, a <= u < t -> f u <= k) -> f t <= k.
Proof.
  intros C Ha B. apply Rnot_lt_le. intros N. destruct (C t ltac:(lra) (f t - k)) as (d & Hd & K); [lra|].
  destruct (just_before a t d) as (u & Hu & Near); [lra|auto|]. specialize (K u ltac:(lra) ltac:(apply Rabs_def1; lra)).
  apply Rabs_def2 in K. specialize (B u ltac:(lra)). lra.
Qed.

(** the first zero of a function that changes its sign *)
Lemma first_zero w t q : cont w -> 0 <= t <= q -> w t * w q <= 0 -> w t <> 0 ->
  exists c, t < c <= q /\ w c = 0 /\ forall u, t <= u < c -> 0 < w t * w u.
Proof.
  intros C Hq N Nt. apply Classical_Prop.NNPP. intros No. apply (Rle_not_lt _ _ N).
  assert (Cg : forall k, cont (fun u => k * w u)) by auto using cont_mult, cont_const.
  apply (onward (fun u => 0 < w t * w u) t q); [lra|nra| | |lra].
  - intros c Hc All. apply Rnot_le_lt. intros Nc. apply No. exists c. split; [lra|]. split; auto.
    assert (- w t * w c <= 0) by (apply (cont_le _ 0 t c (Cg (- w t))); [lra|intros u Hu; specialize (All u Hu); lra]).
    nra.
  - intros c Hc Pc. destruct (Cg (w t) c ltac:(lra) _ Pc) as (d & Hd & K). exists d; split; auto. intros u Hu.
    specialize (K u ltac:(lra) ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in K. lra.
Qed.

(** a zero between two signs *)
Lemma cont_IVT f p q : cont f -> 0 <= p <= q -> f p * f q <= 0 -> exists c, p <= c <= q /\ f c = 0.
Proof.
  intros C Hp Hs. destruct (Req_dec (f p) 0); [exists p; split; [lra|auto]|].
  destruct (first_zero f p q C Hp Hs) as (c & Hc & Z & _); auto. exists c. split; [lra|auto].
Qed.

(** ** Dini: what does not rise where it is at a level or above does not pass it *)
Lemma barrier_until f k s t : cont f -> 0 <= s <= t -> f s <= k -> (forall u, s <= u < t -> k <= f u -> dini_le f u 0)
  ->
  f t <= k.
Proof.
  intros C Hst Fs D. apply le_epsilon. intros q Hq. set (e := q / (t - s + 1)). assert (He : 0 < e) by positive.
  assert (Cl : cont (fun u => f u - e * (u - s))).
  { apply cont_minus; auto. apply (lip_cont _ e); [lra|]. intros r u Hr. rewrite Rabs_pos_eq; nra. }
  apply Rle_trans with (k + e * (t - s)).
  2: { replace q with (e * (t - s + 1)) by (unfold e; field; lra). nra. }
  apply (onward (fun u => f u <= k + e * (u - s)) s t); try lra.
  - intros c Hc Below. assert (f c - e * (c - s) <= k); [|lra]. apply (cont_le _ k s c Cl); [lra|]. intros u Hu.
    specialize (Below u Hu). lra.
  - intros c Hc Fc. destruct (Rlt_dec (f c) k) as [L|L].
    + destruct (C c ltac:(lra) (k - f c)) as (d & Hd & K); [lra|]. exists d; split; auto. intros u Hu.
      specialize (K u ltac:(lra) ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in K. nra.
    + destruct (D c ltac:(lra) ltac:(lra) e He) as (d & Hd & K). exists d; split; auto. intros u Hu.
      specialize (K (u - c) ltac:(lra)). replace (c + (u - c)) with u in K by ring. lra.
Qed.

(** for ever *)
Corollary barrier f k : cont f -> f 0 <= k -> (forall t, 0 <= t -> k <= f t -> dini_le f t 0) ->
  forall t, 0 <= t -> f t <= k.
Proof. intros C F0 D t Ht. apply (barrier_until f k 0 t); auto; [lra|]. intros u Hu. apply D. lra. Qed.

(** an upper right derivative <= 0 everywhere: the function does not increase *)
Theorem dini_mono f s t : cont f -> 0 <= s <= t -> (forall r, s <= r < t -> dini_le f r 0) -> f t <= f s.
Proof. intros C Hst D. apply (barrier_until f (f s) s t); auto; lra. Qed.

(** with a constant slope bound *)
Corollary dini_slope f k s t : cont f -> 0 <= s <= t -> (forall r, s <= r < t -> dini_le f r k) ->
  f t - f s <= k * (t - s).
Proof.
  intros C Hst D. assert (f t - k * t <= f s - k * s); [|lra]. apply (dini_mono (fun u => f u - k * u)); auto.
  { apply cont_minus; auto. apply (lip_cont (fun u => k * u) (Rabs k)); [apply Rabs_pos|].
    intros r u Hr. replace (k * u - k * r) with (k * (u - r)) by ring. rewrite Rabs_mult, (Rabs_pos_eq (u - r)); lra. }
  intros r Hr e He. apply (soon (D r Hr e He)). intros h Hh K. lra.
Qed.

(** the same with a right derivative *)
Corollary rderiv_mono f s t l : cont f -> 0 <= s <= t -> (forall r, s <= r < t -> rderiv f r (l r) /\ l r <= 0) ->
  f t <= f s.
Proof. intros C H D. apply dini_mono; auto. intros r Hr. destruct (D r Hr). eapply rderiv_dini; eauto. Qed.

(** a right derivative between two bounds on [r, t) *)
Lemma between f f' lo hi r t : cont f -> 0 <= r <= t -> (forall u, r <= u < t -> rderiv f u (f' u) /\ lo <= f' u <= hi) ->
  lo * (t - r) <= f t - f r <= hi * (t - r).
Proof.
  intros C Hr F. split.
  - cut (-1 * f t - -1 * f r <= - lo * (t - r)); [lra|]. apply (dini_slope (fun u => -1 * f u)); auto using cont_scal.
    intros u Hu. destruct (F u Hu). eapply rderiv_dini; [|apply rderiv_scal; eauto]. lra.
  - apply (dini_slope f); auto. intros u Hu. destruct (F u Hu). eapply rderiv_dini; [|eauto]. lra.
Qed.

(** of size at most K *)
Lemma lip_between f f' K r t : cont f -> 0 <= r <= t ->
  (forall u, r <= u < t -> rderiv f u (f' u) /\ - K <= f' u <= K) -> Rabs (f t - f r) <= K * (t - r).
Proof. intros C Hr F. pose proof (between f f' (- K) K r t C Hr F). apply Rabs_le. lra. Qed.

(** one everywhere: a Lipschitz constant *)
Lemma lip_of_rderiv f f' K r t : cont f -> (forall u, 0 <= u -> rderiv f u (f' u) /\ Rabs (f' u) <= K) -> 0 <= r <= t ->
  Rabs (f t - f r) <= K * (t - r).
Proof.
  intros C F Hr. apply (lip_between f f'); auto. intros u Hu. destruct (F u ltac:(lra)). auto using Rabs_inv.
Qed.

Lemma rderiv_line f k r t : cont f -> 0 <= r <= t -> (forall u, r <= u < t -> rderiv f u k) -> f t - f r = k * (t - r).
Proof. intros C Hr F. pose proof (between f (fun _ => k) k k r t C Hr ltac:(split; [auto|lra])). lra. Qed.

(** a Lipschitz constant bounds the right derivative *)
Lemma lip_rderiv f K t l : (forall r q, 0 <= r <= q -> Rabs (f q - f r) <= K * (q - r)) -> 0 <= t ->
  rderiv f t l -> Rabs l <= K.
Proof.
  intros L Ht F. apply le_epsilon. intros e He. destruct (F e He) as (d & Hd & Q). specialize (Q (d / 2) ltac:(lra)).
  pose proof (L t (t + d / 2) ltac:(lra)) as B. apply Rabs_inv in Q. apply Rabs_inv in B. apply Rabs_le. split; nra.
Qed.

(** ** What decreases and is not negative has a limit *)
Lemma dec_limit f : (forall r t, 0 <= r <= t -> f t <= f r) -> (forall t, 0 <= t -> 0 <= f t) ->
  exists l, 0 <= l /\ (forall t, 0 <= t -> l <= f t) /\ forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    f t <= l + e.
Proof.
  intros Mo P. destruct (completeness (fun y => exists t, 0 <= t /\ y = - f t)) as (m & U & L).
  { exists 0. intros y (t & Ht & ->). specialize (P t Ht). lra. } { exists (- f 0), 0. split; lra. }
  exists (- m). split; [|split].
  - cut (m <= 0); [lra|]. apply L. intros y (t & Ht & ->). specialize (P t Ht). lra.
  - intros t Ht. cut (- f t <= m); [lra|]. eauto.
  - intros e He. apply Classical_Prop.NNPP. intros No. cut (m <= m - e); [lra|]. apply L. intros y (t & Ht & ->).
    apply Rnot_lt_le. intros N. apply No. exists t; split; auto. intros u Hu. specialize (Mo t u ltac:(lra)). lra.
Qed.

(** and what moves only at its cost has one, too *)
Lemma paid_limit (E F : R -> R) k l : 0 <= k -> (forall t, 0 <= t -> l <= E t) ->
  (forall r t, 0 <= r <= t -> Rabs (F t - F r) <= k * (E r - E t)) ->
  exists a, forall t, 0 <= t -> Rabs (F t - a) <= k * (E t - l).
Proof.
  intros Hk Hl HF. assert (Nest : forall t r, 0 <= t -> 0 <= r -> F t - k * (E t - l) <= F r + k * (E r - l)).
  { intros t r Ht Hr. assert (0 <= k * (E t - l)) by (specialize (Hl t Ht); apply Rmult_le_pos; lra).
    assert (0 <= k * (E r - l)) by (specialize (Hl r Hr); apply Rmult_le_pos; lra).
    destruct (Rle_dec r t); [pose proof (HF r t ltac:(lra)) as Q|pose proof (HF t r ltac:(lra)) as Q];
    apply Rabs_inv in Q; lra. }
  destruct (completeness (fun y => exists t, 0 <= t /\ y = F t - k * (E t - l))) as (a & Ub & Lub).
  { exists (F 0 + k * (E 0 - l)). intros y (t & Ht & ->). apply Nest; lra. }
  { exists (F 0 - k * (E 0 - l)), 0; split; [lra|auto]. }
  exists a. intros t Ht. apply Rabs_le. split.
  - assert (a <= F t + k * (E t - l)); [|lra]. apply Lub. intros y (u & Hu & ->). apply Nest; auto.
  - assert (F t - k * (E t - l) <= a); [|lra]. eauto.
Qed.

(** a derivative, without a quotient *)
Lemma derive_near f t l e : is_derive f t l -> 0 < e ->
  exists d, 0 < d /\ forall u, Rabs (u - t) < d -> Rabs (f u - f t - l * (u - t)) <= e * Rabs (u - t).
Proof.
  intros (_ & D) He. destruct (D t (fun _ H => H) (mkposreal e He)) as (d & K). exists d. split; [apply cond_pos|].
  intros u Hu. rewrite Rmult_comm. exact (K u Hu).
Qed.
Lemma rderiv_of_derive f t l : is_derive f t l -> rderiv f t l.
Proof.
  intros D e He. destruct (derive_near f t l e D He) as (d & Hd & K). exists d; split; auto. intros h Hh.
  specialize (K (t + h)). replace (t + h - t) with h in K by ring. rewrite (Rabs_pos_eq h) in K by lra. apply K, Hh.
Qed.

Lemma cont_of_derive f f' : (forall t, is_derive f t (f' t)) -> cont f.
Proof. intros H. apply cont_of_continuous. intros t _. apply @ex_derive_continuous. eexists. apply H. Qed.
