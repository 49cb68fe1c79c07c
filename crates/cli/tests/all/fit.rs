//! `meniscus fit` on the command line.
use crate::common::{Done, meniscus};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A damped cosine in centimetres at 30 frames per second, with reproducible noise.
pub fn record(directory: &Path, name: &str, damping: f64, scatter: f64) -> PathBuf {
    let mut text = "t [s]\ty [cm]\n".to_owned();
    let mut seed = 12345_u64;
    for frame in 0..210_u32 {
        let time = f64::from(frame) / 30.0;
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let noise = ((seed >> 33) as f64 / f64::from(1_u32 << 31) - 0.5) * scatter;
        let level = 5.0 * libm::exp(-damping * time) * libm::cos(9.6 * time + 0.3) - 0.2 + noise;
        text.push_str(&format!("{time:.6}\t{level:.6}\n"));
    }
    let path = directory.join(name);
    std::fs::write(&path, text).expect("it can be written");
    path
}

pub fn word(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

pub fn object(done: &Done) -> Value {
    assert_eq!(done.code, 0, "{}", done.stderr);
    serde_json::from_str(&done.stdout).expect("JSON")
}

pub const COSINE: &str = "simulations/theories/cosine.md";
pub const LINEAR: &str = "simulations/theories/linear.md";

#[test]
fn a_fit_gives_values_in_declared_units_with_both_errors() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let fit = object(&meniscus(&["fit", COSINE, word(&data), "--observe", "y", "--format", "json"]));
    assert_eq!(fit["converged"], true);
    assert_eq!((fit["n"].as_u64(), fit["dof"].as_u64()), (Some(210), Some(205)));
    assert_eq!(fit["chi2_reduced"], Value::Null);
    for (name, truth, unit) in [("gamma", 0.4, "1/s"), ("omega_d", 9.6, "rad/s"), ("c", -0.002, "m")] {
        let found = &fit["parameters"][name];
        let (value, error) = (found["value"].as_f64().unwrap(), found["stderr"].as_f64().unwrap());
        assert!((value - truth).abs() < 4.0 * error, "{name}: {found}");
        assert!(found["stderr_hac"].as_f64().unwrap() > 0.0);
        assert_eq!(found["unit"], unit);
    }
    // Uniform noise of width 1 mm has the root mean square 1 mm/sqrt(12).
    assert!((fit["rmse"].as_f64().unwrap() / (0.001 / libm::sqrt(12.0)) - 1.0).abs() < 0.1);
    let length = fit["derived"]["L"]["value"].as_f64().unwrap();
    assert!((length - 2.0 * 9.8 / (9.6 * 9.6 + 0.16)).abs() < 1e-3);
    assert_eq!(fit["correlation"]["gamma"]["gamma"], 1.0);
    assert_eq!(fit["undetermined"], serde_json::json!([]));
    for key in ["r2", "aicc", "bic", "durbin_watson"] {
        assert!(fit[key].is_f64(), "{key}");
    }
}

#[test]
fn a_best_value_at_an_end_of_its_range_is_in_doubt() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let words = ["fit", COSINE, word(&data), "--observe", "y", "--bounds", "gamma=0..0.25"];
    let doubt = "gamma = 0.25 1/s is in doubt: it stands at an end of the range in which it was searched";
    let text = meniscus(&words);
    assert!(text.code == 0 && text.stdout.contains(doubt), "{}", text.stdout);
    let fit = object(&meniscus(&[&words[..], &["--format", "json"]].concat()));
    assert_eq!(fit["parameters"]["gamma"]["at_bound"], true);
    assert!(fit["warnings"][0].as_str().is_some_and(|remark| remark.starts_with(doubt)), "{}", fit["warnings"]);
    assert!(!meniscus(&words[..5]).stdout.contains("is in doubt"));
}

