// Where the soil is dry.
Skin with_water(Skin skin, Place p, Detail d) { return skin; }
