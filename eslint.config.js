/** What eslint checks in the pages' scripts and their tests. Layout is prettier's, types are tsc's business. */

import js from "@eslint/js";
import globals from "globals";

export default [
  { ignores: ["static/vendor/", "node_modules/", ".venv*/", "build/"] },
  js.configs.recommended,
  {
    files: ["static/js/**/*.js", "service/**/*.js"],
    languageOptions: { ecmaVersion: 2024, sourceType: "module", globals: globals.browser },
    rules: {
      "no-unused-vars": ["error", { argsIgnorePattern: "^_", varsIgnorePattern: "^_", ignoreRestSiblings: true }],
      eqeqeq: "error",
      "no-var": "error",
      "prefer-const": "error",
      "no-eval": "error",
      "no-implied-eval": "error",
      "no-restricted-properties": [
        "error",
        { property: "innerHTML", message: "Elements are put together node by node." },
        { property: "outerHTML", message: "Elements are put together node by node." },
      ],
    },
  },
  {
    files: ["tests/web/js/**/*.mjs", "eslint.config.js"],
    languageOptions: { ecmaVersion: 2024, sourceType: "module", globals: globals.node },
  },
];
