//! Browser shell of the laboratory: it calls the methods of the desk and of its simulation and draws the values of
//! their getters. The desk and the simulation own the state; this crate keeps browser objects only (nodes, canvases,
//! the clock, the theme).

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
