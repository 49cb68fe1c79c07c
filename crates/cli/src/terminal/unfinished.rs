//! Cleanup of temporary files and folders when the program is interrupted.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

/// Temporary files and folders that exist at present.
static FILES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
static WATCH: Once = Once::new();

/// Exit code of a program ended by a signal: by convention 128 plus the number of SIGINT.
const INTERRUPTED: i32 = 130;

/// Guard of a temporary file or folder. The file is removed if the program is interrupted (Ctrl-C, SIGTERM, SIGHUP)
/// while the guard exists.
#[derive(Debug)]
pub struct Unfinished {
    path: PathBuf,
}

impl Unfinished {
    /// Creates a temporary file or folder together with its guard. The lock is held in between, so that no interruption
    /// can miss it.
    ///
    /// # Errors
    /// The error of `create`.
    pub fn watching<T: AsRef<Path>>(create: impl FnOnce() -> io::Result<T>) -> io::Result<(T, Self)> {
        WATCH.call_once(|| {
            // Without a handler an interruption leaves the file behind, which is better than not writing.
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
