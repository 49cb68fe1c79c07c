//! Facts about a simulation that its translation asks: variables with their roles, functions, what code may write.

use super::value::Kind;
use crate::place::{Place, Section};
use crate::report::Report;
use crate::script::{Expression, Function, Node, Statement, StatementKind, parse_program};
use crate::simulation::{CodePage, Equations, EvolutionPage, Simulation, Variable};
use std::collections::{BTreeMap, BTreeSet};

/// Greatest depth of calls that are looked into.
const DEEPEST: usize = 12;

/// Role of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A rate determines it.
    State,
    /// Independent variable.
    Time,
    /// Computed from others, in fixed relations or with the rates.
    Computed,
    /// Changed by events only, or after each step.
    Discrete,
    /// Never written after the start.
    Constant,
}

/// Variable of the table.
#[derive(Clone, Debug)]
pub(super) struct VariableFact {
    pub role: Role,
    pub kind: Kind,
    pub is_array: bool,
    pub comment: String,
    /// JavaScript of its value.
    pub value: String,
    pub place: Place,
}

/// Page of code, read.
#[derive(Clone, Debug)]
pub(super) struct Page {
    pub place: Place,
    pub statements: Vec<Statement>,
}

/// Function with the page that it stands in.
#[derive(Clone, Debug)]
pub(super) struct FunctionFact {
    pub function: Function,
    pub place: Place,
}

/// Facts about one simulation.
#[derive(Clone, Debug)]
pub(super) struct Facts {
    /// Names in the order of the tables.
    pub order: Vec<String>,
    variables: BTreeMap<String, VariableFact>,
    functions: BTreeMap<String, FunctionFact>,
    pub initialization: Vec<Page>,
    pub fixed_relations: Vec<Page>,
    pub equations: Equations,
}

impl Facts {
    /// Facts of a simulation with these equations. What cannot be read is reported.
    pub fn new(simulation: &Simulation, equations: &Equations, report: &mut Report) -> Self {
        let mut facts = Self {
            order: Vec::new(),
            variables: BTreeMap::new(),
            functions: BTreeMap::new(),
            initialization: Vec::new(),
            fixed_relations: Vec::new(),
            equations: equations.clone(),
        };
        for page in simulation.variables.iter().filter(|page| page.is_active) {
            for (row, variable) in page.variables.iter().enumerate() {
                facts.declare(variable, Place::new(Section::Variables, &page.name).at(row + 1));
            }
        }
        let mut read = |section: Section, pages: &[CodePage]| -> Vec<Page> {
            let active = pages.iter().filter(|page| page.is_active);
            let mut found = Vec::new();
            for page in active {
                let place = Place::new(section, &page.name);
                match parse_program(&page.code) {
                    Ok(statements) => found.push(Page { place, statements }),
                    Err(unreadable) => {
                        report.not_read(place.at(unreadable.line), &unreadable.obstacle);
                        found.push(Page { place, statements: vec![unread(&page.code, unreadable.line)] });
                    }
                }
            }
            found
        };
        let custom = read(Section::Custom, &simulation.custom);
        let initialization = read(Section::Initialization, &simulation.initialization);
        let fixed_relations = read(Section::FixedRelations, &simulation.fixed_relations);
        for page in custom {
            for statement in page.statements {
                if let StatementKind::Function(function) = statement.kind {
                    let place = page.place.at(statement.line);
                    facts.functions.insert(function.name.clone(), FunctionFact { function, place });
                }
            }
        }
        (facts.initialization, facts.fixed_relations) = (initialization, fixed_relations);
        facts.set_roles();
        facts
    }

    fn declare(&mut self, variable: &Variable, place: Place) {
        if variable.name.is_empty() || self.variables.contains_key(&variable.name) {
            return;
        }
        let kind = match variable.kind.to_ascii_lowercase().as_str() {
            "boolean" => Kind::Truth,
            "string" => Kind::Text,
            _ => Kind::Number,
        };
        let is_array = !variable.dimension.trim().is_empty()
            || variable.value.trim_start().starts_with(['[', '{'])
            || variable.value.trim_start().starts_with("new ");
        self.order.push(variable.name.clone());
        let fact = VariableFact {
            role: Role::Constant,
            kind,
            is_array,
            comment: variable.comment.clone(),
            value: variable.value.clone(),
            place,
        };
        self.variables.insert(variable.name.clone(), fact);
    }

    fn set_roles(&mut self) {
        let mut computed = BTreeSet::new();
        for page in &self.fixed_relations {
            computed.extend(self.written_by(&page.statements));
        }
        computed.extend(self.written_in_text(&self.equations.preliminary));
        for (_, rate) in &self.equations.rates {
            computed.extend(self.written_in_text(rate));
        }
        let mut discrete = BTreeSet::new();
        for event in self.equations.events.iter().filter(|event| event.is_active) {
            discrete.extend(self.written_in_text(&event.action));
        }
        let states: BTreeSet<String> = self.equations.rates.iter().map(|(state, _)| state.clone()).collect();
        for (name, fact) in &mut self.variables {
            fact.role = match () {
                () if *name == self.equations.independent && !states.contains(name) => Role::Time,
                () if states.contains(name) => Role::State,
                () if computed.contains(name) => Role::Computed,
                () if discrete.contains(name) => Role::Discrete,
                () => Role::Constant,
            };
        }
    }

    /// A computed variable keeps its value from step to step from now on.
    pub fn keep(&mut self, name: &str) {
        if let Some(fact) = self.variables.get_mut(name) {
            fact.role = Role::Discrete;
        }
    }

    pub fn variable(&self, name: &str) -> Option<&VariableFact> {
        self.variables.get(name)
    }

