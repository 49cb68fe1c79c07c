//! Checks before the first frame is decoded.

use super::arguments::{Given, Place, Point, Track as Arguments, TrackFormat};
use super::clock::{self, Clock};
use super::following::HALF_WIDTH;
use super::opened::{Opened, refused_with};
use crate::failure::Failure;
use film::tracking::Known;
use std::path::{Path, PathBuf};
use units::number::fixed;
use units::{Words, words};

/// Maximum number of surfaces and of bodies.
const MOST_SURFACES: usize = 2;
const MOST_BODIES: usize = 4;
/// Relative tolerance of a given time that exceeds the frame interval: users round 1/29.97 s to 33.4 ms.
const ROUNDED: f64 = 0.01;

/// Checks that do not depend on the film.
///
/// # Errors
///
/// A request that no film can satisfy.
pub fn arguments(arguments: &Arguments) -> Result<(), Failure> {
    let (surfaces, bodies, tubes) = (arguments.surface.len(), arguments.body.len(), arguments.tube.len());
    if surfaces + bodies == 0 {
        return Err(Failure::in_words(
            words("it is not said what to track"),
            words("click a liquid's surface, --surface X,Y, or a body, --body X,Y, in pixels of the first frame"),
        ));
    }
    if surfaces > MOST_SURFACES || bodies > MOST_BODIES {
        return Err(Failure::in_words(
            words("too many surfaces or bodies"),
            words!(
                "track at most {MOST_SURFACES} surfaces or {MOST_BODIES} bodies at once, and the others in a second call"
            ),
        ));
    }
    if tubes > 0 && tubes != surfaces {
        return Err(Failure::in_words(
            words!("--tube and --surface differ in number: {tubes} and {surfaces}"),
            words("write --tube once for each --surface, in the same order, or not at all for upright tubes"),
        ));
    }
    places(arguments)?;
    clock::part(arguments)?;
    Ok(())
}

/// Rejects two clicks at one place, which would track the same object twice.
fn places(arguments: &Arguments) -> Result<(), Failure> {
    let first = |places: &[Place]| places.first().copied();
    let marks = arguments.marks.iter().flat_map(|marks| &marks.0);
    let all: [(&str, Vec<Place>); 3] = [
        ("--surface", arguments.surface.iter().filter_map(|surface| first(&surface.places)).collect()),
        ("--body", arguments.body.iter().filter_map(|body| first(&body.places)).collect()),
        ("--marks", marks.map(|mark| Place { position: *mark, time: None }).collect()),
    ];
    for (name, places) in all {
        let same = |at: usize| places[..at].iter().any(|place| place == &places[at]);
        if let Some(at) = (1..places.len()).find(|at| same(*at)) {
            let [x, y] = places[at].position;
            return Err(Failure::in_words(
                words!("{name}: {x},{y} is given twice"),
                words("give each thing its own place"),
            ));
        }
    }
    Ok(())
}

/// Output files of a film.
#[derive(Clone, Debug, Default)]
pub struct Targets {
    /// File of the table; `None` for the standard output.
    pub table: Option<PathBuf>,
    /// File of the report, if any.
    pub report: Option<PathBuf>,
}

/// Format of the tables: the requested one, else by the ending of the output file. With several films the output is a
/// folder.
pub fn format(arguments: &Arguments) -> Result<TrackFormat, Failure> {
    let file = arguments.output.as_deref().filter(|_| arguments.films.len() == 1);
    let (Some(path), None) = (file, arguments.format) else {
        return Ok(arguments.format.unwrap_or(TrackFormat::Csv));
    };
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    match ending.as_str() {
        "csv" => Ok(TrackFormat::Csv),
        "xlsx" => Ok(TrackFormat::Xlsx),
        "json" => Ok(TrackFormat::Json),
        _ => {
            let name = path.display();
            Err(Failure::in_words(
                words!("--output {name}: the ending is none of a table"),
                words(
                    "end its name in .csv (a table), .xlsx (a workbook) or .json (an object), or say the form with --format",
                ),
            ))
        }
    }
}

/// Output files of each film.
///
/// # Errors
///
/// Unsuitable names, missing folders, or two films with the same output.
pub fn outputs(arguments: &Arguments, format: TrackFormat) -> Result<Vec<Targets>, Failure> {
    let (output, report) = (arguments.output.as_deref(), arguments.report.as_deref());
    if let [_] = arguments.films.as_slice() {
        if let Some(report) = report.filter(|report| !is_page(report)) {
            let name = report.display();
            return Err(Failure::in_words(
                words!("--report {name}: a report is an HTML page"),
                words("end its name in .html"),
            ));
        }
        if report.is_some() && report == output {
            return Err(Failure::in_words(
                words("--output and --report name one file"),
                words("give the table another name"),
            ));
        }
        return Ok(vec![Targets { table: arguments.output.clone(), report: arguments.report.clone() }]);
    }
    let ending = match format {
        TrackFormat::Csv => ".csv",
        TrackFormat::Xlsx => ".xlsx",
        TrackFormat::Json => ".json",
    };
    let tables = several(arguments, "--output", output, ending)?;
    let reports = match report {
        None => vec![None; tables.len()],
        Some(_) => several(arguments, "--report", report, ".html")?.into_iter().map(Some).collect(),
    };
    Ok(tables.into_iter().map(Some).zip(reports).map(|(table, report)| Targets { table, report }).collect())
}

