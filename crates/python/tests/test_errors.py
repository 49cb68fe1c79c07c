"""Errors are exceptions whose message says what, where, and what to do."""

import pytest

import meniscus
from conftest import DAMPED, ROOT


def test_findings_have_place_message_and_remedy():
    text = DAMPED.replace("-2*gamma*x'", "-2*gmma*x'")
    [finding] = [finding for finding in meniscus.check(text) if finding.severity == "error"]
    line = next(number for number, line in enumerate(text.splitlines(), 1) if "gmma" in line)
    assert (finding.line, finding.text) == (line, "gmma")
    assert text.splitlines()[line - 1][finding.column - 1 :].startswith("gmma")
    assert "gamma" in finding.remedy + finding.message and finding.code
    with pytest.raises(meniscus.DocumentError) as raised:
        meniscus.open(text)
    assert finding.message in str(raised.value) and f"document:{line}:" in str(raised.value)


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"x0": 1}, "there is no parameter `x0`"),
        ({"x_0": "3 kg"}, "x_0 is in cm"),
        ({"x_0": 100}, "x_0 = 100 cm is out of range"),
        ({"x_0": "3 +"}, "x_0:1:"),
        ({"until": -1}, "until must be greater than 0"),
        ({"method": "rk5"}, "did you mean `rk4`?"),
        ({"columns": "z"}, "there is no column `z`"),
        ({"start": {"v": 1}}, "there is no variable `v`"),
        ({"seat": 3}, "the document assigns no values to seats"),
    ],
)
def test_wrong_settings_name_themselves(damped, settings, message):
    with pytest.raises(meniscus.SettingError) as raised:
        damped.run(**settings)
    assert message in str(raised.value) and "--" not in str(raised.value)


def test_a_run_that_cannot_go_on_says_where():
    document = meniscus.open("```model\nparameter a = 1 [1/(m s)]\nx' = a*x^2\nx(0) = 1 [m]\n```\n")
    with pytest.raises(meniscus.RunError) as raised:
        document.run(until=5)
    [finding] = raised.value.diagnostics
    assert finding.line in (3, 4) and finding.remedy


def test_files_that_are_missing_are_named():
    with pytest.raises(meniscus.SettingError, match="cannot read"):
        meniscus.open(ROOT / "simulations" / "missing.md")
    with pytest.raises(meniscus.MeniscusError, match="is a folder"):
        meniscus.open(ROOT / "simulations")


def test_wrong_types_are_refused(damped):
    with pytest.raises(ValueError):
        damped.run(x_0=[object()])
    with pytest.raises(TypeError):
        damped.run(set=3)
    with pytest.raises(TypeError):
        damped.fit({"t": [0, 1], "x": [0, 1]}, "x", vari="gamma")


def test_claims_of_documents_that_ship_hold():
    for name in ["utube", "pendulum"]:
        assert meniscus.open(ROOT / "simulations" / f"{name}.md").check(claims=True) == []
