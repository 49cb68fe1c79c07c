//! Tracks the test films of a folder and compares with the truth beside them:
//!
//!     cargo run --release -p film --example films -- FOLDER [NAME...]
//!
//! Each film is tracked by a click at the true position and by two clicks up to 3 pixels beside it, for tubes one of them in a later
//! frame. Times are those of taking all frames, of the search, and of its longest step.
//!
//! Needs `ffmpeg` and `ffprobe`. A film NAME.mp4 has its truth in NAME.json (frames with `instant`, `seen` and `scene`).

#![allow(clippy::expect_used, reason = "a program for developers: it stops where something is missing")]

use film::Plane;
use film::tracking::body::{self, Body};
use film::tracking::column::{Click, Column, Settings};
use film::tracking::{Exposure, Known, Marks, Track};
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Film with its description.
struct Film {
    planes: Vec<Plane>,
    times: Vec<f64>,
    about: serde_json::Value,
}

fn output(command: &mut Command) -> Vec<u8> {
    command.output().expect("ffmpeg and ffprobe on the PATH").stdout
}

fn decode(path: &Path) -> Film {
    let about = std::fs::read_to_string(path.with_extension("json")).expect("the truth beside the film");
    let about: serde_json::Value = serde_json::from_str(&about).expect("JSON");
    let size = |key: &str| about[key].as_u64().expect("a size") as usize;
    let (width, height) = (size("width"), size("height"));
    let raw = ["-fps_mode", "passthrough", "-f", "rawvideo", "-pix_fmt", "gray", "-"];
    let pixels = output(Command::new("ffmpeg").args(["-v", "error", "-i"]).arg(path).args(raw));
    let planes =
        pixels.chunks_exact(width * height).filter_map(|grey| Plane::new(width, height, grey.to_vec())).collect();
    let entries = ["-v", "error", "-select_streams", "v", "-show_entries", "frame=pts_time", "-of", "csv=p=0"];
    let listed = output(Command::new("ffprobe").args(entries).arg(path));
    let listed = String::from_utf8(listed).expect("text");
    let times = listed.lines().filter_map(|line| line.trim_matches(',').parse().ok()).collect();
    Film { planes, times, about }
}

impl Film {
    fn pair(&self, frame: usize, key: &str) -> [f64; 2] {
        let pair = &self.about["frames"][frame][key];
        let [x, y] = [pair[0].as_f64().expect("x"), pair[1].as_f64().expect("y")];
        if key != "scene" {
            return [x, y];
        }
        // In the picture of the first frame, in which shaken films are measured.
        let camera = &self.about["frames"][0]["camera"];
        let [dx, dy, angle] = [0, 1, 2].map(|k| camera[k].as_f64().expect("a number"));
        let half = ["width", "height"].map(|side| self.about[side].as_f64().expect("a size") / 2.0);
        let (sine, cosine) = libm::sincos(angle);
        let (u, v) = (x - half[0], y - half[1]);
        [cosine * u - sine * v + half[0] + dx, sine * u + cosine * v + half[1] + dy]
    }

    fn number(&self, frame: usize, key: &str) -> f64 {
        self.about["frames"][frame][key].as_f64().expect("a number")
    }

    /// The true position at a time near that of a frame.
    fn truth(&self, frame: usize, key: &str, time: f64, moment: &str) -> [f64; 2] {
        let count = self.about["frames"].as_array().map_or(0, Vec::len);
        let (before, after) = (frame.saturating_sub(1), (frame + 1).min(count - 1));
        let late = time - self.number(frame, moment);
        let (p, q) = (self.pair(before, key), self.pair(after, key));
        let span = self.number(after, moment) - self.number(before, moment);
        let here = self.pair(frame, key);
        [0, 1].map(|k| here[k] + late * (q[k] - p[k]) / span)
    }

    fn column(&self, clicked: usize, beside: [f64; 2], shaken: bool) -> (Track, [f64; 3]) {
        let [x, y] = self.pair(clicked, "seen");
        let mut settings = Settings::new(Click { frame: clicked, position: [x + beside[0], y + beside[1]] });
        // If the camera is held at an angle, the tube is given by two points.
        let angle = self.about["frames"][0]["camera"][2].as_f64().unwrap_or(0.0);
        if angle.abs() > 0.05 && !shaken {
            let along = [-libm::sin(angle), libm::cos(angle)];
            let end = |far: f64| [x + far * along[0], y + far * along[1]];
            settings.tube = Some([end(10.0 - y), end(y - 10.0 + 0.3 * (y - 10.0))]);
        }
        let mut column = Column::new(settings);
        let mut marks = self.marks(shaken);
        let started = Instant::now();
        for (frame, (plane, time)) in self.planes.iter().zip(&self.times).enumerate() {
            let camera = marks.take(frame, plane).expect("the marks");
            column.take(frame, *time, plane, camera).expect("a frame");
        }
        let strips = started.elapsed().as_secs_f64();
        // In portions, as a page works: the longest step decides how smoothly it runs.
        let mut longest = 0.0_f64;
        loop {
            let before = started.elapsed().as_secs_f64();
            let done = column.advance(1).expect("a step");
            longest = longest.max(started.elapsed().as_secs_f64() - before);
            if done {
                break;
            }
        }
        let track = column.track().cloned().unwrap_or_default();
        (track, [strips, started.elapsed().as_secs_f64() - strips, longest])
    }

