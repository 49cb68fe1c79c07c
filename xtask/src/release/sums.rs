//! `SHA256SUMS`, and the files of `packaging`, which state addresses and sums.

use super::version::VERSION;
use crate::steps;
use anyhow::{Context, Result};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Templates of `packaging` that are published. `@DOWNLOADS@` becomes the address of the files, `@SUM FILE@` the sum of a file.
const TEMPLATES: [&str; 5] =
    ["install.sh", "install.ps1", "meniscus.rb", "server/compose.yml", "server/meniscus-class.service"];
const SUMS: &str = "SHA256SUMS";

/// Writes the templates whose files are all there, and the sums of everything in the folder.
pub fn write(output: &Path) -> Result<()> {
    let mut sums = sums(output)?;
    for template in TEMPLATES {
        let path = steps::root().join("packaging").join(template);
        let name = template.rsplit('/').next().unwrap_or(template);
        let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        match filled(&text, &sums) {
            Ok(text) => fs::write(output.join(name), text)?,
            Err(missing) => println!("{name} is left out: {missing} is not there"),
        }
    }
    sums = self::sums(output)?;
    let lines: String = sums.iter().map(|(name, sum)| format!("{sum}  {name}\n")).collect();
    fs::write(output.join(SUMS), &lines)?;
    for name in sums.keys() {
        println!("{:>12} {name}", fs::metadata(output.join(name))?.len());
    }
    Ok(())
}

/// Sums of the files in a folder by name, in hexadecimal digits.
fn sums(folder: &Path) -> Result<BTreeMap<String, String>> {
    let mut sums = BTreeMap::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name != SUMS {
            let sum = Sha256::digest(fs::read(entry.path())?);
            sums.insert(name, sum.iter().map(|byte| format!("{byte:02x}")).collect());
        }
    }
    Ok(sums)
}

/// A template with addresses, version and sums; fails with the name of a file that is missing.
fn filled(template: &str, sums: &BTreeMap<String, String>) -> Result<String, String> {
    const DOWNLOADS: &str = concat!(env!("CARGO_PKG_REPOSITORY"), "/releases");
    let mut text = template
        .replace("@DOWNLOADS@", DOWNLOADS)
        .replace("@HOMEPAGE@", env!("CARGO_PKG_HOMEPAGE"))
        .replace("@VERSION@", VERSION);
    while let Some((before, rest)) = text.split_once("@SUM ") {
        let (file, after) = rest.split_once('@').unwrap_or((rest, ""));
        let sum = sums.get(file).ok_or_else(|| file.to_owned())?;
        text = format!("{before}{sum}{after}");
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_template_states_addresses_and_sums() {
        let sums = BTreeMap::from([("a.tar.gz".to_owned(), "12ab".to_owned())]);
        let text = filled("get @DOWNLOADS@/a.tar.gz @SUM a.tar.gz@ of @VERSION@", &sums).unwrap();
        assert!(text.starts_with("get https://") && text.ends_with(&format!("/a.tar.gz 12ab of {VERSION}")), "{text}");
        assert_eq!(filled("@SUM b@", &sums).unwrap_err(), "b");
    }

    /// The list of sums is one that `sha256sum --check` reads.
    #[test]
    fn the_sum_of_a_file_is_that_of_sha256() {
        let folder = steps::target().join("sums-test");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("abc"), "abc").unwrap();
        // FIPS 180-2, appendix B.1.
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sums(&folder).unwrap().get("abc").map(String::as_str), Some(expected));
    }
}
