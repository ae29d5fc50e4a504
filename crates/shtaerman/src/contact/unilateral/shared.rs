//! Operators of one punch on a half-plane in local coordinates: they depend on the number of nodes alone, so all problems share those used last.

use std::sync::{Arc, Mutex, PoisonError};

use fredholm::SincOperator;

use crate::Error;

/// Most operators that are kept, and most nodes on either side of the middle: together they stay below 30 MB.
const MOST: usize = 24;
const LARGEST: usize = 240;

/// Numbers of nodes with their operators, those used last first.
type Known = Vec<(usize, Arc<SincOperator>)>;

static KNOWN: Mutex<Known> = Mutex::new(Vec::new());

/// The operator with so many nodes on either side of the middle, which is built where it is not known.
pub(super) fn operator(
    half_count: usize,
    build: impl FnOnce() -> Result<Arc<SincOperator>, Error>,
) -> Result<Arc<SincOperator>, Error> {
    if half_count > LARGEST {
        return build();
    }
    if let Some(operator) = recalled(half_count) {
        return Ok(operator);
    }
    // Without the lock: others need not wait for it.
    let operator = build()?;
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if known.iter().all(|(count, _)| *count != half_count) {
        known.insert(0, (half_count, Arc::clone(&operator)));
        known.truncate(MOST);
    }
    Ok(operator)
}

fn recalled(half_count: usize) -> Option<Arc<SincOperator>> {
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let at = known.iter().position(|(count, _)| *count == half_count)?;
    known[..=at].rotate_right(1);
    known.first().map(|(_, operator)| Arc::clone(operator))
}
