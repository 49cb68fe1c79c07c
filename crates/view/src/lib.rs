//! Views of a simulation: scene, plots, transport, controls, values, questions and text. The page of a single
//! simulation and the laboratory are built from these views; everything else is specific to the page ([`Host`]).

mod app;
pub mod browser;
mod buttons;
mod choices;
mod claims;
mod colours;
pub mod controls;
mod data;
mod drag;
mod drawings;
pub mod frame;
mod grip;
pub mod handing;
pub mod header;
pub mod icons;
pub mod keys;
mod member;
pub mod message;
pub mod messages;
pub mod panel;
mod parameters;
pub mod picture;
pub mod pieces;
pub mod playing;
pub mod projector;
pub mod question;
pub mod reading;
mod readouts;
mod scene;
mod seat;
pub mod shell;
pub mod sight;
mod sizes;
mod sound;
pub mod stage;
mod steady;
mod survey;
pub mod symbols;
pub mod tabs;
pub mod theme;
mod transport;
pub mod views;
pub mod words;
pub mod worksheet;

pub use app::{App, Changes, Host, News, Page, title};
