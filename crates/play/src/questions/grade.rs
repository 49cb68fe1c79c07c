//! Grading of answers.

use program::Tolerance;
use serde::{Deserialize, Serialize};

/// The grade of an answer, with its text.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The grade.
    pub grade: Grade,
    /// Text in the chosen language.
    pub text: String,
}

/// Grade of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grade {
    /// Within the tolerance.
    Correct,
    /// Within five times the tolerance.
    Close,
    /// The magnitude is right, the sign is wrong.
    WrongSign,
    /// Right except for a power of ten, probably due to the unit.
    WrongScale,
    /// None of the above.
    Wrong,
    /// Not an answer: no number, an unknown unit, or a unit of another dimension.
    Unreadable,
    /// No answer exists for the present parameters, such as `omega_d` when overdamped.
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

    /// Code for storage.
    pub fn code(self) -> &'static str {
        Self::CODES.iter().find(|(grade, _)| *grade == self).map_or("", |(_, code)| code)
    }

    /// True for an answer that counts as an attempt: it could be read, and there is a right answer.
    pub fn is_attempt(self) -> bool {
        !matches!(self, Self::Unreadable | Self::Unanswerable)
    }

    /// Parses the output of [`Grade::code`].
    pub fn from_code(code: &str) -> Option<Self> {
        Self::CODES.iter().find(|(_, own)| *own == code).map(|(grade, _)| *grade)
    }
}

/// An answer within this multiple of the tolerance is close.
const CLOSE: f64 = 5.0;

/// Grade of the answer `given` if `right` is expected (both SI).
pub(super) fn grade(given: f64, right: f64, tolerance: Tolerance) -> Grade {
    let wider = match tolerance {
        Tolerance::Relative(fraction) => Tolerance::Relative(fraction * CLOSE),
        Tolerance::Absolute(amount) => Tolerance::Absolute(amount * CLOSE),
    };
    let scaled = |power: i32| {
        let factor = units::number::decimal(&format!("1e{power}")).unwrap_or(1.0);
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
