// Reads one stream of messages from the server until it ends. `open` asks for it with a signal that ends it, `take` gets the data of each
// message; `goes` is asked after each piece whether to go on. Returns the status of the answer, and true as `heard` if anything
// came: a proxy may keep streams back.
const readStream = async (open, take, goes = () => true) => {
  // Longest silence before the first piece, and after it: the server sends a piece every 15 s at least. Measured by the clock,
  // which goes on while the computer sleeps: its connections may be dead then.
  const FIRST = 4000, LATER = 40000, LOOK = 500;
  const stream = new AbortController();
  let heard = false, status = 0, last = Date.now();
  const watch = setInterval(() => { if (Math.abs(Date.now() - last) > (heard ? LATER : FIRST)) stream.abort(); }, LOOK);
  try {
    const response = await open(stream.signal);
    status = response.status;
    if (status === 401) return { heard, status };
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    let rest = "";
    for (;;) {
      const { value, done } = await reader.read();
      if (done) break;
      [heard, last] = [true, Date.now()];
      const messages = (rest + value).split("\n\n");
      rest = messages.pop();
      for (const message of messages) {
        const data = message.split("\n").find((line) => line.startsWith("data: "));
        if (data) take(data.slice(6));
      }
      if (!goes()) { stream.abort(); break; }
    }
  } catch { /* It is tried again. */ }
  finally { clearInterval(watch); }
  return { heard, status };
};
