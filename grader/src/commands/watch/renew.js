// Asks for the page every second, and shows what has changed. What the reader has opened or chosen stays so.
let shown = null;

function show(text) {
  const kept = [...document.querySelectorAll("details[open], input:checked")].map(one => one.id), focused = document.activeElement.id;
  const page = new DOMParser().parseFromString(text, "text/html");
  document.title = page.title;
  document.head.querySelector("style")?.remove();
  document.head.append(...page.querySelectorAll("style"));
  document.body.replaceChildren(...page.body.childNodes);
  for (const one of kept.map(id => document.getElementById(id)).filter(Boolean)) one[one.tagName === "DETAILS" ? "open" : "checked"] = true;
  if (focused) document.getElementById(focused)?.focus({ preventScroll: true });
}

async function renew() {
  try {
    const text = await (await fetch(location.pathname, { cache: "no-store" })).text();
    if (text !== shown) show(text);
    shown = text;
  } catch {} // the watch has ended
  setTimeout(renew, 1000);
}
renew();
