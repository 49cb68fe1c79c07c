//! Form for a new plot: quantity, abscissa, title.

use crate::app::App;
use crate::write::fields::{named, new_line, opener, refuse};
use crate::write::typing;
use document::edit::{NewPlot, add_plot};
use document::form::plottable;
use view::browser;
use view::views::*;
use web_sys::{HtmlInputElement, HtmlSelectElement, SubmitEvent};

/// Button and form.
pub fn view(app: App) -> View {
    let words = app.words();
    let open = create_signal(false);
    let refusal = create_signal(None::<String>);
    let names = |with_independent: bool| {
        memo(move || {
            app.written.track();
            app.read(|play| plottable(play.program(), with_independent))
        })
    };
    let choice = |(name, label): (String, Option<String>)| {
        let title = named(&name, label);
        option().value(name).child(title)
    };
    let (drawn, abscissas) = (names(false), names(true));
    let mut curves = select().class("cell").id("new-plot-curves");
    let mut across = select().class("cell").id("new-plot-across");
    let mut title = input().r#type("text").class("cell").id("new-plot-title").autocomplete("off");
    let nodes: (HtmlSelectElement, HtmlSelectElement, HtmlInputElement) = (curves.node(), across.node(), title.node());
    let add = move |event: SubmitEvent| {
        event.prevent_default();
        let (curves, across, title) = &nodes;
        let name = curves.value();
        // Without a title from the author, the plot is named after its quantity.
        let label =
            drawn.with_untracked(|all| all.iter().find(|(own, _)| *own == name).and_then(|(_, label)| label.clone()));
        let given = Some(title.value()).filter(|title| !title.trim().is_empty());
        let plot =
            NewPlot { title: given.or(label).unwrap_or_else(|| name.clone()), curves: name, across: across.value() };
        let text = typing::text(app, 0);
        let added = typing::act(app, 0, &text, |outline| add_plot(outline, &plot).map(|edit| vec![edit]));
        if added.is_ok() {
            title.set_value("");
            open.set(false);
            browser::focus_later("new-plot".to_owned());
        }
        refuse(refusal, added.err());
    };
    let fields = tags::form()
        .class("new-question card")
        .id("new-plot-form")
        .hidden(move || !open.get())
        .when(events::submit, add)
        .child(new_line(
            "new-plot-curves",
            words.plot_curves,
            curves.child(changing(move || each(drawn.get_clone(), choice))).into(),
        ))
        .child(new_line(
            "new-plot-across",
            words.plot_against,
            across.child(changing(move || each(abscissas.get_clone(), choice))).into(),
        ))
        .child(new_line("new-plot-title", words.text_title, title.into()))
        .child(refusal_of(refusal))
        .child(button().r#type("submit").class("primary").child(words.add_new));
    let button = opener(words.plot_add, open, "new-plot-curves").id("new-plot").attr("aria-controls", "new-plot-form");
    View::from((div().class("form-tools").child(button), fields))
}
