//! Arguments of the commands for a class server.

use clap::{Args, Subcommand};
use server::class::MOST_OF_CLASS;
use std::net::IpAddr;
use std::path::PathBuf;

/// File of a store if none is named.
const STORE: &str = "meniscus-class.sqlite";

/// The commands for a class server.
#[derive(Debug, Subcommand)]
pub enum ClassServer {
    /// Serve documents to a class: students join with a code, and the dashboard fills while they work
    #[command(after_help = SERVE_EXAMPLES)]
    Serve(ServeClass),
    /// Write the classes of a store, or one of them, into a new file; a server may run meanwhile
    Backup(Backup),
    /// Take classes from a backup; erased seats, classes whose time is over, and devices of teachers are left out
    Restore(Restore),
    /// Erase a seat, or everything
    Erase(Erase),
    /// Write all hand-ins and answers to surveys of a class into a folder
    Export(ExportClass),
    /// List the classes of a store: code, title, day, seats
    List(ListClasses),
}

const SERVE_EXAMPLES: &str = "\
Examples:
  meniscus class serve tube.md                     a class in the local network
  meniscus class serve tube.md --lab --keep 7      with records, films and fits; erased after 7 days
  meniscus class serve tube.md --public https://class.example --tls behind-proxy --port 8080
  meniscus class serve tube.md --continue --store postgres://meniscus@db.example/class   one of several servers of a class

The screen shows the address and the code for students, and a link for the teacher, which works once. Where the store has a
class, --continue goes on with it, and --new begins another one. Without --tls the dashboard answers to this computer only.";

/// Where a store is.
#[derive(Debug, Args)]
pub struct StorePlace {
    /// File with the classes, or a Postgres database: postgres://USER@HOST/DATABASE, with the password in PGPASSWORD
    #[arg(long, value_name = "FILE|postgres://..", default_value = STORE)]
    pub store: String,
}

/// `meniscus class serve`
#[derive(Debug, Args)]
pub struct ServeClass {
    /// Documents for the class
    #[arg(value_name = "DOC", required = true)]
    pub documents: Vec<PathBuf>,

    /// Give students the laboratory: records, films and fits
    #[arg(long)]
    pub lab: bool,

    /// Port [default: the first free one from 4250]
    #[arg(long, value_name = "N")]
    pub port: Option<u16>,

    #[command(flatten)]
    pub place: StorePlace,

    /// Days after which a new class is erased
    #[arg(long, value_name = "DAYS", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=3650))]
    pub keep: u32,

    /// Most that each class stores, in MiB; what comes beyond it waits in the browsers
    #[arg(long, value_name = "MIB", default_value_t = MOST_OF_CLASS >> 20, value_parser = clap::value_parser!(u64).range(1..=1 << 24))]
    pub room: u64,

    /// Begin a new class even if the store has one
    #[arg(long)]
    pub new: bool,

    /// Go on with the latest class of the store, if it has one
    #[arg(long = "continue", conflicts_with = "new")]
    pub goes_on: bool,

    /// Address under which students reach the server, such as https://class.example
    #[arg(long, value_name = "URL")]
    pub public: Option<String>,

    /// Encryption: certificate and key as files in PEM, or `behind-proxy` if a proxy in front of the server does it
    #[arg(long, value_name = "CERT,KEY", requires = "public")]
    pub tls: Option<String>,

    /// Log with a line of JSON for each request, without answers, names and addresses
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,

    /// Address on which the server listens, such as 192.0.2.5 or :: [default: all of IPv4; behind a proxy 127.0.0.1]
    #[arg(long, value_name = "ADDRESS")]
    pub listen: Option<IpAddr>,

    /// Address of the proxy with --tls behind-proxy: only its requests are answered [default: this computer]
    #[arg(long, value_name = "ADDRESS", requires = "tls")]
    pub proxy: Option<IpAddr>,
}

/// `meniscus class backup`
#[derive(Debug, Args)]
pub struct Backup {
    #[command(flatten)]
    pub place: StorePlace,

    /// Code or title of a class [default: every class of the store]
    #[arg(long, value_name = "NAME")]
    pub class: Option<String>,

    /// The new file
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,
}

/// `meniscus class restore`
#[derive(Debug, Args)]
pub struct Restore {
    /// The backup
    #[arg(value_name = "BACKUP")]
    pub backup: PathBuf,

    #[command(flatten)]
    pub place: StorePlace,
}

/// `meniscus class erase`
#[derive(Debug, Args)]
pub struct Erase {
    #[command(flatten)]
    pub place: StorePlace,

    /// Seat to erase
    #[arg(long, value_name = "N", required_unless_present = "all", conflicts_with = "all")]
    pub seat: Option<u32>,

    /// Code or title of a class [default: the latest class with --seat, every class with --all]
    #[arg(long, value_name = "NAME")]
    pub class: Option<String>,

    /// Erase classes with all that is in them
    #[arg(long)]
    pub all: bool,
}

/// `meniscus class export`
#[derive(Debug, Args)]
pub struct ExportClass {
    #[command(flatten)]
    pub place: StorePlace,

    /// Code or title of the class [default: the latest class]
    #[arg(long, value_name = "NAME")]
    pub class: Option<String>,

    /// Folder for the files, which is made if there is none
    #[arg(long, short, value_name = "FOLDER")]
    pub output: PathBuf,
}

/// `meniscus class list`
#[derive(Debug, Args)]
pub struct ListClasses {
    #[command(flatten)]
    pub place: StorePlace,
}
