//! The hand-ins of a class together: those that count, tallies of answers, groups that are stuck, reports.

use crate::support::{answered, handed, measured, report};
use class::collection::{Calculator, Collection, Entry, Snapshot, Snapshots, State, WorkOrder};
use class::page::{count_text, html, progress_text, stuck, workbook};
use class::verify::hand_in;
use desk::play::Grade;
use saved::hand_in::{Fact, HandIn, HandInError, Sender};
use units::Language;

fn of(name: &str, rows: &[(f64, f64)], answers: &[&str]) -> HandIn {
    let sender = Sender { name: name.to_owned(), ..Sender::default() };
    hand_in(answered(rows, answers), sender, 1_763_812_900_000).unwrap()
}

/// A collection of these hand-ins, computed.
fn computed(hand_ins: &[HandIn]) -> Collection {
    let mut collection = Collection::new(Language::English);
    for (index, one) in hand_ins.iter().enumerate() {
        collection.add(&format!("{index}.hand-in"), HandIn::read(&one.write()));
    }
    while collection.advance() {}
    assert_eq!(collection.waiting(), 0);
    collection
}

#[test]
fn of_repeated_hand_ins_the_last_counts_and_all_are_kept() {
    let early = handed(&measured(1), "fox");
    let late = HandIn { made: early.made + 1, ..handed(&measured(2), "fox") };
    let other = handed(&measured(3), "heron");
    // In whatever order they arrive.
    for order in [[0, 1, 2], [1, 0, 2], [2, 1, 0], [1, 2, 0]] {
        let all = [&early, &late, &other];
        let mut collection = Collection::new(Language::English);
        for index in order {
            collection.add(&format!("{index}.hand-in"), HandIn::read(&all[index].write()));
            // Some are computed before the next one arrives.
            if index == 0 {
                while collection.advance() {}
            }
        }
        collection.add("notes.hand-in", HandIn::read("[]"));
        collection.add("cut.hand-in", HandIn::read(&early.write()[..500]));
        while collection.advance() {}
        let counting: Vec<&str> = collection.works().map(|(index, _)| collection.entries()[index].file()).collect();
        assert_eq!(counting.len(), 2, "{order:?}");
        assert!(counting.contains(&"1.hand-in") && counting.contains(&"2.hand-in"), "{counting:?}");
        let repeated: Vec<&Entry> =
            collection.entries().iter().filter(|entry| matches!(entry.state(), State::Repeated(_))).collect();
        assert_eq!(repeated.len(), 1);
        let State::Repeated(counts) = repeated[0].state() else { panic!() };
        assert_eq!((repeated[0].file(), collection.entries()[*counts].file()), ("0.hand-in", "1.hand-in"));
        let unreadable = |entry: &&Entry| matches!(entry.state(), State::Unreadable(_));
        assert_eq!(collection.entries().iter().filter(unreadable).count(), 2);
        assert!(collection.copies().is_empty());
    }
}

#[test]
fn answers_are_told_apart_by_error_with_examples() {
    let class = computed(&[
        of("a", &measured(1), &["420", "0.42"]),
        of("b", &measured(2), &["-0.42", "-0.42 1/s", "-0.420"]),
        of("c", &measured(3), &["7", "8", "9"]),
        of("d", &measured(4), &["0.42"]),
        of("e", &measured(5), &[]),
    ]);
    // The right answer is the fitted value, near 0.42, which the fit has put into the sliders.
    let questions = class.questions();
    let [tally] = questions.as_slice() else { panic!("{questions:?}") };
    assert_eq!((tally.first.count, tally.first.of), (1, 4));
    assert_eq!((tally.found.count, tally.found.of, tally.without), (2, 4, 1));
    let kind = |grade: Grade| tally.errors.iter().find(|kind| kind.grade == grade);
    let signs = kind(Grade::WrongSign).unwrap();
    assert_eq!((signs.groups, signs.examples.len()), (1, 3), "{tally:?}");
    assert!(signs.examples[0].1.starts_with("0.4"), "{tally:?}");
    // Three answers wrong in the same way: the group is stuck. The first group is not.
    let stuck = class.stuck(&class.quantities());
    let who: Vec<usize> = stuck.iter().map(|one| one.hand_in).collect();
    assert!(who.contains(&1) && !who.contains(&0) && !who.contains(&3), "{stuck:?}");
}

