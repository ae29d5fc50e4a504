//! `shtaerman roughness`.

mod doubts;
mod findings;
mod read;

use shtaerman::asperities::{
    BearingCurve, GreenwoodWilliamson, Table, TableOrder, open_trace, read_table,
};
use shtaerman::document::{FileError, load_bytes};
use shtaerman::finite_elements::{is_input_file, read_input_file};
use shtaerman::quantity::Dimension;
use shtaerman::{Error, Roughness};

use crate::Failure;
use crate::arguments::{
    BearingArguments, ColumnOrder, GreenwoodWilliamsonArguments, Law, ReportFormat,
    RoughnessArguments, RoughnessSource, TableArguments,
};
use crate::failure;
use crate::output::{Content, Input, Outputs, check_writable};
use findings::{Curve, Findings, LawReport, State};
use read::{number, optional_quantity, optional_unit, pair, quantity, unit, usage};

/// `1/m^2`.
const DENSITY: Dimension = Dimension::new(-2, 0, 0);
/// Shares between which a bearing curve is fitted.
const SHARES: [f64; 2] = [0.01, 0.5];
/// Share of real contact above which neighbours feel each other.
const CROWDED: f64 = 0.1;
/// Plasticity index above which asperities yield at ordinary pressures.
const PLASTIC: f64 = 0.6;

pub(super) fn run(arguments: &RoughnessArguments) -> Result<(), Failure> {
    let (output, input) = match &arguments.source {
        RoughnessSource::GreenwoodWilliamson(source) => (&source.output, None),
        RoughnessSource::Bearing(source) => {
            let trace = source.trace.as_deref().map(|path| Input { what: "the trace", path });
            (&source.output, trace)
        }
        RoughnessSource::Table(source) => {
            (&source.output, Some(Input { what: "the table", path: &source.file }))
        }
    };
    check_writable(&[output.output.as_deref()], input.as_slice())?;
    // Where there is no law, the slip that is likely stands beside the error.
    let slips = doubts::of(&arguments.source);
    let is_strict = doubts::sense(&arguments.source).strict;
    failure::hold(slips.iter().filter(|_| !is_strict).cloned());
    let findings = findings(&arguments.source, slips)?;
    if !output.is_table() {
        findings.warnings.iter().for_each(|warning| failure::warn(warning));
    }
    let text = match output.format {
        ReportFormat::Table => Content::page(&findings.table()),
        ReportFormat::Json => Content::json(&findings),
        ReportFormat::Csv => findings.csv(),
    };
    let mut outputs = Outputs::default();
    outputs.result(output.output.as_deref(), text);
    outputs.write()
}

/// What is found as JSON, whatever the format asked for.
pub(super) fn json(arguments: &RoughnessArguments) -> Result<String, Failure> {
    let slips = doubts::of(&arguments.source);
    Content::json(&findings(&arguments.source, slips)?).text()
}

/// What is found, with the slips that are likely, which `--strict` refuses.
fn findings(source: &RoughnessSource, slips: Vec<String>) -> Result<Findings, Failure> {
    let sense = doubts::sense(source);
    doubts::refuse(&sense, &slips)?;
    let mut found = match source {
        RoughnessSource::GreenwoodWilliamson(source) => greenwood_williamson(source)?,
        RoughnessSource::Bearing(source) => bearing(source)?,
        RoughnessSource::Table(source) => table(source)?,
    };
    doubts::refuse(&sense, &found.warnings)?;
    found.warnings.splice(..0, slips);
    Ok(found)
}

