// The page of `raybook present`: steps through the pictures, and turns the knobs.
const at = id => document.getElementById(id);
let course = [], chapter = 0, screen = 0, screens = [], complete = false, later = null, turned = {}, shown = "", wanted = 0, timer = 0;
const asked = new Map();

/** Asks for something, again and again while it is wanted and another drawing is in the way. */
async function ask(path, turn = wanted, patience = 300) {
  const answer = await fetch(path);
  if (answer.status === 202) { // somebody wanted another picture: here, or in another window
    await new Promise(later => setTimeout(later, patience * (1 + Math.random())));
    return turn === wanted ? ask(path, turn, Math.min(2 * patience, 8000)) : null;
  }
  if (!answer.ok) throw new Error(await answer.text());
  return answer;
}

/** Tells twice a second how far the drawing is, as long as there is one: in per cent, or for how many seconds it goes on. */
async function tell(since = null) {
  let share = "";
  const words = at("status").textContent, begin = words.startsWith("drawing") ? since ?? Date.now() : null;
  if (begin !== null && Date.now() - begin > 900) {
    const known = await fetch("progress.json").then(answer => answer.json()).catch(() => ({}));
    share = known.share > 0 ? Math.floor(100 * known.share) + " %" : Math.round((Date.now() - begin) / 1000) + " s";
  }
  at("share").textContent = at("status").textContent === words ? share : "";
  setTimeout(tell, 500, begin);
}

function fail(error) { at("status").textContent = error.message.split("\n")[0]; }

/** Shows a chapter, at its first picture, its last (-1), or the one of a name, with knobs that are turned. */
async function open(number, which = 0, set = {}) {
  chapter = Math.max(0, Math.min(course.length - 1, number));
  turned = set; shown = ""; screens = []; complete = false; later = null;
  const turn = ++wanted, { name, number: n, title, teaches } = course[chapter];
  at("note").textContent = "";
  at("chapters").value = chapter;
  at("count").textContent = ""; at("caption").textContent = teaches; at("status").textContent = "drawing …";
  at("picture").removeAttribute("src");
  knobs();
  try {
    const answer = await ask("screens/" + name + (which === 0 ? "?first=1" : ""));
    if (!answer || turn !== wanted) return;
    ({ screens, all: complete } = await answer.json());
    const found = screens.findIndex(one => one.name === which);
    screen = found >= 0 ? found : which === -1 ? screens.length - 1 : 0;
    document.title = n + " " + title;
    show();
  } catch (error) { fail(error); }
}

/** Asks for the rest of the chapter's pictures, of which the first is shown already. */
async function rest(turn) {
  if (complete) return;
  const answer = await ask("screens/" + course[chapter].name);
  if (!answer || turn !== wanted) return;
  ({ screens, all: complete } = await answer.json());
  at("count").textContent = screen + 1 + " / " + screens.length;
  if (later) later();
}

/** The picture on the screen, as part of an address. */
const place = () => course[chapter].name + "/" + screens[screen].name;

/** The knobs that are turned, as part of an address. */
const query = () => new URLSearchParams(turned).toString();

/** The bytes of a small version of the picture on the screen, with knobs as in this part of an address. */
async function sketch(knobs, turn) {
  const path = "picture/" + course[chapter].name + "/" + screens[screen].name + "?quick=1&fresh=1&" + knobs;
  const answer = await ask(path, turn);
  return answer && String(new Uint8Array(await answer.arrayBuffer()));
}

/** Shows what a knob changes: the picture on the screen, or else the knob's own. */
async function follow(knob) {
  at("note").textContent = "";
  if (query() !== shown && screens[screen].name !== knob.picture) {
    const turn = ++wanted;
    at("status").textContent = "drawing …";
    try {
      const before = await sketch(shown, turn), now = await sketch(query(), turn);
      if (before === now) await rest(turn);
      if (turn !== wanted) return;
      const own = screens.findIndex(one => one.name === knob.picture);
      if (before === now && own >= 0) {
        screen = own;
        at("note").textContent = knob.name.replaceAll("-", " ") + " is a knob of picture " + (own + 1) + ", which is shown now";
      }
    } catch (error) { if (turn === wanted) fail(error); return; }
  }
  show();
}

