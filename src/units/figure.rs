//! Figures as people write them.

/// A figure with at most `decimals` decimals, without zeros behind the last one that counts and without a negative zero.
#[must_use]
pub fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_zeros_behind_the_point_go() {
        assert_eq!(trimmed(12.3456, 3), "12.346");
        assert_eq!(trimmed(100.0, 3), "100");
        assert_eq!(trimmed(100.0, 0), "100");
        assert_eq!(trimmed(2.50, 3), "2.5");
        assert_eq!(trimmed(-0.0001, 3), "0");
    }
}
