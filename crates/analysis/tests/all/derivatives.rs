//! Steps in time, finite differences and smoothing polynomials.

use crate::support::{Noise, utube_bytes};
use analysis::derivative::Differentiation;
use analysis::import;
use analysis::inspection::inspect;
use analysis::sampling::{Gap, examine};
use analysis::smoothing::{WIDEST, savitzky_golay};
use analysis::stencil::{Stencil, differentiate, recognise};
use units::Language;

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn measured_records_say_what_they_hide() {
    let step =
        "the time step 0.033333 s looks like 1/30 s rounded: times are too short by 0.001 %, frequencies too high";
    let velocity = "column 3 was computed from column 2, (x[i+1] − x[i−1])/(2 Δt): it adds no independent information; at the frequency of this record that makes it too small by ";
    let acceleration = "column 4 was computed from column 2, (2 x[i+2] − x[i+1] − 2 x[i] − x[i−1] + 2 x[i−2])/(7 Δt²): it adds no independent information; at the frequency of this record that makes it too small by ";
    for (name, gap, first, second) in [
        ("U1", None, "2.1 %", "4.5 %"),
        ("U2", None, "2 %", "4.4 %"),
        ("U3", Some("6 frames are missing: 16 to 21 (between 0.499995 s and 0.733326 s)"), "1.7 %", "3.7 %"),
        ("U4", None, "1.7 %", "3.7 %"),
    ] {
        let bytes = utube_bytes(name);
        let found = inspect(&import::text(&bytes).expect("a table").table);
        let texts: Vec<String> = found.findings.iter().map(|finding| finding.text(Language::English)).collect();
        let mut expected: Vec<String> = gap.iter().map(|gap| (*gap).to_owned()).collect();
        expected.extend([step.to_owned(), format!("{velocity}{first}"), format!("{acceleration}{second}")]);
        assert_eq!(texts, expected, "{name}");
        let spanish = found.findings.last().expect("a finding").text(catalogues::with(Language::Spanish));
        assert!(spanish.starts_with("la columna 4 se calculó a partir de la columna 2, (2 x[i+2]"), "{spanish}");
        assert!(spanish.ends_with(&format!("un {} demasiado pequeña", second.replace('.', ","))), "{spanish}");
        let pairs: Vec<(usize, usize, Stencil)> =
            found.derived.iter().map(|derived| (derived.column, derived.of, derived.recognised.stencil)).collect();
        assert_eq!(pairs, [(2, 1, Stencil::Central), (3, 1, Stencil::FivePoint)]);
        assert!(found.derived.iter().all(|derived| derived.recognised.share > 0.99), "{:?}", found.derived);
    }
}

#[test]
fn steps_are_examined() {
    let even = |rows: usize, step: f64| -> Vec<f64> { (0..rows).map(|row| row as f64 * step).collect() };
    let found = examine(&even(100, 0.04));
    assert_eq!((found.missing.len(), found.rounded_to, found.rate), (0, None, None));
    assert!(found.jitter < 1e-9 && (found.interval - 0.04).abs() < 1e-12);

    // Rounding errors in the last digit are neither jitter nor rounding.
    let found = examine(&even(100, 0.033_333_333_333_332_12));
    assert_eq!((found.rounded_to, found.rate), (None, None));
    assert_eq!(found.findings(&[], "s"), []);

    let rounded: Vec<f64> = even(100, 1.0 / 30.0).iter().map(|time| (time * 1e3).round() / 1e3).collect();
    let found = examine(&rounded);
    assert_eq!(found.findings(&rounded, "s")[0].text(Language::English), "the times are rounded to 0.001 s");
    assert_eq!(
        found.findings(&rounded, "s")[0].text(catalogues::with(Language::Spanish)),
        "los tiempos están redondeados a 0,001 s"
    );
    assert_eq!(found.findings(&rounded, "s").len(), 1);

    for (step, rate) in [
        (0.0333, 30.0),
        (0.0334, 30000.0 / 1001.0),
        (0.0167, 60.0),
        (0.041_667, 24.0),
        (0.04, 0.0),
        (0.02, 0.0),
        (0.005, 0.0),
    ] {
        assert_eq!(examine(&even(50, step)).rate.unwrap_or(0.0), rate, "{step}");
    }

    let mut times = even(50, 0.1);
    times.remove(30);
    times.drain(10..13);
    times.insert(5, times[5]);
    times.push(4.0);
    let found = examine(&times);
    let gaps: Vec<(u64, u64)> = found.missing.iter().map(|gap| (gap.first, gap.last)).collect();
    assert_eq!(gaps, [(10, 12), (30, 30)]);
    assert_eq!((found.doubled, found.backwards), (vec![6], vec![times.len() - 1]));

    let mut random = Noise::new(1);
    let shaken: Vec<f64> = even(200, 0.1).iter().map(|time| time + 0.002 * random.normal()).collect();
    let found = examine(&shaken);
    assert!((found.jitter - 0.028).abs() < 0.005, "{}", found.jitter);
    assert!(
        found.findings(&shaken, "s")[0].text(Language::English).starts_with("the rows are unevenly spaced"),
        "{found:?}"
    );

    let logarithmic: Vec<f64> = (0..50).map(|row| libm::exp(0.1 * f64::from(row))).collect();
    let found = examine(&logarithmic);
    assert!(found.missing.is_empty() && found.frames.is_empty() && found.jitter > 0.5);
    for few in [&[][..], &[1.0], &[1.0, 2.0], &[1.0, 1.0, 1.0], &[f64::NAN; 9]] {
        assert_eq!(examine(few).interval, 0.0);
    }
}

