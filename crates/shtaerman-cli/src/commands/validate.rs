//! `shtaerman validate`.

use super::problem_file;
use crate::Failure;
use crate::arguments::ValidateArguments;
use crate::output::Outputs;
use crate::report::significant;

pub(super) fn run(arguments: &ValidateArguments) -> Result<(), Failure> {
    let file = problem_file::read(&arguments.problem)?;
    let problem = file.problem();
    let kind = if problem.frame().scaling().is_some() { "physical" } else { "dimensionless" };
    let degree = problem.solver().degree.map_or(String::new(), |n| format!(", n = {n}"));
    let mut outputs = Outputs::default();
    outputs.result(
        None,
        format!(
            "{}: valid; {kind} problem, theta0 = {}{degree}\n",
            problem_file::name(&arguments.problem.file),
            significant(problem.frame().theta0(), 8)
        ),
    );
    outputs.write()
}
