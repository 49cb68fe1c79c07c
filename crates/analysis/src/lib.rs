//! Measured data and fits: from a file to a table, and from tables and a model to numbers with uncertainties.
//!
//! | module | content |
//! |---|---|
//! | [`reading`] | a file of any kind, read in slices: the entry of page and program |
//! | [`import`] | text to a [`table`]: delimiters, headings, units, clocks, sections, files of instruments |
//! | [`workbook`], [`tracker`], [`data_sets`] | workbooks and archives as text; projects of Tracker; what was exported together |
//! | [`roles`], [`lookup`], [`origin`] | which columns are independent variables; columns by name; where a column comes from |
//! | [`assumed_unit`] | the unit of a column that states none, decided once for all theories that are fitted to it |
//! | [`inspection`], [`sampling`], [`stencil`], [`finding`] | dropped frames, columns derived from others and other defects |
//! | [`cycles`], [`derivative`], [`smoothing`] | an oscillation without a theory; differentiated columns |
//! | [`fit`] | least squares of models, and their ranking |
//! | [`csv`], [`spreadsheet`] | files that are written, as text and as XLSX |
//!
//! - **Invariant:** import drops nothing silently, and asks where two readings hold. Every observation is a
//!   [`finding::Finding`] or an [`import::ImportError`], with its words in every language.
//! - **Invariant:** a file that is read in slices ([`reading::Reading`], [`inspection::Inspector`]) gives the same result as
//!   one that is read at once.
//! - **Invariant:** a workbook or project is treated as hostile: size, length of a token, nesting and addresses of cells are
//!   checked before anything is stored.
//! - **Invariant:** a fit has no state outside itself and uses no random numbers. The same task gives the same bits.
//!
//! ```
//! let file = b"t [s];y [cm]\n0;1.5\n0.1;1.2\n0.2;0.7\n0.3;0.1\n";
//! let table = analysis::import::text(file).expect("a table").table;
//! assert_eq!(table.columns[1].name, "y");
//! assert_eq!(table.columns[1].si(None)[0], 0.015);
//! ```

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
