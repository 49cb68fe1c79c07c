//! Tracks bodies in the films of a folder by one click each and compares with the truth beside the films:
//!
//!     cargo run --release -p film --example clicked -- FOLDER [NAME...] [--start N] [--beside PART] [--radius PX] [--frames]
//!
//! Clicks lie on the middle in frames 0, n/7 and n/3 of n, or only in frame N, and PART radii beside it. A row is right within 3 pixels of the truth
//! after the shift of the click. `kept` counts tracks with 90 % right rows of those in which the body is seen, and `quiet` wrong rows without a mark.
//! `--frames` lists the rows that are wrong without a mark (!), wrong (w) or in doubt (?).
//!
//! Needs `ffmpeg`. The truth of FILM.mp4 or .mpg lies in FILM.json: `file`, `tracks` and `frames` with `t` (s), `xy` (px) and `vis` (seen) of each
//! track; `radius` (px) for `--beside`.

#![allow(clippy::expect_used, reason = "a program for developers: it stops where something is missing")]

use film::Plane;
use film::tracking::body::{Body, Settings};
use film::tracking::column::Click;
use film::tracking::{Known, Similarity, Track};
use film::y4m::Reader;
use serde_json::Value;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Distance from the truth in px from which a row is wrong.
const WRONG: f64 = 3.0;
/// Fraction of the visible rows that a kept track has.
const KEPT: f64 = 0.9;

fn planes(path: &Path) -> Vec<Plane> {
    let raw = ["-fps_mode", "passthrough", "-pix_fmt", "yuv420p", "-f", "yuv4mpegpipe", "-"];
    let output = Command::new("ffmpeg").args(["-v", "error", "-i"]).arg(path).args(raw).output();
    let bytes = output.expect("ffmpeg on the PATH").stdout;
    let (mut reader, mut rest) = (Reader::default(), bytes.as_slice());
    std::iter::from_fn(|| reader.frame(&mut rest).expect("a film")).collect()
}

/// Truth of a film.
struct Truth(Value);

impl Truth {
    fn place(&self, frame: usize, track: usize) -> [f64; 2] {
        [0, 1].map(|k| self.0["frames"][frame]["xy"][track][k].as_f64().expect("a position"))
    }

    fn is_seen(&self, frame: usize, track: usize) -> bool {
        self.0["frames"][frame]["vis"][track].as_bool().expect("true or false")
    }
}

/// Options of the command line.
struct Options {
    start: Option<usize>,
    beside: f64,
    radius: Option<f64>,
    is_listed: bool,
}

fn tracked(planes: &[Plane], truth: &Truth, click: Click, radius: Option<f64>) -> Result<(Track, f64), String> {
    let mut body = Body::new(Settings { keys: vec![click], radius, readout: Known::Estimated });
    for (frame, plane) in planes.iter().enumerate().skip(click.frame) {
        let time = truth.0["frames"][frame]["t"].as_f64().expect("a time");
        body.take(frame, time, plane, Similarity::IDENTITY).map_err(|refusal| format!("{refusal:?}"))?;
    }
    Ok((body.finish(), body.radius().unwrap_or(0.0)))
}

/// Sums over tracks.
#[derive(Default)]
struct Sum {
    tracks: usize,
    kept: usize,
    rows: usize,
    right: usize,
    quiet: usize,
    marked: usize,
    seconds: f64,
}

