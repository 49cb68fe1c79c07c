//! Views of a simulation: scene, plots, transport, controls, values, questions and text. The page of a single simulation and
//! the laboratory are built from these views; everything else is specific to the page ([`Host`]).
//!
//! Sycamore makes the structure, a canvas the plots, SVG nodes the scene. `views.rs` has the few ways to build views, with
//! boxed closures, so that the module holds their code once.
//!
//! | module | content |
//! |---|---|
//! | `app.rs`, `frame.rs` | the handle that every view holds; the animation frame |
//! | `stage` | scene, plots and transport, always in sight |
//! | `scene` | the picture of a simulation, its handles, outline and ruler |
//! | `controls` | parameters, presets, state, method and step |
//! | `panel` | a row of tabs, of which *Explore*, *Questions* and *Theory* are here |
//! | `pieces` | buttons, fields, tables, dialogs |
//! | `page` | what stands around stage and panel |
//!
//! - **Invariant:** no physics, no parsers, no data, no fits.
//! - **Invariant:** every text of the interface stands in a table (`words.rs`) in English and is translated by a catalogue.
//! - **Invariant:** signals act at once: never set a signal inside [`App::read`]. Rebuilding a view disposes the signals of
//!   the handler that triggered it; signals owned by [`App`] survive.

mod app;
pub mod browser;
pub mod controls;
pub mod frame;
pub mod page;
pub mod panel;
pub mod pieces;
pub mod scene;
pub mod stage;
pub mod views;
pub mod words;

pub use app::{App, Changes, Host, News, Page, title};
