// What `make lint` asks of the report's page. Names and types are checked by tsc (tsconfig.json).
const rules = [
  "array-callback-return", "consistent-return", "curly-style", "default-case-last", "dot-notation", "eqeqeq", "getter-return", "no-alert",
  "no-console", "no-constant-condition", "no-dupe-class-members", "no-dupe-else-if", "no-dupe-keys", "no-else-return", "no-empty",
  "no-eval", "no-extend-native", "no-implicit-coercion", "no-implied-eval", "no-loop-func", "no-new-func", "no-param-reassign",
  "no-self-assign", "no-self-compare", "no-shadow", "no-sparse-arrays", "no-throw-literal", "no-unreachable", "no-unused-expressions",
  "no-unused-vars", "no-use-before-define", "no-useless-assignment", "no-useless-return", "no-var", "object-shorthand", "prefer-arrow-callback",
  "prefer-const", "prefer-object-spread", "prefer-rest-params", "prefer-template", "require-await", "use-isnan", "valid-typeof",
];

export default [{
  files: ["**/*.js"],
  languageOptions: { ecmaVersion: 2024, sourceType: "module" },
  linterOptions: { reportUnusedDisableDirectives: "error" },
  rules: {
    ...Object.fromEntries(rules.filter((rule) => rule !== "curly-style").map((rule) => [rule, "error"])),
    "complexity": ["error", 12],
    "max-len": ["error", { code: 180 }],
    "max-lines": ["error", 220],
    "no-use-before-define": ["error", { functions: false }],
    // Whatever a planner or a log says stays text.
    "no-restricted-properties": ["error", ...["innerHTML", "outerHTML", "insertAdjacentHTML", "write"].map((property) => ({ property }))],
  },
}];
