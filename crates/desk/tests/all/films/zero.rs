//! The zero of heights in a film, which is set by a click or unknown.

use super::scene::{DECAY, OMEGA, container, identity, track};
use super::{THEORY, frame, ruler, surface, tracked};
use crate::support::open;
use desk::{CalibrationForm, Desk};

/// The theory with a separate parameter for the level.
fn level() -> String {
    THEORY
        .replace("omega = 7.5", "c = 0 [cm] in -9..9\nparameter omega = 7.5")
        .replace("y'' + 2*beta*y' + omega^2*y = 0", "z'' + 2*beta*z' + omega^2*z = 0")
        .replace("y(0)  =", "y = z + c\nz(0)  =")
        .replace("y'(0) =", "z'(0) =")
}

/// True for each of the two zeros that is varied.
fn zeros(desk: &Desk) -> Vec<bool> {
    desk.fits().choices().into_iter().filter(|choice| choice.name.is_empty()).map(|choice| choice.varied).collect()
}

#[test]
fn the_zero_of_a_film_is_varied_unless_somebody_or_the_theory_says_otherwise() {
    let mut desk = tracked();
    assert_eq!(zeros(&desk), [false, true]);
    desk.change_fits(|fits, data| fits.vary(data.play(), 5, false));
    assert_eq!(zeros(&desk), [false, false]);
    // Without an origin heights count from the lower edge of the picture.
    let mut desk = tracked();
    desk.work_on_film(|films, play| films.calibrate(play, CalibrationForm { origin: None, ..ruler() }, None)).unwrap();
    (0..4).for_each(|choice| desk.change_fits(|fits, data| fits.vary(data.play(), choice, true)));
    desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap();
    while desk.advance_fit() {}
    let detail = desk.fits().detail(desk.fits().list()[0].id).unwrap();
    let omega = desk.play().course().parameters()[0];
    assert!((omega - (OMEGA * OMEGA + DECAY * DECAY).sqrt()).abs() < 0.01, "{omega} {:?}", detail.sentences);
    // A parameter that shifts the whole curve replaces the zero: `c`, or the start of a fall.
    let fall = THEORY.replace("y'' + 2*beta*y' + omega^2*y = 0", "y'' + beta*y' = -9.8 [m/s^2]");
    for (theory, own) in [(fall, "y_0"), (level(), "c")] {
        let mut desk = open(&theory, &[]);
        desk.change_films(|films, play| films.open(play, identity("swing.mp4"), container(75))).unwrap();
        desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
        track(&mut desk, &frame);
        desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
        assert_eq!(zeros(&desk), [false, true], "{own}");
        let place = desk.fits().choices().iter().find(|choice| choice.name == own).unwrap().index;
        desk.change_fits(|fits, data| fits.vary(data.play(), place, true));
        assert_eq!(zeros(&desk), [false, false], "{own}");
    }
}

/// Heights count from the lower edge of the picture. One of two theories has a parameter for this level; the zero is
/// varied for the other.
#[test]
fn a_ranking_varies_the_zero_of_a_film_where_a_theory_has_none() {
    let vary = |theory: &str, names: &str| theory.replacen("---\n\n", &format!("vary: {names}\n---\n\n"), 1);
    let theories = [vary(THEORY, "omega, beta, y_0"), vary(&level(), "omega, beta, y_0, c")];
    let theories = theories.map(|text| ("t.md".to_owned(), document::open(&text, &[]).document.unwrap()));
    for (zero_is_known, expected) in [(false, [1, 0]), (true, [0, 0])] {
        let mut desk = tracked();
        desk.work_on_film(|films, play| films.calibrate(play, CalibrationForm { origin: None, ..ruler() }, None))
            .unwrap();
        if zero_is_known {
            desk.change_fits(|fits, data| fits.vary(data.play(), 5, false));
        }
        desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
        while desk.advance_fit() {}
        let fits = desk.fits().list();
        let zeros = |own: bool| -> usize {
            let of = fits.iter().map(|fit| desk.fits().detail(fit.id).unwrap().estimates);
            let mut of = of.filter(|estimates| estimates.iter().any(|one| one.name == "c") == own);
            of.next().unwrap().iter().filter(|one| one.name == "y_offset").count()
        };
        assert_eq!([zeros(false), zeros(true)], expected);
    }
}
