//! Image of the class server: the static program, a folder for the store, and nothing else. An archive as `podman load` and
//! `docker load` read it, in the image layout of the Open Container Initiative (OCI), version 1.1.
//!
//! It says what `packaging/server/Containerfile` says, and is written without a container engine, with equal bytes for equal
//! programs.

use super::archive::{self, Owner};
use super::version::VERSION;
use crate::page;
use anyhow::{Context, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};

/// Name under which the image is loaded.
const NAME: &str = "meniscus-class";
/// User and group of the server: those of *nonroot* in other images without a system.
const USER: Owner = Owner(65532);

/// Writes the image of a static program for Linux into a folder.
pub fn write(program: &Path, target: &str, output: &Path) -> Result<()> {
    let folder = crate::steps::target().join("release-image");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    let root = folder.join("root");
    fs::create_dir_all(root.join("data"))?;
    fs::copy(program, root.join("meniscus")).with_context(|| format!("cannot copy {}", program.display()))?;
    let layers =
        [("meniscus", Owner(0)), ("data", USER)].map(|(name, owner)| archive::tar(&root, &[name.into()], owner));

    let mut blobs = Blobs { folder: folder.join("image"), names: vec!["oci-layout".into(), "index.json".into()] };
    fs::create_dir_all(blobs.folder.join("blobs").join("sha256"))?;
    let mut unpacked = Vec::new();
    let mut packed = Vec::new();
    for layer in layers {
        let layer = layer?;
        unpacked.push(digest(&layer));
        packed.push(blobs.add(&page::gzip(&layer)?, "application/vnd.oci.image.layer.v1.tar+gzip")?);
    }
    let config = blobs.add_json(&config(target, &unpacked), "application/vnd.oci.image.config.v1+json")?;
    let manifest_type = "application/vnd.oci.image.manifest.v1+json";
    let manifest = json!({ "schemaVersion": 2, "mediaType": manifest_type, "config": config, "layers": packed });
    let mut manifest = blobs.add_json(&manifest, manifest_type)?;
    manifest["annotations"] = json!({
        "org.opencontainers.image.ref.name": VERSION,
        // The first name is for podman, the second one for containerd, which Docker uses.
        "io.containerd.image.name": format!("docker.io/library/{NAME}:{VERSION}"),
    });
    let index = json!({ "schemaVersion": 2, "manifests": [manifest] });
    fs::write(blobs.folder.join("index.json"), index.to_string())?;
    fs::write(blobs.folder.join("oci-layout"), json!({ "imageLayoutVersion": "1.0.0" }).to_string())?;
    let image = archive::tar(&blobs.folder, &blobs.names, Owner(0))?;
    let path = output.join(format!("{NAME}-{}.tar", architecture(target)));
    fs::write(&path, image).with_context(|| format!("cannot write {}", path.display()))
}

/// Files of an image, named by their sums.
struct Blobs {
    folder: PathBuf,
    names: Vec<PathBuf>,
}

impl Blobs {
    /// Writes one file and returns its description: type, sum and length in bytes.
    fn add(&mut self, bytes: &[u8], media_type: &str) -> Result<Value> {
        let digest = digest(bytes);
        let name = PathBuf::from("blobs").join("sha256").join(&digest["sha256:".len()..]);
        fs::write(self.folder.join(&name), bytes)?;
        self.names.push(name);
        Ok(json!({ "mediaType": media_type, "digest": digest, "size": bytes.len() }))
    }

    fn add_json(&mut self, value: &Value, media_type: &str) -> Result<Value> {
        self.add(value.to_string().as_bytes(), media_type)
    }
}

fn digest(bytes: &[u8]) -> String {
    let sum: String = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
    format!("sha256:{sum}")
}

/// Program that the image starts, its user and its folder. `unpacked` has the sums of the layers before compression.
fn config(target: &str, unpacked: &[String]) -> Value {
    json!({
        "architecture": architecture(target),
        "os": "linux",
        "config": {
            "User": format!("{0}:{0}", USER.0),
            "Entrypoint": ["/meniscus", "class", "serve", "--continue", "--port", "4250"],
            "Cmd": ["/lesson/lesson.md"],
            "WorkingDir": "/data",
            "Volumes": { "/data": {} },
            "ExposedPorts": { "4250/tcp": {} },
            "StopSignal": "SIGINT",
        },
        "rootfs": { "type": "layers", "diff_ids": unpacked },
    })
}

/// Name of a processor as images have it.
fn architecture(target: &str) -> &'static str {
    if target.starts_with("aarch64") { "arm64" } else { "amd64" }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The recipe and the image start the same thing.
    #[test]
    fn the_image_is_that_of_the_recipe() {
        let path = crate::steps::root().join("packaging").join("server").join("Containerfile");
        let recipe = fs::read_to_string(path).unwrap();
        let stated = |word: &str| {
            let line = recipe.lines().find_map(|line| line.strip_prefix(word)).unwrap_or_else(|| panic!("no {word}"));
            line.trim().to_owned()
        };
        let config = config("x86_64-unknown-linux-musl", &[]);
        let config = &config["config"];
        for (word, field) in [("USER", "User"), ("WORKDIR", "WorkingDir"), ("STOPSIGNAL", "StopSignal")] {
            assert_eq!(stated(word), config[field], "{word}");
        }
        for (word, field) in [("ENTRYPOINT", "Entrypoint"), ("CMD", "Cmd")] {
            assert_eq!(serde_json::from_str::<Value>(&stated(word)).unwrap(), config[field], "{word}");
        }
        assert!(config["Volumes"].get(stated("VOLUME")).is_some());
        assert!(config["ExposedPorts"].get(format!("{}/tcp", stated("EXPOSE"))).is_some());
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn an_image_has_the_same_bytes_again() {
        let output = crate::steps::target().join("image-test");
        fs::create_dir_all(&output).unwrap();
        let program = output.join("program");
        fs::write(&program, "not a program").unwrap();
        let image = || {
            write(&program, "aarch64-unknown-linux-musl", &output).unwrap();
            fs::read(output.join("meniscus-class-arm64.tar")).unwrap()
        };
        assert!(image() == image());
    }
}
