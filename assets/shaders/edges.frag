// Edges: smooths stairs in the picture. Where the row or column beside an edge ends, the edge crosses to the next
// one, so a pixel takes a share of the colour across the edge by its place between two ends [lottes2009]. It
// looks along the edge only, so that texture stays sharp.
layout(binding = SLOT_PICTURE) uniform sampler2D picture;  // as the screen shows it, not linear; filtered

out vec4 colour;

// How far to look for an end, both ways; farther off, stairs are so long that they are hardly seen. Pixels.
const int kSteps = 5;
const float kStrides[kSteps] = float[](1.0, 1.0, 2.0, 4.0, 8.0);
const float kMostOfCorner = 0.25;  // largest share where stairs are a pixel long

// Green is most of brightness, and saves computing it. From 0 to 1.
float brightness(vec2 at) {
    return textureLod(picture, at, 0.0).g;
}

void main() {
    vec2 pixel = 1.0 / vec2(textureSize(picture, 0));
    vec2 at = gl_FragCoord.xy * pixel;
    vec4 above_right = textureGather(picture, at + 0.5 * pixel, 1);
    vec4 below_left = textureGather(picture, at - 0.5 * pixel, 1);
    float n = above_right.x, ne = above_right.y, e = above_right.z, here = above_right.w;
    float w = below_left.x, s = below_left.z, sw = below_left.w;
    float nw = textureLodOffset(picture, at, 0.0, ivec2(-1, 1)).g;
    float se = textureLodOffset(picture, at, 0.0, ivec2(1, -1)).g;

    // The edge runs along x where rows differ more than columns. It lies on the side that differs more.
    float rows = abs(nw + sw - 2.0 * w) + 2.0 * abs(n + s - 2.0 * here) + abs(ne + se - 2.0 * e);
    float columns = abs(nw + ne - 2.0 * n) + 2.0 * abs(w + e - 2.0 * here) + abs(sw + se - 2.0 * s);
    bool level = rows >= columns;
    float before = level ? s : w, after = level ? n : e;
    bool is_before = abs(before - here) >= abs(after - here);
    float other = is_before ? before : after;
    vec2 across = (level ? vec2(0.0, pixel.y) : vec2(pixel.x, 0.0)) * (is_before ? -1.0 : 1.0);
    vec2 along = level ? vec2(pixel.x, 0.0) : vec2(0.0, pixel.y);

    // Walk between the two rows or columns: their mean stays, until either of them changes.
    vec2 start = at + 0.5 * across;
    float mean = 0.5 * (here + other), change = 0.25 * abs(other - here);
    vec2 reach = vec2(0.0), last = vec2(0.0), difference = vec2(0.0);  // backward, forward
    bvec2 ended = bvec2(false);
    for (int i = 0; i < kSteps && !all(ended); ++i) {
        last = mix(vec2(kStrides[i]), last, ended);
        reach += mix(last, vec2(0.0), ended);
        difference = vec2(brightness(start - reach.x * along), brightness(start + reach.y * along)) - mean;
        ended = greaterThanEqual(abs(difference), vec2(change));
    }
    reach -= 0.5 * last;  // the end is somewhere within the last stride

    // The edge crosses this pixel if at the nearer end both rows are like the other one.
    float end = reach.x < reach.y ? difference.x : difference.y;
    bool crosses = (end < 0.0) != (here < mean);
    float share = crosses ? 0.5 - min(reach.x, reach.y) / (reach.x + reach.y) : 0.0;

    // The ends of stairs of one pixel are everywhere: there count how many neighbours differ.
    float most = max(here, max(max(n, s), max(w, e))), least = min(here, min(min(n, s), min(w, e)));
    float blurred = (2.0 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
    float corner = kMostOfCorner * smoothstep(0.33, 0.5, abs(blurred - here) / (most - least));
    colour = textureLod(picture, at + max(share, corner) * across, 0.0);
}
