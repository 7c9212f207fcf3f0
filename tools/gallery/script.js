'use strict';
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
