//! The book: every block of code runs, is compared with what it is taken from, or says why not.
//!
//! A block is marked by a comment on the line above it, which no reader sees: `<!-- not run: REASON -->` or `<!-- excerpt of PATH -->`. Blocks of a chapter run one after the other in a folder
//! with the examples, as a reader would run them; chapters in `ELSEWHERE` are run by other tests.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cli::support::{Folder, PROGRAM, repository};

/// Languages of chapters that other tests run, and which.
const ELSEWHERE: [(&str, &str, &str); 9] = [
    ("ten-tasks", "sh", "python/tests/test_ten_tasks.py"),
    ("ten-tasks", "text", "python/tests/test_ten_tasks.py"),
    ("ten-tasks", "python", "python/tests/test_ten_tasks.py"),
    ("ten-tasks", "matlab", "python/tests/test_ten_tasks.py"),
    ("ten-tasks", "rust", "crates/shtaerman/src/lib.rs"),
    ("layered", "rust", "crates/shtaerman/src/lib.rs"),
    ("python", "python", "python/tests/test_examples.py"),
    ("studies", "python", "python/tests/test_sweep.py"),
    ("ten-tasks", "toml", "python/tests/test_ten_tasks.py"),
];

/// Language of a block that is set off by four blanks.
const INDENTED: &str = "indented";

#[derive(Debug)]
struct Block {
    place: String,
    chapter: String,
    language: String,
    text: String,
    /// The comment above it.
    mark: String,
}

fn blocks(path: &Path) -> Vec<Block> {
    let chapter = path.file_stem().unwrap().to_str().unwrap().to_owned();
    let text = fs::read_to_string(path).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    // What stands before a block, and whether that is an item of a list.
    let (mut above, mut in_list) = ("", false);
    let mut at = 0;
    while at < lines.len() {
        let line = lines[at];
        let start = at;
        let fence = line.trim_start().strip_prefix("```");
        let is_indented =
            line.starts_with("    ") && !in_list && at > 0 && lines[at - 1].is_empty();
        if fence.is_none() && !is_indented {
            if !line.is_empty() {
                above = line;
                let is_item = line.starts_with("- ")
                    || line.trim_start_matches(|c: char| c.is_ascii_digit()).starts_with(". ");
                in_list = is_item || (in_list && line.starts_with(' '));
            }
            at += 1;
            continue;
        }
        let inside: Vec<&str> = if fence.is_some() {
            at += 1;
            let inside = lines[at..].iter().take_while(|line| line.trim() != "```");
            inside
                .map(|line| {
                    line.strip_prefix(
                        &" ".repeat(lines[start].len() - lines[start].trim_start().len()),
                    )
                    .unwrap_or(line)
                })
                .collect()
        } else {
            lines[at..]
                .iter()
                .take_while(|line| line.starts_with("    "))
                .map(|line| &line[4..])
                .collect()
        };
        at += inside.len() + usize::from(fence.is_some());
        found.push(Block {
            place: format!("docs/src/{chapter}.md:{}", start + 1),
            chapter: chapter.clone(),
            language: fence.map_or(INDENTED, str::trim).to_owned(),
            text: inside.join("\n"),
            mark: above
                .strip_prefix("<!-- ")
                .and_then(|mark| mark.strip_suffix(" -->"))
                .unwrap_or_default()
                .to_owned(),
        });
        above = "";
    }
    found
}

