//! Equation files that make no sense, and values made to break them.

use crate::cli::equation::{FIRST, SECOND, file};
use crate::cli::support::{Folder, Run};

/// Runs `equation` on a faulty file with both kinds of output; nothing is written, whatever the exit code is.
#[track_caller]
fn run(text: &str) -> Run {
    let folder = Folder::new();
    folder.write("e.toml", text);
    let arguments =
        ["equation", "e.toml", "--format", "json", "--output", "out.json", "--plot", "out.svg"];
    let run = folder.run(&arguments);
    assert_eq!(folder.files(), ["e.toml"], "{text}{run:?}");
    run
}

/// A refusal at a place with words, in which `validate` agrees.
#[track_caller]
fn refused(text: &str, place: &str, said: &str) {
    let refusal = run(text);
    let message = refusal.refusal();
    assert!(message.starts_with(&format!("error: {place}: ")), "{text}{message}");
    assert!(refusal.stderr.contains(said), "{text}{}", refusal.stderr);
    let folder = Folder::new();
    folder.write("e.toml", text);
    let validated = folder.run(&["validate", "e.toml"]);
    validated.refusal();
    assert_eq!(validated.stderr, refusal.stderr);
}

#[test]
fn keys_and_kinds() {
    for (base, from, to, place, said) in [
        (SECOND, "kind = \"second\"\n", "", "e.toml:1: equation.kind", "is missing"),
        (SECOND, "\"second\"", "\"secnod\"", "e.toml:2: equation.kind", "did you mean \"second\"?"),
        (SECOND, "\"second\"", "2", "e.toml:2: equation.kind", "is a string"),
        (SECOND, "lambda = 1.0\n", "", "e.toml:1: equation.lambda", "kind = \"first\""),
        (SECOND, "lambda", "lamdba", "e.toml:3: equation.lambda", "did you mean lambda?"),
        (SECOND, "= 1.0\nrhs", "= \"1 Pa\"\nrhs", "e.toml:3: equation.lambda", "no dimensions"),
        (SECOND, "rhs = \"1 + x\"\n", "", "e.toml:1: equation.rhs", "is missing"),
        (SECOND, "1 + x", "1 + y", "e.toml:4: equation.rhs", "y"),
        (SECOND, "1 + x", "1 + 2x", "e.toml:4: equation.rhs", "write 2*x"),
        (SECOND, "1 + x", "1/x", "e.toml:4: equation.rhs", "at x = 0: it must be finite"),
        (SECOND, "1 + x", "ln(x)", "e.toml:4: equation.rhs", "must be finite"),
        (SECOND, "1 + x", "1/(x - 0.3)", "e.toml:4: equation.rhs", "at x = 0.3"),
        (SECOND, "[kernel]\nname = \"log\"\na = 1.0\n", "", "e.toml: kernel", "is missing"),
        (SECOND, "name = \"log\"\n", "", "e.toml:6: kernel.name", "is missing"),
        (SECOND, "\"log\"", "\"pwoer\"", "e.toml:7: kernel.name", "did you mean \"power\"?"),
        (SECOND, "\"log\"", "\"logratio\"", "e.toml:7: kernel.name", "did you mean \"log-ratio\"?"),
        (SECOND, "\"log\"", "1", "e.toml:7: kernel.name", "is a string"),
        (SECOND, "\na = 1.0", "\na = 1.0\nmu = 0.3", "e.toml:9: kernel.mu", "kernel log takes a ("),
        (SECOND, "\na = 1.0", "", "e.toml:6: kernel.a", "kernel log takes a ("),
        (SECOND, "\na = 1.0", "\nA = 1.0", "e.toml:8: kernel.a", "A is written, did you mean a?"),
        (SECOND, "\na = 1.0", "\na = \"5 mm\"", "e.toml:8: kernel.a", "no dimensions"),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\nweight = 3",
            "e.toml:9: kernel.weight",
            "not a known key",
        ),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\ninterval = \"half-line\"",
            "e.toml:9: kernel.interval",
            "macdonald",
        ),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\n[load]\nforce = 1",
            "e.toml:9: load",
            "is not a known key",
        ),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\n[solver]\nn = 40",
            "e.toml:10: solver.n",
            "method = \"spectral\"",
        ),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\n[solver]\ntolerance = 0",
            "e.toml:10: solver.tolerance",
            "greater than 0",
        ),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\n[solver]\ncontact = \"bilateral\"",
            "e.toml:10: solver.contact",
            "not a known key",
        ),
        (
            SECOND,
            "\na = 1.0",
            "\na = 1.0\n[solver]\nmethod = \"magic\"",
            "e.toml:10: solver.method",
            "is one of",
        ),
        (
            FIRST,
            "rhs",
            "lambda = 1\nrhs",
            "e.toml:3: equation.lambda",
            "belongs to kind = \"second\"",
        ),
        (
            FIRST,
            "\na = 1.0",
            "\na = 1.0\n[solver]\nmethod = \"sinc\"",
            "e.toml:9: solver.method",
            "second kind",
        ),
        (FIRST, "\na = 1.0", "\na = 1.0\n[solver]\nn = 0", "e.toml:9: solver.n", "from 1 to 20000"),
    ] {
        let text = base.replace(from, to);
        assert_ne!(text, base, "{from}");
        refused(&text, place, said);
    }
    let set = SECOND.to_owned() + "[solver]\nmethod = \"spectral\"\nn = 40\n";
    for n in ["7", "0", "-1", "20001", "100000000000", "1e3", "9223372036854775807"] {
        refused(
            &set.replace("n = 40", &format!("n = {n}")),
            "e.toml:11: solver.n",
            "is a whole number",
        );
    }
}

