//! The protocol of the Denford ORAC: pages of ASCII text, each begun by a page mark (STX), the whole ended by an end
//! mark (EOT). There are no check sums and no answers, so only a program that came back can be called verified.
//!
//! Both machines are pure: bytes and the time since the start of the transfer go in, bytes and verdicts come out.

mod receiver;
mod sender;

pub use receiver::{ReceiveStep, Receiver};
pub use sender::{Refused, SendStep, Sender};
