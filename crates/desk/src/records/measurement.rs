//! Virtual measurement: a noisy record of a simulated run, whose true parameters are known.

use crate::records::Records;
use crate::records::recognise::observed;
use crate::{Changes, OpenDocument, Refusal, number};
use analysis::virtual_record::{Camera, tracked_velocities};
use engine::{Advance, Method, Readings, Run, Setup};
use play::Play;
use program::NodeId;
use std::fmt::Write as _;

/// Typed settings of a virtual measurement: numbers in the units of [`measurement_units`], or with a unit of
/// their own.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasurementForm {
    /// Name of the filmed quantity, such as `y`.
    pub quantity: String,
    /// Texts of the fields, in the order given at [`MEASUREMENT_FIELDS`].
    pub fields: [String; MEASUREMENT_FIELDS],
}

/// Number of fields: frame rate, duration, pixel size, noise, jitter of the frames, error of the scale, seed.
pub const MEASUREMENT_FIELDS: usize = 7;

/// Maximum work of the simulated run, in floating-point operations: one or two seconds.
const MOST_WORK: u64 = 500_000_000;

/// Rows of the run per frame. Interpolation between them is accurate to far less than a pixel.
const ROWS_PER_FRAME: f64 = 4.0;

impl MeasurementForm {
    /// Default settings of a virtual measurement: a camera that suits the run.
    pub fn suited(play: &Play) -> Self {
        let (Some(state), independent) = (play.model().states.first(), &play.model().independent) else {
            return Self::default();
        };
        let greatest = |index: usize| play.time_line().greatest(index);
        let start = play.course().initial().first().map_or(0.0, |value| value.abs());
        let size = [greatest(0), start].into_iter().filter(|size| size.is_finite()).fold(0.0, f64::max);
        let size = if size > 0.0 { size } else { 1.0 };
        // The amplitude then covers about 100 pixels, the whole swing about 200.
        let pixel = number::roundest(size / 120.0, size / 80.0);
        let duration = independent.unit.to_si(10.0);
        let shown = |value: f64| number::plain(value, 6, play.basis().style());
        Self {
            quantity: state.name(),
            fields: [
                shown(independent.unit.to_si(30.0)),
                shown(independent.unit.from_si(play.course().front().max(duration))),
                shown(fine(&state.unit).from_si(pixel)),
                shown(fine(&state.unit).from_si(pixel / 2.0)),
                shown(0.0),
                shown(0.0),
                shown(1.0),
            ],
        }
    }
}

/// Unit of each field for the filmed quantity.
pub fn measurement_units(play: &Play, quantity: &str) -> [String; MEASUREMENT_FIELDS] {
    let unit = |unit: &units::Unit| number::unit_text(&unit.text);
    let time = unit(&play.model().independent.unit);
    let own = observed(play.model(), quantity).map(|observed| unit(&fine(&observed.unit))).unwrap_or_default();
    let rate = if time.is_empty() { String::new() } else { format!("1/{time}") };
    [rate, time.clone(), own.clone(), own, time, "%".to_owned(), String::new()]
}

impl Records {
    /// Makes a virtual measurement and adds it as a record of this name. Returns the id of the record.
    ///
    /// # Errors
    /// The index of the rejected field, and the reason.
    pub fn measure(
        &mut self,
        open: OpenDocument<'_>,
        name: &str,
        form: &MeasurementForm,
    ) -> Result<(u32, Changes), (usize, Refusal)> {
        let camera = camera(open.play, form)?;
        let text = measured_text(open.play, &form.quantity, &camera).map_err(|refusal| (0, refusal))?;
        self.insert(open, name, text.as_bytes(), Some(truth_of(open.play))).map_err(|refusal| (0, refusal))
    }
}

/// Names and values of the parameters, SI.
pub(super) fn truth_of(play: &Play) -> Vec<(String, f64)> {
    play.basis().parameters(play.course()).into_iter().map(|one| (one.name, one.value)).collect()
}

fn camera(play: &Play, form: &MeasurementForm) -> Result<Camera, (usize, Refusal)> {
    let time = &play.model().independent.unit;
    let observed =
        observed(play.model(), &form.quantity).ok_or_else(|| (0, Refusal::unknown(form.quantity.as_str())))?;
    let fine = fine(&observed.unit);
    let [rate, duration, pixel, noise, jitter, scale, seed] = &form.fields;
    let percent = units::Unit::parse("%").unwrap_or_else(|_| units::Unit::dimensionless());
    let read = |field: usize, typed: &str, unit: &units::Unit, least: f64| -> Result<f64, (usize, Refusal)> {
        let value = play.basis().read_value(typed, unit).map_err(|refusal| (field, refusal.into()))?;
        if value > least || (field > 1 && value >= 0.0) || field == 5 {
            Ok(value)
        } else {
            Err((field, play::Refusal::NotPositive.into()))
        }
    };
    let style = play.basis().style();
    let seed = number::typed::whole(seed, 0..=i64::from(u32::MAX), style)
        .map_err(|why| (6, play::Refusal::from(why).into()))?;
    Ok(Camera {
        rate: read(0, rate, &per(time), 0.0)?,
        duration: read(1, duration, time, 0.0)?,
        pixel: read(2, pixel, &fine, 0.0)?,
        noise: read(3, noise, &fine, 0.0)?,
        jitter: read(4, jitter, time, 0.0)?,
        scale: read(5, scale, &percent, f64::NEG_INFINITY)?,
        seed: seed.unsigned_abs(),
    })
}

