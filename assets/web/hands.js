// Hands on the picture: mouse, fingers, wheel and keys.

const kTap = 6;          // px that a tap may move
const kNearer = 0.85;    // factor of the distance, per key
const kTurned = 4, kRaised = 3, kPanned = 0.05;  // degrees and share of the distance, per key

class Hands {
    // `page` is what they move.
    constructor(page) {
        this.page = page;
        this.canvas = page.canvas;
        this.camera = page.camera;
        this.pointers = new Map();  // places by number, px
        this.travelled = 0;         // px since the first touched the picture
        this.pivot = null;          // the ground that they hold
        this.tool = null;           // the pointer that acts on the world; none: they turn the view
        const on = (type, action, options) => this.canvas.addEventListener(type, action, options);
        on('pointerdown', event => this.down(event));
        on('pointermove', event => this.move(event));
        on('pointerup', event => this.up(event));
        on('pointercancel', event => this.up(event));
        on('pointerleave', () => page.pointAt(null));
        on('wheel', event => this.wheel(event), {passive: false});
        on('contextmenu', event => event.preventDefault());
        addEventListener('keydown', event => {
            if (event.target.tagName === 'SELECT' || part('keys').open || part('card').open) return;  // have keys of their own
            const live = page.live?.on && !event.altKey && !(event.key === 'Enter' && event.target.tagName === 'BUTTON');
            if (live && page.live.key(event)) return event.preventDefault();
            if (event.ctrlKey || event.metaKey || event.altKey) return;
            if (this.key(event)) event.preventDefault();
        });
    }

    get busy() {
        return this.pointers.size > 0;
    }

    // ---- mouse and fingers ----

    down(event) {
        if (event.pointerType === 'mouse') event.preventDefault();  // the middle button would scroll
        this.canvas.focus({preventScroll: true, focusVisible: false});
        this.canvas.setPointerCapture(event.pointerId);
        this.canvas.classList.add('held');
        part('welcome').hidden = true;
        if (!this.busy) this.travelled = 0;
        const place = [event.offsetX, event.offsetY];
        if (this.acts(event, place)) return;
        this.pointers.set(event.pointerId, place);
        if (this.tool !== null) this.letGo();  // a second finger: both turn the view
        this.grip();
    }

    // ---- the hand on the world, once a person has taken over ----

    // One button or one finger on the ground acts. Beside it, with two fingers, or with another button, the view turns.
    acts(event, place) {
        const {live} = this.page;
        if (!live?.on || this.busy || event.button !== 0 || event.altKey || part('card').open) return false;
        if (!live.press(place, event.shiftKey, event.ctrlKey || event.metaKey)) return false;
        this.pointers.set(event.pointerId, place);
        this.tool = event.pointerId;
        return true;
    }

    letGo() {
        this.tool = null;
        this.page.live.release();
    }

    // Takes hold of the ground under the finger, or between two.
    grip() {
        this.camera.stop();
        this.pivot = this.page.groundAt(...this.middle());
    }

    middle() {
        const all = [...this.pointers.values()];
        return [0, 1].map(axis => all.reduce((sum, at) => sum + at[axis], 0) / all.length);
    }

    move(event) {
        const old = this.pointers.get(event.pointerId), now = [event.offsetX, event.offsetY];
        if (!old) {
            if (event.pointerType === 'mouse') this.page.pointAt(now);
            return;
        }
        this.travelled += Math.hypot(now[0] - old[0], now[1] - old[1]);
        if (this.travelled <= kTap && this.tool === null) return;  // the next movement counts from the same place
        if (this.tool === event.pointerId) {
            this.pointers.set(event.pointerId, now);
            return this.page.live.move(now);
        }
        const from = this.middle(), two = this.pointers.size === 2;
        if (two) this.twist(old, now, [...this.pointers].find(([id]) => id !== event.pointerId)[1]);
        this.pointers.set(event.pointerId, now);
        const to = this.middle();
        if (two || event.shiftKey || (event.buttons & 6) !== 0) this.drag(from, to);
        else if (this.pointers.size === 1) this.turn(to[0] - from[0], to[1] - from[1]);
        this.page.stir();
    }

