
function callout(mistake) {
  return mistake && html`<p class="cause">This looks like: <b>${withCode(mistake.title)}</b>${withCode(mistake.rest)}</p>`;
}

/** One of the two pictures. The viewer makes a canvas of it. */
function pane({name, label, problem, url, width, height, values, channels}) {
  if (problem) return html`<figure class="pane"><p class="problem">${problem}</p><figcaption>${label}</figcaption></figure>`;
  const numbers = values && html`data-values="${values}" data-channels="${channels}"`;
  return html`<figure class="pane" data-pane="${name}"><img src="${url}" width="${width}" height="${height}" alt="${label}"
    ${numbers}><figcaption>${label}</figcaption></figure>`;
}

function viewer({view, unit, limit, isCompared, panes}) {
  if (panes.length === 0) return '';
  const pictures = html`<div class="panes" data-view="${view}">${panes.map(pane)}</div>`;
  return isCompared ? html`<div class="viewer" data-view="${view}" data-unit="${unit}" data-limit="${limit}">${pictures}</div>` : pictures;
}

function caseArticle(one) {
  return html`<article class="case">
    <h4>${one.name}
      ${one.hidden && html`<span class="tag">hidden case</span>`}
      ${one.view !== 'color' && html`<span class="tag">${one.view} view</span>`}
      ${one.isRight && html`<span class="tag">right, only other steps spoil it</span>`}</h4>
    ${one.message && html`<p>${withCode(one.message)}</p>`}
    ${one.figures && html`<p class="quiet">${one.figures}.</p>`}
    ${callout(one.mistake)}
    ${viewer(one)}
    ${one.command && commandLine(one.command)}</article>`;
}

/** A line of the names of cases of which there is no more to say. */
function otherCases(cases, style, symbol, says) {
  const names = cases.map(({name, hidden}) => name + (hidden ? ' (hidden)' : '')).join(', ');
  return names && html`<p class="others"><span class="${style}" aria-hidden="true">${symbol}</span> ${says}: ${names}</p>`;
}

function explanation(step) {
  return html`
    ${step.message && html`<p>${withCode(step.message)}</p>`}
    ${callout(step.mistake)}
    ${step.place && html`<p class="place">Written in <code>${step.place}</code></p>`}
    ${step.hint && html`<details class="hint"><summary>Hint</summary><p>${withCode(step.hint)}</p></details>`}
    ${step.wrong.map(caseArticle)}
    ${otherCases(step.same, 'failed', '✗', 'The same is true of')}
    ${otherCases(step.passed, 'passed', '✓', 'Passed')}`;
}

function stepSection(step) {
  return html`<section class="step ${step.style}" id="step-${step.id}">
    <h3><span class="symbol" aria-hidden="true">${step.symbol}</span><span>${step.id} ${step.title}</span><span
      class="spoken">${step.word}</span><span class="points">${step.earned} / ${step.points}</span></h3>
    ${step.overridden && html`<p class="cause">The teacher set these points: ${step.overridden}</p>`}
    ${step.judging && html`<p>${step.judging}</p>`}
    ${step.isExplained && explanation(step)}
    ${step.spoilt.length > 0 && html`<details><summary>${counted(step.spoilt.length, 'picture')} that other steps spoil</summary>
      ${step.spoilt.map(caseArticle)}</details>`}</section>`;
}

function labSection({number, title, points, maxPoints, notes, steps}) {
  return html`<section class="lab" id="lab${number}" aria-labelledby="title${number}">
    <header><p class="number" aria-hidden="true">${number}</p>
      <div><h2 id="title${number}">${title}</h2><p>${points} of ${maxPoints} points</p></div></header>
    ${notes.map((note) => html`<p class="cause">${note}</p>`)}
    ${steps.map(stepSection)}</section>`;
}

function logsSection() {
  return data.logs.length > 0 && html`<section id="compiler" class="logs"><h2>Compiler errors</h2>
    ${data.logs.map(({file, text}) => html`<details open><summary><code>${file}</code></summary><pre tabindex="0">${text}</pre></details>`)}
    </section>`;
}

function ignoredSection() {
  const few = 10;
  const {ignored} = data;
  return ignored.length > 0 && html`<section id="ignored"><details ${ignored.length <= few && 'open'}>
    <summary>${counted(ignored.length, 'file')} of the submission not used</summary>
    <ul>${ignored.map(({path, reason}) => html`<li><code>${path}</code> ${reason}</li>`)}</ul></details></section>`;
}

/** A line with a link to the files that were not used. */
function ignoredLink() {
  const count = data.ignored.length;
  return count > 0 && html`<p class="aside"><a href="#ignored">${counted(count, 'file')} of the submission</a> ${count === 1 ? 'is' : 'are'} not used.</p>`;
}

/** What to do first: the submission's or the grader's fault, or the first step that was begun and did not pass. */
function firstThing() {
  if (data.incident)
    return html`<div class="start incident"><p>${data.incidentSays}</p>
      <details><summary>What happened</summary><p>${data.incident}</p></details></div>`;
  if (data.unmarked) return html`<div class="start incident"><p>Not graded yet: ${data.unmarked}.</p></div>`;
  if (data.fault) return html`<div class="start failed"><p>The submission ${data.fault}</p></div>`;
  const wrong = data.labs.flatMap(({steps}) => steps).filter(({style}) => style !== 'passed');
  const step = wrong.find(({isUntouched}) => !isUntouched) ?? wrong[0];
  if (step) {
    const how = data.logs.length > 0 ? html`Correct the <a href="#compiler">compiler's errors</a>, then` :
        step.isUntouched ? 'All that you began is right. Next is' : 'Correct this first:';
    return html`<div class="start ${step.isUntouched ? 'skipped' : 'failed'}">
      <p>${how} <a href="#step-${step.id}">step ${step.id}: ${step.title}</a></p></div>${ignoredLink()}`;
  }
  return data.labs.length > 0 && html`<div class="start passed"><p>Every step passed.</p></div>${ignoredLink()}`;
}

function mark() {
  if (data.unmarked) return 'Not graded';
  return data.labs.length === 0 ? html`0 <small>points</small>` : html`${data.points} <small>of ${data.maxPoints} points</small>`;
}

function contents() {
  return data.labs.length > 0 && html`<nav aria-label="Labs"><ol>${data.labs.map(({number, title, points, maxPoints}) =>
      html`<li><a href="#lab${number}"><b>${number}</b> ${title} <span>${points}/${maxPoints}</span></a></li>`)}</ol></nav>`;
}

const shownCases = data.labs.flatMap(({steps}) => steps).flatMap(({wrong, spoilt}) => [...wrong, ...spoilt]);
const hasPictures = shownCases.some(({panes}) => panes.length > 0);

show(html`
  <header class="masthead student"><div><h1><bdi>${data.name}</bdi></h1><p>${data.number}</p></div>
    <p class="mark">${mark()}</p>${firstThing()}</header>
  ${contents()}
  <main>${logsSection()}${data.labs.map(labSection)}${ignoredSection()}
    <section id="facts"><h2>Facts</h2>${factsList(data.facts)}
      ${hasPictures && shownCases.some(({command}) => command) &&
        html`<p class="quiet">The command below a picture draws it again in your own tree.</p>`}
      ${hasPictures && data.isReduced &&
        html`<p class="quiet">To keep this page small, some pictures are small or have no difference.</p>`}</section></main>`);

