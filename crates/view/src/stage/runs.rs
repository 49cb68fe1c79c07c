//! Kept runs, drawn behind the present one: show, hide, remove.

use super::legend;
use crate::app::App;
use crate::pieces::icons;
use crate::views::*;
use play::Play;

/// Button that keeps the present run.
pub fn keep_button(app: App) -> HtmlButton {
    let words = app.words();
    let keep = move |_| {
        if let Some(refusal) = app.attempt(|play| play.change_run(|line, basis| line.keep(basis))) {
            app.complain(refusal)
        }
    };
    labelled(icons::keep(), words.keep).id("keep").title(words.keep_title).when(events::click, keep)
}

/// List of kept runs and the ghost; empty if there are none.
pub fn list(app: App) -> View {
    let kept = memo(move || {
        app.changes.runs.track();
        // Its name is what differs from the present run.
        app.changes.parameters.track();
        app.read(|play| play.time_line().kept(play.basis()))
    });
    // Rebuilt only if an entry was added or removed, so that hiding a run keeps the focus on its check box.
    let lines = memo(move || {
        let named =
            kept.with(|kept| kept.iter().map(|run| (run.id, run.name.clone(), run.pattern)).collect::<Vec<_>>());
        app.changes.runs.track();
        (named, app.read(|play| play.time_line().has_ghost()))
    });
    let shown = move |id: u32| kept.with(|kept| kept.iter().any(|run| run.id == id && run.shown));
    changing(move || {
        let words = app.words();
        let (named, ghost) = lines.get_clone();
        if named.is_empty() && !ghost {
            return View::new();
        }
        let run = |(id, name, pattern): (u32, String, u8)| {
            let show = move |event| {
                let shown = is_checked(&event);
                app.act(|play| play.change_run(|line, _| line.show_kept(id, shown)));
            };
            let tick = input().r#type("checkbox").prop("checked", move || shown(id)).when(events::change, show);
            let remove = remove(app, &name, move |play| play.change_run(|line, basis| line.remove_kept(basis, id)));
            let name = span().class("run-name").title(name.clone()).child(name);
            let line = legend::sample(figure::Style::Faded(pattern), 0);
            li().class("run").child(switch(tick, View::from((line, name)))).child(remove)
        };
        let ghost = ghost.then(|| {
            let remove = remove(app, words.ghost, |play| play.change_run(|line, basis| line.remove_ghost(basis)));
            li().class("run ghost").child(span().child(words.ghost)).child(remove)
        });
        ul().class("runs").attr("aria-label", words.runs).each(named, run).maybe(ghost).into()
    })
}

/// Button that removes a run.
fn remove(app: App, name: &str, remove: impl Fn(&mut Play) + 'static) -> HtmlButton {
    let label = format!("{}: {name}", app.words().remove_run);
    let remove = move |_| {
        app.act(&remove);
        // The button no longer exists; the focus moves to the button that keeps runs.
        crate::browser::focus("keep");
    };
    cross(label).when(events::click, remove)
}
