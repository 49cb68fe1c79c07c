//! `meniscus build`: a web site of all documents in a folder. Its pages share styles, scripts and modules whose names
//! contain the hash of their content. A service worker caches all files for visits without a network.
//!
//! `parts.rs` takes the built pages apart into files that all pages of a site share. `folder.rs` writes them, the service
//! worker last; `worker.js` keeps them in the browser.

mod collect;
mod curve;
mod files;
mod folder;
mod index;
mod llms;
mod names;
mod parts;
mod worker;

use crate::arguments::Build;
use crate::failure::Failure;
use crate::guide;
use crate::page;
use crate::terminal::Terminal;
use collect::Simulation;
use document::page::{LIBRARY, Source, read_list, write_list};
use files::Files;
use folder::Folder;
use names::{GUIDE, INDEX, LABORATORY, LLMS, WORKER};
use parts::{Parts, ROOT};
use units::markup::escaped;
use units::say;

/// Folder of the theories that the laboratory offers for fits.
const THEORIES: &str = "theories/";

/// Builds the site. If a document has errors, the folder is not changed.
pub fn build(arguments: &Build, terminal: Terminal) -> Result<(), Failure> {
    let (laboratory, player) = (page::own()?, page::bare_player()?);
    let folder = Folder::open(&arguments.output)?;
    let found = collect::collect(&arguments.directory, &arguments.output, terminal)?;
    let files = site(laboratory, player, &found)?;
    folder.publish(&files)?;
    let [simulations, kilobytes] = [found.len(), files.size() / 1000];
    let site = arguments.output.display();
    let language = terminal.language;
    let simulations = match simulations {
        1 => language.say("1 simulation").to_owned(),
        count => say!(language, "{count} simulations"),
    };
    terminal.print(&say!(
        language,
        "{site}: {simulations}, {kilobytes} kB; put the folder on any web server
"
    ));
    Ok(())
}

/// All files of the site.
fn site(laboratory: &str, player: &str, simulations: &[Simulation]) -> Result<Files, Failure> {
    let mut files = Files::default();
    let player = Parts::of(player, "player", &mut files)?;
    for simulation in simulations {
        files.add(simulation.page(), play_page(&player, simulation)?);
    }
    let laboratory = Parts::of(laboratory, "laboratory", &mut files)?;
    let page = laboratory_page(&laboratory, simulations, &mut files)?;
    files.add(LABORATORY, page);
    let index = index::page(simulations, &player, &mut files);
    files.add(INDEX, index);
    files.add(GUIDE, guide::GUIDE);
    files.add(LLMS, llms::text(simulations));
    files.add(WORKER, worker::script(&files));
    files.compress()?;
    Ok(files)
}

/// The page that plays a simulation.
fn play_page(player: &Parts, simulation: &Simulation) -> Result<String, Failure> {
    let program = &simulation.document.program;
    let links = format!(
        "<link rel=\"index\" id=\"simulations\" href=\"{ROOT}{INDEX}\">\n\
         <link rel=\"related\" id=\"laboratory\" href=\"{ROOT}{}\">",
        escaped(&simulation.in_laboratory())
    );
    let page = player.html.replace(parts::LINKS, &links).replace(ROOT, &"../".repeat(simulation.depth()));
    // The source is omitted to keep the page small; the laboratory has it.
    Ok(page::played(&page, &[], program)?)
}

/// The laboratory with the documents of the site, and its own theories unless the site replaces them.
fn laboratory_page(laboratory: &Parts, simulations: &[Simulation], files: &mut Files) -> Result<String, Failure> {
    let mut library: Vec<Source> = simulations.iter().flat_map(Simulation::library).collect();
    let own = parts::between(&laboratory.html, LIBRARY, "</script>").ok_or_else(page::no_place)?;
    let shipped = read_list(own).unwrap_or_default().into_iter().filter(|source| source.name.starts_with(THEORIES));
    let theories: Vec<Source> = shipped.filter(|own| library.iter().all(|source| source.name != own.name)).collect();
    library.extend(theories);
    // A script, because pages opened from a disk cannot load other files.
    let list = serde_json::Value::from(write_list(&library));
    let script = format!("document.getElementById(\"library\").textContent = {list};\n");
    let script = files.share("library", "js", script);
    let element = LIBRARY.replace('>', &format!(" data-script=\"{ROOT}{script}\">"));
    let mut html = laboratory.html.replace(&format!("{LIBRARY}{own}"), &element);
    if let (Some(first), Some(home)) = (simulations.first(), library.first()) {
        html = page::opening(&html, &home.name, &first.document.program)?;
    }
    Ok(html.replace(parts::LINKS, "").replace(ROOT, ""))
}
