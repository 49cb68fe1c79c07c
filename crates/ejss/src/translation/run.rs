//! Symbolic execution of code: which value each variable has behind it, as an expression. Nothing is computed.

use super::facts::{Facts, Page, Role};
use super::value::{Kind, Value};
use crate::place::{Place, Reason};
use crate::refusal::Obstacle;
use crate::script::{Expression, Node, Operator, Statement, StatementKind};
use std::collections::{BTreeMap, BTreeSet};

/// Greatest number of statements and expressions that are executed in one phase.
const MOST_WORK: usize = 40_000;
/// Greatest size of a value, in nodes.
const LARGEST: usize = 2_000;
/// Greatest depth of calls.
pub(super) const DEEPEST: usize = 12;
/// Separates the name of a local variable from its number; no name contains it.
pub(super) const LOCAL: char = '\u{1}';

/// When code is executed; decides what a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    /// Values of the tables and pages of the initialization.
    Start,
    /// Preliminary code and rates.
    Motion,
    /// Fixed relations.
    Fixed,
    /// Condition or action of an event.
    Event,
    /// Body of a function on its own.
    Function,
}

/// Value, or the reason why there is none.
pub(super) type Known = Result<Value, Reason>;

/// Execution of the code of one phase.
pub(super) struct Run<'a> {
    pub facts: &'a Facts,
    pub phase: Phase,
    /// Page that is being executed.
    pub place: Place,
    /// Values of variables and locals that have been written.
    pub values: BTreeMap<String, Known>,
    /// Kinds of locals.
    pub kinds: BTreeMap<String, Kind>,
    /// Order in which the variables and locals were first written.
    pub order: Vec<String>,
    /// Statements that have no effect on the model, each with its reason.
    pub dropped: Vec<Reason>,
    /// Reasons why the model as a whole cannot be translated.
    pub blockers: Vec<Reason>,
    /// For each `_pause()` the condition under which it is called.
    pub pauses: Vec<Value>,
    /// Names read before they have a value of this pass: their value is an older one.
    pub older: BTreeSet<String>,
    /// Functions called by rates that read states or the time by their names, which have the values before the step there.
    pub older_in: BTreeSet<String>,
    /// Variables that fixed relations read before they write them, each with the place where it is first read.
    pub past: BTreeMap<String, Reason>,
    /// Index of the last statement of a page that writes a name.
    pub last: BTreeMap<String, usize>,
    /// Index of the statement of a page that is being executed.
    pub now: usize,
    /// Keys of locals by their names: of the page, and of each call.
    frames: Vec<BTreeMap<String, String>>,
    conditions: Vec<Value>,
    locals: usize,
    /// Line of the statement that is being executed.
    line: usize,
    work: usize,
    pub depth: usize,
}

impl<'a> Run<'a> {
    pub fn new(facts: &'a Facts, phase: Phase, place: Place) -> Self {
        // Locals of different phases have different numbers: they come into one list of definitions.
        let locals = match phase {
            Phase::Fixed => 1_000_000,
            _ => 0,
        };
        Self {
            facts,
            phase,
            place,
            values: BTreeMap::new(),
            kinds: BTreeMap::new(),
            order: Vec::new(),
            dropped: Vec::new(),
            blockers: Vec::new(),
            pauses: Vec::new(),
            older: BTreeSet::new(),
            older_in: BTreeSet::new(),
            past: BTreeMap::new(),
            last: BTreeMap::new(),
            now: 0,
            frames: vec![BTreeMap::new()],
            conditions: Vec::new(),
            locals,
            line: 0,
            work: 0,
            depth: 0,
        }
    }

    /// Executes pages one after the other. A name stands for its value as soon as nothing later writes it.
    pub fn pages(&mut self, pages: &[Page]) {
        let mut index = 0;
        for page in pages {
            for statement in &page.statements {
                index += 1;
                for name in self.facts.written_by(std::slice::from_ref(statement)) {
                    self.last.insert(name, index);
                }
            }
        }
        for page in pages {
            self.place = page.place.clone();
            // Locals belong to their page; their last writing statement is found like that of variables.
            self.frames = vec![BTreeMap::new()];
            let own = self.last_local_writes(&page.statements);
            for (at, statement) in page.statements.iter().enumerate() {
                self.now += 1;
                let returned = self.list(std::slice::from_ref(statement), 0).is_some();
                for (name, key) in &self.frames.first().cloned().unwrap_or_default() {
                    let last = own.get(name).copied().unwrap_or(at);
                    self.last.insert(key.clone(), self.now + last.saturating_sub(at));
                }
                if returned {
                    self.now += page.statements.len() - at - 1;
                    break;
                }
            }
        }
        self.now += 1;
    }

