//! The documents that ship, with their own method and with all others.

use crate::host::Instance;
use engine::{Method, Run, Setup};
use std::path::PathBuf;
use std::rc::Rc;

/// Texts of all documents by name.
fn documents() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut found = Vec::new();
    for folder in [folder.clone(), folder.join("theories")] {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if name.ends_with(".md") && !name.ends_with(".es.md") {
                found.push((name, std::fs::read_to_string(path).expect("a text")));
            }
        }
    }
    found.sort();
    found
}

/// Compares `rows` rows of an emitted run with an interpreted one. Returns why there is no emitted code, if there is none.
fn compare(name: &str, text: &str, method: Option<Method>, rows: usize) -> Option<String> {
    let document = document::open(text, &[]).document.unwrap_or_else(|| panic!("{name} has errors"));
    let model = &document.program.model;
    let mut setup = Setup::of(&document.program);
    setup.method = method.unwrap_or(setup.method);
    let Ok(mut interpreted) = Run::start(model, setup) else { return Some("no run".to_owned()) };
    let mut emitted = interpreted.clone();
    let listing = match emitted.listing() {
        Ok(listing) => listing,
        Err(reason) => return Some(format!("{reason:?}")),
    };
    let module = match emit::module(&listing) {
        Ok(module) => module,
        Err(reason) => return Some(format!("{reason:?}")),
    };
    emitted.use_compiled(Rc::new(Instance::new(&module, &listing)));
    for row in 0..rows {
        let (one, other) = (interpreted.advance(), emitted.advance());
        assert_eq!(format!("{one:?}"), format!("{other:?}"), "{name}, {method:?}, row {row}");
        assert_eq!(interpreted.work(), emitted.work(), "{name}, {method:?}, row {row}");
        if one.is_err() {
            break;
        }
        if row == rows / 2 {
            // A changed parameter discards steps that are computed in advance.
            let mut parameters = interpreted.parameters().to_vec();
            parameters.iter_mut().take(1).for_each(|parameter| *parameter *= 1.01);
            interpreted.set_parameters(parameters.clone());
            emitted.set_parameters(parameters);
        }
    }
    assert_eq!(interpreted.history().fingerprint(), emitted.history().fingerprint(), "{name}, {method:?}");
    None
}

/// Documents that are interpreted with their own method, with the reason.
const INTERPRETED: [(&str, &str); 5] = [
    ("double-pendulum.md", "LinearSystem"),
    ("gas.md", "TooManyOperations(20356)"),
    ("logistic-map.md", "Counting"),
    ("string.md", "TooManyOperations(11714)"),
    ("van-der-pol.md", "Method(Rosenbrock)"),
];

#[test]
fn the_documents_run_with_the_same_bits_in_emitted_code() {
    let reasons = documents().into_iter().filter_map(|(name, text)| Some((compare(&name, &text, None, 300)?, name)));
    let found: Vec<String> = reasons.map(|(reason, name)| format!("{name}: {reason}")).collect();
    assert_eq!(found, INTERPRETED.map(|(name, reason)| format!("{name}: {reason}")));
}

#[test]
fn each_method_has_the_same_bits_in_emitted_code() {
    let documents = documents();
    let text = |name: &str| &documents.iter().find(|(known, _)| known == name).expect("a document").1;
    for name in ["utube.md", "pendulum.md", "bouncing-ball.md"] {
        for method in Method::ALL.into_iter().filter(|&method| method != Method::Rosenbrock) {
            assert_eq!(compare(name, text(name), Some(method), 300), None, "{name}, {method:?}");
        }
    }
    assert_eq!(
        compare("utube.md", text("utube.md"), Some(Method::Rosenbrock), 1),
        Some("Method(Rosenbrock)".to_owned())
    );
}
