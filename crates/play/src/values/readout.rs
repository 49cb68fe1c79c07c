//! What is read off: time, states and quantities with their units; the pitch.

use super::lines::{Line, Member};
use super::members::{Members, ReadoutKind};
use crate::{Play, number, words};
use program::{Compiled, Kind, Node, NodeId, Role};
use units::Unit;
use units::mathml::{self, typeset_name};
use units::number::Group;

/// One value with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Readout {
    /// What it is.
    pub kind: ReadoutKind,
    /// The ASCII name, `omega_0`, `y'`, `x[3]`; of a vector the name without component.
    pub name: String,
    /// The label in the chosen language; empty where the author gave none.
    pub label: String,
    /// The name as MathML, of a member of a family without its index. Empty where it is a word of the author's language that
    /// says no more than the label.
    pub symbol: String,
    /// The family of whose members this one is shown.
    pub members: Option<Members>,
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

/// One value of a line, before it is written.
struct Part<'a> {
    value: f64,
    /// The greatest size that it has had in this run, SI.
    scale: f64,
    node: Option<NodeId>,
    unit: &'a Unit,
    name: String,
    label: Option<&'a str>,
    varies: bool,
    hidden: bool,
    /// A text or truth value as such.
    word: Option<&'a Compiled>,
}

impl Play {
    /// Everything that can be read off at the time shown: the independent variable, the states, the quantities. A vector is one
    /// value, and of a family the member that is chosen is shown ([`Play::choose_member`]).
    pub fn readouts(&mut self) -> Vec<Readout> {
        let values = self.quantity_values();
        let mut readouts = vec![self.time_readout()];
        let lines = self.lines.readouts.iter().filter_map(|line| self.line_readout(line, &values));
        readouts.extend(lines);
        readouts.extend(self.friction_readouts());
        readouts
    }

    fn time_readout(&self) -> Readout {
        let independent = &self.program.model.independent;
        let (value, unit) = match self.small_times() {
            Some(group) => (group.number(self.course.time()), group.unit_text()),
            None => (self.time_number(self.course.time()), number::unit_text(&independent.unit.text)),
        };
        Readout {
            kind: ReadoutKind::Independent,
            name: independent.name.clone(),
            label: String::new(),
            symbol: typeset_name(&independent.name),
            members: None,
            value,
            unit,
            varies: true,
            hidden: false,
        }
    }

    fn line_readout(&self, line: &Line<ReadoutKind>, values: &[f64]) -> Option<Readout> {
        let member = line.member(self.lines.chosen_of(line))?;
        let parts: Vec<Part> = member.parts.iter().filter_map(|&kind| self.part(kind, values)).collect();
        let first = parts.first()?;
        let hidden = parts.iter().any(|part| part.hidden);
        let (value, unit) = match (first.word, parts.as_slice()) {
            _ if hidden => (words::hidden(self.language).to_owned(), String::new()),
            (Some(word), _) => (self.word_value(word, first.value), number::unit_text(&first.unit.text)),
            (None, [one]) if !member.is_vector && one.varies => self.moving(one.value, one.scale, one.node, one.unit),
            (None, [one]) if !member.is_vector => self.constant(one.value, one.node, one.unit),
            _ => self.vector(&parts, first.unit),
        };
        let members = self.lines.family(line);
        let label_of = |member: &Member<ReadoutKind>| self.line_label(&member.parts, member.is_vector);
        // The first member that has a label tells what the family is.
        let label = label_of(member).or_else(|| line.members.iter().find_map(label_of)).unwrap_or_default();
        let own = if member.is_vector || members.is_some() { line.name() } else { first.name.clone() };
        let shows_symbol = label.is_empty()
            || first.word.is_none() && first.label.is_none_or(|label| !own.eq_ignore_ascii_case(label));
        let order = u32::try_from(line.primes.len()).unwrap_or_default();
        let symbol = match shows_symbol {
            false => String::new(),
            true if member.is_vector => format!("<math>{}</math>", mathml::vector(&line.stem, &[], order, None)),
            true => typeset_name(&own),
        };
        let kind = *member.parts.first()?;
        let varies = line.members.iter().flat_map(|member| &member.parts).any(|&kind| self.varies(kind));
        let name = if member.is_vector { vector_name(&first.name) } else { first.name.clone() };
        Some(Readout { kind, name, label, symbol, members, value, unit, varies, hidden })
    }

