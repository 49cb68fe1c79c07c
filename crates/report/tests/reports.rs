//! Reports contain the results of the fit in both languages, and are well-formed, safe and complete.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by them")]

mod support;

use calamine::{Data, Reader};
use report::{Ranking, csv, figure, html, ranking_csv, ranking_html, ranking_workbook, workbook};
use support::{Fitted, fitted, level, observed, parsed, record, texts, theory};
use units::number::Style;

/// Fit of the record with known truth up to 6 s.
fn fit(name: &str, file: &str) -> Fitted {
    let (times, values) = level();
    let mut document = theory(name);
    let record = record(&mut document, file, &times, &values);
    fitted(name, document, vec![record], |task| task.until = Some(6.0))
}

#[test]
fn the_page_says_what_was_found() {
    let mut fit = fit("linear", "swing.txt");
    fit.notes = vec![vec!["6 frames are missing".to_owned()]];
    let mut report = fit.report("en");
    report.intervals = &fit.intervals;
    let page = html(&report);
    let all = texts(&page);
    let gamma = fit.outcome.estimate("gamma").unwrap();
    let rounded = units::number::concise(gamma.value, gamma.stderr_hac, Style::POINT);
    assert!(rounded.starts_with("0.") && rounded.contains('('), "{rounded}");
    for expected in [
        "Linear damping",
        "swing.txt",
        "The residuals look random",
        &rounded,
        "Damping rate",
        "68 % by profile",
        "Quality factor",
        "Durbin-Watson",
        "Prediction",
        "Correlations",
        "Drift of the level",
        "6 frames are missing",
        "meniscus fit linear.md U3.txt --observe y --until 6",
        "until 6 s",
        "L, gamma, y_0, v_0, c",
        // The document is included, so that the page is self-contained.
        "x'' + 2*gamma*x' + omega_0^2*x = 0",
        // The data: the first row.
        "t [s],y measured [m],y fitted [m],y residual [m],y used [1]".trim_end_matches(" [1]"),
    ] {
        assert!(all.contains(expected), "{expected}");
    }
    assert!(page.contains("<mfrac>") && page.contains("<msqrt>"), "equations are typeset");
    assert_eq!(page.matches("<svg").count(), 3, "two panels in one drawing");
    assert!(!page.contains("<script"));
    // Names of XML vocabularies, which are not requested.
    assert_eq!(
        page.matches("http").count(),
        page.matches("http://www.w3.org/").count() + page.matches("http-equiv").count()
    );
}

#[test]
fn the_page_speaks_spanish() {
    let fit = fit("linear", "swing.txt");
    let page = html(&fit.report("es"));
    assert!(page.contains("<html lang=\"es\">"));
    let all = texts(&page);
    for expected in
        ["Amortiguamiento lineal", "Coeficiente de amortiguamiento", "Los residuos parecen aleatorios", "hasta 6 s"]
    {
        assert!(all.contains(expected), "{expected}");
    }
    let gamma = fit.outcome.estimate("gamma").unwrap();
    assert!(all.contains(&units::number::concise(gamma.value, gamma.stderr_hac, Style::COMMA)));
    // A language without translation gets English.
    assert!(html(&fit.report("de")).contains("What the residuals say"));
}

#[test]
fn names_from_outside_do_no_harm() {
    let hostile = "</title><script>alert(1)</script>\"&.txt";
    let mut fit = fit("linear", hostile);
    fit.name = hostile.to_owned();
    fit.notes = vec![vec![hostile.to_owned()]];
    let mut report = fit.report("en");
    (report.command, report.version, report.date) = (hostile, hostile, hostile);
    let page = html(&report);
    assert!(!page.contains("<script"));
    assert!(texts(&page).contains(hostile));
    assert!(!figure(&report).contains("<script"));
    let theories = [report];
    let page = ranking_html(&Ranking { theories: &theories, command: hostile });
    assert!(!page.contains("<script"));
    texts(&page);
}

