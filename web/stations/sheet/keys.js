// Keys and clipboard of the sheet.

const PAGE = 10;
const ARROWS = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };

export function bindKeys(sheet) {
  let home = null; // the column where a run of Tab began: Enter goes back below it

  sheet.enter = (up) => {
    const col = home ?? sheet.active.col;
    home = null;
    sheet.step(up ? -1 : 1, col - sheet.active.col);
  };

  /** One cell on; from the end of a row to the next where something was typed, else out of the sheet (false). */
  sheet.tab = (back, typed) => {
    const { col } = sheet.active;
    const last = sheet.view.columns.length - 1;
    if (back ? col > 0 : col < last) {
      const from = home ?? col;
      sheet.step(0, back ? -1 : 1);
      home = from;
      return true;
    }
    if (typed) sheet.step(back ? -1 : 1, back ? last : -last);
    return typed;
  };

  function arrows(event, [down, right]) {
    const { rows, columns } = sheet.view;
    if (event.altKey) {
      if (down !== 0) sheet.on.command(event.shiftKey ? (down < 0 ? "above" : "below") : down < 0 ? "up" : "down");
      return down !== 0;
    }
    const far = event.ctrlKey || event.metaKey;
    sheet.step(far ? down * rows.length : down, far ? right * columns.length : right, event.shiftKey);
    return true;
  }

  /** Whether the key was one of the sheet's. */
  function press(event) {
    const { key, shiftKey } = event;
    const control = event.ctrlKey || event.metaKey;
    const { view } = sheet;
    if (key !== "Tab" && key !== "Enter" && key !== "Shift") home = null;
    if (key in ARROWS) return arrows(event, ARROWS[key]);
    if (key === "Home" || key === "End") {
      const end = key === "End";
      const row = control ? (end ? view.rows.at(-1) : view.rows[0]) : sheet.active.row;
      sheet.go(row, end ? view.columns.length - 1 : 0, shiftKey);
      return true;
    }
    if (key === "Delete" || key === "Backspace") {
      if (event.altKey) sheet.on.command("delete");
      else sheet.on.clear();
      return true;
    }
    if (control && key.toLowerCase() === "a") {
      sheet.selectAll();
      return true;
    }
    if (control || event.altKey) return false;
    if (key === "PageUp" || key === "PageDown") sheet.step(key === "PageUp" ? -PAGE : PAGE, 0, shiftKey);
    else if (key === "Enter") sheet.enter(shiftKey);
    else if (key === "Tab") return sheet.tab(shiftKey, false);
    else if (key === "F2") sheet.editor.begin();
    else if (key.length === 1 && key !== " ") {
      // The key itself goes into the field that has the focus by then.
      sheet.editor.begin(true);
      return false;
    } else return key === " ";
    return true;
  }

  sheet.table.addEventListener("keydown", (event) => {
    if (event.target.tagName === "TD" && !event.isComposing && press(event)) event.preventDefault();
  });

  // Browsers send these to where the text cursor is, which may be anywhere: the focus tells.
  const ours = () => document.activeElement?.tagName === "TD" && sheet.table.contains(document.activeElement);
  for (const kind of /** @type {const} */ (["copy", "cut"])) {
    document.addEventListener(
      kind,
      (event) => {
        if (!ours()) return;
        event.preventDefault();
        event.stopImmediatePropagation();
        event.clipboardData.setData("text/plain", sheet.on.copy(kind === "cut"));
      },
      true,
    );
  }
  document.addEventListener(
    "paste",
    (event) => {
      if (!ours()) return;
      event.preventDefault();
      sheet.on.paste(event.clipboardData.getData("text/plain"));
    },
    true,
  );
}
