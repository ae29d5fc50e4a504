//! Kernels by name: what a file or a command line says, turned into a kernel of [`fredholm`].

use fredholm::kernel::{Kernel, Logarithm, MacdonaldHalfLine, SpectralRelation};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::catalogue::FAMILIES;
use crate::quantity::plain;

/// A parameter of a kernel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parameter {
    /// Its name, as in a file.
    pub name: &'static str,
    /// The range in which the kernel has its spectral relation, and why.
    pub range: &'static str,
    /// Whether it must be a whole number.
    pub is_whole: bool,
}

impl Parameter {
    pub(super) const fn real(name: &'static str, range: &'static str) -> Self {
        Self { name, range, is_whole: false }
    }

    pub(super) const fn whole(name: &'static str, range: &'static str) -> Self {
        Self { name, range, is_whole: true }
    }
}

/// A family of kernels: one of the seven, or a companion of one.
pub struct Family {
    /// Its name, as in a file.
    pub name: &'static str,
    /// Whether its interval is the half-line.
    pub is_half_line: bool,
    /// `K(x, s)` in words of a formula.
    pub formula: &'static str,
    /// The interval, as a formula.
    pub interval: &'static str,
    /// The weight of the spectral relation, as a formula.
    pub weight: &'static str,
    /// The measure of the integrals, `ds` or `s ds`.
    pub measure: &'static str,
    /// What the integral of a solution is taken of.
    pub integral_of: &'static str,
    /// Its parameters, all of them required.
    pub parameters: &'static [Parameter],
    /// The names under which the mathematics refuses them, where they differ.
    pub(super) aliases: &'static [(&'static str, &'static str)],
    /// From the values in the order of `parameters`.
    pub(super) build: fn(&[f64]) -> Result<Operator, fredholm::Error>,
}

impl std::fmt::Debug for Family {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Family")
            .field("name", &self.name)
            .field("is_half_line", &self.is_half_line)
            .finish_non_exhaustive()
    }
}

impl Family {
    /// All families.
    #[must_use]
    pub fn all() -> &'static [Self] {
        &FAMILIES
    }

    /// The family of this name, on the half-line or not.
    #[must_use]
    pub fn find(name: &str, is_half_line: bool) -> Option<&'static Self> {
        FAMILIES.iter().find(|family| family.name == name && family.is_half_line == is_half_line)
    }

    /// The names of all families, each once.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        FAMILIES.iter().filter(|family| !family.is_half_line).map(|family| family.name).collect()
    }

    /// The names of all parameters of all families, each once.
    #[must_use]
    pub fn all_parameters() -> Vec<&'static str> {
        let mut names = Vec::new();
        for parameter in FAMILIES.iter().flat_map(|family| family.parameters) {
            if !names.contains(&parameter.name) {
                names.push(parameter.name);
            }
        }
        names
    }

    /// What to call it in messages: `power`, `macdonald on the half-line`.
    #[must_use]
    pub fn title(&self) -> String {
        if self.is_half_line {
            format!("{} on the half-line", self.name)
        } else {
            self.name.to_owned()
        }
    }

    /// The parameters for messages: `a (greater than 0) and mu (...)`.
    #[must_use]
    pub fn signature(&self) -> String {
        let shown: Vec<String> = (self.parameters.iter())
            .map(|parameter| format!("{} ({})", parameter.name, parameter.range))
            .collect();
        shown.join(", ")
    }
}

/// Why a kernel cannot be had.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KernelError {
    /// The number of values is not that of the parameters.
    #[error("kernel {kernel} takes {expected} parameters, got {found}")]
    Count {
        /// Name of the kernel.
        kernel: &'static str,
        /// Parameters of the kernel.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// A parameter lies outside its range.
    #[error("{parameter} = {}: must be {requirement}", plain(*value))]
    Refused {
        /// The parameter, as in a file.
        parameter: &'static str,
        /// The value given.
        value: f64,
        /// What would be right, and why.
        requirement: &'static str,
        /// What to do instead.
        help: Option<&'static str>,
    },
    /// Something else about the kernel.
    #[error(transparent)]
    Equation(fredholm::Error),
}

