//! What an answer is worth.

use program::Tolerance;

/// What an answer is worth, and in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The grade.
    pub grade: Grade,
    /// In the chosen language.
    pub text: String,
}

/// The grades.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// Within the tolerance.
    Correct,
    /// Within five times the tolerance.
    Close,
    /// The size is right, the sign is not.
    WrongSign,
    /// Right but for a power of ten: most likely the unit.
    WrongScale,
    /// Off.
    Wrong,
    /// Not an answer: no number, an unknown unit, or a unit of something else.
    Unreadable,
    /// There is no answer for the present parameters: `omega_d` when overdamped.
    Unanswerable,
}

impl Grade {
    const CODES: [(Self, &str); 7] = [
        (Self::Correct, "correct"),
        (Self::Close, "close"),
        (Self::WrongSign, "sign"),
        (Self::WrongScale, "scale"),
        (Self::Wrong, "wrong"),
        (Self::Unreadable, "unreadable"),
        (Self::Unanswerable, "unanswerable"),
    ];

    /// The word under which it is stored.
    pub fn code(self) -> &'static str {
        Self::CODES.iter().find(|(grade, _)| *grade == self).map_or("", |(_, code)| code)
    }

    /// What [`Grade::code`] has written.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::CODES.iter().find(|(_, own)| *own == code).map(|(grade, _)| *grade)
    }
}

/// How many tolerances away an answer is still close.
const CLOSE: f64 = 5.0;

/// What `given` is worth where `right` is asked for (both SI).
pub(super) fn grade(given: f64, right: f64, tolerance: Tolerance) -> Grade {
    let wider = match tolerance {
        Tolerance::Relative(fraction) => Tolerance::Relative(fraction * CLOSE),
        Tolerance::Absolute(amount) => Tolerance::Absolute(amount * CLOSE),
    };
    let scaled = |power: i32| {
        let factor: f64 = format!("1e{power}").parse().unwrap_or(1.0);
        right != 0.0 && tolerance.accepts(given * factor, right)
    };
    if !right.is_finite() {
        Grade::Unanswerable
    } else if tolerance.accepts(given, right) {
        Grade::Correct
    } else if tolerance.accepts(-given, right) {
        Grade::WrongSign
    } else if wider.accepts(given, right) {
        Grade::Close
    } else if [-6, -3, -2, -1, 1, 2, 3, 6].into_iter().any(scaled) {
        Grade::WrongScale
    } else {
        Grade::Wrong
    }
}
