//! Controls for switches (check box) and choices: chips, or a drop-down list where there are many.

use crate::app::App;
use crate::pieces::symbols::name_and_symbol;
use crate::pieces::toolbar::Toolbar;
use crate::views::*;
use play::{ChoiceView, ParameterView};

/// Maximum number of choices or presets with a chip each. More are offered as a list.
pub const CHIPS: usize = 5;

/// Control of a switch or a choice.
pub fn control(app: App, first: ParameterView) -> HtmlDiv {
    let index = first.index;
    let now = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.basis().parameter(play.course(), index))
    });
    let value = move || now.with(|view| view.as_ref().map_or(0.0, |view| view.value));
    let error = create_signal(None::<String>);
    let set = move |value: f64| {
        error.set(app.attempt(|play| play.change_settings(|settings| settings.set_parameter(index, value))))
    };
    let id = format!("parameter-{index}");
    let title = if first.restarts { app.words().restarts } else { "" };
    let changed = move || now.with(|view| view.as_ref().is_some_and(|view| !view.is_default));
    let row = move |kind: &'static str| format!("parameter {kind}{}", if changed() { " changed" } else { "" });
    let name = label().r#for(id.clone()).title(title).child(name_and_symbol(&first.label, &first.name));
    let refusal = refusal_of(error).id(format!("{id}-error"));
    if first.is_switch {
        let tick = input()
            .r#type("checkbox")
            .id(id)
            .prop("checked", move || value() != 0.0)
            .when(events::change, move |event| set(f64::from(u8::from(is_checked(&event)))));
        return div().class(move || row("on-off")).child(name).child(tick).child(refusal);
    }
    if first.choices.len() <= CHIPS {
        let bar = Toolbar::new();
        let name_id = format!("{id}-name");
        let chip = |(place, choice): (usize, ChoiceView)| {
            button()
                .class("chip")
                .tabindex(move || bar.stop(place))
                .when(events::focus, move |_| bar.enter(place))
                .attr("aria-pressed", move || (value() == choice.value).to_string())
                .when(events::click, move |_| set(choice.value))
                .child(choice.text)
        };
        let chips = div().class("chips").role("toolbar").id(id).attr("aria-labelledby", name_id.clone());
        let chips = chips.when(events::keydown, Toolbar::turn).each(first.choices.into_iter().enumerate(), chip);
        let name = span().class("name").id(name_id).title(title).child(name_and_symbol(&first.label, &first.name));
        return div().class(move || row("chosen")).child(name).child(chips).child(refusal);
    }
    let alternative = |choice: ChoiceView| {
        option().value(choice.value.to_string()).selected(move || value() == choice.value).child(choice.text)
    };
    // After a selection by the reader, only the property changes the value shown; the attribute of an option does not.
    let choose = select()
        .id(id)
        .prop("value", move || value().to_string())
        .when(events::change, move |event| {
            if let Some(value) = units::number::decimal(&value_of(&event)) {
                set(value);
            }
        })
        .each(first.choices, alternative);
    div().class(move || row("choice")).child(name).child(choose).child(refusal)
}
