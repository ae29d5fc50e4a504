//! Files that are read stay as they are, and files that are written keep what is theirs.
#![cfg(unix)]

use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::Path;
use std::time::{Duration, Instant};

use crate::cli::support::{Folder, PHYSICAL, finished, is_ignored};

/// A problem with a measured profile, `trace.csv`.
fn measured() -> Folder {
    let csv = "{ csv = \"trace.csv\", x_unit = \"mm\", f_unit = \"um\" }";
    let folder = Folder::with(&PHYSICAL.replace("\"x^2 / (2*20)\"", csv));
    folder.write("trace.csv", TRACE);
    folder
}

const TRACE: &str = "-6,1\n-3,0.2\n0,0\n3,0.2\n6,1\n";

#[test]
fn no_file_that_is_read_is_written_over() {
    let folder = measured();
    folder.write("table.csv", "0,0\n1e-6,1e6\n2e-6,3e6\n");
    folder.write(
        "e.toml",
        "[equation]\nkind = \"second\"\nlambda = 1\nrhs = \"1\"\n[kernel]\nname = \"log\"\na = 1\n",
    );
    for name in ["trace.csv", "punch.toml", "table.csv", "e.toml"] {
        symlink(name, folder.path(&format!("{name}.link"))).unwrap();
        std::fs::hard_link(folder.path(name), folder.path(&format!("{name}.svg"))).unwrap();
    }
    let before = folder.files();
    let commands: [(&[&str], &str, &str); 9] = [
        (&["solve", "punch.toml", "--format", "csv"], "trace.csv", "the measured profile"),
        (&["find", "force", "punch.toml", "--peak-pressure", "1 GPa"], "trace.csv", "the measured"),
        (&["find", "profile", "punch.toml", "--pressure", "1"], "trace.csv", "the measured"),
        (&["stress", "punch.toml"], "trace.csv", "the measured profile"),
        (&["convergence", "punch.toml"], "trace.csv", "the measured profile"),
        (&["solve", "punch.toml"], "punch.toml", "the problem file"),
        (&["equation", "e.toml"], "e.toml", "the problem file"),
        (&["roughness", "table", "table.csv"], "table.csv", "the table"),
        (
            &["roughness", "bearing", "--hardness", "1 GPa", "--trace", "trace.csv"],
            "trace.csv",
            "the trace",
        ),
    ];
    for (command, name, said) in commands {
        let content = folder.read(name);
        let absolute = folder.path(name).into_os_string().into_string().unwrap();
        let names = [name, &format!("./{name}"), &format!("{name}.link"), &format!("{name}.svg")];
        for output in names.into_iter().chain([absolute.as_str()]) {
            let run = folder.run(&[command, &["--output", output]].concat());
            let message = run.refusal();
            assert!(message.contains(&format!("{output} is {said}")), "{message}");
            assert!(message.ends_with("the result would overwrite it"), "{message}");
        }
        if command[0] == "solve" {
            let plot = format!("{name}.svg");
            folder.run(&[command, &["--plot", &plot]].concat()).refusal();
        }
        assert_eq!(folder.read(name), content);
    }
    assert_eq!(folder.files(), before);
    // Another file in the folder is free, one of the same content as well.
    folder.write("copy.csv", TRACE);
    folder.run(&["solve", "punch.toml", "--output", "copy.csv"]).answer();
}

#[test]
fn standard_input_is_a_file_that_is_read() {
    let folder = Folder::with(PHYSICAL);
    let input = std::fs::File::open(folder.path("punch.toml")).unwrap();
    let mut command = folder.command(&["solve", "-", "--output", "punch.toml"]);
    let run = finished(command.stdin(input).output().unwrap());
    assert!(run.refusal().contains("punch.toml is the problem file"), "{}", run.stderr);
    assert_eq!(folder.read("punch.toml"), PHYSICAL);
}

fn mode(path: &Path) -> u32 {
    std::fs::metadata(path).unwrap().permissions().mode() & 0o7777
}

fn set_mode(path: &Path, mode: u32) {
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode)).unwrap();
}

#[test]
fn permissions_of_what_is_replaced_are_kept() {
    let folder = Folder::with(PHYSICAL);
    let (result, plot) = (folder.path("out.txt"), folder.path("out.svg"));
    let solve = ["solve", "punch.toml", "--output", "out.txt", "--plot", "out.svg"];
    folder.run(&solve).answer();
    // What the umask leaves, as of any new file.
    folder.write("usual", "");
    assert_eq!(mode(&result), mode(&folder.path("usual")));
    for kept in [0o600, 0o640, 0o664, 0o666, 0o755] {
        set_mode(&result, kept);
        set_mode(&plot, kept);
        folder.run(&solve).answer();
        assert_eq!([mode(&result), mode(&plot)], [kept, kept]);
    }
    let owner = std::fs::metadata(&result).unwrap().uid();
    assert_eq!(owner, std::fs::metadata(folder.path("usual")).unwrap().uid());
    for refused in [0o444, 0o400] {
        folder.write("out.txt", "mine");
        set_mode(&result, refused);
        let run = folder.run(&solve);
        let said = "error: out.txt cannot be written: it is read-only";
        assert_eq!(run.refusal(), said);
        assert_eq!((folder.read("out.txt").as_str(), mode(&result)), ("mine", refused));
        set_mode(&result, 0o644);
    }
    assert_eq!(folder.files(), ["out.svg", "out.txt", "punch.toml", "usual"]);
}

