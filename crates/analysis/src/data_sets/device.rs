//! Phone and sensors, as described by phyphox.

use super::remark::Remark;
use crate::import::cells_of;
use crate::table::Table;
use std::collections::BTreeMap;
use units::Unit;

/// Sensors of Android with the unit of their quantity.
const SENSORS: [(&str, &str); 5] = [
    ("accelerometer", "m/s^2"),
    ("gyroscope", "rad/s"),
    ("magnetic_field", "uT"),
    ("pressure", "hPa"),
    ("light", "lx"),
];
/// Upper bound of the lines of a description.
const MOST_LINES: usize = 1000;
/// Upper bound of the length of a property in characters.
const LONGEST: usize = 60;

/// Properties of the device by name.
#[derive(Debug, Default)]
pub(super) struct Device(BTreeMap<String, String>);

impl Device {
    /// Reads lines of `"property","value"`.
    pub fn read(text: &str) -> Self {
        let pair = |cells: Vec<&str>| match cells.as_slice() {
            [name, value, ..] if !value.is_empty() && *value != "null" => {
                Some(((*name).to_owned(), value.chars().take(LONGEST).collect()))
            }
            _ => None,
        };
        Self(cells_of(text).skip(1).take(MOST_LINES).filter_map(pair).collect())
    }

    fn get(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
    }

    /// Remark on the app and the phone; `None` without properties.
    pub fn remark(&self) -> Option<Remark> {
        let maker = self.get("deviceManufacturer").or_else(|| self.get("deviceBrand"));
        let phone: Vec<&str> = maker.into_iter().chain(self.get("deviceModel")).collect();
        let version = self.get("version").unwrap_or_default().to_owned();
        (!self.0.is_empty()).then(|| Remark::Device { version, phone: phone.join(" ") })
    }

    /// Remark on the sensor of a data set.
    pub fn sensor(&self, set: &str, table: &Table) -> Option<Remark> {
        let unit = table.observed_columns().find_map(|column| table.columns.get(column)?.unit.clone())?;
        let same = |text: &str| {
            let other = Unit::parse(text).ok();
            other.is_some_and(|other| other.dimension == unit.dimension && other.factor == unit.factor)
        };
        let (sensor, _) = SENSORS.iter().find(|(_, text)| same(text))?;
        let property = |what: &str| self.get(&format!("{sensor} {what}")).unwrap_or_default().to_owned();
        let (name, range, resolution) = (property("Name"), property("Range"), property("Resolution"));
        let described = [&name, &range, &resolution].iter().any(|text| !text.is_empty());
        described.then(|| Remark::Sensor { set: set.to_owned(), name, range, resolution, unit: unit.text })
    }
}
