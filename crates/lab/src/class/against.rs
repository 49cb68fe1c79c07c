//! Results against a parameter that each group held fixed, with a straight line.

use super::drawn::look;
use super::room::Part;
use super::words;
use crate::app::App;
use class::against::{Against, Power};
use class::page;
use class::results::Quantity;
use view::views::*;

/// Maximum number of results in a table; the report has all.
const MOST_ROWS: usize = 100;

/// Quantities against a parameter. `x`: power of the parameter. `y`: power of the quantity; empty for all quantities.
///
/// # Errors
/// The sentence for a text that is no power, or for a parameter that no group held fixed.
pub fn asked(app: App, x: &str, y: &str) -> Result<Vec<Against>, String> {
    let language = app.language.get_untracked();
    let power = |text: &str| Power::parse(text).map_err(|why| why.text(language).into_owned());
    let x = power(x)?;
    let y = if y.trim().is_empty() { None } else { Some(power(y)?) };
    let found: Vec<Against> = app.class.read_quantities(Part::Against, |quantities: &[Quantity]| {
        quantities.iter().filter_map(|quantity| Against::new(quantity, y.as_ref(), &x)).collect()
    });
    if found.is_empty() { Err(words::of(app).against_none.replace('#', x.name())) } else { Ok(found) }
}

/// The section: two fields, and below the figures.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let field = |id: &'static str, label: &'static str, example: &'static str, typed: Signal<String>| {
        let input = input()
            .r#type("text")
            .id(id)
            .autocomplete("off")
            .attr("spellcheck", "false")
            .attr("placeholder", example)
            .attr("value", typed.get_clone_untracked())
            .when(events::change, move |event| typed.set(value_of(&event)));
        field_of(id, label).child(input)
    };
    let (x, y) = app.class.axes();
    let found = move || {
        app.class.follow(Part::Against);
        let (x, y) = (x.get_clone(), y.get_clone());
        if x.trim().is_empty() {
            return View::new();
        }
        match asked(app, &x, &y) {
            Err(why) => p().class("refusal").role("alert").child(why).into(),
            Ok(found) => {
                let section = |one: &Against| {
                    app.class.read_once(|collection| page::against(one, collection, MOST_ROWS, look(app)))
                };
                div().class("class-report").inner_html(found.iter().map(section).collect()).into()
            }
        }
    };
    View::from((
        note(words.against_note),
        div().class("class-axes").child(field("class-x", words.against_x, "2/L", x)).child(field(
            "class-y",
            words.against_y,
            "omega_0^2",
            y,
        )),
        changing(found),
    ))
}
