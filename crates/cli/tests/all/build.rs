//! `meniscus build`: the site of a folder of documents.

use crate::common::{SPRING, directory_with, meniscus, names};
use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::Path;
use std::sync::LazyLock;

const SPANISH: &str =
    "---\ntitle: Un muelle\nlanguage: es\ntranslates: spring.md\n---\n\nUn cuerpo cuelga de un muelle.\n";

/// A temporary folder with two documents, one in two languages and one in a subfolder.
fn documents() -> tempfile::TempDir {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let put = |name: &str, text: &str| {
        let path = directory.path().join("docs").join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("it can be written");
    };
    put("spring.md", SPRING);
    put("spring.es.md", SPANISH);
    put("más difícil/a & b #1.md", &SPRING.replace("title: A spring", "title: <b>Hard</b> & \"soft\""));
    put("README.md", "# Our simulations\n");
    put("data.csv", "t,x\n0,1\n");
    directory
}

/// Builds the site of these documents beside them.
fn build(directory: &Path) -> crate::common::Done {
    let path = |name: &str| directory.join(name).to_str().expect("UTF-8").to_owned();
    meniscus(&["build", &path("docs"), "--output", &path("site")])
}

/// All files below a folder, by path.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("below it").to_str().expect("UTF-8").to_owned();
                found.insert(name, fs::read(path).expect("a file"));
            }
        }
    }
    found
}

/// Files of the site of these documents. It takes seconds, and most tests begin with it.
static SITE: LazyLock<BTreeMap<String, Vec<u8>>> = LazyLock::new(|| {
    let directory = documents();
    let done = build(directory.path());
    assert_eq!(done.code, 0, "{}", done.stderr);
    assert!(done.stderr.contains("no simulation in it: README.md and data.csv"), "{}", done.stderr);
    assert_eq!(names(directory.path()), ["docs", "site"]);
    contents(&directory.path().join("site"))
});

/// A temporary folder with these documents and their site beside them.
fn built() -> tempfile::TempDir {
    let directory = documents();
    for (name, content) in SITE.iter() {
        let path = directory.path().join("site").join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, content).expect("it can be written");
    }
    directory
}

fn text(files: &BTreeMap<String, Vec<u8>>, name: &str) -> String {
    String::from_utf8(files[name].clone()).expect("UTF-8")
}

/// `llms.txt` names the guide of the language and each page, and all that it names is there.
#[test]
fn language_models_are_told_what_the_site_holds() {
    let files = &*SITE;
    let list = text(files, "llms.txt");
    assert!(list.starts_with("# Simulations made with Meniscus\n\n> "), "{list}");
    assert!(list.contains("- [A spring](spring.html)\n"), "{list}");
    assert!(list.contains("](m%C3%A1s%20dif%C3%ADcil/a%20%26%20b%20%231.html)\n"), "{list}");
    assert_eq!(list.matches("\n- [").count(), 3, "{list}");
    assert_eq!(text(files, "guide.md"), meniscus(&["guide"]).stdout);
    assert!(list.contains("](guide.md)"), "{list}");
}