    /// A value with what is needed to write it.
    fn part(&self, kind: ReadoutKind, values: &[f64]) -> Option<Part<'_>> {
        let model = &self.program.model;
        Some(match kind {
            ReadoutKind::Independent => return None,
            ReadoutKind::State(index) => {
                let state = model.states.get(index)?;
                Part {
                    value: self.course.state().get(index).copied().unwrap_or(f64::NAN),
                    scale: self.scales.get(index).copied().unwrap_or_default(),
                    node: model.graph.find(Node::State(index as u32)),
                    unit: &state.unit,
                    name: state.name(),
                    label: state.label.as_deref(),
                    varies: true,
                    hidden: false,
                    word: None,
                }
            }
            ReadoutKind::Quantity(index) => {
                let quantity = model.quantities.get(index)?;
                Part {
                    value: values.get(index).copied().unwrap_or(f64::NAN),
                    scale: self.scales.get(model.states.len() + index).copied().unwrap_or_default(),
                    node: Some(quantity.value.node),
                    unit: &quantity.value.unit,
                    name: quantity.name.clone(),
                    label: quantity.label.as_deref(),
                    varies: quantity.varies,
                    hidden: self.is_hidden(index),
                    word: Some(&quantity.value).filter(|value| value.kind != Kind::Number),
                }
            }
        })
    }

    fn varies(&self, kind: ReadoutKind) -> bool {
        match kind {
            ReadoutKind::Quantity(index) => self.model().quantities.get(index).is_some_and(|quantity| quantity.varies),
            _ => true,
        }
    }

    /// The author's label of what stands in a line, in the chosen language: of a vector what those of its components have in
    /// common.
    fn line_label(&self, parts: &[ReadoutKind], is_vector: bool) -> Option<String> {
        let model = &self.program.model;
        let label = |kind: &ReadoutKind| match *kind {
            ReadoutKind::Independent => None,
            ReadoutKind::State(index) => model.states.get(index)?.label.as_deref(),
            ReadoutKind::Quantity(index) => model.quantities.get(index)?.label.as_deref(),
        };
        let mut labels = parts.iter().filter_map(label).map(|label| self.text(label));
        let first = labels.next()?;
        let second = labels.next().filter(|_| is_vector);
        Some(second.map_or_else(|| first.to_owned(), |second| common_words(first, second)))
    }

    /// The components of a vector in one unit, with the same decimals.
    fn vector(&self, parts: &[Part], unit: &Unit) -> (String, String) {
        let style = self.style;
        let greatest =
            |size: fn(&Part) -> f64| parts.iter().map(size).filter(|size| size.is_finite()).fold(0.0_f64, f64::max);
        let written = |write: &dyn Fn(f64) -> String| {
            let components: Vec<String> = parts.iter().map(|part| write(part.value)).collect();
            format!("({})", components.join(if style.decimal_comma { "; " } else { ", " }))
        };
        if parts.iter().all(|part| part.node.is_some_and(|node| self.is_count(node, unit))) {
            return (written(&|value| self.count(value)), number::unit_text(&unit.text));
        }
        if parts.iter().any(|part| part.varies) {
            let group = Group::of_scale(unit, greatest(|part| part.scale.max(part.value.abs())), MOVING_DIGITS, style);
            return (written(&|value| group.number(value)), group.unit_text());
        }
        let unit = unit.for_size(unit.from_si(greatest(|part| part.value.abs())).abs());
        let number = |value| number::plain(unit.from_si(value), MOVING_DIGITS, style);
        (written(&number), number::unit_text(&unit.text))
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
                symbol: String::new(),
                members: None,
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
    fn constant(&self, value: f64, node: Option<NodeId>, unit: &Unit) -> (String, String) {
        if node.is_some_and(|node| self.is_count(node, unit)) {
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

/// `r[2]'` for its component `r[2].x'`.
fn vector_name(component: &str) -> String {
    let (name, primes) = component.split_at(component.trim_end_matches('\'').len());
    let vector = name.rsplit_once('.').map_or(name, |(vector, _)| vector);
    [vector, primes].concat()
}

/// "Position" for "Position x" and "Position y": without the words in which two labels differ.
fn common_words(one: &str, other: &str) -> String {
    let words = one.split(' ').zip(other.split(' '));
    let common: Vec<&str> = words.filter(|(one, other)| one == other).map(|(one, _)| one).collect();
    if common.is_empty() { one.to_owned() } else { common.join(" ") }
}
