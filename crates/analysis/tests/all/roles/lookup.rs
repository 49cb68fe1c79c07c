//! Columns by the texts that select them, and the texts by which columns are called.

use super::import;
use analysis::lookup::LookupError;
use units::Language;

#[test]
fn a_column_is_called_by_its_number_in_the_file() {
    // Words at each place, a header or none, each number.
    for words in 0..=3 {
        for header in [true, false] {
            let mut text = String::new();
            let row = |cells: [String; 3], word: &str| {
                let mut cells = cells.to_vec();
                cells.insert(words, word.to_owned());
                cells.join(",") + "\n"
            };
            if header {
                text += &row(["t [s]", "y [cm]", "v [cm/s]"].map(str::to_owned), "run");
            }
            for at in 0..12 {
                let at = f64::from(at);
                text += &row([at * 0.1, 1.0 + at, 20.0 - at * at].map(|value| value.to_string()), "A");
            }
            let table = import(&text).table;
            for number in 1..=9_usize {
                let expected = (1..=4).contains(&number) && number != words + 1;
                let found = table.column(&number.to_string());
                assert_eq!(found.is_ok(), expected, "{number}\n{text}");
                assert_eq!(table.column(&format!("#{number}")), found);
                if let Ok(found) = found {
                    let place = number - 1 - usize::from(number > words + 1);
                    let second = [0.1, 2.0, 19.0][place];
                    assert_eq!(table.columns[found].values[1], second, "{number}\n{text}");
                }
            }
        }
    }
}

#[test]
fn a_name_that_is_another_column_s_number_is_refused() {
    let table = import("x-axis,1,2\nsecond,Volt,Volt\n-2,3.5,0.1\n-1,2.5,-0.1\n0,2,-0.4\n").table;
    // `1` names column 2, and is the number of column 1.
    assert_eq!(table.column("1"), Err(LookupError::Several(vec![1, 0])));
    assert_eq!(table.column("2"), Err(LookupError::Several(vec![2, 1])));
    assert_eq!(table.column("3"), Ok(2));
    assert_eq!(["#1", "#2", "#3"].map(|which| table.column(which)), [Ok(0), Ok(1), Ok(2)]);
    assert_eq!([0, 1, 2].map(|index| table.typed(index)), ["#1", "#2", "#3"]);
    // A name `#2`, or `##2`, leaves one more sign for the number.
    for (heads, expected) in
        [("t,y 1,#2", ["t", "##2", "#3"]), ("t,#2,y 1", ["t", "#2", "#3"]), ("a b,##1,#1", ["###1", "#2", "#3"])]
    {
        let table = import(&format!("{heads}\n0,5,1\n1,6,2\n2,4,3\n")).table;
        assert_eq!([0, 1, 2].map(|index| table.typed(index)), expected, "{heads}");
        assert_eq!(expected.map(|which| table.column(which)), [Ok(0), Ok(1), Ok(2)], "{heads}");
    }
    // If both are the same column, it is not ambiguous.
    let table = import("1,2\n0,5\n1,6\n2,4\n").table;
    assert!(table.column("2") == Ok(1) || table.columns[1].name.is_empty());
    // Of several bodies the first is used; columns of one name in one body are ambiguous.
    let twice = import("t,y,y\n0,5,1\n1,6,2\n2,4,3\n").table;
    assert_eq!(twice.column("y"), Err(LookupError::Several(vec![1, 2])));
}

#[test]
fn columns_of_one_name_are_told_apart_in_all_texts() {
    for (heads, labels) in [
        ("t [s],y,y", ["t", "y #2", "y #3"]),
        ("t [s],y [cm],y [V]", ["t", "y [cm]", "y [V]"]),
        ("t [s],y [cm],y", ["t", "y #2", "y #3"]),
        ("t [s],t [ms],y", ["t [s]", "t [ms]", "y"]),
        ("t [s],y [cm],y [cm]", ["t", "y #2", "y #3"]),
    ] {
        let table = import(&format!("{heads}\n0,5,1\n1,6,2\n2,4,3\n3,9,1\n")).table;
        assert_eq!(table.labels(), labels, "{heads}");
        for (index, label) in labels.iter().enumerate() {
            assert_eq!((table.label(index).as_str(), table.column(label)), (*label, Ok(index)), "{heads}");
            assert!(table.reading_in_words(&[index], Language::English).ends_with(label), "{heads}");
        }
    }
}

#[test]
fn columns_of_runs_that_share_a_number_are_told_apart_by_the_run() {
    // Runs below one another with odd or equal headings: found by fuzzing.
    for (text, of_the_last) in [
        (&b"2\n'\t\n0\n0\xff\n2\t 2\n0\xff\n' \n0 20 "[..], "Run 2.#2"),
        (b"\n5 --2\tu\n\xc2\xb0K\tu\nu\t2\t55 --2\tu\n\xc2\xb0K\t55 --2\tu\n\xc2\xb0K\tu\nu\t2\t5MM2", "Run 2.#3"),
    ] {
        let table = import::text(text).expect("a table").table;
        for index in 0..table.columns.len() {
            assert_eq!(table.column(&table.typed(index)), Ok(index), "{}", table.typed(index));
        }
        assert_eq!(table.typed(table.columns.len() - 1), of_the_last);
    }
}

#[test]
fn names_are_matched_as_they_are_before_capitals_and_units_are_left_out() {
    for (heads, which, expected) in [
        ("t (h),T (blips)", "T", Ok(1)),
        ("t (h),T (blips)", "t", Ok(0)),
        ("t [s],T [K]", "T", Ok(1)),
        ("t,y (left)", "y", Ok(1)),
        ("t,Y (left)", "y", Ok(1)),
        ("t,Temp,temp", "TEMP", Err(LookupError::Several(vec![1, 2]))),
        ("t,Temp,temp", "temp", Ok(2)),
        ("t,y (left),y (right)", "y", Err(LookupError::Several(vec![1, 2]))),
        ("t,y (left),y (right)", "y (right)", Ok(2)),
    ] {
        let row = |row: f64| {
            (0..heads.split(',').count()).map(move |place| libm::sin(row * (1.0 + place as f64)).to_string())
        };
        let rows: Vec<String> = (0..5).map(|at| row(f64::from(at)).collect::<Vec<_>>().join(",")).collect();
        let table = import(&format!("{heads}\n{}\n", rows.join("\n"))).table;
        assert_eq!(table.column(which), expected, "{which} of {heads}");
    }
}