#[test]
fn each_document_becomes_a_page_and_a_card() {
    let files = &*SITE;
    let pages: Vec<&String> = files.keys().filter(|name| name.ends_with(".html")).collect();
    assert_eq!(pages, ["index.html", "laboratory.html", "más difícil/a & b #1.html", "spring.html"]);
    let index = text(files, "index.html");
    for part in [
        "<a href=\"spring.html\">A spring</a>",
        "<a href=\"spring.html\">Un muelle</a>",
        "<a href=\"spring.html?language=es\" lang=\"es\" hreflang=\"es\">Español</a>",
        "<a class=\"laboratory\" href=\"laboratory.html#1&amp;d=spring.md\">Open in the laboratory</a>",
        "<a href=\"m%C3%A1s%20dif%C3%ADcil/a%20%26%20b%20%231.html\">&lt;b&gt;Hard&lt;/b&gt; &amp; &quot;soft&quot;</a>",
        "<p>Un cuerpo cuelga de un muelle.</p>",
        "<h2>Más difícil</h2>",
    ] {
        assert!(index.contains(part), "{part} in {index}");
    }
    let deep = text(files, "más difícil/a & b #1.html");
    assert!(deep.contains("<title>&lt;b&gt;Hard&lt;/b&gt;"), "its title");
    assert!(
        deep.contains("href=\"../laboratory.html#1&amp;d=m%C3%A1s%20dif%C3%ADcil/a%20%26%20b%20%231.md\""),
        "the laboratory"
    );
    assert!(deep.contains("data-worker=\"../sw.js\""), "the service worker");
    // The documents of the laboratory are a script of their own, with the list as a text.
    let library = files.keys().find(|name| name.starts_with("assets/library-") && name.ends_with(".js")).unwrap();
    assert!(text(files, "laboratory.html").contains(&format!("data-script=\"{library}\"")));
    let documents = text(files, library);
    let has = |name: &str| documents.contains(&format!("\\\"name\\\":\\\"{name}\\\""));
    assert!(has("spring.es.md") && has("theories/linear.md"));
    assert!(!has("utube.md"), "only theories are taken along");
}

#[test]
fn no_page_has_a_script_of_its_own_or_names_another_host() {
    for name in SITE.keys().filter(|name| name.ends_with(".html")) {
        let page = text(&SITE, name);
        for tag in page.split("<script").skip(1).map(|rest| rest.split('>').next().unwrap_or_default()) {
            assert!(tag.contains(" src=\"") || tag.contains("type=\"application/"), "{name}: <script{tag}>");
        }
        for address in page.split(" src=\"").chain(page.split("<link")).skip(1) {
            let address = address.split("href=\"").last().unwrap_or_default();
            assert!(!address.starts_with("http") && !address.starts_with("//"), "{name}: {address:.80}");
        }
        assert!(page.contains("script-src 'self' 'wasm-unsafe-eval';"), "{name}: its policy");
    }
}

#[test]
fn texts_are_there_compressed_as_well() {
    let files = &*SITE;
    for ending in [".gz", ".br"] {
        let packed: Vec<_> = files.iter().filter(|(name, _)| name.ends_with(ending)).collect();
        assert!(packed.len() >= 10, "{packed:?}");
        for (name, content) in packed {
            let mut text = Vec::new();
            match ending {
                ".gz" => flate2::read::GzDecoder::new(content.as_slice()).read_to_end(&mut text).expect("gzip"),
                _ => brotli::Decompressor::new(content.as_slice(), 4096).read_to_end(&mut text).expect("Brotli"),
            };
            assert_eq!(files.get(name.trim_end_matches(ending)), Some(&text), "{name}");
        }
    }
    let module = files.iter().find(|(name, _)| name.starts_with("assets/player-") && name.ends_with(".bin"));
    assert_eq!(module.map(|(_, content)| &content[..2]), Some([0x1f, 0x8b].as_slice()), "gzip itself");
}

#[test]
fn the_same_documents_give_the_same_bytes() {
    let directory = built();
    assert_eq!(build(directory.path()).code, 0);
    assert!(contents(&directory.path().join("site")) == *SITE, "over the last build");
    let directory = documents();
    build(directory.path());
    assert!(contents(&directory.path().join("site")) == *SITE, "alone");
}

#[test]
fn a_new_build_replaces_the_last_one_and_nothing_else() {
    let directory = built();
    let site = directory.path().join("site");
    fs::write(site.join("CNAME"), "example.org").expect("it can be written");
    fs::remove_dir_all(directory.path().join("docs/más difícil")).expect("it is there");
    fs::write(directory.path().join("docs/spring.md"), SPRING.replace("title: A spring", "title: Another"))
        .expect("it can be written");
    let worker = fs::read(site.join("sw.js")).expect("a file");
    let done = build(directory.path());
    assert_eq!(done.code, 0, "{}", done.stderr);
    let files = contents(&site);
    assert!(!site.join("más difícil").exists());
    assert!(text(&files, "index.html").contains(">Another</a>"));
    assert_eq!(text(&files, "CNAME"), "example.org");
    assert_ne!(files["sw.js"], worker, "browsers notice the change by it");
    // No file of the last build remains.
    fs::remove_dir_all(&site).expect("it is there");
    build(directory.path());
    let mut fresh = contents(&site);
    fresh.insert("CNAME".to_owned(), b"example.org".to_vec());
    assert_eq!(files, fresh);
}

