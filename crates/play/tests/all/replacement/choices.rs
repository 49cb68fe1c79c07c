//! The user's choices, kept runs and answers when the program is replaced.

use super::{dropped, edited, fresh, swinging};
use crate::support::{UTUBE, UTUBE_ES, go_on, open, set, utube};
use play::figure::{Direction, Settings};
use play::{Announcement, Grade, Play, PlotId};

fn given(play: &Play, question: usize) -> play::AnswerView {
    play.answers().answer(play.basis(), question)
}

#[test]
fn a_method_and_a_step_that_were_chosen_stay_and_others_are_the_documents() {
    let step = ("step: 0.05 [s]", "step: 0.02 [s]");
    let mut play = utube();
    go_on(&mut play, [1.0]);
    play.replace_program(edited(&[step, ("method: rk4", "method: euler")]));
    assert_eq!(
        (play.course().begun().step, play.course().begun().method.name(), play.values().table_length()),
        (0.02, "euler", 51)
    );
    play.change_settings(|settings| settings.set_method("velocity-verlet")).unwrap();
    play.change_settings(|settings| settings.set_step(0.1)).unwrap();
    go_on(&mut play, [1.0]);
    play.replace_program(edited(&[]));
    assert_eq!((play.course().begun().step, play.course().begun().method.name()), (0.1, "velocity-verlet"));
    let first_order = "---\ntitle: Decay\nmethod: rk4\n---\n```model\ny' = -y/(1 [s])\ny(0) = 1 [m]\n```\n";
    play.replace_program(open(first_order, &[]).program().clone());
    assert_eq!(
        (play.course().begun().step, play.course().begun().method.name(), play.course().time()),
        (0.1, "rk4", 1.0)
    );
    assert_eq!(dropped(&mut play), ["velocity Verlet"]);
    // The abscissa is a length: there is no time axis to keep.
    play.replace_program(
        open(&first_order.replace("```model\n", "```model\nindependent x in [m]\n").replace("1 [s]", "1 [m]"), &[])
            .program()
            .clone(),
    );
    assert_eq!(
        (play.course().time(), dropped(&mut play)),
        (0.0, vec!["h = 0.1 s".to_owned(), "the time 1.00 s".to_owned()])
    );
}

#[test]
fn plots_keep_what_was_chosen_by_their_titles() {
    let mut play = swinging();
    let settings = Settings::default();
    for index in 0..3 {
        play.layout_plot(PlotId::at(index), &settings);
        play.change_plots(|plots, _| plots.zoom(PlotId::at(index), None, 2.0, Direction::Both));
    }
    play.change_plots(|plots, _| plots.show(PlotId::at(2), true));
    let added = play.change_plots(|plots, _| plots.add());
    play.change_plots(|plots, _| plots.change_added(added, |plot| plot.labels.title = "Residuals".to_owned()));
    play.replace_program(edited(&[
        ("\"Motion\": y, y' against t", "\"Speed\": abs(y') against t\n\"Motion\": y, y' against t"),
        ("E, T, V against t", "E, T, V against y"),
    ]));
    let plots = play.plots().list();
    let seen: Vec<(&str, bool, bool)> =
        plots.iter().map(|plot| (plot.title.as_str(), plot.shown, plot.automatic)).collect();
    assert_eq!(
        seen,
        [
            ("Speed", true, true),
            ("Motion", true, false),
            ("Phase portrait", false, false),
            // The zoomed axis was in seconds and is now in metres.
            ("Energies", true, true),
            ("Residuals", false, true),
        ]
    );
    let mut is_added = false;
    play.change_plots(|plots, _| plots.change_added(PlotId::at(4), |_| is_added = true));
    assert!(is_added);
    play.set_language("es");
    assert_eq!(play.plots().list()[4].title, "Residuals");
}

