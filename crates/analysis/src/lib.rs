//! Measured data meet a model: tables and their import, what a measurement hides, derivatives, cycles, least squares
//! with honest uncertainties, and the ranking of models.

pub mod cycles;
pub mod fit;
pub mod table;
pub mod virtual_record;
