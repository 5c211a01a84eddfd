"""Sentences of the paper that are quoted and not judged: opinions, plans, and statements about the literature.

No computation or proof settles them. With these, every sentence of the paper that asserts something has a claim.
"""

from paper_checks.claims.words import *


def quoted(id: str, section: str, where: str, said: str, why: str) -> Claim:
    """Return a claim that is not judged, with the reason."""
    return Claim(id, section, where, said, NOT_JUDGED, case=lambda: because(why))


LITERATURE = (
    "It is a statement about what others have published or do in practice, which no check of the model can settle."
)

IMPORTANCE = quoted(
    "importance-of-the-problem",
    "Abstract",
    "abstract, first sentence; I, first paragraph",
    r"""
    Understanding the dynamics of two inertial bodies coupled via a friction interface is essential for a wide range
    of systems and motion control applications; adhesion and continuous sliding are both essential for modeling a
    frictional interface; such interactions deserve attention due to their theoretical and practical relevance.
    """,
    "How much a problem matters is an opinion.",
)
UNDERSTUDIED = quoted(
    "understudied-in-the-past",
    "Abstract",
    "abstract, second sentence; I, first paragraph",
    """
    The coupling terms within the dynamics of an inertial pair connected via a passive frictional contact are
    non-trivial and have long remained understudied in system communities; to the best of the authors' knowledge such
    interactions have been less studied in the past.
    """,
    LITERATURE,
)
CHALLENGING = quoted(
    "modeling-is-challenging",
    "Abstract",
    "abstract, third sentence; I, first paragraph",
    """
    The problem is particularly challenging from a point of view of modeling the interaction forces and motion state
    variables; a pass over from contact surfaces to a lumped parameter modeling of inertial pairs is not trivial.
    """,
    "How difficult a task is, is an opinion.",
)
STUDIED = quoted(
    "friction-processes-studied",
    "I",
    "first paragraph",
    """
    Dynamic transitions in friction processes, from attachment-detachment cycles to stick-slip and then continuous
    sliding, have been intensively studied on a physical level in tribology and material science, from the nano- to the
    meso-scale.
    """,
    LITERATURE,
)
EVOKED = quoted(
    "friction-as-evoked-damping",
    "I",
    "first paragraph",
    """
    In earlier control related studies kinetic friction usually occurred as an evoked source of damping during the
    forced motion, with the motion variables as the source and the friction force as the consequence; this paradigm is
    independent of the level of detail of the friction modeling.
    """,
    f"{LITERATURE} That friction opposes the relative velocity is judged in friction-opposes-displacement.",
)
CAUSE = quoted(
    "friction-as-cause",
    "I",
    "first paragraph",
    """
    A contact that joins two moving bodies requires a causal relationship with the generalized frictional force as the
    source and the relative displacement as the result.
    """,
    """
    The equations (3), (4) relate force and acceleration at the same time and single out no cause. That body 2 is moved
    by friction alone is judged in one-active-one-passive.
    """,
)
APPLICATIONS = quoted(
    "common-in-manufacturing",
    "I",
    "second paragraph",
    """
    A typical example is a periodic motion of the target body put on a driven surface; such controlled motion is
    exceedingly common on conveyor lines and turntables, in material flow, surface treatment, the preparation of mixed
    substances and robot handling of free objects.
    """,
    LITERATURE,
)
UNDERSTOOD = quoted(
    "rigid-bodies-understood",
    "I",
    "paragraph after Fig. 1",
    """
    Control of a periodic motion is sufficiently well understood for rigid bodies and for multi-body systems with
    elasticities, although non-trivial reference trajectories and disturbances can pose serious challenges.
    """,
    LITERATURE,
)
ADEQUATE = quoted(
    "coulomb-law-is-sufficient",
    "I",
    "third paragraph; II, second paragraph after Fig. 2",
    """
    Effects of the Prandtl-Tomlinson type, the Stribeck effect and presliding are left out to maintain an adequate
    complexity; detailed dynamic friction models have been studied extensively, and yet the basic Coulomb law is often
    sufficient for modeling purposes.
    """,
    """
    Whether a model is sufficient depends on the purpose and on measurements, of which the paper has none. What static
    friction above kinetic would change is in static-friction-stops-creeping.
    """,
)
HISTORY = quoted(
    "history-of-friction-laws",
    "I",
    "third paragraph",
    "Several interesting historical aspects of the Coulomb law and of Stribeck curves can be found in the references.",
    LITERATURE,
)
SECONDARY = quoted(
    "secondary-as-damping",
    "I",
    "third paragraph",
    """
    Coulomb friction would become secondary to the analysis if it only acted as a nonlinear damping and sticking
    element in an active system with feedback control.
    """,
    "What is secondary to an analysis is its authors' choice.",
)
NOTATION = quoted(
    "most-general-notation",
    "I",
    "last paragraph; II, after Fig. 2",
    """
    Equations (2)–(4) and Fig. 2 provide the most general notation of the overall system dynamics; a relative motion
    with one spatial degree of freedom is the single restriction.
    """,
    """
    No class of systems is stated in which this would be "most general". What (3), (4) mean is judged claim by claim;
    motions with more degrees of freedom are in motions-on-a-surface.
    """,
)
FAVOUR = quoted(
    "in-favour-of-analysis",
    "II",
    "after eq. (4)",
    "Inclusion of the switching conditions into (3), (4) comes in favor of their analysis.",
    """
    Which form of equations is convenient is an opinion. That (3), (4) have well-defined solutions, which the sentence
    says too, is judged in sgn-three-valued.
    """,
)
SUITED = quoted(
    "sliding-modes-well-suited",
    "III",
    "second footnote",
    "Sliding modes are well suited for analyzing dynamical systems with Coulomb friction and feedback controls.",
    "How well a method suits a class of problems is an opinion, and the sentence refers to the literature for it.",
)
TRANSPARENT = quoted(
    "transparent-view",
    "V",
    "first paragraph",
    """
    The framework, analysis and examples provide a transparent systems- and control-oriented view of how the friction
    interface of an inertial pair couples interacting forces and motion variables.
    """,
    "It is the authors' opinion of their own presentation.",
)
TRIBOLOGY = quoted(
    "surface-friction-is-nontrivial",
    "V",
    "fifth bullet",
    """
    The extension to a surface requires careful modeling because the coupling terms of friction on a surface are
    non-trivial from the tribological viewpoint.
    """,
    "How much care is needed is an opinion. What changes on a surface is judged in motions-on-a-surface.",
)
EFFICIENT = quoted(
    "efficient-control-is-challenging",
    "V",
    "sixth bullet; III, opening paragraph",
    """
    Energy- and performance-efficient control of friction-coupled systems (2)–(4) is expected to be challenging; various
    cases of $u\\neq 0$, and a case study with application-motivated controls, will be the subject of future works.
    """,
    "It is an expectation and a plan. What a force can do is in trackable-references, minimum-transfer-time and cheapest-transfer.",
)
