//! Families: x with index i as a subscript, sums over i, and "i = 1, ..., N".

use super::expression::{Typesetter, function_sign, parenthesised};
use crate::{Expression, Name, Over};
use units::mathml::name;

impl Typesetter<'_> {
    /// The indices of a member.
    pub(super) fn indices(&self, indices: &[Expression]) -> Vec<String> {
        indices.iter().map(|index| self.expression(index)).collect()
    }

    /// A name with its indices.
    pub(super) fn member(&self, name: &str, indices: &[Expression], order: u32) -> String {
        self.indexed(name, &self.indices(indices), order, None)
    }

    /// A reduction: `∑` with the range of its index; minimum and maximum with the range below them.
    pub(super) fn reduction(&self, function: &Name, body: &Expression, over: &[Over]) -> String {
        if function.text != "sum" {
            let ranges = over.iter().map(|over| self.range(over)).collect::<Vec<_>>().join("<mo>,</mo>");
            let sign = format!("<munder>{}<mrow>{ranges}</mrow></munder>", function_sign(&function.text));
            return format!("<mrow>{sign}<mo>&#x2061;</mo>{}</mrow>", parenthesised(&self.expression(body)));
        }
        let signs: String = over
            .iter()
            .map(|over| {
                let low =
                    format!("<mrow>{}<mo>=</mo>{}</mrow>", name(&over.index.text, 0, None), self.expression(&over.low));
                format!(
                    "<munderover><mo movablelimits=\"false\">∑</mo>{low}{}</munderover>",
                    self.expression(&over.high)
                )
            })
            .collect();
        format!("<mrow>{signs}{}</mrow>", self.term(body))
    }

    /// Ranges after a statement that is repeated for all values of its indices.
    pub(super) fn for_all(&self, over: &[Over]) -> String {
        let ranges: Vec<String> = over.iter().map(|over| self.range(over)).collect();
        if ranges.is_empty() {
            return String::new();
        }
        format!("<mspace width=\"1.5em\"/>{}", ranges.join("<mo separator=\"true\">,</mo>"))
    }

    fn range(&self, over: &Over) -> String {
        let (low, high) = (self.expression(&over.low), self.expression(&over.high));
        format!("<mrow>{}<mo>=</mo>{low}<mo>,</mo><mo>…</mo><mo>,</mo>{high}</mrow>", name(&over.index.text, 0, None))
    }
}
