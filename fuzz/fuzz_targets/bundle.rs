//! Any bytes as a bundle; what is read is played, drawn and written again.

#![no_main]

use libfuzzer_sys::fuzz_target;
use play::figure::Settings;
use play::{Play, PlotId};
use program::bundle;

fuzz_target!(|bytes: &[u8]| {
    let Ok(program) = bundle::read(bytes) else { return };
    let written = bundle::write(&program).expect("what was read can be written");
    assert!(bundle::read(&written).is_ok());
    let mut play = Play::open(program);
    play.change_run(|line, _| line.play());
    for _ in 0..4 {
        play.change_run(|line, _| line.tick(0.1));
    }
    play.change_run(|line, _| line.pause());
    play.layout_plot(PlotId::at(0), &Settings::default());
    let _ = (
        play.readouts(),
        play.controls().presets(play.basis(), play.course()),
        play.scene().values().len(),
        play.change_answers(|answers, run| answers.check(run, 0, "1")),
    );
});
