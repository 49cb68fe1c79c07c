//! A simulation that is passed on to another program of the page.

use crate::support::{bits, set, utube};
use figure::{Palette, Settings};
use play::{Play, PlotId};

/// The same document, which takes over what `play` passes on, through bytes as in the page.
fn taken_over(play: &mut Play) -> Play {
    let mut other = utube();
    let bytes = postcard::to_allocvec(&play.pass_on()).unwrap();
    other.take_over(postcard::from_bytes(&bytes).unwrap());
    other
}

/// Everything that shows: plots, values, kept runs.
fn shown(play: &mut Play) -> (Vec<String>, String, String) {
    let settings = Settings::default();
    let plots = (0..3).map(|plot| play.plots_to_front().svg(PlotId::at(plot), &settings, &Palette::LIGHT));
    let plots = plots.map(|svg| format!("{svg:?}")).collect();
    (plots, format!("{:?}", play.readouts()), format!("{:?}", play.time_line().kept(play.basis())))
}

#[test]
fn a_fresh_simulation_stays_fresh() {
    let other = taken_over(&mut utube());
    assert_eq!(other.share(), "");
    assert!(!other.time_line().is_playing() && !other.time_line().has_ghost());
}

#[test]
fn a_run_with_more_changes_than_a_link_holds_goes_on_to_the_bit() {
    let mut play = utube();
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(1.0));
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    let kept = play.time_line().kept(play.basis())[0].id;
    play.change_run(|line, basis| line.back_to_start(basis));
    play.change_run(|line, _| line.play());
    for change in 0..400 {
        play.change_run(|line, _| line.tick(0.02));
        set(&mut play, "b", 100.0 + f64::from(change));
    }
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    play.change_run(|line, _| line.show_kept(kept, false));
    // What follows this moment becomes the ghost.
    play.change_run(|line, _| line.scrub(4.0));
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(0.25));
    assert!(play.time_line().has_ghost());
    let expected = shown(&mut play);
    let mut witness = utube();
    witness.take_over(play.pass_on());
    let mut other = taken_over(&mut witness);
    assert_eq!(bits(&other), bits(&witness));
    assert_eq!(shown(&mut other), expected);
    assert!(other.time_line().is_playing());
    assert!(other.take_announcement().is_none(), "nobody is told again");
    other.change_run(|line, _| line.tick(0.5));
    play.change_run(|line, _| line.tick(0.5));
    assert_eq!(bits(&other), bits(&play));
}
