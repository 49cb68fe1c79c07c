// Makes the sample film `tube.mp4`: draws each frame of a U-tube as a camera would see it, and encodes the frames by ffmpeg.
//
//   node simulations/films/make.mjs
//
// It needs ffmpeg and what the browser tests need (`npm ci` in tests/page; CHROME names another browser than Debian's).
//
// The liquid moves by the exact solution of rho S L y'' + b y' + 2 rho S g y = 0 with the values below. The picture shows the
// part of the plane that the scene of `tube.md` shows, with 1.5 pixels per unit of the scene, so that the film can
// take the place of the drawing.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";

const require = createRequire(new URL("../../tests/page/lab.mjs", import.meta.url));
const { chromium } = require("playwright-core");

// SI units. `y` is the displacement of the left column, `bore` follows from the cross-section.
const TUBE = { length: 0.22, section: 1.1e-4, density: 998, damping: 0.0105, gravity: 9.8, displacement: 0.037 };
const FILM = { width: 472, height: 736, rate: 30, seconds: 8, exposure: 1 / 60, instants: 6 };

// Runs in the browser. Returns a function that draws the frame at a time and returns it as a data URL.
const studio = ({ tube, film }) => {
  const [scale, pixel] = [24, 1.5]; // units per centimetre, pixels per unit
  const bore = 2 * scale * 100 * Math.sqrt(tube.section / Math.PI);
  const rest = 470 - (scale * 100 * (tube.length - 0.08)) / 2;
  const rate = tube.damping / (2 * tube.density * tube.section * tube.length);
  const frequency = Math.sqrt((2 * tube.gravity) / tube.length - rate * rate);
  const displacement = (time) =>
    tube.displacement * Math.exp(-rate * time) * (Math.cos(frequency * time) + (rate / frequency) * Math.sin(frequency * time));

  const sheet = () => {
    const sheet = document.createElement("canvas");
    [sheet.width, sheet.height] = [film.width, film.height];
    const pen = sheet.getContext("2d");
    pen.setTransform(pixel, 0, 0, pixel, 12 * pixel, -64 * pixel);
    return pen;
  };
  // The middle line of the tube, from the top of the left column to that of the right one.
  const line = (top) => {
    const line = new Path2D();
    line.moveTo(125, top);
    line.lineTo(125, 470);
    line.arc(186, 470, 61, Math.PI, 0, true);
    line.lineTo(247, top);
    return line;
  };
  const stroke = (pen, path, width, colour) => {
    [pen.lineWidth, pen.strokeStyle] = [width, colour];
    pen.stroke(path);
  };
  const box = (pen, x, y, width, height, colour) => {
    pen.fillStyle = colour;
    pen.fillRect(x, y, width, height);
  };

  // Wall with light from the upper left, table, stand, and a shadow of the glass.
  const wall = sheet();
  const light = wall.createRadialGradient(70, 150, 30, 110, 240, 430);
  [[0, "#d9d3c8"], [0.55, "#c3bcaf"], [1, "#938c80"]].forEach(([at, colour]) => light.addColorStop(at, colour));
  box(wall, -12, 64, 315, 491, light);
  wall.filter = "blur(9px)";
  wall.translate(11, 8);
  stroke(wall, line(72), bore + 6, "rgb(70 62 52 / 26%)");
  wall.setTransform(pixel, 0, 0, pixel, 12 * pixel, -64 * pixel);
  wall.filter = "none";
  const metal = wall.createLinearGradient(180, 0, 192, 0);
  [[0, "#5c5f63"], [0.35, "#c9ccd0"], [1, "#55585c"]].forEach(([at, colour]) => metal.addColorStop(at, colour));
  box(wall, 182.5, 64, 7, 491, metal);
  const table = wall.createLinearGradient(0, 547, 0, 554);
  table.addColorStop(0, "#7b5f45");
  table.addColorStop(1, "#5d4632");
  box(wall, -12, 547, 315, 8, table);
  // The ruler between the columns, in centimetres, with two marks 12 cm apart.
  box(wall, 169, 92, 36, 394, "rgb(70 62 52 / 20%)");
  box(wall, 167, 90, 36, 394, "#f3efe3");
  wall.font = "10px sans-serif";
  wall.textAlign = "right";
  for (let half = 0; half <= 30; half += 1) {
    const y = 470 - half * 12;
    const length = half % 10 === 0 ? 13 : half % 2 === 0 ? 9 : 5;
    box(wall, 167, y - 0.5, length, 1, "#3d3a34");
    if (half % 10 === 0) wall.fillText(String(half / 2), 196, y + 3.5);
  }
  [470 - 24, 470 - 13 * 24].forEach((y) => {
    wall.fillStyle = "#111";
    wall.beginPath();
    wall.arc(196.5, y, 4, 0, 2 * Math.PI);
    wall.fill();
  });
  // The empty glass.
  stroke(wall, line(72), bore + 8, "rgb(86 98 104 / 42%)");
  stroke(wall, line(72), bore + 5.5, "rgb(222 228 230 / 55%)");
  stroke(wall, line(72), bore, "rgb(226 231 231 / 62%)");

  // What stands before the liquid: reflections on the glass, the clamp.
  const front = sheet();
  front.lineCap = "round";
  const gleam = (x, width, share) => {
    const gleam = new Path2D(`M${x} 84V462`);
    stroke(front, gleam, width, `rgb(255 255 255 / ${share}%)`);
  };
  [125, 247].forEach((x) => {
    gleam(x - 0.3 * bore, 3.2, 42);
    gleam(x + 0.36 * bore, 1.6, 26);
    front.strokeStyle = "rgb(86 98 104 / 60%)";
    front.lineWidth = 1.2;
    front.beginPath();
    front.ellipse(x, 73, bore / 2 + 3.5, 3.4, 0, 0, 2 * Math.PI);
    front.stroke();
  });
  front.lineCap = "butt";
  const clamp = front.createLinearGradient(0, 500, 0, 514);
  [[0, "#3b3f44"], [0.3, "#6d7278"], [1, "#24272b"]].forEach(([at, colour]) => clamp.addColorStop(at, colour));
  box(front, 168, 517, 36, 10, clamp);
  box(front, 179, 510, 14, 24, "#2d3136");

  const picture = sheet();
  const liquid = sheet();
  // The liquid at an instant; each surface climbs the glass at its rim.
  const pour = (time) => {
    liquid.clearRect(-12, 64, 315, 491);
    liquid.save();
    const up = scale * 100 * displacement(time);
    const wet = new Path2D("M60 469.5H320V579.5H60Z");
    [[125, rest - up], [247, rest + up]].forEach(([x, y]) => {
      const [left, right] = [x - bore / 2 - 1, x + bore / 2 + 1];
      wet.addPath(new Path2D(`M${left} ${y - 3}Q${x} ${y + 3} ${right} ${y - 3}V600H${left}Z`));
    });
    liquid.clip(wet);
    stroke(liquid, line(56), bore, "#1f5d86");
    [[0.82, "#2a6f9b"], [0.58, "#3880ad"], [0.3, "#468fba"]].forEach(([part, colour]) => stroke(liquid, line(56), part * bore, colour));
    liquid.restore();
    [[125, rest - up], [247, rest + up]].forEach(([x, y]) => {
      const rim = new Path2D(`M${x - bore / 2} ${y - 3}Q${x} ${y + 3} ${x + bore / 2} ${y - 3}`);
      stroke(liquid, rim, 1.6, "rgb(12 46 74 / 85%)");
    });
    return liquid.canvas;
  };
  const lay = (pen, canvas) => {
    pen.save();
    pen.resetTransform();
    pen.drawImage(canvas, 0, 0);
    pen.restore();
  };
  return (time) => {
    picture.globalAlpha = 1;
    lay(picture, wall.canvas);
    // The mean of the pictures during the exposure: the n-th counts 1/n of what is there then.
    const blend = sheet();
    for (let n = 0; n < film.instants; n += 1) {
      const single = sheet();
      lay(single, wall.canvas);
      single.globalAlpha = 0.93;
      lay(single, pour(Math.max(0, time + (film.exposure * (n + 0.5 - film.instants / 2)) / film.instants)));
      blend.globalAlpha = 1 / (n + 1);
      lay(blend, single.canvas);
    }
    lay(picture, blend.canvas);
    lay(picture, front.canvas);
    return picture.canvas.toDataURL("image/png");
  };
};

const browser = await chromium.launch({ executablePath: process.env.CHROME ?? "/usr/bin/chromium-headless-shell" });
const page = await browser.newPage();
await page.evaluate(`globalThis.draw = (${studio})(${JSON.stringify({ tube: TUBE, film: FILM })})`);
const output = fileURLToPath(new URL("tube.mp4", import.meta.url));
const encoding = "-c:v libx264 -profile:v high -preset veryslow -crf 24 -bf 0 -g 60 -pix_fmt yuv420p -movflags +faststart -map_metadata -1 -fflags +bitexact";
const encoder = spawn("ffmpeg", ["-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", String(FILM.rate), "-i", "-", ...encoding.split(" "), output], {
  stdio: ["pipe", "inherit", "inherit"],
});
for (let frame = 0; frame < FILM.rate * FILM.seconds; frame += 1) {
  const url = await page.evaluate((time) => globalThis.draw(time), frame / FILM.rate);
  const png = Buffer.from(url.slice(url.indexOf(",") + 1), "base64");
  if (!encoder.stdin.write(png)) await new Promise((done) => encoder.stdin.once("drain", done));
}
encoder.stdin.end();
await new Promise((done) => encoder.once("close", done));
await browser.close();