/// Kernel, the key at fault, words of the message: the range, and why.
#[test]
fn parameters_out_of_range() {
    for (kernel, key, said) in [
        ("name = \"log\"\na = 0", "a", "positive"),
        ("name = \"log\"\na = -1", "a", "positive"),
        ("name = \"log-ratio\"\na = 1\nb = 0", "b", "name = \"log-ratio-limit\""),
        ("name = \"log-ratio\"\na = 1\nb = 0", "b", "not integrable at 0"),
        ("name = \"log-ratio\"\na = 1\nb = -0.5", "b", "positive"),
        ("name = \"log-ratio\"\na = 1\nb = 1", "b", "below"),
        ("name = \"log-ratio\"\na = 1\nb = 2", "b", "below"),
        ("name = \"log-ratio\"\na = -1\nb = 0.5", "a", "between"),
        ("name = \"log-ratio-limit\"\na = 0", "a", "between"),
        ("name = \"log-square\"\na = 1\nb = -1", "b", "at least 0"),
        ("name = \"log-sine\"\nalpha = 0", "alpha", "below pi"),
        ("name = \"log-sine\"\nalpha = 3.2", "alpha", "positive definite"),
        ("name = \"log-sine\"\nalpha = \"180 deg\"", "alpha", "below pi"),
        ("name = \"log-sine\"\nalpha = \"1 mm\"", "alpha", "mm"),
        ("name = \"power\"\na = 1\nmu = 0", "mu", "between 0 and 1"),
        ("name = \"power\"\na = 1\nmu = 1", "mu", "integrated"),
        ("name = \"power\"\na = 1\nmu = -0.2", "mu", "positive"),
        ("name = \"power\"\na = 0\nmu = 0.2", "a", "positive"),
        ("name = \"macdonald\"\na = 1\nmu = 0.5\nkappa = 1", "mu", "1/2"),
        ("name = \"macdonald\"\na = 1\nmu = 0\nkappa = 0", "kappa", "positive"),
        ("name = \"macdonald\"\na = 1\nmu = 0\nkappa = 1e6", "", "kappa a"),
        ("name = \"macdonald\"\ninterval = \"half-line\"\nmu = 0.5\nkappa = 1", "mu", "1/2"),
        ("name = \"macdonald\"\ninterval = \"half-line\"\nmu = 0\nkappa = -1", "kappa", "1e-50"),
        (
            "name = \"macdonald\"\ninterval = \"half-line\"\na = 1\nmu = 0\nkappa = 1",
            "a",
            "on the half-line",
        ),
        ("name = \"macdonald\"\ninterval = \"line\"\nmu = 0\nkappa = 1", "interval", "half-line"),
        ("name = \"weber-sonine\"\na = 1\nmu = -1\ngamma = 0", "mu", "positive"),
        ("name = \"weber-sonine\"\na = 1\nmu = 0\ngamma = 0.5", "gamma", "integrable"),
        ("name = \"weber-sonine\"\na = 0\nmu = 0\ngamma = 0", "a", "positive"),
        ("name = \"yukawa\"\na = 1\nchi0 = -1\nm = 0", "chi0", ""),
        ("name = \"yukawa\"\na = 1\nchi0 = 1\nm = -1", "m", "whole number"),
        ("name = \"yukawa\"\na = 1\nchi0 = 1\nm = 1.5", "m", "whole number"),
        ("name = \"yukawa\"\na = 1\nchi0 = 1\nm = 4000000000", "m", ""),
    ] {
        let text = file(Some(1.0), "1", kernel);
        let line =
            kernel.lines().position(|line| line.starts_with(&format!("{key} ="))).unwrap_or(0);
        let place = if key.is_empty() {
            "e.toml:5: kernel".to_owned()
        } else {
            format!("e.toml:{}: kernel.{key}", 6 + line)
        };
        refused(&text, &place, said);
    }
}

