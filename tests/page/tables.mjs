// Tables as other programs write them: text, and workbooks made by hand.

import { deflateRawSync } from "node:zlib";

/** Time and height of a damped oscillation, 30 rows a second. */
function rows() {
  const height = (t) => 5 * Math.exp(-0.4 * t) * Math.cos(9.6 * t);
  return Array.from({ length: 60 }, (_, frame) => [frame / 30, height(frame / 30)]);
}

/** As text. */
export const film = () => `t [s]\ty [cm]\n${rows().map((row) => row.join("\t")).join("\n")}\n`;

/** As XLSX: a sheet of words, then the table; or these rows instead. */
export function xlsx(sheet = undefined) {
  const text = (value) => `<c t="inlineStr"><is><t>${value}</t></is></c>`;
  const head = `<row>${text("t [s]")}${text("y [cm]")}</row>`;
  const body = rows().map((row) => `<row>${row.map((value) => `<c><v>${value}</v></c>`).join("")}</row>`).join("");
  const kind = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
  const relation = (id, type, target) => `<Relationship Id="${id}" Type="${kind}/${type}" Target="${target}"/>`;
  const worksheet = (rows) => `<worksheet><sheetData>${rows}</sheetData></worksheet>`;
  return zip({
    "[Content_Types].xml": "<Types/>",
    "_rels/.rels": `<Relationships>${relation("a", "officeDocument", "xl/workbook.xml")}</Relationships>`,
    "xl/workbook.xml": `<workbook><sheets><sheet name="Notes" r:id="b"/><sheet name="Film" r:id="c"/></sheets></workbook>`,
    "xl/_rels/workbook.xml.rels": `<Relationships>${relation("b", "worksheet", "b.xml")}${relation("c", "worksheet", "c.xml")}</Relationships>`,
    "xl/b.xml": worksheet(`<row>${text("Filmed in May")}</row>`),
    "xl/c.xml": worksheet(sheet ?? head + body),
  });
}

/** The same as ODS. */
export function ods() {
  const text = (value) => `<table:table-cell office:value-type="string"><text:p>${value}</text:p></table:table-cell>`;
  const number = (value) => `<table:table-cell office:value-type="float" office:value="${value}"/>`;
  const row = (cells) => `<table:table-row>${cells.join("")}</table:table-row>`;
  const table = (name, rows) => `<table:table table:name="${name}">${rows.join("")}</table:table>`;
  const notes = table("Notes", [row([text("Filmed in May")])]);
  const film = table("Film", [row([text("t [s]"), text("y [cm]")]), ...rows().map((cells) => row(cells.map(number)))]);
  return zip({ mimetype: "", "content.xml": `<office:spreadsheet>${notes}${film}</office:spreadsheet>` });
}

/** The same as XLS of Excel 5: records of a kind, a length and their content, without a compound file around them. */
export function xls() {
  const words = (...values) => Buffer.from(Uint16Array.from(values).buffer);
  const record = (kind, ...parts) => Buffer.concat([words(kind, Buffer.concat(parts).length), ...parts]);
  const text = (value) => [words(value.length), Buffer.from(value, "latin1")];
  const number = (value) => Buffer.from(Float64Array.of(value).buffer);
  const stream = (kind, ...records) => Buffer.concat([record(0x809, words(0x500, kind, 0, 0)), ...records, record(0x0a)]);
  const heads = ["t [s]", "y [cm]"].map((head, column) => record(0x204, words(0, column, 0), ...text(head)));
  const cells = rows().flatMap((row, place) => row.map((value, column) => record(0x203, words(place + 1, column, 0), number(value))));
  const sheet = (name, start) => record(0x85, words(start & 0xffff, start >> 16, 0), Buffer.from([name.length]), Buffer.from(name));
  const notes = stream(0x10, record(0x204, words(0, 0, 0), ...text("Filmed in May")));
  const book = (start) => stream(5, sheet("Notes", start), sheet("Film", start + notes.length));
  return Buffer.concat([book(book(0).length), notes, stream(0x10, ...heads, ...cells)]);
}

/** A ZIP archive of compressed files. */
function zip(files) {
  const parts = [];
  const directory = [];
  let offset = 0;
  for (const [name, content] of Object.entries(files)) {
    const bytes = Buffer.from(content);
    const packed = deflateRawSync(bytes);
    const facts = Buffer.alloc(26);
    [20, 0, 8, 0, 0x21].forEach((word, index) => facts.writeUInt16LE(word, 2 * index));
    [checksum(bytes), packed.length, bytes.length, name.length].forEach((word, index) => facts.writeUInt32LE(word, 10 + 4 * index));
    const place = Buffer.alloc(14);
    place.writeUInt32LE(offset, 10);
    directory.push(Buffer.from("PK\x01\x02\x14\0", "latin1"), facts, place, Buffer.from(name));
    parts.push(Buffer.from("PK\x03\x04", "latin1"), facts, Buffer.from(name), packed);
    offset += 30 + name.length + packed.length;
  }
  const list = Buffer.concat(directory);
  const end = Buffer.alloc(22);
  end.write("PK\x05\x06", "latin1");
  const count = Object.keys(files).length;
  end.writeUInt16LE(count, 8);
  end.writeUInt16LE(count, 10);
  end.writeUInt32LE(list.length, 12);
  end.writeUInt32LE(offset, 16);
  return Buffer.concat([...parts, list, end]);
}

/** CRC-32, bit by bit. */
function checksum(bytes) {
  let check = 0xffffffff;
  for (const byte of bytes) {
    check ^= byte;
    for (let bit = 0; bit < 8; bit += 1) check = check & 1 ? (check >>> 1) ^ 0xedb88320 : check >>> 1;
  }
  return (check ^ 0xffffffff) >>> 0;
}
