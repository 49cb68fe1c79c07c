//! The storage format: stored data, damaged data, and round trips.

use crate::support::{bring_back_texts, utube};
use desk::saved::Item;
use desk::{Desk, Differentiation, Visit};
use play::Grade;
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;

const RECORD: &str = include_str!("stored/record.json");
const OTHER: &str = include_str!("stored/other-record.json");
const FIT: &str = include_str!("stored/fit.json");
const FIT_OF_TWO: &str = include_str!("stored/fit-of-two.json");

fn linear() -> Desk {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories");
    let read = |name: &str| std::fs::read_to_string(directory.join(name)).unwrap();
    Desk::open(desk::document::open(&read("linear.md"), &[&read("linear.es.md")]).document.unwrap())
}

/// Storage key of the open document.
const DOCUMENT: &str = "linear";

/// Opens a page with this storage. Returns its desk, its visit, and the number of records without room.
fn begin(storage: &mut BTreeMap<String, String>) -> (Desk, Visit, usize) {
    let (mut desk, mut visit) = (linear(), Visit::default());
    let closed = visit.restore_measured(&mut desk, storage);
    (desk, visit, closed)
}

fn stored() -> BTreeMap<String, String> {
    [
        ("record:159d2ddcf951f93c", RECORD),
        ("record:ad6a005bfab9dd0f", OTHER),
        ("fit:fc704d21dc511cbb", FIT),
        ("fit:32b1c3fa448d2a8c", FIT_OF_TWO),
    ]
    .map(|(key, text)| (key.to_owned(), text.to_owned()))
    .into()
}

#[test]
fn records_and_fits_come_back_and_are_stored_once() {
    let mut storage = stored();
    let (mut desk, mut visit, closed) = begin(&mut storage);
    assert_eq!(closed, 0);
    let names: Vec<(String, bool, usize)> =
        desk.records().list().into_iter().map(|record| (record.name, record.shown, record.columns.len())).collect();
    assert_eq!(names, [("tube 2.txt".into(), false, 2), ("vídeo 1.txt".into(), true, 4)]);
    let columns = desk.records().list().remove(1).columns;
    assert_eq!(
        (columns[0].unit_origin.as_str(), columns[1].unit_origin.as_str()),
        ("stated by you", "from the header")
    );
    assert_eq!(columns[3].made, "polynomials of degree 2 over 5 rows");
    let gamma = desk.fits().choices().iter().find(|choice| choice.name == "gamma").unwrap().index;
    desk.change_fits(|fits, data| fits.vary(data.play(), gamma, false));
    desk.change_fits(|fits, data| fits.set_same(data.play(), gamma, false));
    assert!(desk.fits().choices()[gamma].values.iter().any(|known| known.text == "0.41"));

    // No item is stored twice, and each keeps its time.
    assert!(visit.save(&desk, &mut storage, DOCUMENT, 9000));
    let items = |storage: &BTreeMap<String, String>| -> Vec<(String, u64)> {
        let items = storage.iter().filter(|(key, _)| !key.starts_with("state:"));
        items.map(|(key, text)| (key.clone(), Item::read(text).unwrap().0)).collect()
    };
    let kept = items(&storage);
    let times = |kind: &str| -> Vec<u64> {
        let mut times: Vec<u64> =
            kept.iter().filter(|(key, _)| key.starts_with(kind)).map(|(_, since)| *since).collect();
        times.sort_unstable();
        times
    };
    assert_eq!((times("record:"), times("fit:")), (vec![900, 1000], vec![2000, 3000]));
    assert!(kept.iter().any(|(key, _)| key == "record:159d2ddcf951f93c"), "{kept:?}");
    let written = storage.clone();

    let (mut later, mut other, _) = begin(&mut storage);
    other.save(&later, &mut storage, DOCUMENT, 9000);
    assert_eq!(storage, written, "another visit changes nothing");
    for desk in [&mut desk, &mut later] {
        while desk.advance_fit() {}
        let fits = desk.fits().list();
        assert_eq!(fits.len(), 2);
        let losses: Vec<bool> = (fits.iter())
            .map(|fit| desk.fits().detail(fit.id).unwrap().sentences.iter().any(|one| one.contains("Tukey's loss")))
            .collect();
        assert_eq!(losses.iter().filter(|tukey| **tukey).count(), 1);
        assert!(fits.iter().any(|fit| fit.records == ["vídeo 1.txt", "tube 2.txt"]));
    }
    let details = |desk: &Desk| desk.fits().list().iter().map(|fit| desk.fits().detail(fit.id)).collect::<Vec<_>>();
    assert_eq!(details(&desk), details(&later));
}

