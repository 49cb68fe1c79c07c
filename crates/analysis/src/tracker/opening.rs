//! A project on its way from a file, read in slices.

use super::project::{Opened, PackedFilm, Project};
use super::refusal::TrackerError;
use super::xml_reader::XmlReader;
use crate::import;
use crate::packed::{self, Archive, Gathering, Part};

/// The XML of a project may expand to so many bytes. An hour of film at 100 frames/s with five masses has half of it.
const MOST_EXPANDED: u64 = 256 << 20;
/// How many projects of an archive are tried.
const MOST_PROJECTS: usize = 20;

/// A project that is being read.
#[derive(Debug)]
pub struct Opening {
    archive: Option<Archive>,
    /// The projects of the archive that have not been read, the next one last.
    names: Vec<String>,
    /// How many there are.
    projects: usize,
    /// The one that is being read.
    name: String,
    stage: Stage,
    /// Why the first project of the archive was passed over.
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
    /// An archive without a project.
    pub fn new(bytes: Vec<u8>) -> Result<Self, TrackerError> {
        if !packed::is_archive(&bytes) {
            return Ok(Self::of_xml(bytes));
        }
        Self::of_archive(Archive::open(bytes)?).map_err(|_| TrackerError::Damaged)
    }

    /// The same for a text.
    pub(crate) fn of_xml(bytes: Vec<u8>) -> Self {
        let stage = Stage::Xml(Box::new(XmlReader::new(characters(bytes))));
        Self { archive: None, names: Vec::new(), projects: 1, name: String::new(), stage, first: None }
    }

    /// The same for an archive; it is given back where it holds no project.
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

    /// Reads on for about `budget` bytes. Whether it has come to the end. Of several projects in an archive it is the first in
    /// which a mass is marked.
    ///
    /// # Errors
    /// What cannot be read.
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

    /// Which part has been read, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match &self.stage {
            Stage::Next => 0.0,
            Stage::Expanding(part, _) => 0.3 * part.progress(),
            Stage::Xml(reader) => 0.3 + 0.7 * reader.progress(),
            Stage::Finished(_) => 1.0,
        }
    }

    /// What was read, once it is complete.
    pub fn finish(self) -> Option<Opened> {
        let Stage::Finished(project) = self.stage else { return None };
        Some(Opened { project: *project, name: (self.projects > 1).then_some(self.name) })
    }

    /// Looks for the film in the archive: where the project says it is, else anywhere under its name.
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
/// What is no project, or damaged, or marks no mass.
pub fn read(bytes: Vec<u8>) -> Result<Opened, TrackerError> {
    let mut opening = Opening::new(bytes)?;
    while !opening.advance(usize::MAX)? {}
    opening.finish().ok_or(TrackerError::Damaged)
}

/// The bytes of an archive of this length that are needed to read its projects and to find their film, without reading it whole.
pub fn gathering(size: u64) -> Gathering {
    Gathering::new(size, ".trk")
}

/// Whether a file of an archive is a project. macOS adds files with the attributes of others.
fn is_project_file(name: &str) -> bool {
    let ends = name.len() > 4 && name.as_bytes()[name.len() - 4..].eq_ignore_ascii_case(b".trk");
    ends && !name.starts_with("__MACOSX/") && !last(name).starts_with("._")
}

/// A path without its folders.
fn last(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

/// The text in UTF-8: old versions wrote that of the system and called it UTF-8.
fn characters(bytes: Vec<u8>) -> Vec<u8> {
    if core::str::from_utf8(&bytes).is_ok() { bytes } else { import::characters(&bytes).into_owned().into_bytes() }
}
