(** Right increments: o(h), O(h), right derivatives; the Dini monotonicity lemma. *)
From Coq Require Import Reals Lra Psatz.
Local Open Scope R_scope.

(** a bound of the absolute value, both sides *)
Lemma Rabs_inv x a : Rabs x <= a -> - a <= x <= a.
Proof. intros H. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra. Qed.

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

(** o(h) of equal functions *)
Lemma little_ext f g : (forall h, f h = g h) -> little f -> little g.
Proof. intros E H e He; destruct (H e He) as (d & Hd & K). exists d; split; auto. intros; rewrite <- E; auto. Qed.

(** 0 is o(h) *)
Lemma little_0 : little (fun _ => 0).
Proof. intros e He; exists 1; split; [lra|]. intros h Hh; rewrite Rabs_R0; nra. Qed.

(** sums of o(h) *)
Lemma little_plus f g : little f -> little g -> little (fun h => f h + g h).
Proof.
  intros F G e He. destruct (F (e/2)) as (d1 & ? & K1); [lra|]. destruct (G (e/2)) as (d2 & ? & K2); [lra|].
  exists (Rmin d1 d2); split; [apply Rmin_glb_lt; auto|]. intros h Hh.
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  assert (Rabs (f h) <= e/2*h) by (apply K1; lra). assert (Rabs (g h) <= e/2*h) by (apply K2; lra).
  pose proof (Rabs_triang (f h) (g h)). lra.
Qed.

(** multiples of o(h) *)
Lemma little_scal c f : little f -> little (fun h => c * f h).
Proof.
  intros F e He. pose proof (Rabs_pos c). destruct (F (e / (Rabs c + 1))) as (d & ? & K).
  { apply Rdiv_lt_0_compat; lra. }
  exists d; split; auto. intros h Hh. rewrite Rabs_mult. specialize (K h Hh).
  assert (0 <= e / (Rabs c + 1)) by (apply Rlt_le, Rdiv_lt_0_compat; lra).
  apply Rle_trans with (Rabs c * (e / (Rabs c + 1) * h)). { apply Rmult_le_compat_l; auto. }
  replace (e * h) with ((Rabs c + 1) * (e / (Rabs c + 1) * h)) by (field; lra).
  apply Rmult_le_compat_r; nra.
Qed.

(** differences of o(h) *)
Lemma little_minus f g : little f -> little g -> little (fun h => f h - g h).
Proof. intros F G. apply little_ext with (fun h => f h + (-1) * g h); [intros; ring|]. apply little_plus; auto.
  apply little_scal; auto. Qed.

(** o(h) is O(h) *)
Lemma little_big f : little f -> big f.
Proof. intros F. destruct (F 1) as (d & ? & K); [lra|]. exists 1, d; repeat split; try lra; auto. Qed.

(** h is O(h) *)
Lemma big_id : big (fun h => h).
Proof. exists 1, 1; repeat split; try lra. intros; rewrite Rabs_pos_eq; lra. Qed.

(** O(h) of equal functions *)
Lemma big_ext f g : (forall h, f h = g h) -> big f -> big g.
Proof. intros E (C & d & ? & ? & K); exists C, d; repeat split; auto. intros; rewrite <- E; auto. Qed.

(** sums of O(h) *)
Lemma big_plus f g : big f -> big g -> big (fun h => f h + g h).
Proof.
  intros (C1 & d1 & ? & ? & K1) (C2 & d2 & ? & ? & K2).
  exists (C1 + C2), (Rmin d1 d2); repeat split; try lra; [apply Rmin_glb_lt; auto|]. intros h Hh.
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  assert (Rabs (f h) <= C1*h) by (apply K1; lra). assert (Rabs (g h) <= C2*h) by (apply K2; lra).
  pose proof (Rabs_triang (f h) (g h)). lra.
Qed.

