"""How dual numbers tell the texts: values by the base's own ways, gradients from the equation that is solved."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
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
from numerics.flows import forced_sine, oscillator
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
        forced_sine.faded_turn: _faded_turn(base(forced_sine.faded_turn), words),
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


def unit(index: int, count: int) -> Any:
    """Return a unit vector of exact numbers."""
    return np.array([Fraction(int(k == index)) for k in range(count)], dtype=object)


def frozen(kind: type[Any], **values: Any) -> Any:
    """Return a frozen record of what its constructor would not read: dual numbers in the place of exact ones."""
    record: Any = object.__new__(kind)
    for name, value in values.items():
        object.__setattr__(record, name, value)
    return record


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
    while of.regime and words["size"](term) > enough:
        j += 1
        term = -term * z * j / ((j - 1) * 2 * j * (2 * j + 1))
        total = total + term
    if of.regime and isinstance(term.value, arb):
        total = total + DualNumber(term.value.union(-term.value))  # what is left out is less than the last term
    return -t * t * t * total * words["exp"](-of.decay * t)


def _faded_turn(
    found: Callable[..., tuple[Any, Any]], words: dict[str, Any]
) -> Callable[..., tuple[DualNumber, DualNumber]]:
    """Return F = (1 - e^(-z tau))/z of z = decay + i omega as the base has it: dF = F' dz + e^(-z tau) dtau."""

    def faded_turn(decay: DualNumber, omega: DualNumber, tau: DualNumber) -> tuple[DualNumber, DualNumber]:
        fixed = DualNumber(decay.value), DualNumber(omega.value), DualNumber(tau.value)
        re, im = map(DualNumber, found(decay.value, omega.value, tau.value))
        sine, cosine = words["sine_cosine"](fixed[1] * fixed[2])
        left = words["exp"](-fixed[0] * fixed[2])
        turned = left * cosine, -left * sine
        by_re, by_im = _turn_by_rate(*fixed, (re, im), turned, words)
        return (
            linear(re, (by_re, decay), (-by_im, omega), (turned[0], tau)),
            linear(im, (by_im, decay), (by_re, omega), (turned[1], tau)),
        )

    return faded_turn


def _turn_by_rate(
    decay: DualNumber, omega: DualNumber, tau: DualNumber, turn: Any, turned: Any, words: dict[str, Any]
) -> tuple[DualNumber, DualNumber]:
    """Return F' = (tau e^(-y) - F)/z, y = z tau; next to z = 0 by the series -tau^2 sum_k (k+1) (-y)^k/(k+2)!."""
    y, rough = (decay * tau, omega * tau), words["rough"]
    if math.hypot(rough(y[0]), rough(y[1])) > 1:
        square = decay * decay + omega * omega
        re, im = (tau * one - two for one, two in zip(turned, turn, strict=True))
        return (re * decay + im * omega) / square, (im * decay - re * omega) / square
    re, im = words["exactly"](1.0) / 2, words["exactly"](0.0)
    sums, enough, k = (re, im), words["tolerance"]() / 2**40, 0
    while words["size"](re) > enough or words["size"](im) > enough:
        k += 1
        factor = (k + 1) * words["exactly"](1.0) / (k * (k + 2))  # of the terms (k + 1) (-y)^k/(k + 2)!
        re, im = -(re * y[0] - im * y[1]) * factor, -(re * y[1] + im * y[0]) * factor
        sums = sums[0] + re, sums[1] + im
    if isinstance(re.value, arb):  # what is left out is less than the last term
        rest = abs(re.value) + abs(im.value)
        sums = sums[0] + DualNumber(rest.union(-rest)), sums[1] + DualNumber(rest.union(-rest))
    return -tau * tau * sums[0], -tau * tau * sums[1]
