//! Effects of clicks on the film.

use super::aim::{Handle, Kind, Pixel, Tool};
use super::now::now;
use super::refusals::refuse;
use super::{calibrating, frames, tracking};
use crate::app::App;
use desk::{FilmedBody, FilmedSurface, LengthsForm, POINT_SIGMA, Subject};
use film::tracking::column::Click;
use units::order::sort_by;
use view::views::*;

/// Applies the selected tool at a point, px.
pub fn place(app: App, at: Pixel) {
    let films = app.films;
    let frame = films.frame.get_untracked();
    match films.tool.get_untracked() {
        Tool::Rest => {}
        Tool::Subject => place_subject(app, Click { frame, position: at }),
        Tool::Tube => collect(app, at, 2, |app, ends| {
            change_subject(app, |subject| {
                if let Subject::Surfaces(surfaces) = subject
                    && let Some(surface) = surfaces.last_mut()
                    && let [from, to] = ends[..]
                {
                    surface.tube = Some([from, to]);
                }
            });
        }),
        Tool::Still => {
            let mut marks = now(app).map(|now| now.marks.clone()).unwrap_or_default();
            marks.push(at);
            set_marks(app, marks);
        }
        Tool::Ruler => {
            let mut marks = films.ruler.get_clone_untracked();
            if marks.len() >= 2 {
                marks.clear();
            }
            marks.push(at);
            let complete = marks.len() == 2;
            films.ruler.set(marks);
            if complete {
                films.tool.set(Tool::Rest);
                calibrating::ruler(app);
                view::browser::focus("film-length");
            }
        }
        Tool::Origin | Tool::Axis => {
            let origin = films.tool.get_untracked() == Tool::Origin;
            films.tool.set(Tool::Rest);
            calibrating::change(app, move |form| *if origin { &mut form.origin } else { &mut form.axis } = Some(at));
        }
        Tool::Corners => {
            let mut corners = films.corners.get_clone_untracked();
            if corners.len() >= 4 {
                corners.clear();
            }
            corners.push(at);
            let complete = corners.len() == 4;
            films.corners.set(if complete { around(corners) } else { corners });
            if complete {
                films.tool.set(Tool::Rest);
                calibrating::rectangle(app);
                view::browser::focus("film-width");
            }
        }
    }
}

/// Corners in the order bottom left, bottom right, top right, top left, independent of the order of clicks.
fn around(mut corners: Vec<Pixel>) -> Vec<Pixel> {
    // Lower corners first; each pair in counter-clockwise order.
    sort_by(&mut corners, |one, other| other[1].total_cmp(&one[1]));
    let half = corners.len() / 2;
    let (low, high) = corners.split_at_mut(half);
    sort_by(low, |one, other| one[0].total_cmp(&other[0]));
    sort_by(high, |one, other| other[0].total_cmp(&one[0]));
    corners
}

/// Collects points until there are `count`, and passes them to `done`.
fn collect(app: App, at: Pixel, count: usize, done: impl Fn(App, Vec<Pixel>)) {
    let mut points = app.films.points.take();
    points.push(at);
    if points.len() < count {
        return app.films.points.set(points);
    }
    app.films.points.set(Vec::new());
    app.films.tool.set(Tool::Rest);
    done(app, points);
}

