"""What cannot be right with a set of measurements, told before a body is sought."""
