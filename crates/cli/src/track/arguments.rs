//! Arguments of `meniscus track`.

use clap::{Args, ValueEnum};
use film::tracking::Known;
use std::path::PathBuf;
use units::{Dimension, Unit};

/// Shown after the help of `meniscus track`.
pub const TRACK_EXAMPLES: &str = "\
Examples:
  meniscus track utube.mp4 --surface 255,130 --output utube.csv        a liquid in an upright tube
  meniscus track utube.mp4 --surface 255,130 --scale '60,50,580,60=35 [cm]' --origin 255,180
  meniscus track utube.mp4 --surface 255,130 --surface 410,180         both arms, as y_1 and y_2
  meniscus track pendulum.mov --body 320,240 --from 2 --until '12 [s]'
  meniscus track pendulum.mov --body '320,240 410,255@3.5'             found again at 3.5 s, after something hid it
  meniscus track fall.mp4 --body 100,40,12 --rate 8                    filmed at 240 frames/s, played at 30
  meniscus track utube.mp4 --surface 255,130 --report utube.html       a page that shows what was tracked
  meniscus track *.mp4 --surface 255,130                               several films: FILM.csv beside each

Points are pixels of the upright picture, x to the right and y down from its top left corner, in the first frame that is tracked,
or, with @T, in the first frame from that time of the film on.
Films are decoded by ffmpeg 5.1 or later; Y4M films are read without it. docs/films.md says how to film and what the table holds.
Fit it, with its errors: meniscus fit DOC utube.csv --observe y";

/// `meniscus track`
#[derive(Debug, Args)]
pub struct Track {
    /// The films: MP4, MOV, WebM, MKV, AVI, or Y4M
    #[arg(value_name = "FILM", required = true)]
    pub films: Vec<PathBuf>,

    /// The surface of a liquid in a tube, and perhaps where it is at further times; twice for both arms
    #[arg(long, value_name = "X,Y X,Y@T", value_parser = surface, conflicts_with = "body")]
    pub surface: Vec<Surface>,

    /// Two points of the axis of a tube that is not upright; one for each surface
    #[arg(long, value_name = "X1,Y1,X2,Y2", value_parser = line, requires = "surface")]
    pub tube: Vec<Line>,

    /// A body, such as a bob or a ball, perhaps with its radius, and perhaps where it is at further times; up to four
    #[arg(long, value_name = "X,Y[,R] X,Y@T", value_parser = body)]
    pub body: Vec<Body>,

    /// Two marks and their distance [default: the table is in pixels]
    #[arg(long, value_name = "X1,Y1,X2,Y2=10 [cm]", value_parser = scale)]
    pub scale: Option<Ruler>,

    /// Origin of the coordinates [default: the bottom left corner of the picture]
    #[arg(long, value_name = "X,Y", value_parser = point)]
    pub origin: Option<Point>,

    /// Factor of slow motion: how many times slower the film plays than things happened [default: as the file
    /// says, or 1]
    #[arg(long, value_name = "FACTOR", value_parser = factor, allow_hyphen_values = true)]
    pub rate: Option<f64>,

    /// Begin at this time of the film, in seconds or as '500 [ms]'; the points are those of the first frame from
    /// there on
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub from: Option<String>,

    /// End at this time of the film
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub until: Option<String>,

    /// Readout time of a rolling shutter, from the first row to the last, in seconds [default: auto; 0 for bodies]
    #[arg(long, value_name = "auto|S", value_parser = readout, allow_hyphen_values = true)]
    pub readout: Option<Given>,

    /// Exposure time of each frame, in seconds [default: auto]
    #[arg(long, value_name = "auto|S", value_parser = exposure, allow_hyphen_values = true, conflicts_with = "body")]
    pub exposure: Option<Given>,

    /// Up to four fixed marks, which correct for a camera that moves
    #[arg(long, value_name = "X,Y X,Y", value_parser = points)]
    pub marks: Option<Points>,

    /// The form of the result [default: by the ending of FILE, or csv]
    #[arg(long, value_enum)]
    pub format: Option<TrackFormat>,

    /// Write into this file, which appears whole or not at all; for several films into this folder [default: the
    /// standard output; for several films FILM.csv beside each]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write a report (.html) besides: a frame with the marks, the space-time picture, times and calibration; for
    /// several films into this folder
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
}

/// The forms of a track.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TrackFormat {
    /// A row for each frame
    Csv,
    /// A workbook: the table, and what is known of the film
    Xlsx,
    /// One object, with settings, notes and the score of each point
    Json,
}

/// Point of the upright picture, px.
pub type Point = [f64; 2];
/// Two points, px.
pub type Line = [Point; 2];

/// Click.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Position, px.
    pub position: Point,
    /// Time of the film in s: the click belongs to the first frame from there on. Default: the first tracked frame.
    pub time: Option<f64>,
}

