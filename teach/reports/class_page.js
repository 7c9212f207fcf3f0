
const students = data.students;

/** The labs of the class with their steps, each as the student has it who has the most: one whose submission could not be read has none. */
function labsOfClass() {
  const labs = new Map();
  for (const lab of students.flatMap((student) => student.labs))
    if (lab.steps.length > (labs.get(lab.number)?.steps.length ?? -1)) labs.set(lab.number, lab);
  return [...labs.values()].sort((a, b) => a.number - b.number);
}

const labs = labsOfClass();
const columns = labs.flatMap(({steps}) => steps.map((step, i) => ({...step, first: i === 0 && 'first'})));

function stepOf(student, id) {
  return student.labs.flatMap(({steps}) => steps).find((step) => step.id === id);
}

function says({title, rest}) {
  return `This looks like: ${title}${rest}`;
}

function tableHead() {
  const column = (label, style, title) => html`<th scope="col" class="${style}" aria-sort="none"><button type="button"
    title="${title}">${label}</button></th>`;
  return html`<thead>
    <tr><td colspan="2"></td>${labs.map(({number, title, steps}) =>
        html`<th scope="colgroup" colspan="${steps.length}" title="${title}">Lab ${number}</th>`)}</tr>
    <tr>${column('Student', 'name', 'Sort by name')}${column('Points', 'number', 'Sort by points')}${columns.map((step) =>
        column(step.id, `step ${step.first || ''}`, `Sort by step ${step.id}: ${step.title}, ${step.points} points`))}</tr></thead>`;
}

function cell(step, first, page) {
  if (!step) return html`<td class="step ${first}" data-sort="-1"></td>`;
  let title = `${step.id} ${step.title}: ${step.word}, ${step.earned} of ${step.points}`;
  if (step.mistake) title += `. ${says(step.mistake)}`;
  if (step.overridden) title += `. Set by the teacher: ${step.overridden}`;
  return html`<td class="step ${step.style} ${first}" data-sort="${step.score}" title="${title}"><a
    href="${page}#step-${step.id}"><span aria-hidden="true">${step.symbol}${step.overridden && '*'}</span><span
    class="spoken">${step.id} ${step.word}</span></a></td>`;
}

/** Without a mark only what passed is known. */
function known(step) {
  return step && step.style !== 'passed' ? {...step, style: '', symbol: '·', word: 'not judged', earned: '–', mistake: null} : step;
}

function row(student) {
  const steps = columns.map(({id}) => stepOf(student, id)).map((step) => student.unmarked ? known(step) : step);
  const isDone = student.readable && steps.every((step) => step?.style === 'passed');
  const mistakes = steps.filter((step) => step?.mistake && step.style !== 'passed').map((step) => step.mistake.name);
  return html`<tr data-state="${student.unmarked ? 'incident' : isDone ? 'passed' : 'open'}"
    data-mistakes=" ${mistakes.join(' ')} "><th scope="row" class="name"><a
    href="${student.page}"><bdi>${student.name}</bdi></a><span class="quiet">${student.number}</span>${
    student.note && html`<span class="note ${student.noteStyle}">${student.note}</span>`}</th><td class="number"
    data-sort="${student.sort}">${student.points}</td>${steps.map((step, i) => cell(step, columns[i].first, student.page))}</tr>`;
}

function tableFoot() {
  const passed = ({id}) => students.filter((student) => stepOf(student, id)?.style === 'passed').length;
  return html`<tfoot><tr><th scope="row" class="name">Passed by</th><td class="number"></td>${columns.map((step) =>
      html`<td class="step ${step.first}">${passed(step)}</td>`)}</tr></tfoot>`;
}

