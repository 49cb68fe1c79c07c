//! The model over the film: where it would be in the picture of each frame, and which frame shows one of its times.

use crate::Desk;
use crate::films::record::table;
use crate::films::work::Work;
use crate::records::recognise::observed;
use crate::records::record::{Record, Use};
use engine::Readings;
use film::tracking::Track;
use units::Unit;

/// The readings of the model's quantities behind the columns of a track, each with what the column is taken for.
struct Model {
    readings: Readings,
    /// For `x` and `y` of a body, or for the level of a surface: which reading, and how it becomes a number of the column.
    coordinates: Vec<Option<(usize, Unit, f64)>>,
}

impl Desk {
    /// Where the model is in a frame of the open film, in pixels of the upright picture: by the quantities that the columns of this
    /// track measure, and the origin that a fit has found. A coordinate that the model does not have is the measured one. `None`
    /// where the run has not come there, without a record, and where no column measures a quantity of the model.
    pub fn film_model_at(&mut self, track: usize, frame: usize) -> Option<[f64; 2]> {
        self.film_model(track, &[frame]).into_iter().next().flatten()
    }

    /// The same in several frames: the curve over a space-time picture.
    pub fn film_model(&mut self, track: usize, frames: &[usize]) -> Vec<Option<[f64; 2]>> {
        let nothing = || vec![None; frames.len()];
        let Some((_, work)) = self.films.current() else { return nothing() };
        let work = work.clone();
        let (Some(mut model), Some(own)) = (self.film_quantities(&work, track), work.tracks().into_iter().nth(track))
        else {
            return nothing();
        };
        let mut state = vec![0.0; self.play.model().states.len()];
        let mut place = |frame: &usize| {
            let time = self.model_time_of(*frame)?;
            if !(0.0..=self.play.course().front()).contains(&time) {
                return None;
            }
            let parameters = self.play.state_at(time, &mut state)?;
            let values = model.readings.at(&parameters, self.play.course().initial(), time, &state);
            let number = |k: usize| {
                let (reading, unit, offset) = model.coordinates.get(k)?.as_ref()?;
                values.get(*reading).map(|value| unit.from_si(value + offset)).filter(|value| value.is_finite())
            };
            position(&work, &own, *frame, [number(0), number(1)])
        };
        frames.iter().map(&mut place).collect()
    }

    /// The time of the model, SI, at which a frame of the open film was taken.
    pub fn model_time_of(&self, frame: usize) -> Option<f64> {
        let (open, work) = self.films.current()?;
        let taken = open.clip.times().get(frame)? / work.factor();
        Some(taken - self.film_origin(work)?)
    }

    /// The frame of the open film that was taken nearest to a time of the model, SI.
    pub fn frame_at_model_time(&self, time: f64) -> Option<usize> {
        let (open, work) = self.films.current()?;
        let shown = (time + self.film_origin(work)?) * work.factor();
        let times = open.clip.times();
        let next = times.partition_point(|other| *other < shown);
        let far = |frame: &usize| times.get(*frame).map_or(f64::INFINITY, |other| (other - shown).abs());
        [next.saturating_sub(1), next]
            .into_iter()
            .filter(|frame| *frame < times.len())
            .min_by(|one, other| far(one).total_cmp(&far(other)))
    }

    fn film_origin(&self, work: &Work) -> Option<f64> {
        let model = self.play.model();
        Some(self.record(work.record?)?.origin(&model.independent.name, model.is_autonomous()))
    }

    fn film_quantities(&self, work: &Work, track: usize) -> Option<Model> {
        let record = self.record(work.record?)?;
        let model = self.play.model();
        let table = table(work)?;
        // The columns stand in the order of the table: the time, then values and errors of each track.
        let before: usize = table.quantities.iter().take(track).map(|own| 2 * own.len()).sum();
        let mut nodes = Vec::new();
        let coordinates: Vec<_> = (0..table.quantities.get(track)?.len())
            .map(|k| {
                let used = use_of(record, 1 + before + k, &model.independent.name)?;
                let observed = observed(model, &used.meaning.quantity)?;
                if observed.dimension() != used.meaning.unit.dimension {
                    return None;
                }
                nodes.push(observed.node);
                Some((nodes.len() - 1, used.meaning.unit.clone(), used.offset))
            })
            .collect();
        let known = coordinates.iter().any(Option::is_some);
        known.then(|| Model { readings: Readings::new(model, &nodes), coordinates })
    }
}

/// What a column is taken for, if it measures something and its unit is known.
fn use_of<'a>(record: &'a Record, column: usize, independent: &str) -> Option<&'a Use> {
    let used = record.uses.get(column)?;
    let quantity = &used.meaning.quantity;
    let measures = !quantity.is_empty() && quantity != independent && !record.asks_for_unit(&record.uses, column);
    measures.then_some(used)
}

/// The pixel of these coordinates, as the record has them.
pub(super) fn position(
    work: &Work,
    track: &Track,
    frame: usize,
    [first, second]: [Option<f64>; 2],
) -> Option<[f64; 2]> {
    let calibration = &work.calibration;
    let near = track.points.partition_point(|point| point.frame < frame).min(track.points.len().checked_sub(1)?);
    let measured = calibration.apply(track.points.get(near)?.position);
    let place = match track.direction {
        None if first.is_none() && second.is_none() => return None,
        None => [first.unwrap_or(measured[0]), second.unwrap_or(measured[1])],
        Some(direction) => {
            let (up, _) = calibration.upwards_along(direction);
            let further = first? - (measured[0] * up[0] + measured[1] * up[1]);
            [measured[0] + further * up[0], measured[1] + further * up[1]]
        }
    };
    Some(calibration.undo(place)).filter(|place| place.iter().all(|part| part.is_finite()))
}
