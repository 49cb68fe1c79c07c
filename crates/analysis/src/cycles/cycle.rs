//! One cycle of an oscillation. Values and times are in the units of the record.

/// Value with its standard error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// Value.
    pub value: f64,
    /// Standard error.
    pub error: f64,
}

/// Cycle around one turning point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Time of the turning point.
    pub time: Measured,
    /// True for a maximum, false for a minimum.
    pub maximum: bool,
    /// Envelope at the turning point, measured from the offset.
    pub amplitude: Measured,
    /// Time from one maximum to the next.
    pub period: Measured,
    /// Natural logarithm of the ratio of two amplitudes one period apart; negative if they grow.
    pub decrement: Measured,
    /// Local angular frequency, 2 pi over the period, rad per unit of time.
    pub angular_frequency: Measured,
    /// Local damping, the decrement over the period, 1 per unit of time.
    pub damping: Measured,
    /// Level about which it oscillates.
    pub offset: Measured,
}
