// A lesson: time halts at stops, each with a card: a text, perhaps a question, or a guess where the front will stop. All texts
// are set as text.

const kMostTilt = 26;    // degrees
const kInFront = 0.02;  // share of the distance by which ground before a place hides it

// With the blanks that number() has between thousands.
const grouped = text => text.replace(/(\d),(?=\d{3}(?!\d))/g, '$1\u202f');

class Lesson {
    constructor(page) {
        const {slide, info} = page;
        this.page = page;
        // At the stored states next to them.
        this.stops = info.lesson.stops.map(stop => ({...stop, tick: slide.tickOf(slide.frameNear(stop.tick))}));
        this.shown = null;   // index of the stop whose card is open
        this.passed = null;  // of the one that was left, and at which time still is
        this.begin();
        for (const stop of this.stops) {
            const mark = add(part('track'), 'i');
            mark.className = 'stop';
            mark.style.setProperty('--at', stop.tick / Math.max(1, info.last));
        }
        this.pins = ['Your guess', 'Stopped here'].map(words => {
            const pin = add(part('pins'), 'div');
            add(pin, 'span', words);
            pin.hidden = true;
            return pin;
        });
        part('go-on').addEventListener('click', () => this.goOn());
        part('lesson-again').addEventListener('click', () => this.startAgain());
        for (const row of document.querySelectorAll('.guesses')) row.hidden = !this.stops.some(stop => stop.guess);
    }

    // Nothing was answered or guessed.
    begin() {
        this.answers = this.stops.map(() => null);
        this.guess = null;
    }

    get isOpen() {
        return this.shown !== null;
    }

    get asksGuess() {
        return this.isOpen && this.stops[this.shown].guess;
    }

    // The tick at which time has to halt, from this one on.
    haltAfter(tick) {
        return this.stops.find((stop, i) => stop.tick > tick || (stop.tick === tick && i !== this.passed))?.tick ?? Infinity;
    }

    // Time is at a tick.
    see(tick, isPlaying) {
        const at = this.stops.findIndex(stop => stop.tick === tick);
        if (at < 0) this.passed = null;
        else if (!isPlaying && at !== this.passed) this.open(at);
    }

    open(at) {
        if (this.shown === at) return;
        this.shown = at;
        this.passed = null;
        const stop = this.stops[at], {camera} = this.page;
        part('welcome').hidden = true;
        part('lesson').hidden = false;
        part('lesson').scrollTop = 0;
        part('lesson-place').textContent = `Stop ${at + 1} of ${this.stops.length}`;
        part('lesson-heading').textContent = stop.heading;
        part('lesson-text').textContent = grouped(stop.text);
        this.fillQuestion();
        this.fillGuess();
        const isLast = at + 1 === this.stops.length;
        part('go-on').textContent = isLast ? 'Look around' : 'Go on';
        part('lesson-again').hidden = !isLast;
        if (stop.camera) camera.send(this.poseOf(stop.camera));
        part('go-on').focus({preventScroll: true, focusVisible: false});
        say(`${stop.heading}. ${stop.text}`);
        this.page.draw();
    }

    // From the same place, but looking lower if the card is as wide as the picture, so that it leaves free what is looked at.
    poseOf({place: [x, y], azimuth, elevation, distance}) {
        const {camera, canvas, ground} = this.page, card = part('lesson').getBoundingClientRect();
        const turns = 360 * Math.round((camera.azimuth - azimuth) / 360);
        const pose = {target: [x, y, ground.heightAt(x, y)], azimuth: azimuth + turns, elevation, distance};
        if (card.width < 0.8 * canvas.clientWidth) return pose;
        const share = (canvas.clientHeight - card.top) / canvas.clientHeight, half = Math.hypot(...this.page.view().up);
        const tilt = Math.min(kMostTilt, Math.atan(half * share) / kDegree), {eye} = poseOf(pose);
        const tilted = {...pose, elevation: Math.min(kHighestElevation, elevation + tilt)};
        return {...tilted, target: along(eye, poseOf(tilted).forward, distance)};
    }

