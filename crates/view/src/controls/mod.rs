//! Controls: parameters, presets, state, method and step.

mod buttons;
mod choices;
pub(crate) mod member;
mod parameters;
mod seat;
mod sizes;

use crate::app::App;
use crate::browser;
use crate::pieces::followed::followed;
use crate::pieces::symbols::name_and_symbol;
use crate::pieces::toolbar::Toolbar;
use crate::views::*;
use crate::{page::everything, scene::drawings};
use play::{MethodView, ParameterGroup, Play, PresetGroup, PresetView, StateView};
use web_sys::HtmlDetailsElement;

/// Maximum number of parameters in sight without *More*.
const MAIN: usize = 3;

/// The card with the main parameters and the first group of presets.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let parameters = div()
        .class("block")
        .child(div().class("block-head").child(h3().child(words.parameters)).child(restore_button(app)))
        .each(app.read(|play| play.basis().sizes()), |size| sizes::control(app, size))
        .each(main_groups(app).into_iter().enumerate(), |group| parameter_group(app, "main-group", group));
    let controls = part("controls", "controls card", words.controls).child(buttons::view(app));
    let values = View::from((parameters, drawings::view(app), presets(app, false)));
    controls.child(seat::view(app)).child(lockable(app, values))
}

/// Indices of the parameters in sight without *More*.
fn main_parameters(app: App) -> Vec<usize> {
    let mut main = app.read(|play| play.program().main_parameters());
    main.truncate(MAIN);
    main
}

/// The main parameters under the headings of the document. Without headings if the document names them in another order.
fn main_groups(app: App) -> Vec<ParameterGroup> {
    let main = main_parameters(app);
    let groups = groups_of(app, |index| main.contains(&index));
    let in_order = groups.iter().flat_map(|group| &group.parameters).map(|parameter| parameter.index);
    if in_order.eq(main.iter().copied()) {
        return groups;
    }
    let named = |play: &mut Play| {
        main.iter().filter_map(|index| play.basis().parameter(play.course(), *index)).collect::<Vec<_>>()
    };
    vec![ParameterGroup { name: String::new(), parameters: app.read(named) }]
}

/// The groups of the parameters whose index is `wanted`; none is empty.
fn groups_of(app: App, wanted: impl Fn(usize) -> bool) -> Vec<ParameterGroup> {
    let mut groups = app.read(|play| play.basis().parameter_groups(play.course()));
    for group in &mut groups {
        group.parameters.retain(|parameter| wanted(parameter.index));
    }
    groups.retain(|group| !group.parameters.is_empty());
    groups
}

/// Number of parameters that are not in sight without *More*.
pub fn further_count(app: App) -> usize {
    let main = main_parameters(app);
    groups_of(app, |index| !main.contains(&index)).iter().map(|group| group.parameters.len()).sum()
}

/// The card with the parameters and presets that are not in sight without *More*; empty if there are none.
pub fn further(app: App) -> View {
    let main = main_parameters(app);
    let groups = groups_of(app, |index| !main.contains(&index));
    let has_presets = app.read(|play| play.controls().presets(play.basis(), play.course()).len() > 1);
    if groups.is_empty() && !has_presets {
        return View::new();
    }
    let words = app.words();
    let parameters = (!groups.is_empty()).then(|| {
        div()
            .class("block")
            .child(div().class("block-head").child(h3().child(words.further_parameters)))
            .each(groups.into_iter().enumerate(), |group| parameter_group(app, "parameter-group", group))
    });
    let content = View::from((parameters.map(View::from), presets(app, true)));
    part("further", "controls card", words.further_parameters).child(lockable(app, content)).into()
}

/// Button that restores the values of the document. Hidden while they are set.
fn restore_button(app: App) -> HtmlButton {
    let words = app.words();
    let is_as_written = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.time_line().is_as_written(play.basis()))
    });
    button()
        .class("quiet")
        .id("restore-defaults")
        .title(words.restore_defaults_title)
        .hidden(move || is_as_written.get())
        .when(events::click, move |_| restore_all(app))
        .child(words.restore_defaults)
}

