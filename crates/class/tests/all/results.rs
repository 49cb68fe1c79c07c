//! Results of a class from its hand-ins.

use crate::support::{handed, measured};

#[test]
fn the_pooled_damping_of_six_groups_is_the_true_one() {
    let hand_ins: Vec<_> = (0..6).map(|seed| (seed, handed(&measured(seed as u64), "group").facts)).collect();
    let facts = |most: usize| hand_ins.iter().take(most).map(|(index, facts)| (*index, facts.as_slice()));
    let quantities = class::results::quantities(facts(6));
    let gamma = quantities.iter().find(|one| one.theory == "Linear damping" && one.name == "gamma").unwrap();
    assert_eq!(gamma.results.iter().map(|(index, _)| *index).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5]);
    assert_eq!(gamma.unit, "1/s");
    let pool = gamma.pool.as_ref().unwrap();
    let (low, high) = pool.all.interval;
    assert!(low < 0.42 && 0.42 < high && high - low < 0.02, "{pool:?}");
    // A single group has a result, but no pooled value.
    let alone = class::results::quantities(facts(1));
    assert!(alone.iter().all(|one| one.results.len() == 1 && one.pool.is_err()));
    assert!(class::results::quantities(facts(0)).is_empty());
}
