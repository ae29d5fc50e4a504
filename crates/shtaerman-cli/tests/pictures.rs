//! Pictures of contacts: what they show of the answer, and what they must not show.
#![expect(clippy::unwrap_used, reason = "helpers outside of test functions fail by panicking")]

use std::path::PathBuf;

use shtaerman::Contact;
use shtaerman::file::ProblemFile;
use shtaerman_cli::plot::{
    ContactPlot, Format, Look, Plot, PlotError, Size, Theme, render, render_as,
};
use shtaerman_cli::{ContactPicture, contact_picture, contact_plot};

fn example(name: &str, overrides: &[&str]) -> Contact {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
    ProblemFile::open(&path, &overrides).unwrap().solve().unwrap()
}

fn svg(plot: &dyn Plot) -> String {
    String::from_utf8(render(plot, Format::Svg, Size::default()).unwrap()).unwrap()
}

fn finite(points: &[(f64, f64)]) -> impl Iterator<Item = &(f64, f64)> {
    points.iter().filter(|point| point.0.is_finite() && point.1.is_finite())
}

#[test]
fn nothing_is_drawn_of_a_punch_where_there_is_none() {
    // Feet from 300 mm to 400 mm on either side.
    let plot = contact_plot(&example("two_punches.toml", &[])).unwrap();
    for points in [&plot.punch_base, &plot.pressure] {
        assert!(finite(points).all(|(x, _)| (300.0..=400.0).contains(&x.abs())), "{points:?}");
        // The curve is broken between them.
        let is_broken = points.windows(2).any(|pair| pair[0].0 < 0.0 && pair[1].1.is_nan());
        assert!(is_broken, "{points:?}");
    }
    assert_eq!(plot.edges, [-400.0, -300.0, 300.0, 400.0]);
    // The body goes on between them.
    assert!(finite(&plot.body_surface).any(|(x, _)| x.abs() < 10.0));
}

#[test]
fn a_wave_has_no_edges_and_no_kinks() {
    let plot = contact_plot(&example("wave.toml", &[])).unwrap();
    assert!(plot.edges.is_empty());
    assert!(!svg(&plot).contains("edges of the punch"));
    let (left, right) = (plot.pressure[0], *finite(&plot.pressure).last().unwrap());
    assert!((left.0 + 500.0).abs() < 1e-9 && (right.0 - 500.0).abs() < 1e-9, "{left:?} {right:?}");
    assert!((left.1 - right.1).abs() < 1e-6 * left.1.abs());
    // Where the period repeats the slope of the base does, too.
    let base: Vec<(f64, f64)> = finite(&plot.punch_base).copied().collect();
    let slope = |from: f64, to: f64| {
        let inside: Vec<&(f64, f64)> = base.iter().filter(|p| (from..=to).contains(&p.0)).collect();
        let (first, last) = (inside[0], inside[inside.len() - 1]);
        (last.1 - first.1) / (last.0 - first.0)
    };
    let [before, after] = [slope(230.0, 249.9), slope(250.1, 270.0)];
    assert!((before + after).abs() < 0.05 * slope(100.0, 150.0).abs(), "{before} {after}");
    assert_eq!(plot.contact_ends.len(), 4);
}

#[test]
fn a_narrow_contact_is_shown_larger_with_the_whole_beside() {
    let hertz = ["punch.half_width=20 mm", "punch.profile=x^2/(2*0.05)", "load.force=20 kN/m"];
    let contact = example("crowned_punch.toml", &hertz);
    let plot = contact_plot(&contact).unwrap();
    let [left, right] = plot.window.unwrap();
    let width = contact.contact_width() * 1e6;
    assert!((right - left) / width > 2.0 && (right - left) / width < 4.0, "{left} {right} {width}");
    assert!(svg(&plot).contains("the whole base, to ±20 mm"));
    let inside = finite(&plot.pressure).filter(|(x, _)| (left..=right).contains(x)).count();
    assert!(inside > 200, "{inside}");
    // What is asked for is shown instead.
    let wanted = ContactPicture { x_range: Some([-1e-3, 2e-3]), ..ContactPicture::default() };
    let asked = contact_picture(&contact, &wanted).unwrap();
    assert_eq!(asked.window, Some([-1.0, 2.0]));
    // A wide contact is shown whole.
    let wide = contact_plot(&example("crowned_punch.toml", &[])).unwrap();
    assert!(wide.whole.is_empty() && !svg(&wide).contains("the whole base"));
}

