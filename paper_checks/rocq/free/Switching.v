(** The paper's equations (3), (4), which switch between the two modes by three-valued signs: absolutely continuous
    functions obey them at almost all times exactly if they are a motion of Coulomb's law (in Filippov's sense) that
    at almost all times of a stick asks for less than all of the friction. Without a force every motion does. *)
From InertialPair Require Import Dini Forced ModeAtContact AlmostEverywhere Filippov.

(** the three-valued sign, eq. (1) *)
Definition sgn r := if Rlt_dec 0 r then 1 else if Rlt_dec r 0 then -1 else 0.
Lemma sgn_cases r : (0 < r /\ sgn r = 1) \/ (r < 0 /\ sgn r = -1) \/ (r = 0 /\ sgn r = 0).
Proof. unfold sgn. destruct (Rlt_dec 0 r); [auto|]. destruct (Rlt_dec r 0); [auto|]. lra. Qed.

Section Switching.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** eqs. (3) and (4) at one time: a and a' are the accelerations of the bodies *)
Definition switched (u x v1 v2 : R -> R) t := exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\
  is_derive v2 t a' /\ (m1 + m2 * (1 - Rabs (sgn (v1 t - v2 t)))) * a + a1 * v1 t + a2 * x t + b * sgn (v1 t - v2 t)
  = u t /\
  m2 * a' = m2 * a * ((1 - Rabs (sgn (v1 t - v2 t))) / 2 * (1 - sgn (Rabs a - b / m2))) + b * sgn (v1 t - v2 t).

(** a solution of (3), (4): absolutely continuous, the equations met at almost all times *)
Definition switching u x v1 v2 := ac x /\ ac v1 /\ ac v2 /\ almost (switched u x v1 v2).

Context (load := load m1 m2 a1 a2) (filippov := filippov m1 m2 a1 a2 b).