/// Surface of a liquid.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Clicks. The first one selects the surface, the others fix its path.
    pub places: Vec<Place>,
}

/// Body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Clicks: the first one, and those in key frames.
    pub places: Vec<Place>,
    /// Radius, px. Default: found around the click.
    pub radius: Option<f64>,
}

/// Two marks at a known distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Ruler {
    /// Positions of the marks, px.
    pub marks: Line,
    /// Distance of the marks, m.
    pub length: f64,
    /// Distance as typed.
    pub typed: String,
}

/// Several points in one argument.
#[derive(Clone, Debug, PartialEq)]
pub struct Points(pub Vec<Point>);

/// Exposure or readout time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given(pub Known);

fn numbers<const COUNT: usize>(text: &str) -> Option<[f64; COUNT]> {
    let read = |part: &str| part.trim().parse().ok().filter(|value: &f64| value.is_finite());
    let numbers: Vec<f64> = text.split(',').map(read).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

fn point(text: &str) -> Result<Point, String> {
    numbers(text).ok_or_else(|| "write two numbers of pixels, such as 255,130".to_owned())
}

fn line(text: &str) -> Result<Line, String> {
    let [x, y, u, v] = numbers(text).ok_or_else(|| "write two points, such as 255,20,260,340".to_owned())?;
    Ok([[x, y], [u, v]])
}

fn points(text: &str) -> Result<Points, String> {
    let points: Result<Vec<Point>, String> = text.split_whitespace().map(point).collect();
    let points = points.ok().filter(|points| (1..=4).contains(&points.len()));
    points.map(Points).ok_or_else(|| "write one to four points, such as '60,50 580,60'".to_owned())
}

fn surface(text: &str) -> Result<Surface, String> {
    match places(text, "write two numbers of pixels, such as 255,130")? {
        (places, None) => Ok(Surface { places }),
        (_, Some(_)) => Err("a surface has no radius: write a point, such as 255,130".to_owned()),
    }
}

fn body(text: &str) -> Result<Body, String> {
    let (places, radius) = places(text, "write a point and perhaps a radius, such as 320,240 or 320,240,12")?;
    Ok(Body { places, radius })
}

/// Parses a point with an optional radius, and further points with times: `320,240,12 410,255@3.5`. `example`: advice
/// on how to write a point, used as error.
fn places(text: &str, example: &str) -> Result<(Vec<Place>, Option<f64>), String> {
    // Spaces separate points, except before a unit and after a comma.
    let text = text.replace(" [", "[").replace(", ", ",");
    let (mut places, mut radius) = (Vec::new(), None);
    for part in text.split_whitespace() {
        let (place, time) = part.split_once('@').map_or((part, None), |(place, time)| (place, Some(time)));
        let no_time = |why| format!("{part}: {why}; a time is in seconds, as in @3.5, or has a unit, as in @3500[ms]");
        let time = time.map(|time| seconds(time).map_err(no_time)).transpose()?;
        if !places.is_empty() && time.is_none() {
            return Err(format!("{part}: say at which time of the film it is there, such as {part}@3.5"));
        }
        let position = match (numbers(place), numbers(place)) {
            (Some(position), _) => position,
            (None, Some([x, y, own])) if own > 0.0 && places.is_empty() => {
                radius = Some(own);
                [x, y]
            }
            _ => return Err(example.to_owned()),
        };
        places.push(Place { position, time });
    }
    if places.is_empty() { Err(example.to_owned()) } else { Ok((places, radius)) }
}

fn scale(text: &str) -> Result<Ruler, String> {
    let example = "write two marks and their distance, such as '60,50,580,60=35 [cm]'";
    let (marks, length) = text.split_once('=').ok_or(example)?;
    let marks = line(marks).map_err(|_| format!("{} is not two points: {example}", marks.trim()))?;
    let (value, unit) = quantity(length).map_err(|why| format!("{why}: {example}"))?;
    let unit = unit.ok_or_else(|| format!("the distance {value} has no unit: {example}"))?;
    if unit.dimension != Dimension::LENGTH {
        return Err(format!("{} is not a unit of length: {example}", unit.text));
    }
    let metres = unit.to_si(value);
    if metres > 0.0 && metres.is_finite() {
        Ok(Ruler { marks, length: metres, typed: length.replace(['[', ']'], "").trim().to_owned() })
    } else {
        Err(format!("the distance of two marks is greater than zero, not {value} {}: {example}", unit.text))
    }
}

fn factor(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| "write a number without a unit, such as 8 for 240 frames/s played at 30".to_owned())
}

fn exposure(text: &str) -> Result<Given, String> {
    let given = known(text)?;
    match given.0 {
        Known::Seconds(seconds) if seconds < 0.0 => Err(format!("no exposure is negative: {TIMES}")),
        _ => Ok(given),
    }
}

/// Readout time. Negative if the camera is held upside down: rows are then read from the last to the first.
fn readout(text: &str) -> Result<Given, String> {
    known(text)
}

