//! Times of frames: rates, gaps, doubled times, slow motion.

use crate::support::{bytes, open};
use film::timing::{Finding, Intervals, TimeBase, slow_motion};

/// Every finding on a list of times, in English.
fn english(times: &[f64], stated: Option<f64>) -> Vec<String> {
    let findings = Intervals::of(times).unwrap().findings(stated);
    findings.iter().map(|finding| finding.words().english()).collect()
}

fn steady(count: usize, rate: f64) -> Vec<f64> {
    (0..count).map(|n| n as f64 / rate).collect()
}

#[test]
fn regular_films() {
    assert_eq!(english(&steady(90, 30.0), Some(30.0)), ["30.00 frames/s, intervals spread by 0.00 ms"]);
    // Each frame a little early or late: 0.3 ms times the square root of 2, since an interval has two ends.
    let uneven: Vec<f64> = (0..900).map(|n| f64::from(n) / 29.97 + if n % 3 == 0 { 0.3e-3 } else { 0.0 }).collect();
    let intervals = Intervals::of(&uneven).unwrap();
    assert!((intervals.rate - 29.97).abs() < 1e-3 && (intervals.spread - 0.245e-3).abs() < 1e-5, "{intervals:?}");
    assert!(!intervals.is_variable() && intervals.gaps.is_empty());
    let spanish = intervals.findings(None)[0].words().text(catalogues::with(units::Language::Spanish)).into_owned();
    assert_eq!(spanish, "29,97 fotogramas/s, con una dispersión de los intervalos de 0,2 ms");
}

#[test]
fn gaps_are_found_where_frames_are_missing() {
    for (rate, missing) in [(30.0, vec![63, 64, 65]), (240.0, vec![5]), (60.0, vec![10, 30, 31, 118])] {
        let times: Vec<f64> = steady(120, rate)
            .into_iter()
            .enumerate()
            .filter(|(n, _)| !missing.contains(n))
            .map(|(_, time)| time)
            .collect();
        let intervals = Intervals::of(&times).unwrap();
        assert_eq!(intervals.gaps.iter().map(|gap| gap.missing).sum::<usize>(), missing.len(), "{rate}");
        assert!((intervals.rate - rate).abs() < 1e-6 * rate);
        let first = (missing[0] - 1) as f64 / rate;
        assert!((intervals.gaps[0].time - first).abs() < 1e-9);
    }
    let mut times = steady(120, 30.0);
    times.drain(64..67);
    assert_eq!(english(&times, None)[1], "a gap of 3 frames at 2.10 s");
}

/// A phone in dim light slows down from 30 to 24 frames a second and loses one frame: only that is a gap.
#[test]
fn a_variable_rate_is_no_gap() {
    let mut times = vec![0.0];
    for n in 1..200 {
        let interval = if n < 60 { 1.0 / 30.0 } else { 1.0 / 24.0 } + if n == 130 { 1.0 / 24.0 } else { 0.0 };
        times.push(times[n - 1] + interval);
    }
    let intervals = Intervals::of(&times).unwrap();
    assert!(intervals.is_variable());
    assert_eq!(intervals.gaps.iter().map(|gap| (gap.after, gap.missing)).collect::<Vec<_>>(), [(129, 1)]);
    assert!(english(&times, None)[0].contains("from 24.00 to 30.00"));
    // Half the rate from one frame on.
    let halved: Vec<f64> =
        (0..100).map(|n| if n < 50 { f64::from(n) / 30.0 } else { f64::from(2 * n - 50) / 30.0 }).collect();
    assert_eq!(Intervals::of(&halved).unwrap().gaps, []);
}

#[test]
fn milliseconds_of_webm_are_noticed() {
    let times: Vec<f64> = (0..90).map(|n| (f64::from(n) / 30.0 * 1e3).round() / 1e3).collect();
    let intervals = Intervals::of(&times).unwrap();
    assert!(intervals.rounded && !intervals.is_variable() && (intervals.rate - 30.0).abs() < 0.01, "{intervals:?}");
    assert!(!Intervals::of(&steady(90, 50.0)).unwrap().rounded, "0.02 s is exact");
    assert!(Intervals::of(&open(&bytes("vp9.webm")).unwrap().times()).unwrap().rounded);
}

#[test]
fn doubled_times_and_wrong_rates_are_said() {
    let mut times = steady(60, 30.0);
    times.insert(30, times[30]);
    let intervals = Intervals::of(&times).unwrap();
    assert_eq!((intervals.doubled.as_slice(), (intervals.rate - 30.0).abs() < 1e-9), (&[31][..], true));
    assert_eq!(
        english(&times, Some(25.0))[1..],
        [
            "a frame has the same time as the one before, 1.00 s; leave one of them out",
            "the file states 25.00 frames/s, its times give 30.00; the times are used"
        ]
    );
    assert_eq!((Intervals::of(&[]), Intervals::of(&[1.0]), Intervals::of(&[1.0, 1.0])), (None, None, None));
}

/// Cases: recording rate, playback rate (frames per second), and factor.
#[test]
fn slow_motion_divides_times() {
    for (captured, shown, factor) in [
        (240.0, 30.0, Some(8.0)),
        (240.0, 29.97, Some(8.0)),
        (120.0, 30.0, Some(4.0)),
        (120.0, 24.0, Some(5.0)),
        (960.0, 29.7, Some(32.0)),
        (60.0, 59.94, None),
        (30.0, 29.97, None),
        // In dim light: stated 30, but one every 1/15 s.
        (30.0, 15.0, None),
        (2.0, 30.0, Some(1.0 / 15.0)),
    ] {
        let intervals = Intervals::of(&steady(60, shown)).unwrap();
        let found = slow_motion(&intervals, captured);
        let found = found.map(|finding| match finding {
            Finding::SlowMotion { factor, .. } => factor,
            other => panic!("{other:?}"),
        });
        let near = |found: f64, factor: f64| (found / factor - 1.0).abs() < 1e-9;
        assert!(
            found.zip(factor).map_or(found == factor, |(found, factor)| near(found, factor)),
            "{captured} {shown} {found:?}"
        );
    }
    let film = open(&bytes("capture-rate.mp4")).unwrap();
    let intervals = Intervals::of(&film.times()).unwrap();
    let Some(Finding::SlowMotion { factor, .. }) = slow_motion(&intervals, film.capture_rate.unwrap()) else {
        panic!()
    };
    let base = TimeBase::new(&film.times(), factor).unwrap();
    assert!(base.times().iter().zip(0..).all(|(time, n)| (time - f64::from(n) / 240.0).abs() < 1e-6));
    for factor in [0.0, -2.0, f64::NAN, f64::INFINITY, 1e-9] {
        assert_eq!(TimeBase::new(&[0.0, 1.0], factor), None);
    }
}
