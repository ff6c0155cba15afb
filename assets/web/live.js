// Takes the slide over: the world goes on in this page, and a hand acts on it. The world itself is in live_worker.js.

const kMostDue = 15;        // ticks that one answer may take; what is late beyond that is left out
const kSilent = 4000;       // ms without an answer, after which the page says so
const kSliderSteps = 200;   // over the logarithm of a range

// Whether this browser runs the module: WebAssembly with 128-bit lanes (the smallest function that has one).
function runsModules() {
    const smallest = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];
    return Boolean(globalThis.WebAssembly && globalThis.Worker && WebAssembly.validate(new Uint8Array(smallest)));
}

// What was won in this browser, by the names of worlds; nothing if that is no record.
function bestRuns() {
    try {
        return JSON.parse(localStorage.getItem('couloir.best')) ?? {};
    } catch (error) {
        if (error instanceof SyntaxError) return {};
        throw error;
    }
}

// A number as its tool words it: printf with one %.Nf.
const worded = (format, value) =>
    format.replace(/%\.(\d)f/, (_, digits) => number(value, Number(digits))).replaceAll('%%', '%');

class Live {
    constructor(page) {
        this.page = page;
        this.slide = page.slide;
        this.questions = new Map();  // that wait for an answer, by number
        this.asked = 0;
        this.turn = Promise.resolve();
        this.hand = [];              // what the hand did since the last step
        this.held = null;            // {x, y}: the ground under a held button
        this.paused = false;
        this.due = 0;                // ticks
        this.settings = new Map();   // of each tool: its numbers
        this.on = false;             // since a person has taken over
    }

    // ---- the worker ----

    // Starts the world and its proof, once: both take a while, and nothing waits for them.
    begin() {
        return this.begun ??= this.start();
    }

    async start() {
        const carried = part('world'), {parts, name} = this.page.info.live;
        let pieces;
        try {
            pieces = await unzip(carried.textContent.trim(), parts);
        } catch (cause) {
            throw new Error('The world in this page is damaged, so it can be watched only. Copy or download the file again.', {cause});
        }
        carried.remove();
        const text = which => new TextDecoder().decode(pieces.get(which));
        const address = URL.createObjectURL(new Blob([text('worker')], {type: 'text/javascript'}));
        this.worker = new Worker(address);
        URL.revokeObjectURL(address);
        this.worker.onmessage = ({data}) => this.hear(data);
        this.worker.onerror = event => this.end(event.message || 'its thread has stopped');
        const {facts} = await this.ask('open', {
            bytes: pieces.get('module'), name, recording: text('recording'), light: [...this.page.picture.frame.sun],
            cover: this.cover(),
        });
        this.facts = facts;
        for (const tool of facts.tools) this.settings.set(tool.name, tool.numbers.map(each => each.usual));
        this.fillTools();
    }

    // Depth and share of the lower material at tick 0, on which houses stand; null in a model.
    cover() {
        const depth = this.slide.array('cover_d'), lower = this.slide.array('cover_l');
        if (!depth) return null;
        const cover = new Float32Array(2 * depth.length);
        for (let i = 0; i < depth.length; ++i) cover[2 * i] = depth[i], cover[2 * i + 1] = lower ? lower[i] : 0;
        return cover;
    }

    // Asks the worker, one question after another.
    ask(kind, data = {}) {
        const asked = this.turn.then(() => this.askNow(kind, data));
        this.turn = asked.catch(() => {});
        return asked;
    }

    askNow(kind, data) {
        if (this.ended) throw new Error(this.ended);
        const id = ++this.asked, spare = this.spare;
        this.spare = undefined;
        const waits = setTimeout(() => this.tell('Computing…'), kSilent);
        return new Promise((done, failed) => {
            this.questions.set(id, {done, failed});
            this.worker.postMessage({id, kind, spare, ...data}, spare ? Object.values(spare).map(array => array.buffer) : []);
        }).finally(() => clearTimeout(waits));
    }

    hear({id, failed, over, remains, proof, ...answer}) {
        if (proof) return;  // how far it has come, for whoever listens
        const question = this.questions.get(id);
        this.questions.delete(id);
        if (over) this.end(failed, remains);
        if (failed !== undefined) question.failed(new Error(over ? this.ended : failed));
        else question.done(answer);
    }

