//! The line settings, editable.

use crate::app::widgets::{Typed, choice, field, form_label};
use crate::machine::{Delivery, EndOfBlock, FlowControl, Parity, Protocol, SerialProfile};
use egui::Ui;

/// Width of the labels, points.
const LABEL: f32 = 86.0;

/// `2400 7O1`: the settings as people write them.
pub(super) fn brief(delivery: &Delivery) -> String {
    let profile = match delivery {
        Delivery::Line(profile) => profile,
        Delivery::Folder(profile) => return format!(".{}", profile.extension),
    };
    let parity = match profile.parity {
        Parity::None => 'N',
        Parity::Odd => 'O',
        Parity::Even => 'E',
    };
    format!("{} {}{parity}{}", profile.baud, profile.data_bits, profile.stop_bits)
}

/// Shows the settings as a form; a folder has none but its path, which is the port.
pub(super) fn show(ui: &mut Ui, delivery: &mut Delivery) {
    if let Delivery::Line(profile) = delivery {
        line(ui, profile);
    }
}

fn line(ui: &mut Ui, profile: &mut SerialProfile) {
    let baud = profile.baud.to_string();
    let read = |text: &str| {
        let baud = text.trim().parse::<u32>().ok().filter(|b| (50..=4_000_000).contains(b));
        baud.ok_or_else(|| format!("“{}” is not a speed; the line takes 50 to 4000000 baud.", text.trim()))
    };
    row(ui, "Baud", |ui, width| {
        if let Some(Typed::Left(Some(baud))) = field(ui, "Baud", &baud, width, read) {
            profile.baud = baud;
        }
    });
    let bits = [(7, "7".to_owned()), (8, "8".to_owned())];
    pick(ui, "Data bits", &mut profile.data_bits, &bits);
    let parities =
        [(Parity::None, "none"), (Parity::Odd, "odd"), (Parity::Even, "even")].map(|(p, t)| (p, t.to_owned()));
    pick(ui, "Parity", &mut profile.parity, &parities);
    pick(ui, "Stop bits", &mut profile.stop_bits, &[(1, "1".to_owned()), (2, "2".to_owned())]);
    let flows = [(FlowControl::None, "none"), (FlowControl::Software, "DC1/DC3"), (FlowControl::Hardware, "RTS/CTS")];
    pick(ui, "Flow control", &mut profile.flow, &flows.map(|(f, t)| (f, t.to_owned())));
    if let Protocol::FanucReaderPunch(habits) = &mut profile.protocol {
        let ends = [(EndOfBlock::Lf, "LF"), (EndOfBlock::LfCrCr, "LF CR CR")].map(|(e, t)| (e, t.to_owned()));
        pick(ui, "End of block", &mut habits.end_of_block, &ends);
        pick(ui, "TV check", &mut habits.tv_check, &[(false, "off".to_owned()), (true, "on".to_owned())]);
    }
}

fn row(ui: &mut Ui, label: &str, content: impl FnOnce(&mut Ui, f32)) {
    ui.horizontal(|ui| {
        form_label(ui, label, LABEL);
        let width = ui.available_width();
        content(ui, width);
    });
}

fn pick<T: PartialEq + Clone>(ui: &mut Ui, label: &str, value: &mut T, all: &[(T, String)]) {
    row(ui, label, |ui, width| {
        if let Some(new) = choice(ui, label, value, all, width) {
            *value = new;
        }
    });
}
