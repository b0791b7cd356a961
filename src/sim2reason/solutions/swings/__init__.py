"""Bodies that rotate or swing about an axle, fixed or on a carriage: inertia, angles, speeds and times."""
