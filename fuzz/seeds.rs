//! Writes what fuzzing begins with: the simulations with their translations as documents, as bundles and, block by block, as models; and the films and projects of the tests.
//! `cargo run --manifest-path fuzz/Cargo.toml --bin seeds`

use std::path::{Path, PathBuf};
use std::{fs, io};

fn main() -> io::Result<()> {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR"));
    for target in ["bundle", "document", "film", "language", "tracker"] {
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

fn files(directory: &Path) -> io::Result<Vec<PathBuf>> {
    fs::read_dir(directory)?.map(|entry| Ok(entry?.path())).collect()
}
