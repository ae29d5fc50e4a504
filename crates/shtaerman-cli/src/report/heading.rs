//! What stands above a picture.

/// The name of a file as words.
pub(crate) fn heading(name: &str) -> Option<String> {
    let words = name.replace('_', " ");
    let mut letters = words.trim().chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect())
}