/// If only the quotient of friction and density is determined, the report says so and gives no values for them.
#[test]
fn what_is_not_determined_has_no_number() {
    let source = "---\ntitle: A tube\n---\n```model\nparameter b = 50 [kg/s]\nparameter rho = 1000 [kg/m^3]\n\
                  rho*0.05 [m^2]*0.2 [m]*y'' + b*y' + 2*rho*0.05 [m^2]*9.8 [m/s^2]*y = 0\ny(0) = 45 [mm]\ny'(0) = 0\n```\n";
    let mut document = document::open(source, &[]).document.unwrap();
    let (times, values) = level();
    let mut record = record(&mut document, "swing.txt", &times, &values);
    record.observations[0].errors = Some(vec![0.001; times.len()]);
    document.program.vary = vec![0, 1];
    document.program.method = Some(program::Method::DormandPrince);
    let fit = fitted("tube", document, vec![record], |_| ());
    assert_eq!(fit.outcome.undetermined[0].combinations, ["b/rho"]);
    let page = html(&fit.report("en"));
    let all = texts(&page);
    assert!(all.contains("b/rho"), "{all}");
    assert_eq!(all.matches("not determined").count(), 2);
    assert!(all.contains("Reduced χ²") && all.contains("weights from the given errors"));
    // Error bars, each of three strokes, on some of the 240 points: they are dense.
    let strokes = figure(&fit.report("en")).matches("<path").count();
    assert!((3 * 40..3 * 240).contains(&strokes), "{strokes}");
}

#[test]
fn the_figure_is_one_drawing_with_one_axis_of_time() {
    let fit = fit("linear", "swing.txt");
    let text = figure(&fit.report("en"));
    let tree = roxmltree::Document::parse(&text).unwrap();
    let panels: Vec<_> = tree
        .root_element()
        .children()
        .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "svg")))
        .collect();
    assert_eq!(panels.len(), 2);
    // The grids of both panels begin at the same abscissa, that of the texts "0" below them.
    let zero = |panel: &roxmltree::Node| {
        let shift: f64 = panel.attribute("x").unwrap().parse().unwrap();
        let labels = panel
            .children()
            .filter(|node| node.tag_name().name() == "text" && node.attribute("text-anchor") == Some("middle"));
        let mut first = labels
            .filter(|node| node.text() == Some("1"))
            .map(|node| node.attribute("x").unwrap().parse::<f64>().unwrap());
        shift + first.next_back().unwrap()
    };
    assert!((zero(&panels[0]) - zero(&panels[1])).abs() < 0.02);
    for expected in ["predicted", "not fitted", "Δy [mm]", "Linear damping · swing.txt"] {
        assert!(text.contains(expected), "{expected}");
    }
}

#[test]
fn the_workbook_holds_results_data_and_curves() {
    let fit = fit("linear", "swing.txt");
    let bytes = workbook(&fit.report("en"));
    let mut book: calamine::Xlsx<_> = calamine::open_workbook_from_rs(std::io::Cursor::new(bytes)).unwrap();
    assert_eq!(book.sheet_names(), ["Results", "Data", "Curves", "Correlations", "About"]);
    let results = book.worksheet_range("Results").unwrap();
    let gamma = fit.outcome.estimate("gamma").unwrap();
    let row = results.rows().find(|row| row[0] == Data::String("gamma".to_owned())).unwrap();
    assert_eq!(row[3], Data::Float(gamma.value));
    assert_eq!(row[4], Data::Float(gamma.stderr_hac.unwrap()));
    assert_eq!(row[6], Data::String("1/s".to_owned()));
    let data = book.worksheet_range("Data").unwrap();
    assert_eq!(data.get_size(), (241, 5));
    let inside = data.rows().skip(1).filter(|row| row[4] == Data::Float(1.0)).count();
    assert_eq!(inside, 181, "frames up to 6 s");
    let curves = book.worksheet_range("Curves").unwrap();
    assert_eq!(curves.get_size(), (601, 3));
}

/// Columns and headings distinguish two records, one of which has its velocity.
#[test]
fn several_records_stand_side_by_side() {
    let (times, values) = level();
    let mut document = theory("linear");
    let mut first = record(&mut document, "one.txt", &times, &values);
    let second = record(&mut document, "two.txt", &times, &values);
    let velocities = analysis::stencil::differentiate(&times, &values, analysis::stencil::Stencil::Central);
    let mut velocity = observed(&mut document, "y'", &times, &velocities);
    velocity.derived_from = Some(0);
    first.observations.push(velocity);
    let fit = fitted("linear", document, vec![first, second], |task| {
        task.varied.iter_mut().take(2).for_each(|varied| varied.shared = true);
    });
    let report = fit.report("en");
    let header = csv(&report, false).lines().next().unwrap().to_owned();
    assert!(header.starts_with("one.txt: t [s],one.txt: y measured [m],"), "{header}");
    assert!(header.contains("one.txt: y' measured [m/s]") && header.contains("two.txt: y fitted [m]"), "{header}");
    let page = html(&report);
    let all = texts(&page);
    for expected in ["one value for all", "computed from another column", "one.txt and two.txt"] {
        assert!(all.contains(expected), "{expected}");
    }
    let drawn = figure(&report);
    let tree = roxmltree::Document::parse(&drawn).unwrap();
    let tops: Vec<f64> = tree.root_element().children().filter_map(|node| node.attribute("y")?.parse().ok()).collect();
    assert_eq!(tops, [0.0, 300.0, 490.0, 790.0, 980.0, 1280.0], "two panels for each of the three observations");
    assert!(drawn.contains("Linear damping · one.txt") && drawn.contains("Linear damping · two.txt"));
    let spanish = csv(&report, true);
    assert!(spanish.starts_with('\u{feff}') && spanish.contains(";0,0"), "decimal commas");
}

