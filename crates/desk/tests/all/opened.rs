//! Documents that are kept for the next work with the same texts.

use desk::OpenedDocuments;

fn text(title: &str) -> String {
    format!("---\ntitle: {title}\n---\n\n```model\nx' = -k*x\nparameter k = 1 [1/s]\nx(0) = 1 [m]\n```\n")
}

#[test]
fn a_document_is_found_by_all_of_its_texts() {
    let mut documents = OpenedDocuments::default();
    let mut title = |texts: &[String]| documents.open(texts).map(|document| document.program.title);
    // More documents than are kept, twice.
    for round in 0..2 {
        for number in 0..20 {
            let name = format!("number {number}");
            assert_eq!(title(&[text(&name)]), Some(name), "{round}");
        }
    }
    assert_eq!(title(&[text("a"), "no translation".to_owned()]), title(&[text("a"), "no translation".to_owned()]));
    for _ in 0..2 {
        assert_eq!(title(&["```model\nx' = (\n```\n".to_owned()]), None);
        assert_eq!(title(&[]), None);
    }
}
