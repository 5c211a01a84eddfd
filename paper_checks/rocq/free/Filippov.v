(** What is called a solution in Pair.v is what Filippov calls one:
    absolutely continuous functions that obey the differential inclusion almost everywhere. *)
From Coq Require Import List.
From InertialPair Require Import Dini Pair Stick Pursuit Forced ForcedExistence WellPosed Analytic Modes
  FinitelyManyModes AlmostEverywhere.

Section Filippov.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** the inclusion at one time: x' = v1, m1 v1' = - a2 x - a1 v1 - b g, m2 v2' = b g for some g in the set-valued sign *)
Definition included (x v1 v2 : R -> R) t := exists g, -1 <= g <= 1 /\ (v2 t < v1 t -> g = 1) /\
  (v1 t < v2 t -> g = -1) /\
  is_derive x t (v1 t) /\ is_derive v1 t ((- a2 * x t - a1 * v1 t - b * g) / m1) /\ is_derive v2 t (b * g / m2).

(** a Filippov solution on [0, oo) *)
Definition filippov (x v1 v2 : R -> R) := ac x /\ ac v1 /\ ac v2 /\
  forall T, 0 <= T -> exists N, null N /\ forall t, 0 <= t <= T -> ~ N t -> included x v1 v2 t.

(** Every Filippov solution is a solution: what is proved of all solutions is true of it. *)
Theorem filippov_solution x v1 v2 : filippov x v1 v2 -> solution m1 m2 a1 a2 b x v1 v2 (fun t => m2 / b * v2 t).
Proof.
  intros (Ax & A1 & A2 & In). pose proof (cont_ac _ Ax) as Cx. pose proof (cont_ac _ A1) as C1.
  pose proof (cont_ac _ A2) as C2. assert (Hk : 0 < m2 / b) by positive.
  assert (As : ac (fun t => m2 / b * v2 t)) by (apply ac_scal; auto).
  assert (Ds : forall t, included x v1 v2 t -> exists g, is_derive (fun t => m2 / b * v2 t) t g /\ -1 <= g <= 1 /\
    (v2 t < v1 t -> g = 1) /\ (v1 t < v2 t -> g = -1)).
  { intros t (g & Hg & Gp & Gn & _ & _ & D). exists g. split; auto.
    replace g with (m2 / b * (b * g / m2)) by (field; lra). apply (is_derive_scal v2 t (m2 / b) _ D). }
  assert (Local : forall t k, 0 <= t -> k = 1 \/ k = -1 -> 0 < k * (v1 t - v2 t) ->
    rderiv (fun t => m2 / b * v2 t) t k).
  { intros t k Ht Hk1 Pos. assert (Cw : cont (fun t => k * (v1 t - v2 t))) by (apply cont_scal, cont_minus; auto).
    destruct (Cw t Ht _ Pos) as (d & Hd & K). intros e He. exists d; split; auto. intros h Hh.
    destruct (In (t + h) ltac:(lra)) as (N & HN & Inn).
    destruct (ac_slope (fun t => m2 / b * v2 t) N t (t + h) k k) as (L & U); auto; [lra| |].
    - intros u Hu Nu. destruct (Ds u (Inn u ltac:(lra) Nu)) as (g & Dg & _ & Gp & Gn). exists g. split; auto.
      specialize (K u ltac:(lra)). assert (Q : Rabs (u - t) < d) by (rewrite Rabs_pos_eq; lra). specialize (K Q).
      apply Rabs_def2 in K. destruct Hk1; subst k; [rewrite Gp by lra|rewrite Gn by lra]; lra.
    - replace (t + h - t) with h in * by ring. apply Rabs_le. split; nra. }
  constructor; auto.
  - intros r t Hr. destruct (In t ltac:(lra)) as (N & HN & Inn).
    destruct (ac_slope (fun t => m2 / b * v2 t) N r t (-1) 1) as (L & U); auto.
    + intros u Hu Nu. destruct (Ds u (Inn u ltac:(lra) Nu)) as (g & Dg & Hg & _). exists g; auto.
    + apply Rabs_le. lra.
  - intros t Ht Hv. apply (Local t 1); auto; lra.
  - intros t Ht Hv. apply (Local t (-1)); auto; lra.
  - intros t Ht. apply (ac_rderiv x v1); auto. intros T HT. destruct (In T HT) as (N & HN & Inn). exists N. split; auto.
    intros u Hu Nu. destruct (Inn u Hu Nu) as (g & _ & _ & _ & D & _). auto.
  - intros t Ht. apply (ac_rderiv (fun u => m1 * v1 u + b * (m2 / b * v2 u)) (fun u => - (a2 * x u + a1 * v1 u))); auto.
    + apply ac_plus; apply ac_scal; auto.
    + apply cont_ext with (fun u => -1 * (a2 * x u + a1 * v1 u)); [intros; ring|].
      apply cont_scal, cont_plus; apply cont_scal; auto.
    + intros T HT. destruct (In T HT) as (N & HN & Inn). exists N. split; auto.
      intros u Hu Nu. destruct (Inn u Hu Nu) as (g & _ & _ & _ & _ & D1 & D2).
      replace (- (a2 * x u + a1 * v1 u)) with (plus (m1 * ((- a2 * x u - a1 * v1 u - b * g) / m1)) (b * (m2 / b * (b
        * g / m2)))) by (unfold plus; simpl; field; lra).
      apply (is_derive_plus (fun u => m1 * v1 u) (fun u => b * (m2 / b * v2 u))).
      * apply (is_derive_scal v1 u m1 _ D1).
      * apply (is_derive_scal (fun u => m2 / b * v2 u) u b). apply (is_derive_scal v2 u (m2 / b) _ D2).
  - intros t Ht. field; lra.
