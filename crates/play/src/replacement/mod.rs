//! Replacement of the program while it runs. While a document is edited, the former program runs on until the text is free of
//! errors.
//!
//! | item | treatment |
//! |---|---|
//! | parameters | by name and dimension: a value that differs from the former default stays, any other becomes the new default |
//! | method, step | likewise: values that differ from the former document stay |
//! | presses of buttons | stay at their times, by the names or titles of the buttons |
//! | drawn curves | stay by the names of their tables, if range and arguments are equal |
//! | start set by hand | stays if each state has a former one of its name and dimension |
//! | the run, its time | recomputed with the changes of parameters at their times, up to the work limit of a link; kept as it is if model and values are equal |
//! | speed, language, playing | stay |
//! | ghost | the run that was replaced, or the former ghost if the run stays; none if other curves are plotted |
//! | kept runs | recomputed, except where nothing would change; a run that loses a value is dropped |
//! | visibility and zoom of plots | by title; zoom only if the units of the axes are equal |
//! | answers | by the text of the question; the grade stays if the computed answer is the same expression |
//! | answers to the survey | by kind and texts of the item |
//! | undo, drag in the scene | end, because they refer to the former program |
//! | added plots | stay after those of the document, whose number determines their [`PlotId`](crate::PlotId) |
//!
//! A value that equals the former default counts as not set, even if the user has set it: the two cases cannot be distinguished.

mod answers;
mod names;
mod plots;
mod recipe;

pub(crate) use answers::asks_the_same;
pub(crate) use names::Names;
pub(crate) use plots::{has_same_curves, same_curves};
