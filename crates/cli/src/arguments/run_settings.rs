//! Settings of a run on the command line.

use clap::Args;
use program::Seat;
use runner::Settings;
use runner::names::{Assignment, assignment, press, seat};

/// Settings of a run.
#[derive(Clone, Debug, Args)]
pub struct RunSettings {
    /// Take the assigned values of this seat
    #[arg(long, value_name = "N", value_parser = seat)]
    pub seat: Option<Seat>,

    /// Change a parameter: a bare number is in the declared unit, `b='0.2 [t/s]'` names its own
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    pub set: Vec<Assignment>,

    /// Start with this state instead of the document's initial value, such as y='10 [cm]'
    #[arg(long = "start", value_name = "NAME=VALUE", value_parser = assignment)]
    pub start: Vec<Assignment>,

    /// Set the parameters of this preset of the document, before any --set
    #[arg(long, value_name = "NAME")]
    pub preset: Vec<String>,

    /// Press a button of the document at a time, such as Kick=3.2; by its title, its translated title or its name
    #[arg(long = "press", value_name = "BUTTON=T", value_parser = press)]
    pub press: Vec<Assignment>,

    /// Draw a table of the document through the points of a file with two columns, such as F=push.csv
    #[arg(long = "draw", value_name = "TABLE=FILE", value_parser = assignment)]
    pub draw: Vec<Assignment>,

    /// Method of integration [default: the document's, or rk4]
    #[arg(long, value_name = "METHOD")]
    pub method: Option<String>,

    /// The step, or with an adaptive method the distance between rows [default: the document's]
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub step: Option<String>,

    /// The relative error that an adaptive method may make in a step
    #[arg(long, value_name = "X")]
    pub tolerance: Option<f64>,

    /// End of the run [default: the document's, or 100 s]
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub until: Option<String>,
}

impl From<&RunSettings> for Settings {
    fn from(arguments: &RunSettings) -> Self {
        let arguments = arguments.clone();
        Self {
            seat: arguments.seat,
            set: arguments.set,
            start: arguments.start,
            preset: arguments.preset,
            press: arguments.press,
            method: arguments.method,
            step: arguments.step,
            tolerance: arguments.tolerance,
            until: arguments.until,
        }
    }
}
