// The page itself: time, colours, hands and words. It draws only if something changed.

const kScales = [0.3, 0.4, 0.5, 0.65, 0.8, 1];     // samples per pixel of the screen along an edge, in motion
const kSmoothScales = [2, 1.5];                    // of a picture that stays
const kFluent = 40, kSmoothed = 250;               // ms that a picture may take in motion; when it stays
const kSettle = 150, kSmooth = 400;                // ms without a change before either
const kMostSamples = 9e6;
const kTap = 6;                                    // px that a tap may move
const kRates = [0.25, 0.5, 1, 2, 4, 8];
const kSlow = 60;                                  // s from which a slide begins at twice its speed

const part = id => document.getElementById(id);
const number = (value, digits = 0) =>
    value.toLocaleString('en', {minimumFractionDigits: digits, maximumFractionDigits: digits}).replace('-', '−');
const signed = (value, digits) => (Number(value.toFixed(digits)) > 0 ? '+' : '') + number(value, digits);

// Adds an element with a text, which is never read as HTML.
function add(parent, tag, text) {
    const element = parent.appendChild(document.createElement(tag));
    if (text !== undefined) element.textContent = text;
    return element;
}

// Replaces the page by a sentence.
function fail(sentence) {
    document.documentElement.dataset.state = 'failed';
    const note = part('note');
    note.hidden = false;
    note.setAttribute('role', 'alert');
    note.textContent = sentence;
}

