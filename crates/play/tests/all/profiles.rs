//! Plots of a single moment, and points at the firings of an event.

use crate::support::{go_on, open, set};
use figure::{Item, Palette, Point, Settings};
use play::{Play, PlotId};
use std::f64::consts::PI;

const SETTINGS: Settings = Settings { width: 640.0, height: 360.0, font_size: 13.0, decimal_comma: false, level: None };

/// A chain with this number of masses in its second mode.
fn chain(masses: usize) -> Play {
    open(
        &format!(
            "---\nstep: 0.01 [s]\nmethod: dormand-prince\ntolerance: 1e-10\n---\n\
             ```model\nsize N = {masses} in 2..200\nparameter a = 1 [m] in 0.5..2\nparameter k = 4 [1/s^2]\n\
             x[i]'' = k*(x[i-1] - 2*x[i] + x[i+1]) for i in 1..N\nx[0] = 0 [m] \"Wall\"\nx[N+1] = 0 [m]\n\
             x[i](0) = a*sin(2*pi*i/(N + 1)) in [cm] for i in 1..N \"Displacement\"\nx[i]'(0) = 0 [m/s] for i in 1..N\n```\n\
             ```plots\n\"Shape\": x[i] against i*a for i in 0..N+1\n\
             \"Both\": x[i], x[i]*1 [1/s] in [cm/s] \"Second\" against i for i in 1..N\n\
             \"Phases\": points x[i]' against x[i] for i in 1..N\n\
             \"Places\": histogram x[i] for i in 1..N\n\"Times\": histogram x[1]\n```\n"
        ),
        &[],
    )
}

/// The lines of a plot's CSV as numbers, without the heading.
fn table(play: &mut Play, plot: usize) -> (String, Vec<Vec<f64>>) {
    let csv = play.plots_to_front().csv(PlotId::at(plot));
    let mut lines = csv.lines();
    let head = lines.next().unwrap_or_default().to_owned();
    (head, lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect())
}

#[test]
fn a_profile_shows_all_members_at_the_moment() {
    let mut play = chain(11);
    go_on(&mut play, [0.5; 3]);
    // The mode n oscillates with 2 sqrt(k) sin(n pi/(2 (N + 1))).
    let omega = 4.0 * libm::sin(PI / 12.0);
    for time in [1.5, 0.4] {
        play.change_run(|line, _| line.scrub(time));
        let (head, rows) = table(&mut play, 0);
        let shown = format!("{time:.2}");
        assert_eq!(head, format!("i·a (t = {shown} s) [m],x_i (t = {shown} s) [cm]"));
        assert_eq!(rows.len(), 13);
        for (i, row) in rows.iter().enumerate() {
            let expected = 100.0 * libm::sin(PI * i as f64 / 6.0) * libm::cos(omega * time);
            assert!(row[0] == i as f64 && (row[1] - expected).abs() < 1e-6, "{row:?} at {time} s: {expected}");
        }
        let svg = play.plots_to_front().svg(PlotId::at(0), &SETTINGS, &Palette::LIGHT);
        assert!(svg.contains(&format!("Shape (t = {shown} s)")), "{svg}");
        assert!(svg.contains("Shape: Displacement (x_i) against i·a."), "{svg}");
    }
    play.set_language("es");
    let csv = play.plots_to_front().csv(PlotId::at(0));
    assert!(csv.contains("\"i·a (t = 0,40 s) [m]\";\"x_i (t = 0,40 s) [cm]\""), "{csv}");
}

#[test]
fn the_axes_of_a_profile_grow_with_the_run_and_stay_while_it_is_scrubbed() {
    let mut play = chain(11);
    let top = |play: &mut Play| {
        let figure = play.layout_plot(PlotId::at(0), &SETTINGS).unwrap();
        // The pixels of 0 cm and 50 cm are fixed while the axis is.
        (figure.place(0, 0.0, 0.0), figure.place(0, 12.0, 50.0))
    };
    let start = top(&mut play);
    assert!(start.0.is_some() && start.1.is_some());
    go_on(&mut play, [0.1; 30]);
    let all = top(&mut play);
    for time in [0.0, 0.7, 1.5, 2.9] {
        play.change_run(|line, _| line.scrub(time));
        assert_eq!(top(&mut play), all, "{time} s");
    }
    // A run with a longer chain has its own axes.
    set(&mut play, "a", 2.0);
    play.change_run(|line, basis| line.back_to_start(basis));
    assert_ne!(top(&mut play), all);
    set(&mut play, "a", 1.0);
    play.change_run(|line, basis| line.back_to_start(basis));
    assert_eq!(top(&mut play), start);
}

