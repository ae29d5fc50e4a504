use proptest::prelude::*;

use super::*;

fn value(text: &str) -> f64 {
    parse(text).unwrap_or_else(|error| panic!("{text}: {error}")).value
}

fn message(text: &str) -> String {
    parse(text).expect_err(text).to_string()
}

fn relative_error(got: f64, exact: f64) -> f64 {
    ((got - exact) / exact).abs()
}

/// NIST SP 811 (2008), appendix B.8: exact factors, and rounded ones to the digits printed there.
#[test]
fn factors_agree_with_nist() {
    let exact = [
        ("1 in", 0.0254, Dimension::LENGTH),
        ("1 ft", 0.3048, Dimension::LENGTH),
        ("1 yd", 0.9144, Dimension::LENGTH),
        ("1 mil", 2.54e-5, Dimension::LENGTH),
        ("1 thou", 2.54e-5, Dimension::LENGTH),
        ("1 uin", 2.54e-8, Dimension::LENGTH),
        ("1 lbf", 4.4482216152605, Dimension::FORCE),
        ("1 kip", 4448.2216152605, Dimension::FORCE),
        ("1 ozf", 4.4482216152605 / 16.0, Dimension::FORCE),
        ("1 kgf", 9.80665, Dimension::FORCE),
        ("1 dyn", 1e-5, Dimension::FORCE),
        ("1 psi", 6894.757293168361, Dimension::PRESSURE),
        ("1 ksi", 6894757.293168361, Dimension::PRESSURE),
        ("1 Msi", 6894757293.168361, Dimension::PRESSURE),
        ("1 psf", 47.88025898033584, Dimension::PRESSURE),
        ("1 bar", 1e5, Dimension::PRESSURE),
        ("1 atm", 101325.0, Dimension::PRESSURE),
        ("1 t", 1000.0, Dimension::MASS),
        ("1 lbf/in", 175.1268352464764, Dimension::FORCE_PER_LENGTH),
        ("1 deg", 0.017453292519943295, Dimension::NONE),
        ("1°", 0.017453292519943295, Dimension::NONE),
    ];
    for (text, factor, dimension) in exact {
        let quantity = parse(text).unwrap();
        assert!(relative_error(quantity.value, factor) < 3e-16, "{text}: {}", quantity.value);
        assert_eq!(quantity.dimension, dimension, "{text}");
    }
    let printed = [("1 ft lbf", 1.355818), ("1 kip/in^2", 6.894757e6), ("1 kgf/cm^2", 9.80665e4)];
    for (text, factor) in printed {
        assert!(relative_error(value(text), factor) < 5e-7, "{text}");
    }
}

#[test]
fn decimal_units_are_exact() {
    let cases = [
        ("0.1 mm", 1e-4),
        ("0.3 µm", 3e-7),
        ("0.3 μm", 3e-7),
        ("0.3um", 3e-7),
        ("200GPa", 2e11),
        ("200 N/mm^2", 2e8),
        ("200 N/mm²", 2e8),
        ("200 N/mm**2", 2e8),
        ("200 N mm^-2", 2e8),
        ("200 N·mm⁻²", 2e8),
        ("1 µm/MPa", 1e-12),
        ("3 m/Pa", 3.0),
        ("4 1/m", 4.0),
        ("4/mm", 4000.0),
        ("4 /mm", 4000.0),
        ("4*mm", 0.004),
        ("7 N mm/mm", 7.0),
        ("7 (N mm)/mm", 7.0),
        ("6 J/m/m", 6.0),
        ("6 J/(m m)", 6.0),
        ("6 kJ/m^2", 6000.0),
        ("1e-13 m/Pa", 1e-13),
        ("1E5Pa", 1e5),
        ("+.5 mm", 5e-4),
        ("5. mm", 5e-3),
        ("-5 mm", -5e-3),
        ("−5 mm", -5e-3),
        ("  5\tmm  ", 5e-3),
        ("1.5 mrad", 1.5e-3),
        ("10 urad", 1e-5),
        ("1e310 nm", 1e301),
        ("3 hPa", 300.0),
        ("2 g m/s^2", 0.002),
        ("12", 12.0),
        ("0 GPa", 0.0),
        ("0e999999999999999999999", 0.0),
    ];
    for (text, expected) in cases {
        assert_eq!(value(text), expected, "{text}");
    }
    assert_eq!(parse("1 kg m/s^2").unwrap().dimension, parse("1 N").unwrap().dimension);
    assert_eq!(parse("1 J").unwrap().dimension, parse("1 N m").unwrap().dimension);
}

