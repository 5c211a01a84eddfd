"""The advice says what the record says: planted records in which a peer wins, a sequence is wrong, numba is missing."""

from __future__ import annotations

from dataclasses import replace

import pytest
from planted_trades import COMPILED, EULER_FIGURE, PLAIN, READ, SCENES, our_runs, planted, run

from numerics.scene.file import load_scene
from numerics.trade import euler
from numerics.trade.comparisons.euler_peer import read
from numerics.trade.comparisons.forward_euler import forward_euler
from numerics.trade.comparisons.switching import SwitchedPair
from numerics.trade.euler import EulerFigure, StickEnergy
from numerics.trade.interface import Wait
from numerics.trade.ours import TWELVE
from paper_checks.report.content.blocks import Section, Table
from paper_checks.report.formats.markdown import markdown
from paper_checks.speed import euler_figures, in_short, misleading, needs, payoff, peers, section


def said(found) -> str:
    """Return blocks as one text."""
    return markdown(Section("x", "x", tuple(found)))


@pytest.fixture
def plain_trade(tmp_path):
    return planted(tmp_path)


class TestNeeds:
    def test_the_cheapest_that_is_right_everywhere_is_chosen(self, plain_trade):
        rows = needs.choices(plain_trade)
        assert [need for need, _ in rows] == [14, 20, 100]
        names = [[choice.name for choice in row.values()] for _, row in rows]
        assert names == [[READ] * 2, ["ball, 10 digits"] * 2, ["ball, 100 digits"] * 2]

    def test_a_method_that_is_wrong_on_one_scene_is_not_chosen_for_its_kind(self, tmp_path):
        runs = [one for one in our_runs() if (one["contender"], one["scene"]) != (READ, SCENES[0])]
        wrong = run(READ, SCENES[0], 5e-4, -14.5, right=False, difference="1 event, not 2")
        rows = needs.choices(planted(tmp_path, wrong, runs=runs))
        assert [choice.name for choice in rows[0][1].values()] == ["ball, 10 digits", READ]

    def test_without_numba_the_gap_is_named(self, tmp_path):
        left_out = [{"contender": COMPILED, "missing": "numba"}]
        trade = planted(tmp_path, runs=our_runs(compiled=False), left_out=left_out)
        assert "The compiled path was not measured: it needs numba." in said(payoff.payoff(trade))
        assert f"Left out, as not installed: {COMPILED} (needs numba)." in said(section.provenance(trade))

    def test_a_contender_that_did_not_exist_before_takes_its_place(self, tmp_path):
        more = [run(TWELVE, scene, 6e-4, -28.5) for scene in SCENES]
        names = {choice.name for choice in needs.choices(planted(tmp_path, *more))[1][1].values()}
        assert names == {TWELVE}

    def test_mpmath_is_compared_at_the_same_digits(self, plain_trade):
        assert "at 10 digits it takes 10 times as long" in said(needs.needs(plain_trade))

    def test_float64s_bounds_stand_beside_what_was_measured(self, plain_trade):
        (table,) = [one for one in needs.float64_is_enough(plain_trade) if isinstance(one, Table)]
        assert [row[0] for row in table.rows] == list(SCENES)
        assert all(int(bound) <= 16 and measured == "14" for _, _, bound, measured in table.rows)
        assert all(int(each) > 5 for _, each, *_ in table.rows[:2])

    def test_a_scene_that_nobody_knows_has_no_bounds(self):
        assert needs.bounded("a scene of tomorrow") is None
        assert needs.bounded("long-many") is None

    def test_the_price_of_a_digit_is_a_slope(self, plain_trade):
        text = said(needs.price_of_digits(plain_trade))
        assert "50 µs at 10 digits and 400 µs at 1,000: 354 ns for each further digit" in text
        assert "| 10 | 250 ns | 50 µs (200) |" in text