Qed.

(** *** And the other way round *)
(** a continuous right derivative is a derivative *)
Lemma derive_of_rderiv f g t : cont f -> cont g -> (forall u, 0 <= u -> rderiv f u (g u)) -> 0 < t ->
  is_derive f t (g t).
Proof.
  intros F G D Ht. apply is_derive_Reals. intros e He. destruct (G t ltac:(lra) (e / 2) ltac:(lra)) as (d & Hd & K).
  assert (Hd' : 0 < Rmin d t) by positive. exists (mkposreal _ Hd'). simpl. intros h Nh Hh.
  pose proof (Rmin_l d t). pose proof (Rmin_r d t).
  assert (S : forall p q, t - Rmin d t < p <= q -> q < t + Rmin d t ->
    (g t - e / 2) * (q - p) <= f q - f p <= (g t + e / 2) * (q - p)).
  { intros p q Hp Hq. assert (B : forall u, p <= u < q -> g t - e / 2 <= g u <= g t + e / 2).
    { intros u Hu. specialize (K u ltac:(lra)). assert (Q : Rabs (u - t) < d) by (apply Rabs_def1; lra).
      specialize (K Q). apply Rabs_def2 in K. lra. }
    apply (between f g); auto; [lra|]. intros u Hu. split; [apply D; lra|auto]. }
  apply Rle_lt_trans with (e / 2); [|lra]. replace ((f (t + h) - f t) / h - g t)
    with ((f (t + h) - f t - g t * h) / h) by (field; auto).
  apply Rabs_def2 in Hh. unfold Rdiv at 1. rewrite Rabs_mult, Rbasic_fun.Rabs_inv. apply Rmult_le_reg_r with (Rabs h);
    [apply Rabs_pos_lt; auto|].
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by (apply Rabs_no_R0; auto). apply Rabs_le. destruct (Rlt_dec 0 h).
  - rewrite Rabs_pos_eq by lra. destruct (S t (t + h) ltac:(lra) ltac:(lra)). lra.
  - assert (h < 0) by (destruct (Req_dec h 0); [contradiction|lra]). rewrite Rabs_left by lra.
    destruct (S (t + h) t ltac:(lra) ltac:(lra)). lra.
Qed.

