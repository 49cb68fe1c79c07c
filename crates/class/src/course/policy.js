// The page may ask the addresses of its launch, and no others. A path that ends in a slash, as that of the store, allows all below it.
const asked = [["endpoint", "/"], ["fetch", ""]].map(([name, end]) => {
  try {
    const { protocol, origin, pathname } = new URL(new URLSearchParams(location.search).get(name));
    const path = end ? pathname.replace(/\/?$/, end) : pathname;
    return /^https?:$/.test(protocol) ? origin + path.replace(/[;,]/g, encodeURIComponent) : "";
  } catch {
    return "";
  }
});
const meta = { httpEquiv: "Content-Security-Policy", content: `${policy}; connect-src ${asked.join(" ").trim() || "'none'"}` };
document.head.append(Object.assign(document.createElement("meta"), meta));
