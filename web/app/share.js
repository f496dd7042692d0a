// The share link: the whole blade and the view in the address, after the #.

import { at } from "../lib/dom.js";
import { contentOf, pack, unpack } from "./pack.js";

/** Browsers and mail programs take links of this length. */
const LONGEST_LINK = 32_000;

/**
 * Makes the button. Returns `open`, which opens the blade of the page's address, true where there was one;
 * and `outgrow(content)`, for a blade that is kept otherwise.
 */
export function startShare(store, open, say) {
  let held = null; // what the address holds
  const now = () => JSON.stringify(contentOf(store.get()));

  /** An address that no longer says what the page shows goes: else a reload would bring back what was shared. */
  function outgrow(content) {
    if (location.hash.length > 1 && content !== held) history.replaceState(null, "", location.pathname + location.search);
  }

  async function share() {
    if (store.get().doc === null) return;
    const link = new URL(location.href);
    const content = now();
    link.hash = await pack(store.get());
    if (link.href.length > LONGEST_LINK) {
      say("The blade is too long for a link. Save it as a file and send that.");
      return;
    }
    held = content;
    history.replaceState(null, "", link);
    try {
      await navigator.clipboard.writeText(link.href);
      say("The link is copied. It holds the whole blade and this view.");
    } catch {
      say("The link stands in the address line. It holds the whole blade and this view.");
    }
  }

  async function fromAddress() {
    if (location.hash.length < 2) return false;
    try {
      const content = await unpack(decodeURIComponent(location.hash.slice(1)));
      if (content.refused !== null) say(`The link is opened but for one thing. ${content.refused}`);
      await open.back(content);
      held = now();
      return true; // or something newer was opened meanwhile
    } catch (error) {
      const why = error instanceof URIError ? "it is cut off or changed" : error.message;
      say(`The link cannot be read: ${why}. Ask for it anew.`);
      return false;
    }
  }

  at("share").addEventListener("click", share);
  addEventListener("hashchange", fromAddress);
  return { open: fromAddress, outgrow };
}