    pub fn role(&self, name: &str) -> Option<Role> {
        self.variables.get(name).map(|fact| fact.role)
    }

    /// Row of a variable in its table; for a key that is no variable the part of the simulation in which it stands.
    pub fn place_of(&self, key: &str, section: Section) -> Place {
        self.variables.get(key).map_or_else(|| Place::new(section, ""), |fact| fact.place.clone())
    }

    pub fn function(&self, name: &str) -> Option<&FunctionFact> {
        self.functions.get(name)
    }

    /// Names of the variables that a text of code may write; none if it cannot be read.
    pub fn written_in_text(&self, code: &str) -> BTreeSet<String> {
        parse_program(code).map(|statements| self.written_by(&statements)).unwrap_or_default()
    }

    /// Names of the variables that statements may write, by the functions that they call as well.
    pub fn written_by(&self, statements: &[Statement]) -> BTreeSet<String> {
        let mut written = BTreeSet::new();
        self.collect(statements, &BTreeSet::new(), DEEPEST, &mut written);
        written
    }

    fn collect(
        &self,
        statements: &[Statement],
        hidden: &BTreeSet<String>,
        depth: usize,
        written: &mut BTreeSet<String>,
    ) {
        let mut hidden = hidden.clone();
        declared_names(statements, &mut hidden);
        let mut calls = BTreeSet::new();
        for statement in statements {
            statement.walk(&mut |expression| match &expression.node {
                Node::Assignment(target, ..) => {
                    if let Some(name) =
                        target.root().filter(|name| !hidden.contains(*name) && self.variables.contains_key(*name))
                    {
                        written.insert(name.to_owned());
                    }
                }
                Node::Call(callee, _) => calls.extend(callee.name().map(str::to_owned)),
                _ => {}
            });
        }
        let Some(depth) = depth.checked_sub(1) else { return };
        for call in calls {
            if let Some(fact) = self.functions.get(&call) {
                let arguments = fact.function.arguments.iter().cloned().collect();
                self.collect(&fact.function.body, &arguments, depth, written);
            }
        }
    }

    /// Names of the variables that a function reads, by the functions that it calls as well.
    pub fn read_by(&self, name: &str) -> BTreeSet<String> {
        let mut read = BTreeSet::new();
        self.collect_read(name, DEEPEST, &mut read);
        read
    }

    fn collect_read(&self, name: &str, depth: usize, read: &mut BTreeSet<String>) {
        let (Some(fact), Some(depth)) = (self.functions.get(name), depth.checked_sub(1)) else { return };
        let mut hidden: BTreeSet<String> = fact.function.arguments.iter().cloned().collect();
        declared_names(&fact.function.body, &mut hidden);
        let mut calls = BTreeSet::new();
        for statement in &fact.function.body {
            statement.walk(&mut |expression| match &expression.node {
                Node::Name(name) if !hidden.contains(name) && self.variables.contains_key(name) => {
                    read.insert(name.clone());
                }
                Node::Call(callee, _) => calls.extend(callee.name().map(str::to_owned)),
                _ => {}
            });
        }
        calls.iter().for_each(|call| self.collect_read(call, depth, read));
    }
}

/// A page that cannot be read, as one statement that writes every name which seems to be written in it.
fn unread(code: &str, line: usize) -> Statement {
    let mut written = Vec::new();
    let mut rest = code;
    while let Some(start) = rest.find(|letter: char| letter.is_alphabetic() || matches!(letter, '_' | '$')) {
        let from = rest.get(start..).unwrap_or_default();
        let end =
            from.find(|letter: char| !(letter.is_alphanumeric() || matches!(letter, '_' | '$'))).unwrap_or(from.len());
        let (name, after) = from.split_at(end);
        let sign = after.trim_start();
        let is_written = sign.starts_with(['=', '[', '+', '-', '*', '/', '%']) && !sign.starts_with("==");
        if is_written || rest.get(..start).is_some_and(|before| before.ends_with("++") || before.ends_with("--")) {
            let expression = |node| Box::new(Expression { node, line });
            let target = expression(Node::Name(name.to_owned()));
            written.push(*expression(Node::Assignment(target, None, expression(Node::Nothing))));
        }
        rest = after;
    }
    Statement { kind: StatementKind::Other("code", written, Vec::new()), line }
}

/// Adds the names that statements declare by `var`, in branches and loops as well.
fn declared_names(statements: &[Statement], names: &mut BTreeSet<String>) {
    for statement in statements {
        if let StatementKind::Declaration(declared) = &statement.kind {
            names.extend(declared.iter().map(|(name, _)| name.clone()));
        }
        for inner in statement.inner() {
            declared_names(std::slice::from_ref(inner), names);
        }
    }
}

/// The active pages of equations of a simulation.
pub(crate) fn active_equations(simulation: &Simulation) -> Vec<&Equations> {
    let equations = simulation.evolution.iter().filter_map(|page| match page {
        EvolutionPage::Equations(equations) if equations.is_active => Some(equations),
        _ => None,
    });
    equations.collect()
}

/// The first active page of evolution code that does something.
pub(super) fn evolution_code(simulation: &Simulation) -> Option<&CodePage> {
    simulation.evolution.iter().find_map(|page| match page {
        EvolutionPage::Code(page) if page.is_active => {
            let is_empty = parse_program(&page.code).is_ok_and(|statements| statements.is_empty());
            (!is_empty).then_some(page)
        }
        _ => None,
    })
}

/// The value of an assignment that stands alone, and the name that it sets.
pub(super) fn assigned(expression: &Expression) -> Option<(&str, &Expression)> {
    match &expression.node {
        Node::Assignment(target, None, value) => Some((target.name()?, value)),
        _ => None,
    }
}