#[test]
fn dimensions_follow_the_units() {
    let cases = [
        ("1 m/Pa", Dimension::COMPLIANCE),
        ("1 MPa/µm", Dimension::SUBGRADE_MODULUS),
        ("1 MN/m", Dimension::FORCE_PER_LENGTH),
        ("1 N m/m", Dimension::MOMENT_PER_LENGTH),
        ("1 1/m", Dimension::CURVATURE),
        ("1 mm mm", Dimension::AREA),
        ("1 mm/m", Dimension::NONE),
        ("1", Dimension::NONE),
    ];
    for (text, dimension) in cases {
        assert_eq!(parse(text).unwrap().dimension, dimension, "{text}");
    }
}

#[test]
fn bare_numbers_are_si_of_any_dimension() {
    let bare = parse("5").unwrap();
    assert!(!bare.unit_written());
    assert_eq!(bare.of(Dimension::PRESSURE, "5"), Ok(5.0));
    let angle = parse("5 rad").unwrap();
    assert!(angle.unit_written());
    let error = angle.of(Dimension::LENGTH, "5 rad").unwrap_err();
    assert_eq!(
        error.to_string(),
        "is a length (like \"5 mm\"), got rad, a plain number or an angle"
    );
    assert_eq!(error.span(), 2..5);
}

#[test]
fn wrong_dimensions_are_named() {
    let wrong = |text: &str| {
        parse(text).unwrap().expect(Dimension::LENGTH, "half_width", text).unwrap_err().to_string()
    };
    assert_eq!(wrong("5 Pa"), "half_width is a length (like \"5 mm\"), got Pa, a pressure");
    assert_eq!(wrong("5 mm mm"), "half_width is a length (like \"5 mm\"), got mm mm, an area");
    assert_eq!(
        wrong("5 N s"),
        "half_width is a length (like \"5 mm\"), got N s, a quantity in kg m s^-1"
    );
}

#[test]
fn units_that_are_meant_are_proposed() {
    let cases = [
        ("5 mpa", "has the unknown unit mpa, did you mean MPa?"),
        ("5 gpa", "has the unknown unit gpa, did you mean GPa?"),
        ("5 MM", "has the unknown unit MM, did you mean mm?"),
        ("5 Psi", "has the unknown unit Psi, did you mean psi?"),
        ("5 Nm", "has the unknown unit Nm, did you mean N m?"),
        ("5 kNmm", "has the unknown unit kNmm, did you mean kN mm?"),
        ("5 inches", "has the unknown unit inches, did you mean in?"),
        ("5 microns", "has the unknown unit microns, did you mean µm?"),
        ("5 lbs", "has the unknown unit lbs, did you mean lbf?"),
        ("5 furlong", "has the unknown unit furlong"),
        ("5 kin", "has the unknown unit kin, did you mean kip?"),
    ];
    for (text, expected) in cases {
        assert_eq!(message(text), expected);
    }
    assert!(parse("5 furlong").unwrap_err().help().unwrap().contains("psi"));
}

#[test]
fn faults_are_named_in_their_place() {
    use QuantityErrorKind as Kind;
    let unit_missing = |sign: &str| Kind::UnitMissing(sign.to_owned());
    let number_form = |written: &str, instead: &str| Kind::NumberForm {
        written: written.to_owned(),
        instead: instead.to_owned(),
    };
    let cases = [
        ("", Kind::Empty, 0..0),
        ("  ", Kind::Empty, 0..2),
        ("GPa", Kind::NoNumber, 0..3),
        ("-", Kind::NoNumber, 0..1),
        (".", Kind::NoNumber, 0..1),
        ("é5", Kind::NoNumber, 0..3),
        ("nan m", Kind::NotFinite("nan".to_owned()), 0..3),
        ("-inf Pa", Kind::NotFinite("-inf".to_owned()), 0..4),
        ("Infinity", Kind::NotFinite("Infinity".to_owned()), 0..8),
        ("1e400 Pa", Kind::TooLarge, 0..8),
        ("1e308 GPa", Kind::TooLarge, 0..9),
        ("1e-400 Pa", Kind::TooSmall, 0..9),
        ("1e-320 pm", Kind::TooSmall, 0..9),
        ("1e99999999999999999999", Kind::TooLarge, 0..22),
        ("1,5 mm", number_form("1,5", "1.5"), 0..3),
        ("800.000,5 N", number_form("800.000,5", "800000.5"), 0..9),
        ("1,500.25 N", number_form("1,500.25", "1500.25"), 0..8),
        ("1,500 mm", number_form("1,500", "1500 or 1.500"), 0..5),
        ("1_000 m", number_form("1_000", "1000"), 0..5),
        ("1 000 m", number_form("1 000", "1000"), 0..5),
        ("10^6 Pa", number_form("10^6", "powers of ten as in 1e6"), 0..4),
        ("1.2.3 m", Kind::NumberInUnit(".3".to_owned()), 3..5),
        ("5 3 m", Kind::NumberInUnit("3".to_owned()), 2..3),
        ("5 m 3", Kind::NumberInUnit("3".to_owned()), 4..5),
        ("5 m/2", Kind::NumberInUnit("2".to_owned()), 4..5),
        ("5 mm2", Kind::BareDigit { unit: "mm".to_owned(), digits: "2".to_owned() }, 2..5),
        ("5 m%", Kind::UnknownCharacter('%'), 3..4),
        ("5 m/", unit_missing("/"), 4..4),
        ("5 m//s", unit_missing("/"), 4..4),
        ("5 m * / s", unit_missing("*"), 6..6),
        ("5 ()", unit_missing("("), 2..4),
        ("5 (m", Kind::Parenthesis, 2..3),
        ("5 (", Kind::Parenthesis, 2..3),
        ("5 m)", Kind::Parenthesis, 3..4),
        ("5 )", Kind::Parenthesis, 2..3),
        ("5 m^", Kind::Power, 3..4),
        ("5 m^0.5", Kind::Power, 3..7),
        ("5 m^10", Kind::Power, 3..6),
        ("5 ^2", Kind::Power, 2..3),
        ("5 m⁻", Kind::Power, 3..6),
    ];
    for (text, kind, span) in cases {
        let error = parse(text).expect_err(text);
        assert_eq!(error.kind(), &kind, "{text}");
        assert_eq!(error.span(), span, "{text}");
    }
}