(** a bounded right derivative on every [0, T]: absolutely continuous *)
Lemma ac_of_rderiv f g : cont f -> cont g -> (forall u, 0 <= u -> rderiv f u (g u)) -> ac f.
Proof.
  intros F G D. apply ac_lip. intros T HT. destruct (cont_bounded g T G HT) as (B & HB). exists B. split.
  { pose proof (HB 0 ltac:(lra)). pose proof (Rabs_pos (g 0)). lra. }
  intros r t Hr Hl. apply (lip_between f g); auto. intros u Hu. split; [apply D; lra|apply Rabs_inv, HB; lra].
Qed.

(** equal around t *)
Lemma derive_near (f g : R -> R) t d (l : R) : 0 < d -> (forall u, t - d < u < t + d -> f u = g u) ->
  is_derive f t l -> is_derive g t l.
Proof.
  intros Hd E D. apply (is_derive_ext_loc f); auto. exists (mkposreal d Hd). intros u Hu. apply E.
  unfold ball in Hu; simpl in Hu; unfold AbsRing_ball, abs, minus, plus, opp in Hu; simpl in Hu.
  apply Rabs_def2 in Hu. lra.
Qed.

(** Every solution is a Filippov solution: its mode changes finitely often in bounded time,
    and in between it is smooth. *)
