//! How the lab's page looks, and what it does when it is clicked or a key is pressed.

/// Figures keep their size, and so does their text; a figure that is wider than the window is scrolled. Pictures of pixels are
/// never scaled.
pub const STYLE: &str = "
body { max-width: 1420px }
.figures { display: flex; flex-wrap: wrap; gap: 1.5rem .7rem }
.figures > * { max-width: 100% }
.scroll > a > img, .scroll > img { width: auto; max-width: none; display: block }
figcaption { max-width: 43em; margin-top: .4em } figcaption code { font-size: 13px }
.pixels img, .flip img { width: auto; height: auto; max-width: none; image-rendering: pixelated; display: block }
.pixels { display: grid; grid-template-columns: repeat(auto-fill, var(--width)); gap: 8px; padding-bottom: .5rem }
.pixels span { font-size: 15px }
@media (max-width: 700px) { .pixels { grid-auto-flow: column; grid-template-columns: none; justify-content: start; overflow-x: auto } }
th, td { padding: .2em .45em }
th { vertical-align: bottom } th button { font: inherit; font-weight: bold; border: 0; background: none; color: inherit; cursor: pointer; text-align: inherit; padding: .3em 0 }
th button::after { content: ' ↕'; opacity: .5 } th[aria-sort=ascending] button::after { content: ' ↑'; opacity: 1 } th[aria-sort=descending] button::after { content: ' ↓'; opacity: 1 }
th:last-child, td:last-child { text-align: left; min-width: 15em } dt { font-weight: bold } dd { margin: 0 0 .4em 1.5em }
.flip { margin-top: 1rem } .flip label { margin-right: 1em } .flip select, .flip button { font: inherit } .flip p { margin: .5em 0 }
body.slides { max-width: none; margin: 0; padding: 0 } body.slides .screen { min-height: 100vh; box-sizing: border-box; padding: 2vh 3vw; border: 0; margin: 0 }
body.slides figcaption, body.slides section > p { font-size: 22px; max-width: none } body.slides figcaption code { font-size: 17px }
body.slides figure { height: 96vh; display: flex; flex-direction: column } body.slides figure > .scroll, body.slides figure > .scroll > a { flex: 1; min-height: 0; display: flex }
body.slides .scroll > a > img { width: 94vw; min-height: 0; object-fit: contain; margin: auto } body.slides .figures { justify-content: center }
html:has(body.slides) { scroll-snap-type: y proximity } body.slides .screen { scroll-snap-align: start }
body.slides table { font-size: 17px } body.slides th, body.slides td { padding: .3em .5em } body.slides td:first-child { white-space: nowrap }
body.slides th:last-child, body.slides td:last-child { display: none } body.slides dl { columns: 2; font-size: 19px } body.slides dd { break-before: avoid }";

/// One screen pixel for each pixel of a picture, whatever the screen's ratio; a table that is sorted by a click on a heading; two
/// pictures in turns; and the arrow keys in slides.
pub const SCRIPT: &str = "
const exact = i => { const fit = () => { i.style.width = i.naturalWidth / devicePixelRatio + 'px'; }; if (i.complete) fit(); i.addEventListener('load', fit); addEventListener('resize', fit); };
document.querySelectorAll('.pixels img, .flip img').forEach(exact);
document.querySelectorAll('th button').forEach(button => button.addEventListener('click', () => {
  const th = button.parentElement, row = th.parentElement, body = row.closest('table').tBodies[0], i = [...row.children].indexOf(th);
  const up = th.getAttribute('aria-sort') !== 'ascending';
  [...row.children].forEach(h => h.setAttribute('aria-sort', 'none'));
  th.setAttribute('aria-sort', up ? 'ascending' : 'descending');
  const value = r => r.children[i].dataset.value ?? r.children[i].textContent;
  const order = (a, b) => { const [x, y] = [value(a), value(b)]; const d = x - y;
    if (x === '' || y === '') return (x === '') - (y === '');
    return (up ? 1 : -1) * (Number.isNaN(d) ? x.localeCompare(y) : d); };
  [...body.rows].sort(order).forEach(r => body.append(r));
}));
document.querySelectorAll('.flip').forEach(flip => {
  const [what, samples, one, other] = flip.querySelectorAll('select'), image = flip.querySelector('img'), shown = flip.querySelector('output');
  let second = false;
  const show = () => { const which = second ? other : one;
    image.src = what.value + '_' + which.value + '_' + samples.value + '.png';
    image.alt = shown.textContent = (second ? 'B: ' : 'A: ') + which.selectedOptions[0].text; };
  const turn = () => { second = !second; show(); };
  if (other.options.length > 1) other.selectedIndex = 1;
  flip.querySelectorAll('select').forEach(s => s.addEventListener('change', () => { second = s === other; show(); }));
  flip.querySelector('button').addEventListener('click', turn);
  addEventListener('keydown', e => { if (e.key === 'f' && !e.ctrlKey && !e.metaKey && !e.altKey && e.target.tagName !== 'SELECT') turn(); });
  show();
});
if (document.body.classList.contains('slides')) {
  const screens = [...document.querySelectorAll('.screen')];
  addEventListener('keydown', e => {
    const step = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 }[e.key];
    if (!step || e.target.tagName === 'SELECT') return;
    const at = screens.reduce((best, s, i) => Math.abs(s.offsetTop - scrollY) < Math.abs(screens[best].offsetTop - scrollY) ? i : best, 0);
    screens[Math.min(Math.max(at + step, 0), screens.length - 1)].scrollIntoView(); e.preventDefault();
  });
}";
