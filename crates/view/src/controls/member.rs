//! Selection of the member of a family: a number field for each of its indices.

use crate::app::App;
use crate::views::*;
use play::number::typed::whole;
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
        let language = app.language.get_untracked();
        let read = move |typed: &str| get().map(|index| whole(typed, index.least..=index.greatest, language.style()));
        let typed = {
            let (node, choose) = (node.clone(), choose.clone());
            move |_| {
                // While the user types, the digits so far may not form a valid index.
                if let Some(Ok(value)) = read(&node.value()) {
                    choose(value);
                }
            }
        };
        let taken = move |_| {
            match read(&node.value()) {
                Some(Ok(value)) => choose(value),
                Some(Err(why)) => {
                    app.complain(why.words().text(language).into_owned());
                    // The nearest member is shown instead of one beyond the ends.
                    if let Ok(beyond) = whole(&node.value(), i64::MIN..=i64::MAX, language.style()) {
                        choose(beyond);
                    }
                }
                None => {}
            }
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
