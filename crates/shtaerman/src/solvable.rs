//! What is refused before anything is solved.

use crate::contact::require_even;
use crate::error::require;
use crate::{Error, Problem};

impl Problem {
    /// Refuses what [`Problem::solve`] refuses whatever the contact would be: a circular base that is no body of revolution, a tilt or a moment of a base that fills its period, or of a disk whose rough
    /// layer has a power law. Whether the punch touches anywhere, and whether a method finds its contact, only a solution tells.
    ///
    /// ```
    /// use shtaerman::file;
    ///
    /// let wave = |tilt: f64| {
    ///     let text = format!("[dimensionless]\ntheta0 = 2\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"cos(pi*xi)\"\nforce = 1\ntilt = {tilt}\n");
    ///     file::parse(&text, "wave.toml")
    /// };
    /// assert!(wave(0.0)?.check().is_ok());
    /// assert!(wave(0.1)?.check().is_err());
    /// # Ok::<(), shtaerman::file::FileError>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for these, and [`Error::TipsOver`] and the like for a load that no pressure balances.
    pub fn check(&self) -> Result<(), Error> {
        if self.is_circular() {
            require_even(self)?;
            return self.require_one_harmonic();
        }
        if self.is_wave() {
            self.require_no_turn()?;
        }
        self.check_balance()
    }

    /// Refuses a tilt and a moment of a base that fills its period.
    pub(crate) fn require_no_turn(&self) -> Result<(), Error> {
        let (field, value) = self.load().rotational().named();
        let requirement = "zero where the base fills the period: a wave cannot tilt, and a moment does not repeat";
        require(value == 0.0, field, value, requirement).map(|_| ())
    }

    /// Refuses a tilt and a moment of a disk whose pressure would have more than the harmonics 0 and 1 of the angle.
    pub(crate) fn require_one_harmonic(&self) -> Result<(), Error> {
        let exponent = self.bodies().law().exponent();
        let is_mixed = exponent.is_some_and(|exponent| exponent != 1.0);
        let (field, value) = self.load().rotational().named();
        let requirement = "zero for a circular punch on a layer with a power law, which mixes the harmonics of the pressure";
        require(!is_mixed || value == 0.0, field, value, requirement).map(|_| ())
    }
}
