//! Archives with the same bytes for the same files: sorted names, no times, no owners.

use crate::page;
use anyhow::{Context, Result, ensure};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, UNIX_EPOCH};

/// 1 January 1980, the first date of ZIP archives, which other tools accept as well.
const DATE: Duration = Duration::from_secs(315_532_800);

/// Numeric user and group to whom files of an archive belong.
#[derive(Clone, Copy)]
pub struct Owner(pub u32);

/// Packs files of a folder with `tar` and gzip.
pub fn write(folder: &Path, names: &[PathBuf], archive: &Path) -> Result<()> {
    let packed = page::gzip(&tar(folder, names, Owner(0))?)?;
    fs::write(archive, packed).with_context(|| format!("cannot write {}", archive.display()))
}

/// Packs files and empty folders of a folder with `tar`, which Linux, macOS and Windows have.
pub fn tar(folder: &Path, names: &[PathBuf], owner: Owner) -> Result<Vec<u8>> {
    for name in names {
        let path = folder.join(name);
        // Windows changes times only of files that are opened for writing, and Linux opens no folder for writing.
        let opened = if path.is_dir() { File::open(path)? } else { File::options().append(true).open(path)? };
        opened.set_modified(UNIX_EPOCH + DATE)?;
    }
    let [user, group] = if cfg!(target_os = "linux") { ["--owner", "--group"] } else { ["--uid", "--gid"] };
    let mut tar = Command::new("tar");
    tar.args(["--format", "ustar", user, &owner.0.to_string(), group, &owner.0.to_string(), "--numeric-owner"]);
    let packed = tar.args(["-cf", "-"]).args(names).current_dir(folder).output().context("`tar` cannot be started")?;
    ensure!(packed.status.success(), "tar: {}", String::from_utf8_lossy(&packed.stderr));
    Ok(packed.stdout)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_files_give_the_same_bytes() {
        let folder = crate::steps::target().join("archive-test");
        let packed = || {
            fs::create_dir_all(folder.join("a")).unwrap();
            fs::write(folder.join("a").join("b.txt"), "text").unwrap();
            write(&folder, &[PathBuf::from("a/b.txt")], &folder.join("c.tar.gz")).unwrap();
            fs::read(folder.join("c.tar.gz")).unwrap()
        };
        let first = packed();
        fs::remove_dir_all(&folder).unwrap();
        assert!(first == packed() && first.starts_with(&[0x1f, 0x8b]));
    }
}
