"""Fits of synthetic records, whose parameters are known."""

import json
import os
import subprocess

import numpy
import pandas
import pytest

import meniscus
from conftest import DAMPED, ROOT

TRUE = {"gamma": 0.7, "omega": 12.0, "x_0": 4.0}


@pytest.fixture
def record(damped):
    """A noisy record, columns by heading."""
    run = damped.run(**TRUE, step=0.01)
    noise = numpy.random.default_rng(1).normal(0.0, 0.02, len(run))
    return {"t [s]": run["t"], "x [cm]": run["x"] + noise}


@pytest.mark.parametrize("form", ["dictionary", "frame", "file", "several"])
def test_a_fit_finds_what_made_the_record(damped, record, tmp_path, form):
    path = tmp_path / "record.csv"
    pandas.DataFrame(record).to_csv(path, index=False)
    data = {"dictionary": record, "frame": pandas.DataFrame(record), "file": path, "several": [path, record]}[form]
    fit = damped.fit(data, "x", share=["gamma", "omega", "x_0"] if form == "several" else None)
    for name, value in TRUE.items():
        found = fit.parameters[name]
        assert abs(found.value - value) < 5 * found.stderr and found.stderr < 0.02 * value, (name, found)
        assert found.unit == damped.units[name] and float(found) == found.value
    assert fit["converged"] and fit["rmse"] == pytest.approx(0.02, rel=0.2)
    table = fit.curves[0]
    assert (table["measured"] - table["fitted"] == pytest.approx(table["residual"], abs=1e-12)) and table["inside"].all()
    assert "gamma" in str(fit)


def test_a_table_is_a_record(damped):
    fit = damped.fit(damped.run(**TRUE, columns="t, x", step="10 ms"), {"x": "x"}, vary="gamma, omega, x_0")
    assert {name: found.value for name, found in fit.parameters.items()} == pytest.approx(TRUE, rel=1e-4)


def test_a_fit_has_the_bits_of_the_program(record, tmp_path, damped):
    path, document = tmp_path / "record.csv", tmp_path / "damped.md"
    pandas.DataFrame(record).to_csv(path, index=False)
    document.write_text(DAMPED)
    words = [os.environ["MENISCUS"], "fit", document, path, "--observe", "x", "--fix", "omega=12", "--until", "1.5", "--format", "json"]
    expected = json.loads(subprocess.run(words, capture_output=True, check=True).stdout)
    fit = meniscus.open(document).fit(path, "x", fix={"omega": 12}, until="1.5 s")
    assert fit.summary == expected


def test_settings_of_a_fit_are_taken(damped, record):
    fit = damped.fit(
        record, "x", vary=["gamma", "x_0"], fix={"omega": "12 rad/s"}, start={"gamma": 1}, bounds={"gamma": (0.1, None), "x_0": "2..6"},
        error={"x": "0.2 mm"}, loss="huber", begin=0.1, until=1.9,
    )  # fmt: skip
    assert set(fit.parameters) == {"gamma", "x_0"} and fit["loss"] == "huber"
    assert not fit.curves[0]["inside"].all()
    assert damped.fit(record, "x", profile=True)["parameters"]["gamma"]["profile"][0]["level"] == pytest.approx(0.6827, abs=1e-3)


def test_theories_are_ranked(damped, record):
    other = meniscus.open(DAMPED.replace("-2*gamma*x'", "-0.1*gamma*x'").replace("gamma = 0.3 [1/s] in 0..5", "gamma = 0.3 [1/s] in 0..1"))
    best, second = meniscus.rank(record, [other, damped], "x", predict_from=1.2)
    assert best["title"] == second["title"] and (best["place"], second["place"]) == (1, 2)
    assert best.parameters["gamma"].value == pytest.approx(TRUE["gamma"], rel=0.05)
    assert second["delta_aicc"] > 100 and best["rmse_predicted"] < second["rmse_predicted"]


def test_wrong_fits_say_why(damped, record):
    for options, message in [
        ({"vary": "mass"}, "there is no parameter `mass`"),
        ({"bounds": {"gamma": (2, 1)}}, "the lower bound is not below"),
        ({"share": "gamma"}, "only one record"),
    ]:
        with pytest.raises(meniscus.SettingError) as raised:
            damped.fit(record, "x", **options)
        assert message in str(raised.value) and "--" not in str(raised.value)
    with pytest.raises(meniscus.SettingError, match="no column `z`"):
        damped.fit(record, {"x": "z"})
