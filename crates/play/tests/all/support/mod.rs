//! Documents opened by the tests.
use play::Play;

/// A liquid column in a U-tube, with everything a document can have.
pub const UTUBE: &str = include_str!("utube.md");
/// Its Spanish edition.
pub const UTUBE_ES: &str = include_str!("utube.es.md");

/// Opens a document that must be without faults.
pub fn open(source: &str, translations: &[&str]) -> Play {
    catalogues::install();
    let opened = document::open(source, translations);
    assert!(opened.diagnostics.is_empty(), "{:#?}", opened.diagnostics);
    Play::open(opened.document.expect("a document without faults opens").program)
}

/// The U-tube.
pub fn utube() -> Play {
    open(UTUBE, &[UTUBE_ES])
}

/// The index of a parameter.
pub fn parameter(play: &Play, name: &str) -> usize {
    play.model().parameters.iter().position(|parameter| parameter.name == name).expect("the parameter exists")
}

/// Sets a parameter to an SI value.
pub fn set(play: &mut Play, name: &str, value: f64) {
    let index = parameter(play, name);
    play.change_settings(|settings| settings.set_parameter(index, value)).expect("the value is in the range");
}

/// Lets wall time pass in frames.
pub fn go_on(play: &mut Play, frames: impl IntoIterator<Item = f64>) {
    play.change_run(|line, _| line.play());
    for seconds in frames {
        play.change_run(|line, _| line.tick(seconds));
    }
    play.change_run(|line, _| line.pause());
}

/// The states shown.
pub fn state(play: &Play) -> Vec<f64> {
    play.values().states().into_iter().map(|state| state.value).collect()
}

/// The bits of a run: its table without loss.
pub fn bits(play: &Play) -> String {
    play.values().csv()
}

/// The value of a readout.
pub fn readout(play: &mut Play, name: &str) -> String {
    play.readouts().into_iter().find(|readout| readout.name == name).expect("the readout exists").value
}
