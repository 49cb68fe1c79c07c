//! Reports of doubtful results, and the format of numbers.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by them")]

mod support;

use analysis::fit::{Loss, Record, Target, Varied};
use calamine::{Data, Reader};
use report::{Ranking, html, quantity, ranking_html, workbook};
use support::{Fitted, fitted, level, observed, record, texts, theory};
use units::Unit;
use units::number::Style;

/// Index of `gamma` among the parameters of the theory.
const GAMMA: usize = 5;

/// The record of known truth, fitted with its theory.
fn level_fitted() -> Fitted {
    let (times, values) = level();
    let mut document = theory("linear");
    let record = record(&mut document, "swing.txt", &times, &values);
    fitted("linear", document, vec![record], |_| ())
}

#[test]
fn a_number_at_an_end_of_its_range_is_in_doubt() {
    let (times, values) = level();
    let mut document = theory("linear");
    let record = record(&mut document, "swing.txt", &times, &values);
    // The true damping of the record is 0.4 /s.
    let stopped = fitted("linear", document, vec![record], |task| {
        let name = |varied: &Varied| matches!(varied.target, Target::Parameter(index) if index == GAMMA);
        task.varied.iter_mut().filter(|varied| name(varied)).for_each(|varied| varied.bounds = Some((0.0, 0.3)));
    });
    let (english, spanish) =
        ("gamma = 0.3 1/s is in doubt: it stands at an end", "gamma = 0,3 1/s es dudoso: está en un extremo");
    for (language, expected) in [("en", english), ("es", spanish)] {
        let report = stopped.report(language);
        let page = texts(&html(&report));
        assert_eq!(page.matches(expected).count(), 1, "{page}");
        let mut book: calamine::Xlsx<_> =
            calamine::open_workbook_from_rs(std::io::Cursor::new(workbook(&report))).unwrap();
        let sheet = if language == "en" { "Results" } else { "Resultados" };
        let results = book.worksheet_range(sheet).unwrap();
        let said = |cell: &Data| matches!(cell, Data::String(text) if text.starts_with(expected));
        assert!(results.rows().any(|row| row.iter().any(said)), "{language}");
    }
    // Without an estimate at a bound there is no doubt.
    assert!(!texts(&html(&level_fitted().report("en"))).contains("is in doubt"));
}

/// Five values per second resolve 10 rad/s, three do not.
#[test]
fn an_alias_is_in_doubt() {
    let (times, values) = level();
    let doubted = |every: usize, language: &str| {
        let (times, values): (Vec<f64>, Vec<f64>) =
            times.iter().copied().zip(values.iter().copied()).step_by(every).unzip();
        let mut document = theory("linear");
        let record = record(&mut document, "swing.txt", &times, &values);
        let fit = fitted("linear", document, vec![record], |_| ());
        let page = texts(&html(&fit.report(language)));
        let start = match language {
            "en" => "The fitted curve oscillates faster than the sampling can show",
            _ => "La curva ajustada oscila más rápido de lo que el muestreo puede mostrar",
        };
        page.matches(start).count()
    };
    assert_eq!([doubted(10, "en"), doubted(10, "es"), doubted(6, "en")], [1, 1, 0]);
}

/// The outlier that dominates the fit is reported first, without the good values beside it.
#[test]
fn a_value_far_from_all_others_is_named() {
    let (times, mut values) = level();
    values[80] = 9999.0;
    let page = |loss: Loss, language: &str| {
        let mut document = theory("linear");
        let record = record(&mut document, "swing.txt", &times, &values);
        let fit = fitted("linear", document, vec![record], |task| task.loss = loss);
        texts(&html(&fit.report(language)))
    };
    for (language, expected) in [
        ("en", "One value lies far from all others: y = 9999 m at t = 2.6667 s. It has decided the fit"),
        ("es", "Un valor está muy lejos de todos los demás: y = 9999 m en t = 2,6667 s. Ha decidido el ajuste"),
    ] {
        let page = page(Loss::Squares, language);
        assert_eq!(page.matches(expected).count(), 1, "{page}");
        assert!(!page.contains("are outliers") && !page.contains("son atípicos"), "{page}");
    }
    let robust = page(Loss::Tukey, "en");
    assert!(robust.contains("the weight is below one half for 3 of 240 values"), "{robust}");
    assert!(robust.contains("One value is an outlier: y = 9999 m at t = 2.6667 s (+"), "{robust}");
    assert!(!robust.contains("Another minimum"), "{robust}");
}