function studentsSection() {
  return html`<section id="students"><h2>Students</h2>${distribution()}<div class="filter">
    <label>Find <input type="search" id="find" placeholder="name or number" autocomplete="off"></label>
    <label>Show <select id="show"><option value="">all</option><option value="open">with work to do</option><option
      value="passed">all steps passed</option><option value="incident">not graded</option></select></label>
    <button type="button" id="mistake" hidden></button>
    <p id="shown" role="status"></p></div>
    <button type="button" id="more" hidden></button>
    <div class="scroll" tabindex="0" role="region" aria-label="Students and steps">
      <table class="class">${tableHead()}<tbody>${students.map(row)}</tbody>${tableFoot()}</table></div>
    <p class="legend"><span class="passed">✓</span> passed <span class="partial">◐</span> in part
      <span class="failed">✗</span> not yet <span class="skipped">–</span> not begun <span>·</span> not judged
      <span>*</span> set by the teacher</p></section>`;
}

/** How many students have which share of all points, in ten parts. */
function distribution() {
  const most = columns.reduce((sum, {points}) => sum + Number(points), 0);
  const marked = students.filter(({sort}) => sort >= 0);
  if (marked.length < 2 || !(most > 0)) return '';
  const counts = Array(10).fill(0);
  for (const {sort} of marked) ++counts[Math.min(Math.floor(10 * sort / most), 9)];
  const high = Math.max(...counts);
  return html`<figure class="distribution"><ol>${counts.map((count, i) => html`<li title="${counted(count, 'student')} with ${10 * i} to ${
      10 * (i + 1)} % of the points"><span>${count || ''}</span><svg viewBox="0 0 1 ${high}" preserveAspectRatio="none"
    aria-hidden="true"><rect y="${high - count}" width="1" height="${count}"/></svg></li>`)}</ol>
    <figcaption><span>0</span><span>students by points</span><span>${most}</span></figcaption></figure>`;
}

/** A line of a histogram: a number and its bar, at most `most` long. */
function histogramLine(count, most, text) {
  return html`<li><span class="count">${count}</span><svg class="bar" viewBox="0 0 ${most} 1" preserveAspectRatio="none"
    aria-hidden="true"><rect width="${count}" height="1"/></svg><div>${text}</div></li>`;
}

/** The steps that anybody began, with how many did and how many of them failed. Those first that fail most often. */
function triedSteps() {
  const tried = new Map();
  for (const {id, title, style, begun} of students.flatMap((student) => student.labs).flatMap(({steps}) => steps)) {
    if (!begun) continue;
    const step = tried.get(id) ?? {id, title, begun: 0, failed: 0};
    ++step.begun;
    if (style !== 'passed') ++step.failed;
    tried.set(id, step);
  }
  return [...tried.values()].sort((a, b) => b.failed - a.failed || (a.id < b.id ? -1 : 1));
}

const tried = triedSteps();

function stepsSection() {
  const lines = tried.filter(({failed}) => failed > 0).map(({id, title, begun, failed}) => histogramLine(failed, begun,
      html`${id} ${withCode(title)} <span class="quiet">${Math.round(100 * failed / begun)} % of ${counted(begun, 'student')}
        who began it</span>`));
  return html`<section id="steps"><h2>Steps that are not right yet</h2>
    ${lines.length > 0 ? html`<ol class="histogram">${lines}</ol>` : html`<p>None of those that are begun.</p>`}</section>`;
}

/** The mistakes with their steps and how many students made them, those first that most made. A student counts once. */
function mistakesMade() {
  const made = new Map();
  for (const student of students)
    for (const {id, style, mistake} of student.labs.flatMap(({steps}) => steps)) {
      if (style === 'passed' || !mistake) continue;
      const one = Object.assign(made.get(mistake.name) ?? {steps: new Set(), students: new Set()}, mistake);
      one.steps.add(id);
      one.students.add(student);
      made.set(mistake.name, one);
    }
  return [...made.values()].sort((a, b) => b.students.size - a.students.size || (a.name < b.name ? -1 : 1));
}

/** Of those who began the step, or one of the steps. */
const beganOneOf = (steps) => Math.max(...[...steps].map((id) => tried.find((one) => one.id === id)?.begun ?? 0));

