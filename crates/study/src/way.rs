//! How the cases of a study are computed: only what changes anew.

use shtaerman::document::{Document, ValueKind};
use shtaerman::file::ProblemFile;
use shtaerman::{Error, Load, LoadSweep, LoadSwept, Problem, Rotational, Vertical};

use crate::design::LEAST_SHARE;
use crate::quantity::SweptCase;
use crate::{Input, Variable, Variation};

const YOUNG_MODULUS: &str = "foundation.young_modulus";

/// How a problem takes another value of a key.
type Setter = fn(&Problem, f64) -> Result<Problem, Error>;

/// How the cases are computed: by one eigendecomposition for all, else with the values of one problem replaced, else with the problem read anew for each.
#[derive(Debug, Clone, Default)]
pub(crate) struct Way {
    pub(crate) swept: Option<SweptCases>,
    pub(crate) varied: Option<VariedCases>,
}

/// A problem whose values are replaced.
#[derive(Debug, Clone)]
pub(crate) struct VariedCases {
    /// With the first values.
    file: ProblemFile,
    setters: Vec<Setter>,
    /// Whether what is doubted about the file alone is another thing with other values.
    has_varied_doubts: bool,
}

/// Cases in which `theta0` and the values of the load vary.
#[derive(Debug, Clone)]
pub(crate) struct SweptCases {
    sweep: LoadSweep,
    theta0: f64,
    load: Load,
    /// What each variable is.
    places: Vec<Place>,
}

/// What a swept variable is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Theta0,
    Vertical,
    Rotational,
}

/// The setter of a key of a problem file.
fn setter(key: &str) -> Option<Setter> {
    Some(match key {
        "dimensionless.theta0" => Problem::with_theta0,
        "foundation.roughness" => |problem, value| problem.with_roughness(value),
        YOUNG_MODULUS => Problem::with_young_modulus,
        "load.force" | "dimensionless.force" => Problem::with_force,
        "load.settlement" | "dimensionless.settlement" => Problem::with_settlement,
        "load.moment" | "dimensionless.moment" => Problem::with_moment,
        "load.eccentricity" | "dimensionless.eccentricity" => Problem::with_eccentricity,
        "load.tilt" | "dimensionless.tilt" => Problem::with_tilt,
        _ => return None,
    })
}

/// Whether a value of this key that can be set may be doubted by itself.
fn may_be_doubted(key: &str) -> bool {
    key == YOUNG_MODULUS
}

fn place(key: &str) -> Option<Place> {
    Some(match key {
        "dimensionless.theta0" => Place::Theta0,
        "dimensionless.force" | "dimensionless.settlement" => Place::Vertical,
        "dimensionless.moment" | "dimensionless.tilt" => Place::Rotational,
        _ => return None,
    })
}

impl Way {
    /// The cheapest way that gives the cases, from the file as it is and with the first values.
    pub(crate) fn of(
        document: &Document,
        variables: &[Variable],
        first: ProblemFile,
        may_sweep: bool,
    ) -> Self {
        let problem = first.problem().clone();
        let varied = VariedCases::of(document, variables, first);
        let is_sweep = varied.is_some() && may_sweep;
        // Where a sweep fails, single solves say why.
        let swept = is_sweep.then(|| SweptCases::of(variables, &problem).ok()).flatten();
        Self { swept: swept.flatten(), varied }
    }
}

impl VariedCases {
    /// None unless every key stands in the file, as a plain value that a problem can be given anew.
    fn of(document: &Document, variables: &[Variable], file: ProblemFile) -> Option<Self> {
        let setter = |variable: &Variable| {
            // A table, such as that of a power law, is more than the value.
            let is_plain = document
                .get(&variable.key)
                .is_some_and(|known| !matches!(known.kind(), ValueKind::Table(_)));
            setter(&variable.key).filter(|_| variable.is_number() && is_plain)
        };
        let setters = variables.iter().map(setter).collect::<Option<_>>()?;
        let has_varied_doubts = variables.iter().any(|variable| may_be_doubted(&variable.key));
        Some(Self { file, setters, has_varied_doubts })
    }

