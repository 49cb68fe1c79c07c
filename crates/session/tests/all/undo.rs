//! What was removed or overwritten last can be put back, as it was and where it was.

use crate::support::{play, set, utube};
use session::{Announcement, Prominence, Session};

const TABLE: &str = "0.1 0.40\n0.2 0.33\n0.3 0.24\n0.4 0.13\n";

fn told(session: &mut Session) -> Vec<Announcement> {
    std::iter::from_fn(|| session.take_announcement()).collect()
}

/// Everything that a removal may take away.
fn everything(session: &mut Session) -> String {
    let parameters: Vec<f64> = session.parameters().iter().map(|parameter| parameter.value).collect();
    let records: Vec<String> = session.records().into_iter().map(|record| format!("{record:?}")).collect();
    format!("{parameters:?} {records:?} {:?} {:?} {}", session.kept(), session.fits(), session.has_ghost())
}

fn laboratory() -> Session {
    let mut session = utube();
    for name in ["one", "two", "three"] {
        session.add_record(name, TABLE.as_bytes()).unwrap();
        session.set_parameter_text(0, "9.7").unwrap();
        play(&mut session, [1.0]);
        session.keep().unwrap();
    }
    session.vary(0, true);
    session.begin_fit("utube.md").unwrap();
    while session.advance_fit() {}
    play(&mut session, [1.0]);
    session.scrub(0.5);
    play(&mut session, [0.2]);
    assert!(session.has_ghost());
    told(&mut session);
    session
}

#[test]
fn each_removal_is_announced_and_undone() {
    type Removal = (&'static str, fn(&mut Session));
    let removals: [Removal; 6] = [
        ("a record", |session| session.remove_record(session.records()[1].id)),
        ("a kept run", |session| session.remove_kept(session.kept()[1].id)),
        ("the previous run", Session::remove_ghost),
        ("a fit", |session| session.remove_fit(session.fits()[0].id)),
        ("all parameters", Session::restore_defaults),
        ("a preset", |session| session.apply_preset(1).unwrap()),
    ];
    let mut session = laboratory();
    for (what, remove) in removals {
        let before = everything(&mut session);
        remove(&mut session);
        assert_ne!(everything(&mut session), before, "{what} is gone");
        let announced = told(&mut session);
        let last = announced.last().unwrap();
        assert!(last.can_be_undone() && last.prominence() == Prominence::Shown, "{what}: {announced:?}");
        let number = session.undo_number().unwrap();
        assert!(session.undo(number), "{what}");
        assert_eq!(everything(&mut session), before, "{what} is back");
        assert_eq!(told(&mut session).last(), Some(&Announcement::Undone));
        assert!(!session.undo(number), "{what} comes back once");
    }
}

#[test]
fn only_the_last_removal_is_undone() {
    let mut session = laboratory();
    let (first, second) = (session.records()[0].id, session.records()[1].id);
    session.remove_record(first);
    let number = session.undo_number().unwrap();
    session.remove_record(second);
    assert!(!session.undo(number), "another removal came after it");
    assert_eq!(session.records().len(), 1);
    // A reset that changes nothing leaves nothing to undo.
    session.restore_defaults();
    session.restore_defaults();
    assert_eq!(session.undo_number(), None);
    // Another document goes on with the numbering: what a person still sees does not undo something else.
    let mut other = utube();
    other.adopt_records(&mut session);
    set(&mut other, "b", 77.0);
    other.restore_defaults();
    assert!(other.undo_number().unwrap() > number + 1);
}

#[test]
fn a_run_that_comes_back_keeps_an_id_of_its_own() {
    let mut session = laboratory();
    let last = session.kept().pop().unwrap().id;
    session.remove_kept(last);
    session.keep().unwrap();
    session.undo(session.undo_number().unwrap());
    let mut ids: Vec<u32> = session.kept().iter().map(|run| run.id).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), session.kept().len());
}

#[test]
fn what_changes_while_a_control_is_moved_is_not_shown() {
    let mut session = utube();
    play(&mut session, [1.0]);
    session.scrub(0.5);
    session.step_back();
    session.step_forward();
    set(&mut session, "b", 60.0);
    session.set_speed(4.0);
    assert!(told(&mut session).iter().all(|one| one.prominence() == Prominence::Spoken));
}