/// Where the limit of kernel 2 is to be found.
const LIMIT_HELP: &str = "b = 0 has a system of its own: name = \"log-ratio-limit\", which takes a";

/// A kernel with its parameters.
pub struct NamedKernel {
    family: &'static Family,
    values: Vec<f64>,
    operator: Operator,
}

impl std::fmt::Debug for NamedKernel {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("NamedKernel")
            .field("family", &self.family.name)
            .field("values", &self.values)
            .finish_non_exhaustive()
    }
}

impl NamedKernel {
    /// A kernel of a family, with the values of its parameters in their order.
    ///
    /// ```
    /// use shtaerman::equation::{Family, NamedKernel};
    ///
    /// let family = Family::find("log", false).unwrap();
    /// let kernel = NamedKernel::new(family, &[1.0])?;
    /// assert!((kernel.relation(3)?.eigenvalue(2) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`KernelError`] for a wrong number of values or a value outside of its range.
    pub fn new(family: &'static Family, values: &[f64]) -> Result<Self, KernelError> {
        if values.len() != family.parameters.len() {
            return Err(KernelError::Count {
                kernel: family.name,
                expected: family.parameters.len(),
                found: values.len(),
            });
        }
        let operator = (family.build)(values).map_err(|error| refused(family, values, error))?;
        Ok(Self { family, values: values.to_vec(), operator })
    }

    /// Its family.
    #[must_use]
    pub fn family(&self) -> &'static Family {
        self.family
    }

    /// The parameters with their values.
    pub fn parameters(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.family
            .parameters
            .iter()
            .map(|parameter| parameter.name)
            .zip(self.values.iter().copied())
    }

    /// The value of a parameter.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<f64> {
        self.parameters().find(|(known, _)| *known == name).map(|(_, value)| value)
    }

    /// The kernel as a function.
    #[must_use]
    pub fn kernel(&self) -> &dyn Kernel {
        &*self.operator.kernel
    }

    /// The spectral relation with at least `count` eigenfunctions.
    ///
    /// # Errors
    /// Those of the preparation of kernels whose eigenfunctions have no formulae.
    pub fn relation(&self, count: usize) -> Result<Box<dyn SpectralRelation>, fredholm::Error> {
        (self.operator.relation)(count)
    }

    pub(super) fn operator(&self) -> &Operator {
        &self.operator
    }

    /// The kernel for people: `power kernel, a = 1, mu = 0.3`.
    #[must_use]
    pub fn title(&self) -> String {
        let mut text = format!("{} kernel", self.family.name);
        if self.family.is_half_line {
            text.push_str(" on the half-line");
        }
        for (name, value) in self.parameters() {
            text.push_str(&format!(", {name} = {}", plain(value)));
        }
        text
    }
}

/// `{"name": "power", "a": 1.0, "mu": 0.3}`.
impl Serialize for NamedKernel {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", self.family.name)?;
        if self.family.is_half_line {
            map.serialize_entry("interval", "half-line")?;
        }
        for (parameter, value) in self.family.parameters.iter().zip(&self.values) {
            if parameter.is_whole {
                map.serialize_entry(parameter.name, &(*value as u64))?;
            } else {
                map.serialize_entry(parameter.name, value)?;
            }
        }
        map.end()
    }
}

fn refused(family: &Family, values: &[f64], error: fredholm::Error) -> KernelError {
    let fredholm::Error::InvalidParameter { name, value, requirement } = error else {
        return KernelError::Equation(error);
    };
    let alias = family.aliases.iter().find(|(alias, _)| *alias == name);
    let parameter = alias.map_or(name, |(_, parameter)| parameter);
    let index = family.parameters.iter().position(|known| known.name == parameter);
    let value = index.map_or(value, |index| values[index]);
    let is_limit = family.name == "log-ratio" && parameter == "b" && value == 0.0;
    KernelError::Refused { parameter, value, requirement, help: is_limit.then_some(LIMIT_HELP) }
}