    fn body(&self, beside: [f64; 2], shaken: bool) -> (Track, [f64; 3]) {
        let [x, y] = self.pair(0, "seen");
        let click = Click { frame: 0, position: [x + beside[0], y + beside[1]] };
        let mut body = Body::new(body::Settings { keys: vec![click], radius: None, readout: Known::Seconds(0.0) });
        let mut marks = self.marks(shaken);
        let started = Instant::now();
        for (frame, (plane, time)) in self.planes.iter().zip(&self.times).enumerate() {
            let camera = marks.take(frame, plane).expect("the marks");
            body.take(frame, *time, plane, camera).expect("a frame");
        }
        let search = started.elapsed().as_secs_f64();
        let track = body.finish();
        (track, [search, started.elapsed().as_secs_f64() - search, 0.0])
    }

    /// The fixed marks of a shaken film.
    fn marks(&self, shaken: bool) -> Marks {
        let marks = self.about["marks"].as_array().filter(|_| shaken).map_or(&[][..], Vec::as_slice);
        let camera = &self.about["frames"][0]["camera"];
        let number = |value: &serde_json::Value| value.as_f64().expect("a number");
        Marks::new(
            marks
                .iter()
                .map(|mark| [number(&mark[0]) + number(&camera[0]), number(&mark[1]) + number(&camera[1])])
                .collect(),
        )
        .expect("four marks")
    }
}

/// Prints how far a track is from the truth in one coordinate, after a constant.
fn compare(film: &Film, track: &Track, name: &str, axis: usize, key: &str, seconds: [f64; 3]) {
    let moment = if key == "scene" { "t" } else { "instant" };
    let errors: Vec<f64> = track
        .points
        .iter()
        .map(|point| point.position[axis] - film.truth(point.frame, key, point.time, moment)[axis])
        .collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let rms = |values: &mut dyn Iterator<Item = f64>| {
        let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value * value, count + 1.0));
        f64::sqrt(sum / f64::max(count, 1.0))
    };
    let error = rms(&mut errors.iter().map(|error| error - mean));
    let relative = rms(&mut errors.iter().zip(&track.points).map(|(error, point)| (error - mean) / point.sigma[axis]));
    let worst = errors.iter().map(|error| (error - mean).abs()).enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    let (at, worst) = worst.unwrap_or((0, 0.0));
    let frame = track.points.get(at).map_or(0, |point| point.frame);
    let doubtful = track.points.iter().filter(|point| point.doubtful).count();
    let exposure = match track.exposure {
        Some(Exposure::Seconds(seconds)) => format!("{:.1} ms", 1e3 * seconds),
        Some(Exposure::Under(seconds)) => format!("<{:.1} ms", 1e3 * seconds),
        None => "-".to_owned(),
    };
    let readout = track
        .readout
        .map_or("-".to_owned(), |readout| format!("{:.1}+-{:.1} ms", 1e3 * readout.seconds, 1e3 * readout.sigma));
    let lost = track.lost.map_or(String::new(), |frame| format!(" lost at {frame}"));
    println!(
        "{name:22} {} frames {:4}  rmse {error:.3}  error/sigma {relative:.2}  worst {worst:.2} (frame {frame})  doubtful {doubtful:3}  \
         exposure {exposure:>9}  readout {readout:>14}  mean {mean:6.2}  {:.3} + {:.3} s, step {:.1} ms{lost}",
        ["x", "y"][axis],
        track.points.len(),
        seconds[0],
        seconds[1],
        1e3 * seconds[2]
    );
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().expect("a folder");
    let wanted: Vec<String> = arguments.collect();
    let mut paths: Vec<_> =
        std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "mp4"));
    paths.sort();
    for path in paths {
        let name = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default().to_owned();
        if name.starts_with("n-") || !(wanted.is_empty() || wanted.iter().any(|one| name.contains(one.as_str()))) {
            continue;
        }
        let film = decode(&path);
        let shaken = name.contains("shake");
        let key = if shaken { "scene" } else { "seen" };
        for (part, beside) in [(0, [0.0, 0.0]), (3, [2.0, 2.2]), (0, [-2.0, -2.2])] {
            let clicked = film.planes.len().checked_div(part).unwrap_or(0);
            if name.starts_with("utube") {
                let (track, seconds) = film.column(clicked, beside, shaken);
                compare(&film, &track, &name, 1, key, seconds);
            } else {
                let (track, seconds) = film.body(beside, shaken);
                compare(&film, &track, &name, 0, key, seconds);
                compare(&film, &track, &name, 1, key, seconds);
            }
        }
    }
}