#[test]
fn frames_count_from_time_zero_where_they_can() {
    let found = examine(&[0.2, 0.3, 0.6, 0.7]);
    assert_eq!(found.missing, [Gap { first: 4, last: 5, after: 0.3, before: 0.6 }]);
    let found = examine(&[0.25, 0.35, 0.65, 0.75]);
    assert_eq!(found.missing, [Gap { first: 2, last: 3, after: 0.35, before: 0.65 }]);
    // Frames of a record that begins before time 0 count from its first row.
    let found = examine(&[-0.4, -0.3, -0.2, 0.1, 0.2]);
    assert_eq!(found.missing, [Gap { first: 3, last: 4, after: -0.2, before: 0.1 }]);
}

/// A typing error in one time makes a gap of more frames than a number can count.
#[test]
fn frames_without_end_are_not_counted() {
    for wild in [1.7e65, -1e300, 1e16] {
        let mut times: Vec<f64> = (0..100).map(|row| 0.1 * f64::from(row)).collect();
        times[50] = wild;
        let found = examine(&times);
        assert!(found.missing.is_empty() && found.frames.is_empty(), "{wild}: {found:?}");
        assert!(!found.findings(&times, "s").is_empty());
    }
    // Times that go forth and back have no gaps.
    let times: Vec<f64> = [0.0, 1.0, 2.0, 8e15].repeat(3000);
    let findings = examine(&times).findings(&times, "s");
    assert!(findings[0].text(Language::English).contains("2999 are earlier than the row before"), "{findings:?}");
}

fn rounded(values: Vec<f64>, decimals: usize) -> Vec<f64> {
    values
        .into_iter()
        .map(|value| if value.is_nan() { value } else { format!("{value:.decimals$}").parse().expect("a number") })
        .collect()
}

#[test]
fn every_stencil_is_recognised_after_rounding_with_gaps_and_in_other_units() {
    let mut random = Noise::new(2);
    let mut times: Vec<f64> = (0..120).map(|row| f64::from(row) / 30.0).collect();
    times.drain(40..44);
    let position: Vec<f64> =
        times.iter().map(|t| 5.0 * libm::exp(-0.3 * t) * libm::cos(9.6 * t) + 0.02 * random.normal()).collect();
    for decimals in [2, 4, 9] {
        let position = rounded(position.clone(), decimals);
        for stencil in Stencil::ALL {
            for scale in [1.0, 0.01, 1000.0] {
                let exact: Vec<f64> =
                    differentiate(&times, &position, stencil).iter().map(|value| value * scale).collect();
                let column = rounded(exact, decimals + 2);
                let found = recognise(&times, &position, &column).unwrap_or_else(|| panic!("{stencil:?} {decimals}"));
                assert_eq!((found.stencil, found.order, found.scale), (stencil, stencil.order(), scale), "{decimals}");
                assert_eq!(found.share, 1.0, "{stencil:?} {decimals} {scale}");
            }
        }
    }
    let velocity = differentiate(&times, &position, Stencil::Central);
    let acceleration = differentiate(&times, &velocity, Stencil::Central);
    assert_eq!(
        recognise(&times, &velocity, &acceleration).map(|found| (found.stencil, found.order)),
        Some((Stencil::Central, 1))
    );
    assert_eq!(recognise(&times, &position, &acceleration), None);
}