fn place_subject(app: App, click: Click) {
    let films = app.films;
    let before = now(app).map(|now| now.subject.clone()).unwrap_or_default();
    let subject = match (films.kind.get_untracked(), before) {
        (Kind::Arms, Subject::Surfaces(mut surfaces)) if surfaces.len() == 1 => {
            surfaces.push(FilmedSurface::new(click));
            Subject::Surfaces(surfaces)
        }
        (Kind::Surface | Kind::Arms, _) => Subject::Surfaces(vec![FilmedSurface::new(click)]),
        (Kind::Body, Subject::Bodies(mut bodies)) => {
            match bodies.get_mut(films.body.get_untracked()) {
                Some(body) => {
                    body.keys.retain(|key| key.frame != click.frame);
                    body.keys.push(click);
                }
                None => bodies.push(FilmedBody::new(click)),
            }
            Subject::Bodies(bodies)
        }
        (Kind::Body, _) => Subject::Bodies(vec![FilmedBody::new(click)]),
        (Kind::Hand, Subject::Points { mut clicks, sigma }) => {
            clicks.retain(|other| other.frame != click.frame);
            clicks.push(click);
            Subject::Points { clicks, sigma }
        }
        (Kind::Hand, _) => Subject::Points { clicks: vec![click], sigma: POINT_SIGMA },
    };
    let awaits = films.kind.get_untracked() == Kind::Arms
        && matches!(&subject, Subject::Surfaces(surfaces) if surfaces.len() < 2);
    match films.kind.get_untracked() {
        // The next click belongs to the next frame.
        Kind::Hand => {
            follow(app, subject);
            return frames::step(app, 1);
        }
        _ if awaits => return take(app, subject),
        // The next click sets the ruler, unless there is one.
        _ if films.ruler.with_untracked(|marks| marks.len() < 2) => films.tool.set(Tool::Ruler),
        _ => films.tool.set(Tool::Rest),
    }
    follow(app, subject);
}

/// Changes the subject and starts tracking.
pub fn change_subject(app: App, change: impl FnOnce(&mut Subject)) {
    if let Some(now) = now(app) {
        let mut subject = now.subject.clone();
        change(&mut subject);
        follow(app, subject);
    }
}

/// Sets the subject without tracking.
fn take(app: App, subject: Subject) {
    refuse(app, app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.follow(play, subject))));
}

fn follow(app: App, subject: Subject) {
    let tracks = subject.needs_tracking();
    let refusal = app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.follow(play, subject)));
    let refused = refusal.is_some();
    refuse(app, refusal);
    if tracks && !refused {
        tracking::begin(app);
    }
}

/// Sets the fixed marks and repeats the tracking.
pub fn set_marks(app: App, marks: Vec<Pixel>) {
    let refusal = app.attempt_on_desk(|desk| desk.change_films(|films, play| films.set_fixed_marks(play, marks)));
    let refused = refusal.is_some();
    refuse(app, refusal);
    if !refused && now(app).is_some_and(|now| now.subject.needs_tracking()) {
        tracking::begin(app);
    }
}

/// Removes a point.
pub fn remove(app: App, handle: Handle) {
    app.films.selected.set(None);
    match handle {
        Handle::Surface(_) | Handle::Tube(..) | Handle::Body(..) | Handle::Hand(_) => {
            change_subject(app, |subject| remove_from(subject, handle));
        }
        Handle::Still(mark) => {
            let mut marks = now(app).map(|now| now.marks.clone()).unwrap_or_default();
            if mark < marks.len() {
                marks.remove(mark);
            }
            set_marks(app, marks);
        }
        Handle::Ruler(mark) => remove_length(app, app.films.ruler, mark),
        Handle::Corner(corner) => remove_length(app, app.films.corners, corner),
        Handle::Origin => calibrating::change(app, |form| form.origin = None),
        Handle::Axis => calibrating::change(app, |form| form.axis = None),
    }
}

/// Removes a point of ruler or rectangle. The scale is removed until another point is clicked.
fn remove_length(app: App, points: Signal<Vec<Pixel>>, at: usize) {
    points.update(|points| {
        if at < points.len() {
            points.remove(at);
        }
    });
    calibrating::change(app, |form| form.lengths = LengthsForm::Pixels);
}

fn remove_from(subject: &mut Subject, handle: Handle) {
    match (handle, subject) {
        (Handle::Surface(number), Subject::Surfaces(surfaces)) if number < surfaces.len() => {
            surfaces.remove(number);
        }
        (Handle::Tube(number, _), Subject::Surfaces(surfaces)) => {
            surfaces.get_mut(number).into_iter().for_each(|surface| surface.tube = None);
        }
        (Handle::Body(number, key), Subject::Bodies(bodies)) => {
            if let Some(keys) = bodies.get_mut(number).map(|body| &mut body.keys).filter(|keys| key < keys.len()) {
                keys.remove(key);
            }
        }
        (Handle::Hand(number), Subject::Points { clicks, .. }) if number < clicks.len() => {
            clicks.remove(number);
        }
        _ => {}
    }
}

