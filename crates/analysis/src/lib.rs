//! Analysis of measured data with models: tables and their import, data quality, derivatives, cycles, least squares with
//! uncertainties, and the ranking of models.

pub mod assumed_unit;
pub mod conversion;
pub mod csv;
pub mod cycles;
pub mod data_sets;
pub mod derivative;
mod error_name;
pub mod finding;
pub mod fit;
pub mod import;
pub mod inspection;
pub mod lookup;
pub mod origin;
pub mod reading;
mod repeats;
pub mod roles;
mod run_name;
pub mod sampling;
mod scale_line;
pub mod smoothing;
pub mod spreadsheet;
pub mod stencil;
pub mod table;
pub mod tracker;
pub mod virtual_record;
pub mod workbook;

pub use scale_line::scale_line;
