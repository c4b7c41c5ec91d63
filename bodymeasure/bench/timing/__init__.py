"""Processor times, growth, stages, and a whole body."""
