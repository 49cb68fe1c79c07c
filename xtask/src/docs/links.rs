//! Links of the documentation that lead nowhere. Other sites are not asked.

use super::markdown::Page;
use std::path::Path;

/// Links to pages, sections and files that do not exist in the site, each with its page.
pub fn broken(pages: &[Page], folder: &Path) -> Vec<String> {
    let leads = |page: &Page, link: &str| {
        let (file, id) = link.split_once('#').unwrap_or((link, ""));
        let target = if file.is_empty() { Some(page) } else { page_of(pages, file) };
        match target {
            Some(target) => id.is_empty() || target.sections.iter().any(|section| section.id == id),
            None => id.is_empty() && folder.join(file).is_file(),
        }
    };
    let own = |link: &&String| !link.contains("://") && !link.starts_with("mailto:");
    let of_page = |page| move |link: &String| (!leads(page, link)).then(|| format!("docs/{}.md: {link}", page.name));
    pages.iter().flat_map(|page| page.links.iter().filter(own).filter_map(of_page(page))).collect()
}

fn page_of<'a>(pages: &'a [Page], file: &str) -> Option<&'a Page> {
    let name = file.strip_suffix(".html")?;
    pages.iter().find(|page| page.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_to_missing_pages_sections_and_files_are_found() {
        let text = "# A\n\n## One two\n\n[a](#one-two) [b](b.md) [c](b.md#there) [d](#nowhere) [e](c.md) [f](b.md#no) \
                    [g](https://x.org/no) ![h](no.png)\n";
        let pages = [Page::of("a", text).unwrap(), Page::of("b", "# B\n\n## There\n").unwrap()];
        let broken = broken(&pages, Path::new("/nowhere"));
        let expected = ["#nowhere", "c.html", "b.html#no", "no.png"].map(|link| format!("docs/a.md: {link}"));
        assert_eq!(broken, expected);
    }
}
