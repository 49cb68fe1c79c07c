//! A message that knows its text in every language.

use super::catalogue::translated;
use super::conjunction::Conjunction;
use super::list::Language;
use std::borrow::Cow;
use std::fmt::{self, Debug, Display, Formatter};
use std::sync::Arc;

/// A text in all languages, for messages made before the language of the reader is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Words(Content);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Content {
    /// Identical in all languages.
    Same(Cow<'static, str>),
    /// A text of the catalogues, by its English form.
    Constant(&'static str),
    /// A template of the catalogues, and the values of its places by name.
    Filled(&'static str, Vec<(&'static str, Words)>),
    /// A function that makes the text.
    Each(Made),
    /// Names joined by commas, the last one by a conjunction.
    List(Vec<String>, Conjunction),
}

/// A function that makes a text. Two are equal if their English texts are.
#[derive(Clone)]
struct Made(Arc<dyn Fn(Language) -> String + Send + Sync>);

impl PartialEq for Made {
    fn eq(&self, other: &Self) -> bool {
        self.0(Language::English) == other.0(Language::English)
    }
}

impl Eq for Made {}

impl Debug for Made {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        Debug::fmt(&self.0(Language::English), formatter)
    }
}

/// A constant text. The macro of the same name allows values in it.
pub const fn words(english: &'static str) -> Words {
    Words(Content::Constant(english))
}

impl Words {
    /// A text that is identical in all languages, such as a name or a number.
    pub fn same(text: impl Into<Cow<'static, str>>) -> Self {
        Self(Content::Same(text.into()))
    }

    /// A text made by the same function for each language when it is read, such as a number in the style of the language.
    pub fn each(text: impl Fn(Language) -> String + Send + Sync + 'static) -> Self {
        Self(Content::Each(Made(Arc::new(text))))
    }

    /// An enumeration: `a, b and c`, or `a, b or c`.
    pub const fn list(names: Vec<String>, conjunction: Conjunction) -> Self {
        Self(Content::List(names, conjunction))
    }

    /// A template of `words!` with the values of its places.
    #[doc(hidden)]
    pub fn filled(english: &'static str, parts: &[(&'static str, &dyn ToWords)]) -> Self {
        Self(Content::Filled(english, parts.iter().map(|(place, value)| (*place, value.to_words())).collect()))
    }

    /// The text of `say!`.
    #[doc(hidden)]
    pub fn said(english: &'static str, parts: &[(&'static str, &dyn ToWords)], language: Language) -> String {
        Self::filled(english, parts).text(language).into_owned()
    }

    /// The text in one language.
    pub fn text(&self, language: Language) -> Cow<'_, str> {
        match &self.0 {
            Content::Same(text) => Cow::Borrowed(text),
            Content::Constant(english) => Cow::Borrowed(translated(language, english)),
            Content::Filled(english, parts) => Cow::Owned(filled(translated(language, english), &|place| {
                parts.iter().find(|(known, _)| *known == place).map(|(_, value)| value.text(language))
            })),
            Content::Each(Made(text)) => Cow::Owned(text(language)),
            Content::List(names, conjunction) => Cow::Owned(conjunction.join(names, language)),
        }
    }

    /// The English text.
    pub fn english(&self) -> String {
        self.text(Language::English).into_owned()
    }

    /// True if the text is empty.
    pub fn is_empty(&self) -> bool {
        self.text(Language::English).is_empty()
    }
}

impl Default for Words {
    fn default() -> Self {
        words("")
    }
}

/// A value in a message.
pub trait ToWords {
    /// The value in all languages.
    fn to_words(&self) -> Words;
}

impl ToWords for Words {
    fn to_words(&self) -> Words {
        self.clone()
    }
}

impl ToWords for &Words {
    fn to_words(&self) -> Words {
        (*self).clone()
    }
}

impl<T: Display> ToWords for T {
    fn to_words(&self) -> Words {
        Words::same(self.to_string())
    }
}

/// A template with the values of its places: `{name}`, or `{}` for the next number. `{{` and `}}` are braces. A place
/// without a value stays as it is.
fn filled<'a>(template: &str, value: &dyn Fn(&str) -> Option<Cow<'a, str>>) -> String {
    let mut text = String::with_capacity(template.len() + 32);
    let (mut rest, mut unnamed) = (template, 0);
    while let Some(at) = rest.find(['{', '}']) {
        text.push_str(&rest[..at]);
        let (brace, after) = rest[at..].split_at(1);
        if let Some(after) = after.strip_prefix(brace) {
            text.push_str(brace);
            rest = after;
            continue;
        }
        let place = after.split_once('}').filter(|_| brace == "{");
        let found = place.and_then(|(name, _)| match name {
            "" => value(&unnamed.to_string()),
            name => value(name),
        });
        match (place, found) {
            (Some((name, after)), Some(found)) => {
                unnamed += usize::from(name.is_empty());
                text.push_str(&found);
                rest = after;
            }
            _ => {
                text.push_str(brace);
                rest = after;
            }
        }
    }
    text.push_str(rest);
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{say, words};

    #[test]
    fn places_of_a_template_are_filled() {
        let (name, kind) = ("y", words("a number"));
        assert_eq!(words!("`{name}` is {kind}").english(), "`y` is a number");
        assert_eq!(words!("{{{}}} and {} of {count}", 1, &kind, count = 2 + 1).english(), "{1} and a number of 3");
        assert_eq!(say!(Language::English, "{name}{name}\u{2212}"), "yy\u{2212}");
    }

    #[test]
    fn a_translation_may_change_the_order_and_keeps_unknown_places() {
        let value =
            |place: &str| ["0", "one", "1"].iter().position(|known| *known == place).map(|at| at.to_string().into());
        for (template, expected) in
            [("{1} {one} {0}", "2 1 0"), ("{} {}", "0 2"), ("{two} {", "{two} {"), ("a } b }} {{c}}", "a } b } {c}")]
        {
            assert_eq!(filled(template, &value), expected, "{template}");
        }
    }
}
