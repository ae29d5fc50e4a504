//! Nothing that is asked hangs the page.

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::io::{BufReader, Write};
use std::process::Command;
use std::thread::{scope, sleep};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::explore::client::{PROGRAM, PUNCH, Page, Response, finish};

fn solve(page: &Page) -> Value {
    page.ask("solve", &json!({ "name": "x.toml", "toml": PUNCH }))
}

#[test]
fn a_question_that_is_too_large_or_too_slow_is_refused() {
    let page = Page::open(&[]);
    let port = page.port;
    let head = |length: usize| {
        format!(
            "POST /api/solve HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\nContent-Type: application/json\r\nContent-Length: {length}\r\n\r\n"
        )
    };
    let large = 17 << 20;
    let mut stream = page.connect();
    stream.write_all(head(large).as_bytes()).unwrap();
    let told = Response::read(&mut BufReader::new(stream)).unwrap();
    assert_eq!(told.status, 413);
    assert!(told.body.contains("16777216 bytes"), "{}", told.body);
    // One that breaks off, and one that never comes: others are answered meanwhile.
    let mut broken = page.connect();
    broken.write_all(format!("{}{{", head(100)).as_bytes()).unwrap();
    let mut silent = page.connect();
    silent.write_all(b"GET / HT").unwrap();
    let mut endless = page.connect();
    endless.write_all(b"GET / HTTP/1.1\r\nX: ").unwrap();
    finish(&broken);
    assert!(solve(&page)["answer"].is_object());
    assert!(Response::read(&mut BufReader::new(broken)).is_none_or(|told| told.status == 400));
    // A head without end is not kept.
    let junk = vec![b'x'; 1 << 20];
    let _ = endless.write_all(&junk);
    let told = Response::read(&mut BufReader::new(endless));
    assert!(told.is_none_or(|told| told.status == 431), "a head of a megabyte");
    let since = Instant::now();
    let told = Response::read(&mut BufReader::new(silent));
    assert!(told.is_none_or(|told| told.status == 408));
    assert!(since.elapsed() < Duration::from_secs(20), "{:?}", since.elapsed());
}

#[test]
fn what_is_no_question_is_told_so() {
    let page = Page::open(&[]);
    for (operation, body) in [
        ("solve", ""),
        ("solve", "{"),
        ("solve", "[]"),
        ("solve", "null"),
        ("solve", "{\"toml\": 7}"),
        ("solve", "\u{0}"),
        ("map", "{}"),
        ("map", "{\"component\": \"von-mises\", \"points\": [1e99, -3]}"),
        ("kernel", "{\"name\": \"power\", \"parameters\": {}, \"count\": 3, \"drawn\": 2}"),
        ("curve", "{\"lambda0\": -1}"),
        ("curve", "{\"lambda0\": 1e300}"),
        ("study", "{\"from\": 0, \"count\": 9}"),
        ("equation", "{\"toml\": \"[equation]\"}"),
        ("nothing", "{}"),
        ("../solve", "{}"),
    ] {
        let told = page.raw(&page.question(operation, body));
        assert_eq!(told.status, 200, "{operation} {body}");
        let told: Value = serde_json::from_str(&told.body).unwrap();
        assert!(told["fault"]["message"].is_string(), "{operation} {body}: {told}");
    }
    let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    let told = page.raw(&page.question("solve", &deep));
    assert_eq!(told.status, 200, "{}", told.body);
    assert!(solve(&page)["answer"].is_object());
}

/// A trace of many points, waves of random phase, whose contact takes many seconds.
fn endless() -> Value {
    const WAVES: usize = 200;
    let mut state = 20_261_123u64;
    let phases: [f64; WAVES] = std::array::from_fn(|_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        TAU * (state >> 33) as f64 / f64::from(u32::MAX)
    });
    let mut text = "x,f\n".to_owned();
    let points = 100_000;
    for i in 0..points {
        let t = 2.0 * f64::from(i) / f64::from(points - 1) - 1.0;
        let wave = |(k, phase): (usize, &f64)| {
            let k = (k + 1) as f64;
            (PI * k * t + phase).cos() / k.sqrt()
        };
        let height: f64 = phases.iter().enumerate().map(wave).sum();
        let _ = writeln!(text, "{:e},{:e}", 0.01 * t, 1e-6 * height);
    }
    let toml =
        PUNCH.replace("\"5 mm\"", "0.01").replace("\"x^2 / (2*20)\"", "{ csv = \"trace.csv\" }");
    json!({ "name": "x.toml", "toml": toml, "files": { "trace.csv": text } })
}

#[test]
fn a_hostile_profile_ends_in_time_and_others_are_answered_meanwhile() {
    let page = Page::open(&["--time-limit", "1 s"]);
    let hostile = endless();
    let since = Instant::now();
    let question = page.question("solve", &hostile.to_string());
    scope(|threads| {
        let asked = threads.spawn(|| page.raw(&question));
        sleep(Duration::from_millis(200));
        let other = Instant::now();
        assert!(solve(&page)["answer"].is_object());
        assert!(other.elapsed() < Duration::from_secs(5), "{:?}", other.elapsed());
        let told = asked.join().unwrap();
        // The best so far with its warning, or that there is none; on a busy machine its process is ended before it comes to that.
        if told.status == 504 {
            assert!(told.body.contains("took longer than 2 s"), "{}", told.body);
            return;
        }
        let told: Value = serde_json::from_str(&told.body).unwrap();
        let is_best = told["unfinished"] == true;
        let said = told["fault"]["message"].as_str();
        // Or it was refused before that: no zones were found.
        let is_refused = told["fault"]["exit_code"] == 3;
        assert!(is_best || is_refused && said.is_some(), "{told}");
    });
    assert!(since.elapsed() < Duration::from_secs(20), "{:?}", since.elapsed());
}