(** multiples of O(h) *)
Lemma big_scal c f : big f -> big (fun h => c * f h).
Proof.
  intros (C & d & ? & ? & K). pose proof (Rabs_pos c). exists ((Rabs c + 1) * C), d; repeat split; auto; [nra|].
  intros h Hh. rewrite Rabs_mult. specialize (K h Hh). pose proof (Rabs_pos (f h)).
  rewrite Rmult_assoc. apply Rmult_le_compat; lra.
Qed.

(** differences of O(h) *)
Lemma big_minus f g : big f -> big g -> big (fun h => f h - g h).
Proof. intros F G. apply big_ext with (fun h => f h + (-1) * g h); [intros; ring|]. apply big_plus; auto.
  apply big_scal; auto. Qed.

(** a product of two O(h) is o(h) *)
Lemma big_mult f g : big f -> big g -> little (fun h => f h * g h).
Proof.
  intros (C1 & d1 & ? & ? & K1) (C2 & d2 & ? & ? & K2) e He.
  exists (Rmin (Rmin d1 d2) (e / (C1 * C2))); split.
  { repeat apply Rmin_glb_lt; auto. apply Rdiv_lt_0_compat; nra. }
  intros h (Hh & Hm).
  assert (h < d1 /\ h < d2 /\ h < e / (C1 * C2)) as (? & ? & He2).
  { repeat split; eapply Rlt_le_trans; [exact Hm| |exact Hm| |exact Hm|];
    [ eapply Rle_trans; [apply Rmin_l|apply Rmin_l] | eapply Rle_trans; [apply Rmin_l|apply Rmin_r] | apply Rmin_r ]. }
  rewrite Rabs_mult. assert (Rabs (f h) <= C1*h) by (apply K1; lra). assert (Rabs (g h) <= C2*h) by (apply K2; lra).
  pose proof (Rabs_pos (f h)). pose proof (Rabs_pos (g h)).
  apply Rle_trans with (C1 * h * (C2 * h)). { apply Rmult_le_compat; auto. }
  assert (0 < C1 * C2) by nra.
  assert (C1 * C2 * h < e). { apply Rmult_lt_reg_r with (/ (C1 * C2)). { apply Rinv_0_lt_compat; auto. }
    replace (C1 * C2 * h * / (C1 * C2)) with h by (field; split; lra). exact He2. }
  nra.
Qed.

(** increments *)
Lemma rderiv_big f t l : rderiv f t l -> big (fun h => f (t + h) - f t).
Proof.
  intros H. apply big_ext with (fun h => (f (t+h) - f t - l*h) + l * h); [intros; ring|].
  apply big_plus; [apply little_big; auto | apply big_scal, big_id].
Qed.

(** right derivatives of functions that are equal from some time on *)
Lemma rderiv_ext f g t l : (forall u, t <= u -> f u = g u) -> rderiv f t l -> rderiv g t l.
Proof.
  intros E H e He. destruct (H e He) as (d & ? & K). exists d; split; auto. intros h Hh.
  rewrite <- !E by lra. apply K; auto.
Qed.

(** of a sum *)
Lemma rderiv_plus f g t l k : rderiv f t l -> rderiv g t k -> rderiv (fun u => f u + g u) t (l + k).
Proof. intros F G. eapply little_ext; [|exact (little_plus _ _ F G)]. intros; simpl; ring. Qed.

(** of a multiple *)
Lemma rderiv_scal c f t l : rderiv f t l -> rderiv (fun u => c * f u) t (c * l).
Proof. intros F. eapply little_ext; [|exact (little_scal c _ F)]. intros; simpl; ring. Qed.

(** of a difference *)
Lemma rderiv_minus f g t l k : rderiv f t l -> rderiv g t k -> rderiv (fun u => f u - g u) t (l - k).
Proof. intros F G. eapply little_ext; [|exact (little_minus _ _ F G)]. intros; simpl; ring. Qed.

(** of a constant *)
Lemma rderiv_const c t : rderiv (fun _ => c) t 0.
Proof. eapply little_ext; [|exact little_0]. intros; simpl; ring. Qed.

