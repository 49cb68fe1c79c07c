//! Very many points: reduced to the marks that pixels can show, without losing an extreme.

use figure::{Figure, Interval, Item, Palette, Plot, Series, Settings, Style, View, layout, layout_into};

const SETTINGS: Settings = Settings { width: 640.0, height: 360.0, font_size: 13.0, decimal_comma: false, level: None };
const ROWS: usize = 100_000;

/// An oscillation with noise, and a few values far from it.
fn column() -> (Vec<f64>, Vec<f64>) {
    let noise = |row: usize| ((row * 48_271) % 65_537) as f64 / 65_537.0 - 0.5;
    let height = |row: usize| match row {
        777 => 3.0,
        50_000 => -2.5,
        _ => libm::sin(row as f64 * 3e-4) + 0.2 * noise(row),
    };
    ((0..ROWS).map(|row| row as f64 * 1e-3).collect(), (0..ROWS).map(height).collect())
}

fn plot<'a>(x: &'a [f64], y: &'a [f64], version: u64, ordered: bool) -> Plot<'a> {
    let series = vec![Series { style: Style::Points, x, y, version, ..Series::default() }];
    Plot { y: vec![figure::Axis::default()], series, ordered, ..Plot::default() }
}

fn bars(figure: &Figure) -> Vec<[f32; 3]> {
    let found = figure.items().find_map(|item| match item {
        Item::Bars { bars, .. } => Some(bars.chunks_exact(3).map(|bar| [bar[0], bar[1], bar[2]]).collect()),
        _ => None,
    });
    found.unwrap_or_default()
}

#[test]
fn many_points_are_few_bars_that_cover_every_point() {
    let (x, y) = column();
    for ordered in [true, false] {
        let figure = layout(&plot(&x, &y, 0, ordered), &SETTINGS);
        let bars = bars(&figure);
        assert!(!bars.is_empty() && bars.len() < 3 * figure.panel.width as usize, "{}", bars.len());
        assert!(bars.iter().all(|[_, upper, lower]| upper <= lower));
        let (across, up) = (figure.x_scale().unwrap(), &figure.y_scales()[0]);
        for (x, y) in x.iter().zip(&y) {
            let (right, down) = (across.pixel(*x) as f32, up.pixel(*y) as f32);
            let near =
                |[at, upper, lower]: &[f32; 3]| (at - right).abs() <= 1.0 && down >= upper - 0.6 && down <= lower + 0.6;
            assert!(bars.iter().any(near), "{x} {y}");
        }
        // The extremes are exact to the bit.
        let end = |pick: fn(f32, f32) -> f32, place: usize| bars.iter().map(|bar| bar[place]).reduce(pick).unwrap();
        assert!((end(f32::min, 1) - up.pixel(3.0) as f32).abs() < 1e-3);
        assert!((end(f32::max, 2) - up.pixel(-2.5) as f32).abs() < 1e-3);
        // A saved figure shows the same, and is small.
        let svg = figure.svg(&Palette::LIGHT);
        assert!(svg.contains("stroke-linecap=\"round\"") && svg.len() < 100_000, "{}", svg.len());
        roxmltree::Document::parse(&svg).unwrap();
    }
    // Few points are drawn as dots.
    let figure = layout(&plot(&x[..500], &y[..500], 0, true), &SETTINGS);
    assert!(bars(&figure).is_empty() && figure.items().any(|item| matches!(item, Item::Dots { .. })));
}

#[test]
fn what_is_kept_of_a_series_changes_nothing_in_its_figure() {
    let (x, y) = column();
    let mut kept = Figure::default();
    let steps = [
        (10_000, 1, None),
        (60_000, 1, None),
        (60_000, 1, Some((10.0, 40.0))),
        (ROWS, 1, None),
        (ROWS, 1, None),
        (50_000, 2, None),
    ];
    for (rows, version, view) in steps {
        let zoomed = |version| Plot {
            view: View { x: view.map(|(low, high)| Interval::new(low, high)), y: Vec::new() },
            ..plot(&x[..rows], &y[..rows], version, true)
        };
        layout_into(&mut kept, &zoomed(version), &SETTINGS);
        let fresh = layout(&zoomed(0), &SETTINGS);
        assert_eq!(
            kept.items().collect::<Vec<_>>(),
            fresh.items().collect::<Vec<_>>(),
            "{rows} rows, version {version}"
        );
    }
}

#[test]
fn a_very_long_series_is_drawn_in_several_layouts_when_it_is_new() {
    let rows = 600_000;
    let x: Vec<f64> = (0..rows).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| libm::sin(x * 1e-4)).collect();
    let mut figure = Figure::default();
    let mut shown = Vec::new();
    loop {
        layout_into(&mut figure, &plot(&x, &y, 1, true), &SETTINGS);
        shown.push(bars(&figure).len());
        if !figure.is_unfinished() {
            break;
        }
    }
    assert!(shown.len() == 3 && shown.is_sorted() && shown[0] < shown[2], "{shown:?}");
    let whole = layout(&plot(&x, &y, 0, true), &SETTINGS);
    assert_eq!(figure.items().collect::<Vec<_>>(), whole.items().collect::<Vec<_>>());
    // A single call of `layout` draws the whole series, and a change of scales is drawn at once.
    assert_eq!(bars(&layout(&plot(&x, &y, 2, true), &SETTINGS)), bars(&whole));
    let view = View { x: Some(Interval::new(0.0, 5e5)), y: Vec::new() };
    layout_into(&mut figure, &Plot { view, ..plot(&x, &y, 1, true) }, &SETTINGS);
    assert!(!figure.is_unfinished());
}

#[test]
fn computed_points_are_the_smaller_the_more_there_are() {
    let x: Vec<f64> = (0..ROWS).map(|row| ((row * 48_271) % 65_537) as f64).collect();
    let y: Vec<f64> = (0..ROWS).map(|row| ((row * 16_807) % 65_521) as f64).collect();
    let radius = |style, rows: usize| {
        let series = vec![Series { style, x: &x[..rows], y: &y[..rows], ..Series::default() }];
        let plot = Plot { y: vec![figure::Axis::default()], series, ..Plot::default() };
        let figure = layout(&plot, &SETTINGS);
        let found = figure.items().find_map(|item| match item {
            Item::Dots { radius, .. } | Item::Bars { radius, .. } => Some(radius),
            _ => None,
        });
        (found.expect("points"), figure.svg(&Palette::LIGHT))
    };
    for (rows, expected) in [(10, 2.5), (300, 2.5), (1200, 1.25), (3000, 0.79), (ROWS, 0.7)] {
        let (dots, _) = radius(Style::Dots, rows);
        assert!((dots - expected).abs() < 0.01, "{rows} points: {dots}");
        assert_eq!(radius(Style::Points, rows).0, 2.5, "measured data are seen however many they are");
    }
    // A file has dots of the same size.
    assert!(radius(Style::Dots, 1200).1.contains("r=\"1.25\""));
}
