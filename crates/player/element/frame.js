// Begins the page in the frame of an element. Its animation frames are held while the element is out of sight, and their time
// stands still.
{
  const ask = requestAnimationFrame.bind(window);
  let held;
  let away = 0;
  let since = 0;
  globalThis.requestAnimationFrame = (draw) => ask((now) => (held ? held.push(draw) : draw(now - away)));
  frameElement.hold = (isHeld) => {
    if (isHeld === Boolean(held)) return;
    const waiting = held ?? [];
    held = isHeld ? [] : undefined;
    if (isHeld) since = performance.now();
    else away += performance.now() - since;
    for (const draw of waiting) requestAnimationFrame(draw);
  };
}
