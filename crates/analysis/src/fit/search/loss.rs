//! Loss functions of a residual: the square, or a robust loss that grows more slowly for large residuals.

use serde::{Deserialize, Serialize};
use units::Language;

/// Loss function of a residual.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Loss {
    /// Square.
    #[default]
    Squares,
    /// Square up to 1.345 standard deviations, linear beyond (P. J. Huber, Ann. Math. Statist. 35 (1964) 73): 95 %
    /// efficiency for normal errors.
    Huber,
    /// Biweight (A. E. Beaton & J. W. Tukey, Technometrics 16 (1974) 147): residuals beyond 4.685 standard deviations have
    /// no weight; 95 % efficiency for normal errors.
    Tukey,
}

impl Loss {
    /// All loss functions, the usual one first.
    pub const ALL: [Self; 3] = [Self::Squares, Self::Huber, Self::Tukey];

    /// Tuning constant, in standard deviations.
    const fn tuning(self) -> f64 {
        match self {
            Self::Squares => f64::INFINITY,
            Self::Huber => 1.345,
            Self::Tukey => 4.685,
        }
    }

    /// Short name, read by [`Loss::from_code`].
    pub const fn code(self) -> &'static str {
        match self {
            Self::Squares => "least-squares",
            Self::Huber => "huber",
            Self::Tukey => "tukey",
        }
    }

    /// Loss with this [`Loss::code`].
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|loss| loss.code() == code)
    }

    /// Name shown to users.
    pub fn name(self, language: Language) -> &'static str {
        match self {
            Self::Squares => language.say("least squares"),
            Self::Huber => language.say("Huber's loss"),
            Self::Tukey => language.say("Tukey's loss"),
        }
    }

    /// Weight of the square of a residual of `z` standard deviations, 0 to 1.
    pub(in crate::fit) fn weight(self, z: f64) -> f64 {
        let part = z.abs() / self.tuning();
        match self {
            Self::Squares => 1.0,
            Self::Huber => 1.0 / part.max(1.0),
            Self::Tukey if part < 1.0 => (1.0 - part * part) * (1.0 - part * part),
            Self::Tukey => 0.0,
        }
    }

    /// Derivative of the residual times its weight.
    pub(in crate::fit) fn slope(self, z: f64) -> f64 {
        let square = (z / self.tuning()) * (z / self.tuning());
        match self {
            Self::Squares => 1.0,
            _ if square > 1.0 => 0.0,
            Self::Huber => 1.0,
            Self::Tukey => (1.0 - square) * (1.0 - 5.0 * square),
        }
    }
}
