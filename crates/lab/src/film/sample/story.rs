//! *See it measured*: the sample film plays, its curve is drawn out of the surface, the drawn tube is laid over it and misses, and
//! the fit makes both meet. Any press outside of the bar, or Escape, ends it.

use super::super::access::Player;
use super::super::aim::Tool;
use super::super::now::now;
use super::super::{frames, opening, words};
use super::moment::{MOMENTS, Moment};
use super::{measure, take};
use crate::app::App;
use crate::fit;
use std::rc::Rc;
use view::browser;
use view::panel::tabs;
use view::stage::plot::PlotNodes;
use view::views::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent, PointerEvent};

/// Least time for which the film alone is shown, ms.
const FILM_ALONE: f64 = 3000.0;
/// Time for which the drawing lies over the film before the fit, ms.
const MISS: f64 = 5000.0;

/// Number of looks for the record after the tracking, 50 ms apart.
const RECORD_TASKS: usize = 40;

/// Marks the page for the style sheet, reveals the measured points, and hears what ends the story.
pub fn follow(app: App) {
    effect(move || {
        let moment = app.films.story.get();
        let Some(root) = document().document_element() else { return };
        let _ = match moment {
            Some(moment) => root.set_attribute("data-story", moment.name()),
            None => root.remove_attribute("data-story"),
        };
        measure_again(app);
    });
    // Outside of the story no frame of a film changes it.
    let until = memo(move || match app.films.story.get() {
        Some(Moment::Film) => Some(f64::NEG_INFINITY),
        Some(Moment::Curve) => {
            let frame = app.films.painted.get().unwrap_or_default();
            app.read_desk(|desk| desk.films().model_time_of(frame)).or(Some(0.0))
        }
        _ => None,
    });
    effect(move || {
        let until = until.get();
        app.slide(|play| play.change_plots(|plots, _| plots.draw_records_until(until)));
    });
    browser::listen("pointerdown", move |event: &PointerEvent| {
        let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let inside = target.is_some_and(|target| target.closest("#story").ok().flatten().is_some());
        if !inside && app.films.story.get_untracked().is_some_and(|moment| moment != Moment::Fit) {
            end(app);
        }
    });
    browser::listen("keydown", move |event: &KeyboardEvent| {
        if event.key() == "Escape" && app.films.story.get_untracked().is_some() {
            end(app);
        }
    });
}

/// Plots and scene measure their place again.
fn measure_again(app: App) {
    app.nodes(|nodes| nodes.plots.iter_mut().flatten().for_each(PlotNodes::measure_again));
    app.page.wake();
}

/// Begins the story.
pub fn begin(app: App) {
    if app.films.story.get_untracked().is_some() {
        return;
    }
    app.act(|play| play.change_run(|line, _| line.pause()));
    app.tab.set(tabs::MEASURE);
    app.films.story.set(Some(Moment::Film));
    browser::focus_later("story-end".to_owned());
    wasm_bindgen_futures::spawn_local(async move {
        if let Err(why) = tell(app).await {
            end(app);
            app.complain(format!("{} {why}", words::of(app).not_opened));
        }
    });
}

/// Ends the story. The film stays open, and its tracking goes on.
fn end(app: App) {
    app.films.story.set(None);
    app.films.playing.set(false);
    browser::focus_later("film-frame".to_owned());
}

/// True while this moment of the story is shown.
fn is_at(app: App, moment: Moment) -> bool {
    app.films.story.get_untracked() == Some(moment)
}

/// Proceeds from one moment to the next, unless the story has been ended. Returns false then.
fn proceed(app: App, from: Moment, to: Moment) -> bool {
    let goes_on = is_at(app, from);
    if goes_on {
        app.films.story.set(Some(to));
    }
    goes_on
}

