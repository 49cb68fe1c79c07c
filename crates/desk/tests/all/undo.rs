//! Undo restores the last removed or overwritten item with its content and its place.

use crate::support::{play, set, utube};
use desk::{Announcement, Desk};
use play::Prominence;

const TABLE: &str = "0.1 0.40\n0.2 0.33\n0.3 0.24\n0.4 0.13\n";

fn told(desk: &mut Desk) -> Vec<Announcement> {
    std::iter::from_fn(|| desk.take_announcement()).collect()
}

/// Text of the state that removals can change.
fn everything(desk: &mut Desk) -> String {
    let parameters: Vec<f64> =
        desk.play().basis().parameters(desk.play().course()).iter().map(|parameter| parameter.value).collect();
    let records: Vec<String> = desk.records().list().into_iter().map(|record| format!("{record:?}")).collect();
    format!(
        "{parameters:?} {records:?} {:?} {:?} {}",
        desk.play().time_line().kept(desk.play().basis()),
        desk.fits().list(),
        desk.play().time_line().has_ghost()
    )
}

fn laboratory() -> Desk {
    let mut desk = utube();
    for name in ["one", "two", "three"] {
        desk.add_record(name, TABLE.as_bytes()).unwrap();
        desk.play_mut().change_settings(|settings| settings.set_parameter_text(0, "9.7")).unwrap();
        play(&mut desk, [1.0]);
        desk.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    }
    desk.change_fits(|fits, data| fits.vary(data.play(), 0, true));
    desk.change_fits(|fits, data| fits.begin(data, "utube.md")).unwrap();
    while desk.advance_fit() {}
    play(&mut desk, [1.0]);
    desk.play_mut().change_run(|line, _| line.scrub(0.5));
    play(&mut desk, [0.2]);
    assert!(desk.play().time_line().has_ghost());
    told(&mut desk);
    desk
}

#[test]
fn each_removal_is_announced_and_undone() {
    type Removal = (&'static str, fn(&mut Desk));
    let removals: [Removal; 6] = [
        ("a record", |desk| {
            let id = desk.records().list()[1].id;
            desk.change_records(|records, _| records.remove(id));
        }),
        ("a kept run", |desk| {
            let id = desk.play().time_line().kept(desk.play().basis())[1].id;
            desk.play_mut().change_run(|line, basis| line.remove_kept(basis, id));
        }),
        ("the previous run", |desk| desk.play_mut().change_run(|line, basis| line.remove_ghost(basis))),
        ("a fit", |desk| {
            let id = desk.fits().list()[0].id;
            desk.change_fits(|fits, data| fits.remove(data.play(), id));
        }),
        ("all parameters", |desk| desk.play_mut().change_settings(|settings| settings.restore_defaults())),
        ("a preset", |desk| desk.play_mut().change_settings(|settings| settings.apply_preset(1)).unwrap()),
    ];
    let mut desk = laboratory();
    for (what, remove) in removals {
        let before = everything(&mut desk);
        remove(&mut desk);
        assert_ne!(everything(&mut desk), before, "{what} is gone");
        let announced = told(&mut desk);
        let last = announced.last().unwrap();
        assert!(last.can_be_undone() && last.prominence() == Prominence::Shown, "{what}: {announced:?}");
        let number = desk.undo_number().unwrap();
        assert!(desk.undo(number), "{what}");
        assert_eq!(everything(&mut desk), before, "{what} is back");
        assert_eq!(told(&mut desk).last(), Some(&Announcement::Play(play::Announcement::Undone)));
        assert!(!desk.undo(number), "{what} comes back once");
    }
}

#[test]
fn only_the_last_removal_is_undone() {
    let mut desk = laboratory();
    let (first, second) = (desk.records().list()[0].id, desk.records().list()[1].id);
    desk.change_records(|records, _| records.remove(first));
    let number = desk.undo_number().unwrap();
    desk.change_records(|records, _| records.remove(second));
    assert!(!desk.undo(number), "another removal came after it");
    assert_eq!(desk.records().list().len(), 1);
    // A reset that changes nothing leaves nothing to undo.
    desk.play_mut().change_settings(|settings| settings.restore_defaults());
    desk.play_mut().change_settings(|settings| settings.restore_defaults());
    assert_eq!(desk.undo_number(), None);
    // The numbering continues with another document, so that an old undo button undoes nothing else.
    let mut other = utube();
    other.adopt(&mut desk);
    set(&mut other, "b", 77.0);
    other.play_mut().change_settings(|settings| settings.restore_defaults());
    assert!(other.undo_number().unwrap() > number + 1);
}

#[test]
fn a_run_that_comes_back_keeps_an_id_of_its_own() {
    let mut desk = laboratory();
    let last = desk.play().time_line().kept(desk.play().basis()).pop().unwrap().id;
    desk.play_mut().change_run(|line, basis| line.remove_kept(basis, last));
    desk.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    desk.undo(desk.undo_number().unwrap());
    let mut ids: Vec<u32> = desk.play().time_line().kept(desk.play().basis()).iter().map(|run| run.id).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), desk.play().time_line().kept(desk.play().basis()).len());
}

#[test]
fn what_changes_while_a_control_is_moved_is_not_shown() {
    let mut desk = utube();
    play(&mut desk, [1.0]);
    desk.play_mut().change_run(|line, _| line.scrub(0.5));
    desk.play_mut().change_run(|line, _| line.step_back());
    desk.play_mut().change_run(|line, _| line.step_forward());
    set(&mut desk, "b", 60.0);
    desk.play_mut().change_run(|line, _| line.set_speed(4.0));
    assert!(told(&mut desk).iter().all(|one| one.prominence() == Prominence::Spoken));
}
