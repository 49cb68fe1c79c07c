//! What an editor lists of a document: its blocks with what they declare.

use super::names::{FUNCTION, declared_by};
use super::vocabulary;
use crate::{Block, BlockKind, Outline};
use model::{Span, Statement, StatementKind, inside};
use units::Words;

/// Longest name of a symbol in characters; longer texts are cut and end with dots.
const LONGEST: usize = 60;

/// Kind of a symbol, for its icon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// A fenced block.
    Block,
    /// A name that the model declares.
    Name,
    /// A function of the document.
    Function,
    /// An equation.
    Equation,
    /// An event.
    Event,
    /// An entry with a title: a plot, a preset, a claim, an item of the survey.
    Entry,
}

/// A part of a document with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// Its name, as written.
    pub name: String,
    /// Short description; may be empty.
    pub meaning: Words,
    /// Its kind.
    pub kind: SymbolKind,
    /// Whole place.
    pub span: Span,
    /// Place of the name, inside of it.
    pub named: Span,
    /// Symbols inside it, in text order.
    pub children: Vec<Symbol>,
}

/// The fenced blocks of a document with what they declare, in text order.
pub fn symbols(outline: &Outline) -> Vec<Symbol> {
    let fenced = outline.blocks().iter().filter(|block| block.fence.is_some());
    fenced.map(|block| of_block(outline, block)).collect()
}

fn of_block(outline: &Outline, block: &Block) -> Symbol {
    let (source, head) = (outline.source(), block.head());
    let children = match block.kind {
        BlockKind::Plots | BlockKind::Presets | BlockKind::Check | BlockKind::Survey => entries(source, block),
        _ => block.statements.iter().flat_map(|statement| of_statement(outline, statement)).collect(),
    };
    let word = block.kind.word();
    let meaning = vocabulary::BLOCKS.iter().find(|(known, _)| *known == word);
    Symbol {
        name: cut(source[head.range()].trim_matches([' ', '`', '~'])),
        meaning: meaning.map(|(_, meaning)| meaning.clone()).unwrap_or_default(),
        kind: SymbolKind::Block,
        span: block.span,
        named: head,
        children,
    }
}

/// Sentences with a title; a group of presets is none.
fn entries(source: &str, block: &Block) -> Vec<Symbol> {
    let listed = block.sentences.iter().filter(|one| one.head.is_none() || block.kind == BlockKind::Survey);
    let titled = listed.filter_map(|sentence| {
        let named = sentence.title?;
        Some(leaf(inside(source, named), Words::default(), SymbolKind::Entry, sentence.span, named))
    });
    titled.collect()
}

/// The names that a statement declares; an equation and an event without a name by what is written.
fn of_statement(outline: &Outline, statement: &Statement) -> Vec<Symbol> {
    let (source, span) = (outline.source(), statement.span);
    let written = |kind| {
        let text = source[span.range()].split(['{', '\n']).next().unwrap_or_default();
        let named = Span::new(span.start, span.start + text.len());
        let label = statement.label.as_ref().map(|label| Words::same(label.text.clone()));
        vec![leaf(text, label.unwrap_or_default(), kind, span, named)]
    };
    let declared = declared_by(outline, statement).into_iter().map(|one| {
        let kind = match statement.kind {
            StatementKind::Event { .. } => SymbolKind::Event,
            _ if one.what == FUNCTION => SymbolKind::Function,
            _ => SymbolKind::Name,
        };
        let meaning = one.label.map_or(one.what, |label| Words::same(label.to_owned()));
        leaf(&source[one.span.range()], meaning, kind, span, one.span)
    });
    match &statement.kind {
        StatementKind::Equation { .. } => written(SymbolKind::Equation),
        StatementKind::Event { extras, .. } if extras.name.is_none() => written(SymbolKind::Event),
        _ => declared.collect(),
    }
}

fn leaf(name: &str, meaning: Words, kind: SymbolKind, span: Span, named: Span) -> Symbol {
    Symbol { name: cut(name), meaning, kind, span, named, children: Vec::new() }
}

/// A text without outer blanks, cut to the longest name. A symbol cannot be without a name.
fn cut(text: &str) -> String {
    let text = text.trim();
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} ...", text[..end].trim_end()),
        None if text.is_empty() => "...".to_owned(),
        None => text.to_owned(),
    }
}
