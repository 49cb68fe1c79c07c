//! Check for paths of the machine on which a text was written.

use crate::texts::{all_texts, root};

#[test]
fn no_path_of_a_machine_is_left() {
    let root = root();
    let mut places = vec![root.display().to_string()];
    // A short home folder such as `/root` also occurs in other paths, so it is only searched with a slash.
    places.extend(std::env::var("HOME").ok().filter(|home| home.len() > 1).map(|home| format!("{home}/")));
    for (path, text) in all_texts() {
        let found = places.iter().find(|place| text.contains(place.as_str()));
        assert_eq!(found, None, "in {}", path.display());
    }
}
