//! Dispersion: the index of refraction of a glass depends on the wavelength, so a prism turns each colour by a different angle.
//!
//! ```
//! use raybook::material::dispersion::Sellmeier;
//!
//! let [blue, red] = [450.0, 650.0].map(|wavelength| Sellmeier::SF11.index(wavelength));
//! assert!(blue > red + 0.04);
//! ```

/// Wavelengths of three spectral lines, in nanometres: F, blue (hydrogen); d, yellow (helium); C, red (hydrogen).
const LINE_F: f32 = 486.133;
const LINE_D: f32 = 587.562;
const LINE_C: f32 = 656.273;

// ANCHOR: sellmeier
/// The index of refraction of a glass by Sellmeier's equation, n²(λ) = 1 + Σ Bᵢ λ²/(λ² − Cᵢ), with λ in micrometres
/// (Sellmeier, "Zur Erklärung der abnormen Farbenfolge im Spectrum einiger Substanzen", 1871).
///
/// Each term is a resonance of the glass at the wavelength √Cᵢ: two in the ultraviolet, one in the infrared. Visible light is
/// between them, where n falls as λ grows. The constants are from the data sheets of the manufacturer, Schott.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sellmeier {
    /// B: the strengths of the resonances, without a unit.
    pub b: [f32; 3],
    /// C: the squares of the resonances' wavelengths, in µm².
    pub c: [f32; 3],
}

impl Sellmeier {
    /// N-BK7, a crown glass: windows and simple lenses.
    pub const BK7: Self = Self {
        b: [1.039_612, 0.231_792_34, 1.010_469_5],
        c: [0.006_000_699, 0.020_017_914, 103.560_65],
    };
    /// N-SF11, a dense flint glass: for the same deviation it spreads the colours more than twice as much as N-BK7.
    pub const SF11: Self = Self {
        b: [1.737_597, 0.313_747_35, 1.898_781],
        c: [0.013_188_707, 0.062_306_82, 155.236_3],
    };

    /// The index of refraction for light of a wavelength in vacuum, in nanometres.
    pub fn index(&self, nanometres: f32) -> f32 {
        let square = (0.001 * nanometres).powi(2);
        let term = |(b, c)| b * square / (square - c);
        let terms: f32 = self.b.into_iter().zip(self.c).map(term).sum();
        (1.0 + terms).sqrt()
    }

    /// The Abbe number V = (n_d − 1)/(n_F − n_C): refraction over dispersion. A large V is good for lenses.
    pub fn abbe(&self) -> f32 {
        (self.index(LINE_D) - 1.0) / (self.index(LINE_F) - self.index(LINE_C))
    }
}
// ANCHOR_END: sellmeier
