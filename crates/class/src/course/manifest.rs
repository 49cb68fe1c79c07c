//! Manifests of course packages: IMS Content Packaging with the extensions of SCORM, and the course structure of cmi5.

use play::name_of;
use program::Program;
use units::markup::{Escaped, escaped};

const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// Identifier of the course. It stays the same when the text of the document changes, so that a course recognises a new version:
/// it follows from the name of the assignment or else from the title.
fn identifier(program: &Program) -> String {
    let name = program.assignment.as_deref().unwrap_or(&program.title);
    format!("meniscus-{}", name_of(&[name, &program.language]))
}

/// The title in each language: `one` makes the element of a language and an escaped title.
fn titles(program: &Program, one: impl Fn(Escaped<'_>, Escaped<'_>) -> String) -> String {
    program.editions.iter().map(|edition| one(Escaped(&edition.language), Escaped(&edition.title))).collect()
}

/// `imsmanifest.xml` for SCORM 1.2.
pub fn scorm12(program: &Program) -> String {
    let titles = titles(program, |tag, title| format!("<langstring xml:lang=\"{tag}\">{title}</langstring>"));
    content_package(
        program,
        "xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\" xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\"",
        "1.2",
        &format!(
            "<lom xmlns=\"http://www.imsglobal.org/xsd/imsmd_rootv1p2p1\"><general><title>{titles}</title></general></lom>"
        ),
        "",
        "adlcp:scormtype",
    )
}

/// `imsmanifest.xml` for SCORM 2004, 4th edition. The page alone says that it is completed.
pub fn scorm2004(program: &Program) -> String {
    let titles = titles(program, |tag, title| format!("<string language=\"{tag}\">{title}</string>"));
    content_package(
        program,
        "xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_v1p3\" \
         xmlns:imsss=\"http://www.imsglobal.org/xsd/imsss\"",
        "2004 4th Edition",
        &format!("<lom xmlns=\"http://ltsc.ieee.org/xsd/LOM\"><general><title>{titles}</title></general></lom>"),
        "<imsss:sequencing><imsss:deliveryControls completionSetByContent=\"true\" objectiveSetByContent=\"true\"/>\
         </imsss:sequencing>",
        "adlcp:scormType",
    )
}

/// A package with one organization of one item. `sequencing`: element at the end of the item; `kind`: name of the attribute that
/// marks the resource as a SCO.
fn content_package(
    program: &Program,
    spaces: &str,
    version: &str,
    metadata: &str,
    sequencing: &str,
    kind: &str,
) -> String {
    let (id, title) = (identifier(program), escaped(&program.title));
    format!(
        "{DECLARATION}<manifest identifier=\"{id}\" version=\"1\" {spaces}>\n\
         <metadata><schema>ADL SCORM</schema><schemaversion>{version}</schemaversion>{metadata}</metadata>\n\
         <organizations default=\"course\"><organization identifier=\"course\"><title>{title}</title>\
         <item identifier=\"item\" identifierref=\"page\"><title>{title}</title>{sequencing}</item>\
         </organization></organizations>\n\
         <resources><resource identifier=\"page\" type=\"webcontent\" {kind}=\"sco\" href=\"index.html\">\
         <file href=\"index.html\"/></resource></resources>\n</manifest>\n"
    )
}

/// `cmi5.xml`: a course with one assignable unit.
pub fn cmi5(program: &Program) -> String {
    let id = identifier(program);
    let titles = titles(program, |tag, title| format!("<langstring lang=\"{tag}\">{title}</langstring>"));
    let about = format!("<title>{titles}</title><description>{titles}</description>");
    format!(
        "{DECLARATION}<courseStructure xmlns=\"https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd\">\n\
         <course id=\"urn:meniscus:{id}\">{about}</course>\n\
         <au id=\"urn:meniscus:{id}:page\" moveOn=\"Completed\">{about}<url>index.html</url></au>\n\
         </courseStructure>\n"
    )
}
