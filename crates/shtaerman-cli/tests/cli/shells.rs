//! What shells and `man` read, and a quiet run.

use std::process::Command;

use crate::cli::support::Folder;

const COMMANDS: [&str; 19] = [
    "solve",
    "find",
    "validate",
    "init",
    "reproduce",
    "regularity",
    "convergence",
    "equation",
    "stress",
    "spectrum",
    "sweep",
    "explore",
    "roughness",
    "export",
    "trace",
    "schema",
    "completions",
    "book",
    "man",
];

#[test]
fn completions_have_all_commands_and_bash_takes_them() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = folder.run(&["completions", shell]).answer();
        for command in COMMANDS {
            assert!(script.contains(command), "{shell}: {command}");
        }
    }
    folder.run(&["completions", "bash", "--output", "c.sh"]).answer();
    let asked = "source ./c.sh; COMP_WORDS=(shtaerman sol); COMP_CWORD=1; _shtaerman shtaerman sol shtaerman; echo \"${COMPREPLY[*]}\"";
    // Where there is no bash, nobody completes in it.
    if let Ok(told) = Command::new("bash").args(["-c", asked]).current_dir(folder.path("")).output()
    {
        assert_eq!(String::from_utf8_lossy(&told.stdout), "solve\n");
    }
    assert!(folder.run(&["completions", "csh"]).refusal().contains("csh"));
}

#[test]
fn every_command_has_a_page() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("man1")).unwrap();
    let said = folder.run(&["man", "man1"]).answer();
    assert!(said.contains("pages to man1"), "{said}");
    for command in COMMANDS {
        let page = folder.read(&format!("man1/shtaerman-{command}.1"));
        assert!(page.starts_with(".ie") && page.contains(".SH SYNOPSIS"), "{command}: {page}");
    }
    assert!(folder.read("man1/shtaerman-solve.1").contains("sensitivities"));
    assert!(folder.read("man1/shtaerman-roughness-table.1").contains("FILE"));
    folder.run(&["man", "nowhere"]).failure(2);
}

#[test]
fn a_quiet_run_tells_errors_only() {
    let folder = Folder::new();
    folder.run(&["init"]).answer();
    let heavy =
        ["solve", "punch.toml", "--set", "load.force=0.8 GN/m", "--format", "json", "--no-audit"];
    let loud = folder.run(&heavy);
    assert!(loud.stderr.contains("warning: "), "{}", loud.stderr);
    let quiet = folder.run(&[&heavy[..], &["--quiet"]].concat());
    assert_eq!((quiet.stderr.as_str(), &quiet.stdout), ("", &loud.stdout));
    assert!(folder.run(&["-q", "solve", "nowhere.toml"]).refusal().contains("nowhere.toml"));
}

#[test]
fn every_geometry_has_an_example() {
    let folder = Folder::new();
    for geometry in ["plane", "circular", "periodic", "pair"] {
        folder.run(&["init", "--geometry", geometry, "--force"]).answer();
        assert!(folder.read("punch.toml").contains("shtaerman solve punch.toml --plot punch.svg"));
        assert!(
            geometry == "plane"
                || folder.read("punch.toml").contains(&format!("geometry = \"{geometry}\""))
        );
        folder.run(&["solve", "punch.toml", "--no-audit", "--strict"]).answer();
    }
    folder.run(&["init", "--geometry", "round"]).refusal();
}

#[test]
fn init_writes_a_schema_that_the_first_line_names() {
    let folder = Folder::new();
    let said = folder.run(&["init"]).answer();
    assert!(said.contains("wrote problem.schema.json"), "{said}");
    assert!(folder.read("punch.toml").starts_with("#:schema ./problem.schema.json\n"));
    let schema = folder.read("problem.schema.json");
    assert_eq!(folder.run(&["schema"]).answer(), schema);
    // It is there now; an older one of ours is renewed.
    let said = folder.run(&["init", "--force"]).answer();
    assert!(!said.contains("schema.json"), "{said}");
    folder.write("problem.schema.json", "{\n  \"title\": \"Shtaerman problem file\"\n}\n");
    folder.run(&["init", "--force"]).answer();
    assert_eq!(folder.read("problem.schema.json"), schema);
    // What is not ours stays, and nothing is written.
    folder.write("problem.schema.json", "mine");
    let before = folder.read("punch.toml");
    let refused = folder.run(&["init", "--force", "--geometry", "pair"]);
    assert!(refused.refusal().contains("is no schema of ours"), "{}", refused.stderr);
    assert_eq!(
        (folder.read("problem.schema.json"), folder.read("punch.toml")),
        ("mine".to_owned(), before)
    );
    for name in [
        "problem",
        "equation-file",
        "answer",
        "find",
        "stress",
        "equation",
        "spectrum",
        "roughness",
        "convergence",
        "regularity",
        "reproduction",
        "trace",
    ] {
        let text = folder.run(&["schema", name]).answer();
        let file = format!("schema/{}.schema.json", name.replace('-', "_"));
        assert_eq!(
            text,
            std::fs::read_to_string(crate::cli::support::repository().join(file)).unwrap()
        );
    }
}

#[test]
fn the_schema_of_equation_files_takes_what_the_program_takes() {
    let schema = crate::cli::support::schema("equation_file");
    for entry in std::fs::read_dir(crate::cli::support::repository().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.to_string_lossy().contains("equation_") {
            let text = std::fs::read_to_string(&path).unwrap();
            crate::cli::support::assert_valid(
                &schema,
                &crate::cli::support::toml_as_json(&text),
                &text,
            );
        }
    }
    let folder = Folder::new();
    folder.run(&["init", "--equation"]).answer();
    let text = folder.read("equation.toml");
    crate::cli::support::assert_valid(&schema, &crate::cli::support::toml_as_json(&text), "init");
    for (from, to) in [
        ("lambda = 1.0", "lamda = 1.0"),
        ("kind = \"second\"", "kind = \"third\""),
        ("kind = \"second\"", "kind = \"first\""),
        ("name = \"power\"", "name = \"powers\""),
    ] {
        let wrong = text.replacen(from, to, 1);
        assert_ne!(wrong, text);
        assert!(!schema.is_valid(&crate::cli::support::toml_as_json(&wrong)), "{to}");
        folder.write("wrong.toml", &wrong);
        folder.run(&["equation", "wrong.toml"]).refusal();
    }
}
