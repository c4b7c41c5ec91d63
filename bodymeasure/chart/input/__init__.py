"""What the value of a measurement owes to the scan that its body was fitted to."""