#[test]
fn kept_runs_are_computed_with_the_new_equation() {
    let equation = ("b*y'", "2*b*y'");
    let (mut play, mut other) = (utube(), fresh(&[equation]));
    for play in [&mut play, &mut other] {
        for b in [100.0, 200.0, 300.0] {
            play.change_run(|line, basis| line.back_to_start(basis));
            set(play, "b", b);
            go_on(play, [2.0]);
            play.change_run(|line, basis| line.keep(basis)).unwrap();
        }
        let first = play.time_line().kept(play.basis())[0].id;
        play.change_run(|line, basis| line.remove_kept(basis, first));
        play.change_run(|line, basis| line.show_kept(line.kept(basis)[0].id, false));
        play.change_run(|line, basis| line.back_to_start(basis));
    }
    let ids: Vec<u32> = play.time_line().kept(play.basis()).iter().map(|kept| kept.id).collect();
    play.replace_program(edited(&[equation]));
    assert!(dropped(&mut play).is_empty());
    assert_eq!(play.time_line().kept(play.basis()), other.time_line().kept(other.basis()));
    assert_eq!(play.time_line().kept(play.basis()).iter().map(|kept| kept.id).collect::<Vec<_>>(), ids);
    play.change_run(|line, _| line.clear_ghost());
    assert_eq!(play.plots_to_front().csv(PlotId::at(0)), other.plots_to_front().csv(PlotId::at(0)));
    assert_eq!(play.removals().number(), None, "the run that was removed was one of the former equation");
    play.replace_program(edited(&[("0..20000", "0..250")]));
    assert_eq!(dropped(&mut play), ["b = 300 kg/s", "the kept run “b = 300 kg/s”"]);
    assert_eq!(play.time_line().kept(play.basis()).len(), 1);
}

#[test]
fn answers_stay_with_their_questions_and_grades_with_the_right_answers() {
    let period = |play: &mut Play| play.change_answers(|answers, run| answers.check(run, 0, "2*pi/(1.672 1/s)")).grade;
    let mut play = utube();
    assert_eq!(period(&mut play), Grade::Correct);
    play.change_answers(|answers, _| answers.type_text(1, "1 m"));
    // Another parameter and another question are inserted before all others.
    let more = [
        ("parameter g ", "parameter a = 1\nparameter g "),
        (
            "```question\nMeasure the period.",
            "```question\nWhat is a?\nanswer: a within 1 %\n```\n\n```question\nMeasure the period.",
        ),
    ];
    play.replace_program(edited(&more));
    assert!(dropped(&mut play).is_empty());
    assert_eq!(given(&play, 0).typed, "");
    let answer = given(&play, 1);
    assert_eq!(
        (answer.typed.as_str(), answer.verdict.map(|verdict| verdict.grade)),
        ("2*pi/(1.672 1/s)", Some(Grade::Correct))
    );
    assert_eq!(given(&play, 2).typed, "1 m");
    // The expression of the right answer has changed.
    play.replace_program(edited(&[("2*pi/omega_d within", "2*pi/omega_0 within")]));
    assert_eq!((given(&play, 0).typed.as_str(), given(&play, 0).verdict), ("2*pi/(1.672 1/s)", None));
    play.replace_program(edited(&[("Measure the period.", "Measure the half-period.")]));
    assert_eq!(dropped(&mut play), ["the answer “2*pi/(1.672 1/s)”"]);
    assert_eq!((given(&play, 0).typed.as_str(), given(&play, 1).typed.as_str()), ("", "1 m"));
}

#[test]
fn a_language_stays_and_names_what_is_lost() {
    let mut play = swinging();
    play.set_language("es");
    let narrower = UTUBE.replace("in 0..20000", "in 0..100");
    play.replace_program(open(&narrower, &[UTUBE_ES]).program().clone());
    assert_eq!((play.basis().tag(), play.plots().list()[0].title.as_str()), ("es", "Movimiento"));
    assert_eq!(dropped(&mut play), ["b = 200 kg/s"]);
    let text = Announcement::Replaced(vec!["b = 200 kg/s".to_owned()]).text(play.basis(), play.time_line());
    assert_eq!(text, "El documento cambiado está en marcha; se omitió lo que no encaja: b = 200 kg/s");
}
