//! Links and saved states.

use crate::support::{bits, go_on, set, utube};
use figure::{Direction, Palette, Point, Settings};
use handed::Number;
use handed::fact::FactValue;
use play::{Extent, Play, PlotId, Refusal};

/// Opens the document again and restores what `play` shares.
fn reopened(play: &Play) -> Play {
    let fragment = play.share();
    let allowed = |character: char| character.is_ascii_alphanumeric() || "-._~!$&'()*+,;=:@/?".contains(character);
    assert!(fragment.chars().all(allowed), "{fragment}");
    let mut other = utube();
    other.restore(&fragment).unwrap_or_else(|refusal| panic!("{fragment}: {refusal:?}"));
    assert_eq!(other.share(), fragment);
    other
}

#[test]
fn nothing_is_shared_of_a_fresh_document() {
    let mut play = utube();
    assert_eq!(play.share(), "");
    play.restore("").unwrap();
    play.restore("#").unwrap();
    assert_eq!(play.share(), "");
}

#[test]
fn a_link_is_short_and_says_what_differs() {
    let mut play = utube();
    set(&mut play, "b", 200.0);
    set(&mut play, "h_l", 3.5);
    play.change_run(|line, _| line.set_speed(2.0));
    play.change_plots(|plots, _| plots.show(PlotId::at(2), true));
    go_on(&mut play, [5.0]);
    assert_eq!(play.share(), "1&p=b:200,h_l:3.5&t=10&x=2&v=1");
    let other = reopened(&play);
    assert_eq!(bits(&other), bits(&play));
    assert_eq!((other.time_line().speed(), other.plots().list()[2].shown), (2.0, true));
    assert!(!other.time_line().is_playing());
}

#[test]
fn what_plots_are_zoomed_to_comes_back() {
    let mut play = utube();
    go_on(&mut play, [5.0]);
    let settings = Settings::default();
    for plot in 0..3 {
        play.layout_plot(PlotId::at(plot), &settings);
    }
    let drawn = |play: &mut Play, plot| play.plots_to_front().svg(PlotId::at(plot), &settings, &Palette::LIGHT);
    let everything = drawn(&mut play, 1);
    play.change_plots(|plots, _| plots.zoom(PlotId::at(0), None, 2.0, Direction::Horizontal));
    play.change_plots(|plots, _| plots.zoom(PlotId::at(1), Some(Point { x: 200.0, y: 90.0 }), 3.0, Direction::Both));
    play.change_plots(|plots, _| plots.pan(PlotId::at(2), 0.0, 17.0));
    let mut other = reopened(&play);
    for plot in 0..3 {
        assert!(!other.plots().list()[plot].automatic);
        assert_eq!(drawn(&mut other, plot), drawn(&mut play, plot));
    }
    assert_ne!(drawn(&mut other, 1), everything);
    other.restore("1&t=5").unwrap();
    assert!(other.plots().list().iter().all(|plot| plot.automatic));
    assert_eq!(drawn(&mut other, 1), everything);
}

#[test]
fn everything_comes_back_with_the_same_bits() {
    let mut play = utube();
    play.change_settings(|settings| settings.set_state(0, 0.123_456_789)).unwrap();
    play.change_settings(|settings| settings.set_method("dormand-prince")).unwrap();
    play.change_settings(|settings| settings.set_step(0.03)).unwrap();
    go_on(&mut play, [1.0 / 3.0]);
    set(&mut play, "b", 1e-7);
    go_on(&mut play, [1.0]);
    set(&mut play, "rho", 2000.0);
    set(&mut play, "g", 1.62);
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    set(&mut play, "h_l", 5.0);
    go_on(&mut play, [2.0]);
    set(&mut play, "b", 0.0);
    go_on(&mut play, [2.0]);
    play.change_run(|line, _| line.scrub(1.0 / 7.0));
    let other = reopened(&play);
    assert_eq!(bits(&other), bits(&play));
    assert_eq!((other.course().time(), other.course().front()), (play.course().time(), play.course().front()));
    assert_eq!(crate::support::state(&other), crate::support::state(&play));
    assert_eq!(other.course().parameters(), play.course().parameters());
    assert_eq!(other.time_line().kept(other.basis()), play.time_line().kept(play.basis()));
}

