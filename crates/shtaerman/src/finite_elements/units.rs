//! Units of finite-element models, which their programs do not know.

/// A system of units in which the numbers of a model belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// Newtons, metres, pascals.
    Si,
    /// Newtons, millimetres, megapascals.
    Millimetres,
}

impl Units {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Si, Self::Millimetres];

    /// Unit of force, length and pressure, as the comment of an exported file states them.
    #[must_use]
    pub fn names(self) -> [&'static str; 3] {
        match self {
            Self::Si => ["N", "m", "Pa"],
            Self::Millimetres => ["N", "mm", "MPa"],
        }
    }

    /// The unit of length in metres.
    #[must_use]
    pub fn length(self) -> f64 {
        match self {
            Self::Si => 1.0,
            Self::Millimetres => 1e-3,
        }
    }

    /// The unit of pressure in pascals.
    #[must_use]
    pub fn pressure(self) -> f64 {
        match self {
            Self::Si => 1.0,
            Self::Millimetres => 1e6,
        }
    }

    /// The comment by which an input file tells its units.
    ///
    /// ```
    /// use shtaerman::finite_elements::Units;
    ///
    /// assert_eq!(Units::Millimetres.comment(), "** Units: N, mm, MPa");
    /// ```
    #[must_use]
    pub fn comment(self) -> String {
        format!("** Units: {}", self.names().join(", "))
    }
}
