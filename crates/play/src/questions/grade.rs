//! Grading of answers.

use program::Tolerance;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Beginning of the code of partial credit.
const PARTLY: &str = "partly:";

/// The grade of an answer, with its text.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The grade.
    pub grade: Grade,
    /// Text in the chosen language.
    pub text: String,
    /// Remarks of the author on the answer, as HTML of the document.
    pub remarks: Vec<String>,
}

/// Grade of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grade {
    /// Within the tolerance.
    Correct,
    /// A part of what is right, in percent of the credit, from 1 to 99.
    Partly(u8),
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
    /// Grades without partial credit, with their codes.
    const CODES: [(Self, &str); 7] = [
        (Self::Correct, "correct"),
        (Self::Close, "close"),
        (Self::WrongSign, "sign"),
        (Self::WrongScale, "scale"),
        (Self::Wrong, "wrong"),
        (Self::Unreadable, "unreadable"),
        (Self::Unanswerable, "unanswerable"),
    ];

    /// Code for storage: a word, and for partial credit its percent, `partly:67`.
    pub fn code(self) -> Cow<'static, str> {
        match self {
            Self::Partly(percent) => format!("{PARTLY}{percent}").into(),
            _ => Self::CODES.iter().find(|(grade, _)| *grade == self).map_or("", |(_, code)| code).into(),
        }
    }

    /// The grade for this credit, from 0 to 1.
    pub(super) fn of_credit(credit: f64) -> Self {
        match credit {
            1.0.. => Self::Correct,
            0.0 => Self::Wrong,
            _ => Self::Partly((credit * 100.0).round().clamp(1.0, 99.0) as u8),
        }
    }

    /// Share of the credit, from 0 to 1.
    pub fn credit(self) -> f64 {
        match self {
            Self::Correct => 1.0,
            Self::Partly(percent) => f64::from(percent) / 100.0,
            _ => 0.0,
        }
    }

    /// True for an answer that counts as an attempt: it could be read, and there is a right answer.
    pub fn is_attempt(self) -> bool {
        !matches!(self, Self::Unreadable | Self::Unanswerable)
    }

    /// Parses the output of [`Grade::code`].
    pub fn from_code(code: &str) -> Option<Self> {
        if let Some(percent) = code.strip_prefix(PARTLY) {
            return percent.parse().ok().filter(|percent| (1..=99).contains(percent)).map(Self::Partly);
        }
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
