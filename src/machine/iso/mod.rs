//! Inserts and holders by their codes: ISO 1832, ISO 5608, ISO 6261.

mod holder;
mod insert;

pub(super) use holder::{IsoHolder, Seat};
pub(super) use insert::{InsertForm, IsoInsert};

/// Insert and holder that belong together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct IsoTool {
    /// The insert.
    pub(super) insert: IsoInsert,
    /// The holder.
    pub(super) holder: IsoHolder,
}

impl IsoTool {
    /// Reads both codes and checks that the insert fits the holder.
    ///
    /// # Errors
    /// The key of the wrong code and a sentence that says what is wrong with it.
    pub(super) fn read(insert: &str, holder: &str) -> Result<Self, (&'static str, String)> {
        let insert = IsoInsert::read(insert).map_err(|e| ("insert", e))?;
        let holder = IsoHolder::read(holder).map_err(|e| ("holder", e))?;
        let fits = |what: &str, of_insert: String, of_holder: String| {
            if of_insert == of_holder {
                return Ok(());
            }
            Err(("holder", format!("The holder takes {what} {of_holder}; that of the insert is {of_insert}.")))
        };
        fits("the shape", insert.letter.to_string(), holder.insert_letter.to_string())?;
        fits("the size", insert.size.clone(), holder.insert_size.clone())?;
        if let (Some(inside), seat) = (insert.inside, holder.seat) {
            let for_bore = matches!(seat, Seat::Bar { .. });
            if inside != for_bore {
                let side = if inside { "inside" } else { "outside" };
                return Err(("holder", format!("The insert is for {side} threads; the holder is not.")));
            }
        }
        Ok(Self { insert, holder })
    }
}