/// Controls of a parameter group under its heading, whose id is `id` and the number.
fn parameter_group(app: App, id: &str, (number, group): (usize, ParameterGroup)) -> View {
    let control = |first| parameters::control(app, first);
    if group.name.is_empty() {
        return each(group.parameters, control);
    }
    headed("parameter-group", format!("{id}-{number}"), group.name).each(group.parameters, control).into()
}

/// A group with a heading of this id.
fn headed(class: &'static str, id: String, name: String) -> HtmlDiv {
    div().class(class).role("group").attr("aria-labelledby", id.clone()).child(h4().id(id).child(name))
}

/// Disables controls in a page with locked values. The document's buttons stay enabled, because they change only the
/// run.
pub fn lockable(app: App, controls: View) -> View {
    if app.host().embedding().locked {
        fieldset().class("locked").attr("disabled", "").child(controls).into()
    } else {
        controls
    }
}

/// Resets all values to those of the document. Sizes come first: the defaults of the others belong to the model that
/// the sizes determine.
fn restore_all(app: App) {
    let resized = sizes::restore(app);
    app.act(|play| play.change_settings(|settings| settings.restore_defaults()));
    if resized {
        app.rebuild();
    }
    // The button is hidden now.
    browser::focus("panel-explore");
}

/// Present state and, with everything shown, method and step: changed less often than parameters.
pub fn state_and_method(app: App) -> HtmlSection {
    let settings = part("settings", "controls card", app.words().settings).child(states(app));
    // A model with a counter as independent variable needs no method.
    if app.read(|play| play.model().independent.counts) {
        settings
    } else {
        settings.child(everything::only(app, Box::new(move || numerics(app).into())))
    }
}

/// The first group of presets, or the `further` ones.
fn presets(app: App, further: bool) -> View {
    let words = app.words();
    let now = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.controls().presets(play.basis(), play.course()))
    });
    let groups = now.get_clone_untracked().into_iter().enumerate();
    let mut groups = groups.filter(|(number, _)| (*number > 0) == further).peekable();
    if groups.peek().is_none() {
        return View::new();
    }
    let selected = move |index: usize| {
        now.with(|groups| {
            groups.iter().flat_map(|group| &group.presets).any(|preset| preset.index == index && preset.selected)
        })
    };
    let refusal = create_signal(None::<String>);
    let apply = move |index: usize| {
        refusal.set(app.attempt(|play| play.change_settings(|settings| settings.apply_preset(index))))
    };
    let choose = |bar: Toolbar, (place, preset): (usize, PresetView)| {
        let index = preset.index;
        button()
            .class("chip")
            .title(preset.description)
            .tabindex(move || bar.stop(place))
            .when(events::focus, move |_| bar.enter(place))
            .attr("aria-pressed", move || selected(index).to_string())
            .when(events::click, move |_| apply(index))
            .child(preset.name)
    };
    let group = |(number, group): (usize, PresetGroup)| -> View {
        let id = format!("presets-{number}");
        let name = if group.name.is_empty() { words.presets.to_owned() } else { group.name };
        if group.presets.len() <= choices::CHIPS {
            let bar = Toolbar::new();
            let chips = div().class("chips").role("toolbar").attr("aria-labelledby", id.clone());
            let chips = chips.when(events::keydown, Toolbar::turn);
            let chips = chips.each(group.presets.into_iter().enumerate(), |preset| choose(bar, preset));
            return headed("preset-group", id, name).child(chips).into();
        }
        let indices: Vec<usize> = group.presets.iter().map(|preset| preset.index).collect();
        let now = move || indices.iter().find(|index| selected(**index)).map(usize::to_string).unwrap_or_default();
        let none = option().value("").disabled(true).child(words.choose);
        let choices = group
            .presets
            .into_iter()
            .map(|preset| option().value(preset.index.to_string()).title(preset.description).child(preset.name));
        let choose = select().id(id.clone()).child(none).each(choices, |choice| choice).prop("value", now).when(
            events::change,
            move |event| {
                if let Ok(index) = value_of(&event).parse() {
                    apply(index);
                }
            },
        );
        div().class("parameter preset-choice").child(label().r#for(id).child(span().child(name))).child(choose).into()
    };
    div()
        .class("block presets")
        .child(h3().class("visually-hidden").child(words.presets))
        .each(groups, group)
        .child(refusal_of(refusal))
        .into()
}

