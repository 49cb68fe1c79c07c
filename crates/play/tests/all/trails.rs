//! Where points of the scene have been.

use crate::support::{go_on, open, set};
use play::Play;

/// A body on a circle of 100 units about (200, 150), and a body that jumps.
fn circle(step: &str) -> Play {
    open(
        &format!(
            "---\nstep: {step}\nlanguage: en\n---\n```model\nparameter omega = 2 [rad/s] in 1..5\nparameter span = 1 [s]\n\
             x = 1 [m]*cos(omega*t)\ny = 1 [m]*sin(omega*t)\ndiscrete n = 0\nevery 1 [s] {{ n = n + 1 }}\n```\n\
             ```scene\n<svg viewBox=\"0 0 400 300\">\n<frame x=\"-2..2 [m]\" y=\"-1.5..1.5 [m]\">\n\
             <trail at=\"(x, y)\" last=\"span\"/>\n<trail at=\"(x, y)\" every=\"0.25 [s]\"/>\n\
             <trail at=\"(n*0.1 [m], 0)\"/>\n</frame>\n</svg>\n```\n"
        ),
        &[],
    )
}

/// The points of a trail, and how many lines it consists of.
fn points(play: &mut Play, trail: usize) -> (Vec<(f64, f64)>, usize) {
    let mut path = String::new();
    play.scene().write_trail(trail, &mut path);
    let numbers = path.split(['M', 'L']).filter(|part| !part.is_empty()).map(|part| {
        let (x, y) = part.trim_end_matches("h0").split_once(' ').unwrap();
        (x.parse().unwrap(), y.parse().unwrap())
    });
    (numbers.collect(), path.matches('M').count())
}

fn at(time: f64) -> (f64, f64) {
    (200.0 + 100.0 * libm::cos(2.0 * time), 150.0 - 100.0 * libm::sin(2.0 * time))
}

fn near(found: (f64, f64), time: f64) -> bool {
    (found.0 - at(time).0).abs() < 0.01 && (found.1 - at(time).1).abs() < 0.01
}

#[test]
fn a_trail_is_the_way_of_the_last_seconds_at_every_moment() {
    let mut play = circle("0.05 [s]");
    go_on(&mut play, [0.52; 6]);
    for (time, first) in [(3.12, 2.15), (0.5, 0.0), (2.0, 1.0), (3.12, 2.15), (0.0, 0.0)] {
        play.change_run(|line, _| line.scrub(time));
        let (line, lines) = points(&mut play, 0);
        assert_eq!(lines, 1);
        assert!(near(line[0], first) && near(*line.last().unwrap(), time), "{time} s: {line:?}");
        for pair in line.windows(2) {
            let step = libm::hypot(pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
            assert!(step <= 10.02, "no row of 0.05 s is left out at {time} s");
        }
    }
    // What lasts no time is a point.
    set(&mut play, "span", 0.0);
    assert!(points(&mut play, 0).0.len() <= 2);
}

#[test]
fn a_stroboscope_has_a_dot_at_each_multiple() {
    let mut play = circle("0.06 [s]");
    go_on(&mut play, [0.5; 5]);
    for (time, dots) in [(2.5, 11), (0.3, 2), (1.0, 5)] {
        play.change_run(|line, _| line.scrub(time));
        let (found, single) = points(&mut play, 1);
        assert_eq!((found.len(), single), (dots, dots), "{time} s");
        for (number, found) in found.into_iter().enumerate() {
            // Between rows the state is interpolated, the time is exact.
            assert!(near(found, 0.25 * number as f64), "dot {number}: {found:?}");
        }
    }
}

#[test]
fn a_jump_leaves_a_gap_and_long_trails_are_bounded() {
    let mut play = circle("0.05 [s]");
    go_on(&mut play, [0.7; 5]);
    let (line, lines) = points(&mut play, 2);
    assert_eq!(lines, 4, "three jumps in 3.5 s: {line:?}");
    let mut play = circle("0.001 [s]");
    go_on(&mut play, [1.0; 10]);
    let (line, _) = points(&mut play, 2);
    assert!(line.len() <= 1001 && line.len() > 400, "{} points of 10,000 rows", line.len());
    let (line, _) = points(&mut play, 0);
    assert!(line.len() <= 1001 && near(*line.last().unwrap(), 10.0));
}
