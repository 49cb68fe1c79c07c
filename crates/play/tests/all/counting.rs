//! Models whose independent variable is a counter.

use crate::support::{bits, go_on, open, state};
use play::Status;

fn document(front: &str) -> String {
    format!(
        "---\ntitle: Rabbits\n{front}---\n\n```model\nindependent k by 1\nparameter r = 3.2 in 0..4\n\
         next p = r*p*(1 - p)\np(0) = 0.1 \"Population\"\n```\n\n```plots\n\"Population\": p against k\n\
         \"Return map\": points p against r*p*(1 - p)\n```\n"
    )
}

/// A run is watched for 5 to 20 s, with or without a stated end.
#[test]
fn a_run_takes_5_to_20_seconds_to_watch() {
    for (front, end) in [("", 100.0), ("until: 40\n", 40.0), ("until: 3000\n", 3000.0)] {
        let play = open(&document(front), &[]);
        let seconds = end / play.program().pace().per_second;
        assert!((5.0..=20.0).contains(&seconds), "{front}: {seconds} s");
    }
    let mut play = open(&document("speed: 3\nuntil: 12\n"), &[]);
    go_on(&mut play, [1.0, 0.5]);
    assert_eq!((play.course().time(), play.basis().time_text(play.course()).as_str()), (4.5, "4"), "counts are whole");
    let at_4 = state(&play);
    play.change_run(|line, _| line.scrub(4.0));
    assert_eq!(state(&play), at_4, "the value holds from one count to the next");
    play.change_run(|line, _| line.scrub(3.999));
    assert_ne!(state(&play), at_4);
    go_on(&mut play, [10.0]);
    assert_eq!((play.course().time(), play.time_line().status()), (12.0, Status::Ended));
    assert_eq!(bits(&play).lines().count(), 14, "a heading and one row for each count: {}", bits(&play));
}

/// A parameter changed during the run is part of the link; the step is not.
#[test]
fn a_link_repeats_the_run() {
    let mut play = open(&document("speed: 10\n"), &[]);
    go_on(&mut play, [1.0]);
    crate::support::set(&mut play, "r", 3.9);
    go_on(&mut play, [1.0]);
    let link = play.share();
    let mut other = open(&document("speed: 10\n"), &[]);
    other.restore(&link).expect("the link holds");
    assert_eq!((bits(&other), other.course().time()), (bits(&play), play.course().time()));
    assert!(!link.contains("&h="), "{link}");
}

/// Another seed restarts the run with other draws. The first seed and the link reproduce the first run.
#[test]
fn a_seed_decides_the_run() {
    let source = "---\ntitle: A walk\nspeed: 10\n---\n\n```model\nindependent k by 1\nrandom seed = 1 in 1..9999 \"Seed\"\n\
                  next x = x + normal(0, 1)\nx(0) = 0 \"Place\"\n```\n";
    let mut play = open(source, &[]);
    go_on(&mut play, [2.0]);
    let first = bits(&play);
    let index = crate::support::parameter(&play, "seed");
    assert!(
        play.change_settings(|settings| settings.set_parameter(index, 1.5)).is_err()
            && play.change_settings(|settings| settings.set_parameter(index, 10_000.0)).is_err()
    );
    crate::support::set(&mut play, "seed", 2.0);
    assert_eq!(play.course().time(), 0.0);
    go_on(&mut play, [2.0]);
    let second = bits(&play);
    assert_ne!(first, second);
    let mut other = open(source, &[]);
    other.restore(&play.share()).expect("the link holds");
    assert_eq!(bits(&other), second);
    play.change_run(|line, _| line.scrub(7.0));
    go_on(&mut play, [1.3]);
    assert_eq!(bits(&play), second, "going back changes no draw");
    crate::support::set(&mut play, "seed", 1.0);
    go_on(&mut play, [2.0]);
    assert_eq!(bits(&play), first);
}
