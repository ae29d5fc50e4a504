//! `shtaerman spectrum`.

use shtaerman::equation::{Family, KernelError, NamedKernel, Parameter, Spectrum};
use shtaerman::quantity::{self, Dimension};

use super::picture::Picture;
use crate::Failure;
use crate::arguments::{KernelArguments, ReportFormat, SpectrumArguments};
use crate::failure::shown;
use crate::output::{Content, Outputs, check_writable};
use crate::plot::{Arrangement, Curve, CurvePanel, CurveScaling, CurvesPlot};
use crate::report::{self, Table};

/// Eigenfunctions that are drawn.
const DRAWN: usize = 5;
/// Intervals between the points of their curves.
const PLOT_INTERVALS: u32 = 400;

pub(super) fn run(arguments: &SpectrumArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    check_writable(&[arguments.output.output.as_deref(), arguments.plot.as_deref()], &[])?;
    let kernel = kernel(arguments)?;
    let spectrum = Spectrum::new(&kernel, arguments.count, arguments.verify).map_err(usage)?;
    let text = match arguments.output.format {
        ReportFormat::Table => {
            let mut text = table(&spectrum);
            if let Some(path) = &arguments.plot {
                text.push_str(&format!("\nplot: {}\n", shown(path)));
            }
            Content::page(&text)
        }
        ReportFormat::Json => Content::json(&spectrum),
        ReportFormat::Csv => csv(&spectrum),
    };
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.output.as_deref(), text);
    if let Some(picture) = picture {
        picture.draw(&plot(&spectrum), &mut outputs)?;
    }
    outputs.write()?;
    verdict(&spectrum)
}

/// The spectrum as JSON, whatever the format asked for; fails where it is to be verified and does not pass.
pub(super) fn json(arguments: &SpectrumArguments) -> Result<String, Failure> {
    let kernel = kernel(arguments)?;
    let spectrum = Spectrum::new(&kernel, arguments.count, arguments.verify).map_err(usage)?;
    verdict(&spectrum)?;
    Content::json(&spectrum).text()
}

/// Values that make no sense are the fault of the arguments, and named as they are written there.
pub(super) fn usage(error: shtaerman::Error) -> Failure {
    match error {
        shtaerman::Error::InvalidValue { field, value, requirement } => {
            Failure::Usage(format!("--{field} {value}: must be {requirement}"))
        }
        other => Failure::Problem(other),
    }
}

fn kernel(arguments: &SpectrumArguments) -> Result<NamedKernel, Failure> {
    let family = family(arguments)?;
    let takes = || format!("kernel {} takes {}", family.title(), options(family));
    for name in Family::all_parameters() {
        let belongs = family.parameters.iter().any(|parameter| parameter.name == name);
        if !belongs && written(&arguments.parameters, name).is_some() {
            return Err(Failure::Usage(format!("--{name} does not belong here: {}", takes())));
        }
    }
    let values = (family.parameters.iter())
        .map(|parameter| match written(&arguments.parameters, parameter.name) {
            Some(text) => value(parameter, text),
            None => Err(Failure::Usage(format!("--{} is missing: {}", parameter.name, takes()))),
        })
        .collect::<Result<Vec<_>, _>>()?;
    named(family, &values)
}

/// The kernel with these values of its parameters.
pub(super) fn named(family: &'static Family, values: &[f64]) -> Result<NamedKernel, Failure> {
    NamedKernel::new(family, values).map_err(|error| match error {
        KernelError::Refused { parameter, value, requirement, help } => {
            let help = help.map_or(String::new(), |help| format!("; {help}"));
            Failure::Usage(format!("--{parameter} {value}: must be {requirement}{help}"))
        }
        other => Failure::Usage(other.to_string()),
    })
}

fn family(arguments: &SpectrumArguments) -> Result<&'static Family, Failure> {
    let name = arguments.kernel.as_str();
    if Family::find(name, false).is_none() {
        let guess = shtaerman::equation::suggestion(name)
            .map_or(".".to_owned(), |known| format!(", did you mean {known}?"));
        let names = Family::names().join(", ");
        return Err(Failure::Usage(format!("{name:?} is no kernel{guess} Kernels: {names}")));
    }
    let is_half_line = match arguments.parameters.interval.as_deref() {
        None | Some("finite") => false,
        Some("half-line") => true,
        Some(other) => {
            let message = format!("--interval {other}: must be \"finite\" or \"half-line\"");
            return Err(Failure::Usage(message));
        }
    };
    Family::find(name, is_half_line).ok_or_else(|| {
        Failure::Usage(format!(
            "--interval half-line: kernel {name} does not have it, macdonald has"
        ))
    })
}

/// `--a A (greater than 0), ...`
fn options(family: &Family) -> String {
    let option = |parameter: &Parameter| format!("--{} ({})", parameter.name, parameter.range);
    family.parameters.iter().map(option).collect::<Vec<_>>().join(", ")
}