/// The unit of a rate: one over the unit of time.
fn per(time: &units::Unit) -> units::Unit {
    let unit = (!time.text.is_empty()).then(|| units::Unit::parse(&format!("1/({})", time.text)).ok());
    unit.flatten().unwrap_or_else(units::Unit::dimensionless)
}

/// Text of a virtual measurement of a run with the present parameters and initial values: a table as written by
/// tracking programs, with the velocities that they compute. Settings of `camera` in SI units.
pub(super) fn measured_text(play: &Play, quantity: &str, camera: &Camera) -> Result<String, Refusal> {
    let model = play.model();
    let observed = observed(model, quantity).ok_or_else(|| Refusal::unknown(quantity))?;
    let setup = Setup { parameters: play.course().parameters().to_vec(), ..play.course().begun().clone() };
    let nothing = |_| play::Refusal::NoValue { name: quantity.to_owned() };
    // Uses the most exact method; if the equations do not allow it, the method of the document.
    let step = 1.0 / (camera.rate * ROWS_PER_FRAME);
    let exact = Setup { method: Method::DormandPrince, tolerance: 1e-10, step, ..setup.clone() };
    let end = camera.times().last().copied().unwrap_or_default();
    let run = recorded(model, exact, end, MOST_WORK).or_else(|_| recorded(model, setup, end, MOST_WORK));
    let mut run = run.map_err(nothing)?;
    let values = camera.read(value_at(model, &mut run, observed.node, play.course().parameters()));
    let times = camera.times();
    let time_unit = &model.independent.unit;
    let rate = quantity_rate(model, quantity);
    let velocities = rate.as_ref().map(|_| tracked_velocities(&times, &values)).unwrap_or_default();
    let head = |name: &str, unit: &units::Unit| {
        if unit.text.is_empty() { name.to_owned() } else { format!("{name} [{}]", unit.text) }
    };
    let mut text = format!("{}\t{}", head(&model.independent.name, time_unit), head(quantity, &observed.unit));
    if let Some((name, unit)) = &rate {
        let _ = write!(text, "\t{}", head(name, unit));
    }
    text.push('\n');
    for (row, (time, value)) in times.iter().zip(&values).enumerate() {
        let _ = write!(text, "{}\t{:.9e}", time_unit.from_si(*time), observed.unit.from_si(*value));
        if let (Some((_, unit)), Some(velocity)) = (&rate, velocities.get(row)) {
            let _ =
                if velocity.is_nan() { write!(text, "\t") } else { write!(text, "\t{:.9e}", unit.from_si(*velocity)) };
        }
        text.push('\n');
    }
    Ok(text)
}
/// Unit of pixel size and noise: one thousandth of the quantity's unit if that has a prefixed form, otherwise the unit
/// itself.
fn fine(unit: &units::Unit) -> units::Unit {
    let thousandth = units::Unit::parse(&format!("m{}", unit.text)).ok();
    thousandth.filter(|fine| fine.dimension == unit.dimension).unwrap_or_else(|| unit.clone())
}

/// Name and unit of the time derivative of the filmed quantity; `v` for a length that is not an unknown of the model.
fn quantity_rate(model: &program::Model, quantity: &str) -> Option<(String, units::Unit)> {
    let name = format!("{quantity}'");
    if let Some(rate) = observed(model, &name) {
        return Some((name, rate.unit));
    }
    let dimension = observed(model, quantity)?.dimension();
    let rate = dimension.per(model.independent.unit.dimension)?;
    (dimension == units::Dimension::LENGTH).then(|| ("v".to_owned(), units::Unit::si(rate)))
}

/// Value of a quantity of a run with these parameters at a time, all SI.
pub(crate) fn value_at<'a>(
    model: &'a program::Model,
    run: &'a mut Run,
    quantity: NodeId,
    parameters: &'a [f64],
) -> impl FnMut(f64) -> f64 + 'a {
    let mut readings = Readings::new(model, &[quantity]);
    let mut state = vec![0.0; model.states.len()];
    move |time| {
        run.interpolate(time, &mut state);
        readings.at(parameters, run.initial(), time, &state).first().copied().unwrap_or(f64::NAN)
    }
}

/// Simulates a run up to time `end`, SI. Fails if the work exceeds `most_work` floating-point operations or the run stops earlier.
pub(crate) fn recorded(model: &program::Model, setup: Setup, end: f64, most_work: u64) -> Result<Run, ()> {
    let mut run = Run::start(model, setup).map_err(|_| ())?;
    while run.time() < end {
        let left = most_work.checked_sub(run.work()).ok_or(())?;
        if !matches!(run.advance_within(left), Ok(Advance::Step | Advance::Event)) {
            return Err(());
        }
    }
    // An event that ends the run at `end` does not affect the rows before.
    let _ = run.finish(end);
    Ok(run)
}
