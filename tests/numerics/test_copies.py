"""What the public functions answer can be pickled, copied and saved, in every arithmetic, to the last bit.

What is no saved trajectory is refused in a sentence.
"""

import copy
import math
import pickle
from fractions import Fraction
from hashlib import sha256

import numpy as np
import pytest
from flint import acb, arb, arb_mat, arb_poly
from hypothesis import example, given
from scene_files import scenes_in
from strategies import balls
from three_scenes import DAMPED, HOW, PAPER, STUCK

import numerics
from numerics import (
    InvalidScene,
    PlaneTrajectory,
    Trajectory,
    load_scene,
    sensitivities,
    solve,
    solve_many,
)
from numerics.arithmetic.ball import Ball
from numerics.errors import InvalidFile

COPIES = [lambda one: pickle.loads(pickle.dumps(one)), copy.copy, copy.deepcopy]
TIMES = [0, "0.1", "1/3", 0.5, 2]
PLANE = load_scene("plane-box")
SURFACES = scenes_in("surfaces")
LINES = [DAMPED, STUCK, load_scene("forced-friction-by-pieces"), load_scene("conveyor").replace(until=1)]
RUNS = [(PAPER, how) for how in HOW] + [(scene, how) for scene in LINES for how in ({}, {"digits": 20})]
RUNS += [(PAPER, {"digits": 20, "t_eval": TIMES}), (PLANE, {"digits": 20})]
RUNS += [
    (SURFACES["two-lines"], {"digits": 12}),
    (SURFACES["two-parts"], {}),
    (SURFACES["isotropic"], {"t_eval": TIMES}),
]


def bits(value):
    """Return what an answer holds, down to the bits of its numbers."""
    if isinstance(value, arb):
        return [part.man_exp() if part.is_finite() else str(part) for part in (value.mid(), value.rad())]
    if isinstance(value, acb):
        return bits([value.real, value.imag])
    if isinstance(value, arb_poly | arb_mat):
        return bits(value.coeffs() if isinstance(value, arb_poly) else value.entries())
    if isinstance(value, list | tuple | np.ndarray):
        return [bits(one) for one in value]
    if isinstance(value, dict):
        return {name: bits(one) for name, one in value.items()}
    return bits(vars(value)) if hasattr(value, "__dict__") and not callable(value) else repr(value)


def same_in_all_copies(answer):
    return all(bits(make(answer)) == bits(answer) and repr(make(answer)) == repr(answer) for make in COPIES)


def answered(run):
    """What a run answers, also when it is looked at later, in bits."""
    with run.context():
        numbers = [run.t, run.y, run.events, run.modes, *map(run.sol, run.t)]
        if isinstance(run, Trajectory):
            numbers += [run.ledger, run.accuracy, run.final, run.y_events, run.segments[0].losses()]
            numbers += [run.units, sensitivities(run.but(t_eval=None), 0)] if run.has_frame else []
        return bits(numbers)


@pytest.mark.parametrize(("scene", "how"), RUNS)
def test_a_run_and_all_that_it_answers_comes_back(scene, how, tmp_path):
    run = solve(scene, **how)
    run.save(tmp_path / "run.npz")
    known = answered(run)
    for again in (type(run).load(tmp_path / "run.npz"), *(make(run) for make in COPIES)):
        assert again == run
        assert (repr(again), again.scene, again.tried) == (repr(run), scene, run.tried)
        assert answered(again) == known
    assert same_in_all_copies(run.events)
    assert solve(scene, **how) == run != solve(scene, arithmetic="ball", digits=13)
    assert [path.name for path in tmp_path.iterdir()] == ["run.npz"]


ANSWERS = """
thresholds(PAPER.pair, omega=7)
response(DAMPED, amplitude=3, omega=7)
response(DAMPED, amplitude="0.1", omega=7)
fastest_transfer(load_scene("at-rest"), "0.01")
cheapest_transfer(load_scene("at-rest"), "0.001", "0.2")
damping(load_scene("at-rest"), "0.001")
track(load_scene("at-rest"), load_reference("s-curve"))
ring_entry(PAPER, radius="0.001")
sensitivities(solve(PAPER.replace(until="0.1"), digits=40))
solve_scenes([PLANE], jobs=1, keep_events=2)
"""


@pytest.mark.parametrize("asked", ANSWERS.strip().splitlines())
def test_answers_of_control_and_batches(asked):
    assert same_in_all_copies(eval(asked, {**{name: getattr(numerics, name) for name in dir(numerics)}, **globals()}))