fn chapters() -> Vec<PathBuf> {
    let mut chapters: Vec<PathBuf> = fs::read_dir(repository().join("docs/src"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    chapters.sort();
    chapters
}

/// Text with single blanks: tables are as wide as what stands in them.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Whether a line was printed; numbers of many digits may differ in the last ones, as they do between processors.
fn prints(said: &str, line: &str) -> bool {
    const DIGITS: usize = 12;
    const LAST: f64 = 1e-11;
    let number = |word: &str| -> Option<f64> {
        let is_long = word.chars().filter(char::is_ascii_digit).count() > DIGITS;
        word.trim_end_matches(',').parse().ok().filter(|_| is_long)
    };
    let is_same = |(found, wanted): (&&str, &&str)| {
        let numbers = number(found).zip(number(wanted));
        found == wanted || numbers.is_some_and(|(a, b)| (a - b).abs() <= LAST * b.abs())
    };
    let (found, wanted): (Vec<&str>, Vec<&str>) =
        (said.split(' ').collect(), line.split(' ').collect());
    said.contains(line)
        || found.windows(wanted.len()).any(|words| words.iter().zip(&wanted).all(is_same))
}

/// What a script of a POSIX shell prints, with the program on the path; where it fails, why.
fn shell(folder: &Folder, script: &str) -> Result<String, String> {
    let programs = Path::new(PROGRAM).parent().unwrap().display().to_string();
    let path = format!("{programs}:{}", std::env::var("PATH").unwrap_or_default());
    let mut command = Command::new("sh");
    let done = command
        .args(["-eu", "-c", script])
        .current_dir(folder.path("."))
        .env("PATH", path)
        .output()
        .unwrap();
    let said = format!(
        "{}{}",
        String::from_utf8_lossy(&done.stdout),
        String::from_utf8_lossy(&done.stderr)
    );
    if done.status.success() { Ok(said) } else { Err(said) }
}

/// Commands after `$ `, each with what is shown of its output; `...` stands for what is left out.
fn console(folder: &Folder, text: &str) -> Result<(), String> {
    for part in format!("\n{text}").split("\n$ ").skip(1) {
        let (command, shown) = part.split_once('\n').unwrap_or((part, ""));
        let said = words(&shell(folder, command)?);
        for line in shown.lines().map(words).filter(|line| !line.is_empty() && line != "...") {
            if !prints(&said, &line) {
                return Err(format!("`{command}` does not print `{line}` but\n{said}"));
            }
        }
    }
    Ok(())
}

/// A problem file, a study or an equation, whole or with what it leaves out.
fn problem(folder: &Folder, text: &str) -> Result<(), String> {
    let first = text.lines().next().unwrap_or_default();
    if let Some(name) = first
        .strip_prefix("# ")
        .filter(|name| name.ends_with(".toml") && !name.contains(['/', ' ']))
    {
        folder.write(name, format!("{text}\n"));
        return Ok(());
    }
    let mut whole = format!("{text}\n");
    let is_alone = ["[dimensionless]", "[equation]"].iter().any(|table| text.contains(table));
    let rest = [
        (
            "[foundation]",
            "young_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nroughness = \"1e-15 m/Pa\"\n",
        ),
        ("[punch]", "half_width = \"5 mm\"\nprofile = \"x^2 / (2*20)\"\n"),
        ("[load]", "force = \"0.1 MN/m\"\nmoment = 0\n"),
    ];
    for (table, keys) in rest {
        if !is_alone && !text.contains(table) {
            whole += &format!("{table}\n{keys}");
        }
    }
    folder.write("block.toml", whole);
    let run = folder.run(&["validate", "block.toml"]);
    if run.code == Some(0) { Ok(()) } else { Err(run.stderr) }
}

/// Lines of commands: those without a gap to be filled run, of the others options are looked up, and names of files, packages, tests and examples of what cargo is to run.
fn commands(folder: &Folder, text: &str) -> Result<(), String> {
    let joined = text.replace("\\\n", " ");
    for line in joined.lines().filter(|line| !line.trim().is_empty()) {
        let command = line.split("   ").next().unwrap().split("  #").next().unwrap().trim();
        let Some(arguments) = command.strip_prefix("shtaerman ") else {
            named(command)?;
            continue;
        };
        let is_gap = |word: &str| {
            let bare = word.trim_end_matches([',', ';']);
            bare == "..."
                || word.contains(['[', ']', '|'])
                || word.starts_with('(')
                || bare.split(['.', '=', ':']).any(|part| {
                    part.len() > 1
                        && part.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit())
                        && part.starts_with(char::is_alphabetic)
                })
                || bare == "T"
        };
        // The page is served until it is ended.
        if arguments.split(' ').any(is_gap) || arguments.starts_with("explore ") {
            synopsis(folder, arguments)?;
        } else {
            shell(folder, command).map_err(|said| format!("`{command}`: {said}"))?;
        }
    }
    Ok(())
}

/// Each option of a synopsis is one of the command.
fn synopsis(folder: &Folder, arguments: &str) -> Result<(), String> {
    let lower = |word: &&str| {
        word.chars().all(|c| c.is_ascii_lowercase() || c == '-') && !word.starts_with('-')
    };
    let mut commands: Vec<&str> = arguments.split(' ').take_while(lower).collect();
    let mut help = loop {
        let run = folder.run(&[&commands[..], &["--help"]].concat());
        if run.code == Some(0) {
            break run.stdout;
        }
        if commands.pop().is_none() || commands.is_empty() {
            return Err(format!("no command: `{arguments}`"));
        }
    };
    help.push_str(" --title --size --theme --dpi ");
    let options = arguments
        .split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'))
        .filter(|word| word.starts_with("--") && word.len() > 2);
    for option in options {
        let is_known = help
            .split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'))
            .any(|word| word == option);
        if !is_known {
            return Err(format!("`shtaerman {}` has no {option}", commands.join(" ")));
        }
    }
    Ok(())
}

/// What a command of cargo, Python or a shell names is there.
fn named(command: &str) -> Result<(), String> {
    let root = repository();
    let words: Vec<&str> = command.split_whitespace().collect();
    let crates: Vec<PathBuf> =
        fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path()).collect();
    let there = |kind: &str, name: &str| {
        crates.iter().any(|path| {
            let file = path.join(kind).join(name);
            file.with_extension("rs").is_file() || file.join("main.rs").is_file()
        })
    };
    for pair in words.windows(2) {
        let is_there = match pair[0] {
            "--example" => there("examples", pair[1]),
            "--bench" => there("benches", pair[1]),
            "--test" => there("tests", pair[1]),
            "python3" => pair[1].starts_with('-') || root.join(pair[1]).is_file(),
            _ => true,
        };
        if !is_there {
            return Err(format!("`{command}`: there is no {}", pair[1]));
        }
    }
    let known =
        ["cargo", "python3", "rustup", "pip", "time", "mkdir", "--report", "SHTAERMAN_CCX=ccx"];
    if known.contains(&words[0]) || root.join(words[0]).is_file() {
        Ok(())
    } else {
        Err(format!("what is `{command}`? mark the block"))
    }
}

