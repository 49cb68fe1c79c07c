//! Agreement of a track with the truth.

use film::tracking::Point;

/// Differences between positions and truth, minus their mean.
#[derive(Debug)]
pub struct Agreement {
    /// Root mean square, px.
    pub error: f64,
    /// Root mean square in units of the standard errors.
    pub relative: f64,
    /// Largest difference, px.
    pub worst: f64,
}

/// Compares one coordinate of a track.
pub fn agreement(points: &[Point], axis: usize, truth: impl Fn(&Point) -> f64) -> Agreement {
    let count = points.len() as f64;
    let errors: Vec<f64> = points.iter().map(|point| point.position[axis] - truth(point)).collect();
    let mean = errors.iter().sum::<f64>() / count;
    let errors: Vec<f64> = errors.iter().map(|error| error - mean).collect();
    let relative: f64 = errors.iter().zip(points).map(|(error, point)| error / point.sigma[axis]).map(|e| e * e).sum();
    Agreement {
        error: (errors.iter().map(|error| error * error).sum::<f64>() / count).sqrt(),
        relative: (relative / count).sqrt(),
        worst: errors.iter().fold(0.0, |worst, error| error.abs().max(worst)),
    }
}

/// Asserts that the root mean square error of a track is below `error`, and that its standard errors are realistic.
#[track_caller]
pub fn assert_exact(name: &str, found: &Agreement, error: f64) {
    assert!(found.error < error, "{name}: {found:?}");
    assert!(found.worst < 8.0 * error, "{name}: {found:?}");
    assert!((0.7..1.4).contains(&found.relative), "{name}: {found:?}");
}
