//! A simulation whose code has been executed symbolically and whose states have all that they need.

use super::blocker::Blocker;
use super::choices::{Choice, choices};
use super::controls::{Control, constant, controls};
use super::events::{EventText, until};
use super::facts::{Facts, Role, active_equations, evolution_code};
use super::motion::Motion;
use super::needs::{Functions, Search};
use super::picture::{Picture, picture};
use super::plots::{Plot, plots};
use super::units::stated_units;
use super::value::{Kind, Value};
use crate::place::{Place, Section};
use crate::reading::Files;
use crate::report::{EntryKind, Report};
use crate::simulation::{Equations, Simulation};
use std::collections::{BTreeMap, BTreeSet};
use units::words;

/// Greatest number of rates, and of events, of a model that is translated.
const MOST_RATES: usize = 100;
/// Greatest number of its variables.
const MOST_VARIABLES: usize = 1000;

/// Translated model.
#[derive(Debug)]
pub(crate) struct Solved {
    pub(super) facts: Facts,
    pub(super) motion: Motion,
    pub(super) controls: Vec<Control>,
    pub(super) choices: Vec<Choice>,
    pub(super) plots: Vec<Plot>,
    pub(super) picture: Option<Picture>,
    pub(super) functions: Functions,
    /// Keys that the document uses.
    pub(super) used: BTreeSet<String>,
    pub(super) units: BTreeMap<String, String>,
    /// Events but for the one that only ends the run at a time.
    pub(super) events: Vec<EventText>,
    /// Time at which the run ends.
    pub until: Option<f64>,
    /// Step of the run.
    pub step: f64,
    /// Increment of the time between two pictures of the original.
    pub increment: f64,
}

/// Blocks of a translated document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Document {
    /// Lines of the model.
    pub model: Vec<String>,
    /// Lines of the drawing; empty for none.
    pub scene: Vec<String>,
    /// Lines of the plots; empty for none.
    pub plots: Vec<String>,
    /// Name in the simulation and name in the document of each variable.
    pub names: Vec<(String, String)>,
}

impl Solved {
    /// Executes the code of a simulation. What is not carried over is reported.
    ///
    /// # Errors
    /// The reason why the model cannot be translated.
    pub fn new(simulation: &Simulation, files: &Files, report: &mut Report) -> Result<Self, Blocker> {
        let equations = match active_equations(simulation).as_slice() {
            [] => return Err(Blocker::NoEquations),
            [equations] if equations.rates.is_empty() => return Err(Blocker::NoEquations),
            [equations] => *equations,
            several => return Err(Blocker::SeveralEquations(several.len())),
        };
        if let Some(page) = evolution_code(simulation) {
            return Err(Blocker::EvolutionCode(page.name.clone()));
        }
        let count: usize = simulation.variables.iter().map(|page| page.variables.len()).sum();
        if equations.rates.len() > MOST_RATES || equations.events.len() > MOST_RATES || count > MOST_VARIABLES {
            return Err(Blocker::TooLarge);
        }
        if equations.has_extras {
            return Err(Blocker::Extras);
        }
        let mut facts = Facts::new(simulation, equations, report);
        for (state, _) in &equations.rates {
            match facts.variable(state) {
                _ if state.contains('[') => return Err(Blocker::ArrayState(state.clone())),
                None => return Err(Blocker::UnknownState(state.clone())),
                Some(fact) if fact.is_array => return Err(Blocker::ArrayState(state.clone())),
                Some(_) => {}
            }
        }
        let motion = Motion::of(&mut facts, report);
        if let Some(reason) = motion.blockers.first() {
            return Err(Blocker::Code(reason.clone()));
        }
        let (step, increment) = step(&facts, &motion).ok_or_else(|| Blocker::Step(equations.increment.clone()))?;
        if let Some(Ok(value)) = motion.start.get(&equations.independent)
            && value.constant(&|_| None).is_none_or(|value| value != 0.0)
            && *value != Value::Nothing
        {
            let shown = facts.variable(&equations.independent).map(|fact| fact.value.clone()).unwrap_or_default();
            return Err(Blocker::StartOfTime(shown));
        }
        let unknown = motion.rates.iter().find_map(|(state, rate)| Some((state, rate.as_ref().err()?)));
        if let Some((state, reason)) = unknown {
            return Err(Blocker::Needed(state.clone(), reason.clone()));
        }
        let mut needs = Search::new(&facts, &motion);
        needs.states();
        if let Some((key, reason)) = needs.missing.first() {
            return Err(Blocker::Needed(key.clone(), reason.clone()));
        }
        let needed = needs.found;
        let solved = Self::shown(simulation, files, facts, motion, [step, increment], report);
        solved.report_held(&needed, report);
        solved.report_left(simulation, report);
        Ok(solved)
    }

