//! Columns that count cycles beside quantities that count angles, and the reverse.

use crate::support::open;
use play::PlotId;
use std::f64::consts::TAU;

/// Units with their factors to turns per second.
const UNITS: [(&str, f64); 5] =
    [("Hz", 1.0), ("kHz", 1e3), ("rad/s", 1.0 / TAU), ("deg/s", 1.0 / 360.0), ("rpm", 1.0 / 60.0)];

#[track_caller]
fn same(found: f64, expected: f64, what: &str) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{what}: {found}, not {expected}");
}

#[test]
fn records_are_drawn_and_fitted_in_the_kind_of_the_quantity() {
    for (own, turns) in UNITS {
        let shown = if own == "rpm" { "Hz" } else { "rpm" };
        let text = format!(
            "---\ntitle: Turns\nuntil: 5 [s]\nvary: w\n---\n\n```model\nparameter w = 1 [{own}] in 0..100000\n\
             x' = 0*x/(1 [s])\nx(0) = 1\nq = w\n```\n\n```plots\n\"Own\": q against t\n\"Other\": q in [{shown}] against t\n```\n"
        );
        for (unit, column) in UNITS {
            let what = format!("a column in {unit} for {own}");
            let mut desk = open(&text, &[]);
            let rows = [1.5, 1.51, 1.49, 1.5]
                .iter()
                .zip(0..)
                .map(|(value, time)| format!("{time},{},{}\n", value / column, 0.01 / column));
            let data = format!("t [s],q [{unit}],sigma_q [{unit}]\n{}", rows.collect::<String>());
            desk.add_record("a", data.as_bytes()).unwrap();
            let curves = desk.measured().curves(desk.play());
            let [curve] = curves.as_slice() else { panic!("{what}: {curves:?}") };
            same(curve.values[1], 1.51 / turns_of(&curve.quantity.unit), &what);
            for plot in [0, 1] {
                assert_eq!(desk.play().plots().legend(PlotId::at(plot)).len(), 2, "{what}, plot {plot}");
            }
            desk.change_fits(|fits, data| fits.begin(data, "turns.md")).unwrap();
            while desk.advance_fit() {}
            let last = desk.fits().list().iter().map(|fit| fit.id).max().unwrap();
            let index = crate::support::parameter(&desk, "w");
            desk.apply_fit(last);
            let fitted = desk.play().course().parameters()[index];
            same(desk.play().model().parameters[index].unit.from_si(fitted), 1.5 / turns, &what);
        }
    }
}

/// Turns per second of one unit.
fn turns_of(unit: &str) -> f64 {
    UNITS.iter().find(|(text, _)| *text == unit).unwrap().1
}
