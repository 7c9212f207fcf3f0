'use strict';
// ---- The page, from what was drawn: {renderer, labs: [{number, folder, title, lesson, looks: [look]}]}

const {renderer, labs} = JSON.parse(document.getElementById('drawn').textContent);
const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const anchor = (lab, look) => `${lab.folder}-${look.name}`;
const image = (lab, look, more = '') =>
    `<img src="${lab.folder}/${look.file}" alt="${escaped(look.caption)}" width="${look.width}" height="${look.height}"${more}>`;

// A line is broken between flags, not within them.
const commandLine = (command) => `<div class="command"><code><span>${escaped(command).replaceAll(' --', '</span> <span>--')}</span></code
    ><button type="button" class="copy" aria-label="Copy the command">Copy</button></div>`;

// The values of the settings that choose a method, as "averaged", or "default".
function methodsOf({set}) {
  const methods = Object.keys(set).filter((name) => name.endsWith('method')).map((name) => set[name]);
  return methods.length > 0 ? methods : ['default'];
}

// Whether two pictures show the same, apart from one parameter: a reader would put them beside each other.
function isPair(a, b) {
  const different = Object.keys({...a.set, ...b.set}).filter((name) => a.set[name] !== b.set[name]);
  return a.view === b.view && a.width === b.width && a.height === b.height && different.length === 1;
}

const hero = (lab, look) =>
    `<a href="#${anchor(lab, look)}">${image(lab, look)}<span><b>${lab.number}</b> ${escaped(lab.title)}</span></a>`;

function figure(lab, look) {
  const pair = lab.looks.find((other) => isPair(look, other));
  return `<figure id="${anchor(lab, look)}" data-view="${look.view}" data-methods="${methodsOf(look).join(' ')}"
      ${pair ? `data-pair="${anchor(lab, pair)}"` : ''}>
    <a class="open" href="${lab.folder}/${look.file}">${image(lab, look, ' loading="lazy"')}
      ${look.view === 'color' ? '' : `<span class="view">${look.view} view</span>`}</a>
    <figcaption><p class="caption">${escaped(look.caption)}</p>
      ${look.source ? `<p class="source">${escaped(look.source)}</p>` : ''}
      ${pair ? `<button type="button" class="compare">Compare with: ${escaped(pair.caption)}</button>` : ''}
      ${commandLine(look.command)}</figcaption></figure>`;
}

const section = (lab) => `<section id="lab${lab.number}" class="lab" aria-labelledby="title${lab.number}">
    <header><p class="number" aria-hidden="true">${lab.number}</p>
      <div><h2 id="title${lab.number}">${escaped(lab.title)}</h2><p>${escaped(lab.lesson)}</p></div>
      ${commandLine(`./run lab ${lab.number}`)}</header>
    <div class="looks">${lab.looks.map((look) => figure(lab, look)).join('')}</div></section>`;

// A choice of one of the values, each with its text.
const choice = (id, label, values) => `<label>${label} <select id="${id}"><option value="">all</option>
    ${values.map(([value, text]) => `<option value="${value}">${escaped(text)}</option>`).join('')}</select></label> `;

const looks = labs.flatMap((lab) => lab.looks);
const sorted = (values) => [...new Set(values)].sort().map((value) => [value, value]);
const put = (selector, where, html) => document.querySelector(selector).insertAdjacentHTML(where, html);
put('.heroes', 'beforeend', labs.flatMap((lab) => lab.looks.filter((look) => look.hero).map((look) => hero(lab, look))).join(''));
put('nav ol', 'beforeend',
    labs.map((lab) => `<li><a href="#lab${lab.number}"><b>${lab.number}</b> ${escaped(lab.title)}</a></li>`).join(''));
put('.filters', 'afterbegin',
    choice('lab', 'Lab', labs.map((lab) => [`lab${lab.number}`, `${lab.number} ${lab.title}`])) +
    choice('view', 'View', sorted(looks.map((look) => look.view))) +
    choice('method', 'Method', sorted(looks.flatMap(methodsOf))));
