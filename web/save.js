// The download menu: what each entry saves.

import { at } from "./dom.js";
import { convergeCsv, download, fanCsv, fileName, png, shapesCsv } from "./download.js";
import { textFormat } from "./format.js";
import { optionsOf } from "./solve.js";

const tables = { fan: fanCsv, shapes: shapesCsv, converge: convergeCsv };

/** Makes the menu work. */
export function startSaving(store, client, editor) {
  const named = (what, extension) => fileName(store.get().blade?.name ?? "", what, extension);

  /** What the open tab shows, as numbers. */
  async function report() {
    const { tab, blade } = store.get();
    const result = await client.call("report", tab, blade, optionsOf(tab, store.get()));
    if (result?.status === "error") store.set({ solveFaults: result.faults });
    return result?.status === "ok" ? result.value : null;
  }

  const files = {
    svg: ({ drawing }) => download(named(drawing.kind, "svg"), drawing.svg, "image/svg+xml"),
    png: async ({ drawing }) => download(named(drawing.kind, "png"), await png(drawing)),
    csv: async ({ tab }) => {
      const value = await report();
      if (value) download(named(tab, "csv"), tables[tab](value), "text/csv");
    },
    json: async ({ tab }) => {
      const value = await report();
      if (value) download(named(tab, "json"), JSON.stringify(value, null, 1) + "\n", "application/json");
    },
    blade: () => download(named("", textFormat(editor.value)), editor.value, "text/plain"),
  };
  const menu = at("download");
  for (const [what, make] of Object.entries(files)) {
    at(`download-${what}`).addEventListener("click", async () => {
      menu.open = false;
      menu.querySelector("summary").focus();
      if (store.get().drawing !== null) await make(store.get());
    });
  }
  addEventListener("pointerdown", ({ target }) => {
    if (!menu.contains(target)) menu.open = false;
  });
  menu.addEventListener("keydown", ({ key }) => {
    if (key === "Escape") menu.open = false;
  });
}
