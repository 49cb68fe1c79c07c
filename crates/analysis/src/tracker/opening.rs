//! Reading of a project from a file in slices.

use super::project::{Opened, PackedFilm, Project};
use super::refusal::TrackerError;
use super::xml_reader::XmlReader;
use crate::import;
use packed::{Archive, Gathering, Part};

/// Upper bound of the expanded XML of a project, in bytes. An hour of film at 100 frames/s with five masses has half of it.
const MOST_EXPANDED: u64 = 256 << 20;
/// Upper bound of the projects tried in an archive.
const MOST_PROJECTS: usize = 20;

/// Reading of a project.
#[derive(Debug)]
pub struct Opening {
    archive: Option<Archive>,
    /// Names of the projects in the archive still to be read, the next one last.
    names: Vec<String>,
    /// Number of projects in the archive.
    projects: usize,
    /// Name of the present project.
    name: String,
    stage: Stage,
    /// Error of the first project in the archive that was skipped.
    first: Option<TrackerError>,
}

#[derive(Debug)]
enum Stage {
    Next,
    Expanding(Box<Part>, Vec<u8>),
    Xml(Box<XmlReader>),
    Finished(Box<Project>),
}

impl Opening {
    /// Begins to read a file, XML or an archive.
    ///
    /// # Errors
    /// The archive contains no project.
    pub fn new(bytes: Vec<u8>) -> Result<Self, TrackerError> {
        if !packed::is_archive(&bytes) {
            return Ok(Self::of_xml(bytes));
        }
        Self::of_archive(Archive::open(bytes)?).map_err(|_| TrackerError::Damaged)
    }

    /// Begins to read a project from its XML.
    pub(crate) fn of_xml(bytes: Vec<u8>) -> Self {
        let stage = Stage::Xml(Box::new(XmlReader::new(characters(bytes))));
        Self { archive: None, names: Vec::new(), projects: 1, name: String::new(), stage, first: None }
    }

    /// Begins to read the projects of an archive; returns the archive if it has none.
    pub(crate) fn of_archive(archive: Archive) -> Result<Self, Archive> {
        let mut names: Vec<String> = archive.names().filter(|name| is_project_file(name)).map(str::to_owned).collect();
        if names.is_empty() {
            return Err(archive);
        }
        let projects = names.len();
        names.truncate(MOST_PROJECTS);
        names.reverse();
        Ok(Self { archive: Some(archive), names, projects, name: String::new(), stage: Stage::Next, first: None })
    }

    /// Reads about `budget` more bytes. Returns true at the end. Of several projects in an archive, the first with a marked
    /// mass is read.
    ///
    /// # Errors
    /// No project can be read.
    pub fn advance(&mut self, budget: usize) -> Result<bool, TrackerError> {
        match self.step(budget) {
            Err(error) if self.names.is_empty() => Err(self.first.take().unwrap_or(error)),
            Err(error) => {
                self.first.get_or_insert(error);
                self.stage = Stage::Next;
                Ok(false)
            }
            done => done,
        }
    }

    fn step(&mut self, budget: usize) -> Result<bool, TrackerError> {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Next) {
            Stage::Next => {
                self.name = self.names.pop().ok_or(TrackerError::Damaged)?;
                let archive = self.archive.as_ref().ok_or(TrackerError::Damaged)?;
                Stage::Expanding(Box::new(archive.part(&self.name, Some(MOST_EXPANDED))?), Vec::new())
            }
            Stage::Expanding(mut part, mut bytes) => {
                if part.expand(budget, &mut bytes)? {
                    Stage::Xml(Box::new(XmlReader::new(characters(bytes))))
                } else {
                    Stage::Expanding(part, bytes)
                }
            }
            Stage::Xml(mut reader) => {
                if reader.advance(budget)? {
                    let mut project = reader.finish()?;
                    if project.masses.is_empty() {
                        return Err(TrackerError::NoMass { film: project.trackable().is_some() });
                    }
                    self.find_film(&mut project);
                    Stage::Finished(Box::new(project))
                } else {
                    Stage::Xml(reader)
                }
            }
            Stage::Finished(project) => Stage::Finished(project),
        };
        Ok(matches!(self.stage, Stage::Finished(_)))
    }

    /// Progress, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match &self.stage {
            Stage::Next => 0.0,
            Stage::Expanding(part, _) => 0.3 * part.progress(),
            Stage::Xml(reader) => 0.3 + 0.7 * reader.progress(),
            Stage::Finished(_) => 1.0,
        }
    }

    /// Project that was read; `None` before the end.
    pub fn finish(self) -> Option<Opened> {
        let Stage::Finished(project) = self.stage else { return None };
        Some(Opened { project: *project, name: (self.projects > 1).then_some(self.name) })
    }

    /// Locates the film in the archive: at the stated path, else anywhere under its name.
    fn find_film(&self, project: &mut Project) {
        let (Some(archive), Some(film)) = (&self.archive, &mut project.film) else { return };
        let path = film.path.replace('\\', "/");
        let folder = self.name.rsplit_once('/').map_or(String::new(), |(folder, _)| format!("{folder}/"));
        let stated = format!("{folder}{}", path.trim_start_matches("./"));
        let found = archive.names().find(|name| name.eq_ignore_ascii_case(&stated)).or_else(|| {
            let file = last(&path);
            archive.names().find(|name| !file.is_empty() && last(name).eq_ignore_ascii_case(file))
        });
        film.packed = found.and_then(|name| {
            let stored = archive.stored(name)?;
            let (range, deflated, size) = (stored.range, stored.deflated, stored.expanded);
            Some(PackedFilm { name: name.to_owned(), range, deflated, size })
        });
    }
}

/// Reads a project at once.
///
/// # Errors
/// The file is not a project, is damaged, or marks no mass.
pub fn read(bytes: Vec<u8>) -> Result<Opened, TrackerError> {
    let mut opening = Opening::new(bytes)?;
    while !opening.advance(usize::MAX)? {}
    opening.finish().ok_or(TrackerError::Damaged)
}

/// Requests for the bytes of an archive of this length that are needed to read its projects and to locate their film.
pub fn gathering(size: u64) -> Gathering {
    Gathering::new(size, ".trk")
}

/// True if a file of an archive is a project. macOS adds files with the attributes of others.
fn is_project_file(name: &str) -> bool {
    let ends = name.len() > 4 && name.as_bytes()[name.len() - 4..].eq_ignore_ascii_case(b".trk");
    ends && !name.starts_with("__MACOSX/") && !last(name).starts_with("._")
}

/// Path without its folders.
fn last(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

/// Text in UTF-8; old versions wrote the encoding of the system and declared it as UTF-8.
fn characters(bytes: Vec<u8>) -> Vec<u8> {
    if core::str::from_utf8(&bytes).is_ok() { bytes } else { import::characters(&bytes).into_owned().into_bytes() }
}
