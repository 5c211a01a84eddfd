"""The interactive page as a file: whole in itself, the same every time, every control with a name."""

import json
import re
from dataclasses import replace

import pytest
from elements import Elements

from numerics import Force, Pair, load_scene
from paper_checks.__main__ import main
from paper_checks.claims import CLAIMS
from paper_checks.explore.page import source
from paper_checks.explore.scenes import SCENES, reduced


@pytest.fixture(scope="module")
def elements(whole):
    return Elements(whole).found


def test_it_is_one_light_file_that_needs_no_network(whole, elements):
    assert len(whole.encode()) < 100_000
    assert not [one for one in elements if {"src", "href", "srcset"} & set(one[1])]
    assert not re.search(r"https?:|//cdn|import\s|fetch\(|XMLHttp|@import|url\(|eval\(", whole)


def test_every_id_is_its_own_and_every_control_has_a_name(elements):
    ids = [attributes["id"] for _, attributes in elements if "id" in attributes]
    assert len(ids) == len(set(ids)) > 20
    labelled = {attributes["for"] for tag, attributes in elements if tag == "label"}
    fields = [attributes for tag, attributes in elements if tag in ("input", "select")]
    assert len(fields) > 15
    assert all(one.get("aria-label") or one.get("id") in labelled for one in fields)
    assert all(one.get("aria-label") for tag, one in elements if tag == "canvas")


def test_the_papers_scenes_are_those_of_the_files(whole):
    data = json.loads(re.search(r"const EXPLORE = (\{.*\});", whole).group(1))
    for shown, name in zip(data["scenes"], SCENES["paper"].values(), strict=False):
        told, scene = shown["scene"], load_scene(name)
        assert told["ratio"] == float(scene.pair.m1 / scene.pair.m2)
        energy = told["X"] ** 2 + (told["ratio"] * told["V1"] ** 2 + told["V2"] ** 2) / (1 + told["ratio"])
        assert energy - 1 == pytest.approx(float(scene.energy_excess))
        assert told["until"] == pytest.approx(float(scene.until) * float(scene.pair.a2 / scene.pair.mass) ** 0.5)
        assert not told["literal"]
    assert 0.792631 < data["criticalRatio"] < 0.792633


def test_what_the_page_knows_survives_the_reduction_and_other_forces_are_refused():
    scene = load_scene("velocities")
    pair, force = Pair(1, 1, 200, "0.05", a1=20), Force.step(0, "0.1") + Force.sine("0.2", 20)
    found = reduced(replace(scene, pair=pair, force=force))
    assert (found.zeta, found.constant, found.amplitude, found.omega) == pytest.approx((0.5, 2, 4, 2))
    assert reduced(load_scene("velocities-literal")).literal
    two = Force.sine(1, 1) + Force.sine(1, 2)
    for force in (Force.step(1, 1), Force.ramp(0, 1, 1), Force.sine(1, 1, 1), two):
        with pytest.raises(ValueError, match="one sine of phase 0"):
            reduced(replace(scene, force=force))


def test_the_rows_that_it_names_are_in_the_ledger():
    named = set(re.findall(r'row: "([a-z-]+)"', source()))
    assert len(named) == 3
    assert named <= {claim.id for claim in CLAIMS}


def test_the_command_writes_the_page_or_says_in_one_line_why_it_cannot(tmp_path, whole, capsys):
    target = tmp_path / "new" / "explore.html"
    assert main(["explore", "--out", str(target)]) == 0
    assert target.read_text("utf-8") == whole
    assert capsys.readouterr().out == f"{target}\n"
    assert main(["explore", "--out", str(target / "explore.html")]) == 2
    assert capsys.readouterr().err.startswith("error: the page cannot be written: ")