    close() {
        this.passed = this.shown;
        this.shown = null;
        part('lesson').hidden = true;
    }

    goOn() {
        const isLast = this.shown + 1 === this.stops.length;
        if (isLast) this.close();
        else this.page.play(true);
        this.page.canvas.focus({preventScroll: true, focusVisible: false});
    }

    // Closes the card. Time continues from its stop, wherever it was scrubbed to meanwhile; from the last one, from the start.
    leave() {
        const {tick} = this.stops[this.shown], isLast = this.shown + 1 === this.stops.length;
        if (isLast) return this.startAgain();
        this.close();
        this.page.seek(tick);
    }

    startAgain() {
        this.begin();
        this.close();
        this.passed = null;
        this.page.seek(0);
    }

    // ---- question and guess ----

    fillQuestion() {
        const {question} = this.stops[this.shown], given = this.answers[this.shown], list = part('lesson-answers');
        part('lesson-question').hidden = !question;
        list.replaceChildren();
        if (!question) return;
        part('lesson-asks').textContent = grouped(question.asks);
        question.answers.forEach((answer, i) => {
            const button = add(list, 'button', answer);
            button.type = 'button';
            button.disabled = given !== null && i !== given && i !== question.right;
            if (given !== null && i === question.right) button.className = 'right';
            button.addEventListener('click', () => this.answer(i));
        });
        const verdict = given === null ? '' : given === question.right ? 'Right. ' : 'Not quite. ';
        part('lesson-why').textContent = given === null ? '' : verdict + grouped(question.why);
    }

    // The first one counts.
    answer(i) {
        if (this.answers[this.shown] !== null) return;
        this.answers[this.shown] = i;
        this.fillQuestion();
        part('go-on').focus({preventScroll: true, focusVisible: false});
    }

    fillGuess() {
        const stop = this.stops[this.shown], {guess} = this, asked = this.stops.some(each => each.guess);
        const off = guess && stop.toe && Math.hypot(guess.x - stop.toe[0], guess.y - stop.toe[1]);
        part('lesson-guess').textContent =
            stop.guess ? guess ? 'Your guess is marked. Click or tap elsewhere to change it.'
                               : 'Click or tap on the mountain where you think the front will stop.'
            : !asked || !stop.last ? ''
            : off !== null && off !== undefined ? `Your guess was ${number(off)} m from where the front stopped.`
                                                : 'You made no guess.';
    }

    guessAt(place) {
        if (!place) return;
        this.guess = place;
        this.fillGuess();
        this.page.draw();
    }

    // ---- what is marked in the picture ----

    showPins(view) {
        const stop = this.isOpen ? this.stops[this.shown] : null;
        const places = [this.guess && [this.guess.x, this.guess.y], stop?.last && stop.toe];
        places.forEach((place, i) => {
            const at = place && !this.page.live?.on ? this.onScreen(view, ...place) : null;
            this.pins[i].hidden = !at;
            if (at) this.pins[i].style.transform = `translate(${at[0]}px, ${at[1]}px)`;
        });
    }

    // Where a place of the ground is seen, px from the top left; null: it is hidden.
    onScreen(view, x, y) {
        const {canvas, ground} = this.page, point = [x, y, ground.heightAt(x, y), 1], {clip, eye} = view;
        const [right, up, , w] = [0, 1, 2, 3].map(row => point.reduce((sum, v, i) => sum + v * clip[4 * i + row], 0));
        if (w <= 0 || Math.abs(right) > w || Math.abs(up) > w) return null;
        const away = from => Math.hypot(...[0, 1, 2].map(i => from[i] - eye[i]));
        const seen = pickGround(view, right / w, up / w, ground);
        if (seen && away(seen) < (1 - kInFront) * away(point) - ground.cell) return null;
        return [(1 + right / w) / 2 * canvas.clientWidth, (1 - up / w) / 2 * canvas.clientHeight];
    }
}