    /// The file of which the doubts about all cases are, if there is one.
    pub(crate) fn file(&self) -> Option<&ProblemFile> {
        (!self.has_varied_doubts).then_some(&self.file)
    }

    /// The problem with these values.
    pub(crate) fn problem(&self, inputs: &[Input]) -> Result<Problem, Error> {
        let first = self.file.problem().clone();
        self.setters.iter().zip(inputs).try_fold(first, |problem, (set, input)| {
            set(&problem, input.number().unwrap_or(f64::NAN))
        })
    }
}

impl SweptCases {
    fn of(variables: &[Variable], problem: &Problem) -> Result<Option<Self>, Error> {
        let places = variables.iter().map(|variable| place(&variable.key));
        let Some(places) = places.collect::<Option<Vec<Place>>>() else { return Ok(None) };
        let theta0 = problem.theta0();
        let mut range = [theta0; 2];
        for (variable, _) in
            variables.iter().zip(&places).filter(|(_, place)| **place == Place::Theta0)
        {
            range = ends(&variable.variation);
        }
        if !(0.0 <= range[0] && range[1].is_finite()) {
            return Ok(None);
        }
        let Some(sweep) = problem.load_sweep(range)? else { return Ok(None) };
        Ok(Some(Self { sweep, theta0, load: *problem.load(), places }))
    }

    /// Contacts of cases with these values; NaN where `theta0` or the load are none.
    pub(crate) fn cases(&self, inputs: &[Vec<Input>]) -> Vec<SweptCase> {
        let (mut theta0, mut loads) = (Vec::new(), Vec::new());
        for values in inputs {
            let (mut parameter, mut load) = (self.theta0, self.load);
            for (place, value) in self.places.iter().zip(values) {
                let value = value.number().unwrap_or(f64::NAN);
                match place {
                    Place::Theta0 => parameter = value,
                    Place::Vertical => load = with_vertical(&load, value),
                    Place::Rotational => load = with_rotational(&load, value),
                }
            }
            theta0.push(parameter);
            loads.push(load);
        }
        let mut found = vec![LoadSwept::default(); inputs.len()];
        self.sweep.run(&theta0, &loads, &mut found);
        let cases = theta0.into_iter().zip(loads).zip(found);
        cases
            .map(|((theta0, load), LoadSwept { contact, errors })| SweptCase {
                theta0,
                load,
                contact,
                errors,
            })
            .collect()
    }
}

/// A load of the same kind with another first value; one that is not finite is told by the sweep.
fn with_vertical(load: &Load, value: f64) -> Load {
    let vertical = match load.vertical() {
        Vertical::Force(_) => Vertical::Force(value),
        Vertical::Settlement(_) => Vertical::Settlement(value),
    };
    Load::new(vertical, load.rotational()).unwrap_or(*load)
}

fn with_rotational(load: &Load, value: f64) -> Load {
    let rotational = match load.rotational() {
        Rotational::Moment(_) => Rotational::Moment(value),
        Rotational::Eccentricity(_) => Rotational::Eccentricity(value),
        Rotational::Tilt(_) => Rotational::Tilt(value),
    };
    Load::new(load.vertical(), rotational).unwrap_or(*load)
}

/// The least and the largest value of a variable of numbers.
fn ends(variation: &Variation) -> [f64; 2] {
    match variation {
        Variation::Values(_) => variation
            .numbers()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]),
        Variation::Spaced(_, count) => {
            let ends =
                [0, count - 1].map(|index| variation.value(index).number().unwrap_or(f64::NAN));
            [ends[0].min(ends[1]), ends[0].max(ends[1])]
        }
        Variation::Drawn(distribution) => {
            let ends =
                [distribution.quantile(LEAST_SHARE), distribution.quantile(1.0 - LEAST_SHARE)];
            [ends[0].min(ends[1]).max(0.0), ends[0].max(ends[1])]
        }
    }
}
