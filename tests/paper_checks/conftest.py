"""A small ledger with a finding of every verdict, heavy mathematics and hostile texts; the kernel is asked once."""

import pickle
from dataclasses import dataclass, replace
from functools import cache

import pytest
from matplotlib.figure import Figure

from numerics.arithmetic.compiled import _alone
from paper_checks.decide import smt
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.proofs import kernel, library
from paper_checks.proofs.audit import register
from paper_checks.running.graph import proofs
from paper_checks.running.runner import Row

EXACT = Evidence(
    EvidenceKind.EXACT,
    "sympy",
    r"$\frac{d}{dt}\Bigl(\tfrac{1}{2}a_2x_1^2+\tfrac{1}{2}m_1v_1^2+\tfrac{1}{2}m_2v_2^2\Bigr)+b\,|v_1-v_2|=0$",
    True,
    5,
    "left minus right simplifies to 0, and is 0 at 5 test points",
)
SMT = Evidence(
    EvidenceKind.SMT,
    "z3 and cvc5",
    r"$\Phi_+\cdot n_S<0$ on $S_+$",
    True,
    value="negation unsat in both, assumptions alone sat in both",
    assumptions=(r"$x_1>\frac{b(m_1+m_2)}{a_2m_2}$", "$v_1=v_2$"),
)
BALL = Evidence(
    EvidenceKind.ENCLOSURE,
    "python-flint",
    r"the slip ends at $t\in[0.0812,0.0813]$ s",
    True,
    3,
    "0.08127496301884623117390165432890012345678901234567890123456789 +/- 1e-60",
)
SAMPLE = Evidence(EvidenceKind.PROPERTY, "hypothesis", "$w$ never increases", True, 500)
PRINTED = Evidence(EvidenceKind.EXACT, "sympy", "the statement as printed is false", True, value="x_1 = 1, b = 1/2")

LONG = (
    r"As printed the bound $|\ddot{x}_1|<b\,m_2^{-1}$ fails: at $x_1=0.006$, $b=0.5$ the common acceleration is "
    r"$a_2|x_1|/(m_1+m_2)=0.6>0.5=b/m_2$, so that the bodies cannot stick. "
    "The rest of this reason is long, so that the page has to wrap it more than once: it names the branch, the "
    "place, the law under which it fails and the one under which it holds, and what a reader should take from it."
)


@dataclass(frozen=True)
class Decided(Claim):
    """A claim about which this is found, whatever is asked."""

    finding: Finding | None = None

    def decide(self, seed=0, **others):
        return self.finding


def claim(name, recorded=Verdict.HOLDS, section="III", where="after (8)", statement="$E$ decreases."):
    return Decided(name, section, where, statement, recorded)


@pytest.fixture(scope="session", autouse=True)
def the_kernel_is_asked_once(tmp_path_factory, testrun_uid):
    """About all theorems, when a test first needs one; of the processes that test one asks, the others wait."""
    answers, prepare = tmp_path_factory.getbasetemp().parent / testrun_uid, library.prepare

    def prepared(ids, jobs=2):
        missing = [one for one in ids if one not in library._known]
        if missing and not kernel.why_not():
            with _alone(answers.with_suffix(".lock")):
                if not answers.exists():
                    answers.write_bytes(pickle.dumps(library.prove(register(), jobs=jobs)))
            library.know(pickle.loads(answers.read_bytes()))
        return prepare(missing, jobs)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(library, "prepare", prepared)
        yield


ask_once = cache(smt.ask)


@pytest.fixture
def the_solvers_remember(monkeypatch):
    """A solver is asked the same text once."""
    monkeypatch.setattr(smt, "ask", ask_once)


@pytest.fixture(scope="session")
def rows():
    corrected = r"$|\ddot{x}_1|\leqslant b\,m_2^{-1}$ on $S_0$ with $|x_1|\leqslant \frac{b(m_1+m_2)}{a_2m_2}$."
    counter = r"$x_1(0)=0.006$, $b=0.5$: $\ddot{x}_1=-0.6$."
    both = (PRINTED, BALL.as_counterexample(), SMT.as_correction())
    found = [
        Row(
            claim("energy-rate", statement=r"$\dot{E} = -b\,|v_1-v_2|\leqslant 0$ along every trajectory."),
            Finding(Verdict.HOLDS, "An identity.", (EXACT, SMT), figure="sine"),
        ),
        Row(
            claim("example-stiction-never-violated", Verdict.REFUTED, "IV", "after eq. (12)", LONG),
            Finding(Verdict.REFUTED, LONG, both, corrected, counter, "sine"),
            1.25,
        ),
        Row(
            claim("stiction-bracket", Verdict.HOLDS_CORRECTED, "II", "eq. (4)"),
            Finding(Verdict.HOLDS_CORRECTED, LONG, both, corrected, counter),
        ),
        Row(
            claim("rate-one-over-t"),
            Finding(Verdict.UNDECIDED, "Samples only.", (SAMPLE,), figure="lost", missing="a proof of $w\\to 0$"),
        ),
        Row(
            claim("hostile", section="V", where='<script>alert("1")</script> & $x<y$'),
            Finding(Verdict.UNCHECKED, r"<b>100%</b> & \$5 $\foo{x}$ $unpaired #_^~{}\ ẋ ≤", missing="z3 <missing>"),
        ),
    ]
    found = [replace(row, claim=replace(row.claim, finding=row.finding)) for row in found]
    return [replace(row, proofs=proofs(row.claim, row.finding)) for row in found]


def _sine():
    figure = Figure(figsize=(6, 2.5))
    axes = figure.subplots()
    axes.plot([0, 1, 2, 3], [0, 0.8, 0.9, 0.1], label="$v_1$")
    axes.set_xlabel("$t$ in s")
    axes.legend()
    return figure


@pytest.fixture(scope="session")
def figures():
    return dict.fromkeys(("two-bodies", "sine", "sharp-rate"), _sine)
