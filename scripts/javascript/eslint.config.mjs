// Mistakes, not taste: looks are prettier's, types are tsc's.
import js from "@eslint/js";
import globals from "globals";

const rules = {
  ...js.configs.recommended.rules,
  eqeqeq: "error",
  "no-eval": "error",
  "no-implied-eval": "error",
  "no-throw-literal": "error",
  "no-unused-vars": ["error", { argsIgnorePattern: "^_", varsIgnorePattern: "^_", ignoreRestSiblings: true }],
  "no-useless-return": "error",
  "no-var": "error",
  "object-shorthand": "error",
  "prefer-const": ["error", { destructuring: "all" }],
  // Markup and addresses of scripts are made in web/lib/trusted.js alone.
  "no-restricted-properties": [
    "error",
    ...["innerHTML", "outerHTML", "insertAdjacentHTML", "parseFromString"].map((property) => ({ property, message: "see web/lib/trusted.js" })),
  ],
};

export default [
  { ignores: ["**/node_modules/", "web/pkg/", "web/docs/", "crates/", "target/"] },
  { linterOptions: { reportUnusedDisableDirectives: "error" } },
  { files: ["web/**/*.js"], ignores: ["web/sw.js", "web/solver/worker.js"], languageOptions: { globals: globals.browser }, rules },
  { files: ["web/lib/trusted.js"], rules: { "no-restricted-properties": "off" } },
  { files: ["web/sw.js"], languageOptions: { sourceType: "script", globals: globals.serviceworker }, rules },
  { files: ["web/solver/worker.js"], languageOptions: { globals: globals.worker }, rules },
  // What a test of the page hands to the browser runs there, and may try what the page may not.
  {
    files: ["tests/**/*.mjs", "scripts/**/*.mjs"],
    languageOptions: { globals: { ...globals.nodeBuiltin, ...globals.browser } },
    rules: { ...rules, "no-restricted-properties": "off" },
  },
];
