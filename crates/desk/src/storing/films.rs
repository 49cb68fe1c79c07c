//! Conversion between work on films and stored items: the user's settings and the tracks as numbers. The film itself is
//! not stored.

use saved::format::{self, Content, Followed, Place};
use saved::{Item, Number};

use super::place::{factor, place, point};
use super::tracks;
use crate::films::work::Work;
use crate::films::{
    CalibrationForm, CameraSettings, FilmIdentity, FilmRecipe, FilmedBody, FilmedSurface, LengthsForm, POINT_SIGMA,
    ParallaxForm, ShownFilms, Subject,
};
use crate::records::Records;
use film::calibration::{CLICK, Calibration, Lengths, Parallax, Rectangle, Scale};
use film::tracking::column::Click;
use play::name_of;

/// Maximum number of works on films that are stored.
pub(super) const MOST_WORKS: usize = 32;
/// Maximum number of track points stored for all films together, about 100 bytes each. The tracks of other films are
/// computed again.
const MOST_POINTS: usize = 10_000;

impl ShownFilms<'_> {
    /// The works on films to store, each with a name that is the same at every visit. The most recent ones have
    /// priority.
    pub fn saved(self) -> Vec<(String, Item)> {
        let records = self.records().names();
        let mut room = MOST_POINTS;
        let item = |work: &Work| {
            let record = records.iter().find(|(id, _)| Some(*id) == work.record).map(|(_, name)| name.clone());
            let points =
                work.found.as_ref().map_or(0, |found| found.tracks.iter().map(|track| track.points.len()).sum());
            let found = work.found.as_ref().filter(|_| points <= room);
            room -= if found.is_some() { points } else { 0 };
            (name(&work.identity), Item(Content::Film(Box::new(saved(work, found.map(tracks::saved), record)))))
        };
        let worked = |work: &&Work| !work.subject.is_nothing() || work.form != CalibrationForm::default();
        let mut items: Vec<(String, Item)> =
            self.works().iter().rev().filter(worked).take(MOST_WORKS).map(item).collect();
        // Oldest first, in the order of restoring.
        items.reverse();
        items
    }
}

/// The stored work on a film with its record, and its name in the storage. `None` if it cannot be read.
pub(crate) fn read(saved: &format::Film, records: &Records) -> Option<(String, Work)> {
    let mut work = restored(saved)?;
    let names = records.names();
    work.record = names.into_iter().find(|(_, name)| Some(name) == saved.record.as_ref()).map(|(id, _)| id);
    Some((name(&work.identity), work))
}

fn name(identity: &FilmIdentity) -> String {
    name_of(&[&identity.hash, &identity.size.to_string()])
}

fn clicks(clicks: &[Click]) -> Vec<(usize, Place)> {
    clicks.iter().map(|click| (click.frame, place(click.position))).collect()
}

fn read_clicks(saved: &[(usize, Place)]) -> Vec<Click> {
    saved.iter().map(|&(frame, at)| Click { frame, position: point(at) }).collect()
}

fn saved(work: &Work, found: Option<format::FoundInFilm>, record: Option<String>) -> format::Film {
    let surface = |surface: &FilmedSurface| Followed {
        clicks: clicks(&[surface.click]),
        tube: surface.tube.map(|ends| ends.map(place)),
        anchors: clicks(&surface.anchors),
        ..Followed::default()
    };
    let body = |body: &FilmedBody| Followed {
        clicks: clicks(&body.keys),
        radius: body.radius.map(Number),
        ..Followed::default()
    };
    let (kind, followed) = match &work.subject {
        Subject::Nothing => ("", Vec::new()),
        Subject::Surfaces(all) => ("surfaces", all.iter().map(surface).collect()),
        Subject::Bodies(all) => ("bodies", all.iter().map(body).collect()),
        Subject::Points { clicks: all, sigma } => {
            ("points", vec![Followed { clicks: clicks(all), sigma: Some(Number(*sigma)), ..Followed::default() }])
        }
    };
    let (points, lengths, intervals) = match &work.form.lengths {
        LengthsForm::Pixels => (Vec::new(), Vec::new(), 0),
        LengthsForm::Ruler { marks, length, intervals } => (marks.to_vec(), vec![length.clone()], *intervals),
        LengthsForm::Rectangle { corners, size } => (corners.to_vec(), size.to_vec(), 0),
    };
    let scale = match &work.calibration.lengths {
        Lengths::Scale(scale) => Some([Number(scale.pixel), Number(scale.relative_sigma)]),
        _ => None,
    };
    format::Film {
        name: crate::records::line(&work.identity.name),
        size: work.identity.size,
        hash: work.identity.hash.clone(),
        factor: work.factor.map(Number),
        part: work.part.map(|end| end.map(Number)),
        kind: kind.to_owned(),
        followed,
        marks: work.marks.iter().map(|mark| place(*mark)).collect(),
        points: points.into_iter().map(place).collect(),
        lengths,
        intervals,
        scale,
        origin: work.form.origin.map(place),
        axis: work.form.axis.map(place),
        parallax: work.form.parallax.as_ref().map(|form| [form.behind.clone(), form.distance.clone()]),
        sides: match &work.calibration.lengths {
            Lengths::Rectangle(rectangle) => Some(place(rectangle.size)),
            _ => None,
        },
        zero: Some(place(work.calibration.origin)),
        angle: (work.calibration.angle != 0.0).then_some(Number(work.calibration.angle)),
        ruler: work.calibration.parallax.map(|parallax| place([parallax.behind, parallax.distance])),
        stated_factor: Some(Number(work.stated_factor)),
        ends: work.ends,
        found,
        record,
        recipe: work.recipe.as_ref().map(saved_recipe),
    }
}