    // The world is lost; the page goes on as a picture. `remains`: the recording of what was done.
    end(sentence, remains = '') {
        if (this.ended) return;
        this.remains = remains;
        this.ended = `The world of this page has ended: ${sentence}. ` +
            (remains ? 'Save keeps what was done in it. ' : '') + 'Load the page again to go on.';
        for (const {failed} of this.questions.values()) failed(new Error(this.ended));
        this.questions.clear();
        this.worker?.terminate();
        this.tell(this.ended);
    }

    // ---- taking over ----

    async takeOver() {
        if (this.on || this.taking) return;
        const {page, slide} = this, button = part('take-over');
        this.taking = true;
        button.disabled = true;
        part('take-over-word').textContent = 'Taking over…';
        page.play(false);
        try {
            await this.begin();
            const answer = await this.ask('takeOver', {tick: slide.tickOf(slide.frameNear(slide.tick))});
            this.on = true;
            this.show(answer);
        } catch (error) {
            this.tell(error.message);
            part('take-over-word').textContent = 'Take over';
            button.disabled = false;
            return;
        } finally {
            this.taking = false;
        }
        button.hidden = part('welcome').hidden = true;
        part('live').hidden = false;
        document.documentElement.dataset.live = 'on';
        page.rate = 1;  // somebody may have watched at a higher speed
        part('rate').value = 1;
        this.choose(this.facts.tools[0].name);
        this.wake();
        say('You have taken over. What you do is recorded.');
    }

    // Where the run that is to be beaten was at the same time of its try, as game/session/run_extent.h has it.
    showGhost() {
        const {goal} = this.page.info, {slide} = this;
        if (goal?.ghost_step === undefined) return;
        const {try_ticks: ticks} = this.status, last = ticks < 0 ? 0 : 1 + Math.floor(ticks / goal.ghost_step);
        if (last === (slide.extent?.last ?? 0)) return;
        this.steps ??= slide.array('ghost');
        slide.extent = last > 0 ? {last, inside: Float32Array.from(this.steps, step => step > 0 && step <= last ? 1 : 0)} : null;
    }

    // Shows an answer of the worker.
    show({status, shown, said}) {
        const {slide, page} = this;
        this.spare = {depth: shown.depth, rolling: shown.rolling, speed: shown.speed, along_y: shown.along_y};
        slide.become(status.tick, shown);
        this.status = status;
        this.showGhost();
        if (said) this.tell(said);
        this.showStatus();
        page.showTime();
        page.stir();
    }

    // What is done to the world besides time: undo, going back, a new beginning.
    async change(kind, data = {}) {
        this.due = 0;
        this.hand = [];
        this.held = null;
        try {
            const answer = await this.ask(kind, data);
            this.show(answer);
            if (answer.name) this.tell(`${kind === 'undo' ? 'Undone' : 'Redone'}: ${answer.name}`);
        } catch (error) {
            this.tell(error.message);
        }
        this.wake();
    }

    // ---- time ----

    pause(on) {
        this.paused = on;
        this.showPlaying();
        this.wake();
    }

    showPlaying() {
        const playing = !this.paused;
        part('play').classList.toggle('on', playing);
        part('play-word').textContent = playing ? 'Pause' : 'Play';
    }

    // Whether there is anything to compute: the hand acts, or time runs and something moves or is still to come.
    get goesOn() {
        if (this.ended || document.hidden) return false;
        if (this.held || this.hand.length > 0) return true;
        const waits = this.facts.goal && !this.status.card;
        return !this.paused && (!this.status.rests || waits || this.status.looks_back);
    }

    wake() {
        if (!this.on || this.running) return;
        this.running = true;
        this.run().catch(error => this.tell(error.message)).finally(() => this.running = false);
    }

    async run() {
        const {page} = this, tickS = page.info.tick_s;
        let last = performance.now();
        while (this.goesOn) {
            await new Promise(requestAnimationFrame);
            const now = performance.now();
            const runs = !this.paused || (this.held && this.deed.acts === 'always');
            if (runs) this.due = Math.min(this.due + (now - last) / 1000 / tickS * page.rate, kMostDue);
            last = now;
            let ticks = Math.floor(this.due);
            if (!runs) {  // time moves for what acts at once, and for nothing else
                if (this.hand.length === 0 || !await this.actsNow()) continue;
                ticks = 1;
            }
            if (ticks === 0 && this.hand.length === 0) continue;
            this.due = Math.max(this.due - ticks, 0);
            this.show(await this.ask('step', {ticks, hand: this.takeHand()}));
        }
        this.due = 0;
        page.draw();
    }

