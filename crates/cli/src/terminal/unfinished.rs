//! Temporary files and folders that must not stay behind when the program is interrupted.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

/// The temporary files and folders that exist now.
static FILES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
static WATCH: Once = Once::new();

/// The exit code of a program that a signal has ended, by convention 128 and the number of SIGINT.
const INTERRUPTED: i32 = 130;

/// A temporary file or folder that is removed if the program is interrupted (Ctrl-C, SIGTERM, SIGHUP) while this exists.
#[derive(Debug)]
pub struct Unfinished {
    path: PathBuf,
}

impl Unfinished {
    /// Creates a temporary file or folder and watches over it, without a moment in between.
    ///
    /// # Errors
    /// Those of `create`.
    pub fn watching<T: AsRef<Path>>(create: impl FnOnce() -> io::Result<T>) -> io::Result<(T, Self)> {
        WATCH.call_once(|| {
            // Without a handler an interruption leaves the file behind, which harms less than not writing at all.
            let _ = ctrlc::set_handler(|| {
                for path in files().iter() {
                    let _ = std::fs::remove_file(path).or_else(|_| std::fs::remove_dir_all(path));
                }
                std::process::exit(INTERRUPTED);
            });
        });
        let mut files = files();
        let file = create()?;
        let path = file.as_ref().to_owned();
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
