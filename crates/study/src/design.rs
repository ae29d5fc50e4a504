//! Which cases a study has.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Most points of a scrambled Sobol sequence.
pub(crate) const LONGEST_SOBOL: usize = 1 << 16;

/// The least share of a distribution that is drawn; the largest is as far from 1.
pub(crate) const LEAST_SHARE: f64 = 1.0 / (1u64 << 53) as f64;

/// How the cases fill the space of the varied values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Design {
    /// Every combination; the last variable changes fastest.
    Grid,
    /// Each of as many equal shares of every distribution is met once (Technometrics 21 (1979) 239).
    LatinHypercube {
        /// Number of cases.
        count: usize,
        /// Seed of all that is random.
        seed: u64,
    },
    /// A Sobol sequence with Owen's scrambling (B. Burley, J. Comput. Graph. Tech. 9(4) (2020) 1), in 24 bits.
    Sobol {
        /// Number of cases.
        count: usize,
        /// Seed of the scrambling.
        seed: u32,
    },
    /// Groups for Sobol's indices: two points of a Sobol sequence, and for each variable the first with this one value of the second (A. Saltelli et al., Comput. Phys.
    /// Commun. 181 (2010) 259). With `d` variables a group has `d + 2` cases.
    SobolIndices {
        /// Number of groups.
        count: usize,
        /// Seed of the scrambling.
        seed: u32,
    },
    /// Independent.
    Random {
        /// Number of cases.
        count: usize,
        /// Seed of all that is random.
        seed: u64,
    },
}

/// The shares `u` of the distributions, strictly between 0 and 1.
#[derive(Debug, Clone)]
pub(crate) struct Shares {
    design: Design,
    variables: usize,
    /// For the hypercube: which of the equal shares a case has, for each variable.
    order: Vec<Vec<u32>>,
}

impl Shares {
    pub(crate) fn new(design: Design, variables: usize) -> Self {
        let order = match design {
            Design::LatinHypercube { count, seed } => {
                (0..variables).map(|variable| permutation(count, seed, variable)).collect()
            }
            _ => Vec::new(),
        };
        Self { design, variables, order }
    }

    /// The share of one variable in one case. A grid has none.
    pub(crate) fn at(&self, case: usize, variable: usize) -> f64 {
        self.drawn(case, variable).clamp(LEAST_SHARE, 1.0 - LEAST_SHARE)
    }

    fn drawn(&self, case: usize, variable: usize) -> f64 {
        match self.design {
            Design::Grid => 0.5,
            Design::LatinHypercube { count, seed } => {
                let share = f64::from(self.order[variable][case]);
                (share + uniform(seed, variable, case)) / count as f64
            }
            Design::Sobol { seed, .. } => sobol(case, variable, seed),
            Design::SobolIndices { seed, .. } => {
                let (group, member) = (case / (self.variables + 2), case % (self.variables + 2));
                let is_second = member == 1 || member == variable + 2;
                let dimension = if is_second { self.variables + variable } else { variable };
                sobol(group, dimension, seed)
            }
            Design::Random { seed, .. } => uniform(seed, variable, case),
        }
    }
}

/// A coordinate of a point of the scrambled Sobol sequence.
fn sobol(index: usize, dimension: usize, seed: u32) -> f64 {
    let share = sobol_burley::sample(index as u32, dimension as u32, seed);
    // Half a unit of the last place keeps it from 0.
    f64::from(share) + 0.5 / f64::from(1u32 << 24)
}

/// The generator of one variable: streams of one seed do not overlap.
fn generator(seed: u64, stream: u64) -> ChaCha8Rng {
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    generator.set_stream(stream);
    generator
}

/// A number strictly between 0 and 1 that belongs to variable and case.
fn uniform(seed: u64, variable: usize, case: usize) -> f64 {
    let mut generator = generator(seed, 2 * variable as u64);
    // Words of 32 bits; a case takes two.
    generator.set_word_pos(2 * case as u128);
    ((generator.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64
}

/// A random order of `0..count` (R. Durstenfeld, Commun. ACM 7 (1964) 420).
fn permutation(count: usize, seed: u64, variable: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    let mut generator = generator(seed, 2 * variable as u64 + 1);
    for last in (1..order.len()).rev() {
        order.swap(last, (generator.next_u64() % (last as u64 + 1)) as usize);
    }
    order
}

/// Cases of a study, chosen at random and in ascending order.
pub(crate) fn sample(cases: usize, wanted: usize, seed: u64) -> Vec<usize> {
    if wanted >= cases {
        return (0..cases).collect();
    }
    let mut generator = generator(seed, u64::MAX);
    let mut chosen = std::collections::BTreeSet::new();
    while chosen.len() < wanted {
        chosen.insert((generator.next_u64() % cases as u64) as usize);
    }
    chosen.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hypercube_meets_every_share_once() {
        let count = 37;
        let shares = Shares::new(Design::LatinHypercube { count, seed: 4 }, 3);
        for variable in 0..3 {
            let mut met: Vec<usize> = (0..count)
                .map(|case| (shares.at(case, variable) * count as f64) as usize)
                .collect();
            met.sort_unstable();
            assert!(met.into_iter().eq(0..count));
        }
    }

    #[test]
    fn a_sobol_sequence_has_one_point_in_each_interval_of_its_length() {
        let shares = Shares::new(Design::Sobol { count: 64, seed: 9 }, 2);
        for variable in 0..2 {
            let mut met: Vec<usize> =
                (0..64).map(|case| (shares.at(case, variable) * 64.0) as usize).collect();
            met.sort_unstable();
            assert!(met.into_iter().eq(0..64));
        }
    }

    #[test]
    fn random_shares_belong_to_their_case() {
        let shares = Shares::new(Design::Random { count: 10, seed: 1 }, 2);
        let all: Vec<f64> =
            (0..10).flat_map(|case| [shares.at(case, 0), shares.at(case, 1)]).collect();
        assert!(all.iter().all(|u| *u > 0.0 && *u < 1.0));
        let mut sorted = all.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        assert_eq!(sorted.len(), 20);
        assert_eq!(shares.at(7, 1), all[15]);
    }
}
