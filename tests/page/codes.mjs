// QR codes on a page, as a telephone reads them.

import { createRequire } from "node:module";

const jsQR = createRequire(import.meta.url)("jsqr");

/** What a telephone reads in the code on the page. */
export async function readCode(page) {
  const svg = await page.locator(".qr svg").evaluate((svg) => svg.outerHTML);
  const { width, data } = await page.evaluate(async (svg) => {
    const image = new Image();
    image.src = `data:image/svg+xml;base64,${btoa(svg)}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const paper = canvas.getContext("2d");
    paper.drawImage(image, 0, 0);
    return { width: image.width, data: [...paper.getImageData(0, 0, image.width, image.height).data] };
  }, svg);
  return jsQR(new Uint8ClampedArray(data), width, width)?.data;
}
