//! Read-out, zoom and pan: from pixels to values and back.

use figure::{Axis, Direction, Figure, Interval, Plot, Point, Series, Settings, View, layout};

struct Run {
    time: Vec<f64>,
    displacement: Vec<f64>,
    velocity: Vec<f64>,
}

fn run() -> Run {
    let time: Vec<f64> = (0..=200).map(|row| f64::from(row) / 20.0).collect();
    let displacement = time.iter().map(|t| 0.5 * libm::cos(1.67 * t)).collect();
    let velocity = time.iter().map(|t| -0.835 * libm::sin(1.67 * t)).collect();
    Run { time, displacement, velocity }
}

fn time_plot(run: &Run) -> Plot<'_> {
    Plot {
        x: Axis { label: "t", unit: "s", ..Axis::default() },
        y: vec![
            Axis { label: "y", unit: "m", ..Axis::default() },
            Axis { label: "y′", unit: "m/s", ..Axis::default() },
        ],
        series: vec![
            Series { label: "y", x: &run.time, y: &run.displacement, ..Series::default() },
            Series { label: "y′", axis: 1, colour: 1, x: &run.time, y: &run.velocity, ..Series::default() },
        ],
        ordered: true,
        ..Plot::default()
    }
}

fn phase_plot(run: &Run) -> Plot<'_> {
    Plot {
        x: Axis { label: "y", unit: "m", ..Axis::default() },
        y: vec![Axis { label: "y′", unit: "m/s", ..Axis::default() }],
        series: vec![Series { x: &run.displacement, y: &run.velocity, ..Series::default() }],
        ..Plot::default()
    }
}

fn settings() -> Settings {
    Settings { width: 640.0, height: 320.0, ..Settings::default() }
}

fn with_view<'a>(plot: &Plot<'a>, view: View) -> Plot<'a> {
    Plot { view, ..plot.clone() }
}

fn centre(figure: &Figure) -> Point {
    let panel = figure.panel;
    Point { x: panel.x + panel.width / 2.0, y: panel.y + panel.height / 2.0 }
}

fn close(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * one.abs().max(other.abs()).max(1.0)
}

#[test]
fn values_and_pixels_lead_back_and_forth() {
    let run = run();
    let figure = layout(&time_plot(&run), &settings());
    for scale in figure.y_scales().iter().chain(figure.x_scale()) {
        for step in 0..=100 {
            let value = scale.values.low + scale.values.length() * f64::from(step) / 100.0;
            assert!(close(scale.value(scale.pixel(value)), value));
        }
        assert!(close(scale.pixel(scale.values.low), scale.low) && close(scale.pixel(scale.values.high), scale.high));
    }
}

#[test]
fn hovering_a_time_plot_reads_all_series_at_the_nearest_sample() {
    let run = run();
    let plot = time_plot(&run);
    let figure = layout(&plot, &settings());
    let x = figure.x_scale().unwrap();
    // A little to the right of row 100, t = 5 s; anywhere above or below.
    let at = Point { x: x.pixel(5.02) as f32, y: figure.panel.y + 3.0 };
    let readout = figure.hover(&plot, at).unwrap();
    assert_eq!(readout.heading, "t = 5.000\u{a0}s");
    let texts: Vec<&str> = readout.samples.iter().map(|sample| sample.text.as_str()).collect();
    assert_eq!(texts, ["y = −0.2380\u{a0}m", "y′ = −0.7344\u{a0}m/s"]);
    assert!(readout.samples.iter().all(|sample| sample.row == 100 && sample.x == 5.0));
    assert_eq!(readout.samples[0].at.y, figure.y_scales()[0].pixel(run.displacement[100]) as f32);
    // Outside the panel there is no read-out.
    assert_eq!(figure.hover(&plot, Point { x: 1.0, y: 1.0 }), None);
}

#[test]
fn a_series_that_has_ended_is_not_read() {
    let run = run();
    let mut plot = time_plot(&run);
    plot.series[1].x = &run.time[..50];
    let figure = layout(&plot, &settings());
    let at = |t| Point { x: figure.x_scale().unwrap().pixel(t) as f32, y: centre(&figure).y };
    assert_eq!(figure.hover(&plot, at(1.0)).unwrap().samples.len(), 2);
    assert_eq!(figure.hover(&plot, at(8.0)).unwrap().samples.len(), 1);
}

