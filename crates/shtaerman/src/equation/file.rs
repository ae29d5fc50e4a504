//! Equation files: TOML read into an [`Equation`].

use std::path::Path;

use super::{Equation, Family, KernelError, Kind, MOST_DEGREE, NamedKernel};
use crate::document::{Document, Field, FileError, TableReader};
use crate::document::{load_bytes, overridden};
use crate::expression::Expression;
use crate::quantity::{self, Dimension};
use crate::{Error, MethodChoice, Solver};

/// An equation with the document it was read from, so that a fault found while solving still names file, line and field.
#[derive(Debug)]
pub struct EquationFile {
    equation: Equation,
    document: Document,
}

/// Whether a document is an equation, not a contact problem.
#[must_use]
pub fn is_equation(document: &Document) -> bool {
    ["equation", "kernel"].iter().any(|table| document.get(table).is_some())
}

impl EquationFile {
    /// Reads an equation from text; `name` is for messages.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn parse(text: &str, name: &str) -> Result<Self, Error> {
        Self::read(Document::parse(text, name)?)
    }

    /// Reads an equation file, with overrides `KEY=VALUE`.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn open(path: &Path, overrides: &[String]) -> Result<Self, Error> {
        let name = path.display().to_string();
        let bytes =
            load_bytes(path).map_err(|message| FileError::new(message).in_file(Some(&name)))?;
        Self::from_bytes(&bytes, &name, overrides)
    }

    /// Reads an equation from the bytes of a file, with overrides `KEY=VALUE`; `name` is for messages.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn from_bytes(bytes: &[u8], name: &str, overrides: &[String]) -> Result<Self, Error> {
        Self::read(overridden(bytes, name, overrides, "kernel.mu=0.3")?)
    }

    /// Reads an equation from a document.
    ///
    /// # Errors
    /// [`Error::File`] with file, line and field.
    pub fn read(document: Document) -> Result<Self, Error> {
        let equation = read(&document).map_err(|error| locate(&document, error))?;
        Ok(Self { equation, document })
    }

    /// The document, overrides included.
    #[must_use]
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The equation.
    #[must_use]
    pub fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The error with the file, and line and field where they are known; a failed numerical promise stays as it is.
    #[must_use]
    pub fn locate(&self, error: Error) -> Error {
        locate(&self.document, error)
    }
}

fn read(document: &Document) -> Result<Equation, Error> {
    let reader = document.reader();
    if !is_equation(document) {
        let fault = FileError::new("has no [equation]").in_file(document.file_name());
        let contact = ["foundation", "punch", "dimensionless"];
        let help = if contact.iter().any(|table| document.get(table).is_some()) {
            "a contact problem is solved by `shtaerman solve`"
        } else {
            "`shtaerman init --equation` writes an example"
        };
        return Err(fault.with_help(help).into());
    }
    let help = "add these lines, with values of your own:\n[equation]\nkind = \"second\"\nlambda = 1.0\nrhs = \"1 + x\"";
    let equation = reader.required("equation").map_err(or_help(help))?;
    let table = equation.table()?;
    let kind = kind(&table)?;
    let rhs = right_hand_side(&table)?;
    let help = "add these lines, with values of your own:\n[kernel]\nname = \"log\"\na = 1.0";
    let kernel_field = reader.required("kernel").map_err(or_help(help))?;
    let kernel = kernel(&kernel_field.table()?)?;
    let solver = match reader.table("solver")? {
        Some(table) => solver(&table, kind)?,
        None => Solver::default(),
    };
    reader.finish()?;
    Equation::new(kind, kernel, rhs, solver)
}

fn kind(table: &TableReader<'_>) -> Result<Kind, FileError> {
    let is_second = table.required("kind")?.one_of(&["second", "first"])? == "second";
    let written = table.optional("lambda");
    if is_second {
        let help = "phi + lambda int K phi = rhs; without phi in front the equation is of kind = \"first\"";
        let field = table.required("lambda").map_err(or_help(help))?;
        return Ok(Kind::Second { lambda: plain(&field)? });
    }
    match written {
        None => Ok(Kind::First),
        Some(field) => Err(field
            .error("belongs to kind = \"second\"; the first kind is int K phi = rhs")
            .with_help("drop lambda; a factor of the integral divides the right-hand side")),
    }
}

/// A fault with this help where it has none of its own.
fn or_help(help: &str) -> impl Fn(FileError) -> FileError {
    move |error| if error.help().is_some() { error } else { error.with_help(help) }
}

/// A number without a unit.
fn plain(field: &Field<'_>) -> Result<f64, FileError> {
    let help = "the equation has no dimensions: write a number, without quotes and unit";
    field.number().map_err(|error| if field.is_string() { or_help(help)(error) } else { error })
}

/// A formula in `x`; a bare number is a constant.
fn right_hand_side(table: &TableReader<'_>) -> Result<Expression, FileError> {
    let field = table.required("rhs")?;
    let constant = field.number().ok().map(quantity::plain);
    let text = if let Some(text) = &constant { text } else { field.string()? };
    Expression::parse(text, &[Equation::VARIABLE]).map_err(|error| {
        let fault = field.error_within(&error, error.span.clone());
        if let Some(help) = error.help() { fault.with_help(help) } else { fault }
    })
}

