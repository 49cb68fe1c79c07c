//! Readouts: time, states and quantities with their units.

use super::lines::{Line, Member};
use super::members::{Members, ReadoutKind};
use super::rounding::Rounding;
use super::{Shown, Values};
use crate::{Answers, Basis, TimeLine, number, words};
use program::{Compiled, Kind, Node, NodeId, Role};
use units::Unit;
use units::mathml::{self, typeset_name};
use units::number::Group;

/// One value with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Readout {
    /// Kind of the value.
    pub kind: ReadoutKind,
    /// ASCII name: `omega_0`, `y'`, `x[3]`; for a vector, the name without component.
    pub name: String,
    /// Label in the chosen language; empty if the author gave none.
    pub label: String,
    /// Name as MathML; for a member of a family, without its index. Empty if it is an ordinary word that repeats the
    /// label.
    pub symbol: String,
    /// Family of the displayed member; `None` for a value that stands alone.
    pub members: Option<Members>,
    /// Value in `unit`, a dash if it is not finite, or a text in the chosen language.
    pub value: String,
    /// Unit as displayed; empty for a pure number, a text or a truth value.
    pub unit: String,
    /// True if it changes while the parameters are constant.
    pub varies: bool,
    /// True if a question hides the value; a placeholder is shown instead.
    pub hidden: bool,
}

/// Significant digits of a changing value.
pub(super) const MOVING_DIGITS: usize = 4;

/// One value of a line, before formatting.
struct Part<'a> {
    value: f64,
    /// Greatest magnitude in this run, SI.
    scale: f64,
    node: Option<NodeId>,
    unit: &'a Unit,
    name: String,
    label: Option<&'a str>,
    varies: bool,
    hidden: bool,
    /// Expression of a text or truth value; `None` for a number.
    word: Option<&'a Compiled>,
}

impl Values {
    /// All readouts at the time shown: the independent variable, the states, the quantities. A vector is one readout; a
    /// family shows the selected member ([`Values::choose_member`]). Widens the magnitudes of the quantities.
    pub(crate) fn readouts(&mut self, basis: &Basis, line: &TimeLine, answers: &Answers) -> Vec<Readout> {
        let at = line.course();
        let values = self.quantities.at(at.parameters(), at.initial(), at.time(), at.state());
        for (scale, value) in self.quantity_scales.iter_mut().zip(values) {
            if value.is_finite() {
                *scale = scale.max(value.abs());
            }
        }
        let values = values.to_vec();
        let shown = self.shown(basis, line, answers);
        let mut readouts = vec![shown.time_readout()];
        let rounding = Rounding::of(&shown);
        let lines = shown.values.lines.readouts.iter();
        readouts.extend(lines.filter_map(|line| shown.line_readout(line, &values, &rounding)));
        readouts.extend(shown.friction_readouts());
        readouts
    }
}

