//! A stopwatch in the time of the simulation: it stops when the run is paused.

use crate::app::App;
use crate::pieces::icons;
use crate::views::*;
use play::Play;

/// Accumulated time, and the time of the last start while it is running, SI.
#[derive(Clone, Copy, Default, PartialEq)]
struct Watch {
    held: f64,
    since: Option<f64>,
}

impl Watch {
    /// Elapsed time at `now`, SI. If the run was set back before the time of the start, nothing is added.
    fn elapsed(self, now: f64) -> f64 {
        self.held + self.since.map_or(0.0, |since| (now - since).max(0.0))
    }
}

/// The stopwatch.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let watch = create_signal(Watch::default());
    let reading = move |watch: Watch| {
        app.read(|play| play.basis().time_words(play.course(), watch.elapsed(play.course().time())))
    };
    let shown = move || {
        app.changes.frame.track();
        reading(watch.get())
    };
    let runs = move || watch.get().since.is_some();
    let press = move |_| {
        let (now, before) = (app.read(|play: &mut Play| play.course().time()), watch.get_untracked());
        let next = match before.since {
            Some(_) => Watch { held: before.elapsed(now), since: None },
            None => Watch { since: Some(now), ..before },
        };
        watch.set(next);
        let what = if next.since.is_some() { words.stopwatch_started } else { words.stopwatch };
        app.say(format!("{what}: {}", reading(next)));
    };
    let reset = move |_| {
        watch.set(Watch::default());
        app.say(format!("{}: {}", words.stopwatch, reading(Watch::default())));
    };
    let name = move || if runs() { words.stopwatch_stop } else { words.stopwatch_start };
    div()
        .class("stopwatch")
        .role("group")
        .attr("aria-label", words.stopwatch)
        .child(output().attr("aria-live", "off").attr("aria-label", words.stopwatch).child(text(shown)))
        .child(
            button()
                .class("icon")
                .id("stopwatch-press")
                .title(name)
                .attr("aria-label", name)
                .when(events::click, press)
                .child(changing(move || if runs() { icons::pause() } else { icons::play() })),
        )
        .child(button().class("icon").called(words.stopwatch_reset).when(events::click, reset).child(icons::reset()))
}
