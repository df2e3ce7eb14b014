// Looks at pages in Chromium. Called by `tests/pages`: Chromium's file, the address of a watch, the file that is wrong in it, that file without the
// mistake, a folder for pictures (or nothing), and more addresses or files.
import puppeteer from "puppeteer-core";
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";

const [chromium, watch, wrong, right, shots, ...others] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const faults = [];
const browser = await puppeteer.launch({ executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"] });

// A window on an address, whose console is listened to.
async function open(address, width, scheme, height = 900) {
  const page = await browser.newPage(), where = `${address.split("/").slice(-2).join("/")} at ${width} pixels, ${scheme}`;
  const fault = what => faults.push(`${where}: ${what}`);
  page.on("console", said => ["error", "warn"].includes(said.type()) && fault(`console: ${said.text()}`));
  page.on("pageerror", error => fault(`script: ${error.message}`));
  page.on("requestfailed", request => fault(`not loaded: ${request.url()}`));
  await page.setBypassCSP(true); // or axe could not be run in a page that runs its own script only
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  await page.goto(address, { waitUntil: "load", timeout: 120_000 });
  return { page, fault };
}

// What is seriously wrong with a page as it is now.
async function examine({ page, fault }, name) {
  await page.evaluate(axe);
  // Without preload: axe would ask for the style sheets again, which a browser refuses to a page that is a file.
  const { violations } = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"], preload: false }));
  for (const { id, impact, nodes } of violations.filter(one => ["serious", "critical"].includes(one.impact)))
    fault(`${impact} ${id}: ${nodes.length} times, first ${nodes[0].html.slice(0, 160)} (${nodes[0].any.concat(nodes[0].all)[0]?.message ?? ""})`);
  const [inside, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  if (inside > window) fault(`the page is ${inside} pixels wide in a window of ${window}`);
  const small = await page.evaluate(() => [...document.querySelectorAll("figure > svg :is(text, tspan)")]
    .map(word => [word.textContent, parseFloat(getComputedStyle(word).fontSize) * word.ownerSVGElement.getScreenCTM().a]).filter(([, pixels]) => pixels < 11));
  if (small.length) fault(`${small.length} words of drawings are less than 11 pixels high: "${small[0][0]}" has ${small[0][1].toFixed(1)}`);
  if (shots) {
    mkdirSync(shots, { recursive: true });
    await page.screenshot({ path: `${shots}/${name}.png`, fullPage: inside <= window && name.startsWith("watch") });
  }
}

const views = [1400, 420].flatMap(width => ["light", "dark"].map(scheme => [width, scheme]));
for (const other of others) {
  const address = other.startsWith("http") ? other : pathToFileURL(other).href;
  for (const [width, scheme] of views) {
    const view = await open(address, width, scheme);
    if (address.startsWith("http")) await view.page.waitForSelector("img[src]", { timeout: 60_000 });
    const name = decodeURIComponent(address).replace(/^.*\/(book|tour|class|samplers|drawing)\//, "$1-").replace(/^.*\//, "").replace(/[#.].*/, "");
    await examine(view, `${address.startsWith("http") ? "present" : name}-${width}-${scheme}`);
    await view.page.close();
  }
}

// The page of a watch, by the keyboard alone.
const check = (right, what) => right || faults.push(`watch: ${what}`);
for (const [width, scheme] of views) {
  const view = await open(watch, width, scheme), { page } = view;
  await page.waitForSelector("#sphere_hit-0-row", { timeout: 120_000 });
  const output = () => page.$eval("output", one => one.textContent), number = name => page.$eval(`#sphere_hit-0-${name}`, one => Number(one.value));
  await page.waitForFunction(() => document.querySelector("output").textContent.includes("the right one"));
  const [x, y] = [await number("x"), await number("y")];
  check((await output()).startsWith("yours: "), `the first wrong pixel is looked at, and told: ${await output()}`);
  await page.focus("#sphere_hit-0-row");
  for (const key of ["ArrowRight", "ArrowRight", "ArrowDown", "ArrowLeft"]) await page.keyboard.press(key);
  check(await number("x") === x + 1 && await number("y") === y + 1, "arrow keys move the pixel");
  await page.focus("#sphere_hit-0-difference");
  await page.keyboard.press("ArrowRight");
  check(await page.$eval("#sphere_hit-0-slider", one => one.checked), "arrow keys choose the slider");
  await page.focus("#sphere_hit-0-cut");
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
  check(await page.$eval("#sphere_hit-0", one => one.style.getPropertyValue("--cut")) === "55%", "arrow keys move the slider");
  await page.focus("#sphere_hit-0-explain");
  await page.keyboard.press("Enter");
  await page.waitForSelector("[aria-live] pre", { timeout: 60_000 });
  const told = await page.$eval("[aria-live]", one => one.textContent);
  check(told.includes(`the pixel in column ${x + 1} of row ${y + 1}`), `the pixel is explained: ${told.slice(0, 200)}`);
  await examine(view, `watch-${width}-${scheme}`);
  await page.close();
}

// The page of `raybook present`, by the keyboard: its own size or the window's, more room, and the same state after a reload.
const presents = others.find(other => other.startsWith("http"));
if (presents) {
  const { page, fault } = await open(presents.replace(/#.*/, "#ch22_antialiasing/zone_plates"), 1280, "dark", 720);
  const right = (is, what) => is || fault(what);
  const drawn = () => page.waitForFunction(() => document.getElementById("picture").naturalWidth && !document.getElementById("status").textContent, { timeout: 120_000 });
  const isExact = () => page.$eval("#picture", one => one.getBoundingClientRect().width === one.naturalWidth);
  const press = async key => { await page.keyboard.press(key); await page.evaluate(() => new Promise(requestAnimationFrame)); };
  const count = () => page.$eval("#count", one => one.textContent), isHidden = id => page.$eval(id, one => one.hidden);
  await drawn();
  right(await isExact(), "rings are not scaled");
  await press("1");
  right(!await isExact(), "the key 1 scales them");
  for (const [key, id] of [["c", "#words"], ["k", "#knobs"], ["b", "#black"]]) {
    const before = await isHidden(id);
    await press(key);
    right(await isHidden(id) !== before, `the key ${key} works`);
    await press(key);
    right(await isHidden(id) === before, `the key ${key} works again`);
  }
  await page.focus("[data-knob=pattern]");
  await page.select("[data-knob=pattern]", "halton");
  await page.waitForFunction(() => location.hash.endsWith("?pattern=halton"));
  await drawn();
  const before = await count();
  await page.reload();
  await drawn();
  const command = await page.$eval("#command", one => one.textContent);
  right(await count() === before && command.endsWith("--picture picture --pattern halton"), `a reload keeps picture and knob: ${command}`);
  right(await page.$eval("[data-knob=pattern]", one => one.value) === "halton", "the knob shows its value");
  await press("r");
  right(!(await page.$eval("#command", one => one.textContent)).includes("halton"), "the key r turns the knob back");
  await page.close();
}
// The sampling lab: a heading sorts, a key flips, no picture is scaled, and nothing is to be scrolled sideways in a wide window.
const lab = others.find(other => other.endsWith("samplers/index.html"));
if (lab) {
  const { page, fault } = await open(pathToFileURL(lab).href, 1400, "light");
  const right = (is, what) => is || fault(what);
  const column = i => page.$$eval("tbody tr", (rows, i) => rows.map(row => row.children[i].dataset.value ?? row.children[i].textContent), i);
  const sorted = (all, order) => all.every((one, i) => i === 0 || order(all[i - 1], one) <= 0);
  const headings = await page.$$("th button");
  await headings[1].click();
  right(sorted(await column(1), (a, b) => a - b), `a click sorts by the numbers: ${await column(1)}`);
  await headings[1].click();
  right(sorted(await column(1), (a, b) => b - a), "another click sorts the other way round");
  await headings[0].focus();
  await page.keyboard.press("Enter");
  right(sorted(await column(0), (a, b) => a.localeCompare(b)), `a key sorts by the names: ${await column(0)}`);
  const shown = () => page.$eval(".flip", flip => [flip.querySelector("output").textContent, flip.querySelector("img").src].join(" "));
  const [a, b] = [await shown(), (await page.keyboard.press("f"), await shown())];
  right(a.startsWith("A: ") && b.startsWith("B: ") && a !== b, `the key f flips: ${a}, ${b}`);
  const scaled = await page.evaluate(async () => {
    const images = [...document.querySelectorAll(".pixels img")];
    for (const image of images) image.loading = "eager";
    await Promise.all(images.map(image => image.decode()));
    return images.filter(image => image.getBoundingClientRect().width !== image.naturalWidth).length;
  });
  right(scaled === 0, `${scaled} pictures of pixels are scaled`);
  const cut = await page.$$eval(".pixels, .scroll", all => all.filter(one => one.scrollWidth > one.clientWidth).length);
  right(cut === 0, `${cut} figures are wider than a window of 1400 pixels`);
  await page.close();
}
const { page } = await open(watch, 1400, "light");
await page.waitForSelector("#sphere_hit-0-row", { timeout: 120_000 });
await page.evaluate(() => { window.same = true; });
await page.click("#sphere_hit-0-slider");
copyFileSync(right, wrong);
await page.waitForFunction(() => document.body.textContent.includes("sphere_hit: right"), { timeout: 120_000 });
check(await page.evaluate(() => window.same), "the page is renewed without being loaded again");
check(await page.$eval("#sphere_hit-0-slider", one => one.checked), "what was chosen stays");

// All lessons of the book as slides, by the keyboard alone: every part of a page is on one screen, and no screen is larger than the window.
const book = others.filter(other => /\/book\/book\//.test(other)).map(dirname)[0];
const lessons = book ? readdirSync(book).filter(name => /^ch\d/.test(name)).map(name => join(book, name)) : [];
for (const lesson of lessons) {
  const { page, fault } = await open(`${pathToFileURL(lesson).href}?slides`, 1280, "light", 720);
  await page.waitForSelector(".slides");
  const screens = Number((await page.$eval(".slide-number", one => one.value)).split(" / ")[1]);
  await page.evaluate(() => { window.shown = new Map(); });
  for (let screen = 1; screen <= screens; screen++) {
    await page.waitForFunction(() => [...document.querySelectorAll("main .on img")].every(image => image.complete || !image.checkVisibility()));
    // A picture or a font that came is fitted in the next frames, or a little later on a busy machine.
    await page.evaluate(() => new Promise(drawn => requestAnimationFrame(() => requestAnimationFrame(drawn))));
    await page.waitForFunction(() => document.documentElement.scrollHeight <= innerHeight, { timeout: 3_000 }).catch(() => {});
    const wrong = await page.evaluate(screen => {
      for (const part of document.querySelectorAll("main .on")) window.shown.set(part, [...window.shown.get(part) ?? [], screen]);
      const { scrollWidth, scrollHeight } = document.documentElement, over = [scrollWidth - innerWidth, scrollHeight - innerHeight];
      if (!document.querySelector(".slide-number").value.startsWith(`${screen} / `)) return "another number";
      return over.some(pixels => pixels > 0) && `${over[0]} pixels too wide, ${over[1]} too high`;
    }, screen);
    if (wrong) fault(`slide ${screen}: ${wrong}`);
    if (screen < screens) await page.keyboard.press("ArrowRight");
  }
  const lost = await page.evaluate(() => [...document.querySelectorAll("main > :not(.gallery), .gallery > *")]
    .filter(part => part.textContent.trim() && (window.shown.get(part)?.length ?? 0) !== 1 && !/^H[1-3]$/.test(part.tagName)).map(part => part.outerHTML.slice(0, 80)));
  if (lost.length) fault(`${lost.length} parts are on no slide, or on several: ${lost[0]}`);
  await page.keyboard.press("Home");
  if (!(await page.$eval(".slide-number", one => one.value)).startsWith("1 / ")) fault("Home does not lead to the first slide");
  await page.keyboard.press("Escape");
  if (await page.$eval("html", one => one.classList.contains("slides"))) fault("Escape does not lead back to the page");
  await page.close();
}
// Who searches the book for a word of the field is led to a lesson first, or to this very term of the glossary.
for (const word of book ? ["AABB", "aliasing", "radiance", "bounding box", "SAH", "pdf", "BRDF", "Fresnel", "unbiased", "MIS", "area light"] : []) {
  const { page, fault } = await open(`${pathToFileURL(join(book, "introduction.html")).href}?search=${encodeURIComponent(word)}`, 1280, "light");
  const first = "#mdbook-searchresults li a";
  await page.waitForSelector(first, { timeout: 60_000 });
  const found = await page.$eval(first, one => one.getAttribute("href"));
  if (!/^(ch\d|radiometry|monte_carlo|glossary\.html.*#)/.test(found)) fault(`a search for "${word}" leads to ${found} first`);
  await page.close();
}
// The live picture of chapter 24, where the book was built with it: it draws, also by the other kernel, is turned by keys and by a drag, and
// comes to rest.
const wide = lessons.find(lesson => lesson.endsWith("ch24_wide_bvh.html"));
if (wide && existsSync(join(book, "theme/module.js"))) {
  for (const [width, scheme] of views) {
    const view = await open(pathToFileURL(wide).href, width, scheme), { page, fault } = view;
    await page.click(".live .begin");
    await page.waitForSelector(".live canvas", { timeout: 60_000 });
    const shot = async () => (await (await page.$(".live canvas")).screenshot({ captureBeyondViewport: false })).toString("base64");
    const state = () => page.$eval(".kernels .state", one => one.textContent);
    const speed = i => page.$$eval(".kernels output", (all, i) => Number(all[i].textContent), i);
    const begun = () => page.waitForFunction(() => /^[1-9]/.test(document.querySelector(".kernels .state").textContent), { timeout: 60_000 });
    const turns = () => new Promise(later => setTimeout(later, 1_000)); // a glance, and then another picture is begun
    await begun();
    await examine(view, `live-${width}-${scheme}`);
    if (!(await speed(0) > 0)) fault("the live picture tells no speed");
    const turned = [await shot()];
    await page.focus(".live canvas");
    await page.keyboard.press("ArrowLeft");
    await turns();
    await begun();
    turned.push(await shot());
    const { x, y, width: across, height } = await (await page.$(".live canvas")).boundingBox();
    await page.mouse.move(x + across / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + across / 4, y + height / 2, { steps: 4 });
    await page.mouse.up();
    await turns();
    await begun();
    turned.push(await shot());
    if (new Set(turned).size < turned.length) fault("the live picture is not turned by a key and a drag");
    if (!page.url().endsWith("ch24_wide_bvh.html")) fault("a key of the live picture turned the page");
    await (await page.$$(".kernels input"))[1].click();
    await page.waitForFunction(() => Number(document.querySelectorAll(".kernels output")[1].textContent) > 0, { timeout: 60_000 });
    if (width === views[0][0] && scheme === views[0][1]) {
      await (await page.$$(".kernels input"))[0].click();
      await page.waitForFunction(() => document.querySelector(".kernels .state").textContent === "64 of 64 samples a pixel", { timeout: 300_000 });
      await turns();
      if (!(await state()).startsWith("64 ")) fault(`the live picture does not rest: ${await state()}`);
    }
    await page.close();
  }
}
await browser.close();

for (const fault of new Set(faults)) console.error(fault);
console.log(`${others.length + 1} pages, ${views.length} views each: ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
