//! A control for each parameter: name, slider, number field with unit.

use crate::app::App;
use crate::controls::symbol;
use leptos::html;
use leptos::prelude::*;
use session::ParameterView;
use web_sys::KeyboardEvent;

/// A field for a number with everything a field needs; the caller shows the error below it, under `{id}-error`.
pub struct Field<C, N> {
    /// The id of the input.
    pub id: String,
    /// What it shows unless something else is being typed.
    pub text: Signal<String>,
    /// Whether it takes input now.
    pub editable: Signal<bool>,
    /// Whether a minus may be needed: the number pads of phones have none.
    pub signed: bool,
    /// Why the last input was not taken.
    pub error: RwSignal<Option<String>>,
    /// Takes what was typed; the refusal in words.
    pub commit: C,
    /// One step up (1) or down (-1) by arrow key.
    pub nudge: N,
}

impl<C, N> Field<C, N>
where
    C: Fn(String) -> Option<String> + Copy + 'static,
    N: Fn(i32) + Copy + 'static,
{
    /// The input.
    pub fn view(self) -> impl IntoView {
        let Self { id, text, editable, signed, error, commit, nudge } = self;
        let input = NodeRef::<html::Input>::new();
        // What is being typed is left alone, also while the value changes beneath it.
        let typing = RwSignal::new(false);
        Effect::new(move |_| {
            let text = text.get();
            if let Some(input) = input.get()
                && !typing.get()
                && input.value() != text
            {
                input.set_value(&text);
            }
        });
        let take = move || {
            let Some(input) = input.get_untracked() else { return };
            if typing.get_untracked() {
                let refusal = commit(input.value());
                // What was refused stays to be corrected.
                typing.set(refusal.is_some());
                error.set(refusal);
            }
        };
        let keys = move |event: KeyboardEvent| match event.key().as_str() {
            "Enter" => take(),
            "Escape" => {
                error.set(None);
                typing.set(false);
            }
            "ArrowUp" => {
                event.prevent_default();
                take();
                nudge(1);
            }
            "ArrowDown" => {
                event.prevent_default();
                take();
                nudge(-1);
            }
            _ => {}
        };
        view! {
            <input node_ref=input type="text" class="number" id=id.clone() inputmode=if signed { "text" } else { "decimal" }
                autocomplete="off" spellcheck="false" enterkeyhint="done"
                readonly=move || !editable.get()
                aria-invalid=move || error.with(Option::is_some).then_some("true")
                aria-describedby=move || error.with(Option::is_some).then(|| format!("{id}-error"))
                on:input=move |_| typing.set(true)
                on:change=move |_| take()
                on:keydown=keys />
        }
    }
}

/// All parameters.
pub fn view(app: App) -> impl IntoView {
    app.read(|session| session.parameters()).into_iter().map(|first| control(app, first)).collect_view()
}

fn control(app: App, first: ParameterView) -> impl IntoView {
    let words = app.words();
    let index = first.index;
    let now = Memo::new(move |_| {
        app.changes.parameters.track();
        app.read(|session| session.parameter(index))
    });
    let get = move |part: fn(&ParameterView) -> String| now.with(|view| view.as_ref().map(part).unwrap_or_default());
    let error = RwSignal::new(None::<String>);
    let (id, range_id) = (format!("parameter-{index}"), format!("range-{index}"));
    let slide_by = move |by: i32| {
        app.slide(|session| {
            if let Some(slider) = session.parameter(index).and_then(|view| view.slider) {
                session.slide(index, slider.position.saturating_add_signed(by).min(slider.positions));
            }
        });
    };
    let field = Field {
        id: id.clone(),
        text: Signal::derive(move || get(|view| view.text.clone())),
        editable: Signal::derive(|| true),
        signed: first.range.as_ref().is_none_or(|(low, _)| low.starts_with(['-', '−'])),
        error,
        commit: move |text: String| app.attempt(|session| session.set_parameter_text(index, &text)),
        nudge: slide_by,
    };
    let slider = first.slider.map(|slider| {
        let position =
            move || now.with(|view| view.as_ref().and_then(|view| view.slider).map_or(0, |slider| slider.position));
        let label =
            if first.unit.is_empty() { first.label.clone() } else { format!("{} ({})", first.label, first.unit) };
        let page = i32::try_from(slider.page).unwrap_or(1);
        let part = move || format!("--part:{:.2}%", 100.0 * f64::from(position()) / f64::from(slider.positions.max(1)));
        view! {
            <input type="range" id=range_id class="slider" min="0" max=slider.positions.to_string() step="1"
                aria-label=label aria-valuetext=move || get(|view| view.spoken.clone())
                style=part
                prop:value=move || position().to_string()
                on:input=move |event| if let Ok(position) = event_target_value(&event).parse() {
                    error.set(None);
                    app.slide(|session| session.slide(index, position));
                }
                on:keydown=move |event: KeyboardEvent| {
                    let by = match event.key().as_str() { "PageUp" => page, "PageDown" => -page, _ => return };
                    event.prevent_default();
                    slide_by(by);
                } />
        }
    });
    let hint = first.range.as_ref().map(|(low, high)| format!("{low} … {high} {}", first.unit));
    let title = match (hint, first.restarts) {
        (Some(hint), true) => format!("{hint}. {}", words.restarts),
        (Some(hint), false) => hint,
        (None, true) => words.restarts.to_owned(),
        (None, false) => String::new(),
    };
    view! {
        <div class="parameter" class:changed=move || now.with(|view| view.as_ref().is_some_and(|view| !view.is_default))>
            <label for=id.clone() title=title><span>{first.label}</span>{symbol(&first.name)}</label>
            <span class="quantity">{field.view()}<span class="unit">{first.unit}</span></span>
            {slider}
            <p class="refusal" id=format!("{id}-error") role="alert">{move || error.get()}</p>
        </div>
    }
}