    /// Adds what the view shows: controls, choices, plots and the picture.
    fn shown(
        simulation: &Simulation,
        files: &Files,
        facts: Facts,
        motion: Motion,
        [step, increment]: [f64; 2],
        report: &mut Report,
    ) -> Self {
        let controls = controls(simulation, &facts);
        let start = |name: &str| motion.start.get(name).and_then(|known| known.as_ref().ok()).cloned();
        let choices = choices(simulation, &facts, &start, report);
        let mut plots = plots(simulation, &facts, report);
        let mut picture = picture(simulation, &facts, files, report);
        let (until, events) = until(&facts, &motion, report);
        let mut search = Search::new(&facts, &motion);
        search.states();
        // Plots and drawings use only what has a value.
        let is_known = |value: &Value| {
            let mut trial = Search::new(&facts, &motion);
            trial.value(value);
            trial.missing.is_empty()
        };
        for plot in &mut plots {
            plot.curves.retain(|curve| is_known(curve) && is_known(&plot.against));
        }
        plots.retain(|plot| !plot.curves.is_empty());
        plots.iter().flat_map(|plot| plot.curves.iter().chain([&plot.against])).for_each(|value| search.value(value));
        if let Some(picture) = &mut picture {
            picture.keep(&is_known, report);
            picture.values().into_iter().for_each(|value| search.value(value));
        }
        let displayed = controls.iter().map(|control| &control.variable);
        let computed =
            facts.order.iter().filter(|name| matches!(facts.role(name), Some(Role::Computed | Role::Discrete)));
        // A constant that is computed from others, such as a period, is a value that the page shows.
        let is_result = |name: &&String| {
            let start = motion.start.get(*name).and_then(|known| known.as_ref().ok());
            facts.role(name) == Some(Role::Constant)
                && start.is_some_and(|value| !value.is_plain() && value.constant(&|_| None).is_none())
        };
        let results: Vec<&String> = facts.order.iter().filter(is_result).collect();
        for name in displayed.chain(computed).chain(results.iter().copied()) {
            let is_plain = |value: &Value| *value != Value::Nothing && !matches!(value, Value::Join(_));
            let has_value = match motion.defined(&facts, name) {
                Some(Ok(value)) => is_plain(value) && is_known(&Value::Name(name.clone())),
                _ => false,
            };
            if has_value && (facts.role(name) != Some(Role::Constant) || results.contains(&name)) {
                search.key(name);
            }
        }
        let events = events.into_iter().filter(|event| {
            let is_sound = event.condition.as_ref().is_none_or(&is_known);
            if !is_sound {
                report.add(
                    EntryKind::Left,
                    Place::new(Section::Evolution, &event.name),
                    words!("The event is not carried over: it needs a quantity that is not carried over."),
                );
            }
            is_sound
        });
        let events: Vec<EventText> = events.collect();
        for event in &events {
            let acts = event.stops || event.actions.iter().any(|(name, _)| search.found.contains(name));
            if acts {
                event.condition.iter().for_each(|condition| search.value(condition));
            }
            for (name, value) in &event.actions {
                if search.found.contains(name) {
                    search.value(value);
                }
            }
        }
        let units = stated_units(&facts, &motion, &controls, &plots);
        let (used, functions) = (search.found, search.functions);
        Self {
            motion,
            controls,
            choices,
            plots,
            picture,
            functions,
            used,
            units,
            events,
            until,
            step,
            increment,
            facts,
        }
    }

    /// The equations as they are stored.
    pub fn equations(&self) -> &Equations {
        &self.facts.equations
    }

    /// Model time that passes in a second of watching: the increment, times the frames of a second, times the steps of a frame.
    pub fn speed(&self, simulation: &Simulation) -> Option<f64> {
        let frames: f64 = simulation.frames_per_second.trim().parse().ok()?;
        let steps: f64 = simulation.steps_per_display.trim().parse().unwrap_or(1.0);
        let speed = self.increment * frames * steps;
        // A product of decimal numbers has further digits from rounding.
        let speed = (speed * 1e9).round() / 1e9;
        (speed > 0.0 && speed.is_finite()).then_some(speed)
    }

    /// Reports quantities that EJS holds through a step, and corners that its steps pass over.
    fn report_held(&self, needed: &BTreeSet<String>, report: &mut Report) {
        for name in &self.motion.held_functions {
            let Some(place) = self.facts.function(name).map(|fact| fact.place.clone()) else { continue };
            report.add(
                EntryKind::Differs,
                place,
                words!("The function `{name}` reads states by their names. In the original it sees their values before the step, here those of the moment: the motion differs, and is the more exact one."),
            );
        }
        if self.has_corners(needed) {
            let place = Place::new(Section::Evolution, &self.facts.equations.name);
            report.add(
                EntryKind::Differs,
                place,
                words!("The rates have a jump or a corner (a condition, `abs`, `min`, `floor` ..). Steps end there, and in the original they go over it: the motion may differ behind it."),
            );
        }
        let is_discrete = |name: &&String| self.facts.role(name) == Some(Role::Discrete);
        for name in self.motion.held.intersection(needed).filter(|name| !is_discrete(name)) {
            let mut search = Search::new(&self.facts, &self.motion);
            search.key(name);
            if search.moves() {
                report.add(
                    EntryKind::Differs,
                    self.facts.place_of(name, Section::FixedRelations),
                    words!("`{name}` is computed after each step in the original, and the rates use the value of the step before. Here it follows the states at once: the motion differs, and is the more exact one."),
                );
            }
        }
    }