#[test]
fn what_the_data_cannot_determine_is_named() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.1, 0.02);
    let theory = directory.path().join("tube.md");
    let text = "---\ntitle: A tube\nvary: b, rho, L, y_0, v_0, c\n---\n\n```model\n\
        parameter b = 0.1 [kg/s]\nparameter rho = 1000 [kg/m^3]\nparameter S = 5 [cm^2]\nparameter L = 0.2 [m]\n\
        parameter y_0 = 0.04 [m]\nparameter v_0 = 0 [m/s]\nparameter c = 0 [m]\n\
        rho*S*L*x'' + b*x' + 2*rho*S*9.8 [m/s^2]*x = 0\nx(0) = y_0\nx'(0) = v_0\ny = x + c\nratio = b/rho\n```\n";
    std::fs::write(&theory, text).unwrap();
    let words = ["fit", word(&theory), word(&data), "--observe", "y"];
    let fit = object(&meniscus(&[&words[..], &["--format", "json"]].concat()));
    assert_eq!(fit["undetermined"], serde_json::json!(["b", "rho"]));
    assert_eq!(fit["determined_combinations"], serde_json::json!(["b/rho"]));
    assert_eq!(fit["parameters"]["b"]["value"], Value::Null);
    // Only the ratio is determined: gamma = b/(2 rho S L).
    let ratio = fit["derived"]["ratio"]["value"].as_f64().unwrap();
    let length = fit["parameters"]["L"]["value"].as_f64().unwrap();
    assert!((ratio / (2.0 * 5e-4 * length) - 0.1).abs() < 2e-3, "{ratio}");
    let told = meniscus(&words).stdout;
    assert!(told.contains("The data determine only b/rho, not b and rho each by itself; fix one of them."), "{told}");
    let held = object(&meniscus(&[&words[..], &["--fix", "rho=1000", "--format", "json"]].concat()));
    assert_eq!(held["undetermined"], serde_json::json!([]));
    assert!(held["parameters"]["rho"].is_null());
}

#[test]
fn a_part_is_fitted_and_the_rest_predicted() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.05);
    let words =
        ["fit", LINEAR, word(&data), "--observe", "y", "--from", "1", "--until", "4000 [ms]", "--format", "json"];
    let fit = object(&meniscus(&words));
    let outside = &fit["observations"][0]["outside"];
    // Of the 119 other values, the 30 before the initial values are not predicted.
    assert_eq!((fit["n"].as_u64(), outside["n"].as_u64()), (Some(91), Some(89)));
    assert_eq!((fit["observations"][0]["before_initial_values"].as_u64(), &fit["starts"]), (Some(30), &1.into()));
    assert_eq!(fit["initial_values_at"], serde_json::json!({"value": 1.0, "unit": "s"}));
    // The theory is the true one, so its prediction is as accurate as its fit.
    assert!(outside["rmse"].as_f64().unwrap() < 1.5 * fit["rmse"].as_f64().unwrap());
}

/// A fit that begins later gives the same result as one without the earlier rows: for each theory, each start, and a
/// prediction from the middle on.
fn rows_before_do_not_count(file: &Path, theories: &[&str], moments: &[&str]) {
    let directory = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(file).unwrap();
    for &from in moments {
        let first: f64 = from.parse().unwrap();
        let late = |line: &&str| {
            line.split_whitespace().next().and_then(|cell| cell.parse().ok()).is_none_or(|time: f64| time >= first)
        };
        let cut = directory.path().join("cut.txt");
        std::fs::write(&cut, text.lines().filter(late).map(|line| format!("{line}\n")).collect::<String>()).unwrap();
        let models: Vec<String> = theories.iter().map(|name| format!("simulations/theories/{name}.md")).collect();
        let rank = |file: &Path, part: &[&str]| {
            let mut words = vec!["rank", word(file), "--observe", "y", "--predict-from", "5", "--format", "json"];
            words.extend(models.iter().flat_map(|model| ["--model", model.as_str()]));
            object(&meniscus(&[&words, part].concat())).as_array().unwrap().clone()
        };
        let (part, alone) = (rank(file, &["--from", from]), rank(&cut, &[]));
        for (part, alone) in part.iter().zip(&alone) {
            assert_eq!((&part["document"], &part["n"]), (&alone["document"], &alone["n"]));
            for key in ["rmse", "rmse_before", "rmse_after", "rmse_predicted"] {
                let [one, other] = [part, alone].map(|row| row[key].as_f64().unwrap());
                assert!((one / other - 1.0).abs() < 2e-3, "{} {key} from {from}: {one} {other}", part["title"]);
            }
            assert_eq!(part["initial_values_at"], alone["initial_values_at"]);
        }
    }
}

