//! Views of a simulation: scene, plots, transport, controls, values, questions and text. The page of a single
//! simulation and the laboratory are built from these views; everything else is specific to the page ([`Host`]).

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
