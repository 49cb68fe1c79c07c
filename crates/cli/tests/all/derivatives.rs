//! `meniscus derivatives` on the command line.

use crate::common::meniscus;
use crate::fit::word;

#[test]
fn derivatives_are_exact_for_a_parabola() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("fall.txt");
    // y = 5 t^2 in cm at 10 rows per second with one row missing. Both methods are exact for a parabola.
    let row = |frame: u32| format!("{:.1}\t{:.2}\n", f64::from(frame) / 10.0, 0.05 * f64::from(frame * frame));
    let rows: String = (0..12).filter(|frame| *frame != 7).map(row).collect();
    std::fs::write(&path, format!("t [s]\ty [cm]\n{rows}")).unwrap();
    let table = |words: &[&str]| {
        let done = meniscus(&[&["derivatives", word(&path), "--observe", "y"], words].concat());
        assert_eq!(done.code, 0, "{}", done.stderr);
        let mut lines = done.stdout.lines().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(lines.remove(0), "t [s],y [cm],y' [cm/s],y'' [cm/s^2]");
        let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
        lines.iter().map(|line| line.split(',').map(number).collect()).collect::<Vec<Vec<f64>>>()
    };
    let near = |found: f64, truth: f64| (found - truth).abs() < 1e-9;
    for (place, row) in table(&[]).iter().enumerate() {
        // Rows beside the missing one and at the ends lack a neighbour.
        assert_eq!(row[2].is_nan(), [0, 6, 7, 10].contains(&place), "{row:?}");
        assert!(row[2].is_nan() || near(row[2], 10.0 * row[0]), "{row:?}");
        assert!(row[3].is_nan() || near(row[3], 10.0), "{row:?}");
    }
    for row in table(&["--smooth", "5"]) {
        assert!(near(row[1], 5.0 * row[0] * row[0]) && near(row[2], 10.0 * row[0]) && near(row[3], 10.0), "{row:?}");
    }
    assert_eq!(meniscus(&["derivatives", word(&path), "--observe", "y", "--smooth", "4"]).code, 2);
}
