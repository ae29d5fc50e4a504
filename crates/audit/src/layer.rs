//! Layers `v = p^kappa` and what an error of `v` is of `p`.

/// `v = p^kappa`, of either sign.
pub(crate) fn displacement(kappa: f64, p: f64) -> f64 {
    if kappa == 1.0 { p } else { p.signum() * p.abs().powf(kappa) }
}

/// `p`, which is not negative where the layer bends.
pub(crate) fn pressure(kappa: f64, v: f64) -> f64 {
    if kappa == 1.0 { v } else { v.max(0.0).powf(1.0 / kappa) }
}

/// How far `p <= highest` may be off where `v` is by `off`: `p = v^(1/kappa)` is steepest where it is largest.
pub(crate) fn pressure_error(kappa: f64, highest: f64, off: f64) -> f64 {
    if kappa == 1.0 {
        return off;
    }
    let v = highest.powf(kappa);
    off / kappa * (v + off).powf(1.0 / kappa - 1.0)
}

/// The largest `dp/dv` up to this pressure.
pub(crate) fn softest(kappa: f64, highest: f64) -> f64 {
    if kappa == 1.0 { 1.0 } else { highest.powf(1.0 - kappa) / kappa }
}
