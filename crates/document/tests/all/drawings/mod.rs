//! Scenes: permitted content, and graphical edits.

mod clips;
mod drawing;
mod frames;
mod parts;
mod repeats;
mod scene;
mod sketch;
