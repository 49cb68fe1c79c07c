//! Complete figures: positions of texts, and items drawn.

use figure::{
    Anchor, Axis, Figure, Ink, Interval, Item, Level, Palette, Plot, Point, Series, Settings, View, layout, layout_into,
};

pub fn settings(width: f64, height: f64) -> Settings {
    Settings { width, height, ..Settings::default() }
}

pub fn columns(rows: usize) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let time: Vec<f64> = (0..rows).map(|row| row as f64 * 0.05).collect();
    let displacement = time.iter().map(|t| 0.5 * libm::exp(-0.07 * t) * libm::cos(1.67 * t)).collect();
    let velocity = time.iter().map(|t| -0.8 * libm::exp(-0.07 * t) * libm::sin(1.67 * t)).collect();
    (time, displacement, velocity)
}

pub fn time_axis<'a>() -> Axis<'a> {
    Axis { label: "t", unit: "s", ..Axis::default() }
}

pub fn axis<'a>(label: &'a str, unit: &'a str) -> Axis<'a> {
    Axis { label, unit, ..Axis::default() }
}

#[test]
fn a_name_stands_before_the_symbol_where_it_has_room() {
    let (time, displacement, _) = columns(201);
    let plot = Plot {
        x: Axis { name: "Time", ..time_axis() },
        y: vec![Axis { name: "Displacement", ..axis("y", "m") }],
        series: vec![Series { x: &time, y: &displacement, ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    let titles = |width| texts(&layout(&plot, &settings(width, 240.0)))[..2].join(", ");
    assert_eq!(titles(400.0), "Time t [s], Displacement y [m]");
    assert_eq!(titles(130.0), "t [s], y [m]");
}

/// All texts in order.
pub fn texts(figure: &Figure) -> Vec<String> {
    let text = |item| {
        if let Item::Text { text, .. } = item { Some(String::from(text)) } else { None }
    };
    figure.items().filter_map(text).collect()
}

#[test]
fn two_dimensions_have_an_axis_each() {
    let (time, displacement, velocity) = columns(201);
    let plot = Plot {
        title: "Displacement and velocity",
        x: time_axis(),
        y: vec![axis("y", "m"), axis("y′", "m/s")],
        series: vec![
            Series { label: "y", x: &time, y: &displacement, ..Series::default() },
            Series { label: "y′", axis: 1, colour: 1, x: &time, y: &velocity, ..Series::default() },
        ],
        ordered: true,
        ..Plot::default()
    };
    let wide = layout(&plot, &settings(640.0, 320.0));
    assert_eq!(
        texts(&wide).join(" "),
        "Displacement and velocity y y′ t [s] y [m] y′ [m/s] 0 1 2 3 4 5 6 7 8 9 10 \
         −0.8 −0.6 −0.4 −0.2 0 0.2 0.4 0.6 0.8 −0.8 −0.6 −0.4 −0.2 0 0.2 0.4 0.6 0.8"
    );
    let phone = Settings { decimal_comma: true, ..settings(358.0, 200.0) };
    assert_eq!(
        texts(&layout(&plot, &phone)).join(" "),
        "Displacement and velocity y y′ t [s] y [m] y′ [m/s] 0 2 4 6 8 10 −0,5 0 0,5 −1 0 1"
    );
}

/// On the page the title stands above the figure: the legend then takes no row of its own where the axes leave it room.
#[test]
fn the_legend_stands_between_the_titles_of_the_axes() {
    let (time, displacement, velocity) = columns(201);
    let plot = |label: &'static str| Plot {
        x: time_axis(),
        y: vec![axis("y", "m"), axis("y′", "m/s")],
        series: vec![
            Series { label, x: &time, y: &displacement, ..Series::default() },
            Series { label: "y′", axis: 1, colour: 1, x: &time, y: &velocity, ..Series::default() },
        ],
        ordered: true,
        ..Plot::default()
    };
    let without = layout(&plot(""), &settings(560.0, 200.0));
    let with = layout(&plot("y"), &settings(560.0, 200.0));
    assert_eq!(with.panel.y, without.panel.y, "no row is lost");
    let place = |wanted: &str, last: bool| {
        let mut found = with.items().filter_map(|item| match item {
            Item::Text { text, at, .. } if text == wanted => Some(at),
            _ => None,
        });
        if last { found.last() } else { found.next() }.unwrap()
    };
    let (left, legend, right) = (place("y [m]", false), place("y", false), place("y′ [m/s]", true));
    assert!((left.y - legend.y).abs() < 2.0, "{left:?} {legend:?}");
    assert!(left.x + 60.0 < legend.x && legend.x + 120.0 < right.x, "{left:?} {legend:?} {right:?}");
    // Names that are too long have rows of their own.
    let long = layout(&plot("a displacement whose name is far longer than its axis"), &settings(400.0, 200.0));
    assert!(long.panel.y > without.panel.y + 10.0);
}

#[test]
fn a_path_has_equal_axes_also_when_it_is_zoomed() {
    let angle: Vec<f64> = (0..=90).map(|step| f64::from(step) * std::f64::consts::TAU / 90.0).collect();
    let x: Vec<f64> = angle.iter().map(|angle| 3.0 * libm::cos(*angle)).collect();
    let y: Vec<f64> = angle.iter().map(|angle| 3.0 * libm::sin(*angle)).collect();
    let series = vec![Series { x: &x, y: &y, ..Series::default() }];
    let mut plot = Plot { x: axis("x", "m"), y: vec![axis("y", "m")], series, equal: true, ..Plot::default() };
    let per_unit = |figure: &figure::Figure| {
        let (x, y) = (figure.x_scale().unwrap(), &figure.y_scales()[0]);
        (x.pixel(1.0) - x.pixel(0.0), y.pixel(0.0) - y.pixel(1.0))
    };
    for size in [settings(640.0, 240.0), settings(240.0, 640.0), settings(300.0, 300.0)] {
        plot.view = figure::View::default();
        let figure = layout(&plot, &size);
        let (across, up) = per_unit(&figure);
        assert!((across / up - 1.0).abs() < 0.02, "{across} and {up} pixels at {size:?}");
        plot.view = figure.zoom_centre(2.0, figure::Direction::Both);
        let (zoomed, up) = per_unit(&layout(&plot, &size));
        assert!((zoomed / up - 1.0).abs() < 0.02 && zoomed > 1.8 * across, "{zoomed} and {up} pixels");
    }
}

#[test]
fn zeros_of_all_axes_are_level_and_the_present_is_marked() {
    let (time, displacement, velocity) = columns(201);
    let plot = Plot {
        x: time_axis(),
        y: vec![axis("y", "m"), axis("y′", "m/s")],
        series: vec![
            Series { x: &time, y: &displacement, present: Some((5.0, displacement[100])), ..Series::default() },
            Series { axis: 1, colour: 1, x: &time, y: &velocity, ..Series::default() },
        ],
        ordered: true,
        marker: Some(5.0),
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(640.0, 320.0));
    let [left, right] = figure.y_scales() else { panic!("two axes") };
    assert!((left.pixel(0.0) - right.pixel(0.0)).abs() < 1e-9);
    let x = figure.x_scale().unwrap();
    let marker = figure.items().find_map(|item| match item {
        Item::Line(from, to, stroke) if stroke.ink == Ink::Marker => Some((from, to)),
        _ => None,
    });
    let (from, to) = marker.unwrap();
    assert!((f64::from(from.x) - x.pixel(5.0)).abs() <= 0.5 && from.x == to.x);
    let dots: Vec<(f32, f32)> = figure
        .items()
        .filter_map(|item| match item {
            Item::Dots { centres, ink: Ink::Series(0), ringed: true, .. } => Some((centres[0], centres[1])),
            _ => None,
        })
        .collect();
    assert_eq!(dots, [(x.pixel(5.0) as f32, left.pixel(displacement[100]) as f32)]);
}

/// A value at the end of an axis may be greater than it by rounding; one further out is not seen.
#[test]
fn the_present_is_seen_at_the_end_of_an_axis() {
    let (time, displacement, _) = columns(201);
    for (value, dots) in [(3.0, 1), (3.0_f64.next_up(), 1), (3.1, 0), (f64::NAN, 0)] {
        let plot = Plot {
            x: time_axis(),
            y: vec![axis("y", "m")],
            series: vec![Series { x: &time, y: &displacement, present: Some((0.0, value)), ..Series::default() }],
            view: View { x: None, y: vec![Interval { low: -3.0, high: 3.0 }] },
            ..Plot::default()
        };
        let figure = layout(&plot, &settings(640.0, 320.0));
        assert_eq!(figure.items().filter(|item| matches!(item, Item::Dots { .. })).count(), dots, "{value}");
    }
}

#[test]
fn labels_never_overlap_and_a_phone_has_fewer() {
    let (time, displacement, _) = columns(2001);
    let mut counts = Vec::new();
    for width in [1200.0, 640.0, 390.0, 240.0] {
        for (low, high) in [(0.0, 100.0), (40.000_01, 40.000_04), (-1e-7, 3e9), (0.0, 1e300)] {
            let plot = Plot {
                x: time_axis(),
                y: vec![axis("y", "m")],
                series: vec![Series { x: &time, y: &displacement, ..Series::default() }],
                ordered: true,
                view: View { x: Some(Interval { low, high }), y: vec![] },
                ..Plot::default()
            };
            let figure = layout(&plot, &settings(width, 240.0));
            let mut free_from = f32::NEG_INFINITY;
            let mut count = 0;
            for item in figure.items() {
                let Item::Text { text, at, anchor: Anchor::Middle, size, .. } = item else {
                    continue;
                };
                if text == "t [s]" || text.contains('[') {
                    continue;
                }
                // Digits of the widest usual font, DejaVu Sans.
                let half = text.chars().map(|c| if c == '.' { 0.32 } else { 0.64 }).sum::<f32>() * size / 2.0;
                assert!(at.x - half >= free_from, "{text} overlaps at width {width}");
                assert!(at.x - half >= -0.5 && at.x + half <= width as f32 + 0.5, "{text} sticks out at {width}");
                free_from = at.x + half;
                count += 1;
            }
            if high == 100.0 {
                counts.push(count);
            }
        }
    }
    assert_eq!(counts, [21, 11, 6, 3]);
}

#[test]
fn a_figure_without_data_or_room_is_still_a_figure() {
    let plot = Plot { title: "Nothing", x: time_axis(), y: vec![axis("y", "m")], ordered: true, ..Plot::default() };
    let figure = layout(&plot, &settings(640.0, 320.0));
    assert_eq!(figure.x_scale().unwrap().values, Interval { low: 0.0, high: 1.0 });
    for (width, height) in [(0.0, 0.0), (30.0, 300.0), (300.0, 20.0), (f64::NAN, f64::INFINITY), (-5.0, 1e9)] {
        let figure = layout(&plot, &settings(width, height));
        assert!(figure.svg(&Palette::LIGHT).ends_with("</svg>\n"));
        assert!(figure.hover(&plot, Point { x: 10.0, y: 10.0 }).is_none());
    }
}

#[test]
fn a_figure_used_again_is_as_one_made_anew() {
    let (time, displacement, velocity) = columns(500);
    let one = Plot {
        title: "One",
        x: time_axis(),
        y: vec![axis("y", "m"), axis("y′", "m/s")],
        series: vec![Series { label: "y", x: &time, y: &displacement, ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    let two = Plot {
        x: axis("y", "m"),
        y: vec![axis("y′", "m/s")],
        series: vec![Series { x: &displacement, y: &velocity, ..Series::default() }],
        ..Plot::default()
    };
    let mut figure = layout(&one, &settings(640.0, 320.0));
    layout_into(&mut figure, &two, &settings(400.0, 300.0));
    let fresh = layout(&two, &settings(400.0, 300.0));
    assert_eq!(figure.svg(&Palette::DARK), fresh.svg(&Palette::DARK));
}

#[test]
fn bars_stand_on_zero_and_are_as_wide_as_their_bins() {
    let (middles, counts) = ([0.5, 1.5, 2.5], [2.0, 0.0, 4.0]);
    let bars = Series { style: figure::Style::Bars, width: 1.0, x: &middles, y: &counts, ..Series::default() };
    let plot = Plot {
        x: Axis { include: Some(Interval { low: 0.0, high: 3.0 }), ..axis("v", "m/s") },
        y: vec![Axis { include: Some(Interval { low: 0.0, high: 5.0 }), ..axis("Count", "") }],
        series: vec![bars],
        ordered: true,
        steady: true,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(640.0, 320.0));
    let fills = figure.items().filter_map(|item| match item {
        Item::Fill(area, Ink::Series(0)) => Some(area),
        _ => None,
    });
    let fills: Vec<figure::Rect> = fills.collect();
    assert_eq!(fills.len(), 2, "an empty bin has no bar: {fills:?}");
    for (bar, (from, to, count)) in fills.iter().zip([(0.0, 1.0, 2.0), (2.0, 3.0, 4.0)]) {
        let (low, high) = (figure.place(0, from, 0.0).unwrap(), figure.place(0, to, count).unwrap());
        let ends = [bar.x - low.x, bar.x + bar.width + 1.0 - high.x, bar.y - high.y, bar.y + bar.height - low.y];
        assert!(ends.iter().all(|off| off.abs() < 0.01), "{bar:?}: {low:?} to {high:?}");
    }
    // The axis ends where the last bin does, not at the next round number of a growing run.
    assert!((fills[1].x + fills[1].width - figure.panel.x - figure.panel.width).abs() < 2.0);
    let read = figure.readout(&plot, 0, 2).unwrap();
    assert_eq!((read.heading.as_str(), read.samples[0].text.as_str()), ("v = 2.5000\u{a0}m/s", "Count = 4.000"));
}

#[test]
fn an_axis_may_show_one_range_only() {
    let (x, y) = ([0.0, 10.0, 20.0], [-50.0, 0.0, 50.0]);
    let plot = Plot {
        x: Axis { only: Some(Interval { low: 0.0, high: 4.0 }), ..axis("t", "s") },
        y: vec![Axis { only: Some(Interval { low: -1.0, high: 2.0 }), ..axis("y", "cm") }],
        series: vec![Series { x: &x, y: &y, ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(640.0, 320.0));
    // The series is longer and higher than the panel.
    let (low, high) = (figure.place(0, 0.0, -1.0).unwrap(), figure.place(0, 4.0, 2.0).unwrap());
    assert!(figure.panel.contains(low) && figure.panel.contains(high), "{low:?}, {high:?}");
    assert!(high.x - low.x > figure.panel.width / 2.0 && low.y - high.y > figure.panel.height / 2.0);
}

#[test]
fn beside_a_drawing_the_axis_has_its_scale_as_long_as_all_fits() {
    let (time, displacement, _) = columns(201);
    let at = |level| {
        let series = Series { x: &time, y: &displacement, present: Some((3.0, 0.25)), ..Series::default() };
        let y = vec![axis("y", "m")];
        layout(
            &Plot { x: time_axis(), y, series: vec![series], ordered: true, ..Plot::default() },
            &Settings { level, ..settings(640.0, 320.0) },
        )
    };
    let figure = at(Some(Level { zero: 140.0, unit: 200.0 }));
    let scale = figure.y_scales()[0];
    assert!((scale.pixel(0.0) - 140.0).abs() < 1e-9 && (scale.pixel(0.5) - 40.0).abs() < 1e-9);
    let dot = figure.level_point().expect("the present moment");
    assert!((f64::from(dot.y) - 90.0).abs() < 1e-4);
    // A swing that leaves the panel has its own scale, and so has a scale that points downwards.
    for level in [None, Some(Level { zero: 140.0, unit: 400.0 }), Some(Level { zero: 140.0, unit: -200.0 })] {
        let other = at(level);
        assert_eq!((other.level_point(), other.y_scales()), (None, at(None).y_scales()));
    }
}
