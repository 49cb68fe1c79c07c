//! Comparison of film and model: position of the model in the picture of a frame, and the frame of a model time.

use crate::films::record::table;
use crate::films::work::Work;
use crate::films::{Films, ShownFilms};
use crate::opened::OpenDocument;
use crate::records::Records;
use crate::records::recognise::observed;
use crate::records::record::{Record, Use};
use document::Document;
use engine::Readings;
use film::tracking::Track;
use play::Play;
use units::Unit;

/// Readings of the quantities that the columns of a track measure.
struct Model {
    readings: Readings,
    /// For `x` and `y` of a body, or for the level of a surface: index of the reading, unit of the column, and offset
    /// (SI).
    coordinates: Vec<Option<(usize, Unit, f64)>>,
}

impl Films {
    /// Positions of the model in frames of the open film, px of the upright picture. They use the quantities that the
    /// columns of this track measure, and the time origin of the record. A coordinate without a quantity in the model is
    /// the measured one. `None` if the run has not reached the time, without a record, or if no column measures a
    /// quantity of the model.
    pub(crate) fn model(
        &self,
        play: &mut Play,
        document: &Document,
        records: &Records,
        track: usize,
        frames: &[usize],
    ) -> Vec<Option<[f64; 2]>> {
        let nothing = || vec![None; frames.len()];
        let Some((_, work)) = self.current() else { return nothing() };
        let (Some(mut model), Some(own)) = (
            self.shown(OpenDocument { play, document }, records).quantities(work, track),
            work.tracks().into_iter().nth(track),
        ) else {
            return nothing();
        };
        let mut state = vec![0.0; play.model().states.len()];
        let mut place = |frame: &usize| {
            let time = self.shown(OpenDocument { play, document }, records).model_time_of(*frame)?;
            if !(0.0..=play.course().front()).contains(&time) {
                return None;
            }
            let parameters = play.change_run(|line, _| line.state_at(time, &mut state))?;
            let values = model.readings.at(&parameters, play.course().initial(), time, &state);
            let number = |k: usize| {
                let (reading, unit, offset) = model.coordinates.get(k)?.as_ref()?;
                values.get(*reading).map(|value| unit.from_si(value + offset)).filter(|value| value.is_finite())
            };
            position(work, &own, *frame, [number(0), number(1)])
        };
        frames.iter().map(&mut place).collect()
    }
}

impl ShownFilms<'_> {
    /// Model time (SI) of a frame of the open film.
    pub fn model_time_of(self, frame: usize) -> Option<f64> {
        let (open, work) = self.films.current()?;
        let taken = open.clip.times().get(frame)? / work.factor();
        Some(taken - self.origin_of(work)?)
    }

    /// Frame of the open film nearest to a model time (SI).
    pub fn frame_at_model_time(self, time: f64) -> Option<usize> {
        let (open, work) = self.films.current()?;
        let shown = (time + self.origin_of(work)?) * work.factor();
        let times = open.clip.times();
        let next = times.partition_point(|other| *other < shown);
        let far = |frame: &usize| times.get(*frame).map_or(f64::INFINITY, |other| (other - shown).abs());
        [next.saturating_sub(1), next]
            .into_iter()
            .filter(|frame| *frame < times.len())
            .min_by(|one, other| far(one).total_cmp(&far(other)))
    }

    fn origin_of(self, work: &Work) -> Option<f64> {
        let model = self.play.model();
        Some(self.records.get(work.record?)?.origin(&model.independent, model.is_autonomous()))
    }

    fn quantities(self, work: &Work, track: usize) -> Option<Model> {
        let record = self.records.get(work.record?)?;
        let model = self.play.model();
        let table = table(work)?;
        // Order of the columns: the time, then values and errors of each track.
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

/// Use of a column, if it measures a quantity and its unit is known.
fn use_of<'a>(record: &'a Record, column: usize, independent: &str) -> Option<&'a Use> {
    let used = record.uses().get(column)?;
    let quantity = &used.meaning.quantity;
    let measures = !quantity.is_empty() && quantity != independent && !record.asks_for_unit(record.uses(), column);
    measures.then_some(used)
}

/// Position in px of the given coordinates, in the unit of the record. Missing coordinates of a body are those of the
/// nearest point.
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
