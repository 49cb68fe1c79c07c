//! Travel from the values before a fit to the fitted ones: liquid and curve are seen to move onto the data.

use crate::app::App;
use program::Choices;
use view::browser;

/// Duration of the travel, ms.
const DURATION: f64 = 600.0;
/// Pause between two steps of the travel, ms: about a frame.
const PAUSE: i32 = 15;
/// Most rows of a run that is computed again in each step.
const MOST_ROWS: usize = 4000;

/// Present values of the parameters, SI.
pub fn values(app: App) -> Vec<f64> {
    app.read(|play| play.course().parameters().to_vec())
}

/// Lets the simulation travel from `before` (SI) to the values that a fit has set. Any other change ends the travel at
/// once. Does nothing if the visitor wishes less motion, or if the run takes too long to compute.
pub fn from(app: App, before: Vec<f64>) {
    let (fitted, end, rows) = app.read(|play| {
        let course = play.course();
        (course.parameters().to_vec(), course.front(), course.rows())
    });
    let is_still = fitted == before || fitted.len() != before.len() || rows > MOST_ROWS;
    if is_still || browser::matches("(prefers-reduced-motion: reduce)") {
        return;
    }
    let program = app.changes.program.get_untracked();
    wasm_bindgen_futures::spawn_local(async move {
        let begun = js_sys::Date::now();
        let mut set = fitted.clone();
        loop {
            let share = ((js_sys::Date::now() - begun) / DURATION).min(1.0);
            if app.changes.program.get_untracked() != program {
                return;
            }
            let now = values(app);
            let is_alone = now == set;
            let next = match is_alone && share < 1.0 {
                true => between(app, &before, &fitted, share * share * (3.0 - 2.0 * share)),
                // A value that was changed meanwhile stays.
                false => (0..now.len()).map(|k| if now[k] == set[k] { fitted[k] } else { now[k] }).collect(),
            };
            app.slide(|play| {
                let time = play.course().time();
                play.change_run(|line, basis| line.run_through(basis, next.clone(), end));
                play.change_run(|line, _| line.show_time(time));
            });
            if !is_alone || share >= 1.0 {
                return;
            }
            set = next;
            browser::pause(PAUSE).await;
        }
    });
}

/// Values at a share of the way. Parameters that have few values have the fitted one.
fn between(app: App, before: &[f64], fitted: &[f64], share: f64) -> Vec<f64> {
    app.read(|play| {
        let parameters = play.model().parameters.iter().zip(before.iter().zip(fitted));
        let at = |(parameter, (from, to)): (&program::Parameter, (&f64, &f64))| match parameter.choices {
            Choices::Numbers => from + share * (to - from),
            _ => *to,
        };
        parameters.map(at).collect()
    })
}
