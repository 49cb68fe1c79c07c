//! Sentences: lossless, and their words are keywords only where the grammar expects them.

use super::syntax_properties::text;
use model::{Grammar, LexemeKind, Phrase, Span, lexemes, sentence, sentences};
use proptest::prelude::*;

const WORDS: &[&str] =
    &["against", "for", "in", "at", "every", "from", "within", "of", "by", "step", "always", "to", "over"];

const PLOTS: Grammar =
    Grammar { heads: &["group"], kinds: &["points"], clauses: WORDS, ending: &["equal", "axes"], ..Grammar::TITLED };

/// The nodes of a text, as `operand|keyword operand|..`, with labels in their quotation marks; phrases separated by `;`.
fn nodes(source: &str) -> String {
    let of = |span: Span| source[span.range()].to_owned();
    let phrase = |phrase: Phrase| {
        let operand = |operand: model::Operand| match operand.label {
            Some(label) => format!("{}{}", of(operand.span), of(label)),
            None => of(operand.span),
        };
        let clauses =
            phrase.clauses.iter().map(|clause| format!("|{} {}", clause.keyword.word, operand(clause.operand)));
        operand(phrase.operand) + &clauses.collect::<String>()
    };
    let whole = sentence(source, 0..source.len(), &PLOTS);
    let marks = [
        whole.head.map(|head| format!("<{}> ", head.word)),
        whole.title.map(|title| format!("{} ", of(title))),
        whole.colon.map(|_| ": ".to_owned()),
        whole.kind.map(|kind| format!("<{}> ", kind.word)),
    ];
    let phrases: Vec<String> = whole.phrases().map(phrase).collect();
    let ending = whole.ending.map_or_else(String::new, |ending| format!(" <{}>", of(ending)));
    format!("{}{}{ending}", marks.into_iter().flatten().collect::<String>(), phrases.join("; "))
}

#[test]
fn words_are_keywords_where_the_grammar_expects_them() {
    for (source, expected) in [
        ("\"A\": y, x against t, equal axes", "\"A\" : y; x|against t <equal axes>"),
        ("\"From at to\": y \"at from\" against t", "\"From at to\" : y\"at from\"|against t"),
        ("group \"at\"", "<group> \"at\" "),
        ("group against t", "<group> |against t"),
        // Quantities named as keywords.
        ("at at end", "at|at end"),
        ("at + 1 at at", "at + 1|at at"),
        ("from*from from 2 [s] against at in 1..2", "from*from|from 2 [s]|against at|in 1..2"),
        ("\"A\": points every against every every 1 from 2", "\"A\" : <points> every|against every|every 1|from 2"),
        ("\"A\": points against t", "\"A\" : points|against t"),
        ("\"A\": points, x against points", "\"A\" : points; x|against points"),
        ("\"A\": points(x) against t", "\"A\" : points(x)|against t"),
        ("\"A\": points_x against t", "\"A\" : points_x|against t"),
        ("if at then of else by at 2", "if at then of else by|at 2"),
        ("not at and from at 3", "not at and from|at 3"),
        ("of within 1 % of of at end", "of|within 1 %|of of|at end"),
        ("at' against at''", "at'|against at''"),
        ("against_x against t", "against_x|against t"),
        // Parentheses, brackets, texts and comments.
        ("sum(x[at] for i in 1..3) at end", "sum(x[at] for i in 1..3)|at end"),
        ("(a at b) against t", "(a at b)|against t"),
        ("y in [m at s] against t", "y|in [m at s]|against t"),
        ("y # at end\n", "y"),
        ("x[i] against i*a for i in 0..N+1", "x[i]|against i*a|for i|in 0..N+1"),
        // Incomplete phrases keep their nodes.
        ("\"A\": against t", "\"A\" : |against t"),
        ("y + against t", "y +|against t"),
        ("y against", "y|against "),
        ("y, against t", "y; |against t"),
        ("in -1..1", "|in -1..1"),
        ("y in [m against t", "y|in [m against t"),
        ("a > b ? x : y against t", "a > b ? x : y|against t"),
        ("30° at 5. at end", "30°|at 5.|at end"),
        ("", ""),
    ] {
        assert_eq!(nodes(source), expected, "{source}");
    }
}

