//! Transfer of the user's plot settings to another program, by the titles of the plots.

use crate::Play;
use crate::plots::plot::PlotState;
use program::{Curve, Plot};

/// True if two plots draw the same expressions in the same units. The meaning of their names may differ.
fn same_curves(one: &Plot, other: &Plot) -> bool {
    let same =
        |(one, other): (&Curve, &Curve)| one.expression == other.expression && one.value.unit == other.value.unit;
    one.curves.len() == other.curves.len()
        && one.others.iter().map(|(place, _)| place).eq(other.others.iter().map(|(place, _)| place))
        && one.expressions().zip(other.expressions()).all(same)
}

impl Play {
    /// Takes over visibility and zoom of plots, the points over their curves, and added plots.
    pub(super) fn adopt_plots(&mut self, before: &mut Play) {
        let documents = before.basis.program().plots.len().min(before.plots.len());
        let added = before.plots.split_off(documents);
        let mut former: Vec<Option<PlotState>> = std::mem::take(&mut before.plots).into_iter().map(Some).collect();
        for (index, (state, plot)) in self.plots.iter_mut().zip(&self.basis.program().plots).enumerate() {
            // Plots with equal titles are matched in their order.
            let titles = before.basis.program().plots.iter().zip(&mut former).enumerate();
            let mut same_title = titles.filter(|(_, (other, state))| other.title == plot.title && state.is_some());
            let Some((place, (other, old))) = same_title.next() else { continue };
            let Some(old) = old.take() else { continue };
            let axes = |play: &Play, index: usize| play.line.columns().plot(index).map(|columns| columns.axes.clone());
            let own_axes = self.line.columns().plot(index).map(|columns| columns.axes.clone());
            if same_curves(plot, other) {
                // Computed content belongs to the program.
                let content = std::mem::take(&mut state.content);
                *state = PlotState { content, ..old };
            } else {
                state.shown = old.shown;
                if plot.x.value.unit == other.x.value.unit && own_axes == axes(before, place) {
                    state.view = old.view;
                }
            }
        }
        self.plots.extend(added);
    }

    /// True if the columns of the plots are arranged as in the former program, so that its runs can be drawn.
    pub(super) fn has_curves_of(&self, before: &Play) -> bool {
        let (plots, former) = (&self.basis.program().plots, &before.basis.program().plots);
        plots.len() == former.len()
            && plots.iter().zip(former).all(|(one, other)| same_curves(one, other))
            && self.line.columns().is_arranged_like(&before.line.columns())
    }

    /// True if the columns also compute the same values, for runs with the same states.
    pub(super) fn columns_are_those_of(&self, before: &Play) -> bool {
        let (graph, former) = (&self.model().graph, &before.model().graph);
        graph.same(self.line.columns().nodes(), former, before.line.columns().nodes(), Some)
    }
}