fn kernel(table: &TableReader<'_>) -> Result<NamedKernel, FileError> {
    let name = table.required("name")?;
    let family = family(table, &name)?;
    for key in Family::all_parameters() {
        let belongs = family.parameters.iter().any(|parameter| parameter.name == key);
        if let Some(field) = table.optional(key).filter(|_| !belongs) {
            let title = family.title();
            return Err(field
                .error(format!("is no parameter of kernel {title}"))
                .with_help(format!("kernel {title} takes {}", family.signature())));
        }
    }
    let fields = (family.parameters.iter())
        .map(|parameter| {
            let help = format!("kernel {} takes {}", family.title(), family.signature());
            let field = table.required(parameter.name).map_err(or_help(&help))?;
            let value = match parameter.name {
                // An angle may be in degrees.
                "alpha" => field.quantity(Dimension::NONE)?,
                _ if parameter.is_whole => field.count(0..=u32::MAX as usize)? as f64,
                _ => plain(&field)?,
            };
            Ok((field, value))
        })
        .collect::<Result<Vec<_>, FileError>>()?;
    let values: Vec<f64> = fields.iter().map(|(_, value)| *value).collect();
    NamedKernel::new(family, &values).map_err(|error| match error {
        KernelError::Refused { parameter, value, requirement, help } => {
            let message = format!("is {}: must be {requirement}", quantity::plain(value));
            let at = family.parameters.iter().position(|known| known.name == parameter);
            let fault = match at.and_then(|index| fields.get(index)) {
                Some((field, _)) => field.error(message),
                None => table.error(format!("{parameter} {message}")),
            };
            if let Some(help) = help { fault.with_help(help) } else { fault }
        }
        other => table.error(other),
    })
}

fn family(table: &TableReader<'_>, name: &Field<'_>) -> Result<&'static Family, FileError> {
    let chosen = name.one_of(&Family::names())?;
    let is_half_line = match table.optional("interval") {
        Some(field) => {
            let is_half_line = field.one_of(&["finite", "half-line"])? == "half-line";
            if is_half_line && Family::find(chosen, true).is_none() {
                let message = format!("is \"half-line\", which kernel {chosen} does not have");
                return Err(field.error(message).with_help("name = \"macdonald\" has it"));
            }
            is_half_line
        }
        None => false,
    };
    Family::find(chosen, is_half_line).ok_or_else(|| name.error("is no kernel"))
}

fn solver(table: &TableReader<'_>, kind: Kind) -> Result<Solver, FileError> {
    let method_field = table.optional("method");
    let method = match &method_field {
        Some(field) => match field.one_of(&["auto", "spectral", "sinc"])? {
            "spectral" => MethodChoice::Spectral,
            "sinc" if kind == Kind::First => {
                let message = "is \"sinc\", which solves equations of the second kind";
                let help = "leave it out: the first kind is solved from the spectral relation";
                return Err(field.error(message).with_help(help));
            }
            "sinc" => MethodChoice::Sinc,
            _ => MethodChoice::Auto,
        },
        None => MethodChoice::Auto,
    };
    let least = if kind == Kind::First { 1 } else { super::LEAST_DEGREE };
    let degree = match table.optional("n") {
        Some(field) if method != MethodChoice::Spectral && kind != Kind::First => {
            return Err(field.error(
                "belongs to method = \"spectral\"; collocation chooses its nodes by the error",
            ));
        }
        Some(field) => Some(field.count(least..=MOST_DEGREE)?),
        None => None,
    };
    let tolerance = table.optional("tolerance").map(|field| field.tolerance()).transpose()?;
    Ok(Solver { method, degree, tolerance, ..Solver::default() })
}

fn locate(document: &Document, error: Error) -> Error {
    let key = match &error {
        Error::File(_) => return error,
        numerical if numerical.is_numerical() && !is_too_large(numerical) => return error,
        Error::RightHandSide { .. }
        | Error::Cone { .. }
        | Error::Equation(fredholm::Error::NotFinite { .. }) => "equation.rhs",
        Error::Equation(
            fredholm::Error::TooLarge { .. }
            | fredholm::Error::TooFew { .. }
            | fredholm::Error::InvalidParameter { name: "number of eigenfunctions", .. },
        ) => "solver.n",
        Error::Equation(fredholm::Error::InvalidParameter { name: "parameter", .. }) => {
            "equation.lambda"
        }
        Error::Equation(fredholm::Error::InvalidParameter { name: "x_max", .. }) => "equation",
        Error::Equation(_) => "kernel",
        _ => "",
    };
    let message = error.to_string();
    let message = message.strip_prefix("the right-hand side ").unwrap_or(&message);
    let fault = FileError::new(message).in_file(document.file_name());
    let fault = match document.get(key).filter(|_| !key.is_empty()) {
        Some(value) => fault.of_field(key).at(value.origin()),
        None => fault,
    };
    if error.is_numerical() { Error::Beyond(fault) } else { fault.into() }
}

/// Whether the memory does not suffice, which the number of eigenfunctions decides.
fn is_too_large(error: &Error) -> bool {
    matches!(error, Error::Equation(fredholm::Error::TooLarge { .. }))
}