#[test]
fn curves_and_results_of_a_class_are_reported() {
    let mut hand_ins: Vec<HandIn> =
        (1..=9).map(|seed| of(&format!("group {seed}"), &measured(seed), &["0.3"])).collect();
    // One group has copied, one has taken half the times: its rate is twice as large.
    let copied: Vec<(f64, f64)> = measured(1).iter().map(|(time, level)| (*time, 2.0 * level)).collect();
    hand_ins.push(of("copy", &copied, &["0.3"]));
    let fast: Vec<(f64, f64)> = measured(20).iter().map(|(time, level)| (0.5 * time, *level)).collect();
    hand_ins.push(of("twice", &fast, &["0.3"]));
    hand_ins[3].facts.pop();
    let class = computed(&hand_ins);
    assert_eq!(class.copies().len(), 1, "{:?}", class.copies());
    let groups = class.curve_groups();
    assert_eq!((groups[0].quantity.name.as_str(), groups[0].members.len()), ("y", 11));
    assert!(class.typical_fit(&groups[0]).is_some());
    let quantities = class.quantities();
    let gamma = quantities.iter().find(|one| one.name == "gamma").unwrap();
    let pool = gamma.pool.as_ref().unwrap();
    assert_eq!(pool.outliers.iter().map(|one| one.index).collect::<Vec<_>>(), [10], "{pool:?}");
    let page = html(&class, &[], Language::English, "");
    for expected in [
        "11 groups",
        "twice or half as large",
        "the same data, shifted or scaled: group 1",
        "Without those far from the others, n = 10",
        " values equal<br>",
    ] {
        assert!(page.contains(expected), "{expected}");
    }
    assert!(html(&class, &[], catalogues::with(Language::Spanish), "").contains("el doble o la mitad"));
    assert!(workbook(&class, Language::English).starts_with(b"PK"));
}

#[test]
fn snapshots_are_shown_in_order_and_without_names() {
    let class = computed(&[of("Ana", &measured(1), &["1"]), of("Bob", &measured(2), &["2"])]);
    let members = class.curve_groups()[0].members.clone();
    let mut snapshots = Snapshots::default();
    for member in members.iter().rev() {
        assert!(snapshots.toggle(Snapshot::Curve(*member)));
    }
    assert!(snapshots.toggle(Snapshot::Answer { hand_in: 1, answer: 0 }));
    assert_eq!(snapshots.letters(), ["A", "B", "A"]);
    snapshots.move_up(2);
    assert_eq!(snapshots.list()[1], Snapshot::Answer { hand_in: 1, answer: 0 });
    assert!(!snapshots.toggle(Snapshot::Curve(members[1])));
    assert_eq!(snapshots.letters(), ["A", "B"]);
    snapshots.retain(&Collection::new(Language::English));
    assert!(snapshots.list().is_empty());
}

#[test]
fn reports_have_no_sender_and_each_counts() {
    let class = computed(&[of("", &measured(1), &[]), of("", &measured(2), &[]), of("heron", &measured(3), &[])]);
    assert_eq!(class.works().count(), 3);
    let shown: Vec<&str> = class.entries().iter().map(Entry::sender).collect();
    assert_eq!(shown, ["0.hand-in", "1.hand-in", "heron"]);
}

/// The state of a hand-in whose runs were all kept without a change between them.
#[test]
fn the_same_run_again_and_again_is_named() {
    let mut same = of("runs", &measured(1), &[]);
    let mut other = of("others", &measured(2), &[]);
    let run = same.work.state.split_once('&').map_or("", |(_, run)| run).to_owned();
    same.work.state += &format!("&k&{run}").repeat(5);
    other.work.state += &format!("&k&{run}").repeat(4);
    let class = computed(&[same, other]);
    let stuck = class.stuck(&class.quantities());
    let reasons = |hand_in: usize| {
        stuck.iter().filter(|one| one.hand_in == hand_in).map(|one| one.why.text(Language::English)).collect::<Vec<_>>()
    };
    assert!(reasons(0).contains(&"the same run was kept 5 times".into()), "{stuck:?}");
    assert!(reasons(1).iter().all(|why| !why.contains("the same")), "{stuck:?}");
}

