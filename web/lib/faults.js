// Faults as the page lists them.

/** The place of a fault: "line 12: distribution.mass[3]". */
export function faultPlace(fault) {
  const parts = [];
  if (fault.line !== null) parts.push(`line ${fault.line}`);
  if (fault.path !== "") parts.push(fault.path);
  return parts.join(": ");
}

/** Fills a list with faults; those with a place in the text are buttons that lead there. */
export function listFaults(list, faults, onJump) {
  list.replaceChildren(
    ...faults.map((fault) => {
      const item = document.createElement("li");
      const place = faultPlace(fault);
      const words = place === "" ? fault.message : `${place}: ${fault.message}`;
      if (fault.line === null || !onJump) {
        item.textContent = words;
      } else {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = words;
        button.addEventListener("click", () => onJump(fault));
        item.append(button);
      }
      return item;
    }),
  );
  list.hidden = faults.length === 0;
}
