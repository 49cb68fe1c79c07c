//! Another program in the place of the present one while it runs.

mod choices;
mod run;

use crate::support::{UTUBE, go_on, open, set, utube};
use play::program::Program;
use play::{Announcement, Play};

/// The U-tube with some parts of its text replaced.
fn edited(changes: &[(&str, &str)]) -> Program {
    let text = changes.iter().fold(UTUBE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    open(&text, &[]).program().clone()
}

/// A fresh run of a program.
fn fresh(changes: &[(&str, &str)]) -> Play {
    Play::open(edited(changes))
}

/// What the last replacement has dropped.
fn dropped(play: &mut Play) -> Vec<String> {
    let announcements = std::iter::from_fn(|| play.take_announcement());
    let lost = announcements.filter_map(|announcement| match announcement {
        Announcement::Replaced(lost) => Some(lost),
        _ => None,
    });
    lost.last().expect("a replacement is announced")
}

/// 5 s with b = 50 kg/s, then with 200, of which 3.3 s are shown.
fn swinging() -> Play {
    let mut play = utube();
    go_on(&mut play, [5.0]);
    set(&mut play, "b", 200.0);
    go_on(&mut play, [5.0]);
    play.scrub(3.3);
    play
}
