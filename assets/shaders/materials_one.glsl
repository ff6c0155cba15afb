// Ground of one material.
vec2 lower_shares(Place p, Detail d, float change) { return vec2(0.0); }
