//! Runs of the program: arguments in, texts and an exit code out.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The program, in the root of the workspace, without colours and in English.
pub fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_meniscus"));
    command.current_dir(root()).env("NO_COLOR", "1").env("LC_ALL", "C").stdin(Stdio::null());
    command
}

/// The root of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the workspace is there")
}

/// Result of a command.
#[derive(Debug)]
pub struct Done {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

/// Runs `meniscus` with these arguments and asserts that it does not panic.
pub fn meniscus(words: &[&str]) -> Done {
    done(program().args(words).output().expect("the program starts"))
}

/// Texts and exit code of a finished command.
pub fn done(output: Output) -> Done {
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    let (stdout, stderr) = (text(output.stdout), text(output.stderr));
    assert!(!stderr.contains("panicked"), "{stderr}");
    Done { code: output.status.code().expect("it ended by itself"), stdout, stderr }
}

/// A document for tests that are not about the U-tube.
pub const SPRING: &str = r#"---
title: A spring
language: en
step: 0.1 [s]
until: 2 [s]
---

A body on a spring.

```model
parameter m = 2 [kg] in 0.5..10 "Mass"
parameter k = 8 [N/m] in 0..100 "Stiffness"
parameter x_0 = 5 [cm] in -20..20 "Start"

m*x'' + k*x = 0

x(0) = x_0 in [cm]
x'(0) = 0

omega = sqrt(k/m)
E = m*x'^2/2 + k*x^2/2 in [J] "Energy"
```

```presets
"Stiff": k = 50 [N/m]
```
"#;

/// A temporary directory with `spring.md` in it.
pub fn directory_with(text: &str) -> (tempfile::TempDir, PathBuf) {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join("spring.md");
    std::fs::write(&path, text).expect("it can be written");
    (directory, path)
}

/// Permissions of a file or folder.
#[cfg(unix)]
pub fn mode(path: &Path) -> u32 {
    let permissions = std::fs::metadata(path).expect("it exists").permissions();
    std::os::unix::fs::PermissionsExt::mode(&permissions) & 0o777
}

/// The names of all files in a directory, sorted.
pub fn names(directory: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(directory).expect("a directory");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// The numbers of a CSV table, row by row, without its header.
pub fn numbers(csv: &str) -> Vec<Vec<f64>> {
    let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
    csv.lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1)
        .map(|line| line.split(',').map(number).collect())
        .collect()
}
