//! One named step of a regeneration.

use std::sync::Arc;

/// A step that remembers its last input and output.
///
/// An equal input is not computed again, and an equal output keeps its old `Arc`, so that a later stage that holds the `Arc` in
/// its own input sees no change.
#[derive(Debug)]
pub struct Stage<I, O> {
    last: Option<(I, Arc<O>)>,
    runs: u64,
}

impl<I, O> Default for Stage<I, O> {
    fn default() -> Self {
        Self { last: None, runs: 0 }
    }
}

impl<I: PartialEq, O: PartialEq> Stage<I, O> {
    /// The output for `input`; `make` is called only if `input` differs from the last one.
    ///
    /// # Errors
    /// What `make` returns; the stage then keeps what it had.
    pub fn try_get<E>(&mut self, input: I, make: impl FnOnce(&I) -> Result<O, E>) -> Result<Arc<O>, E> {
        if let Some((last_input, output)) = &self.last
            && *last_input == input
        {
            return Ok(Arc::clone(output));
        }
        let made = make(&input)?;
        self.runs += 1;
        let output = match self.last.take() {
            Some((_, old)) if *old == made => old,
            _ => Arc::new(made),
        };
        self.last = Some((input, Arc::clone(&output)));
        Ok(output)
    }

    /// The output for `input`; `make` is called only if `input` differs from the last one.
    pub fn get(&mut self, input: I, make: impl FnOnce(&I) -> O) -> Arc<O> {
        match self.try_get(input, |i| Ok::<_, std::convert::Infallible>(make(i))) {
            Ok(output) => output,
            Err(never) => match never {},
        }
    }

    /// The last output.
    #[must_use]
    pub fn output(&self) -> Option<&Arc<O>> {
        self.last.as_ref().map(|(_, output)| output)
    }

    /// How often the stage has computed something.
    #[must_use]
    pub const fn runs(&self) -> u64 {
        self.runs
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_input_is_not_computed_again() {
        let mut stage = Stage::default();
        let first = stage.get(3, |x| x * 2);
        let second = stage.get(3, |_| unreachable!("computed again"));
        assert!(Arc::ptr_eq(&first, &second));
        assert_eq!(stage.runs(), 1);
    }

    #[test]
    fn equal_output_keeps_its_arc() {
        let mut stage = Stage::default();
        let first = stage.get(3, |x| x / 2);
        let second = stage.get(2, |x| x / 2);
        assert!(Arc::ptr_eq(&first, &second));
        assert_eq!(stage.runs(), 2);
    }

    #[test]
    fn a_failed_run_keeps_what_there_was() {
        let mut stage = Stage::default();
        let first = stage.get(3, |x| x * 2);
        assert_eq!(stage.try_get(4, |_| Err("no")), Err("no"));
        assert!(Arc::ptr_eq(&first, &stage.get(3, |_| unreachable!("computed again"))));
    }
}
