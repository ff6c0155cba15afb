// The page: its time, its colours, and when it draws, which is only if something changed.

const kSettle = 150, kSmooth = 400;  // ms without a change before full resolution; before more
const kLongest = 1000;               // ms that playing moves on in one picture
const kRates = [[0.25, '¼ ×'], [0.5, '½ ×'], [1, '1 ×'], [2, '2 ×'], [4, '4 ×'], [8, '8 ×']];
const kMark = [1, 0.55, 0.05];       // linear light: the ring around a marked point
const kOutOfStep = 0.3;              // s by which two pages that play may differ
const kLong = 60;                    // s from which a slide begins at twice its speed

class Page {
    constructor(slide) {
        this.slide = slide;
        this.info = slide.info;
        this.canvas = part('view');
        this.picture = null;
        this.ground = new Ground(slide);
        const calm = matchMedia('(prefers-reduced-motion: reduce)');
        this.camera = new Camera(slide, this.ground, !calm.matches);
        calm.addEventListener('change', () => this.camera.smooth = !calm.matches);
        this.resolution = new Resolution();
        this.scale = 1;
        this.frames = 0;       // drawn so far
        this.overlay = null;
        this.pin = null;       // {x, y}: the point that a tap has marked
        this.hover = null;     // {x, y}: the point under the mouse
        this.playing = false;
        this.touched = false;  // whether somebody has chosen a time
        this.rate = this.seconds(this.info.last) > kLong ? 2 : 1;
        this.live = this.info.live && runsModules() ? new Live(this) : null;
        this.lesson = this.info.lesson ? new Lesson(this) : null;
        this.hands = new Hands(this);
    }

    seconds(tick) {
        return tick * this.info.tick_s;
    }

    // Whether nothing was done yet: a world to play in, not a slide to watch.
    get isWorld() {
        return this.info.last === 0;
    }

    get framesPerSecond() {
        return Math.max(1, Math.round(1 / this.seconds(this.info.every)));
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
        const view = this.view();
        this.picture.draw({view, overlay: this.overlay, cursor: this.ring(), scale: this.scale});
        this.lesson?.showPins(view);
    }

    // The ring that is drawn: of the brush, or around the marked point.
    ring() {
        const {live, hover, pin, info} = this;
        if (live?.on && hover && live.deed) return {...hover, radius: live.reach, colour: live.deed.ring};
        return pin && {...pin, radius: 1.5 * info.grid.dx, colour: kMark};
    }

    // Asks for a picture.
    draw() {
        if (this.asked || !this.picture) return;
        this.asked = true;
        requestAnimationFrame(now => this.frame(now));
    }

    // Asks for a picture of a moment between others, which need not be sharp.
    stir() {
        this.stirred = true;
        this.draw();
    }

    frame(now) {
        this.asked = false;
        if (!this.picture) return;
        clearTimeout(this.resting);
        const elapsed = this.moving ? now - this.last : 0;
        this.last = now;
        if (this.playing) this.advance(Math.min(kLongest, elapsed));
        const glides = this.camera.glide((elapsed || 16) / 1000);
        const moves = this.playing || glides || this.stirred;
        if (moves || !this.moving) {
            if (moves && elapsed > 0) this.resolution.adapt(elapsed);
            this.scale = this.resolution.held || (moves ? this.resolution.inMotion : 1);
            this.paint();
        }
        this.stirred = false;
        if (this.playing || glides) this.draw();
        else if (moves || this.moving) this.resting = setTimeout(() => this.settle(), kSettle);
        else this.resting = setTimeout(() => this.smooth(), kSmooth);
        this.moving = moves;
    }

    // Full resolution, once nothing moves.
    settle() {
        if (this.hands.busy) return;  // their end stirs
        this.moving = false;
        this.draw();
    }

