"""Formats that other libraries read, each in a process of its own."""
