(** The free pair, stuck: its load is at an edge, or beyond, at isolated times only. There (4) transmits half of the
    adhesion, or none. *)
From InertialPair Require Import Dini Pair Forced ModeAtContact Modes Analytic RuleOfModes FinitelyManyModes Interface
  InterfaceMode.

Section Edges.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 a1 a2 b x v1 v2 s).
Let Hf : forced m1 m2 a1 a2 b (fun _ => 0) x v1 v2 s. Proof. apply free_case; auto. Qed.
(** what the spring and the damper do to both masses: of place and velocity the acceleration A of a stick, and so on *)
Let F (f g : R -> R) r := - / (m1 + m2) * (a2 * f r + a1 * g r).
Lemma cont_F f g : cont f -> cont g -> cont (F f g).
Proof. intros. apply cont_scal, cont_plus; apply cont_scal; auto. Qed.
Lemma rate_F f g f' g' r : rderiv f r (f' r) -> rderiv g r (g' r) -> rderiv (F f g) r (F f' g' r).
Proof. intros. apply rderiv_scal, rderiv_plus; apply rderiv_scal; auto. Qed.
Context (A := F x v1) (J := F v1 A).

(** in a stick from p to q *)
Lemma edge_once p q t k : 0 <= p -> (forall r, p < r < q -> v1 r = v2 r) -> p <= t <= q -> k = 1 \/ k = -1 ->
  exists d, 0 < d /\ forall r, p < r < q -> r <> t -> Rabs (r - t) < d -> k * A r < b / m2.
