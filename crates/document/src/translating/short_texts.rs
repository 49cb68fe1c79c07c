//! Labels, titles and texts of the drawing, which a translation has in its blocks `translations`.

use crate::open::File;
use crate::scene::{has_word, normalised};

/// Short texts of a document, each once, in text order. Empty if the model has errors. Texts without a word are left out.
pub fn short_texts(source: &str) -> Vec<String> {
    let mut file = File::new(source);
    let Some(read) = file.model().map(|checked| file.document(checked)) else { return Vec::new() };
    let program = &read.document.program;
    let drawn = read.scene_words.iter().filter_map(|text| text.translatable());
    let mut texts: Vec<String> = Vec::new();
    for text in program.translatable().into_iter().chain(drawn).filter(|text| has_word(text)) {
        let text = normalised(text);
        if !texts.contains(&text) {
            texts.push(text);
        }
    }
    texts
}
