// The shadow of a tree: what it leaves of the light, as a factor. Its edges are soft, softer toward its tip.
in vec2 along;
flat in vec3 left;
flat in float strength;
out vec4 colour;

void main() {
    float aside = abs(along.x) / max(1.0 - along.y, 0.02);
    float dense = (1.0 - smoothstep(0.55 - 0.5 * along.y, 1.0, aside)) * smoothstep(0.0, 0.10, along.y);
    colour = vec4(mix(vec3(1.0), left, strength * dense * (0.95 - 0.35 * along.y)), 0.0);  // alpha 0: edges_mark.frag leaves it out
}