#[test]
fn rows_before_the_part_might_as_well_not_be_there() {
    let directory = tempfile::tempdir().unwrap();
    let made = record(directory.path(), "made.txt", 0.4, 0.05);
    rows_before_do_not_count(&made, &["linear", "quadratic", "cosine"], &["1", "1.3", "2"]);
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn rows_before_the_part_of_a_measured_record_might_as_well_not_be_there() {
    let measured = crate::common::root().join("../shared/data/utube/U2.txt");
    rows_before_do_not_count(&measured, &["linear", "quadratic", "linear-contact-line", "dry-friction"], &["1.3"]);
}

#[test]
fn where_initial_values_hold_and_how_often_was_searched_is_said() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let words = ["fit", "simulations/theories/quadratic.md", word(&data), "--observe", "y", "--from", "1.01"];
    let told = meniscus(&words).stdout;
    assert!(told.contains("t = 1.0333 s. Nothing is predicted of the 31 values before"), "{told}");
    assert!(told.contains("The search was made from "), "{told}");
    let told = meniscus(&["fit", COSINE, word(&data), "--observe", "y", "--from", "1"]).stdout;
    assert!(!told.contains("initial values") && !told.contains("starts"), "{told}");
}

/// Standard errors are assigned to the right values despite gaps, and invalid ones are reported.
#[test]
fn given_errors_that_are_none_are_refused_where_they_count() {
    let directory = tempfile::tempdir().unwrap();
    let file = |name: &str, error: &dyn Fn(usize) -> &'static str| {
        let row = |place: usize| {
            let level = if place == 4 { String::new() } else { format!("{}", 1.0 + 0.5 * place as f64) };
            format!("{place}\t{level}\t{}\n", error(place))
        };
        let path = directory.path().join(name);
        let rows: String = (0..20).map(row).collect();
        std::fs::write(&path, format!("t [s]\ty [m]\ts [mm]\n{rows}")).unwrap();
        path
    };
    let line = directory.path().join("line.md");
    let text = "---\ntitle: A line\nvary: a, b\n---\n\n```model\nparameter a = 1 [m]\nparameter b = 1 [m/s]\ny = a + b*t\n```\n";
    std::fs::write(&line, text).unwrap();
    let fit = |file: &Path, more: &[&str]| {
        meniscus(&[&["fit", word(&line), word(file), "--observe", "y", "--error", "y=s"], more].concat())
    };
    // A gap of the level may have an error or none.
    for gap in ["2", ""] {
        let good = file("good.txt", &|place| if place == 4 { gap } else { "2" });
        let done = fit(&good, &["--format", "json"]);
        assert_eq!(object(&done)["n"], 19);
    }
    for bad in ["0", "-1", ""] {
        let bad = file("bad.txt", &|place| if place == 7 || place == 9 { bad } else { "2" });
        let done = fit(&bad, &[]);
        assert_eq!(done.code, 2);
        assert!(done.stderr.contains("bad.txt: 2 values have a standard error that is missing or not greater than 0"));
        assert!(done.stderr.contains("the first is at t = 7 s"), "{}", done.stderr);
        assert_eq!(fit(&bad, &["--until", "6"]).code, 0);
    }
    let good = file("good.txt", &|_| "2");
    for (words, said) in [
        (vec!["--error", "y=0"], "--error y must be greater than 0"),
        (vec!["--error", "y=t"], "and what is observed is in m"),
        (vec!["--fix", "b=1,2"], "--fix b: 2 values for 1 record"),
        (vec!["--from", "3", "--until", "2"], "--until 2 is not after --from 3: nothing lies between them"),
        (vec!["--from", "2", "--until", "2"], "--until 2 is not after --from 2: nothing lies between them"),
        (vec!["--start", "a=1/0"], "--start a"),
    ] {
        let done = meniscus(&[&["fit", word(&line), word(&good), "--observe", "y"], &words[..]].concat());
        assert_eq!(done.code, 2, "{words:?}: {}", done.stderr);
        assert!(done.stderr.contains(said), "{words:?}: {}", done.stderr);
    }
    // Of several files, the one without values in the fitted part is named.
    let late = directory.path().join("late.txt");
    std::fs::write(&late, "t [s]\ty [m]\n100\t1\n101\t2\n102\t3\n").unwrap();
    let done = meniscus(&["fit", word(&line), word(&good), word(&late), "--observe", "y", "--until", "50"]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("late.txt: a record has no measured value in the fitted part"), "{}", done.stderr);
}

