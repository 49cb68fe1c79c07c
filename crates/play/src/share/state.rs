//! State of the laboratory as a short text, for links and for the next visit.
//!
//! The text begins with its version and has fields `key=value` separated by `&`. All characters are allowed in the fragment of
//! a URL. Numbers are SI, in the shortest form that reads back exactly.
//!
//! | key | value |
//! |---|---|
//! | `p` | parameters at the start that differ from the document's: `b:200,h_l:3.5` |
//! | `n` | sizes of families that differ from the document's: `N:50` |
//! | `seat` | seat of a class: the assigned values follow from it |
//! | `y` | a start state set by hand, one value per state: `0.5,0` |
//! | `m`, `h` | method and step, if they differ |
//! | `a` | a drawn curve, once for each: the table and the levels of its points, 12 bits per point in base64url |
//! | `b` | presses of buttons, by name or title with their times: `kick:3.2:4.1,stop:5` |
//! | `c` | a change during the run, once for each: the first row it applies to, and the parameters: `100,b:300` |
//! | `e` | greatest time reached, if greater than `t` |
//! | `t` | the time shown |
//! | `k` | (no value) a kept run: the fields up to the next `k` describe it instead of the present one |
//! | `x` | the speed |
//! | `w` | (no value) the values that questions hide are shown |
//! | `v` | plots not shown: `0,2` |
//! | `z` | zoom of a plot, once for each: the plot, then the limits of the horizontal axis (empty if automatic) and of each vertical one: `0,1:2.5,-3:3` |

use crate::controls::button::written;
use crate::controls::drawing;
use crate::share::link::{VERSION, encode};
use crate::time::recipe::{Change, Recipe};
use crate::{Answers, Basis, Plots, TimeLine};
use engine::Setup;
use figure::{Interval, View};
use units::number::compact as exact;

/// Maximum number of parameter changes in a link. With more, the run of the link begins at the state shown.
pub(crate) const MOST_CHANGES: usize = 300;

/// Parts of the state in a text that must be short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// All of it, with any number of changes during the run: for [`crate::Play::pass_on`].
    Exact,
    /// All of it, as far as a link has room.
    Whole,
    /// Without the kept runs.
    WithoutKept,
    /// Without the kept runs and without what was changed on the way: the run begins at the state shown.
    Moment,
    /// A run from time 0 with the present parameters, without what was changed on the way and without the view.
    Start,
}

/// The parts of the state that a link contains.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State<'a> {
    pub basis: &'a Basis,
    pub line: &'a TimeLine,
    pub plots: &'a Plots,
    pub answers: &'a Answers,
}

