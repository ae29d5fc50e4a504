//! The eigenvalues, from the matrix of the integral operator in Legendre functions.

use std::f64::consts::FRAC_PI_4;

use super::waves::inner_quotients;
use crate::Error;
use crate::basis::legendre::strengths;
use crate::basis::spheroidal::Spheroidal;
use crate::quadrature::gauss_legendre;

/// `lambda_n = d^T A d` with the coefficients `d` of `S_n` in the basis `e_j` and
///
/// `A_ij = 4 C_i C_j (-1)^(i-j) int_0^(pi/2) I_(nu_max)(q) K_(nu_min)(q) d theta`, `q = kappa sin theta`, `nu_j = m + 2j + 1/2`:
///
/// the transform of `1/sqrt(t^2 + kappa^2)` with Bessel functions, turned to the imaginary axis. The error is of second order in that of `d`. The matrix itself is not needed: the sums over `i < j` run along with
/// the quotients `I_(nu+1)/I_nu`, which neither overflow nor underflow.
pub(super) fn eigenvalues(
    harmonic: u32,
    kappa: f64,
    functions: &Spheroidal,
) -> Result<Vec<f64>, Error> {
    let (count, order) = (functions.count(), functions.order());
    let scaled = scaled(harmonic, functions);
    let rule = gauss_legendre(48 + (8.0 * kappa.sqrt()) as usize)?;
    let mut eigenvalues = vec![0.0; count];
    let mut carried = vec![0.0; count];
    let mut quotients = vec![0.0; harmonic as usize + 2 * order + 1];
    for (t, weight) in rule.nodes.iter().zip(&rule.weights) {
        let argument = kappa * (FRAC_PI_4 * (1.0 + t)).sin();
        let square = argument * argument;
        inner_quotients(square, &mut quotients);
        let mut diagonal = Diagonal::new(argument, harmonic, &quotients);
        carried.fill(0.0);
        let factor = 4.0 * FRAC_PI_4 * weight;
        for (j, row) in scaled.chunks_exact(count).enumerate() {
            let l = harmonic as usize + 2 * j;
            let product = diagonal.at(l);
            let ratio = square * quotients[l] * quotients[l + 1];
            for ((sum, carried), entry) in eigenvalues.iter_mut().zip(&mut carried).zip(row) {
                let own = product * entry;
                *sum += factor * entry * (own + 2.0 * *carried);
                *carried = ratio * (*carried + own);
            }
        }
    }
    Ok(eigenvalues)
}

/// `(-1)^j C_j d_j^{(n)}`, `n` running fastest.
fn scaled(harmonic: u32, functions: &Spheroidal) -> Vec<f64> {
    let (count, order) = (functions.count(), functions.order());
    let strengths = strengths(harmonic, order);
    let entry = |place: usize| {
        let (j, n) = (place / count, place % count);
        let value = strengths[j] * functions.coefficients(n)[j];
        if j.is_multiple_of(2) { value } else { -value }
    };
    (0..count * order).map(entry).collect()
}

/// The products `I_nu(q) K_nu(q) = 1/(q k + q i)`, `nu = l + 1/2`, with the quotients `k = K_(nu+1)/K_nu` upwards and `i = I_(nu+1)/I_nu`; `1/(2 nu)` at `q = 0`.
struct Diagonal<'q> {
    square: f64,
    inner: &'q [f64],
    /// `q K_(nu+1)/K_nu` at `l`.
    outer: f64,
    l: usize,
}

impl<'q> Diagonal<'q> {
    fn new(argument: f64, harmonic: u32, inner: &'q [f64]) -> Self {
        let mut diagonal = Self { square: argument * argument, inner, outer: argument + 1.0, l: 0 };
        diagonal.rise(harmonic as usize);
        diagonal
    }

    fn rise(&mut self, l: usize) {
        while self.l < l {
            self.l += 1;
            self.outer = (2 * self.l + 1) as f64 + self.square / self.outer;
        }
    }

    fn at(&mut self, l: usize) -> f64 {
        self.rise(l);
        1.0 / (self.outer + self.square * self.inner[l])
    }
}