class TestPayoff:
    def test_compiling_is_paid_back_after_its_time_by_the_gain(self, plain_trade):
        text = said(payoff.payoff(plain_trade))
        assert "75 times as long" in text
        assert "500 ms: that is paid back after 1,690 such solves" in text

    def test_compiling_that_does_not_pay_is_said(self, tmp_path):
        runs = [one | ({"seconds": 1.0} if one["contender"] == COMPILED else {}) for one in our_runs()]
        assert "Compiling does not pay there." in said(payoff.payoff(planted(tmp_path, runs=runs)))

    def test_a_batch_pays_from_where_it_undercuts_a_loop(self, plain_trade):
        text = said(payoff.payoff(plain_trade))
        assert "From 100 scenes on `solve_many` undercuts" in text
        assert "62.5 times less than `solve(scene)`" in text
        assert "On 2 cores a batch of 100 scenes goes 2 times as fast as on one." in text

    def test_growth_is_told_for_events_and_masses(self, plain_trade):
        assert f"| {PLAIN} | 10 µs (20 events) | 20 µs (200 events) | 3 times |" in said(payoff.payoff(plain_trade))

    def test_a_trade_without_growth_says_nothing_of_it(self, tmp_path):
        trade = planted(tmp_path, growth=[])
        assert not list(payoff.payoff(trade))[1:]
        assert list(needs.price_of_digits(trade)) == []
        assert list(section.figures(trade)) == ["work-precision"]


class TestPeers:
    def test_a_lead_is_told_with_its_closest_peer(self, tmp_path):
        slow, close = (run("Slow", "velocities", 1.0, -5.0), run("Close", "velocities", 1e-3, -3.0))
        text = said(peers.leading(planted(tmp_path, slow, close)))
        assert "No peer with the right events beats ours at equal or better accuracy on any scene." in text
        assert "Close on velocities: ours is 2 times as fast." in text
        assert "| 2 | 250 | 2 to 2,000 |" in text

    def test_a_peer_that_wins_is_said_to(self, tmp_path):
        winner = run("Winner", "velocities", 1e-3, -16.0)
        text = said(peers.leading(planted(tmp_path, winner)))
        assert "On velocities Winner (16 digits, 1 ms) beats ours: it is 2 times as fast as ball, 10 digits." in text
        assert "No peer with" not in text

    def test_a_peer_that_is_more_accurate_than_all_of_ours_is_said_to_be(self, tmp_path):
        text = said(peers.leading(planted(tmp_path, run("Exact", "velocities", 9.0, -500.0))))
        assert "On velocities no run of ours is as accurate as Exact (500 digits, 9 s)." in text

    def test_a_wrong_peer_wins_nothing(self, tmp_path):
        wrong = run("Wrong", "velocities", 1e-9, -500.0, right=False, difference="1 event, not 24")
        text = said(peers.leading(planted(tmp_path, wrong)))
        assert "beats ours:" not in text
        assert "| velocities | none is right |" in text

    def test_without_peers_nothing_is_claimed(self, plain_trade):
        assert "nothing can be said about others" in said(peers.leading(plain_trade))

    def test_who_is_right_where(self, tmp_path):
        half = [run("Half", "velocities", 1e-3, -3.0, setting=1e-3)]
        half += [run("Half", "velocities", 1e-4, -1.0, setting=1e-2, right=False, difference="1 event, not 24")]
        hung = run("Hung", "velocities", None)
        text = said(peers.sequences(planted(tmp_path, *half, hung)))
        assert "| Half | 1/2: 3 | – | – |" in text
        assert "| Hung | stopped | – | – |" in text
        assert "Ours have the right event sequence in all 18 runs." in text

    def test_a_wrong_sequence_of_ours_is_confessed(self, tmp_path):
        wrong = run(READ, "velocities", 1e-3, -1.0, setting=1.0, right=False, difference="23 events, not 24")
        text = said(peers.sequences(planted(tmp_path, wrong)))
        assert f"Ours are wrong in 1 run of 19: {READ} on velocities (23 events, not 24)." in text