#[test]
fn two_curves_and_points_stand_in_profiles_and_are_read() {
    let mut play = chain(11);
    let (head, rows) = table(&mut play, 1);
    assert_eq!(head, "i (t = 0.00 s),x_i (t = 0.00 s) [cm],i (t = 0.00 s),x_i·1 [1/s] (t = 0.00 s) [cm/s]");
    assert!(rows.iter().all(|row| row.len() == 4 && row[1] == row[3]), "{rows:?}");
    let legend = play.plots().legend(PlotId::at(1));
    assert_eq!(legend.len(), 2);
    play.layout_plot(PlotId::at(1), &SETTINGS);
    let readout = play.change_plots(|plots, run| plots.move_cursor(run, PlotId::at(1), 2)).unwrap();
    assert!(readout.heading.starts_with("i = 3") && readout.samples.len() == 2, "{readout:?}");
    let figure = play.layout_plot(PlotId::at(2), &SETTINGS).unwrap();
    let dots = figure.items().any(|item| matches!(item, Item::Dots { centres, .. } if centres.len() >= 10));
    assert!(dots, "each mass is a point of the phase plane");
    let at = figure.place(0, 50.0, 0.0).unwrap();
    let readout = play.change_plots(|plots, run| plots.hover(run, PlotId::at(2), Point { x: at.x, y: at.y })).unwrap();
    assert!(readout.heading.starts_with("x_i = 50") && readout.samples[0].text.starts_with("x_i′ = 0"), "{readout:?}");
}

#[test]
fn histograms_count_every_member_and_every_row() {
    let mut play = chain(150);
    go_on(&mut play, [0.5]);
    let (head, rows) = table(&mut play, 3);
    assert_eq!(head, "x_i (t = 0.50 s) [cm],Count (t = 0.50 s)");
    assert_eq!(rows.iter().map(|row| row[1]).sum::<f64>(), 150.0);
    // A sine is most often near its turning points.
    let highest = rows.iter().map(|row| row[1]).fold(0.0, f64::max);
    assert!(rows[0][1] == highest || rows[rows.len() - 1][1] == highest, "{rows:?}");
    let svg = play.plots_to_front().svg(PlotId::at(3), &SETTINGS, &Palette::LIGHT);
    assert!(svg.contains("Histogram of Displacement (x_i) at the moment shown.") && svg.contains("Count"), "{svg}");
    let (_, rows) = table(&mut play, 4);
    assert_eq!(rows.iter().map(|row| row[1]).sum::<f64>(), 51.0, "0.5 s in steps of 0.01 s, with both ends");
    play.change_run(|line, _| line.scrub(0.2));
    let (_, rows) = table(&mut play, 4);
    assert_eq!(rows.iter().map(|row| row[1]).sum::<f64>(), 21.0);
    play.layout_plot(PlotId::at(3), &SETTINGS);
    let readout = play.change_plots(|plots, run| plots.move_cursor(run, PlotId::at(3), 1)).unwrap();
    let count = readout.samples[0].text.strip_prefix("Count = ").and_then(|count| count.parse::<u32>().ok());
    assert!(count.is_some_and(|count| count <= 150), "{readout:?}");
}

#[test]
fn points_are_drawn_at_the_firings_of_an_event() {
    let source = "---\nstep: 0.03 [s]\nmethod: dormand-prince\ntolerance: 1e-10\n---\n\
        ```model\nparameter omega = 3 [rad/s] in 1..9\nx'' = -omega^2*x\nx(0) = 1 [m]\nx'(0) = 0 [m/s]\n\
        y'' = -9.8 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\n\
        every 2*pi/omega as drive { }\nwhen y < 0 [m] as landing { y' = -y' }\n```\n\
        ```plots\n\"Section\": points x' against x at drive\n\"Landings\": points y' against t at landing\n```\n";
    let mut play = open(source, &[]);
    go_on(&mut play, [1.0; 10]);
    let (_, rows) = table(&mut play, 0);
    assert!(rows.len() >= 4, "10 s hold 4 periods of 2.09 s: {rows:?}");
    assert!(rows.iter().all(|row| (row[0] - 1.0).abs() < 1e-6 && row[1].abs() < 1e-5), "{rows:?}");
    // The velocity is that before the bounce: sqrt(2 g h) downwards each time.
    let (_, rows) = table(&mut play, 1);
    let speed = libm::sqrt(2.0 * 9.8);
    for (number, row) in rows.iter().enumerate() {
        let time = (2.0 * number as f64 + 1.0) * speed / 9.8;
        assert!((row[0] - time).abs() < 1e-5 && (row[1] + speed).abs() < 1e-5, "{row:?}: {time}, {speed}");
    }
    assert_eq!(rows.len(), 11, "the first landing after 0.45 s, then one each 0.90 s");
    let all = rows;
    play.change_run(|line, _| line.scrub(1.0));
    play.change_run(|line, _| line.play());
    assert_eq!(table(&mut play, 1).1.len(), all.iter().filter(|row| row[0] <= 1.0).count());
    go_on(&mut play, [9.0]);
    assert_eq!(table(&mut play, 1).1, all);
}
