//! Media query for narrow windows.

/// A window with room for the scene and one plot: a phone, or a tablet in portrait orientation.
pub const NARROW: &str = "(max-width: 1099px) and (orientation: portrait), (max-width: 719px), (max-height: 500px)";
