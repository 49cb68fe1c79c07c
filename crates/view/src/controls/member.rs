//! Selection of the member of a family: a number field for each of its indices.

use crate::app::App;
use crate::views::*;
use play::{Index, Members};
use web_sys::HtmlInputElement;

/// Number fields for the indices of a family named `called`. `shown` reads the member shown now.
pub fn pickers(
    app: App,
    called: &str,
    family: Members,
    shown: impl Fn() -> Option<Members> + Copy + 'static,
) -> HtmlSpan {
    let several = family.indices.len() > 1;
    let picker = |place: usize| {
        let name = family.name.clone();
        let index = app.words().index;
        let number = if several { format!(" {}", place + 1) } else { String::new() };
        let get = move || shown().and_then(|family| family.indices.get(place).copied());
        let part = move |part: fn(&Index) -> i64| get().map_or_else(String::new, |index| part(&index).to_string());
        let mut input = input();
        let node: HtmlInputElement = input.node();
        let choose =
            move |value: i64| app.act(|play| play.change_values(|values| values.choose_member(&name, place, value)));
        let typed = {
            let (node, choose) = (node.clone(), choose.clone());
            move |_| {
                // While the user types, the digits so far may not form a valid index.
                let value = node.value().parse::<i64>().ok();
                if let Some((value, index)) = value.zip(get())
                    && (index.least..=index.greatest).contains(&value)
                {
                    choose(value);
                }
            }
        };
        let taken = move |_| {
            if let Ok(value) = node.value().parse() {
                choose(value);
            }
            // If there is no such member, another one is shown.
            node.set_value(&part(|index| index.value));
        };
        input
            .r#type("number")
            .class("member")
            .attr("aria-label", format!("{called}: {index}{number}"))
            .attr("min", move || Some(part(|index| index.least)))
            .attr("max", move || Some(part(|index| index.greatest)))
            .step("1")
            .prop("value", move || part(|index| index.value))
            .when(events::input, typed)
            .when(events::change, taken)
    };
    span().class("members").each(0..family.indices.len(), picker)
}