class TestForwardEuler:
    def test_energy_that_departs_from_theory_is_named(self):
        fits, departs = StickEnergy(1e-2, 5.0, 2.0, 2.0, None, 5), StickEnergy(1e-3, 5.0, 2.0, 2.1, 1.5, 50)
        text = said(misleading.forward_euler([EULER_FIGURE], [fits, departs]))
        assert "to 8 digits, but not with steps of $10^{-3}$ s." in text
        assert "at first differ by $10^{-9}$ m/s it chatters" in text
        assert "between 1.50000 and 1.50000" in text
        assert "slips out" in text
        shorter = said(misleading.forward_euler([], [replace(fits, until=2.5)]))
        assert "$E(2.5)/E(0)$ in chatter" in shorter
        assert "stuck for 2.5 s" in shorter
        assert "in every run below" in said(misleading.forward_euler([EULER_FIGURE], [fits]))

    def test_steps_and_chatter_are_those_of_the_runs(self):
        text = said(misleading.forward_euler([EULER_FIGURE], []))
        assert (
            "| Fig. 9 | 7 in 2 s | $10^{-3}$ | about $3.2\\cdot10^{-4}$ | about $3.2\\cdot10^{-5}$ | $3\\cdot10^{-2}$ |"
            in text
        )
        assert "| Fig. 9 | 0 × | 40 |" in text
        assert "Runs that never chatter have missed every phase of stick: Fig. 9 up to $10^{-2}$ s." in text
        assert "Finer steps give more chatter" in text

    def test_chatter_that_does_not_grow_is_not_said_to(self):
        figure = EulerFigure("9", 7, 2.0, tuple(reversed(EULER_FIGURE.outcomes)))
        assert "Finer steps" not in said(misleading.forward_euler([figure], []))


class TestInShort:
    def short(self, trade) -> str:
        return said(in_short.in_short(trade, [EULER_FIGURE], [StickEnergy(1e-2, 5.0, 2.0, 2.0, None, 5)]))

    def test_it_names_the_arithmetics_in_their_order(self, plain_trade):
        text = self.short(plain_trade)
        assert "warm and with its answer read" in text
        assert f"on the one scene relative-motion-b05: {READ} up to 14 (500 µs) and ball up to 100 (3 ms)." in text
        assert "peer" not in text

    def test_it_says_what_a_user_waits_for_and_what_runs_inside(self, tmp_path, plain_trade):
        assert "on relative-motion-b05: with times, states and itinerary read 500 µs; the run inside takes 4 µs." in (
            self.short(plain_trade)
        )
        assert "This record does not say" in said(section.waiting(plain_trade))
        waits = [Wait("the run inside", 5e-6), Wait("solve(scene)", 2e-5, "the run inside", 4.0, 6.0)]
        trade = planted(tmp_path, interface=[one.as_record() for one in waits])
        assert "`solve(scene)` takes 20 µs, with times, states and itinerary read 500 µs;" in self.short(trade)
        assert "| `solve(scene)` | 20 µs | 4 times the run inside | ≤ 6 ×: kept |" in said(section.waiting(trade))

    def test_a_lead_counts_only_scenes_where_nobody_beats_ours(self, tmp_path):
        winner, loser = run("A", "velocities", 1e-3, -16.0), run("B", "relative-motion-b05", 1e-3, -12.0)
        text = self.short(planted(tmp_path, winner, loser))
        assert "by a factor of at least 2, on 1 of 2 scenes" in text
        assert "Some peer beats ours on velocities" in text

    def test_a_peer_that_is_wrong_or_stopped_once_is_not_always_right(self, tmp_path):
        right = run("Right", "velocities", 1e-3, -12.0)
        wrong = run("Wrong", "velocities", 1e-3, -12.0, right=False, difference="1 event, not 24")
        text = self.short(planted(tmp_path, right, wrong, run("Hung", "velocities", None)))
        assert "Of 3 ways to use other tools, only Right has the events right everywhere." in text

    def test_forward_euler_is_told_by_its_hardest_figure(self, plain_trade):
        text = self.short(plain_trade)
        assert "Fig. 9: for the right events $10^{-3}$ s, for 1 % about $3.2\\cdot10^{-4}$ s." in text
        assert "In 5 s forward Euler multiplies the energy" in text
        assert "by 2 (step $10^{-2}$ s)" in text


def test_the_house_runs_of_euler_are_cached():
    assert euler.stick_energies() is euler.stick_energies()


def test_every_figure_has_its_scene():
    for name in euler_figures.SCENES.values():
        scene = load_scene(name)
        run = forward_euler(replace(scene, until=1), 1e-2)
        assert read(SwitchedPair.of(scene), run).steps == 100
