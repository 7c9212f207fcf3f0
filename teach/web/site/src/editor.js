// SPDX-License-Identifier: MIT
// The editor of a step: CodeMirror with GLSL's colours. Loaded when the first step comes into view.
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, indentOnInput, indentUnit, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { shader } from "@codemirror/legacy-modes/mode/clike";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const colors = HighlightStyle.define([
  { tag: [tags.keyword, tags.modifier, tags.controlKeyword], color: "var(--code-keyword)" },
  { tag: [tags.typeName, tags.standard(tags.variableName), tags.standard(tags.name)], color: "var(--code-name)" },
  { tag: [tags.number, tags.bool, tags.atom], color: "var(--code-number)" },
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: [tags.meta, tags.processingInstruction], color: "var(--code-meta)" },
]);

const look = EditorView.theme({
  "&": { backgroundColor: "var(--code)", color: "var(--ink)", fontSize: "0.8125rem" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-gutters": { backgroundColor: "transparent", color: "var(--quiet)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--code-line)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "var(--code-selection) !important" },
  ".cm-tooltip": { backgroundColor: "var(--card)", color: "var(--ink)", border: "1px solid var(--line)" },
});

/**
 * Puts an editor into `host`. `numbers(text)`: the file's line numbers of the text's lines (places.js). `changed(text)`: after each
 * change by the user. `wraps`: long lines go on below. Gives `{text, write(text), mark(problems)}`; `problems`: [{line, column, message}] in the file's lines.
 */
export function makeEditor({ host, text, numbers, label, changed, wraps = false }) {
  let quiet = false;
  const view = new EditorView({
    parent: host,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers({ formatNumber: (n, state) => String(numbers(state.doc.toString())[n - 1] ?? "") }),
        history(), drawSelection(), wraps ? EditorView.lineWrapping : [], indentOnInput(), bracketMatching(), highlightActiveLine(), lintGutter(),
        indentUnit.of("  "), StreamLanguage.define(shader), syntaxHighlighting(colors), look,
        EditorView.contentAttributes.of({ "aria-label": label, spellcheck: "false", autocapitalize: "off", autocorrect: "off" }),
        // Tab indents; Escape and then Tab leaves the editor (https://codemirror.net/examples/tab/).
        keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !quiet) changed(update.state.doc.toString());
        }),
      ],
    }),
  });
  return {
    text: () => view.state.doc.toString(),
    write(wanted) {
      quiet = true;
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: wanted } });
      quiet = false;
    },
    mark(problems) {
      const found = problems.map(({ line, column, message }) => {
        // What is found beyond the step's text is marked at the line that is closest to it.
        const distance = (number) => (number === null ? Infinity : Math.abs(number - line));
        const known = numbers(view.state.doc.toString());
        const closest = known.reduce((best, number, i) => (distance(number) < distance(known[best]) ? i : best), 0);
        const at = view.state.doc.line(closest + 1);
        const from = known[closest] === line && column > 1 && column <= at.length ? at.from + column - 1 : at.from;
        return { from, to: at.to, severity: "error", message };
      });
      view.dispatch(setDiagnostics(view.state, found));
    },
    focus: () => view.focus(),
  };
}
