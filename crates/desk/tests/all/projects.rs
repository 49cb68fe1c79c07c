//! Projects: the data of a desk besides its document are written to one file and restored at another visit.

use crate::support::utube;
use desk::document::page::Source;
use desk::saved::project::Project;
use proptest::prelude::*;
use units::Language;

const RECORD: &[u8] = b"t [s],y [m]\n0,0.5\n0.5,0.2\n1,-0.3\n1.5,-0.45\n2,-0.1\n2.5,0.3\n3,0.44\n";

#[test]
fn records_and_answers_come_back_and_are_not_taken_twice() {
    let mut desk = utube();
    desk.change_records(|records, open| records.begin(open, "film.csv", RECORD.to_vec(), None)).unwrap();
    while desk.records().progress().is_some() {
        desk.advance_record(1 << 20).unwrap();
    }
    let items = desk::project_items(&desk, 5);
    assert_eq!(items.len(), 1);
    let source = Source { name: "a.md".to_owned(), text: "x".to_owned() };
    let project = Project { documents: vec![source], state: desk.play().share(), items };
    let project = Project::read(&project.write()).unwrap();
    let mut other = utube();
    assert!(desk::take_project_items(&mut other, &project.items).is_empty());
    assert_eq!(other.records().list().len(), 1);
    assert_eq!(desk::project_items(&other, 5), project.items, "the same to the letter");
    assert!(desk::take_project_items(&mut other, &project.items).is_empty());
    assert_eq!(other.records().list().len(), 1, "what is there already stays");
    let damaged = [("a".to_owned(), "{}".to_owned()), ("b".to_owned(), "[".to_owned()), project.items[0].clone()];
    let mut third = utube();
    let refused = desk::take_project_items(&mut third, &damaged);
    let refused: Vec<_> = refused.iter().map(|why| why.text(Language::English)).collect();
    assert_eq!(refused, ["a", "b"].map(|name| format!("{name}: it is damaged, or was saved by a later version")));
    assert_eq!(third.records().list().len(), 1);
}

/// A file of unknown origin may contain thousands of items; the desk tries no more than it has room for.
#[test]
fn a_project_with_thousands_of_items_is_taken_in_part() {
    let film = |number: usize| {
        let text = format!(
            r#"{{"meniscus":3,"since":1,"item":{{"film":{{"name":"a","size":{number},"hash":"{number:016x}","frames":3}}}}}}"#
        );
        (format!("film {number}"), text)
    };
    let many: Vec<(String, String)> = (0..5000).map(film).collect();
    let mut desk = utube();
    let refused = desk::take_project_items(&mut desk, &many).len();
    assert!((4900..=5000).contains(&refused), "{refused}");
    // A repeated record is restored once, also among many others.
    let mut owner = utube();
    owner.change_records(|records, open| records.begin(open, "film.csv", RECORD.to_vec(), None)).unwrap();
    while owner.records().progress().is_some() {
        owner.advance_record(1 << 20).unwrap();
    }
    let items = vec![desk::project_items(&owner, 5).remove(0); 1000];
    let mut desk = utube();
    assert_eq!((desk::take_project_items(&mut desk, &items).len(), desk.records().list().len()), (0, 1));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// No text causes a panic, and a project that was read can be written again.
    #[test]
    fn any_text_is_a_project_or_refused(text in "\\PC{0,200}", at in 0usize..400, byte in any::<u8>()) {
        let _ = Project::read(&text);
        let mut desk = utube();
        desk::take_project_items(&mut desk, &[(text.clone(), text)]);
        let source = Source { name: "a".to_owned(), text: "b".to_owned() };
        let items = vec![("r".to_owned(), "{\"meniscus\":3,\"since\":1,\"item\":{\"answer\":{}}}".to_owned())];
        let mut bytes = Project { documents: vec![source], state: String::new(), items }.write().into_bytes();
        let place = at % bytes.len();
        bytes[place] = byte;
        if let Ok(project) = String::from_utf8(bytes).map_err(drop).and_then(|text| Project::read(&text).map_err(drop)) {
            desk::take_project_items(&mut desk, &project.items);
            prop_assert_eq!(Project::read(&project.write()), Ok(project));
        }
    }
}
