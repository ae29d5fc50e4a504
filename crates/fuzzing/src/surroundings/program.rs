//! Running the program in a folder of its own.

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use tempfile::TempDir;

/// Where this variable is set, the program of this crate is `shtaerman`: both are built in one go, from the same sources.
pub const RUN_AS_PROGRAM: &str = "FUZZING_RUNS_AS_SHTAERMAN";

static PROGRAM: OnceLock<PathBuf> = OnceLock::new();

/// Says where the program of this crate lies; without it, it is the one that runs.
pub fn set_program(path: impl Into<PathBuf>) {
    // The first word counts.
    let _ = PROGRAM.set(path.into());
}

/// The program under test.
pub(super) fn program() -> Result<PathBuf, String> {
    PROGRAM.get().map_or_else(|| std::env::current_exe().map_err(told), |path| Ok(path.clone()))
}

/// An error of the system as a fault of the case.
#[expect(clippy::needless_pass_by_value, reason = "for `map_err`")]
pub(super) fn told(error: std::io::Error) -> String {
    format!("the surroundings of a case fail: {error}")
}

/// A folder for one run, gone afterwards.
pub(super) struct Folder(TempDir);

/// Content of files by their names.
pub(super) type Files = BTreeMap<OsString, Vec<u8>>;

impl Folder {
    pub(super) fn new() -> Result<Self, String> {
        tempfile::tempdir().map(Self).map_err(told)
    }

    pub(super) fn path(&self) -> &Path {
        self.0.path()
    }

    pub(super) fn write(&self, name: impl AsRef<OsStr>, content: &str) -> Result<(), String> {
        std::fs::write(self.path().join(name.as_ref()), content).map_err(told)
    }

    /// Everything that lies in it.
    pub(super) fn files(&self) -> Result<Files, String> {
        let mut files = Files::new();
        for entry in std::fs::read_dir(self.path()).map_err(told)? {
            let entry = entry.map_err(told)?;
            files.insert(entry.file_name(), std::fs::read(entry.path()).map_err(told)?);
        }
        Ok(files)
    }

    /// The program with these arguments, which prints nowhere.
    pub(super) fn command(&self, arguments: &[&str]) -> Result<Command, String> {
        let mut command = Command::new(program()?);
        command.args(arguments);
        Ok(self.prepared(command))
    }

    /// A line of the shell, in which `$0` is the program.
    pub(super) fn shell(&self, line: &str) -> Result<Command, String> {
        let mut command = Command::new("sh");
        command.arg("-c").arg(line).arg(program()?);
        Ok(self.prepared(command))
    }

    fn prepared(&self, mut command: Command) -> Command {
        command.current_dir(self.path()).env(RUN_AS_PROGRAM, "1");
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command
    }
}