#[test]
fn what_was_measured_by_itself_is_not_taken_for_a_difference() {
    let mut random = Noise::new(4);
    let times: Vec<f64> = (0..200).map(|row| f64::from(row) / 100.0).collect();
    let position: Vec<f64> = times.iter().map(|t| libm::cos(6.0 * t)).collect();
    let exact: Vec<f64> = times.iter().map(|t| -6.0 * libm::sin(6.0 * t)).collect();
    let noisy: Vec<f64> = exact.iter().map(|v| v + 0.05 * random.normal()).collect();
    for column in [&exact, &noisy, &position, &times, &vec![0.0; 200], &vec![f64::NAN; 200]] {
        assert_eq!(recognise(&times, &position, column), None);
    }
    assert_eq!(recognise(&times, &rounded(position.clone(), 1), &rounded(exact.clone(), 1)), None);
}

#[test]
fn the_attenuation_is_that_of_a_sinusoid() {
    let (omega, step) = (9.6, 1.0 / 30.0);
    let times: Vec<f64> = (0..60).map(|row| f64::from(row) * step).collect();
    let wave = |phase: f64| -> Vec<f64> { times.iter().map(|t| libm::sin(omega * t + phase)).collect() };
    let largest = |values: Vec<f64>| values.into_iter().filter(|value| value.is_finite()).fold(0.0, f64::max);
    for stencil in Stencil::ALL {
        let over_phases = (0..100).map(|phase| largest(differentiate(&times, &wave(f64::from(phase) * 0.07), stencil)));
        let scale = if stencil.order() == 1 { omega } else { omega * omega };
        let found = over_phases.fold(0.0, f64::max) / scale;
        assert!((found - stencil.attenuation(omega * step)).abs() < 1e-5, "{stencil:?}: {found}");
        assert_eq!(stencil.attenuation(0.0), 1.0);
    }
}

#[test]
fn differences_stop_at_gaps() {
    let times = [0.0, 0.1, 0.2, 0.3, 0.6, 0.7, 0.8];
    let velocity = differentiate(&times, &times, Stencil::Central);
    let is_nan: Vec<bool> = velocity.iter().map(|value| value.is_nan()).collect();
    assert_eq!(is_nan, [true, false, false, true, true, false, true]);
    assert!(velocity.iter().filter(|value| !value.is_nan()).all(|value| (value - 1.0).abs() < 1e-12));
}

#[test]
fn a_smoothing_polynomial_reproduces_polynomials() {
    let mut random = Noise::new(9);
    let mut times: Vec<f64> = (0..60).map(|row| 0.1 * f64::from(row) + 0.02 * random.uniform()).collect();
    times.drain(20..30);
    let of = |f: &dyn Fn(f64) -> f64| -> Vec<f64> { times.iter().map(|t| f(*t)).collect() };
    let values = of(&|t| 2.0 - 3.0 * t + 0.5 * t * t - 0.1 * t * t * t);
    let derivatives = [values.clone(), of(&|t| -3.0 + t - 0.3 * t * t), of(&|t| 1.0 - 0.6 * t), of(&|_| -0.6)];
    for (derivative, expected) in derivatives.iter().enumerate() {
        for (window, degree) in [(7, 3), (5, 4), (11, 5), (6, 3), (201, 3)] {
            let smooth = savitzky_golay(&times, &values, window, degree, derivative);
            for (found, expected) in smooth.iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-6 * (1.0 + expected.abs()),
                    "{derivative} {window} {degree}: {found} {expected}"
                );
            }
        }
    }
}

