// A page of the book as slides for a projector: a heading with what fits below it, or a figure, on each screen. The slides are the page
// itself; what is not on the screen is hidden. They begin by the button "Slides", by the key p or with an address that ends in ?slides.
// Keys: → Space PageDown next, ← Backspace PageUp back, Home End, Enter opens and folds what is folded, f full screen, Esc back to the page.
(() => {
  "use strict";
  const main = document.querySelector("main"), root = document.documentElement;
  const ALONE = "figure:has(img, svg, canvas), .tabs, table"; // each has a screen of its own, below its heading and at most a few lines
  let screens = [], at = 0;

  // The parts of the page: its blocks, and each card of a gallery.
  const parts = () => [...main.children].flatMap(part => part.matches(".gallery") ? [...part.children] : [part]);

  // How much of a screen a part takes, in pixels.
  const height = part => part.getBoundingClientRect().height + 16;

  // Each screen is a list of the parts that it shows, its heading first.
  function cut() {
    const cuts = [];
    let headings = [], shown = [], taken = 0;
    const close = () => { if (shown.length) cuts.push([...headings, ...shown]); shown = []; taken = 0; };
    const free = () => innerHeight - headings.reduce((sum, heading) => sum + height(heading), 80);
    for (const part of parts()) {
      if (!height(part)) continue;
      const level = /^H[1-3]$/.test(part.tagName) && Number(part.tagName[1]);
      if (level) {
        close();
        headings = level === 1 ? [part] : [...headings.filter(heading => heading.tagName[1] > 1 && heading.tagName[1] < level), part];
      } else if (part.matches(ALONE)) {
        if (taken > innerHeight / 5) close();
        shown.push(part);
        close();
      } else {
        if (taken + height(part) > free()) close();
        shown.push(part);
        taken += height(part);
      }
    }
    close();
    return cuts;
  }

  // The screen is made as small as its contents need, down to two fifths; what is still longer, such as a long listing that was unfolded, is
  // scrolled. Lines break elsewhere on a smaller screen, so the size is found by halving.
  function fit() {
    const fits = zoom => {
      main.style.zoom = zoom;
      return root.scrollHeight <= innerHeight;
    };
    let small = 0.4, large = 1;
    if (fits(large)) return;
    while (large - small > 0.005) {
      const middle = (small + large) / 2;
      if (fits(middle)) small = middle;
      else large = middle;
    }
    fits(small);
  }

  function show(number) {
    at = Math.min(Math.max(number, 0), screens.length - 1);
    for (const part of main.querySelectorAll(".on")) part.classList.remove("on");
    for (const part of screens[at]) {
      part.classList.add("on");
      if (part.parentElement !== main) part.parentElement.classList.add("on");
      for (const picture of part.querySelectorAll("img[loading]")) picture.loading = "eager";
    }
    place.value = `${at + 1} / ${screens.length}`;
    scrollTo(0, 0);
    fit();
  }

  function start(from) {
    root.classList.add("slides", "measured");
    screens = cut();
    root.classList.remove("measured");
    show(Math.max(0, screens.findIndex(screen => screen.some(part => part.contains(from)))));
  }

  function end() {
    root.classList.remove("slides");
    main.style.zoom = "";
    screens[at].at(-1).scrollIntoView();
  }

  const running = () => root.classList.contains("slides");
  const visible = () => parts().find(part => part.getBoundingClientRect().bottom > 60);
  const other = (name, step) => {
    const link = document.querySelector(`a[rel~="${name}"]`);
    if (link) location = link.href.replace(/[?#].*/, "") + "?slides";
    else show(at + step);
  };
  const next = () => at + 1 < screens.length ? show(at + 1) : other("next", 0);
  const back = () => at > 0 ? show(at - 1) : other("prev", 0);
  const fold = () => {
    const folded = screens[at].filter(part => part.matches("details"));
    const one = folded.find(part => !part.open);
    for (const part of one ? [one] : folded) part.open = !part.open;
    fit();
  };
  const keys = {
    ArrowRight: next, PageDown: next, " ": next, ArrowLeft: back, PageUp: back, Backspace: back, Home: () => show(0), End: () => show(screens.length - 1),
    Enter: fold, Escape: end, f: () => document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen(),
  };
  // Before the book's own keys, of which the arrows turn pages.
  addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches?.("input:not([type=radio]), textarea, select")) return;
    if (event.target.matches?.("canvas") && event.key.startsWith("Arrow")) return; // they turn the live picture
    const act = running() ? keys[event.key] : event.key === "p" && (() => start(visible()));
    const pressed = event.target.closest?.("a, button, summary, label");
    if (!act || pressed && ["Enter", " "].includes(event.key)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    act();
  }, true);
  addEventListener("resize", () => { if (running()) start(screens[at].at(-1)); });
  main.addEventListener("toggle", () => { if (running()) fit(); }, true);
  main.addEventListener("load", () => { if (running()) fit(); }, true);
  document.fonts.addEventListener("loadingdone", () => { if (running()) fit(); }); // a formula's font comes when it is first shown

  const place = document.createElement("output");
  place.className = "slide-number";
  const button = document.createElement("button");
  button.className = "slides-button";
  button.type = "button";
  button.textContent = "Slides";
  button.title = "Slides for a projector (p)";
  button.addEventListener("click", () => { button.blur(); start(visible()); });
  document.body.append(place);
  document.querySelector(".right-buttons")?.prepend(button);
  if (/[?&]slides\b/.test(location.search)) document.fonts.ready.then(() => start(document.getElementById(decodeURIComponent(location.hash.slice(1))) ?? main.firstElementChild));
})();
