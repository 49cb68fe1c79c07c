//! Builds the texts of the plots.

use super::labels::Labels;
use super::traces::Columns;
use crate::values::symbol::symbol;
use crate::{Basis, number, words};
use program::{Curve, Drawing, Plot};
use units::Dimension;
use units::mathml::is_word;

impl Basis {
    /// Title of an axis from the names of its curves. For a single expression that is not a plain name, or is a word, its label. For
    /// several curves that all have labels, and not all plain names, the title is empty: the legend shows the labels,
    /// the axis only its unit.
    fn axis_title(&self, curves: &[(&Curve, &String)]) -> String {
        let is_name = |curve: &Curve| {
            let is_plain = curve.expression.bytes().all(|letter| letter.is_ascii_alphabetic());
            let is_labelled_word = curve.label.is_some() && is_plain && is_word(&curve.expression);
            curve.expression.chars().all(|letter| letter.is_alphanumeric() || "_'[].,".contains(letter))
                && !is_labelled_word
        };
        if curves.iter().all(|(curve, _)| is_name(curve)) {
            return curves.iter().map(|(_, name)| name.as_str()).collect::<Vec<_>>().join(", ");
        }
        match curves {
            [(curve, name)] => {
                curve.label.as_ref().map_or_else(|| (*name).clone(), |label| self.text(label).to_owned())
            }
            _ if curves.iter().all(|(curve, _)| curve.label.is_some()) => String::new(),
            _ => curves.iter().map(|(_, name)| name.as_str()).collect::<Vec<_>>().join(", "),
        }
    }

    /// Words before the title of an axis: the label of its only curve, unless it is the title. Time has a name without a label.
    fn axis_name(&self, curves: &[(&Curve, &String)], title: &str) -> String {
        let [(curve, _)] = curves else { return String::new() };
        let independent = &self.model().independent;
        match &curve.label {
            Some(label) => Some(self.text(label)).filter(|label| *label != title).unwrap_or_default().to_owned(),
            None if curve.expression == independent.name
                && !independent.counts
                && independent.unit.dimension == Dimension::TIME =>
            {
                words::time_axis(self.language()).to_owned()
            }
            None => String::new(),
        }
    }

    /// Texts of a plot of the document; `None` for an unknown index.
    pub(super) fn labels_of(&self, columns: &Columns, index: usize) -> Option<Labels> {
        let plot = self.program().plots.get(index)?;
        let columns = columns.plot(index)?;
        let title = self.text(&plot.title).to_owned();
        if let Drawing::Histogram(members) = &plot.drawing {
            return Some(self.labels_of_histogram(plot, title, members.is_empty()));
        }
        let named = |curve: &program::Curve| match &curve.label {
            Some(label) => format!("{} ({})", self.text(label), symbol(&curve.expression)),
            None => symbol(&curve.expression),
        };
        let names: Vec<String> = plot.curves.iter().map(named).collect();
        let description = self.described(plot, &names, named);
        let curves: Vec<String> = plot.curves.iter().map(|curve| symbol(&curve.expression)).collect();
        let legend = plot.curves.iter().zip(&curves).map(|(curve, name)| match &curve.label {
            Some(label) if curve.named => self.text(label).to_owned(),
            _ => name.clone(),
        });
        let legend = legend.collect();
        let axes = columns.axes.iter().enumerate().map(|(axis, unit)| {
            let places = columns.curves.iter().enumerate().filter(|(_, columns)| columns.axis == axis);
            let here: Vec<(&Curve, &String)> =
                places.filter_map(|(place, _)| plot.curves.get(place).zip(curves.get(place))).collect();
            let title = self.axis_title(&here);
            (self.axis_name(&here, &title), (title, number::unit_text(&unit.text)))
        });
        let (axis_names, axes) = axes.unzip();
        let mut abscissas: Vec<(&Curve, String)> = plot.abscissas().map(|x| (x, symbol(&x.expression))).collect();
        abscissas.dedup_by(|one, other| one.1 == other.1);
        let abscissas: Vec<(&Curve, &String)> = abscissas.iter().map(|(x, name)| (*x, name)).collect();
        let x = self.axis_title(&abscissas);
        let across = (0..curves.len()).map(|curve| match plot.others.is_empty() {
            true => String::new(),
            false => symbol(&plot.x_of(curve).expression),
        });
        let across = across.collect();
        Some(Labels {
            axes,
            names: (self.axis_name(&abscissas, &x), axis_names),
            description: format!("{title}: {description}"),
            title,
            x: (x, number::unit_text(&plot.x.value.unit.text)),
            curves,
            legend,
            across,
        })
    }

    fn labels_of_histogram(&self, plot: &Plot, title: String, over_run: bool) -> Labels {
        let name = symbol(&plot.x.expression);
        let described =
            plot.x.label.as_ref().map_or_else(|| name.clone(), |label| format!("{} ({name})", self.text(label)));
        let description = format!("{title}: {}", words::counted(self.language(), &described, over_run));
        let count = words::count(self.language()).to_owned();
        let x = (name, number::unit_text(&plot.x.value.unit.text));
        let axes = vec![(count.clone(), String::new())];
        let names = (plot.x.label.as_ref().map_or_else(String::new, |label| self.text(label).to_owned()), Vec::new());
        Labels { title, description, x, axes, names, curves: vec![count], ..Labels::default() }
    }

    /// Description of a plot: `Height (y), Speed (v) against Time (t).` Curves with the same abscissa are grouped.
    fn described(&self, plot: &Plot, names: &[String], named: impl Fn(&Curve) -> String) -> String {
        let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
        for (curve, name) in names.iter().enumerate() {
            let x = named(plot.x_of(curve));
            match groups.last_mut() {
                Some((last, together)) if *last == x => together.push(name),
                _ => groups.push((x, vec![name])),
            }
        }
        let sentences = groups.iter().map(|(x, curves)| words::against(self.language(), &curves.join(", "), x));
        sentences.collect::<Vec<_>>().join(" ")
    }
}
