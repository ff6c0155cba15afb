// Mountains of one material.
float lower_share(Place p, Detail d, vec2 source, float added) { return 0.0; }
