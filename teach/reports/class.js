
// The table of students: sorted by a click on a column's head, filtered by name, state and mistake.
const table = document.querySelector('table.class');
const rows = [...table.tBodies[0].rows];
const find = document.getElementById('find');
const state = document.getElementById('show');
const mistake = document.getElementById('mistake');

function filter() {
  const wanted = find.value.trim().toLowerCase();
  const made = mistake.dataset.mistake;
  let count = 0;
  for (const row of rows) {
    row.hidden = !(row.cells[0].textContent.toLowerCase().includes(wanted) &&
                   (!state.value || row.dataset.state === state.value) &&
                   (!made || row.dataset.mistakes.includes(` ${made} `)));
    if (!row.hidden) ++count;
  }
  document.getElementById('shown').textContent =
      count === rows.length ? '' : `${count} of ${rows.length} students`;
}
find.addEventListener('input', filter);
state.addEventListener('change', filter);

for (const button of document.querySelectorAll('.pick')) {
  button.addEventListener('click', () => {
    mistake.dataset.mistake = button.dataset.mistake;
    mistake.textContent = `${button.textContent} ×`;
    mistake.setAttribute('aria-label', `Show all again, not only: ${button.textContent}`);
    mistake.hidden = false;
    filter();
    document.getElementById('students').scrollIntoView();
    mistake.focus({preventScroll: true});
  });
}
mistake.addEventListener('click', () => {
  delete mistake.dataset.mistake;
  mistake.hidden = true;
  filter();
  find.focus();
});

const heads = [...table.tHead.rows[1].cells];
const byName = new Intl.Collator(undefined, {numeric: true, sensitivity: 'base'});
heads.forEach((head, column) => head.firstElementChild.addEventListener('click', () => {
  // Names begin at A, points with the most.
  const first = column === 0 ? 'ascending' : 'descending';
  const second = column === 0 ? 'descending' : 'ascending';
  const order = head.getAttribute('aria-sort') === first ? second : first;
  for (const other of heads) other.setAttribute('aria-sort', other === head ? order : 'none');
  const key = (row) => column === 0 ? row.querySelector('a').textContent : Number(row.cells[column].dataset.sort);
  const sign = order === 'ascending' ? 1 : -1;
  const compare = column === 0 ? (a, b) => byName.compare(key(a), key(b)) : (a, b) => key(a) - key(b);
  rows.sort((a, b) => sign * compare(a, b));
  table.tBodies[0].append(...rows);
}));

// Wide classes: which labs are out of view, and a button that goes there.
const scroller = document.querySelector('.scroll');
const more = document.getElementById('more');
function tellMore() {
  const right = scroller.getBoundingClientRect().right;
  const hidden = [...table.tHead.rows[0].querySelectorAll('th')].filter((lab) => lab.getBoundingClientRect().right > right + 1);
  const names = hidden.map((lab) => lab.textContent);
  const isAtEnd = scroller.scrollLeft + scroller.clientWidth >= scroller.scrollWidth - 1;
  more.hidden = scroller.scrollWidth <= scroller.clientWidth;
  more.textContent = isAtEnd || !hidden.length ? '← Back to the first lab' :
      `More to the right: ${names.length > 3 ? `${names[0]} to ${names.at(-1)}` : names.join(', ')} →`;
  more.dataset.end = isAtEnd;
}
more.addEventListener('click', () => {
  const names = table.tHead.rows[1].cells[0].offsetWidth;  // they stay in view
  scroller.scrollTo({left: more.dataset.end === 'true' ? 0 : scroller.scrollLeft + scroller.clientWidth - names});
});
scroller.addEventListener('scroll', tellMore);
new ResizeObserver(tellMore).observe(scroller);
