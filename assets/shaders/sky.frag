// Sky: where nothing was drawn. Above the horizon the sky, below it haze that deepens.
in vec2 ndc;
out vec4 colour;

const vec3 kZenith = vec3(0.10, 0.25, 0.55);
const vec3 kNadir = vec3(0.16, 0.30, 0.50);

void main() {
    vec3 direction = normalize(frame.ray_forward.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz);
    float steep = 2.8 * abs(direction.z);
    vec3 sky = mix(kHorizon, direction.z > 0.0 ? kZenith : kNadir, steep / (0.35 + steep) * min(1.0, 3.0 * steep));
    float disc = smoothstep(0.9994, 0.9997, dot(direction, frame.sun.xyz));
    colour = vec4(sky + glow(direction) + disc * vec3(3.0, 2.7, 2.2), 1.0);
}
