//! Restores a state from the text written by [`crate::Play::share`].

use super::link::{VERSION, decode, encode};
use crate::controls::button::read;
use crate::controls::drawing;
use crate::time::recipe::{Change, Moments, Recipe};
use crate::{Answers, Basis, Changes, MOST_KEPT, Plots, Refusal, TimeLine};
use engine::Method;
use figure::{Interval, View};
use program::Seat;
use units::number::compact as exact;

/// Maximum number of rows of a run in a link, because recording a row takes time.
const MOST_ROWS: usize = 2_500_000;

/// Maximum number of omitted parts that a refusal names individually.
const MOST_NAMED: usize = 12;

/// Fields of a text written by [`crate::Play::share`]; `None` if it is empty.
///
/// # Errors
///
/// The text is not a state.
pub(crate) fn fields(fragment: &str) -> Result<Option<Vec<&str>>, Refusal> {
    let fragment = fragment.trim_start_matches('#');
    if fragment.is_empty() {
        return Ok(None);
    }
    // A link to a seat is written by hand, too: `#seat=7`.
    let after_version = match fragment.split_once('&') {
        Some((VERSION, fields)) => fields,
        _ if fragment == VERSION => return Ok(Some(Vec::new())),
        _ if fragment.strip_prefix("seat=").is_some_and(|seat| seat.parse::<Seat>().is_ok()) => fragment,
        _ => return Err(Refusal::UnreadableState),
    };
    Ok(Some(after_version.split('&').collect()))
}

/// Seat of a link; `None` if it leaves the present one.
pub(crate) fn seat(fields: &[&str]) -> Option<Seat> {
    fields.iter().find_map(|field| field.strip_prefix("seat=")?.parse().ok())
}

/// Parser of fields; collects the parts that do not fit.
pub(crate) struct Reader<'a> {
    basis: &'a Basis,
    line: &'a mut TimeLine,
    plots: &'a mut Plots,
    answers: &'a mut Answers,
    changes: Changes,
    /// Maximum number of changes in each run.
    most_changes: usize,
    left_out: Vec<String>,
}

impl<'a> Reader<'a> {
    /// Reader that changes these parts of a simulation. A run has at most `most_changes` changes.
    pub fn new(
        basis: &'a Basis,
        line: &'a mut TimeLine,
        plots: &'a mut Plots,
        answers: &'a mut Answers,
        most_changes: usize,
    ) -> Self {
        Self { basis, line, plots, answers, changes: Changes::NONE, most_changes, left_out: Vec::new() }
    }

    /// Restores the state of these fields. Parts that do not fit the document are omitted and named in the refusal; the
    /// rest is applied. `work` is the limit for all runs together, in floating-point operations; it is reduced by the
    /// work done.
    pub fn restore(mut self, fields: &[&str], work: &mut u64) -> (Result<(), Refusal>, Changes) {
        self.changes |= Changes::RELEASED | self.line.set_speed(1.0) | self.plots.reset_all();
        let mut sections = fields.split(|field| *field == "k");
        let present = self.recipe(sections.next().unwrap_or_default());
        // Limited before anything is computed: a link can name far more runs than can be kept.
        let kept: Vec<Recipe> = sections.by_ref().take(MOST_KEPT).map(|section| self.recipe(section)).collect();
        let Self { basis, line, mut changes, mut left_out, .. } = self;
        left_out.extend(sections.map(|_| "k".to_owned()).take(MOST_NAMED + 1));
        let (course, complete) = line.replay(basis, &present, Moments::Rows, work);
        if !complete {
            left_out.push(format!("t={}", exact(present.front)));
        }
        changes |= line.stop() | line.forget_runs() | line.replace(course);
        for recipe in &kept {
            let complete = line.keep_recipe(basis, recipe, work).map(|(complete, kept)| {
                changes |= kept;
                complete
            });
            if complete != Ok(true) {
                left_out.push(format!("k, t={}", exact(recipe.front)));
            }
        }
        if left_out.len() > MOST_NAMED {
            left_out.truncate(MOST_NAMED);
            left_out.push("…".to_owned());
        }
        (if left_out.is_empty() { Ok(()) } else { Err(Refusal::PartlyRestored { left_out }) }, changes)
    }

