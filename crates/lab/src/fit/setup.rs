//! Settings of a fit: records, varied parameters, parameters common to all records, and the selected part of the time
//! axis.

use crate::app::App;
use desk::{ChoiceView, FitRecordView, Fits, KnownView, measurement_units};
use view::browser;
use view::pieces::symbols::symbol;
use view::views::*;

/// Reason why typed text was refused.
type Refusal = Signal<Option<String>>;

/// Parameters that can be varied, with their present settings.
type Choices = ReadSignal<Vec<ChoiceView>>;

/// The records that are fitted together, and the selected part of the time axis.
pub fn record(app: App, refusal: Refusal) -> View {
    let records = records(app);
    View::from((
        div().class("step-line").child(ends(app, refusal)),
        changing(move || together(app, records.get_clone())),
    ))
}

/// Choice of the record shown.
pub fn chooser(app: App) -> View {
    let records = records(app);
    changing(move || choice(app, records.get_clone()))
}

fn records(app: App) -> ReadSignal<Vec<FitRecordView>> {
    memo(move || {
        app.records.track();
        app.fits.track();
        app.read_desk(|desk| desk.fits().records())
    })
}

/// Varied parameters. Rebuilt only when the rows change, so that typing is not interrupted.
pub fn varied(app: App, refusal: Refusal) -> View {
    let choices = memo(move || {
        app.changes.parameters.track();
        app.records.track();
        app.fits.track();
        app.read_desk(|desk| desk.fits().choices())
    });
    // Without the known values, which the user may be typing.
    let rows = memo(move || {
        let mut rows = choices.get_clone();
        rows.iter_mut().flat_map(|row| &mut row.values).for_each(|known| known.text.clear());
        rows
    });
    changing(move || vary(app, refusal, choices, rows.get_clone()))
}

/// Settings that are seldom changed.
pub fn options(app: App) -> HtmlDetails {
    details().class("options").child(summary().child(app.words().fit_options)).child(loss(app))
}

/// Choice of the loss function of residuals.
fn loss(app: App) -> HtmlDiv {
    let words = app.words();
    let (names, chosen) = app.read_desk(|desk| desk.fits().losses());
    let choose = move |event| {
        if let Ok(place) = value_of(&event).parse() {
            app.act_on_desk(|desk| desk.change_fits(|fits, _| fits.set_loss(place)));
        }
    };
    let options = names.into_iter().enumerate();
    let choice = select()
        .id("fit-loss")
        .attr("aria-describedby", "fit-loss-note")
        .when(events::change, choose)
        .each(options, |(place, name)| option().value(place.to_string()).selected(place == chosen).child(name));
    div()
        .class("ends")
        .child(field_of("fit-loss", words.fit_loss).child(choice))
        .child(note(words.fit_loss_note).id("fit-loss-note"))
}

fn choice(app: App, records: Vec<FitRecordView>) -> HtmlSelect {
    let choose = move |event| {
        if let Ok(id) = value_of(&event).parse() {
            app.act_on_desk(|desk| desk.choose_record(id));
            browser::focus_later("fit-record".to_owned());
        }
    };
    select()
        .id("fit-record")
        .when(events::change, choose)
        .each(records, |record| option().value(record.id.to_string()).selected(record.chosen).child(record.name))
}

/// Check boxes for the records that take part; empty if there is only one record.
fn together(app: App, records: Vec<FitRecordView>) -> View {
    if records.len() < 2 {
        return View::new();
    }
    let words = app.words();
    let several = records.iter().filter(|record| record.taking_part).count() > 1;
    let record = |record: FitRecordView| {
        let (id, place) = (record.id, format!("fit-with-{}", record.id));
        let tick = tick(place, record.taking_part, move |takes_part| {
            app.act_on_desk(|desk| desk.change_fits(|fits, _| fits.include(id, takes_part)))
        });
        switch(tick.disabled(record.chosen), record.name)
    };
    View::from((
        fieldset().class("choices").child(legend().child(words.fit_together)).each(records, record),
        View::from(several.then(|| note(words.fit_same_intro).into())),
    ))
}

