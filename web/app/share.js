// The share link: the whole blade and the view in the address, after the #.

import { at } from "../lib/dom.js";
import { pack, unpack } from "./pack.js";

/** Browsers and mail programs take links of this length. */
const LONGEST_LINK = 32_000;

/** Makes the button; returns what opens the blade of the page's address, true where there was one. */
export function startShare(store, open, say) {
  async function share() {
    if (store.get().doc === null) return;
    const link = new URL(location.href);
    link.hash = await pack(store.get());
    if (link.href.length > LONGEST_LINK) {
      say("The blade is too long for a link. Save it as a file and send that.");
      return;
    }
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
      const { blade, choice, view } = await unpack(decodeURIComponent(location.hash.slice(1)));
      await open(blade, choice, { view });
      return true; // or something newer was opened meanwhile
    } catch (error) {
      const why = error instanceof URIError ? "it is cut off or changed" : error.message;
      say(`The link cannot be read: ${why}. Ask for it anew.`);
      return false;
    }
  }

  at("share").addEventListener("click", share);
  addEventListener("hashchange", fromAddress);
  return fromAddress;
}
