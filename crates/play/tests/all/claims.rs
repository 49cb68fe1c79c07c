//! Claims of the author: judged on demand only, with the values of the document, independently of the visitor's run.
use crate::support::{UTUBE, UTUBE_ES, bits, go_on, open, set};
use play::{ClaimView, Play, deviation, deviation_svg};

fn claiming() -> Play {
    let checks = "\n```check\n\"Bound\": abs(y) < 100 [m] always\nset: b = 0 [kg/s]\n\"Displacement\": y within 1e-9 of 0 [m] + 1000*y(0) at end\n```\n";
    open(&[UTUBE, checks].concat(), &[&[UTUBE_ES, "\n```translations\n\"Bound\" = \"Cota\"\n```\n"].concat()])
}

fn claims(play: &Play) -> Vec<ClaimView> {
    play.claims().list(play.basis()).into_iter().flat_map(|checks| checks.claims).collect()
}

#[test]
fn claims_are_judged_on_demand_and_in_slices() {
    let mut play = claiming();
    assert!(
        !play.program().checks.is_empty()
            && !play.claims().is_judging(play.basis())
            && !play.change_claims(|claims, basis| claims.advance(basis))
    );
    assert!(claims(&play).iter().all(|claim| claim.holds.is_none() && claim.outcome.is_empty()));
    set(&mut play, "b", 0.0);
    go_on(&mut play, [0.1; 30]);
    let before = bits(&play);
    play.change_claims(|claims, _| claims.begin());
    assert!(play.claims().is_judging(play.basis()));
    let revision = play.revision().claims;
    while play.change_claims(|claims, basis| claims.advance(basis)) {}
    assert!(!play.claims().is_judging(play.basis()) && play.revision().claims > revision);
    let found: Vec<_> = claims(&play).into_iter().map(|claim| claim.holds).collect();
    assert_eq!(found, [Some(true), Some(false)]);
    assert_eq!(bits(&play), before, "the visitor's run stays");
}

#[test]
fn claims_are_in_the_language_of_the_page_with_what_they_suppose() {
    let mut play = claiming();
    play.change_claims(|claims, _| claims.begin());
    while play.change_claims(|claims, basis| claims.advance(basis)) {}
    let names = |play: &Play| claims(play).into_iter().map(|claim| claim.name).collect::<Vec<_>>();
    assert_eq!(names(&play), ["Bound", "Displacement"]);
    let checks = play.claims().list(play.basis());
    assert!(checks[0].setup.is_empty());
    assert_eq!(checks[1].setup, [("b".to_owned(), "0 kg/s".to_owned())]);
    assert_eq!(checks[0].claims[0].written, "abs(y) < 100 [m] always");
    assert!(checks[1].claims[0].outcome.contains("expected"), "{:?}", checks[1]);
    play.set_language("es");
    assert_eq!(names(&play)[0], "Cota");
    assert!(claims(&play)[1].outcome.contains("se espera"), "{:?}", claims(&play));
}

/// The deviation plot for claims with a known error: y grows as t and is claimed to grow as 2t and as 3t.
#[test]
fn the_present_run_is_compared_with_what_is_claimed_of_all_of_it() {
    let text = "---\nstep: 0.01 [s]\n---\n```model\nparameter a = 1 [m/s]\ny' = a\ny(0) = 0 [m]\n```\n\n```check\n\
                \"Way\": y within 1 % of 2*a*t always\n\"Thrice\": y within 1 [cm] of 3*a*t always\n\
                \"End\": y within 1 % of 1 [m] at end\n\"Bound\": y < 1000 [m] always\n```\n";
    let mut play = open(text, &[]);
    assert_eq!(deviation(play.basis(), play.course(), (0, 0)), None, "nothing has run");
    go_on(&mut play, [0.1; 30]);
    let way = deviation(play.basis(), play.course(), (0, 0)).unwrap();
    let end = *way.times.last().unwrap();
    assert!(way.is_relative && way.times.len() == way.off.len() && end > 1.0);
    for (time, off) in way.times.iter().zip(&way.off) {
        assert!((off + time / (2.0 * end)).abs() < 1e-12, "{off} at {time}");
    }
    let thrice = deviation(play.basis(), play.course(), (0, 1)).unwrap();
    assert!(!thrice.is_relative);
    assert!(thrice.times.iter().zip(&thrice.off).all(|(time, off)| (off + 2.0 * time).abs() < 1e-12));
    for other in [(0, 2), (0, 3), (0, 9), (9, 0)] {
        assert_eq!(deviation(play.basis(), play.course(), other), None, "{other:?}");
    }
    let drawn: Vec<bool> = claims(&play).iter().map(|claim| claim.is_drawn).collect();
    assert_eq!(drawn, [true, true, false, false]);
    let svg = deviation_svg(play.basis(), play.course(), (0, 1), &figure::Settings::default(), &figure::Palette::LIGHT)
        .unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("deviation [m]"), "{svg}");
    // The number of points is bounded.
    set(&mut play, "a", 2.0);
    go_on(&mut play, [1.0; 60]);
    assert!((700..=1500).contains(&deviation(play.basis(), play.course(), (0, 0)).unwrap().times.len()));
}
