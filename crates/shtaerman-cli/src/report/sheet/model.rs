//! The model that was solved, with its formula.

use std::fmt::Write;

use shtaerman::equation::{Equation, Kind};
use shtaerman::quantity::{Dimension, engineering};
use shtaerman::{ContactKind, Geometry, Law, LayerBase, Layering, Problem, Rotational, Vertical};

use super::math::{
    SPACE, THIN, display, escaped, inline, integral, magnitude, name, number, of, over, plain,
    power, row, sign, sub, upright,
};
use crate::report::significant;

const DIGITS: usize = 6;

/// The model of a problem, as HTML.
pub(super) fn of_problem(problem: &Problem) -> String {
    let mut text = display(&equation(problem));
    text.push_str(&display(&carried(problem)));
    text.push_str(&display(&conditions(problem)));
    let _ = write!(text, "<p>{}</p>", where_(problem));
    text.push_str("<p>Small slopes, linear elasticity, no friction, adhesion or plasticity. Compression is positive; a positive moment gives a negative tilt.");
    let _ = write!(text, " The settlement is in the gauge {}.</p>", escaped(problem.gauge()));
    text
}

/// What gives locally, what gives as a whole, and what presses it.
fn equation(problem: &Problem) -> String {
    let p = name("p");
    let local = match problem.foundation().law() {
        Law::Smooth => String::new(),
        Law::Linear => row(&[&name("χ"), &p, &of(&name("x")), &sign("+")]),
        Law::Power(_) => row(&[&name("B"), &power(&p, &name("κ")), &of(&name("x")), &sign("+")]),
    };
    let right = row(&[
        &name("δ"),
        &sign("−"),
        &name("α"),
        &name("x"),
        &sign("−"),
        &name("f"),
        &of(&name("x")),
    ]);
    row(&[&local, &elastic(problem), &sign("="), &right])
}

/// The displacement of the elastic body.
fn elastic(problem: &Problem) -> String {
    let distance = magnitude(&row(&[&name("x"), &sign("−"), &name("s")]));
    let pressure = row(&[&name("p"), &of(&name("s")), THIN, &upright("d"), &name("s")]);
    let zone = integral(&name("C"));
    let foundation = problem.foundation();
    if problem.is_circular() {
        let factor = over(&number("1"), &row(&[&name("π"), &power(&name("E"), &sign("*"))]));
        let pressure = row(&[&name("p"), &of(&name("s")), THIN, &upright("d"), &name("A")]);
        if let Some(grading) = foundation.grading().filter(|grading| !grading.is_homogeneous()) {
            let exponent =
                row(&[&number("1"), &sign("+"), &number(&significant(grading.exponent(), DIGITS))]);
            return row(&[&name("θ"), &zone, &over(&pressure, &power(&distance, &exponent))]);
        }
        if foundation.layering().is_some() {
            return row(&[&factor, &zone, &name("G"), &of(&distance), &pressure]);
        }
        return row(&[&factor, &zone, &over(&pressure, &distance)]);
    }
    if let Some(grading) = foundation.grading().filter(|grading| !grading.is_homogeneous()) {
        let exponent = number(&significant(grading.exponent(), DIGITS));
        return row(&[&name("θ"), &zone, &over(&pressure, &power(&distance, &exponent))]);
    }
    let theta = name("θ");
    if foundation.layering().is_some() {
        return row(&[
            &theta,
            &zone,
            &name("G"),
            &of(&row(&[&name("x"), &sign("−"), &name("s")])),
            THIN,
            &pressure,
        ]);
    }
    if let Geometry::Periodic { .. } = problem.punch().geometry() {
        let angle =
            over(&row(&[&name("π"), &of(&row(&[&name("x"), &sign("−"), &name("s")]))]), &name("L"));
        let sine = row(&[&number("2"), THIN, &magnitude(&row(&[&upright("sin"), &angle]))]);
        return row(&[&theta, &zone, &upright("ln"), &over(&number("1"), &sine), &pressure]);
    }
    row(&[&theta, &zone, &upright("ln"), &over(&name("a"), &distance), THIN, &pressure])
}

/// What the load says.
fn carried(problem: &Problem) -> String {
    let element = if problem.is_circular() { "A" } else { "s" };
    let pressure = row(&[&name("p"), THIN, &upright("d"), &name(element)]);
    let zone = integral(&name("C"));
    let force = row(&[&zone, &pressure, &sign("="), &name("P")]);
    let moment = row(&[&zone, &name("s"), &pressure, &sign("="), &name("M")]);
    let mut parts = vec![force, SPACE.to_owned(), moment];
    let given = |symbol: &str| row(&[SPACE, &name(symbol), &upright("\u{a0}given")]);
    if let Vertical::Settlement(_) = problem.load().vertical() {
        parts.push(given("δ"));
    }
    match problem.load().rotational() {
        Rotational::Tilt(_) => parts.push(given("α")),
        Rotational::Eccentricity(_) => {
            parts.push(row(&[SPACE, &name("M"), &sign("="), &name("P"), THIN, &name("e")]));
        }
        Rotational::Moment(_) => {}
    }
    parts.concat()
}