#[test]
fn products_behind_quotients_are_not_guessed() {
    let error = parse("5 N/mm mm").unwrap_err();
    assert_eq!(
        error.to_string(),
        "has the unit N/mm mm, which can be read in two ways: write N/(mm mm) or N/mm*mm"
    );
    assert_eq!(value("5 N/(mm mm)"), 5e6);
    assert_eq!(value("5 N/mm*mm"), 5.0);
    assert_eq!(value("5 N/mm/mm"), 5e6);
}

#[test]
fn hostile_texts_give_errors() {
    assert_eq!(parse(&"9".repeat(257)).unwrap_err().kind(), &QuantityErrorKind::TooLong(257));
    assert!(parse(&format!("1 {}m{}", "(".repeat(126), ")".repeat(126))).is_ok());
    assert!(parse(&format!("1 {}", "(".repeat(254))).is_err());
    let tower = format!("1 {}m{}", "(".repeat(30), ")^9".repeat(30));
    assert_eq!(parse(&tower).unwrap_err().kind(), &QuantityErrorKind::PowerOverflow);
    let angles = format!("1 {}deg{}", "(".repeat(30), ")^9".repeat(30));
    assert!(parse(&angles).is_err());
    let ratios = format!("1 {}bar/Pa{}", "(".repeat(30), ")^9".repeat(30));
    assert!(parse(&ratios).is_err());
    assert_eq!(value(&format!("{}e-200 m", "1".repeat(201))), 1.1111111111111112);
}

#[test]
fn engineering_notation_reads_as_people_write() {
    let length = |value| engineering(value, Dimension::LENGTH);
    assert_eq!(length(3.1234e-6), "3.1234 µm");
    assert_eq!(length(0.0), "0 m");
    assert_eq!(length(-0.0), "0 m");
    assert_eq!(length(-2.5e-3), "-2.5 mm");
    assert_eq!(length(999.9999999), "1 km");
    assert_eq!(length(999.999), "999.999 m");
    assert_eq!(length(1e-15), "1e-15 m");
    assert_eq!(length(1.5e15), "1.5e15 m");
    assert_eq!(length(9.99e14), "999 Tm");
    assert_eq!(length(f64::NAN), "not a number");
    assert_eq!(length(f64::INFINITY), "infinite");
    assert_eq!(length(f64::NEG_INFINITY), "minus infinite");
    assert_eq!(engineering(1.2e8, Dimension::PRESSURE), "120 MPa");
    assert_eq!(engineering(8e5, Dimension::FORCE_PER_LENGTH), "800 kN/m");
    assert_eq!(engineering(1.5e3, Dimension::MOMENT_PER_LENGTH), "1.5 kN m/m");
    assert_eq!(engineering(1e12, Dimension::SUBGRADE_MODULUS), "1 TPa/m");
    assert_eq!(engineering(1.2e-13, Dimension::COMPLIANCE), "0.12 µm/MPa");
    assert_eq!(engineering(1.2e-3, DisplayUnit::angle()), "1.2 mrad");
    assert_eq!(engineering(0.25, Dimension::NONE), "0.25");
    assert_eq!(engineering(1.25e7, Dimension::NONE), "1.25e7");
    assert_eq!(engineering(1.25e-5, Dimension::NONE), "1.25e-5");
    assert_eq!(engineering(123_456_789.0, Dimension::PRESSURE), "123.457 MPa");
    assert_eq!(engineering_with_digits(123_456_789.0, Dimension::PRESSURE, 1), "100 MPa");
    assert_eq!(engineering_with_digits(123_456_789.0, Dimension::PRESSURE, 0), "100 MPa");
}

