//! The transport: play, step, reset, time line, speed, sound.

use crate::app::App;
use crate::{frame, icons};
use leptos::html;
use leptos::prelude::*;
use session::{SPEEDS, Session, Status};
use web_sys::{HtmlElement, HtmlInputElement};

/// The time line has so many positions.
const POSITIONS: f64 = 10_000.0;

/// What changes in each frame.
pub struct TransportNodes {
    clock: HtmlElement,
    line: HtmlInputElement,
    shown: String,
    position: i32,
}

impl TransportNodes {
    /// Shows the time.
    pub fn draw(&mut self, session: &mut Session) {
        let text = session.time_text();
        if text != self.shown {
            self.clock.set_text_content(Some(&text));
            // Read only when the slider has the focus and moves; otherwise it costs nothing.
            if !session.is_playing() || self.shown.is_empty() {
                let _ = self.line.set_attribute("aria-valuetext", &text);
            }
            self.shown = text;
        }
        let end = session.end();
        let fraction = if end > 0.0 { (session.time() / end).clamp(0.0, 1.0) } else { 0.0 };
        let position = (fraction * POSITIONS).round() as i32;
        if position != self.position {
            self.line.set_value(&position.to_string());
            // The part that lies behind, for the style sheet.
            let _ = HtmlElement::style(&self.line).set_property("--part", &format!("{:.2}%", fraction * 100.0));
            self.position = position;
        }
    }
}

/// The bar.
pub fn view(app: App) -> impl IntoView {
    let words = app.words();
    let status = move || {
        app.changes.transport.track();
        app.read(|session| Some(session.status()))
    };
    let playing = Memo::new(move |_| status() == Some(Status::Playing));
    let clock = NodeRef::<html::Output>::new();
    let line = NodeRef::<html::Input>::new();
    line.on_load(move |line| {
        let Some(clock) = clock.get_untracked() else { return };
        let clock = wasm_bindgen::JsCast::unchecked_into(web_sys::Element::from(clock));
        app.with(|lab| lab.stage.transport = Some(TransportNodes { clock, line, shown: String::new(), position: -1 }));
        frame::wake(app);
    });
    let play = move || if playing.get() { words.pause } else { words.play };
    view! {
        <section class="transport" id="transport" aria-label=words.transport>
            <div class="buttons">
                <button type="button" class="icon" id="reset" title=format!("{} (R)", words.reset) aria-label=words.reset
                    on:click=move |_| app.act(Session::reset)>{icons::reset()}</button>
                <button type="button" class="icon" id="step-back" title=format!("{} (,)", words.step_back) aria-label=words.step_back
                    on:click=move |_| app.act(Session::step_back)>{icons::step_back()}</button>
                <button type="button" class="play" id="play" title=move || format!("{} (K)", play()) aria-label=play
                    on:click=move |_| app.act(Session::toggle)>
                    {move || if playing.get() { icons::pause().into_any() } else { icons::play().into_any() }}
                </button>
                <button type="button" class="icon" id="step-forward" title=format!("{} (.)", words.step_forward) aria-label=words.step_forward
                    on:click=move |_| app.act(Session::step_forward)>{icons::step_forward()}</button>
            </div>
            <div class="time">
                <output node_ref=clock class="clock" id="clock" aria-label=words.time aria-live="off"></output>
                <input node_ref=line type="range" class="line" id="time-line" min="0" max=POSITIONS.to_string() step="any" value="0" aria-label=words.time_line
                    on:input=move |event| scrub(app, &event_target_value(&event))
                    on:keydown=move |event| line_key(app, &event) />
            </div>
            <div class="extras">
                {speed(app)}
                {sound(app)}
            </div>
            <p class="trouble" role="status">{move || { app.changes.values.track(); status(); trouble(app) }}</p>
        </section>
    }
}

fn scrub(app: App, position: &str) {
    let fraction = position.parse::<f64>().unwrap_or(0.0) / POSITIONS;
    app.slide(|session| session.scrub(fraction * session.end()));
}

/// On the time line the arrows go by steps of the grid, not by the slider's positions.
fn line_key(app: App, event: &web_sys::KeyboardEvent) {
    if event.ctrl_key() || event.alt_key() || event.meta_key() {
        return;
    }
    match event.key().as_str() {
        "ArrowLeft" | "ArrowDown" => app.slide(Session::step_back),
        "ArrowRight" | "ArrowUp" => app.slide(|session| {
            // Within what is recorded; the step button goes on from its end.
            if session.is_scrubbed() {
                session.step_forward();
            }
        }),
        _ => return,
    }
    event.prevent_default();
    event.stop_propagation();
}

fn speed(app: App) -> impl IntoView {
    let words = app.words();
    let chosen = move || {
        app.changes.transport.track();
        app.read(|session| session.speed())
    };
    let options = SPEEDS
        .iter()
        .map(|&speed| {
            let text = if speed < 1.0 { format!("1/{} ×", 1.0 / speed) } else { format!("{speed} ×") };
            view! { <option value=speed.to_string() selected=move || chosen() == speed>{text}</option> }
        })
        .collect_view();
    view! {
        <label class="speed">
            <span class="visually-hidden">{words.speed}</span>
            <select id="speed" title=words.speed prop:value=move || chosen().to_string()
                on:change=move |event| if let Ok(speed) = event_target_value(&event).parse() {
                    app.act(|session| session.set_speed(speed));
                }>
                {options}
            </select>
        </label>
    }
}

fn sound(app: App) -> impl IntoView {
    let words = app.words();
    let on = RwSignal::new(app.with(|lab| lab.sound.is_on()).unwrap_or_default());
    let toggle = move |_| {
        app.with(|lab| lab.sound.turn(!on.get_untracked()));
        on.set(app.with(|lab| lab.sound.is_on()).unwrap_or_default());
        frame::wake(app);
    };
    view! {
        <button type="button" class="icon" id="sound" title=words.sound_title aria-label=words.sound aria-pressed=move || on.get().to_string() on:click=toggle>
            {move || if on.get() { icons::sound().into_any() } else { icons::mute().into_any() }}
        </button>
    }
}

/// What keeps the run from going on as it should.
fn trouble(app: App) -> String {
    let words = app.words();
    app.read(|session| match session.status() {
        Status::Failed => {
            session.problem().map(|problem| format!("{}. {}", problem.message, problem.hint)).unwrap_or_default()
        }
        Status::Full => words.full.to_owned(),
        Status::Playing if session.slippage() > 0.5 => words.slow.to_owned(),
        _ => String::new(),
    })
}
