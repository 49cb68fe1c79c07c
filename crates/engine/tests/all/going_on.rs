//! A run may be interrupted, divided into portions of work, and continued from an earlier row: its bits stay the same.

use crate::support::{model, setup};
use engine::{Advance, Method, Run, Setup};
use program::Model;

/// Bounces that die away, an event in time, and one that the first causes.
const BOUNCES: &str = "
parameter g = 9.8 [m/s^2]
parameter e = 0.6
y'' = -g
y(0) = 1 [m]
y'(0) = 0 [m/s]
n' = 0 [1/s]
n(0) = 0
when y < 0 [m] { y' = -e*y'
 n = n + 1 }
when t > 0.6 [s] { n = n + 100 }
when n > 104.5 { n = n - 100 }
";

/// Van der Pol's oscillator, stiff for large mu, with an event at the fast transitions.
const RELAXATION: &str = "
independent t
parameter mu = 5
y'' = mu*(1 - y^2)*y' - y
y(0) = 2
y'(0) = 0
n' = 0
n(0) = 0
when y < 0 { n = n + 1 }
";

fn cases() -> Vec<(Model, Setup)> {
    let mut cases = Vec::new();
    for method in Method::ALL {
        for (text, step) in [(BOUNCES, 0.05), (RELAXATION, 0.2)] {
            let model = model(text);
            if method == Method::VelocityVerlet {
                continue;
            }
            let setup = setup(&model, method, step);
            cases.push((model, setup));
        }
    }
    cases
}

/// Goes on to row `until` on the grid or to an error, with other parameters from two rows on.
fn proceed(run: &mut Run, until: usize, mut advance: impl FnMut(&mut Run) -> Option<Advance>) {
    loop {
        let grid = grid_rows(run);
        for at in [12, 21] {
            if grid == at {
                let mut parameters = run.parameters().to_vec();
                let last = parameters.len() - 1;
                parameters[last] = if at == 12 { 0.7 } else { 0.9 };
                run.set_parameters(parameters);
            }
        }
        if grid >= until {
            return;
        }
        loop {
            match advance(run) {
                Some(Advance::Partial) => {}
                Some(_) => break,
                None => return,
            }
        }
    }
}

/// How many points of the grid were reached.
fn grid_rows(run: &Run) -> usize {
    run.history().times().last().map_or(0, |time| (time / run.setup().step).round() as usize)
}

#[test]
fn going_on_from_any_row_of_the_grid_gives_the_same_bits_with_every_method() {
    for (model, setup) in cases() {
        let mut run = Run::start(&model, setup.clone()).unwrap();
        proceed(&mut run, 40, |run| run.advance().ok());
        let (history, step) = (run.history(), setup.step);
        assert!(history.segments().last() > Some(&0), "{}: without events the test shows nothing", setup.method);
        let on_grid = |row: &usize| {
            let time = history.time(*row);
            time == (time / step).round() * step && history.times().get(row + 1) != Some(&time)
        };
        for row in (0..history.len()).filter(on_grid) {
            let mut again = run.clone();
            again.truncate(row);
            assert_eq!(again.history().len(), row + 1);
            proceed(&mut again, 40, |run| run.advance().ok());
            assert_eq!(again.history(), run.history(), "{}, row {row}", setup.method);
        }
    }
}

#[test]
fn portions_of_work_do_not_change_the_bits() {
    for (model, setup) in cases() {
        let mut whole = Run::start(&model, setup.clone()).unwrap();
        proceed(&mut whole, 40, |run| run.advance().ok());
        for portion in [1, 100, 3000] {
            let mut run = Run::start(&model, setup.clone()).unwrap();
            proceed(&mut run, 40, |run| run.advance_within(portion).ok());
            assert_eq!(run.history(), whole.history(), "{}, portions of {portion}", setup.method);
        }
    }
}

#[test]
fn parameters_changed_within_a_row_hold_from_the_row_before_on() {
    let model = model(RELAXATION);
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let setup = setup(&model, method, 10.0);
        let mut whole = Run::start(&model, setup.clone()).unwrap();
        let mut divided = Run::start(&model, setup).unwrap();
        for run in [&mut whole, &mut divided] {
            (0..3).for_each(|_| assert!(run.advance().is_ok()));
        }
        assert_eq!(divided.advance_within(1), Ok(Advance::Partial));
        for run in [&mut whole, &mut divided] {
            run.set_parameters(vec![2.0]);
            (0..3).for_each(|_| assert!(run.advance().is_ok()));
        }
        assert_eq!(whole.history(), divided.history(), "{method}");
    }
}

#[test]
fn a_change_that_is_taken_back_before_the_next_step_leaves_no_trace() {
    for (model, setup) in cases() {
        let mut whole = Run::start(&model, setup.clone()).unwrap();
        let mut wavering = Run::start(&model, setup.clone()).unwrap();
        for _ in 0..40 {
            let advanced = [&mut whole, &mut wavering].map(|run| run.advance().is_ok());
            if advanced != [true; 2] {
                break;
            }
            let parameters = wavering.parameters().to_vec();
            wavering.set_parameters(parameters.iter().map(|value| 0.9 * value).collect());
            wavering.set_parameters(parameters.iter().map(|value| 1.1 * value).collect());
            wavering.set_parameters(parameters);
        }
        assert_eq!(wavering.history(), whole.history(), "{}", setup.method);
        assert_eq!(whole.history().parameter_sets(), [(0, setup.parameters)]);
    }
}

#[test]
fn a_portion_of_work_is_hardly_exceeded_however_stiff_the_equations_are() {
    const PORTION: u64 = 10_000;
    let text = RELAXATION.replace("mu = 5", "mu = 100000");
    let model = model(&text);
    for (method, step) in [(Method::DormandPrince, 20.0), (Method::Rosenbrock, 2e5)] {
        let mut run = Run::start(&model, setup(&model, method, step)).unwrap();
        let mut greatest = 0;
        let mut partial = 0;
        for _ in 0..500 {
            let before = run.work();
            match run.advance_within(PORTION) {
                Ok(Advance::Partial) => partial += 1,
                Ok(_) => {}
                Err(error) => panic!("{method}: {error}"),
            }
            greatest = greatest.max(run.work() - before);
        }
        assert!(partial > 10, "{method}: {partial}");
        // One step more, and the search for an event in it.
        assert!(greatest < PORTION + 20_000, "{method}: {greatest}");
    }
}

#[test]
fn a_flight_shorter_than_a_step_is_still_a_parabola_between_its_rows() {
    let model = model(BOUNCES);
    let mut run = Run::start(&model, setup(&model, Method::RungeKutta4, 0.25)).unwrap();
    for _ in 0..7 {
        run.advance().unwrap();
    }
    let history = run.history();
    let flights: Vec<usize> = (0..history.len() - 1)
        .filter(|&row| {
            let floor = |row: usize| history.column(0)[row].abs() < 1e-12;
            history.segment(row) == history.segment(row + 1) && floor(row) && floor(row + 1)
        })
        .collect();
    assert!(flights.len() >= 2, "{flights:?}");
    for row in flights {
        let (start, end, speed) = (run.history().time(row), run.history().time(row + 1), run.history().column(1)[row]);
        let mut state = [0.0; 3];
        run.interpolate((start + end) / 2.0, &mut state);
        let height = speed * speed / (2.0 * 9.8);
        assert!((state[0] - height).abs() < 1e-9, "row {row}: {} for {height}", state[0]);
    }
}
