// No stars, at no cost.
vec3 stars(vec3 direction) {
    return vec3(0.0);
}