// Where a point of the grid is on Earth, between its corners: "47.30012° N 11.43210° E".
function placeOnEarth(info, x, y) {
    if (!info.georeference) return null;
    const u = x / ((info.grid.nx - 1) * info.grid.dx), v = y / ((info.grid.ny - 1) * info.grid.dx);
    const weights = [(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v];  // south-west, south-east, north-west, …
    const [latitude, longitude] = [0, 1].map(axis =>
        info.georeference.corners.reduce((sum, corner, i) => sum + weights[i] * corner[axis], 0));
    return `${Math.abs(latitude).toFixed(5)}° ${latitude < 0 ? 'S' : 'N'} ` +
        `${Math.abs(longitude).toFixed(5)}° ${longitude < 0 ? 'W' : 'E'}`;
}

// Everything that follows the slide: one page has one.
class Page {
    constructor(slide) {
        this.slide = slide;
        this.info = slide.info;
        this.canvas = part('view');
        this.ground = new Ground(slide);
        this.stillMotion = matchMedia('(prefers-reduced-motion: reduce)');
        this.camera = new Camera(slide, this.ground, !this.stillMotion.matches);
        this.stillMotion.addEventListener('change', () => this.camera.smooth = !this.stillMotion.matches);
        this.overlay = null;
        this.pin = null;       // {x, y}: the point that a tap has marked
        this.hover = null;     // {x, y}: the point under the mouse
        this.playing = false;
        this.touched = false;  // whether somebody has chosen a time
        this.rate = this.seconds(this.info.last) > kSlow ? 2 : 1;
        this.scale = 1;
        this.motionScale = 1;
        this.frozen = 0;       // a scale that tests hold
        this.frames = 0;       // drawn so far
        this.pointers = new Map();
    }

    seconds(tick) {
        return tick * this.info.tick_s;
    }

    // ---- drawing ----

    size(scale) {
        const ratio = Math.min(devicePixelRatio, 2) * scale;
        return [this.canvas.clientWidth, this.canvas.clientHeight].map(edge => Math.max(1, Math.round(edge * ratio)));
    }

    view() {
        return this.camera.viewOf(...this.size(this.scale));
    }

    paint() {
        const [width, height] = this.size(this.scale);
        if (this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
        }
        ++this.frames;
        this.picture.draw({view: this.view(), overlay: this.overlay, cursor: this.pin, scale: this.scale});
    }

    // Asks for a picture.
    draw() {
        if (this.asked || !this.picture) return;
        this.asked = true;
        requestAnimationFrame(now => this.frame(now));
    }

    frame(now) {
        this.asked = false;
        if (!this.picture) return;
        clearTimeout(this.settling);
        const elapsed = this.moving ? now - this.last : 0;
        this.last = now;
        if (this.playing) this.advance(Math.min(250, elapsed));
        const glides = this.camera.glide((elapsed || 16) / 1000);
        const moved = this.playing || glides || this.held;
        if (moved && this.moving) this.adapt(elapsed);
        this.moving = moved;
        this.scale = this.frozen || (moved ? this.motionScale : 1);
        if (moved || this.scale === 1 || this.frozen) this.paint();
        if (this.playing || glides) this.draw();
        else if (moved) this.settling = setTimeout(() => this.settle(), kSettle);
        else this.settling = setTimeout(() => this.smooth(), kSmooth);
    }

    // Full resolution, once nothing moves.
    settle() {
        this.held = this.pointers.size > 0;
        if (this.held) return;
        this.moving = false;
        this.draw();
    }

    // Chooses the resolution in motion by the time between pictures, ms.
    adapt(elapsed) {
        if (this.frozen) return;
        this.busy = this.busy ? 0.75 * this.busy + 0.25 * elapsed : elapsed;
        const step = kScales.indexOf(this.motionScale);
        const next = this.busy > kFluent ? step - (this.busy > 3 * kFluent ? 2 : 1) : this.busy < kFluent / 2 ? step + 1 : step;
        const scale = kScales[clamp(next, 0, kScales.length - 1)];
        if (scale === this.motionScale) return;
        this.motionScale = scale;
        this.busy = (kFluent + kFluent / 2) / 2;  // counts anew
    }

    // Draws, and returns how many milliseconds later the picture is there.
    async time() {
        const gl = this.canvas.getContext('webgl2'), began = performance.now();
        this.paint();
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        while (fence && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await breathe();
        gl.deleteSync(fence);
        return performance.now() - began;
    }

    // Draws a picture that stays with more samples, if that is quick.
    async smooth() {
        if (this.frozen || document.hidden) return;
        if (!this.warm) {
            this.warm = true;
            this.setCost(await this.time());  // the first picture took longer
        }
        const samples = scale => this.size(scale).reduce((a, b) => a * b);
        const scale = kSmoothScales.find(each => samples(each) < kMostSamples && this.cost * each * each < kSmoothed);
        if (!scale || this.asked || this.moving || !this.picture) return;
        this.scale = scale;
        this.paint();
    }

    // Milliseconds of a picture of full resolution.
    setCost(cost) {
        this.cost = cost;
        this.motionScale = Math.max(kScales[0], ...kScales.filter(scale => scale * scale * cost <= kFluent));
    }

    // ---- time ----

    advance(elapsed) {
        this.slide.seek(this.slide.tick + elapsed / 1000 / this.info.tick_s * this.rate);
        if (this.slide.tick >= this.info.last) this.play(false);
        this.showTime();
    }

    // To a tick, as it is stored.
    seek(tick) {
        this.slide.seek(this.slide.tickOf(this.slide.frameNear(clamp(tick, 0, this.info.last))));
        this.touched = true;
        part('welcome').hidden = true;
        this.showTime();
        this.draw();
    }

    step(frames) {
        this.play(false);
        const {every, last} = this.info, tick = this.slide.tick;
        const frame = this.slide.frameNear(tick) + frames;
        this.seek(clamp(frame * every, 0, last));
    }

    play(on) {
        if (on === this.playing) return;
        if (on && (!this.touched || this.slide.tick >= this.info.last)) this.seek(0);
        this.playing = on;
        part('welcome').hidden = true;
        part('play').classList.toggle('on', on);
        part('play-word').textContent = on ? 'Pause' : 'Play';
        if (!on) this.seek(this.slide.tick);  // a stored state
        this.say(on ? 'Playing' : `Paused at ${number(this.seconds(this.slide.tick), 1)} seconds`);
        this.draw();
    }

    showTime() {
        const {tick} = this.slide, now = number(this.seconds(tick), 1), all = number(this.seconds(this.info.last), 1);
        const scrub = part('scrub'), share = `${(100 * tick / Math.max(1, this.info.last)).toFixed(2)}%`;
        scrub.value = this.slide.frameNear(tick);
        scrub.setAttribute('aria-valuetext', `${now} seconds of ${all}`);
        part('track').style.setProperty('--played', share);
        part('track').style.setProperty('--filled', `calc(9px + (100% - 18px) * ${tick / Math.max(1, this.info.last)})`);
        this.clockNow.textContent = `${now} s`;
        this.showReading();
    }

    // ---- colours ----

    // Colours by a quantity; 0: as it looks.
    choose(index) {
        const overlay = index > 0 ? this.info.overlays[index - 1] : null;
        if (overlay === undefined) return;
        this.overlay = overlay;
        part('overlay').value = index;
        part('legend').hidden = !overlay;
        if (overlay) this.showLegend(overlay);
        this.say(overlay ? `Colours: ${overlay.name}, ${overlay.unit}` : 'Colours: as it looks');
        this.draw();
    }

    // As the program's own legend: a part of equal width for each stop.
    showLegend({name, unit, stepped, stops}) {
        part('quantity').textContent = unit ? `${name}, ${unit}` : name;
        const rgb = ([, r, g, b]) => `rgb(${[r, g, b].map(v => Math.round(255 * v)).join(' ')})`;
        const colours = stops.map((stop, i) => {
            const last = i + 1 === stops.length, to = stepped || last ? stop : stops[i + 1];
            return `${rgb(stop)} ${100 * i / stops.length}%, ${rgb(to)} ${100 * (i + 1) / stops.length}%`;
        });
        part('colours').style.background = `linear-gradient(to right, ${colours.join(', ')})`;
        part('legend').classList.toggle('many', stops.length > 6);
        part('values').replaceChildren();
        for (const [value] of stops) add(part('values'), 'li', String(Number(value.toPrecision(3))).replace('-', '−'));
    }

    // ---- the ground under a point ----

    // Where a place on the screen, px from the top left, is on the ground of the slide; null: nowhere.
    pick(x, y) {
        const at = this.groundAt(x, y);
        return at && this.ground.inside(at[0], at[1]) && this.slide.read(at[0], at[1]) ? {x: at[0], y: at[1]} : null;
    }

    groundAt(x, y) {
        return pickGround(this.view(), ...this.inPicture(x, y), this.ground);
    }

    // The same place from −1 to 1, right and up.
    inPicture(x, y) {
        return [2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight];
    }

    mark(point) {
        this.pin = point;
        this.showReading();
        this.draw();
    }

    rows(reading) {
        const {info} = this, rows = [
            ['Height', `${number(reading.height, 1)} m`],
            ['Standing', `${number(reading.standing, 2)} m`],
            ['Change', `${signed(reading.change, 2)} m`],
            ['Rolling', `${number(reading.rolling, 2)} m`],
            ['Speed in plan', `${number(reading.speed, 1)} m/s`],
            ['Deepest flow', `${number(reading.peakDepth, 2)} m`],
            ['Fastest flow', `${number(reading.peakSpeed, 1)} m/s`],
        ];
        if (info.two) {
            const share = reading.rolling > 0 ? reading.lowerRolling : reading.lowerStanding;
            rows.splice(4, 0, ['Mixture', `${number(100 * share)} % ${info.lower_material}`]);
        }
        return rows;
    }

    showReading() {
        const point = this.pin ?? this.hover, reading = point && this.slide.read(point.x, point.y);
        part('reading').hidden = !reading;
        if (!reading) return;
        const rows = this.rows(reading), cells = part('values-here').children;
        if (cells.length === 0)
            for (const [name] of rows) add(part('values-here'), 'dt', name), add(part('values-here'), 'dd');
        rows.forEach(([, text], i) => cells[2 * i + 1].textContent = text);
        part('where').textContent = placeOnEarth(this.info, reading.x, reading.y) ??
            `${number(reading.x)} m east, ${number(reading.y)} m north`;
    }

    readMiddle() {
        this.mark(this.pick(this.canvas.clientWidth / 2, this.canvas.clientHeight / 2));
        const reading = this.pin && this.slide.read(this.pin.x, this.pin.y);
        this.say(reading ? this.rows(reading).map(row => row.join(' ')).join(', ') : 'No ground of the slide is there');
    }

    // To a screen reader, at rests only.
    say(text) {
        part('spoken').textContent = text;
    }

    // ---- hands ----

    // Something moves the camera now; the picture settles afterwards.
    hold() {
        this.held = true;
        this.draw();
    }

    turn(azimuth, elevation) {
        this.camera.turn(azimuth, elevation);
        this.draw();
    }

    zoom(factor) {
        this.camera.zoom(factor);
        this.draw();
    }

    pan(right, away) {
        this.camera.pan(right, away);
        this.draw();
    }

    goHome() {
        this.camera.goHome();
        this.draw();
    }

    down(event) {
        if (event.pointerType === 'mouse') event.preventDefault();  // no scrolling by the middle button
        this.canvas.focus({preventScroll: true, focusVisible: false});
        this.canvas.setPointerCapture(event.pointerId);
        this.canvas.classList.add('held');
        part('welcome').hidden = true;
        if (this.pointers.size === 0) this.travelled = 0;
        this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
        this.grip();
    }

    // What fingers have taken hold of: the ground under them, or between two of them.
    grip() {
        this.camera.stop();
        const [x, y] = this.middle();
        this.pivot = this.groundAt(x, y);
    }

    middle() {
        const all = [...this.pointers.values()];
        return [0, 1].map(axis => all.reduce((sum, at) => sum + at[axis], 0) / all.length);
    }

    move(event) {
        const old = this.pointers.get(event.pointerId), now = [event.offsetX, event.offsetY];
        if (!old) {
            if (event.pointerType === 'mouse' && !this.pin) this.hoverAt(...now);
            return;
        }
        this.travelled += Math.hypot(now[0] - old[0], now[1] - old[1]);
        if (this.travelled <= kTap) return;  // `old` stays: nothing is lost
        const from = this.middle();
        if (this.pointers.size === 2) this.twist(old, now, [...this.pointers].find(([id]) => id !== event.pointerId)[1]);
        this.pointers.set(event.pointerId, now);
        const to = this.middle();
        if (this.pointers.size === 2 || event.shiftKey || (event.buttons & 6) !== 0) this.drag(from, to);
        else if (this.pointers.size === 1) this.spin(to[0] - from[0], to[1] - from[1]);
        this.hold();
    }

    // One of two fingers moves: nearer or farther, and round the ground between them.
    twist(old, now, other) {
        const before = [old[0] - other[0], old[1] - other[1]], after = [now[0] - other[0], now[1] - other[1]];
        const pivot = this.pivot ?? this.camera.target;
        const angle = Math.atan2(before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]);
        this.camera.zoom(Math.hypot(...before) / Math.max(1, Math.hypot(...after)), pivot, true);
        this.camera.turn(angle / kDegree, 0, pivot, true);
    }

    // 180° for the width of the picture.
    spin(x, y) {
        const degrees = 180 / this.canvas.clientWidth;
        this.camera.turn(x * degrees, y * degrees, this.pivot ?? this.camera.target, true);
    }

    drag(from, to) {
        const view = this.view(), shares = 2 * Math.hypot(...view.up) / this.canvas.clientHeight;
        if (this.pivot) this.camera.drag(this.pivot, ...this.inPicture(...to), view);
        else this.camera.pan((from[0] - to[0]) * shares, (to[1] - from[1]) * shares, true);
    }

    hoverAt(x, y) {
        this.hover = this.pick(x, y);
        this.showReading();
    }

    up(event) {
        if (!this.pointers.delete(event.pointerId)) return;
        if (this.pointers.size > 0) return this.grip();
        this.canvas.classList.remove('held');
        if (event.type === 'pointerup' && this.travelled <= kTap && event.button === 0)
            this.mark(this.pin && event.pointerType === 'mouse' ? null : this.pick(event.offsetX, event.offsetY));
        if (this.held) this.settling = setTimeout(() => this.settle(), kSettle);
    }

    wheel(event) {
        event.preventDefault();
        const pixels = event.deltaY * [1, 18, 300][event.deltaMode] * (event.ctrlKey ? 6 : 1);
        const pivot = this.groundAt(event.offsetX, event.offsetY) ?? this.camera.goal.target;
        this.camera.zoom(Math.exp(clamp(pixels, -400, 400) * 0.0014), pivot);
        this.draw();
    }

    // Returns whether the key means something here.
    key(event) {
        const {key, shiftKey, target} = event, isButton = /^(BUTTON|SUMMARY)$/.test(target.tagName);
        const second = Math.max(1, Math.round(1 / (this.info.every * this.info.tick_s)));
        const arrow = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[key];
        if (arrow) {
            if (target === part('scrub') || target.closest('#numbers')) return false;  // has arrows of its own
            if (shiftKey) this.pan(0.05 * arrow[0], 0.05 * arrow[1]);
            else this.turn(4 * arrow[0], 3 * arrow[1]);
            return true;
        }
        if (/^[0-9]$/.test(key)) return this.choose(Number(key)), true;
        if (key === ',' || (shiftKey && event.code === 'Comma')) return this.step(shiftKey ? -second : -1), true;
        if (key === '.' || (shiftKey && event.code === 'Period')) return this.step(shiftKey ? second : 1), true;
        switch (key) {
            case ' ':
                if (isButton) return false;
                this.play(!this.playing);
                return true;
            case 'Home':
                this.step(-this.info.frames);
                return true;
            case 'End':
                this.step(this.info.frames);
                return true;
            case '+':
            case '=':
                this.zoom(0.85);
                return true;
            case '-':
            case '−':
                this.zoom(1 / 0.85);
                return true;
            case 'v':
            case 'V':
                this.goHome();
                return true;
            case 'r':
            case 'R':
                this.readMiddle();
                return true;
            case '?':
                part('keys').showModal();
                return true;
            case 'Escape':
                this.mark(null);
                return true;
        }
        return false;
    }

    listen() {
        const {canvas} = this, on = (id, type, action) => part(id).addEventListener(type, action);
        canvas.addEventListener('pointerdown', event => this.down(event));
        canvas.addEventListener('pointermove', event => this.move(event));
        for (const type of ['pointerup', 'pointercancel']) canvas.addEventListener(type, event => this.up(event));
        canvas.addEventListener('pointerleave', () => {
            this.hover = null;
            this.showReading();
        });
        canvas.addEventListener('wheel', event => this.wheel(event), {passive: false});
        canvas.addEventListener('contextmenu', event => event.preventDefault());
        on('start', 'click', () => {
            this.play(true);
            part('play').focus({focusVisible: false});
        });
        on('play', 'click', () => this.play(!this.playing));
        on('scrub', 'input', event => {
            const frame = Number(event.target.value);
            this.play(false);
            this.seek(this.slide.tickOf(frame));
        });
        on('rate', 'change', event => this.rate = Number(event.target.value));
        on('overlay', 'change', event => this.choose(Number(event.target.value)));
        on('home', 'click', () => this.goHome());
        on('help', 'click', () => part('keys').showModal());
        addEventListener('keydown', event => {
            const ours = !event.ctrlKey && !event.metaKey && !event.altKey && event.target.tagName !== 'SELECT' &&
                !part('keys').open && this.key(event);
            if (ours) event.preventDefault();
        });
        addEventListener('hashchange', () => this.seekAddress());
        new ResizeObserver(() => this.draw()).observe(canvas);
        const bar = document.querySelector('footer');
        new ResizeObserver(() => document.body.style.setProperty('--bar', `${bar.offsetHeight}px`)).observe(bar);
        canvas.addEventListener('webglcontextlost', event => {
            event.preventDefault();
            this.play(false);
            this.picture = null;
            fail('The browser has taken the graphics memory back. If the picture does not return, load the page again.');
        });
        canvas.addEventListener('webglcontextrestored', () => this.begin().catch(error => fail(error.message)));
    }

    // ---- words ----

    describe() {
        const {info} = this, {measures: m, grid} = info, length = this.seconds(info.last);
        const material = info.two ? `${info.material} on ${info.lower_material}` : info.material;
        part('title').textContent = info.title;
        part('about').textContent = m.run_out_m > 0 ?
            `${material}, ${number(length)} s, run-out ${number(m.run_out_m)} m, up to ${number(m.peak_speed_slope_m_s, 1)} m/s` :
            `${material}, ${number(length)} s`;

        this.table([
            ['Run-out', `${number(m.run_out_m)} m`],
            ['Fall', `${number(m.fall_m)} m`],
            ['Angle of reach', `${number(m.reach_deg, 1)}°`],
            ['Area', `${number(m.extent_ha, 2)} ha`],
            ['Deepest flow', `${number(m.peak_depth_m, 1)} m`],
            ['Fastest, along the slope', `${number(m.peak_speed_slope_m_s, 1)} m/s`],
            ['Fastest, in plan', `${number(m.peak_speed_plan_m_s, 1)} m/s`],
            m.peak_pressure_kpa !== undefined && ['Greatest impact pressure', `${number(m.peak_pressure_kpa, 1)} kPa`],
            ['Eroded', `${number(m.eroded_m3)} m³`],
            ['Deposited', `${number(m.deposited_m3)} m³`],
            ['Mass error', info.mass.error_quanta === 0 ? 'none' : `${number(info.mass.error_quanta)} quanta`],
            ['Material', material],
            ['Ground', info.terrain],
            info.licence && ['Licence of the ground', info.licence],
            ['Grid', `${number(grid.nx - 1)} × ${number(grid.ny - 1)} squares of ${Number(grid.dx.toPrecision(4))} m`],
            info.georeference && ['South-west corner', info.georeference.south_west],
            ['Made with', info.program],
        ].filter(Boolean));

        const numbers = part('numbers'), centimetres = metres => Number((100 * metres).toPrecision(2));
        if (info.command) {
            add(numbers, 'h2', 'The same again, and checked');
            const repeat = add(numbers, 'div');
            repeat.className = 'repeat';
            const command = add(repeat, 'code', info.command), copy = add(repeat, 'button', 'Copy');
            copy.type = 'button';
            copy.addEventListener('click', () => this.copy(command, copy));
        }
        add(numbers, 'h2', 'State hash of the end');
        add(numbers, 'code', info.hash);
        add(numbers, 'p', 'As the program computed it. This page carries it along and cannot compute it.');
        add(numbers, 'h2', 'What this page keeps');
        add(numbers, 'p', `A state every ${Number((info.every * info.tick_s).toPrecision(2))} s: standing depth within ` +
            `${centimetres(info.error.depth)} cm, rolling depth within ${centimetres(info.error.moving)} cm, speed within ` +
            `${Number(info.error.speed.toPrecision(2))} m/s, ground within ${centimetres(info.error.ground)} cm. While it ` +
            'plays, it blends between states; what it reads out is of a stored state and of the nearest vertex.');
        if (info.surroundings) add(numbers, 'p', 'The ground beyond the slide is invented. Nothing was simulated there.');
    }

    table(rows) {
        const table = add(part('numbers'), 'table');
        for (const [name, value] of rows) {
            const row = table.insertRow();
            add(row, 'th', name).scope = 'row';
            add(row, 'td', value);
        }
    }

    async copy(source, button) {
        try {
            await navigator.clipboard.writeText(source.textContent);
        } catch {
            getSelection().selectAllChildren(source);
            document.execCommand('copy');  // where the newer way is not allowed
        }
        button.textContent = 'Copied';
        this.say('Copied');
        setTimeout(() => button.textContent = 'Copy', 2000);
    }

    fillControls() {
        const {info} = this, names = {0.25: '¼ ×', 0.5: '½ ×'};
        for (const rate of kRates) add(part('rate'), 'option', names[rate] ?? `${rate} ×`).value = rate;
        part('rate').value = this.rate;
        add(part('overlay'), 'option', 'As it looks').value = 0;
        info.overlays.forEach(({name}, i) => add(part('overlay'), 'option', name).value = i + 1);
        part('scrub').max = info.frames - 1;
        this.clockNow = add(part('clock'), 'span');
        add(part('clock'), 'small', ` of ${number(this.seconds(info.last), 1)} s`);
        this.drawCurve();
    }

    // The moving volume over time, under the scrub bar.
    drawCurve() {
        const {volume, last} = this.info, most = Math.max(...volume, 1e-9);
        const stride = Math.ceil(volume.length / 600);
        let path = 'M0 100';
        for (let i = 0; i < volume.length; i += stride) {
            const height = Math.max(...volume.slice(i, i + stride));
            path += `L${(1000 * this.slide.tickOf(i) / Math.max(1, last)).toFixed(1)} ${(100 - 96 * height / most).toFixed(1)}`;
        }
        for (const curve of document.querySelectorAll('.curve path')) curve.setAttribute('d', `${path}L1000 100Z`);
    }

    // ---- the beginning ----

    // The time that the address asks for. Returns whether there is one.
    seekAddress() {
        const asked = /[#&]t=(\d+(?:\.\d+)?)/.exec(location.hash);
        if (!asked) return false;
        this.play(false);
        this.seek(Number(asked[1]) / this.info.tick_s);
        return true;
    }

    // A moment at which much moves, until somebody plays or chooses.
    seekOpening() {
        const {volume} = this.info, most = volume.reduce((best, v, i) => v > volume[best] ? i : best, 0);
        this.seek(this.slide.tickOf(Math.round(0.8 * most)));
        this.touched = false;
        part('welcome').hidden = false;
    }

    // Makes the picture, at first and after the browser has lost it.
    async begin() {
        this.picture = await Picture.create(this.canvas, this.slide);
        this.scale = this.frozen || 1;
        this.warm = false;
        this.setCost(await this.time());
        part('note').hidden = true;
        document.documentElement.dataset.state = 'ready';
        this.settling = setTimeout(() => this.smooth(), kSmooth);
    }
}

// Lets the browser show what is there before longer work begins.
const breathe = () => new Promise(resolve => setTimeout(resolve));

document.documentElement.dataset.began = '';
try {
    if (!globalThis.DecompressionStream)
        throw new Error('This browser is too old for this page. ' +
                        'Use Chrome or Edge 88, Firefox 113, Safari 16.4, or a newer one.');
    await breathe();
    const began = performance.now(), slide = await unpackSlide(), unpacked = performance.now();
    const page = new Page(slide);
    page.fillControls();
    page.describe();
    if (!page.seekAddress()) page.seekOpening();
    page.listen();
    await breathe();
    await page.begin();

    // For tests, and for the curious.
    window.couloir = {
        info: slide.info, camera: page.camera,
        seek: tick => page.seek(tick), read: (x, y) => slide.read(x, y), pick: (x, y) => page.pick(x, y),
        choose: index => page.choose(index), play: on => page.play(on),
        freeze(scale) {
            page.frozen = scale;
            page.scale = scale || 1;
            page.draw();
        },
        // Draws and reads in one go: a canvas that is read later is empty.
        pixels() {
            page.paint();
            return page.picture.pixels();
        },
        get tick() { return slide.tick; },
        get playing() { return page.playing; },
        get frames() { return page.frames; },
        get scale() { return page.scale; },
        renderer: page.picture.renderer,
        ms: {unpack: unpacked - began, picture: page.cost, all: performance.now() - began},
    };
} catch (error) {
    fail(error.message);
}