    fn recipe(&mut self, fields: &[&str]) -> Recipe {
        let mut recipe =
            Recipe { setup: self.basis.defaults().clone(), changes: Vec::new(), front: 0.0, time: f64::NAN };
        for field in fields {
            let (key, value) = field.split_once('=').unwrap_or((field, ""));
            if self.field(key, value, &mut recipe).is_none() {
                self.leave_out(field);
            }
        }
        if recipe.time.is_nan() {
            recipe.time = recipe.front;
        }
        recipe.front = recipe.front.max(recipe.time);
        recipe
    }

    /// Applies one field to the recipe or the state; `None` if it does not fit.
    fn field(&mut self, key: &str, value: &str, recipe: &mut Recipe) -> Option<()> {
        match key {
            "p" if value.is_empty() => return None,
            "p" => {
                let parameters = self.parameters(value.split(','), &recipe.setup.parameters);
                recipe.setup.parameters = parameters;
            }
            // Sizes are part of the program: they match if the page has built it with them.
            "n" => {
                let is_so = |pair: &str| {
                    let (name, value) = pair.split_once(':')?;
                    let size = self.basis.model().sizes.iter().find(|size| size.name == name)?;
                    (value.parse() == Ok(size.value)).then_some(())
                };
                return value.split(',').map(is_so).collect();
            }
            // Read first: the values of a recipe differ from those of the seat.
            "seat" => return (self.basis.program().seat == Some(value.parse().ok()?)).then_some(()),
            "y" => {
                let start: Vec<f64> = value.split(',').map(number).collect::<Option<_>>()?;
                if start.len() != self.basis.model().states.len() {
                    return None;
                }
                recipe.setup.start = Some(start);
            }
            "m" => recipe.setup.method = value.parse::<Method>().ok()?,
            "h" => recipe.setup.step = number(value).filter(|&step| step > 0.0)?,
            "a" => {
                let (index, values) = drawing::read(self.basis.model(), value)?;
                *recipe.setup.drawings.get_mut(index)? = values;
            }
            "b" => recipe.setup.presses = read(value, &self.basis.model().buttons, encode)?,
            "c" => {
                let (row, values) = value.split_once(',')?;
                let row: usize = row.parse().ok()?;
                let last = recipe.changes.last();
                if !(1..=MOST_ROWS).contains(&row)
                    || last.is_some_and(|before| before.row >= row)
                    || recipe.changes.len() >= self.most_changes
                {
                    return None;
                }
                let parameters = self.parameters(values.split(','), recipe.last_parameters());
                // Ignores the rows of events: they are known only once the run is computed.
                let after = (row - 1) as f64 * recipe.setup.step;
                recipe.changes.push(Change { row, after, parameters });
            }
            "e" => recipe.front = number(value).filter(|&time| time >= 0.0)?,
            "t" => recipe.time = number(value).filter(|&time| time >= 0.0)?,
            "x" => self.changes |= self.line.set_speed(number(value)?),
            "w" => self.changes |= self.answers.show_hidden(true),
            "v" => {
                let hidden = value.split(',').filter(|index| !index.is_empty()).map(|index| index.parse().ok());
                self.changes |= self.plots.show_except(hidden)?;
            }
            "z" => {
                let (index, limits) = value.split_once(',')?;
                self.changes |= self.plots.set_view(index.parse().ok()?, view(limits)?)?;
            }
            _ => return None,
        }
        Some(())
    }

    /// Copy of `before` (SI) with some parameters replaced; values that do not fit are collected.
    fn parameters<'t>(&mut self, values: impl Iterator<Item = &'t str>, before: &[f64]) -> Vec<f64> {
        let mut parameters = before.to_vec();
        for text in values {
            let admitted = text.split_once(':').and_then(|(name, value)| {
                let index = self.basis.model().parameters.iter().position(|parameter| parameter.name == name)?;
                let parameter = self.basis.model().parameters.get(index)?;
                let value = match parameter.choices {
                    program::Choices::Numbers | program::Choices::Seed => number(value)?,
                    _ => parameter.chosen(&decode(value)?, &self.basis.model().texts)?,
                };
                Some((index, self.basis.admit(index, value).ok()?))
            });
            match admitted.and_then(|(index, value)| parameters.get_mut(index).zip(Some(value))) {
                Some((parameter, value)) => *parameter = value,
                None => self.leave_out(text),
            }
        }
        parameters
    }

    /// Records a part that does not fit. The list stays short even for a link of megabytes.
    fn leave_out(&mut self, part: &str) {
        if self.left_out.len() <= MOST_NAMED {
            self.left_out.push(part.chars().take(40).collect());
        }
    }
}