    fn last_local_writes(&self, statements: &[Statement]) -> BTreeMap<String, usize> {
        let mut last = BTreeMap::new();
        for (at, statement) in statements.iter().enumerate() {
            statement.walk(&mut |expression| {
                if let Node::Assignment(target, ..) = &expression.node
                    && let Some(name) = target.name()
                {
                    last.insert(name.to_owned(), at);
                }
            });
            if let StatementKind::Declaration(names) = &statement.kind {
                last.extend(names.iter().map(|(name, _)| (name.clone(), at)));
            }
        }
        last
    }

    /// Executes statements. Returns the value of `return`, if all ways lead to one; [`Value::Nothing`] for none behind it.
    pub fn list(&mut self, statements: &[Statement], depth: usize) -> Option<Known> {
        for (index, statement) in statements.iter().enumerate() {
            self.line = statement.line;
            if self.spend(statement.line).is_err() {
                self.spoil(std::slice::from_ref(statement), Obstacle::TooLong);
                continue;
            }
            match &statement.kind {
                StatementKind::Return(value) => {
                    return Some(value.as_ref().map_or(Ok(Value::Nothing), |value| self.value(value)));
                }
                StatementKind::If(condition, yes, no) => {
                    let rest = statements.get(index + 1..).unwrap_or_default();
                    if returns(yes) || returns(no) {
                        return self.branches_with_return(condition, [yes, no], rest, depth);
                    }
                    self.branches(condition, [yes, no]);
                }
                StatementKind::Block(inner) => {
                    if let Some(returned) = self.list(inner, depth) {
                        return Some(returned);
                    }
                }
                _ => self.statement(statement),
            }
        }
        None
    }

    fn spend(&mut self, line: usize) -> Result<(), Reason> {
        self.work += 1;
        if self.work > MOST_WORK { Err(self.reason(line, Obstacle::TooLong)) } else { Ok(()) }
    }

