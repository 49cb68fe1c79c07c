//! Fits of several records: shared numbers, a fitted window, and several theories.

use super::{DAMPING, LENGTHS, fit, place, theory, three, together};
use desk::saved::Item;
use desk::{Desk, ExportKind, Imprint};

/// `0.1802 ± 0.0004` as a number.
fn number(value: &str) -> f64 {
    let plain = value.trim_start_matches('(').split(['±', '(']).next().unwrap().trim().replace('−', "-");
    plain.parse().unwrap_or_else(|_| panic!("{value}"))
}

#[test]
fn records_are_fitted_together() {
    let mut desk = three();
    // The latest record is chosen by default and always takes part.
    let records = desk.fits().records();
    assert_eq!(records.iter().map(|record| record.taking_part).collect::<Vec<_>>(), [false, false, true]);
    assert!(records[2].chosen);
    // With one record there is nothing to share.
    assert!(desk.fits().choices().iter().all(|choice| choice.same.is_none()));
    together(&mut desk);
    // As on the command line, each record has its own varied values, and all share the sliders' fixed values.
    for choice in desk.fits().choices().iter().filter(|choice| !choice.name.is_empty()) {
        assert_eq!(choice.same, Some(!choice.varied), "{choice:?}");
    }
    let gamma = place(&desk, "gamma");
    desk.change_fits(|fits, data| fits.set_same(data.play(), gamma, true));
    let found = fit(&mut desk);
    let of = |name: &str| {
        let estimates = found.estimates.iter().filter(|one| one.name == name);
        estimates.map(|one| (one.record.as_str(), number(&one.value))).collect::<Vec<_>>()
    };
    let shared = of("gamma");
    assert_eq!(shared.len(), 1);
    assert_eq!(shared[0].0, "");
    assert!((shared[0].1 - DAMPING).abs() < 0.01, "{shared:?}");
    let lengths = of("L");
    assert_eq!(lengths.iter().map(|one| one.0).collect::<Vec<_>>(), ["tube 1.txt", "tube 2.txt", "tube 3.txt"]);
    for ((_, found), truth) in lengths.iter().zip(LENGTHS) {
        assert!((found / truth - 1.0).abs() < 0.01, "{lengths:?}");
    }
    // A quantity derived from a record's own length belongs to this record. Estimates for all records come first.
    assert_eq!(of("T").len(), 3);
    assert_eq!(found.estimates[0].record, "");
    assert_eq!(desk.fits().list()[0].records.len(), 3);
    assert_eq!(desk.fits().list()[0].counts.0, 540);
    let files = desk.fits().export(desk.fits().list()[0].id, ExportKind::Report, Imprint::default()).unwrap();
    assert_eq!(files.name, "tube-1-tube-2-tube-3.html");
    let page = String::from_utf8(files.bytes).unwrap();
    for record in 1..=3 {
        assert!(page.contains(&format!("<figcaption>tube {record}.txt.")), "a figure of each record");
    }
}

#[test]
fn the_sliders_follow_the_record_that_is_looked_at() {
    let mut desk = three();
    together(&mut desk);
    let length = |desk: &Desk| desk.play().course().parameters()[place(desk, "L")];
    fit(&mut desk);
    assert!((length(&desk) - 0.3).abs() < 0.003);
    let shown = |desk: &Desk| desk.records().list().iter().map(|record| record.shown).collect::<Vec<_>>();
    assert_eq!(shown(&desk), [false, false, true]);
    let first = desk.records().list()[0].id;
    desk.choose_record(first);
    assert!((length(&desk) - 0.18).abs() < 0.002);
    assert_eq!(shown(&desk), [true, false, false]);
    while let Some(told) = desk.take_announcement() {
        let text = told.text(desk.play());
        assert!(text != "The parameters have the fitted values", "of which record is said: {text}");
    }
    // A fit of one record does not change the sliders when another record is chosen.
    desk.fits().records().iter().for_each(|record| desk.change_fits(|fits, _| fits.include(record.id, false)));
    fit(&mut desk);
    let second = desk.records().list()[1].id;
    desk.choose_record(second);
    assert!((length(&desk) - 0.18).abs() < 0.002);
}

