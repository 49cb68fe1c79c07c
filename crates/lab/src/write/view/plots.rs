//! Plots of the document, one card each.

use super::forms::Plots;
use super::{new_plot, plot};
use crate::app::App;
use crate::write::typing;
use document::form::{PlotCell, PlotPart, plots};
use model::Diagnostic;
use view::views::*;

/// Cards of all plots.
pub fn view(app: App) -> HtmlDiv {
    let all = memo(move || {
        app.typed.track();
        app.written.track();
        plots(&document::read(&typing::text(app, 0)))
    });
    let faults = memo(move || {
        app.written.track();
        let (text, findings) = app.read_writing(|writing| {
            (writing.texts().first().cloned().unwrap_or_default(), writing.findings().to_vec())
        });
        let checked = plots(&document::read(&text));
        let of = |(file, found): (usize, Diagnostic)| {
            let place = found.span().start;
            let number = checked.iter().position(|plot| plot.span.start <= place && place <= plot.span.end);
            Some((number.filter(|_| file == 0)?, found))
        };
        findings.into_iter().filter_map(of).collect()
    });
    let shared = Plots { app, all, faults, typing: create_signal(false) };
    let mut last: Vec<Vec<PlotCell>> = Vec::new();
    // Cells for which the views are built. They are kept while a whole plot is being typed, so that its field stays.
    let shapes = memo(move || {
        let cells = |part: &PlotPart| part.cells.iter().map(|(kind, ..)| *kind).collect();
        let now: Vec<Vec<PlotCell>> = shared.all.with(|all| all.iter().map(cells).collect());
        if !(shared.typing.get() && now.len() == last.len()) {
            last = now;
        }
        last.clone()
    });
    let list = move || {
        let shapes = shapes.get_clone();
        let count = shapes.len();
        if count == 0 {
            return View::from(note(app.words().plots_none));
        }
        let one = |(number, cells): (usize, Vec<PlotCell>)| plot::view(shared, number, count, &cells);
        ol().class("plot-forms").each(shapes.into_iter().enumerate(), one).into()
    };
    div().class("plots-form").child(changing(list)).child(new_plot::view(app))
}
