//! Conditions: both branches are executed, and the values behind them are joined.

use super::evaluation::is_truth;
use super::run::{DEEPEST, Known, Run};
use super::value::{Kind, Value};
use crate::place::Reason;
use crate::refusal::Obstacle;
use crate::script::{Expression, Statement};
use std::collections::{BTreeMap, BTreeSet};

impl Run<'_> {
    /// Both branches of a condition without `return`.
    pub(super) fn branches(&mut self, condition: &Expression, branches: [&[Statement]; 2]) {
        let condition = match self.truth(condition) {
            Ok(condition) => condition,
            Err(reason) => {
                branches.iter().filter(|branch| !branch.is_empty()).for_each(|branch| self.spoil_for(branch, &reason));
                return;
            }
        };
        if let Value::Truth(truth) = condition {
            self.list(branches[usize::from(!truth)], 0);
            return;
        }
        let before = self.values.clone();
        self.under(condition.clone(), |run| run.list(branches[0], 0));
        let yes = std::mem::replace(&mut self.values, before.clone());
        self.under(condition.clone().not(), |run| run.list(branches[1], 0));
        self.join(&condition, yes, &before);
    }

    /// A condition with `return` in a branch: what follows is executed for each branch.
    pub(super) fn branches_with_return(
        &mut self,
        condition: &Expression,
        branches: [&[Statement]; 2],
        rest: &[Statement],
        depth: usize,
    ) -> Option<Known> {
        let line = condition.line;
        let condition = match self.truth(condition) {
            Ok(condition) => condition,
            Err(reason) => {
                [branches[0], branches[1], rest].iter().for_each(|part| self.spoil_for(part, &reason));
                return Some(Err(reason));
            }
        };
        if depth > 2 * DEEPEST {
            return Some(Err(self.reason(line, Obstacle::TooLong)));
        }
        let way = |run: &mut Self, branch: &[Statement]| {
            let returned = run.list(&[branch, rest].concat(), depth + 1);
            returned.unwrap_or(Ok(Value::Nothing))
        };
        if let Value::Truth(truth) = condition {
            return Some(way(self, branches[usize::from(!truth)]));
        }
        let before = self.values.clone();
        let yes_value = self.under(condition.clone(), |run| way(run, branches[0]));
        let yes = std::mem::replace(&mut self.values, before.clone());
        let no_value = self.under(condition.clone().not(), |run| way(run, branches[1]));
        self.join(&condition, yes, &before);
        Some(match (yes_value, no_value) {
            (Ok(Value::Nothing), Ok(Value::Nothing)) => Ok(Value::Nothing),
            (Ok(Value::Nothing), Ok(_)) | (Ok(_), Ok(Value::Nothing)) => {
                Err(self.reason(line, Obstacle::NoValue("return".to_owned())))
            }
            (Ok(yes), Ok(no)) => self.chosen(condition, yes, no, line),
            (Err(reason), _) | (_, Err(reason)) => Err(reason),
        })
    }

    fn spoil_for(&mut self, statements: &[Statement], reason: &Reason) {
        if !statements.is_empty() {
            let place = std::mem::replace(&mut self.place, reason.place.clone());
            self.spoil(statements, reason.obstacle.clone());
            self.place = place;
        }
    }

    /// Joins the values of two branches, of which the second has just been executed.
    fn join(&mut self, condition: &Value, yes: BTreeMap<String, Known>, before: &BTreeMap<String, Known>) {
        let no = std::mem::replace(&mut self.values, before.clone());
        let keys: BTreeSet<&String> = yes.keys().chain(no.keys()).collect();
        for key in keys {
            let (of_yes, of_no) = (yes.get(key), no.get(key));
            if of_yes == of_no {
                if let Some(known) = of_yes {
                    self.values.insert(key.clone(), known.clone());
                }
                continue;
            }
            let [of_yes, of_no] = [of_yes, of_no].map(|known| known.cloned().unwrap_or_else(|| self.before(key, 0)));
            let joined = match (of_yes, of_no) {
                (Ok(yes), Ok(no)) => self.chosen(condition.clone(), yes, no, 0),
                (Err(reason), _) | (_, Err(reason)) => Err(reason),
            };
            self.set(key.clone(), joined);
        }
    }

    fn chosen(&self, condition: Value, yes: Value, no: Value, line: usize) -> Known {
        let nothing = |value: &Value| matches!(value, Value::Nothing);
        if nothing(&yes) && nothing(&no) {
            return Ok(Value::Nothing);
        }
        if nothing(&yes) || nothing(&no) {
            return Err(self.reason(line, Obstacle::NoValue("undefined".to_owned())));
        }
        match (self.kind(&yes), self.kind(&no)) {
            (Some(one), Some(other)) if one == other => Ok(Value::choose(condition, yes, no)),
            (Some(Kind::Truth), Some(Kind::Number)) if is_truth(&no).is_some() => {
                Ok(Value::choose(condition, yes, Value::Truth(is_truth(&no) == Some(true))))
            }
            _ => Err(self.reason(line, Obstacle::Kinds)),
        }
    }
}