/// Advice on how to write times of the camera.
const TIMES: &str = "write auto, or a time such as 0.02 or '20 [ms]'";

fn known(text: &str) -> Result<Given, String> {
    if text.trim() == "auto" {
        return Ok(Given(Known::Estimated));
    }
    let seconds = seconds(text).map_err(|why| format!("{why}: {TIMES}"))?;
    // No camera exposes or reads a frame for longer.
    if seconds.abs() < 10.0 {
        Ok(Given(Known::Seconds(seconds)))
    } else {
        Err(format!("no camera takes 10 s or more for a frame: {TIMES}"))
    }
}

/// Parses a time, in s without a unit.
///
/// # Errors
///
/// A message with the fault.
fn seconds(text: &str) -> Result<f64, String> {
    match quantity(text)? {
        (value, Some(unit)) if unit.dimension == Dimension::TIME => Ok(unit.to_si(value)),
        (value, None) => Ok(value),
        (_, Some(unit)) => Err(format!("{} is not a unit of time", unit.text)),
    }
}

/// Parses a number with an optional unit: `10 [cm]`, `10 cm`, `10`.
///
/// # Errors
///
/// A message with the fault.
fn quantity(text: &str) -> Result<(f64, Option<Unit>), String> {
    let text = text.trim();
    let finite = |value: f64| if value.is_finite() { Ok(value) } else { Err(format!("{text} is not a finite number")) };
    if let Ok(value) = text.parse() {
        return Ok((finite(value)?, None));
    }
    let end = text.find(|c: char| c == '[' || c.is_alphabetic() && !matches!(c, 'e' | 'E')).unwrap_or(text.len());
    let (value, unit) = text.split_at(end);
    let no_number = |_| match value.trim().split_once(',') {
        Some((whole, decimals)) => format!("`{whole},{decimals}` has a comma; write {whole}.{decimals}"),
        None => format!("`{text}` does not begin with a number"),
    };
    let value = finite(value.trim().parse().map_err(no_number)?)?;
    let unit = unit.trim_matches(['[', ']', ' ']);
    Ok((value, Some(Unit::parse(unit).map_err(|_| format!("`{unit}` is not a known unit"))?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_scales_and_times_are_read() {
        assert_eq!(point("255, 130.5"), Ok([255.0, 130.5]));
        let place = |x: f64, y: f64, time: Option<f64>| Place { position: [x, y], time };
        assert_eq!(surface("255, 130"), Ok(Surface { places: vec![place(255.0, 130.0, None)] }));
        assert_eq!(body("3,4,5"), Ok(Body { places: vec![place(3.0, 4.0, None)], radius: Some(5.0) }));
        let places = vec![place(3.0, 4.0, Some(0.5)), place(6.0, 7.0, Some(2.5)), place(8.0, 9.0, Some(3.0))];
        assert_eq!(body("3,4,5@0.5 6,7@2500 [ms]  8, 9@3[s]"), Ok(Body { places, radius: Some(5.0) }));
        assert_eq!(points("1,2 3,4").map(|points| points.0.len()), Ok(2));
        let ruler = |typed: &str| Ruler { marks: [[60.0, 50.0], [580.0, 60.0]], length: 0.1, typed: typed.to_owned() };
        assert_eq!(scale("60,50,580,60=10 [cm]"), Ok(ruler("10 cm")));
        assert_eq!(scale("60,50,580,60 = 100 mm"), Ok(ruler("100 mm")));
        assert_eq!(known("auto"), Ok(Given(Known::Estimated)));
        assert_eq!(known("4 [ms]"), Ok(Given(Known::Seconds(0.004))));
        assert_eq!(known("2.5e-2"), Ok(Given(Known::Seconds(0.025))));
        for wrong in ["", "1", "1,2,3", "a,b", "inf,1", "1;2"] {
            assert!(point(wrong).is_err(), "{wrong}");
        }
        for wrong in ["1,2,3,4", "1,2,3,4=10", "1,2,3,4=10 [s]", "1,2,3,4=-1 [m]", "1,2,3=1 [m]"] {
            assert!(scale(wrong).is_err(), "{wrong}");
        }
        for wrong in ["soon", "1 [m]", "99", "inf", "NaN", "", "1 []"] {
            assert!(known(wrong).is_err(), "{wrong}");
        }
        assert!(exposure("-0.01").is_err());
        assert_eq!(readout("-10 [ms]"), Ok(Given(Known::Seconds(-0.01))));
        for wrong in ["1,2,-3", "", " ", "@2", "1,2 3,4", "1,2 3,4,5@2", "1,2@soon", "1,2@", "1,2@2@3", "1,2@1[kg"] {
            assert!(body(wrong).is_err() && surface(wrong).is_err(), "{wrong}");
        }
        assert!(surface("1,2,3").is_err() && points("").is_err() && points("1,1 2,2 3,3 4,4 5,5").is_err());
    }
}
