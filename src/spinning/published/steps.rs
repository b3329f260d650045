//! The interpolation in integers, with the 16-bit products as they were, or wide enough.

use super::parameters::{ConeParameters, ParabolaParameters};
use super::tables::{PARABOLA_CONSTANT_MM, form_length_pulses, parabola_ratio, tangent_ratio};
use super::{MM_PER_PULSE, MM_PER_STEP};

/// How products are calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Arithmetic {
    /// Unsigned 16 bits, as the 8085's PL/M: products beyond 65535 wrap, and the parabola's table ends at its 72nd point.
    AsPublished,
    /// The same rounding with integers that hold every product.
    #[default]
    Exact,
}

/// A point of the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PublishedPoint {
    /// Carriage travel from the tip, pulses.
    pub pulses: u32,
    /// Roller travel away from the axis, steps.
    pub steps: u32,
    /// Absolute reading to retract to: start of the roller less steps.
    pub target: i32,
    /// A product went beyond 16 bits and wrapped.
    pub wrapped: bool,
}

/// `numerator / denominator`, halves up, by quotient and remainder as the controller divides.
fn divided(numerator: u32, denominator: u32) -> u32 {
    let quotient = numerator / denominator;
    quotient + u32::from(2 * (numerator % denominator) >= denominator)
}

/// The points of a cone: `pulses · num / den` in pulses, then `· 32 / 63` in steps, each rounded. The last lies beyond the
/// form length by up to an increment.
#[must_use]
pub fn cone_points(cone: &ConeParameters, arithmetic: Arithmetic) -> Vec<PublishedPoint> {
    // The parameters' own range is the table's.
    let Some((num, den)) = tangent_ratio(cone.angle_deg()) else { return Vec::new() };
    let point = |pulses: u32| {
        let wide = pulses * u32::from(num);
        let wrapped = wide > u32::from(u16::MAX);
        let product = if arithmetic == Arithmetic::AsPublished { wide & 0xFFFF } else { wide };
        let steps = divided(divided(product, u32::from(den)) * 32, 63);
        PublishedPoint { pulses, steps, target: below(cone.roller_position(), steps), wrapped }
    };
    travels(cone.form_length_mm(), cone.increment_pulses()).map(point).collect()
}

/// The points of the parabola: `num · 8 / den` from the table, rounded. The lost radius compensation of the listing is not
/// applied. Where a form of 74 mm runs past the table, the published program read what lay behind it, and so there is no
/// point; exactly, it follows from the equation.
#[must_use]
pub fn parabola_points(parabola: &ParabolaParameters, arithmetic: Arithmetic) -> Vec<PublishedPoint> {
    let start = parabola.roller_position();
    let of_travel = |(k, pulses): (usize, u32)| {
        let steps = match (parabola_ratio(k), arithmetic) {
            (Some((num, den)), _) => divided(u32::from(num) * 8, u32::from(den)),
            (None, Arithmetic::Exact) => equation_steps(pulses),
            (None, Arithmetic::AsPublished) => return None,
        };
        Some(PublishedPoint { pulses, steps, target: below(start, steps), wrapped: false })
    };
    let travels = travels(parabola.form_length_mm(), ParabolaParameters::INCREMENT_PULSES);
    (1..).zip(travels).filter_map(of_travel).collect()
}

/// Carriage travels of the points, pulses: increments are added as long as the last is not beyond the form length.
fn travels(form_length_mm: u32, increment: u32) -> impl Iterator<Item = u32> {
    let length = form_length_pulses(form_length_mm);
    (0..=length).step_by(usize::try_from(increment).unwrap_or(1).max(1)).map(move |before| before + increment)
}

fn equation_steps(pulses: u32) -> u32 {
    let travel = f64::from(pulses) * MM_PER_PULSE;
    let steps = (travel * travel / PARABOLA_CONSTANT_MM / MM_PER_STEP + 0.5).floor();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number below 1000")]
    {
        steps as u32
    }
}

fn below(start: i32, steps: u32) -> i32 {
    start.saturating_sub_unsigned(steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worked_example_comes_out() {
        // Mohamad 1988, Fig. 6.3: 50 mm, 16 pulses, 30°: 9.24 → 9 → 4.57 → 5.
        let cone = ConeParameters::new(50, 16, 30).unwrap();
        let points = cone_points(&cone, Arithmetic::AsPublished);
        assert_eq!(points[0], PublishedPoint { pulses: 16, steps: 5, target: 597, wrapped: false });
        // The last point lies beyond the 787 pulses.
        assert_eq!(points.last().unwrap().pulses, 800);
    }

    #[test]
    fn wide_integers_grow_where_sixteen_bits_wrap() {
        let cone = ConeParameters::new(74, 16, 32).unwrap();
        let exact = cone_points(&cone, Arithmetic::Exact);
        let published = cone_points(&cone, Arithmetic::AsPublished);
        assert!(exact.windows(2).all(|w| w[0].steps < w[1].steps));
        assert!(published.windows(2).any(|w| w[0].steps > w[1].steps));
        assert!(exact.iter().zip(&published).all(|(e, p)| (e.steps == p.steps) != e.wrapped));
    }

    #[test]
    fn the_parabola_runs_past_its_table_at_seventy_four() {
        let parabola = ParabolaParameters::new(74).unwrap();
        assert_eq!(parabola_points(&parabola, Arithmetic::AsPublished).len(), 72);
        let exact = parabola_points(&parabola, Arithmetic::Exact);
        assert_eq!((exact.len(), exact[72].pulses), (73, 1168));
        assert!(exact[72].steps > exact[71].steps);
    }
}
