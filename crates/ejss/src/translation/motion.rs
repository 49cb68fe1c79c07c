//! All code of a simulation executed symbolically: values at the start, rates, definitions, events.

use super::facts::{Facts, Page, Role, assigned};
use super::run::{Known, Phase, Run};
use super::value::{Kind, Value};
use crate::place::{Place, Reason, Section};
use crate::refusal::Obstacle;
use crate::report::{EntryKind, Report};
use crate::script::{Expression, Node, Statement, StatementKind, parse_expression, parse_program};
use std::collections::{BTreeMap, BTreeSet};
use units::words;

/// Marks the local that holds a rate.
const RATE: char = '\u{2}';

/// Result of the execution.
#[derive(Debug, Default)]
pub(super) struct Motion {
    /// Values at the start, by variable.
    pub start: BTreeMap<String, Known>,
    /// Rates in the order of the equations.
    pub rates: Vec<(String, Known)>,
    /// Computed variables and locals in the order of their code.
    pub definitions: Vec<(String, Known)>,
    pub events: Vec<SolvedEvent>,
    /// Kinds of locals.
    pub kinds: BTreeMap<String, Kind>,
    /// Computed variables that rates read from the step before, in the original.
    pub held: BTreeSet<String>,
    /// Functions that read states by their names and are called by rates or conditions of events.
    pub held_functions: BTreeSet<String>,
    /// Reasons why the model cannot be translated.
    pub blockers: Vec<Reason>,
}

/// Trigger of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Trigger {
    /// Its quantity passes through zero, either way.
    Crossing,
    /// Its quantity becomes negative.
    Negative,
    /// The end of each step.
    EachStep,
}

/// Event.
#[derive(Clone, Debug)]
pub(super) struct SolvedEvent {
    pub name: String,
    pub place: Place,
    pub trigger: Trigger,
    /// The quantity that passes through zero; nothing for the end of each step.
    pub condition: Known,
    /// New values of states and discrete quantities.
    pub actions: Vec<(String, Known)>,
    /// Conditions under which it pauses the run.
    pub pauses: Vec<Value>,
}

impl Motion {
    /// Executes the code. Variables whose relations need their own values become discrete in `facts`.
    pub fn of(facts: &mut Facts, report: &mut Report) -> Self {
        let mut motion = Self::default();
        motion.start(facts, report);
        motion.rates_and_relations(facts, report);
        let facts = &*facts;
        for event in facts.equations.events.iter().filter(|event| event.is_active) {
            let place = Place::new(Section::Evolution, &event.name);
            let condition = statements(&event.condition, &place).and_then(|page| {
                let mut run = Run::new(facts, Phase::Event, place.clone());
                let returned = run.list(&page, 0);
                motion.held.append(&mut run.older);
                motion.held_functions.append(&mut run.older_in);
                returned.unwrap_or_else(|| Err(run.reason(1, Obstacle::NoValue("return".to_owned()))))
            });
            let mut run = Run::new(facts, Phase::Event, place.clone());
            match statements(&event.action, &place) {
                Ok(page) => _ = run.list(&page, 0),
                Err(reason) => motion.blockers.push(reason),
            }
            dropped(&run, report);
            motion.blockers.append(&mut run.blockers);
            let actions = run.order.iter().filter(|key| facts.variable(key).is_some());
            let actions =
                actions.map(|key| (key.clone(), run.values.get(key).cloned().unwrap_or(Ok(Value::Nothing)))).collect();
            let is_crossing = event.kind.to_ascii_uppercase().contains("CROSS");
            let trigger = if is_crossing { Trigger::Crossing } else { Trigger::Negative };
            motion.events.push(SolvedEvent {
                name: event.name.clone(),
                place,
                trigger,
                condition,
                actions,
                pauses: run.pauses,
            });
        }
        motion
    }

    /// Values of the tables, then the pages of the initialization.
    fn start(&mut self, facts: &Facts, report: &mut Report) {
        let mut pages: Vec<Page> = Vec::new();
        for name in &facts.order {
            let Some(fact) = facts.variable(name).filter(|fact| !fact.is_array) else { continue };
            let line = fact.place.line.unwrap_or(1);
            let node = |node| Box::new(Expression { node, line });
            let value = if fact.value.trim().is_empty() {
                node(Node::Nothing)
            } else {
                parse_expression(&fact.value).map_or_else(
                    |_| node(Node::Other("value", Vec::new())),
                    |mut value| {
                        value.line = line;
                        Box::new(value)
                    },
                )
            };
            let assignment = node(Node::Assignment(node(Node::Name(name.clone())), None, value));
            let statement = Statement { kind: StatementKind::Expression(*assignment), line };
            match pages.last_mut().filter(|page| page.place.page == fact.place.page) {
                Some(page) => page.statements.push(statement),
                None => pages.push(Page {
                    place: Place::new(Section::Variables, &fact.place.page),
                    statements: vec![statement],
                }),
            }
        }
        pages.extend(facts.initialization.iter().cloned());
        let mut run = Run::new(facts, Phase::Start, Place::new(Section::Variables, ""));
        run.pages(&pages);
        dropped(&run, report);
        self.blockers.append(&mut run.blockers);
        self.start = run.values;
    }