/// Published coefficients for five points, and the treatment of ends and gaps.
#[test]
fn a_smoothing_polynomial_has_the_published_coefficients() {
    let times: Vec<f64> = (0..9).map(f64::from).collect();
    let mut values = vec![0.0; 9];
    for (place, coefficient) in [(2, -3.0), (3, 12.0), (4, 17.0), (5, 12.0), (6, -3.0)] {
        values.fill(0.0);
        values[place] = 1.0;
        let found = savitzky_golay(&times, &values, 5, 2, 0)[4];
        assert!((found - coefficient / 35.0).abs() < 1e-14, "{place}: {found}");
        let slope = savitzky_golay(&times, &values, 5, 2, 1)[4];
        assert!((slope - (place as f64 - 4.0) / 10.0).abs() < 1e-14, "{place}: {slope}");
    }
    values[4] = f64::NAN;
    let smooth = savitzky_golay(&times, &values, 5, 2, 0);
    assert!(smooth.iter().enumerate().all(|(row, value)| value.is_nan() == (row == 4)), "{smooth:?}");
    for (window, degree, derivative) in [(3, 3, 0), (5, 2, 3), (20, 8, 0)] {
        assert!(savitzky_golay(&times, &values, window, degree, derivative).iter().all(|value| value.is_nan()));
    }
}

/// Even steps share one polynomial; slightly uneven steps, with one polynomial per row, give the same result.
#[test]
fn even_steps_are_smoothed_as_uneven_ones() {
    let mut random = Noise::new(9);
    let values: Vec<f64> = (0..60).map(|row| libm::sin(0.2 * f64::from(row)) + 0.1 * random.normal()).collect();
    let even: Vec<f64> = (0..60).map(|row| 3.0 + 0.1 * f64::from(row)).collect();
    let mut uneven = even.clone();
    uneven[30] += 1e-6;
    for (window, degree) in [(5, 2), (9, 3), (21, 7)] {
        for derivative in 0..3 {
            let one = savitzky_golay(&even, &values, window, degree, derivative);
            let other = savitzky_golay(&uneven, &values, window, degree, derivative);
            for (one, other) in one.iter().zip(&other) {
                assert!(
                    (one - other).abs() < 1e-3 * (1.0 + other.abs()),
                    "{window} {degree} {derivative}: {one} {other}"
                );
            }
        }
    }
}

/// A window as wide as the record would take hours: it is refused at once, like an even number of rows.
#[test]
fn windows_are_bounded() {
    let rows = 100_000;
    let times: Vec<f64> = (0..rows).map(|row| f64::from(row) / 100.0).collect();
    let values: Vec<f64> = times.iter().map(|time| libm::sin(*time)).collect();
    for window in [WIDEST + 2, 100_001] {
        assert!(!Differentiation::Smooth { window, degree: 3 }.is_possible());
        assert_eq!(Differentiation::from_code(&format!("smooth-{window}-3")), None);
        assert!(savitzky_golay(&times, &values, window, 3, 1).iter().all(|value| value.is_nan()));
    }
    // The widest window follows a slower signal.
    assert!(Differentiation::Smooth { window: WIDEST, degree: 7 }.is_possible());
    let slope = savitzky_golay(&times, &values, WIDEST, 7, 1);
    assert!((slope[50_000] - libm::cos(500.0)).abs() < 1e-4, "{} {}", slope[50_000], libm::cos(500.0));
}

#[test]
fn a_resampled_film_is_noticed_in_its_file() {
    // 27 pictures a second written at 30: every tenth row repeats the row before.
    let row = |frame: usize| {
        let time = f64::from((frame * 27 / 30) as u32) / 27.0;
        format!("{:.4};{:.3};{:.3}\n", frame as f64 / 30.0, 30.0 * libm::cos(4.1 * time), 20.0 * libm::sin(4.1 * time))
    };
    let text: String = std::iter::once("t [s];x [cm];y [cm]\n".to_owned()).chain((0..90).map(row)).collect();
    let table = import::text(text.as_bytes()).expect("a table").table;
    let findings: Vec<String> =
        inspect(&table).findings.iter().map(|finding| finding.text(Language::English)).collect();
    let repeated = "9 of 90 rows repeat the value of x, y in the row before, at regular distances, as a film does that was converted to another frame rate: their times are wrong; leave these rows out, or use the original film";
    assert_eq!(findings, ["the times are rounded to 0.0001 s", repeated]);
}