/// Beside the base the surface is the one that the contact knows there, as far as it is shown; nothing of the punch is drawn.
#[test]
fn beside_the_base_the_free_surface_is_shown() {
    let contact = example("crowned_punch.toml", &[]);
    let a = contact.problem().punch().half_width();
    for [from, to] in [[0.5 * a, 12.0 * a], [-4.0 * a, 0.2 * a], [0.1 * a, 1.7 * a]] {
        let wanted = ContactPicture { x_range: Some([from, to]), ..ContactPicture::default() };
        let plot = contact_picture(&contact, &wanted).unwrap();
        let within = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
            let shown = |x: f64| (from * 1e3 - 1e-9..=to * 1e3 + 1e-9).contains(&x);
            finite(points).copied().filter(|(x, _)| shown(*x)).collect()
        };
        let body = within(&plot.body_surface);
        for end in [from, to] {
            let nearest = body.iter().map(|(x, _)| (x - end * 1e3).abs()).fold(9e9, f64::min);
            assert!(nearest <= 0.02 * (to - from) * 1e3, "{from} {to}: {nearest}");
        }
        // The line is a layer's thickness below the surface, everywhere beside the base.
        let factor = plot.length_of_depth.unwrap() * 1e-3;
        let free = body.iter().filter(|(x, _)| x.abs() > a * 1e3 * (1.0 + 1e-9));
        let below: Vec<f64> =
            free.map(|(x, u)| u * factor - contact.elastic_displacement(x * 1e-3)).collect();
        assert!(below.len() > 20, "{}", below.len());
        assert!(below.iter().all(|depth| (depth - below[0]).abs() < 1e-12), "{below:?}");
        let base = within(&plot.punch_base);
        assert!(base.len() > 50 && base.iter().all(|(x, _)| x.abs() <= a * 1e3 * (1.0 + 1e-9)));
        assert_eq!(plot.whole.is_empty(), to - from > 2.0 * a, "{from} {to}");
    }
}

/// What is periodic goes on: pressures and surfaces a period away are the same, and none is missing in what is shown.
#[test]
fn a_wave_goes_on_over_all_of_a_range() {
    let contact = example("wave.toml", &[]);
    let period = 0.5e-3;
    for [from, to] in [[0.0, 4.2], [-3.3, 0.1], [0.6, 0.9], [95.2, 98.9]] {
        let wanted = ContactPicture {
            x_range: Some([from * period, to * period]),
            ..ContactPicture::default()
        };
        let plot = contact_picture(&contact, &wanted).unwrap();
        let unit = plot.window.unwrap()[1] / to;
        for points in [&plot.pressure, &plot.body_surface, &plot.punch_base] {
            let mut shown: Vec<(f64, f64)> = finite(points)
                .map(|(x, y)| (x / unit, *y))
                .filter(|(x, _)| (from..=to).contains(x))
                .collect();
            shown.sort_by(|one, two| one.0.total_cmp(&two.0));
            let gap = shown.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(0.0, f64::max);
            let ends = (shown[0].0 - from).max(to - shown[shown.len() - 1].0);
            assert!(gap.max(ends) < 0.02, "{from} {to}: {gap} {ends}");
        }
        let pressure = finite(&plot.pressure).filter(|(x, _)| (from..=to).contains(&(x / unit)));
        for (x, p) in pressure {
            let xi = x / unit - (x / unit).round();
            let exact = contact.pressure(xi * period).unwrap();
            let found = p * contact.peak_pressure() / peak(&plot);
            assert!((found - exact).abs() < 1e-6 * contact.peak_pressure(), "{x}: {found} {exact}");
        }
    }
}

fn peak(plot: &ContactPlot) -> f64 {
    finite(&plot.pressure).map(|(_, p)| *p).fold(0.0, f64::max)
}

