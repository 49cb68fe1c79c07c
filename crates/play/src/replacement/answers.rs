//! Comparison of questions of two programs.

use super::names::Names;
use crate::Basis;
use program::{NodeId, Question, QuestionKind};

/// True if two kinds differ at most in their values.
fn is_same_kind(one: &QuestionKind, other: &QuestionKind) -> bool {
    match (one, other) {
        (QuestionKind::Number(one), QuestionKind::Number(other)) => {
            let allowed = |number: &program::NumberAnswer| -> Vec<_> {
                number.wrong.iter().map(|wrong| wrong.tolerance).chain([number.tolerance]).collect()
            };
            one.unit == other.unit && allowed(one) == allowed(other)
        }
        (QuestionKind::Choice(one), QuestionKind::Choice(other)) => one == other,
        _ => false,
    }
}

/// True if the answer to a question is the same expression as that of a former question.
pub(crate) fn asks_the_same((basis, index): (&Basis, usize), (before, former): (&Basis, usize), names: &Names) -> bool {
    let (Some(asked), Some(other)) = (basis.program().questions.get(index), before.program().questions.get(former))
    else {
        return false;
    };
    let nodes = |question: &Question| -> Vec<NodeId> {
        let setup = question.setup.iter().map(|assignment| assignment.value.node);
        setup.chain(question.values().map(|value| value.node)).collect()
    };
    let (mut own, mut others) = (nodes(asked), nodes(other));
    // Initial values in an answer are compared by their expressions in the model.
    for state in others.clone().into_iter().flat_map(|node| before.model().depends(node).initial) {
        let now = names.state(state as usize).and_then(|state| basis.model().states.get(state));
        let (Some(now), Some(then)) = (now, before.model().states.get(state as usize)) else { return false };
        own.push(now.initial);
        others.push(then.initial);
    }
    let sets = asked.setup.iter().map(|assignment| Some(assignment.parameter));
    is_same_kind(&asked.kind, &other.kind)
        && sets.eq(other.setup.iter().map(|assignment| names.parameter(assignment.parameter)))
        && before.model().graph.same(&others, &basis.model().graph, &own, |node| names.input(node))
}