/// Each word between operands can also be the name of a quantity.
#[test]
fn names_are_no_keywords() {
    for word in WORDS.iter().filter(|word| **word != "in") {
        for (before, after) in [
            ("x", "1"),
            (*word, *word),
            ("f(x)", "-1"),
            ("2 [m]", "y'"),
            (&format!("1 + {word}"), *word),
            (&format!("{word}^2"), &format!("{word}*2")),
            (&format!("{word}(3)"), "(1 + 2)"),
            (&format!("not {word}"), "2.5 %"),
        ] {
            assert_eq!(nodes(&format!("{before} {word} {after}")), format!("{before}|{word} {after}"));
            assert_eq!(nodes(before), before);
        }
    }
}

#[test]
fn sentences_go_on_after_commas_and_colons() {
    let all = |source: &str, joins_indented| -> Vec<String> {
        let grammar = Grammar { joins_indented, ..PLOTS };
        let found = sentences(source, 0..source.len(), &grammar);
        found.iter().map(|one| source[one.span.range()].to_owned()).collect()
    };
    assert_eq!(all("# a\n\"b # c\": d, # e\n  f\n\ng", false), ["\"b # c\": d, # e\n  f", "g"]);
    assert_eq!(all("a\n  b\n  \"c\"\n  group: d\n  group\ne", true), ["a\n  b", "\"c\"", "group: d\n  group", "e"]);
    assert_eq!(all("a [b\nc", false), ["a [b", "c"]);
}

#[test]
fn a_phrase_is_split_at_its_keywords() {
    let source = "a from 1 at b from 2 \"Label\"";
    let whole = sentence(source, 0..source.len(), &PLOTS);
    let phrase = whole.phrases().next().unwrap();
    let text = |span: Span| &source[span.range()];
    let (first, last) = (phrase.split_first("from").unwrap(), phrase.split_last(&["from", "every"]).unwrap());
    assert_eq!((text(first.before.span()), text(first.after.span())), ("a", "1 at b from 2 \"Label\""));
    assert_eq!((text(last.before.span()), text(last.after.unlabelled())), ("a from 1 at b", "2"));
    assert_eq!((text(phrase.unlabelled()), phrase.label().map(text)), ("a from 1 at b from 2", Some("\"Label\"")));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn lexemes_are_the_whole_text(source in prop_oneof![text(), ".{0,40}", "[a-z?|\"#°º\\[\\](){}., \n]{0,40}"]) {
        let lexemes = lexemes(&source, 0..source.len());
        let written: String = lexemes.iter().map(|lexeme| lexeme.text(&source)).collect();
        prop_assert_eq!(&written, &source);
        // Each lexeme with a meaning lies in one sentence, and nodes neither overlap nor cut lexemes.
        let found = sentences(&source, 0..source.len(), &PLOTS);
        for lexeme in lexemes {
            let holds = |span: Span| span.start <= lexeme.span.start && lexeme.span.end <= span.end;
            let touches = |span: Span| span.start < lexeme.span.end && lexeme.span.start < span.end;
            let has_meaning = !matches!(lexeme.kind, LexemeKind::Blank | LexemeKind::Comment | LexemeKind::LineEnd);
            if has_meaning {
                prop_assert_eq!(found.iter().filter(|one| holds(one.span)).count(), 1);
            }
            let phrases = || found.iter().flat_map(|one| one.phrases());
            prop_assert!(phrases().all(|phrase| holds(phrase.span()) || !touches(phrase.span()) || !has_meaning));
            prop_assert!(phrases().filter(|phrase| holds(phrase.span())).count() <= 1);
        }
    }
}
