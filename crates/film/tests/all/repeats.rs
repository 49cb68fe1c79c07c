//! Repeated pictures are found by the differences of successive ones, and none where there are none.

use crate::support::bytes;
use film::timing::repeats;

/// A film of 200 frames whose frame `n` shows the picture `shown(n)`: differences of a swing whose motion stops twice in `period`
/// pictures. Coding changes a picture that is shown again by `coding`, and each by as much.
fn differences(shown: &dyn Fn(usize) -> usize, period: f64, coding: f64) -> Vec<f64> {
    let mut state = 1_u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1_u32 << 24)
    };
    let place = |picture: usize| libm::sin(std::f64::consts::TAU * picture as f64 / period + 0.3);
    (1..200)
        .map(|n| 3.0 * (place(shown(n)) - place(shown(n - 1))).abs() * period / 6.0 + coding * (0.3 + 0.7 * noise()))
        .collect()
}

fn repeated(shown: &dyn Fn(usize) -> usize) -> Vec<usize> {
    (1..200).filter(|&n| shown(n) == shown(n - 1)).collect()
}

/// Rates of cameras in those of players: every repeat is found, also where the motion stops.
#[test]
fn all_repeats_of_a_pattern_are_found() {
    for (taken, written) in
        [(25, 50), (24, 30), (25, 30), (24, 60), (30, 50), (20, 60), (25, 60), (15, 25), (15, 24), (15, 60)]
    {
        for phase in 0..4 {
            for period in [17.0, 40.0, 90.0] {
                for coding in [0.01, 0.2, 0.5] {
                    let shown = |n: usize| (n * taken + phase * written / 4) / written;
                    let found = repeats(&differences(&shown, period, coding));
                    assert_eq!(found, repeated(&shown), "{taken} in {written}, {phase}, {period}, {coding}");
                }
            }
        }
    }
}

/// Motion that stops, slow and fast, with much and little noise of the coding.
#[test]
fn films_that_were_not_converted_have_none() {
    for period in [8.3, 9.7, 10.0, 12.0, 17.0, 25.0, 40.0, 90.0, 300.0] {
        for coding in [0.0, 0.01, 0.05, 0.2, 0.5, 2.0] {
            assert_eq!(repeats(&differences(&|n| n, period, coding)), [0; 0], "{period}, {coding}");
        }
    }
}

#[test]
fn copies_without_a_pattern_are_found() {
    let shown = |n: usize| n - n / 7 - n / 11;
    assert_eq!(repeats(&differences(&shown, 1000.0, 0.01)), repeated(&shown));
    let (early, late) = (|n: usize| n / 2, |n: usize| n);
    let changing = |n: usize| if n < 100 { early(n) } else { late(n) - 50 };
    assert_eq!(repeats(&differences(&changing, 1000.0, 0.01)), repeated(&changing), "the first half");
}

#[test]
fn what_rests_is_not_repeated() {
    let moving = differences(&|n| n, 1000.0, 0.3);
    let with = |rests: &dyn Fn(usize) -> bool| -> Vec<f64> {
        moving.iter().enumerate().map(|(at, value)| if rests(at) { 0.01 } else { *value }).collect()
    };
    assert_eq!(repeats(&with(&|at| at == 57)), [0; 0], "a single one");
    assert_eq!(repeats(&with(&|at| at > 120)), [0; 0], "at rest from frame 121 on");
    assert_eq!(repeats(&with(&|at| at % 20 < 10)), [0; 0], "stops and goes");
    assert_eq!(repeats(&[0.0; 50]), [0; 0], "a still picture");
    assert_eq!(repeats(&[]), [0; 0]);
}

/// A long film whose pattern changes its phase: each block has its own.
#[test]
fn the_phase_of_a_pattern_may_change() {
    let shown = |n: usize| if n < 900 { n / 2 } else { n.div_ceil(2) };
    let moving = |n: usize| 1.0 + 0.8 * libm::sin(n as f64 * 0.2);
    let differences: Vec<f64> =
        (1..1800).map(|n| if shown(n) == shown(n - 1) { 0.3 } else { moving(n) + 0.3 }).collect();
    let expected: Vec<usize> = (1..1800).filter(|&n| shown(n) == shown(n - 1)).collect();
    let found = repeats(&differences);
    let missed = expected.iter().filter(|n| found.binary_search(n).is_err()).count();
    let wrong = found.iter().filter(|n| expected.binary_search(n).is_err()).count();
    assert!(missed <= 100 && wrong == 0, "{missed} {wrong}");
}

/// Differences measured in films of a tube and of a ball: 120 drawn pictures of 320 x 240 pixels with noise of 0.5 or 2 grey values, coded by
/// `libx264` and `mpeg4` of ffmpeg 5.1 as the lines of the file say.
#[test]
fn repeats_are_found_in_coded_films() {
    for line in String::from_utf8(bytes("differences.csv")).unwrap().lines() {
        let fields: Vec<&str> = line.split(';').collect();
        let differences: Vec<f64> = fields[2].split(' ').map(|value| value.parse().unwrap()).collect();
        let shown = |n: usize| match fields[1] {
            "double" => n / 2,
            "24to30" => n * 4 / 5,
            "24to60" => n * 2 / 5,
            "30to50" => n * 3 / 5,
            _ => n,
        };
        let expected: Vec<usize> = (1..=differences.len()).filter(|&n| shown(n) == shown(n - 1)).collect();
        assert_eq!(repeats(&differences), expected, "{}", fields[0]);
    }
}