put('main', 'beforeend', labs.map(section).join(''));
for (const lab of labs)
  for (const look of lab.looks)
    if (look.legend) document.getElementById(anchor(lab, look)).querySelector('.open').after(texelLegend(look.legend));
put('footer p', 'beforeend', `Drawn by ${escaped(renderer)}.`);

// ---- A picture alone, or beside another one

const pictures = [...document.querySelectorAll('figure .open')];
const lightbox = document.getElementById('lightbox');
const over = lightbox.querySelector('.over');
const split = lightbox.querySelector('.split');
let shown = 0;

const caption = (figure) => figure.querySelector('.caption').textContent;

// Puts the pair's other picture over the right part of the one that is shown.
function compare(other) {
  over.hidden = split.hidden = !other;
  lightbox.querySelector('.bar b').hidden = Boolean(other);  // the pair has its own words
  if (!other) return;
  over.src = other.querySelector('.open').href;
  over.alt = other.querySelector('img').alt;
  const [left, right] = split.querySelectorAll('span');
  left.textContent = caption(pictures[shown].closest('figure'));
  right.textContent = caption(other);
  split.querySelector('input').value = 50;
  slide();
}
function slide() {
  const part = split.querySelector('input').value;
  over.style.clipPath = `inset(0 0 0 ${part}%)`;
  lightbox.querySelector('.stage').style.setProperty('--part', `${part}%`);
}
split.addEventListener('input', slide);

function show(index) {
  shown = (index + pictures.length) % pictures.length;
  compare(null);
  const figure = pictures[shown].closest('figure');
  const image = lightbox.querySelector('img');
  image.src = pictures[shown].href;
  image.alt = figure.querySelector('img').alt;
  lightbox.querySelector('.bar b').textContent = caption(figure);
  lightbox.querySelector('.bar span').textContent =
      figure.closest('.lab').querySelector('h2').textContent + ', picture ' + (shown + 1) + ' of ' + pictures.length;
}

pictures.forEach((picture, index) => picture.addEventListener('click', (event) => {
  if (event.ctrlKey || event.metaKey || event.shiftKey) return;  // a new tab shows the file itself
  event.preventDefault();
  show(index);
  lightbox.showModal();
}));
document.querySelectorAll('.compare').forEach((button) => button.addEventListener('click', () => {
  const figure = button.closest('figure');
  show(pictures.indexOf(figure.querySelector('.open')));
  compare(document.getElementById(figure.dataset.pair));
  lightbox.showModal();
}));
lightbox.addEventListener('click', (event) => {
  const step = event.target.dataset.step;
  if (step) show(shown + Number(step));
  else if (!event.target.closest('.bar p, .split')) lightbox.close();
});
lightbox.addEventListener('keydown', (event) => {
  if (event.target.type === 'range') return;
  if (event.key === 'ArrowLeft') show(shown - 1);
  else if (event.key === 'ArrowRight') show(shown + 1);
  else if (event.key === 'Home') show(0);
  else if (event.key === 'End') show(pictures.length - 1);
  else return;
  event.preventDefault();
});
lightbox.addEventListener('close', () => pictures[shown].focus());  // where the reader has got to

// The pictures that fit all three choices.
const filters = document.querySelector('.filters');
function filter() {
  const {lab, view, method} = Object.fromEntries([...filters.querySelectorAll('select')].map((s) => [s.id, s.value]));
  let count = 0;
  for (const section of document.querySelectorAll('.lab')) {
    let any = false;
    for (const figure of section.querySelectorAll('figure')) {
      const {view: shows, methods} = figure.dataset;
      const fits = (!lab || section.id === lab) && (!view || shows === view) && (!method || methods.split(' ').includes(method));
      figure.hidden = !fits;
      any ||= fits;
      count += fits;
    }
    section.hidden = !any;
  }
  filters.querySelector('output').value = `${count} of ${pictures.length} pictures`;
}
filters.addEventListener('change', filter);
filter();
