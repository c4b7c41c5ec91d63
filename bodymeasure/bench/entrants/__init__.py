"""The methods that take part in the benchmark."""
