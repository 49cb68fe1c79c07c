//! Restores a state from the text written by [`Play::share`].

use super::share::MOST_CHANGES;
use crate::controls::button::read;
use crate::controls::drawing;
use crate::share::link::{VERSION, decode, encode};
use crate::time::recipe::{Change, Moments, Recipe};
use crate::{Announcement, Changes, MOST_KEPT, Play, Refusal};
use engine::Method;
use figure::{Interval, View};
use units::number::compact as exact;

/// Maximum work for all recomputed runs together, in floating-point operations. A link may come from a stranger, and
/// the page is blocked meanwhile: about a second on a slow phone.
pub(super) const MOST_WORK: u64 = 50_000_000;

/// Maximum number of rows of a run in a link, because recording a row takes time.
const MOST_ROWS: usize = 2_500_000;

/// Maximum number of omitted parts that a refusal names individually.
const MOST_NAMED: usize = 12;

impl Play {
    /// Restores a state. Parts that do not fit the document are omitted and named in the refusal; the rest is applied.
    ///
    /// # Errors
    ///
    /// A text that is not a state, or parts that do not fit: an unknown key, a value out of range, too many kept runs,
    /// a run that exceeds the work limit of a link.
    pub fn restore(&mut self, fragment: &str) -> Result<(), Refusal> {
        self.restore_within(fragment, MOST_CHANGES, &mut { MOST_WORK })
    }

    /// Restores a state with at most `most_changes` changes in each run, and the work limit `work` for all runs
    /// together, in floating-point operations; it is reduced by the work done.
    pub(super) fn restore_within(
        &mut self,
        fragment: &str,
        most_changes: usize,
        work: &mut u64,
    ) -> Result<(), Refusal> {
        let fragment = fragment.trim_start_matches('#');
        if fragment.is_empty() {
            return Ok(());
        }
        let mut fields = fragment.split('&');
        if fields.next() != Some(VERSION) {
            return Err(Refusal::UnreadableState);
        }
        let changes = self.line.set_speed(1.0);
        self.note(changes);
        let changes = self.plots.reset_all();
        self.note(changes);
        let fields: Vec<&str> = fields.collect();
        self.restore_seat(&fields);
        let mut reader = Reader { play: self, most_changes, left_out: Vec::new() };
        let mut sections = fields.split(|field| *field == "k");
        let present = reader.recipe(sections.next().unwrap_or_default());
        // Limited before anything is computed: a link can name far more runs than can be kept.
        let kept: Vec<Recipe> = sections.by_ref().take(MOST_KEPT).map(|section| reader.recipe(section)).collect();
        let mut left_out = reader.left_out;
        left_out.extend(sections.map(|_| "k".to_owned()).take(MOST_NAMED + 1));
        self.adopt_drawings(&present.setup.drawings);
        let (course, complete) = self.line.replay(&self.basis, &present, Moments::Rows, work);
        if !complete {
            left_out.push(format!("t={}", exact(present.front)));
        }
        self.stop();
        self.controls.hold(None);
        let changes = self.line.forget_runs();
        self.note(changes);
        self.replace_course(course);
        for recipe in &kept {
            let kept = self.line.keep_recipe(&self.basis, recipe, work);
            self.note(kept.as_ref().map_or(Changes::NONE, |(_, changes)| *changes));
            if !kept.is_ok_and(|(complete, _)| complete) {
                left_out.push(format!("k, t={}", exact(recipe.front)));
            }
        }
        self.announcements.clear();
        self.announce(Announcement::Restored);
        if left_out.len() > MOST_NAMED {
            left_out.truncate(MOST_NAMED);
            left_out.push("…".to_owned());
        }
        if left_out.is_empty() { Ok(()) } else { Err(Refusal::PartlyRestored { left_out }) }
    }
}

impl Play {
    /// Takes the seat of a link before its other fields. A link without a seat leaves the present one.
    fn restore_seat(&mut self, fields: &[&str]) {
        let seat = fields.iter().find_map(|field| field.strip_prefix("seat=")?.parse().ok());
        if seat.is_some() {
            self.basis.set_seat(seat);
        }
    }
}

/// Parser of fields; collects the parts that do not fit.
struct Reader<'a> {
    play: &'a mut Play,
    most_changes: usize,
    left_out: Vec<String>,
}

impl Reader<'_> {
    fn recipe(&mut self, fields: &[&str]) -> Recipe {
        let mut recipe =
            Recipe { setup: self.play.basis.defaults().clone(), changes: Vec::new(), front: 0.0, time: f64::NAN };
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
                    let size = self.play.model().sizes.iter().find(|size| size.name == name)?;
                    (value.parse() == Ok(size.value)).then_some(())
                };
                return value.split(',').map(is_so).collect();
            }
            // Read first: the values of a recipe differ from those of the seat.
            "seat" => return (self.play.program().seat == Some(value.parse().ok()?)).then_some(()),
            "y" => {
                let start: Vec<f64> = value.split(',').map(number).collect::<Option<_>>()?;
                if start.len() != self.play.model().states.len() {
                    return None;
                }
                recipe.setup.start = Some(start);
            }
            "m" => recipe.setup.method = value.parse::<Method>().ok()?,
            "h" => recipe.setup.step = number(value).filter(|&step| step > 0.0)?,
            "a" => {
                let (index, values) = drawing::read(self.play.model(), value)?;
                *recipe.setup.drawings.get_mut(index)? = values;
            }
            "b" => recipe.setup.presses = read(value, &self.play.model().buttons, encode)?,
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
            "x" => self.play.set_speed(number(value)?),
            "w" => self.play.show_hidden(true),
            "v" => {
                let hidden = value.split(',').filter(|index| !index.is_empty()).map(|index| index.parse().ok());
                let changes = self.play.plots.show_except(hidden)?;
                self.play.note(changes);
            }
            "z" => {
                let (index, limits) = value.split_once(',')?;
                let changes = self.play.plots.set_view(index.parse().ok()?, view(limits)?)?;
                self.play.note(changes);
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
                let index = self.play.model().parameters.iter().position(|parameter| parameter.name == name)?;
                let parameter = self.play.model().parameters.get(index)?;
                let value = match parameter.choices {
                    program::Choices::Numbers | program::Choices::Seed => number(value)?,
                    _ => parameter.chosen(&decode(value)?, &self.play.model().texts)?,
                };
                Some((index, self.play.basis.admit(index, value).ok()?))
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
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::{MOST_CHANGES, MOST_NAMED, MOST_WORK};
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
