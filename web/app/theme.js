// Light or dark: the system's choice until the user makes one, which is remembered.

const KEY = "bladefan-theme";
const system = matchMedia("(prefers-color-scheme: dark)");

function remembered() {
  try {
    const choice = localStorage.getItem(KEY);
    return choice === "light" || choice === "dark" ? choice : null;
  } catch {
    return null; // storage may be switched off
  }
}

/** Shows the theme on the page and on its button; `onChange` hears of every change. */
export function startTheme(button, onChange) {
  let choice = remembered();
  const current = () => choice ?? (system.matches ? "dark" : "light");
  const show = () => {
    const theme = current();
    document.documentElement.dataset.theme = theme;
    button.textContent = theme === "dark" ? "Light" : "Dark";
    button.setAttribute("aria-label", `${button.textContent} colours`);
    onChange(theme);
  };
  button.addEventListener("click", () => {
    choice = current() === "dark" ? "light" : "dark";
    try {
      localStorage.setItem(KEY, choice);
    } catch {
      // not remembered, still applied
    }
    show();
  });
  system.addEventListener("change", show);
  show();
}
