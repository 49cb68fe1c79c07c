//! `meniscus rank` on the command line.

use crate::common::meniscus;
use crate::fit::{object, word};

/// Theories of friction for the measured column: their AICc, their errors before and after 6 s, and their predictions
/// after 6 s.
#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn the_theories_of_the_measured_column_are_ranked() {
    let data = crate::common::root().join("../shared/data/utube");
    let theories =
        ["linear", "quadratic", "dry-friction", "linear-contact-line", "quadratic-contact-line", "power-law"];
    for name in ["U1", "U2", "U3", "U4"] {
        let file = data.join(format!("{name}.txt"));
        let mut words =
            vec!["rank", word(&file), "--observe", "y", "--from", "1", "--predict-from", "6", "--format", "json"];
        let models: Vec<String> = theories.iter().map(|theory| format!("simulations/theories/{theory}.md")).collect();
        for model in &models {
            words.extend(["--model", model]);
        }
        let ranked = object(&meniscus(&words));
        let rows = ranked.as_array().unwrap();
        let row = |theory: &str| {
            let ending = format!("{theory}.md");
            rows.iter().find(|row| row["document"].as_str().unwrap().ends_with(&format!("/{ending}"))).unwrap()
        };
        let number = |theory: &str, key: &str| row(theory)[key].as_f64().unwrap();
        for theory in theories {
            let [all, before, after, predicted] =
                ["rmse", "rmse_before", "rmse_after", "rmse_predicted"].map(|key| 1000.0 * number(theory, key));
            println!(
                "{name} {theory:24} {all:.3} mm, before 6 s {before:.3}, after {after:.3}, predicted {predicted:.3}"
            );
            assert_eq!(row(theory)["converged"], true, "{name} {theory}");
        }
        // The contact line explains and predicts what viscous friction does not.
        let best = rows[0]["document"].as_str().unwrap();
        assert!(best.ends_with("contact-line.md"), "{name}: {best}");
        for theory in ["linear", "quadratic", "dry-friction", "power-law"] {
            assert!(number(theory, "rmse") > 1.3 * number("quadratic-contact-line", "rmse"), "{name} {theory}");
        }
        let by_best = rows[0]["rmse_predicted"].as_f64().unwrap();
        assert!(number("linear", "rmse_predicted") > 1.3 * by_best, "{name}");
    }
}
