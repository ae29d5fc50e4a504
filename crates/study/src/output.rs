//! What is kept of an answer.

use shtaerman::document::{Field, FileError};
use shtaerman::quantity::{self, Dimension};
use shtaerman::{Contact, Criterion, Error};

use crate::answered::Answered;
use crate::quantity::{QUANTITIES, Quantity};

/// A quantity of an answer: by the name that it has in the JSON answer, or a function at a place, such as `pressure(2 mm)`.
#[derive(Debug, Clone)]
pub struct Output {
    /// Its name, as the study has it.
    pub name: String,
    pub(crate) told: Told,
}

/// What an output tells.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Told {
    /// A quantity of every contact.
    Contact(&'static Quantity),
    /// The pressure at a place of the base.
    Pressure(f64),
    /// The displacement of the surface at a place, without the layer.
    Displacement(f64),
    /// The largest stress of von Mises or shear stress below the surface, and its depth.
    Stress(Criterion),
    Depth(Criterion),
    /// The value that was looked for.
    Found,
    /// The integral of the solution of an equation.
    Integral,
    /// The solution of an equation at a place.
    Solution(f64),
}

/// What a study is of, as far as it decides which outputs there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Contact { is_dimensionless: bool, is_search: bool },
    Equation,
}

/// Outputs of a contact beside the [quantities](QUANTITIES).
const STRESSES: [(&str, Told); 4] = [
    ("max_von_mises", Told::Stress(Criterion::VonMises)),
    ("max_von_mises_depth", Told::Depth(Criterion::VonMises)),
    ("max_shear", Told::Stress(Criterion::Tresca)),
    ("max_shear_depth", Told::Depth(Criterion::Tresca)),
];
const FOUND: &str = "found";
const INTEGRAL: &str = "integral";
/// Functions of a place, as they are named in messages.
const AT_PLACES: [&str; 2] = ["pressure(x)", "displacement(x)"];
const SOLUTION: &str = "phi(x)";

impl Output {
    /// The output that an item of the list names.
    pub(crate) fn read(item: &Field<'_>, kind: Kind) -> Result<Self, FileError> {
        let name = item.string()?.trim();
        let told = match name.split_once('(') {
            Some((function, rest)) => at_place(item, kind, function.trim_end(), rest)?,
            None => plain(item.one_of(&Self::names(kind))?, kind)
                .ok_or_else(|| item.error("needs a place, such as \"phi(0.5)\""))?,
        };
        Ok(Self { name: name.to_owned(), told })
    }

    /// The value of a contact (SI units, or none for a dimensionless problem) with its stated error, where there is one; NaN for what contacts do not have.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] for a place that is not on the base, and those of [`StressField::new`](shtaerman::StressField::new).
    pub fn of_contact(&self, contact: &Contact) -> Result<(f64, Option<f64>), Error> {
        let answered = Answered::contact(std::slice::from_ref(self), contact, None)?;
        Ok((answered.outputs[0], answered.errors[0]))
    }

    /// The names of those that every contact has.
    #[must_use]
    pub fn quantities() -> Vec<&'static str> {
        QUANTITIES.iter().map(|quantity| quantity.name).collect()
    }

    /// The names of all.
    fn names(kind: Kind) -> Vec<&'static str> {
        let Kind::Contact { is_search, .. } = kind else { return vec![INTEGRAL, SOLUTION] };
        let mut names = Self::quantities();
        names.extend(STRESSES.iter().map(|(name, _)| *name));
        names.extend(AT_PLACES);
        names.extend(is_search.then_some(FOUND));
        names
    }

    /// Those that a study has which names none.
    pub(crate) fn usual(kind: Kind) -> Vec<Self> {
        let names: &[&str] = match kind {
            Kind::Equation => &[INTEGRAL],
            Kind::Contact { is_search: true, .. } => {
                &[FOUND, "settlement", "tilt", "force", "peak_pressure", "contact_width"]
            }
            Kind::Contact { .. } => {
                &["settlement", "tilt", "force", "peak_pressure", "contact_width"]
            }
        };
        let named = |name: &&str| Some(Self { name: (*name).to_owned(), told: plain(name, kind)? });
        names.iter().filter_map(named).collect()
    }

    /// The place at which it is told.
    pub(crate) fn place(&self) -> Option<f64> {
        match self.told {
            Told::Pressure(x) | Told::Solution(x) => Some(x),
            _ => None,
        }
    }

    /// The quantity of every contact that it is.
    pub(crate) fn quantity(&self) -> Option<&'static Quantity> {
        if let Told::Contact(quantity) = self.told { Some(quantity) } else { None }
    }

    /// Whether stresses below the surface have to be known.
    pub(crate) fn is_stress(&self) -> bool {
        matches!(self.told, Told::Stress(_) | Told::Depth(_))
    }
}

fn plain(name: &str, kind: Kind) -> Option<Told> {
    if kind == Kind::Equation {
        return (name == INTEGRAL).then_some(Told::Integral);
    }
    let quantity = QUANTITIES.iter().find(|quantity| quantity.name == name).map(Told::Contact);
    let stress = STRESSES.iter().find(|(known, _)| *known == name).map(|(_, told)| *told);
    quantity.or(stress).or((name == FOUND).then_some(Told::Found))
}

/// `pressure(2 mm)`, of which `rest` is what stands behind the bracket.
fn at_place(item: &Field<'_>, kind: Kind, function: &str, rest: &str) -> Result<Told, FileError> {
    let (told, dimension): (fn(f64) -> Told, _) = match (kind, function) {
        (Kind::Equation, "phi") => (Told::Solution, Dimension::NONE),
        (Kind::Contact { is_dimensionless, .. }, "pressure" | "displacement") => {
            let told = if function == "pressure" { Told::Pressure } else { Told::Displacement };
            (told, if is_dimensionless { Dimension::NONE } else { Dimension::LENGTH })
        }
        (Kind::Equation, _) => return Err(item.error("is none: at a place there is phi(x)")),
        (Kind::Contact { .. }, _) => {
            return Err(
                item.error(format!("is none: at a place there are {}", AT_PLACES.join(" and ")))
            );
        }
    };
    let Some(text) = rest.strip_suffix(')').map(str::trim) else {
        return Err(item.error("has no bracket at its end"));
    };
    let place = quantity::parse(text).and_then(|read| read.of(dimension, text));
    let example = if dimension == Dimension::NONE { "0.5" } else { "2 mm" };
    place.map(told).map_err(|error| {
        item.error(format!("`{function}({text})`: the place {error}"))
            .with_help(format!("write a place, such as \"{function}({example})\""))
    })
}
