'use strict';

// Keeps the files of a site, so that it opens without a network. Each is kept under its name and digest: a file of another
// version is never taken for it, and one that came damaged or cut is not kept.

const files = @FILES@;  // SHA-256 of each file, by name
const {scope} = registration;
const cacheName = `couloir ${scope}`;
const addressOf = name => new URL(name, scope).href;
const keyOf = name => `${addressOf(name)}?${files[name]}`;
const isPage = name => name.endsWith('.html') && name !== 'index.html';

const digestOf = async bytes =>
    [...new Uint8Array(await crypto.subtle.digest('SHA-256', bytes))].map(byte => byte.toString(16).padStart(2, '0')).join('');

// A file from this device, or else from the network, and then it is kept.
async function take(name) {
    const cache = await caches.open(cacheName), kept = await cache.match(keyOf(name));
    if (kept) return kept;
    const answer = await fetch(addressOf(name), {cache: 'no-cache'});
    if (!answer.ok) return answer;
    const body = await answer.arrayBuffer();
    const fresh = () => new Response(body, {headers: answer.headers});  // a redirected answer may not answer a visit
    if (await digestOf(body) === files[name])
        await cache.put(keyOf(name), fresh()).catch(() => {});  // without room it is not kept
    return fresh();
}

// The index and its pictures, and pages that were kept in an earlier version.
async function install() {
    const cache = await caches.open(cacheName), before = (await cache.keys()).map(({url}) => url.split('?')[0]);
    for (const name of Object.keys(files)) {
        if (isPage(name) && !before.includes(addressOf(name))) continue;
        const answer = await take(name);
        if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
    }
    await self.skipWaiting();
}

async function activate() {
    const cache = await caches.open(cacheName), current = new Set(Object.keys(files).map(keyOf));
    for (const request of await cache.keys())
        if (!current.has(request.url)) await cache.delete(request);
    await self.clients.claim();
}

// The file that an address means. Some servers leave endings out.
function nameOf({url, method}) {
    const address = new URL(url);
    if (method !== 'GET' || !address.href.startsWith(scope)) return undefined;
    const name = decodeURIComponent(address.origin + address.pathname).slice(scope.length) || 'index.html';
    return [name, `${name}.html`].find(each => Object.hasOwn(files, each));
}

async function answer(name) {
    try {
        return await take(name);
    } catch {
        return new Response('There is no network, and this is not on the device yet. Go back, and open it once when there is one.',
                            {status: 503, headers: {'Content-Type': 'text/plain; charset=utf-8'}});
    }
}

addEventListener('install', event => event.waitUntil(install()));
addEventListener('activate', event => event.waitUntil(activate()));
addEventListener('fetch', event => {
    const name = nameOf(event.request);
    if (name !== undefined) event.respondWith(answer(name));
});
