//! The page on a port of this machine.

use std::io::{Write, stdin, stdout};
use std::path::Path;
use std::time::Duration;

use shtaerman::Error;
use shtaerman::document::{FileError, load_bytes};
use shtaerman::quantity::Dimension;
use shtaerman_explore::{Limits, Server, bind, show};

use super::{PageEngine, start};
use crate::Failure;
use crate::arguments::ExploreArguments;
use crate::commands::places;
use crate::failure::{shown, warn};

/// The shortest and the longest limit of a solve.
const LEAST: Duration = Duration::from_millis(100);
const MOST: Duration = Duration::from_secs(3600);
/// The option by which the program is its own worker.
const WORKER: &str = "--worker";

pub(in crate::commands) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let limit = limit(&arguments.time_limit)?;
    if arguments.worker {
        return shtaerman_explore::work(stdin(), stdout().lock(), &mut PageEngine::new(limit))
            .map_err(|error| Failure::unwritten(Path::new("standard output"), &error));
    }
    let start = match &arguments.file {
        Some(path) => start::with_file(path, &read(path)?, limit),
        None => start::without_file(limit),
    };
    let listener = bind(arguments.port).map_err(|error| unserved(arguments.port, &error))?;
    let port = listener.local_addr().map_err(|error| unserved(arguments.port, &error))?.port();
    let program = std::env::current_exe().map_err(|error| {
        Failure::Usage(format!("the program does not know where it is itself: {error}"))
    })?;
    let seconds = format!("{:e} s", limit.as_secs_f64());
    let own = ["explore", WORKER, "--time-limit", &seconds].map(str::to_owned).to_vec();
    // A map solves twice, and an audit has no limit of its own.
    let limits = Limits { computation: 2 * limit, ..Limits::default() };
    let server = Server::new(port, start.to_string(), program, own, limits);
    let address = format!("http://127.0.0.1:{port}/");
    tell(&format!("{address}  (Ctrl-C ends it)\n"))?;
    if !arguments.no_browser
        && let Err(error) = show(&address)
    {
        warn(&format!("no browser could be opened ({error}): open {address} yourself"));
    }
    match server.run(listener) {
        Ok(never) => match never {},
        Err(error) => Err(unserved(Some(port), &error)),
    }
}

fn limit(text: &str) -> Result<Duration, Failure> {
    let seconds = places::quantity("--time-limit", text, Dimension::TIME)?;
    let limit =
        Duration::try_from_secs_f64(seconds).ok().filter(|limit| (LEAST..=MOST).contains(limit));
    limit.ok_or_else(|| {
        Failure::Usage(format!("--time-limit `{text}`: must be from 0.1 s to 1 h, like \"10 s\""))
    })
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    load_bytes(path)
        .map_err(|message| Error::from(FileError::new(message).in_file(Some(&shown(path)))).into())
}

fn unserved(port: Option<u16>, error: &std::io::Error) -> Failure {
    let place = port.map_or_else(|| "127.0.0.1".to_owned(), |port| format!("127.0.0.1:{port}"));
    let advice = if port.is_some() { ": choose another --port, or leave it out" } else { "" };
    Failure::Usage(format!("the page cannot be served on {place}: {error}{advice}"))
}

/// Where the page is, at once: whoever started this process may wait for it.
fn tell(text: &str) -> Result<(), Failure> {
    let mut out = stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|error| Failure::unwritten(Path::new("standard output"), &error))
}
