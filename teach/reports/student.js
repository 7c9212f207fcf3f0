
// A failed case: yours, expected and the difference side by side, with the numbers behind one pixel.

/** The bytes of a PNG of 8 bits, grey or RGB: read by ourselves, since some browsers falsify a canvas's. */
async function readPng(url) {
  const bytes = Uint8Array.from(atob(url.slice(url.indexOf(',') + 1)), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const width = view.getUint32(16);
  const height = view.getUint32(20);
  const channels = bytes[25] === 2 ? 3 : 1;
  const packed = [];
  for (let at = 8; at < bytes.length; at += view.getUint32(at) + 12)
    if (view.getUint32(at + 4) === 0x49444154) packed.push(bytes.subarray(at + 8, at + 8 + view.getUint32(at)));
  const stream = new Blob(packed).stream().pipeThrough(new DecompressionStream('deflate'));
  const rows = new Uint8Array(await new Response(stream).arrayBuffer());
  const row = width * channels;
  const samples = new Uint8Array(row * height);
  for (let y = 0, from = 0, to = 0; y < height; ++y) {
    const filter = rows[from++];
    for (let x = 0; x < row; ++x, ++from, ++to) {
      const left = x < channels ? 0 : samples[to - channels];
      const up = y === 0 ? 0 : samples[to - row];
      const corner = x < channels || y === 0 ? 0 : samples[to - row - channels];
      let guess = 0;
      if (filter === 1) guess = left;
      if (filter === 2) guess = up;
      if (filter === 3) guess = (left + up) >> 1;
      if (filter === 4) {
        const p = left + up - corner;
        const a = Math.abs(p - left), b = Math.abs(p - up), c = Math.abs(p - corner);
        guess = a <= b && a <= c ? left : b <= c ? up : corner;
      }
      samples[to] = rows[from] + guess;
    }
  }
  return {width, height, channels, samples};
}

/** A picture's numbers: 0 to 255 of a colour picture, or a data view's floats, of which 24 bits are kept. */
async function readNumbers(image) {
  if (!image.dataset.values) return readPng(image.src);
  const planes = await readPng(image.dataset.values);
  const channels = Number(image.dataset.channels);
  const width = planes.width;
  const height = planes.height / (3 * channels);
  const plane = width * height;
  const bits = new Uint32Array(plane * channels);
  for (let c = 0; c < channels; ++c)
    for (let i = 0; i < plane; ++i)
      for (let part = 0; part < 3; ++part)
        bits[i * channels + c] |= planes.samples[(3 * c + part) * plane + i] << (24 - 8 * part);
  return {width, height, channels, samples: new Float32Array(bits.buffer)};
}

/** How far two pixels are apart in the case's unit, as the grader counts it but without its mercy at edges. */
function distance(a, b, unit, view) {
  if (![...a, ...b].every(Number.isFinite)) return Infinity;
  if (unit === 'degrees') {
    const lengthA = Math.hypot(...a), lengthB = Math.hypot(...b);
    if (lengthA === 0 || lengthB === 0) return lengthA === lengthB ? 0 : 180;
    const cross = Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    return Math.atan2(cross, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / Math.PI;
  }
  const apart = a.map((value, c) => Math.abs(value - b[c]));
  return view === 'texcoord' ? Math.hypot(apart[0], apart[1]) : Math.max(...apart);
}

const kChannels = {color: ['R', 'G', 'B'], texcoord: ['s', 't'], lod: ['level'], depth: ['depth'], mask: ['mask']};

/** A colour of the heat map, for t from 0 to 1. */
function heat(t) {
  const at = t * (data.heat.length - 1);
  const i = Math.min(Math.floor(at), data.heat.length - 2);
  return data.heat[i].map((value, c) => 255 * (value + (data.heat[i + 1][c] - value) * (at - i)));
}

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function shortNumber(value) {
  if (!Number.isFinite(value)) return String(value);
  return value === 0 ? '0' : Math.abs(value) < 0.01 ? value.toExponential(1) : Number(value.toPrecision(3)).toString();
}

class Viewer {
  constructor(root) {
    this.root = root;
    this.view = root.dataset.view;
    this.unit = root.dataset.unit;
    this.limit = Number(root.dataset.limit);
    this.grid = root.querySelector('.panes');
    this.panes = [];
    this.split = 1;      // of the first pane: what is left of it is yours
    this.zoom = 1;       // 1 shows all
    this.origin = [0, 0];  // the pixel in the upper left corner
    this.pixel = [0, 0];   // the one whose numbers are shown, from the upper left
  }

  async make() {
    for (const figure of this.grid.querySelectorAll('[data-pane]')) {
      const image = figure.querySelector('img');
      await image.decode();
      this[figure.dataset.pane] = {image, ...await readNumbers(image)};
      this.addPane(figure, figure.dataset.pane);
    }
    const base = this.expected || this.yours;
    if (!base) return;
    this.width = base.width;
    this.height = base.height;
    this.names = kChannels[this.view] || ['x', 'y', 'z'];
    this.pixel = [this.width >> 1, this.height >> 1];
    const both = this.yours && this.expected;
    if (both && this.yours.width === this.width && this.yours.height === this.height) this.measure();
    this.addReadout();
    this.addControls(both);
    this.listen();
    if (this.difference) this.toWorst();
    new ResizeObserver(() => this.draw()).observe(this.grid);
    this.draw();
  }

  addPane(figure, name) {
    const canvas = element('canvas');
    const caption = figure.querySelector('figcaption');
    const image = figure.querySelector('img');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', caption.textContent);
    if (image) image.replaceWith(canvas);
    else figure.prepend(canvas);
    this.panes.push({name, canvas, caption});
  }

  at(picture, x, y) {
    if (!picture || x >= picture.width || y >= picture.height) return null;
    const from = (y * picture.width + x) * picture.channels;
    return [...picture.samples.subarray(from, from + picture.channels)];
  }

  /** The difference of each pixel, and its largest. */
  measure() {
    this.difference = new Float32Array(this.width * this.height);
    this.largest = 0;
    for (let y = 0, i = 0; y < this.height; ++y)
      for (let x = 0; x < this.width; ++x, ++i) {
        this.difference[i] = distance(this.at(this.yours, x, y), this.at(this.expected, x, y), this.unit, this.view);
        if (Number.isFinite(this.difference[i])) this.largest = Math.max(this.largest, this.difference[i]);
      }
    this.map = element('canvas', {width: this.width, height: this.height});
    const figure = element('figure', {className: 'pane difference'}, element('figcaption', {
      textContent: `Difference, up to ${shortNumber(this.largest)} ${this.unit}; coloured above the tolerance`}));
    this.grid.append(figure);
    this.addPane(figure, 'difference');
    this.tolerance = this.limit;
    this.mark();
  }

  /** Colours the difference: grey within the tolerance, marked above it. */
  mark() {
    const picture = new ImageData(this.width, this.height);
    this.above = 0;
    this.difference.forEach((value, i) => {
      const share = this.largest > 0 ? value / this.largest : 0;
      let color = [30 + 70 * share, 30 + 70 * share, 34 + 70 * share];
      if (value > this.tolerance) {
        ++this.above;
        color = Number.isFinite(value) ? heat(0.35 + 0.65 * share) : [255, 0, 255];
      }
      picture.data.set([...color, 255], 4 * i);
    });
    this.map.getContext('2d').putImageData(picture, 0, 0);
  }

  addReadout() {
    this.readout = element('table');
    this.readout.setAttribute('aria-live', 'polite');
    this.grid.append(element('div', {className: 'readout'}, this.readout));
  }

  button(label, title, action) {
    const button = element('button', {type: 'button', textContent: label, title});
    button.setAttribute('aria-label', title);
    button.addEventListener('click', () => { action(); this.draw(); });
    return button;
  }

  slider(label, value, action) {
    const input = element('input', {type: 'range', min: 0, max: 100, step: 1, value});
    const output = element('output');
    input.addEventListener('input', () => { action(Number(input.value)); this.draw(); });
    return {input, output, label: element('label', {}, label, input, output)};
  }

  addControls(both) {
    this.grid.tabIndex = 0;
    this.grid.setAttribute('role', 'group');
    this.grid.setAttribute('aria-label', 'Pictures. Arrow keys select a pixel, plus and minus zoom, 0 shows everything, ' +
        'S splits the view, W goes to the worst pixel.');
    const buttons = element('div', {className: 'buttons'},
        this.button('−', 'Zoom out', () => this.zoomBy(0.5)), this.button('+', 'Zoom in', () => this.zoomBy(2)),
        this.button('Fit', 'Show the whole picture', () => this.zoomBy(0)));
    const controls = element('div', {className: 'controls'}, buttons);
    if (both) {
      this.splitter = this.slider('Split', 100, (value) => { this.split = value / 100; });
      controls.append(this.splitter.label);
    }
    if (this.difference) {
      buttons.append(this.button('Worst pixel', 'Go to the largest difference', () => this.toWorst()));
      // A square makes small tolerances easy to choose.
      this.tolerancer = this.slider('Tolerance', 100 * Math.min(1, Math.sqrt(this.limit / (this.largest || 1))), (value) => {
        const chosen = this.largest * (value / 100) ** 2;
        this.tolerance = this.view === 'color' ? Math.round(chosen) : chosen;
        this.mark();
      });
      controls.append(this.tolerancer.label);
    }
    this.root.append(controls);
    if (this.root === document.querySelector('.viewer'))  // said once
      controls.append(element('p', {className: 'keys', textContent: 'Keys (press Tab or click a picture first): arrow ' +
          'keys select a pixel, with Shift 8 pixels at a time; + and − or the wheel zoom; 0 shows everything; S splits; W goes to the ' +
          'worst pixel.'}));
  }

  toWorst() {
    let worst = 0;
    this.difference.forEach((value, i) => { if (value > this.difference[worst]) worst = i; });
    this.choose(worst % this.width, Math.floor(worst / this.width));
  }

  /** Chooses a pixel, and moves what is shown so that it is seen. */
  choose(x, y) {
    const limits = [this.width, this.height];
    [x, y].forEach((value, axis) => {
      const shown = limits[axis] / this.zoom;
      this.pixel[axis] = Math.min(Math.max(Math.floor(value), 0), limits[axis] - 1);
      this.origin[axis] = Math.min(Math.max(this.origin[axis], this.pixel[axis] + 1 - shown), this.pixel[axis]);
    });
    this.clamp();
  }

  clamp() {
    [this.width, this.height].forEach((limit, axis) => {
      this.origin[axis] = Math.min(Math.max(this.origin[axis], 0), limit - limit / this.zoom);
    });
    this.root.classList.toggle('zoomed', this.zoom > 1);
  }

  /** Zooms and keeps a place where it is: the chosen pixel's middle, unless told. 0 shows all. */
  zoomBy(factor, place = [this.pixel[0] + 0.5, this.pixel[1] + 0.5]) {
    let zoom = Math.min(Math.max(this.zoom * factor, 1), 32);
    if (zoom < 1.01) zoom = 1;  // what the wheel's roots of 2 leave
    this.origin = this.origin.map((from, axis) => place[axis] - (place[axis] - from) * this.zoom / zoom);
    this.zoom = zoom;
    this.clamp();
  }

  listen() {
    const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    this.grid.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const step = steps[event.key];
      const far = event.shiftKey ? 8 : 1;
      if (step) this.choose(this.pixel[0] + far * step[0], this.pixel[1] + far * step[1]);
      else if (event.key === '+' || event.key === '=') this.zoomBy(2);
      else if (event.key === '-') this.zoomBy(0.5);
      else if (event.key === '0') this.zoomBy(0);
      else if (event.key.toLowerCase() === 's' && this.splitter) this.setSplit(this.split > 0.75 ? 50 : this.split > 0.25 ? 0 : 100);
      else if (event.key.toLowerCase() === 'w' && this.difference) this.toWorst();
      else return;
      event.preventDefault();
      this.draw();
    });
    for (const {canvas} of this.panes) {
      const place = (event) => {
        const box = canvas.getBoundingClientRect();
        return [this.origin[0] + (event.clientX - box.left) / box.width * this.width / this.zoom,
                this.origin[1] + (event.clientY - box.top) / box.height * this.height / this.zoom];
      };
      let held = null;
      canvas.addEventListener('pointerdown', (event) => {
        held = place(event);
        if (this.zoom > 1) canvas.setPointerCapture(event.pointerId);
        this.choose(...held);
        this.draw();
      });
      canvas.addEventListener('pointermove', (event) => {
        const now = place(event);
        if (held && this.zoom > 1) {  // the place that was taken hold of stays below the pointer
          this.origin = this.origin.map((from, axis) => from + held[axis] - now[axis]);
          this.clamp();
        } else if (event.pointerType === 'mouse') {
          this.choose(...now);
        }
        this.draw();
      });
      for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { held = null; });
      canvas.addEventListener('wheel', (event) => {
        if (document.activeElement !== this.grid) return;  // else the page could not be scrolled past pictures
        event.preventDefault();
        this.zoomBy(2 ** (-Math.sign(event.deltaY) / 2), place(event));
        this.draw();
      }, {passive: false});
    }
  }

  setSplit(percent) {
    this.splitter.input.value = percent;
    this.split = percent / 100;
  }

  draw() {
    for (const pane of this.panes) this.drawPane(pane);
    this.drawReadout();
    if (this.splitter) this.splitter.output.value = this.split === 1 ? 'yours' : this.split === 0 ? 'expected' : `${Math.round(100 * this.split)} %`;
    if (this.tolerancer)
      this.tolerancer.output.value = `${shortNumber(this.tolerance)} ${this.unit}: ${this.above} pixels above` +
          ` (${shortNumber(100 * this.above / this.difference.length)} %)`;
  }

  drawPane({name, canvas, caption}) {
    const scale = window.devicePixelRatio || 1;
    const width = Math.round((canvas.clientWidth || this.width) * scale);
    const height = Math.round(width * this.height / this.width);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const context = canvas.getContext('2d');
    context.imageSmoothingEnabled = false;
    context.fillStyle = '#363941';
    context.fillRect(0, 0, width, height);
    const paint = (source, sourceWidth, sourceHeight) => {
      const fitX = sourceWidth / this.width, fitY = sourceHeight / this.height;
      context.drawImage(source, this.origin[0] * fitX, this.origin[1] * fitY, sourceWidth / this.zoom,
                        sourceHeight / this.zoom, 0, 0, width, height);
    };
    if (name === 'difference') {
      paint(this.map, this.width, this.height);
    } else {
      paint(this[name].image, this[name].width, this[name].height);
      if (name === 'yours' && this.split < 1) {
        const border = Math.round(this.split * width);
        context.save();
        context.beginPath();
        context.rect(border, 0, width - border, height);
        context.clip();
        paint(this.expected.image, this.width, this.height);
        context.restore();
        context.fillStyle = '#fff';
        context.fillRect(border - scale, 0, 2 * scale, height);
      }
      if (name === 'yours')
        caption.textContent = this.split === 1 ? 'Yours' : this.split === 0 ? 'Expected instead of yours' : 'Yours | Expected';
    }
    // The chosen pixel, in a frame that is seen on light and dark.
    const size = width * this.zoom / this.width;
    const frame = Math.max(size, 7 * scale);
    const [x, y] = [0, 1].map((axis) => (this.pixel[axis] + 0.5 - this.origin[axis]) * size - frame / 2);
    for (const [style, line] of [['#000', 3], ['#fff', 1]]) {
      context.strokeStyle = style;
      context.lineWidth = line * scale;
      context.strokeRect(x, y, frame, frame);
    }
  }

  drawReadout() {
    const [x, y] = this.pixel;
    const text = (value) => value === undefined ? '' : this.view === 'color' ? value : Number.isFinite(value) ? value.toFixed(4) : value;
    const line = (label, values) => element('tr', {}, element('th', {scope: 'row', textContent: label}),
        ...this.names.map((_, c) => element('td', {textContent: values ? text(values[c]) : ''})));
    const rows = [element('tr', {}, element('th'), ...this.names.map((name) => element('th', {scope: 'col', textContent: name})))];
    if (this.yours) rows.push(line('Yours', this.at(this.yours, x, y)));
    if (this.expected) rows.push(line('Expected', this.at(this.expected, x, y)));
    if (this.difference) {
      const value = this.difference[y * this.width + x];
      rows.push(element('tr', {}, element('th', {scope: 'row', textContent: 'Difference'}), element('td', {
        colSpan: this.names.length, className: value > this.tolerance ? 'far' : '',
        textContent: `${shortNumber(value)} ${this.unit}`})));
    }
    this.readout.replaceChildren(
        element('caption', {textContent: `Pixel ${x}, ${this.height - 1 - y} from the lower left`}), ...rows);
  }
}

// Pictures are unpacked when they come near: a page may hold hundreds.
const near = new IntersectionObserver((entries) => {
  for (const {target, isIntersecting} of entries) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    new Viewer(target).make().then(() => target.classList.add('ready'), (error) => {
      target.append(element('p', {className: 'problem', textContent:
        `The pictures cannot be compared here (${error.message}). Use a browser from 2023 or later.`}));
    });
  }
}, {rootMargin: '400px'});
for (const viewer of document.querySelectorAll('.viewer')) near.observe(viewer);
