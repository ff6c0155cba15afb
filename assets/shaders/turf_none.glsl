// No turf rides on the flow, and its grains are alike.
float sorted(inout Paint seen, Sheet sheets[kSheets], float footprint) { return 0.0; }
