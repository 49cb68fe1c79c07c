//! Films of drawings.

use crate::scenes::{HEIGHT, Scene, Tube, WIDTH};
use film::Plane;
use film::camera::{Exposure, Noise, instants};
use film::tracking::Similarity;
use film::tracking::column::{Click, Column, Settings};

fn even(grey: u8) -> Plane {
    Plane::new(400, 250, vec![grey; 100_000]).unwrap()
}

fn developed(grey: u8, sigma: f64, frame: u64) -> Vec<f64> {
    let plane = Exposure::new(&even(grey)).develop(&Noise::new(sigma, 3), frame).unwrap();
    plane.grey().iter().map(|grey| f64::from(*grey)).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[test]
fn noise_has_the_variance_that_was_asked_for_and_grows_with_the_light() {
    for (grey, factor) in [(128, 1.0), (32, 0.25), (200, 200.0 / 128.0)] {
        let values = developed(grey, 5.0, 0);
        let average = mean(&values);
        let variance = mean(&values.iter().map(|value| (value - average) * (value - average)).collect::<Vec<_>>());
        // Of whole grey values: rounding adds 1/12. A pool of 65,536 deviates has a mean within 4/256 of its deviation.
        assert!((average - f64::from(grey)).abs() < 0.08, "{average}");
        assert!((variance / (25.0 * factor + 1.0 / 12.0) - 1.0).abs() < 0.03, "{variance}");
    }
}

#[test]
fn frames_and_rows_have_noise_of_their_own_and_a_seed_repeats_it() {
    let (first, second) = (developed(128, 5.0, 0), developed(128, 5.0, 1));
    let correlation = |left: &[f64], right: &[f64]| {
        mean(&left.iter().zip(right).map(|(a, b)| (a - 128.0) * (b - 128.0)).collect::<Vec<_>>()) / 25.0
    };
    assert!(correlation(&first, &second).abs() < 0.02);
    assert!(correlation(&first[400..], &first).abs() < 0.02);
    assert_eq!(first, developed(128, 5.0, 0));
}

#[test]
fn without_noise_an_exposure_is_the_mean_of_its_drawings() {
    let mut exposure = Exposure::new(&even(10));
    assert!(exposure.add(&even(20)) && exposure.add(&even(60)));
    assert!(!exposure.add(&Plane::new(1, 1, vec![0]).unwrap()), "another size");
    assert_eq!(exposure.develop(&Noise::new(0.0, 1), 7), Some(even(30)));
    let times: Vec<f64> = instants(1.0, 0.04, 4).collect();
    let expected = [0.985, 0.995, 1.005, 1.015];
    assert!(times.iter().zip(expected).all(|(time, expected)| (time - expected).abs() < 1e-12), "{times:?}");
}

/// A drawn, blurred and noisy surface is tracked to its drawn position.
#[test]
fn a_drawn_tube_is_tracked_back() {
    let tube = Tube::default();
    let noise = Noise::new(2.0, 9);
    let drawn = |time: f64| {
        let grey = |at: usize| {
            let (x, y) = ((at % WIDTH) as f64 + 0.5, (at / WIDTH) as f64 + 0.5);
            tube.grey(x, y, time).round().clamp(0.0, 255.0) as u8
        };
        Plane::new(WIDTH, HEIGHT, (0..WIDTH * HEIGHT).map(grey).collect()).unwrap()
    };
    let mut column = Column::new(Settings::new(Click { frame: 0, position: tube.place(0.0) }));
    let times: Vec<f64> = (0..60).map(|frame| f64::from(frame) / 30.0).collect();
    for (frame, time) in times.iter().enumerate() {
        let mut pictures = instants(*time, 0.01, 5).map(drawn);
        let mut exposure = Exposure::new(&pictures.next().unwrap());
        assert!(pictures.all(|picture| exposure.add(&picture)));
        let plane = exposure.develop(&noise, frame as u64).unwrap();
        column.take(frame, *time, &plane, Similarity::IDENTITY).unwrap();
    }
    let track = column.finish().unwrap();
    let errors: Vec<f64> =
        track.points.iter().zip(&times).map(|(point, time)| point.position[1] - tube.place(*time)[1]).collect();
    let shift = mean(&errors);
    let rms = mean(&errors.iter().map(|error| (error - shift) * (error - shift)).collect::<Vec<_>>()).sqrt();
    assert_eq!(errors.len(), 60);
    assert!(rms < 0.08, "{rms}");
}
