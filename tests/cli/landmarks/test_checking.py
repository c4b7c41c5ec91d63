"""`bodymeasure landmarks check`."""

import csv
import io
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import Run

from bodymeasure import load_sample, write_atlas
from bodymeasure.atlas import AtlasPoint


def test_a_symmetric_body_passes_the_check(run: Run) -> None:
    ran = run("landmarks", "check", "male_average")
    assert (ran.code, ran.err) == (0, "")
    assert "Mirror: the plane in which the surface is most nearly symmetric" in ran.out
    assert "with normal (1.0000, 0.0000, 0.0000)" in ran.out
    assert "0 remarks; landmarks that are off by more than 0.50 cm get one\n" in ran.out
    across = run("landmarks", "check", "male_average", "--mirror", "axes", "--unit", "mm")
    assert "Mirror: the plane across the atlas's axes through its median landmarks" in across.out
    assert "more than 5.0 mm" in across.out


def test_the_check_tells_what_is_off(run: Run, tmp_path: Path) -> None:
    body = load_sample("female_average")
    landmarks = {
        **body.landmarks,
        "bust point left": AtlasPoint(215, 0.6, 0.3),
        "front hip point": AtlasPoint(109, 0.1, 0.6),
        "acromion left": AtlasPoint(208, 0.5, 0.5),
    }
    file = tmp_path / "off.atlas"
    write_atlas(replace(body, landmarks=landmarks), file)
    ran = run("landmarks", "check", file)
    assert (ran.code, ran.err) == (1, "")
    for said in (
        "not the mirror image of bust point right",
        "off the mirror, to the right",
        "has no partner acromion right",
        "unknown; did you mean 'shoulder point left'?",
        "4 remarks;",
    ):
        assert said in ran.out
    ran = run("landmarks", "check", file, "--within", "30", "--format", "json")
    assert ran.code == 1
    document = json.loads(ran.out)
    assert (document["mirror"], document["within"], document["unit"]) == ("fitted", 30.0, "cm")
    remarks = [record for record in document["landmarks"] if record["remark"]]
    assert [record["checked"] for record in remarks] == ["partner", "name"]
    rows = list(csv.DictReader(io.StringIO(run("landmarks", "check", file, "--format", "csv").out)))
    assert (rows[0]["name"], rows[0]["checked"]) == ("bust point left", "pair")
    mirrored = body.position(landmarks["bust point left"]) * [-1.0, 1.0, 1.0]
    apart = 100.0 * np.linalg.norm(mirrored - body.position(landmarks["bust point right"]))
    assert float(rows[0]["distance"]) == pytest.approx(apart, rel=1e-12)


def test_a_distance_that_is_no_number_is_refused(run: Run) -> None:
    ran = run("landmarks", "check", "female_average", "--within", "nan")
    assert ran.code == 2
    assert "'nan' is no number" in " ".join(ran.err.split())
