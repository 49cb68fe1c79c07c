//! Attributes that take one of several texts by the value of an expression: whether an element is shown, and colours.

use super::builder::Builder;
use crate::expressions::Placed;
use model::{Diagnostic, Span};
use program::{Attribute, Kind, Node, NodeId, Piece};
use std::collections::BTreeSet;
use std::ops::Range;
use units::{Words, words};

/// The theme's colours by the names that documents use, each with a colour for where there is no theme.
pub const PALETTE: [(&str, &str); 6] = [
    ("text", "currentColor"),
    ("liquid", "var(--liquid, #3f9fc0)"),
    ("liquid-deep", "var(--liquid-deep, #1c7699)"),
    ("glass", "var(--glass, #6d7d86)"),
    ("accent", "var(--accent, #0a6076)"),
    ("mark", "var(--mark, #c4551d)"),
];

/// Colours that have a name in every browser.
const NAMED: [&str; 34] = [
    "none",
    "transparent",
    "currentColor",
    "black",
    "white",
    "gray",
    "grey",
    "silver",
    "red",
    "maroon",
    "crimson",
    "tomato",
    "orange",
    "gold",
    "yellow",
    "olive",
    "lime",
    "green",
    "teal",
    "turquoise",
    "cyan",
    "blue",
    "navy",
    "purple",
    "violet",
    "indigo",
    "magenta",
    "pink",
    "salmon",
    "brown",
    "tan",
    "beige",
    "khaki",
    "orchid",
];

/// Whether an attribute is a colour.
pub fn is_colour(attribute: &str) -> bool {
    matches!(attribute, "fill" | "stroke" | "color" | "stop-color")
}

/// What a name of the palette stands for.
pub fn palette(name: &str) -> Option<&'static str> {
    PALETTE.iter().find(|(known, _)| *known == name.trim()).map(|(_, colour)| *colour)
}

/// A colour as it is written into the page: of the palette, a named one, or `#rgb` and `#rrggbb`.
fn colour(text: &str) -> Option<String> {
    let text = text.trim();
    let is_hexadecimal =
        |digits: &str| matches!(digits.len(), 3 | 6) && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    palette(text)
        .or_else(|| NAMED.into_iter().find(|known| *known == text))
        .map(str::to_owned)
        .or_else(|| text.strip_prefix('#').filter(|digits| is_hexadecimal(digits)).map(|_| text.to_owned()))
}

impl Builder<'_, '_> {
    /// `visible="CONDITION"`
    pub fn visible(&mut self, range: Range<usize>) -> Option<Attribute> {
        let range = self.inside_braces(range);
        let condition = self.expressions.compile(range)?;
        if condition.value.kind != Kind::Truth {
            let mut diagnostic = Diagnostic::error(
                "not-a-condition",
                words("`visible` needs a condition", "`visible` necesita una condición"),
                condition.span,
            );
            diagnostic.hints.push(words("such as `visible=\"x > 0 [m]\"`", "por ejemplo `visible=\"x > 0 [m]\"`"));
            self.expressions.diagnostics.push(diagnostic);
            return None;
        }
        let texts = vec![(0, "none".to_owned()), (1, "inline".to_owned())];
        Some(Attribute { name: "display".to_owned(), value: vec![self.chosen(condition, texts)?] })
    }

    /// A colour that an expression chooses among texts.
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
                    let (message, hint) = no_colour(name);
                    self.refuse_at(message, chosen.span, Some(hint));
                    return None;
                }
                None => {}
            }
        }
        self.chosen(chosen, texts)
    }

    /// The text for a value; that of a constant at once.
    fn chosen(&mut self, value: Placed, texts: Vec<(u32, String)>) -> Option<Piece> {
        if let Some(constant) = self.graph().as_constant(value.value.node) {
            let (_, text) = texts.into_iter().find(|(number, _)| f64::from(*number) == constant)?;
            return Some(Piece::Literal(text));
        }
        Some(Piece::Choice { index: self.value(value)?, texts })
    }

    /// Collects the texts that a node chooses from; whether those are all it can be.
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

    /// Reports what is left out.
    pub fn refuse_at(&mut self, message: Words, span: Span, hint: Option<Words>) {
        self.refuse(message, span.start..span.end, hint);
    }
}

fn no_colour(name: &str) -> (Words, Words) {
    let palette = PALETTE.map(|(name, _)| name).join(", ");
    (
        words!("\"{name}\" is not a colour", "«{name}» no es un color"),
        words!(
            "colours are those of the page ({palette}), common English names such as red, and `#c4551d`",
            "los colores son los de la página ({palette}), nombres ingleses comunes como red, y `#c4551d`"
        ),
    )
}
