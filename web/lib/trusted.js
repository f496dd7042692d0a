// The page's own policy of trusted types. Its Content-Security-Policy lets a text become markup or the
// address of a script here alone; every other place that tries is stopped by the browser.

/** Browsers without trusted types take the texts as they are. */
const policy = globalThis.trustedTypes?.createPolicy("bladefan", {
  // Only for drawings: parsed apart, and without scripts, which the policy for scripts forbids anyway.
  createHTML: (text) => text,
  createScriptURL(address) {
    if (new URL(address, location.href).origin !== location.origin) throw new TypeError(`${address} is no script of this page`);
    return address;
  },
});

/** The document of an SVG text, apart from the page. */
export function parsedSvg(text) {
  return new DOMParser().parseFromString(policy ? policy.createHTML(text) : text, "image/svg+xml");
}

/** The address of one of the page's own scripts, as workers take it. */
export function scriptAddress(address) {
  return policy ? policy.createScriptURL(String(address)) : String(address);
}