async fn tell(app: App) -> Result<(), String> {
    take(app).await?;
    let Some(player) = app.with(|lab| lab.player.clone()).flatten() else { return Ok(()) };
    app.films.tool.set(Tool::Rest);
    measure(app);
    let is_still = browser::matches("(prefers-reduced-motion: reduce)");
    let begun = js_sys::Date::now();
    while is_at(app, Moment::Film) && (is_busy(app) || js_sys::Date::now() - begun < FILM_ALONE) {
        play_on(app, is_still);
        browser::pause(50).await;
    }
    if !is_measured(app).await {
        end(app);
        return Ok(());
    }
    if !proceed(app, Moment::Film, Moment::Curve) {
        return Ok(());
    }
    to_start(app, &player, is_still).await;
    while is_at(app, Moment::Curve) && app.films.playing.get_untracked() {
        browser::pause(50).await;
    }
    if !proceed(app, Moment::Curve, Moment::Theory) {
        return Ok(());
    }
    to_start(app, &player, is_still).await;
    let begun = js_sys::Date::now();
    while is_at(app, Moment::Theory) && js_sys::Date::now() - begun < MISS {
        browser::pause(50).await;
    }
    if proceed(app, Moment::Theory, Moment::Fit) {
        fit::start(app).await;
    }
    Ok(())
}

fn is_busy(app: App) -> bool {
    app.films.progress.with_untracked(Option::is_some) || app.read_desk(|desk| desk.films().is_tracking())
}

/// True if the tracking has given a record. The views have it some tasks later.
async fn is_measured(app: App) -> bool {
    for _ in 0..RECORD_TASKS {
        if now(app).is_some_and(|now| now.record.is_some()) {
            return true;
        }
        browser::pause(50).await;
    }
    false
}

/// Plays the film again when it has ended.
fn play_on(app: App, is_still: bool) {
    if !is_still && !app.films.playing.get_untracked() {
        frames::play(app);
    }
}

/// Plays the film from its first frame, once that is painted. With less motion, shows the last frame.
async fn to_start(app: App, player: &Rc<Player>, is_still: bool) {
    app.films.playing.set(false);
    browser::pause(50).await;
    if is_still {
        frames::go(app, player.source.count());
        return browser::pause(2000).await;
    }
    frames::go(app, 0);
    browser::pause(300).await;
    frames::play(app);
}

/// Bar in the place of the transport: the moments, one sentence, and what ends the story.
pub fn bar(app: App) -> View {
    let words = words::of(app);
    let Some(moment) = app.films.story.get() else { return View::new() };
    let said = match moment {
        Moment::Film => words.story_film,
        Moment::Curve => words.story_curve,
        Moment::Theory => words.story_theory,
        Moment::Fit => words.story_fit,
    };
    let progress = move || match app.films.progress.get() {
        Some(now) if !now.computing => format!("{} {} / {}", words.frame, now.taken, now.of),
        _ => String::new(),
    };
    let is_last = moment == Moment::Fit;
    let own = move |_| {
        opening::close(app);
        app.films.story.set(None);
        app.act(|play| play.change_run(|line, _| line.show_time(0.0)));
        app.tab.set(tabs::EXPLORE);
        browser::focus_later("apparatus".to_owned());
    };
    let turn = button().class("primary").id("your-turn").when(events::click, own).child(words.your_turn);
    let name = if is_last { words.story_close } else { words.story_skip };
    let close = button().class("quiet outlined").id("story-end").when(events::click, move |_| end(app)).child(name);
    let number = MOMENTS.iter().position(|other| *other == moment).unwrap_or_default() + 1;
    let shares = MOMENTS
        .iter()
        .enumerate()
        .map(|(place, _)| span().class(if place < number { "told" } else { "untold" }).attr("aria-hidden", "true"));
    section()
        .class("transport story")
        .id("story")
        .attr("aria-label", app.page.words().see_measured)
        .child(div().class("moments").each(shares, |share| share))
        .child(p().id("story-said").role("status").child(said))
        .child(span().class("note").child(text(progress)))
        .maybe(is_last.then_some(turn))
        .child(close)
        .into()
}