#[test]
fn what_another_page_removed_is_gone() {
    let mut storage = stored();
    let (mut desk, mut visit, _) = begin(&mut storage);
    visit.save(&desk, &mut storage, DOCUMENT, 9000);
    let (other, mut their_visit, _) = begin(&mut storage);
    let record = desk.records().list()[1].id;
    desk.change_records(|records, _| records.remove(record));
    visit.save(&desk, &mut storage, DOCUMENT, 9001);
    their_visit.save(&other, &mut storage, DOCUMENT, 9002);
    assert!(!storage.contains_key("record:159d2ddcf951f93c"));
    // Its fits go at the next visit.
    let (desk, mut visit, _) = begin(&mut storage);
    visit.save(&desk, &mut storage, DOCUMENT, 9003);
    assert_eq!(storage.keys().filter(|key| key.starts_with("fit:")).count(), 0);
}

#[test]
fn a_record_that_there_is_no_room_for_stays_in_the_storage() {
    // Two pages have each stored a record that leaves no room for the other.
    let rows = |from: usize| (from..from + 50_000).map(|row| format!("{row} {row}.5\n")).collect::<String>();
    let storage: BTreeMap<String, String> = ["one", "two"]
        .iter()
        .zip(1..)
        .map(|(name, since)| {
            let mut desk = linear();
            desk.add_record(name, rows(100_000 * since as usize).as_bytes()).unwrap();
            let (key, item) = desk.records().saved().remove(0);
            (format!("record:{key}"), item.write(since))
        })
        .collect();
    assert_eq!(storage.len(), 2);
    let mut after = storage.clone();
    let (desk, mut visit, closed) = begin(&mut after);
    assert_eq!(closed, 1);
    visit.save(&desk, &mut after, DOCUMENT, 9000);
    after.retain(|key, _| !key.starts_with("state:"));
    assert_eq!(after, storage);
}

#[test]
fn answers_come_back() {
    let mut desk = utube();
    desk.play_mut().change_answers(|answers, run| answers.check(run, 0, "123456"));
    desk.play_mut().change_answers(|answers, _| answers.type_text(1, "\"π\"\\"));
    desk.play_mut().change_answers(|answers, run| answers.reveal(run, 1));
    let saved = desk::saved_answers(desk.play());
    assert_eq!(saved.len(), 2);
    let mut later = utube();
    for (name, item) in &saved {
        let (_, item) = Item::read(&item.write(3)).unwrap();
        assert!(
            desk::restore_answer(later.play_mut(), name, &item) && !desk::restore_answer(later.play_mut(), "x", &item)
        );
        assert_eq!((later.restore_item(&item), later.restore_item(&item)), (None, None));
    }
    assert_eq!(desk::saved_answers(later.play()), saved);
    assert_eq!(
        [0, 1].map(|question| later.play().answers().answer(later.play().basis(), question)),
        [0, 1].map(|question| desk.play().answers().answer(desk.play().basis(), question))
    );
    let text = r#"{"meniscus":3,"since":7,"item":{"answer":{"typed":"9.81 m/s²","grade":"scale","revealed":true}}}"#;
    let (since, item) = Item::read(text).unwrap();
    assert_eq!(since, 7);
    assert!(desk::restore_answer(later.play_mut(), &saved[0].0, &item));
    let answer = later.play().answers().answer(later.play().basis(), 0);
    assert_eq!((answer.typed.as_str(), answer.shown), ("9.81 m/s²", Some(0)));
    assert_eq!(answer.verdict.map(|verdict| verdict.grade), Some(Grade::WrongScale));
    let with_shown = text.replace("\"revealed\"", "\"shown\":0,\"revealed\"");
    assert_eq!(desk::saved_answers(later.play())[0].1.write(7), with_shown);
}

