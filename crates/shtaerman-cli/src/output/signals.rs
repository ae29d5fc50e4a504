//! Signals end a run without anything left behind.

#[cfg(any(unix, windows))]
use super::pending::interrupt;

/// Exit code of an interrupted run.
#[cfg(any(unix, windows))]
const INTERRUPTED: i32 = 130;

/// From here on a signal that asks for an end is answered by [`interrupt`]. Without a handler the run still ends, only without our exit code, and
/// with a temporary file left.
#[cfg(unix)]
pub(crate) fn watch_signals() {
    use signal_hook::consts::{
        SIGALRM, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
        SIGXFSZ,
    };
    use signal_hook::{flag, iterator::Signals};

    /// All by which a system or a user ends a process that can prevent it; what tells of a fault of the process itself is left as it is.
    const ENDS: [i32; 10] =
        [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2];
    // A file that grows beyond the limit of the process is then an error of writing, which is reported.
    let _ = flag::register(SIGXFSZ, std::sync::Arc::default());
    let ignored = ignored();
    let watched = ENDS.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
    let Ok(mut signals) = Signals::new(watched) else { return };
    let answer = move || {
        if let Some(signal) = signals.forever().next() {
            if signal == SIGXCPU {
                crate::failure::say(
                    "error",
                    "the processor time that this process may take is used up",
                );
            }
            interrupt(INTERRUPTED);
        }
    };
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(answer);
}

#[cfg(windows)]
pub(crate) fn watch_signals() {
    let _ = ctrlc::set_handler(|| interrupt(INTERRUPTED));
}

/// Where there are none.
#[cfg(not(any(unix, windows)))]
pub(crate) fn watch_signals() {}

/// The signals that whoever started this process told it to ignore, bit by bit: `nohup` does so, and a shell for what runs in the background. Where the system
/// does not say, none.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
}