fn written<'a>(arguments: &'a KernelArguments, name: &str) -> Option<&'a str> {
    let option = match name {
        "a" => &arguments.a,
        "b" => &arguments.b,
        "alpha" => &arguments.alpha,
        "mu" => &arguments.mu,
        "kappa" => &arguments.kappa,
        "gamma" => &arguments.gamma,
        "chi0" => &arguments.chi0,
        "m" => &arguments.m,
        _ => &None,
    };
    option.as_deref()
}

fn value(parameter: &Parameter, text: &str) -> Result<f64, Failure> {
    let name = parameter.name;
    if parameter.is_whole {
        let whole = text.trim().parse::<u32>();
        return whole
            .map(f64::from)
            .map_err(|_| Failure::Usage(format!("--{name} {text}: is a whole number, 0 or more")));
    }
    let parsed = quantity::parse(text).and_then(|quantity| quantity.of(Dimension::NONE, text));
    parsed.map_err(|error| Failure::Usage(format!("--{name} {text}: {error}")))
}

fn table(spectrum: &Spectrum<'_>) -> String {
    let mut text = format!(
        "{}\nK(x, s) = {} on {}, by {}; weight w = {}\n\n",
        spectrum.kernel.title(),
        spectrum.formula,
        spectrum.interval,
        spectrum.measure,
        spectrum.weight
    );
    let mut table = Table::new(&["n", "eigenvalue", "norm", "expansion factor"]);
    for (i, n) in spectrum.index.iter().enumerate() {
        table.row(vec![
            n.to_string(),
            report::significant(spectrum.eigenvalue[i], 14),
            report::significant(spectrum.norm[i], 14),
            report::significant(spectrum.expansion_factor[i], 14),
        ]);
    }
    text.push_str(&table.to_string());
    if let Some(check) = &spectrum.verify {
        text.push_str("\nworst errors against independent quadrature\n\n");
        let mut table = Table::new(&["check", "worst error", "at most", ""]);
        for report in check.reports() {
            table.row(vec![
                report.name.replace('_', " "),
                format!("{:.1e}", report.error),
                format!("{:.0e}", report.limit),
                if report.passes() { "ok" } else { "FAILS" }.to_owned(),
            ]);
        }
        text.push_str(&table.to_string());
        text.push_str(&format!("\nterms of the bilinear sum: {}\n", check.terms));
    }
    text
}

fn csv<'a>(spectrum: &'a Spectrum<'_>) -> Content<'a> {
    let rows = spectrum.index.iter().enumerate().map(|(i, n)| {
        vec![
            n.to_string(),
            spectrum.eigenvalue[i].to_string(),
            spectrum.norm[i].to_string(),
            spectrum.expansion_factor[i].to_string(),
        ]
    });
    Content::csv(&["index", "eigenvalue", "norm", "expansion_factor"], rows)
}

fn verdict(spectrum: &Spectrum<'_>) -> Result<(), Failure> {
    let Some(check) = spectrum.verify.as_ref().filter(|check| !check.passes) else {
        return Ok(());
    };
    let failed: Vec<String> = (check.reports().iter().filter(|report| !report.passes()))
        .map(|report| format!("{} {:.1e}", report.name.replace('_', " "), report.error))
        .collect();
    Err(Failure::Check(format!("the spectral relation fails: {}", failed.join(", "))))
}

/// The first eigenfunctions: name and points of each.
pub(super) fn curves(spectrum: &Spectrum<'_>, count: usize) -> Vec<(String, Vec<(f64, f64)>)> {
    let count = count.min(spectrum.index.len());
    let [left, right] = spectrum.extent();
    let mut curves: Vec<(String, Vec<(f64, f64)>)> =
        (0..count).map(|n| (format!("n = {n}"), Vec::new())).collect();
    for i in 0..=PLOT_INTERVALS {
        // Dense at the ends, where eigenfunctions may bend most.
        let angle = std::f64::consts::PI * f64::from(i) / f64::from(PLOT_INTERVALS);
        let share = (0.5 * angle).sin().powi(2);
        let x = if i == PLOT_INTERVALS { right } else { left + share * (right - left) };
        for (curve, value) in curves.iter_mut().zip(spectrum.eigenfunctions(x, count)) {
            curve.1.push((x, value));
        }
    }
    curves
}

fn plot(spectrum: &Spectrum<'_>) -> CurvesPlot {
    let curves = curves(spectrum, DRAWN).into_iter();
    let curves = curves.map(|(name, points)| Curve { name, points }).collect();
    CurvesPlot {
        title: format!("Eigenfunctions of K = {}", spectrum.formula),
        notes: vec![spectrum.kernel.title()],
        panels: vec![CurvePanel { heading: String::new(), curves }],
        scaling: CurveScaling::Normalised,
        arrangement: Arrangement::Stacked,
        horizontal_label: "x".to_owned(),
        vertical_label: "φₙ / max |φₙ|".to_owned(),
    }
}
