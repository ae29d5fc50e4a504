//! Pictures of contacts, convergence and curves: what is in them, and that nothing makes them fail.
#![expect(clippy::unwrap_used, reason = "helpers outside of test functions fail by panicking")]

use std::f64::consts::PI;
use std::path::Path;

use shtaerman_cli::plot::{
    Arrangement, Axis, ContactPlot, ConvergencePlot, ConvergenceSeries, Curve, CurvePanel,
    CurveScaling, CurvesPlot, Figure, Format, Layer, LegendPlace, Line, PNG_PIXELS_PER_UNIT, Panel,
    Plot, PlotError, Scale, Size, render,
};

/// A picture with little room.
const SMALL: Size = Size { width: 480, height: 360 };

fn positions(count: usize) -> Vec<f64> {
    (0..count).map(|i| 2.0 * i as f64 / (count - 1) as f64 - 1.0).collect()
}

/// Smooth flat punch of half-width 10 mm pressed by 1 kN/mm, cut short of its infinite corners.
fn flat_punch() -> ContactPlot {
    let xi: Vec<f64> = positions(401).into_iter().map(|xi| 0.998 * xi).collect();
    let pressure = |xi: &f64| 1000.0 / (10.0 * PI * (1.0 - xi * xi).sqrt());
    let outside = |xi: f64| 12.0 - 3.0 * (xi.abs() + (xi * xi - 1.0).max(0.0).sqrt()).ln();
    let surface = |i: i32| {
        let xi = f64::from(i) / 100.0;
        (10.0 * xi, outside(xi.abs().max(1.0)))
    };
    ContactPlot {
        title: "Flat punch on a smooth half-plane".to_owned(),
        notes: vec![
            "a = 10 mm, P = 1 kN/mm; displacement relative to the gauge ln(a/|x − s|)".to_owned(),
        ],
        pressure: xi.iter().map(|xi| (10.0 * xi, pressure(xi))).collect(),
        punch_base: xi.iter().map(|xi| (10.0 * xi, 12.0)).collect(),
        body_surface: (-160..=160).map(surface).collect(),
        edges: vec![-9.98, 9.98],
        position_label: "x [mm]".to_owned(),
        pressure_label: "p [MPa]".to_owned(),
        depth_label: "displacement [µm]".to_owned(),
        ..ContactPlot::default()
    }
}

/// Bilateral parabolic punch: the edges pull.
fn parabola() -> ContactPlot {
    let xi = positions(201);
    let pressure = |xi: &f64| (2.0 * xi, 180.0 - 260.0 * xi * xi);
    let banded = |xi: &f64| {
        let (x, p) = pressure(xi);
        let error = 8.0 + 14.0 * xi * xi;
        (x, p - error, p + error)
    };
    let surface = |i: i32| {
        let x = f64::from(i) / 100.0;
        (2.0 * x, 5.5 - 2.0 * x * x / (1.0 + 0.35 * x * x))
    };
    ContactPlot {
        title: "Parabolic punch on a rough body, bilateral contact".to_owned(),
        notes: vec![
            "the pressure pulls at both edges: use unilateral contact if nothing bonds the bodies"
                .to_owned(),
        ],
        pressure_band: xi.iter().map(banded).collect(),
        band_name: "error (bound)".to_owned(),
        pressure: xi.iter().map(pressure).collect(),
        punch_base: xi.iter().map(|xi| (2.0 * xi, 6.5 - 3.5 * xi * xi)).collect(),
        body_surface: (-150..=150).map(surface).collect(),
        edges: vec![-2.0, 2.0],
        contact_ends: vec![-1.664, 1.664],
        position_label: "x [mm]".to_owned(),
        pressure_label: "p [MPa]".to_owned(),
        depth_label: "displacement [µm]".to_owned(),
        ..ContactPlot::default()
    }
}