/// Eigenvalues of the plain logarithm on (-1, 1), by collocation with `NumPy`: 16 digits.
const EIGENVALUES: [f64; 2] = [1.764_238_546_025_337_4, 1.566_005_108_374_583_6];

#[test]
fn promises_that_cannot_be_kept_end_with_3() {
    let mut cases: Vec<(String, &str)> = EIGENVALUES
        .iter()
        .flat_map(|nu| {
            let text = SECOND.replace("= 1.0\nrhs", &format!("= {:?}\nrhs", -1.0 / nu));
            [text, "no unique solution".to_owned()]
        })
        .collect::<Vec<_>>()
        .chunks(2)
        .map(|pair| (pair[0].clone(), "no unique solution"))
        .collect();
    // The logarithmic capacity 1: int ln 1/|x - s| w ds = 0.
    cases.push((FIRST.replace("a = 1.0", "a = 2.0"), "eigenvalue 0 of the kernel is 0"));
    let solver = |lines: &str| format!("{SECOND}[solver]\n{lines}\n");
    cases.push((solver("tolerance = 1e-16"), "the tolerance 1e-16 was not met"));
    cases.push((
        solver("method = \"spectral\"\nn = 8\ntolerance = 1e-9"),
        "spectral method with n = 8",
    ));
    let half_line = "name = \"macdonald\"\ninterval = \"half-line\"\nmu = 0.0\nkappa = 1.0";
    // 1/G(0) = 1/pi.
    cases.push((file(Some(-0.33), "exp(-x)", half_line), "continuous spectrum"));
    // A constant is no potential of a density that decays, nor is a step one of a function.
    cases.push((file(None, "1", half_line), "no digit of the solution is certain"));
    cases.push((FIRST.replace("\"1\"", "\"step(x)\""), "no digit of the solution is certain"));
    cases.push((file(Some(1.0), "exp(x)", half_line), "no digit of the solution is certain"));
    // However small a kink or a jump, the solution of the first kind is infinite there: `p.v. int dx/(x - s)` of a step is a logarithm.
    for (rhs, said) in [
        ("1 + 1e-9*abs(x - 0.3)", "x = 0.3, where the right-hand side has a kink"),
        ("1 + 1e-6*max(0, x - 0.3)^0.5", "x = 0.3, where the right-hand side has a kink"),
        ("1 + 1e-3*max(0, 1e-9 - abs(x - 0.3))", "where the right-hand side has a kink"),
        ("1 + 1e-11*step(x - 0.3)", "x = 0.3, where the right-hand side has a jump"),
        ("1 + 1.41421e8*max(0, x - 0.9999999999)^1.5", "no digit of the solution is certain"),
    ] {
        cases.push((FIRST.replace("\"1\"", &format!("\"{rhs}\"")), said));
    }
    for (text, said) in &cases {
        let run = run(text);
        assert_eq!(run.code, Some(3), "{text}{run:?}");
        assert!(run.stderr.starts_with("error: ") && run.stderr.contains(said), "{}", run.stderr);
    }
    // A tolerance that can be kept is, and what looks like a kink and is none is solved.
    let folder = Folder::new();
    for smooth in ["cos(abs(x - 0.3))", "max(x^2, 2*x^2)", "abs(x^2 - 0.3)^2", "cbrt(x)^6"] {
        folder.write("e.toml", FIRST.replace("\"1\"", &format!("\"{smooth}\"")));
        folder.run(&["equation", "e.toml"]).answer();
    }
    folder.write("e.toml", solver("tolerance = 1e-6"));
    folder.run(&["equation", "e.toml"]).answer();
    // Beside an eigenvalue there is an answer, and it knows its error.
    let near = -1.0 / EIGENVALUES[0] * (1.0 + 1e-4);
    folder.write("e.toml", SECOND.replace("= 1.0\nrhs", &format!("= {near:?}\nrhs")));
    folder.run(&["equation", "e.toml", "--cross-check"]).answer();
}

#[test]
fn slow_kernels_are_said_to_be_slow() {
    for (kernel, slow) in [
        ("name = \"power\"\na = 1.0\nmu = 0.49", false),
        ("name = \"power\"\na = 1.0\nmu = 0.5", true),
        ("name = \"power\"\na = 1.0\nmu = 0.8", true),
        ("name = \"macdonald\"\na = 1.0\nmu = 0.3\nkappa = 1.0", true),
        ("name = \"weber-sonine\"\na = 1.0\nmu = 0.0\ngamma = 0.3", true),
    ] {
        let folder = Folder::new();
        folder.write("e.toml", file(Some(0.5), "1", kernel));
        let json = folder.run(&["equation", "e.toml", "--format", "json"]).json();
        let warnings = json["warnings"].to_string();
        assert_eq!(warnings.contains("not_square_summable"), slow, "{kernel}: {warnings}");
    }
}

