//! Controls of parameters: name, slider, number field with unit.

use crate::app::App;
use crate::controls::choices;
use crate::pieces::symbols::name_and_symbol;
use crate::views::*;
use play::ParameterView;
use std::rc::Rc;
use web_sys::{HtmlInputElement, KeyboardEvent};

/// Accepts typed text. Returns the reason if it is refused.
pub type Commit = Box<dyn Fn(&str) -> Option<String>>;

/// A number field. The caller shows the error below it, under the id `{id}-error`.
pub struct Field {
    /// Id of the input.
    pub id: String,
    /// Text shown while nothing is being typed.
    pub text: ReadSignal<String>,
    /// True if it accepts input now.
    pub editable: ReadSignal<bool>,
    /// True if a minus sign may be needed: the number pads of phones have none.
    pub signed: bool,
    /// Reason why the last input was refused.
    pub error: Signal<Option<String>>,
    /// Accepts typed text. Returns the reason if it is refused.
    pub commit: Commit,
    /// One step up (1) or down (-1) by arrow key.
    pub nudge: Box<dyn Fn(i32)>,
}

impl Field {
    /// The input element.
    pub fn view(self) -> HtmlInput {
        let Self { id, text, editable, signed, error, commit, nudge } = self;
        let mut input = short_field(id.clone());
        let node: HtmlInputElement = input.node();
        // Text being typed stays, even if the value changes meanwhile.
        let typing = create_signal(false);
        let shown = node.clone();
        effect(move || {
            let text = text.get_clone();
            if !typing.get() && shown.value() != text {
                shown.set_value(&text);
            }
        });
        let take = Rc::new(move || {
            if typing.get_untracked() {
                let refusal = commit(&node.value());
                // Refused input stays, to be corrected.
                typing.set(refusal.is_some());
                error.set(refusal);
            }
        });
        let again = take.clone();
        let keys = move |event: KeyboardEvent| match event.key().as_str() {
            "Enter" => again(),
            "Escape" => {
                error.set(None);
                typing.set(false);
            }
            "ArrowUp" => {
                event.prevent_default();
                again();
                nudge(1);
            }
            "ArrowDown" => {
                event.prevent_default();
                again();
                nudge(-1);
            }
            _ => {}
        };
        let refused = move || error.with(Option::is_some);
        input
            .inputmode(if signed { "text" } else { "decimal" })
            .enterkeyhint("done")
            .readonly(move || !editable.get())
            .attr("aria-invalid", move || refused().then_some("true"))
            .attr("aria-describedby", move || refused().then(|| format!("{id}-error")))
            .when(events::input, move |_| typing.set(true))
            .when(events::change, move |_| take())
            .when(events::keydown, keys)
    }
}

/// Control of a parameter.
pub fn control(app: App, first: ParameterView) -> HtmlDiv {
    if first.choices.is_empty() { number(app, first) } else { choices::control(app, first) }
}

/// Slider and field of a number.
fn number(app: App, first: ParameterView) -> HtmlDiv {
    let words = app.words();
    let index = first.index;
    let now = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.basis().parameter(play.course(), index))
    });
    let get = move |part: fn(&ParameterView) -> String| now.with(|view| view.as_ref().map(part).unwrap_or_default());
    let error = create_signal(None::<String>);
    let (id, range_id) = (format!("parameter-{index}"), format!("range-{index}"));
    let slide_by = move |by: i32| {
        app.slide(|play| {
            if let Some(slider) = play.basis().parameter(play.course(), index).and_then(|view| view.slider) {
                play.change_settings(|settings| {
                    settings.slide(index, slider.position.saturating_add_signed(by).min(slider.positions))
                });
            }
        });
    };
    let field = Field {
        id: id.clone(),
        text: memo(move || get(|view| view.text.clone())),
        editable: memo(|| true),
        signed: first.range.as_ref().is_none_or(|(low, _)| low.starts_with(['-', '−'])),
        error,
        commit: Box::new(move |text| {
            app.attempt(|play| play.change_settings(|settings| settings.set_parameter_text(index, text)))
        }),
        nudge: Box::new(slide_by),
    };
    let slider = first.slider.map(|slider| {
        let position =
            move || now.with(|view| view.as_ref().and_then(|view| view.slider).map_or(0, |slider| slider.position));
        let label =
            if first.unit.is_empty() { first.label.clone() } else { format!("{} ({})", first.label, first.unit) };
        let page = i32::try_from(slider.page).unwrap_or(1);
        let part = move || format!("--part:{:.2}%", 100.0 * f64::from(position()) / f64::from(slider.positions.max(1)));
        input()
            .r#type("range")
            .id(range_id)
            .class("slider")
            .min("0")
            .max(slider.positions.to_string())
            .step("1")
            .attr("aria-label", label)
            .attr("aria-valuetext", move || get(|view| view.spoken.clone()))
            .style(part)
            .prop("value", move || position().to_string())
            .when(events::input, move |event| {
                if let Ok(position) = value_of(&event).parse() {
                    error.set(None);
                    app.slide(|play| play.change_settings(|settings| settings.slide(index, position)));
                }
            })
            .when(events::keydown, move |event: KeyboardEvent| {
                let by = match event.key().as_str() {
                    "PageUp" => page,
                    "PageDown" => -page,
                    _ => return,
                };
                event.prevent_default();
                slide_by(by);
            })
    });
    let hint = first.range.as_ref().map(|(low, high)| format!("{low} … {high} {}", first.unit));
    let title = match (hint, first.restarts) {
        (Some(hint), true) => format!("{hint}. {}", words.restarts),
        (Some(hint), false) => hint,
        (None, true) => words.restarts.to_owned(),
        (None, false) => String::new(),
    };
    // Beside a slider the number is read more often than it is typed.
    let value: View = match slider {
        Some(_) => {
            let reading = text(move || get(|view| view.text.clone()));
            let reading = span().class("reading").attr("aria-hidden", "true").child(reading);
            span().class("editing").child(reading).child(field.view()).into()
        }
        None => field.view().into(),
    };
    let slides = if slider.is_some() { " with-slider" } else { "" };
    let changed = move || now.with(|view| view.as_ref().is_some_and(|view| !view.is_default));
    div()
        .class(move || format!("parameter{slides}{}", if changed() { " changed" } else { "" }))
        .child(label().r#for(id.clone()).title(title).child(name_and_symbol(&first.label, &first.name)))
        .child(span().class("quantity").child(value).child(unit_of(first.unit)))
        .maybe(slider)
        .child(refusal_of(error).id(format!("{id}-error")))
}
