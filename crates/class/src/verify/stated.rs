//! Stated values of hand-ins of all versions.

use super::difference::Difference;
use saved::Number;
use saved::hand_in::{Fact, FactValue, HandIn, Part, fact_of_version_1};
use std::borrow::Cow;

/// The facts that a hand-in states, with identifiers.
pub(super) struct Stated<'a> {
    pub facts: Cow<'a, [Fact]>,
    /// True for a computed fact that a hand-in of this version does not state.
    pub omitted: fn(&Fact) -> bool,
    /// Number of looks at right answers whose time is unknown.
    pub looks: usize,
}

/// The stated facts. Those of version 1 get identifiers; that version stated neither seats nor grades by the values of an attempt.
pub(super) fn stated_facts(hand_in: &HandIn) -> Stated<'_> {
    if hand_in.version > 1 {
        return Stated { facts: Cow::Borrowed(&hand_in.facts), omitted: |_| false, looks: 0 };
    }
    let is_look = |fact: &&Fact| fact.part == Part::Answer && fact.quantity == "right answer";
    let facts = hand_in.facts.iter().filter(|fact| !is_look(fact)).map(fact_of_version_1).collect();
    let omitted = |fact: &Fact| match fact.part {
        Part::Answer => {
            ["shown", "allowed", "made"].contains(&fact.quantity.as_str()) || fact.quantity.starts_with("grade:")
        }
        Part::Run => ["seat", "assignment"].contains(&fact.quantity.as_str()),
        _ => false,
    };
    Stated { facts: Cow::Owned(facts), omitted, looks: hand_in.facts.iter().filter(is_look).count() }
}

/// Differences between the seat and the assignment of the sender and those of the run. A document without assigned values has none.
pub(super) fn sender_differences(hand_in: &HandIn, computed: &[Fact]) -> Vec<Difference> {
    let of_run = |quantity: &str| computed.iter().find(|fact| fact.part == Part::Run && fact.quantity == quantity);
    let Some(assignment) = of_run("assignment") else { return Vec::new() };
    let (sender, seat) = (&hand_in.sender, of_run("seat").map(|fact| &fact.value));
    let stated_seat = sender.seat.map(|number| FactValue::Number(Number(number.into())));
    let stated_assignment =
        Some(&sender.assignment).filter(|name| !name.is_empty()).map(|name| FactValue::Text(name.clone()));
    let difference = |quantity: &str, stated: &Option<FactValue>, computed: Option<&FactValue>| Difference {
        part: Part::Run,
        item: assignment.item.clone(),
        quantity: quantity.to_owned(),
        stated: stated.clone(),
        computed: computed.cloned(),
    };
    let mut differences = Vec::new();
    if stated_seat.as_ref() != seat {
        differences.push(difference("seat", &stated_seat, seat));
    }
    if stated_assignment.as_ref().is_some_and(|stated| *stated != assignment.value) {
        differences.push(difference("assignment", &stated_assignment, Some(&assignment.value)));
    }
    differences
}
