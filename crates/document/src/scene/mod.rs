//! The drawing: SVG with `{expressions}`, restricted to safe elements and attributes.
//!
//! The page builds its nodes from the scene tree and never from the author's text. A scene may use `url(` in one form only,
//! `url(#id)` for a paint, clip or marker of the same scene. The page shows a scene in a shadow tree: its ids, classes and
//! rules stay there. The shapes of a clip are joined to one path (`clip.rs`), because WebKit clips by a path only where there
//! is one.

mod allowed;
mod amounts;
mod appearance;
mod attributes;
mod build;
mod builder;
mod choice;
mod clip;
mod colours;
mod drag;
mod elements;
mod ids;
mod parts;
mod quantity;
mod reading;
mod repeat;
mod space;
mod style;
mod template;
mod translate;
mod value_list;
mod values;
mod xml;

pub(crate) use allowed::ELEMENTS;
pub(crate) use build::{build, build_marked};
pub(crate) use colours::PALETTE;
pub use parts::Part;
pub(crate) use parts::{ARC_RADIUS, BOB_RADIUS, PARTS, part, part_of};
pub(crate) use space::marks::Marks;
pub(crate) use space::points::{Step, pairs, steps};
pub(crate) use template::normalised;
pub(crate) use translate::{SceneText, has_word, translated};
pub(crate) use xml::{RawChild, RawElement, parse};
