//! Browser shell of the laboratory: it calls the methods of the desk and of its simulation and draws the values of their
//! getters. The desk and the simulation own the state; this crate keeps browser objects only (nodes, canvases, the clock, the
//! theme).
//!
//! `App` (`app.rs`) leads to the views' `App` and to the desk (`read_desk`, `act_on_desk`).
//!
//! | module | content |
//! |---|---|
//! | `workspace.rs`, `header.rs`, `panel`, `idle.rs` | the page, its tabs, and a document with errors in place of the stage |
//! | `documents` | opening, links, history of the browser, storage, projects |
//! | `library` | documents that the page carries, as cards |
//! | `measuring`, `fit`, `film`, `write`, `class` | the tabs *Measure*, *Write* and *Class*, the strip of fits, films |
//! | `publish`, `verifying` | the dialog of the button *Share*; hand-ins that are read |
//! | `guide`, `welcome.rs` | the guided start, whose steps are recognised by the announcements of the simulation |
//! | `workers` | long work beside the page |
//!
//! `panel/needed.rs` turns *For teachers* on when something is opened that needs a hidden part.
//!
//! Opening: `crates/lab/page/opening.js` inflates and compiles the laboratory when the page is idle, and says when it may work:
//! never while something is pressed, and while a run plays only ten seconds after the last press or key. `workspace.rs` reads the
//! document and builds the page part by part, outside of what is shown (`App::part`). It calls `view::page::opening::Opening::take`
//! as soon as nothing in the panel has the focus and no dialog, menu or passing message is shown, and puts its page in the place of
//! the player's in the same task, so that nothing is painted between. Its live region is empty then. Everything comes as soon as it
//! can when it is asked for, or when link, step of the history or errors need another document than the player's.
//!
//! - **Invariant:** no physics, and no state of the laboratory: that is in the one `Desk`.

mod app;
mod class;
mod documents;
mod film;
mod fit;
mod guide;
mod header;
mod idle;
mod library;
mod measuring;
mod panel;
mod publish;
mod verifying;
mod welcome;
mod words;
mod workers;
mod workspace;
mod write;

fn main() {
    if workers::is_worker() {
        workers::serve();
    } else {
        workspace::start();
    }
}
