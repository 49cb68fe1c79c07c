//! Temporary files that must not stay behind when the program is interrupted.

use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use tempfile::NamedTempFile;

/// The temporary files that exist now.
static FILES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
static WATCH: Once = Once::new();

/// The exit code of a program that a signal has ended, by convention 128 and the number of SIGINT.
const INTERRUPTED: i32 = 130;

/// A temporary file that is removed if the program is interrupted (Ctrl-C, SIGTERM, SIGHUP) while this exists.
#[derive(Debug)]
pub struct Unfinished {
    path: PathBuf,
}

impl Unfinished {
    /// Creates a temporary file and watches over it, without a moment in between.
    ///
    /// # Errors
    /// Those of `create`.
    pub fn watching(create: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<(NamedTempFile, Self)> {
        WATCH.call_once(|| {
            // Without a handler an interruption leaves the file behind, which harms less than not writing at all.
            let _ = ctrlc::set_handler(|| {
                for path in files().iter() {
                    let _ = std::fs::remove_file(path);
                }
                std::process::exit(INTERRUPTED);
            });
        });
        let mut files = files();
        let file = create()?;
        let path = file.path().to_owned();
        files.push(path.clone());
        Ok((file, Self { path }))
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        files().retain(|path| *path != self.path);
    }
}

fn files() -> MutexGuard<'static, Vec<PathBuf>> {
    FILES.lock().unwrap_or_else(PoisonError::into_inner)
}
