//! Helpers of the tests: compiling, evaluating a node, and diagnostics as plain text.
pub mod catalogue;

use model::{Diagnostic, Edit, Fix, Severity};
use program::{Graph, Model, Node, NodeId, Variable};

/// Value of the quantity `name` for these values of the states.
pub fn quantity_value(model: &Model, states: &[f64], name: &str) -> f64 {
    let quantity = model.quantities.iter().find(|quantity| quantity.name == name).unwrap();
    At::new(model, 0.0, states).value(&model.graph, quantity.value.node)
}

/// Compiles a text that consists of a model only; it must have no errors.
#[track_caller]
pub fn compile(source: &str) -> Model {
    let (model, diagnostics) = model::compile(source, std::slice::from_ref(&(0..source.len())));
    let model = model.map(|checked| checked.model);
    model.unwrap_or_else(|| panic!("{}", render(source, &diagnostics)))
}

/// Diagnostics of a text that consists of a model only.
pub fn diagnostics(source: &str) -> String {
    let compile = |source: &str| model::compile(source, std::slice::from_ref(&(0..source.len()))).1;
    let diagnostics = compile(source);
    check_fixes(source, &diagnostics, compile);
    render(source, &diagnostics)
}

/// The text after a fix.
pub fn applied(fix: &Fix, source: &str) -> String {
    let mut edits: Vec<&Edit> = fix.edits.iter().collect();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.span.start));
    let mut text = source.to_owned();
    edits.iter().for_each(|edit| text.replace_range(edit.span.range(), &edit.text));
    text
}

/// Applies each fix: fewer diagnostics with its code and message must remain.
#[track_caller]
pub fn check_fixes(source: &str, diagnostics: &[Diagnostic], again: impl Fn(&str) -> Vec<Diagnostic>) {
    for diagnostic in diagnostics {
        for fix in &diagnostic.fixes {
            let text = applied(fix, source);
            assert_ne!(text, source, "{diagnostic:?}");
            let left = again(&text);
            let same = |other: &&Diagnostic| (other.code, &other.message) == (diagnostic.code, &diagnostic.message);
            let (before, after) = (diagnostics.iter().filter(same).count(), left.iter().filter(same).count());
            assert!(after < before, "{text}\n{}", render(&text, &left));
        }
    }
}

/// Diagnostics as plain text: code and message, places with their texts, notes, hints and fixes.
pub fn render(source: &str, diagnostics: &[Diagnostic]) -> String {
    let mut text = String::new();
    for diagnostic in diagnostics {
        let severity = if diagnostic.severity == Severity::Error { "error" } else { "warning" };
        text += &format!("{severity} [{}]: {}\n", diagnostic.code, diagnostic.message.english());
        for label in &diagnostic.labels {
            let line = source[..label.span.start].matches('\n').count() + 1;
            let quoted = source[label.span.range()].replace('\n', " ");
            let says = if label.text.is_empty() { String::new() } else { format!(": {}", label.text.english()) };
            text += &format!("  {line}: `{quoted}`{says}\n");
        }
        for note in diagnostic.notes.iter().map(units::Words::english) {
            text.extend(note.lines().map(|line| format!("  | {line}\n")));
        }
        for hint in &diagnostic.hints {
            text += &format!("  hint: {}\n", hint.english());
        }
        for fix in &diagnostic.fixes {
            text += &format!("  fix: {}\n", fix.title(source).english().replace('\n', "\\n"));
        }
    }
    text
}

/// Inputs for the evaluation of nodes.
pub struct At {
    pub parameters: Vec<f64>,
    pub initial: Vec<f64>,
    pub time: f64,
    pub states: Vec<f64>,
}

impl At {
    /// Default parameters with a time and states.
    pub fn new(model: &Model, time: f64, states: &[f64]) -> Self {
        let parameters: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
        let mut at = Self { parameters, initial: vec![f64::NAN; states.len()], time, states: states.to_vec() };
        at.initial = model.states.iter().map(|state| at.value(&model.graph, state.initial)).collect();
        at
    }