fn main() {
    let mut options = Options { start: None, beside: 0.0, radius: None, is_listed: false };
    let mut names = Vec::new();
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().expect("a folder");
    while let Some(argument) = arguments.next() {
        let mut number = || arguments.next().and_then(|text| text.parse::<f64>().ok()).expect("a number");
        match argument.as_str() {
            "--start" => options.start = Some(number() as usize),
            "--beside" => options.beside = number(),
            "--radius" => options.radius = Some(number()),
            "--frames" => options.is_listed = true,
            _ => names.push(argument),
        }
    }
    let mut paths: Vec<_> =
        std::fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    paths.sort();
    let mut sum = Sum::default();
    for path in paths {
        let name = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        if !names.is_empty() && !names.iter().any(|one| name.starts_with(one.as_str())) {
            continue;
        }
        let about = std::fs::read_to_string(&path).expect("a file");
        let truth = Truth(serde_json::from_str(&about).expect("JSON"));
        let planes = planes(&path.with_file_name(truth.0["file"].as_str().expect("a file name")));
        let count = planes.len().min(truth.0["frames"].as_array().map_or(0, Vec::len));
        let tracks = truth.0["tracks"].as_array().expect("tracks").iter().filter_map(Value::as_u64);
        for track in tracks.map(|track| track as usize) {
            let starts = options.start.map_or(vec![0, count / 7, count / 3], |start| vec![start]);
            for (number, start) in starts.into_iter().enumerate() {
                report(&mut sum, (name, &planes[..count], &truth), (track, start, number), &options);
            }
        }
    }
    println!(
        "{} tracks, {} kept; of {} rows {} right, {} quiet, {} of the right ones marked ({:.1} %); {:.1} s",
        sum.tracks,
        sum.kept,
        sum.rows,
        sum.right,
        sum.quiet,
        sum.marked,
        100.0 * sum.marked as f64 / sum.right.max(1) as f64,
        sum.seconds
    );
}

fn report(
    sum: &mut Sum,
    (name, planes, truth): (&str, &[Plane], &Truth),
    (track, start, number): (usize, usize, usize),
    options: &Options,
) {
    let middle = truth.place(start, track);
    let far = options.beside * truth.0["radius"].as_f64().unwrap_or(0.0);
    let (sine, cosine) = libm::sincos(2.4 * (number + 1) as f64);
    let shift = [far * cosine, far * sine];
    let click = Click { frame: start, position: [0, 1].map(|k| middle[k] + shift[k]) };
    let seen: Vec<bool> = (0..planes.len()).map(|frame| frame >= start && truth.is_seen(frame, track)).collect();
    let rows = seen.iter().filter(|seen| **seen).count();
    let started = Instant::now();
    let outcome = tracked(planes, truth, click, options.radius);
    let seconds = started.elapsed().as_secs_f64();
    sum.tracks += 1;
    sum.rows += rows;
    sum.seconds += seconds;
    let (found, radius) = match outcome {
        Ok(found) => found,
        Err(refusal) => {
            println!("{name:26} {track} from {start:3}: {refusal}");
            return;
        }
    };
    let (mut right, mut wrong, mut quiet, mut marked) = (0, 0, 0, 0);
    let mut list = String::new();
    for point in &found.points {
        let place = truth.place(point.frame, track);
        let off = [0, 1].map(|k| point.position[k] - place[k] - shift[k]);
        let off = libm::hypot(off[0], off[1]);
        let is_wrong = off > WRONG;
        wrong += usize::from(is_wrong);
        quiet += usize::from(is_wrong && !point.doubtful);
        right += usize::from(!is_wrong && seen[point.frame]);
        marked += usize::from(!is_wrong && seen[point.frame] && point.doubtful);
        if is_wrong || point.doubtful {
            let sign = if !is_wrong {
                "?"
            } else if point.doubtful {
                "w"
            } else {
                "!"
            };
            list += &format!(" {}{sign}{off:.0}", point.frame);
        }
    }
    let is_kept = right as f64 >= KEPT * rows as f64;
    sum.kept += usize::from(is_kept);
    sum.right += right;
    sum.quiet += quiet;
    sum.marked += marked;
    println!(
        "{name:26} {track} from {start:3}: {} {right:3}/{rows:3} wrong {wrong:3} quiet {quiet:3} marked {marked:3} radius {radius:5.1} lost {:?} {seconds:.2} s",
        if is_kept { "kept" } else { "-   " },
        found.lost
    );
    if options.is_listed {
        println!("   {list}");
    }
}