/// The right answer or a clear refusal, and never a NaN.
#[test]
fn hostile_values() {
    hostile(&["nan", "inf", "-1e308", "1e400", "0"]);
}

#[test]
fn extreme_values() {
    hostile(&["1e-308", "1e-320", "-0.0", "745.5"]);
}

fn hostile(values: &[&str]) {
    for value in values {
        let lambda = SECOND.replace("= 1.0\nrhs", &format!("= {value}\nrhs"));
        let half_length = SECOND.replace("\na = 1.0", &format!("\na = {value}"));
        let rhs = SECOND.replace("\"1 + x\"", value);
        let mu = file(Some(1.0), "1", &format!("name = \"power\"\na = 1.0\nmu = {value}"));
        let decay = file(
            Some(1.0),
            "1",
            &format!("name = \"macdonald\"\na = 1.0\nmu = 0.1\nkappa = {value}"),
        );
        let half_line = file(
            Some(1.0),
            "exp(-x)",
            &format!("name = \"macdonald\"\ninterval = \"half-line\"\nmu = 0.1\nkappa = {value}"),
        );
        let disk =
            file(Some(1.0), "1", &format!("name = \"yukawa\"\na = 1.0\nchi0 = {value}\nm = 0"));
        let order = file(
            Some(1.0),
            "1",
            &format!("name = \"weber-sonine\"\na = 1.0\nmu = {value}\ngamma = 0.1"),
        );
        let first = FIRST.replace("a = 1.0", &format!("a = {value}"));
        for text in [lambda, half_length, rhs, mu, decay, half_line, disk, order, first] {
            let folder = Folder::new();
            folder.write("e.toml", &text);
            let mut arguments = vec!["equation", "e.toml", "--format", "json", "--points", "9"];
            // The audit of the thousands of nodes of so fast a decay takes ten seconds.
            arguments.extend((*value == "745.5").then_some("--no-audit"));
            let run = folder.run(&arguments);
            assert!(!run.stderr.contains("panicked"), "{text}{}", run.stderr);
            match run.code {
                Some(0) => {
                    let first = text.contains("first");
                    assert!(!run.stdout.contains("NaN"), "{text}{}", run.stdout);
                    let json = run.json();
                    crate::cli::support::assert_valid(
                        &crate::cli::support::schema("equation"),
                        &json,
                        &text,
                    );
                    if !first {
                        assert!(!json["solution"]["phi"].to_string().contains("null"), "{text}");
                    }
                }
                Some(2 | 3) => assert!(run.stderr.starts_with("error: "), "{text}{}", run.stderr),
                _ => assert_eq!(run.code, Some(0), "{text}{run:?}"),
            }
        }
    }
}

#[test]
fn arguments() {
    let folder = Folder::new();
    folder.write("e.toml", SECOND);
    folder.write("f.toml", FIRST);
    folder.write("empty.toml", "");
    for (arguments, said) in [
        (
            ["e.toml", "--at", "1.5"].as_slice(),
            "--at `1.5`: is beyond the interval, which reaches from -1 to 1",
        ),
        (&["e.toml", "--at", "0,"], "--at ``"),
        (&["e.toml", "--at", "nan"], "--at `nan`"),
        (&["e.toml", "--at", "1 mm"], "--at `1 mm`"),
        (&["e.toml", "--points", "1"], "--points 1: must be from 2"),
        (&["e.toml", "--points", "10000000"], "--points"),
        (&["e.toml", "--plot", "e.bmp"], "use .svg"),
        (&["e.toml", "--output", "e.toml"], "is the problem file"),
        (&["e.toml", "--set", "kernel.a"], "has no `=`"),
        (&["e.toml", "--set", "kernel.a=-1"], "--set kernel.a=-1: kernel.a: is -1: must be"),
        (&["f.toml", "--cross-check"], "--cross-check: the first kind has one method"),
        (&["empty.toml"], "the file is empty"),
        (&["nowhere.toml"], "cannot be read"),
    ] {
        let run = folder.run(&[&["equation"], arguments].concat());
        run.refusal();
        assert!(run.stderr.contains(said), "{arguments:?}: {}", run.stderr);
    }
    let run = folder.run_with_input(&["equation", "-"], "");
    assert!(run.refusal().contains("standard input: the file is empty"));
    // Rounding may take a place a little beyond an end.
    folder.run(&["equation", "e.toml", "--at", "1.0000000000000002"]).answer();
}
