//! The independent variable of a record: asked if the file is ambiguous, taken from the document, or chosen.

use crate::support::{bring_back_records, open, utube};
use desk::Desk;

const RESONANCE: &str = "---\ntitle: Resonance\n---\n\n```model\nindependent f in [Hz]\nparameter F = 1 [mm Hz^2]\n\
    parameter f0 = 1 [Hz]\nparameter b = 1 [Hz]\nA = F/sqrt((f0^2 - f^2)^2 + (b*f)^2)\n```\n";

/// The quantities of the columns of the first record.
fn quantities(desk: &Desk) -> Vec<String> {
    desk.records().list().remove(0).columns.into_iter().map(|column| column.quantity).collect()
}

/// The choices of the independent variable of the first record, and which is chosen.
fn choices(desk: &Desk) -> (Vec<String>, Option<usize>) {
    let variables = desk.records().list().remove(0).variables;
    let chosen = variables.iter().position(|choice| choice.chosen);
    (variables.into_iter().map(|choice| choice.text).collect(), chosen)
}

fn text(heads: &str, columns: &[fn(f64) -> f64]) -> Vec<u8> {
    let row = |row: u32| columns.iter().map(|column| column(f64::from(row)).to_string()).collect::<Vec<_>>().join(",");
    format!("{heads}\n{}\n", (0..30).map(row).collect::<Vec<_>>().join("\n")).into_bytes()
}

#[test]
fn an_open_variable_is_asked_for_and_measures_nothing_before() {
    let mut desk = utube();
    let data = text("t [s],y [cm],delay [ms],z [cm]", &[|at| 0.1 * at, libm::sin, |at| 40.0 * at, libm::cos]);
    let id = desk.add_record("a", &data).unwrap();
    let (texts, chosen) = choices(&desk);
    assert_eq!(texts[..2], ["all columns against t", "t, delay, each for its own columns"], "{texts:?}");
    assert_eq!(chosen, None);
    assert!(quantities(&desk).iter().all(String::is_empty) && !desk.measured().has_points());
    assert!(
        desk.records().list()[0].findings.iter().any(|finding| finding.contains("in 2 ways")),
        "{:?}",
        desk.records().list()[0].findings
    );
    // Each choice makes the file a usable record, and is stored for the next visit.
    for reading in [vec![0], vec![0, 2]] {
        desk.change_records(|records, open| records.set_variable(open, id, &reading));
        assert_eq!(quantities(&desk)[..2], ["t", "y"]);
        assert!(desk.measured().has_points() && choices(&desk).1.is_some());
        assert_eq!(choices(&desk).0[..2], texts[..2], "both stay on offer");
        let mut later = utube();
        bring_back_records(&mut later, &desk.records().saved());
        assert_eq!((quantities(&later), choices(&later)), (quantities(&desk), choices(&desk)));
    }
    desk.change_records(|records, open| records.set_variable(open, id, &[9]));
    assert_eq!(quantities(&desk)[..2], ["t", "y"]);
    desk.set_language("es");
    assert!(choices(&desk).0.iter().any(|text| text == "t, delay, cada una para sus columnas"), "{:?}", choices(&desk));
}

#[test]
fn the_document_s_variable_is_found_and_given_back() {
    for heads in ["Nr,f [Hz],A [mm]", "Nr,nu [Hz],A [mm]", ",f,A", "t [s],f [Hz],A [mm]"] {
        let mut desk = open(RESONANCE, &[]);
        let data = text(heads, &[|at| at, |at| 0.5 + 0.1 * at, |at| 3.0 + libm::sin(at)]);
        let id = desk.add_record("a", &data).unwrap();
        assert_eq!(quantities(&desk), ["", "f", "A"], "{heads}");
        assert!(desk.measured().has_points());
        // The user's choice has priority.
        desk.change_records(|records, open| records.set_variable(open, id, &[0]));
        assert_eq!(choices(&desk).1.map(|chosen| choices(&desk).0[chosen].contains("against")), Some(true));
        desk.change_records(|records, open| records.set_variable(open, id, &[1]));
        assert_eq!(quantities(&desk), ["", "f", "A"], "{heads}");
    }
}

#[test]
fn derivatives_follow_another_variable() {
    let mut desk = utube();
    let data = text("t [s],u [s],y [cm]", &[|at| 0.1 * at, |at| 0.3 * at, |at| at * at]);
    let id = desk.add_record("a", &data).unwrap();
    desk.change_records(|records, open| records.set_variable(open, id, &[0]));
    desk.change_records(|records, open| {
        records.make_derivatives(open, id, 2, analysis::derivative::Differentiation::Central)
    })
    .unwrap();
    let slope = |desk: &Desk| desk.records().cells(id, 3, 1..2).remove(0);
    assert_eq!(slope(&desk), "20");
    desk.change_records(|records, open| records.set_variable(open, id, &[1]));
    assert_eq!(slope(&desk), "6.66667");
    assert_eq!(desk.records().list()[0].columns.len(), 5);
}
