//! Where a store is.

use super::fault::Fault;
use std::fmt;
use std::path::{Path, PathBuf};
use tokio_postgres::Config;
use tokio_postgres::config::Host;

/// Port of Postgres if an address names none.
const PORT: u16 = 5432;

/// Where a store is.
#[derive(Clone, Debug)]
pub enum Location {
    /// A SQLite file.
    File(PathBuf),
    /// A Postgres database.
    Database(Box<Config>),
}

impl Location {
    /// Reads a file name or `postgres://USER:PASSWORD@HOST/DATABASE`. `password`: used if the address has none.
    ///
    /// # Errors
    /// The address of a database has a mistake. Its text is not repeated, because it may contain a password.
    pub fn read(text: &str, password: Option<&str>) -> Result<Self, Fault> {
        if !["postgres://", "postgresql://"].iter().any(|scheme| text.starts_with(scheme)) {
            return Ok(Self::File(text.into()));
        }
        let mut config: Config = text.parse().map_err(|_| Fault::Address)?;
        if config.get_hosts().is_empty() {
            return Err(Fault::Address);
        }
        if let Some(password) = password.filter(|_| config.get_password().is_none()) {
            config.password(password);
        }
        Ok(Self::Database(Box::new(config)))
    }
}

impl From<&Path> for Location {
    fn from(path: &Path) -> Self {
        Self::File(path.to_owned())
    }
}

/// The name of the file, or the address without its password.
impl fmt::Display for Location {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let config = match self {
            Self::File(path) => return write!(formatter, "{}", path.display()),
            Self::Database(config) => config,
        };
        let host = match config.get_hosts().first() {
            Some(Host::Tcp(name)) => name.clone(),
            #[cfg(unix)]
            Some(Host::Unix(path)) => path.display().to_string(),
            None => String::new(),
        };
        let user = config.get_user().map(|user| format!("{user}@")).unwrap_or_default();
        let port = config.get_ports().first().filter(|port| **port != PORT);
        let port = port.map(|port| format!(":{port}")).unwrap_or_default();
        let name = config.get_dbname().map(|name| format!("/{name}")).unwrap_or_default();
        write!(formatter, "postgres://{user}{host}{port}{name}")
    }
}
