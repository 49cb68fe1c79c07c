
{
  const { worker, module, text } = document.currentScript.dataset;
  const isOnline = location.protocol !== "file:";
  // The module is loaded beside the scripts. From a disk nothing is loaded ahead: its browser would refuse.
  if (module) {
    const part = Object.assign(document.createElement("link"), { id: "module", href: module });
    part.dataset.text = text;
    if (isOnline) Object.assign(part, { rel: "preload", as: "fetch", crossOrigin: "" });
    document.head.append(part);
  }
  // The service worker keeps the files of the site for visits without a network. It begins when the page has been loaded.
  if (navigator.serviceWorker && isOnline) {
    addEventListener("load", () => navigator.serviceWorker.register(worker).catch(console.warn));
  }
}
