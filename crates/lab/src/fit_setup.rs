//! What a fit is asked for: theory, records, what is varied and what records have in common, the part that counts.

use crate::app::App;
use crate::controls::symbol;
use crate::{browser, library};
use leptos::prelude::*;
use session::{ChoiceView, FitRecordView, KnownView};

/// Why something typed was not taken.
type Refusal = RwSignal<Option<String>>;

/// The setup. It is built anew only where it has changed, so that nobody is interrupted while typing.
pub fn view(app: App, refusal: Refusal) -> AnyView {
    let words = app.words();
    let records = Memo::new(move |_| {
        app.changes.records.track();
        app.changes.fits.track();
        app.read(|session| session.fit_records())
    });
    let choices = Memo::new(move |_| {
        app.changes.parameters.track();
        records.track();
        app.changes.fits.track();
        app.read(|session| session.fit_choices())
    });
    view! {
        <div class="record-head">
            <h3 id="fitting-title">{words.fit_title}</h3>
            {move || records.with(|records| chooser(app, records))}
            <button type="button" class="quiet outlined" id="fit-theory" aria-haspopup="dialog" on:click=move |_| library::choose(app)>{words.fit_theory}</button>
        </div>
        <p class="note">{words.fit_intro}</p>
        {move || records.with(|records| (records.len() > 1).then(|| together(app, records)))}
        {move || choices.with(|choices| vary(app, refusal, choices))}
        {ends(app, refusal)}
    }
    .into_any()
}

/// Which record is looked at.
fn chooser(app: App, records: &[FitRecordView]) -> AnyView {
    let option = |record: &FitRecordView| {
        view! { <option value=record.id.to_string() selected=record.chosen>{record.name.clone()}</option> }.into_any()
    };
    let options: Vec<AnyView> = records.iter().map(option).collect();
    view! {
        <select id="fit-record" aria-label=app.words().fit_record on:change=move |event| {
            if let Ok(id) = event_target_value(&event).parse() {
                app.act(|session| session.choose_record(id));
                browser::focus_later("fit-record".to_owned());
            }
        }>{options}</select>
    }
    .into_any()
}

/// Which records take part.
fn together(app: App, records: &[FitRecordView]) -> AnyView {
    let words = app.words();
    let tick = |record: &FitRecordView| {
        let (id, place) = (record.id, format!("fit-with-{}", record.id));
        let again = place.clone();
        view! {
            <label class="switch">
                <input type="checkbox" id=place disabled=record.chosen prop:checked=record.taking_part on:change=move |event| {
                    let takes_part = event_target_checked(&event);
                    app.act(|session| session.fit_with(id, takes_part));
                    browser::focus_later(again.clone());
                } />
                <span>{record.name.clone()}</span>
            </label>
        }
        .into_any()
    };
    let ticks: Vec<AnyView> = records.iter().map(tick).collect();
    let several = records.iter().filter(|record| record.taking_part).count() > 1;
    view! {
        <fieldset class="choices"><legend>{words.fit_together}</legend>{ticks}</fieldset>
        {several.then(|| view! { <p class="note">{words.fit_same_intro}</p> })}
    }
    .into_any()
}

/// What is varied, and what is one number for all records.
fn vary(app: App, refusal: Refusal, choices: &[ChoiceView]) -> AnyView {
    let several = choices.iter().any(|choice| choice.same.is_some());
    let rows: Vec<AnyView> = choices.iter().map(|choice| row(app, refusal, choice, several)).collect();
    let class = if several { "choices several" } else { "choices" };
    view! { <fieldset class=class><legend>{app.words().fit_vary}</legend>{rows}</fieldset> }.into_any()
}

fn row(app: App, refusal: Refusal, choice: &ChoiceView, several: bool) -> AnyView {
    let (index, id) = (choice.index, format!("vary-{}", choice.index));
    let again = id.clone();
    let symbol = (!choice.name.is_empty()).then(|| symbol(&choice.name));
    let varied = view! {
        <label class="switch">
            <input type="checkbox" id=id prop:checked=choice.varied on:change=move |event| {
                let varied = event_target_checked(&event);
                app.act(|session| session.vary(index, varied));
                browser::focus_later(again.clone());
            } />
            <span>{choice.label.clone()}</span>{symbol}
        </label>
    }
    .into_any();
    if !several {
        return varied;
    }
    let known: Vec<AnyView> = choice.values.iter().map(|known| value(app, refusal, choice, known)).collect();
    let known = (!known.is_empty()).then(|| view! { <div class="known">{known}</div> });
    view! {
        <div class="choice">
            {varied}
            {choice.same.map(|same| common(app, choice, same))}
            {known}
        </div>
    }
    .into_any()
}

/// Whether something is one number for all records.
fn common(app: App, choice: &ChoiceView, same: bool) -> AnyView {
    let words = app.words();
    let (index, id) = (choice.index, format!("same-{}", choice.index));
    let again = id.clone();
    view! {
        <label class="switch same">
            <input type="checkbox" id=id aria-label=format!("{}: {}", choice.label, words.fit_same) prop:checked=same
                on:change=move |event| {
                    let same = event_target_checked(&event);
                    app.act(|session| session.set_same(index, same));
                    browser::focus_later(again.clone());
                } />
            <span>{words.fit_same}</span>
        </label>
    }
    .into_any()
}

/// The field of a value that is known of a record.
fn value(app: App, refusal: Refusal, choice: &ChoiceView, known: &KnownView) -> AnyView {
    let (index, record, id) = (choice.index, known.record, format!("known-{}-{}", choice.index, known.record));
    view! {
        <span class="quantity">
            <label for=id.clone()>{known.name.clone()}</label>
            <input type="text" class="number" id=id aria-label=format!("{}, {}", choice.label, known.name) autocomplete="off"
                spellcheck="false" enterkeyhint="done" prop:value=known.text.clone()
                on:change=move |event| {
                    let typed = event_target_value(&event);
                    refusal.set(app.attempt(|session| session.set_known(index, record, &typed)));
                } />
            <span class="unit">{choice.unit.clone()}</span>
        </span>
    }
    .into_any()
}

/// What part of the records counts.
fn ends(app: App, refusal: Refusal) -> AnyView {
    let words = app.words();
    let [from, until] = app.read(|session| session.fit_window());
    let unit = app.read(|session| session.measurement_units("")[1].clone());
    let end = |(end, (label, value)): (usize, (&'static str, String))| {
        let id = format!("fit-end-{end}");
        view! {
            <span class="quantity">
                <label for=id.clone()>{label}</label>
                <input type="text" class="number" id=id autocomplete="off" spellcheck="false" prop:value=value
                    on:change=move |event| {
                        let typed = event_target_value(&event);
                        refusal.set(app.attempt(|session| session.set_fit_window(end, &typed)));
                    } />
                <span class="unit">{unit.clone()}</span>
            </span>
        }
        .into_any()
    };
    let ends: Vec<AnyView> =
        [(words.fit_from, from), (words.fit_until, until)].into_iter().enumerate().map(end).collect();
    view! { <div class="ends" role="group" aria-label=words.fit_part>{ends}</div> }.into_any()
}
