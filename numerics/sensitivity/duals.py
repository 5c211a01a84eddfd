"""How dual numbers tell the texts: values by the base's own ways, gradients from the equation that is solved."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from flint import arb

from numerics.arithmetic import float64
from numerics.arithmetic.dual import Dual
from numerics.arithmetic.dual_number import DualNumber, linear, weighted_sum
from numerics.arithmetic.dual_words import dual_words
from numerics.arithmetic.protocol import Arithmetic
from numerics.arithmetic.telling import Telling, text_of
from numerics.arithmetic.words import words_of
from numerics.contact.root import root, root_of
from numerics.contact.surface import Contact, contact
from numerics.flows import oscillator
from numerics.flows.slip import Variables, slid_at
from numerics.motion import seen, undamped
from numerics.motion.tellings import motion_telling
from numerics.sensitivity import gradients


def dual(base: Arithmetic) -> Dual:
    """Return the dual numbers over an arithmetic."""
    return Dual(base, _dual_telling(base.telling))


@cache
def _dual_telling(base: Telling) -> Telling:
    motions = motion_telling(base, is_damped=False)
    words = dual_words(base.words or words_of(float64))
    formulas = Telling(f"formulas of dual {base.name}", words, words_of(float64))
    instead = {
        contact: _contact(motions(contact), words),
        root: lambda pair: _root(motions, pair),
        slid_at: _slid(motions(slid_at), formulas(slid_at)),
        oscillator.smooth_in_damping: _basis(words),
        undamped.ray_landing: _landing(motions),
        seen.seen_ray_landing: gradients.ray_landing,
        seen.seen_landing: gradients.landing,
        seen.seen_on_ray: gradients.on_ray,
        seen.seen_exit_time: gradients.exit_time,
        seen.seen_excess_at_exit: gradients.excess_at_exit,
        seen.seen_flow: gradients.flow,
        undamped.velocity: gradients.velocity,
    }
    return Telling(f"dual {base.name}", words, words_of(float64), instead)


def values(record: Any) -> Any:
    """Return a record with the values in the place of dual numbers."""
    if isinstance(record, DualNumber):
        return record.value
    return type(record)(*map(values, record)) if isinstance(record, tuple) else record


def _landing(motions: Telling) -> Callable[[Any, Any], undamped.Landing]:
    """Return the end of a slip from an exit ray as the base has it, without gradients yet."""

    def dual_ray_landing(pair: Any, start: Any) -> undamped.Landing:
        found = motions(undamped.ray_landing)(values(pair), values(start))
        theta, gap, slid, w, versine = map(DualNumber, found[:-1])
        return undamped.Landing(theta, gap, slid, w, versine, found.spared)

    return dual_ray_landing


def _contact(found: Callable[..., Contact], words: dict[str, Any]) -> Callable[[DualNumber, DualNumber], Contact]:
    """Return the end of a slip from S: dtheta = (du (1 - cos) + dd sin)/(c + d), dc = h dtheta."""

    def dual_contact(gap: DualNumber, push: DualNumber) -> Contact:
        theta, depth, versine = found(gap.value, push.value)
        sine = words["sin"](DualNumber(theta)).value
        rise = ((theta * theta + depth * depth) / 2 - depth) / theta  # c' = h (contact/surface.py)
        gradient = weighted_sum((push.gradient, versine), (gap.gradient, sine))
        angle = DualNumber(theta, None if gradient is None else gradient / (depth + gap.value))
        one = [DualNumber(value, weighted_sum((angle.gradient, by))) for value, by in ((depth, rise), (versine, sine))]
        return Contact(angle, *one)

    return dual_contact


def _root(motions: Telling, pair: Any) -> Callable[..., DualNumber]:
    """Return the root that the base finds; its derivatives follow from those of the function at a fixed argument.

    The ends of the bracket do not count: the root is the same for all that hold it.
    """
    search = motions(root_of(text_of(pair), "root_of_values"))

    def dual_root(at: Any, lower: DualNumber, upper: DualNumber, guess: DualNumber) -> DualNumber:
        x = search(values(at), lower.value, upper.value, guess.value)
        value, slope = pair(at, DualNumber(x))
        return DualNumber(x, None if value.gradient is None else value.gradient / -slope.value)

    return dual_root


def _slid(
    found: Callable[..., Any], formula: Callable[..., DualNumber]
) -> Callable[[Variables, DualNumber], DualNumber]:
    """Return K as the base has it, with the gradient of its formula."""

    def dual_slid(at: Variables, theta: DualNumber) -> DualNumber:
        return DualNumber(found(values(at), theta.value), formula(at, theta).gradient)

    return dual_slid


def _basis(words: dict[str, Any]) -> Callable[..., tuple[DualNumber, DualNumber]]:
    """Return e^(-dt) (cos nt, sin(nt)/n) as functions of d, t and n^2 = k - d^2, smooth through critical damping."""

    def basis(of: Any, t: DualNumber, found: tuple[DualNumber, DualNumber]) -> tuple[DualNumber, DualNumber]:
        cosine, sine = (DualNumber(one.value) for one in found)
        decay, squared = of.decay, of.stiffness - of.decay * of.decay
        signed = of.regime * of.frequency * of.frequency
        by_square = _sine_by_square(of, t, (cosine, sine), words)
        return (
            linear(cosine, (-t * cosine, decay), (-t * sine / 2, squared), (-decay * cosine - signed * sine, t)),
            linear(sine, (-t * sine, decay), (by_square, squared), (cosine - decay * sine, t)),
        )

    return basis


def _sine_by_square(of: Any, t: DualNumber, found: tuple[DualNumber, DualNumber], words: dict[str, Any]) -> DualNumber:
    """Return the derivative of e^(-dt) sin(nt)/n with respect to n^2, (t cos - sin/n)/(2 n^2), next to n = 0 by series.

    It is -t^3 (1/3! - 2 z/5! + 3 z^2/7! - ...) with z = n^2 t^2.
    """
    (cosine, sine), squared = found, of.regime * of.frequency * of.frequency
    z = DualNumber((squared * t * t).value)
    if of.regime and abs(words["rough"](z)) > 1:
        return (t * cosine - sine) / (2 * squared)
    total = term = words["exactly"](1.0) / 6
    enough, j = words["tolerance"]() / 2**40, 1
    while of.regime and words["size"](term.value) > enough:
        j += 1
        term = -term * z * j / ((j - 1) * 2 * j * (2 * j + 1))
        total = total + term
    if of.regime and isinstance(term.value, arb):
        total = total + DualNumber(term.value.union(-term.value))  # what is left out is less than the last term
    return -t * t * t * total * words["exp"](-of.decay * t)
