//! The memory of the process.

use std::hint::black_box;

/// A block a little below the 32 MB up to which the GNU C library adapts its limit, in bytes; two pages are for what it adds of its own.
const BLOCK: usize = (32 << 20) - 8192;

/// Lets the C library keep freed blocks of up to that size for later ones. A program that solves many problems calls it once, at its start, as the command line does.
///
/// The GNU C library begins with giving freed blocks of 128 KB and more back to the system; its limit rises to the size of the largest block freed so far, here to that of one that was
/// never touched. A page that the system hands out anew costs microseconds, and a solution takes and frees matrices of the same size all the time: three zones on a rough surface are solved
/// in a tenth less of the time (`cargo bench -p shtaerman --bench unilateral`). Up to twice that size stays with the process. Other C libraries are not changed by it.
///
/// ```
/// shtaerman::keep_freed_blocks();
/// ```
pub fn keep_freed_blocks() {
    let mut block = Vec::<u8>::new();
    // Where memory is that short, all stays as it is.
    if block.try_reserve_exact(BLOCK).is_ok() {
        black_box(block.as_mut_ptr());
    }
}
