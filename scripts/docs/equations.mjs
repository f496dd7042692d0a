// TeX to MathML. A page's policy allows no style attributes, so those that Temml writes become
// classes of one stylesheet.
import temml from "temml";

export class Equations {
  count = 0;
  #classes = new Map();

  /** An equation as MathML; one that Temml does not understand ends the build. */
  mathml(tex, displayMode) {
    this.count += 1;
    const html = temml.renderToString(tex, { displayMode, throwOnError: true, strict: false });
    return html.replace(/<(\w+)([^>]*?) style="([^"]*)"([^>]*)>/g, (_, tag, before, style, after) => {
      const attributes = before + after;
      const name = this.#classOf(style);
      if (!attributes.includes(' class="')) return `<${tag} class="${name}"${attributes}>`;
      return `<${tag}${attributes.replace(' class="', ` class="${name} `)}>`;
    });
  }

  /** The stylesheet of those classes. They win over Temml's own, as the attributes would. */
  css() {
    return [...this.#classes].map(([style, name]) => `math.${name}.${name}, math .${name}.${name} { ${style} }\n`).join("");
  }

  #classOf(style) {
    if (!this.#classes.has(style)) this.#classes.set(style, `style-${this.#classes.size}`);
    return this.#classes.get(style);
  }
}