/// Hostile profiles fill the places of what takes long, and no others; each is told something in the end.
#[test]
fn six_hostile_profiles_do_not_keep_a_plain_solve_waiting() {
    let page = Page::open(&["--time-limit", "4 s"]);
    let question = page.question("solve", &endless().to_string());
    scope(|threads| {
        let asked: Vec<_> = (0..6).map(|_| threads.spawn(|| page.raw(&question))).collect();
        // While they begin, and while they compute.
        for pause in [300, 3000] {
            sleep(Duration::from_millis(pause));
            let other = Instant::now();
            assert!(solve(&page)["answer"].is_object());
            assert!(other.elapsed() < Duration::from_secs(3), "{:?}", other.elapsed());
        }
        for asked in asked {
            let told = asked.join().unwrap();
            assert!([200, 504].contains(&told.status), "{}", told.body);
        }
    });
}

/// What has no limit of its own is ended with its process, and the next question finds another.
#[test]
fn a_process_that_takes_too_long_is_ended_and_replaced() {
    let page = Page::open(&["--time-limit", "0.1 s"]);
    // The map of a wavy contact that is solved at once: 160,000 stresses, which no limit of a solve holds.
    let wavy = PUNCH.replace("x^2 / (2*20)", "1e-6*cos(30*pi*xi)").replace("0.8 MN/m", "50 kN/m");
    assert_ne!(wavy, PUNCH);
    let map = json!({ "name": "x.toml", "toml": wavy, "component": "von-mises", "points": [400, 400], "peaks": true });
    for _ in 0..2 {
        let told = page.raw(&page.question("map", &map.to_string()));
        assert_eq!(told.status, 504, "{}", told.body);
        assert!(told.body.contains("took longer than 0.2 s"), "{}", told.body);
    }
    assert!(solve(&page)["answer"].is_object());
}

#[test]
fn a_port_that_is_taken_is_told_and_another_is_taken_where_none_was_asked_for() {
    let page = Page::open(&[]);
    let run = |arguments: &[&str]| Command::new(PROGRAM).args(arguments).output().unwrap();
    let port = page.port.to_string();
    let told = run(&["explore", "--no-browser", "--port", &port]);
    let said = String::from_utf8(told.stderr).unwrap();
    assert_eq!(told.status.code(), Some(2));
    assert!(said.contains(&format!("127.0.0.1:{port}")) && said.contains("--port"), "{said}");
    let other = Page::open(&[]);
    assert_ne!(other.port, page.port);
    let told = run(&["explore", "--no-browser", "missing.toml"]);
    assert_eq!(told.status.code(), Some(2));
    assert!(String::from_utf8(told.stderr).unwrap().contains("missing.toml"));
    for limit in ["0 s", "soon", "5 mm", "1 d", "-1 s"] {
        let told = run(&["explore", "--no-browser", &format!("--time-limit={limit}")]);
        assert_eq!(told.status.code(), Some(2), "{limit}");
    }
}

/// The processes whose parent is this one.
#[cfg(target_os = "linux")]
fn children(of: u32) -> Vec<u32> {
    let entries = std::fs::read_dir("/proc").unwrap().flatten();
    let numbers = entries.filter_map(|entry| entry.file_name().to_str()?.parse::<u32>().ok());
    let parent = |process: &u32| {
        let text = std::fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
        // Behind the name in parentheses: the state, then the parent.
        text.rsplit_once(')')?.1.split_whitespace().nth(1)?.parse::<u32>().ok()
    };
    numbers.filter(|process| parent(process) == Some(of)).collect()
}

/// However the server ends, the processes that compute for it end with it, in the middle of a computation, too.
#[cfg(target_os = "linux")]
#[test]
fn nothing_computes_on_when_the_page_is_closed() {
    let mut page = Page::open(&["--time-limit", "10 min"]);
    let mut stream = page.connect();
    let question = page.question("solve", &endless().to_string());
    stream.write_all(question.as_bytes()).unwrap();
    let since = Instant::now();
    let workers = loop {
        let workers = children(page.process.id());
        if !workers.is_empty() || since.elapsed() > Duration::from_secs(20) {
            break workers;
        }
        sleep(Duration::from_millis(20));
    };
    assert!(!workers.is_empty());
    sleep(Duration::from_millis(300));
    page.process.kill().unwrap();
    page.process.wait().unwrap();
    let is_there = |process: &u32| std::path::Path::new(&format!("/proc/{process}")).exists();
    let since = Instant::now();
    while workers.iter().any(is_there) && since.elapsed() < Duration::from_secs(20) {
        sleep(Duration::from_millis(20));
    }
    assert!(!workers.iter().any(is_there), "{workers:?} compute on");
}

/// Who closes the page, or moves on, does not leave a computation behind.
#[cfg(target_os = "linux")]
#[test]
fn a_question_that_nobody_waits_for_is_ended() {
    let page = Page::open(&["--time-limit", "10 min"]);
    let mut stream = page.connect();
    let question = page.question("solve", &endless().to_string());
    stream.write_all(question.as_bytes()).unwrap();
    sleep(Duration::from_millis(500));
    let before = children(page.process.id());
    assert!(!before.is_empty());
    drop(stream);
    let since = Instant::now();
    while children(page.process.id()).iter().any(|one| before.contains(one)) {
        assert!(since.elapsed() < Duration::from_secs(20), "{before:?} compute on");
        sleep(Duration::from_millis(20));
    }
    assert!(solve(&page)["answer"].is_object());
}
