//! Form for computing velocity and acceleration from a column of a record: column and method.

use crate::app::App;
use crate::measuring::intake;
use desk::number::typed::whole;
use desk::{ColumnView, Differentiation, RecordView, WIDEST};
use units::Language;
use view::browser;
use view::views::*;
use web_sys::HtmlDetailsElement;

/// Least and greatest number of rows of a smoothing polynomial that can be typed.
const ROWS: [i64; 2] = [3, WIDEST as i64];
/// Least and greatest degree of a smoothing polynomial.
const DEGREES: [i64; 2] = [2, 7];

/// The last selection, shared by all records, as long as the page is open.
#[derive(Clone, Copy)]
pub struct Choice {
    /// Ids of the records whose form is open.
    open: Signal<Vec<u32>>,
    smooth: Signal<bool>,
    window: Signal<String>,
    degree: Signal<String>,
    window_refused: Signal<Option<String>>,
    degree_refused: Signal<Option<String>>,
}

impl Choice {
    /// Initial selection.
    pub fn new() -> Self {
        Self {
            open: create_signal(Vec::new()),
            smooth: create_signal(false),
            window: create_signal("9".to_owned()),
            degree: create_signal("3".to_owned()),
            window_refused: create_signal(None),
            degree_refused: create_signal(None),
        }
    }

    /// The chosen method; `None` if a number is refused, which is then shown at its field.
    fn method(self, language: Language) -> Option<Differentiation> {
        if !self.smooth.get_untracked() {
            return Some(Differentiation::Central);
        }
        let number = |[least, most]: [i64; 2], text: Signal<String>, refused: Signal<Option<String>>| {
            let read = text.with_untracked(|text| whole(text, least..=most, language.style()));
            refused.set(read.as_ref().err().map(|why| why.words().text(language).into_owned()));
            usize::try_from(read.ok()?).ok()
        };
        let window = number(ROWS, self.window, self.window_refused);
        let degree = number(DEGREES, self.degree, self.degree_refused);
        Some(Differentiation::Smooth { window: window?, degree: degree? })
    }
}

/// The form, initially closed; empty if no column can be differentiated.
pub fn view(app: App, record: &RecordView, choice: Choice) -> View {
    let words = app.words();
    let id = record.id;
    let columns: Vec<_> = record.columns.iter().filter(|column| column.differentiable).collect();
    let Some(first) = columns.first().map(|column| column.index) else { return View::new() };
    let any_made = record.columns.iter().any(|column| !column.made.is_empty());
    let of = columns.iter().find(|column| column.fitted).map_or(first, |column| column.index);
    let column = create_signal(of);
    let choose = |column: &ColumnView| {
        option().value(column.index.to_string()).selected(column.index == of).child(column.head.clone())
    };
    let place = format!("derive-{id}");
    let again = place.clone();
    let make = move |_| {
        let Some(method) = choice.method(app.language.get_untracked()) else { return };
        let refusal = app.attempt_on_desk(|desk| {
            desk.change_records(|records, open| records.make_derivatives(open, id, column.get_untracked(), method))
        });
        intake::refuse(app, refusal);
        browser::focus_later(again.clone());
    };
    let forget_focus = place.clone();
    let mut details = details();
    let node: HtmlDetailsElement = details.node();
    let toggled = move |_| {
        let now = node.open();
        choice.open.update(|open| {
            open.retain(|other| *other != id);
            if now {
                open.push(id)
            }
        });
    };
    let forget = move |_| {
        app.act_on_desk(|desk| desk.change_records(|records, _| records.forget_derivatives(id)));
        browser::focus_later(forget_focus.clone());
    };
    let of_what = select()
        .id(format!("derive-of-{id}"))
        .when(events::change, move |event| column.set(value_of(&event).parse().unwrap_or(of)))
        .each(columns, choose);
    let smooth = choice.smooth.get_untracked();
    let how = select()
        .id(format!("derive-how-{id}"))
        .when(events::change, move |event| choice.smooth.set(value_of(&event) == "smooth"))
        .child(option().value("central").selected(!smooth).child(words.derivatives_central))
        .child(option().value("smooth").selected(smooth).child(words.derivatives_smooth));
    let form = div()
        .class("looking")
        .child(field_of(format!("derive-of-{id}"), words.derivatives_of).child(of_what))
        .child(field_of(format!("derive-how-{id}"), words.derivatives_method).child(how))
        .child(changing(move || if choice.smooth.get() { polynomial(app, id, choice) } else { View::new() }))
        .child(button().class("quiet outlined").id(place).when(events::click, make).child(words.derivatives_make))
        .maybe(any_made.then(|| button().class("quiet").when(events::click, forget).child(words.derivatives_forget)));
    details
        .class("derivatives")
        .open(choice.open.with_untracked(|open| open.contains(&id)))
        .when(events::toggle, toggled)
        .child(summary().id(format!("derivatives-{id}")).child(words.derivatives_title))
        .child(note(words.derivatives_intro))
        .child(form)
        .into()
}

/// Fields for the number of rows and the degree of the smoothing polynomials.
fn polynomial(app: App, id: u32, choice: Choice) -> View {
    let words = app.words();
    let field = move |part: &str, name: &'static str, text: Signal<String>, refused: Signal<Option<String>>| {
        let id = format!("derive-{part}-{id}");
        let input = number_field(id.clone(), refused)
            .inputmode("numeric")
            .prop("value", text.get_clone_untracked())
            .when(events::input, move |event| text.set(value_of(&event)));
        View::from((field_of(id.clone(), name).child(input), why_refused(&id, refused)))
    };
    View::from((
        field("rows", words.derivatives_rows, choice.window, choice.window_refused),
        field("degree", words.derivatives_degree, choice.degree, choice.degree_refused),
    ))
}
