//! Reports of a finished fit, or of several ranked ones: one HTML page that prints well, a workbook, CSV and SVG figures, in
//! every language of the interface.
//!
//! All are made from a finished [`analysis::fit::Outcome`] and its document, a [`Report`]. [`FitReport`] is a fit as rows,
//! statistics and sentences in one language: the HTML page, the workbook, the text of the program, its JSON and the
//! laboratory's panel print it and choose no sentence of their own. `film` draws the films of the records, or a tracked film
//! on a page of its own.
//!
//! - **Invariant:** nothing else is computed. Every number in a report comes from the fit's outcome and is only rounded.
//! - **Invariant:** no file is read or written. The page contains no script and makes no request; `markup.rs` escapes every
//!   name that comes from a file or document.

mod doubt;
mod drawing;
mod export;
mod film;
mod findings;
mod fit_report;
mod markup;
mod outliers;
mod page;
mod png;
mod ranking;
mod remarks;
mod report;
mod results;
mod theory;
mod written;

pub use drawing::figure;
pub use export::{csv, workbook};
pub use film::{Film, FilmFile, FilmPicture, FilmView, Frame, TrackReport, film_html};
pub use fit_report::{FitReport, FitRow, Statistic};
pub use markup::{Page, document as page_of, escaped, plain_symbol, symbol, with_math_font};
pub use page::{footer, html};
pub use ranking::{Ranking, ranking_csv, ranking_html, ranking_workbook};
pub use report::Report;

pub use written::{quantity, size, sizes};
