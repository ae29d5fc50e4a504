//! Contacts that are their own mirror images: zones that are so to the last bit keep operators of half the size.

use crate::contact::edges::CLOSE;
use crate::contact::zones::Zone;

/// Makes mirror images of zones that nearly are.
pub(super) fn mirror(zones: &mut [Zone]) {
    let count = zones.len();
    let is_near = |i: usize| {
        let (one, other) = (&zones[i], &zones[count - 1 - i]);
        (one.left() + other.right()).abs() <= CLOSE && one.kinds[0] == other.kinds[1]
    };
    if !(0..count).all(is_near) {
        return;
    }
    for i in 0..count {
        let at = 0.5 * (zones[i].left() - zones[count - 1 - i].right());
        zones[i].ends[0] = at;
        zones[count - 1 - i].ends[1] = -at;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_nearly_even_becomes_even() {
        let mut zones = [Zone::within(-0.9, -0.3), Zone::within(0.3 + 1e-9, 0.9 - 1e-12)];
        mirror(&mut zones);
        assert_eq!(zones[0].left(), -zones[1].right());
        assert_eq!(zones[0].right(), -zones[1].left());
        assert!((zones[0].left() + 0.9).abs() < 1e-12 && (zones[1].left() - 0.3).abs() < 1e-9);
        let mut other = [Zone::within(-0.9, 0.8)];
        mirror(&mut other);
        assert_eq!(other, [Zone::within(-0.9, 0.8)]);
    }
}
