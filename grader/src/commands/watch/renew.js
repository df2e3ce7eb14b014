// Asks for the page every second, and shows what has changed. What the reader has opened stays open.
let shown = null;
async function renew() {
  try {
    const text = await (await fetch(location.pathname, { cache: "no-store" })).text();
    if (shown !== null && text !== shown) {
      const open = [...document.querySelectorAll("details")].map(d => d.open);
      const page = new DOMParser().parseFromString(text, "text/html");
      document.title = page.title;
      document.body.replaceChildren(...page.body.childNodes);
      document.querySelectorAll("details").forEach((d, i) => { d.open = open[i] || false; });
    }
    shown = text;
  } catch {} // the watch has ended, or is not there yet
  setTimeout(renew, 1000);
}
renew();
