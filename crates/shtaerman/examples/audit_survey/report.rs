//! Counts, quantiles and everything that is wrong.

use std::collections::BTreeMap;

use super::draw::Case;
use super::judge::{Answered, Outcome};

#[derive(Default)]
struct Class {
    answered: usize,
    checked: usize,
    violations: usize,
    limits: usize,
    refused: usize,
    slow: usize,
}

impl Class {
    fn add(&mut self, outcome: Option<&Outcome>) {
        match outcome {
            None => self.slow += 1,
            Some(Outcome::NoProblem(_)) => {}
            Some(Outcome::Limit(_)) => self.limits += 1,
            Some(Outcome::Refused(_)) => self.refused += 1,
            Some(Outcome::Answered(answered)) => {
                self.answered += 1;
                if let Some(checked) = &answered.checked {
                    self.checked += 1;
                    self.violations += usize::from(checked.violation.is_some());
                }
            }
        }
    }
}

/// What became of all problems.
#[derive(Default)]
pub(crate) struct Report {
    classes: BTreeMap<String, Class>,
    no_problem: BTreeMap<String, usize>,
    limits: BTreeMap<String, usize>,
    refusals: Vec<String>,
    unchecked: BTreeMap<String, usize>,
    audits: BTreeMap<&'static str, usize>,
    ratios: Vec<f64>,
    coarse: [Vec<f64>; 2],
    reached: Vec<f64>,
    costs: Vec<f64>,
    times: Vec<(f64, u64, String)>,
}

impl Report {
    pub(crate) fn add(&mut self, index: u64, case: &Case, outcome: Option<Outcome>, time: f64) {
        // Counted by geometry or kernel, and by the base.
        let (setting, base) = case.class.split_once(", ").unwrap_or((&case.class, "any base"));
        let keys = [setting.to_owned(), format!("  {base}")];
        for key in keys {
            self.classes.entry(key).or_default().add(outcome.as_ref());
        }
        let name = format!("{index} ({})", case.class);
        match outcome {
            None => {
                self.refusals.push(format!("{name}: no answer in 20 s"));
                println!("SLOW {name}\n{}", case.toml);
            }
            Some(Outcome::NoProblem(reason)) => count(&mut self.no_problem, &reason),
            Some(Outcome::Limit(reason)) => count(&mut self.limits, &reason),
            Some(Outcome::Refused(reason)) => {
                println!("REFUSED {name}: {reason}\n{}", case.toml);
                self.refusals.push(format!("{name}: {reason}"));
            }
            Some(Outcome::Answered(answered)) => self.answered(index, case, &name, *answered, time),
        }
    }

    fn answered(&mut self, index: u64, case: &Case, name: &str, answered: Answered, time: f64) {
        *self.audits.entry(answered.audit).or_default() += 1;
        let [reached, aim] = answered.reached;
        self.reached.push(reached / aim);
        let [solve, audit] = answered.times;
        if audit > 0.0 && answered.audit != "none" && !case.is_equation {
            self.costs.push(audit / solve);
        }
        self.times.push((solve + audit, index, case.class.clone()));
        for (all, own) in self.coarse.iter_mut().zip(answered.coarse) {
            all.extend(own);
        }
        if let Some(reason) = answered.unchecked {
            count(&mut self.unchecked, &reason);
        }
        if let Some(checked) = answered.checked {
            self.ratios.extend(checked.ratios);
            if let Some(violation) = checked.violation {
                println!("VIOLATION {name} after {time:.1} s: {violation}\n{}", case.toml);
            }
        }
    }

    pub(crate) fn has_violations(&self) -> bool {
        self.total().violations > 0
    }

    /// Counts of every problem once.
    fn total(&self) -> Class {
        let mut total = Class::default();
        let settings = self.classes.iter().filter(|(name, _)| !name.starts_with(' '));
        for (_, class) in settings {
            total.answered += class.answered;
            total.checked += class.checked;
            total.violations += class.violations;
            total.limits += class.limits;
            total.refused += class.refused;
            total.slow += class.slow;
        }
        total
    }

    /// A line of progress.
    pub(crate) fn counts(&self) -> String {
        let Class { answered, checked, violations, refused, slow, .. } = self.total();
        format!(
            "{answered} answered, {checked} checked, {violations} violations, {refused} refused, {slow} slow"
        )
    }

    pub(crate) fn print(&mut self) {
        println!("\n{:44} answered checked violations limits refused slow", "class");
        for (name, class) in &self.classes {
            let Class { answered, checked, violations, limits, refused, slow } = class;
            println!(
                "{name:44} {answered:8} {checked:7} {violations:10} {limits:6} {refused:7} {slow:4}"
            );
        }
        let Class { answered, checked, violations, limits, refused, slow } = self.total();
        println!(
            "{:44} {answered:8} {checked:7} {violations:10} {limits:6} {refused:7} {slow:4}",
            "all"
        );
        let all = answered + refused + slow;
        println!(
            "refused beside the limits that are named: {:.2} %",
            100.0 * (refused + slow) as f64 / all.max(1) as f64
        );
        for refusal in &self.refusals {
            println!("  {refusal}");
        }
        println!("audits: {:?}", self.audits);
        let reasons = [
            ("states no problem", &self.no_problem),
            ("refused for a limit that is named", &self.limits),
            ("not checked", &self.unchecked),
        ];
        for (name, counts) in reasons {
            counts.iter().for_each(|(reason, times)| println!("{name}, {times} times: {reason}"));
        }
        quantiles(
            "stated over true error, where that is above 1e-11 of its size",
            &mut self.ratios,
        );
        let names = ["pressures", "displacements and loads"];
        for (name, values) in names.into_iter().zip(&mut self.coarse) {
            quantiles(
                &format!("the same of bilateral contacts with solver.n = 6, 20, 60, 180, {name}"),
                values,
            );
        }
        quantiles("relative error stated over what is aimed at", &mut self.reached);
        quantiles("time of the audit over that of the solve", &mut self.costs);
        self.times.sort_by(|one, two| two.0.total_cmp(&one.0));
        for (time, index, class) in self.times.iter().take(5) {
            println!("slowest: {time:.2} s, {index} ({class})");
        }
    }
}

/// Counts reasons that are alike but for their numbers.
fn count(reasons: &mut BTreeMap<String, usize>, reason: &str) {
    let words = reason.split(|c: char| c.is_ascii_digit() || ".-".contains(c));
    let words: Vec<&str> = words.map(str::trim).filter(|word| word.len() > 1).collect();
    *reasons.entry(words.join(" ")).or_default() += 1;
}

fn quantiles(name: &str, values: &mut [f64]) {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| {
        values
            .get(((values.len() as f64 * share) as usize).min(values.len().saturating_sub(1)))
            .copied()
            .unwrap_or(f64::NAN)
    };
    println!(
        "{name}: {} values, least {:.2e}, median {:.2e}, 90 % {:.2e}, 99 % {:.2e}, largest {:.2e}",
        values.len(),
        at(0.0),
        at(0.5),
        at(0.9),
        at(0.99),
        at(1.0)
    );
}