    // Draws a picture that stays with more samples, if that is quick.
    async smooth() {
        if (this.resolution.held || document.hidden) return;
        if (!this.warm) {
            this.warm = true;
            this.resolution.know(await this.time());  // the first picture took longer
        }
        const scale = this.resolution.atRest(this.size(1).reduce((a, b) => a * b));
        if (scale === 1 || this.asked || this.moving || !this.picture) return;
        this.scale = scale;
        this.paint();
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

    // ---- time ----

    advance(elapsed) {
        const end = Math.min(this.info.last, this.lesson?.haltAfter(this.slide.tick) ?? Infinity);
        this.slide.seek(Math.min(this.slide.tick + elapsed / 1000 / this.info.tick_s * this.rate, end));
        if (this.slide.tick >= end) this.play(false);
        this.showTime();
    }

    // To the stored state nearest to a tick.
    seek(tick) {
        if (this.live?.on) return this.live.seek(tick);
        this.slide.seek(this.slide.tickOf(this.slide.frameNear(clamp(tick, 0, this.info.last))));
        this.touched = true;
        part('welcome').hidden = true;
        this.showTime();
        this.draw();
    }

    // By stored states.
    step(frames) {
        this.play(false);
        if (this.live?.on) return this.live.seek(clamp(this.slide.tick + frames * this.info.every, 0, this.live.status.known));
        this.seek((this.slide.frameNear(this.slide.tick) + frames) * this.info.every);
        this.stir();
    }

    play(on) {
        if (this.live?.on) return this.live.pause(!on);
        if (on === this.playing) return;
        if (on && this.lesson?.isOpen) this.lesson.leave();
        else if (on && (!this.touched || this.slide.tick >= this.info.last)) this.seek(0);
        this.playing = on;
        part('welcome').hidden = true;
        part('play').classList.toggle('on', on);
        part('play-word').textContent = on ? 'Pause' : 'Play';
        if (!on) this.seek(this.slide.tick);
        say(on ? 'Playing' : `Paused at ${number(this.seconds(this.slide.tick), 1)} seconds`);
        this.draw();
    }

    get end() {
        return this.live?.on ? this.live.status.known : this.info.last;
    }

    showTime() {
        const {end: last, slide: {tick}} = this, scrub = part('scrub');
        const share = tick / Math.max(1, last), now = number(this.seconds(tick), 1);
        if (this.live?.on) scrub.max = last, scrub.value = tick, this.whole.textContent = ` of ${number(this.seconds(last), 1)} s`;
        else scrub.value = this.slide.frameNear(tick);
        scrub.setAttribute('aria-valuetext', `${now} seconds of ${number(this.seconds(last), 1)}`);
        part('track').style.setProperty('--played', share);
        this.clock.textContent = `${now} s`;
        if (this.live?.on && this.lesson?.isOpen) this.lesson.close();
        else if (!this.live?.on) this.lesson?.see(tick, this.playing);
        this.showPoint();
    }

    turnPlay() {
        this.play(this.live?.on ? this.live.paused : !this.playing);
    }

    // ---- colours and points ----

    // Colours by a quantity; 0: as it looks.
    choose(index) {
        const overlay = index > 0 ? this.info.overlays[index - 1] : null;
        if (overlay === undefined) return;
        this.overlay = overlay;
        part('overlay').value = index;
        showLegend(overlay);
        say(overlay ? `Colours: ${overlay.name}, ${overlay.unit}` : 'Colours: as it looks');
        this.draw();
    }

    // The ground under a place on the screen, px from the top left; null: sky.
    groundAt(x, y) {
        return pickGround(this.view(), ...this.inPicture(x, y), this.ground);
    }

    // The same place from −1 to 1, right and up.
    inPicture(x, y) {
        return [2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight];
    }

    // The ground of the slide there; null: none.
    pick(x, y) {
        const at = this.groundAt(x, y);
        return at && this.slide.read(at[0], at[1]) && this.ground.inside(at[0], at[1]) ? {x: at[0], y: at[1]} : null;
    }

    // The mouse is at a place; null: it left.
    pointAt(place) {
        this.hover = place && (!this.pin || this.live?.on) ? this.pick(...place) : null;
        if (this.live?.on) this.stir();
        this.showPoint();
    }

    // A mouse takes a mark away with its next click; a finger moves it.
    markAt(place, isMouse) {
        if (this.lesson?.asksGuess) return this.lesson.guessAt(this.pick(...place));
        this.mark(this.pin && isMouse ? null : this.pick(...place));
    }

    mark(point) {
        this.pin = point;
        this.showPoint();
        this.draw();
    }

    showPoint() {
        const point = this.pin ?? this.hover;
        showReading(this.info, point && this.slide.read(point.x, point.y));
    }

    // By keys alone.
    guessMiddle() {
        if (!this.lesson?.asksGuess) return;
        this.lesson.guessAt(this.pick(this.canvas.clientWidth / 2, this.canvas.clientHeight / 2));
        say(part('lesson-guess').textContent);
    }

    readMiddle() {
        this.mark(this.pick(this.canvas.clientWidth / 2, this.canvas.clientHeight / 2));
        const reading = this.pin && this.slide.read(this.pin.x, this.pin.y);
        say(reading ? rowsOf(this.info, reading).map(row => row.join(' ')).join(', ') : 'No ground of the slide is there');
    }

    // ---- the beginning ----

    fillControls() {
        const {info} = this;
        for (const [rate, name] of kRates) add(part('rate'), 'option', name).value = rate;
        part('rate').value = this.rate;
        add(part('overlay'), 'option', 'As it looks').value = 0;
        info.overlays.forEach(({name}, i) => add(part('overlay'), 'option', name).value = i + 1);
        part('scrub').max = info.frames - 1;
        this.clock = add(part('clock'), 'span');
        this.whole = add(part('clock'), 'small', ` of ${number(this.seconds(info.last), 1)} s`);
        this.drawCurve();
    }

    // The moving volume over time, under the scrub bar.
    drawCurve() {
        const {volume, last} = this.info, most = Math.max(...volume, 1e-9), together = Math.ceil(volume.length / 600);
        let path = 'M0 100';
        for (let i = 0; i < volume.length; i += together) {
            const x = 1000 * this.slide.tickOf(i) / Math.max(1, last);
            const height = Math.max(...volume.slice(i, i + together));
            path += `L${x.toFixed(1)} ${(100 - 96 * height / most).toFixed(1)}`;
        }
        for (const curve of document.querySelectorAll('.curve path')) curve.setAttribute('d', `${path}L1000 100Z`);
    }

    listen() {
        const {canvas} = this, on = (id, type, action) => part(id).addEventListener(type, action);
        on('start', 'click', () => {
            if (this.isWorld && this.live) return this.live.takeOver();
            this.play(true);
            part('play').focus({focusVisible: false});
        });
        on('play', 'click', () => this.turnPlay());
        on('scrub', 'input', ({target}) => {
            const tick = this.live?.on ? Number(target.value) : this.slide.tickOf(Number(target.value));
            this.play(false);
            this.seek(tick);
            this.stir();
        });
        on('rate', 'change', ({target}) => this.rate = Number(target.value));
        on('overlay', 'change', ({target}) => this.choose(Number(target.value)));
        on('home', 'click', () => {
            this.camera.goHome();
            this.draw();
        });
        on('help', 'click', () => part('keys').showModal());
        addEventListener('hashchange', () => this.seekAddress());
        if (this.live) this.live.listen();
        for (const element of [part('take-over'), ...document.querySelectorAll('.plays')]) element.hidden = !this.live;
        document.documentElement.classList.toggle('world', this.isWorld);
        if (this.isWorld && this.live) part('start').setAttribute('aria-label', 'Play in this world');
        if (this.isWorld && this.live)
            for (const words of document.querySelectorAll('#welcome p')) words.textContent = `Press to play. ${words.textContent}`;
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

    // The time that the address asks for: "#t=34". Returns whether it asks for one.
    seekAddress() {
        const asked = /[#&]t=(\d+(?:\.\d+)?)/.exec(location.hash);
        if (!asked) return false;
        this.play(false);
        this.seek(Number(asked[1]) / this.info.tick_s);
        return true;
    }

    // A moment at which much moves, until somebody plays or chooses; a lesson begins at its beginning.
    seekOpening() {
        if (this.lesson) {
            part('welcome').hidden = false;
            this.slide.seek(0);
            return this.showTime();
        }
        const {volume} = this.info, most = volume.reduce((best, v, i) => v > volume[best] ? i : best, 0);
        this.seek(this.slide.tickOf(Math.round(0.8 * most)));
        this.touched = false;
        part('welcome').hidden = false;
    }

    // Makes the picture, at first and after the browser has lost it.
    async begin() {
        this.picture = await Picture.create(this.canvas, this.slide);
        this.scale = this.resolution.held || 1;
        this.warm = false;
        this.resolution.know(await this.time());
        part('note').hidden = true;
        document.documentElement.dataset.state = 'ready';
        this.resting = setTimeout(() => this.smooth(), kSmooth);
    }

    // ---- beside another page ----

    // What a page beside this one shows too.
    get shown() {
        const {slide: {tick}, playing, rate, overlay, camera} = this;
        return {tick, playing, rate, overlay: overlay?.name ?? null, camera: camera.pose};
    }

    // Shows what that page shows, as far as it has changed. A slide that is shorter waits at its end.
    follow({tick, playing, rate, overlay, camera}) {
        const before = this.followed ?? {}, {last, tick_s: tickSeconds, overlays} = this.info;
        this.followed = {tick, playing, rate, overlay, camera};
        if (rate !== before.rate) part('rate').value = this.rate = rate;
        if (overlay !== before.overlay) this.choose(overlay === null ? 0 : overlays.findIndex(each => each.name === overlay) + 1);
        const plays = playing && tick < last, late = Math.abs(Math.min(tick, last) - this.slide.tick);
        if (this.playing && !plays) this.play(false);
        if (plays ? late * tickSeconds > kOutOfStep : tick !== before.tick && late > 0) this.seek(tick);
        if (plays && !this.playing) this.touched = true, this.play(true);
        if (camera && JSON.stringify(camera) !== JSON.stringify(before.camera)) this.camera.send(camera, true), this.stir();
    }

    // For tests, and for the curious.
    hook(ms) {
        const page = this, {slide} = this;
        return {
            info: this.info, camera: this.camera, renderer: this.picture.renderer, ms,
            seek: tick => page.seek(tick), read: (x, y) => slide.read(x, y), pick: (x, y) => page.pick(x, y),
            choose: index => page.choose(index), play: on => page.play(on),
            get shown() { return page.shown; }, follow: shown => page.follow(shown),
            freeze(scale) {
                page.resolution.held = scale;
                page.scale = scale || 1;
                page.draw();
            },
            // Draws and reads in one go: a canvas that is read later is empty.
            pixels() {
                page.paint();
                const {width: w, height: h, bytes: p} = page.picture.pixels();
                return {w, h, p};
            },
            get tick() { return slide.tick; },
            get playing() { return page.playing; },
            live: this.live,
            get frames() { return page.frames; },
            get scale() { return page.scale; },
        };
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
    describe(slide.info);
    if (!page.seekAddress()) page.seekOpening();
    page.listen();
    await breathe();
    await page.begin();
    window.couloir = page.hook({unpack: unpacked - began, picture: page.resolution.cost, all: performance.now() - began});
} catch (error) {
    fail(error.message);
}