/// Fields of the state, editable while the run is paused.
fn states(app: App) -> View {
    let words = app.words();
    let states = app.read(|play| play.values().state_lines());
    if states.is_empty() {
        return View::new();
    }
    let mut block = div().class("block");
    let now = followed(app, &block.node(), |play| play.values().state_lines());
    let field = |(line, state): (usize, StateView)| {
        let id = format!("state-{line}");
        let view = move || now.with(|states| states.get(line).cloned());
        // For a family, the index of the selected member.
        let index = move || view().map_or(state.index, |state| state.index);
        let error = create_signal(None::<String>);
        let field = parameters::Field {
            id: id.clone(),
            text: memo(move || view().map(|state| state.text).unwrap_or_default()),
            editable: memo(move || view().is_some_and(|state| state.editable)),
            signed: true,
            error,
            commit: Box::new(move |text| {
                app.attempt(|play| play.change_settings(|settings| settings.set_state_text(index(), text)))
            }),
            nudge: Box::new(|_| ()),
        };
        let name = label().r#for(id.clone()).child(name_and_symbol(&state.label, &state.name));
        let shown = move || view().and_then(|state| state.members);
        let picker = state.members.map(|members| member::pickers(app, &state.label, members, shown));
        div()
            .class("parameter")
            .child(span().class("name").child(name).maybe(picker))
            .child(with_unit(field.view(), text(move || view().map(|state| state.unit).unwrap_or_default())))
            .child(refusal_of(error).id(format!("{id}-error")))
    };
    let hint = move || {
        app.changes.parameters.track();
        let by_hand = app.read(|play| play.course().is_started_by_hand());
        (if by_hand { words.started_by_hand } else { words.state_hint }).to_owned()
    };
    block
        .child(div().class("block-head").child(h3().child(words.state)))
        .each(states.into_iter().enumerate(), field)
        .child(note(text(hint)))
        .into()
}

/// Method and step.
fn numerics(app: App) -> HtmlDetails {
    let words = app.words();
    let refusal = create_signal(None::<String>);
    let error = create_signal(None::<String>);
    let chosen = move |name: &'static str| {
        app.changes.parameters.track();
        app.read(|play| play.basis().methods(play.course()).iter().any(|method| method.name == name && method.selected))
    };
    let method = |method: MethodView| {
        option()
            .value(method.name)
            .disabled(!method.refused.is_empty())
            .title(method.refused)
            .selected(move || chosen(method.name))
            .child(method.label)
    };
    let step = move || {
        app.changes.parameters.track();
        app.read(|play| play.basis().step_text(play.course()))
    };
    let field = parameters::Field {
        id: "step-size".to_owned(),
        text: memo(move || step().0),
        editable: memo(|| true),
        signed: false,
        error,
        commit: Box::new(move |text| app.attempt(|play| play.change_settings(|settings| settings.set_step_text(text)))),
        nudge: Box::new(|_| ()),
    };
    let now = move || {
        app.changes.parameters.track();
        app.read(|play| {
            play.basis().methods(play.course()).iter().find(|method| method.selected).map_or("", |method| method.name)
        })
    };
    // After a selection by the reader, only the property changes the value shown; the attribute of an option does not.
    let choose = select()
        .id("method")
        .prop("value", now)
        .when(events::change, move |event| {
            let name = value_of(&event);
            refusal.set(app.attempt(|play| play.change_settings(|settings| settings.set_method(&name))));
        })
        .each(app.read(|play| play.basis().methods(play.course())), method);
    let method = div()
        .class("parameter")
        .child(label().r#for("method").child(span().child(words.method)))
        .child(choose)
        .child(refusal_of(refusal));
    let unit = unit_of(text(move || step().1));
    let step = div()
        .class("parameter")
        .child(label().r#for("step-size").child(span().child(words.step)))
        .child(span().class("quantity").child(field.view()).child(unit))
        .child(refusal_of(error).id("step-size-error"));
    let summary = summary().child(h3().child(words.numerics));
    let mut details = details();
    let node: HtmlDetailsElement = details.node();
    // They stay open when the page is rebuilt in another language.
    details
        .class("block numerics")
        .open(app.numerics_open.get_untracked())
        .when(events::toggle, move |_| app.numerics_open.set(node.open()))
        .child(summary)
        .child(method)
        .child(step)
}
