//! Places of names, and the list of what a document contains.

use document::assist::{symbols, uses, uses_of};
use document::read;

/// Each place of the name is marked by brackets, those that declare it by braces.
fn marked(text: &str, offset: usize) -> String {
    let found = uses(&read(text), offset).expect("a name stands there");
    let mut marked = text.to_owned();
    for place in found.places.iter().rev() {
        let [open, close] = if found.declared.contains(place) { ['{', '}'] } else { ['[', ']'] };
        marked.insert(place.end, close);
        marked.insert(place.start, open);
    }
    marked
}

/// Lines with marks of the marked text, without the others.
fn lines_of(text: &str, before: &str) -> Vec<String> {
    let at = text.find(before).expect("it stands there") + before.len();
    let marked = marked(text, at);
    text.lines()
        .zip(marked.lines())
        .filter(|(own, marked)| own != marked)
        .map(|(_, marked)| marked.to_owned())
        .collect()
}

const DOCUMENT: &str = "---\ntitle: k\nvary: k\n---\n\nThe stiffness k is {k}, and $k$.\n\n```model\nparameter k = 4 [N/m] in 1..9 \"k\"\n\
parameter ω₀ = 2 [1/s]\nm = k/omega_0^2 # k\nm*x'' = -k*x\nx(0) = 3 [cm]\nx'(0) = 0\nfunction half(k) = k/2\n\
y = sum(k*half(i) for i in 1..3)\nz = sum(2*i for i in 1..4)\nwhen x < 0 as landing { let k = x/2, x = k }\n```\n\n\
```scene\n<svg viewBox=\"0 0 9 9\" id=\"k\"><rect width=\"k\"/><text>{k}</text></svg>\n```\n\n```plots\n\"k\": k*x, landing.x against t\n```\n\n\
```question\nHow large is k?\nanswer: k\n```\n";

#[test]
fn a_name_is_found_wherever_it_means_the_quantity() {
    let expected = [
        "vary: [k]",
        "The stiffness k is {[k]}, and $k$.",
        "parameter {k} = 4 [N/m] in 1..9 \"k\"",
        "m = [k]/omega_0^2 # k",
        "m*x'' = -[k]*x",
        "y = sum([k]*half(i) for i in 1..3)",
        "<svg viewBox=\"0 0 9 9\" id=\"k\"><rect width=\"[k]\"/><text>{[k]}</text></svg>",
        "\"k\": [k]*x, landing.x against t",
        "answer: [k]",
    ];
    for place in ["vary: k", "is {k", "parameter k", "m = k", "= -k", "width=\"k", "\"k\": k", "answer: k"] {
        assert_eq!(lines_of(DOCUMENT, place), expected, "{place}");
    }
}

/// Names that hold within a statement, names in Greek letters, names with primes, of events and of what every document has.
#[test]
fn local_names_greek_letters_and_primes() {
    for (place, expected) in [
        ("half(k", &["function half({k}) = [k]/2"][..]),
        ("function half(k) = k", &["function half({k}) = [k]/2"]),
        ("let k", &["when x < 0 as landing { let {k} = x/2, x = [k] }"]),
        ("sum(k*half(i", &["y = sum(k*half([i]) for {i} in 1..3)"]),
        ("sum(2*i for i", &["z = sum(2*[i] for {i} in 1..4)"]),
        ("ω₀", &["parameter {ω₀} = 2 [1/s]", "m = k/[omega_0]^2 # k"]),
        ("k/omega_0", &["parameter {ω₀} = 2 [1/s]", "m = k/[omega_0]^2 # k"]),
        ("function half", &["function {half}(k) = k/2", "y = sum(k*[half](i) for i in 1..3)"]),
        ("landing", &["when x < 0 as {landing} { let k = x/2, x = k }", "\"k\": k*x, [landing].x against t"]),
        ("against t", &["\"k\": k*x, landing.x against [t]"]),
    ] {
        assert_eq!(lines_of(DOCUMENT, place), expected, "{place}");
    }
    let of_x = lines_of(DOCUMENT, "\nx");
    assert_eq!(of_x[..3], ["m*[x]'' = -k*[x]", "{x}(0) = 3 [cm]", "{x}'(0) = 0"]);
}

#[test]
fn other_words_are_no_names() {
    for place in
        ["titl", "The", "stiffness k", "$k", "# k", "9 \"k", "[N", "id=\"k", "\n\"k", "large is k", "4", "sum", "whe"]
    {
        let at = DOCUMENT.find(place).expect("it stands there") + place.len();
        assert_eq!(uses(&read(DOCUMENT), at), None, "{place}");
    }
    assert_eq!(uses_of(&read(DOCUMENT), "unknown"), None);
    assert_eq!(uses(&read(""), 7), None);
}

#[test]
fn a_document_is_listed_by_its_blocks() {
    let found = symbols(&read(DOCUMENT));
    let told = |symbol: &document::assist::Symbol| format!("{:?} {}", symbol.kind, symbol.name);
    let all: Vec<String> = found
        .iter()
        .flat_map(|symbol| {
            std::iter::once(told(symbol)).chain(symbol.children.iter().map(|child| format!("  {}", told(child))))
        })
        .collect();
    let expected = "Block model\n  Name k\n  Name ω₀\n  Name m\n  Equation m*x'' = -k*x\n  Name x\n  Name x\n  Function half\n  Name y\n  \
                    Name z\n  Event landing\nBlock scene\nBlock plots\n  Entry k\nBlock question";
    assert_eq!(all.join("\n"), expected);
    let places = found.iter().flat_map(|symbol| symbol.children.iter().chain([symbol]));
    assert!(places.clone().all(|one| one.span.start <= one.named.start && one.named.end <= one.span.end));
    assert_eq!(symbols(&read("# Shopping\n")), []);
}

#[test]
fn entries_with_a_title_are_listed_over_all_their_lines() {
    for (text, expected) in [
        ("```survey\nrole \"You are\": \"a\", \"b\"\n```\n", vec![("You are", "role \"You are\": \"a\", \"b\"")]),
        ("```presets\ngroup \"Liquid\"\n\"Oil\": a = 1 # thin\n```\n", vec![("Oil", "\"Oil\": a = 1")]),
        ("```plots\n\"A\": x against t,\n  y against t\n```\n", vec![("A", "\"A\": x against t,\n  y against t")]),
    ] {
        let found = symbols(&read(text));
        let children = found[0].children.iter().map(|one| (one.name.as_str(), &text[one.span.range()]));
        assert_eq!(children.collect::<Vec<_>>(), expected);
    }
}