fn is_page(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    ["html", "htm"].iter().any(|page| ending.eq_ignore_ascii_case(page))
}

/// Output file of each film, beside the film or in the folder given by an option.
fn several(
    arguments: &Arguments,
    option: &'static str,
    folder: Option<&Path>,
    ending: &str,
) -> Result<Vec<PathBuf>, Failure> {
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        let name = folder.display();
        return Err(Failure::in_words(
            words!("{option} {name}: there is no such folder"),
            words!("for several films {option} is a folder, in which each gets its file; make it first"),
        ));
    }
    let targets: Vec<PathBuf> = arguments.films.iter().map(|film| beside(film, folder, ending)).collect();
    let mut sorted = targets.clone();
    sorted.sort();
    if let Some([same, _]) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        let name = same.display();
        return Err(Failure::in_words(
            words!("two films would write {name}"),
            words("leave one of them out, or rename it"),
        ));
    }
    Ok(targets)
}

/// Output file beside a film or in a folder.
fn beside(film: &Path, folder: Option<&Path>, ending: &str) -> PathBuf {
    let mut name = film.file_name().unwrap_or_default().to_owned();
    name.push(ending);
    folder.map_or_else(|| film.with_file_name(&name), |folder| folder.join(&name))
}

/// Checks that points lie inside the picture and bodies are smaller than it.
pub fn points(film: &Opened, arguments: &Arguments) -> Result<(), Failure> {
    let [width, height] = film.upright_size();
    let clicked = |places: &[Place]| places.iter().map(|place| place.position).collect::<Vec<Point>>();
    let named = |name: &'static str, points: Vec<Point>| points.into_iter().map(move |point| (name, point));
    let all = named("--surface", arguments.surface.iter().flat_map(|surface| clicked(&surface.places)).collect())
        .chain(named("--tube", arguments.tube.concat()))
        .chain(named("--body", arguments.body.iter().flat_map(|body| clicked(&body.places)).collect()))
        .chain(named("--marks", arguments.marks.iter().flat_map(|marks| marks.0.clone()).collect()))
        .chain(named("--scale", arguments.scale.iter().flat_map(|ruler| ruler.marks).collect()));
    for (name, [x, y]) in all {
        if !((0.0..=width).contains(&x) && (0.0..=height).contains(&y)) {
            let why = words!("{name} {x},{y} lies outside the picture, which is {width} pixels wide and {height} high");
            let hint = words("points count from the top left corner of the upright picture, x to the right and y down");
            return Err(refused_with(&film.path, why, hint));
        }
    }
    off_axis(film, arguments)?;
    let most = width.min(height) / 2.0;
    let mut radii = arguments.body.iter().filter_map(|body| body.radius);
    if let Some(radius) = radii.find(|radius| *radius > most) {
        let why = words!(
            "a body of radius {radius} does not fit into the picture, which is {width} pixels wide and {height} high"
        );
        let hint = words("write --body X,Y,R with the radius R in pixels, or leave R out: it is found then");
        return Err(refused_with(&film.path, why, hint));
    }
    Ok(())
}

/// Checks that clicks lie within the searched strip around the axis of the tube.
fn off_axis(film: &Opened, arguments: &Arguments) -> Result<(), Failure> {
    let [_, height] = film.upright_size();
    for (surface, [[x, y], [u, v]]) in arguments.surface.iter().zip(&arguments.tube) {
        let (along, down) = (u - x, v - y);
        let length = (along * along + down * down).sqrt();
        let distance = |place: &Place| {
            let [p, q] = place.position;
            ((p - x) * down - (q - y) * along).abs() / length
        };
        let Some(place) = surface.places.iter().find(|place| distance(place) > HALF_WIDTH * height) else { continue };
        let ([p, q], distance) = (place.position, distance(place));
        let why = words!("--surface {p},{q} is {distance} pixels from the axis of its tube, --tube {x},{y},{u},{v}");
        let hint = words("write two points on the axis of the tube in which the surface is, such as its ends");
        return Err(refused_with(&film.path, why, hint));
    }
    Ok(())
}

/// Checks that exposure and readout are not longer than the frame interval.
pub fn durations(film: &Opened, clock: &Clock, arguments: &Arguments) -> Result<(), Failure> {
    // A film of one frame has no rate.
    let Some(rate) = clock.rate else { return Ok(()) };
    let lasts = 1.0 / (rate * clock.factor);
    for (name, given) in [("--exposure", arguments.exposure), ("--readout", arguments.readout)] {
        let Some(Given(Known::Seconds(seconds))) = given else { continue };
        if seconds.abs() <= lasts * (1.0 + ROUNDED) {
            continue;
        }
        let milliseconds = |seconds: f64| Words::each(move |language| fixed(1e3 * seconds, 1, language.style()));
        let half = milliseconds(lasts / 2.0);
        let why = words!(
            "{name} is {given} ms, and a frame lasts {lasts} ms: no frame takes longer than until the next one",
            name = Words::same(name),
            given = milliseconds(seconds),
            lasts = milliseconds(lasts)
        );
        let hint = words!(
            "write a time up to {lasts} ms, such as '{half} [ms]', or auto; a number without a unit is in seconds",
            lasts = milliseconds(lasts),
        );
        return Err(refused_with(&film.path, why, hint));
    }
    Ok(())
}
