//! Lists of the values that were wanted latest, shared by threads.

use std::sync::{Mutex, PoisonError};

use crate::Error;

/// Most values kept in a list (memory: 24 operators of half a megabyte).
const KEPT: usize = 24;

/// The value with this key, which becomes the latest; a new one, if it is small, in the place of the one not wanted for longest.
pub(crate) fn cached<K: PartialEq, V: Clone>(
    list: &Mutex<Vec<(K, V)>>,
    key: K,
    is_small: impl FnOnce(&V) -> bool,
    make: impl FnOnce() -> Result<V, Error>,
) -> Result<V, Error> {
    let locked = || list.lock().unwrap_or_else(PoisonError::into_inner);
    let known = |list: &Vec<(K, V)>| list.iter().position(|(known, _)| *known == key);
    let mut list = locked();
    if let Some(index) = known(&list) {
        list[index..].rotate_left(1);
        return Ok(list[list.len() - 1].1.clone());
    }
    drop(list);
    let value = make()?;
    let mut list = locked();
    // Another thread may have been first.
    if is_small(&value) && known(&list).is_none() {
        if list.len() >= KEPT {
            list.remove(0);
        }
        list.push((key, value.clone()));
    }
    Ok(value)
}

/// Keeps every value.
pub(crate) fn always<V>(_: &V) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest value that is kept.
    const LARGEST: usize = 2570;

    #[test]
    fn the_latest_are_kept() {
        let list = Mutex::new(Vec::new());
        let made = std::cell::Cell::new(0);
        let value = |key: usize| {
            let make = || {
                made.set(made.get() + 1);
                Ok(10 * key)
            };
            cached(&list, key, |value| *value < LARGEST, make).unwrap()
        };
        for key in (0..KEPT).chain([0, KEPT]) {
            assert_eq!(value(key), 10 * key);
        }
        assert_eq!(made.get(), KEPT + 1);
        for key in [0, 2, KEPT] {
            assert_eq!(value(key), 10 * key);
        }
        assert_eq!(made.get(), KEPT + 1);
        // The one not wanted for longest is made again, and what is large each time.
        for key in [1, LARGEST, LARGEST] {
            assert_eq!(value(key), 10 * key);
        }
        assert_eq!(made.get(), KEPT + 4);
    }
}