#[test]
fn what_is_beyond_a_frame_is_hidden() {
    let hertz = ["punch.half_width=20 mm", "punch.profile=x^2/(2*0.05)", "load.force=20 kN/m"];
    let text = svg(&contact_plot(&example("crowned_punch.toml", &hertz)).unwrap());
    let picture = roxmltree::Document::parse(&text).unwrap();
    let mut clipped = 0;
    for node in picture.descendants() {
        let Some(clip) = node.attribute("clip-path") else { continue };
        let id = clip.strip_prefix("url(#").unwrap().strip_suffix(')').unwrap();
        let path = picture.descendants().find(|node| node.attribute("id") == Some(id)).unwrap();
        assert_eq!(path.tag_name().name(), "clipPath");
        let width = path.first_element_child().unwrap().attribute("width").unwrap();
        assert!((100.0..800.0).contains(&width.parse::<f64>().unwrap()), "{width}");
        clipped += 1;
    }
    assert_eq!(clipped, 3);
}

#[test]
fn infinite_ends_run_out_of_the_frame() {
    let smooth = contact_plot(&example("flat_punch.toml", &["foundation.roughness=0"])).unwrap();
    let infinite = smooth.pressure.iter().filter(|point| point.1 == f64::INFINITY).count();
    assert_eq!(infinite, 2);
    // The mean is 80 MPa, the middle has 2/pi of it, and what is shown is not set by the ends.
    let shown = smooth.largest_shown.unwrap();
    assert!(shown > 80.0 && shown < 400.0, "{shown}");
    let svg = svg(&smooth);
    assert!(svg.contains("infinite pressure at corners") && svg.contains(">infinite<"));
    let rough = contact_plot(&example("flat_punch.toml", &[])).unwrap();
    assert!(rough.largest_shown.is_none());
}

#[test]
fn the_error_is_called_what_it_is() {
    let contact = example("eccentric_load.toml", &[]);
    let told = |plot: &ContactPlot| (plot.band_name.clone(), plot.notes.join(" "));
    let (name, notes) = told(&contact_plot(&contact).unwrap());
    assert_eq!(name, "error (estimate)");
    assert!(notes.contains("(estimate)") && !notes.contains("bound"), "{notes}");
    let (name, notes) = told(&contact_plot(&contact.audited().unwrap()).unwrap());
    assert_eq!(name, "error (bound)");
    assert!(
        notes.contains("error of the pressure at most") && notes.contains("(bound)"),
        "{notes}"
    );
    // One that can be seen is drawn.
    let rough = example("paper_row.toml", &["solver.n=8"]);
    let plot = contact_plot(&rough).unwrap();
    let error = rough.error().unwrap().pressure;
    let (_, low, high) = plot.pressure_band[200];
    assert!((0.5 * (high - low) / error - 1.0).abs() < 1e-9);
    assert!(svg(&plot).contains(&plot.band_name));
}

#[test]
fn the_layer_lies_between_base_and_body() {
    let contact = example("crowned_punch.toml", &[]);
    let plot = contact_plot(&contact).unwrap();
    // A micrometre of depth; chi p at the middle, and the thickness where it is free.
    let chi = 1.2e-14;
    let at = |x: f64| {
        plot.layer.iter().min_by(|a, b| (a.0 - x).abs().total_cmp(&(b.0 - x).abs())).unwrap()
    };
    let thickness = |x: f64| (at(x).2 - at(x).1) * 1e-6;
    let compressed = thickness(7.0) - thickness(0.0);
    let exact = chi * contact.pressure(0.0).unwrap();
    assert!((compressed / exact - 1.0).abs() < 1e-4, "{compressed} {exact}");
    assert!(plot.layer.iter().all(|(_, upper, lower)| upper <= lower));
    assert!(plot.layer_name.starts_with("rough layer, drawn 1.9 µm thick"), "{}", plot.layer_name);
    let svg = svg(&plot);
    for name in ["punch", "elastic body", "heights exaggerated "] {
        assert!(svg.contains(name), "{name}");
    }
    let smooth = contact_plot(&example("flat_punch.toml", &["foundation.roughness=0"])).unwrap();
    assert!(smooth.layer.is_empty());
}

