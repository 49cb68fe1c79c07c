//! Functions that are given by tables, against closed forms.

use crate::support::{model, run, setup};
use engine::{Method, NoticeKind, Run, Setup, Stepper};

/// Linear from (0, 0) over (1, 2) and (3, -1) to (4, -1): v(4) = 1 + 1 - 1 + ..., piece by piece a parabola.
const PUSH: &str = "
table a(t) in [m/s^2] \"Push\" { 0 [s] 0  1 2  3 -1  4 -1 }
v' = a(t)
x' = v
v(0) = 0 [m/s]
x(0) = 0 [m]
";

#[test]
fn a_step_ends_at_each_point_of_a_table() {
    let model = model(PUSH);
    // 1 and 3 s are no multiples of the step.
    let run = run(&model, setup(&model, Method::RungeKutta4, 0.16), 25);
    let history = run.history();
    let end = history.len() - 1;
    let [v, x] = [0, 1].map(|state| history.column(state)[end]);
    assert!((v - 1.0).abs() < 1e-14 && (x - 35.0 / 6.0).abs() < 1e-13, "v = {v}, x = {x}");
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let setup = Setup { tolerance: 1e-10, ..setup(&model, method, 0.16) };
        let mut stepper = Stepper::new(&model, &setup).unwrap();
        stepper.advance_to(4.0).unwrap();
        let [v, x] = [0, 1].map(|state| stepper.state()[state]);
        assert!((v - 1.0).abs() < 5e-8 && (x - 35.0 / 6.0).abs() < 2e-7, "{method:?}: v = {v}, x = {x}");
    }
}

/// A potential of straight lines, U, and the force in it.
const VALLEY: &str = "
parameter m = 1 [kg]
parameter x_0 = 1.5 [m]
steps table F(x) in [N] { -2 [m] 3  -1 1  0 -1  1 -3 }
table U(x) in [J] { -2 [m] 4  -1 1  0 0  1 1  2 4 }
m*x'' = F(x)
x(0) = x_0
x'(0) = 0 [m/s]
E = m*x'^2/2 + U(x)
";

/// x at a time in the first half of the period.
fn valley([m, x_0]: [f64; 2], t: f64) -> f64 {
    let s = t / m.sqrt();
    let steep = (2.0 * (x_0 - 1.0) / 3.0).sqrt();
    let (v_1, v_2) = (3.0 * steep, (9.0 * steep * steep + 2.0).sqrt());
    let flat = v_2 - v_1;
    let at = |begin: f64, x: f64, v: f64, a: f64| x + (s - begin) * (v + a * (s - begin) / 2.0);
    match s {
        s if s < steep => at(0.0, x_0, 0.0, -3.0),
        s if s < steep + flat => at(steep, 1.0, -v_1, -1.0),
        s if s < steep + 2.0 * flat => at(steep + flat, 0.0, -v_2, 1.0),
        _ => at(steep + 2.0 * flat, -1.0, -v_1, 3.0),
    }
}

#[test]
fn a_body_in_a_valley_of_straight_slopes_keeps_its_energy_and_its_period() {
    let model = model(VALLEY);
    let steep = (1.0_f64 / 3.0).sqrt();
    let period = 4.0 * (steep + 5.0_f64.sqrt() - 3.0_f64.sqrt());
    let run = run(&model, setup(&model, Method::RungeKutta4, period / 64.0), 64);
    let history = run.history();
    let energy = model.lookup("E", 0).unwrap().node;
    let mut energies = engine::Readings::new(&model, &[energy]);
    for row in 0..history.len() {
        let energy = energies.at_row(history, row)[0];
        assert!((energy - 2.5).abs() < 1e-12, "{energy} J at {} s", history.time(row));
        let t = history.time(row);
        let x = history.column(0)[row];
        let expected = if t <= period / 2.0 { valley([1.0, 1.5], t) } else { valley([1.0, 1.5], period - t) };
        assert!((x - expected).abs() < 1e-11, "{x} for {expected} m at {t} s");
    }
    assert_eq!(run.notices(), []);
}

#[test]
fn sensitivities_jump_where_a_table_does() {
    for t in [0.3, 0.8, 1.3, 1.9] {
        crate::sensitivities::check(VALLEY, &[1.0, 1.5], &[t], |p, t| valley([p[0], p[1]], t), 1e-6);
    }
}

#[test]
fn outside_its_points_a_table_keeps_its_last_value_and_the_run_says_so() {
    let model = model(PUSH);
    let mut run = run(&model, setup(&model, Method::RungeKutta4, 0.16), 25);
    assert!(run.notices().is_empty(), "the last point is not outside");
    let last = run.history().len() - 1;
    for _ in 0..5 {
        run.advance().unwrap();
    }
    let notices = run.notices();
    assert_eq!(notices.len(), 1);
    assert_eq!(notices[0].kind, NoticeKind::OutsideTable(0));
    assert!((notices[0].time - 4.16).abs() < 1e-12);
    let end = run.history().len() - 1;
    assert!((run.history().column(0)[end] - (1.0 - 0.8)).abs() < 1e-13, "with -1 m/s² on");
    run.truncate(last);
    assert_eq!(run.notices(), []);
}

#[test]
fn a_table_of_many_points_does_not_slow_the_steps_down_to_a_halt() {
    // A sine by 5,000 points, whose integral is 1 - cos t.
    let points: String =
        (0..5000).map(|number| f64::from(number) / 500.0).map(|t| format!("{t:?} {:?}\n", libm::sin(t))).collect();
    let model = model(&format!("smooth table s(tau) {{ {points} }}\ny' = s(t/1 [s])/1 [s]\ny(0) = 0"));
    let mut run = Run::start(&model, setup(&model, Method::RungeKutta4, 0.05)).unwrap();
    for _ in 0..190 {
        run.advance().unwrap();
    }
    let end = run.history().len() - 1;
    let (t, y) = (run.history().time(end), run.history().column(0)[end]);
    assert!((y - (1.0 - libm::cos(t))).abs() < 1e-6, "{y} at {t}");
}
