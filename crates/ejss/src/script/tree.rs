//! Syntax tree of the JavaScript subset.

/// Expression with its line in the text, from 1.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Expression {
    pub node: Node,
    pub line: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Node {
    /// Number as it is written, and its value.
    Number(String, f64),
    Text(String),
    Truth(bool),
    /// `undefined` or `null`.
    Nothing,
    Name(String),
    Unary(Operator, Box<Expression>),
    Binary(Operator, Box<Expression>, Box<Expression>),
    Conditional(Box<Expression>, Box<Expression>, Box<Expression>),
    /// Target, operator of a compound assignment, and value.
    Assignment(Box<Expression>, Option<Operator>, Box<Expression>),
    Call(Box<Expression>, Vec<Expression>),
    Member(Box<Expression>, String),
    Index(Box<Expression>, Box<Expression>),
    Array(Vec<Expression>),
    Function(Function),
    /// Object, regular expression, `new`, and what else has no counterpart; the expressions in it.
    Other(&'static str, Vec<Expression>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Plus,
    Minus,
    Times,
    Over,
    Remainder,
    Power,
    Equal,
    Different,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    And,
    Or,
    Not,
    /// `&`, `|`, `^`, shifts: they work on the bits of integers.
    Bits,
}

/// Function with its name, which may be empty.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Function {
    pub name: String,
    pub arguments: Vec<String>,
    pub body: Vec<Statement>,
}

/// Statement with its line, from 1.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Statement {
    pub kind: StatementKind,
    pub line: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum StatementKind {
    Expression(Expression),
    /// Names of `var`, `let` or `const` with their values.
    Declaration(Vec<(String, Option<Expression>)>),
    If(Expression, Vec<Statement>, Vec<Statement>),
    Block(Vec<Statement>),
    Return(Option<Expression>),
    Function(Function),
    /// `for`, `while`, `switch`, `try` ..: the word, the expressions of the head, and all statements inside.
    Other(&'static str, Vec<Expression>, Vec<Statement>),
}

impl Expression {
    /// Name of a variable, if the expression is one.
    pub fn name(&self) -> Option<&str> {
        match &self.node {
            Node::Name(name) => Some(name),
            _ => None,
        }
    }

    /// Name at the root of a path such as `a.b[2].c`.
    pub fn root(&self) -> Option<&str> {
        match &self.node {
            Node::Name(name) => Some(name),
            Node::Member(object, _) | Node::Index(object, _) => object.root(),
            Node::Call(callee, _) => callee.root(),
            _ => None,
        }
    }

    /// The path as it is written, such as `navigator.userAgent`, for a message.
    pub fn path(&self) -> String {
        match &self.node {
            Node::Name(name) => name.clone(),
            Node::Member(object, member) => format!("{}.{member}", object.path()),
            Node::Index(object, _) => format!("{}[]", object.path()),
            Node::Call(callee, _) => format!("{}()", callee.path()),
            _ => "…".to_owned(),
        }
    }

    /// Expressions directly inside.
    pub fn parts(&self) -> Vec<&Self> {
        match &self.node {
            Node::Unary(_, inner) | Node::Member(inner, _) => vec![inner],
            Node::Binary(_, left, right) | Node::Assignment(left, _, right) | Node::Index(left, right) => {
                vec![left, right]
            }
            Node::Conditional(condition, yes, no) => vec![condition, yes, no],
            Node::Call(callee, arguments) => std::iter::once(&**callee).chain(arguments).collect(),
            Node::Array(parts) | Node::Other(_, parts) => parts.iter().collect(),
            Node::Number(..) | Node::Text(_) | Node::Truth(_) | Node::Nothing | Node::Name(_) | Node::Function(_) => {
                Vec::new()
            }
        }
    }

    /// Calls `visit` with this expression and all inside it; functions are not entered.
    pub fn walk(&self, visit: &mut dyn FnMut(&Self)) {
        visit(self);
        for part in self.parts() {
            part.walk(visit);
        }
    }
}

impl Statement {
    /// Statements directly inside.
    pub fn inner(&self) -> Vec<&Self> {
        match &self.kind {
            StatementKind::If(_, yes, no) => yes.iter().chain(no).collect(),
            StatementKind::Block(inner) | StatementKind::Other(_, _, inner) => inner.iter().collect(),
            StatementKind::Expression(_)
            | StatementKind::Declaration(_)
            | StatementKind::Return(_)
            | StatementKind::Function(_) => Vec::new(),
        }
    }

    /// Expressions directly inside.
    pub fn expressions(&self) -> Vec<&Expression> {
        match &self.kind {
            StatementKind::Expression(expression) | StatementKind::If(expression, ..) => vec![expression],
            StatementKind::Declaration(names) => names.iter().filter_map(|(_, value)| value.as_ref()).collect(),
            StatementKind::Return(value) => value.iter().collect(),
            StatementKind::Other(_, head, _) => head.iter().collect(),
            StatementKind::Block(_) | StatementKind::Function(_) => Vec::new(),
        }
    }

    /// Calls `visit` with all expressions of the statement and of those inside it; functions are not entered.
    pub fn walk(&self, visit: &mut dyn FnMut(&Expression)) {
        for expression in self.expressions() {
            expression.walk(visit);
        }
        for inner in self.inner() {
            inner.walk(visit);
        }
    }
}
