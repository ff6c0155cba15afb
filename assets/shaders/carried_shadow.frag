// The shadow of what a flow carries: what it leaves of the light, as a factor.
in vec2 along;
flat in vec3 left;
flat in float strength;
out vec4 colour;

void main() {
    float dense = 1.0 - smoothstep(0.45, 1.0, length(vec2(along.x, along.y)));
    colour = vec4(mix(vec3(1.0), left, strength * dense), 0.0);  // alpha 0: edges_mark.frag leaves it out
}
