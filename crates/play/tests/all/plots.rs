//! Plots of a document: several paths in one plot, legends and descriptions.

use crate::support::{go_on, open, set, utube};
use figure::{Point, Settings};
use play::{Play, PlotId};

/// Two bodies on circles about each other, with equal axes.
fn bodies() -> Play {
    open(
        "```model\nparameter omega = 2 [rad/s]\nx_1 = cos(omega*t)\ny_1 = sin(omega*t)\nx_2 = -2*x_1\n\
         y_2 = -2*y_1 \"Height of the second\"\n```\n\
         ```plots\n\"Bodies\": y_1 \"Height\" against x_1, y_2 against x_2, equal axes\n\"Time\": x_1, x_2 against t\n```\n",
        &[],
    )
}

const SETTINGS: Settings = Settings { width: 640.0, height: 360.0, font_size: 13.0, decimal_comma: false, level: None };

#[test]
fn each_curve_is_drawn_against_its_own_abscissa() {
    let mut play = bodies();
    go_on(&mut play, [1.0]);
    let csv = play.plots_to_front().csv(PlotId::at(0));
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("x₁,y₁,x₂,y₂"));
    let mut rows = 0;
    for line in lines {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        for (x, y, radius) in [(row[0], row[1], 1.0), (row[2], row[3], 2.0)] {
            assert!((libm::hypot(x, y) - radius).abs() < 1e-12, "{line}");
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
        .map(|at| {
            play.change_plots(|plots, run| plots.hover(run, PlotId::at(0), Point { x: at.x, y: at.y })).unwrap().heading
        })
        .collect();
    assert!(headings[0].starts_with("x₁ = ") && headings[1].starts_with("x₂ = "), "{headings:?}");
    let svg = play.plots_to_front().svg(PlotId::at(0), &SETTINGS, &figure::Palette::LIGHT);
    let described = "Bodies: Height (y₁) against x₁. Height of the second (y₂) against x₂.";
    assert!(svg.contains(described), "{svg}");
    assert!(svg.contains("x₁, x₂"), "the axis names both");
}

/// A driven oscillator: the amplitude from the textbook, and that of the computed runs.
fn resonance() -> Play {
    let mut play = open(
        "---\nstep: 0.02 [s]\nuntil: 40 [s]\nmethod: rk4\n---\n\
         ```model\nparameter omega = 3 [rad/s] in 0.5..12 \"Driving frequency\"\nparameter omega_0 = 5 [rad/s]\n\
         parameter gamma = 0.5 [1/s] in 0..5 \"Damping\"\nparameter f = 1 [m/s^2]\n\
         A = f/sqrt((omega_0^2 - omega^2)^2 + (2*gamma*omega)^2) \"Amplitude\"\n\
         x'' + 2*gamma*x' + omega_0^2*x = f*cos(omega*t)\nx(0) = 0 [m]\nx'(0) = 0 [m/s]\n```\n\
         ```plots\n\"Theory\": A against omega in 1..12 [rad/s] step 0.5\n\
         \"Runs\": maximum(x) from 25 [s], A, x at end, mean(x^2) from 25 [s] against omega in 3..6 step 0.05\n```\n",
        &[],
    );
    // The second plot is folded at first.
    play.change_plots(|plots, _| plots.show(PlotId::at(1), true));
    play
}

/// The cells of a plot's CSV without the heading.
fn cells(play: &mut Play, plot: usize) -> Vec<Vec<f64>> {
    let csv = play.plots_to_front().csv(PlotId::at(plot));
    csv.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect()
}

fn amplitude(omega: f64, gamma: f64) -> f64 {
    1.0 / libm::hypot(25.0 - omega * omega, 2.0 * gamma * omega)
}

#[test]
fn a_definition_is_drawn_over_the_values_of_a_parameter_and_follows_the_others() {
    let mut play = resonance();
    for gamma in [0.5, 2.0] {
        set(&mut play, "gamma", gamma);
        let rows = cells(&mut play, 0);
        assert_eq!(rows.len(), 23);
        for (number, row) in rows.iter().enumerate() {
            assert_eq!(row[0], 1.0 + 0.5 * number as f64);
            assert!((row[1] - amplitude(row[0], gamma)).abs() < 1e-14, "{row:?}");
        }
    }
    assert_eq!(play.plots().progress(PlotId::at(0)), None);
    // The axis ends with the sweep, from 1 to 12, and has no tick label beyond.
    let svg = play.plots_to_front().svg(PlotId::at(0), &SETTINGS, &figure::Palette::LIGHT);
    assert!(svg.contains(">12<") && !svg.contains(">14<") && !svg.contains(">15<"), "{svg}");
    // The swept parameter moves the mark only.
    let before = cells(&mut play, 0);
    set(&mut play, "omega", 7.0);
    assert_eq!(cells(&mut play, 0), before);
    let readout = {
        play.layout_plot(PlotId::at(0), &SETTINGS);
        play.change_plots(|plots, run| plots.move_cursor(run, PlotId::at(0), 0)).unwrap()
    };
    assert!(readout.heading.starts_with("ω = 7"), "{readout:?}");
}

#[test]
fn runs_over_the_values_of_a_parameter_are_made_by_and_by() {
    let mut play = resonance();
    assert!(cells(&mut play, 1).iter().all(|row| row[1].is_nan() && (row[3] - amplitude(row[2], 0.5)).abs() < 1e-14));
    let mut slices = 0;
    while play.change_plots(|plots, run| plots.work(run)) {
        slices += 1;
        assert!(slices < 1000);
    }
    assert_eq!(play.plots().progress(PlotId::at(1)), None);
    let rows = cells(&mut play, 1);
    assert_eq!(rows.len(), 61);
    for row in &rows {
        // After 25 s the transient is e^-12.5 of its size; rows 0.02 s apart miss the top by (0.06)^2/2 at most.
        let expected = amplitude(row[0], 0.5);
        assert!((row[1] / expected - 1.0).abs() < 3e-3, "{row:?}");
        assert!((row[7] / (expected * expected / 2.0) - 1.0).abs() < 0.03, "{row:?}");
    }
    // The result is bit-identical however the work is divided.
    let mut other = resonance();
    other.change_run(|line, _| line.play());
    for _ in 0..slices + 50 {
        other.change_run(|line, _| line.tick(0.001));
        other.change_plots(|plots, run| plots.work(run));
    }
    assert_eq!(cells(&mut other, 1), rows);
    // Another parameter restarts the runs, the swept one does not.
    set(&mut play, "omega", 7.0);
    assert!(!play.change_plots(|plots, run| plots.work(run)));
    set(&mut play, "gamma", 2.0);
    assert!(play.change_plots(|plots, run| plots.work(run)));
    let (done, all) = play.plots().progress(PlotId::at(1)).unwrap();
    assert!(done < 61 && all == 61);
    while play.change_plots(|plots, run| plots.work(run)) {}
    assert!(cells(&mut play, 1).iter().all(|row| (row[1] / amplitude(row[0], 2.0) - 1.0).abs() < 3e-3));
    // Hidden plots are not computed.
    play.change_plots(|plots, _| plots.show(PlotId::at(1), false));
    set(&mut play, "gamma", 1.0);
    assert!(!play.change_plots(|plots, run| plots.work(run)));
}

/// The logistic map: one value up to r = 3, then two, (r + 1 +- sqrt((r - 3)(r + 1)))/(2 r), then four.
#[test]
fn points_of_a_map_over_the_values_of_a_parameter() {
    let mut play = open(
        "---\nuntil: 400\n---\n```model\nindependent n by 1\nparameter r = 3 in 0..4\nnext x = r*x*(1 - x)\nx(0) = 0.2\n```\n\
         ```plots\n\"Bifurcations\": points x from 381 against r in 2.5..3.5 step 0.1\n```\n",
        &[],
    );
    while play.change_plots(|plots, run| plots.work(run)) {}
    assert_eq!(play.plots().progress(PlotId::at(0)), None);
    let rows = cells(&mut play, 0);
    assert_eq!(rows.len(), 11 * 20, "20 points of each run");
    for (number, points) in rows.chunks(20).enumerate() {
        let r = 2.5 + 0.1 * number as f64;
        let expected = match r {
            ..2.95 => vec![1.0 - 1.0 / r],
            ..3.05 => continue,
            ..3.45 => [1.0, -1.0].map(|sign| (r + 1.0 + sign * ((r - 3.0) * (r + 1.0)).sqrt()) / (2.0 * r)).to_vec(),
            _ => {
                let mut values: Vec<f64> = points.iter().map(|row| row[1]).collect();
                values.sort_by(f64::total_cmp);
                values.dedup_by(|one, other| (*one - *other).abs() < 1e-9);
                assert_eq!(values.len(), 4, "{values:?}");
                continue;
            }
        };
        for row in points {
            assert!((row[0] - r).abs() < 1e-12, "{row:?}");
            assert!(expected.iter().any(|value| (row[1] - value).abs() < 1e-9), "{row:?} for {expected:?}");
        }
    }
}

/// At whole periods of the drive, a linear oscillator has the phase given by the textbook.
#[test]
fn points_at_an_event_over_the_values_of_a_parameter() {
    let mut play = open(
        "---\nstep: 0.02 [s]\nuntil: 40 [s]\n---\n\
         ```model\nparameter omega = 3 [rad/s] in 0.5..12\nx'' + 1 [1/s]*x' + 25 [1/s^2]*x = 1 [m/s^2]*cos(omega*t)\n\
         x(0) = 0 [m]\nx'(0) = 0 [m/s]\nevery 2*pi/omega as drive { }\n```\n\
         ```plots\n\"Sections\": points x from 30 [s], x' from 35 [s] against omega in 3..6 step 0.5 at drive\n```\n",
        &[],
    );
    while play.change_plots(|plots, run| plots.work(run)) {}
    let rows = cells(&mut play, 0);
    for omega in (0..7).map(|number| 3.0 + 0.5 * f64::from(number)) {
        let own: Vec<&Vec<f64>> = rows.iter().filter(|row| (row[0] - omega).abs() < 1e-12).collect();
        let period = std::f64::consts::TAU / omega;
        assert_eq!(own.len(), (40.0 / period).floor() as usize - (30.0 / period).floor() as usize, "{omega}");
        let (real, imaginary) = (25.0 - omega * omega, omega);
        let square = real * real + imaginary * imaginary;
        for (number, row) in own.iter().enumerate() {
            assert!((row[1] - real / square).abs() < 1e-5, "{row:?}");
            let is_late = ((30.0 / period).floor() + 1.0 + number as f64) * period >= 35.0;
            assert_eq!(row[3].is_finite(), is_late, "{row:?}");
            assert!(!is_late || (row[3] - omega * imaginary / square).abs() < 1e-5, "{row:?}");
        }
    }
}

#[test]
fn a_section_has_a_point_at_each_multiple_of_the_period() {
    let source = "---\nstep: 0.03 [s]\nmethod: dormand-prince\ntolerance: 1e-10\n---\n\
        ```model\nparameter omega = 3 [rad/s] in 1..9\nx'' = -omega^2*x\nx(0) = 1 [m]\nx'(0) = 0 [m/s]\n```\n\
        ```plots\n\"Section\": points x' against x every 2*pi/omega\n\"Quarters\": points x against t every pi/2/omega from 1 [s]\n```\n";
    let mut play = open(source, &[]);
    go_on(&mut play, [1.0; 10]);
    let rows = cells(&mut play, 0);
    assert_eq!(rows.len(), 4, "10 s hold 4 periods of 2.09 s");
    assert!(rows.iter().all(|row| (row[0] - 1.0).abs() < 1e-6 && row[1].abs() < 1e-5), "{rows:?}");
    let quarter = std::f64::consts::PI / 6.0;
    let quarters = cells(&mut play, 1);
    for (number, row) in quarters.iter().enumerate() {
        let time = 1.0 + number as f64 * quarter;
        assert!((row[0] - time).abs() < 1e-12 && (row[1] - libm::cos(3.0 * time)).abs() < 1e-6, "{row:?}");
    }
    assert_eq!(quarters.len(), 18);
    // Discarded rows take their points with them. Recomputed rows have the same points.
    play.change_run(|line, _| line.scrub(5.0));
    play.change_run(|line, _| line.play());
    assert_eq!(cells(&mut play, 0).len(), 2);
    go_on(&mut play, [5.0]);
    assert_eq!(cells(&mut play, 0), rows);
    play.layout_plot(PlotId::at(0), &SETTINGS);
    assert!(
        play.change_plots(|plots, run| plots.move_cursor(run, PlotId::at(0), 1)).unwrap().heading.starts_with("x = ")
    );
    play.change_run(|line, basis| line.back_to_start(basis));
    assert!(cells(&mut play, 0).is_empty());
}

#[test]
fn a_run_that_an_event_ends_has_a_value_there() {
    let source = "---\nstep: 0.05 [s]\nuntil: 20 [s]\n---\n\
        ```model\nparameter alpha = 30 [deg] in 5..85\nparameter v = 20 [m/s]\nparameter g = 10 [m/s^2]\n\
        x'' = 0\ny'' = -g\nx(0) = 0\ny(0) = 0\nx'(0) = v*cos(alpha)\ny'(0) = v*sin(alpha)\n\
        when y < 0 [m] { stop }\n```\n\
        ```plots\n\"Range\": x at end against alpha in 10..80 [deg] step 10\n```\n";
    let mut play = open(source, &[]);
    while play.change_plots(|plots, run| plots.work(run)) {}
    let rows = cells(&mut play, 0);
    assert_eq!(rows.len(), 8);
    for row in rows {
        let range = 40.0 * libm::sin((2.0 * row[0]).to_radians());
        assert!((row[1] - range).abs() < 1e-6, "{row:?}: {range}");
    }
}

#[test]
fn axes_have_the_range_of_the_first_part_from_the_beginning() {
    let settings = Settings::default();
    let mut play = utube();
    let limits = |play: &mut Play| -> Vec<[figure::Interval; 2]> {
        let plots = 0..play.plots().list().len();
        let of = |plot| {
            let figure = play.layout_plot(PlotId::at(plot), &settings).unwrap();
            [figure.x_scale().unwrap().values, figure.y_scales()[0].values]
        };
        plots.map(of).collect()
    };
    let at_rest = limits(&mut play);
    assert!(at_rest[0][1].low < 0.0 && at_rest[0][1].high > 0.0, "{at_rest:?}");
    for _ in 0..3 {
        go_on(&mut play, [0.4]);
        assert_eq!(limits(&mut play), at_rest);
    }
    // Other parameters, another start, another first part.
    play.change_run(|line, basis| line.back_to_start(basis));
    set(&mut play, "g", 1.62);
    let on_the_moon = limits(&mut play);
    assert_ne!(on_the_moon, at_rest, "energies differ");
    go_on(&mut play, [1.0]);
    assert_eq!(limits(&mut play), on_the_moon);
}
