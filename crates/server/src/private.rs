//! Permissions of the files of a class.

use rustix::fs::Mode;
use rustix::process::umask;

/// Files that this process makes from now on, such as stores, backups, exports and reports, can be read and written by their owner
/// alone. Files that exist keep their permissions.
pub fn write_private_files() {
    umask(Mode::RWXG | Mode::RWXO);
}