Theorem solution_filippov x v1 v2 s : solution m1 m2 a1 a2 b x v1 v2 s -> filippov x v1 v2.
Proof.
  intros H. pose proof (s_cx _ _ _ _ _ _ _ _ _ H) as Cx. pose proof (s_cv _ _ _ _ _ _ _ _ _ H) as C1.
  pose proof (moves_cs m1 m2 a1 a2 b _ _ _ _ _ _ H) as Cs.
  set (P := fun u => m1 * v1 u + b * s u). set (g := fun u => - (a2 * x u + a1 * v1 u)).
  assert (CP : cont P) by (apply cont_plus; apply cont_scal; auto). assert (Cg : cont g).
  { apply cont_ext with (fun u => -1 * (a2 * x u + a1 * v1 u)); [intros; unfold g; ring|].
    apply cont_scal, cont_plus; apply cont_scal; auto. }
  assert (DP : forall u, 0 <= u -> rderiv P u (g u)) by exact (s_v1 _ _ _ _ _ _ _ _ _ H).
  assert (As : ac s). { apply ac_lip. intros T HT. exists 1. split; [lra|]. intros r t Hr _. rewrite Rmult_1_l.
    apply (s_lip _ _ _ _ _ _ _ _ _ H); auto. }
  set (c := m2 * v2 0 - b * s 0). assert (V2 : forall u, 0 <= u -> v2 u = (c + b * s u) / m2).
  { intros u Hu. pose proof (s_v2 _ _ _ _ _ _ _ _ _ H u Hu). unfold c. apply Rmult_eq_reg_l with m2; [|lra].
    replace (m2 * ((m2 * v2 0 - b * s 0 + b * s u) / m2)) with (m2 * v2 0 - b * s 0 + b * s u) by (field; lra). lra. }
  assert (AcE : forall f f', (forall u, 0 <= u -> f u = f' u) -> ac f -> ac f').
  { intros f f' E F T HT e He. destruct (F T HT e He) as (d & Hd & K). exists d; split; auto. intros l Ch L.
    replace (moves f' l) with (moves f l); [auto|]. clear - E Ch. assert (G : forall l lo, 0 <= lo -> chain l lo T ->
      moves f l = moves f' l).
    { clear Ch l. induction l as [|(p, q) l IH]; simpl; auto. intros lo Hlo (Hp & Ch). rewrite (IH q), !E; auto; lra.
      }
    apply (G l 0); auto; lra. }
  split; [apply (ac_of_rderiv x v1); auto; exact (s_x _ _ _ _ _ _ _ _ _ H)|]. split; [|split].
  - apply (AcE (fun u => / m1 * (P u + - b * s u))); [intros; unfold P; field; lra|].
    apply ac_scal, ac_plus; [apply (ac_of_rderiv P g); auto|apply ac_scal; auto].
  - apply (AcE (fun u => b / m2 * s u + c / m2 * 1)); [intros; rewrite V2 by auto; field; lra|].
    apply ac_plus; [apply ac_scal; auto|]. apply ac_lip. intros T HT. exists 0. split; [lra|]. intros r t _ _.
    rewrite Rminus_diag_eq, Rabs_R0 by auto. lra.
  - intros T HT. pose proof (proj2 (free_case m1 m2 a1 a2 b x v1 v2 s) H) as Hf.
    assert (PA : piecewise_analytic (fun _ => 0)).
    { intros t Ht. exists (fun _ => 0), (fun _ => 0), 1. repeat split; auto using analytic_const. lra. }
    destruct (no_zeno m1 m2 a1 a2 b (fun _ => 0) (fun _ => 0) x v1 v2 s T Hm1 Hm2 Ha1 Ha2 Hb Hf
      (fun t _ => rderiv_const 0 t) PA HT) as (n & p & P0 & Pn & Step).
    exists (fun t => exists i, t = p i). split; [apply null_points|]. intros t Ht Nt.
    assert (exists i, (i < n)%nat /\ p i < t < p (S i)) as (i & Hi & Hpi).
    { assert (G : forall k, (k <= n)%nat -> t < p k -> exists i, (i < k)%nat /\ p i < t < p (S i)).
      { induction k as [|k IH]; intros Hk Lt.
        - exfalso. apply Nt. exists O. lra.
        - destruct (Rtotal_order t (p k)) as [L|[E|G]].
          + destruct (IH ltac:(lia) L) as (i & Hi & Q). exists i; split; auto.
          + exfalso. apply Nt. exists k. auto.
          + exists k. split; [lia|lra]. }
      apply (G n); auto. destruct (Req_dec t (p n)) as [E|]; [exfalso; apply Nt; exists n; auto|]. lra. }
    assert (Pos : 0 <= p i) by (rewrite <- P0; apply (times_within n p); [apply Step|lia]).
    destruct (Step i Hi) as (_ & Mode). set (d := Rmin (t - p i) (p (S i) - t)).
    assert (Hd : 0 < d) by positive. assert (d <= t - p i) by apply Rmin_l. assert (d <= p (S i) - t) by apply Rmin_r.
    assert (Dx : is_derive x t (v1 t)) by (apply derive_of_rderiv; auto; [exact (s_x _ _ _ _ _ _ _ _ _ H)|lra]).
    assert (Dp : is_derive P t (g t)) by (apply derive_of_rderiv; auto; lra).
    assert (Slip : forall k, k = 1 \/ k = -1 -> (forall u, p i < u < p (S i) -> 0 < k * (v1 u - v2 u)) ->
      included x v1 v2 t).
    { intros k Hk W. exists k. specialize (W t Hpi) as Wt. split; [lra|]. split; [destruct Hk; subst k; lra|].
      split; [destruct Hk; subst k; lra|]. split; auto. assert (Ds : is_derive s t k).
      { set (r := t - d / 2). apply (derive_near (fun u => s r + k * (u - r)) s t (d / 2)); [lra| |].
        - intros u Hu. pose proof (moves_impulse m1 m2 a1 a2 b _ _ x v1 v2 s H r u k) as SI. rewrite <- SI; auto; [ring| |];
            unfold r; [lra|]. intros q Hq. apply W. lra.
        - auto_derive; auto. ring. }
      split.
      - apply (derive_near (fun u => / m1 * (P u + - b * s u)) v1 t d); auto; [intros; unfold P; field; lra|].
        replace ((- a2 * x t - a1 * v1 t - b * k) / m1) with (/ m1 * (plus (g t) (- b * k))) by (unfold plus, g;
          simpl; field; lra).
        apply (is_derive_scal (fun u => P u + - b * s u)). apply (is_derive_plus P (fun u => - b * s u)); auto.
        apply (is_derive_scal s t (- b) _ Ds).
      - apply (derive_near (fun u => b / m2 * s u + c / m2) v2 t d); auto; [intros u Hu; rewrite V2 by lra; field;
        lra|]. replace (b * k / m2) with (plus (b / m2 * k) 0) by (unfold plus; simpl; field; lra).
        apply (is_derive_plus (fun u => b / m2 * s u) (fun _ => c / m2)); [apply (is_derive_scal s t (b / m2) _ Ds)|].
        apply @is_derive_const. }
    destruct Mode as [St|[Fo|Ba]].
    + set (M := m1 + m2). assert (HM : 0 < M) by positive. set (k := m2 / (b * M) * g t).
      assert (Ev : forall u, t - d < u < t + d -> / M * (P u + c) = v1 u /\ / M * (P u + c) = v2 u).
      { intros u Hu. specialize (St u ltac:(lra)). pose proof (V2 u ltac:(lra)) as Vu. unfold P.
        assert (Eq : m1 * v1 u + b * s u + c = M * v1 u).
        { unfold M. rewrite St at 2. rewrite <- St at 1. replace (b * s u) with (m2 * v2 u - c) by (rewrite Vu;
          field; lra). rewrite St. ring. }
        rewrite Eq. split; [field; lra|]. rewrite <- St. field; lra. }
      assert (Dv : is_derive (fun u => / M * (P u + c)) t (/ M * g t)).
      { apply (is_derive_scal (fun u => P u + c)). replace (g t) with (plus (g t) 0) by (unfold plus; simpl; ring).
        apply (is_derive_plus P (fun _ => c)); auto. apply @is_derive_const. }
      assert (D1 : is_derive v1 t (/ M * g t)) by (apply (derive_near (fun u => / M * (P u + c)) v1 t d); auto;
        intros u Hu; apply Ev; auto).
      assert (D2 : is_derive v2 t (/ M * g t)) by (apply (derive_near (fun u => / M * (P u + c)) v2 t d); auto;
        intros u Hu; apply Ev; auto).
      assert (Ds : rderiv s t k).
      { apply rderiv_ext with (fun u => m2 / b * v2 u + - (c / b)); [intros u Hu; rewrite V2 by lra; field; lra|].
        apply rderiv_eq with (m2 / b * (/ M * g t) + 0); [unfold k; field; lra|].
        apply rderiv_plus; [apply rderiv_scal, rderiv_of_derive; auto|apply rderiv_const]. }
      assert (Bk : Rabs k <= 1).
      { apply (lip_rderiv s 1 t k); [intros r q Hq; rewrite Rmult_1_l; apply (s_lip _ _ _ _ _ _ _ _ _ H)|lra|]; auto. }
      pose proof (St t Hpi) as Et. exists k. split; [apply Rabs_inv; auto|]. split; [lra|]. split; [lra|]. split; auto. split.
      * replace ((- a2 * x t - a1 * v1 t - b * k) / m1) with (/ M * g t); auto. unfold k, g, M. field. lra.
      * replace (b * k / m2) with (/ M * g t); auto. unfold k. field. lra.
    + apply (Slip 1); auto. intros u Hu. specialize (Fo u Hu). lra.
    + apply (Slip (-1)); auto. intros u Hu. specialize (Ba u Hu). lra.
Qed.

(** The two notions agree. *)
Corollary filippov_iff x v1 v2 : filippov x v1 v2 <-> exists s, solution m1 m2 a1 a2 b x v1 v2 s.
Proof.
  split; [intros F; eexists; apply filippov_solution, F|]. intros (s & H). exact (solution_filippov _ _ _ _ H).
Qed.

(** From every start there is one and only one Filippov solution. *)
Corollary filippov_well_posed x0 v10 v20 : exists x v1 v2, (filippov x v1 v2 /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2', filippov x' v1' v2' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t.
Proof.
  destruct (well_posed m1 m2 a1 a2 b x0 v10 v20 Hm1 Hm2 Ha1 Ha2 Hb) as (x & v1 & v2 & s & (H & St) & Only).
  exists x, v1, v2. split; [split; [exact (solution_filippov _ _ _ _ H)|auto]|]. intros x' v1' v2' F X V W t Ht.
  destruct (Only _ _ _ _ (filippov_solution _ _ _ F) X V W t Ht) as (? & ? & ? & _). auto.
Qed.
End Filippov.
