"""The interactive page in use, in headless Chromium: buttons, sliders, keys, phone, less motion."""

from dataclasses import asdict

import pytest

from numerics import load_scene
from paper_checks.explore.scenes import reduced


@pytest.fixture(scope="module")
def found(ask) -> dict:
    answer = ask("use", "--blink-settings=preferredColorScheme=0")  # dark
    assert "error" not in answer, answer
    return answer


def test_every_button_tells_what_becomes_of_its_scene(found):
    said = dict(found["regimes"])
    assert len(said) == 16
    for name, regime in said.items():
        for word in ("merges", "creeps", "entrained", "stick and slip"):
            if word in name.lower():
                assert regime.lower().startswith(word), name
    assert said["Sine: never sticks"].startswith("Slips all the time")
    assert said["Sticks permanently"].startswith("Sticks permanently")
    assert said["Next to the critical orbit"].startswith("Creeps")
    assert found["pressed"] == 1
    assert found["proof"] == [True, None, "report.html#critical-mass-ratio"]


def test_the_scene_that_it_writes_is_the_one_that_it_shows(found, tmp_path):
    for text, shown in found["files"]:
        path = tmp_path / "scene.toml"
        path.write_text(text, encoding="utf-8")
        assert asdict(reduced(load_scene(path))) == pytest.approx(shown, rel=1e-12, abs=1e-12)


def test_sliders_and_fields_change_the_scene(found):
    assert found["merging"] == ["slip+", "stick"]
    value, told, pressed, hidden = found["slid"]
    assert float(value) == pytest.approx(22.9, rel=1e-2)
    assert (told, pressed, hidden) == ("22.9", 0, True)
    assert found["hidden"] == [True, False, True]
    assert found["invalid"] == ["true", "true", None, True]
    assert found["literal"].startswith("Stuck by definition")


def test_nothing_overflows_on_a_phone(ask, whole):
    empty = "<!DOCTYPE html><html><body></body></html>"
    width, out, picture = ask("phone", on=empty, WHOLE=whole)
    assert width <= 390
    assert out == []
    assert picture > 320


def test_less_motion_goes_from_event_to_event(ask):
    seen, times = ask("calm", "--force-prefers-reduced-motion")
    for text, time in zip(seen, times, strict=False):
        assert float(text.split("=")[1].split(":")[0]) == pytest.approx(float(time), rel=1e-3)
