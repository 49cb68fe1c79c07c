//! The documents that the tests open.
use session::Session;

/// A liquid column in a U-tube, with everything a document can have.
pub const UTUBE: &str = include_str!("utube.md");
/// Its Spanish edition.
pub const UTUBE_ES: &str = include_str!("utube.es.md");

/// Opens a document that must be without faults.
pub fn open(source: &str, translations: &[&str]) -> Session {
    let opened = session::document::open(source, translations);
    assert!(opened.diagnostics.is_empty(), "{:#?}", opened.diagnostics);
    Session::open(opened.document.expect("a document without faults opens"))
}

/// The U-tube.
pub fn utube() -> Session {
    open(UTUBE, &[UTUBE_ES])
}

/// The index of a parameter.
pub fn parameter(session: &Session, name: &str) -> usize {
    session.model().parameters.iter().position(|parameter| parameter.name == name).expect("the parameter exists")
}

/// Sets a parameter to an SI value.
pub fn set(session: &mut Session, name: &str, value: f64) {
    let index = parameter(session, name);
    session.set_parameter(index, value).expect("the value is in the range");
}

/// Lets wall time pass in frames.
pub fn play(session: &mut Session, frames: impl IntoIterator<Item = f64>) {
    session.play();
    for seconds in frames {
        session.tick(seconds);
    }
    session.pause();
}

/// Brings back records as at the next visit.
pub fn bring_back_records(session: &mut Session, saved: &[(String, String)]) {
    saved.iter().for_each(|(_, text)| session.restore_records(text));
}

/// Brings back fits as at the next visit; their records must be there.
pub fn bring_back_fits(session: &mut Session, saved: &[(String, String)]) {
    saved.iter().for_each(|(_, text)| session.restore_fits(text));
}

/// The states shown.
pub fn state(session: &Session) -> Vec<f64> {
    session.states().into_iter().map(|state| state.value).collect()
}

/// The bits of a run: its table without loss.
pub fn bits(session: &Session) -> String {
    session.csv()
}

/// The value of a readout.
pub fn readout(session: &mut Session, name: &str) -> String {
    session.readouts().into_iter().find(|readout| readout.name == name).expect("the readout exists").value
}
