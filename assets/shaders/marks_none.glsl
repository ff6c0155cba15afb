// No marks, at no cost.
vec3 marked(vec3 seen, Place p, vec3 light) {
    return seen;
}
