"""What turns or swings about an axle, itself fixed or on a carriage: its inertia, angles, speeds and times."""
