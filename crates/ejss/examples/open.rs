//! Writes the documents of simulations into a folder: `cargo run -p ejss --example open FOLDER FILE..`.

#![allow(clippy::expect_used, reason = "an example")]

use std::path::Path;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().expect("a folder");
    for path in arguments {
        let bytes = std::fs::read(&path).expect("a file");
        let mut accepts =
            |text: &str| document::open(text, &[]).first_error().map_or(Ok(()), |error| Err(error.message.english()));
        let stem = Path::new(&path).file_name().and_then(|stem| stem.to_str()).expect("a name");
        match ejss::import(&bytes, &mut accepts) {
            Ok(imported) => {
                let reason = imported.listed_because.map(|why| why.english()).unwrap_or_default();
                let check =
                    accepts(&imported.document).err().map(|error| format!(" CHECK: {error}")).unwrap_or_default();
                let longest = imported
                    .document
                    .lines()
                    .filter(|line| !line.contains("data:image"))
                    .map(|line| line.chars().count())
                    .max();
                let long = if longest > Some(200) { " LONG LINE" } else { "" };
                println!("{stem}: {reason}{check}{long}");
                std::fs::write(Path::new(&folder).join(format!("{stem}.md")), imported.document).expect("a document");
            }
            Err(refusal) => {
                println!("{stem}: refused: {}", refusal.words().english());
                std::fs::write(Path::new(&folder).join(format!("{stem}.err")), refusal.words().english())
                    .expect("a message");
            }
        }
    }
}
