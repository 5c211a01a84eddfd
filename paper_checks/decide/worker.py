"""One SMT solver in a process of its own, so that a time limit holds even where the solver's own does not.

Each line on stdin is JSON, `{"texts": [SMT-LIB 2 text, ...], "seconds": limit for each}`, and is answered by a line on
stdout, `{"answers": ["sat" | "unsat" | "unknown", ...], "model": of the last text}`; it ends with its stdin. Run as
`python -P worker.py z3` (or `cvc5`), by its file: it needs nothing of the package.
"""

from __future__ import annotations

import json
import signal
import sys
from fractions import Fraction
from functools import cache


def ask_z3(text: str, seconds: float) -> tuple[str, str]:
    """Return z3's answer and, where it is sat, its model."""
    import z3

    context = z3.Context()  # its own, so that no earlier question bears on the answer
    # the one tactic for these theories, without the others' setup
    solver = z3.Tactic("qfnra-nlsat", ctx=context).solver()
    solver.set("timeout", int(1000 * seconds))
    solver.from_string(text)
    answer = str(solver.check())
    return answer, _model(solver.model(), z3.RatNumRef) if answer == "sat" else ""


def _model(model: object, rational: type) -> str:
    """Return `name = value` in the order of names, rational values exactly, algebraic ones to 20 decimals."""
    values = {declaration.name(): model[declaration] for declaration in model.decls()}  # type: ignore[attr-defined, index]
    texts = {
        name: str(Fraction(str(number))) if isinstance(number, rational) else number.as_decimal(20)
        for name, number in values.items()
    }
    return ", ".join(f"{name} = {texts[name]}" for name in sorted(texts)) or "every value"


def ask_cvc5(text: str, seconds: float) -> tuple[str, str]:
    """Return cvc5's answer; its models are not asked for. Raises ValueError where it refuses the text."""
    import cvc5

    solver = cvc5.Solver(cvc5.TermManager())
    solver.setOption("tlimit-per", str(int(1000 * seconds)))
    solver.setOption("nl-ext", "none")  # coverings alone decide these theories, in half the time
    solver.setOption("nl-cov", "true")
    parser = cvc5.InputParser(solver)
    parser.setStringInput(cvc5.InputLanguage.SMT_LIB_2_6, text, "statement")
    symbols = parser.getSymbolManager()
    while not (command := parser.nextCommand()).isNull():
        if complaint := str(command.invoke(solver, symbols)).strip():
            raise ValueError(complaint)
    result = solver.checkSat()
    return ("sat" if result.isSat() else "unsat" if result.isUnsat() else "unknown"), ""


SOLVERS = {"z3": ask_z3, "cvc5": ask_cvc5}


def main(name: str) -> None:
    """Answer the questions on stdin, one line each."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C reaches the whole group: end without a word
    if hasattr(signal, "pthread_sigmask"):  # what started this one may not hear it
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    answered = cache(SOLVERS[name])  # the same text, of which every third is, has the same answer
    for line in sys.stdin:
        question = json.loads(line)
        results = [answered(text, question["seconds"]) for text in question["texts"]]
        print(json.dumps({"answers": [answer for answer, _ in results], "model": results[-1][1]}), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
