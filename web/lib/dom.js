/** Shows a text where it is another one: setting the same again would still have the page laid out anew. */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/**
 * The element of this id, with the type that it has in index.html.
 * @template {string} Id
 * @param {Id} id
 * @returns {Id extends keyof Elements ? Elements[Id] : HTMLElement}
 */
export function at(id) {
  return /** @type {any} */ (document.getElementById(id));
}

/**
 * The element that an event came to.
 * @param {Event} event
 */
export const targetOf = (event) => /** @type {HTMLElement} */ (event.target);

/**
 * A new element with these properties; `dataset` and `aria` are tables of their own.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {{ dataset?: object, aria?: object, [property: string]: unknown }} [properties]
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, { dataset, aria, ...properties } = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  Object.assign(made.dataset, dataset);
  for (const [name, value] of Object.entries(aria ?? {})) made.setAttribute(name === "role" ? name : `aria-${name}`, value);
  made.append(...children);
  return made;
}

/** The namespace of SVG. */
export const SVG = "http://www.w3.org/2000/svg";

/** A new SVG element with these attributes. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}
