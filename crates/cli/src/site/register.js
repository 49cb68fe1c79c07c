
// The service worker keeps the files of the site for visits without a network. It begins when the page has been loaded.
{
  const worker = document.currentScript.dataset.worker;
  if (navigator.serviceWorker && location.protocol !== "file:") {
    addEventListener("load", () => navigator.serviceWorker.register(worker).catch(console.warn));
  }
}
