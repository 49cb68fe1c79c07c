//! Tracker project given instead of its film: hint to the film.

use super::opened::refused_with;
use crate::failure::Failure;
use analysis::tracker::{self, Film, Project, TrackerError};
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;
use units::{Words, words};

/// Number of bytes that identify a project.
const LOOK: u64 = 4096;
/// Maximum size of an archive that is searched for its film, bytes.
const MOST_BYTES: u64 = 256 << 20;

/// Failure for a project, with the name of its film; `None` for other or unreadable files.
pub fn refusal(path: &Path) -> Option<Failure> {
    let mut file = File::open(path).ok()?;
    let mut bytes = Vec::new();
    Read::by_ref(&mut file).take(LOOK).read_to_end(&mut bytes).ok()?;
    let is_archive = analysis::workbook::is_workbook(&bytes);
    let is_text = tracker::is_project(&bytes);
    if !is_archive && !is_text {
        return None;
    }
    file.take(MOST_BYTES).read_to_end(&mut bytes).ok()?;
    let project = match tracker::read(bytes) {
        Err(error @ TrackerError::Tabs { .. }) => {
            let error = Arc::new(error);
            let of_hint = error.clone();
            let hint = Words::each(move |language| of_hint.hint(language).to_owned());
            return Some(refused_with(path, Words::each(move |language| error.message(language)), hint));
        }
        read => read.ok().map(|opened| opened.project),
    };
    if project.is_none() && !is_text {
        return None;
    }
    let why = words("it is a project of Tracker, not a film");
    Some(refused_with(path, why, hint(path, project.as_ref())))
}

fn hint(path: &Path, project: Option<&Project>) -> Words {
    let name = path.display();
    let Some(project) = project else {
        return words("give the film itself");
    };
    let Some(Film { path: film, packed, .. }) = project.trackable() else {
        let pictures = project.film.as_ref().filter(|film| !film.path.is_empty()).map(|film| &film.path);
        let why = match pictures {
            Some(pictures) => words!("it names pictures, `{pictures}`, and no film that can be tracked here"),
            None => words("it names no film"),
        };
        return words!(
            "{why}; `meniscus fit` and `meniscus cycles {name}` read its positions",
            name = Words::same(name.to_string())
        );
    };
    let beside = path.parent().unwrap_or_else(|| Path::new("")).join(film.replace('\\', "/"));
    if let Some(packed) = packed {
        let inside = &packed.name;
        words!("its film `{inside}` is in this archive: extract it (unzip {name} '{inside}') and track that")
    } else if beside.is_file() {
        let beside = beside.display();
        words!("its film is beside it: meniscus track {beside}")
    } else {
        words!("its film is `{film}`: give that file")
    }
}