/// The next step of an adaptive method depends on the previous ones, also if the run continued from an earlier moment.
#[test]
fn a_run_that_goes_on_from_an_earlier_moment_comes_back_with_the_same_bits() {
    for method in ["rk4", "dormand-prince", "rosenbrock"] {
        for back in [0.0, 0.32, 0.5] {
            let mut play = utube();
            play.change_settings(|settings| settings.set_method(method)).unwrap();
            go_on(&mut play, [0.7]);
            play.change_run(|line, _| line.scrub(back));
            play.change_run(|line, _| line.step_forward());
            set(&mut play, "b", 80.0);
            play.change_run(|line, _| line.step_forward());
            play.change_run(|line, _| line.step_forward());
            play.change_run(|line, _| line.scrub(back));
            go_on(&mut play, [0.4]);
            assert_eq!(bits(&reopened(&play)), bits(&play), "{method} from {back}");
        }
    }
}

#[test]
fn a_change_that_has_not_acted_yet_is_shared() {
    let mut play = utube();
    go_on(&mut play, [1.0]);
    set(&mut play, "b", 300.0);
    let mut other = reopened(&play);
    assert_eq!(other.course().parameters(), play.course().parameters());
    go_on(&mut play, [1.0]);
    go_on(&mut other, [1.0]);
    assert_eq!(bits(&other), bits(&play));
}

#[test]
fn a_change_that_is_taken_back_before_it_acts_is_none() {
    for method in ["rk4", "dormand-prince", "rosenbrock"] {
        let (mut play, mut straight) = (utube(), utube());
        for play in [&mut play, &mut straight] {
            play.change_settings(|settings| settings.set_method(method)).unwrap();
            go_on(play, [1.02]);
        }
        let link = play.share();
        set(&mut play, "b", 300.0);
        set(&mut play, "b", 400.0);
        assert_ne!(play.share(), link);
        set(&mut play, "b", 50.0);
        assert_eq!(play.share(), link, "{method}");
        for play in [&mut play, &mut straight] {
            go_on(play, [2.0]);
        }
        assert_eq!(bits(&play), bits(&straight), "{method}");
        assert_eq!(bits(&reopened(&play)), bits(&play), "{method}");
    }
}

#[test]
fn more_changes_than_a_link_holds_leave_the_state() {
    let mut play = utube();
    play.change_run(|line, _| line.play());
    for change in 0..1000 {
        set(&mut play, "b", f64::from(change));
        play.change_run(|line, _| line.tick(0.05));
    }
    play.change_run(|line, _| line.pause());
    let fragment = play.share();
    assert!(fragment.len() < 200, "{fragment}");
    let mut other = utube();
    other.restore(&fragment).unwrap();
    assert_eq!(crate::support::state(&other), crate::support::state(&play));
    assert_eq!(other.course().parameters(), play.course().parameters());
}

#[test]
fn what_does_not_fit_is_left_out_and_named() {
    for (fragment, left_out) in [
        ("1&p=b:200,q:3", "q:3"),
        ("1&p=b:1e9&t=1", "b:1e9"),
        ("1&p=b:nan", "b:nan"),
        ("1&p", "p"),
        ("1&y=1", "y=1"),
        ("1&y=1,inf", "y=1,inf"),
        ("1&m=leapfrog", "m=leapfrog"),
        ("1&h=0", "h=0"),
        ("1&h=-1&t=3", "h=-1"),
        ("1&t=-1", "t=-1"),
        ("1&t=1e300", "t=1e300"),
        ("1&c=0,b:3", "c=0,b:3"),
        ("1&c=10,b:3&c=5,b:3&t=3", "c=5,b:3"),
        ("1&c=99999999,b:3", "c"),
        ("1&v=7", "v=7"),
        ("1&z=7,0:1", "z=7,0:1"),
        ("1&z=0", "z=0"),
        ("1&z=0,1:1", "z=0,1:1"),
        ("1&z=0,2:1", "z=0,2:1"),
        ("1&z=1,0:1,2:3,4:5", "z=1,0:1,2:3,4:5"),
        ("1&z=1,0:NaN", "z=1,0:NaN"),
        ("1&zzz=1", "zzz=1"),
        ("1&&", ""),
        ("1&k&k&k&k&k&k&k", "k"),
    ] {
        let mut play = utube();
        let refusal = play.restore(fragment).expect_err(fragment);
        let Refusal::PartlyRestored { left_out: parts } = &refusal else { panic!("{fragment}: {refusal:?}") };
        assert!(parts.iter().any(|part| part.starts_with(left_out)), "{fragment}: {parts:?}");
        play.change_run(|line, _| line.play());
        play.change_run(|line, _| line.tick(0.1));
    }
    for fragment in ["2&p=b:1", "hello", "%31", "p=b:200", "1;p=b:200", "é"] {
        let mut play = utube();
        assert_eq!(play.restore(fragment), Err(Refusal::UnreadableState), "{fragment}");
        assert_eq!(play.share(), "");
    }
}

