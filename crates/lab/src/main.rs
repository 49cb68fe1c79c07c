//! The browser shell of the laboratory: it calls the methods of the desk and of its simulation and draws what their getters give.
//! All state is theirs; what is kept here is the browser's business (nodes, canvases, the clock, the theme).

mod app;
mod browser;
mod controls;
mod correction;
mod cycles;
mod data;
mod derivatives;
mod diagnostics;
mod drag;
mod drop;
mod fit;
mod frame;
mod grip;
mod header;
mod icons;
mod intake;
mod keys;
mod library;
mod links;
mod measurements;
mod messages;
mod opening;
mod packing;
mod panel;
mod parameters;
mod pieces;
mod presenter;
mod question;
mod readouts;
mod records;
mod saved;
mod scene;
mod sound;
mod stage;
mod theme;
mod titles;
mod transport;
mod views;
mod virtual_form;
mod visited;
mod words;
mod worksheet;
mod workspace;

fn main() {
    workspace::start();
}
