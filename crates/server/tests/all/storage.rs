//! Stores for tests: a file, or a database of a Postgres of the test program's own.

use server::store::{Location, files_beside};
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{ChildStdin, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};

/// A test for both stores: `cases!(first, second)` beside functions with a [`Storage`]. Those with Postgres are run by
/// `cargo test -p server --test all postgres:: -- --ignored`.
macro_rules! cases {
    ($($case:ident),* $(,)?) => {
        mod sqlite {
            $(#[test]
            fn $case() {
                super::$case(&crate::storage::Storage::file());
            })*
        }
        mod postgres {
            $(#[test]
            #[ignore = "needs Postgres"]
            fn $case() {
                super::$case(&crate::storage::Storage::database());
            })*
        }
    };
}
pub(crate) use cases;

/// The same for tests that take long and print figures, in the modules `file` and `database`.
macro_rules! long_cases {
    ($($case:ident),* $(,)?) => {
        mod file {
            $(#[test]
            #[ignore = "takes long and prints figures"]
            fn $case() {
                super::$case(&crate::storage::Storage::file());
            })*
        }
        mod database {
            $(#[test]
            #[ignore = "takes long and prints figures; needs Postgres"]
            fn $case() {
                super::$case(&crate::storage::Storage::database());
            })*
        }
    };
}
pub(crate) use long_cases;

/// A place for a store, and for files of a test.
pub struct Storage {
    pub location: Location,
    /// The location as a text, with the password.
    pub address: String,
    folder: tempfile::TempDir,
}

impl Storage {
    pub fn file() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("class.sqlite");
        Self { address: path.to_str().unwrap().to_owned(), location: Location::File(path), folder }
    }

    /// A new database.
    pub fn database() -> Self {
        Self::in_cluster(Cluster::shared())
    }

    /// A new database in this Postgres.
    pub fn in_cluster(cluster: &Cluster) -> Self {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let name = format!("class{}", NUMBER.fetch_add(1, Ordering::Relaxed));
        cluster.sql("postgres", &format!("CREATE DATABASE {name} ENCODING 'UTF8' TEMPLATE template0"));
        let address = cluster.address(&name);
        Self { location: Location::read(&address, None).unwrap(), address, folder: tempfile::tempdir().unwrap() }
    }

    /// Name of the database.
    pub fn name(&self) -> &str {
        match &self.location {
            Location::Database(config) => config.get_dbname().unwrap(),
            Location::File(path) => panic!("{} is no database", path.display()),
        }
    }

    /// Another place of the same kind.
    pub fn other(&self) -> Self {
        match self.location {
            Location::File(_) => Self::file(),
            Location::Database(_) => Self::database(),
        }
    }

    /// A file beside the store.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// True if the store holds a text: in the bytes of its files, or in a row of a database.
    pub fn holds(&self, text: &str) -> bool {
        match &self.location {
            Location::File(path) => holds(path, text),
            Location::Database(config) => {
                let dump = dump(config);
                assert!(dump.contains("CREATE TABLE meniscus.event"), "{dump}");
                dump.contains(text)
            }
        }
    }
}

/// True if the text is in the bytes of a file, or of those that SQLite keeps beside it.
pub fn holds(path: &std::path::Path, text: &str) -> bool {
    let mut files = vec![path.to_owned()];
    files.extend(files_beside(path));
    let bytes = files.iter().filter_map(|file| std::fs::read(file).ok());
    bytes.into_iter().any(|bytes| bytes.windows(text.len()).any(|window| window == text.as_bytes()))
}

