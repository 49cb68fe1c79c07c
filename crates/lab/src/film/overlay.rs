//! Overlays of the shown frame: lines between clicks, the tracks, and the model.

use super::aim::{Handle, Pixel};
use super::tools::Held;
use super::{now, tools};
use crate::app::App;
use desk::BodyOutline;
use sycamore_web::SvgGlobalAttributes;
use view::views::*;

/// Lines: axis of a tube, ruler, x axis, rectangle, and outlines of bodies in the frames of their clicks.
pub fn lines(app: App, [width, height]: Pixel) -> View {
    let lines = memo(move || {
        let aim = app.films.aim.get();
        let held = tools::held(app);
        let at = |handle: Handle| {
            let moved = aim.filter(|aim| aim.handle == Some(handle)).map(|aim| aim.at);
            moved.or_else(|| held.iter().find(|held| held.handle == handle).map(|held| held.at))
        };
        let line = |class: &'static str, from: Handle, to: Handle| {
            let (from, to) = (at(from)?, at(to)?);
            Some((class, format!("M{:.2} {:.2}L{:.2} {:.2}", from[0], from[1], to[0], to[1])))
        };
        let painted = app.films.painted.get();
        let now = app.films.now.get_clone();
        let outline = |held: &Held| {
            let Handle::Body(body, _) = held.handle else { return None };
            let BodyOutline { radius, offset, .. } =
                now.as_ref()?.outlines.get(body).copied().flatten().filter(|_| held.frame == painted)?;
            let [x, y] = at(held.handle)?;
            let (left, middle) = (x + offset[0] - radius, y + offset[1]);
            let arc = |across: f64| format!("a{radius:.2} {radius:.2} 0 1 0 {across:.2} 0");
            Some(("body-outline", format!("M{left:.2} {middle:.2}{}{}", arc(2.0 * radius), arc(-2.0 * radius))))
        };
        let mut lines =
            vec![line("ruler", Handle::Ruler(0), Handle::Ruler(1)), line("axis", Handle::Origin, Handle::Axis)];
        lines.extend((0..2).map(|number| line("tube", Handle::Tube(number, 0), Handle::Tube(number, 1))));
        lines.extend((0..4).map(|corner| line("ruler", Handle::Corner(corner), Handle::Corner((corner + 1) % 4))));
        lines.extend(held.iter().map(outline));
        lines.into_iter().flatten().collect::<Vec<_>>()
    });
    let draw = move || {
        each(lines.get_clone(), |(class, d)| View::from((path().class("halo").d(d.clone()), path().class(class).d(d))))
    };
    // Trails of bodies. The path of a surface is shown below the film.
    let trails = memo(move || {
        let now = app.films.now.get_clone();
        let bodies = now.iter().flat_map(|now| &now.tracks).filter(|track| track.direction.is_none());
        let trail = |track: &film::tracking::Track| {
            let points = track.points.iter().map(|point| format!("{:.1} {:.1}", point.position[0], point.position[1]));
            points.collect::<Vec<_>>().join("L")
        };
        bodies.map(trail).filter(|trail| !trail.is_empty()).collect::<Vec<_>>()
    });
    let ways = move || each(trails.get_clone(), |trail| path().class("trail").d(format!("M{trail}")));
    svg()
        .class("film-lines")
        .viewBox(format!("0 0 {width} {height}"))
        .attr("preserveAspectRatio", "none")
        .attr("aria-hidden", "true")
        .child(changing(ways))
        .child(changing(draw))
        .into()
}

/// Tracked positions in this frame, and the model.
pub fn marks(app: App, [width, height]: Pixel) -> View {
    let mark = move |class: &'static str, [x, y]: Pixel| {
        let place = format!("left:{:.3}%;top:{:.3}%", 100.0 * x / width, 100.0 * y / height);
        span().class(format!("film-mark {class}")).style(place).attr("aria-hidden", "true")
    };
    changing(move || {
        let Some(frame) = app.films.painted.get() else { return View::new() };
        let now = app.films.now.get_clone();
        let found = now.iter().flat_map(|now| &now.tracks).filter_map(|track| {
            let at = track.points.binary_search_by_key(&frame, |point| point.frame).ok()?;
            track.points.get(at).map(|point| point.position)
        });
        let found: Vec<Pixel> = found.collect();
        app.fits.track();
        app.changes.parameters.track();
        app.changes.transport.track();
        let models = now::models(app, frame);
        View::from((each(found, |at| mark("found", at)), each(models, |(_, at)| mark("model", at))))
    })
}

/// Values of this frame as text.
pub fn readout(app: App) -> View {
    let said = move || {
        app.films.now.track();
        app.fits.track();
        app.changes.transport.track();
        let frame = app.films.frame.get();
        now::values(app, frame)
    };
    p().class("film-values").id("film-values").child(text(said)).into()
}
