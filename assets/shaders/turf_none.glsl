// No turf rides on the flow.
float turf(Sheet sheets[kSheets], float footprint) { return 0.0; }
