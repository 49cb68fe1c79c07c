//! Pseudonyms of seats: a colour, an animal, and the number of the seat, which makes them unique.

use units::{Language, Words, say, words};

/// Adjectives; where nouns have a gender, those with one form for all.
const COLOURS: [Words; 8] = [
    words("blue"),
    words("green"),
    words("grey"),
    words("brown"),
    words("orange"),
    words("pink"),
    words("violet"),
    words("turquoise"),
];

const ANIMALS: [Words; 16] = [
    words("heron"),
    words("otter"),
    words("fox"),
    words("whale"),
    words("eagle"),
    words("hare"),
    words("seal"),
    words("swan"),
    words("lynx"),
    words("owl"),
    words("deer"),
    words("trout"),
    words("horse"),
    words("crane"),
    words("turtle"),
    words("squirrel"),
];

/// Pseudonym of a seat. `chance`: a random number.
pub fn pseudonym(seat: &str, chance: u8, language: Language) -> String {
    let [colour, animal] = [&COLOURS[usize::from(chance & 7)], &ANIMALS[usize::from(chance >> 4)]];
    say!(language, "{colour} {animal} {seat}")
}
