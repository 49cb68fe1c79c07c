//! Reports of a fit: one printable HTML page, a workbook, CSV and figures, in English and Spanish.
//!
//! All are made from a finished [`analysis::fit::Outcome`] and its document. Nothing else is computed, and no file is
//! read or written. The page contains no script and makes no request.

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
