//! Names of the runs of a logger: `Run 2`, `Data Set 1`.

/// Words for a run of a logger, in lower case, the longer ones first.
const RUNS: [&str; 25] = [
    "conjunto de datos",
    "data set",
    "datensatz",
    "messreihe",
    "ejecución",
    "ejecucion",
    "recording",
    "exécution",
    "execução",
    "dataset",
    "medición",
    "medicion",
    "medida",
    "messung",
    "versuch",
    "corrida",
    "ensayo",
    "series",
    "trial",
    "serie",
    "essai",
    "prova",
    "toma",
    "lauf",
    "run",
];

/// Normalised name of a run, `Run 2` for `Run #2`; `None` for other texts.
pub(crate) fn name(text: &str) -> Option<String> {
    let text = text.trim();
    let lower = text.to_lowercase();
    if matches!(lower.as_str(), "latest" | "última" | "último") {
        return Some(text.to_owned());
    }
    let word = RUNS.iter().find(|word| lower.starts_with(**word))?;
    let blanks = [' ', '#', '_', '.', '°', 'º'];
    let number = lower[word.len()..].trim_start_matches(blanks);
    // For `Ejecución n.º 2`, `Run No. 2`.
    let sign = ["nr.", "nr ", "no.", "no ", "núm.", "num.", "nº", "n°", "n.º", "n.°"];
    let number = sign.iter().find_map(|sign| number.strip_prefix(sign)).unwrap_or(number).trim_start_matches(blanks);
    let is_number = !number.is_empty() && number.len() <= 6 && number.bytes().all(|byte| byte.is_ascii_digit());
    // The word as written in the text: lower case may have another length.
    let written: String = text.chars().take(word.chars().count()).collect();
    is_number.then(|| format!("{written} {number}"))
}

/// Cell without the name of a run before or after it, and this name: `Run 2: Time (s)`, `Time (s) Run #2`.
pub(crate) fn without(cell: &str) -> (&str, Option<String>) {
    if let Some((before, rest)) = cell.split_once(':')
        && let Some(run) = name(before)
        && !rest.trim().is_empty()
    {
        return (rest.trim(), Some(run));
    }
    let ends = |character: char| matches!(character, ' ' | ',' | '-' | '–' | ':' | '_' | '(' | '[');
    let closed = cell.trim_end_matches([')', ']']);
    // The name of a run at the end of a cell follows a blank or a bracket.
    for (place, character) in closed.char_indices().filter(|(_, character)| ends(*character)) {
        let behind = &closed[place + character.len_utf8()..];
        if let Some(run) = name(behind).filter(|_| behind.ends_with(|last: char| last.is_ascii_digit())) {
            let mut rest = cell[..place].trim_end_matches([' ', ',', '-', '–', ':', '_']);
            if rest.ends_with(['(', '[']) {
                rest = rest.trim_end_matches(['(', '[']).trim_end();
            }
            if !rest.is_empty() {
                return (rest, Some(run));
            }
        }
    }
    (cell, None)
}
