//! Fits that are restored at the next visit.

use super::{film, fit, place, theory, three, together};
use desk::Desk;
use desk::saved::Item;
use std::collections::BTreeSet;

#[test]
fn fits_come_back() {
    let mut desk = three();
    // One fit of a part of one record, then one of all records.
    desk.change_fits(|fits, data| fits.set_window(data.play(), 1, "4")).unwrap();
    fit(&mut desk);
    desk.change_fits(|fits, data| fits.set_window(data.play(), 1, "")).unwrap();
    together(&mut desk);
    let gamma = place(&desk, "gamma");
    desk.change_fits(|fits, data| fits.set_same(data.play(), gamma, true));
    fit(&mut desk);
    let theories = ["quadratic", "linear"].map(|name| (format!("theories/{name}.md"), theory(name)));
    desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
    while desk.advance_fit() {}
    let before = desk.fits().list();
    assert_eq!(before.len(), 3, "the same fit twice is one");

    let (records, fits) = (desk.records().saved(), desk.fits().saved());
    // The page is opened with another document.
    let mut later = Desk::open(theory("cosine"));
    crate::support::bring_back_records(&mut later, &records);
    crate::support::bring_back_fits(&mut later, &fits);
    assert!(later.fits().has_waiting());
    assert_eq!(later.fits().saved(), fits, "whoever leaves at once loses nothing");
    let mut trials = 0;
    while later.advance_fit() {
        trials += 1;
        assert!(later.fits().progress().is_none(), "nobody has begun it");
        if trials == 2 {
            assert_eq!(later.fits().saved().len(), fits.len(), "nor does who leaves meanwhile");
        }
    }
    assert!(trials < 60, "{trials}");
    assert!(later.take_announcement().is_none());
    let after = later.fits().list();
    assert_eq!(after.len(), 3);
    for (one, other) in before.iter().zip(&after) {
        assert_eq!(
            (&one.theory, &one.records, one.counts, &one.rmse, &one.predicted, &one.difference, &one.weight),
            (
                &other.theory,
                &other.records,
                other.counts,
                &other.rmse,
                &other.predicted,
                &other.difference,
                &other.weight
            )
        );
        assert_eq!(desk.fits().detail(one.id), later.fits().detail(other.id));
        // The texts of the theory are restored unchanged.
        assert_eq!(desk.fits().texts(one.id), later.fits().texts(other.id));
    }
    assert!(after.iter().any(|fit| !fit.predicted.is_empty()));
    let names = |saved: &[(String, Item)]| saved.iter().map(|(name, _)| name.clone()).collect::<BTreeSet<_>>();
    assert_eq!(names(&later.fits().saved()), names(&fits), "whatever the last digits of what was found");
    assert!(later.fits().records().iter().all(|record| record.taking_part), "as they were");
}

#[test]
fn fits_that_cannot_come_back_are_left_out() {
    let mut desk = three();
    assert_eq!(desk.fits().saved(), []);
    fit(&mut desk);
    let (records, fits) = (desk.records().saved(), desk.fits().saved());
    let text = fits[0].1.write(0);
    let restored = |records: &[(String, Item)], fit: &str| {
        let mut later = Desk::open(theory("linear"));
        crate::support::bring_back_records(&mut later, records);
        let taken = crate::support::bring_back_texts(&mut later, &[fit]);
        while later.advance_fit() {}
        assert!(later.fits().list().len() <= taken);
        later.fits().list().len()
    };
    assert_eq!(restored(&records, &text), 1);
    assert_eq!(restored(&[], &text), 0);
    let renamed: Vec<(String, Item)> = (records.iter())
        .map(|(name, record)| {
            let text = record.write(0).replace("tube 3.txt", "tube 4.txt");
            (name.clone(), Item::read(&text).unwrap().1)
        })
        .collect();
    assert_eq!(restored(&renamed, &text), 0, "another record in its place");
    for (from, to) in [
        ("\"parameters\":[", "\"parameters\":[1,"),
        ("\"parameter\":0", "\"parameter\":99"),
        ("\"record\":\"", "\"record\":\"x"),
        ("\"values\":[", "\"values\":[\"x\","),
        ("\"column\":1", "\"column\":9"),
        ("\"meniscus\":3", "\"meniscus\":4"),
    ] {
        assert!(text.contains(from), "{from} {text}");
        assert_eq!(restored(&records, &text.replace(from, to)), 0, "{from}");
    }
    // Fields of later versions are ignored, and missing ones have their defaults.
    let more =
        text.replace("\"parameters\":", "\"more\":{\"a\":[null]},\"parameters\":").replace("\"stated\":false,", "");
    assert_eq!(restored(&records, &more), 1);
    // A fit of a removed record is not stored.
    let gone = desk.records().list()[2].id;
    desk.change_records(|records, _| records.remove(gone));
    assert_eq!(desk.fits().saved(), []);
    // A new record does not replace the removed one.
    desk.add_record("tube 3.txt", film(0.5, 0.1, 9).as_bytes()).unwrap();
    assert_eq!(desk.fits().saved(), []);
}
