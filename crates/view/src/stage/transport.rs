//! The transport: play, step, back to start, time line, speed, sound.

use crate::app::App;
use crate::pieces::steady::Steady;
use crate::views::*;
use crate::{browser, page::projector, pieces::icons};
use play::{Play, SPEEDS, Status};
use web_sys::{HtmlElement, HtmlInputElement};

/// Number of positions of the time line.
const POSITIONS: f64 = 10_000.0;
/// Number of positions while the run plays, each half a pixel on a phone: every change costs the browser a layout.
const MOVING: f64 = 500.0;

/// Nodes that change in each frame.
pub struct TransportNodes {
    clock: Steady,
    line: HtmlInputElement,
    /// Bars below the time line: the recorded part, and the part before the time shown.
    bars: [HtmlElement; 2],
    /// Fractions of the line before the time shown, and recorded.
    parts: (f64, f64),
}

impl TransportNodes {
    /// Updates the clock and the time line.
    pub fn draw(&mut self, play: &mut Play) {
        let text = play.basis().time_text(play.course());
        if text != self.clock.shown() {
            // Needed only when the user moves the slider, so it is not updated while the run plays.
            if !play.time_line().is_playing() || self.clock.shown().is_empty() {
                let _ = self.line.set_attribute("aria-valuetext", &text);
            }
            self.clock.show(&text);
        }
        let places = if play.time_line().is_playing() { MOVING } else { POSITIONS };
        let part = |time: f64| ((time / play.basis().horizon(play.course())).clamp(0.0, 1.0) * places).round() / places;
        let (fraction, recorded) = (part(play.course().time()), part(play.course().front()));
        let position = (fraction * POSITIONS).round();
        // The user may have moved the slider beyond the recording.
        if position != self.line.value_as_number() {
            self.line.set_value(&position.to_string());
        }
        if (fraction, recorded) != self.parts {
            for (bar, length) in self.bars.iter().zip([recorded, fraction]) {
                // A scale transform needs no layout, unlike a change of the width.
                let _ = bar.style().set_property("transform", &format!("scaleX({length:.4})"));
            }
            self.parts = (fraction, recorded);
        }
    }
}

/// The transport bar.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let status = move || {
        app.changes.transport.track();
        app.read(|play| Some(play.time_line().status()))
    };
    let playing = memo(move || status() == Some(Status::Playing));
    let (steady, digits) = Steady::new();
    let clock =
        output().class("clock").id("clock").attr("aria-label", words.time).attr("aria-live", "off").child(digits);
    let mut line =
        input().r#type("range").class("line").id("time-line").min("0").max(POSITIONS.to_string()).step("any");
    let [mut recorded, mut behind] = ["recorded", "behind"].map(|class| span().class(class));
    let nodes = TransportNodes {
        clock: steady,
        line: line.node(),
        bars: [recorded.node(), behind.node()],
        parts: (f64::NAN, f64::NAN),
    };
    app.nodes(|all| all.transport = Some(nodes));
    app.wake();
    let step = |id: &'static str, name: &'static str, key: char, icon: SvgSvg, act: fn(&mut Play)| {
        button()
            .class("icon")
            .id(id)
            .title(format!("{name} ({key})"))
            .attr("aria-label", name)
            .when(events::click, move |_| app.act(act))
            .child(icon)
    };
    let play = move || if playing.get() { words.pause } else { words.play };
    let toggle = button()
        .class(move || if playing.get() { "play playing" } else { "play" })
        .id("play")
        .title(move || format!("{} (K)", play()))
        .attr("aria-label", play)
        .when(events::click, move |_| app.act(|play| play.change_run(|line, _| line.toggle())))
        .child(changing(move || if playing.get() { icons::pause() } else { icons::play() }));
    let buttons = div()
        .class("buttons")
        .child(step("back-to-start", words.back_to_start, 'R', icons::reset(), |play| {
            play.change_run(|line, basis| line.back_to_start(basis))
        }))
        .child(step("step-back", words.step_back, ',', icons::step_back(), |play| {
            play.change_run(|line, _| line.step_back())
        }))
        .child(toggle)
        .child(step("step-forward", words.step_forward, '.', icons::step_forward(), |play| {
            play.change_run(|line, _| line.step_forward())
        }));
    let line = line
        .value("0")
        .attr("aria-label", words.time_line)
        .when(events::input, move |event| scrub(app, &value_of(&event)))
        .when(events::keydown, move |event| line_key(app, &event));
    let place_of_line = div().class("line-place").child(recorded).child(behind).child(line);
    let trouble = move |announced: bool| {
        app.changes.values.track();
        status();
        trouble(app, announced)
    };
    // Before a run has begun there is nothing to go back to or to hurry.
    let fresh = memo(move || {
        app.changes.values.track();
        !app.read(|play| play.time_line().has_run())
    });
    section()
        .class(move || if fresh.get() { "transport fresh" } else { "transport" })
        .id("transport")
        .attr("aria-label", words.transport)
        .child(buttons)
        .child(div().class("time").child(clock).child(place_of_line))
        .child(div().class("extras").child(speed(app)).child(sound(app)).child(projector::button_of(app)))
        // The first reason is announced by the simulation; only the second one must be a live region.
        .child(ended(app))
        .child(p().class("trouble").child(text(move || trouble(true))))
        .child(p().class("trouble").role("status").child(text(move || trouble(false))))
}

