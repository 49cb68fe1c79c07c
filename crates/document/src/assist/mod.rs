//! Editing help: completions at a place ([`complete`]), explanations ([`explain`]), the places of a name ([`uses()`]) and a list of
//! what a document contains ([`symbols()`]). All work while the text has errors.

mod names;
mod place;
mod suggestion;
mod symbols;
mod uses;
mod vocabulary;

pub(crate) use names::independent;
pub use suggestion::{Completion, Explanation, Suggestion, SuggestionKind};
pub use symbols::{Symbol, SymbolKind, symbols};
pub use uses::{Uses, named, outer_places, uses, uses_of};
pub(crate) use uses::{places_of, plain};

use crate::{Outline, scene};
use model::Span;
use names::{dimension, names};
pub(crate) use place::name_at;
use place::{Place, attribute_at, place, word_at};
use program::Program;
use units::{Dimension, QuantityName, Unit, Words, words};

/// Completions at the cursor, `offset` bytes from the beginning. `program` is the last valid program of the text, for
/// units.
pub fn complete(outline: &Outline, program: Option<&Program>, offset: usize) -> Completion {
    let (place, span) = place(outline, offset);
    let begun = &outline.source()[span.range()];
    let suggestions = match place {
        Place::Nothing => Vec::new(),
        Place::Key => keys(outline),
        Place::Fence => vocabulary::BLOCKS.iter().map(|(word, meaning)| of_word(word, meaning)).collect(),
        Place::Statement => [vocabulary::STATEMENTS, vocabulary::OPERATORS]
            .into_iter()
            .flatten()
            .map(|(word, meaning)| of_word(word, meaning))
            .chain(in_expressions(outline, program))
            .collect(),
        Place::Expression => in_expressions(outline, program).chain(operators()).collect(),
        Place::Unit => vocabulary::UNITS.iter().map(|unit| of_unit(unit)).collect(),
        Place::Element => elements(),
        Place::Attribute(element) => attributes(element),
    };
    let lower = begun.to_lowercase();
    let matches = |suggestion: &Suggestion| suggestion.text.to_lowercase().starts_with(&lower);
    Completion { span, suggestions: suggestions.into_iter().filter(matches).collect() }
}

/// Meaning of the word at byte `offset`; `None` if it is neither a keyword nor a name.
pub fn explain(outline: &Outline, program: Option<&Program>, offset: usize) -> Option<Explanation> {
    let source = outline.source();
    let mut span = word_at(source, offset)?;
    let (place, _) = place(outline, span.end);
    if let Place::Attribute(_) = place {
        span = attribute_at(source, offset)?;
    }
    let word = &source[span.range()];
    let named =
        |list: &[vocabulary::Entry]| list.iter().find(|(name, _)| *name == word).map(|(_, meaning)| meaning.clone());
    let meaning = match place {
        Place::Nothing => None,
        Place::Key => named(vocabulary::KEYS),
        Place::Fence => named(vocabulary::BLOCKS),
        Place::Unit => Unit::parse(word).ok().map(|unit| quantity(&unit.dimension)),
        Place::Element | Place::Attribute(_) => named(vocabulary::PARTS).or_else(|| named(vocabulary::ATTRIBUTES)),
        Place::Statement | Place::Expression => {
            let name = names(outline, program).into_iter().find(|name| name.text == word).map(|name| name.meaning);
            let lists = [vocabulary::STATEMENTS, vocabulary::OPERATORS].into_iter().find_map(named);
            name.or(lists).or_else(|| vocabulary::function(word))
        }
    };
    let order = source[span.end..].chars().take_while(|letter| matches!(letter, '\'' | '′')).count();
    let is_name = matches!(place, Place::Statement | Place::Expression);
    let dimension = program.filter(|_| is_name).and_then(|program| dimension(&program.model, word, order));
    let primes: usize = source[span.end..].chars().take(order).map(char::len_utf8).sum();
    let span = Span::new(span.start, span.end + if is_name { primes } else { 0 });
    meaning.map(|meaning| Explanation { span, meaning, dimension: dimension.as_ref().map(quantity) })
}

