// The surface at a vertex: its height and slope, and what shares of the layers are drawn there.
layout(binding = SLOT_BEDROCK) uniform sampler2D bedrock;
layout(binding = SLOT_DEPTH) uniform sampler2D depth;
layout(binding = SLOT_UNDISTURBED) uniform sampler2D undisturbed;
layout(binding = SLOT_ROLLING) uniform sampler2D rolling;
layout(binding = SLOT_SITE) uniform usampler2D site;

const float kHalfSpeed = 10.0;  // m/s, drawn at half of the maximum

float height(ivec2 v) {
    return texelFetch(bedrock, v, 0).r + texelFetch(depth, v, 0).r + texelFetch(rolling, v, 0).r;
}

bool is_ground(ivec2 v) {
    return all(greaterThanEqual(v, ivec2(0))) && all(lessThan(v, frame.size.xy)) &&
           texelFetch(site, v, 0).r != uint(SITE_DRAIN);
}

// Central difference if both neighbours are ground, one-sided beside an edge of the world.
float slope(ivec2 v, ivec2 along, float here) {
    bool ahead = is_ground(v + along), behind = is_ground(v - along);
    float rise = (ahead ? height(v + along) : here) - (behind ? height(v - along) : here);
    return rise / (frame.ground.x * (ahead && behind ? 2.0 : 1.0));
}

// The layers of a vertex, for SLOT_LAYERS. Shares up to 1, not depths, are interpolated later. A front is then equally
// sharp at any depth, and lies midway between the last vertex inside and the first outside. The share of the standing
// layer still grows where it is deep, so that noise can leave patches of ground in it.
vec4 layers_at(ivec2 v, vec2 rise, float speed) {
    float d = texelFetch(depth, v, 0).r, r = texelFetch(rolling, v, 0).r;
    vec2 share = vec2(cover_share(d, rise), min(0.5 * r / frame.rolling.w, 1.0));
    // No data counts as unchanged. Any other value would be interpolated into the ground beside it.
    float change = frame.material.w > 0.0 && is_ground(v) ? (d - texelFetch(undisturbed, v, 0).r) / MOST_CHANGE : 0.0;
    return vec4(share, speed / (speed + kHalfSpeed), (128.0 + 127.0 * clamp(change, -1.0, 1.0)) / 255.0);
}
