//! Straight lines through results of groups.

use analysis::virtual_record::Chance;
use class::against::{Line, Point, line};
use class::pooling::Measured;

fn points(rows: &[(f64, f64, f64)]) -> Vec<Point> {
    rows.iter().map(|&(x, value, error)| Point { x, measured: Measured { value, error } }).collect()
}

fn numbers(line: &Line) -> [f64; 5] {
    [line.slope, line.slope_error, line.intercept, line.intercept_error, line.tau]
}

/// Slope, its error, intercept, its error, tau.
const SCATTERED: [f64; 5] = [0.877_355_010, 0.370_093_673, 0.692_012_407, 0.204_622_505, 0.467_742_714];
const SMOOTH: [f64; 5] = [1.983_431_953, 0.107_141_448, 0.103_550_296, 0.277_776_463, 0.0];

/// Meta-regression (in R's metafor `rma(yi, vi, mods = ~ xi, method = "PM", test = "adhoc")`), computed from its definition
/// with SciPy: data of Jackson, Turner, Rhodes and Viechtbauer (BMC Med. Res. Methodol. 14 (2014) 103), and a line with
/// less scatter than its errors.
#[test]
fn slopes_and_errors_are_those_of_the_definitions() {
    let values = [
        0.0267, 0.8242, 0.3930, 2.4405, 2.1401, 1.2528, 2.4849, 0.3087, 1.4246, 0.1823, 1.1378, 1.2321, 2.0695, 4.0237,
        1.4383, 1.6021,
    ];
    let variances: [f64; 16] = [
        0.1285, 0.0315, 0.0931, 2.0967, 1.0539, 0.1602, 1.0235, 0.0218, 0.5277, 0.0556, 0.3304, 0.1721, 0.4901, 2.0200,
        0.3399, 0.1830,
    ];
    let rows: Vec<(f64, f64, f64)> =
        (0..16).map(|row| (if row < 10 { 0.0 } else { 1.0 }, values[row], variances[row].sqrt())).collect();
    let scattered = line(&points(&rows)).unwrap();
    let smooth = line(&points(&[(1.0, 2.1, 0.2), (2.0, 3.9, 0.4), (3.0, 6.1, 0.2), (4.0, 8.0, 0.3)])).unwrap();
    let cases = [(scattered, SCATTERED), (smooth, SMOOTH)];
    for (found, expected) in cases {
        for (found, expected) in numbers(&found).into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-6 * expected.abs().max(1.0), "{found} {expected}");
        }
    }
    // Student's quantile with 14 degrees of freedom; that of the normal distribution, because four results on a line by
    // chance have hardly any scatter.
    let reach = |line: &Line| (line.slope_interval.1 - line.slope) / line.slope_error;
    assert!((reach(&scattered) - 2.144_787).abs() < 1e-5, "{scattered:?}");
    assert!((reach(&smooth) - 1.959_964).abs() < 1e-5, "{smooth:?}");
}

/// The interval of the slope holds in 95 % of 1,000 classes, whether the errors are all or the groups differ.
#[test]
fn the_interval_of_a_slope_holds() {
    for (groups, tau) in [(6, 0.0), (6, 2.0), (30, 0.0), (30, 2.0)] {
        let mut chance = Chance::new(groups + 7);
        let mut held = 0;
        for _ in 0..1000 {
            let point = |group: u64| {
                let (one, other) = chance.normals();
                let (x, error) = ((group % 3) as f64, 0.5 + chance.uniform());
                Point { x, measured: Measured { value: 4.0 + 3.0 * x + error * one + tau * other, error } }
            };
            let found = line(&(0..groups).map(point).collect::<Vec<_>>()).unwrap();
            held += u32::from(found.slope_interval.0 <= 3.0 && 3.0 <= found.slope_interval.1);
        }
        println!("{groups} groups, tau = {tau}: {} %", f64::from(held) / 10.0);
        assert!((930..=995).contains(&held), "{groups} {tau}: {held}");
    }
}

#[test]
fn points_without_a_line_are_refused_with_the_reason() {
    let cases: [(&[(f64, f64, f64)], &str); 6] = [
        (&[(1.0, 1.0, 1.0), (2.0, 2.0, 1.0)], "three groups at least"),
        (&[(1.0, 1.0, 1.0), (1.0, 2.0, 1.0), (1.0, 3.0, 1.0)], "same value of the parameter"),
        (&[(1.0, 1.0, 1.0), (f64::NAN, 2.0, 1.0), (3.0, 3.0, 1.0)], "parameter of result 2"),
        (&[(1.0, 1.0, 1.0), (1e200, 2.0, 1.0), (3.0, 3.0, 1.0)], "parameter of result 2"),
        (&[(1.0, 1.0, 0.0), (2.0, 2.0, 1.0), (3.0, 3.0, 1.0)], "result 1 has no standard error"),
        (&[(1e-200, 1.0, 1.0), (2e-200, 2.0, 1.0), (3e-200, 3.0, 1.0)], "too close to each other"),
    ];
    for (rows, expected) in cases {
        let refused = line(&points(rows)).unwrap_err();
        assert!(refused.english.contains(expected), "{refused:?}");
    }
}