/// Nine values are too few to judge residuals, which is a warning.
#[test]
fn a_verdict_is_a_warning_unless_it_is_good() {
    assert!(html(&level_fitted().report("en")).contains("<p class=\"verdict\">"));
    let (times, values) = level();
    let mut document = theory("linear");
    let record = record(&mut document, "swing.txt", &times[..9], &values[..9]);
    let page = html(&fitted("linear", document, vec![record], |_| ()).report("en"));
    let verdict = page.split("<p class=\"verdict warn\">").nth(1).expect(&page);
    assert!(verdict.starts_with("The curve ") && verdict.contains("peak to peak. There are too few values"), "{page}");
}

/// The calibration gives the scale 1 ± 0.01, and the theory's lengths give 1.1.
#[test]
fn a_scale_that_contradicts_its_calibration_is_named() {
    let (times, values) = level();
    for (scale_error, expected) in [(0.01, 1), (0.1, 0)] {
        let mut document = theory("linear");
        let observed =
            observed(&mut document, "y", &times, &values.iter().map(|value| 1.1 * value).collect::<Vec<_>>());
        let record = Record { observations: vec![observed], scale_error: Some(scale_error), ..Record::default() };
        // Displacement, velocity and level are fixed, so that lengths determine the scale.
        let fit = fitted("linear", document, vec![record], |task| {
            task.parameters[1..4].copy_from_slice(&[0.042, -0.018, -0.003]);
            task.varied = [0, GAMMA].map(Varied::parameter).to_vec();
        });
        let page = texts(&html(&fit.report("en")));
        assert!(page.contains("(prior 1 ± "), "{page}");
        assert_eq!(page.matches("standard errors of the calibration away from 1").count(), expected, "{page}");
    }
}

/// Residuals of one quantity share one unit, regardless of their sizes.
#[test]
fn a_column_has_one_unit() {
    let (times, values) = level();
    let mut document = theory("linear");
    let rough: Vec<f64> =
        values.iter().enumerate().map(|(row, value)| value + 0.05 * libm::sin(2.0 * row as f64)).collect();
    let records = [("fine.txt", &values), ("rough.txt", &rough)]
        .map(|(name, values)| record(&mut document, name, &times, values));
    let fit = fitted("linear", document, records.to_vec(), |task| task.varied[0].shared = true);
    let page = texts(&html(&fit.report("en")));
    let sizes = &fit.outcome.observations;
    assert!(sizes[0].rmse < 0.01 && sizes[1].rmse > 0.03, "{} {}", sizes[0].rmse, sizes[1].rmse);
    let group = report::sizes(&fit.outcome, "y", Style::POINT);
    for one in sizes {
        assert!(page.contains(&group.quantity(one.rmse)), "{page}");
    }
}

/// A rounded number in a workbook is given in a unit without a power of ten.
#[test]
fn rounded_numbers_have_their_unit() {
    let fit = level_fitted();
    let mut book: calamine::Xlsx<_> =
        calamine::open_workbook_from_rs(std::io::Cursor::new(workbook(&fit.report("en")))).unwrap();
    let results = book.worksheet_range("Results").unwrap();
    let row = results.rows().find(|row| row[0] == Data::String("c".to_owned())).unwrap();
    let [unit, rounded] = [6, 7].map(|column| row[column].to_string());
    assert!(rounded.starts_with('−') && rounded.ends_with(&format!(") {unit}")), "{row:?}");
}

#[test]
fn quantities_need_no_power_of_ten() {
    let second = Unit::parse("s").unwrap();
    for (si, expected) in [(-974.53e-6, "−0.97453 ms"), (2.6667, "2.6667 s"), (0.0, "0 s")] {
        assert_eq!(quantity(si, &second, Style::POINT), expected);
    }
}

/// The ranking mentions residuals beyond the scale only if there are any.
#[test]
fn a_caption_says_what_is_not_drawn_where_there_is_such() {
    let (times, values) = level();
    let page = |until: Option<f64>| {
        let fit = |name: &str| {
            let mut document = theory(name);
            let record = record(&mut document, "swing.txt", &times, &values);
            fitted(name, document, vec![record], |task| task.until = until)
        };
        let fits = [fit("linear"), fit("quadratic")];
        let reports = fits.each_ref().map(|fit| fit.report("en"));
        texts(&ranking_html(&Ranking { theories: &reports, command: "" }))
    };
    assert!(!page(None).contains("What lies beyond it is not drawn."));
    assert!(page(Some(0.8)).contains("What lies beyond it is not drawn."));
}
