//! Claims of documents about their runs: measured values agree with theory, and failures are explained.

use document::{Document, open};
use engine::checks::{Checking, Measured, Outcome, Verdict, claim_outcome, judge_all};
use program::{Moment, Program};
use std::f64::consts::PI;
use std::path::Path;

/// A spring with angular frequency 2 rad/s and optional damping.
const SPRING: &str = "```model
parameter gamma = 0.1 [1/s] in 0..3
x'' = -4 [1/s^2]*x - 2*gamma*x'
x(0) = 1 [m]
x'(0) = 0 [m/s]
E = x'^2/2 + 2 [1/s^2]*x^2 in [J/kg]
discrete n = 0
when x < 0 [m] { n = n + 1 }
motion = if x > 0 then \"right\" else \"left\"
```
";

fn document(front: &str, checks: &str) -> Document {
    let opened = open(&format!("---\n{front}\n---\n{SPRING}```check\n{checks}\n```\n"), &[]);
    assert_eq!(opened.diagnostics, Vec::new());
    opened.document.unwrap()
}

fn judged(front: &str, checks: &str) -> (Program, Vec<Outcome>) {
    let program = document(front, checks).program;
    let outcomes = judge_all(&program).into_iter().flatten().collect();
    (program, outcomes)
}

fn measured(outcome: &Outcome) -> Measured {
    outcome.worst.unwrap().measured.unwrap()
}

#[test]
fn claims_are_read_with_their_setup_and_place() {
    let document = document(
        "title: x",
        "\"First\": x < 2 [m] always # a remark\nset: gamma = 0 [1/s]\n\"Kept\": E within 1e-6 of\n  E(0) always\n\"Late\": x within 1 [mm] of 1 [m] at pi*1 [s]\nset: gamma = 1 [1/s]\n\"Step\": halving  the step changes x by less than 0.1 %",
    );
    let checks = &document.program.checks;
    let shape: Vec<_> = checks.iter().map(|check| (check.setup.len(), check.claims.len())).collect();
    assert_eq!(shape, [(0, 1), (1, 2), (1, 1)]);
    let claims: Vec<_> = checks.iter().flat_map(|check| &check.claims).collect();
    assert_eq!(claims[1].written, "E within 1e-6 of E(0) always");
    assert_eq!(claims[3].written, "halving the step changes x by less than 0.1 %");
    assert_eq!((&claims[0].moment, &claims[3].moment), (&Moment::Always, &Moment::End));
    assert!(matches!(claims[2].moment, Moment::At(_)));
    let written = |place: &model::Span| document.source[place.range()].split(':').next().unwrap().to_owned();
    let names: Vec<_> = document.claims.iter().map(written).collect();
    assert_eq!(names, ["\"First\"", "\"Kept\"", "\"Late\"", "\"Step\""]);
}

#[test]
fn energy_is_kept_without_damping_and_falls_with_it() {
    let claims = "\"Falls\": E within 1 % of E(0) always\nset: gamma = 0 [1/s]\n\"Kept\": E within 1e-6 of E(0) always";
    let (program, outcomes) = judged("step: 0.01 [s]\nuntil: 10 [s]", claims);
    assert!(outcomes[1].held() && !outcomes[0].held());
    // E = E(0) exp(-2 gamma t), apart from oscillations within a period: off by 1 - exp(-2) = 0.8646647 at the end.
    let (worst, off) = (outcomes[0].worst.unwrap(), measured(&outcomes[0]).off);
    assert!(worst.time > 9.0 && (off - 0.864_664_7).abs() < 0.02, "{worst:?}");
    let text = claim_outcome(&program, &program.checks[0].claims[0], &outcomes[0]);
    assert!(text.english().starts_with("at worst 0.2"), "{}", text.english());
    assert!(
        text.english().contains("J/kg at t = ") && text.english().contains("expected 2 J/kg, off by 8"),
        "{}",
        text.english()
    );
    assert!(
        text.english().ends_with(" % (1 % allowed)")
            && text.text(catalogues::with(units::Language::Spanish)).contains("0,2"),
        "{}",
        text.text(catalogues::with(units::Language::Spanish))
    );
}

#[test]
fn moments_between_rows_are_judged_there() {
    // x = cos 2t, which is sqrt(1/2) after 9/8 of the period pi, between two rows.
    let claims = "set: gamma = 0 [1/s]\n\"Eighth\": x within 1e-5 of sqrt(1/2)*x(0) at 9*pi/8*1 [s]\n\"End\": x within 1e-5 of cos(7.03)*1 [m] at end";
    let (_, outcomes) = judged("step: 0.02 [s]\nuntil: 3.515 [s]", claims);
    assert!(outcomes.iter().all(Outcome::held), "{outcomes:?}");
    assert!((outcomes[0].worst.unwrap().time - 9.0 * PI / 8.0).abs() < 1e-12);
    assert!((outcomes[1].worst.unwrap().time - 3.515).abs() < 1e-12);
}

#[test]
fn a_moment_behind_the_end_is_reached_all_the_same() {
    let claims = "set: gamma = 0 [1/s]\n\"Later\": x within 1e-5 of cos(20)*1 [m] at 10 [s]\n\"Counts\": n <= 1 always";
    let (_, outcomes) = judged("step: 0.02 [s]\nuntil: 1 [s]", claims);
    // Up to 1 s the body passes the equilibrium once, up to 10 s three times.
    assert!(outcomes.iter().all(Outcome::held), "{outcomes:?}");
}

#[test]
fn a_fraction_is_one_of_the_greatest_value_where_a_claim_is_for_the_whole_run() {
    // The error of the classical method is near the amplitude times 1e-5 here, also where x passes through 0.
    let claims = "set: gamma = 0 [1/s]\n\"Cosine\": x within 1e-3 of cos(2 [1/s]*t)*1 [m] always\n\"Near 0\": x within 1e-7 of cos(2 [1/s]*t)*1 [m] at pi/4*1 [s]";
    let (_, outcomes) = judged("step: 0.1 [s]\nuntil: 10 [s]", claims);
    assert!(outcomes[0].held() && !outcomes[1].held(), "{outcomes:?}");
    assert!((1e-6..1e-3).contains(&measured(&outcomes[0]).off), "{outcomes:?}");
}

#[test]
fn comparisons_tell_the_worst_and_conditions_the_first_moment() {
    let claims = "set: gamma = 0 [1/s]\n\"Bound\": x <= 1.001 [m] always\n\"Wrong bound\": x > -0.5 [m] always\n\"Both\": x < 2 [m] and x > -0.5 [m] always\n\"Passages\": n == 2 at 5 [s]\n\"Either\": x < 2 [m] or t > 3 [s] always";
    let (program, outcomes) = judged("step: 0.01 [s]\nuntil: 10 [s]", claims);
    let held: Vec<bool> = outcomes.iter().map(Outcome::held).collect();
    assert_eq!(held, [true, false, false, true, true]);
    let Measured { value, expected, off, allowed } = measured(&outcomes[1]);
    assert!((value + 1.0).abs() < 1e-4 && expected == -0.5 && (off - 0.5).abs() < 1e-4 && allowed.is_none());
    // The condition first fails where cos 2t = -1/2, at the next row.
    let first = outcomes[2].worst.unwrap();
    assert!((first.time - (PI / 3.0 / 0.01).ceil() * 0.01).abs() < 1e-9 && first.measured.is_none(), "{first:?}");
    let text = |index: usize| claim_outcome(&program, &program.checks[0].claims[index], &outcomes[index]).english();
    assert_eq!(text(2), "not true at t = 1.05 s");
    assert_eq!(text(3), "2 at t = 5 s, compared with 2");
    assert_eq!(text(4), "true");
}

#[test]
fn halving_the_step_shows_the_order_of_the_method() {
    let claim = "set: gamma = 0 [1/s]\n\"Step\": halving the step changes x by less than 1e-9 always";
    let change = |method: &str, step: f64| {
        let (_, outcomes) = judged(&format!("method: {method}\nstep: {step} [s]\nuntil: 10 [s]"), claim);
        assert!(!outcomes[0].held());
        measured(&outcomes[0]).off
    };
    for (method, order) in [("euler-richardson", 2), ("rk4", 4)] {
        let ratio = change(method, 0.05) / change(method, 0.025);
        let expected = f64::from(1 << order);
        assert!((ratio / expected - 1.0).abs() < 0.15, "{method}: {ratio}");
    }
}

#[test]
fn a_finer_tolerance_takes_the_place_of_half_the_step() {
    let claims = "\"Step\": halving the step changes x by less than 0.01 %\n\"Too much\": halving the step changes x by less than 1e-12 at 3 [s]";
    let (program, outcomes) = judged("method: dormand-prince\nstep: 0.5 [s]\nuntil: 10 [s]\ntolerance: 1e-6", claims);
    assert_eq!(outcomes.iter().map(Outcome::held).collect::<Vec<_>>(), [true, false]);
    let text = claim_outcome(&program, &program.checks[0].claims[1], &outcomes[1]);
    assert!(text.english().contains("with a tenth of the tolerance"), "{}", text.english());
}

#[test]
fn a_run_that_stops_decides_nothing_that_comes_later() {
    let source = "---\nuntil: 3 [s]\nstep: 0.01 [s]\n---\n```model\ny' = y^2/(1 [m s])\ny(0) = 1 [m]\n```\n```check\n\"Before\": y within 1e-4 of 2 [m] at 0.5 [s]\n\"After\": y > 0 [m] at 2 [s]\n\"Always\": y > 0 [m] always\n\"Never\": y < 0 [m] always\n\"Step\": halving the step changes y by less than 1 %\n```\n";
    let opened = open(source, &[]);
    assert_eq!(opened.diagnostics, Vec::new());
    // y = 1/(1 - t), until it is no longer finite.
    let outcomes: Vec<Outcome> = judge_all(&opened.document.unwrap().program).into_iter().flatten().collect();
    assert!(outcomes[0].held(), "{outcomes:?}");
    for index in [1, 2, 4] {
        assert!(matches!(outcomes[index].verdict, Verdict::Stopped(_)), "{:?}", outcomes[index]);
    }
    assert_eq!(outcomes[3].verdict, Verdict::Failed);
}

