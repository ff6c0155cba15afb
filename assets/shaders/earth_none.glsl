// Where no earth was sculpted.
Skin with_earth(Skin skin, Place p, Detail d, vec4 fine) { return skin; }
