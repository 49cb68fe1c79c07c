//! Selection of columns: `--observe` by name and number, `--against`, and the variable of the document.

use crate::common::meniscus;
use crate::fit::word;
use std::path::PathBuf;
use tempfile::TempDir;

/// A file with these headings. The letter of a column chooses its values.
fn file(heads: &str, kinds: &str) -> (TempDir, PathBuf) {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("data.csv");
    let cell = |kind: char, row: u32| {
        let at = f64::from(row);
        match kind {
            'n' => row.to_string(),
            't' => format!("{:.3}", 0.04 * at),
            'u' => format!("{:.3}", 0.1 * at),
            'f' => format!("{:.2}", 0.5 + 0.03 * at),
            'y' => format!("{:.5}", libm::cos(0.9 * at)),
            'z' => format!("{:.5}", libm::cos(0.7 * at)),
            _ => "A".to_owned(),
        }
    };
    let row = |row: u32| kinds.chars().map(|kind| cell(kind, row)).collect::<Vec<_>>().join(",") + "\n";
    let header = if heads.is_empty() { String::new() } else { format!("{heads}\n") };
    std::fs::write(&path, header + &(0..40).map(row).collect::<String>()).unwrap();
    (directory, path)
}

/// Header and second row of the table of derivatives, or the message of the refusal.
fn derivatives(path: &std::path::Path, words: &[&str]) -> Result<(String, Vec<String>), String> {
    let done = meniscus(&[&["derivatives", word(path)], words].concat());
    match done.code {
        0 => {
            let mut lines = done.stdout.lines();
            let head = lines.next().unwrap().to_owned();
            Ok((head, lines.nth(1).unwrap().split(',').map(str::to_owned).collect()))
        }
        code => {
            assert_eq!(code, 2, "{}", done.stderr);
            Err(done.stderr)
        }
    }
}

/// Options suggested by a refusal.
fn options<'a>(refusal: &'a str, option: &str) -> Vec<&'a str> {
    let parts = refusal.split(option).skip(1);
    parts.map(|part| part.trim_start().split([' ', '\n']).next().unwrap_or_default().trim_matches('\'')).collect()
}

#[test]
fn a_number_counts_the_columns_of_the_file() {
    for (heads, kinds) in
        [("run,t [s],y,z", "wtyz"), ("t [s],run,y,z", "twyz"), ("", "wtyz"), ("", "tywz"), ("", "tyzy")]
    {
        let (_directory, path) = file(heads, kinds);
        let time = kinds.find('t').unwrap();
        for number in 1..=5_usize {
            let found = derivatives(&path, &["--observe", &format!("q={number}")]);
            let kind = kinds.chars().nth(number - 1).filter(|kind| *kind != 'w');
            match kind {
                Some(kind) if number != time + 1 => {
                    let expected = if kind == 'y' { libm::cos(0.9) } else { libm::cos(0.7) };
                    let (_, row) = found.unwrap_or_else(|refusal| panic!("{number} of {heads} {kinds}: {refusal}"));
                    assert!(
                        (row[1].parse::<f64>().unwrap() - expected).abs() < 1e-4,
                        "{number} of {heads} {kinds}: {row:?}"
                    );
                }
                _ => assert!(found.is_err(), "{number} of {heads} {kinds}: {found:?}"),
            }
        }
    }
}

#[test]
fn what_can_be_two_columns_is_refused_and_each_option_shown_is_one_of_them() {
    for (heads, which) in [("x-axis,1,2", "2"), ("t,y,y", "y"), ("t,Y,y", "y "), ("t,Amp,amp", "AMP")] {
        let (_directory, path) = file(heads, "tyz");
        let found = derivatives(&path, &["--observe", &format!("q={which}")]);
        if which == "y " {
            assert!(found.is_ok(), "{found:?}");
            continue;
        }
        let refusal = found.unwrap_err();
        let shown = options(&refusal, "--observe q=");
        assert_eq!(shown.len(), 2, "{refusal}");
        let mut rows: Vec<Vec<String>> = Vec::new();
        for option in shown {
            rows.push(derivatives(&path, &["--observe", &format!("q={option}")]).unwrap().1);
        }
        assert_ne!(rows[0], rows[1], "{heads}");
    }
}