/// The work on a film; `None` if the saved work has no hash of a film, or no entry for its points.
fn restored(saved: &format::Film) -> Option<Work> {
    let identity = FilmIdentity { name: saved.name.clone(), size: saved.size, hash: saved.hash.clone() };
    if identity.hash.is_empty() {
        return None;
    }
    let surface = |followed: &Followed| {
        let click = *read_clicks(&followed.clicks).first()?;
        let anchors = read_clicks(&followed.anchors);
        Some(FilmedSurface { anchors, tube: followed.tube.map(|ends| ends.map(point)), ..FilmedSurface::new(click) })
    };
    let body = |followed: &Followed| FilmedBody {
        keys: read_clicks(&followed.clicks),
        radius: followed.radius.map(|Number(radius)| radius),
    };
    let subject = match saved.kind.as_str() {
        "surfaces" => Subject::Surfaces(saved.followed.iter().filter_map(surface).collect()),
        "bodies" => Subject::Bodies(saved.followed.iter().map(body).collect()),
        "points" => {
            let followed = saved.followed.first()?;
            let sigma = followed.sigma.map_or(POINT_SIGMA, |Number(sigma)| sigma);
            Subject::Points { clicks: read_clicks(&followed.clicks), sigma }
        }
        _ => Subject::Nothing,
    };
    let points: Vec<[f64; 2]> = saved.points.iter().map(|at| point(*at)).collect();
    let (lengths, found) = match (&points[..], &saved.lengths[..], saved.scale) {
        (&[from, to], [length], Some([Number(pixel), Number(relative_sigma)])) if pixel > 0.0 => (
            LengthsForm::Ruler { marks: [from, to], length: length.clone(), intervals: saved.intervals },
            Lengths::Scale(Scale { pixel, relative_sigma }),
        ),
        (&[a, b, c, d], [width, height], _) => {
            let sides = saved.sides.map_or([0.0; 2], point);
            let lengths = Rectangle::new([a, b, c, d], sides, CLICK).map_or(Lengths::Pixels, Lengths::Rectangle);
            (LengthsForm::Rectangle { corners: [a, b, c, d], size: [width.clone(), height.clone()] }, lengths)
        }
        _ => (LengthsForm::Pixels, Lengths::Pixels),
    };
    let parallax = saved.parallax.clone().map(|[behind, distance]| ParallaxForm { behind, distance });
    let form = CalibrationForm { lengths, origin: saved.origin.map(point), axis: saved.axis.map(point), parallax };
    let calibration = Calibration {
        lengths: found,
        origin: saved.zero.map_or([0.0; 2], point),
        angle: saved.angle.map_or(0.0, |Number(angle)| angle),
        parallax: saved.ruler.map(point).map(|[behind, distance]| Parallax { behind, distance }),
        ..Calibration::default()
    };
    Some(Work {
        identity,
        factor: saved.factor.and_then(factor),
        stated_factor: saved.stated_factor.and_then(factor).unwrap_or(1.0),
        part: saved.part.map(|end| end.map(|Number(end)| end).filter(|end| end.is_finite())),
        ends: saved.ends,
        subject: subject.settled(),
        marks: saved.marks.iter().map(|mark| point(*mark)).collect(),
        form,
        calibration,
        found: saved.found.as_ref().and_then(tracks::restored),
        record: None,
        recipe: saved.recipe.as_ref().and_then(restored_recipe),
    })
}

fn saved_recipe(recipe: &FilmRecipe) -> format::Recipe {
    let CameraSettings { seconds, rate, exposure, noise, seed } = recipe.settings;
    format::Recipe {
        document: recipe.document.clone(),
        source: recipe.source.clone(),
        state: recipe.state.clone(),
        language: recipe.language.clone(),
        camera: Some([seconds, rate, exposure, noise].map(Number)),
        seed,
    }
}

/// The recipe; `None` if its camera settings are invalid.
fn restored_recipe(saved: &format::Recipe) -> Option<FilmRecipe> {
    let [Number(seconds), Number(rate), Number(exposure), Number(noise)] = saved.camera?;
    let settings = CameraSettings { seconds, rate, exposure, noise, seed: saved.seed };
    settings.check().ok()?;
    Some(FilmRecipe {
        document: saved.document.clone(),
        source: saved.source.clone(),
        state: saved.state.clone(),
        language: saved.language.clone(),
        settings,
    })
}
