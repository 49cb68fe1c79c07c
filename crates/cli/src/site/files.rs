//! The files of a site in memory.

use super::names::FROM_DISK;
use crate::failure::Failure;
use crate::page::gzip;
use brotli::enc::BrotliEncoderParams;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Contents by path, with slashes.
#[derive(Debug, Default)]
pub struct Files(BTreeMap<String, Vec<u8>>);

impl Files {
    /// Adds a file.
    pub fn add(&mut self, path: impl Into<String>, content: impl Into<Vec<u8>>) {
        self.0.insert(path.into(), content.into());
    }

    /// Adds a file that pages share and returns its path. The name contains the hash of the content, so that browsers
    /// may cache it forever.
    pub fn share(&mut self, name: &str, ending: &str, content: impl Into<Vec<u8>>) -> String {
        let content = content.into();
        let hash = hash(&content);
        let path = format!("assets/{name}-{}.{ending}", hash.get(..16).unwrap_or(&hash));
        self.add(path.clone(), content);
        path
    }

    /// All files by their paths.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.0.iter().map(|(path, content)| (path.as_str(), content.as_slice()))
    }

    /// Total size of all files in bytes.
    pub fn size(&self) -> usize {
        self.0.values().map(Vec::len).sum()
    }

    /// Adds a gzip and a Brotli version of each text file, for servers that deliver such files directly.
    pub fn compress(&mut self) -> Result<(), Failure> {
        let mut packed = Vec::new();
        for (path, content) in self.iter().filter(|(path, _)| is_text(path)) {
            packed.push((format!("{path}.gz"), gzip(content)?));
            packed.push((format!("{path}.br"), brotli(content)?));
        }
        self.0.extend(packed);
        Ok(())
    }
}

/// Compresses with Brotli at the highest level.
fn brotli(content: &[u8]) -> Result<Vec<u8>, Failure> {
    let mut packed = Vec::new();
    match brotli::BrotliCompress(&mut &*content, &mut packed, &BrotliEncoderParams::default()) {
        Ok(_) => Ok(packed),
        Err(error) => Err(Failure::request(format!("the site cannot be compressed: {error}"))),
    }
}

fn is_text(path: &str) -> bool {
    let texts = [".html", ".css", ".js"];
    texts.iter().any(|ending| path.ends_with(ending)) && !path.ends_with(FROM_DISK)
}

/// SHA-256 in hexadecimal digits.
pub fn hash(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}