#[test]
fn what_is_known_of_each_record_is_held() {
    let mut desk = three();
    together(&mut desk);
    let (length, records) = (place(&desk, "L"), desk.fits().records());
    desk.change_fits(|fits, data| fits.vary(data.play(), length, false));
    assert_eq!(desk.fits().choices()[length].values, []);
    desk.change_fits(|fits, data| fits.set_same(data.play(), length, false));
    assert_eq!(desk.fits().choices()[length].values.len(), 3);
    for (record, truth) in records.iter().zip(["18 cm", "0.24", "0.3"]) {
        desk.change_records(|records, open| records.set_known(open, length, record.id, truth)).unwrap();
    }
    assert_eq!(desk.fits().choices()[length].values[0].text, "0.18");
    let first = records[0].id;
    assert!(desk.change_records(|records, open| records.set_known(open, length, first, "3 kg")).is_err());
    assert!(desk.change_records(|records, open| records.set_known(open, length, first, "-1")).is_err());
    let found = fit(&mut desk);
    assert!(found.estimates.iter().all(|one| one.name != "L"));
    let damping: Vec<f64> =
        found.estimates.iter().filter(|one| one.name == "gamma").map(|one| number(&one.value)).collect();
    assert!(damping.len() == 3 && damping.iter().all(|found| (found - DAMPING).abs() < 0.03), "{damping:?}");
    assert_eq!(desk.play().course().parameters()[length], 0.3);
    desk.choose_record(records[0].id);
    assert_eq!(desk.play().course().parameters()[length], 0.18);
    // The value is restored at the next visit.
    let saved = desk.records().saved();
    let mut later = Desk::open(theory("linear"));
    crate::support::bring_back_records(&mut later, &saved);
    together(&mut later);
    later.change_fits(|fits, data| fits.vary(data.play(), length, false));
    later.change_fits(|fits, data| fits.set_same(data.play(), length, false));
    assert_eq!(later.fits().choices()[length].values, desk.fits().choices()[length].values);
    // Without a value the slider's value is used.
    let first = later.fits().records()[0].id;
    later.change_records(|records, open| records.set_known(open, length, first, "")).unwrap();
    assert_eq!(later.fits().choices()[length].values[0].text, "0.2");
}

#[test]
fn theories_of_several_records_are_ranked() {
    let mut desk = three();
    together(&mut desk);
    let gamma = place(&desk, "gamma");
    desk.change_fits(|fits, data| fits.set_same(data.play(), gamma, true));
    let theories = ["quadratic", "linear"].map(|name| (format!("theories/{name}.md"), theory(name)));
    desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
    while desk.advance_fit() {}
    let fits = desk.fits().list();
    assert_eq!(fits[0].theory, theory("linear").program.title);
    assert!(fits.iter().all(|fit| fit.records.len() == 3));
    let shared = |id| desk.fits().detail(id).unwrap().estimates.iter().filter(|one| one.record.is_empty()).count();
    assert_eq!((shared(fits[0].id), shared(fits[1].id)), (1, 0), "gamma alone, where there is one");
    let page = desk.fits().export_ranking(fits[0].id, ExportKind::Report, Imprint::default()).unwrap().bytes;
    let page = String::from_utf8(page).unwrap();
    assert_eq!(page.matches("<svg").count(), 6, "of both theories in every record");
}

/// A robust loss can be chosen, is reported, is ranked separately from least squares, and is restored at the next
/// visit.
#[test]
fn a_loss_is_chosen_and_kept() {
    let mut desk = three();
    fit(&mut desk);
    assert_eq!(desk.fits().losses(), (vec!["least squares", "Huber's loss", "Tukey's loss"], 0));
    desk.change_fits(|fits, _| fits.set_loss(2));
    fit(&mut desk);
    let fits = desk.fits().list();
    assert_eq!(fits.len(), 2);
    let said = |desk: &Desk| -> Vec<bool> {
        let details = desk.fits().list().into_iter().map(|fit| desk.fits().detail(fit.id).unwrap());
        details.map(|detail| detail.sentences.iter().any(|one| one.contains("Tukey's loss"))).collect()
    };
    assert_eq!(said(&desk), [false, true]);
    let (records, fits) = (desk.records().saved(), desk.fits().saved());
    let mut later = Desk::open(theory("cosine"));
    crate::support::bring_back_records(&mut later, &records);
    crate::support::bring_back_fits(&mut later, &fits);
    while later.advance_fit() {}
    let found = said(&later);
    assert_eq!((found.len(), found.iter().filter(|said| **said).count()), (2, 1));
    assert_eq!(later.fits().saved().iter().filter(|(_, fit)| fit.write(0).contains("\"loss\":\"tukey\"")).count(), 1);
}

/// A film whose clock starts at 0.5 s and whose column is released after 1 s.
fn late_film() -> String {
    let omega = libm::sqrt(19.6 / 0.2 - 0.16);
    let mut state = 5_u64;
    let row = |frame: u32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let noise = ((state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5) * 4e-4;
        let t = f64::from(frame) / 30.0;
        let since = (t - 1.0).max(0.0);
        let swing = libm::cos(omega * since) + 0.4 / omega * libm::sin(omega * since);
        format!("{} {}\n", t + 0.5, 0.04 * libm::exp(-0.4 * since) * swing + noise)
    };
    (0..180).map(row).collect()
}

