//! The documents that the tests open.
use desk::Desk;
use desk::saved::Item;
use play::Play;

/// A liquid column in a U-tube, with everything a document can have.
pub const UTUBE: &str = include_str!("../../../../play/tests/all/support/utube.md");
/// Its Spanish edition.
pub const UTUBE_ES: &str = include_str!("../../../../play/tests/all/support/utube.es.md");

/// Opens a document and asserts that it has no findings.
pub fn open(source: &str, translations: &[&str]) -> Desk {
    catalogues::install();
    let opened = desk::document::open(source, translations);
    assert!(opened.diagnostics.is_empty(), "{:#?}", opened.diagnostics);
    Desk::open(opened.document.expect("a document without faults opens"))
}

/// The U-tube.
pub fn utube() -> Desk {
    open(UTUBE, &[UTUBE_ES])
}

/// The index of a parameter.
pub fn parameter(desk: &Desk, name: &str) -> usize {
    desk.play().model().parameters.iter().position(|parameter| parameter.name == name).expect("the parameter exists")
}

/// Sets a parameter to an SI value.
pub fn set(desk: &mut Desk, name: &str, value: f64) {
    let index = parameter(desk, name);
    desk.play_mut()
        .change_settings(|settings| settings.set_parameter(index, value))
        .expect("the value is in the range");
}

/// Lets wall time pass in frames.
pub fn play(desk: &mut Desk, frames: impl IntoIterator<Item = f64>) {
    desk.play_mut().change_run(|line, _| line.play());
    for seconds in frames {
        desk.play_mut().change_run(|line, _| line.tick(seconds));
    }
    desk.play_mut().change_run(|line, _| line.pause());
}

/// Restores records as at the next visit.
pub fn bring_back_records(desk: &mut Desk, saved: &[(String, Item)]) {
    for (_, item) in saved {
        assert!(desk.restore_item(&stored(item)).is_some());
    }
}

/// Restores fits as at the next visit. Their records must be there.
pub fn bring_back_fits(desk: &mut Desk, saved: &[(String, Item)]) {
    for (_, item) in saved {
        assert!(desk.restore_item(&stored(item)).is_some());
    }
}

/// An item after a round trip through the storage.
fn stored(item: &Item) -> Item {
    let (since, item) = Item::read(&item.write(1_763_812_800_000)).expect("it reads back");
    assert_eq!(since, 1_763_812_800_000);
    item
}

/// Restores the records and fits of stored texts. Returns the number of restored items.
pub fn bring_back_texts(desk: &mut Desk, texts: &[&str]) -> usize {
    let items = texts.iter().filter_map(|text| Item::read(text));
    items.filter_map(|(_, item)| desk.restore_item(&item)).count()
}

/// The states shown.
pub fn state(desk: &Desk) -> Vec<f64> {
    desk.play().values().states().into_iter().map(|state| state.value).collect()
}

/// The value of a readout.
pub fn readout(desk: &mut Desk, name: &str) -> String {
    desk.play_mut().readouts().into_iter().find(|readout| readout.name == name).expect("the readout exists").value
}

/// The simulation after measured data were updated, as before each drawing.
pub fn followed(desk: &mut Desk) -> &mut Play {
    desk.follow();
    desk.play_mut()
}
