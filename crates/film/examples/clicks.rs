//! Tracks surfaces of generated films by twenty first clicks each, and counts what is wrong without a mark:
//!
//!     cargo run --release -p film --example clicks -- [KIND...] [--seeds N] [--first N] [--clicks N] [--frames]
//!
//! `wrong` counts clicks with a frame more than 6 pixels wrong that is in no doubt, and `silent` such frames; `doubt` is the part of right frames
//! that are in doubt, `missing` the part of the frames that show the surface and have no point, `refused` the clicks that were refused. `--frames` lists the frames of each click that are in doubt (?) or wrong (!).

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    reason = "a program for developers: it stops where something is missing"
)]

#[path = "../tests/all/tubes.rs"]
mod tubes;

use film::tracking::column::{Click, Settings};
use film::tracking::{Following, Plan, Surface, Track};
use std::time::Instant;
use tubes::{Draw, Taken, kind};

/// The kinds of film, each with a geometry of its own for every seed.
const KINDS: [&str; 12] = [
    "clean",
    "comb",
    "dark",
    "steps",
    "reflection",
    "leaves",
    "plain leaves",
    "hand",
    "bump",
    "low",
    "small",
    "textured",
];

fn tracked(taken: &Taken, click: Click, tilted: bool) -> Result<Track, String> {
    let settings = Settings { tube: tilted.then_some(taken.axis), ..Settings::new(click) };
    let plan = Plan {
        surfaces: vec![Surface { settings, anchors: Vec::new() }],
        bodies: Vec::new(),
        marks: Vec::new(),
        frames: (0..taken.planes.len()).map(|n| (n, n as f64 / 30.0)).collect(),
    };
    let mut following = Following::new(plan).map_err(|refusal| format!("{refusal:?}"))?;
    while let Some(frame) = following.wanted() {
        following.take(taken.planes[frame].clone()).map_err(|refusal| format!("{refusal:?}"))?;
    }
    following.advance(usize::MAX).map_err(|refusal| format!("{refusal:?}"))?;
    Ok(following.tracks()[0].clone())
}

fn main() {
    let (mut first, mut seeds, mut clicks) = (1, 3, 20);
    let mut listed = false;
    let mut wanted = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--seeds" => seeds = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(seeds),
            "--first" => first = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(first),
            "--clicks" => clicks = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(clicks),
            "--frames" => listed = true,
            _ => wanted.push(argument),
        }
    }
    for name in KINDS.iter().filter(|kind| wanted.is_empty() || wanted.iter().any(|one| one == *kind)) {
        for seed in first..first + seeds {
            let film = kind(name, seed, false);
            let taken = film.film();
            let mut draw = Draw::new(seed ^ 0xc11c);
            let (mut wrong, mut silent, mut refused, mut right, mut doubted, mut hidden) = (0, 0, 0, 0, 0, 0);
            let (mut missing, mut visible) = (0, 0);
            let (mut squares, mut relative, mut good) = (0.0, 0.0, 0.0);
            let started = Instant::now();
            for _ in 0..clicks {
                let mut frame = (draw.next() * taken.planes.len() as f64) as usize;
                while taken.hidden[frame] {
                    frame -= 1;
                }
                let [x, y] = taken.seen[frame];
                let position = [x + draw.between(-2.0, 2.0), y + draw.between(-2.0, 2.0)];
                let track = match tracked(&taken, Click { frame, position }, film.tilt != 0.0) {
                    Ok(track) => track,
                    Err(why) => {
                        if listed {
                            println!("  click {frame}: {why}");
                        }
                        refused += 1;
                        continue;
                    }
                };
                let along = |[x, y]: [f64; 2], [u, v]: [f64; 2]| {
                    (y - v) * libm::cos(film.tilt) - (x - u) * libm::sin(film.tilt)
                };
                let errors: Vec<f64> =
                    track.points.iter().map(|point| along(point.position, taken.truth[point.frame])).collect();
                let mut sorted = errors.clone();
                sorted.sort_by(f64::total_cmp);
                let middle = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0).clamp(-4.0, 4.0);
                let mut bad = 0;
                let has_point = |frame: usize| track.points.binary_search_by_key(&frame, |point| point.frame).is_ok();
                let shown: Vec<usize> = (0..taken.hidden.len()).filter(|frame| !taken.hidden[*frame]).collect();
                visible += shown.len();
                missing += shown.iter().filter(|frame| !has_point(**frame)).count();
                for (point, error) in track.points.iter().zip(&errors) {
                    let sigma = libm::hypot(point.sigma[0], point.sigma[1]);
                    let error = error - middle;
                    if error.abs() > 6.0 {
                        bad += usize::from(!point.doubtful);
                    } else if taken.hidden[point.frame] {
                        hidden += usize::from(!point.doubtful);
                    } else {
                        right += 1;
                        doubted += usize::from(point.doubtful);
                        if !point.doubtful {
                            squares += error * error;
                            relative += error * error / (sigma * sigma);
                            good += 1.0;
                        }
                    }
                }
                if listed {
                    let list: Vec<String> = track
                        .points
                        .iter()
                        .zip(&errors)
                        .filter(|(point, error)| point.doubtful || (*error - middle).abs() > 6.0)
                        .map(|(point, error)| {
                            format!(
                                "{}{}{:.0}/{:.2}",
                                point.frame,
                                if point.doubtful { "?" } else { "!" },
                                error - middle,
                                point.score
                            )
                        })
                        .collect();
                    println!("  click {frame} {:?}: {}", track.exposure, list.join(" "));
                }
                wrong += usize::from(bad > 0);
                silent += bad;
            }
            println!(
                "{name:13} {seed} {:?}x{} r {:.0} swing {:.0} T {:.0}: wrong {wrong:2} silent {silent:4} refused {refused:2} doubt {:.1} % missing {:.1} % hidden {hidden} rms {:.3} error/sigma {:.2}  {:.0} ms",
                film.size,
                film.frames,
                film.inner,
                film.swing,
                film.period,
                100.0 * doubted as f64 / f64::max(right as f64, 1.0),
                100.0 * missing as f64 / f64::max(visible as f64, 1.0),
                f64::sqrt(squares / f64::max(good, 1.0)),
                f64::sqrt(relative / f64::max(good, 1.0)),
                started.elapsed().as_secs_f64() * 1e3 / f64::from(clicks),
            );
        }
    }
}
