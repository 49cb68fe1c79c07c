//! Measured curves of the same quantity.

use super::{Collection, Work};
use desk::{CurveAxis, FittedCurve, MeasuredCurve};
use std::collections::BTreeMap;
use units::order::{sort_by, sort_by_key};

/// A measured curve of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Member {
    /// Index of the hand-in.
    pub hand_in: usize,
    /// Index of the curve in [`Work::curves`].
    pub curve: usize,
}

/// All measured curves of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveGroup {
    /// The independent variable.
    pub across: CurveAxis,
    /// The quantity.
    pub quantity: CurveAxis,
    /// The curves, in the order of the hand-ins.
    pub members: Vec<Member>,
}

impl Collection {
    /// The measured curves by quantity and unit, the most frequent quantity first.
    pub fn curve_groups(&self) -> Vec<CurveGroup> {
        let mut groups: BTreeMap<[&str; 4], CurveGroup> = BTreeMap::new();
        for (hand_in, work) in self.works() {
            for (curve, own) in work.curves.iter().enumerate() {
                let MeasuredCurve { across, quantity, .. } = own;
                let key = [&quantity.name, &quantity.unit, &across.name, &across.unit].map(String::as_str);
                let group = groups.entry(key).or_insert_with(|| CurveGroup {
                    across: across.clone(),
                    quantity: quantity.clone(),
                    members: Vec::new(),
                });
                group.members.push(Member { hand_in, curve });
            }
        }
        let mut groups: Vec<CurveGroup> = groups.into_values().collect();
        sort_by_key(&mut groups, |group| std::cmp::Reverse(group.members.len()));
        groups
    }

    /// A measured curve.
    pub fn curve(&self, member: Member) -> Option<&MeasuredCurve> {
        self.work(member.hand_in)?.curves.get(member.curve)
    }

    /// The last fit of a measured curve: of the same record and quantity.
    pub fn fit_of(&self, member: Member) -> Option<&FittedCurve> {
        let (work, curve) = (self.work(member.hand_in)?, self.curve(member)?);
        let is_of = |fit: &&FittedCurve| fit.record == curve.record && fit.quantity.name == curve.quantity.name;
        work.fits.iter().rev().find(is_of)
    }

    fn work(&self, hand_in: usize) -> Option<&Work> {
        self.entries.get(hand_in)?.work()
    }

    /// The curve of a group whose fit stands for all: the fit with the median of the root mean square residuals.
    pub fn typical_fit(&self, group: &CurveGroup) -> Option<(Member, &FittedCurve)> {
        let size =
            |fit: &FittedCurve| fit.residuals.iter().map(|one| one * one).sum::<f64>() / fit.residuals.len() as f64;
        let fitted = group.members.iter().filter_map(|member| Some((*member, self.fit_of(*member)?)));
        let mut fitted: Vec<(f64, Member, &FittedCurve)> =
            fitted.map(|(member, fit)| (size(fit), member, fit)).filter(|(size, ..)| size.is_finite()).collect();
        sort_by(&mut fitted, |one, other| one.0.total_cmp(&other.0));
        fitted.get(fitted.len().saturating_sub(1) / 2).map(|(_, member, fit)| (*member, *fit))
    }
}
