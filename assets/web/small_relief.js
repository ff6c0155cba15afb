// Small relief of the ground, made in shaders as render/mountain/detail.cpp makes it.
const kDetailSize = 512;  // texels along the tile

function makeSmallRelief(gpu, shaders, slots) {
    const {gl} = gpu, heights = floatTarget(gpu, slots.SLOT_DETAIL, kDetailSize, 1);
    shaders.detailHeights.use();
    gl.uniform1f(shaders.detailHeights.at('texels'), kDetailSize);
    gpu.fill(shaders.detailHeights);

    // The lowest and the highest, in two steps.
    const halfway = Math.sqrt(kDetailSize / 2), made = [heights];
    let range = [heights.textures[0], heights.textures[0]];
    for (const [edge, texels] of [[halfway, kDetailSize / halfway], [1, halfway]]) {
        const next = floatTarget(gpu, slots.SLOT_DETAIL, edge, 2);
        bindRange(gpu, slots, range);
        shaders.detailRange.use();
        gl.uniform1i(shaders.detailRange.at('edge'), texels);
        gpu.fill(shaders.detailRange);
        made.push(next);
        range = next.textures;
    }

    const relief = gl.createTexture(), target = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, relief);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, Math.log2(kDetailSize) + 1, gl.RGBA8, kDetailSize, kDetailSize,
                    slots.DETAIL_LAYERS);
    bindRange(gpu, slots, range);
    gpu.bind(slots.SLOT_DETAIL, heights.textures[0]);
    gpu.into(target, kDetailSize, kDetailSize);
    shaders.detailLayer.use();
    for (let layer = 0; layer < slots.DETAIL_LAYERS; ++layer) {
        gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, relief, 0, layer);
        gl.uniform1i(shaders.detailLayer.at('layer'), layer);
        gpu.fill(shaders.detailLayer);
    }
    for (const each of [...made.map(one => one.target), target]) gl.deleteFramebuffer(each);
    for (const texture of made.flatMap(one => one.textures)) gl.deleteTexture(texture);

    gl.activeTexture(gl.TEXTURE0 + slots.SLOT_DETAIL);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, relief);
    gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
}

// A square target of so many textures, to be drawn into.
function floatTarget(gpu, unit, edge, count) {
    const textures = Array.from({length: count}, () => gpu.texture(unit, gpu.gl.RGBA32F, edge, edge, gpu.gl.NEAREST));
    const target = gpu.target(textures);
    gpu.bind(unit, null);
    gpu.into(target, edge, edge);
    return {textures, target};
}

// Units that fields take later.
function bindRange(gpu, slots, [lowest, highest]) {
    gpu.bind(slots.SLOT_BEDROCK, lowest);
    gpu.bind(slots.SLOT_DEPTH, highest);
}
