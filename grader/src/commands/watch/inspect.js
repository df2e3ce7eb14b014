// What the pictures of an exercise can do on this page: a slider between yours and the right one, and a pixel to look at closely.
const MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// Two pictures in the same place: the right one is cut off at its left.
const slider = (id, yours, right) => `
  <figure class="slider"><span class="picture">${yours}${right}</span>
    <figcaption><label for="${id}-cut">Yours, and right of the slider the right one</label>
      <input type="range" id="${id}-cut" min="0" max="100" value="50"></figcaption></figure>`;

const inspector = (id, { width, height, x, y }) => `
  <p class="inspector"><label>column <input type="number" id="${id}-x" min="0" max="${width - 1}" value="${x}"></label>
    <label>row <input type="number" id="${id}-y" min="0" max="${height - 1}" value="${y}"></label>
    <output for="${id}-x ${id}-y"></output></p>`;

const explainer = id => `
  <p><button type="button" id="${id}-explain">Explain this pixel</button> <code></code></p><div aria-live="polite"></div>`;

// The pixels of a picture, three numbers from 0 to 255 each, as they are shown.
async function read(image) {
  await image.decode();
  const { naturalWidth: width, naturalHeight: height } = image, context = new OffscreenCanvas(width, height).getContext("2d");
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  return (x, y) => data.subarray(4 * (y * width + x)).slice(0, 3);
}

// The nearest number of a column or a row, of which there are `size`.
const inside = (value, size) => Math.min(Math.max(Math.trunc(value) || 0, 0), size - 1);

// The slider, the inspector and the explanation of the pictures in a `fieldset`.
function liven(pictures) {
  const { id, dataset } = pictures, { exercise } = dataset, row = pictures.querySelector(".row");
  const [width, height, x, y] = ["width", "height", "x", "y"].map(name => Number(dataset[name]));
  const images = [...pictures.querySelectorAll("img")], numbers = Promise.all(images.slice(0, 2).map(read));
  const [yours, right] = images.map(image => image.outerHTML);
  pictures.querySelector("p").insertAdjacentHTML("beforeend",
    `<label><input type="radio" id="${id}-slider" name="${id}-shown" value="slider"> a slider</label>`);
  row.insertAdjacentHTML("beforeend", slider(id, yours, right));
  row.insertAdjacentHTML("afterend", inspector(id, { width, height, x, y }) + ("explained" in dataset ? explainer(id) : ""));
  const [cut, column, line] = ["cut", "x", "y"].map(name => document.getElementById(`${id}-${name}`));
  const output = pictures.querySelector("output"), button = pictures.querySelector("button");
  const marks = [...pictures.querySelectorAll(".picture")].map(picture => picture.appendChild(document.createElement("i")));

  const pixel = () => [inside(column.value, width), inside(line.value, height)];
  async function look() {
    const [x, y] = pixel(), words = (await numbers).map(at => [...at(x, y)].join(" "));
    for (const { style } of marks)
      [style.left, style.top, style.width, style.height] = [x / width, y / height, 1 / width, 1 / height].map(part => `${100 * part}%`);
    output.textContent = words[0] === words[1] ? `yours and the right one: ${words[0]}` : `yours: ${words[0]}, the right one: ${words[1]}`;
    if (button) button.nextElementSibling.textContent = `raybook explain ${exercise} --pixel ${x},${y}`;
  }
  async function explain() {
    const told = pictures.querySelector("[aria-live]");
    told.textContent = "Asking your program …";
    const answer = await fetch(`explain/${exercise}/${pixel()}`).catch(() => null), text = answer && await answer.text();
    if (answer?.ok) told.innerHTML = text;
    else told.textContent = text ?? "The watch has ended.";
  }
  function move(x, y) {
    [column.value, line.value] = [inside(x, width), inside(y, height)];
    look();
  }
  cut.oninput = () => pictures.style.setProperty("--cut", `${cut.value}%`);
  column.oninput = line.oninput = look;
  button?.addEventListener("click", explain);
  row.id = `${id}-row`;
  row.tabIndex = 0;
  row.setAttribute("role", "group");
  row.setAttribute("aria-label", "The pictures: arrow keys choose the pixel that is told below");
  row.onkeydown = event => {
    const [dx, dy] = MOVES[event.key] ?? [];
    if (dx === undefined || event.target !== row) return;
    event.preventDefault();
    const [x, y] = pixel();
    move(x + dx, y + dy);
  };
  row.onclick = event => {
    const picture = event.target.closest(".picture")?.getBoundingClientRect();
    if (picture) move((event.clientX - picture.left) / picture.width * width, (event.clientY - picture.top) / picture.height * height);
  };
  look();
}
