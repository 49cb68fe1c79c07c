//! Integration methods and their names.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use units::{Words, nearest, words};

/// Integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
pub enum Method {
    /// Euler's method, order 1.
    Euler,
    /// Euler-Richardson, the midpoint method, order 2.
    EulerRichardson,
    /// Velocity Verlet, order 2, for equations of second order.
    VelocityVerlet,
    /// The classical Runge-Kutta method, order 4.
    #[default]
    RungeKutta4,
    /// Dormand-Prince 5(4), adaptive.
    DormandPrince,
    /// RODAS 4(3), a Rosenbrock method for stiff equations, adaptive.
    Rosenbrock,
}

impl Method {
    /// All methods, those of fixed step first.
    pub const ALL: [Self; 6] = [
        Self::Euler,
        Self::EulerRichardson,
        Self::VelocityVerlet,
        Self::RungeKutta4,
        Self::DormandPrince,
        Self::Rosenbrock,
    ];

    /// Name in documents, links and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Euler => "euler",
            Self::EulerRichardson => "euler-richardson",
            Self::VelocityVerlet => "velocity-verlet",
            Self::RungeKutta4 => "rk4",
            Self::DormandPrince => "dormand-prince",
            Self::Rosenbrock => "rosenbrock",
        }
    }

    /// Order p: the error of a run is proportional to step^p.
    pub fn order(self) -> u32 {
        match self {
            Self::Euler => 1,
            Self::EulerRichardson | Self::VelocityVerlet => 2,
            Self::RungeKutta4 | Self::Rosenbrock => 4,
            Self::DormandPrince => 5,
        }
    }

    /// True if the method chooses its own steps by the tolerance; rows are on the grid in any case.
    pub fn adaptive(self) -> bool {
        matches!(self, Self::DormandPrince | Self::Rosenbrock)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// Names of the methods in other programs and in textbooks, in small letters and digits.
const OTHER_NAMES: [(Method, &[&str]); 6] = [
    (Method::Euler, &["euler", "forwardeuler", "explicit", "expliciteuler"]),
    (Method::EulerRichardson, &["eulerrichardson", "midpoint", "rk2", "puntomedio"]),
    (Method::VelocityVerlet, &["velocityverlet", "verlet", "leapfrog", "velverlet", "stoermerverlet"]),
    (Method::RungeKutta4, &["rk4", "rungekutta", "rungekutta4", "rk", "rungekuttaorder4"]),
    (
        Method::DormandPrince,
        &["dormandprince", "dopri", "dopri5", "rk45", "ode45", "rkf45", "adaptive", "dormandprince54"],
    ),
    (Method::Rosenbrock, &["rosenbrock", "rodas", "stiff", "ode15s", "ode23s", "radau", "bdf"]),
];

/// A name that belongs to no method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod(pub String);

impl UnknownMethod {
    /// The method with this name in other programs and in textbooks, or with a name much like it; `None` for another method.
    pub fn meant(&self) -> Option<Method> {
        let plain: String = self.0.to_lowercase().chars().filter(char::is_ascii_alphanumeric).collect();
        let known = OTHER_NAMES.iter().find(|(_, names)| names.contains(&plain.as_str())).map(|(method, _)| *method);
        let near = || nearest(&self.0, Method::ALL.map(Method::name)).and_then(|name| name.parse().ok());
        known.or_else(near)
    }

    /// Error message with the list of the methods.
    pub fn words(&self) -> Words {
        let Self(name) = self;
        let [first @ .., last] = Method::ALL.map(Method::name);
        let first = first.join(", ");
        words!("there is no method `{name}`; the methods are {first} and {last}")
    }
}

/// The English message.
impl fmt::Display for UnknownMethod {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.words().english())
    }
}

impl std::error::Error for UnknownMethod {}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(text: &str) -> Result<Self, UnknownMethod> {
        Self::ALL.into_iter().find(|method| method.name() == text).ok_or_else(|| UnknownMethod(text.to_owned()))
    }
}
