//! Counts, quantiles and everything that is wrong.

use std::collections::BTreeMap;

use crate::draw::Case;
use crate::judge::Outcome;

#[derive(Default)]
struct Class {
    answered: usize,
    checked: usize,
    violations: usize,
    limits: usize,
    refused: usize,
    slow: usize,
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
    reached: Vec<f64>,
    costs: Vec<f64>,
    times: Vec<(f64, u64, String)>,
}

impl Report {
    pub(crate) fn add(&mut self, index: u64, case: &Case, outcome: Option<Outcome>, time: f64) {
        // The geometry or kernel, and the base.
        let class = self.classes.entry(case.class.clone()).or_default();
        let name = format!("{index} ({})", case.class);
        match outcome {
            None => {
                class.slow += 1;
                self.refusals.push(format!("{name}: no answer in 20 s"));
                println!("SLOW {name}\n{}", case.toml);
            }
            Some(Outcome::NoProblem(reason)) => count(&mut self.no_problem, &reason),
            Some(Outcome::Limit(reason)) => {
                class.limits += 1;
                count(&mut self.limits, &reason);
            }
            Some(Outcome::Refused(reason)) => {
                class.refused += 1;
                println!("REFUSED {name}: {reason}\n{}", case.toml);
                self.refusals.push(format!("{name}: {reason}"));
            }
            Some(Outcome::Answered(answered)) => {
                class.answered += 1;
                *self.audits.entry(answered.audit).or_default() += 1;
                let [reached, aim] = answered.reached;
                self.reached.push(reached / aim);
                let [solve, audit] = answered.times;
                if audit > 0.0 && !case.is_equation {
                    self.costs.push(audit / solve);
                }
                self.times.push((solve + audit, index, case.class.clone()));
                if let Some(reason) = answered.unchecked {
                    count(&mut self.unchecked, &reason);
                }
                if let Some(checked) = answered.checked {
                    class.checked += 1;
                    self.ratios.extend(checked.ratios);
                    if let Some(violation) = checked.violation {
                        class.violations += 1;
                        println!("VIOLATION {name} after {time:.1} s: {violation}\n{}", case.toml);
                    }
                }
            }
        }
    }

    pub(crate) fn has_violations(&self) -> bool {
        self.classes.values().any(|class| class.violations > 0)
    }

    pub(crate) fn print(&mut self) {
        println!("\n{:44} answered checked violations limits refused slow", "class");
        let mut total = Class::default();
        for (name, class) in &self.classes {
            let Class { answered, checked, violations, limits, refused, slow } = class;
            println!(
                "{name:44} {answered:8} {checked:7} {violations:10} {limits:6} {refused:7} {slow:4}"
            );
            total.answered += answered;
            total.checked += checked;
            total.violations += violations;
            total.limits += limits;
            total.refused += refused;
            total.slow += slow;
        }
        let Class { answered, checked, violations, limits, refused, slow } = total;
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
