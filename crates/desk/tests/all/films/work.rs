//! Corrections, undo, and restoring the work on a film.

use super::{columns, frame, laboratory, ruler, scene, surface, tracked};
use crate::support::{bring_back_records, play};
use desk::film::tracking::column::Click;
use desk::saved::Item;
use desk::{Desk, FilmOpening};
use scene::{container, identity, level, track};

#[test]
fn an_anchor_repeats_the_path_alone() {
    let mut desk = tracked();
    let before = columns(&desk);
    // An anchor on the tracked surface changes nothing.
    let point = desk.films().current().unwrap().tracks()[0].points[20];
    desk.change_films(|films, play| films.anchor_surface(play, 0, Click { frame: 20, position: point.position }))
        .unwrap();
    assert!(desk.films().is_tracking() && desk.films().wanted_frame().is_none(), "no frame is needed");
    while !desk.advance_tracking(10).unwrap() {}
    let close = columns(&desk)[1].iter().zip(&before[1]).all(|(one, other)| (one - other).abs() < 5e-5);
    assert!(close);
    // An anchor far from it: the track follows the click there.
    desk.change_films(|films, play| {
        films.anchor_surface(play, 0, Click { frame: 20, position: [80.0, point.position[1] + 60.0] })
    })
    .unwrap();
    while !desk.advance_tracking(10).unwrap() {}
    assert!((columns(&desk)[1][20] - before[1][20]).abs() > 0.04);
    desk.change_films(|films, play| films.release_surface(play, 0, 20)).unwrap();
    while !desk.advance_tracking(10).unwrap() {}
    assert_eq!(columns(&desk), before);
}

#[test]
fn the_record_is_removed_and_comes_back() {
    let mut desk = tracked();
    let id = desk.films().current().unwrap().record().unwrap();
    desk.change_records(|records, _| records.remove(id));
    desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
    assert!(desk.records().list().is_empty(), "a change does not bring back what was removed");
    let number = desk.undo_number().unwrap();
    assert!(desk.undo(number));
    assert_eq!((desk.records().list()[0].id, desk.films().of_record(id).unwrap().name.as_str()), (id, "swing.mp4"));
    desk.change_records(|records, _| records.remove(id));
    let other = desk.film_to_record().unwrap();
    assert!(other != id && desk.records().list()[0].rows == 75);
}

fn bring_back(desk: &mut Desk, saved: &[(String, Item)]) {
    for (name, item) in saved {
        let (_, item) = Item::read(&item.write(7)).unwrap();
        assert_eq!(desk.restore_item(&item).as_ref(), Some(name));
    }
}

#[test]
fn the_work_is_there_at_the_next_visit() {
    let desk = tracked();
    let mut next = laboratory();
    bring_back_records(&mut next, &desk.records().saved());
    bring_back(&mut next, &desk.films().saved());
    assert_eq!(next.films().saved(), desk.films().saved());
    assert_eq!(columns(&next), columns(&desk));
    assert!(next.films().current().is_none());
    // A different film with the same name is not taken for it; the same film with another name is.
    assert_eq!(
        next.change_films(|films, play| films.open(play, desk::FilmIdentity::new("swing.mp4", 5, b"x"), container(75))),
        Ok(FilmOpening::SameName)
    );
    let renamed = desk::FilmIdentity { name: "copy.mp4".into(), ..identity("swing.mp4") };
    assert_eq!(next.change_films(|films, play| films.open(play, renamed, container(75))), Ok(FilmOpening::TakenUp));
    let (one, other) = (desk.films().current().unwrap(), next.films().current().unwrap());
    assert_eq!((one.tracks(), one.subject()), (other.tracks(), other.subject()));
    assert_eq!((one.calibration(), one.calibration_form()), (other.calibration(), other.calibration_form()));
    // The record follows changes of the calibration, and the model is drawn over the film without further tracking.
    let mut form = ruler();
    form.origin = Some([80.0, 130.0]);
    next.work_on_film(|films, play| films.calibrate(play, form, None)).unwrap();
    assert!((columns(&next)[1][0] - columns(&desk)[1][0] - 0.01).abs() < 1e-6);
    play(&mut next, [0.5]);
    assert!(next.film_model(0, &[3])[0].is_some());
    // A correction needs the frames again.
    next.change_films(|films, play| {
        films.anchor_surface(play, 0, Click { frame: 0, position: [80.0, 120.0 - level(0.0) + 3.0] })
    })
    .unwrap();
    assert_eq!(next.films().wanted_frame(), Some(0));
}

