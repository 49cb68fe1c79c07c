//! Claims of the author: known on demand only, with the values of the document, and without touching the visitor's run.
use crate::support::{UTUBE, UTUBE_ES, bits, go_on, open, set};
use play::{ClaimView, Play};

fn claiming() -> Play {
    let checks = "\n```check\n\"Bound\": abs(y) < 100 [m] always\nset: b = 0 [kg/s]\n\"Displacement\": y within 1e-9 of 0 [m] + 1000*y(0) at end\n```\n";
    open(&[UTUBE, checks].concat(), &[&[UTUBE_ES, "\n```translations\n\"Bound\" = \"Cota\"\n```\n"].concat()])
}

fn claims(play: &Play) -> Vec<ClaimView> {
    play.checks().into_iter().flat_map(|checks| checks.claims).collect()
}

#[test]
fn claims_are_judged_on_demand_and_in_slices() {
    let mut play = claiming();
    assert!(play.has_checks() && !play.is_checking() && !play.advance_checks());
    assert!(claims(&play).iter().all(|claim| claim.holds.is_none() && claim.outcome.is_empty()));
    set(&mut play, "b", 0.0);
    go_on(&mut play, [0.1; 30]);
    let before = bits(&play);
    play.begin_checks();
    assert!(play.is_checking());
    let revision = play.revision().checks;
    while play.advance_checks() {}
    assert!(!play.is_checking() && play.revision().checks > revision);
    let found: Vec<_> = claims(&play).into_iter().map(|claim| claim.holds).collect();
    assert_eq!(found, [Some(true), Some(false)]);
    assert_eq!(bits(&play), before, "the visitor's run stays");
}

#[test]
fn claims_are_in_the_language_of_the_page_with_what_they_suppose() {
    let mut play = claiming();
    play.begin_checks();
    while play.advance_checks() {}
    let names = |play: &Play| claims(play).into_iter().map(|claim| claim.name).collect::<Vec<_>>();
    assert_eq!(names(&play), ["Bound", "Displacement"]);
    let checks = play.checks();
    assert!(checks[0].setup.is_empty());
    assert_eq!(checks[1].setup, [("b".to_owned(), "0 kg/s".to_owned())]);
    assert_eq!(checks[0].claims[0].written, "abs(y) < 100 [m] always");
    assert!(checks[1].claims[0].outcome.contains("expected"), "{:?}", checks[1]);
    play.set_language("es");
    assert_eq!(names(&play)[0], "Cota");
    assert!(claims(&play)[1].outcome.contains("se espera"), "{:?}", claims(&play));
}
