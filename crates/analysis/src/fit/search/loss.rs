//! What a residual costs: its square, or with a robust loss less where it is large.

use units::Language;

/// What a residual costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loss {
    /// Its square.
    #[default]
    Squares,
    /// Its square up to 1.345 standard deviations, beyond it a straight line (P. J. Huber, Ann. Math. Statist. 35 (1964) 73): as
    /// good as 95 % of the values with least squares, where these are normal.
    Huber,
    /// The biweight (A. E. Beaton & J. W. Tukey, Technometrics 16 (1974) 147): what is beyond 4.685 standard deviations counts
    /// nothing; 95 % as well.
    Tukey,
}

impl Loss {
    /// All of them, the usual one first.
    pub const ALL: [Self; 3] = [Self::Squares, Self::Huber, Self::Tukey];

    /// Where it leaves the square, in standard deviations.
    const fn tuning(self) -> f64 {
        match self {
            Self::Squares => f64::INFINITY,
            Self::Huber => 1.345,
            Self::Tukey => 4.685,
        }
    }

    /// A short name that [`Loss::from_code`] reads.
    pub const fn code(self) -> &'static str {
        match self {
            Self::Squares => "least-squares",
            Self::Huber => "huber",
            Self::Tukey => "tukey",
        }
    }

    /// What [`Loss::code`] has written.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|loss| loss.code() == code)
    }

    /// What it is called.
    pub const fn name(self, language: Language) -> &'static str {
        match (self, language) {
            (Self::Squares, Language::English) => "least squares",
            (Self::Squares, Language::Spanish) => "mínimos cuadrados",
            (Self::Huber, Language::English) => "Huber's loss",
            (Self::Huber, Language::Spanish) => "pérdida de Huber",
            (Self::Tukey, Language::English) => "Tukey's loss",
            (Self::Tukey, Language::Spanish) => "pérdida de Tukey",
        }
    }

    /// How much a residual of so many standard deviations counts, beside its square.
    pub(in crate::fit) fn weight(self, z: f64) -> f64 {
        let part = z.abs() / self.tuning();
        match self {
            Self::Squares => 1.0,
            Self::Huber => 1.0 / part.max(1.0),
            Self::Tukey if part < 1.0 => (1.0 - part * part) * (1.0 - part * part),
            Self::Tukey => 0.0,
        }
    }

    /// The derivative of the residual times its weight.
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