#[test]
fn titles_come_from_file_load_and_peak() {
    let contact = example("eccentric_load.toml", &[]);
    let named = ContactPicture { name: "eccentric_load".to_owned(), ..ContactPicture::default() };
    let title = contact_picture(&contact, &named).unwrap().title;
    let peak = contact.peak_pressure() / 1e6;
    assert!(title.starts_with("Eccentric load: 800 kN/m, moment "), "{title}");
    assert!(title.ends_with(&format!("largest pressure {peak:.1} MPa")), "{title}");
    let plot = contact_plot(&contact).unwrap();
    for code in ["first_kind", "theta0", "sinc"] {
        assert!(!svg(&plot).contains(code), "{code}");
    }
}

#[test]
fn axes_have_a_handful_of_ticks() {
    for (name, overrides) in
        [("wave.toml", &[][..]), ("rough_ball.toml", &[]), ("paper_row.toml", &[])]
    {
        let plot = contact_plot(&example(name, overrides)).unwrap();
        for size in [Size { width: 400, height: 300 }, Size::default(), Size::LARGEST] {
            let svg = String::from_utf8(render(&plot, Format::Svg, size).unwrap()).unwrap();
            let document = roxmltree::Document::parse(&svg).unwrap();
            let labels = document.descendants().filter(|node| node.has_tag_name("text"));
            let numbers: Vec<(String, String)> = labels
                .filter(|node| {
                    node.text().is_some_and(|text| text.replace('−', "-").parse::<f64>().is_ok())
                })
                .map(|node| {
                    (
                        node.attribute("y").unwrap().to_owned(),
                        node.attribute("x").unwrap().to_owned(),
                    )
                })
                .collect();
            for (y, x) in &numbers {
                let along = numbers.iter().filter(|one| one.0 == *y).count();
                // Both panels have the same places along, and one vertical axis each.
                let up = numbers.iter().filter(|one| one.1 == *x).count();
                assert!(along <= 9 + 2 && up <= 2 * 9 + 2, "{name}: {along} and {up} labels");
            }
        }
    }
}

#[test]
fn themes_sizes_and_resolutions() {
    let plot = contact_plot(&example("flat_punch.toml", &[])).unwrap();
    let look = |theme| Look { theme, ..Look::default() };
    let text = |look| String::from_utf8(render_as(&plot, Format::Svg, look).unwrap()).unwrap();
    let [screen, print, dark] =
        [Theme::Screen, Theme::Print, Theme::Dark].map(|theme| text(look(theme)));
    assert!(
        screen
            .starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"600\"")
    );
    assert!(
        print.contains("width=\"605\" height=\"454\"") && print.contains("viewBox=\"0 0 605 454\"")
    );
    assert!(dark.contains("fill=\"#14181f\"") && !screen.contains("#14181f"));
    // No grid in print.
    assert!(screen.contains("#dcdcdc") && !print.contains("#dcdcdc"));
    let dots = Look {
        size: Some(Size { width: 384, height: 288 }),
        dots_per_inch: Some(300),
        ..Look::default()
    };
    let png = render_as(&plot, Format::Png, dots).unwrap();
    let word = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    // 4 inches by 3 at 300 dots.
    assert_eq!((word(16), word(20)), (1200, 900));
    let at = png.windows(4).position(|window| window == b"pHYs").unwrap() + 4;
    assert_eq!((word(at), word(at + 4), png[at + 8]), (11811, 11811, 1));
    for dots_per_inch in [10, 5000] {
        let look = Look { dots_per_inch: Some(dots_per_inch), ..Look::default() };
        let error = render_as(&plot, Format::Png, look).unwrap_err();
        assert_eq!(error, PlotError::Resolution { dots: dots_per_inch });
    }
    if cfg!(feature = "pdf") {
        let pdf = render_as(&plot, Format::Pdf, look(Theme::Print)).unwrap();
        assert!(pdf.starts_with(b"%PDF-"));
    } else {
        assert_eq!(render_as(&plot, Format::Pdf, look(Theme::Print)), Err(PlotError::NoPdf));
    }
}