/// Everything that can be read in a database, by Postgres's own program.
fn dump(config: &tokio_postgres::Config) -> String {
    let output = Command::new(program("pg_dump"))
        .args(["--host", "127.0.0.1", "--port", &config.get_ports()[0].to_string()])
        .args(["--username", "postgres", config.get_dbname().unwrap()])
        .env("PGPASSWORD", PASSWORD)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

const PASSWORD: &str = "a p@ss:word/of this test";

/// A Postgres with one new cluster in a temporary folder. It ends with the test program, also if that is killed.
pub struct Cluster {
    folder: PathBuf,
    port: u16,
    /// The shell goes on while this is open. It takes the mode of a stop, restarts Postgres and says so.
    shell: Mutex<(ChildStdin, BufReader<ChildStdout>)>,
}

/// Starts Postgres, and waits until this program has closed the shell's input: `$1` is the folder of the programs, `$2` that of the cluster, `$3` the port.
const SHELL: &str = r#"
trap '' INT TERM
bin="$1" folder="$2" port="$3"
as() { if [ "$(id -u)" = 0 ]; then setpriv --reuid=postgres --regid=postgres --clear-groups "$@"; else "$@"; fi; }
[ "$(id -u)" != 0 ] || chown -R postgres: "$folder"
as "$bin/initdb" --no-sync --encoding=UTF8 --locale=C --username=postgres --auth=scram-sha-256 --pwfile="$folder/password" "$folder/data" >"$folder/made" 2>&1 || exit 1
chmod 600 "$folder/key.pem"
printf "ssl=on\nssl_cert_file='$folder/cert.pem'\nssl_key_file='$folder/key.pem'\n" >>"$folder/data/postgresql.conf"
printf "listen_addresses='127.0.0.1'\nport=$port\nunix_socket_directories=''\nmax_connections=200\n" >>"$folder/data/postgresql.conf"
as "$bin/pg_ctl" --pgdata="$folder/data" --log="$folder/log" --wait start >/dev/null || exit 1
echo ready
while read -r command; do
  as "$bin/pg_ctl" --pgdata="$folder/data" --log="$folder/log" --wait --mode="$command" stop >/dev/null
  sleep 1
  as "$bin/pg_ctl" --pgdata="$folder/data" --log="$folder/log" --wait start >/dev/null
  echo ready
done
as "$bin/pg_ctl" --pgdata="$folder/data" --wait --mode=immediate stop >/dev/null
rm -rf "$folder"
"#;

/// A program of Postgres, in the folder `POSTGRES_BIN`, which `cargo xtask test` finds.
fn program(name: &str) -> PathBuf {
    let folder = std::env::var_os("POSTGRES_BIN").unwrap_or_else(|| "/usr/lib/postgresql/15/bin".into());
    PathBuf::from(folder).join(name)
}

impl Cluster {
    /// The Postgres of all tests that do not stop it.
    pub fn shared() -> &'static Self {
        static SHARED: OnceLock<Cluster> = OnceLock::new();
        SHARED.get_or_init(Cluster::start)
    }

    #[allow(clippy::zombie_processes, reason = "the shell ends after this program")]
    pub fn start() -> Self {
        let folder = tempfile::tempdir().unwrap().keep();
        std::fs::write(folder.join("password"), PASSWORD).unwrap();
        for name in ["cert.pem", "key.pem"] {
            let own = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/all/tls-");
            std::fs::copy(format!("{own}{name}"), folder.join(name)).unwrap();
        }
        let port = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        let programs = program("initdb");
        let mut shell = Command::new("sh")
            .args(["-c", SHELL, "sh"])
            .arg(programs.parent().unwrap())
            .arg(&folder)
            .arg(port.to_string())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let shell = Mutex::new((shell.stdin.take().unwrap(), BufReader::new(shell.stdout.take().unwrap())));
        let cluster = Self { folder, port, shell };
        cluster.wait();
        cluster
    }

    fn wait(&self) {
        let mut line = String::new();
        self.shell.lock().unwrap().1.read_line(&mut line).unwrap();
        let log = || std::fs::read_to_string(self.folder.join("log")).unwrap_or_default();
        assert_eq!(line, "ready\n", "{}", log());
    }

    /// Stops Postgres (`fast`, or `immediate` as in a crash) and starts it a second later.
    pub fn restart(&self, mode: &str) {
        writeln!(self.shell.lock().unwrap().0, "{mode}").unwrap();
        self.wait();
    }

    /// Address of a database, with its password.
    pub fn address(&self, name: &str) -> String {
        let password = percent_encoding::utf8_percent_encode(PASSWORD, percent_encoding::NON_ALPHANUMERIC);
        format!("postgres://postgres:{password}@127.0.0.1:{}/{name}", self.port)
    }

    /// Runs statements in a database, and returns what they print.
    pub fn sql(&self, name: &str, statements: &str) -> String {
        let output = Command::new(program("psql"))
            .args(["--no-psqlrc", "--quiet", "--tuples-only", "--no-align", "--set", "ON_ERROR_STOP=1"])
            .args(["--host", "127.0.0.1", "--port", &self.port.to_string()])
            .args(["--username", "postgres", "--dbname", name, "--command", statements])
            .env("PGPASSWORD", PASSWORD)
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    }

    /// True if the bytes are in a file of a database.
    pub fn files_hold(&self, name: &str, text: &str) -> bool {
        self.sql("postgres", "CHECKPOINT");
        let folder = self.sql(name, "SELECT oid FROM pg_database WHERE datname = current_database()");
        let folder = self.folder.join("data").join("base").join(folder.trim());
        std::fs::read_dir(folder).unwrap().any(|entry| holds(&entry.unwrap().path(), text))
    }
}
