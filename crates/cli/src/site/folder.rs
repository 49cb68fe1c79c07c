//! The output folder of a site. The written files are listed in a file in it, so that the next build replaces only
//! these.

use super::files::Files;
use super::names::WORKER;
use crate::failure::Failure;
use crate::terminal::unfinished::Unfinished;
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use tempfile::Builder;

/// Name of the list of the site's files, by which the folder is recognised.
const LIST: &str = "meniscus-site.json";

/// A folder that may be written to.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    exists: bool,
    /// Files of the last build.
    before: BTreeSet<String>,
}

impl Folder {
    /// Opens the folder `path`: a new one, an empty one, or one of an earlier build.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let failure = |error: io::Error| Failure::file("write", path, &error);
        let mut entries = match fs::read_dir(path) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                return Ok(Self { path: path.to_owned(), exists: false, before: BTreeSet::new() });
            }
            Err(error) => return Err(failure(error)),
        };
        // A link to a folder is kept; its target is written.
        let path = path.canonicalize().map_err(failure)?;
        let before = match fs::read_to_string(path.join(LIST)) {
            Ok(list) => serde_json::from_str(&list).map_err(|_| {
                let list = path.join(LIST);
                Failure::with_hint(format!("{} is damaged", list.display()), "empty the folder, or choose another one")
            })?,
            Err(_) if entries.next().is_none() => BTreeSet::new(),
            Err(_) => {
                return Err(Failure::with_hint(
                    format!("{} is not empty, and not a site that `meniscus build` has made", path.display()),
                    "choose a new folder, or empty this one",
                ));
            }
        };
        Ok(Self { path, exists: true, before })
    }

    /// Writes the files. All are first written to a temporary folder beside this one. Then each is moved into place:
    /// shared files, pages that need them, and the service worker last. Files that only the last build had are removed.
    /// Every page is therefore complete at any time.
    pub fn publish(self, files: &Files) -> Result<(), Failure> {
        let now: BTreeSet<String> = files.iter().map(|(path, _)| path.to_owned()).collect();
        self.refuse_foreign(&now)?;
        let failure = |error: io::Error| Failure::file("write", &self.path, &error);
        let parent = self.path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::create_dir_all(parent).map_err(failure)?;
        let mut builder = Builder::new();
        builder.prefix(".meniscus-");
        #[cfg(unix)]
        builder.permissions(<fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o777));
        let (fresh, _unfinished) = Unfinished::watching(|| builder.tempdir_in(parent)).map_err(failure)?;
        for (path, content) in files.iter() {
            write(&fresh.path().join(path), content).map_err(failure)?;
        }
        let list =
            |files: &BTreeSet<String>| serde_json::to_string_pretty(files).map_err(|error| failure(error.into()));
        write(&fresh.path().join(LIST), list(&now)?.as_bytes()).map_err(failure)?;
        if !self.exists {
            return fs::rename(fresh.path(), &self.path).map_err(failure);
        }
        // If the build is interrupted, the next one knows the files of both builds.
        let both = self.before.union(&now).cloned().collect();
        fs::write(self.path.join(LIST), list(&both)?).map_err(failure)?;
        for path in in_order(&now) {
            replace(&fresh.path().join(path), &self.path.join(path)).map_err(failure)?;
        }
        for path in self.before.difference(&now) {
            self.remove(path).map_err(failure)?;
        }
        replace(&fresh.path().join(LIST), &self.path.join(LIST)).map_err(failure)
    }

    /// Refuses to replace files that no build has written, and to write through links that lead out of the folder.
    fn refuse_foreign(&self, now: &BTreeSet<String>) -> Result<(), Failure> {
        for path in now.union(&self.before) {
            let Some(place) = self.place(path) else {
                return Err(Failure::with_hint(
                    format!("{path} does not lie in {}", self.path.display()),
                    "a link leads out of the folder, or its list of files was changed; choose a new folder",
                ));
            };
            if !self.before.contains(path) && place.symlink_metadata().is_ok() {
                return Err(Failure::with_hint(
                    format!("{} is there, and `meniscus build` has not made it", place.display()),
                    "move it away, or choose another folder",
                ));
            }
        }
        Ok(())
    }

    /// Path of a file of the site; `None` if it is not inside the folder.
    fn place(&self, path: &str) -> Option<PathBuf> {
        let mut place = self.path.clone();
        for part in Path::new(path).components() {
            let Component::Normal(name) = part else { return None };
            if place != self.path && place.is_symlink() {
                return None;
            }
            place.push(name);
        }
        (place != self.path).then_some(place)
    }

    /// Removes a file of the last build and the folders that become empty.
    fn remove(&self, path: &str) -> io::Result<()> {
        let place = self.path.join(path);
        match fs::remove_file(&place) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        for folder in place.ancestors().skip(1).take_while(|folder| *folder != self.path) {
            if fs::remove_dir(folder).is_err() {
                break;
            }
        }
        Ok(())
    }
}

fn write(path: &Path, content: &[u8]) -> io::Result<()> {
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent)?;
    }
    fs::write(path, content)
}

/// Moves a file into place. A file with the same content is kept, so that its modification time does not change.
fn replace(fresh: &Path, place: &Path) -> io::Result<()> {
    if let Some(parent) = place.parent() {
        fs::create_dir_all(parent)?;
    }
    if fs::read(place).ok() == Some(fs::read(fresh)?) {
        return Ok(());
    }
    fs::rename(fresh, place)
}

/// Order of publication: shared files, pages, service worker.
fn in_order(files: &BTreeSet<String>) -> Vec<&String> {
    let mut files: Vec<&String> = files.iter().collect();
    files.sort_by_key(|path| (path.starts_with(WORKER), !path.starts_with("assets/")));
    files
}