#[test]
fn restoring_replaces_what_was_there() {
    let mut play = utube();
    go_on(&mut play, [3.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    play.change_plots(|plots, _| plots.show(PlotId::at(0), false));
    play.change_run(|line, _| line.play());
    play.restore("1&p=b:7&t=2").unwrap();
    assert!(
        !play.time_line().is_playing()
            && play.time_line().kept(play.basis()).is_empty()
            && !play.time_line().has_ghost()
    );
    assert_eq!(play.share(), "1&p=b:7&t=2");
}

/// More than three plots would be too small. The others are hidden at first, and a link stores the selection.
#[test]
fn the_first_plot_is_shown_at_first() {
    let plots: String = (0..5).map(|number| format!("\"Plot {number}\": {number} + x against t\n")).collect();
    let source = format!("---\ntitle: A\n---\n\n```model\nx' = -x/1 [s]\nx(0) = 1\n```\n\n```plots\n{plots}```\n");
    let open = || crate::support::open(&source, &[]);
    let shown = |play: &Play| play.plots().list().iter().map(|plot| plot.shown).collect::<Vec<_>>();
    let mut play = open();
    assert_eq!((shown(&play), play.share().as_str()), (vec![true, false, false, false, false], ""));
    for (changed, link) in [(4, "1&v=1,2,3"), (3, "1&v=1,2"), (0, "1&v=0,1,2")] {
        play.change_plots(|plots, _| plots.show(PlotId::at(changed), changed > 0));
        assert_eq!(play.share(), link);
        let mut other = open();
        other.restore(link).unwrap();
        assert_eq!(shown(&other), shown(&play), "{link}");
    }
    play.restore("1&t=1").unwrap();
    assert_eq!(shown(&play), [true, false, false, false, false]);
}

#[test]
fn parts_of_the_state_can_be_left_out() {
    let mut play = utube();
    go_on(&mut play, [2.0]);
    play.change_run(|line, basis| line.keep(basis)).expect("room for a run");
    set(&mut play, "b", 200.0);
    go_on(&mut play, [1.0]);
    let [whole, unkept, moment] =
        [Extent::Whole, Extent::WithoutKept, Extent::Moment].map(|extent| play.share_within(extent));
    assert_eq!(whole, play.share());
    assert!(whole.contains("&k") && whole.contains("&c="), "{whole}");
    assert_eq!(whole.split_once("&k").map(|(before, _)| before), Some(unkept.as_str()));
    assert!(!moment.contains("&c=") && moment.contains("&y=") && moment.contains("b:200"), "{moment}");
    let mut other = utube();
    other.restore(&moment).expect("a state");
    let state = |play: &Play| -> Vec<u64> { play.values().states().iter().map(|own| own.value.to_bits()).collect() };
    assert_eq!(state(&other), state(&play));
    play.change_run(|line, _| line.set_speed(2.0));
    assert_eq!(play.share_within(Extent::Start), "1&p=b:200", "neither the way there nor the view");
}

#[test]
fn facts_follow_from_the_state() {
    let mut play = utube();
    go_on(&mut play, [2.0]);
    play.change_run(|line, basis| line.keep(basis)).expect("room for a run");
    set(&mut play, "b", 200.0);
    go_on(&mut play, [1.0]);
    play.change_answers(|answers, run| answers.check(run, 0, "17"));
    let facts = |play: &Play| (play::facts_of_run(play, "text".to_owned()), play::facts_of_answers(play));
    let mut other = reopened(&play);
    for (name, answer) in play.answers().saved(play.basis()) {
        assert!(other.change_answers(|answers, run| answers.restore(run, &name, &answer)));
    }
    assert_eq!(facts(&other), facts(&play));
    let (run, answers) = facts(&play);
    let value = |item: &str, quantity: &str| {
        run.iter().find(|fact| fact.item.ends_with(item) && fact.quantity == quantity).map(|fact| fact.value.clone())
    };
    let title = play.program().title.clone();
    assert_eq!(value(&title, "parameter:b"), Some(FactValue::Number(Number(200.0))));
    assert!(run.iter().any(|fact| fact.item != title && fact.quantity == "parameter:b"), "the kept run");
    assert!(answers.iter().any(|fact| fact.quantity == "grade:1"), "{answers:?}");
}
