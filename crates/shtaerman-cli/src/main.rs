//! The `shtaerman` command.

fn main() -> std::process::ExitCode {
    shtaerman_cli::run()
}
