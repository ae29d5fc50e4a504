//! The time that a command takes: a line of progress on a terminal, and the end of what may not take longer.

use std::io::{IsTerminal, Write, stderr};
use std::sync::mpsc::channel;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::{self, Builder};
use std::time::{Duration, Instant};

use crate::Failure;
use crate::failure::is_quiet;

/// Commands that take less than this show no progress, and how often the line is written anew.
const FIRST: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(200);
/// Stack of a thread that does what the main one would, in bytes.
const STACK: usize = 8 << 20;
/// Share of the time limit after which the best so far is shown without what is still computed: the rest is for writing it.
const LAST: f64 = 0.95;

static CLOCK: Mutex<Clock> = Mutex::new(Clock { running: None, is_shown: false, after: None });

/// What is said where the time is over before there is an answer.
pub(crate) type Early = fn(Duration) -> Failure;

struct Clock {
    running: Option<Running>,
    /// Whether there is a line of progress on the terminal.
    is_shown: bool,
    /// What is done with an answer that was found.
    after: Option<&'static str>,
}

#[derive(Clone, Copy)]
struct Running {
    since: Instant,
    limit: Option<Duration>,
}

fn clock() -> MutexGuard<'static, Clock> {
    CLOCK.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Clock {
    /// Takes the line of progress away.
    fn clear(&mut self) {
        if std::mem::take(&mut self.is_shown) {
            // Where standard error is closed, there is no line.
            let _ = stderr().write_all(b"\r\x1b[K");
        }
    }

    fn show(&mut self, elapsed: Duration) {
        let line = format!("\r\x1b[Kcomputing: {} s", elapsed.as_secs());
        let _ = stderr().write_all(line.as_bytes());
        self.is_shown = true;
    }
}

/// Starts the clock of a command. At the limit `end` ends the process with the exit code of [`Error::TimeLimit`](shtaerman::Error::TimeLimit), unless the clock was [stopped](stop) before.
pub(crate) fn start(limit: Option<Duration>, early: Early, end: fn(i32) -> !) {
    let is_seen = stderr().is_terminal() && !is_quiet();
    if limit.is_none() && !is_seen {
        return;
    }
    let running = Running { since: Instant::now(), limit };
    clock().running = Some(running);
    // Without a thread nobody is shown anything; the search itself still ends in time.
    let _ =
        Builder::new().name("clock".to_owned()).spawn(move || watch(running, is_seen, early, end));
}

fn watch(Running { since, limit }: Running, is_seen: bool, early: Early, end: fn(i32) -> !) {
    loop {
        let left = limit.map_or(TICK, |limit| limit.saturating_sub(since.elapsed()));
        thread::sleep(left.min(TICK));
        let mut clock = clock();
        if clock.running.is_none() {
            return;
        }
        let elapsed = since.elapsed();
        if let Some(limit) = limit.filter(|limit| elapsed >= *limit) {
            clock.clear();
            let failure = match clock.after {
                Some(what) => Failure::Late { what, limit },
                None => early(limit),
            };
            failure.report();
            end(i32::from(failure.exit_code()));
        }
        if is_seen && elapsed >= FIRST {
            clock.show(elapsed);
        }
    }
}

/// Says what comes after an answer that was found: at the limit this is what took too long.
pub(crate) fn answered(next: &'static str) {
    clock().after = Some(next);
}

/// Stops the clock: from here on something is written, which is not cut short.
pub(crate) fn stop() {
    let mut clock = clock();
    clock.running = None;
    clock.clear();
}

/// What comes of `work`; none where that takes longer than there is time.
pub(crate) fn in_time<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Option<T> {
    let running = clock().running.and_then(|running| Some((running.since, running.limit?)));
    let Some((since, limit)) = running else { return Some(work()) };
    let left = limit.mul_f64(LAST).saturating_sub(since.elapsed());
    let (sender, receiver) = channel();
    let worker = Builder::new().stack_size(STACK).spawn(move || {
        // Nobody waits for it any more when its time is over.
        let _ = sender.send(work());
    });
    worker.ok()?;
    receiver.recv_timeout(left).ok()
}