fn greenwood_williamson(source: &GreenwoodWilliamsonArguments) -> Result<Findings, Failure> {
    let model = GreenwoodWilliamson::new(
        quantity("deviation", &source.deviation, Dimension::LENGTH)?,
        quantity("density", &source.density, DENSITY)?,
        quantity("radius", &source.radius, Dimension::LENGTH)?,
        quantity("modulus", &source.modulus, Dimension::PRESSURE)?,
    )
    .map_err(usage)?;
    let mut findings = Findings::new("greenwood-williamson");
    let hardness = optional_quantity("hardness", source.hardness.as_ref(), Dimension::PRESSURE)?;
    let pressure = optional_quantity("pressure", source.pressure.as_ref(), Dimension::PRESSURE)?;
    let range =
        (source.range.as_ref()).map(|text| pair("range", text, Dimension::PRESSURE)).transpose()?;
    if let Some(pressure) = pressure {
        let compliance = model.compliance(pressure).map_err(usage)?;
        findings.state = Some(State {
            separation: Some(model.separation(pressure).map_err(usage)?),
            contact_share: Some(model.contact_share(pressure).map_err(usage)?),
            contacts: Some(model.contacts(pressure).map_err(usage)?),
            ..State::new(pressure, compliance)
        });
        findings.linear = Some(LawReport::exact(Roughness::Linear { compliance }));
    }
    if let Some(range) = range {
        let named = |error| in_range(error);
        findings.power = Some(LawReport::fitted(&model.fit_power(range).map_err(named)?));
        if findings.linear.is_none() {
            findings.linear = Some(LawReport::fitted(&model.fit_linear(range).map_err(named)?));
        }
    }
    if let Some(hardness) = hardness {
        let index = model.plasticity_index(hardness).map_err(usage)?;
        findings.plasticity_index = Some(index);
        if index > PLASTIC {
            findings.note(format!(
                "the plasticity index {index:.3} is above {PLASTIC}: asperities yield, and the layer is stiffer on unloading than on first loading"
            ));
        }
    }
    let highest = range.map_or(pressure, |range| Some(range[1])).unwrap_or(f64::NAN);
    let share = model.contact_share(highest).map_err(usage)?;
    if share > 1.0 {
        findings.warnings.push(format!(
            "the model has {share:.2} times the surface in contact at the highest pressure, which is more than there is: are the density in 1/m^2 and the pressure in Pa?"
        ));
    } else if share > CROWDED {
        findings.note(format!(
            "{:.0} % of the surface are in contact at the highest pressure: asperities feel their neighbours, which the model leaves out",
            100.0 * share
        ));
    }
    findings.choose(source.law.unwrap_or(if range.is_some() {
        Law::Power
    } else {
        Law::Linear
    }))?;
    Ok(findings)
}

/// A fault of a fit over `--range`.
fn in_range(error: Error) -> Failure {
    match error {
        Error::InvalidValue { field: "pressure", value, requirement } => {
            Failure::Usage(format!("--range: the pressure {value} Pa must be {requirement}"))
        }
        Error::InvalidValue { field: "exponent", value, requirement } => Failure::Usage(format!(
            "--range: the exponent comes out as {value}, must be {requirement}"
        )),
        other => usage(other),
    }
}

