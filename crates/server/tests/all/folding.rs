//! The fold over events.

use crate::client::parts;
use proptest::prelude::*;
use serde_json::Value;
use server::fold::{Folded, PART};
use server::store::EventRow;

/// Three savings of a hand-in, as the store has them.
fn rows() -> Vec<EventRow> {
    let all = [parts(1, "1", "wrong"), parts(7, "2", "wrong"), parts(13, "4.5", "correct")].concat();
    let row = |(part, number): (&Value, u64)| EventRow {
        number,
        seat: 1,
        seq: part["seq"].as_u64().unwrap(),
        at: 1_000_000 + number,
        kind: PART.to_owned(),
        body: serde_json::json!({ "document": part["document"], "part": part["part"], "value": part["value"] })
            .to_string(),
    };
    all.iter().zip(1..).map(row).collect()
}

proptest! {
    #[test]
    fn order_and_repetition_change_nothing(order in proptest::collection::vec(0usize..18, 0..60)) {
        let rows = rows();
        let expected = Folded::of(&rows).hand_in("tube.md", "blue heron 1").unwrap();
        // Every event arrives at last, in whatever order and however often.
        let missing = (0..18).rev().filter(|index| !order.contains(index));
        let shuffled: Vec<&EventRow> = order.iter().copied().chain(missing).map(|index| &rows[index]).collect();
        prop_assert_eq!(Folded::of(shuffled).hand_in("tube.md", "blue heron 1").unwrap(), expected);
    }

    #[test]
    fn no_body_stops_the_fold(body in ".*", kind in "part|settings") {
        let row = EventRow { number: 1, seat: 1, seq: 1, at: 0, kind, body };
        let _ = Folded::of([&row]).hand_in("tube.md", "a");
    }
}

#[test]
fn an_incomplete_hand_in_is_none() {
    let rows = rows();
    for left_out in ["documents", "state", "item:q1", "order", "head"] {
        let rest = rows.iter().filter(|row| !row.body.contains(&format!("\"part\":\"{left_out}\"")));
        assert_eq!(Folded::of(rest).hand_in("tube.md", "a"), None, "{left_out}");
    }
}