    // Gives the hand to the world, and asks whether it would act in a tick.
    async actsNow() {
        this.show(await this.ask('step', {ticks: 0, hand: this.takeHand()}));
        return (await this.ask('wouldAct')).acts;
    }

    takeHand() {
        return this.hand.splice(0);
    }

    // A drag of the time bar asks for many ticks; those that it has passed are left out.
    async seek(tick) {
        this.target = Math.round(tick);
        if (this.seeking) return;
        this.seeking = true;
        while (this.target !== undefined) {
            const asked = this.target;
            this.target = undefined;
            await this.change('seek', {tick: asked});
        }
        this.seeking = false;
    }

    // ---- the hand ----

    get tool() {
        return this.facts?.tools.find(tool => tool.name === this.chosen);
    }
    get deed() {
        return this.tool?.[this.with ?? 'plain'];
    }
    // Radius of the ring that shows what a deed reaches, m.
    get reach() {
        return this.deed.radius ? clamp(this.radius, ...this.tool.radius) : 1.5 * this.slide.info.grid.dx;
    }

    choose(name) {
        const tool = this.facts.tools.find(each => each.name === name);
        if (!tool) return;
        this.chosen = name;
        this.setBrush({tool: name});
        for (const button of part('tools').children) {
            const chosen = button.dataset.tool === name;
            button.setAttribute('aria-checked', chosen);
            if (chosen) button.scrollIntoView({block: 'nearest', inline: 'nearest'});
        }
        this.fillSettings();
        say(`${tool.plain.label}: ${tool.tooltip}`);
    }

    setBrush(brush) {
        this.hand.push(['brush', brush]);
        this.wake();
    }

    // A button or a finger goes down on the ground. Returns whether it acts.
    press(place, shift, control) {
        if (!this.on || !this.tool) return false;
        const at = this.page.pick(...place);
        if (!at) return false;
        if (this.status.looks_back) {
            this.tell('This is the past. Press "Continue from here" to act in it.');
            return true;
        }
        this.with = shift ? 'shift' : control ? 'control' : 'plain';
        this.held = at;
        this.hand.push(['press', shift ? 1 : 0, control ? 1 : 0, at.x, at.y]);
        this.wake();
        return true;
    }
    move(place) {
        if (!this.held) return;  // the press was not taken
        const at = this.page.pick(...place);
        this.hand.push(at ? ['move', at.x, at.y] : ['leave']);
        if (at) this.held = at;
        this.page.hover = at;
        this.wake();
    }
    release() {
        if (!this.held) return;
        this.held = null;
        this.with = 'plain';
        this.hand.push(['release']);
        this.wake();
    }

    // ---- buttons and words ----

    fillTools() {
        const bar = part('tools');
        for (const {name, key, tooltip, plain} of this.facts.tools) {
            const button = add(bar, 'button');
            button.type = 'button';
            button.dataset.tool = name;
            button.title = `${tooltip} (${key})`;
            button.setAttribute('role', 'radio');
            button.setAttribute('aria-checked', false);
            button.append(iconOf(plain.icon));
            add(button, 'span', plain.label);
            button.addEventListener('click', () => this.choose(name));
        }
        this.radius = this.facts.brush.radius;
    }