/** Shows the picture: at first what is quick, then what is good. */
async function show() {
  const turn = ++wanted, { name, caption } = screens[screen], { name: of } = course[chapter];
  // Who keeps this address comes back to this picture.
  history.replaceState(null, "", "#" + place() + (query() && "?" + query()));
  at("count").textContent = screen + 1 + " / " + (complete ? screens.length : "…");
  at("caption").textContent = caption;
  at("picture").alt = caption;
  const words = Object.entries(turned);
  at("command").textContent = course[chapter].command + " --picture " + name + words.map(([knob, value]) => " --" + knob + " " + value).join("");
  shown = query();
  at("status").textContent = "drawing …";
  try {
    for (const quick of words.length ? ["quick=1", "half=1", ""] : ["quick=1", ""]) {
      if (!quick && !words.length) await rest(turn);
      if (turn !== wanted) return;
      const answer = await ask("picture/" + of + "/" + name + "?" + [shown, quick].filter(Boolean).join("&"));
      if (!answer || turn !== wanted) return;
      const said = answer.headers.get("Caption"); // a knob may change what there is to say
      if (said) at("caption").textContent = decodeURIComponent(said);
      const picture = URL.createObjectURL(await answer.blob()), before = at("picture").src;
      at("picture").src = picture;
      at("picture").onload = size;
      at("picture").className = quick.split("=")[0];
      if (quick === "half=1") at("status").textContent = "drawing in full …";
      if (before.startsWith("blob:")) URL.revokeObjectURL(before);
    }
    at("status").textContent = "";
    await rest(turn);
  } catch (error) { if (turn === wanted) fail(error); }
}

/** Whether the picture on the screen is shown pixel by pixel: as the key has said for it, or else as it must be. */
const isExact = () => asked.get(place()) ?? course[chapter].unscaled.includes(screens[screen].name);

/** Gives the picture its size: one screen pixel for each of its pixels, or the size of the window. */
function size() {
  const picture = at("picture"), exact = isExact() && picture.className === "";
  document.body.classList.toggle("exact", exact);
  picture.style.width = exact ? picture.naturalWidth / devicePixelRatio + "px" : "";
  const { parentElement: place } = picture, isCut = place.scrollWidth > place.clientWidth || place.scrollHeight > place.clientHeight;
  if (exact && isCut) at("note").textContent = CUT; else if (at("note").textContent === CUT) at("note").textContent = "";
}
const CUT = "pixel by pixel, and larger than its place: k and c make room, 1 scales it";

/** Shows a part of the page, or hides it. */
function toggle(id) { at(id).hidden = !at(id).hidden; if (screens.length) size(); }
addEventListener("resize", () => screens.length && size());

function step(by) {
  at("note").textContent = "";
  const next = screen + by;
  if (!complete && next >= screens.length) { later = () => { later = null; step(by); }; return; }
  if (next >= 0 && next < screens.length) { screen = next; show(); }
  else if (next < 0 && chapter > 0) open(chapter - 1, -1);
  else if (next >= screens.length && chapter + 1 < course.length) open(chapter + 1);
}

