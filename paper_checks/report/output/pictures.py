"""The figures of a report as files, each drawn once, or taken from those kept."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from matplotlib.figure import Figure

from paper_checks.drawing.style import Figures
from paper_checks.report.formats import vector
from paper_checks.report.output.finished import Finished

_SAVED: Mapping[str, Callable[[Figure], bytes]] = {"svg": lambda one: vector.svg(one).encode(), "pdf": vector.pdf}


@dataclass(frozen=True)
class Undrawn:
    """Why a figure was not drawn."""

    why: str


def drawn(figures: Figures, name: str, form: str) -> bytes | Undrawn:
    """Return a figure as `svg` or `pdf`; it is drawn anew for each, as saving it leaves a trace in its layout."""
    if name not in figures:
        return Undrawn(f"the figure {name} is not known")
    try:
        return _SAVED[form](figures[name]())
    except Exception as error:  # noqa: BLE001  one figure's failure must not cost the reader the report
        return Undrawn(f"the figure {name} was not drawn: {type(error).__name__}: {error}")


class Pictures:
    """The figures that a report shows."""

    def __init__(
        self,
        names: Sequence[str],
        figures: Figures,
        complain: Callable[[str], None],
        kept: Finished | None = None,
        fresh: bool = False,
    ) -> None:
        """Take the names of those that are shown, and how all are drawn; `fresh`: none is taken from those kept."""
        self.names, self._figures, self._complain = names, figures, complain
        self._kept, self._fresh = kept, fresh
        self._found: dict[tuple[str, str], bytes | Undrawn] = {}
        self._complaints: set[str] = set()

    def missing(self, form: str) -> list[str]:
        """Return the names of those that have still to be drawn in this form."""
        return [name for name in self.names if self._before(name, form) is None]

    def take(self, name: str, form: str, content: bytes | Undrawn) -> None:
        """Take a figure that was drawn, and keep it; one that was not is told, once."""
        self._found[name, form] = content
        if isinstance(content, bytes):
            if self._kept:
                self._kept.keep_figure(f"{name}.{form}", content)
        elif content.why not in self._complaints:
            self._complaints.add(content.why)
            self._complain(content.why)

    def saved(self, form: str) -> dict[str, bytes]:
        """Return all figures as `svg` or `pdf`, without those that cannot be drawn; what is missing is drawn now."""
        for name in self.missing(form):
            self.take(name, form, drawn(self._figures, name, form))
        return {name: one for name in self.names if isinstance(one := self._found[name, form], bytes)}

    def _before(self, name: str, form: str) -> bytes | Undrawn | None:
        """Return a figure that was drawn before; None where there is none."""
        if (name, form) not in self._found and self._kept and not self._fresh:
            content = self._kept.figure(f"{name}.{form}")
            if content is not None:
                self._found[name, form] = content
        return self._found.get((name, form))
