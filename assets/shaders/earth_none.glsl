// Where no earth was sculpted.
Skin with_earth(Skin skin, Place p, Detail d, vec4 fine) { return skin; }
vec3 with_dirt(vec3 lies, Place p, Detail d) { return lies; }