/// Every line of an excerpt is in the file, or in one of the folder.
fn excerpt(path: &str, text: &str) -> Result<(), String> {
    let place = repository().join(path);
    let files: Vec<PathBuf> = if place.is_dir() {
        fs::read_dir(&place).unwrap().map(|entry| entry.unwrap().path()).collect()
    } else {
        vec![place]
    };
    let read =
        |file: &PathBuf| fs::read_to_string(file).map_err(|error| format!("{path}: {error}"));
    let whole = words(&files.iter().map(read).collect::<Result<Vec<_>, _>>()?.join("\n"));
    let lines = text
        .lines()
        .map(|line| words(line.split("  //").next().unwrap()))
        .filter(|line| !line.is_empty() && !line.starts_with(['#', '/']));
    for line in lines {
        if !whole.contains(&line) {
            return Err(format!("{path} has no `{line}`"));
        }
    }
    Ok(())
}

fn run(folder: &Folder, block: &Block, printed: &mut String) -> Result<(), String> {
    if let Some(reason) = block.mark.strip_prefix("not run:") {
        return if reason.trim().len() > 5 { Ok(()) } else { Err("no reason".to_owned()) };
    }
    if let Some(path) = block.mark.strip_prefix("excerpt of ") {
        return excerpt(path, &block.text);
    }
    let elsewhere = ELSEWHERE
        .iter()
        .find(|(chapter, language, _)| *chapter == block.chapter && *language == block.language);
    if let Some((chapter, _, test)) = elsewhere {
        let test = fs::read_to_string(repository().join(test)).unwrap();
        return if test.contains(&format!("docs/src/{chapter}.md")) {
            Ok(())
        } else {
            Err("its test is gone".to_owned())
        };
    }
    match block.language.as_str() {
        "sh" => shell(folder, &block.text).map(|said| *printed = words(&said)),
        "console" => console(folder, &block.text),
        "toml" => problem(folder, &block.text),
        "text" if !printed.is_empty() => {
            let mut lines = block.text.lines().map(words).filter(|line| !line.is_empty());
            let missing = lines.find(|line| !prints(printed, line));
            missing.map_or(Ok(()), |line| Err(format!("not printed: `{line}`, but\n{printed}")))
        }
        INDENTED => commands(folder, &block.text),
        other => Err(format!("a block of `{other}` that nothing runs: mark it")),
    }
}