/// A record with every possible setting.
fn record() -> Desk {
    let mut desk = linear();
    let id = desk.add_record("a \"b\".txt", "t y [cm]\n0 1\n0.5 3\n1 2\n1.5 4\n2 1\n2.5 3\n3 2\n".as_bytes()).unwrap();
    desk.change_records(|records, open| records.set_unit(open, id, 0, "ms")).unwrap();
    desk.change_records(|records, open| records.make_derivatives(open, id, 1, Differentiation::Central)).unwrap();
    desk.change_records(|records, _| records.show(id, false));
    desk
}

#[test]
fn a_record_is_stored_as_json() {
    let saved = record().records().saved();
    assert_eq!(
        saved[0].1.write(1_763_812_800_000),
        concat!(
            r#"{"meniscus":3,"since":1763812800000,"item":{"record":{"name":"a \"b\".txt","#,
            r#""text":"t y [cm]\n0 1\n0.5 3\n1 2\n1.5 4\n2 1\n2.5 3\n3 2\n","hidden":true,"#,
            r#""columns":[{"column":0,"quantity":"t","unit":"ms","stated":true,"fitted":false}],"#,
            r#""derivatives":[{"column":1,"method":"central"}]}}}"#
        )
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn any_item_reads_back(
        name in "\\PC{0,20}",
        values in prop::collection::vec(any::<f64>(), 1..6),
        since in any::<u64>(),
        grade in prop::option::of("\\PC{0,8}"),
    ) {
        // Finite values are JSON numbers, others are texts.
        let number = |value: &f64| if value.is_finite() { format!("{value:e}") } else { format!("\"{value}\"") };
        let text = serde_json::to_string(&name).unwrap();
        let numbers = values.iter().map(number).collect::<Vec<_>>().join(",");
        let grade = grade.map_or("null".to_owned(), |grade| serde_json::to_string(&grade).unwrap());
        for item in [
            format!(r#"{{"record":{{"name":{text},"text":{text},"truth":[[{text},{}]],"known":[]}}}}"#, number(&values[0])),
            format!(
                r#"{{"fit":{{"documents":[{text}],"task":{{"window":[null,{}],"parameters":[{numbers}],
                "varied":[{{"target":"origin"}},{{"target":{{"offset":3}},"shared":true}}]}},
                "found":{{"values":[{numbers}],"starts":2,"rival":{{"growth":{},"values":[{numbers}]}}}}}}}}"#,
                number(&values[0]), number(&values[0])
            ),
            format!(r#"{{"answer":{{"typed":{text},"grade":{grade}}}}}"#),
        ] {
            let stored = format!(r#"{{"item":{item},"later":[{{}}],"since":{since},"meniscus":3}}"#);
            let (read_since, item) = Item::read(&stored).expect("an item");
            prop_assert_eq!(read_since, since);
            // Compares bits instead of values, because NaN differs from itself.
            let written = item.write(since);
            let (_, again) = Item::read(&written).expect("an item");
            prop_assert_eq!(again.write(since), written.clone());
            for value in values.iter().filter(|value| value.is_finite()).take(1) {
                let json: serde_json::Value = serde_json::from_str(&written).unwrap();
                let fit = &json["item"]["fit"]["task"]["parameters"];
                prop_assert!(fit.is_null() || fit.as_array().unwrap().iter().any(|one| one.as_f64().map(f64::to_bits) == Some(value.to_bits())));
            }
        }
    }

    #[test]
    fn damaged_texts_do_no_harm(which in 0..4_usize, at in any::<prop::sample::Index>(), to in "[0-9e\\-\\[\\]{}\",:a#; \n]{0,4}", cut in any::<bool>()) {
        let mut desk = linear();
        prop_assert_eq!(bring_back_texts(&mut desk, &[OTHER, RECORD, FIT, FIT_OF_TWO]), 4);
        let fits = desk.fits().saved();
        let records = desk.records().saved();
        let sound = [OTHER.to_owned(), FIT_OF_TWO.to_owned(), records[1].1.write(5), fits[1].1.write(5)];
        let text = &sound[which];
        let place = (0..=at.index(text.len())).rev().find(|place| text.is_char_boundary(*place)).unwrap_or(0);
        let rest = if cut { "" } else { text[place..].char_indices().nth(1).map_or("", |(next, _)| &text[place + next..]) };
        let damaged = format!("{}{to}{rest}", &text[..place]);
        let mut later = linear();
        let texts: &[&str] = match which {
            0 => &[&damaged, RECORD, FIT_OF_TWO],
            2 => &[OTHER, &damaged, FIT_OF_TWO],
            _ => &[OTHER, RECORD, &damaged],
        };
        bring_back_texts(&mut later, texts);
        for _ in 0..3 {
            later.advance_fit();
        }
        let saved = (later.records().saved(), later.fits().saved());
        for (_, item) in saved.0.iter().chain(&saved.1) {
            prop_assert!(Item::read(&item.write(0)).is_some());
        }
    }

    #[test]
    fn no_text_does_harm(text in ".{0,60}") {
        let mut desk = utube();
        bring_back_texts(&mut desk, &[&text, &format!("{{{text}}}")]);
    }
}