#[test]
fn a_tracking_is_given_up_and_begun_again() {
    let mut desk = laboratory();
    desk.change_films(|films, play| films.open(play, identity("swing.mp4"), container(75))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
    desk.change_films(|films, play| films.begin_tracking(play)).unwrap();
    for at in 0..10 {
        desk.change_films(|films, play| films.give_frame(play, at, frame(at))).unwrap();
    }
    assert_eq!(desk.films().tracking_progress().map(|one| (one.taken, one.of, one.computing)), Some((10, 75, false)));
    desk.change_films(|films, _| films.cancel_tracking());
    assert_eq!((desk.films().wanted_frame(), desk.records().list().len()), (None, 0));
    // A frame that cannot be decoded is left out.
    desk.change_films(|films, play| films.begin_tracking(play)).unwrap();
    desk.change_films(|films, play| films.leave_out_frame(play, 0)).unwrap();
    while let Some(at) = desk.films().wanted_frame() {
        desk.change_films(|films, play| films.give_frame(play, at, frame(at))).unwrap();
    }
    while !desk.advance_tracking(7).unwrap() {}
    assert_eq!(desk.records().list()[0].rows, 74);
    let first = columns(&desk);
    track(&mut desk, &frame);
    assert_eq!((desk.records().list()[0].rows, first[0].len()), (75, 74));
}

#[test]
fn another_document_keeps_the_film() {
    let mut desk = tracked();
    let mut next = crate::support::utube();
    next.adopt(&mut desk);
    assert_eq!(next.films().current().unwrap().tracks()[0].points.len(), 75);
    next.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
    assert_eq!(next.records().list().len(), 1);
}

#[test]
fn stored_work_is_not_trusted() {
    let desk = tracked();
    let text = desk.films().saved()[0].1.write(7);
    let changes = [
        // A click outside the picture: no surface is tracked.
        ("[[0,[81.5,83.0]]]", "[[0,[1e9,83.0]]]"),
        ("\"ends\":[0,74]", "\"ends\":[74,18446744073709551615]"),
        ("\"factor\":1.0", "\"factor\":0.0"),
    ];
    for (from, to) in changes {
        assert!(text.contains(from), "{from} in {}", &text[..600]);
        let (_, item) = Item::read(&text.replace(from, to)).unwrap();
        let mut next = laboratory();
        assert!(next.restore_item(&item).is_some());
        next.change_films(|films, play| films.open(play, identity("swing.mp4"), container(75))).unwrap();
        let film = next.films().current().unwrap();
        assert_eq!((film.ends(), film.factor()), ([0, 74], 1.0));
        assert_eq!(film.subject().is_nothing(), to.contains("1e9"));
    }
}

/// The limit follows from the container: no frame is decoded for it.
#[test]
fn a_film_that_is_too_long_is_refused_before_a_frame_is_asked_for() {
    let mut desk = laboratory();
    desk.change_films(|films, play| films.open(play, identity("long.mp4"), container(30_000))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
    let refusal = desk.change_films(|films, play| films.begin_tracking(play)).unwrap_err();
    let text = refusal.text(desk.play());
    assert!(text.contains("at most 10485 frames"), "{text}");
    assert_eq!((desk.films().wanted_frame(), desk.films().is_tracking()), (None, false));
}
