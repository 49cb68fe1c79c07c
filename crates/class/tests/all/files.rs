//! Projects made of files of data, and the reason if there is none.

use class::verify::{DataFile, project_of_files};
use desk::document::page::Source;
use units::Language;

const MODEL: &str = "```model\ny' = 0 [m/s]\ny(0) = 0 [m]\n```\n";

/// The reason for which the table gives no project.
fn refused(model: &str, table: &str) -> String {
    let documents = vec![Source { name: "film.md".to_owned(), text: model.to_owned() }];
    let file = DataFile { name: "ball.csv".to_owned(), bytes: table.into(), against: Vec::new() };
    let made = project_of_files(documents, String::new(), vec![file], Vec::new(), Vec::new());
    made.map_or_else(|why| why.text(Language::English).into_owned(), |_| String::new())
}

#[test]
fn the_reason_is_true() {
    let table = "t [s],y [m]\n0,1\n1,2\n2,3\n";
    assert_eq!(refused(MODEL, table), "");
    let long = "t [s],y [m]\n".to_owned() + &(0..100_000).map(|row| format!("{row},0.123456789\n")).collect::<String>();
    for (model, table, expected) in [
        ("```model\ny' = \n```\n", table, "the document of the hand-in has errors"),
        (MODEL, "no table", "ball.csv could not be read."),
        (MODEL, &long, "the table ball.csv is too long: the tables of a hand-in have at most 1024 KiB together"),
    ] {
        let said = refused(model, table);
        assert!(said.starts_with(expected), "{said}");
    }
}
