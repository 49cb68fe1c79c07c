//! A server with its classes, pages and limits.

use super::gate::Gate;
use super::limits::Limits;
use super::log::Log;
use super::tally::Tallies;
use crate::class::Classes;
use crate::pages::Pages;
use std::net::IpAddr;
use std::sync::Arc;

/// Where and how the server is reached.
#[derive(Clone, Debug)]
pub struct Place {
    /// Address of the page for students, without a slash at its end.
    pub address: String,
    /// Host names under which the server answers, besides IP addresses and `localhost`.
    pub hosts: Vec<String>,
    /// Connections are encrypted, here or by a proxy: the dashboard answers to every address.
    pub is_encrypted: bool,
    /// Address of the proxy in front of the server, if there is one: requests from elsewhere are refused, and the address of a
    /// client is in the last entry of `X-Forwarded-For`. A loopback address stands for all of this computer.
    pub proxy: Option<IpAddr>,
}

impl Place {
    /// True if a request may come from this address.
    pub(super) fn admits(&self, peer: IpAddr) -> bool {
        let peer = peer.to_canonical();
        self.proxy.is_none_or(|proxy| peer == proxy.to_canonical() || (proxy.is_loopback() && peer.is_loopback()))
    }

    /// Address with the code of a class, for its QR code.
    pub fn join_address(&self, code: &str) -> String {
        format!("{}/#join={code}", self.address)
    }
}

/// Address of a client.
#[derive(Clone, Copy, Debug)]
pub struct Peer(pub IpAddr);

/// A server: classes, pages, limits.
#[derive(Debug)]
pub struct Server {
    pub(super) classes: Classes,
    pub(super) pages: Pages,
    pub(super) place: Place,
    pub(super) gate: Gate,
    pub(super) limits: Limits,
    pub(super) tallies: Tallies,
    pub(super) log: Option<Arc<Log>>,
}

impl Server {
    /// A server of these classes. `log`: place of a line for each request.
    pub fn new(classes: Classes, pages: Pages, place: Place, log: Option<Log>) -> Arc<Self> {
        let (gate, limits, tallies) = (Gate::default(), Limits::default(), Tallies::default());
        Arc::new(Self { classes, pages, place, gate, limits, tallies, log: log.map(Arc::new) })
    }

    /// Where and how the server is reached.
    pub fn place(&self) -> &Place {
        &self.place
    }

    /// The classes.
    pub fn classes(&self) -> &Classes {
        &self.classes
    }
}
