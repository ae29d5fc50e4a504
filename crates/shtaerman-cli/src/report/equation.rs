//! The answer of `equation` for people, and as CSV.

use std::fmt::Write;

use shtaerman::ErrorKind;
use shtaerman::equation::{EquationAnswer, EquationAudit, EquationCheck, SolvedEquation};

use super::{Table, Told, significant};
use crate::Failure;
use crate::output::Content;

/// Significant digits of a table.
const DIGITS: usize = 12;

/// The answer as a table; `with_places` adds the solution at the places asked for.
///
/// # Errors
/// Those of the solution at the ends.
pub(crate) fn equation_table(
    name: &str,
    solved: &SolvedEquation<'_>,
    answer: &EquationAnswer<'_>,
    with_places: bool,
) -> Result<Told, Failure> {
    let equation = match answer.lambda {
        Some(lambda) => format!("phi + lambda int K phi = f, lambda = {lambda}"),
        None => "int K phi = f".to_owned(),
    };
    let family = answer.kernel.family();
    let mut text = Told::new(format!(
        "{name}: {equation}, f = {}\n{}: K = {} on {}, by {}\n\n",
        answer.rhs,
        answer.kernel.title(),
        family.formula,
        family.interval,
        family.measure
    ));
    let [left, right] = solved.equation().shown();
    let mut table = Table::new(&["", ""]);
    let mut row = |name: String, value: Option<f64>, missing: &str| {
        let value = value.map_or(missing.to_owned(), |value| significant(value, DIGITS));
        table.row(vec![name, value]);
    };
    for (name, x) in [("left end", left), ("middle", left.midpoint(right)), ("right end", right)] {
        let name = format!("phi({}), {name}", significant(x, 6));
        row(name, solved.evaluate(x).map_err(Failure::from)?, "infinite");
    }
    row(format!("int {} dx", answer.integral_of), answer.integral, "none");
    text.table(table);
    let _ = writeln!(
        text,
        "\nmethod: {} with n = {}: {}",
        answer.method.name, answer.method.n, answer.method.reason
    );
    text.push_str(&error_line(answer));
    if let Some(audit) = &answer.audit {
        text.push_str(&audit_line(audit));
    }
    if let Some(check) = &answer.cross_check {
        text.push_str(&check_line(check));
    }
    if with_places {
        text.push('\n');
        let mut table = Table::new(&["x", "phi"]);
        for (x, phi) in answer.solution.x.iter().zip(&answer.solution.phi) {
            let phi = phi.map_or("infinite".to_owned(), |phi| significant(phi, DIGITS));
            table.row(vec![significant(*x, DIGITS), phi]);
        }
        text.table(table);
    }
    if !answer.warnings.is_empty() {
        text.push('\n');
    }
    for warning in answer.warnings {
        let _ = writeln!(text, "warning: {}", warning.message);
    }
    Ok(text)
}

fn error_line(answer: &EquationAnswer<'_>) -> String {
    let kind = match answer.error.kind {
        ErrorKind::Bound => "bound",
        ErrorKind::Estimate => "estimate",
    };
    let shown = |value: Option<f64>| value.map_or("unknown".to_owned(), |v| significant(v, 2));
    let mut line = format!(
        "error ({kind}), at most: {} {}",
        answer.error.of,
        shown(answer.error.solution_sup)
    );
    if answer.integral.is_some() {
        let _ = write!(line, ", integral {}", shown(answer.error.integral));
    }
    line.push('\n');
    line
}

fn audit_line(audit: &EquationAudit) -> String {
    let mut parts = Vec::new();
    let named = [
        ("phi", audit.solution_sup),
        ("integral", audit.integral),
        ("in the mean square", audit.mean_square),
    ];
    for (name, value) in named {
        if let Some(value) = value {
            parts.push(format!("{name} {}", significant(value, 2)));
        }
    }
    let kind = audit.kind.map_or("none", ErrorKind::name);
    match (&audit.reason, parts.is_empty()) {
        (Some(reason), true) => format!("no audit: {reason}\n"),
        (Some(reason), false) => format!(
            "audit ({kind}) by the residual, at most: {}; phi not audited: {reason}\n",
            parts.join(", ")
        ),
        (None, _) => format!("audit ({kind}) by the residual, at most: {}\n", parts.join(", ")),
    }
}

fn check_line(check: &EquationCheck) -> String {
    let mut line = format!(
        "cross-check by the {} method with n = {}: phi differs by {}, allowed {}",
        check.method,
        check.n,
        significant(check.solution_sup, 2),
        significant(check.solution_allowed, 2)
    );
    if let (Some(integral), Some(allowed)) = (check.integral, check.integral_allowed) {
        let _ = write!(
            line,
            "; integral by {}, allowed {}",
            significant(integral, 2),
            significant(allowed, 2)
        );
    }
    line.push('\n');
    line
}

/// The solution as CSV: `x,phi`; an infinite value is an empty field.
pub(crate) fn equation_csv<'a>(answer: &'a EquationAnswer<'_>) -> Content<'a> {
    let pairs = answer.solution.x.iter().zip(&answer.solution.phi);
    let value = move |phi: &Option<f64>| phi.map_or(String::new(), |phi| phi.to_string());
    Content::csv(&["x", "phi"], pairs.map(move |(x, phi)| vec![x.to_string(), value(phi)]))
}
