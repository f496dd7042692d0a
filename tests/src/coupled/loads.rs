//! What masses do: the coefficients of Ω² C − λ M on (w, w′, v, v′, φ), for a stretch and for a point.

use super::series::Series;

/// What a blade and its motion have everywhere alike.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    /// Ω² [rad²/s²].
    pub pull: f64,
    /// Sine and cosine of the precone.
    pub precone: (f64, f64),
    /// Torque offset e0 [m].
    pub torque_offset: f64,
    pub rotary: bool,
}

/// A mass, or a mass per length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inertia {
    pub r: Series,
    pub mass: Series,
    /// e.
    pub offset: Series,
    /// About the elastic axis.
    pub moments: [Series; 2],
    /// β.
    pub angle: Series,
}

/// A coefficient of the symmetric form: row ≤ column, its parts Ω² C and M.
pub(super) type Load = (usize, usize, Series, Series);

impl Inertia {
    /// Everything but the tension.
    pub fn loads(&self, motion: &Motion) -> Vec<Load> {
        let none = Series::constant(0.0);
        let ((sp, cp), pull) = (motion.precone, motion.pull);
        let [s, c] = Series::sin_cos(&self.angle);
        let [s2, c2] = Series::sin_cos(&self.angle.times(2.0));
        let m = self.mass;
        let [first, second] = self.moments;
        let difference = second - first;
        let (mec, mes) = (m * self.offset * c, m * self.offset * s);
        let mut loads = vec![
            (0, 0, m.times(-pull * sp * sp), m),
            (0, 1, mes.times(-pull * sp * cp), none),
            (0, 3, mec.times(-pull * sp * cp), none),
            (0, 4, mec.times(-pull * sp * sp), mec),
            (1, 4, (self.r * mec).times(pull * cp * cp) - (difference * s2).times(pull * sp * cp), none),
            (2, 2, m.times(-pull), m),
            (2, 4, mes.times(pull), mes.times(-1.0)),
            (3, 4, (self.r * mes).times(-pull * cp * cp) - (difference * c2).times(pull * sp * cp), none),
            (
                4,
                4,
                (difference * c2).times(pull * cp * cp) + mec.times(pull * motion.torque_offset)
                    - (self.r * mes).times(pull * sp * cp),
                first + second,
            ),
        ];
        if motion.rotary {
            let flapwise = second * s * s + first * c * c;
            loads.extend([
                (1, 1, flapwise.times(-pull * cp * cp), flapwise),
                (1, 3, none, difference * s * c),
                (3, 3, none, second * c * c + first * s * s),
            ]);
        }
        loads
    }
}
