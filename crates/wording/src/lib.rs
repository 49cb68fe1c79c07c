//! The macros `words!` and `say!`, which `units` exports. They read the places of an English template when the program is
//! compiled, so that a place without a value, or a value without a place, is an error there.
//!
//! - **Invariant:** the text in the code is the key of the catalogues; nothing is translated when the program is compiled.

use proc_macro::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// A message with values in it, as `units::Words`: an English template with the values of its places as in `format!`. `{name}` takes
/// the variable of that name unless `name = value` follows; `{}` takes the next value without a name. A value is
/// displayed, or is itself a `Words` and then stands in the language of the message. Formats such as `{:.2}` are not
/// allowed: numbers are rounded before, in the style of the language.
#[proc_macro]
pub fn words(input: TokenStream) -> TokenStream {
    let arguments = arguments(input);
    message(&arguments).map_or_else(|error| error, |message| call("filled", message))
}

/// The text of [`words!`] in a language, as `String`: the language stands before the template.
#[proc_macro]
pub fn say(input: TokenStream) -> TokenStream {
    let arguments = arguments(input);
    let Some((language, rest)) = arguments.split_first() else {
        return error("the language and the English text are missing", Span::call_site());
    };
    match message(rest) {
        Ok([template, parts]) => call("said", [template, parts, language.iter().cloned().collect()]),
        Err(error) => error,
    }
}

/// The arguments between top-level commas.
fn arguments(input: TokenStream) -> Vec<Vec<TokenTree>> {
    let mut arguments = vec![Vec::new()];
    for token in input {
        match (&token, arguments.last_mut()) {
            (TokenTree::Punct(mark), _) if mark.as_char() == ',' => arguments.push(Vec::new()),
            (_, Some(last)) => last.push(token),
            (_, None) => {}
        }
    }
    arguments.retain(|argument| !argument.is_empty());
    arguments
}

/// The template, and a list of its places with their values.
fn message(arguments: &[Vec<TokenTree>]) -> Result<[TokenStream; 2], TokenStream> {
    let missing = || error("the English text is missing, as a literal", Span::call_site());
    let (template, values) = arguments.split_first().ok_or_else(missing)?;
    let template = literal(template).ok_or_else(missing)?;
    let places = places(&template.to_string()).map_err(|why| error(&why, template.span()))?;
    let mut values: Vec<Value> = values.iter().map(|value| Value::read(value)).collect();
    let mut parts = TokenStream::new();
    for place in places {
        let value = match values.iter_mut().find(|value| value.name.as_deref() == Some(&place)) {
            Some(value) => value.take(),
            None => {
                match values.iter_mut().filter(|value| value.name.is_none()).nth(place.parse().unwrap_or(usize::MAX)) {
                    Some(value) => value.take(),
                    None if place.starts_with(|letter: char| letter.is_ascii_digit()) => {
                        return Err(error(&format!("the place `{{{place}}}` has no value"), template.span()));
                    }
                    None => TokenTree::from(Ident::new(&place, template.span())).into(),
                }
            }
        };
        let mut part = TokenStream::from(TokenTree::from(Literal::string(&place)));
        part.extend(TokenStream::from(TokenTree::from(Punct::new(',', Spacing::Alone))));
        part.extend(reference(group(Delimiter::Parenthesis, value)));
        parts.extend(group(Delimiter::Parenthesis, part));
        parts.extend(TokenStream::from(TokenTree::from(Punct::new(',', Spacing::Alone))));
    }
    if let Some(value) = values.iter().find(|value| !value.used) {
        let span = value.tokens.first().map_or(Span::call_site(), TokenTree::span);
        return Err(error("this value has no place in the text", span));
    }
    Ok([TokenStream::from(TokenTree::from(template)), reference(group(Delimiter::Bracket, parts))])
}

/// A value after the template.
struct Value {
    name: Option<String>,
    tokens: Vec<TokenTree>,
    used: bool,
}

impl Value {
    fn read(tokens: &[TokenTree]) -> Self {
        let value = |name, tokens: &[TokenTree]| Self { name, tokens: tokens.to_vec(), used: false };
        match tokens {
            [TokenTree::Ident(name), TokenTree::Punct(mark), rest @ ..]
                if mark.as_char() == '=' && mark.spacing() == Spacing::Alone =>
            {
                value(Some(name.to_string()), rest)
            }
            _ => value(None, tokens),
        }
    }

    fn take(&mut self) -> TokenStream {
        self.used = true;
        self.tokens.iter().cloned().collect()
    }
}

/// A literal text, also one that was handed through another macro.
fn literal(tokens: &[TokenTree]) -> Option<Literal> {
    match tokens {
        [TokenTree::Literal(literal)] => Some(literal.clone()),
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::None => {
            literal(&group.stream().into_iter().collect::<Vec<_>>())
        }
        _ => None,
    }
}

/// Names and numbers of the places of a template, each once.
fn places(template: &str) -> Result<Vec<String>, String> {
    let (mut places, mut unnamed) = (Vec::new(), 0);
    let mut letters = template.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            // A character by its number: `\u{2212}`.
            '\\' if letters.next() == Some('u') => while letters.next_if(|letter| *letter != '}').is_some() {},
            '{' if letters.next_if_eq(&'{').is_none() => {
                let mut name = String::new();
                while let Some(letter) = letters.next_if(|letter| *letter != '}') {
                    name.push(letter);
                }
                if !name.chars().all(|letter| letter.is_alphanumeric() || letter == '_') {
                    return Err(format!("`{{{name}}}`: only the name of a value may stand between braces"));
                }
                if name.is_empty() {
                    name = unnamed.to_string();
                    unnamed += 1;
                }
                if !places.contains(&name) {
                    places.push(name);
                }
            }
            _ => {}
        }
    }
    Ok(places)
}

/// A call of an associated function of `units::Words`.
fn call<const COUNT: usize>(function: &str, arguments: [TokenStream; COUNT]) -> TokenStream {
    let mut inside = TokenStream::new();
    for argument in arguments {
        inside.extend(argument);
        inside.extend(TokenStream::from(TokenTree::from(Punct::new(',', Spacing::Alone))));
    }
    let mut path = TokenStream::new();
    for name in ["units", "Words", function] {
        for spacing in [Spacing::Joint, Spacing::Alone] {
            path.extend(TokenStream::from(TokenTree::from(Punct::new(':', spacing))));
        }
        path.extend(TokenStream::from(TokenTree::from(Ident::new(name, Span::mixed_site()))));
    }
    path.extend(TokenStream::from(TokenTree::from(Group::new(Delimiter::Parenthesis, inside))));
    path
}

fn reference(value: TokenStream) -> TokenStream {
    let mut reference = TokenStream::from(TokenTree::from(Punct::new('&', Spacing::Alone)));
    reference.extend(value);
    reference
}

fn group(delimiter: Delimiter, inside: TokenStream) -> TokenStream {
    TokenTree::from(Group::new(delimiter, inside)).into()
}

/// `compile_error!` with a message.
fn error(message: &str, span: Span) -> TokenStream {
    let text = TokenTree::from(Literal::string(message));
    let mut group = Group::new(Delimiter::Brace, text.into());
    group.set_span(span);
    let mark = TokenTree::from(Punct::new('!', Spacing::Alone));
    [TokenTree::from(Ident::new("compile_error", span)), mark, group.into()].into_iter().collect()
}