/// Where it touches.
fn conditions(problem: &Problem) -> String {
    match problem.solver().contact() {
        ContactKind::Bilateral => row(&[
            &name("C"),
            &sign("="),
            &upright("the\u{a0}whole\u{a0}base"),
            &sign(","),
            &upright("\u{a0}held\u{a0}together"),
        ]),
        ContactKind::Unilateral => row(&[
            &name("p"),
            &sign("≥"),
            &number("0"),
            &sign(","),
            SPACE,
            &name("g"),
            &sign("≥"),
            &number("0"),
            &sign(","),
            SPACE,
            &name("p"),
            &sign("⋅"),
            &name("g"),
            &sign("="),
            &number("0"),
        ]),
    }
}

/// What the symbols are.
fn where_(problem: &Problem) -> String {
    let mut parts = vec![match problem.solver().contact() {
        ContactKind::Unilateral => {
            "<i>C</i> is where it touches, found with the answer, <i>g</i> the gap".to_owned()
        }
        ContactKind::Bilateral => "<i>C</i> is the whole base".to_owned(),
    }];
    let stiff = row(&[&power(&name("E"), &sign("*"))]);
    let theta =
        row(&[&name("θ"), &sign("="), &number("2"), &sign("/"), &of(&row(&[&name("π"), &stiff]))]);
    let foundation = problem.foundation();
    match (problem.scaling(), foundation.grading().filter(|grading| !grading.is_homogeneous())) {
        (_, Some(_)) => parts.push("<i>θ</i> is the response of the graded ground".to_owned()),
        (Some(scaling), None) => {
            let modulus = engineering(scaling.contact_modulus(), Dimension::PRESSURE);
            let how = if problem.punch().body().is_some() { ", of both bodies" } else { "" };
            if problem.is_circular() {
                parts.push(format!("{} = {modulus}{how}", inline(&stiff)));
            } else {
                parts.push(format!("{}, {} = {modulus}{how}", inline(&theta), inline(&stiff)));
            }
        }
        (None, None) => parts.push(
            "lengths are in <i>a</i>, pressures in <i>E</i>, displacements in <i>χE</i>".to_owned(),
        ),
    }
    if foundation.law() != Law::Smooth {
        let zero = inline(&sub(&name("θ"), &number("0")));
        let how = match foundation.law() {
            Law::Power(_) => "the law of the asperities is <i>B p<sup>κ</sup></i>",
            _ => "<i>χ</i> is the compliance of the asperities",
        };
        parts.push(format!("{how}, {zero} = {}", significant(problem.theta0(), 8)));
    } else {
        parts.push("the surface is smooth".to_owned());
    }
    parts.extend(foundation.layering().map(layering));
    parts.extend(geometry(problem));
    parts.join("; ") + "."
}

fn layering(layering: &Layering) -> String {
    match layering {
        Layering::Layer { base: LayerBase::Bonded { .. }, .. } => {
            "<i>G</i> is the response of an elastic layer that sticks to a rigid base".to_owned()
        }
        Layering::Layer { base: LayerBase::Frictionless, .. } => {
            "<i>G</i> is the response of an elastic layer that slides on a rigid base".to_owned()
        }
        Layering::Coating { .. } => "<i>G</i> is the response of the coated half-plane".to_owned(),
        Layering::Own(_) => "<i>G</i> is the response given by the user".to_owned(),
    }
}

fn geometry(problem: &Problem) -> Option<String> {
    Some(match problem.punch().geometry() {
        Geometry::Pair { .. } => "the two bases belong to one body".to_owned(),
        Geometry::Periodic { .. } => "force and moment are those of one period <i>L</i>".to_owned(),
        Geometry::Circular => "the base is round, force and moment those of the whole".to_owned(),
        _ => return None,
    })
}

/// The model of an equation, as HTML.
pub(super) fn of_equation(equation: &Equation) -> String {
    let family = equation.kernel().family();
    let (phi, x, s) = (name("φ"), name("x"), name("s"));
    let measure = row(&[THIN, &plain(family.measure)]);
    let of_both = of(&row(&[&x, &sign(","), &s]));
    let left = row(&["<mo largeop=\"true\">∫</mo>", &name("K"), &of_both, &phi, &of(&s), &measure]);
    let right = row(&[&sign("="), &name("f"), &of(&x)]);
    let whole = match equation.kind() {
        Kind::Second { .. } => row(&[&phi, &of(&x), &sign("+"), &name("λ"), &left, &right]),
        Kind::First => row(&[&left, &right]),
    };
    let kernel = row(&[&name("K"), &of_both, &sign("="), &plain(family.formula)]);
    let mut text = display(&whole) + &display(&kernel);
    let lambda = match equation.kind() {
        Kind::Second { lambda } => {
            format!("; {} = {}", inline(&name("λ")), significant(lambda, 12))
        }
        Kind::First => String::new(),
    };
    let _ = write!(
        text,
        "<p>{} on {}; <i>f</i>(<i>x</i>) = <code>{}</code>{lambda}.</p>",
        escaped(&equation.kernel().title()),
        inline(&plain(family.interval)),
        escaped(&equation.right_hand_side().to_string()),
    );
    text
}
