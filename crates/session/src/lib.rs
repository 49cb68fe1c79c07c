//! Everything a person can do in the laboratory, as plain state and transitions. No DOM, no clock: the shell calls
//! [`Session::tick`] with the seconds that have passed and draws what the getters return.
//!
//! | subject | what it offers |
//! |---|---|
//! | opening | [`Session::open`], [`Session::document`], [`Session::model`], [`Session::language`], [`Session::set_language`], [`Session::style`], [`Session::text`], [`Session::revision`] |
//! | clock and transport | [`Session::tick`], [`Session::play`], [`Session::pause`], [`Session::toggle`], [`Session::step_forward`], [`Session::step_back`], [`Session::back_to_start`], [`Session::scrub`], [`Session::set_speed`], [`Session::status`], [`Session::time`], [`Session::time_text`], [`Session::time_words`], [`Session::end`], [`Session::horizon`], [`Session::is_scrubbed`], [`Session::slippage`], [`Session::problem`] |
//! | parameters | [`Session::parameters`], [`Session::parameter`], [`Session::parameter_values`], [`Session::set_parameter`], [`Session::set_parameter_text`], [`Session::slide`], [`Session::restore_default`], [`Session::restore_defaults`] |
//! | presets | [`Session::presets`], [`Session::apply_preset`] |
//! | state | [`Session::states`], [`Session::set_state`], [`Session::set_state_text`], [`Session::is_started_by_hand`], [`Session::drag_range`], [`Session::drag_begin`], [`Session::drag_move`], [`Session::drag_end`], [`Session::is_dragging`] |
//! | what is shown | [`Session::readouts`], [`Session::scene_values`], [`Session::scene_text`], [`Session::pitch`] |
//! | plots | [`Session::plots`], [`Session::show_plot`], [`Session::layout_plot`], [`Session::plot_figure`], [`Session::plot_svg`], [`Session::hover_plot`], [`Session::move_cursor`], [`Session::zoom_plot`], [`Session::pan_plot`], [`Session::zoom_plot_to`], [`Session::reset_plot`] |
//! | runs | [`Session::keep`], [`Session::kept`], [`Session::show_kept`], [`Session::remove_kept`], [`Session::has_ghost`], [`Session::remove_ghost`], [`Session::clear_ghost`] |
//! | table | [`Session::table_header`], [`Session::table_length`], [`Session::table_rows`], [`Session::table_row_now`], [`Session::csv`], [`Session::workbook`] |
//! | measured data | [`Session::records`], [`Session::newest_record`], [`Session::record_cells`], [`Session::add_record`], [`Session::begin_record`], [`Session::advance_record`], [`Session::record_progress`], [`Session::cancel_record`], [`Session::add_sample`], [`Session::sample_names`], [`Session::measure`], [`Session::measurement_form`], [`Session::measurement_units`], [`Session::show_record`], [`Session::remove_record`], [`Session::measurable`], [`Session::set_column_quantity`], [`Session::set_column_unit`], [`Session::set_column_fitted`], [`Session::make_derivatives`], [`Session::forget_derivatives`], [`Session::has_points`], [`Session::ghost_follows`], [`Session::ghost_records`], [`Session::ghost_values`], [`Session::saved_records`], [`Session::restore_records`], [`Session::adopt_records`] |
//! | cycle by cycle | [`Session::open_cycles`], [`Session::looks_at_cycles`], [`Session::cycle_columns`], [`Session::choose_cycles`], [`Session::cycle_quantities`], [`Session::show_cycles`], [`Session::cycles_against_amplitude`], [`Session::cycles`], [`Session::cycle_plot`], [`Session::export_cycles`] |
//! | fits | [`Session::fit_records`], [`Session::fit_with`], [`Session::chosen_record`], [`Session::choose_record`], [`Session::fit_choices`], [`Session::vary`], [`Session::set_same`], [`Session::set_known`], [`Session::fit_window`], [`Session::set_fit_window`], [`Session::begin_fit`], [`Session::begin_ranking`], [`Session::advance_fit`], [`Session::cancel_fit`], [`Session::fit_progress`], [`Session::fits`], [`Session::fit_detail`], [`Session::fit_texts`], [`Session::apply_fit`], [`Session::remove_fit`], [`Session::export_fit`], [`Session::export_ranking`], [`Session::saved_fits`], [`Session::restore_fits`], [`Session::has_fits_waiting`] |
//! | questions | [`Session::check_answer`], [`Session::reveal_answer`], [`Session::answer`], [`Session::type_answer`], [`Session::saved_answers`], [`Session::restore_answer`], [`Session::question_unit`], [`Session::question_setup`], [`Session::apply_question_setup`], [`Session::hides_values`], [`Session::shows_hidden`], [`Session::show_hidden`] |
//! | method | [`Session::methods`], [`Session::set_method`], [`Session::step`], [`Session::step_text`], [`Session::set_step`], [`Session::set_step_text`] |
//! | undo | [`Session::undo_number`], [`Session::undo`] |
//! | sharing | [`Session::share`], [`Session::missing_in_link`], [`Session::restore`], [`Link`] |
//! | words | [`Session::take_announcement`], [`Session::announcement_text`], [`Session::refusal_text`], [`speed_text`], [`symbol`], [`number`] |
//!
//! A [`Refusal`] is the answer to input that cannot be taken; nothing has changed then. Getters that return texts use
//! the session's language. No method panics; an index that does not exist is ignored or refused.

