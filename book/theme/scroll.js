// What is wider than the page and scrolls by itself can be scrolled by the keyboard too: a formula, a listing, a table, a drawing.
(() => {
  "use strict";
  const WIDE = ".katex-display, pre > code, .table-wrapper, figure, figure > a";
  function reach() {
    for (const part of document.querySelectorAll(WIDE)) {
      if (part.matches("a[href]")) continue; // a link is reached already
      if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
      else if (part.tabIndex === 0) part.removeAttribute("tabindex");
    }
  }
  addEventListener("load", reach);
  addEventListener("resize", reach);
})();