(** of a product *)
Lemma rderiv_mult f g t l k : rderiv f t l -> rderiv g t k -> rderiv (fun u => f u * g u) t (l * g t + f t * k).
Proof.
  intros F G.
  eapply little_ext; [|exact (little_plus _ _ (little_plus _ _ (little_scal (g t) _ F) (little_scal (f t) _ G))
    (big_mult _ _ (rderiv_big _ _ _ F) (rderiv_big _ _ _ G)))].
  intros; simpl; ring.
Qed.

(** of an equal value *)
Lemma rderiv_eq f t l k : l = k -> rderiv f t l -> rderiv f t k.
Proof. intros ->; auto. Qed.

(** a right derivative bounds the upper right derivative *)
Lemma rderiv_dini f t l k : l <= k -> rderiv f t l -> dini_le f t k.
Proof.
  intros Hl H e He. destruct (H e He) as (d & ? & K). exists d; split; auto. intros h Hh.
  specialize (K h Hh). apply Rabs_inv in K. nra.
Qed.

(** continuity *)
Lemma cont_const c : cont (fun _ => c).
Proof. intros t _ e He; exists 1; split; [lra|]. intros. rewrite Rminus_diag_eq, Rabs_R0; auto. Qed.

(** continuity of a sum *)
Lemma cont_plus f g : cont f -> cont g -> cont (fun u => f u + g u).
Proof.
  intros F G t Ht e He. destruct (F t Ht (e/2)) as (d1 & ? & K1); [lra|].
    destruct (G t Ht (e/2)) as (d2 & ? & K2); [lra|].
  exists (Rmin d1 d2); split; [apply Rmin_glb_lt; auto|]. intros s Hs Hd.
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  assert (Rabs (f s - f t) < e/2) by (apply K1; lra). assert (Rabs (g s - g t) < e/2) by (apply K2; lra).
  replace (f s + g s - (f t + g t)) with ((f s - f t) + (g s - g t)) by ring.
  pose proof (Rabs_triang (f s - f t) (g s - g t)). lra.
Qed.

(** of a product *)
Lemma cont_mult f g : cont f -> cont g -> cont (fun u => f u * g u).
Proof.
  intros F G t Ht e He. pose proof (Rabs_pos (f t)). pose proof (Rabs_pos (g t)).
  set (k := Rabs (f t) + Rabs (g t) + 1). set (e1 := Rmin 1 (e / (2 * k))).
  assert (0 < e / (2 * k)) by (apply Rdiv_lt_0_compat; unfold k; lra).
  assert (0 < e1) by (apply Rmin_glb_lt; lra).
  destruct (F t Ht e1) as (d1 & ? & K1); auto. destruct (G t Ht e1) as (d2 & ? & K2); auto.
  exists (Rmin d1 d2); split; [apply Rmin_glb_lt; auto|]. intros s Hs Hd.
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  assert (A : Rabs (f s - f t) < e1) by (apply K1; lra). assert (B : Rabs (g s - g t) < e1) by (apply K2; lra).
  replace (f s * g s - f t * g t) with ((f s - f t) * (g s - g t) + (f s - f t) * g t + f t * (g s - g t)) by ring.
  eapply Rle_lt_trans. { eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_r. apply Rabs_triang. }
  rewrite !Rabs_mult. assert (e1 <= 1) by apply Rmin_l. assert (e1 <= e / (2*k)) by apply Rmin_r.
  assert (Hk : 0 < k) by (unfold k; lra).
  assert (k * e1 <= e / 2). { replace (e/2) with (k * (e / (2*k))) by (field; lra). apply Rmult_le_compat_l; lra. }
  pose proof (Rabs_pos (f s - f t)). pose proof (Rabs_pos (g s - g t)).
  assert (Rabs (f s - f t) * Rabs (g s - g t) <= e1 * 1) by (apply Rmult_le_compat; lra).
  assert (Rabs (f s - f t) * Rabs (g t) <= e1 * Rabs (g t)) by (apply Rmult_le_compat_r; lra).
  assert (Rabs (f t) * Rabs (g s - g t) <= Rabs (f t) * e1) by (apply Rmult_le_compat_l; lra).
  unfold k in *. lra.
