//! Lines and points: simplified, clipped, and in styles that can be told apart.

use crate::layout::{axis, columns, settings, texts, time_axis};
use figure::{Axis, Figure, Ink, Interval, Item, Palette, Plot, Point, Series, Settings, Style, View, layout};

/// The points of all polylines of an ink.
fn polylines(figure: &Figure, wanted: Ink) -> Vec<Vec<(f32, f32)>> {
    let polyline = |item| match item {
        Item::Polyline(points, stroke) if stroke.ink == wanted => {
            Some(points.chunks_exact(2).map(|point| (point[0], point[1])).collect())
        }
        _ => None,
    };
    figure.items().filter_map(polyline).collect()
}

#[test]
fn lines_break_at_jumps_and_gaps() {
    let time: Vec<f64> = (0..10).map(f64::from).collect();
    let height = [0.0, 3.0, 1.0, 4.0, f64::NAN, 2.0, f64::INFINITY, 0.0, 5.0, 1.0];
    let plot = Plot {
        x: time_axis(),
        y: vec![axis("y", "m")],
        series: vec![Series { x: &time, y: &height, breaks: &[0, 2, 9], ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(640.0, 320.0));
    let lengths: Vec<usize> = polylines(&figure, Ink::Series(0)).iter().map(Vec::len).collect();
    assert_eq!(lengths, [2, 2, 2]);
    // Rows 5 and 9 stand alone and become dots.
    let dots = figure.items().filter(|item| matches!(item, Item::Dots { .. })).count();
    assert_eq!(dots, 2);
}

#[test]
fn decimation_keeps_the_extrema_and_follows_every_point() {
    // A thousand oscillations in a panel of some 580 pixels, and one spike.
    let rows = 100_000;
    let time: Vec<f64> = (0..rows).map(|row| f64::from(row) * 1e-3).collect();
    let mut height: Vec<f64> = time.iter().map(|t| libm::sin(62.8 * t)).collect();
    height[54_321] = 1.9;
    let plot = Plot {
        x: time_axis(),
        y: vec![axis("y", "m")],
        series: vec![Series { x: &time, y: &height, ..Series::default() }],
        ordered: true,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(640.0, 320.0));
    let lines = polylines(&figure, Ink::Series(0));
    assert_eq!(lines.len(), 1);
    assert!(lines[0].len() < 4 * 640, "{} points", lines[0].len());
    let (x, y) = (figure.x_scale().unwrap(), figure.y_scales()[0]);
    let spike = (x.pixel(time[54_321]), y.pixel(1.9));
    let near =
        |point: &&(f32, f32)| (f64::from(point.0) - spike.0).abs() < 0.3 && (f64::from(point.1) - spike.1).abs() < 0.3;
    assert!(lines[0].iter().find(near).is_some());
    // The lowest and highest value in each column of pixels are reached by the line there.
    let mut ends = vec![(f64::INFINITY, f64::NEG_INFINITY); 640];
    for (t, value) in time.iter().zip(&height) {
        let column = &mut ends[x.pixel(*t) as usize];
        *column = (column.0.min(y.pixel(*value)), column.1.max(y.pixel(*value)));
    }
    for segment in lines[0].windows(2) {
        let (low, high) = (segment[0].1.min(segment[1].1), segment[0].1.max(segment[1].1));
        for end in segment {
            let column = &mut ends[end.0 as usize];
            if f64::from(low) <= column.0 + 0.25 {
                column.0 = f64::INFINITY;
            }
            if f64::from(high) >= column.1 - 0.25 {
                column.1 = f64::NEG_INFINITY;
            }
        }
    }
    let missed = ends.iter().filter(|ends| ends.0 < 1e9 || ends.1 > -1e9).count();
    assert_eq!(missed, 0);
}

#[test]
fn a_simplified_curve_stays_within_a_quarter_of_a_pixel() {
    let (_, displacement, velocity) = columns(4001);
    let plot = Plot {
        x: axis("y", "m"),
        y: vec![axis("y′", "m/s")],
        series: vec![Series { x: &displacement, y: &velocity, ..Series::default() }],
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(500.0, 500.0));
    let line = &polylines(&figure, Ink::Series(0))[0];
    assert!(line.len() < 1000, "{} of 4001 points", line.len());
    let (x, y) = (figure.x_scale().unwrap(), figure.y_scales()[0]);
    for (a, b) in displacement.iter().zip(&velocity) {
        let point = (x.pixel(*a) as f32, y.pixel(*b) as f32);
        let nearest = line.windows(2).map(|ends| distance(point, ends[0], ends[1])).fold(f32::INFINITY, f32::min);
        assert!(nearest < 0.25, "{point:?} is {nearest} from the line");
    }
}

/// The distance of a point from a segment.
fn distance(point: (f32, f32), from: (f32, f32), to: (f32, f32)) -> f32 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let along = ((point.0 - from.0) * dx + (point.1 - from.1) * dy) / (dx * dx + dy * dy).max(1e-12);
    let part = along.clamp(0.0, 1.0);
    let (x, y) = (point.0 - from.0 - part * dx, point.1 - from.1 - part * dy);
    (x * x + y * y).sqrt()
}

#[test]
fn a_zoomed_line_is_clipped_to_the_panel() {
    let (time, displacement, _) = columns(2001);
    let view = View { x: Some(Interval { low: 10.013, high: 10.02 }), y: vec![Interval { low: -0.01, high: 0.5 }] };
    let plot = Plot {
        x: time_axis(),
        y: vec![axis("y", "m")],
        series: vec![Series { x: &time, y: &displacement, ..Series::default() }],
        ordered: true,
        view,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(640.0, 320.0));
    let panel = figure.panel;
    for line in polylines(&figure, Ink::Series(0)) {
        for (x, y) in line {
            assert!(x >= panel.x - 2.0 && x <= panel.x + panel.width + 2.0);
            assert!(y >= panel.y - 2.0 && y <= panel.y + panel.height + 2.0);
        }
    }
    // Between two samples, with none in the panel, the line still passes.
    let plot = Plot { view: View { x: Some(Interval { low: 10.01, high: 10.03 }), y: vec![] }, ..plot };
    let figure = layout(&plot, &settings(640.0, 320.0));
    assert_eq!(polylines(&figure, Ink::Series(0)).iter().map(Vec::len).collect::<Vec<_>>(), [2]);
}

#[test]
fn styles_can_be_told_apart_without_colour() {
    let (time, displacement, _) = columns(50);
    let series = |label, style| Series { label, style, x: &time, y: &displacement, ..Series::default() };
    let plot = Plot {
        x: time_axis(),
        y: vec![axis("y", "m")],
        series: vec![
            series("before", Style::Ghost),
            series("run 1", Style::Kept(0)),
            series("run 2", Style::Kept(1)),
            series("now", Style::Line),
            series("measured", Style::Points),
        ],
        ordered: true,
        ..Plot::default()
    };
    let figure = layout(&plot, &settings(700.0, 320.0));
    let mut strokes = Vec::new();
    for item in figure.items() {
        if let Item::Polyline(_, stroke) = item {
            strokes.push((stroke.ink, stroke.dash.lengths().to_vec()));
        }
    }
    assert_eq!(strokes.len(), 4);
    for (index, stroke) in strokes.iter().enumerate() {
        assert!(!strokes[..index].contains(stroke), "{stroke:?} twice");
    }
    for palette in [Palette::LIGHT, Palette::DARK] {
        let faint = palette.colour(Ink::Ghost(0)).contrast(palette.ground);
        assert!(faint > 1.3 && faint < palette.colour(Ink::Series(0)).contrast(palette.ground));
    }
    assert!(texts(&figure).starts_with(&["before", "run 1", "run 2", "now", "measured"].map(String::from)));
}

#[test]
fn uncertainties_are_bars_on_points_and_a_band_about_a_line() {
    let x = [0.0, 1.0, 2.0, 3.0, 4.0];
    let y = [0.0, 0.5, f64::NAN, 0.5, 1.0];
    let spread = [0.1, 0.2, 0.1, 0.1, 0.3];
    let figure_of = |style| {
        let series = vec![Series { style, colour: 1, x: &x, y: &y, spread: &spread, ..Series::default() }];
        let plot = Plot { y: vec![Axis::default()], series, ordered: true, ..Plot::default() };
        layout(&plot, &Settings::default())
    };
    let figure = figure_of(Style::Points);
    let (x_scale, y_scale) = (*figure.x_scale().unwrap(), figure.y_scales()[0]);
    assert!(y_scale.values.contains(1.3) && y_scale.values.contains(-0.1), "{y_scale:?}");
    let bars: Vec<(Point, Point)> = figure
        .items()
        .filter_map(|item| match item {
            Item::Line(from, to, stroke) if stroke.ink == Ink::Ghost(1) => Some((from, to)),
            _ => None,
        })
        .collect();
    // A bar with a cap at either end for each of four points.
    assert_eq!(bars.len(), 12);
    let (top, bottom) = bars[3];
    assert!((x_scale.value(top.x.into()) - 1.0).abs() < 1e-6 && top.x == bottom.x);
    assert!((y_scale.value(top.y.into()) - 0.7).abs() < 1e-6 && (y_scale.value(bottom.y.into()) - 0.3).abs() < 1e-6);
    // Bars that their points hide are not drawn, and of many only some are.
    let many: Vec<f64> = (0..5000).map(f64::from).collect();
    let heights: Vec<f64> = many.iter().map(|x| libm::sin(0.01 * x)).collect();
    let bars_of = |spread: f64| {
        let spread = vec![spread; many.len()];
        let style = Style::Points;
        let series = vec![Series { style, colour: 1, x: &many, y: &heights, spread: &spread, ..Series::default() }];
        let plot = Plot { y: vec![Axis::default()], series, ordered: true, ..Plot::default() };
        let figure = layout(&plot, &Settings::default());
        let ghosts =
            figure.items().filter(|item| matches!(item, Item::Line(_, _, stroke) if stroke.ink == Ink::Ghost(1)));
        ghosts.count() / 3
    };
    assert_eq!(bars_of(1e-3), 0);
    assert!((40..=80).contains(&bars_of(0.3)), "{}", bars_of(0.3));
    let figure = figure_of(Style::Line);
    let areas: Vec<usize> = figure
        .items()
        .filter_map(|item| match item {
            Item::Area(points, Ink::Band(1)) => Some(points.len()),
            _ => None,
        })
        .collect();
    assert_eq!(areas, [8, 8], "two rows before the gap and two after it, there and back");
    assert!(figure.svg(&Palette::LIGHT).contains(&format!("fill=\"{}\"/>", Palette::LIGHT.colour(Ink::Band(1)))));
}

#[test]
fn names_stand_at_the_ends_of_curves_and_do_not_overlap() {
    let time: Vec<f64> = (0..50).map(f64::from).collect();
    // All end at the lower edge of the panel, one of them outside of a zoomed view.
    let falling = |from: f64| -> Vec<f64> { time.iter().map(|t| from * (1.0 - t / 49.0)).collect() };
    let curves = [falling(3.0), falling(2.0), falling(1.0)];
    let series = |(number, y): (usize, &'static str)| Series {
        x: &time,
        y: &curves[number],
        style: Style::Faded(number as u8),
        end: y,
        ..Series::default()
    };
    let names =
        ["b = 0.1 kg/s", "b = 0.2 kg/s", "a name that is much too long for the end of a curve in a narrow figure"];
    for view in [View::default(), View { x: Some(Interval::new(0.0, 20.0)), ..View::default() }] {
        let plot = Plot {
            x: time_axis(),
            y: vec![axis("y", "m")],
            series: names.into_iter().enumerate().map(series).collect(),
            ordered: true,
            view,
            ..Plot::default()
        };
        let figure = layout(&plot, &settings(400.0, 240.0));
        let ends = figure.items().filter_map(|item| match item {
            Item::Text { text, at, size, ink: Ink::Faded(0), .. } => Some((text.to_owned(), at, size)),
            _ => None,
        });
        let ends: Vec<(String, Point, f32)> = ends.collect();
        let texts: Vec<&str> = ends.iter().map(|(text, ..)| text.as_str()).collect();
        assert_eq!(texts.len(), 3, "{texts:?}");
        assert!(texts.contains(&names[0]) && texts.contains(&names[1]), "{texts:?}");
        assert!(texts.iter().any(|text| text.starts_with("a name") && text.ends_with('…')), "{texts:?}");
        let (x, y) = (figure.x_scale().unwrap(), figure.y_scales()[0]);
        for (place, (text, at, size)) in ends.iter().enumerate() {
            assert!(f64::from(at.y) < y.low + 1.0 && f64::from(at.y - size) > y.high - 1.0, "{text} at {at:?}");
            assert!(f64::from(at.x) <= x.high + 0.5, "{text} at {at:?}");
            assert!(ends[..place].iter().all(|(_, other, _)| (other.y - at.y).abs() >= *size), "{ends:?}");
        }
    }
}
