// The frame around a page: policy, navigation, the page's own contents, the pages before and after.
import { posix } from "node:path";
import { escaped } from "./markdown.mjs";

const policy = "default-src 'none'; style-src 'self'; img-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'";

/** The whole document of `page`, one of `pages`, between its neighbours. */
export function layOut(page, pages, previous, next) {
  const to = (address) => posix.relative(posix.dirname(page.address), address) || "./";
  const link = (other, text, attributes = "") => `<a href="${to(other.address)}"${attributes}>${text}</a>`;
  const entries = pages.map((other) => `<li>${link(other, escaped(other.name), other === page ? ' aria-current="page"' : "")}</li>`);
  const contents = page.headings.filter(({ depth }) => depth === 2).map(({ anchor, html }) => `<li><a href="#${anchor}">${html}</a></li>`);
  const title = page === pages[0] ? "bladefan: documentation" : `${escaped(page.name)} – bladefan`;
  // Twice, and shown once: beside a wide page, folded above a narrow one.
  const list = `<ul>${contents.join("\n")}</ul>`;
  const beside = contents.length > 1 ? `<nav class="beside" aria-label="On this page"><h2>On this page</h2>${list}</nav>` : "";
  const above =
    contents.length > 1 ? `<details class="above"><summary>On this page</summary><nav aria-label="On this page">${list}</nav></details>` : "";
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="color-scheme" content="light dark">
<title>${title}</title>
<link rel="icon" href="${to("../icon.svg")}" type="image/svg+xml">
<link rel="stylesheet" href="${to("docs.css")}">
${page.hasMath ? `<link rel="stylesheet" href="${to("math.css")}">\n` : ""}</head>
<body>
<a class="skip" href="#main">To the text</a>
<header class="bar">
${link(pages[0], "bladefan", ' class="brand"')}
<a class="calculator" href="${to("..")}/">Open the calculator</a>
</header>
<div class="columns">
<div class="side">
<nav class="pages" aria-label="Pages"><ul>
${entries.join("\n")}
</ul></nav>
${beside}
</div>
<main id="main">
${above}
<article>
${page.body}</article>
<nav class="turn" aria-label="Previous and next page">
${previous ? link(previous, `<span>Previous</span> ${escaped(previous.name)}`, ' rel="prev"') : ""}
${next ? link(next, `<span>Next</span> ${escaped(next.name)}`, ' rel="next"') : ""}
</nav>
</main>
</div>
</body>
</html>
`;
}