#[test]
fn links_that_lead_nowhere_are_followed_and_not_replaced() {
    let folder = Folder::with(PHYSICAL);
    let link = folder.path("link.toml");
    symlink("second", &link).unwrap();
    symlink("target.toml", folder.path("second")).unwrap();
    let run = folder.run(&["init", "link.toml"]);
    assert!(run.refusal().contains("link.toml exists already"), "{}", run.stderr);
    assert_eq!(folder.files(), ["link.toml", "punch.toml", "second"]);
    folder.run(&["init", "link.toml", "--force"]).answer();
    assert!(link.is_symlink() && folder.path("second").is_symlink());
    assert!(folder.read("target.toml").contains("[punch]"));

    symlink("result.txt", folder.path("out.txt")).unwrap();
    folder.run(&["solve", "punch.toml", "--output", "out.txt"]).answer();
    assert!(folder.path("out.txt").is_symlink());
    assert!(folder.read("result.txt").contains("settlement"));
    symlink("loop", folder.path("loop")).unwrap();
    let run = folder.run(&["solve", "punch.toml", "--output", "loop"]);
    assert!(run.refusal().contains("leads to itself"), "{}", run.stderr);
    symlink("nowhere/result.txt", folder.path("astray")).unwrap();
    let run = folder.run(&["solve", "punch.toml", "--output", "astray"]);
    assert!(run.refusal().contains("there is no folder"), "{}", run.stderr);
}

/// Writes enough to be met while it does.
const LONG: [&str; 9] =
    ["regularity", "--theta0", "1", "--rows", "1000000", "--format", "csv", "--output", "out.csv"];

/// Waits until a temporary file has content.
#[track_caller]
fn wait_for_content(folder: &Folder) {
    let begun = Instant::now();
    let has_content = |name: &String| {
        let is_temporary = name.starts_with(".shtaerman-");
        is_temporary && std::fs::metadata(folder.path(name)).is_ok_and(|found| found.len() > 0)
    };
    while !folder.files().iter().any(has_content) {
        assert!(begun.elapsed() < Duration::from_secs(120), "nothing was written");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn signals_leave_nothing() {
    let signals = [("HUP", 1), ("INT", 2), ("QUIT", 3), ("USR1", 10), ("TERM", 15), ("XCPU", 24)];
    for (signal, _) in signals.into_iter().filter(|(_, number)| !is_ignored(*number)) {
        // On a busy machine a run may be over before the signal comes.
        let is_met = (0..20).any(|_| is_ended_by(signal));
        assert!(is_met, "{signal}");
    }
}

/// Whether the signal ended a run, which has then left nothing.
#[track_caller]
fn is_ended_by(signal: &str) -> bool {
    let folder = Folder::new();
    folder.write("out.csv", "old");
    let mut child = folder.command(&LONG).spawn().unwrap();
    wait_for_content(&folder);
    let kill = ["-s", signal, &child.id().to_string()];
    assert!(std::process::Command::new("kill").args(kill).status().unwrap().success());
    let code = child.wait().unwrap().code();
    assert_eq!(folder.files(), ["out.csv"], "{signal}");
    if code == Some(0) {
        return false;
    }
    assert_eq!(code, Some(130), "{signal}");
    assert_eq!(folder.read("out.csv"), "old");
    true
}

#[test]
fn limits_of_the_size_of_files_leave_nothing() {
    let folder = Folder::with(PHYSICAL);
    let solve = ["solve", "punch.toml", "--format", "json", "--output", "out.json"];
    let run = finished(folder.limited("ulimit -f 1", &solve).output().unwrap());
    assert!(
        run.failure(1).starts_with("error: out.json cannot be written: File too large"),
        "{}",
        run.stderr
    );
    assert_eq!(folder.files(), ["punch.toml"]);
}

/// A full disk is no bad input, and help that nobody got is no answer.
#[cfg(target_os = "linux")]
#[test]
fn what_could_not_be_written_ends_with_1() {
    let folder = Folder::with(PHYSICAL);
    for arguments in [
        ["--help"].as_slice(),
        &["--version"],
        &["help"],
        &["solve", "--help"],
        &["solve", "punch.toml"],
        &["init", "-"],
    ] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let run = finished(folder.command(arguments).stdout(full).output().unwrap());
        let message = run.failure(1);
        assert!(message.starts_with("error: standard output cannot be written: No space left"));
    }
    let run = folder.run(&["solve", "punch.toml", "--output", "/dev/full"]);
    assert!(run.failure(1).starts_with("error: /dev/full cannot be written"), "{}", run.stderr);
}
