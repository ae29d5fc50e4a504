//! Square matrices by columns, for factorisation in place.

use faer::MatMut;

/// Numbers in a line of the processor's cache, at which every column starts.
const LINE: usize = 8;

/// A square matrix of which each column starts at a line of the cache.
///
/// The memory is asked for without an alignment, with some room to choose the start in: what is freed then serves the next matrix of the same size. Memory asked for with an alignment does
/// not (the block that was freed is too short for the next such request of its own size), and a page that is touched for the first time costs microseconds.
#[derive(Debug)]
pub(super) struct Columns {
    entries: Vec<f64>,
    start: usize,
    stride: usize,
    order: usize,
}

impl Columns {
    pub(super) fn zeros(order: usize) -> Self {
        let stride = order.next_multiple_of(LINE);
        let entries = vec![0.0; order * stride + LINE];
        let start = entries.as_ptr().align_offset(LINE * size_of::<f64>()).min(LINE);
        Self { entries, start, stride, order }
    }

    pub(super) fn order(&self) -> usize {
        self.order
    }

    pub(super) fn column(&self, j: usize) -> &[f64] {
        &self.entries[self.start + j * self.stride..][..self.order]
    }

    pub(super) fn column_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.entries[self.start + j * self.stride..][..self.order]
    }

    /// What the library underneath works on.
    pub(super) fn as_library(&mut self) -> MatMut<'_, f64> {
        let entries = &mut self.entries[self.start..];
        MatMut::from_column_major_slice_with_stride_mut(
            entries,
            self.order,
            self.order,
            self.stride,
        )
    }
}

impl Clone for Columns {
    fn clone(&self) -> Self {
        let mut copy = Self::zeros(self.order);
        (0..self.order).for_each(|j| copy.column_mut(j).copy_from_slice(self.column(j)));
        copy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_start_at_lines_and_do_not_overlap() {
        for order in [1, 7, 8, 9, 100] {
            let mut columns = Columns::zeros(order);
            for j in 0..order {
                assert!(columns.column(j).iter().all(|entry| *entry == 0.0));
                columns.column_mut(j).fill(j as f64 + 1.0);
                assert_eq!(columns.column(j).as_ptr() as usize % 64, 0);
            }
            let copy = columns.clone();
            assert!((0..order).all(|j| copy.column(j) == vec![j as f64 + 1.0; order]));
            assert_eq!(columns.as_library()[(order - 1, 0)], 1.0);
        }
    }
}