fn convergence() -> ConvergencePlot {
    let counts: Vec<f64> = (2..11).map(|k| f64::from(1 << k)).collect();
    let series = |name: &str, size: f64, order: i32| ConvergenceSeries {
        name: name.to_owned(),
        n: counts.clone(),
        difference: counts.iter().map(|n| size * n.powi(-order) * (1.0 + 0.3 * n.sin())).collect(),
    };
    ConvergencePlot {
        title: "Convergence of the degenerate kernel".to_owned(),
        notes: Vec::new(),
        series: vec![
            series("settlement", 0.4, 4),
            series("pressure at the centre", 2.0, 3),
            series("pressure at the edges", 3.0, 2),
        ],
        count_label: "highest degree n".to_owned(),
        difference_label: "difference from collocation".to_owned(),
    }
}

/// Curves of the sizes of a parabolic base from very rough to nearly smooth.
fn families() -> CurvesPlot {
    const LAMBDAS: [f64; 12] =
        [0.001, 0.005, 0.1, 0.3, 0.5, 0.8, 1.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    let family = |sign: f64| {
        let curve = |lambda: &f64| {
            let bend = sign * 0.9 * lambda / (1.0 + 0.05 * (1.0 - sign) * lambda);
            let value = |xi: f64| 0.0005 + bend * (xi * xi - 1.0 / 3.0);
            let points = positions(101).into_iter().map(|xi| (xi, value(xi))).collect();
            Curve { name: format!("λ₀ = {lambda}"), points }
        };
        LAMBDAS.iter().map(curve).collect()
    };
    CurvesPlot {
        title: "Pressure for a parabolic base, P₀ = 0.001, M₀ = 0.0001".to_owned(),
        notes: Vec::new(),
        panels: vec![
            CurvePanel { heading: "as the paper computed it".to_owned(), curves: family(1.0) },
            CurvePanel { heading: "as it is".to_owned(), curves: family(-1.0) },
        ],
        scaling: CurveScaling::Automatic,
        arrangement: Arrangement::SideBySide,
        horizontal_label: "ξ".to_owned(),
        vertical_label: "p₀".to_owned(),
    }
}

/// Renders, and leaves the picture where it can be looked at.
fn picture(name: &str, plot: &dyn Plot, format: Format, size: Size) -> Vec<u8> {
    let bytes = render(plot, format, size).unwrap();
    let suffix = if format == Format::Png { "png" } else { "svg" };
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.{suffix}"));
    std::fs::write(file, &bytes).unwrap();
    bytes
}

fn svg(name: &str, plot: &dyn Plot) -> String {
    String::from_utf8(picture(name, plot, Format::Svg, Size::default())).unwrap()
}

/// All texts of an SVG with the place of their anchors, after checking that it is XML.
fn texts(svg: &str) -> Vec<(f64, f64, String)> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    let number =
        |node: &roxmltree::Node<'_, '_>, name| node.attribute(name).unwrap().parse().unwrap();
    texts.map(|n| (number(&n, "x"), number(&n, "y"), n.text().unwrap().to_owned())).collect()
}

fn assert_png(bytes: &[u8], size: Size) {
    assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
    let word = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!(word(16), PNG_PIXELS_PER_UNIT * size.width);
    assert_eq!(word(20), PNG_PIXELS_PER_UNIT * size.height);
}

#[test]
fn pictures_are_xml_with_their_labels_inside() {
    let plots: [(&str, &dyn Plot, &[&str]); 4] = [
        ("flat", &flat_punch(), &["x [mm]", "p [MPa]", "displacement [µm]", "edges of the punch"]),
        ("parabola", &parabola(), &["tension, p < 0", "error (bound)", "ends of the contact"]),
        ("convergence", &convergence(), &["n⁻²", "n⁻³", "n⁻⁴", "settlement", "10⁻⁶"]),
        ("families", &families(), &["λ₀ = 0.001", "λ₀ = 100", "as it is", "ξ", "p₀"]),
    ];
    for (name, plot, labels) in plots {
        let texts = texts(&svg(name, plot));
        for label in labels {
            assert!(texts.iter().any(|(_, _, text)| text == label), "{name} lacks {label}");
        }
        for (x, y, text) in &texts {
            let inside = (0.0..=800.0).contains(x) && (0.0..=600.0).contains(y);
            assert!(inside, "{name}: {text} at {x}, {y}");
        }
    }
}