#[test]
fn the_progress_is_stated_and_data_are_compared_after_all_are_computed() {
    let hand_ins = [1, 2, 1].map(|seed| of(&format!("seed {seed}"), &measured(seed), &["7", "8", "9"]));
    let mut class = Collection::new(Language::English);
    for (name, hand_in) in ["a", "b", "c"].iter().zip(&hand_ins) {
        let sender = Sender { name: (*name).to_owned(), ..Sender::default() };
        class.add(name, Ok(HandIn { sender, ..hand_in.clone() }));
    }
    let said = |class: &Collection| stuck(class, &class.quantities(), Language::English);
    assert!(said(&class).contains("Being computed: 0 of 3 hand-ins are done.") && !said(&class).contains("No group"));
    while class.waiting() > 1 {
        assert!(class.advance());
        assert!(class.copies().is_empty());
    }
    let listed = said(&class);
    assert!(listed.contains("2 of 3 hand-ins") && listed.contains("a: question 1: 3 answers wrong"), "{listed}");
    assert_eq!(count_text(&class, Language::English), "2 groups, 1 still to be computed");
    while class.waiting() > 0 {
        class.advance();
    }
    assert_eq!(progress_text(&class, Language::English), None);
    assert_eq!(count_text(&class, Language::English), "3 groups, looking for shared data: 3 to go");
    while class.advance() {}
    assert_eq!((class.uncompared(), class.copies().len()), (0, 1));
    assert_eq!(count_text(&class, catalogues::with(Language::Spanish)), "3 grupos");
}

#[test]
fn of_the_pages_of_a_folder_those_without_data_are_left_out() {
    for (name, is_candidate) in [("a.hand-in", true), ("A.HTM", true), ("b.html", true), ("b.csv", false), ("b", false)]
    {
        assert_eq!(Collection::is_candidate(name), is_candidate, "{name}");
    }
    let mut class = Collection::new(Language::English);
    assert!(!class.add_of_folder("notes.html", HandIn::open(b"<html><body>notes</body></html>")));
    assert!(class.add_of_folder("report.html", HandIn::open(report(&measured(1)).as_bytes())));
    assert!(class.add_of_folder("cut.hand-in", Err(HandInError::Damaged)));
    while class.advance() {}
    assert_eq!((class.entries().len(), class.works().count()), (2, 1));
}

#[test]
fn what_is_computed_elsewhere_is_what_is_computed_here() {
    let film = crate::support::with_film(handed(&measured(4), "kite"), &measured(4));
    let damaged = HandIn { facts: Vec::new(), ..handed(&measured(5), "owl") };
    let mut broken = handed(&measured(6), "broken");
    broken.work.documents[0].text = "no document".to_owned();
    let hand_ins = [of("a", &measured(1), &["420", "0.42"]), of("b", &measured(2), &["7"]), film, damaged, broken];
    let here = computed(&hand_ins);
    // Two workers; the one with the later hand-ins is ready first.
    let mut collection = Collection::new(Language::English);
    for (index, one) in hand_ins.iter().enumerate() {
        collection.add(&format!("{index}.hand-in"), HandIn::read(&one.write()));
    }
    let mut orders: Vec<(usize, WorkOrder)> = std::iter::from_fn(|| collection.order()).collect();
    assert_eq!(orders.len(), hand_ins.len());
    assert!(!collection.advance(), "what is ordered is not computed here");
    let early = orders.split_off(2);
    let mut delivered = 0;
    for part in [early, orders] {
        let mut calculator = Calculator::default();
        for (index, order) in part {
            let bytes = postcard::to_allocvec(&calculator.compute(&order)).unwrap();
            collection.deliver(index, postcard::from_bytes(&bytes).unwrap());
            delivered += 1;
            assert_eq!(collection.waiting(), hand_ins.len() - delivered);
        }
    }
    while collection.advance() {}
    let [elsewhere, here] = [&collection, &here].map(|all| html(all, &[], Language::English, ""));
    assert_eq!(elsewhere, here);
    // A delivery that comes too late is not taken; a hand-in that is taken back is computed here.
    collection.clear();
    collection.deliver(0, None);
    assert_eq!(collection.entries().len(), 0);
    collection.add("0.hand-in", HandIn::read(&hand_ins[0].write()));
    let (index, _) = collection.order().unwrap();
    collection.take_back(index);
    collection.fail(index);
    while collection.advance() {}
    assert_eq!(collection.works().count(), 1, "what is not ordered does not fail");
    collection.add("1.hand-in", HandIn::read(&hand_ins[1].write()));
    let (index, _) = collection.order().unwrap();
    collection.fail(index);
    while collection.advance() {}
    let State::Unreadable(why) = collection.entries()[1].state() else { panic!("it has failed") };
    assert!(why.english().contains("fault in the program"), "{why:?}");
}

