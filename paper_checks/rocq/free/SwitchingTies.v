(** Ties: equations (3), (4) and (11), (12) of the paper and the load are what `theory/` derives. A test prints each
    expression of the theory and looks for it in the statement. *)
From InertialPair Require Import Dini ModeAtContact Switching CaseStudy.

(** [tie-switching] Equations (3) and (4) of the paper at one time. *)
Theorem tie_switching : forall m1 m2 a1 a2 b (u x v1 v2 : R -> R) t, 0 < m2 -> Switching.switched m1 m2 a1 a2 b u x v1 v2 t <->
  exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\ is_derive v2 t a' /\ (((-1) * (u t)) + (a * (m1 + (m2 * (1 + ((-1) * (Rabs (Switching.sgn ((v1 t) + ((-1) * (v2 t)))))))))) + ((v1 t) * a1) + ((x t) * a2) + (b * (Switching.sgn ((v1 t) + ((-1) * (v2 t)))))) = 0 /\ ((b * (Switching.sgn ((v1 t) + ((-1) * (v2 t))))) + ((-1) * a' * m2) + (a * m2 * (1 + ((-1) * (Switching.sgn (((-1) * b * (/ m2)) + (Rabs a))))) * ((1 / 2) + ((-1 / 2) * (Rabs (Switching.sgn ((v1 t) + ((-1) * (v2 t))))))))) = 0.
Proof. intros m1 m2 a1 a2 b u x v1 v2 t Hm; split; intros (a & a' & X & V & W & E3 & E4); exists a, a'; assert (E1 : ((v1 t) + ((-1) * (v2 t))) = v1 t - v2 t) by ring; assert (E2 : (((-1) * b * (/ m2)) + (Rabs a)) = Rabs a - b / m2) by (field; lra);
  rewrite ?E1, ?E2 in *; repeat (split; [assumption|]); split; lra. Qed.

(** [tie-case-study] Equations (11) and (12) of the paper at one time. *)
Theorem tie_case_study : forall b (x v1 v2 : R -> R) t, CaseStudy.case_study b x v1 v2 t <-> exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\ is_derive v2 t a' /\ a = ((/ ((-2) + (Rabs (Switching.sgn ((v1 t) + ((-1) * (v2 t))))))) * ((200 * (x t)) + (b * (Switching.sgn ((v1 t) + ((-1) * (v2 t))))))) /\ a' = (a + (b * (Switching.sgn ((v1 t) + ((-1) * (v2 t))))) + ((-1) * a * (Rabs (Switching.sgn ((v1 t) + ((-1) * (v2 t))))))).
Proof. intros b x v1 v2 t; assert (E1 : ((v1 t) + ((-1) * (v2 t))) = v1 t - v2 t) by ring; unfold CaseStudy.case_study; rewrite E1;
  assert (N : Rabs (-1) = 1) by (rewrite Rabs_left; lra);
  destruct (Switching.sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S;
  rewrite ?Rabs_R0, ?Rabs_R1, ?N; split; intros (a & a' & X & V & Y & E3 & E4); exists a, a';
  repeat (split; [assumption|]); split; lra. Qed.

(** [tie-load] The load, the friction that a stick needs. *)
Theorem tie_load : forall m1 m2 a1 a2 (u x v1 : R -> R) t, 0 < m1 + m2 -> ModeAtContact.load m1 m2 a1 a2 u x v1 t = ((-1) * m2 * (/ (m1 + m2)) * (((-1) * (u t)) + ((v1 t) * a1) + ((x t) * a2))).
Proof. intros; unfold ModeAtContact.load; field; lra. Qed.
