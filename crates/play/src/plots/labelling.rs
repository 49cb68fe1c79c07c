//! Writes the texts of the plots.

use super::labels::Labels;
use crate::values::symbol::symbol;
use crate::{Play, number, words};

impl Play {
    /// Writes the texts of all plots in the chosen language.
    pub(crate) fn label_plots(&mut self) {
        for index in 0..self.plots.len() {
            let Some(labels) = self.labels_of(index) else {
                continue;
            };
            if let Some(state) = self.plots.get_mut(index) {
                state.labels = labels;
            }
        }
        self.revision.plots += 1;
    }

    fn labels_of(&self, index: usize) -> Option<Labels> {
        let plot = self.program.plots.get(index)?;
        let columns = self.columns.plot(index)?;
        let title = self.text(&plot.title).to_owned();
        let named = |curve: &program::Curve| match &curve.label {
            Some(label) => format!("{} ({})", self.text(label), symbol(&curve.expression)),
            None => symbol(&curve.expression),
        };
        let names: Vec<String> = plot.curves.iter().map(named).collect();
        let description = words::against(self.language, &names.join(", "), &named(&plot.x));
        let curves: Vec<String> = plot.curves.iter().map(|curve| symbol(&curve.expression)).collect();
        let axes = columns.axes.iter().enumerate().map(|(axis, unit)| {
            let here = columns.curves.iter().zip(&curves).filter(|((_, of), _)| *of == axis);
            let names: Vec<&str> = here.map(|(_, name)| name.as_str()).collect();
            (names.join(", "), number::unit_text(&unit.text))
        });
        Some(Labels {
            axes: axes.collect(),
            description: format!("{title}: {description}"),
            title,
            x: (symbol(&plot.x.expression), number::unit_text(&plot.x.value.unit.text)),
            curves,
        })
    }
}