#[test]
fn hovering_a_phase_portrait_reads_the_nearest_point() {
    let run = run();
    let plot = phase_plot(&run);
    let figure = layout(&plot, &settings());
    let row = 33;
    let (x, y) = (figure.x_scale().unwrap(), figure.y_scales()[0]);
    let at = Point { x: x.pixel(run.displacement[row]) as f32 + 2.0, y: y.pixel(run.velocity[row]) as f32 };
    let readout = figure.hover(&plot, at).unwrap();
    assert_eq!(readout.samples.len(), 1);
    let sample = &readout.samples[0];
    let distance = |row: usize| {
        let (right, down) =
            (x.pixel(run.displacement[row]) - f64::from(at.x), y.pixel(run.velocity[row]) - f64::from(at.y));
        right * right + down * down
    };
    assert!((0..=200).all(|other| distance(sample.row) <= distance(other)));
    // The centre of the ellipse is far from every point.
    assert_eq!(figure.hover(&plot, Point { x: x.pixel(0.0) as f32, y: y.pixel(0.0) as f32 }), None);
}

#[test]
fn the_cursor_steps_over_what_cannot_be_drawn() {
    let mut run = run();
    run.displacement[5] = f64::NAN;
    let plot = time_plot(&run);
    let figure = layout(&plot, &settings());
    let cases = [
        (4, 1, Some(6)),
        (6, -1, Some(4)),
        (0, -1, Some(0)),
        (0, 10, Some(11)),
        (195, 100, Some(200)),
        (9999, 0, Some(200)),
    ];
    for (row, rows, expected) in cases {
        assert_eq!(figure.step(&plot, 0, row, rows), expected, "{row} by {rows}");
    }
    assert_eq!(figure.step(&plot, 7, 0, 1), None);
    assert_eq!(figure.readout(&plot, 0, 20).unwrap().heading, "t = 1.000\u{a0}s");
    assert_eq!(figure.readout(&plot, 0, 5), None);
    // In a zoomed view the cursor stays in the panel.
    let zoomed = with_view(&plot, View { x: Some(Interval { low: 2.0, high: 3.0 }), y: vec![] });
    let figure = layout(&zoomed, &settings());
    assert_eq!(figure.step(&zoomed, 0, 60, 5), Some(60));
    assert_eq!(figure.step(&zoomed, 0, 0, 1), Some(40));
}