Qed.

(** of a multiple *)
Lemma cont_scal c f : cont f -> cont (fun u => c * f u).
Proof. intros. apply cont_mult; auto. apply cont_const. Qed.

(** of a difference *)
Lemma cont_minus f g : cont f -> cont g -> cont (fun u => f u - g u).
Proof.
  intros F G t Ht e He. destruct (cont_plus f (fun u => -1 * g u) F (cont_scal (-1) g G) t Ht e He) as (d & ? & K).
  exists d; split; auto. intros s Hs Hd. specialize (K s Hs Hd). simpl in K.
  replace (f s - g s - (f t - g t)) with (f s + -1 * g s - (f t + -1 * g t)) by ring. auto.
Qed.

(** of an equal function *)
Lemma cont_ext f g : (forall u, 0 <= u -> f u = g u) -> cont f -> cont g.
Proof.
  intros E F t Ht e He. destruct (F t Ht e He) as (d & ? & K). exists d; split; auto. intros s Hs Hd.
  rewrite <- !E by auto. auto.
Qed.

(** of a function shifted in time *)
Lemma cont_shift f s : 0 <= s -> cont f -> cont (fun u => f (s + u)).
Proof.
  intros Hs F t Ht e He. destruct (F (s + t)) with (eps := e) as (d & ? & K); try lra.
  exists d; split; auto. intros r Hr Hd. apply K; [lra|]. replace (s + r - (s + t)) with (r - t) by ring; auto.
Qed.

(** a Lipschitz function is continuous *)
Lemma lip_cont f K : 0 <= K -> (forall r t, 0 <= r <= t -> Rabs (f t - f r) <= K * (t - r)) -> cont f.
Proof.
  intros HK L t Ht e He. exists (e / (K + 1)); split. { apply Rdiv_lt_0_compat; lra. }
  intros s Hs Hd.
  assert (Rabs (f s - f t) <= K * Rabs (s - t)).
  { destruct (Rle_dec s t).
    - rewrite (Rabs_minus_sym (f s)), (Rabs_minus_sym s). rewrite (Rabs_pos_eq (t - s)) by lra. apply L; lra.
    - rewrite (Rabs_pos_eq (s - t)) by lra. apply L; lra. }
  pose proof (Rabs_pos (s - t)).
  assert ((K + 1) * Rabs (s - t) < e). { apply Rmult_lt_reg_r with (/ (K + 1)). { apply Rinv_0_lt_compat; lra. }
    replace ((K+1) * Rabs (s - t) * / (K+1)) with (Rabs (s - t)) by (field; lra). exact Hd. }
  nra.
Qed.

(** ** Dini: a continuous function with upper right derivative <= 0 never increases. *)
Lemma dini_eps f s t e : 0 < e -> cont f -> 0 <= s <= t -> (forall r, s <= r < t -> dini_le f r 0) ->
  f t <= f s + e * (t - s).