    /// Reason at a line; 0 stands for the statement that is being executed.
    pub fn reason(&self, line: usize, obstacle: Obstacle) -> Reason {
        let line = if line == 0 { self.line } else { line };
        Reason { place: self.place.at(line), obstacle }
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Expression(expression) => self.effect(expression),
            StatementKind::Declaration(names) => {
                for (name, value) in names {
                    let known = value.as_ref().map_or(Ok(Value::Nothing), |value| self.value(value));
                    let key = self.declare(name);
                    self.set(key, known);
                }
            }
            StatementKind::Other(word, ..) => {
                let obstacle = match *word {
                    "for" | "while" | "do" => Obstacle::Loop,
                    word => Obstacle::Statement(word.to_owned()),
                };
                self.spoil(std::slice::from_ref(statement), obstacle);
            }
            StatementKind::Function(function) => {
                let obstacle = Obstacle::Statement(format!("function {}", function.name));
                self.spoil(std::slice::from_ref(statement), obstacle);
            }
            StatementKind::If(..) | StatementKind::Block(_) | StatementKind::Return(_) => {}
        }
    }

    /// Declares a local of the innermost frame; returns its key.
    pub fn declare(&mut self, name: &str) -> String {
        self.locals += 1;
        let key = format!("{name}{LOCAL}{}", self.locals);
        if let Some(frame) = self.frames.last_mut() {
            frame.insert(name.to_owned(), key.clone());
        }
        key
    }

    pub fn local(&self, name: &str) -> Option<&String> {
        self.frames.last().and_then(|frame| frame.get(name))
    }

    /// Calls `body` with a frame of its own, one call deeper.
    pub fn in_frame<T>(&mut self, body: impl FnOnce(&mut Self) -> T) -> T {
        self.frames.push(BTreeMap::new());
        self.depth += 1;
        let result = body(self);
        self.depth -= 1;
        self.frames.pop();
        result
    }

    pub fn is_too_deep(&self) -> bool {
        self.depth >= DEEPEST
    }

    /// Executes an expression that stands as a statement.
    pub fn effect(&mut self, expression: &Expression) {
        match &expression.node {
            Node::Assignment(target, operator, value) => self.assignment(target, *operator, value),
            Node::Other("," | "++", parts) => parts.iter().for_each(|part| self.effect(part)),
            Node::Conditional(condition, yes, no) => {
                let as_statement = |inner: &Expression| {
                    vec![Statement { kind: StatementKind::Expression(inner.clone()), line: inner.line }]
                };
                self.branches(condition, [&as_statement(yes), &as_statement(no)]);
            }
            Node::Call(callee, arguments) => self.call_statement(expression, callee, arguments),
            _ => {}
        }
    }

    fn call_statement(&mut self, expression: &Expression, callee: &Expression, arguments: &[Expression]) {
        let line = expression.line;
        match callee.name() {
            Some("_pause") => {
                let condition = self.conditions.iter().cloned().reduce(Value::and).unwrap_or(Value::Truth(true));
                self.pauses.push(condition);
            }
            Some(name) if self.facts.function(name).is_some() => _ = self.inlined(name, arguments, line),
            _ => {
                let obstacle = self.view_obstacle(callee).unwrap_or_else(|| Obstacle::Call(callee.path()));
                // An unknown function may move anything.
                if matches!(obstacle, Obstacle::Call(_)) && callee.name().is_some() && self.phase != Phase::Function {
                    let reason = self.reason(line, obstacle.clone());
                    self.blockers.push(reason);
                }
                let statement = Statement { kind: StatementKind::Expression(expression.clone()), line };
                self.spoil(&[statement], obstacle);
            }
        }
    }

    fn assignment(&mut self, target: &Expression, operator: Option<Operator>, value: &Expression) {
        let Some(name) = target.name() else {
            // An element of an array, or a property of an element of the view.
            if let Some(root) =
                target.root().filter(|root| self.local(root).is_some() || self.facts.variable(root).is_some())
            {
                let known = Err(self.reason(target.line, Obstacle::Array(root.to_owned())));
                let key = self.local(root).cloned().unwrap_or_else(|| root.to_owned());
                self.set(key, known);
            } else {
                let obstacle =
                    self.view_obstacle(target).unwrap_or(Obstacle::Name(target.root().unwrap_or_default().to_owned()));
                let reason = self.reason(target.line, obstacle);
                self.dropped.push(reason);
            }
            return;
        };
        let known = match operator {
            None => self.value(value),
            Some(operator) => self.combined(operator, target, value),
        };
        let line = target.line;
        if let Some(key) = self.local(name).cloned() {
            self.set(key, known);
            return;
        }
        let Some(fact) = self.facts.variable(name) else {
            let reason = self.reason(line, Obstacle::Name(name.to_owned()));
            self.dropped.push(reason);
            return;
        };
        let is_motion = matches!(self.phase, Phase::Motion | Phase::Fixed);
        let is_time = fact.role == Role::Time || name == self.facts.equations.increment;
        if is_motion && (fact.role == Role::State || is_time) || self.phase == Phase::Event && is_time {
            let reason = self.reason(line, Obstacle::WritesState(name.to_owned()));
            self.blockers.push(reason);
            return;
        }
        let known = known.and_then(|value| {
            if fact.is_array {
                return Err(self.reason(line, Obstacle::Array(name.to_owned())));
            }
            self.coerced(value, fact.kind, line)
        });
        self.set(name.to_owned(), known);
    }

    /// Gives a variable or local its value.
    pub fn set(&mut self, key: String, known: Known) {
        let known = known
            .and_then(|value| if value.size() > LARGEST { Err(self.reason(0, Obstacle::TooLong)) } else { Ok(value) });
        if key.contains(LOCAL)
            && let Ok(value) = &known
            && let Some(kind) = self.kind(value)
        {
            self.kinds.insert(key.clone(), kind);
        }
        if !self.order.contains(&key) {
            self.order.push(key.clone());
        }
        self.values.insert(key, known);
    }

    /// Statements that cannot be executed: what they may write has no value, or, if that is nothing, they are dropped.
    pub(super) fn spoil(&mut self, statements: &[Statement], obstacle: Obstacle) {
        let line = statements.first().map_or(0, |statement| statement.line);
        let mut written = self.facts.written_by(statements);
        for statement in statements {
            statement.walk(&mut |expression| {
                if let Node::Assignment(target, ..) = &expression.node
                    && let Some(key) = target.root().and_then(|name| self.local(name))
                {
                    written.insert(key.clone());
                }
            });
        }
        let reason = self.reason(line, obstacle);
        if written.is_empty() {
            self.dropped.push(reason);
            return;
        }
        for key in written {
            let moves = matches!(self.facts.role(&key), Some(Role::State | Role::Time))
                || key == self.facts.equations.increment;
            if moves && self.phase != Phase::Start {
                self.blockers.push(reason.clone());
            }
            self.set(key, Err(reason.clone()));
        }
    }

    /// Executes under a further condition.
    pub(super) fn under<T>(&mut self, condition: Value, body: impl FnOnce(&mut Self) -> T) -> T {
        self.conditions.push(condition);
        let result = body(self);
        self.conditions.pop();
        result
    }

    /// Value of a local of the page that has been executed last.
    pub fn local_value(&self, name: &str) -> Option<Known> {
        self.values.get(self.local(name)?).cloned()
    }

    /// True if a name stands for its value from here on: nothing later in this pass writes it.
    pub fn is_settled(&self, key: &str) -> bool {
        self.last.get(key).is_none_or(|last| *last < self.now)
    }
}

/// True if statements contain a `return`.
fn returns(statements: &[Statement]) -> bool {
    statements.iter().any(|statement| match &statement.kind {
        StatementKind::Return(_) => true,
        _ => statement.inner().into_iter().any(|inner| returns(std::slice::from_ref(inner))),
    })
}