    // Sliders of the chosen tool.
    fillSettings() {
        const box = part('settings'), {tool} = this;
        box.replaceChildren();
        // Fine where the numbers are small. What the rules fix has none.
        const slider = (label, title, [least, most], now, words, changed) => {
            if (least === most) return;
            const row = add(box, 'label'), text = add(row, 'span', words(now)), range = add(row, 'input');
            const of = step => clamp(least * Math.pow(most / least, step / kSliderSteps), least, most);
            const value = kSliderSteps * Math.log(now / least) / Math.log(most / least);
            row.title = title;
            Object.assign(range, {type: 'range', min: 0, max: kSliderSteps, step: 1, value});
            range.setAttribute('aria-label', label);
            range.setAttribute('aria-valuetext', words(now));
            range.addEventListener('input', () => {
                const set = of(Number(range.value));
                text.textContent = words(set);
                range.setAttribute('aria-valuetext', text.textContent);
                changed(set);
            });
        };
        if (tool.plain.radius)
            slider('Radius', 'Radius of the brush. [ and ] change it.', tool.radius, clamp(this.radius, ...tool.radius),
                   radius => `Radius ${number(radius)} m`, radius => this.setRadius(radius));
        const values = this.settings.get(tool.name);
        tool.numbers.forEach((each, i) => {
            if (each.fixed) return;
            slider(each.label, each.tooltip, [each.least, each.most], values[i], value => worded(each.format, value * each.scale), value => {
                values[i] = value;
                this.setBrush({numbers: values});
            });
        });
        if (tool.layer) {
            const row = add(box, 'label'), box_ = add(row, 'input');
            box_.type = 'checkbox';
            box_.checked = this.standing ?? false;
            add(row, 'span', 'lies still');
            row.title = 'Pour onto the layer that lies, instead of into the flow.';
            box_.addEventListener('change', () => this.setBrush({standing: this.standing = box_.checked}));
        }
    }

    setRadius(radius) {
        this.radius = clamp(radius, ...this.tool.radius);
        this.setBrush({radius: this.radius});
        this.page.stir();
    }

    showStatus() {
        const {status} = this;
        part('undo').disabled = status.undo === 0;
        part('redo').disabled = status.redo === 0;
        part('continue').hidden = !status.looks_back;
        if (status.left) {
            part('left').replaceChildren();
            for (const {kind, left, unit} of status.left) {
                const tool = this.facts.tools.find(each => each.plain.kind === kind);
                add(part('left'), 'li', `${tool ? tool.plain.label : kind}: ${number(left)}${unit ? ` ${unit.replace('m3', 'm³')}` : ''} left`);
            }
        }
        if (status.card && this.shownCard !== status.card.tick) this.showCard(status.card);
        if (!status.card) this.shownCard = undefined;
        this.showPlaying();
    }

    // In a site the index shows what was won in this browser. Returns whether nothing was refused.
    keepBest({won, points, medal}) {
        const {name} = this.page.info.site ?? {}, rank = of => ['bronze', 'silver', 'gold'].indexOf(of);
        if (!won || !name) return true;
        try {
            const best = bestRuns(), before = best[name];
            if (before && (rank(before.medal) > rank(medal) || (before.medal === medal && before.points >= points))) return true;
            localStorage.setItem('couloir.best', JSON.stringify({...best, [name]: {points, medal}}));
        } catch {  // its storage is full, or closed to this page
            return false;
        }
        return true;
    }

    showCard(card) {
        this.shownCard = card.tick;
        const kept = this.keepBest(card);
        part('verdict').textContent = card.verdict;
        part('points').textContent = `Score ${number(card.points)}. Bronze from ${this.facts.goal.medals.map(least => number(least)).join(', silver from ').replace(/, silver from ([^,]*)$/, ', gold from $1')}.`;
        part('reason').textContent = [card.needs.some(need => !need.met) && card.reason, card.advice].filter(Boolean).join(' ');
        const {to_beat} = this.page.info.goal ?? {};
        if (card.won && card.points > to_beat)
            part('points').textContent += ` You have beaten the ${number(to_beat)} points of before: save it, and send it back.`;
        if (!kept) part('points').textContent += ' This browser keeps no medal, because its storage is full or closed: save the try.';
        part('learn').textContent = card.won ? this.facts.goal.learn : '';
        part('needs').replaceChildren();
        for (const need of card.needs) {
            const row = part('needs').insertRow();
            add(row, 'th', `${need.met ? '✓' : '✗'} ${need.what}`).scope = 'row';
            add(row, 'td', `${need.value}, ${need.bound}`);
        }
        part('card').dataset.medal = card.medal;
        part('card').showModal();
        say(`${card.verdict}. Score ${card.points}.`);
    }

    // A sentence for a while.
    tell(sentence) {
        const told = part('told');
        told.textContent = sentence;
        told.hidden = false;
        clearTimeout(this.forgets);
        this.forgets = setTimeout(() => told.hidden = true, 3000 + 60 * sentence.length);
    }

    // ---- what is kept ----

