//! Arbitrary input gives a figure that is finite and well-formed, without a panic.

use figure::{Anchor, Axis, Direction, Interval, Item, Palette, Plot, Point, Series, Settings, Style, View, layout};
use proptest::prelude::*;

fn value() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>(),
        -10.0..10.0,
        Just(0.0),
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(f64::MAX),
        Just(f64::MIN_POSITIVE),
        Just(1e300),
        Just(-1e-300),
        (-1e-9..1e-9).prop_map(|small: f64| 1e6 + small),
    ]
}

fn interval() -> impl Strategy<Value = Interval> {
    (value(), value()).prop_map(|(low, high)| Interval { low, high })
}

fn style() -> impl Strategy<Value = Style> {
    prop_oneof![
        Just(Style::Line),
        Just(Style::Ghost),
        Just(Style::Points),
        Just(Style::Dots),
        any::<u8>().prop_map(Style::Kept)
    ]
}

prop_compose! {
    fn column()(values in prop::collection::vec(value(), 0..40)) -> Vec<f64> { values }
}

proptest! {
    #[test]
    fn any_plot_can_be_laid_out(
        (x, y, z) in (column(), column(), column()),
        sorted in any::<bool>(),
        ordered in any::<bool>(),
        breaks in prop::collection::vec(0_usize..50, 0..5),
        (one, other) in (style(), style()),
        axes in 0_usize..4,
        view_x in prop::option::of(interval()),
        view_y in prop::collection::vec(interval(), 0..4),
        include in prop::option::of(interval()),
        (width, height, font_size) in (0.0..900.0, 0.0..600.0, 1.0..30.0),
        label in ".{0,12}",
        (marker, at_x, at_y) in (value(), value(), value()),
        (pixel_x, pixel_y, factor) in (-100.0_f32..900.0, -100.0_f32..600.0, value()),
        rows in -60_isize..60,
    ) {
        let mut x = x;
        if sorted {
            x.sort_by(f64::total_cmp);
        }
        let axis = Axis { label: &label, unit: "m", include, only: None, ..Axis::default() };
        let plot = Plot {
            title: &label,
            x: axis,
            y: vec![axis; axes],
            series: vec![
                Series { label: &label, style: one, x: &x, y: &y, spread: &z, breaks: &breaks, ..Series::default() },
                Series { label: "z", axis: 1, spread: &y, colour: 9, style: other, x: &x, y: &z, present: Some((at_x, at_y)), ..Series::default() },
            ],
            ordered,
            marker: Some(marker),
            view: View { x: view_x, y: view_y },
            ..Plot::default()
        };
        let figure = layout(&plot, &Settings { width, height, font_size, decimal_comma: sorted, level: None });
        let mut free_from = f32::NEG_INFINITY;
        for item in figure.items() {
            match item {
                Item::Polyline(points, _) => {
                    prop_assert!(points.len() >= 4 && points.iter().all(|pixel| pixel.is_finite()));
                    let panel = figure.panel;
                    for point in points.chunks_exact(2) {
                        prop_assert!(point[0] >= panel.x - 2.0 && point[0] <= panel.x + panel.width + 2.0);
                        prop_assert!(point[1] >= panel.y - 2.0 && point[1] <= panel.y + panel.height + 2.0);
                    }
                }
                Item::Bars { bars, .. } => prop_assert!(bars.iter().all(|pixel| pixel.is_finite())),
                Item::Dots { centres, .. } => prop_assert!(centres.iter().all(|pixel| pixel.is_finite())),
                Item::Line(from, to, _) => {
                    prop_assert!([from.x, from.y, to.x, to.y].iter().all(|pixel| pixel.is_finite()));
                }
                Item::Text { text, at, anchor, size, .. } => {
                    prop_assert!(at.x.is_finite() && at.y.is_finite());
                    if anchor == Anchor::Middle && !text.contains('[') {
                        let half = text.chars().map(|c| if c == '.' || c == ',' { 0.3 } else { 0.6 }).sum::<f32>() * size / 2.0;
                        prop_assert!(at.x - half >= free_from, "{} overlaps", text);
                        free_from = at.x + half;
                    }
                }
                Item::Area(points, _) => {
                    prop_assert!(points.len() >= 8);
                    for point in points.chunks_exact(2) {
                        prop_assert!(figure.panel.x - 0.01 <= point[0] && point[0] <= figure.panel.x + figure.panel.width + 0.01);
                        prop_assert!(figure.panel.y - 0.01 <= point[1] && point[1] <= figure.panel.y + figure.panel.height + 0.01);
                    }
                }
                Item::Fill(..) => {}
            }
        }
        let text = figure.svg(&Palette::DARK);
        prop_assert!(roxmltree::Document::parse(&text).is_ok(), "{}", text);
        let at = Point { x: pixel_x, y: pixel_y };
        if let Some(readout) = figure.hover(&plot, at) {
            for sample in readout.samples {
                prop_assert!(figure.panel.contains(sample.at));
                let _ = figure.readout(&plot, sample.series, sample.row);
            }
        }
        let _ = figure.step(&plot, 0, 7, rows);
        let far = Point { x: 400.0, y: 50.0 };
        for view in [
            figure.zoom(at, factor, Direction::Both),
            figure.zoom_to(at, far),
            figure.pan(f64::from(pixel_x), factor),
        ] {
            let again = layout(&Plot { view, ..plot.clone() }, &Settings { width, height, font_size, decimal_comma: false, level: None });
            for scale in again.x_scale().into_iter().chain(again.y_scales()) {
                prop_assert!(scale.values.length() > 0.0 && scale.values.length().is_finite());
            }
        }
    }

    #[test]
    fn automatic_limits_contain_the_data(values in prop::collection::vec(-1e6..1e6, 1..30), scale in -200..200_i32, ordered in any::<bool>()) {
        let factor = libm::pow(10.0, f64::from(scale));
        let mut x: Vec<f64> = values.iter().map(|value| value * factor).collect();
        let y: Vec<f64> = x.iter().rev().copied().collect();
        if ordered {
            x.sort_by(f64::total_cmp);
        }
        let plot = Plot {
            y: vec![Axis::default()],
            series: vec![Series { x: &x, y: &y, ..Series::default() }],
            ordered,
            ..Plot::default()
        };
        let figure = layout(&plot, &Settings::default());
        for scale in figure.x_scale().into_iter().chain(figure.y_scales()) {
            let slack = 1e-8 * scale.values.length();
            for value in &x {
                prop_assert!(*value >= scale.values.low - slack && *value <= scale.values.high + slack);
            }
        }
    }
}