#[test]
fn the_cursor_reads_both_rows_of_a_jump() {
    let (time, velocity) = ([0.0, 1.0, 1.0, 2.0], [0.0, -4.0, 3.0, 0.0]);
    let plot = Plot {
        y: vec![Axis { label: "v", unit: "m/s", ..Axis::default() }],
        series: vec![Series { x: &time, y: &velocity, breaks: &[2], ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings());
    let text = |row| figure.readout(&plot, 0, row).unwrap().samples[0].text.clone();
    assert_eq!((text(1), text(2)), ("v = −4.000\u{a0}m/s".to_owned(), "v = 3.000\u{a0}m/s".to_owned()));
}

#[test]
fn zooming_keeps_the_value_under_the_pointer() {
    let run = run();
    let plot = time_plot(&run);
    let figure = layout(&plot, &settings());
    let at = Point { x: figure.panel.x + 100.0, y: figure.panel.y + 30.0 };
    let view = figure.zoom(at, 2.0, Direction::Both);
    let zoomed = layout(&with_view(&plot, view.clone()), &settings());
    // The panel may move a little, since the labels are longer: compare places within the panel.
    let part = |figure: &Figure, scale: &figure::Scale, value: f64| {
        let _ = figure;
        (scale.pixel(value) - scale.low) / (scale.high - scale.low)
    };
    let pairs = figure.y_scales().iter().zip(zoomed.y_scales());
    for (before, after) in pairs.chain(figure.x_scale().into_iter().zip(zoomed.x_scale())) {
        let horizontal = before.low < before.high;
        let value = before.value(f64::from(if horizontal { at.x } else { at.y }));
        assert!(close(part(&figure, before, value), part(&zoomed, after, value)));
        assert!(close(after.values.length() * 2.0, before.values.length()));
    }
    // Zooming out about the same values restores the view.
    let back = zoomed.zoom(
        Point {
            x: zoomed.x_scale().unwrap().pixel(figure.x_scale().unwrap().value(f64::from(at.x))) as f32,
            y: zoomed.y_scales()[0].pixel(figure.y_scales()[0].value(f64::from(at.y))) as f32,
        },
        0.5,
        Direction::Both,
    );
    let limits = back.x.unwrap();
    assert!((limits.low - figure.x_scale().unwrap().values.low).abs() < 1e-4);
    assert!((limits.high - figure.x_scale().unwrap().values.high).abs() < 1e-4);
    // The direction that is not zoomed stays automatic.
    assert!(figure.zoom_centre(2.0, Direction::Horizontal).y.is_empty());
    assert!(figure.zoom_centre(2.0, Direction::Vertical).x.is_none());
}

#[test]
fn a_rectangle_becomes_the_view() {
    let run = run();
    let plot = time_plot(&run);
    let figure = layout(&plot, &settings());
    let (x, y) = (figure.x_scale().unwrap(), figure.y_scales()[0]);
    let corner = |t: f64, value: f64| Point { x: x.pixel(t) as f32, y: y.pixel(value) as f32 };
    let view = figure.zoom_to(corner(4.0, 0.3), corner(2.0, -0.1));
    let limits = view.x.unwrap();
    assert!((limits.low - 2.0).abs() < 1e-5 && (limits.high - 4.0).abs() < 1e-5);
    assert!((view.y[0].low + 0.1).abs() < 1e-5 && (view.y[0].high - 0.3).abs() < 1e-5);
    assert_eq!(view.y.len(), 2);
    // A flat rectangle zooms along the time only, a click is no rectangle, and one beyond the panel ends at its edge.
    assert!(figure.zoom_to(corner(4.0, 0.3), corner(2.0, 0.3)).y.is_empty());
    assert!(figure.zoom_to(corner(4.0, 0.3), corner(4.0, 0.3)).is_automatic());
    let beyond = figure.zoom_to(corner(5.0, 0.3), Point { x: 1e6, y: 1e6 });
    assert!(close(beyond.x.unwrap().high, 10.0));
}

#[test]
fn panning_moves_with_the_pointer_and_not_out_of_sight() {
    let run = run();
    let plot = time_plot(&run);
    let figure = layout(&plot, &settings());
    let x = figure.x_scale().unwrap();
    let per_second = x.pixel(1.0) - x.pixel(0.0);
    let view = figure.pan(2.0 * per_second, 0.0);
    assert!(close(view.x.unwrap().low, -2.0) && close(view.x.unwrap().high, 8.0));
    assert!(view.y.is_empty());
    let far = figure.pan(1e9, -1e9);
    let limits = far.x.unwrap();
    assert!(limits.high >= 1.0 - 1e-9 && limits.high <= 10.0, "{limits:?}");
    assert!(figure.pan(0.0, 0.0).is_automatic());
}

#[test]
fn zooming_ends_where_nothing_can_be_told_apart() {
    let run = run();
    let plot = time_plot(&run);
    for factor in [1.7, 1e-3, 1e6, 0.5, f64::NAN, 0.0, -1.0, f64::INFINITY] {
        let mut view = View::default();
        for _ in 0..300 {
            let figure = layout(&with_view(&plot, view.clone()), &settings());
            view = figure.zoom(Point { x: 333.3, y: 111.1 }, factor, Direction::Both);
        }
        let figure = layout(&with_view(&plot, view.clone()), &settings());
        for scale in figure.y_scales().iter().chain(figure.x_scale()) {
            let length = scale.values.length();
            assert!(length > 1e-10 && length < 2e3, "{factor}: {:?}", scale.values);
        }
    }
}
