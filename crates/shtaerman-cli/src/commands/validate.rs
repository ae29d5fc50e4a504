//! `shtaerman validate`.

use std::path::Path;

use shtaerman::equation::{Equation, Kind};
use shtaerman::file::AnyFile;
use shtaerman::{Law, Problem};

use super::problem_file;
use crate::Failure;
use crate::arguments::ValidateArguments;
use crate::output::Outputs;
use crate::report::significant;

pub(super) fn run(arguments: &ValidateArguments) -> Result<(), Failure> {
    // Standard input is read once.
    let is_file = arguments.problem.file != Path::new("-");
    let study = if is_file { problem_file::read_study(&arguments.problem)? } else { None };
    let said = match study {
        Some(study) => format!(
            "study of {} cases over {}",
            study.cases(),
            study.variables().iter().map(|one| one.key.as_str()).collect::<Vec<_>>().join(", ")
        ),
        None => match problem_file::read_any(&arguments.problem)? {
            AnyFile::Problem(file) => {
                file.problem().check().map_err(|error| file.locate(error))?;
                problem_file::check_input(&file, &arguments.sense, false)?;
                problem(file.problem())
            }
            AnyFile::Equation(file) => equation(file.equation()),
        },
    };
    let mut outputs = Outputs::default();
    let name = problem_file::name(&arguments.problem.file);
    outputs.result(None, format!("{name}: valid; {said}\n"));
    outputs.write()
}

fn problem(problem: &Problem) -> String {
    let kind = if problem.is_dimensionless() { "dimensionless" } else { "physical" };
    let degree = problem.solver().degree().map_or(String::new(), |n| format!(", n = {n}"));
    let surface = match problem.foundation().law() {
        Law::Smooth => "smooth surface".to_owned(),
        Law::Linear | Law::Power(_) => {
            format!("theta0 = {}", significant(problem.theta0(), 8))
        }
    };
    format!("{kind} problem, {surface}{degree}")
}

fn equation(equation: &Equation) -> String {
    let kind = match equation.kind() {
        Kind::Second { lambda } => format!("the second kind, lambda = {lambda}"),
        Kind::First => "the first kind".to_owned(),
    };
    format!("equation of {kind}; {}", equation.kernel().title())
}
