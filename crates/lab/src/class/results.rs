//! The fitted quantities of all groups, and groups that are stuck.

use super::drawn::look;
use super::empty::nothing;
use super::room::Part;
use super::words;
use crate::app::App;
use class::page;
use class::pooling::Measured;
use class::results::Quantity;
use units::number::{error_with_unit, unit_text};
use view::views::*;
use web_sys::HtmlDetailsElement;

/// Maximum number of results in a table; the report has all.
const MOST_ROWS: usize = 100;

/// The section: a fold for each quantity, the first open.
pub fn view(app: App) -> View {
    changing(move || {
        let quantities = app.class.read_quantities(Part::Results, <[Quantity]>::to_vec);
        if quantities.is_empty() {
            return nothing(app);
        }
        each(quantities.into_iter().enumerate(), |(number, quantity)| fold(app, quantity, number))
    })
}

/// A quantity; its figure and table are built when it is opened.
fn fold(app: App, quantity: Quantity, number: usize) -> HtmlDetails {
    let open = create_signal(number == 0);
    let title = title(app, &quantity);
    let mut details = details();
    let node: HtmlDetailsElement = details.node();
    let content = move || {
        if !open.get() {
            return View::new();
        }
        let html = app.class.read_once(|collection| page::quantity(&quantity, collection, MOST_ROWS, look(app)));
        div().class("class-report").inner_html(html).into()
    };
    details
        .class("class-fold")
        .open(number == 0)
        .when(events::toggle, move |_| open.set(node.open()))
        .child(summary().id(format!("class-result-{number}")).child(title))
        .child(changing(content))
}

/// Theory, quantity, and the pooled value without results far from the others.
fn title(app: App, quantity: &Quantity) -> String {
    let name = format!("{}: {}", quantity.theory, quantity.name);
    let Ok(pool) = &quantity.pool else { return name };
    let pooled = pool.without.as_ref().unwrap_or(&pool.all);
    let measured = Measured { value: pooled.value, error: pooled.error };
    let value = page::result_text(quantity, measured, app.language.get_untracked());
    format!("{name} = {}, n = {}", error_with_unit(&value, &unit_text(&quantity.unit)), pooled.count)
}

/// List of the groups that are stuck.
pub fn stuck(app: App) -> View {
    let language = app.language.get_untracked();
    let list = move || {
        let html = app.class.read_quantities(Part::Stuck, |quantities| {
            app.class.read_once(|collection| page::stuck(collection, quantities, language))
        });
        div().class("class-report").inner_html(html)
    };
    View::from((note(words::of(app).stuck_rules), changing(list)))
}