(** at almost all times of a stick both bodies have one rate *)
Lemma same_rates v1 v2 : almost (fun t => v1 t = v2 t -> forall a a' : R, is_derive v1 t a -> is_derive v2 t a' -> a = a').
Proof.
  apply (almost_impl _ _) with (2 := almost_no_simple_zero (fun t => v1 t - v2 t)). intros t _ No E a a' D D'.
  cut (a - a' = 0); [lra|]. apply No; [lra|]. exact (is_derive_minus v1 v2 t a a' D D').
Qed.

(** (3), (4) at such a time, and Coulomb's law: both are the same with a load below b *)
Lemma switched_iff (u x v1 v2 : R -> R) t : (v1 t = v2 t -> forall a a' : R, is_derive v1 t a -> is_derive v2 t a' -> a = a') ->
  (switched u x v1 v2 t <-> included m1 m2 a1 a2 b u x v1 v2 t /\ (v1 t = v2 t -> Rabs (load u x v1 t) < b)).
Proof.
  intros Same. assert (Hbm : 0 < b / m2) by positive. split.
  - intros (a & a' & Dx & D1 & D2 & E3 & E4).
    destruct (sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S in E3, E4.
    + rewrite Rabs_R1 in E3, E4. split; [|intros; lra]. exists 1. repeat (split; [lra|]). split; [auto|split].
      * replace ((u t - a2 * x t - a1 * v1 t - b * 1) / m1) with a by (rewrite <- E3; field; lra); auto.
      * replace (b * 1 / m2) with a' by (apply Rmult_eq_reg_l with m2; [field_simplify; lra|lra]); auto.
    + rewrite Rabs_left in E3, E4 by lra. split; [|intros; lra]. exists (-1). repeat (split; [lra|]). split; [auto|split].
      * replace ((u t - a2 * x t - a1 * v1 t - b * -1) / m1) with a by (rewrite <- E3; field; lra); auto.
      * replace (b * -1 / m2) with a' by (apply Rmult_eq_reg_l with m2; [field_simplify; lra|lra]); auto.
    + rewrite Rabs_R0 in E3, E4. assert (Eq : a = a') by (apply Same; auto; lra). subst a'.
      assert (Small : Rabs a < b / m2) by (destruct (sgn_cases (Rabs a - b / m2)) as [(L & Z)|[(L & Z)|(L & Z)]];
        [exfalso|lra|exfalso]; rewrite Z in E4; assert (a = 0) as -> by nra; rewrite Rabs_R0 in L; lra).
      apply Rabs_def2 in Small. assert (m2 * (b / m2) = b) by (field; lra).
      assert (Ld : load u x v1 t = m2 * a) by (unfold load, ModeAtContact.load; rewrite <- E3; field; lra).
      split; [|intros _; rewrite Ld; apply Rabs_def1; nra]. exists (m2 * a / b).
      split; [split; undivide b; nra|]. split; [lra|]. split; [lra|]. split; [auto|split].
      * replace ((u t - a2 * x t - a1 * v1 t - b * (m2 * a / b)) / m1) with a; auto. rewrite <- E3. field; lra.
      * replace (b * (m2 * a / b) / m2) with a by (field; lra). auto.
  - intros ((g & Hg & Gp & Gn & Dx & D1 & D2) & Small).
    set (a := (u t - a2 * x t - a1 * v1 t - b * g) / m1) in *. exists a, (b * g / m2).
    split; [auto|split; [auto|split; [auto|]]].
    destruct (sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S.
    + assert (g = 1) by lra. subst g. rewrite Rabs_R1. unfold a. split; field; lra.
    + assert (g = -1) by lra. subst g. rewrite (Rabs_left (-1)) by lra. unfold a. split; field; lra.
    + rewrite Rabs_R0. assert (Eq : a = b * g / m2) by (apply Same; auto; lra).
      assert (E3 : (m1 + m2) * a + a1 * v1 t + a2 * x t = u t).
      { rewrite Rmult_plus_distr_r. rewrite Eq at 2. unfold a. field; lra. }
      assert (Ld : load u x v1 t = m2 * a) by (unfold load, ModeAtContact.load; rewrite <- E3; field; lra).
      specialize (Small ltac:(lra)). apply Rabs_def2 in Small.
      assert (Sm : Rabs a < b / m2) by (assert (m2 * (b / m2) = b) by (field; lra); apply Rabs_def1; nra).
      destruct (sgn_cases (Rabs a - b / m2)) as [(L & Z)|[(L & Z)|(L & Z)]]; try lra. rewrite Z. split; [lra|].
      rewrite <- Eq. field.
Qed.

(** [forced-switching-iff] Under any force the absolutely continuous solutions of (3), (4), met at almost every time,
    are the Filippov solutions with $|\Lambda|<b$ at almost every time with $v_1=v_2$, and only they. *)
Theorem forced_switching_iff u x v1 v2 : switching u x v1 v2 <->
  filippov u x v1 v2 /\ almost (fun t => v1 t = v2 t -> Rabs (load u x v1 t) < b).
Proof.
  assert (I : almost (switched u x v1 v2) <-> almost (included m1 m2 a1 a2 b u x v1 v2) /\
    almost (fun t => v1 t = v2 t -> Rabs (load u x v1 t) < b)).
  { pose proof (same_rates v1 v2) as Sr. split.
    - intros A. pose proof (almost_and _ _ Sr A) as B. split; revert B; apply almost_impl; intros t _ (S & W);
        apply (switched_iff u x v1 v2 t S); auto.
    - intros (A & B). pose proof (almost_and _ _ Sr (almost_and _ _ A B)) as C. revert C. apply almost_impl.
      intros t _ (S & W). apply (switched_iff u x v1 v2 t S); auto. }
  unfold switching, filippov, Filippov.filippov. tauto.
Qed.

(** at almost all times of a stick of Coulomb's law the load is what body 2 is given, and no more than b *)
Lemma stuck_at u x v1 v2 : filippov u x v1 v2 -> almost (fun t => v1 t = v2 t -> exists a : R, is_derive x t (v1 t) /\
  is_derive v1 t a /\ is_derive v2 t a /\ load u x v1 t = m2 * a /\ Rabs (m2 * a) <= b).
Proof.
  intros (_ & _ & _ & In). apply (almost_impl _ _) with (2 := almost_and _ _ (same_rates v1 v2) In).
  intros t _ (Same & g & Hg & _ & _ & Dx & D1 & D2) E. pose proof (Same E _ _ D1 D2) as Q. exists (b * g / m2).
  rewrite Q in D1. split; [auto|split; [auto|split; [auto|split]]].
  - unfold load, ModeAtContact.load. apply Rmult_eq_reg_r with ((m1 + m2) / m2); [|apply Rgt_not_eq, Rdiv_lt_0_compat; lra].
    transitivity (m1 * (b * g / m2) + b * g); [rewrite <- Q|]; field; lra.
  - replace (m2 * (b * g / m2)) with (b * g) by (field; lra). apply Rabs_le. split; nra.
Qed.
Lemma load_within u x v1 v2 : filippov u x v1 v2 -> almost (fun t => v1 t = v2 t -> Rabs (load u x v1 t) <= b).
Proof.
  intros F. generalize (stuck_at _ _ _ _ F). apply almost_impl. intros t _ S E.
  destruct (S E) as (a & _ & _ & _ & -> & Le). exact Le.
Qed.

(** [literal-solutions] Under an integrable force that is continuous at almost every time (3), (4) have a solution
    from the start of a motion exactly if that has $|\Lambda|\neq b$ at almost every time with $v_1=v_2$; every such
    solution is that motion. *)
Theorem literal_solutions u U x v1 v2 s : integral_of u U -> almost (continuous u) -> forced m1 m2 a1 a2 b U x v1 v2 s ->
  ((exists x' v1' v2', switching u x' v1' v2' /\ x' 0 = x 0 /\ v1' 0 = v1 0 /\ v2' 0 = v2 0) <->
    almost (fun t => v1 t = v2 t -> Rabs (load u x v1 t) <> b)) /\
  forall x' v1' v2', switching u x' v1' v2' -> x' 0 = x 0 -> v1' 0 = v1 0 -> v2' 0 = v2 0 ->
    forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t.
Proof.
  intros HU Cu H.
  assert (Only : forall x' v1' v2', switching u x' v1' v2' -> x' 0 = x 0 -> v1' 0 = v1 0 -> v2' 0 = v2 0 ->
    forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t).
  { intros x' v1' v2' Sw X V W t Ht. apply forced_switching_iff in Sw.
    apply (forced_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U x' v1' v2' _ x v1 v2 s 0
      (filippov_forced m1 m2 a1 a2 b Hm1 Hm2 Hb u U _ _ _ HU (proj1 Sw)) H); auto; lra. }
  split; [|exact Only]. pose proof (forced_filippov m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb u U x v1 v2 s HU H Cu) as F. split.
  - intros (x' & v1' & v2' & Sw & X & V & W). pose proof (Only x' v1' v2' Sw X V W) as Eq.
    apply forced_switching_iff in Sw. revert Sw. intros (_ & L). revert L. apply almost_impl. intros t Ht L E.
    destruct (Eq t Ht) as (Ex & Ev & Ew). unfold load, ModeAtContact.load in *. rewrite Ex, Ev in L. lra.
  - intros N. exists x, v1, v2. split; [|auto]. apply forced_switching_iff. split; [auto|].
    apply (almost_impl _ _) with (2 := almost_and _ _ N (load_within _ _ _ _ F)). intros t _ (Ne & Le) E. lra.
Qed.

(** [switching-iff] The absolutely continuous solutions of (3), (4) without a control, met at almost all times, are
    Filippov's, and only they. *)
Theorem switching_iff x v1 v2 : switching (fun _ => 0) x v1 v2 <-> filippov (fun _ => 0) x v1 v2.
Proof.
  rewrite forced_switching_iff. split; [tauto|]. intros F. split; [auto|].
  set (p := fun k t => a2 * x t + a1 * v1 t + k * (b * (m1 + m2) / m2)).
  set (q := fun k t => v1 t + k * (a1 * b / (a2 * m2))).
  pose proof (almost_and _ _ (almost_no_simple_zero (p 1)) (almost_no_simple_zero (q 1))) as N1.
  pose proof (almost_and _ _ (almost_no_simple_zero (p (-1))) (almost_no_simple_zero (q (-1)))) as N2.
  apply (almost_impl _ _) with (2 := almost_and _ _ (almost_and _ _ N1 N2) (stuck_at _ _ _ _ F)).
  intros t _ (((P1 & Q1) & P2 & Q2) & St) E. destruct (St E) as (a & Dx & D1 & _ & Ld & Bd).
  destruct (Rle_lt_or_eq_dec _ _ Bd) as [|Ed]; [rewrite Ld; auto|].
  assert (exists k, (k = 1 \/ k = -1) /\ m2 * a = k * b) as (k & Hk & Ea).
  { unfold Rabs in Ed. destruct (Rcase_abs (m2 * a)); [exists (-1)|exists 1]; split; auto; lra. }
  assert (Ux : Derive (fun r => x r) t = v1 t) by (apply is_derive_unique, Dx).
  assert (Uv : Derive (fun r => v1 r) t = a) by (apply is_derive_unique, D1).
  assert (Dp : is_derive (p k) t (a2 * v1 t + a1 * a)).
  { unfold p. auto_derive; [repeat split; eexists; eauto|]. rewrite Ux, Uv. ring. }
  assert (Dq : is_derive (q k) t a) by (unfold q; auto_derive; [eexists; eauto|rewrite Uv; ring]).
  assert (Zp : p k t = 0).
  { unfold p. apply Rmult_eq_reg_l with (m2 / (m1 + m2)); [|apply Rgt_not_eq, Rdiv_lt_0_compat; lra].
    transitivity (k * b - load (fun _ => 0) x v1 t); [unfold load, ModeAtContact.load; field; lra|rewrite Ld, Ea; ring]. }
  assert (a2 * v1 t + a1 * a = 0) as Z by (destruct Hk; subst k; [apply P1|apply P2]; auto).
  assert (Zq : q k t = 0).
  { unfold q. apply Rmult_eq_reg_l with a2; [|lra]. rewrite Rmult_0_r, <- Z.
    replace a with (k * b / m2) by (rewrite <- Ea; field; lra). field. lra. }
  assert (a = 0) by (destruct Hk; subst k; [apply Q1|apply Q2]; auto). destruct Hk; subst k; nra.
Qed.

(** [momentum-balance] Every solution of (3), (4) has $m_1\dot v_1+a_1v_1+a_2x_1+m_2\dot v_2=u$ at almost every time:
    the forces between the bodies add up to nothing. *)
Theorem momentum_balance u x v1 v2 : switching u x v1 v2 -> almost (fun t => exists a a' : R,
  is_derive v1 t a /\ is_derive v2 t a' /\ m1 * a + a1 * v1 t + a2 * x t + m2 * a' = u t).
Proof.
  intros H. apply forced_switching_iff in H. destruct H as ((_ & _ & _ & In) & _). revert In. apply almost_impl.
  intros t _ (g & _ & _ & _ & _ & D1 & D2). eexists. eexists. split; [exact D1|]. split; [exact D2|]. field. lra.
Qed.

End Switching.

(** [no-solution-under-control] Case study, $b=0.5$, from rest at 0 under $u=1+50t^2$: (3), (4) have no solution. *)
Theorem no_solution_under_control : ~ exists x v1 v2, switching 1 1 0 200 (1 / 2) (fun t => 1 + 50 * t ^ 2) x v1 v2 /\
  x 0 = 0 /\ v1 0 = 0 /\ v2 0 = 0.
Proof.
  intros (y & w1 & w2 & Sw). set (U := fun t => t + 50 / 3 * t ^ 3). set (u := fun t => 1 + 50 * t ^ 2) in *.
  assert (DU : forall t, is_derive U t (u t)) by (intros t; unfold U, u; auto_derive; auto; field).
  assert (Cu : forall t, continuous u t).
  { intros t. apply (ex_derive_continuous u). unfold u. auto_derive. auto. }
  assert (CU : cont U) by exact (cont_of_derive U _ DU).
  assert (Dx : forall t, is_derive (fun t => t ^ 2 / 4) t (t / 2)) by (intros t; auto_derive; auto; field).
  assert (Dv : forall t, is_derive (fun t => t / 2) t (1 / 2)) by (intros t; auto_derive; auto; field).
  assert (H : forced 1 1 0 200 (1 / 2) U (fun t => t ^ 2 / 4) (fun t => t / 2) (fun t => t / 2) (fun t => t)).
  { constructor; [|intros t _ L; exfalso; lra|intros t _ L; exfalso; lra|auto|exact (cont_of_derive _ _ Dx)|
      exact (cont_of_derive _ _ Dv)|intros t _; apply rderiv_of_derive, Dx| |intros; lra].
    - intros r t Hr. rewrite Rabs_pos_eq; lra.
    - intros t _. apply rderiv_of_derive. unfold U. auto_derive; auto. field. }
  assert (Cu' : cont u) by (apply cont_of_derive with (fun t => 100 * t); intros t; unfold u; auto_derive; auto; ring).
  assert (HU : integral_of u U).
  { split; [apply (ac_of_rderiv U u CU Cu'); intros t _; apply rderiv_of_derive, DU|].
    apply (almost_impl (fun t => 0 < t)); auto using almost_later. }
  destruct (literal_solutions 1 1 0 200 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) u U _ _ _ _ HU
    ltac:(apply (almost_impl (fun t => 0 < t)); auto using almost_later) H) as ((N & _) & _).
  destruct (almost_some _ 1 Rlt_0_1 (N ltac:(exists y, w1, w2; destruct Sw as (S & X & V & W); split; [exact S|lra])))
    as (t & _ & Q). apply Q; [auto|]. unfold ModeAtContact.load, u. rewrite Rabs_pos_eq; field_simplify; lra.
Qed.
