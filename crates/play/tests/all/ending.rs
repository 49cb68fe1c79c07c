//! Events that end a run, and remembered values.

use crate::support::{bits, go_on, open, readout};
use play::{Play, Status};

const STONE: &str = "---\ntitle: A stone\nstep: 0.1 [s]\n---\n\n```model\ny'' = -9.8 [m/s^2]\ny(0) = 0 [m]\n\
                     y'(0) = 4.9 [m/s]\nwhen y < 0 [m] as landing { stop } \"The stone has landed\"\n\
                     T = landing.time\nh = maximum(y)\n```\n";

fn stone() -> Play {
    open(STONE, &[])
}

#[test]
fn a_run_ends_at_an_event_and_goes_on_when_asked() {
    let mut play = stone();
    assert_eq!(readout(&mut play, "T"), "–", "there is no value yet");
    let names: Vec<String> = play.readouts().into_iter().map(|readout| readout.name).collect();
    assert_eq!(names, ["t", "y", "y'", "T", "h"]);
    go_on(&mut play, [0.5, 0.4, 0.4, 0.4]);
    assert!((play.course().time() - 1.0).abs() < 1e-9, "{}", play.course().time());
    assert_eq!(play.time_line().status(), Status::Ended);
    let problem = play.time_line().problem(play.basis()).expect("a reason");
    assert_eq!(problem.code, "ended");
    assert!(problem.message.ends_with("The stone has landed."), "{}", problem.message);
    assert_eq!(
        play.time_line().ending(play.basis()).as_deref(),
        Some("The run ends at t = 1 s: The stone has landed.")
    );
    play.set_language("es");
    assert_eq!(
        play.time_line().ending(play.basis()).as_deref(),
        Some("El ensayo termina en t = 1 s: The stone has landed.")
    );
    play.set_language("en");
    assert!(readout(&mut play, "T").starts_with('1'), "{}", readout(&mut play, "T"));
    // A link restores the time at the end, and also a time beyond it.
    for more in [0.0, 1.0] {
        if more > 0.0 {
            go_on(&mut play, [more]);
            assert!((play.course().time() - 1.0 - more).abs() < 1e-9, "{}", play.course().time());
        }
        let mut other = stone();
        other.restore(&play.share()).expect("the link holds");
        assert_eq!((other.course().time(), bits(&other)), (play.course().time(), bits(&play)));
    }
    // After scrubbing back before the end, the run ends again.
    play.change_run(|line, _| line.scrub(0.5));
    assert!(play.time_line().problem(play.basis()).is_none() && play.time_line().ending(play.basis()).is_none());
    go_on(&mut play, [2.0]);
    assert_eq!(play.time_line().problem(play.basis()).map(|problem| problem.code), Some("ended"));
}
