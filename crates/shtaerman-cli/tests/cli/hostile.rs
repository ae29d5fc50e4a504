//! Files that are no problem files at all, and files made to break a reader.

use std::io::Write;

use crate::cli::support::{Folder, PHYSICAL, Run, finished};

/// Solves `file` and checks that the message begins with `place`, is short and leaves no file behind.
#[track_caller]
fn refused_at(folder: &Folder, file: &str, place: &str) -> Run {
    let before = folder.files();
    let run = folder.run(&["solve", file, "--output", "out.txt", "--plot", "out.svg"]);
    let message = run.refusal();
    assert!(message.starts_with(&format!("error: {place}")), "{message}");
    assert!(run.stderr.len() < 2000, "a message of {} bytes", run.stderr.len());
    assert_eq!(folder.files(), before);
    run
}

#[track_caller]
fn refused(folder: &Folder, place: &str) -> Run {
    refused_at(folder, "punch.toml", place)
}

#[test]
fn no_problem_files() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder")).unwrap();
    for (content, said) in [
        (b"".as_slice(), "the file is empty"),
        (b" \n\n", "the file is empty"),
        (b"# nothing\n", "comments but no keys"),
        (b"[solver]\n# \xff\n", "not UTF-8: byte 0xff at offset 11, line 2"),
        (b"\xff\xfe[\0s\0", "it looks like UTF-16"),
        (b"{\"punch\": 1}", "is not valid TOML"),
        (b"[solver\n", "punch.toml:1: is not valid TOML"),
        (
            b"[solver]\ncontact = \"bilateral\"\n",
            "neither [foundation], [punch], [load] nor [dimensionless]",
        ),
        (b"\0\0\0\0", "punch.toml"),
    ] {
        folder.write("punch.toml", content);
        let run = refused(&folder, "punch.toml");
        assert!(run.stderr.contains(said), "{said}: {}", run.stderr);
    }
    assert!(refused_at(&folder, "folder", "folder: ").stderr.contains("is a folder"));
    assert!(
        refused_at(&folder, "nowhere.toml", "nowhere.toml: ").stderr.contains("cannot be read")
    );
    let run = folder.run_with_input(&["solve", "-"], "");
    assert!(run.refusal().contains("standard input: the file is empty"));
}

/// A problem with this profile, written piece by piece: it may be large.
fn with_profile(folder: &Folder, piece: &str, count: usize) {
    let (before, after) = PHYSICAL.split_once("x^2 / (2*20)").unwrap();
    let mut file =
        std::io::BufWriter::new(std::fs::File::create(folder.path("punch.toml")).unwrap());
    file.write_all(before.as_bytes()).unwrap();
    for _ in 0..count {
        file.write_all(piece.as_bytes()).unwrap();
    }
    file.write_all(after.as_bytes()).unwrap();
}

#[test]
fn an_expression_of_100_megabytes() {
    let folder = Folder::new();
    with_profile(&folder, &"x + ".repeat(1000), 25_000);
    let run = refused(&folder, "punch.toml:8: punch.profile");
    assert!(run.stderr.contains("the expression has 100000000 bytes"), "{}", run.stderr);
}

#[test]
fn nesting_without_end() {
    let folder = Folder::new();
    for (piece, count) in
        [("(", 1_000_000), ("(", 60_000), ("(", 300), ("sin(", 300), ("-", 60_000), ("2^", 30_000)]
    {
        with_profile(&folder, piece, count);
        refused(&folder, "punch.toml:8: punch.profile");
    }
    for text in [
        format!("a = {}", "[".repeat(1_000_000)),
        format!("a = {}{}", "[".repeat(1_000_000), "]".repeat(1_000_000)),
        format!("a = {}", "{a=".repeat(300_000)),
        format!("{}a = 1", "a.".repeat(1_000_000)),
        format!("[{}a]", "a.".repeat(1_000_000)),
    ] {
        folder.write("punch.toml", text);
        let run = refused(&folder, "punch.toml:1");
        assert!(!run.stderr.contains("aaaa"), "{}", run.stderr);
    }
}

#[test]
fn files_too_large_to_be_read() {
    let folder = Folder::new();
    // A hole: takes no space.
    std::fs::File::create(folder.path("punch.toml")).unwrap().set_len(3 << 30).unwrap();
    assert!(
        refused(&folder, "punch.toml").stderr.contains("more than the 200000000 that are read")
    );
    folder.write("punch.toml", PHYSICAL.replace("\"x^2 / (2*20)\"", "{ csv = \"p.csv\" }"));
    std::fs::File::create(folder.path("p.csv")).unwrap().set_len(3 << 30).unwrap();
    assert!(refused(&folder, "punch.toml:8: punch.profile.csv").stderr.contains("p.csv has"));
}

