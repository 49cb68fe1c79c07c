//! What is read off: time, states and quantities with their units; the pitch.

use crate::{Play, number, words};
use program::{Compiled, Kind, Node, NodeId, Role};
use units::Unit;
use units::number::Group;

/// What a readout shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadoutKind {
    /// The independent variable.
    Independent,
    /// State of this number.
    State(usize),
    /// Quantity of this number.
    Quantity(usize),
}

/// One value with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Readout {
    /// What it is.
    pub kind: ReadoutKind,
    /// The ASCII name, `omega_0`, `y'`.
    pub name: String,
    /// The label in the chosen language; empty where the author gave none.
    pub label: String,
    /// Whether the name is a symbol to be shown beside the label, and not a word of the author's language.
    pub has_symbol: bool,
    /// The value in the unit; a dash when it is not finite; a text in the chosen language.
    pub value: String,
    /// The unit for people; empty for a pure number, a text or a truth value.
    pub unit: String,
    /// Whether it changes while the parameters do not.
    pub varies: bool,
    /// Whether a question hides the value; a word stands in its place.
    pub hidden: bool,
}

/// Significant digits of a value that moves.
pub(crate) const MOVING_DIGITS: usize = 4;

/// Digits of a count; beyond these it is not exact.
const COUNT_DIGITS: usize = 15;

impl Play {
    /// Everything that can be read off at the time shown: the independent variable, the states, the quantities.
    pub fn readouts(&mut self) -> Vec<Readout> {
        let model = &self.program.model;
        let (time, unit) = match self.small_times() {
            Some(group) => (group.number(self.course.time()), group.unit_text()),
            None => (self.time_number(self.course.time()), number::unit_text(&model.independent.unit.text)),
        };
        let mut readouts = vec![Readout {
            kind: ReadoutKind::Independent,
            name: model.independent.name.clone(),
            label: String::new(),
            has_symbol: true,
            value: time,
            unit,
            varies: true,
            hidden: false,
        }];
        for (index, state) in model.states.iter().enumerate().filter(|(_, state)| state.role == Role::Own) {
            let value = self.course.state().get(index).copied().unwrap_or(f64::NAN);
            let scale = self.scales.get(index).copied().unwrap_or_default();
            let node = model.graph.find(Node::State(index as u32));
            let (value, unit) = self.moving(value, scale, node, &state.unit);
            readouts.push(Readout {
                kind: ReadoutKind::State(index),
                name: state.name(),
                label: state.label.as_deref().map_or("", |label| self.text(label)).to_owned(),
                has_symbol: has_symbol(&state.name(), state.label.as_deref(), Kind::Number),
                value,
                unit,
                varies: true,
                hidden: false,
            });
        }
        let values = self.quantity_values();
        let quantities = self.program.model.quantities.iter().zip(&values).enumerate();
        for (index, (quantity, &value)) in
            quantities.filter(|(_, (quantity, _))| !quantity.is_remembered() && !quantity.hidden)
        {
            let scale = self.scales.get(self.program.model.states.len() + index).copied().unwrap_or_default();
            let unit = &quantity.value.unit;
            let hidden = self.is_hidden(index);
            let (value, unit) = match quantity.value.kind {
                _ if hidden => (words::hidden(self.language).to_owned(), String::new()),
                Kind::Number if quantity.varies => self.moving(value, scale, Some(quantity.value.node), unit),
                Kind::Number => self.constant(value, quantity.value.node, unit),
                Kind::Truth | Kind::Text => (self.word_value(&quantity.value, value), number::unit_text(&unit.text)),
            };
            readouts.push(Readout {
                kind: ReadoutKind::Quantity(index),
                name: quantity.name.clone(),
                label: quantity.label.as_deref().map_or("", |label| self.text(label)).to_owned(),
                has_symbol: has_symbol(&quantity.name, quantity.label.as_deref(), quantity.value.kind),
                value,
                unit,
                varies: quantity.varies,
                hidden,
            });
        }
        readouts.extend(self.friction_readouts());
        readouts
    }

