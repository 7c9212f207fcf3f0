'use strict';
const pictures = [...document.querySelectorAll('figure .open')];
const lightbox = document.getElementById('lightbox');
let shown = 0;

function show(index) {
  shown = (index + pictures.length) % pictures.length;
  const figure = pictures[shown].closest('figure');
  const image = lightbox.querySelector('img');
  image.src = pictures[shown].href;
  image.alt = figure.querySelector('img').alt;
  lightbox.querySelector('b').textContent = figure.querySelector('.caption').textContent;
  lightbox.querySelector('span').textContent =
      figure.closest('.lab').querySelector('h2').textContent + ', picture ' + (shown + 1) + ' of ' + pictures.length;
}

pictures.forEach((picture, index) => picture.addEventListener('click', (event) => {
  if (event.ctrlKey || event.metaKey || event.shiftKey) return;  // a new tab shows the file itself
  event.preventDefault();
  show(index);
  lightbox.showModal();
}));
lightbox.addEventListener('click', (event) => {
  const step = event.target.dataset.step;
  if (step) show(shown + Number(step));
  else if (!event.target.closest('.bar p')) lightbox.close();
});
lightbox.addEventListener('keydown', (event) => {
  if (event.key === 'ArrowLeft') show(shown - 1);
  else if (event.key === 'ArrowRight') show(shown + 1);
  else if (event.key === 'Home') show(0);
  else if (event.key === 'End') show(pictures.length - 1);
  else return;
  event.preventDefault();
});
lightbox.addEventListener('close', () => pictures[shown].focus());  // where the reader has got to
