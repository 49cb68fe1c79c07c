//! Output of results: the standard output, or a file that appears complete or not at all.

use super::unfinished::Unfinished;
use super::visible::Visible;
use crate::failure::Failure;
use runner::Sources;
use std::fs;
use std::io::{self, BufWriter, IsTerminal, StdoutLock, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// A destination of output. A file does not appear under its name before [`Output::finish`].
#[derive(Debug)]
pub enum Output {
    /// The standard output.
    Standard(BufWriter<StdoutLock<'static>>),
    /// The standard output on a terminal. Control characters of documents and data are escaped.
    Screen(BufWriter<Visible<StdoutLock<'static>>>),
    /// A temporary file beside its target.
    File {
        /// Buffered temporary file.
        writer: BufWriter<NamedTempFile>,
        /// Final path of the file.
        target: PathBuf,
        /// Guard that removes the temporary file if the program is interrupted.
        unfinished: Unfinished,
    },
    /// A device such as /dev/null, which must be written to and not replaced.
    Device {
        /// Open device.
        writer: BufWriter<fs::File>,
        /// Path of the device.
        target: PathBuf,
    },
}

/// True if writing to `path` would overwrite one of the files.
fn is_source(path: &Path, sources: &Sources) -> bool {
    let Ok(path) = path.canonicalize() else {
        return false;
    };
    sources.texts().any(|(file, _)| file.canonicalize().is_ok_and(|own| own == path))
}

impl Output {
    /// The standard output: unchanged bytes to files and other programs, escaped control characters on a terminal.
    pub fn standard() -> Self {
        let output = io::stdout().lock();
        if output.is_terminal() { Self::Screen(BufWriter::new(Visible::new(output))) } else { Self::rendered() }
    }

    /// The standard output for text that is already escaped, such as coloured diagnostics.
    pub fn rendered() -> Self {
        Self::Standard(BufWriter::new(io::stdout().lock()))
    }

    /// The file `path`; `-` is the standard output. Refuses to overwrite the sources of the result.
    pub fn to(path: &Path, sources: &Sources) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Ok(Self::standard());
        }
        if is_source(path, sources) {
            return Err(Failure::request(format!("{} is the document itself; choose another output", path.display())));
        }
        let failure = |error: io::Error| Failure::file("write", path, &error);
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => {
                Err(Failure::request(format!("cannot write {}: it is a directory", path.display())))
            }
            Ok(metadata) if !metadata.is_file() => {
                let device = fs::OpenOptions::new().write(true).open(path).map_err(failure)?;
                Ok(Self::Device { writer: BufWriter::new(device), target: path.to_owned() })
            }
            // A link is kept; its target is replaced.
            Ok(metadata) => {
                Self::beside(path.canonicalize().map_err(failure)?, Some(metadata.permissions())).map_err(failure)
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                Self::beside(path.to_owned(), None).map_err(failure)
            }
            Err(error) => Err(failure(error)),
        }
    }

    fn beside(target: PathBuf, permissions: Option<fs::Permissions>) -> io::Result<Self> {
        let directory = target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut builder = Builder::new();
        builder.prefix(".meniscus-");
        #[cfg(unix)]
        let new_file = <fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666);
        #[cfg(unix)]
        builder.permissions(new_file);
        let (file, unfinished) = Unfinished::watching(|| builder.tempfile_in(directory))?;
        if let Some(permissions) = permissions {
            if permissions.readonly() {
                return Err(io::ErrorKind::PermissionDenied.into());
            }
            file.as_file().set_permissions(permissions)?;
        }
        Ok(Self::File { writer: BufWriter::new(file), target, unfinished })
    }

    /// Failure for an error of writing to this destination.
    pub fn failure(&self, error: &io::Error) -> Failure {
        match self {
            Self::Standard(_) | Self::Screen(_) => Failure::standard_output(error),
            Self::File { target, .. } | Self::Device { target, .. } => Failure::file("write", target, error),
        }
    }

    /// Flushes the output and gives the file its final name.
    pub fn finish(mut self) -> Result<(), Failure> {
        self.flush().map_err(|error| self.failure(&error))?;
        match self {
            Self::Standard(_) | Self::Screen(_) | Self::Device { .. } => Ok(()),
            Self::File { writer, target, unfinished } => {
                let file = writer.into_inner().map_err(|error| Failure::file("write", &target, error.error()))?;
                let named = file.persist(&target).map_err(|error| Failure::file("write", &target, &error.error));
                drop(unfinished);
                named.map(drop)
            }
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Standard(writer) => writer.write(bytes),
            Self::Screen(writer) => writer.write(bytes),
            Self::File { writer, .. } => writer.write(bytes),
            Self::Device { writer, .. } => writer.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Standard(writer) => writer.flush(),
            Self::Screen(writer) => writer.flush(),
            Self::File { writer, .. } => writer.flush(),
            Self::Device { writer, .. } => writer.flush(),
        }
    }
}

/// Writes bytes to a file, which must not be one of the data files, or to the standard output if `path` is `None`.
pub fn deliver(path: Option<&Path>, data: &[PathBuf], bytes: &[u8]) -> Result<(), Failure> {
    match path {
        Some(path) => file(path, data, bytes),
        None => whole(Output::standard(), bytes),
    }
}

/// Writes a complete file, which must not be one of the data files.
pub fn file(path: &Path, data: &[PathBuf], bytes: &[u8]) -> Result<(), Failure> {
    let own = path.canonicalize().ok();
    if own.is_some() && data.iter().any(|data| data.canonicalize().ok() == own) {
        return Err(Failure::request(format!("{} is the data; choose another output", path.display())));
    }
    whole(Output::to(path, &Sources::of_text("", ""))?, bytes)
}

/// Prints to the standard output.
pub fn print(text: &str) -> Result<(), Failure> {
    whole(Output::standard(), text.as_bytes())
}

fn whole(mut output: Output, bytes: &[u8]) -> Result<(), Failure> {
    output.write_all(bytes).map_err(|error| output.failure(&error))?;
    output.finish()
}
