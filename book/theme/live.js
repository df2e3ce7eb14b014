// The live picture of chapter 24: the reader's browser draws what the still picture shows, by the course's own library in WebAssembly
// (book/live). It is loaded when the reader presses the button. book/build links this script into the lesson's page only, and only where the
// module was built; without it, or without a script, the still picture stands alone.
(() => {
  "use strict";
  const figure = document.getElementById("figure-picture"), still = figure?.querySelector("a"), image = still?.firstElementChild;
  if (!still || !("DecompressionStream" in window) || !("WebAssembly" in window)) return;
  const SAMPLES = 64, SLICE = 24, WIDEST = 960; // of each pixel; milliseconds until the page is asked for other work; pixels
  const make = (name, properties, parent) => parent.appendChild(Object.assign(document.createElement(name), properties));
  const frame = document.createElement("div"); // around the still picture, so that the button lies upon it
  frame.className = "live";
  still.replaceWith(frame);
  frame.append(still);
  const button = make("button", { type: "button", className: "begin", textContent: "Turn it yourself" }, frame);

  // The module's bytes stand in a script, because a page that is a file may load nothing else.
  async function load() {
    await new Promise((loaded, failed) => make("script", { src: "theme/module.js", onload: loaded, onerror: failed }, document.head));
    const packed = Uint8Array.from(atob(window.raybookModule), letter => letter.charCodeAt(0));
    const bytes = new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")));
    return (await WebAssembly.instantiate(await bytes.arrayBuffer())).instance.exports;
  }

  const drawn = () => new Promise(done => requestAnimationFrame(() => setTimeout(done)));

  button.addEventListener("click", async () => {
    button.textContent = "One moment …";
    button.disabled = true;
    await drawn();
    try {
      begin(await load());
    } catch (error) {
      button.textContent = "This browser cannot draw it";
      console.info(error);
    }
  }, { once: true });

  function begin(library) {
    let live = library.build(), kernel = 0, turn = 0, rise = 0, isTurning = false, resting, work = 0;
    const speeds = Array.from({ length: library.kernels() }, () => ({ rays: 0, time: 0 }));
    const perSecond = ({ rays, time }) => time ? (rays / time / 1000).toFixed(1) : "–"; // millions

    const canvas = make("canvas", { className: "turned", tabIndex: 0 }, frame), pen = canvas.getContext("2d", { alpha: false });
    canvas.style.aspectRatio = `${image.naturalWidth || 16} / ${image.naturalHeight || 9}`;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${image.alt} The arrow keys turn it.`);
    const small = document.createElement("canvas"), smallPen = small.getContext("2d", { alpha: false });
    still.remove();
    button.remove();
    figure.querySelector("figcaption").textContent = "Drawn by your browser. Drag it, or press the arrow keys. From each point that is seen, one ray goes "
      + `towards the sun and one towards the sky, again and again with other random numbers; the mean of ${SAMPLES} has little noise left.`;
    const panel = figure.insertBefore(document.createElement("fieldset"), frame.nextSibling);
    panel.className = "kernels";
    make("legend", { textContent: "Million rays a second:" }, panel);
    const shown = speeds.map((speed, i) => {
      const label = make("label", {}, panel);
      make("input", { type: "radio", name: "kernel", checked: i === 0, onchange: () => choose(i) }, label);
      const name = new Uint8Array(library.memory.buffer, library.name(i), library.name_length(i));
      make("span", { textContent: `${new TextDecoder().decode(name)}: ` }, label);
      return make("output", { textContent: perSecond(speed) }, label);
    });
    const state = make("span", { className: "state" }, panel);

    // Draws rows by the next sample of each, and counts the rays.
    function draw(sample, top, bottom) {
      const start = performance.now(), rays = library.draw(live, sample, top, bottom), time = performance.now() - start;
      const speed = speeds[kernel], kept = 0.5 ** (time / 1000); // the last seconds count most
      speed.rays = kept * speed.rays + rays;
      speed.time = kept * speed.time + time;
      return time;
    }

    const pixels = (width, top, bottom) =>
      new ImageData(new Uint8ClampedArray(library.memory.buffer, library.shown(live) + 4 * width * top, 4 * width * (bottom - top)), width);

    function size() {
      const width = Math.min(WIDEST, Math.round(canvas.clientWidth * devicePixelRatio));
      return [width, Math.round(width * canvas.clientHeight / canvas.clientWidth)].map(edge => Math.max(edge, 1) || 1);
    }

    // While it turns, a picture of as few pixels as can be drawn at once, enlarged.
    function glance() {
      const { rays, time } = speeds[kernel], [width, height] = [canvas.width, canvas.height];
      const affordable = time ? rays / time * 60 / 3 : 12_000; // three rays a pixel, in 60 milliseconds
      const part = Math.min(1, Math.max(Math.sqrt(affordable / (width * height)), 0.1));
      [small.width, small.height] = [Math.ceil(width * part), Math.ceil(height * part)];
      rise = library.look(live, small.width, small.height, 1, turn, rise);
      draw(0, 0, small.height);
      smallPen.putImageData(pixels(small.width, 0, small.height), 0, 0);
      pen.filter = `blur(${Math.min(0.9 / part, 5)}px)`; // less noise, and no squares; where there is no filter, it goes without
      pen.drawImage(small, 0, 0, width, height);
      pen.filter = "none";
      tell("");
    }

    // At rest, sample after sample over all pixels, until there are enough.
    function refine(own, sample, top, rows) {
      if (own !== work) return; // another picture has been begun since
      const end = performance.now() + SLICE;
      do {
        const bottom = Math.min(top + rows, canvas.height), time = draw(sample, top, bottom);
        pen.putImageData(pixels(canvas.width, top, bottom), 0, top);
        rows = Math.max(1, Math.min(Math.round(rows * SLICE / 3 / Math.max(time, 0.1)), 4 * rows));
        top = bottom;
        if (top === canvas.height) [top, sample] = [0, sample + 1];
      } while (performance.now() < end && sample < SAMPLES);
      tell(`${sample} of ${SAMPLES} samples a pixel`);
      if (sample < SAMPLES) requestAnimationFrame(() => refine(own, sample, top, rows));
    }

    function tell(words) {
      shown[kernel].textContent = perSecond(speeds[kernel]);
      state.textContent = words;
    }

    function rest() {
      library.look(live, canvas.width, canvas.height, SAMPLES, turn, rise);
      refine(++work, 0, 0, 1);
    }

    // Another view: a glance at once, and what is finer after a moment of rest.
    function look() {
      work++;
      clearTimeout(resting);
      resting = setTimeout(rest, 150);
      if (!isTurning) requestAnimationFrame(() => { isTurning = false; glance(); });
      isTurning = true;
    }

    function choose(other) {
      kernel = other;
      live = library.with(live, kernel);
      rest(); // over the same picture, for it is the same
    }

    let held;
    canvas.addEventListener("pointerdown", event => {
      held = [event.clientX, event.clientY];
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", event => {
      if (!held) return;
      turn -= (event.clientX - held[0]) / 150;
      rise += (event.clientY - held[1]) / 250;
      held = [event.clientX, event.clientY];
      look();
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = undefined; });
    const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.06], ArrowDown: [0, -0.06] };
    canvas.addEventListener("keydown", event => {
      const [right, up] = event.ctrlKey || event.altKey || event.metaKey ? [] : keys[event.key] ?? [];
      if (right === undefined) return;
      event.preventDefault();
      event.stopPropagation(); // or it would turn the page
      turn += right;
      rise += up;
      look();
    });
    new ResizeObserver(() => {
      const [width, height] = size();
      if (width === canvas.width && height === canvas.height) return;
      [canvas.width, canvas.height] = [width, height];
      if (work) return look();
      pen.drawImage(image, 0, 0, width, height); // the first rays are drawn over the still picture
      rest();
    }).observe(canvas);
    canvas.focus();
  }
})();
