//! Changing the size of a family replaces the program by one that runs as if the document stated that size. A link
//! contains it.

use crate::support::{bits, go_on, open, set};
use document::{Document, resized};
use play::{Announcement, Play, PlotId};

const CHAIN: &str = "---\nstep: 0.01 [s]\n---\n```model\nsize N = 5 in 2..40 \"Number of masses\"\nsize M = 3\n\
    parameter k = 4 [1/s^2] in 1..9\nx[i]'' = k*(x[i-1] - 2*x[i] + x[i+1]) for i in 1..N\nx[0] = 0 [m]\nx[N+1] = 0 [m]\n\
    x[i](0) = i*1 [m] for i in 1..N \"Displacement\"\nx[i]'(0) = 0 [m/s] for i in 1..N\ny[i] = i*1 [m] for i in 1..M\n```\n\
    ```plots\n\"Shape\": x[i] against i for i in 0..N+1\n\"First\": x[1] against t\n\"Sum\": y[1] + x[2] against t\n\
    \"Fourth\": x[2]' against t\n```\n";
const SPANISH: &str = "---\nlanguage: es\ntranslates: a.md\n---\n```translations\n\
    \"Number of masses\" = \"Número de masas\"\n\"Displacement\" = \"Desplazamiento\"\n\"Shape\" = \"Forma\"\n\
    \"First\" = \"Primera\"\n\"Sum\" = \"Suma\"\n\"Fourth\" = \"Cuarta\"\n```\n";

fn chain() -> Document {
    let opened = document::open(CHAIN, &[SPANISH]);
    assert!(opened.diagnostics.is_empty(), "{:#?}", opened.diagnostics);
    opened.document.unwrap()
}

#[test]
fn another_size_runs_as_the_document_that_states_it() {
    let document = chain();
    let mut play = Play::open(document.program.clone());
    set(&mut play, "k", 9.0);
    go_on(&mut play, [0.5]);
    play.change_plots(|plots, _| plots.show(PlotId::at(1), false));
    play.change_values(|values| values.choose_member("x", 0, 4));
    play.change_run(|line, _| line.play());
    while play.take_announcement().is_some() {}
    play.resize(resized(&document, &[("N", "12")]).unwrap().program);
    assert_eq!(play.take_announcement(), Some(Announcement::Resized(Vec::new())));
    assert!(play.time_line().is_playing());
    play.change_run(|line, _| line.pause());
    // Bit-identical to the text with this size.
    let mut stated = open(&CHAIN.replace("size N = 5", "size N = 12"), &[SPANISH]);
    set(&mut stated, "k", 9.0);
    go_on(&mut stated, [0.5]);
    assert_eq!(bits(&play), bits(&stated));
    assert_eq!(play.values().states().len(), 24);
    assert!(!play.plots().list()[1].shown);
    let index = |play: &mut Play| {
        let chosen = play.readouts().into_iter().find(|one| one.label == "Displacement").unwrap();
        chosen.members.unwrap().indices[0]
    };
    assert_eq!((index(&mut play).value, index(&mut play).greatest), (4, 13));
    let view = play.basis().sizes().remove(0);
    assert_eq!((view.label.as_str(), view.value, view.is_default), ("Number of masses", 12, false));
    play.set_language("es");
    assert_eq!(play.basis().sizes().remove(0).label, "Número de masas");
    // After changing the size back, no trace is left.
    play.resize(document.program.clone());
    assert!(play.basis().sizes().iter().all(|size| size.is_default));
    assert!(!play.share().contains("n="), "{}", play.share());
}

#[test]
fn a_link_carries_sizes_and_names_those_that_the_page_cannot_build() {
    let document = chain();
    let large = resized(&document, &[("N", "12"), ("M", "2")]).unwrap();
    let mut play = Play::open(large.program.clone());
    go_on(&mut play, [0.3]);
    let link = play.share();
    assert!(link.contains("&n=N:12,M:2&"), "{link}");
    // Without a parser, the size can only be reported as not fitting.
    let mut other = Play::open(document.program.clone());
    assert!(
        matches!(other.restore(&link), Err(play::Refusal::PartlyRestored { left_out }) if left_out == ["n=N:12,M:2"])
    );
    assert_eq!(other.basis().sizes_for(&link), [("N".to_owned(), 12), ("M".to_owned(), 2)]);
    assert_eq!(other.basis().sizes_for("1&n=N:x,Q:3,:,N&t=1"), []);
    assert_eq!(other.basis().sizes_for(""), []);
    let mut same = Play::open(large.program.clone());
    assert_eq!(same.restore(&link), Ok(()));
    assert_eq!(bits(&same), bits(&play));
    // A link without sizes refers to the sizes stated in the document.
    assert_eq!(play.basis().sizes_for("1&t=1"), [("N".to_owned(), 5), ("M".to_owned(), 3)]);
}

#[test]
fn sizes_that_cannot_be_are_refused() {
    let document = chain();
    for (name, value, reason) in [
        ("N", "41", "outside its range 2..40"),
        ("N", "1", "outside its range 2..40"),
        ("M", "20000", "10000"),
        ("Q", "3", "no parameter `Q`"),
        ("N", "many", "not a number"),
    ] {
        let refused = resized(&document, &[(name, value)]).unwrap_err();
        assert!(refused.english().contains(reason), "{name} = {value}: {}", refused.english());
    }
    assert_eq!(resized(&document, &[]).unwrap().program.model.sizes, document.program.model.sizes);
}