/// Devices and pipes that never end are read to the limit of files, which takes less than 1.5 GB.
#[cfg(unix)]
#[test]
fn streams_without_an_end() {
    let folder = Folder::with(&PHYSICAL.replace("\"x^2 / (2*20)\"", "{ csv = \"/dev/zero\" }"));
    let bearing = ["roughness", "bearing", "--hardness", "1 GPa", "--trace", "/dev/zero"];
    for (arguments, place) in [
        (["solve", "/dev/zero"].as_slice(), "/dev/zero: "),
        (&["equation", "/dev/zero"], "/dev/zero: "),
        (&["validate", "/dev/zero"], "/dev/zero: "),
        (&["solve", "punch.toml"], "punch.toml:8: punch.profile.csv: /dev/zero "),
        (&["roughness", "table", "/dev/zero"], "/dev/zero: "),
        (&bearing, "/dev/zero: "),
    ] {
        let run = finished(folder.limited("ulimit -v 1500000", arguments).output().unwrap());
        let said = format!("error: {place}has more than the 200000000 bytes that are read");
        assert_eq!(run.refusal(), said);
    }
    let endless = std::fs::File::open("/dev/zero").unwrap();
    let mut piped = folder.limited("ulimit -v 1500000", &["solve", "-"]);
    let run = finished(piped.stdin(endless).output().unwrap());
    assert!(run.refusal().contains("standard input has more than"), "{}", run.stderr);
}

/// 200 TiB with any method, so beyond every machine: the file is sound, the promise cannot be kept.
#[test]
fn degrees_beyond_memory() {
    let folder = Folder::with(&PHYSICAL.replace("n = 40", "n = 1_000_000_000_000"));
    let run = folder.run(&["solve", "punch.toml"]);
    assert!(run.failure(3).starts_with("error: punch.toml:16: solver.n: "), "{}", run.stderr);
    assert!(run.stderr.contains("of memory, and"), "{}", run.stderr);
    let run = folder.run(&["validate", "punch.toml", "--set", "solver.n=10"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

/// What the process may not have is refused before it is asked for, and what is admitted is had.
#[cfg(target_os = "linux")]
#[test]
fn limits_of_the_process_count() {
    let folder = Folder::with(&PHYSICAL.replace("n = 40", "n = 8_000_000"));
    for limit in ["ulimit -v 2000000", "ulimit -d 2000000"] {
        let run = finished(folder.limited(limit, &["solve", "punch.toml"]).output().unwrap());
        let said =
            "error: punch.toml:16: solver.n: is 8000000: that needs 12.800 GB of memory, and";
        assert!(run.failure(3).starts_with(said), "{limit}: {}", run.stderr);
        let study = ["convergence", "punch.toml", "--max-n", "4000000", "--set", "solver.n=40"];
        let run = finished(folder.limited(limit, &study).output().unwrap());
        assert!(run.failure(3).contains("of memory, and"), "{limit}: {}", run.stderr);
        let solve = ["solve", "punch.toml"];
        let run = finished(folder.limited("ulimit -v 600000", &solve).output().unwrap());
        run.failure(3);
        let most = run.stderr.split("n may be ").nth(1).unwrap().split(' ').next().unwrap();
        // The next run may find less free by the 64 MB that the allocator sets aside for a thread.
        let set = format!("solver.n={}", most.parse::<usize>().unwrap() * 85 / 100);
        let solve = ["solve", "punch.toml", "--set", &set];
        finished(folder.limited("ulimit -v 600000", &solve).output().unwrap()).answer();
    }
}

/// What is finite in the file may overflow on its way to the answer: that is bad input, too, and never `null` in JSON.
#[test]
fn answers_that_overflow() {
    for (from, to) in [
        ("0.8 MN/m", "1e306 N/m"),
        ("0.8 MN/m", "1.7e308 N/m"),
        ("100 N", "1e307 N"),
        ("x^2 / (2*20)", "1e300"),
        ("x^2 / (2*20)", "1e290*xi^2"),
    ] {
        let folder = Folder::with(&PHYSICAL.replace(from, to));
        let run = folder.run(&["solve", "punch.toml", "--format", "json"]);
        if run.code == Some(0) {
            assert!(!run.stdout.contains(": null") && !run.stdout.contains("null,"), "{to}");
        } else {
            assert!(run.refusal().starts_with("error: punch.toml"), "{}", run.stderr);
        }
    }
    let folder = Folder::with(&PHYSICAL.replace("0.8 MN/m", "1e306 N/m"));
    refused(&folder, "punch.toml: the pressure comes out as inf");
}