    /// Value of a node, by evaluating the graph.
    pub fn value(&self, graph: &Graph, root: NodeId) -> f64 {
        let mut values = vec![f64::NAN; graph.len()];
        for id in graph.reachable(&[root]) {
            let of = |id: NodeId| values[id.0 as usize];
            values[id.0 as usize] = match graph.node(id) {
                Node::Constant(bits) => f64::from_bits(bits),
                Node::Parameter(index) => self.parameters[index as usize],
                Node::Initial(index) => self.initial[index as usize],
                Node::Independent => self.time,
                Node::State(index) => self.states[index as usize],
                Node::Piece(number, x) => graph.interpolations()[number as usize].piece(of(x)),
                Node::Interpolated(number, x, piece) => graph.interpolations()[number as usize].value(of(x), of(piece)),
                Node::Unary(function, x) => function.evaluate(of(x)),
                Node::Binary(function, a, b) => function.evaluate(of(a), of(b)),
                Node::Select(condition, chosen, other) => {
                    if of(condition) != 0.0 {
                        of(chosen)
                    } else {
                        of(other)
                    }
                }
                Node::Friction(..) | Node::Binomial(..) => f64::NAN,
                Node::Solution { system, row } => {
                    let system = &graph.systems()[system as usize];
                    let right: Vec<f64> = system.right.iter().map(|&entry| of(entry)).collect();
                    let mut matrix = vec![0.0; right.len() * right.len()];
                    for entry in &system.entries {
                        matrix[entry.row as usize * right.len() + entry.column as usize] = of(entry.node);
                    }
                    eliminate(matrix, right)[row as usize]
                }
            };
        }
        values[root.0 as usize]
    }
}

/// Gaussian elimination with pivoting.
fn eliminate(mut matrix: Vec<f64>, mut right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    for column in 0..n {
        let pivot =
            (column..n).max_by(|&a, &b| matrix[a * n + column].abs().total_cmp(&matrix[b * n + column].abs())).unwrap();
        for k in 0..n {
            matrix.swap(column * n + k, pivot * n + k);
        }
        right.swap(column, pivot);
        for row in column + 1..n {
            let factor = matrix[row * n + column] / matrix[column * n + column];
            for k in column..n {
                matrix[row * n + k] -= factor * matrix[column * n + k];
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..n).rev() {
        for k in row + 1..n {
            right[row] -= matrix[row * n + k] * right[k];
        }
        right[row] /= matrix[row * n + row];
    }
    right
}

/// Value of a name with primes.
#[track_caller]
pub fn value(model: &Model, at: &At, name: &str, order: u32) -> f64 {
    let compiled = model.lookup(name, order).unwrap_or_else(|| panic!("no {name} with {order} primes"));
    at.value(&model.graph, compiled.node)
}

/// Compares with a relative tolerance of a few rounding errors.
#[track_caller]
pub fn assert_near(found: f64, expected: f64) {
    let scale = expected.abs().max(1e-3);
    assert!((found - expected).abs() <= 1e-12 * scale, "{found} instead of {expected}");
}

/// Derivative by central differences, accurate to about nine digits.
pub fn difference(model: &Model, at: &At, node: NodeId, variable: Variable) -> f64 {
    let moved = |by: f64| {
        let mut at = At {
            parameters: at.parameters.clone(),
            initial: at.initial.clone(),
            time: at.time,
            states: at.states.clone(),
        };
        match variable {
            Variable::State(index) => at.states[index as usize] += by,
            Variable::Parameter(index) => at.parameters[index as usize] += by,
            Variable::Initial(index) => at.initial[index as usize] += by,
            Variable::Independent => at.time += by,
        }
        at.value(&model.graph, node)
    };
    let h = 1e-4;
    // Fourth order: the error is of the order of h^4.
    (8.0 * (moved(h) - moved(-h)) - (moved(2.0 * h) - moved(-2.0 * h))) / (12.0 * h)
}
