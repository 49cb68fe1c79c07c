//! An ensemble beside the single runs of the engine.

use engine::{Readings, Run, RunError, Setup};
use ensemble::{Alone, Ensemble, Features, LastRow, NoLanes};
use program::{Model, NodeId};

/// Rows read, time and values in turn, and how the run ends.
pub type Course = (Vec<u64>, Result<(u64, Vec<u64>), RunError>);

/// Number of rows of the run with these parameters.
pub fn rows(model: &Model, setup: &Setup, until: f64) -> usize {
    let mut run = Run::start(model, setup.clone()).unwrap();
    while run.time() < until && run.advance().is_ok() {}
    run.history().len()
}

/// The run with these parameters by the engine alone.
pub fn single(model: &Model, setup: &Setup, until: f64, nodes: &[NodeId]) -> Course {
    let mut read = Vec::new();
    let mut last = None;
    let mut readings = Readings::new(model, nodes);
    let mut run = match Run::start(model, setup.clone()) {
        Ok(run) => run,
        Err(error) => return (read, Err(error)),
    };
    let mut rows = 0;
    let mut take = |run: &Run, rows: &mut usize| {
        let history = run.history();
        for row in *rows..history.len() {
            let time = history.time(row);
            if time <= until * (1.0 + engine::ROUNDING) {
                if !nodes.is_empty() {
                    read.push(time.to_bits());
                    read.extend(readings.at_row(history, row).iter().map(|value| value.to_bits()));
                }
                let mut state = vec![0.0; history.states()];
                history.state(row, &mut state);
                last = Some((time.to_bits(), state.into_iter().map(f64::to_bits).collect()));
            }
        }
        *rows = history.len();
    };
    take(&run, &mut rows);
    let mut error = None;
    while run.time() < until * (1.0 - engine::ROUNDING) {
        let advanced = run.advance();
        take(&run, &mut rows);
        if let Err(found) = advanced {
            error = Some(found);
            break;
        }
    }
    if error.is_none() {
        error = run.finish(until).err();
        take(&run, &mut rows);
    }
    let end = match error {
        Some(error) if !error.is_end() => Err(error),
        _ => Ok(last.unwrap()),
    };
    (read, end)
}

/// The runs with these parameters in lanes.
pub fn lanes(
    model: &Model,
    (setup, until): (&Setup, f64),
    nodes: &[NodeId],
    parameters: &[Vec<f64>],
    features: Features,
) -> Result<Vec<Course>, NoLanes> {
    let mut ensemble = Ensemble::new(model, setup, until, nodes)?;
    ensemble.use_features(features);
    let mut alone = Alone::new(model, setup, nodes);
    let mut courses = Vec::new();
    for parameters in parameters.chunks(ensemble.lanes()) {
        let mut read = vec![Vec::new(); parameters.len()];
        let ends = ensemble.run(&mut alone, parameters, &mut |lane, time, values| {
            read[lane].push(time.to_bits());
            read[lane].extend(values.iter().map(|value| value.to_bits()));
        });
        let bits = |last: LastRow| (last.time.to_bits(), last.state.into_iter().map(f64::to_bits).collect());
        courses.extend(read.into_iter().zip(ends).map(|(read, end)| (read, end.map(|end| bits(end.last)))));
    }
    Ok(courses)
}
