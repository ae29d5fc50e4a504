//! Code for the widest vectors of the processor that it runs on.

/// Runs `work` as compiled for the widest vectors that the processor at hand has. Only what is inlined into it is compiled so: loops over fixed numbers of lanes.
///
/// Multiplications and additions are rounded one by one on every width, so that results have the same bits.
#[inline(always)]
pub(crate) fn vectorised<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}
