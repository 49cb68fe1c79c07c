//! Names of grades.

use desk::play::Grade;
use units::Language;

/// Name of a grade.
pub(crate) fn grade_name(grade: Grade, language: Language) -> &'static str {
    match grade {
        Grade::Partly(_) => language.say("partly right"),
        Grade::Correct => language.say("right"),
        Grade::Close => language.say("nearly right"),
        Grade::WrongSign => language.say("wrong sign"),
        Grade::WrongScale => language.say("wrong power of ten"),
        Grade::Wrong => language.say("wrong"),
        Grade::Unreadable => language.say("not a number, or another unit"),
        Grade::Unanswerable => language.say("no answer for these values"),
    }
}