fn scrub(app: App, position: &str) {
    let fraction = units::number::decimal(position).unwrap_or(0.0) / POSITIONS;
    app.slide(|play| play.change_run(|line, basis| line.scrub(fraction * basis.horizon(line.course()))));
}

/// On the time line, the arrow keys move by grid steps instead of slider positions.
fn line_key(app: App, event: &web_sys::KeyboardEvent) {
    if event.ctrl_key() || event.alt_key() || event.meta_key() {
        return;
    }
    match event.key().as_str() {
        "ArrowLeft" | "ArrowDown" => app.slide(|play| play.change_run(|line, _| line.step_back())),
        "ArrowRight" | "ArrowUp" => app.slide(|play| {
            // Only within the recording; beyond its end, the step button is used.
            if play.course().is_scrubbed() {
                play.change_run(|line, _| line.step_forward());
            }
        }),
        _ => return,
    }
    event.prevent_default();
    event.stop_propagation();
}

fn speed(app: App) -> HtmlLabel {
    let words = app.words();
    let chosen = move || {
        app.changes.transport.track();
        app.read(|play| play.time_line().speed())
    };
    let choose = |speed: f64| {
        let name = app.read(|play| play.time_line().speed_text(play.basis(), speed));
        option().value(speed.to_string()).selected(move || chosen() == speed).child(name)
    };
    let set = move |event| {
        if let Some(speed) = units::number::decimal(&value_of(&event)) {
            app.act(|play| play.change_run(|line, _| line.set_speed(speed)));
        }
    };
    let select = select()
        .id("speed")
        .title(words.speed)
        .when(events::change, set)
        .each(SPEEDS, choose)
        .prop("value", move || chosen().to_string());
    label().class("speed").child(span().class("visually-hidden").child(words.speed)).child(select)
}

fn sound(app: App) -> HtmlButton {
    let words = app.words();
    let on = create_signal(app.nodes(|nodes| nodes.sound.is_on()).unwrap_or_default());
    let toggle = move |_| {
        app.nodes(|nodes| nodes.sound.turn(!on.get_untracked()));
        on.set(app.nodes(|nodes| nodes.sound.is_on()).unwrap_or_default());
        app.wake();
    };
    button()
        .class("icon")
        .id("sound")
        .title(words.sound_title)
        .attr("aria-label", words.sound)
        .attr("aria-pressed", move || on.get().to_string())
        .when(events::click, toggle)
        .child(changing(move || if on.get() { icons::sound() } else { icons::mute() }))
}

/// Message that the run has reached the end set by the document or an event, with a button to continue. The simulation
/// announces it.
fn ended(app: App) -> impl Into<View> {
    let words = app.words();
    let ending = memo(move || {
        app.changes.transport.track();
        app.read(|play| play.time_line().ending(play.basis()))
    });
    // The button disappears when used; the focus stays in the transport.
    let go_on = move |_| {
        app.act(|play| play.change_run(|line, _| line.play()));
        if let Some(play) = browser::by_id::<HtmlElement>("play") {
            let _ = play.focus();
        }
    };
    changing(move || match ending.get_clone() {
        Some(ending) => {
            let go_on = button().class("action").id("go-on").child(words.go_on).when(events::click, go_on);
            div().class("ended").child(p().child(ending)).child(go_on).into()
        }
        None => View::new(),
    })
}

/// Text for a failed or stopped run. `announced`: true for the reasons that the simulation has already announced, false
/// for the others.
fn trouble(app: App, announced: bool) -> String {
    let words = app.words();
    app.read(|play| match play.time_line().status() {
        Status::Failed if announced => play
            .time_line()
            .problem(play.basis())
            .map(|problem| format!("{} {}", problem.message, problem.hint))
            .unwrap_or_default(),
        Status::Full if announced => words.full.to_owned(),
        Status::Playing if !announced && play.time_line().slippage() > 0.5 => words.slow.to_owned(),
        Status::Failed | Status::Full | Status::Ended => String::new(),
        _ if announced => String::new(),
        _ => play
            .time_line()
            .notice(play.basis())
            .map(|notice| format!("{} {}", notice.message, notice.hint))
            .unwrap_or_default(),
    })
}
