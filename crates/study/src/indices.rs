//! Sobol's indices: how much of the variance of an output each varied value brings about.

use crate::Row;

/// The indices of one varied value for one output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// `Var(E(y | x_i))/Var(y)`: what this value brings about alone.
    pub first: f64,
    /// Its standard error, for groups that are independent.
    pub first_error: f64,
    /// `1 - Var(E(y | all but x_i))/Var(y)`: with all that it does together with others.
    pub total: f64,
    /// Its standard error, for groups that are independent.
    pub total_error: f64,
}

/// The sums from which the indices follow, filled row by row.
///
/// With `A`, `B` two points and `A_i` the first with the value `i` of the second: `Var(E(y | x_i)) = mean (y_B - c)(y_Ai - y_A)` for any `c` (A. Saltelli et al., Comput. Phys. Commun. 181
/// (2010) 259, table 2 b) and `Var - Var(E(y | all but x_i)) = mean (y_A - y_Ai)^2/2` (M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35).
#[derive(Debug, Clone, PartialEq)]
pub struct Indices {
    variables: usize,
    /// The rows of the group on its way.
    group: Vec<Row>,
    groups: usize,
    /// For each output: of `y_A` and `y_B`.
    spread: Vec<Moments>,
    /// For each output and variable: of the terms of both means.
    terms: Vec<[Moments; 2]>,
}

/// Mean and sum of the squares of the differences from it (B. P. Welford, Technometrics 4 (1962) 419).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Moments {
    count: f64,
    mean: f64,
    squares: f64,
}

impl Moments {
    fn add(&mut self, value: f64) {
        self.count += 1.0;
        let difference = value - self.mean;
        self.mean += difference / self.count;
        self.squares += difference * (value - self.mean);
    }

    fn variance(&self) -> f64 {
        self.squares / (self.count - 1.0).max(1.0)
    }

    /// The standard error of the mean; NaN of a single value, which tells nothing of it.
    fn error(&self) -> f64 {
        if self.count < 2.0 {
            return f64::NAN;
        }
        (self.variance() / self.count).sqrt()
    }
}

impl Indices {
    pub(crate) fn new(variables: usize, outputs: usize) -> Self {
        Self {
            variables,
            group: Vec::new(),
            groups: 0,
            spread: vec![Moments::default(); outputs],
            terms: vec![[Moments::default(); 2]; outputs * variables],
        }
    }

    /// Groups of which every case has an answer.
    #[must_use]
    pub fn groups(&self) -> usize {
        self.groups
    }

    /// The indices of all variables for one output; NaN where nothing varies.
    pub fn of(&self, output: usize) -> impl Iterator<Item = Index> + '_ {
        let variance = self.spread.get(output).map_or(f64::NAN, Moments::variance);
        let terms = self.terms.iter().skip(output * self.variables).take(self.variables);
        terms.map(move |[first, total]| Index {
            first: first.mean / variance,
            first_error: first.error() / variance,
            total: total.mean / variance,
            total_error: total.error() / variance,
        })
    }

    /// Takes a row in; rows come in the order of their cases, and groups that are not whole are left out.
    pub(crate) fn add(&mut self, row: &Row) {
        let size = self.variables + 2;
        if row.case.is_multiple_of(size) {
            self.group.clear();
        }
        self.group.push(row.clone());
        let is_whole = self.group.len() == size
            && self.group[0].case.is_multiple_of(size)
            && self.group.iter().all(Row::is_answered)
            && row.case + 1 == self.group[0].case + size;
        if is_whole {
            self.groups += 1;
            let group = std::mem::take(&mut self.group);
            self.add_group(&group);
        }
    }

    fn add_group(&mut self, group: &[Row]) {
        for output in 0..self.spread.len() {
            let y = |member: usize| group[member].outputs[output];
            // The mean so far keeps the products small; it knows nothing of this group.
            let centre = if self.groups > 1 { self.spread[output].mean } else { y(0) };
            for variable in 0..self.variables {
                let [first, total] = &mut self.terms[output * self.variables + variable];
                let difference = y(variable + 2) - y(0);
                first.add((y(1) - centre) * difference);
                total.add(0.5 * difference * difference);
            }
            self.spread[output].add(y(0));
            self.spread[output].add(y(1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Design;
    use crate::design::Shares;

    /// Ishigami's function, whose indices are known (T. Ishigami, T. Homma, ISUMA (1990) 398): with a = 7, b = 0.1 the first are 0.3139, 0.4424 and 0, the total 0.5576, 0.4424 and 0.2437.
    #[test]
    fn indices_of_ishigamis_function_are_found() {
        let (variables, count) = (3, 8192);
        let shares = Shares::new(Design::SobolIndices { count, seed: 3 }, variables);
        let mut indices = Indices::new(variables, 1);
        for case in 0..count * (variables + 2) {
            let x: Vec<f64> = (0..variables)
                .map(|variable| std::f64::consts::PI * (2.0 * shares.at(case, variable) - 1.0))
                .collect();
            let y = x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin();
            indices.add(&Row {
                case,
                inputs: Vec::new(),
                outputs: vec![y],
                errors: vec![None],
                error_kind: String::new(),
                warnings: String::new(),
                reason: String::new(),
            });
        }
        assert_eq!(indices.groups(), count);
        let exact = [[0.313_905, 0.557_589], [0.442_411, 0.442_411], [0.0, 0.243_684]];
        for (found, [first, total]) in indices.of(0).zip(exact) {
            assert!((found.first - first).abs() < 3.0 * found.first_error, "{found:?} {first}");
            assert!((found.total - total).abs() < 3.0 * found.total_error, "{found:?} {total}");
            assert!(found.first_error < 0.03 && found.total_error < 0.02, "{found:?}");
        }
    }
}
