//! Comparison of stated values with computed ones.

use super::difference::{BeyondLimit, Difference, GradeDifference, shortened};
use super::stated::{Stated, sender_differences, stated_facts};
use saved::Number;
use saved::hand_in::{FOLLOWS_NOT, Fact, FactValue, HandIn, Part};
use std::collections::BTreeMap;
use units::{Language, Words, say, words};

/// Relative deviation allowed between programs whose results may have other bits.
const TOLERANCE: f64 = 1e-6;

/// Program whose results may have other bits than those of this program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OtherBits {
    /// Version that it states.
    pub version: String,
    /// Number of its bits; `None` if it states none.
    pub bits: Option<u32>,
}

/// Result of a verification.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Number of stated values that were computed again with the same result.
    pub equal: usize,
    /// Stated values that do not follow from the work.
    pub differences: Vec<Difference>,
    /// Answers whose stated grade does not follow.
    pub grades: Vec<GradeDifference>,
    /// Questions with more attempts than the document allows.
    pub beyond: Vec<BeyondLimit>,
    /// Number of grades and of looks at right answers that cannot be computed, since work of versions up to 0.2.0 lacks the values
    /// at that time. They count as stated.
    pub unknown: usize,
    /// Number of parts of the work that could not be restored.
    pub refused: usize,
    /// Program that made the hand-in, if the bits of its results may be others; numbers may then differ by the relative
    /// deviation 1e-6.
    pub other_bits: Option<OtherBits>,
}

impl Verdict {
    /// True if every stated value follows from the work.
    pub fn holds(&self) -> bool {
        self.differences.is_empty() && self.grades.is_empty() && self.refused == 0
    }

    /// Description in lines: the number of equal values, other bits, refused parts, and each difference.
    pub fn lines(&self, language: Language) -> Vec<String> {
        let (equal, all) = (self.equal, self.equal + self.differences.len());
        let mut lines = vec![if self.differences.is_empty() {
            say!(language, "{equal} values computed again, all equal")
        } else {
            say!(language, "{equal} of {all} values equal")
        }];
        lines.extend(self.other_bits.as_ref().map(|other| other.text(language)));
        if self.refused > 0 {
            let refused = self.refused;
            lines.push(say!(language, "parts of the work that could not be restored: {refused}"));
        }
        if self.unknown > 0 {
            let unknown = self.unknown;
            lines.push(say!(
                language,
                "grades and looks at answers that count as stated, since versions up to 0.2.0 did not keep the values at that time: {unknown}"
            ));
        }
        lines.extend(self.beyond.iter().map(|beyond| beyond.text(language)));
        lines.extend(self.grades.iter().map(|grade| grade.text(language)));
        lines.extend(self.differences.iter().map(|difference| difference.text(language)));
        lines
    }
}

impl OtherBits {
    /// Program that made a hand-in, if its results may have other bits.
    fn of(hand_in: &HandIn) -> Option<Self> {
        let differ = hand_in.bits != Some(program::BITS);
        differ.then(|| Self { version: hand_in.program.clone(), bits: hand_in.bits })
    }

    /// One line: why numbers are compared within a tolerance.
    fn text(&self, language: Language) -> String {
        let (version, here) = (shortened(&self.version), program::BITS);
        match self.bits {
            Some(bits) => say!(
                language,
                "made by version {version}, whose results have bits {bits} (here {here}): numbers are compared to a relative deviation of 1e-6"
            ),
            None => say!(
                language,
                "made by version {version}, which does not state the bits of its results (here {here}): numbers are compared to a \
                 relative deviation of 1e-6"
            ),
        }
    }
}

/// Explanation of what a verification shows and what it does not.
pub fn meaning() -> Words {
    words("Equal values follow from the data of the hand-in. This does not show who took the data or did the work.")
}

/// Compares the values of a hand-in with those computed from its work. `refused`: number of parts of the work that could
/// not be restored. Values are compared exactly if the hand-in states the bits of this program's results.
pub fn compare(hand_in: &HandIn, computed: &[Fact], refused: usize) -> Verdict {
    let other_bits = OtherBits::of(hand_in);
    let (grades, mut unknown) = GradeDifference::all(computed);
    let Stated { facts, omitted, looks } = stated_facts(hand_in);
    unknown += looks;
    let computed_facts = computed.iter().filter(|fact| !omitted(fact));
    let mut rest: BTreeMap<(Part, &str, &str), &FactValue> =
        computed_facts.chain(&hand_in.page).map(|fact| (key(fact), &fact.value)).collect();
    let (mut equal, mut differences) = (0, sender_differences(hand_in, computed));
    // The data that were saved from a report stand without its page.
    for fact in facts.iter().filter(|fact| fact.part != Part::Report || !hand_in.page.is_empty()) {
        let value = rest.remove(&key(fact));
        if value.is_some_and(|value| is_equal(fact, value, other_bits.is_some())) {
            equal += 1;
        } else {
            differences.push(difference(key(fact), Some(&fact.value), value));
        }
    }
    differences.extend(rest.into_iter().map(|(key, value)| difference(key, None, Some(value))));
    let beyond = BeyondLimit::all(computed);
    Verdict { equal, differences, grades, beyond, unknown, refused, other_bits }
}

fn key(fact: &Fact) -> (Part, &str, &str) {
    (fact.part, &fact.item, &fact.quantity)
}

fn difference(
    (part, item, quantity): (Part, &str, &str),
    stated: Option<&FactValue>,
    computed: Option<&FactValue>,
) -> Difference {
    Difference {
        part,
        item: item.to_owned(),
        quantity: quantity.to_owned(),
        stated: stated.cloned(),
        computed: computed.cloned(),
    }
}

/// True if a stated value is the computed one, for other bits within the tolerance.
fn is_equal(Fact { part, quantity, value: stated, .. }: &Fact, computed: &FactValue, has_other_bits: bool) -> bool {
    let is_of_film = |name: &str| *part == Part::Film && quantity == name;
    match (stated, computed) {
        (_, FactValue::Text(text)) if is_of_film("record") && text == FOLLOWS_NOT => false,
        // The hash of a computed table; its means are compared.
        (FactValue::Text(_), FactValue::Text(_)) if has_other_bits && is_of_film("table") => true,
        (FactValue::Number(Number(one)), FactValue::Number(Number(other))) if has_other_bits && stated != computed => {
            (one - other).abs() <= TOLERANCE * other.abs()
        }
        _ => stated == computed,
    }
}
