// Lens: the mean of what is spread over a pixel, from points in a spiral around it. What is behind the pixel is spread no
// farther than twice the pixel itself, so that nothing behind runs over what is sharp; what is in front is spread as it is.
// After Gustafsson, "Bokeh depth of field in a single pass" (2018).
layout(binding = SLOT_COLOUR) uniform sampler2D circles;
layout(binding = SLOT_LENS_REACH) uniform sampler2D reaches;
layout(location = 0) uniform vec2 take;  // exposure; pixels between the points

out vec4 colour;

const float kGoldenAngle = 2.39996323;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(circles, 0) - 1;
    vec4 here = texelFetch(circles, pixel, 0);
    float reach = texelFetch(reaches, pixel / LENS_BLOCK, 0).r, soft = 0.5 * take.y;
    int points = reach < 0.5 ? 0 : int(reach * reach / (take.y * take.y)) + 1;
    vec3 sum = here.rgb;
    for (int i = 1; i <= points; ++i) {
        float radius = take.y * sqrt(float(i)), angle = kGoldenAngle * float(i);
        ivec2 at = clamp(pixel + ivec2(round(radius * vec2(cos(angle), sin(angle)))), ivec2(0), last);
        vec4 there = texelFetch(circles, at, 0);
        float spread = abs(there.a);
        if (there.a > here.a) spread = min(spread, 2.0 * abs(here.a));
        float share = smoothstep(radius - soft, radius + soft, spread);
        sum += mix(sum / float(i), there.rgb, share);
    }
    colour = vec4(take.x / float(points + 1) * sum, 1.0);
}
