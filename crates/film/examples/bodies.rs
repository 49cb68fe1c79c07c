//! Follows bodies in drawn films whose truth is known, by clicks beside their middles, and prints how each went:
//!
//!     cargo run --release -p film --example bodies -- [KIND...] [--overlap] [FIRST SEED]
//!
//! Sizes, speeds, colours and exposures vary with the seed. `wrong` are frames more than 6 pixels off after the shift of the click,
//! `silent` those of them without a mark, `false` marks on right frames. A click on both of two equal bodies does not show which of them is meant: marks
//! on such a track are true, and `both` counts them. `--overlap` clicks in the frame in which both bodies are nearest to one
//! another.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a program for developers: it stops where something is missing"
)]

#[path = "../tests/all/stage/mod.rs"]
mod stage;

use film::tracking::body::{Body, Settings};
use film::tracking::column::Click;
use film::tracking::{Known, Similarity};
use stage::{Kind, Stage};
use std::time::Instant;

/// First clicks in films of each kind.
const CLICKS: u64 = 20;

/// Frame in the first two thirds of a film in which the first two bodies are nearest to one another; 0 for one body.
fn nearest(stage: &Stage, frames: usize) -> usize {
    let distance = |frame: &usize| {
        let [one, other] = [0, stage.bodies() - 1].map(|body| stage.place(body, *frame as f64));
        libm::hypot(one[0] - other[0], one[1] - other[1])
    };
    (0..2 * frames / 3).min_by(|one, other| distance(one).total_cmp(&distance(other))).unwrap_or(0)
}

fn main() {
    let mut wanted: Vec<String> = std::env::args().skip(1).collect();
    let seed: u64 = wanted.pop_if(|last| last.parse::<u64>().is_ok()).map_or(0, |last| last.parse().expect("a seed"));
    let overlap = wanted.iter().position(|one| one == "--overlap").map(|at| wanted.remove(at)).is_some();
    let kinds = [
        Kind::DoublePendulum,
        Kind::Chaos,
        Kind::Twins,
        Kind::Leaves,
        Kind::Ball,
        Kind::Wall,
        Kind::Boards,
        Kind::Plain,
    ];
    for kind in kinds {
        let name = format!("{kind:?}");
        if !wanted.is_empty() && !wanted.iter().any(|one| name.starts_with(one.as_str())) {
            continue;
        }
        let mut total = [0_usize; 6];
        let mut both = 0;
        let mut silently = 0;
        let mut ends_wrong = 0;
        let mut tracks = 0_u64;
        let mut seconds = 0.0;
        let bodies = if matches!(kind, Kind::DoublePendulum | Kind::Chaos | Kind::Twins) { 2 } else { 1 };
        for seed in seed..seed + CLICKS / bodies {
            let height = [240, 360, 480, 720, 1080][seed as usize % 5];
            let frames = if height > 500 { 90 } else { 240 };
            let coloured = seed % 2 == 0 || kind == Kind::Chaos;
            let stage = Stage::new(kind, seed, height, frames, coloured);
            let planes: Vec<_> = (0..frames).map(|frame| stage.frame(frame)).collect();
            for body in 0..stage.bodies() {
                let first = if overlap { nearest(&stage, frames) } else { (seed as usize * 7) % 40 };
                let position = stage.click(body, first, seed + 100 * body as u64, 0.6);
                let settings =
                    Settings { keys: vec![Click { frame: first, position }], radius: None, readout: Known::Estimated };
                let mut tracker = Body::new(settings);
                let started = Instant::now();
                let mut refused = None;
                for (frame, plane) in planes.iter().enumerate() {
                    if let Err(refusal) = tracker.take(frame, frame as f64 / 30.0, plane, Similarity::IDENTITY) {
                        refused = Some(refusal);
                        break;
                    }
                }
                let took = started.elapsed().as_secs_f64();
                let track = tracker.finish();
                let refined = started.elapsed().as_secs_f64() - took;
                let middle = stage.place(body, first as f64);
                let shift = [position[0] - middle[0], position[1] - middle[1]];
                let (mut wrong, mut silent, mut marked) = (0, 0, 0);
                let mut late = false;
                let mut squares = Vec::new();
                for point in &track.points {
                    let truth = stage.place(body, point.frame as f64);
                    let off = [0, 1].map(|k| point.position[k] - truth[k] - shift[k]);
                    let far = libm::hypot(off[0], off[1]);
                    late = far > 6.0;
                    if far > 6.0 {
                        wrong += 1;
                        silent += usize::from(!point.doubtful);
                    } else {
                        marked += usize::from(point.doubtful);
                        squares.push(far * far);
                    }
                }
                let rms = (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
                let right = track.points.len() - wrong;
                let is_on = |other: usize| {
                    let [x, y] = stage.place(other, first as f64);
                    libm::hypot(position[0] - x, position[1] - y) < stage.radius
                };
                if kind == Kind::Twins && (0..stage.bodies()).all(is_on) {
                    both += std::mem::take(&mut marked);
                }
                tracks += 1;
                seconds += took + refined;
                silently += usize::from(silent > 0);
                ends_wrong += usize::from(late);
                for (sum, value) in total.iter_mut().zip([frames - first, right, wrong, silent, marked]) {
                    *sum += value;
                }
                println!(
                    "{name:14} {seed:2} body {body} rows {height:4} radius {:4.1} speed {:.1} {} found radius {:5.1}: of {} right {right} wrong {wrong} \
                     silent {silent} false {marked} rms {rms:.2} lost {:?} {} {took:.2}+{refined:.2} s",
                    stage.radius,
                    stage.speed,
                    if coloured { "colour" } else { "grey  " },
                    tracker.radius().unwrap_or(0.0),
                    frames - first,
                    track.lost,
                    refused.map_or(String::new(), |refusal| format!("{refusal:?}"))
                );
            }
        }
        println!(
            "{name}: {tracks} tracks, {silently} silently wrong, {ends_wrong} end wrong; frames {} right {} wrong {} silent {} false marks {} ({:.2} %) both {both}, {seconds:.0} s",
            total[0],
            total[1],
            total[2],
            total[3],
            total[4],
            100.0 * total[4] as f64 / total[1].max(1) as f64
        );
    }
}