Proof.
  intros He C Hst D.
  set (P := fun r => s <= r <= t /\ forall u, s <= u <= r -> f u <= f s + e * (u - s)).
  assert (Ps : P s). { split; [lra|]. intros u Hu. replace u with s by lra. lra. }
  destruct (completeness P) as (c & Cub & Club).
  { exists t. intros r (Hr & _); lra. } { exists s; auto. }
  assert (Hc : s <= c <= t). { split; [apply Cub; auto|]. apply Club. intros r (Hr & _); lra. }
  assert (Below : forall u, s <= u < c -> f u <= f s + e * (u - s)).
  { intros u Hu. destruct (Rle_dec (f u) (f s + e * (u - s))) as [|N]; auto. exfalso.
    assert (c <= u); [|lra]. apply Club. intros r (Hr & Q). destruct (Rle_dec r u); auto. exfalso; apply N, Q; lra. }
  assert (Pc : P c).
  { split; auto. intros u Hu. destruct (Req_dec u c) as [->|]; [|apply Below; lra].
    destruct (Rle_dec (f c) (f s + e * (c - s))) as [|N]; auto. exfalso.
    destruct (C c) with (eps := f c - (f s + e * (c - s))) as (d & Hd & K); try lra.
    assert (s < c). { destruct (Req_dec s c) as [E|]; [|lra]. subst c. lra. }
    set (u0 := Rmax s (c - d / 2)). assert (s <= u0) by apply Rmax_l. assert (c - d/2 <= u0) by apply Rmax_r.
    assert (u0 < c) by (unfold u0; apply Rmax_lub_lt; lra).
    specialize (K u0). assert (Rabs (f u0 - f c) < f c - (f s + e * (c - s))).
    { apply K; [lra|]. rewrite Rabs_left; lra. }
    apply Rabs_def2 in H3. pose proof (Below u0). nra. }
  destruct (Req_dec c t) as [->|Hne]. { apply Pc; lra. }
  exfalso. destruct (D c) with (eps := e) as (d & Hd & K); try lra.
  set (h := Rmin (d / 2) (t - c)). assert (0 < h) by (apply Rmin_glb_lt; lra).
  assert (h <= d/2) by apply Rmin_l. assert (h <= t - c) by apply Rmin_r.
  assert (P (c + h)).
  { split; [lra|]. intros u Hu. destruct (Rle_dec u c); [apply Pc; lra|].
    specialize (K (u - c)). replace (c + (u - c)) with u in K by ring.
    destruct Pc as (_ & Pc). specialize (Pc c). assert (f u - f c <= (0 + e) * (u - c)) by (apply K; lra).
    assert (f c <= f s + e * (c - s)) by (apply Pc; lra). lra. }
  pose proof (Cub _ H2). lra.
Qed.

(** an upper right derivative <= 0 everywhere: the function does not increase *)
Theorem dini_mono f s t : cont f -> 0 <= s <= t -> (forall r, s <= r < t -> dini_le f r 0) -> f t <= f s.
Proof.
  intros C Hst D. apply le_epsilon. intros e He.
  apply Rle_trans with (f s + e / (t - s + 1) * (t - s)).
  { apply dini_eps; auto. apply Rdiv_lt_0_compat; lra. }
  apply Rplus_le_compat_l. replace e with (e / (t - s + 1) * (t - s + 1)) at 2 by (field; lra).
  apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat|]; lra.
Qed.

(** with a constant slope bound *)
Corollary dini_slope f k s t : cont f -> 0 <= s <= t -> (forall r, s <= r < t -> dini_le f r k) ->
  f t - f s <= k * (t - s).
Proof.
  intros C Hst D.
  assert (f t - k * t <= f s - k * s); [|lra].
  apply (dini_mono (fun u => f u - k * u)); auto.
  { apply cont_minus; auto. apply (lip_cont (fun u => k * u) (Rabs k)); [apply Rabs_pos|].
    intros r u Hr. replace (k * u - k * r) with (k * (u - r)) by ring. rewrite Rabs_mult, (Rabs_pos_eq (u - r)); lra. }
  intros r Hr e He. destruct (D r Hr e He) as (d & ? & K). exists d; split; auto. intros h Hh.
  specialize (K h Hh). lra.
Qed.

(** the same with a right derivative *)
Corollary rderiv_mono f s t l : cont f -> 0 <= s <= t -> (forall r, s <= r < t -> rderiv f r (l r) /\ l r <= 0) ->
  f t <= f s.
Proof. intros C H D. apply dini_mono; auto. intros r Hr. destruct (D r Hr). eapply rderiv_dini; eauto. Qed.