#[test]
fn a_later_form_of_a_file_replaces_the_former_one_in_a_lesson() {
    let early = handed(&measured(1), "fox");
    let late = HandIn { made: early.made + 1, ..handed(&measured(2), "fox") };
    let mut collection = Collection::new(Language::English);
    for hand_in in [&early, &late, &late] {
        collection.update("fox.hand-in", HandIn::read(&hand_in.write()));
        while collection.advance() {}
        assert_eq!((collection.entries().len(), collection.works().count()), (1, 1));
    }
    assert_eq!(collection.entries()[0].hand_in(), Some(&late));
    assert!(collection.copies().is_empty(), "a former form is no copy");
}

/// The fitted values of the only hand-in.
fn facts(collection: &Collection) -> Vec<Fact> {
    let mut works = collection.works();
    let facts = works.next().unwrap().1.facts.clone();
    assert!(works.next().is_none());
    facts
}

#[test]
fn a_group_keeps_its_last_state_until_the_new_one_is_computed() {
    let forms: Vec<HandIn> = (1..5).map(|seed| handed(&measured(seed), "fox")).collect();
    let read = |form: usize| HandIn::read(&forms[form].write());
    let alone = |form: usize| {
        let mut collection = Collection::new(Language::English);
        collection.add("fox.hand-in", read(form));
        while collection.advance() {}
        facts(&collection)
    };
    let expected: Vec<Vec<Fact>> = (0..forms.len()).map(alone).collect();
    let mut collection = Collection::new(Language::English);
    collection.update("fox.hand-in", read(0));
    while collection.advance() {}

    // Here: a form that arrives while the one before is computed.
    collection.update("fox.hand-in", read(1));
    assert_eq!((facts(&collection), collection.waiting(), collection.computed()), (expected[0].clone(), 1, 0));
    collection.advance();
    collection.update("fox.hand-in", read(2));
    let mut seen = vec![facts(&collection)];
    while collection.advance() {
        let now = facts(&collection);
        if seen.last() != Some(&now) {
            seen.push(now);
        }
    }
    assert_eq!(seen, expected[..3]);
    assert_eq!((collection.waiting(), collection.computed()), (0, 1));

    // Elsewhere: the answer for a form that is superseded is shown, and the last form is ordered.
    collection.update("fox.hand-in", read(1));
    let mut calculator = Calculator::default();
    let (index, order) = collection.order().unwrap();
    collection.update("fox.hand-in", read(3));
    assert!(collection.order().is_none(), "one order at a time");
    collection.deliver(index, calculator.compute(&order));
    assert_eq!((facts(&collection), collection.waiting()), (expected[1].clone(), 1));
    let (index, order) = collection.order().unwrap();
    collection.deliver(index, calculator.compute(&order));
    while collection.advance() {}
    assert_eq!((facts(&collection), collection.waiting()), (expected[3].clone(), 0));
}