#[test]
fn hostile_fits_are_left_out_or_fitted() {
    let mut desk = linear();
    bring_back_texts(&mut desk, &[OTHER, RECORD, FIT, FIT_OF_TWO]);
    let (records, fits) = (desk.records().saved(), desk.fits().saved());
    let sound: Vec<String> = fits.iter().map(|(_, fit)| fit.write(1)).collect();
    for (from, to) in [
        (r#"{"parameter":0}"#, r#"{"offset":99}"#),
        (r#"{"parameter":0}"#, r#"{"offset":18446744073709551615}"#),
        (r#"{"parameter":0}"#, r#"{"parameter":1}"#),
        (r#"{"parameter":0}"#, r#""origin""#),
        (r#""parameters":["#, r#""parameters":["NaN"],"x":["#),
        (r#""values":["#, r#""values":["NaN","inf",1e308,-1e308,0],"x":["#),
        (r#""values":["#, r#""values":[],"x":["#),
        (r#""window":["#, r#""window":["NaN","-inf"],"x":["#),
        (r#""window":["#, r#""window":[1e300,-1e300],"x":["#),
        (r#""fixed":[[5"#, r#""fixed":[[0,1],[99,1],[5,"inf"],[5"#),
        (r#""fixed":[[5"#, r#""fixed":[[0"#),
        (r#""name":""#, r#""origin":"NaN","name":""#),
        (r#""name":""#, r#""origin":-1e300,"name":""#),
        (r#""varied":["#, r#""varied":[],"x":["#),
        (r#""records":["#, r#""records":[],"x":["#),
        (r#""quantity":"t""#, r#""quantity":"y""#),
        (r#""quantity":"y""#, r#""quantity":"t""#),
        (r#""fitted":false"#, r#""fitted":true"#),
        (r#""starts":"#, r#""rival":{"growth":"NaN","values":[1]},"starts":"#),
    ] {
        assert!(sound.iter().any(|text| text.contains(from)), "{from}");
        for text in sound.iter().filter(|text| text.contains(from)) {
            let mut later = linear();
            crate::support::bring_back_records(&mut later, &records);
            bring_back_texts(&mut later, &[&text.replace(from, to)]);
            for _ in 0..200 {
                later.advance_fit();
            }
            for fit in later.fits().list() {
                later.fits().detail(fit.id);
            }
            assert!(later.fits().list().len() <= 1);
        }
    }
}

#[test]
fn what_is_nested_or_long_without_end_is_refused() {
    assert_eq!(Item::read(&format!("{{\"item\":{}", "[".repeat(1 << 20))), None);
    assert_eq!(Item::read(&format!("{{\"meniscus\":3,\"since\":1,\"item\":{}1", "{\"record\":".repeat(100_000))), None);
    let long =
        format!("{{\"meniscus\":3,\"since\":1,\"item\":{{\"answer\":{{\"typed\":\"{}\"}}}}}}", "1".repeat(9 << 20));
    assert_eq!(Item::read(&long), None);
    // Repeated derivatives of one column count once.
    let text = record().records().saved()[0].1.write(0);
    let one = r#"{"column":1,"method":"central"}"#;
    let many = text.replace(one, &vec![one; 1000].join(","));
    let mut desk = linear();
    assert_eq!(bring_back_texts(&mut desk, &[&many]), 1);
    assert_eq!(desk.records().list()[0].columns.len(), 4);
}
