//! Dropped folders: the files in them, also in folders inside.

use js_sys::{Array, Function, Promise};
use units::order::sort_by_key;
use view::browser;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{DataTransfer, File, FileSystemDirectoryEntry, FileSystemEntry, FileSystemFileEntry};

/// Maximum number of entries that are read.
const MOST_ENTRIES: usize = 20_000;

/// The dropped folders. Must be called in the event of the drop.
pub fn folders(data: &DataTransfer) -> Vec<FileSystemEntry> {
    let items = data.items();
    let entries = (0..items.length()).filter_map(|index| items.get(index)?.webkit_get_as_entry().ok()?);
    entries.filter(FileSystemEntry::is_directory).collect()
}

/// The files in folders, at most 20,000 entries. What cannot be read is left out.
pub async fn files_in(folders: Vec<FileSystemEntry>) -> Vec<File> {
    let (mut open, mut files, mut read) = (folders, Vec::new(), 0);
    while let Some(entry) = open.pop().filter(|_| read < MOST_ENTRIES) {
        read += 1;
        match entry.dyn_into::<FileSystemDirectoryEntry>() {
            Ok(folder) => open.extend(entries_of(&folder).await),
            Err(entry) => {
                let Ok(entry) = entry.dyn_into::<FileSystemFileEntry>() else { continue };
                let found = called(|take, fail| entry.file_with_callback_and_callback(take, fail)).await;
                files.extend(found.and_then(|file| file.dyn_into::<File>().ok()));
            }
        }
    }
    sort_by_key(&mut files, File::name);
    files
}

/// Browsers give at most 100 entries at once.
async fn entries_of(folder: &FileSystemDirectoryEntry) -> Vec<FileSystemEntry> {
    let reader = folder.create_reader();
    let mut all: Vec<FileSystemEntry> = Vec::new();
    while all.len() < MOST_ENTRIES {
        let found = called(|take, fail| reader.read_entries_with_callback_and_callback(take, fail).is_ok()).await;
        let found = found.and_then(|list| list.dyn_into::<Array>().ok()).unwrap_or_default();
        if found.length() == 0 {
            break;
        }
        all.extend(found.iter().filter_map(|entry| entry.dyn_into().ok()));
    }
    all
}

/// Result of a function of the browser with two callbacks; `None` if it fails.
async fn called<T>(mut call: impl FnMut(&Function, &Function) -> T) -> Option<JsValue> {
    let promise = Promise::new(&mut |take, fail| {
        call(&take, &fail);
    });
    browser::wait(promise).await.ok()
}