impl Shown<'_> {
    fn time_readout(&self) -> Readout {
        let independent = &self.basis.model().independent;
        let (value, unit) = match self.basis.small_times(self.line.course()) {
            Some(group) => (group.number(self.line.course().time()), group.unit_text()),
            None => (
                self.basis.time_number(self.line.course(), self.line.course().time()),
                number::unit_text(&independent.unit.text),
            ),
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

    fn line_readout(&self, line: &Line<ReadoutKind>, values: &[f64], rounding: &Rounding) -> Option<Readout> {
        let member = line.member(self.values.lines.chosen_of(line))?;
        let parts: Vec<Part> = member.parts.iter().filter_map(|&kind| self.part(kind, values, rounding)).collect();
        let first = parts.first()?;
        let hidden = parts.iter().any(|part| part.hidden);
        let (value, unit) = match (first.word, parts.as_slice()) {
            _ if hidden => (words::hidden(self.basis.language()).to_owned(), String::new()),
            (Some(word), _) => (self.basis.word_value(word, first.value), number::unit_text(&first.unit.text)),
            (None, [one]) if !member.is_vector && one.varies => self.moving(one.value, one.scale, one.node, one.unit),
            (None, [one]) if !member.is_vector => self.constant(one.value, one.node, one.unit),
            _ => self.vector(&parts, first.unit),
        };
        let members = self.values.lines.family(line);
        let label_of = |member: &Member<ReadoutKind>| self.line_label(&member.parts, member.is_vector);
        // The first labelled member names the family.
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

    /// A value with the data needed to format it; a rounding error is 0.
    fn part(&self, kind: ReadoutKind, values: &[f64], rounding: &Rounding) -> Option<Part<'_>> {
        let model = self.basis.model();
        let mut part = match kind {
            ReadoutKind::Independent => return None,
            ReadoutKind::State(index) => {
                let state = model.states.get(index)?;
                Part {
                    value: self.line.course().state().get(index).copied().unwrap_or(f64::NAN),
                    scale: self.line.greatest(index),
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
                    scale: self.values.quantity_scales.get(index).copied().unwrap_or_default(),
                    node: Some(quantity.value.node),
                    unit: &quantity.value.unit,
                    name: quantity.name.clone(),
                    label: quantity.label.as_deref(),
                    varies: quantity.varies,
                    hidden: self.answers.hide(self.basis, index),
                    word: Some(&quantity.value).filter(|value| value.kind != Kind::Number),
                }
            }
        };
        part.value = rounding.cleared(part.value, part.unit.dimension);
        part.scale = rounding.cleared(part.scale, part.unit.dimension);
        Some(part)
    }

    fn varies(&self, kind: ReadoutKind) -> bool {
        match kind {
            ReadoutKind::Quantity(index) => {
                self.basis.model().quantities.get(index).is_some_and(|quantity| quantity.varies)
            }
            _ => true,
        }
    }

    /// Label of a line in the chosen language; for a vector, the words common to the labels of its components.
    fn line_label(&self, parts: &[ReadoutKind], is_vector: bool) -> Option<String> {
        let model = self.basis.model();
        let label = |kind: &ReadoutKind| match *kind {
            ReadoutKind::Independent => None,
            ReadoutKind::State(index) => model.states.get(index)?.label.as_deref(),
            ReadoutKind::Quantity(index) => model.quantities.get(index)?.label.as_deref(),
        };
        let mut labels = parts.iter().filter_map(label).map(|label| self.basis.text(label));
        let first = labels.next()?;
        let second = labels.next().filter(|_| is_vector);
        Some(second.map_or_else(|| first.to_owned(), |second| common_words(first, second)))
    }

    /// Formats the components of a vector in one unit with equal decimals: (text, unit).
    fn vector(&self, parts: &[Part], unit: &Unit) -> (String, String) {
        let style = self.basis.style();
        let greatest =
            |size: fn(&Part) -> f64| parts.iter().map(size).filter(|size| size.is_finite()).fold(0.0_f64, f64::max);
        let written = |write: &dyn Fn(f64) -> String| {
            let components: Vec<String> = parts.iter().map(|part| write(part.value)).collect();
            format!("({})", components.join(if style.decimal_comma { "; " } else { ", " }))
        };
        if parts.iter().all(|part| part.node.is_some_and(|node| self.basis.is_count(node, unit))) {
            return (written(&|value| self.basis.count(value)), number::unit_text(&unit.text));
        }
        if parts.iter().any(|part| part.varies) {
            let group = Group::of_scale(unit, greatest(|part| part.scale.max(part.value.abs())), MOVING_DIGITS, style);
            return (written(&|value| group.number(value)), group.unit_text());
        }
        let unit = unit.for_size(unit.from_si(greatest(|part| part.value.abs())).abs());
        let number = |value| number::plain(unit.from_si(value), MOVING_DIGITS, style);
        (written(&number), number::unit_text(&unit.text))
    }

    /// Readouts that show whether each dry friction sticks or slips.
    fn friction_readouts(&self) -> impl Iterator<Item = Readout> {
        let states = self.basis.model().states.iter().zip(self.line.course().state()).enumerate();
        let frictions = states.filter(|(_, (state, _))| state.role == Role::Friction);
        let several = frictions.clone().nth(1).is_some();
        frictions.map(move |(index, (state, &motion))| {
            let label = words::dry_friction(self.basis.language());
            Readout {
                kind: ReadoutKind::State(index),
                name: state.name(),
                label: if several { format!("{label}: {}", state.name()) } else { label.to_owned() },
                symbol: String::new(),
                members: None,
                value: words::sticks(self.basis.language(), motion == 0.0).to_owned(),
                unit: String::new(),
                varies: true,
                hidden: false,
            }
        })
    }

    /// Number and unit of a changing value; `scale` is its greatest magnitude in this run, both SI. A value negligible
    /// relative to the scale is shown as zero.
    fn moving(&self, value: f64, scale: f64, node: Option<NodeId>, unit: &Unit) -> (String, String) {
        if node.is_some_and(|node| self.basis.is_count(node, unit)) {
            return (self.basis.count(value), number::unit_text(&unit.text));
        }
        let group = Group::of_scale(unit, scale.max(value.abs()), MOVING_DIGITS, self.basis.style());
        (group.number(value), group.unit_text())
    }

    /// Number and unit of a constant value (SI).
    fn constant(&self, value: f64, node: Option<NodeId>, unit: &Unit) -> (String, String) {
        if node.is_some_and(|node| self.basis.is_count(node, unit)) {
            return (self.basis.count(value), number::unit_text(&unit.text));
        }
        let unit = unit.for_size(unit.from_si(value).abs());
        (number::plain(unit.from_si(value), MOVING_DIGITS, self.basis.style()), number::unit_text(&unit.text))
    }
}

/// Name of the vector of a component: `r[2]'` for `r[2].x'`.
fn vector_name(component: &str) -> String {
    let (name, primes) = component.split_at(component.trim_end_matches('\'').len());
    let vector = name.rsplit_once('.').map_or(name, |(vector, _)| vector);
    [vector, primes].concat()
}

/// Words that two labels have in common: "Position" for "Position x" and "Position y".
fn common_words(one: &str, other: &str) -> String {
    let words = one.split(' ').zip(other.split(' '));
    let common: Vec<&str> = words.filter(|(one, other)| one == other).map(|(one, _)| one).collect();
    if common.is_empty() { one.to_owned() } else { common.join(" ") }
}
