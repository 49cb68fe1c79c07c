//! Golden results of measured data: cycles, fits and tracks, which must have the same bits on every machine as runs must.

use crate::fits::Fits;
use analysis::cycles::cycles;
use film::Plane;
use film::tracking::{Following, Plan, Surface, Track, body, column};
use units::split_mix::{SplitMix64, scramble};

/// Number of rows and frames.
const ROWS: usize = 90;
/// Rows and frames per second.
const RATE: f64 = 30.0;
/// Size of a frame, px.
const WIDTH: usize = 48;
const HEIGHT: usize = 96;

/// One line for each golden result: `name method rows fingerprint`.
pub fn golden_measured() -> String {
    let (times, levels) = record();
    let results = [
        ("cycles -", of_cycles(&times, &levels)),
        ("fit formula", of_fit(&times, &levels, Fits::formula_outcome)),
        ("fit motion", of_fit(&times, &levels, Fits::motion_outcome)),
        ("track surface", of_track(&levels, surface)),
        ("track body", of_track(&levels, body)),
    ];
    results.map(|(name, found)| format!("{name} {ROWS} {}\n", found.unwrap_or_else(|message| message))).concat()
}

/// Times, s, and levels, m: a damped swing with noise, made by additions and multiplications alone.
fn record() -> (Vec<f64>, Vec<f64>) {
    let mut noise = SplitMix64::new(1);
    // Two neighbours of a swing with a period of 18 rows and a damping of 1.4 % a row.
    let (mut before, mut now) = (0.0379, 0.04);
    let level = |_| {
        (before, now) = (now, 1.8532 * now - 0.9722 * before);
        now + 1e-3 * ((noise.bits() >> 11) as f64 / (1_u64 << 53) as f64 - 0.5)
    };
    ((0..ROWS).map(|row| row as f64 / RATE).collect(), (0..ROWS).map(level).collect())
}

/// Hash of numbers, in 16 hexadecimal digits.
fn hash(numbers: impl IntoIterator<Item = f64>) -> String {
    format!("{:016x}", numbers.into_iter().fold(0, |hash, number| scramble(hash ^ number.to_bits())))
}

fn of_cycles(times: &[f64], levels: &[f64]) -> Result<String, String> {
    let found = cycles(times, levels).map_err(|why| format!("{why:?}"))?;
    let numbers = found.cycles.iter().flat_map(|cycle| {
        let measured = [cycle.time, cycle.amplitude, cycle.period, cycle.decrement, cycle.damping, cycle.offset];
        measured.into_iter().flat_map(|one| [one.value, one.error])
    });
    Ok(hash(numbers))
}

fn of_fit(
    times: &[f64],
    levels: &[f64],
    outcome: impl Fn(&Fits) -> Result<analysis::fit::Outcome, String>,
) -> Result<String, String> {
    let outcome = outcome(&Fits::new(times, levels)?)?;
    let estimates = outcome.parameters.iter().chain(&outcome.derived);
    let numbers = estimates
        .flat_map(|one| [Some(one.value), one.stderr, one.stderr_hac])
        .map(|number| number.unwrap_or(f64::NAN));
    Ok(hash(numbers.chain([outcome.chi2, outcome.rmse, outcome.bic])))
}

/// Hash of the track in a film of these levels. `follow`: what is followed, clicked in the first frame at this row of the picture, px.
fn of_track(levels: &[f64], follow: impl Fn(f64) -> Plan) -> Result<String, String> {
    let rows: Vec<f64> = levels.iter().map(|level| 48.0 - 800.0 * level).collect();
    let mut following = Following::new(follow(rows[0])).map_err(|refusal| format!("{refusal:?}"))?;
    while let Some(frame) = following.wanted() {
        let plane = rows.get(frame).and_then(|&row| drawn(frame, row)).ok_or("no frame")?;
        following.take(plane).map_err(|refusal| format!("{refusal:?}"))?;
    }
    following.advance(usize::MAX).map_err(|refusal| format!("{refusal:?}"))?;
    let tracks = following.tracks();
    let points = tracks.iter().flat_map(|track: &Track| &track.points);
    let numbers: Vec<f64> = points.flat_map(|point| [point.position, point.sigma].concat()).collect();
    if numbers.is_empty() { Err("no points".to_owned()) } else { Ok(hash(numbers)) }
}

fn frames() -> Vec<(usize, f64)> {
    (0..ROWS).map(|frame| (frame, frame as f64 / RATE)).collect()
}

fn surface(row: f64) -> Plan {
    let click = column::Click { frame: 0, position: [12.0, row] };
    let surfaces = vec![Surface { settings: column::Settings::new(click), anchors: Vec::new() }];
    Plan { surfaces, bodies: Vec::new(), marks: Vec::new(), frames: frames() }
}

fn body(row: f64) -> Plan {
    let click = column::Click { frame: 0, position: [36.0, row] };
    let bodies =
        vec![body::Settings { keys: vec![click], radius: Some(5.0), readout: film::tracking::Known::Estimated }];
    Plan { surfaces: Vec::new(), bodies, marks: Vec::new(), frames: frames() }
}

/// A frame with noise: a liquid in a tube on the left and a disc on the right, whose surface and centre are at `row`, px.
fn drawn(frame: usize, row: f64) -> Option<Plane> {
    let mut noise = SplitMix64::new(frame as u64 + 100);
    let grey = |pixel: usize| {
        let (x, y) = ((pixel % WIDTH) as f64, (pixel / WIDTH) as f64);
        let in_liquid = if (8.0..16.0).contains(&x) { (y - row + 0.5).clamp(0.0, 1.0) } else { 0.0 };
        let distance = ((x - 36.0) * (x - 36.0) + (y - row) * (y - row)).sqrt();
        let in_disc = (5.5 - distance).clamp(0.0, 1.0);
        let shade = 200.0 - 100.0 * in_liquid - 140.0 * in_disc + (noise.bits() >> 61) as f64;
        shade as u8
    };
    Plane::new(WIDTH, HEIGHT, (0..WIDTH * HEIGHT).map(grey).collect())
}
