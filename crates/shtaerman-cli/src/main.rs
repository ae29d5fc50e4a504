//! Command line of Shtaerman.

fn main() -> std::process::ExitCode {
    shtaerman_cli::run()
}