mod announcement;
mod answer;
mod answered;
mod applied_fit;
mod arithmetic;
mod columns;
mod course;
mod cycle_plot;
mod cycles;
mod derived;
mod drag;
mod fit_setup;
mod fitted;
mod fitting;
mod ghost;
mod input;
mod intake;
mod kept;
mod link;
mod measurement;
mod method;
mod observed;
mod parameter;
mod plot;
mod plot_series;
mod preset;
mod problem;
mod question;
mod reading;
mod readout;
mod recognise;
mod record;
mod refusal;
mod reporting;
mod residual_plot;
mod runs;
mod sample;
mod saved_fits;
mod saved_records;
mod session;
mod share;
mod shelf;
mod slider;
mod start;
mod state;
mod symbol;
mod table;
mod traces;
mod transport;
mod understood;
mod undo;
mod words;

pub use analysis::derivative::Differentiation;
pub use document;
pub use engine;
pub use figure;
pub use program;
pub use units::number;

pub use announcement::{Announcement, Prominence};
pub use answered::AnswerView;
pub use cycles::{CycleColumn, CyclesView};
pub use fit_setup::{ChoiceView, FitRecordView, KnownView};
pub use fitted::{EstimateView, FitDetail, FitView, MOST_FITS};
pub use fitting::FitProgress;
pub use ghost::Follows;
pub use intake::RecordProgress;
pub use kept::{KeptView, MOST_KEPT};
pub use link::{LONGEST_PACKED, LONGEST_UNPACKED, Link, Subject, packed_length};
pub use measurement::{MEASUREMENT_FIELDS, MeasurementForm};
pub use method::MethodView;
pub use parameter::ParameterView;
pub use plot::PlotView;
pub use plot_series::LegendEntry;
pub use preset::{PresetGroup, PresetView};
pub use problem::Problem;
pub use question::{Grade, Verdict};
pub use readout::{Readout, ReadoutKind};
pub use record::{ColumnView, LONGEST_RECORD, MOST_RECORDS, RecordView};
pub use refusal::Refusal;
pub use reporting::{Export, ExportKind, Imprint};
pub use sample::{SAMPLES, Sample};
pub use session::{Revision, Session};
pub use shelf::{Change, Shelf};
pub use slider::Slider;
pub use state::StateView;
pub use symbol::symbol;
pub use transport::{LONGEST_GAP, SPEEDS, Status, WORK_PER_TICK};
pub use units::Language;
pub use words::speed_text;