/// Limits of a zoomed plot; `None` if an interval is empty.
fn view(limits: &str) -> Option<View> {
    let ends = |limits: &str| {
        let (low, high) = limits.split_once(':')?;
        Some(Interval { low: number(low)?, high: number(high)? }).filter(|limits| limits.low < limits.high)
    };
    let (horizontal, vertical) = limits.split_once(',').unwrap_or((limits, ""));
    let x = if horizontal.is_empty() { None } else { Some(ends(horizontal)?) };
    let y = vertical.split(',').filter(|limits| !limits.is_empty()).map(ends).collect::<Option<_>>()?;
    Some(View { x, y })
}

fn number(text: &str) -> Option<f64> {
    units::number::decimal(text).filter(|value| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::MOST_NAMED;
    use crate::share::state::MOST_CHANGES;
    use crate::time::recipe::MOST_WORK;
    use crate::{MOST_KEPT, Play, Refusal};

    fn opened() -> Play {
        let source = "---\ntitle: Swing\nstep: 0.01 [s]\n---\n```model\nparameter k = 1 [1/s^2] in 0..9\n\
                      x'' + k*x = 0\nx(0) = 1\nx'(0) = 0\n```\n";
        Play::open(document::open(source, &[]).document.unwrap().program)
    }

    /// Work used to restore a link, in floating-point operations, and number of parts named as omitted.
    fn cost(link: &str) -> (u64, usize) {
        let (mut play, mut left) = (opened(), MOST_WORK);
        let left_out = match play.restore_within(link, MOST_CHANGES, &mut left) {
            Ok(()) => 0,
            Err(Refusal::PartlyRestored { left_out }) => left_out.len(),
            Err(refusal) => panic!("{refusal:?}"),
        };
        assert!(play.time_line().kept(play.basis()).len() <= MOST_KEPT);
        (MOST_WORK - left, left_out)
    }

    #[test]
    fn kept_runs_beyond_the_most_cost_nothing() {
        // A run of 20 s takes twice the work of one of 10 s.
        let (ten, all) = (cost("1&t=10").0, 1 + 2 * MOST_KEPT as u64);
        assert!(ten > 1000, "more than an operation for each of 1000 steps: {ten}");
        assert_eq!(cost(&format!("1&t=10{}", "&k&t=20".repeat(MOST_KEPT))), (ten * all, 0));
        assert_eq!(cost(&format!("1&t=10{}", "&k&t=20".repeat(MOST_KEPT + 1))), (ten * all, 1));
        let many = format!("1&t=10{}", "&k&t=20".repeat(100_000));
        assert_eq!(cost(&many), (ten * all, MOST_NAMED + 1));
    }

    #[test]
    fn all_runs_of_a_link_share_one_budget() {
        let ten = cost("1&t=10").0;
        let time = 10 * (MOST_WORK * 2 / 5 / ten);
        let long = format!("1&t={time}{}", format!("&k&t={time}").repeat(MOST_KEPT));
        assert_eq!(
            cost(&long),
            (MOST_WORK, MOST_KEPT - 1),
            "the present run, one whole kept run and a part of the next"
        );
        assert_eq!(cost("1&h=1e-9&t=1&k&t=1"), (MOST_WORK, 2));
        assert_eq!(cost("1&c=100,k:2&c=200,k:3&t=3"), (3 * ten / 10, 0));
    }

    #[test]
    fn what_is_left_out_is_named_up_to_a_length() {
        assert_eq!(cost(&format!("1{}", "&zzz".repeat(100_000))).1, MOST_NAMED + 1);
        assert_eq!(cost(&format!("1&p={}", "q:1,".repeat(100_000))).1, MOST_NAMED + 1);
    }
}
