//! Evaluation order of definitions, and detection of circular ones.

use super::declarations::Declarations;
use super::scope::Meaning;
use super::traverse::for_each_name;
use crate::matching::blocks;
use crate::notation::quote;
use crate::{Diagnostic, Expression, ExpressionKind};
use units::{Conjunction, Words, words};

/// Indices of definitions, each after those that it uses. Members of circles and definitions that use them are left out.
/// Each circle is reported.
pub(crate) fn definition_order(declarations: &Declarations, diagnostics: &mut Vec<Diagnostic>) -> Vec<usize> {
    let uses = uses(declarations);
    let order = sorted(&uses);
    if order.len() < uses.len() {
        report_circles(declarations, &uses, &order, diagnostics);
    }
    order
}

/// For each definition, the indices of the definitions that it uses, each once.
fn uses(declarations: &Declarations) -> Vec<Vec<usize>> {
    let uses_of = |value| {
        let mut used = Vec::new();
        for_each_name(value, |name, _, _| {
            if let Some(Meaning::Definition(index)) = declarations.scope.meaning(name)
                && !used.contains(&index)
            {
                used.push(index);
            }
        });
        used
    };
    declarations.definitions.iter().map(|definition| uses_of(definition.value)).collect()
}

/// Topological order: each index after all that it uses. Members of circles and their users are missing.
fn sorted(uses: &[Vec<usize>]) -> Vec<usize> {
    let mut users: Vec<Vec<usize>> = vec![Vec::new(); uses.len()];
    let mut missing: Vec<usize> = uses.iter().map(Vec::len).collect();
    for (user, used) in uses.iter().enumerate() {
        for &index in used {
            users[index].push(user);
        }
    }
    let mut order: Vec<usize> = (0..uses.len()).filter(|&index| missing[index] == 0).collect();
    let mut next = 0;
    while next < order.len() {
        for &user in &users[order[next]] {
            missing[user] -= 1;
            if missing[user] == 0 {
                order.push(user);
            }
        }
        next += 1;
    }
    order
}

/// Reports the circles among the definitions that could not be sorted.
fn report_circles(
    declarations: &Declarations,
    uses: &[Vec<usize>],
    order: &[usize],
    diagnostics: &mut Vec<Diagnostic>,
) {
    let mut remaining = vec![true; uses.len()];
    order.iter().for_each(|&index| remaining[index] = false);
    let among: Vec<Vec<usize>> =
        uses.iter().map(|used| used.iter().copied().filter(|&index| remaining[index]).collect()).collect();
    for members in blocks(&among) {
        if members.iter().any(|&member| among[member].iter().any(|used| members.contains(used))) {
            diagnostics.push(circle(declarations, &members, &among));
        }
    }
}

fn circle(declarations: &Declarations, members: &[usize], uses: &[Vec<usize>]) -> Diagnostic {
    let name = |index: usize| declarations.definitions[index].name;
    let first = name(members[0]);
    if members.len() == 1 {
        let text = &first.text;
        let extremum = extremum(text, declarations.definitions[members[0]].value);
        let diagnostic = Diagnostic::error("cycle", words!("`{text}` is defined by itself"), first.span);
        return match extremum {
            Some((keeps, other)) => {
                diagnostic.with_hint(words!("what it was so far is kept by the run: `{text} = {keeps}({other})`"))
            }
            None => diagnostic
                .with_hint(words!("for a differential equation write `{text}' = ...` and give `{text}(0)`"))
                .with_hint(words!(
                    "what events change is declared with its value at the start: `discrete {text} = ...`"
                )),
        };
    }
    let names: Vec<String> = members.iter().map(|&index| format!("`{}`", name(index).text)).collect();
    let message = words!("the definitions of {names} go in a circle", names = list(&names));
    let mut diagnostic = Diagnostic::error("cycle", message, first.span);
    for (position, &index) in members.iter().enumerate() {
        let used = uses[index].iter().filter(|used| members.contains(used));
        let used: Vec<String> = used.map(|&used| format!("`{}`", name(used).text)).collect();
        let text = words!("uses {used}", used = list(&used));
        diagnostic =
            if position == 0 { diagnostic.saying(text) } else { diagnostic.with_label(name(index).span, text) };
    }
    diagnostic
}

/// `maximum` and `x` for `max(A, x)`: in other tools A would be updated in every step.
fn extremum(name: &str, value: &Expression) -> Option<(&'static str, String)> {
    let ExpressionKind::Call { function, arguments } = &value.kind else { return None };
    let keeps = match function.text.as_str() {
        "max" => "maximum",
        "min" => "minimum",
        _ => return None,
    };
    let itself = |one: &Expression| matches!(&one.kind, ExpressionKind::Name { name: own, order: 0 } if own == name);
    match arguments.as_slice() {
        [own, other] | [other, own] if itself(own) => Some((keeps, quote(other))),
        _ => None,
    }
}

/// Maximum number of items in a list.
const LONGEST_LIST: usize = 8;

/// `a`, `a and b`, `a, b and c`; of a long list, the first items and the number of others.
pub(crate) fn list(items: &[String]) -> Words {
    if items.len() > LONGEST_LIST {
        let (first, others) = items.split_at(LONGEST_LIST - 1);
        let (first, others) = (first.join(", "), others.len());
        return words!("{first} and {others} others");
    }
    Words::list(items.to_vec(), Conjunction::And)
}

/// `a`, `a or b`, `a, b or c`
pub(crate) fn alternatives(items: &[String]) -> Words {
    Words::list(items.to_vec(), Conjunction::Or)
}
