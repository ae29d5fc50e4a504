//! Potentials and solutions against closed forms.

mod potentials;