#[test]
fn several_runs_share_what_they_are_told_to() {
    let directory = tempfile::tempdir().unwrap();
    let (slow, fast) =
        (record(directory.path(), "slow.txt", 0.2, 0.05), record(directory.path(), "fast.txt", 0.8, 0.05));
    let words = ["fit", LINEAR, word(&slow), word(&fast), "--observe", "y", "--share", "L,c", "--format", "json"];
    let fit = object(&meniscus(&words));
    assert!(fit["parameters"]["L"]["value"].is_f64() && fit["parameters"]["gamma"].is_null());
    for (run, name, damping) in [(0, "slow.txt", 0.2), (1, "fast.txt", 0.8)] {
        assert_eq!(fit["runs"][run]["name"], name);
        let gamma = fit["runs"][run]["parameters"]["gamma"]["value"].as_f64().unwrap();
        assert!((gamma - damping).abs() < 0.01, "{gamma}");
    }
}

#[test]
fn given_errors_make_chi_square_mean_something() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let error = format!("y={}", 0.001 / libm::sqrt(12.0));
    let fit = object(&meniscus(&["fit", COSINE, word(&data), "--observe", "y", "--error", &error, "--format", "json"]));
    assert!((fit["chi2_reduced"].as_f64().unwrap() - 1.0).abs() < 0.25);
}

#[test]
fn what_cannot_be_done_is_said_and_nothing_is_written() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let kilograms = directory.path().join("mass.txt");
    std::fs::write(&kilograms, "t [s]\ty [kg]\n0\t1\n1\t2\n2\t3\n3\t5\n").unwrap();
    for (words, code, said) in [
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--vary", "gama"], 2, "there is no parameter `gama`\n"),
        (vec!["fit", COSINE, word(&data), "--observe", "z"], 2, "z"),
        (vec!["fit", COSINE, word(&data), "--observe", "y=7"], 2, "no column `7`"),
        (vec!["fit", COSINE, word(&kilograms), "--observe", "y"], 2, "column y is in kg, and what is observed is in m"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--share", "drift"], 2, "drift is not varied"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--bounds", "gamma=3..1"], 2, "not below"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--bounds", "gamma=3"], 2, "LO..HI"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--from", "100"], 2, "no measured value"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--until", "0.1"], 2, "cannot determine 5 numbers"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--fix", "gamma=99"], 2, "out of range"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--vary", "gamma", "--fix", "gamma=1"], 2, "gamma"),
        (vec!["fit", COSINE, word(&data), "--observe", "y", "--output", "fit.docx"], 2, ".html (a report)"),
        (vec!["fit", COSINE, "absent.txt", "--observe", "y"], 2, "absent.txt"),
        (vec!["rank", word(&data), "--model", COSINE, "--observe", "y"], 2, "only one theory"),
    ] {
        let done = meniscus(&words);
        assert_eq!(done.code, code, "{words:?}: {}", done.stderr);
        assert!(done.stderr.contains(said), "{words:?}: {}", done.stderr);
        assert_eq!(done.stdout, "", "{words:?}");
    }
    let before = std::fs::read(&data).unwrap();
    let over = directory.path().join("run.csv");
    std::fs::rename(&data, &over).unwrap();
    let done = meniscus(&["fit", COSINE, word(&over), "--observe", "y", "--output", word(&over)]);
    assert_eq!(done.code, 2);
    assert_eq!(std::fs::read(&over).unwrap(), before, "the data are never overwritten");
}

