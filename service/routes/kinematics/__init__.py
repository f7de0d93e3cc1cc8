"""What is computed of a robot: poses, velocities, forces, closed forms, and other descriptions of it."""
