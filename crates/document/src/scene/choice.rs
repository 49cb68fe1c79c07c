//! Attributes whose text depends on the value of an expression: visibility and colours.

use super::builder::Builder;
use super::colours::{colour, no_colour};
use crate::expressions::Placed;
use model::Diagnostic;
use program::{Attribute, Kind, Node, NodeId, Piece};
use std::collections::BTreeSet;
use std::ops::Range;
use units::words;

impl Builder<'_, '_> {
    /// Compiles `visible="CONDITION"`.
    pub fn visible(&mut self, range: Range<usize>) -> Option<Attribute> {
        let range = self.inside_braces(range);
        let condition = self.expressions.compile(range)?;
        if condition.value.kind != Kind::Truth {
            let mut diagnostic =
                Diagnostic::error("not-a-condition", words("`visible` needs a condition"), condition.span);
            diagnostic.hints.push(words("such as `visible=\"x > 0 [m]\"`"));
            self.expressions.diagnostics.push(diagnostic);
            return None;
        }
        let texts = vec![(0, "none".to_owned()), (1, "inline".to_owned())];
        Some(Attribute { name: "display".to_owned(), value: vec![self.chosen(condition, texts)?] })
    }

    /// A colour that an expression selects among texts.
    pub fn colour(&mut self, chosen: Placed) -> Option<Piece> {
        let mut leaves = BTreeSet::new();
        let all_known = self.leaves(chosen.value.node, &mut leaves);
        let names = &self.expressions.model().texts;
        let candidates: Vec<u32> =
            if all_known { leaves.iter().copied().collect() } else { (0..names.len() as u32).collect() };
        let mut texts = Vec::new();
        for number in candidates {
            let Some(name) = names.get(number as usize) else { continue };
            match colour(name) {
                Some(colour) => texts.push((number, colour)),
                None if leaves.contains(&number) => {
                    let found = no_colour(name, chosen.span);
                    self.expressions.diagnostics.push(found);
                    return None;
                }
                None => {}
            }
        }
        self.chosen(chosen, texts)
    }

    /// Piece that selects a text by a value; a constant value is resolved at once.
    fn chosen(&mut self, value: Placed, texts: Vec<(u32, String)>) -> Option<Piece> {
        if let Some(constant) = self.graph().as_constant(value.value.node) {
            let (_, text) = texts.into_iter().find(|(number, _)| f64::from(*number) == constant)?;
            return Some(Piece::Literal(text));
        }
        Some(Piece::Choice { index: self.value(value)?, texts })
    }

    /// Collects the texts among which a node selects. Returns true if it can have no other value.
    fn leaves(&self, node: NodeId, leaves: &mut BTreeSet<u32>) -> bool {
        let graph = &self.expressions.model().graph;
        let (mut open, mut seen, mut all_known) = (vec![node], BTreeSet::new(), true);
        while let Some(node) = open.pop() {
            if !seen.insert(node) {
                continue;
            }
            match graph.node(node) {
                Node::Constant(bits) => drop(leaves.insert(f64::from_bits(bits) as u32)),
                Node::Select(_, yes, no) => open.extend([yes, no]),
                _ => all_known = false,
            }
        }
        all_known
    }
}