#[test]
fn reports_workbooks_tables_and_figures_are_written() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    for (name, begins, contains) in [
        ("fit.html", "<!doctype html>", "Damped cosine"),
        ("fit.csv", "", "y residual [m]"),
        ("fit.svg", "<svg", "</svg>"),
    ] {
        let path = directory.path().join(name);
        let done = meniscus(&["fit", COSINE, word(&data), "--observe", "y", "--profile", "--output", word(&path)]);
        assert_eq!(done.code, 0, "{}", done.stderr);
        assert!(done.stdout.contains("68 %:"), "{}", done.stdout);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.to_lowercase().starts_with(begins) && text.contains(contains), "{name}: {text:.200}");
    }
    let path = directory.path().join("fit.xlsx");
    let done = meniscus(&["fit", COSINE, word(&data), "--observe", "y", "--output", word(&path)]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    use calamine::Reader;
    let mut workbook = calamine::open_workbook_auto(&path).unwrap();
    let sheets = workbook.sheet_names();
    assert!(sheets.len() >= 3, "{sheets:?}");
    let cells: Vec<String> = sheets
        .iter()
        .flat_map(|sheet| {
            let range = workbook.worksheet_range(sheet).unwrap();
            range.used_cells().map(|(_, _, cell)| cell.to_string()).collect::<Vec<_>>()
        })
        .collect();
    assert!(cells.iter().any(|cell| cell == "gamma" || cell == "γ"), "{cells:?}");
    // The sheet contains the measured levels.
    assert!(cells.len() > 3 * 210);
}

/// One value of a record is off by 2 cm: it is reported, and a robust loss removes its influence.
#[test]
fn an_outlier_is_named_and_a_robust_loss_disregards_it() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let mut lines: Vec<String> = std::fs::read_to_string(&data).unwrap().lines().map(str::to_owned).collect();
    let (time, value) = lines[61].split_once('\t').unwrap();
    lines[61] = format!("{time}\t{:.6}", value.parse::<f64>().unwrap() + 2.0);
    std::fs::write(&data, lines.join("\n")).unwrap();
    let words = ["fit", COSINE, word(&data), "--observe", "y"];
    let with = |more: &[&str]| object(&meniscus(&[&words[..], &["--format", "json"], more].concat()));
    let squares = with(&[]);
    let outlier = &squares["outliers"][0];
    assert_eq!(squares["outliers"].as_array().unwrap().len(), 1);
    assert!(
        (outlier["time"].as_f64().unwrap() - 2.0).abs() < 1e-9 && outlier["sigmas"].as_f64().unwrap() > 30.0,
        "{outlier}"
    );
    assert_eq!((&squares["loss"], &squares["reweighted"]), (&"least-squares".into(), &Value::Null));
    let text = meniscus(&words).stdout;
    assert!(text.contains("One value is an outlier: y = ") && text.contains("at t = 2 s (+"), "{text}");
    assert!(text.contains("The residuals look random"), "{text}");
    for loss in ["huber", "tukey"] {
        let robust = with(&["--loss", loss]);
        assert_eq!((&robust["loss"], &robust["r2"]), (&loss.into(), &Value::Null));
        for (name, truth) in [("gamma", 0.4), ("omega_d", 9.6), ("c", -0.002)] {
            let found = &robust["parameters"][name];
            let off = (found["value"].as_f64().unwrap() - truth).abs();
            assert!(off < 4.0 * found["stderr"].as_f64().unwrap(), "{loss} {name}: {found}");
            assert_eq!(
                found["least_squares"].as_f64().unwrap(),
                squares["parameters"][name]["value"].as_f64().unwrap()
            );
        }
        let text = meniscus(&[&words[..], &["--loss", loss]].concat()).stdout;
        assert!(text.contains("the weight is ") && text.contains("Against least squares "), "{text}");
    }
    let refused = meniscus(&[&words[..], &["--loss", "huber", "--profile"]].concat());
    assert!(refused.code != 0 && refused.stderr.contains("--profile needs least squares"), "{}", refused.stderr);
}
