//! Instruments and programs whose files are described.

use super::description::{Cells, Clock, Description, Gain, PLAIN, Sections, Settings};
use crate::import::cells::Delimiter;

/// Descriptions; the first that matches is used.
pub(super) const KNOWN: &[Description] = &[
    // Specification of the LabVIEW measurement file (ni.com, tutorial 4139); files of github.com/ladisk/lvm_read, `data`.
    Description {
        name: "LabVIEW",
        first: &["labview measurement"],
        names: Cells::FromEnd(0),
        units: Cells::Key(&["y_unit_label"]),
        clock: Clock::Named("x_value"),
        step: &["delta_x"],
        start: &["x0"],
        time_unit: &["x_unit_label"],
        sections: Sections::Runs,
        ..PLAIN
    },
    // TDS 200 to 2000, TBS 1000: settings in columns A to C, times in D, values in E (Tektronix, TDS2000 manual, "Saving
    // waveform data").
    Description {
        name: "Tektronix",
        first: &["record length,"],
        also: &["sample interval,", "vertical units,", "probe atten"],
        settings: Settings::Beside,
        names: Cells::Key(&["source"]),
        units: Cells::Key(&["vertical units"]),
        clock: Clock::Named(""),
        step: &["sample interval"],
        time_unit: &["horizontal units"],
        ..PLAIN
    },
    // MSO, DPO and MDO: settings, then `TIME,CH1`.
    Description {
        name: "Tektronix",
        first: &["model,"],
        also: &["sample interval,", "time,"],
        names: Cells::FromEnd(0),
        units: Cells::Key(&["vertical units"]),
        step: &["sample interval"],
        time_unit: &["horizontal units"],
        ..PLAIN
    },
    // SDS 1000: `Source` over `Second,Volt`.
    Description {
        name: "Siglent",
        first: &["record length,"],
        also: &["sample interval,", "second,"],
        names: Cells::Key(&["source"]),
        units: Cells::FromEnd(0),
        step: &["sample interval"],
        ..PLAIN
    },
    // DS1000Z: `X,CH1,Start,Increment,` over `Sequence,Volt,-1.2e-03,2.0e-06`.
    Description {
        name: "Rigol",
        first: &["x,ch", "x,math", "x,d7"],
        also: &["increment", "sequence"],
        settings: Settings::Columns,
        names: Cells::Line(0),
        units: Cells::Line(1),
        clock: Clock::Index,
        step: &["increment"],
        start: &["start"],
        ..PLAIN
    },
    // DS1000Z, export without the count of the rows: `CH1,CH2,Start,Increment,` over `Volt,Volt,-6e-02,1e-04`.
    Description {
        name: "Rigol",
        first: &["ch", "math", "d7"],
        also: &["start,increment"],
        settings: Settings::Columns,
        names: Cells::Line(0),
        units: Cells::Line(1),
        clock: Clock::Perhaps,
        step: &["increment"],
        start: &["start"],
        ..PLAIN
    },
    // DS1000D and DS1000E: `Time,X(CH1)` over `Second,Volt`.
    Description {
        name: "Rigol",
        first: &["time,x(ch"],
        also: &["second,volt"],
        names: Cells::Line(0),
        units: Cells::Line(1),
        ..PLAIN
    },
    // MSO5000 and DHO: `CH1V,CH2V,t0 =-5e-06, tInc = 2e-10,`.
    Description {
        name: "Rigol",
        first: &["ch", "time"],
        also: &["tinc", "t0"],
        names: Cells::Line(0),
        clock: Clock::Perhaps,
        step: &["tinc"],
        start: &["t0"],
        ..PLAIN
    },
    // HDS 200: `Time interval :,0.08uS`, then `index,CH1_Voltage(mV)` (github.com/h-elsner/OwonOszi, `testfiles`).
    Description {
        name: "OWON",
        first: &["channel"],
        also: &["time interval", "index"],
        delimiters: &[Delimiter::Semicolon, Delimiter::Comma],
        names: Cells::FromEnd(0),
        clock: Clock::Index,
        step: &["time interval"],
        ..PLAIN
    },
    // Older program of the VDS and HDS: `Unit:(mV)`, `,CH1`, no step.
    Description {
        name: "OWON",
        first: &["unit:("],
        also: &["frequency", "period"],
        delimiters: &[Delimiter::Semicolon, Delimiter::Comma],
        names: Cells::Line(1),
        units: Cells::Key(&["unit"]),
        clock: Clock::Index,
        ..PLAIN
    },
    // `#CHANNEL:CH1`, `#CLOCK=20.0uS`, `#SIZE=130048`, `#UNITS:V`, then one number a line; the channels one after the
    // other (Blog Electronicayciencia, 2020-02-02).
    Description {
        name: "Hantek",
        first: &["#channel", "# channel", "#clock", "# clock"],
        also: &["clock"],
        delimiters: &[Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma, Delimiter::Blanks],
        names: Cells::Key(&["channel"]),
        units: Cells::Key(&["units"]),
        clock: Clock::Perhaps,
        step: &["clock"],
        sections: Sections::Channels,
        ..PLAIN
    },
    // GDS and GBS: `Waveform Data`, then volts with times (Detail) or points of the screen (Fast), 25 a division
    // (GDS-2000A user manual, "Spreadsheet file format"; GDS-2000, "Waveform file format").
    Description {
        name: "GW Instek",
        first: &["format,", "memory length,"],
        also: &["sampling period,", "waveform data"],
        names: Cells::Key(&["source"]),
        units: Cells::Key(&["vertical units"]),
        clock: Clock::Pairs { key: "mode", value: "detail" },
        step: &["sampling period"],
        time_unit: &["horizontal units"],
        gain: Gain::Divisions { key: "vertical scale", points: 25 },
        ..PLAIN
    },
    // X = HResolution * (number - 1) + HOffset (DLM3000 user manual IM DLM3054-01EN, appendix 3).
    Description {
        name: "Yokogawa",
        first: &["header size", "\"header size", "//yokogawa", "model name", "\"model name"],
        also: &["tracename", "hresolution"],
        names: Cells::Key(&["tracename"]),
        units: Cells::Key(&["vunit"]),
        clock: Clock::Perhaps,
        step: &["hresolution"],
        start: &["hoffset"],
        time_unit: &["hunit"],
        ..PLAIN
    },
    // Infiniium: `XInc:,0.04`, `XOrg:,-3`, then `Data:,` (Infiniium help, "CSV files").
    Description {
        name: "Keysight",
        first: &["revision:"],
        also: &["xinc:", "yunits:"],
        names: Cells::Key(&["source"]),
        units: Cells::Key(&["yunits"]),
        clock: Clock::Perhaps,
        step: &["xinc"],
        start: &["xorg"],
        time_unit: &["xunits"],
        ..PLAIN
    },
    // NI ELVIS: `waveform`, `t0`, `delta t`, then rows whose times of day are rounded to microseconds.
    Description {
        name: "NI ELVIS",
        first: &["waveform,"],
        also: &["t0,", "delta t,"],
        names: Cells::Line(0),
        clock: Clock::Index,
        step: &["delta t"],
        ..PLAIN
    },
    // LabQuest and Logger Pro: `Vernier Format 2`, file and date, name of the run, names, symbols, units; a blank line; the
    // next run begins with its name.
    Description {
        name: "Vernier",
        first: &["vernier format"],
        delimiters: &[Delimiter::Tab],
        names: Cells::FromEnd(2),
        units: Cells::FromEnd(0),
        clock: Clock::Any,
        sections: Sections::Runs,
        ..PLAIN
    },
    // CASSY Lab: `MIN=`, `MAX=`, `SCALE=`, `DEC=`, `DEF="Zeit" t / s`.
    Description {
        name: "CASSY Lab",
        first: &["min="],
        also: &["max=", "def="],
        delimiters: &[Delimiter::Tab],
        names: Cells::Key(&["def"]),
        clock: Clock::Any,
        ..PLAIN
    },
    // Console of MakeCode: each column behind the times at which it arrived.
    Description { name: "MakeCode", first: &["time (source"], names: Cells::FromEnd(0), clock: Clock::Any, ..PLAIN },
];

/// MATLAB's display of a matrix: `A =`, `1.0e+03 *`, `Columns 1 through 8` (MATLAB, `format`).
pub(super) const MATLAB: Description = Description {
    name: "MATLAB",
    delimiters: &[Delimiter::Blanks],
    clock: Clock::Any,
    gain: Gain::Power,
    sections: Sections::Channels,
    ..PLAIN
};
