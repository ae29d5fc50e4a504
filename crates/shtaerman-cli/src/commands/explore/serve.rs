//! The page on a port of this machine.

use std::io::{Write, stdin, stdout};
use std::path::Path;

use shtaerman::Error;
use shtaerman::document::{FileError, load_bytes};
use shtaerman_explore::{Limits, Server, bind, show};

use super::{PageEngine, start};
use crate::Failure;
use crate::arguments::ExploreArguments;
use crate::failure::{shown, warn};

/// The option by which the program is its own worker.
const WORKER: &str = "--worker";

pub(in crate::commands) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    if arguments.worker {
        return shtaerman_explore::work(stdin(), stdout().lock(), &mut PageEngine::default())
            .map_err(|error| Failure::unwritten(Path::new("standard output"), &error));
    }
    let start = match &arguments.file {
        Some(path) => start::with_file(path, &read(path)?),
        None => start::without_file(),
    };
    let listener = bind(arguments.port).map_err(|error| unserved(arguments.port, &error))?;
    let port = listener.local_addr().map_err(|error| unserved(arguments.port, &error))?.port();
    let program = std::env::current_exe().map_err(|error| {
        Failure::Usage(format!("the program does not know where it is itself: {error}"))
    })?;
    let own = ["explore", WORKER].map(str::to_owned).to_vec();
    let server = Server::new(port, start.to_string(), program, own, Limits::default());
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