#[test]
fn axes_share_one_prefix() {
    let axis = |value, unit: DisplayUnit| {
        let AxisUnit { factor, label } = axis_unit(value, unit);
        (factor, label)
    };
    assert_eq!(axis(2e8, Dimension::PRESSURE.into()), (1e-6, "MPa".to_owned()));
    assert_eq!(axis(-0.02, Dimension::LENGTH.into()), (1e3, "mm".to_owned()));
    assert_eq!(axis(3e-4, DisplayUnit::angle()), (1e6, "µrad".to_owned()));
    assert_eq!(axis(3e-13, Dimension::COMPLIANCE.into()), (1e12, "µm/MPa".to_owned()));
    assert_eq!(axis(7.0, Dimension::NONE.into()), (1.0, String::new()));
    assert_eq!(axis(0.0, Dimension::LENGTH.into()), (1.0, "m".to_owned()));
    assert_eq!(axis(f64::NAN, Dimension::LENGTH.into()), (1.0, "m".to_owned()));
    assert_eq!(axis(1e-300, Dimension::LENGTH.into()), (1e12, "pm".to_owned()));
    assert_eq!(axis(1e300, Dimension::LENGTH.into()), (1e-12, "Tm".to_owned()));
}

const SHOWN: [Dimension; 9] = [
    Dimension::NONE,
    Dimension::LENGTH,
    Dimension::AREA,
    Dimension::CURVATURE,
    Dimension::PRESSURE,
    Dimension::COMPLIANCE,
    Dimension::SUBGRADE_MODULUS,
    Dimension::FORCE_PER_LENGTH,
    Dimension::MOMENT_PER_LENGTH,
];

proptest! {
    #[test]
    fn arbitrary_texts_never_panic(text in ".{0,80}") {
        check_spans(&text);
    }

    #[test]
    fn texts_of_the_grammar_never_panic(
        text in "[-+−0-9.eE,_ ]{0,6}[mPaNkMGinpsrdgµ°²⁻^*/·() 0-9é-]{0,20}"
    ) {
        check_spans(&text);
    }

    #[test]
    fn formatted_values_parse_back_to_the_bit(
        bits in any::<u64>(),
        dimension in prop::sample::select(SHOWN.to_vec()),
    ) {
        let value = f64::from_bits(bits);
        prop_assume!(value.is_finite());
        let text = engineering_with_digits(value, dimension, 17);
        let back = parse(&text).unwrap().of(dimension, &text).unwrap();
        prop_assert_eq!(back, value, "{}", text);
    }

    #[test]
    fn usual_values_survive_six_digits(
        mantissa in 1.0f64..1000.0,
        exponent in -14i32..16,
        dimension in prop::sample::select(SHOWN.to_vec()),
    ) {
        let value = mantissa * 10f64.powi(exponent);
        let text = engineering(value, dimension);
        let back = parse(&text).unwrap().of(dimension, &text).unwrap();
        prop_assert!(relative_error(back, value) <= 5.1e-6, "{} {}", text, value);
        prop_assert!(text.len() < 24, "{}", text);
    }

    #[test]
    fn products_of_units_multiply(
        left in prop::sample::select(vec!["mm", "ksi", "lbf", "kg", "deg", "s"]),
        right in prop::sample::select(vec!["µm", "GPa", "kip", "g", "mrad", "in"]),
        power in -3i8..=3,
    ) {
        let product = parse(&format!("2 {left}^{power} {right}")).unwrap();
        let [a, b] = [left, right].map(|unit| parse(&format!("1 {unit}")).unwrap());
        let expected = 2.0 * a.value.powi(i32::from(power)) * b.value;
        prop_assert!(relative_error(product.value, expected) < 1e-14);
        let dimension = a.dimension.checked_pow(power).unwrap().checked_mul(b.dimension);
        prop_assert_eq!(Some(product.dimension), dimension);
    }
}

/// Whatever the text, spans lie in it on character boundaries, and values are finite.
fn check_spans(text: &str) {
    match parse(text) {
        Ok(quantity) => {
            assert!(quantity.value.is_finite(), "{text}");
            assert!(quantity.unit_span().is_none_or(|span| text.get(span).is_some()), "{text}");
        }
        Err(error) => {
            assert!(text.get(error.span()).is_some(), "{text:?} {:?}", error.span());
            assert!(!error.to_string().is_empty());
        }
    }
}