    // One of two fingers moves: nearer or farther, and round the ground between them.
    twist(old, now, other) {
        const before = [old[0] - other[0], old[1] - other[1]], after = [now[0] - other[0], now[1] - other[1]];
        const pivot = this.pivot ?? this.camera.target;
        const angle = Math.atan2(before[0] * after[1] - before[1] * after[0],
                                 before[0] * after[0] + before[1] * after[1]);
        this.camera.zoom(Math.hypot(...before) / Math.max(1, Math.hypot(...after)), pivot, true);
        this.camera.turn(angle / kDegree, 0, pivot, true);
    }

    // By 180° for the width of the picture.
    turn(x, y) {
        const degrees = 180 / this.canvas.clientWidth;
        this.camera.turn(x * degrees, y * degrees, this.pivot ?? this.camera.target, true);
    }

    drag(from, to) {
        const view = this.page.view(), shares = 2 * Math.hypot(...view.up) / this.canvas.clientHeight;
        if (this.pivot) this.camera.drag(this.pivot, ...this.page.inPicture(...to), view);
        else this.camera.pan((from[0] - to[0]) * shares, (to[1] - from[1]) * shares, true);
    }

    up(event) {
        if (!this.pointers.delete(event.pointerId)) return;
        if (this.tool === event.pointerId) {
            this.canvas.classList.remove('held');
            return this.letGo();
        }
        if (this.busy) return this.grip();
        this.canvas.classList.remove('held');
        const tapped = event.type === 'pointerup' && this.travelled <= kTap && event.button === 0;
        if (tapped && !this.page.live?.on) this.page.markAt([event.offsetX, event.offsetY], event.pointerType === 'mouse');
        else this.page.stir();
    }

    wheel(event) {
        event.preventDefault();
        const unit = [1, 18, 300][event.deltaMode];  // pixels, lines, pages
        const pixels = event.deltaY * unit * (event.ctrlKey ? 6 : 1);  // a pinch on a touchpad comes with Ctrl
        const pivot = this.page.groundAt(event.offsetX, event.offsetY) ?? this.camera.goal.target;
        this.camera.zoom(Math.exp(clamp(pixels, -400, 400) * 0.0014), pivot);
        this.page.draw();
    }

    // ---- keys ----

    // Returns whether the key means something here.
    key(event) {
        const {key, shiftKey, target} = event, {page, camera} = this;
        const arrow = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[key];
        const states = {',': -1, '.': 1}[key] ?? (shiftKey ? {Comma: -1, Period: 1}[event.code] : undefined);
        if (arrow && (target === part('scrub') || target.closest('#numbers'))) return false;  // have arrows of their own
        if (key === ' ' && /^(BUTTON|SUMMARY)$/.test(target.tagName)) return false;
        if (arrow && shiftKey) camera.pan(kPanned * arrow[0], kPanned * arrow[1]);
        else if (arrow) camera.turn(kTurned * arrow[0], kRaised * arrow[1]);
        else if (states) page.step(shiftKey ? states * page.framesPerSecond : states);
        else if (/^[0-9]$/.test(key)) page.choose(Number(key));
        else if (key === ' ') page.turnPlay();
        else if ((key === 't' || key === 'T') && page.live) page.live.takeOver();
        else if (key === 'Home') page.step(-Infinity);
        else if (key === 'End') page.step(Infinity);
        else if (key === '+' || key === '=') camera.zoom(kNearer);
        else if (key === '-' || key === '−') camera.zoom(1 / kNearer);
        else if (key === 'v' || key === 'V') camera.goHome();
        else if (key === 'r' || key === 'R') page.readMiddle();
        else if (key === 'g' || key === 'G') page.guessMiddle();
        else if (key === '?') part('keys').showModal();
        else if (key === 'Escape') page.mark(null);
        else return false;
        page.draw();
        return true;
    }
}
