//! Versions of a text: thinning of the history, and comparison.

use std::collections::BTreeMap;
use units::order::sort;

/// Added to the age of a version, in milliseconds, so that versions of the last minutes have nearly the same weight.
const RECENT: u64 = 300_000;

/// Indices of the versions to delete so that at most `most` remain, but at least 2. `times`: ascending, in
/// milliseconds, like `now`. Each step deletes the version with the smallest distance between its neighbours relative
/// to its age, so that gaps grow with age. The first and the last version are kept.
pub fn superfluous_versions(times: &[u64], now: u64, most: usize) -> Vec<usize> {
    let mut kept: Vec<usize> = (0..times.len()).collect();
    let mut given_up = Vec::new();
    while kept.len() > most.max(2) {
        let gap = |window: &[usize]| {
            let time = |place: usize| window.get(place).and_then(|index| times.get(*index)).copied().unwrap_or(now);
            let age = now.saturating_sub(time(1)).saturating_add(RECENT);
            time(2).saturating_sub(time(0)) as f64 / age as f64
        };
        let narrowest = kept.windows(3).map(gap).enumerate().min_by(|(_, one), (_, other)| one.total_cmp(other));
        let Some((place, _)) = narrowest else { break };
        given_up.push(kept.remove(place + 1));
    }
    sort(&mut given_up);
    given_up
}

/// Number of lines that differ between two versions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LineChanges {
    /// Number of lines that only the later version has.
    pub added: usize,
    /// Number of lines that only the earlier version has.
    pub removed: usize,
}

/// Counts the lines that differ between all texts of two versions. Moved lines do not count.
pub fn line_changes<'a>(
    before: impl IntoIterator<Item = &'a str>,
    after: impl IntoIterator<Item = &'a str>,
) -> LineChanges {
    let mut counts: BTreeMap<&str, i64> = BTreeMap::new();
    for line in before.into_iter().flat_map(str::lines) {
        *counts.entry(line).or_default() -= 1;
    }
    for line in after.into_iter().flat_map(str::lines) {
        *counts.entry(line).or_default() += 1;
    }
    let sum = |sign: i64| counts.values().map(|count| usize::try_from(sign * count).unwrap_or(0)).sum();
    LineChanges { added: sum(1), removed: sum(-1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_wherever_they_stand() {
        let cases: [(&str, &str, usize, usize); 6] = [
            ("", "", 0, 0),
            ("a\nb\n", "b\na", 0, 0),
            ("a\nb\nc", "a\nB\nc", 1, 1),
            ("a", "a\na\na", 2, 0),
            ("a\n\nb\n", "", 0, 3),
            ("a\r\nb", "a\nb", 0, 0),
        ];
        for (before, after, added, removed) in cases {
            assert_eq!(line_changes([before], [after]), LineChanges { added, removed }, "{before:?} {after:?}");
        }
        assert_eq!(line_changes(["a", "b"], ["a", "c"]), LineChanges { added: 1, removed: 1 });
    }

    #[test]
    fn versions_are_thinned_with_age() {
        const MINUTE: u64 = 60_000;
        // One version per minute for a day, thinned after each.
        let mut times: Vec<u64> = Vec::new();
        for minute in 0..1440 {
            let now = minute * MINUTE;
            times.push(now);
            let given_up = superfluous_versions(&times, now, 50);
            let mut place = 0;
            times.retain(|_| {
                place += 1;
                !given_up.contains(&(place - 1))
            });
            assert!(times.len() <= 50);
        }
        let now = 1439 * MINUTE;
        assert_eq!((times[0], times[49]), (0, now), "the first and the last stay");
        let within = |minutes: u64| times.iter().filter(|time| now - **time <= minutes * MINUTE).count();
        assert!(within(10) >= 8, "{} of the last ten minutes", within(10));
        assert!((10..=35).contains(&within(60)), "{} of the last hour", within(60));
        let gaps: Vec<u64> = times.windows(2).map(|pair| (pair[1] - pair[0]) / MINUTE).collect();
        assert!(*gaps.iter().max().unwrap() <= 240, "no gap is longer than four hours: {gaps:?}");
    }

    #[test]
    fn odd_times_do_no_harm() {
        assert!(superfluous_versions(&[], 0, 50).is_empty());
        assert_eq!(superfluous_versions(&[5, 5, 5, 5], 0, 0), vec![1, 2]);
        assert_eq!(superfluous_versions(&[u64::MAX, 0, u64::MAX], u64::MAX, 2), vec![1]);
    }
}
