//! Figures: axes, ticks and series to a display list, and that to SVG.