#[test]
fn theories_are_ranked() {
    let fits = ["quadratic", "linear", "cosine"].map(|name| fit(name, "swing.txt"));
    let theories = fits.each_ref().map(|fit| fit.report("en"));
    let ranking = Ranking { theories: &theories, command: "meniscus rank swing.txt" };
    let table = ranking_csv(&ranking, false);
    let order: Vec<&str> = table.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    // The formula and the equation are the same theory.
    assert_eq!(order.last(), Some(&"Quadratic damping"), "{order:?}");
    let page = ranking_html(&ranking);
    let all = texts(&page);
    assert!(all.contains("They cannot tell it from “") && all.contains("They rule out “Quadratic damping”."), "{all}");
    let bytes = ranking_workbook(&ranking);
    let mut book: calamine::Xlsx<_> = calamine::open_workbook_from_rs(std::io::Cursor::new(bytes)).unwrap();
    assert_eq!(book.sheet_names().len(), 4);
    let first = book.worksheet_range("Theories").unwrap();
    assert_eq!(first.get((1, 0)), Some(&Data::String(order[0].to_owned())));
    let nothing = Ranking { theories: &[], command: "" };
    assert!(texts(&ranking_html(&nothing)).contains("Which theory"));
    assert_eq!(ranking_csv(&nothing, false).lines().count(), 1);
}

/// AICc favours one theory and another predicts better: both are reported, and neither is ruled out.
#[test]
fn a_better_prediction_contradicts_a_better_fit() {
    let mut fits = ["linear", "quadratic"].map(|name| fit(name, "swing.txt"));
    let mut said = |of_linear: f64, language: &str| {
        for (fit, rmse) in fits.iter_mut().zip([of_linear, 3.01e-3]) {
            let outside = &mut fit.outcome.observations[0].outside;
            *outside = outside.map(|part| analysis::fit::Outside { rmse, ..part });
        }
        let theories = fits.each_ref().map(|fit| fit.report(language));
        texts(&ranking_html(&Ranking { theories: &theories, command: "" }))
    };
    let all = said(5.59e-3, "en");
    assert!(
        all.contains(
            "But “Quadratic damping” predicts the later values better, with an error of 3.01 mm against 5.59 mm."
        ),
        "{all}"
    );
    assert!(!all.contains("rule out"), "{all}");
    let all = said(1e-3, "en");
    assert!(all.contains("They rule out “Quadratic damping”. It also predicts the later values best."), "{all}");
    let all = said(5.59e-3, "es");
    assert!(all.contains("La predicción es mejor juez"), "{all}");
}

#[test]
fn every_header_has_words_and_every_image_a_name() {
    // An unnamed record, many parameters and two records cover every kind of table.
    let fits = [fit("linear", "swing.txt"), fit("quadratic", "")];
    for language in ["en", "es"] {
        let reports: Vec<_> = fits.iter().map(|fit| fit.report(language)).collect();
        let ranking = Ranking { theories: &reports, command: "" };
        let pages = reports.iter().map(html).chain([ranking_html(&ranking)]);
        for page in pages {
            let source = parsed(&page);
            let tree = roxmltree::Document::parse(&source).unwrap_or_else(|error| panic!("{error}"));
            let words = |node: roxmltree::Node<'_, '_>| {
                node.descendants().filter_map(|inner| inner.text()).collect::<String>().trim().to_owned()
            };
            for node in tree.descendants() {
                if node.tag_name().name() == "th" {
                    assert!(!words(node).is_empty(), "{}", &source[node.range()]);
                    let mathematics = node.descendants().any(|inner| inner.tag_name().name() == "math");
                    let heard = node.children().any(|inner| inner.attribute("class") == Some("heard"));
                    assert!(!mathematics || heard, "{}", &source[node.range()]);
                }
                if node.attribute("role") == Some("img") {
                    let title = node.children().find(|child| child.tag_name().name() == "title");
                    assert!(title.is_some_and(|title| !words(title).is_empty()), "{}", &source[node.range()][..200]);
                }
            }
        }
    }
}