#[test]
fn an_open_variable_is_refused_and_each_option_shown_chooses_one() {
    for (heads, kinds, observed) in [
        ("t [s],y,delay [ms],z", "tyuz", "z"),
        ("tA,tB,y", "tuy", "y"),
        ("n,x [m],y [m]", "nfy", "y"),
        ("", "tyuz", "z=4"),
        ("h,t1,t2", "ftu", "t2"),
    ] {
        let (_directory, path) = file(heads, kinds);
        let refusal = derivatives(&path, &["--observe", observed]).unwrap_err();
        let shown = options(&refusal, "--against");
        assert!(shown.len() > 1, "{refusal}");
        let mut tables = Vec::new();
        for option in shown {
            let found = derivatives(&path, &["--observe", observed, "--against", option]);
            let found = found.unwrap_or_else(|refusal| panic!("--against {option}: {refusal}"));
            assert!(!tables.contains(&found), "{heads}: {option}");
            tables.push(found);
        }
    }
    // A column with the same independent variable in each reading is not ambiguous.
    let (_directory, path) = file("t [s],y,delay [ms],z", "tyuz");
    assert!(derivatives(&path, &["--observe", "y"]).unwrap().0.starts_with("t [s],y,"));
}

#[test]
fn columns_are_measured_against_what_is_asked_for() {
    for (heads, against, expected) in [
        ("t [s],f [Hz],y,z", "f", "f [Hz]"),
        ("t [s],f [Hz],y,z", "#2", "f [Hz]"),
        ("t [s],f [Hz],y,z", "2", "f [Hz]"),
        ("x [m],t [s],y,z", "x", "x [m]"),
        ("Nr,f [Hz],y,z", "Nr", "Nr [s]"),
    ] {
        let (_directory, path) = file(heads, "tfyz");
        let (head, _) = derivatives(&path, &["--observe", "y", "--against", against]).unwrap();
        assert!(head.starts_with(&format!("{expected},y")), "{head}");
    }
    let (_directory, path) = file("t,y", "ty");
    assert!(derivatives(&path, &["--observe", "y", "--against", "q"]).unwrap_err().contains("no column `q`"));
}

#[test]
fn the_variable_of_the_document_is_found_in_the_file() {
    let directory = tempfile::tempdir().unwrap();
    let document = directory.path().join("resonance.md");
    std::fs::write(
        &document,
        "---\ntitle: Resonance\nvary: F, f0, b\n---\n\n```model\nindependent f in [Hz]\nparameter F = 1 [mm Hz^2] in 0..100\n\
         parameter f0 = 1 [Hz] in 0.1..10\nparameter b = 1 [Hz] in 0.001..5\nA = F/sqrt((f0^2 - f^2)^2 + (b*f)^2)\n```\n",
    )
    .unwrap();
    for (heads, order) in [
        ("Nr,f [Hz],A [mm]", "nfA"),
        ("#;A [mm];nu [Hz]", "nAf"),
        ("A [mm],f [Hz]", "Af"),
        (",f,A [mm]", "nfA"),
        ("t [s],f [Hz],A [mm]", "nfA"),
        ("i,f [Hz],A [mm],phase [deg]", "nfAf"),
    ] {
        let delimiter = if heads.contains(';') { ";" } else { "," };
        let mut text = format!("{heads}\n");
        for row in 0..60 {
            let f = 0.3 + 0.04 * f64::from(row);
            let amplitude = 3.0 / ((1.21 - f * f) * (1.21 - f * f) + 0.09 * f * f).sqrt();
            let cell = |kind: char| match kind {
                'n' => row.to_string(),
                'f' => f.to_string(),
                _ => amplitude.to_string(),
            };
            text += &(order.chars().map(cell).collect::<Vec<_>>().join(delimiter) + "\n");
        }
        let path = directory.path().join("data.csv");
        std::fs::write(&path, text).unwrap();
        let done = meniscus(&["fit", word(&document), word(&path), "--observe", "A", "--format", "json"]);
        assert_eq!(done.code, 0, "{heads}: {}", done.stderr);
        let result: serde_json::Value = serde_json::from_str(&done.stdout).unwrap();
        let found = &result["parameters"]["f0"];
        assert!((found["value"].as_f64().unwrap() - 1.1).abs() < 1e-6, "{heads}: {found}");
    }
}