/// Makes the spectral relation with so many eigenfunctions.
type Relation =
    Box<dyn Fn(usize) -> Result<Box<dyn SpectralRelation>, fredholm::Error> + Send + Sync>;

/// A kernel as collocation wants it, and the way to its spectral relation.
pub(super) struct Operator {
    pub(super) kernel: Box<dyn Kernel>,
    relation: Relation,
    /// Whether the relation is computed for a number of eigenfunctions.
    pub(super) is_prepared: bool,
    pub(super) route: Route,
}

/// What a kernel has that others have not.
pub(super) enum Route {
    /// Nothing.
    General,
    /// Guaranteed bounds.
    Bounds(Logarithm),
    /// A collocation of its own.
    HalfLine(MacdonaldHalfLine),
}

impl Operator {
    /// A kernel whose eigenfunctions have formulae.
    pub(super) fn closed<R: SpectralRelation + Clone + 'static>(kernel: R) -> Self {
        let relation = kernel.clone();
        Self {
            kernel: Box::new(kernel),
            relation: Box::new(move |_| Ok(Box::new(relation.clone()))),
            is_prepared: false,
            route: Route::General,
        }
    }

    /// A kernel whose eigenfunctions are computed, so many as are asked for.
    pub(super) fn prepared<K, R>(
        kernel: K,
        relation: impl Fn(&K, usize) -> Result<R, fredholm::Error> + Send + Sync + 'static,
    ) -> Self
    where
        K: Kernel + Clone + 'static,
        R: SpectralRelation + 'static,
    {
        let source = kernel.clone();
        Self {
            kernel: Box::new(kernel),
            relation: Box::new(move |count| Ok(Box::new(relation(&source, count)?))),
            is_prepared: true,
            route: Route::General,
        }
    }

    pub(super) fn with_route(mut self, route: Route) -> Self {
        self.route = route;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values that suit every kernel.
    fn value(parameter: &str) -> f64 {
        match parameter {
            "b" | "mu" => 0.25,
            "gamma" => 0.1,
            _ => 1.0,
        }
    }

    #[test]
    fn every_family_builds_and_names_what_it_refuses() {
        for family in Family::all() {
            let values: Vec<f64> = family.parameters.iter().map(|p| value(p.name)).collect();
            let kernel = NamedKernel::new(family, &values).unwrap();
            assert!(kernel.relation(8).unwrap().eigenvalue(7) > 0.0, "{family:?}");
            assert_eq!(kernel.kernel().interval().is_finite(), !family.is_half_line);
            // The measure that is told is the measure that is used.
            let weighted = kernel.kernel().measure(0.5) != 1.0;
            assert_eq!(weighted, family.measure == "s ds", "{family:?}");
            for (index, parameter) in family.parameters.iter().enumerate() {
                for bad in [f64::NAN, f64::INFINITY, -1e300, 1e300] {
                    let mut values = values.clone();
                    values[index] = bad;
                    match NamedKernel::new(family, &values) {
                        Err(KernelError::Refused { parameter: named, requirement, .. }) => {
                            let known = family.parameters.iter().any(|p| p.name == named);
                            assert!(known || named.contains(' '), "{family:?}: {named}");
                            assert!(!requirement.is_empty());
                        }
                        Err(other) => panic!("{family:?}, {}: {other}", parameter.name),
                        // The plain logarithm knows no largest length.
                        Ok(_) => assert!(bad == 1e300 || parameter.is_whole, "{family:?}: {bad}"),
                    }
                }
            }
            let count = NamedKernel::new(family, &[]);
            assert!(matches!(count, Err(KernelError::Count { found: 0, .. })));
        }
    }

    #[test]
    fn names_are_found_once() {
        for family in Family::all() {
            let found = Family::find(family.name, family.is_half_line).unwrap();
            assert!(std::ptr::eq(found, family));
        }
        assert!(Family::find("power", true).is_none());
        assert!(Family::all_parameters().contains(&"kappa"));
    }
}