#[test]
fn work_is_bounded_and_may_be_divided() {
    let endless =
        document("step: 1e-9 [s]\nuntil: 1e9 [s]", "\"Ever\": x < 2 [m] always\n\"Start\": n == 0 at 0 [s]").program;
    let mut checking = Checking::within(3_000_000);
    let mut rounds = 0_u64;
    while !checking.advance(&endless, 100_000) {
        rounds += 1;
    }
    assert!((20..40).contains(&rounds), "{rounds}");
    let verdicts: Vec<_> = checking.outcomes()[0].iter().map(|outcome| outcome.verdict.clone()).collect();
    assert_eq!(verdicts, [Verdict::TooLong, Verdict::Held]);
    let claims = "\"Step\": halving the step changes x by less than 1e-9 always\n\"Kept\": E within 1 % of E(0) at 3 [s]\nset: gamma = 0 [1/s]\n\"Count\": n == 1 at end";
    let program = document("step: 0.01 [s]\nuntil: 10 [s]\nmethod: dormand-prince", claims).program;
    let mut checking = Checking::new();
    while !checking.advance(&program, 100) {}
    assert_eq!(checking.outcomes(), judge_all(&program));
}

/// All documents of Meniscus, including theories, by file name.
fn gallery() -> Vec<(String, Program)> {
    let simulations = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let files = [simulations.clone(), simulations.join("theories")].map(|folder| std::fs::read_dir(folder).unwrap());
    let mut gallery = Vec::new();
    for path in files.into_iter().flatten().map(|entry| entry.unwrap().path()) {
        let name = path.file_name().unwrap().to_str().unwrap();
        if let Some(stem) = name.strip_suffix(".md").filter(|stem| !stem.contains('.')) {
            let opened = open(&std::fs::read_to_string(&path).unwrap(), &[]);
            assert_eq!(opened.diagnostics, Vec::new(), "{name}");
            gallery.push((stem.to_owned(), opened.document.unwrap().program));
        }
    }
    assert!(gallery.len() >= 15, "{}", gallery.len());
    gallery
}

