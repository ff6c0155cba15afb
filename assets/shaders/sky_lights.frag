// Lights of the sky: sun, moon and stars before the sky of sky.frag, where nothing was drawn.
layout(binding = SLOT_SKY) uniform sampler2D sky;

in vec2 ndc;
out vec4 colour;

// Light of stars in a direction, in stars.glsl or stars_none.glsl.
vec3 stars(vec3 direction);

void main() {
    vec3 direction = normalize(frame.ray_middle.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz);
    vec4 behind = textureLod(sky, 0.5 + 0.5 * ndc, 0.0);
    float lamp = clamp((dot(direction, frame.disc.xyz) - frame.disc.w) * 12500.0, 0.0, 1.0);
    colour = vec4(behind.rgb + (frame.lamp.rgb * (frame.glow.w * lamp) + stars(direction)) * behind.a, 1.0);
}
