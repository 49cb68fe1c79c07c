//! Asked answers that no claim compares with a run.

use program::{NodeId, Program};
use std::collections::HashSet;
use units::{Words, words};

/// One remark for each value that a question asks for and no claim uses, in the order of the questions.
pub fn untested(program: &Program) -> Vec<Words> {
    let graph = &program.model.graph;
    let claims = program.checks.iter().flat_map(|check| &check.claims);
    let roots: Vec<NodeId> =
        claims.flat_map(|claim| claim.values().into_iter().map(|value| value.node).chain(claim.condition())).collect();
    let tested: HashSet<NodeId> = graph.reachable(&roots).into_iter().collect();
    let mut remarks = Vec::new();
    let mut named = Vec::new();
    for (number, question) in (1..).zip(&program.questions) {
        let Some(answer) = question.number().map(|asked| asked.right.node) else { continue };
        if tested.contains(&answer) || graph.as_constant(answer).is_some() {
            continue;
        }
        let parts = parts(program, answer);
        if parts.is_empty() {
            remarks.push(words!("nothing tests the answer to question {number}"));
        }
        for (name, node) in parts {
            if !tested.contains(&node) && !named.contains(&name) {
                named.push(name.clone());
                remarks
                    .push(words!("nothing tests {name}, which question {number} asks for", name = Words::same(name)));
            }
        }
    }
    remarks
}

/// The named definitions that an answer is computed from directly.
fn parts(program: &Program, answer: NodeId) -> Vec<(String, NodeId)> {
    let model = &program.model;
    let mut found = Vec::new();
    let mut waiting = vec![answer];
    let mut seen = HashSet::new();
    while let Some(node) = waiting.pop() {
        if !seen.insert(node) {
            continue;
        }
        match model.quantities.iter().find(|quantity| quantity.value.node == node && !quantity.remembered) {
            Some(quantity) => found.push((quantity.name.clone(), node)),
            None => model.graph.for_each_operand(node, |operand| waiting.push(operand)),
        }
    }
    found.sort();
    found.dedup();
    found
}