/// Varied parameters, with check boxes for those common to all records.
fn vary(app: App, refusal: Refusal, choices: Choices, rows: Vec<ChoiceView>) -> HtmlFieldset {
    let several = rows.iter().any(|choice| choice.same.is_some());
    let class = if several { "choices several" } else { "choices" };
    let legend = legend().child(app.words().fit_vary);
    fieldset().class(class).child(legend).each(rows, |choice| row(app, refusal, choices, choice, several))
}

fn row(app: App, refusal: Refusal, choices: Choices, choice: ChoiceView, several: bool) -> View {
    let index = choice.index;
    let tick = tick(format!("vary-{index}"), choice.varied, move |varied| {
        app.act_on_desk(|desk| desk.change_fits(|fits, data| fits.vary(data.play(), index, varied)))
    });
    let varied = switch(tick, choice.label.clone()).maybe((!choice.name.is_empty()).then(|| symbol(&choice.name)));
    if !several {
        return varied.into();
    }
    let known = |known: &KnownView| value(app, refusal, choices, &choice, known);
    let known = (!choice.values.is_empty()).then(|| div().class("known").each(&choice.values, known));
    let same = choice.same.map(|same| common(app, &choice, same));
    div().class("varied").child(varied).maybe(same).maybe(known).into()
}

/// Check box: the parameter is common to all records.
fn common(app: App, choice: &ChoiceView, same: bool) -> HtmlLabel {
    let words = app.words();
    let index = choice.index;
    let tick = tick(format!("same-{index}"), same, move |same| {
        app.act_on_desk(|desk| desk.change_fits(|fits, data| fits.set_same(data.play(), index, same)))
    });
    let tick = tick.attr("aria-label", format!("{}: {}", choice.label, words.fit_same));
    label().class("switch same").child(tick).child(span().child(words.fit_same))
}

/// Field of a parameter value known for a record.
fn value(app: App, refusal: Refusal, choices: Choices, choice: &ChoiceView, known: &KnownView) -> HtmlSpan {
    let (index, record, id) = (choice.index, known.record, format!("known-{}-{}", choice.index, known.record));
    let text = memo(move || {
        choices.with(|choices| {
            let values = choices.iter().filter(|choice| choice.index == index).flat_map(|choice| &choice.values);
            values.filter(|known| known.record == record).map(|known| known.text.clone()).collect::<String>()
        })
    });
    let take = move |event| {
        let typed = value_of(&event);
        refusal.set(app.attempt_on_desk(|desk| {
            desk.change_records(|records, open| records.set_known(open, index, record, &typed))
        }));
    };
    let field = short_field(id.clone())
        .attr("aria-label", format!("{}, {}", choice.label, known.name))
        .enterkeyhint("done")
        .prop("value", text)
        .when(events::change, take);
    field_of(id, known.name.clone()).child(field).child(unit_of(choice.unit.clone()))
}

/// Fields for begin and end of the selected part.
fn ends(app: App, refusal: Refusal) -> HtmlDiv {
    let words = app.words();
    let window = memo(move || {
        app.fits.track();
        app.read_desk(|desk| desk.fits().window())
    });
    let unit = app.read_desk(|desk| measurement_units(desk.play(), "")[1].clone());
    let end = |(end, name): (usize, &'static str)| {
        let value = move || window.with(|window| window.get(end).cloned().unwrap_or_default());
        let id = format!("fit-end-{end}");
        let take = move |event| {
            let typed = value_of(&event);
            refusal.set(
                app.attempt_on_desk(|desk| desk.change_fits(|fits, data| fits.set_window(data.play(), end, &typed))),
            );
        };
        field_of(id.clone(), name)
            .child(short_field(id).prop("value", value).when(events::change, take))
            .child(unit_of(unit.clone()))
    };
    let zoomed = memo(move || {
        app.changes.plots.track();
        app.read_desk(|desk| desk.fits().has_part_in_plot())
    });
    let take = move |_| app.act_on_desk(|desk| desk.change_fits(Fits::take_part_in_plot));
    let from_plot = button()
        .class("quiet")
        .id("fit-part-in-plot")
        .hidden(move || !zoomed.get())
        .when(events::click, take)
        .child(words.fit_part_in_plot);
    let ends = [words.fit_from, words.fit_until].into_iter().enumerate();
    div().class("ends").role("group").attr("aria-label", words.fit_part).each(ends, end).child(from_plot)
}
