//! Workbooks as written by other programs, from the XML of their rows, in valid or invalid archives.

use miniz_oxide::deflate::compress_to_vec;

/// Validity of an archive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pack {
    /// Valid.
    Deflated,
    /// The directory states a tenth of the expanded sizes.
    Understated,
    WrongChecksum,
    Encrypted,
}

const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const RELATIONS: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

/// A workbook of Office Open XML with these sheets.
pub fn xlsx(sheets: &[(&str, &str)]) -> Vec<u8> {
    xlsx_with("", sheets, Pack::Deflated)
}

/// Workbook with these sheets and settings.
pub fn xlsx_with(settings: &str, sheets: &[(&str, &str)], pack: Pack) -> Vec<u8> {
    let mut list = format!("<workbook xmlns=\"{MAIN}\" xmlns:r=\"{RELATIONS}\">{settings}<sheets>");
    let mut relations = String::from("<Relationships>");
    let mut relation = |id: &str, kind: &str, target: &str| {
        relations += &format!("<Relationship Id=\"{id}\" Type=\"{RELATIONS}/{kind}\" Target=\"{target}\"/>");
    };
    relation("texts", "sharedStrings", "/xl/sharedStrings.xml");
    relation("styles", "styles", "styles.xml");
    for (number, (name, _)) in sheets.iter().enumerate() {
        list += &format!("<sheet name=\"{name}\" sheetId=\"{}\" r:id=\"id{number}\"/>", number + 1);
        relation(&format!("id{number}"), "worksheet", &format!("worksheets/sheet{number}.xml"));
    }
    let office = format!(
        "<Relationships><Relationship Id=\"1\" Type=\"{RELATIONS}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
    );
    let texts = "<sst><si><t>t [s]</t></si><si><r><t>y &amp; &lt;z&gt;</t></r><rPh><t>no</t></rPh><r><t> [cm]</t></r></si></sst>";
    let styles = "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"yyyy\\-mm\\-dd h:mm:ss.000\"/>\
                  <numFmt numFmtId=\"165\" formatCode=\"0.00&quot; ms&quot;\"/></numFmts>\
                  <cellStyleXfs><xf numFmtId=\"14\"/></cellStyleXfs><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"164\"/>\
                  <xf numFmtId=\"46\"/><xf numFmtId=\"10\"/><xf numFmtId=\"21\"/><xf numFmtId=\"165\"/></cellXfs></styleSheet>";
    let mut files = vec![
        ("[Content_Types].xml".to_owned(), "<Types/>".to_owned()),
        ("_rels/.rels".to_owned(), office),
        ("xl/workbook.xml".to_owned(), list + "</sheets></workbook>"),
        ("xl/_rels/workbook.xml.rels".to_owned(), relations + "</Relationships>"),
        ("xl/sharedStrings.xml".to_owned(), texts.to_owned()),
        ("xl/styles.xml".to_owned(), styles.to_owned()),
    ];
    for (number, (_, rows)) in sheets.iter().enumerate() {
        let sheet = format!("<?xml version=\"1.0\"?><worksheet><sheetData>{rows}</sheetData></worksheet>");
        files.push((format!("xl/worksheets/sheet{number}.xml"), sheet));
    }
    archive(&files, pack)
}

/// An OpenDocument spreadsheet with these sheets.
pub fn ods(sheets: &[(&str, &str)]) -> Vec<u8> {
    let tables: String =
        sheets.iter().map(|(name, rows)| format!("<table:table table:name=\"{name}\">{rows}</table:table>")).collect();
    let content = format!(
        "<?xml version=\"1.0\"?><office:document-content><office:body><office:spreadsheet>{tables}</office:spreadsheet></office:body></office:document-content>"
    );
    archive(&[("mimetype".to_owned(), String::new()), ("content.xml".to_owned(), content)], Pack::Deflated)
}

/// A ZIP archive.
pub fn archive(files: &[(String, String)], pack: Pack) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in files {
        let packed = compress_to_vec(content.as_bytes(), 6);
        // Only the sheets are invalid.
        let pack = if name.contains("sheets/") { pack } else { Pack::Deflated };
        let size = if pack == Pack::Understated { content.len() / 10 } else { content.len() };
        let check = checksum(content.as_bytes()) ^ u32::from(pack == Pack::WrongChecksum);
        let mut facts = Vec::new();
        for word in [20, u16::from(pack == Pack::Encrypted), 8, 0, 0x21] {
            facts.extend(u16::to_le_bytes(word));
        }
        for word in [check, packed.len() as u32, size as u32, name.len() as u32] {
            facts.extend(word.to_le_bytes());
        }
        directory.extend(b"PK\x01\x02\x14\0");
        directory.extend(&facts);
        directory.extend([0; 10]);
        directory.extend((bytes.len() as u32).to_le_bytes());
        directory.extend(name.as_bytes());
        bytes.extend(b"PK\x03\x04");
        bytes.extend(&facts);
        bytes.extend(name.as_bytes());
        bytes.extend(packed);
    }
    let (start, count) = (bytes.len() as u32, (files.len() as u16).to_le_bytes());
    bytes.extend(&directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend(count);
    bytes.extend(count);
    bytes.extend((directory.len() as u32).to_le_bytes());
    bytes.extend(start.to_le_bytes());
    bytes.extend([0; 2]);
    bytes
}

/// CRC-32, bit by bit.
fn checksum(bytes: &[u8]) -> u32 {
    let next = |check: u32, byte: &u8| {
        (0..8).fold(
            check ^ u32::from(*byte),
            |check, _| if check & 1 == 1 { 0xEDB8_8320 ^ (check >> 1) } else { check >> 1 },
        )
    };
    !bytes.iter().fold(u32::MAX, next)
}