    /// Whether each dry friction holds or slides.
    fn friction_readouts(&self) -> impl Iterator<Item = Readout> {
        let states = self.program.model.states.iter().zip(self.course.state()).enumerate();
        let frictions = states.filter(|(_, (state, _))| state.role == Role::Friction);
        let several = frictions.clone().nth(1).is_some();
        frictions.map(move |(index, (state, &motion))| {
            let label = words::dry_friction(self.language);
            Readout {
                kind: ReadoutKind::State(index),
                name: state.name(),
                label: if several { format!("{label}: {}", state.name()) } else { label.to_owned() },
                has_symbol: false,
                value: words::sticks(self.language, motion == 0.0).to_owned(),
                unit: String::new(),
                varies: true,
                hidden: false,
            }
        })
    }

    /// The number and the unit of a value that has had the size `scale` in this run, both SI. What is nothing beside it is
    /// zero.
    fn moving(&self, value: f64, scale: f64, node: Option<NodeId>, unit: &Unit) -> (String, String) {
        if node.is_some_and(|node| self.is_count(node, unit)) {
            return (self.count(value), number::unit_text(&unit.text));
        }
        let group = Group::of_scale(unit, scale.max(value.abs()), MOVING_DIGITS, self.style);
        (group.number(value), group.unit_text())
    }

    /// The same of a value that stands still.
    fn constant(&self, value: f64, node: NodeId, unit: &Unit) -> (String, String) {
        if self.is_count(node, unit) {
            return (self.count(value), number::unit_text(&unit.text));
        }
        let unit = unit.for_size(unit.from_si(value).abs());
        (number::plain(unit.from_si(value), MOVING_DIGITS, self.style), number::unit_text(&unit.text))
    }

    /// The pitch in hertz at which the first state sounds while the run is playing or held: 440 Hz at 0, an octave up or
    /// down at the greatest value it has had in this run. `None` while there is nothing to hear.
    pub fn pitch(&self) -> Option<f64> {
        let (&value, &scale) = (self.course.state().first()?, self.scales.first()?);
        let sounding = (self.playing || self.hold.is_some()) && value.is_finite() && scale > 0.0;
        sounding.then(|| 440.0 * libm::exp2((value / scale).clamp(-1.0, 1.0)))
    }

    fn quantity_values(&mut self) -> Vec<f64> {
        let course = &self.course;
        let values =
            self.evaluators.quantities.at(course.parameters(), course.initial(), course.time(), course.state());
        let states = self.program.model.states.len();
        for (scale, value) in self.scales.iter_mut().skip(states).zip(values) {
            if value.is_finite() {
                *scale = scale.max(value.abs());
            }
        }
        values.to_vec()
    }

    /// Whether a value is a whole number and shown as such.
    pub(crate) fn is_count(&self, node: NodeId, unit: &Unit) -> bool {
        unit.text.is_empty() && self.whole.get(node.0 as usize).is_some_and(|whole| *whole)
    }

    /// A whole number, all of its digits.
    pub(crate) fn count(&self, value: f64) -> String {
        number::plain(value, COUNT_DIGITS, self.style)
    }

    /// A text or truth value in the chosen language.
    pub(super) fn word_value(&self, compiled: &Compiled, value: f64) -> String {
        if !value.is_finite() {
            return number::DASH.to_owned();
        }
        match compiled.kind {
            Kind::Text => {
                self.model().texts.get(value as usize).map_or(number::DASH, |text| self.text(text)).to_owned()
            }
            _ => words::truth(self.language, value != 0.0).to_owned(),
        }
    }
}

/// No formula holds the name of a text or a truth value, and `power` beside "Power" says nothing new, nor beside its
/// translation. Without a label the name is all there is.
fn has_symbol(name: &str, label: Option<&str>, kind: Kind) -> bool {
    label.is_none_or(|label| kind == Kind::Number && !name.eq_ignore_ascii_case(label))
}