/** "3 of 40 students who began 5.2", or the steps in which a mistake was made. */
function whoMade({steps, students: makers}) {
  if (steps.size > 1) return `steps ${[...steps].sort().join(', ')}`;
  const [id] = steps;
  const step = tried.find((one) => one.id === id);
  return step ? `${makers.size} of ${counted(step.begun, 'student')} who began ${id}` : counted(makers.size, 'student');
}

function mistakesSection() {
  const made = mistakesMade();
  const unnamed = students.flatMap((student) => student.labs).flatMap(({steps}) => steps)
      .filter(({style, mistake}) => (style === 'failed' || style === 'partial') && !mistake);
  const bySteps = columns.map(({id}) => [id, unnamed.filter((step) => step.id === id).length]).filter(([, count]) => count > 0);
  const sentence = (rest) => rest.replace(/^[.:; ]+/, '').replace(/^[a-z]/, (c) => c.toUpperCase());
  return html`<section id="mistakes"><h2>Mistakes</h2>
    ${made.length > 0 && html`<ol class="histogram">${made.map((one) => histogramLine(one.students.size, Math.max(beganOneOf(one.steps), one.students.size),
        html`<button type="button" class="pick" data-mistake="${one.name}" title="Show these students">${withCode(one.title)}</button>
          <span class="quiet">${whoMade(one)}</span><p>${withCode(sentence(one.rest))}</p>`))}</ol>`}
    ${unnamed.length === 0 && made.length === 0 ? html`<p>None.</p>` :
      html`<p class="quiet">${counted(unnamed.length, 'failed step')} ${unnamed.length === 1 ? 'looks' : 'look'} like no known mistake${
          bySteps.map(([id, count], i) => `${i === 0 ? ': ' : ', '}${id} (${count})`).join('')}.</p>`}</section>`;
}

function incidentsSection() {
  const unmarked = students.filter((student) => student.unmarked);
  return unmarked.length > 0 && html`<section id="incidents"><h2>Not graded</h2><p>The grader or the machine failed, or the run is not
    finished. These students have no new mark; earlier marks are kept. Grade again with <code>--resume</code>.</p>
    <dl class="incidents">${unmarked.map((student) => html`<dt><a href="${student.page}"><bdi>${student.name}</bdi></a></dt><dd>${
        student.unmarked}</dd>`)}</dl></section>`;
}

function changesSection() {
  const line = ({name, page, step, before, after, rises}) => html`<tr><th scope="row" class="name">${
      page ? html`<a href="${page}#step-${step}"><bdi>${name}</bdi></a>` : name}</th><td>${step}</td><td
      class="number">${before} %</td><td class="number">${after} %</td><td class="${rises ? 'passed' : 'failed'}">${
      rises ? '▲' : '▼'}</td></tr>`;
  return data.changes.length > 0 && html`<section id="changes"><h2>Changed since the last grading</h2><div class="scroll"><table>
    <thead><tr><th scope="col" class="name">Student</th><th scope="col">Step</th><th scope="col">before</th><th
      scope="col">after</th><th></th></tr></thead><tbody>${data.changes.map(line)}</tbody></table></div></section>`;
}

const incidents = incidentsSection(), changes = changesSection();
show(html`
  <header class="masthead"><h1>Class report</h1><p>${data.summary}</p></header>
  <nav aria-label="Sections"><ol><li><a href="#students">Students</a></li><li><a href="#steps">Steps</a></li><li><a
    href="#mistakes">Mistakes</a></li>${incidents && html`<li><a href="#incidents">Not graded</a></li>`}${
    changes && html`<li><a href="#changes">Changed</a></li>`}<li><a href="#facts">Facts</a></li></ol></nav>
  <main>${studentsSection()}${stepsSection()}${mistakesSection()}${incidents}${changes}
    <section id="facts"><h2>Facts</h2>${factsList(data.facts)}</section></main>`);

