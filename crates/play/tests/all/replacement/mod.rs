//! Replacing the program while it runs.

mod choices;
mod passing;
mod run;

use crate::support::{UTUBE, go_on, open, set, utube};
use play::program::Program;
use play::{Announcement, Play};

/// The U-tube with parts of its text replaced.
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

/// Items dropped by the last replacement.
fn dropped(play: &mut Play) -> Vec<String> {
    let announcements = std::iter::from_fn(|| play.take_announcement());
    let lost = announcements.filter_map(|announcement| match announcement {
        Announcement::Replaced(lost) => Some(lost),
        _ => None,
    });
    lost.last().expect("a replacement is announced")
}

/// 5 s with b = 50 kg/s, then b = 200 kg/s; the moment 3.3 s is shown.
fn swinging() -> Play {
    let mut play = utube();
    go_on(&mut play, [5.0]);
    set(&mut play, "b", 200.0);
    go_on(&mut play, [5.0]);
    play.change_run(|line, _| line.scrub(3.3));
    play
}
