// A tree that is a few pixels high.
in vec3 reflected;
out vec4 colour;

void main() {
    colour = vec4(reflected, 0.0);  // alpha 0: edges_mark.frag leaves it out
}