/** The chapter's knobs: what is turned is drawn as soon as the hand rests for a moment. */
function knobs() {
  const panel = at("knobs");
  panel.replaceChildren();
  for (const knob of course[chapter].knobs) {
    const label = document.createElement("label"), name = document.createElement("b"), value = document.createElement("output");
    const help = document.createElement("small"), input = document.createElement(knob.kind === "choice" ? "select" : "input");
    name.textContent = knob.name.replaceAll("-", " ");
    const own = knob.picture === "picture" ? "" : " (picture “" + knob.picture.replaceAll("_", " ") + "”)";
    help.textContent = knob.help + own;
    const unit = knob.unit ? (knob.unit === "°" ? "°" : " " + knob.unit) : "";
    if (knob.kind === "choice") {
      if (knob.default === null) input.append(new Option("as it is", ""));
      for (const word of knob.words) input.append(new Option(word, word));
      input.set = value => input.value = value ?? "";
    } else {
      // Where the range goes over decades from above zero, so does the slider.
      const decades = knob.least > 0 && knob.most / knob.least > 50, whole = Number.isInteger(knob.least) && Number.isInteger(Number(knob.default ?? .5)) && knob.most - knob.least > 2;
      const onto = v => decades ? Math.log(v / knob.least) / Math.log(knob.most / knob.least) : (v - knob.least) / (knob.most - knob.least);
      const from = s => {
        const v = decades ? knob.least * (knob.most / knob.least) ** s : knob.least + s * (knob.most - knob.least);
        const rounded = whole ? Math.round(v) : Number(v.toPrecision(3));
        return Math.min(knob.most, Math.max(knob.least, rounded));
      };
      Object.assign(input, { type: "range", min: 0, max: 1, step: .002 });
      input.set = value => input.value = value === null ? 1 : onto(Number(value));
      input.read = () => from(Number(input.value));
    }
    const without = knob.instead.length ? "by " + knob.instead.join(", ").replaceAll("-", " ") : "as it is";
    const say = () => value.textContent = knob.kind === "choice" ? "" : (turned[knob.name] ?? knob.default ?? without) + (turned[knob.name] ?? knob.default ? unit : "");
    input.addEventListener("input", () => {
      const read = String(input.read ? input.read() : input.value);
      if (read === "" || read === knob.default) delete turned[knob.name]; else turned[knob.name] = read;
      // Of two knobs that exclude each other, the one that is turned counts.
      for (const other of knob.instead) { delete turned[other]; panel.querySelector(`[data-knob="${other}"]`).reset(); }
      say();
      clearTimeout(timer);
      timer = setTimeout(() => screens.length && follow(knob), 120);
    });
    // After the mouse, keys step again; who came by keyboard goes on by keyboard.
    input.addEventListener(knob.kind === "choice" ? "change" : "pointerup", () => input.blur());
    input.dataset.knob = knob.name;
    input.reset = () => { input.set(knob.default); say(); };
    input.set(turned[knob.name] ?? knob.default);
    say();
    label.append(name, value, input, help);
    panel.append(label);
  }
}

const keys = {
  ArrowRight: () => step(1), " ": () => step(1), PageDown: () => step(1), ArrowLeft: () => step(-1), PageUp: () => step(-1),
  ArrowDown: () => open(chapter + 1), ArrowUp: () => open(chapter - 1),
  Home: () => { if (screens.length) { screen = 0; show(); } },
  End: () => { if (screens.length) { screen = screens.length - 1; show(); } },
  b: () => at("black").hidden = !at("black").hidden, ".": () => keys.b(),
  f: () => document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen(),
  k: () => toggle("knobs"), c: () => toggle("words"),
  1: () => { if (screens.length) { asked.set(place(), !isExact()); size(); } },
  r: () => { turned = {}; knobs(); if (screens.length) show(); },
  "?": () => at("keys").open ? at("keys").close() : at("keys").showModal(),
};
addEventListener("keydown", event => {
  const inside = event.target.closest("input, select, dialog, button");
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "Escape") { document.activeElement.blur(); return; }
  if (inside && !["b", "f", "k", "c", "1", "?"].includes(event.key)) return;
  const act = keys[event.key];
  if (act) { event.preventDefault(); act(); }
});
at("black").addEventListener("click", keys.b);
at("help").addEventListener("click", () => { at("help").blur(); keys["?"](); });
at("chapters").addEventListener("change", event => { event.target.blur(); open(Number(event.target.value)); });

tell();
ask("course.json").then(answer => answer.json()).then(all => {
  course = all;
  all.forEach(({ number, title }, i) => at("chapters").append(new Option(number + "  " + title, i)));
  const go = () => {
    const [where, set] = location.hash.slice(1).split("?"), [name, picture] = where.split("/");
    open(Math.max(0, all.findIndex(one => one.name === name)), picture, Object.fromEntries(new URLSearchParams(set)));
  };
  addEventListener("hashchange", go);
  go();
}).catch(fail);