#[test]
fn a_png_has_its_signature_and_size() {
    let size = Size { width: 900, height: 700 };
    assert_png(&picture("flat", &flat_punch(), Format::Png, size), size);
    assert_png(&picture("parabola", &parabola(), Format::Png, size), size);
    assert_png(&picture("convergence", &convergence(), Format::Png, size), size);
    let wide = Size { width: 1000, height: 560 };
    assert_png(&picture("families", &families(), Format::Png, wide), wide);
    let small = SMALL;
    assert_png(&picture("small", &parabola(), Format::Png, small), small);
}

#[test]
fn equal_plots_give_equal_bytes_and_other_plots_do_not() {
    for format in [Format::Svg, Format::Png] {
        let once = render(&parabola(), format, Size::default()).unwrap();
        assert_eq!(once, render(&parabola(), format, Size::default()).unwrap());
        let mut other = parabola();
        other.pressure[100].1 += 20.0;
        assert_ne!(once, render(&other, format, Size::default()).unwrap());
    }
}

#[test]
fn tension_is_named_only_where_there_is_some() {
    let named = |plot: &dyn Plot| svg("tension", plot).contains("tension");
    assert!(named(&parabola()));
    assert!(!named(&flat_punch()));
}

/// The deepest point of the surface is drawn lowest: the axis counts downward.
#[test]
fn depth_grows_downward() {
    let texts = texts(&svg("depth", &flat_punch()));
    let height = |label: &str| {
        let found = texts.iter().filter(|(x, _, text)| *x < 100.0 && text == label);
        found.map(|text| text.1).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(height("10") > height("5"), "{texts:?}");
}

fn nasty_numbers() -> Vec<Vec<f64>> {
    vec![
        vec![],
        vec![0.0],
        vec![f64::NAN],
        vec![5.0; 7],
        vec![-0.0, 0.0],
        vec![1e-15, 2e-15, -3e-15],
        vec![1e20, 2e20, 1.5e20],
        vec![1.0, 1.0 + 1e-12, 1.0 - 1e-12],
        vec![f64::NAN, 1.0, f64::INFINITY, 2.0, f64::NEG_INFINITY, -3.0],
        vec![f64::MAX, f64::MIN, f64::MIN_POSITIVE, 5e-324],
        vec![1e300, -1e300, 1e-300],
        vec![1e-300, 1.000_000_01e-300, 2e-300],
        vec![1e-12, 1e12, 3.0, 1e5, -1e-9],
    ]
}

#[test]
fn nasty_numbers_never_fail() {
    for x in nasty_numbers() {
        for y in nasty_numbers() {
            let points: Vec<_> = x.iter().copied().zip(y.iter().copied()).collect();
            let contact = ContactPlot {
                pressure: points.clone(),
                pressure_band: points.iter().map(|&(x, y)| (x, y, 2.0 * y)).collect(),
                punch_base: points.clone(),
                layer: points.iter().map(|&(x, y)| (x, y, x)).collect(),
                body_surface: points.clone(),
                edges: x.clone(),
                contact_ends: y.clone(),
                window: x.first().zip(y.first()).map(|(x, y)| [*x, *y]),
                whole: "all".to_owned(),
                length_of_depth: y.first().copied(),
                largest_shown: x.first().copied(),
                ..flat_punch()
            };
            let series =
                ConvergenceSeries { n: x.clone(), difference: y.clone(), ..Default::default() };
            let convergence = ConvergencePlot { series: vec![series], ..convergence() };
            let curves = vec![Curve { name: "c".to_owned(), points: points.clone() }];
            let panels = vec![CurvePanel { curves, ..Default::default() }, CurvePanel::default()];
            let curves = CurvesPlot { panels, ..families() };
            for plot in [&contact as &dyn Plot, &convergence, &curves] {
                let svg = render(plot, Format::Svg, SMALL).unwrap();
                let svg = String::from_utf8(svg).unwrap();
                texts(&svg);
                // An arrow is named so, where a pressure is.
                let numbers = svg.replace(">infinite<", "");
                assert!(!numbers.contains("NaN") && !numbers.contains("inf"), "{x:?} {y:?}");
            }
        }
    }
}

#[test]
fn nasty_numbers_never_fail_in_pixels() {
    for numbers in nasty_numbers() {
        let plot = ContactPlot {
            pressure: numbers.iter().map(|&v| (v, v)).collect(),
            punch_base: numbers.iter().map(|&v| (v, v)).collect(),
            body_surface: numbers.iter().map(|&v| (v, v)).collect(),
            ..flat_punch()
        };
        assert_png(&render(&plot, Format::Png, SMALL).unwrap(), SMALL);
    }
}

#[test]
fn nasty_scales_never_fail() {
    let scales = [Scale::Linear, Scale::Logarithmic].into_iter().chain(
        [0.0, -1.0, f64::NAN, 1e-299, 1e299]
            .map(|threshold| Scale::SymmetricLogarithmic { threshold }),
    );
    for scale in scales {
        for x in nasty_numbers() {
            let axis = Axis::with_scale("v", scale).including(f64::NAN).reversed();
            let points = x.iter().map(|&x| (x, x)).collect();
            let line = Line::new("", points, shtaerman_cli::plot::Colour::BLUE);
            let figure = Figure {
                title: String::new(),
                notes: Vec::new(),
                panels: vec![Panel::new(axis.clone(), axis, vec![Layer::Line(line)])],
                arrangement: Arrangement::Stacked,
                legend: LegendPlace::Panel,
            };
            texts(&String::from_utf8(render(&figure, Format::Svg, SMALL).unwrap()).unwrap());
        }
    }
}

#[test]
fn hostile_text_is_cut_and_escaped() {
    let hostile = "<&\"'>\u{0}$x^2$ \\$ ";
    // What there is one of is longer than any memory of a name; what there are many of, a few lines.
    let [long, line] = [4000, 100].map(|times| hostile.repeat(times));
    let mut plot = parabola();
    plot.title.clone_from(&long);
    plot.notes = vec![line.clone(); 50];
    plot.position_label.clone_from(&long);
    plot.pressure_label.clone_from(&long);
    let svg = svg("hostile", &plot);
    assert!(texts(&svg).iter().any(|(_, _, text)| text.starts_with("<&\"'> $x^2$")));
    assert!(svg.len() < 200_000);
    let curve = |i: usize| Curve { name: format!("{i} {line}"), points: vec![(0.0, i as f64)] };
    let curves = (0..300).map(curve).collect();
    let panels = vec![CurvePanel { heading: long.clone(), curves }];
    let plot = CurvesPlot { panels, ..families() };
    let size = Size { width: 1200, height: 1200 };
    let svg = String::from_utf8(render(&plot, Format::Svg, size).unwrap()).unwrap();
    assert!(texts(&svg).iter().any(|(_, _, text)| text.contains("more")));
}

#[test]
fn nothing_to_draw_is_said() {
    let empty = ContactPlot::default();
    assert!(svg("empty", &empty).contains("no numbers to draw"));
    let none = CurvesPlot { panels: Vec::new(), ..families() };
    assert!(svg("none", &none).contains("Pressure"));
}

#[test]
fn a_size_out_of_range_is_an_error() {
    let size = Size { width: 10, height: 100_000 };
    let error = render(&parabola(), Format::Png, size).unwrap_err();
    assert_eq!(error, PlotError::Size { width: 10, height: 100_000 });
}

#[test]
fn the_common_power_of_ten_of_tiny_and_huge_numbers_is_written_at_the_axis() {
    let mut plot = parabola();
    plot.pressure.iter_mut().for_each(|point| *point = (point.0 * 1e20, point.1 * 1e-12));
    plot.pressure_band = Vec::new();
    for line in [&mut plot.punch_base, &mut plot.body_surface] {
        line.iter_mut().for_each(|point| point.0 *= 1e20);
    }
    (plot.edges, plot.contact_ends) = (Vec::new(), Vec::new());
    let texts = texts(&svg("factors", &plot));
    picture("factors", &plot, Format::Png, Size::default());
    // 180e-12 = 180 x 10^-12 and 3e20 = 300 x 10^18
    for factor in ["×10⁻¹²", "×10¹⁸"] {
        assert!(texts.iter().any(|(_, _, text)| text == factor), "{factor}: {texts:?}");
    }
    assert!(texts.iter().any(|(_, _, text)| text == "100"));
}
