// One page from Markdown to HTML: equations, anchors of headings, links, and tables that scroll
// within themselves.
import { Marked } from "marked";

const escapes = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
export const escaped = (text) => text.replace(/[&<>"]/g, (character) => escapes[character]);
const withoutTags = (html) => html.replace(/<[^>]*>/g, "");

/** `$…$` as GitHub takes it: nothing blank inside the signs, no digit after them. */
const inline = /\$(?!\s)((?:\\.|[^\\$`])+?)(?<!\s)\$(?!\d)/s;

/** The anchor that GitHub gives a heading, so that a link holds there and here. */
function anchorOf(html, taken) {
  const text = withoutTags(html).replace(/&\w+;|&#\d+;/g, "");
  const anchor = text
    .toLowerCase()
    .replace(/[^\p{L}\p{M}\p{N}\p{Pc}\- ]/gu, "")
    .replaceAll(" ", "-");
  const times = taken.get(anchor) ?? 0;
  taken.set(anchor, times + 1);
  return times === 0 ? anchor : `${anchor}-${times}`;
}

/** `{ title, headings, body, hasMath }` of a text; `resolve` gives `{ href, name }` of a link on the site. */
export function render(text, { name, equations, resolve }) {
  const headings = [];
  const taken = new Map();
  const before = equations.count;
  const mathml = (tex, display) => {
    try {
      return equations.mathml(tex, display);
    } catch (error) {
      throw new Error(`${name}: ${error.message}\n${tex}`, { cause: error });
    }
  };
  const marked = new Marked({
    gfm: true,
    walkTokens(token) {
      if (token.type === "html")
        token.text = token.text.replace(/\b(src|srcset|href)="([^"]+)"/g, (_, key, to) => `${key}="${escaped(resolve(to).href)}"`);
      if (token.type !== "link" && token.type !== "image") return;
      const { href, name } = resolve(token.href);
      token.href = href;
      // The name of a file says nothing on the site.
      if (name && /\.md$/.test(token.text)) token.tokens = [{ type: "text", raw: name, text: name }];
    },
    // An underscore or asterisk inside an equation begins no emphasis.
    hooks: { emStrongMask: (source) => source.replace(new RegExp(inline, "gs"), (whole) => "a".repeat(whole.length)) },
    extensions: [
      {
        name: "equation",
        level: "inline",
        start: (source) => source.indexOf("$"),
        tokenizer(source) {
          const [raw, tex] = new RegExp(`^${inline.source}`, "s").exec(source) ?? [];
          if (raw !== undefined) return { type: "equation", raw, tex };
        },
        renderer: ({ tex }) => mathml(tex, false),
      },
    ],
    renderer: {
      code: ({ text: tex, lang }) =>
        lang === "math" && `<div class="equation" tabindex="0" role="group" aria-label="Equation">${mathml(tex, true)}</div>\n`,
      heading({ tokens, depth }) {
        const html = this.parser.parseInline(tokens);
        const anchor = anchorOf(html, taken);
        headings.push({ depth, anchor, html });
        return depth === 1
          ? `<h1 id="${anchor}">${html}</h1>\n`
          : `<h${depth} id="${anchor}"><a class="anchor" href="#${anchor}">${html}</a></h${depth}>\n`;
      },
    },
  });
  const body = marked
    .parse(text)
    .replace(/<th( [^>]*)?><\/th>/g, "<td></td>") // a header without a name is none
    .replace(/<th(?=[ >])/g, '<th scope="col"')
    .replaceAll("<table>", '<div class="table" tabindex="0" role="group" aria-label="Table"><table>')
    .replaceAll("</table>", "</table></div>")
    .replaceAll("<pre>", '<pre tabindex="0">')
    // An equation and the bracket or point beside it, which math.css keeps on one line.
    .replace(/(\(?)(<math>.*?<\/math>)([.,;:)]*)/g, (whole, left, math, right) =>
      left + right === "" ? math : `<span class="kept">${whole}</span>`,
    );
  const title = withoutTags(headings[0].html);
  return { title, headings, body, hasMath: equations.count > before };
}