fn bearing(source: &BearingArguments) -> Result<Findings, Failure> {
    let mut findings = Findings::new("bearing");
    let curve = match (&source.trace, &source.b, &source.nu, &source.height) {
        (Some(path), ..) => {
            let units = [
                unit("position-unit", &source.position_unit, Dimension::LENGTH)?,
                unit("height-unit", &source.height_unit, Dimension::LENGTH)?,
            ];
            let shares = (source.shares.as_ref())
                .map_or(Ok(SHARES), |text| pair("shares", text, Dimension::NONE))?;
            let trace = open_trace(path, units)?;
            let fit = BearingCurve::of_trace(&trace, shares).map_err(|error| match error {
                Error::InvalidValue { field: "share", value, requirement } => {
                    Failure::Usage(format!("--shares {value}: must be {requirement}"))
                }
                other => Failure::Usage(format!("{}: {other}", path.display())),
            })?;
            findings.curve = Some(Curve::fitted(&fit));
            fit.curve
        }
        (None, Some(b), Some(nu), Some(height)) => {
            let height = quantity("height", height, Dimension::LENGTH)?;
            let curve = BearingCurve::new(number("b", b)?, number("nu", nu)?, height);
            let curve = curve.map_err(usage)?;
            findings.curve = Some(Curve::given(&curve));
            curve
        }
        _ => {
            return Err(Failure::Usage(
                "--b, --nu and --height, or --trace, are needed".to_owned(),
            ));
        }
    };
    let law = match (&source.hardness, &source.modulus, &source.radius) {
        (Some(hardness), ..) => curve.plastic(quantity("hardness", hardness, Dimension::PRESSURE)?),
        (None, Some(modulus), Some(radius)) => curve.elastic(
            quantity("modulus", modulus, Dimension::PRESSURE)?,
            quantity("radius", radius, Dimension::LENGTH)?,
        ),
        _ => {
            return Err(Failure::Usage(
                "--hardness, or --modulus and --radius, are needed".to_owned(),
            ));
        }
    };
    let law = law.map_err(usage)?;
    findings.power = Some(LawReport::exact(law));
    if let Some(pressure) =
        optional_quantity("pressure", source.pressure.as_ref(), Dimension::PRESSURE)?
    {
        if pressure.is_nan() || pressure <= 0.0 {
            return Err(Failure::Usage(format!(
                "--pressure {pressure}: must be greater than zero"
            )));
        }
        let approach = law.displacement(pressure);
        let exponent = match law {
            Roughness::Power { exponent, .. } => exponent,
            _ => 1.0,
        };
        let compliance = exponent * approach / pressure;
        let share = curve.share(approach);
        findings.state = Some(State {
            approach: Some(approach),
            bearing_share: Some(share),
            ..State::new(pressure, compliance)
        });
        findings.linear = Some(LawReport::exact(Roughness::Linear { compliance }));
        if share > 1.0 {
            findings.warnings.push(format!(
                "the approach reaches {share:.2} times the bearing curve, which is more than the whole surface: are the pressure and the hardness in Pa, and the height in m?"
            ));
        } else if share > SHARES[1] {
            findings.note(format!(
                "the approach reaches the share {share:.2} of the bearing curve: beyond about one half a power does not describe it"
            ));
        }
    }
    findings.choose(source.law.unwrap_or(Law::Power))?;
    Ok(findings)
}

fn table(source: &TableArguments) -> Result<Findings, Failure> {
    let table = open(source)?;
    let mut findings = Findings::new("table");
    let in_file = |error: Error| Failure::Usage(format!("{}: {error}", source.file.display()));
    let linear = table.fit_linear().map_err(in_file)?;
    findings.linear = Some(LawReport::fitted(&linear));
    let mut better = Law::Linear;
    match table.fit_power() {
        Ok(power) => {
            findings.power = Some(LawReport::fitted(&power));
            if power.largest_deviation < linear.largest_deviation {
                better = Law::Power;
            }
        }
        Err(error) if source.law == Some(Law::Power) => return Err(in_file(error)),
        Err(error) => findings.note(format!("no power law: {error}")),
    }
    findings.choose(source.law.unwrap_or(better))?;
    Ok(findings)
}

/// The table of a file of columns or of an input file.
fn open(source: &TableArguments) -> Result<Table, Failure> {
    let bytes = load_bytes(&source.file).map_err(|message| {
        FileError::new(message).in_file(Some(&source.file.display().to_string()))
    })?;
    let name = source.file.display().to_string();
    let approach =
        optional_unit("approach-unit", source.approach_unit.as_ref(), Dimension::LENGTH)?;
    let pressure =
        optional_unit("pressure-unit", source.pressure_unit.as_ref(), Dimension::PRESSURE)?;
    if is_input_file(&bytes) {
        let units = match (approach, pressure) {
            (Some(approach), Some(pressure)) => Some([approach, pressure]),
            (None, None) => None,
            _ => {
                return Err(Failure::Usage(
                    "--approach-unit and --pressure-unit: of an input file both are needed, or none where it tells its units".to_owned(),
                ));
            }
        };
        return Ok(read_input_file(&bytes, &name, units)?);
    }
    let order = source.columns.map(|order| match order {
        ColumnOrder::ApproachPressure => TableOrder::ApproachPressure,
        ColumnOrder::PressureApproach => TableOrder::PressureApproach,
    });
    Ok(read_table(&bytes, &name, [approach, pressure], order)?)
}