    fn rates_and_relations(&mut self, facts: &mut Facts, report: &mut Report) {
        let place = Place::new(Section::Evolution, &facts.equations.name);
        let mut page = match statements(&facts.equations.preliminary, &place) {
            Ok(page) => page,
            Err(reason) => {
                self.blockers.push(reason);
                return;
            }
        };
        let mut unread = BTreeMap::new();
        for (index, (state, rate)) in facts.equations.rates.iter().enumerate() {
            let line = index + 1;
            match parse_expression(rate) {
                Ok(expression) => {
                    // A rate that assigns is a definition of its own, and the rate is its name.
                    let value = match assigned(&expression) {
                        Some((name, _)) if facts.variable(name).is_some() => {
                            let name = name.to_owned();
                            page.push(Statement { kind: StatementKind::Expression(expression), line });
                            Expression { node: Node::Name(name), line }
                        }
                        _ => expression,
                    };
                    let name = format!("{RATE}{state}");
                    page.push(Statement { kind: StatementKind::Declaration(vec![(name, Some(value))]), line });
                }
                Err(unreadable) => {
                    unread.insert(state.clone(), Reason { place: place.at(line), obstacle: unreadable.obstacle });
                }
            }
        }
        let mut run = Run::new(facts, Phase::Motion, place.clone());
        run.pages(&[Page { place: place.clone(), statements: page }]);
        dropped(&run, report);
        for (state, _) in &facts.equations.rates {
            let known = match unread.remove(state) {
                Some(reason) => Err(reason),
                None => run.local_value(&format!("{RATE}{state}")).unwrap_or(Ok(Value::Nothing)),
            };
            self.rates.push((state.clone(), known));
        }
        self.blockers.append(&mut run.blockers);
        let mut definitions: Vec<(String, Known)> = Vec::new();
        for key in run.order.iter().filter(|key| !key.starts_with(RATE)) {
            definitions.push((key.clone(), run.values.get(key).cloned().unwrap_or(Ok(Value::Nothing))));
        }
        self.held = std::mem::take(&mut run.older);
        self.held_functions = std::mem::take(&mut run.older_in);
        self.kinds = run.kinds;

        let mut fixed = Run::new(facts, Phase::Fixed, Place::new(Section::FixedRelations, ""));
        fixed.pages(&facts.fixed_relations);
        dropped(&fixed, report);
        self.blockers.append(&mut fixed.blockers);
        self.kinds.extend(fixed.kinds.clone());
        for key in &fixed.order {
            let known = fixed.values.get(key).cloned().unwrap_or(Ok(Value::Nothing));
            match definitions.iter_mut().find(|(own, _)| own == key) {
                Some((_, own)) if *own == known.as_ref().map(Value::of_one_moment).map_err(Clone::clone) => {}
                Some((_, own)) => {
                    let line = fixed.place.line.unwrap_or(1);
                    *own = Err(Reason { place: fixed.place.at(line), obstacle: Obstacle::TwoWays(key.clone()) });
                }
                None => definitions.push((key.clone(), known)),
            }
        }
        let past = fixed.past;
        self.definitions = definitions;
        self.remember(facts);
        self.lag(facts, &past, report);
    }

    /// Value of a definition, or of a constant at the start.
    pub fn defined(&self, facts: &Facts, key: &str) -> Option<&Known> {
        match facts.role(key) {
            Some(Role::Constant | Role::Discrete) => self.start.get(key),
            Some(Role::State | Role::Time) => None,
            Some(Role::Computed) | None => self.definitions.iter().find(|(own, _)| own == key).map(|(_, known)| known),
        }
    }

    /// Kind of a key.
    pub fn kind(&self, facts: &Facts, key: &str) -> Kind {
        facts.variable(key).map_or_else(|| self.kinds.get(key).copied().unwrap_or(Kind::Number), |fact| fact.kind)
    }
}

/// Statements of a piece of code.
fn statements(code: &str, place: &Place) -> Result<Vec<Statement>, Reason> {
    parse_program(code).map_err(|unreadable| Reason { place: place.at(unreadable.line), obstacle: unreadable.obstacle })
}

/// Reports statements that have no effect on the model.
fn dropped(run: &Run, report: &mut Report) {
    for reason in &run.dropped {
        let why = reason.obstacle.words();
        report.add(EntryKind::Left, reason.place.clone(), words!("The statement is not carried over: {why}."));
    }
}
