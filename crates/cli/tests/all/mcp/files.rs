//! What the tools keep to: files below the folder, bounded time and memory, broken input.

use super::client::Client;
use crate::common::{SPRING, directory_with};
use serde_json::json;
use std::fs;

#[test]
fn paths_do_not_lead_out_of_the_folder() {
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret.md"), SPRING).unwrap();
    fs::write(outside.path().join("data.txt"), "t [s] x [m]\n0 1\n1 2\n").unwrap();
    let (directory, _) = directory_with(SPRING);
    fs::create_dir(directory.path().join("sub")).unwrap();
    fs::write(directory.path().join("sub/inner.md"), SPRING).unwrap();
    let mut client = Client::open(directory.path());
    // Below the folder, also by way of `..` and by the whole path.
    let whole = directory.path().join("spring.md").canonicalize().unwrap();
    for path in ["spring.md", "sub/inner.md", "sub/../spring.md", whole.to_str().unwrap()] {
        assert_eq!(client.call("check", json!({ "document": path }))["ok"], true, "{path}");
    }
    let secret = outside.path().join("secret.md").canonicalize().unwrap();
    let up = format!("../{}/secret.md", outside.path().file_name().unwrap().to_str().unwrap());
    for path in [secret.to_str().unwrap(), &up, "../../../../../../etc/passwd", "/etc/passwd", "", ".", "sub"] {
        let why = client.refused("check", json!({ "document": path }));
        assert!(!why.to_string().contains("root:"), "{why}");
        client.refused("run", json!({ "document": path }));
        client.refused("format", json!({ "document": path }));
    }
    for output in ["../out.md", secret.to_str().unwrap(), "/tmp/meniscus-out.md", "none/out.md", "sub", "..", ""] {
        client.refused("format", json!({ "text": SPRING, "output": output }));
        client.refused("run", json!({ "text": SPRING, "output": output }));
    }
    assert_eq!(fs::read_to_string(&secret).unwrap(), SPRING);
    client.close();
}

#[cfg(unix)]
#[test]
fn links_that_lead_out_are_refused() {
    use std::os::unix::fs::symlink;
    let outside = tempfile::tempdir().unwrap();
    let secret = outside.path().join("secret.md");
    fs::write(&secret, SPRING).unwrap();
    let (directory, _) = directory_with(SPRING);
    symlink(&secret, directory.path().join("link.md")).unwrap();
    symlink(outside.path(), directory.path().join("folder")).unwrap();
    symlink(&secret, directory.path().join("spring.es.md")).unwrap();
    symlink("spring.md", directory.path().join("inner.md")).unwrap();
    let mut client = Client::open(directory.path());
    for path in ["link.md", "folder/secret.md"] {
        let why = client.refused("check", json!({ "document": path }));
        assert!(why["error"].as_str().unwrap().contains("outside of the folder"), "{why}");
        client.refused("format", json!({ "text": SPRING, "output": path }));
    }
    client.refused("format", json!({ "text": SPRING, "output": "folder/new.md" }));
    // A link to a file inside is read, and replaced by nothing.
    assert_eq!(client.call("check", json!({ "document": "inner.md" }))["ok"], true);
    client.refused("format", json!({ "text": SPRING, "output": "inner.md" }));
    // A translation that is such a link is no translation.
    assert_eq!(client.call("check", json!({ "document": "spring.md" }))["ok"], true);
    assert_eq!(fs::read_to_string(&secret).unwrap(), SPRING);
    // A device is no file.
    symlink("/dev/zero", directory.path().join("zero.md")).unwrap();
    client.refused("check", json!({ "document": "zero.md" }));
}

#[test]
fn a_document_that_never_ends_is_stopped() {
    let (directory, _) = directory_with(SPRING);
    let mut client = Client::open_for(directory.path(), 1);
    // A run of 10^12 rows, and one whose first row needs as many steps.
    let rows = SPRING.replace("step: 0.1 [s]\nuntil: 2 [s]", "step: 1e-6 [s]\nuntil: 1e6 [s]");
    let steps = SPRING.replace("step: 0.1 [s]\nuntil: 2 [s]", "method: dormand-prince\nstep: 1e9 [s]\nuntil: 1e9 [s]");
    for (text, part) in [(&rows, "was stopped after 1 s"), (&steps, "steps were not enough")] {
        let why = client.refused("run", json!({ "text": text })).to_string();
        assert!(why.contains(part), "{why}");
    }
    client.refused("picture", json!({ "text": rows, "plots": [] }));
    let pictures = client.text("picture", json!({ "text": steps, "plots": [] }));
    assert!(pictures.contains("steps were not enough"), "{pictures}");
    // The server goes on.
    assert_eq!(client.call("check", json!({ "document": "spring.md" }))["ok"], true);
    client.close();
}

#[test]
fn broken_input_does_not_end_the_server() {
    let (directory, _) = directory_with(SPRING);
    let mut client = Client::open(directory.path());
    for line in ["", "{", "[]", "null", "{\"jsonrpc\":\"2.0\"}", "{\"jsonrpc\":\"2.0\",\"method\":7,\"id\":{}}"] {
        client.send(line);
    }
    client.send(&"x".repeat(1 << 20));
    for arguments in [json!({ "text": 5 }), json!({ "run": "yes", "text": SPRING }), json!({})] {
        client.refused("check", arguments);
    }
    client.refused("run", json!({ "text": SPRING, "settings": { "until": "soon" } }));
    client.refused("run", json!({ "text": SPRING, "settings": { "until": 1e300 } }));
    assert_eq!(client.call("check", json!({ "text": SPRING }))["ok"], true);
    client.close();
}
