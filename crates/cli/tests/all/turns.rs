//! Cycles and angles on the command line: each pair of units through each way by which a number comes in or goes out.

use crate::common::{directory_with, meniscus, numbers};
use serde_json::Value;
use std::f64::consts::TAU;

/// Units with their factors to turns per second.
const UNITS: [(&str, f64); 5] =
    [("Hz", 1.0), ("kHz", 1e3), ("rad/s", 1.0 / TAU), ("deg/s", 1.0 / 360.0), ("rpm", 1.0 / 60.0)];

/// A document with a parameter `w`, a quantity `q` made of it, and both shown in each unit.
fn document(unit: &str) -> String {
    let shown = UNITS
        .iter()
        .zip(0..)
        .map(|((unit, _), place)| format!("w_{place} = w in [{unit}]\nq_{place} = q in [{unit}]\n"));
    let shown: String = shown.collect();
    format!(
        "---\nuntil: 1 [s]\nstep: 0.5 [s]\nvary: w\n---\n\n```model\nparameter w = 1 [{unit}] in 0..1e9\n\
         q = w*(1 + 0*t/(1 [s]))\nx' = 0*x/(1 [s])\nx(0) = 1\n{shown}```\n"
    )
}

#[track_caller]
fn same(found: f64, expected: f64, what: &str) {
    assert!((found / expected - 1.0).abs() < 1e-12, "{what}: {found}, not {expected}");
}

#[test]
fn settings_sweeps_and_columns_are_converted_through_the_turn() {
    for (own, turns) in UNITS {
        let (_directory, path) = directory_with(&document(own));
        let path = path.to_str().unwrap();
        let columns: Vec<String> = (0..UNITS.len()).map(|place| format!("w_{place},q_{place}")).collect();
        let columns = columns.join(",");
        for (typed, typed_turns) in UNITS {
            let set = format!("w=0.5 [{typed}]");
            let done = meniscus(&["run", path, "--set", &set, "--columns", &columns]);
            assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{own} {set}");
            for (place, (unit, shown)) in UNITS.into_iter().enumerate() {
                for found in &numbers(&done.stdout)[0][2 * place..2 * place + 2] {
                    same(*found, 0.5 * typed_turns / shown, &format!("{set} for {own}, shown in {unit}"));
                }
            }
            let over = format!("w in 0.1..0.2 [{typed}] step 0.1");
            let single = format!("w = 0.1, 0.2 [{typed}]");
            for over in [over, single] {
                let keep = "w in [rpm], maximum(q) in [Hz], q at end in [deg/s]";
                let done = meniscus(&["sweep", path, "--over", &over, "--keep", keep]);
                assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{own} {over}");
                let turns_of_rows = [0.1, 0.2].map(|value| value * typed_turns);
                for (row, expected) in numbers(&done.stdout).iter().zip(turns_of_rows) {
                    let scales = [turns, 1.0 / 60.0, 1.0, 1.0 / 360.0];
                    for (found, scale) in row[1..].iter().zip(scales) {
                        same(*found, expected / scale, &format!("{over} for {own}: {row:?}"));
                    }
                }
            }
        }
    }
}

#[test]
fn expressions_are_set_and_shown_as_they_are() {
    let (_directory, path) = directory_with(&document("rad/s"));
    let path = path.to_str().unwrap();
    for (over, keep, expected) in [
        ("w = 2*pi*0.5 [Hz]", "w", TAU / 2.0),
        ("w = 3 [1/s]", "w", 3.0),
        ("w = 3", "w in [1/s]", 3.0),
        ("w = 3", "w/(2*pi) in [Hz]", 3.0 / TAU),
        ("w = 3", "2*w in [Hz]", 6.0),
    ] {
        let done = meniscus(&["sweep", path, "--over", over, "--keep", keep]);
        assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{over} {keep}");
        same(numbers(&done.stdout)[0][2], expected, &format!("{over} {keep}"));
    }
}

/// A column of 1.5 turns per second in each unit, measured against a quantity in each unit.
#[test]
fn columns_are_compared_in_the_kind_of_the_quantity() {
    let directory = tempfile::tempdir().unwrap();
    let data = directory.path().join("data.csv");
    let off = [0.01, -0.01, 0.02, -0.02];
    let heads = UNITS.map(|(unit, _)| format!("n ({unit})")).join(",");
    let rows = off.iter().zip(0..).map(|(off, time)| {
        let cells = UNITS.map(|(_, turns)| ((1.5 + off) / turns).to_string());
        format!("{time},{}\n", cells.join(","))
    });
    std::fs::write(&data, format!("t (s),{heads}\n{}", rows.collect::<String>())).unwrap();
    let data = data.to_str().unwrap();
    for (own, turns) in UNITS {
        let (_directory, path) = directory_with(&document(own));
        for (column, (unit, _)) in UNITS.into_iter().enumerate() {
            let observe = format!("q=#{}", column + 2);
            let done = meniscus(&["fit", path.to_str().unwrap(), data, "--observe", &observe, "--format", "json"]);
            assert_eq!(done.code, 0, "{}", done.stderr);
            let found: Value = serde_json::from_str(&done.stdout).unwrap();
            let value = found["parameters"]["w"]["value"].as_f64().unwrap_or(f64::NAN);
            assert!((value * turns / 1.5 - 1.0).abs() < 1e-9, "a column in {unit} for {own}: {value}\n{}", done.stdout);
        }
    }
}

#[test]
fn claims_compare_cycles_with_angles() {
    for (own, turns) in UNITS {
        for (other, other_turns) in UNITS {
            let value = turns / other_turns;
            let text = format!(
                "{}\n```check\n\"shown\": q in [{other}] within 1e-9 of {value} [{other}] at end\n\
                 \"stated\": q within 1e-9 of {value} [{other}] at end\n\
                 \"near\": q within {} [{other}] of 0 [{own}] at end\n\
                 \"far\": q within {} [{other}] of 0 [{own}] at end\n```\n",
                document(own),
                value * 1.001,
                value * 0.999
            );
            let (_directory, path) = directory_with(&text);
            let done = meniscus(&["check", "--run", path.to_str().unwrap()]);
            for (sign, name) in [('✓', "shown"), ('✓', "stated"), ('✓', "near"), ('✗', "far")] {
                let said = done.stdout.contains(&format!("{sign} {name}: "));
                assert!(said, "{name} in {other} for {own}\n{}{}", done.stdout, done.stderr);
            }
        }
    }
}