    async recorded() {
        const text = this.remains || (await this.ask('recorded')).text;
        return new File([text], `${this.page.info.live.name}-mine.couloir`, {type: 'application/octet-stream'});
    }

    async save() {
        try {
            const file = await this.recorded(), link = document.createElement('a');
            link.href = URL.createObjectURL(file);
            link.download = file.name;
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 60000);
            this.tell(`Saved as ${file.name}. "couloir replay ${file.name} --verify" proves it.`);
        } catch (error) {
            this.tell(`Not saved: ${error.message}`);
        }
    }

    async share() {
        try {
            await navigator.share({files: [await this.recorded()], title: this.page.info.title});
        } catch (error) {
            if (error.name !== 'AbortError') this.tell(`Not shared: ${error.message}`);
        }
    }

    listen() {
        const on = (id, action) => part(id).addEventListener('click', action);
        on('take-over', () => this.takeOver());
        on('undo', () => this.change('undo'));
        on('redo', () => this.change('redo'));
        on('again', () => this.change('again'));
        on('card-again', () => {
            part('card').close();
            this.change('again');
        });
        on('card-save', () => this.save());
        on('continue', () => this.change('takeOver', {tick: this.status.tick}));
        on('save', () => this.save());
        on('share', () => this.share());
        part('share').hidden = !navigator.canShare?.({files: [new File([''], 'a.couloir')]});
        for (const type of ['pointerdown', 'keydown'])
            addEventListener(type, () => this.begin().catch(() => {}), {once: true});  // told by takeOver()
        document.addEventListener('visibilitychange', () => this.wake());
    }

    // Returns whether the key means something here.
    key({key, ctrlKey, metaKey, shiftKey}) {
        if ((ctrlKey || metaKey) && key.toLowerCase() === 'z') this.change(shiftKey ? 'redo' : 'undo');
        else if ((ctrlKey || metaKey) && key.toLowerCase() === 'y') this.change('redo');
        else if (ctrlKey || metaKey) return false;
        else if (key === '[' || key === ']') {
            this.setRadius(key === '[' ? this.radius / 1.15 : this.radius * 1.15);
            this.fillSettings();
        }
        else if (key === 'Enter') this.stampMiddle();
        else {
            const tool = !shiftKey && this.facts.tools.find(each => each.key.toLowerCase() === key.toLowerCase());
            if (!tool) return false;
            this.choose(tool.name);
        }
        return true;
    }

    // By keyboard alone: a short stroke in the middle of the picture.
    stampMiddle() {
        const {canvas} = this.page, middle = [canvas.clientWidth / 2, canvas.clientHeight / 2];
        if (!this.press(middle, false, false)) return this.tell('No ground of the slide is in the middle of the picture');
        setTimeout(() => this.release(), 400);
    }
}

// An icon in a square from −1 to 1, as the program draws it.
function iconOf(parts) {
    const {namespaceURI} = document.querySelector('#play svg'), svg = document.createElementNS(namespaceURI, 'svg');
    svg.setAttribute('viewBox', '-1.15 -1.15 2.3 2.3');
    svg.setAttribute('aria-hidden', 'true');
    const shape = (name, attributes) => {
        const made = svg.appendChild(document.createElementNS(namespaceURI, name));
        for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    };
    for (const [kind, ...n] of parts) {
        if (kind === 'line') shape('path', {d: `M${n[0]} ${n[1]}L${n[2]} ${n[3]}`, class: 'stroke'});
        if (kind === 'triangle') shape('path', {d: `M${n[0]} ${n[1]}L${n[2]} ${n[3]}L${n[4]} ${n[5]}Z`});
        if (kind === 'box') shape('path', {d: `M${n[0]} ${n[1]}H${n[2]}V${n[3]}H${n[0]}Z`});
        if (kind === 'dot') shape('circle', {cx: n[0], cy: n[1], r: n[2]});
        if (kind === 'ring') shape('circle', {cx: n[0], cy: n[1], r: n[2], class: 'stroke'});
        if (kind === 'rays')
            for (let i = 0; i < n[2]; ++i) {
                const angle = 2 * Math.PI * i / n[2], [x, y] = [Math.sin(angle), Math.cos(angle)];
                shape('path', {d: `M${n[0] * x} ${n[0] * y}L${n[1] * x} ${n[1] * y}`, class: 'stroke'});
            }
    }
    return svg;
}
