'use strict';
// Makes the page's HTML out of its data. Text of any origin is put in by ${…} in html`…` and there alone: that escapes it.

class Html {
  constructor(text) { this.text = text; }
}

const kEntities = {'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;'};

function escaped(value) {
  if (value instanceof Html) return value.text;
  if (Array.isArray(value)) return value.map(escaped).join('');
  if (value === undefined || value === null || value === false) return '';
  return String(value).replace(/[&<>"']/g, (c) => kEntities[c]);
}

function html(parts, ...values) {
  return new Html(parts.map((part, i) => part + (i < values.length ? escaped(values[i]) : '')).join(''));
}

/** What stands between backquotes as code. */
function withCode(text) {
  return new Html(escaped(text).replace(/`([^`]*)`/g, '<code>$1</code>'));
}

/** "1 case", "2 cases". */
function counted(count, what) {
  return `${count} ${what}${count === 1 ? '' : 's'}`;
}

/** A command, broken between flags and not within them, with a button that copies it. */
function commandLine(command) {
  const pieces = command.split(/ (?=--)/).map((piece, i) => html`${i > 0 && ' '}<span>${piece}</span>`);
  return html`<div class="command"><code>${pieces}</code><button type="button" class="copy"
    aria-label="Copy the command">Copy</button></div>`;
}

function factsList({command, ...facts}) {
  const items = Object.entries(facts).map(([name, value]) => html`<dt>${name}</dt><dd>${value}</dd>`);
  return html`
    ${items.length > 0 && html`<dl class="facts">${items}</dl>`}
    ${command !== undefined && html`<p>This command grades the same again:</p>${commandLine(command)}`}`;
}

const data = JSON.parse(document.getElementById('data').textContent);

function show(body) {
  document.querySelector('noscript').remove();
  document.body.insertAdjacentHTML('afterbegin', body.text);
}
