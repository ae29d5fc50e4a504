//! Regularity of the infinite systems against direct summation with bounds of the tails.

#[cfg(test)]
mod direct;
#[cfg(test)]
mod paper_bounds;
#[cfg(test)]
mod report;
#[cfg(test)]
mod row_sums;
