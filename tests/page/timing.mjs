// What the measurements of the page have in common.

export const median = (values) => values.toSorted((one, other) => one - other)[Math.floor(values.length / 2)];

/** Opens the page: milliseconds from the start of the navigation until the button `play` can be pressed. */
export async function usableAfter(page, address, play = "#play") {
  await page.addInitScript((play) => {
    new MutationObserver((_, observer) => {
      const button = document.querySelector(play);
      if (!button || button.disabled) return;
      observer.disconnect();
      window.usableAfter = performance.now();
    }).observe(document, { childList: true, subtree: true });
  }, play);
  await page.goto(address, { timeout: 120_000 });
  await page.locator(play).first().waitFor({ timeout: 120_000 });
  return page.evaluate(() => window.usableAfter);
}

/** How many frames the browser makes in so many seconds. */
export function framesIn(page, seconds) {
  return page.evaluate(async (seconds) => {
    const end = performance.now() + seconds * 1000;
    let count = 0;
    while (performance.now() < end) {
      await new Promise(requestAnimationFrame);
      count += 1;
    }
    return count;
  }, seconds);
}
