//! A stopwatch for the time of the simulation: it goes as fast as the run does, and stands while the run stands.

use crate::app::App;
use crate::icons;
use crate::views::*;
use play::Play;

/// The time that has been stopped, and since when it goes on.
#[derive(Clone, Copy, Default, PartialEq)]
struct Watch {
    held: f64,
    since: Option<f64>,
}

impl Watch {
    /// A run that begins again behind the moment of starting adds nothing.
    fn elapsed(self, now: f64) -> f64 {
        self.held + self.since.map_or(0.0, |since| (now - since).max(0.0))
    }
}

/// The stopwatch.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let watch = create_signal(Watch::default());
    let reading = move |watch: Watch| app.read(|play| play.time_words(watch.elapsed(play.time())));
    let shown = move || {
        app.changes.frame.track();
        reading(watch.get())
    };
    let runs = move || watch.get().since.is_some();
    let press = move |_| {
        let (now, before) = (app.read(|play: &mut Play| play.time()), watch.get_untracked());
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