#[test]
fn an_error_in_a_document_leaves_the_site_as_it_was() {
    let directory = built();
    let before = contents(&directory.path().join("site"));
    fs::write(directory.path().join("docs/broken.md"), SPRING.replace("k*x = 0", "k*y = 0")).expect("written");
    let done = build(directory.path());
    assert_eq!(done.code, 1);
    assert!(done.stderr.contains("broken.md:"), "{}", done.stderr);
    assert_eq!(contents(&directory.path().join("site")), before);
    assert_eq!(names(directory.path()), ["docs", "site"]);
}

#[test]
fn folders_and_files_of_others_are_refused() {
    let directory = documents();
    let site = directory.path().join("site");
    fs::create_dir(&site).expect("a folder");
    fs::write(site.join("thesis.txt"), "years").expect("written");
    let done = build(directory.path());
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("is not empty") && done.stderr.contains("choose a new folder"), "{}", done.stderr);
    assert_eq!(names(&site), ["thesis.txt"]);
    fs::remove_file(site.join("thesis.txt")).expect("it is there");
    assert_eq!(build(directory.path()).code, 0);
    let before = contents(&site);
    fs::write(site.join("new.html"), "mine").expect("written");
    fs::write(directory.path().join("docs/new.md"), SPRING).expect("written");
    let done = build(directory.path());
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("new.html is there"), "{}", done.stderr);
    fs::remove_file(site.join("new.html")).expect("it is there");
    assert_eq!(contents(&site), before);
}

#[cfg(unix)]
#[test]
fn nothing_is_written_or_removed_outside_of_the_site() {
    let directory = built();
    let site = directory.path().join("site");
    let outside = directory.path().join("outside");
    fs::rename(site.join("más difícil"), &outside).expect("it is there");
    std::os::unix::fs::symlink(&outside, site.join("más difícil")).expect("a link");
    let before = contents(&outside);
    let done = build(directory.path());
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("does not lie in"), "{}", done.stderr);
    assert_eq!(contents(&outside), before);
    fs::remove_file(site.join("más difícil")).expect("it is there");
    fs::write(directory.path().join("secret"), "kept").expect("written");
    fs::write(site.join("meniscus-site.json"), "[\"../secret\", \"index.html\"]").expect("written");
    assert_eq!(build(directory.path()).code, 2);
    assert!(directory.path().join("secret").exists());
}

#[test]
fn names_that_cannot_be_pages_are_refused() {
    for (name, words) in [
        ("index.md", "a place that the site needs"),
        ("Laboratory.md", "a place that the site needs"),
        ("Spring.md", "one page on some hosts"),
        ("a\tb.md", "control character"),
    ] {
        let directory = documents();
        let path = directory.path().join("docs").join(name);
        // Some systems refuse such names, or do not distinguish two of them.
        if path.exists() || fs::write(path, SPRING).is_err() {
            continue;
        }
        let done = build(directory.path());
        assert_eq!(done.code, 2, "{name}");
        assert!(done.stderr.contains(words), "{}", done.stderr);
        assert_eq!(names(directory.path()), ["docs"]);
    }
}

#[test]
fn a_folder_without_simulations_makes_no_site() {
    let (directory, path) = directory_with("# No model\n");
    let folder = path.parent().expect("a folder").to_str().expect("UTF-8");
    let site = directory.path().join("site");
    let done = meniscus(&["build", folder, "--output", site.to_str().expect("UTF-8")]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("holds no simulation") && done.stderr.contains("```model"), "{}", done.stderr);
    assert_eq!(names(directory.path()), ["spring.md"]);
}
