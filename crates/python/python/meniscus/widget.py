"""The player of a document in a notebook."""

try:
    import anywidget
    import traitlets
except ImportError as error:
    raise ImportError("the widget needs anywidget: pip install anywidget") from error

# The page runs in a frame of its own: it has a style and keys of its own, and reaches nothing of the notebook.
_CODE = """
const asText = (values) => JSON.stringify(Object.entries(values).sort());

function render({ model, el }) {
  const frame = document.createElement("iframe");
  frame.title = model.get("title");
  frame.setAttribute("sandbox", "allow-scripts allow-downloads");
  frame.style.cssText = "width: 100%; border: 0; display: block";
  const grow = () => { frame.style.height = `${model.get("height")}px`; };
  let heard = "";
  const tell = () => {
    const parameters = model.get("parameters");
    if (asText(parameters) !== heard) frame.contentWindow?.postMessage({ meniscus: { parameters } }, "*");
  };
  const hear = ({ source, data }) => {
    const parameters = data?.meniscus?.parameters;
    if (source !== frame.contentWindow || !parameters) return;
    heard = asText(parameters);
    if (heard === asText(model.get("parameters"))) return;
    model.set("parameters", parameters);
    model.save_changes();
  };
  // The player is there some time after its frame: it is asked until it answers.
  const ask = setInterval(() => { if (heard) clearInterval(ask); else tell(); }, 50);
  window.addEventListener("message", hear);
  model.on("change:parameters", tell);
  model.on("change:height", grow);
  grow();
  frame.srcdoc = model.get("_page");
  el.append(frame);
  return () => {
    clearInterval(ask);
    window.removeEventListener("message", hear);
    model.off("change:parameters", tell);
    model.off("change:height", grow);
  };
}

export default { render };
"""


class DocumentWidget(anywidget.AnyWidget):
    """A document that plays in a notebook.

    ``parameters`` has the values of all parameters by name, numbers in declared units. It follows the sliders, and the sliders follow
    it: assign a dictionary with the values to be changed, or call ``set``.
    """

    _esm = _CODE
    _page = traitlets.Unicode().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)
    height = traitlets.Int(640).tag(sync=True)
    parameters = traitlets.Dict().tag(sync=True)

    def set(self, **values):
        """Changes some parameters."""
        self.parameters = {**self.parameters, **values}
