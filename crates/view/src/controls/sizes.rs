//! Sizes of families: a number field if the page can rebuild the model, otherwise the value only.

use crate::app::App;
use crate::browser;
use crate::pieces::symbols::name_and_symbol;
use crate::views::*;
use play::SizeView;
use play::number::typed::whole;
use web_sys::HtmlInputElement;

/// Resets the sizes to the values of the document, if the page can. Returns true if a size has changed, so that the
/// page must be rebuilt.
pub fn restore(app: App) -> bool {
    let host = app.host();
    let changed = app.read(|play| {
        let others = play.model().sizes.iter().filter(|size| size.value != size.stated);
        others.map(|size| (size.name.clone(), size.stated)).collect::<Vec<_>>()
    });
    host.can_resize() && changed.iter().filter(|(name, stated)| host.resize(name, *stated).is_none()).count() > 0
}

/// Control of a size.
pub fn control(app: App, size: SizeView) -> HtmlDiv {
    let words = app.words();
    let id = format!("size-{}", size.name);
    let changed = if size.is_default { "" } else { " changed" };
    let row = div().class(format!("parameter size{changed}"));
    let name = name_and_symbol(&size.label, &size.name);
    if !app.host().can_resize() {
        let value = span().class("value").id(id).child(size.value.to_string());
        let fixed = span().class("quantity").child(value).child(unit_of(""));
        return row.child(span().class("label").child(name)).child(fixed).child(note(words.size_fixed));
    }
    let error = create_signal(None::<String>);
    let mut field = input();
    let node: HtmlInputElement = field.node();
    let (place, before) = (id.clone(), size.value);
    let take = move |_| {
        let language = app.language.get_untracked();
        let value = match whole(&node.value(), 0..=i64::from(u32::MAX), language.style()) {
            Ok(value) => u32::try_from(value).unwrap_or_default(),
            Err(why) => return error.set(Some(why.words().text(language).into_owned())),
        };
        if value == before {
            return error.set(None);
        }
        let refusal = app.host().resize(&size.name, value);
        if refusal.is_none() {
            // The views of families are rebuilt; the focus is restored.
            let had_focus = browser::focused() == place;
            app.rebuild();
            if had_focus {
                browser::focus(&place);
            }
        } else {
            error.set(refusal);
        }
    };
    let bound = |bound: Option<u32>| bound.map(|bound| bound.to_string());
    let (least, greatest) = (bound(size.range.map(|range| range.0)), bound(size.range.map(|range| range.1)));
    let title = match (&least, &greatest) {
        (Some(least), Some(greatest)) => format!("{least} … {greatest}. {}", words.size_title),
        _ => words.size_title.to_owned(),
    };
    let field = field
        .r#type("number")
        .class("number")
        .id(id.clone())
        .attr("min", least.or_else(|| bound(Some(0))))
        .attr("max", greatest)
        .step("1")
        .prop("value", size.value.to_string())
        .attr("aria-invalid", move || error.with(Option::is_some).then_some("true"))
        .attr("aria-describedby", format!("{id}-error"))
        .when(events::change, take);
    row.child(label().r#for(id.clone()).title(title).child(name))
        .child(with_unit(field, ""))
        .child(refusal_of(error).id(format!("{id}-error")))
}