/// Moves a point to another position, px.
pub fn moved(app: App, handle: Handle, at: Pixel) {
    match handle {
        Handle::Surface(_) | Handle::Tube(..) | Handle::Body(..) | Handle::Hand(_) => {
            change_subject(app, |subject| move_in(subject, handle, at));
        }
        Handle::Still(mark) => {
            let mut marks = now(app).map(|now| now.marks.clone()).unwrap_or_default();
            if let Some(place) = marks.get_mut(mark) {
                *place = at;
            }
            set_marks(app, marks);
        }
        Handle::Ruler(mark) => {
            app.films.ruler.update(|marks| marks.get_mut(mark).into_iter().for_each(|place| *place = at));
            calibrating::ruler(app);
        }
        Handle::Corner(corner) => {
            app.films.corners.update(|corners| corners.get_mut(corner).into_iter().for_each(|place| *place = at));
            calibrating::rectangle(app);
        }
        Handle::Origin => calibrating::change(app, move |form| form.origin = Some(at)),
        Handle::Axis => calibrating::change(app, move |form| form.axis = Some(at)),
    }
}

fn move_in(subject: &mut Subject, handle: Handle, at: Pixel) {
    let place = match (handle, subject) {
        (Handle::Surface(number), Subject::Surfaces(surfaces)) => {
            surfaces.get_mut(number).map(|surface| &mut surface.click.position)
        }
        (Handle::Tube(number, end), Subject::Surfaces(surfaces)) => {
            surfaces.get_mut(number).and_then(|surface| surface.tube.as_mut()?.get_mut(end))
        }
        (Handle::Body(number, key), Subject::Bodies(bodies)) => {
            bodies.get_mut(number).and_then(|body| body.keys.get_mut(key)).map(|key| &mut key.position)
        }
        (Handle::Hand(number), Subject::Points { clicks, .. }) => {
            clicks.get_mut(number).map(|click| &mut click.position)
        }
        _ => None,
    };
    if let Some(place) = place {
        *place = at;
    }
}

/// Movable point.
#[derive(Clone, PartialEq)]
pub struct Held {
    /// Its handle.
    pub handle: Handle,
    /// Position, px.
    pub at: Pixel,
    /// Frame of the click; `None` for a point of all frames.
    pub frame: Option<usize>,
}

impl Held {
    /// True if the point is shown in a frame.
    pub fn is_seen(&self, frame: usize) -> bool {
        self.frame.is_none_or(|own| own == frame)
    }
}

/// All movable points.
pub fn held(app: App) -> Vec<Held> {
    let films = app.films;
    let mut held = Vec::new();
    let mut hold = |handle: Handle, at: Pixel, frame: Option<usize>| held.push(Held { handle, at, frame });
    if let Some(now) = films.now.get_clone() {
        match &now.subject {
            Subject::Nothing => {}
            Subject::Surfaces(surfaces) => {
                for (number, surface) in surfaces.iter().enumerate() {
                    hold(Handle::Surface(number), surface.click.position, Some(surface.click.frame));
                    for (end, at) in surface.tube.iter().flatten().enumerate() {
                        hold(Handle::Tube(number, end), *at, None);
                    }
                }
            }
            Subject::Bodies(bodies) => {
                for (number, body) in bodies.iter().enumerate() {
                    for (key, click) in body.keys.iter().enumerate() {
                        hold(Handle::Body(number, key), click.position, Some(click.frame));
                    }
                }
            }
            Subject::Points { clicks, .. } => {
                for (number, click) in clicks.iter().enumerate() {
                    hold(Handle::Hand(number), click.position, Some(click.frame));
                }
            }
        }
        for (mark, at) in now.marks.iter().enumerate() {
            hold(Handle::Still(mark), *at, None);
        }
        if let Some(origin) = now.form.origin {
            hold(Handle::Origin, origin, None);
        }
        if let Some(axis) = now.form.axis {
            hold(Handle::Axis, axis, None);
        }
    }
    films.ruler.with(|marks| marks.iter().enumerate().for_each(|(mark, at)| hold(Handle::Ruler(mark), *at, None)));
    films.corners.with(|corners| {
        corners.iter().enumerate().for_each(|(corner, at)| hold(Handle::Corner(corner), *at, None));
    });
    held
}