/// Every picture of a chapter was drawn by a command of it, as it is in the book. `RENEW_FIGURES=1` puts what was drawn into the book.
fn figures(folder: &Folder, path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).unwrap();
    let mut wrong = Vec::new();
    for part in text.split("](figures/").skip(1) {
        let name = format!("docs/src/figures/{}", part.split(')').next().unwrap());
        let in_book = repository().join(&name);
        let Ok(drawn) = fs::read_to_string(folder.path(&name)) else {
            wrong.push(format!("{}: no command draws {name}", path.display()));
            continue;
        };
        if std::env::var_os("RENEW_FIGURES").is_some() {
            fs::write(&in_book, &drawn).unwrap();
        }
        if let Some(why) = difference(&drawn, &fs::read_to_string(&in_book).unwrap_or_default()) {
            wrong.push(format!("{name} is stale: {why}; RENEW_FIGURES=1 renews it"));
        }
    }
    wrong
}

/// Where two pictures differ: in their words, or in a number by more than a tenth of a pixel. Errors at the level of rounding are left out, which differ between processors.
fn difference(drawn: &str, shown: &str) -> Option<String> {
    let is_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let without_errors = |svg: &str| -> Vec<String> {
        let lines = svg.split('<').filter(|part| !part.contains("error of"));
        let spaced = lines.map(|part| part.replace([',', '>', '"', '=', '(', ')'], " "));
        spaced.flat_map(|part| part.split(' ').map(str::to_owned).collect::<Vec<_>>()).collect()
    };
    let parts = |word: &str| -> (String, Vec<f64>) {
        let numbers = word.split(|c| !is_number(c)).filter_map(|number| number.parse().ok());
        (word.chars().filter(|c| !is_number(*c)).collect(), numbers.collect())
    };
    let (drawn, shown) = (without_errors(drawn), without_errors(shown));
    if drawn.len() != shown.len() {
        return Some(format!("{} words instead of {}", drawn.len(), shown.len()));
    }
    drawn.iter().zip(&shown).find_map(|(drawn, shown)| {
        let ((words, numbers), (known, others)) = (parts(drawn), parts(shown));
        let are_near = numbers.len() == others.len()
            && numbers.iter().zip(&others).all(|(a, b): (&f64, &f64)| (a - b).abs() <= 0.1);
        (words != known || !are_near).then(|| format!("`{drawn}` instead of `{shown}`"))
    })
}

/// A folder with the examples, and with the places that commands of the repository write to.
fn place() -> Folder {
    let folder = super::examples::copy();
    for path in ["docs/src/figures", "man"] {
        fs::create_dir_all(folder.path(path)).unwrap();
    }
    folder
}

fn check(chapters: &[PathBuf], place: fn() -> Folder) {
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in chapters {
        let (folder, mut printed) = (place(), String::new());
        for block in blocks(path) {
            count += 1;
            if let Err(why) = run(&folder, &block, &mut printed) {
                wrong.push(format!("{}: {why}", block.place));
            }
            // What a newcomer does step by step is nothing that an engineer would doubt; an error above the aim is no such doubt.
            let is_doubted = printed
                .split("warning: ")
                .skip(1)
                .any(|said| !said.starts_with("the relative error reached is"));
            if is_tutorial(path) && block.language == "sh" && is_doubted {
                wrong.push(format!("{}: a tutorial warns: {printed}", block.place));
            }
            if block.language != "sh" && block.language != "text" {
                printed.clear();
            }
        }
        wrong.extend(figures(&folder, path));
    }
    assert!(wrong.is_empty(), "{} of {count} blocks:\n{}", wrong.len(), wrong.join("\n"));
    assert!(count >= 5 * chapters.len().min(3), "{count}");
}

fn is_tutorial(path: &Path) -> bool {
    path.file_name().unwrap().to_str().unwrap().starts_with("tutorial-")
}

#[test]
fn every_block_of_the_book_runs_or_says_why_not() {
    let chapters: Vec<PathBuf> = chapters().into_iter().filter(|path| !is_tutorial(path)).collect();
    assert!(chapters.len() > 35);
    check(&chapters, place);
}

#[test]
fn the_tutorials_lead_from_an_empty_folder_to_a_report() {
    let chapters: Vec<PathBuf> = chapters().into_iter().filter(|path| is_tutorial(path)).collect();
    assert_eq!(chapters.len(), 3);
    check(&chapters, Folder::new);
    for path in chapters {
        let blocks = blocks(&path);
        assert!(blocks.iter().all(|block| block.mark.is_empty()), "{path:?}");
        assert!(
            blocks.iter().any(|block| block.language == "sh" && block.text.contains("--report ")),
            "{path:?}"
        );
    }
}