#[test]
fn every_document_that_ships_makes_claims_and_they_hold() {
    let mut report = String::new();
    for (name, program) in gallery() {
        assert!(!program.checks.is_empty(), "{name}: no claims");
        for (check, outcomes) in program.checks.iter().zip(judge_all(&program)) {
            assert_eq!(check.claims.len(), outcomes.len(), "{name}");
            for (claim, outcome) in check.claims.iter().zip(outcomes) {
                let text = claim_outcome(&program, claim, &outcome).english();
                println!("{name}: {}: {}: {text}", claim.name, outcome.held());
                if !outcome.held() {
                    report += &format!("{name}: {}: {text}\n", claim.name);
                }
            }
        }
    }
    assert_eq!(report, "");
}

#[test]
fn an_event_that_ends_the_run_is_its_end() {
    let source = "---\nuntil: 9 [s]\nstep: 0.01 [s]\n---\n```model\ny'' = -2 [m/s^2]\ny(0) = 4 [m]\ny'(0) = 0 [m/s]\nwhen y < 0 [m] { stop }\n```\n```check\n\"Landing\": t within 1e-6 of 2 [s] at end\n\"Above\": y > -0.001 [mm] always\n\"Step\": halving the step changes y' by less than 1e-6\n\"Later\": y < 0 [m] at 3 [s]\n```\n";
    let opened = open(source, &[]);
    assert_eq!(opened.diagnostics, Vec::new());
    let outcomes: Vec<Outcome> = judge_all(&opened.document.unwrap().program).into_iter().flatten().collect();
    assert!(outcomes[..3].iter().all(Outcome::held), "{outcomes:?}");
    assert_eq!(outcomes[3].verdict, Verdict::NotReached);
}
