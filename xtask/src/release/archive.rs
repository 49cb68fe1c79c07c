//! Archives with the same bytes for the same files: sorted names, no times, no owners.

use crate::page;
use anyhow::{Context, Result, ensure};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, UNIX_EPOCH};

/// 1 January 1980, the first date of ZIP archives, which other tools accept as well.
const DATE: Duration = Duration::from_secs(315_532_800);

/// Packs files of a folder with `tar`, which Linux, macOS and Windows have, and gzip.
pub fn write(folder: &Path, names: &[PathBuf], archive: &Path) -> Result<()> {
    for name in names {
        // Windows changes times only of files that are opened for writing.
        File::options().append(true).open(folder.join(name))?.set_modified(UNIX_EPOCH + DATE)?;
    }
    let owner: &[&str] = if cfg!(target_os = "linux") {
        &["--owner=0", "--group=0", "--numeric-owner"]
    } else {
        &["--uid", "0", "--gid", "0", "--numeric-owner"]
    };
    let mut tar = Command::new("tar");
    tar.args(["--format", "ustar"]).args(owner).args(["-cf", "-"]).args(names).current_dir(folder);
    let packed = tar.output().context("`tar` cannot be started")?;
    ensure!(packed.status.success(), "tar: {}", String::from_utf8_lossy(&packed.stderr));
    fs::write(archive, page::gzip(&packed.stdout)?).with_context(|| format!("cannot write {}", archive.display()))
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
