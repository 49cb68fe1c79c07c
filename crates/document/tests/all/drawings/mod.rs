//! Scenes: what may stand in them, and how they change by hand.

mod drawing;
mod frames;
mod parts;
mod repeats;
mod scene;
mod sketch;
