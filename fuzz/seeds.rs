//! Writes what fuzzing begins with: the simulations with their translations as documents, as bundles and, block by block, as models; the films and
//! projects of the tests; simulations of EJS in both formats; old workbooks; hand-ins; a sheet of answers; what an archive of phyphox has in its files;
//! and files of measuring instruments.
//! `cargo run --manifest-path fuzz/Cargo.toml --bin seeds`

#[path = "../crates/analysis/tests/all/support/old_workbook.rs"]
mod old_workbook;
#[path = "../crates/ejss/tests/all/support.rs"]
#[allow(dead_code, reason = "the tests of the crate use the rest")]
mod simulation;

use class::verify::hand_in;
use old_workbook::{Cell, OldWorkbook};
use saved::carried::carry;
use saved::hand_in::Sender;
use saved::project::Project;
use simulation::Simulation;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// A sheet with each kind of item.
const SHEET: &str = r#"{"meniscus survey":1,"document":"U-tube","items":[
{"name":"a","kind":"role","asked":"You are a","words":["student","teacher"],"of":2,"chosen":2},
{"name":"b","kind":"scale","asked":"It was clear","words":["no","yes"],"of":5,"chosen":4},
{"name":"c","kind":"choice","asked":"Best","words":["plots","fit"],"of":2},
{"name":"d","kind":"text","asked":"Why?","typed":"Las gráficas no se leen <b>bien</b>\n=1+1"}
]}
"#;

fn main() -> io::Result<()> {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR"));
    for target in [
        "bundle",
        "data_sets",
        "document",
        "ejs",
        "film",
        "hand_in",
        "import",
        "language",
        "old_workbook",
        "survey",
        "tracker",
    ] {
        fs::create_dir_all(fuzz.join("corpus").join(target))?;
    }
    let write = |target: &str, name: &str, bytes: &[u8]| fs::write(fuzz.join("corpus").join(target).join(name), bytes);
    let simulations = fuzz.join("../simulations");
    for path in files(&simulations)?.into_iter().filter(|path| path.extension().is_some_and(|kind| kind == "md")) {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let Ok(text) = fs::read_to_string(&path) else { continue };
        if name.contains('.') {
            continue;
        }
        let translation = fs::read_to_string(simulations.join(format!("{name}.es.md"))).unwrap_or_default();
        write("document", &name, format!("{text}\n=====\n{translation}").as_bytes())?;
        let model: String = text.split("```model\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
        write("language", &name, model.as_bytes())?;
        if let Some(document) = document::open(&text, &[&translation]).document
            && let Ok(bundle) = program::bundle::write(&document.program)
        {
            write("bundle", &name, &bundle)?;
        }
    }
    for path in files(&fuzz.join("seeds/language"))? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path)?;
        write("language", &name, text.as_bytes())?;
        write("document", &name, format!("```model\n{text}```\n").as_bytes())?;
    }
    for target in ["data_sets", "import"] {
        for path in files(&fuzz.join("seeds").join(target))? {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            write(target, &name, &fs::read(&path)?)?;
        }
    }
    for (name, text) in hand_ins(fuzz)? {
        let page = "<html><body><h1>a</h1><footer></footer></body></html>";
        write("hand_in", &name, text.as_bytes())?;
        write("hand_in", &format!("{name}.html"), carry(page, text.as_bytes(), units::Language::English).as_bytes())?;
    }
    write("survey", "sheet", SHEET.as_bytes())?;
    for five in [false, true] {
        let workbook = workbook(five);
        write("old_workbook", &format!("file-{five}"), &workbook.bytes())?;
        write("old_workbook", &format!("stream-{five}"), &workbook.stream())?;
    }
    for path in files(&fuzz.join("../crates/ejss/tests/simulations"))? {
        if path.extension().is_some_and(|kind| kind == "txt") {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let simulation = Simulation::read(&fs::read_to_string(&path)?);
            write("ejs", &format!("{name}.ejss"), simulation.ejss().as_bytes())?;
            write("ejs", &format!("{name}.json"), simulation.json().as_bytes())?;
        }
    }
    for path in files(&fuzz.join("../crates/film/tests/films"))? {
        if path.extension().is_some_and(|kind| kind != "csv" && kind != "sh") {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            write("film", &name, &fs::read(&path)?)?;
        }
    }
    for path in files(&fuzz.join("../crates/analysis/tests/tracker"))? {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        write("tracker", &name, &fs::read(&path)?)?;
    }
    Ok(())
}

/// Hand-ins of each theory: one without records, and one with the records and fits of the tests.
fn hand_ins(fuzz: &Path) -> io::Result<Vec<(String, String)>> {
    let mut stored = Vec::new();
    for path in files(&fuzz.join("../crates/desk/tests/all/stored"))? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        stored.push((name, fs::read_to_string(&path)?.trim().to_owned()));
    }
    // Records come before the fits that need them.
    stored.sort_by_key(|(name, _)| !name.contains("record"));
    let mut hand_ins = Vec::new();
    for path in files(&fuzz.join("../simulations/theories"))? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path)?;
        for items in [Vec::new(), stored.clone()] {
            let name = format!("{name}-{}", items.len());
            let documents = vec![document::page::Source { name: "a.md".to_owned(), text: text.clone() }];
            let work = Project { documents, items, ..Project::default() };
            let sender = Sender { name: "blue heron".to_owned(), ..Sender::default() };
            hand_ins.extend(hand_in(work, sender, 5, "0.1.0").ok().map(|made| (name, made.write())));
        }
    }
    Ok(hand_ins)
}

/// A workbook with each kind of cell.
fn workbook(five: bool) -> OldWorkbook {
    let mut cells = vec![(0, 0, Cell::Label("t (s)")), (0, 1, Cell::Label("y (cm)"))];
    if !five {
        cells.push((0, 2, Cell::Shared(0)));
    }
    for row in 1..6 {
        cells.push((row, 0, Cell::Number(0.1 * f64::from(row))));
        cells.push((row, 1, Cell::Formatted(2.5, row)));
        cells.push((row, 2, Cell::Rks(vec![0x4059_0000, 402, 40001])));
        cells.push((row, 5, Cell::Formula(1.5_f64.to_le_bytes())));
    }
    cells.push((6, 0, Cell::Rk(0x4059_0001)));
    cells.push((6, 1, Cell::TextFormula("end")));
    cells.push((6, 2, Cell::Code(42, 1)));
    OldWorkbook {
        sheets: vec![("Data", cells), ("Second", vec![(0, 0, Cell::Number(1.0))])],
        texts: vec![vec![("v (m/", false), ("s)", true)]],
        five,
        ..OldWorkbook::default()
    }
}

fn files(directory: &Path) -> io::Result<Vec<PathBuf>> {
    fs::read_dir(directory)?.map(|entry| Ok(entry?.path())).collect()
}
