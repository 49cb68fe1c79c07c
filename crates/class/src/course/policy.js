// The page may ask the addresses of its launch, and no others.
const asked = ["endpoint", "fetch"].map((name) => {
  try {
    const { protocol, origin, pathname } = new URL(new URLSearchParams(location.search).get(name));
    return /^https?:$/.test(protocol) ? origin + pathname.replace(/[;,]/g, encodeURIComponent) : "";
  } catch {
    return "";
  }
});
const meta = { httpEquiv: "Content-Security-Policy", content: `${policy}; connect-src ${asked.join(" ").trim() || "'none'"}` };
document.head.append(Object.assign(document.createElement("meta"), meta));
