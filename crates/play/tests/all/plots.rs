//! What a document can draw: several paths in one plot, and what is said of them.

use crate::support::{go_on, open};
use figure::{Point, Settings};
use play::{Play, PlotId};

/// Two bodies on circles about one another, with equal axes.
fn bodies() -> Play {
    open(
        "```model\nparameter omega = 2 [rad/s]\nx_1 = cos(omega*t)\ny_1 = sin(omega*t)\nx_2 = -2*x_1\n\
         y_2 = -2*y_1 \"Height of the second\"\n```\n\
         ```plots\n\"Bodies\": y_1 \"Height\" against x_1, y_2 against x_2, equal axes\n\"Time\": x_1, x_2 against t\n```\n",
        &[],
    )
}

const SETTINGS: Settings = Settings { width: 640.0, height: 360.0, font_size: 13.0, decimal_comma: false };

#[test]
fn each_curve_is_drawn_against_its_own_abscissa() {
    let mut play = bodies();
    go_on(&mut play, [1.0]);
    let csv = play.plot_csv(PlotId::at(0));
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("x₁,y₁,x₂,y₂"));
    let mut rows = 0;
    for line in lines {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        for (x, y, radius) in [(row[0], row[1], 1.0), (row[2], row[3], 2.0)] {
            assert!((x.hypot(y) - radius).abs() < 1e-12, "{line}");
        }
        rows += 1;
    }
    assert_eq!(rows, 21, "1 s in steps of 0.05 s");
}

#[test]
fn equal_axes_keep_a_circle_round_and_readings_name_the_abscissa() {
    let mut play = bodies();
    go_on(&mut play, [3.2]);
    let figure = play.layout_plot(PlotId::at(0), &SETTINGS).unwrap();
    let at = |x: f64, y: f64| figure.place(0, x, y).unwrap();
    let (centre, right, above) = (at(0.0, 0.0), at(2.0, 0.0), at(0.0, 2.0));
    assert!(((right.x - centre.x) - (centre.y - above.y)).abs() < 0.5, "{centre:?} {right:?} {above:?}");
    let headings: Vec<String> = [at(1.0, 0.0), at(-2.0, 0.0)]
        .into_iter()
        .map(|at| play.hover_plot(PlotId::at(0), Point { x: at.x, y: at.y }).unwrap().heading)
        .collect();
    assert!(headings[0].starts_with("x₁ = ") && headings[1].starts_with("x₂ = "), "{headings:?}");
    let svg = play.plot_svg(PlotId::at(0), &SETTINGS, &figure::Palette::LIGHT);
    let described = "Bodies: Height (y₁) against x₁. Height of the second (y₂) against x₂.";
    assert!(svg.contains(described), "{svg}");
    assert!(svg.contains("x₁, x₂"), "the axis names both");
}
