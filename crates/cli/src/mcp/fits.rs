//! Tools `fit` and `rank`: documents fitted to measured data.

use super::answer::{Answer, Refused};
use super::given::{Given, GivenByName, assignments};
use super::workplace::Call;
use analysis::fit::{Loss, Outcome};
use rmcp::schemars::{self, JsonSchema};
use runner::fitting::{Contender, FitSettings, Fitted, Theory, fit_as_json, ranking_as_json, settle_units, task};
use runner::names::{date_order, observe, seat};
use runner::records::Measured;
use serde::Deserialize;

/// Settings of a fit.
#[derive(Debug, Deserialize, JsonSchema)]
#[schemars(inline)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Observed quantities: "y", or "y=COLUMN" with the name or number of its column.
    observe: Vec<String>,
    /// The independent column, if it is not the time.
    #[serde(default)]
    against: Vec<String>,
    /// Units of columns that the file does not state, such as {"t": "ms"}.
    #[serde(default)]
    unit: GivenByName,
    /// Order of dates: day-first or month-first.
    dates: Option<String>,
    /// Number of the seat whose assigned values are taken.
    seat: Option<u32>,
    /// Parameters to vary; without it those of the document's `vary`. Also t_origin and y_offset.
    #[serde(default)]
    vary: Vec<String>,
    /// Varied parameters with one value in all records.
    #[serde(default)]
    share: Vec<String>,
    /// Parameters that are held at a value.
    #[serde(default)]
    fix: GivenByName,
    /// Parameters that follow from others by an expression.
    #[serde(default)]
    tie: GivenByName,
    /// Where the search begins: a value, a list "3,5,8" or a range "3..9 step 1".
    #[serde(default)]
    start: GivenByName,
    /// Ranges of the search, such as {"b": "0..2"}.
    #[serde(default)]
    bounds: GivenByName,
    /// Standard errors of observed quantities: a value or a column.
    #[serde(default)]
    error: GivenByName,
    /// least-squares (without it), huber or tukey.
    loss: Option<String>,
    /// Fit from this time on.
    from: Option<Given>,
    /// Fit up to this time.
    until: Option<Given>,
    /// Rows to leave out: "17", "20..30", "t=1.5..2".
    #[serde(default)]
    exclude: Vec<String>,
}

impl Settings {
    /// The settings as `runner` has them.
    fn settings(&self) -> Result<FitSettings, Refused> {
        let loss = match self.loss.as_deref() {
            None | Some("least-squares") => Loss::Squares,
            Some("huber") => Loss::Huber,
            Some("tukey") => Loss::Tukey,
            Some(other) => return Err(Refused::because(format!("no loss `{other}`: least-squares, huber or tukey"))),
        };
        Ok(FitSettings {
            observe: self
                .observe
                .iter()
                .map(|text| observe(text))
                .collect::<Result<_, _>>()
                .map_err(Refused::because)?,
            against: self.against.clone(),
            dates: self.dates.as_deref().map(date_order).transpose().map_err(Refused::because)?,
            unit: assignments(&self.unit),
            seat: self.seat.map(|number| seat(&number.to_string())).transpose().map_err(Refused::because)?,
            vary: self.vary.clone(),
            share: self.share.clone(),
            fix: assignments(&self.fix),
            tie: assignments(&self.tie),
            start: assignments(&self.start),
            bounds: assignments(&self.bounds),
            error: assignments(&self.error),
            loss,
            from: self.from.as_ref().map(Given::text),
            until: self.until.as_ref().map(Given::text),
            exclude: self.exclude.clone(),
        })
    }
}

/// Arguments of `fit`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fit {
    /// Path of the document below the folder.
    document: Option<String>,
    /// The document itself, in place of a path.
    text: Option<String>,
    /// Paths of files with measured data: text, XLSX, XLS, ODS, Tracker; one for each run.
    data: Vec<String>,
    /// Observed, varied and held quantities.
    settings: Settings,
    /// Also intervals from the profile of the likelihood; takes longer.
    #[serde(default)]
    profile: bool,
}

/// Fits a document.
pub fn fit(call: Call, asked: Fit) -> Result<Answer, Refused> {
    let settings = asked.settings.settings()?;
    if asked.profile && settings.loss != Loss::Squares {
        return Err(Refused::because("a profile needs least squares: with another loss it has no probability"));
    }
    let mut theory = call.theory(asked.document.as_ref(), asked.text.as_ref())?;
    let data = records(call, &asked.data, std::slice::from_mut(&mut theory), &settings)?;
    let task = task(&mut theory.document, &data, &settings, &mut |_| {})?;
    let fitted = Fitted::complete(theory, task, asked.profile, &mut |_| call.goes_on())?;
    Ok(Answer::Data(fit_as_json(&fitted, &data)))
}

/// Arguments of `rank`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rank {
    /// Paths of two or more documents below the folder.
    documents: Vec<String>,
    /// Paths of files with measured data.
    data: Vec<String>,
    /// Observed, varied and held quantities.
    settings: Settings,
    /// Also fit what is before this time, and give the error of what is predicted from there on.
    predict_from: Option<Given>,
}

/// Fits documents to the same data, best first.
pub fn rank(call: Call, asked: Rank) -> Result<Answer, Refused> {
    if asked.documents.len() < 2 {
        return Err(Refused::because("there is only one theory: name two or more `documents`"));
    }
    let settings = asked.settings.settings()?;
    let theory = |path: &String| call.theory(Some(path), None);
    let mut theories: Vec<Theory> = asked.documents.iter().map(theory).collect::<Result<_, _>>()?;
    let data = records(call, &asked.data, &mut theories, &settings)?;
    let predict_from = asked.predict_from.as_ref().map(Given::text);
    let contend = |theory: Theory| {
        let asked = (&settings, predict_from.as_deref());
        Contender::complete(theory, &data, asked, &mut |_| {}, &mut |_| call.goes_on())
    };
    let contenders: Vec<Contender> = theories.into_iter().map(contend).collect::<Result<_, _>>()?;
    let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
    let ranked = analysis::fit::rank(&outcomes);
    Ok(Answer::Data(serde_json::json!({ "ranking": ranking_as_json(&contenders, &ranked, &data) })))
}

fn records(
    call: Call,
    paths: &[String],
    theories: &mut [Theory],
    settings: &FitSettings,
) -> Result<Vec<Measured>, Refused> {
    let first = theories.first().ok_or_else(|| Refused::because("there is no document"))?;
    let stated = settings.stated(&first.document);
    let mut data: Vec<Measured> = paths.iter().map(|path| call.record(path, stated)).collect::<Result<_, _>>()?;
    if data.is_empty() {
        return Err(Refused::because("`data` names no file"));
    }
    settle_units(theories, &mut data, settings)?;
    Ok(data)
}
