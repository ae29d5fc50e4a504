//! Running the program in a folder of its own.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

/// The program under test.
pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_shtaerman");

/// A valid physical problem; line numbers of tests count in it.
pub(crate) const PHYSICAL: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"

[punch]
half_width = "5 mm"
profile = "x^2 / (2*20)"

[load]
force = "0.8 MN/m"
moment = "100 N"

[solver]
contact = "bilateral"
n = 40
"#;

/// The same where the punch may lift off.
pub(crate) const UNILATERAL: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"

[punch]
half_width = "5 mm"
profile = "x^2 / (2*20)"

[load]
force = "0.8 MN/m"
moment = "100 N"
"#;

/// A valid dimensionless problem.
pub(crate) const DIMENSIONLESS: &str = r#"[dimensionless]
theta0 = 13.0
profile = "xi^4 - xi/2"
force = 1.7
moment = -0.31

[solver]
contact = "bilateral"
n = 40
"#;

/// How a run ended.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    /// Standard output of a run that gave an answer.
    #[track_caller]
    pub(crate) fn answer(self) -> String {
        assert_eq!(self.code, Some(0), "{}", self.stderr);
        self.stdout
    }

    /// JSON of a run that gave an answer.
    #[track_caller]
    pub(crate) fn json(self) -> Value {
        serde_json::from_str(&self.answer()).unwrap()
    }

    /// The one `error:` line of a run that refused bad input and printed nothing else.
    #[track_caller]
    pub(crate) fn refusal(&self) -> &str {
        self.failure(2)
    }

    /// The one `error:` line of a run that ended with this code and printed nothing else.
    #[track_caller]
    pub(crate) fn failure(&self, code: i32) -> &str {
        assert_eq!(self.code, Some(code), "{self:?}");
        assert_eq!(self.stdout, "", "{self:?}");
        let mut lines = self.stderr.lines().filter(|line| line.starts_with("error:"));
        let line = lines.next().unwrap();
        assert_eq!(lines.next(), None, "more than one message: {}", self.stderr);
        assert!(!self.stderr.contains("panicked"), "{}", self.stderr);
        line
    }
}

/// A folder for one test, gone afterwards.
#[derive(Debug)]
pub(crate) struct Folder(tempfile::TempDir);

impl Folder {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// A folder with `punch.toml`.
    pub(crate) fn with(problem: &str) -> Self {
        let folder = Self::new();
        folder.write("punch.toml", problem);
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// Names of the files in the folder, sorted; hidden ones as well.
    pub(crate) fn files(&self) -> Vec<String> {
        let mut names: Vec<String> = std::fs::read_dir(self.0.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(PROGRAM);
        command.current_dir(self.0.path()).args(arguments).stdin(Stdio::null());
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Run {
        finished(self.command(arguments).output().unwrap())
    }

    /// The program under limits of the shell, such as `ulimit -v 1500000` (KiB).
    #[cfg(unix)]
    pub(crate) fn limited(&self, limits: &str, arguments: &[&str]) -> Command {
        let mut command = Command::new("sh");
        command
            .current_dir(self.0.path())
            .args(["-c", &format!("{limits} && exec \"$0\" \"$@\""), PROGRAM])
            .args(arguments)
            .stdin(Stdio::null());
        command
    }

    /// A run with this standard input.
    pub(crate) fn run_with_input(&self, arguments: &[&str], input: &str) -> Run {
        let mut child = self
            .command(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // Short enough for the buffer of the pipe.
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        finished(child.wait_with_output().unwrap())
    }
}

pub(crate) fn finished(output: std::process::Output) -> Run {
    Run {
        code: output.status.code(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Whether the tests were started to ignore a signal, as a shell does with `INT` and `QUIT` for what runs in the background: the program then ignores it, too.
#[cfg(unix)]
pub(crate) fn is_ignored(signal: u32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.map_or(0, |mask| u64::from_str_radix(mask.trim(), 16).unwrap());
    ignored >> (signal - 1) & 1 == 1
}

/// The root of the repository.
pub(crate) fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// `schema/NAME.schema.json`, compiled.
pub(crate) fn schema(name: &str) -> jsonschema::Validator {
    let path = repository().join(format!("schema/{name}.schema.json"));
    let schema: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    jsonschema::draft202012::meta::validate(&schema).map_err(|error| error.to_string()).unwrap();
    jsonschema::draft202012::new(&schema).map_err(|error| error.to_string()).unwrap()
}

/// Asserts that `value` is what the schema describes.
#[track_caller]
pub(crate) fn assert_valid(schema: &jsonschema::Validator, value: &Value, what: &str) {
    let faults: Vec<String> = schema
        .iter_errors(value)
        .map(|error| format!("{}: {error}", error.instance_path()))
        .collect();
    assert!(faults.is_empty(), "{what}: {faults:?}");
}

/// A problem file as the schema of problem files sees it.
pub(crate) fn toml_as_json(text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap()
}

/// The number at a path such as `/physical/settlement`.
#[track_caller]
pub(crate) fn number(value: &Value, pointer: &str) -> f64 {
    value.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic_at(pointer, value))
}

#[track_caller]
fn panic_at(pointer: &str, value: &Value) -> f64 {
    assert!(
        value.pointer(pointer).is_some_and(Value::is_number),
        "no number at {pointer}: {value}"
    );
    f64::NAN
}