def test_a_batch_answers_as_before():
    batch = solve_many(1, 1, 200, 0.5, v1=[0.1, 0.2], until=1, keep_events=2)
    assert [bits(make(batch).results) for make in COPIES] == [bits(batch.results)] * 3


def test_a_scene_that_no_file_holds_is_compared_and_pickled_all_the_same():
    run = solve(SURFACES["isotropic"].replace(v1=[Fraction(6, 100) + Fraction(1, 7**1500), "0.01"]))
    assert pickle.loads(pickle.dumps(run)) == run
    with pytest.raises(InvalidScene, match="at most 1000 are read"):
        run.save("run.npz")


@given(balls())
@example(arb(0))
@example(arb(1, 2.0**-2000))
@example(arb("0.1"))
@example(arb(math.inf))
@example(arb(-3, math.inf))
@example(arb("nan"))
def test_every_ball_at_whatever_precision_is_set(ball):
    wide = [ball, acb(ball, 1), arb_poly([1, ball]), arb_mat([[ball, 2]])]
    for digits in (1, 100):
        with Ball(digits).context():
            assert all(bits(make(wide)) == bits(wide) for make in COPIES)


# what is no saved trajectory


WRITTEN = [
    b"[" * 200_000,
    b"{}",
    b"7",
    b"\xff\xfe",
    b'{"format": "inertial-pair trajectory 6"}',
    b'{"ratio": ["0x1", "0x0"]}',
]


@pytest.mark.parametrize("scene", [PAPER, PLANE])
def test_a_file_with_another_header_is_refused_in_a_sentence(tmp_path, scene):
    """Also with a digest that fits, as of another program."""
    path, run = tmp_path / "run.npz", solve(scene)
    run.save(path)
    with np.load(path) as archive:
        right, digest = archive["header"].tobytes(), archive["digest"].tobytes()
    changed = right.replace(b"0x1", b"0x3", 1) if scene is PLANE else right.replace(b'"A', b'"B', 1)
    for wrong in [*WRITTEN, changed]:
        for its in {digest, digest if wrong is changed else sha256(wrong).digest()}:
            np.savez_compressed(
                path, **{name: np.frombuffer(one, np.uint8) for name, one in (("header", wrong), ("digest", its))}
            )
            with pytest.raises(InvalidFile, match=r"holds no saved trajectory.*; give a file that `save`") as found:
                type(run).load(path)
            assert "\n" not in str(found.value), wrong


@pytest.mark.parametrize("scene", [PAPER, PLANE])
def test_a_file_in_which_a_byte_was_changed_or_is_missing_is_refused_or_holds_the_same_run(tmp_path, scene):
    path, other = tmp_path / "run.npz", tmp_path / "other.npz"
    run = solve(scene, max_events=2)
    run.save(path)
    whole = path.read_bytes()
    changed = [whole[:k] + bytes([whole[k] ^ 8]) + whole[k + 1 :] for k in range(0, len(whole), 1 + len(whole) // 200)]
    missing, count = [whole[:k] for k in range(0, len(whole), 1 + len(whole) // 60)], 0
    for wrong in changed + missing:
        other.write_bytes(wrong)
        try:
            assert type(run).load(other) == run  # of what the archive says twice, once may be changed
        except InvalidFile:
            count += 1
    assert count > len(changed) // 2


@pytest.mark.parametrize(
    ("write", "kind", "said"),
    [
        (lambda file: solve(PAPER).save(file), PlaneTrajectory, "a run on a line, which Trajectory.load reads"),
        (lambda file: solve(PLANE).save(file), Trajectory, "a run on a surface, which PlaneTrajectory.load reads"),
        (lambda file: file.write_bytes(b""), Trajectory, "it is empty"),
        (lambda file: file.write_text("t,x1\n", encoding="utf-8"), Trajectory, "no npz archive"),
        (lambda file: np.savez(file, t=np.zeros(3)), Trajectory, "archive of plain arrays, as of --npz"),
        (lambda file: np.savez(file, header=np.array([{}], dtype=object)), Trajectory, "trajectory"),  # a pickle
        (lambda _: None, Trajectory, "give a file that `save`"),
    ],
)
def test_what_else_a_file_is_is_said(tmp_path, write, kind, said):
    write(file := tmp_path / "run.npz")
    with pytest.raises((InvalidFile, FileNotFoundError), match=said):
        kind.load(file)