Proof.
  intros Hp St Ht Hk. pose proof (s_cx _ _ _ _ _ _ _ _ _ H) as Cx. pose proof (s_cv _ _ _ _ _ _ _ _ _ H) as Cv.
  pose proof (cont_w m1 m2 a1 a2 b Hm2 _ x v1 v2 s Hf) as Cw. assert (Hbm : 0 < b / m2) by positive.
  assert (CA : cont A) by (apply cont_F; auto). assert (CJ : cont J) by (apply cont_F; auto).
  assert (St' : forall r, p <= r < q -> v1 r = v2 r).
  { intros r Hr. destruct (Req_dec r p) as [->|]; [|apply St; lra]. apply cond_eq. intros e He.
    destruct (Cw p Hp e He) as (d & Hd & K). assert (0 < Rmin d (q - p)) by positive.
    pose proof (Rmin_l d (q - p)). pose proof (Rmin_r d (q - p)).
    specialize (K (p + Rmin d (q - p) / 2) ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)).
    rewrite St, (Rminus_diag_eq _ _ eq_refl), Rminus_0_l, Rabs_Ropp in K by lra. exact K. }
  assert (In : forall r, p <= r < q -> rderiv v1 r (A r) /\ k * A r <= b / m2).
  { intros r Hr. destruct (stuck_load m1 m2 a1 a2 b Hm1 Hm2 Hb _ (fun _ => 0) x v1 v2 s Hf r (q - r) ltac:(lra)
      ltac:(lra) (rderiv_const 0 r) ltac:(intros; apply St'; lra)) as (D & B).
    replace (load m1 m2 a1 a2 (fun _ => 0) x v1 r) with (m2 * A r) in * by (unfold A, F, load; field; lra).
    split; [apply rderiv_near with v2 (q - r); [lra|intros; symmetry; apply St'; lra|]|].
    - apply (rderiv_eq _ _ (m2 * A r / m2)); [field; lra|exact D].
    - apply Rabs_inv in B. undivide m2. destruct Hk; subst k; lra. }
  assert (DA : forall r, p <= r < q -> rderiv A r (J r)).
  { intros r Hr. apply rate_F; [apply (s_x _ _ _ _ _ _ _ _ _ H); lra|apply In; auto]. }
  assert (DJ : forall r, p <= r < q -> rderiv J r (F A J r)) by (intros; apply rate_F; [apply In|]; auto).
  assert (Le : forall r, p <= r < q -> k * A r <= b / m2) by (intros; apply In; auto).
  (* a function with a slope at a time is monotone around it *)
  assert (Mono : forall j f f' o, cont f -> cont f' -> (forall r, p <= r < q -> rderiv f r (f' r)) -> 0 <= o -> 0 < j *
    f' o -> exists d, 0 < d /\ forall r r', p <= r < r' -> r' <= q -> Rabs (r - o) < d -> Rabs (r' - o) < d -> j * f r <
    j * f r').
  { intros j f f' o Cf Cf' Df Ho S. destruct (cont_scal j _ Cf' o Ho (j * f' o / 2)) as (d & Hd & K); [lra|]. exists d.
    split; [auto|]. intros r r' Hr Hr' N N'. apply Rabs_def2 in N. apply Rabs_def2 in N'.
    pose proof (between (fun y => j * f y) (fun y => j * f' y) (j * f' o / 2) (j * f' o * 2) r r' (cont_scal _ _ Cf)
      ltac:(lra)) as B. assert (0 < j * f' o / 2 * (r' - r)) by (apply Rmult_lt_0_compat; lra).
    cut (j * f' o / 2 * (r' - r) <= j * f r' - j * f r); [lra|]. apply B. intros y Hy.
    split; [apply rderiv_scal, Df; lra|]. specialize (K y ltac:(lra) ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in K.
    lra. }
  assert (Flat : forall r, p < r < q -> k * A r = b / m2 -> k * J r = 0).
  { intros r Hr E. destruct (Rtotal_order (k * J r) 0) as [N|[Z|G]]; [exfalso|exact Z|exfalso].
    - destruct (Mono (- k) A J r CA CJ DA) as (d & Hd & K); [lra|lra|].
      destruct (just_before p r d) as (u & Hu & Nu); [lra|auto|]. pose proof (Le u ltac:(lra)).
      specialize (K u r ltac:(lra) ltac:(lra) ltac:(apply Rabs_def1; lra) ltac:(apply Rabs_def1; lra)). lra.
    - destruct (Mono k A J r CA CJ DA) as (d & Hd & K); [lra|lra|]. assert (0 < Rmin d (q - r)) by positive.
      pose proof (Rmin_l d (q - r)). pose proof (Rmin_r d (q - r)). pose proof (Le (r + Rmin d (q - r) / 2) ltac:(lra)).
      specialize (K r (r + Rmin d (q - r) / 2) ltac:(lra) ltac:(lra) ltac:(apply Rabs_def1; lra) ltac:(apply Rabs_def1;
        lra)). lra. }
  cut (exists d, 0 < d /\ forall r, p < r < q -> r <> t -> Rabs (r - t) < d -> k * A r <> b / m2).
  { intros (d & Hd & K). exists d. split; [auto|]. intros r Hr Ne N. specialize (K r Hr Ne N).
    pose proof (Le r ltac:(lra)). lra. }
  destruct (Req_dec (k * J t) 0) as [Z|Nz]; [destruct (Rle_dec (k * A t) 0) as [Np|Ps]|].
  - destruct (cont_scal k _ CA t ltac:(lra) _ Hbm) as (d & Hd & K). exists d. split; [auto|]. intros r Hr _ N E.
    specialize (K r ltac:(lra) N). apply Rabs_def2 in K. lra.
  - (* the acceleration is concave there, so its rate is 0 at t alone *)
    destruct (Mono (- k) J _ t CJ (cont_F _ _ CA CJ) DJ) as (d & Hd & K); [lra| |].
    { replace (- k * F A J t) with (/ (m1 + m2) * (a2 * (k * A t) + a1 * (k * J t))) by (unfold F at 1; ring).
      rewrite Z, Rmult_0_r, Rplus_0_r. apply Rmult_lt_0_compat; [positive|]. apply Rmult_lt_0_compat; lra. }
    exists d. split; [auto|]. intros r Hr Ne N E. pose proof (Flat r Hr E).
    assert (T : Rabs (t - t) < d) by (apply Rabs_def1; lra). destruct (Rdichotomy _ _ Ne); [pose proof (K r t ltac:(lra)
      ltac:(lra) N T)|pose proof (K t r ltac:(lra) ltac:(lra) T N)]; lra.
  - destruct (cont_scal k _ CJ t ltac:(lra) (Rabs (k * J t)) (Rabs_pos_lt _ Nz)) as (d & Hd & K). exists d.
    split; [auto|]. intros r Hr _ N E. specialize (K r ltac:(lra) N). rewrite (Flat r Hr E), Rminus_0_l, Rabs_Ropp in K.
    lra.
Qed.

(** [edges-isolated] Around every time of a solution: with $v_1=v_2$ (3) gives an acceleration of absolute value below
    $b/m_2$, but perhaps at that time itself. *)
Theorem edges_isolated t : 0 <= t -> exists d, 0 < d /\ forall r, 0 <= r -> r <> t -> Rabs (r - t) < d -> v1 r = v2 r ->
  Rabs (- (a2 * x r + a1 * v1 r) / (m1 + m2)) < b / m2.
Proof.
  intros Ht. assert (Side : forall p q, 0 <= p <= t -> t <= q -> one_mode v1 v2 p q -> exists d, 0 < d /\ forall r, p < r < q ->
    r <> t -> Rabs (r - t) < d -> v1 r = v2 r -> Rabs (- (a2 * x r + a1 * v1 r) / (m1 + m2)) < b / m2).
  { intros p q Hp Hq [St|[Fo|Ba]].
    - destruct (edge_once p q t 1 ltac:(lra) St ltac:(lra) ltac:(auto)) as (d & Hd & K).
      destruct (edge_once p q t (-1) ltac:(lra) St ltac:(lra) ltac:(auto)) as (d' & Hd' & K'). smaller d d'.
      intros r Hr Ne N _. specialize (K r Hr Ne ltac:(lra)). specialize (K' r Hr Ne ltac:(lra)).
      replace (- (a2 * x r + a1 * v1 r) / (m1 + m2)) with (A r) by (unfold A, F; field; lra). apply Rabs_def1; lra.
    - exists 1. split; [lra|]. intros r Hr _ _ E. specialize (Fo r Hr). lra.
    - exists 1. split; [lra|]. intros r Hr _ _ E. specialize (Ba r Hr). lra. }
  assert (A0 : analytic_at (fun _ => 0) t) by apply analytic_const.
  destruct (mode_after m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (fun _ => 0) (fun _ => 0) x v1 v2 s Hf (fun t _ => rderiv_const 0 t)
    t (fun _ => 0) 1 Ht ltac:(lra) A0 ltac:(auto)) as (d & Hd & After).
  destruct (Side t (t + d) ltac:(lra) ltac:(lra) After) as (d1 & Hd1 & K1).
  assert (Before : exists e, 0 < e /\ forall r, 0 <= r < t -> Rabs (r - t) < e -> v1 r = v2 r ->
    Rabs (- (a2 * x r + a1 * v1 r) / (m1 + m2)) < b / m2).
  { destruct (Req_dec t 0) as [->|]; [exists 1; split; [lra|intros; lra]|].
    destruct (interface_no_zeno m1 m2 a1 a2 Hm1 Hm2 Ha1 Ha2 _ _ (fun _ => 0) x v1 v2 _ t (forced_rubs _ _ _ _ _ _ _ _ _
      _ Hb Hf) (fun t _ => rderiv_const 0 t)) as (n & p & P0 & Pn & Step); [| |lra|].
    { intros r Hr. exists (fun _ => 0), (fun _ => 0), 1. repeat split; auto using analytic_const. lra. }
    { intros r Hr. exists b, b, 1. repeat split; auto; lra. }
    revert p P0 Pn Step. induction n as [|n IH]; intros p P0 Pn Step; [exfalso; lra|].
    destruct (Step n ltac:(lia)) as (Hn & Mo). destruct (Req_dec (p n) t) as [E|N].
    - apply (IH p P0 E). intros i Hi. apply Step. lia.
    - assert (0 <= p n) by (rewrite <- P0; apply (times_within (S n) p); [apply Step|lia]).
      rewrite Pn in Hn, Mo. destruct (Side (p n) t ltac:(lra) ltac:(lra) Mo) as (e & He & K). smaller e (t - p n).
      intros r Hr Nr E. apply Rabs_def2 in Nr as Nr'. apply K; auto; lra. }
  destruct Before as (e & He & K2). smaller e (Rmin d d1). intros r Hr Ne N E. apply Rabs_def2 in N as N'.
  destruct (Rtotal_order r t) as [L|[L|L]]; [apply K2; auto; lra|lra|apply K1; auto; lra].
Qed.
End Edges.
