//! Work in parts that do not depend on each other, on all processors: what is found is the same whoever does which part.

use std::num::NonZero;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// What the work makes of each part, so many together, in their order. A part ought to take far longer than the 50 us or so in which the system begins a thread; where it gives none, this one does all.
pub(crate) fn each<T: Sync, R: Send>(
    all: &[T],
    together: usize,
    work: impl Fn(&[T]) -> R + Sync,
) -> Vec<R> {
    if all.len() <= together {
        return all.chunks(together).map(work).collect();
    }
    let parts: Vec<&[T]> = all.chunks(together).collect();
    each_on(processors(), &parts, |part| work(part))
}

/// The same on so many processors.
fn each_on<T: Sync, R: Send>(
    processors: usize,
    parts: &[T],
    work: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let all = || {
        let mut found = Vec::new();
        while let Some((index, part)) = {
            let index = next.fetch_add(1, Ordering::Relaxed);
            parts.get(index).map(|part| (index, part))
        } {
            found.push((index, work(part)));
        }
        found
    };
    let mut found = thread::scope(|scope| {
        let others = parts.len().min(processors).saturating_sub(1);
        let begun = (0..others).map(|_| thread::Builder::new().spawn_scoped(scope, all));
        let others: Vec<_> = begun.filter_map(Result::ok).collect();
        let mut found = all();
        for other in others {
            found.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        found
    });
    found.sort_unstable_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, found)| found).collect()
}

fn processors() -> usize {
    static KNOWN: OnceLock<usize> = OnceLock::new();
    *KNOWN.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
}

#[cfg(test)]
mod tests {
    use super::each_on;

    #[test]
    fn parts_come_back_in_their_order() {
        for count in [0_usize, 1, 2, 1000] {
            let parts: Vec<usize> = (0..count).collect();
            let squares: Vec<usize> = parts.iter().map(|part| part * part).collect();
            for processors in [1, 2, 7, 2000] {
                assert_eq!(each_on(processors, &parts, |part| part * part), squares);
            }
        }
    }
}
