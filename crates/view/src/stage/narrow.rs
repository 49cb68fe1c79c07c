//! Which windows have room for one plot only.

/// A window with room for the scene and one plot: a phone, or a tablet held upright.
pub const NARROW: &str = "(max-width: 1099px) and (orientation: portrait), (max-width: 719px), (max-height: 500px)";