    /// True if rates have a jump or a corner that moves with states or the time.
    fn has_corners(&self, needed: &BTreeSet<String>) -> bool {
        let mut values: Vec<&Value> = self.motion.rates.iter().filter_map(|(_, rate)| rate.as_ref().ok()).collect();
        values.extend(needed.iter().filter_map(|key| self.motion.defined(&self.facts, key)?.as_ref().ok()));
        values.extend(self.functions.order.iter().filter_map(|name| self.functions.value(name)));
        let mut found = false;
        for value in values {
            value.walk(&mut |part| {
                let is_corner = match part {
                    Value::If(..) => true,
                    Value::Call(name, _) => matches!(*name, "abs" | "sign" | "min" | "max" | "floor" | "ceil" | "mod"),
                    _ => false,
                };
                if is_corner && !found {
                    let mut search = Search::new(&self.facts, &self.motion);
                    search.value(part);
                    let mut has_argument = false;
                    part.walk(&mut |inner| {
                        has_argument |= matches!(inner, Value::Name(name) if name.contains(super::names::ARGUMENT))
                    });
                    found = has_argument || search.moves();
                }
            });
        }
        found
    }

    /// Reports variables and controls that are missing.
    fn report_left(&self, simulation: &Simulation, report: &mut Report) {
        for name in &self.facts.order {
            let Some(fact) = self.facts.variable(name) else { continue };
            let is_choice = self.choices.iter().any(|choice| choice.name == *name);
            if self.is_written(name) || is_choice || fact.role == Role::Time || *name == self.facts.equations.increment
            {
                continue;
            }
            match self.motion.defined(&self.facts, name) {
                Some(Err(reason)) => report.quantity_left(name, reason),
                Some(Ok(Value::Join(_))) => {
                    report.add(
                        EntryKind::Left,
                        fact.place.clone(),
                        words!("`{name}` is not carried over: it is a text with values in it."),
                    );
                }
                _ if fact.is_array => report.add(
                    EntryKind::Left,
                    fact.place.clone(),
                    words!("`{name}` is not carried over: it is an array."),
                ),
                _ => report.add(
                    EntryKind::Left,
                    fact.place.clone(),
                    words!("`{name}` is not carried over: nothing in the document uses it."),
                ),
            }
        }
        for control in self.controls.iter().filter(|control| control.is_editable) {
            let name = &control.variable;
            let is_step = *name == self.facts.equations.increment;
            let why = match self.facts.role(name) {
                _ if is_step => {
                    words!("The control of the step is not carried over: *Numerical method* of the page has one.")
                }
                Some(Role::Constant) if self.is_written(name) => continue,
                Some(Role::State) if self.start_parameter(name).is_some() => continue,
                Some(Role::Computed | Role::Discrete) => {
                    words!("The control of `{name}` is not carried over: the model itself changes it.")
                }
                Some(Role::Constant | Role::State | Role::Time) | None => {
                    words!("The control of `{name}` is not carried over: nothing in the document uses it.")
                }
            };
            report.add(EntryKind::Left, control.place.clone(), why);
        }
        let follows = |name: &str| matches!(self.facts.role(name), Some(Role::State | Role::Time | Role::Computed));
        crate::listing::report_view(simulation, &follows, report);
    }

    /// True if the document declares a variable.
    pub(super) fn is_written(&self, name: &str) -> bool {
        self.used.contains(name)
            || self.choices.iter().any(|choice| super::choices::sets(choice).into_iter().any(|own| own == name))
    }

    /// Control that sets a variable.
    pub(super) fn control(&self, variable: &str) -> Option<&Control> {
        self.controls.iter().find(|control| control.variable == variable && control.is_editable)
    }

    /// Control that sets a state at the start, if the state begins with a number.
    pub(super) fn start_parameter(&self, state: &str) -> Option<(&Control, f64)> {
        let control = self.control(state)?;
        let value = self.motion.start.get(state)?.as_ref().ok()?.constant(&|_| None)?;
        Some((control, value))
    }

    /// Kind of a key.
    pub(super) fn kind(&self, key: &str) -> Kind {
        self.motion.kind(&self.facts, key)
    }
}

/// The step, which is the internal one if it is stated, and the increment of the independent variable.
fn step(facts: &Facts, motion: &Motion) -> Option<(f64, f64)> {
    let of = |text: &str| {
        let by_name = motion.start.get(text).and_then(|known| known.as_ref().ok()?.constant(&|_| None));
        by_name.or_else(|| constant(facts, text)).filter(|step| *step > 0.0)
    };
    let increment = of(&facts.equations.increment)?;
    let internal = of(&facts.equations.internal_step).filter(|internal| *internal < increment);
    Some((internal.unwrap_or(increment), increment))
}
