// Asks for the page every second, and shows what has changed. What the reader has opened, chosen or entered stays so.
let shown = null;

function show(text) {
  const opened = [...document.querySelectorAll("details[open]")].map(one => one.id), focused = document.activeElement.id;
  const entered = [...document.querySelectorAll("input")].map(({ id, checked, value }) => [id, checked, value]);
  const page = new DOMParser().parseFromString(text, "text/html");
  document.title = page.title;
  document.head.querySelector("style")?.remove();
  document.head.append(...page.querySelectorAll("style"));
  document.body.replaceChildren(...page.body.childNodes);
  document.querySelectorAll(".pictures").forEach(liven);
  for (const one of opened.map(id => document.getElementById(id)).filter(Boolean)) one.open = true;
  for (const [id, checked, value] of entered) {
    const one = document.getElementById(id);
    if (!one) continue;
    [one.checked, one.value] = [checked, value];
    if (one.type !== "radio") one.dispatchEvent(new Event("input"));
  }
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
