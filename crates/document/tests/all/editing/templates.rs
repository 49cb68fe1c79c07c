//! File names of new documents.

use document::file_name;

#[test]
fn a_document_from_a_template_is_called_after_its_title() {
    let titled = |title: &str| format!("---\ntitle: {title}\nlanguage: en\n---\n\nText.\n");
    for (name, title, expected) in [
        ("empty.md", "A mass on a spring", "a-mass-on-a-spring.md"),
        ("oscillator.md", "Oscilación: ¿cuánto dura?", "oscilación-cuánto-dura.md"),
        ("empty.md", "  ../x  ", "x.md"),
        ("empty.md", "?", "empty.md"),
        ("spring.md", "A mass on a spring", "spring.md"),
        ("empty-room.md", "Other", "empty-room.md"),
    ] {
        assert_eq!(file_name(name, &titled(title)), expected, "{name} {title}");
    }
    assert_eq!(file_name("empty.md", "no front matter"), "empty.md");
    assert_eq!(file_name("map.md", &titled(&"word ".repeat(30))).chars().count(), 59 + ".md".len());
}
