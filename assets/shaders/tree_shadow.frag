// The shadow of a tree: what it leaves of the light, as a factor.
in float along;
flat in vec3 left;
flat in float strength;
out vec4 colour;

void main() {
    colour = vec4(mix(vec3(1.0), left, strength * (0.85 - 0.45 * along)), 0.0);  // alpha 0: edges_mark.frag leaves it out
}
