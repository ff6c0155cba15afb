// Finds edges in the picture: discards every pixel that is much like its four neighbours, or like one of them at
// most: that is texture. It leaves out trees and
// their shadows, too, whose alpha is 0: nearly all of their pixels are edges.
layout(binding = SLOT_PICTURE) uniform sampler2D picture;  // as the screen shows it, not linear

// Green is most of brightness, and saves computing it. From 0 to 1.
const float kLeastContrast = 0.08;
const float kLeastShare = 0.18;  // of the brightest around the pixel

void main() {
    vec2 pixel = 1.0 / vec2(textureSize(picture, 0));
    vec2 at = gl_FragCoord.xy * pixel;
    vec4 above_right = textureGather(picture, at + 0.5 * pixel, 1);  // above, its right, right, here
    vec4 below_left = textureGather(picture, at - 0.5 * pixel, 1);   // left, here, below, its left
    vec4 around = vec4(above_right.xz, below_left.xz);
    float here = above_right.w;
    float most = max(here, max(max(around.x, around.y), max(around.z, around.w)));
    float least = min(here, min(min(around.x, around.y), min(around.z, around.w)));
    float range = most - least;
    float alike = dot(vec4(lessThan(abs(around - here), vec4(0.4 * range))), vec4(1.0));
    if (range <= max(kLeastContrast, kLeastShare * most) || alike < 2.0) discard;
    vec4 solid = min(textureGather(picture, at + 0.5 * pixel, 3), textureGather(picture, at - 0.5 * pixel, 3));
    if (min(min(solid.x, solid.y), min(solid.z, solid.w)) < 0.5) discard;
}
