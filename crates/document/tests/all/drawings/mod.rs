//! Scenes: permitted content, and graphical edits.

mod drawing;
mod frames;
mod parts;
mod repeats;
mod scene;
mod sketch;