/// The statement of the model at byte `offset` as `<math>` elements; empty if there is none.
pub fn typeset_at(outline: &Outline, offset: usize) -> String {
    let number = crate::form::places(outline).at(offset).map(|(number, _)| number);
    number.map_or_else(String::new, |number| model::typeset_one(&crate::form::statements(outline), number).concat())
}

/// Names that a model declares.
pub(crate) fn names_in(outline: &Outline) -> Vec<String> {
    let fixed = |name: &Suggestion| name.text == "pi" || name.text == "t";
    names(outline, None).into_iter().filter(|name| !fixed(name)).map(|name| name.text).collect()
}

fn of_word(word: &str, meaning: &Words) -> Suggestion {
    Suggestion { kind: SuggestionKind::Word, text: word.to_owned(), meaning: meaning.clone() }
}

fn of_unit(unit: &str) -> Suggestion {
    let meaning = Unit::parse(unit).map(|unit| quantity(&unit.dimension)).unwrap_or_default();
    Suggestion { kind: SuggestionKind::Unit, text: unit.to_owned(), meaning }
}

/// Name of the quantity with a dimension: `length`.
fn quantity(dimension: &Dimension) -> Words {
    if dimension.is_none() {
        return QuantityName::PURE_NUMBER.noun();
    }
    let names = dimension.quantity_names();
    names.first().map_or_else(|| Words::same(dimension.to_string()), |name| name.noun())
}

/// Keys of the front matter that are not given yet.
fn keys(outline: &Outline) -> Vec<Suggestion> {
    let given = |key: &str| outline.front_matter().entries.iter().any(|entry| entry.key == key);
    let free = vocabulary::KEYS.iter().filter(|(key, _)| !given(key));
    free.map(|(key, meaning)| Suggestion { text: format!("{key}: "), ..of_word(key, meaning) }).collect()
}

fn operators() -> impl Iterator<Item = Suggestion> {
    vocabulary::OPERATORS.iter().map(|(word, meaning)| of_word(word, meaning))
}

/// Completions in expressions: names and functions.
fn in_expressions(outline: &Outline, program: Option<&Program>) -> impl Iterator<Item = Suggestion> {
    let functions = vocabulary::functions().map(|(name, meaning)| Suggestion {
        kind: SuggestionKind::Function,
        text: name.to_owned(),
        meaning,
    });
    names(outline, program).into_iter().chain(functions)
}

/// Completions for elements of a scene: parts first, because they need less text.
fn elements() -> Vec<Suggestion> {
    let of = |(name, meaning): &vocabulary::Entry| Suggestion { kind: SuggestionKind::Part, ..of_word(name, meaning) };
    let plain = scene::ELEMENTS.iter().map(|name| Suggestion {
        kind: SuggestionKind::Part,
        text: (*name).to_owned(),
        meaning: words("element of SVG"),
    });
    vocabulary::PARTS.iter().map(of).chain(plain).collect()
}

/// Completions for attributes of an element: its own, then the common ones.
fn attributes(element: &str) -> Vec<Suggestion> {
    let own = scene::part_of(element).map(|part| part.attributes).unwrap_or_default();
    let all = vocabulary::ATTRIBUTES.iter().filter(|(name, _)| !own.contains(name));
    let of =
        |name: &str, meaning: Words| Suggestion { kind: SuggestionKind::Part, text: format!("{name}=\"\""), meaning };
    let meaning = |name: &str| {
        let known = vocabulary::ATTRIBUTES.iter().find(|(known, _)| *known == name);
        known.map_or_else(|| words("of this part"), |(_, meaning)| meaning.clone())
    };
    let own = own.iter().map(|name| of(name, meaning(name)));
    own.chain(all.map(|(name, meaning)| of(name, meaning.clone()))).collect()
}
