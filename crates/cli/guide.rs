//! The guide of the language: the parts of the reference, `docs/language.md`, that a comment marks. A part of the build script.

/// Line before a paragraph, list, table or block that belongs to the guide.
const MARK: &str = "<!-- guide -->";

/// The marked parts of a page in their order, with the headings above them. A part ends at an empty line, a block at the line that closes
/// it.
pub fn guide(page: &str) -> String {
    let mut lines = page.lines();
    let (mut guide, mut headings) = (String::new(), Vec::<&str>::new());
    let mut open: Option<&str> = None;
    while let Some(line) = lines.next() {
        match open {
            Some(fence) if line == fence => open = None,
            Some(_) => {}
            None if line == MARK => {
                headings.drain(..).for_each(|heading| guide.extend([heading, "\n\n"]));
                let mut fence = None;
                for line in lines.by_ref() {
                    let closes = fence.map_or(line.is_empty(), |fence| line == fence);
                    fence = fence.or_else(|| opening(line));
                    if !line.is_empty() || fence.is_some() {
                        guide.extend([line, "\n"]);
                    }
                    if closes {
                        break;
                    }
                }
                guide.push('\n');
            }
            None if line.starts_with('#') => {
                headings.retain(|above| depth(above) < depth(line));
                headings.push(line);
            }
            None => open = opening(line),
        }
    }
    guide.truncate(guide.trim_end().len());
    guide + "\n"
}

/// The backquotes with which a line begins a block.
fn opening(line: &str) -> Option<&str> {
    let marks = line.len() - line.trim_start_matches('`').len();
    (marks >= 3).then(|| &line[..marks])
}

/// Number of the heading's signs.
fn depth(heading: &str) -> usize {
    heading.len() - heading.trim_start_matches('#').len()
}
