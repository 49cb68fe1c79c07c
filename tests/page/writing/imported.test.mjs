// A simulation of Easy JavaScript Simulations is dropped on the page: it opens in Write with the report of the import, whose entries lead
// to their lines, and the original source of a quantity stands below the text.

import assert from "node:assert/strict";
import { drop, eventually, visit } from "../lab.mjs";

const data = (text) => `<![CDATA[${text}]]>`;
const variable = ([name, value, comment = ""]) =>
  `<Variable>\n<Name>${data(name)}</Name>\n<Value>${data(value)}</Value>\n<Type>${data("double")}</Type>\n<Dimension>${data("")}</Dimension>\n<Comment>${data(comment)}</Comment>\n</Variable>`;

/** A mass on a spring whose force is computed in a fixed relation, so that EJS holds it through a step. In UTF-16, as EJS writes. */
function spring(code) {
  const text = `<?xml version="1.0" encoding="UTF-16"?>
<Osejs version="6.0" password="">
<Osejs.Information>
<Title>${data("A force computed too late")}</Title>
<Author>${data("A. Writer")}</Author>
</Osejs.Information>
<Osejs.Model>
<Osejs.Model.FramesPerSecond>20</Osejs.Model.FramesPerSecond>
<Osejs.Model.StepsPerDisplay>1</Osejs.Model.StepsPerDisplay>
<Osejs.Model.Variables>
<Osejs.Model.Variables.Page>
<Name>Table</Name>
<Active>true</Active>
${[["x", "1", "displacement"], ["v", "0"], ["F", ""], ["t", "0"], ["dt", "0.05"]].map(variable).join("\n")}
</Osejs.Model.Variables.Page>
</Osejs.Model.Variables>
<Osejs.Model.Evolution>
<Osejs.Model.Evolution.Page>
<Type>ODE_EDITOR</Type>
<Name>ODE</Name>
<Active>true</Active>
<Events>
</Events>
<IndependentVariable>t</IndependentVariable>
<Increment>dt</Increment>
<Rate state="x">v</Rate>
<Rate state="v">F</Rate>
<Method>RungeKutta</Method>
</Osejs.Model.Evolution.Page>
</Osejs.Model.Evolution>
<Osejs.Model.Constraints>
<Osejs.Model.Constraints.Page>
<Name>force</Name>
<Active>true</Active>
<Code>${data(`\n${code}\n`)}</Code>
</Osejs.Model.Constraints.Page>
</Osejs.Model.Constraints>
</Osejs.Model>
</Osejs>
`;
  return Buffer.from(`\ufeff${text}`, "utf16le");
}

const file = (name, text) => ({ name, text });
const written = (lab) => lab.page.locator(".cm-content").evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);

visit("a simulation of EJS opens in Write with its report", async (lab) => {
  await drop(lab, file("held.ejss", spring("F = -4*x;")));
  await eventually(async () => assert.match(await written(lab), /v' = F\n/));
  assert.match(await written(lab), /F = -4\*x\n/);
  await eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /^No errors/));
  const report = lab.page.locator("#import-report");
  await report.locator("summary").click();
  assert.match(await report.innerText(), /The model is translated/);
  const entry = report.getByRole("button", { name: /computed after each step in the original/ });
  await entry.click();
  // The cursor stands on the line of the entry; on a quantity the line below the text has its source.
  const line = await lab.page.locator(".cm-activeLine").innerText();
  assert.match(line, /computed after each step in the original/);
  await lab.page.locator(".cm-line", { hasText: /^F = -4/ }).click({ position: { x: 4, y: 6 } });
  await eventually(async () => assert.match(await lab.page.locator("#original").innerText(), /F = -4\*x;/));
});

visit("a simulation that is not translated says why", async (lab) => {
  await drop(lab, file("loop.ejss", spring("for (var i=0; i<3; i++) F = F - x;")));
  await eventually(async () => assert.match(await written(lab), /for \(var i=0; i<3; i\+\+\)/));
  const report = lab.page.locator("#import-report");
  await report.locator("summary").click();
  assert.match(await report.innerText(), /listed and not translated: F cannot be translated, and the motion needs it: it has a loop/);
});

visit("an exported page of EJS says where its source is", async (lab) => {
  await drop(lab, file("page.ejss", Buffer.from("<!DOCTYPE html><html><body>A simulation</body></html>")));
  await eventually(async () => assert.match(await lab.page.locator("body").innerText(), /This is an exported page\. Its source is the file \.ejss/));
});
