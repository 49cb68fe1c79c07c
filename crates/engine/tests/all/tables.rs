//! Tables, character by character.

use crate::support::{model, setup};
use engine::csv::Dialect;
use engine::table::Table;
use engine::{Method, Run};

const TEXT: &str = r#"
parameter a = 2 [cm/s]
y' = a
y(0) = 0 [m] in [cm]
x = 1e-6 [m]*t/(2 [s]) in [nm]
kind = if t > 0.05 [s] then "late, very" else "early"
late = t > 0.05 [s]
w = ln(t/(1 [s]))
k = 2*a
"#;

fn written(table: &mut Table, run: &Run, dialect: Dialect) -> String {
    let mut text = String::new();
    let mut write = || -> std::fmt::Result {
        table.write_head(dialect, &mut text)?;
        for row in 0..run.history().len() {
            table.write_row(dialect, run.history(), row, &mut text)?;
        }
        Ok(())
    };
    assert!(write().is_ok());
    text
}

fn example() -> (program::Model, Run) {
    let model = model(TEXT);
    let run = crate::support::run(&model, setup(&model, Method::Euler, 0.1), 1);
    (model, run)
}

#[test]
fn csv() {
    let (model, run) = example();
    assert_eq!(
        written(&mut Table::new(&model), &run, Dialect::Lines),
        "t [s],y [cm],x [nm],kind,late,w\n\
         0,0,0,early,false,\n\
         0.1,0.2,50,\"late, very\",true,-2.3025850929940455\n"
    );
}

#[test]
fn chosen_columns() {
    let (model, run) = example();
    let mut table = Table::select(&model, &["k", "y", "a", "y'"]).unwrap();
    assert_eq!(
        written(&mut table, &run, Dialect::Lines),
        "k [m/s],y [cm],a [cm/s],y' [m/s]\n0.04,0,2,0.02\n0.04,0.2,2,0.02\n"
    );
    for (name, near) in [("knd", Some("kind")), ("Y", Some("y")), ("zebra", None)] {
        let unknown = Table::select(&model, &[name]).unwrap_err();
        assert_eq!((unknown.name.as_str(), unknown.near.as_deref()), (name, near));
    }
}

#[test]
fn a_table_shows_the_parameters_in_force() {
    let (model, mut run) = example();
    run.set_parameters(vec![0.05]);
    run.advance().unwrap();
    let mut table = Table::select(&model, &["a", "k"]).unwrap();
    assert_eq!(written(&mut table, &run, Dialect::Lines), "a [cm/s],k [m/s]\n2,0.04\n2,0.04\n5,0.1\n");
}
