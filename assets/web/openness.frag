// Computes the openness of each vertex of the bedrock, once.
out vec4 open;

void main() { open = vec4(openness_at(ivec2(gl_FragCoord.xy))); }
