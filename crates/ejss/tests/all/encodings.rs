//! The forms in which a simulation travels: encodings, archives, protected files.

use crate::support::{import, simulations, utf16};
use ejss::Refusal;

fn spring() -> String {
    simulations().into_iter().find(|(name, _)| name == "01-spring").expect("a simulation").1.ejss()
}

#[test]
fn encodings_give_one_document() {
    let text = spring();
    let expected = import(text.as_bytes()).expect("a document").document;
    let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let without_mark = utf16(&text, false)[2..].to_vec();
    for bytes in
        [marked, utf16(&text, true), utf16(&text, false), without_mark, text.replace('\n', "\r\n").into_bytes()]
    {
        assert_eq!(import(&bytes).expect("a document").document, expected);
    }
}

#[test]
fn what_is_no_simulation_is_refused_with_the_reason() {
    let text = spring();
    let protected = text.replace("password=\"\"", "password=\"x\"");
    let page = "<!DOCTYPE html><html><body>A simulation</body></html>";
    let cases = [
        (protected.into_bytes(), Refusal::Protected),
        (page.as_bytes().to_vec(), Refusal::ExportedPage),
        (text.as_bytes()[..text.len() / 2].to_vec(), Refusal::Broken),
        (b"t,y\n0,1\n".to_vec(), Refusal::Unknown),
        (vec![b' '; (20 << 20) + 1], Refusal::TooLarge),
        (b"PK\x03\x04 no archive".to_vec(), Refusal::Damaged),
        (format!("{{\"model\": {}", "[".repeat(10_000)).into_bytes(), Refusal::TooComplex),
    ];
    for (bytes, expected) in cases {
        let refusal = import(&bytes).expect_err("no document");
        assert_eq!(refusal, expected);
        assert!(refusal.words().english().ends_with('.'));
    }
}

#[test]
fn many_elements_and_circles_of_them_are_refused() {
    let element = |name: &str, parent: &str| {
        format!(
            "<HtmlView.Element>\n<Type>Elements.Panel</Type>\n<Name>{name}</Name>\n<Parent>{parent}</Parent>\n</HtmlView.Element>\n"
        )
    };
    let with = |elements: String| spring().replace("</Tree>", &format!("{elements}</Tree>"));
    let many = with((0..2001).map(|number| element(&number.to_string(), "")).collect());
    assert_eq!(import(many.as_bytes()).expect_err("too many"), Refusal::TooComplex);
    let circle = with(element("one", "other") + &element("other", "one"));
    assert_eq!(import(circle.as_bytes()).expect_err("a circle"), Refusal::TooComplex);
}
