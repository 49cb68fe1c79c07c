//! Line above a table with the relative standard error of its scale, such as that of the ruler in a film, which is common
//! to all lengths.

/// Beginning of the line, after the comment sign.
const LABEL: &str = "relative standard error of the scale:";

/// Line, without its line end, for a table whose lengths have this relative standard error.
pub fn scale_line(error: f64) -> String {
    format!("# {LABEL} {error}")
}

/// Error stated by one of these lines, also if a spreadsheet saved it with quotation marks, separators or a decimal comma.
/// `None` without such a line, or if the number is not between 0 and 1.
pub(crate) fn read<'a>(lines: impl IntoIterator<Item = &'a str>) -> Option<f64> {
    let stated = |line: &str| {
        let cell = line.trim_start_matches(['"', '#', ' ', '\t']).trim_end_matches(['"', ',', ';', ' ', '\t']);
        let (label, value) = cell.split_at_checked(LABEL.len())?;
        let value: f64 = value.trim().replace(',', ".").parse().ok()?;
        (label.eq_ignore_ascii_case(LABEL) && value > 0.0 && value < 1.0).then_some(value)
    };
    lines.into_iter().find_map(stated)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_is_read_as_programs_save_it() {
        let written = scale_line(0.0015);
        for line in [
            written.as_str(),
            "\"# relative standard error of the scale: 0,0015\";;",
            "# Relative Standard Error of the Scale: 1.5e-3,,",
            "# relative standard error of the scale: 0.0015\t\t",
        ] {
            assert_eq!(read(["t,y", line]), Some(0.0015), "{line}");
        }
        for line in
            ["# relative standard error of the scale: 0", "# relative standard error of the scale: inf", "t,y", ""]
        {
            assert_eq!(read([line]), None, "{line}");
        }
    }
}
