// The download menu: what each entry saves.

import { at, targetOf } from "../lib/dom.js";
import { textFormat } from "../lib/format.js";
import { convergeCsv, download, fanCsv, fileName, png, shapesCsv } from "./download.js";

/** The width asked for, held to what a canvas takes. */
const pngWidth = () => Math.min(8000, Math.max(320, Math.round(Number(at("png-width").value)) || 1920));

const tables = { fan: fanCsv, shapes: shapesCsv, converge: convergeCsv };

/** Makes the menu work. */
export function startSaving(store, client, say) {
  const named = (what, extension) => fileName(store.get().blade?.name ?? "", what, extension);

  /** The blade as its author's text where that is unchanged, else written anew; JSON holds faulty values, too. */
  async function bladeText(format) {
    const { doc, text } = store.get();
    if (text !== null && textFormat(text) === format) return text;
    const written = await client.call("save", "write_blade", doc, format);
    if (written?.status === "ok") return written.value;
    if (format === "json") return `${JSON.stringify(doc, null, 1)}\n`;
    say("The blade has faults and cannot be saved as TOML yet; as JSON it is saved as it stands.");
    return null;
  }

  async function saveBlade(format) {
    const text = await bladeText(format);
    if (text !== null) download(fileName(store.get().doc?.name ?? "", "", format), text, "text/plain");
  }

  const files = {
    svg: ({ drawing }) => download(named(drawing.kind, "svg"), drawing.svg, "image/svg+xml"),
    png: async ({ drawing }) => download(named(drawing.kind, "png"), await png(drawing, pngWidth())),
    csv: ({ drawing: { kind, report } }) => download(named(kind, "csv"), tables[kind](report), "text/csv"),
    json: ({ drawing: { kind, report } }) => download(named(kind, "json"), `${JSON.stringify(report, null, 1)}\n`, "application/json"),
    toml: () => saveBlade("toml"),
    "json-blade": () => saveBlade("json"),
  };
  const menu = at("download");
  for (const [what, make] of Object.entries(files)) {
    at(`download-${what}`).addEventListener("click", async () => {
      menu.open = false;
      menu.querySelector("summary").focus();
      if (store.get().drawing !== null) await make(store.get());
    });
  }
  addEventListener("pointerdown", (event) => {
    if (!menu.contains(targetOf(event))) menu.open = false;
  });
  menu.addEventListener("keydown", ({ key }) => {
    if (key === "Escape") menu.open = false;
  });
}
