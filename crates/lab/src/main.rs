//! Browser shell of the laboratory: it calls the methods of the desk and of its simulation and draws the values of
//! their getters. The desk and the simulation own the state; this crate keeps browser objects only (nodes, canvases,
//! the clock, the theme).

mod app;
mod carried;
mod class;
mod cycles;
mod data;
mod derivatives;
mod diagnostics;
mod drop;
mod files;
mod film;
mod fit;
mod guide;
mod header;
mod idle;
mod intake;
mod library;
mod library_list;
mod library_own;
mod library_search;
mod links;
mod measurements;
mod navigation;
mod opening;
mod packing;
mod panel;
mod pictures;
mod project;
mod publish;
mod records;
mod saved;
mod served;
mod stored;
mod titles;
mod verifying;
mod virtual_form;
mod visited;
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
