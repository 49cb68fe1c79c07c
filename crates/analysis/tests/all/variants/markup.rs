//! Variants of tables in HTML and LaTeX.

use super::{ROWS, Variant, column, heights, number, times};

/// Tables between other text, with the marks that programs and people write.
pub fn tables(found: &mut Vec<Variant>) {
    let html = |start: &str, head: [&str; 2], row: &str, comma: bool| {
        let rows: String = (0..ROWS)
            .map(|place| {
                let cell = |value: f64| number(value, comma);
                row.replace("@t", &cell(times()[place])).replace("@y", &cell(heights(0.0)[place]))
            })
            .collect();
        format!(
            "{start}<table class=\"a\"><thead><tr><th>{}</th><th>{}</th></tr></thead>{rows}</table></html>",
            head[0], head[1]
        )
    };
    for start in [
        "<html>",
        "<!DOCTYPE html>\n<html><head><style>td { a: b }</style></head>",
        "<HTML><!-- a < b --><TABLE><TR><TD>menu</TABLE>",
    ] {
        for head in [["t (s)", "y (cm)"], ["t&nbsp;(s)", "<b>y</b><br>[cm]"]] {
            for row in [
                "<tr><td>@t</td><td>@y</td></tr>\n",
                "<TR align=right><TD>@t<TD>@y\n",
                "<tr>\n <td style='x'> @t </td>\n <td><span>@y</span></td>\n</tr>\n",
            ] {
                for comma in [false, true] {
                    let text = html(start, head, row, comma);
                    let text = if row.contains("span") { text.replace("<span>-", "<span>&minus;") } else { text };
                    let columns = vec![column(None, "t", "s", times()), column(None, "y", "cm", heights(0.0))];
                    found.push(Variant { kind: "HTML", text, columns });
                }
            }
        }
    }
    for start in [
        "",
        "\\begin{tabular}{lr}\n",
        "\\begin{table}\n\\centering\n\\begin{tabular}{S[table-format=1.2]c}\n\\toprule\n",
    ] {
        for head in ["t (s) & y (cm)", "$t$ (s) & $y$ (cm)", "\\textbf{t} [s] & {$y$} [cm]", "{$t$ / s} & {$y$ / cm}"] {
            for row in ["@t & @y \\\\\n", "  $@t$ & $@y$ \\\\[2pt] % a\n", "\\num{@t} & \\num{@y} \\\\ \\hline\n"] {
                let rows: String = (0..ROWS)
                    .map(|place| {
                        row.replace("@t", &number(times()[place], false))
                            .replace("@y", &number(heights(0.0)[place], false))
                    })
                    .collect();
                let end = if start.is_empty() { "" } else { "\\bottomrule\n\\end{tabular}\n\\caption{50 cm}\n" };
                let text = format!("{start}{head} \\\\\n\\hline\n{rows}{end}");
                let columns = vec![column(None, "t", "s", times()), column(None, "y", "cm", heights(0.0))];
                found.push(Variant { kind: "LaTeX", text, columns });
            }
        }
    }
}