/// The initial values hold at the start of the fitted part: in the result, on the sliders, beside the record, and after
/// a restored visit.
#[test]
fn a_part_begins_with_its_initial_values() {
    let said = "The initial values refer to t = 1.5 s. Nothing is predicted of the 30 values before.";
    let mut desk = Desk::open(theory("quadratic"));
    desk.add_record("film.txt", late_film().as_bytes()).unwrap();
    desk.change_fits(|fits, data| fits.set_window(data.play(), 0, "1.5")).unwrap();
    let of_part = fit(&mut desk);
    assert!(of_part.sentences.iter().any(|sentence| sentence == said), "{:?}", of_part.sentences);
    let start = desk.play().course().parameters()[place(&desk, "y_0")];
    // The theory's friction differs from that of the film, which biases the value slightly.
    assert!((start - 0.04).abs() < 0.01, "{start}");
    let values = desk.play().course().parameters().to_vec();
    let (records, fits) = (desk.records().saved(), desk.fits().saved());
    // A fit of all values begins at the first one again, and a fit of a part at its start.
    desk.change_fits(|fits, data| fits.set_window(data.play(), 0, "")).unwrap();
    let whole = fit(&mut desk);
    let begins = |sentence: &&String| sentence.starts_with("The initial values refer to ");
    let begins = whole.sentences.iter().find(begins).unwrap();
    assert!(begins != said && !begins.contains("Nothing is predicted"), "{begins}");
    desk.change_fits(|fits, data| fits.set_window(data.play(), 0, "1.5")).unwrap();
    fit(&mut desk);
    for (one, other) in desk.play().course().parameters().iter().zip(&values) {
        assert!((one - other).abs() <= 1e-3 * other.abs(), "{one} {other}");
    }

    // The origin of the model in the record is restored without a fit.
    let mut again = Desk::open(theory("quadratic"));
    crate::support::bring_back_records(&mut again, &records);
    let begins = |records: &[(String, Item)]| records[0].1.write(0).contains("\"origin\":1.5");
    assert!(begins(&records));
    assert_eq!(again.records().saved(), records);
    // With another document the origin is not valid.
    let mut other = Desk::open(theory("linear"));
    crate::support::bring_back_records(&mut other, &records);
    assert!(!begins(&other.records().saved()));

    let restored = |fit: &Item| {
        let mut later = Desk::open(theory("quadratic"));
        crate::support::bring_back_records(&mut later, &records);
        assert!(later.restore_item(fit).is_some());
        while later.advance_fit() {}
        later.fits().detail(later.fits().list()[0].id).unwrap()
    };
    assert_eq!(restored(&fits[0].1), of_part, "searches and other minima among it");
    // A fit without values is searched again in full.
    let mut text: serde_json::Value = serde_json::from_str(&fits[0].1.write(0)).unwrap();
    text["item"]["fit"]["found"] = serde_json::json!({});
    let (_, unsearched) = Item::read(&text.to_string()).unwrap();
    let sentences = restored(&unsearched).sentences;
    assert!(sentences.iter().any(|sentence| sentence == said), "{sentences:?}");
}

/// Ids of removed fits and kept runs are not reused, because old references may exist.
#[test]
fn ids_are_given_once() {
    let mut desk = three();
    fit(&mut desk);
    let first = desk.fits().list()[0].id;
    desk.change_fits(|fits, data| fits.remove(data.play(), first));
    let record = desk.records().list()[0].id;
    desk.choose_record(record);
    let theories = [("theories/quadratic.md".to_owned(), theory("quadratic"))];
    desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
    while desk.advance_fit() {}
    let second = desk.fits().list()[0].id;
    assert_ne!(first, second);
    // Ids are not reused with another document either.
    desk.change_fits(|fits, data| fits.remove(data.play(), second));
    let mut other = Desk::open(theory("quadratic"));
    other.adopt(&mut desk);
    other.change_fits(|fits, data| fits.begin(data, "theories/quadratic.md")).unwrap();
    while other.advance_fit() {}
    assert!(![first, second].contains(&other.fits().list()[0].id));
    other.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    let kept = other.play().time_line().kept(other.play().basis())[0].id;
    other.play_mut().change_run(|line, basis| line.remove_kept(basis, kept));
    other.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    assert_ne!(other.play().time_line().kept(other.play().basis())[0].id, kept);
}
