//! One cycle of an oscillation.

/// A value and its standard error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// The cycle around one turning point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// When the turning point is.
    pub time: Measured,
    /// Whether it is a maximum.
    pub maximum: bool,
    /// The envelope there, from the offset.
    pub amplitude: Measured,
    /// From one maximum to the next.
    pub period: Measured,
    /// The natural logarithm of the ratio of two amplitudes one period apart; negative where they grow.
    pub decrement: Measured,
    /// Local angular frequency, 2 pi over the period.
    pub angular_frequency: Measured,
    /// Local damping, the decrement over the period.
    pub damping: Measured,
    /// What it swings about.
    pub offset: Measured,
}