impl State<'_> {
    /// Differences from the freshly opened document; see [`crate::Play::share`].
    pub fn text(&self, extent: Extent) -> String {
        let (course, mut fields) = (self.line.course(), Vec::new());
        let mut recipe = course.recipe();
        let changed = !(recipe.changes.is_empty() && recipe.setup.presses.is_empty());
        let begins_now = match extent {
            Extent::Exact | Extent::Start => false,
            Extent::Moment => changed,
            Extent::Whole | Extent::WithoutKept => recipe.changes.len() > MOST_CHANGES,
        };
        let begins_now = begins_now && course.state().iter().all(|value| value.is_finite());
        if begins_now || extent == Extent::Start {
            let start = if begins_now { Some(course.state().to_vec()) } else { recipe.setup.start };
            let parameters = course.parameters().to_vec();
            let setup = Setup { parameters, start, presses: Vec::new(), ..recipe.setup };
            recipe = Recipe { setup, changes: Vec::new(), front: 0.0, time: 0.0 };
        }
        let sizes = self.basis.model().sizes.iter().filter(|size| size.value != size.stated);
        let sizes: Vec<String> = sizes.map(|size| format!("{}:{}", size.name, size.value)).collect();
        if !sizes.is_empty() {
            fields.push(format!("n={}", sizes.join(",")));
        }
        fields.extend(self.basis.program().seat.map(|seat| format!("seat={}", seat.number())));
        self.write_recipe(&recipe, &mut fields);
        if extent != Extent::Start {
            self.write_view(&mut fields);
        }
        for recipe in self.line.kept_recipes().filter(|_| matches!(extent, Extent::Whole | Extent::Exact)) {
            fields.push("k".to_owned());
            self.write_recipe(recipe, &mut fields);
        }
        if fields.is_empty() { String::new() } else { format!("{VERSION}&{}", fields.join("&")) }
    }

    /// Writes what decides how the run is shown.
    fn write_view(&self, fields: &mut Vec<String>) {
        if self.answers.shows_hidden() {
            fields.push("w".to_owned());
        }
        if self.line.speed() != 1.0 {
            fields.push(format!("x={}", exact(self.line.speed())));
        }
        let documents = self.basis.program().plots.len();
        if let Some(hidden) = self.plots.hidden(documents) {
            let hidden: Vec<String> = hidden.iter().map(usize::to_string).collect();
            fields.push(format!("v={}", hidden.join(",")));
        }
        // Plots of measurements come and go with the records, which a link does not contain.
        for (index, view) in self.plots.zoomed().filter(|(index, _)| *index < documents) {
            fields.push(format!("z={index},{}", limits(view)));
        }
    }

    fn write_recipe(&self, recipe: &Recipe, fields: &mut Vec<String>) {
        let setup = &recipe.setup;
        let parameters = self.differing(&self.basis.defaults().parameters, &setup.parameters);
        if !parameters.is_empty() {
            fields.push(format!("p={}", parameters.join(",")));
        }
        if let Some(start) = &setup.start {
            let values: Vec<String> = start.iter().map(|&value| exact(value)).collect();
            fields.push(format!("y={}", values.join(",")));
        }
        if setup.method != self.basis.defaults().method {
            fields.push(format!("m={}", setup.method));
        }
        if setup.step != self.basis.defaults().step {
            fields.push(format!("h={}", exact(setup.step)));
        }
        let drawn = drawing::written(self.basis.model(), &setup.drawings, &self.basis.defaults().drawings);
        fields.extend(drawn.into_iter().map(|curve| format!("a={curve}")));
        if !setup.presses.is_empty() {
            fields.push(format!("b={}", written(&setup.presses, &self.basis.model().buttons, encode)));
        }
        let mut before = &setup.parameters;
        for Change { row, parameters, .. } in &recipe.changes {
            fields.push(format!("c={row},{}", self.differing(before, parameters).join(",")));
            before = parameters;
        }
        if recipe.front != recipe.time {
            fields.push(format!("e={}", exact(recipe.front)));
        }
        if recipe.time != 0.0 || recipe.front != recipe.time {
            fields.push(format!("t={}", exact(recipe.time)));
        }
    }

    /// Entries such as `b:200` for each parameter that differs.
    fn differing(&self, from: &[f64], to: &[f64]) -> Vec<String> {
        let values = self.basis.model().parameters.iter().zip(from.iter().zip(to));
        let differing = values.filter(|(parameter, (from, to))| parameter.is_shown() && from.to_bits() != to.to_bits());
        let texts = &self.basis.model().texts;
        let written = |(parameter, (_, to)): (&program::Parameter, (&f64, &f64))| {
            let value = parameter.word(*to, texts).map_or_else(|| exact(*to), encode);
            format!("{}:{value}", parameter.name)
        };
        differing.map(written).collect()
    }
}

/// Limits of a zoomed plot: `1:2.5,-3:3`, or `,-3:3` if the horizontal axis is automatic.
fn limits(view: &View) -> String {
    let ends = |limits: &Interval| format!("{}:{}", exact(limits.low), exact(limits.high));
    let horizontal = view.x.as_ref().map_or_else(String::new, ends);
    std::iter::once(horizontal).chain(view.y.iter().map(ends)).collect::<Vec<_>>().join(",")
}
