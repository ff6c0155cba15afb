'use strict';

// What the index of a site does besides leading to pages: shows what was won here, and keeps pages for times without a network.

const part = id => document.getElementById(id);
const pages = [...document.querySelectorAll('[data-world]')].map(each => each.href);
const bytes = [...document.querySelectorAll('[data-bytes]')].reduce((sum, each) => sum + Number(each.dataset.bytes), 0);
const megabytes = `${Math.ceil(bytes / 1e6)} MB`;

// ---- medals: a page of a challenge keeps its best try ----

function showBest() {
    let best;
    try {
        best = JSON.parse(localStorage.getItem('couloir.best')) ?? {};
    } catch {
        return;  // a browser that keeps nothing, or what is no record
    }
    for (const link of document.querySelectorAll('[data-world]')) {
        const {points, medal} = best[link.dataset.world] ?? {}, rank = ['bronze', 'silver', 'gold'].indexOf(medal);
        if (!Number.isFinite(points) || rank < 0) continue;
        const score = points.toLocaleString('en').replaceAll(',', '\u202f');
        const words = link.closest('.words'), said = words.querySelector(`[data-best="${CSS.escape(link.dataset.world)}"]`);
        said.textContent = said.dataset.after ? `: ${score}, ${medal}` : `Your best here: ${score}, ${medal}`;
        said.hidden = false;
        if (!said.dataset.after) words.querySelectorAll('.medals li').forEach((each, i) => each.classList.toggle('won', i <= rank));
    }
}

// ---- pages that are kept ----

const cacheName = `couloir ${new URL('./', location.href).href}`;  // as service_worker.js has it

async function countKept() {
    const names = new Set((await (await caches.open(cacheName)).keys()).map(({url}) => url.split('?')[0]));
    return pages.filter(page => names.has(page.split('#')[0])).length;
}

async function showKept() {
    const kept = await countKept(), button = part('keep');
    part('kept').textContent = kept === pages.length ? 'All mountains are on this device, and open without a network.' :
        `${kept} of ${pages.length} mountains are on this device. One that you have opened stays.`;
    button.textContent = `Keep all (${megabytes})`;
    button.hidden = kept === pages.length;
    return kept;
}

async function keepAll() {
    const button = part('keep');
    button.disabled = true;
    try {
        await navigator.storage?.persist?.();
        for (const [i, page] of pages.entries()) {
            part('kept').textContent = `Keeping ${i + 1} of ${pages.length}…`;
            await fetch(page).then(answer => answer.arrayBuffer()).catch(() => {});  // the service worker keeps what is whole
        }
    } finally {
        button.disabled = false;
    }
    const kept = await showKept();
    if (kept < pages.length)
        part('kept').textContent = `${kept} of ${pages.length} mountains are on this device. The others could not be kept: ` +
            'the network does not give them whole, or there is no room.';
}

async function workOffline() {
    if (!('serviceWorker' in navigator) || !isSecureContext || !globalThis.caches) return;
    if (!location.protocol.startsWith('http')) return;  // from a file: it is here anyway
    Object.assign(document.head.appendChild(document.createElement('link')), {rel: 'manifest', href: 'manifest.webmanifest'});
    await navigator.serviceWorker.register('service_worker.js');
    await navigator.serviceWorker.ready;
    await showKept();
    part('offline').hidden = false;
    part('keep').addEventListener('click', () => keepAll().catch(() => showKept()));
}

addEventListener('beforeinstallprompt', event => {
    const button = part('install');
    button.hidden = false;
    button.onclick = () => event.prompt();
});
addEventListener('appinstalled', () => part('install').hidden = true);
addEventListener('pageshow', () => {  // also when somebody comes back from a page
    showBest();
    if (!part('offline').hidden) showKept();
});
workOffline().catch(() => {}).finally(() => document.documentElement.dataset.state = 'ready');
